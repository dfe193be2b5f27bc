// SPDX-License-Identifier: Apache-2.0
#include "filters/known_parts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "filters/arrow_heads.h"
#include "filters/closed_gaps.h"
#include "filters/darken.h"
#include "filters/dash_rows.h"
#include "filters/dashed_whiskers.h"
#include "filters/error_bars.h"
#include "filters/inked_bars.h"
#include "filters/inked_fills.h"
#include "filters/inked_marks.h"
#include "filters/inked_points.h"
#include "filters/noisy_curves.h"
#include "filters/opencv.h"
#include "filters/pale_curves.h"
#include "filters/pale_fills.h"
#include "filters/pale_grid.h"
#include "filters/plot_symbols.h"
#include "filters/quieted.h"
#include "filters/tick_marks.h"
#include "tactics/layout/chart_told.h"
#include "tactics/layout/felt_bars.h"
#include "tactics/plot.h"
#include "tactics/text/phrase.h"

namespace tactics {

namespace {

// They say more than lines of their length: as strong as an edge can be.
constexpr float kStrength = 255;

// A barb is felt as a line from 6.4 mm on (media.inc, swell paper); longer ones would be lines of their own. 35 degrees off the
// line its end has 3.6 mm of it, and a corner of 29 degrees or more is no gap (rules/narrow.h).
constexpr double kLeastBarb = 6.4, kMostBarb = 10, kLeastTurn = 35, kMostTurn = 45;
constexpr double kLongestHead = 20;  // mm of a head as it is drawn
constexpr double kOnHead = 1.3;      // of its length: so far from its tip a line of dashes ends at it

Stroke head_of(const InkedHead& head, double mm) {
    const Point tip{head.tip.x * mm, head.tip.y * mm}, neck{head.neck.x * mm, head.neck.y * mm};
    const double length = std::clamp(head.length() * mm, kLeastBarb, kMostBarb),
                 half = distance(head.barbs[0], head.barbs[1]) / 2;
    const double degrees = std::asin(std::min(1.0, half / head.length())) * 180 / std::numbers::pi;
    const double turn = std::clamp(degrees, kLeastTurn, kMostTurn) * std::numbers::pi / 180, way = distance(tip, neck);
    const Point back{(neck.x - tip.x) / way, (neck.y - tip.y) / way};
    const auto barb = [&](double sign) {
        const double c = std::cos(turn), s = sign * std::sin(turn);
        return Point{tip.x + length * (back.x * c - back.y * s), tip.y + length * (back.x * s + back.y * c)};
    };
    return {{barb(1), tip, barb(-1)}, false, LineClass::normal, kStrength, Role::arrow};
}

// Dashes as drawing tools make them: on the page up to 11 mm long, 1.6 mm wide, with gaps of no more than 5.5 mm.
constexpr double kLongestDash = 11, kWidestDash = 1.6, kMostGap = 5.5;

// On paper dashes are 8 mm long with gaps of half of that (tactics/geometry/line_styles.h): what is shorter has one or two.
constexpr double kShortRow = 20;

DashLimits dash_limits(double mm) { return {kLongestDash / mm, std::max(2.0, kWidestDash / mm), kMostGap / mm}; }

// A point is as large as it is drawn, but as wide as two of the dots of braille, which it is not taken for then.
constexpr double kLeastPoint = 0.5, kMostPoint = 4.8, kFeltPoint = 1.6, kLeastDisc = 1;  // radius, mm
// Forms that say something by what they are: at 5 mm across they are told apart (rules/symbol_size.cpp), and a ring has a hole.
constexpr double kLeastForm = 1.5, kFeltForm = 2.5;
constexpr std::size_t kMostMeasured = 1000;

// Marks of a plot, from side to side: smaller ones do not show what they look like, larger ones are things of their own.
constexpr double kFewestPixels = 6, kLeastMark = 0.9, kMostMark = 9;  // pixels; mm

// Smaller where most of them are near others, so that more of them have room; the gap is that between any two things.
double felt_radius(const std::vector<Point>& points, double mm, double smallest, double largest) {
    constexpr double kGap = 3.4;
    std::vector<double> nearest;
    for (std::size_t i = 0; i < points.size() && i < kMostMeasured; ++i) {
        double least = 1e9;
        for (std::size_t j = 0; j < points.size() && j < kMostMeasured; ++j)
            if (i != j) least = std::min(least, distance(points[i], points[j]));
        nearest.push_back(least * mm);
    }
    if (nearest.empty()) return largest;
    const auto few = nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 4);
    std::nth_element(nearest.begin(), few, nearest.end());
    return std::clamp((*few - kGap) / 2, smallest, largest);
}

// With the paler pixels around them they get the colour of what is nearest to them. Other ink stays.
void paint_over(Image& picture, const Image& all_ink, const std::vector<Run>& ink) {
    cv::Mat own(picture.height, picture.width, CV_8U, cv::Scalar(255));
    for (const Run& run : ink) own(cv::Rect(run.begin, run.row, run.end - run.begin, 1)) = 0;
    const cv::Mat others = (view_of(all_ink) < 128) & own;
    cv::erode(own, own, cv::getStructuringElement(cv::MORPH_RECT, cv::Size(5, 5)));
    own |= others;
    cv::Mat away, label;
    cv::distanceTransform(255 - own, away, label, cv::DIST_L2, cv::DIST_MASK_5, cv::DIST_LABEL_PIXEL);
    std::vector<const std::uint8_t*> nearest(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height) +
                                             1);
    const Image before = picture;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            if (own.at<std::uint8_t>(y, x) != 0)
                nearest[static_cast<std::size_t>(label.at<int>(y, x))] = before.row(y) + x * picture.channels;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            if (const std::uint8_t* from = nearest[static_cast<std::size_t>(label.at<int>(y, x))];
                own.at<std::uint8_t>(y, x) == 0 && from != nullptr)
                std::copy_n(from, picture.channels, picture.row(y) + x * picture.channels);
}

