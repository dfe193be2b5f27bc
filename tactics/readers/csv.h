// SPDX-License-Identifier: Apache-2.0
// The records of a text in lines (CSV of RFC 4180, TSV, columns between blanks), one at a time, within bounds.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tactics/readers/read.h"
#include "tactics/readers/table.h"
#include "tactics/text/phrase.h"

namespace tactics {

inline constexpr std::size_t kLongestCsvRecord = 1'048'576;  // bytes

/// Whether lines of that separator are columns between blanks, as gnuplot and R write them.
inline constexpr char kBlankSeparator = ' ';

/// Values stand between separators; in double quotes they may hold separators and line ends; blanks around them are ignored.
/// Lines with # before the first record are comments; in blank-separated columns, all lines with # are.
class CsvRecords {
public:
    /// Rewinds the source, which must outlive it. Throws Error: UTF-16.
    CsvRecords(const Source& source, char separator);

    /// Whether there is one more. Throws Error with the line.
    bool next();

    std::size_t line() const { return line_; }                             ///< where the record begins, from 1
    const std::vector<std::string_view>& cells() const { return cells_; }  ///< until next()
    bool apart() const { return apart_; }                    ///< in columns between blanks, an empty line is before it
    bool ended() const { return ended_; }                    ///< its last line has an end
    std::size_t bytes() const { return bytes_; }             ///< of the lines so far
    const std::string& comment() const { return comment_; }  ///< the last before the first record, without its #

private:
    bool next_line(std::string_view& line);
    bool fill();
    void split(std::string_view line);
    void split_quoted(std::string_view line);
    void add_cell(std::string_view cell);
    [[noreturn]] void fail(const Phrase& message) const;

    const Source& source_;
    char separator_;
    std::string buffer_;
    std::size_t at_ = 0, end_ = 0, bytes_ = 0;
    std::size_t number_ = 0, line_ = 0;
    bool begun_ = false, apart_ = false, ended_ = true;
    std::string comment_, unquoted_;
    std::vector<std::string_view> cells_;
};

/// The separator (tab, semicolon, comma or blanks) for which the first records have equal length and mostly numbers; if there is
/// none, the one in the first line.
char separator_of(const Source& source);

/// Whether a first line that is one value short leaves out the name of the row names, which come first, as R writes tables.
bool leaves_out_row_names(char separator);

/// Takes the values of one line apart that has no quotes.
std::vector<std::string_view> cells_of(std::string_view line, char separator);

}  // namespace tactics
