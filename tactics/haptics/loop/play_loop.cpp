// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/loop/play_loop.h"

namespace tactics {

namespace {

constexpr double kSilent = 0.003;  // s without a word: what it felt last is no longer so
constexpr double kTold = 2;        // s until the user is notified
constexpr double kAgain = 0.2;     // s between looking for a mouse that is gone

// false: the waiting has ended. `time` is when it was unplugged.
bool is_back(const PlayLoop& loop, Clock& clock, HapticDevice& device, double time) {
    const double begin = clock.now();
    std::string why, told;
    double refused = begin;  // since
    while (!loop.ended() && !(loop.seconds && time + clock.now() - begin >= *loop.seconds)) {
        if (device.reopen(why)) return true;
        // Just after plugging in, it cannot be used until udev has processed it.
        if (why.empty())
            refused = clock.now();
        else if (clock.now() - refused >= kTold && why != told)
            loop.told(DeviceNews::refused, told = why);
        clock.wait_until(clock.now() + kAgain);
    }
    return false;
}

// One tick after the other, as long as the mouse is there and there is nothing to tell.
class Ticks {
public:
    Ticks(const PlayLoop& loop, HapticDevice& device, Playing& play) : loop_(loop), device_(device), play_(play) {}

    // false: the play ends, the user must be notified, or the mouse is gone.
    bool tick(double dt) {
        time += dt;
        const HapticDevice::State state = device_.read(sample_, dt);
        if (state == HapticDevice::State::over) return false;
        if (state == HapticDevice::State::gone) {
            gone = true;
            return false;
        }
        silent_ = state == HapticDevice::State::nothing ? silent_ + dt : 0;
        if (state == HapticDevice::State::fine) {
            if (missed_) news = DeviceNews::back;
            missed_ = away_ = false;
            heard_ = true;
        } else if (silent_ > kTold && !missed_) {
            news = DeviceNews::silent;
            missed_ = true;
        }
        return !news && push(dt);
    }

    // Gives whether its user does not know yet. A while after it was unplugged the kernel still has it, and it can be opened and
    // be gone again.
    bool lose() {
        const bool known = away_;
        missed_ = away_ = true;
        return !known;
    }

    void begin_again(double waited) {
        gone = heard_ = false;
        sample_ = {};
        silent_ = 0;
        time += waited;
        play_.begin_again(waited);
    }

    double time = 0;  // s
    bool gone = false;
    std::optional<DeviceNews> news;

private:
    bool push(double dt) {
        const bool ended = loop_.ended() || (loop_.seconds && time >= *loop_.seconds);
        // The finger's position is still unknown. A write to a mouse that accepts nothing would also block for 5 s in the kernel.
        if (!heard_) return !ended;
        if (ended) play_.stop();
        HapticSample now = sample_;
        now.fault = sample_.fault || silent_ > kSilent;
        const Point3 force = play_.tick(now, dt);
        if (!device_.push(force)) gone = true;
        return !gone && !(play_.stopped() && force == Point3{});
    }

    const PlayLoop& loop_;
    HapticDevice& device_;
    Playing& play_;
    HapticSample sample_;
    double silent_ = 0;                   // s
    bool missed_ = false, away_ = false;  // and its user knows
    bool heard_ = false;                  // since it was opened
};

}  // namespace

PlayLoopReport run_play(const PlayLoop& loop, Clock& clock, HapticDevice& device, Playing& play) {
    PlayLoopReport all;
    Ticks ticks(loop, device, play);
    for (;;) {
        const LoopReport report = run_loop(clock, loop.rate, [&](double dt) { return ticks.tick(dt); });
        all.loop.lateness.add(report.lateness);
        all.loop.long_periods += report.long_periods;
        all.loop.seconds += report.seconds;
        const double begin = clock.now();
        if (ticks.news) {
            // To tell it may take a while (a terminal that is stopped): between ticks, while no force is on.
            loop.told(*ticks.news, "");
            ticks.news.reset();
            ticks.time += clock.now() - begin;
            continue;
        }
        if (!ticks.gone) break;
        if (ticks.lose()) {
            ++all.gone;
            loop.told(DeviceNews::gone, "");
        }
        const double lost = clock.now();
        if (!is_back(loop, clock, device, ticks.time)) break;
        ticks.begin_again(clock.now() - lost);
    }
    // Now, and not when it is closed: what there is to write down may take a while, and the mouse would take that for a fault.
    device.let_go();
    return all;
}

}  // namespace tactics
