// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "print/height_files.h"
#include "tactics/readers/exr.h"
#include "tactics/relief/height_words.h"

namespace tactics {

HeightSheet sheet_of(const HeightMap& map, double low, double high) { return {map.columns, map.rows, map.pitch, low, high, {}}; }

HeightRows rows_of(const HeightMap& map) {
    return [&map](int row, std::span<float> heights) {
        std::copy_n(map.heights.begin() + static_cast<std::ptrdiff_t>(row) * map.columns, map.columns, heights.begin());
    };
}

std::string height_exr(const HeightSheet& sheet, const HeightRows& rows) {
    return write_exr(sheet.columns, sheet.rows, words_of(sheet.pitch, sheet.low, sheet.high, sheet.profile), rows);
}

}  // namespace tactics
