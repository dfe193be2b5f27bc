// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/line_field.h"

#include <algorithm>
#include <cmath>

namespace tactics {

namespace {

// The least (or the largest) of each value and its neighbours in the same row or column, each more (or less) by `bend` times its
// distance squared. What comes in rises by no more than 1 from node to node in units of the pitch, so that farther neighbours
// never count.
class Envelope {
public:
    Envelope(std::size_t columns, std::size_t rows, std::size_t window, double bend)
        : columns_(columns), rows_(rows), window_(window), bend_(static_cast<float>(bend)) {}

    template <typename Pick>
    void along_rows(std::vector<float>& values, float sign, Pick pick) {
        std::vector<float> before(columns_);
        for (std::size_t row = 0; row < rows_; ++row) {
            float* to = values.data() + row * columns_;
            std::copy_n(to, columns_, before.data());
            for (std::size_t k = 1; k <= std::min(window_, columns_ - 1); ++k) {
                const float more = sign * bend_ * static_cast<float>(k * k);
                take(to, before.data() + k, columns_ - k, more, pick);
                take(to + k, before.data(), columns_ - k, more, pick);
            }
        }
    }
    template <typename Pick>
    void along_columns(std::vector<float>& values, float sign, Pick pick) {
        // The rows above that are overwritten already are kept as they were.
        std::vector<std::vector<float>> above(window_ + 1, std::vector<float>(columns_));
        for (std::size_t row = 0; row < rows_; ++row) {
            float* to = values.data() + row * columns_;
            std::copy_n(to, columns_, above[row % above.size()].data());
            for (std::size_t k = 1; k <= window_; ++k) {
                const float more = sign * bend_ * static_cast<float>(k * k);
                if (row + k < rows_) take(to, to + k * columns_, columns_, more, pick);
                if (k <= row) take(to, above[(row - k) % above.size()].data(), columns_, more, pick);
            }
        }
    }

private:
    template <typename Pick>
    static void take(float* to, const float* from, std::size_t count, float more, Pick pick) {
        for (std::size_t i = 0; i < count; ++i) to[i] = pick(to[i], from[i] + more);
    }
    std::size_t columns_, rows_, window_;
    float bend_;
};

}  // namespace

LineField::LineField(const std::vector<std::vector<Point>>& lines, const Reach& reach) : far_(reach.far) {
    const std::vector<LineSegment> segments = segments_of(lines);
    if (segments.empty()) return;
    // The cut at the far limit makes an edge, which is rounded like others.
    const double cut = far_ + reach.blend;
    squares_ = squares_round(segments, cut, kPitch, kMostNodes);
    std::vector<float> distances(squares_.columns * squares_.rows, static_cast<float>(cut));
    const auto square = [&](std::size_t column, std::size_t row, double nearest, const std::vector<FoundSegment>&) {
        distances[row * squares_.columns + column] = static_cast<float>(std::min(nearest, cut));
    };
    // Noise that fills a plot is done with here: each node has a line beside it.
    const double beside = std::min(cut, squares_.side / 2);
    each_square_beside(
        segments, squares_, beside, [&](std::size_t column, std::size_t row, double across, const LineSegment& segment) {
            float& known = distances[row * squares_.columns + column];
            if (across > static_cast<double>(known) * (1 + 1e-6)) return;
            const Point middle = squares_.middle(static_cast<double>(column), static_cast<double>(row));
            known = std::min(known, static_cast<float>(distance(place_on(segment, nearest_along(segment, middle)), middle)));
        });
    const auto unknown = [&](std::size_t column, std::size_t row, std::size_t size) {
        const auto most = static_cast<float>(beside * (1 - 1e-6));
        const std::size_t columns = std::min(size, squares_.columns - column), end = std::min(row + size, squares_.rows);
        for (const float* from = &distances[row * squares_.columns + column]; row < end; ++row, from += squares_.columns)
            if (std::any_of(from, from + columns, [&](float one) { return !(one < most); })) return true;
        return false;
    };
    SquareDescent(segments, squares_, cut, false, square, unknown).run();
    round_edges(distances, reach.blend);
    take_squares(distances);
}

void LineField::round_edges(std::vector<float>& distances, double blend) const {
    const double pitch = squares_.side, bend = 1 / blend * pitch * pitch;
    Envelope envelope(squares_.columns, squares_.rows, static_cast<std::size_t>(blend / 2 / pitch) + 1, bend);
    const auto less = [](float a, float b) { return b < a ? b : a; };
    const auto more = [](float a, float b) { return b > a ? b : a; };
    envelope.along_rows(distances, 1, less);
    envelope.along_columns(distances, 1, less);
    envelope.along_rows(distances, -1, more);
    envelope.along_columns(distances, -1, more);
}

// A quadratic spline through weights x^2 is x^2 + 1/4, in units of the pitch: an eighth of the second differences is taken off
// beforehand. Beside a line no weight is below 1/8, so that nowhere the whole is 0, where a distance has no direction.
void LineField::take_squares(const std::vector<float>& distances) {
    const std::size_t columns = squares_.columns, rows = squares_.rows;
    const auto least = static_cast<float>(squares_.side * squares_.side / 8);
    weights_.resize(distances.size());
    const auto squared = [&](std::size_t column, std::size_t row) {
        const float value = distances[row * columns + column];
        return value * value;
    };
    for (std::size_t row = 0; row < rows; ++row)
        for (std::size_t column = 0; column < columns; ++column) {
            const float here = squared(column, row);
            const float beside = squared(column > 0 ? column - 1 : 0, row) + squared(std::min(column + 1, columns - 1), row) +
                                 squared(column, row > 0 ? row - 1 : 0) + squared(column, std::min(row + 1, rows - 1));
            weights_[row * columns + column] = std::max(here - (beside - 4 * here) / 8, least);
        }
}

namespace {

// Of the spline's three pieces at a place between -1/2 and 1/2 from the middle one.
struct Pieces {
    double value[3], slope[3];
    explicit Pieces(double at) noexcept
        : value{(0.5 - at) * (0.5 - at) / 2, 0.75 - at * at, (0.5 + at) * (0.5 + at) / 2}, slope{at - 0.5, -2 * at, at + 0.5} {}
};

}  // namespace

LineField::Felt LineField::at(const Point3& place) const noexcept {
    Felt felt;
    const double column = (place.x - squares_.corner.x) / squares_.side, row = (place.y - squares_.corner.y) / squares_.side;
    // Of each node the square around it; the outermost have no neighbours on one side.
    if (!(column >= 1 && row >= 1 && column < static_cast<double>(squares_.columns) - 1 &&
          row < static_cast<double>(squares_.rows) - 1 && std::abs(place.z) < far_))
        return felt;
    const auto c = static_cast<std::size_t>(column), r = static_cast<std::size_t>(row);
    const Pieces x(column - static_cast<double>(c) - 0.5), y(row - static_cast<double>(r) - 0.5);
    double squared = 0, right = 0, down = 0;
    for (std::size_t j = 0; j < 3; ++j) {
        const float* weight = weights_.data() + (r - 1 + j) * squares_.columns + c - 1;
        double sum = 0, change = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            sum += x.value[i] * static_cast<double>(weight[i]);
            change += x.slope[i] * static_cast<double>(weight[i]);
        }
        squared += y.value[j] * sum;
        right += y.value[j] * change;
        down += y.slope[j] * sum;
    }
    felt.distance = std::sqrt(squared + place.z * place.z);
    felt.within = felt.distance < far_;
    if (!felt.within || !(felt.distance > 0)) return felt;
    const double flat = 1 / (2 * felt.distance * squares_.side);
    felt.slope = {right * flat, down * flat, place.z / felt.distance};
    return felt;
}

}  // namespace tactics
