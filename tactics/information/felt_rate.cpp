// SPDX-License-Identifier: Apache-2.0
#include "tactics/information/felt_rate.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

#include "tactics/information/code_length.h"

namespace tactics {

namespace {

constexpr std::size_t kTile = 128, kMostTiles = 16, kMostTileCells = 130'000;

// Complex numbers in rows, their parts apart so that a row is worked on several at a time. What is lost by single precision is
// under a millionth of the largest, in amplitude, and so nothing beside levels.
struct Tile {
    std::size_t columns = 0, rows = 0;
    std::vector<float> real, imaginary;

    Tile(std::size_t width, std::size_t height) : columns(width), rows(height), real(width * height), imaginary(width * height) {}
};

// In squares that stay near: one of the two is read or written across the rows.
void transpose(const std::vector<float>& from, std::size_t columns, std::size_t rows, std::vector<float>& to) {
    constexpr std::size_t kSquare = 16;
    for (std::size_t top = 0; top < rows; top += kSquare)
        for (std::size_t left = 0; left < columns; left += kSquare)
            for (std::size_t x = left; x < std::min(columns, left + kSquare); ++x)
                for (std::size_t y = top; y < std::min(rows, top + kSquare); ++y) to[x * rows + y] = from[y * columns + x];
}

Tile transposed(const Tile& tile) {
    Tile out(tile.rows, tile.columns);
    transpose(tile.real, tile.columns, tile.rows, out.real);
    transpose(tile.imaginary, tile.columns, tile.rows, out.imaginary);
    return out;
}

// Row b less, and row a more, by row b turned.
void butterfly(float* __restrict real_a, float* __restrict imaginary_a, float* __restrict real_b, float* __restrict imaginary_b,
               std::size_t columns, float cosine, float sine) {
    for (std::size_t x = 0; x < columns; ++x) {
        const float real = cosine * real_b[x] - sine * imaginary_b[x], imaginary = cosine * imaginary_b[x] + sine * real_b[x];
        real_b[x] = real_a[x] - real;
        imaginary_b[x] = imaginary_a[x] - imaginary;
        real_a[x] += real;
        imaginary_a[x] += imaginary;
    }
}

// The Fourier transform of all columns at once, of 2^n rows: J. W. Cooley, J. W. Tukey (1965).
void transform_down(Tile& tile) {
    const std::size_t columns = tile.columns, rows = tile.rows;
    const auto row = [columns](std::vector<float>& part, std::size_t y) {
        return part.begin() + static_cast<std::ptrdiff_t>(y * columns);
    };
    for (std::size_t y = 0, mirrored = 0; y < rows; ++y) {
        if (y < mirrored) {
            std::swap_ranges(row(tile.real, y), row(tile.real, y + 1), row(tile.real, mirrored));
            std::swap_ranges(row(tile.imaginary, y), row(tile.imaginary, y + 1), row(tile.imaginary, mirrored));
        }
        std::size_t bit = rows / 2;
        for (; bit > 0 && (mirrored & bit) != 0; bit /= 2) mirrored ^= bit;
        mirrored |= bit;
    }
    for (std::size_t half = 1; half < rows; half *= 2)
        for (std::size_t i = 0; i < half; ++i) {
            const double turn = -std::numbers::pi * static_cast<double>(i) / static_cast<double>(half);
            const auto cosine = static_cast<float>(std::cos(turn)), sine = static_cast<float>(std::sin(turn));
            for (std::size_t from = i; from < rows; from += 2 * half) {
                const std::size_t a = from * columns, b = (from + half) * columns;
                butterfly(&tile.real[a], &tile.imaginary[a], &tile.real[b], &tile.imaginary[b], columns, cosine, sine);
            }
        }
}

// Of so many values, so that its mean square is 1.
std::vector<float> hann_window(std::size_t size) {
    std::vector<float> window(size, 1.0f);
    if (size < 4) return window;
    const auto raised = [size](std::size_t i) {
        return 1 - std::cos(2 * std::numbers::pi * (static_cast<double>(i) + 0.5) / static_cast<double>(size));
    };
    double squares = 0;
    for (std::size_t i = 0; i < size; ++i) squares += raised(i) * raised(i);
    for (std::size_t i = 0; i < size; ++i)
        window[i] = static_cast<float>(raised(i) / std::sqrt(squares / static_cast<double>(size)));
    return window;
}

// Parts of a grid without their planes, under a Hann window, and the mean of their spectra.
class Spectrum {
public:
    Spectrum(std::size_t columns, std::size_t rows)
        : columns_(columns), rows_(rows), window_x_(hann_window(columns)), window_y_(hann_window(rows)), power_(columns * rows) {}