// Two others at least are parallel to it and as long.
bool is_of_grid(const DashRow& row, const std::vector<DashRow>& rows) {
    const auto level = is_level(row);
    const double length = distance(row.points.front(), row.points.back());
    return level && std::count_if(rows.begin(), rows.end(), [&](const DashRow& other) {
                        return other.kind == row.kind && is_level(other) == level &&
                               std::abs(distance(other.points.front(), other.points.back()) - length) < 0.1 * length;
                    }) > 2;
}

// What the marks of a line are says something if another line has others.
bool tell_lines_apart(const std::vector<DashRow>& rows) {
    std::optional<DashKind> kind;
    for (const DashRow& row : rows) {
        if (is_of_grid(row, rows)) continue;
        if (kind && *kind != row.kind) return true;
        kind = row.kind;
    }
    return false;
}

// What is found in a picture when it is first asked for, and again only after the picture changed.
class KnownOfPicture {
public:
    explicit KnownOfPicture(const Image& picture) : picture_(picture) {}

    const Image& ink() {
        if (!ink_) ink_ = ink_on_white(picture_);
        return *ink_;
    }
    // Dashes of half a pixel are pale, but darker than the grids of plotting tools (b0b0b0).
    Image ink_of_dashes() {
        constexpr std::uint8_t kPalest = 0xb0;
        Image dashes = ink();
        for (std::uint8_t& sample : dashes.pixels) sample = sample < kPalest ? 0 : 255;
        return dashes;
    }
    const std::vector<DashRow>& rows() {
        if (!rows_) rows_ = dash_rows_in(ink_of_dashes(), picture_, dash_limits(picture_.mm_per_pixel), marks_);
        return *rows_;
    }
    void hide_under(std::vector<HidingMark> marks) { marks_ = std::move(marks); }
    // Which end on a head goes on to its tip: these are taken out together, the row later.
    void lead_to(std::vector<InkedHead>& heads) {
        rows();
        for (DashRow& row : *rows_)
            for (Point* const end : {&row.points.front(), &row.points.back()})
                for (InkedHead& head : heads)
                    if (distance(*end, head.tip) <= kOnHead * head.length()) {
                        *end = head.tip;
                        head.dashed = true;
                    }
        ink_.reset();
    }
    void forget() {
        ink_.reset();
        rows_.reset();
    }

private:
    const Image& picture_;
    std::vector<HidingMark> marks_;  // what was taken out of it
    std::optional<Image> ink_;
    std::optional<std::vector<DashRow>> rows_;
};

