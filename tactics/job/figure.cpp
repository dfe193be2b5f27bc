// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/figure.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "print/letters.h"
#include "tactics/error.h"
#include "tactics/geometry/box.h"
#include "tactics/geometry/clipped.h"
#include "tactics/job/figure_title.h"
#include "tactics/job/label_lines.h"
#include "tactics/job/letter_picture.h"
#include "tactics/job/letter_shapes.h"
#include "tactics/layout/sheet.h"
#include "tactics/readers/xml.h"
#include "tactics/text/utf8.h"
#include "tactics/units.h"

namespace tactics {

std::string bytes_of(std::FILE* file) {
    std::string bytes;
    char block[1 << 16];
    for (std::size_t count = 1; count > 0 && bytes.size() <= kMostXmlBytes;) {  // one more than may be: parse_xml says so
        count = std::fread(block, 1, sizeof block, file);
        bytes.append(block, count);
    }
    return bytes;
}

namespace {

// Lettering that nobody could read.
Phrase left_out_words(std::size_t count, const std::string& places, const Phrase& trouble) {
    Phrase text =
        phrases(count,
                "{0} piece of its lettering, drawn as shapes that no installed font has, is left out: at {1}; give the "
                "words with {2}",
                "{0} pieces of its lettering, drawn as shapes that no installed font has, are left out: at {1}; give the "
                "words with {2}",
                places, spelled("label"));
    return trouble.empty() ? text : phrase("{0}. {1}", std::move(text), trouble);
}

// Where its lines and areas begin, but for a frame around the whole.
FirstInk first_ink(const Page& page) {
    constexpr double kNearlyAll = 0.95;  // of the width and the height
    double top = page.height;
    const auto each = [&](const auto& take) {
        const auto look = [&](const std::vector<Point>& points, double half) {
            const Box box = box_of(points);
            if (box.width() < kNearlyAll * page.width || box.height() < kNearlyAll * page.height) take(points, box, half);
        };
        for (const PageStroke& stroke : page.strokes) look(stroke.points, stroke.width / 2);
        for (const Area& area : page.areas)
            for (const auto& ring : area.rings) look(ring, 0);
    };
    each([&](const std::vector<Point>&, const Box& box, double half) { top = std::min(top, box.top - half); });
    if (top >= page.height) return {};
    const Rect part{0, top, page.width, kFirstPart / 100 * page.height};
    double left = page.width, right = 0;
    each([&](const std::vector<Point>& points, const Box& box, double) {
        if (box.top > part.top + part.height) return;
        for (const auto& piece : clipped(points, false, part))
            for (const Point& p : piece) left = std::min(left, p.x), right = std::max(right, p.x);
    });
    return {100 * top / page.height, 100 * left / page.width, 100 * right / page.width};
}

// The lines of what is drawn, by where they are.
class DrawnLines {
public:
    explicit DrawnLines(const Page& page) {
        for (const PageStroke& stroke : page.strokes) add(stroke.points, stroke.closed);
        for (const Area& area : page.areas)
            for (const auto& ring : area.rings) add(ring, true);
    }

    bool any_in(const Box& box) const {
        const Rect place{box.left, box.top, box.width(), box.height()};
        return std::any_of(all_.begin(), all_.end(), [&](const Drawn& one) {
            return meet(one.box, box) && !clipped(*one.points, one.closed, place).empty();
        });
    }

    // The smallest closed one around a place; null: there is none.
    const std::vector<Point>* around(Point at) const {
        const Drawn* best = nullptr;
        for (const Drawn& one : all_)
            if (one.closed && one.box.holds(at) &&
                (best == nullptr || one.box.width() * one.box.height() < best->box.width() * best->box.height()))
                best = &one;
        return best == nullptr ? nullptr : best->points;
    }

private:
    struct Drawn {
        Box box;
        const std::vector<Point>* points;
        bool closed;
    };
    void add(const std::vector<Point>& points, bool closed) { all_.push_back({box_of(points), &points, closed}); }

