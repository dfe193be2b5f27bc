// SPDX-License-Identifier: Apache-2.0
#include "tactics/measure/regions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace tactics {

namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

std::size_t size_of(int width, int height) { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }

// Calls `visit` with each neighbour of a pixel by a side: left, above, right, below.
template <typename Visit>
void for_neighbours(std::size_t pixel, int width, int height, Visit visit) {
    const auto w = static_cast<std::size_t>(width);
    const std::size_t x = pixel % w;
    if (x > 0) visit(pixel - 1);
    if (pixel >= w) visit(pixel - w);
    if (x + 1 < w) visit(pixel + 1);
    if (pixel + w < w * static_cast<std::size_t>(height)) visit(pixel + w);
}

// Numbers connected sets of pixels of one value; what `skip` says stays kNone.
template <typename Value, typename Skip>
LabelMap parts_of(const Value& value, int width, int height, Skip skip) {
    LabelMap map{width, height, std::vector<std::uint32_t>(size_of(width, height), kNone), 0};
    std::vector<std::size_t> open;
    for (std::size_t start = 0; start < map.label.size(); ++start) {
        if (map.label[start] != kNone || skip(value[start])) continue;
        open.push_back(start);
        map.label[start] = map.regions;
        while (!open.empty()) {
            const std::size_t at = open.back();
            open.pop_back();
            for_neighbours(at, width, height, [&](std::size_t next) {
                if (map.label[next] != kNone || value[next] != value[start]) return;
                map.label[next] = map.regions;
                open.push_back(next);
            });
        }
        ++map.regions;
    }
    return map;
}

void give_to_nearest(LabelMap& map, std::vector<std::uint32_t> waiting) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> given;
    while (!waiting.empty()) {
        given.clear();
        std::vector<std::uint32_t> left;
        for (const std::uint32_t pixel : waiting) {
            std::uint32_t label = kNone;
            for_neighbours(pixel, map.width, map.height, [&](std::size_t next) {
                if (label == kNone) label = map.label[next];
            });
            if (label == kNone)
                left.push_back(pixel);
            else
                given.emplace_back(pixel, label);
        }
        for (const auto& [pixel, label] : given) map.label[pixel] = label;  // only now: all of a round are as near
        waiting = std::move(left);
    }
}

double share(long long part, long long all) { return static_cast<double>(part) / static_cast<double>(all); }

double entropy(const std::vector<long long>& areas, long long all) {
    double sum = 0;
    for (const long long area : areas)
        if (area > 0) sum -= share(area, all) * std::log2(share(area, all));
    return sum;
}

double pairs_of(const std::vector<long long>& areas) {
    double sum = 0;
    for (const long long area : areas) sum += 0.5 * static_cast<double>(area) * static_cast<double>(area - 1);
    return sum;
}

std::vector<long long> areas_of(std::span<const std::uint32_t> labels) {
    std::vector<long long> areas;
    for (const std::uint32_t label : labels) {
        if (label >= labels.size()) throw std::logic_error("a label is not less than the number of pixels");
        if (label >= areas.size()) areas.resize(label + 1, 0);
        ++areas[label];
    }
    return areas;
}

}  // namespace

LabelMap regions_between(const PixelSet& lines) {
    std::vector<std::uint8_t> line(size_of(lines.width, lines.height), 0);
    for (const std::uint32_t pixel : lines.pixels) line[pixel] = 1;
    LabelMap map = parts_of(line, lines.width, lines.height, [](std::uint8_t value) { return value != 0; });
    if (map.regions == 0) {
        std::fill(map.label.begin(), map.label.end(), 0u);
        map.regions = map.label.empty() ? 0 : 1;
        return map;
    }
    give_to_nearest(map, lines.pixels);
    return map;
}

LabelMap connected(std::span<const std::uint32_t> labels, int width, int height) {
    if (labels.size() != size_of(width, height)) throw std::logic_error("a map of regions has one label for each pixel");
    return parts_of(labels, width, height, [](std::uint32_t) { return false; });
}

