// SPDX-License-Identifier: Apache-2.0
// Sources of a room are compiled together (compile_together in CMakeLists.txt), so their private names are names of the room. The
// compiler sees the few files of a group; this sees the room.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "tests/patterns.h"
#include "tests/tree.h"

namespace tactics {
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

}  // namespace
}  // namespace tactics
