// SPDX-License-Identifier: Apache-2.0
// The program `tactics-assimp`: Assimp with the frames of protocol.h. It reads only the given file and opens no other.
#include <assimp/BaseImporter.h>
#include <assimp/config.h>
#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <sys/mman.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <charconv>
#include <cmath>
#include <cstring>
#include <initializer_list>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tactics/mesh.h"
#include "tactics/readers/caged/serving.h"

namespace {

using namespace tactics::caged;
using tactics::CageLimits;
using tactics::Mesh;

constexpr std::size_t kMostNodes = 100'000;
constexpr int kMostDepth = 500;

// Whatever else a file asks for is not there: materials, textures, buffers beside it.
class NoOtherFiles final : public Assimp::IOSystem {
public:
    explicit NoOtherFiles(std::vector<std::string>& asked) : asked_(asked) {}
    bool Exists(const char* name) const override {
        remember(name);
        return false;
    }
    char getOsSeparator() const override { return '/'; }
    Assimp::IOStream* Open(const char* name, const char*) override {
        remember(name);
        return nullptr;
    }
    void Close(Assimp::IOStream*) override {}

private:
    void remember(const char* name) const {
        const std::string path(name), text = path.substr(path.find_last_of('/') + 1);
        if (asked_.size() < 3 && std::find(asked_.begin(), asked_.end(), text) == asked_.end()) asked_.push_back(text);
    }
    std::vector<std::string>& asked_;
};

// Only the importer of the format, so that no other is tried on what a stranger wrote.
void keep_importer(Assimp::Importer& importer, const std::string& format) {
    for (std::size_t i = importer.GetImporterCount(); i-- > 0;) {
        Assimp::BaseImporter* one = importer.GetImporter(i);
        const std::string extensions = ' ' + std::string(one->GetInfo()->mFileExtensions) + ' ';
        const bool first_gltf = std::string(one->GetInfo()->mName).find("glTF Importer") == 0;
        if (extensions.find(' ' + format + ' ') == std::string::npos || first_gltf) importer.UnregisterLoader(one);
    }
}

std::string name_of(const aiString& name) {
    std::string text(name.C_Str(), std::min<std::size_t>(name.length, tactics::kMostMeshName));
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c == 0x7F; }, ' ');
    // Assimp's, for a node of COLLADA without any, and for an OBJ.
    return text.starts_with("$ColladaAutoName$") || text == "defaultobject" ? std::string() : text;
}

struct Taken {
    Mesh mesh;
    std::vector<std::int32_t> parents;  // as many as there are parts
    bool upright = false;               // it is in metres with y upwards, as glTF has it, and Assimp makes of COLLADA
    std::size_t others = 0;             // points and lines, which have no surface
    std::size_t nodes = 0;
};

// Into the last part.
void take_mesh(const aiMesh& from, const aiMatrix4x4& to_world, Taken& taken) {
    Mesh& mesh = taken.mesh;
    if (mesh.vertices.size() + from.mNumVertices > tactics::kMostMeshVertices) fail("it has too many vertices");
    if (mesh.triangles.size() + from.mNumFaces > tactics::kMostMeshTriangles)
        fail("it has over " + std::to_string(tactics::kMostMeshTriangles) + " triangles");
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (unsigned i = 0; i < from.mNumVertices; ++i) {
        const aiVector3D at = to_world * from.mVertices[i];
        const std::array<double, 3> value{static_cast<double>(at.x), static_cast<double>(at.y), static_cast<double>(at.z)};
        for (const double one : value)
            if (!std::isfinite(one)) fail("a vertex is no number, in its part " + std::to_string(mesh.parts.size()));
        constexpr double kPerMetre = 1000;
        if (taken.upright)
            mesh.vertices.push_back({kPerMetre * value[0], -kPerMetre * value[2], kPerMetre * value[1]});
        else
            mesh.vertices.push_back({value[0], value[1], value[2]});
    }
    // A mirrored part would face inwards.
    const bool mirrored = to_world.Determinant() < 0;
    for (unsigned i = 0; i < from.mNumFaces; ++i) {
        const aiFace& face = from.mFaces[i];
        if (face.mNumIndices != 3) {
            ++taken.others;
            continue;
        }
        for (unsigned k = 0; k < 3; ++k)
            if (face.mIndices[k] >= from.mNumVertices) fail("a triangle has a vertex that is not there");
        mesh.triangles.push_back(
            {first + face.mIndices[0], first + face.mIndices[mirrored ? 2 : 1], first + face.mIndices[mirrored ? 1 : 2]});
    }
    mesh.parts.back().count = static_cast<std::uint32_t>(mesh.triangles.size()) - mesh.parts.back().first;
}

