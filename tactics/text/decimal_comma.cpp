// SPDX-License-Identifier: Apache-2.0
#include "tactics/text/decimal_comma.h"

#include <algorithm>
#include <span>
#include <string>

namespace tactics {

namespace {

// The marks of Unicode CLDR 48, as ICU 78 gives them.
constexpr std::string_view kComma[] = {
    "af", "az", "be", "bg", "br", "bs", "ca", "cs", "da", "de", "el", "eo", "es", "et", "eu", "fi", "fo", "fr", "fy", "gl", "hr",
    "hu", "hy", "ia", "id", "is", "it", "ka", "kk", "kl", "ku", "ky", "lb", "ln", "lo", "lt", "lv", "mk", "nb", "nl", "nn", "no",
    "oc", "os", "pl", "pt", "ro", "ru", "sc", "se", "sk", "sl", "sq", "sr", "sv", "tg", "tk", "tr", "tt", "uk", "uz", "vi", "wo"};
// Countries that use another decimal mark than their language does elsewhere.
constexpr std::string_view kPointThere[] = {"de-ch", "de-li", "es-419", "es-br", "es-bz", "es-cu", "es-do", "es-gt", "es-hn",
                                            "es-mx", "es-ni", "es-pa",  "es-pe", "es-pr", "es-sv", "es-us", "it-ch"};
constexpr std::string_view kCommaThere[] = {"en-at", "en-be", "en-cz", "en-de", "en-dk", "en-ee", "en-es", "en-fi", "en-fr",
                                            "en-ge", "en-hu", "en-id", "en-it", "en-lt", "en-lv", "en-nl", "en-no", "en-pl",
                                            "en-pt", "en-ro", "en-se", "en-si", "en-sk", "en-ua", "en-za"};

bool is_in(std::span<const std::string_view> list, const std::string& text) {
    return std::find(list.begin(), list.end(), text) != list.end();
}

// A country is two letters or three digits; what stands before it may be a script.
bool is_country(std::string_view part) {
    return part.size() == 2 || (part.size() == 3 && part.find_first_not_of("0123456789") == std::string_view::npos);
}

}  // namespace

bool writes_comma(std::string_view language) {
    std::string low;
    for (const char c : language) low += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c == '_' ? '-' : c;
    const std::string spoken = low.substr(0, low.find('-'));
    std::string there = spoken;
    for (std::size_t from = spoken.size(); from < low.size();) {
        const std::size_t end = std::min(low.find('-', from + 1), low.size());
        const std::string part = low.substr(from + 1, end - from - 1);
        if (is_country(part)) {
            there += "-" + part;
            break;
        }
        from = end;
    }
    if (is_in(kPointThere, there)) return false;
    return is_in(kComma, spoken) || is_in(kCommaThere, there);
}

}  // namespace tactics
