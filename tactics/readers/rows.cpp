// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/rows.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "tactics/readers/upright.h"

namespace tactics {

namespace {

std::uint8_t over_white(unsigned value, unsigned alpha, Alpha kind) {
    if (kind == Alpha::premultiplied) return static_cast<std::uint8_t>(std::min(255u, value + 255u - alpha));
    return static_cast<std::uint8_t>(255u - ((255u - value) * alpha + 127u) / 255u);
}

void convert(const RowShape& shape, bool colour, const std::uint8_t* from, std::uint8_t* to) {
    const int step = shape.channels();
    for (int x = 0; x < shape.size.width; ++x, from += step) {
        if (colour) {
            for (int c = 0; c < 3; ++c) *to++ = over_white(from[c], from[3], shape.alpha);
        } else {
            const std::uint8_t grey = shape.colours == 3 ? luma(from) : *from;
            *to++ = shape.alpha == Alpha::none ? grey : over_white(grey, from[shape.colours], shape.alpha);
        }
    }
}

void convert(const RowShape& shape, bool, const float* from, float* to) {
    const auto finite = [](float value) { return std::isfinite(value) ? value : 0.0f; };
    const int step = shape.channels();
    for (int x = 0; x < shape.size.width; ++x, from += step) {
        const float alpha = shape.alpha == Alpha::none ? 1.0f : std::clamp(finite(from[shape.colours]), 0.0f, 1.0f);
        const float factor = shape.alpha == Alpha::straight ? alpha : 1.0f;
        for (int c = 0; c < shape.colours; ++c) *to++ = finite(from[c]) * factor;
        if (shape.alpha != Alpha::none) *to++ = alpha;
    }
}

// The colours of a shrunk linear picture, coded and laid over white.
std::vector<std::uint8_t> develop(const std::vector<float>& samples, const RowShape& shape) {
    const int step = shape.channels();
    const float scale = 1.0f / white_of(samples, step, shape.colours);
    std::vector<std::uint8_t> coded;
    coded.reserve(samples.size() / static_cast<std::size_t>(step) * static_cast<std::size_t>(shape.colours));
    for (std::size_t at = 0; at < samples.size(); at += static_cast<std::size_t>(step)) {
        const float paper = shape.alpha == Alpha::none ? 0.0f : 1.0f - samples[at + static_cast<std::size_t>(shape.colours)];
        for (int c = 0; c < shape.colours; ++c)
            coded.push_back(srgb_coded(samples[at + static_cast<std::size_t>(c)] * scale + paper));
    }
    return coded;
}

std::vector<std::uint8_t> develop(std::vector<std::uint8_t>&& samples, const RowShape&) { return std::move(samples); }

template <class Sample>
int kept_channels(const RowShape& shape, bool colour) {
    if constexpr (std::is_same_v<Sample, float>) return shape.channels();  // alpha and grey wait for the exposure
    return colour ? 3 : 1;
}

}  // namespace

template <class Sample>
RowReceiver<Sample>::RowReceiver(const RowShape& shape, const ReadRequest& request, Size to, Size eighths)
    : shape_(shape),
      channels_(kept_channels<Sample>(shape, request.colour && shape.colours == 3)),
      colour_(request.colour && shape.colours == 3),
      to_(to),
      shrinker_(shape.size, to, channels_, eighths) {
    const bool as_it_is = std::is_same_v<Sample, std::uint8_t> && channels_ == shape.channels();
    if (!as_it_is) row_.resize(static_cast<std::size_t>(shape.size.width) * static_cast<std::size_t>(channels_));
}

template <class Sample>
void RowReceiver<Sample>::add(const Sample* row) {
    if (row_.empty()) {
        shrinker_.add(row);
        return;
    }
    convert(shape_, colour_, row, row_.data());
    shrinker_.add(row_.data());
}

template <class Sample>
Image RowReceiver<Sample>::finish() {
    Image image;
    image.width = to_.width;
    image.height = to_.height;
    image.channels = std::is_same_v<Sample, float> ? shape_.colours : channels_;
    image.pixels = develop(shrinker_.take(), shape_);
    if (!colour_) image = to_grey(std::move(image));
    return turn_upright(std::move(image), shape_.orientation);
}

template class RowReceiver<std::uint8_t>;
template class RowReceiver<float>;

float white_of(const std::vector<float>& samples, int channels, int colours) {
    constexpr float kDark = 0.25f, kBright = 2.0f;
    std::vector<float> brightest;
    brightest.reserve(samples.size() / static_cast<std::size_t>(channels));
    for (std::size_t at = 0; at < samples.size(); at += static_cast<std::size_t>(channels))
        brightest.push_back(*std::max_element(samples.data() + at, samples.data() + at + colours));
    if (brightest.empty()) return 1.0f;
    const auto rank = brightest.begin() + static_cast<std::ptrdiff_t>(brightest.size() * 99 / 100);
    std::nth_element(brightest.begin(), rank, brightest.end());
    constexpr float kBlack = 1e-6f;  // a picture without any light stays black
    return std::isfinite(*rank) && *rank > kBlack && (*rank < kDark || *rank > kBright) ? *rank : 1.0f;
}

namespace {

// steps[i] is the smallest linear value that is coded as i + 1.
std::array<float, 255> srgb_steps() {
    std::array<float, 255> steps{};
    for (std::size_t i = 0; i < steps.size(); ++i) {
        steps[i] = static_cast<float>(srgb_light((static_cast<double>(i) + 0.5) / 255.0));
    }
    return steps;
}

}  // namespace

std::uint8_t srgb_coded(float linear) {
    static const std::array<float, 255> kSteps = srgb_steps();
    return static_cast<std::uint8_t>(std::upper_bound(kSteps.begin(), kSteps.end(), linear) - kSteps.begin());
}

}  // namespace tactics
