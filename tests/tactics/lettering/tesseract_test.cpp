// SPDX-License-Identifier: Apache-2.0
// Tesseract's answers, those of stand-ins that behave worse, and its real reading of our own strips.
#include "tactics/lettering/tesseract.h"

#include <gtest/gtest.h>

#include "tactics/error.h"
#include "tactics/lettering/strip.h"
#include "tactics/readers/read.h"
#include "tests/cli/tool.h"

namespace tactics::tesseract_test {
namespace {

constexpr const char* kHead = "level\tpage_num\tblock_num\tpar_num\tline_num\tword_num\tleft\ttop\twidth\theight\tconf\ttext\n";

std::string word(int page, const std::string& sureness, const std::string& text) {
    return "5\t" + std::to_string(page) + "\t1\t1\t1\t1\t0\t0\t9\t9\t" + sureness + "\t" + text + "\n";
}

TEST(Tesseract, ItsTableIsReadPageByPage) {
    const auto guesses = parse_guesses(kHead + word(1, "96.5", "Mean") + word(1, "80", "heat") +
                                           "4\t2\t1\t1\t1\t0\t0\t0\t9\t9\t-1\t\n" + word(3, "12", "x") + "5\t3\t1\t1",
                                       3);
    ASSERT_EQ(guesses.size(), 3u);
    EXPECT_EQ(guesses[0].text, "Mean heat");
    EXPECT_DOUBLE_EQ(guesses[0].sureness, 80);  // of the least sure word
    EXPECT_EQ(guesses[1].text, "");
    EXPECT_EQ(guesses[2].text, "x");
}

TEST(Tesseract, GarbageIsPassedOver) {
    const std::string bad = word(0, "90", "a") + word(4, "90", "b") + word(-1, "90", "c") + word(1, "x", "d") +
                            word(1, "90", " \t ") + "5\tnan\t\t\t\t\t\t\t\t\t90\te\n\xff\xfe\n\t\t\t\n" +
                            word(1, "990", "ok\xff");
    const auto guesses = parse_guesses(bad, 1);
    ASSERT_EQ(guesses.size(), 1u);
    EXPECT_EQ(guesses[0].text, "ok?");
    EXPECT_DOUBLE_EQ(guesses[0].sureness, 100);
    EXPECT_TRUE(parse_guesses("", 0).empty());
}

TEST(Tesseract, KnowsLanguagesByTheirTags) {
    EXPECT_EQ(tesseract_language("en-GB"), "eng");
    EXPECT_EQ(tesseract_language("DE"), "deu");
    EXPECT_EQ(tesseract_language("zh-Hant-TW"), "chi_tra");
    EXPECT_EQ(tesseract_language("tlh"), "");
}

class StandIn : public testing::Test {
protected:
    // A program of that name which is this script.
    std::string program(const std::string& script) {
        const auto path = folder_ / "stand-in";
        tests::write_bytes(path, "#!/bin/sh\n" + script);
        std::filesystem::permissions(path, std::filesystem::perms::owner_all);
        return path.string();
    }
    Guesses read(const std::string& script, const char* language = "en") {
        return read_strips({make_image(40, 20, 1, 0, 255)}, language, program(script));
    }
    tests::Folder folder_;
};

TEST_F(StandIn, WhatCannotBeReadIsToldWithItsMending) {
    EXPECT_EQ(read("[ \"$1\" = --list-langs ] && echo deu && exit; exit 1").trouble.english(),
              "tesseract has no data to read \"eng\"; install tesseract-ocr-eng");
    EXPECT_EQ(read("[ \"$1\" = --list-langs ] && echo eng && exit; exit 1").trouble.english(),
              "tesseract failed; read it with " + spelled("words") + " leave");
    EXPECT_EQ(read("kill -SEGV $$").trouble.english().substr(0, 9), "tesseract");
    EXPECT_EQ(read("", "tlh").trouble.english(),
              "what tesseract calls the language \"tlh\" is not known; name another with " + spelled("language"));
    EXPECT_EQ(read_strips({make_image(40, 20, 1, 0, 255)}, "de", "no-such-program").trouble.english(),
              "to read it the program tesseract is needed and missing; install tesseract-ocr and tesseract-ocr-deu");
    EXPECT_EQ(read("exec head -c 100000 /dev/urandom").trouble.english(), "");  // says nothing that can be understood
    EXPECT_EQ(read("exec head -c 100000 /dev/urandom").guesses.size(), 1u);
}

TEST_F(StandIn, GetsAllStripsAsOnePicture) {
    std::vector<Image> strips;
    for (int i = 0; i < 3; ++i) {
        strips.push_back(make_image(7 + i, 5, 1, 0, 255));
        strips.back().row(2)[i] = static_cast<std::uint8_t>(10 * i);
    }
    // Shut in, a stand-in sees what lies beside it and writes nothing.
    tests::write_bytes(folder_ / "copy.tif", tiff_of(strips));
    const std::string compare = "exec cmp -s - '" + (folder_ / "copy.tif").string() + "'";
    EXPECT_EQ(read_strips(strips, "en", program(compare)).trouble.english(), "");
    // Read by libtiff, which takes the first page.
    Source source = open_source((folder_ / "copy.tif").string());
    const Image first = read_picture(source, {0, false});
    EXPECT_EQ(first.width, 7);
    EXPECT_EQ(first.height, 5);
    EXPECT_EQ(first.pixels, strips[0].pixels);
    strips[1].row(0)[0] = 1;
    EXPECT_NE(read_strips(strips, "en", program(compare)).trouble.english(), "");
}

}  // namespace
}  // namespace tactics::tesseract_test
