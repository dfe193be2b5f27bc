// SPDX-License-Identifier: Apache-2.0
#include "tactics/coding/drawn_tile.h"

#include <algorithm>
#include <array>
#include <vector>

#include "tactics/coding/binary_coder.h"

namespace tactics {

namespace {

constexpr unsigned kPlaceBits = 16;

// What followed some neighbours, and how often in a row.
//
// `Kept` is no wider than the levels are: with bytes, all that is remembered fits the memory near the processor.
template <typename Kept>
struct Remembered {
    Kept level = 0;
    std::uint8_t right = 0;
};
constexpr std::uint8_t kMostRight = 15;

// Remembering it once more changes nothing.
template <typename Kept>
bool is_sure(const Remembered<Kept>& place, Level level) noexcept {
    return place.level == level && place.right == kMostRight;
}

template <typename Kept>
void remember(Remembered<Kept>& place, Level level) noexcept {
    if (place.level == level) {
        if (place.right < kMostRight) ++place.right;
    } else if (place.right > 1) {
        place.right = static_cast<std::uint8_t>(place.right / 4);
    } else {
        place = {static_cast<Kept>(level), 0};
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
    bool all_alike() const noexcept {
        const Level level = row[-1];
        return level_ground() && row[-2] == level && row[-3] == level && above[-2] == level && above[2] == level &&
               far_above[-1] == level && far_above[0] == level && far_above[1] == level;
    }
    // After a level like them, if all before were alike.
    bool are_still(Level level) const noexcept { return still(level, 1) == 1; }
    // How far, after such levels, at most so many.
    int still(Level level, int most) const noexcept {
        int count = 0;
        while (count < most && above[2 + count] == level && far_above[1 + count] == level) ++count;
        return count;
    }
    int guess() const noexcept { return guess_of(row[-1], above[0], above[-1]); }
    void step(int levels) noexcept { row += levels, above += levels, far_above += levels; }

private:
    // Odd numbers whose bits look like chance: the golden ratio's, and two of the hash xxHash64 (Y. Collet).
    static constexpr std::uint64_t kMix[] = {0x9E3779B97F4A7C15u, 0xC2B2AE3D27D4EB4Fu, 0x165667B19E3779F9u};
};

// Both sides alike: `Coder` says whether a decision is told or asked for.
template <typename Kept>
class Memory {
    using Place = Remembered<Kept>;

public:
    // Of a row of levels that stand in `given`, or that the coder tells. What is around the first is `around`; of the row itself
    // it becomes what is passed. Where all around are alike, as on the empty paper of a page, they mean the same places from
    // level to level, which are looked for once.
    template <typename Coder, typename Given>
    void pass_row(Coder& coder, Neighbours around, Level* row, int columns, int top, const Given& given) {
        for (int x = 0; x < columns;) {
            Place &first = eleven_[around.eleven()], &second = six_[around.six()];
            const bool alike = around.all_alike();
            const Level level = row[x] = pass(coder, around, first, second, around.level_ground(), given(x), top);
            ++x, around.step(1);
            if (!alike || level != row[x - 2]) continue;
            while (x < columns && around.are_still(level)) {
                if (is_sure(first, level) && is_sure(second, level) && before_ == kAllRight) {
                    const int same = coder.same(first_[1][kMostRight][kAllRight], level, around.still(level, columns - x),
                                                [&](int i) { return given(x + i); });
                    std::fill_n(row + x, same, level);
                    x += same, around.step(same);
                    if (x == columns || !around.are_still(level)) break;
                }
                row[x] = pass(coder, around, first, second, true, given(x), top);
                ++x, around.step(1);
                if (row[x - 1] != level) break;
            }
        }
    }

private:
    template <typename Coder>
    Level pass(Coder& coder, const Neighbours& around, Place& first, Place& second, bool level_ground, Level level, int top) {
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

    std::vector<Place> eleven_ = std::vector<Place>(std::size_t{1} << kPlaceBits),
                       six_ = std::vector<Place>(std::size_t{1} << kPlaceBits);
    std::array<std::array<std::array<Chance, 8>, kMostRight + 1>, 2> first_{};
    std::array<Chance, kMostRight + 1> second_{};
    static constexpr unsigned kAllRight = 7;
    unsigned before_ = kAllRight;  // of the last three levels, which were as remembered
};

class Telling {
public:
    explicit Telling(std::string& bytes) : encoder_(bytes) {}
    bool decide(Chance& chance, bool is) {
        encoder_.put(chance, !is);
        return is;
    }
    // How many of the next levels are like it, at most so many: these are told.
    template <typename Given>
    int same(Chance& chance, Level level, int most, const Given& given) {
        int count = 0;
        while (count < most && given(count) == level) ++count;
        encoder_.put_zeros(chance, static_cast<std::size_t>(count));
        return count;
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
    template <typename Given>
    int same(Chance& chance, Level, int most, const Given&) noexcept {
        return static_cast<int>(decoder_.get_zeros(chance, static_cast<std::size_t>(most)));
    }
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
    Neighbours around() const { return {rows_[0].data() + 3, rows_[1].data() + 3, rows_[2].data() + 3}; }

private:
    std::array<std::vector<Level>, 3> rows_;
};

constexpr int kMostOfByte = 255;

template <typename Kept>
std::string bytes_of(const TileView<const Level>& tile, int top, std::size_t enough) {
    std::string bytes;
    Telling telling(bytes);
    Memory<Kept> memory;
    Rows rows(tile.columns);
    for (int y = 0; y < tile.rows && bytes.size() < enough; ++y, rows.next()) {
        const Level* row = tile.row(y);
        memory.pass_row(telling, rows.around(), rows.now(), tile.columns, top, [row](int x) { return row[x]; });
    }
    telling.finish();
    return bytes;
}

template <typename Kept>
bool read_rows(std::string_view bytes, const TileView<Level>& tile, int top) {
    Asking asking(bytes);
    Memory<Kept> memory;
    Rows rows(tile.columns);
    for (int y = 0; y < tile.rows; ++y, rows.next()) {
        memory.pass_row(asking, rows.around(), rows.now(), tile.columns, top, [](int) { return Level{0}; });
        std::copy_n(rows.now(), tile.columns, tile.row(y));
        if (asking.wrong()) return false;
    }
    return asking.whole();
}

}  // namespace

std::string drawn_bytes(const TileView<const Level>& tile, int top, std::size_t enough) {
    return top <= kMostOfByte ? bytes_of<std::uint8_t>(tile, top, enough) : bytes_of<Level>(tile, top, enough);
}

bool read_drawn(std::string_view bytes, const TileView<Level>& tile, int top) {
    return top <= kMostOfByte ? read_rows<std::uint8_t>(bytes, tile, top) : read_rows<Level>(bytes, tile, top);
}

}  // namespace tactics
