// SPDX-License-Identifier: Apache-2.0
// What is at the other end of a haptic mouse's cable: a lever with a finger on it, a hand that moves it, and a firmware. Its
// reports are written from the table in tactics/haptics/devices/mouse_report.h and share no code with what reads them; its report
// descriptor is the one there.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "tactics/haptics/devices/mouse_report.h"
#include "tactics/haptics/simulated/lever.h"

namespace tactics::tests {

using Report = std::array<unsigned char, 64>;

/// CRC-16/CCITT-FALSE without a loop over bits.
inline unsigned sum_of(std::span<const unsigned char> bytes) {
    unsigned sum = 0xFFFF;
    for (const unsigned char byte : bytes) {
        sum = (sum >> 8 | sum << 8) & 0xFFFF;
        sum ^= byte;
        sum ^= (sum & 0xFF) >> 4;
        sum ^= sum << 12 & 0xFFFF;
        sum ^= (sum & 0xFF) << 5;
    }
    return sum;
}

struct ForceWord {
    bool motor_on = false;
    int number = 0;
    double force = 0;  // N
    int hold = 0;      // ms
};

/// Nothing, unless it is whole and says nothing else.
inline std::optional<ForceWord> force_word(std::span<const unsigned char> bytes) {
    if (bytes.size() != 64 || bytes[0] != 0x46 || bytes[1] != 1 || bytes[2] > 1) return std::nullopt;
    for (std::size_t i = 8; i < 62; ++i)
        if (bytes[i] != 0) return std::nullopt;
    if (sum_of(bytes.first(62)) != (bytes[62] | static_cast<unsigned>(bytes[63]) << 8)) return std::nullopt;
    const int force = bytes[4] | bytes[5] << 8;
    return ForceWord{bytes[2] == 1, bytes[3], 1e-3 * (force >= 0x8000 ? force - 0x10000 : force), bytes[6] | bytes[7] << 8};
}

class Firmware {
public:
    /// During a play the hand moves it to the right by that many counts per second, and back after `turns_at` counts.
    Firmware(double speed, double turns_at) : speed_(speed), turns_at_(turns_at) {}
    bool stop_key = false, too_hot = false;

    /// So much time passes for lever, finger and motor. What it was told holds as long as was said; then it lets go.
    void advance(double seconds) {
        time_ += seconds;
        since_word_ += seconds;
        if (since_word_ > hold_) force_ = 0;
        if (motor_on_ && since_word_ < 0.05) place_ += speed_ * seconds;
        if ((speed_ > 0 && place_ > turns_at_) || (speed_ < 0 && place_ < 0)) speed_ = -speed_;
        lever_.push(too_hot ? 0 : force_);
        lever_.advance(seconds);
    }

    Report report() {
        const long moved = std::lround(place_) - told_;
        told_ += moved;
        Report bytes{};
        bytes[0] = 0x54;
        bytes[1] = 1;
        bytes[2] = static_cast<unsigned char>((stop_key ? 1 : 0) | (motor_on_ ? 2 : 0) | (is_at_fault() ? 4 : 0));
        bytes[3] = static_cast<unsigned char>(number_++);
        put(bytes, 4, 4, static_cast<long long>(time_ * 1e6));
        put(bytes, 8, 4, std::llround(lever_.height() / LeverSettings{}.encoder_step));
        put(bytes, 12, 2, moved);
        put(bytes, 16, 2, moved);
        seal(bytes);
        return bytes;
    }
    static void seal(Report& bytes) { put(bytes, 62, 2, sum_of(std::span(bytes).first(62))); }

    /// false: damaged, and ignored.
    bool obey(std::span<const unsigned char> bytes) {
        const auto word = force_word(bytes);
        if (!word) return false;
        motor_on_ = word->motor_on;
        force_ = motor_on_ ? word->force : 0;
        hold_ = 1e-3 * word->hold;
        since_word_ = 0;
        return true;
    }

    bool is_at_fault() const { return too_hot || (motor_on_ && since_word_ > hold_); }
    double force() const { return too_hot ? 0 : force_; }
    bool motor_on() const { return motor_on_; }
    double height() const { return lever_.true_height(); }
    double place() const { return place_; }  ///< counts from where it began, to the right

private:
    static void put(Report& bytes, std::size_t at, std::size_t count, long long value) {
        for (std::size_t i = 0; i < count; ++i) bytes[at + i] = static_cast<unsigned char>(value >> 8 * i & 0xFF);
    }

    double speed_, turns_at_, place_ = 0;
    long told_ = 0;  // counts
    SimulatedLever lever_{LeverSettings{}, FingerSettings{}, 0};
    double time_ = 0, since_word_ = 0, hold_ = 0, force_ = 0;
    bool motor_on_ = false;
    unsigned number_ = 0;
};

}  // namespace tactics::tests
