// SPDX-License-Identifier: Apache-2.0
// What looks like a line of lettering and is a part of letters.
#pragma once

#include <vector>

#include "tactics/lettering/lettering_line.h"

namespace tactics {

/// A line as it was found at one level of grey.
struct FoundLine {
    LetteringLine line;
    int rank = 0;  ///< grey levels from the middle between letters and ground; the fewer the clearer
};

/// Grey levels, by which one place is clearer than another. A setting.
inline constexpr int kClearer = 24;

/// Boxes with words in them stand in line, too: their grounds look like letters of the other shade. The words themselves stay.
void drop_frames(std::vector<FoundLine>& found);

/// The distance of the line's level from the middle between letters and their ground, which is best; 256 if they hardly differ.
int off_middle(const Image& grey, const LetteringLine& line);

/// What lines enclose looks like large light letters, which would take the place of what is printed there.
void drop_enclosed(const Image& grey, std::vector<FoundLine>& found);

/// The holes of letters stand in line, too.
void drop_holes(const Image& grey, std::vector<FoundLine>& found);

/// A letter that is one piece where it is clear comes apart at deeper levels, as in a noisy scan or on a dark ground, and its
/// splinters look like a word. In small print they may as well be letters that touch, unless there are marks among them.
void drop_splinters(const Image& grey, std::vector<FoundLine>& found);

/// Where strokes are thin, a letter by itself comes apart at deeper levels, above and below: its halves are none.
void drop_halves(const Image& grey, std::vector<FoundLine>& found);

}  // namespace tactics
