// SPDX-License-Identifier: Apache-2.0
// Hostile .felt files. Sums keep most of them out, so the bytes are also taken as tiles and as a part of a recording whose sums
// fit. What is read keeps its promises, and heights come back from what is written of them.
#include <algorithm>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/coding/level_map.h"
#include "tactics/coding/level_tile.h"
#include "tactics/coding/recording.h"
#include "tactics/error.h"

namespace {

using namespace tactics;

constexpr long long kMost = 1'000'000;  // heights, or it takes its time

void require(bool holds) {
    if (!holds) std::abort();
}

void check_file(std::string_view bytes) {
    const Container container(bytes, "fuzz");
    if (container.kind() == ContainerKind::recording) {
        const Recording recording = decode_recording(container);
        require(recording.forces.size() == recording.times.size() && recording.places.size() == recording.times.size());
        require(std::is_sorted(recording.times.begin(), recording.times.end()));
        return;
    }
    const LevelMap map = decode_levels(container, kMost);
    require(*std::max_element(map.levels.begin(), map.levels.end()) <= map.top);
    const std::string again = encode_levels(map);
    require(decode_levels(Container(again, "again"), kMost).levels == map.levels);
}

void check_tile(std::string_view bytes, int columns, int rows, int top) {
    std::vector<Level> levels(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    if (read_tile(bytes, {levels.data(), columns, rows, static_cast<std::size_t>(columns)}, top))
        require(*std::max_element(levels.begin(), levels.end()) <= top);
}

// The facts of a recording of 300 ticks, made once.
std::string facts(ForceGuess guess) {
    Recording recording{1e-4, 1e-4, true, true, {}, {}, {}};
    recording.times.assign(300, 0);
    recording.places.assign(300, {});
    recording.forces.assign(300, {});
    const std::string bytes = encode_recording(recording, {0.1, 0.01, 0.1, guess}).bytes;
    return std::string(Container(bytes, "facts").facts());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    if (size < 3) return 0;
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    try {
        check_file(bytes);
    } catch (const Error&) {
    }
    check_tile(bytes.substr(2), 1 + data[0] % 64, 1 + data[1] % 64, data[0] < 128 ? 255 : 65535);
    static const std::string hold = facts(ForceGuess::hold), linear = facts(ForceGuess::linear);
    const std::vector<std::string> parts{std::string(bytes.substr(1))};
    try {
        check_file(container_bytes(ContainerKind::recording, data[0] % 2 == 0 ? hold : linear, parts));
    } catch (const Error&) {
    }
    return 0;
}
