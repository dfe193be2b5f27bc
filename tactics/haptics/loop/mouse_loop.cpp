// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/loop/mouse_loop.h"

namespace tactics {

namespace {

constexpr double kSilent = 0.003;  // s without a word: what it felt last is no longer so
constexpr double kTold = 2;        // s until somebody wants to know
constexpr double kAgain = 0.2;     // s between looking for a mouse that is gone

// false: nobody waits for it any more. `time` is when it went.
bool is_back(const MouseLoop& loop, Clock& clock, MouseDevice& device, double time) {
    const double begin = clock.now();
    std::string why, told;
    double refused = begin;  // since
    while (!loop.ended() && !(loop.seconds && time + clock.now() - begin >= *loop.seconds)) {
        if (device.reopen(why)) return true;
        // Just after it was plugged in nobody may use it until udev has come to it.
        if (why.empty())
            refused = clock.now();
        else if (clock.now() - refused >= kTold && why != told)
            loop.told(MouseNews::refused, told = why);
        clock.wait_until(clock.now() + kAgain);
    }
    return false;
}

}  // namespace

MouseLoopReport run_mouse(const MouseLoop& loop, Clock& clock, MouseDevice& device, MousePlay& play) {
    MouseLoopReport all;
    MouseSample sample;
    double time = 0, silent = 0;
    bool missed = false, away = false;  // and its user knows
    bool heard = false;                 // since it was opened
    for (;;) {
        bool gone = false;
        // To tell it may take a while (a terminal that is stopped): between ticks, while no force is on.
        std::optional<MouseNews> news;
        const LoopReport report = run_loop(clock, loop.rate, [&](double dt) {
            time += dt;
            const MouseDevice::State state = device.read(sample, dt);
            if (state == MouseDevice::State::over) return false;
            if (state == MouseDevice::State::gone) {
                gone = true;
                return false;
            }
            silent = state == MouseDevice::State::nothing ? silent + dt : 0;
            if (state == MouseDevice::State::fine) {
                if (missed) news = MouseNews::back;
                missed = away = false;
                heard = true;
            } else if (silent > kTold && !missed) {
                news = MouseNews::silent;
                missed = true;
            }
            if (news) return false;
            const bool ended = loop.ended() || (loop.seconds && time >= *loop.seconds);
            // Where the finger is nobody has said yet. And for a mouse that takes nothing a write would wait 5 s in the kernel.
            if (!heard) return !ended;
            if (ended) play.stop();
            MouseSample now = sample;
            now.fault = sample.fault || silent > kSilent;
            const double force = play.tick(now, dt);
            if (!device.push(force)) gone = true;
            return !gone && !(play.stopped() && force == 0);
        });
        all.loop.lateness.add(report.lateness);
        all.loop.long_periods += report.long_periods;
        all.loop.seconds += report.seconds;
        if (news) {
            const double begin = clock.now();
            loop.told(*news, "");
            time += clock.now() - begin;
            continue;
        }
        if (!gone) break;
        // A while after it was unplugged the kernel still has it, and it can be opened and be gone again.
        if (!away) {
            ++all.gone;
            loop.told(MouseNews::gone, "");
        }
        missed = away = true;
        const double begin = clock.now();
        if (!is_back(loop, clock, device, time)) break;
        sample = {};
        silent = 0;
        heard = false;
        time += clock.now() - begin;
        play.begin_again(clock.now() - begin);
    }
    // Now, and not when it is closed: what there is to write down may take a while, and the mouse would take that for a fault.
    device.let_go();
    return all;
}

}  // namespace tactics
