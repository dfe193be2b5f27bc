// SPDX-License-Identifier: Apache-2.0
// What passes between the program and `tactics-openimageio`, which reads what strangers wrote with libraries that break on it.
// Linking OpenImageIO costs 0.2 s at every start, so that program is started with the first file that needs it, loads it once and
// then makes a copy of itself for each file (fork), which shuts itself in (transport/cage.h), answers and ends.
//
// A request is one packet of lines and two descriptors, the file and the pipe to answer in. An answer is frames of the
// machine's own numbers; both are of one build.
//
//   version, "inspect", format            -> facts
//   version, "read", format, key ...      -> facts, a word for each key (empty if the file has none), rows till the last
//   version, "write", format, key, word ...  (the file is a WritingPlan and its samples)  -> file
//
// Wherever a frame is expected, `fault` may come with a line of text, or the answer may just end.
#pragma once

#include <cstdint>

namespace tactics::caged {

/// Goes up with every change of this file.
inline constexpr char kVersion[] = "3";
inline constexpr const char* kProgram = "tactics-openimageio";
inline constexpr int kSocket = 3;  ///< the program's descriptor of requests
inline constexpr std::uint32_t kMostRequest = 4096;

enum class Frame : std::uint32_t { facts = 1, word, rows, file, fault };

struct FrameHead {
    Frame kind{};
    std::uint32_t size = 0;  ///< bytes that follow
};

struct Facts {
    std::int32_t width = 0;
    std::int32_t height = 0;
    std::int32_t colours = 0;      ///< 1 grey, 3 red green blue
    std::int32_t alpha = 0;        ///< behind the colours: 0 none, 1 straight, 2 premultiplied
    std::int32_t linear = 0;       ///< samples are 0: unsigned char, sRGB-coded; 1: float, linear light
    std::int32_t orientation = 0;  ///< 1 to 8 as in EXIF
    std::int32_t batch = 0;        ///< rows in a frame, from the top, without padding; the last may have fewer
};

struct WritingPlan {
    std::int32_t width = 0;
    std::int32_t height = 0;
};

}  // namespace tactics::caged
