// SPDX-License-Identifier: Apache-2.0
// Sources of a room are compiled together (compile_together in CMakeLists.txt), so their private names are names of the room. The
// compiler sees the few files of a group; this sees the room. Tests have a namespace for each file instead.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "tests/patterns.h"
#include "tests/tree.h"

namespace tactics::private_names_test {
namespace {

using namespace tests;

// What is declared in the first column of anonymous namespaces ("public:" is not), each up to its body or value, on one line.
std::vector<std::string> private_declarations(const std::string& text) {
    std::vector<std::string> all;
    std::istringstream lines(text);
    bool inside = false, whole = true;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("namespace {") || line.starts_with("}  // namespace")) {
            inside = line.front() == 'n';
            continue;
        }
        if (!inside) continue;
        line = line.substr(0, line.find("  //"));
        const bool begins =
            !line.empty() && (std::isalpha(static_cast<unsigned char>(line[0])) != 0 || line[0] == '[') && line.back() != ':';
        if (begins && whole)
            all.push_back(line);
        else if (!whole)
            all.back() += " " + line.substr(std::min(line.size(), line.find_first_not_of(' ')));
        if (begins || !whole) whole = !line.starts_with("template") && line.find_first_of(";{=") != std::string::npos;
    }
    return all;
}

// Without the names of parameters: functions that differ in their parameters may share a name.
std::string signature_of(const std::string& name, std::string parameters) {
    parameters = without(parameters, " = [^,]*");
    return name + "(" + without(parameters, "[ ]*\\b[a-z_0-9]+(\\[\\])?(?=,|$)") + ")";
}

// The same alias in two files is one.
std::vector<std::string> names_in(const std::string& declaration) {
    if (const Fit type =
            first_fit(declaration, R"(^(?:template <.*> )?(?:struct|class|enum class|enum) (\w+)(?: final)?(?: :.*)? \{)");
        !type.empty())
        return {type[1]};
    if (declaration.starts_with("using ")) return {};
    std::vector<std::string> names;
    if (!first_fit(declaration, "^(static )?(inline )?const").empty() && !first_fit(declaration, R"(\bk[A-Z]\w*)").empty()) {
        for (const Fit& constant : all_fits(declaration, R"(\b(k[A-Z]\w*)(?:\[[^\]]*\])*(?: =|\{))"))
            names.push_back(constant[1]);
        if (!names.empty()) return names;
    }
    if (const Fit function =
            first_fit(declaration, R"(([A-Za-z_]\w*)\(([^()]*(?:\([^()]*\)[^()]*)*)\)(?: const)?(?: noexcept)? \{)");
        !function.empty())
        return {signature_of(function[1], function[2])};
    return {};
}

// Programs of their own, and doors to foreign headers.
bool is_compiled_alone(const SourceFile& file, const std::string& doors) {
    return file.path.find("/caged/") != std::string::npos || file.path.starts_with("filters/net/kernel_") ||
           doors.find(file.path) != std::string::npos;
}

// What a test file would share with its neighbours: what stands outside the namespace of its name, and macros that it leaves
// defined. GoogleTest finds a PrintTo beside its type.
std::vector<std::string> shared_lines(const std::string& text, const std::string& name) {
    std::vector<std::string> shared;
    std::istringstream lines(text);
    bool own = false;
    for (std::string line; std::getline(lines, line);) {
        if (line == "namespace tactics::" + name + " {" || line == "namespace tactics::tests::" + name + " {")
            own = true;
        else if (line.starts_with("}  // namespace tactics::") && line.ends_with("::" + name))
            own = false;
        else if (line.starts_with("#define ") &&
                 text.find("#undef " + first_fit(line, R"(^#define (\w+))").at(1)) == std::string::npos)
            shared.push_back(line);
        else if (!own && !line.empty() && std::isalpha(static_cast<unsigned char>(line[0])) != 0 &&
                 !line.starts_with("namespace tactics") && !line.starts_with("void PrintTo("))
            shared.push_back(line);
    }
    if (own) shared.push_back("// namespace tactics::" + name + " has no end");
    return shared;
}

TEST(PrivateNames, AreReadFromDeclarations) {
    const std::string text =
        "namespace {\n\nconstexpr int kOne = 1, kTwo[] = {1, 2};  // kThree = 3\nstruct Four {\n    int five = 6;\n};\n"
        "template <typename T>\nT seven(const T& a,\n        int b = 8) {\n    return a;\n}\n\n}  // namespace\nint nine() {\n";
    std::vector<std::string> names;
    for (const auto& one : private_declarations(text))
        for (const auto& name : names_in(one)) names.push_back(name);
    EXPECT_EQ(names, (std::vector<std::string>{"kOne", "kTwo", "Four", "seven(const T&, int)"}));
}

TEST(PrivateNames, AreUniqueInTheirRoom) {
    const std::string build = read(fs::path(TACTICS_SOURCE_DIR) / "CMakeLists.txt");
    const std::size_t begin = build.find("file(GLOB doors");
    ASSERT_NE(begin, std::string::npos);
    const std::string doors = build.substr(begin, build.find(')', begin) - begin);
    std::map<std::string, std::string> homes;
    for (const SourceFile& file : tree()) {
        if (!file.path.ends_with(".cpp") || !starts_with_any(file.path, {"tactics/", "filters/", "print/", "studies/", "cli/"}))
            continue;
        if (is_compiled_alone(file, doors)) continue;
        const std::string room = file.path.substr(0, file.path.rfind('/') + 1);
        for (const auto& declaration : private_declarations(file.text))
            for (const auto& name : names_in(declaration)) {
                const auto [known, fresh] = homes.try_emplace(room + name, file.path);
                EXPECT_TRUE(fresh || known->second == file.path) << name << " is in " << known->second << " and in " << file.path;
            }
    }
    EXPECT_GT(homes.size(), 1000u);
}

TEST(PrivateNames, WhatIsOutsideANamespaceOfItsOwnIsSeen) {
    const std::string own =
        "// what\n#include <map>\n\nnamespace tactics::page_test {\nnamespace {\n\nint one = 1;\n\n}  // namespace\n";
    EXPECT_EQ(shared_lines(own + "}  // namespace tactics::page_test\n", "page_test"), std::vector<std::string>{});
    EXPECT_EQ(shared_lines("#define ONE 1\n" + own + "}  // namespace tactics::page_test\n#undef ONE\n", "page_test"),
              std::vector<std::string>{});
    EXPECT_EQ(shared_lines(
                  "#define TWO 2\nusing std::map;\n" + own + "}  // namespace tactics::page_test\nnamespace {\nint three;\n}\n",
                  "page_test"),
              (std::vector<std::string>{"#define TWO 2", "using std::map;", "namespace {", "int three;"}));
    EXPECT_EQ(shared_lines(own, "page_test"), std::vector<std::string>{"// namespace tactics::page_test has no end"});
    EXPECT_FALSE(shared_lines(own + "}  // namespace tactics::page_test\n", "sheet_test").empty());
}

TEST(PrivateNames, OfATestAreInTheNamespaceOfItsFile) {
    std::size_t files = 0;
    for (const SourceFile& file : tree()) {
        if (!file.path.starts_with("tests/") || !file.path.ends_with("_test.cpp")) continue;
        const std::string name = fs::path(file.path).stem().string();
        for (const std::string& line : shared_lines(file.text, name))
            ADD_FAILURE() << file.path << " is compiled with others; put this into namespace tactics::" << name << ": " << line;
        ++files;
    }
    EXPECT_GT(files, 300u);
}

}  // namespace
}  // namespace tactics::private_names_test
