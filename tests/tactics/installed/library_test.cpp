// SPDX-License-Identifier: Apache-2.0
// The library as other people's programs have it: installed, found by CMake and by pkg-config, with headers that need nothing
// else.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/cli/pdf_files.h"
#include "tests/cli/tool.h"
#include "tests/sanitized.h"

namespace tactics::library_test {
namespace {

using namespace tests;
namespace fs = std::filesystem;

class InstalledLibrary : public testing::Test {
protected:
    void SetUp() override {
        if (TACTICS_SANITIZED) GTEST_SKIP() << "it is not installed where sanitizers watch";
        const Ending end = run_tool(folder, {"cmake", "--install", TACTICS_BINARY_DIR, "--prefix", there().string()});
        ASSERT_EQ(end.code, 0) << end.err;
    }

    fs::path there() const { return folder / "there"; }

    // The words of a shell, with pkg-config looking into the installation first.
    Ending shell(const std::string& line) const {
        return run_tool(folder, {"env", "PKG_CONFIG_PATH=" + (there() / "lib/pkgconfig").string(), "CXX=" TACTICS_CXX,
                                 "SOURCES=" TACTICS_SOURCE_DIR, "sh", "-c", line});
    }

    // A page made by that program is the one that the program makes.
    void expect_pages(const std::string& program) const {
        write_bytes(folder / "line.pdf", pdf_that_says(""));
        const Ending made = run_tool(folder, {program, "line.pdf", "made.pdf"});
        EXPECT_EQ(made.code, 0) << made.err;
        EXPECT_EQ(run_tactics(folder, {"convert", "line.pdf", "-o", "same.pdf", "-q"}).code, 0);
        EXPECT_EQ(bytes_of(folder / "made.pdf"), bytes_of(folder / "same.pdf"));
    }

