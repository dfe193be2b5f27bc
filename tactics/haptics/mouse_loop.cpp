#include "tactics/haptics/mouse_loop.h"

#include <chrono>
#include <thread>

namespace tactics {

MouseLoopReport run_mouse(const MouseLoop& loop, Clock& clock, MouseDevice& device, MousePlay& play) {
    constexpr double kSilent = 0.003;  // s without a word: what it felt last is no longer so
    constexpr std::chrono::milliseconds kAgain{200};
    MouseLoopReport all;
    MouseSample sample;
    double time = 0, silent = 0;
    for (bool gone = true; gone;) {
        gone = false;
        const LoopReport report = run_loop(clock, loop.rate, [&](double dt) {
            time += dt;
            const MouseDevice::State state = device.read(sample, dt);
            if (state == MouseDevice::State::over) return false;
            if (state == MouseDevice::State::gone) {
                gone = true;
                return false;
            }
            silent = state == MouseDevice::State::nothing ? silent + dt : 0;
            if (silent > kSilent) sample.fault = true;
            if (loop.ended() || (loop.seconds && time >= *loop.seconds)) play.stop();
            const double force = play.tick(sample, dt);
            if (!device.push(force)) gone = true;
            return !gone && !(play.stopped() && force == 0);
        });
        all.loop.lateness.add(report.lateness);
        all.loop.long_periods += report.long_periods;
        all.loop.seconds += report.seconds;
        if (!gone) break;
        ++all.gone;
        loop.told(false);
        while (!loop.ended() && !device.reopen()) std::this_thread::sleep_for(kAgain);
        gone = !loop.ended();
        if (gone) loop.told(true);
    }
    return all;
}

}  // namespace tactics
