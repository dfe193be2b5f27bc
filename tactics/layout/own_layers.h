// SPDX-License-Identifier: Apache-2.0
// Which layer of our SVG a thing of a page is in, and what is drawn there by a person.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tactics/page.h"

namespace tactics {

/// By its role and its width on the page's medium.
std::string_view layer_of(const PageStroke& stroke, const Page& page);
std::string_view layer_of(const Area& area);

/// Changes with any of their points.
std::string mark_of(const std::vector<Area>& areas);

/// How wide the lines of a layer are on the medium of that name, mm; 0: on none that is known.
double width_in_layer(std::string_view layer, std::string_view medium);
/// What a line is for that a person draws in that layer.
Role role_in_layer(std::string_view layer);

}  // namespace tactics
