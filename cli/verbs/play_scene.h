// SPDX-License-Identifier: Apache-2.0
// Plays a scene on an open device to its end: the loop, its clock and its log.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/verbs/play_report.h"
#include "tactics/error.h"
#include "tactics/haptics/devices/haptic_device.h"
#include "tactics/haptics/loop/play.h"

namespace tactics {

struct SceneWish {
    std::string device;             ///< as it was named, for messages
    PlaySettings settings;          ///< with the rate; the number of ticks to keep is computed
    std::optional<double> seconds;  ///< nothing: until it is over or stopped
    bool by_wall = false;           ///< in real time although nothing real moves
    std::string csv;                ///< the log; empty: none
    TickColumns columns;
    ForceLaw law;  ///< for the figures
};

struct PlayedScene {
    std::vector<TickRecord> records;
    PlayFigures figures;
    bool lost = false;              ///< records are the last ones only
    std::optional<Error> unlogged;  ///< the log could not be written
};

/// Reports when the device is gone and when it is back. Ctrl-C ends it. Throws Error if the log cannot be created.
PlayedScene play_scene(Scene& scene, HapticDevice& device, Fusion* fusion, SceneWish wish);

/// The figures, as lines or as JSON with `more` in it.
void tell_figures(const PlayedScene& played, bool quiet, bool json, const std::string& more = "");

}  // namespace tactics
