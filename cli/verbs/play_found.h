// SPDX-License-Identifier: Apache-2.0
// What a simulated hand took to be there, beside what is.
#pragma once

#include <string>
#include <vector>

#include "tactics/haptics/loop/recorder.h"
#include "tactics/haptics/scenes/plot_frame.h"
#include "tactics/haptics/simulated/hand.h"
#include "tactics/plot.h"

namespace tactics {

struct HandReport {
    std::vector<std::string> lines;
    std::string json;  ///< members of an object; empty: the hand found nothing
};

/// Of a curve that was followed: how far from it the finger was, and how much of it was passed. Of points: which there are, and
/// the three highest. Of a tick: which it is. Of two
/// sections of a surface: its shape in a word.
HandReport report_of(const std::vector<HandFinding>& findings, const std::vector<TickRecord>& records, const Plot& plot,
                     const PlotFrame& frame);

}  // namespace tactics
