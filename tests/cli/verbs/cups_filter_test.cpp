// SPDX-License-Identifier: Apache-2.0
// The program as CUPS calls it: by its name as a filter, with a PPD file of its own.
#include "cli/verbs/cups_filter.h"

#include "cli/verbs/ppd.h"
#include "print/embosser.h"
#include "tests/cli/converting.h"

namespace tactics {
namespace {

using namespace tests;
using Pairs = std::vector<std::pair<std::string, std::string>>;

class CupsFilter : public Convert {
protected:
    void SetUp() override {
        Convert::SetUp();
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

TEST(Ppd, NamesPapersAsTheSpecificationDoes) {
    EXPECT_EQ(paper_of_ppd("A4"), "a4");
    EXPECT_EQ(paper_of_ppd("Letter"), "letter");
    EXPECT_EQ(paper_of_ppd("Tabloid"), "11x17");
    EXPECT_EQ(paper_of_ppd("w720h792"), "254x279.4mm");
    for (const char* none : {"", "w", "w1", "wxhy", "Nothing"}) EXPECT_EQ(paper_of_ppd(none), "") << none;
}

}  // namespace
}  // namespace tactics
