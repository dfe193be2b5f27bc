// SPDX-License-Identifier: Apache-2.0
// The bytes of our encoders beside those of other people's programs for the same cells:
// tests/golden/machines/NAME-PROGRAM-PAGE.prn was written by PROGRAM when it was run on PAGE.brf (as PEF, 30 cells by 25 lines):
//
//   libembosser: libembosser of the American Printing House, 1.4.3 and ten commits (4c1bf25), by its document handlers
//   cups: cups-filters 1.28.17-3+deb12u2 of Debian, textbrftoindexv3/4 and imageubrltoindexv3/4, of A4, from BRF or dots-*.ubrl
//   dotify: dotify.library 1.0.9-SNAPSHOT (1293c3a), by its embosser writers and PEFHandler
//
//   brailleplot: brailleplot 63abd73, its FloatingDotAreaBuilder with lengths that are numbers of mm, for the places of
//   floating.txt
//
// text has an empty line, full all lines and cells, graphic a circle of cells, two pages are text and graphic, backs are three
// pages of which the second is empty. Paper is 11 inches long.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "print/embosser.h"
#include "print/text_pages.h"
#include "tactics/text/utf8.h"
#include "tactics/text/words.h"

namespace tactics::golden_bytes_test {
namespace {

constexpr std::string_view kPages[] = {"text", "full", "graphic", "two", "backs"};

std::string golden(const std::string& name) {
    std::ifstream file(std::string(TACTICS_SOURCE_DIR) + "/tests/golden/machines/" + name, std::ios::binary);
    EXPECT_TRUE(file) << name << " is missing";
    std::ostringstream bytes;
    bytes << file.rdbuf();
    return bytes.str();
}

struct Beside {
    std::string theirs;  ///< NAME-PROGRAM
    std::string_view embosser;
    std::string_view settings;  ///< "firmware=16 sides=both"
    double width, height;       ///< mm, of a sheet that has their cells and lines for us
};

Settings settings_of(const Beside& beside) {
    Settings settings(find_format(beside.embosser)->options);
    for (const std::string_view set : words_of(beside.settings)) {
        const auto equals = set.find('=');
        settings.set(set.substr(0, equals), set.substr(equals + 1), "test", beside.embosser);
    }
    return settings;
}

std::string ours(const Beside& beside, std::string_view page) {
    const std::string name = std::string(page) + ".brf";
    return text_for(golden(name), *find_format(beside.embosser), settings_of(beside), {"", "", beside.width, beside.height},
                    name);
}

std::size_t first_difference(const std::string& a, const std::string& b) {
    return static_cast<std::size_t>(std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first - a.begin());
}

TEST(GoldenBytes, AreTheOthersByteForByte) {
    const Beside kAll[] = {
        {"nippon-libembosser", "nippon", "", 210, 279.4},
        {"braillo17-dotify", "braillo", "sides=both", 222, 279.4},
        {"braillo16-dotify", "braillo", "firmware=16 sides=both", 222, 279.4},
        {"braillo11-dotify", "braillo", "firmware=11 sides=both", 222, 279.4},
        {"cidat-dotify", "cidat", "", 202, 264},
        {"cidat-both-dotify", "cidat", "sides=both", 202, 264},
        {"enabling-phoenix-libembosser", "enabling", "model=phoenix cell=nls", 195, 266},
        {"enabling-romeo-libembosser", "enabling", "model=romeo", 192, 260},
        {"enabling-attache-libembosser", "enabling", "model=attache cell=nls", 195, 266},
        {"enabling-trident-libembosser", "enabling", "model=trident cell=nls sides=both", 195, 266},
        {"enabling-juliet-libembosser", "enabling", "model=juliet-pro60 sides=both", 192, 260},
        {"enabling-romeo-dotify", "enabling", "model=romeo cell=nls commands=control", 195, 266},
        {"enabling-et-dotify", "enabling", "model=et cell=nls commands=control", 195, 266},
    };
    for (const Beside& beside : kAll)
        for (const std::string_view page : kPages) {
            const std::string theirs = golden(beside.theirs + "-" + std::string(page) + ".prn"), we = ours(beside, page);
            EXPECT_EQ(we, theirs) << beside.theirs << " " << page << ", byte " << first_difference(we, theirs);
        }
}

// All characters for cells except five, because its { would begin a command.
TEST(GoldenBytes, MountbattenIsThatOfDotifyButForFiveSigns) {
    constexpr std::string_view kBegin = "{man}{bc 1}{lm 0}{rm 0}{tm 0}", kTheirs = "`{|}~", kOurs = "@[\\]^";
    for (const std::string_view page : kPages) {
        std::string theirs = golden("mountbatten-dotify-" + std::string(page) + ".prn");
        ASSERT_TRUE(theirs.starts_with(kBegin));
        for (std::size_t at = kBegin.size(); at < theirs.size(); ++at) {
            const auto sign = kTheirs.find(theirs[at]);
            if (theirs.compare(at, 4, "{np}") == 0)
                at += 3;
            else if (sign != std::string_view::npos)
                theirs[at] = kOurs[sign];
        }
        const std::string we = ours({"", "mountbatten", "", 216, 297}, page);
        EXPECT_EQ(we, theirs) << page << ", byte " << first_difference(we, theirs);
    }
}

// dotify leaves the last sheet of an odd number of pages on its front; libembosser, and we, do not.
TEST(GoldenBytes, EnablingAsControlBytesEndsWithABack) {
    const Beside beside{"enabling-juliet-dotify", "enabling", "model=juliet-pro60 cell=nls commands=control sides=both", 195,
                        266};
    for (const std::string_view page : kPages) {
        const std::string theirs = golden(beside.theirs + "-" + std::string(page) + ".prn"), we = ours(beside, page);
        EXPECT_EQ(we, theirs + (page == "two" ? "" : "\f")) << page << ", byte " << first_difference(we, theirs);
    }
}

// A page that is as long as the machine is told feeds itself: the next stands on another sheet, and no empty one between.
TEST(GoldenBytes, FullPagesOfEnablingAreOneSheet) {
    const Settings settings(find_format("enabling")->options);
    for (const std::string_view page : {"text", "full", "graphic"}) {
        const std::string job = golden("enabling-romeo-libembosser-" + std::string(page) + ".prn");
        const Punched punched = find_format("enabling")->embosser->punch(job + job, settings);
        EXPECT_TRUE(punched.notes.empty()) << page << ": " << punched.notes[0].english();
        ASSERT_EQ(punched.sheets.size(), 2u) << page;
        EXPECT_EQ(punched.sheets[0].lines, punched.sheets[1].lines) << page;
        EXPECT_EQ(punched.sheets[0].lines.size() == 25, page == "full") << page;
    }
}

// What follows the keys of the set-up, and the keys.
std::pair<std::string, std::string> index_parts(const std::string& bytes) {
    const std::size_t end = bytes.find(';') + 1;
    return {bytes.substr(0, end), bytes.substr(end)};
}

const Beside kIndex[] = {{"index-v4", "index-v4", "", 210, 297},
                         {"index-v3everest", "index-v3", "model=everest", 210, 297},
                         {"index-v3basic", "index-v3", "model=basic", 210, 297},
                         {"index-v3any", "index-v3", "", 210, 297}};

// The keys are those of cups-filters, in its order; the text is that of libembosser, and of dotify, which ends no job.
TEST(GoldenBytes, IndexSetUpIsThatOfCupsAndTextThatOfTheOthers) {
    for (const Beside& beside : kIndex)
        for (const std::string_view page : {"text", "full", "graphic", "two"}) {
            const std::string name = "-" + std::string(page) + ".prn", we = ours(beside, page);
            const auto [keys, text] = index_parts(we);
            EXPECT_EQ(keys, index_parts(golden(beside.theirs + "-cups" + name)).first) << beside.theirs << " " << page;
            const std::string end = text.ends_with("\x1a\x1a") ? "\x1a\x1a" : "\x1a";
            EXPECT_EQ(text, index_parts(golden(beside.theirs + "-dotify" + name)).second + end) << beside.theirs << " " << page;
            if (beside.embosser != "index-v4") continue;
            EXPECT_EQ(text, index_parts(golden("index-v4-libembosser" + name)).second + end.substr(1)) << page;
        }
}

// A page of 78 by 112 dots from Unicode braille, a dot a line of no length.
Page page_of_dots(const Format& format, const Settings& settings, std::string_view ubrl) {
    Page page;
    page.width = 210;
    page.height = 297;
    page.cell = format.dots(settings).cell;
    page.bed = format.dots(settings).bed;
    page.live = {0, 0, page.width, page.height};
    int line = 0, column = 0;
    while (!ubrl.empty()) {
        const char32_t letter = take_letter(ubrl);
        if (letter == '\n') ++line, column = -1;
        for (int dot = 0; letter >= 0x2800 && letter <= 0x28FF && dot < 8; ++dot) {
            if (((letter - 0x2800) >> dot & 1) == 0) continue;
            const int right = dot < 6 ? dot / 3 : dot - 6, down = dot < 6 ? dot % 3 : 3;
            const Point at{page.bed->first.x + (2 * column + right) * 2.5, page.bed->first.y + (4 * line + down) * 2.5};
            page.strokes.push_back({{at, at}, false, 1.6});
        }
        ++column;
    }
    return page;
}

TEST(GoldenBytes, IndexGraphicsAreThoseOfCupsByteForByte) {
    for (const Beside& beside : kIndex)
        for (const std::string page : {"text", "full", "graphic", "both"}) {
            Settings settings = settings_of(beside);
            if (page == "both") settings.set("sides", "both", "test", beside.embosser);
            const Format& format = *find_format(beside.embosser);
            std::string theirs = golden(beside.theirs + "-cups-dots-" + page + ".prn");
            if (theirs.size() % 64 == 0) theirs += '\x1a';  // Index's own driver
            const std::string dots = golden("dots-" + (page == "both" ? "graphic" : page) + ".ubrl");
            const std::string we = format.encode(page_of_dots(format, settings, dots), settings);
            EXPECT_EQ(we, theirs) << beside.theirs << " " << page << ", byte " << first_difference(we, theirs);
        }
}

// The area of a page; its set-up and its end are those of other jobs.
TEST(GoldenBytes, IndexFloatingDotsAreThoseOfBrailleplot) {
    const Format& format = *find_format("index-v4-floating");
    const Settings settings(format.options);
    Page page;
    page.width = 210;
    page.height = 297;
    page.live = {0, 0, page.width, page.height};
    std::istringstream places(golden("floating.txt"));
    for (Point at; places >> at.x >> at.y;) page.strokes.push_back({{at, at}, false, 1.6});
    ASSERT_EQ(page.strokes.size(), 63u);
    const std::string bytes = format.encode(page, settings);
    const std::size_t begin = bytes.find(
                          "\x1b"
                          "F"),
                      end = bytes.rfind(';') + 1;
    ASSERT_NE(begin, std::string::npos);
    EXPECT_EQ(bytes.substr(begin, end - begin), golden("index-v4-floating-brailleplot.prn"));
}

std::vector<std::string> commands_of(const PunchedSheet& sheet, const std::string& bytes) {
    std::vector<std::string> commands;
    for (std::size_t at = sheet.set_up_begin; at < sheet.set_up_end;) {
        const std::size_t end = std::min(bytes.find('\x1b', at + 1), sheet.set_up_end);
        commands.push_back(bytes.substr(at, end - at));
        at = end;
    }
    std::sort(commands.begin(), commands.end());
    return commands;
}

// The same commands in another order, and CR LF in other places: the machine makes the same sheets of it.
TEST(GoldenBytes, OfAnotherOrderMakeTheSameSheets) {
    const Beside kAll[] = {
        {"braillo17-libembosser", "braillo", "", 222, 279.4},
        {"braillo16-libembosser", "braillo", "firmware=16", 222, 279.4},
        {"braillo11-libembosser", "braillo", "firmware=11", 222, 279.4},
        {"generic-libembosser", "generic", "", 210, 279.4},
    };
    for (const Beside& beside : kAll)
        for (const std::string_view page : kPages) {
            const std::string theirs = golden(beside.theirs + "-" + std::string(page) + ".prn"), we = ours(beside, page);
            const auto punch = find_format(beside.embosser)->embosser->punch;
            const Punched of_theirs = punch(theirs, settings_of(beside)), of_ours = punch(we, settings_of(beside));
            EXPECT_TRUE(of_theirs.notes.empty()) << beside.theirs << " " << page << ": " << of_theirs.notes[0].english();
            EXPECT_TRUE(of_ours.notes.empty()) << beside.theirs << " " << page << ": " << of_ours.notes[0].english();
            ASSERT_EQ(of_theirs.sheets.size(), of_ours.sheets.size()) << beside.theirs << " " << page;
            for (std::size_t i = 0; i < of_ours.sheets.size(); ++i)
                EXPECT_EQ(unicode_of(of_ours.sheets[i], 2.5), unicode_of(of_theirs.sheets[i], 2.5))
                    << beside.theirs << " " << page;
            EXPECT_EQ(commands_of(of_ours.sheets[0], we), commands_of(of_theirs.sheets[0], theirs)) << beside.theirs;
        }
}

}  // namespace
}  // namespace tactics::golden_bytes_test
