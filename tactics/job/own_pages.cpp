// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/own_pages.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "tactics/error.h"
#include "tactics/geometry/dashed_line.h"
#include "tactics/layout/chosen_heights.h"
#include "tactics/layout/dot_grid.h"
#include "tactics/layout/key.h"
#include "tactics/layout/place.h"
#include "tactics/layout/room.h"
#include "tactics/layout/words_anew.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

constexpr double kSamePlace = 0.02;  // mm

bool is_same(double a, double b) { return std::abs(a - b) < kSamePlace; }

const Medium* medium_named(std::string_view name) {
    for (const Medium& medium : media())
        if (medium.name == name) return &medium;
    return nullptr;
}

bool is_paper_of(const Paper& paper, const Page& own) {
    return (is_same(paper.width, own.width) && is_same(paper.height, own.height)) ||
           (is_same(paper.width, own.height) && is_same(paper.height, own.width));
}

bool is_turned_so(Orientation orientation, const Page& own) {
    return orientation == Orientation::automatic || (orientation == Orientation::landscape) == (own.width > own.height);
}

bool has_margin(double margin, const Rect& live, const Page& own) {
    return is_same(live.left, margin) && is_same(live.top, margin) && is_same(own.width - live.left - live.width, margin) &&
           is_same(own.height - live.top - live.height, margin);
}

// A picture has the dots of any machine; a file of 6-dot cells has those of such cells, wherever they begin, and loses others.
bool has_dots_of(const DotBed& bed, const Format& format, const Settings& settings) {
    if (has_six_dots(format, settings)) return bed.raster == 0 && bed.dots_down < 4;
    return format.dots == nullptr;
}

// Which is the same on every medium.
bool has_only_braille(const Page& own) {
    return own.drawing.width <= 0 && own.strokes.empty() && own.areas.empty() && own.textured.empty() && !own.picture;
}

// Another line of words than it has.
bool differs(const std::string& asked, const std::string& own) { return !asked.empty() && to_line(asked) != own; }

bool asks_for_other_words(const Job& job, const Page& own) {
    const Sheet& asked = job.sheet;
    const bool print =
        std::any_of(own.words.begin(), own.words.end(),
                    [](const PageWords& words) { return words.kind == WordsKind::title || words.kind == WordsKind::caption; }) &&
        !own.print.empty();
    return differs(asked.title, own.title) || differs(asked.caption, own.caption) ||
           differs(asked.description, own.description) || job.title_from_name || !job.labels.empty() ||
           (job.asked.language && asked.language != own.language) ||
           ((job.asked.braille || job.asked.language) && asked.braille_table != own.braille_table) ||
           (!asked.print_title && print);
}

bool asks_for_other_place(const Job& job, const Page& own) {
    const Sheet& asked = job.sheet;
    return (job.paper && !is_paper_of(*job.paper, own)) || (asked.margin && !has_margin(*asked.margin, own.live, own)) ||
           !is_turned_so(asked.orientation, own) || asked.binding || asked.duplex || asked.tiles.several() ||
           asked.drawing_width || asked.real_width || asked.scale || asked.bare;
}

LineClass class_of(double width, const Medium& medium) {
    if (width < medium.line - kPageStep / 2) return LineClass::thin;
    return width > (medium.line + medium.thick_line) / 2 + kPageStep ? LineClass::thick : LineClass::normal;
}

// A lead line of a name is found anew; those of a chart are of its drawing.
bool leads_from_name(const PageStroke& stroke, const Page& own, double gap) {
    return std::any_of(own.names.begin(), own.names.end(), [&](const PageName& name) {
        return distance(nearest_of(name.place, stroke.points.front()), stroke.points.front()) < gap + 1;
    });
}

void add_strokes(const Page& own, const Medium& medium, Drawing& drawing) {
    for (std::size_t i = 0; i < own.strokes.size(); ++i) {
        const PageStroke& stroke = own.strokes[i];
        if (!is_drawn(stroke.role) || stroke.points.size() < 2) continue;
        if (stroke.role == Role::lead && leads_from_name(stroke, own, clear_of_braille(medium) + medium.thin_line)) continue;
        Stroke line{stroke.points, stroke.closed, stroke.inner ? LineClass::thin : class_of(stroke.width, medium), 0,
                    stroke.role};
        if (const std::size_t last = last_of_line(own, i); last > i) {
            line.points = whole_line(own, i, last);
            line.closed = false;
            i = last;
        }
        drawing.strokes.push_back(std::move(line));
    }
}

void add_words_of(const Page& own, Drawing& drawing) {
    for (const PageWords& words : own.words)
        if (words.kind == WordsKind::label) drawing.labels.push_back({words.at, words.across, words.down, words.text});
    for (const PageName& name : own.names) {
        Name found{name.thing, name.text, "its word \"" + beginning_of(name.text) + "\""};
        if (name.words >= 0 && static_cast<std::size_t>(name.words) < own.words.size()) {
            found.within = own.words[static_cast<std::size_t>(name.words)].within;
            found.optional = own.words[static_cast<std::size_t>(name.words)].optional;
        }
        drawing.names.push_back(std::move(found));
    }
    for (const Name& name : own.left_out) {
        drawing.names.push_back(name);
        drawing.names.back().optional = true;
    }
}

void move_to_origin(Drawing& drawing, const Rect& place) {
    const auto move = [&](Point& p) { p = {p.x - place.left, p.y - place.top}; };
    for (Stroke& stroke : drawing.strokes)
        for (Point& p : stroke.points) move(p);
    for (Area& area : drawing.areas)
        for (auto& ring : area.rings)
            for (Point& p : ring) move(p);
    for (Region& region : drawing.regions) {
        move(region.at);
        for (auto& ring : region.rings)
            for (Point& p : ring) move(p);
    }
    for (Label& label : drawing.labels) move(label.at);
    for (Name& name : drawing.names) move(name.at);
}

