// SPDX-License-Identifier: Apache-2.0
#include "filters/kmeans_iterative.h"

#include <algorithm>

#include "filters/opencv.h"

namespace tactics {

namespace {

// How many different samples there are, up to `limit`: OpenCV's answer with more classes than that has empty or double ones.
int count_different(std::span<const float> samples, int limit) {
    std::vector<float> seen;
    for (const float s : samples) {
        if (std::find(seen.begin(), seen.end(), s) != seen.end()) continue;
        seen.push_back(s);
        if (static_cast<int>(seen.size()) == limit) break;
    }
    return static_cast<int>(seen.size());
}

}  // namespace

std::vector<double> kmeans_iterative(std::span<const float> samples, int k, int starts, std::uint64_t seed) {
    k = count_different(samples, k);
    if (k == 0) return {};
    cv::Mat labels;
    cv::Mat centres;
    cv::theRNG() = cv::RNG(seed);  // of this thread
    cv::kmeans(view_of(samples), k, labels, cv::TermCriteria(cv::TermCriteria::COUNT, 100, 0), starts, cv::KMEANS_PP_CENTERS,
               centres);
    std::vector<double> sorted;
    for (int i = 0; i < k; ++i) sorted.push_back(static_cast<double>(centres.at<float>(i)));
    std::sort(sorted.begin(), sorted.end());
    return sorted;
}

}  // namespace tactics
