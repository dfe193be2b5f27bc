// SPDX-License-Identifier: Apache-2.0
#include "tactics/layout/felt_bars.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <utility>

#include "tactics/layout/texture.h"
#include "tactics/layout/texture_choice.h"

namespace tactics {

namespace {

// mm on the page. The gap is that between any two lines (rules/gap.cpp), with their width. A texture needs 6.4 mm with the gap to
// the outline on both sides, and some have two lines only on what is 14 mm wide.
constexpr double kLineGap = 3.4, kHoldsTexture = 14, kRungs = 4.6;

// A bar as if it stood on y = 0 and grew with y.
struct Upright {
    double left = 0, right = 0, foot = 0, top = 0;
    std::size_t look = 0;
};

std::vector<Upright> standing_up(const ChartBars& found) {
    std::vector<Upright> bars;
    for (const auto& [b, look] : found.bars) {
        if (found.lying)
            bars.push_back({b.top, b.bottom, b.left - found.base, b.right - found.base, look});
        else
            bars.push_back({b.left, b.right, found.base - b.bottom, found.base - b.top, look});
    }
    return bars;
}

double thinnest(const std::vector<Upright>& bars) {
    double least = 1e9;
    for (const Upright& bar : bars) least = std::min(least, bar.right - bar.left);
    return least;
}

// The sides of two that are closer than a finger can tell are one, also where one was seen a bit too wide.
void join_sides(std::vector<Upright>& bars) {
    const double closest = std::min(kLineGap, thinnest(bars) / 2);
    std::map<double, double> moved;
    for (const Upright& a : bars)
        for (const Upright& b : bars) {
            const double between = b.left - a.right;
            if (b.left > a.left && b.right > a.right && between != 0 && (between > 0 ? between < kLineGap : -between < closest))
                moved[a.right] = moved[b.left] = (a.right + b.left) / 2;
        }
    for (Upright& bar : bars) {
        if (const auto at = moved.find(bar.left); at != moved.end()) bar.left = at->second;
        if (const auto at = moved.find(bar.right); at != moved.end()) bar.right = at->second;
    }
}

// Bars that touch.
struct BarGroup {
    double left = 0, right = 0;
    double middle() const { return (left + right) / 2; }
};

std::vector<BarGroup> groups_of(std::vector<Upright> bars) {
    std::sort(bars.begin(), bars.end(), [](const Upright& a, const Upright& b) { return a.left < b.left; });
    std::vector<BarGroup> groups;
    for (const Upright& bar : bars) {
        if (groups.empty() || bar.left > groups.back().right + 0.01) groups.push_back({bar.left, bar.right});
        groups.back().right = std::max(groups.back().right, bar.right);
    }
    return groups;
}

// Where bars are too thin to be felt they take what is free between their groups: how wide they are says nothing.
void widen(std::vector<Upright>& bars) {
    constexpr double kWide = 5;  // mm
    if (thinnest(bars) >= kWide) return;
    const std::vector<BarGroup> groups = groups_of(bars);
    double room = 1e9, widest = 0;
    for (std::size_t i = 0; i < groups.size(); ++i) {
        widest = std::max(widest, groups[i].right - groups[i].left);
        if (i > 0) room = std::min(room, groups[i].middle() - groups[i - 1].middle() - kRungs);
    }
    const double times = std::min(kWide / thinnest(bars), room / widest);
    if (groups.size() < 2 || times <= 1) return;
    for (Upright& bar : bars) {
        const auto own =
            std::find_if(groups.begin(), groups.end(), [&](const BarGroup& group) { return bar.left < group.right; });
        bar.left = own->middle() + (bar.left - own->middle()) * times;
        bar.right = own->middle() + (bar.right - own->middle()) * times;
    }
}

// Stretches along straight lines, by where these are.
class RuledLines {
public:
    void add(double at, double from, double to) { lines_[std::lround(at * 1000)].emplace_back(from, to); }

    // Each without what another one draws already: (where, from, to).
    std::vector<std::array<double, 3>> joined() {
        std::vector<std::array<double, 3>> all;
        for (auto& [at, stretches] : lines_) {
            std::sort(stretches.begin(), stretches.end());
            std::vector<std::pair<double, double>> one;
            for (const auto& [from, to] : stretches) {
                if (!one.empty() && from <= one.back().second + 0.01)
                    one.back().second = std::max(one.back().second, to);
                else
                    one.emplace_back(from, to);
            }
            for (const auto& [from, to] : one) all.push_back({static_cast<double>(at) / 1000, from, to});
        }
        return all;
    }

private:
    std::map<long, std::vector<std::pair<double, double>>> lines_;
};

// Darker kinds get what has more ink.
std::vector<std::size_t> by_darkness(const std::vector<BarPaint>& looks) {
    std::vector<std::size_t> order(looks.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return looks[a].dark < looks[b].dark; });
    return order;
}

// Of the upright bars, back on the page.
class Placed {
public:
    explicit Placed(const ChartBars& found) : lying_(found.lying), base_(found.base) {}

