// The ground painted over the ink of words, from around each letter inwards.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "tactics/lettering/lettering.h"

namespace tactics {

namespace {

// 1 where the picture shows ink of a word.
std::vector<std::uint8_t> mask_for(const Image& picture, const Lettering& lettering, bool only_sure) {
    std::vector<std::uint8_t> mask(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height), 0);
    const double across = static_cast<double>(picture.width) / lettering.width, down = static_cast<double>(picture.height) / lettering.height;
    for (const PrintedWords& words : lettering.words) {
        if (only_sure && !words.sure) continue;
        for (const Run& run : words.ink) {
            const int left = std::max(0, static_cast<int>(std::floor(run.left * across)));
            const int right = std::min(picture.width, static_cast<int>(std::ceil(run.right * across)));
            const int top = std::max(0, static_cast<int>(std::floor(run.y * down)));
            const int bottom = std::min(picture.height, static_cast<int>(std::ceil((run.y + 1) * down)));
            for (int y = top; y < bottom; ++y)
                for (int x = left; x < right; ++x)
                    mask[static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x)] = 1;
        }
    }
    return mask;
}

}  // namespace

void take_out(Image& picture, const Lettering& lettering, bool only_sure) {
    if (lettering.words.empty() || picture.pixels.empty()) return;
    std::vector<std::uint8_t> mask = mask_for(picture, lettering, only_sure);
    const int width = picture.width, height = picture.height;
    const auto at = [width](int x, int y) { return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x); };
    // Layer by layer: each pixel beside known ones becomes their mean, and is known for the next layer.
    std::vector<std::pair<int, int>> left;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            if (mask[at(x, y)] != 0) left.emplace_back(x, y);
    while (!left.empty()) {
        std::vector<std::pair<int, int>> later, known;
        for (const auto& [x, y] : left) {
            int count = 0, sums[3] = {0, 0, 0};
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) {
                    const int nx = x + dx, ny = y + dy;
                    if (nx < 0 || ny < 0 || nx >= width || ny >= height || mask[at(nx, ny)] != 0) continue;
                    ++count;
                    for (int c = 0; c < picture.channels; ++c) sums[c] += picture.row(ny)[nx * picture.channels + c];
                }
            if (count == 0) {
                later.emplace_back(x, y);
                continue;
            }
            for (int c = 0; c < picture.channels; ++c)
                picture.row(y)[x * picture.channels + c] = static_cast<std::uint8_t>((sums[c] + count / 2) / count);
            known.emplace_back(x, y);
        }
        if (known.empty()) break;  // nothing but words in the whole picture
        for (const auto& [x, y] : known) mask[at(x, y)] = 0;
        left = std::move(later);
    }
}

}  // namespace tactics
