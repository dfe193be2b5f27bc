// SPDX-License-Identifier: Apache-2.0
#include "tactics/coding/level_tile.h"

#include <bit>
#include <cmath>
#include <cstdlib>

#include "tactics/coding/bytes.h"
#include "tactics/coding/drawn_tile.h"
#include "tactics/coding/slope_tile.h"

namespace tactics {

namespace {

constexpr int kEach = 16;  // of so many rows one is looked at
// Rows that are coded in both ways, and what drawn ones may have of the bytes of a slope. Where little is as guessed, little is
// drawn, which takes longer: few rows tell, over which the tables of a slope weigh. Where much is, what is drawn has to be
// learned first.
constexpr double kFewAsGuessed = 0.35, kManyAsGuessed = 0.6;
constexpr double kOfFew = 0.5, kOfSome = 0.9, kOfMany = 1.2;
constexpr int kTried = 48, kTriedOfFew = 12, kTriedOfMany = 4;  // of many, one of so many rows

unsigned bits_of(int top) { return static_cast<unsigned>(std::bit_width(static_cast<unsigned>(top))); }

std::size_t plain_size(std::size_t levels, int top) { return (levels * bits_of(top) + 7) / 8; }

std::string plain_bytes(const TileView<const Level>& tile, int top) {
    std::string bytes;
    bytes.reserve(plain_size(tile.size(), top));
    std::uint64_t held = 0;
    unsigned holds = 0;
    for (int y = 0; y < tile.rows; ++y)
        for (int x = 0; x < tile.columns; ++x) {
            held |= std::uint64_t{tile.row(y)[x]} << holds;
            for (holds += bits_of(top); holds >= 8; holds -= 8, held >>= 8)
                bytes += static_cast<char>(static_cast<unsigned char>(held & 0xFFu));
        }
    append_number(bytes, held, (holds + 7) / 8);
    return bytes;
}

bool read_plain(std::string_view bytes, const TileView<Level>& tile, int top) {
    if (bytes.size() != plain_size(tile.size(), top)) return false;
    std::uint64_t held = 0;
    unsigned holds = 0;
    std::size_t at = 0;
    for (int y = 0; y < tile.rows; ++y)
        for (int x = 0; x < tile.columns; ++x) {
            for (; holds < bits_of(top); holds += 8) held |= std::uint64_t{static_cast<unsigned char>(bytes[at++])} << holds;
            const auto level = static_cast<Level>(held & ((1u << bits_of(top)) - 1));
            if (level > top) return false;
            tile.row(y)[x] = level;
            held >>= bits_of(top);
            holds -= bits_of(top);
        }
    return true;
}

bool is_even(const TileView<const Level>& tile) {
    for (int y = 0; y < tile.rows; ++y)
        for (int x = 0; x < tile.columns; ++x)
            if (tile.row(y)[x] != *tile.first) return false;
    return true;
}

// How many of the levels are as their neighbours let one guess.
double share_as_guessed(const TileView<const Level>& tile) {
    std::size_t as_guessed = 0, seen = 0;
    for (int y = 1; y < tile.rows; y += kEach) {
        const Level *row = tile.row(y), *above = tile.row(y - 1);
        for (int x = 1; x < tile.columns; ++x, ++seen) as_guessed += row[x] == guess_of(row[x - 1], above[x], above[x - 1]);
    }
    return seen == 0 ? 0 : static_cast<double>(as_guessed) / static_cast<double>(seen);
}

}  // namespace

TileWay way_of(const TileView<const Level>& tile, int top) {
    const double as_guessed = share_as_guessed(tile);
    const bool few = as_guessed<kFewAsGuessed, many = as_guessed> kManyAsGuessed;
    TileView<const Level> tried = tile;
    tried.rows = std::min(tile.rows, few ? kTriedOfFew : many ? std::max(kTried, tile.rows / kTriedOfMany) : kTried);
    tried.first = tile.row((tile.rows - tried.rows) / 2);
    const double most = (few ? kOfFew : many ? kOfMany : kOfSome) * static_cast<double>(slope_bytes(tried, top).size());
    const auto drawn = static_cast<double>(drawn_bytes(tried, top, static_cast<std::size_t>(std::ceil(most))).size());
    return drawn < most ? TileWay::drawn : TileWay::slope;
}

std::string tile_bytes(const TileView<const Level>& tile, int top, std::optional<TileWay> known) {
    const auto begun_with = [](TileWay way) { return std::string(1, static_cast<char>(way)); };
    if (is_even(tile)) {
        std::string bytes = begun_with(TileWay::even);
        append_number(bytes, *tile.first, 2);
        return bytes;
    }
    const TileWay way = known ? *known : way_of(tile, top);
    std::string bytes = begun_with(way);
    bytes += way == TileWay::drawn ? drawn_bytes(tile, top) : slope_bytes(tile, top);
    if (bytes.size() <= plain_size(tile.size(), top)) return bytes;
    return begun_with(TileWay::plain) + plain_bytes(tile, top);
}

bool read_tile(std::string_view bytes, const TileView<Level>& tile, int top) {
    if (bytes.empty()) return false;
    const std::string_view rest = bytes.substr(1);
    switch (static_cast<TileWay>(bytes[0])) {
        case TileWay::plain: return read_plain(rest, tile, top);
        case TileWay::slope: return read_slope(rest, tile, top);
        case TileWay::drawn: return read_drawn(rest, tile, top);
        case TileWay::even: break;
        default: return false;
    }
    ByteReader reader(rest);
    const std::uint64_t level = reader.number(2);
    if (rest.size() != 2 || level > static_cast<std::uint64_t>(top)) return false;
    for (int y = 0; y < tile.rows; ++y) std::fill_n(tile.row(y), tile.columns, static_cast<Level>(level));
    return true;
}

}  // namespace tactics
