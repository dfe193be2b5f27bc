// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/felt_file.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>

#include "tactics/error.h"
#include "tactics/readers/limits.h"
#include "tactics/readers/rows.h"

namespace tactics {

namespace {

bool begins_so(std::span<const unsigned char> head) {
    return std::string_view(reinterpret_cast<const char*>(head.data()), head.size()).starts_with(kContainerMagic);
}

PictureInfo inspect_felt_file(Source& source) {
    const std::string bytes = felt_bytes(source);
    const LevelMap map = map_facts(Container(bytes, source.name));
    check_whole_size(source.name, "a .felt file", map.columns, map.rows);
    return {"felt", map.columns, map.rows};
}

// Low is black, high is white.
Image read_felt_file(Source& source, const ReadRequest& request) {
    const LevelMap map = read_levels(source, kMaxWholePixels);
    RowReceiver<std::uint8_t> rows({{map.columns, map.rows}}, request);
    const auto width = static_cast<std::size_t>(map.columns);
    std::vector<std::uint8_t> row(width);
    const double white = 255 * map.rise / (map.high - map.low);
    for (auto level = map.levels.begin(); level != map.levels.end(); level += map.columns) {
        std::transform(level, level + map.columns, row.begin(),
                       [white](Level one) { return static_cast<std::uint8_t>(std::lround(std::min(255.0, white * one))); });
        rows.add(row.data());
    }
    return rows.finish();
}

}  // namespace

bool is_felt(Source& source) {
    if (source.file == nullptr) return false;
    std::array<unsigned char, kContainerMagic.size()> head{};
    std::rewind(source.file.get());
    const std::size_t got = std::fread(head.data(), 1, head.size(), source.file.get());
    std::rewind(source.file.get());
    return begins_so({head.data(), got});
}

std::string felt_bytes(Source& source) {
    std::string bytes;
    std::rewind(source.file.get());
    for (std::size_t step = 1u << 16;; step = std::min<std::size_t>(2 * step, 16u << 20)) {
        const std::size_t before = bytes.size();
        bytes.resize(before + step);
        const std::size_t got = std::fread(bytes.data() + before, 1, step, source.file.get());
        bytes.resize(before + got);
        if (got < step) break;
    }
    if (std::ferror(source.file.get()) != 0)
        throw Error(Fault::failed, source.name, phrase("cannot be read: {0}", std::strerror(errno)));
    return bytes;
}

LevelMap read_levels(Source& source, long long most) {
    const std::string bytes = felt_bytes(source);
    return decode_levels(Container(bytes, source.name), most);
}

extern const Reader felt_reader;
const Reader felt_reader{
    .name = "felt",
    .summary = "heights as convert, relief and encode pack them (tactics help felt)",
    .extensions = "felt",
    .recognises = begins_so,
    .inspect = inspect_felt_file,
    .read = read_felt_file,
};

}  // namespace tactics
