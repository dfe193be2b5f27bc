// SPDX-License-Identifier: Apache-2.0
// A plot that obeys the keys of the device: it speaks, and it leads the finger.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tactics/haptics/scenes/guidance.h"
#include "tactics/haptics/scenes/near_lines.h"
#include "tactics/haptics/scenes/plot_frame.h"
#include "tactics/haptics/scenes/scene.h"
#include "tactics/haptics/voice/announcement.h"
#include "tactics/haptics/voice/plot_keys.h"
#include "tactics/haptics/voice/speaking.h"
#include "tactics/haptics/voice/tone_track.h"
#include "tactics/haptics/voice/toning.h"
#include "tactics/plot.h"

namespace tactics {

/// Keys typed in one thread, as indices into plot_keys(), until another thread takes them: up to 16; later ones are lost. No
/// thread waits.
class TypedKeys {
public:
    static constexpr int kBits = 4;
    void press(std::size_t entry) noexcept {
        std::uint64_t word = word_.load();
        while (word >> (64 - kBits) == 0 && !word_.compare_exchange_weak(word, word << kBits | (entry + 1))) {
        }
    }
    /// Each kBits hold an index plus one, the first typed in the highest bits; 0: none.
    std::uint64_t take() noexcept { return word_.load(std::memory_order_relaxed) == 0 ? 0 : word_.exchange(0); }

private:
    std::atomic<std::uint64_t> word_{0};
};

/// The outputs for its answers; any may be empty. `typed` is a further input.
struct KeyedParts {
    Speaking* speaking = nullptr;
    TypedKeys* typed = nullptr;
    Toning* toning = nullptr;
    ToneTrack* track = nullptr;
    const PlotSurface* surface = nullptr;  ///< the surface that can be under the finger
};

/// Carries out the action in plot_keys() when a numbered key goes down or a letter is typed. The next request interrupts the
/// current speech. The place to which a finger was led is announced on arrival, a comparison of two curves at once. While the
/// finger is on a curve, its height sounds as a tone. The guidance decides what is felt. A tick only passes on numbers: other
/// threads make words, speak and sound tones (speaking.h, toning.h).
class KeyedScene final : public Scene {
public:
    /// All must outlive it. `lines` are the plot's curves as felt.
    KeyedScene(Guidance& guidance, const KeyedParts& parts, const PlotFrame& frame, const FeltLines& lines);
    Felt feel(const Touch& touch, double dt) noexcept override;
    void begin_again() noexcept override { guidance_.begin_again(); }

private:
    void act(PlotAction action, const Point3& finger, const Nearness& near) noexcept;
    void lead(LeadTo where, const Point3& finger, const Nearness& near) noexcept;
    void tell_end(const LeadRecord& record) noexcept;
    void tell(Telling telling, const Point3& finger, const Nearness& near) noexcept;
    void look_under(const Point3& finger, const Nearness& near, Announcement& one) const noexcept;
    bool is_on_surface(const Point3& finger) const noexcept;
    void sound(const Nearness& near, double dt) noexcept;
    void ask(const Announcement& one) noexcept {
        if (parts_.speaking != nullptr) parts_.speaking->ask(one);
    }

    Guidance& guidance_;
    KeyedParts parts_;
    PlotFrame frame_;
    NearLines lines_;
    std::vector<std::size_t> curves_;
    unsigned down_ = 0;       // keys at the previous tick
    std::size_t chosen_ = 0;  // index into chosen_actions()
};

}  // namespace tactics
