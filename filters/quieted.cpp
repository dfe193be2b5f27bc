// SPDX-License-Identifier: Apache-2.0
#include "filters/quieted.h"

#include <algorithm>
#include <vector>

#include "filters/edge_noise.h"
#include "filters/opencv.h"

namespace tactics {

namespace {

// Grey levels: less is no mark to any later step, which take neighbours within 14 for one colour (inked_fills.cpp).
constexpr double kNoisy = 2;
// Two passes of a bilateral filter (C. Tomasi and R. Manduchi 1998): pixels count less the farther they are and the more they
// differ. The first keeps pale lines, the second, which is wider, only counts where there are none. Deviations in pixels and in
// those of the noise; settings, tried on the scans of tests/bench/figures, where few marks are left in grey surfaces and a step
// of some ten levels between two surfaces may go.
struct Smoothing {
    int window;
    double near, alike;
};
constexpr Smoothing kFirst{7, 2, 4}, kSecond{9, 3, 2};
constexpr int kNoBorder = 10;  // levels between neighbours after both: less is no line and no border

double noise_in(const cv::Mat& plane) {
    Image grey = make_image(plane.cols, plane.rows, 1, 0, 0);
    plane.copyTo(view_of(grey));
    return noise_level(grey);
}

// Noise that was enlarged, or went through JPEG, is coarser than pixels; where they are put together by fours it still is noise,
// and what differs from pixel to pixel has half its deviation.
double noise_of_channels(const cv::Mat& pixels) {
    std::vector<cv::Mat> planes;
    cv::split(pixels, planes);
    double most = 0;
    for (const cv::Mat& plane : planes) {
        most = std::max(most, noise_in(plane));
        if (std::min(plane.cols, plane.rows) < 2) continue;
        cv::Mat half;
        cv::resize(plane, half, cv::Size(plane.cols / 2, plane.rows / 2), 0, 0, cv::INTER_AREA);
        most = std::max(most, 2 * noise_in(half));
    }
    return most;
}

cv::Mat smoothed(const cv::Mat& pixels, const Smoothing& smoothing, double noise) {
    cv::Mat smooth;
    const double alike = pixels.channels() * smoothing.alike * noise;  // the filter adds up the differences of all channels
    cv::bilateralFilter(pixels, smooth, smoothing.window, alike, smoothing.near, cv::BORDER_REPLICATE);
    return smooth;
}

}  // namespace

bool quieten_lines(Image& picture) {
    cv::Mat pixels = view_of(picture);
    const double noise = noise_of_channels(pixels);
    if (noise < kNoisy) return false;
    smoothed(pixels, kFirst, noise).copyTo(pixels);
    return true;
}

void quieten(Image& picture) {
    cv::Mat pixels = view_of(picture);
    const double noise = noise_of_channels(pixels);
    if (noise < kNoisy) return;
    const cv::Mat once = smoothed(pixels, kFirst, noise), twice = smoothed(once, kSecond, noise);
    once.copyTo(pixels);
    twice.copyTo(pixels, range_around(twice) <= kNoBorder);
}

}  // namespace tactics
