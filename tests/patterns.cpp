// SPDX-License-Identifier: Apache-2.0
#include "tests/patterns.h"

#include <map>
#include <regex>

namespace tactics::tests {

namespace {

// Once each: rules of the house ask every line of the tree.
const std::regex& compiled(const std::string& pattern) {
    static std::map<std::string, std::regex> known;
    const auto at = known.find(pattern);
    if (at != known.end()) return at->second;
    return known.emplace(pattern, std::regex(pattern, std::regex::ECMAScript | std::regex::multiline)).first->second;
}

Fit fit_of(const std::smatch& found) { return {found.begin(), found.end()}; }

}  // namespace

Fit whole_fit(const std::string& text, const std::string& pattern) {
    std::smatch found;
    return std::regex_match(text, found, compiled(pattern)) ? fit_of(found) : Fit();
}

Fit first_fit(const std::string& text, const std::string& pattern) {
    std::smatch found;
    return std::regex_search(text, found, compiled(pattern)) ? fit_of(found) : Fit();
}

std::vector<Fit> all_fits(const std::string& text, const std::string& pattern) {
    std::vector<Fit> all;
    const std::regex& form = compiled(pattern);
    for (std::sregex_iterator at(text.begin(), text.end(), form), end; at != end; ++at) all.push_back(fit_of(*at));
    return all;
}

std::string without(const std::string& text, const std::string& pattern) {
    return std::regex_replace(text, compiled(pattern), "");
}

}  // namespace tactics::tests
