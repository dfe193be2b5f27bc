// SPDX-License-Identifier: Apache-2.0
#include "tactics/braille/tables.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <tuple>

#include "tactics/braille/louis.h"
#include "tactics/text/utf8.h"
#include "tactics/text/words.h"

namespace tactics {

namespace {

constexpr std::size_t kHead = 16'384;  // bytes; in the tables of liblouis 3.24 all metadata are in the first 5,000

std::string small(std::string_view text) {
    std::string letters(text);
    for (char& c : letters)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return letters;
}

std::string head_of(const std::string& path) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rbe"), std::fclose);
    if (!file) return "";
    std::string text(kHead, '\0');
    text.resize(std::fread(text.data(), 1, text.size(), file.get()));
    return text;
}

// "German" of "German contracted braille", and not "an": whole words, one after the other.
bool names_in_words(std::string_view title, std::string_view language) {
    std::string words = " " + small(title) + " ";
    std::replace_if(
        words.begin(), words.end(), [](char c) { return c == ',' || c == '(' || c == ')'; }, ' ');
    return words.find(" " + std::string(language) + " ") != std::string::npos;
}

}  // namespace

BrailleTable table_of(std::string_view name, std::string_view text) {
    BrailleTable table;
    table.name = name;
    std::string index_name;
    while (!text.empty()) {
        const auto end = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        const auto colon = line.find(':');
        if (line.size() < 2 || line[0] != '#' || (line[1] != '+' && line[1] != '-') || colon == std::string_view::npos) continue;
        const std::string_view key = trimmed(line.substr(1, colon - 1));
        const std::string value = to_line(trimmed(line.substr(colon + 1)));
        if (key == "+language") table.languages.push_back(value);
        if (key == "+grade") table.grade = value;
        if (key == "+type") table.type = value;
        if (key == "+dots") table.dots = value;
        if (key == "+contraction") table.contraction = value;
        if (key == "-display-name") table.title = value;
        if (key == "-index-name") index_name = value;
    }
    if (table.title.empty()) table.title = index_name;
    return table;
}

std::vector<BrailleTable> described_tables() {
    std::vector<BrailleTable> tables;
    for (const std::string& name : louis_tables())
        if (BrailleTable table = table_of(name, head_of(louis_folder() + "/" + name)); !table.languages.empty())
            tables.push_back(std::move(table));
    return tables;
}

std::string words_of(const BrailleTable& table) {
    std::string words;
    for (const std::string& language : table.languages) words += (words.empty() ? "" : " ") + language;
    if (!table.grade.empty()) words += ", grade " + table.grade;
    return words + (table.title.empty() ? "" : ": " + table.title);
}

std::vector<BrailleTable> tables_for(std::string_view language, std::vector<BrailleTable> all) {
    const std::string wanted = small(trimmed(language));
    const std::string tag = wanted.substr(0, wanted.find_first_of("-_"));
    std::erase_if(all, [&](const BrailleTable& table) {
        const bool has_tag = std::any_of(table.languages.begin(), table.languages.end(), [&](const std::string& one) {
            const std::string own = small(one);
            return own.substr(0, own.find('-')) == tag;
        });
        return wanted.empty() || wanted.find('.') != std::string::npos || (!has_tag && !names_in_words(table.title, wanted));
    });
    std::stable_partition(all.begin(), all.end(), [](const BrailleTable& table) { return table.type != "computer"; });
    return all;
}

std::string table_for_tag(std::string_view tag, std::vector<BrailleTable> all) {
    const std::string base = small(tag.substr(0, tag.find_first_of("-_")));
    if (base == "en") return std::string(kEnglishTable);
    // A table with several languages is mainly for the first.
    const auto is_of = [&](const BrailleTable& table) {
        const std::string first = table.languages.empty() ? "" : small(table.languages.front());
        return first.substr(0, first.find('-')) == base || (base == "nb" && first == "no") || (base == "nn" && first == "no");
    };
    const auto rank = [&](const BrailleTable& table) {
        constexpr std::string_view kLess[] = {"no", "", "partial", "full"};
        const auto contraction = std::find(std::begin(kLess), std::end(kLess), table.contraction) - std::begin(kLess);
        const bool own = std::any_of(table.languages.begin(), table.languages.end(),
                                     [&](const std::string& one) { return small(one) == small(tag); });
        // An older standard has its year in its name, and a table with more signs a word: the plain one is the shortest.
        return std::tuple(!own, contraction, table.name.size(), table.name);
    };
    std::erase_if(all, [&](const BrailleTable& table) { return !is_of(table) || table.type == "computer" || table.dots == "8"; });
    const auto best =
        std::min_element(all.begin(), all.end(), [&](const BrailleTable& a, const BrailleTable& b) { return rank(a) < rank(b); });
    return best == all.end() ? "" : best->name;
}

}  // namespace tactics
