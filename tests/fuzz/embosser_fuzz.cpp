// SPDX-License-Identifier: Apache-2.0
// Any bytes sent to any embosser: the first byte says to which. What comes out can be drawn and written as Unicode braille.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "print/embosser.h"
#include "print/format.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace tactics;
    if (size == 0) return 0;
    std::size_t number = data[0];
    const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
    const Format* machine = nullptr;
    while (machine == nullptr)
        for (const Format* format : formats())
            if (format->embosser != nullptr && number-- == 0) {
                machine = format;
                break;
            }
    const Punched punched = machine->embosser->punch(bytes, Settings(machine->options));
    if (punched.sheets.empty() || punched.sheets.size() > bytes.size() + 1) std::abort();
    std::size_t end = 0;
    for (const PunchedSheet& sheet : punched.sheets) {
        if (sheet.begin > sheet.end || sheet.begin < end || sheet.end > bytes.size()) std::abort();
        end = sheet.end;
        for (const Point& dot : sheet.dots)
            if (!std::isfinite(dot.x) || !std::isfinite(dot.y)) std::abort();
        unicode_of(sheet, 2.5);
        if (sheet.dots.size() < 1000)
            find_format("svg")->encode(page_of(sheet, 210, 297, 1.6), Settings(find_format("svg")->options));
    }
    return 0;
}
