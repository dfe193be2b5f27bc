// SPDX-License-Identifier: Apache-2.0
#include "filters/ruled_cells.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include "filters/opencv.h"
#include "tactics/image.h"

namespace tactics {

namespace {

// Levels, pixels and shares; settings, all.
constexpr int kFlatLevels = 14;    // that neighbours in one colour may differ by
constexpr int kNearFlat = 13;      // pixels that an even place is with the line along it, if it is 9 wide
constexpr int kDarkRule = 50;      // levels that a line in such a pattern is darker than it, and
constexpr double kDarkest = 0.35;  // of its darkest places
constexpr double kRectangle = 0.85,
                 kFilledRectangle = 0.95;  // of its box is the cell; and is one of one colour, which a disc is not
constexpr double kWholePicture = 0.8;      // of the picture's width; a frame
constexpr int kSameSide = 2;               // pixels
constexpr int kSameLevels = 20;
constexpr double kBlankCell = 0.05, kCrossedCell = 0.3;  // of a cell that is blank, and of one in a colour, next to other colours
constexpr double kSpread = 0.3;                          // of that share has each ninth of a hatch
constexpr std::size_t kMostCells = 4000;

struct Rules {
    cv::Mat upright, level;
};

cv::Mat box_of(int width, int height) { return cv::getStructuringElement(cv::MORPH_RECT, cv::Size(width, height)); }

cv::Mat opened_by(const cv::Mat& mask, const cv::Mat& box) {
    cv::Mat open;
    cv::morphologyEx(mask, open, cv::MORPH_OPEN, box);
    return open;
}

// Without the runs of a line that leans: where such a one ends, it goes on a row higher at one end and a row lower at the other.
cv::Mat without_stairs(const cv::Mat& rows) {
    constexpr int kGoesOn = 2;  // pixels
    cv::Mat straight = rows.clone();
    const auto goes_on = [&](int y, int from) {
        if (y < 0 || y >= rows.rows || from < 0 || from + kGoesOn > rows.cols) return false;
        return cv::countNonZero(rows(cv::Rect(from, y, kGoesOn, 1))) == kGoesOn;
    };
    for (int y = 0; y < rows.rows; ++y)
        for (int begin = 0, end = 0; begin < rows.cols; begin = end + 1) {
            const std::uint8_t* row = rows.ptr<std::uint8_t>(y);
            while (begin < rows.cols && row[begin] == 0) ++begin;
            for (end = begin; end < rows.cols && row[end] != 0;) ++end;
            for (const int up : {-1, 1})
                if (goes_on(y - up, begin - kGoesOn) && goes_on(y + up, end)) straight(cv::Rect(begin, y, end - begin, 1)) = 0;
        }
    return straight;
}

// Where an even place ends along a straight line. Within patterns lines that are darker than these all along.
Rules rules_in(const cv::Mat& pixels, const cv::Mat& uneven, const RulePixels& sizes) {
    cv::Mat grey = pixels, darkest;
    if (pixels.channels() == 3) cv::cvtColor(pixels, grey, cv::COLOR_RGB2GRAY);
    const cv::Mat dark = 255 - grey, flat = opened_by(~uneven, box_of(sizes.flat, sizes.flat));
    cv::dilate(dark, darkest, box_of(sizes.widest, sizes.widest));
    const auto along = [&](int across, int down) {
        const bool upright = down > across;
        const auto level_runs = [&](const cv::Mat& mask) -> cv::Mat {
            return upright ? without_stairs(mask.t()).t() : without_stairs(mask);
        };
        const cv::Mat run = box_of(across, down), beside = upright ? box_of(sizes.widest, 1) : box_of(1, sizes.widest);
        cv::Mat near_flat;
        cv::dilate(flat, near_flat, upright ? box_of(kNearFlat, 1) : box_of(1, kNearFlat));
        const cv::Mat dark_along = opened_by(dark, run), darker = dark_along - opened_by(dark_along, beside);
        const cv::Mat dark_lines = (darker > kDarkRule) & (darker > kDarkest * darkest);
        cv::Mat lines = opened_by(level_runs(dark_lines), run) | opened_by(level_runs(uneven & near_flat), run);
        // At a corner each of two lines hides the end of the other.
        cv::dilate(lines, lines, upright ? box_of(1, sizes.widest) : box_of(sizes.widest, 1));
        return lines;
    };
    return {along(1, sizes.shortest), along(sizes.shortest, 1)};
}

PixelColour middle_colour_of(const cv::Mat& pixels, const cv::Mat& mask) {
    std::array<std::array<int, 256>, 3> counts{};
    const int channels = pixels.channels();
    int all = 0;
    for (int y = 0; y < pixels.rows; ++y)
        for (int x = 0; x < pixels.cols; ++x) {
            if (mask.at<std::uint8_t>(y, x) == 0) continue;
            ++all;
            for (int c = 0; c < 3; ++c)
                ++counts[static_cast<std::size_t>(c)][pixels.ptr<std::uint8_t>(y)[x * channels + std::min(c, channels - 1)]];
        }
    PixelColour middle{};
    for (std::size_t c = 0; c < 3; ++c)
        for (int below = counts[c][0]; below <= all / 2 && middle[c] < 255;)
            below += counts[c][static_cast<std::size_t>(++middle[c])];
    return middle;
}

bool same_colour(const PixelColour& a, const PixelColour& b) { return channels_apart(a, b) <= kSameLevels; }

// The marks of a hatch are all over it; a curve crosses a part of a cell.
bool is_all_over(const cv::Mat& busy, double share) {
    constexpr int kParts = 3;
    const int wide = busy.cols / kParts, high = busy.rows / kParts;
    if (wide == 0 || high == 0) return true;
    for (int i = 0; i < kParts; ++i)
        for (int j = 0; j < kParts; ++j)
            if (cv::countNonZero(busy(cv::Rect(i * wide, j * high, wide, high))) < kSpread * share * wide * high) return false;
    return true;
}

// By the share of its pixels that are next to other colours.
CellFill fill_of(double busy, bool is_ground) {
    if (busy > (is_ground ? kBlankCell : kCrossedCell)) return CellFill::hatch;
    return is_ground ? CellFill::ground : CellFill::colour;
}

CellFill fill_of_all(const cv::Mat& busy, int size, bool is_ground) {
    const double share = static_cast<double>(cv::countNonZero(busy)) / size;
    return fill_of(is_all_over(busy, share) ? share : 0, is_ground);
}

std::vector<RuledCell> cells_between(const cv::Mat& pixels, const cv::Mat& uneven, const cv::Mat& rules,
                                     const PixelColour& ground) {
    cv::Mat labels, stats, middles;
    const int count = cv::connectedComponentsWithStats(~rules, labels, stats, middles, 4, CV_32S);
    std::vector<RuledCell> cells;
    for (int i = 1; i < count; ++i) {
        const cv::Rect box = box_of_piece(stats, i);
        const int size = stats.at<int>(i, cv::CC_STAT_AREA);
        if (std::min(box.width, box.height) < 2 || box.width > kWholePicture * pixels.cols || size < kRectangle * box.area())
            continue;
        if (cells.size() == kMostCells) return {};
        const cv::Mat own = labels(box) == i;
        const PixelColour colour = middle_colour_of(pixels(box), own);
        const CellFill fill = fill_of_all(uneven(box) & own, size, same_colour(colour, ground));
        if (fill == CellFill::colour && size < kFilledRectangle * box.area()) continue;
        cells.push_back({{box.x, box.y, box.br().x, box.br().y}, fill, colour, {}});
    }
    return cells;
}

// Cells one below the other; of a picture turned over its diagonal they are beside each other.
class CellsBelow {
public:
    CellsBelow(std::vector<RuledCell>& cells, int hatch) : cells_(cells), hatch_(hatch) {}

