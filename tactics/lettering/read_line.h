// SPDX-License-Identifier: Apache-2.0
// A line of lettering on its way from ink to words.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tactics/lettering/lettering.h"
#include "tactics/lettering/lines.h"

namespace tactics {

/// What is known of a line that was freed of what is drawn.
struct Freed {
    bool goes_on = false;  ///< what was freed stands as letters do: as high, or on their line
    bool lacks = false;    ///< beside it is what may be a part of a letter, a point, or a tick
};

struct ReadLine {
    LetteringLine line;
    PrintedWords words;
    bool alike = false;                      ///< read the same at two sizes
    bool counted = false;                    ///< it has as many words as there are gaps
    bool tell = false;                       ///< it is print, whether it can be read or not
    bool nearly = false;                     ///< a number that others of an axis may bear out, as Belief has it
    bool likely = false;                     ///< it was read as words that may be none
    std::optional<Freed> freed = {};         ///< it may take the place of lines that are parts of it
    std::vector<std::string> readings = {};  ///< what any reader has made of it
};

inline bool is_words(const LetteringLine& line) { return line.letters.size() > 1; }

/// Its place and its ink, with what fades from it and no ink of others: a line that passes by stays whole.
PrintedWords print_of(const Image& grey, const LetteringLine& line);

/// The print of a picture that is upright, or climbs straight.
Lettering read_upright(const Image& grey, std::string_view language, double least_sure, const PrintFonts& fonts,
                       const std::string& program);

struct FreedLine {
    LetteringLine line;
    Freed freed;
};

/// Of lines of print that stand beside something drawn, each once more, with what stands in line with it but hangs together with
/// a long stroke, such as a link of a diagram or a coast, and without that stroke, which becomes its veil. Lines that are parted
/// by such letters become one.
std::vector<FreedLine> freed_lines(const Image& grey, const std::vector<LetteringLine>& lines);

/// The second reader: the letters of fonts are held against each line. `climbing` are lines of one or two letters that may take
/// the place of some of one letter. False: there are no fonts here.
bool hold_against_fonts(const Image& grey, std::vector<ReadLine>& lines, std::vector<LetteringLine> climbing,
                        const PrintFonts& fonts);

/// What is as large as letters of the print there, is no simple form, and hangs together with a long stroke: letters by
/// themselves that no reader got. A few at most; more are a texture.
std::vector<LetteringLine> loose_letters(const Image& grey, const std::vector<ReadLine>& lines);

/// Which of the lines that are neither sure nor told are print: those that are likely, and such as look like print: figures and
/// words that are soft, noisy or of no known font. Where other print is known these are about as large, else there are few. They
/// stand free. None is what may be drawn: bars and discs; three or more things that look like each other, or are of about one
/// size and as wide as high, as marks of a plot are, and bent dashes among others, unless they stand in line with print.
std::vector<bool> unread_print(const Image& grey, const std::vector<ReadLine>& lines);

/// Which of the lines that are not sure are print beyond doubt, however they are read: words of the size of print that was read
/// for sure, or read themselves with high sureness, and figures in line with such print. A lone mark
/// that may be drawn is none.
std::vector<bool> certain_print(const std::vector<ReadLine>& lines);

/// Pixels, of the tallest letter of a line. A setting: an x of larger print is as high as the smallest thing whose shape tells.
inline constexpr int kMostSmallPrint = 13;

/// Adds those of `low`, as find_lettering gives them, that are print: there is small print of about that size and as thick among
/// `lines`, and a letter by itself stands in line with it.
void add_low_print(const Image& grey, std::vector<LetteringLine>& lines, std::vector<LetteringLine> low);

enum class SmallPrint { none, told, out, mark };

/// Which of the lines that are neither sure nor told are small print all the same: what is as high and as thick as small print
/// that is known, stands free, is no bar, block, or mark that is there several times, and stands in line with print or was read
/// as likely words; and figures in even steps with those of an axis. It is out if nothing drawn could be there.
/// A mark is what lies among marks of a plot, one or a few that cover each other, and may have been taken for letters.
std::vector<SmallPrint> small_print(const Image& grey, const std::vector<ReadLine>& lines);

/// Where most numbers of a row or column were read and grow evenly, one that is not sure becomes sure if a reader has read what
/// its place says; and in tiny print one that was read for sure and is another is no longer sure, but told.
void hold_against_axes(std::vector<ReadLine>& lines);

/// A label of which a part is only told, or lost behind lines, is told as a whole: "effect" of "random effect" would name
/// something else, as would "6" of "6 cm". Figures stand beside each other along a scale. `told`: by index, what is told although
/// no reader made it out.
void doubt_parts(const Image& grey, std::vector<ReadLine>& lines, const std::vector<bool>& told);

/// A frame that runs through "10.5" leaves "10 5".
void doubt_parted(const Image& grey, std::vector<ReadLine>& lines);

}  // namespace tactics
