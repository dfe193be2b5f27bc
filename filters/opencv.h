// SPDX-License-Identifier: Apache-2.0
// The only access to OpenCV (core and imgproc): nothing else in the project includes its headers.
//
// All access goes through views, and making the first one turns off OpenCV's own threads for the whole program: each picture is
// processed by the calling thread, and a batch keeps the cores busy with many pictures. So the result does not depend on the
// number of cores, and no thread pool is started for a few milliseconds of work.
#pragma once

#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/core/hal/intrin.hpp>
#include <opencv2/imgproc.hpp>
#include <span>
#include <vector>

#include "tactics/drawing.h"
#include "tactics/geometry/skeleton.h"
#include "tactics/image.h"

namespace tactics {

/// The pixels as a matrix of bytes with 1 or 3 channels. Nothing is copied: the image must outlive the view.
cv::Mat view_of(Image& image);
const cv::Mat view_of(const Image& image);  ///< to be read only

/// The strengths as a matrix of floats, without a copy.
cv::Mat view_of(EdgeMap& edges);
const cv::Mat view_of(const EdgeMap& edges);  ///< to be read only

/// A plane of floats, row by row, without a copy.
cv::Mat view_of(std::span<float> plane, int width, int height);

const cv::Mat view_of(std::span<const float> column);  ///< one value a row, to be read only

/// The pixel that a place is in; the middle of the first one is (0.5, 0.5).
inline cv::Point pixel_of(Point p) { return {static_cast<int>(std::floor(p.x)), static_cast<int>(std::floor(p.y))}; }

/// A place for OpenCV to draw at, in sixteenths of a pixel: for `shift` of its functions.
inline constexpr int kFineShift = 4;
inline cv::Point fine_point(Point p) {
    constexpr double kFine = 1 << kFineShift;
    return {static_cast<int>(std::lround((p.x - 0.5) * kFine)), static_cast<int>(std::lround((p.y - 0.5) * kFine))};
}

/// As steps from where they are counted from.
std::vector<PixelStep> steps_to(const std::vector<cv::Point>& pixels);

/// The colour of that pixel, to draw with; outside the picture that of the nearest.
cv::Scalar colour_near(const Image& picture, cv::Point pixel);

/// Of a piece that cv::connectedComponentsWithStats found.
cv::Rect box_of_piece(const cv::Mat& stats, int piece);

/// A mask grown by so many pixels to all sides, and over corners.
cv::Mat spread(const cv::Mat& mask, int by);

/// The largest difference in any channel among each pixel and the eight around it.
cv::Mat range_around(const cv::Mat& pixels);

}  // namespace tactics
