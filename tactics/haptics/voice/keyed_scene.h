// SPDX-License-Identifier: Apache-2.0
// A plot that does what the keys of the device ask: it speaks, and it leads the finger.
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

/// What is typed on a keyboard by one thread, as numbers of entries of plot_keys(), until another looks: up to 16, and what comes
/// then is lost. Nobody waits.
class TypedKeys {
public:
    static constexpr int kBits = 4;
    void press(std::size_t entry) noexcept {
        std::uint64_t word = word_.load();
        while (word >> (64 - kBits) == 0 && !word_.compare_exchange_weak(word, word << kBits | (entry + 1))) {
        }
    }
    /// In kBits each the number of an entry and one, the first that was typed in the highest; 0: none.
    std::uint64_t take() noexcept { return word_.load(std::memory_order_relaxed) == 0 ? 0 : word_.exchange(0); }

private:
    std::atomic<std::uint64_t> word_{0};
};

/// Where its answers go; any may be empty. `typed` is where it is asked, too.
struct KeyedParts {
    Speaking* speaking = nullptr;
    TypedKeys* typed = nullptr;
    Toning* toning = nullptr;
    ToneTrack* track = nullptr;
    const PlotSurface* surface = nullptr;  ///< that can be under the finger
};

/// Does what is in plot_keys() when a key goes down, by its number, or is typed. What is spoken is interrupted by what is asked
/// next; where a finger was led is told when it is there, what two curves are at that x at once. While the finger is on a curve
/// its height there is a tone. What is felt is the guidance's. A tick only hands over numbers: words are made and spoken, and
/// tones are heard, on other threads (speaking.h, toning.h).
class KeyedScene final : public Scene {
public:
    /// All must outlive it. `lines` are the plot's curves as they are felt.
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
    unsigned down_ = 0;       // keys at the tick before
    std::size_t chosen_ = 0;  // of chosen_actions()
};

}  // namespace tactics
