// SPDX-License-Identifier: Apache-2.0
// Any bytes as braille text for any embosser: the first byte says for which, the second on which sheet. What is not refused comes
// out of the machine dot by dot.
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "print/embosser.h"
#include "print/machines/sheet_feed.h"
#include "print/text_pages.h"
#include "tactics/error.h"

namespace {

using namespace tactics;

const Format& machine_of(std::size_t number) {
    for (;;)
        for (const Format* format : formats())
            if (format->embosser != nullptr && format->embosser->display == nullptr && number-- == 0) return *format;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size < 2) return 0;
    const Format& machine = machine_of(data[0]);
    const double side = data[1];
    const Paper paper{"", "", 100 + side, 150 + side};
    const std::string_view text(reinterpret_cast<const char*>(data) + 2, size - 2);
    const Settings settings(machine.options);
    try {
        const Punched punched = machine.embosser->punch(text_for(text, machine, settings, paper, "fuzzed.brf"), settings);
        if (!punched.notes.empty()) std::abort();
        std::size_t wanted = 0, found = 0;
        for (const char letter : text)
            wanted += static_cast<std::size_t>(std::popcount(cell_of_letter(static_cast<unsigned char>(letter)).value_or(0)));
        for (const PunchedSheet& sheet : punched.sheets) {
            found += sheet.dots.size();
            for (const Point& dot : sheet.dots)
                if (!(dot.x > 0 && dot.x < paper.width && dot.y > 0 && dot.y < paper.height)) std::abort();
        }
        if (found != wanted) std::abort();
    } catch (const Error& error) {
        if (error.what()[0] == '\0') std::abort();
    }
    return 0;
}
