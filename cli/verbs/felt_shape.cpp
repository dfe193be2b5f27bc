// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/felt_shape.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace tactics {

namespace {

constexpr double kBegin = 0.1, kEnd = 0.9;     // of a section
constexpr double kMissing = 0.13;              // of a section without a height: unknown
constexpr double kOfAll = 0.1, kOfOwn = 0.15;  // of the heights: less is level
constexpr double kAbrupt = 0.25;               // of a section, within which a step rises

// Up and down from one turn to the next, where it comes back by at least `least`: the section's own ends and its turns.
std::vector<double> turns_of(const std::vector<Point>& heights, double least) {
    std::vector<double> turns = {heights.front().y};
    double low = turns[0], high = turns[0];
    int way = 0;
    for (const Point& one : heights) {
        if (way == 0) {
            low = std::min(low, one.y), high = std::max(high, one.y);
            if (one.y - low >= least)
                way = 1, turns = {low}, high = one.y;
            else if (high - one.y >= least)
                way = -1, turns = {high}, low = one.y;
        } else if (way > 0) {
            high = std::max(high, one.y);
            if (high - one.y >= least) turns.push_back(high), low = one.y, way = -1;
        } else {
            low = std::min(low, one.y);
            if (one.y - low >= least) turns.push_back(low), high = one.y, way = 1;
        }
    }
    if (way != 0) turns.push_back(way > 0 ? high : low);
    return turns;
}

// Its whole rise or fall but a tenth at either end lies within a short stretch.
bool is_abrupt(const std::vector<Point>& heights, double from, double to) {
    const auto share = [&](const Point& one) { return (one.y - from) / (to - from); };
    const auto left = std::find_if(heights.rbegin(), heights.rend(), [&](const Point& one) { return share(one) < 0.1; });
    const auto right = std::find_if(heights.begin(), heights.end(), [&](const Point& one) { return share(one) > 0.9; });
    return left != heights.rend() && right != heights.end() && right->x - left->x < kAbrupt;
}

struct ShapeWords {
    std::string_view name;
    SourceWords words;
};
constexpr ShapeWords kShapes[] = {
    {"level", SourceWords("level ground")}, {"slope", SourceWords("a slope")},   {"step", SourceWords("a step")},
    {"waves", SourceWords("waves")},        {"hump", SourceWords("a hump")},     {"dip", SourceWords("a dip")},
    {"hill", SourceWords("a hill")},        {"bowl", SourceWords("a bowl")},     {"saddle", SourceWords("a saddle")},
    {"ridge", SourceWords("a ridge")},      {"valley", SourceWords("a valley")}, {"hole", SourceWords("a surface with a hole")}};

}  // namespace

std::string_view course_of(const Section& section, double whole) {
    const auto within = [](double share) { return share >= kBegin && share <= kEnd; };
    if (std::any_of(section.bare.begin(), section.bare.end(), within)) return "hole";
    std::vector<Point> heights;
    for (const Point& one : section.heights)
        if (within(one.x)) heights.push_back(one);
    double reached = kBegin;
    bool missing = false;
    for (const Point& one : heights) missing |= one.x - std::exchange(reached, one.x) > kMissing;
    if (missing || kEnd - reached > kMissing || !(whole > 0)) return "";
    const auto [low, high] =
        std::minmax_element(heights.begin(), heights.end(), [](const Point& a, const Point& b) { return a.y < b.y; });
    const std::vector<double> turns = turns_of(heights, std::max(kOfAll * whole, kOfOwn * (high->y - low->y)));
    if (turns.size() < 2) return "level";
    if (turns.size() == 2) return is_abrupt(heights, turns[0], turns[1]) ? "step" : "slope";
    if (turns.size() == 3) return turns[1] > turns[0] ? "hump" : "dip";
    return "waves";
}

std::string_view shape_of(std::string_view across, std::string_view down) {
    if (across.empty() || down.empty()) return "";
    const auto either = [&](std::string_view course) { return across == course || down == course; };
    if (either("hole")) return "hole";
    const bool humps = either("hump"), dips = either("dip"), steps = either("step"), waves = either("waves");
    if (humps && dips) return "saddle";
    if (humps + dips + steps + waves > 1) return "";
    if (waves) return "waves";
    if (steps) return "step";
    if (humps) return across == down ? "hill" : "ridge";
    if (dips) return across == down ? "bowl" : "valley";
    return either("slope") ? "slope" : "level";
}

Phrase spoken_shape(std::string_view shape_or_course) {
    const auto found =
        std::find_if(std::begin(kShapes), std::end(kShapes), [&](const ShapeWords& one) { return one.name == shape_or_course; });
    return found == std::end(kShapes) ? Phrase(shape_or_course) : phrase(found->words);
}

}  // namespace tactics
