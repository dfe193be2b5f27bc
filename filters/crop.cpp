// SPDX-License-Identifier: Apache-2.0
// Cuts the edges of a picture off: what is not in it cannot clutter the page.
#include <algorithm>
#include <cmath>
#include <string>

#include "tactics/error.h"
#include "tactics/filter.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr Option crop_percent(std::string_view name, std::string_view summary) {
    return {.name = name, .type = Option::Type::number, .fallback = 0, .min = 0, .max = 90, .unit = "%", .summary = summary};
}

constexpr Option kCropOptions[] = {
    crop_percent("left", "share of the picture's width to cut off at the left"),
    crop_percent("top", "share of the picture's height to cut off at the top"),
    crop_percent("right", "share of the picture's width to cut off at the right"),
    crop_percent("bottom", "share of the picture's height to cut off at the bottom"),
};

struct Span {
    int begin = 0;
    int length = 0;
};

Span kept(int length, const Settings& settings, std::string_view before, std::string_view after) {
    const double first = settings.number(before);
    const double last = settings.number(after);
    if (first + last >= 100)
        throw Error(Fault::usage, "crop",
                    phrase("{0}={1} and {2}={3} leave nothing of the picture (together they must be under 100)", before,
                           to_text(first), after, to_text(last)));
    const int begin = std::min(length - 1, static_cast<int>(std::lround(length * first / 100)));
    const int end = static_cast<int>(std::lround(length * (100 - last) / 100));
    return {begin, std::max(1, end - begin)};
}

// Rows of `width` items, each item `step` values, moved together at the front of the same vector.
template <typename Value>
void cut(std::vector<Value>& values, int width, int step, Span columns, Span rows) {
    if (values.empty()) return;
    const auto row_length = static_cast<std::ptrdiff_t>(width) * step;
    const auto kept_length = static_cast<std::ptrdiff_t>(columns.length) * step;
    auto to = values.begin();
    for (int y = rows.begin; y < rows.begin + rows.length; ++y) {
        const auto from = values.begin() + y * row_length + static_cast<std::ptrdiff_t>(columns.begin) * step;
        to = std::copy(from, from + kept_length, to);
    }
    values.erase(to, values.end());
}

double share(const Settings& settings, std::string_view before, std::string_view after) {
    return std::max(0.0, 1 - (settings.number(before) + settings.number(after)) / 100);
}

Kept keeps(const Settings& settings) { return {share(settings, "left", "right"), share(settings, "top", "bottom")}; }

Artwork apply_crop(Artwork artwork, const Settings& settings) {
    const auto spans = [&](auto& picture) {
        return std::pair(kept(picture.width, settings, "left", "right"), kept(picture.height, settings, "top", "bottom"));
    };
    if (auto* image = std::get_if<Image>(&artwork)) {
        const auto [columns, rows] = spans(*image);
        cut(image->pixels, image->width, image->channels, columns, rows);
        image->width = columns.length;
        image->height = rows.length;
    } else {
        auto& edges = std::get<EdgeMap>(artwork);
        const auto [columns, rows] = spans(edges);
        cut(edges.strength, edges.width, 1, columns, rows);
        cut(edges.normal, edges.width, 1, columns, rows);
        edges.width = columns.length;
        edges.height = rows.length;
    }
    return artwork;
}

}  // namespace

extern const Filter crop_filter;
const Filter crop_filter{
    .name = "crop",
    .summary = "cuts off the edges of the picture; the rest keeps its scale on the page, and at least one pixel stays",
    .takes = Kind::picture | Kind::edges,
    .options = kCropOptions,
    .apply = apply_crop,
    .keeps = keeps,
};

}  // namespace tactics
