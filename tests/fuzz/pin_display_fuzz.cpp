// SPDX-License-Identifier: Apache-2.0
// Any bytes as what a display of pins answers: the first byte says which display hears them. Each answer is taken off, and a size
// that is taken is one that a page can be laid out for.
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "print/embosser.h"
#include "print/format.h"
#include "print/pin_display.h"
#include "tactics/error.h"

namespace {

std::vector<const tactics::Format*> displays() {
    std::vector<const tactics::Format*> found;
    for (const tactics::Format* format : tactics::formats())
        if (format->embosser != nullptr && format->embosser->display != nullptr) found.push_back(format);
    return found;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace tactics;
    static const std::vector<const Format*> all = displays();
    if (size == 0) return 0;
    const Format& format = *all[data[0] % all.size()];
    const PinDisplay& display = *format.embosser->display;
    const std::string bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
    if (!bytes.empty() && display.message) {
        const std::size_t length = display.message(bytes);
        if (length == 0 || length > bytes.size()) std::abort();
        if (display.row && display.row(std::string_view(bytes).substr(0, length)) > 255) std::abort();
    }
    Settings settings(format.options);
    std::string heard = bytes;
    try {
        for (std::size_t before = heard.size(); const auto answer = display.next(heard, settings); before = heard.size()) {
            if (heard.size() >= before) std::abort();
            if (answer->kind != PinAnswer::Kind::told || !format.dots) continue;
            const DotSetting set = format.dots(settings);
            if (set.title_cells < 0) std::abort();
        }
    } catch (const Error& error) {
        if (error.what()[0] == '\0') std::abort();
    }
    return 0;
}
