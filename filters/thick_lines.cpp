// SPDX-License-Identifier: Apache-2.0
#include "filters/thick_lines.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "filters/darken.h"
#include "filters/edge_map.h"
#include "filters/opencv.h"
#include "filters/paths.h"
#include "filters/pixel_graph.h"

namespace tactics {

namespace {

// Grey levels between a stroke and what is beside it: pale ones are fills.
constexpr float kStroke = 90, kStrokeFadesTo = 45;
constexpr double kStrokeLonger = 5;   // times the width: a finger follows it, and a bar is a bar
constexpr double kEven = 0.2;         // of its width, or a pixel: AA at both sides
constexpr double kMostlyEven = 0.75;  // of its length; crossings are wider
constexpr double kTurnsBack = 1.6;    // where a stroke turns back it is as wide as two
constexpr int kSameInk = 24;          // grey levels
constexpr std::size_t kFewSteps = 8;

// Erosion and dilation by an octagon: the time hardly grows with its size.
cv::Mat spread_by(const cv::Mat& from, double radius, bool darker) {
    const int diamond = std::max(1, static_cast<int>(std::lround(0.586 * radius))),
              half = std::max(1, static_cast<int>(std::lround(radius)) - diamond);
    const cv::Mat square = cv::getStructuringElement(cv::MORPH_RECT, cv::Size(2 * half + 1, 2 * half + 1)),
                  cross = cv::getStructuringElement(cv::MORPH_CROSS, cv::Size(3, 3));
    cv::Mat to;
    const int way = darker ? cv::MORPH_ERODE : cv::MORPH_DILATE;
    cv::morphologyEx(from, to, way, square);
    cv::morphologyEx(to, to, way, cross, cv::Point(-1, -1), diamond);
    return to;
}

// How much darker each place is than what is around it, if it is narrower than twice the radius.
cv::Mat narrow_ink(const cv::Mat& ink, double radius) {
    cv::Mat hat;
    cv::subtract(spread_by(spread_by(ink, radius, false), radius, true), ink, hat);
    return hat;
}

// A part of a path that one pen drew.
struct BroadStroke {
    const PixelPath* path = nullptr;
    std::size_t begin = 0, end = 0;
    double width = 0;
};

cv::Point stroke_pixel(Point p) { return {static_cast<int>(p.x), static_cast<int>(p.y)}; }

class StrokeFinder {
public:
    StrokeFinder(const cv::Mat& ink, const EdgeMap& map) : ink_(ink) {
        mask_ = view_of(map) > 0;
        cv::distanceTransform(mask_, deep_, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    }

    double width_at(Point p) const { return 2 * static_cast<double>(deep_.at<float>(stroke_pixel(p))) - 1; }

    // A broad line may go on as a thin one: a curve along an axis.
    std::vector<BroadStroke> strokes_of(const PixelPath& path, PenWidths pens) const {
        std::vector<BroadStroke> strokes;
        const auto patience = static_cast<std::size_t>(pens.widest);  // steps that may be narrower
        const std::size_t n = path.points.size();
        for (std::size_t i = 0; i < n; ++i) {
            if (width_at(path.points[i]) < pens.narrowest) continue;
            std::size_t last = i;
            for (std::size_t k = i; k < n && k <= last + patience; ++k)
                if (width_at(path.points[k]) >= pens.narrowest) last = k;
            BroadStroke stroke{&path, i, last + 1, 0};
            if (is_of_one_pen(stroke, pens)) strokes.push_back(stroke);
            i = last;
        }
        return strokes;
    }

private:
    bool is_of_one_pen(BroadStroke& stroke, PenWidths pens) const {
        if (stroke.end - stroke.begin < kFewSteps) return false;
        std::vector<double> widths;
        for (std::size_t i = stroke.begin; i < stroke.end; ++i) widths.push_back(width_at(stroke.path->points[i]));
        const auto half = widths.begin() + static_cast<std::ptrdiff_t>(widths.size() / 2);
        std::nth_element(widths.begin(), half, widths.end());
        const double pen = stroke.width = *half, off = std::max(kEven * pen, 1.0);
        const auto size = static_cast<double>(widths.size());
        if (pen < pens.narrowest || pen > pens.widest || size < kStrokeLonger * pen) return false;
        const auto even = std::count_if(widths.begin(), widths.end(), [&](double width) { return std::abs(width - pen) <= off; });
        if (static_cast<double>(even) < kMostlyEven * size) return false;
        if (pens.bent_only && is_upright_or_level(stroke)) return false;
        return !comes_out(stroke, false) && !comes_out(stroke, true);
    }

    static bool is_upright_or_level(const BroadStroke& stroke) {
        double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
        for (std::size_t i = stroke.begin; i < stroke.end; ++i) {
            const Point p = stroke.path->points[i];
            left = std::min(left, p.x), right = std::max(right, p.x);
            top = std::min(top, p.y), bottom = std::max(bottom, p.y);
        }
        return std::min(right - left, bottom - top) < stroke.width;
    }

    // Out of a surface of the same ink: it is a part of that surface's outline.
    bool comes_out(const BroadStroke& stroke, bool last) const {
        const std::vector<Point>& points = stroke.path->points;
        // In a corner of the ink the middle line comes to its border.
        const auto corner = static_cast<std::size_t>(stroke.width);
        if (stroke.path->closed || (last ? stroke.end + corner < points.size() : stroke.begin > corner)) return false;
        const double pen = stroke.width;
        const std::size_t n = points.size(), back = std::min(n - 1, static_cast<std::size_t>(pen) + kFewSteps);
        const Point end = last ? points.back() : points.front(), from = last ? points[n - 1 - back] : points[back];
        const double way = distance(from, end);
        if (way <= 0) return false;
        const Point beyond{end.x + pen * (end.x - from.x) / way, end.y + pen * (end.y - from.y) / way};
        const cv::Point at = stroke_pixel(beyond);
        if (at.x < 0 || at.y < 0 || at.x >= ink_.cols || at.y >= ink_.rows || mask_.at<std::uint8_t>(at) != 0) return false;
        const int own = ink_.at<std::uint8_t>(stroke_pixel(points[(stroke.begin + stroke.end) / 2])),
                  there = ink_.at<std::uint8_t>(at);
        return std::abs(own - there) <= kSameInk;
    }

    cv::Mat ink_, mask_, deep_;
};

}  // namespace

void add_thick_lines(EdgeMap& edges, const Image& picture, PenWidths pens, double beside) {
    if (pens.widest < 2 || std::max(edges.width, edges.height) < 2 * kStrokeLonger * pens.widest) return;
    const Image ink = ink_on_white(picture);
    // In any channel: against white, yellow is nearly as deep an ink as the black border around it.
    const double radius = kTurnsBack * pens.widest / 2;
    cv::Mat hat = narrow_ink(view_of(ink), radius);
    if (picture.channels == 3)
        for (const Image& one : inks_on_white(picture)) hat = cv::max(hat, narrow_ink(view_of(one), radius));
    EdgeMap narrow{edges.width, edges.height, edges.mm_per_pixel, false, {}, {}, {}};
    narrow.strength.resize(edges.strength.size());
    cv::Mat strengths = view_of(narrow);
    hat.convertTo(strengths, CV_32F);
    narrow = keep_connected(std::move(narrow), kStrokeFadesTo, kStroke);
    const StrokeFinder finder(view_of(ink), narrow);
    Skeleton middles = thin(ink_of(narrow));
    const PixelGraph graph = graph_of(middles, pens.narrowest);
    const std::vector<PixelPath> paths = join_at_junctions(graph);
    std::vector<BroadStroke> found;
    for (const PixelPath& path : paths)
        for (const BroadStroke& stroke : finder.strokes_of(path, pens)) found.push_back(stroke);
    if (found.empty()) return;
    cv::Mat strength = view_of(edges), near = cv::Mat::zeros(edges.height, edges.width, CV_8U);
    // As strong as the edges that it stands for: what crosses it was as strong as these, or not.
    const cv::Mat before = strength.clone();
    std::vector<float> values;
    for (const BroadStroke& stroke : found) {
        cv::Mat own = cv::Mat::zeros(near.size(), CV_8U);
        for (std::size_t i = stroke.begin; i < stroke.end; ++i) {
            const Point p = stroke.path->points[i];
            cv::circle(own, stroke_pixel(p), static_cast<int>(std::ceil(std::max(finder.width_at(p), stroke.width) / 2 + beside)),
                       cv::Scalar(255), cv::FILLED);
        }
        near |= own;
        values.push_back(std::max(static_cast<float>(cv::mean(before, own & (before > 0))[0]), kStrokeFadesTo));
    }
    strength.setTo(0, near);
    const auto draw = [&](const PixelPath& path, std::size_t begin, std::size_t end, float value) {
        for (std::size_t i = begin; i + 1 < end || (path.closed && i < end); ++i) {
            const cv::Point a = stroke_pixel(path.points[i]), b = stroke_pixel(path.points[(i + 1) % path.points.size()]);
            if (near.at<std::uint8_t>(a) != 0 && near.at<std::uint8_t>(b) != 0)
                cv::line(strength, a, b, cv::Scalar(static_cast<double>(value)));
        }
    };
    const float weakest = *std::min_element(values.begin(), values.end());
    for (const PixelPath& path : paths) draw(path, 0, path.points.size(), weakest);
    for (std::size_t i = 0; i < found.size(); ++i) draw(*found[i].path, found[i].begin, found[i].end, values[i]);
}

}  // namespace tactics
