// SPDX-License-Identifier: Apache-2.0
#include "tactics/lettering/stroke_parts.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

#include "tactics/lettering/mark_shape.h"

namespace tactics {

namespace {

// Settings: grey levels by which ink is fainter, and the last level at which it is no ground; share of its box that a drawn line
// is at most; pixels of a long part, and how often the longer and the shorter side of its line are as long. A short part may be
// of a letter that comes apart, and its line must be larger on both sides. Of a band with the moments of its ink, a bar fills
// more.
constexpr int kFainter = 96, kFaintest = 192;
constexpr double kMostOfBox = 0.35, kLongPart = 20, kLongerSide = 1.6, kShorterSide = 1.35, kSidesOfShort = 3, kFillsBand = 0.8;

struct LineRun {
    InkRun run;
    std::size_t line;
};

// What is drawn with thin lines, at a fainter level.
class FaintLines {
public:
    FaintLines(const Image& grey, int level, bool light, int least) {
        for (const InkPiece& piece : pieces_of(grey, level, light, std::numeric_limits<int>::max())) {
            if (std::min(piece.box.width(), piece.box.height()) < least || share_of_ink(piece) > kMostOfBox) continue;
            for (const InkRun& run : piece.runs) runs_.push_back({run, boxes_.size()});
            boxes_.push_back(piece.box);
        }
        std::sort(runs_.begin(), runs_.end(), [](const LineRun& a, const LineRun& b) {
            return std::pair(a.run.y, a.run.left) < std::pair(b.run.y, b.run.left);
        });
    }

    // Where the first of its pixels lies, as all others do.
    bool have(const InkPiece& part) const {
        const InkRun& first = part.runs.front();
        const auto after = std::upper_bound(runs_.begin(), runs_.end(), first, [](const InkRun& run, const LineRun& own) {
            return std::pair(run.y, run.left) < std::pair(own.run.y, own.run.left);
        });
        if (after == runs_.begin()) return false;
        const LineRun& own = *(after - 1);
        if (own.run.y != first.y || own.run.right <= first.left) return false;
        const PixelBox& whole = boxes_[own.line];
        const double side = std::max(part.box.width(), part.box.height());
        const bool is_long = side >= kLongPart;
        return std::max(whole.width(), whole.height()) >= (is_long ? kLongerSide : kSidesOfShort) * side &&
               std::min(whole.width(), whole.height()) >= (is_long ? kShorterSide : kSidesOfShort) * side;
    }

private:
    std::vector<PixelBox> boxes_;
    std::vector<LineRun> runs_;
};

}  // namespace

void drop_stroke_parts(const Image& grey, int level, bool light, std::vector<InkPiece>& pieces) {
    const int faint = light ? std::max(255 - kFaintest, level - kFainter) : std::min(kFaintest, level + kFainter);
    if (light ? faint >= level : faint <= level) return;
    const FaintLines lines(grey, faint, light, kLeastInkHeight);
    std::erase_if(pieces, [&](const InkPiece& piece) {
        return std::max(piece.box.width(), piece.box.height()) >= kLeastInkHeight && lines.have(piece) &&
               (mark_shape(piece).band >= kFillsBand || is_bent_band(piece));
    });
}

}  // namespace tactics
