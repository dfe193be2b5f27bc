// SPDX-License-Identifier: Apache-2.0
#include "studies/told_table.h"

#include <utility>

#include "tactics/text/table.h"

namespace tactics {

namespace {

std::vector<Row> rows_in(const std::vector<ToldRow>& rows, std::string_view language) {
    std::vector<Row> texts;
    for (const ToldRow& row : rows) texts.push_back(in_language(row, language));
    return texts;
}

bool is_number(const std::string& field) {
    return !field.empty() && field.find_first_not_of("-.0123456789 %") == std::string::npos;
}

}  // namespace

std::string told_table(const std::vector<ToldRow>& rows, std::string_view language) {
    std::vector<Row> texts = rows_in(rows, language);
    for (Row& row : texts)
        for (std::size_t i = 1; i < row.size(); ++i)
            if (is_number(row[i])) row[i] = numeral_of(row[i]).in(language);
    return aligned(std::move(texts));
}

std::string told_csv(const std::vector<ToldRow>& rows) { return comma_separated(rows_in(rows, "en")); }

Phrase fixed_numeral(double value, int digits) { return numeral_of(fixed(value, digits)); }

}  // namespace tactics
