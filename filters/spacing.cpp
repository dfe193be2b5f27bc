// SPDX-License-Identifier: Apache-2.0
#include "filters/spacing.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "tactics/geometry/box.h"
#include "tactics/geometry/evidence.h"
#include "tactics/geometry/places.h"
#include "tactics/geometry/walk.h"

namespace tactics {

namespace {

// Distances are taken between samples this part of the gap apart along the lines; that makes them right to 0.4 %.
constexpr double kStepsPerGap = 8;
// An end this near to a line, in gaps, touches it: a third of 3.2 mm is a line's width.
constexpr double kTouches = 1.0 / 3;
// A line that ends on another may be within the gap for at most so many gaps: it comes in at 30 degrees or more.
constexpr double kMeeting = 2;
// Two parts of one line are a bend while the way along it is at most so many times the distance across (a corner of 29
// degrees); beyond that they run back beside each other.
constexpr double kBend = 4;
constexpr double kOfSteps = 1e-6;  // mm: a line that is kept whole is as long as it was

struct Sample {
    Point at;
    double along;       // mm from the stroke's first point
    std::size_t owner;  // index of the piece that was kept, or that it will have
    double from_end;    // mm to the nearer end of that piece; endless if it is closed
    Point end;          // that end
};

// Samples of all that is drawn so far.
class Drawn {
public:
    Drawn(double width, double height, double gap) : places_({0, 0, width, height}, gap), gap_(gap) {}

    void add(const Sample& sample) {
        places_.add(sample.at);
        samples_.push_back(sample);
    }
    std::size_t size() const { return samples_.size(); }
    // Takes back what was added last.
    void shrink(std::size_t size) {
        places_.shrink(size);
        samples_.resize(size);
    }
    // Calls `visit` with the index and the sample of all that may lie within the gap.
    template <typename Visit>
    void near(Point at, Visit visit) const {
        places_.any_near(at, gap_, [&](std::size_t i) {
            visit(i, samples_[i]);
            return false;
        });
    }

private:
    Places places_;
    std::vector<Sample> samples_;
    double gap_;
};

// A closed stroke starts where it is farthest from its middle: at the tip, if it is the outline of a thin bar, so that one
// whole side of it comes first.
void start_at_tip(Stroke& stroke) {
    Point middle;
    for (const Point& p : stroke.points) middle = {middle.x + p.x, middle.y + p.y};
    const auto n = static_cast<double>(stroke.points.size());
    middle = {middle.x / n, middle.y / n};
    const auto tip = std::max_element(stroke.points.begin(), stroke.points.end(),
                                      [middle](Point a, Point b) { return distance(a, middle) < distance(b, middle); });
    std::rotate(stroke.points.begin(), tip, stroke.points.end());
}

// Samples at even steps, the last point of an open stroke included.
std::vector<Sample> samples_of(const Stroke& stroke, double step, std::size_t owner) {
    const double length = length_of(stroke);
    const auto steps = std::max<std::size_t>(2, static_cast<std::size_t>(std::ceil(length / step)));
    std::vector<Sample> samples;
    samples.reserve(steps + 1);
    Walk walk(stroke.points, stroke.closed);
    for (std::size_t i = 0; i < steps + (stroke.closed ? 0 : 1); ++i) {
        const double along = length * static_cast<double>(i) / static_cast<double>(steps);
        samples.push_back({walk.to(along), along, owner, kNowhere, {}});
    }
    return samples;
}

struct NearRun {
    std::size_t begin, end;  // samples; end is behind the last and may lie beyond a closed stroke's last sample
};

// That part of a stroke, with the stroke's own points between the two samples at its ends.
Stroke piece_of(const Stroke& stroke, const std::vector<Sample>& samples, NearRun run) {
    const std::size_t n = samples.size();
    const Sample &from = samples[run.begin % n], &to = samples[(run.end - 1) % n];
    const double length = length_of(stroke);
    const double begin = from.along + (run.begin >= n ? length : 0), end = to.along + (run.end - 1 >= n ? length : 0);
    Stroke piece{{from.at}, false, stroke.line, stroke.strength};
    for (double lap = 0; lap < (end > length ? 2 : 1); ++lap) {
        double along = lap * length;
        for (std::size_t i = 0; i < stroke.points.size(); ++i) {
            if (i > 0) along += distance(stroke.points[i - 1], stroke.points[i]);
            if (along > begin + 1e-9 && along < end - 1e-9) piece.points.push_back(stroke.points[i]);
        }
    }
    if (end > begin) piece.points.push_back(to.at);
    return piece;
}

class Spacer {
public:
    Spacer(Drawing& drawing, double gap, double shortest)
        : drawing_(drawing), gap_(gap), shortest_(shortest), drawn_(drawing.width, drawing.height, gap) {}

