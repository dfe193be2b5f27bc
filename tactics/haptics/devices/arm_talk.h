// SPDX-License-Identifier: Apache-2.0
// Between the ticks of a loop and who talks with an arm, which may take its time: the last word and the last wish, and neither
// side waits for the other.
#pragma once

#include <atomic>
#include <memory>

#include "tactics/haptics/devices/haptic_device.h"
#include "tactics/haptics/devices/latest.h"

namespace tactics {

/// What an arm tells, in the axes that arm_devices.h says.
struct ArmWord {
    Point3 place;        ///< mm
    unsigned keys = 0;   ///< that are down: bit 0 the first
    bool fault = false;  ///< it gives no force, or says that it is not fit to
};

class ArmTalk {
public:
    // Of the ticks.
    HapticDevice::State read(HapticSample& sample) noexcept;
    /// N; false: gone.
    bool push(const Point3& force) noexcept;
    /// From now on there is no force; waits until the arm has been told so, 0.1 s at most.
    void let_go() noexcept;

    // Of who talks with the arm.
    void tell(const ArmWord& word) noexcept;
    /// The force that is wished for now: finite, 8 N at most, and none where the wish is older than 10 ms or the arm is let go
    /// of.
    Point3 force() noexcept;
    bool lets_go() const noexcept { return let_go_.load(); }
    void has_let_go() noexcept { lies_ = true; }
    void lose() noexcept { gone_ = true; }
    bool gone() const noexcept { return gone_.load(); }

private:
    struct Told {
        ArmWord word;
        double time = 0;      // s, when it came in
        unsigned number = 0;  // of words since it was opened, from 1
    };
    struct Wish {
        Point3 force;
        double time = 0;  // s
    };
    Latest<Told> told_;
    Latest<Wish> wished_;
    unsigned read_ = 0;    // of the ticks
    Wish wish_;            // of who talks
    unsigned number_ = 0;  // of who talks
    std::atomic<bool> let_go_{false}, lies_{false}, gone_{false};
};

/// An arm by such talk. What is opened and closed is its own.
class TalkedArm : public HapticDevice {
public:
    State read(HapticSample& sample, double) noexcept override { return talk_ ? talk_->read(sample) : State::gone; }
    bool push(const Point3& force) noexcept override { return talk_ && talk_->push(force); }
    void let_go() noexcept override {
        if (talk_) talk_->let_go();
    }
    bool is_real() const override { return true; }

protected:
    std::unique_ptr<ArmTalk> talk_;  ///< empty: it is gone
};

}  // namespace tactics
