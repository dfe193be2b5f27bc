// SPDX-License-Identifier: Apache-2.0
// Pin displays: their bytes as the sources have them, what is understood of their answers, and parts of a page that is too large.
#include <gtest/gtest.h>

#include <random>

#include "print/cell_rows.h"
#include "print/display_parts.h"
#include "print/embosser.h"
#include "print/format.h"
#include "print/pin_display.h"
#include "tactics/error.h"
#include "tactics/layout/chosen_heights.h"
#include "tactics/layout/lay_out.h"
#include "tests/cli/tool.h"

namespace tactics::displays_test {
namespace {

using Kind = PinAnswer::Kind;

std::string hex(std::string_view bytes) {
    std::string text;
    for (const char c : bytes) {
        constexpr char kDigits[] = "0123456789abcdef";
        text += kDigits[static_cast<unsigned char>(c) >> 4];
        text += kDigits[static_cast<unsigned char>(c) & 15];
    }
    return text;
}

std::string bytes(std::initializer_list<int> values) {
    std::string text;
    for (const int value : values) text += static_cast<char>(value);
    return text;
}

Settings small(const Format& format) {
    Settings settings(format.options);
    settings.set("columns", "8", "test", format.name);
    settings.set("rows", "8", "test", format.name);
    settings.set("text", "2", "test", format.name);
    return settings;
}

Page page_with(const Format& format, const Settings& settings, const std::vector<Point>& pins) {
    Page page;
    const DotSetting set = format.dots(settings);
    page.width = set.width;
    page.height = set.height;
    page.live = {0, 0, set.width, set.height};
    page.cell = set.cell;
    page.bed = set.bed;
    for (const Point pin : pins) page.strokes.push_back({{pin, pin}, false, 1.6});
    return page;
}

// By hand from BRLTTY's driver: head, count, row, command, number, zero, four cells, checksum.
TEST(DotPad, SendsARowOfCellsAsAPacket) {
    const Format& pad = *find_format("dot-pad");
    const Settings settings = small(pad);
    // Dot 1 of the first cell, dot 8 of the second, in the first row of cells; dot 7 of the last in the second.
    Page page = page_with(pad, settings, {{1.25, 1.25}, {8.75, 8.75}, {16.25, 18.75}});
    page.title = "ab";
    page.braille_table = "en-us-comp6.ctb";
    const std::string sent = pad.encode(page, settings);
    EXPECT_EQ(hex(sent),
              "aa55000a01020000000180000027"
              "aa55000a0202000000000000"
              "08ad"
              "aa550008000200000001"
              "03a5");
    EXPECT_EQ(pad.embosser->display->message(sent), 14u);
    EXPECT_EQ(pad.embosser->display->message(sent.substr(28)), 12u);
    const Punched shown = pad.embosser->punch(sent, settings);
    ASSERT_EQ(shown.sheets.size(), 1u);
    EXPECT_TRUE(shown.notes.empty());
    EXPECT_EQ(shown.sheets[0].dots.size(), 3u);
    EXPECT_EQ(unicode_of(shown.sheets[0].apart), "\u2801\u2803");
}

std::string packet(int row, int command, const std::string& data) {
    std::string text = bytes({0xAA, 0x55, 0, static_cast<int>(5 + data.size()), row, command >> 8, command & 0xFF, 0}) + data;
    std::uint8_t sum = 0xA5;
    for (const char c : text.substr(4)) sum = static_cast<std::uint8_t>(sum ^ static_cast<std::uint8_t>(c));
    return text + static_cast<char>(sum);
}

std::vector<Kind> kinds_of(std::string_view name, std::string heard) {
    const Format& format = *find_format(name);
    Settings settings(format.options);
    std::vector<Kind> kinds;
    while (const auto answer = format.embosser->display->next(heard, settings)) kinds.push_back(answer->kind);
    return kinds;
}

TEST(DotPad, IsAskedHowLargeItIs) {
    const PinDisplay& display = *find_format("dot-pad")->embosser->display;
    EXPECT_EQ(hex(display.question),
              "aa550005000110"
              "00"
              "b4");
    const std::string answer = "noise\xAA" + packet(0, 0x0111, bytes({0xC0, 1, 24, 4, 1, 40, 0, 5, 16, 48, 0, 5}));
    for (std::size_t cut = 0; cut < answer.size(); ++cut) EXPECT_TRUE(kinds_of("dot-pad", answer.substr(0, cut)).empty()) << cut;
    Settings settings(find_format("dot-pad")->options);
    std::string heard = answer + "rest";
    ASSERT_EQ(display.next(heard, settings)->kind, Kind::told);
    EXPECT_EQ(heard, "rest");
    EXPECT_EQ(settings.whole("columns"), 96);
    EXPECT_EQ(settings.whole("rows"), 64);
    EXPECT_EQ(settings.number("pitch"), 2.4);
    EXPECT_EQ(settings.whole("text"), 40);
    std::string wrong = answer;
    wrong.back() = static_cast<char>(wrong.back() ^ 1);
    EXPECT_TRUE(kinds_of("dot-pad", wrong).empty());
    EXPECT_EQ(kinds_of("dot-pad", packet(0, 0x0111, bytes({0x40, 1, 25, 4, 1, 20, 0, 5, 0, 0, 0, 0}))),
              std::vector<Kind>{Kind::too_small});
    EXPECT_THROW(kinds_of("dot-pad", packet(0, 0x0111, bytes({0xC0, 1, 25, 4, 1, 20, 0, 5, 255, 255, 0, 5}))), Error);
}

TEST(DotPad, AnswersAreUnderstood) {
    const auto kind_of = [](int command, int data) {
        return kinds_of("dot-pad", packet(3, command, std::string(1, static_cast<char>(data)))).at(0);
    };
    EXPECT_EQ(kind_of(0x0201, 0), Kind::taken);
    EXPECT_EQ(kind_of(0x0201, 1), Kind::refused);
    EXPECT_EQ(kind_of(0x0201, 2), Kind::again);
    EXPECT_EQ(kind_of(0x0201, 3), Kind::again);
    EXPECT_EQ(kind_of(0x0202, 0), Kind::standing);
    EXPECT_EQ(kind_of(0x9902, 3), Kind::refused);
    EXPECT_EQ(kind_of(0x0332, 0x40), Kind::keys_down);
    EXPECT_EQ(kind_of(0x0332, 0), Kind::keys_up);
    EXPECT_EQ(kinds_of("dot-pad", packet(3, 0x0201, std::string(1, '\0')) + "?" + packet(3, 0x0202, std::string(1, '\0'))),
              (std::vector<Kind>{Kind::taken, Kind::standing}));
    const PinDisplay& display = *find_format("dot-pad")->embosser->display;
    EXPECT_EQ(display.row(packet(7, 0x0200, "abc")), 7);
}

// What a display says may be anything.
TEST(PinDisplays, BearAnyAnswer) {
    std::mt19937 random(7);
    for (const std::string_view name : {"dot-pad", "graphiti"}) {
        const Format& format = *find_format(name);
        const PinDisplay& display = *format.embosser->display;
        for (int trial = 0; trial < 20'000; ++trial) {
            std::string heard(random() % 40, '\0');
            for (char& c : heard)
                c = random() % 3 == 0 ? "\xAA\x55\x1B\x01\x11\x00\x02\x53"[random() % 8] : static_cast<char>(random() % 256);
            EXPECT_LE(display.message(heard), heard.size());
            display.row(heard);
            Settings settings(format.options);
            try {
                for (std::size_t before = heard.size(); display.next(heard, settings); before = heard.size())
                    ASSERT_LT(heard.size(), before);
            } catch (const Error& error) {
                EXPECT_TRUE(tests::holds(error.what(), "the display tells of")) << error.what();
            }
        }
    }
}

TEST(Graphiti, SendsAHeightForEachPin) {
    const Format& graphiti = *find_format("graphiti");
    const Settings settings(graphiti.options);
    Page page = page_with(graphiti, settings, {{1.25, 1.25}});
    page.strokes.push_back({{{3.75, 3.75}, {3.75, 3.75}}, false, 1.6, Role::pattern});
    page.heights = kind_heights({&page, 1}, graphiti.dots(settings).heights);
    const std::string sent = graphiti.encode(page, settings);
    ASSERT_EQ(sent.size(), 2u + 2 * 60 * 40 + 1);
    EXPECT_EQ(hex(sent.substr(0, 6)), "1b1504000000");
    EXPECT_EQ(static_cast<int>(sent[2 + 2 * 61]), 2);
    int sum = 0;
    for (const char c : sent.substr(1)) sum += static_cast<unsigned char>(c);
    EXPECT_EQ(sum % 256, 0);
    const Punched shown = graphiti.embosser->punch(sent + sent, settings);
    ASSERT_EQ(shown.sheets.size(), 2u);
    ASSERT_EQ(shown.sheets[1].dots.size(), 2u);
    EXPECT_EQ(shown.sheets[1].height_of(0), 1);
    EXPECT_EQ(shown.sheets[1].height_of(1), 0.5);
    const PinDisplay& display = *graphiti.embosser->display;
    EXPECT_EQ(display.message(sent + sent), sent.size());
    EXPECT_EQ(display.message(sent), sent.size());
    EXPECT_EQ(hex(display.question), "1b3101ce");
    EXPECT_EQ(hex(display.farewell), "1b3100cf");
    EXPECT_EQ(hex(display.thanks), "1b51af");
}

TEST(Graphiti, NoWishRaisesPinsAboveTheHeightOfAll) {
    const Format& graphiti = *find_format("graphiti");
    Settings settings(graphiti.options);
    settings.set("height", "2", "", "");
    settings.set("inner", "4", "", "");
    const DotHeights heights = graphiti.dots(settings).heights;
    EXPECT_EQ(heights.wished[static_cast<std::size_t>(LineKind::inner)], 1);
}

TEST(Graphiti, AnswersAreUnderstood) {
    EXPECT_EQ(kinds_of("graphiti", bytes({0x1B, 0x31, 1, 0xCE})), std::vector<Kind>{Kind::told});
    EXPECT_EQ(kinds_of("graphiti", bytes({7, 0x1B, 0x53, 0, 0xAD, 0x1B, 0x53, 3, 0xAA, 0x1B, 0x53, 1, 0xAC})),
              (std::vector<Kind>{Kind::standing, Kind::again, Kind::refused}));
    EXPECT_EQ(kinds_of("graphiti", bytes({0x1B, 0x32, 0, 1, 2, 0xCB, 0x1B, 0x32, 0, 0, 2, 0xCC})),
              (std::vector<Kind>{Kind::keys_down, Kind::keys_up}));
    EXPECT_TRUE(kinds_of("graphiti", bytes({0x1B, 0x53})).empty());
    EXPECT_TRUE(kinds_of("graphiti", bytes({0x1B, 0x53, 0, 0xAE})).empty());  // a wrong sum
    // An ESC among the keys comes twice and counts twice; one that is the sum comes twice.
    EXPECT_EQ(kinds_of("graphiti", bytes({0x1B, 0x32, 0x1B, 0x1B, 1, 2, 0x95})), std::vector<Kind>{Kind::keys_down});
    EXPECT_EQ(kinds_of("graphiti", bytes({0x1B, 0x32, 0x80, 0x33, 0, 0x1B, 0x1B})), std::vector<Kind>{Kind::keys_down});
}

// A checksum that is an ESC is sent twice, too.
TEST(Graphiti, SumsThatAreAnEscapeAreDoubled) {
    const Format& graphiti = *find_format("graphiti");
    Settings settings(graphiti.options);
    settings.set("height", "1", "test", "graphiti");
    // 15h and as many pins of height 1 as make E5h, whose complement is 1Bh.
    std::vector<Point> pins;
    for (int i = 0; i < 0xE5 - 0x15; ++i) pins.push_back({1.25 + 2.5 * (i % 60), 1.25 + 5 * (i / 60)});
    const std::string sent = graphiti.encode(page_with(graphiti, settings, pins), settings);
    EXPECT_EQ(hex(sent.substr(sent.size() - 2)), "1b1b");
    const Punched shown = graphiti.embosser->punch(sent + sent, settings);
    EXPECT_TRUE(shown.notes.empty());
    ASSERT_EQ(shown.sheets.size(), 2u);
    EXPECT_EQ(shown.sheets[1].dots.size(), pins.size());
}

// No byte is read twice, however broken messages stand in each other; what is whole behind them is seen.
TEST(Graphiti, BrokenMessagesAreLeftWhereTheyEnd) {
    const Format& graphiti = *find_format("graphiti");
    const Settings settings(graphiti.options);
    const std::string good = graphiti.encode(page_with(graphiti, settings, {{1.25, 1.25}}), settings);
    const auto notes = [&](const std::string& sent) {
        std::string all;
        for (const Phrase& note : graphiti.embosser->punch(sent, settings).notes) all += note.english() + "\n";
        return all;
    };
    std::string doubled;
    while (doubled.size() < 3'000'000) doubled += "\x1b\x1b\x15";
    // ESC 15h and 4801 bytes, of which two of three are an ESC that was doubled.
    EXPECT_TRUE(
        notes(doubled).starts_with("byte 0: no picture of pins begins here\n"
                                   "byte 1: a picture whose checksum is wrong\n"
                                   "byte 7205: no picture of pins begins here\n"))
        << notes(doubled);
    const std::string cut = "\x1b\x15" + std::string(100, '\1'), wrong = good.substr(0, good.size() - 1) + '\7';
    EXPECT_EQ(notes(cut + good), "byte 0: a picture of pins that is cut short\n");
    EXPECT_EQ(notes(wrong + good), "byte 0: a picture whose checksum is wrong\n");
    EXPECT_EQ(notes(good + cut + "\x1b"),
              "byte 4803: a picture of pins that is cut short\nbyte 4905: no picture of pins begins here\n");
    for (const std::string& before : {cut, wrong}) EXPECT_EQ(graphiti.embosser->punch(before + good, settings).sheets.size(), 1u);
    for (const std::string& before : {cut, wrong})
        EXPECT_EQ(graphiti.embosser->punch(before + good, settings).sheets[0].dots.size(), 1u);
}

TEST(BrailleDisplay, HasExactlyItsCells) {
    const Format& cells = *find_format("braille-display");
    Settings settings(cells.options);
    settings.set("columns", "5", "test", cells.name);
    settings.set("lines", "3", "test", cells.name);
    Page page = page_with(cells, settings, {});
    page.braille.push_back({page.bed->first, {0x19, 0x1b}});
    EXPECT_EQ(cells.encode(page, settings),
              "\u2819\u281b\u2800\u2800\u2800\n\u2800\u2800\u2800\u2800\u2800\n\u2800\u2800\u2800\u2800\u2800\n");
    // Dots of the right lower corner: the last cell's dot 8.
    page.strokes.push_back({{{30, 30}, {30, 30}}, false, 1.6});
    EXPECT_EQ(cells_of(page, 5, 3).back(), 0x80);
}

// What is raised part by part is what is raised on the whole.
TEST(DisplayParts, TogetherAreThePage) {
    for (const std::string_view name : {"dot-pad", "graphiti", "braille-display"}) {
        const Format& format = *find_format(name);
        const Settings settings(format.options);
        Sheet sheet;
        sheet.medium = &find_medium(format.medium, "test");
        sheet.title = "Title";
        fit_to_machine(sheet, format, settings, 3);
        Drawing drawing;
        drawing.width = 300;
        drawing.height = 200;
        drawing.strokes.push_back({{{10, 10}, {290, 190}}, false});
        drawing.strokes.push_back({{{10, 190}, {150, 20}, {290, 100}}, false});
        const Page whole = lay_out(drawing, sheet);
        const DotSetting set = format.dots(settings);
        const std::vector<Page> parts = parts_of({&whole, 1}, set.width, set.height);
        ASSERT_EQ(parts.size(), 9u) << name;
        const CellRows all = cell_rows(whole);
        const bool pins = set.bed.raster > 0;
        const auto columns = static_cast<std::size_t>(std::lround(set.width / (pins ? 5 : 6)));
        const std::size_t lines = 10;
        for (std::size_t part = 0; part < 9; ++part) {
            const auto cells = cells_of(parts[part], columns, lines);
            for (std::size_t line = 0; line < lines; ++line)
                for (std::size_t column = 0; column < columns; ++column)
                    EXPECT_EQ(cells[line * columns + column], all.line(part / 3 * lines + line)[part % 3 * columns + column])
                        << part << " " << line << " " << column;
        }
    }
}

TEST(DisplayParts, OfPinsTogetherAreThePage) {
    const Format& format = *find_format("dot-pad");
    const Settings settings(format.options);
    Sheet sheet;
    sheet.medium = &find_medium(format.medium, "test");
    fit_to_machine(sheet, format, settings, 2);
    Drawing drawing;
    drawing.width = 300;
    drawing.height = 200;
    drawing.strokes.push_back({{{10, 10}, {290, 190}}, false});
    const Page whole = lay_out(drawing, sheet);
    std::size_t dots = 0;
    for (const Page& part : parts_of({&whole, 1}, 150, 100)) {
        const Punched shown = format.embosser->punch(format.encode(part, settings), settings);
        for (const Point& dot : shown.sheets[0].dots) {
            EXPECT_TRUE(dot.x > 0 && dot.x < 150 && dot.y > 0 && dot.y < 100);
            ++dots;
        }
    }
    EXPECT_EQ(dots, 112u);  // a column each, of 280 mm
}

}  // namespace
}  // namespace tactics::displays_test
