// SPDX-License-Identifier: Apache-2.0
// The plan of a play, checked before anything moves.
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
    std::string map;  ///< empty: only the chart of stability is wanted
    MapWish wish;
    std::string device;
    MouseSettings machine;
    ReliefFeel feel;
    PlaySettings settings;
    std::optional<OverlayWish> overlay;
    bool paper_fusion = false;
    std::string learned;            ///< the file with learned parameters; empty: none
    bool own_learned = false;       ///< the user did not name it
    double speed = 50;              ///< mm/s, of a simulated hand
    std::optional<double> seconds;  ///< nothing: until a real mouse is stopped, or a recorded path ends
    std::string csv;
    std::vector<ChartFile> way, track, stable;
    std::optional<Point> part;  ///< mm, from and to: the part of the path that --plot draws
};

/// Throws Error for conflicting options, a missing machine file, or two outputs with one name.
PlayPlan plan_play(const Given& given);

/// Checks that no two outputs have one name ("-" is standard output), and that none is an input; names may be empty. Throws
/// Error(usage).
void check_names(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs, bool json, const Disk& disk);

/// Checks that --paper and similar options come with a drawing. Throws Error(usage).
void check_page_flags(const Given& given);

}  // namespace tactics
