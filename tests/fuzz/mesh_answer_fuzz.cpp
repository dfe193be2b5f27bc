// SPDX-License-Identifier: Apache-2.0
// Any bytes as what tactics-assimp answers, which had a stranger's model in it: an Error of one line, or a mesh as mesh.h has it.
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "tactics/error.h"
#include "tactics/readers/mesh_answer.h"

namespace {

void require(bool holds) {
    if (!holds) std::abort();
}

int descriptor_of(const std::uint8_t* data, std::size_t size) {
    const int file = memfd_create("answer", MFD_CLOEXEC);
    require(file >= 0);
    require(size == 0 || write(file, data, size) == static_cast<ssize_t>(size));
    require(lseek(file, 0, SEEK_SET) == 0);
    return file;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace tactics;
    CagedAnswer answer(descriptor_of(data, size));
    std::vector<Phrase> notes;
    try {
        const Mesh mesh = mesh_in(answer, "model", "PLY model", notes).mesh;
        require(!mesh.triangles.empty() && mesh.triangles.size() <= kMostMeshTriangles && mesh.parts.size() <= kMostMeshParts);
        require(mesh.vertices.size() * sizeof(Point3) <= size);
        for (const Point3& vertex : mesh.vertices) require(is_finite(vertex));
        for (const auto& triangle : mesh.triangles)
            for (const std::uint32_t vertex : triangle) require(vertex < mesh.vertices.size());
        std::uint64_t end = 0;
        for (const MeshPart& part : mesh.parts) {
            require(part.first == end && part.name.find('\n') == std::string::npos);
            end += part.count;
        }
        require(end <= mesh.triangles.size());
    } catch (const Error& error) {
        require(std::string(error.what()).find('\n') == std::string::npos);
    }
    return 0;
}
