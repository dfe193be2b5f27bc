// SPDX-License-Identifier: Apache-2.0
// Recordings as tables, as play --csv writes them, to and from the container of tactics/coding.
#pragma once

#include <string>
#include <vector>

#include "tactics/coding/recording.h"
#include "tactics/readers/read.h"

namespace tactics {

/// Whether a table is a recording: one of its columns is time_s.
bool has_ticks(Source& table);

struct TickTable {
    Recording recording;
    std::vector<std::string> notes;  ///< what was left out or is not exact, a sentence each
};

/// Columns time_s,x_mm,y_mm; a height of the finger, finger_mm or z_mm; forces force_n (upwards), force_x_n, force_y_n. Others
/// are left out. Steps are the largest of 1, 0.1 ... 0.000001 that tell all numbers exactly. Throws Error(failed) with the line:
/// not a number, beyond 1e7 s, 1e5 mm or 1e4 N, time that goes back, over 10 million ticks.
TickTable read_ticks(Source& table);

/// The same columns again, with a header line.
std::string ticks_csv(const Recording& recording);

}  // namespace tactics
