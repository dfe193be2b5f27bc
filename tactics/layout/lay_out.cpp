// SPDX-License-Identifier: Apache-2.0
#include "tactics/layout/lay_out.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "tactics/layout/chosen_heights.h"
#include "tactics/layout/dot_grid.h"
#include "tactics/layout/facing.h"
#include "tactics/layout/label.h"
#include "tactics/layout/pattern.h"
#include "tactics/layout/scale_bar.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

// From the drawing's millimetres to the page's.
class Mover {
public:
    Mover(const Place& place, double drawing_width)
        : scale_(place.drawing.width / drawing_width),
          left_(place.drawing.left),
          top_(place.drawing.top),
          right_edge_(place.page_width),
          bottom_edge_(place.page_height) {}

    Point moved(const Point& p) const {
        if (!std::isfinite(p.x) || !std::isfinite(p.y)) throw std::logic_error("a drawing with a point nowhere");
        const double x = left_ + p.x * scale_, y = top_ + p.y * scale_;
        return {std::clamp(x, 0.0, right_edge_), std::clamp(y, 0.0, bottom_edge_)};
    }

    std::vector<Point> moved(const std::vector<Point>& points) const {
        std::vector<Point> out;
        out.reserve(points.size());
        for (const Point& p : points) out.push_back(moved(p));
        return out;
    }

private:
    double scale_, left_, top_, right_edge_, bottom_edge_;
};

struct Drawn {
    Page page;
    std::vector<KeyEntry> key;  // if it had no room on the page
    std::optional<Cut> cut;
    Place place;
};

PageStroke on_page(const Stroke& stroke, const Mover& mover, const Medium& medium) {
    return {mover.moved(stroke.points), stroke.closed, width_of(stroke.line, medium), stroke.role, is_inner(stroke)};
}

// A page with everything but names and what gives way to them.
Page inked(const Drawing& drawing, const Sheet& sheet, Arrangement& arrangement) {
    const Place& place = arrangement.place;
    Page page;
    page.width = place.page_width;
    page.height = place.page_height;
    page.live = place.live;
    page.drawing = place.drawing;
    page.medium = sheet.medium->name;
    page.title = std::move(arrangement.title);
    page.caption = std::move(arrangement.caption);
    page.print = std::move(arrangement.band.print);
    page.braille = std::move(arrangement.band.braille);
    if (!page.title.empty()) page.words.push_back({WordsKind::title, page.title});
    if (!page.caption.empty()) page.words.push_back({WordsKind::caption, page.caption});
    page.braille_dot = sheet.cell.dot;
    page.cell = sheet.cell;
    page.bed = sheet.bed;
    put_on_dots(page);  // the title, before anything keeps clear of it
    page.braille_table = sheet.braille_table;
    page.description = to_line(sheet.description);
    page.language = sheet.language;

    const Mover mover(place, drawing.width);
    page.strokes.reserve(drawing.strokes.size());
    for (const Stroke& stroke : drawing.strokes) page.strokes.push_back(on_page(stroke, mover, *sheet.medium));
    page.areas.reserve(drawing.areas.size());
    for (const Area& area : drawing.areas) {
        Area& moved = (area.texture > 0 ? page.textured : page.areas).emplace_back();
        moved.role = area.role;
        moved.texture = area.texture;
        for (const auto& ring : area.rings) moved.rings.push_back(mover.moved(ring));
    }
    page.regions = drawing.regions;
    for (Region& region : page.regions) {
        region.at = mover.moved(region.at);
        for (auto& ring : region.rings) ring = mover.moved(ring);
    }
    page.remarks = drawing.remarks;
    for (const Label& label : drawing.labels) {
        const Point at = mover.moved(label.at);
        LabelBlock block = placed(set_label(label.text, sheet), label, at, page.cell, page.width, page.height);
        say(block, page, {WordsKind::label, to_line(label.text), "", at, label.across, label.down});
        std::move(block.print.begin(), block.print.end(), std::back_inserter(page.print));
        std::move(block.braille.begin(), block.braille.end(), std::back_inserter(page.braille));
    }
    if (drawing.picture && !drawing.picture->pixels.empty())
        page.picture = drawing.picture->channels == 1 ? to_bitmap(*drawing.picture, place.drawing)
                                                      : to_bitmap(to_grey(*drawing.picture), place.drawing);
    if (sheet.real_width) set_scale_bar(page, arrangement.scale_bar, place.drawing.width / *sheet.real_width, sheet);
    put_on_dots(page);
    return page;
}

