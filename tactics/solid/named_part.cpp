// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/named_part.h"

#include <algorithm>
#include <vector>

#include "tactics/error.h"
#include "tactics/text/words.h"

namespace tactics {

namespace {

bool ends_in_path(const std::string& path, const std::string& end) {
    if (!path.ends_with(end)) return false;
    return path.size() == end.size() || path[path.size() - end.size() - 1] == '/';
}

std::string spoken_path_of(const Model& model, std::uint32_t object) {
    std::string path, inner;
    for (int at = named_around(model, static_cast<int>(object)); at >= 0;) {
        const ModelObject& one = model.objects[static_cast<std::size_t>(at)];
        if (inner.empty() || !names_shape_of(inner, one.name)) {
            const std::string name = spoken_name(model, static_cast<std::size_t>(at));
            path = path.empty() ? name : name + "/" + path;
        }
        inner = one.name;
        at = named_around(model, one.parent);
    }
    return path;
}

}  // namespace

bool is_named(const Model& model, std::uint32_t object, const std::string& path) {
    return !model.objects[object].name.empty() &&
           (ends_in_path(path_of(model, object), path) || ends_in_path(spoken_path_of(model, object), path));
}

std::string path_of(const Model& model, std::uint32_t object) {
    std::string path;
    for (int at = static_cast<int>(object); at >= 0; at = model.objects[static_cast<std::size_t>(at)].parent) {
        const std::string& name = model.objects[static_cast<std::size_t>(at)].name;
        if (name.empty()) continue;
        path = path.empty() ? name : name + "/" + path;
    }
    return path;
}

Model part_named(const Model& model, const std::string& path) {
    std::vector<std::uint32_t> found;
    std::vector<std::string> paths;
    for (std::uint32_t i = 0; i < model.objects.size(); ++i) {
        if (model.objects[i].name.empty()) continue;
        paths.push_back(path_of(model, i));
        if (is_named(model, i, path)) found.push_back(i);
    }
    if (found.empty()) {
        std::vector<std::string_view> names(paths.begin(), paths.end());
        std::string some;
        for (std::size_t i = 0; i < std::min<std::size_t>(paths.size(), 8); ++i) some += (i == 0 ? "" : ", ") + paths[i];
        throw Error(Fault::usage, path,
                    paths.empty() ? phrase("the model has no such part; none of its objects has a name")
                    : paths.size() > 8
                        ? phrase("the model has no such part{0}; it has {1} and more", did_you_mean(path, names), some)
                        : phrase("the model has no such part{0}; it has {1}", did_you_mean(path, names), some));
    }
    // The shortest path is the thing itself, longer ones are parts of it.
    const std::uint32_t root = *std::min_element(found.begin(), found.end(), [&](std::uint32_t a, std::uint32_t b) {
        return path_of(model, a).size() < path_of(model, b).size();
    });
    Model part = model;
    part.objects.clear();
    std::vector<int> place(model.objects.size(), -1);
    for (std::uint32_t i = root; i < model.objects.size(); ++i) {
        const ModelObject& object = model.objects[i];
        const bool belongs = i == root || (object.parent >= 0 && place[static_cast<std::size_t>(object.parent)] >= 0);
        if (!belongs) continue;
        place[i] = static_cast<int>(part.objects.size());
        part.objects.push_back(object);
        part.objects.back().parent = i == root ? -1 : place[static_cast<std::size_t>(object.parent)];
    }
    return part;
}

}  // namespace tactics
