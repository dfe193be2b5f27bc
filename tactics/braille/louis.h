// SPDX-License-Identifier: Apache-2.0
// Cells by liblouis, in this process: for trusted tables, and inside the isolated program for others.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tactics {

/// A table as liblouis finds it (a path, or several separated by commas) and under its user's name for it.
struct LouisTable {
    std::string path;  ///< empty: there is none of that name
    std::string shown;
};

/// The folder of the tables that came with liblouis.
std::string louis_folder();
/// The names of the tables that came with liblouis, sorted; none: they are not installed.
std::vector<std::string> louis_tables();

/// As to_braille (braille.h), with the same errors. Thread-safe.
std::vector<std::uint8_t> cells_by_louis(std::string_view utf8, const LouisTable& table, std::string_view text_place);

/// Before which letters of the word a table with hyphenation patterns ("de-g0.utb,hyph_de_DE.dic") divides it, by letter. Empty:
/// it does not know, as of words of 100 letters or more. Thread-safe.
std::vector<bool> divisions_by_louis(std::string_view word, const std::string& table);

}  // namespace tactics
