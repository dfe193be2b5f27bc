// SPDX-License-Identifier: Apache-2.0
#include "tactics/page.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "tactics/error.h"
#include "tactics/layout/lay_out.h"
#include "tactics/layout/place.h"
#include "tactics/text/utf8.h"

namespace tactics::page_test {
namespace {

constexpr double kSlip = 1e-6;

Sheet sheet_of(std::string_view paper, std::string title = "", std::string_view medium = "swell") {
    Sheet sheet;
    sheet.paper = find_paper(paper, "test");
    sheet.medium = &find_medium(medium, "test");
    sheet.title = std::move(title);
    return sheet;
}

Drawing box(double width, double height) {
    Drawing drawing;
    drawing.width = width;
    drawing.height = height;
    drawing.strokes.push_back({{{0, 0}, {width, 0}, {width, height}, {0, height}}, true, LineClass::normal, 0});
    return drawing;
}

std::string message_of(const Sheet& sheet, double aspect = 1.5) {
    try {
        place_on(sheet, aspect);
    } catch (const Error& error) {
        EXPECT_EQ(error.fault(), Fault::usage);
        return error.what();
    }
    return "no error";
}

TEST(Page, DrawingStandsAsLargeAsItCanInTheMiddleOfTheWidth) {
    for (const Paper& paper : papers())
        for (const Medium& medium : media())
            for (const Orientation way : {Orientation::automatic, Orientation::portrait, Orientation::landscape})
                for (const double aspect : {0.01, 0.5, 1.0, 1.41, 3.0, 100.0})
                    for (const std::string title : {"", "A cat"}) {
                        Sheet sheet = sheet_of(paper.name, title, medium.name);
                        sheet.orientation = way;
                        const Place place = place_on(sheet, aspect);
                        const Rect &live = place.live, &d = place.drawing;
                        EXPECT_NEAR(d.width / d.height, aspect, aspect * kSlip);
                        EXPECT_NEAR(d.left - live.left, live.left + live.width - d.left - d.width, kSlip);
                        EXPECT_GE(d.top, live.top - kSlip);
                        EXPECT_LE(d.top + d.height, live.top + live.height + kSlip);
                        const double below = live.top + live.height - d.top - d.height;
                        EXPECT_TRUE(std::abs(d.width - live.width) < kSlip || std::abs(below) < kSlip);
                        EXPECT_NEAR(live.left, medium.margin, kSlip);
                        EXPECT_NEAR(live.left + live.width + medium.margin, place.page_width, kSlip);
                        EXPECT_NEAR(live.top + live.height + medium.margin, place.page_height, kSlip);
                        if (way != Orientation::automatic) continue;
                        for (const Orientation other : {Orientation::portrait, Orientation::landscape}) {
                            sheet.orientation = other;
                            EXPECT_GE(d.width, place_on(sheet, aspect).drawing.width - 1e-5);
                        }
                    }
}

TEST(Page, WidthIsHonouredOrTheLargestIsTold) {
    Sheet sheet = sheet_of("a4");
    sheet.drawing_width = 100;
    const Page page = lay_out(box(50, 50), sheet);
    EXPECT_NEAR(page.strokes[0].points[1].x - page.strokes[0].points[0].x, 100, kSlip);
    EXPECT_NEAR(page.strokes[0].points[0].x, 55, kSlip);
    sheet.drawing_width = 300;
    EXPECT_EQ(message_of(sheet, 1), "--width: the drawing cannot be 300 mm wide; on this page it can be up to 184.6 mm");
    sheet.drawing_width = 184.6;
    EXPECT_EQ(message_of(sheet, 1), "no error");
    for (const double wrong : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
        sheet.drawing_width = wrong;
        EXPECT_NE(message_of(sheet, 1), "no error");
    }
}

TEST(Page, MarginsThatLeaveNothingAreRefused) {
    Sheet sheet = sheet_of("a4");
    sheet.margin = 103;
    EXPECT_EQ(message_of(sheet),
              "--margin: margins of 103 mm leave nothing of 210 mm x 297 mm paper to draw on; "
              "they can be up to 101.8 mm here, or take larger paper");
    sheet.margin = 101.8;
    EXPECT_EQ(message_of(sheet), "no error");
    sheet.margin = -1;
    EXPECT_NE(message_of(sheet), "no error");
    sheet.margin = 0;
    EXPECT_NEAR(place_on(sheet, 297.0 / 210).drawing.width, 297, kSlip);
}

TEST(Page, PaperThatIsTooSmallIsRefused) {
    Sheet sheet = sheet_of("12x12mm");
    EXPECT_EQ(message_of(sheet),
              "--paper: 12 mm x 12 mm paper is too small for its margins of 12.7 mm; take paper of at least "
              "31.8 mm a side, or margins of up to 2.8 mm with --margin");
    sheet.margin = 2.8;
    EXPECT_EQ(message_of(sheet), "no error");
    EXPECT_EQ(message_of(sheet_of("31.8x31.8mm")), "no error");
    for (const Orientation way : {Orientation::portrait, Orientation::landscape}) {
        sheet = sheet_of("31.7x60mm");
        sheet.orientation = way;
        EXPECT_EQ(message_of(sheet).substr(0, 9), "--paper: ");
    }
    // Too small for any margin.
    sheet = sheet_of("11x11mm", "", "thermoform");
    EXPECT_NE(message_of(sheet).find("or margins of up to 1.5 mm"), std::string::npos) << message_of(sheet);
    sheet.paper = {"tiny", "", 7, 7};
    EXPECT_EQ(message_of(sheet),
              "--paper: 7 mm x 7 mm paper is too small for its margins of 19 mm; take paper of at least 46 mm a side");
}

TEST(Page, BarePageIsTheDrawingAsLargeAsOnTheSheet) {
    Sheet sheet = sheet_of("a4", "");
    const Place full = place_on(sheet, 1.25);
    sheet.bare = true;
    sheet.title = "not drawn";
    const Page page = lay_out(box(50, 40), sheet);
    EXPECT_NEAR(page.width, full.drawing.width, kSlip);
    EXPECT_NEAR(page.height, full.drawing.height, kSlip);
    EXPECT_TRUE(page.braille.empty() && page.print.empty());
    EXPECT_EQ(page.title, "not drawn");
    EXPECT_NEAR(page.strokes[0].points[2].x, page.width, kSlip);
    EXPECT_EQ(page.strokes[0].width, sheet.medium->line);
}

TEST(Page, BrailleKeepsClearOfEverything) {
    for (const Medium& medium : media())
        for (const std::string title : {"A cat", "A hot air balloon over the river at noon, and seven people in it"}) {
            const Page page = lay_out(box(50, 40), sheet_of("a4", title, medium.name));
            ASSERT_FALSE(page.braille.empty());
            ASSERT_EQ(page.print.size(), 1u);
            double top = 1e9, bottom = 0, right = 0, left = 1e9;
            for (const BrailleLine& line : page.braille) {
                EXPECT_FALSE(line.cells.empty());
                EXPECT_NE(line.cells.front(), 0);
                EXPECT_NE(line.cells.back(), 0);
                for (const Point& dot : dots_of(line, page.cell)) {
                    top = std::min(top, dot.y - page.braille_dot / 2);
                    bottom = std::max(bottom, dot.y + page.braille_dot / 2);
                    left = std::min(left, dot.x - page.braille_dot / 2);
                    right = std::max(right, dot.x + page.braille_dot / 2);
                }
            }
            const double clear = std::max(6.0, medium.gap);
            EXPECT_GE(top - page.print[0].baseline.y, clear);
            EXPECT_GE(page.strokes[0].points[0].y - page.strokes[0].width / 2 - bottom, clear - kSlip);
            EXPECT_GE(left, page.live.left - kSlip);
            EXPECT_LE(right, page.live.left + page.live.width + kSlip);
            for (std::size_t i = 1; i < page.braille.size(); ++i) {
                EXPECT_NEAR(page.braille[i].first_dot.y - page.braille[i - 1].first_dot.y, kMarburgMedium.line_pitch, kSlip);
                EXPECT_EQ(page.braille[i].first_dot.x, page.braille[0].first_dot.x);
            }
        }
}

// Titles, labels and names are all in the cells that were asked for.
TEST(Page, BrailleHasTheCellsOfItsStandard) {
    for (const NamedCell& cell : cells()) {
        Sheet sheet;
        sheet.paper = find_paper("a4", "test");
        sheet.medium = &find_medium("swell", "test");
        sheet.title = "A title that is long enough for two lines of braille whatever the cells are that it is set in";
        sheet.cell = cell.size;
        Drawing drawing{200, 100, {Stroke{{{0, 0}, {200, 0}}}}, {}, {}};
        drawing.labels = {{{100, 50}, 0.5, 0.5, "label"}};
        drawing.names = {{{50, 80}, "name"}};
        const Page page = lay_out(drawing, sheet);
        ASSERT_GE(page.braille.size(), 4u) << cell.name;
        EXPECT_EQ(page.cell.cell_pitch, cell.size.cell_pitch);
        EXPECT_EQ(page.braille_dot, cell.size.dot);
        EXPECT_NEAR(page.braille[1].first_dot.y - page.braille[0].first_dot.y, cell.size.line_pitch, 1e-9) << cell.name;
        for (const BrailleLine& line : page.braille)
            for (const Point& dot : dots_of(line, page.cell)) {
                EXPECT_GE(dot.x - page.braille_dot / 2, page.live.left - 1e-9) << cell.name;
                EXPECT_LE(dot.x + page.braille_dot / 2, page.live.left + page.live.width + 1e-9) << cell.name;
            }
    }
}

TEST(Page, LongTitlesWrapUntilTheyWouldTakeThePage) {
    Sheet sheet = sheet_of("a4",
                           "Hurry from the river to the mountain by seven roads, over thirteen bridges, through the "
                           "valley and the forest, and back");
    const Page page = lay_out(box(40, 50), sheet);
    EXPECT_GE(page.braille.size(), 2u);
    EXPECT_LT(page.print[0].size, 4.9);
    sheet.title = std::string(10'000, 'x');
    const std::string message = message_of(sheet);
    EXPECT_NE(message.find("mm, which leaves too little to the drawing; shorten it"), std::string::npos) << message;
    EXPECT_EQ(message.substr(0, 9), "--title: ");
    // Without braille only print is cut short, and no error is needed.
    sheet.braille_table.clear();
    const Page print_only = lay_out(box(40, 50), sheet);
    EXPECT_EQ(print_only.title, sheet.title);
    EXPECT_LT(print_only.print[0].text.size(), 120u);
    EXPECT_EQ(print_only.print[0].text.substr(print_only.print[0].text.size() - 3), "\xE2\x80\xA6");
    sheet.title = std::string(30'000, 'x');
    EXPECT_NE(message_of(sheet), "no error");
}

TEST(Page, OnlyWhatIsAskedForIsPrinted) {
    Sheet sheet = sheet_of("a4", "A cat");
    const double both = place_on(sheet, 0.1).drawing.top;
    sheet.print_title = false;
    const double braille = place_on(sheet, 0.1).drawing.top;
    EXPECT_TRUE(lay_out(box(1, 10), sheet).print.empty());
    sheet.braille_table.clear();
    const double none = place_on(sheet, 0.1).drawing.top;
    EXPECT_TRUE(lay_out(box(1, 10), sheet).braille.empty());
    EXPECT_LT(braille, both);
    EXPECT_LT(none, braille);
    EXPECT_EQ(none, sheet.medium->margin);
    sheet.title = " \t\n";
    sheet.print_title = true;
    EXPECT_EQ(place_on(sheet, 0.1).drawing.top, none);
}

TEST(Page, SmallSheetsHoldAShortTitleOrSayThatTheyCannot) {
    Sheet sheet = sheet_of("90x70mm", "A cat");
    EXPECT_EQ(message_of(sheet), "no error");
    sheet = sheet_of("60x50mm", "A cat");
    EXPECT_EQ(message_of(sheet).substr(0, 25), "--title: the title takes ");
}

TEST(Page, LinesAreOnPaperAndAsWideAsTheMediumHasThem) {
    Drawing drawing = box(100, 50);
    drawing.strokes[0].points.push_back({-1000, 20});
    drawing.strokes.push_back({{{1, 1}, {2, 1e300}}, false, LineClass::thick, 0});
    drawing.strokes.push_back({{{1, 1}, {2, 2}}, false, LineClass::thin, 0});
    drawing.areas.push_back({{{{0, 0}, {99999, 0}, {5, 5}}}});
    for (const Medium& medium : media())
        for (const bool bare : {false, true}) {
            Sheet sheet = sheet_of("letter", "", medium.name);
            sheet.bare = bare;
            const Page page = lay_out(drawing, sheet);
            const auto on_paper = [&](const Point& p) { return p.x >= 0 && p.x <= page.width && p.y >= 0 && p.y <= page.height; };
            for (const PageStroke& stroke : page.strokes) {
                EXPECT_GE(stroke.width, medium.thin_line);
                EXPECT_TRUE(std::all_of(stroke.points.begin(), stroke.points.end(), on_paper));
            }
            EXPECT_EQ(page.strokes[1].width, medium.thick_line);
            EXPECT_EQ(page.strokes[2].width, medium.thin_line);
            EXPECT_TRUE(std::all_of(page.areas[0].rings[0].begin(), page.areas[0].rings[0].end(), on_paper));
        }
    drawing.strokes[0].points[0].x = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(lay_out(drawing, sheet_of("a4")), std::logic_error);
    EXPECT_THROW(lay_out(box(0, 10), sheet_of("a4")), std::logic_error);
}

TEST(Page, PictureBecomesBits) {
    Drawing drawing;
    drawing.width = 19;
    drawing.height = 3;
    drawing.picture = make_image(19, 3, 3, 1, 255);
    std::mt19937 random(7);
    for (int i = 0; i < 19 * 3; ++i)
        if (random() % 2 == 0) std::fill_n(drawing.picture->pixels.begin() + 3 * i, 3, std::uint8_t{0});
    const Page page = lay_out(drawing, sheet_of("a4"));
    ASSERT_TRUE(page.picture);
    EXPECT_EQ(page.picture->row_bytes(), 3u);
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 24; ++x) {
            const int bit = (page.picture->bits[static_cast<std::size_t>(y * 3 + x / 8)] >> (7 - x % 8)) & 1;
            EXPECT_EQ(bit, x < 19 && drawing.picture->row(y)[3 * x] == 0 ? 1 : 0);
        }
    EXPECT_NEAR(page.picture->place.width, 297 - 2 * 12.7, kSlip);
}

TEST(Page, BeginningOfTextEndsWithAWholeLetter) {
    EXPECT_EQ(beginning_of(""), "");
    EXPECT_EQ(beginning_of(std::string(80, 'a')), std::string(80, 'a'));
    EXPECT_EQ(beginning_of(std::string(81, 'a')), std::string(80, 'a') + "...");
    EXPECT_EQ(beginning_of(std::string(79, 'a') + "\xE2\x82\xAC"), std::string(79, 'a') + "...");
    EXPECT_EQ(beginning_of(std::string(100, '\x80')), "...");  // no letters at all
}

TEST(Utf8, LinesAreCleanWhateverTheBytes) {
    EXPECT_EQ(to_line("  a\t\r\nb  c\x01 "), "a b c");
    EXPECT_EQ(to_line("\xC3\xA4\xE2\x82\xAC\xF0\x9F\x90\x98"), "\xC3\xA4\xE2\x82\xAC\xF0\x9F\x90\x98");
    EXPECT_EQ(to_line("a\xFF\xFE\xC0\x80z"), "a?z");
    EXPECT_EQ(to_line("\xED\xA0\x80"), "?");      // a surrogate
    EXPECT_EQ(to_line("\xE2\x82"), "?");          // cut off
    EXPECT_EQ(to_line("\xF4\x90\x80\x80"), "?");  // above U+10FFFF
    EXPECT_EQ(to_line("a\xE2\x80\xA8z\xE2\x80\xAE"), "a z");
    // Soft hyphen, blank without width, left to right, word joiner, heart as a picture; a joiner of letters is text.
    EXPECT_EQ(to_line("a\xC2\xAD\xE2\x80\x8B\xE2\x80\x8E\xE2\x81\xA0z\xE2\x9D\xA4\xEF\xB8\x8F"), "az\xE2\x9D\xA4");
    EXPECT_EQ(to_line("a\xE2\x80\x8Dz"), "a\xE2\x80\x8Dz");
    std::mt19937 random(1);
    for (int round = 0; round < 2000; ++round) {
        std::string bytes(random() % 40, '\0');
        for (char& c : bytes) c = static_cast<char>(random() % 256);
        const std::string line = to_line(bytes);
        EXPECT_EQ(to_line(line), line);
        for (std::string_view rest = line; !rest.empty();) {
            const char32_t letter = take_letter(rest);
            EXPECT_TRUE(letter >= 0x20 && letter != kNoLetter && letter != 0x7F);
        }
    }
}

TEST(Binding, TakesItsRoomFromOneSide) {
    for (const double room : {0.0, 10.0, 60.0})
        for (const auto edge : {Binding::Edge::left, Binding::Edge::top, Binding::Edge::right}) {
            Sheet sheet = sheet_of("a4", "Title");
            sheet.margin = 12;
            sheet.orientation = Orientation::portrait;
            const Place without = place_on(sheet, 1);
            sheet.binding = {edge, room};
            const Place bound = place_on(sheet, 1);
            const auto is = [&](Binding::Edge side) { return side == edge ? 12 + room : 12.0; };
            EXPECT_NEAR(bound.live.left, is(Binding::Edge::left), 1e-9);
            EXPECT_NEAR(bound.live.top, is(Binding::Edge::top), 1e-9);
            EXPECT_NEAR(bound.page_width - bound.live.left - bound.live.width, is(Binding::Edge::right), 1e-9);
            EXPECT_NEAR(bound.page_height - bound.live.top - bound.live.height, 12, 1e-9);
            EXPECT_EQ(bound.page_width, without.page_width);
            EXPECT_GE(bound.drawing.left, bound.live.left - 1e-9);
            EXPECT_LE(bound.drawing.left + bound.drawing.width, bound.live.left + bound.live.width + 1e-9);
        }
    Sheet sheet = sheet_of("a4", "");
    sheet.orientation = Orientation::portrait;
    sheet.margin = 10;
    for (const auto& [room, fits] : {std::pair{183.6, true}, {183.7, false}, {500.0, false}, {-1.0, false}}) {
        sheet.binding = {Binding::Edge::left, room};
        if (fits)
            EXPECT_NO_THROW(place_on(sheet, 1)) << room;
        else
            EXPECT_THROW(place_on(sheet, 1), Error) << room;
    }
}

// A file that writes hundredths of a millimetre holds the page itself.
TEST(LayOut, PointsStandOnSteps) {
    Drawing drawing = box(100.0 / 3, 200.0 / 7);
    for (int i = 0; i < 400; ++i)
        drawing.strokes[0].points.push_back({16 + 15 * std::cos(i / 63.0), 14 + 13 * std::sin(i / 63.0)});
    drawing.areas.push_back({{{{1, 1}, {1.00001, 1}, {1.00001, 1.00001}}}, Role::line});
    Page page = lay_out(drawing, sheet_of("a4", "Steps"));
    const auto stands = [](double mm) { return std::abs(mm * 100 - std::round(mm * 100)) < 1e-9; };
    for (const PageStroke& stroke : page.strokes) {
        EXPECT_TRUE(stands(stroke.width));
        for (std::size_t i = 0; i < stroke.points.size(); ++i) {
            EXPECT_TRUE(stands(stroke.points[i].x) && stands(stroke.points[i].y));
            if (i > 0) {
                EXPECT_GT(distance(stroke.points[i], stroke.points[i - 1]), 0.009);
            }
        }
    }
    EXPECT_TRUE(page.areas.empty()) << "smaller than a step";
    const Page before = page;
    put_on_steps(page);
    EXPECT_EQ(page.strokes[0].points.size(), before.strokes[0].points.size());
}

}  // namespace
}  // namespace tactics::page_test
