// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/own_told.h"

#include <cmath>
#include <string>

#include "tactics/layout/own_marks.h"
#include "tactics/text/number.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

constexpr double kMostTold = 1e12;  // mm: what is drawn to scale may be larger than the earth
constexpr double kMostNumber = 1e6;
constexpr double kLargest = 5000;           // mm, of a page; as find_paper has it
constexpr std::size_t kMostWords = 20'000;  // more than there is room for

std::string line_told(const Element& element, std::string_view name) { return to_line(element.attribute(name)); }

bool take_rect(const Element& element, std::string_view name, Rect& rect) {
    const auto numbers = numbers_told(element, name, 4);
    if (!numbers || (*numbers)[2] < 0 || (*numbers)[3] < 0) return false;
    rect = {(*numbers)[0], (*numbers)[1], (*numbers)[2], (*numbers)[3]};
    return true;
}

bool take_cell(const Element& root, CellSize& cell) {
    const auto sizes = numbers_told(root, marks::kCell, 4);
    if (!sizes) return false;
    for (const double size : *sizes)
        if (!(size > 0.1 && size < 1000)) return false;
    cell = {(*sizes)[0], (*sizes)[1], (*sizes)[2], (*sizes)[3]};
    return cell.cell_pitch > cell.dot_pitch && cell.line_pitch > 2 * cell.dot_pitch;
}

bool take_bed(const Element& root, std::optional<DotBed>& bed) {
    if (root.attribute(marks::kBed).empty()) return true;
    const auto numbers = numbers_told(root, marks::kBed, 4);
    if (!numbers) return false;
    const double raster = (*numbers)[2], down = (*numbers)[3];
    if (raster < 0 || (raster > 0 && raster < 0.5) || (down != 3 && down != 4)) return false;
    bed = DotBed{{(*numbers)[0], (*numbers)[1]}, raster, static_cast<int>(down)};
    return true;
}

bool take_scale(const Element& root, std::optional<PageScale>& scale) {
    if (root.attribute(marks::kScale).empty()) return true;
    const auto numbers = numbers_told(root, marks::kScale, 6);
    // A bar of less than a millimetre cannot be felt, and is not what we wrote.
    if (!numbers || !((*numbers)[0] >= 1 && (*numbers)[0] <= kLargest) || !((*numbers)[1] >= 1e-6 && (*numbers)[1] <= 1e12) ||
        !((*numbers)[4] >= 0) || !((*numbers)[5] >= 0))
        return false;
    scale = PageScale{line_told(root, marks::kText),
                      (*numbers)[0],
                      (*numbers)[1],
                      {(*numbers)[2], (*numbers)[3], (*numbers)[4], (*numbers)[5]}};
    return true;
}

bool is_key(std::string_view letters) {
    return letters.size() == 2 && letters[0] >= 'a' && letters[0] <= 'z' && letters[1] >= 'a' && letters[1] <= 'z';
}

PageWords words_of(const Element& element) {
    PageWords words{words_named(element.attribute(marks::kKind)).value_or(WordsKind::label), line_told(element, marks::kText)};
    if (is_key(element.attribute(marks::kKey))) words.key = element.attribute(marks::kKey);
    if (const auto anchor = numbers_told(element, marks::kAnchor, 4)) {
        words.at = {(*anchor)[0], (*anchor)[1]};
        words.across = (*anchor)[2];
        words.down = (*anchor)[3];
    }
    if (const auto within = numbers_told(element, marks::kWithin, 1)) words.within = within->front();
    words.optional = element.attribute(marks::kOptional) == "1";
    return words;
}

std::optional<PageName> name_of(const Element& element, std::size_t words) {
    const auto at = numbers_told(element, marks::kAt, 6);
    if (!at) return std::nullopt;
    PageName name{line_told(element, marks::kText), "", {(*at)[0], (*at)[1]}, {(*at)[2], (*at)[3], (*at)[4], (*at)[5]}};
    if (is_key(element.attribute(marks::kKey))) name.key = element.attribute(marks::kKey);
    if (const auto number = number_told(element, marks::kWords); number && *number < words)
        name.words = static_cast<int>(*number);
    return name;
}

Region undrawn_of(const Element& element) {
    Region region;
    region.name = line_told(element, marks::kText);
    region.path = line_told(element, marks::kPath);
    region.description = line_told(element, marks::kDescription);
    region.counts = counts_told(element.attribute(marks::kCounts));
    return region;
}

void take_one(const Element& element, RestTold& rest) {
    if (const auto number = number_told(element, marks::kRegion)) {
        if (!element.attribute(marks::kText).empty()) rest.undrawn.emplace_back(*number, undrawn_of(element));
    } else if (const std::string remark = line_told(element, marks::kRemark); !remark.empty()) {
        rest.remarks.push_back(remark);
    } else if (number_told(element, marks::kLeftOut)) {
        const auto at = point_told(element, marks::kAt);
        const auto within = numbers_told(element, marks::kWithin, 1);
        if (at)
            rest.left_out.push_back({*at, line_told(element, marks::kText), line_told(element, marks::kOrigin),
                                     within ? within->front() : 0, element.attribute(marks::kOptional) == "1"});
    }
}

