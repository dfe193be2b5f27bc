// SPDX-License-Identifier: Apache-2.0
// What an output format says of itself. The formats are in formats/, one a file.
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

/// The braille that a machine sets, or a file holds, and where its dots can be.
struct DotSetting {
    CellSize cell;
    DotBed bed;
    double width = 0, height = 0;  ///< of all that a display shows, mm; 0: the sheet's
    int title_cells = 0;           ///< of a line that it has for the title besides
    int levels = 2;                ///< heights at which a dot can stand, down among them
    double reach = 0;              ///< mm from the sheet's left edge to the farthest that a dot reaches; 0: all of it
};

struct Format {
    std::string_view name = {};        ///< "pdf"
    std::string_view summary = {};     ///< one line
    std::string_view extensions = {};  ///< what file names end with, without the dot, longest first: "ps eps"
    std::string_view medium = {};      ///< the medium it is made for, if the user names none: "swell", "embosser"
    std::string_view paper = {};       ///< the paper it is made for, if the user names none
    std::span<const Option> options = {};
    /// The whole file, of one page: of a format that holds no more. Pure: same page, same settings, same bytes, whatever the
    /// locale, the clock and the thread.
    std::string (*encode_page)(const Page& page, const Settings& settings) = nullptr;
    /// The whole file of one page or more, all of one size. A format has this, encode_page or encode_heights.
    std::string (*encode_pages)(std::span<const Page> pages, const Settings& settings) = nullptr;
    /// Of a format that can take pages one after the other, of any sizes, and forget them: page_book.h. Its file of one drawing
    /// is not that of encode_pages, as it has an outline.
    std::unique_ptr<PageBook> (*open_book)() = nullptr;
    /// The whole file of heights: a map as it is, or a page as PageRelief raises it, by the options that it adds to these.
    std::string (*encode_heights)(const HeightSheet& sheet, const HeightRows& rows, const Settings& settings) = nullptr;
    const Embosser* embosser = nullptr;  ///< the bytes of a machine; nullptr: a kind of file
    /// What its standard wants told, the settings do not tell and so the file does not say: a sentence for the user, or nothing.
    std::string (*untold)(const Settings& settings) = nullptr;
    DotSetting (*dots)(const Settings& settings) = nullptr;  ///< nullptr: dots and braille may be anywhere, in any size
    bool six_dots = false;                                   ///< a cell has no more, though `dots` does not say so

    /// The file of one page.
    std::string encode(const Page& page, const Settings& settings) const;
};

/// The sheet as the machine of the format has it: its braille, where its dots are and, of a display, its size, or so many times
/// that (display_parts.h). Sheets of other formats stay as they are.
void fit_to_machine(Sheet& sheet, const Format& format, const Settings& settings, int zoom = 1);

/// Dots 7 and 8 of a cell are lost in it.
bool has_six_dots(const Format& format, const Settings& settings);

/// One file that holds them all, or, if the format holds one, a file for each page with something on it; how many, and one after
/// the other.
std::size_t count_files(const Format& format, std::span<const Page> pages);
void each_file(const Format& format, std::span<const Page> pages, const Settings& settings,
               const std::function<void(std::string_view bytes)>& take);
std::vector<std::string> files_of(const Format& format, std::span<const Page> pages, const Settings& settings);

/// Kinds of files, then embossers, then displays, each in the order of the help.
std::span<const Format* const> formats();
const Format* find_format(std::string_view name);  ///< nullptr if there is none
/// With its dot, "page.PNG": 4; the longest that fits; 0 if the name ends in none of the format's extensions.
std::size_t ending_size(const Format& format, std::string_view path);
const Format* format_of_path(std::string_view path);  ///< by the end of the name; nullptr if it tells nothing
/// The format that takes heights whose names end as this one does behind their last dot; nullptr if there is none.
const Format* heights_format_of_path(std::string_view path);

}  // namespace tactics
