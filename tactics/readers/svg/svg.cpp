// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/svg.h"

#include <algorithm>
#include <cmath>

#include "tactics/error.h"
#include "tactics/layout/own_marks.h"
#include "tactics/readers/svg/chart_parts.h"
#include "tactics/readers/svg/clip.h"
#include "tactics/readers/svg/embedded.h"
#include "tactics/readers/svg/found_braille.h"
#include "tactics/readers/svg/found_mark.h"
#include "tactics/readers/svg/hidden_lines.h"
#include "tactics/readers/svg/outlined_words.h"
#include "tactics/readers/svg/rings.h"
#include "tactics/readers/svg/style_sheet.h"
#include "tactics/readers/svg/svg_choice.h"
#include "tactics/readers/svg/svg_dashes.h"
#include "tactics/readers/svg/svg_drawn.h"
#include "tactics/readers/svg/svg_ground.h"
#include "tactics/readers/svg/svg_letters.h"
#include "tactics/readers/svg/svg_marker.h"
#include "tactics/readers/svg/svg_numbers.h"
#include "tactics/readers/svg/svg_ours.h"
#include "tactics/readers/svg/svg_path.h"
#include "tactics/readers/svg/svg_shapes.h"
#include "tactics/readers/svg/svg_size.h"
#include "tactics/readers/svg/svg_style.h"
#include "tactics/readers/svg/svg_words.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr double kFarthest = 1e5;  // mm
constexpr std::size_t kMostPoints = 3'000'000;
constexpr std::size_t kMostDashes = 10'000;  // of a line
constexpr int kMostUses = 16;                // of a thing that uses a thing that uses ...

class SvgReader {
public:
    SvgReader(const std::string& file, FoundPage& found, SvgPurpose purpose, const FontOpener& open_font,
              SvgLook look = SvgLook::plain, std::vector<FoundMark>* marks = nullptr)
        : file_(file),
          found_(found),
          fonts_(open_font),
          look_(look),
          figure_(purpose != SvgPurpose::page),
          marks_(marks),
          ground_(look) {}

    void run(const Element& root, double margin, const std::optional<Paper>& paper) {
        if (root.name != "svg") refuse(root, phrase("this is XML but no SVG drawing; save it as SVG"));
        by_id_ = elements_by_id(root);
        sheet_.know(root, missed_);
        if (figure_) fonts_.know(root);
        Page& page = found_.page;
        SvgSize size = size_of_svg(root, file_, paper);
        found_.tells_size = size.told;
        found_.file_width = size.width;
        found_.file_height = size.height;
        if (figure_) scale_to_figure(size);
        page.width = size.width;
        page.height = size.height;
        lengths_.width = size.view_width;
        lengths_.height = size.view_height;
        if (!size.note.empty() && !figure_) found_.notes.push_back(size.note);
        const double inset = std::min({margin, page.width / 2, page.height / 2});
        page.live = {inset, inset, page.width - 2 * inset, page.height - 2 * inset};
        const Style style = sheet_.style_of(root, Style{}, missed_);
        page.title = figure_ ? title_of(root) : first_title_in(root);
        clip_ = {0, 0, page.width, page.height};
        for (const Element& child : root.children) draw(child, size.to_mm, style, 0);
        settle_discs(std::move(discs_), found_.page);
        if (figure_) take_braille_of_figure(found_);
        if (figure_) letters_.settle(found_);
        missed_.all = is_blank(found_.page);
        for (Phrase& note : notes_of(missed_, figure_)) found_.notes.push_back(std::move(note));
    }

private:
    [[noreturn]] void refuse(const Element& element, const Phrase& why) const {
        throw Error(Fault::failed, file_ + ":" + std::to_string(element.line), why);
    }

    double across(const Element& e, std::string_view name, double fallback = 0) const {
        return lengths_.across(e, name, fallback);
    }
    double down(const Element& e, std::string_view name, double fallback = 0) const { return lengths_.down(e, name, fallback); }

