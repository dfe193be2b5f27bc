// SPDX-License-Identifier: Apache-2.0
// Each form is tried in each size wherever there is ink: the middle line of its strokes must be ink, what is within it ground,
// and what is around it ground, too, but for one or two lines.
#include "filters/line_marks.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <random>
#include <utility>

#include "filters/lab.h"
#include "filters/opencv.h"
#include "filters/runs_around.h"

namespace tactics {

namespace {

constexpr int kFormMargin = 5;  // pixels around the middle line
constexpr int kSmallForm = 14;  // pixels: below, lines are thinner, too

struct LineForm {
    MarkForm shape;
    int size = 0, box = 0;          // pixels across; of the box around it
    std::vector<cv::Point> line;    // from the corner of the box
    std::vector<cv::Point> within;  // clear of the line
    std::vector<cv::Point> hull;    // around it, in order
};

struct LineMarkPlace {
    std::size_t form = 0;
    cv::Point corner;
    double worth = 0;
    PixelColour colour{};
};

using Corners = std::vector<std::vector<cv::Point2d>>;  // of each stroke, from -1 to 1

std::vector<std::pair<MarkForm, Corners>> line_shapes() {
    std::vector<cv::Point2d> round;
    for (int i = 0; i <= 32; ++i) round.emplace_back(std::sin(2 * CV_PI * i / 32), -std::cos(2 * CV_PI * i / 32));
    return {{MarkForm::ring, {round}},
            {MarkForm::open_square, {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}}}},
            {MarkForm::open_diamond, {{{0, -1}, {1, 0}, {0, 1}, {-1, 0}, {0, -1}}}},
            {MarkForm::open_triangle, {{{0, -1}, {1, 1}, {-1, 1}, {0, -1}}}},
            {MarkForm::open_triangle, {{{0, 1}, {1, -1}, {-1, -1}, {0, 1}}}},
            {MarkForm::open_triangle, {{{0, -1}, {1, 0.73}, {-1, 0.73}, {0, -1}}}},  // of three equal sides
            {MarkForm::open_triangle, {{{0, 1}, {1, -0.73}, {-1, -0.73}, {0, 1}}}},
            {MarkForm::plus, {{{-1, 0}, {1, 0}}, {{0, -1}, {0, 1}}}},
            {MarkForm::cross, {{{-1, -1}, {1, 1}}, {{-1, 1}, {1, -1}}}}};
}

// No mark is known by a pixel of an axis, a frame or a grid.
cv::Mat without_long_lines(const cv::Mat& black, int length) {
    cv::Mat level, upright;
    cv::morphologyEx(black, level, cv::MORPH_OPEN, cv::getStructuringElement(cv::MORPH_RECT, cv::Size(length, 1)));
    cv::morphologyEx(black, upright, cv::MORPH_OPEN, cv::getStructuringElement(cv::MORPH_RECT, cv::Size(1, length)));
    return black & ~(level | upright);
}

