// SPDX-License-Identifier: Apache-2.0
// The borders between regions of plain colours, each once and without gaps: a political map, a diagram of fields.
//
// An edge detector finds both sides of an outline, loses one of them where colours are as dark as it is, and is cut by every
// junction. Regions have none of these gaps: where two meet is a line, whatever is drawn there.
#include <algorithm>
#include <cmath>

#include "filters/flat_regions.h"
#include "filters/lab.h"
#include "filters/opencv.h"
#include "filters/region_borders.h"
#include "filters/region_map.h"
#include "filters/spacing.h"
#include "filters/traced.h"
#include "tactics/filter.h"
#include "tactics/medium.h"
#include "tactics/text/number.h"

namespace tactics {

namespace {

constexpr Option kBordersOptions[] = {
    {.name = "smallest",
     .type = Option::Type::length,
     .fallback = 4.4,
     .min = 1.2,
     .max = 100,
     .unit = "mm",
     .summary = "regions narrower than this join a neighbour, or are a black spot if they lie within one region; convert sets "
                "what the medium needs"},
    {.name = "shortest",
     .type = Option::Type::length,
     .fallback = 12,
     .min = 2,
     .max = 500,
     .unit = "mm",
     .summary = "lines within a region that are shorter than this, such as lettering, are left out"},
};

constexpr double kLeastRegion = 1.2;      // mm: a smaller one is no spot that a finger finds
constexpr double kBesideBorders = 1;      // mm: a line as near to a border is drawn by the border
constexpr int kClearInk = 64;             // levels: paler lines within a region are a grid or the frame of a legend
constexpr double kWidestLine = 1.6;       // mm
constexpr double kBorderTolerance = 0.1;  // mm; as that of simplify

RegionMap map_of(const FlatRegions& flat) {
    RegionMap map{flat.width, flat.height, flat.region, {}};
    // A class of its own for each as long as numbers last: two regions of one colour are two.
    for (std::size_t i = 0; i < flat.count(); ++i) {
        const auto& [red, green, blue] = flat.colour[i];
        map.class_of.push_back(
            static_cast<std::uint8_t>(flat.count() <= 256 ? i : (red & 0xe0) | (green & 0xe0) >> 3 | blue >> 6));
    }
    return map;
}

std::vector<std::vector<double>> unlike_classes(const FlatRegions& flat, const RegionMap& map) {
    std::vector<std::array<int, 3>> colour(256);
    for (std::size_t i = 0; i < flat.count(); ++i)
        colour[map.class_of[i]] = {flat.colour[i][0], flat.colour[i][1], flat.colour[i][2]};
    std::vector<std::vector<double>> apart(256, std::vector<double>(256));
    for (std::size_t a = 0; a < 256; ++a)
        for (std::size_t b = 0; b < 256; ++b) apart[a][b] = 10 + channels_apart(colour[a], colour[b]);
    return apart;
}

// Of each region: it has one neighbour only, and is too narrow for an outline.
std::vector<bool> spots_among(const FlatRegions& flat, double smallest) {
    constexpr std::int64_t kNone = -1, kMany = -2;
    std::vector<std::int64_t> beside(flat.count(), kNone);
    const auto meet = [&](std::uint32_t a, std::int64_t b) {
        if (beside[a] != b) beside[a] = beside[a] == kNone ? b : kMany;
    };
    for (int y = 0; y < flat.height; ++y)
        for (int x = 0; x < flat.width; ++x) {
            const std::uint32_t own = flat.region[flat.index(x, y)];
            if (x == 0 || y == 0 || x + 1 == flat.width || y + 1 == flat.height) beside[own] = kMany;
            if (x > 0)
                if (const std::uint32_t left = flat.region[flat.index(x - 1, y)]; left != own) meet(own, left), meet(left, own);
            if (y > 0)
                if (const std::uint32_t above = flat.region[flat.index(x, y - 1)]; above != own)
                    meet(own, above), meet(above, own);
        }
    std::vector<bool> spots(flat.count());
    for (std::size_t i = 0; i < spots.size(); ++i) spots[i] = beside[i] >= 0 && static_cast<double>(flat.wide[i]) < smallest;
    return spots;
}

class Borders {
public:
    Borders(const Image& image, const Settings& settings)
        : pixel_(image.mm_per_pixel > 0 ? image.mm_per_pixel : 1), settings_(settings) {
        drawing_.width = image.width * pixel_;
        drawing_.height = image.height * pixel_;
        const double smallest = settings.number("smallest") / pixel_;
        flat_ = flat_regions_of(image, kLeastRegion / pixel_, smallest);
        if (flat_.count() == 0) return;
        spots_ = spots_among(flat_, smallest);
        map_ = map_of(flat_);
        Merging merging(map_, unlike_classes(flat_, map_));
        merging.merge(smallest, flat_.count());
        map_ = merging.regions();
        tell(merging.count());
    }

