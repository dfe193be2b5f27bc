// SPDX-License-Identifier: Apache-2.0
// Height maps as files: what is written is read back, by us, by the libraries themselves and by another program.
#include "print/height_files.h"

#include <gtest/gtest.h>
#include <tiffio.h>

#include <cmath>
#include <map>
#include <random>

#include "print/format.h"
#include "tactics/error.h"
#include "tactics/relief/read_heights.h"
#include "tactics/units.h"
#include "tests/cli/tool.h"

namespace tactics::height_files_test {
namespace {

using namespace tests;

HeightFile read(const std::string& bytes, const HeightWish& wish = {}, const std::string& name = "test") {
    Source source = memory_source({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()}, name);
    return read_heights(source, wish);
}

// All samples are of 16 bits, the ends among them.
HeightMap noisy_map(int columns, int rows, double pitch, double low, double high) {
    std::mt19937 chance(3);
    HeightMap map{columns, rows, pitch, {}};
    for (int i = 0; i < columns * rows; ++i) {
        const unsigned sample = i == 0 ? 0 : i == 1 ? 65535 : chance() % 65536;
        map.heights.push_back(static_cast<float>(low + (high - low) * sample / 65535));
    }
    return map;
}

std::string png_of(const HeightFile& file) { return height_png(sheet_of(file.map, file.low, file.high), rows_of(file.map)); }
std::string tiff_of(const HeightFile& file) { return height_tiff(sheet_of(file.map, file.low, file.high), rows_of(file.map)); }
std::string decimal_tiff_of(const HeightFile& file) {
    return height_tiff_decimal(sheet_of(file.map, file.low, file.high), rows_of(file.map));
}
std::string exr_of(const HeightFile& file) { return height_exr(sheet_of(file.map, file.low, file.high), rows_of(file.map)); }

HeightFile noisy_file(double low, double high) {
    HeightFile file;
    file.map = noisy_map(71, 45, 0.35, low, high);
    file.low = low;
    file.high = high;
    return file;
}

TEST(HeightFiles, SixteenBitsComeBackToTheByte) {
    for (const auto& [low, high] :
         std::vector<std::pair<double, double>>{{0, 0.5}, {-3, 40}, {10, 10.5}, {0, 300}, {-0.001, 0.0004}, {9900, 10000}}) {
        const HeightFile file = noisy_file(low, high);
        for (const auto& write : {png_of, tiff_of}) {
            const std::string bytes = write(file);
            const HeightFile back = read(bytes);
            EXPECT_EQ(back.map.columns, 71);
            EXPECT_EQ(back.map.rows, 45);
            EXPECT_EQ(back.map.pitch, 0.35);
            EXPECT_EQ(back.low, low);
            EXPECT_EQ(back.high, high);
            EXPECT_TRUE(back.notes.empty()) << back.notes.front().english();
            EXPECT_EQ(write(back), bytes) << low << " " << high;
        }
        // From one to the other nothing is lost either.
        EXPECT_EQ(png_of(read(tiff_of(read(png_of(file))))), png_of(file));
    }
}

TEST(HeightFiles, DecimalNumbersComeBackToTheBit) {
    HeightFile file = noisy_file(-2, 7);
    file.map.at(3, 4) = 0.1f;
    for (const auto& write : {decimal_tiff_of, exr_of}) {
        const std::string bytes = write(file);
        const HeightFile back = read(bytes);
        EXPECT_EQ(back.map.heights, file.map.heights);
        EXPECT_EQ(back.map.pitch, 0.35);
        EXPECT_EQ(back.low, -2);
        EXPECT_EQ(back.high, 7);
        EXPECT_TRUE(back.notes.empty()) << back.notes.front().english();
        EXPECT_EQ(write(back), bytes);
    }
    EXPECT_EQ(png_of(read(exr_of(read(png_of(file))))), png_of(read(png_of(file))));
    EXPECT_TRUE(holds(exr_of(file), "1970:01:01 00:00:00")) << "it holds the time of day";
}

// By libtiff, which the writer does not use.
TEST(HeightFiles, LibtiffReadsWhatIsWritten) {
    const HeightFile file = noisy_file(0, 5);
    for (const bool decimal : {false, true}) {
        const Folder folder;
        const std::string path = (folder / "map.tif").string();
        write_bytes(path, decimal ? decimal_tiff_of(file) : tiff_of(file));
        TIFF* tiff = TIFFOpen(path.c_str(), "r");
        ASSERT_NE(tiff, nullptr);
        std::uint32_t width = 0, height = 0;
        std::uint16_t bits = 0, format = 0, unit = 0;
        float across = 0, down = 0;
        const char* text = nullptr;
        TIFFGetField(tiff, TIFFTAG_IMAGEWIDTH, &width);
        TIFFGetField(tiff, TIFFTAG_IMAGELENGTH, &height);
        TIFFGetField(tiff, TIFFTAG_BITSPERSAMPLE, &bits);
        TIFFGetField(tiff, TIFFTAG_SAMPLEFORMAT, &format);
        TIFFGetField(tiff, TIFFTAG_RESOLUTIONUNIT, &unit);
        TIFFGetField(tiff, TIFFTAG_XRESOLUTION, &across);
        TIFFGetField(tiff, TIFFTAG_YRESOLUTION, &down);
        ASSERT_EQ(TIFFGetField(tiff, TIFFTAG_IMAGEDESCRIPTION, &text), 1);
        EXPECT_EQ(width, 71u);
        EXPECT_EQ(height, 45u);
        EXPECT_EQ(bits, decimal ? 32 : 16);
        EXPECT_EQ(format, decimal ? SAMPLEFORMAT_IEEEFP : SAMPLEFORMAT_UINT);
        EXPECT_EQ(unit, RESUNIT_CENTIMETER);
        EXPECT_NEAR(across, 10 / 0.35, 1e-4);
        EXPECT_EQ(across, down);
        EXPECT_EQ(std::string(text), "tactics:pitch-mm 0.35\ntactics:black-mm 0\ntactics:white-mm 5\n");
        std::vector<float> row(width);
        std::vector<std::uint16_t> samples(width);
        for (std::uint32_t y = 0; y < height; ++y) {
            ASSERT_EQ(TIFFReadScanline(tiff, decimal ? static_cast<void*>(row.data()) : samples.data(), y), 1);
            for (std::uint32_t x = 0; x < width; ++x) {
                const float expected = file.map.at(static_cast<int>(x), static_cast<int>(y));
                if (decimal)
                    ASSERT_EQ(row[x], expected);
                else
                    ASSERT_EQ(samples[x], std::lround(static_cast<double>(expected) / 5 * 65535)) << x << " " << y;
            }
        }
        TIFFClose(tiff);
    }
}

TEST(HeightFiles, AnotherProgramSeesTheSameHeights) {
    if (!has_tool("identify")) GTEST_SKIP() << "ImageMagick is not installed";
    const Folder folder;
    const HeightFile file = noisy_file(0, 5);
    write_bytes(folder / "map.png", png_of(file));
    write_bytes(folder / "map.tif", tiff_of(file));
    for (const char* name : {"map.png", "map.tif"}) {
        const Ending told = run_tool(folder, {"identify", "-format", "%w %h %z %[colorspace]", name});
        EXPECT_EQ(told.out, "71 45 16 Gray") << told.err;
        const Ending grey = run_tool(folder, {"convert", name, "-depth", "16", "-endian", "LSB", "gray:-"});
        ASSERT_EQ(grey.out.size(), 71u * 45 * 2) << grey.err;
        for (std::size_t i = 0; i < file.map.heights.size(); ++i) {
            const int sample = static_cast<unsigned char>(grey.out[2 * i]) | static_cast<unsigned char>(grey.out[2 * i + 1]) << 8;
            ASSERT_EQ(sample, std::lround(static_cast<double>(file.map.heights[i]) / 5 * 65535)) << name << " " << i;
        }
    }
}

// Libraries stop where they like; large maps have several strips.
TEST(HeightFiles, ManyStripsAreOneMap) {
    HeightFile file;
    file.map = noisy_map(700, 900, 0.1, 0, 2);
    file.low = 0;
    file.high = 2;
    for (const auto& write : {tiff_of, decimal_tiff_of}) {
        const HeightFile back = read(write(file));
        for (std::size_t i = 0; i < file.map.heights.size(); ++i)
            ASSERT_NEAR(back.map.heights[i], file.map.heights[i], 1e-6) << i;
    }
}

TEST(HeightFiles, HeightsOutsideTheRangeAreCutAndNoNumberIsLow) {
    HeightFile file = noisy_file(0, 1);
    file.map.heights = {-5, 5, std::nanf(""), INFINITY};
    file.map.columns = 4;
    file.map.rows = 1;
    for (const auto& write : {png_of, tiff_of}) EXPECT_EQ(read(write(file)).map.heights, (std::vector<float>{0, 1, 0, 1}));
}

// The page's formats are those files.
TEST(HeightFiles, OnePageIsTheSameHeightsInEveryFormat) {
    Page page;
    page.width = 30;
    page.height = 20;
    page.strokes.push_back({{{5, 5}, {25, 15}}, false, 2});
    const auto encoded = [&](const char* name, const char* samples = nullptr) {
        const Format* format = find_format(name);
        Settings settings(format->options);
        if (samples != nullptr) settings.set("samples", samples, "", name);
        return read(format->encode(page, settings));
    };
    const HeightFile png = encoded("heightmap"), tiff = encoded("heightmap-tiff"), decimal = encoded("heightmap-tiff", "decimal"),
                     exr = encoded("heightmap-exr");
    EXPECT_EQ(png.map.columns, 300);
    EXPECT_EQ(png.high, 0.5);
    EXPECT_EQ(tiff.map.heights, png.map.heights);
    EXPECT_EQ(decimal.map.heights, exr.map.heights);
    for (std::size_t i = 0; i < png.map.heights.size(); ++i) ASSERT_NEAR(decimal.map.heights[i], png.map.heights[i], 0.5 / 65535);
    EXPECT_EQ(format_of_path("a.height.TIF"), find_format("heightmap-tiff"));
    EXPECT_EQ(format_of_path("a.height.tiff"), find_format("heightmap-tiff"));
    EXPECT_EQ(format_of_path("a.height.exr"), find_format("heightmap-exr"));
    EXPECT_EQ(format_of_path("a.tif"), find_format("tiff"));
}

// Grid below axes below data; patterns, symbols and braille are data.
TEST(HeightFiles, LinesAreAsHighAsTheirRole) {
    Page page;
    page.width = 130;
    page.height = 20;
    const std::map<Role, double> heights = {{Role::line, 1},    {Role::dash, 1},   {Role::arrow, 1},  {Role::symbol, 1},
                                            {Role::pattern, 1}, {Role::axis, 0.7}, {Role::tick, 0.7}, {Role::lead, 0.7},
                                            {Role::scale, 0.7}, {Role::mark, 0.7}, {Role::grid, 0.4}};
    double x = 5;
    for (const auto& [role, height] : heights) {
        page.strokes.push_back({{{x, 2}, {x, 18}}, false, 2, role});
        x += 10;
    }
    // Where two cross, the higher one is felt.
    page.strokes.push_back({{{1, 10}, {125, 10}}, false, 2, Role::axis});
    const Format* format = find_format("heightmap");
    for (const char* profile : {"round", "flat"}) {
        Settings settings(format->options);
        settings.set("height", "2mm", "", "heightmap");
        settings.set("profile", profile, "", "heightmap");
        const HeightFile file = read(format->encode(page, settings));
        double at = 5;
        for (const auto& [role, height] : heights) {
            const int column = static_cast<int>(std::lround(at / 0.1));
            EXPECT_NEAR(file.map.at(column, 40), 2 * height, 0.01) << name_of(role);
            EXPECT_NEAR(file.map.at(column, 100), 2 * std::max(height, 0.7), 0.01) << name_of(role);
            at += 10;
        }
        settings.set("grid", "20", "", "heightmap");
        settings.set("axes", "50", "", "heightmap");
        const HeightFile other = read(format->encode(page, settings));
        EXPECT_NEAR(other.map.at(1220, 100), 1, 0.01);  // the axis alone
        const auto grid = static_cast<int>(std::distance(heights.begin(), heights.find(Role::grid)));
        EXPECT_NEAR(other.map.at(50 + 100 * grid, 40), 0.4, 0.01);
    }
}

}  // namespace
}  // namespace tactics::height_files_test
