// SPDX-License-Identifier: Apache-2.0
// A plot that speaks when a key of the device is pressed.
#pragma once

#include <vector>

#include "tactics/haptics/scenes/near_lines.h"
#include "tactics/haptics/scenes/plot_frame.h"
#include "tactics/haptics/scenes/scene.h"
#include "tactics/haptics/voice/announcement.h"
#include "tactics/haptics/voice/speaking.h"

namespace tactics {

/// The first key tells where the finger is, the second the nearest data point, the third what is under the finger; any of them
/// while something is spoken interrupts it. What is felt is the scene's. A tick only hands over numbers: words are made and
/// spoken on another thread (speaking.h).
class SpokenScene final : public Scene {
public:
    /// `scene` and `speaking` must outlive it. `lines` are the plot's curves as they are felt.
    SpokenScene(Scene& scene, Speaking& speaking, const PlotFrame& frame, const FeltLines& lines);
    Felt feel(const Touch& touch, double dt) noexcept override;
    void begin_again() noexcept override { scene_.begin_again(); }

private:
    Announcement announcement_for(unsigned key, const Point3& finger) const noexcept;
    void look_under(const Point3& finger, Announcement& one) const noexcept;

    Scene& scene_;
    Speaking& speaking_;
    PlotFrame frame_;
    NearLines lines_;
    std::vector<std::size_t> curves_;
    unsigned down_ = 0;  // keys at the tick before
};

}  // namespace tactics
