// SPDX-License-Identifier: Apache-2.0
// What an area can be filled with so that a finger tells it from another. A visible list: textures.inc.
#pragma once

#include <span>
#include <string_view>

#include "tactics/text/phrase.h"

namespace tactics {

/// A mark is a dot, a dash or a line; marks stand in rows.
struct Texture {
    SourceWords name;         ///< "coarse dots": how it feels, as it is told
    double width = 0;         ///< of a mark, in widths of the medium's usual line
    double between_rows = 0;  ///< mm of white
    double along_row = 0;     ///< mm of white
    double length = 0;        ///< mm of a mark's middle line; 0 for a dot
    double degrees = 0;       ///< which way the rows run, clockwise from level
    bool staggered = false;   ///< every second row begins half a step later
    std::string_view tile;    ///< for fixed dots: rows of # and . parted by /, repeated over the page

    bool endless() const { return length > 1e6; }
};

/// mm across, so that it is felt as a texture of its own (L. Hasty, Designing Tactile Graphics: 1/4 in; good).
inline constexpr double kLeastTexture = 6.4;

/// Number n of Area::texture is textures()[n - 1].
std::span<const Texture> textures();

/// "coarse dots"; "a texture" for a number that is not in the list.
Phrase name_of_texture(int texture);

/// How different two feel, by their kinds, directions and distances; 0 for the same. Blank is texture 0, more different from
/// each than any two of them.
double difference(int texture, int other);

/// Share of an area that it blackens on swell paper, 0 to 1; 0 for texture 0.
double share_black(int texture);

}  // namespace tactics
