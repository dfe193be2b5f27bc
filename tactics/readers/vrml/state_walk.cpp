// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/vrml/state_walk.h"

#include <algorithm>
#include <array>
#include <string>

#include "tactics/readers/vrml/resolved.h"
#include "tactics/readers/vrml/shape.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

using namespace std::string_view_literals;

/// What a node inherits.
struct DrawingState {
    Placing placing;
    std::span<const double> points{};
    bool ordered = false, clockwise = false, solid = false;  // ShapeHints
    double unit = 1;                                         // metres
};

class StateWalk;
using Visit = void (StateWalk::*)(const WorldPlace& at, int depth);

class StateWalk {
public:
    StateWalk(const World& world, ModelMaker& maker) : world_(world, maker), maker_(maker) {
        constexpr double kMm = 1000;
        state_.placing = {{kMm, 0, 0}, {0, 0, kMm}, {0, -kMm, 0}, {0, 0, 0}};
        upright_ = state_.placing;
    }

    void walk() {
        for (const std::uint32_t root : world_.world().roots) visit(root, nullptr, 0);
    }

private:
    void visit(std::uint32_t node, const WorldFrame* frame, int depth);

    // Groups with a name are objects. `show` visits what is in it.
    template <typename Show>
    void named(const WorldPlace& at, const Show& show) {
        const bool link = at.name.empty() && at.node->type == "WWWAnchor";
        const std::string name = link ? world_.text(at, "description") : std::string(at.name);
        if (!name.empty()) maker_.begin_object(name, at.node->line);
        show();
        if (!name.empty()) maker_.end_object();
    }
    void child(const WorldPlace& at, std::size_t which, int depth) { visit(at.node->children[which], at.frame, depth + 1); }
    void group(const WorldPlace& at, int depth) {
        named(at, [&] {
            for (std::size_t i = 0; i < at.node->children.size(); ++i) child(at, i, depth);
        });
    }
    void separator(const WorldPlace& at, int depth) {
        const DrawingState before = state_;
        group(at, depth);
        state_ = before;
    }
    void transform_separator(const WorldPlace& at, int depth) {
        const Placing before = state_.placing;
        group(at, depth);
        state_.placing = before;
    }
    void choice(const WorldPlace& at, int depth) {
        const std::size_t count = at.node->children.size();
        const double chosen = world_.number(at, "whichChild", -1);
        constexpr double kAll = -3;
        if (chosen == kAll) return group(at, depth);
        const bool there = chosen >= 0 && chosen < static_cast<double>(count);
        if (count > (there ? 1u : 0u)) maker_.leave_out("what a Switch does not show", at.node->line);
        if (there) named(at, [&] { child(at, static_cast<std::size_t>(chosen), depth); });
    }
    void levels(const WorldPlace& at, int depth) {
        const DrawingState before = state_;
        if (!at.node->children.empty()) named(at, [&] { child(at, 0, depth); });
        state_ = before;
    }
    void elsewhere(const WorldPlace& at, int) {
        maker_.leave_out(at.node->type + " of \"" + beginning_of(to_line(world_.text(at, "name"))) +
                             "\": no other file is read; take it by itself",
                         at.node->line);
    }

    void place(const Placing& inner) { state_.placing = state_.placing * inner; }
    void transform(const WorldPlace& at, int) { place(transform_of(world_, at, "scaleFactor")); }
    void translation(const WorldPlace& at, int) { place(moved(world_.point(at, "translation", {}))); }
    void scale(const WorldPlace& at, int) { place(scaled(world_.point(at, "scaleFactor", {1, 1, 1}))); }
    void rotation(const WorldPlace& at, int) {
        const auto turn = world_.turn(at, "rotation");
        place(turned(turn.axis, turn.angle));
    }
    void rotation_about(const WorldPlace& at, int) {
        const std::string axis = world_.text(at, "axis");
        const Point3 about = axis == "Z" ? Point3{0, 0, 1} : axis == "Y" ? Point3{0, 1, 0} : Point3{1, 0, 0};
        place(turned(about, world_.number(at, "angle", 0)));
    }
    void matrix(const WorldPlace& at, int) { place(matrix_of(world_, at)); }
    void reset(const WorldPlace&, int) { state_.placing = upright_; }
    void units(const WorldPlace& at, int);

