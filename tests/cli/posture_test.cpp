// SPDX-License-Identifier: Apache-2.0
// What a fault in memory would meet: how the programs are built that `cmake --install` puts in place, as binutils' readelf sees
// them.
#include <gtest/gtest.h>

#include <filesystem>
#include <vector>

#include "tests/cli/tool.h"
#include "tests/sanitized.h"

namespace tactics::posture_test {
namespace {

using namespace tests;
namespace fs = std::filesystem;

bool is_elf(const fs::path& path) {
    return fs::is_regular_file(path) && bytes_of(path).starts_with(
                                            "\x7f"
                                            "ELF");
}

std::vector<fs::path> programs_in(const fs::path& folder) {
    std::vector<fs::path> found;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (!entry.is_symlink() && is_elf(entry.path())) found.push_back(entry.path());
    return found;
}

TEST(Posture, OfAllThatIsInstalled) {
    if (TACTICS_SANITIZED) GTEST_SKIP() << "sanitizers have their own";
    if (!has_tool("readelf")) GTEST_SKIP() << "readelf (binutils) is not installed";
    const Folder folder;
    ASSERT_EQ(run_tool(folder, {"cmake", "--install", TACTICS_BINARY_DIR, "--prefix", (folder / "there").string()}).code, 0);
    const std::vector<fs::path> programs = programs_in(folder / "there");
    EXPECT_GE(programs.size(), 3u) << "tactics, and what it starts";
    for (const fs::path& program : programs) {
        const Ending read = run_tool(folder, {"readelf", "-W", "-h", "-l", "-d", "-n", "--dyn-syms", program.string()});
        ASSERT_EQ(read.code, 0) << read.err;
        const std::string& seen = read.out;
        const std::string name = program.filename().string();
        const bool library = holds(name, ".so.");
        EXPECT_TRUE(holds(seen, library ? "DYN (Shared object file)" : "DYN (Position-Independent Executable file)"))
            << name << ": addresses are not by chance";
        EXPECT_TRUE(holds(seen, "GNU_RELRO") && holds(seen, "BIND_NOW")) << name << ": tables can be written while it runs";
        EXPECT_FALSE(holds(seen, "RWE")) << name << ": memory that can be written and run";
        EXPECT_TRUE(holds(seen, "__stack_chk_fail")) << name << ": frames are not watched";
        EXPECT_FALSE(holds(seen, "(RPATH)") || holds(seen, "(RUNPATH)"))
            << name << ": looks for libraries in a folder of its own";
    }
    // Copies of a size that the compiler knows are checked; the smallest programs have none.
    const Ending read = run_tool(folder, {"readelf", "-W", "--dyn-syms", (folder / "there/bin/tactics").string()});
    EXPECT_TRUE(holds(read.out, "_chk@GLIBC")) << "FORTIFY is off";
}

#ifdef __x86_64__
// Of a program the linker says so only if the C library's own first lines are built so, too; Debian 12's are not.
TEST(Posture, JumpsAndReturnsCanBeChecked) {
    if (!has_tool("readelf")) GTEST_SKIP() << "readelf (binutils) is not installed";
    const auto count = [](const std::string& text, std::string_view part) {
        std::size_t found = 0;
        for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
        return found;
    };
    const Folder folder;
    for (const char* library : {"nouns", "rules", "print", "job", "cli"}) {
        const std::string path = std::string(TACTICS_BINARY_DIR) + "/libtactics_" + library + ".a";
        const Ending read = run_tool(folder, {"readelf", "-W", "-n", path});
        EXPECT_GT(count(read.out, "File: "), 0u) << path;
        EXPECT_EQ(count(read.out, "x86 feature: IBT, SHSTK"), count(read.out, "File: ")) << path;
    }
}
#endif

}  // namespace
}  // namespace tactics::posture_test
