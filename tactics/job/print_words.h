// SPDX-License-Identifier: Apache-2.0
// Print in a picture, for convert: when it is read, what happens to it, and what is reported.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tactics/job/axis_names.h"
#include "tactics/job/reading.h"
#include "tactics/job/told_words.h"
#include "tactics/layout/sheet.h"
#include "tactics/lettering/lettering.h"
#include "tactics/text/note.h"

namespace tactics {

/// --words. Automatic: read it if the recipe is for drawings and Tesseract is installed.
enum class WordsWish { automatic, read, leave, remove };
/// "auto", "read", "leave" or "remove". Throws Error(usage) at `place`.
WordsWish find_words_wish(std::string_view name, std::string_view place);

/// The print in one picture.
struct PrintWords {
    Lettering lettering;
    std::vector<ToldWords> told;
    Notes notes;              ///< for the user
    bool remove_all = false;  ///< remove all print and set nothing
    std::vector<Rect> samples =
        {};  ///< in percent: samples of a legend whose words stand at the things themselves, and the sides of its frame
    std::string title = {};  ///< title of the figure, if it has a long one; empty: none, or the user gave one

    /// Paints over the print that does not stay in the drawing. What may be drawn stays, and is reported.
    void take_from(Image& picture) const;
    bool any_set() const;
    /// On a drawing of that part of the picture (in shares of its sides); names may lie outside of it.
    std::vector<Name> names_on(const Drawing& drawing, const Rect& part) const;
};

/// Nothing if no print is to be read. Throws Error(failed) if the user asked for it and it cannot be read.
PrintWords words_of(Reading& reading, const Recipe& recipe, WordsWish wish, const Sheet& sheet);

/// Sets the preferred places of the braille: axis names have their own.
void want_places(std::vector<ToldWords>& told, std::vector<PrintPlace> places);
/// Words with letters that have no cells in the table are not set: a letter must not stop a page, and a person will know what to
/// do. Superscript digits first become "^2", all of them if one must.
void keep_what_has_braille(std::vector<ToldWords>& told, const std::string& table);

/// Names that were left out are no longer set.
std::vector<ToldWords> without(const std::vector<Name>& left_out, std::vector<ToldWords> told);

/// The form in messages: "the print at 30 %, 40 %".
std::string origin_of(const ToldWords& words);

/// "print at 30 %, 40 % was read as ..."
Phrase unsure_line(const ToldWords& words);

}  // namespace tactics
