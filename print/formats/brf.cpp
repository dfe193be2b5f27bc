// SPDX-License-Identifier: Apache-2.0
// BRF, the text format that every embosser and braille display takes: one letter a cell (North American Braille
// Computer Code), CR LF after a line, form feed after a page, as file2brl of liblouisutdml 2.11 has them (libembosser 1.4.3
// leaves out the CR LF before a form feed).
//
// The page has as many cells and lines as its live area holds: 45 x 28 on 11 x 11.5 in paper with margins of 6 mm. The
// embosser must be set to at least as many cells and lines, and to single-sided and uncontracted (no translation).
#include "print/format.h"
#include "print/text_job.h"

namespace tactics {

namespace {

std::string encode_pages_brf(std::span<const Page> pages, const Settings&) {
    TextJob job;
    job.letter = nabcc_letter;
    return text_job(pages, job);
}

}  // namespace

extern const Format brf_format;
const Format brf_format{
    .name = "brf",
    .summary = "braille text with a drawing of 6-dot cells, for any embosser",
    .extensions = "brf",
    .medium = "embosser",
    .paper = "11x11.5",
    .encode_pages = encode_pages_brf,
    .six_dots = true,
};

}  // namespace tactics
