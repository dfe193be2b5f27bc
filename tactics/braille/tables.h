// SPDX-License-Identifier: Apache-2.0
// The metadata of liblouis tables: their language and degree of contraction.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tactics {

/// From lines such as "#+language: de" at the beginning of a table (liblouis manual, "Table Metadata"). Missing data are empty.
struct BrailleTable {
    std::string name;                    ///< file name, as a user gives it: "de-g2.ctb"
    std::vector<std::string> languages;  ///< tags: "de"; at least one
    std::string grade;                   ///< "0", "1", "1.5", "2"
    std::string type;                    ///< "literary", "computer"
    std::string dots;                    ///< of a cell: "6", "8"
    std::string title;                   ///< "German contracted braille"
    std::string contraction = {};        ///< "no", "partial", "full"
};

/// The metadata in a table file; without a language if it is only a part of other tables.
BrailleTable table_of(std::string_view name, std::string_view text);

/// The tables of liblouis that name a language, sorted by name. Reads the first 16 KB of some 400 files each time.
std::vector<BrailleTable> described_tables();

/// "de, grade 2: German contracted braille"
std::string words_of(const BrailleTable& table);

/// The tables of a language, given by its tag ("de", also "de-AT" and "de_DE") or in English ("german"), literary ones before
/// computer braille.
std::vector<BrailleTable> tables_for(std::string_view language, std::vector<BrailleTable> all);

/// The default table of a language tag: literary, six dots, and the least contracted, which every reader of the language knows,
/// unlike all of its contractions. For English it is kEnglishTable, the default without a language. Empty: no table.
std::string table_for_tag(std::string_view tag, std::vector<BrailleTable> all);

inline constexpr std::string_view kEnglishTable = "en-ueb-g2.ctb";

}  // namespace tactics
