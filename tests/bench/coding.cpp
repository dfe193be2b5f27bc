// SPDX-License-Identifier: Apache-2.0
// How small files of heights become, and how quickly: the container against PNG, zlib and lzma, each as hard as it tries.
//     build/coding MAP.png...    a table; with --csv for programs
// A map is as a file of heights has it, in the fewest levels that tell it; raw are its levels, a byte each up to 256 of them,
// else two. PNG is libpng with level 9 and all its filters to choose from, zlib level 9, lzma preset 9 and "extreme". Speed is
// that of raw bytes on one core, by processor time, the best of nine runs.
#include <lzma.h>
#include <png.h>
#include <zlib.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

#include "print/height_files.h"
#include "tactics/error.h"
#include "tactics/relief/read_heights.h"

namespace {

using namespace tactics;

std::string raw_of(const LevelMap& map, bool big_end_first) {
    std::string raw;
    for (const Level level : map.levels) {
        const auto low = static_cast<char>(static_cast<unsigned char>(level & 0xFF));
        const auto high = static_cast<char>(static_cast<unsigned char>(level >> 8));
        if (map.top < 256)
            raw += low;
        else
            raw += big_end_first ? std::string{high, low} : std::string{low, high};
    }
    return raw;
}

std::size_t png_size(const LevelMap& map) {
    std::string raw = raw_of(map, true), file;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    const auto add = [](png_structp to, png_bytep bytes, png_size_t size) {
        static_cast<std::string*>(png_get_io_ptr(to))->append(reinterpret_cast<const char*>(bytes), size);
    };
    png_set_write_fn(png, &file, add, nullptr);
    png_set_compression_level(png, 9);
    png_set_filter(png, 0, PNG_ALL_FILTERS);
    png_set_IHDR(png, info, static_cast<png_uint_32>(map.columns), static_cast<png_uint_32>(map.rows), map.top < 256 ? 8 : 16,
                 PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    const std::size_t stride = raw.size() / static_cast<std::size_t>(map.rows);
    for (std::size_t at = 0; at < raw.size(); at += stride) png_write_row(png, reinterpret_cast<png_bytep>(raw.data() + at));
    png_write_end(png, nullptr);
    png_destroy_write_struct(&png, &info);
    return file.size();
}

std::size_t zlib_size(const std::string& raw) {
    uLongf size = compressBound(static_cast<uLong>(raw.size()));
    std::string packed(size, '\0');
    compress2(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(raw.data()),
              static_cast<uLong>(raw.size()), 9);
    return size;
}

std::size_t lzma_size(const std::string& raw) {
    lzma_options_lzma options;
    lzma_lzma_preset(&options, 9 | LZMA_PRESET_EXTREME);
    lzma_stream stream = LZMA_STREAM_INIT;
    if (lzma_alone_encoder(&stream, &options) != LZMA_OK) return 0;
    std::string packed(raw.size() + raw.size() / 2 + 4096, '\0');
    stream.next_in = reinterpret_cast<const std::uint8_t*>(raw.data());
    stream.avail_in = raw.size();
    stream.next_out = reinterpret_cast<std::uint8_t*>(packed.data());
    stream.avail_out = packed.size();
    const bool whole = lzma_code(&stream, LZMA_FINISH) == LZMA_STREAM_END;
    const std::size_t size = whole ? stream.total_out : 0;
    lzma_end(&stream);
    return size;
}

double processor_time() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

template <typename Work>
double best_seconds(const Work& work) {
    constexpr int kRuns = 9;
    double best = 1e9;
    for (int run = 0; run < kRuns; ++run) {
        const double begun = processor_time();
        work();
        best = std::min(best, processor_time() - begun);
    }
    return best;
}

}  // namespace

int main(int count, char** words) {
    bool csv = false;
    int smaller = 0, maps = 0;
    for (int i = 1; i < count; ++i) {
        if (std::string(words[i]) == "--csv") {
            csv = true;
            std::printf("map,raw,ours,png,zlib,lzma,encode_mb_s,decode_mb_s\n");
            continue;
        }
        const HeightFile file = read_heights(words[i], {});
        const LevelMap map = level_map_of(sheet_of(file.map, file.low, file.high), rows_of(file.map));
        const std::string raw = raw_of(map, false), bytes = encode_levels(map);
        const double encode = best_seconds([&] { encode_levels(map); });
        bool same = true;
        const double decode =
            best_seconds([&] { same = same && decode_levels(Container(bytes, words[i]), 1'000'000'000).levels == map.levels; });
        if (!same) {
            std::fprintf(stderr, "%s: it did not come back\n", words[i]);
            return 1;
        }
        std::string name = words[i];
        name = name.substr(name.rfind('/') + 1);
        name = name.substr(0, name.find('.'));
        const std::size_t png = png_size(map), zlib = zlib_size(raw), lzma = lzma_size(raw);
        const double mb = static_cast<double>(raw.size()) / 1e6;
        if (csv) {
            std::printf("%s,%zu,%zu,%zu,%zu,%zu,%.0f,%.0f\n", name.c_str(), raw.size(), bytes.size(), png, zlib, lzma,
                        mb / encode, mb / decode);
            continue;
        }
        if (maps == 0)
            std::printf("| map | raw | ours | PNG | zlib -9 | lzma -9 | encode, decode, MB/s |\n|---|---|---|---|---|---|---|\n");
        std::printf("| %s, %d x %d, %d levels | %zu | %zu | %zu | %zu | %zu | %.0f, %.0f |\n", name.c_str(), map.columns,
                    map.rows, map.top + 1, raw.size(), bytes.size(), png, zlib, lzma, mb / encode, mb / decode);
        std::fflush(stdout);
        ++maps;
        smaller += bytes.size() < std::min({png, zlib, lzma}) ? 1 : 0;
    }
    if (!csv) std::printf("\nsmaller than the best of the others: %d of %d\n", smaller, maps);
    return 0;
}
