// SPDX-License-Identifier: Apache-2.0
// VRML97, VRML 1.0 and Inventor files read by our reader and by Coin, the reader of those who made the format (Debian:
// libcoin-dev; BSD-3-Clause; no part of the program). A line a file: shapes and polygons of both, how many shapes have the same
// name, and by how much their boxes and areas differ at most, as a part of the shape's own size.
//
//   coin_models FILE...        ends with 1 if any file differs
//
// Coin draws round things with other sides, so that their boxes may differ by 3 % and their areas by 5 %, and cuts bent faces as
// it likes (10 %); all others by 1e-4, as it reckons in single precision. Faces that we leave out, having no area, are among
// Coin's polygons.
#include <Inventor/SoDB.h>
#include <Inventor/SoInput.h>
#include <Inventor/SoPrimitiveVertex.h>
#include <Inventor/VRMLnodes/SoVRMLIndexedFaceSet.h>
#include <Inventor/VRMLnodes/SoVRMLInline.h>
#include <Inventor/actions/SoCallbackAction.h>
#include <Inventor/errors/SoDebugError.h>
#include <Inventor/errors/SoReadError.h>
#include <Inventor/misc/SoProtoInstance.h>
#include <Inventor/nodes/SoIndexedFaceSet.h>
#include <Inventor/nodes/SoSeparator.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "tactics/error.h"
#include "tactics/readers/vrml/vrml.h"

namespace {

using tactics::Point3;

struct Seen {
    std::string name;
    bool round = false, text = false;
    bool bent = false;  // a face of more than three corners, which may be cut either way
    std::size_t polygons = 0;
    Point3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
    double area = 0;

