// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/layout_told.h"

#include <algorithm>
#include <cmath>

#include "tactics/braille/braille.h"
#include "tactics/geometry/dashed_line.h"
#include "tactics/layout/text_pages.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

bool has_black(const Bitmap& picture) {
    return std::any_of(picture.bits.begin(), picture.bits.end(), [](std::uint8_t bits) { return bits != 0; });
}

}  // namespace

void tell_layout(Layout& layout, const Pages& pages) {
    const Page& page = pages.whole();
    layout.place = pages.place;
    layout.place.page_width = pages.all.front().width;
    layout.place.page_height = pages.all.front().height;
    layout.pages = pages.all.size();
    for (std::size_t i = 0; i < page.strokes.size(); i = last_of_line(page, i) + 1)
        layout.strokes += is_drawn(page.strokes[i].role) ? 1 : 0;
    layout.stroke_length = total_stroke_length(page);
    layout.areas = page.areas.size();
    layout.textured = page.textured.size();
    layout.has_picture = page.picture.has_value();
    layout.empty =
        layout.strokes == 0 && page.areas.empty() && page.textured.empty() && !(page.picture && has_black(*page.picture));
    if (pages.place.drawing.width <= 0) {  // a page of text, or of a key
        layout.text_lines = lines_of_braille(pages.all);
        layout.empty = layout.empty && layout.text_lines == 0;
    }
    for (const PageName& name : page.names) layout.names.push_back(name.text);
}

Phrase left_out_words(const std::vector<Name>& left_out, const Phrase& more_room) {
    std::vector<Phrase> names;
    for (const Name& name : left_out) names.push_back(phrase("\"{0}\" ({1})", beginning_of(name.text), name.origin));
    return phrases(
        names.size(),
        "{1} is left out, as there is no room for it in braille; take {2}, or shorter names with {3} and {4} remove",
        "{0} names are left out, as there is no room for them in braille: {1}; take {2}, or shorter names with {3} and "
        "{4} remove",
        row_of(names), more_room, spelled("label"), spelled("words"));
}

Phrase thinned_words(std::size_t numbers, const Phrase& more_room) {
    return phrase(
        "{0} numbers in rows are left out, every second or more, as the page has no room for all in braille; {1} shows "
        "more",
        std::to_string(numbers), more_room);
}

Phrase no_room_for_words(bool print_is_left, const Phrase& more_room) {
    return print_is_left
               ? phrase("print in it is left in the lines, as the page has no room for it in braille; take {0}, or {1} remove",
                        more_room, spelled("words"))
               : phrase("its words are left out, as the page has no room for them in braille; take {0}, or {1} remove", more_room,
                        spelled("words"));
}

Phrase note_of_smaller(const Layout& layout, double before, const Phrase& more_room) {
    const double width = layout.place.drawing.width;
    // Where dots are fixed the room is one of whole cells, and less than one of them is no loss.
    const double loss = has_fixed_dots(*layout.sheet.medium) ? layout.sheet.cell.cell_pitch : 0.1;
    if (width > before - loss) return {};
    const auto mm = [](double value) { return numeral(std::round(value * 10) / 10); };
    return phrase("the drawing is {0} mm wide instead of {1} mm, as this sheet has room for no more; take {2}", mm(width),
                  mm(before), more_room);
}

Phrase note_of_long_title(const Sheet& sheet) {
    if (sheet.title_cells <= 0 || sheet.title.empty()) return {};
    const std::size_t cells = to_braille(sheet.title, sheet.braille_table, sheet.title_origin).size();
    if (cells <= static_cast<std::size_t>(sheet.title_cells)) return {};
    return phrase("the display shows the first {0} of the {1} cells of the title; shorten it", std::to_string(sheet.title_cells),
                  std::to_string(cells));
}

bool breaks_a_rule(const Outcome& outcome) {
    return std::any_of(outcome.layouts.begin(), outcome.layouts.end(), [](const Layout& layout) {
        return std::any_of(layout.broken.begin(), layout.broken.end(),
                           [](const BrokenRule& rule) { return rule.hard && rule.places > 0; });
    });
}

std::string name_of_input(const Outcome& outcome) {
    const std::string name = outcome.input == "-" ? "standard input" : outcome.input;
    return outcome.pdf_page > 0 ? name + " page " + std::to_string(outcome.pdf_page) : name;
}

}  // namespace tactics
