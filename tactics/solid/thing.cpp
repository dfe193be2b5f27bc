// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/thing.h"

#include <algorithm>

#include "tactics/geometry/lots.h"
#include "tactics/solid/space_box.h"

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
        return object;
    };
    Lots lots(parts.size());
    std::vector<SpaceBox> boxes;
    for (const ModelPart& part : parts) boxes.push_back(space_of(part));
    for (std::uint32_t a = 0; a < parts.size(); ++a)
        for (std::uint32_t b = a + 1; b < parts.size(); ++b)
            if (lots.find(a) != lots.find(b) && top(parts[a].object) == top(parts[b].object) &&
                apart(boxes[a], boxes[b]) <= kLoose * std::min(parts[a].box.half[0], parts[b].box.half[0]))
                lots.join(a, b);
    std::vector<std::uint32_t> of(parts.size());
    for (std::uint32_t a = 0; a < parts.size(); ++a) of[a] = lots.find(a);
    return of;
}

}  // namespace tactics
