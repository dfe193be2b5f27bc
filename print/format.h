// What an output format says of itself. The formats are in formats/, one a file.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "tactics/option.h"
#include "tactics/page.h"

namespace tactics {

struct Format {
    std::string_view name;        ///< "pdf"
    std::string_view summary;     ///< one line
    std::string_view extensions;  ///< what file names end with, without the dot, longest first: "ps eps"
    std::string_view medium;      ///< the medium it is made for, if the user names none: "swell", "embosser"
    std::string_view paper;       ///< the paper it is made for, if the user names none
    std::span<const Option> options;
    /// The whole file. Pure: same page, same settings, same bytes, whatever the locale, the clock and the thread.
    std::string (*encode)(const Page& page, const Settings& settings) = nullptr;
};

std::span<const Format* const> formats();
const Format* find_format(std::string_view name);          ///< nullptr if there is none
const Format* format_of_path(std::string_view path);       ///< by the end of the name; nullptr if it tells nothing

}  // namespace tactics
