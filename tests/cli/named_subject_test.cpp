// SPDX-License-Identifier: Apache-2.0
// --subject, --subject-only and --leave, on the command line and in files of labels.
#include "cli/named_subject.h"

#include <gtest/gtest.h>

#include "cli/labels.h"
#include "cli/outputs.h"
#include "cli/request.h"
#include "filters/list.h"
#include "tests/cli/converting.h"
#include "tests/cli/fake_disk.h"

namespace tactics::named_subject_test {
namespace {

using tests::error_of;
using tests::FakeDisk;
using Strings = std::vector<std::string>;

Request planned(Strings words, const FakeDisk& disk = {}) {
    words.insert(words.begin(), {"in/map.png", "-o", "map.pdf"});
    return plan(parse_words(*find_command("convert"), words), disk.disk());
}

TEST(NamedSubject, IsReadFromTheLine) {
    const SubjectWish wish = planned({"-r", "photo", "--subject", "70%,90%-20%,30%", "--subject", "40%,50%", "--leave",
                                      "0%,0%-10%,10%", "--subject-only"})
                                 .items[0]
                                 .wish;
    EXPECT_EQ(to_text(wish.subject), "20%,30%-70%,90%;40%,50%");
    EXPECT_EQ(to_text(wish.leave), "0%,0%-10%,10%");
    EXPECT_TRUE(wish.only);
    EXPECT_TRUE(planned({}).items[0].wish.empty());
}

TEST(NamedSubject, IsReadFromFilesOfLabels) {
    FakeDisk disk;
    disk.files = {
        {"a.labels",
         "# what matters\nsubject 20%,30%-70%,90%\n10%,10% Hill\nsubject\t40%,50%\r\nleave 0%,0%-5%,5%\nsubject-only\n"}};
    const Item item = planned({"-r", "photo", "--labels", "a.labels"}, disk).items[0];
    ASSERT_EQ(item.labels.size(), 1u);
    EXPECT_EQ(to_text(item.wish.subject), "20%,30%-70%,90%;40%,50%");
    EXPECT_EQ(to_text(item.wish.leave), "0%,0%-5%,5%");
    EXPECT_TRUE(item.wish.only);
    const auto fault = [&](const std::string& line) {
        disk.files = {{"a.labels", "\n" + line + "\n"}};
        return error_of([&] { planned({"-r", "photo", "--labels", "a.labels"}, disk); });
    };
    EXPECT_TRUE(fault("subject here").starts_with("1 a.labels:2: subject cannot be \"here\"; a box is two corners"))
        << fault("subject here");
    EXPECT_TRUE(fault("subject").starts_with("1 a.labels:2: the place is missing")) << fault("subject");
    EXPECT_TRUE(fault("leave 40%,50%").starts_with("1 a.labels:2: \"40%,50%\" is a point")) << fault("leave 40%,50%");
    EXPECT_TRUE(fault("subject-only 40%,50%").starts_with("1 a.labels:2: subject-only stands alone"))
        << fault("subject-only 40%,50%");
    EXPECT_TRUE(fault("subject-only").starts_with("1 a.labels:2: no subject is named")) << fault("subject-only");
    disk.files = {{"a.labels", "\n\nleave 0%,0%-9%,9%\nsubject 40%,50%\n"}};
    const std::string map = error_of([&] { planned({"-r", "map", "--labels", "a.labels"}, disk); });
    EXPECT_TRUE(map.starts_with("1 a.labels:4: recipe map has no filter outlines, which draws the subject")) << map;
}

TEST(NamedSubject, WhatCannotBeIsTold) {
    const auto fault = [](const Strings& words) { return error_of([&] { planned(words); }); };
    EXPECT_EQ(fault({"--subject", "the dog"}),
              "1 --subject: it cannot be \"the dog\"; a box is two corners such as 20%,30%-70%,90%, a point 40%,50%, from the "
              "left and from the top of "
              "the picture");
    EXPECT_EQ(fault({"--subject", "20%,30%-20%,90%"}),
              "1 --subject: it cannot be \"20%,30%-20%,90%\"; it is a box without size: give two opposite corners, or a point");
    EXPECT_EQ(fault({"--subject", "20%,30%-120%,90%"}),
              "1 --subject: it cannot be \"20%,30%-120%,90%\"; the picture is from 0% to 100%, and this is outside of it");
    EXPECT_TRUE(fault({"--subject", ""}).starts_with("1 --subject: the place is missing"));
    EXPECT_EQ(fault({"--leave", ""}), "1 --leave: the box is missing; write for example 20%,30%-70%,90%");
    EXPECT_TRUE(fault({"--leave", "40%,50%"}).starts_with("1 --leave: \"40%,50%\" is a point; what is left out is a box"));
    EXPECT_TRUE(fault({"--subject-only"}).starts_with("1 --subject-only: no subject is named; add for example --subject"));
    EXPECT_EQ(
        fault({"-r", "map", "--subject", "40%,50%"}),
        "1 --subject: recipe map has no filter outlines, which draws the subject; use --recipe photo, without --detail contours");
    const std::string leave = fault({"-r", "map", "--leave", "1%,1%-2%,2%"});
    EXPECT_TRUE(leave.starts_with("1 --leave: recipe map has no filter outlines, which leaves boxes out")) << leave;
}

TEST(NamedSubject, GoesIntoTheRecipe) {
    const Recipe recipe = with_subject(find_recipe("photo", "test"), {{{0.2, 0.3, 0.7, 0.9}}, {}, true, "test", "", "test"});
    EXPECT_NE(to_text(recipe).find("\noutlines subject=20%,30%-70%,90% only=yes\n"), std::string::npos) << to_text(recipe);
    const Recipe photo = find_recipe("photo", "test");
    EXPECT_EQ(to_text(with_subject(photo, {})), to_text(photo));
}

using ConvertSubject = tests::Convert;

TEST_F(ConvertSubject, IsToldAndSavedInTheRecipe) {
    const auto told = convert({"disc.tif", "-r", "photo", "--set", "nest.map=plain", "--subject", "0%,0%-100%,100%",
                               "--save-recipe", "own.recipe", "-o", "a.svg"});
    EXPECT_EQ(told.code, 0) << told.err;
    EXPECT_NE(told.err.find("disc.tif: subject: "), std::string::npos) << told.err;
    const auto again = convert({"disc.tif", "-r", "own.recipe", "-o", "b.svg", "-q"});
    EXPECT_EQ(again.code, 0) << again.err;
    EXPECT_EQ(tests::bytes_of(folder / "a.svg"), tests::bytes_of(folder / "b.svg"));
}

}  // namespace
}  // namespace tactics::named_subject_test
