// SPDX-License-Identifier: Apache-2.0
// A source includes what it names. The compiler sees less: with precompiled headers, or with its neighbours in one unit, a source
// compiles that includes nothing of a type, until an include elsewhere goes.
#include <gtest/gtest.h>

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

// Names of one word are left out: they are those of enumerators and of private types as well.
TEST(HouseRules, SourcesIncludeTheTypesThatTheyName) {
    std::map<std::string, std::vector<std::string>> includes;
    std::map<std::string, std::string> homes;
    for (const SourceFile& file : tree()) {
        if (!is_code(file)) continue;
        includes[file.path] = includes_of(file, '"');
        if (!file.path.ends_with(".h")) continue;
        for (const Fit& type :
             all_fits(file.text, R"(^(?:struct|class|enum class) ([A-Z][a-z]+[A-Z][A-Za-z]+)(?: :[^;{]*| final)? \{)"))
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
        std::set<std::string> names, declared;
        for (const Fit& name : all_fits(code, R"((^|[^A-Za-z:])([A-Z][a-z]+[A-Z][A-Za-z]+))")) names.insert(name[2]);
        for (const Fit& name : all_fits(code, R"((?:struct|class) ([A-Za-z]+)[ ;])")) declared.insert(name[1]);
        const std::set<std::string> seen = reached(file.path);
        for (const std::string& name : names) {
            const auto home = homes.find(name);
            EXPECT_TRUE(home == homes.end() || declared.contains(name) || seen.contains(home->second))
                << file.path << " names " << name << " and does not include " << home->second;
        }
    }
    EXPECT_GT(homes.size(), 300u);
}

}  // namespace
}  // namespace tactics::includes_test
