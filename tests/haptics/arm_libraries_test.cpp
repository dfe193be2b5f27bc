// SPDX-License-Identifier: Apache-2.0
// Arms by the libraries of their makers, which are not ours to have: by libraries of our own with the same names in them.
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <limits>
#include <thread>

#include "tactics/error.h"
#include "tactics/haptics/devices/arm_devices.h"

namespace tactics::arm_libraries_test {
namespace {

using State = HapticDevice::State;
using Open = std::unique_ptr<HapticDevice> (*)(const std::string& library);

std::string why_not(Open open, const std::string& library) {
    try {
        open(library);
    } catch (const Error& error) {
        return error.what();
    }
    return "opened";
}

class Fake {
public:
    explicit Fake(const std::string& path) : handle_(dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL)) {
        if (handle_ == nullptr) ADD_FAILURE() << dlerror();
    }
    template <typename Function>
    Function* find(const char* name) const {
        return reinterpret_cast<Function*>(dlsym(handle_, name));
    }
    void put(double x, double y, double z, unsigned buttons) const {
        find<void(double, double, double, unsigned)>("fake_put")(x, y, z, buttons);
    }
    void unplug(bool unplugged) const { find<void(int)>("fake_unplug")(unplugged ? 1 : 0); }
    int number(const char* name) const { return find<int()>(name)(); }
    struct Told {
        Point3 force;
        double most = 0;
    };
    Told told() const {
        double values[4] = {};
        find<void(double*)>("fake_told")(values);
        return {{values[0], values[1], values[2]}, values[3]};
    }

private:
    void* handle_;
};

State ticks(HapticDevice& device, HapticSample& sample, const Point3& force, const std::function<bool()>& over) {
    State state = State::nothing;
    for (int i = 0; i < 10'000 && !over(); ++i) {
        state = device.read(sample, 0.001);
        if (state == State::gone || !device.push(force)) return State::gone;
        std::this_thread::sleep_for(std::chrono::milliseconds{1});
    }
    return state;
}

// What holds of both. `place` is what the library says for 10 mm to the right, 20 upwards and 30 towards the person; `pushed`
// what it is told for (1, 2, 3) N in these directions.
void is_an_arm(Open open, const std::string& path, const Point3& place, const Point3& pushed) {
    const Fake fake(path);
    fake.put(place.x, place.y, place.z, 5);
    HapticSample sample;
    {
        const auto device = open(path);
        EXPECT_TRUE(device->is_real());
        EXPECT_EQ(fake.number("fake_is_on"), 1);
        ticks(*device, sample, {1, 2, 3}, [&] { return sample.knows_place && fake.told().force == pushed; });
        EXPECT_NEAR(sample.place.x, 10, 1e-9);
        EXPECT_NEAR(sample.place.y, 20, 1e-9);
        EXPECT_NEAR(sample.height, 30, 1e-9);
        EXPECT_EQ(sample.keys, 5u);
        EXPECT_EQ(fake.told().force, pushed);
        const double none = std::numeric_limits<double>::quiet_NaN();
        for (const Point3 wild : {Point3{1e9, 0, 0}, {0, -1e5, 0}, {none, 1, 1}})
            ticks(*device, sample, wild, [n = 0]() mutable { return ++n > 30; });
        EXPECT_LE(fake.told().most, 8 * (1 + 1e-12));
        // A loop that hangs is let go of.
        const int then = fake.number("fake_pushes");
        for (int i = 0; i < 1000 && fake.number("fake_pushes") < then + 100; ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds{1});
        EXPECT_EQ(fake.told().force, Point3{});
        ticks(*device, sample, {0, 0, 1}, [&] { return !(fake.told().force == Point3{}); });
        device->let_go();
        EXPECT_EQ(fake.told().force, Point3{});
        device->push({0, 0, 1});
        std::this_thread::sleep_for(std::chrono::milliseconds{10});
        EXPECT_EQ(fake.told().force, Point3{});
    }
    EXPECT_EQ(fake.number("fake_opened"), 0);
    const auto device = open(path);
    ticks(*device, sample, {0, 1, 0}, [&] { return !(fake.told().force == Point3{}); });
    fake.unplug(true);
    EXPECT_EQ(ticks(*device, sample, {0, 1, 0}, [] { return false; }), State::gone);
    std::string why = "?";
    EXPECT_FALSE(device->reopen(why));
    EXPECT_EQ(why, "");
    EXPECT_NE(why_not(open, path).find("no device is there ("), std::string::npos) << why_not(open, path);
    fake.unplug(false);
    EXPECT_TRUE(device->reopen(why));
    sample = {};
    EXPECT_EQ(ticks(*device, sample, {}, [&] { return sample.words > 0; }), State::fine);
    // A place that cannot be is no word.
    fake.put(std::numeric_limits<double>::quiet_NaN(), 0, 0, 0);
    ticks(*device, sample, {}, [n = 0]() mutable { return ++n > 30; });
    EXPECT_EQ(device->read(sample, 0.001), State::nothing);
    EXPECT_NEAR(sample.place.x, 10, 1e-9);
}

TEST(ArmLibrariesThreads, ForceDimensionsArmIsAnArm) {
    // Theirs: x towards the person, y to the right, z up, in m.
    is_an_arm(force_dimension_arm, TACTICS_FAKE_DHD, {0.03, 0.01, 0.02}, {3, 1, 2});
}

TEST(ArmLibrariesThreads, AnArmOfOpenHapticsIsAnArm) {
    is_an_arm(openhaptics_arm, TACTICS_FAKE_HD, {10, 20, 30}, {1, 2, 3});
    EXPECT_EQ(Fake(TACTICS_FAKE_HD).number("fake_misuses"), 0);
}

TEST(ArmLibrariesThreads, WarmMotorsAreAFaultAndNotTheEnd) {
    const Fake fake(TACTICS_FAKE_HD);
    fake.put(1, 2, 3, 0);
    const auto device = openhaptics_arm(TACTICS_FAKE_HD);
    HapticSample sample;
    ticks(*device, sample, {0, 1, 0}, [&] { return sample.knows_place; });
    EXPECT_FALSE(sample.fault);
    fake.find<void(int)>("fake_heat")(1);
    ticks(*device, sample, {0, 1, 0}, [&] { return sample.fault && fake.told().force == Point3{}; });
    EXPECT_TRUE(sample.fault);
    EXPECT_EQ(fake.told().force, Point3{});
    fake.find<void(int)>("fake_heat")(0);
    EXPECT_EQ(ticks(*device, sample, {0, 1, 0}, [&] { return !sample.fault; }), State::fine);
    EXPECT_FALSE(sample.fault);
}

TEST(ArmLibrariesThreads, WhatIsMissingSaysWhereToGetIt) {
    const std::string none = "/nowhere/lib.so", other = "libdl.so.2";
    EXPECT_NE(why_not(force_dimension_arm, none).find("dhd: the library of Force Dimension is not there; get their SDK at"),
              std::string::npos);
    EXPECT_NE(why_not(force_dimension_arm, other).find("the library has no dhdOpen"), std::string::npos);
    EXPECT_NE(why_not(openhaptics_arm, none).find("the library of OpenHaptics is not there; get it and the driver"),
              std::string::npos);
    EXPECT_NE(why_not(openhaptics_arm, other).find("the library has no hdInitDevice"), std::string::npos);
}

}  // namespace
}  // namespace tactics::arm_libraries_test
