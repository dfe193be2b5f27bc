// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/model.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <memory>

#include "tactics/error.h"
#include "tactics/geometry/triangulate.h"
#include "tactics/readers/caged_answer.h"
#include "tactics/readers/descriptor_copy.h"
#include "tactics/readers/mesh_answer.h"
#include "tactics/readers/vrml/vrml.h"

namespace tactics {

namespace {

using namespace std::string_view_literals;

struct Form {
    std::string_view name;
    std::string_view extension;  // also what Assimp calls it
};
constexpr Form kForms[] = {
    {"OBJ model", "obj"}, {"PLY model", "ply"}, {"glTF model", "gltf"}, {"glTF model", "glb"}, {"COLLADA model", "dae"}};
constexpr Form kStl{"STL model", "stl"};
// Read by us, too.
constexpr Form kWorlds[] = {{"VRML97 model", "wrl"}, {"VRML 1.0 model", "wrl"}, {"Inventor model", "iv"}, {"X3D model", "x3d"}};

bool is_world(const Form* form) { return form >= std::begin(kWorlds) && form < std::end(kWorlds); }

bool ends_in(std::string_view name, std::string_view extension) {
    if (name.size() <= extension.size() || name[name.size() - extension.size() - 1] != '.') return false;
    return std::equal(extension.begin(), extension.end(), name.end() - static_cast<std::ptrdiff_t>(extension.size()),
                      [](char a, unsigned char b) { return a == std::tolower(b); });
}

// The first lines have the words of a Wavefront OBJ at their beginning, and one of them is a vertex.
bool is_obj(std::string_view text) {
    constexpr std::array kWords{"v"sv, "vn"sv, "vt"sv, "vp"sv, "f"sv, "l"sv, "p"sv, "o"sv, "g"sv, "s"sv, "mtllib"sv, "usemtl"sv};
    bool vertex = false;
    while (!text.empty()) {
        const auto end = text.find('\n');
        const std::string_view line = text.substr(0, end);
        if (end == std::string_view::npos) break;  // cut, or the last: enough has been seen
        text.remove_prefix(end + 1);
        const auto begin = line.find_first_not_of(" \t\r");
        if (begin == std::string_view::npos || line[begin] == '#') continue;
        const std::string_view word = line.substr(begin, line.find_first_of(" \t\r", begin) - begin);
        if (std::find(kWords.begin(), kWords.end(), word) == kWords.end()) return false;
        vertex = vertex || (word == "v" && line.find_first_of("0123456789") != std::string_view::npos);
    }
    return vertex;
}

// An object whose asset has a version (glTF 2.0, section 3.2). Its name stands near the beginning, or after much else.
bool is_gltf(std::string_view text) {
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    const auto begin = text.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos || text[begin] != '{') return false;
    const auto asset = text.find("\"asset\"");
    return asset != std::string_view::npos && text.find("\"version\"") != std::string_view::npos;
}

// The first element, behind a declaration, comments and what entities a DOCTYPE may have. In UTF-16 each letter has a byte 0.
bool is_collada(std::string_view head) {
    std::string text(head);
    std::erase(text, '\0');
    const auto begin = text.find('<');
    return begin <= text.find_first_of("abcdefghijklmnopqrstuvwxyz{#") && text.find("<COLLADA") != std::string::npos;
}

const Form* form_of(Source& source) {
    if (source.file == nullptr) return nullptr;
    std::array<char, 4096> head{};
    std::rewind(source.file.get());
    const std::string_view text(head.data(), std::fread(head.data(), 1, head.size(), source.file.get()));
    std::rewind(source.file.get());
    const Form* found = nullptr;
    if (text.starts_with("ply\n") || text.starts_with("ply\r")) found = &kForms[1];
    if (text.starts_with("glTF")) found = &kForms[3];
    if (found == nullptr && is_gltf(text)) found = &kForms[2];
    if (found == nullptr && is_collada(text)) found = &kForms[4];
    if (const std::string_view world = vrml_format(text); !world.empty())
        found = std::find_if(std::begin(kWorlds), std::end(kWorlds), [&](const Form& form) { return form.name == world; });
    if (found == nullptr && is_obj(text)) found = &kForms[0];
    if (found == nullptr && is_stl(source)) found = &kStl;
    std::rewind(source.file.get());
    // Names are asked last: what is in a file counts.
    const bool silent = found == nullptr && (text.empty() || text[0] == '{' || text[0] == '#' || ends_in(source.name, "obj"));
    if (silent)
        for (const Form& form : kForms)
            if (ends_in(source.name, form.extension)) found = &form;
    return found;
}

// For Assimp the name of an object in OBJ ends at its first blank, and objects of one name are one.
constexpr std::string_view kJoined = "\xC2\xA0";  // U+00A0, a blank that joins

// Copies an OBJ with the blanks within names of objects joined; `to` may be null. True: there were some.
bool join_names(std::FILE* from, std::FILE* to) {
    enum class In { beginning, keyword, before_name, name, gap, rest } in = In::beginning;
    bool joined = false;
    std::rewind(from);
    for (int c = std::getc(from); c != EOF; c = std::getc(from)) {
        const bool is_blank = c == ' ' || c == '\t';
        if (c == '\n' || c == '\r') {
            in = In::beginning;
        } else if (is_blank) {
            if (in == In::keyword) in = In::before_name;
            if (in == In::name) in = In::gap;
        } else {
            if (in == In::gap) {
                joined = true;
                if (to != nullptr) std::fwrite(kJoined.data(), 1, kJoined.size(), to);
            }
            in = in == In::beginning && c == 'o'                            ? In::keyword
                 : in == In::before_name || in == In::name || in == In::gap ? In::name
                                                                            : In::rest;
        }
        if (to != nullptr && in != In::gap) std::putc(c, to);
    }
    return joined;
}

AnsweredMesh read_with_assimp(Source& source, const Form& form, std::vector<Phrase>& notes) {
    std::FILE* file = source.file.get();
    TemporaryFile copy(nullptr, &std::fclose);
    const bool joined = &form == &kForms[0] && join_names(file, nullptr);
    if (joined || fileno(file) < 0) {
        copy = joined ? temporary_file() : with_descriptor(file);
        if (joined && copy != nullptr) {
            join_names(file, copy.get());
            if (std::fflush(copy.get()) != 0 || std::ferror(copy.get()) != 0) copy.reset();
        }
        file = copy.get();
        if (file == nullptr)
            throw Error(Fault::failed, source.name, phrase("cannot be kept in a temporary file; make room for it"));
    }
    CagedAnswer answer(source.name, CagedRequest{"mesh", form.extension, {}, fileno(file), &caged::kAssimp});
    AnsweredMesh read = mesh_in(answer, source.name, form.name, notes);
    for (MeshPart& part : read.mesh.parts)
        for (std::size_t at = 0; joined && (at = part.name.find(kJoined, at)) != std::string::npos;)
            part.name.replace(at, kJoined.size(), " ");
    return read;
}

}  // namespace

