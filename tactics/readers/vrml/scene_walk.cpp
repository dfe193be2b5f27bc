// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/vrml/scene_walk.h"

#include <algorithm>
#include <array>
#include <string>

#include "tactics/readers/vrml/resolved.h"
#include "tactics/readers/vrml/shape_of.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

using namespace std::string_view_literals;

enum class Part { group, transform, matrix, choice, levels, shape, elsewhere, nothing, unknown };

struct NamedPart {
    std::string_view type;
    Part part;
};
constexpr NamedPart kParts[] = {
    {"Group", Part::group},
    {"Transform", Part::transform},
    {"MatrixTransform", Part::matrix},
    {"Shape", Part::shape},
    {"Switch", Part::choice},
    {"LOD", Part::levels},
    {"Anchor", Part::group},
    {"Billboard", Part::group},
    {"Collision", Part::group},
    {"StaticGroup", Part::group},
    {"PickableGroup", Part::group},
    {"Layer", Part::group},
    {"LayerSet", Part::group},
    {"HAnimHumanoid", Part::transform},
    {"HAnimJoint", Part::transform},
    {"HAnimSite", Part::transform},
    {"HAnimSegment", Part::group},
    {"CADLayer", Part::group},
    {"CADAssembly", Part::group},
    {"CADPart", Part::transform},
    {"CADFace", Part::group},
    {"Inline", Part::elsewhere},
    {"WorldInfo", Part::nothing},
    {"NavigationInfo", Part::nothing},
    {"Script", Part::nothing},
    {"Fog", Part::nothing},
    {"LocalFog", Part::nothing},
    {"Sound", Part::nothing},
    {"AudioClip", Part::nothing},
    // A geometry or an appearance outside a Shape only serves for reuse in one.
    {"Appearance", Part::nothing},
    {"Material", Part::nothing},
    {"Coordinate", Part::nothing},
};
// ends of names
constexpr std::array kNothing{"Light"sv,    "Sensor"sv, "Interpolator"sv, "Viewpoint"sv,    "Background"sv,
                              "Follower"sv, "Filter"sv, "Sequencer"sv,    "Trigger"sv,      "Toggle"sv,
                              "Chaser"sv,   "Damper"sv, "Texture"sv,      "PhysicsModel"sv, "ViewpointGroup"sv};

Part part_of(std::string_view type) {
    for (const NamedPart& one : kParts)
        if (one.type == type) return one.part;
    const auto fits = [&](std::string_view end) { return type.ends_with(end); };
    if (type.starts_with("Metadata") || std::any_of(kNothing.begin(), kNothing.end(), fits)) return Part::nothing;
    return Part::unknown;
}

class SceneWalk {
public:
    SceneWalk(const World& world, ModelMaker& maker) : world_(world, maker), maker_(maker) {}

    void walk() {
        // y upwards and z towards who looks becomes z upwards and y away, metres become mm.
        const double mm = 1000 * world_.world().metre;
        const Placing upright{{mm, 0, 0}, {0, 0, mm}, {0, -mm, 0}, {0, 0, 0}};
        for (const std::uint32_t root : world_.world().roots) visit(root, nullptr, upright, 0);
    }

private:
    void visit(std::uint32_t node, const WorldFrame* frame, const Placing& placing, int depth) {
        const auto at = world_.resolve(node, frame);
        if (!at) return;
        const int line = at->node->line;
        if (depth > kMostWorldDepth)
            maker_.fail(line, phrase("groups are nested over {0} deep; save the model with fewer groups in groups",
                                     std::to_string(kMostWorldDepth)));
        const Part part = part_of(at->node->type);
        if (at->node->type == "WorldInfo") maker_.set_title(world_.text(*at, "title"), line);
        if (at->node->type == "Viewpoint" || at->node->type == "OrthoViewpoint")
            maker_.set_viewed_from(viewer_of(world_, *at, placing));
        if (part == Part::nothing) return;
        if (part == Part::elsewhere) {
            maker_.leave_out(
                "Inline of \"" + beginning_of(to_line(world_.text(*at, "url"))) + "\": no other file is read; take it by itself",
                line);
            return;
        }
        if (!world_.flag(*at, "visible", true)) return maker_.leave_out("what is not visible", line);
        if (part == Part::shape) return shape(*at, placing);
        const std::string name = name_of(*at);
        if (!name.empty()) maker_.begin_object(name, line);
        inside(*at, part,
               part == Part::transform ? placing * transform_of(world_, *at, "scale")
               : part == Part::matrix  ? placing * matrix_of(world_, *at)
                                       : placing,
               depth);
        if (!name.empty()) maker_.end_object();
    }

    // By DEF, or by what else names things for people.
    std::string name_of(const WorldPlace& at) {
        if (!at.name.empty()) return std::string(at.name);
        const std::string& type = at.node->type;
        if (type == "Anchor") return world_.text(at, "description");
        if (type.starts_with("HAnim") || type.starts_with("CAD")) return world_.text(at, "name");
        const auto about = world_.node(at, "metadata");
        if (!about || about->node->type != "MetadataString") return {};
        std::string key = world_.text(*about, "name");
        return key == "name" || key == "title" || key == "label" ? world_.text(*about, "value") : std::string();
    }

    void inside(const WorldPlace& at, Part part, const Placing& placing, int depth) {
        if (part == Part::unknown) {
            const bool has_inside = world_.find(at, "children").value != nullptr || !at.node->children.empty();
            maker_.leave_out(at.node->type + ", a node that is not known here" + (has_inside ? "; what is in it is kept" : ""),
                             at.node->line);
        }
        std::vector<std::pair<std::uint32_t, const WorldFrame*>> nodes;
        for (const std::string_view field : {"children"sv, "choice"sv, "level"sv, "skeleton"sv, "shape"sv, "layers"sv})
            if (const auto found = world_.find(at, field); found.value != nullptr)
                for (const std::uint32_t node : found.value->nodes) nodes.emplace_back(node, found.frame);
        for (const std::uint32_t node : at.node->children) nodes.emplace_back(node, at.frame);
        if (part == Part::choice || part == Part::levels) {
            const double chosen = part == Part::levels ? 0 : world_.number(at, "whichChoice", -1);
            const bool there = chosen >= 0 && chosen < static_cast<double>(nodes.size());
            if (part == Part::choice && nodes.size() > (there ? 1u : 0u))
                maker_.leave_out("what a Switch does not show", at.node->line);
            if (!there) return;
            nodes = {nodes[static_cast<std::size_t>(chosen)]};
        }
        for (const auto& [node, frame] : nodes) visit(node, frame, placing, depth + 1);
    }

    void shape(const WorldPlace& at, const Placing& placing) {
        const auto geometry = world_.node(at, "geometry");
        if (!geometry) return;
        const auto made = shape_of(world_, *geometry, maker_);
        if (!made) return;
        std::string name = name_of(at);
        const bool weak = name.empty();
        maker_.add_shape(*made, placing, weak ? std::string(geometry->name) : name, weak, geometry->node->line);
    }

    ResolvedWorld world_;
    ModelMaker& maker_;
};

}  // namespace

void walk_scene(const World& world, ModelMaker& maker) { SceneWalk(world, maker).walk(); }

}  // namespace tactics
