// SPDX-License-Identifier: Apache-2.0
// The contour net: predicts which pixels lie on a contour that people would draw. A small convolutional net (train/model.py),
// fitted to photographs with contours drawn by people, computed in integers: the same bits on every machine.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "filters/net/kernel.h"
#include "tactics/image.h"

namespace tactics {

/// The numbers of a net, as train/export.py wrote them.
class ContourNet {
public:
    /// Throws Error(failed) for a file that is no net, of another version, truncated, damaged, or with sums that could overflow.
    static ContourNet from_bytes(std::string_view bytes, const std::string& place);

    /// Channels and residual blocks at a half, a quarter, an eighth and a sixteenth of the picture's size.
    const std::array<int, 4>& channels() const { return channels_; }
    const std::array<int, 4>& blocks() const { return blocks_; }
    /// In the order of their use.
    std::span<const NetLayer> layers() const { return layers_; }
    /// FNV-1a of the logits of the picture that train/integers.py draws, as computed there.
    std::uint64_t proof() const { return proof_; }

private:
    ContourNet() = default;

    std::array<int, 4> channels_{}, blocks_{};
    std::vector<NetLayer> layers_;
    std::uint64_t proof_ = 0;
};

/// The confidence of the net: log(p / (1 - p)) with 8 bits of fraction, clamped to 32. Half the picture's size, rounded up;
/// sample (x, y) lies at (2x + 0.5, 2y + 0.5), counted from the middle of the first pixel.
struct ContourLogits {
    int width = 0;
    int height = 0;
    std::vector<std::int16_t> values;
};

/// How to run the net. The result does not depend on it.
struct NetRun {
    const NetKernel* kernel = nullptr;  ///< the fastest that this machine has
    /// Larger pictures are run in tiles that overlap by as much as the net sees, each up to this many pixels (or as many as
    /// the overlap needs); 40 bytes a pixel are taken.
    long long most_pixels = 1LL << 22;
};

/// Any picture of at least 1 x 1; grey counts as a colour picture without colour.
ContourLogits logits_of(const ContourNet& net, const Image& image, const NetRun& run = {});

/// The map that people's contours stand out in: strength is 255 times the probability, not thinned; `normal` is filled in.
/// With several scales (each from 0.1 to 4, of the picture's size) the probabilities are averaged.
EdgeMap contour_map(const ContourNet& net, const Image& image, std::span<const double> scales = {}, const NetRun& run = {});

}  // namespace tactics
