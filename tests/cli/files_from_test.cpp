// SPDX-License-Identifier: Apache-2.0
// Names of pictures out of a list.
#include "cli/files_from.h"

#include "tests/cli/converting.h"

namespace tactics::files_from_test {
namespace {

using namespace tests;

TEST(NamesIn, AreLinesOrEndInZeroBytes) {
    EXPECT_EQ(names_in("", false), Words{});
    EXPECT_EQ(names_in("a b.tif\r\n\n c\nlast", false), (Words{"a b.tif", " c", "last"}));
    using namespace std::string_view_literals;
    EXPECT_EQ(names_in("a\nb\0\0c\r\0"sv, true), (Words{"a\nb", "c\r"}));
}

class FilesFrom : public Convert {};

TEST_F(FilesFrom, ConvertsAllThatAreNamed) {
    const std::string odd = "two\nlines.tif";
    write_bytes(folder / odd, disc_picture());
    write_bytes(folder / "b c.tif", disc_picture());
    write_bytes(folder / "list", "b c.tif\r\n\ndisc.tif\n");
    EXPECT_EQ(convert({"-q", "--files-from", "list", "-o", "one/", "-t", "svg"}).code, 0);
    EXPECT_EQ(names("one"), "b c.svg disc.svg");
    EXPECT_EQ(
        convert({"-q", "disc.tif", "--files-from", "-", "-0", "-o", "two/", "-t", "svg"}, odd + std::string(1, '\0') + "b c.tif")
            .code,
        0);
    EXPECT_EQ(names("two"), "b c.svg disc.svg two\nlines.svg");
    EXPECT_EQ(bytes_of(folder / "one/disc.svg"), bytes_of(folder / "two/disc.svg"));
}

TEST_F(FilesFrom, RefusesBeforeWork) {
    const auto told = [&](Words words, const std::string& input = "") {
        words.insert(words.end(), {"-o", "out/"});
        const Ending end = convert(words, input);
        EXPECT_EQ(end.out, "");
        return std::to_string(end.code) + " " + end.err;
    };
    EXPECT_TRUE(told({"--files-from", "missing"}).starts_with("2 tactics: missing: there is no such file"));
    EXPECT_TRUE(told({"--files-from", "-"}, "\n\n").starts_with("1 tactics: --files-from: this list names no picture"));
    EXPECT_TRUE(told({"--files-from", "-"}, std::string("a\0b", 3)).starts_with("1 tactics: --files-from: there are zero bytes"));
    EXPECT_TRUE(
        told({"-", "--files-from", "-"}, "disc.tif").starts_with("1 tactics: --files-from: standard input (-) is the list"));
    EXPECT_TRUE(told({"disc.tif", "-0"}).starts_with("1 tactics: --null: "));
    EXPECT_TRUE(
        told({"disc.tif", "--files-from", "-"}, "disc.tif\n").starts_with("1 tactics: disc.tif: this picture is named twice"));
    EXPECT_EQ(names(), "disc.tif");
}

}  // namespace
}  // namespace tactics::files_from_test
