// SPDX-License-Identifier: Apache-2.0
// One choice of language, as the user meets it.
#include "tactics/braille/tables.h"
#include "tests/cli/converting.h"

namespace tactics::language_choice_test {
namespace {

using namespace tests;

std::string table_of_language(const std::string& tag, const std::vector<BrailleTable>& all) { return table_for_tag(tag, all); }

TEST(TableForTag, IsTheOneThatAllReadersKnow) {
    const auto table = [](std::string name, std::vector<std::string> languages, std::string contraction, std::string dots = "6",
                          std::string type = "literary") {
        return BrailleTable{std::move(name),       std::move(languages), "", std::move(type), std::move(dots), "",
                            std::move(contraction)};
    };
    const std::vector<BrailleTable> all{
        table("xx-g2", {"xx"}, "full"),         table("xx-g0-detailed", {"xx"}, "no"),       table("xx-g0", {"xx"}, "no"),
        table("xx8", {"xx"}, "no", "8"),        table("xxc", {"xx"}, "no", "6", "computer"), table("xx-AT", {"xx-AT"}, "full"),
        table("yy-and-zz", {"yy", "zz"}, "no"), table("zz-partly", {"zz"}, "partial"),       table("ww8", {"ww"}, "no", "8")};
    EXPECT_EQ(table_of_language("xx", all), "xx-g0");
    EXPECT_EQ(table_of_language("XX-de", all), "xx-g0");
    EXPECT_EQ(table_of_language("xx-AT", all), "xx-AT") << "its own region comes first";
    EXPECT_EQ(table_of_language("zz", all), "zz-partly") << "the other is for yy";
    EXPECT_EQ(table_of_language("ww", all), "") << "an embosser would lose dots";
    EXPECT_EQ(table_of_language("vv", all), "");
    EXPECT_EQ(table_of_language("en-GB", all), kEnglishTable);
}

// Whatever liblouis is installed: the table of a language sets a word of it.
TEST(TableForTag, SetsWordsOfItsLanguage) {
    const Folder folder;
    write_bytes(folder / "disc.tif", disc_picture());
    for (const auto& [tag, word] : {std::pair{"de", "Größe"}, {"fr", "Élève"}, {"pl", "Żółw"}, {"ar", "قلب"}}) {
        const Ending end = run_tactics(folder, {"convert", "disc.tif", "-o", "a.svg", "--title", word, "--language", tag});
        EXPECT_EQ(end.code, 0) << end.err;
        EXPECT_TRUE(holds(end.err, std::string(", as the language is ") + tag)) << end.err;
        EXPECT_TRUE(holds(bytes_of(folder / "a.svg"), "xml:lang=\"" + std::string(tag) + "\""));
    }
}

using LanguageChoice = Convert;

TEST_F(LanguageChoice, BringsItsBrailleAndEachCanBeSetByItself) {
    const auto page = [&](Words words) {
        words.insert(words.begin(), {"disc.tif", "-q", "-r", "none", "-o", "p.brf", "--title", "Schöne Größe"});
        EXPECT_EQ(convert(words).code, 0);
        return bytes_of(folder / "p.brf");
    };
    const std::string german = page({"--language", "de"}), plain = page({});
    EXPECT_EQ(german, page({"--braille", "de-g0.utb"}));
    EXPECT_NE(german, plain);
    EXPECT_EQ(page({"--language", "de", "--braille", "en-ueb-g2.ctb"}), plain);
    EXPECT_EQ(page({"--language", "en-GB"}), plain);
    EXPECT_EQ(page({"--language", "de", "--braille", "none"}), page({"--braille", "none"}));
    EXPECT_TRUE(holds(convert({"disc.tif", "-o", "p.brf", "--title", "Disc", "--language", "tlh"}).err,
                      "no braille table is installed for the language tlh"));
}

TEST_F(LanguageChoice, ATableStaysWithItsLanguage) {
    const auto page = [&](const std::string& kept, Words words) {
        std::filesystem::create_directories(folder / "own/tactics");
        write_bytes(folder / "own/tactics/defaults", kept);
        words.insert(words.begin(), {"env", "XDG_CONFIG_HOME=" + (folder / "own").string(), TACTICS_PROGRAM, "convert",
                                     "disc.tif", "-q", "-r", "none", "-o", "p.brf", "--title", "Schiff und Sache"});
        EXPECT_EQ(run_tool(folder, words).code, 0);
        return bytes_of(folder / "p.brf");
    };
    const std::string contracted = page("", {"--braille", "de-g2.ctb"}), basic = page("", {"--braille", "de-g0.utb"});
    EXPECT_NE(contracted, basic);
    EXPECT_EQ(page("language de\n", {}), basic);
    EXPECT_EQ(page("language de\nbraille de-g2.ctb\n", {}), contracted);
    EXPECT_EQ(page("braille de-g2.ctb\n", {"--language", "de"}), contracted);
    EXPECT_EQ(page("braille de-g2.ctb\n", {"--language", "fr"}), page("", {"--language", "fr"}));
    EXPECT_EQ(page("braille none\n", {"--language", "fr"}), page("", {"--braille", "none"}));
}

TEST_F(LanguageChoice, ATitleInAnotherLanguageIsTold) {
    const auto told = [&](Words words) {
        words.insert(words.begin(), {"disc.tif", "-r", "none", "--warnings", "-o", "p.svg"});
        return convert(words).err;
    };
    EXPECT_EQ(
        told({"--title", "Größe und Höhe"}),
        "disc.tif: the title has ö, ß, which English does not write, and its braille (en-ueb-g2.ctb) is English; if the title is "
        "in another language, name that: --language de, for example\n");
    EXPECT_EQ(told({"--title", "Größe und Höhe", "--language", "de"}), "");
    EXPECT_EQ(told({"--title", "A café, 3 × 4"}), "");
    std::filesystem::rename(folder / "disc.tif", folder / "Größe.tif");
    EXPECT_TRUE(
        holds(convert({"Größe.tif", "-q", "--title-from-name", "-o", "p.svg", "--json"}).out, "which English does not write"));
}

}  // namespace
}  // namespace tactics::language_choice_test
