// SPDX-License-Identifier: Apache-2.0
#include "filters/closed_gaps.h"

#include <algorithm>
#include <cstddef>

#include "filters/opencv.h"

namespace tactics {

Image with_gaps_closed(Image ink, const std::vector<DashRow>& rows) {
    for (const DashRow& row : rows)
        for (std::size_t i = 1; i < row.points.size(); ++i)
            cv::line(view_of(ink), fine_point(row.points[i - 1]), fine_point(row.points[i]), cv::Scalar(0),
                     std::max(1, static_cast<int>(row.width)), cv::LINE_8, kFineShift);
    return ink;
}

}  // namespace tactics
