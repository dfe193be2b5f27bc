// SPDX-License-Identifier: Apache-2.0
// Rows of convolutions, written once for each kind of processor. Every kernel gives the same bits: products of int16 are summed
// in int32, and ContourNet::from_bytes has verified that no sum can overflow.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace tactics {

/// The values between layers: 8 bits of fraction, clamped to -kMostActivation and kMostActivation.
inline constexpr int kMostActivation = 8191;
/// The channels of a pixel are computed in groups of 8.
inline constexpr int kChannelGroup = 8;
inline constexpr int kMostChannels = 64;

/// A convolution with its bias: sums are shifted right by `shift`, rounded half up.
struct NetLayer {
    int inputs = 0;                  ///< channels, a multiple of 8
    int outputs = 0;                 ///< channels, padded to a multiple of 8 with channels that are always 0
    int side = 1;                    ///< of the kernel: 1, 3 or 5
    int shift = 0;                   ///< at least 1
    bool each = false;               ///< depthwise: each output sees only the input with the same number
    std::vector<std::int32_t> bias;  ///< one per output
    /// Dense: [row][pair of (column, input)][output][2]. Depthwise: [pair of taps][channel][2]; a last tap without a partner is
    /// paired with 0.
    std::vector<std::int16_t> weights;
};

/// A row of a dense layer. Pixels lie side by side, a pixel's channels, too.
struct DenseRow {
    const NetLayer* layer;
    std::array<const std::int16_t*, 3> in;  ///< for each row of the kernel, what its first column meets at the first pixel
    const std::int16_t* add;                ///< a row of outputs to add before the cut, or nullptr; may be `out`
    std::int16_t* out;
    int pixels;
    int least;  ///< 0 for a ReLU, else -kMostActivation
};

/// A row of a depthwise layer, with a ReLU.
struct EachRow {
    const NetLayer* layer;
    std::array<const std::int16_t*, 5> in;
    std::int16_t* out;
    int pixels;
};

/// For each tap of a depthwise kernel what it meets at the first pixel; one more, to stand beside a weight of 0.
using NetTaps = std::array<const std::int16_t*, 26>;
NetTaps taps_of(const EachRow& row);

/// How many pixels beyond the end of a row a kernel may read (it makes no use of them).
inline constexpr int kReadBeyond = 11;

struct NetKernel {
    std::string_view name;
    bool (*runs_here)();
    void (*dense)(const DenseRow&);
    void (*each)(const EachRow&);
};

/// The kernels that this processor can run, the fastest first, plain C++ last.
std::span<const NetKernel* const> net_kernels();

extern const NetKernel kPlainKernel;
#if defined(__x86_64__)
extern const NetKernel kSse2Kernel;
extern const NetKernel kAvx2Kernel;
extern const NetKernel kAvx512Kernel;
#elif defined(__aarch64__)
extern const NetKernel kNeonKernel;
#endif

}  // namespace tactics
