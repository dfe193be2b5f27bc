// SPDX-License-Identifier: Apache-2.0
// Textures that fill areas so that a finger can tell them apart. A visible list: textures.inc.
#pragma once

#include <span>
#include <string_view>

#include "tactics/text/phrase.h"

namespace tactics {

/// A mark is a dot, a dash or a line; marks stand in rows.
struct Texture {
    SourceWords name;         ///< "coarse dots": how it feels, for messages
    double width = 0;         ///< width of a mark, in widths of the medium's normal line
    double between_rows = 0;  ///< mm of white
    double along_row = 0;     ///< mm of white
    double length = 0;        ///< mm of a mark's middle line; 0 for a dot
    double degrees = 0;       ///< direction of the rows, clockwise from horizontal
    bool staggered = false;   ///< every second row begins half a step later
    std::string_view tile;    ///< for fixed dots: rows of # and . separated by /, repeated over the page

    bool endless() const { return length > 1e6; }
};

/// Minimum width of an area, mm, for its texture to be felt as such (L. Hasty, Designing Tactile Graphics: 1/4 in; good).
inline constexpr double kLeastTexture = 6.4;

/// Number n of Area::texture is textures()[n - 1].
std::span<const Texture> textures();

/// "coarse dots"; "a texture" for a number that is not in the list.
Phrase name_of_texture(int texture);

/// How different two textures feel, by their kinds, directions and distances; 0 for the same. Texture 0 is blank, and differs
/// more from every texture than any two textures differ.
double difference(int texture, int other);

/// Share of an area that is black on swell paper, 0 to 1; 0 for texture 0.
double share_black(int texture);

}  // namespace tactics
