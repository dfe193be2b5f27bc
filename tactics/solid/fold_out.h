// SPDX-License-Identifier: Apache-2.0
// A model becomes a drawing without perspective, in which every face keeps its shape. M. Kurze, "Rendering Drawings for
// Interactive Haptic Perception", CHI 1997.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/drawing.h"
#include "tactics/medium.h"
#include "tactics/model.h"
#include "tactics/solid/folded_objects.h"
#include "tactics/solid/layout.h"
#include "tactics/solid/plane_choice.h"
#include "tactics/solid/reach.h"
#include "tactics/text/phrase.h"

namespace tactics {

struct FoldWish {
    FoldPlane plane = FoldPlane::automatic;
    std::optional<UpAxis> up = {};  ///< for who reads the model, which is drawn as it is; none: as its file implies
    std::string part = {};          ///< only this object and what belongs to it: "Table/Top"; empty: all
    PartWish parts = {};
    ReachWish reach = {};
    ReaderWish reader = {};
    int effort = 64;  ///< as LayoutWish
    std::vector<ObjectWish> objects = {};
    /// For several views: the position of the section, from the front (0) to the back (1). 0: where it cuts most parts, as near
    /// to the middle as possible.
    double section = 0;
    bool turns = false;           ///< the sheet may be turned, so that the room is as high as it was wide
    bool move = true;             ///< things may be moved off each other
    bool unite = true;            ///< sides that are too close to be felt as two become one
    std::string language = "en";  ///< of words that stand in the drawing (BCP 47)
};

struct FoldOut {
    Drawing drawing;  ///< with a name for each object that is drawn and has one, and a region for each
    std::vector<FoldedObject> objects;
    FoldPlane plane = FoldPlane::above;
    UpAxis up = UpAxis::z;  ///< the axis of the file that points upwards
    double scale = 1;       ///< mm of the drawing for one of the model
    double spread = 1;      ///< factor by which things are farther from the middle than in the model
    Rating rating;
};

/// As large as the room allows. `notes` receives deviations from the model. Throws Error(usage) if there is no such part;
/// Error(failed) if the model has no faces.
FoldOut fold_out(const Model& model, double width, double height, const Medium& medium, const FoldWish& wish,
                 std::vector<Phrase>& notes);

}  // namespace tactics