    void draw(const Element& element, const Transform& outer, const Style& parent, int uses) {
        if (!is_rendered(element)) return;
        if (++drawn_ > kMostElements) refuse(element, phrase("this drawing uses its parts over a million times; simplify it"));
        Transform own;
        if (const auto text = element.attribute("transform"); !text.empty() && !parse_transform(text, own))
            refuse(element, phrase("\"{0}\" is no transform; mend it or save the drawing again", text.substr(0, 40)));
        const Transform transform = outer * own;
        const Style style = sheet_.style_of(element, parent, missed_);
        if (!style.shown) return;
        if (element.name == "page" && missed_.pages++ > 0) return;
        const Rect outside = clip_;
        if (figure_) {
            if (narrow_clip(element, transform)) --missed_.clips;
            if (std::string words = words_beside(element); !words.empty() && !lettering_) {
                draw_lettering(element, transform, style, uses, std::move(words));
                clip_ = outside;
                return;
            }
        }
        draw_inside(element, transform, style, uses);
        clip_ = outside;
    }

    void draw_inside(const Element& element, const Transform& transform, const Style& style, int uses) {
        if (is_group(element)) {
            draw_group(element, transform, style, uses);
        } else if (element.name == "switch") {
            draw_choice(element, transform, style, uses);
        } else if (element.name == "svg") {
            draw_view(element, element, transform, style, uses);
        } else if (element.name == "use") {
            use(element, transform, style, uses);
        } else if (has_words(element)) {
            ++(element.name == "text" ? missed_.letters : missed_.foreign);
            auto words = figure_ ? words_in(element, transform, style, needs_, lengths_) : std::vector<FoundWords>();
            missed_.foreign -= element.name != "text" && !words.empty() ? 1 : 0;
            if (style.visible && !lettering_) add_words(found_.words, std::move(words));
        } else if (element.name == "image") {
            if (style.visible && style.opacity > 0) draw_picture(element, transform);
        } else {
            draw_shape(element, transform, style);
        }
    }

    void draw_group(const Element& group, const Transform& transform, const Style& style, int uses) {
        if (auto cell = cell_told(group, transform.scale())) cell_ = cell;
        // What names nothing, such as the title, which title_of knows; and the same in print.
        if (figure_ && !lettering_ && (tells_cells(group) || tells_words(group))) return;
        const std::size_t disc = discs_.size(), line = found_.page.braille.size();
        const MarkKeeper keeper(tells_cells(group) ? marks_ : nullptr, group, transform, layer_, found_.page);
        const std::string_view outer_layer = layer_;
        if (const auto layer = group.attribute(marks::kLayer); !layer.empty()) layer_ = layer;
        const Element* const outer = group_;
        if (outer == nullptr || outer->attribute("data-mml-node") != "math") group_ = &group;
        for (const Element& child : group.children) draw(child, transform, style, uses);
        group_ = outer;
        layer_ = outer_layer;
        if (!figure_) settle_group(group, cell_, discs_, disc, line, found_.page);
    }

    void draw_choice(const Element& choice, const Transform& transform, const Style& style, int uses) {
        const SvgChoice chosen = chosen_in(choice);
        if (chosen.drawn == nullptr) return;
        const std::size_t before = found_.words.size();
        draw(*chosen.drawn, transform, style, uses);
        // The place is that of the text, the words are those that were not cut off.
        if (found_.words.size() == before + 1 && !chosen.words.empty()) found_.words.back().text = chosen.words;
    }

    // Letters that are shapes, with their words beside them: their box is all that is wanted.
    void draw_lettering(const Element& element, const Transform& transform, const Style& style, int uses, std::string words) {
        ink_ = {};
        for (const Element& child : element.children) {
            lettering_ = !child.attribute("id").starts_with("patch");  // Matplotlib's frame around them
            draw(child, transform, style, uses);
        }
        lettering_ = true;
        if (element.name == "path") draw_inside(element, transform, style, uses);
        lettering_ = false;
        if (ink_.points == 0) {  // they are text after all
            const std::size_t before = found_.words.size();
            draw_inside(element, transform, style, uses);
            if (element.attribute("id").starts_with("text_"))
                say_right(found_.words, before, words);  // others label all their texts
            return;
        }
        found_.words.push_back(words_in_box(std::move(words), ink_.box, element.comment));
    }

