// SPDX-License-Identifier: Apache-2.0
// The first and only program of a virtual machine with a real kernel: a haptic mouse, its firmware in a process of its own, and
// on the other side our hid_mouse, its loop and its play. Prints a row for each trial; tests/bench/mouse starts it.
#include <signal.h>
#include <sys/mman.h>
#include <sys/reboot.h>
#include <sys/wait.h>

#include <algorithm>
#include <functional>
#include <vector>

#include "tactics/error.h"
#include "tactics/haptics/devices/mouse_devices.h"
#include "tactics/haptics/loop/play_loop.h"
#include "tactics/haptics/scenes/relief_scene.h"
#include "tests/bench/guest/mouse_cables.h"

namespace {

using namespace tactics;
using namespace tests;

// Counts the words that it hands on.
class Counted : public HapticDevice {
public:
    explicit Counted(std::unique_ptr<HapticDevice> mouse) : mouse_(std::move(mouse)) {}
    unsigned seen = 0, lost = 0;
    State read(HapticSample& sample, double dt) noexcept override {
        const State state = mouse_->read(sample, dt);
        if (state == State::fine) {
            seen += sample.words;
            lost += sample.lost;
        }
        return state;
    }
    bool push(const Point3& force) noexcept override { return mouse_->push(force); }
    void let_go() noexcept override { mouse_->let_go(); }
    bool reopen(std::string& why) override { return mouse_->reopen(why); }
    bool is_real() const override { return true; }

private:
    std::unique_ptr<HapticDevice> mouse_;
};

struct Outcome {
    PlayLoopReport report;
    std::string news;
    unsigned sent = 0, seen = 0, lost = 0;  // between the first time that the loop asked whether it is over and the last
    double began = 0, ended = 0;            // s
    std::size_t ticks = 0;                  // in the log
    double last_force = 0;                  // there
};

class Bench {
public:
    explicit Bench(Cable& cable, Says says = words) {
        shared = new (mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)) Shared;
        shared->says = says;
        shared->takes = says != nothing;
        std::fflush(stdout);
        firmware_ = fork();
        if (firmware_ == 0) run_firmware(cable, *shared);
        plug(true);
    }
    ~Bench() {
        plug(false);
        kill(firmware_, SIGKILL);
        waitpid(firmware_, nullptr, 0);
        munmap(shared, sizeof(Shared));
    }
    Bench(const Bench&) = delete;
    Bench& operator=(const Bench&) = delete;

    void plug(bool in) {
        shared->began = MonotonicClock(false).now() + 1.5;
        // Now and then the pretended bus fails at the first time.
        for (int time = 0; time < 3; ++time) {
            shared->plugged = in;
            while (shared->is_plugged != in) rest(5);
            if (!in || is_there("/dev/hidraw0")) break;
            shared->plugged = false;
            while (shared->is_plugged) rest(5);
        }
        rest(200);
    }

    // Until `end` answers true. It is asked every tick, and while the mouse is gone, with the seconds since the beginning.
    Outcome play(const std::function<bool(double)>& end) {
        HeightMap map{280, 40, 0.5, {}};
        for (int j = 0; j < map.rows; ++j)
            for (int i = 0; i < map.columns; ++i) map.heights.push_back(static_cast<float>(hills(i * map.pitch)));
        const ReliefSurface surface(std::move(map));
        const auto fusion = learning_fusion({});
        PlaySettings settings;
        settings.most_records = 60'000;
        ReliefScene scene(surface, {});
        Playing mouse_play(scene, fusion.get(), settings);
        Outcome outcome;
        try {
            Counted mouse(hid_mouse("", {}));
            MonotonicClock clock(true);
            outcome.began = clock.now();
            PlayLoop loop;
            bool over = false, asked = false;
            Outcome first;
            loop.ended = [&] {
                if (!asked) first.sent = shared->sent, first.seen = mouse.seen, first.lost = mouse.lost;
                asked = true;
                outcome.sent = shared->sent - first.sent;
                outcome.seen = mouse.seen - first.seen;
                outcome.lost = mouse.lost - first.lost;
                return over = over || end(clock.now() - outcome.began);
            };
            loop.told = [&](DeviceNews news, const std::string& why) {
                const char* names[] = {"gone ", "refused ", "silent ", "back "};
                outcome.news += names[static_cast<int>(news)] + why;
            };
            outcome.report = run_play(loop, clock, mouse, mouse_play);
            outcome.ended = clock.now();
        } catch (const Error& error) {
            outcome.news = error.what();
        }
        const std::vector<TickRecord> records = mouse_play.recorder().records();
        outcome.ticks = records.size();
        outcome.last_force = records.empty() ? 0 : records.back().force.z;
        return outcome;
    }

