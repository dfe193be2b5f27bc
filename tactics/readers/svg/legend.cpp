// SPDX-License-Identifier: Apache-2.0
// A legend says by colour and kind of line which curve is which. On paper that is felt all colours are black, so its words go to
// the things themselves, as a transcriber sets them.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "tactics/geometry/course.h"
#include "tactics/layout/bar_names.h"
#include "tactics/readers/svg/chart_parts.h"
#include "tactics/readers/svg/legend_fills.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

// Of a sample, in heights of the capitals beside it. Settings: Matplotlib's line is 2.8 wide and 1.1 from the words, gnuplot's 5;
// the boxes of ggplot2 are 2.7 high.
constexpr double kLeastWide = 0.8, kMostWide = 7, kMostHigh = 3.2, kMostAway = 4, kInLine = 0.8;
constexpr double kNextRow = 5, kNextColumn = 30;  // from a sample to the next one
constexpr std::size_t kMostLooks = 3000;          // a chart has some hundreds; with more a search would take long
constexpr std::size_t kMostPlaces = 60;           // of a curve at which its name is tried
constexpr std::size_t kMostTries = 100'000'000;   // of places beside sides; with more the legend stays as it is drawn

struct Entry {
    std::size_t words, sample;
    double away;  // mm between them
};

bool is_line(const FoundLook& look) { return look.fill < 0 && look.strokes_end > look.stroke; }

bool alike(const FoundLook& a, const FoundLook& b) {
    if (is_line(a) != is_line(b)) return false;
    if (is_line(a)) return a.line == b.line && a.dashes == b.dashes;
    return a.fill == b.fill;
}

enum class SampleSide { left, right };

// How far it stands on that side of its words, in line with them. Nothing: it does not.
std::optional<double> beside(const Rect& sample, const FoundWords& words, SampleSide side) {
    const double h = words.height, left = words.middle.x - words.width / 2, right = words.middle.x + words.width / 2;
    if (words.upwards || !(h > 0) || std::abs(sample.middle().y - words.middle.y) > kInLine * h) return std::nullopt;
    if (sample.width < kLeastWide * h || sample.width > kMostWide * h || sample.height > kMostHigh * h) return std::nullopt;
    const double away = side == SampleSide::left ? left - (sample.left + sample.width) : sample.left - right;
    // The width of words that are text is a guess.
    return away > -h && away < kMostAway * h ? std::optional(away) : std::nullopt;
}

double away_from(Point p, const std::vector<Point>& points, bool closed) {
    double least = std::numeric_limits<double>::max();
    const std::size_t sides = points.size() - (closed || points.size() < 2 ? 0 : 1);
    for (std::size_t i = 0; i < sides; ++i)
        least = std::min(least, distance_to_segment(p, points[i], points[(i + 1) % points.size()]));
    return least;
}

class Legend {
public:
    explicit Legend(FoundPage& figure) : figure_(figure), page_(figure.page) {
        for (const FoundLook& look : figure.looks) boxes_.push_back(box_of(figure, look));
    }

    void run() {
        find_entries();
        if (entries_.size() < 2) return;  // a scale bar, say, or the only pond of a map
        if (entries_.size() * kMostPlaces > kMostTries / (points() + 1)) return;
        std::vector<Phrase> told;
        for (const Entry& entry : entries_) {
            FoundWords& words = figure_.words[entry.words];
            words.thing = place_for(entry);
            told.push_back(phrase("\"{0}\"", beginning_of(words.text)));
        }
        std::vector<std::size_t> samples;
        for (const Entry& entry : entries_) samples.push_back(entry.sample);
        fill_as_legend(figure_, samples);
        leave_out_frame();
        for (const Entry& entry : entries_) take_sample(boxes_[entry.sample], figure_.words[entry.words].height);
        figure_.notes.push_back(
            phrase("of its legend these words {0} each name what is drawn as their sample, and stand there", row_of(told)));
    }

private:
    bool is_sample(std::size_t look) const {
        return std::any_of(entries_.begin(), entries_.end(), [&](const Entry& entry) { return entry.sample == look; });
    }

