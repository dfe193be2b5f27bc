// SPDX-License-Identifier: Apache-2.0
// Panels and bars of a model laid out in one plane: what is parallel to it lies
// where it is, the rest is folded or flattened into it, and nothing lies over
// anything that it does not stand on. M. Kurze, CHI 1997, steps 3 to 6 and the
// rating.
#pragma once

#include <cstdint>
#include <vector>

#include "tactics/solid/flat_shape.h"
#include "tactics/solid/panel.h"

namespace tactics {

/// The manipulation that brought a panel or a bar into the plane.
enum class Handling : std::uint8_t {
    kept,          ///< parallel to the plane: it lies where it is
    straightened,  ///< it leant, and was turned upright about its middle
    folded,        ///< turned about a side that it has in common with a panel that lies
                   ///< already
    lying,         ///< an upright face that nothing holds, laid down about its lower side
    flattened,     ///< a bar, turned about the end that it is held by
    wedge,         ///< a bar along the line of sight: a mark that is thick where it is
                   ///< near
};
std::string_view name_of(Handling handling);

/// An isometry from a panel's plane into the drawing.
struct Placement {
    Point3 origin, along, across;
    Point at, to_along, to_across;
    Point of(const Point3& place) const;
};

struct PlacedPanel {
    std::uint32_t panel = 0;
    Handling handling = Handling::kept;
    int folds = 0;      ///< one after the other, from what lies where it is
    double height = 0;  ///< mm towards the reader: of what it hangs on
    Placement placement;
    FlatShape shape;
};

struct PlacedBar {
    std::uint32_t bar = 0;
    Handling handling = Handling::kept;
    double height = 0;
    Point from, to;  ///< from: where it is held
};

/// M. Kurze's rating: information shown against manipulations asked of the
/// reader.
struct Rating {
    double shown = 0;  ///< share of the faces, sides and bars that a hand can reach
    double asked = 0;  ///< manipulations, weighted as the reader likes them, a
                       ///< face or bar of the model
    double value() const { return shown - asked; }
};

/// How hard a reader finds each manipulation: the loss of rating if every face of a model had one more of it.
struct ReaderWish {
    double fold = 0.15, fold_again = 0.4, flatten = 0.1, straighten = 0.1, lay = 0.15, wedge = 0.3, kind = 0.02;
};

struct FlatLayout {
    std::vector<PlacedPanel> panels;
    std::vector<PlacedBar> bars;
    Rating rating;
};

/// Round all that is laid out.
Box box_of(const FlatLayout& layout);
/// mm: what is nearer than that in a layout touches.
double touching_in(const std::vector<ModelPart>& parts);
/// The largest number of outlines of a part that is useful; further sides show nothing new.
std::size_t most_outlines(PartForm form);

/// The room that a drawing has on its sheet, mm; 0: its size is of no matter.
struct SheetRoom {
    double width = 0, height = 0;
    bool turns = false;  ///< the sheet may be turned
};
/// mm of the drawing for one of the model, if it is as large as the room allows.
double scale_in(const SheetRoom& room, const Box& box);

struct LayoutWish {
    ReaderWish reader;
    double gap = 0;       ///< mm of the model: between lines of different things
    int effort = 64;      ///< layouts that are tried beyond the strategies (layouts_tried); the best is kept
    SheetRoom room = {};  ///< what is folded out may make all smaller, which is hard for a reader, too
    double shortest = 0;  ///< mm of the drawing, below which a part is not felt
};

}  // namespace tactics
