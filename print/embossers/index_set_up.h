// SPDX-License-Identifier: Apache-2.0
// The common part of the embossers of Index Braille.
#pragma once

#include <span>
#include <string>

#include "print/embosser.h"
#include "print/format.h"
#include "print/sides.h"

namespace tactics {

enum class IndexSeries { v3, v4 };

/// ESC D key,key,...; for this job only (firmware 10.30 and newer; an older one would emboss it as text, so "setup=no" omits it):
/// no machine margins, no page numbers, the sheet, single lines, North American Braille Computer Code. `graphic` is the key of a
/// graphic pitch, or empty. Settings: setup, impacts, copies; sides and model if the format has them.
std::string index_set_up(const Page& page, const Settings& settings, IndexSeries series, std::string_view graphic);

inline constexpr std::size_t kIndexPacket = 64;  ///< bytes, of USB

/// Adds one more 1Ah, an empty job, after a job whose length is a multiple of that.
std::string index_job(std::string bytes);

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
    kSides,
    {.name = "model",
     .type = Option::Type::choice,
     .fallback = 0,
     .min = 0,
     .max = 2,
     .summary = "of the third series, which has the size of its paper in its own unit: everest (and 4x4 PRO), basic; any (and "
                "4-Waves) leaves it as it is set on the machine",
     .choices = "any everest basic"},
};
inline constexpr std::span<const Option> kFourDotOptionsV4 = std::span(kFourDotOptions).first(std::size(kFourDotOptions) - 1);

/// The common part of the series.
inline constexpr ProtocolFact kFourDotFact{
    "ESC 07h and ESC 06h begin and end 4-dot graphics; @ to O is a column of 4 dots, the lowest bit on top; @ at the end may be "
    "left out",
    "cups-filters imageubrltoindexv3 and v4", Confidence::good};
inline constexpr ProtocolFact kFourDotSetUpFact{
    "ESC D key,key; sets up this job with firmware 10.30 and newer, in the order of cups-filters: TM0 BI0 FO0 no margins, MC "
    "copies, "
    "MI impacts, DP1 one side and DP2 both, TD0 text dots 2.5 mm apart, GD graphic dots 2.0, 2.5 or 1.6 mm apart, PN0 no page "
    "numbers, LS single lines, BT0 North American Braille Computer Code",
    "cups-filters 1.28.17 index.sh, indexv3.sh, indexv4.sh; libembosser 1.4.3 and dotify 1.0.9 set the same in other orders, "
    "without "
    "FO, MI and GD",
    Confidence::good};
inline constexpr ProtocolFact kJobEndFact{
    "1Ah ends a job", "Index's own CUPS driver 1.2.3; cups-filters 1.28.17; libembosser 1.4.3 (dotify sends none)",
    Confidence::good};
inline constexpr ProtocolFact kPacketFact{
    "USB of the machine waits for more behind a job that is a multiple of 64 bytes long: such a job has another 1Ah, an empty "
    "job, "
    "which is dropped",
    "Index's own CUPS driver 1.2.3, index-braille.sh and index-direct-braille.c", Confidence::good};
inline constexpr ProtocolFact kFeedFact{"a form feed and CR inside the graphics, behind their last line, end a page",
                                        "cups-filters 1.28.17, which adds both to a page of "
                                        "imagetoubrl",
                                        Confidence::good};
inline constexpr ProtocolFact kIndexTextFact{
    "text: lines have CR LF between them, a page a form feed behind its last letter, also when it is full or empty",
    "libembosser 1.4.3 IndexBrailleDocumentHandler; dotify 1.0.9 IndexV3Embosser, IndexV4Embosser", Confidence::good};
inline constexpr ProtocolFact kIndexCellFact{
    "text is in the machine's own cells, 6 mm apart; braille beside a drawing stands on the raster of the graphics, in cells 7.5 "
    "mm "
    "apart at a pitch of 2.5 mm: no source says where a line of text stands behind one of graphics",
    "dotify 1.0.9 IndexEmbosser; this project", Confidence::medium};

/// Text mode with the machine's own braille of 2.5 mm (TD0), 6 mm per cell and 10 mm per line, and its table of North American
/// Braille Computer Code (BT0). Settings: those of index_set_up.
extern const TextMode index_v3_text, index_v4_text;

/// Distance from the top left corner of the sheet to the first dot of any page, mm.
inline constexpr Point kFirstDotV3{0.8, 2.8}, kFirstDotV4{5.8, 5.8};

/// The pages in 4-dot graphics: each byte @ to O is a column of four dots, with the topmost as its lowest bit.
std::string four_dot_job_v3(std::span<const Page> pages, const Settings& settings);
std::string four_dot_job_v4(std::span<const Page> pages, const Settings& settings);

}  // namespace tactics
