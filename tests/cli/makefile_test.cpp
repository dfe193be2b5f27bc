// SPDX-License-Identifier: Apache-2.0
// samples/Makefile: what depends on what.
#include <gtest/gtest.h>

#include <chrono>

#include "tests/cli/picture.h"
#include "tests/cli/tool.h"

namespace tactics::makefile_test {
namespace {

using namespace tests;
namespace fs = std::filesystem;

TEST(Makefile, MakesAgainOnlyWhatHasChanged) {
    if (!has_tool("make")) GTEST_SKIP() << "make is missing";
    const Folder folder;
    fs::create_directory(folder / "photos");
    write_bytes(folder / "photos/a.tif", disc_picture());
    write_bytes(folder / "photos/b.tif", disc_picture(100, 120));
    write_bytes(folder / "own.recipe", "threshold\n");
    const std::vector<std::string> words{"make",
                                         "-j2",
                                         "-f",
                                         TACTICS_SOURCE_DIR "/samples/Makefile",
                                         std::string("TACTICS=") + TACTICS_PROGRAM,
                                         "PICTURES=photos",
                                         "PAGES=pages",
                                         "RECIPE=own.recipe",
                                         "OPTIONS=--paper letter"};
    const auto made = [&] {
        const Ending ending = run_tool(folder, words);
        EXPECT_EQ(ending.code, 0) << ending.err;
        std::string names;
        for (const std::string name : {"a", "b"})
            if (ending.out.find("photos/" + name + ".tif") != std::string::npos) names += name;
        return names;
    };
    EXPECT_EQ(made(), "ab");
    EXPECT_GT(fs::file_size(folder / "pages/a.pdf"), 0u);
    EXPECT_EQ(made(), "");
    const auto later = fs::last_write_time(folder / "pages/b.pdf") + std::chrono::seconds(2);
    fs::last_write_time(folder / "photos/b.tif", later);
    EXPECT_EQ(made(), "b");
    fs::last_write_time(folder / "photos/b.tif", later - std::chrono::seconds(20));
    fs::last_write_time(folder / "own.recipe", later);
    EXPECT_EQ(made(), "ab");
}

}  // namespace
}  // namespace tactics::makefile_test
