// SPDX-License-Identifier: Apache-2.0
#include "tactics/spot.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "tactics/drawing.h"
#include "tactics/error.h"
#include "tactics/units.h"

namespace tactics {

namespace {

// To the six decimals that to_text writes, so that what is saved is the same when it is read back.
std::optional<double> percent_of(std::string_view text) {
    if (!text.ends_with('%')) return std::nullopt;
    const auto number = parse_number(text.substr(0, text.size() - 1));
    return number ? std::optional(std::round(*number * 1e6) / 1e6) : std::nullopt;
}

std::optional<Point> corner_of(std::string_view text) {
    const auto comma = text.find(',');
    if (comma == std::string_view::npos) return std::nullopt;
    const auto x = percent_of(text.substr(0, comma)), y = percent_of(text.substr(comma + 1));
    return x && y ? std::optional(Point{*x, *y}) : std::nullopt;
}

Spot spot_of(std::string_view text, std::string_view place, std::string_view what) {
    // A box's hyphen comes after a percent sign; any other is a minus.
    const auto hyphen = text.find("%-");
    const auto middle = hyphen == std::string_view::npos ? hyphen : hyphen + 1;
    const auto first = corner_of(text.substr(0, middle));
    const auto second = middle == std::string_view::npos ? first : corner_of(text.substr(middle + 1));
    const std::string shown = "\"" + std::string(text.substr(0, 80)) + "\"";
    if (!first || !second)
        throw Error(Fault::usage, place,
                    phrase("{0} cannot be {1}; a box is two corners such as 20%,30%-70%,90%, a point 40%,50%, from the left and "
                           "from the top of the picture",
                           what, shown));
    for (const double value : {first->x, first->y, second->x, second->y})
        if (value < 0 || value > 100)
            throw Error(Fault::usage, place,
                        phrase("{0} cannot be {1}; the picture is from 0% to 100%, and this is outside of it", what, shown));
    const auto [left, right] = std::minmax(first->x, second->x);
    const auto [top, bottom] = std::minmax(first->y, second->y);
    const Spot spot{left / 100, top / 100, right / 100, bottom / 100};
    if (middle != std::string_view::npos && !spot.is_box())
        throw Error(Fault::usage, place,
                    phrase("{0} cannot be {1}; it is a box without size: give two opposite corners, or a point", what, shown));
    return spot;
}

std::string percent(double share) { return to_text(std::round(share * 1e8) / 1e6) + "%"; }

}  // namespace

std::vector<Spot> parse_spots(std::string_view text, std::string_view place, std::string_view what) {
    std::vector<Spot> spots;
    while (!text.empty()) {
        const auto end = std::min(text.find(';'), text.size());
        if (spots.size() == kMostSpots)
            throw Error(Fault::usage, place, phrase("{0} has over {1} places; name fewer", what, std::to_string(kMostSpots)));
        spots.push_back(spot_of(text.substr(0, end), place, what));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return spots;
}

std::string to_text(const Spot& spot) {
    const std::string first = percent(spot.left) + "," + percent(spot.top);
    return spot.is_box() ? first + "-" + percent(spot.right) + "," + percent(spot.bottom) : first;
}

std::string to_text(const std::vector<Spot>& spots) {
    std::string text;
    for (const Spot& spot : spots) text += (text.empty() ? "" : ";") + to_text(spot);
    return text;
}

}  // namespace tactics
