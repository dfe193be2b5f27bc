// SPDX-License-Identifier: Apache-2.0
#include "tactics/relief/height_picture.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tactics/readers/shrink.h"

namespace tactics {

namespace {

// Models have no unit, and this is only looked at, so any size within the bounds of heights will do.
constexpr double kLonger = 900 * kModelPitch;  // mm
constexpr int kGround = 50;                    // samples around it, so that its own outline can be seen

HeightMap on_ground(const HeightMap& map, float low) {
    HeightMap larger{map.columns + 2 * kGround, map.rows + 2 * kGround, map.pitch, {}};
    larger.heights.assign(static_cast<std::size_t>(larger.columns) * static_cast<std::size_t>(larger.rows), low);
    for (int y = 0; y < map.rows; ++y)
        for (int x = 0; x < map.columns; ++x) larger.at(x + kGround, y + kGround) = map.at(x, y);
    return larger;
}

}  // namespace

HeightFile model_for_picture(Source& source, std::optional<UpAxis> up) {
    HeightFile file = read_model_heights(source, up, [](const ModelBox& box) -> HeightWish {
        const double longer = std::max(box.size(0), box.size(1));
        if (!(longer > 0)) return {};  // it will be said what is wrong
        return {.pitch = kModelPitch, .width = kLonger * box.size(0) / longer};
    });
    file.map = on_ground(file.map, static_cast<float>(file.low));
    return file;
}

Image picture_of(const HeightFile& file, int longest) {
    const HeightMap& map = file.map;
    const Size from{map.columns, map.rows}, to = shrunk_size(from, longest);
    RowShrinker<std::uint8_t> rows(from, to, 1);
    std::vector<std::uint8_t> row(static_cast<std::size_t>(map.columns));
    for (int y = 0; y < map.rows; ++y) {
        for (int x = 0; x < map.columns; ++x) {
            const double share = (static_cast<double>(map.at(x, y)) - file.low) / (file.high - file.low);
            row[static_cast<std::size_t>(x)] = static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
        }
        rows.add(row.data());
    }
    Image image;
    image.width = to.width;
    image.height = to.height;
    image.channels = 1;
    image.pixels = rows.take();
    return image;
}

}  // namespace tactics
