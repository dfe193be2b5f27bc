// SPDX-License-Identifier: Apache-2.0
#include "tactics/measure/fingertip.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "tactics/measure/random.h"

namespace tactics {

namespace {

// The ratio of the neighbourhood against which an edge is felt to the width that is felt as one.
constexpr double kSurround = 3;

std::vector<float> blurred(const std::vector<float>& map, int cells, double sigma) {
    const int reach = std::min(cells - 1, static_cast<int>(std::ceil(3 * sigma)));
    std::vector<double> weights;
    double sum = 0;
    for (int i = -reach; i <= reach; ++i) {
        weights.push_back(std::exp(-0.5 * i * i / (sigma * sigma)));
        sum += weights.back();
    }
    std::vector<float> row(static_cast<std::size_t>(cells));
    // Around the sheet there is nothing to feel. Along rows, turned, twice: so both axes are done and all lies as before.
    const auto pass = [&](const std::vector<float>& from) {
        std::vector<float> to(from.size());
        for (int y = 0; y < cells; ++y) {
            std::fill(row.begin(), row.end(), 0.0f);
            for (int i = -reach; i <= reach; ++i) {
                const auto weight = static_cast<float>(weights[static_cast<std::size_t>(i + reach)] / sum);
                const float* values = from.data() + y * cells;
                for (int x = std::max(0, -i); x < std::min(cells, cells - i); ++x)
                    row[static_cast<std::size_t>(x)] += weight * values[x + i];
            }
            for (int x = 0; x < cells; ++x) to[static_cast<std::size_t>(x * cells + y)] = row[static_cast<std::size_t>(x)];
        }
        return to;
    };
    return pass(pass(map));
}

// A finger's sensation of a sheet, at any place.
class Felt {
public:
    Felt(const Relief& sheet, const FingertipReader& reader) : cells_(sheet.cells), mm_per_cell_(sheet.mm_per_cell) {
        constexpr double kSigmaOfWidth = 2.3548;  // a Gaussian's width at half height
        const double sigma = reader.acuity / kSigmaOfWidth / mm_per_cell_;
        std::vector<float> map = blurred(sheet.raised, cells_, sigma);
        if (reader.edges > 0) {
            const std::vector<float> around = blurred(sheet.raised, cells_, kSurround * sigma);
            for (std::size_t i = 0; i < map.size(); ++i)
                map[i] = static_cast<float>((1 - reader.edges) * map[i] + reader.edges * std::abs(map[i] - around[i]));
        }
        sums_.assign(static_cast<std::size_t>(cells_ + 1) * static_cast<std::size_t>(cells_ + 1), 0);
        for (int y = 0; y < cells_; ++y)
            for (int x = 0; x < cells_; ++x)
                sums_[at(x + 1, y + 1)] =
                    map[static_cast<std::size_t>(y * cells_ + x)] + sums_[at(x, y + 1)] + sums_[at(x + 1, y)] - sums_[at(x, y)];
    }

    double side() const { return cells_ * mm_per_cell_; }

    /// The mean in a square of `width` mm around that place; the finger does not leave the sheet.
    double mean(double x, double y, double width) const {
        const int cells = std::clamp(static_cast<int>(width / mm_per_cell_ + 0.5), 1, cells_);
        const auto begin = [&](double middle) {
            return static_cast<int>(std::clamp((middle - width / 2) / mm_per_cell_, 0.0, static_cast<double>(cells_ - cells)) +
                                    0.5);
        };
        const int left = begin(x), top = begin(y);
        return (sums_[at(left + cells, top + cells)] - sums_[at(left, top + cells)] - sums_[at(left + cells, top)] +
                sums_[at(left, top)]) /
               (static_cast<double>(cells) * cells);
    }

private:
    std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(cells_ + 1) + static_cast<std::size_t>(x);
    }

