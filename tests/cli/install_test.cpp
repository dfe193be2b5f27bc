// SPDX-License-Identifier: Apache-2.0
// `cmake --install` under a prefix of one's own, and for a packager (DESTDIR): all that was installed is found, moved or not.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/cli/pdf_files.h"
#include "tests/cli/tool.h"
#include "tests/filters/weights.h"

namespace tactics::install_test {
namespace {

using namespace tests;
namespace fs = std::filesystem;

// A picture for OpenImageIO: 16 x 16 pixels, the right half black.
std::string bitmap() {
    std::string bytes = "BM";
    const auto number = [&](unsigned value, int size) {
        for (int i = 0; i < size; ++i) bytes += static_cast<char>(value >> 8 * i & 0xff);
    };
    for (const unsigned value : {54u + 16 * 48, 0u, 54u, 40u, 16u, 16u}) number(value, 4);
    number(1, 2);
    number(24, 2);
    for (const unsigned value : {0u, 16u * 48, 2835u, 2835u, 0u, 0u}) number(value, 4);
    for (int i = 0; i < 256; ++i) number(i % 16 < 8 ? 0xffffff : 0, 3);
    return bytes;
}

TEST(Install, UnderAnyPrefixAllThatBelongsToItIsFound) {
    SKIP_WITHOUT_WEIGHTS();
    const Folder folder;
    write_bytes(folder / "half.bmp", bitmap());
    const Ending own = run_tool(folder, {"cmake", "--install", TACTICS_BINARY_DIR, "--prefix", (folder / "first").string()});
    ASSERT_EQ(own.code, 0) << own.err;
    fs::rename(folder / "first", folder / "moved");
    const std::string program = (folder / "moved/bin/tactics").string();
    // The weights, the program for other formats, and the link for CUPS, which leads nowhere else.
    EXPECT_EQ(run_tool(folder, {program, "list", "recipes"}).code, 0);
    const Ending page = run_tool(folder, {program, "convert", "half.bmp", "-r", "photo", "-o", "half.svg", "--json"});
    EXPECT_TRUE(holds(page.out, "\"nest map=learned\"")) << page.out << page.err;
    EXPECT_TRUE(fs::equivalent(folder / "moved/lib/cups/filter/tacticstoembosser", program));
    EXPECT_EQ(
        run_tool(folder, {(folder / "moved/lib/cups/driver/tacticsdriver").string(), "cat", "tacticsdriver://index-v4"}).out,
        run_tool(folder, {program, "ppd", "index-v4"}).out);
    if (has_tool("pdftocairo")) {
        write_bytes(folder / "line.pdf", pdf_that_says(""));
        const Ending pdf = run_tool(folder, {program, "convert", "line.pdf", "-o", "line.svg", "-q"});
        EXPECT_EQ(pdf.code, 0) << pdf.err;
    }
    EXPECT_TRUE(fs::exists(folder / "moved/share/man/man1/tactics.1"));
    EXPECT_TRUE(fs::exists(folder / "moved/share/man/man1/tactics-convert.1"));
    EXPECT_TRUE(fs::exists(folder / "moved/share/doc/tactics/LICENSE") &&
                fs::exists(folder / "moved/share/tactics/nets/bsds500.NOTICE"));
    EXPECT_TRUE(fs::exists(folder / "moved/share/tactics/schemas/convert.schema.json"));
    EXPECT_TRUE(fs::exists(folder / "moved/share/bash-completion/completions/tactics"));

    const Ending packed = run_tool(
        folder, {"env", "DESTDIR=" + (folder / "root").string(), "cmake", "--install", TACTICS_BINARY_DIR, "--prefix", "/usr"});
    ASSERT_EQ(packed.code, 0) << packed.err;
    EXPECT_EQ(fs::read_symlink(folder / "root/usr/lib/cups/filter/tacticstoembosser"), "../../../bin/tactics");
}

}  // namespace
}  // namespace tactics::install_test
