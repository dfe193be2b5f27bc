// SPDX-License-Identifier: Apache-2.0
#include "tactics/lettering/dotted_rows.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "tactics/geometry/places.h"
#include "tactics/lettering/ink.h"

namespace tactics {

namespace {

// Settings.
constexpr std::size_t kFewestOfRow = 5;
constexpr int kLongestOfRow = 60;     // pixels
constexpr double kThickestOfRow = 9;  // pixels: blobs are larger
constexpr double kIsDash = 2.5;       // times as long as thick; a dot of two pixels may be twice as long
constexpr double kFilledBar = 0.3;    // by so much of a bar's ink may differ what is no bar
constexpr double kAlikeInRow = 0.3;   // of a length, in which pieces of one row may differ
constexpr double kWidestGap = 6.5;    // of a dot; drawing tools leave five times as much as it is long
constexpr double kLongestGap = 1.6;   // of a dash
constexpr double kOffCourse = 0.25;   // of a step

// A short straight bar, as long as thick if it is a dot.
struct Bar {
    std::size_t piece;
    double x, y, length, thick;
    double dx, dy;  // along it
    bool is_dash() const { return length >= kIsDash * thick; }
};

std::optional<Bar> bar_of(const InkPiece& piece, std::size_t number) {
    if (std::max(piece.box.width(), piece.box.height()) > kLongestOfRow) return std::nullopt;
    double ink = 0, sx = 0, sy = 0, xx = 0, yy = 0, xy = 0;
    for (const InkRun& run : piece.runs)
        for (int x = run.left; x < run.right; ++x) {
            ink += 1;
            sx += x;
            sy += run.y;
            xx += static_cast<double>(x) * x;
            yy += static_cast<double>(run.y) * run.y;
            xy += static_cast<double>(x) * run.y;
        }
    const double x = sx / ink, y = sy / ink;
    // Of a pixel itself there is a twelfth.
    const double vx = xx / ink - x * x + 1.0 / 12, vy = yy / ink - y * y + 1.0 / 12, v = xy / ink - x * y;
    const double middle = (vx + vy) / 2, off = std::hypot((vx - vy) / 2, v), turn = std::atan2(2 * v, vx - vy) / 2;
    const Bar bar{
        number,        x, y, std::sqrt(12 * (middle + off)), std::sqrt(12 * std::max(0.0, middle - off)), std::cos(turn),
        std::sin(turn)};
    const bool filled = std::abs(ink - bar.length * bar.thick) <= kFilledBar * bar.length * bar.thick;
    return filled && bar.thick <= kThickestOfRow ? std::optional(bar) : std::nullopt;
}

class RowFinder {
public:
    RowFinder(const std::vector<InkPiece>& pieces, const Image& grey)
        : pieces_(pieces), middles_({0, 0, 1.0 * grey.width, 1.0 * grey.height}, kCell), in_row_(pieces.size(), false) {
        for (std::size_t i = 0; i < pieces.size(); ++i)
            if (const auto bar = bar_of(pieces[i], i)) {
                bars_.push_back(*bar);
                middles_.add({bar->x, bar->y});
            }
    }

    std::vector<bool> run() {
        for (std::size_t i = 0; i < bars_.size(); ++i) {
            if (in_row_[bars_[i].piece]) continue;
            for (const std::size_t next : beside(i)) follow(i, next);
        }
        for (const Bar& bar : bars_)
            if (in_row_[bar.piece] && bar.is_dash() && stands_among_letters(bar)) in_row_[bar.piece] = false;
        return std::move(in_row_);
    }

private:
    static constexpr double kCell = 16;  // pixels
    // Between the middles of two.
    static double reach(const Bar& bar) {
        return bar.is_dash() ? (1 + kLongestGap) * bar.length : (1 + kWidestGap) * std::sqrt(bar.length * bar.thick);
    }

    std::vector<std::size_t> near(double x, double y, double radius) const {
        std::vector<std::size_t> found;
        middles_.any_near({x, y}, radius, [&](std::size_t one) {
            if (std::hypot(bars_[one].x - x, bars_[one].y - y) <= radius) found.push_back(one);
            return false;
        });
        std::sort(found.begin(), found.end());
        return found;
    }

    // With which a row may begin there: in each direction the nearest.
    std::vector<std::size_t> beside(std::size_t first) const {
        constexpr double kSameWay = 0.8;  // cosine
        const Bar& from = bars_[first];
        std::vector<std::size_t> found, all = near(from.x, from.y, reach(from));
        const auto away = [&](std::size_t one) { return std::hypot(bars_[one].x - from.x, bars_[one].y - from.y); };
        std::erase_if(all, [&](std::size_t one) { return one == first || !goes_on(from, bars_[one]); });
        std::sort(all.begin(), all.end(),
                  [&](std::size_t a, std::size_t b) { return std::pair(away(a), a) < std::pair(away(b), b); });
        for (const std::size_t one : all)
            if (std::none_of(found.begin(), found.end(), [&](std::size_t other) {
                    const double along =
                        (bars_[one].x - from.x) * (bars_[other].x - from.x) + (bars_[one].y - from.y) * (bars_[other].y - from.y);
                    return along > kSameWay * away(one) * away(other);
                }))
                found.push_back(one);
        return found;
    }

