// SPDX-License-Identifier: Apache-2.0
// The link between the ticks of a loop and the thread that talks to an arm, which may be slow: it holds the last report and the
// last requested force, and neither side waits for the other.
#pragma once

#include <atomic>
#include <memory>

#include "tactics/haptics/devices/haptic_device.h"
#include "tactics/haptics/devices/latest.h"

namespace tactics {

/// The report of an arm, in the axes of arm_devices.h.
struct ArmWord {
    Point3 place;        ///< mm
    unsigned keys = 0;   ///< that are down: bit 0 the first
    bool fault = false;  ///< it applies no force, or reports that it cannot
};

class ArmTalk {
public:
    // For the ticks.
    HapticDevice::State read(HapticSample& sample) noexcept;
    /// N; false: gone.
    bool push(const Point3& force) noexcept;
    /// From now on the force is zero; waits until the arm has received this, 0.1 s at most.
    void let_go() noexcept;

    // For the thread that talks to the arm.
    void tell(const ArmWord& word) noexcept;
    /// The force requested now: finite, 8 N at most, and zero if the request is older than 10 ms or the arm was released.
    Point3 force() noexcept;
    bool lets_go() const noexcept { return let_go_.load(); }
    void has_let_go() noexcept { lies_ = true; }
    void lose() noexcept { gone_ = true; }
    bool gone() const noexcept { return gone_.load(); }

private:
    struct Told {
        ArmWord word;
        double time = 0;      // s, time of arrival
        unsigned number = 0;  // number of the report since opening, from 1
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

/// An arm with such a link. Derived classes open and close the device.
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