    // Matplotlib and others cut the curves of a chart off at its frame.
    bool narrow_clip(const Element& element, const Transform& transform) {
        const Element* clip = needs_.element(name_in_url(element.attribute("clip-path")));
        const auto cut = clip == nullptr ? std::nullopt : clip_rectangle(*clip, lengths_, transform);
        if (cut) clip_ = common_of(clip_, {cut->left, cut->top}, {cut->left + cut->width, cut->top + cut->height});
        return cut.has_value();
    }

    // The children of a svg or symbol, in the place that `by` gives it.
    void draw_view(const Element& of, const Element& by, const Transform& outer, const Style& style, int uses) {
        Transform place = of.name == "svg" ? outer * Transform{1, 0, 0, 1, across(of, "x"), down(of, "y")} : outer;
        double view[4];
        if (view_box(of, view))
            place = place * fit_view(view, across(by, "width", view[2]), down(by, "height", view[3]),
                                     of.attribute("preserveAspectRatio"));
        for (const Element& child : of.children) draw(child, place, style, uses);
    }

    void use(const Element& element, const Transform& transform, const Style& style, int uses) {
        std::string_view name = element.attribute("href");
        if (!name.starts_with('#')) return;
        name.remove_prefix(1);
        const auto found = by_id_.find(name);
        if (names_letter(name) && !lettering_) {
            ++missed_.letters;
            if (found != by_id_.end() && style.visible)
                letters_.add(*found->second, name, element.attribute("data-c"),
                             transform * Transform{1, 0, 0, 1, across(element, "x"), down(element, "y")}, group_);
            return;
        }
        if (found == by_id_.end()) return;
        if (uses >= kMostUses)
            refuse(element, phrase("parts of this drawing use each other without end; mend it or save the drawing again"));
        const Transform place = transform * Transform{1, 0, 0, 1, across(element, "x"), down(element, "y")};
        const Element& target = *found->second;
        if (target.name == "symbol" || target.name == "svg")
            draw_view(target, element, place, sheet_.style_of(target, style, missed_), uses + 1);
        else
            draw(target, place, style, uses + 1);
    }

    void draw_shape(const Element& element, const Transform& transform, const Style& style) {
        const MarkKeeper keeper(marks_, element, transform, layer_, found_.page);
        ours_ = marks_ != nullptr && !element.attribute(marks::kNumber).empty();
        if (take_region(element, transform, found_.page)) return;
        Pen pen(transform);
        if (!draw_outline(element, lengths_, pen, figure_ ? &missed_.broken : nullptr) || !style.visible) return;
        const std::size_t strokes = found_.page.strokes.size(), areas = found_.page.areas.size();
        add(element, pen.finish(), transform, style, element.name != "line");
        if (figure_) add_look(found_, strokes, areas, style, ground_);
    }

    void count_points(const Element& element, std::size_t more) {
        points_ += more;
        if (points_ > kMostPoints)
            refuse(element, phrase("there are more than 3 million points up to here; simplify the drawing"));
    }

