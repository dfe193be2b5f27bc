// SPDX-License-Identifier: Apache-2.0
#include "filters/straight_lines.h"

#include <algorithm>

#include "filters/opencv.h"

namespace tactics {

void take_straight_lines(std::span<std::uint8_t> pixels, int width) {
    const int height = static_cast<int>(pixels.size()) / std::max(1, width);
    if (width < 1 || height < 1) return;
    cv::Mat mask(height, width, CV_8U, pixels.data());
    for (const cv::Size size : {cv::Size(std::max(3, mask.cols / 5), 1), cv::Size(1, std::max(3, mask.rows / 3))}) {
        cv::Mat straight;
        cv::morphologyEx(mask, straight, cv::MORPH_OPEN, cv::getStructuringElement(cv::MORPH_RECT, size));
        mask.setTo(0, straight);
    }
}

}  // namespace tactics
