// SPDX-License-Identifier: Apache-2.0
// A part of a model as a hand would tell it: a face, a line, something round,
// something with sides, or too small to be there. M. Kurze, "Rendering Drawings
// for Interactive Haptic Perception", CHI 1997, steps 1 and 2 of the pipeline.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tactics/model.h"
#include "tactics/solid/revolution.h"
#include "tactics/solid/solid.h"
#include "tactics/text/phrase.h"

namespace tactics {

enum class PartForm : std::uint8_t {
    solid,   ///< plane sides that can be folded out
    face,    ///< flat: its larger side represents it
    line,    ///< slender: its axis represents it
    round,   ///< a surface of revolution: a section or an outline, and its ends
    curved,  ///< many small patches: its outline
};
std::string_view name_of(PartForm form);  ///< "solid", "face", ...

/// A box round a part, along its own directions.
struct PartBox {
    Point3 middle;
    std::array<Point3, 3> axis;  ///< of length 1, a right-handed frame; the longest first
    std::array<double, 3> half;  ///< mm
};

struct ModelPart {
    std::uint32_t object = 0;  ///< place in Model::objects
    PartForm form = PartForm::solid;
    Solid solid;
    PartBox box;
    std::optional<Revolution> round;  ///< of something round
    bool folds = true;                ///< its faces may be folded out
};

struct PartWish {
    double flat = 0.125;     ///< thickness over the second longest extent: no more,
                             ///< and it is a face
    double slender = 0.125;  ///< second longest extent over the longest: no more,
                             ///< and it is a line
    bool simplify = true;    ///< off: nothing becomes a face or a line
    bool fold = true;        ///< off: only what is parallel to the plane
    bool hide = false;       ///< it is left out
};

/// The wishes for one object and what belongs to it.
struct ObjectWish {
    std::string path;  ///< "Table/Top", or the end of it
    PartWish parts;
};

/// All parts of a model, in the order of its objects; one for each shell of an
/// object, or one that is curved for all of over 2,000 shells. A model of very many faces is made coarse first. `notes` is told
/// of both, and of what has no area.
/// `objects`: the last that fits an object holds for it. Throws Error(usage) where one fits none.
std::vector<ModelPart> parts_of(const Model& model, const PartWish& wish, const std::vector<ObjectWish>& objects,
                                std::vector<Phrase>& notes);

/// How far a solid reaches along a direction of length 1, mm.
struct Stretch {
    double low, high;
};
Stretch stretch_of(const Solid& solid, const Point3& direction);

double extent_of(const ModelPart& part);  ///< mm, the longest
/// For a line: the middles of its two ends.
std::array<Point3, 2> ends_of(const ModelPart& part);
/// mm from a place to the surface; 0 within a closed convex part.
double distance(const Point3& at, const ModelPart& part);

}  // namespace tactics
