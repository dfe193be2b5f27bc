// SPDX-License-Identifier: Apache-2.0
// `tactics similar` as a person or a script would call it.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/cli/tool.h"

namespace tactics::tests::similar_test {
namespace {

std::string svg(const std::string& inner) {
    return "<svg xmlns='http://www.w3.org/2000/svg' width='120mm' height='120mm' viewBox='0 0 120 120'><g fill='none' "
           "stroke='black'>" +
           inner + "</g></svg>";
}

const std::string kHouse = "<path d='M20 100 V50 L60 15 L100 50 V100 Z M50 100 V70 H70 V100'/>";
const std::string kStar = "<path d='M60 10 L72 48 L110 48 L79 70 L91 108 L60 85 L29 108 L41 70 L10 48 L48 48 Z'/>";
const std::string kRings = "<circle cx='60' cy='60' r='50'/><circle cx='60' cy='60' r='30'/>";

struct Library {
    Folder folder;
    Library() {
        std::filesystem::create_directories(folder / "atlas/more");
        write_bytes(folder / "atlas/house.svg", svg("<g transform='translate(30 30) scale(.6)'>" + kHouse + "</g>"));
        write_bytes(folder / "atlas/more/star.svg", svg(kStar));
        write_bytes(folder / "atlas/rings.svg", svg(kRings));
        write_bytes(folder / "atlas/.hidden.svg", svg(kHouse));
        write_bytes(folder / "house.svg", svg(kHouse));
    }
};

TEST(Similar, TellsTheNearestFirst) {
    const Library library;
    const Ending told = run_tactics(library.folder, {"similar", "house.svg", "atlas"});
    ASSERT_EQ(told.code, 0) << told.err;
    EXPECT_EQ(told.err, "");
    EXPECT_TRUE(holds(told.out, "shared  file\n")) << told.out;
    EXPECT_LT(told.out.find("atlas/house.svg"), told.out.find("atlas/rings.svg")) << told.out;
    EXPECT_LT(told.out.find("atlas/house.svg"), told.out.find("atlas/more/star.svg")) << told.out;
    EXPECT_FALSE(holds(told.out, "hidden"));
    const Ending one = run_tactics(library.folder, {"similar", "house.svg", "atlas", "house.svg", "--count", "1", "--json"});
    ASSERT_EQ(one.code, 0) << one.err;
    EXPECT_TRUE(one.out.starts_with("{\"schema\":1,\"file\":\"atlas/house.svg\",\"share\":")) << one.out;  // not itself
    EXPECT_EQ(std::count(one.out.begin(), one.out.end(), '\n'), 1);
}

TEST(Similar, LooksFromTheOtherSidesIfAsked) {
    const Library library;
    write_bytes(library.folder / "turned.svg", svg("<g transform='rotate(90 60 60)'>" + kHouse + "</g>"));
    const Ending told = run_tactics(library.folder, {"similar", "turned.svg", "house.svg", "--any-way-up"});
    ASSERT_EQ(told.code, 0) << told.err;
    EXPECT_TRUE(holds(told.out, "turned a quarter")) << told.out;
}

TEST(Similar, NamesWhatCannotBeComparedAndGoesOn) {
    const Library library;
    write_bytes(library.folder / "atlas/notes.bin", std::string("\0\1\2nothing", 10));
    write_bytes(library.folder / "atlas/cut.png", "\x89PNG\r\n\x1a\n");
    const Ending told = run_tactics(library.folder, {"similar", "house.svg", "atlas"});
    EXPECT_EQ(told.code, 0);
    EXPECT_TRUE(holds(told.err, "2 could not be compared:\n")) << told.err;
    EXPECT_TRUE(holds(told.err, "atlas/cut.png: "));
    EXPECT_TRUE(holds(told.out, "atlas/house.svg"));
    EXPECT_EQ(run_tactics(library.folder, {"similar", "house.svg", "atlas", "-q"}).err, "");
}

TEST(Similar, SaysWhatIsWrong) {
    const Library library;
    std::filesystem::create_directories(library.folder / "empty");
    const auto told = [&](const Words& words, const std::string& what, int code) {
        const Ending ending = run_tactics(library.folder, words);
        EXPECT_EQ(ending.code, code) << ending.err;
        EXPECT_TRUE(holds(ending.err, what)) << ending.err;
        EXPECT_EQ(ending.out, "");
    };
    told({"similar", "house.svg"}, "name a figure, and the folder or the files to look in", 1);
    told({"similar", "house.svg", "empty"}, "there is no other file to compare it with", 2);
    told({"similar", "house.svg", "atlas", "--count", "0"}, "--count: it is a whole number from 1 to 1000", 1);
    told({"similar", "absent.svg", "atlas"}, "absent.svg", 2);
    write_bytes(library.folder / "white.svg", svg(""));
    told({"similar", "white.svg", "atlas"}, "nothing is drawn of it that could be compared", 2);
}

}  // namespace
}  // namespace tactics::tests::similar_test
