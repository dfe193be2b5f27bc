// SPDX-License-Identifier: Apache-2.0
// Parameters of a haptic mouse: read, or refused; what is read is written and read again as the same.
#include <cstdlib>
#include <string_view>

#include "tactics/error.h"
#include "tactics/haptics/simulated/lever_file.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    using namespace tactics;
    MouseSettings mouse;
    try {
        mouse = read_mouse({reinterpret_cast<const char*>(data), size}, "mouse.txt");
    } catch (const Error&) {
        return 0;
    }
    const std::string text = to_text(mouse);
    if (to_text(read_mouse(text, "mouse.txt")) != text) std::abort();
    return 0;
}
