// SPDX-License-Identifier: Apache-2.0
// What a play was asked for, checked before anything moves.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/chart_files.h"
#include "cli/command.h"
#include "cli/verbs/play_device.h"
#include "cli/verbs/play_map.h"
#include "tactics/haptics/loop/play.h"
#include "tactics/haptics/scenes/relief_scene.h"
#include "tactics/job/disk.h"

namespace tactics {

struct PlayPlan {
    std::string map;  ///< empty: only the chart of what is stable is wanted
    MapWish wish;
    std::string device;
    MouseSettings machine;
    ReliefFeel feel;
    PlaySettings settings;
    std::optional<OverlayWish> overlay;
    bool paper_fusion = false;
    std::string learned;            ///< the file of what was learned; empty: none
    bool own_learned = false;       ///< it was not named
    double speed = 50;              ///< mm/s, of a simulated hand
    std::optional<double> seconds;  ///< nothing: until a real mouse is stopped, or a recorded way is over
    std::string csv;
    std::vector<ChartFile> way, track, stable;
    std::optional<Point> part;  ///< mm, from and to: what --plot draws of the way
};

/// Throws Error: flags that do not fit, no such file of a machine, two outputs of one name.
PlayPlan plan_play(const Given& given);

/// No two outputs of one name ("-" is standard output), and none that is an input; those may be empty. Throws Error(usage).
void check_names(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs, bool json, const Disk& disk);

/// --paper and the like go with a drawing. Throws Error(usage).
void check_page_flags(const Given& given);

}  // namespace tactics