    void run() {
        std::vector<Stroke> kept;
        const std::vector<bool> between = lie_between_lines();
        for (const std::size_t i : by_evidence(drawing_.strokes)) {
            const double length = length_of(drawing_.strokes[i]);
            if (length < (between[i] ? kShareBetween : 1) * shortest_) continue;
            place(std::move(drawing_.strokes[i]), kept, between[i] ? length - kOfSteps : shortest_);
        }
        for (std::size_t i = 0; i < kept.size(); ++i)
            if (!kept[i].closed) {
                meet(kept[i].points, kept[i].points.back(), i, false);
                meet(kept[i].points, kept[i].points.front(), i, true);
            }
        drawing_.strokes = std::move(kept);
    }

private:
    // An end that touches another line is led onto it: a finger takes a hair's breadth of white for an end. One that passes is
    // better than one that ends there, too.
    void meet(std::vector<Point>& points, Point end, std::size_t owner, bool in_front) const {
        Point nearest = end;
        double least = kTouches * gap_;
        bool passes = false;
        drawn_.near(end, [&](std::size_t, const Sample& s) {
            const double away = distance(s.at, end);
            const bool is_passing = s.from_end > gap_;
            if (s.owner == owner || away >= kTouches * gap_ || (is_passing == passes ? away >= least : passes)) return;
            least = away;
            passes = is_passing;
            nearest = s.at;
        });
        constexpr double kThere = 1e-3;  // mm
        if (distance(nearest, end) > kThere) points.insert(in_front ? points.begin() : points.end(), nearest);
    }

    // Short lines that lead from one line to another, as whiskers and ticks do.
    std::vector<bool> lie_between_lines() const {
        const auto is_short = [&](const Stroke& stroke) {
            return !stroke.closed && length_of(stroke) < shortest_ && length_of(stroke) >= kShareBetween * shortest_;
        };
        const std::vector<Stroke>& strokes = drawing_.strokes;
        std::vector<bool> between(strokes.size(), false);
        if (std::none_of(strokes.begin(), strokes.end(), is_short)) return between;
        Drawn all(drawing_.width, drawing_.height, gap_);
        for (std::size_t i = 0; i < strokes.size(); ++i)
            for (const Sample& sample : samples_of(strokes[i], gap_ / kStepsPerGap, i)) all.add(sample);
        for (std::size_t i = 0; i < strokes.size(); ++i) {
            const auto touches = [&](Point end) {
                bool found = false;
                all.near(end, [&](std::size_t, const Sample& s) {
                    found = found || (s.owner != i && distance(s.at, end) <= kTouches * gap_);
                });
                return found;
            };
            between[i] = is_short(strokes[i]) && touches(strokes[i].points.front()) && touches(strokes[i].points.back());
        }
        return between;
    }

