// SPDX-License-Identifier: Apache-2.0
#include "filters/ink_hues.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "filters/darken.h"

namespace tactics {

namespace {

using Direction = std::array<double, 3>;  // of a colour from the ground's: the paler pixels of a line's border have it, too

constexpr double kInk = 79;         // levels off the ground, as dashes (known_parts.cpp): a grid has no more
constexpr double kSameHue = 0.988;  // cosine, 9 degrees
constexpr std::size_t kMostHues = 8;

struct Hue {
    Direction to{};
    std::size_t count = 0;
};

double along(const Direction& a, const Direction& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Direction unit_of(Direction d) {
    const double size = std::sqrt(along(d, d));
    for (double& part : d) part /= size > 0 ? size : 1;
    return d;
}

// What was drawn with: its place in the cells of a coarse cube, gathered by the commonest.
class HueFinder {
public:
    explicit HueFinder(const Image& picture) : picture_(picture), ground_(ground_of(picture)) {
        constexpr int kHueCells = 16;
        std::vector<Hue> cells(kHueCells * kHueCells * kHueCells);
        for (int y = 0; y < picture.height; ++y)
            for (int x = 0; x < picture.width; ++x)
                if (const auto to = at(x, y)) {
                    std::size_t cell = 0;
                    for (const double part : *to)
                        cell = cell * kHueCells +
                               static_cast<std::size_t>(std::clamp((part + 1) / 2 * kHueCells, 0.0, kHueCells - 1.0));
                    ++cells[cell].count;
                    for (std::size_t c = 0; c < 3; ++c) cells[cell].to[c] += (*to)[c];
                }
        std::erase_if(cells, [](const Hue& cell) { return cell.count == 0; });
        std::sort(cells.begin(), cells.end(), [](const Hue& a, const Hue& b) { return a.count > b.count; });
        for (const Hue& cell : cells) {
            const Direction to = unit_of(cell.to);
            if (hues_.size() == kMostHues) break;
            if (std::none_of(hues_.begin(), hues_.end(), [&](const Direction& hue) { return along(hue, to) > kSameHue; }))
                hues_.push_back(to);
        }
    }

    std::size_t count() const { return hues_.size(); }

    // The number of the hue of that pixel; 0: ground, or pale; one more than there are hues: a mixture.
    Image labels() const {
        Image labels = make_image(picture_.width, picture_.height, 1, picture_.mm_per_pixel, 0);
        for (int y = 0; y < picture_.height; ++y)
            for (int x = 0; x < picture_.width; ++x) {
                const auto to = at(x, y);
                if (!to) continue;
                double best = kSameHue;
                labels.row(y)[x] = static_cast<std::uint8_t>(hues_.size() + 1);
                for (std::size_t i = 0; i < hues_.size(); ++i)
                    if (const double cosine = along(hues_[i], *to); cosine > best) {
                        best = cosine;
                        labels.row(y)[x] = static_cast<std::uint8_t>(i + 1);
                    }
            }
        return labels;
    }

private:
    std::optional<Direction> at(int x, int y) const {
        const std::uint8_t* pixel = picture_.row(y) + x * picture_.channels;
        Direction to{};
        double most = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            to[c] = ground_[c] - pixel[picture_.channels == 3 ? c : 0];
            most = std::max(most, std::abs(to[c]));
        }
        if (most < kInk) return std::nullopt;
        return unit_of(to);
    }

    const Image& picture_;
    std::array<int, 3> ground_;
    std::vector<Direction> hues_;
};

}  // namespace

InkHues ink_hues_of(const Image& picture) {
    const HueFinder finder(picture);
    return {finder.count(), finder.labels()};
}

}  // namespace tactics
