// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/svg_style.h"

#include <algorithm>

#include "tactics/readers/svg/svg_numbers.h"
#include "tactics/readers/svg/svg_pattern.h"

namespace tactics {

namespace {

// Lines of a figure. Of the colours of plotting tools all but yellow are darker than that (orange 0.60, olive 0.67); grids and
// frames of legends are lighter (0.69 in Matplotlib, 0.8 and more elsewhere). A setting.
constexpr double kPaleLine = 0.68;
constexpr double kMark = 5;  // mm, of a figure that is 200 mm wide

// "font: 10px 'DejaVu Sans'" has the size before the family.
std::string_view size_in(std::string_view font) {
    while (!font.empty()) {
        const auto blank = std::min(font.find_first_of(" /"), font.size());
        const std::string_view word = font.substr(0, blank);
        if (!word.empty() && ((word[0] >= '0' && word[0] <= '9') || word[0] == '.') && word.find_first_of("px%m") != word.npos)
            return word;
        font.remove_prefix(std::min(blank + 1, font.size()));
    }
    return {};
}

// `own` becomes the opacity of a gradient.
void set_paint(Paint& paint, double& own, std::string_view value, double current, const MeanPaints& gradients, Missed& missed) {
    paint.none = value == "none";
    paint.fades = false;
    paint.pattern = 0;
    own = 1;
    if (paint.none) return;
    if (value == "currentColor" || value == "currentcolor" || value == "context-fill" || value == "context-stroke") {
        paint.lightness = current;
    } else if (value.starts_with("url(")) {
        const auto known = gradients.find(name_in_url(value));
        const MeanPaint mean =
            known == gradients.end() ? MeanPaint{.pattern = pattern_number(name_in_url(value))} : known->second;
        missed.textures += mean.pattern > 0 ? 1 : 0;
        paint.pattern = mean.pattern;
        paint.lightness = mean.lightness;
        paint.fades = mean.fades;
        own = mean.opacity;
    } else if (const auto light = lightness_of(value)) {
        paint.lightness = *light;
    } else {
        ++missed.colours;
        paint.lightness = 0;
    }
}

double share_of(std::string_view value) { return std::clamp(parse_svg_length(value, 1).value_or(1), 0.0, 1.0); }

}  // namespace

std::string_view name_in_url(std::string_view url) {
    const auto hash = url.find('#');
    if (!url.starts_with("url(") || hash == url.npos) return {};
    const auto end = url.find_first_of("\"')", hash);
    return without_svg_blanks(url.substr(hash + 1, end == url.npos ? url.npos : end - hash - 1));
}

Declarations parse_declarations(std::string_view text) {
    Declarations declarations;
    while (!text.empty()) {
        const auto end = text.find(';');
        std::string_view one = text.substr(0, end);
        text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
        const auto colon = one.find(':');
        if (colon == std::string_view::npos) continue;
        std::string_view value = one.substr(colon + 1);
        value = without_svg_blanks(value.substr(0, value.find('!')));
        declarations.emplace_back(without_svg_blanks(one.substr(0, colon)), value);
    }
    return declarations;
}

void set_property(Style& style, std::string_view name, std::string_view value, const MeanPaints& gradients, Missed& missed) {
    if (value == "inherit") return;
    if (name == "fill")
        set_paint(style.fill, style.fill_own, value, style.current, gradients, missed);
    else if (name == "stroke")
        set_paint(style.stroke, style.stroke_own, value, style.current, gradients, missed);
    else if (name == "filter" && value != "none")
        style.blurred = style.blurred || gradients.contains("filter " + std::string(name_in_url(value)));
    else if (name == "fill-opacity")
        style.fill.opacity = share_of(value);
    else if (name == "stroke-opacity")
        style.stroke.opacity = share_of(value);
    else if (name == "opacity")
        style.opacity *= share_of(value);
    else if (name == "stroke-width")
        style.stroke_width = value;
    else if (name == "stroke-linecap")
        style.butt = value == "butt";
    else if (name == "stroke-dasharray")
        style.dashes = value;
    else if (name == "stroke-dashoffset")
        style.dash_offset = value;
    else if (name == "text-anchor")
        style.anchor = value;
    else if (name == "font-size")
        style.font_size = parse_font_size(value, style.font_size);
    else if (name == "font-family")
        style.font_family = value;
    else if (name == "font" && !size_in(value).empty())
        style.font_size = parse_font_size(size_in(value), style.font_size);
    else if (name == "fill-rule")
        style.even_odd = value == "evenodd";
    else if (name == "visibility")
        style.visible = value == "visible";
    else if (name == "display")
        style.shown = style.shown && value != "none";
    else if ((name == "clip-path" || name == "mask") && value != "none")
        ++missed.clips;
    else if (name == "marker-start")
        style.marker_start = value;
    else if (name == "marker-end")
        style.marker_end = value;
    else if (name == "marker-mid")
        missed.markers += value != "none" ? 1 : 0;
    else if (name == "marker")
        style.marker_start = style.marker_end = value;
}

std::vector<Phrase> notes_of(const Missed& missed, bool figure) {
    std::vector<Phrase> notes;
    const auto tell = [&](std::size_t count, Phrase words) {
        if (count > 0) notes.push_back(std::move(words));
    };
    if (!figure && missed.all)
        notes.push_back(phrase("nothing on this page is to be felt: no line or area is darker than half grey; draw in black"));
    if (missed.pages > 1) notes.push_back(phrase("only its first page is looked at"));
    if (!figure)
        tell(missed.letters, phrases(missed.letters, "{0} text or letter is not looked at by any rule",
                                     "{0} texts or letters are not looked at by any rule"));
    tell(missed.dashes, figure ? phrases(missed.dashes, "{0} dashed line is drawn whole", "{0} dashed lines are drawn whole")
                               : phrases(missed.dashes, "{0} line is dashed too finely and taken for whole",
                                         "{0} lines are dashed too finely and taken for whole"));
    tell(missed.textures,
         phrases(missed.textures, "{0} pattern or gradient is taken for black", "{0} patterns or gradients are taken for black"));
    tell(missed.clips, phrases(missed.clips, "{0} clip path or mask is not applied", "{0} clip paths or masks are not applied"));
    tell(missed.markers, phrases(missed.markers, "{0} marker is not looked at; those at the ends of lines are",
                                 "{0} markers are not looked at; those at the ends of lines are"));
    tell(missed.pictures,
         figure ? phrases(missed.pictures, "{0} picture is left out; convert it by itself",
                          "{0} pictures are left out; convert it by itself")
                : phrases(missed.pictures, "{0} picture is not looked at; one upright PNG, JPEG or WebP within the file is",
                          "{0} pictures are not looked at; one upright PNG, JPEG or WebP within the file is"));
    tell(missed.pale, phrases(missed.pale, "{0} pale line is left out, such as those of a grid; darken them to have them drawn",
                              "{0} pale lines are left out, such as those of a grid; darken them to have them drawn"));
    tell(missed.shadows, phrases(missed.shadows, "{0} mostly clear shadow or gleam is left out",
                                 "{0} mostly clear shadows or gleams are left out"));
    tell(missed.broken,
         phrases(missed.broken, "{0} path has a fault and is drawn up to it", "{0} paths have a fault and are drawn up to it"));
    tell(missed.stretched, phrases(missed.stretched, "{0} line is wider in one direction, taken for even",
                                   "{0} lines are wider in one direction, taken for even"));
    tell(missed.colours,
         phrases(missed.colours, "{0} colour is not known, taken for black", "{0} colours are not known, taken for black"));
    tell(missed.selectors, phrases(missed.selectors, "{0} selector of a style sheet is not understood; tags, classes and ids are",
                                   "{0} selectors of style sheets are not understood; tags, classes and ids are"));
    tell(missed.foreign, phrases(missed.foreign, "{0} part in another language is not looked at",
                                 "{0} parts in other languages are not looked at"));
    return notes;
}

bool is_shadow(const Paint& fill, const Paint& stroke, bool blurred) {
    constexpr double kClear = 0.6;  // a setting
    return !fill.none && (fill.fades || blurred) && fill.opacity < kClear && (stroke.none || stroke.opacity < kClear);
}

bool paint_figure(Paint& fill, Paint& stroke, bool has_inside, double size) {
    const Paint none{true, 0, 1}, black{false, 0, 1};
    const bool filled = has_inside && fill.is_seen(), lined = stroke.shown() < kPaleLine;
    const bool pale = !lined && !filled && stroke.is_seen();
    const bool mark = filled && size <= kMark;
    stroke = lined || (filled && !mark) ? black : none;
    fill = mark ? black : none;
    return pale;
}

}  // namespace tactics
