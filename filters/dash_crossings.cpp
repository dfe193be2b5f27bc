// SPDX-License-Identifier: Apache-2.0
#include "filters/dash_crossings.h"

#include <algorithm>
#include <cstdint>

#include "filters/opencv.h"
#include "tactics/geometry/vectors.h"

namespace tactics {

void take_crossings(const Image& ink, const Components& pieces, const DashLimits& limits, std::vector<DashRow>& rows) {
    constexpr double kSize = 2.5, kThick = 1.1;
    if (rows.empty()) return;
    const auto extents = pieces.extents();
    std::vector<std::uint32_t> piece_at(ink.pixels.size(), pieces.count);
    for (const Run& run : pieces.runs)
        if (static_cast<double>(extents[run.component]) <= kSize * limits.longest)
            std::fill_n(piece_at.begin() + static_cast<std::ptrdiff_t>(run.row) * ink.width + run.begin, run.end - run.begin,
                        run.component);
    for (const DashRow& row : rows)
        for (const Run& run : row.ink)
            std::fill_n(piece_at.begin() + static_cast<std::ptrdiff_t>(run.row) * ink.width + run.begin, run.end - run.begin,
                        pieces.count);
    std::vector<DashRow*> owner(pieces.count);
    for (DashRow& row : rows)
        for (std::size_t i = 1; i + 2 < row.points.size(); i += 2) {
            const Point a = row.points[i], b = row.points[i + 1];
            for (double t = 0; t <= 1; t += 0.5 / std::max(1.0, distance(a, b))) {
                const int x = static_cast<int>(a.x + t * (b.x - a.x)), y = static_cast<int>(a.y + t * (b.y - a.y));
                if (x < 0 || y < 0 || x >= ink.width || y >= ink.height) continue;
                const std::uint32_t piece =
                    piece_at[static_cast<std::size_t>(y) * static_cast<std::size_t>(ink.width) + static_cast<std::size_t>(x)];
                if (piece < pieces.count) owner[piece] = &row;
            }
        }
    cv::Mat depth;
    for (const Run& run : pieces.runs) {
        DashRow*& row = owner[run.component];
        if (row == nullptr) continue;
        if (depth.empty()) cv::distanceTransform(view_of(ink) < 128, depth, cv::DIST_L2, cv::DIST_MASK_5);
        const double owner_width = row->width + 1;
        for (int x = run.begin; x < run.end; ++x)
            if (static_cast<double>(depth.at<float>(run.row, x)) > kThick * owner_width) row = nullptr;
    }
    for (const Run& run : pieces.runs)
        if (owner[run.component] != nullptr) owner[run.component]->ink.push_back(run);
}

}  // namespace tactics
