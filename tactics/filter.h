// SPDX-License-Identifier: Apache-2.0
// What a filter says of itself. The filters are in filters/, one verb a file.
#pragma once

#include <span>
#include <string_view>

#include "tactics/artwork.h"
#include "tactics/medium.h"
#include "tactics/option.h"

namespace tactics {

/// How much of a picture's sides is left, each from 0 to 1.
struct Kept {
    double width = 1;
    double height = 1;
};

struct Filter {
    std::string_view name = {};
    std::string_view summary = {};  ///< one line, lower case, no period
    Kinds takes = 0;                ///< an edge map is also taken by a filter that takes pictures (as to_picture shows it)
    Kinds gives = 0;                ///< one kind, or 0: the kind that it was given
    /// Is better with a colour picture; the others keep a picture's colour or make it grey themselves. A filter that also
    /// has a setting colour=no|yes uses it only when that is yes.
    bool uses_colour = false;
    std::span<const Option> options = {};
    /// Pure: same artwork and settings, same answer, on any thread. Artwork is of a kind in `takes`.
    Artwork (*apply)(Artwork artwork, const Settings& settings) = nullptr;
    /// Puts numbers in place of settings that leave the choice to the filter (0), as `apply` would choose for that artwork, and
    /// says what it chose and why: "k=3: 3 greys explain 94 % of ...". What `apply` leaves out by itself is such a choice, too.
    /// An empty answer means that there was nothing to choose. nullptr: this filter never chooses.
    std::string (*settle)(const Artwork& artwork, Settings& settings) = nullptr;
    /// Fills in what a medium decides where the user has not, and takes back what it could not show.
    void (*fit)(Settings& settings, const Medium& medium) = nullptr;
    Kept (*keeps)(const Settings& settings) = nullptr;  ///< of the picture; nullptr: all of it
    std::string_view dpi = {};  ///< its option for the resolution of the page at which all that follows looks; empty: none
    /// What a recipe ends in that cannot be printed is given to the filter that finishes that kind, at its defaults.
    Kinds finishes = 0;
    std::string_view budget = {};  ///< its option for how much line it leaves, which --detail turns; empty: none
    /// The step that takes its place where every contour is wanted, as a recipe's line; it keeps what settings both have. "-":
    /// none does. Empty: it stays.
    std::string_view in_full = {};
    bool cuts_edges = false;  ///< an edge map that went through it has lines and ground only
};

using FilterList = std::span<const Filter* const>;
const Filter* find_filter(FilterList list, std::string_view name);  ///< nullptr if there is none

}  // namespace tactics
