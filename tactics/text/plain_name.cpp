// SPDX-License-Identifier: Apache-2.0
#include "tactics/text/plain_name.h"

#include <algorithm>
#include <vector>

#include "tactics/text/utf8.h"

namespace tactics {

namespace {

// Marks that no person gives: they say what kind of entry of the file it is.
//   OB_ and ME_: an object and its mesh, in Blender's exporters of VRML 97 and X3D (export_x3d.py, uuid_cache_object and
//     uuid_cache_mesh; castle_vrml97.wrl and the kitchen of Simox have both); there the point before the number of a copy, too,
//     becomes a line below, as ids of VRML have no points.
//   _TRANSFORM: an object's transform, in the same exporter since Blender 2.6.
//   -FACES: the polygons of an object, in 3ds Max's exporter of VRML 97 (desk.wrl).
//   group_ME_: the group of a mesh's shapes, in the exporter of X3D (car.x3d).
constexpr std::string_view kObject = "OB_", kMesh = "ME_", kGroup = "group_ME_", kTransform = "_TRANSFORM", kFaces = "-FACES";
// Autodesk Maya: barShape, bar1Shape or barShape1 are the shapes of bar or bar1. "Shape" is a word, too, and therefore a mark
// only beside the object's own name.
constexpr std::string_view kShape = "Shape";

std::string_view without_digits(std::string_view name) {
    while (!name.empty() && is_digit(name.back())) name.remove_suffix(1);
    return name;
}

// Chair.001: Blender numbers copies so, with three digits or more. Chair (1): so does Unity.
std::string_view without_copy(std::string_view name, bool marked) {
    const std::string_view rest = without_digits(name);
    const std::size_t digits = name.size() - rest.size();
    if (digits >= 3 && rest.size() > 1 && (rest.ends_with('.') || (marked && rest.ends_with('_'))))
        return rest.substr(0, rest.size() - 1);
    if (!name.ends_with(')')) return name;
    const std::string_view inner = without_digits(name.substr(0, name.size() - 1));
    const bool numbered = inner.size() + 1 < name.size() && inner.ends_with(" (") && inner.size() > 2;
    return numbered ? inner.substr(0, inner.size() - 2) : name;
}

bool is_lower(char c) { return c >= 'a' && c <= 'z'; }
bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }

// Positions where a lower-case letter or a digit precedes a capital; none if a word would be too short.
std::vector<std::size_t> humps_of(std::string_view word) {
    constexpr std::size_t kShortest = 3;
    std::vector<std::size_t> humps = {0};
    for (std::size_t i = 1; i < word.size(); ++i)
        if (is_upper(word[i]) && (is_lower(word[i - 1]) || is_digit(word[i - 1]))) humps.push_back(i);
    humps.push_back(word.size());
    for (std::size_t i = 0; i + 1 < humps.size(); ++i)
        if (letters_in(word.substr(humps[i], humps[i + 1] - humps[i])) < kShortest) return {0, word.size()};
    return humps;
}

}  // namespace

std::string plain_name(std::string_view name) {
    std::string_view plain = name;
    for (const std::string_view mark : {kGroup, kObject, kMesh})
        if (plain.starts_with(mark)) plain.remove_prefix(mark.size());
    for (const std::string_view mark : {kTransform, kFaces})
        if (plain.ends_with(mark)) plain.remove_suffix(mark.size());
    plain = without_copy(plain, plain.size() < name.size());
    return std::string(plain.empty() ? name : plain);
}

bool names_shape_of(std::string_view inner, std::string_view outer) {
    const std::string shape = plain_name(inner), object = plain_name(outer);
    if (shape == object || ((inner.starts_with(kMesh) || inner.starts_with(kGroup)) && outer.starts_with(kObject))) return true;
    const std::string_view digits = std::string_view(shape).substr(without_digits(shape).size());
    std::string_view rest = without_digits(shape);
    if (!rest.ends_with(kShape)) return false;
    rest.remove_suffix(kShape.size());
    if (rest.ends_with('_')) rest.remove_suffix(1);
    return std::string(rest) + std::string(digits) == object;
}

std::string name_as_words(std::string_view name) {
    if (name.find(' ') != std::string_view::npos) return to_line(name);
    std::string words;
    while (!name.empty()) {
        const std::string_view word = name.substr(0, name.find('_'));
        name.remove_prefix(std::min(word.size() + 1, name.size()));
        const std::vector<std::size_t> humps = humps_of(word);
        for (std::size_t i = 0; i + 1 < humps.size(); ++i)
            words += (words.empty() ? "" : " ") + std::string(word.substr(humps[i], humps[i + 1] - humps[i]));
    }
    return to_line(words);
}

}  // namespace tactics
