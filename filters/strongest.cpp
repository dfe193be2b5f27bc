// SPDX-License-Identifier: Apache-2.0
// The line budget. More lines than a hand can follow make a sheet harder to know, not easier: in a simulated matching by
// touch, 75 to 150 mm of line on a square of 63 mm (the paper's 2.5 in) were matched far more often than more. Of
// 160 mm looked for, 110 to 120 mm are drawn when short pieces and lines too close have gone; of 9 sheets simulated readers
// find 0.97, of 20 0.99; with 140 mm 0.99 and 0.99 (tactics evaluate --study matching), but less of the scene is there.
//
// It is met by a threshold, found for each picture, not by counting out strokes: where a stroke begins and ends hangs on a
// pixel here and there, and with a score of strokes a sheet each that changes places is a twentieth of it. Of the drawing of
// 20 photographs 0.02 to 0.05 more stay so under noise, JPEG or a turn (tactics evaluate --study stability).
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "filters/edge_map.h"
#include "filters/line_budget.h"
#include "tactics/filter.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr Option kStrongestOptions[] = {
    {.name = "line",
     .type = Option::Type::length,
     .fallback = 160,
     .min = 1,
     .max = 100'000,
     .unit = "mm",
     .summary = "length of line to keep on a square of 63 mm; on a larger drawing it grows as the side to the power 5/3"},
    {.name = "gap",
     .type = Option::Type::length,
     .fallback = 20,
     .min = 0,
     .max = 1000,
     .unit = "mm",
     .summary = "keep a weak part of a line between two strong ones if it is no longer than this, so that lines do not break "
                "into dashes"},
};

// A pixel of a thin line at an angle to the rows, a, is 1 / cos a long; the mean of cos a up to 45 degrees is 2 sqrt(2) / pi.
constexpr double kLengthOfPixel = std::numbers::pi / (2 * std::numbers::sqrt2);

// The pixels of thin lines and which touch which.
class Ridges {
public:
    explicit Ridges(const EdgeMap& edges) {
        std::vector<std::uint32_t> number(edges.strength.size(), kNone);
        for (std::size_t i = 0; i < edges.strength.size(); ++i)
            if (edges.strength[i] > 0) {
                number[i] = static_cast<std::uint32_t>(at_.size());
                at_.push_back(static_cast<std::uint32_t>(i));
                strength_.push_back(std::min(edges.strength[i], std::numeric_limits<float>::max()));
            }
        for (const std::uint32_t i : at_) {
            const int column = static_cast<int>(i) % edges.width, row = static_cast<int>(i) / edges.width;
            first_.push_back(static_cast<std::uint32_t>(touching_.size()));
            for (int y = std::max(row - 1, 0); y <= std::min(row + 1, edges.height - 1); ++y)
                for (int x = std::max(column - 1, 0); x <= std::min(column + 1, edges.width - 1); ++x) {
                    const std::uint32_t other =
                        number[static_cast<std::size_t>(y) * static_cast<std::size_t>(edges.width) + static_cast<std::size_t>(x)];
                    if (other != kNone && (x != column || y != row)) touching_.push_back(other);
                }
        }
        first_.push_back(static_cast<std::uint32_t>(touching_.size()));
    }

    std::size_t size() const { return at_.size(); }
    float strongest() const { return strength_.empty() ? 0 : *std::max_element(strength_.begin(), strength_.end()); }
    std::uint32_t pixel(std::size_t i) const { return at_[i]; }

    // Those as strong as `least`, and the gaps between them, up to `gap` pixels of the line.
    std::vector<bool> as_strong_as(float least, int gap) const {
        std::vector<bool> kept(size());
        std::vector<Way> ways(size());
        std::vector<std::uint32_t> front;
        for (std::uint32_t i = 0; i < size(); ++i) {
            if (strength_[i] < least) continue;
            kept[i] = true;
            ways[i] = {i, i, 0};
            front.push_back(i);
        }
        // From both sides of a gap at once, a step at a time: where two ways meet, they close it.
        std::vector<std::pair<std::uint32_t, std::uint32_t>> meetings;
        std::vector<std::uint32_t> next;
        for (int step = 1; 2 * step <= gap + 2 && !front.empty(); ++step) {
            next.clear();
            for (const std::uint32_t i : front)
                for (std::uint32_t k = first_[i]; k < first_[i + 1]; ++k) {
                    const std::uint32_t j = touching_[k];
                    if (ways[j].source == kNone) {
                        ways[j] = {ways[i].source, i, step};
                        next.push_back(j);
                    } else if (ways[i].steps + ways[j].steps > 0 && are_apart(ways[i].source, ways[j].source) &&
                               ways[i].steps + ways[j].steps <= gap) {
                        meetings.push_back({i, j});
                    }
                }
            std::swap(front, next);
        }
        for (const auto& [a, b] : meetings)
            for (std::uint32_t i : {a, b})
                for (; !kept[i]; i = ways[i].from) kept[i] = true;
        return kept;
    }

