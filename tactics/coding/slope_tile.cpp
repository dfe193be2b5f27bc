// SPDX-License-Identifier: Apache-2.0
#include "tactics/coding/slope_tile.h"

#include <algorithm>
#include <array>
#include <type_traits>
#include <vector>

#include "tactics/coding/binary_coder.h"
#include "tactics/coding/bytes.h"
#include "tactics/coding/slope_tables.h"

namespace tactics {

namespace {

using namespace slope;

constexpr std::uint32_t kLeastState = 1u << 16;

// A row with two levels before it and one behind, so that none needs to be asked whether it is at the edge.
struct Row {
    explicit Row(int columns) : levels(static_cast<std::size_t>(columns) + 3) {}
    std::vector<Level> levels;
    Level* first() { return levels.data() + 2; }
};

// A level as it is told.
struct Coded {
    std::uint16_t residual;
    std::uint8_t kind, symbol;
};

// What is told of each level, and how often each symbol was told of each kind of steepness.
struct Told {
    std::vector<Coded> levels;
    std::vector<std::array<std::uint32_t, kSymbols>> counts;
};

// Of a row the residuals, of which each is one of top + 1 steps, whichever way round is shorter, and how much the levels around
// differ, without the residual before. `row` and `up` have a level before the first and one behind the last. Without branches, in
// no more bits than the levels need, so that a compiler works on several at a time.
template <typename Signed>
void look_at_row(const Level* row, const Level* up, int columns, Signed top, std::uint16_t* __restrict residuals,
                 std::make_unsigned_t<Signed>* __restrict differences) {
    const auto between = [](Signed a, Signed b) { return static_cast<Signed>(a > b ? a - b : b - a); };
    const auto half = static_cast<Signed>(top / 2), other_half = static_cast<Signed>((top + 1) / 2);
    const auto steps = static_cast<Signed>(top + 1);
    for (int x = 0; x < columns; ++x) {
        const auto left = static_cast<Signed>(row[x - 1]), above = static_cast<Signed>(up[x]),
                   corner = static_cast<Signed>(up[x - 1]), next = static_cast<Signed>(up[x + 1]);
        const Signed low = left < above ? left : above, high = left < above ? above : left;
        const auto plane = static_cast<Signed>(left + above - corner);
        const Signed bounded = plane < low ? low : plane > high ? high : plane;
        const auto missed = static_cast<Signed>(static_cast<Signed>(row[x]) - bounded);
        const auto step = static_cast<Signed>(missed > half ? missed - steps : missed < -other_half ? missed + steps : missed);
        residuals[x] = static_cast<std::uint16_t>(step < 0 ? -2 * step - 1 : 2 * step);
        differences[x] =
            static_cast<std::make_unsigned_t<Signed>>(between(left, corner) + between(above, corner) + between(above, next));
    }
}

// Of levels up to 255 what kind and which symbol, looked up.
struct SmallKinds {
    std::array<std::uint8_t, 1024> kind{};  // by steepness, which is four times 255 at most
    std::array<std::uint8_t, 256> symbol{};
};
constexpr SmallKinds kSmall = [] {
    SmallKinds small;
    for (unsigned i = 0; i < small.kind.size(); ++i) small.kind[i] = static_cast<std::uint8_t>(kind_of(i));
    for (unsigned i = 0; i < small.symbol.size(); ++i) small.symbol[i] = static_cast<std::uint8_t>(symbol_of(i));
    return small;
}();

template <typename Signed>
Told told_of(const TileView<const Level>& tile, int top) {
    constexpr bool kIsSmall = sizeof(Signed) == 2;
    const auto columns = static_cast<std::size_t>(tile.columns);
    Told told{std::vector<Coded>(tile.size()), std::vector<std::array<std::uint32_t, kSymbols>>(kKinds)};
    // Counted twice, taking turns, so that the same count is not waited for.
    constexpr std::size_t kRoom = 64;
    std::vector<std::uint32_t> counts(2 * kKinds * kRoom);
    std::uint32_t *const even = counts.data(), *const odd = counts.data() + kKinds * kRoom;
    Row now(tile.columns), above(tile.columns);
    std::vector<std::uint16_t> residuals(columns);
    std::vector<std::make_unsigned_t<Signed>> differences(columns);
    Coded* next = told.levels.data();
    for (int y = 0; y < tile.rows; ++y) {
        Level* row = now.first();
        std::copy_n(tile.row(y), columns, row);
        row[-1] = above.first()[-1] = above.first()[0];
        look_at_row<Signed>(row, above.first(), tile.columns, static_cast<Signed>(top), residuals.data(), differences.data());
        unsigned before = 0;
        for (std::size_t x = 0; x < columns; ++x) {
            const unsigned residual = residuals[x], steepness = differences[x] + before;
            const unsigned kind = kIsSmall ? kSmall.kind[steepness] : kind_of(steepness);
            const unsigned symbol = kIsSmall ? kSmall.symbol[residual] : symbol_of(residual);
            *next++ = {static_cast<std::uint16_t>(residual), static_cast<std::uint8_t>(kind), static_cast<std::uint8_t>(symbol)};
            ++(x % 2 == 0 ? even : odd)[kind * kRoom + symbol];
            before = residual;
        }
        row[columns] = row[columns - 1];
        std::swap(now, above);
    }
    for (std::size_t kind = 0; kind < kKinds; ++kind)
        for (std::size_t s = 0; s < kSymbols; ++s) told.counts[kind][s] = even[kind * kRoom + s] + odd[kind * kRoom + s];
    return told;
}

// How a symbol goes into a state: it divides by a share, which is a multiplication, as states are below the share << 20. With
// `times` = 2^44 / share + 1, rounded down, what state * times is too large by is below state * share <= 2^44, so the quotient is
// exact; and the product stays below 2^64.
struct Step {
    std::uint64_t times = 0;
    std::uint16_t share = 0, start = 0;

