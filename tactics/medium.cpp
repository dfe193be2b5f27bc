// SPDX-License-Identifier: Apache-2.0
#include "tactics/medium.h"

#include <algorithm>
#include <string>
#include <vector>

#include "tactics/error.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr Paper kPapers[] = {
#define PAPER(...) {__VA_ARGS__},
#include "tactics/papers.inc"
#undef PAPER
};

constexpr Medium kMedia[] = {
#define MEDIUM(...) {__VA_ARGS__},
#include "tactics/media.inc"
#undef MEDIUM
};

constexpr NamedCell kCells[] = {
#define CELL(name, summary, ...) {name, summary, {__VA_ARGS__}},
#include "tactics/cells.inc"
#undef CELL
};

// PDF 1.7 (ISO 32000-1, annex C) allows pages up to 14,400 points; smaller than this holds no braille cell.
constexpr double kLongestSide = 14'400 * kMmPerPoint;
constexpr double kShortestSide = 10;

// "200x150mm": the unit stands at the end and counts for both.
bool parse_size(std::string_view text, double& width, double& height) {
    const auto cross = text.find('x');
    if (cross == std::string_view::npos) return false;
    const auto second = text.substr(cross + 1);
    const auto unit_at = second.find_first_not_of("0123456789.");
    const std::string unit(unit_at == std::string_view::npos ? "" : second.substr(unit_at));
    const auto w = parse_length(std::string(text.substr(0, cross)) + unit);
    const auto h = parse_length(second);
    if (!w || !h || unit_at == 0) return false;
    width = std::min(*w, *h);
    height = std::max(*w, *h);
    return true;
}

}  // namespace

double least_apart(const Medium& medium, double width, double other_width) {
    return std::max(medium.gap + (width + other_width) / 2, has_fixed_dots(medium) ? kTwoRows : 0.0);
}

std::span<const Paper> papers() { return kPapers; }
std::span<const Medium> media() { return kMedia; }
std::span<const NamedCell> cells() { return kCells; }

Paper find_paper(std::string_view text, std::string_view place) {
    std::vector<std::string_view> names;
    std::string lower(text);
    for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    for (const Paper& paper : kPapers) {
        if (paper.name == lower) return paper;
        names.push_back(paper.name);
    }
    Paper own{"custom", "a size given in numbers", 0, 0};
    if (!parse_size(lower, own.width, own.height))
        throw Error(Fault::usage, place,
                    phrase("there is no paper \"{0}\"{1}; see tactics list papers, or give a size such as 200x150mm or 8.5x11in",
                           text, did_you_mean(lower, names)));
    if (own.width < kShortestSide || own.height > kLongestSide + 1e-6)
        throw Error(Fault::usage, place,
                    phrase("paper {0} is out of range; each side is 10 to {1} mm", text, to_text(kLongestSide)));
    return own;
}

const NamedCell& find_cell(std::string_view name, std::string_view place) {
    std::vector<std::string_view> names;
    for (const NamedCell& cell : kCells) {
        if (cell.name == name) return cell;
        names.push_back(cell.name);
    }
    throw Error(Fault::usage, place,
                phrase("there is no cell \"{0}\"{1}; see tactics list cells", name, did_you_mean(name, names)));
}

const Medium& find_medium(std::string_view name, std::string_view place) {
    std::vector<std::string_view> names;
    for (const Medium& medium : kMedia) {
        if (medium.name == name) return medium;
        names.push_back(medium.name);
    }
    throw Error(Fault::usage, place,
                phrase("there is no medium \"{0}\"{1}; see tactics list media", name, did_you_mean(name, names)));
}

}  // namespace tactics
