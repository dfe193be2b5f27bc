// SPDX-License-Identifier: Apache-2.0
#include "tactics/coding/level_map.h"

#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <stdexcept>

#include "tactics/coding/bytes.h"
#include "tactics/coding/level_tile.h"
#include "tactics/error.h"

namespace tactics {

namespace {

// Tables of a slope fit 512 x 512 levels, and fit the memory next to the processor; what was drawn is remembered longer.
constexpr int kSlopeSide = 512, kDrawnSide = 1024;
constexpr int kMostSide = 200'000, kMostTileSide = 4096;
constexpr double kRounding = 1e-9;
constexpr std::array<std::string_view, 3> kProfiles{"", "round", "flat"};

int count_of(int size, int side) { return (size + side - 1) / side; }

template <typename Value>
TileView<Value> view_of(Value* levels, int columns, int left, int top, int tile_columns, int tile_rows) {
    const auto stride = static_cast<std::size_t>(columns);
    return {levels + static_cast<std::size_t>(top) * stride + static_cast<std::size_t>(left), tile_columns, tile_rows, stride};
}

struct Facts {
    LevelMap map;
    int side = 0;
};

Facts facts_of(const Container& container) {
    if (container.kind() != ContainerKind::heights)
        throw Error(Fault::failed, container.name(), phrase("holds a recording and no heights; tactics decode gives it out"));
    ByteReader reader(container.facts());
    const std::uint64_t columns = reader.number(4), rows = reader.number(4);
    LevelMap map;
    map.pitch = reader.real();
    map.low = reader.real();
    map.high = reader.real();
    map.rise = reader.real();
    map.top = static_cast<int>(reader.number(2));
    const auto side = static_cast<int>(reader.number(2));
    const std::uint64_t profile = reader.number(1), rest = reader.number(1);
    if (!reader.whole() || reader.left() > 0 || rest != 0) container.fail(phrase("its facts are none of heights"));
    if (columns < 1 || rows < 1 || columns > kMostSide || rows > kMostSide)
        container.fail(phrase("it tells of {0} x {1} levels", std::to_string(columns), std::to_string(rows)));
    if (!(map.pitch > 0) || !std::isfinite(map.pitch) || !std::isfinite(map.low) || !std::isfinite(map.high) ||
        !(map.high > map.low))
        container.fail(phrase("its pitch or its heights are no lengths"));
    if (!(map.rise > 0) || !(map.rise * map.top <= (map.high - map.low) * (1 + kRounding)))
        container.fail(phrase("its levels go above its highest place"));
    if (map.top < 1 || side < 1 || side > kMostTileSide || profile >= kProfiles.size())
        container.fail(phrase("a fact of it is none that there is"));
    map.columns = static_cast<int>(columns);
    map.rows = static_cast<int>(rows);
    map.profile = kProfiles[profile];
    const auto tiles = static_cast<std::size_t>(count_of(map.columns, side)) * static_cast<std::size_t>(count_of(map.rows, side));
    if (container.parts() != tiles) container.fail(phrase("it has not as many parts as tiles"));
    return {std::move(map), side};
}

// The part of a tile that lies in the window goes to where that is in `map`.
void copy_tile(const std::vector<Level>& tile, const LevelWindow& from, const LevelWindow& window, LevelMap& map) {
    const int left = std::max(from.left, window.left), right = std::min(from.left + from.columns, window.left + window.columns);
    const int top = std::max(from.top, window.top), bottom = std::min(from.top + from.rows, window.top + window.rows);
    for (int y = top; y < bottom; ++y)
        std::copy_n(view_of(tile.data(), from.columns, left - from.left, y - from.top, 1, 1).first, right - left,
                    view_of(map.levels.data(), map.columns, left - window.left, y - window.top, 1, 1).first);
}

}  // namespace

LevelMap with_fewest_levels(LevelMap map) {
    int step = 0;
    for (const Level level : map.levels) {
        step = std::gcd(step, static_cast<int>(level));
        if (step == 1) return map;
    }
    if (step == 0) step = map.top;  // all are the lowest
    for (Level& level : map.levels) level = static_cast<Level>(level / step);
    map.top /= step;
    map.rise *= step;
    return map;
}

std::string encode_levels(const LevelMap& map) {
    if (map.columns < 1 || map.rows < 1 || map.top < 1 || map.top > 65535 || map.columns > kMostSide || map.rows > kMostSide)
        throw std::logic_error("no map of levels");
    const auto profile = std::find(kProfiles.begin(), kProfiles.end(), map.profile);
    if (profile == kProfiles.end()) throw std::logic_error("no profile of lines");
    const TileWay way = way_of(view_of(map.levels.data(), map.columns, 0, 0, map.columns, map.rows), map.top);
    const int side = way == TileWay::drawn ? kDrawnSide : kSlopeSide;
    const std::optional<TileWay> of_all = map.columns <= side && map.rows <= side ? std::optional(way) : std::nullopt;
    std::string facts;
    append_number(facts, static_cast<std::uint64_t>(map.columns), 4);
    append_number(facts, static_cast<std::uint64_t>(map.rows), 4);
    for (const double length : {map.pitch, map.low, map.high, map.rise}) append_double(facts, length);
    append_number(facts, static_cast<std::uint64_t>(map.top), 2);
    append_number(facts, static_cast<std::uint64_t>(side), 2);
    append_number(facts, static_cast<std::uint64_t>(profile - kProfiles.begin()), 1);
    append_number(facts, 0, 1);
    std::vector<std::string> tiles;
    for (int top = 0; top < map.rows; top += side)
        for (int left = 0; left < map.columns; left += side)
            tiles.push_back(tile_bytes(view_of(map.levels.data(), map.columns, left, top, std::min(side, map.columns - left),
                                               std::min(side, map.rows - top)),
                                       map.top, of_all));
    return container_bytes(ContainerKind::heights, facts, tiles);
}

LevelMap map_facts(const Container& container) { return facts_of(container).map; }

LevelMap decode_levels(const Container& container, const LevelWindow& window, long long most) {
    auto [map, side] = facts_of(container);
    if (window.left < 0 || window.top < 0 || window.columns < 1 || window.rows < 1 ||
        window.left > map.columns - window.columns || window.top > map.rows - window.rows)
        throw std::logic_error("a window beyond its map");
    const int across = count_of(map.columns, side), whole_columns = map.columns, whole_rows = map.rows;
    const long long count = static_cast<long long>(window.columns) * window.rows;
    if (count > most)
        throw Error(Fault::failed, container.name(),
                    phrase("has {0} x {1} heights; at most {2} million are read, make it smaller first",
                           std::to_string(window.columns), std::to_string(window.rows), std::to_string(most / 1'000'000)));
    map.columns = window.columns;
    map.rows = window.rows;
    map.levels.resize(static_cast<std::size_t>(count));
    std::vector<Level> apart;
    for (int row = window.top / side; row * side < window.top + window.rows; ++row)
        for (int column = window.left / side; column * side < window.left + window.columns; ++column) {
            const LevelWindow tile{column * side, row * side, std::min(side, whole_columns - column * side),
                                   std::min(side, whole_rows - row * side)};
            const auto number =
                static_cast<std::size_t>(row) * static_cast<std::size_t>(across) + static_cast<std::size_t>(column);
            const bool within = tile.left >= window.left && tile.top >= window.top &&
                                tile.left + tile.columns <= window.left + window.columns &&
                                tile.top + tile.rows <= window.top + window.rows;
            TileView<Level> view;
            if (within) {
                view = view_of(map.levels.data(), map.columns, tile.left - window.left, tile.top - window.top, tile.columns,
                               tile.rows);
            } else {
                apart.resize(static_cast<std::size_t>(tile.columns) * static_cast<std::size_t>(tile.rows));
                view = view_of(apart.data(), tile.columns, 0, 0, tile.columns, tile.rows);
            }
            if (!read_tile(container.part(number), view, map.top))
                container.fail(phrase("tile {0} is none", std::to_string(number + 1)));
            if (!within) copy_tile(apart, tile, window, map);
        }
    return std::move(map);
}

LevelMap decode_levels(const Container& container, long long most) {
    const LevelMap map = map_facts(container);
    return decode_levels(container, {0, 0, map.columns, map.rows}, most);
}

}  // namespace tactics
