// SPDX-License-Identifier: Apache-2.0
// The result for each object of a folded-out model.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/solid/layout.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// The result for an object.
struct FoldedObject {
    std::uint32_t object = 0;  ///< place in Model::objects
    std::string name;          ///< its own, or that of what it belongs to; empty: none has one
    std::string path;          ///< "Table/Top"
    PartForm form = PartForm::solid;
    /// Of something round: "vessel", "cylinder", "cone", "sphere", or "turned", which has a profile of its own; else empty.
    std::string_view shape;
    enum class Fate : std::uint8_t { drawn, small, hidden } fate = Fate::drawn;
    int kept = 0, straightened = 0, folded = 0, lying = 0, flattened = 0,
        wedges = 0;                        ///< of its faces and bars
    int hanging = 0;                       ///< what it looks like from a side, beside the face that hides it
    int doubled = 0;                       ///< sides that are shown in two places
    int left_out = 0;                      ///< faces that a hand can reach and that had no room
    Point at;                              ///< on it, mm in the drawing; on the section of a vessel, if there is one
    std::optional<Point> opening, bottom;  ///< of a vessel: in the circles that are drawn for them
    double size = 0;                       ///< mm of the model, its longest extent
    double moved = 0;  ///< mm of the model: how far it was moved off what was too close, with what it stands on
};

/// Its name, or that it has none.
Phrase called(const FoldedObject& one);

/// mm: a wedge is a triangle, with its thick end at the place of its bar and its tip below. A finger tells it from a dot, and its
/// ends apart (assumed).
inline constexpr double kWedgeLong = 6, kWedgeWide = 3;
/// Well within a wedge.
inline Point in_wedge(Point at) { return {at.x, at.y + kWedgeLong / 3}; }

/// From a layout into a drawing.
struct IntoDrawing {
    double scale = 1, left = 0, top = 0, edge = 0;
    Point of(Point at) const { return {edge + (at.x - left) * scale, edge + (at.y - top) * scale}; }
};

/// In the order of the model's. `is_small` is of all parts, `felt` are those that are not.
std::vector<FoldedObject> folded_objects(const Model& model, const std::vector<ModelPart>& parts,
                                         const std::vector<char>& is_small, const std::vector<ModelPart>& felt,
                                         const Panels& panels, const FlatLayout& layout, const IntoDrawing& into);

}  // namespace tactics
