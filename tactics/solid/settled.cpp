// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/settled.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <vector>

namespace tactics {

namespace {

constexpr double kLastDigits = 1.1e-6;  // of the extent, by which what is meant to be the same may differ either way
constexpr double kAlone = 10;           // times that: nothing else is so near to numbers that are one
constexpr double kPlain = 200;          // times that: a step on which a number lies by intention, not one in a hundred by chance
constexpr double kPlainWithOthers = 5;  // times that: the same of a number among numbers that nearly all lie on such steps
constexpr double kNearlyAll = 0.75;     // of the numbers along an axis
constexpr std::size_t kMostPlanes = 4096;  // numbers along an axis; more are a mesh that nobody wrote by its planes

// The number of the fewest decimals that is no farther away than `within`, on steps of `least` or more.
std::optional<double> plain(double number, double within, double least, int largest) {
    for (int power = largest;; --power) {
        const double ten = std::pow(10.0, std::abs(power));
        if ((power < 0 ? 1 / ten : ten) < least) return std::nullopt;
        const double times = std::round(power < 0 ? number * ten : number / ten);
        // A quotient of whole numbers is what reading that number gives.
        const double rounded = (power < 0 ? times / ten : times * ten) + 0.0;  // not -0
        if (std::abs(rounded - number) <= within) return rounded;
    }
}

// Numbers that are one.
struct Run {
    std::size_t begin, end;
    double one;
    bool is_alone;
};

void settle(std::vector<Point3>& places, double Point3::*axis, double within) {
    std::vector<std::uint32_t> order(places.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return places[a].*axis < places[b].*axis; });
    const auto at = [&](std::size_t i) { return places[order[i]].*axis; };
    std::vector<Run> runs;
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (i > 0 && at(i) <= at(i - 1) + within) continue;
        if (!runs.empty()) runs.back().end = i;
        runs.push_back({i, order.size(), 0, true});
    }
    if (runs.size() > kMostPlanes) return;
    const double far = std::max(std::abs(at(0)), std::abs(at(order.size() - 1)));
    const int largest = far > 0 ? static_cast<int>(std::ceil(std::log10(far))) + 1 : 0;
    std::size_t plain_ones = 0;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        Run& run = runs[i];
        const double low = at(run.begin), high = at(run.end - 1);
        run.one = low + (high - low) / 2;
        run.is_alone = high - low <= 2 * within && (i == 0 || low - at(run.begin - 1) > kAlone * within) &&
                       (i + 1 == runs.size() || at(run.end) - high > kAlone * within);
        plain_ones += plain(run.one, within, kPlainWithOthers * within, largest).has_value();
    }
    const bool all_plain = static_cast<double>(plain_ones) >= kNearlyAll * static_cast<double>(runs.size());
    for (const Run& run : runs) {
        if (!run.is_alone) continue;
        const double one = plain(run.one, within, (all_plain ? kPlainWithOthers : kPlain) * within, largest).value_or(run.one);
        for (std::size_t i = run.begin; i < run.end; ++i) places[order[i]].*axis = one;
    }
}

}  // namespace

Model settled(Model model) {
    constexpr double kFarthest = 1e9;  // times the extent from the origin, beyond which a number has no digits to spare
    if (model.vertices.empty()) return model;
    Point3 low = model.vertices.front(), high = low;
    for (const Point3& at : model.vertices) {
        low = {std::min(low.x, at.x), std::min(low.y, at.y), std::min(low.z, at.z)};
        high = {std::max(high.x, at.x), std::max(high.y, at.y), std::max(high.z, at.z)};
    }
    const double extent = length_of(high - low);
    const double far = std::max(length_of(low), length_of(high));
    if (!(extent > 0) || !std::isfinite(extent) || !(far < kFarthest * extent)) return model;
    for (double Point3::*axis : {&Point3::x, &Point3::y, &Point3::z}) settle(model.vertices, axis, kLastDigits * extent);
    return model;
}

}  // namespace tactics
