// SPDX-License-Identifier: Apache-2.0
#include "tactics/layout/place.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "tactics/error.h"
#include "tactics/layout/scale_bar.h"
#include "tactics/text/number.h"
#include "tactics/units.h"

namespace tactics {

namespace {

// Rounded down, and with a point in every language, so that what a message offers is accepted when it is given back.
Phrase mm(double value) { return phrase("{0} mm", to_text(std::max(0.0, std::floor(value * 10 + 1e-6) / 10))); }

// From the first dot of a machine's cells that lies in the live area to the last, so that braille in its corner has dots and no
// line lies beside them. What the machine keeps free at the left and the top it does on the other sides, too.
Rect within_bed(Rect live, const DotBed& bed, const CellSize& cell, double width, double height) {
    const double half = cell.dot / 2;
    const auto trim = [half](double& from, double& extent, double first, double step, double inner, double whole) {
        const auto cells = [&](double at) { return (at - first) / step; };
        const double begin = first + std::max(0.0, std::ceil(cells(from + half) - 1e-9)) * step;
        const double end =
            first + std::floor(cells(std::min(from + extent, whole - first + half) - half - inner) + 1e-9) * step + inner;
        from = begin - half;
        extent = end + half - from;
    };
    const bool raster = bed.raster > 0;
    trim(live.left, live.width, bed.first.x, bed.across(cell), raster ? 0 : cell.dot_pitch, width);
    trim(live.top, live.height, bed.first.y, bed.down(cell), raster ? 0 : (bed.dots_down - 1) * cell.dot_pitch, height);
    return live;
}

// One orientation of the sheet: its arrangement with the largest drawing, or the reason why there is none.
struct Attempt {
    Arrangement arrangement;
    std::string place;  // of the fault
    Phrase fault;       // empty = it can be done
};

// Each step of an attempt answers whether there was room enough, and gives up where there was not.
bool give_up(Attempt& attempt, std::string_view place, Phrase fault) {
    attempt.place = place;
    attempt.fault = std::move(fault);
    return false;
}

Phrase paper_words(const Place& place) { return phrase("{0} x {1} paper", mm(place.page_width), mm(place.page_height)); }

bool leave_binding(Attempt& attempt, const Sheet& sheet, double least) {
    const Binding& binding = *sheet.binding;
    Place& place = attempt.arrangement.place;
    const bool top = binding.edge == Binding::Edge::top;
    const double most = (top ? place.live.height : place.live.width) - least;
    if (binding.room > most && most >= 0)
        return give_up(attempt, sheet.binding_origin,
                       phrase("{0} mm for the binding leaves nothing of {1} to draw on; it can be up to {2} here, or take larger "
                              "paper",
                              to_text(binding.room), paper_words(place), mm(most)));
    (top ? place.live.height : place.live.width) -= binding.room;
    if (top)
        place.live.top += binding.room;
    else if (binding.edge == Binding::Edge::left)
        place.live.left += binding.room;
    return true;
}

bool check_live(Attempt& attempt, const Sheet& sheet, double margin, double least) {
    const Place& place = attempt.arrangement.place;
    if (!(place.live.width < least || place.live.height < least)) return true;
    const double spare = (std::min(place.page_width, place.page_height) - least) / 2;
    if (sheet.margin)
        return give_up(attempt, sheet.margin_origin,
                       phrase("margins of {0} mm leave nothing of {1} to draw on; they can be up to {2} here, or take larger "
                              "paper",
                              to_text(margin), paper_words(place), mm(spare)));
    const Phrase side = to_text(std::ceil((2 * margin + least) * 10) / 10);
    return give_up(attempt, spelled("paper"),
                   spare > 0
                       ? phrase("{0} is too small for its margins of {1} mm; take paper of at least {2} mm a side, or margins "
                                "of up to {3} with {4}",
                                paper_words(place), to_text(margin), side, mm(spare), spelled("margin"))
                       : phrase("{0} is too small for its margins of {1} mm; take paper of at least {2} mm a side",
                                paper_words(place), to_text(margin), side));
}

// From here on the page is the whole of all tiles.
bool lay_together(Attempt& attempt, const Sheet& sheet) {
    Place& place = attempt.arrangement.place;
    const auto& cut = attempt.arrangement.cut = cut_of(place.page_width, place.page_height, place.live, sheet);
    if (!cut)
        return give_up(attempt, spelled("tiles"),
                       phrase("{0} is too small to be laid together; take larger paper or leave it out", paper_words(place)));
    place.page_width += cut->whole.width - cut->window.width;
    place.page_height += cut->whole.height - cut->window.height;
    place.live = cut->whole;
    return true;
}

Phrase crowded_words(const Sheet& sheet, const Title& title, const TitleBand& band, double height) {
    Phrase taken = mm(band.height);
    if (band.braille.size() > 1)
        taken = phrase("{0} ({1} lines of braille)", std::move(taken), std::to_string(band.braille.size()));
    const Phrase mend = sheet.window ? phrase("leave it out") : phrase("shorten it, leave it out, or take larger paper");
    const Phrase all = mm(height);
    if (title.caption.empty())
        return phrase("the title takes {0} of the page's {1}, which leaves too little to the drawing; {2}", taken, all, mend);
    if (title.text.empty())
        return phrase("the caption takes {0} of the page's {1}, which leaves too little to the drawing; {2}", taken, all, mend);
    return phrase("the title and the caption take {0} of the page's {1}, which leaves too little to the drawing; {2}", taken, all,
                  mend);
}

// The title, the drawing and the scale bar, one below the other. `titled`: the live area of the first sheet, on which the title
// stands as a whole.
void stack(Attempt& attempt, const Sheet& sheet, const Title& title, const Rect& titled, double aspect) {
    Place& place = attempt.arrangement.place;
    const TitleBand& band = attempt.arrangement.band = set_title(title, sheet, titled);
    const double below = sheet.real_width ? scale_bar_height(sheet) : 0;
    // On the first sheet of the lowest row as a whole.
    attempt.arrangement.scale_bar = {place.live.left, place.live.top + place.live.height - below, titled.width, below};
    const double room = place.live.height - band.height - below;
    const bool long_title = band.braille.size() > 1 && band.height > titled.height / 3;
    if (long_title || room < sheet.medium->shortest) {
        give_up(attempt, title.text.empty() ? spelled("caption") : sheet.title_origin,
                crowded_words(sheet, title, band, place.live.height));
        return;
    }
    // At the top of its room, close to the title: hands come from there, and what is left free is in one piece.
    const double drawn = std::min(place.live.width, room * aspect);
    place.drawing = {place.live.left + (place.live.width - drawn) / 2, place.live.top + band.height, drawn,
                     std::min(room, drawn / aspect)};
}

Attempt attempt(const Sheet& sheet, const Title& title, double width, double height, double aspect) {
    Attempt out;
    Place& place = out.arrangement.place;
    const double margin = sheet.margin.value_or(sheet.medium->margin);
    const double least = sheet.medium->shortest;
    place.page_width = width;
    place.page_height = height;
    place.live = {margin, margin, width - 2 * margin, height - 2 * margin};
    if (sheet.reach > 0) place.live.width = std::min(place.live.width, sheet.reach - margin);
    if (sheet.binding && !leave_binding(out, sheet, least)) return out;
    if (sheet.bed) place.live = within_bed(place.live, *sheet.bed, sheet.cell, width, height);
    if (!check_live(out, sheet, margin, least)) return out;
    Rect titled = place.live;
    if (sheet.tiles.several()) {
        if (!lay_together(out, sheet)) return out;
        titled = out.arrangement.cut->window;
    }
    stack(out, sheet, title, titled, aspect);
    return out;
}

Attempt best_attempt(const Sheet& sheet, const Title& title, double aspect) {
    const double shorter = std::min(sheet.paper.width, sheet.paper.height);
    const double longer = std::max(sheet.paper.width, sheet.paper.height);
    const auto portrait = [&] { return attempt(sheet, title, shorter, longer, aspect); };
    const auto landscape = [&] { return attempt(sheet, title, longer, shorter, aspect); };
    if (sheet.orientation == Orientation::portrait) return portrait();
    if (sheet.orientation == Orientation::landscape) return landscape();
    Attempt upright = portrait();
    Attempt turned = landscape();
    // The drawing has the same shape on both, so the wider one is the larger; upright unless turning gains something.
    const double gain = turned.arrangement.place.drawing.width - upright.arrangement.place.drawing.width;
    return turned.fault.empty() && (!upright.fault.empty() || gain > 1e-6) ? turned : upright;
}

// A scale that asks for more than the page has room for: what would do.
[[noreturn]] void refuse_scale(const Sheet& sheet, const Title& title, double aspect, double wanted, double room) {
    const auto fits = [&](const Sheet& other) {
        const Attempt attempt = best_attempt(other, title, aspect);
        return attempt.fault.empty() && attempt.arrangement.place.drawing.width >= wanted;
    };
    // To two digits, up: 1:130 for 1:121.
    const double least = *sheet.real_width / room, step = std::pow(10, std::floor(std::log10(least)) - 1);
    std::vector<Phrase> ways{phrase("take {0} 1:{1}", spelled("scale"), to_text(std::ceil(least / step - 1e-9) * step))};
    const Paper* smallest = nullptr;
    for (const Paper& paper : papers()) {
        Sheet other = sheet;
        other.paper = paper;
        if (fits(other) && (smallest == nullptr || paper.width * paper.height < smallest->width * smallest->height))
            smallest = &paper;
    }
    if (smallest != nullptr) ways.push_back(phrase("{0} {1}", spelled("paper"), smallest->name));
    std::optional<Tiles> fewest;
    for (int columns = 1; columns <= 9; ++columns)
        for (int rows = 1; rows <= 9; ++rows) {
            Sheet other = sheet;
            other.tiles = {columns, rows};
            if ((!fewest || columns * rows < fewest->columns * fewest->rows) && fits(other)) fewest = other.tiles;
        }
    if (fewest)
        ways.push_back(phrase("{0} {1}", spelled("tiles"), std::to_string(fewest->columns) + "x" + std::to_string(fewest->rows)));
    Phrase mend = ways.front();
    for (std::size_t i = 1; i < ways.size(); ++i) mend = phrase("{0}, or {1}", std::move(mend), ways[i]);
    throw Error(Fault::usage, spelled("scale"),
                phrase("at this scale the drawing would be {0} wide and {1} high, and the page has room for {2} x {3}; {4}",
                       mm(wanted), mm(wanted / aspect), mm(room), mm(room / aspect), mend));
}

// Round, and no larger than the paper allows.
double scale_that_fits(double least) { return least >= 1 ? std::floor(least) + 1 : std::ceil(least * 1000) / 1000; }

}  // namespace

Arrangement arrange(const Sheet& sheet, double aspect) {
    if (sheet.medium == nullptr || !std::isfinite(aspect) || aspect <= 0)
        throw std::logic_error("a sheet without a medium, or a drawing without a size");
    if (sheet.margin && (!std::isfinite(*sheet.margin) || *sheet.margin < 0))
        throw Error(Fault::usage, sheet.margin_origin, phrase("a margin cannot be less than nothing; give 0mm or more"));
    if (sheet.binding && (!std::isfinite(sheet.binding->room) || sheet.binding->room < 0))
        throw Error(Fault::usage, sheet.binding_origin, phrase("the room for it cannot be less than nothing; give 0mm or more"));
    const Title title = title_of(sheet);
    Attempt best = best_attempt(sheet, title, aspect);
    if (!best.fault.empty()) throw Error(Fault::usage, best.place, best.fault);
    Arrangement& found = best.arrangement;
    found.title = title.text;
    Place& place = found.place;
    found.caption = title.caption;
    const bool to_scale = sheet.real_width && sheet.scale;
    if (to_scale || sheet.drawing_width) {
        const double wanted = to_scale ? *sheet.real_width * *sheet.scale : *sheet.drawing_width;
        if (to_scale && wanted < sheet.medium->shortest)
            throw Error(
                Fault::usage, spelled("scale"),
                phrase("at this scale the drawing would be {0} mm wide, too little to be felt; take {1} 1:{2}", to_text(wanted),
                       spelled("scale"), to_text(scale_that_fits(*sheet.real_width / place.drawing.width))));
        if (to_scale && wanted > place.drawing.width + 1e-6) refuse_scale(sheet, title, aspect, wanted, place.drawing.width);
        if (!(wanted > 0) || wanted > place.drawing.width + 1e-6)
            throw Error(Fault::usage, spelled("width"),
                        phrase("the drawing cannot be {0} mm wide; on this page it can be up to {1}", to_text(wanted),
                               mm(place.drawing.width)));
        place.drawing.left += (place.drawing.width - wanted) / 2;
        place.drawing.width = wanted;
        place.drawing.height = wanted / aspect;
    }
    if (sheet.bare) {
        place.drawing.left = place.drawing.top = 0;
        place.page_width = place.drawing.width;
        place.page_height = place.drawing.height;
        place.live = place.drawing;
    }
    return std::move(found);
}

Place place_on(const Sheet& sheet, double aspect) { return arrange(sheet, aspect).place; }

}  // namespace tactics
