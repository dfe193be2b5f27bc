// SPDX-License-Identifier: Apache-2.0
#include "tactics/coding/drawn_tile.h"

#include <array>
#include <vector>

#include "tactics/coding/binary_coder.h"

namespace tactics {

namespace {

constexpr unsigned kPlaceBits = 16;

// What followed some neighbours, and how often in a row.
struct Remembered {
    Level level = 0;
    std::uint8_t right = 0;
};
constexpr std::uint8_t kMostRight = 15;

void remember(Remembered& place, Level level) noexcept {
    if (place.level == level) {
        if (place.right < kMostRight) ++place.right;
    } else if (place.right > 1) {
        place.right = static_cast<std::uint8_t>(place.right / 4);
    } else {
        place = {level, 0};
    }
}

// The levels around, row by row, and the places in memory that they mean.
struct Neighbours {
    const Level *row, *above, *far_above;  // at the level itself, and over it
    // left, far left, above, far above, and both beside `above`
    std::size_t six() const noexcept {
        const std::uint64_t near = std::uint64_t{row[-1]} | std::uint64_t{above[0]} << 16 | std::uint64_t{above[-1]} << 32 |
                                   std::uint64_t{above[1]} << 48;
        const std::uint64_t far = std::uint64_t{row[-2]} << 16 | far_above[0];
        return static_cast<std::size_t>((near * kMix[0] + far * kMix[1]) >> (64 - kPlaceBits));
    }
    // and five more around those
    std::size_t eleven() const noexcept {
        const std::uint64_t near = std::uint64_t{row[-1]} | std::uint64_t{above[0]} << 16 | std::uint64_t{above[-1]} << 32 |
                                   std::uint64_t{above[1]} << 48;
        const std::uint64_t far = std::uint64_t{row[-2]} | std::uint64_t{far_above[0]} << 16 | std::uint64_t{above[-2]} << 32 |
                                  std::uint64_t{above[2]} << 48;
        const std::uint64_t farthest =
            std::uint64_t{row[-3]} | std::uint64_t{far_above[-1]} << 16 | std::uint64_t{far_above[1]} << 32;
        return static_cast<std::size_t>((near * kMix[0] + far * kMix[1] + farthest * kMix[2]) >> (64 - kPlaceBits));
    }
    bool level_ground() const noexcept { return row[-1] == above[0] && row[-1] == above[-1] && row[-1] == above[1]; }
    int guess() const noexcept { return guess_of(row[-1], above[0], above[-1]); }

private:
    // Odd numbers whose bits look like chance: the golden ratio's, and two of the hash xxHash64 (Y. Collet).
    static constexpr std::uint64_t kMix[] = {0x9E3779B97F4A7C15u, 0xC2B2AE3D27D4EB4Fu, 0x165667B19E3779F9u};
};

// Both sides alike: `Coder` says whether a decision is told or asked for.
class Memory {
public:
    // Of the level that stands there, or that the coder tells.
    template <typename Coder>
    Level pass(Coder& coder, const Neighbours& around, Level level, int top) {
        Remembered &first = eleven_[around.eleven()], &second = six_[around.six()];
        const bool level_ground = around.level_ground();
        Chance& first_chance = first_[level_ground ? 1 : 0][first.right][before_];
        if (coder.decide(first_chance, level == first.level)) {
            level = first.level;
            before_ = before_ >> 1 | 4u;
        } else if (second.level != first.level && coder.decide(second_[second.right], level == second.level)) {
            level = second.level;
            before_ = before_ >> 1;
        } else {
            level = coder.number(level, around.guess(), top);
            before_ = before_ >> 1;
        }
        remember(first, level);
        remember(second, level);
        return level;
    }

private:
    std::vector<Remembered> eleven_ = std::vector<Remembered>(std::size_t{1} << kPlaceBits),
                            six_ = std::vector<Remembered>(std::size_t{1} << kPlaceBits);
    std::array<std::array<std::array<Chance, 8>, kMostRight + 1>, 2> first_{};
    std::array<Chance, kMostRight + 1> second_{};
    unsigned before_ = 7;  // of the last three levels, which were as remembered
};

class Telling {
public:
    explicit Telling(std::string& bytes) : encoder_(bytes) {}
    bool decide(Chance& chance, bool is) {
        encoder_.put(chance, !is);
        return is;
    }
    Level number(Level level, int guess, int) {
        step_.put(encoder_, folded(level - guess));
        return level;
    }
    void finish() { encoder_.finish(); }

private:
    BinaryEncoder encoder_;
    NumberChances step_;
};

class Asking {
public:
    explicit Asking(std::string_view bytes) : decoder_(bytes) {}
    bool decide(Chance& chance, bool) noexcept { return !decoder_.get(chance); }
    Level number(Level, int guess, int top) noexcept {
        const std::int64_t level = guess + unfolded(step_.get(decoder_));
        wrong_ |= level < 0 || level > top;
        return wrong_ ? Level{0} : static_cast<Level>(level);
    }
    bool wrong() const noexcept { return wrong_ || decoder_.overrun(); }
    bool whole() const noexcept { return !wrong_ && decoder_.whole(); }

private:
    BinaryDecoder decoder_;
    NumberChances step_;
    bool wrong_ = false;
};

// Beyond the edges stand zeros.
class Rows {
public:
    explicit Rows(int columns) {
        for (auto& row : rows_) row.resize(static_cast<std::size_t>(columns) + 5);
    }
    Level* now() { return rows_[0].data() + 3; }
    void next() {
        std::swap(rows_[2], rows_[1]);
        std::swap(rows_[1], rows_[0]);
    }
    Neighbours around(int x) const { return {rows_[0].data() + 3 + x, rows_[1].data() + 3 + x, rows_[2].data() + 3 + x}; }

private:
    std::array<std::vector<Level>, 3> rows_;
};

}  // namespace

std::string drawn_bytes(const TileView<const Level>& tile, int top, std::size_t enough) {
    std::string bytes;
    Telling telling(bytes);
    Memory memory;
    Rows rows(tile.columns);
    for (int y = 0; y < tile.rows && bytes.size() < enough; ++y, rows.next()) {
        const Level* row = tile.row(y);
        Level* copy = rows.now();
        for (int x = 0; x < tile.columns; ++x) copy[x] = memory.pass(telling, rows.around(x), row[x], top);
    }
    telling.finish();
    return bytes;
}

bool read_drawn(std::string_view bytes, const TileView<Level>& tile, int top) {
    Asking asking(bytes);
    Memory memory;
    Rows rows(tile.columns);
    for (int y = 0; y < tile.rows; ++y, rows.next()) {
        Level* row = tile.row(y);
        Level* copy = rows.now();
        for (int x = 0; x < tile.columns; ++x) row[x] = copy[x] = memory.pass(asking, rows.around(x), 0, top);
        if (asking.wrong()) return false;
    }
    return asking.whole();
}

}  // namespace tactics
