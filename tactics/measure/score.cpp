// SPDX-License-Identifier: Apache-2.0
#include "tactics/measure/score.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "tactics/measure/lines.h"

namespace tactics {

namespace {

constexpr int kLevels = 48;
// From one grey level up, each level so many times the one below: 1.12^46 is 184, more than any threshold of use.
constexpr double kStep = 1.12;

double share_of(long long part, long long all) { return all > 0 ? static_cast<double>(part) / static_cast<double>(all) : 0; }

// Lines against some annotators; the lines may change from call to call.
class Referee {
public:
    Referee(int width, int height) : reach_(reach_of(width, height)) {}

    void add(const PixelSet& annotator) {
        matchings_.emplace_back(annotator, reach_);
        truth_ += static_cast<long long>(annotator.pixels.size());
    }

    Counts score(const PixelSet& lines) {
        Counts counts;
        counts.truth = truth_;
        counts.lines = static_cast<long long>(lines.pixels.size());
        for (Matching& matching : matchings_) {
            matching.match(lines);
            counts.found += static_cast<long long>(matching.pairs());
        }
        counts.right = std::count_if(lines.pixels.begin(), lines.pixels.end(), [&](std::uint32_t pixel) {
            return std::any_of(matchings_.begin(), matchings_.end(), [&](const Matching& m) { return m.has_pair(pixel); });
        });
        return counts;
    }

private:
    double reach_;
    std::vector<Matching> matchings_;
    long long truth_ = 0;
};

}  // namespace

Counts& Counts::operator+=(const Counts& other) {
    found += other.found;
    truth += other.truth;
    right += other.right;
    lines += other.lines;
    return *this;
}

double Counts::precision() const { return share_of(right, lines); }
double Counts::recall() const { return share_of(found, truth); }
double Counts::f() const {
    const double p = precision(), r = recall();
    return p + r > 0 ? 2 * p * r / (p + r) : 0;
}

double reach_of(int width, int height) {
    constexpr double kShareOfDiagonal = 0.0075;  // the benchmark's maxDist
    return kShareOfDiagonal * std::hypot(width, height);
}

std::span<const float> levels() {
    static const std::array<float, kLevels> kAll = [] {
        std::array<float, kLevels> all{};
        for (int i = 0; i + 1 < kLevels; ++i)
            all[static_cast<std::size_t>(i)] = static_cast<float>(std::pow(kStep, kLevels - 2 - i));
        return all;
    }();
    return kAll;
}

std::vector<Counts> score_at_levels(const EdgeMap& lines, std::span<const PixelSet> annotators) {
    Referee referee(lines.width, lines.height);
    for (const PixelSet& annotator : annotators) referee.add(annotator);
    std::vector<Counts> curve;
    std::ptrdiff_t before = -1;
    for (const float level : levels()) {
        // Between two levels often nothing is added: a recipe without strengths has one state at all of them.
        const std::ptrdiff_t kept =
            std::count_if(lines.strength.begin(), lines.strength.end(), [&](float s) { return s > 0 && s >= level; });
        curve.push_back(kept == before ? curve.back() : referee.score(cut_at(lines, level)));
        before = kept;
    }
    return curve;
}

Counts score_person(std::span<const PixelSet> annotators, std::size_t one) {
    if (annotators.size() < 2) return {};
    Referee referee(annotators[one].width, annotators[one].height);
    for (std::size_t other = 0; other < annotators.size(); ++other)
        if (other != one) referee.add(annotators[other]);
    return referee.score(thinned(annotators[one]));
}

Counts score_people(std::span<const PixelSet> annotators) {
    Counts sum;
    for (std::size_t i = 0; i < annotators.size(); ++i) sum += score_person(annotators, i);
    return sum;
}

}  // namespace tactics
