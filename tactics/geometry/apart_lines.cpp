// SPDX-License-Identifier: Apache-2.0
#include "tactics/geometry/apart_lines.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>

#include "tactics/geometry/box.h"
#include "tactics/geometry/course.h"
#include "tactics/geometry/places.h"

namespace tactics {

namespace {

constexpr double kMeeting = 0.2;   // mm: so near, lines are drawn to meet
constexpr double kExcused = 2;     // times `apart`: so far from where they meet, lines may be near
constexpr double kLooksApart = 6;  // looks at a line for each `apart`
// More places would be lines side by side over all of the largest paper.
constexpr std::size_t kMostPlaces = 2'000'000;

struct Sample {
    Point at;
    double along = 0;  // mm from the beginning
};

std::vector<Sample> samples_of(const Stroke& stroke, double step) {
    std::vector<Sample> samples;
    double along = 0;
    const std::size_t n = stroke.points.size(), sides = stroke.closed ? n : n - 1;
    for (std::size_t i = 0; i < sides; ++i) {
        const Point a = stroke.points[i], b = stroke.points[(i + 1) % n];
        const double side = distance(a, b);
        const auto cuts = std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(side / step)));
        for (std::size_t k = 0; k < cuts; ++k) {
            const double t = static_cast<double>(k) / static_cast<double>(cuts);
            samples.push_back({{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}, along + t * side});
        }
        along += side;
    }
    if (!stroke.closed) samples.push_back({stroke.points.back(), along});
    return samples;
}

// A line to and fro or in circles, narrower than `apart`, feels like a line along its middle.
Stroke slimmed(const Stroke& stroke, double apart) {
    std::size_t longest = 0;
    const std::size_t n = stroke.points.size();
    if (n < 3) return stroke;
    const auto side = [&](std::size_t i) { return distance(stroke.points[i], stroke.points[(i + 1) % n]); };
    for (std::size_t i = 1; i < (stroke.closed ? n : n - 1); ++i)
        if (side(i) > side(longest) * (1 + 1e-9)) longest = i;
    const double length = side(longest);
    if (!(length > 0)) return stroke;
    const Point from = stroke.points[longest], to = stroke.points[(longest + 1) % n];
    const Point along{(to.x - from.x) / length, (to.y - from.y) / length};
    Box box = kNothing;  // along and across that side
    for (const Point& p : stroke.points)
        box.take({(p.x - from.x) * along.x + (p.y - from.y) * along.y, (p.y - from.y) * along.x - (p.x - from.x) * along.y});
    if (box.height() >= apart) return stroke;
    const double across = (box.top + box.bottom) / 2;
    const auto at = [&](double x) {
        return Point{from.x + x * along.x - across * along.y, from.y + x * along.y + across * along.x};
    };
    Stroke line = stroke;
    line.points = {at(box.left), at(box.right)};
    line.closed = false;
    return line;
}

class Choosing {
public:
    Choosing(const Box& area, double apart, double shortest)
        : taken_(grown(area, 1), apart), apart_(apart), shortest_(shortest) {}

    std::vector<Stroke> take(const Stroke& stroke) {
        std::vector<Stroke> kept;
        const std::vector<Sample> samples = samples_of(stroke, apart_ / kLooksApart);
        if (taken_.size() + samples.size() > kMostPlaces) return kept;
        const std::vector<char> near = near_others(samples, stroke.closed);
        for (Stroke& piece : pieces_of(stroke, samples, near))
            if (length_of(piece) >= shortest_) kept.push_back(std::move(piece));
        for (const Stroke& piece : kept)
            for (const Sample& one : samples_of(piece, apart_ / kLooksApart)) taken_.add(one.at);
        return kept;
    }

private:
    // Near what was taken, but not where they meet; or near where the line itself went before.
    std::vector<char> near_others(const std::vector<Sample>& samples, bool closed) const {
        std::vector<Sample> meetings;
        for (const Sample& one : samples)
            if (taken_.any_near(one.at, kMeeting, [&](std::size_t other) { return distance(taken_[other], one.at) < kMeeting; }))
                meetings.push_back(one);
        // A line that is on another all along does not meet it.
        const bool same = meetings.size() * 2 > samples.size();
        const double length = samples.back().along, excused = kExcused * apart_;
        const auto apart_along = [&](double a, double b) {
            const double off = std::abs(a - b);
            return closed ? std::min(off, length - off) : off;
        };
        Places own(box_of(samples), apart_);
        std::vector<std::size_t> owner;
        std::vector<char> near(samples.size(), 0);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const Point at = samples[i].at;
            const auto meets = [&](Point other) {
                return !same && std::any_of(meetings.begin(), meetings.end(), [&](const Sample& one) {
                    return apart_along(one.along, samples[i].along) <= excused && distance(one.at, other) <= excused;
                });
            };
            const bool others = taken_.any_near(at, apart_, [&](std::size_t other) {
                return distance(taken_[other], at) < apart_ * (1 - 1e-6) && !meets(taken_[other]);
            });
            const bool itself = own.any_near(at, apart_, [&](std::size_t other) {
                return distance(own[other], at) < apart_ * (1 - 1e-6) &&
                       apart_along(samples[owner[other]].along, samples[i].along) > 2.5 * apart_;
            });
            near[i] = others || itself ? 1 : 0;
            if (near[i] != 0) continue;
            own.add(at);
            owner.push_back(i);
        }
        return near;
    }

    static Box box_of(const std::vector<Sample>& samples) {
        Box box = kNothing;
        for (const Sample& one : samples) box.take(one.at);
        return box;
    }

    static std::vector<Stroke> pieces_of(const Stroke& stroke, const std::vector<Sample>& samples,
                                         const std::vector<char>& near) {
        if (std::none_of(near.begin(), near.end(), [](char one) { return one != 0; })) return {stroke};
        std::vector<Stroke> pieces;
        std::vector<Point> run;
        const auto finish = [&] {
            if (run.size() > 1) {
                Stroke& piece = pieces.emplace_back(stroke);
                piece.closed = false;
                piece.points = course_of(run, 1e-6);
            }
            run.clear();
        };
        // Of a closed line from behind a gap, all round.
        std::size_t begin = 0;
        if (stroke.closed)
            begin = static_cast<std::size_t>(std::find_if(near.begin(), near.end(), [](char one) { return one != 0; }) -
                                             near.begin());
        for (std::size_t k = 0; k < samples.size(); ++k) {
            const std::size_t i = (begin + k) % samples.size();
            if (near[i] != 0)
                finish();
            else
                run.push_back(samples[i].at);
        }
        finish();
        return pieces;
    }

    Places taken_;
    double apart_, shortest_;
};

}  // namespace

std::vector<Stroke> apart_lines(std::vector<Stroke> strokes, double apart, double shortest) {
    Box area = kNothing;
    for (Stroke& stroke : strokes) {
        stroke = slimmed(stroke, apart);
        for (const Point& p : stroke.points) area.take(p);
    }
    const auto rank = [](const Stroke& stroke) {
        return std::tuple(-static_cast<int>(stroke.line), -std::round(length_of(stroke) * 1000));
    };
    std::stable_sort(strokes.begin(), strokes.end(), [&](const Stroke& a, const Stroke& b) { return rank(a) < rank(b); });
    Choosing choosing(area, apart, shortest);
    std::vector<Stroke> kept;
    for (const Stroke& stroke : strokes)
        for (Stroke& piece : choosing.take(stroke)) kept.push_back(std::move(piece));
    return kept;
}

}  // namespace tactics
