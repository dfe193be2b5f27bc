// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/devices/arm_talk.h"

#include <chrono>
#include <thread>

namespace tactics {

namespace {

constexpr double kMostForce = 8;     // N, as SafetyLimits has it
constexpr double kWishHolds = 0.01;  // s: twice what a loop takes for too late
constexpr std::chrono::milliseconds kLetsGo{100};

// CLOCK_MONOTONIC
double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

}  // namespace

HapticDevice::State ArmTalk::read(HapticSample& sample) noexcept {
    sample.words = sample.lost = 0;
    // Asked in this order, so that the last word of one that is gone is heard.
    const bool gone = gone_.load();
    Told told;
    if (!told_.ask(told)) return gone ? HapticDevice::State::gone : HapticDevice::State::nothing;
    sample.knows_place = true;
    sample.place = {told.word.place.x, told.word.place.y};
    sample.height = told.word.place.z;
    sample.place_time = told.time;
    sample.keys = told.word.keys;
    sample.fault = told.word.fault;
    sample.words = told.number - read_;
    read_ = told.number;
    return HapticDevice::State::fine;
}

bool ArmTalk::push(const Point3& force) noexcept {
    if (gone_) return false;
    wished_.tell({force, now()});
    return true;
}

void ArmTalk::let_go() noexcept {
    let_go_ = true;
    for (const auto end = std::chrono::steady_clock::now() + kLetsGo; std::chrono::steady_clock::now() < end && !lies_ && !gone_;)
        std::this_thread::sleep_for(std::chrono::microseconds{200});
}

void ArmTalk::tell(const ArmWord& word) noexcept { told_.tell({word, now(), ++number_}); }

Point3 ArmTalk::force() noexcept {
    wished_.ask(wish_);
    if (let_go_ || !(now() - wish_.time <= kWishHolds) || !is_finite(wish_.force)) return {};
    const double length = std::hypot(wish_.force.x, wish_.force.y, wish_.force.z);
    return length > kMostForce ? (kMostForce / length) * wish_.force : wish_.force;
}

}  // namespace tactics
