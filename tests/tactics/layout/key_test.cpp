// SPDX-License-Identifier: Apache-2.0
// The key on pages of its own: every entry once, in braille that stands where a hand and an embosser can read it.
#include "tactics/layout/key.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "print/format.h"
#include "tactics/braille/braille.h"
#include "tactics/error.h"
#include "tactics/layout/facing.h"
#include "tactics/layout/lay_out.h"
#include "tactics/layout/room.h"
#include "tests/print/brf_reader.h"

namespace tactics::key_test {
namespace {

using Cells = std::vector<std::uint8_t>;

Sheet sheet_on(const char* paper, const char* medium, const std::string& title) {
    Sheet sheet;
    sheet.paper = find_paper(paper, "test");
    sheet.medium = &find_medium(medium, "test");
    sheet.title = title;
    return sheet;
}

std::string words_for(std::mt19937& random, std::size_t most) {
    const std::string words[] = {"Park", "River", "Ember", "Station", "Road", "of the", "Saints", "7", "Knowledge"};
    std::string text = words[random() % 9];
    while (text.size() < most && random() % 5 != 0) text += " " + words[random() % 9];
    return text;
}

std::vector<KeyEntry> entries_of(std::mt19937& random, std::size_t count, std::size_t longest) {
    std::vector<KeyEntry> entries;
    for (std::size_t i = 0; i < count; ++i) {
        KeyEntry entry{{static_cast<char>('a' + i / 26 % 26), static_cast<char>('a' + i % 26)}, words_for(random, longest), {}};
        entry.cells = {letter_cell(entry.letters[0]), letter_cell(entry.letters[1]), 0, 0, 0};
        const Cells words = to_braille(entry.text, "en-ueb-g2.ctb", "test");
        entry.cells.insert(entry.cells.end(), words.begin(), words.end());
        entries.push_back(entry);
    }
    return entries;
}

Cells without_blanks(Cells cells) {
    std::erase(cells, 0);
    return cells;
}

// What a hand reads that goes down column by column: the cells of the entry that begins at each pair of letters.
std::vector<Cells> read_back(const std::vector<Page>& pages) {
    std::vector<Cells> entries;
    for (const Page& page : pages) {
        std::map<double, std::vector<const BrailleLine*>> columns;
        for (const BrailleLine& line : page.braille)
            if (line.first_dot.y > pages.front().names.front().place.top) columns[line.first_dot.x].push_back(&line);
        for (auto& [x, lines] : columns) {
            std::sort(lines.begin(), lines.end(),
                      [](const BrailleLine* a, const BrailleLine* b) { return a->first_dot.y < b->first_dot.y; });
            for (const BrailleLine* line : lines) {
                if (line->cells[0] != 0) entries.emplace_back();
                const Cells cells = without_blanks(line->cells);
                entries.back().insert(entries.back().end(), cells.begin(), cells.end());
            }
        }
    }
    return entries;
}

TEST(Key, EveryEntryStandsOnceInOrderAndClear) {
    std::mt19937 random(1);
    std::size_t several_columns = 0, several_pages = 0, runovers = 0;
    for (int i = 0; i < 60; ++i) {
        const Sheet sheet = sheet_on(i % 3 == 0   ? "120x90mm"
                                     : i % 3 == 1 ? "a4"
                                                  : "11x11.5",
                                     i % 2 == 0 ? "swell" : "embosser", i % 4 == 0 ? "" : "Map of Lisbon");
        const Page drawn = lay_out(Drawing{200, 150, {}, {}, {}}, sheet);
        const auto entries = entries_of(random, 1 + random() % 120, i % 5 == 0 ? 150 : i % 5 < 3 ? 3 : 20);
        const auto pages = key_pages(entries, drawn, sheet);
        const auto read = read_back(pages);
        ASSERT_EQ(read.size(), entries.size());
        for (std::size_t k = 0; k < read.size(); ++k) EXPECT_EQ(read[k], without_blanks(entries[k].cells)) << entries[k].text;
        several_pages += pages.size() > 1 ? 1 : 0;
        std::size_t named = 0;
        for (const Page& page : pages) {
            EXPECT_TRUE(page.is_key);
            EXPECT_EQ(page.width, drawn.width);
            EXPECT_EQ(page.height, drawn.height);
            EXPECT_EQ(page.title, i % 4 == 0 ? "Key" : "Map of Lisbon, key");
            for (const PageName& name : page.names) EXPECT_EQ(name.key, entries[named++].letters);
            std::vector<Rect> taken;
            for (const BrailleLine& line : page.braille) {
                const Rect rect = extent_of(line, page.cell, page.braille_dot);
                EXPECT_GE(rect.left, page.live.left - 1e-9);
                EXPECT_GE(rect.top, page.live.top - 1e-9);
                EXPECT_LE(rect.left + rect.width, page.live.left + page.live.width + 1e-9);
                EXPECT_LE(rect.top + rect.height, page.live.top + page.live.height + 1e-9);
                for (const Rect& other : taken) {
                    const double across = std::max(other.left - rect.left - rect.width, rect.left - other.left - other.width);
                    const double down = std::max(other.top - rect.top - rect.height, rect.top - other.top - other.height);
                    EXPECT_TRUE(across > 2.5 + 2 * 6 || down > 2.5) << across << ' ' << down;
                }
                taken.push_back(rect);
                runovers += line.cells[0] == 0 ? 1 : 0;
                several_columns += line.cells[0] != 0 && line.first_dot.x > page.live.left + 10 ? 1 : 0;
            }
            // An embosser loses no cell.
            const Format& brf = *find_format("brf");
            std::size_t dots = 0;
            for (const BrailleLine& line : page.braille) dots += dots_of(line, page.cell).size();
            EXPECT_EQ(test::read_brf(brf.encode(page, Settings(brf.options))).at(0).dots.size(), dots);
        }
        EXPECT_EQ(named, entries.size());
    }
    EXPECT_GT(several_columns, 20u);
    EXPECT_GT(several_pages, 5u);
    EXPECT_GT(runovers, 20u);
}

TEST(Key, GoesOnAPageOfItsOwnOnlyWhereItHasNoRoom) {
    Drawing drawing{200, 100, {Stroke{{{0, 50}, {200, 50}}}}, {}, {}};
    drawing.names = {{{100, 50}, "Avenue"}};
    EXPECT_EQ(pages_of(drawing, sheet_on("a4", "swell", "")).all.size(), 1u);
    // Wider than the page: two letters there, the words behind.
    drawing.names.push_back(
        {{20, 50}, "Donaudampfschifffahrtselektrizitätenhauptbetriebswerkbauunterbeamtengesellschaftsverwaltungsgebäudeeingang"});
    const auto pages = pages_of(drawing, sheet_on("a4", "swell", "Town")).all;
    ASSERT_EQ(pages.size(), 2u);
    EXPECT_FALSE(pages[0].is_key);
    ASSERT_EQ(pages[0].names.size(), 2u);
    const auto keyed =
        std::find_if(pages[0].names.begin(), pages[0].names.end(), [](const PageName& name) { return !name.key.empty(); });
    ASSERT_NE(keyed, pages[0].names.end());
    ASSERT_EQ(pages[1].names.size(), 1u);
    EXPECT_EQ(pages[1].names[0].key, keyed->key);
    EXPECT_EQ(pages[1].names[0].text, keyed->text);
    const Format& text = *find_format("text");
    EXPECT_NE(
        text.encode(pages[1], Settings(text.options)).find("On it is the key to the drawing: " + keyed->key + " is Donaudampf"),
        std::string::npos);
}

TEST(Key, IsCalledWhatItsLanguageCallsIt) {
    const auto title = [](const std::string& language, const std::string& title_of_drawing) {
        std::mt19937 random(1);
        Sheet sheet = sheet_on("a4", "swell", title_of_drawing);
        sheet.language = language;
        return key_pages(entries_of(random, 3, 3), lay_out(Drawing{200, 150, {}, {}, {}}, sheet), sheet).at(0).title;
    };
    EXPECT_EQ(title("en-GB", "Lisbon"), "Lisbon, key");
    EXPECT_EQ(title("de", "Lissabon"), "Lissabon, Legende");
    EXPECT_EQ(title("fr-CA", "Lisbonne"), "Lisbonne, l\xC3\xA9gende");
    EXPECT_EQ(title("fr", ""), "L\xC3\xA9gende");
    EXPECT_EQ(title("xx", "Lisbon"), "Lisbon") << "better no word than one in another language";
    EXPECT_EQ(title("xx", ""), "");
    for (const std::string language : {"es", "it", "nl", "pt", "sv", "da", "pl", "cs"}) {
        EXPECT_TRUE(title(language, "A").starts_with("A, ")) << language;
        EXPECT_NE(title(language, ""), "") << language;
    }
}

// The back of a sheet is what its front would be if it were bound at the other edge.
TEST(Binding, ChangesSidesOnTheBackOfASheet) {
    std::mt19937 random(5);
    Drawing drawing{200, 100, {Stroke{{{0, 50}, {200, 50}}}}, {}, {}};
    for (int i = 0; i < 3; ++i) drawing.names.push_back({{20 + 70.0 * i, 50}, std::string(60, static_cast<char>('a' + i))});
    for (const auto edge : {Binding::Edge::left, Binding::Edge::top, Binding::Edge::right}) {
        Sheet sheet = sheet_on("a5", "swell", "Town");
        sheet.binding = {edge, 17};
        const auto fronts = pages_of(drawing, sheet).all;
        sheet.duplex = true;
        const auto both = pages_of(drawing, sheet).all;
        Pages drawn;
        std::vector<Page> key;
        for (const Page& page : fronts) (page.is_key ? key : drawn.all).push_back(page);
        const auto front = on_both_sides(drawn, key).all;
        ASSERT_GE(both.size(), 2u);
        ASSERT_EQ(front.size(), both.size());
        const double by = edge == Binding::Edge::top ? 0 : edge == Binding::Edge::left ? -17 : 17;
        for (std::size_t i = 0; i < both.size(); ++i) {
            const double moved = i % 2 == 1 ? by : 0;
            EXPECT_NEAR(both[i].live.left, front[i].live.left + moved, 1e-9);
            ASSERT_EQ(both[i].braille.size(), front[i].braille.size());
            for (std::size_t k = 0; k < both[i].braille.size(); ++k) {
                EXPECT_NEAR(both[i].braille[k].first_dot.x, front[i].braille[k].first_dot.x + moved, 1e-9);
                const Rect rect = extent_of(both[i].braille[k], both[i].cell, both[i].braille_dot);
                EXPECT_GE(rect.left, both[i].live.left - 1e-9);
                EXPECT_LE(rect.left + rect.width, both[i].live.left + both[i].live.width + 1e-9);
            }
            if (!front[i].print.empty()) {
                EXPECT_NEAR(both[i].print.at(0).baseline.x, front[i].print[0].baseline.x + moved, 1e-9);
            }
        }
        EXPECT_EQ(fronts[1].live.left, fronts[0].live.left);
    }
}

TEST(Key, ThatHasNoRoomOnAnyPaperIsTold) {
    std::mt19937 random(1);
    const Sheet sheet = sheet_on("60x50mm", "swell", "");
    const Page drawn = lay_out(Drawing{20, 15, {}, {}, {}}, sheet);
    try {
        key_pages(entries_of(random, 3, 20), drawn, sheet);
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_EQ(error.fault(), Fault::usage);
        EXPECT_TRUE(std::string(error.what()).starts_with("--paper: it is too small for the key of the labels")) << error.what();
    }
}

}  // namespace
}  // namespace tactics::key_test
