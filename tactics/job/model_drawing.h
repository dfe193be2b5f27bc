// SPDX-License-Identifier: Apache-2.0
// A model as a source of pages: folded out, seen from several sides, or by its heights.
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
    automatic,  ///< folded out, or a terrain by its heights
    fold_out,   ///< no perspective, every face in its shape
    views,      ///< top, front and side, each as it is seen
    heights,    ///< from above, the higher the lighter
};

struct ModelDrawingWish {
    ModelView view = ModelView::automatic;
    FoldWish fold = {};
};

/// It is one surface that has no name, and no place lies over another: heights tell it.
bool is_terrain(const Model& model);

/// Folded out for sheets; each is worked out once.
class ModelDrawing {
public:
    ModelDrawing(std::shared_ptr<const Model> model, ModelDrawingWish wish) : model_(std::move(model)), wish_(std::move(wish)) {}
    /// As large as the sheet's room; y downwards, mm.
    const FoldOut& on(const Sheet& sheet);
    const Model& model() const { return *model_; }
    const std::vector<Phrase>& notes() const { return notes_; }

private:
    std::shared_ptr<const Model> model_;
    ModelDrawingWish wish_;
    double width_ = 0, height_ = 0;
    const Medium* medium_ = nullptr;
    FoldOut made_;
    std::vector<Phrase> notes_;
};

/// What a reader or a transcriber is told of it, a line each: what was folded, hidden, moved.
std::vector<Phrase> fold_lines(const FoldOut& made);
/// The same of each object, as a JSON object; places in percent of the drawing, from the left and from the top.
std::string fold_json(const FoldOut& made);

}  // namespace tactics
