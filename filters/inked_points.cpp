// SPDX-License-Identifier: Apache-2.0
#include "filters/inked_points.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "filters/opencv.h"

namespace tactics {

namespace {

constexpr int kInkOfPoints = 160;
constexpr double kLeastRadius = 1.8;          // pixels; smaller discs are ends of lines
constexpr double kArm = 0.55;                 // of its width; a crossing of lines is 1.2 times as wide as they are
constexpr double kSmall = 3, kThinArm = 0.4;  // pixels; of its width: a line on a slope is now and then a pixel wider
constexpr int kAround = 48;                   // places on a circle that are looked at
constexpr std::size_t kMostPoints = 20000;    // candidates; more is a pattern

bool is_ink(const cv::Mat& deep, Point p) {
    const int x = static_cast<int>(std::floor(p.x)), y = static_cast<int>(std::floor(p.y));
    return x >= 0 && y >= 0 && x < deep.cols && y < deep.rows && deep.at<float>(y, x) > 0;
}

Point on_circle(Point middle, double radius, double turn) {
    return {middle.x + radius * std::cos(turn), middle.y + radius * std::sin(turn)};
}

constexpr double turn_of(int step) { return 2 * std::numbers::pi * step / kAround; }

// Runs of ink on a circle around it, as the turns of their middles; nothing if one is too wide for a line that a disc is on.
std::optional<std::vector<double>> arms_of(const cv::Mat& deep, Point middle, double radius) {
    const double beyond = radius + 1.5;
    bool ink[kAround];
    int first = -1;
    for (int i = 0; i < kAround; ++i) {
        ink[i] = is_ink(deep, on_circle(middle, beyond, turn_of(i)));
        if (!ink[i]) first = i;
    }
    if (first < 0) return std::nullopt;
    std::vector<double> arms;
    int run = 0;
    for (int k = 1; k <= kAround; ++k) {
        const int i = (first + k) % kAround;
        if (ink[i]) {
            ++run;
            continue;
        }
        if (run > 0) {
            if (turn_of(run) * beyond > (radius < kSmall ? kThinArm : kArm) * 2 * radius) return std::nullopt;
            arms.push_back(turn_of(first + k) - turn_of(run + 1) / 2);
        }
        run = 0;
    }
    return arms;
}

bool are_across(double a, double b) { return std::cos(a - b) < -0.9; }

// A triangle has three corners, and a head of an arrow a line besides.
bool are_lines(const std::vector<double>& arms) {
    if (arms.size() < 3) return true;
    return arms.size() == 4 && are_across(arms[0], arms[2]) && are_across(arms[1], arms[3]);
}

std::optional<InkedPoint> point_at(const cv::Mat& deep, int x, int y, double radius) {
    // The middle of all that is as deep.
    double sx = 0, sy = 0, n = 0;
    const int reach = static_cast<int>(std::ceil(radius / 2));
    for (int v = std::max(0, y - reach); v <= std::min(deep.rows - 1, y + reach); ++v)
        for (int u = std::max(0, x - reach); u <= std::min(deep.cols - 1, x + reach); ++u)
            if (static_cast<double>(deep.at<float>(v, u)) > radius - 0.8) {
                sx += u + 0.5;
                sy += v + 0.5;
                ++n;
            }
    InkedPoint point{{sx / n, sy / n}, radius, {}};
    for (int i = 0; i < kAround; ++i)
        if (!is_ink(deep, on_circle(point.middle, radius - 0.9, turn_of(i)))) return std::nullopt;
    const auto arms = arms_of(deep, point.middle, radius);
    if (!arms || !are_lines(*arms)) return std::nullopt;
    for (const double turn : *arms) point.arms.push_back(on_circle(point.middle, radius + 1.5, turn));
    return point;
}

}  // namespace

std::vector<InkedPoint> points_in(const Image& ink, double least, double most) {
    least = std::max(least, kLeastRadius);
    cv::Mat deep, highest;
    cv::distanceTransform(view_of(ink) < kInkOfPoints, deep, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    cv::dilate(deep, highest, cv::Mat());  // of 3 x 3
    struct Candidate {
        double radius;
        int x, y;
    };
    std::vector<Candidate> candidates;
    for (int y = 0; y < deep.rows; ++y)
        for (int x = 0; x < deep.cols; ++x) {
            const auto radius = static_cast<double>(deep.at<float>(y, x));
            if (radius >= least && radius <= most && deep.at<float>(y, x) >= highest.at<float>(y, x))
                candidates.push_back({radius, x, y});
        }
    if (candidates.size() > kMostPoints) return {};
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.radius > b.radius; });
    std::vector<InkedPoint> points;
    for (const Candidate& one : candidates) {
        const auto point = point_at(deep, one.x, one.y, one.radius);
        if (point && std::none_of(points.begin(), points.end(), [&](const InkedPoint& other) {
                return distance(other.middle, point->middle) < other.radius + point->radius;
            }))
            points.push_back(*point);
    }
    return points;
}

void take_out(Image& picture, const std::vector<InkedPoint>& points) {
    cv::Mat pixels = view_of(picture);
    const auto colour_at = [&](Point p) { return colour_near(picture, pixel_of(p)); };
    for (const InkedPoint& point : points) {
        // The lightest or the darkest beside it is ink; what most places have is ground.
        std::vector<std::pair<double, Point>> beside;
        const double out = point.radius + 2.5;
        for (int i = 0; i < kAround; ++i) {
            const Point at = on_circle(point.middle, out, turn_of(i));
            const cv::Scalar colour = colour_at(at);
            beside.emplace_back(colour[0] + colour[1] + colour[2], at);
        }
        std::nth_element(beside.begin(), beside.begin() + kAround / 2, beside.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
        const cv::Scalar ground = colour_at(beside[kAround / 2].second), own = colour_at(point.middle);
        cv::circle(pixels, pixel_of(point.middle), static_cast<int>(std::ceil(point.radius + 1)), ground, cv::FILLED);
        for (const Point& arm : point.arms) cv::line(pixels, pixel_of(point.middle), pixel_of(arm), own, 1);
    }
}

}  // namespace tactics
