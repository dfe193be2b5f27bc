// SPDX-License-Identifier: Apache-2.0
#include "cli/report/user_language.h"

#include <algorithm>
#include <cstdlib>
#include <string_view>

#include "tactics/text/catalogue.h"
#include "tactics/text/decimal_comma.h"

namespace tactics {

namespace {

// "de_DE.UTF-8@euro"
struct Locale {
    std::string_view language, codes;
    explicit Locale(std::string_view name) {
        const std::string_view before = name.substr(0, name.find('@'));
        const auto dot = before.find('.');
        language = before.substr(0, dot);
        if (dot != before.npos) codes = before.substr(dot + 1);
    }
    bool plain() const { return language.empty() || language == "C" || language == "POSIX"; }
    bool shows_all_letters() const {
        std::string small;
        for (const char c : codes)
            if (c != '-') small += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
        return small.empty() || small == "utf8";
    }
};

// Of a list, the first that the program speaks; English stops the search.
std::string_view first_spoken(std::string_view list) {
    while (!list.empty()) {
        const std::string_view one = Locale(list.substr(0, list.find(':'))).language;
        const std::string_view spoken = spoken_language(one);
        if (spoken != "en" || one.substr(0, 2) == "en") return spoken;
        list.remove_prefix(list.find(':') == list.npos ? list.size() : list.find(':') + 1);
    }
    return "en";
}

}  // namespace

std::string language_of_locale(const char* language, const char* lc_all, const char* lc_messages, const char* lang) {
    std::string_view name;
    for (const char* one : {lang, lc_messages, lc_all})
        if (one != nullptr && *one != '\0') name = one;
    const Locale locale(name);
    if (locale.plain() || !locale.shows_all_letters()) return "en";
    if (language != nullptr && *language != '\0') return std::string(first_spoken(language));
    return std::string(spoken_language(locale.language));
}

const std::string& user_language() {
    static const std::string language =
        language_of_locale(std::getenv("LANGUAGE"), std::getenv("LC_ALL"), std::getenv("LC_MESSAGES"), std::getenv("LANG"));
    return language;
}

std::string for_user(std::string number) {
    if (writes_comma(user_language())) std::replace(number.begin(), number.end(), '.', ',');
    return number;
}

std::string line_for_user(const Phrase& words) { return words.in(user_language()) + "\n"; }

}  // namespace tactics
