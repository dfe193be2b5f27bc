// SPDX-License-Identifier: Apache-2.0
// Converts recordings between tables, as play --csv writes them, and the container of tactics/coding.
#pragma once

#include <string>
#include <vector>

#include "tactics/coding/recording.h"
#include "tactics/readers/read.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// Whether a table is a recording: one of its columns is time_s.
bool has_ticks(Source& table);

struct TickTable {
    Recording recording;
    std::vector<Phrase> notes;  ///< on things left out or not exact, one sentence each
};

/// Columns time_s,x_mm,y_mm; a height of the finger, finger_mm or z_mm; forces force_n (upwards), force_x_n, force_y_n. Other
/// columns are left out. Steps are the largest of 1, 0.1 ... 0.000001 that represent all numbers exactly. Throws Error(failed)
/// with the line for a value that is not a number or is beyond 1e7 s, 1e5 mm or 1e4 N, for time that goes back, and for over 10
/// million ticks.
TickTable read_ticks(Source& table);

/// The same columns again, with a header line.
std::string ticks_csv(const Recording& recording);

}  // namespace tactics
