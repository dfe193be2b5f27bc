// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/read_table.h"

#include "tactics/readers/csv_table.h"
#include "tactics/readers/json_table.h"

namespace tactics {

TableHead table_head(Source& source) { return begins_json(source) ? json_table_head(source) : csv_table_head(source); }

void read_rows(Source& source, const TableHead& head, std::span<const std::size_t> wanted, const TakeRow& take) {
    if (head.form == TableForm::lines)
        read_csv_rows(source, head, wanted, take);
    else
        read_json_rows(source, head, wanted, take);
}

}  // namespace tactics
