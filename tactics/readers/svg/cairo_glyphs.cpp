// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/cairo_glyphs.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace tactics {

namespace {

constexpr double kSlack = 0.5;  // points that a letter may begin outside of its word's box; never behind it
constexpr std::string_view kEnd = "/>";

// Reads a number where the text begins, and takes it off.
std::optional<double> take_number(std::string_view& text) {
    while (text.starts_with(' ')) text.remove_prefix(1);
    double number = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (fault != std::errc() || !std::isfinite(number)) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return number;
}

std::optional<double> number_behind(std::string_view element, std::string_view name) {
    const auto at = element.find(name);
    if (at == std::string_view::npos) return std::nullopt;
    std::string_view value = element.substr(at + name.size());
    return take_number(value);
}

// "M 21.16 295.46 L 27.41 295.46 L 27.41 296.29 L 21.16 296.29 Z M 21.16 295.46 ": upright, its sides in any order.
std::optional<Rect> rectangle_in(std::string_view path) {
    std::array<Point, 4> corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (!path.starts_with(i == 0 ? "M " : " L ")) return std::nullopt;
        path.remove_prefix(i == 0 ? 2 : 3);
        const auto x = take_number(path), y = take_number(path);
        if (!x || !y) return std::nullopt;
        corners[i] = {*x, *y};
    }
    if (!path.starts_with(" Z")) return std::nullopt;
    const auto [left, right] = std::minmax({corners[0].x, corners[2].x});
    const auto [top, bottom] = std::minmax({corners[0].y, corners[2].y});
    for (const Point& corner : corners)
        if ((corner.x != left && corner.x != right) || (corner.y != top && corner.y != bottom)) return std::nullopt;
    return Rect{left, top, right - left, bottom - top};
}

// From letter to letter neither across nor down, by more than eight degrees, and no further than letters stand apart.
bool is_slanted(double dx, double dy) {
    constexpr double kTangent = 0.14, kFar = 40;  // points
    const double across = std::abs(dx), down = std::abs(dy);
    return std::hypot(dx, dy) < kFar && across > kTangent * down && down > kTangent * across;
}

}  // namespace

CairoGlyphs::CairoGlyphs(std::string_view svg) : svg_(svg) {
    find_letters();
    find_bars();
    for (std::vector<Piece>* pieces : {&letters_, &bars_})
        std::stable_sort(pieces->begin(), pieces->end(), [](const Piece& a, const Piece& b) { return a.box.top < b.box.top; });
}

// <use xlink:href="#glyph0-1" x="150" y="30"/>; those of one font that follow each other are a line.
void CairoGlyphs::find_letters() {
    constexpr std::string_view kUse = "<use xlink:href=\"#glyph";
    constexpr std::size_t kBetween = 4;  // a line end and blanks
    std::string_view font;
    std::size_t first = 0;
    const auto end_line = [&] {
        std::size_t slanted = 0;
        for (std::size_t i = first + 1; i < letters_.size(); ++i)
            slanted += is_slanted(letters_[i].box.left - letters_[i - 1].box.left, letters_[i].box.top - letters_[i - 1].box.top);
        const bool most = 2 * slanted > letters_.size() - std::min(first + 1, letters_.size()) && slanted > 0;
        for (std::size_t i = first; i < letters_.size(); ++i) letters_[i].slanted = most;
        first = letters_.size();
    };
    for (auto at = svg_.find(kUse); at != std::string_view::npos; at = svg_.find(kUse, at + 1)) {
        const auto end = svg_.find(kEnd, at);
        if (end == std::string_view::npos) break;
        const std::string_view element = svg_.substr(at, end - at);
        const auto x = number_behind(element, " x=\""), y = number_behind(element, " y=\"");
        if (!x || !y) continue;
        const std::string_view number = element.substr(kUse.size());
        const std::string_view own = number.substr(0, number.find('-', 1));
        if (own != font || letters_.empty() || at > letters_.back().end + kBetween) end_line();
        font = own;
        letters_.push_back({at, end + kEnd.size(), {*x, *y, 0, 0}});
    }
    end_line();
}

