// SPDX-License-Identifier: Apache-2.0
// Words are divided where their language divides them, whatever their case, and on the page with a hyphen that a reader knows.
#include "tactics/braille/hyphenation.h"

#include <gtest/gtest.h>

#include <string>

#include "tactics/braille/braille.h"
#include "tactics/braille/louis.h"
#include "tactics/layout/wrapped.h"

namespace tactics::hyphenation_test {
namespace {

using Cells = std::vector<std::uint8_t>;

// "Dampf-schiff-fahrt"
std::string divided(const std::string& word, std::string_view table, std::string_view language = "en") {
    std::string text = word;
    const std::vector<std::size_t> places = places_to_divide(word, table, language);
    for (auto place = places.rbegin(); place != places.rend(); ++place) text.insert(*place, "|");
    return text;
}

// The words are from Duden and Petit Robert; a place that the patterns do not know is no fault, a wrong one is.
TEST(Hyphenation, DividesAsTheLanguageDoes) {
    EXPECT_EQ(divided("Beamten", "de-g2.ctb"), "Be|amten");
    EXPECT_EQ(divided("Dampfschifffahrt", "de-g0.utb"), "Dampf|schiff|fahrt");
    EXPECT_EQ(divided("\u00DCbergr\u00F6\u00DFe", "de-g1.ctb"), "\u00DCber|gr\u00F6|\u00DFe");
    EXPECT_EQ(divided("anticonstitutionnellement", "fr-bfu-g2.ctb"), "anti|consti|tu|tion|nel|le|ment");
    EXPECT_EQ(divided("Beamten", "en-ueb-g2.ctb"), divided("Beamten", "en-ueb-g1.ctb")) << "the language counts, not the grade";
    EXPECT_EQ(divided("Beamten", "own.ctb", "de-AT"), "Be|amten") << "a table that says no language has that of the page";
    EXPECT_EQ(divided("\u05E9\u05DC\u05D5\u05DD", "he-IL.utb"), "\u05E9\u05DC\u05D5\u05DD") << "no patterns";
    EXPECT_EQ(divided("Nord-Ostsee-Kanal,", "de-g2.ctb"), "Nord-|Ost|see-|Ka|nal,") << "hyphens of its own";
    EXPECT_EQ(divided("eben", "de-g2.ctb"), "eben") << "one letter alone says nothing";
    EXPECT_EQ(divided(std::string(400, 'n'), "de-g2.ctb"), std::string(400, 'n'));
    EXPECT_EQ(divided("\xFF\xFE", "de-g2.ctb"), "\xFF\xFE");
}

TEST(Hyphenation, CapitalsAreDividedAsSmallLetters) {
    for (const char* word : {"beamten", "dampfschifffahrt", "urlaubsantrag", "bodenuntersuchung", "tastgrafik", "wasserkreislauf",
                             "schulbuchverlag", "himmelsrichtung"}) {
        std::string capitals = word, first = word;
        for (char& c : capitals) c = static_cast<char>(c - 'a' + 'A');
        first[0] = capitals[0];
        const auto places = places_to_divide(word, "de-g2.ctb", "de");
        EXPECT_FALSE(places.empty()) << word;
        EXPECT_EQ(places_to_divide(capitals, "de-g2.ctb", "de"), places) << word;
        EXPECT_EQ(places_to_divide(first, "de-g2.ctb", "de"), places) << word;
    }
}

// Every line but the last of a word is the braille of a part that its language has, and a hyphen.
TEST(Hyphenation, LinesOfBrailleEndAtThosePlaces) {
    for (const std::string table : {"de-g0.utb", "de-g2.ctb"}) {
        Sheet sheet;
        sheet.braille_table = table;
        sheet.language = "de";
        const std::string text = "DIE BODENUNTERSUCHUNGEN DER BEAMTEN";
        const auto cells = [&](const std::string& part) { return to_braille(part, table); };
        Cells first = cells("BODENUNTER"), whole = cells("BODENUNTERSUCHUNGEN");
        const Cells hyphen = hyphen_of(table);
        first.insert(first.end(), hyphen.begin(), hyphen.end());
        const std::vector<Cells> lines = wrapped(cells(text), whole.size() - 2, division_in(sheet, text));
        ASSERT_GE(lines.size(), 3u) << table;
        EXPECT_EQ(lines[0], cells("DIE")) << table;
        EXPECT_EQ(lines[1].back(), hyphen.back()) << table;
        bool known = false;
        std::size_t place = 0;
        for (const std::size_t one : places_to_divide("BODENUNTERSUCHUNGEN", table, "de")) {
            Cells part = cells(std::string("BODENUNTERSUCHUNGEN").substr(0, one));
            part.insert(part.end(), hyphen.begin(), hyphen.end());
            if (part == lines[1]) known = true, place = one;
        }
        EXPECT_TRUE(known) << table;
        Cells rest = cells(std::string("BODENUNTERSUCHUNGEN").substr(place));
        ASSERT_GE(lines[2].size(), rest.size()) << table;
        EXPECT_TRUE(std::equal(rest.begin(), rest.end(), lines[2].begin())) << table;
    }
}

}  // namespace
}  // namespace tactics::hyphenation_test
