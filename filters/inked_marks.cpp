// SPDX-License-Identifier: Apache-2.0
// Marks that stand alone show what the kinds are. Each kind is then looked for wherever there is ink of its colour, where marks
// overlap and on lines.
#include "filters/inked_marks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <span>
#include <utility>

#include "filters/darken.h"
#include "filters/key_samples.h"
#include "filters/lab.h"
#include "filters/mark_forms.h"
#include "filters/mark_kinds.h"
#include "filters/opencv.h"
#include "filters/runs_around.h"

namespace tactics {

namespace {

constexpr std::size_t kMostPlaces = 200000;

struct MarkPlace {
    std::size_t kind = 0;
    cv::Point corner;  // of the kind's box in the picture
    double worth = 0;
};

cv::Point operator+(cv::Point corner, PixelStep step) { return {corner.x + step.x, corner.y + step.y}; }

// Where ink is, and whose colour it has.
struct Inks {
    cv::Mat any, deep;                         // deep: how far each of its pixels is from the ground
    std::vector<cv::Mat> of_kind, other_kind;  // of another's colour, which may hide it
    std::vector<cv::Mat> near_of_kind;
};

Inks inks_of(const Image& picture, const Image& ink, const std::vector<MarkKind>& kinds) {
    constexpr double kLeastShare = 0.4, kRest = kMarkColour;
    const PixelColour ground = ground_of(picture);
    Inks inks;
    inks.any = view_of(ink) < kInkOfMarks;
    cv::distanceTransform(inks.any, inks.deep, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    for (std::size_t k = 0; k < kinds.size(); ++k) inks.of_kind.push_back(cv::Mat::zeros(inks.any.size(), CV_8U));
    for (int y = 0; y < ink.height; ++y)
        for (int x = 0; x < ink.width; ++x) {
            if (inks.any.at<std::uint8_t>(y, x) == 0) continue;
            const PixelColour pixel = pixel_colour(picture, x, y);
            for (std::size_t k = 0; k < kinds.size(); ++k)
                if (const auto [share, rest] = share_of_ink(pixel, ground, kinds[k].colour);
                    share >= kLeastShare && rest <= kRest)
                    inks.of_kind[k].at<std::uint8_t>(y, x) = 255;
        }
    for (std::size_t k = 0; k < kinds.size(); ++k) {
        cv::Mat others = cv::Mat::zeros(inks.any.size(), CV_8U);
        for (std::size_t j = 0; j < kinds.size(); ++j)
            if (channels_apart(kinds[j].colour, kinds[k].colour) > kMarkColour) others |= inks.of_kind[j];
        inks.other_kind.push_back(others & ~inks.of_kind[k]);
        inks.near_of_kind.push_back(kinds[k].thin ? spread(inks.of_kind[k], 1) : inks.of_kind[k]);
    }
    return inks;
}

// Nothing if too much of it is missing there, or if it is in something thicker; else the share of what is around it that is no
// ink, less what is missing or hidden. Of two that are as free, as a disc within a square is, the larger one explains more.
std::optional<double> worth_at(const Inks& inks, const MarkKind& kind, std::size_t k, cv::Point corner) {
    constexpr double kMissing = 0.08, kHidden = 0.5, kLarger = 0.01, kThicker = 1.7;
    const cv::Mat &own = inks.near_of_kind[k], &other = inks.other_kind[k];
    const cv::Rect box(corner, cv::Size(kind.width, kind.height));
    if ((box & cv::Rect(0, 0, own.cols, own.rows)) != box) return std::nullopt;
    const auto all = static_cast<double>(kind.body.size());
    int missing = 0, hidden = 0;
    for (const PixelStep step : kind.body) {
        const cv::Point at = corner + step;
        if (own.at<std::uint8_t>(at) != 0) {
            if (!kind.thin && static_cast<double>(inks.deep.at<float>(at)) > kThicker * kind.depth) return std::nullopt;
            continue;
        }
        if (other.at<std::uint8_t>(at) != 0)
            ++hidden;
        else if (++missing > kMissing * all)
            return std::nullopt;
    }
    if (hidden > kHidden * all) return std::nullopt;
    const auto inked = std::count_if(kind.around.begin(), kind.around.end(),
                                     [&](PixelStep step) { return inks.any.at<std::uint8_t>(corner + step) != 0; });
    const double beside = static_cast<double>(inked) / static_cast<double>(std::max<std::size_t>(1, kind.around.size()));
    return 1 - beside / 2 - missing / all - hidden / all / 2 + kLarger * kind.radius;
}

cv::Point anchor_of(const MarkKind& kind) {
    const PixelStep step = kind.body[kind.body.size() / 2];
    return {step.x, step.y};
}

// Where each may be, the worthiest first. Of places beside each other only the best.
std::vector<MarkPlace> places_of(const Inks& inks, const std::vector<MarkKind>& kinds) {
    std::vector<MarkPlace> places;
    for (std::size_t k = 0; k < kinds.size(); ++k) {
        const cv::Mat& own = inks.near_of_kind[k];
        const cv::Point anchor = anchor_of(kinds[k]);
        cv::Mat worth = cv::Mat::zeros(own.size(), CV_32F);
        std::vector<MarkPlace> all;
        for (int y = 0; y < own.rows; ++y)
            for (int x = 0; x < own.cols; ++x) {
                if (own.at<std::uint8_t>(y, x) == 0) continue;
                const cv::Point corner = cv::Point(x, y) - anchor;
                const auto found = worth_at(inks, kinds[k], k, corner);
                if (!found) continue;
                worth.at<float>(y, x) = static_cast<float>(*found);
                all.push_back({k, corner, *found});
            }
        for (const MarkPlace& place : all) {
            const cv::Point at = place.corner + anchor;
            double highest = 0;
            cv::minMaxLoc(worth(cv::Rect(at.x - 1, at.y - 1, 3, 3) & cv::Rect(0, 0, own.cols, own.rows)), nullptr, &highest);
            if (place.worth >= highest - 1e-6) places.push_back(place);
        }
        if (places.size() > kMostPlaces) return {};
    }
    std::stable_sort(places.begin(), places.end(), [](const MarkPlace& a, const MarkPlace& b) { return a.worth > b.worth; });
    return places;
}

// Which places are taken, and what ink that explains.
class ChosenPlaces {
public:
    ChosenPlaces(const Inks& inks, const std::vector<MarkKind>& kinds) : inks_(inks), kinds_(kinds) {
        seen_ = cv::Mat::zeros(inks.any.size(), CV_8U);
    }

    // So much of its ink is no other's. Lines hide hardly any of each other.
    bool is_new(const MarkPlace& place) const {
        constexpr double kNew = 0.2, kNewLines = 0.6;
        const MarkKind& kind = kinds_[place.kind];
        const auto fresh = std::count_if(kind.body.begin(), kind.body.end(),
                                         [&](PixelStep step) { return seen_.at<std::uint8_t>(place.corner + step) == 0; });
        return static_cast<double>(fresh) >= (kind.thin ? kNewLines : kNew) * static_cast<double>(kind.body.size());
    }

    // Lines that leave it, as their middles; nothing if more leave it than a mark on lines has.
    std::optional<std::vector<cv::Point>> arms_of(const MarkPlace& place) const {
        constexpr double kWidest = 0.6;  // of its size
        const MarkKind& kind = kinds_[place.kind];
        const std::size_t n = kind.hull.size();
        const auto at = [&](std::size_t i) { return place.corner + kind.hull[i % n]; };
        const auto is_ink = [&](std::size_t i) {
            return cv::Rect(0, 0, seen_.cols, seen_.rows).contains(at(i)) && inks_.any.at<std::uint8_t>(at(i)) != 0 &&
                   seen_.at<std::uint8_t>(at(i)) == 0;
        };
        const auto runs = runs_around(n, is_ink);
        if (!runs) return std::nullopt;
        std::vector<cv::Point> arms;
        for (const RunAround& run : *runs) {
            if (static_cast<double>(run.length) > kWidest * 2 * kind.radius) return std::nullopt;
            arms.push_back(at(run.middle));
        }
        if (arms.size() > (kind.thin ? 2 : 4)) return std::nullopt;
        return arms;
    }

    void take(const MarkPlace& place) {
        taken.push_back(place);
        const cv::Rect all(0, 0, seen_.cols, seen_.rows);
        for (const PixelStep step : kinds_[place.kind].body)
            seen_(cv::Rect(place.corner + step - cv::Point(1, 1), cv::Size(3, 3)) & all) = 255;
    }

    const cv::Mat& seen() const { return seen_; }

    std::vector<MarkPlace> taken;

private:
    const Inks& inks_;
    const std::vector<MarkKind>& kinds_;
    cv::Mat seen_;
};

// Of filled marks on lines all are taken first, as what is beside one is explained by the next; then those that do not stand free
// go, which may bare others.
void take_those_that_stand_free(std::vector<MarkPlace> tried, const Inks& inks, const std::vector<MarkKind>& kinds,
                                ChosenPlaces& choice) {
    for (std::size_t before = tried.size() + 1; before != tried.size();) {
        before = tried.size();
        ChosenPlaces all(inks, kinds);
        for (const MarkPlace& place : tried) all.take(place);
        std::erase_if(tried, [&](const MarkPlace& place) { return !all.arms_of(place); });
    }
    for (const MarkPlace& place : tried) choice.take(place);
}

Point middle_of(cv::Point at) { return {at.x + 0.5, at.y + 0.5}; }

InkedMark mark_at(const MarkPlace& place, const MarkKind& kind, std::size_t number) {
    InkedMark mark{number, {}, {}, {}};
    for (const PixelStep step : kind.hull) mark.hull.push_back(middle_of(place.corner + step));
    const Box box = box_of(mark.hull);
    mark.middle = {(box.left + box.right) / 2, (box.top + box.bottom) / 2};
    return mark;
}

// What is left of a piece of ink, clear of the borders of its marks, is a line: it leads from one of them to another that is
// apart from it, or is longer than what one leaves of another that it lies over.
bool is_any_line(const cv::Mat& left, cv::Point corner, std::span<const MarkPlace> marks, const std::vector<MarkKind>& kinds) {
    constexpr double kShort = 1.2, kLong = 3;  // radii
    if (marks.empty()) return true;
    cv::Mat labels, stats, middles;
    const int count = cv::connectedComponentsWithStats(left, labels, stats, middles, 8, CV_32S);
    const double radius = kinds[marks.front().kind].radius;
    std::vector<Point> places;
    for (const MarkPlace& mark : marks) places.push_back(mark_at(mark, kinds[mark.kind], 0).middle);
    const auto nearest = [&](cv::Point at) {
        const Point p = middle_of(at + corner);
        return *std::min_element(places.begin(), places.end(),
                                 [p](const Point& a, const Point& b) { return distance(a, p) < distance(b, p); });
    };
    for (int i = 1; i < count; ++i) {
        const double length = std::hypot(stats.at<int>(i, cv::CC_STAT_WIDTH), stats.at<int>(i, cv::CC_STAT_HEIGHT));
        if (length <= kShort * radius) continue;
        const bool level = stats.at<int>(i, cv::CC_STAT_WIDTH) > stats.at<int>(i, cv::CC_STAT_HEIGHT);
        std::vector<cv::Point> own;
        cv::findNonZero(labels == i, own);
        const auto [first, last] = std::minmax_element(
            own.begin(), own.end(), [level](cv::Point p, cv::Point q) { return level ? p.x < q.x : p.y < q.y; });
        if (length > kLong * radius || distance(nearest(*first), nearest(*last)) > 2 * radius) return true;
    }
    return false;
}

// Pieces of ink that are marks and nothing else are known by that, however the marks overlap; on lines each mark must stand free.
// `rest` gets the ink of such pieces.
ChosenPlaces choose_places(const Inks& inks, const std::vector<MarkKind>& kinds, const std::vector<MarkPlace>& places,
                           cv::Mat& rest) {
    constexpr double kAll = 0.85;        // of the ink of a piece
    constexpr double kOverlapped = 0.6;  // worth of one that others lie over
    cv::Mat labels, stats, middles;
    const int count = cv::connectedComponentsWithStats(inks.any, labels, stats, middles, 8, CV_32S);
    std::vector<std::vector<MarkPlace>> of_piece(static_cast<std::size_t>(count));
    for (const MarkPlace& place : places)
        of_piece[static_cast<std::size_t>(labels.at<int>(place.corner + anchor_of(kinds[place.kind])))].push_back(place);
    ChosenPlaces choice(inks, kinds), trial(inks, kinds);
    std::vector<MarkPlace> on_lines, tried;
    rest = cv::Mat::zeros(inks.any.size(), CV_8U);
    for (int i = 1; i < count; ++i) {
        const auto& own = of_piece[static_cast<std::size_t>(i)];
        if (own.empty()) continue;
        const std::size_t before = trial.taken.size();
        for (const MarkPlace& place : own)
            if (!kinds[place.kind].joined && place.worth >= kOverlapped && trial.is_new(place)) trial.take(place);
        const cv::Rect box = box_of_piece(stats, i);
        const cv::Mat piece = labels(box) == i;
        if (cv::countNonZero(piece & trial.seen()(box)) >= kAll * stats.at<int>(i, cv::CC_STAT_AREA) &&
            !is_any_line(piece & ~spread(trial.seen()(box), 1), box.tl(), std::span(trial.taken).subspan(before), kinds)) {
            for (const MarkPlace& place : std::span(trial.taken).subspan(before)) choice.take(place);
            cv::Mat(rest(box)).setTo(255, piece);
            continue;
        }
        std::copy_if(trial.taken.begin() + static_cast<std::ptrdiff_t>(before), trial.taken.end(), std::back_inserter(tried),
                     [&](const MarkPlace& place) { return !kinds[place.kind].thin; });
        on_lines.insert(on_lines.end(), own.begin(), own.end());
    }
    take_those_that_stand_free(std::move(tried), inks, kinds, choice);
    // What one explains may free another.
    for (std::size_t before = ~std::size_t{0}; before != choice.taken.size();) {
        before = choice.taken.size();
        for (const MarkPlace& place : on_lines)
            if (choice.is_new(place) && choice.arms_of(place)) choice.take(place);
    }
    return choice;
}

// Lines and dashes beside the marks. A dash ends at a mark, another line goes on through it: it leads to another mark, or is
// long, or nothing follows it, as in a legend.
class ArmInk {
public:
    explicit ArmInk(const cv::Mat& ink) {
        cv::Mat middles;
        cv::connectedComponentsWithStats(ink, labels_, stats_, middles, 8, CV_32S);
    }
    int number_at(cv::Point at) const { return labels_.at<int>(at); }

    bool goes_through(cv::Point at, Point middle, double radius) const {
        constexpr double kLong = 3, kFollows = 1.2;  // times the size of a mark
        const int label = number_at(at);
        if (label == 0) return false;
        const int wide = stats_.at<int>(label, cv::CC_STAT_WIDTH), high = stats_.at<int>(label, cv::CC_STAT_HEIGHT);
        if (std::hypot(wide, high) >= kLong * 2 * radius) return true;
        const cv::Point own(stats_.at<int>(label, cv::CC_STAT_LEFT) + wide / 2,
                            stats_.at<int>(label, cv::CC_STAT_TOP) + high / 2),
            end = own * 2 - at;
        const int reach = static_cast<int>(kFollows * 2 * radius);
        const cv::Rect box =
            cv::Rect(end.x - reach, end.y - reach, 2 * reach, 2 * reach) & cv::Rect(0, 0, labels_.cols, labels_.rows);
        for (int y = box.y; y < box.br().y; ++y)
            for (int x = box.x; x < box.br().x; ++x) {
                const bool beyond = distance(middle, middle_of({x, y})) > distance(middle, middle_of(end));
                if (beyond && labels_.at<int>(y, x) != 0 && labels_.at<int>(y, x) != label) return false;
            }
        return true;
    }

private:
    cv::Mat labels_, stats_;
};

// Triangles that a line leaves from the middle of the side across from their tip are heads of arrows.
bool are_heads(const MarkKind& kind, std::size_t number, const ChosenPlaces& choice) {
    constexpr double kStraightBack = 0.9, kMost = 0.4;  // cosine of 26 degrees; of those that lines leave
    if (kind.shape != MarkForm::triangle && kind.shape != MarkForm::open_triangle) return false;
    Point mean{0, 0};
    for (const PixelStep step : kind.body)
        mean = {mean.x + (step.x + 0.5) / static_cast<double>(kind.body.size()),
                mean.y + (step.y + 0.5) / static_cast<double>(kind.body.size())};
    int joined = 0, heads = 0;
    for (const MarkPlace& place : choice.taken) {
        if (place.kind != number) continue;
        const auto arms = choice.arms_of(place);
        if (!arms || arms->empty()) continue;
        ++joined;
        const Point middle = mark_at(place, kind, 0).middle,
                    back{place.corner.x + mean.x - middle.x, place.corner.y + mean.y - middle.y};
        heads += std::any_of(arms->begin(), arms->end(), [&](const cv::Point& arm) {
            const Point way{arm.x + 0.5 - middle.x, arm.y + 0.5 - middle.y};
            return (way.x * back.x + way.y * back.y) >= kStraightBack * std::hypot(way.x, way.y) * std::hypot(back.x, back.y);
        });
    }
    return heads > kMost * joined;
}

}  // namespace

InkedMarks without_print(InkedMarks marks, const std::vector<Box>& print) {
    const auto is_print = [&](Point p) {
        return std::any_of(print.begin(), print.end(), [&](const Box& box) { return box.holds(p); });
    };
    std::vector<int> weight(marks.symbols.size(), 0);  // of each kind, marks beside print less those in it
    for (const InkedMark& mark : marks.marks) weight[mark.kind] += is_print(mark.middle) ? -1 : 1;
    if (std::none_of(weight.begin(), weight.end(), [](int one) { return one < 0; })) return marks;
    std::erase_if(marks.marks, [&](const InkedMark& mark) { return weight[mark.kind] < 0; });
    std::erase_if(marks.rest, [&](const Run& run) { return is_print({(run.begin + run.end) / 2.0, run.row + 0.5}); });
    return marks;
}

InkedMarks inked_marks_in(const Image& picture, const Image& ink, double least, double most) {
    const std::vector<MarkKind> kinds = mark_kinds_in(picture, ink, least, most);
    if (kinds.empty()) return {};
    const Inks inks = inks_of(picture, ink, kinds);
    cv::Mat rest;
    const ChosenPlaces choice = choose_places(inks, kinds, places_of(inks, kinds), rest);
    InkedMarks found;
    std::vector<MarkForm> shapes;
    std::vector<std::optional<std::size_t>> number(kinds.size());
    for (std::size_t k = 0; k < kinds.size(); ++k) {
        const auto count =
            std::count_if(choice.taken.begin(), choice.taken.end(), [k](const MarkPlace& place) { return place.kind == k; });
        if (static_cast<std::size_t>(count) < kFewestMarks || are_heads(kinds[k], k, choice)) continue;
        number[k] = shapes.size();
        shapes.push_back(kinds[k].shape);
        found.radii.push_back(kinds[k].radius);
    }
    found.symbols = symbols_for(shapes);
    const ArmInk arm_ink(inks.any & ~choice.seen());
    std::vector<std::vector<cv::Point>> arms;
    std::map<int, int> marks_at;  // of a line, by its number
    for (const MarkPlace& place : choice.taken) {
        if (!number[place.kind]) continue;
        found.marks.push_back(mark_at(place, kinds[place.kind], *number[place.kind]));
        arms.push_back(choice.arms_of(place).value_or(std::vector<cv::Point>{}));
        for (const cv::Point& arm : arms.back()) ++marks_at[arm_ink.number_at(arm)];
    }
    for (std::size_t i = 0; i < found.marks.size(); ++i)
        for (const cv::Point& arm : arms[i]) {
            InkedMark& mark = found.marks[i];
            if (marks_at[arm_ink.number_at(arm)] > 1 || arm_ink.goes_through(arm, mark.middle, found.radii[mark.kind]))
                mark.arms.push_back(middle_of(arm));
        }
    found.rest = find_components(rest.cols, rest.rows, Joined::by_corners, [&](std::size_t i) { return rest.data[i] != 0; }).runs;
    return found;
}

}  // namespace tactics
