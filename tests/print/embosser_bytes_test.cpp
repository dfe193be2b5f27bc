// SPDX-License-Identifier: Apache-2.0
// The bytes of each embosser, against what its sources say, for the smallest page: two cells, a dot, two pages.
#include <gtest/gtest.h>

#include <set>

#include "print/embosser.h"
#include "print/format.h"
#include "tactics/error.h"
#include "tactics/text/words.h"

namespace tactics::embosser_bytes_test {
namespace {

// "d" and the cell of dots 1 2 4 5 at the machine's first cell.
Page page_for(const Format& format, const Settings& settings, double width, double height) {
    Page page;
    page.width = width;
    page.height = height;
    if (format.dots != nullptr) {
        page.cell = format.dots(settings).cell;
        page.bed = format.dots(settings).bed;
    }
    page.live = {0, 0, width, height};
    const Point first = page.bed ? page.bed->first : Point{20, 30};
    page.braille.push_back({first, {0x19, 0x1b}});
    return page;
}

std::string bytes_of(std::string_view name, std::string_view option = "", std::string_view value = "", double width = 210,
                     double height = 297) {
    const Format& format = *find_format(name);
    Settings settings(format.options);
    if (!option.empty()) settings.set(option, value, "test", name);
    return format.encode(page_for(format, settings, width, height), settings);
}

std::string twice(std::string_view name) {
    const Format& format = *find_format(name);
    const Settings settings(format.options);
    const std::vector<Page> pages(2, page_for(format, settings, 210, 297));
    return format.encode_pages(pages, settings);
}

#define ESC "\x1b"

TEST(EmbosserBytes, Generic) {
    EXPECT_EQ(bytes_of("generic"), "DG\r\n\f");
    EXPECT_EQ(bytes_of("generic", "dots", "8"), "\u2819\u281b\r\n\f");
    EXPECT_EQ(twice("generic"), "DG\r\n\fDG\r\n\f");
}

TEST(EmbosserBytes, Index) {
    const std::string graphics = ESC
        "\x07"
        "AC@CC\r\n\f\r" ESC "\x06\x1a";
    EXPECT_EQ(bytes_of("index-v3"), ESC "DTM0,BI0,FO0,MI1,DP1,TD0,GD1,PN0,LS4,BT0;" + graphics);
    EXPECT_EQ(bytes_of("index-v3", "model", "everest"), ESC "DTM0,BI0,FO0,MI1,DP1,TD0,GD1,PN0,PW210,PL297,LS4,BT0;" + graphics);
    EXPECT_EQ(bytes_of("index-v3", "model", "basic", 215.9, 290),
              ESC "DTM0,BI0,FO0,MI1,DP1,TD0,GD1,PN0,PW83,PL112,LS4,BT0;" + graphics);
    EXPECT_EQ(bytes_of("index-v4"), ESC "DTM0,BI0,FO0,MI1,DP1,TD0,GD1,PN0,CH33,LP29,LS50,BT0;" + graphics);
    EXPECT_EQ(bytes_of("index-v4", "setup", "no"), graphics);
    EXPECT_EQ(bytes_of("index-v4", "sides", "both"), ESC "DTM0,BI0,FO0,MI1,DP2,TD0,GD1,PN0,CH33,LP29,LS50,BT0;" + graphics);
    EXPECT_EQ(bytes_of("index-v4", "pitch", "2.0").substr(26, 4), "GD0,");
    EXPECT_EQ(bytes_of("index-v4", "pitch", "1.6").substr(26, 4), "GD2,");
    EXPECT_EQ(bytes_of("index-v4", "copies", "12").substr(0, 22), ESC "DTM0,BI0,FO0,MC12,MI1");
    EXPECT_EQ(bytes_of("index-v4-floating"),
              ESC "DTM0,BI0,FO0,MI1,DP1,TD0,PN0,CH33,LP29,LS50,BT0;" ESC
                  "F;\n20.00:30.00\n22.50:30.00\n26.00:30.00\n28.50:30.00\n22.50:32.50\n26.00:32.50\n28.50:32.50;\f\x1a");
}

// Behind a whole number of packets an Index waits for more.
TEST(EmbosserBytes, NoIndexJobIsAMultipleOf64BytesLong) {
    for (const std::string_view name : {"index-v3", "index-v4", "index-v4-floating"}) {
        const Format& format = *find_format(name);
        Settings settings(format.options);
        std::size_t longer = 0;
        for (int cells = 1; cells <= 120; ++cells) {
            Page page = page_for(format, settings, 400, 297);
            page.braille[0].cells.assign(static_cast<std::size_t>(cells), 1);
            const std::string bytes = format.encode(page, settings);
            EXPECT_NE(bytes.size() % 64, 0u);
            longer += bytes.ends_with("\x1a\x1a") ? 1 : 0;
            if (bytes.ends_with("\x1a\x1a")) {
                EXPECT_EQ(bytes.size() % 64, 1u);
            }
        }
        EXPECT_GT(longer, 0u) << name;
    }
}

TEST(EmbosserBytes, ViewplusIsAPictureOfTwentyDotsPerInch) {
    const std::string png = bytes_of("viewplus", "", "", 25.4, 50.8);
    ASSERT_GT(png.size(), 50u);
    EXPECT_EQ(png.substr(1, 3), "PNG");
    EXPECT_EQ(png.substr(16, 8), (std::string{0, 0, 0, 20, 0, 0, 0, 40}));
    const auto scale = png.find("pHYs");
    ASSERT_NE(scale, std::string::npos);
    EXPECT_EQ(png.substr(scale + 4, 9), (std::string{0, 0, 3, 19, 0, 0, 3, 19, 1}));  // 787 a metre
}

// 33 cells of 6 mm lie between 6.8 mm from the left and as much from the right, 29 lines of 10 mm; 297 mm are 12 inches.
TEST(EmbosserBytes, Enabling) {
    EXPECT_EQ(bytes_of("enabling"), ESC "A@@" ESC "K@" ESC "W@" ESC "iA" ESC "sH" ESC "LA" ESC "Ra" ESC "TL" ESC
                                        "Q\\"
                                        "DG\r\n\f");
    EXPECT_EQ(bytes_of("enabling", "cell", "nls").substr(13, 3), ESC "s@");
    EXPECT_EQ(bytes_of("enabling", "model", "attache").substr(28), "DG\n\f");
    EXPECT_EQ(bytes_of("enabling", "model", "phoenix").substr(28), "DG\r\n\f\x1a");
    EXPECT_EQ(bytes_of("enabling", "sides", "both").substr(10, 3), ESC "i@");
    EXPECT_EQ(bytes_of("enabling", "sides", "both").substr(28), "DG\r\n\f\r\n\f");  // and the back of the last sheet
}

// A machine that has fewer cells than the sheet is told its own number, unless they are needed.
TEST(EmbosserBytes, EnablingModelsHaveTheirNumberOfCells) {
    const Format& format = *find_format("enabling");
    const auto right = [&](std::string_view model, double width) {
        const std::string bytes = bytes_of("enabling", "model", model, width);
        return bytes[bytes.find(ESC "R") + 2] - 0x40;
    };
    const std::pair<std::string_view, int> kMost[] = {{"any", 45},          {"attache", 32}, {"romeo", 40},     {"thomas", 40},
                                                      {"et", 40},           {"juliet", 56},  {"bookmaker", 44}, {"express", 44},
                                                      {"juliet-pro60", 40}, {"phoenix", 45}, {"cyclone", 45},   {"trident", 45}};
    std::set<std::string_view> models;
    for (const auto& [model, most] : kMost) {
        models.insert(model);
        EXPECT_EQ(right(model, 381), most) << model;
        EXPECT_EQ(right(model, 160), 24) << model;
        Settings settings(format.options);
        settings.set("model", model, "test", "enabling");
        Page page = page_for(format, settings, 381, 297);
        page.braille[0].cells.assign(static_cast<std::size_t>(most), 1);
        EXPECT_NO_THROW(format.encode(page, settings)) << model;
        page.braille[0].cells.push_back(1);
        EXPECT_THROW(format.encode(page, settings), Error) << model;
    }
    for (const std::string_view model : words_of(format.options[0].choices)) EXPECT_TRUE(models.count(model)) << model;
}

TEST(EmbosserBytes, EnablingModelsOfOneSideRefuseBoth) {
    const Format& format = *find_format("enabling");
    std::string both;
    for (const std::string_view model : words_of(format.options[0].choices)) {
        Settings settings(format.options);
        settings.set("model", model, "test", "enabling");
        settings.set("sides", "both", "test", "enabling");
        try {
            format.encode(page_for(format, settings, 210, 297), settings);
            both += std::string(model) + " ";
        } catch (const Error& error) {
            EXPECT_EQ(error.fault(), Fault::usage);
        }
    }
    EXPECT_EQ(both, "any et juliet-pro60 juliet bookmaker express trident ");
}

TEST(EmbosserBytes, Braillo) {
    EXPECT_EQ(bytes_of("braillo"), ESC "S1" ESC "C0" ESC "J0" ESC "A24" ESC "B33" ESC "H0" ESC "N0" ESC
                                       "R0"
                                       "DG\f");
    EXPECT_ANY_THROW(bytes_of("braillo", "", "", 60, 297));
    EXPECT_ANY_THROW(bytes_of("braillo", "firmware", "16", 150, 297));
    EXPECT_ANY_THROW(bytes_of("braillo", "firmware", "11", 210, 240));
}

// From 4 to 14 inches, as dotify 1.0.9 writes them.
TEST(EmbosserBytes, BrailloOfFirmware12To16HasADigitForItsLength) {
    std::string lengths;
    for (int half_inches = 8; half_inches <= 28; ++half_inches) {
        const std::string bytes = bytes_of("braillo", "firmware", "16", 222, 12.7 * half_inches);
        lengths += bytes[bytes.find('\x1e') + 1];
    }
    EXPECT_EQ(lengths, "011223344556789ABCDEF");
}

TEST(EmbosserBytes, Cidat) {
    EXPECT_EQ(bytes_of("cidat"),
              ESC ")" ESC "*" ESC ".<" ESC "/1" ESC "0O" ESC "1L" ESC "3" ESC "P" ESC "GU0\n" ESC "IN0\n" ESC "MB0\n" ESC
                  "ML0\n" ESC "MR0\n" ESC "MT0\n" ESC "NC1\n" ESC "SC1\n" ESC "PM0\n" ESC "PN0\n" ESC
                  "PI0\n"
                  "\x19" ESC ESC ESC "\f" ESC "T");
}

TEST(EmbosserBytes, Mountbatten) { EXPECT_EQ(bytes_of("mountbatten"), "{man}{bc 1}{lm 0}{rm 0}{tm 0}dg\f"); }

TEST(EmbosserBytes, Nippon) {
    const auto text = [](const char* bytes, std::size_t size) { return std::string(bytes, size); };
    EXPECT_EQ(bytes_of("nippon"), text("\x01\0\0\x02\x01\x01\x04"
                                       "DG\r\n\x03",
                                       12));
    EXPECT_EQ(twice("nippon"), text("\x01\0\0\x02\x01\x01\x04"
                                    "DG\r\n\f\x02\x01\x01\x04"
                                    "DG\r\n\x03",
                                    21));
    // The back of the last sheet.
    EXPECT_EQ(bytes_of("nippon", "sides", "both"), text("\x01\0\0\x02\x01\x01\x04"
                                                        "DG\r\n\f\x02\x01\0\x03",
                                                        16));
}

#undef ESC

}  // namespace
}  // namespace tactics::embosser_bytes_test