    // Pieces shorter than `shortest` are left out.
    void place(Stroke stroke, std::vector<Stroke>& kept, double shortest) {
        if (stroke.closed) start_at_tip(stroke);
        const auto samples = samples_of(stroke, gap_ / kStepsPerGap, kept.size());
        const double begun_on = along_where_begun(stroke, samples);
        const std::size_t n = samples.size(), before = drawn_.size();
        const double length = stroke.closed ? length_of(stroke) : 0;
        std::vector<double> apart(n, gap_);  // from what is drawn already; the gap if that is far
        std::vector<bool> own(n, false);     // and it is the stroke's own earlier part
        for (std::size_t i = 0; i < n; ++i) {
            double others = gap_, earlier = gap_;
            drawn_.near(samples[i].at, [&](std::size_t index, const Sample& s) {
                const double across = distance(samples[i].at, s.at);
                if (index < before) {
                    others = std::min(others, across);
                    return;
                }
                double way = samples[i].along - s.along;
                if (s.along <= kMeeting * gap_ && std::abs(samples[i].along - begun_on) <= kMeeting * gap_) return;
                if (stroke.closed) way = std::min(way, length - way);
                if (way > kBend * across) earlier = std::min(earlier, across);
            });
            own[i] = others >= gap_ && earlier < gap_;
            apart[i] = std::min(others, earlier);
            if (apart[i] >= gap_) drawn_.add(samples[i]);
        }
        drawn_.shrink(before);
        if (!stroke.closed) {
            allow_meeting(samples, own, apart, false);
            allow_meeting(samples, own, apart, true);
        }
        allow_being_met(samples, own, apart);
        widen_cuts(stroke.closed, samples, apart);
        auto runs = clear_runs(stroke.closed, apart);
        std::stable_sort(runs.begin(), runs.end(), [](NearRun a, NearRun b) { return a.end - a.begin > b.end - b.begin; });
        // The longest piece is drawn; the others are lines of their own now and must keep clear of it too.
        for (std::size_t i = 0; i < runs.size(); ++i) {
            if (static_cast<double>(runs[i].end - runs[i].begin) * gap_ / kStepsPerGap < shortest)
                continue;  // steps are no longer
            Stroke piece = runs[i].end - runs[i].begin == n ? stroke : piece_of(stroke, samples, runs[i]);
            if (piece.points.size() < 2 || length_of(piece) < shortest) continue;
            if (i > 0) {
                place(std::move(piece), kept, shortest);
                continue;
            }
            for (std::size_t k = runs[i].begin; k < runs[i].end; ++k)
                drawn_.add(drawn_as(piece, samples[k % n], k - runs[i].begin, runs[i].end - 1 - k));
            kept.push_back(std::move(piece));
        }
    }

    // How far along itself a stroke passes where it began; its end, which comes last, may meet it in any case. Endless if it does
    // not.
    double along_where_begun(const Stroke& stroke, const std::vector<Sample>& samples) const {
        double nearest = kTouches * gap_, along = kNowhere;
        for (const Sample& s : samples) {
            const double across = distance(s.at, samples.front().at);
            if (stroke.closed || across > nearest || s.along <= std::max(gap_, kBend * across)) continue;
            nearest = across;
            along = s.along;
        }
        return along;
    }

    // A run of samples within the gap at an end of the stroke, not long, that reaches what it is near to: a meeting with
    // another line or lines, or with the stroke itself, as in a 6 or a 9. It comes near to nothing that it does not reach.
    void allow_meeting(const std::vector<Sample>& samples, const std::vector<bool>& own, std::vector<double>& apart,
                       bool at_end) const {
        const std::size_t n = apart.size();
        const auto index = [n, at_end](std::size_t i) { return at_end ? n - 1 - i : i; };
        const std::size_t first = end_of_meeting(samples, apart, index);
        if (first == n || apart[index(first)] > kTouches * gap_) return;
        const Sample& end = samples[index(first)];
        std::size_t behind = first;
        while (behind < n && apart[index(behind)] < gap_ && own[index(behind)] == own[index(first)]) ++behind;
        if (behind == n || apart[index(behind)] < gap_ || std::abs(samples[index(behind)].along - end.along) > kMeeting * gap_)
            return;
        std::vector<std::size_t> reached;
        drawn_.near(end.at, [&](std::size_t, const Sample& s) {
            if (distance(s.at, end.at) <= kTouches * gap_) reached.push_back(s.owner);
        });
        bool clear = true;
        for (std::size_t i = first; i < behind && clear; ++i)
            drawn_.near(samples[index(i)].at, [&](std::size_t, const Sample& s) {
                if (distance(s.at, samples[index(i)].at) < gap_ &&
                    std::find(reached.begin(), reached.end(), s.owner) == reached.end())
                    clear = false;
            });
        if (!clear) return;
        for (std::size_t i = 0; i < behind; ++i) apart[index(i)] = i < first ? 0 : gap_;
    }