    void coordinates(const WorldPlace& at, int) { state_.points = world_.numbers(at, "point"); }
    void hints(const WorldPlace& at, int) {
        const auto has = [&](std::string_view field, std::string_view word) {
            const auto found = world_.find(at, field);
            return found.value != nullptr &&
                   std::find(found.value->words.begin(), found.value->words.end(), word) != found.value->words.end();
        };
        state_.clockwise = has("vertexOrdering", "CLOCKWISE");
        state_.ordered = state_.clockwise || has("vertexOrdering", "COUNTERCLOCKWISE") || has("hints", "ORDERED");
        state_.solid = has("shapeType", "SOLID") || has("hints", "SOLID");
    }

    void add(const WorldPlace& at, const WorldShape& shape) {
        maker_.add_shape(shape, state_.placing, at.name, false, at.node->line);
    }
    bool sized(const WorldPlace& at, std::initializer_list<double> lengths) {
        return maker_.has_size(at.node->type, at.node->line, lengths);
    }
    void cube(const WorldPlace& at, int) {
        const Point3 size{world_.number(at, "width", 2), world_.number(at, "height", 2), world_.number(at, "depth", 2)};
        if (maker_.has_sides("Cube", at.node->line, size)) add(at, make_box(size));
    }
    void sphere(const WorldPlace& at, int) {
        const double radius = world_.number(at, "radius", 1);
        if (sized(at, {radius})) add(at, make_sphere(radius));
    }
    RoundParts parts(const WorldPlace& at) const {
        const auto found = world_.find(at, "parts");
        if (found.value == nullptr) return {};
        const auto has = [&](std::string_view word) {
            const auto& words = found.value->words;
            return std::find(words.begin(), words.end(), word) != words.end() ||
                   std::find(words.begin(), words.end(), "ALL") != words.end();
        };
        return {has("SIDES"), has("BOTTOM"), has("TOP")};
    }
    void cone(const WorldPlace& at, int) {
        const double radius = world_.number(at, "bottomRadius", 1), height = world_.number(at, "height", 2);
        if (sized(at, {radius, height})) add(at, make_cone(radius, height, parts(at)));
    }
    void cylinder(const WorldPlace& at, int) {
        const double radius = world_.number(at, "radius", 1), height = world_.number(at, "height", 2);
        if (sized(at, {radius, height})) add(at, make_cylinder(radius, height, parts(at)));
    }

    std::span<const double> points(const WorldPlace& at) {
        const auto own = world_.node(at, "vertexProperty");
        return own ? world_.numbers(*own, "vertex") : state_.points;
    }
    void faces(const WorldPlace& at, std::span<const double> indices) {
        const auto all = points(at);
        maker_.spend(10 * indices.size() + all.size(), at.node->line);
        WorldShape shape = make_faces(all, indices);
        if (state_.clockwise) shape.turn_inside_out();
        shape.one_sided = state_.ordered && state_.solid;
        add(at, shape);
    }
    void indexed_faces(const WorldPlace& at, int) { faces(at, world_.numbers(at, "coordIndex")); }
    void indexed_strips(const WorldPlace& at, int) { faces(at, faces_in(world_.numbers(at, "coordIndex"), FaceRuns::strips)); }
    // Open Inventor's FaceSet: so many points each, one after another.
    void faces_in_order(const WorldPlace& at, int) {
        const double count = static_cast<double>(points(at).size() / 3);
        std::vector<double> indices;
        double next = world_.number(at, "startIndex", 0);
        if (!(next >= 0)) maker_.fail(at.node->line, phrase("startIndex is below 0; save the model again"));
        for (double corners : world_.numbers(at, "numVertices")) {
            if (corners < 0) corners = count - next;
            for (; corners >= 1 && next < count; --corners) indices.push_back(next++);
            indices.push_back(-1);
        }
        faces(at, indices);
    }
    void no_faces(const WorldPlace& at, int) { maker_.leave_out(at.node->type + ", which has no faces", at.node->line); }
    void nothing(const WorldPlace&, int) {}
    void camera(const WorldPlace& at, int) { maker_.set_viewed_from(viewer_of(world_, at, state_.placing)); }
    void unknown(const WorldPlace& at, int depth) {
        maker_.leave_out(
            at.node->type + ", a node that is not known here" + (at.node->children.empty() ? "" : "; what is in it is kept"),
            at.node->line);
        separator(at, depth);
    }
    static Visit visit_of(std::string_view type);

    ResolvedWorld world_;
    ModelMaker& maker_;
    DrawingState state_;
    Placing upright_;
};

