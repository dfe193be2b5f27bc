// SPDX-License-Identifier: Apache-2.0
// K-means of a colour picture, by how different colours look (CIELAB).
#pragma once

#include "tactics/image.h"

namespace tactics {

/// Gives each pixel the mean colour of its class, of at most `k` classes. Colours that differ by less than 8 levels in
/// every channel may be taken as one. There is no chance in it: the start is cut from the picture itself.
Image kmeans_colour(Image image, int k);

}  // namespace tactics
