// SPDX-License-Identifier: Apache-2.0
#include "filters/plain_contours.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "filters/edge_map.h"
#include "filters/edge_noise.h"
#include "filters/gradient.h"
#include "filters/opencv.h"

namespace tactics {

namespace {

// The sides: discs of that deviation, that far from the line, in blurs. Found with the rest; 4 to 6 and 7 to 12 do as well.
constexpr double kSideWidth = 5;
constexpr double kSideAway = 9;

// A line with less than this share of its strength left is part of its surround, as all of an even slope is.
constexpr float kLeastContour = 0.1f;

// Where there is texture, lines have others on both sides. The border of a textured thing has them on one side only, and
// must stay: the quieter side counts (surround suppression, but of the two half-discs the weaker one). What is weaker than
// the floor before anything is taken off goes.
void hold_texture_down(EdgeMap& map, double sigma, double share, float floor) {
    if (share <= 0 || map.width < 8 || map.height < 8) return drop_below(map, floor);
    // A wide blur is smooth: a quarter of the resolution is enough for it.
    constexpr double kCoarse = 4;
    const cv::Mat strength = view_of(map);
    cv::Mat around;
    cv::resize(strength, around, cv::Size(), 1 / kCoarse, 1 / kCoarse, cv::INTER_AREA);
    const double width = kSideWidth * sigma / kCoarse;
    cv::GaussianBlur(around, around, cv::Size(), width, width, cv::BORDER_REFLECT);
    cv::resize(around, around, strength.size(), 0, 0, cv::INTER_LINEAR);
    const double away = kSideAway * sigma;
    const auto at = [&](int x, int y) {
        return around.at<float>(std::clamp(y, 0, map.height - 1), std::clamp(x, 0, map.width - 1));
    };
    float normal = 0;
    int dx = cvRound(away), dy = 0;
    std::size_t i = 0;
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x, ++i) {
            if (map.strength[i] < floor) {  // but it counts in the surround of others
                map.strength[i] = 0;
                continue;
            }
            if (map.normal[i] != normal) {  // there are few directions, and neighbours share them
                normal = map.normal[i];
                dx = cvRound(away * std::cos(normal));
                dy = cvRound(away * std::sin(normal));
            }
            const float quieter = std::min(at(x + dx, y + dy), at(x - dx, y - dy));
            const float left = map.strength[i] - static_cast<float>(share) * quieter;
            map.strength[i] = left > kLeastContour * map.strength[i] ? left : 0;
        }
}

// The strength that noise alone reaches in few pictures, in scales of its gradient. Its energy, collected along a line, is a
// mean of as many independent ones as the line is longer than the blur (their correlation falls off as exp(-d^2 / 2 sigma^2)),
// so it has about a chi-squared distribution of so many degrees of freedom. Its quantile: E. B. Wilson, M. M. Hilferty 1931.
double noise_collected(double sigma, double along) {
    const double freedom = std::sqrt(1 + 2 * along * along / (sigma * sigma));
    constexpr double kRare = 5;  // deviations of a normal distribution; a picture is some thousand lines
    const double spread = 2 / (9 * freedom);
    return std::pow(1 - spread + kRare * std::sqrt(spread), 1.5);
}

// Where squares of that side begin that cover the whole of `length`; the last two may overlap.
std::vector<int> beginnings(int length, int side) {
    std::vector<int> all;
    for (int at = 0; at + side < length; at += side) all.push_back(at);
    if (length >= side) all.push_back(length - side);
    return all;
}

// Mean energy of the gradient in squares much wider than a line.
std::vector<float> energies(const GradientTensor& tensor, double sigma) {
    constexpr double kSide = 10;  // in blurs
    const int side = std::max(8, static_cast<int>(kSide * sigma));
    std::vector<float> means;
    for (const int top : beginnings(tensor.height, side))
        for (const int left : beginnings(tensor.width, side)) {
            float sum = 0;
            for (int y = top; y < top + side; ++y) {
                const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(tensor.width);
                for (std::size_t i = row + static_cast<std::size_t>(left); i < row + static_cast<std::size_t>(left + side); ++i)
                    sum += tensor.xx[i] + tensor.yy[i];
            }
            means.push_back(sum / static_cast<float>(side * side));
        }
    return means;
}

// Grain that compression has smeared looks like faint structure to the measure of noise. But it looks alike everywhere: where
// no part of a picture stands out from the rest and all is not much stronger than its noise, there is nothing.
bool is_blank(const GradientTensor& tensor, double sigma, double noise) {
    // Of 192 blank pictures with grain, half of them JPEG, all but 6 have less than both; of 100 photographs none has.
    constexpr float kStandsOut = 3;
    constexpr double kOfNoise = 4;
    constexpr std::size_t kEnough = 40;
    std::vector<float> parts = energies(tensor, sigma);
    if (parts.size() < kEnough) return false;
    const auto middle = parts.begin() + static_cast<std::ptrdiff_t>(parts.size() / 2);
    std::nth_element(parts.begin(), middle, parts.end());
    return *std::max_element(middle, parts.end()) <= kStandsOut * *middle &&
           std::sqrt(static_cast<double>(*middle) / 2) <= kOfNoise * noise;
}

EdgeMap no_edges(const Image& picture) {
    EdgeMap none;
    none.width = picture.width;
    none.height = picture.height;
    none.mm_per_pixel = picture.mm_per_pixel;
    none.thinned = true;
    none.strength.assign(static_cast<std::size_t>(none.width) * static_cast<std::size_t>(none.height), 0.0f);
    none.normal = none.strength;
    return none;
}

}  // namespace

PlainMap plain_contours(const Image& picture, const PlainContours& wish) {
    Planes planes = see(picture, wish.chroma);
    const double scale = noise_of_gradient(planes, wish.blur);
    const GradientTensor tensor = gradient_tensor(std::move(planes), wish.blur);
    if (is_blank(tensor, wish.blur, scale)) return {no_edges(picture), 0};
    const double noise = noise_collected(wish.blur, wish.along) * scale;
    EdgeMap map = strongest_direction(tensor, wish.along, picture.mm_per_pixel);
    hold_texture_down(map, wish.blur, wish.surround, static_cast<float>(std::max(wish.floor, noise)));
    return {std::move(map), noise};
}

}  // namespace tactics