    Shared* shared = nullptr;

private:
    pid_t firmware_ = -1;
};

void tell(const std::string& what, const std::string& figures, bool good) {
    std::printf("| %s | %s | %s |\n", what.c_str(), figures.c_str(), good ? "good" : "BAD");
    std::fflush(stdout);
}

template <typename... Parts>
std::string text_of(const char* form, Parts... parts) {
    char text[300];
    std::snprintf(text, sizeof text, form, parts...);
    return text;
}

// The longest that a force was felt after the last good word may be 5 ms, the time that a force holds, and what this machine was
// late.
bool let_go_in_time(double felt, const Outcome& outcome) {
    return felt < 0.008 + 0.001 + outcome.report.loop.lateness.quantile(1);
}

// Reports and ticks that are on their way, or the one more at a beginning and an end.
constexpr double kOnTheWay = 4;
bool is_within(double is, double should_be, double by) { return std::abs(is - should_be) <= by; }

void trial_of_play(Cable& cable, const std::string& bus, double seconds) {
    Bench bench(cable);
    const Outcome outcome = bench.play([&](double time) { return time > seconds; });
    rest(20);
    const Shared& shared = *bench.shared;
    const Lateness& late = outcome.report.loop.lateness;
    tell(bus + ": played on",
         text_of("%llu ticks in %.2f s, late by %.0f/%.0f/%.0f us (50/99/99.9 %%)", static_cast<unsigned long long>(late.ticks()),
                 outcome.report.loop.seconds, late.quantile(0.5) * 1e6, late.quantile(0.99) * 1e6, late.quantile(0.999) * 1e6),
         is_within(static_cast<double>(late.ticks()), 1000 * seconds, kOnTheWay) && outcome.ticks == late.ticks() &&
             outcome.news.empty());
    tell(bus + ": reports of the mouse", text_of("%u sent, %u seen, %u lost", outcome.sent, outcome.seen, outcome.lost),
         outcome.lost == 0 && is_within(outcome.sent, 1000 * seconds, 100) && is_within(outcome.seen, outcome.sent, kOnTheWay));
    tell(bus + ": reports to the mouse",
         text_of("%u obeyed, %u not whole, %u times none for over 3 ms, at most %.2f N", shared.obeyed.load(),
                 shared.broken.load(), shared.faults.load(), shared.most_force.load()),
         shared.broken == 0 && shared.faults == 0 && shared.most_force > 0.5 && shared.most_force <= 8 &&
             is_within(shared.obeyed, static_cast<double>(late.ticks()), kOnTheWay));
    {
        const double mean = shared.sum / shared.number, rms = std::sqrt(shared.square / shared.number);
        tell(bus + ": the finger under the surface",
             text_of("%.2f mm in the mean, %.2f mm rms of the rest, %.2f mm rms; %.0f reports", -mean,
                     std::sqrt(std::max(0.0, rms * rms - mean * mean)), rms, shared.number.load()),
             shared.number > 1000 * (seconds - 3) && rms < 2.5);
    }
    tell(bus + ": at the end", shared.motor_on ? "the motor is on" : "the motor is off",
         !shared.motor_on && outcome.last_force == 0);
}

void trial_of_round_trips(Cable& cable, const std::string& bus) {
    Bench bench(cable);
    Shared& shared = *bench.shared;
    std::vector<unsigned> trips;
    double next = 1;
    const Outcome outcome = bench.play([&](double time) {
        if (time > next) {
            shared.marked = !shared.marked;
            if (!shared.marked) {
                trips.push_back(shared.after_mark);
                shared.after_mark = 0;
            }
            next = time + (shared.marked ? 0.05 : 0.5);
        }
        return trips.size() == 12;
    });
    std::sort(trips.begin(), trips.end());
    if (trips.empty()) return tell(bus + ": from a fault to no force", "no trip", false);
    tell(bus + ": from a fault to no force",
         text_of("%u reports (half of the times), %u to %u", trips[trips.size() / 2], trips.front(), trips.back()),
         trips.size() == 12 && trips.front() > 0 && trips.back() <= 5);  // 5 ms are the time that a force holds
}

