// SPDX-License-Identifier: Apache-2.0
// Objects of a model by their names.
#pragma once

#include <string>

#include "tactics/model.h"

namespace tactics {

/// "Kitchen/Table/Top": of those that have a name.
std::string path_of(const Model& model, std::uint32_t object);

/// Whether it has that path, or one that ends in it, as "Top" for "Table/Top": by the names in the file, or by the plain names,
/// where a shape has no name apart from its object's ("Chair" of OB_Chair/ME_Chair).
bool is_named(const Model& model, std::uint32_t object, const std::string& path);

/// Only that object and what belongs to it. The path may begin anywhere: "Top"
/// is enough where there is one. Throws Error(usage), telling which there are.
Model part_named(const Model& model, const std::string& path);

}  // namespace tactics
