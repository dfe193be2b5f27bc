// SPDX-License-Identifier: Apache-2.0
// The user's language is that of the locale, as for gettext; what programs read is the same under each.
#include "cli/report/user_language.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/cli/picture.h"
#include "tests/cli/tool.h"
#include "tests/patterns.h"

namespace tactics::user_language_test {
namespace {

using namespace tests;

TEST(UserLanguage, IsThatOfTheLocale) {
    const auto of = [](const char* lang) { return language_of_locale(nullptr, nullptr, nullptr, lang); };
    for (const char* german : {"de", "de_DE.UTF-8", "de_AT.utf8", "de_DE.UTF-8@euro", "de_CH"})
        EXPECT_EQ(of(german), "de") << german;
    EXPECT_EQ(of("fr_CA.UTF-8"), "fr");
    for (const char* english : {"", "C", "POSIX", "C.UTF-8", "en_GB.UTF-8", "pl_PL.UTF-8", "de_DE.ISO-8859-1"})
        EXPECT_EQ(of(english), "en") << english;
    EXPECT_EQ(of("de_DE.ISO-8859-1"), "en") << "its letters could not be shown";
    EXPECT_EQ(of(nullptr), "en");
}

TEST(UserLanguage, TheVariablesCountInTheOrderOfGettext) {
    EXPECT_EQ(language_of_locale(nullptr, "fr_FR.UTF-8", "de_DE.UTF-8", "C"), "fr");
    EXPECT_EQ(language_of_locale(nullptr, "", "de_DE.UTF-8", "fr_FR.UTF-8"), "de");
    EXPECT_EQ(language_of_locale("fr:de", nullptr, nullptr, "en_GB.UTF-8"), "fr");
    EXPECT_EQ(language_of_locale("pl:de", nullptr, nullptr, "en_GB.UTF-8"), "de");
    EXPECT_EQ(language_of_locale("en:de", nullptr, nullptr, "de_DE.UTF-8"), "en");
    EXPECT_EQ(language_of_locale("de", "C", nullptr, nullptr), "en") << "scripts ask for C";
    EXPECT_EQ(language_of_locale("", nullptr, nullptr, "de_DE.UTF-8"), "de");
}

std::string without_times(const std::string& json) { return without(json, R"re(,"seconds":[0-9.e-]+)re"); }

// Turkish has another small I, Arabic other digits, German and French a comma: no byte of what a program reads depends on it.
TEST(UserLanguage, WhatProgramsReadIsTheSameInEveryLocale) {
    const Folder folder;
    write_bytes(folder / "disc.tif",
                grey_picture(200, 200, [](int x, int y) { return std::hypot(x - 100, y - 100) < 70 ? 0 : 255; }));
    write_bytes(folder / "data.csv", "time (s),length (mm)\n0,1.5\n1,2.5\n2,2.25\n");
    const std::vector<Words> commands{
        {"convert", "disc.tif", "-o", "page.svg", "-o", "page.pdf", "--title", "INITIAL", "--json"},
        {"convert", "disc.tif", "-o", "page.brf", "--language", "de", "--json"},
        {"convert", "none.tif", "-o", "none.svg", "--json"},
        {"describe", "disc.tif", "--json"},
        {"describe", "disc.tif", "--language", "fr"},
        {"chart", "data.csv", "-o", "chart.svg", "--json"},
        {"check", "page.svg", "none.svg", "--json"},
        {"check", "page.svg", "--format", "sarif", "--set", "gap.least=40mm"},
        {"check", "page.svg", "--format", "junit", "--set", "gap.least=40mm"},
        {"check", "page.svg", "--mark", "marked.svg", "--set", "gap.least=40mm", "--json"},
        {"measure", "disc.tif", "--media", "all", "--json"},
        {"preview", "page.brf", "--embosser", "generic", "--json"},
        {"defaults", "--json"},
        {"decode", "nothing.felt", "--json"},
        {"list", "--json"},
    };
    const auto outcome_in = [&](const std::string& locale) {
        std::string all;
        for (const Words& command : commands) {
            Words words{"env", "-u", "LANGUAGE", "LC_ALL=" + locale, TACTICS_PROGRAM};
            words.insert(words.end(), command.begin(), command.end());
            const Ending ending = run_tool(folder, words);
            all += command[0] + " " + std::to_string(ending.code) + "\n" + without_times(ending.out);
        }
        for (const char* file : {"page.svg", "page.pdf", "page.brf", "chart.svg", "marked.svg"}) all += bytes_of(folder / file);
        return all;
    };
    const std::string plain = outcome_in("C");
    EXPECT_TRUE(holds(plain, "\"lines\":[")) << plain;
    for (const char* locale : {"de_DE.UTF-8", "fr_FR.UTF-8", "tr_TR.UTF-8", "ar_EG.UTF-8"})
        EXPECT_EQ(outcome_in(locale), plain) << locale;
}

TEST(UserLanguage, WhatAPersonReadsIsInTheLanguageOfTheLocale) {
    const Folder folder;
    const auto says = [&](const std::string& locale) {
        return run_tool(folder,
                        {"env", "-u", "LANGUAGE", "LC_ALL=" + locale, TACTICS_PROGRAM, "convert", "none.tif", "-o", "a.pdf"})
            .err;
    };
    EXPECT_TRUE(says("de_DE.UTF-8").starts_with("tactics: none.tif: es gibt keine solche Datei")) << says("de_DE.UTF-8");
    EXPECT_TRUE(holds(says("fr_FR.UTF-8"), "ce fichier n\u2019existe pas")) << says("fr_FR.UTF-8");
    EXPECT_TRUE(says("pl_PL.UTF-8").starts_with("tactics: none.tif: there is no such file")) << says("pl_PL.UTF-8");
}

TEST(UserLanguage, WhatCheckSaysOfAPageIsInTheLanguageOfTheLocale) {
    const Folder folder;
    write_bytes(
        folder / "page.svg",
        std::string("<svg xmlns='http://www.w3.org/2000/svg' width='210mm' height='297mm' viewBox='0 0 210 297' fill='none' "
                    "stroke='#000' stroke-linecap='round'><path d='M20 50h100M20 53.5h100'/></svg>"));
    const auto says = [&](const std::string& locale) {
        return run_tool(folder, {"env", "-u", "LANGUAGE", "LC_ALL=" + locale, TACTICS_PROGRAM, "check", "page.svg"}).out;
    };
    const std::string german = says("de_DE.UTF-8"), french = says("fr_FR.UTF-8");
    EXPECT_TRUE(holds(german,
                      "mm von oben: ein Abstand von 2,5 mm zwischen zwei Linien, mindestens 3,2 mm n\u00f6tig; "
                      "auseinanderr\u00fccken oder verbinden (gap, zwingend)\n"))
        << german;
    EXPECT_TRUE(holds(
        french, "un espace de 2,5 mm entre deux lignes, minimum 3,2 mm\u00a0; \u00e9carter ou relier (gap, imp\u00e9rative)\n"))
        << french;
}

}  // namespace
}  // namespace tactics::user_language_test