LabelMap resized(const LabelMap& map, int width, int height) {
    std::vector<std::uint32_t> labels;
    labels.reserve(size_of(width, height));
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto column = static_cast<std::size_t>((2LL * x + 1) * map.width / (2LL * width));
            const auto row = static_cast<std::size_t>((2LL * y + 1) * map.height / (2LL * height));
            labels.push_back(map.label[row * static_cast<std::size_t>(map.width) + column]);
        }
    LabelMap made{width, height, std::move(labels), 0};
    std::vector<std::uint32_t> number(map.regions, kNone);  // some may have gone
    for (std::uint32_t& label : made.label) {
        if (number[label] == kNone) number[label] = made.regions++;
        label = number[label];
    }
    return made;
}

PixelSet borders_of(const LabelMap& map) {
    PixelSet set{map.width, map.height, {}};
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x) {
            const auto at = [&](int column, int row) {
                return map.label[static_cast<std::size_t>(std::min(row, map.height - 1)) * static_cast<std::size_t>(map.width) +
                                 static_cast<std::size_t>(std::min(column, map.width - 1))];
            };
            if (at(x, y) != at(x + 1, y) || at(x, y) != at(x, y + 1) || at(x, y) != at(x + 1, y + 1))
                set.pixels.push_back(static_cast<std::uint32_t>(y * map.width + x));
        }
    return set;
}

OverlapTable overlaps_of(std::span<const std::uint32_t> first, std::span<const std::uint32_t> second) {
    if (first.size() != second.size()) throw std::logic_error("two maps of regions have as many pixels");
    OverlapTable table{static_cast<long long>(first.size()), areas_of(first), areas_of(second), {}};
    // Pixels in the order of their first label; then each run counts its second labels in one row that all runs share.
    std::vector<std::size_t> begin(table.first.size() + 1, 0);
    for (std::size_t i = 0; i < table.first.size(); ++i) begin[i + 1] = begin[i] + static_cast<std::size_t>(table.first[i]);
    std::vector<std::uint32_t> ordered(second.size());
    std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
    for (std::size_t i = 0; i < first.size(); ++i) ordered[next[first[i]]++] = second[i];
    std::vector<std::size_t> place(table.second.size());
    std::vector<std::uint32_t> run_of(table.second.size(), kNone);
    for (std::uint32_t a = 0; a < table.first.size(); ++a)
        for (std::size_t i = begin[a]; i < begin[a + 1]; ++i) {
            const std::uint32_t b = ordered[i];
            if (run_of[b] != a) {
                run_of[b] = a;
                place[b] = table.parts.size();
                table.parts.push_back({a, b, 0});
            }
            ++table.parts[place[b]].pixels;
        }
    return table;
}

namespace {

// Of each region of the second map: intersection over union with that of the first that covers it best.
std::vector<double> best_overlaps(const OverlapTable& table) {
    std::vector<double> best(table.second.size(), 0.0);
    for (const OverlapTable::Part& part : table.parts)
        best[part.second] =
            std::max(best[part.second], share(part.pixels, table.first[part.first] + table.second[part.second] - part.pixels));
    return best;
}

}  // namespace

double covering(const OverlapTable& table) {
    const std::vector<double> best = best_overlaps(table);
    double sum = 0;
    for (std::size_t i = 0; i < best.size(); ++i) sum += best[i] * static_cast<double>(table.second[i]);
    return table.pixels > 0 ? sum / static_cast<double>(table.pixels) : 1;
}

double rand_index(const OverlapTable& table) {
    if (table.pixels < 2) return 1;
    std::vector<long long> both;
    for (const OverlapTable::Part& part : table.parts) both.push_back(part.pixels);
    return 1 - (pairs_of(table.first) + pairs_of(table.second) - 2 * pairs_of(both)) / pairs_of({table.pixels});
}

double variation_of_information(const OverlapTable& table) {
    std::vector<long long> both;
    for (const OverlapTable::Part& part : table.parts) both.push_back(part.pixels);
    const double sum = 2 * entropy(both, table.pixels) - entropy(table.first, table.pixels) - entropy(table.second, table.pixels);
    return std::max(0.0, sum);
}

std::span<const float> region_levels() {
    // From below the strongest down to about one grey level, each 8.3 % (1 - 1 / 1.09) below the one before.
    static const std::array<float, 64> kAll = [] {
        std::array<float, 64> all{};
        for (std::size_t i = 0; i + 1 < all.size(); ++i)
            all[i] = static_cast<float>(255 * std::pow(1.09, -static_cast<double>(i + 1)));
        return all;
    }();
    return kAll;
}