    // All samples of a legend stand on the same side of their words: in a row one may be as near to those before it.
    void find_entries() {
        std::vector<Entry> left = entries_on(SampleSide::left), right = entries_on(SampleSide::right), all = left;
        all.insert(all.end(), right.begin(), right.end());
        left = aligned(with_sample_like_axes(unlike_others(left, all), left));
        right = aligned(with_sample_like_axes(unlike_others(right, all), right));
        const auto away = [](const std::vector<Entry>& some) {
            return std::accumulate(some.begin(), some.end(), 0.0, [](double sum, const Entry& one) { return sum + one.away; });
        };
        const bool more_left = left.size() > right.size() || (left.size() == right.size() && away(left) <= away(right));
        entries_ = more_left ? std::move(left) : std::move(right);
    }

    std::vector<Entry> entries_on(SampleSide side) const {
        std::vector<std::size_t> downwards;
        for (std::size_t w = 0; w < figure_.words.size(); ++w)
            if (std::isfinite(figure_.words[w].middle.y)) downwards.push_back(w);
        const auto level = [&](std::size_t word) { return figure_.words[word].middle.y; };
        std::sort(downwards.begin(), downwards.end(),
                  [&](std::size_t a, std::size_t b) { return std::pair(level(a), a) < std::pair(level(b), b); });
        double highest = 0;
        for (const FoundWords& one : figure_.words) highest = std::max(highest, one.height);
        std::vector<Entry> entries;
        for (std::size_t i = 0; i < boxes_.size(); ++i) {
            std::optional<Entry> nearest;
            const double y = boxes_[i].middle().y;
            const auto first = std::partition_point(downwards.begin(), downwards.end(),
                                                    [&](std::size_t w) { return level(w) < y - kInLine * highest; });
            for (auto w = first; w != downwards.end() && level(*w) <= y + kInLine * highest; ++w)
                if (const auto away = beside(boxes_[i], figure_.words[*w], side); away && (!nearest || *away < nearest->away))
                    nearest = Entry{*w, i, *away};
            if (nearest && is_sample_of_something(i)) entries.push_back(*nearest);
        }
        return entries;
    }

    // Ticks beside numbers look alike; the samples of a legend do not. A sample that is drawn twice is one.
    std::vector<Entry> unlike_others(const std::vector<Entry>& entries, const std::vector<Entry>& all) const {
        std::vector<Entry> unique;
        for (const Entry& entry : entries) {
            const bool common = std::any_of(all.begin(), all.end(), [&](const Entry& other) {
                return other.words != entry.words && other.sample != entry.sample &&
                       alike(figure_.looks[entry.sample], figure_.looks[other.sample]);
            });
            const bool twice =
                std::any_of(unique.begin(), unique.end(), [&](const Entry& other) { return other.words == entry.words; });
            if (!common && !twice) unique.push_back(entry);
        }
        return unique;
    }

    // Samples of a legend stand below each other, or side by side.
    bool are_in_line(const Entry& one, const Entry& other) const {
        const double h = figure_.words[one.words].height;
        const Point a = boxes_[one.sample].middle(), b = boxes_[other.sample].middle();
        const double across = std::abs(a.x - b.x), down = std::abs(a.y - b.y);
        return one.words != other.words &&
               ((across < kInLine * h && down < kNextRow * h) || (down < kInLine * h && across < kNextColumn * h));
    }

    std::vector<Entry> aligned(const std::vector<Entry>& entries) const {
        std::vector<Entry> aligned;
        for (const Entry& entry : entries)
            if (std::any_of(entries.begin(), entries.end(), [&](const Entry& other) { return are_in_line(entry, other); }))
                aligned.push_back(entry);
        return aligned;
    }

