// SPDX-License-Identifier: Apache-2.0
// A line of lettering on its way from ink to words.
#pragma once

#include "tactics/lettering/lettering.h"
#include "tactics/lettering/lines.h"

namespace tactics {

struct ReadLine {
    LetteringLine line;
    PrintedWords words;
    bool alike = false;    ///< read the same at two sizes
    bool counted = false;  ///< it has as many words as there are gaps
    bool tell = false;     ///< it is print, whether it can be read or not
    bool likely = false;   ///< it was read as words that may be none
};

inline bool is_words(const LetteringLine& line) { return line.letters.size() > 1; }

/// Its place and its ink, with what fades from it and no ink of others: a line that passes by stays whole.
PrintedWords print_of(const Image& grey, const LetteringLine& line);

/// The print of a picture that is upright, or climbs straight.
Lettering read_upright(const Image& grey, std::string_view language, double least_sure, const PrintFonts& fonts,
                       const std::string& program);

/// The second reader: the letters of fonts are held against each line. `climbing` are lines of one or two letters that may take
/// the place of some of one letter. False: there are no fonts here.
bool hold_against_fonts(const Image& grey, std::vector<ReadLine>& lines, std::vector<LetteringLine> climbing,
                        const PrintFonts& fonts);

/// Which of the lines that are neither sure nor told are print: those that are likely, and such as look like print: figures and
/// words that are soft, noisy or of no known font. Where other print is known these are about as large, else there are few. They
/// stand free. None is what may be drawn: bars and discs; three or more things that look like each other, or are of about one
/// size and as wide as high, as marks of a plot are, and bent dashes among others, unless they stand in line with print.
std::vector<bool> unread_print(const Image& grey, const std::vector<ReadLine>& lines);

/// Which of the lines that are not sure are print beyond doubt, however they are read: words of the size of print that was read
/// for sure, or read themselves with high sureness, and figures in line with such print. A lone mark
/// that may be drawn is none.
std::vector<bool> certain_print(const std::vector<ReadLine>& lines);

}  // namespace tactics
