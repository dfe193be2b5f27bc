// SPDX-License-Identifier: Apache-2.0
#include "filters/opencv.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace tactics {

namespace {

// OpenCV keeps this setting for the process; 0 means "run in the caller" and starts no pool.
void one_thread_a_picture() {
    static const bool once = [] {
        cv::setNumThreads(0);
        return true;
    }();
    static_cast<void>(once);
}

}  // namespace

cv::Mat view_of(Image& image) {
    one_thread_a_picture();
    return {image.height, image.width, CV_8UC(image.channels), image.pixels.data()};
}

// cv::Mat has no read-only form; a const one does not hand out its elements for writing.
const cv::Mat view_of(const Image& image) { return view_of(const_cast<Image&>(image)); }

cv::Mat view_of(EdgeMap& edges) { return view_of(edges.strength, edges.width, edges.height); }

const cv::Mat view_of(const EdgeMap& edges) { return view_of(const_cast<EdgeMap&>(edges)); }

cv::Mat view_of(std::span<float> plane, int width, int height) {
    one_thread_a_picture();
    return {height, width, CV_32FC1, plane.data()};
}

const cv::Mat view_of(std::span<const float> column) {
    one_thread_a_picture();
    return {static_cast<int>(column.size()), 1, CV_32FC1, const_cast<float*>(column.data())};
}

std::vector<PixelStep> steps_to(const std::vector<cv::Point>& pixels) {
    std::vector<PixelStep> steps;
    for (const cv::Point& p : pixels) steps.push_back({p.x, p.y});
    return steps;
}

cv::Scalar colour_near(const Image& picture, cv::Point pixel) {
    const std::uint8_t* at =
        picture.row(std::clamp(pixel.y, 0, picture.height - 1)) + std::clamp(pixel.x, 0, picture.width - 1) * picture.channels;
    return {1.0 * at[0], picture.channels == 3 ? 1.0 * at[1] : 0, picture.channels == 3 ? 1.0 * at[2] : 0};
}

cv::Rect box_of_piece(const cv::Mat& stats, int piece) {
    return {stats.at<int>(piece, cv::CC_STAT_LEFT), stats.at<int>(piece, cv::CC_STAT_TOP),
            stats.at<int>(piece, cv::CC_STAT_WIDTH), stats.at<int>(piece, cv::CC_STAT_HEIGHT)};
}

cv::Mat spread(const cv::Mat& mask, int by) {
    cv::Mat wide;
    cv::dilate(mask, wide, cv::getStructuringElement(cv::MORPH_RECT, cv::Size(2 * by + 1, 2 * by + 1)));
    return wide;
}

cv::Mat range_around(const cv::Mat& pixels) {
    cv::Mat low, high, range;
    cv::erode(pixels, low, cv::Mat());
    cv::dilate(pixels, high, cv::Mat());
    cv::subtract(high, low, range);
    if (range.channels() == 1) return range;
    std::vector<cv::Mat> planes;
    cv::split(range, planes);
    return cv::max(planes[0], cv::max(planes[1], planes[2]));
}

}  // namespace tactics
