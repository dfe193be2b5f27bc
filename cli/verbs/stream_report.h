// SPDX-License-Identifier: Apache-2.0
// The report of `tactics measure` on a recording, in words and in JSON.
#pragma once

#include <string>
#include <vector>

#include "tactics/information/stream.h"
#include "tactics/text/phrase.h"

namespace tactics {

struct StreamMedium {
    MediumChannel channel;  ///< one that pushes back
    CarriedForces carried;
};

struct StreamReport {
    std::string file;
    MeasuredStream stream;
    std::vector<StreamMedium> media;
    std::vector<Phrase> notes;
};

std::string text_of(const StreamReport& report);
std::string json_of(const StreamReport& report);  ///< one object, one line

}  // namespace tactics
