// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/near_borders.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tactics {

namespace {

constexpr double kMostPiecesOfBorders = 400'000;
constexpr double kPieceOfReach = 4;  // times the reach: a piece is about as long

template <typename Take>  // panel, from, to
void each_border(const FlatLayout& layout, Take take) {
    for (std::uint32_t i = 0; i < layout.panels.size(); ++i)
        if (layout.panels[i].handling == Handling::kept)
            for (const auto& ring : layout.panels[i].shape.rings)
                for (std::size_t j = 0; j < ring.size(); ++j) take(i, ring[j], ring[(j + 1) % ring.size()]);
}

// How long a piece is, and about how many there are.
struct BorderPieces {
    double longest = 0;
    std::size_t count = 0;
};

BorderPieces pieces_of(const FlatLayout& layout, double reach) {
    double sum = 0;
    BorderPieces pieces;
    each_border(layout, [&](std::uint32_t, Point from, Point to) {
        sum += distance(from, to);
        ++pieces.count;
    });
    pieces.longest = std::max({kPieceOfReach * reach, sum / kMostPiecesOfBorders, 1e-9});
    pieces.count += static_cast<std::size_t>(sum / pieces.longest);
    return pieces;
}

}  // namespace

NearBorders::NearBorders(const FlatLayout& layout, double reach)
    : reach_(reach), pieces_(box_of(layout), pieces_of(layout, reach).count) {
    const double longest = pieces_of(layout, reach).longest;
    each_border(layout, [&](std::uint32_t panel, Point from, Point to) {
        const int count = 1 + static_cast<int>(distance(from, to) / longest);
        const auto at = [&](int i) {
            const double share = static_cast<double>(i) / count;
            return Point{from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)};
        };
        for (int i = 0; i < count; ++i) {
            pieces_.add(box_of(std::array{at(i), at(i + 1)}));
            panel_.push_back(panel);
        }
    });
}

}  // namespace tactics
