// SPDX-License-Identifier: Apache-2.0
// Labels as the user gives them.
#include "cli/labels.h"

#include <gtest/gtest.h>

#include "cli/outputs.h"
#include "tests/cli/fake_disk.h"
#include "tests/cli/tool.h"

namespace tactics::labels_test {
namespace {

using tests::error_of;
using tests::FakeDisk;
using Words = std::vector<std::string>;

std::vector<Item> planned(const Words& words, const FakeDisk& disk = {}, std::vector<std::string> pictures = {"in/map.png"}) {
    std::vector<Item> items;
    for (std::string& picture : pictures) items.push_back({std::move(picture), {}});
    plan_labels(items, parse_words(*find_command("convert"), words), disk.disk());
    return items;
}

TEST(Labels, AreReadFromTheLineAndFromFiles) {
    FakeDisk disk;
    disk.folders = {"names"};
    disk.files = {{"names/map.labels", "\xEF\xBB\xBF# streets\r\n\n 10mm,5mm\tHill   Road  \r\n0%,100% x"}};
    const auto items =
        planned({"--label", "30%,40.5%= City Park=big", "--labels", "names"}, disk, {"in/map.png", "in/other.png"});
    ASSERT_EQ(items[0].labels.size(), 3u);
    EXPECT_EQ(items[0].labels[0].text, "City Park=big");
    EXPECT_TRUE(items[0].labels[0].share);
    EXPECT_DOUBLE_EQ(items[0].labels[0].y, 0.405);
    EXPECT_EQ(items[0].labels[1].text, "Hill   Road");
    EXPECT_EQ(items[0].labels[1].origin, "names/map.labels:3");
    EXPECT_FALSE(items[0].labels[1].share);
    EXPECT_DOUBLE_EQ(items[0].labels[1].x, 10);
    EXPECT_EQ(items[0].label_file, "names/map.labels");
    EXPECT_EQ(items[1].labels.size(), 1u);  // it has no file of its own, which is no fault
    EXPECT_EQ(items[1].label_file, "");
}

TEST(Labels, ThatCannotBeAreToldWithTheirPlace) {
    const auto fault = [](const Words& words) { return error_of([&] { planned(words); }); };
    EXPECT_EQ(fault({"--label", "City Park"}),
              "1 --label 1: \"City Park\" is no label; write X,Y=WORDS, for example \"30%,40%=City Park\"");
    for (const std::string place : {"30%", "30%,", "30%,40mm", "-1%,5%", "101%,5%", "a,b", "nan%,1%", ",", "1%,2%,3%"})
        EXPECT_EQ(
            fault({"--label", "5%,5%=ok", "--label", place + "=Park"}),
            "1 --label 2: \"" + place +
                "\" is no place; write how far from the left and from the top of the drawing, such as 30%,40% or 12mm,50mm");
    EXPECT_EQ(fault({"--label", "1%,2%="}), "1 --label 1: the words are missing after the place");
    EXPECT_EQ(fault({"--bare", "--label", "1%,2%=x"}),
              "1 --bare: the drawing alone has no labels; leave out --bare or the labels");
    FakeDisk disk;
    disk.files = {{"a.labels", "10%,10% a\n20% b\n"}};
    EXPECT_TRUE(error_of([&] { planned({"--labels", "a.labels"}, disk); }).starts_with("1 a.labels:2: \"20%\" is no place"));
    EXPECT_EQ(error_of([&] {
                  planned({"--labels", "a.labels"}, disk, {"a.png", "b.png"});
              }),
              "1 --labels: a.labels would label every picture alike; name a folder with a file for each, such as map.labels for "
              "map.png");
    std::string many;
    for (int i = 0; i < 1001; ++i) many += "1%,1% x\n";
    EXPECT_TRUE(error_of([&] { parse_labels(many, "f"); }).starts_with("1 f:1001: these are over 1000 labels"));
}

TEST(Labels, StandWhereTheyAreSaidToAndNotOutside) {
    const Drawing drawing{200, 100, {}, {}, {}};
    const auto names = names_on(drawing, {{0.5, 0.25, true, "a", ""}, {200, 100, false, "b", ""}});
    EXPECT_DOUBLE_EQ(names[0].at.x, 100);
    EXPECT_DOUBLE_EQ(names[0].at.y, 25);
    EXPECT_DOUBLE_EQ(names[1].at.x, 200);
    EXPECT_EQ(error_of([&] {
                  check_places({{200.1, 5, false, "c", "--label 1"}}, 200, 100);
              }),
              "1 --label 1: it is outside of the drawing, which is 200 mm wide and 100 mm high");
}

}  // namespace
}  // namespace tactics::labels_test