Image image_of(const Bitmap& bitmap) {
    Image image;
    image.width = bitmap.width;
    image.height = bitmap.height;
    image.channels = 1;
    for (int y = 0; y < bitmap.height; ++y)
        for (int x = 0; x < bitmap.width; ++x) {
            const std::uint8_t byte =
                bitmap.bits[static_cast<std::size_t>(y) * bitmap.row_bytes() + static_cast<std::size_t>(x / 8)];
            image.pixels.push_back((byte >> (7 - x % 8) & 1) != 0 ? 0 : 255);
        }
    return image;
}

// Behind the page, if it has no room for that.
void add_key(Pages& pages, const Page& own) {
    std::vector<bool> set(own.words.size(), false);
    for (const BrailleLine& line : own.braille)
        if (line.words >= 0) set[static_cast<std::size_t>(line.words)] = true;
    std::vector<KeyEntry> entries;
    for (std::size_t i = 0; i < own.words.size(); ++i)
        if (own.words[i].kind == WordsKind::key && !set[i]) entries.push_back(key_entry(own.words[i], own));
    std::vector<Page> key = key_pages(entries, own, sheet_of(own));
    for (Page& page : key) {
        put_on_dots(page);
        put_on_steps(page);
    }
    std::move(key.begin(), key.end(), std::back_inserter(pages.all));
}

}  // namespace

void take_own(Sheet& sheet, const Page& own, const Wishes& wishes, const Format& format) {
    if (!wishes.asked.language) sheet.language = own.language;
    if (!wishes.asked.language && !wishes.asked.braille) sheet.braille_table = own.braille_table;
    // A machine that was named has its own cells, medium and paper.
    const bool six = format.embosser == nullptr && has_six_dots(format, wishes.settings_of(format));
    const bool free = wishes.machine == nullptr && (format.dots == nullptr || six);
    if (!wishes.asked.cell && free) sheet.cell = own.cell;
    if (sheet.description.empty()) sheet.description = own.description;
    const Medium* medium = medium_named(own.medium);
    // A picture can show dots, and dots cannot show lines.
    const bool can_have =
        medium != nullptr && (has_fixed_dots(*medium) || !has_fixed_dots(find_medium(format.medium, format.name)));
    if (can_have && wishes.sheet.medium == nullptr && free) sheet.medium = medium;
    if (!wishes.paper && sheet.medium == medium && free && !sheet.bare) {
        sheet.paper = {"", "", std::min(own.width, own.height), std::max(own.width, own.height)};
        if (sheet.orientation == Orientation::automatic)
            sheet.orientation = own.width > own.height ? Orientation::landscape : Orientation::portrait;
    }
    if (sheet.bare) return;
    if (sheet.title.empty()) sheet.title = own.title;
    if (sheet.caption.empty()) sheet.caption = own.caption;
    if (own.print.empty() && !own.braille.empty() && !has_fixed_dots(*sheet.medium) && sheet.medium == medium)
        sheet.print_title = false;
    if (own.scale && !sheet.real_width && own.drawing.width > 0)
        sheet.real_width = own.drawing.width / own.scale->length * own.scale->real;
}

bool asks_for_other_size(const Sheet& sheet, const Page& own, const Wishes& wishes) {
    // More paper is asked for because more has room on it, but another medium has its own.
    return sheet.drawing_width || sheet.scale || sheet.tiles.several() || sheet.window ||
           (wishes.paper && sheet.medium == medium_named(own.medium));
}

void keep_size(Sheet& sheet, const Page& own, const Wishes& wishes) {
    if (!asks_for_other_size(sheet, own, wishes) &&
        place_on(sheet, own.drawing.width / own.drawing.height).drawing.width >= own.drawing.width)
        sheet.drawing_width = own.drawing.width;
}

bool stays_as_it_is(const Sheet& sheet, const Page& own, const Job& job, const Format& format) {
    const bool same_medium = own.medium.empty() || sheet.medium->name == own.medium || has_only_braille(own);
    const bool same_bed =
        sheet.bed ? own.bed && *own.bed == *sheet.bed : !own.bed || has_dots_of(*own.bed, format, job.settings_of(format));
    if (same_medium && same_bed && sheet.cell == own.cell && !asks_for_other_words(job, own) && !asks_for_other_place(job, own))
        return true;
    if (own.drawing.width > 0 && own.drawing.height > 0 && medium_named(own.medium) != nullptr) return false;
    throw Error(
        Fault::usage, job.input,
        phrase("this page has no drawing that could be laid out on another sheet or medium; make it from what it was made of"));
}

Pages pages_of_own(const Page& own, const DotHeights& dots) {
    Pages pages;
    pages.place = {own.width, own.height, own.live, own.drawing};
    pages.all.push_back(own);
    if (!own.is_key) add_key(pages, own);
    choose_heights(pages, dots);
    return pages;
}

Drawing drawing_of_page(const Page& own) {
    Drawing drawing;
    drawing.width = own.drawing.width;
    drawing.height = own.drawing.height;
    if (const Medium* medium = medium_named(own.medium)) add_strokes(own, *medium, drawing);
    drawing.areas = own.areas;
    drawing.areas.insert(drawing.areas.end(), own.textured.begin(), own.textured.end());
    if (own.picture) drawing.picture = image_of(*own.picture);
    add_words_of(own, drawing);
    drawing.regions = own.regions;
    drawing.remarks = own.remarks;
    move_to_origin(drawing, own.drawing);
    return drawing;
}

}  // namespace tactics
