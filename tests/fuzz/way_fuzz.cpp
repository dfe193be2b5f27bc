// SPDX-License-Identifier: Apache-2.0
// Any bytes as the recorded way of a hand: refused with one line, or played to its end at places that are finite.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "tactics/error.h"
#include "tactics/haptics/devices/mouse_devices.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace tactics;
    try {
        const auto mouse = recorded_mouse({reinterpret_cast<const char*>(data), size}, "way.csv", {}, {}, 0);
        for (int tick = 0; tick < 100; ++tick) {
            HapticSample sample;
            if (mouse->read(sample, tick == 0 ? 0 : 0.001 * tick) != HapticDevice::State::fine) break;
            if (!std::isfinite(sample.place.x) || !std::isfinite(sample.place.y) || !std::isfinite(sample.height)) std::abort();
            mouse->push({0, 0, 0.5});
        }
    } catch (const Error& error) {
        if (error.what()[0] == '\0') std::abort();
    }
    return 0;
}
