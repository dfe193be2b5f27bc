// SPDX-License-Identifier: Apache-2.0
// A field of colours, such as a heat map or filled contours, as a few levels: lines between them, and a texture for each.
//
// The colour bar is the key: it is cut into the same levels with the same textures, beside the numbers that it has.
#include <algorithm>
#include <cmath>

#include "filters/darken.h"
#include "filters/field_levels.h"
#include "filters/region_borders.h"
#include "filters/spacing.h"
#include "filters/traced.h"
#include "tactics/filter.h"
#include "tactics/layout/texture.h"
#include "tactics/medium.h"
#include "tactics/page.h"
#include "tactics/text/number.h"

namespace tactics {

namespace {

constexpr Option kLevelsOptions[] = {
    {.name = "most",
     .type = Option::Type::whole,
     .fallback = 4,
     .min = 2,
     .max = 6,
     .unit = "levels",
     .summary = "maximum number of levels, each as high as the others"},
    {.name = "smallest",
     .type = Option::Type::length,
     .fallback = 9,
     .min = 2,
     .max = 100,
     .unit = "mm",
     .summary = "regions of a level that are narrower than this join a neighbour"},
    {.name = "clear",
     .type = Option::Type::length,
     .fallback = 4.4,
     .min = 0.5,
     .max = 50,
     .unit = "mm",
     .summary = "minimum distance of lines; convert sets what the medium needs"},
    {.name = "textures",
     .type = Option::Type::choice,
     .fallback = 1,
     .min = 0,
     .max = 1,
     .summary = "whether each level has a texture; no: only lines between levels",
     .choices = "no yes"},
    {.name = "shortest",
     .type = Option::Type::length,
     .fallback = 12,
     .min = 2,
     .max = 500,
     .unit = "mm",
     .summary = "lines outside the field, and on it, that are shorter than this, such as ticks, are left out"},
};

constexpr double kLevelsTolerance = 0.1;  // mm; as that of simplify
constexpr double kBesideFrame = 3;        // mm: a line as near to a frame is the frame, or its blur
constexpr double kMostOutwards = 5;       // mm that a bar grows towards its numbers

// From the lowest level to the highest, the more ink the higher; neighbours differ in kind. Number of textures.inc.
std::vector<int> textures_for(std::size_t levels) {
    constexpr int kBlank = 0, kCoarseDots = 1, kLevelLines = 2, kUprightLines = 3, kSlantingDashes = 4, kFineDots = 5;
    switch (levels) {
        case 1: return {kBlank};
        case 2: return {kBlank, kLevelLines};
        case 3: return {kBlank, kCoarseDots, kLevelLines};
        case 4: return {kBlank, kCoarseDots, kLevelLines, kFineDots};
        case 5: return {kBlank, kCoarseDots, kUprightLines, kLevelLines, kFineDots};
        default: return {kBlank, kCoarseDots, kUprightLines, kSlantingDashes, kLevelLines, kFineDots};
    }
}

std::vector<Point> box_corners(double left, double top, double right, double bottom) {
    return {{left, top}, {right, top}, {right, bottom}, {left, bottom}};
}

// The picture by its lightness, for one that has no field.
ColourField whole_by_lightness(const Image& picture) {
    return {all_of(picture.width, picture.height), ColourScale({{0, {255, 255, 255}}, {1, {0, 0, 0}}}), std::nullopt};
}

class LevelsPage {
public:
    LevelsPage(const Image& picture, const Settings& settings)
        : picture_(picture), settings_(settings), pixel_(picture.mm_per_pixel > 0 ? picture.mm_per_pixel : 1) {
        drawing_.width = picture.width * pixel_;
        drawing_.height = picture.height * pixel_;
    }

    Drawing draw() && {
        std::vector<ColourField> fields = colour_fields_in(picture_);
        const bool found = !fields.empty();
        if (!found) {
            fields.push_back(whole_by_lightness(picture_));
            drawing_.remarks.push_back(
                phrase("No field of colours was found; the lightness of the whole picture is drawn as levels."));
        }
        InkMap marks(picture_.width, picture_.height);
        for (const ColourField& field : fields) add(field, marks);
        if (!found && drawing_.strokes.empty()) return std::move(drawing_);  // of one lightness: there is nothing to be framed
        for (const ColourField& field : fields) frame(field.box);
        if (found) add_rest(fields, std::move(marks));
        return std::move(drawing_);
    }

private:
    bool has_textures() const { return settings_.choice("textures") == "yes"; }

