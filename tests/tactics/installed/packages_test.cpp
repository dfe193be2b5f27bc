// SPDX-License-Identifier: Apache-2.0
// The Debian packages that cpack makes: what each holds and depends on, and that the program works where they are unpacked.
// tests/first_hours/admin installs them on a clean system.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>

#include "tests/cli/picture.h"
#include "tests/cli/tool.h"
#include "tests/patterns.h"
#include "tests/sanitized.h"

namespace tactics::packages_test {
namespace {

using namespace tests;
namespace fs = std::filesystem;

TEST(Packages, HoldWhatTheyShouldAndDependOnIt) {
    if (TACTICS_SANITIZED) GTEST_SKIP() << "the libraries are not built where sanitizers watch";
    if (!has_tool("dpkg-shlibdeps") || !has_tool("file")) GTEST_SKIP() << "dpkg-dev or file is not installed";
    const Folder folder;
    const Ending packed = run_tool(
        folder, {"cpack", "-G", "DEB", "--config", TACTICS_BINARY_DIR "/CPackConfig.cmake", "-B", (folder / "made").string()});
    ASSERT_EQ(packed.code, 0) << packed.out << packed.err;
    std::map<std::string, std::string> depends, files;
    for (const auto& entry : fs::directory_iterator(folder / "made")) {
        if (entry.path().extension() != ".deb") continue;
        const std::string path = entry.path().string();
        const std::string name = whole_fit(run_tool(folder, {"dpkg-deb", "-f", path, "Package"}).out, "([a-z0-9-]+)\n").at(1);
        depends[name] = run_tool(folder, {"dpkg-deb", "-f", path, "Depends"}).out;
        files[name] = run_tool(folder, {"dpkg-deb", "-c", path}).out;
        EXPECT_EQ(run_tool(folder, {"dpkg-deb", "-x", path, (folder / "root").string()}).code, 0);
        EXPECT_TRUE(holds(files[name], "./usr/share/doc/" + name + "/copyright")) << name;
        EXPECT_EQ(first_fit(files[name], "^.* root/root .* \\./(?!usr/|$).*$"), Fit{}) << name << " puts files outside /usr";
    }
    const bool printer_app = fs::exists(TACTICS_BINARY_DIR "/tactics-printer-app");
    ASSERT_EQ(depends.size(), printer_app ? 6u : 5u);
    if (printer_app) {
        EXPECT_TRUE(holds(depends["tactics-printer-app"], "libpappl1") && holds(depends["tactics-printer-app"], "tactics (= "));
        EXPECT_TRUE(holds(files["tactics-printer-app"], "man1/tactics-printer-app.1.gz"));
        EXPECT_TRUE(holds(files["tactics-printer-app"], "lib/systemd/system/tactics-printer-app.service"));
        EXPECT_FALSE(holds(depends["tactics"], "pappl")) << depends["tactics"];
    }
    // OpenImageIO brings 180 packages, so only the package of rare formats may need it.
    EXPECT_TRUE(holds(depends["tactics"], "liblouis") && !holds(depends["tactics"], "openimageio")) << depends["tactics"];
    if (fs::exists(TACTICS_BINARY_DIR "/tactics-openimageio")) {
        EXPECT_TRUE(holds(depends["tactics-formats"], "libopenimageio")) << depends["tactics-formats"];
    }
    for (const char* name : {"tactics-formats", "tactics-cups", "libtactics0"})
        EXPECT_TRUE(holds(depends[name], "tactics (= ")) << name << ": another version would not fit it: " << depends[name];
    EXPECT_TRUE(holds(depends["libtactics-dev"], "libtactics0 (= ")) << depends["libtactics-dev"];
    EXPECT_TRUE(holds(files["tactics-cups"], "cups/driver/tacticsdriver -> ../../../bin/tactics")) << files["tactics-cups"];
    EXPECT_TRUE(holds(files["libtactics0"], "libtactics.so.0 -> ") && !holds(files["libtactics0"], "libtactics.so -> "));
    EXPECT_TRUE(holds(files["libtactics-dev"], "libtactics.so -> ")) << "the linker looks for it";
    EXPECT_TRUE(holds(files["tactics"], "man1/tactics-convert.1.gz"));

    write_bytes(folder / "disc.tif", disc_picture());
    const Ending page = run_tool(folder, {(folder / "root/usr/bin/tactics").string(), "convert", "disc.tif", "-o", "page.svg"});
    EXPECT_EQ(page.code, 0) << page.err;
}

}  // namespace
}  // namespace tactics::packages_test