    std::vector<Drawn> all_;
};

void join_lines(const FoundPage& found, std::vector<ToldWords>& told) {
    std::vector<PlacedLine> lines;
    for (const FoundWords& one : found.words)
        lines.push_back({{one.middle.x - one.width / 2, one.middle.y - one.height / 2, one.middle.x + one.width / 2,
                          one.middle.y + one.height / 2},
                         one.height,
                         one.upwards,
                         one.centred});
    std::optional<DrawnLines> known;
    const auto drawn = [&]() -> const DrawnLines& { return known ? *known : known.emplace(found.page); };
    join_label_lines(told, lines,
                     {[&](const Box& place) { return !drawn().any_in(place); },
                      [&](Point one, Point other) {
                          const auto* around = drawn().around(one);
                          return around != nullptr && around == drawn().around(other);
                      }});
}

std::string origin_place(const ToldWords& words) {
    const auto percent = [](double value) { return to_text(std::round(value * 10) / 10) + "%"; };
    return percent(words.x) + "," + percent(words.y);
}

}  // namespace

Figure read_figure(Source& source, WordsWish wish, const Sheet& sheet) {
    Figure figure;
    // A figure without a size is finally drawn as large as the sheet, so any size will do.
    const bool wordless = wish == WordsWish::leave || wish == WordsWish::remove || sheet.bare;
    Phrase trouble;  // in reading letters that are shapes
    figure.page = read_svg(
        bytes_of(source.file.get()), source.name, 0, find_paper("a4", ""), wordless ? SvgPurpose::lines : SvgPurpose::figure,
        [&](FoundPage& page) {
            read_letter_shapes(page);
            trouble = read_letter_picture(page, sheet.language);
        },
        letter_widths_of);
    const Page& page = figure.page.page;
    PrintWords& words = figure.words;
    words.notes.assign(figure.page.notes.begin(), figure.page.notes.end());
    if (!page.braille.empty())
        words.notes.push_back(to_act_on(phrase("braille in it is left out; give its words with {0}", spelled("label"))));
    if (wordless) {
        if (!figure.page.words.empty() && !sheet.bare) words.notes.push_back(phrase("its words are left out"));
        return figure;
    }
    std::vector<PrintPlace> places;
    std::string unread;
    std::size_t count = 0, by_sight = 0;
    for (const FoundWords& one : figure.page.words) {
        const double x = 100 * one.middle.x / page.width, y = 100 * one.middle.y / page.height;
        const bool known = !one.text.empty();
        by_sight += known && !one.letters.empty() && one.sureness < 100 ? 1 : 0;
        const bool there = x >= 0 && x <= 100 && y >= 0 && y <= 100;
        words.told.push_back({one.text, known ? one.sureness : 0, x, y, known && there && !one.hidden});
        if (!known) {
            unread += (++count == 1 ? "" : "; ") + origin_place(words.told.back());
        } else if (!there)
            words.notes.push_back(
                to_act_on(phrase("the words \"{0}\" are left out: they lie outside of the drawing", beginning_of(one.text))));
        places.push_back({{x, y}, 100 * one.height / page.height, one.upwards, false, false, one.thing.has_value()});
    }
    if (by_sight > 0)
        words.notes.push_back(to_act_on(phrases(
            by_sight,
            "{0} piece of its lettering, drawn as shapes that no installed font has, was read as print is; look it over",
            "{0} pieces of its lettering, drawn as shapes that no installed font has, were read as print is; look them over")));
    if (count > 0) words.notes.push_back(to_act_on(left_out_words(count, unread, trouble)));
    std::vector<ToldWords> before = words.told;
    keep_what_has_braille(words.told, sheet.braille_table);
    for (std::size_t i = 0; i < before.size(); ++i)
        if (before[i].set && !words.told[i].set)
            words.notes.push_back(
                to_act_on(phrase("the words \"{0}\" are left out: the braille table has no cells for them; take another with {1}",
                                 beginning_of(before[i].text), spelled("braille"))));
    if (sheet.title.empty() && page.title.empty()) words.title = take_title(words.told, places, first_ink(page));
    want_places(words.told, std::move(places));
    for (std::size_t i = 0; i < words.told.size(); ++i)
        if (const auto& thing = figure.page.words[i].thing)
            words.told[i].wanted = {100 * thing->x / page.width, 100 * thing->y / page.height};
    join_lines(figure.page, words.told);
    return figure;
}

}  // namespace tactics
