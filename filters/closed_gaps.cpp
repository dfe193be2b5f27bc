// SPDX-License-Identifier: Apache-2.0
#include "filters/closed_gaps.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "filters/opencv.h"

namespace tactics {

Image with_gaps_closed(Image ink, const std::vector<DashRow>& rows) {
    constexpr double kFine = 16;  // of a pixel
    const auto fine = [](Point p) {
        return cv::Point(static_cast<int>(std::lround((p.x - 0.5) * kFine)), static_cast<int>(std::lround((p.y - 0.5) * kFine)));
    };
    for (const DashRow& row : rows)
        for (std::size_t i = 1; i < row.points.size(); ++i)
            cv::line(view_of(ink), fine(row.points[i - 1]), fine(row.points[i]), cv::Scalar(0),
                     std::max(1, static_cast<int>(row.width)), cv::LINE_8, 4);
    return ink;
}

}  // namespace tactics