    Drawing draw() && {
        if (flat_.count() == 0) return std::move(drawing_);
        for (const Border& border : borders_of(map_, kBorderTolerance / pixel_).borders)
            if (border.other >= 0) drawing_.strokes.push_back({placed(border.points), border.closed});
        InkMap spots(flat_.width, flat_.height), lines(flat_.width, flat_.height);
        const cv::Mat away = from_borders(), street = streets(away);
        for (int y = 0; y < flat_.height; ++y)
            for (int x = 0; x < flat_.width; ++x) {
                const std::size_t i = flat_.index(x, y);
                if (spots_[flat_.region[i]])
                    spots.row(y)[x] = 1;
                else if (flat_.unlike[i] > kClearInk && street.ptr(y)[x] == 0 &&
                         static_cast<double>(away.at<float>(y, x)) * pixel_ > kBesideBorders)
                    lines.row(y)[x] = 1;
            }
        for (const Outline& outline : outlines_of(spots)) add_area(drawing_, outline, pixel_, kLeastRegion);
        add_lines(drawing_, std::move(lines), nullptr, nullptr, pixel_, {settings_.number("shortest"), 3, 2});
        return std::move(drawing_);
    }

private:
    void tell(std::size_t left) {
        const auto spots = static_cast<std::size_t>(std::count(spots_.begin(), spots_.end(), true));
        if (flat_.count() > left + spots)
            drawing_.remarks.push_back(phrases(flat_.count() - left - spots, "{0} region is too narrow and joins a neighbour.",
                                               "{0} regions are too narrow and join a neighbour."));
    }

    // In pixels, from what is drawn of regions.
    cv::Mat from_borders() const {
        cv::Mat inner(flat_.height, flat_.width, CV_8UC1, cv::Scalar(255)), away;
        const auto other = [&](std::size_t a, std::size_t b) {
            return map_.region[a] != map_.region[b] || spots_[flat_.region[a]] != spots_[flat_.region[b]];
        };
        for (int y = 0; y < flat_.height; ++y)
            for (int x = 0; x < flat_.width; ++x)
                if (const std::size_t i = flat_.index(x, y);
                    (x > 0 && other(i, i - 1)) || (y > 0 && other(i, flat_.index(x, y - 1))))
                    inner.ptr(y)[x] = 0;
        cv::distanceTransform(inner, away, cv::DIST_L2, cv::DIST_MASK_5);
        return away;
    }

    // What is wider than a line and has a border in it: a street between two regions.
    cv::Mat streets(const cv::Mat& away) const {
        cv::Mat ink(flat_.height, flat_.width, CV_8UC1), thick, piece;
        for (int y = 0; y < flat_.height; ++y)
            for (int x = 0; x < flat_.width; ++x) ink.ptr(y)[x] = flat_.is_line(flat_.index(x, y)) ? 255 : 0;
        const int across = 2 * static_cast<int>(std::ceil(kWidestLine / 2 / pixel_)) + 1;
        cv::morphologyEx(ink, thick, cv::MORPH_OPEN, cv::getStructuringElement(cv::MORPH_ELLIPSE, {across, across}));
        std::vector<bool> has_border(static_cast<std::size_t>(cv::connectedComponents(thick, piece, 8, CV_32S)));
        for (int y = 0; y < flat_.height; ++y)
            for (int x = 0; x < flat_.width; ++x)
                if (away.at<float>(y, x) <= 1) has_border[static_cast<std::size_t>(piece.at<int>(y, x))] = true;
        for (int y = 0; y < flat_.height; ++y)
            for (int x = 0; x < flat_.width; ++x)
                if (!has_border[static_cast<std::size_t>(piece.at<int>(y, x))]) thick.ptr(y)[x] = 0;
        cv::dilate(thick, thick, cv::getStructuringElement(cv::MORPH_ELLIPSE, {across, across}));  // with its blurred rims
        return thick;
    }

    std::vector<Point> placed(std::vector<Point> points) const {
        for (Point& p : points)
            p = {std::clamp(p.x * pixel_, 0.0, drawing_.width), std::clamp(p.y * pixel_, 0.0, drawing_.height)};
        return points;
    }

    double pixel_;  // mm
    const Settings& settings_;
    Drawing drawing_;
    FlatRegions flat_;
    std::vector<bool> spots_;
    RegionMap map_;
};

Artwork apply_borders(Artwork artwork, const Settings& settings) { return Borders(std::get<Image>(artwork), settings).draw(); }

void fit_borders(Settings& settings, const Medium& medium) {
    if (settings.is_default("smallest"))
        settings.set("smallest", to_text(least_apart(medium, medium.line, medium.line) + kMovedLater) + "mm", "borders",
                     "borders");
}

}  // namespace

extern const Filter borders_filter;
const Filter borders_filter{
    .name = "borders",
    .summary =
        "draws the borders between regions of plain colours, whole and each once, small ones as spots, and the lines within",
    .takes = static_cast<Kinds>(Kind::picture),
    .gives = static_cast<Kinds>(Kind::drawing),
    .uses_colour = true,
    .options = kBordersOptions,
    .apply = apply_borders,
    .fit = fit_borders,
};

}  // namespace tactics
