// SPDX-License-Identifier: Apache-2.0
// The effective nodes of a World: with USE, PROTO and IS resolved, and fields with their defaults.
#pragma once

#include <deque>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/point3.h"
#include "tactics/readers/vrml/model_maker.h"
#include "tactics/readers/vrml/world.h"

namespace tactics {

/// Where IS in the body of a PROTO finds its values.
struct WorldFrame {
    const WorldProto* proto = nullptr;
    const WorldNode* instance = nullptr;
    const WorldFrame* outer = nullptr;  ///< in which the instance stands
    int depth = 0;
};

/// A node in its place.
struct WorldPlace {
    const WorldNode* node = nullptr;
    const WorldFrame* frame = nullptr;
    std::string_view name;  ///< that counts: of the instance of a PROTO, else of the node, else of the PROTO
};

class ResolvedWorld {
public:
    ResolvedWorld(const World& world, ModelMaker& maker) : world_(world), maker_(maker) {}

    const World& world() const { return world_; }

    /// The node after resolving USE and PROTO; nothing: it does not exist, and a note says so.
    std::optional<WorldPlace> resolve(std::uint32_t node, const WorldFrame* frame);

    /// The first that stands there, resolved.
    std::optional<WorldPlace> node(const WorldPlace& at, std::string_view field);

    struct Found {
        const WorldValue* value = nullptr;
        const WorldFrame* frame = nullptr;
    };
    /// No value: neither the node nor the PROTO around it gives one.
    Found find(const WorldPlace& at, std::string_view field) const;

    // Throw Error(failed) at FILE:LINE when something else stands there.
    std::span<const double> numbers(const WorldPlace& at, std::string_view field) const;
    double number(const WorldPlace& at, std::string_view field, double otherwise) const;
    bool flag(const WorldPlace& at, std::string_view field, bool otherwise) const;
    Point3 point(const WorldPlace& at, std::string_view field, const Point3& otherwise) const;
    struct Turn {
        Point3 axis{0, 0, 1};
        double angle = 0;  ///< radians
    };
    Turn turn(const WorldPlace& at, std::string_view field) const;
    std::string text(const WorldPlace& at, std::string_view field) const;  ///< its first word; may be empty

    /// All that stands there; nothing or at least `count`.
    std::span<const double> several(const WorldPlace& at, std::string_view field, std::size_t count) const;

private:
    const World& world_;
    ModelMaker& maker_;
    std::deque<WorldFrame> frames_;  // stay where they are; as many as there are steps for, at most
};

/// The fields of a Transform node in either dialect.
Placing transform_of(const ResolvedWorld& world, const WorldPlace& at, std::string_view scale);
/// The direction to who looks through a Viewpoint or a camera: along their z.
Point3 viewer_of(const ResolvedWorld& world, const WorldPlace& at, const Placing& placing);
/// MatrixTransform, which VRML97 lost and some programs still write.
Placing matrix_of(const ResolvedWorld& world, const WorldPlace& at);

}  // namespace tactics