    // A whole black line looks like the axes and their ticks. It is a sample if it stands in line with those that are, and is as
    // long as they are, and the only one.
    std::vector<Entry> with_sample_like_axes(std::vector<Entry> entries, const std::vector<Entry>& all) const {
        constexpr double kAsLong = 0.1;
        std::vector<Entry> fitting;
        for (const Entry& one : all) {
            const FoundLook& look = figure_.looks[one.sample];
            if (!is_line(look) || look.dashes > 0) continue;
            const bool fits = std::any_of(entries.begin(), entries.end(), [&](const Entry& known) {
                const double wide = boxes_[known.sample].width;
                return are_in_line(one, known) && is_line(figure_.looks[known.sample]) &&
                       std::abs(boxes_[one.sample].width - wide) < kAsLong * wide;
            });
            const bool known =
                std::any_of(entries.begin(), entries.end(), [&](const Entry& other) { return other.words == one.words; });
            if (fits && !known && curve_like(one)) fitting.push_back(one);
        }
        if (fitting.size() == 1) entries.push_back(fitting.front());
        return entries;
    }

    // Something else is painted so, and is larger.
    bool is_sample_of_something(std::size_t sample) const {
        const auto size = [&](std::size_t i) { return std::hypot(boxes_[i].width, boxes_[i].height); };
        for (std::size_t i = 0; i < boxes_.size(); ++i)
            if (i != sample && alike(figure_.looks[i], figure_.looks[sample]) && size(i) > 1.5 * size(sample)) return true;
        return false;
    }

    std::size_t points() const {
        std::size_t count = 0;
        for (const PageStroke& stroke : page_.strokes) count += stroke.points.size();
        return count;
    }

    // As a curve does somewhere, and no axis.
    bool leans(std::size_t look) const {
        constexpr double kLeans = 0.3;  // mm
        for (std::size_t s = figure_.looks[look].stroke; s < figure_.looks[look].strokes_end; ++s) {
            const auto& points = page_.strokes[s].points;
            for (std::size_t i = 1; i < points.size(); ++i)
                if (std::abs(points[i].x - points[i - 1].x) > kLeans && std::abs(points[i].y - points[i - 1].y) > kLeans)
                    return true;
        }
        return false;
    }

    double extent_of(std::size_t look) const {
        constexpr double kOfAxis = 1e-6;
        const double size = boxes_[look].width * boxes_[look].height + 1e-3 * boxes_[look].width;
        return is_line(figure_.looks[look]) && !leans(look) ? kOfAxis * size : size;
    }

    // The largest that looks like the sample: of bars that is the tallest, where its colour is seen best. The sample itself:
    // there is none.
    std::size_t largest_like(const Entry& entry) const {
        std::size_t best = entry.sample;
        double most = 0;
        for (std::size_t i = 0; i < boxes_.size(); ++i)
            if (!is_sample(i) && i != entry.sample && alike(figure_.looks[i], figure_.looks[entry.sample]))
                if (const double size = extent_of(i); size > most) {
                    most = size;
                    best = i;
                }
        return best;
    }

    // Of all that looks like it there is one curve, which is wider than it.
    std::optional<std::size_t> curve_like(const Entry& entry) const {
        std::optional<std::size_t> curve;
        for (std::size_t i = 0; i < boxes_.size(); ++i) {
            if (i == entry.sample || !alike(figure_.looks[i], figure_.looks[entry.sample]) || !leans(i) ||
                boxes_[i].width < 2 * boxes_[entry.sample].width)
                continue;
            if (curve) return std::nullopt;
            curve = i;
        }
        return curve;
    }

    Point place_for(const Entry& entry) const {
        const std::size_t best = largest_like(entry);
        return is_line(figure_.looks[entry.sample]) ? clearest_on(figure_.looks[best]) : place_on_surface(boxes_[best]);
    }

    Point place_on_surface(const Rect& surface) const {
        constexpr double kRoomOfWords = 19;  // mm of a figure that is 200 mm wide or high
        const Point middle = surface.middle();
        if (figure_.bars)
            for (const ChartBar& bar : figure_.bars->bars)
                if (bar.box.holds(middle))
                    return place_of_bar_name(*figure_.bars, bar.look, page_.width, page_.height, kRoomOfWords);
        return middle;
    }

