// SPDX-License-Identifier: Apache-2.0
// Print that no reader made out.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "tactics/drawing.h"
#include "tactics/geometry/skeleton.h"
#include "tactics/lettering/read_line.h"

namespace tactics {

namespace {

// Settings. Of the height of known print; of the longer side; of what a band as long and as wide has in ink.
constexpr double kLeastOfKnown = 0.7, kMostOfKnown = 1.4, kNarrow = 0.3, kBandLike = 0.8;
constexpr int kLeastMark = 9, kMostMark = 60;  // pixels
constexpr std::size_t kFewUnread = 8;          // where no print is known

struct MarkShape {
    double side = 0, across = 0, share = 0, band = 0;
    Point middle;  // of its ink, in shares of its box
};

// From the moments of its ink. A bar, whichever way it lies, and a disc fill the bar with their moments.
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
    shape.band = area / (12 * std::sqrt(std::max(1e-9, a * b - c * c)));
    return shape;
}

bool is_letter_like(const MarkShape& shape) {
    return shape.side >= kLeastMark && shape.side <= kMostMark && shape.across >= kNarrow * shape.side && shape.band < kBandLike;
}

bool is_said(const ReadLine& line) { return line.words.sure || line.tell; }

bool as_large_as_print(const MarkShape& shape, const std::vector<ReadLine>& lines) {
    return std::any_of(lines.begin(), lines.end(), [&](const ReadLine& other) {
        const double height = other.line.letter_height;
        return is_said(other) && is_words(other.line) && shape.side >= kLeastOfKnown * height &&
               shape.side <= kMostOfKnown * height;
    });
}

bool has_room_around(const Image& grey, const LetteringLine& line) {
    const int room = std::max(2, line.letter_height / 6);
    const auto is_ink = [&](int x, int y) {
        return x >= 0 && y >= 0 && x < grey.width && y < grey.height && (grey.row(y)[x] < line.level) != line.light;
    };
    for (int x = line.box.left - room; x < line.box.right + room; ++x)
        if (is_ink(x, line.box.top - room) || is_ink(x, line.box.bottom - 1 + room)) return false;
    for (int y = line.box.top - room; y < line.box.bottom + room; ++y)
        if (is_ink(line.box.left - room, y) || is_ink(line.box.right - 1 + room, y)) return false;
    return true;
}

// A scan is not quite level.
bool in_line_with_print(const PixelBox& box, const std::vector<ReadLine>& lines) {
    const double near = 0.3 * std::max(box.width(), box.height());
    return std::any_of(lines.begin(), lines.end(), [&](const ReadLine& other) {
        const PixelBox& b = other.line.box;
        return is_said(other) && (std::abs(box.bottom - b.bottom) <= near || std::abs(box.right - b.right) <= near ||
                                  std::abs(box.left + box.right - b.left - b.right) <= 2 * near);
    });
}

// Figures are as large as each other, too, but their ink lies otherwise.
bool same_mark(const MarkShape& a, const MarkShape& b) {
    return std::abs(a.side - b.side) <= 1 && std::abs(a.across - b.across) <= 1 && std::abs(a.share - b.share) <= 0.05 &&
           std::abs(a.band - b.band) <= 0.05 && distance(a.middle, b.middle) <= 0.03;
}

// A dash of a curve where it bends, from end to end hardly longer than it is large. Letters turn more often, or branch.
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

// A plot has several marks of about one size, about as wide as high, and not most of them in line with print, as figures of an
// axis are.
bool is_one_of_marks(const std::vector<MarkShape>& shapes, std::size_t which, const std::vector<ReadLine>& lines) {
    constexpr double kSquare = 0.75, kOneSize = 0.75;
    if (shapes[which].across < kSquare * shapes[which].side) return false;
    int count = 0, in_line = 0;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        const MarkShape &a = shapes[i], &b = shapes[which];
        if (is_said(lines[i]) || a.across < kSquare * a.side || std::min(a.side, b.side) < kOneSize * std::max(a.side, b.side))
            continue;
        ++count;
        in_line += in_line_with_print(lines[i].line.box, lines) ? 1 : 0;
    }
    return count > 2 && 2 * in_line <= count;
}

}  // namespace

std::vector<bool> unread_print(const Image& grey, const std::vector<ReadLine>& lines) {
    const bool any_known =
        std::any_of(lines.begin(), lines.end(), [](const ReadLine& one) { return is_said(one) && is_words(one.line); });
    std::vector<bool> unread(lines.size(), false);
    std::vector<MarkShape> shapes;
    for (const ReadLine& one : lines) shapes.push_back(mark_shape(one.line.letters.front()));
    std::size_t count = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const LetteringLine& line = lines[i].line;
        const auto letters = static_cast<std::size_t>(std::count_if(
            line.letters.begin(), line.letters.end(), [](const InkPiece& piece) { return is_letter_like(mark_shape(piece)); }));
        if (is_said(lines[i]) || line.marks.size() > line.letters.size() || 2 * letters < line.letters.size() || letters == 0)
            continue;
        if (!(any_known ? as_large_as_print(shapes[i], lines) : !line.light) || !has_room_around(grey, line)) continue;
        const auto alike =
            std::count_if(shapes.begin(), shapes.end(), [&](const MarkShape& other) { return same_mark(shapes[i], other); });
        if ((alike > 2 || is_bent_band(line.letters.front())) && !in_line_with_print(line.box, lines)) continue;
        if (is_one_of_marks(shapes, i, lines)) continue;
        unread[i] = true;
        ++count;
    }
    if (!any_known && count > kFewUnread) unread.assign(lines.size(), false);
    return unread;
}

}  // namespace tactics