    Point at(double across, double up) const { return lying_ ? Point{base_ + up, across} : Point{across, base_ - up}; }
    Stroke line(Point from, Point to) const { return {{at(from.x, from.y), at(to.x, to.y)}, false}; }
    Area area(const Upright& bar, int texture) const {
        Area area;
        area.rings.push_back({at(bar.left, bar.foot), at(bar.right, bar.foot), at(bar.right, bar.top), at(bar.left, bar.top)});
        area.texture = texture;
        return area;
    }

private:
    bool lying_;
    double base_;
};

// Lower than two lines apart: it is felt as a wider piece of what it stands on.
bool is_low(const Upright& bar) { return std::abs(bar.top - bar.foot) < kLineGap; }

void add_outlines(const std::vector<Upright>& bars, bool on_axis, const Placed& placed, FeltBars& felt) {
    RuledLines sides, ends;
    for (const Upright& bar : bars) {
        const auto [low, high] = std::minmax(bar.foot, bar.top);
        if (is_low(bar)) {
            felt.areas.push_back(placed.area(bar, 0));
            continue;
        }
        sides.add(bar.left, low, high);
        sides.add(bar.right, low, high);
        for (const double end : {low, high})
            if (!on_axis || std::abs(end) > kLineGap / 2) ends.add(end, bar.left, bar.right);
    }
    for (const auto& [at, from, to] : sides.joined()) felt.strokes.push_back(placed.line({at, from}, {at, to}));
    for (const auto& [at, from, to] : ends.joined()) felt.strokes.push_back(placed.line({from, at}, {to, at}));
}

void add_textures(const std::vector<Upright>& bars, const std::vector<BarPaint>& looks, const Placed& placed, FeltBars& felt) {
    std::vector<double> grey{255};  // the ground is blank, and beside all of them; so is what looks like it
    std::vector<std::size_t> number(looks.size(), 0);
    for (std::size_t i = 0; i < looks.size(); ++i) {
        if (looks[i].blank) continue;
        number[i] = grey.size();
        grey.push_back(255 * (1 - looks[i].dark));
    }
    if (grey.size() - 1 > textures().size()) return;
    std::vector<std::vector<double>> beside(grey.size(), std::vector<double>(grey.size(), 1));
    for (std::size_t i = 0; i < grey.size(); ++i) beside[i][0] = beside[0][i] = 100;
    const std::vector<int> chosen = choose_textures(beside, grey);
    for (const Upright& bar : bars)
        if (const int texture = chosen[number[bar.look]]; texture > 0 && !is_low(bar))
            felt.areas.push_back(placed.area(bar, texture));
}

void add_rungs(const Upright& bar, double pitch, const Placed& placed, FeltBars& felt) {
    const double way = bar.top > bar.foot ? 1 : -1, length = std::abs(bar.top - bar.foot);
    for (double along = pitch; along <= length - kLineGap; along += pitch)
        felt.strokes.push_back(placed.line({bar.left, bar.foot + way * along}, {bar.right, bar.foot + way * along}));
}

enum class BarFilling { blank, few_rungs, middle, rungs, black };

// So many that are told apart in bars of that width, the palest first; none if there are not so many. Much black swells unevenly.
std::vector<BarFilling> narrow_fillings(std::size_t count, double width) {
    using enum BarFilling;
    const bool holds_middle = width >= 2 * kRungs;
    if (count == 2) return {blank, rungs};
    if (count == 3) return holds_middle ? std::vector{blank, middle, rungs} : std::vector{blank, rungs, black};
    if (count == 4)
        return holds_middle ? std::vector{blank, few_rungs, middle, rungs} : std::vector{blank, few_rungs, rungs, black};
    if (count == 5 && holds_middle) return {blank, few_rungs, middle, rungs, black};
    return {};
}

void add_narrow_fillings(const std::vector<Upright>& bars, const std::vector<BarPaint>& looks, const Placed& placed,
                         FeltBars& felt) {
    constexpr double kFew = 2.5;  // as far apart
    const std::vector<BarFilling> all = narrow_fillings(looks.size(), thinnest(bars));
    if (all.empty()) return;
    const std::vector<std::size_t> order = by_darkness(looks);
    std::vector<BarFilling> filling(looks.size());
    for (std::size_t i = 0; i < order.size(); ++i) filling[order[i]] = all[i];
    for (const Upright& bar : bars) {
        if (is_low(bar)) continue;
        const BarFilling own = filling[bar.look];
        if (own == BarFilling::rungs || own == BarFilling::few_rungs)
            add_rungs(bar, own == BarFilling::rungs ? kRungs : kFew * kRungs, placed, felt);
        if (own == BarFilling::black) felt.areas.push_back(placed.area(bar, 0));
        if (const double middle = (bar.left + bar.right) / 2; own == BarFilling::middle)
            felt.strokes.push_back(placed.line({middle, bar.foot}, {middle, bar.top}));
    }
}

}  // namespace

FeltBars felt_bars(const ChartBars& found) {
    std::vector<Upright> bars = standing_up(found);
    if (bars.empty()) return {};
    join_sides(bars);
    widen(bars);
    if (thinnest(bars) < kLineGap) return {};
    FeltBars felt;
    const Placed placed(found);
    add_outlines(bars, found.on_axis, placed, felt);
    if (felt.strokes.empty()) return {};  // all are too low
    const bool tells = found.looks.size() > 1;
    if (thinnest(bars) >= kHoldsTexture) {
        if (tells || found.looks[0].hatched) add_textures(bars, found.looks, placed, felt);
    } else if (tells) {
        add_narrow_fillings(bars, found.looks, placed, felt);
    }
    return felt;
}

}  // namespace tactics
