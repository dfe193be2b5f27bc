// SPDX-License-Identifier: Apache-2.0
// How a picture is read, and a recipe fitted, for a place on a page: what convert and evaluate do alike.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "filters/choose.h"
#include "tactics/page.h"
#include "tactics/readers/read.h"
#include "tactics/recipe.h"

namespace tactics {

/// A picture read for a purpose, kept for the next purpose that needs the same.
class Reading {
public:
    explicit Reading(Source& source) : read_([&source](const ReadRequest& request) { return read_picture(source, request); }) {}
    /// Of pixels that come from elsewhere.
    explicit Reading(std::function<Image(const ReadRequest& request)> read) : read_(std::move(read)) {}

    const Image& get(const ReadRequest& request);
    Image take(const ReadRequest& request);

private:
    std::function<Image(const ReadRequest& request)> read_;
    Image image_;
    int longest_ = 0;
    bool colour_ = false;
};

/// How much of the picture's sides a recipe draws. What is left fills the place of the drawing, so that lengths of the recipe are
/// lengths on the page.
Kept kept_by(const Recipe& recipe);
bool draws_whole(const Recipe& recipe);  ///< nothing is cropped

double aspect_of(const PictureInfo& picture);

/// The choice depends on the picture alone, so that every page of it is made the same way.
Choice choose(Reading& reading);

/// A recipe knows no medium: what asks for more pixels than the medium can show is made as coarse as that, and lines that
/// keep the usual gap keep that of the medium.
Recipe fit_to(const Medium& medium, Recipe recipe);

/// Its filters with their settings, a text each.
std::vector<std::string> steps_of(const Recipe& recipe);

/// The picture as that recipe wants to see it, with its size on the page.
Image read_for(const Recipe& recipe, const Rect& drawing, Reading& reading);

}  // namespace tactics