// Where one dash goes on behind another a step of pixels may look like a small head.
bool is_within_row(Point tip, const std::vector<DashRow>& rows) {
    return std::any_of(rows.begin(), rows.end(), [&](const DashRow& row) {
        for (std::size_t i = 2; i + 2 < row.points.size(); ++i)
            if (distance(row.points[i], tip) <= 2 * row.width + 1) return true;
        return false;
    });
}

void take_dashes(Image& picture, KnownOfPicture& known, KnownParts& parts) {
    if (known.rows().empty()) return;
    const Image ink = known.ink_of_dashes();
    const double mm = picture.mm_per_pixel;
    const std::vector<bool> is_whisker = whiskers_among(known.rows(), kShortRow / mm);
    std::vector<Run> ink_of_all;
    std::vector<DashRow> lines, whiskers;
    for (std::size_t i = 0; i < is_whisker.size(); ++i) {
        const DashRow& row = known.rows()[i];
        ink_of_all.insert(ink_of_all.end(), row.ink.begin(), row.ink.end());
        (is_whisker[i] ? whiskers : lines).push_back(row);
    }
    const bool told_apart = tell_lines_apart(lines);
    for (const DashRow& row : lines) {
        const DashKind kind = told_apart && !is_of_grid(row, lines) ? row.kind : DashKind::dashes;
        Stroke stroke{{},
                      false,
                      kind == DashKind::dashes ? LineClass::normal : LineClass::thick,
                      kStrength,
                      kind == DashKind::dots ? Role::dots : Role::dash};
        for (const Point& p : row.points) stroke.points.push_back({p.x * mm, p.y * mm});
        parts.strokes.push_back(std::move(stroke));
    }
    const Image before = whiskers.empty() ? Image{} : picture;
    paint_over(picture, ink, ink_of_all);
    join_whiskers(picture, before, ink, whiskers);
    known.forget();
}

void take_noisy_curves(Image& picture, KnownOfPicture& known, KnownParts& parts) {
    const double mm = picture.mm_per_pixel;
    std::vector<Run> all;
    for (const NoisyCurve& curve : noisy_curves_in(picture)) {
        Stroke stroke{{}, false, LineClass::normal, kStrength, Role::line};
        for (const Point& p : curve.course) stroke.points.push_back({p.x * mm, p.y * mm});
        parts.strokes.push_back(std::move(stroke));
        ++parts.noisy;
        for (const auto& [foot, tip] : curve.spikes)
            parts.strokes.push_back(
                {{{foot.x * mm, foot.y * mm}, {tip.x * mm, tip.y * mm}}, false, LineClass::normal, kStrength});
        all.insert(all.end(), curve.ink.begin(), curve.ink.end());
    }
    if (all.empty()) return;
    paint_over(picture, known.ink_of_dashes(), all);
    known.forget();
}

