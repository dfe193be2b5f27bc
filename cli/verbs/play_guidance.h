// SPDX-License-Identifier: Apache-2.0
// What answers a finger in a plot besides force: keys, on the arm and on the keyboard; where they lead it; speech and tones.
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

/// The hand that lets itself be led, which --guide wants.
inline constexpr std::string_view kLedHand = "led";
/// The numbers of the keys that --guide names. Throws Error(usage).
std::vector<unsigned> keys_to_press(const Given& given, const HandKind& hand);

/// What is below the layers.
struct PlotLayersWish {
    Scene& scene;
    ForceLaw law;
    double most_force = 0;  ///< N, of the arm
    double resolution = 0;  ///< mm
};

/// --speak, --language and --tones, and the keys, over the scene of a plot. Absent or broken speech and sound are notes.
class PlotLayers {
public:
    /// `plot` and the scene must outlive it. Throws Error: what is asked for means nothing, or a file cannot be written.
    PlotLayers(const Given& given, const Plot& plot, const PlotFrame& frame, const PlotLayersWish& wish);
    ~PlotLayers();
    PlotLayers(const PlotLayers&) = delete;
    PlotLayers& operator=(const PlotLayers&) = delete;

    Scene& scene();
    bool are_heard() const;  ///< by a loudspeaker, which wants the clock on the wall
    /// Before the first tick. By the clock on the wall keys are taken from the terminal, too, if there is one.
    void begin(bool by_wall);
    /// After the last: what is spoken ends, the terminal is as it was, and the tones are written. Throws Error(failed).
    void finish();
    /// The ways that the finger was led, beside those that its hand found.
    void tell_ways(const PlayedScene& played, HandReport& report) const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace tactics
