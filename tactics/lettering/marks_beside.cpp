// SPDX-License-Identifier: Apache-2.0
#include "tactics/lettering/marks_beside.h"

#include <algorithm>
#include <cmath>

#include "tactics/geometry/convex.h"
#include "tactics/lettering/mark_shape.h"

namespace tactics {

namespace {

// Settings. A solid letter, such as an l, is narrow; letters that touch are wide, but in a line of such.
constexpr double kSolid = 0.85, kNarrowLetter = 0.5;               // of what is between its ink; of its longer side
constexpr double kApart = 0.25, kFrameApart = 0.4, kWideMark = 2;  // of the height of the line's tallest letter
constexpr int kLeastSide = 5, kTellingSide = 8;                    // pixels

// A box with straight sides that is empty, or painted paler than its border. A zero of square letters is narrower.
bool is_frame(const InkPiece& piece) {
    constexpr double kSquare = 0.8;
    const PixelBox& box = piece.box;
    if (box.width() < kSquare * box.height()) return false;
    std::vector<int> ink(static_cast<std::size_t>(box.height()), 0);
    std::size_t reach = 0;  // ends of rows at a side
    for (const InkRun& run : piece.runs) {
        ink[static_cast<std::size_t>(run.y - box.top)] += run.right - run.left;
        reach += (run.left == box.left ? 1U : 0U) + (run.right == box.right ? 1U : 0U);
    }
    return box.height() > kLeastSide && reach == 2 * ink.size() && ink.front() == box.width() && ink.back() == box.width();
}

// Discs, boxes and heads of arrows: nothing but ink between one part of it and another.
bool is_solid(const InkPiece& piece) {
    const int side = std::max(piece.box.width(), piece.box.height()), across = std::min(piece.box.width(), piece.box.height());
    if (side < kLeastSide || across < kNarrowLetter * side) return false;
    std::vector<Point> corners;
    double ink = 0;
    for (const InkRun& run : piece.runs) {
        ink += run.right - run.left;
        for (const int x : {run.left, run.right})
            for (const int y : {run.y, run.y + 1}) corners.push_back({1.0 * x, 1.0 * y});
    }
    if (ink < kSolid * area_of(hull_of(std::move(corners)))) return false;
    return side >= kTellingSide || mark_shape(piece).band >= kSolid;  // of few pixels, an n is nearly as solid
}

}  // namespace

std::vector<std::vector<std::size_t>> parts_at_marks(const std::vector<InkPiece>& pieces, const std::vector<PixelBox>& boxes,
                                                     const std::vector<std::size_t>& letters) {
    int height = 0;
    for (const std::size_t letter : letters) height = std::max(height, boxes[letter].height());
    std::vector<bool> marks;
    int reached = boxes[letters.front()].left - height;
    for (std::size_t i = 0; i < letters.size(); ++i) {
        const PixelBox& box = boxes[letters[i]];
        const int next = i + 1 < letters.size() ? boxes[letters[i + 1]].left : box.right + height;
        const double apart = 1.0 * std::min(box.left - reached, next - box.right) / height;
        const InkPiece& piece = pieces[letters[i]];
        marks.push_back((apart >= kApart && (box.width() >= kWideMark * height || is_solid(piece))) ||
                        (apart >= kFrameApart && is_frame(piece)));
        reached = std::max(reached, box.right);
    }
    const auto count = std::count(marks.begin(), marks.end(), true);
    if (count == 0 || 2 * count > static_cast<std::ptrdiff_t>(marks.size())) return {letters};
    std::vector<std::vector<std::size_t>> parts;
    for (std::size_t i = 0; i < letters.size(); ++i) {
        if (i == 0 || marks[i] || marks[i - 1]) parts.emplace_back();
        parts.back().push_back(letters[i]);
    }
    return parts;
}

bool is_node(const InkPiece& piece, const PixelBox& box, const PixelBox& line) {
    // Of the height: points have up to 0.3, and a pixel more; signs of degrees are above.
    constexpr double kLargerThanPoint = 0.4, kLargerThanLargePoint = 0.34, kOffMiddle = 0.2;
    constexpr int kLargePrint = 30;
    const double least = line.height() >= kLargePrint ? kLargerThanLargePoint : kLargerThanPoint;
    return box.height() >= least * line.height() &&
           std::abs(middle_of(box).y - middle_of(line).y) <= kOffMiddle * line.height() && is_solid(piece);
}

}  // namespace tactics