// Heads of arrows.
void take_heads(Image& picture, KnownOfPicture& known, KnownParts& parts) {
    const double mm = picture.mm_per_pixel;
    std::vector<InkedHead> taken;
    // On a dark ground of its own a head is only seen by how black it is, on white a pale one by its colour.
    for (const bool by_colour : {true, false}) {
        const Image ink = with_gaps_closed(by_colour ? known.ink() : black_ink(picture), known.rows());
        auto heads = arrow_heads_in(ink, kLongestHead / mm);
        if (heads.empty()) continue;
        // A point on a short line looks much like one, as does what is left at the tip of another.
        const auto points = points_in(ink, kLeastPoint / mm, kMostPoint / mm);
        std::erase_if(heads, [&](const InkedHead& head) {
            return is_within_row(head.tip, known.rows()) ||
                   std::any_of(points.begin(), points.end(),
                               [&](const InkedPoint& point) {
                                   return distance(point.middle, head.tip) < head.length() + point.radius;
                               }) ||
                   std::any_of(taken.begin(), taken.end(), [&](const InkedHead& other) {
                       return distance(head.tip, other.tip) < other.length() && 2 * head.length() < other.length();
                   });
        });
        if (heads.empty()) continue;
        known.lead_to(heads);
        take_out(picture, heads);
        for (const InkedHead& head : heads) parts.strokes.push_back(head_of(head, mm));
        taken.insert(taken.end(), heads.begin(), heads.end());
    }
}

// Without a strength neither they nor the end of the bar that they cross are broken, and the bar stays where they are close to
// it.
void add_thin_strokes(const std::vector<std::array<Point, 2>>& strokes, double mm, KnownParts& parts) {
    for (const auto& [from, to] : strokes) parts.strokes.push_back({{{from.x * mm, from.y * mm}, {to.x * mm, to.y * mm}}, false});
}

// Bars of a chart; whether there are any.
bool take_bars(Image& picture, const PixelColour& ground, KnownParts& parts) {
    constexpr float kBarStrength = 60;  // less than that of curves over them, which say more
    const auto found = inked_bars_in(picture, ground, picture.mm_per_pixel);
    if (!found) return false;
    FeltBars felt = felt_bars(chart_bars_of(*found, picture.mm_per_pixel));
    if (felt.strokes.empty()) return false;
    take_out(picture, ground, *found);
    for (Stroke& stroke : felt.strokes) stroke.strength = kBarStrength;
    std::move(felt.strokes.begin(), felt.strokes.end(), std::back_inserter(parts.strokes));
    std::move(felt.areas.begin(), felt.areas.end(), std::back_inserter(parts.areas));
    return true;
}

// How many of the marks are dashes of that line.
std::size_t count_dashes_among(const InkedMarks& found, const DashRow& row) {
    std::size_t count = 0;
    for (std::size_t i = 0; i + 1 < row.points.size(); i += 2) {
        const Point a = row.points[i], b = row.points[i + 1], middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
        count += std::any_of(found.marks.begin(), found.marks.end(),
                             [&](const InkedMark& mark) { return distance(mark.middle, middle) <= row.width / 2; })
                     ? 1
                     : 0;
    }
    return count;
}

// Large dots and short dashes of a line are alike, as the points of a plot are: so they go before these are looked for. A line
// with points on it has more dashes than points.
InkedMarks marks_in(const Image& picture, KnownOfPicture& known) {
    const double mm = picture.mm_per_pixel, least = std::max(kFewestPixels, kLeastMark / mm), most = kMostMark / mm;
    InkedMarks found = inked_marks_in(picture, known.ink(), least, most);
    if (found.marks.empty()) return found;
    std::vector<Run> dashes;
    for (const DashRow& row : known.rows())
        if (is_dense(row) && 4 * count_dashes_among(found, row) > row.points.size())  // half of them
            dashes.insert(dashes.end(), row.ink.begin(), row.ink.end());
    if (dashes.empty()) return found;
    Image without = picture;
    paint_over(without, known.ink_of_dashes(), dashes);
    return inked_marks_in(without, ink_on_white(without), least, most);
}

