// SPDX-License-Identifier: Apache-2.0
#include "cli/language_choice.h"

#include <algorithm>
#include <utility>

#include "cli/kept_choices.h"
#include "cli/sheet_values.h"
#include "tactics/braille/tables.h"

namespace tactics {

namespace {

bool is_table_of(const std::string& table, const std::string& language, const std::vector<BrailleTable>& all) {
    const auto fitting = tables_for(language, all);
    return std::any_of(fitting.begin(), fitting.end(), [&](const BrailleTable& one) { return one.name == table; });
}

std::string base_of(const std::string& tag) { return tag.substr(0, tag.find('-')); }

void take_table_of(const std::string& language, std::vector<BrailleTable> all, bool tell, Sheet& sheet,
                   std::vector<Phrase>& notes) {
    const std::string table = table_for_tag(language, std::move(all));
    if (table.empty()) {
        notes.push_back(
            phrase("no braille table is installed for the language {0}, so {1} is used; name another with --braille, or none",
                   language, sheet.braille_table));
        return;
    }
    sheet.braille_table = table;
    if (table != kEnglishTable && tell)
        notes.push_back(
            phrase("braille by {0}, as the language is {1}; --braille names another, and tactics list braille shows all", table,
                   language));
}

}  // namespace

void plan_language(Sheet& sheet, const Given& given, std::vector<Phrase>& notes) {
    const bool typed = given.has("--language");
    if (typed)
        sheet.language = language_of(given.value("--language"), "--language");
    else if (const KeptValue* kept = given.kept("language"))
        sheet.language = language_of(kept->value, kept->place);

    if (given.has("--braille")) {
        const std::string table = given.value("--braille");
        sheet.braille_table = table == "none" ? "" : table;
        return;
    }
    const KeptValue* kept = given.kept("braille");
    const bool english = base_of(sheet.language) == "en";
    // Without a language that is not the usual one nothing is looked up: there are some 400 tables.
    const std::vector<BrailleTable> all = english && kept == nullptr ? std::vector<BrailleTable>() : described_tables();
    if (kept != nullptr && (!typed || kept->value == "none" || kept->value.find('/') != std::string::npos ||
                            is_table_of(kept->value, sheet.language, all))) {
        check_kept_table(kept->value, kept->place);
        sheet.braille_table = kept->value == "none" ? "" : kept->value;
    } else if (!english) {
        take_table_of(sheet.language, all, typed, sheet, notes);  // no note each time for a kept choice
    }
}

}  // namespace tactics