    // Where all else is farthest: nobody is to take it for the name of another.
    Point clearest_on(const FoundLook& curve) const {
        std::vector<Point> places;
        for (std::size_t s = curve.stroke; s < curve.strokes_end; ++s) {
            const auto& points = page_.strokes[s].points;
            for (std::size_t i = 0; i + 1 < points.size(); ++i) {
                places.push_back({(points[i].x + points[i + 1].x) / 2, (points[i].y + points[i + 1].y) / 2});
                if (points.size() < 6)  // long straight sides have places along them
                    for (const double t : {0.1, 0.3, 0.7, 0.9})
                        places.push_back({points[i].x + t * (points[i + 1].x - points[i].x),
                                          points[i].y + t * (points[i + 1].y - points[i].y)});
            }
        }
        Point best = places.empty() ? Point{} : places.front();
        double most = -1;
        const std::size_t step = places.size() / kMostPlaces + 1;
        for (std::size_t i = step / 2; i < places.size(); i += step) {
            double least = std::numeric_limits<double>::max();
            for (std::size_t s = 0; s < page_.strokes.size(); ++s)
                if ((s < curve.stroke || s >= curve.strokes_end) && !page_.strokes[s].points.empty())
                    least = std::min(least, away_from(places[i], page_.strokes[s].points, page_.strokes[s].closed));
            for (const Entry& entry : entries_)
                if (const auto& thing = figure_.words[entry.words].thing) least = std::min(least, distance(*thing, places[i]));
            if (least > most) {
                most = least;
                best = places[i];
            }
        }
        return best;
    }

    void take_away(const FoundLook& look) {
        for (std::size_t i = look.stroke; i < look.strokes_end; ++i) page_.strokes[i].points.clear();
        for (std::size_t i = look.area; i < look.areas_end; ++i) page_.areas[i].rings.clear();
    }

    // With the mark on it, and the line around it.
    void take_sample(const Rect& sample, double room) {
        for (std::size_t i = 0; i < boxes_.size(); ++i) {
            const Rect& box = boxes_[i];
            const bool within = box.left > sample.left - room / 2 &&
                                box.left + box.width < sample.left + sample.width + room / 2 && box.top > sample.top - room &&
                                box.top + box.height < sample.top + sample.height + room;
            if (within) take_away(figure_.looks[i]);
        }
    }

    // The smallest box around all entries, if it is around nothing else that says something.
    void leave_out_frame() {
        const auto within = [](const Rect& box, Point p) {
            return p.x > box.left && p.x < box.left + box.width && p.y > box.top && p.y < box.top + box.height;
        };
        for (std::size_t i = 0; i < boxes_.size(); ++i) {
            const Rect& box = boxes_[i];
            std::size_t inside = 0, words = 0;
            for (const FoundWords& one : figure_.words) words += within(box, one.middle) ? 1 : 0;
            for (const Entry& entry : entries_)
                inside += within(box, figure_.words[entry.words].middle) && within(box, boxes_[entry.sample].middle()) ? 1 : 0;
            if (inside < entries_.size() || words > inside + 1) continue;  // it may have a heading
            if (figure_.bars && within(box, figure_.bars->bars[0].box.middle())) continue;
            // Curves of the chart have it around their legend, too: they are wider than its words.
            double right = 0, left = std::numeric_limits<double>::max();
            for (const Entry& entry : entries_) {
                const FoundWords& one = figure_.words[entry.words];
                left = std::min({left, one.middle.x - one.width / 2, boxes_[entry.sample].left});
                right = std::max({right, one.middle.x + one.width / 2, boxes_[entry.sample].left + boxes_[entry.sample].width});
            }
            if (box.width < 1.6 * (right - left)) take_away(figure_.looks[i]);
        }
    }

    FoundPage& figure_;
    Page& page_;
    std::vector<Rect> boxes_;  // of each look
    std::vector<Entry> entries_;
};

}  // namespace

void name_by_legend(FoundPage& figure) {
    if (figure.looks.size() <= kMostLooks && !figure.words.empty()) Legend(figure).run();
}

}  // namespace tactics
