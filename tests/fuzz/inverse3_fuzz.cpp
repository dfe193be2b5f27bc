// SPDX-License-Identifier: Apache-2.0
// Any bytes as a message of an Inverse Service are ignored, or give a possible position of an arm; the answer is again a message.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "tactics/haptics/devices/inverse3_messages.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace tactics;
    const std::string_view message(reinterpret_cast<const char*>(data), size);
    const auto ids = inverse3_ids(message);
    if (inverse3_word(message, "049D") && !ids) std::abort();
    if (!ids) return 0;
    for (const std::string& id : *ids) {
        if (id.empty() || id.size() > 64 || id.find_first_of("\"\\{}") != std::string::npos) std::abort();
        const auto word = inverse3_word(message, id);
        if (!word) continue;
        for (const double mm : {word->place.x, word->place.y, word->place.z})
            if (!(std::abs(mm) <= 1000)) std::abort();
        const auto named = inverse3_ids(inverse3_request(id, 0.001 * word->place, false));
        if (!named || named->size() != 1 || named->front() != id) std::abort();
    }
    return 0;
}
