// What an output format says of itself. The formats are in formats/, one a file.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/option.h"
#include "tactics/page.h"

namespace tactics {

struct Embosser;

/// The braille that a machine sets, or a file holds, and where its dots can be.
struct DotSetting {
    CellSize cell;
    DotBed bed;
};

struct Format {
    std::string_view name;        ///< "pdf"
    std::string_view summary;     ///< one line
    std::string_view extensions;  ///< what file names end with, without the dot, longest first: "ps eps"
    std::string_view medium;      ///< the medium it is made for, if the user names none: "swell", "embosser"
    std::string_view paper;       ///< the paper it is made for, if the user names none
    std::span<const Option> options;
    /// The whole file. Pure: same page, same settings, same bytes, whatever the locale, the clock and the thread.
    std::string (*encode)(const Page& page, const Settings& settings) = nullptr;
    /// The whole file of one page or more, all of one size; of one page the same bytes as encode. nullptr: it holds one.
    std::string (*encode_pages)(std::span<const Page> pages, const Settings& settings) = nullptr;
    const Embosser* embosser = nullptr;  ///< the bytes of a machine; nullptr: a kind of file
    DotSetting (*dots)(const Settings& settings) = nullptr;  ///< nullptr: dots and braille may be anywhere, in any size
};

/// One file that holds them all, or, if the format holds one, a file for each page with something on it.
std::vector<std::string> files_of(const Format& format, std::span<const Page> pages, const Settings& settings);

/// Kinds of files, then embossers, each in the order of the help.
std::span<const Format* const> formats();
const Format* find_format(std::string_view name);          ///< nullptr if there is none
/// With its dot, "page.PNG": 4; the longest that fits; 0 if the name ends in none of the format's extensions.
std::size_t ending_size(const Format& format, std::string_view path);
const Format* format_of_path(std::string_view path);       ///< by the end of the name; nullptr if it tells nothing

}  // namespace tactics
