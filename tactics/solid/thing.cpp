// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/thing.h"

#include <algorithm>

#include "tactics/geometry/lots.h"
#include "tactics/solid/space_grid.h"

namespace tactics {

std::vector<std::uint32_t> things_of(const Model& model, const std::vector<ModelPart>& parts) {
    // Objects that hold the whole model between them do not tell one thing from
    // another.
    std::vector<std::uint32_t> children(model.objects.size(), 0), roots;
    for (std::uint32_t i = 0; i < model.objects.size(); ++i) {
        if (model.objects[i].parent >= 0)
            ++children[static_cast<std::size_t>(model.objects[i].parent)];
        else
            roots.push_back(i);
    }
    std::vector<bool> whole(model.objects.size(), false);
    if (roots.size() == 1 && model.objects[roots.front()].count == 0) {
        // Down to the object that branches.
        std::uint32_t at = roots.front();
        while (true) {
            whole[at] = children[at] == 1;
            if (!whole[at]) break;
            const auto child = std::find_if(model.objects.begin(), model.objects.end(),
                                            [&](const ModelObject& one) { return one.parent == static_cast<int>(at); });
            if (child == model.objects.end() || child->count > 0) break;
            at = static_cast<std::uint32_t>(child - model.objects.begin());
        }
    }
    const auto top = [&](std::uint32_t object) {
        while (model.objects[object].parent >= 0 && !whole[static_cast<std::size_t>(model.objects[object].parent)])
            object = static_cast<std::uint32_t>(model.objects[object].parent);
        // Things without a name are distinguished only by touch.
        const ModelObject& found = model.objects[object];
        return found.parent < 0 && found.name.empty() ? static_cast<std::uint32_t>(model.objects.size()) : object;
    };
    std::vector<std::uint32_t> tops;
    std::vector<SpaceBox> boxes;
    for (const ModelPart& part : parts) {
        tops.push_back(top(part.object));
        boxes.push_back(space_of(part));
    }
    const auto reach = [&](std::uint32_t part) { return kLoose * parts[part].box.half[0]; };
    const SpaceGrid near(boxes);
    Lots lots(parts.size());
    for (std::uint32_t a = 0; a < parts.size(); ++a)
        near.any_near(grown(boxes[a], reach(a)), [&](std::uint32_t b) {
            if (a != b && tops[a] == tops[b] && lots.find(a) != lots.find(b) &&
                apart(boxes[a], boxes[b]) <= std::min(reach(a), reach(b)))
                lots.join(a, b);
            return false;
        });
    std::vector<std::uint32_t> of(parts.size());
    for (std::uint32_t a = 0; a < parts.size(); ++a) of[a] = lots.find(a);
    return of;
}

}  // namespace tactics
