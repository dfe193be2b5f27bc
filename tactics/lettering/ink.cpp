// SPDX-License-Identifier: Apache-2.0
#include "tactics/lettering/ink.h"

#include <algorithm>
#include <numeric>

namespace tactics {

namespace {

// Which runs belong together: a forest whose trees are the pieces.
class Forest {
public:
    std::size_t add() {
        parent_.push_back(parent_.size());
        return parent_.size() - 1;
    }
    std::size_t root(std::size_t one) {
        while (parent_[one] != one) one = parent_[one] = parent_[parent_[one]];
        return one;
    }
    void join(std::size_t a, std::size_t b) {
        a = root(a);
        b = root(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::size_t> parent_;
};

}  // namespace

double share_of_ink(const InkPiece& piece) {
    double ink = 0;
    for (const InkRun& run : piece.runs) ink += run.right - run.left;
    return ink / (static_cast<double>(piece.box.width()) * piece.box.height());
}

void move_piece(InkPiece& piece, int right, int down) {
    for (InkRun& run : piece.runs) run = {run.y + down, run.left + right, run.right + right};
    piece.box = {piece.box.left + right, piece.box.top + down, piece.box.right + right, piece.box.bottom + down};
}

bool ends_within(const InkPiece& piece, const Image& part) {
    const PixelBox& box = piece.box;
    return box.left > 0 && box.top > 0 && box.right < part.width && box.bottom < part.height;
}

std::vector<InkPiece> pieces_of(const Image& grey, int level, bool light, int largest) {
    std::vector<InkRun> runs;
    Forest forest;
    std::size_t above = 0, above_end = 0;  // the runs of the row before
    for (int y = 0; y < grey.height; ++y) {
        const std::uint8_t* row = grey.row(y);
        const std::size_t first = runs.size();
        std::size_t beside = above;
        for (int x = 0; x < grey.width;) {
            if ((row[x] < level) == light) {
                ++x;
                continue;
            }
            const int left = x;
            while (x < grey.width && (row[x] < level) != light) ++x;
            const std::size_t own = forest.add();
            runs.push_back({y, left, x});
            while (beside < above_end && runs[beside].right < left) ++beside;
            for (std::size_t other = beside; other < above_end && runs[other].left <= x; ++other) forest.join(own, other);
        }
        above = first;
        above_end = runs.size();
    }
    std::vector<PixelBox> boxes(runs.size(), PixelBox{0, 0, -1, -1});
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const PixelBox own{runs[i].left, runs[i].y, runs[i].right, runs[i].y + 1};
        PixelBox& box = boxes[forest.root(i)];
        box = box.right < 0 ? own : around(box, own);
    }
    constexpr std::size_t kNone = static_cast<std::size_t>(-1);
    std::vector<std::size_t> number(runs.size(), kNone);
    std::vector<InkPiece> pieces;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const std::size_t root = forest.root(i);
        if (boxes[root].width() > largest || boxes[root].height() > largest) continue;
        if (number[root] == kNone) {
            number[root] = pieces.size();
            pieces.push_back({boxes[root], {}});
        }
        pieces[number[root]].runs.push_back(runs[i]);
    }
    return pieces;
}

}  // namespace tactics