    void add(const ColourField& field, InkMap& marks) {
        const FieldLevels levels = field_levels_of(picture_, field, ticks_of(picture_, field),
                                                   {settings_.whole("most"), settings_.number("smallest") / pixel_});
        const std::vector<int> textures = textures_for(levels.limits.size() + 1);
        const RegionMap map = regions_of(levels.map);
        const RegionBorders borders = borders_of(map, kLevelsTolerance / pixel_);
        for (const Border& border : borders.borders)
            if (border.other >= 0) drawing_.strokes.push_back({placed(border.points, field.box), border.closed});
        std::vector<Area> areas(map.class_of.size());
        for (const BorderRing& ring : borders.rings)
            if (auto points = placed(borders.points_of(ring), field.box); points.size() >= 3)
                areas[ring.region].rings.push_back(std::move(points));
        for (std::size_t region = 0; region < areas.size(); ++region) {
            areas[region].texture = textures[map.class_of[region]];
            if (has_textures() && areas[region].texture > 0 && !areas[region].rings.empty())
                drawing_.areas.push_back(std::move(areas[region]));
        }
        if (field.bar) add_bar(field, levels.limits, textures);
        for (int y = 0; y < levels.map.height; ++y)
            for (int x = 0; x < levels.map.width; ++x)
                if (levels.marked[levels.map.index(x, y)]) marks.row(y + field.box.top)[x + field.box.left] = 1;
        tell(field, textures);
    }

    void tell(const ColourField& field, const std::vector<int>& textures) {
        const std::size_t count = textures.size();
        drawing_.remarks.push_back(
            phrases(count, "A field of colours is drawn as {0} level.", "A field of colours is drawn as {0} levels."));
        if (!has_textures() || count < 2) return;
        std::vector<Phrase> names;
        for (const int texture : textures) names.push_back(texture == 0 ? phrase("blank") : name_of_texture(texture));
        const Phrase row = row_of(names);
        drawing_.remarks.push_back(!field.bar           ? phrase("From its light colours to the dark ones: {0}.", row)
                                   : field.bar->upright ? phrase("From the bottom of its colour bar to the top: {0}.", row)
                                                        : phrase("From the left of its colour bar to the right: {0}.", row));
    }

    void frame(const PixelBox& box) {
        drawing_.strokes.push_back(
            {box_corners(box.left * pixel_, box.top * pixel_, box.right * pixel_, box.bottom * pixel_), true});
    }

    // As long as it is, and as wide as a texture needs: towards the field as far as there is room, and then towards its numbers.
    Rect widened(const ColourBar& bar, const PixelBox& field) const {
        const PixelBox& box = bar.box;
        Rect rect{box.left * pixel_, box.top * pixel_, box.width() * pixel_, box.height() * pixel_};
        const double clear = settings_.number("clear"), wish = width_for_texture(clear);
        const double more = std::max(0.0, wish - (bar.upright ? rect.width : rect.height));
        const bool after = bar.upright ? box.left >= field.right : box.top >= field.bottom;
        const int between = bar.upright ? (after ? box.left - field.right : field.left - box.right)
                                        : (after ? box.top - field.bottom : field.top - box.bottom);
        const double inwards = std::clamp(between * pixel_ - clear, 0.0, more),
                     outwards = std::min(more - inwards, kMostOutwards);
        double& begin = bar.upright ? rect.left : rect.top;
        double& size = bar.upright ? rect.width : rect.height;
        const double end = begin + size + (after ? outwards : inwards);
        begin = std::max(0.0, begin - (after ? inwards : outwards));
        size = std::min(end, bar.upright ? drawing_.width : drawing_.height) - begin;
        return rect;
    }

