// SPDX-License-Identifier: Apache-2.0
// Dashed and dotted lines of black and white pictures, made whole: rows of small thin pieces of ink with gaps that are alike.
// Traced as they are, each dash would be a line of its own, too short to be felt, and go.
#include <algorithm>
#include <cmath>

#include "filters/dash_rows.h"
#include "filters/opencv.h"
#include "tactics/filter.h"

namespace tactics {

namespace {

constexpr Option kDashesOptions[] = {
    {.name = "longest",
     .type = Option::Type::length,
     .fallback = 8,
     .min = 0,
     .max = 50,
     .unit = "mm",
     .summary = "pieces of ink longer than this are no dashes; no effect under 1 pixel"},
    {.name = "widest",
     .type = Option::Type::length,
     .fallback = 1.2,
     .min = 0.1,
     .max = 20,
     .unit = "mm",
     .summary = "pieces of ink wider than this are no dashes: letters are wider than lines"},
};

constexpr double kDashesMostGap = 2.5;  // mm on the page; gaps made for the eye are smaller

Artwork apply_dashes(Artwork artwork, const Settings& settings) {
    Image image = to_grey(std::move(std::get<Image>(artwork)));
    const double mm = image.mm_per_pixel;
    const auto rows = dash_rows_in(
        image, image, {settings.number("longest") / mm, std::max(2.0, settings.number("widest") / mm), kDashesMostGap / mm});
    cv::Mat ink = view_of(image);
    const int thick = std::max(1, static_cast<int>(std::lround(0.3 / mm)));
    for (const DashRow& row : rows)
        for (std::size_t i = 0; i + 1 < row.points.size(); ++i) {
            if (i % 2 == 0 && i > 0 && i + 2 < row.points.size()) continue;  // a dash
            const Point a = row.points[i], b = row.points[i + 1];
            cv::line(ink, cv::Point(static_cast<int>(a.x), static_cast<int>(a.y)),
                     cv::Point(static_cast<int>(b.x), static_cast<int>(b.y)), cv::Scalar(0), thick);
        }
    return image;
}

}  // namespace

extern const Filter dashes_filter;
const Filter dashes_filter{
    .name = "dashes",
    .summary = "joins dashed and dotted lines in a black and white picture, so that they are traced as lines",
    .takes = static_cast<Kinds>(Kind::picture),
    .gives = static_cast<Kinds>(Kind::picture),
    .options = kDashesOptions,
    .apply = apply_dashes,
};

}  // namespace tactics