// From some time on its words are none.
void trial_of_words(Cable& cable, const std::string& bus, const char* name, int says) {
    Bench bench(cable);
    Shared& shared = *bench.shared;
    double after = 0, most = 0;
    const Outcome outcome = bench.play([&](double time) {
        if (time > 1.2 && shared.says == words) {
            most = shared.most_force;
            shared.says = says;
        }
        after = std::max(0.0, shared.felt_force - shared.good_word);
        return time > 4.4;
    });
    tell(bus + ": " + name + " from some time on",
         text_of("the force is gone %.1f ms after the last word; told: ", after * 1000) + outcome.news,
         outcome.news == "silent " && most > 0.5 && let_go_in_time(after, outcome) && shared.broken == 0);
}

void trial_of_stop(Cable& cable, const std::string& bus) {
    Bench bench(cable);
    const Outcome outcome = bench.play([&](double time) {
        if (time > 1.2) bench.shared->stop_key = true;
        return time > 5;
    });
    rest(20);
    const double after = outcome.ended - outcome.began - 1.2;
    tell(bus + ": the stop key", text_of("over after %.1f ms", after * 1000),
         after < 1 && !bench.shared->motor_on && outcome.last_force == 0);
}

// Plugged in again its number may be another's by now.
void trial_of_unplugging(Cable& cable, const std::string& bus, double at, bool number_is_taken) {
    Bench bench(cable);
    Shared& shared = *bench.shared;
    Uhid other;
    int step = 0;
    double before = 0;  // the force before it, felt
    const Outcome outcome = bench.play([&](double time) {
        if (step == 0 && time > at) {
            ++step;
            before = shared.most_force;
            shared.plugged = false;
        } else if (step == 1 && time > at + 0.5) {
            ++step;
            if (number_is_taken) other.plug_keyboard();
            shared.most_force = 0;
            shared.plugged = true;
        }
        return time > at + 3.5;
    });
    if (number_is_taken) other.plug(false);
    rest(20);
    const bool good = outcome.news == "gone back " && outcome.report.gone == 1 && (at < 1 || before > 0.5) &&
                      shared.most_force > 0.5 && !shared.motor_on && outcome.last_force == 0 && shared.broken == 0;
    tell(bus + text_of(": unplugged after %.3f s, back%s", at, number_is_taken ? " under another number" : ""),
         text_of("told: %s; %zu ticks in the log; at most %.2f N, then %.2f N", outcome.news.c_str(), outcome.ticks, before,
                 shared.most_force.load()),
         good);
}

// It never says a word, and takes none.
void trial_of_muteness(Cable& cable, const std::string& bus) {
    Bench bench(cable, nothing);
    const Outcome outcome = bench.play([&](double time) { return time > 3; });  // Ctrl-C
    bench.shared->takes = true;
    rest(20);
    tell(bus + ": never says a word, Ctrl-C at 3 s",
         text_of("over at %.2f s; told: ", outcome.ended - outcome.began) + outcome.news,
         outcome.news == "silent " && outcome.ended - outcome.began < 3.1 && bench.shared->obeyed == 0);
}

// A mouse that takes no reports: the kernel waits for it, and the wait cannot be interrupted.
void trial_of_deafness(Cable& cable, const std::string& bus) {
    Bench bench(cable);
    const Outcome outcome = bench.play([&](double time) {
        if (time > 1) bench.shared->takes = false;
        return time > 3;  // Ctrl-C
    });
    const double end = outcome.ended - outcome.began;
    tell(bus + ": takes no reports from 1 s on, Ctrl-C at 3 s", text_of("over at %.2f s; told: ", end) + outcome.news,
         bus == "usb" ? end < 9 && outcome.news == "gone " : end < 3.1 && outcome.news.empty());
}

void trials_on(Cable& cable, const std::string& bus) {
    trial_of_play(cable, bus, 8);
    trial_of_stop(cable, bus);
    trial_of_round_trips(cable, bus);
    trial_of_words(cable, bus, "silent", nothing);
    trial_of_words(cable, bus, "short reports", brief);
    trial_of_words(cable, bus, "of another kind", magic);
    trial_of_words(cable, bus, "damaged", sum);
    trial_of_words(cable, bus, "noise", noise);
    trial_of_muteness(cable, bus);
    for (const double at : {0.005, 0.31, 1.0007, 1.7773}) trial_of_unplugging(cable, bus, at, false);
    trial_of_unplugging(cable, bus, 1.3, true);
    trial_of_deafness(cable, bus);
}

}  // namespace

int main() {
    set_up_guest();
    std::printf("| trial | | |\n|---|---|---|\n");
    Uhid uhid;
    trials_on(uhid, "uhid");
    Gadget gadget;
    trials_on(gadget, "usb");
    std::printf("END\n");
    std::fflush(stdout);
    reboot(RB_POWER_OFF);
}
