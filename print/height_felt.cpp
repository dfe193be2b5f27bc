// SPDX-License-Identifier: Apache-2.0
#include <vector>

#include "print/height_files.h"
#include "print/height_samples.h"
#include "tactics/coding/level_map.h"

namespace tactics {

LevelMap level_map_of(const HeightSheet& sheet, const HeightRows& rows) {
    const auto columns = static_cast<std::size_t>(sheet.columns);
    LevelMap map{.columns = sheet.columns,
                 .rows = sheet.rows,
                 .pitch = sheet.pitch,
                 .low = sheet.low,
                 .high = sheet.high,
                 .rise = (sheet.high - sheet.low) / 65535,
                 .profile = std::string(sheet.profile)};
    map.levels.resize(columns * static_cast<std::size_t>(sheet.rows));
    std::vector<float> heights(columns);
    for (int y = 0; y < sheet.rows; ++y) {
        rows(y, heights);
        to_samples(sheet, heights, std::span(map.levels).subspan(static_cast<std::size_t>(y) * columns, columns));
    }
    return with_fewest_levels(std::move(map));
}

std::string height_felt(const HeightSheet& sheet, const HeightRows& rows) { return encode_levels(level_map_of(sheet, rows)); }

}  // namespace tactics
