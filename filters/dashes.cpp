// SPDX-License-Identifier: Apache-2.0
// Dashed and dotted lines of black and white pictures, made whole: rows of small thin pieces of ink with gaps that are alike.
// Traced as they are, each dash would be a line of its own, too short to be felt, and go.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "filters/components.h"
#include "filters/opencv.h"
#include "tactics/filter.h"

namespace tactics {

namespace {

constexpr Option kOptions[] = {
    {.name = "longest",
     .type = Option::Type::length,
     .fallback = 8,
     .min = 0,
     .max = 50,
     .unit = "mm",
     .summary = "longer pieces of ink are no dashes; under 1 pixel it has no effect"},
    {.name = "widest",
     .type = Option::Type::length,
     .fallback = 1.2,
     .min = 0.1,
     .max = 20,
     .unit = "mm",
     .summary = "wider pieces of ink are no dashes: letters are wider than lines"},
};

constexpr std::size_t kLeastDashes = 4;    // dashes of a line; three in a row are dots after a word
constexpr double kMostGap = 2.5;           // mm on the page; gaps made for the eye are smaller
constexpr double kOnCourse = 0.86;         // cosine of what a line may turn from dash to dash: 30 degrees
constexpr std::size_t kMostDashes = 4000;  // of a picture; more is a pattern or noise

struct Dash {
    Point ends[2];  // pixels, of its middle line
    double width = 0;
    Point middle() const { return {(ends[0].x + ends[1].x) / 2, (ends[0].y + ends[1].y) / 2}; }
    double length() const { return distance(ends[0], ends[1]); }
};

// Along its main axis (of the second moments), if it is thin across it.
std::optional<Dash> dash_of(const std::vector<const Run*>& runs, double longest, double widest) {
    double n = 0, sx = 0, sy = 0, sxx = 0, syy = 0, sxy = 0;
    for (const Run* run : runs)
        for (int x = run->begin; x < run->end; ++x) {
            const double px = x + 0.5, py = run->row + 0.5;
            ++n;
            sx += px;
            sy += py;
            sxx += px * px;
            syy += py * py;
            sxy += px * py;
        }
    const double mx = sx / n, my = sy / n, cxx = sxx / n - mx * mx + 1.0 / 12, cyy = syy / n - my * my + 1.0 / 12,
                 cxy = sxy / n - mx * my;
    const double mean = (cxx + cyy) / 2, off = std::hypot((cxx - cyy) / 2, cxy);
    // A bar of length l has a variance of l^2 / 12.
    const double length = std::sqrt(12 * (mean + off)), width = std::sqrt(12 * std::max(0.0, mean - off));
    if (length > longest || width > widest) return std::nullopt;
    const double angle = std::atan2(2 * cxy, cxx - cyy) / 2, half = std::max(0.0, length - width) / 2;
    const Point along{half * std::cos(angle), half * std::sin(angle)};
    return Dash{{{mx - along.x, my - along.y}, {mx + along.x, my + along.y}}, width};
}

struct Link {
    std::size_t a, b;  // ends: 2 * dash + which
    double gap;
};

class Rows {
public:
    Rows(std::vector<Dash> dashes, double reach) : dashes_(std::move(dashes)), links_(2 * dashes_.size(), kNone) {
        std::vector<Link> all;
        for (std::size_t i = 0; i < dashes_.size(); ++i)
            for (std::size_t j = i + 1; j < dashes_.size(); ++j) {
                if (distance(dashes_[i].middle(), dashes_[j].middle()) > reach + (dashes_[i].length() + dashes_[j].length()) / 2)
                    continue;
                for (std::size_t e = 0; e < 2; ++e)
                    for (std::size_t f = 0; f < 2; ++f) {
                        const double gap = distance(dashes_[i].ends[e], dashes_[j].ends[f]);
                        if (gap <= reach && go_on(i, e, j, f)) all.push_back({2 * i + e, 2 * j + f, gap});
                    }
            }
        std::stable_sort(all.begin(), all.end(), [](const Link& a, const Link& b) { return a.gap < b.gap; });
        for (const Link& link : all)
            if (links_[link.a] == kNone && links_[link.b] == kNone && links_[link.a ^ 1] != link.b && keeps_course(link)) {
                links_[link.a] = link.b;
                links_[link.b] = link.a;
            }
    }

