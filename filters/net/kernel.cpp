// SPDX-License-Identifier: Apache-2.0
#include "filters/net/kernel.h"

#include <algorithm>

namespace tactics {

namespace {

std::int16_t held(std::int32_t value, std::int32_t least) {
    return static_cast<std::int16_t>(std::clamp(value, least, kMostActivation));
}

void dense(const DenseRow& row) {
    const NetLayer& layer = *row.layer;
    const int pairs = layer.side * layer.inputs / 2, outputs = layer.outputs;
    std::array<std::int32_t, kMostChannels> sums{};
    for (int x = 0; x < row.pixels; ++x) {
        std::copy_n(layer.bias.begin(), outputs, sums.begin());
        const std::int16_t* weight = layer.weights.data();
        for (int down = 0; down < layer.side; ++down) {
            const std::int16_t* in = row.in[static_cast<std::size_t>(down)] + x * layer.inputs;
            for (int pair = 0; pair < pairs; ++pair, in += 2, weight += 2 * outputs)
                for (int o = 0; o < outputs; ++o)
                    sums[static_cast<std::size_t>(o)] += in[0] * weight[2 * o] + in[1] * weight[2 * o + 1];
        }
        for (int o = 0; o < outputs; ++o) {
            const int i = x * outputs + o;
            const std::int32_t sum = (sums[static_cast<std::size_t>(o)] + (1 << (layer.shift - 1))) >> layer.shift;
            row.out[i] = held(sum + (row.add != nullptr ? row.add[i] : 0), row.least);
        }
    }
}

void each(const EachRow& row) {
    const NetLayer& layer = *row.layer;
    const int channels = layer.outputs;
    std::array<std::int32_t, kMostChannels> sums{};
    for (int x = 0; x < row.pixels; ++x) {
        std::copy_n(layer.bias.begin(), channels, sums.begin());
        for (int tap = 0; tap < layer.side * layer.side; ++tap) {
            const std::int16_t* in = row.in[static_cast<std::size_t>(tap / layer.side)] + (x + tap % layer.side) * channels;
            const std::int16_t* weight = layer.weights.data() + tap / 2 * 2 * channels + tap % 2;
            for (int c = 0; c < channels; ++c) sums[static_cast<std::size_t>(c)] += in[c] * weight[2 * c];
        }
        for (int c = 0; c < channels; ++c)
            row.out[x * channels + c] = held((sums[static_cast<std::size_t>(c)] + (1 << (layer.shift - 1))) >> layer.shift, 0);
    }
}

bool always() { return true; }

}  // namespace

const NetKernel kPlainKernel{"plain", always, dense, each};

NetTaps taps_of(const EachRow& row) {
    const NetLayer& layer = *row.layer;
    const int taps = layer.side * layer.side;
    NetTaps at{};
    for (int tap = 0; tap < taps; ++tap)
        at[static_cast<std::size_t>(tap)] = row.in[static_cast<std::size_t>(tap / layer.side)] + tap % layer.side * layer.outputs;
    at[static_cast<std::size_t>(taps)] = at[0];
    return at;
}

std::span<const NetKernel* const> net_kernels() {
    static const std::vector<const NetKernel*> kKernels = [] {
        std::vector<const NetKernel*> running;
#if defined(__x86_64__)
        for (const NetKernel* kernel : {&kAvx512Kernel, &kAvx2Kernel, &kSse2Kernel})
            if (kernel->runs_here()) running.push_back(kernel);
#elif defined(__aarch64__)
        running.push_back(&kNeonKernel);
#endif
        running.push_back(&kPlainKernel);
        return running;
    }();
    return kKernels;
}

}  // namespace tactics
