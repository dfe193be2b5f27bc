// SPDX-License-Identifier: Apache-2.0
// A source includes what it names. The compiler sees less: with precompiled headers, or with its neighbours in one unit, a source
// compiles that includes nothing of a type, until an include elsewhere goes.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "tests/patterns.h"
#include "tests/tree.h"

namespace tactics::includes_test {
namespace {

using namespace tests;

bool is_code(const SourceFile& file) {
    return is_source(file) && !starts_with_any(file.path, {"tests/", "samples/"}) && !file.path.ends_with(".inc");
}

// Names of one word are those of enumerators and of private types as well: they count in headers, where a reference or a list of
// them is named.
TEST(HouseRules, SourcesIncludeTheTypesThatTheyName) {
    std::map<std::string, std::vector<std::string>> includes;
    std::map<std::string, std::string> homes;
    std::map<std::string, std::set<std::string>> declared;
    for (const SourceFile& file : tree()) {
        if (!is_code(file)) continue;
        includes[file.path] = includes_of(file, '"');
        for (const Fit& name : all_fits(file.text, R"((?:struct|class|using|typename)(?:\.\.\.)? ([A-Za-z]+)[ ;>,])"))
            declared[file.path].insert(name[1]);
        if (!file.path.ends_with(".h")) continue;
        for (const Fit& type : all_fits(file.text, R"(^(?:struct|class|enum class) ([A-Z][A-Za-z]+)(?: :[^;{]*| final)? \{)"))
            homes[type[1]] = file.path;
    }
    const auto reached = [&](const std::string& path) {
        std::set<std::string> found = {path};
        for (std::vector<std::string> next = {path}; !next.empty();) {
            const std::string from = next.back();
            next.pop_back();
            for (const std::string& to : includes[from])
                if (found.insert(to).second) next.push_back(to);
        }
        return found;
    };
    for (const SourceFile& file : tree()) {
        if (!is_code(file)) continue;
        const std::string code = without(file.text, R"(//[^\n]*|"[^"\n]*")");
        std::set<std::string> names;
        for (const Fit& name : all_fits(code, R"((^|[^A-Za-z:])([A-Z][a-z]+[A-Z][A-Za-z]+))")) names.insert(name[2]);
        if (file.path.ends_with(".h"))
            for (const Fit& name : all_fits(code, R"((?:const |<|\()([A-Z][a-z]+)[&>])")) names.insert(name[1]);
        const std::set<std::string> seen = reached(file.path);
        for (const std::string& name : names) {
            const auto home = homes.find(name);
            const auto declares = [&](const std::string& path) { return declared[path].contains(name); };
            EXPECT_TRUE(home == homes.end() || std::any_of(seen.begin(), seen.end(), declares))
                << file.path << " names " << name << " and does not include " << home->second;
        }
    }
    EXPECT_GT(homes.size(), 300u);
}

}  // namespace
}  // namespace tactics::includes_test
