// SPDX-License-Identifier: Apache-2.0
// Everything besides force that responds to a finger in a plot: keys on the arm and the keyboard, guidance, speech and tones.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/command.h"
#include "cli/verbs/play_found.h"
#include "cli/verbs/play_scene.h"
#include "tactics/haptics/scenes/plot_frame.h"
#include "tactics/haptics/simulated/hand.h"
#include "tactics/plot.h"

namespace tactics {

/// The led hand, required by --guide.
inline constexpr std::string_view kLedHand = "led";
/// The numbers of the keys that --guide names. Throws Error(usage).
std::vector<unsigned> keys_to_press(const Given& given, const HandKind& hand);

/// The scene under the layers, and its limits.
struct PlotLayersWish {
    Scene& scene;
    ForceLaw law;
    double most_force = 0;  ///< N, of the arm
    double resolution = 0;  ///< mm
};

/// --speak, --language, --tones and the keys, on top of the scene of a plot. Missing or broken speech and sound give notes.
class PlotLayers {
public:
    /// `plot` and the scene must outlive it. Throws Error for invalid options, or a file that cannot be written.
    PlotLayers(const Given& given, const Plot& plot, const PlotFrame& frame, const PlotLayersWish& wish);
    ~PlotLayers();
    PlotLayers(const PlotLayers&) = delete;
    PlotLayers& operator=(const PlotLayers&) = delete;

    Scene& scene();
    bool are_heard() const;  ///< on a loudspeaker, which needs real time
    /// Call it before the first tick. In real time, it also takes keys from the terminal, if there is one.
    void begin(bool by_wall);
    /// Call it after the last tick: ends speech, restores the terminal, and writes the tones. Throws Error(failed).
    void finish();
    /// The paths on which the finger was led, compared with those that its hand found.
    void tell_ways(const PlayedScene& played, HandReport& report) const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace tactics
