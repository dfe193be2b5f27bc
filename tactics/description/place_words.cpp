// SPDX-License-Identifier: Apache-2.0
#include "tactics/description/place_words.h"

#include <algorithm>

namespace tactics {

namespace {

std::size_t third(double at, double length) {
    return length > 0 ? static_cast<std::size_t>(std::clamp(at / length * 3, 0.0, 2.0)) : 1;
}

}  // namespace

std::size_t Ninths::of(Point p) const {
    return third(p.y - frame_.top, frame_.height) * 3 + third(p.x - frame_.left, frame_.width);
}

std::string Ninths::place(const Rect& box) const {
    constexpr double kAcross = 0.55;  // more than one third and half of another
    const bool wide = frame_.width > 0 && box.width >= kAcross * frame_.width,
               high = frame_.height > 0 && box.height >= kAcross * frame_.height;
    const std::size_t cell = of(box), row = cell / 3, column = cell % 3;
    if (wide && high) return "over most of the " + name_;
    if (wide) return row == 1 ? "across the middle" : row == 0 ? "across the upper part" : "across the lower part";
    if (high) return column == 1 ? "down the middle" : column == 0 ? "down the left side" : "down the right side";
    return "in the " + std::string(kNinths[cell]);
}

std::string Ninths::course(Point a, Point b) const {
    std::size_t from = of(a), to = of(b);
    if (from % 3 == to % 3 ? from > to : from % 3 > to % 3) std::swap(from, to);
    return "from the " + std::string(kNinths[from]) + " to the " + kNinths[to];
}

std::string counted(std::size_t count, const std::string& thing) {
    return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

std::string listed(const std::vector<std::string>& parts) {
    std::string text;
    for (std::size_t i = 0; i < parts.size(); ++i) text += (i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ") + parts[i];
    return text;
}

}  // namespace tactics
