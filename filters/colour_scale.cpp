// SPDX-License-Identifier: Apache-2.0
#include "filters/colour_scale.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "filters/opencv.h"

namespace tactics {

namespace {

using ScaleColour = std::array<double, 3>;

double colours_apart(const ScaleColour& a, const ScaleColour& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

double middle_value(std::vector<double>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

// All in levels of a channel; the way from black to white is 441 long. These numbers are this project's own.
constexpr double kShortestWay = 130;  // a course that says something: the pale half of a scale of one hue
constexpr double kReturns = 0.25;     // of the way between two colours; a course that comes nearer to itself is none
constexpr double kSurelyUnlike = 40;  // or they are at least so far apart, as the dark ends of a rainbow are
constexpr double kFirstOfWay = 0.12;  // of the whole way; what is nearer is a neighbour
constexpr double kSameKnot = 6;       // steps of one colour, and compression

// Whether each colour is unlike all that are not its neighbours.
bool runs_one_way(const std::vector<ScaleColour>& course) {
    std::vector<double> way{0};
    for (std::size_t i = 1; i < course.size(); ++i) way.push_back(way.back() + colours_apart(course[i - 1], course[i]));
    if (way.back() < kShortestWay) return false;
    for (std::size_t i = 0; i < course.size(); ++i)
        for (std::size_t j = i + 1; j < course.size(); ++j)
            if (const double between = way[j] - way[i];
                between > kFirstOfWay * way.back() &&
                colours_apart(course[i], course[j]) < std::min(kReturns * between, kSurelyUnlike))
                return false;
    return true;
}

// The colour of each row (or column) of the bar, from its low end; the middle third, as ticks may be within. Empty: it has more
// than one colour across.
std::vector<ScaleColour> colours_along(const cv::Mat& picture, const PixelBox& bar) {
    constexpr double kSameAcross = 12;  // levels
    constexpr double kMostOdd = 0.1;    // of the rows: lines between its parts
    const bool upright = bar.height() > bar.width();
    const int length = upright ? bar.height() : bar.width(), across = upright ? bar.width() : bar.height();
    std::vector<ScaleColour> colours;
    std::array<std::vector<double>, 3> row;
    int odd = 0;
    for (int k = 0; k < length; ++k) {
        ScaleColour colour;
        double spread = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            row[c].clear();
            for (int i = across / 3; i < std::max(across - across / 3, across / 3 + 1); ++i) {
                const int x = upright ? bar.left + i : bar.left + k, y = upright ? bar.bottom - 1 - k : bar.top + i;
                row[c].push_back(picture.ptr(y)[3 * x + static_cast<int>(c)]);
            }
            const auto [least, most] = std::minmax_element(row[c].begin(), row[c].end());
            spread = std::max(spread, *most - *least);
            colour[c] = middle_value(row[c]);
        }
        odd += spread > kSameAcross ? 1 : 0;
        colours.push_back(colour);
    }
    if (odd > kMostOdd * length) colours.clear();
    return colours;
}

// Without what one or two rows have for themselves, such as a line between two parts or the tremble of compression, which would
// make the course longer than it is.
std::vector<ScaleColour> without_lines(const std::vector<ScaleColour>& colours) {
    const std::size_t half = std::max<std::size_t>(2, colours.size() / 60);
    std::vector<ScaleColour> clean(colours.size());
    std::vector<double> near;
    for (std::size_t i = 0; i < colours.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const std::size_t least = i < half ? 0 : i - half;
            near.clear();
            for (std::size_t k = least; k <= std::min(i + half, colours.size() - 1); ++k) near.push_back(colours[k][c]);
            clean[i][c] = middle_value(near);
        }
    return clean;
}

}  // namespace

ColourScale::Found ColourScale::nearest(const std::uint8_t* rgb) const {
    const ScaleColour own{static_cast<double>(rgb[0]), static_cast<double>(rgb[1]), static_cast<double>(rgb[2])};
    Found found{0, std::numeric_limits<double>::max()};
    for (std::size_t i = 0; i + 1 < knots_.size(); ++i) {
        const ScaleColour &a = knots_[i].colour, &b = knots_[i + 1].colour;
        double along = 0, all = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            along += (own[c] - a[c]) * (b[c] - a[c]);
            all += (b[c] - a[c]) * (b[c] - a[c]);
        }
        const double share = all > 0 ? std::clamp(along / all, 0.0, 1.0) : 0;
        double away = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            const double apart = own[c] - a[c] - share * (b[c] - a[c]);
            away += apart * apart;
        }
        if (away < found.away) found = {knots_[i].position + share * (knots_[i + 1].position - knots_[i].position), away};
    }
    found.away = std::sqrt(found.away);
    return found;
}