    void add(const Element& element, std::vector<Subpath> subpaths, const Transform& transform, const Style& style,
             bool has_inside) {
        for (const Subpath& subpath : subpaths) {
            count_points(element, subpath.points.size());
            if (!is_within(subpath, kFarthest))
                refuse(element, phrase("a place over 100 m away from the page is out of range; mend its coordinates"));
        }
        if (lettering_) return add_all(ink_, subpaths);
        Paint fill = style.fill, stroke = style.stroke;
        fill.opacity *= style.opacity * style.fill_own;
        stroke.opacity *= style.opacity * style.stroke_own;
        if (const int texture = texture_told(element); has_inside && texture > 0) {
            found_.page.textured.push_back({rings_of(subpaths), Role::line, texture});
            return;
        }
        has_inside = has_inside && !rings_of(subpaths).empty();
        if (figure_ && has_inside) add_light_shape(found_, subpaths, style.fill, ground_.on_white(style.fill.lightness));
        if (figure_ && ground_.takes(has_inside ? subpaths : std::vector<Subpath>{}, fill, stroke, found_.page)) return;
        if (figure_ && look_ == SvgLook::plain && has_inside && is_shadow(fill, stroke, style.blurred)) {
            ++missed_.shadows;
            return;
        }
        if (figure_ && has_inside) add_cover(found_, subpaths, fill, clip_);
        const bool is_surface = figure_ && has_inside && fill.is_seen();
        if (figure_ && paint_figure(fill, stroke, has_inside, fill.is_ink() && is_sign(subpaths) ? 0 : size_of(subpaths)))
            ++missed_.pale;
        if (has_inside && fill.is_ink()) add_area(subpaths, style.even_odd, role_of(element));
        const double whole = lengths_.whole();
        const double width = parse_svg_length(style.stroke_width, whole).value_or(1) * transform.scale();
        if (!stroke.is_ink() || !(width > 0)) return;
        if (!(width <= kFarthest)) refuse(element, phrase("a line over 100 m wide is out of range; mend its width"));
        missed_.stretched += transform.stretches() ? 1 : 0;
        if (takes_markers(element)) draw_markers(subpaths, style, width, transform.scale());
        if (is_surface) close_rings(subpaths);
        const Dashes dashes = parse_dashes(style.dashes, style.dash_offset, whole, transform.scale());
        const Role role = role_of(element);
        for (Subpath& subpath : subpaths) {
            // Dashes made for the eye are too fine for a finger: those of a figure are made anew when it is repaired.
            auto pieces = dashes.lengths.empty() || figure_ ? std::nullopt : cut_into_dashes(subpath, dashes, kMostDashes);
            missed_.dashes += !dashes.lengths.empty() && !pieces && !figure_ ? 1 : 0;
            if (!pieces) {
                add_stroke(std::move(subpath), width, style.butt,
                           figure_ && !dashes.lengths.empty() && role == Role::line ? Role::dash : role);
                continue;
            }
            count_points(element, 2 * pieces->size());
            for (Subpath& piece : *pieces) add_stroke(std::move(piece), width, style.butt, Role::dash);
        }
    }

    void draw_markers(const std::vector<Subpath>& subpaths, const Style& style, double width, double scale) {
        const auto ends = in_marker_ ? std::nullopt : ends_of(subpaths);
        if (!ends) return;
        draw_marker(style.marker_start, ends->first, width, scale);
        draw_marker(style.marker_end, ends->second, width, scale);
    }

    void draw_marker(std::string_view url, const LineEnd& end, double width, double scale) {
        if (url.empty() || url == "none") return;
        const auto found = by_id_.find(name_in_url(url));
        if (found == by_id_.end() || found->second->name != "marker") return void(++missed_.markers);
        const Element& marker = *found->second;
        const std::size_t strokes = found_.page.strokes.size(), areas = found_.page.areas.size();
        in_marker_ = true;
        const Style style = sheet_.style_of(marker, Style{}, missed_);
        for (const Element& child : marker.children) draw(child, marker_place(marker, end, width, scale), style, 0);
        in_marker_ = false;
        tell_marker(found_.page, strokes, areas);
    }

    void add_area(const std::vector<Subpath>& subpaths, bool even_odd, Role role) {
        std::vector<std::vector<Point>> rings = rings_of(subpaths);
        if (rings.empty()) return;
        Disc disc;
        if (figure_) {
            if (!std::all_of(rings.begin(), rings.end(), [&](const auto& ring) { return lies_in(ring, clip_); })) return;
        } else if (role == Role::line && !ours_ && rings.size() == 1 && is_braille_dot(rings[0], disc)) {
            discs_.push_back(disc);
            return;
        }
        found_.page.areas.push_back({even_odd ? std::move(rings) : to_even_odd(std::move(rings)), role});
    }

    // A marker's is another one when all of it is known.
    Role role_of(const Element& element) const { return in_marker_ ? Role::symbol : role_told(element); }

