// SPDX-License-Identifier: Apache-2.0
#include "tactics/coding/recording.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tactics/coding/bytes.h"
#include "tactics/coding/device_filter.h"
#include "tactics/error.h"
#include "tactics/point3.h"

namespace tactics::tests::recording_test {
namespace {

// A finger that goes about, and what pushes it: a stiff ground with waves and noise, nothing in the air, sometimes a blow.
Recording motion(unsigned seed, std::size_t ticks, bool spatial = true) {
    Recording recording{1e-4, 1e-4, true, spatial};
    std::mt19937 random(seed);
    std::normal_distribution<double> noise;
    double x = 0, y = 0, pace_x = 0, pace_y = 0;
    std::int64_t time = 5'000'000;
    for (std::size_t i = 0; i < ticks; ++i) {
        pace_x = 0.999 * pace_x + 0.003 * noise(random);
        pace_y = 0.999 * pace_y + 0.003 * noise(random);
        x += pace_x;
        y += pace_y;
        const double t = static_cast<double>(i) / 1000, z = 2 * std::sin(3 * t + seed) + 0.02 * noise(random);
        const double deep = std::max(0.0, std::sin(x) * std::cos(y) - z);
        const double blow = random() % 997 == 0 ? 3 : 0;
        const Point3 force{0.3 * deep * std::cos(x), -0.3 * deep * std::sin(y), deep + blow};
        recording.times.push_back(time);
        time += random() % 50 == 0 ? 1000 + static_cast<std::int64_t>(random() % 40) : 1000;
        recording.places.push_back({std::llround(x * 1e4), std::llround(y * 1e4), std::llround(z * 1e4)});
        recording.forces.push_back(
            {spatial ? std::llround(force.x * 1e4) : 0, spatial ? std::llround(force.y * 1e4) : 0, std::llround(force.z * 1e4)});
    }
    return recording;
}

Recording decoded(const std::string& bytes) { return decode_recording(Container(bytes, "ticks.felt")); }

std::string fault_of(const std::string& bytes) {
    try {
        decoded(bytes);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

Point3 newtons(const Steps3& force) {
    return {static_cast<double>(force.x) * 1e-4, static_cast<double>(force.y) * 1e-4, static_cast<double>(force.z) * 1e-4};
}

TEST(Recording, WithoutADeadbandItComesBackAsItWas) {
    for (const std::size_t ticks : {std::size_t{1}, std::size_t{2}, std::size_t{4096}, std::size_t{4097}, std::size_t{9000}})
        for (const bool spatial : {true, false}) {
            const Recording truth = motion(1, ticks, spatial), back = decoded(encode_recording(truth, {}).bytes);
            EXPECT_EQ(back.times, truth.times);
            EXPECT_EQ(back.places, truth.places);
            EXPECT_EQ(back.forces, truth.forces);
            EXPECT_EQ(back.place_step, truth.place_step);
            EXPECT_EQ(back.force_step, truth.force_step);
            EXPECT_EQ(back.has_height, truth.has_height);
            EXPECT_EQ(back.spatial, truth.spatial);
        }
}

TEST(Recording, NumbersAtTheEndOfTheirRangeComeBack) {
    Recording truth{1e-6, 1e-6, true, true};
    constexpr std::int64_t kFar = (std::int64_t{1} << 44) - 1, kStrong = (std::int64_t{1} << 34) - 1;
    std::mt19937_64 random(2);
    for (int i = 0; i < 200; ++i) {
        const auto any = [&](std::int64_t most) {
            return static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(2 * most)) - most;
        };
        truth.times.push_back(-kFar + i * (kFar / 100));
        truth.places.push_back(i % 2 == 0 ? Steps3{-kFar, kFar, any(kFar)} : Steps3{kFar, -kFar, any(kFar)});
        truth.forces.push_back(i % 2 == 0 ? Steps3{kStrong, any(kStrong), -kStrong} : Steps3{-kStrong, any(kStrong), kStrong});
    }
    for (const ForceGuess guess : {ForceGuess::hold, ForceGuess::linear}) {
        const Recording back = decoded(encode_recording(truth, {0, 0, 0, guess}).bytes);
        EXPECT_EQ(back.places, truth.places);
        EXPECT_EQ(back.forces, truth.forces);
        EXPECT_EQ(back.times, truth.times);
    }
}

// Weber's law, at every tick, in whatever direction the force points; checked in N, without what the sender reckons with.
TEST(Recording, ForcesAreWithinTheThresholdEverywhere) {
    for (unsigned seed = 0; seed < 6; ++seed)
        for (const double share : {0.05, 0.1, 0.2, 0.5})
            for (const ForceGuess guess : {ForceGuess::hold, ForceGuess::linear}) {
                const Recording truth = motion(seed, 5000);
                const EncodedRecording encoded = encode_recording(truth, {share, 0.01, 0.1, guess});
                const Recording back = decoded(encoded.bytes);
                for (std::size_t i = 0; i < truth.forces.size(); ++i) {
                    const Point3 force = newtons(truth.forces[i]);
                    ASSERT_LE(length_of(newtons(back.forces[i]) - force), std::max(share * length_of(force), 0.01) + 1e-12) << i;
                }
                EXPECT_EQ(back.places, truth.places);
                EXPECT_LT(encoded.told, truth.forces.size() / 2);
            }
}

// Beside a sender that does not know what comes, and tells the true force whenever the one that it told is too far off.
TEST(Recording, WhatIsToldServesForLongerThanTheForceOfItsTick) {
    for (unsigned seed = 20; seed < 24; ++seed) {
        const Recording truth = motion(seed, 8000);
        std::size_t at_once = 0;
        Point3 told;
        for (const Steps3& steps : truth.forces) {
            const Point3 force = newtons(steps);
            if (at_once > 0 && length_of(told - force) <= std::max(0.1 * length_of(force), 0.01)) continue;
            told = force;
            ++at_once;
        }
        const std::size_t held = encode_recording(truth, {0.1, 0.01, 1e6, ForceGuess::hold}).told,
                          on_lines = encode_recording(truth, {0.1, 0.01, 1e6, ForceGuess::linear}).told;
        EXPECT_LT(held, 0.75 * static_cast<double>(at_once)) << seed;
        EXPECT_LE(on_lines, held) << seed;
    }
}

// Every stretch of a recording, from wherever to wherever: the work of the decoded forces over the way of the finger is no more
// than that of the true ones and the allowance.
TEST(Recording, NoStretchGivesOutMoreWorkThanIsAllowed) {
    constexpr double kStep = 1e-4;
    bool bound_mattered = false;
    for (unsigned seed = 10; seed < 16; ++seed)
        for (const double allowance : {0.0, 0.002, 0.1})
            for (const ForceGuess guess : {ForceGuess::hold, ForceGuess::linear}) {
                const Recording truth = motion(seed, 6000);
                const auto told = encode_recording(truth, {0.2, 0.01, allowance, guess});
                const Recording back = decoded(told.bytes);
                std::vector<double> sums{0};
                for (std::size_t i = 0; i + 1 < truth.forces.size(); ++i) {
                    const Point3 from = newtons(truth.places[i]), to = newtons(truth.places[i + 1]);  // mm, of the same step
                    sums.push_back(sums.back() + dot(newtons(back.forces[i]) - newtons(truth.forces[i]), to - from));
                }
                for (std::size_t i = 0; i < sums.size(); i += 7)
                    for (std::size_t j = i; j < sums.size(); ++j) ASSERT_LE(sums[j] - sums[i], allowance + kStep * kStep) << i;
                bound_mattered |= told.told > encode_recording(truth, {0.2, 0.01, 1e6, guess}).told;
            }
    EXPECT_TRUE(bound_mattered);
}

TEST(Recording, WhatIsToldOfItsLossIsItsLoss) {
    const Recording truth = motion(20, 3000);
    const ForceBand band{0.1, 0.01, 0.05, ForceGuess::linear};
    const Recording back = decoded(encode_recording(truth, band).bytes);
    const ForceLoss loss = loss_of(truth, back, band);
    double most = 0, squares = 0, worst = 0;
    std::size_t touched = 0;
    for (std::size_t i = 0; i < truth.forces.size(); ++i) {
        const double error = length_of(newtons(back.forces[i]) - newtons(truth.forces[i]));
        most = std::max(most, error);
        squares += error * error;
        worst = std::max(worst, error / std::max(0.1 * length_of(newtons(truth.forces[i])), 0.01));
        touched += length_of(newtons(truth.forces[i])) > 0 ? 1 : 0;
    }
    EXPECT_NEAR(loss.most, most, 1e-9);
    EXPECT_NEAR(loss.rms, std::sqrt(squares / 3000), 1e-9);
    EXPECT_NEAR(loss.of_threshold, worst, 1e-9);
    EXPECT_EQ(loss.touched, touched);
    EXPECT_LE(loss.of_threshold, 1);
    EXPECT_LE(loss.work, 0.05);
}

TEST(Recording, AnyPartIsAsInTheWhole) {
    const Recording truth = motion(30, 20000);
    for (const ForceBand& band : {ForceBand{}, ForceBand{0.1, 0.01, 0.1, ForceGuess::linear}}) {
        const std::string bytes = encode_recording(truth, band).bytes;
        const Container container(bytes, "ticks.felt");
        const Recording whole = decode_recording(container);
        std::mt19937 random(4);
        for (int i = 0; i < 40; ++i) {
            const std::int64_t from = truth.times.front() - 2000 + static_cast<std::int64_t>(random() % 20'100'000);
            const std::int64_t to = from + static_cast<std::int64_t>(random() % 6'000'000);
            const Recording part = decode_recording(container, from, to);
            std::vector<std::int64_t> times;
            std::vector<Steps3> forces, places;
            for (std::size_t tick = 0; tick < whole.times.size(); ++tick)
                if (whole.times[tick] >= from && whole.times[tick] <= to) {
                    times.push_back(whole.times[tick]);
                    forces.push_back(whole.forces[tick]);
                    places.push_back(whole.places[tick]);
                }
            ASSERT_EQ(part.times, times);
            ASSERT_EQ(part.forces, forces);
            ASSERT_EQ(part.places, places);
        }
    }
}

TEST(Recording, TicksOfOneTimeAreAllFound) {
    Recording truth = motion(31, 13000);
    for (std::size_t i = 3000; i < 12900; ++i) truth.times[i] = truth.times[3000];
    for (std::size_t i = 12900; i < 13000; ++i) truth.times[i] = std::max(truth.times[i], truth.times[3000]);
    const std::string bytes = encode_recording(truth, {}).bytes;
    EXPECT_EQ(decode_recording(Container(bytes, "t"), truth.times[3000], truth.times[3000]).times.size(), 9900u);
}

TEST(Recording, CutOffAnywhereOrChangedAnywhereItIsRefused) {
    const std::string bytes = encode_recording(motion(40, 300), {0.1, 0.01, 0.1, ForceGuess::linear}).bytes;
    for (std::size_t size = 0; size < bytes.size(); ++size) ASSERT_NE(fault_of(bytes.substr(0, size)), "") << size;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        std::string changed = bytes;
        changed[i] = static_cast<char>(changed[i] ^ (1 << (i % 8)));
        ASSERT_NE(fault_of(changed), "") << i;
    }
}

TEST(Recording, HostilePartsGiveAnErrorOrTicks) {
    const std::string bytes = encode_recording(motion(41, 200), {0.1, 0.01, 0.1, ForceGuess::linear}).bytes;
    const Container container(bytes, "ticks.felt");
    std::mt19937 random(6);
    int refused = 0;
    for (int i = 0; i < 20000; ++i) {
        std::vector<std::string> parts{std::string(container.part(0))};
        for (unsigned change = 0; change <= random() % 3; ++change)
            parts[0][random() % parts[0].size()] = static_cast<char>(random());
        if (random() % 4 == 0) parts[0].resize(random() % (parts[0].size() + 20));
        const std::string hostile = container_bytes(ContainerKind::recording, container.facts(), parts);
        try {
            const Recording back = decoded(hostile);
            ASSERT_EQ(back.times.size(), 200u);
            ASSERT_TRUE(std::is_sorted(back.times.begin(), back.times.end()));
        } catch (const Error&) {
            ++refused;
        }
    }
    EXPECT_GT(refused, 10000);
}

TEST(Recording, FactsThatCannotBeAreRefused) {
    const std::string bytes = encode_recording(motion(42, 100), {0.1, 0.01, 0.1, ForceGuess::linear}).bytes;
    const Container container(bytes, "ticks.felt");
    const std::vector<std::string> parts{std::string(container.part(0))};
    const auto with = [&](std::size_t at, std::uint64_t number, std::size_t size) {
        std::string facts(container.facts()), told;
        append_number(told, number, size);
        facts.replace(at, size, told);
        return fault_of(container_bytes(ContainerKind::recording, facts, parts));
    };
    EXPECT_EQ(with(0, 100, 4), "");
    for (const auto& [at, number, size] :
         std::initializer_list<std::tuple<std::size_t, std::uint64_t, std::size_t>>{{0, 0, 4},
                                                                                    {0, 99, 4},
                                                                                    {0, 0xFFFFFFFF, 4},
                                                                                    {0, 10'000'001, 4},
                                                                                    {4, 2, 1},
                                                                                    {5, 4, 1},
                                                                                    {6, 1, 2},
                                                                                    {8, 0, 8},
                                                                                    {16, 0x7FF8000000000000, 8},   // NaN
                                                                                    {24, 0xBFF0000000000000, 8},   // -1
                                                                                    {40, 0x7FF0000000000000, 8}})  // infinite
        EXPECT_NE(with(at, number, size), "") << at << " " << number;
    EXPECT_NE(fault_of(container_bytes(ContainerKind::heights, container.facts(), parts)), "");
}

TEST(DeviceFilter, TakesAwayWhatADeviceCannotTellAndNoMore) {
    const Recording truth = motion(50, 4000);
    const DeviceSteps omni{0.055, 0.01, 0.5};
    const Recording soft = for_device(truth, omni);
    bool cut = false;
    for (std::size_t i = 0; i < truth.forces.size(); ++i) {
        const Point3 force = newtons(truth.forces[i]);
        const Point3 given{static_cast<double>(soft.forces[i].x) * 0.01, static_cast<double>(soft.forces[i].y) * 0.01,
                           static_cast<double>(soft.forces[i].z) * 0.01};
        ASSERT_LE(length_of(given - within(force, 0.5)), 0.005 * std::sqrt(3.0) + 1e-9);
        cut |= length_of(force) > 0.5;
        ASSERT_LE(std::abs(static_cast<double>(soft.places[i].x) * 0.055 - static_cast<double>(truth.places[i].x) * 1e-4),
                  0.0275 + 1e-9);
    }
    EXPECT_TRUE(cut);
    EXPECT_EQ(for_device(soft, omni).places, soft.places);
    EXPECT_LT(encode_recording(soft, {}).bytes.size(), encode_recording(truth, {}).bytes.size() / 2);
}

TEST(DeviceFilter, AHeightMovesByAtMostHalfTheResolution) {
    LevelMap map{300, 1, 0.1, -2, 8, 10.0 / 65535, 65535, {}, {}};
    for (int i = 0; i < 300; ++i) map.levels.push_back(static_cast<Level>(65535 * i / 299));
    const LevelMap soft = for_device(map, {0.055, 0.01, 3.3});
    EXPECT_EQ(soft.top, 182);  // 10 mm / 0.055 mm = 181.8
    for (std::size_t i = 0; i < 300; ++i)
        EXPECT_LE(std::abs(soft.rise * soft.levels[i] - map.rise * map.levels[i]), 0.0275 + 1e-9);
    // One that the device tells apart already stays as it is.
    map.top = 100;
    map.rise = 0.1;
    for (Level& level : map.levels) level = static_cast<Level>(level % 101);
    EXPECT_EQ(for_device(map, {0.055, 0.01, 3.3}).levels, map.levels);
}

}  // namespace
}  // namespace tactics::tests::recording_test
