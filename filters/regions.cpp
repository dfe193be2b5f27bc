// SPDX-License-Identifier: Apache-2.0
// Regions of a picture as textured areas with their outlines.
//
// A region must be as wide as what a finger needs to know a texture (tactics/layout/texture.h), with the clear room between the
// texture and the outline on both sides, and no part of one may be so thin that its two outlines come too near to each other.
// How many a reader can keep in mind is not known; 20 is this project's own.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>

#include "filters/histogram.h"
#include "filters/kmeans_colour.h"
#include "filters/kmeans_exact.h"
#include "filters/lab.h"
#include "filters/region_borders.h"
#include "filters/region_map.h"
#include "filters/spacing.h"
#include "tactics/filter.h"
#include "tactics/layout/texture.h"
#include "tactics/layout/texture_choice.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr Option kRegionsOptions[] = {
    {.name = "smallest",
     .type = Option::Type::length,
     .fallback = 0,
     .min = 0,
     .max = 500,
     .unit = "mm",
     .summary = "regions narrower than this join a neighbour; 0: as wide as a texture needs, or wider while there are too many "
                "regions"},
    {.name = "clear",
     .type = Option::Type::length,
     .fallback = 4.4,
     .min = 0.5,
     .max = 50,
     .unit = "mm",
     .summary = "minimum width of any part of a region, from outline to outline; convert sets what the medium needs"},
    {.name = "most",
     .type = Option::Type::whole,
     .fallback = 20,
     .min = 1,
     .max = 1000,
     .unit = "regions",
     .summary = "maximum number of regions if smallest is 0"},
};

double needed_by_texture(const Settings& settings) { return std::ceil(width_for_texture(settings.number("clear"))); }

struct RegionClasses {
    ClassMap map;
    std::vector<double> grey;                ///< of each class
    std::vector<std::vector<double>> apart;  ///< how different they look
    double pixel = 1;                        ///< mm
};

// Every so many pixels are enough for regions of that size, and bound memory and time whatever comes.
int step_of(const Image& image, double pixel, double clear) {
    constexpr double kPixelsAcross = 12;  // of the thinnest part that stays
    constexpr double kMostPixels = 2e6;
    const double many = std::sqrt(static_cast<double>(image.width) * image.height / kMostPixels);
    return static_cast<int>(std::max({1.0, std::floor(clear / kPixelsAcross / pixel), std::ceil(many)}));
}