// A node with a name or with triangles is a part, unless there are none in it and its nodes. The root has the name of the file or
// of the scene. Each mesh of a node has another material, which is none of a finger's business.
void take_node(const aiScene& scene, const aiNode& node, const aiMatrix4x4& around, std::int32_t parent, int depth,
               Taken& taken) {
    if (++taken.nodes > kMostNodes || depth > kMostDepth) fail("its parts are nested too deep or too many");
    const aiMatrix4x4 to_world = around * node.mTransformation;
    Mesh& mesh = taken.mesh;
    const std::size_t part = mesh.parts.size(), triangles = mesh.triangles.size();
    std::string name = depth > 0 || node.mNumMeshes > 0 ? name_of(node.mName) : std::string();
    if (!name.empty() || node.mNumMeshes > 0) {
        if (part >= tactics::kMostMeshParts) fail("it has too many parts");
        mesh.parts.push_back({std::move(name), static_cast<std::uint32_t>(triangles), 0});
        taken.parents.push_back(parent);
        parent = static_cast<std::int32_t>(part);
    }
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
        if (node.mMeshes[i] >= scene.mNumMeshes) fail("");
        const aiMesh& from = *scene.mMeshes[node.mMeshes[i]];
        if (mesh.parts[part].name.empty()) mesh.parts[part].name = name_of(from.mName);
        take_mesh(from, to_world, taken);
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i) take_node(scene, *node.mChildren[i], to_world, parent, depth + 1, taken);
    if (mesh.triangles.size() == triangles) {
        mesh.parts.resize(part);
        taken.parents.resize(part);
    }
}

void put_word(const std::string& text) { put(Frame::word, text.data(), text.size()); }

void put_mesh(const Taken& taken, const std::vector<std::string>& asked) {
    const Mesh& mesh = taken.mesh;
    const MeshCounts counts{static_cast<std::uint32_t>(mesh.vertices.size()), static_cast<std::uint32_t>(mesh.triangles.size()),
                            static_cast<std::uint32_t>(mesh.parts.size()), static_cast<std::uint32_t>(mesh.up)};
    put(Frame::mesh, &counts, sizeof counts);
    for (std::size_t i = 0; i < mesh.parts.size(); ++i) {
        const PartFacts facts{mesh.parts[i].count, taken.parents[i]};
        put(Frame::part, &facts, sizeof facts);
        put_word(mesh.parts[i].name);
    }
    put(Frame::vertices, mesh.vertices.data(), mesh.vertices.size() * sizeof mesh.vertices[0]);
    put(Frame::triangles, mesh.triangles.data(), mesh.triangles.size() * sizeof mesh.triangles[0]);
    std::string note;
    for (const std::string& name : asked) note += (note.empty() ? "" : ", ") + name;
    put_word(note.empty() ? "" : "it asks for other files, which are not read: " + note);
    put_word(taken.others == 0 ? "" : std::to_string(taken.others) + " points and lines in it have no surface and are left out");
}

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