    bool is_large(std::uint32_t state) const noexcept { return state >> (32 - kPartBits) >= share; }
    std::uint32_t after(std::uint32_t state) const noexcept {
        const auto quotient = static_cast<std::uint32_t>(state * times >> kShift);
        return state + start + quotient * (kParts - share);  // quotient * kParts + state % share + start
    }
    static constexpr unsigned kShift = 44;
};

std::vector<std::array<Step, kSymbols>> steps_of(const Tables& tables) {
    std::vector<std::array<Step, kSymbols>> steps(tables.shares.size());
    for (std::size_t t = 0; t < steps.size(); ++t) {
        unsigned sum = 0;
        for (unsigned s = 0; s < kSymbols; ++s) {
            const std::uint16_t share = tables.shares[t][s];
            if (share == 0) continue;
            steps[t][s] = {(std::uint64_t{1} << Step::kShift) / share + 1, share, static_cast<std::uint16_t>(sum)};
            sum += share;
        }
    }
    return steps;
}

// The words of both coders, with their number before them. From the last level to the first, as they are read the other way
// round.
std::string word_bytes(const std::vector<Coded>& levels, const Tables& tables) {
    const std::vector<std::array<Step, kSymbols>> steps = steps_of(tables);
    std::array<const Step*, kKinds> steps_of_kind{};
    for (unsigned kind = 0; kind < kKinds; ++kind) steps_of_kind[kind] = steps[tables.table_of[kind]].data();
    std::vector<std::uint16_t> words(levels.size() + 4);
    std::uint16_t* word = words.data() + words.size();
    const auto pass = [&](std::uint32_t state, const Coded& level) {
        const Step& step = steps_of_kind[level.kind][level.symbol];
        const bool large = step.is_large(state);
        word[-1] = static_cast<std::uint16_t>(state & 0xFFFFu);
        word -= large ? 1 : 0;
        return step.after(large ? state >> 16 : state);
    };
    std::size_t i = levels.size();
    std::array<std::uint32_t, 2> states{kLeastState, kLeastState};
    if (i % 2 != 0) {
        --i;
        states[0] = pass(states[0], levels[i]);
    }
    while (i > 0) {
        states[1] = pass(states[1], levels[--i]);
        states[0] = pass(states[0], levels[--i]);
    }
    for (const std::uint32_t state : {states[1], states[0]}) {
        *--word = static_cast<std::uint16_t>(state & 0xFFFFu);
        *--word = static_cast<std::uint16_t>(state >> 16);
    }
    const auto count = static_cast<std::size_t>(words.data() + words.size() - word);
    std::string bytes(2 * count, '\0');
    for (std::size_t k = 0; k < count; ++k) {
        bytes[2 * k] = static_cast<char>(static_cast<unsigned char>(word[k] & 0xFFu));
        bytes[2 * k + 1] = static_cast<char>(static_cast<unsigned char>(word[k] >> 8));
    }
    return bytes;
}

// The bits that follow symbols, the first in the lowest.
void add_bits(std::string& bytes, const std::vector<Coded>& levels) {
    std::uint64_t held = 0;
    unsigned holds = 0;
    for (const Coded& one : levels) {
        const unsigned count = kRests[one.symbol].count;
        held |= std::uint64_t{one.residual & ((1u << count) - 1)} << holds;
        holds += count;
        if (holds < 32) continue;
        append_number(bytes, held, 4);
        held >>= 32;
        holds -= 32;
    }
    append_number(bytes, held, (holds + 7) / 8);
}

}  // namespace

std::string slope_bytes(const TileView<const Level>& tile, int top) {
    const Told told = top <= 255 ? told_of<std::int16_t>(tile, top) : told_of<std::int32_t>(tile, top);
    const Tables tables = tables_of(told.counts);
    std::string head;
    BinaryEncoder encoder(head);
    put_tables(tables, encoder);
    encoder.finish();
    const std::string words = word_bytes(told.levels, tables);
    std::string bytes;
    bytes.reserve(head.size() + words.size() + 2 * tile.size());
    append_number(bytes, head.size(), 4);
    append_number(bytes, words.size() / 2, 4);
    bytes += head;
    bytes += words;
    add_bits(bytes, told.levels);
    return bytes;
}

namespace {

// What stands around a level; rows above the first are zeros, and so is what is left of it.
struct Around {
    int left, above, corner, next;  // next: above on the right
    int guess() const noexcept { return guess_of(left, above, corner); }
    unsigned steepness(unsigned before) const noexcept {
        const auto between = [](int a, int b) { return static_cast<unsigned>(a > b ? a - b : b - a); };
        return between(left, corner) + between(above, corner) + between(above, next) + before;
    }
};

inline int level_of(std::uint32_t residual, int guess, int top) noexcept {
    int level = guess + static_cast<int>(unfolded(residual));
    if (level < 0) level += top + 1;
    if (level > top) level -= top + 1;
    return level;
}

// What a slot of a state stands for, in 32 bits: so the tables of a tile stay near the processor.
class Slot {
public:
    Slot(unsigned share, unsigned offset, unsigned symbol) : all_((share - 1) << 18 | offset << 6 | symbol) {}
    std::uint32_t share() const noexcept { return (all_ >> 18) + 1; }
    std::uint32_t offset() const noexcept { return all_ >> 6 & (kParts - 1); }  ///< of the slot within its symbol
    unsigned symbol() const noexcept { return all_ & 63u; }

private:
    std::uint32_t all_;
};

std::vector<Slot> slots_of(const Tables& tables) {
    std::vector<Slot> slots;
    slots.reserve(tables.shares.size() * kParts);
    for (const Shares& shares : tables.shares)
        for (unsigned s = 0; s < kSymbols; ++s)
            for (unsigned i = 0; i < shares[s]; ++i) slots.emplace_back(shares[s], i, s);
    return slots;
}

// The words and the bits of a tile, with room for a row behind them: whether they were there is asked once a row.
struct Streams {
    std::vector<std::uint16_t> words;
    std::vector<unsigned char> bits;
    std::size_t word_count = 0, bit_count = 0, word = 0, bit = 0;
    bool overrun() const noexcept { return word > word_count || bit > bit_count; }
    bool whole() const noexcept { return word == word_count && (bit + 7) / 8 == bit_count / 8; }
    std::uint32_t take(unsigned count) noexcept {
        const unsigned char* at = bits.data() + bit / 8;  // told as a number of four bytes, which compilers take at once
        const std::uint32_t four =
            std::uint32_t{at[0]} | std::uint32_t{at[1]} << 8 | std::uint32_t{at[2]} << 16 | std::uint32_t{at[3]} << 24;
        const std::uint32_t taken = (four >> (bit % 8)) & ((1u << count) - 1);
        bit += count;
        return taken;
    }
};

// False: the bytes do not hold together.
bool open_streams(std::string_view bytes, const TileView<Level>& tile, Streams& in, Tables& tables) {
    ByteReader reader(bytes);
    const std::size_t head_size = reader.number(4);
    in.word_count = reader.number(4);
    const std::string_view head = reader.take(head_size);
    const std::string_view words = reader.take(in.word_count <= tile.size() + 4 ? 2 * in.word_count : 0);
    const std::string_view bits = reader.take(reader.left());
    if (!reader.whole() || 2 * in.word_count != words.size() || in.word_count < 4 || bits.size() > 2 * tile.size()) return false;
    BinaryDecoder decoder(head);
    if (!get_tables(tables, decoder) || !decoder.whole()) return false;
    const auto width = static_cast<std::size_t>(tile.columns);
    in.bit_count = 8 * bits.size();
    in.words.resize(in.word_count + width);
    for (std::size_t i = 0; i < in.word_count; ++i)
        in.words[i] = static_cast<std::uint16_t>(static_cast<unsigned char>(words[2 * i]) |
                                                 static_cast<unsigned char>(words[2 * i + 1]) << 8);
    in.bits.assign(bits.begin(), bits.end());
    in.bits.resize(bits.size() + 2 * width + 8);
    return true;
}

// Residuals of levels up to 255 are no more themselves: tables that tell of others are none.
constexpr unsigned kSmallSymbols = 24;
static_assert(base_of(kSmallSymbols) == 256);

bool tell_small(const Tables& tables) {
    return std::all_of(tables.shares.begin(), tables.shares.end(), [](const Shares& shares) {
        return std::all_of(shares.begin() + kSmallSymbols, shares.end(), [](std::uint16_t share) { return share == 0; });
    });
}

// Where the slots of a kind are, by steepness: looked up for levels up to 255, of which 1020 is the most.
template <bool kIsSmall>
class SlotsOf {
public:
    SlotsOf(const Tables& tables, const std::vector<Slot>& slots) : tables_(tables), slots_(slots.data()) {
        if constexpr (kIsSmall)
            for (unsigned i = 0; i < first_.size(); ++i) first_[i] = slots_ + std::size_t{tables.table_of[kind_of(i)]} * kParts;
    }
    const Slot* operator()(unsigned steepness) const noexcept {
        if constexpr (kIsSmall) return first_[steepness];
        return slots_ + std::size_t{tables_.table_of[kind_of(steepness)]} * kParts;
    }

private:
    const Tables& tables_;
    const Slot* slots_;
    std::array<const Slot*, kIsSmall ? 1024 : 1> first_{};
};

template <bool kIsSmall>
bool read_levels(Streams& in, const Tables& tables, const TileView<Level>& tile, int top) {
    const std::vector<Slot> slots = slots_of(tables);
    const SlotsOf<kIsSmall> slots_for(tables, slots);
    std::array<std::uint32_t, 2> states{};
    for (std::uint32_t& state : states) {
        state = std::uint32_t{in.words[in.word]} << 16 | in.words[in.word + 1];
        in.word += 2;
    }
    std::uint32_t now = states[0], then = states[1];
    Row above(tile.columns);
    for (int y = 0; y < tile.rows; ++y) {
        Level* row = tile.row(y);
        const Level* up = above.first();
        Around around{y == 0 ? 0 : up[0], up[0], up[0], 0};
        unsigned before = 0;
        bool wrong = false;
        for (int x = 0; x < tile.columns; ++x) {
            around.next = up[x + 1];
            const Slot slot = slots_for(around.steepness(before))[now & (kParts - 1)];
            std::uint32_t state = slot.share() * (now >> kPartBits) + slot.offset();
            const bool more = state < kLeastState;
            state = more ? state << 16 | in.words[in.word] : state;
            in.word += more ? 1 : 0;
            now = then;
            then = state;
            const Rest rest = kRests[slot.symbol()];
            const std::uint32_t residual = rest.base + in.take(rest.count);
            before = residual;
            const int level = level_of(residual, around.guess(), top);
            row[x] = static_cast<Level>(kIsSmall ? level & 0xFF : level);  // else a wrong one would be looked up
            wrong |= level < 0 || level > top;
            around = {row[x], around.next, around.above, 0};
        }
        if (in.overrun() || wrong) return false;
        std::copy_n(row, tile.columns, above.first());
        above.first()[tile.columns] = row[tile.columns - 1];
    }
    return in.whole() && now == kLeastState && then == kLeastState;
}

}  // namespace

bool read_slope(std::string_view bytes, const TileView<Level>& tile, int top) {
    Streams in;
    Tables tables;
    if (!open_streams(bytes, tile, in, tables)) return false;
    if (top <= 255 && !tell_small(tables)) return false;
    return top <= 255 ? read_levels<true>(in, tables, tile, top) : read_levels<false>(in, tables, tile, top);
}

}  // namespace tactics