    void add_bar(const ColourField& field, const std::vector<double>& limits, const std::vector<int>& textures) {
        const ColourBar& bar = *field.bar;
        if (std::find(bars_.begin(), bars_.end(), bar.box) != bars_.end()) return;
        bars_.push_back(bar.box);
        const Rect place = widened(bar, field.box);
        const double left = place.left, top = place.top, right = left + place.width, bottom = top + place.height;
        std::vector<double> ends{0};
        ends.insert(ends.end(), limits.begin(), limits.end());
        ends.push_back(1);
        drawing_.strokes.push_back({box_corners(left, top, right, bottom), true});
        for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
            const double low = bar.upright ? bottom - ends[i] * (bottom - top) : left + ends[i] * (right - left);
            const double high = bar.upright ? bottom - ends[i + 1] * (bottom - top) : left + ends[i + 1] * (right - left);
            if (i > 0)
                drawing_.strokes.push_back({bar.upright ? std::vector<Point>{{left, low}, {right, low}}
                                                        : std::vector<Point>{{low, top}, {low, bottom}}});
            if (has_textures() && textures[i] > 0)
                drawing_.areas.push_back(
                    {{bar.upright ? box_corners(left, high, right, low) : box_corners(low, top, high, bottom)},
                     Role::line,
                     textures[i]});
        }
    }

    // Axes and other lines outside, and curves on the field.
    void add_rest(const std::vector<ColourField>& fields, InkMap marks) {
        constexpr int kInk = 192;  // grey levels; paler is a grid
        const Image ink = ink_on_white(picture_);
        std::vector<bool> taken(static_cast<std::size_t>(picture_.width) * static_cast<std::size_t>(picture_.height));
        const int beside = static_cast<int>(std::ceil(kBesideFrame / pixel_));
        const auto take = [&](const PixelBox& box) {
            for (int y = std::max(0, box.top - beside); y < std::min(picture_.height, box.bottom + beside); ++y)
                for (int x = std::max(0, box.left - beside); x < std::min(picture_.width, box.right + beside); ++x)
                    taken[static_cast<std::size_t>(y) * static_cast<std::size_t>(picture_.width) + static_cast<std::size_t>(x)] =
                        true;
        };
        for (const ColourField& field : fields) take(field.box);
        for (const PixelBox& bar : bars_) take(bar);
        for (int y = 0; y < picture_.height; ++y)
            for (int x = 0; x < picture_.width; ++x)
                if (!taken[static_cast<std::size_t>(y) * static_cast<std::size_t>(picture_.width) +
                           static_cast<std::size_t>(x)] &&
                    ink.row(y)[x] < kInk)
                    marks.row(y)[x] = 1;
        add_lines(drawing_, std::move(marks), nullptr, nullptr, pixel_, {settings_.number("shortest"), 3, 2});
    }

    std::vector<Point> placed(std::vector<Point> points, const PixelBox& box) const {
        for (Point& p : points)
            p = {std::clamp((p.x + box.left) * pixel_, 0.0, drawing_.width),
                 std::clamp((p.y + box.top) * pixel_, 0.0, drawing_.height)};
        return points;
    }

    const Image& picture_;
    const Settings& settings_;
    double pixel_;  // mm
    std::vector<PixelBox> bars_;
    Drawing drawing_;
};

Artwork apply_levels(Artwork artwork, const Settings& settings) { return LevelsPage(std::get<Image>(artwork), settings).draw(); }

void fit_levels(Settings& settings, const Medium& medium) {
    if (settings.is_default("clear"))
        settings.set("clear", to_text(least_apart(medium, medium.line, medium.line) + kMovedLater) + "mm", "levels", "levels");
}

}  // namespace

extern const Filter levels_filter;
const Filter levels_filter{
    .name = "levels",
    .summary = "draws a field of colours that stand for values, such as a heat map, as a few levels, and lines around and on it",
    .takes = static_cast<Kinds>(Kind::picture),
    .gives = static_cast<Kinds>(Kind::drawing),
    .uses_colour = true,
    .options = kLevelsOptions,
    .apply = apply_levels,
    .fit = fit_levels,
};

}  // namespace tactics