LineForm form_of(MarkForm shape, const Corners& strokes, int size) {
    LineForm form{shape, size, size + 2 * kFormMargin, {}, {}, {}};
    cv::Mat line = cv::Mat::zeros(form.box, form.box, CV_8U), full = line.clone();
    const double half = (size - 1) / 2.0, middle = kFormMargin + half;
    std::vector<cv::Point> all;
    for (const auto& stroke : strokes) {
        std::vector<cv::Point> corners;
        for (const cv::Point2d& p : stroke)
            corners.emplace_back(static_cast<int>(std::lround(middle + half * p.x)),
                                 static_cast<int>(std::lround(middle + half * p.y)));
        cv::polylines(line, corners, false, cv::Scalar(255));
        all.insert(all.end(), corners.begin(), corners.end());
    }
    std::vector<cv::Point> hull;
    cv::convexHull(all, hull);
    cv::fillConvexPoly(full, hull, cv::Scalar(255));
    cv::findNonZero(line, form.line);
    // In no order, so that where it does not fit is seen at once.
    std::shuffle(form.line.begin(), form.line.end(), std::mt19937(1));
    const cv::Mat within = full & ~spread(line, size < kSmallForm ? 1 : 2);
    if (cv::countNonZero(within) > 0) cv::findNonZero(within, form.within);
    std::vector<std::vector<cv::Point>> rings;
    cv::findContours(spread(full, 3), rings, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
    form.hull = rings.front();
    return form;
}

// How many lines leave it; nothing if they are too wide for that.
std::optional<std::size_t> lines_leaving(const LineForm& form, cv::Point corner, const cv::Mat& black) {
    constexpr double kWidest = 0.5;  // of its size
    const auto runs = runs_around(
        form.hull.size(), [&](std::size_t i) { return black.at<std::uint8_t>(corner + form.hull[i % form.hull.size()]) != 0; });
    if (!runs || std::any_of(runs->begin(), runs->end(),
                             [&](const RunAround& run) { return static_cast<double>(run.length) > kWidest * form.size; }))
        return std::nullopt;
    return runs->size();
}

// How deep its line is in ink, nothing where it is not there.
std::optional<double> depth_at(const LineForm& form, cv::Point corner, const cv::Mat& black, const cv::Mat& near,
                               const cv::Mat& deep) {
    constexpr double kMissing = 0.04, kBeside = 0.25, kMostWithin = 0.4;  // of its line, twice; of what is within
    constexpr double kStrokes = 4.5;                                      // that are as wide as the form, at least
    constexpr double kThickest = 4;                                       // pixels from the ground: a line of 7
    const auto all = static_cast<double>(form.line.size());
    int missing = 0, beside = 0;
    double sum = 0;
    for (const cv::Point& p : form.line) {
        // A thin line may be beside its middle for a while.
        if (near.at<std::uint8_t>(corner + p) == 0 && ++missing > kMissing * all) return std::nullopt;
        const auto depth = static_cast<double>(deep.at<float>(corner + p));
        if (depth > kThickest || (depth == 0 && ++beside > kBeside * all)) return std::nullopt;
        sum += depth;
    }
    if (form.size < kStrokes * (2 * sum / (all - beside) - 1)) return std::nullopt;
    const auto inked = std::count_if(form.within.begin(), form.within.end(),
                                     [&](const cv::Point& p) { return black.at<std::uint8_t>(corner + p) != 0; });
    if (static_cast<double>(inked) > kMostWithin * static_cast<double>(form.within.size())) return std::nullopt;
    const auto lines = lines_leaving(form, corner, black);
    if (!lines || *lines < 1 || *lines > 2) return std::nullopt;
    return sum / static_cast<double>(form.line.size());
}

// Of places that overlap the deepest: a line's middle is deeper than its sides. Of two as deep the larger one.
std::vector<LineMarkPlace> best_of(std::vector<LineMarkPlace> places, const std::vector<LineForm>& forms) {
    std::stable_sort(places.begin(), places.end(),
                     [](const LineMarkPlace& a, const LineMarkPlace& b) { return a.worth > b.worth; });
    std::vector<LineMarkPlace> best;
    const auto middle = [&](const LineMarkPlace& place) {
        const int half = forms[place.form].box / 2;
        return place.corner + cv::Point(half, half);
    };
    for (const LineMarkPlace& place : places)
        if (std::none_of(best.begin(), best.end(), [&](const LineMarkPlace& other) {
                const cv::Point off = middle(place) - middle(other);
                return std::hypot(off.x, off.y) < (forms[place.form].size + forms[other.form].size) / 2.0;
            }))
            best.push_back(place);
    return best;
}

// Ticks across an axis, as those of a number line, stand in a row that is level or upright, and are no points. With the axis they
// are upright crosses, of which three are enough.
void leave_out_ticks(std::vector<LineMarkPlace>& places, MarkForm shape) {
    const std::ptrdiff_t least = shape == MarkForm::plus ? 3 : 4;
    const std::vector<LineMarkPlace> all = places;
    std::erase_if(places, [&](const LineMarkPlace& place) {
        const auto in_row = [&](auto at) {
            return std::count_if(all.begin(), all.end(),
                                 [&](const LineMarkPlace& other) { return std::abs(at(other.corner) - at(place.corner)) <= 1; });
        };
        return std::max(in_row([](cv::Point p) { return p.x; }), in_row([](cv::Point p) { return p.y; })) >= least;
    });
}

MarkKind kind_like(const LineForm& form, const PixelColour& colour) {
    MarkKind kind{colour, form.shape,          form.box, form.box,           form.size / 2.0 + 1, 1, true,
                  true,   steps_to(form.line), {},       steps_to(form.hull)};
    kind.around = steps_to(form.within);
    kind.around.insert(kind.around.end(), kind.hull.begin(), kind.hull.end());
    return kind;
}

}  // namespace

