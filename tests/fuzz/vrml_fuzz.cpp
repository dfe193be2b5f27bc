// SPDX-License-Identifier: Apache-2.0
// Any bytes as VRML and X3D: a model that is sound and can be cut into triangles, or one line of what is wrong.
#include <cstdint>
#include <cstdlib>

#include "tactics/error.h"
#include "tactics/geometry/triangulate.h"
#include "tactics/readers/vrml/vrml.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace tactics;
    if (size == 0) return 0;
    vrml_format({reinterpret_cast<const char*>(data), size});
    try {
        Source source = memory_source({data, size}, "fuzz.wrl");
        std::vector<Phrase> notes;
        const Model model = read_vrml(source, notes);
        for (const Point3& vertex : model.vertices)
            if (!is_finite(vertex)) std::abort();
        for (const std::uint32_t corner : model.corners)
            if (corner >= model.vertices.size()) std::abort();
        std::size_t faces = 0, triangles = 0;
        for (std::size_t i = 0; i < model.objects.size(); ++i) {
            const ModelObject& object = model.objects[i];
            if (object.parent >= static_cast<int>(i) || object.name.size() > kMostModelName) std::abort();
            if (object.first + object.count > model.faces.size()) std::abort();
            faces += object.count;
        }
        for (const ModelFace& face : model.faces) {
            if (face.count < 3 || face.first + face.count > model.corners.size()) std::abort();
            triangles += face.count - 2;
        }
        if (faces != model.faces.size() || faces == 0) std::abort();
        if (triangles < 100'000 && mesh_of(model, "fuzz.wrl").triangles.size() != triangles) std::abort();
        for (const Phrase& note : notes)
            if (note.empty() || note.english().find('\n') != std::string::npos) std::abort();
    } catch (const Error& error) {
        const std::string what = error.what();
        if (!what.starts_with("fuzz.wrl") || what.find('\n') != std::string::npos) std::abort();
    }
    return 0;
}
