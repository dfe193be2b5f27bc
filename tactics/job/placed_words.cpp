// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/placed_words.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "tactics/error.h"
#include "tactics/text/words.h"
#include "tactics/units.h"

namespace tactics {

namespace {

struct Coordinate {
    double value = 0;
    bool share = false;
};

std::optional<Coordinate> coordinate_of(std::string_view text) {
    if (text.ends_with('%')) {
        const auto number = parse_number(text.substr(0, text.size() - 1));
        if (!number || *number < 0 || *number > 100) return std::nullopt;
        return Coordinate{*number / 100, true};
    }
    const auto length = parse_length(text);
    if (!length || *length < 0) return std::nullopt;
    return Coordinate{*length, false};
}

}  // namespace

PlacedWords label_of(std::string_view place, std::string_view words, const std::string& origin) {
    const auto comma = place.find(',');
    const auto x = coordinate_of(place.substr(0, comma));
    const auto y = comma == std::string_view::npos ? std::nullopt : coordinate_of(place.substr(comma + 1));
    if (!x || !y || x->share != y->share)
        throw Error(
            Fault::usage, origin,
            phrase(
                "\"{0}\" is no place; write how far from the left and from the top of the drawing, such as 30%,40% or 12mm,50mm",
                place.substr(0, 80)));
    if (words.empty()) throw Error(Fault::usage, origin, phrase("the words are missing after the place"));
    return {x->value, y->value, x->share, std::string(words), origin};
}

std::vector<PlacedWords> parse_labels(std::string_view text, const std::string& file) {
    std::vector<PlacedWords> labels;
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // what some editors put before UTF-8
    for (std::size_t number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = trimmed(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        if (line.empty() || line.front() == '#') continue;
        if (is_subject_line(line)) continue;
        const std::string origin = file + ":" + std::to_string(number);
        if (labels.size() == kMostLabels)
            throw Error(Fault::usage, origin, phrase("these are over 1000 labels, more than a page has room for"));
        const std::size_t blank = std::min(line.find_first_of(kBlanks), line.size());
        labels.push_back(label_of(line.substr(0, blank), trimmed(line.substr(blank)), origin));
    }
    return labels;
}

SubjectWish parse_subject(std::string_view text, const std::string& file, SubjectWish wish) {
    for (std::size_t number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = trimmed(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        if (is_subject_line(line)) add_subject_line(wish, line, file + ":" + std::to_string(number));
    }
    return wish;
}

std::vector<Name> names_on(const Drawing& drawing, const std::vector<PlacedWords>& labels, const Rect& part) {
    std::vector<Name> names;
    for (const PlacedWords& label : labels) {
        const Point at = label.share ? Point{(label.x - part.left) / part.width * drawing.width,
                                             (label.y - part.top) / part.height * drawing.height}
                                     : Point{label.x, label.y};
        names.push_back({at, label.text, label.origin});
    }
    return names;
}

bool any_outside(const std::vector<PlacedWords>& labels, const Rect& part) {
    return std::any_of(labels.begin(), labels.end(), [&](const PlacedWords& label) {
        return label.share && (label.x < part.left || label.x > part.left + part.width || label.y < part.top ||
                               label.y > part.top + part.height);
    });
}

void check_places(const std::vector<PlacedWords>& labels, double width, double height) {
    for (const PlacedWords& label : labels)
        if (!label.share && (label.x > width || label.y > height))
            throw Error(Fault::usage, label.origin,
                        phrase("it is outside of the drawing, which is {0} mm wide and {1} mm high",
                               to_text(std::floor(width * 10) / 10), to_text(std::floor(height * 10) / 10)));
}

}  // namespace tactics