    static bool goes_on(const Bar& from, const Bar& to) {
        constexpr double kTurn = 0.35;  // of a dash off the way, sine
        if (from.is_dash() != to.is_dash() || std::abs(from.length - to.length) > kAlikeInRow * from.length + 1 ||
            std::abs(from.thick - to.thick) > kAlikeInRow * from.thick + 0.7)
            return false;
        const double dx = to.x - from.x, dy = to.y - from.y, way = std::hypot(dx, dy);
        const auto is_along = [&](const Bar& bar) { return std::abs(bar.dx * dy - bar.dy * dx) <= kTurn * way; };
        return !from.is_dash() || (is_along(from) && is_along(to));
    }

    // From one to the next, and on from there.
    void follow(std::size_t first, std::size_t second) {
        std::vector<std::size_t> row{first, second};
        while (row.size() < bars_.size()) {
            const Bar &last = bars_[row.back()], &before = bars_[row[row.size() - 2]];
            const double dx = last.x - before.x, dy = last.y - before.y, off = kOffCourse * std::hypot(dx, dy) + 1;
            std::optional<std::size_t> next;
            for (const std::size_t one : near(last.x + dx, last.y + dy, off))
                if (one != row.back() && goes_on(last, bars_[one]) && (!next || is_nearer(one, *next, last.x + dx, last.y + dy)))
                    next = one;
            if (!next || std::find(row.begin(), row.end(), *next) != row.end()) break;
            row.push_back(*next);
        }
        if (row.size() >= kFewestOfRow)
            for (const std::size_t one : row) in_row_[bars_[one].piece] = true;
    }

    bool is_nearer(std::size_t a, std::size_t b, double x, double y) const {
        return std::hypot(bars_[a].x - x, bars_[a].y - y) < std::hypot(bars_[b].x - x, bars_[b].y - y);
    }

    // An i between others, with which a row of dashes seems to go on.
    bool stands_among_letters(const Bar& bar) const {
        constexpr double kNear = 0.7, kBesideIt = 0.5, kTallest = 2.5;  // of its length
        const bool upright = std::abs(bar.dy) > std::abs(bar.dx);
        const auto seen = [&](const PixelBox& box) {  // as if it were upright
            return upright ? box : PixelBox{box.top, box.left, box.bottom, box.right};
        };
        const PixelBox own = seen(pieces_[bar.piece].box);
        bool left = false, right = false;
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            const PixelBox box = seen(pieces_[i].box);
            const int both = std::min(own.bottom, box.bottom) - std::max(own.top, box.top);
            if (in_row_[i] || both < kBesideIt * bar.length || box.height() > kTallest * bar.length) continue;
            left = left || (box.left < own.left && own.left - box.right <= kNear * bar.length);
            right = right || (box.right > own.right && box.left - own.right <= kNear * bar.length);
        }
        return left && right;
    }

    const std::vector<InkPiece>& pieces_;
    std::vector<Bar> bars_;
    Places middles_;  // of the bars
    std::vector<bool> in_row_;
};

// With the paler pixels around it, but for ink of others.
void paint_out(Image& grey, const Image& others, const PixelBox& box, std::uint8_t ground) {
    for (int y = std::max(0, box.top - 1); y < std::min(grey.height, box.bottom + 1); ++y)
        for (int x = std::max(0, box.left - 1); x < std::min(grey.width, box.right + 1); ++x)
            if (others.row(y)[x] == 0) grey.row(y)[x] = std::max(grey.row(y)[x], ground);
}

// The lightest that is right beside it.
std::uint8_t ground_around(const Image& grey, const PixelBox& box) {
    constexpr int kBesideDot = 2;
    std::uint8_t ground = 0;
    for (const int y : {box.top - kBesideDot, box.bottom + kBesideDot - 1})
        for (const int x : {box.left - kBesideDot, box.right + kBesideDot - 1})
            if (x >= 0 && y >= 0 && x < grey.width && y < grey.height) ground = std::max(ground, grey.row(y)[x]);
    return ground;
}

}  // namespace

Image without_dotted_rows(Image grey) {
    constexpr int kInkOfRows = 160;
    constexpr std::size_t kMostOfRows = 10'000;  // pieces; more is a texture
    const std::vector<InkPiece> pieces = pieces_of(grey, kInkOfRows, false, std::max(grey.width, grey.height));
    if (pieces.size() > kMostOfRows) return grey;
    const std::vector<bool> in_row = RowFinder(pieces, grey).run();
    if (std::find(in_row.begin(), in_row.end(), true) == in_row.end()) return grey;
    Image others = make_image(grey.width, grey.height, 1, 0, 0);
    for (std::size_t i = 0; i < pieces.size(); ++i)
        for (const InkRun& run : pieces[i].runs)
            if (!in_row[i]) std::fill(others.row(run.y) + run.left, others.row(run.y) + run.right, std::uint8_t{1});
    for (std::size_t i = 0; i < pieces.size(); ++i)
        if (in_row[i]) paint_out(grey, others, pieces[i].box, ground_around(grey, pieces[i].box));
    return grey;
}

}  // namespace tactics