    int cells_;
    double mm_per_cell_;
    std::vector<double> sums_;  // of all above and to the left
};

class Matcher {
public:
    Matcher(const std::vector<Relief>& sheets, const FingertipReader& reader)
        : reader_(reader),
          squares_(static_cast<std::size_t>(reader.grid) * static_cast<std::size_t>(reader.grid)),
          grades_(std::max(2.0, std::round(std::exp2(reader.bits)))) {
        for (const Relief& sheet : sheets) {
            if (sheet.cells != sheets.front().cells || sheet.mm_per_cell != sheets.front().mm_per_cell)
                throw std::logic_error("sheets of different sizes in one set");
            felt_.emplace_back(sheet, reader);
        }
        // A judgement of how much uses the range that is met (L. D. Braida, N. I. Durlach 1972), here that of the collection.
        least_ = most_ = mean_at(felt_.front(), 0, 0, 0);
        for (const Felt& felt : felt_)
            for (std::size_t square = 0; square < squares_; ++square) {
                const double value = mean_at(felt, square, 0, 0);
                least_ = std::min(least_, value);
                most_ = std::max(most_, value);
            }
    }

    std::uint16_t look_for(std::size_t sheet, RandomNumbers random) const {
        const bool returns = random.uniform() < reader_.returning;
        const Memory memory = explore(felt_[sheet], random);
        int least = 0;
        std::size_t ties = 0;
        std::uint16_t taken = 0;
        for (std::size_t i = 0; i < felt_.size(); ++i) {
            const int difference = returns ? revisit(felt_[i], memory, random) : compare(memory, explore(felt_[i], random));
            if (ties > 0 && difference > least) continue;
            ties = ties > 0 && difference == least ? ties + 1 : 1;
            // Of those that are alike each is taken as often.
            if (random.below(ties) == 0) taken = static_cast<std::uint16_t>(i);
            least = difference;
        }
        return taken;
    }

private:
    // x and y: how far off the finger is, in standard deviations.
    double mean_at(const Felt& felt, std::size_t square, double x, double y) const {
        const auto grid = static_cast<std::size_t>(reader_.grid);
        const double width = felt.side() / reader_.grid;
        const auto place = [&](std::size_t at, double off) {
            const double middle = (static_cast<double>(at) + 0.5) * width;
            return middle + off * reader_.position_noise * std::min(middle, felt.side() - middle);
        };
        return felt.mean(place(square % grid, x), place(square / grid, y), width);
    }

    // Sums of floats differ in their last digits; what is the same must be.
    bool nothing_differs() const { return most_ - least_ < 1e-6; }

    int feel(const Felt& felt, std::size_t square, RandomNumbers& random) const {
        const auto [x, y] = random.normals();
        if (nothing_differs()) return 0;
        const double share = (mean_at(felt, square, x, y) - least_) / (most_ - least_);
        return static_cast<int>(std::clamp(grades_ * share + 1e-9, 0.0, grades_ - 1));
    }

    // The memory of a sheet: grades of the squares that were felt.
    struct Memory {
        std::vector<std::size_t> path;
        std::vector<int> grades;  // by square
    };

    // The finger sweeps the sheet until it feels something, follows it, and sweeps again when the surroundings are known; empty
    // places are not remembered.
    Memory explore(const Felt& felt, RandomNumbers& random) const {
        std::vector<int> left(squares_);  // to be felt; 0 where it has been or where there is nothing
        for (std::size_t square = 0; square < squares_; ++square) left[square] = feel(felt, square, random);
        Memory memory{{}, std::vector<int>(squares_, 0)};
        std::vector<std::size_t> open;
        while (memory.path.size() < static_cast<std::size_t>(std::max(1, reader_.places))) {
            open.clear();
            if (!memory.path.empty() && random.uniform() < reader_.following) add_most_beside(memory.path.back(), left, open);
            if (open.empty()) add_all(left, open);
            if (open.empty()) break;
            const std::size_t square = open[random.below(open.size())];
            memory.path.push_back(square);
            memory.grades[square] = std::exchange(left[square], 0);
        }
        return memory;
    }

    int compare(const Memory& one, const Memory& other) const {
        int difference = 0;
        for (std::size_t square = 0; square < squares_; ++square)
            difference += std::abs(one.grades[square] - other.grades[square]);
        return difference;
    }

