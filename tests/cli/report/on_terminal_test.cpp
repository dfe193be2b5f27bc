// SPDX-License-Identifier: Apache-2.0
// `tactics convert` on a terminal, which `script` of util-linux makes: progress, and bytes that are no text.
#include "tactics/transport/terminal.h"
#include "tests/cli/converting.h"

namespace tactics::on_terminal_test {
namespace {

using namespace tests;

class OnTerminal : public Convert {
protected:
    // On a terminal a line ends in \r\n.
    Ending on_terminal(const std::string& setting, const std::string& words) {
        const std::string line = setting + " " + std::string(TACTICS_PROGRAM) + " convert " + words;
        return run_tool(folder, {"script", "-q", "-e", "-c", line, "/dev/null"});
    }
    static bool has_bar(const std::string& shown) {
        for (auto at = shown.find('\r'); at != std::string::npos; at = shown.find('\r', at + 1))
            if (at + 1 < shown.size() && shown[at + 1] != '\n' && shown[at + 1] != '\r') return true;
        return false;
    }
};

TEST_F(OnTerminal, TheBarIsWhereItIsWanted) {
    if (!has_tool("script")) GTEST_SKIP() << "script is missing";
    std::string words = "-r photo -j 1 -o pages/";
    for (int i = 0; i < 6; ++i) {  // for a second; a bar is drawn after 0.2
        const std::string name = "d" + std::to_string(i) + ".tif";
        write_bytes(folder / name, grey_picture(900, 700, [i](int x, int y) { return (x * x + y * y) / 900 % (100 + i) + 60; }));
        words += " " + name;
    }
    const std::string xterm = "env -u NO_COLOR TERM=xterm";
    EXPECT_TRUE(has_bar(on_terminal(xterm, words).out));
    EXPECT_TRUE(has_bar(on_terminal(xterm, words + " --progress bar --warnings").out));
    EXPECT_FALSE(has_bar(on_terminal(xterm, words + " --progress none").out));
    EXPECT_FALSE(has_bar(on_terminal(xterm, words + " --progress lines").out));
    EXPECT_FALSE(has_bar(on_terminal(xterm, words + " --warnings").out));
    EXPECT_FALSE(has_bar(on_terminal("env NO_COLOR=1 TERM=xterm", words + " --progress bar").out));
    EXPECT_FALSE(has_bar(on_terminal("env TERM=dumb", words + " --progress bar").out));
}

TEST_F(OnTerminal, ProgressIsOneOfThree) {
    EXPECT_EQ(convert({"disc.tif", "-o", "a.svg", "--progress", "dots"}).code, 1);
    EXPECT_EQ(convert({"disc.tif", "-q", "-o", "a.svg", "--progress", "bar"}).err, "");
}

TEST_F(OnTerminal, BytesThatAreNoTextAreRefused) {
    if (!has_tool("script")) GTEST_SKIP() << "script is missing";
    for (const std::string format : {"pdf", "png", "tiff", "index-v4", "stl"}) {
        const Ending refused = on_terminal("", "disc.tif -q -o " + format + ":-");
        EXPECT_EQ(refused.code, 1) << format;
        EXPECT_TRUE(refused.out.starts_with("tactics: ") && holds(refused.out, "--output FILE, or send it into a pipe"))
            << refused.out;
        EXPECT_FALSE(is_binary(refused.out)) << format;
        EXPECT_EQ(on_terminal("", "disc.tif -q -o " + format + ":- | cat > piped").code, 0) << format;
        EXPECT_GT(bytes_of(folder / "piped").size(), 100u) << format;
    }
    for (const std::string format : {"svg", "brf", "text", "ubrl"}) {
        const Ending shown = on_terminal("", "disc.tif -q --title Disc -o " + format + ":-");
        EXPECT_EQ(shown.code, 0) << format << shown.out;
        EXPECT_GT(shown.out.size(), 20u) << format;
    }
}

TEST(Terminal, TellsBytesFromText) {
    EXPECT_FALSE(is_binary(""));
    EXPECT_FALSE(is_binary("  ,,#A\r\n\f\tcaf\xc3\xa9 caf\xe9"));
    for (const char c : {'\0', '\x1b', '\a', '\b', '\x7f', '\x1a'}) EXPECT_TRUE(is_binary(std::string("text") + c + "text"));
}

}  // namespace
}  // namespace tactics::on_terminal_test
