// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/svg_letters.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "tactics/readers/svg/cairo_glyphs.h"
#include "tactics/readers/svg/clip.h"
#include "tactics/readers/svg/svg_path.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

// "0-12" after its beginning; with `dash` between the numbers.
bool is_two_numbers(std::string_view text, char dash) {
    const auto at = text.find(dash);
    return at != text.npos && at > 0 && at + 1 < text.size() && std::all_of(text.begin(), text.begin() + at, is_digit) &&
           std::all_of(text.begin() + at + 1, text.end(), is_digit);
}

// Settings, in heights of the tallest letter of the font: what parts letters of one line.
constexpr double kOffBaseline = 0.08, kNextWord = 1.2, kNextLetter = 0.65, kBack = 1.5;
// The same of an index or an exponent: how far it is off the line, and beside its letter.
constexpr double kIndexOff = 0.7, kNextIndex = 0.25;

// Of the width of a wide letter its height is more. A setting.
constexpr double kHighAsWide = 0.6;

constexpr double kStraight = 0.01;  // of a line's length

// The outline in the letter's own units: flattened finely enough for units of any size.
void trace(const Element& element, const Transform& place, std::vector<std::vector<Point>>& rings, int depth) {
    constexpr int kDeepest = 8;
    constexpr double kFine = 500;  // units for which a hundredth is fine enough
    if (depth > kDeepest) return;
    Transform own;
    if (const auto text = element.attribute("transform"); !text.empty() && !parse_transform(text, own)) return;
    const Transform all = place * own;
    if (element.name == "path") {
        double scale = 1;
        for (int pass = 0; pass < 2; ++pass) {
            Pen pen(Transform{scale, 0, 0, scale, 0, 0} * all);
            if (draw_path(element.attribute("d"), pen)) return;
            const std::vector<Subpath> subpaths = pen.finish();
            const double size = size_of(subpaths);
            if (pass == 0 && size > 0 && size < kFine) {
                scale = kFine / size;
                continue;
            }
            for (std::vector<Point>& ring : rings_of(subpaths)) {
                for (Point& p : ring) p = {p.x / scale, p.y / scale};
                rings.push_back(std::move(ring));
            }
            return;
        }
    }
    for (const Element& child : element.children) trace(child, all, rings, depth + 1);
}

// A letter where it stands on its line: along it, and across.
struct Placed {
    std::size_t shape;
    Point at, way;
    double scale = 1;  // mm for one of its units
    const Element* group;
};

Rect box_of(const LetterShape& shape) {
    Extent extent;
    for (const auto& ring : shape.rings)
        for (const Point& p : ring) extent.add(p);
    return extent.box;
}

class Lines {
public:
    Lines(const std::vector<LetterShape>& shapes, FoundPage& figure) : shapes_(shapes), figure_(figure) {
        for (const LetterShape& shape : shapes) {
            boxes_.push_back(box_of(shape));
            // TeX has the minus sign in a font of signs: it is not as high as letters are.
            double& tallest = tallest_[shape.font];
            tallest = std::max({tallest, boxes_.back().height, kHighAsWide * boxes_.back().width});
        }
    }

    void add(const Placed& letter) {
        if (!line_.empty() && !goes_on(letter)) finish();
        line_.push_back(letter);
    }

    // A line that is blank says nothing.
    void finish() {
        Extent ink;
        for (const Placed& one : line_) add_ink(ink, one);
        if (ink.points > 0) {
            const Placed& first = line_.front();
            FoundWords words;
            words.middle = ink.box.middle();
            words.upwards = std::abs(first.way.y) > std::abs(first.way.x);
            words.height = std::min(tall(first), words.upwards ? ink.box.width : ink.box.height);
            words.width = words.upwards ? ink.box.height : ink.box.width;
            words.start = first.at;
            words.way = first.way;
            words.unit = first.scale;
            for (const Placed& one : line_)
                words.letters.push_back({one.shape, along(first, one) / one.scale, -down(first, one) / one.scale});
            figure_.words.push_back(std::move(words));
        }
        line_.clear();
    }

    // All of a formula, where some letters stand above or below others: what it says is not known.
    void finish_as_one(const std::vector<Placed>& formula) {
        Extent ink;
        for (const Placed& one : formula) add_ink(ink, one);
        if (ink.points == 0) return;
        FoundWords words;
        words.middle = ink.box.middle();
        words.height = std::min(tall(formula.front()), ink.box.height);
        words.width = ink.box.width;
        figure_.words.push_back(std::move(words));
    }