    void reach(const Point3& at) {
        low = {std::min(low.x, at.x), std::min(low.y, at.y), std::min(low.z, at.z)};
        high = {std::max(high.x, at.x), std::max(high.y, at.y), std::max(high.z, at.z)};
    }
};

// Whatever has a name, nearest to the shape; that of a geometry in a Shape is none of an object.
std::string name_of(const SoPath& path) {
    for (int i = path.getLength() - 1; i >= 0; --i) {
        SoNode* node = path.getNode(i);
        const bool in_shape = i > 0 && path.getNode(i - 1)->getTypeId().getName() == "VRMLShape";
        if (!in_shape && node->getName().getLength() > 0) return node->getName().getString();
        SoProtoInstance* instance = SoProtoInstance::findProtoInstance(node);
        if (instance != nullptr && instance->getName().getLength() > 0) return instance->getName().getString();
    }
    return {};
}

std::size_t polygons_of(const SoNode* node) {
    const SoMFInt32* index = nullptr;
    if (node->isOfType(SoVRMLIndexedFaceSet::getClassTypeId()))
        index = &static_cast<const SoVRMLIndexedFaceSet*>(node)->coordIndex;
    if (node->isOfType(SoIndexedFaceSet::getClassTypeId())) index = &static_cast<const SoIndexedFaceSet*>(node)->coordIndex;
    if (index == nullptr) return 0;
    std::size_t count = 0;
    for (int i = 0; i < index->getNum(); ++i) count += (*index)[i] >= 0 && (i + 1 == index->getNum() || (*index)[i + 1] < 0);
    return count;
}

SoCallbackAction::Response begin_shape(void* user, SoCallbackAction* action, const SoNode* node) {
    auto& shapes = *static_cast<std::vector<Seen>*>(user);
    Seen& seen = shapes.emplace_back();
    seen.name = name_of(*action->getCurPath());
    const std::string type = node->getTypeId().getName().getString();
    seen.text = type.find("Text") != std::string::npos;
    for (const char* const round : {"Sphere", "Cone", "Cylinder"})
        seen.round = seen.round || type.find(round) != std::string::npos;
    seen.polygons = polygons_of(node);
    return SoCallbackAction::CONTINUE;
}

void triangle(void* user, SoCallbackAction* action, const SoPrimitiveVertex* a, const SoPrimitiveVertex* b,
              const SoPrimitiveVertex* c) {
    Seen& seen = static_cast<std::vector<Seen>*>(user)->back();
    Point3 corners[3];
    for (int i = 0; i < 3; ++i) {
        SbVec3f at;
        action->getModelMatrix().multVecMatrix((i == 0 ? a : i == 1 ? b : c)->getPoint(), at);
        corners[i] = 1000 * Point3{static_cast<double>(at[0]), -static_cast<double>(at[2]), static_cast<double>(at[1])};
        seen.reach(corners[i]);
    }
    seen.area += length_of(cross(corners[1] - corners[0], corners[2] - corners[0])) / 2;
}

std::vector<Seen> by_coin(const char* path) {
    std::vector<Seen> shapes;
    SoInput input;
    if (!input.openFile(path)) return shapes;
    SoSeparator* root = SoDB::readAll(&input);
    if (root == nullptr) return shapes;
    root->ref();
    SoCallbackAction action;
    action.addPreCallback(SoShape::getClassTypeId(), begin_shape, &shapes);
    action.addTriangleCallback(SoShape::getClassTypeId(), triangle, &shapes);
    // Other files are none of ours.
    action.addPreCallback(
        SoVRMLInline::getClassTypeId(), [](void*, SoCallbackAction*, const SoNode*) { return SoCallbackAction::PRUNE; }, nullptr);
    action.apply(root);
    root->unref();
    std::erase_if(shapes, [](const Seen& seen) { return seen.area == 0 || seen.text; });
    return shapes;
}

std::vector<Seen> by_us(const char* path, std::vector<tactics::Phrase>& notes) {
    tactics::Source source = tactics::open_source(path);
    const tactics::Model model = tactics::read_vrml(source, notes);
    std::vector<Seen> shapes;
    for (const tactics::ModelObject& object : model.objects) {
        if (object.count == 0) continue;
        Seen& seen = shapes.emplace_back();
        const tactics::ModelObject* named = &object;
        while (named->name.empty() && named->parent >= 0) named = &model.objects[static_cast<std::size_t>(named->parent)];
        seen.name = named->name;
        seen.polygons = object.count;
        seen.round = object.primitive != tactics::Primitive::none && object.primitive != tactics::Primitive::box;
        for (std::uint32_t i = object.first; i < object.first + object.count; ++i) {
            const tactics::ModelFace& face = model.faces[i];
            Point3 twice;
            double parts = 0;
            const auto at = [&](std::uint32_t k) { return model.vertices[model.corners[face.first + k]]; };
            for (std::uint32_t k = 0; k < face.count; ++k) {
                seen.reach(at(k));
                if (k < 2) continue;
                const Point3 part = cross(at(k - 1) - at(0), at(k) - at(0));
                twice = twice + part;
                parts += length_of(part);
            }
            seen.area += length_of(twice) / 2;
            seen.bent = seen.bent || parts > length_of(twice) * (1 + 1e-6);
        }
    }
    return shapes;
}

bool compare(const char* path) {
    std::vector<tactics::Phrase> notes;
    std::vector<Seen> ours;
    std::string fault;
    try {
        ours = by_us(path, notes);
    } catch (const tactics::Error& error) {
        fault = error.what();
    }
    const std::vector<Seen> theirs = by_coin(path);
    const std::string_view name = std::string_view(path).substr(std::string_view(path).find_last_of('/') + 1);
    if (!fault.empty() || ours.size() != theirs.size()) {
        std::printf("%.*s: %zu shapes, by Coin %zu; %s\n", static_cast<int>(name.size()), name.data(), ours.size(), theirs.size(),
                    fault.c_str());
        return ours.empty() && theirs.empty();
    }
    std::size_t polygons = 0, coin_polygons = 0, names = 0, counted = 0, told = 0;
    double box = 0, area = 0;
    bool alike = true;
    for (std::size_t i = 0; i < ours.size(); ++i) {
        const Seen &a = ours[i], &b = theirs[i];
        names += a.name == b.name;
        if (b.polygons > 0) {
            ++counted;
            polygons += a.polygons;
            coin_polygons += b.polygons;
        }
        const double size = length_of(b.high - b.low),
                     off = std::max(length_of(a.low - b.low), length_of(a.high - b.high)) / size,
                     more = std::abs(a.area - b.area) / b.area;
        const bool same = off < (b.round ? 0.03 : 1e-4) && more < (a.bent ? 0.1 : b.round ? 0.05 : 1e-4) && a.round == b.round;
        constexpr std::size_t kTold = 5;  // shapes of a file
        if ((!same || a.name != b.name) && told++ < kTold)
            std::printf("  shape %zu (%s): \"%s\" by Coin; box %.1e, area %.1e\n", i + 1, a.name.c_str(), b.name.c_str(), off,
                        more);
        alike = alike && same;
        box = std::max(box, off);
        area = std::max(area, more);
    }
    std::printf(
        "%.*s: %zu shapes, %zu with the same name; of %zu face sets %zu polygons, by Coin %zu; boxes within %.1e, areas %.1e%s\n",
        static_cast<int>(name.size()), name.data(), ours.size(), names, counted, polygons, coin_polygons, box, area,
        alike ? "" : "  DIFFERS");
    for (const tactics::Phrase& note : notes) std::printf("  %s\n", note.english().c_str());
    return alike;
}

}  // namespace

int main(int count, char** words) {
    SoDB::init();
    SoDebugError::setHandlerCallback([](const SoError*, void*) {}, nullptr);
    SoReadError::setHandlerCallback(
        [](const SoError* error, void*) {
            const std::string why = error->getDebugString().getString();
            if (why.find("texture") == std::string::npos) std::printf("  Coin: %s\n", why.c_str());
        },
        nullptr);
    bool alike = true;
    for (int i = 1; i < count; ++i) alike = compare(words[i]) && alike;
    return alike ? 0 : 1;
}
