// SPDX-License-Identifier: Apache-2.0
// From logits to an edge map: probabilities at full size, averaged over sizes, and the direction across each contour.
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "filters/net/input.h"
#include "filters/net/net.h"
#include "filters/net/resize.h"

namespace tactics {

namespace {

// Probabilities are counted in 256ths of a grey level.
constexpr int kCertain = 255 * 256;
constexpr int kTableReach = 16;   // logits beyond are as good as certain
constexpr int kTableSteps = 256;  // a unit
constexpr int kTableMiddle = kTableReach * kTableSteps;

// The logistic function. No machine computes exp() quite like another, but all multiply and divide alike.
std::vector<std::int32_t> logistic_table() {
    std::vector<std::int32_t> table(2 * kTableMiddle + 2, kCertain);
    constexpr double kStep = 1.00391388933834757344;  // e to the 1/256
    double power = 1;
    for (int i = 0; i <= kTableMiddle; ++i, power *= kStep) {
        const auto unlikely = static_cast<std::int32_t>(kCertain / (1 + power) + 0.5);
        table[static_cast<std::size_t>(kTableMiddle - i)] = unlikely;
        table[static_cast<std::size_t>(kTableMiddle + i)] = kCertain - unlikely;
    }
    return table;
}

// Of a logit with 12 bits of fraction.
std::int32_t probability(std::int32_t logit) {
    static const std::vector<std::int32_t> kTable = logistic_table();
    constexpr int kLast = 2 * kTableMiddle * 16;
    const std::int32_t at = std::clamp(logit + kTableMiddle * 16, 0, kLast), part = at % 16;
    const std::int32_t* entry = &kTable[static_cast<std::size_t>(at / 16)];
    return (entry[0] * (16 - part) + entry[1] * part + 8) >> 4;
}

// Adds the probabilities at full size; `run_width` is the width of the picture that the net was given, which may be another.
void add_probabilities(const ContourLogits& logits, Size run, Size full, std::vector<std::int32_t>& sums) {
    // The middle of pixel x lies at (2x + 1) / 2 * run / full of the picture that was run; a logit is 2 pixels of that.
    const std::vector<Between> columns = between(full.width, run.width, 2 * full.width, logits.width),
                               rows = between(full.height, run.height, 2 * full.height, logits.height);
    std::vector<std::int32_t> mixed(static_cast<std::size_t>(logits.width));
    const auto row_of = [&](int y) {
        return &logits.values[static_cast<std::size_t>(y) * static_cast<std::size_t>(logits.width)];
    };
    for (int y = 0; y < full.height; ++y) {
        const Between& at = rows[static_cast<std::size_t>(y)];
        const std::int16_t *upper = row_of(at.first), *lower = row_of(at.second);
        for (std::size_t x = 0; x < mixed.size(); ++x) mixed[x] = upper[x] * (kWhole - at.share) + lower[x] * at.share;
        std::int32_t* sum = &sums[static_cast<std::size_t>(y) * static_cast<std::size_t>(full.width)];
        for (std::size_t x = 0; x < columns.size(); ++x) {
            const Between& column = columns[x];
            const std::int32_t value = mixed[static_cast<std::size_t>(column.first)] * (kWhole - column.share) +
                                       mixed[static_cast<std::size_t>(column.second)] * column.share;
            sum[x] += probability((value + (1 << 11)) >> 12);
        }
    }
}

// The angle of (x, y), not both 0, from 0 to pi / 2; within 1e-5, by the polynomial 4.4.49 of Abramowitz and Stegun.
float quarter_angle(float x, float y) {
    const float t = std::min(x, y) / std::max(x, y), s = t * t;
    const float angle = t * (0.9998660f + s * (-0.3302995f + s * (0.1801410f + s * (-0.0851330f + s * 0.0208351f))));
    return y > x ? std::numbers::pi_v<float> / 2 - angle : angle;
}

float angle_of(float x, float y) {
    if (x == 0 && y == 0) return 0;
    const float angle = quarter_angle(std::abs(x), std::abs(y));
    const float upper = x < 0 ? std::numbers::pi_v<float> - angle : angle;
    return y < 0 ? -upper : upper;
}

// In which direction the map is bent down most, from its second derivatives after smoothing by a triangle 9 pixels wide.
class Normals {
public:
    Normals(const std::vector<std::int32_t>& map, int width, int height) : map_(map), width_(width), height_(height) {
        for (auto& row : rows_) row.resize(static_cast<std::size_t>(width + 2 * kAround));
    }