const Element* told_group(const Element& root) {
    for (const Element& child : root.children)
        if (child.attribute("id") == "told") return &child;
    return nullptr;
}

}  // namespace

std::optional<std::vector<double>> numbers_told(const Element& element, std::string_view name, std::size_t count) {
    std::string_view rest = element.attribute(name);
    std::vector<double> numbers;
    while (!rest.empty() && numbers.size() <= count) {
        const auto end = rest.find(' ');
        const auto number = parse_number(rest.substr(0, end));
        if (!number || !(std::abs(*number) <= kMostTold)) return std::nullopt;
        numbers.push_back(*number);
        rest.remove_prefix(end == rest.npos ? rest.size() : end + 1);
    }
    if (numbers.size() != count) return std::nullopt;
    return numbers;
}

std::optional<Point> point_told(const Element& element, std::string_view name) {
    const auto numbers = numbers_told(element, name, 2);
    if (!numbers) return std::nullopt;
    return Point{(*numbers)[0], (*numbers)[1]};
}

std::optional<std::size_t> number_told(const Element& element, std::string_view name) {
    const auto number = numbers_told(element, name, 1);
    if (!number || number->front() < 0 || number->front() > kMostNumber || number->front() != std::floor(number->front()))
        return std::nullopt;
    return static_cast<std::size_t>(number->front());
}

std::optional<Page> page_told(const Element& root) {
    if (root.name != "svg" || root.attribute(marks::kVersion) != marks::kThisVersion) return std::nullopt;
    const auto size = numbers_told(root, marks::kSize, 2), dot = numbers_told(root, marks::kDot, 1);
    Page page;
    if (!size || !dot || !take_rect(root, marks::kLive, page.live) || !take_cell(root, page.cell) || !take_bed(root, page.bed) ||
        !take_scale(root, page.scale))
        return std::nullopt;
    page.width = (*size)[0];
    page.height = (*size)[1];
    page.braille_dot = dot->front();
    const bool sized = page.width > 0 && page.width <= kLargest && page.height > 0 && page.height <= kLargest;
    const bool lives = page.live.width > 0 && page.live.height > 0 && page.live.left >= 0 && page.live.top >= 0 &&
                       page.live.left + page.live.width <= page.width + 1 && page.live.top + page.live.height <= page.height + 1;
    if (!sized || !lives || !(page.braille_dot >= 0 && page.braille_dot < 100)) return std::nullopt;
    if (!root.attribute(marks::kDrawing).empty()) {
        if (!take_rect(root, marks::kDrawing, page.drawing)) return std::nullopt;
        const Rect& drawing = page.drawing;
        const auto fits = [](double side) { return side >= 1 && side <= kLargest; };
        if (!fits(drawing.width) || !fits(drawing.height) || std::abs(drawing.left) > kLargest ||
            std::abs(drawing.top) > kLargest)
            return std::nullopt;
    }
    page.medium = line_told(root, marks::kMedium);
    page.braille_table = line_told(root, marks::kTable);
    page.language = line_told(root, marks::kLanguage);
    page.title = line_told(root, marks::kTitle);
    page.caption = line_told(root, marks::kCaption);
    page.description = line_told(root, marks::kDescription);
    page.is_key = root.attribute(marks::kIsKey) == "1";
    return page;
}

RestTold rest_told(const Element& root) {
    RestTold rest;
    const Element* group = told_group(root);
    if (group == nullptr) return rest;
    for (const Element& element : group->children)
        if (number_told(element, marks::kWords) == rest.words.size() && element.attribute(marks::kName).empty() &&
            rest.words.size() < kMostWords)
            rest.words.push_back(words_of(element));
    for (const Element& element : group->children) {
        if (!number_told(element, marks::kName)) {
            take_one(element, rest);
        } else if (auto name = name_of(element, rest.words.size()); name && rest.names.size() < kMostWords) {
            rest.names.push_back(std::move(*name));
        }
    }
    return rest;
}

std::vector<std::pair<std::string, int>> counts_told(std::string_view text) {
    std::vector<std::pair<std::string, int>> counts;
    while (!text.empty()) {
        const auto end = text.find(' ');
        const std::string_view one = text.substr(0, end);
        text.remove_prefix(end == text.npos ? text.size() : end + 1);
        const auto equals = one.rfind('=');
        if (equals == one.npos || equals == 0) continue;
        const auto number = parse_number(one.substr(equals + 1));
        if (number && std::abs(*number) <= kMostNumber && *number == std::floor(*number))
            counts.emplace_back(one.substr(0, equals), static_cast<int>(*number));
    }
    return counts;
}

}  // namespace tactics
