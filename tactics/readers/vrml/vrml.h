// SPDX-License-Identifier: Apache-2.0
// VRML97, VRML 1.0, Open Inventor's text and X3D as models with the names and shapes that they give.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tactics/model.h"
#include "tactics/readers/read.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// "VRML97 model", "VRML 1.0 model", "X3D model", "Inventor model" by its first bytes, which may be packed with gzip; empty: none
/// of these.
std::string_view vrml_format(std::string_view head);

/// They are in metres (X3D may give another unit) with y upwards, and are turned. LOD gives its finest level, Switch its visible
/// child. Scripts, lights, appearance and movements are ignored; `notes` list omitted things that matter: lines and texts, other
/// files (never opened), unknown nodes, broken faces. Throws Error(failed) at FILE:LINE for invalid format, a truncated file, a
/// passed limit (vrml/world.h, vrml/model_maker.cpp), or no faces.
Model read_vrml(Source& source, std::vector<Phrase>& notes);

}  // namespace tactics
