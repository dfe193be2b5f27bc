// SPDX-License-Identifier: Apache-2.0
// `tactics describe` as the user meets it: the real program, real files.
#include "tests/cli/converting.h"

namespace tactics::describe_test {
namespace {

using namespace tests;

class Describe : public Convert {
protected:
    Ending describe(Words words) {
        words.insert(words.begin(), "describe");
        return run_tactics(folder, words);
    }
};

TEST_F(Describe, SaysWhatConvertMakes) {
    const Ending ending = describe({"disc.tif", "--paper", "letter", "--title", "A disc"});
    EXPECT_EQ(ending.code, 0);
    EXPECT_EQ(ending.err, "");
    EXPECT_TRUE(ending.out.starts_with("Title: A disc.\nPage: Letter ")) << ending.out;
    EXPECT_EQ(convert({"disc.tif", "-q", "--paper", "letter", "--title", "A disc", "-o", "text:-"}).out, ending.out);
    EXPECT_EQ(names(), "disc.tif");
    EXPECT_EQ(describe({"disc.tif", "-o", "disc.txt", "--paper", "letter", "--title", "A disc"}).out, "");
    EXPECT_EQ(bytes_of(folder / "disc.txt"), ending.out);
    EXPECT_NE(describe({"disc.tif", "--filter", "threshold"}).out, ending.out);
}

TEST_F(Describe, SeveralPicturesAreToldInOrderUnderTheirNames) {
    const std::string one = describe({"disc.tif"}).out;
    const Ending ending = describe({"disc.tif", "missing.tif", "disc.tif", "-j", "2"});
    EXPECT_EQ(ending.code, 2);
    EXPECT_EQ(ending.out, "disc.tif:\n" + one + "\ndisc.tif:\n" + one + "\n");
    EXPECT_TRUE(holds(ending.err, "tactics: missing.tif: ")) << ending.err;
}

TEST_F(Describe, TellsAllInJson) {
    if (!has_tool("python3")) GTEST_SKIP() << "python3 is missing";
    write_bytes(folder / "check.py",
                "import sys, json\n"
                "disc, bad = [json.loads(line) for line in sys.stdin]\n"
                "assert 'error' in bad and bad['input'] == 'missing.tif', bad\n"
                "assert disc['title'] == 'A \"disc\"' and disc['page'].startswith('A4 '), disc\n"
                "assert 1 <= len(disc['things']) <= 7, disc\n"
                "for thing in disc['things']:\n"
                "    assert thing['kind'] in ('line', 'area') and thing['length_mm'] > 0, thing\n"
                "    assert any(thing['what'] + ', ' + thing['place'] + '.' in line for line in disc['lines']), thing\n");
    const Ending ending = describe({"disc.tif", "missing.tif", "--json", "--title", "A \"disc\""});
    EXPECT_EQ(ending.code, 2);
    const Ending python = run_tool(folder, {"python3", "check.py"}, ending.out);
    EXPECT_EQ(python.code, 0) << python.err << ending.out;
}

TEST_F(Describe, RefusesWhatItCannotDo) {
    EXPECT_EQ(describe({}).err, "tactics: describe: no picture is named; for example: tactics describe photo.jpg\n");
    EXPECT_EQ(describe({"disc.tif", "-o", "disc.pdf"}).code, 1);
    EXPECT_EQ(describe({"disc.tif", "-o", "disc.txt", "--json"}).code, 1);
    EXPECT_EQ(describe({"disc.tif", "disc.tif", "-o", "disc.txt"}).code, 1);
    EXPECT_EQ(describe({"-", "-"}).code, 1);
    EXPECT_EQ(describe({"missing.tif"}).code, 2);
    EXPECT_EQ(describe({"missing.tif"}).out, "");
    EXPECT_EQ(names(), "disc.tif");
}

TEST_F(Describe, APersonsWordsGoIntoTheFiles) {
    ASSERT_EQ(
        convert({"disc.tif", "-q", "-o", "disc.svg", "-o", "disc.ebrl", "--describe", "Eine Scheibe", "--language", "de-AT"})
            .code,
        0);
    EXPECT_TRUE(holds(bytes_of(folder / "disc.svg"), "<desc id=\"desc\" xml:lang=\"de-AT\">Eine Scheibe</desc>"));
    for (const char* wrong : {"", "d", "de_AT", "de--AT", "de-", "12", "en) /X", "abcdefghi"})
        EXPECT_EQ(convert({"disc.tif", "-o", "x.svg", "--language", wrong}).code, 1) << wrong;
    EXPECT_TRUE(
        holds(convert({"disc.tif", "other.tif", "-o", "out/", "--describe", "Words"}).err, "cannot describe several pictures"));
    EXPECT_EQ(convert({"disc.tif", "-o", "x.svg", "--describe", std::string(10'001, 'a')}).code, 1);
}

}  // namespace
}  // namespace tactics::describe_test
