// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/mesh_answer.h"

#include <algorithm>
#include <utility>

#include "tactics/error.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

class MeshAnswer {
public:
    MeshAnswer(CagedAnswer& answer, const std::string& name, std::string_view format)
        : answer_(answer), name_(name), format_(format) {}

    AnsweredMesh mesh(std::vector<Phrase>& notes) {
        caged::MeshCounts counts;
        require(answer_.read(caged::Frame::mesh, &counts, sizeof counts));
        if (counts.vertices > kMostMeshVertices || counts.triangles > kMostMeshTriangles || counts.parts > kMostMeshParts)
            fail(phrase("there is too much of it"));
        if (counts.up_axis > 2) fail(phrase("it makes no sense"));
        AnsweredMesh answered;
        Mesh& mesh = answered.mesh;
        mesh.up = static_cast<UpAxis>(counts.up_axis);
        std::uint64_t first = 0;
        for (std::uint32_t i = 0; i < counts.parts; ++i) {
            caged::PartFacts facts;
            require(answer_.read(caged::Frame::part, &facts, sizeof facts));
            MeshPart part{word(kMostMeshName), static_cast<std::uint32_t>(first), facts.triangles};
            first += facts.triangles;
            if (first > counts.triangles || facts.parent < -1 || facts.parent >= static_cast<std::int64_t>(i))
                fail(phrase("it makes no sense"));
            mesh.parts.push_back(std::move(part));
            answered.parents.push_back(facts.parent);
        }
        static_assert(sizeof(Point3) == 3 * sizeof(double));
        require(answer_.read(caged::Frame::vertices, mesh.vertices, counts.vertices));
        require(answer_.read(caged::Frame::triangles, mesh.triangles, counts.triangles));
        for (int i = 0; i < 2; ++i)
            if (std::string note = word(1000); !note.empty()) notes.push_back(std::move(note));
        check(mesh);
        return answered;
    }

private:
    void check(const Mesh& mesh) const {
        if (!std::all_of(mesh.vertices.begin(), mesh.vertices.end(), is_finite)) fail(phrase("a vertex is no number"));
        for (const auto& triangle : mesh.triangles)
            for (const std::uint32_t vertex : triangle)
                if (vertex >= mesh.vertices.size()) fail(phrase("a triangle has a vertex that is not there"));
        if (mesh.triangles.empty()) fail(phrase("it has no triangles"));
    }
    std::string word(std::size_t most) {
        std::string text;
        require(answer_.read(caged::Frame::word, text, most));
        return to_line(text);
    }
    void require(bool came) const {
        if (!came) fail(to_line(answer_.why()));
    }
    [[noreturn]] void fail(const Phrase& why) const {
        throw Error(Fault::failed, name_,
                    phrase("cannot be read as {0}: {1}; get a fresh copy or save the model as STL first", format_, why));
    }

    CagedAnswer& answer_;
    const std::string& name_;
    std::string_view format_;
};

}  // namespace

AnsweredMesh mesh_in(CagedAnswer& answer, const std::string& name, std::string_view format, std::vector<Phrase>& notes) {
    return MeshAnswer(answer, name, format).mesh(notes);
}

}  // namespace tactics
