// SPDX-License-Identifier: Apache-2.0
// What is not a photograph: a city map, a chart as a screen shows it, a line drawing.
#include <string>

#include "samples/draw/ink.h"
#include "samples/draw/scenes.h"

namespace tactics::samples {

namespace {
constexpr Colour kBlack{20, 20, 22}, kGrey{110, 112, 116}, kWhite{255, 255, 255};
}

Image draw_map(int size) {
    Ink ink(size, size * 3 / 4, {240, 236, 226});
    constexpr Colour kStreet{255, 255, 255}, kCasing{168, 160, 148}, kMain{246, 206, 110}, kMainCasing{176, 128, 40},
        kHouse{214, 206, 194};
    // Blocks of houses, then the park, then the river with its bridges, then the streets over all.
    for (int row = 0; row < 5; ++row)
        for (int column = 0; column < 8; ++column) {
            const float x = 30 + 122 * static_cast<float>(column), y = 30 + 146 * static_cast<float>(row);
            for (int k = 0; k < 3; ++k)
                ink.box(x + 8 + 33 * static_cast<float>(k), y + 14, 26, 42, kHouse),
                    ink.box(x + 8 + 33 * static_cast<float>(k), y + 78, 26, 38, kHouse);
        }
    const Spot park[] = {{586, 190}, {846, 190}, {846, 330}, {800, 420}, {586, 420}};
    ink.fill(park, {186, 214, 158});
    ink.line(park, 3, {104, 146, 84}, true);
    ink.fill(oval({720, 300}, 62, 34), {158, 198, 222});
    ink.line(oval({720, 300}, 62, 34), 2.5f, {74, 124, 164}, true);
    const Spot bends[] = {{-40, 560}, {120, 520}, {260, 560}, {420, 640}, {560, 600}, {700, 520}, {860, 540}, {1040, 470}};
    const auto river = curve(bends);
    ink.line(river, 76, {74, 124, 164});
    ink.line(river, 70, {158, 198, 222});
    const auto street = [&](std::span<const Spot> path, float width, Colour casing, Colour face) {
        ink.line(path, width + 5, casing);
        ink.line(path, width, face);
    };
    for (const float x : {152.0f, 274.0f, 396.0f, 884.0f}) {
        const Spot path[] = {{x, -10}, {x, 460}};
        street(path, 13, kCasing, kStreet);
        const Spot south[] = {{x, 650}, {x, 770}};
        street(south, 13, kCasing, kStreet);
    }
    for (const float y : {176.0f, 322.0f}) {
        const Spot path[] = {{-10, y}, {572, y}};
        street(path, 13, kCasing, kStreet);
    }
    const Spot station_road[] = {{-10, 30}, {330, 90}, {572, 176}, {860, 176}, {1010, 120}};
    street(station_road, 20, kMainCasing, kMain);
    const Spot bridge_road[] = {{518, -10}, {518, 380}, {490, 520}, {480, 770}};
    street(bridge_road, 24, kMainCasing, kMain);
    const Spot quay[] = {{-10, 470}, {130, 440}, {280, 476}, {430, 540}, {500, 560}};
    street(curve(quay), 13, kCasing, kStreet);
    ink.disc({518, 176}, 26, kMainCasing);
    ink.disc({518, 176}, 22, kMain);
    ink.disc({518, 176}, 10, {186, 214, 158});
    const Colour name{52, 52, 58};
    ink.text({640, 388}, 17, "City Park", {44, 84, 40});
    ink.text({680, 306}, 11, "Pond", {30, 72, 110});
    ink.text({160, 556}, 18, "River Ember", {30, 72, 110});
    ink.text({84, 168}, 10, "Mill Street", name);
    ink.text({300, 314}, 10, "Corn Street", name);
    ink.text({690, 170}, 12, "Station Road", name);
    ink.text({548, 700}, 14, "Old Bridge Road", name);
    ink.text({560, 60}, 16, "Market", name);
    ink.line(std::vector<Spot>{{940, 720}, {940, 650}}, 5, kBlack);
    ink.fill(std::vector<Spot>{{926, 662}, {940, 630}, {954, 662}}, kBlack);
    ink.text({930, 622}, 18, "N", kBlack);
    return std::move(ink).take();
}

Image draw_chart(int size) {
    Ink ink(size, size * 5 / 8, kWhite);
    constexpr Colour kBar{66, 114, 180}, kLine{206, 84, 46}, kGrid{222, 224, 228};
    ink.box(0, 0, 1000, 34, {232, 234, 238});  // the window's title bar
    for (int i = 0; i < 3; ++i) ink.disc({18 + 22 * static_cast<float>(i), 17}, 7, {176, 180, 188});
    ink.text({390, 24}, 13, "Rainfall.ods", kGrey);
    ink.text({250, 84}, 24, "Rain and sun in a year", kBlack);
    const float left = 110, base = 540, top = 130, width = 780;
    for (int i = 0; i <= 5; ++i) {
        const float y = base - (base - top) * static_cast<float>(i) / 5;
        ink.line(std::vector<Spot>{{left, y}, {left + width, y}}, 1.5f, kGrid);
        ink.text({left - 44, y + 6}, 13, std::to_string(20 * i), kGrey);
    }
    constexpr int kRain[] = {78, 62, 55, 41, 50, 58, 66, 60, 47, 64, 80, 92},
                  kSun[] = {18, 26, 40, 56, 70, 78, 82, 76, 58, 38, 22, 14};
    constexpr std::string_view kMonths[] = {"JAN", "FEB", "MAR", "APR", "MAY", "JUN", "JUL", "AUG", "SEP", "OCT", "NOV", "DEC"};
    std::vector<Spot> sun;
    for (int i = 0; i < 12; ++i) {
        const float x = left + width * (static_cast<float>(i) + 0.5f) / 12, unit = (base - top) / 100;
        const float height = unit * static_cast<float>(kRain[i]);
        ink.box(x - 22, base - height, 44, height, kBar);
        ink.text({x - 18, base + 24}, 13, kMonths[i], kGrey);
        sun.push_back({x, base - unit * static_cast<float>(kSun[i])});
    }
    ink.line(sun, 5, kLine);
    for (const Spot p : sun) ink.disc(p, 8, kLine);
    ink.line(std::vector<Spot>{{left, top - 10}, {left, base}, {left + width + 10, base}}, 3, kBlack);
    ink.box(330, 588, 20, 16, kBar);
    ink.text({360, 603}, 15, "Rain, mm", kBlack);
    ink.line(std::vector<Spot>{{540, 596}, {570, 596}}, 5, kLine);
    ink.text({580, 603}, 15, "Sun, %", kBlack);
    return std::move(ink).take();
}

Image draw_line_art(int size) {
    // A sail boat on waves, with a gull and the sun: ink on paper.
    Ink ink(size, size, {252, 252, 250});
    const auto stroke = [&](std::span<const Spot> points, float width = 7, bool closed = false) {
        ink.line(points, width, kBlack, closed);
    };
    const Spot hull[] = {{210, 640}, {300, 740}, {660, 740}, {790, 640}};
    stroke(curve(std::vector<Spot>{hull[0], {246, 700}, hull[1]}));
    stroke(std::vector<Spot>{hull[1], hull[2]});
    stroke(curve(std::vector<Spot>{hull[2], {736, 706}, hull[3]}));
    stroke(std::vector<Spot>{hull[0], hull[3]});
    stroke(std::vector<Spot>{{236, 668}, {764, 668}}, 4);
    stroke(std::vector<Spot>{{480, 640}, {480, 130}}, 10);
    stroke(curve(std::vector<Spot>{{500, 160}, {640, 330}, {740, 580}}));
    stroke(std::vector<Spot>{{740, 580}, {500, 600}, {500, 160}});
    stroke(curve(std::vector<Spot>{{462, 190}, {360, 380}, {250, 590}}));
    stroke(std::vector<Spot>{{250, 590}, {462, 600}, {462, 190}});
    stroke(std::vector<Spot>{{500, 300}, {604, 290}}, 4);
    stroke(std::vector<Spot>{{500, 450}, {682, 436}}, 4);
    ink.fill(std::vector<Spot>{{480, 130}, {560, 106}, {480, 82}}, kBlack);
    stroke(std::vector<Spot>{{480, 80}, {480, 140}}, 8);
    stroke(oval({820, 190}, 76, 76), 7, true);
    for (int i = 0; i < 8; ++i) {
        const auto ray = oval({820, 190}, 100, 100, 45.0f * static_cast<float>(i), 45.0f * static_cast<float>(i) + 0.1f);
        const auto end = oval({820, 190}, 136, 136, 45.0f * static_cast<float>(i), 45.0f * static_cast<float>(i) + 0.1f);
        stroke(std::vector<Spot>{ray.front(), end.front()});
    }
    for (int row = 0; row < 2; ++row) {
        std::vector<Spot> wave;
        for (int i = 0; i <= 16; ++i)
            wave.push_back({60 + 55 * static_cast<float>(i), (i % 2 == 0 ? 800.0f : 774.0f) + 80 * static_cast<float>(row)});
        stroke(curve(wave));
    }
    stroke(oval({150, 260}, 44, 40, 190, 330));
    stroke(oval({232, 260}, 44, 40, 210, 350));
    return std::move(ink).take();
}

}  // namespace tactics::samples