RegionTrial score_regions(std::span<const std::shared_ptr<const LabelMap>> maps, std::span<const LabelMap> annotators) {
    RegionTrial trial;
    std::vector<std::vector<double>> best(annotators.size());
    std::vector<std::vector<long long>> areas(annotators.size());
    for (std::size_t level = 0; level < maps.size(); ++level) {
        if (level > 0 && maps[level] == maps[level - 1]) {
            trial.curve.push_back(trial.curve.back());
            continue;
        }
        RegionScore& score = trial.curve.emplace_back();
        for (std::size_t i = 0; i < annotators.size(); ++i) {
            const OverlapTable table = overlaps_of(maps[level]->label, annotators[i].label);
            const auto count = static_cast<double>(annotators.size());
            score.covering += covering(table) / count;
            score.rand += rand_index(table) / count;
            score.information += variation_of_information(table) / count;
            const std::vector<double> own = best_overlaps(table);
            best[i].resize(own.size(), 0.0);
            for (std::size_t region = 0; region < own.size(); ++region) best[i][region] = std::max(best[i][region], own[region]);
            areas[i] = table.second;
        }
    }
    for (std::size_t i = 0; i < annotators.size(); ++i)
        for (std::size_t region = 0; region < areas[i].size(); ++region) {
            trial.weight += static_cast<double>(areas[i][region]);
            trial.best += best[i][region] * static_cast<double>(areas[i][region]);
        }
    if (trial.weight > 0) trial.best /= trial.weight;
    return trial;
}

RegionTrial score_people(std::span<const LabelMap> annotators) {
    RegionTrial mean;
    if (annotators.size() < 2) return mean;
    const auto count = static_cast<double>(annotators.size());
    mean.curve.resize(region_levels().size());
    for (std::size_t i = 0; i < annotators.size(); ++i) {
        std::vector<LabelMap> others(annotators.begin(), annotators.end());
        const auto own = at_all_levels(std::move(others[i]));
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
        const RegionTrial trial = score_regions(own, others);
        mean.best += trial.best / count;
        mean.weight += trial.weight / count;
        for (std::size_t level = 0; level < mean.curve.size(); ++level) {
            mean.curve[level].covering += trial.curve[level].covering / count;
            mean.curve[level].rand += trial.curve[level].rand / count;
            mean.curve[level].information += trial.curve[level].information / count;
        }
    }
    return mean;
}

std::vector<std::shared_ptr<const LabelMap>> at_all_levels(LabelMap map) {
    return {region_levels().size(), std::make_shared<const LabelMap>(std::move(map))};
}

RegionFigures region_figures(std::span<const RegionTrial> trials) {
    RegionFigures figures;
    const std::size_t levels = region_levels().size();
    std::vector<RegionScore> sums(levels);
    double weight = 0;
    for (const RegionTrial& trial : trials) {
        if (trial.curve.empty()) continue;
        ++figures.pictures;
        weight += trial.weight;
        RegionScore own = trial.curve.front();
        for (std::size_t level = 0; level < levels; ++level) {
            const RegionScore& score = trial.curve[level];
            sums[level].covering += trial.weight * score.covering;
            sums[level].rand += score.rand;
            sums[level].information += score.information;
            own.covering = std::max(own.covering, score.covering);
            own.rand = std::max(own.rand, score.rand);
            own.information = std::min(own.information, score.information);
        }
        figures.covering_ois += trial.weight * own.covering;
        figures.covering_best += trial.weight * trial.best;
        figures.rand_ois += own.rand;
        figures.information_ois += own.information;
    }
    if (figures.pictures == 0) return figures;
    const auto count = static_cast<double>(figures.pictures);
    figures.information_ods = std::numeric_limits<double>::max();
    for (std::size_t level = 0; level < levels; ++level) {
        if (const double covered = sums[level].covering / weight; covered > figures.covering_ods) {
            figures.covering_ods = covered;
            figures.level = region_levels()[level];
        }
        figures.rand_ods = std::max(figures.rand_ods, sums[level].rand / count);
        figures.information_ods = std::min(figures.information_ods, sums[level].information / count);
    }
    figures.covering_ois /= weight;
    figures.covering_best /= weight;
    figures.rand_ois /= count;
    figures.information_ois /= count;
    return figures;
}

}  // namespace tactics