    void add_stroke(Subpath subpath, double width, bool butt, Role role) {
        auto& points = subpath.points;
        const bool dot = std::all_of(points.begin(), points.end(), [&](Point p) { return distance(p, points[0]) < 1e-6; });
        if (dot && (role == Role::pattern || ours_))  // no braille
            return found_.page.strokes.push_back({{points[0], points[0]}, false, width, role});
        if (dot && role == Role::line) {
            // Without round ends a line of no length shows nothing.
            if (!butt) discs_.push_back({points[0], width});
            return;
        }
        if (points.size() < 3) subpath.closed = false;
        if (butt && !subpath.closed) cut_flat_ends(points, width);
        add_clipped(found_.page, {std::move(points), subpath.closed, width, role}, figure_ ? std::optional(clip_) : std::nullopt);
    }

    void draw_picture(const Element& element, const Transform& transform) {
        const MarkKeeper keeper(marks_, element, transform, layer_, found_.page);
        const auto place = upright_box(element, lengths_, transform);
        const std::string_view address = element.attribute("href");
        const bool known = place && std::abs(place->width) <= kFarthest && std::abs(place->height) <= kFarthest;
        if (!known ||
            !(figure_ ? take_figure_picture(found_, address, *place, clip_) : take_page_picture(found_, address, *place)))
            ++missed_.pictures;
    }

    const std::string& file_;
    SvgLengths lengths_{file_};
    FoundPage& found_;
    StyleSheet sheet_;
    Missed missed_;
    SvgFonts fonts_;
    ElementsById by_id_;
    std::vector<Disc> discs_;
    std::optional<CellSize> cell_;  // of our own files, mm
    const SvgLook look_;
    const bool figure_;
    std::vector<FoundMark>* const marks_;  // nullptr: nobody wants to know
    std::string_view layer_ = {};          // of our own files
    const TextNeeds needs_{[this](const Element& part, const Style& outer) { return sheet_.style_of(part, outer, missed_); },
                           [this](std::string_view id) {
                               const auto found = by_id_.find(id);
                               return found == by_id_.end() ? nullptr : found->second;
                           },
                           [this](std::string_view families) -> const LetterWidths& { return fonts_.widths_of(families); }};
    bool lettering_ = false;          // within letters that are shapes, whose words stand beside them
    DrawnLetters letters_;            // those without
    const Element* group_ = nullptr;  // the innermost, or a formula's outermost
    Extent ink_;                      // theirs
    Rect clip_;                       // mm; of a figure
    Ground ground_;                   // its
    std::size_t drawn_ = 0, points_ = 0;
    bool in_marker_ = false;  // which has none of its own
    bool ours_ = false;       // what is drawn is numbered by us
};

}  // namespace

FoundPage read_marked_svg(const Element& root, const std::string& file, std::vector<FoundMark>& marks) {
    FoundPage found;
    SvgReader(file, found, SvgPurpose::page, {}, SvgLook::plain, &marks).run(root, 0, std::nullopt);
    return found;
}

FoundPage read_svg(std::string_view bytes, const std::string& file, double margin, const std::optional<Paper>& paper,
                   SvgPurpose purpose, const LetterReader& read_letters, const FontOpener& open_font) {
    const Element root = parse_xml(bytes, file);
    FoundPage found;
    SvgReader(file, found, purpose, open_font).run(root, margin, paper);
    // Who shows nothing so far may be all gleam, or drawn in white for a dark ground.
    for (const SvgLook look : {SvgLook::gleams, SvgLook::on_dark}) {
        if (purpose == SvgPurpose::page || !is_blank(found.page) || !found.words.empty() || !found.pictures.empty()) break;
        FoundPage again;
        SvgReader(file, again, purpose, open_font, look).run(root, margin, paper);
        if (is_blank(again.page)) continue;
        found = std::move(again);
        if (look == SvgLook::on_dark)
            found.notes.push_back(phrase("all of it is white or nearly so, and taken to stand on a dark ground"));
    }
    if (purpose == SvgPurpose::figure && read_letters) read_with_outlined_words(found, read_letters);
    if (purpose != SvgPurpose::page) tidy_chart(found, purpose == SvgPurpose::figure);
    return found;
}

}  // namespace tactics