std::optional<ColourScale> scale_of_bar(const cv::Mat& picture, const PixelBox& bar) {
    constexpr double kMostOfWay = 0.45;  // for one step: a scale has three colours at least
    const std::vector<ScaleColour> along = colours_along(picture, bar);
    if (along.size() < 8) return std::nullopt;
    const std::vector<ScaleColour> colours = without_lines(along);
    std::vector<ColourScale::Knot> knots;
    std::vector<ScaleColour> course;
    // One knot for each piece of one colour, in its middle.
    for (std::size_t begin = 0, end = 0; begin < colours.size(); begin = end) {
        while (end < colours.size() && colours_apart(colours[begin], colours[end]) <= kSameKnot) ++end;
        course.push_back(colours[(begin + end - 1) / 2]);
        knots.push_back({static_cast<double>(begin + end) / 2 / static_cast<double>(colours.size()), course.back()});
    }
    if (!runs_one_way(course)) return std::nullopt;
    double way = 0, longest = 0;
    for (std::size_t i = 1; i < course.size(); ++i) {
        way += colours_apart(course[i - 1], course[i]);
        longest = std::max(longest, colours_apart(course[i - 1], course[i]));
    }
    if (longest > kMostOfWay * way) return std::nullopt;
    return ColourScale(std::move(knots));
}

namespace {

struct ScaleShade {
    ScaleColour colour{};
    double count = 0;
};

// The colours of the field, gathered; without the rare ones, which are lines and letters.
std::vector<ScaleShade> shades_of(const cv::Mat& picture, const PixelBox& field) {
    constexpr double kRare = 0.0004;
    constexpr std::size_t kMostShades = 600;  // a course of colours has some hundred
    std::map<int, ScaleShade> shades;
    for (int y = field.top; y < field.bottom; ++y)
        for (int x = field.left; x < field.right; ++x) {
            const std::uint8_t* at = picture.ptr(y) + static_cast<std::ptrdiff_t>(3) * x;
            ScaleShade& shade = shades[(at[0] >> 3) << 10 | (at[1] >> 3) << 5 | at[2] >> 3];
            for (std::size_t c = 0; c < 3; ++c) shade.colour[c] += at[c];
            ++shade.count;
        }
    std::vector<ScaleShade> common;
    const double least = kRare * field.width() * field.height();
    for (auto& [key, shade] : shades) {
        if (shade.count < least) continue;
        for (double& channel : shade.colour) channel /= shade.count;
        common.push_back(shade);
    }
    if (common.size() > kMostShades) common.clear();
    return common;
}

// A surface on its ground, between which edges are soft.
bool is_in_two_colours(const std::vector<ScaleShade>& shades) {
    constexpr double kBetween = 0.12;  // of all that a gradient has at least
    double all = 0;
    std::vector<double> counts;
    for (const ScaleShade& shade : shades) {
        all += shade.count;
        counts.push_back(shade.count);
    }
    std::sort(counts.rbegin(), counts.rend());
    return counts.size() < 3 || all - counts[0] - counts[1] < kBetween * all;
}

// The shortest tree that joins all shades: of each, the one that it hangs on, which stands before it in `order`.
struct ShadeTree {
    std::vector<std::size_t> order, parent;
};
ShadeTree shade_tree_of(const std::vector<ScaleShade>& shades) {
    ShadeTree tree{{}, std::vector<std::size_t>(shades.size(), 0)};
    std::vector<double> away(shades.size(), std::numeric_limits<double>::max());
    std::vector<bool> done(shades.size());
    away[0] = 0;
    for (std::size_t k = 0; k < shades.size(); ++k) {
        std::size_t next = shades.size();
        for (std::size_t i = 0; i < shades.size(); ++i)
            if (!done[i] && (next == shades.size() || away[i] < away[next])) next = i;
        done[next] = true;
        tree.order.push_back(next);
        for (std::size_t i = 0; i < shades.size(); ++i)
            if (const double d = colours_apart(shades[next].colour, shades[i].colour); !done[i] && d < away[i])
                away[i] = d, tree.parent[i] = next;
    }
    return tree;
}

// The longest way through the tree: down to the deepest leaf from the node where the two deepest branches part.
std::vector<ScaleColour> longest_way(const std::vector<ScaleShade>& shades) {
    const ShadeTree tree = shade_tree_of(shades);
    const std::size_t none = shades.size();
    std::vector<double> deep(none, 0), second(none, 0);
    std::vector<std::size_t> down(none, none), other(none, none);
    for (auto at = tree.order.rbegin(); at != tree.order.rend() && *at != tree.order.front(); ++at) {
        const std::size_t child = *at, up = tree.parent[child];
        const double depth = deep[child] + colours_apart(shades[child].colour, shades[up].colour);
        if (depth > deep[up]) {
            second[up] = std::exchange(deep[up], depth);
            other[up] = std::exchange(down[up], child);
        } else if (depth > second[up]) {
            second[up] = depth;
            other[up] = child;
        }
    }
    std::size_t top = 0;
    for (std::size_t i = 1; i < none; ++i)
        if (deep[i] + second[i] > deep[top] + second[top]) top = i;
    std::vector<ScaleColour> way;
    for (std::size_t i = other[top]; i != none; i = down[i]) way.push_back(shades[i].colour);
    std::reverse(way.begin(), way.end());
    for (std::size_t i = top; i != none; i = down[i]) way.push_back(shades[i].colour);
    return way;
}

// Shades are gathered in cubes, so that the way through them trembles.
std::vector<ScaleColour> steadied_way(const std::vector<ScaleColour>& way) {
    constexpr std::size_t kHalf = 2;
    std::vector<ScaleColour> steady(way.size());
    for (std::size_t i = 0; i < way.size(); ++i) {
        const std::size_t half = std::min({kHalf, i, way.size() - 1 - i});
        for (std::size_t k = i - half; k <= i + half; ++k)
            for (std::size_t c = 0; c < 3; ++c) steady[i][c] += way[k][c] / static_cast<double>(2 * half + 1);
    }
    return steady;
}

double lightness_of(const ScaleColour& colour) { return 0.299 * colour[0] + 0.587 * colour[1] + 0.114 * colour[2]; }

}  // namespace

