// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/svg_dashes.h"

#include <cmath>
#include <numeric>

#include "tactics/readers/svg/svg_numbers.h"

namespace tactics {

namespace {

// Of one pattern: a page has no room for more dashes in a line. What is behind them is not read, or many lines with a long
// pattern would take very long.
constexpr std::size_t kMostLengths = 1000;

}  // namespace

Dashes parse_dashes(std::string_view array, std::string_view offset, double whole, double scale) {
    Dashes dashes;
    if (array.empty() || array == "none") return dashes;
    while (!array.empty() && dashes.lengths.size() < kMostLengths) {
        const auto end = std::min(array.find_first_of(", \t\r\n"), array.size());
        const std::string_view one = array.substr(0, end);
        array.remove_prefix(std::min(end + 1, array.size()));
        if (one.empty()) continue;
        const auto length = parse_svg_length(one, whole);
        if (!length || *length < 0) return {};  // as SVG has it: the line is whole
        dashes.lengths.push_back(*length * scale);
    }
    if (dashes.lengths.size() % 2 == 1) dashes.lengths.insert(dashes.lengths.end(), dashes.lengths.begin(), dashes.lengths.end());
    const double period = std::accumulate(dashes.lengths.begin(), dashes.lengths.end(), 0.0);
    if (!(period > 0) || !std::isfinite(period)) return {};
    dashes.offset = std::fmod(parse_svg_length(offset, whole).value_or(0) * scale, period);
    if (!(dashes.offset >= 0)) dashes.offset += period;
    return dashes;
}

std::optional<std::vector<Subpath>> cut_into_dashes(const Subpath& line, const Dashes& dashes, std::size_t most) {
    const double period = std::accumulate(dashes.lengths.begin(), dashes.lengths.end(), 0.0);
    if (length_of(Stroke{line.points, line.closed}) / period * static_cast<double>(dashes.lengths.size()) >
        static_cast<double>(most))
        return std::nullopt;
    std::size_t part = 0;
    double left = dashes.offset;  // then: of this part
    while (left >= dashes.lengths[part] && left > 0) {
        left -= dashes.lengths[part];
        part = (part + 1) % dashes.lengths.size();
    }
    left = dashes.lengths[part] - left;
    std::vector<Subpath> pieces;
    Point at = line.points[0];
    const bool begins_inked = part % 2 == 0;
    if (begins_inked) pieces.push_back({{at}, false});
    const std::size_t sides = line.points.size() - (line.closed ? 0 : 1);
    for (std::size_t i = 0; i < sides; ++i) {
        const Point to = line.points[(i + 1) % line.points.size()];
        double side = distance(at, to);
        while (side >= left) {
            const double share = side > 0 ? left / side : 0;
            at = {at.x + share * (to.x - at.x), at.y + share * (to.y - at.y)};
            side -= left;
            if (part % 2 == 0) pieces.back().points.push_back(at);
            part = (part + 1) % dashes.lengths.size();
            left = dashes.lengths[part];
            if (part % 2 == 0) pieces.push_back({{at}, false});
        }
        left -= side;
        at = to;
        if (part % 2 == 0 && side > 0) pieces.back().points.push_back(at);
    }
    // A dash that begins where the line ends.
    const bool whole = !pieces.empty() && pieces.back().points.size() == 1;
    if (whole) pieces.pop_back();
    // A closed line that begins within a dash: its last dash goes on with its first.
    if (line.closed && begins_inked && !whole && part % 2 == 0 && pieces.size() > 1) {
        auto& last = pieces.back().points;
        last.insert(last.end(), pieces.front().points.begin() + 1, pieces.front().points.end());
        pieces.front() = std::move(pieces.back());
        pieces.pop_back();
    }
    return pieces;
}

}  // namespace tactics
