// SPDX-License-Identifier: Apache-2.0
// The description of a filter. The filters are in filters/, one file for each verb.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "tactics/artwork.h"
#include "tactics/medium.h"
#include "tactics/option.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// How much of a picture's width and height is left, each from 0 to 1.
struct Kept {
    double width = 1;
    double height = 1;
};

/// What a filter chose for an artwork, and why; empty: there was nothing to choose.
struct ChosenSetting {
    std::string setting = {};  ///< "k=3"; the name alone, "subject", if `why` tells what came of the user's own value
    Phrase why = {};           ///< "3 greys explain 94 % of its variance"
    std::string filter = {};   ///< its name, which run_settling fills in

    bool empty() const { return why.empty(); }
    bool can_be_changed() const { return setting.find('=') != std::string::npos; }
    Phrase words() const { return phrase("{0}: {1}", filter + " " + setting, why); }
};

struct Filter {
    std::string_view name = {};
    std::string_view summary = {};  ///< one line, lower case, no period
    Kinds takes = 0;                ///< a filter that takes pictures also takes an edge map (as converted by to_picture)
    Kinds gives = 0;                ///< one kind, or 0: the same kind as its input
    /// Works better with a colour picture; other filters keep a picture's colour or convert it to grey themselves. A filter with
    /// a setting colour=no|yes uses colour only if that is yes.
    bool uses_colour = false;
    std::span<const Option> options = {};
    /// Pure: same artwork and settings, same answer, on any thread. Artwork is of a kind in `takes`.
    Artwork (*apply)(Artwork artwork, const Settings& settings) = nullptr;
    /// Replaces settings that leave the choice to the filter (0) by the values that `apply` would choose for this artwork, and
    /// says what it chose and why. Things that `apply` leaves out on its own are such a choice, too. nullptr: this filter never
    /// chooses.
    ChosenSetting (*settle)(const Artwork& artwork, Settings& settings) = nullptr;
    /// Fills in values that the medium decides and the user has not set, and removes those that the medium could not show.
    void (*fit)(Settings& settings, const Medium& medium) = nullptr;
    Kept (*keeps)(const Settings& settings) = nullptr;  ///< of the picture; nullptr: all of it
    std::string_view dpi = {};  ///< name of its option for the page resolution of all later filters; empty: none
    /// If a recipe ends in a kind that cannot be printed, the filter that finishes this kind follows with default settings.
    Kinds finishes = 0;
    std::string_view budget = {};  ///< name of its option for the amount of line to keep, which --detail changes; empty: none
    /// The step, as a line of a recipe, that replaces it if every contour is wanted; settings that both have are kept. "-":
    /// nothing replaces it. Empty: it stays.
    std::string_view in_full = {};
    bool cuts_edges = false;  ///< its output edge maps have only lines and background
};

using FilterList = std::span<const Filter* const>;
const Filter* find_filter(FilterList list, std::string_view name);  ///< nullptr if there is none

}  // namespace tactics
