// SPDX-License-Identifier: Apache-2.0
// A second reader of drawn tiles, as plain as it can be: an interval of exact fractions instead of a range and a code.
#include <gtest/gtest.h>

#include <map>
#include <random>

#include "tactics/coding/drawn_tile.h"
#include "tests/coding/levels.h"

namespace tactics::tests::drawn_twin_test {
namespace {

// The message is a number; the interval of what it may be begins at `low` and is `width` long, both in units that get 256 times
// smaller with each byte that is taken.
class PlainCoder {
public:
    explicit PlainCoder(const std::string& bytes) : bytes_(bytes) {
        for (int i = 0; i < 4; ++i) message_ = message_ * 256 + byte();
    }
    // The chance of a zero, of 65536, is learned.
    int decide(int& chance) {
        const std::uint64_t zero = width_ / 65536 * static_cast<std::uint64_t>(chance);
        const bool one = message_ - low_ >= zero;
        if (one) {
            low_ += zero;
            width_ -= zero;
            chance -= chance / 32;
        } else {
            width_ = zero;
            chance += (65536 - chance) / 32;
        }
        narrow();
        return one ? 1 : 0;
    }
    int even() {
        width_ /= 2;
        const bool one = message_ - low_ >= width_;
        if (one) low_ += width_;
        narrow();
        return one ? 1 : 0;
    }

private:
    std::uint64_t byte() { return next_ < bytes_.size() ? static_cast<unsigned char>(bytes_[next_++]) : 0; }
    void narrow() {
        while (width_ < (1u << 24)) {
            message_ -= low_;  // only their difference counts
            low_ = 0;
            width_ *= 256;
            message_ = message_ * 256 + byte();
        }
    }
    std::string bytes_;
    std::size_t next_ = 0;
    std::uint64_t message_ = 0, low_ = 0, width_ = 0xFFFFFFFF;
};

struct Place {
    int level = 0, right = 0;
    void remember(int now) {
        if (level == now)
            right = std::min(right + 1, 15);
        else if (right > 1)
            right /= 4;
        else
            *this = {now, 0};
    }
};

// Chances by what they are for; each begins as even.
class Chances {
public:
    int& of(const std::string& what, int a = 0, int b = 0, int c = 0) {
        return known_.try_emplace(std::tuple(what, a, b, c), 32768).first->second;
    }

private:
    std::map<std::tuple<std::string, int, int, int>, int> known_;
};

int number(PlainCoder& coder, Chances& chances) {
    int length = 0;
    while (length < 50 && coder.decide(chances.of("longer", length)) == 1) ++length;
    if (length == 0) return 0;
    int more = 2 + coder.decide(chances.of("second", length));
    for (int bit = 1; bit < length; ++bit) more = 2 * more + coder.even();
    return more - 1;
}

std::vector<Level> plainly_read(const std::string& bytes, int columns, int rows) {
    PlainCoder coder(bytes);
    Chances chances;
    std::map<std::uint64_t, Place> eleven, six;
    std::vector<Level> levels(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    const auto at = [&](int x, int y) -> std::uint64_t {
        return x < 0 || y < 0 || x >= columns ? 0 : levels[static_cast<std::size_t>(y * columns + x)];
    };
    int before = 7;
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) {
            const std::uint64_t left = at(x - 1, y), above = at(x, y - 1), corner = at(x - 1, y - 1), next = at(x + 1, y - 1);
            const std::uint64_t near = left + (above << 16) + (corner << 32) + (next << 48);
            const std::uint64_t six_key = near * 0x9E3779B97F4A7C15 + ((at(x - 2, y) << 16) + at(x, y - 2)) * 0xC2B2AE3D27D4EB4F;
            const std::uint64_t far = at(x - 2, y) + (at(x, y - 2) << 16) + (at(x - 2, y - 1) << 32) + (at(x + 2, y - 1) << 48);
            const std::uint64_t farthest = at(x - 3, y) + (at(x - 1, y - 2) << 16) + (at(x + 1, y - 2) << 32);
            const std::uint64_t eleven_key = near * 0x9E3779B97F4A7C15 + far * 0xC2B2AE3D27D4EB4F + farthest * 0x165667B19E3779F9;
            Place &first = eleven[eleven_key >> 48], &second = six[six_key >> 48];
            const int level_ground = left == above && left == corner && left == next ? 1 : 0;
            int level = 0, right = 0;
            if (coder.decide(chances.of("first", level_ground, first.right, before)) == 0) {
                level = first.level;
                right = 4;
            } else if (second.level != first.level && coder.decide(chances.of("second place", second.right)) == 0) {
                level = second.level;
            } else {
                const int step = number(coder, chances);
                const int l = static_cast<int>(left), a = static_cast<int>(above), c = static_cast<int>(corner);
                const int guess = c >= std::max(l, a) ? std::min(l, a) : c <= std::min(l, a) ? std::max(l, a) : l + a - c;
                level = guess + (step % 2 == 0 ? step / 2 : -(step + 1) / 2);
            }
            before = before / 2 + right;
            first.remember(level);
            second.remember(level);
            levels[static_cast<std::size_t>(y * columns + x)] = static_cast<Level>(level);
        }
    return levels;
}

TEST(DrawnTile, APlainReaderReadsTheSame) {
    for (const Ground ground : kGrounds)
        for (const int top : {1, 255, 65535}) {
            const LevelMap map = map_of(ground, 61, 47, top);
            const std::string bytes = drawn_bytes({map.levels.data(), 61, 47, 61}, top);
            ASSERT_EQ(plainly_read(bytes, 61, 47), map.levels) << static_cast<int>(ground) << " " << top;
        }
}

// Long even rows, of which many levels are passed at once, up to a speck at any place.
TEST(DrawnTile, APlainReaderReadsEvenGroundWithSpecks) {
    std::mt19937 random(11);
    for (const int top : {255, 65535})
        for (const int columns : {1, 2, 5, 130}) {
            std::vector<Level> levels(static_cast<std::size_t>(columns) * 40, Level{7});
            for (Level& level : levels)
                if (random() % 60 == 0) level = static_cast<Level>(random() % 3 == 0 ? top : 9);
            const std::string bytes = drawn_bytes({levels.data(), columns, 40, static_cast<std::size_t>(columns)}, top);
            ASSERT_EQ(plainly_read(bytes, columns, 40), levels) << columns << " " << top;
            std::vector<Level> read(levels.size());
            ASSERT_TRUE(read_drawn(bytes, {read.data(), columns, 40, static_cast<std::size_t>(columns)}, top));
            ASSERT_EQ(read, levels);
        }
}

}  // namespace
}  // namespace tactics::tests::drawn_twin_test
