// SPDX-License-Identifier: Apache-2.0
// Reads a picture and fits a recipe for a place on a page, for convert and evaluate alike.
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

/// At most so many pixels on the longer side are read: 0.7 m at 150 dpi. It bounds memory and time for any paper and picture.
inline constexpr int kMostPixels = 4000;

/// A picture as read for one use, cached for the next use that needs the same.
class Reading {
public:
    explicit Reading(Source& source) : read_([&source](const ReadRequest& request) { return read_picture(source, request); }) {}
    /// From pixels from elsewhere.
    explicit Reading(std::function<Image(const ReadRequest& request)> read) : read_(std::move(read)) {}

    const Image& get(const ReadRequest& request);
    Image take(const ReadRequest& request);

private:
    int longer_side() const;

    std::function<Image(const ReadRequest& request)> read_;
    Image image_;
    int longest_ = 0;
    bool colour_ = false;
};

/// The part of the picture's sides that a recipe draws. That part fills the place of the drawing, so that lengths in the recipe
/// are lengths on the page.
Kept kept_by(const Recipe& recipe);
bool draws_whole(const Recipe& recipe);  ///< nothing is cropped

double aspect_of(const PictureInfo& picture);

/// The choice depends on the picture alone, so that every page of it is made the same way.
Choice choose(Reading& reading);

/// Fits a recipe, which knows no medium, to one: limits the resolution to what the medium can show, and replaces the default gap
/// between lines by that of the medium.
Recipe fit_to(const Medium& medium, Recipe recipe);

/// Its filters with their settings, one text each.
std::vector<std::string> steps_of(const Recipe& recipe);

/// The picture as that recipe needs it, with its size on the page.
Image read_for(const Recipe& recipe, const Rect& drawing, Reading& reading);

}  // namespace tactics
