// SPDX-License-Identifier: Apache-2.0
// A model as a source of pages: folded out, seen from several sides, or as heights.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tactics/layout/sheet.h"
#include "tactics/model.h"
#include "tactics/solid/fold_out.h"
#include "tactics/text/phrase.h"

namespace tactics {

enum class ModelView : std::uint8_t {
    automatic,  ///< folded out; a terrain as heights
    fold_out,   ///< no perspective, every face in its true shape
    views,      ///< as seen from the top, the front and the side
    heights,    ///< from above, the higher the lighter
};

struct ModelDrawingWish {
    ModelView view = ModelView::automatic;
    FoldWish fold = {};
};

/// Whether it is a terrain: one surface without a name, with no place above another.
bool is_terrain(const Model& model);

/// Folds out for sheets; computes each layout once.
class ModelDrawing {
public:
    ModelDrawing(std::shared_ptr<const Model> model, ModelDrawingWish wish) : model_(std::move(model)), wish_(std::move(wish)) {}
    /// As large as the room on the sheet; y downwards, mm.
    const FoldOut& on(const Sheet& sheet);
    const Model& model() const { return *model_; }
    const std::vector<Phrase>& notes() const { return notes_; }

private:
    std::shared_ptr<const Model> model_;
    ModelDrawingWish wish_;
    double width_ = 0, height_ = 0;
    bool turns_ = false;
    const Medium* medium_ = nullptr;
    FoldOut made_;
    std::vector<Phrase> notes_;
};

/// Notes for readers and transcribers, one line each: what was folded, hidden, moved.
std::vector<Phrase> fold_lines(const FoldOut& made);
/// The same for each object, as JSON; places in percent of the drawing, from the left and from the top: where it
/// lies on the page is not known yet.
std::string fold_json(const FoldOut& made);

}  // namespace tactics
