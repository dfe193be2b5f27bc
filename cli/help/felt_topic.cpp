// SPDX-License-Identifier: Apache-2.0
// `tactics help felt`: the container of heights and recordings, for who writes or reads it elsewhere.
#include "cli/help/topics.h"

namespace tactics {

namespace {

std::string layout() {
    return "A .felt file holds heights, or a recording of what a finger felt. encode,\n"
           "convert and relief write it, decode gives it back; convert, check, relief and\n"
           "play read its heights as they are, and play --device recorded:FILE.felt takes\n"
           "the way of its finger. Any part can be read without the rest.\n"
           "\n"
           "Layout, version 1. All numbers have their lowest byte first; a double is that of\n"
           "IEEE 754. Behind the place and the size of a field, in bytes:\n"
           "   0  8  89 46 45 4C 54 0D 0A 1A (hexadecimal)\n"
           "   8  1  version, 1\n"
           "   9  1  kind: 1 heights, 2 a recording\n"
           "  10  2  F, the bytes of facts\n"
           "  12  4  P, the number of parts\n"
           "  16  F  facts\n"
           "   .  8P index: of each part its size and its CRC-32, four bytes each\n"
           "   .  4  CRC-32 of all before it (ISO 3309, as in PNG and gzip)\n"
           "   .     the parts, one behind the other; the last ends the file\n"
           "\n"
           "Facts of heights, 46 bytes:\n"
           "   0  4  columns      4  4  rows, each 1 to 200000\n"
           "   8  8  pitch, mm   16  8  mm of black, and of level 0   24  8  mm of white\n"
           "  32  8  from one level to the next, mm (doubles, all four)\n"
           "  40  2  highest level, 1 to 65535, not above white\n"
           "  42  2  side of a tile, 1 to 4096 levels\n"
           "  44  1  lines are: 0 nothing told, 1 round, 2 flat\n"
           "  45  1  0\n"
           "A part is a tile, row by row from the upper left. Its first byte says how:\n"
           "  0  levels of as many bits as the highest needs, the first in the lowest bits\n"
           "  1  all of one level, 2 bytes\n"
           "  2  slope: what the median edge detector of LOCO-I misses, by rANS with a table\n"
           "     for each steepness (tactics/coding/slope_tile.cpp)\n"
           "  3  drawn: what followed the same eleven or six neighbours before, by adaptive\n"
           "     binary coding (tactics/coding/drawn_tile.cpp)\n"
           "\n"
           "Facts of a recording, 56 bytes:\n"
           "   0  4  ticks, at most 10 million\n"
           "   4  1  forces are guessed: 0 as they were told, 1 on a line\n"
           "   5  1  bit 0: heights of the finger; bit 1: forces in all directions, else\n"
           "         upwards alone\n"
           "   6  2  0\n"
           "   8  8  step of places, mm       16  8  step of forces, N\n"
           "  24  8  deadband, share of the force  32  8  its floor, N\n"
           "  40  8  work that may be given out too much, N mm\n"
           "  48  8  time of the first tick, microseconds\n"
           "A part is 4096 ticks, the last one fewer: the time of its first tick, 8 bytes,\n"
           "then decisions of adaptive binary coding (tactics/coding/recording.cpp). To find\n"
           "a time, halve: parts are in the order of their times.\n";
}

std::string coding() {
    return "Two pipelines (K. Moustakas, Handling haptics as a stand-alone medium, 2013).\n"
           "Strong, for any device: steps are the largest of 1, 0.1 ... 0.000001 mm and N in\n"
           "which the source is exact, heights have its levels, 65536 at most. Soft, for one\n"
           "device (--device): places and heights in steps of its resolution, forces in\n"
           "steps of 0.01 N, no larger than it gives.\n"
           "\n"
           "Deadband. A force is told where the guess would miss it by more than the share\n"
           "of its size, whatever its direction, or by more than the floor; else not. Told\n"
           "forces are those of the line through the last 16 ticks, by least squares, no\n"
           "more than half the threshold aside; with hold they are the forces themselves.\n"
           "Over no stretch of time do decoded forces give out more work than the true ones\n"
           "and the allowance: where a guess would, the force itself is told. That holds for\n"
           "a finger that goes the recorded way.\n"
           "\n"
           "HJIF, the JSON of MPEG haptics (ISO/IEC 23090-31), is not written. By the types\n"
           "of its public reference software (MPEGGroup/HapticReferenceSoftware; the text of\n"
           "the standard was not read) it holds effects: signals over time on parts of a\n"
           "body, in bands of keyframes with a place in time, one relative amplitude and a\n"
           "frequency, and devices that tell their greatest amplitude and displacement.\n"
           "Forces of three directions in N and the way of the finger that felt them have no\n"
           "field there, nor have heights over a plane. So neither could be read back.\n";
}

std::string text() { return layout() + "\n" + coding(); }

}  // namespace

extern const Topic felt_topic;
const Topic felt_topic{"felt", "what .felt files hold, byte by byte", text};

}  // namespace tactics
