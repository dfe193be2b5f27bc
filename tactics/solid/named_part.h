// SPDX-License-Identifier: Apache-2.0
// Objects of a model by their names.
#pragma once

#include <string>

#include "tactics/model.h"

namespace tactics {

/// "Kitchen/Table/Top": of those that have a name.
std::string path_of(const Model& model, std::uint32_t object);

/// A path, or the end of one: "Top" of "Table/Top".
bool ends_in_path(const std::string& path, const std::string& end);

/// Only that object and what belongs to it. The path may begin anywhere: "Top"
/// is enough where there is one. Throws Error(usage), telling which there are.
Model part_named(const Model& model, const std::string& path);

}  // namespace tactics