std::string_view model_format(Source& source) {
    const Form* form = form_of(source);
    return form == nullptr ? std::string_view() : form->name;
}

Mesh read_mesh(Source& source, std::vector<Phrase>& notes) {
    const Form* form = form_of(source);
    if (form == nullptr)
        throw Error(Fault::failed, source.name, phrase("is no model; take a file of VRML, X3D, STL, OBJ, PLY, glTF or COLLADA"));
    if (is_world(form)) return mesh_of(read_vrml(source, notes), source.name);
    Mesh mesh;
    if (form != &kStl) {
        mesh = read_with_assimp(source, *form, notes).mesh;
        std::erase_if(mesh.parts, [](const MeshPart& part) { return part.count == 0; });
        return mesh;
    }
    each_triangle(source, [&](const Triangle& triangle) {
        if (mesh.triangles.size() == kMostMeshTriangles)
            throw Error(Fault::failed, source.name,
                        phrase("has over {0} triangles; make it coarser first", std::to_string(kMostMeshTriangles)));
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (const auto& corner : triangle.corners) mesh.vertices.push_back({corner[0], corner[1], corner[2]});
        mesh.triangles.push_back({first, first + 1, first + 2});
    });
    return mesh;
}

namespace {

Model read_model_as_it_is(Source& source, std::vector<Phrase>& notes) {
    const Form* form = form_of(source);
    if (is_world(form)) return read_vrml(source, notes);
    if (form == nullptr || form == &kStl) return model_of(read_mesh(source, notes), true);
    auto [mesh, parents] = read_with_assimp(source, *form, notes);
    Model model = model_of(std::move(mesh), false);
    for (std::size_t i = 0; i < parents.size(); ++i) model.objects[i].parent = parents[i];
    return model;
}

}  // namespace

Model read_model(Source& source, std::vector<Phrase>& notes, std::optional<UpAxis> up) {
    Model model = read_model_as_it_is(source, notes);
    if (!up || *up == model.up) return model;
    const auto turn = [&](Point3& at) { at = turned_up(at, model.up, *up); };
    for (Point3& at : model.vertices) turn(at);
    for (ModelObject& object : model.objects)
        for (Point3* at : {&object.frame.middle, &object.frame.a, &object.frame.b, &object.frame.c}) turn(*at);
    turn(model.viewed_from);
    model.up = *up;
    return model;
}

bool has_unit(std::string_view format) {
    constexpr std::array kWithout{"STL model"sv, "OBJ model"sv, "PLY model"sv};
    return std::find(kWithout.begin(), kWithout.end(), format) == kWithout.end();
}

Triangles triangles_of(Source& source, std::vector<Phrase>& notes, std::optional<UpAxis> up) {
    if (form_of(source) == &kStl && up.value_or(UpAxis::z) == UpAxis::z)
        return [&source](const auto& take) { each_triangle(source, take); };
    const auto mesh = std::make_shared<const Mesh>(read_mesh(source, notes));
    return [mesh, to = up.value_or(mesh->up)](const auto& take) {
        for (const auto& corners : mesh->triangles) {
            Triangle triangle;
            for (std::size_t k = 0; k < 3; ++k) {
                const Point3 at = turned_up(mesh->vertices[corners[k]], mesh->up, to);
                triangle.corners[k] = {at.x, at.y, at.z};
            }
            take(triangle);
        }
    };
}

}  // namespace tactics