std::vector<Name> names_on_page(const Drawing& drawing, const Arrangement& arrangement) {
    const Mover mover(arrangement.place, drawing.width);
    std::vector<Name> names = drawing.names;
    for (Name& name : names) name.at = mover.moved(name.at);
    return names;
}

std::vector<Rect> windows_for(const Arrangement& arrangement, const Sheet& sheet) {
    return arrangement.cut ? windows_of(*arrangement.cut, sheet) : std::vector<Rect>();
}

Drawn draw(const Drawing& drawing, const Sheet& sheet, Arrangement arrangement) {
    Page page = inked(drawing, sheet, arrangement);
    std::vector<KeyEntry> key = set_names(page, names_on_page(drawing, arrangement), sheet, windows_for(arrangement, sheet));
    draw_patterns(page, *sheet.medium,
                  arrangement.cut ? arrangement.cut->live : page.live);  // last: they give way to all that is there
    drop_unset_words(page);
    return {std::move(page), std::move(key), arrangement.cut, arrangement.place};
}

}  // namespace

Page lay_out(const Drawing& drawing, const Sheet& sheet, Arrangement arrangement) {
    Pages pages;
    pages.all.push_back(draw(drawing, sheet, std::move(arrangement)).page);
    put_on_steps(pages.all.front());
    choose_heights(pages, sheet.heights);
    return std::move(pages.all.front());
}

std::optional<NamesCost> cost_of_names(const Drawing& drawing, const Sheet& sheet, Arrangement arrangement, double most) {
    const Page page = inked(drawing, sheet, arrangement);
    return cost_of_names(page, names_on_page(drawing, arrangement), sheet, windows_for(arrangement, sheet), most);
}

Page lay_out(const Drawing& drawing, const Sheet& sheet) {
    return lay_out(drawing, sheet, arrange(sheet, drawing.width / drawing.height));
}

Pages pages_of(const Drawing& drawing, const Sheet& sheet, Arrangement arrangement) {
    Drawn drawn = draw(drawing, sheet, std::move(arrangement));
    Pages pages;
    pages.place = drawn.place;
    if (drawn.cut) {
        pages.all = cut_up(drawn.page, *drawn.cut, sheet);
        pages.large = std::move(drawn.page);
    } else {
        pages.all.push_back(std::move(drawn.page));
    }
    std::vector<Page> key = key_pages(drawn.key, pages.all.front(), sheet);
    for (Page& page : key) put_on_dots(page);
    if (sheet.duplex)
        pages = on_both_sides(std::move(pages), std::move(key));
    else
        std::move(key.begin(), key.end(), std::back_inserter(pages.all));
    if (sheet.duplex && sheet.binding && sheet.binding->edge != Binding::Edge::top)
        for (std::size_t back = 1; back < pages.all.size(); back += 2)
            move_by(pages.all[back], sheet.binding->edge == Binding::Edge::left ? -sheet.binding->room : sheet.binding->room, 0);
    for (Page& page : pages.all) put_on_steps(page);
    if (pages.large) put_on_steps(*pages.large);
    choose_heights(pages, sheet.heights);
    return pages;
}

Pages pages_of(const Drawing& drawing, const Sheet& sheet) {
    return pages_of(drawing, sheet, arrange(sheet, drawing.width / drawing.height));
}

}  // namespace tactics
