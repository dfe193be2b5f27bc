// SPDX-License-Identifier: Apache-2.0
// Surfaces that a legend tells apart by their fill.
#pragma once

#include <cstddef>
#include <vector>

#include "tactics/readers/svg/found_page.h"

namespace tactics {

/// Each surface that is filled like one of these samples (looks of the page) gets a texture, another for each sample; black ones
/// stay black. The name of a sample stands at one of its surfaces only. Nothing where there are more kinds than textures, where
/// two surfaces of unlike fills lie on each other, or where one kind has no room for its texture.
void fill_as_legend(FoundPage& figure, std::vector<std::size_t> samples);

}  // namespace tactics