    std::vector<float> all() {
        std::vector<float> normals(map_.size());
        for (int y = -kAround; y < kAround; ++y) smooth(y);
        for (int y = 0; y < height_; ++y) {
            smooth(y + kAround);
            bend(y, &normals[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_)]);
        }
        return normals;
    }

private:
    static constexpr int kAround = 2;  // rows and columns that a second derivative sees
    static constexpr int kReach = 4;   // of the triangle
    static constexpr std::size_t kRows = 2 * kAround + 1;

    // A triangle is two boxes of five, one after the other.
    static void box(const std::vector<std::int32_t>& from, std::vector<std::int32_t>& to) {
        to.resize(from.size() - kReach);
        for (std::size_t i = 0; i < to.size(); ++i) to[i] = from[i] + from[i + 1] + from[i + 2] + from[i + 3] + from[i + 4];
    }

    std::vector<float>& row(int y) { return rows_[static_cast<std::size_t>(y + 2 * static_cast<int>(kRows)) % kRows]; }

    // Row y of the smoothed map, beyond the border the outermost pixel. 255 * 256 * 625 fits.
    void smooth(int y) {
        constexpr int kFrame = kAround + kReach;
        down_.assign(static_cast<std::size_t>(width_ + 2 * kFrame), 0);
        for (int away = -kReach; away <= kReach; ++away) {
            const std::int32_t weight = kReach + 1 - std::abs(away);
            const std::int32_t* from =
                &map_[static_cast<std::size_t>(std::clamp(y + away, 0, height_ - 1)) * static_cast<std::size_t>(width_)];
            std::int32_t* to = down_.data() + kFrame;
            for (int x = 0; x < width_; ++x) to[x] += weight * from[x];
        }
        const auto end = down_.end() - kFrame;
        std::fill(down_.begin(), down_.begin() + kFrame, down_[kFrame]);
        std::fill(end, down_.end(), *(end - 1));
        box(down_, boxed_);
        box(boxed_, down_);
        std::transform(down_.begin(), down_.end(), row(y).begin(), [](std::int32_t sum) { return static_cast<float>(sum); });
    }

    void bend(int y, float* normals) {
        const float *far_above = row(y - 2).data() + kAround, *above = row(y - 1).data() + kAround,
                    *here = row(y).data() + kAround, *below = row(y + 1).data() + kAround,
                    *far_below = row(y + 2).data() + kAround;
        for (int x = 0; x < width_; ++x) {
            const float xx = here[x + 2] - 2 * here[x] + here[x - 2], yy = far_below[x] - 2 * here[x] + far_above[x];
            const float xy = below[x + 1] + above[x - 1] - above[x + 1] - below[x - 1];
            const float angle = angle_of(yy - xx, -2 * xy) / 2;
            const float turned = angle < 0 ? angle + std::numbers::pi_v<float> : angle;
            normals[x] = turned < std::numbers::pi_v<float> ? turned : 0;
        }
    }

    const std::vector<std::int32_t>& map_;
    int width_, height_;
    std::array<std::vector<float>, kRows> rows_;
    std::vector<std::int32_t> down_, boxed_;
};

}  // namespace

EdgeMap contour_map(const ContourNet& net, const Image& image, std::span<const double> scales, const NetRun& run) {
    constexpr std::array<double, 1> kAsItIs = {1.0};
    if (scales.empty()) scales = kAsItIs;
    const NetLevels levels = net_levels(image);
    const Size full{image.width, image.height};
    std::vector<std::int32_t> sums(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
    for (const double scale : scales) {
        if (!(scale >= 0.1 && scale <= 4)) throw std::logic_error("contour_map: a scale is from 0.1 to 4");
        const Size size = scaled_size(full, scale);
        if (size.width == full.width && size.height == full.height)
            add_probabilities(logits_of(net, image, levels, run), size, full, sums);
        else
            add_probabilities(logits_of(net, resized(image, size), levels, run), size, full, sums);
    }
    EdgeMap map;
    map.width = image.width;
    map.height = image.height;
    map.mm_per_pixel = image.mm_per_pixel;
    const auto count = static_cast<std::int32_t>(scales.size());
    map.strength.reserve(sums.size());
    for (std::int32_t& sum : sums) {
        sum = (sum + count / 2) / count;
        map.strength.push_back(static_cast<float>(sum) / 256);
    }
    map.normal = Normals(sums, image.width, image.height).all();
    return map;
}

}  // namespace tactics
