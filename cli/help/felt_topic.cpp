// SPDX-License-Identifier: Apache-2.0
// `tactics help felt`: the container of heights and recordings, for who writes or reads it elsewhere.
#include "cli/help/topics.h"

namespace tactics {

namespace {

std::string felt_layout() {
    return "A .felt file holds heights, or a recording of what a finger felt. encode,\n"
           "convert and relief write it, decode unpacks it; convert, check, relief and play\n"
           "read its heights directly, and play --device recorded:FILE.felt replays the\n"
           "path of its finger. Any part can be read without the rest.\n"
           "\n"
           "Layout, version 1. All numbers have the lowest byte first; a double is an IEEE\n"
           "754 double. Each line gives the offset of a field, its size in bytes, and its\n"
           "contents:\n"
           "   0  8  89 46 45 4C 54 0D 0A 1A (hexadecimal)\n"
           "   8  1  version, 1\n"
           "   9  1  kind: 1 heights, 2 a recording\n"
           "  10  2  F, the number of bytes of facts\n"
           "  12  4  P, the number of parts\n"
           "  16  F  facts\n"
           "   .  8P index: for each part its size and its CRC-32, four bytes each\n"
           "   .  4  CRC-32 of everything before it (ISO 3309, as in PNG and gzip)\n"
           "   .     the parts, one after the other; the last ends the file\n"
           "\n"
           "Facts of heights, 46 bytes:\n"
           "   0  4  columns      4  4  rows, each 1 to 200000\n"
           "   8  8  pitch, mm   16  8  mm of black, and of level 0   24  8  mm of white\n"
           "  32  8  from one level to the next, mm (doubles, all four)\n"
           "  40  2  highest level, 1 to 65535, not above white\n"
           "  42  2  side of a tile, 1 to 4096 levels\n"
           "  44  1  lines are: 0 unknown, 1 round, 2 flat\n"
           "  45  1  0\n"
           "Parts are tiles, row by row from the upper left. The first byte gives the\n"
           "coding:\n"
           "  0  levels with as many bits as the highest needs, the first in the lowest bits\n"
           "  1  a single level, 2 bytes\n"
           "  2  slope: what the median edge detector of LOCO-I misses, by rANS with a table\n"
           "     for each steepness (tactics/coding/slope_tile.cpp)\n"
           "  3  drawn: what followed the same eleven or six neighbours before, by adaptive\n"
           "     binary coding (tactics/coding/drawn_tile.cpp)\n"
           "\n"
           "Facts of a recording, 56 bytes:\n"
           "   0  4  ticks, at most 10 million\n"
           "   4  1  how forces are predicted: 0 as the last stored one, 1 on a line\n"
           "   5  1  bit 0: heights of the finger; bit 1: forces in all directions, else\n"
           "         only upwards\n"
           "   6  2  0\n"
           "   8  8  step of places, mm       16  8  step of forces, N\n"
           "  24  8  deadband, share of the force  32  8  its floor, N\n"
           "  40  8  allowance of excess work, N mm\n"
           "  48  8  time of the first tick, microseconds\n"
           "A part holds 4096 ticks, the last one fewer: the time of its first tick, 8\n"
           "bytes, then decisions of adaptive binary coding (tactics/coding/recording.cpp).\n"
           "Parts are in order of time, so a binary search finds a time.\n";
}

std::string coding() {
    return "Two pipelines (K. Moustakas, Handling haptics as a stand-alone medium, 2013).\n"
           "Strong, for any device: the steps are the largest of 1, 0.1 ... 0.000001 mm and\n"
           "N that represent the source exactly; heights keep the source's levels, at most\n"
           "65536. Soft, for one device (--device): places and heights in steps of its\n"
           "resolution, forces in steps of 0.01 N, no larger than it can give.\n"
           "\n"
           "Deadband. A force is stored only where the prediction would miss it by more\n"
           "than the share of its size, whatever its direction, or by more than the floor.\n"
           "The stored force is that of the least-squares line through the last 16 ticks,\n"
           "kept within half the threshold of the true force; with hold it is the force\n"
           "itself. Over no stretch of time do the decoded forces give out more work than\n"
           "the true ones plus the allowance: where a prediction would, the force itself is\n"
           "stored. This holds for a finger that follows the recorded path.\n"
           "\n"
           "tactics does not write HJIF, the JSON of MPEG haptics (ISO/IEC 23090-31).\n"
           "According to the types in its public reference software\n"
           "(MPEGGroup/HapticReferenceSoftware; the text of the standard was not read), it\n"
           "holds effects: signals over time on parts of a body, as bands of keyframes with\n"
           "a time, one relative amplitude and a frequency, and devices that state their\n"
           "greatest amplitude and displacement. It has no field for forces of three\n"
           "directions in N, for the path of the finger that felt them, or for heights over\n"
           "a plane. So neither could be read back.\n";
}

std::string felt_text() { return felt_layout() + "\n" + coding(); }

}  // namespace

extern const Topic felt_topic;
const Topic felt_topic{"felt", "what .felt files hold, byte by byte", felt_text};

}  // namespace tactics
