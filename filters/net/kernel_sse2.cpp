// SPDX-License-Identifier: Apache-2.0
// Every x86-64 has SSE2. pmaddwd multiplies eight int16 and adds them in pairs.
#include "filters/net/kernel.h"

#if defined(__x86_64__)

#include <emmintrin.h>

#include <cstring>

namespace tactics {

namespace {

__m128i load(const void* from) { return _mm_loadu_si128(static_cast<const __m128i*>(from)); }

// Two inputs of a pixel, for each of the outputs.
__m128i both_inputs(const std::int16_t* in) {
    int both;
    std::memcpy(&both, in, sizeof both);
    return _mm_set1_epi32(both);
}

// SSE2 has no minimum of int32, so the cut comes after packing, which itself cuts at -32768 and 32767: further out.
__m128i finished(__m128i low, __m128i high, int shift, const std::int16_t* add, int least) {
    const __m128i half = _mm_set1_epi32(1 << (shift - 1)), by = _mm_cvtsi32_si128(shift);
    low = _mm_sra_epi32(_mm_add_epi32(low, half), by);
    high = _mm_sra_epi32(_mm_add_epi32(high, half), by);
    if (add != nullptr) {
        const __m128i more = load(add), sign = _mm_srai_epi16(more, 15);
        low = _mm_add_epi32(low, _mm_unpacklo_epi16(more, sign));
        high = _mm_add_epi32(high, _mm_unpackhi_epi16(more, sign));
    }
    const __m128i packed = _mm_packs_epi32(low, high);
    return _mm_min_epi16(_mm_max_epi16(packed, _mm_set1_epi16(static_cast<short>(least))), _mm_set1_epi16(kMostActivation));
}

// Groups of eight outputs from `first` on, of a few pixels at once, so that a weight that was loaded is used more than once.
template <int Groups, int Pixels>
void dense_tile(const DenseRow& row, int first, int x) {
    const NetLayer& layer = *row.layer;
    const int pairs = layer.side * layer.inputs / 2, outputs = layer.outputs, inputs = layer.inputs;
    __m128i sums[2 * Groups][Pixels];
    for (int g = 0; g < 2 * Groups; ++g)
        for (int p = 0; p < Pixels; ++p) sums[g][p] = load(layer.bias.data() + first + 4 * g);
    const std::int16_t* weight = layer.weights.data() + 2 * first;
    for (int down = 0; down < layer.side; ++down) {
        const std::int16_t* in = row.in[static_cast<std::size_t>(down)] + x * inputs;
        for (int pair = 0; pair < pairs; ++pair, in += 2, weight += 2 * outputs)
            for (int p = 0; p < Pixels; ++p) {
                const __m128i value = both_inputs(in + p * inputs);
                for (int g = 0; g < 2 * Groups; ++g)
                    sums[g][p] = _mm_add_epi32(sums[g][p], _mm_madd_epi16(value, load(weight + 8 * g)));
            }
    }
    for (int p = 0; p < Pixels && x + p < row.pixels; ++p)
        for (int g = 0; g < Groups; ++g) {
            const int at = (x + p) * outputs + first + kChannelGroup * g;
            const __m128i out =
                finished(sums[2 * g][p], sums[2 * g + 1][p], layer.shift, row.add != nullptr ? row.add + at : nullptr, row.least);
            _mm_storeu_si128(reinterpret_cast<__m128i*>(row.out + at), out);
        }
}

void dense(const DenseRow& row) {
    int first = 0;
    for (; first + 16 <= row.layer->outputs; first += 16)
        for (int x = 0; x < row.pixels; x += 3) dense_tile<2, 3>(row, first, x);
    for (; first < row.layer->outputs; first += 8)
        for (int x = 0; x < row.pixels; x += 4) dense_tile<1, 4>(row, first, x);
}

void each(const EachRow& row) {
    const NetLayer& layer = *row.layer;
    const int channels = layer.outputs, taps = layer.side * layer.side;
    const NetTaps at = taps_of(row);
    for (int x = 0; x < row.pixels; ++x)
        for (int c = 0; c < channels; c += kChannelGroup) {
            const int here = x * channels + c;
            __m128i low = load(layer.bias.data() + c), high = load(layer.bias.data() + c + 4);
            const std::int16_t* weight = layer.weights.data() + 2 * c;
            for (std::size_t tap = 0; tap < static_cast<std::size_t>(taps); tap += 2, weight += 2 * channels) {
                const __m128i one = load(at[tap] + here), other = load(at[tap + 1] + here);
                low = _mm_add_epi32(low, _mm_madd_epi16(_mm_unpacklo_epi16(one, other), load(weight)));
                high = _mm_add_epi32(high, _mm_madd_epi16(_mm_unpackhi_epi16(one, other), load(weight + 8)));
            }
            _mm_storeu_si128(reinterpret_cast<__m128i*>(row.out + here), finished(low, high, layer.shift, nullptr, 0));
        }
}

bool always() { return true; }

}  // namespace

const NetKernel kSse2Kernel{"sse2", always, dense, each};

}  // namespace tactics

#endif
