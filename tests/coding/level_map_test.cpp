// SPDX-License-Identifier: Apache-2.0
#include "tactics/coding/level_map.h"

#include <gtest/gtest.h>

#include <limits>

#include "tactics/coding/bytes.h"
#include "tactics/coding/level_tile.h"
#include "tactics/error.h"
#include "tests/coding/levels.h"

namespace tactics::tests::level_map_test {
namespace {

std::string fault_of(const std::string& bytes) {
    try {
        decoded(bytes);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(LevelMap, ComesBackAsItWas) {
    const std::pair<int, int> sizes[] = {{1, 1}, {1, 700}, {700, 1}, {2, 2}, {3, 5}, {511, 3}, {512, 4}, {513, 514}, {64, 1100}};
    for (const Ground ground : kGrounds)
        for (const auto& [columns, rows] : sizes)
            for (const int top : {1, 2, 255, 4095, 65535}) {
                const LevelMap map = map_of(ground, columns, rows, top), back = decoded(encode_levels(map));
                ASSERT_EQ(back.levels, map.levels)
                    << "ground " << static_cast<int>(ground) << ", " << columns << " x " << rows << ", top " << top;
                EXPECT_EQ(back.columns, columns);
                EXPECT_EQ(back.rows, rows);
                EXPECT_EQ(back.top, top);
                EXPECT_EQ(back.rise, map.rise);
                EXPECT_EQ(back.pitch, map.pitch);
                EXPECT_EQ(back.low, map.low);
                EXPECT_EQ(back.high, map.high);
                EXPECT_EQ(back.profile, map.profile);
            }
}

// Sums of files that the first release of version 1 wrote: what one machine packs another has packed alike, and old files are
// read.
TEST(LevelMap, BytesAreThoseOfVersionOne) {
    const std::pair<int, std::uint32_t> sums[] = {{1, 0x9CAEB549},   {2, 0x49E4FC30},    {200, 0xF64349BF},
                                                  {255, 0xA642A981}, {4095, 0xD5B72AE1}, {65535, 0x9302A402}};
    for (const auto& [top, sum] : sums) {
        LevelMap map{300, 200, 0.25, -1.5, 8.25, 9.75 / top, top, "", {}};
        std::mt19937 random(7);
        for (int y = 0; y < map.rows; ++y)
            for (int x = 0; x < map.columns; ++x) {
                const int hill = std::abs((x * 3 + y) % 400 - 200) + std::abs((y * 5) % 300 - 150);
                const auto noise = static_cast<int>(random() % static_cast<unsigned>(1 + top / 12));
                map.levels.push_back(static_cast<Level>((hill * top / 350 * 9 + noise) / 10));
            }
        EXPECT_EQ(crc32_of(encode_levels(map)), sum) << top;
    }
}

// Eight bytes at once, and one after the other.
TEST(LevelMap, SumsAreThoseOfIso3309) {
    std::mt19937 random(1);
    std::string bytes;
    for (int size = 0; size < 70; ++size, bytes += static_cast<char>(random())) {
        std::uint32_t rest = 0xFFFFFFFFu;
        for (const char byte : bytes) {
            rest ^= static_cast<unsigned char>(byte);
            for (int bit = 0; bit < 8; ++bit) rest = (rest & 1u) != 0 ? rest >> 1 ^ 0xEDB88320u : rest >> 1;
        }
        EXPECT_EQ(crc32_of(bytes), ~rest) << size;
    }
    EXPECT_EQ(crc32_of("123456789"), 0xCBF43926u);
}

TEST(LevelMap, EachWayOfATileIsTaken) {
    const auto way = [](Ground ground, int top) {
        const LevelMap map = map_of(ground, 200, 200, top);
        return static_cast<TileWay>(tile_bytes({map.levels.data(), 200, 200, 200}, top)[0]);
    };
    EXPECT_EQ(way(Ground::even, 255), TileWay::even);
    EXPECT_EQ(way(Ground::hills, 65535), TileWay::slope);
    EXPECT_EQ(way(Ground::letters, 255), TileWay::drawn);
    EXPECT_EQ(way(Ground::noise, 255), TileWay::plain);
}

TEST(LevelMap, NothingGrowsMuchAndWhatIsPlainIsSmall) {
    for (const Ground ground : kGrounds) {
        const std::string bytes = encode_levels(map_of(ground, 600, 600, 255));
        EXPECT_LE(bytes.size(), 600u * 600u + 200u) << static_cast<int>(ground);
    }
    EXPECT_LT(encode_levels(map_of(Ground::even, 1000, 1000, 65535)).size(), 150u);
    EXPECT_LT(encode_levels(map_of(Ground::ends, 512, 512, 65535)).size(), 1500u);
    // The letters come again and again: remembered, they cost less than half a bit each.
    EXPECT_LT(encode_levels(map_of(Ground::letters, 1000, 1000, 255)).size(), 60'000u);
}

TEST(LevelMap, AWindowIsAPartOfTheWhole) {
    std::mt19937 random(5);
    for (const Ground ground : {Ground::hills, Ground::letters}) {
        const LevelMap map = map_of(ground, 1200, 1300, 4095);
        const std::string bytes = encode_levels(map);
        const Container container(bytes, "map.felt");
        for (int i = 0; i < 12; ++i) {
            LevelWindow window{static_cast<int>(random() % 1200), static_cast<int>(random() % 1300), 0, 0};
            window.columns = 1 + static_cast<int>(random() % static_cast<unsigned>(1200 - window.left));
            window.rows = 1 + static_cast<int>(random() % static_cast<unsigned>(1300 - window.top));
            const LevelMap part = decode_levels(container, window, 10'000'000);
            ASSERT_EQ(part.levels.size(), static_cast<std::size_t>(window.columns) * static_cast<std::size_t>(window.rows));
            for (int y = 0; y < window.rows; ++y)
                for (int x = 0; x < window.columns; ++x)
                    ASSERT_EQ(part.levels[static_cast<std::size_t>(y * window.columns + x)],
                              map.levels[static_cast<std::size_t>((window.top + y) * 1200 + window.left + x)]);
        }
    }
}

TEST(LevelMap, AWindowReadsTheTilesThatItMeetsOnly) {
    std::string bytes = encode_levels(map_of(Ground::hills, 1200, 600, 4095));
    bytes.back() = static_cast<char>(bytes.back() ^ 1);  // in the last tile
    const Container container(bytes, "map.felt");
    EXPECT_NO_THROW(decode_levels(container, {0, 0, 500, 500}, 10'000'000));
    EXPECT_THROW(decode_levels(container, {1100, 550, 10, 10}, 10'000'000), Error);
}

TEST(LevelMap, CutOffAnywhereOrChangedAnywhereItIsRefused) {
    for (const Ground ground : {Ground::hills, Ground::letters, Ground::noise}) {
        const std::string bytes = encode_levels(map_of(ground, 60, 50, 255));
        for (std::size_t size = 0; size < bytes.size(); ++size) ASSERT_NE(fault_of(bytes.substr(0, size)), "") << size;
        for (std::size_t i = 0; i < bytes.size(); ++i) {
            std::string changed = bytes;
            changed[i] = static_cast<char>(changed[i] ^ (1 << (i % 8)));
            ASSERT_NE(fault_of(changed), "") << i;
        }
        EXPECT_EQ(fault_of(bytes + "x"), "map.felt: is damaged: something stands behind its end; get a complete copy of it");
    }
    EXPECT_EQ(fault_of("plain text"), "map.felt: is no .felt file; make one with tactics encode");
}

// With sums that fit, as somebody could make them: what comes out is a map, or an error.
TEST(LevelMap, HostileTilesGiveAnErrorOrLevelsThatThereAre) {
    std::mt19937 random(3);
    int refused = 0, taken = 0;
    for (const Ground ground : kGrounds) {
        const LevelMap map = map_of(ground, 40, 30, 200);
        const std::string tile = tile_bytes({map.levels.data(), 40, 30, 40}, 200);
        std::vector<Level> levels(map.levels.size());
        for (std::size_t i = 0; i < 40 * tile.size(); ++i) {
            std::string hostile = tile;
            for (unsigned change = 0; change <= random() % 3; ++change)
                hostile[random() % hostile.size()] = static_cast<char>(random());
            if (random() % 4 == 0) hostile.resize(random() % (hostile.size() + 20));
            const bool fits = read_tile(hostile, {levels.data(), 40, 30, 40}, 200);
            ++(fits ? taken : refused);
            if (fits) {
                ASSERT_LE(*std::max_element(levels.begin(), levels.end()), 200);
            }
        }
    }
    EXPECT_GT(refused, 1000);
    EXPECT_GT(taken, 10);
}

TEST(LevelMap, FactsThatCannotBeAreRefused) {
    const std::string bytes = encode_levels(map_of(Ground::hills, 20, 20, 255));
    const Container container(bytes, "map.felt");
    const std::vector<std::string> parts{std::string(container.part(0))};
    const auto with = [&](std::size_t at, std::uint64_t number, std::size_t size) {
        std::string facts(container.facts()), told;
        append_number(told, number, size);
        facts.replace(at, size, told);
        return fault_of(container_bytes(ContainerKind::heights, facts, parts));
    };
    EXPECT_EQ(with(0, 20, 4), "");
    EXPECT_EQ(with(0, 0, 4), "map.felt: is damaged: it tells of 0 x 20 levels; get a complete copy of it");
    for (const auto& [at, number, size] : std::initializer_list<std::tuple<std::size_t, std::uint64_t, std::size_t>>{
             {0, 0xFFFFFFFF, 4},
             {4, 200'001, 4},
             {8, 0x7FF8000000000000, 8},  // NaN
             {8, 0, 8},
             {16, 0x7FF0000000000000, 8},  // infinite
             {24, 0xC059000000000000, 8},  // -100, below the lowest
             {32, 0x4024000000000000, 8},  // 10 mm from one level to the next
             {32, 0, 8},
             {40, 0, 2},
             {42, 0, 2},
             {42, 4097, 2},
             {42, 7, 2},  // more tiles than parts
             {44, 3, 1},
             {45, 1, 1}})
        EXPECT_NE(with(at, number, size), "") << at << " " << number;
    EXPECT_NE(fault_of(container_bytes(ContainerKind::heights, container.facts().substr(1), parts)), "");
    EXPECT_NE(fault_of(container_bytes(ContainerKind::recording, container.facts(), parts)), "");
    EXPECT_NE(fault_of(container_bytes(static_cast<ContainerKind>(9), container.facts(), parts)), "");
}

// One byte of a tile could stand for millions of levels: more than are wanted get no memory.
TEST(LevelMap, MoreLevelsThanWantedAreRefusedBeforeTheyAreRead) {
    const std::string bytes = encode_levels(map_of(Ground::even, 1000, 1000, 255));
    try {
        decode_levels(Container(bytes, "map.felt"), 999'999);
        FAIL();
    } catch (const Error& error) {
        EXPECT_TRUE(std::string(error.what()).starts_with("map.felt: has 1000 x 1000 heights; at most 0 million"));
    }
}

TEST(LevelMap, TheFewestLevelsTellTheSameHeights) {
    LevelMap map = map_of(Ground::hills, 50, 50, 255);
    for (Level& level : map.levels) level = static_cast<Level>(257 * level);
    map.top = 65535;
    const LevelMap few = with_fewest_levels(map);
    EXPECT_EQ(few.top, 255);
    for (std::size_t i = 0; i < map.levels.size(); ++i) ASSERT_EQ(few.levels[i] * 257, map.levels[i]);
    EXPECT_NEAR(few.rise, 257 * map.rise, 1e-12);
    map.levels[7] = 256;
    EXPECT_EQ(with_fewest_levels(map).top, 65535);
    for (Level& level : map.levels) level = static_cast<Level>(level / 16 * 16);
    EXPECT_EQ(with_fewest_levels(map).top, 4095);
    map.levels.assign(map.levels.size(), 0);
    EXPECT_EQ(with_fewest_levels(map).top, 1);
}

TEST(Bytes, TheSumIsThatOfTheStandard) {
    EXPECT_EQ(crc32_of("123456789"), 0xCBF43926u);
    EXPECT_EQ(crc32_of(""), 0u);
}

}  // namespace
}  // namespace tactics::tests::level_map_test