void CairoGlyphs::find_bars() {
    constexpr std::string_view kPath = "<path style=\" stroke:none;", kData = " d=\"";
    for (auto at = svg_.find(kPath); at != std::string_view::npos; at = svg_.find(kPath, at + 1)) {
        const auto end = svg_.find(kEnd, at);
        if (end == std::string_view::npos) break;
        const std::string_view element = svg_.substr(at, end - at);
        const auto data = element.find(kData);
        if (data == std::string_view::npos || element.find(" transform=") != std::string_view::npos) continue;
        if (const auto box = rectangle_in(element.substr(data + kData.size()))) bars_.push_back({at, end + kEnd.size(), *box});
    }
}

template <typename Use>
void CairoGlyphs::each_in(const Rect& word, const Use& use) const {
    auto at = std::lower_bound(letters_.begin(), letters_.end(), word.top - kSlack,
                               [](const Piece& piece, double top) { return piece.box.top < top; });
    for (; at != letters_.end() && at->box.top <= word.top + word.height + kSlack; ++at)
        if (at->box.left >= word.left - kSlack && at->box.left <= word.left + word.width)
            use(static_cast<std::size_t>(at - letters_.begin()));
}

std::optional<double> CairoGlyphs::take(const Rect& word) {
    std::vector<double> lines;
    each_in(word, [&](std::size_t i) {
        if (letters_[i].taken || letters_[i].slanted) return;
        letters_[i].taken = true;
        lines.push_back(letters_[i].box.top);
    });
    return lines.empty() ? std::nullopt : std::optional(lines[lines.size() / 2]);
}

bool CairoGlyphs::are_slanted(const Rect& word) const {
    bool slanted = false;
    each_in(word, [&](std::size_t i) { slanted = slanted || letters_[i].slanted; });
    return slanted;
}

bool CairoGlyphs::take_minus(const Rect& number, double size, std::optional<double> base) {
    // Shares of the size: how long and thick a minus is, how far before its number, and how high over the line it stands on.
    constexpr double kShort = 0.3, kLong = 0.9, kThick = 0.16, kGap = 0.45, kLow = 0.1, kHigh = 0.6;
    const double line = base.value_or(number.top + 0.8 * number.height);
    auto at = std::lower_bound(bars_.begin(), bars_.end(), line - kHigh * size,
                               [](const Piece& piece, double top) { return piece.box.top < top; });
    for (; at != bars_.end() && at->box.top <= line - kLow * size; ++at) {
        const double gap = number.left - (at->box.left + at->box.width);
        if (at->taken || at->box.width < kShort * size || at->box.width > kLong * size || at->box.height > kThick * size ||
            gap < -kSlack || gap > kGap * size)
            continue;
        at->taken = true;
        return true;
    }
    return false;
}

std::string CairoGlyphs::without_taken(std::string_view more) const {
    std::vector<const Piece*> taken;
    for (const std::vector<Piece>* pieces : {&letters_, &bars_})
        for (const Piece& piece : *pieces)
            if (piece.taken) taken.push_back(&piece);
    std::sort(taken.begin(), taken.end(), [](const Piece* a, const Piece* b) { return a->begin < b->begin; });
    std::string out;
    std::size_t copied = 0;
    for (const Piece* piece : taken) {
        out += svg_.substr(copied, piece->begin - copied);
        copied = piece->end;
    }
    const auto end = std::max(copied, std::min(svg_.rfind("</svg>"), svg_.size()));
    out += svg_.substr(copied, end - copied);
    return out + std::string(more) + std::string(svg_.substr(end));
}

std::size_t drawn_in(std::string_view svg) {
    // Outlines of letters and clips have no colour.
    constexpr std::string_view kPath = "<path ", kFill = "fill:rgb(", kLine = "stroke:rgb(", kWhite = "100%,100%,100%)";
    std::size_t drawn = 0;
    for (auto at = svg.find(kPath); at != std::string_view::npos; at = svg.find(kPath, at + 1)) {
        const std::string_view element = svg.substr(at, std::min(svg.find(kEnd, at), svg.size()) - at);
        const auto paints = [&](std::string_view how) {
            const auto colour = element.find(how);
            return colour != std::string_view::npos && !element.substr(colour + how.size()).starts_with(kWhite);
        };
        drawn += paints(kFill) || paints(kLine);
    }
    return drawn;
}

}  // namespace tactics
