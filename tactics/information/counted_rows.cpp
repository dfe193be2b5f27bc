// SPDX-License-Identifier: Apache-2.0
#include "tactics/information/counted_rows.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "tactics/information/random_below.h"

namespace tactics {

namespace {

constexpr std::size_t kCounted = 1'000'000;
constexpr std::size_t kLeastBands = 32;
constexpr double kUnlike = 0.05;
constexpr std::size_t kWeighed = 1 << 19, kParts = 64, kPart = 4096;

// Of a row of any width, the sum of the differences between its cells and those so many before them.
template <typename Value>
double row_difference(const Value* row, const Value* before, std::size_t columns) {
    constexpr std::size_t kPiece = 65'536;  // so many differences are at most 2^32
    double whole = 0;
    for (std::size_t from = 0; from < columns; from += kPiece) {
        std::uint32_t sum = 0;
        for (std::size_t x = from; x < std::min(columns, from + kPiece); ++x)
            sum += static_cast<std::uint32_t>(std::abs(row[x] - before[x]));
        whole += sum;
    }
    return whole;
}

// Of each row, from the cells to the left and from those above, and how much comes as a surprise; read once for all.
struct Differences {
    std::vector<double> left, above, surprise;
};

// What came last behind the same neighbours to the left and above foretells a cell; the logarithm of its error is blind to the
// size of steps: a great one that comes again and again is no surprise, and a small one by chance is. Some 64 cells of each row
// are enough, from another one on each time: it is about rows, and a cell that is looked up costs as much as many that are
// subtracted. What is remembered is little, so that it stays near; two pairs of neighbours may share a place.
class Surprises {
public:
    explicit Surprises(std::size_t columns) : step_(std::max<std::size_t>(1, columns / kOfRow)) {}

    template <typename Value>
    double of_row(const Value* row, const Value* above, std::size_t columns) {
        std::uint64_t sum = 0;
        for (std::size_t x = 1 + random_below(state_, step_); x < columns; x += step_) {
            const auto value = static_cast<std::uint16_t>(row[x]);
            std::uint16_t& last = last_[(row[x - 1] * 0x9e3779b1u ^ above[x] * 0x85ebca6bu) >> (32 - kPlaceBits)];
            sum += lengths_[static_cast<std::size_t>(std::min(std::abs(value - last), kFar))];
            last = value;
        }
        return static_cast<double>(sum);
    }

private:
    static constexpr int kFar = 255, kPlaceBits = 12;
    static constexpr std::size_t kOfRow = 64;
    static std::vector<std::uint16_t> lengths() {
        std::vector<std::uint16_t> found;
        for (int i = 0; i <= kFar; ++i) found.push_back(static_cast<std::uint16_t>(std::lround(256 * std::log2(1 + i))));
        return found;
    }
    std::vector<std::uint16_t> last_ = std::vector<std::uint16_t>(1 << kPlaceBits);
    std::vector<std::uint16_t> lengths_ = lengths();  // 256ths of a bit
    std::size_t step_;
    std::uint64_t state_ = 0x2545f4914f6cdd1d;
};

template <typename Value>
Differences differences(const Value* values, std::size_t rows, std::size_t columns) {
    Differences found;
    Surprises surprises(columns);
    for (std::size_t y = 0; y < rows; ++y) {
        const Value* row = values + y * columns;
        found.left.push_back(row_difference(row + 1, row, columns - 1));
        found.above.push_back(y > 0 ? row_difference(row, row - columns, columns) : 0);
        found.surprise.push_back(y > 0 ? surprises.of_row(row, row - columns, columns) : 0);
    }
    return found;
}

// By which share of the whole the bands have more or less of these differences than their share of the rows.
double unlikeness(const std::vector<double>& differ, const std::vector<std::size_t>& firsts) {
    double counted = 0, all = 0;
    for (const double one : differ) all += one;
    for (const std::size_t first : firsts)
        for (std::size_t y = CountedRows::kBefore; y < CountedRows::kBand; ++y) counted += differ[first + y];
    const double rows = static_cast<double>(firsts.size() * (CountedRows::kBand - CountedRows::kBefore));
    return all > 0 ? std::abs(counted / rows * static_cast<double>(differ.size()) / all - 1) : 0;
}

// Where bands begin, and how unlike the whole they are.
struct Draw {
    std::vector<std::size_t> firsts;
    double unlike = 0;
};

// Of a few draws the one that is most like the whole. Bands at even distances would miss what repeats at that distance.
Draw likest_draw(const Differences& differ, std::size_t bands, std::uint64_t& state) {
    constexpr int kDraws = 8;
    const std::size_t rows = differ.left.size();
    Draw best;
    for (int i = 0; i < kDraws; ++i) {
        Draw draw;
        for (std::size_t band = 0; band < bands; ++band) {
            const std::size_t from = band * rows / bands, to = (band + 1) * rows / bands;
            draw.firsts.push_back(from + random_below(state, to - from - CountedRows::kBand + 1));
        }
        for (const auto* differences : {&differ.left, &differ.above, &differ.surprise})
            draw.unlike = std::max(draw.unlike, unlikeness(*differences, draw.firsts));
        if (i == 0 || draw.unlike < best.unlike) best = std::move(draw);
    }
    return best;
}

}  // namespace

CountedRows::CountedRows(const LevelGrid& whole)
    : whole_(whole), shift_(shift_of(whole)), looked_at_{{0, whole.count() / static_cast<std::size_t>(whole.columns)}} {
    const auto columns = static_cast<std::size_t>(whole.columns), rows = static_cast<std::size_t>(whole.rows);
    std::size_t bands = std::max(kLeastBands, kCounted / ((kBand - kBefore) * columns));
    if (whole.slices != 1 || rows < 2 * bands * kBand) return;
    const Differences differ = whole.values.visit([&](const auto* values) { return differences(values, rows, columns); });
    std::uint64_t state = 0x9e3779b97f4a7c15;
    for (; rows >= 2 * bands * kBand; bands *= 2) {
        const Draw draw = likest_draw(differ, bands, state);
        if (draw.unlike > kUnlike) continue;
        unlike_ = draw.unlike;
        looked_at_.clear();
        for (const std::size_t first : draw.firsts) looked_at_.emplace_back(first, first + kBand);
        return;
    }
}

std::size_t CountedRows::rows() const { return is_part() ? looked_at_.size() * kBand : looked_at_.front().second; }

std::size_t CountedRows::cells_there() const { return rows() * static_cast<std::size_t>(whole_.columns); }

double CountedRows::cells() const { return share() * static_cast<double>(whole_.count()); }

double CountedRows::share() const {
    return is_part() ? static_cast<double>(looked_at_.size() * (kBand - kBefore)) / whole_.rows : 1;
}

std::vector<RowRange> CountedRows::parts() const {
    if (!is_part()) return parts_of(rows(), static_cast<std::size_t>(whole_.columns));
    std::vector<RowRange> found;
    for (std::size_t y = kBefore; y < rows(); y += kBand) found.emplace_back(y, y + kBand - kBefore);
    return found;
}

std::vector<RowRange> parts_of(std::size_t rows, std::size_t columns) {
    const std::size_t size = std::max<std::size_t>(1, kPart / columns);
    std::vector<RowRange> found;
    if (rows * columns <= kWeighed || rows < kParts * size) return {{0, rows}};
    for (std::size_t i = 0; i < kParts; ++i)
        found.emplace_back(i * (rows - size) / (kParts - 1), i * (rows - size) / (kParts - 1) + size);
    return found;
}

}  // namespace tactics
