// SPDX-License-Identifier: Apache-2.0
#include "cli/outputs.h"

#include <gtest/gtest.h>

#include "tests/cli/fake_disk.h"

namespace tactics::outputs_test {
namespace {

using tests::error_of;
using tests::FakeDisk;
using Words = std::vector<std::string>;

// "format path [folder]" for every output of every item.
Words planned(const Words& inputs, const Words& outs, const Words& to = {}) {
    FakeDisk fake;
    fake.folders = {"pages", "."};
    fake.files["old.pdf"] = "";
    Words lines;
    for (const Item& item : plan_outputs(inputs, outs, to, fake.disk()))
        for (const Output& output : item.outputs)
            lines.push_back(item.input + " " + std::string(output.format->name) + " " + output.path +
                            (output.folder.empty() ? "" : " in " + output.folder));
    return lines;
}

std::string refused(const Words& inputs, const Words& outs, const Words& to = {}) {
    return error_of([&] { planned(inputs, outs, to); });
}

TEST(Outputs, NameTheirFormatByEndingOrInFront) {
    EXPECT_EQ(planned({"a.jpg"}, {"a.pdf", "b.SVG", "png:page", "pdf:-"}),
              (Words{"a.jpg pdf a.pdf", "a.jpg svg b.SVG", "a.jpg png page", "a.jpg pdf -"}));
    EXPECT_EQ(planned({"a.jpg"}, {"./odd:name.pdf", "odd:name.svg"}),
              (Words{"a.jpg pdf ./odd:name.pdf", "a.jpg svg odd:name.svg"}));
}

TEST(Outputs, InAFolderTakeTheNameOfThePicture) {
    EXPECT_EQ(planned({"in/a.v2.jpg", "-"}, {"pages"}),
              (Words{"in/a.v2.jpg pdf pages/a.v2.pdf in pages", "- pdf pages/standard-input.pdf in pages"}));
    EXPECT_EQ(planned({"a.jpg"}, {"new/", "png:dots/"}, {"svg", "pdf", "svg"}),
              (Words{"a.jpg svg new/a.svg in new/", "a.jpg pdf new/a.pdf in new/", "a.jpg png dots/a.png in dots/"}));
}

TEST(Outputs, OfAFormatOfManyPagesAreOneFileOfAllPictures) {
    EXPECT_EQ(planned({"a.jpg", "b.jpg"}, {"all.pdf", "brf:-"}),
              (Words{"a.jpg pdf all.pdf", "a.jpg brf -", "b.jpg pdf all.pdf", "b.jpg brf -"}));
    EXPECT_EQ(refused({"a.jpg", "b.jpg"}, {"all.pdf", "./all.pdf"}), "1 -o: ./all.pdf is named twice; name it once");
    EXPECT_EQ(refused({"pages/a.pdf", "b.jpg"}, {"pages/a.pdf"}),
              "1 pages/a.pdf: this would replace the picture pages/a.pdf; choose another name or folder");
    EXPECT_EQ(refused({"a.jpg", "b.jpg"}, {"pages/", "pages/b.pdf"}),
              "1 -o: a.jpg and b.jpg would both be written to pages/b.pdf; convert them into different folders or rename one");
}

TEST(Outputs, AreNeverLost) {
    EXPECT_EQ(
        refused({"x/a.jpg", "y/a.png"}, {"pages/"}),
        "1 -o: x/a.jpg and y/a.png would both be written to pages/a.pdf; convert them into different folders or rename one");
    EXPECT_EQ(refused({"a.jpg", "./a.jpg"}, {"pages/"}),
              "1 -o: a.jpg and ./a.jpg would both be written to pages/a.pdf; convert them into different folders or rename one");
    EXPECT_EQ(refused({"a.jpg", "b.jpg", "a.jpg"}, {"pages/"}), "1 a.jpg: this picture is named twice; name it once");
    EXPECT_EQ(refused({"a.jpg"}, {"a.pdf", "x/../a.pdf"}), "1 -o: x/../a.pdf is named twice; name it once");
    EXPECT_EQ(refused({"a.jpg"}, {"pdf:-", "svg:-"}), "1 -o: standard output is named twice; name it once");
    EXPECT_EQ(refused({"pages/a.png", "b.jpg"}, {"pages"}, {"png"}),
              "1 pages/a.png: this would replace the picture pages/a.png; choose another name or folder");
    EXPECT_EQ(refused({"-", "-"}, {"pages/"}), "1 convert: standard input (-) is named twice; it can be read once");
}

TEST(Outputs, SayWhatIsMissing) {
    EXPECT_EQ(refused({}, {"a.pdf"}), "1 convert: no picture is named; for example: tactics convert photo.jpg -o photo.pdf");
    EXPECT_EQ(refused({"in/heart.jpg"}, {}), "1 convert: where to write is missing; add for example -o heart.pdf");
    EXPECT_EQ(refused({"a.jpg", "b.jpg"}, {}), "1 convert: where to write is missing; add for example -o pages/");
    EXPECT_EQ(refused({"a.jpg", "b.jpg"}, {"a.png"}),
              "1 -o a.png: png holds one page, and there are several pictures; name a folder, which ends in /, for example -o "
              "pages/, or a pdf, which holds all");
    EXPECT_EQ(refused({"a.jpg"}, {"-"}), "1 -o -: name the format for standard output, for example -o pdf:-");
    EXPECT_EQ(refused({"a.jpg"}, {"pdf:"}), "1 -o pdf:: the name of a file or folder is missing");
    EXPECT_EQ(refused({"a.jpg"}, {"a.pdf"}, {"svg"}),
              "1 --to: it names the formats for a folder, and no -o is a folder; end a folder's name in /");
    EXPECT_EQ(refused({"a.jpg"}, {"pages"}, {"pfd"}), "1 --to: there is no format \"pfd\" (pdf?); see tactics list formats");
    EXPECT_EQ(refused({"a.jpg"}, {"pfd:a"}), "1 -o pfd:a: there is no format \"pfd\" (pdf?); see tactics list formats");
    EXPECT_EQ(refused({"a.jpg"}, {"a.pfd"}).substr(0, 53), "1 -o a.pfd: the ending .pfd names no format (pdf?); e");
    for (const std::string out : {"old.pdf/", "old.pdf//", "svg:old.pdf/"})
        EXPECT_EQ(refused({"a.jpg"}, {out}),
                  "1 -o " + out +
                      ": old.pdf is a file, so it cannot be a folder; choose another name for the folder, or leave "
                      "out the / to replace the file");
    EXPECT_EQ(refused({"a.jpg"}, {"pages/", "/"}).substr(0, 10), "no error");
    EXPECT_EQ(refused({"a.jpg"}, {"page"}).substr(0, 56), "1 -o page: this is no folder and its name has no ending;");
}

TEST(Outputs, StemLosesFoldersAndTheLastEnding) {
    EXPECT_EQ(stem_of("pictures/heart.v2.jpg"), "heart.v2");
    EXPECT_EQ(stem_of(".hidden"), ".hidden");
    EXPECT_EQ(stem_of("a.b/noending"), "noending");
    EXPECT_EQ(stem_of("/"), "");
}

}  // namespace
}  // namespace tactics::outputs_test