// Assimp does not terminate on a damaged PLY header. (The form: G. Turk, "The PLY polygon file format", 1994.)
void check_ply(std::string_view file) {
    constexpr std::size_t kMostHeader = 65'536;
    std::string_view rest = file.substr(0, kMostHeader);
    const auto next_word = [](std::string_view& line) {
        line.remove_prefix(std::min(line.find_first_not_of(" \t\r"), line.size()));
        const std::string_view word = line.substr(0, line.find_first_of(" \t\r"));
        line.remove_prefix(word.size());
        return word;
    };
    const auto is_type = [](std::string_view word) {
        return is_one_of(word, {"char", "uchar", "short", "ushort", "int", "uint", "float", "double", "int8", "uint8", "int16",
                                "uint16", "int32", "uint32", "float32", "float64"});
    };
    for (;;) {
        const auto end = rest.find('\n');
        if (end == std::string_view::npos) fail("its header has no end");
        std::string_view line = rest.substr(0, end);
        rest.remove_prefix(end + 1);
        const std::string_view word = next_word(line);
        if (word == "end_header") return;
        if (word == "element") {
            next_word(line);
            const std::string_view count = next_word(line);
            std::size_t value = 0;
            const auto [last, fault] = std::from_chars(count.data(), count.data() + count.size(), value);
            if (fault != std::errc() || last != count.data() + count.size()) fail("its header has a count that is no number");
            if (value > file.size()) fail("its header promises more than the file has");
        } else if (word == "property") {
            const std::string_view type = next_word(line);
            const bool list = type == "list" && is_type(next_word(line)) && is_type(next_word(line));
            if (!list && !is_type(type)) fail("its header has a property of no type");
            if (next_word(line).empty()) fail("its header has a property without a name");
        } else if (word == "format") {
            if (!is_one_of(next_word(line), {"ascii", "binary_little_endian", "binary_big_endian"})) fail("its form is unknown");
        } else if (!is_one_of(word, {"ply", "comment", "obj_info", ""})) {
            fail("its header makes no sense");
        }
    }
}

// Assimp has no word for it: it turns the root, which COLLADA's scenes do not, so that what was upwards is y.
tactics::UpAxis up_axis_of(const aiMatrix4x4& root) {
    const ai_real sum = std::abs(root.b1) + std::abs(root.b2) + std::abs(root.b3);
    return 2 * root.b1 > sum ? tactics::UpAxis::x : 2 * root.b3 > sum ? tactics::UpAxis::z : tactics::UpAxis::y;
}

void answer(const std::vector<std::string>& lines) {
    const std::string& format = lines[2];
    struct stat about {};
    if (lines[1] != "mesh" || fstat(kFile, &about) != 0 || about.st_size <= 0) fail("");
    const auto size = static_cast<std::size_t>(about.st_size);
    const void* mapped = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, kFile, 0);
    if (mapped == MAP_FAILED) fail("it cannot be read");
    if (format == "ply") check_ply({static_cast<const char*>(mapped), size});
    std::vector<std::string> asked;
    Assimp::Importer importer;
    keep_importer(importer, format);
    importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, true);  // not what the nodes refer to each other by
    importer.SetIOHandler(new NoOtherFiles(asked));                              // which is the importer's from here on
    const aiScene* scene = importer.ReadFileFromMemory(mapped, size, aiProcess_Triangulate, format.c_str());
    if (scene == nullptr || scene->mRootNode == nullptr) {
        std::string why = importer.GetErrorString();
        if (why == std::bad_alloc().what()) throw std::bad_alloc();
        if (!asked.empty()) why += " (it asks for other files, which are not read: " + asked.front() + ")";
        fail(why);
    }
    Taken taken;
    taken.upright = format == "gltf" || format == "glb" || format == "dae";
    if (taken.upright) taken.mesh.up = format == "dae" ? up_axis_of(scene->mRootNode->mTransformation) : tactics::UpAxis::y;
    take_node(*scene, *scene->mRootNode, aiMatrix4x4(), -1, 0, taken);
    if (taken.mesh.triangles.empty()) fail("it has no triangles");
    put_mesh(taken, asked);
}

// Five times what 5,000,000 triangles take of a processor: 4 s as PLY, 11 s as OBJ. Over a damaged PLY Assimp may go on without
// end.
CageLimits limits_for(const std::vector<std::string>& lines) {
    CageLimits limits;
    limits.processor_seconds = lines.size() > 2 && lines[2] == "ply" ? 20 : 55;
    return limits;
}

}  // namespace

int main() { serve_requests(answer, limits_for); }