// Points of a plot, each kind with a symbol of its own.
void take_marks(Image& picture, KnownOfPicture& known, const std::vector<Box>& print, KnownParts& parts) {
    const double mm = picture.mm_per_pixel;
    const InkedMarks found = without_print(marks_in(picture, known), print);
    if (found.marks.empty()) return;
    take_out(picture, found);
    known.forget();
    parts.marks = found.symbols.size();
    std::vector<Point> middles;
    std::vector<HidingMark> hiding;
    for (const InkedMark& mark : found.marks) {
        middles.push_back(mark.middle);
        hiding.push_back({mark.middle, found.radii[mark.kind]});
    }
    known.hide_under(std::move(hiding));
    const bool told_apart = found.symbols.size() > 1;
    const double felt = felt_radius(middles, mm, told_apart ? kLeastForm : kLeastDisc, told_apart ? kFeltForm : kFeltPoint);
    for (const InkedMark& mark : found.marks)
        parts.areas.push_back(symbol_area(found.symbols[mark.kind], {mark.middle.x * mm, mark.middle.y * mm},
                                          std::clamp(found.radii[mark.kind] * mm, felt, std::max(felt, kFeltForm))));
}

void take_points(Image& picture, KnownOfPicture& known, KnownParts& parts) {
    const double mm = picture.mm_per_pixel;
    const auto points = points_in(known.ink(), kLeastPoint / mm, kMostPoint / mm);
    take_out(picture, points);
    std::vector<Point> middles;
    for (const InkedPoint& point : points) middles.push_back(point.middle);
    const double felt = felt_radius(middles, mm, kLeastDisc, kFeltPoint);
    for (const InkedPoint& point : points) {
        Drawing disc;
        draw_symbol(PlotSymbol::disc, {point.middle.x * mm, point.middle.y * mm}, std::max(point.radius * mm, felt), disc);
        std::move(disc.areas.begin(), disc.areas.end(), std::back_inserter(parts.areas));
    }
}

}  // namespace

void KnownParts::add_to(Drawing& drawing) && {
    for (Stroke& stroke : strokes) {
        for (Point& p : stroke.points) p = {std::clamp(p.x, 0.0, drawing.width), std::clamp(p.y, 0.0, drawing.height)};
        drawing.strokes.push_back(std::move(stroke));
    }
    std::move(areas.begin(), areas.end(), std::back_inserter(drawing.areas));
}

std::vector<Phrase> KnownParts::told() const {
    std::vector<Phrase> told;
    if (left_out > 0)
        told.push_back(phrases(left_out, "{0} pale surface is left out, as a curve runs along its border.",
                               "{0} pale surfaces are left out, as curves run along their borders."));
    if (marks > kSymbols)
        told.push_back(phrase("{0} kinds of points are more than a finger tells apart, so some have the same symbol.",
                              std::to_string(marks)));
    if (grid_lines > 0) told.push_back(told_of_grid(grid_lines));
    if (noisy > 0) told.push_back(told_of_noise(noisy));
    return told;
}

KnownParts take_known_parts(Image& picture, const std::optional<std::array<int, 3>>& ground, const std::vector<Box>& print) {
    KnownParts parts;
    quieten(picture);
    if (ground) {
        add_thin_strokes(take_error_bars(picture), picture.mm_per_pixel, parts);
        add_thin_strokes(take_tick_marks(picture), picture.mm_per_pixel, parts);
    }
    const std::array<int, 3> ground_there = ground ? *ground : ground_of(picture);
    KnownOfPicture known(picture);
    parts.grid_lines = leave_out_pale_grid(picture, known.ink(), ground_there);
    if (parts.grid_lines > 0) known.forget();
    if (!ground) deepen_pale_curves(picture, known.ink(), ground_there);  // one cut parts ink and ground
    const bool bars = take_bars(picture, ground_there, parts);
    if (ground && !bars) parts.areas = take_fills(picture, *ground);
    if (ground && !bars && parts.areas.empty()) parts.left_out = leave_out_pale_fills(picture);
    known.forget();
    take_noisy_curves(picture, known, parts);
    take_marks(picture, known, print, parts);
    take_heads(picture, known, parts);
    take_dashes(picture, known, parts);
    take_points(picture, known, parts);
    return parts;
}

}  // namespace tactics
