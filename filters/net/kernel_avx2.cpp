// SPDX-License-Identifier: Apache-2.0
// As SSE2, twice as wide. Each function names what it needs, so that no other function of the file is compiled for AVX2: what
// is inline in a header would otherwise find its way into programs on machines without it.
#include "filters/net/kernel.h"

#if defined(__x86_64__)

#include <immintrin.h>

#include <cstring>

#define TACTICS_AVX2 __attribute__((target("avx2")))

namespace tactics {

namespace {

TACTICS_AVX2 inline __m256i load(const void* from) { return _mm256_loadu_si256(static_cast<const __m256i*>(from)); }
TACTICS_AVX2 inline __m128i load_half(const void* from) { return _mm_loadu_si128(static_cast<const __m128i*>(from)); }

TACTICS_AVX2 inline __m256i both_inputs(const std::int16_t* in) {
    int both;
    std::memcpy(&both, in, sizeof both);
    return _mm256_set1_epi32(both);
}

TACTICS_AVX2 inline void finish(__m256i sum, int shift, const std::int16_t* add, int least, std::int16_t* out) {
    __m256i value = _mm256_sra_epi32(_mm256_add_epi32(sum, _mm256_set1_epi32(1 << (shift - 1))), _mm_cvtsi32_si128(shift));
    if (add != nullptr) value = _mm256_add_epi32(value, _mm256_cvtepi16_epi32(load_half(add)));
    value = _mm256_min_epi32(_mm256_max_epi32(value, _mm256_set1_epi32(least)), _mm256_set1_epi32(kMostActivation));
    const __m128i packed = _mm_packs_epi32(_mm256_castsi256_si128(value), _mm256_extracti128_si256(value, 1));
    _mm_storeu_si128(reinterpret_cast<__m128i*>(out), packed);
}

// Groups of eight outputs from `first` on, of a few pixels at once: as many sums as there are registers.
template <int Groups, int Pixels>
TACTICS_AVX2 void dense_tile(const DenseRow& row, int first, int x) {
    const NetLayer& layer = *row.layer;
    const int pairs = layer.side * layer.inputs / 2, outputs = layer.outputs, inputs = layer.inputs;
    __m256i sums[Groups][Pixels];
    for (int g = 0; g < Groups; ++g)
        for (int p = 0; p < Pixels; ++p) sums[g][p] = load(layer.bias.data() + first + kChannelGroup * g);
    const std::int16_t* weight = layer.weights.data() + 2 * first;
    for (int down = 0; down < layer.side; ++down) {
        const std::int16_t* in = row.in[static_cast<std::size_t>(down)] + x * inputs;
        for (int pair = 0; pair < pairs; ++pair, in += 2, weight += 2 * outputs) {
            __m256i weights[Groups];
            for (int g = 0; g < Groups; ++g) weights[g] = load(weight + 2 * kChannelGroup * g);
            for (int p = 0; p < Pixels; ++p) {
                const __m256i value = both_inputs(in + p * inputs);
                for (int g = 0; g < Groups; ++g) sums[g][p] = _mm256_add_epi32(sums[g][p], _mm256_madd_epi16(value, weights[g]));
            }
        }
    }
    for (int p = 0; p < Pixels && x + p < row.pixels; ++p)
        for (int g = 0; g < Groups; ++g) {
            const int at = (x + p) * outputs + first + kChannelGroup * g;
            finish(sums[g][p], layer.shift, row.add != nullptr ? row.add + at : nullptr, row.least, row.out + at);
        }
}

TACTICS_AVX2 void dense(const DenseRow& row) {
    const int outputs = row.layer->outputs;
    int first = 0;
    if (outputs % 24 == 0)
        for (; first < outputs; first += 24)
            for (int x = 0; x < row.pixels; x += 4) dense_tile<3, 4>(row, first, x);
    for (; first + 16 <= outputs; first += 16)
        for (int x = 0; x < row.pixels; x += 6) dense_tile<2, 6>(row, first, x);
    for (; first < outputs; first += 8)
        for (int x = 0; x < row.pixels; x += 8) dense_tile<1, 8>(row, first, x);
}

TACTICS_AVX2 void each(const EachRow& row) {
    const NetLayer& layer = *row.layer;
    const int channels = layer.outputs, taps = layer.side * layer.side;
    const NetTaps at = taps_of(row);
    for (int x = 0; x < row.pixels; ++x)
        for (int c = 0; c < channels; c += kChannelGroup) {
            const int here = x * channels + c;
            __m256i sum = load(layer.bias.data() + c);
            const std::int16_t* weight = layer.weights.data() + 2 * c;
            for (std::size_t tap = 0; tap < static_cast<std::size_t>(taps); tap += 2, weight += 2 * channels) {
                const __m128i one = load_half(at[tap] + here), other = load_half(at[tap + 1] + here);
                const __m256i pairs = _mm256_set_m128i(_mm_unpackhi_epi16(one, other), _mm_unpacklo_epi16(one, other));
                sum = _mm256_add_epi32(sum, _mm256_madd_epi16(pairs, load(weight)));
            }
            finish(sum, layer.shift, nullptr, 0, row.out + here);
        }
}

bool machine_has_avx2() { return __builtin_cpu_supports("avx2") != 0; }

}  // namespace

const NetKernel kAvx2Kernel{"avx2", machine_has_avx2, dense, each};

}  // namespace tactics

#endif
