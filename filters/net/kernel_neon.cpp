// SPDX-License-Identifier: Apache-2.0
// Every 64-bit ARM has NEON. The weights lie in pairs, as x86 wants them; vld2 parts them.
#include "filters/net/kernel.h"

#if defined(__aarch64__)

#include <arm_neon.h>

namespace tactics {

namespace {

void finish(int32x4_t low, int32x4_t high, int shift, const std::int16_t* add, int least, std::int16_t* out) {
    const int32x4_t by = vdupq_n_s32(-shift);  // a rounding shift to the left by less than nothing
    low = vrshlq_s32(low, by);
    high = vrshlq_s32(high, by);
    if (add != nullptr) {
        const int16x8_t more = vld1q_s16(add);
        low = vaddw_s16(low, vget_low_s16(more));
        high = vaddw_s16(high, vget_high_s16(more));
    }
    const int16x8_t packed = vcombine_s16(vqmovn_s32(low), vqmovn_s32(high));
    const int16x8_t bottom = vdupq_n_s16(static_cast<std::int16_t>(least)), top = vdupq_n_s16(kMostActivation);
    vst1q_s16(out, vminq_s16(vmaxq_s16(packed, bottom), top));
}

// Eight outputs from `first` on, of a few pixels at once, so that a weight that was loaded is used more than once.
template <int Pixels>
void dense_tile(const DenseRow& row, int first, int x) {
    const NetLayer& layer = *row.layer;
    const int pairs = layer.side * layer.inputs / 2, outputs = layer.outputs, inputs = layer.inputs;
    int32x4_t low[Pixels], high[Pixels];
    for (int p = 0; p < Pixels; ++p) {
        low[p] = vld1q_s32(layer.bias.data() + first);
        high[p] = vld1q_s32(layer.bias.data() + first + 4);
    }
    const std::int16_t* weight = layer.weights.data() + 2 * first;
    for (int down = 0; down < layer.side; ++down) {
        const std::int16_t* in = row.in[static_cast<std::size_t>(down)] + x * inputs;
        for (int pair = 0; pair < pairs; ++pair, in += 2, weight += 2 * outputs) {
            const int16x8x2_t weights = vld2q_s16(weight);
            for (int p = 0; p < Pixels; ++p) {
                const std::int16_t one = in[p * inputs], other = in[p * inputs + 1];
                low[p] = vmlal_n_s16(low[p], vget_low_s16(weights.val[0]), one);
                high[p] = vmlal_n_s16(high[p], vget_high_s16(weights.val[0]), one);
                low[p] = vmlal_n_s16(low[p], vget_low_s16(weights.val[1]), other);
                high[p] = vmlal_n_s16(high[p], vget_high_s16(weights.val[1]), other);
            }
        }
    }
    for (int p = 0; p < Pixels && x + p < row.pixels; ++p) {
        const int at = (x + p) * outputs + first;
        finish(low[p], high[p], layer.shift, row.add != nullptr ? row.add + at : nullptr, row.least, row.out + at);
    }
}

void dense(const DenseRow& row) {
    for (int first = 0; first < row.layer->outputs; first += kChannelGroup)
        for (int x = 0; x < row.pixels; x += 8) dense_tile<8>(row, first, x);
}

void each(const EachRow& row) {
    const NetLayer& layer = *row.layer;
    const int channels = layer.outputs, taps = layer.side * layer.side;
    const NetTaps at = taps_of(row);
    for (int x = 0; x < row.pixels; ++x)
        for (int c = 0; c < channels; c += kChannelGroup) {
            const int here = x * channels + c;
            int32x4_t low = vld1q_s32(layer.bias.data() + c), high = vld1q_s32(layer.bias.data() + c + 4);
            const std::int16_t* weight = layer.weights.data() + 2 * c;
            for (std::size_t tap = 0; tap < static_cast<std::size_t>(taps); tap += 2, weight += 2 * channels) {
                const int16x8_t one = vld1q_s16(at[tap] + here), other = vld1q_s16(at[tap + 1] + here);
                const int16x8x2_t weights = vld2q_s16(weight);
                low = vmlal_s16(low, vget_low_s16(one), vget_low_s16(weights.val[0]));
                high = vmlal_s16(high, vget_high_s16(one), vget_high_s16(weights.val[0]));
                low = vmlal_s16(low, vget_low_s16(other), vget_low_s16(weights.val[1]));
                high = vmlal_s16(high, vget_high_s16(other), vget_high_s16(weights.val[1]));
            }
            finish(low, high, layer.shift, nullptr, 0, row.out + here);
        }
}

bool always() { return true; }

}  // namespace

const NetKernel kNeonKernel{"neon", always, dense, each};

}  // namespace tactics

#endif
