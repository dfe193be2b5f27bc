// SPDX-License-Identifier: Apache-2.0
// The description of an output format. The formats are in formats/, one file each.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "print/height_files.h"
#include "tactics/layout/sheet.h"
#include "tactics/option.h"
#include "tactics/page.h"

namespace tactics {

struct Embosser;
class PageBook;

/// The braille of a machine or a file, and the possible places of its dots.
struct DotSetting {
    CellSize cell;
    DotBed bed;
    double width = 0, height = 0;  ///< size of a display's area, mm; 0: that of the sheet
    int title_cells = 0;           ///< cells of its separate line for the title
    DotHeights heights = {};       ///< of a dot
    double reach = 0;              ///< mm from the sheet's left edge to the farthest dot; 0: the whole sheet
};

struct Format {
    std::string_view name = {};        ///< "pdf"
    std::string_view summary = {};     ///< one line
    std::string_view extensions = {};  ///< endings of file names, without the dot, longest first: "ps eps"
    std::string_view medium = {};      ///< default medium: "swell", "embosser"
    std::string_view paper = {};       ///< default paper
    std::span<const Option> options = {};
    /// The whole file of one page, for a format that holds only one. Pure: the same page and settings give the same bytes,
    /// regardless of locale, clock and thread.
    std::string (*encode_page)(const Page& page, const Settings& settings) = nullptr;
    /// The whole file of one or more pages, all of one size. Every format has this, encode_page or encode_heights.
    std::string (*encode_pages)(std::span<const Page> pages, const Settings& settings) = nullptr;
    /// For a format that can take pages of any size one after another without keeping them: page_book.h. Its file of one drawing
    /// differs from that of encode_pages, because it has an outline.
    std::unique_ptr<PageBook> (*open_book)() = nullptr;
    /// The whole file of heights: an unchanged map, or a page as PageRelief raises it, with the options that it adds to these.
    std::string (*encode_heights)(const HeightSheet& sheet, const HeightRows& rows, const Settings& settings) = nullptr;
    const Embosser* embosser = nullptr;  ///< nullptr: a file format, not a machine
    /// A sentence for the user about facts that its standard requires and the settings do not give, or nothing.
    std::string (*untold)(const Settings& settings) = nullptr;
    DotSetting (*dots)(const Settings& settings) = nullptr;  ///< nullptr: dots and braille may have any place and size
    bool six_dots = false;                                   ///< its cells have only six dots, although `dots` does not say so

    /// The file of one page.
    std::string encode(const Page& page, const Settings& settings) const;
};

/// The sheet adapted to the machine of the format: its braille, the places of its dots and, for a display, its size, or a
/// multiple of that (display_parts.h). Sheets of other formats are unchanged.
void fit_to_machine(Sheet& sheet, const Format& format, const Settings& settings, int zoom = 1);

/// Whether it loses dots 7 and 8 of a cell.
bool has_six_dots(const Format& format, const Settings& settings);

/// One file that holds all pages, or, if the format holds only one, a file for each page that is not empty; first their number,
/// then one after another.
std::size_t count_files(const Format& format, std::span<const Page> pages);
void each_file(const Format& format, std::span<const Page> pages, const Settings& settings,
               const std::function<void(std::string_view bytes)>& take);
std::vector<std::string> files_of(const Format& format, std::span<const Page> pages, const Settings& settings);

/// File formats, then embossers, then displays, each in the order of the help.
std::span<const Format* const> formats();
const Format* find_format(std::string_view name);  ///< nullptr if there is none
/// Length of the ending with its dot, "page.PNG": 4; the longest that matches; 0 if none of the format's extensions matches.
std::size_t ending_size(const Format& format, std::string_view path);
const Format* format_of_path(std::string_view path);  ///< by the ending of the name; nullptr if it matches none
/// The height format for the ending after the last dot of this name; nullptr if there is none.
const Format* heights_format_of_path(std::string_view path);

}  // namespace tactics
