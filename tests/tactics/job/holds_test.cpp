// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/holds.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "tests/tactics/readers/pictures.h"

namespace tactics::holds_test {
namespace {

Holds holds(std::string_view text, const std::string& name = "test") {
    Source source = memory_source({reinterpret_cast<const unsigned char*>(text.data()), text.size()}, name);
    const Holds found = look_at(source);
    EXPECT_TRUE(text.empty() || std::ftell(source.file.get()) == 0) << "it is rewound";
    return found;
}

Holds holds(const Bytes& bytes) { return holds(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size())); }

TEST(Holds, LinesPagesAndModelsAreKnownByTheirBeginnings) {
    for (const std::string_view svg : {"<svg/>", " \n<?xml version=\"1.0\"?><svg/>", "\xef\xbb\xbf<svg/>"})
        EXPECT_EQ(holds(svg), Holds::svg) << svg;
    EXPECT_EQ(holds(std::string_view("\xff\xfe<\0s\0", 6)), Holds::svg);
    EXPECT_EQ(holds("%PDF-1.7\n1 0 obj, 2\n3, 4"), Holds::pdf);
    EXPECT_EQ(holds("solid box, 1\nfacet, 2\n"), Holds::model);
    Bytes binary(84 + 50, 0);
    binary[80] = 1;
    EXPECT_EQ(holds(binary), Holds::model);
}

TEST(Holds, ATableHasNamesThenNumbersWithTheSameBetween) {
    for (const std::string_view table :
         {"a,b\n1,2\n", "a;b\r\n1,5;2\r\n", "a\tb\n1\t2", "\xef\xbb\xbfTime (s),\"Length, mm\"\n,\n0,1\n"})
        EXPECT_EQ(holds(table), Holds::table) << table;
    for (const std::string_view other :
         {"a, b\n", "a b\n1 2\n", "a,b\n1;2\n", "a,b\nc,d\n", "{\"a\":1,\n\"b\":2,3}", "Dear all,\nfigure 2 is here.\n", ""})
        EXPECT_NE(holds(other), Holds::table) << other;
    EXPECT_NE(holds(std::string_view("a,b\n1,2\0\n", 9)), Holds::table);
}

// Its reader then says what it lacks.
TEST(Holds, ALineOfNamesAloneIsATable) {
    for (const std::string_view table : {"a,b\n", "a;b", "\xef\xbb\xbf\"x\"\t\"y\"\r\n\n"})
        EXPECT_EQ(holds(table), Holds::table) << table;
    for (const std::string_view text :
         {"Dear all, hello\n", "word\n", "word,\n", "a,b\nand more\n", "https://example.org/a,b\n", "data:image/png;base64,AA"})
        EXPECT_NE(holds(text), Holds::table) << text;
    EXPECT_EQ(holds("time in s, force\n", "measured.csv"), Holds::table);
    EXPECT_EQ(holds("force", "measured.tsv"), Holds::table);
    EXPECT_EQ(holds("name,place\nAnn,Bonn\n", "people.csv"), Holds::table);
    EXPECT_NE(holds("Dear all,\nhello", "letter.csv"), Holds::table);
}

TEST(Holds, NumbersBetweenBlanksAreATable) {
    for (const std::string_view table :
         {"a b\n1 2\n3 4\n", "# made by hand\n1 2\n3 NaN\n", "\"x\" \"y\"\n\"1\" 2 3\n\"2\" NA 4\n", "1 2 3\n4 5 6\n7 8"})
        EXPECT_EQ(holds(table), Holds::table) << table;
    for (const std::string_view other : {"1 2\n", "v 1 2 3\nv 2 3 4\n", "1 2\n3 4 5\n", "page 1\n2 3\nof 4\n"})
        EXPECT_NE(holds(other), Holds::table) << other;
}

TEST(Holds, JsonOfNumbersIsATableAndAModelIsNot) {
    for (const std::string_view table : {"[{\"a\":1}]", " [1, 2]", "[[1,2],\n[3,4]]", "[null,1]", "{\"x\": [1, 2]}",
                                         "{\"title\":\"T\", \"x\" : [\"2024-01-01\"]}", "\xef\xbb\xbf[[1]]", "{\"z\":[[1]]}"})
        EXPECT_EQ(holds(table), Holds::table) << table;
    for (const std::string_view other : {"{\"asset\":{\"version\":\"2.0\"},\"scenes\":[0]}", "{\"accessors\":[{\"count\":3}]}",
                                         "{\"type\":\"FeatureCollection\",\"features\":[{}]}", "{\"extensionsUsed\":[\"KHR\"]}",
                                         "{}", "[]", "[\"a\"]", "{\"a\":1}"})
        EXPECT_NE(holds(other), Holds::table) << other;
}

TEST(Holds, PicturesStayPicturesWhateverTheirBytesLookLike) {
    for (const Bytes& picture : {png_of(noise_picture(9, 7, 1)), jpeg_of(test_picture(9, 7, 3)), tiff_of(noise_picture(9, 7, 3))})
        EXPECT_EQ(holds(picture), Holds::picture);
    EXPECT_EQ(holds("P2\n# a,b\n1,2\n"), Holds::picture);
    EXPECT_EQ(holds("#?RADIANCE, x\n1, 2\n"), Holds::picture);
}

}  // namespace
}  // namespace tactics::holds_test
