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

/// What was asked for by name: a page of our own that is read keeps its own else, whatever is usual.
struct AskedByName {
    bool language = false, braille = false, cell = false;
};

/// How pages are made: what is the same for all pictures of a batch. What is left out is as the program would choose it.
struct Wishes {
    RecipeWish chain;
    std::optional<Recipe> recipe;  ///< finish()ed; nothing: made of `chain`, or chosen for each picture
    Sheet sheet;                   ///< all but paper and medium, which may come from the format
    std::optional<Paper> paper;
    AskedByName asked = {};
    const Format* machine = nullptr;        ///< outputs that are of no machine are laid out for this one; nullptr: for their own
    KeptSheet kept = {};                    ///< what counts where sheet and paper leave something open
    TableWish table = {};                   ///< what is drawn of a table
    bool tables_only = false;               ///< a file is a table, whatever it looks like
    ChartWish chart = {};                   ///< how a plot is drawn
    ModelDrawingWish model = {};            ///< how a model is drawn
    std::vector<std::string> allowed = {};  ///< of kAskedFormats: the files are trusted
    int page = 0;                           ///< of a PDF; 0: its first, or all that are text
    bool as_text = false;                   ///< what is written in a file is laid out as pages of braille (written.h)
    int zoom = 1;                           ///< of what a display shows
    bool title_from_name = false;
    std::vector<std::pair<const Format*, Settings>> settings;  ///< of formats; the defaults of others
    bool fixed_dpi = false;                  ///< it was said how many dots there are, so a bare page leaves that alone
    WordsWish words = WordsWish::automatic;  ///< what becomes of print in pictures
    Keep keep = Keep::on_disk;               ///< of pages that are done
    bool check_rules = false;                ///< the outcome tells which hard rules the pages break
    std::string save_recipe;                 ///< the file that is to hold a recipe that is chosen

    Settings settings_of(const Format& format) const;
};

/// The sheet that a format is laid out on. Two sheets of the same wishes differ in paper, medium and machine only.
Sheet sheet_for(const Wishes& wishes, const Format& format, const Item& item);
bool same_sheet(const Sheet& a, const Sheet& b);

}  // namespace tactics