    // Those that the lines of a hatch part are one.
    void join_hatches() {
        std::vector<bool> gone(cells_.size());
        sort();
        for (std::size_t i = 0; i < cells_.size(); ++i) {
            if (gone[i] || !is_sliver(cells_[i])) continue;
            std::vector<std::size_t> row{i};
            for (std::size_t next = below(i, hatch_); next < cells_.size(); next = below(next, hatch_)) {
                if (gone[next] || !is_sliver(cells_[next]) || !same_colour(cells_[i].colour, cells_[next].colour)) break;
                // But for the first and the last one all are as high.
                if (row.size() > 2 && std::abs(cells_[row.back()].box.height() - cells_[row[1]].box.height()) > kSameSide) break;
                row.push_back(next);
            }
            constexpr std::size_t kFewest = 3;
            if (row.size() < kFewest) continue;
            for (std::size_t k = 1; k < row.size(); ++k) {
                cells_[i].box = around(cells_[i].box, cells_[row[k]].box);
                gone[row[k]] = true;
            }
            cells_[i].fill = CellFill::hatch;
        }
        drop(gone);
    }

private:
    bool is_sliver(const RuledCell& cell) const { return cell.box.height() <= hatch_; }

    void sort() {
        std::sort(cells_.begin(), cells_.end(), [](const RuledCell& a, const RuledCell& b) {
            return std::pair(a.box.top, a.box.left) < std::pair(b.box.top, b.box.left);
        });
    }

