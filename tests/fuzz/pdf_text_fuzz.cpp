// SPDX-License-Identifier: Apache-2.0
// Possible outputs of pdftocairo and pdftotext for a page, separated by a line of equal signs: an SVG with words, or one line
// with an error.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "tactics/error.h"
#include "tactics/job/written.h"
#include "tactics/readers/svg/cairo_glyphs.h"
#include "tactics/readers/svg/pdf_text.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace tactics;
    constexpr std::string_view kBetween = "\n====\n";
    const std::string_view bytes = size == 0 ? std::string_view() : std::string_view(reinterpret_cast<const char*>(data), size);
    const auto at = bytes.find(kBetween);
    if (at == std::string_view::npos) return 0;
    const std::string_view svg = bytes.substr(0, at);
    try {
        const PdfText text = pdf_text_of(bytes.substr(at + kBetween.size()), "fuzzed.pdf");
        const std::string made = with_words(svg, text);
        // Nothing but letters and small shapes may go, and what there is to end the SVG stays its end.
        if (svg.ends_with("</svg>") && !made.ends_with("</svg>")) std::abort();
        if (text.count() == 0 && made != svg) std::abort();
        is_text(text, drawn_in(svg));
    } catch (const Error& error) {
        if (error.what()[0] == '\0') std::abort();
    }
    return 0;
}
