// SPDX-License-Identifier: Apache-2.0
// Braille tables that somebody wrote: the good ones are as good as liblouis's own, the others cost themselves.
#include <gtest/gtest.h>

#include <thread>

#include "tactics/braille/braille.h"
#include "tactics/error.h"
#include "tests/cli/converting.h"
#include "tests/tactics/braille/message_of.h"

namespace tactics::own_table_test {
namespace {

using namespace tests;

class OwnTable : public Convert {
protected:
    std::string table(const std::string& text, const std::string& name = "own.ctb") {
        write_bytes(folder / name, text);
        return (folder / name).string();
    }
};

TEST_F(OwnTable, SetsAsTheSameTableOfLiblouis) {
    const std::string own = table("include en-ueb-g2.ctb\n");
    for (const char* text : {"", "the people and you", "3.5 m", "caf\xC3\xA9"}) {
        EXPECT_EQ(to_braille(text, own), to_braille(text, "en-ueb-g2.ctb")) << text;
        EXPECT_EQ(to_braille(text, own), to_braille(text, "en-ueb-g2.ctb")) << text << ", once more";
    }
    // One file beside it, and a list with a table of liblouis.
    table("always brl 123456\n", "brl.cti");
    const std::string two = table("include brl.cti\ninclude en-ueb-g1.ctb\n", "two.ctb");
    EXPECT_EQ(to_braille("brl", two), std::vector<std::uint8_t>{63});
    EXPECT_EQ(to_braille("brl", "unicode.dis," + two), std::vector<std::uint8_t>{63});
    EXPECT_EQ(message_of("\xE4\xBD\xA0", two).find("--title: braille table \"" + two + "\" has no cells for \"\xE4\xBD\xA0\""),
              0u);
    EXPECT_EQ(message_of("\xFF", two).find("--title: the text for braille is not UTF-8"), 0u);
}

TEST_F(OwnTable, ThatBreaksLiblouisCostsItselfOnly) {
    const std::string own = table("include own.ctb\n");
    const std::string first = table("include second.ctb\n", "first.ctb");
    table("include first.ctb\n", "second.ctb");
    for (const std::string& bad : {own, first})
        EXPECT_EQ(message_of("a", bad),
                  "--braille: \"" + bad.substr(0, 80) +
                      "\" breaks liblouis, as one does that includes itself; mend the table or take another");
    EXPECT_EQ(to_braille("a", "en-ueb-g1.ctb"), std::vector<std::uint8_t>{1});
    // A file that is nothing of the kind is not shown.
    const std::string secret = message_of("a", table("a secret line\n", "secret"));
    EXPECT_TRUE(holds(secret, "secret\" is no liblouis table (it does not understand line 1)")) << secret;
    EXPECT_FALSE(holds(secret, "a secret")) << secret;
}

TEST_F(OwnTable, ServesManyThreads) {
    const std::string good = table("include en-ueb-g1.ctb\n", "good.ctb"), bad = table("include own.ctb\n");
    std::vector<std::thread> threads;
    std::array<int, 4> wrong{};
    for (std::size_t t = 0; t < wrong.size(); ++t)
        threads.emplace_back([&, t] {
            for (int i = 0; i < 3; ++i) {
                wrong[t] += to_braille("a" + std::to_string(t), good) != to_braille("a" + std::to_string(t), "en-ueb-g1.ctb");
                wrong[t] += !holds(message_of("a", bad), "breaks liblouis");
            }
        });
    for (auto& thread : threads) thread.join();
    for (const int count : wrong) EXPECT_EQ(count, 0);
}

TEST_F(OwnTable, OnTheCommandLine) {
    table("include own.ctb\n");
    const Ending bad = convert({"disc.tif", "-o", "a.svg", "--title", "A", "--braille", "own.ctb"});
    EXPECT_EQ(bad.code, 1);
    EXPECT_TRUE(holds(bad.err, "--braille: \"own.ctb\" breaks liblouis")) << bad.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "a.svg"));
    table("include en-ueb-g1.ctb\n", "good.ctb");
    EXPECT_EQ(convert({"disc.tif", "-q", "-o", "a.ps", "--title", "A", "--braille", "good.ctb"}).code, 0);
    EXPECT_EQ(convert({"disc.tif", "-q", "-o", "b.ps", "--title", "A", "--braille", "en-ueb-g1.ctb"}).code, 0);
    // A PDF carries the SVG of its page, which names the table.
    EXPECT_EQ(bytes_of(folder / "a.ps"), bytes_of(folder / "b.ps"));
    // A file with the name of a table is not read unless it is named by its path.
    table("include en-ueb-g2.ctb\n", "en-ueb-g2.ctb");
    EXPECT_EQ(convert({"disc.tif", "-q", "-o", "c.svg", "--title", "A"}).code, 0);
    EXPECT_EQ(convert({"disc.tif", "-o", "d.svg", "--title", "A", "--braille", "./en-ueb-g2.ctb"}).code, 1);
}

}  // namespace
}  // namespace tactics::own_table_test
