// SPDX-License-Identifier: Apache-2.0
// Print in a picture, for convert: when it is read, what becomes of it, and what is told of it.
#pragma once

#include <string>
#include <vector>

#include "tactics/job/axis_names.h"
#include "tactics/job/reading.h"
#include "tactics/layout/sheet.h"
#include "tactics/lettering/lettering.h"
#include "tactics/text/note.h"

namespace tactics {

/// --words. Automatic: read where the recipe is for drawings and Tesseract is there.
enum class WordsWish { automatic, read, leave, remove };
/// "auto", "read", "leave" or "remove". Throws Error(usage) at `place`.
WordsWish find_words_wish(std::string_view name, std::string_view place);

/// A piece of print as it is told: where its middle is in the picture, in percent from its left and top.
struct ToldWords {
    std::string text;
    double sureness = 0;
    double x = 0, y = 0;
    bool set = false;    ///< it stands in braille; otherwise it is for a person to look at
    Point wanted = {};   ///< where the braille is wanted, in percent, too
    bool loose = false;  ///< or near there
    bool title = false;  ///< it is in the page's title, and no name in the drawing
};

/// The print of one picture.
struct PrintWords {
    Lettering lettering;
    std::vector<ToldWords> told;
    Notes notes;              ///< for the user
    bool remove_all = false;  ///< and nothing is set
    std::string title = {};   ///< of the figure, if it has a long one; empty: it has none, or the user gave one

    /// Paints over what does not stay in the line work. What is not sure stays: nothing stands for it yet.
    void take_from(Image& picture) const;
    bool any_set() const;
    std::vector<Name> names_on(const Drawing& drawing) const;
};

/// Nothing if none is to be read. Throws Error(failed) if the user asked for it and it cannot be read.
PrintWords words_of(Reading& reading, const Recipe& recipe, WordsWish wish, const Sheet& sheet);

/// Where the braille of print at those places is wanted: that of axes has its own.
void want_places(std::vector<ToldWords>& told, std::vector<PrintPlace> places);
/// What the table has no cells for is not set: a letter must not stop a page, and a person will know what to do about it. Small
/// raised figures become "^2" first, all of them if one must.
void keep_what_has_braille(std::vector<ToldWords>& told, const std::string& table);

/// Of numbers that stand in a row or a column, four or more, every second is not set any more, as a transcriber does where
/// braille has no room for all. Gives how many that are.
std::size_t thin_out(std::vector<ToldWords>& told);

/// As messages name them: "the print at 30 %, 40 %".
std::string origin_of(const ToldWords& words);

/// "print at 30 %, 40 % was read as ..."
Phrase unsure_line(const ToldWords& words);

}  // namespace tactics
