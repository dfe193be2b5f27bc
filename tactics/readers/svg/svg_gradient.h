// SPDX-License-Identifier: Apache-2.0
// Gradients as one paint: on a page that is felt a surface is there or is not.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>

#include "tactics/readers/svg/svg_style.h"
#include "tactics/readers/xml.h"

namespace tactics {

/// Over its length, or its disc if it is radial. `all` are those whose stops it may take over by href; `colour` gives all that is
/// declared for a stop, the most particular last. Nothing: it has no stops.
std::optional<MeanPaint> mean_of_gradient(const Element& gradient, const std::map<std::string, const Element*, std::less<>>& all,
                                          const std::function<Declarations(const Element& stop)>& colour);

}  // namespace tactics
