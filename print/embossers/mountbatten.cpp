// SPDX-License-Identifier: Apache-2.0
// Harpo Mountbatten, as text.
#include "print/embosser.h"
#include "print/format.h"
#include "print/machines/machines.h"
#include "print/text_job.h"

namespace tactics {

namespace {

constexpr ProtocolFact kMountbattenFacts[] = {
    {"{man} keeps lines as they are sent, {bc 1} selects North American Braille Computer Code, {lm 0} {rm 0} {tm 0} are "
     "margins, {np} ends a line",
     "dotify 1.0.9 MountbattenEmbosser", Confidence::medium},
    {"letters are lower case, which that code writes without a capital sign", "dotify 1.0.9 EmbosserTableProvider NABCC",
     Confidence::medium},
    {"@ [ \\ ] ^ are sent for dots 4, 2 4 6, 1 2 5 6, 1 2 4 5 6 and 4 5, as the 6-dot code writes them in a single cell; dotify "
     "sends ` { | } ~, of which { begins a command",
     "Code for Computer Braille Notation, BANA 1987; dotify 1.0.9", Confidence::uncertain},
    {"cells are 5.9 mm wide, lines 10.1 mm high; 15 mm on every side cannot be embossed", "dotify 1.0.9", Confidence::medium},
    {"sheets are fed by hand, one per page; a form feed after the last line ends a page", "dotify 1.0.9", Confidence::medium},
};

constexpr CellSize kMountbattenCell{2.5, 5.9, 10.1, 1.6};

DotSetting mountbatten_dots(const Settings&) { return {kMountbattenCell, DotBed{{15.8, 15.8}, 0, 3}}; }

// Braces begin and end commands, and stand for no cell.
std::string mountbatten_letter(std::uint8_t cell) {
    const char large = nabcc_letter(cell)[0];
    return {large >= 'A' && large <= 'Z' ? static_cast<char>(large - 'A' + 'a') : large};
}

std::string encode_pages_mountbatten(std::span<const Page> pages, const Settings&) {
    TextJob job;
    job.begin = "{man}{bc 1}{lm 0}{rm 0}{tm 0}";
    job.line_end = "{np}";
    job.page_end = "\f";
    job.letter = mountbatten_letter;
    return text_job(pages, job);
}

constexpr Embosser kMountbattenEmbosser{
    .models = "Harpo Mountbatten",
    .called = "harpo-mountbatten",
    .known_by = "mountbatten harpo",
    .punch = punch_mountbatten,
    .widest = 330,
    .longest = 382,
    .facts = kMountbattenFacts,
};

}  // namespace

extern const Format mountbatten_format;
const Format mountbatten_format{
    .name = "mountbatten",
    .summary = "Harpo Mountbatten, in cells",
    .medium = "embosser",
    .paper = "a4",
    .encode_pages = encode_pages_mountbatten,
    .embosser = &kMountbattenEmbosser,
    .dots = mountbatten_dots,
};

}  // namespace tactics