    void drop(const std::vector<bool>& gone) {
        std::size_t i = 0;
        std::erase_if(cells_, [&](const RuledCell&) { return gone[i++]; });
    }

    // The first one that is as wide, so many pixels below at most.
    std::size_t below(std::size_t upper, int most) const {
        const PixelBox& box = cells_[upper].box;
        for (std::size_t i = upper + 1; i < cells_.size() && cells_[i].box.top <= box.bottom + most; ++i)
            if (cells_[i].box.top >= box.bottom && std::abs(cells_[i].box.left - box.left) <= kSameSide &&
                std::abs(cells_[i].box.right - box.right) <= kSameSide)
                return i;
        return cells_.size();
    }

    std::vector<RuledCell>& cells_;
    int hatch_;
};

void turn_over(std::vector<RuledCell>& cells) {
    for (RuledCell& cell : cells) cell.box = {cell.box.top, cell.box.left, cell.box.bottom, cell.box.right};
}

// How many pixels from there on are of a line, up to so many.
int rule_width(const cv::Mat& rules, cv::Point at, cv::Point step, int most) {
    int wide = 0;
    for (; wide < most && at.inside(cv::Rect(0, 0, rules.cols, rules.rows)) && rules.at<std::uint8_t>(at) != 0; at += step)
        ++wide;
    return wide;
}

// The least of three places along the side.
int side_width(const cv::Mat& rules, cv::Point first, cv::Point last, cv::Point out, int most) {
    constexpr int kPlaces = 4;
    int least = most;
    for (int i = 1; i < kPlaces; ++i) least = std::min(least, rule_width(rules, first + (last - first) * i / kPlaces, out, most));
    return least;
}

// The line at a side of a hatch is one with the first line of the hatch where these are close.
void measure_lines(std::vector<RuledCell>& cells, const cv::Mat& rules, int hatch) {
    constexpr int kPlain = 3, kSingle = 4;  // pixels: of a thin line, and no more than of two
    for (RuledCell& cell : cells) {
        PixelBox& b = cell.box;
        const cv::Point upper_left(b.left - 1, b.top - 1), upper_right(b.right, b.top - 1), lower_left(b.left - 1, b.bottom),
            lower_right(b.right, b.bottom);
        const int most = hatch + 2 * kPlain;
        const std::array<int, 4> wide{
            side_width(rules, upper_left, lower_left, {-1, 0}, most), side_width(rules, upper_left, upper_right, {0, -1}, most),
            side_width(rules, upper_right, lower_right, {1, 0}, most), side_width(rules, lower_left, lower_right, {0, 1}, most)};
        std::array<int, 4> more{};
        for (std::size_t i = 0; i < 4; ++i) {
            if (cell.fill == CellFill::hatch && wide[i] > kSingle && wide[i] < most) more[i] = wide[i] - kPlain;
            cell.lines[i] = std::min(wide[i] - more[i], 2 * kPlain);
        }
        b = {b.left - more[0], b.top - more[1], b.right + more[2], b.bottom + more[3]};
    }
}

}  // namespace

std::vector<RuledCell> ruled_cells_in(const Image& picture, const PixelColour& ground, const RulePixels& sizes) {
    const cv::Mat pixels = view_of(picture), uneven = range_around(pixels) > kFlatLevels;
    const Rules rules = rules_in(pixels, uneven, sizes);
    const cv::Mat all = rules.upright | rules.level;
    std::vector<RuledCell> cells = cells_between(pixels, uneven, all, ground);
    CellsBelow(cells, sizes.hatch).join_hatches();
    turn_over(cells);
    CellsBelow(cells, sizes.hatch).join_hatches();
    turn_over(cells);
    // Between two lines that are as close there is no cell.
    cv::Mat closed;
    cv::morphologyEx(all, closed, cv::MORPH_CLOSE, box_of(3, 3));
    measure_lines(cells, closed, sizes.hatch);
    return cells;
}

RuledCell cell_at(const Image& picture, const PixelColour& ground, const PixelBox& box) {
    // What is around it does not count.
    const cv::Mat pixels = view_of(picture)(cv::Rect(box.left, box.top, box.width(), box.height())).clone();
    const PixelColour colour = middle_colour_of(pixels, cv::Mat(pixels.size(), CV_8U, cv::Scalar(255)));
    const double busy = static_cast<double>(cv::countNonZero(range_around(pixels) > kFlatLevels)) / (box.width() * box.height());
    return {box, fill_of(busy, same_colour(colour, ground)), colour, {}};
}

}  // namespace tactics
