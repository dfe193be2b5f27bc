// SPDX-License-Identifier: Apache-2.0
// Every phrase of the program is in every catalogue, with the same places, and nothing else is. TACTICS_REGENERATE=1 in the
// environment writes the catalogues anew, with what is missing still to be translated and without what is no longer said.
#include "tactics/text/catalogue.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <set>

#include "cli/command.h"
#include "cli/help/help_language.h"
#include "tactics/text/phrase.h"
#include "tests/tactics/text/source_phrases.h"

namespace tactics::catalogue_test {
namespace {

using namespace tests;

std::string folder() { return std::string(TACTICS_SOURCE_DIR) + "/tactics/text/po/"; }

// "{0}", "{1}" ... in the order of their numbers, each as often as it stands there.
std::multiset<std::string> places_in(const std::string& text) {
    std::multiset<std::string> places;
    for (std::size_t at = text.find('{'); at != std::string::npos; at = text.find('{', at + 1))
        if (const std::size_t end = text.find('}', at); end != std::string::npos && end < at + 4)
            places.insert(text.substr(at, end - at + 1));
    return places;
}

std::string quoted(const std::string& text) {
    std::string marked = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') marked += '\\';
        marked += c == '\n' ? "\\n" : std::string(1, c);
    }
    return marked + "\"";
}

// Those of the source, and what commands say of themselves in their help.
std::vector<SourcePhrase> all_phrases() {
    std::vector<SourcePhrase> all = phrases_of_the_program();
    std::set<std::string> known;
    for (const SourcePhrase& one : all) known.insert(one.english);
    for (const Command* command : commands())
        for (const std::string& text : help_texts(*command))
            if (known.insert(text).second) all.push_back({text, "", "tactics " + std::string(command->name) + " --help"});
    return all;
}

void write_anew(const Language& language, const std::vector<SourcePhrase>& phrases) {
    const std::string path = folder() + std::string(language.tag) + ".po";
    const std::string before = read(path);
    std::map<std::string, CatalogueEntry> known;
    for (CatalogueEntry& entry : entries_of(before)) known[entry.english] = std::move(entry);
    const std::size_t head = before.find("\n\n");
    std::ofstream out(path, std::ios::binary);
    out << (head == std::string::npos ? before : before.substr(0, head + 1));
    for (const SourcePhrase& one : phrases) {
        const auto& words = known[one.english].words;
        const auto word = [&](std::size_t i) { return quoted(i < words.size() ? words[i] : ""); };
        out << "\n#: " << one.path << "\nmsgid " << quoted(one.english) << "\n";
        if (one.plural.empty())
            out << "msgstr " << word(0) << "\n";
        else
            out << "msgid_plural " << quoted(one.plural) << "\nmsgstr[0] " << word(0) << "\nmsgstr[1] " << word(1) << "\n";
    }
}

TEST(Catalogue, EveryLanguageSaysAllThatIsSaidAndNothingElse) {
    const std::vector<SourcePhrase> phrases = all_phrases();
    ASSERT_GT(phrases.size(), 100u);
    if (const char* ask = std::getenv("TACTICS_REGENERATE"); ask != nullptr && std::string_view(ask) == "1") {
        for (const Language& language : languages()) write_anew(language, phrases);
        FAIL() << "wrote the catalogues; translate what is empty there, build, and run this again without TACTICS_REGENERATE";
    }
    for (const Language& language : languages()) {
        std::map<std::string, CatalogueEntry> said;
        for (const CatalogueEntry& entry : entries_of(read(folder() + std::string(language.tag) + ".po"))) {
            if (entry.english.empty()) continue;
            EXPECT_FALSE(entry.fuzzy) << language.tag << ": not looked over: " << entry.english;
            EXPECT_TRUE(said.emplace(entry.english, entry).second) << language.tag << ": twice: " << entry.english;
        }
        for (const SourcePhrase& one : phrases) {
            const auto entry = said.find(one.english);
            if (entry == said.end()) {
                ADD_FAILURE() << language.tag << ": missing: " << one.english;
                continue;
            }
            EXPECT_EQ(entry->second.plural, one.plural) << language.tag << ": " << one.english;
            EXPECT_EQ(entry->second.words.size(), one.plural.empty() ? 1u : 2u) << language.tag << ": " << one.english;
            for (const std::string& words : entry->second.words)
                EXPECT_FALSE(words.empty()) << language.tag << ": not translated: " << one.english;
            said.erase(entry);
        }
        for (const auto& [english, entry] : said) ADD_FAILURE() << language.tag << ": nobody says: " << english;
    }
}

// Of one thing the number may be a word: "eine Linie".
TEST(Catalogue, TranslationsHaveThePlacesOfTheEnglishWords) {
    for (const Language& language : languages())
        for (const CatalogueEntry& entry : entries_of(*language.po)) {
            if (entry.english.empty()) continue;
            for (std::size_t i = 0; i < entry.words.size(); ++i) {
                const bool plural = !entry.plural.empty();
                auto wanted = places_in(plural && i > 0 ? entry.plural : entry.english), got = places_in(entry.words[i]);
                if (plural && i == 0) {
                    // What is said of many only may be left out, and said.
                    for (const std::string& place : places_in(entry.plural))
                        if (!wanted.contains(place) || place == "{0}") {
                            wanted.erase(place);
                            got.erase(place);
                        }
                }
                EXPECT_EQ(got, wanted) << language.tag << ": " << entry.english << " / " << entry.words[i];
            }
        }
}

// A sentence stays one, and what goes on within another sentence, too.
TEST(Catalogue, TranslationsEndAsTheEnglishWordsDo) {
    const auto end_of = [](const std::string& text) {
        return text.ends_with('.') || text.ends_with(':') || text.ends_with(' ') ? std::string(1, text.back()) : "";
    };
    for (const Language& language : languages())
        for (const CatalogueEntry& entry : entries_of(*language.po)) {
            if (entry.english.empty()) continue;
            for (const std::string& words : entry.words) {
                EXPECT_EQ(end_of(words), end_of(entry.english)) << language.tag << ": " << words;
                EXPECT_FALSE(words.starts_with(' ')) << language.tag << ": " << words;
            }
        }
}

// Straight quotation marks stand around what is to be typed, and there stands the same in English; around a place alone never.
bool quotes_what_is_typed(const std::string& words, const std::string& english) {
    const std::string plain = words.find("[{") != std::string::npos ? "" : words;  // JSON
    for (std::size_t from = plain.find('"'); from != std::string::npos;) {
        const std::size_t to = plain.find('"', from + 1);
        if (to == std::string::npos) return false;
        const std::string typed = plain.substr(from, to + 1 - from);
        if (english.find(typed) == std::string::npos || (typed.size() == 5 && typed[1] == '{')) return false;
        from = plain.find('"', to + 1);
    }
    return true;
}

// But in what is to be typed, such as "usb:", which stands in the English words, too.
bool has_french_blanks(const std::string& words, const std::string& english) {
    for (std::size_t at = words.find_first_of(";:?!"); at != std::string::npos; at = words.find_first_of(";:?!", at + 1)) {
        if (at + 1 < words.size() && words[at + 1] != ' ' && words[at + 1] != ')') continue;  // 1:100
        const std::size_t blank = words.rfind(' ', at);
        const std::string word = words.substr(blank == std::string::npos ? 0 : blank + 1, at - blank);
        if (!words.substr(0, at).ends_with("\xC2\xA0") && english.find(word) == std::string::npos) return false;
    }
    return true;
}

// „So“ in German, « ainsi » in French, where a blank that is not broken also stands before ; : ? and !.
TEST(Catalogue, QuotationMarksAndBlanksAreThoseOfTheLanguage) {
    for (const Language& language : languages())
        for (const CatalogueEntry& entry : entries_of(*language.po)) {
            if (entry.english.empty()) continue;
            for (const std::string& words : entry.words) {
                EXPECT_TRUE(quotes_what_is_typed(words, entry.english)) << language.tag << ": " << words;
                if (language.tag != "fr") continue;
                EXPECT_TRUE(has_french_blanks(words, entry.english)) << words;
                EXPECT_EQ(words.find("\xC2\xAB "), std::string::npos) << words;
                EXPECT_EQ(words.find(" \xC2\xBB"), std::string::npos) << words;
            }
        }
}

// The file's head and the formula that the program counts by say the same.
TEST(Catalogue, PluralsAreThoseOfTheFilesHead) {
    const std::map<std::string_view, std::string> formulas{{"de", "nplurals=2; plural=(n != 1);"},
                                                           {"fr", "nplurals=2; plural=(n > 1);"}};
    for (const Language& language : languages()) {
        ASSERT_TRUE(formulas.contains(language.tag)) << language.tag << ": say here which plurals it has";
        const CatalogueEntry head = entries_of(*language.po).front();
        EXPECT_NE(head.words.at(0).find("Plural-Forms: " + formulas.at(language.tag)), std::string::npos) << head.words[0];
        EXPECT_NE(head.words.at(0).find("Language: " + std::string(language.tag) + "\n"), std::string::npos);
        EXPECT_NE(head.words.at(0).find("charset=UTF-8"), std::string::npos);
    }
    EXPECT_EQ(phrases(0, "{0} area", "{0} areas").in("de"),
              "0 Fl\xC3\xA4"
              "chen");
    EXPECT_EQ(phrases(1, "{0} area", "{0} areas").in("de"),
              "1 Fl\xC3\xA4"
              "che");
    EXPECT_EQ(phrases(0, "{0} area", "{0} areas").in("fr"), "0 surface");
    EXPECT_EQ(phrases(2, "{0} area", "{0} areas").in("fr"), "2 surfaces");
    EXPECT_EQ(phrases(0, "{0} area", "{0} areas").in("en"), "0 areas");
}

TEST(Catalogue, AFileThatIsNoneIsRefusedWithItsLine) {
    EXPECT_EQ(entries_of("# no more\n\nmsgid \"a \\\"b\\\"\"\n\"c\"\nmsgstr \"d\\n\"\n").at(0).english, "a \"b\"c");
    for (const char* bad : {"msgstr \"a\"", "msgid a", "msgid \"a", "msgid \"a\\\"", "msgid \"a\"\nmsgctxt \"b\"", "\"a\""})
        EXPECT_THROW(entries_of(bad), std::logic_error) << bad;
    EXPECT_TRUE(entries_of("#, fuzzy\nmsgid \"a\"\nmsgstr \"b\"\n").at(0).fuzzy);
}

// A string would stay English in every language.
TEST(Catalogue, WhatIsSaidOfAFaultIsAPhrase) {
    for (const SourceFile& file : tree()) {
        if (!is_source(file) || starts_with_any(file.path, {"tests/", "samples/"})) continue;
        EXPECT_EQ(plain_words_in(file), std::vector<std::string>{}) << file.path;
    }
    const std::string source =
        "throw Error(Fault::usage, \"--a\", phrase(\"one\", x) ); Error(f, p, (a ? \"two \" : b) + spelled(\"c\")); "
        "Error(f, g(\"d\", 2), w == \"set\" ? phrase(\"three\") : names({\"e\"}) + \": \"); say(\"four\");";
    EXPECT_EQ(plain_words_in({"cli/x.cpp", source}), (std::vector<std::string>{"two ", "four"}));
    EXPECT_EQ(plain_words_in({"tactics/x.cpp", source}), std::vector<std::string>{"two "});
}

// The test itself finds what it is to find.
TEST(Catalogue, PhrasesAreFoundInTheSource) {
    const std::string source =
        "phrase(\"one \" // not this\n \"thing\", x); phrases(all(a, b).size(), \"{0} a\", \"{0} \\\"b\\\"\"); // "
        "phrase(\"no\")\n"
        "constexpr std::array<SourceWords, 2> kTwo{\"c\", \"d\"}; SourceWords name; f('\"', 10'000, \"e\"); "
        "View{SourceWords(\"g\")}; Rule r{.mend = \"h\"}; std::string mend = \"no\";";
    std::vector<std::string> found;
    for (const SourcePhrase& one : phrases_in({"x.cpp", source})) found.push_back(one.english + "|" + one.plural);
    EXPECT_EQ(found, (std::vector<std::string>{"one thing|", "{0} a|{0} \"b\"", "c|", "d|", "g|", "h|"}));
}

}  // namespace
}  // namespace tactics::catalogue_test
