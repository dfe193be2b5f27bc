// SPDX-License-Identifier: Apache-2.0
// Models of every kind: VRML and X3D (vrml/) and STL by readers of ours, OBJ, PLY, glTF and COLLADA by Assimp, which is in a
// program of its own (caged/protocol.h).
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/mesh.h"
#include "tactics/model.h"
#include "tactics/readers/read.h"
#include "tactics/readers/stl.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// "STL model", "OBJ model", ... by its bytes or, if those do not show it, by the ending of its name; empty: no model. Rewinds
/// it.
std::string_view model_format(Source& source);

/// STL, OBJ and PLY have no unit and are taken as mm, and z as upwards; the others are in metres with y upwards by their
/// standards (COLLADA and X3D may say another unit, COLLADA another axis), and are turned. Files referenced by the model are not
/// read. `notes`: omitted parts. Throws Error(failed) for invalid format, invalid numbers, no triangles or too many, or if the
/// program is missing.
Mesh read_mesh(Source& source, std::vector<Phrase>& notes);

/// The same with all object data of the file. For formats that have only triangles, these are the faces. `up`: the axis of the
/// file that shall point upwards; none: the one that the file names or its format implies.
Model read_model(Source& source, std::vector<Phrase>& notes, std::optional<UpAxis> up = {});

/// By its name, as `model_format` gives it: it says how large things are.
bool has_unit(std::string_view format);

/// Visits all triangles, in the same order each time. Those of an STL are read anew each time and not stored.
using Triangles = std::function<void(const std::function<void(const Triangle&)>& take)>;
/// The source must outlive it.
Triangles triangles_of(Source& source, std::vector<Phrase>& notes, std::optional<UpAxis> up = {});

}  // namespace tactics