std::vector<MarkKind> kinds_on_lines(const Image& picture, const Image& ink, double least, double most) {
    constexpr int kSizeStep = 2;
    constexpr std::size_t kFewest = 5;        // alike: what lines and letters make together is so now and then
    constexpr std::size_t kFewestWithin = 8;  // pixels, or it does not show what is a line and what is not
    constexpr std::size_t kMostFound = 20000;
    constexpr double kSameSize = 2;  // pixels
    if (most < least) return {};
    const cv::Mat black = view_of(ink) < kInkOfMarks;
    const cv::Mat near = spread(black, 1);
    cv::Mat deep;
    cv::distanceTransform(black, deep, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    std::vector<cv::Point> inked;
    const cv::Mat tried = without_long_lines(black, static_cast<int>(2 * most));
    if (cv::countNonZero(tried) == 0) return {};
    cv::findNonZero(tried, inked);
    std::vector<LineForm> forms;
    for (const auto& [shape, strokes] : line_shapes())
        for (int size = static_cast<int>(std::ceil(least)); size <= most; size += kSizeStep)
            if (LineForm form = form_of(shape, strokes, size); form.within.size() >= kFewestWithin)
                forms.push_back(std::move(form));
    std::vector<LineMarkPlace> places;
    for (std::size_t f = 0; f < forms.size(); ++f) {
        const cv::Rect corners(0, 0, black.cols - forms[f].box + 1, black.rows - forms[f].box + 1);
        for (const cv::Point& at : inked) {
            const cv::Point corner = at - forms[f].line.front();
            if (!corners.contains(corner)) continue;
            if (const auto depth = depth_at(forms[f], corner, black, near, deep))
                places.push_back({f, corner, *depth + 0.01 * forms[f].size, pixel_colour(picture, at.x, at.y)});
            if (places.size() > kMostFound) return {};
        }
    }
    std::vector<std::vector<LineMarkPlace>> groups;
    for (const LineMarkPlace& place : best_of(std::move(places), forms)) {
        const auto same = std::find_if(groups.begin(), groups.end(), [&](const std::vector<LineMarkPlace>& group) {
            const LineForm &own = forms[place.form], &other = forms[group.front().form];
            return own.shape == other.shape && std::abs(own.size - other.size) <= kSameSize &&
                   channels_apart(place.colour, group.front().colour) <= 2 * kMarkColour;
        });
        if (same != groups.end())
            same->push_back(place);
        else
            groups.push_back({place});
    }
    std::vector<MarkKind> kinds;
    for (auto& group : groups) {
        const LineForm& form = forms[group.front().form];
        const PixelColour colour = group.front().colour;
        leave_out_ticks(group, form.shape);
        if (group.size() >= kFewest) kinds.push_back(kind_like(form, colour));
    }
    return kinds;
}

}  // namespace tactics
