// SPDX-License-Identifier: Apache-2.0
// Chooses a texture for each class of a picture.
#pragma once

#include <vector>

namespace tactics {

/// The texture of each class (0: blank), all different. The choice maximises, summed over all borders, their length times the
/// difference of the textures on both sides, so that neighbours differ most. Of choices within 2 % of the best, darker classes
/// get textures with more ink. `border[a][b]`: mm that classes a and b share. `grey`: 0 black to 255. At most as many classes as
/// there are textures and blank.
std::vector<int> choose_textures(const std::vector<std::vector<double>>& border, const std::vector<double>& grey);

}  // namespace tactics
