// SPDX-License-Identifier: Apache-2.0
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
    {.name = "pitch",
     .type = Option::Type::choice,
     .fallback = 2,
     .min = 0,
     .max = 2,
     .summary = "mm from dot to dot; labels are braille of standard size at 2.5, too small at 2.0, large at 1.6",
     .choices = "1.6 2.0 2.5"},
    {.name = "setup",
     .type = Option::Type::choice,
     .fallback = 0,
     .min = 0,
     .max = 1,
     .summary = "send settings for this job: no for firmware older than 10.30, which embosses them",
     .choices = "yes no"},
    {.name = "impacts",
     .type = Option::Type::whole,
     .fallback = 1,
     .min = 1,
     .max = 3,
     .summary = "how often a dot is struck, for heavy paper"},
    {.name = "copies", .type = Option::Type::whole, .fallback = 1, .min = 1, .max = 10000, .summary = "copies of all pages"},
};

/// What the series have in common.
inline constexpr ProtocolFact kFourDotFact{
    "ESC 07h and ESC 06h begin and end 4-dot graphics; @ to O is a column of 4 dots, the lowest bit on top; @ at the end may be "
    "left out",
    "cups-filters imageubrltoindexv3 and v4", Confidence::good};
inline constexpr ProtocolFact kFourDotSetUpFact{
    "ESC D key,key; sets up this job with firmware 10.30 and newer; GD is the graphic pitch (2.0, 2.5, 1.6 mm), DP1 "
    "single-sided, PN0 no page "
    "numbers, MC copies, MI impacts, TM and BI margins, FO first line",
    "cups-filters index.sh; dotify IndexV4Header", Confidence::medium};
inline constexpr ProtocolFact kJobEndFact{"1Ah ends a job", "cups-filters; dotify", Confidence::medium};
inline constexpr ProtocolFact kFeedFact{"a form feed outside of graphics ends a page of them",
                                        "this project, by analogy with text", Confidence::uncertain};
inline constexpr ProtocolFact kIndexTextFact{
    "text: BT0 is the table of North American Braille Computer Code, TD0 dots 2.5 mm apart, CH cells of a line, LP lines of a "
    "page",
    "dotify IndexV4Header; brailleplot AbstractIndexV4Builder", Confidence::medium};

/// Text in the machine's own braille of 2.5 mm (TD0), 6 mm a cell and 10 mm a line, by its table of North American Braille
/// Computer Code (BT0). Settings: those of index_set_up.
extern const TextMode index_v3_text, index_v4_text;

/// From the left top corner of the sheet to the first dot of any page, mm.
inline constexpr Point kFirstDotV3{0.8, 2.8}, kFirstDotV4{5.8, 5.8};

/// The pages in 4-dot graphics: each byte @ to O is a column of four dots, the topmost its lowest bit.
std::string four_dot_job(std::span<const Page> pages, const Settings& settings);

}  // namespace tactics
