// SPDX-License-Identifier: Apache-2.0
// Pictures and the contour maps that people drew of them.
#pragma once

#include <string>
#include <vector>

#include "tactics/measure/matching.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// A picture and its maps, one of each annotator.
struct Subject {
    std::string name;  ///< of the picture's file, without ending
    std::string picture;
    std::vector<std::string> truths;
};

struct Pairing {
    std::vector<Subject> subjects;  ///< in the order of their names; without truths if there are none
    std::vector<Phrase> problems;   ///< "gt/b_gt1.png: there is no picture b", one line each
};

/// The maps of picture NAME.jpg are NAME_gt1.png, NAME_gt2.png and so on. Given are paths of files, in any order.
Pairing pair_up(std::vector<std::string> pictures, std::vector<std::string> truths);

/// The map's pixels that are not black. Throws Error(failed): unreadable, of another size than the picture, or light on more
/// than half of its pixels, which is no contour map.
PixelSet read_truth(const std::string& path, int width, int height);

}  // namespace tactics
