// SPDX-License-Identifier: Apache-2.0
// The protocol between the main program and `tactics-openimageio` and `tactics-assimp`, which read untrusted files with fragile
// libraries. Linking OpenImageIO costs 0.2 s at every start, so such a program starts with the first file that needs it, loads
// its library once and then forks for each file; the child isolates itself (transport/cage.h), answers and ends.
//
// A request is one packet of lines and two descriptors, the file and the pipe to answer in. An answer is frames of the
// machine's own numbers; both are of one build.
//
//   version, "inspect", format            -> facts
//   version, "read", format, key ...      -> facts, a word for each key (empty if the file has none), rows till the last
//   version, "mesh", format               -> mesh, a part and its name (word) for each, vertices, triangles, notes (word)
//   version, "write", format, key, word ...  (the file is a WritingPlan and its samples)  -> file
//
// Wherever a frame is expected, `fault` may come with a line of text, or the answer may just end.
#pragma once

#include <cstdint>

namespace tactics::caged {

/// Increase it with every change of this file.
inline constexpr char kVersion[] = "6";
struct Program {
    const char* name;
    const char* instead;  ///< what to do without it
};
inline constexpr Program kOpenImageIo{"tactics-openimageio", "convert the picture to PNG first"};
inline constexpr Program kAssimp{"tactics-assimp", "save the model as STL first"};
inline constexpr int kSocket = 3;  ///< the program's descriptor of requests
inline constexpr std::uint32_t kMostRequest = 4096;

enum class Frame : std::uint32_t { facts = 1, word, rows, file, fault, mesh, part, vertices, triangles };

struct FrameHead {
    Frame kind{};
    std::uint32_t size = 0;  ///< bytes that follow
};

struct Facts {
    std::int32_t width = 0;
    std::int32_t height = 0;
    std::int32_t colours = 0;      ///< 1 grey, 3 red green blue
    std::int32_t alpha = 0;        ///< after the colours: 0 none, 1 straight, 2 premultiplied
    std::int32_t linear = 0;       ///< samples are 0: unsigned char, sRGB-coded; 1: float, linear light
    std::int32_t orientation = 0;  ///< 1 to 8 as in EXIF
    std::int32_t batch = 0;        ///< rows in a frame, from the top, without padding; the last may have fewer
};

struct MeshCounts {
    std::uint32_t vertices = 0;   ///< three doubles each, mm: x to the right, y away, z upwards
    std::uint32_t triangles = 0;  ///< three places of vertices each
    std::uint32_t parts = 0;      ///< one after another
    std::uint32_t up_axis = 2;    ///< the axis that its file has upwards: 0 x, 1 y, 2 z
};

struct PartFacts {
    std::uint32_t triangles = 0;  ///< none of a group, which other parts are in
    std::int32_t parent = -1;     ///< the part that it is in, always one before it; -1: none
};

struct WritingPlan {
    std::int32_t width = 0;
    std::int32_t height = 0;
};

}  // namespace tactics::caged
