// SPDX-License-Identifier: Apache-2.0
#include "tactics/coding/slope_tile.h"

#include <array>
#include <bit>
#include <vector>

#include "tactics/coding/binary_coder.h"
#include "tactics/coding/bytes.h"

namespace tactics {

namespace {

constexpr unsigned kPlain = 16;    // residuals below it are symbols
constexpr unsigned kSymbols = 40;  // 16, and two for each length from 5 to 16 bits
constexpr unsigned kKinds = 40;    // of steepness
constexpr unsigned kPartBits = 12, kParts = 1u << kPartBits;
constexpr std::uint32_t kLeastState = 1u << 16;
constexpr unsigned kShare = 512;  // levels that are worth a table

// Bits that follow a symbol, and the residual if they are zeros.
constexpr unsigned count_of(unsigned symbol) { return symbol < kPlain ? 0 : 3 + (symbol - kPlain) / 2; }
constexpr unsigned base_of(unsigned symbol) { return symbol < kPlain ? symbol : (2 + (symbol - kPlain) % 2) << count_of(symbol); }

// Both ways are gone, as which is right is as good as chance in a photograph.
inline unsigned symbol_of(std::uint32_t residual) noexcept {
    const auto length = static_cast<unsigned>(std::bit_width(residual | kPlain)) - 1;  // 4 to 15
    const unsigned symbol = kPlain + 2 * (length - 4) + (residual >> (length - 1) & 1u);
    return residual < kPlain ? residual : symbol;
}

// Of both sides a residual is one of top + 1 steps, whichever way round is shorter.
inline std::uint32_t residual_of(int level, int guess, int top) noexcept {
    int step = level - guess;
    if (step > top / 2) step -= top + 1;
    if (step < -((top + 1) / 2)) step += top + 1;
    return static_cast<std::uint32_t>(folded(step));
}

inline int level_of(std::uint32_t residual, int guess, int top) noexcept {
    int level = guess + static_cast<int>(unfolded(residual));
    if (level < 0) level += top + 1;
    if (level > top) level -= top + 1;
    return level;
}

// Twice the logarithm of how much the levels around differ.
inline unsigned kind_of(unsigned steepness) noexcept {
    const unsigned twice = 2 * steepness + 1;  // so that 1 has a second bit, too
    const auto length = static_cast<unsigned>(std::bit_width(twice)) - 1;
    return length == 0 ? 0 : std::min(2 * length + (twice >> (length - 1) & 1u), kKinds - 1);
}

// What stands around a level; rows above the first are zeros, and so is what is left of it.
struct Around {
    int left, above, corner, next;  // next: above on the right
    int guess() const noexcept { return guess_of(left, above, corner); }
    unsigned steepness(unsigned before) const noexcept {
        const auto between = [](int a, int b) { return static_cast<unsigned>(a > b ? a - b : b - a); };
        return between(left, corner) + between(above, corner) + between(above, next) + before;
    }
};

// Shares of kParts by which the symbols of a kind are coded; those that occur have at least one.
using Shares = std::array<std::uint16_t, kSymbols>;

Shares shares_of(const std::array<std::uint32_t, kSymbols>& counts) {
    Shares shares{};
    std::uint64_t total = 0;
    for (const std::uint32_t count : counts) total += count;
    if (total == 0) return shares;
    unsigned given = 0, largest = 0;
    for (unsigned s = 0; s < kSymbols; ++s) {
        if (counts[s] == 0) continue;
        shares[s] = static_cast<std::uint16_t>(std::max<std::uint64_t>(1, counts[s] * std::uint64_t{kParts} / total));
        given += shares[s];
        if (shares[s] > shares[largest]) largest = s;
    }
    // What rounding left over, or took, is the most frequent symbol's; that is over kSymbols by far.
    shares[largest] = static_cast<std::uint16_t>(shares[largest] + kParts - given);
    return shares;
}

// The tables of a tile: which kinds of steepness share one, and the shares of each.
struct Tables {
    std::array<std::uint8_t, kKinds> table_of{};  // by kind
    std::vector<Shares> shares;
};

void put_tables(const Tables& tables, BinaryEncoder& encoder) {
    Chance new_table;
    for (unsigned kind = 1; kind < kKinds; ++kind) encoder.put(new_table, tables.table_of[kind] != tables.table_of[kind - 1]);
    NumberChances share, behind_zero;
    for (const Shares& shares : tables.shares) {
        unsigned left = kParts;
        bool zero = false;
        for (unsigned s = 0; s < kSymbols && left > 0; ++s) {
            (zero ? behind_zero : share).put(encoder, shares[s]);
            zero = shares[s] == 0;
            left -= shares[s];
        }
    }
}

bool get_tables(Tables& tables, BinaryDecoder& decoder) {
    Chance new_table;
    std::uint8_t last = 0;
    for (unsigned kind = 1; kind < kKinds; ++kind) {
        last = static_cast<std::uint8_t>(last + (decoder.get(new_table) ? 1 : 0));
        tables.table_of[kind] = last;
    }
    tables.shares.assign(std::size_t{last} + 1, {});
    NumberChances share, behind_zero;
    for (Shares& shares : tables.shares) {
        unsigned left = kParts;
        bool zero = false;
        for (unsigned s = 0; s < kSymbols && left > 0; ++s) {
            const std::uint64_t told = (zero ? behind_zero : share).get(decoder);
            if (told > left) return false;
            shares[s] = static_cast<std::uint16_t>(told);
            zero = told == 0;
            left -= static_cast<unsigned>(told);
        }
        if (left > 0) return false;
    }
    return true;
}

// Kinds next to each other share a table until it has enough levels.
Tables tables_of(const std::vector<std::array<std::uint32_t, kSymbols>>& counts) {
    Tables tables;
    std::array<std::uint32_t, kSymbols> sum{};
    std::uint64_t levels = 0;
    for (unsigned kind = 0; kind < kKinds; ++kind) {
        if (levels >= kShare) {
            tables.shares.push_back(shares_of(sum));
            sum = {};
            levels = 0;
        }
        tables.table_of[kind] = static_cast<std::uint8_t>(tables.shares.size());
        for (unsigned s = 0; s < kSymbols; ++s) {
            sum[s] += counts[kind][s];
            levels += counts[kind][s];
        }
    }
    if (levels == 0) {  // the last kinds are not there at all
        const auto last = static_cast<std::uint8_t>(tables.shares.empty() ? 0 : tables.shares.size() - 1);
        for (std::uint8_t& table : tables.table_of) table = std::min(table, last);
        if (tables.shares.empty()) tables.shares.push_back(shares_of({1}));
    } else {
        tables.shares.push_back(shares_of(sum));
    }
    return tables;
}

// A row with two levels before it and one behind, so that none needs to be asked whether it is at the edge.
struct Row {
    explicit Row(int columns) : levels(static_cast<std::size_t>(columns) + 3) {}
    std::vector<Level> levels;
    Level* first() { return levels.data() + 2; }
};

struct Rest {
    std::uint16_t base, count;
};
constexpr std::array<Rest, kSymbols> kRests = [] {
    std::array<Rest, kSymbols> rests{};
    for (unsigned s = 0; s < kSymbols; ++s)
        rests[s] = {static_cast<std::uint16_t>(base_of(s)), static_cast<std::uint16_t>(count_of(s))};
    return rests;
}();

struct Coded {
    std::uint16_t residual;
    std::uint8_t kind, symbol;
};

// What is told of each level, and how often each symbol was told of each kind of steepness.
struct Told {
    std::vector<Coded> levels;
    std::vector<std::array<std::uint32_t, kSymbols>> counts;
};

Told told_of(const TileView<const Level>& tile, int top) {
    Told told{std::vector<Coded>(tile.size()), std::vector<std::array<std::uint32_t, kSymbols>>(kKinds)};
    Row above(tile.columns);
    Coded* next = told.levels.data();
    for (int y = 0; y < tile.rows; ++y) {
        const Level* row = tile.row(y);
        const Level* up = above.first();
        Around around{y == 0 ? 0 : up[0], up[0], up[0], 0};
        unsigned before = 0;
        for (int x = 0; x < tile.columns; ++x) {
            around.next = up[x + 1];
            const std::uint32_t residual = residual_of(row[x], around.guess(), top);
            const unsigned kind = kind_of(around.steepness(before));
            const unsigned symbol = symbol_of(residual);
            *next++ = {static_cast<std::uint16_t>(residual), static_cast<std::uint8_t>(kind), static_cast<std::uint8_t>(symbol)};
            ++told.counts[kind][symbol];
            before = residual;
            around = {row[x], around.next, around.above, 0};
        }
        std::copy_n(row, tile.columns, above.first());
        above.first()[tile.columns] = row[tile.columns - 1];
    }
    return told;
}

// The words of both coders, with their number before them. From the last level to the first, as they are read the other way
// round.
std::string word_bytes(const std::vector<Coded>& levels, const Tables& tables) {
    std::vector<std::array<std::uint16_t, kSymbols>> starts(tables.shares.size());
    for (std::size_t t = 0; t < starts.size(); ++t) {
        unsigned sum = 0;
        for (unsigned s = 0; s < kSymbols; ++s) {
            starts[t][s] = static_cast<std::uint16_t>(sum);
            sum += tables.shares[t][s];
        }
    }
    std::vector<std::uint16_t> words(levels.size() + 4);
    std::uint16_t* word = words.data() + words.size();
    std::array<std::uint32_t, 2> states{kLeastState, kLeastState};
    for (std::size_t i = levels.size(); i-- > 0;) {
        std::uint32_t& state = states[i % 2];
        const std::size_t table = tables.table_of[levels[i].kind];
        const std::uint32_t share = tables.shares[table][levels[i].symbol];
        if (state >> (32 - kPartBits) >= share) {
            *--word = static_cast<std::uint16_t>(state & 0xFFFFu);
            state >>= 16;
        }
        state = (state / share << kPartBits) + state % share + starts[table][levels[i].symbol];
    }
    for (const std::uint32_t state : {states[1], states[0]}) {
        *--word = static_cast<std::uint16_t>(state & 0xFFFFu);
        *--word = static_cast<std::uint16_t>(state >> 16);
    }
    const auto count = static_cast<std::size_t>(words.data() + words.size() - word);
    std::string bytes;
    bytes.reserve(2 * count);
    for (; word != words.data() + words.size(); ++word) {
        bytes += static_cast<char>(static_cast<unsigned char>(*word & 0xFFu));
        bytes += static_cast<char>(static_cast<unsigned char>(*word >> 8));
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
    const Told told = told_of(tile, top);
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

}  // namespace

bool read_slope(std::string_view bytes, const TileView<Level>& tile, int top) {
    Streams in;
    Tables tables;
    if (!open_streams(bytes, tile, in, tables)) return false;
    const std::vector<Slot> slots = slots_of(tables);
    std::array<const Slot*, kKinds> slots_of_kind{};
    for (unsigned kind = 0; kind < kKinds; ++kind)
        slots_of_kind[kind] = slots.data() + std::size_t{tables.table_of[kind]} * kParts;
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
            const Slot slot = slots_of_kind[kind_of(around.steepness(before))][now & (kParts - 1)];
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
            row[x] = static_cast<Level>(level);
            wrong |= level < 0 || level > top;
            around = {row[x], around.next, around.above, 0};
        }
        if (in.overrun() || wrong) return false;
        std::copy_n(row, tile.columns, above.first());
        above.first()[tile.columns] = row[tile.columns - 1];
    }
    return in.whole() && now == kLeastState && then == kLeastState;
}

}  // namespace tactics