    // From dash to dash of rows that are long enough, the two ends of each gap.
    template <typename Join>
    void join(Join visit) const {
        std::vector<bool> seen(dashes_.size());
        for (std::size_t i = 0; i < dashes_.size(); ++i) {
            if (seen[i]) continue;
            std::vector<std::pair<std::size_t, std::size_t>> gaps;
            std::size_t count = 1;
            seen[i] = true;
            for (const std::size_t way : {2 * i, 2 * i + 1})
                for (std::size_t end = way; links_[end] != kNone && !seen[links_[end] / 2]; end = links_[end] ^ 1) {
                    gaps.emplace_back(end, links_[end]);
                    seen[links_[end] / 2] = true;
                    ++count;
                }
            if (count < kLeastDashes) continue;
            for (const auto& [a, b] : gaps) visit(dashes_[a / 2].ends[a & 1], dashes_[b / 2].ends[b & 1]);
        }
    }

private:
    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

    static double cosine(Point a, Point b) {
        const double size = std::hypot(a.x, a.y) * std::hypot(b.x, b.y);
        return size > 0 ? (a.x * b.x + a.y * b.y) / size : 1;
    }

    // A dash has a direction if it is clearly longer than wide; a dot has that of the pixels' corners.
    Point direction(std::size_t dash, std::size_t end) const {
        const Dash& one = dashes_[dash];
        if (one.length() < one.width) return {};
        return {one.ends[end].x - one.ends[1 - end].x, one.ends[end].y - one.ends[1 - end].y};
    }

    bool go_on(std::size_t i, std::size_t e, std::size_t j, std::size_t f) const {
        const Point a = dashes_[i].middle(), b = dashes_[j].middle(), way{b.x - a.x, b.y - a.y};
        const Point out = direction(i, e), in = direction(j, f);
        return cosine(out, way) >= kOnCourse && cosine({-in.x, -in.y}, way) >= kOnCourse;
    }

    // Dots get their direction from those that they are joined to.
    bool keeps_course(const Link& link) const {
        const Point a = dashes_[link.a / 2].middle(), b = dashes_[link.b / 2].middle(), way{b.x - a.x, b.y - a.y};
        for (const auto& [end, sign] : {std::pair{link.a, 1.0}, std::pair{link.b, -1.0}}) {
            const std::size_t other = links_[end ^ 1];
            if (other == kNone) continue;
            const Point from = dashes_[other / 2].middle(), own = dashes_[end / 2].middle();
            if (cosine({own.x - from.x, own.y - from.y}, {sign * way.x, sign * way.y}) < kOnCourse) return false;
        }
        return true;
    }

    std::vector<Dash> dashes_;
    std::vector<std::size_t> links_;  // of each end
};

Artwork apply(Artwork artwork, const Settings& settings) {
    Image image = to_grey(std::move(std::get<Image>(artwork)));
    const double mm = image.mm_per_pixel, longest = settings.number("longest") / mm,
                 widest = std::max(2.0, settings.number("widest") / mm);
    if (longest < 1) return image;
    const Components pieces =
        find_components(image.width, image.height, Joined::by_corners, [&](std::size_t i) { return image.pixels[i] < 128; });
    const auto extents = pieces.extents();
    std::vector<std::vector<const Run*>> runs(pieces.count);
    for (const Run& run : pieces.runs)
        if (static_cast<double>(extents[run.component]) <= longest) runs[run.component].push_back(&run);
    std::vector<Dash> dashes;
    for (const auto& piece : runs)
        if (!piece.empty())
            if (const auto dash = dash_of(piece, longest, widest)) dashes.push_back(*dash);
    if (dashes.size() < kLeastDashes || dashes.size() > kMostDashes) return image;
    cv::Mat ink = view_of(image);
    const Rows rows(std::move(dashes), kMostGap / mm);
    const int thick = std::max(1, static_cast<int>(std::lround(0.3 / mm)));
    rows.join([&](Point a, Point b) {
        cv::line(ink, cv::Point(static_cast<int>(a.x), static_cast<int>(a.y)),
                 cv::Point(static_cast<int>(b.x), static_cast<int>(b.y)), cv::Scalar(0), thick);
    });
    return image;
}

}  // namespace

extern const Filter dashes_filter;
const Filter dashes_filter{
    .name = "dashes",
    .summary = "makes dashed and dotted lines of a black and white picture whole, so that they are traced as lines",
    .takes = static_cast<Kinds>(Kind::picture),
    .gives = static_cast<Kinds>(Kind::picture),
    .options = kOptions,
    .apply = apply,
};

}  // namespace tactics
