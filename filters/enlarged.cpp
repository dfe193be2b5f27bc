// SPDX-License-Identifier: Apache-2.0
#include "filters/enlarged.h"

#include <algorithm>

#include "filters/opencv.h"

namespace tactics {

Image enlarged(const Image& picture, int width, int height) {
    const double scale = static_cast<double>(std::max(width, height)) / std::max(picture.width, picture.height);
    Image large = make_image(width, height, picture.channels, picture.mm_per_pixel / scale, 0);
    cv::Mat pixels = view_of(large);
    cv::resize(view_of(picture), pixels, pixels.size(), 0, 0, cv::INTER_CUBIC);
    return large;
}

}  // namespace tactics
