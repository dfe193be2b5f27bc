// SPDX-License-Identifier: Apache-2.0
// What the tables of liblouis say of themselves: whose braille they are, and how much of it is contracted.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tactics {

/// Out of the lines "#+language: de" that stand at the beginning of a table (liblouis manual, "Table Metadata"). What a table
/// does not say is empty.
struct BrailleTable {
    std::string name;                    ///< of the file, as a user names it: "de-g2.ctb"
    std::vector<std::string> languages;  ///< tags: "de"; at least one
    std::string grade;                   ///< "0", "1", "1.5", "2"
    std::string type;                    ///< "literary", "computer"
    std::string dots;                    ///< of a cell: "6", "8"
    std::string title;                   ///< "German contracted braille"
    std::string contraction = {};        ///< "no", "partial", "full"
};

/// What the text of a table's file says; without a language if it is only a part of other tables.
BrailleTable table_of(std::string_view name, std::string_view text);

/// The tables that came with liblouis and name a language, by name. They are read anew each time: some 400 files, of which the
/// first 16 KB.
std::vector<BrailleTable> described_tables();

/// "de, grade 2: German contracted braille"
std::string words_of(const BrailleTable& table);

/// Those of a language that is named by its tag ("de", also "de-AT" and "de_DE") or in English ("german"), literary ones before
/// those for computers.
std::vector<BrailleTable> tables_for(std::string_view language, std::vector<BrailleTable> all);

/// The table for words in a language that is known by its tag only: literary, of six dots, and as little contracted as there is,
/// since all who read the language's braille know that, and not all its contractions. For English it is kEnglishTable, as that
/// is what there is without a language. Empty: no table is for it.
std::string table_for_tag(std::string_view tag, std::vector<BrailleTable> all);

inline constexpr std::string_view kEnglishTable = "en-ueb-g2.ctb";

}  // namespace tactics