    // Two tiles are transformed at once, as the real and the imaginary part of one; their spectra add up in its power at a
    // frequency and the opposite one, and no more than the sum is wanted.
    void add(const LevelGrid& grid, std::size_t left, std::size_t top) {
        std::vector<float> tile = cut(grid, left, top);
        ++tiles_;
        if (waiting_.empty()) {
            waiting_ = std::move(tile);
            return;
        }
        transform(std::move(waiting_), std::move(tile));
        waiting_.clear();
    }

    // Of each frequency, square levels; their mean is the variance.
    std::vector<double> power() {
        if (!waiting_.empty()) transform(std::move(waiting_), std::vector<float>(power_.size()));
        waiting_.clear();
        std::vector<double> mean(power_.size());
        const double share = 1 / (2 * static_cast<double>(tiles_) * static_cast<double>(power_.size()));
        for (std::size_t x = 0; x < columns_; ++x) {
            const std::size_t other = (columns_ - x) % columns_;
            for (std::size_t y = 0; y < rows_; ++y)
                mean[x * rows_ + y] = (power_[x * rows_ + y] + power_[other * rows_ + (rows_ - y) % rows_]) * share;
        }
        return mean;
    }

    // The mean logarithm of the power of so many tiles is less than that of what it is made of: ln n - psi(n), as that power is
    // distributed as a sum of n exponentials (M. S. Bartlett, D. G. Kendall 1946). Bits a frequency, of half the logarithm.
    double missing_bits() const {
        double psi = -std::numbers::egamma;
        for (std::size_t i = 1; i < tiles_; ++i) psi += 1 / static_cast<double>(i);
        return (std::log(static_cast<double>(tiles_)) - psi) / (2 * std::numbers::ln2);
    }

private:
    // Without the plane of least squares; x and y from their middle are independent.
    std::vector<float> cut(const LevelGrid& grid, std::size_t left, std::size_t top) const {
        std::vector<float> tile(columns_ * rows_);
        const double middle_x = (static_cast<double>(columns_) - 1) / 2, middle_y = (static_cast<double>(rows_) - 1) / 2;
        double sum = 0, by_x = 0, by_y = 0;
        std::vector<std::uint32_t> of_columns(columns_);  // of 128 cells at most, 16 bits each
        grid.values.visit([&](const auto* values) {
            for (std::size_t y = 0; y < rows_; ++y) {
                const auto* from = values + (top + y) * static_cast<std::size_t>(grid.columns) + left;
                std::uint32_t of_row = 0;
                for (std::size_t x = 0; x < columns_; ++x) {
                    of_row += from[x];
                    of_columns[x] += from[x];
                    tile[y * columns_ + x] = static_cast<float>(from[x]);
                }
                sum += static_cast<double>(of_row);
                by_y += static_cast<double>(of_row) * (static_cast<double>(y) - middle_y);
            }
        });
        for (std::size_t x = 0; x < columns_; ++x)
            by_x += static_cast<double>(of_columns[x]) * (static_cast<double>(x) - middle_x);
        // The mean square distance from the middle of n places is (n^2 - 1) / 12.
        const auto cells = static_cast<double>(tile.size());
        const auto slope = [cells](double by, std::size_t n) {
            return n > 1 ? 12 * by / (cells * (static_cast<double>(n) * static_cast<double>(n) - 1)) : 0;
        };
        const double slope_x = slope(by_x, columns_), slope_y = slope(by_y, rows_);
        std::vector<float> slope_there(columns_);
        for (std::size_t x = 0; x < columns_; ++x)
            slope_there[x] = static_cast<float>(slope_x * (static_cast<double>(x) - middle_x));
        for (std::size_t y = 0; y < rows_; ++y) {
            const auto mean = static_cast<float>(sum / cells + slope_y * (static_cast<double>(y) - middle_y));
            const float weight = window_y_[y];
            for (std::size_t x = 0; x < columns_; ++x) {
                float& value = tile[y * columns_ + x];
                value = (value - mean - slope_there[x]) * (window_x_[x] * weight);
            }
        }
        return tile;
    }

    void transform(std::vector<float> first, std::vector<float> second) {
        Tile tile(columns_, rows_);
        tile.real = std::move(first);
        tile.imaginary = std::move(second);
        transform_down(tile);
        tile = transposed(tile);
        transform_down(tile);
        for (std::size_t i = 0; i < power_.size(); ++i) {
            const auto real = static_cast<double>(tile.real[i]), imaginary = static_cast<double>(tile.imaginary[i]);
            power_[i] += real * real + imaginary * imaginary;
        }
    }

