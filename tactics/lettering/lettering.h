// SPDX-License-Identifier: Apache-2.0
// Print in a picture: found, read, and taken out of it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/drawing.h"
#include "tactics/lettering/ink.h"
#include "tactics/lettering/letter_form.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// A line of print in the picture.
struct PrintedWords {
    std::string text;      ///< as it was read, UTF-8; empty: it looks like print, and nothing was read
    double sureness = 0;   ///< 0 to 100
    bool sure = false;     ///< certain enough to be set in braille without a person's check
    bool print = false;    ///< certainly print, however it is read; else it may be a thing that is drawn
    bool out = false;      ///< print beyond doubt that is not set: it is taken out of the lines, where no finger could read it
    bool upwards = false;  ///< it runs from the bottom to the top
    int letter_height = 0;
    PixelBox box;
    std::optional<Point> at = {};  ///< what it stands at, if that is not its middle: print on a slope ends at it
    int level = 0;                 ///< of grey, between its letters and the ground
    bool light = false;            ///< its letters are lighter
    std::vector<InkRun> ink;       ///< and what fades from it into the ground
};

struct Lettering {
    int width = 0, height = 0;        ///< of the examined picture, in whose coordinates the boxes are
    std::vector<PrintedWords> words;  ///< from the top to the bottom, from the left to the right
    Phrase trouble;                   ///< why nothing was read and how to mend it; empty: all is well
    bool found_any = false;           ///< something that looks like lettering is there
};

/// From the top to the bottom, from the left to the right.
void sort_by_place(std::vector<PrintedWords>& words);

/// The best longer side of a picture for reading, in pixels: A4 at 200 dpi, where 8 pt letters are 16 pixels high.
inline constexpr int kLookForWords = 2400;

/// Words are sure that are read alike at two sizes with at least `least_sure`, and have as many parts as they have gaps. Where
/// there are fonts, the letters of those that the picture is in are held against the ink, and decide: what looks unlike the ink
/// is not sure, whatever Tesseract says, and what both read, or fonts alone without a doubt, is. `program` is for tests.
Lettering read_lettering(const Image& picture, std::string_view language, double least_sure, const PrintFonts& fonts = {},
                         const std::string& program = "tesseract");

/// Tesseract's own measure, of 100. A setting: of the ten figures of tests/bench/figures at 100 and 150 dpi no line of three
/// letters or more that is wrong reaches it twice alike. Shorter ones need more.
inline constexpr double kSureEnough = 60;

/// Paints the background over the ink of the sure words and of those that are out, or of all that is certainly print. `picture`
/// shows the same as the examined one, at any size.
void take_out(Image& picture, const Lettering& lettering, bool only_sure);

}  // namespace tactics
