// SPDX-License-Identifier: Apache-2.0
// The mesh that tactics-assimp answers with (caged/protocol.h). It comes from untrusted bytes, so nothing in it is trusted.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tactics/mesh.h"
#include "tactics/readers/caged_answer.h"
#include "tactics/text/phrase.h"

namespace tactics {

struct AnsweredMesh {
    Mesh mesh;
    std::vector<int> parents;  ///< of each part the place of that which it belongs to, always before its own, or -1
};

/// A mesh as mesh.h has it, with a triangle at least; parts that are groups have none. `notes`: what was left out. Throws
/// Error(failed) at `name`: a fault is told, or the answer makes no sense.
AnsweredMesh mesh_in(CagedAnswer& answer, const std::string& name, std::string_view format, std::vector<Phrase>& notes);

}  // namespace tactics
