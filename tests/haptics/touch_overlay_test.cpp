// SPDX-License-Identifier: Apache-2.0
// An overlay on a map: mm, which contact is the finger, what comes and goes, and no memory in a tick.
#include "tactics/haptics/sensing/touch_overlay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <deque>
#include <mutex>
#include <thread>

#include "tactics/error.h"
#include "tactics/haptics/loop/play.h"
#include "tactics/haptics/scenes/relief_scene.h"
#include "tactics/haptics/simulated/pointing.h"
#include "tests/haptics/allocations.h"

namespace tactics::touch_overlay_test {
namespace {

struct Seen {
    double time;
    std::vector<TouchContact> contacts;
};

class PretendedTouch : public TouchDevice {
public:
    PretendedTouch(TouchAxis x, TouchAxis y, std::deque<Seen>* frames) : x_(x), y_(y), frames_(frames) {}
    TouchAxis x() const override { return x_; }
    TouchAxis y() const override { return y_; }
    State read(TouchFrame& frame) noexcept override {
        if (next_ == frames_->size()) return State::nothing;
        const Seen& seen = (*frames_)[next_++];
        if (seen.time < 0) return State::gone;
        if (seen.contacts.empty() && seen.time == 0) return State::nothing;
        frame = {seen.time, seen.contacts};
        return State::frame;
    }

private:
    TouchAxis x_, y_;
    std::deque<Seen>* frames_;
    std::size_t next_ = 0;
};

double now = 0;
double pretended_now() noexcept { return now; }

std::unique_ptr<Overlay> overlay_of(std::deque<Seen>& frames, TouchAxis x, TouchAxis y, const OverlayPlace& place) {
    return touch_overlay(std::make_unique<PretendedTouch>(x, y, &frames), place, "event0", pretended_now);
}

// One unit a mm from (0, 0).
constexpr TouchAxis kWide{0, 1000, 1}, kHigh{0, 500, 1};

// The report of each single frame; an empty place is (-1, -1).
std::vector<Point> places_of(const std::vector<Seen>& all) {
    std::deque<Seen> frames;
    const auto overlay = overlay_of(frames, kWide, kHigh, {});
    std::vector<Point> places;
    for (const Seen& seen : all) {
        frames.push_back(seen);
        OverlaySample sample;
        places.push_back(overlay->read(sample) == Overlay::State::sample ? sample.at : Point{-1, -1});
    }
    return places;
}

void expect_at(Point place, double x, double y) {
    EXPECT_NEAR(place.x, x, 1e-9);
    EXPECT_NEAR(place.y, y, 1e-9);
}

TEST(TouchOverlay, TellsMillimetresFromTheCornerOfTheMap) {
    std::deque<Seen> frames{{1, {{1100, 300, 1}}}, {2, {{2100, 700, 1}}}};
    OverlaySample sample;
    // By its resolution.
    auto overlay = overlay_of(frames, {100, 8100, 10}, {200, 4200, 20}, {});
    ASSERT_EQ(overlay->read(sample), Overlay::State::sample);
    EXPECT_EQ(sample.time, 2);
    expect_at(sample.at, 200, 25);
    EXPECT_EQ(overlay->read(sample), Overlay::State::nothing);
    // By the size of the field, which is believed before the resolution, with a map 50 mm to the right and 30 mm down.
    overlay = overlay_of(frames, {100, 8100, 10}, {200, 4200, 0}, {400, 200, {50, 30}});
    ASSERT_EQ(overlay->read(sample), Overlay::State::sample);
    expect_at(sample.at, 50, -5);
}

TEST(TouchOverlay, SizesThatAreMissingOrCannotBe) {
    std::deque<Seen> frames;
    const auto message = [&](TouchAxis x, TouchAxis y) -> std::string {
        try {
            overlay_of(frames, x, y, {});
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    };
    const std::string mend = "; measure the field that it sees, and give its width and height: --overlay-size 600x340mm";
    EXPECT_EQ(message({0, 32767, 0}, {0, 32767, 0}), "event0: the overlay does not tell how large it is" + mend);
    EXPECT_EQ(message({0, 32767, 55}, {0, 32767, 0}), "event0: the overlay does not tell how large it is" + mend);
    EXPECT_EQ(message({0, 32767, 1}, {0, 32767, 96}),
              "event0: the overlay says that one of its sides is 32767 mm, which cannot be" + mend);
    EXPECT_EQ(message({-2147483647, 2147483647, 4294967}, {0, 32767, 96}), "");
    EXPECT_NO_THROW(overlay_of(frames, {0, 32767, 0}, {0, 32767, 0}, {600, 340, {}}));
}

TEST(TouchOverlay, TheFingerIsTheContactNearestToWhereItWas) {
    const auto places = places_of({{1.00, {{100, 100, 1}}},
                                   {1.02, {{300, 100, 2}, {104, 100, 1}}},  // a palm comes down
                                   {1.04, {{104, 104, 2}, {300, 104, 1}}},  // they change slots
                                   {1.06, {{300, 104, 1}}},  // the finger is lost; the palm is too far away to be it
                                   {1.08, {{300, 104, 1}, {110, 104, 3}}},  // it is back
                                   {2.50, {{300, 104, 1}}}});               // since then it may be anywhere
    expect_at(places[0], 100, 100);
    expect_at(places[1], 104, 100);
    expect_at(places[2], 104, 104);
    expect_at(places[3], -1, -1);
    expect_at(places[4], 110, 104);
    expect_at(places[5], 300, 104);
}

TEST(TouchOverlay, WhereItWasNowhereTheNewestIsIt) {
    const auto places =
        places_of({{1.0, {{10, 10, 4}, {500, 20, 6}, {40, 40, 5}}}, {1.1, {}}, {1.2, {{10, 10, 8}, {500, 20, 7}}}});
    expect_at(places[0], 500, 20);
    expect_at(places[1], -1, -1);
    expect_at(places[2], 10, 10);
}

// A mouse that rests, and tells nothing but the number of the tick.
class Resting : public HapticDevice {
public:
    State read(HapticSample& sample, double) noexcept override {
        sample.moved.time = ++ticks_;
        sample.height = 3;
        return ticks_ % 2 == 0 ? State::nothing : State::fine;
    }
    bool push(const Point3& force) noexcept override { return force.z == 2; }
    bool reopen(std::string& why) override {
        why.clear();
        return true;
    }
    bool is_real() const override { return true; }

private:
    int ticks_ = 0;
};

TEST(MouseWithOverlay, IsTheMouseAndTheOverlay) {
    std::deque<Seen> frames{{1, {{100, 50, 1}}}};
    const auto mouse = mouse_with_overlay(
        std::make_unique<Resting>(), [&] { return overlay_of(frames, kWide, kHigh, {}); }, [](bool) { FAIL(); });
    HapticSample sample;
    EXPECT_EQ(mouse->read(sample, 0.001), HapticDevice::State::fine);
    EXPECT_EQ(sample.height, 3);
    ASSERT_TRUE(sample.has_overlay);
    expect_at(sample.overlay.at, 100, 50);
    EXPECT_EQ(mouse->read(sample, 0.001), HapticDevice::State::nothing);
    EXPECT_FALSE(sample.has_overlay);  // not told twice
    EXPECT_TRUE(mouse->push({0, 0, 2}));
    EXPECT_FALSE(mouse->push({0, 0, 1}));
    std::string why;
    EXPECT_TRUE(mouse->reopen(why));
    EXPECT_TRUE(mouse->is_real());
}

TEST(MouseWithOverlay, WhatIsNotThereFirstIsAnError) {
    const auto open = []() -> std::unique_ptr<Overlay> { throw Error(Fault::failed, "event0", "there is no such device"); };
    EXPECT_THROW(mouse_with_overlay(std::make_unique<Resting>(), open, [](bool) {}), Error);
}

// It goes twice; each time opening fails twice before it is back. The mouse goes on all the time.
TEST(MouseWithOverlay, GoesOnWithoutAndIsToldOnceEachTime) {
    std::deque<Seen> frames{{1, {{100, 50, 1}}}, {0, {}}, {-1, {}}};
    std::mutex guard;
    std::string story;
    int opened = 0;
    const auto open = [&]() -> std::unique_ptr<Overlay> {
        const std::lock_guard lock(guard);
        if (opened++ % 3 != 0) throw Error(Fault::failed, "event0", "not yet");
        return overlay_of(frames, kWide, kHigh, {});
    };
    const auto told = [&](bool there) {
        const std::lock_guard lock(guard);
        story += there ? "back " : "gone ";
    };
    const auto story_now = [&] {
        const std::lock_guard lock(guard);
        return story;
    };
    const auto mouse = mouse_with_overlay(std::make_unique<Resting>(), open, told);
    HapticSample sample;
    int samples = 0;
    const auto until = [&](const std::string& wished) {
        for (int i = 0; i < 10'000 && story_now() != wished; ++i) {
            EXPECT_NE(mouse->read(sample, 0.001), HapticDevice::State::gone);
            samples += sample.has_overlay ? 1 : 0;
            std::this_thread::sleep_for(std::chrono::milliseconds{1});
        }
        EXPECT_EQ(story_now(), wished);
    };
    until("gone back gone ");
    EXPECT_EQ(samples, 2);  // one from each that was there
}

TEST(MouseWithOverlay, ATickTakesNoMemory) {
    if (!tests::counts_allocations()) GTEST_SKIP() << "sanitizers count for themselves";
    std::deque<Seen> frames;
    for (int i = 0; i < 500; ++i) frames.push_back({i * 0.01, {{100 + i / 10, 50, 1}, {400, 50, 2}}});
    frames.push_back({-1, {}});
    const auto mouse = mouse_with_overlay(
        std::make_unique<Resting>(), [&] { return overlay_of(frames, kWide, kHigh, {}); }, [](bool) {});
    HapticSample sample;
    const std::size_t before = tests::allocations();
    while (mouse->read(sample, 0.001), sample.has_overlay) {
    }
    EXPECT_EQ(tests::allocations(), before);
}

TEST(TouchOverlay, OfAFingerThatRestsItIsToldAgainWhereItIs) {
    std::deque<Seen> frames{{5, {{100, 50, 1}}}};
    const auto overlay = overlay_of(frames, kWide, kHigh, {});
    OverlaySample sample;
    std::string story;
    const auto read = [&](double time) {
        now = time;
        const bool told = overlay->read(sample) == Overlay::State::sample;
        story += told ? "told " : "nothing ";
        return told ? sample.time : 0;
    };
    EXPECT_EQ(read(5.001), 5);
    read(5.05);
    EXPECT_EQ(read(5.11), 5.11);
    read(5.15);
    EXPECT_EQ(read(5.22), 5.22);
    expect_at(sample.at, 100, 50);
    frames.push_back({5.3, {{400, 50, 2}}});  // only a palm is left, too far away to be it
    read(5.35);
    read(5.55);
    frames.push_back({5.6, {}});
    read(5.75);
    EXPECT_EQ(story, "told nothing told nothing told nothing nothing nothing ");
    now = 0;
}

TEST(TouchOverlay, AContactThatJumpsIsStillThatContact) {
    const auto places = places_of({{1.0, {{100, 100, 1}}}, {1.001, {{400, 100, 1}}}});
    expect_at(places[1], 400, 100);
}

// The kernel passes over what has not changed: of a finger that rests it is told seldom.
TEST(TouchOverlay, WhatIsNotToldOfARestingFingerIsNotMissed) {
    constexpr MouseGeometry kMouse{60, {10, -80}};
    PointingCauses causes;
    causes.scale = 1.04;
    causes.delay = 0.13;
    causes.acceleration = 1.4;
    const Pointing pointing = straight_strokes(16, 250, 2500, 9);
    Sensed all = sense(pointing, kMouse, causes, 9);
    for (OverlaySample& sample : all.samples) sample.at = {std::round(10 * sample.at.x) / 10, std::round(10 * sample.at.y) / 10};
    Sensed changed = all;
    changed.samples.erase(std::unique(changed.samples.begin(), changed.samples.end(),
                                      [](const OverlaySample& a, const OverlaySample& b) {
                                          return distance(a.at, b.at) < 1e-9 && b.time < a.time + 0.1;
                                      }),
                          changed.samples.end());
    ASSERT_LT(changed.samples.size(), 0.8 * static_cast<double>(all.samples.size()));
    const PointingError whole = pointing_error(*learning_fusion(kMouse), pointing, all, 4),
                        part = pointing_error(*learning_fusion(kMouse), pointing, changed, 4);
    EXPECT_LT(part.rms, whole.rms + 0.1) << whole.rms;
    EXPECT_LT(part.overshoot, whole.overshoot + 0.1) << whole.overshoot;
    EXPECT_EQ(part.resets, 0u);
}

// Without a word of an overlay the finger begins where it is told to; with one it is where that says.
TEST(Playing, BeginsWhereItIsToldTo) {
    const ReliefSurface surface(HeightMap{4, 4, 1, std::vector<float>(16, 1.0F)});
    for (const bool learning : {false, true}) {
        const auto fusion = learning ? learning_fusion({}) : paper_fusion({});
        PlaySettings settings;
        settings.begin = {40, 30};
        ReliefScene scene(surface, {});
        Playing play(scene, fusion.get(), settings);
        HapticSample sample;
        for (int i = 1; i <= 10; ++i) {
            sample.moved = {i * 0.001, {0.1, 0}, {0.1, 0}};
            play.tick(sample, 0.001);
        }
        expect_at(play.recorder().records().back().at, 41, 30);
        sample.has_overlay = true;
        sample.overlay = {0.011, {7, 8}};
        sample.moved = {0.011, {}, {}};
        play.tick(sample, 0.001);
        sample.has_overlay = false;
        sample.moved = {0.012, {}, {}};
        play.tick(sample, 0.001);
        EXPECT_LT(distance(play.recorder().records().back().at, {8, 8}), 1.1) << learning;
    }
}

}  // namespace
}  // namespace tactics::touch_overlay_test