    bool on_line(const Placed& a, const Placed& b) const {
        return is_along(a, b) && std::abs(down(a, b)) < kOffBaseline * tall(a);
    }

private:
    double tall(const Placed& one) const { return one.scale * tallest_.at(shapes_[one.shape].font); }
    static double along(const Placed& from, const Placed& to) {
        return (to.at.x - from.at.x) * from.way.x + (to.at.y - from.at.y) * from.way.y;
    }
    static double down(const Placed& from, const Placed& to) {
        return (to.at.y - from.at.y) * from.way.x - (to.at.x - from.at.x) * from.way.y;
    }
    static bool is_along(const Placed& a, const Placed& b) {
        return a.way.x * b.way.x + a.way.y * b.way.y > 0.999 && std::abs(a.scale / b.scale - 1) < 0.02;
    }

    bool goes_on(const Placed& next) const {
        const Placed &first = line_.front(), &last = line_.back();
        const double gap = along(last, next) - last.scale * (boxes_[last.shape].left + boxes_[last.shape].width) +
                           next.scale * boxes_[next.shape].left;
        const bool font = shapes_[last.shape].font == shapes_[next.shape].font;
        // In a file that says which letters they are, formulas have other ways.
        const bool formula = !font && shapes_[last.shape].code == 0 && shapes_[next.shape].code == 0;
        const double high = std::max(tall(last), tall(next));
        if (!on_line(last, next)) {
            const bool near = gap > -kNextIndex * high && gap < kNextIndex * high;
            if (!formula || !is_along(first, next)) return false;
            if (on_line(first, next)) return gap > -kNextIndex * high && gap < kNextLetter * std::max(high, tall(first));
            return near && std::abs(down(first, next)) < kIndexOff * std::max(high, tall(first));
        }
        const bool same = last.group == next.group && (last.group == nullptr || shapes_[last.shape].code != 0 || font);
        const double most = same ? kNextWord : kNextLetter;
        return gap > -kBack * tall(last) && gap < most * high;
    }

    void add_ink(Extent& ink, const Placed& one) const {
        const Rect& box = boxes_[one.shape];
        if (shapes_[one.shape].rings.empty()) return;
        for (const double x : {box.left, box.left + box.width})
            for (const double y : {box.top, box.top + box.height})
                ink.add({one.at.x + one.scale * (x * one.way.x - y * one.way.y),
                         one.at.y + one.scale * (x * one.way.y + y * one.way.x)});
    }

    const std::vector<LetterShape>& shapes_;
    FoundPage& figure_;
    std::vector<Rect> boxes_;
    std::map<std::string, double> tallest_;
    std::vector<Placed> line_;
};

}  // namespace

bool names_letter(std::string_view id) {
    if (id.starts_with("glyph-")) return is_two_numbers(id.substr(6), '-');
    if (id.starts_with("glyph")) return is_two_numbers(id.substr(5), '-');
    if (id.starts_with("font_")) return is_two_numbers(id.substr(5), '_');
    if (id.starts_with("MJX-")) return true;
    return id.starts_with('g') && is_two_numbers(id.substr(1), '-');
}

void DrawnLetters::add(const Element& shape, std::string_view name, std::string_view code, const Transform& place,
                       const Element* group) {
    const auto [known, fresh] = known_.try_emplace(&shape, shapes_.size());
    if (fresh) {
        LetterShape& added = shapes_.emplace_back();
        const auto dash = name.find_last_of("-_");
        added.font = name.substr(0, dash);
        added.adopted = dash != name.npos && is_adopted(name.substr(dash + 1));
        trace(shape, Transform(), added.rings, 0);
        std::uint32_t letter = 0;
        const auto end = code.data() + code.size();
        if (!code.empty() && std::from_chars(code.data(), end, letter, 16).ptr == end && letter < 0x110000) added.code = letter;
        // Drawn upwards, in a view that is turned over.
        if (place.a * place.d - place.b * place.c < 0)
            for (auto& ring : added.rings)
                for (Point& p : ring) p.y = -p.y;
    }
    uses_.push_back({known->second, place, group});
}

