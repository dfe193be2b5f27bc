// SPDX-License-Identifier: Apache-2.0
// How pages are to be made.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "filters/chart.h"
#include "tactics/job/item.h"
#include "tactics/job/kept_sheet.h"
#include "tactics/job/model_drawing.h"
#include "tactics/job/print_words.h"
#include "tactics/job/recipe_wish.h"
#include "tactics/job/table.h"
#include "tactics/layout/sheet.h"
#include "tactics/transport/file.h"

namespace tactics {

/// Choices that were made by name. Without them, a page of our own that is read back keeps its own.
struct AskedByName {
    bool language = false, braille = false, cell = false;
};

/// How to make pages; the same for all pictures of a batch. The program chooses everything that is left open.
struct Wishes {
    RecipeWish chain;
    std::optional<Recipe> recipe;  ///< finish()ed; nothing: built from `chain`, or chosen for each picture
    Sheet sheet;                   ///< without paper and medium, which may come from the format
    std::optional<Paper> paper;
    AskedByName asked = {};
    const Format* machine = nullptr;  ///< the machine for which outputs that belong to none are laid out; nullptr: their own
    KeptSheet kept = {};              ///< used where sheet and paper leave something open
    TableWish table = {};             ///< which columns of a table to draw
    bool tables_only = false;         ///< treat every file as a table
    ChartWish chart = {};             ///< how a plot is drawn
    ModelDrawingWish model = {};      ///< how a model is drawn
    std::vector<std::string> allowed = {};  ///< of kAskedFormats: the files are trusted
    int page = 0;                           ///< page of a PDF; 0: the first, or all pages of text
    bool as_text = false;                   ///< lay out the text of a file as braille pages (written.h)
    int zoom = 1;                           ///< enlargement on a display
    bool title_from_name = false;
    std::vector<std::pair<const Format*, Settings>> settings;  ///< settings of formats; other formats use their defaults
    bool fixed_dpi = false;                  ///< the user gave the resolution, so a bare page does not change it
    WordsWish words = WordsWish::automatic;  ///< what to do with print in pictures
    Keep keep = Keep::on_disk;               ///< how finished pages are kept
    std::string save_recipe;                 ///< file to which the chosen recipe is written

    Settings settings_of(const Format& format) const;
};

/// The sheet for a format. Two sheets of the same wishes differ only in paper, medium and machine.
Sheet sheet_for(const Wishes& wishes, const Format& format, const Item& item);
bool same_sheet(const Sheet& a, const Sheet& b);

}  // namespace tactics
