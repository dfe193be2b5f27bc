// SPDX-License-Identifier: Apache-2.0
// Marks taken out of a picture.
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "filters/darken.h"
#include "filters/inked_marks.h"
#include "filters/opencv.h"

namespace tactics {

void take_out(Image& picture, const InkedMarks& marks) {
    cv::Mat pixels = view_of(picture);
    const Image before = picture;
    const std::array<int, 3> ground = ground_of(picture);
    for (const Run& run : marks.rest)
        pixels(cv::Rect(run.begin - 1, run.row - 1, static_cast<int>(run.length()) + 2, 3) &
               cv::Rect(0, 0, pixels.cols, pixels.rows)) = cv::Scalar(ground[0], ground[1], ground[2]);
    for (const InkedMark& mark : marks.marks) {
        std::vector<cv::Point> hull;
        std::vector<std::pair<double, cv::Point>> beside;
        for (const Point& p : mark.hull) {
            hull.push_back(pixel_of(p));
            const cv::Scalar colour = colour_near(before, hull.back());
            beside.emplace_back(colour[0] + colour[1] + colour[2], hull.back());
        }
        // What most places around it have.
        const auto common = beside.begin() + static_cast<std::ptrdiff_t>(beside.size() / 2);
        std::nth_element(beside.begin(), common, beside.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
        cv::fillPoly(pixels, hull, colour_near(before, common->second));
    }
    for (const InkedMark& mark : marks.marks)
        for (const Point& arm : mark.arms)
            cv::line(pixels, pixel_of(mark.middle), pixel_of(arm), colour_near(before, pixel_of(arm)), 2);
}

}  // namespace tactics
