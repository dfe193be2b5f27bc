// What embossers of Index Braille have in common.
#pragma once

#include <span>
#include <string>

#include "print/embosser.h"
#include "print/format.h"

namespace tactics {

/// ESC D key,key,...; for this job only (firmware 10.30 and newer; an older one would emboss it as text, so "setup=no" leaves it
/// out): no margins of its own, single-sided, no page numbers, these keys besides. Settings: setup, impacts, copies.
std::string index_set_up(const Settings& settings, const std::string& keys);

/// Settings of 4-dot graphics: the pitch, and those of index_set_up.
inline constexpr Option kFourDotOptions[] = {
    {.name = "pitch", .type = Option::Type::choice, .fallback = 2, .min = 0, .max = 2, .unit = "",
     .summary = "mm from dot to dot; labels are braille of standard size at 2.5, too small at 2.0, large at 1.6", .choices = "1.6 2.0 2.5"},
    {.name = "setup", .type = Option::Type::choice, .fallback = 0, .min = 0, .max = 1, .unit = "",
     .summary = "send settings for this job: no for firmware older than 10.30, which embosses them", .choices = "yes no"},
    {.name = "impacts", .type = Option::Type::whole, .fallback = 1, .min = 1, .max = 3, .unit = "",
     .summary = "how often a dot is struck, for heavy paper", .choices = ""},
    {.name = "copies", .type = Option::Type::whole, .fallback = 1, .min = 1, .max = 10000, .unit = "", .summary = "copies of all pages", .choices = ""},
};

/// Pages of text, in the machine's own braille of 2.5 mm (TD0), 6 mm a cell and 10 mm a line, by its table of North American Braille
/// Computer Code (BT0). Settings: those of index_set_up.
std::string index_text_job(std::span<const Page> pages, const Settings& settings);

/// The pages in 4-dot graphics: each byte @ to O is a column of four dots, the topmost its lowest bit.
std::string four_dot_job(std::span<const Page> pages, const Settings& settings);

}  // namespace tactics