    std::size_t columns_, rows_, tiles_ = 0;
    std::vector<float> window_x_, window_y_, waiting_;
    std::vector<double> power_;  // column by column
};

// Tiles evenly over the grid, as many as fit and no more than kMostTiles.
Spectrum spectrum_of(const LevelGrid& grid) {
    const auto columns = static_cast<std::size_t>(grid.columns), rows = static_cast<std::size_t>(grid.rows),
               slices = static_cast<std::size_t>(grid.slices);
    const std::size_t width = std::min(kTile, std::bit_floor(columns)), height = std::min(kTile, std::bit_floor(rows));
    Spectrum spectrum(width, height);
    const std::size_t deep = std::min<std::size_t>(slices, 8);
    std::size_t across = (columns + width - 1) / width, down = (rows + height - 1) / height;
    while (across * down * deep > kMostTiles) across >= down ? --across : --down;
    const auto place = [](std::size_t i, std::size_t of, std::size_t room) { return of > 1 ? i * room / (of - 1) : room / 2; };
    for (std::size_t k = 0; k < deep; ++k)
        for (std::size_t j = 0; j < down; ++j)
            for (std::size_t i = 0; i < across; ++i)
                spectrum.add(grid, place(i, across, columns - width),
                             place(k, deep, slices - 1) * rows + place(j, down, rows - height));
    return spectrum;
}

// The level of the water at which the mean of what is under it is `square`. What is under it grows with the level as the number
// of those that are over it, which only fall: from below, each step ends on the line that it is on or short of the level.
double water_level(const std::vector<double>& power, double square) {
    double level = square;
    for (;;) {
        double under = 0;
        std::size_t over = 0;
        for (const double one : power) {
            under += std::min(one, level);
            over += one > level;
        }
        if (over == 0) return level;  // all of it may be wrong
        const double step = (square * static_cast<double>(power.size()) - under) / static_cast<double>(over);
        if (step <= 1e-12 * level) return level;
        level += step;
    }
}

// Bands of rows evenly over it, each in the middle of its part, together no more than kMostTileCells, which stand for the rest.
LevelGrid sample_of(const LevelGrid& grid) {
    constexpr std::size_t kBand = 16;
    const std::size_t rows = grid.count() / static_cast<std::size_t>(grid.columns), bands = rows / kBand,
                      taken = std::max<std::size_t>(1, kMostTileCells / (kBand * static_cast<std::size_t>(grid.columns)));
    if (grid.count() <= kMostTileCells || bands <= taken) return grid;
    std::vector<std::uint16_t> values;
    for (std::size_t i = 0; i < taken; ++i)
        grid.values.visit([&](const auto* all) {
            const std::size_t from = (2 * i + 1) * bands / (2 * taken) * kBand * static_cast<std::size_t>(grid.columns);
            values.insert(values.end(), all + from, all + from + kBand * static_cast<std::size_t>(grid.columns));
        });
    return {grid.columns, static_cast<int>(taken * kBand), 1, grid.levels, std::move(values)};
}

double rate_of(const LevelGrid& grid, double error) {
    if (!(error > 0)) throw std::logic_error("an error that nobody notices is over 0");
    Spectrum spectrum = spectrum_of(grid);
    const std::vector<double> power = spectrum.power();
    const double level = water_level(power, error * error), missing = spectrum.missing_bits();
    double bits = 0;
    for (const double one : power)
        if (one > level) bits += 0.5 * std::log2(one / level) + missing;
    return bits / static_cast<double>(power.size());
}

}  // namespace

double gaussian_rate(const LevelGrid& grid, double error) {
    check_grid(grid);
    return rate_of(grid, error);
}

double felt_bits(const LevelGrid& grid, double error) {
    const double gaussian = rate_of(grid, error) * static_cast<double>(grid.count());
    if (gaussian == 0) return 0;
    // Steps of s are wrong by s / sqrt(12).
    const int levels = static_cast<int>(std::clamp(std::ceil(grid.levels / (error * std::sqrt(12))), 1.0, 65536.0));
    if (levels < 2) return std::min(gaussian, 1.0);
    const LevelGrid sample = sample_of(grid);
    const double share = static_cast<double>(sample.count()) / static_cast<double>(grid.count());
    return std::min(gaussian, neighbour_bits(with_levels(sample, levels)) / share);
}

int weber_levels(double least, double most) {
    if (!(least > 0 && most > least)) return 1;
    return std::max(1, static_cast<int>(std::lround(std::log(most / least) / std::log1p(kWeberForce))));
}

}  // namespace tactics
