// SPDX-License-Identifier: Apache-2.0
// Any grid: its first bytes say how wide it is, how many levels it has and on what it is to be felt, the others are its values.
// What is told of it keeps to its bounds.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "tactics/error.h"
#include "tactics/information/least_loss.h"
#include "tactics/information/media.h"

using namespace tactics;

namespace {

void expect(bool holds) {
    if (!holds) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr std::size_t kHead = 4, kMost = 4096;
    if (size < kHead + 1 || size > kMost) return 0;
    const int columns = 1 + data[0] % 64, levels = 2 + (data[1] | data[2] << 8) % (kMostLevels - 1);
    std::vector<std::uint16_t> values;
    for (std::size_t i = kHead; i < size; ++i)
        values.push_back(
            static_cast<std::uint16_t>(static_cast<std::uint64_t>(data[i]) * 257 * static_cast<unsigned>(levels) >> 16));
    const int rows = static_cast<int>(values.size()) / columns;
    if (rows < 1) return 0;
    values.resize(static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns));
    try {
        MeasuredScene scene = scene_of({columns, rows, 1, levels, std::move(values)}, 0.5, 0, 10, "grid");
        const Measures& measures = scene.measures;
        expect(measures.low >= 0 && measures.low <= measures.high && measures.high <= measures.raw);
        expect(measures.felt && *measures.felt >= 0 && *measures.felt <= measures.high);
        expect(std::isfinite(measures.topology) && measures.topology <= 1);
        static const std::vector<MediumChannel> kChannels = channels({});
        const MediumChannel& channel = kChannels[data[3] % kChannels.size()];
        const Carried carried = carried_by(scene, channel);
        expect(carried.bits >= 0 && carried.bits <= measures.high && carried.loss >= 0 && carried.loss <= 1);
        expect(least_loss(scene, channel).loss <= carried.loss);
    } catch (const Error&) {
    }
    return 0;
}