    // Connected pieces of those, longest first.
    std::vector<std::vector<std::uint32_t>> pieces(const std::vector<bool>& among) const {
        std::vector<std::vector<std::uint32_t>> all;
        std::vector<bool> seen(size());
        for (std::uint32_t i = 0; i < size(); ++i) {
            if (!among[i] || seen[i]) continue;
            std::vector<std::uint32_t> piece{i};
            seen[i] = true;
            for (std::size_t n = 0; n < piece.size(); ++n)
                for (std::uint32_t k = first_[piece[n]]; k < first_[piece[n] + 1]; ++k) {
                    const std::uint32_t j = touching_[k];
                    if (!among[j] || seen[j]) continue;
                    seen[j] = true;
                    piece.push_back(j);
                }
            all.push_back(std::move(piece));
        }
        std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
        return all;
    }

private:
    static constexpr std::uint32_t kNone = 0xffffffff;
    struct Way {
        std::uint32_t source = kNone, from = kNone;
        int steps = 0;
    };
    // Two pixels of one end are not two sides of a gap.
    bool are_apart(std::uint32_t a, std::uint32_t b) const {
        const auto begin = touching_.begin() + first_[a], end = touching_.begin() + first_[a + 1];
        return a != b && std::find(begin, end, b) == end;
    }

    std::vector<std::uint32_t> at_, first_, touching_;
    std::vector<float> strength_;
};

double budget_in_pixels(const EdgeMap& edges, double line) {
    const double mm = edges.mm_per_pixel;
    return line_budget(line, edges.width * mm, edges.height * mm) / (mm * kLengthOfPixel);
}

std::size_t count_of(const std::vector<bool>& kept) {
    return static_cast<std::size_t>(std::count(kept.begin(), kept.end(), true));
}

// What is drawn with one pen has one strength, and no threshold parts it: whole pieces then, the longest first. One of them
// must stay, however long it is, or nothing would.
void fill_up(std::vector<bool>& kept, const Ridges& ridges, const std::vector<bool>& too_many, double most) {
    double length = static_cast<double>(count_of(kept));
    for (const auto& piece : ridges.pieces(too_many)) {
        const auto fresh =
            static_cast<double>(std::count_if(piece.begin(), piece.end(), [&](std::uint32_t i) { return !kept[i]; }));
        if (length + fresh > most && length > 0.1 * most) continue;
        for (const std::uint32_t i : piece) kept[i] = true;
        length += fresh;
    }
}

// 0.98, of a length of 98 cm.
Phrase metres(double pixels, double mm) { return numeral(std::round(pixels * mm * kLengthOfPixel / 10) / 100); }

ChosenSetting settle_strongest(const Artwork& artwork, Settings& settings) {
    const auto& edges = std::get<EdgeMap>(artwork);
    if (!edges.thinned) return {};
    const auto found = static_cast<double>(
        std::count_if(edges.strength.begin(), edges.strength.end(), [](float strength) { return strength > 0; }));
    const double most = budget_in_pixels(edges, settings.number("line"));
    if (found <= most) return {};
    return {"line=" + to_text(settings.number("line")) + "mm",
            phrase("the strongest {0} m of {1} m of contours stay, as much as a hand follows on a drawing of this size",
                   metres(most, edges.mm_per_pixel), metres(found, edges.mm_per_pixel))};
}

Artwork apply_strongest(Artwork artwork, const Settings& settings) {
    auto& edges = std::get<EdgeMap>(artwork);
    if (!edges.thinned) edges = thin_edges(edges, std::nullopt);
    const Ridges ridges(edges);
    const double most = budget_in_pixels(edges, settings.number("line"));
    std::vector<bool> kept(ridges.size(), true);
    if (static_cast<double>(ridges.size()) > most) {
        const double gap_pixels = settings.number("gap") / (edges.mm_per_pixel * kLengthOfPixel);
        const int gap = static_cast<int>(std::min(gap_pixels, static_cast<double>(edges.strength.size())));
        float enough = ridges.strongest(), more = 0;
        kept.assign(ridges.size(), false);
        constexpr int kHalvings = 12;
        for (int i = 0; i < kHalvings; ++i) {
            const float middle = enough / 2 + more / 2;
            std::vector<bool> next = ridges.as_strong_as(middle, gap);
            if (static_cast<double>(count_of(next)) > most) {
                more = middle;
            } else {
                enough = middle;
                kept = std::move(next);
            }
        }
        constexpr double kFar = 0.7;  // of the budget; in photographs a threshold comes closer
        if (static_cast<double>(count_of(kept)) < kFar * most) fill_up(kept, ridges, ridges.as_strong_as(more, gap), most);
    }
    std::vector<float> strength(edges.strength.size(), 0.0f);
    for (std::size_t i = 0; i < kept.size(); ++i)
        if (kept[i]) strength[ridges.pixel(i)] = edges.strength[ridges.pixel(i)];
    edges.strength = std::move(strength);
    return artwork;
}

}  // namespace

extern const Filter strongest_filter;
const Filter strongest_filter{
    .name = "strongest",
    .summary = "keeps the strongest edges, up to a budget of line that a finger can follow",
    .takes = static_cast<Kinds>(Kind::edges),
    .gives = static_cast<Kinds>(Kind::edges),
    .options = kStrongestOptions,
    .apply = apply_strongest,
    .settle = settle_strongest,
    .budget = "line",
    .in_full = "-",
};

}  // namespace tactics
