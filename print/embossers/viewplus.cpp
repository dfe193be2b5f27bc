// SPDX-License-Identifier: Apache-2.0
// ViewPlus (Tiger) machines: a grey picture with a pixel a dot, 20 to the inch, for their own printer driver.
//
// No raster language of theirs is published; the road that works is the driver of the operating system, which raises a dot the
// higher the darker its pixel is. The picture is to be printed at its own size: lp -o ppi=20.
#include <algorithm>
#include <cmath>
#include <vector>

#include "print/dots.h"
#include "print/embosser.h"
#include "print/format.h"
#include "print/machines/machines.h"
#include "print/png_file.h"

namespace tactics {

namespace {

constexpr double kPitch = 1.27;  // mm
constexpr double kLowest = 10;   // percent: a lower dot is none

constexpr Option lower_dots(std::string_view name, std::string_view summary) {
    return {
        .name = name, .type = Option::Type::number, .fallback = 0, .min = 0, .max = 100, .unit = "percent", .summary = summary};
}

constexpr Option kViewplusOptions[] = {
    lower_dots("pattern",
               "height of the dots of patterns; drawn lines and braille have the full height. 0: full or half, by which kinds of "
               "lines there are"),
    lower_dots("inner", "height of the dots of lines inside things; 0: likewise; at least 10"),
    lower_dots("axes", "height of the dots of axes, ticks, lead lines, scale bars and marks; 0: likewise; at least 10"),
    lower_dots("grid", "height of the dots of grid lines; 0: likewise; at least 10"),
};

constexpr ProtocolFact kViewplusFacts[] = {
    {"dots stand 1/20 inch apart", "libembosser; ViewPlus's product pages", Confidence::good},
    {"the darker a dot, the higher it is", "ViewPlus's driver, at second hand", Confidence::medium},
    {"cells are 6.35 mm wide, lines 10.16 mm: 5 and 8 dots", "libembosser", Confidence::medium},
    {"the print queue does not smooth the picture at 20 dots per inch", "this project", Confidence::uncertain},
};

// We know no source for its number of dot heights; we send down, half and full.
DotSetting viewplus_dots(const Settings& settings) {
    DotSetting set{.cell = {2 * kPitch, 5 * kPitch, 8 * kPitch, 1.5}, .bed = DotBed{{kPitch / 2, kPitch / 2}, kPitch, 3}};
    set.heights.levels = 3;
    for (std::size_t kind = 1; kind < kLineKinds; ++kind)
        if (const double wished = settings.number(kKindSettings[kind]); wished > 0)
            set.heights.wished[kind] = std::max(kLowest, wished) / 100;
    return set;
}

// A grey of a pixel, the darker the higher.
std::uint8_t grey_of(double share) { return static_cast<std::uint8_t>(255 - std::lround(255 * share)); }

std::string encode(const Page& page, const Settings&) {
    const Dots kinds = kinds_on_bed(page);
    const auto pixels = [](double mm) { return static_cast<int>(std::floor(mm / kPitch + 1e-6)); };
    const int width = pixels(page.width), height = pixels(page.height);
    PngFile png(static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), 8);
    png.scale(1000 / kPitch, 1000 / kPitch);
    std::vector<std::uint8_t> row(static_cast<std::size_t>(width) + 1);
    for (int y = 0; y < height; ++y) {
        std::fill(row.begin() + 1, row.end(), std::uint8_t{255});
        for (int x = 0; x < std::min(width, kinds.columns) && y < kinds.rows; ++x)
            if (const std::uint8_t dot = kinds.at(x, y); dot != 0)
                row[static_cast<std::size_t>(x) + 1] = grey_of(page.heights.share(kind_of_dot(dot)));
        png.add_row(row);
    }
    return png.finish();
}

constexpr Embosser kViewplusEmbosser{
    .models = "ViewPlus Columbia, Delta, Elite, EmBraille, Max, Premier, Rogue, SpotDot; APH PixBlaster",
    .called = "columbia delta elite embraille max premier rogue spotdot pixblaster tiger",
    .known_by = "viewplus tiger emprint pixblaster",
    .punch = punch_viewplus,
    .widest = 432,
    .facts = kViewplusFacts,
};

}  // namespace

extern const Format viewplus_format;
const Format viewplus_format{
    .name = "viewplus",
    .summary = "ViewPlus: a grey PNG at 20 dots per inch, to be printed at its own size by the ViewPlus driver",
    .medium = "embosser",
    .paper = "letter",
    .options = kViewplusOptions,
    .encode_page = encode,
    .embosser = &kViewplusEmbosser,
    .dots = viewplus_dots,
};

}  // namespace tactics
