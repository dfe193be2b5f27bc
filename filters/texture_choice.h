// SPDX-License-Identifier: Apache-2.0
// Which classes of a picture get which texture.
#pragma once

#include <vector>

namespace tactics {

/// Texture of each class (0: blank), all different, so that what is added up over all borders, their length times the
/// difference of the textures on both sides, is greatest: neighbours differ most. Of choices that are as good within 2 % the one
/// in which darker classes get textures with more ink. `border[a][b]`: mm that classes a and b share. `grey`: 0 black to 255.
/// At most as many classes as there are textures and blank.
std::vector<int> choose_textures(const std::vector<std::vector<double>>& border, const std::vector<double>& grey);

}  // namespace tactics
