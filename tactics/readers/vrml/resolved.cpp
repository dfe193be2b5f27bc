// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/vrml/resolved.h"

#include "tactics/text/utf8.h"

namespace tactics {

namespace {

constexpr std::size_t kResolving = 100;  // steps, as one is a comparison of names

}  // namespace

std::optional<WorldPlace> ResolvedWorld::resolve(std::uint32_t place, const WorldFrame* frame) {
    WorldPlace at{&world_.nodes[place], frame, world_.nodes[place].name};
    while (true) {
        const WorldNode& node = *at.node;
        maker_.spend(kResolving, node.line);
        if (node.undefined || node.within_itself) {
            const char* why = node.undefined ? ", which is not defined before" : " within itself, which would have no end";
            maker_.leave_out("USE of \"" + beginning_of(to_line(node.name)) + '"' + why, node.line);
            return std::nullopt;
        }
        if (node.use >= 0) {
            at.node = &world_.nodes[static_cast<std::size_t>(node.use)];
        } else if (node.proto >= 0) {
            const WorldProto& proto = world_.protos[static_cast<std::size_t>(node.proto)];
            if (proto.external) {
                maker_.leave_out(
                    "what EXTERNPROTO " + beginning_of(to_line(proto.name)) + " stands for in another file; others are not read",
                    node.line);
                return std::nullopt;
            }
            if (proto.body.empty()) return std::nullopt;
            const int depth = at.frame == nullptr ? 1 : at.frame->depth + 1;
            if (depth > kMostWorldDepth)
                maker_.fail(node.line, phrase("PROTOs are made of each other over {0} deep; save the model without them",
                                              std::to_string(kMostWorldDepth)));
            at.frame = &frames_.emplace_back(WorldFrame{&proto, &node, at.frame, depth});
            at.node = &world_.nodes[proto.body[0]];
            if (at.name.empty()) at.name = at.node->name.empty() ? std::string_view(proto.name) : at.node->name;
        } else {
            return at;
        }
    }
}

ResolvedWorld::Found ResolvedWorld::find(const WorldPlace& at, std::string_view field) const {
    maker_.spend(at.node->fields.size() + 1, at.node->line);
    Found found{field_of(*at.node, field), at.frame};
    while (found.value != nullptr && !found.value->is.empty()) {
        if (found.frame == nullptr) return {};
        const std::string_view name = found.value->is;
        const WorldFrame* frame = found.frame;
        maker_.spend(frame->instance->fields.size() + frame->proto->defaults.size() + 1, at.node->line);
        found = {field_of(*frame->instance, name), frame->outer};
        if (found.value != nullptr) continue;
        for (const WorldField& one : frame->proto->defaults)
            if (one.name == name) found = {&one.value, frame};
        // A default is a value; IS in one means nothing.
        if (found.value != nullptr && !found.value->is.empty()) return {};
    }
    return found;
}

std::optional<WorldPlace> ResolvedWorld::node(const WorldPlace& at, std::string_view field) {
    const Found found = find(at, field);
    if (found.value == nullptr || found.value->nodes.empty()) return std::nullopt;
    return resolve(found.value->nodes[0], found.frame);
}

std::span<const double> ResolvedWorld::numbers(const WorldPlace& at, std::string_view field) const {
    const Found found = find(at, field);
    if (found.value == nullptr) return {};
    if (!found.value->words.empty())
        maker_.fail(found.value->line, phrase("\"{0}\" is no number, and {1} takes numbers; save the model again",
                                              beginning_of(to_line(found.value->words[0])), field));
    return found.value->numbers;
}

std::span<const double> ResolvedWorld::several(const WorldPlace& at, std::string_view field, std::size_t count) const {
    const std::span<const double> all = numbers(at, field);
    if (!all.empty() && all.size() < count)
        maker_.fail(find(at, field).value->line, phrase("{0} takes {1} numbers and has {2}; save the model again", field,
                                                        std::to_string(count), std::to_string(all.size())));
    return all;
}

double ResolvedWorld::number(const WorldPlace& at, std::string_view field, double otherwise) const {
    const auto all = several(at, field, 1);
    return all.empty() ? otherwise : all[0];
}

bool ResolvedWorld::flag(const WorldPlace& at, std::string_view field, bool otherwise) const {
    return number(at, field, otherwise ? 1 : 0) != 0;
}

Point3 ResolvedWorld::point(const WorldPlace& at, std::string_view field, const Point3& otherwise) const {
    const auto all = several(at, field, 3);
    return all.empty() ? otherwise : Point3{all[0], all[1], all[2]};
}

ResolvedWorld::Turn ResolvedWorld::turn(const WorldPlace& at, std::string_view field) const {
    const auto all = several(at, field, 4);
    return all.empty() ? Turn{} : Turn{{all[0], all[1], all[2]}, all[3] * world_.radian};
}

std::string ResolvedWorld::text(const WorldPlace& at, std::string_view field) const {
    const Found found = find(at, field);
    return found.value == nullptr || found.value->words.empty() ? std::string() : found.value->words[0];
}

Placing transform_of(const ResolvedWorld& world, const WorldPlace& at, std::string_view scale) {
    TransformFields fields;
    fields.centre = world.point(at, "center", {});
    fields.translation = world.point(at, "translation", {});
    fields.scale = world.point(at, scale, {1, 1, 1});
    const auto turn = world.turn(at, "rotation"), scale_turn = world.turn(at, "scaleOrientation");
    fields.axis = turn.axis;
    fields.angle = turn.angle;
    fields.scale_axis = scale_turn.axis;
    fields.scale_angle = scale_turn.angle;
    return placing_of(fields);
}

Point3 viewer_of(const ResolvedWorld& world, const WorldPlace& at, const Placing& placing) {
    const auto turn = world.turn(at, "orientation");
    return placing.direction(turned(turn.axis, turn.angle).direction({0, 0, 1}));
}

Placing matrix_of(const ResolvedWorld& world, const WorldPlace& at) {
    constexpr std::size_t kNumbers = 16;
    const std::span<const double> rows = world.several(at, "matrix", kNumbers);
    return rows.empty() ? Placing{} : placing_of_rows(rows.first<kNumbers>());
}

}  // namespace tactics