// In CIELAB, where 2.3 is what an eye just sees; alike is what is nearer than some four of these.
double apart(const Lab& a, const Lab& b) { return 10 + std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

// The picture's own colours if they are few, else as few.
RegionClasses classes_of(Image image, const Settings& settings) {
    const std::size_t most = textures().size() + 1;
    const auto colour_at = [&](std::size_t pixel) {
        const std::uint8_t* at = image.pixels.data() + pixel * static_cast<std::size_t>(image.channels);
        return image.channels == 1 ? std::array{at[0], at[0], at[0]} : std::array{at[0], at[1], at[2]};
    };
    const std::size_t count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    const auto count_colours = [&] {
        std::map<std::array<std::uint8_t, 3>, std::uint8_t> colours;
        std::array<std::uint8_t, 3> last{};
        for (std::size_t i = 0; i < count && colours.size() <= most; ++i)
            if (const auto colour = colour_at(i); i == 0 || colour != last) colours.emplace(last = colour, 0);
        return colours;
    };
    auto colours = count_colours();
    if (colours.size() > most) {
        if (image.channels == 3) {
            image = kmeans_colour(std::move(image), static_cast<int>(most));
        } else {
            const auto cut = kmeans_exact(levels_of(image), static_cast<int>(most));
            for (auto& sample : image.pixels) sample = static_cast<std::uint8_t>(std::lround(cut.centres[cut.class_of(sample)]));
        }
        colours = count_colours();
    }
    const double pixel = image.mm_per_pixel > 0 ? image.mm_per_pixel : 1;
    const int step = step_of(image, pixel, settings.number("clear"));
    RegionClasses classes{{(image.width + step - 1) / step, (image.height + step - 1) / step, {}}, {}, {}, pixel * step};
    std::vector<Lab> labs;
    for (auto& [colour, number] : colours) {
        number = static_cast<std::uint8_t>(classes.grey.size());
        classes.grey.push_back(luma(colour.data()));
        labs.push_back(to_lab(colour[0], colour[1], colour[2]));
    }
    for (const Lab& one : labs) {
        auto& row = classes.apart.emplace_back();
        for (const Lab& other : labs) row.push_back(apart(one, other));
    }
    for (int y = 0; y < classes.map.height; ++y)
        for (int x = 0; x < classes.map.width; ++x) {
            const int column = std::min(x * step + step / 2, image.width - 1),
                      row = std::min(y * step + step / 2, image.height - 1);
            classes.map.classes.push_back(colours.at(colour_at(
                static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(column))));
        }
    return classes;
}

// Specks go to what they stand on, then thin parts and necks to what is beside them, and only then what is too small for a
// texture: a path that runs over a river does not make two small rivers of it.
Merging begin(const RegionClasses& classes, const Settings& settings) {
    // Smoothing and corners take some of it again. With necks closed and this, 20 photographs keep 3 gaps that are too narrow of
    // 24.
    constexpr double kSpare = 1.25;
    const double clear = kSpare * settings.number("clear") / classes.pixel;
    // The smallest first, measured anew each time: a region full of specks is as narrow as what is between them.
    ClassMap map = classes.map;
    for (double least = std::min(2.0, clear);; least = std::min(2 * least, clear)) {
        Merging specks(map, classes.apart);
        specks.merge(least, std::numeric_limits<std::size_t>::max());
        map = specks.result();
        if (least >= clear) break;
    }
    return {without_necks(without_thin_parts(map, clear), clear), classes.apart};
}

struct Choice {
    double smallest = 0;    ///< mm
    std::size_t found = 0;  ///< regions that are wide enough for a texture
};

// What a texture needs; if that leaves too many regions, whole mm that leave as few as are asked for.
Choice choose_smallest(Merging merging, const Settings& settings, double pixel) {
    constexpr double kMost = 500;
    Choice choice{std::min(needed_by_texture(settings), kMost), 0};
    merging.merge(choice.smallest / pixel, std::numeric_limits<std::size_t>::max());
    choice.found = merging.count();
    const auto most = static_cast<std::size_t>(settings.whole("most"));
    if (choice.found > most) {
        merging.merge(0, most);
        choice.smallest = std::clamp(std::floor(merging.narrowest() * pixel), choice.smallest, kMost);
    }
    return choice;
}

ChosenSetting settle_regions(const Artwork& artwork, Settings& settings) {
    if (settings.number("smallest") > 0) return {};
    const RegionClasses classes = classes_of(std::get<Image>(artwork), settings);
    const Choice choice = choose_smallest(begin(classes, settings), settings, classes.pixel);
    settings.set("smallest", to_text(choice.smallest) + "mm", "regions", "regions");
    const std::string chosen = "smallest=" + to_text(choice.smallest) + "mm";
    const std::size_t most = static_cast<std::size_t>(settings.whole("most"));
    if (choice.found > most)
        return {chosen, phrases(choice.found, "{0} region has room for a texture, {1} are enough",
                                "{0} regions have room for a texture, {1} are enough", std::to_string(most))};
    return {chosen, phrase("less wide regions have no room for a texture")};
}

void fit_regions(Settings& settings, const Medium& medium) {
    if (settings.is_default("clear"))
        settings.set("clear", to_text(least_apart(medium, medium.line, medium.line) + kMovedLater), "regions", "regions");
}

class Scene {
public:
    Scene(const Image& image, const Settings& settings) {
        RegionClasses classes = classes_of(image, settings);
        pixel_ = classes.pixel;
        const double own = image.mm_per_pixel > 0 ? image.mm_per_pixel : 1;
        width_ = image.width * own;
        height_ = image.height * own;
        grey_ = classes.grey;
        double smallest = settings.number("smallest");
        // What a small region leaves to a neighbour may be a thin part of it, and without that the neighbour may be small.
        // After three rounds less than a pixel in ten thousand changes (20 photographs).
        for (int round = 0; round < 3; ++round) {
            Merging merging = begin(classes, settings);
            if (smallest <= 0) smallest = choose_smallest(merging, settings, pixel_).smallest;
            merging.merge(smallest / pixel_, std::numeric_limits<std::size_t>::max());
            classes.map = merging.result();
        }
        regions_ = regions_of(classes.map);
        constexpr double kTolerance = 0.1;  // mm; as that of simplify
        borders_ = borders_of(regions_, kTolerance / pixel_);
    }

    Drawing draw() const {
        Drawing drawing{width_, height_, {}, {}, {}};
        for (const Border& border : borders_.borders) {
            if (border.other < 0) continue;
            const double step = std::abs(grey_of(border.region) - grey_of(static_cast<std::uint32_t>(border.other)));
            drawing.strokes.push_back(
                {placed(border.points), border.closed, LineClass::normal, static_cast<float>(std::max(step, 1.0))});
        }
        const std::vector<int> textures = textures_of_classes();
        std::vector<Area> areas(regions_.class_of.size());
        for (const BorderRing& ring : borders_.rings)
            if (auto points = placed(borders_.points_of(ring)); points.size() >= 3)
                areas[ring.region].rings.push_back(std::move(points));
        for (std::size_t region = 0; region < areas.size(); ++region) {
            areas[region].texture = textures[regions_.class_of[region]];
            if (areas[region].texture > 0 && !areas[region].rings.empty()) drawing.areas.push_back(std::move(areas[region]));
        }
        return drawing;
    }

private:
    double grey_of(std::uint32_t region) const { return grey_[regions_.class_of[region]]; }

    std::vector<Point> placed(std::vector<Point> points) const {
        for (Point& p : points) p = {std::clamp(p.x * pixel_, 0.0, width_), std::clamp(p.y * pixel_, 0.0, height_)};
        return points;
    }

    // Classes of which nothing is left take no texture from the others.
    std::vector<int> textures_of_classes() const {
        std::vector<std::size_t> number(grey_.size(), grey_.size());
        std::vector<double> grey;
        for (const std::uint8_t c : regions_.class_of)
            if (number[c] == grey_.size()) {
                number[c] = grey.size();
                grey.push_back(grey_[c]);
            }
        std::vector<std::vector<double>> shared(grey.size(), std::vector<double>(grey.size()));
        for (const Border& border : borders_.borders) {
            if (border.other < 0) continue;
            const std::size_t a = number[regions_.class_of[border.region]],
                              b = number[regions_.class_of[static_cast<std::size_t>(border.other)]];
            const double length = length_of(Stroke{border.points, border.closed}) * pixel_;
            shared[a][b] += length;
            shared[b][a] += length;
        }
        const std::vector<int> chosen = choose_textures(shared, grey);
        std::vector<int> textures(grey_.size(), 0);
        for (std::size_t c = 0; c < grey_.size(); ++c)
            if (number[c] < grey.size()) textures[c] = chosen[number[c]];
        return textures;
    }

    double pixel_ = 1, width_ = 0, height_ = 0;  // mm
    std::vector<double> grey_;
    RegionMap regions_;
    RegionBorders borders_;
};

Artwork apply_regions(Artwork artwork, const Settings& settings) { return Scene(std::get<Image>(artwork), settings).draw(); }

}  // namespace

extern const Filter regions_filter;
const Filter regions_filter{
    .name = "regions",
    .summary =
        "turns regions of one grey or colour into textured areas with outlines; small and thin regions join their "
        "neighbours",
    .takes = static_cast<Kinds>(Kind::picture),
    .gives = static_cast<Kinds>(Kind::drawing),
    .uses_colour = true,
    .options = kRegionsOptions,
    .apply = apply_regions,
    .settle = settle_regions,
    .fit = fit_regions,
};

}  // namespace tactics
