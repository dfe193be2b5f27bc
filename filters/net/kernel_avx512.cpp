// SPDX-License-Identifier: Apache-2.0
// As AVX2, twice as wide again, and with an instruction that multiplies two pairs and adds them to a sum at once (VNNI). Each
// function names what it needs, as in AVX2.
#include "filters/net/kernel.h"

#if defined(__x86_64__)

#ifndef __clang__
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"  // GCC 12 warns of its own header (bug 105593)
#endif
#include <immintrin.h>

#include <cstring>

#define TACTICS_AVX512 __attribute__((target("avx512f,avx512bw,avx512vl,avx512vnni")))

namespace tactics {

namespace {

constexpr int kWide = 2 * kChannelGroup;

TACTICS_AVX512 inline __m512i load(const void* from) { return _mm512_loadu_si512(from); }
TACTICS_AVX512 inline __m256i load_half(const void* from) { return _mm256_loadu_si256(static_cast<const __m256i*>(from)); }

TACTICS_AVX512 inline int both_inputs(const std::int16_t* in) {
    int both;
    std::memcpy(&both, in, sizeof both);
    return both;
}

TACTICS_AVX512 inline void finish(__m512i sum, int shift, const std::int16_t* add, int least, std::int16_t* out) {
    __m512i value = _mm512_sra_epi32(_mm512_add_epi32(sum, _mm512_set1_epi32(1 << (shift - 1))), _mm_cvtsi32_si128(shift));
    if (add != nullptr) value = _mm512_add_epi32(value, _mm512_cvtepi16_epi32(load_half(add)));
    value = _mm512_min_epi32(_mm512_max_epi32(value, _mm512_set1_epi32(least)), _mm512_set1_epi32(kMostActivation));
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(out), _mm512_cvtepi32_epi16(value));
}

TACTICS_AVX512 inline void finish(__m256i sum, int shift, const std::int16_t* add, int least, std::int16_t* out) {
    __m256i value = _mm256_sra_epi32(_mm256_add_epi32(sum, _mm256_set1_epi32(1 << (shift - 1))), _mm_cvtsi32_si128(shift));
    if (add != nullptr)
        value = _mm256_add_epi32(value, _mm256_cvtepi16_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(add))));
    value = _mm256_min_epi32(_mm256_max_epi32(value, _mm256_set1_epi32(least)), _mm256_set1_epi32(kMostActivation));
    _mm_storeu_si128(reinterpret_cast<__m128i*>(out), _mm256_cvtepi32_epi16(value));
}

// Groups of sixteen outputs from `first` on, and with Rest one of eight behind them, of a few pixels at once.
template <int Groups, int Rest, int Pixels>
TACTICS_AVX512 void dense_tile(const DenseRow& row, int first, int x) {
    const NetLayer& layer = *row.layer;
    const int pairs = layer.side * layer.inputs / 2, outputs = layer.outputs, inputs = layer.inputs;
    __m512i sums[Groups + 1][Pixels];
    __m256i rests[Pixels];
    for (int p = 0; p < Pixels; ++p) {
        for (int g = 0; g < Groups; ++g) sums[g][p] = load(layer.bias.data() + first + kWide * g);
        if (Rest != 0) rests[p] = load_half(layer.bias.data() + first + kWide * Groups);
    }
    const std::int16_t* weight = layer.weights.data() + 2 * first;
    for (int down = 0; down < layer.side; ++down) {
        const std::int16_t* in = row.in[static_cast<std::size_t>(down)] + x * inputs;
        for (int pair = 0; pair < pairs; ++pair, in += 2, weight += 2 * outputs) {
            __m512i weights[Groups + 1];
            for (int g = 0; g < Groups; ++g) weights[g] = load(weight + 2 * kWide * g);
            const __m256i rest = Rest != 0 ? load_half(weight + 2 * kWide * Groups) : __m256i{};
            for (int p = 0; p < Pixels; ++p) {
                const int both = both_inputs(in + p * inputs);
                for (int g = 0; g < Groups; ++g)
                    sums[g][p] = _mm512_dpwssd_epi32(sums[g][p], _mm512_set1_epi32(both), weights[g]);
                if (Rest != 0) rests[p] = _mm256_dpwssd_epi32(rests[p], _mm256_set1_epi32(both), rest);
            }
        }
    }
    for (int p = 0; p < Pixels && x + p < row.pixels; ++p) {
        const int at = (x + p) * outputs + first;
        const std::int16_t* add = row.add != nullptr ? row.add + at : nullptr;
        for (int g = 0; g < Groups; ++g)
            finish(sums[g][p], layer.shift, add != nullptr ? add + kWide * g : nullptr, row.least, row.out + at + kWide * g);
        if (Rest != 0)
            finish(rests[p], layer.shift, add != nullptr ? add + kWide * Groups : nullptr, row.least,
                   row.out + at + kWide * Groups);
    }
}

template <int Groups, int Rest, int Pixels>
TACTICS_AVX512 void dense_part(const DenseRow& row, int first) {
    for (int x = 0; x < row.pixels; x += Pixels) dense_tile<Groups, Rest, Pixels>(row, first, x);
}

TACTICS_AVX512 void dense(const DenseRow& row) {
    const int outputs = row.layer->outputs;
    int first = 0;
    for (; first + 48 <= outputs; first += 48) dense_part<3, 0, 8>(row, first);
    for (; first + 32 <= outputs; first += 32) dense_part<2, 0, 8>(row, first);
    for (; first + 24 <= outputs; first += 24) dense_part<1, 1, 12>(row, first);
    for (; first + 16 <= outputs; first += 16) dense_part<1, 0, 12>(row, first);
    for (; first < outputs; first += 8) dense_part<0, 1, 12>(row, first);
}

// The inputs of two taps beside each other, channel by channel.
TACTICS_AVX512 inline __m512i beside(const std::int16_t* one, const std::int16_t* other) {
    return _mm512_or_si512(_mm512_cvtepu16_epi32(load_half(one)), _mm512_slli_epi32(_mm512_cvtepu16_epi32(load_half(other)), 16));
}

TACTICS_AVX512 void each(const EachRow& row) {
    const NetLayer& layer = *row.layer;
    const int channels = layer.outputs, taps = layer.side * layer.side;
    if (channels % kWide != 0) return kAvx2Kernel.each(row);
    const NetTaps at = taps_of(row);
    for (int x = 0; x < row.pixels; ++x)
        for (int c = 0; c < channels; c += kWide) {
            const int here = x * channels + c;
            __m512i sum = load(layer.bias.data() + c);
            const std::int16_t* weight = layer.weights.data() + 2 * c;
            for (std::size_t tap = 0; tap < static_cast<std::size_t>(taps); tap += 2, weight += 2 * channels)
                sum = _mm512_dpwssd_epi32(sum, beside(at[tap] + here, at[tap + 1] + here), load(weight));
            finish(sum, layer.shift, nullptr, 0, row.out + here);
        }
}

bool machine_has_avx512() {
    return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512bw") != 0 &&
           __builtin_cpu_supports("avx512vl") != 0 && __builtin_cpu_supports("avx512vnni") != 0;
}

}  // namespace

const NetKernel kAvx512Kernel{"avx512", machine_has_avx512, dense, each};

}  // namespace tactics

#endif