    int revisit(const Felt& felt, const Memory& memory, RandomNumbers& random) const {
        int difference = 0;
        for (const std::size_t square : memory.path) difference += std::abs(feel(felt, square, random) - memory.grades[square]);
        return difference;
    }

    static void add_all(const std::vector<int>& left, std::vector<std::size_t>& open) {
        for (std::size_t square = 0; square < left.size(); ++square)
            if (left[square] > 0) open.push_back(square);
    }

    // The squares around in which there is most.
    void add_most_beside(std::size_t square, const std::vector<int>& left, std::vector<std::size_t>& open) const {
        const int column = static_cast<int>(square) % reader_.grid, row = static_cast<int>(square) / reader_.grid;
        int most = 1;
        for (int y = std::max(0, row - 1); y <= std::min(reader_.grid - 1, row + 1); ++y)
            for (int x = std::max(0, column - 1); x <= std::min(reader_.grid - 1, column + 1); ++x) {
                const auto there = static_cast<std::size_t>(y * reader_.grid + x);
                if (left[there] < most) continue;
                if (left[there] > most) open.clear();
                most = left[there];
                open.push_back(there);
            }
    }

    FingertipReader reader_;
    std::size_t squares_;
    double grades_;
    double least_ = 0, most_ = 0;  // felt in any square of any sheet
    std::vector<Felt> felt_;
};

}  // namespace

std::array<ReaderRange, 7> reader_ranges() {
    using R = FingertipReader;
    return {{
        {SourceWords("acuity"), SourceWords("mm"), 1, 2.5, [](const R& r) { return r.acuity; },
         [](R& r, double v) { r.acuity = v; }},
        {SourceWords("edges"), SourceWords(""), 0, 1, [](const R& r) { return r.edges; }, [](R& r, double v) { r.edges = v; }},
        {SourceWords("position noise"), SourceWords(""), 0, 0.4, [](const R& r) { return r.position_noise; },
         [](R& r, double v) { r.position_noise = v; }},
        {SourceWords("places"), SourceWords("of 64"), 4, 64, [](const R& r) { return static_cast<double>(r.places); },
         [](R& r, double v) { r.places = static_cast<int>(v + 0.5); }},
        {SourceWords("bits"), SourceWords(""), 1, 4, [](const R& r) { return r.bits; }, [](R& r, double v) { r.bits = v; }},
        {SourceWords("following"), SourceWords(""), 0, 1, [](const R& r) { return r.following; },
         [](R& r, double v) { r.following = v; }},
        {SourceWords("returning"), SourceWords(""), 0, 1, [](const R& r) { return r.returning; },
         [](R& r, double v) { r.returning = v; }},
    }};
}

FingertipReader random_reader(std::uint64_t seed) {
    RandomNumbers random(seed);
    FingertipReader reader;
    for (const ReaderRange& range : reader_ranges())
        range.set(reader, range.least + random.uniform() * (range.most - range.least));
    return reader;
}

Answers match_sheets(const std::vector<Relief>& sheets, const FingertipReader& reader, int readers, std::uint64_t seed) {
    Answers answers;
    answers.sheets = sheets.size();
    if (sheets.empty()) return answers;
    const Matcher matcher(sheets, reader);
    std::uint64_t trial = 0;
    for (int i = 0; i < readers; ++i)
        for (std::size_t sheet = 0; sheet < sheets.size(); ++sheet)
            answers.taken.push_back(matcher.look_for(sheet, RandomNumbers(seed_of(seed, trial++))));
    return answers;
}

Interval wilson(std::size_t hits, std::size_t trials) {
    if (trials == 0) return {0, 1};
    constexpr double z = 1.959964;  // 95 % of a normal distribution lie within
    const auto n = static_cast<double>(trials);
    const double share = static_cast<double>(hits) / n;
    const double middle = share + z * z / (2 * n);
    const double half = z * std::sqrt(share * (1 - share) / n + z * z / (4 * n * n));
    return {std::max(0.0, (middle - half) / (1 + z * z / n)), std::min(1.0, (middle + half) / (1 + z * z / n))};
}

}  // namespace tactics
