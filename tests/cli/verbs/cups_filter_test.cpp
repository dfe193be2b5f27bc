// SPDX-License-Identifier: Apache-2.0
// The program as CUPS calls it: by its name as a filter, with a PPD file of its own.
#include "cli/verbs/cups_filter.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <thread>

#include "cli/verbs/ppd.h"
#include "cli/verbs/print_options.h"
#include "print/embosser.h"
#include "tactics/braille/braille.h"
#include "tests/cli/converting.h"
#include "tests/cli/pdf_files.h"
#include "tests/cli/print_user.h"

namespace tactics::cups_filter_test {
namespace {

using namespace tests;
using Pairs = std::vector<std::pair<std::string, std::string>>;

class CupsFilter : public Convert {
protected:
    void SetUp() override {
        Convert::SetUp();
        if (!print_user_reaches(TACTICS_PROGRAM)) GTEST_SKIP() << "the user of print filters may not enter the build folder";
        std::filesystem::create_symlink(TACTICS_PROGRAM, folder / std::string(kCupsFilterName));
        write_bytes(folder / "e.ppd", run_tactics(folder, {"ppd", "index-v4"}).out);
    }
    // As CUPS: the name of the queue where a program's own name would be.
    Ending filter(const std::string& options, const std::string& file, const std::string& input = "",
                  const std::string& copies = "1") {
        const std::string words = "1 me title " + copies + " \"$1\"" + (file.empty() ? "" : " " + file);
        return run_tool(
            folder, {"bash", "-c", "PPD=e.ppd exec -a Queue ./" + std::string(kCupsFilterName) + " " + words, "bash", options},
            input);
    }
};

TEST_F(CupsFilter, GivesTheBytesOfConvert) {
    const std::string bytes = convert({"disc.tif", "-q", "-o", "index-v4:-"}).out;
    ASSERT_FALSE(bytes.empty());
    const Ending file = filter("", "disc.tif");
    EXPECT_EQ(file.code, 0) << file.err;
    EXPECT_EQ(file.out, bytes);
    EXPECT_TRUE(holds(file.err, "PAGE: 1 1\n")) << file.err;
    EXPECT_EQ(filter("", "", bytes_of(folder / "disc.tif")).out, bytes);
    EXPECT_EQ(filter("", "disc.tif", "", "2").out, bytes + bytes);
    EXPECT_EQ(
        filter("TacticsPitch=2.0 media=Letter,upper noTacticsSomething TacticsRecipe=diagram", "disc.tif").out,
        convert({"disc.tif", "-q", "-o", "index-v4:-", "--set", "index-v4.pitch=2.0", "--paper", "letter", "-r", "diagram"}).out);
}

TEST_F(CupsFilter, TakesEveryPageOfAPdf) {
    if (!has_tool("pdfunite") || !has_tool("pdftocairo")) GTEST_SKIP() << "poppler-utils is missing";
    ASSERT_EQ(convert({"disc.tif", "-q", "-o", "a.pdf"}).code, 0);
    ASSERT_EQ(convert({"disc.tif", "-q", "-o", "b.pdf", "--title", "B"}).code, 0);
    ASSERT_EQ(run_tool(folder, {"pdfunite", "a.pdf", "b.pdf", "both.pdf"}).code, 0);
    const std::string first = convert({"both.pdf", "-q", "-o", "index-v4:-"}).out,
                      second = convert({"both.pdf", "-q", "--page", "2", "-o", "index-v4:-"}).out;
    EXPECT_NE(first, second);
    EXPECT_EQ(filter("", "both.pdf").out, first + second);
    EXPECT_TRUE(holds(convert({"both.pdf", "-o", "c.svg"}).err, "both.pdf: this is page 1 of 2; --page 2 is the next"));
    EXPECT_TRUE(holds(convert({"both.pdf", "--page", "3", "-o", "c.svg"}).err, "there is no page 3, but pages 1 to 2"));
    EXPECT_TRUE(holds(convert({"disc.tif", "--page", "2", "-o", "c.svg"}).err, "--page: disc.tif is no PDF"));
    EXPECT_EQ(convert({"-", "-q", "-o", "index-v4:-"}, bytes_of(folder / "both.pdf")).out, first);
}

// A text of several pages goes on from page to page, and is numbered as the sheets are that come out.
TEST_F(CupsFilter, LaysOutPagesOfTextTogether) {
    if (!has_tool("pdftotext")) GTEST_SKIP() << "poppler-utils is missing";
    std::vector<std::string> pages;
    for (int page = 0; page < 6; ++page) {
        std::string content = "BT /F 8 Tf 9 TL 20 280 Td ";
        for (int line = 0; line < 30; ++line) content += "(these are nine words of a page of text) Tj T* ";
        pages.push_back(content + "ET");
    }
    write_bytes(folder / "text.pdf", pdf_pages(pages));
    const Ending made = filter("TacticsBraille=en-us-comp6.ctb", "text.pdf");
    EXPECT_EQ(made.code, 0) << made.err;
    EXPECT_EQ(made.out, convert({"text.pdf", "--text", "-q", "-o", "index-v4:-", "--braille", "en-us-comp6.ctb"}).out);
    EXPECT_TRUE(holds(made.err, "PAGE: 6 1\n") && holds(made.err, "INFO: laying out pages 1 to 6 of 6\n")) << made.err;
    // Behind a page that is drawn, the numbers go on.
    pages.insert(pages.begin() + 3, "2 w 60 60 280 180 re S");
    write_bytes(folder / "both.pdf", pdf_pages(pages));
    const Ending both = filter("TacticsBraille=en-us-comp6.ctb", "both.pdf");
    EXPECT_EQ(both.code, 0) << both.err;
    std::size_t told = 0;
    for (auto at = both.err.find("PAGE: "); at != both.err.npos; at = both.err.find("PAGE: ", at + 1)) ++told;
    EXPECT_TRUE(holds(both.err, "PAGE: " + std::to_string(told) + " 1\n")) << both.err;
    EXPECT_TRUE(holds(both.err, "page 4 of 7\n") && holds(both.err, "pages 5 to 7 of 7\n")) << both.err;
    write_bytes(folder / "end.pdf", pdf_pages({pages[4], pages[5], pages[6]}));
    const std::string end = filter("TacticsBraille=en-us-comp6.ctb", "end.pdf").out;
    EXPECT_FALSE(both.out.ends_with(end.substr(end.size() / 2)));
    const Ending twice = filter("TacticsBraille=en-us-comp6.ctb", "both.pdf", "", "2");
    EXPECT_EQ(twice.out, both.out + both.out);
    EXPECT_TRUE(holds(twice.err, "PAGE: " + std::to_string(2 * told) + " 1\n")) << twice.err;
    // Without braille it is drawn.
    write_bytes(folder / "one.pdf", pdf_page(pages.front()));
    const Ending drawn = filter("TacticsBraille=none", "one.pdf");
    EXPECT_EQ(drawn.code, 0) << drawn.err;
    EXPECT_FALSE(drawn.out.empty());
}

TEST_F(CupsFilter, SaysWhatIsWrongAsCupsReadsIt) {
    const Ending missing = filter("", "missing.pdf");
    EXPECT_EQ(missing.code, 1);
    EXPECT_TRUE(missing.err.starts_with("ERROR: missing.pdf: there is no such file")) << missing.err;
    const Ending words = run_tool(folder, {"./" + std::string(kCupsFilterName), "convert"});
    EXPECT_EQ(words.code, 1);
    EXPECT_TRUE(words.err.starts_with("ERROR: tacticstoembosser: is called by CUPS")) << words.err;
    write_bytes(folder / "e.ppd", "*PPD-Adobe: \"4.3\"\n");
    EXPECT_TRUE(holds(filter("", "disc.tif").err, "names no embosser; set the queue up again with a PPD file of tactics ppd"));
}

TEST_F(CupsFilter, TakesTitleLabelsDetailAndLanguage) {
    const auto made = [&](Words words) {
        words.insert(words.begin(), {"disc.tif", "-q", "-o", "index-v4:-"});
        return convert(words).out;
    };
    const std::string german = made({"--title", "Schöne Größe", "--language", "de"});
    EXPECT_NE(german, made({"--title", "Schöne Größe"}));
    EXPECT_EQ(filter("TacticsTitle='Schöne Größe' TacticsLanguage=de", "disc.tif").out, german);
    EXPECT_EQ(filter("TacticsLanguage=de TacticsBraille=en-ueb-g2.ctb TacticsTitle='Schöne Größe'", "disc.tif").out,
              made({"--title", "Schöne Größe"}));
    EXPECT_EQ(filter("TacticsTitle=job", "disc.tif").out, made({"--title", "title"})) << "the third word of CUPS";
    EXPECT_EQ(filter("TacticsRecipe=photo TacticsDetail=contours", "disc.tif").out,
              made({"-r", "photo", "--detail", "contours"}));
    EXPECT_EQ(filter("TacticsRecipe=photo TacticsDetail=best", "disc.tif").out, made({"-r", "photo", "--detail", "best"}));
    EXPECT_EQ(filter("TacticsLabels='5%,5%=Ring; 90%,90%=Way=out;' TacticsRecipe=none", "disc.tif").out,
              made({"-r", "none", "--label", "5%,5%=Ring", "--label", "90%,90%=Way=out"}));
    EXPECT_TRUE(
        filter("TacticsLabels=file.labels", "disc.tif").err.starts_with("ERROR: TacticsLabels 1: it is a place with words"));
    EXPECT_TRUE(
        filter("TacticsLanguage=../de", "disc.tif").err.starts_with("ERROR: TacticsLanguage: this queue offers no such choice"));
    EXPECT_TRUE(filter("TacticsDetail=3", "disc.tif").err.starts_with("ERROR: TacticsDetail: this queue offers no such choice"));
    // What a person keeps is none of a print job's.
    std::filesystem::create_directories(folder / "own/tactics");
    write_bytes(folder / "own/tactics/defaults", "language de\nembosser-paper a5\nnonsense\n");
    const std::string plain = made({"--title", "title"});
    const Ending kept = run_tool(folder, {"bash", "-c",
                                          "XDG_CONFIG_HOME=$PWD/own PPD=e.ppd exec -a Queue ./" + std::string(kCupsFilterName) +
                                              " 1 me title 1 TacticsTitle=job disc.tif"});
    EXPECT_EQ(kept.out, plain) << kept.err;
}

// What was tried on it: a file named as recipe, as braille table, and lines for CUPS within a wish.
TEST_F(CupsFilter, TakesOnlyWhatItsPpdOffers) {
    write_bytes(folder / "secret", "a secret line\n");
    write_bytes(folder / "own.recipe", "invert\n");
    write_bytes(folder / "own.ctb", "include own.ctb\n");
    const std::string own = folder.path().string() + "/";
    for (const std::string& name : {std::string("TacticsRecipe"), std::string("TacticsBraille")})
        for (const std::string value : {"secret", "own.recipe", "own.ctb", "../own.ctb", "", "en-ueb-g2.ctb,own.ctb",
                                        "none,own.ctb", "'photo\nPPD: DefaultTacticsRecipe=secret'"})
            for (const std::string& place : {std::string(), own}) {
                const Ending ending = filter(name + "=" + place + value, "disc.tif");
                EXPECT_EQ(ending.code, 1) << name << "=" << place << value;
                EXPECT_EQ(ending.out, "");
                EXPECT_EQ(ending.err, "ERROR: " + name +
                                          ": this queue offers no such choice; lpoptions -p QUEUE -l lists them, and a queue of "
                                          "an older PPD file is set up again with one of tactics ppd\n");
            }
    // The PPD file itself cannot name files either, whoever wrote it.
    const std::string ppd = bytes_of(folder / "e.ppd");
    for (const std::string& table : {own + "own.ctb", std::string("own.ctb")}) {
        write_bytes(folder / "e.ppd", ppd + "*TacticsBraille " + table + ": \"\"\n*DefaultTacticsBraille: " + table + "\n");
        EXPECT_TRUE(filter("", "disc.tif").err.starts_with("ERROR: TacticsBraille: ")) << table;
    }
    write_bytes(folder / "e.ppd", ppd + "*TacticsRecipe own.recipe: \"\"\n");
    EXPECT_TRUE(filter("TacticsRecipe=own.recipe", "disc.tif").err.starts_with("ERROR: TacticsRecipe: there is no recipe"));
    write_bytes(folder / "e.ppd", ppd);
    const Ending words = filter("TacticsWords='x\nPPD: a=b'", "disc.tif");
    EXPECT_EQ(words.code, 1);
    EXPECT_EQ(lines_in(words.err), 1u) << words.err;
    EXPECT_EQ(filter("TacticsBraille=de-g1.ctb", "disc.tif").code, 0);
    EXPECT_EQ(filter("TacticsBraille=none TacticsRecipe=auto", "disc.tif").code, 0);
}

// Programs and places of files are those of the system, whatever the filter's environment sets.
TEST_F(CupsFilter, FixesItsSurroundings) {
    if (!has_tool("pdftocairo")) GTEST_SKIP() << "poppler-utils is missing";
    ASSERT_EQ(convert({"disc.tif", "-q", "-o", "a.pdf"}).code, 0);
    for (const char* program : {"pdftocairo", "pdfinfo", "tesseract"}) {
        write_bytes(folder / program, "#!/bin/sh\necho ran >&2\nexit 1\n");
        std::filesystem::permissions(folder / program, std::filesystem::perms::all);
    }
    const std::string plain = filter("", "a.pdf").out;
    EXPECT_FALSE(plain.empty());
    const Ending steered =
        run_tool(folder, {"bash", "-c",
                          "PATH=.:$PATH TMPDIR=/nowhere LC_ALL=de_DE.UTF-8 LOUIS_TABLEPATH=. TESSDATA_PREFIX=. "
                          "PPD=e.ppd exec ./tacticstoembosser 1 me title 1 '' a.pdf"});
    EXPECT_EQ(steered.code, 0) << steered.err;
    EXPECT_EQ(steered.out, plain);
}

// As who it runs is told by the kernel while it waits for a job that does not come.
TEST_F(CupsFilter, GivesUpTheRightsOfRootBeforeItReads) {
    if (geteuid() != 0) GTEST_SKIP() << "only root has rights to give up";
    ASSERT_EQ(mkfifo((folder / "job").c_str(), 0600), 0);
    const Folder streams;
    const int job = open((folder / "job").c_str(), O_RDWR | O_CLOEXEC);
    const pid_t filter =
        start(folder, {"env", "PPD=e.ppd", "./tacticstoembosser", "1", "me", "title", "1", "", "job"}, streams.path(), "");
    const passwd* user = print_user();
    ASSERT_NE(user, nullptr);
    const std::string id = std::to_string(user->pw_uid), group = std::to_string(user->pw_gid);
    const auto four = [](const std::string& number) { return number + "\t" + number + "\t" + number + "\t" + number + "\n"; };
    const std::string wanted = "Uid:\t" + four(id) + "Gid:\t" + four(group);
    std::string status;
    for (int i = 0; i < 1000 && !holds(status, wanted); ++i) {
        status = bytes_of("/proc/" + std::to_string(filter) + "/status");
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    EXPECT_TRUE(holds(status, wanted)) << status;
    EXPECT_TRUE(holds(status, "Groups:\t" + group + " \n")) << status;
    EXPECT_TRUE(holds(status, "CapEff:\t0000000000000000\n")) << status;
    const std::string picture = bytes_of(folder / "disc.tif");
    EXPECT_EQ(write(job, picture.data(), picture.size()), static_cast<ssize_t>(picture.size()));
    close(job);
    const Ending ending = end_of(filter, streams.path());
    EXPECT_EQ(ending.code, 0) << ending.err;
    EXPECT_FALSE(ending.out.empty());
}

TEST_F(CupsFilter, EveryPpdIsTakenByCups) {
    if (!has_tool("cupstestppd")) GTEST_SKIP() << "cupstestppd is missing";
    for (const Format* format : formats()) {
        if (format->embosser == nullptr || format->embosser->display != nullptr) continue;
        write_bytes(folder / "one.ppd", run_tactics(folder, {"ppd", std::string(format->name)}).out);
        // The filter is not installed here.
        const Ending ending = run_tool(folder, {"cupstestppd", "-I", "filters", "one.ppd"});
        EXPECT_EQ(ending.code, 0) << format->name << ": " << ending.out;
    }
    EXPECT_TRUE(holds(run_tactics(folder, {"ppd", "index"}).err, "there is no embosser \"index\""));
}

TEST(CupsOptions, AreRead) {
    EXPECT_EQ(parse_cups_options("a=b  flag nofold c='d e' f=\"g\\\"h\" i=j\\ k"),
              (Pairs{{"a", "b"}, {"flag", "true"}, {"fold", "false"}, {"c", "d e"}, {"f", "g\"h"}, {"i", "j k"}}));
    EXPECT_EQ(parse_cups_options(""), Pairs{});
    EXPECT_EQ(parse_cups_options("a=b=c no x="), (Pairs{{"a", "b=c"}, {"no", "true"}, {"x", ""}}));
    EXPECT_EQ(parse_cups_options("a='b"), (Pairs{{"a", "b"}}));
}

TEST(Ppd, TellsItsChoicesAndDefaults) {
    const PpdWords words = parse_ppd(
        "*PPD-Adobe: \"4.3\"\r\n*TacticsEmbosser: \"index-v4\"\n*OpenUI *TacticsRecipe/Recipe: PickOne\n*DefaultTacticsRecipe: "
        "photo\r\n"
        "*TacticsRecipe photo/photo: \"\"\n*TacticsRecipe map: \"\"\nTacticsRecipe no/no: \"\"\n*DefaultPageSize:A4");
    EXPECT_EQ(words.embosser, "index-v4");
    EXPECT_EQ(words.defaults, (Pairs{{"TacticsRecipe", "photo"}, {"PageSize", "A4"}}));
    EXPECT_EQ(words.choices.at("TacticsRecipe"), (std::set<std::string>{"photo", "map"}));
    // What we write offers all of it.
    const PpdWords own = parse_ppd(ppd_of(*find_format("index-v4"), "filter"));
    EXPECT_TRUE(own.choices.at("TacticsRecipe").contains("auto"));
    for (const std::string& table : braille_tables()) EXPECT_TRUE(own.choices.at("TacticsBraille").contains(table)) << table;
    EXPECT_GT(own.choices.at("TacticsBraille").size(), 2u);
}

TEST(Ppd, NamesPapersAsTheSpecificationDoes) {
    EXPECT_EQ(paper_of_ppd("A4"), "a4");
    EXPECT_EQ(paper_of_ppd("Letter"), "letter");
    EXPECT_EQ(paper_of_ppd("Tabloid"), "11x17");
    EXPECT_EQ(paper_of_ppd("w720h792"), "254x279.4mm");
    for (const char* none : {"", "w", "w1", "wxhy", "Nothing"}) EXPECT_EQ(paper_of_ppd(none), "") << none;
}

}  // namespace
}  // namespace tactics::cups_filter_test