void DrawnLetters::settle(FoundPage& figure) const {
    figure.letter_shapes = shapes_;
    const std::map<std::string, Point> turns = turn_upright(figure.letter_shapes);
    Lines lines(figure.letter_shapes, figure);
    for (std::size_t i = 0; i < uses_.size();) {
        std::vector<Placed> group;
        const std::size_t end = end_of_group(i);
        bool level = true, formula = false;
        for (; i < end; ++i) {
            const Transform& t = uses_[i].place;
            const double size = std::hypot(t.a, t.b);
            if (!(size > 0) || !std::isfinite(size) || !std::isfinite(t.e) || !std::isfinite(t.f)) continue;
            const LetterShape& shape = shapes_[uses_[i].shape];
            const auto turn = turns.find(shape.font);
            const Point way{t.a / size, t.b / size}, by = turn == turns.end() ? Point{1, 0} : turn->second;
            group.push_back({uses_[i].shape,
                             {t.e, t.f},
                             {way.x * by.x - way.y * by.y, way.x * by.y + way.y * by.x},
                             t.scale(),
                             uses_[i].group});
            level = level && lines.on_line(group.front(), group.back());
            formula = formula || shape.code != 0;
        }
        if (formula && !level) {
            lines.finish();
            lines.finish_as_one(group);
            continue;
        }
        for (const Placed& one : group) lines.add(one);
    }
    lines.finish();
}

std::size_t DrawnLetters::end_of_group(std::size_t from) const {
    std::size_t end = from;
    while (end < uses_.size() && uses_[end].group == uses_[from].group) ++end;
    return end;
}

// A line of one group; or, where each letter has a group of its own, those of one font that follow each other upright, ink right
// beside ink, as figures that stand above each other in a column are not.
std::size_t DrawnLetters::end_of_line(std::size_t from) const {
    constexpr double kBeside = 0.25;  // of the ink of the larger one
    std::size_t end = end_of_group(from);
    if (end - from > 1) return end;
    const auto box_at = [&](const Use& use) {
        Rect box = box_of(shapes_[use.shape]);
        return Rect{box.left * use.place.a + use.place.e, box.top * use.place.d + use.place.f, box.width * use.place.a,
                    box.height * use.place.d};
    };
    for (; end < uses_.size() && end_of_group(end) == end + 1; ++end) {
        const Use &last = uses_[end - 1], &next = uses_[end];
        const Rect a = box_at(last), b = box_at(next);
        const double larger = std::max({a.width, a.height, b.width, b.height});
        const double gap = std::max(a.top - b.top - b.height, b.top - a.top - a.height);
        if (shapes_[last.shape].font != shapes_[next.shape].font || last.place.b != 0 || next.place.b != 0 ||
            std::abs(last.place.e - next.place.e) > kStraight * larger || gap > kBeside * larger)
            break;
    }
    return end;
}

// Cairo has letters of turned lines as turned shapes: which way a line runs is seen where its letters stand.
std::map<std::string, Point> DrawnLetters::turn_upright(std::vector<LetterShape>& shapes) const {
    std::map<std::string, Point> turns;
    for (std::size_t i = 0, end = 0; i < uses_.size(); i = end) {
        end = end_of_line(i);
        const std::string& font = shapes_[uses_[i].shape].font;
        const Transform& first = uses_[i].place;
        const Transform& last = uses_[end - 1].place;
        const double x = last.e - first.e, y = last.f - first.f, far = std::hypot(x, y), size = std::hypot(first.a, first.b);
        if (!(far > 0) || !std::isfinite(far) || !(size > 0) || turns.contains(font)) continue;
        bool straight = true, alike = true;
        for (std::size_t k = i; k < end; ++k) {
            const Transform& t = uses_[k].place;
            straight = straight && std::abs((t.e - first.e) * y - (t.f - first.f) * x) < kStraight * far * far;
            alike = alike && shapes_[uses_[k].shape].font == font && t.a == first.a && t.b == first.b;
        }
        // Two letters may stand above each other for other reasons.
        const bool upright = std::min(std::abs(x), std::abs(y)) < kStraight * far;
        if (straight && alike && (end - i > 2 || upright))
            turns[font] = {(x * first.a + y * first.b) / (far * size), (y * first.a - x * first.b) / (far * size)};
    }
    for (LetterShape& shape : shapes)
        if (const auto turn = turns.find(shape.font); turn != turns.end())
            for (auto& ring : shape.rings)
                for (Point& p : ring)
                    p = {p.x * turn->second.x + p.y * turn->second.y, p.y * turn->second.x - p.x * turn->second.y};
    return turns;
}

}  // namespace tactics