    const Folder folder;
};

TEST_F(InstalledLibrary, EachHeaderCompilesAlone) {
    std::string sources;
    int headers = 0;
    const fs::path top = there() / "include/tactics";
    for (const auto& entry : fs::recursive_directory_iterator(top)) {
        if (entry.path().extension() != ".h") continue;
        const std::string source = "header" + std::to_string(++headers) + ".cpp";
        write_bytes(folder / source, "#include \"" + fs::relative(entry.path(), top).string() + "\"\n");
        sources += " " + source;
    }
    EXPECT_GE(headers, 40);
    EXPECT_LE(headers, 80) << "a user of make_pages needs no more; see what a header includes";
    const Ending end =
        shell("$CXX -std=c++20 -Wall -Wextra -Wpedantic -Werror $(pkg-config --cflags tactics) -fsyntax-only" + sources);
    EXPECT_EQ(end.code, 0) << end.err;
}

TEST_F(InstalledLibrary, IsFoundByPkgConfig) {
    if (!has_tool("pkg-config")) GTEST_SKIP() << "pkg-config is not installed";
    const std::string words = " -std=c++20 $(pkg-config --cflags tactics) $SOURCES/samples/hello.cpp -o ";
    const Ending built = shell("$CXX" + words + "there/bin/hello $(pkg-config --libs tactics)");
    ASSERT_EQ(built.code, 0) << built.err;
    if (!has_tool("pdftocairo")) GTEST_SKIP() << "pdftocairo (poppler-utils) is not installed";
    expect_pages((there() / "bin/hello").string());
    // A program in another place is told where the library's own programs are.
    fs::rename(there() / "bin/hello", folder / "hello");
    if (!fs::exists("/usr/local/lib/tactics/tactics-cage") && !fs::exists("/usr/lib/tactics/tactics-cage")) {
        const Ending lost = run_tool(folder, {"./hello", "line.pdf", "lost.pdf"});
        EXPECT_TRUE(holds(lost.err, "tactics-cage is not there")) << lost.err;
    }
    const std::string programs = "TACTICS_PROGRAMS=" + (there() / "lib/tactics").string();
    const Ending told = run_tool(folder, {"env", programs, "./hello", "line.pdf", "told.pdf"});
    EXPECT_EQ(told.code, 0) << told.err;
}

TEST_F(InstalledLibrary, IsFoundByCMakeWhereverItWasMoved) {
    fs::rename(there(), folder / "moved");
    fs::create_directory(folder / "project");
    write_bytes(folder / "project/CMakeLists.txt",
                "cmake_minimum_required(VERSION 3.22)\nproject(hello CXX)\nfind_package(tactics 0.1 REQUIRED)\n"
                "add_executable(hello " TACTICS_SOURCE_DIR
                "/samples/hello.cpp)\n"
                "target_link_libraries(hello PRIVATE tactics::tactics)\n");
    const Ending found = shell("cmake -S project -B built -DCMAKE_CXX_COMPILER=$CXX -DCMAKE_PREFIX_PATH=$PWD/moved");
    ASSERT_EQ(found.code, 0) << found.out << found.err;
    const Ending built = shell("cmake --build built");
    ASSERT_EQ(built.code, 0) << built.out << built.err;
    EXPECT_TRUE(fs::exists(folder / "built/hello"));
    // A version that is to come may speak another language.
    write_bytes(folder / "project/CMakeLists.txt",
                "cmake_minimum_required(VERSION 3.22)\nproject(hello CXX)\nfind_package(tactics 0.2 REQUIRED)\n");
    EXPECT_NE(shell("cmake -S project -B other -DCMAKE_PREFIX_PATH=$PWD/moved").code, 0);
}

TEST_F(InstalledLibrary, IsForCToo) {
    const std::string flags = "${CC:-cc} -std=c99 -Wall -Wextra -Wpedantic -Werror $(pkg-config --cflags tactics-c) ";
    const Ending built = shell(flags + "$SOURCES/samples/hello.c -o hello $(pkg-config --libs tactics-c)");
    ASSERT_EQ(built.code, 0) << built.err;
    write_bytes(folder / "line.svg",
                "<svg xmlns='http://www.w3.org/2000/svg' width='100' height='80'><path d='M10 10L90 70' "
                "fill='none' stroke='black'/></svg>");
    const std::string libraries = "LD_LIBRARY_PATH=" + (there() / "lib").string();
    const Ending made = run_tool(folder, {"env", libraries, "./hello", "line.svg", "made.pdf",
                                          "Gr\xc3\xb6\xc3\x9f"
                                          "e"});
    EXPECT_EQ(made.code, 0) << made.err;
    EXPECT_TRUE(holds(made.out, "line.svg: made.pdf: 1 line")) << made.out;
    EXPECT_EQ(run_tactics(folder, {"convert", "line.svg", "-o", "same.pdf", "--title",
                                   "Gr\xc3\xb6\xc3\x9f"
                                   "e"})
                  .code,
              0);
    EXPECT_EQ(bytes_of(folder / "made.pdf"), bytes_of(folder / "same.pdf"));
    // A project that knows no C++ needs nothing of what the library is made of.
    fs::create_directory(folder / "project");
    write_bytes(folder / "project/CMakeLists.txt",
                "cmake_minimum_required(VERSION 3.22)\nproject(hello C)\nfind_package(tactics REQUIRED COMPONENTS c)\n"
                "add_executable(hello " TACTICS_SOURCE_DIR
                "/samples/hello.c)\ntarget_link_libraries(hello PRIVATE tactics::c)\n");
    const Ending project = shell("cmake -S project -B built -DCMAKE_PREFIX_PATH=$PWD/there && cmake --build built");
    EXPECT_EQ(project.code, 0) << project.out << project.err;
    if (!has_tool("nm")) GTEST_SKIP() << "nm (binutils) is not installed";
    const Ending shown =
        shell("nm -D --defined-only there/lib/libtactics.so | grep ' [A-Z] ' | grep -v ' tactics_\\| TACTICS_0$'");
    EXPECT_EQ(shown.out, "") << "it shows more than its own functions";
}

TEST_F(InstalledLibrary, IsForPythonToo) {
    if (!has_tool("python3")) GTEST_SKIP() << "python3 is not installed";
    write_bytes(folder / "line.pdf", pdf_that_says(""));
    const std::string library = "TACTICS_LIBRARY=" + (there() / "lib/libtactics.so.0").string();
    const auto run = [&](Words words) {
        words.insert(words.begin(), {"env", library, "python3", "-B", TACTICS_SOURCE_DIR "/samples/hello.py"});
        return run_tool(folder, words);
    };
    if (has_tool("pdftocairo")) {  // the programs that shut it in are found from the library, for the program is Python
        const Ending made = run({"line.pdf", "made.svg", "title=one line", "strict"});
        EXPECT_EQ(made.code, 0) << made.err;
        EXPECT_TRUE(holds(made.out, "line.pdf: made.svg: 1 line")) << made.out;
        EXPECT_TRUE(holds(made.err, "reading\n")) << made.err;
        EXPECT_EQ(run_tactics(folder, {"convert", "line.pdf", "-o", "same.svg", "--title", "one line"}).code, 0);
        EXPECT_EQ(bytes_of(folder / "made.svg"), bytes_of(folder / "same.svg"));
    }
    const Ending wrong = run({"line.pdf", "made.svg", "paper=a44"});
    EXPECT_EQ(wrong.code, 1);
    EXPECT_TRUE(wrong.err.starts_with("paper: there is no paper")) << wrong.err << "an option has no dashes here";
}

}  // namespace
}  // namespace tactics::library_test