    // Where the stroke ends; but if it crosses another so near its end that the piece beyond would be left out, it ends there:
    // an axis ends on the other one, not on the far side of it. All samples if nothing is near to it.
    template <typename Index>
    std::size_t end_of_meeting(const std::vector<Sample>& samples, const std::vector<double>& apart, const Index& index) const {
        const std::size_t n = apart.size();
        std::size_t begin = 0;
        while (begin < n && apart[index(begin)] >= gap_) ++begin;
        if (begin == n || (begin == 0 && apart[index(0)] <= kTouches * gap_)) return begin;
        if (std::abs(samples[index(begin)].along - samples[index(0)].along) >= shortest_) return n;
        std::size_t nearest = begin;
        for (std::size_t i = begin; i < n && apart[index(i)] < gap_; ++i)
            if (apart[index(i)] < apart[index(nearest)]) nearest = i;
        return nearest;
    }

    // The sample as one of a piece that is drawn, so many steps from its first and from its last.
    Sample drawn_as(const Stroke& piece, Sample sample, std::size_t from_first, std::size_t to_last) const {
        if (piece.closed) return sample;
        sample.from_end = static_cast<double>(std::min(from_first, to_last)) * gap_ / kStepsPerGap;
        sample.end = from_first < to_last ? piece.points.front() : piece.points.back();
        return sample;
    }

    // A run of samples that is near to nothing but ends of lines which reach it, such as sides of a bar that stand on an axis.
    void allow_being_met(const std::vector<Sample>& samples, const std::vector<bool>& own, std::vector<double>& apart) const {
        for (std::size_t first = 0, end = 0; first < samples.size(); first = end + 1) {
            for (end = first; end < samples.size() && apart[end] < gap_;) ++end;
            bool met = true;
            for (std::size_t k = first; k < end && met; ++k) {
                met = !own[k];
                drawn_.near(samples[k].at, [&](std::size_t, const Sample& s) {
                    if (distance(s.at, samples[k].at) < gap_)
                        met = met && s.from_end <= kMeeting * gap_ && reach(samples, first, end, s.end);
                });
            }
            for (std::size_t k = first; k < end && met; ++k) apart[k] = gap_;
        }
    }

    bool reach(const std::vector<Sample>& samples, std::size_t first, std::size_t end, Point place) const {
        for (std::size_t k = first; k < end; ++k)
            if (distance(samples[k].at, place) <= kTouches * gap_) return true;
        return false;
    }

    // Where a line only touches the gap of another for a moment, the cut is made as wide as the gap: two ends are no nearer
    // to each other than two lines.
    void widen_cuts(bool closed, const std::vector<Sample>& samples, std::vector<double>& apart) const {
        const std::size_t n = samples.size();
        const std::vector<double> found = apart;
        const auto blocked = [&](std::size_t i) { return found[i % n] < gap_; };
        for (std::size_t i = 0; i < n; ++i) {
            if (!blocked(i) || (i == 0 && !closed) || blocked(i + n - 1)) continue;
            std::size_t before = i + n - 1, after = i + n;  // both counted from one lap before
            while (after < i + 2 * n && blocked(after)) ++after;
            while (after - before < n && distance(samples[before % n].at, samples[after % n].at) < gap_) {
                if (!closed && (before <= n || after + 1 >= 2 * n)) break;
                apart[before-- % n] = 0;
                apart[after++ % n] = 0;
            }
        }
    }

    std::vector<NearRun> clear_runs(bool closed, const std::vector<double>& apart) const {
        const std::size_t n = apart.size();
        const auto blocked = [&](std::size_t i) { return apart[i % n] < gap_; };
        std::size_t start = 0;
        if (closed) {
            while (start < n && !blocked(start)) ++start;
            if (start == n) return {{0, n}};
        }
        std::vector<NearRun> runs;
        for (std::size_t i = start; i < start + n;) {
            if (blocked(i)) {
                ++i;
                continue;
            }
            const std::size_t begin = i;
            while (i < start + n && !blocked(i)) ++i;
            runs.push_back({begin, i});
        }
        return runs;
    }

    Drawing& drawing_;
    double gap_;
    double shortest_;
    Drawn drawn_;
};

}  // namespace

void keep_apart(Drawing& drawing, double gap, double shortest) { Spacer(drawing, gap, shortest).run(); }

}  // namespace tactics
