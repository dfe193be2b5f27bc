// SPDX-License-Identifier: Apache-2.0
// The Sobel gradient (I. Sobel and G. Feldman 1968): the paper's edge filter, calibrated in grey levels.
#include <algorithm>
#include <array>
#include <cmath>

#include "filters/edge_map.h"
#include "filters/edge_noise.h"
#include "filters/gradient.h"
#include "filters/opencv.h"
#include "tactics/filter.h"

namespace tactics {

namespace {

constexpr std::array kSobelOptions{
    Option{.name = "blur",
           .type = Option::Type::length,
           .fallback = 0.3,
           .min = 0,
           .max = 20,
           .unit = "mm",
           .summary = "Gaussian blur applied first (standard deviation); 0 is the plain 3x3 Sobel"},
    Option{.name = "thin",
           .type = Option::Type::choice,
           .fallback = 0,
           .min = 0,
           .max = 1,
           .summary = "keep only the ridge of each edge (non-maximum suppression)",
           .choices = "no yes"},
};

// Rows as floats with one mirrored pixel on either side. The kernel is [1 2 1] across and [-1 0 1] along, a quarter of
// its answer is the height of a step.
template <typename Sample>
void sobel_rows(EdgeMap& map, const cv::Mat& grey, float scale, bool directions) {
    const int width = map.width, last = map.height - 1;
    std::vector<float> smooth(static_cast<std::size_t>(width) + 2), slope(static_cast<std::size_t>(width) + 2);
    for (int y = 0; y < map.height; ++y) {
        const Sample* a = grey.ptr<Sample>(std::max(y - 1, 0));
        const Sample* b = grey.ptr<Sample>(y);
        const Sample* c = grey.ptr<Sample>(std::min(y + 1, last));
        float* across = smooth.data() + 1;
        float* down = slope.data() + 1;
        for (int x = 0; x < width; ++x) {
            across[x] = static_cast<float>(a[x]) + 2 * static_cast<float>(b[x]) + static_cast<float>(c[x]);
            down[x] = static_cast<float>(c[x]) - static_cast<float>(a[x]);
        }
        across[-1] = across[0];
        across[width] = across[width - 1];
        down[-1] = down[0];
        down[width] = down[width - 1];
        const std::size_t at = static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
        float* strength = &map.strength[at];
        for (int x = 0; x < width; ++x) {
            const float gx = across[x + 1] - across[x - 1];
            const float gy = down[x - 1] + 2 * down[x] + down[x + 1];
            strength[x] = scale * std::sqrt(gx * gx + gy * gy);
        }
        if (!directions) continue;
        for (int x = 0; x < width; ++x) {
            const float gy = down[x - 1] + 2 * down[x] + down[x + 1];
            map.normal[at + static_cast<std::size_t>(x)] = undirected(std::atan2(gy, across[x + 1] - across[x - 1]));
        }
    }
}

Artwork apply_sobel(Artwork artwork, const Settings& settings) {
    const Image grey = to_grey(std::get<Image>(std::move(artwork)));
    const double sigma = settings.number("blur") / grey.mm_per_pixel;
    const bool thin = settings.choice("thin") == "yes";
    EdgeMap map;
    map.width = grey.width;
    map.height = grey.height;
    map.mm_per_pixel = grey.mm_per_pixel;
    map.noise = static_cast<float>(noise_scale(noise_level(grey), sigma));
    map.strength.resize(grey.pixels.size());
    if (thin) map.normal.resize(grey.pixels.size());
    const cv::Mat bytes = view_of(grey);
    const auto scale = static_cast<float>(step_height_per_slope(sigma) / 8);
    if (sigma < 0.1) {
        sobel_rows<std::uint8_t>(map, bytes, scale, thin);
    } else {
        cv::Mat blurred;
        bytes.convertTo(blurred, CV_32F);  // a dark picture's few levels must not be rounded away
        cv::GaussianBlur(blurred, blurred, cv::Size(), sigma, sigma, cv::BORDER_REFLECT);
        sobel_rows<float>(map, blurred, scale, thin);
    }
    return thin ? thin_edges(map, sigma) : std::move(map);
}

}  // namespace

extern const Filter sobel_filter;
const Filter sobel_filter{
    .name = "sobel",
    .summary = "finds edges by the Sobel gradient; strengths are in grey levels",
    .takes = static_cast<Kinds>(Kind::picture),
    .gives = static_cast<Kinds>(Kind::edges),
    .options = kSobelOptions,
    .apply = apply_sobel,
};

}  // namespace tactics
