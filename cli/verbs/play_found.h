// SPDX-License-Identifier: Apache-2.0
// Compares the findings of a simulated hand with the truth.
#pragma once

#include <string>
#include <vector>

#include "tactics/haptics/loop/recorder.h"
#include "tactics/haptics/scenes/plot_frame.h"
#include "tactics/haptics/simulated/hand.h"
#include "tactics/plot.h"
#include "tactics/text/phrase.h"

namespace tactics {

struct HandReport {
    std::vector<Phrase> lines;
    std::string json;  ///< members of an object; empty: the hand found nothing
};

/// For a followed curve: the distance of the finger from it, and the share that was traced. For points: those that exist, and the
/// three highest. For a tick: its value. For two sections of a surface: its shape in a word. And what it did not find, or not
/// end.
HandReport report_of(const HandKind& kind, const Hand& hand, const std::vector<TickRecord>& records, const Plot& plot,
                     const PlotFrame& frame);

}  // namespace tactics
