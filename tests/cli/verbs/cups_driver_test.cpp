// SPDX-License-Identifier: Apache-2.0
// The program as a driver of CUPS: what it lists can be asked for, and is what `tactics ppd` writes.
#include "cli/verbs/cups_driver.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "print/embosser.h"
#include "print/format.h"
#include "tests/cli/tool.h"
#include "tests/patterns.h"

namespace tactics::cups_driver_test {
namespace {

using namespace tests;

class CupsDriver : public testing::Test {
protected:
    CupsDriver() { std::filesystem::create_symlink(TACTICS_PROGRAM, folder / std::string(kCupsDriverName)); }
    // As cups-driverd does: the bare name where a program's own path would be.
    Ending driver(const std::string& words) {
        return run_tool(folder, {"bash", "-c", "exec -a tacticsdriver ./tacticsdriver " + words});
    }
    const Folder folder;
};

TEST_F(CupsDriver, ListsEveryEmbosserAndGivesItsFile) {
    const std::string list = driver("list").out;
    // "ADDRESS" LANGUAGE "MAKER" "MODEL" "ID", as the drivers of Gutenprint list theirs.
    const auto lines = all_fits(list, R"re(^"(tacticsdriver://([a-z0-9-]+))" en "TACTICS" "(TACTICS [^"]+)" ""$)re");
    std::size_t embossers = 0;
    for (const Format* format : formats()) embossers += format->embosser != nullptr && format->embosser->display == nullptr;
    EXPECT_EQ(lines.size(), embossers) << list;
    for (const Fit& line : lines) {
        const Ending file = driver("cat " + line[1]);
        EXPECT_EQ(file.code, 0) << line[1];
        EXPECT_EQ(file.out, run_tactics(folder, {"ppd", line[2]}).out) << line[1];
        EXPECT_TRUE(holds(file.out, "*NickName: \"" + line[3] + "\"\n")) << "lpinfo and the file name it alike";
    }
}

TEST_F(CupsDriver, RefusesWhatItDidNotList) {
    EXPECT_EQ(driver("cat tacticsdriver://index-v9").code, 1);
    EXPECT_EQ(driver("cat tacticsdriver://dot-pad").code, 1) << "no paper goes through it";
    EXPECT_EQ(driver("cat elsewhere://index-v4").code, 1);
    EXPECT_EQ(driver("").code, 1);
}

}  // namespace
}  // namespace tactics::cups_driver_test
