// SPDX-License-Identifier: Apache-2.0
// Phrases are put together in any order that a language wants, and say the same in English as if they were written there.
#include "tactics/text/phrase.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tactics/error.h"
#include "tactics/text/catalogue.h"

namespace tactics::phrase_test {
namespace {

TEST(Phrase, PartsStandAtTheirPlaces) {
    EXPECT_EQ(phrase("{1} before {0}, {1}", "a", "b").english(), "b before a, b");
    EXPECT_EQ(phrase("{0} and {9} and {x} and {", "a").english(), "a and {9} and {x} and {") << "no place of ours";
    EXPECT_EQ(phrase("as it is: {0}").english(), "as it is: {0}") << "without parts";
    EXPECT_EQ(phrase("{0}", "{1} {0}").english(), "{1} {0}") << "what a user wrote stays as it is";
    EXPECT_EQ(phrase("nobody has {0} said this", phrase("{0} lines", "3")).in("de"), "nobody has 3 lines said this");
    EXPECT_TRUE(Phrase().empty());
    EXPECT_FALSE(phrase("circle").empty());
}

TEST(Phrase, PluralsGoByTheNumber) {
    const auto lines = [](std::size_t n) { return phrases(n, "{0} line of braille", "{0} lines of braille"); };
    EXPECT_EQ(lines(0).english(), "0 lines of braille");
    EXPECT_EQ(lines(1).english(), "1 line of braille");
    EXPECT_EQ(lines(2).english(), "2 lines of braille");
    EXPECT_EQ(lines(0).in("fr"), "0 ligne de braille");
    EXPECT_EQ(lines(1).in("de"), "1 Zeile Brailleschrift");
    EXPECT_EQ(lines(2).in("de"), "2 Zeilen Brailleschrift");
}

TEST(Phrase, ListsHaveTheirLastWord) {
    EXPECT_EQ(listed({}).english(), "");
    EXPECT_EQ(listed({"one"}).english(), "one");
    EXPECT_EQ(listed({"one", "two"}).english(), "one and two");
    EXPECT_EQ(listed({"one", "two", "three"}).english(), "one, two and three");
    EXPECT_EQ(listed({"1", "2", "3"}).in("de"), "1, 2 und 3");
    EXPECT_EQ(either_of({"1", "2", "3"}).in("fr"), "1, 2 ou 3");
    EXPECT_EQ(row_of({"1", "2", "3"}).english(), "1, 2, 3");
}

// Where it took the square of their number, this took hours.
TEST(Phrase, AHundredThousandAreListed) {
    std::vector<Phrase> parts;
    std::string row;
    for (int i = 0; i < 100000; ++i) {
        parts.emplace_back(std::to_string(i));
        row += (i > 0 ? ", " : "") + std::to_string(i);
    }
    const std::vector<Phrase> copies(2, row_of(parts));
    EXPECT_EQ(copies.back().english(), row);
}

TEST(Phrase, NumbersHaveTheMarkOfTheLanguageOfTheWords) {
    const Phrase size = phrase("{0} cm", numeral(2.5));
    EXPECT_EQ(size.english(), "2.5 cm");
    EXPECT_EQ(size.in("de-AT"), "2,5 cm");
    EXPECT_EQ(size.in("de-CH"), "2.5 cm");
    EXPECT_EQ(size.in("fr"), "2,5 cm");
    EXPECT_EQ(size.in("pl"), "2.5 cm") << "said in English";
    EXPECT_EQ(size.in("tr-TR"), "2.5 cm");
}

TEST(Phrase, ALanguageIsFoundByItsTag) {
    for (const char* tag : {"de", "de-AT", "de_DE", "de-DE-1996"}) EXPECT_EQ(spoken_language(tag), "de") << tag;
    EXPECT_EQ(spoken_language("fr-CA"), "fr");
    for (const char* tag : {"", "en", "en-GB", "pl", "den", "fro", "x-de"}) EXPECT_EQ(spoken_language(tag), "en") << tag;
}

TEST(Phrase, ASentenceBeginsWithACapital) {
    EXPECT_EQ(as_sentence("arc"), "Arc");
    EXPECT_EQ(as_sentence("\xC3\xA9toile"), "\xC3\x89toile");
    for (const char* same : {"", "Kreis", "3 cm", "\xC3\xB7", "\xC2\xAB", "\xC3"}) EXPECT_EQ(as_sentence(same), same);
}

TEST(Phrase, AnErrorIsToldInAnyLanguageAndKeepsItsEnglishForPrograms) {
    const Error error(Fault::failed, "photo.jpg", phrase("is empty; get a complete copy of it"));
    EXPECT_STREQ(error.what(), "photo.jpg: is empty; get a complete copy of it");
    EXPECT_EQ(error.told().in("de"), "photo.jpg: ist leer; besorgen Sie eine vollst\xC3\xA4ndige Kopie");
    EXPECT_EQ(Error(Fault::usage, "", "as it was").told().in("fr"), "as it was");
}

}  // namespace
}  // namespace tactics::phrase_test
