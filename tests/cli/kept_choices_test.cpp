// SPDX-License-Identifier: Apache-2.0
// Choices that are kept for all jobs, as their text and as the user meets them.
#include "cli/kept_choices.h"

#include "tests/cli/converting.h"
#include "tests/cli/fake_disk.h"

namespace tactics::kept_choices_test {
namespace {

using namespace tests;

std::string words_of(const std::string& text) {
    std::string all;
    for (const KeptChoice& choice : parse_kept(text, "f"))
        all += std::string(choice.word->name) + "=" + choice.value + "@" + choice.place + ";";
    return all;
}

TEST(KeptChoices, LinesAreReadAsOneMayWriteThem) {
    EXPECT_EQ(words_of("# mine\n\npaper a4\n  margin=15mm # wide\n--cell = marburg-medium\nbinding left=12mm\r\n"),
              "paper=a4@f:3;margin=15mm@f:4;cell=marburg-medium@f:5;binding=left=12mm@f:6;");
    EXPECT_EQ(words_of(""), "");
}

TEST(KeptChoices, WhatIsWrongIsToldWithItsLine) {
    const auto error = [](const std::string& text) { return error_of([&] { parse_kept(text, "f"); }); };
    EXPECT_TRUE(error("paper a4\npapper a4").starts_with("1 f:2: \"papper\" cannot be kept (paper?)"));
    EXPECT_TRUE(error("#\n\npaper b12").starts_with("1 f:3: there is no paper \"b12\""));
    EXPECT_TRUE(error("paper").starts_with("1 f:1: the value is missing"));
    EXPECT_TRUE(error("paper a4\nmargin 1mm\npaper a5").starts_with("1 f:3: paper stands in line 1, too"));
    EXPECT_TRUE(error("margin -1mm").starts_with("1 f:1: it cannot be \"-1mm\""));
    EXPECT_TRUE(error("machine dot-pad").starts_with("1 f:1: dot-pad is a display"));
    EXPECT_TRUE(error("braille own/table.ctb").starts_with("1 f:1: a braille table of your own is kept by its whole path"));
    EXPECT_TRUE(error(std::string(70'000, '#')).starts_with("1 f: it is over 64 KB"));
    for (const KeptWord& word : kept_words())
        EXPECT_TRUE(word.name == "braille" || error(std::string(word.name) + " \x01") != "no error") << word.name;
}

// The text is edited as a person would: what is read of it changes in that word alone, and all other lines stay.
TEST(KeptChoices, OneLineIsChangedAndNoOther) {
    const std::string text = "# mine\npaper a4 # of the office\n\nlanguage de\npaper=a5\nlast";
    EXPECT_EQ(with_choice(text, "paper", "a3"), "# mine\npaper a3\n\nlanguage de\nlast\n");
    EXPECT_EQ(with_choice(text, "margin", "1mm"),
              "# mine\npaper a4 # of the office\n\nlanguage de\npaper=a5\nlast\nmargin 1mm\n");
    EXPECT_EQ(without_choice(text, "paper"), "# mine\n\nlanguage de\nlast\n");
    EXPECT_EQ(without_choice(text, "cell") + "|", text + "\n|");
    EXPECT_EQ(with_choice("", "paper", "a3"), "paper a3\n");
}

class KeptByUser : public Convert {
protected:
    Ending tactics(Words words) {
        words.insert(words.begin(), {"env", "XDG_CONFIG_HOME=" + (folder / "own").string(),
                                     "XDG_CONFIG_DIRS=relative:" + (folder / "all").string(), TACTICS_PROGRAM});
        return run_tool(folder, words);
    }
    void keep(const std::string& where, const std::string& text) {
        std::filesystem::create_directories(folder / where / "tactics");
        write_bytes(folder / where / "tactics/defaults", text);
    }
    std::string bytes(const std::string& name) { return bytes_of(folder / name); }
};

TEST_F(KeptByUser, OwnChoicesComeBeforeThoseOfTheMachine) {
    keep("all", "paper a5\nmargin 20mm\n");
    EXPECT_EQ(tactics({"defaults", "set", "paper", "letter"}).code, 0);
    EXPECT_EQ(bytes("own/tactics/defaults"), "paper letter\n");
    const std::string told = tactics({"defaults"}).out;
    const std::string own = (folder / "own/tactics/defaults:1").string(), all = (folder / "all/tactics/defaults").string();
    EXPECT_TRUE(holds(told, "paper letter (" + own + "), instead of a5 (" + all + ":1)\n")) << told;
    EXPECT_TRUE(holds(told, "margin 20mm (" + all + ":2)\n")) << told;
    EXPECT_TRUE(holds(told, "medium: not kept"));
    EXPECT_TRUE(holds(tactics({"defaults", "--json"}).out, "\"value\":\"letter\",\"place\":\"" + own + "\",\"instead_of\":[{"));

    // A page with what is kept is the page with the same words typed; without, it is as if there were none.
    EXPECT_EQ(tactics({"convert", "disc.tif", "-q", "-o", "kept.svg"}).code, 0);
    EXPECT_EQ(convert({"disc.tif", "-q", "-o", "typed.svg", "--paper", "letter", "--margin", "20mm"}).code, 0);
    EXPECT_EQ(tactics({"convert", "disc.tif", "-q", "-o", "none.svg", "--no-defaults"}).code, 0);
    EXPECT_EQ(convert({"disc.tif", "-q", "-o", "plain.svg"}).code, 0);
    EXPECT_EQ(bytes("kept.svg"), bytes("typed.svg"));
    EXPECT_EQ(bytes("none.svg"), bytes("plain.svg"));
    EXPECT_NE(bytes("kept.svg"), bytes("plain.svg"));

    EXPECT_EQ(tactics({"defaults", "unset", "paper"}).code, 0);
    EXPECT_EQ(bytes("own/tactics/defaults"), "");
    EXPECT_TRUE(holds(tactics({"defaults", "unset", "paper"}).err, "paper is not kept in "));
    EXPECT_EQ(tactics({"convert", "disc.tif", "-q", "-o", "kept.svg", "-p", "a4", "--margin", "12.7mm"}).code, 0);
    EXPECT_EQ(bytes("kept.svg"), bytes("plain.svg"));
}

TEST_F(KeptByUser, WhatDoesNotFitGivesWay) {
    keep("own", "paper a3\nembosser-paper a4\nmargin 30mm\nbinding left=15mm\ncell nls\nmedium plain\n");
    Words words{"convert", "disc.tif", "-q", "--title", "Disc"}, made;
    for (const std::string name : {"brf:p", "index-v3:q", "dot-pad:r", "braille-display:s"})
        words.insert(words.end(), {"-o", name});
    const Ending kept = tactics(words);
    ASSERT_EQ(kept.code, 0) << kept.err;
    for (const std::string name : {"p", "q", "r", "s"}) made.push_back(bytes(name));
    words.erase(words.begin());
    EXPECT_EQ(convert({"disc.tif", "-q", "--title", "Disc", "-o", "brf:p", "-o", "index-v3:q", "-p", "a4"}).code, 0);
    EXPECT_EQ(convert({"disc.tif", "-q", "--title", "Disc", "-o", "dot-pad:r", "-o", "braille-display:s"}).code, 0);
    for (std::size_t i = 0; i < made.size(); ++i) EXPECT_EQ(made[i], bytes(std::string(1, static_cast<char>('p' + i)))) << i;
    EXPECT_EQ(tactics({"convert", "disc.tif", "-q", "--bare", "-o", "bare.svg"}).code, 0);
    keep("own", "margin 90mm\npaper a5\n");
    EXPECT_TRUE(
        tactics({"convert", "disc.tif", "-o", "p.pdf"})
            .err.starts_with("tactics: " + (folder / "own/tactics/defaults:1").string() + ": margins of 90 mm leave nothing"));
}

TEST_F(KeptByUser, ErrorsNameFileAndLineAndLeaveTheRestUsable) {
    keep("own", "paper a4\nmedium swel\n");
    const std::string line = (folder / "own/tactics/defaults:2").string();
    const Ending end = tactics({"convert", "disc.tif", "-o", "p.pdf"});
    EXPECT_EQ(end.code, 1);
    EXPECT_TRUE(end.err.starts_with("tactics: " + line + ": there is no medium \"swel\"")) << end.err;
    EXPECT_EQ(tactics({"convert", "disc.tif", "-q", "-o", "p.pdf", "--no-defaults"}).code, 0);
    EXPECT_EQ(tactics({"help"}).code, 0);
    EXPECT_EQ(tactics({"defaults", "set", "medium", "plain"}).code, 0);
    EXPECT_EQ(tactics({"convert", "disc.tif", "-q", "-o", "p.pdf"}).code, 0);
    EXPECT_EQ(tactics({"defaults", "set", "medium", "swel"}).code, 1);
    EXPECT_EQ(tactics({"defaults", "set", "braille", "nosuch.ctb"}).code, 1);
    EXPECT_EQ(bytes("own/tactics/defaults"), "paper a4\nmedium plain\n");
    keep("own", "braille nosuch.ctb\n");
    EXPECT_TRUE(tactics({"convert", "disc.tif", "-o", "p.pdf", "--title", "Disc"})
                    .err.starts_with("tactics: " + (folder / "own/tactics/defaults:1").string() + ": there is no braille table"));
}

TEST_F(KeptByUser, AMachineIsThatOfEveryCommand) {
    EXPECT_TRUE(holds(tactics({"convert", "disc.tif", "-o", "page.prn"}).err, "as in index-v4:page.prn"));
    EXPECT_TRUE(holds(tactics({"preview", "disc.tif"}).err, "name the machine"));
    EXPECT_EQ(tactics({"defaults", "set", "machine", "index-v3"}).code, 0);
    EXPECT_EQ(tactics({"convert", "disc.tif", "-q", "-o", "page.prn", "-o", "index-v3:named"}).code, 0);
    EXPECT_EQ(bytes("page.prn"), bytes("named"));
    EXPECT_EQ(tactics({"preview", "page.prn"}).out, run_tactics(folder, {"preview", "page.prn", "-e", "index-v3"}).out);
    EXPECT_EQ(tactics({"emboss", "page.prn", "--to", "./sent", "--from-page", "1"}).code, 0);
    EXPECT_EQ(tactics({"emboss", "page.prn", "--to", "./sent", "--from-page", "1", "--no-defaults"}).code, 0);
    EXPECT_EQ(tactics({"emboss", "page.prn", "--to", "./sent", "--from-page", "2", "--no-defaults"}).code, 1);
}

TEST_F(KeptByUser, RecipesAreFoundByName) {
    for (const std::string where : {"own", "all"}) {
        std::filesystem::create_directories(folder / where / "tactics/recipes");
        write_bytes(folder / where / "tactics/recipes/mine.recipe",
                    where == "own" ? "# bold\nthreshold\n" : "invert\nthreshold\n");
    }
    write_bytes(folder / "own/tactics/recipes/photo.recipe", "threshold\n");
    write_bytes(folder / "own/tactics/recipes/bad.recipe", "treshold\n");
    const std::string file = (folder / "own/tactics/recipes/mine.recipe").string();
    const std::string list = tactics({"list", "recipes"}).out;
    EXPECT_TRUE(holds(list, "\nmine: bold (" + file + ")\n")) << list;
    EXPECT_TRUE(holds(list, "\nbad: it cannot be used: "));
    EXPECT_FALSE(holds(list, "photo.recipe")) << "that name is the program's";
    EXPECT_TRUE(holds(tactics({"help", "mine"}).out, "  threshold\n"));
    EXPECT_EQ(tactics({"convert", "disc.tif", "-q", "-r", "mine", "-o", "a.svg"}).code, 0);
    EXPECT_EQ(convert({"disc.tif", "-q", "-r", file, "-o", "b.svg"}).code, 0);
    EXPECT_EQ(bytes("a.svg"), bytes("b.svg"));
    EXPECT_TRUE(holds(tactics({"convert", "disc.tif", "-r", "mien", "-o", "a.svg"}).err, "(mine?)"));
    EXPECT_TRUE(holds(tactics({"convert", "disc.tif", "-r", "bad", "-o", "a.svg"}).err, "bad.recipe:1: there is no filter"));
    EXPECT_EQ(tactics({"convert", "disc.tif", "-r", "mine", "-o", "a.svg", "--no-defaults"}).code, 1);
    // A file in the folder that one is in stays what it was.
    write_bytes(folder / "mine", "invert\nthreshold\n");
    EXPECT_EQ(tactics({"convert", "disc.tif", "-q", "-r", "mine", "-o", "c.svg"}).code, 0);
    EXPECT_NE(bytes("c.svg"), bytes("a.svg"));
    // What is made for others does not have them.
    EXPECT_EQ(tactics({"completion", "bash"}).out, run_tactics(folder, {"completion", "bash"}).out);
    EXPECT_EQ(tactics({"help", "--man"}).out, run_tactics(folder, {"help", "--man"}).out);
}

}  // namespace
}  // namespace tactics::kept_choices_test
