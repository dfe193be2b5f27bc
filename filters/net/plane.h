// SPDX-License-Identifier: Apache-2.0
// The values between two layers: pixels with interleaved channels, in a frame of zeros that kernels may read.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "filters/net/kernel.h"

namespace tactics {

class NetPlane {
public:
    NetPlane(int width, int height, int channels)
        : width_(width), height_(height), channels_(channels), stride_((width + 2 * kFrame) * channels) {
        const auto rows = static_cast<std::size_t>(height + 2 * kFrame), frame = static_cast<std::size_t>(kFrame * stride_);
        const auto size = rows * static_cast<std::size_t>(stride_) + static_cast<std::size_t>(kReadBeyond * channels);
        values_ = std::make_unique_for_overwrite<std::int16_t[]>(size);
        std::fill_n(values_.get(), frame, std::int16_t{0});
        std::fill(values_.get() + size - frame - static_cast<std::size_t>(kReadBeyond * channels), values_.get() + size,
                  std::int16_t{0});
        for (int y = 0; y < height; ++y) {
            std::fill_n(at(-kFrame, y), kFrame * channels, std::int16_t{0});
            std::fill_n(at(width, y), kFrame * channels, std::int16_t{0});
        }
    }

    int width() const { return width_; }
    int height() const { return height_; }
    int channels() const { return channels_; }
    std::int16_t* at(int x, int y) { return values_.get() + place(x, y); }
    const std::int16_t* at(int x, int y) const { return values_.get() + place(x, y); }

private:
    static constexpr int kFrame = 2;  // the largest kernel reaches as far

    std::ptrdiff_t place(int x, int y) const {
        return static_cast<std::ptrdiff_t>(y + kFrame) * stride_ + static_cast<std::ptrdiff_t>((x + kFrame) * channels_);
    }

    int width_, height_, channels_, stride_;
    std::unique_ptr<std::int16_t[]> values_;
};

}  // namespace tactics
