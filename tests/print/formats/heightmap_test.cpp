// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <png.h>

#include <cmath>
#include <cstring>
#include <map>
#include <random>

#include "print/format.h"
#include "tactics/braille/braille.h"
#include "tactics/error.h"
#include "tactics/units.h"

namespace tactics::heightmap_test {
namespace {

struct Heights {
    int width = 0, height = 0;
    unsigned per_metre = 0;
    std::map<std::string, std::string> text;
    std::vector<std::uint16_t> samples;
    double pitch() const { return parse_number(text.at("tactics:pitch-mm")).value(); }
    double at(int x, int y) const {
        const double low = parse_number(text.at("tactics:black-mm")).value(),
                     high = parse_number(text.at("tactics:white-mm")).value();
        return low + (high - low) *
                         samples[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)] /
                         65535;
    }
};

// By libpng, which the writer does not use.
Heights read(const std::string& bytes) {
    struct Input {
        const std::string& bytes;
        std::size_t at = 0;
    } input{bytes};
    png_structp png = png_create_read_struct(
        PNG_LIBPNG_VER_STRING, nullptr,
        [](png_structp, png_const_charp message) {
            ADD_FAILURE() << message;
            throw std::runtime_error(message);
        },
        [](png_structp, png_const_charp message) { ADD_FAILURE() << message; });
    png_infop info = png_create_info_struct(png);
    png_set_read_fn(png, &input, [](png_structp reader, png_bytep out, png_size_t size) {
        Input& from = *static_cast<Input*>(png_get_io_ptr(reader));
        ASSERT_LE(size, from.bytes.size() - from.at);
        std::memcpy(out, from.bytes.data() + from.at, size);
        from.at += size;
    });
    png_read_info(png, info);
    EXPECT_EQ(png_get_bit_depth(png, info), 16);
    EXPECT_EQ(png_get_color_type(png, info), PNG_COLOR_TYPE_GRAY);
    Heights heights;
    heights.width = static_cast<int>(png_get_image_width(png, info));
    heights.height = static_cast<int>(png_get_image_height(png, info));
    heights.per_metre = png_get_x_pixels_per_meter(png, info);
    EXPECT_EQ(png_get_y_pixels_per_meter(png, info), heights.per_metre);
    std::vector<unsigned char> row(png_get_rowbytes(png, info));
    for (int y = 0; y < heights.height; ++y) {
        png_read_row(png, row.data(), nullptr);
        for (std::size_t x = 0; x < row.size(); x += 2)
            heights.samples.push_back(static_cast<std::uint16_t>(row[x] << 8 | row[x + 1]));
    }
    png_read_end(png, info);
    png_textp texts = nullptr;
    int count = 0;
    png_get_text(png, info, &texts, &count);
    for (int i = 0; i < count; ++i) heights.text[texts[i].key] = texts[i].text;
    EXPECT_EQ(input.at, bytes.size());
    png_destroy_read_struct(&png, &info, nullptr);
    return heights;
}

std::string encoded(const Page& page, std::initializer_list<std::pair<const char*, const char*>> options = {}) {
    const Format* format = find_format("heightmap");
    Settings settings(format->options);
    for (const auto& [name, value] : options) settings.set(name, value, "", "heightmap");
    return format->encode(page, settings);
}

Page small_page() {
    Page page;
    page.width = 40;
    page.height = 30;
    page.live = {1, 1, 38, 28};
    page.braille_dot = 1.6;
    return page;
}

double distance(Point p, Point a, Point b) {
    const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
    const double t = square > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0;
    return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

// A round back: a circle through both edges and the crest, with its centre below the ground.
double round_back(double d, double r, double h) {
    if (d > r) return 0;
    if (h > r) return h * std::sqrt(1 - d / r * (d / r));
    const double below = (r * r - h * h) / (2 * h);
    return std::sqrt((h + below) * (h + below) - d * d) - below;
}

// The twin: every sample against every stroke.
double height_at(const Page& page, Point at, double h, bool flat) {
    double highest = 0;
    for (const PageStroke& stroke : page.strokes)
        for (std::size_t i = 0; i + 1 < stroke.points.size() + (stroke.closed ? 1 : 0); ++i) {
            const double d = distance(at, stroke.points[i], stroke.points[(i + 1) % stroke.points.size()]), r = stroke.width / 2;
            highest = std::max(highest, flat ? (d <= r ? h : 0) : round_back(d, r, h));
        }
    for (const BrailleLine& line : page.braille)
        for (const Point& dot : dots_of(line, page.cell))
            highest = std::max(highest, round_back(std::hypot(at.x - dot.x, at.y - dot.y), page.braille_dot / 2, h));
    return highest;
}

void expect_twin(const Page& page, const Heights& heights, double h, bool flat) {
    double worst = 0;
    for (int y = 0; y < heights.height; ++y)
        for (int x = 0; x < heights.width; ++x) {
            const Point at{(x + 0.5) * heights.pitch(), (y + 0.5) * heights.pitch()};
            worst = std::max(worst, std::abs(heights.at(x, y) - height_at(page, at, h, flat)));
        }
    EXPECT_LE(worst, h / 65535);
}

TEST(HeightMap, LinesAndDotsAreRaisedToTheTrueDistance) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> x(-1, 41), y(-1, 31), width(0.7, 3);
    for (int i = 0; i < 4; ++i) {
        Page page = small_page();
        for (int k = 0; k < 6; ++k)
            page.strokes.push_back(
                {{{x(random), y(random)}, {x(random), y(random)}, {x(random), y(random)}}, k % 2 == 0, width(random)});
        page.strokes.push_back({{{5, 5}, {5, 5}}, false, 2});
        page.braille.push_back({{3, 3}, {0x3F, 0x15, 0xFF}});
        expect_twin(page, read(encoded(page)), 0.5, false);
        expect_twin(page, read(encoded(page, {{"profile", "flat"}, {"pitch", "0.13"}})), 0.5, true);
        expect_twin(page, read(encoded(page, {{"height", "2"}, {"pitch", "0.21"}})), 2, false);
    }
}

TEST(HeightMap, SaysHowHighAndHowWideItIs) {
    Page page = small_page();
    page.strokes.push_back({{{10.05, 15.05}, {30.05, 15.05}}, false, 2});
    const std::string bytes = encoded(page);
    const Heights heights = read(bytes);
    EXPECT_EQ(heights.width, 400);
    EXPECT_EQ(heights.height, 300);
    EXPECT_EQ(heights.per_metre, 10'000u);
    EXPECT_EQ(
        heights.text,
        (std::map<std::string, std::string>{
            {"tactics:pitch-mm", "0.1"}, {"tactics:black-mm", "0"}, {"tactics:white-mm", "0.5"}, {"tactics:profile", "round"}}));
    EXPECT_DOUBLE_EQ(heights.at(200, 150), 0.5);  // on the crest
    EXPECT_DOUBLE_EQ(heights.at(0, 0), 0);
    EXPECT_EQ(bytes, encoded(page));
}

TEST(HeightMap, AreasAndPicturesAreFlat) {
    Page page = small_page();
    page.areas.push_back({{{{5, 5}, {15, 5}, {15, 15}, {5, 15}}, {{8, 8}, {12, 8}, {12, 12}, {8, 12}}}});
    page.areas.push_back({{{{9, 9}, {11, 9}, {10, 11}}}});  // an island of its own in the hole
    Bitmap picture;
    picture.width = 10;
    picture.height = 3;
    picture.place = {20, 5, 10, 3};
    picture.bits = {0x80, 0x40, 0xFF, 0xC0, 0x00, 0x00};
    page.picture = picture;
    const Heights heights = read(encoded(page));
    for (int y = 0; y < heights.height; ++y)
        for (int x = 0; x < heights.width; ++x) {
            const double px = (x + 0.5) / 10, py = (y + 0.5) / 10;
            const bool square = px > 5 && px < 15 && py > 5 && py < 15 && !(px > 8 && px < 12 && py > 8 && py < 12);
            const bool island = py > 9 && py < 11 && std::abs(px - 10) < (11 - py) / 2;
            const bool black = px > 20 && px < 30 && py > 5 && py < 7 && (py > 6 || px < 21 || px > 29);
            ASSERT_DOUBLE_EQ(heights.at(x, y), square || island || black ? 0.5 : 0) << px << "," << py;
        }
}

TEST(HeightMap, CornersOnARowOfSamplesCountOnce) {
    Page page = small_page();
    page.areas.push_back({{{{20, 4.95}, {31, 12.05}, {22, 25.05}, {8, 17.05}}}});
    const Heights heights = read(encoded(page));
    int filled = 0;
    for (int y = 0; y < heights.height; ++y)
        for (int x = 0; x < heights.width; ++x) filled += heights.at(x, y) > 0 ? 1 : 0;
    // By the shoelace formula, in samples; the outline of 60 mm is uncertain by half a sample at most.
    const double area = (20 * 12.05 - 31 * 4.95 + 31 * 25.05 - 22 * 12.05 + 22 * 17.05 - 8 * 25.05 + 8 * 4.95 - 20 * 17.05) / 2;
    EXPECT_NEAR(filled, area * 100, 100);
    EXPECT_EQ(heights.at(200, 120), 0.5);
    EXPECT_EQ(heights.at(395, 120), 0);
    EXPECT_EQ(heights.at(200, 170), 0.5);
    EXPECT_EQ(heights.at(4, 170), 0);
}

TEST(HeightMap, RefusesMoreSamplesThanItShould) {
    Page page = small_page();
    page.width = page.height = 5000;
    try {
        encoded(page);
        FAIL() << "2500 million samples";
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(),
                     "heightmap: 50000 x 50000 samples are over the limit of 400 million; take a larger pitch or smaller paper");
    }
}

TEST(HeightMap, ManySmallPagesAndNothingOnThem) {
    for (const double size : {0.01, 0.1, 0.31, 5.0}) {
        Page page;
        page.width = page.height = size;
        const Heights heights = read(encoded(page, {{"pitch", "0.3"}}));
        EXPECT_EQ(heights.width, std::max(1, static_cast<int>(std::lround(size / 0.3))));
    }
}

TEST(HeightMap, EndsOfNamesTellIt) {
    EXPECT_EQ(format_of_path("out/Page.Height.PNG"), find_format("heightmap"));
    EXPECT_EQ(format_of_path("page.brf"), find_format("brf"));
}

}  // namespace
}  // namespace tactics::heightmap_test
