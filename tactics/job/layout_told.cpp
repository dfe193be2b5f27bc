// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/layout_told.h"

#include <algorithm>

#include "tactics/geometry/dashed_line.h"

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
    for (const PageName& name : page.names) layout.names.push_back(name.text);
}

std::string name_of_input(const Outcome& outcome) {
    const std::string name = outcome.input == "-" ? "standard input" : outcome.input;
    return outcome.pdf_page > 0 ? name + " page " + std::to_string(outcome.pdf_page) : name;
}

}  // namespace tactics