// Open Inventor's; of VRML 1.0 all are in metres. The sizes are those of the international yard of 1959 and of the point of
// PostScript.
void StateWalk::units(const WorldPlace& at, int) {
    struct NamedLength {
        std::string_view name;
        double metres;
    };
    constexpr double kInch = 0.0254;
    constexpr NamedLength kUnits[] = {
        {"METERS", 1},          {"CENTIMETERS", 1e-2}, {"MILLIMETERS", 1e-3},    {"MICROMETERS", 1e-6},   {"MICRONS", 1e-6},
        {"NANOMETERS", 1e-9},   {"ANGSTROMS", 1e-10},  {"KILOMETERS", 1e3},      {"FEET", 12 * kInch},    {"INCHES", kInch},
        {"POINTS", kInch / 72}, {"YARDS", 36 * kInch}, {"MILES", 63360 * kInch}, {"NAUTICAL_MILES", 1852}};
    const std::string name = world_.text(at, "units");
    for (const NamedLength& one : kUnits) {
        if (one.name != name) continue;
        const double factor = one.metres / state_.unit;
        place(scaled({factor, factor, factor}));
        state_.unit = one.metres;
    }
}

Visit StateWalk::visit_of(std::string_view type) {
    struct NamedVisit {
        std::string_view type;
        Visit visit;
    };
    static constexpr NamedVisit kVisits[] = {{"Separator", &StateWalk::separator},
                                             {"Group", &StateWalk::group},
                                             {"TransformSeparator", &StateWalk::transform_separator},
                                             {"Switch", &StateWalk::choice},
                                             {"LOD", &StateWalk::levels},
                                             {"LevelOfDetail", &StateWalk::levels},
                                             {"WWWAnchor", &StateWalk::separator},
                                             {"WWWInline", &StateWalk::elsewhere},
                                             {"File", &StateWalk::elsewhere},
                                             {"Transform", &StateWalk::transform},
                                             {"Translation", &StateWalk::translation},
                                             {"Rotation", &StateWalk::rotation},
                                             {"RotationXYZ", &StateWalk::rotation_about},
                                             {"Scale", &StateWalk::scale},
                                             {"MatrixTransform", &StateWalk::matrix},
                                             {"ResetTransform", &StateWalk::reset},
                                             {"Units", &StateWalk::units},
                                             {"Coordinate3", &StateWalk::coordinates},
                                             {"ShapeHints", &StateWalk::hints},
                                             {"Cube", &StateWalk::cube},
                                             {"Sphere", &StateWalk::sphere},
                                             {"Cone", &StateWalk::cone},
                                             {"Cylinder", &StateWalk::cylinder},
                                             {"IndexedFaceSet", &StateWalk::indexed_faces},
                                             {"IndexedTriangleStripSet", &StateWalk::indexed_strips},
                                             {"FaceSet", &StateWalk::faces_in_order},
                                             {"PointSet", &StateWalk::no_faces},
                                             {"LineSet", &StateWalk::no_faces},
                                             {"IndexedLineSet", &StateWalk::no_faces},
                                             {"AsciiText", &StateWalk::no_faces},
                                             {"Text2", &StateWalk::no_faces},
                                             {"Text3", &StateWalk::no_faces}};
    for (const NamedVisit& one : kVisits)
        if (one.type == type) return one.visit;
    constexpr std::array kLooks{"Info"sv,       "Label"sv,       "BaseColor"sv,      "PackedColor"sv, "DrawStyle"sv,
                                "LightModel"sv, "Environment"sv, "Font"sv,           "FontStyle"sv,   "Complexity"sv,
                                "PickStyle"sv,  "Normal"sv,      "VertexProperty"sv, "Background"sv,  "NavigationInfo"sv,
                                "Fog"sv,        "WorldInfo"sv};
    constexpr std::array kBeginnings{"Material"sv, "Texture"sv, "NormalB"sv};
    if (type.ends_with("Camera")) return &StateWalk::camera;
    constexpr std::array kEnds{"Light"sv, "Binding"sv};
    const bool looks = std::find(kLooks.begin(), kLooks.end(), type) != kLooks.end() ||
                       std::any_of(kBeginnings.begin(), kBeginnings.end(), [&](auto word) { return type.starts_with(word); }) ||
                       std::any_of(kEnds.begin(), kEnds.end(), [&](auto word) { return type.ends_with(word); });
    return looks ? &StateWalk::nothing : &StateWalk::unknown;
}

void StateWalk::visit(std::uint32_t node, const WorldFrame* frame, int depth) {
    const auto at = world_.resolve(node, frame);
    if (!at) return;
    if (depth > kMostWorldDepth)
        maker_.fail(at->node->line, phrase("groups are nested over {0} deep; save the model with fewer groups in groups",
                                           std::to_string(kMostWorldDepth)));
    (this->*visit_of(at->node->type))(*at, depth);
}

}  // namespace

void walk_states(const World& world, ModelMaker& maker) { StateWalk(world, maker).walk(); }

}  // namespace tactics
