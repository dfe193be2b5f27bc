// SPDX-License-Identifier: Apache-2.0
#include "tactics/lettering/mark_shape.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "tactics/geometry/skeleton.h"

namespace tactics {

namespace {

// Settings: of the longer side; of what a band as long and as wide has in ink.
constexpr double kNarrow = 0.3, kBandLike = 0.8;

}  // namespace

MarkShape mark_shape(const InkPiece& piece) {
    double area = 0, x = 0, y = 0, xx = 0, yy = 0, xy = 0;
    for (const InkRun& run : piece.runs)
        for (int column = run.left; column < run.right; ++column) {
            const double u = column - piece.box.left, v = run.y - piece.box.top;
            area += 1, x += u, y += v, xx += u * u, yy += v * v, xy += u * v;
        }
    MarkShape shape;
    if (area == 0) return shape;
    shape.side = std::max(piece.box.width(), piece.box.height());
    shape.across = std::min(piece.box.width(), piece.box.height());
    shape.share = area / (shape.side * shape.across);
    shape.middle = {(x / area + 0.5) / piece.box.width(), (y / area + 0.5) / piece.box.height()};
    const double a = xx / area - x * x / (area * area) + 1.0 / 12, b = yy / area - y * y / (area * area) + 1.0 / 12,
                 c = xy / area - x * y / (area * area);
    shape.slant = std::abs(c) / std::sqrt(std::max(1e-9, a * b));
    shape.band = area / (12 * std::sqrt(std::max(1e-9, a * b - c * c)));
    return shape;
}

bool is_letter_like(const MarkShape& shape) {
    return shape.side >= kLeastMark && shape.side <= kMostMark && shape.across >= kNarrow * shape.side && shape.band < kBandLike;
}

bool same_mark(const MarkShape& a, const MarkShape& b) {
    return std::abs(a.side - b.side) <= 1 && std::abs(a.across - b.across) <= 1 && std::abs(a.share - b.share) <= 0.05 &&
           std::abs(a.band - b.band) <= 0.05 && distance(a.middle, b.middle) <= 0.03;
}

bool same_size(const MarkShape& a, const MarkShape& b) {
    constexpr double kSame = 0.12;
    return std::abs(a.side - b.side) <= kSame * b.side && std::abs(a.across - b.across) <= kSame * b.across;
}

bool is_bent_band(const InkPiece& piece) {
    constexpr double kBent = 1.35;
    InkMap map(piece.box.width() + 2, piece.box.height() + 2);
    for (const InkRun& run : piece.runs)
        for (int x = run.left; x < run.right; ++x) map.row(run.y - piece.box.top + 1)[x - piece.box.left + 1] = 1;
    const Skeleton middle = thin(std::move(map));
    double left = 1e9, top = 1e9, right = 0, bottom = 0;
    for (const std::uint32_t pixel : middle.pixels) {
        const double x = middle.x_of(pixel), y = middle.y_of(pixel);
        left = std::min(left, x), right = std::max(right, x), top = std::min(top, y), bottom = std::max(bottom, y);
    }
    return static_cast<double>(middle.pixels.size()) <= kBent * std::hypot(right - left + 1, bottom - top + 1);
}

Point middle_of(const PixelBox& box) { return {0.5 * (box.left + box.right), 0.5 * (box.top + box.bottom)}; }

double gap_between(const PixelBox& a, const PixelBox& b) {
    return std::hypot(std::max({0, a.left - b.right, b.left - a.right}), std::max({0, a.top - b.bottom, b.top - a.bottom}));
}

}  // namespace tactics
