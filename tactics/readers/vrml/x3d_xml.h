// SPDX-License-Identifier: Apache-2.0
// X3D in XML (ISO/IEC 19776-1).
#pragma once

#include <string>
#include <string_view>

#include "tactics/readers/vrml/world.h"

namespace tactics {

/// As `read_classic_world`, within the limits of readers/xml.h, too.
World read_xml_world(std::string_view bytes, const std::string& file);

}  // namespace tactics
