// SPDX-License-Identifier: Apache-2.0
// `convert --update`: what is made anew, and why.
#include "cli/command.h"
#include "cli/page_choices.h"
#include "cli/request.h"
#include "tests/cli/converting.h"
#include "tests/cli/fake_disk.h"

namespace tactics::update_test {
namespace {

using namespace tests;

class Update : public Convert {
protected:
    // What is told after the time of the picture, with its semicolon; "up to date" if nothing is done.
    std::string told(Words words) {
        words.insert(words.end(), {"-r", "none", "--update"});
        const Ending end = convert(words);
        EXPECT_EQ(end.code, 0) << end.err;
        if (holds(end.err, ": up to date\n")) return "up to date";
        const auto why = end.err.find("; made anew: ");
        return why == std::string::npos ? "made" : end.err.substr(why + 13, end.err.find('\n', why) - why - 13);
    }
};

TEST_F(Update, OtherSettingsMakeAPageAnewAndAreTold) {
    const Words plain{"disc.tif", "-o", "page.svg"};
    Words wide = plain, titled = plain;
    wide.insert(wide.end(), {"--margin", "20mm"});
    titled.insert(titled.end(), {"--margin", "15mm", "--title", "Disc"});
    EXPECT_EQ(told(plain), "made");
    const std::string first = bytes_of(folder / "page.svg");
    EXPECT_EQ(told(plain), "up to date");
    EXPECT_EQ(told(wide), "--margin 20mm is new");
    EXPECT_NE(bytes_of(folder / "page.svg"), first);
    EXPECT_EQ(told(wide), "up to date");
    EXPECT_EQ(told(titled), "--margin 15mm, was 20mm, --title Disc is new");
    EXPECT_EQ(told(plain), "--margin 15mm is gone, --title Disc is gone");
    EXPECT_EQ(bytes_of(folder / "page.svg"), first) << "the page holds nothing of how it was made";
    EXPECT_EQ(names(), "disc.tif page.svg");
    EXPECT_EQ(names(".tactics"), "page.svg");
    EXPECT_TRUE(
        holds(convert({"disc.tif", "-o", "page.svg", "--update", "--json"}).out, "\"made_anew\":[\"--recipe none is gone\"]"));
}

TEST_F(Update, APageOfSomebodyElseIsMadeAnew) {
    const Words plain{"disc.tif", "-o", "page.svg"};
    EXPECT_EQ(told(plain), "made");
    const std::string own = bytes_of(folder / "page.svg");
    for (const std::string& other : {std::string(), std::string("damaged"), own + "\n"}) {
        write_bytes(folder / "page.svg", other);
        EXPECT_EQ(told(plain), "page.svg is not what was written there");
        EXPECT_EQ(bytes_of(folder / "page.svg"), own);
    }
}

TEST_F(Update, APageThatBreaksAHardRuleIsNeverUpToDateWhereThatCounts) {
    const std::string start =
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100mm\" height=\"100mm\" viewBox=\"0 0 100 100\">"
        "<path fill=\"none\" stroke=\"#000\" d=\"M10 10h80";
    write_bytes(folder / "hard.svg", start + "M10 11h80\"/></svg>");  // lines 1 mm apart
    write_bytes(folder / "good.svg", start + "M10 50h80\"/></svg>");
    const auto end = [&](const std::string& name, bool strict) {
        Words words{name, "-o", "out/", "--as-drawn", "--update"};
        if (strict) words.push_back("--strict");
        return convert(words);
    };
    for (int i = 0; i < 2; ++i) EXPECT_EQ(end("hard.svg", true).code, 3);
    EXPECT_TRUE(holds(end("hard.svg", true).err, "breaks a hard rule, or was not checked"));
    EXPECT_TRUE(holds(end("hard.svg", false).err, "up to date")) << "nobody asked";
    EXPECT_EQ(end("good.svg", false).code, 0);
    EXPECT_TRUE(holds(end("good.svg", true).err, "up to date")) << "each page is checked, asked for or not";
}

TEST_F(Update, AFileNamedByAnOptionCountsByWhatIsInIt) {
    write_bytes(folder / "likes.txt", "reach 1\n");
    const auto choices = [&](const Words& words) {
        const Given given = parse_words(*find_command("convert"), words);
        return page_choices(*find_command("convert"), given, {});
    };
    const std::string likes = (folder / "likes.txt").string();
    const MadeWith before = choices({"a.wrl", "--reader", likes});
    EXPECT_EQ(before, choices({"a.wrl", "--reader", likes}));
    write_bytes(folder / "likes.txt", "reach 2\n");
    EXPECT_NE(before, choices({"a.wrl", "--reader", likes}));
    EXPECT_NE(choices({"a.wrl", "--label", "50%,50%=a, 20%,20%=b"}),
              choices({"a.wrl", "--label", "50%,50%=a", "--label", "20%,20%=b"}));
}

TEST_F(Update, AConversionWithoutItKeepsTheRecordTrue) {
    const Words plain{"disc.tif", "-o", "page.svg"};
    EXPECT_EQ(convert({"disc.tif", "-q", "-r", "none", "-o", "page.svg"}).code, 0);
    EXPECT_FALSE(std::filesystem::exists(folder / ".tactics")) << "nobody asked for a record";
    EXPECT_EQ(told(plain), "there is no record of how page.svg was made");
    EXPECT_EQ(convert({"disc.tif", "-q", "-r", "none", "-o", "page.svg", "--bare"}).code, 0);
    EXPECT_EQ(told(plain), "--bare is gone");
    // A batch has records from the first, so that one that was cut short goes on.
    EXPECT_EQ(convert({"disc.tif", "-q", "-r", "none", "-o", "out/"}).code, 0);
    EXPECT_EQ(told({"disc.tif", "-o", "out/"}), "up to date");
    write_bytes(folder / "out/.tactics/disc.pdf", bytes_of(folder / "out/.tactics/disc.pdf").substr(0, 40));
    EXPECT_EQ(told({"disc.tif", "-o", "out/"}), "there is no record of how out/disc.pdf was made");
    EXPECT_EQ(told({"disc.tif", "-o", "out/"}), "up to date");
}

TEST_F(Update, LabelsKeptChoicesAndOtherPicturesCount) {
    const Words labelled{"disc.tif", "-o", "page.svg", "--labels", "disc.labels", "--width", "6cm"};
    write_bytes(folder / "disc.labels", "5%,5% Disc\n");
    EXPECT_EQ(told(labelled), "made");
    EXPECT_EQ(told(labelled), "up to date");
    write_bytes(folder / "disc.labels", "5%,5% Ring\n");
    EXPECT_EQ(told(labelled), "its labels are others");
    EXPECT_EQ(told({"disc.tif", "-o", "page.svg", "--width", "6cm"}), "its labels are gone");

    // Another picture of the same name, however old it is.
    std::filesystem::create_directories(folder / "old");
    write_bytes(folder / "old/disc.tif", disc_picture());
    std::filesystem::last_write_time(folder / "old/disc.tif",
                                     std::filesystem::file_time_type::clock::now() - std::chrono::hours(99));
    EXPECT_EQ(told({"old/disc.tif", "-o", "page.svg", "--width", "6cm"}), "the picture is another");

    const auto kept = [&](const std::string& text) {
        std::filesystem::create_directories(folder / "own/tactics");
        write_bytes(folder / "own/tactics/defaults", text);
        return run_tool(folder, {"env", "XDG_CONFIG_HOME=" + (folder / "own").string(), TACTICS_PROGRAM, "convert", "disc.tif",
                                 "-r", "none", "-o", "kept.svg", "--update"})
            .err;
    };
    EXPECT_FALSE(holds(kept("paper a5\n"), "made anew"));
    EXPECT_TRUE(holds(kept("paper a5\nprogress none\nmachine index-v4\n"), "up to date"));
    EXPECT_TRUE(holds(kept("paper a3\n"), "; made anew: the kept paper a3, was a5\n"));
}

// Models of one driver have one format.
TEST_F(Update, AnotherModelCounts) {
    EXPECT_EQ(told({"disc.tif", "-o", "romeo:page.prn"}), "made");
    EXPECT_EQ(told({"disc.tif", "-o", "romeo:page.prn"}), "up to date");
    EXPECT_EQ(told({"disc.tif", "-o", "juliet:page.prn"}), "the machine's enabling model=juliet, was model=romeo");
    EXPECT_EQ(told({"disc.tif", "-o", "index-v4:page.prn"}),
              "format index-v4, was enabling, the machine's enabling model=juliet is gone");
}

// Pages in files of their own, as many as there were.
TEST_F(Update, EveryPageOfSeveralIsAskedFor) {
    const Words tiled{"disc.tif", "-o", "page.svg", "--tiles", "2x1"};
    EXPECT_EQ(told(tiled), "made");
    EXPECT_EQ(told(tiled), "up to date");
    std::filesystem::remove(folder / "page-2.svg");
    EXPECT_EQ(told(tiled), "page-2.svg is not there");
}

// Each option of convert either changes what is compared, or is named among those that cannot make another page.
TEST(PageChoices, NoOptionIsForgotten) {
    const Command& command = *find_command("convert");
    const auto choices = [&](const Words& words) { return page_choices(command, parse_words(command, words), RecipeWish{}); };
    std::size_t counted = 0;
    for (const Flag& flag : command.flags) {
        Words words{std::string(flag.name)};
        if (!flag.value.empty()) words.push_back("value");
        const std::vector<Phrase> told = differences(choices({}), choices(words));
        EXPECT_EQ(told.empty(), !changes_pages(flag.name)) << flag.name;
        counted += told.size();
    }
    EXPECT_GT(counted, 40u);
    // An order or a number of files is none of these; a format is.
    for (const std::string_view flag : {"--set", "--page", "--dpi", "--words", "--language", "--label", "--as-drawn"})
        EXPECT_TRUE(changes_pages(flag)) << flag;
}

}  // namespace
}  // namespace tactics::update_test
