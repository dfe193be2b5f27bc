// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/reading.h"

#include <algorithm>
#include <cmath>

#include "tactics/job/trimmed.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr double kDefaultDpi = 150;  // of the page; drawings made at 300 dpi agree with it within 1 mm to F >= 0.98

// The longer side, in pixels, at which a picture is examined to choose its recipe: A4 at 45 dpi. Uses that need fewer pixels also
// read this size and resample, so that the choice, the page and the embosser's page share one reading.
constexpr int kLook = 500;

// The pixels that the longer side of the picture needs for a drawing of that size: as many as resample leaves, so that it is not
// averaged again for one pixel. Only a recipe that starts with its resolution determines it (a preceding cut changes nothing); a
// recipe that reduces later needs a finer picture first.
int longest_for(const Recipe& recipe, const Rect& drawing) {
    double dpi = kDefaultDpi;
    bool first = true;
    for (const Step& step : recipe.steps) {
        if (step.filter->keeps != nullptr) continue;
        if (!step.filter->dpi.empty()) {
            dpi = first ? step.settings.number(step.filter->dpi) : 2 * kDefaultDpi;
            break;
        }
        first = false;
    }
    const Kept kept = kept_by(recipe);
    const double longer = std::max(drawing.width / kept.width, drawing.height / kept.height);
    const double pixels = std::max<double>(kLook, std::round(longer / kMmPerInch * dpi));
    return static_cast<int>(std::min<double>(pixels, kMostPixels));
}

}  // namespace

int Reading::longer_side() const { return std::max(image_.width, image_.height); }

const Image& Reading::get(const ReadRequest& request) {
    // A grey picture is the same whether colour was requested or not; one of which no pixels were averaged away, at any size.
    const bool all = longer_side() < longest_, as_long = longest_ == request.longest || (all && request.longest >= longer_side());
    const bool same = as_long && (colour_ == request.colour || (colour_ && image_.channels == 1));
    if (!same || image_.pixels.empty()) {
        image_ = Image{};
        image_ = read_(request);
        longest_ = request.longest;
        colour_ = request.colour;
    }
    return image_;
}

Image Reading::take(const ReadRequest& request) {
    constexpr std::size_t kSmall = 16'000'000;  // bytes: as many are kept for the next page rather than read again
    const Image& image = get(request);
    if (longer_side() < longest_ && image.pixels.size() <= kSmall) return image;
    return std::move(image_);
}

Kept kept_by(const Recipe& recipe) {
    Kept kept;
    for (const Step& step : recipe.steps) {
        if (step.filter->keeps == nullptr) continue;
        const Kept left = step.filter->keeps(step.settings);
        kept.width *= left.width;
        kept.height *= left.height;
    }
    // A cut that leaves nothing is refused later; a millionth is less than a pixel of any picture.
    return {std::max(kept.width, 1e-6), std::max(kept.height, 1e-6)};
}

bool draws_whole(const Recipe& recipe) {
    const Kept kept = kept_by(recipe);
    return kept.width >= 1 && kept.height >= 1;
}

double aspect_of(const PictureInfo& picture) { return static_cast<double>(picture.width) / picture.height; }

// On a page that is mostly empty, solid parts are a small share as thin lines are, and are seen when the figure is looked at by
// itself.
Choice choose(Reading& reading) {
    constexpr double kMostlyEmpty = 0.5;
    const Image& whole = reading.get({kLook, true});
    Choice choice = choose_recipe(whole);
    if (choice.recipe != "line-art") return choice;
    const Rect part = inked_part(whole);
    if (part.width * part.height > kMostlyEmpty) return choice;
    const double longer = std::max(part.width * whole.width, part.height * whole.height) / std::max(whole.width, whole.height);
    const int finer = static_cast<int>(std::lround(kLook / std::max(longer, 0.1)));
    Choice closer = choose_recipe(cut_out(reading.get({finer, true}), part));
    return closer.recipe == "diagram" ? closer : choice;
}

Recipe fit_to(const Medium& medium, Recipe recipe) {
    for (Step& step : recipe.steps)
        if (step.filter->fit != nullptr) step.filter->fit(step.settings, medium);
    return recipe;
}

std::vector<std::string> steps_of(const Recipe& recipe) {
    std::vector<std::string> steps;
    for (const Step& step : recipe.steps) {
        const std::string settings = step.settings.to_text();
        steps.push_back(std::string(step.filter->name) + (settings.empty() ? "" : " " + settings));
    }
    return steps;
}

Image read_for(const Recipe& recipe, const Rect& drawing, Reading& reading) {
    Image image = reading.take({longest_for(recipe, drawing), uses_colour(recipe)});
    // By the longer side, as resample has it: the other one is a whole number of pixels only nearly.
    const Kept kept = kept_by(recipe);
    image.mm_per_pixel =
        image.width >= image.height ? drawing.width / (image.width * kept.width) : drawing.height / (image.height * kept.height);
    return image;
}

}  // namespace tactics
