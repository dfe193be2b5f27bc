// SPDX-License-Identifier: Apache-2.0
#include "filters/outline.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <utility>

namespace tactics {

namespace {

// A row of ink from `first` up to, not including, `last`. Each of its two ends is on one ring.
struct OutlineRun {
    int first;
    int last;
    std::size_t piece;  // another run of the same piece, towards the first of them
    bool first_seen = false;
    bool last_seen = false;
};

class Outliner {
public:
    explicit Outliner(const InkMap& ink) : ink_(ink) {}

    std::vector<Outline> build() {
        find_runs();
        join_runs();
        std::vector<std::size_t> outline_of(runs_.size());
        for (int y = 0; y < ink_.height; ++y) {
            for (std::size_t i = start_[static_cast<std::size_t>(y)]; i < start_[static_cast<std::size_t>(y) + 1]; ++i) {
                const std::size_t piece = root(i);
                if (piece == i) {
                    outline_of[i] = outlines_.size();
                    outlines_.emplace_back();
                }
                // The first edge of a ring that is met, row by row, tells which it is: ink begins only at an outer ring
                // that is new, and the piece's first run is there; at its other end, or later, only holes are new.
                if (!runs_[i].first_seen) add_ring(runs_[i].first, y, true, outlines_[outline_of[piece]]);
                if (!runs_[i].last_seen) add_ring(runs_[i].last, y, false, outlines_[outline_of[piece]]);
            }
        }
        return std::move(outlines_);
    }

private:
    void find_runs() {
        start_.assign(static_cast<std::size_t>(ink_.height) + 1, 0);
        for (int y = 0; y < ink_.height; ++y) {
            const std::uint8_t* row = ink_.row(y);
            for (int x = 0; x < ink_.width;) {
                if (row[x] == 0) {
                    const void* next = std::memchr(row + x, 1, static_cast<std::size_t>(ink_.width - x));
                    if (next == nullptr) break;
                    x = static_cast<int>(static_cast<const std::uint8_t*>(next) - row);
                }
                const int first = x;
                while (row[x] != 0) ++x;  // the frame is white
                runs_.push_back({first, x, runs_.size()});
            }
            start_[static_cast<std::size_t>(y) + 1] = runs_.size();
        }
    }

    std::size_t root(std::size_t run) {
        while (runs_[run].piece != run) {
            runs_[run].piece = runs_[runs_[run].piece].piece;
            run = runs_[run].piece;
        }
        return run;
    }

    // Runs of neighbouring rows that touch, if only at a corner, are of one piece; its first run stands for it.
    void join_runs() {
        for (std::size_t y = 1; y + 1 < start_.size(); ++y) {
            std::size_t above = start_[y - 1], below = start_[y];
            while (above < start_[y] && below < start_[y + 1]) {
                if (runs_[above].first <= runs_[below].last && runs_[below].first <= runs_[above].last) {
                    const std::size_t a = root(above), b = root(below);
                    runs_[std::max(a, b)].piece = std::min(a, b);
                }
                (runs_[above].last < runs_[below].last ? above : below)++;
            }
        }
    }

    // Follows the border with the ink on the right hand, from the side edge of a pixel: the left one of ink that begins at
    // (x, y), walked upwards, or the right one of ink that ends at x, walked downwards.
    void add_ring(int x, int y, bool begins, Outline& outline) {
        // Directions: 0 up, 1 right, 2 down, 3 left. (x, y) is a corner of pixels: pixel (x, y) is to its lower right.
        static constexpr int kX[] = {0, 1, 0, -1}, kY[] = {-1, 0, 1, 0};
        // The pixels to the left and right in front of one who stands on a corner and looks that way.
        static constexpr int kLeftX[] = {-1, 0, 0, -1}, kLeftY[] = {-1, -1, 0, 0};
        static constexpr int kRightX[] = {0, 0, -1, -1}, kRightY[] = {-1, 0, 0, -1};
        int direction = begins ? 0 : 2;
        int cx = x, cy = begins ? y + 1 : y;
        const int start_x = cx, start_y = cy, start_direction = direction;
        OutlineRing ring;
        int left = cx, right = cx, top = cy, bottom = cy;
        std::int64_t twice = 0;
        do {
            if (direction == 0)
                run_at(cx, cy - 1).first_seen = true;
            else if (direction == 2)
                run_before(cx, cy).last_seen = true;
            const int nx = cx + kX[direction], ny = cy + kY[direction];
            ring.points.push_back({(cx + nx) / 2.0, (cy + ny) / 2.0});
            twice += static_cast<std::int64_t>(cx) * ny - static_cast<std::int64_t>(nx) * cy;
            cx = nx;
            cy = ny;
            left = std::min(left, cx);
            right = std::max(right, cx);
            top = std::min(top, cy);
            bottom = std::max(bottom, cy);
            // Ink joins over corners, so it is looked for to the left first.
            const auto d = static_cast<std::size_t>(direction);
            if (ink_.ink(cx + kLeftX[d], cy + kLeftY[d]))
                direction = (direction + 3) & 3;
            else if (!ink_.ink(cx + kRightX[d], cy + kRightY[d]))
                direction = (direction + 1) & 3;
        } while (cx != start_x || cy != start_y || direction != start_direction);
        ring.area = static_cast<double>(twice < 0 ? -twice : twice) / 2;
        ring.extent = std::max(right - left, bottom - top);
        outline.rings.push_back(std::move(ring));
    }

    // The run that begins at, or ends before, that pixel of the row.
    OutlineRun& run_at(int x, int y) {
        const auto row = static_cast<std::size_t>(y);
        return *std::lower_bound(runs_.begin() + static_cast<std::ptrdiff_t>(start_[row]),
                                 runs_.begin() + static_cast<std::ptrdiff_t>(start_[row + 1]), x,
                                 [](const OutlineRun& run, int at) { return run.first < at; });
    }
    OutlineRun& run_before(int x, int y) {
        const auto row = static_cast<std::size_t>(y);
        return *std::lower_bound(runs_.begin() + static_cast<std::ptrdiff_t>(start_[row]),
                                 runs_.begin() + static_cast<std::ptrdiff_t>(start_[row + 1]), x,
                                 [](const OutlineRun& run, int at) { return run.last < at; });
    }

    const InkMap& ink_;
    std::vector<OutlineRun> runs_;
    std::vector<std::size_t> start_;  // of each row's runs
    std::vector<Outline> outlines_;
};

}  // namespace

std::vector<Outline> outlines_of(const InkMap& ink) { return Outliner(ink).build(); }

void keep_area(std::vector<Point>& ring, double area) {
    const std::size_t n = ring.size();
    double twice = 0, round = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const Point a = ring[i], b = ring[i + 1 == n ? 0 : i + 1];
        twice += a.x * b.y - b.x * a.y;
        round += std::hypot(b.x - a.x, b.y - a.y);
    }
    if (round <= 0) return;
    const double shift = std::clamp((area - std::abs(twice) / 2) / round, -0.5, 0.5) * (twice < 0 ? -1 : 1);
    const Point first = ring.front();
    Point before = ring.back();
    for (std::size_t i = 0; i < n; ++i) {
        const Point at = ring[i], after = i + 1 == n ? first : ring[i + 1];
        const double dx = after.x - before.x, dy = after.y - before.y, length = std::hypot(dx, dy);
        if (length > 0) ring[i] = {at.x + shift * dy / length, at.y - shift * dx / length};
        before = at;
    }
}

}  // namespace tactics