std::optional<ColourScale> scale_of_colours(const cv::Mat& picture, const PixelBox& field) {
    constexpr std::size_t kLeastShades = 16;
    constexpr double kLongestStep = 40, kOnTheWay = 7, kNearlyAll = 0.95, kColourful = 60;  // levels; a share
    const std::vector<ScaleShade> shades = shades_of(picture, field);
    if (shades.size() < kLeastShades || is_in_two_colours(shades)) return std::nullopt;
    std::vector<ScaleColour> way = longest_way(shades);
    double colourful = 0, longest = 0;
    for (std::size_t i = 0; i < way.size(); ++i) {
        const auto [least, most] = std::minmax_element(way[i].begin(), way[i].end());
        colourful = std::max(colourful, *most - *least);
        if (i > 0) longest = std::max(longest, colours_apart(way[i - 1], way[i]));
    }
    way = steadied_way(way);
    if (colourful < kColourful || longest > kLongestStep || !runs_one_way(way)) return std::nullopt;
    // Of two dark ends the red one is high, as in every rainbow.
    const double darker = lightness_of(way.front()) - lightness_of(way.back());
    constexpr double kAsDark = 30;
    if (std::abs(darker) < kAsDark ? way.back()[0] - way.back()[2] < way.front()[0] - way.front()[2] : darker < 0)
        std::reverse(way.begin(), way.end());
    std::vector<ColourScale::Knot> knots{{0, way.front()}};
    for (std::size_t i = 1; i < way.size(); ++i)
        knots.push_back({knots.back().position + colours_apart(way[i - 1], way[i]), way[i]});
    for (ColourScale::Knot& knot : knots) knot.position /= knots.back().position > 0 ? knots.back().position : 1;
    ColourScale scale(std::move(knots));
    double all = 0, on_the_way = 0;
    for (const ScaleShade& shade : shades) {
        const std::uint8_t rgb[3] = {static_cast<std::uint8_t>(shade.colour[0]), static_cast<std::uint8_t>(shade.colour[1]),
                                     static_cast<std::uint8_t>(shade.colour[2])};
        all += shade.count;
        on_the_way += scale.nearest(rgb).away <= kOnTheWay ? shade.count : 0;
    }
    if (all < kNearlyAll * field.width() * field.height() * 0.9 || on_the_way < kNearlyAll * all) return std::nullopt;
    return scale;
}

}  // namespace tactics
