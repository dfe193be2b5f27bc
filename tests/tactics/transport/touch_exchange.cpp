// SPDX-License-Identifier: Apache-2.0
// Prints what a touch device tells until it is gone, or what is wrong with it.
#include <chrono>
#include <cstdio>
#include <thread>

#include "tactics/error.h"
#include "tactics/transport/touch_device.h"

int main(int count, char** words) {
    using namespace tactics;
    if (count != 2) return 1;
    try {
        const auto device = open_touch_device(words[1]);
        for (const TouchAxis axis : {device->x(), device->y()})
            std::printf("%d to %d, %g a mm\n", axis.least, axis.most, axis.per_mm);
        for (;;) {
            TouchFrame frame;
            const TouchDevice::State state = device->read(frame);
            if (state == TouchDevice::State::gone) break;
            if (state == TouchDevice::State::nothing) {
                std::this_thread::sleep_for(std::chrono::milliseconds{1});
                continue;
            }
            const double now = std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
            if (now - frame.time < 5)
                std::printf("now:");
            else
                std::printf("%.3f:", frame.time);
            for (const TouchContact& contact : frame.contacts) std::printf(" %d,%d", contact.x, contact.y);
            std::printf("\n");
        }
        std::printf("gone\n");
        return 0;
    } catch (const Error& error) {
        std::printf("%s\n", error.what());
        return 2;
    }
}
