// SPDX-License-Identifier: Apache-2.0
#include "filters/flat_regions.h"

#include <algorithm>
#include <cmath>

#include "filters/edge_noise.h"
#include "filters/lab.h"
#include "filters/opencv.h"
#include "filters/region_borders.h"
#include "tactics/geometry/course.h"
#include "tactics/geometry/lots.h"

namespace tactics {

namespace {

constexpr std::uint32_t kNoRegion = 0xffffffff;
constexpr int kFlatRange = 12;  // levels that 3x3 pixels of one colour differ by in a channel: as JPEG of quality 75 leaves
// Levels: what is paler between two regions of one colour is a grid, or the frame of a legend.
constexpr int kBorderStep = 64;
constexpr int kAlikeColours = 12;  // levels between colours that are taken for one
// A street is longer than that many times its width; a province is not.
constexpr double kRoad = 10;

// Without its grain. A median takes lines of one pixel, too, so a clean picture stays as it is.
cv::Mat clean_colours(const Image& picture) {
    constexpr double kGrain = 2;
    cv::Mat colours = view_of(picture);
    if (picture.channels == 1) cv::cvtColor(colours, colours, cv::COLOR_GRAY2RGB);
    if (noise_level(to_grey(picture)) <= kGrain) return colours;
    cv::Mat clean;
    cv::medianBlur(colours, clean, 3);
    return clean;
}

// 255 where the neighbourhood is of one colour.
cv::Mat flat_in(const cv::Mat& picture) {
    const cv::Mat nine = cv::getStructuringElement(cv::MORPH_RECT, {3, 3});
    cv::Mat high, low, flat(picture.rows, picture.cols, CV_8UC1);
    cv::dilate(picture, high, nine);
    cv::erode(picture, low, nine);
    for (int y = 0; y < picture.rows; ++y) {
        const std::uint8_t *h = high.ptr(y), *l = low.ptr(y);
        std::uint8_t* to = flat.ptr(y);
        for (int x = 0; x < picture.cols; ++x, h += 3, l += 3)
            to[x] = std::max({h[0] - l[0], h[1] - l[1], h[2] - l[2]}) <= kFlatRange ? 255 : 0;
    }
    return flat;
}

struct Piece {
    float wide = 0;
    std::size_t area = 0;
    std::array<std::uint64_t, 3> sum{};
};

std::vector<Piece> pieces_in(const cv::Mat& picture, const cv::Mat& label, const cv::Mat& depth, int count) {
    std::vector<Piece> pieces(static_cast<std::size_t>(count));
    for (int y = 0; y < picture.rows; ++y)
        for (int x = 0; x < picture.cols; ++x) {
            Piece& piece = pieces[static_cast<std::size_t>(label.at<int>(y, x))];
            piece.wide = std::max(piece.wide, 2 * depth.at<float>(y, x));
            ++piece.area;
            for (std::size_t c = 0; c < 3; ++c) piece.sum[c] += picture.ptr(y)[3 * x + static_cast<int>(c)];
        }
    return pieces;
}

bool is_region(const Piece& piece, double least, double road) {
    const double wide = static_cast<double>(piece.wide);
    return wide >= least && (wide >= road || static_cast<double>(piece.area) < kRoad * wide * wide);
}

int unlike(const std::array<std::uint8_t, 3>& a, const std::array<std::uint8_t, 3>& b) {
    return channels_apart({a[0], a[1], a[2]}, {b[0], b[1], b[2]});
}

// Each pixel's nearest pixel of a region says which is its own.
void grow(FlatRegions& regions, const cv::Mat& picture, const cv::Mat& label, const std::vector<std::uint32_t>& number) {
    cv::Mat outside(picture.rows, picture.cols, CV_8UC1), away, nearest;
    for (int y = 0; y < picture.rows; ++y)
        for (int x = 0; x < picture.cols; ++x)
            outside.ptr(y)[x] = number[static_cast<std::size_t>(label.at<int>(y, x))] == kNoRegion ? 255 : 0;
    cv::distanceTransform(outside, away, nearest, cv::DIST_L2, cv::DIST_MASK_5, cv::DIST_LABEL_PIXEL);
    std::vector<std::uint32_t> own(static_cast<std::size_t>(picture.rows) * static_cast<std::size_t>(picture.cols) + 1, 0);
    for (int y = 0; y < picture.rows; ++y)
        for (int x = 0; x < picture.cols; ++x)
            if (outside.ptr(y)[x] == 0)
                own[static_cast<std::size_t>(nearest.at<int>(y, x))] = number[static_cast<std::size_t>(label.at<int>(y, x))];
    std::size_t i = 0;
    for (int y = 0; y < picture.rows; ++y)
        for (int x = 0; x < picture.cols; ++x, ++i) {
            const std::uint8_t* at = picture.ptr(y) + static_cast<std::ptrdiff_t>(3) * x;
            regions.region[i] = own[static_cast<std::size_t>(nearest.at<int>(y, x))];
            regions.flat[i] = outside.ptr(y)[x] == 0;
            regions.unlike[i] = regions.flat[i]
                                    ? std::uint8_t{0}
                                    : static_cast<std::uint8_t>(unlike(regions.colour[regions.region[i]], {at[0], at[1], at[2]}));
        }
}

// Two regions side by side, by the number of pixel sides that they share.
struct Contact {
    std::uint32_t a = 0, b = 0;        // a < b
    std::size_t sides = 0, lined = 0;  // of these with a line there
};

std::vector<Contact> contacts_of(const FlatRegions& regions) {
    std::vector<std::uint64_t> sides;  // a, b, and whether there is a line
    const auto meet = [&](std::size_t i, std::size_t j) {
        const auto [a, b] = std::minmax(regions.region[i], regions.region[j]);
        if (a != b)
            sides.push_back(std::uint64_t{a} << 33 | std::uint64_t{b} << 1 |
                            (std::max(regions.unlike[i], regions.unlike[j]) > kBorderStep ? 1 : 0));
    };
    for (int y = 0; y < regions.height; ++y)
        for (int x = 0; x < regions.width; ++x) {
            const std::size_t i = regions.index(x, y);
            if (x > 0) meet(i, i - 1);
            if (y > 0) meet(i, regions.index(x, y - 1));
        }
    std::sort(sides.begin(), sides.end());
    std::vector<Contact> contacts;
    for (const std::uint64_t side : sides) {
        const auto a = static_cast<std::uint32_t>(side >> 33), b = static_cast<std::uint32_t>(side >> 1);
        if (contacts.empty() || contacts.back().a != a || contacts.back().b != b) contacts.push_back({a, b, 0, 0});
        ++contacts.back().sides;
        contacts.back().lined += side & 1;
    }
    return contacts;
}

// Compression cuts one region into pieces, with nothing between them that looks like a line.
void join_alike(FlatRegions& regions) {
    Lots lots(regions.count());
    for (const Contact& contact : contacts_of(regions))
        if (2 * contact.lined < contact.sides && unlike(regions.colour[contact.a], regions.colour[contact.b]) <= kAlikeColours)
            lots.join(contact.a, contact.b);
    std::vector<std::uint32_t> number(regions.count(), kNoRegion);
    std::vector<float> wide;
    std::vector<std::array<std::uint8_t, 3>> colour;
    for (std::uint32_t i = 0; i < regions.count(); ++i) {
        std::uint32_t& now = number[lots.find(i)];
        if (now == kNoRegion) {
            now = static_cast<std::uint32_t>(wide.size());
            wide.push_back(0);
            colour.emplace_back();
        }
        number[i] = now;
        if (regions.wide[i] > wide[now]) wide[now] = regions.wide[i], colour[now] = regions.colour[i];
    }
    for (std::uint32_t& region : regions.region) region = number[region];
    regions.wide = std::move(wide);
    regions.colour = std::move(colour);
}

}  // namespace

FlatRegions flat_regions_of(const Image& picture, double least, double road) {
    const cv::Mat colours = clean_colours(picture);
    const cv::Mat flat = flat_in(colours);
    cv::Mat label, depth;
    const int count = cv::connectedComponents(flat, label, 4, CV_32S);
    cv::distanceTransform(flat, depth, cv::DIST_L2, cv::DIST_MASK_5);
    const std::vector<Piece> pieces = pieces_in(colours, label, depth, count);
    FlatRegions regions{picture.width, picture.height, {}, {}, {}, {}, {}};
    std::vector<std::uint32_t> number(pieces.size(), kNoRegion);
    for (std::size_t i = 1; i < pieces.size(); ++i) {
        const Piece& piece = pieces[i];
        if (!is_region(piece, least, road)) continue;
        number[i] = static_cast<std::uint32_t>(regions.count());
        regions.wide.push_back(piece.wide);
        std::array<std::uint8_t, 3>& mean = regions.colour.emplace_back();
        for (std::size_t c = 0; c < 3; ++c) mean[c] = static_cast<std::uint8_t>((piece.sum[c] + piece.area / 2) / piece.area);
    }
    if (regions.count() == 0) return regions;
    const auto pixels = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
    regions.region.resize(pixels);
    regions.flat.resize(pixels);
    regions.unlike.resize(pixels);
    grow(regions, colours, label, number);
    join_alike(regions);
    return regions;
}

namespace {

constexpr int kMapSide = 600;  // pixels: the outline of a province is one of them at least

double share_of(std::size_t part, std::size_t all) { return all == 0 ? 0 : static_cast<double>(part) / static_cast<double>(all); }

// The colour of most of the picture, of regions as wide as a finger tells.
std::array<std::uint8_t, 3> ground_of(const FlatRegions& regions, const std::vector<std::size_t>& areas,
                                      const std::vector<std::size_t>& wide) {
    std::array<std::uint8_t, 3> ground{};
    std::size_t most = 0;
    for (const std::size_t i : wide) {
        std::size_t area = 0;
        for (const std::size_t j : wide)
            if (unlike(regions.colour[i], regions.colour[j]) <= kAlikeColours) area += areas[j];
        if (area > most) most = area, ground = regions.colour[i];
    }
    return ground;
}

// Of the borders between coloured regions, the share in pieces that are straight over a twentieth of the side.
double straight_share(const FlatRegions& regions, const std::vector<bool>& coloured, double side) {
    constexpr double kCourse = 1.5, kLongPiece = 0.05;  // pixels; of the side
    const RegionMap map{regions.width, regions.height, regions.region, std::vector<std::uint8_t>(regions.count())};
    double all = 0, straight = 0;
    for (const Border& border : borders_of(map, kCourse).borders) {
        if (border.other < 0 || !coloured[border.region] || !coloured[static_cast<std::size_t>(border.other)]) continue;
        const std::vector<Point> course = course_of(border.points, kCourse);
        for (std::size_t i = 0; i + 1 < course.size(); ++i) {
            const double piece = distance(course[i], course[i + 1]);
            all += piece;
            straight += piece >= kLongPiece * side ? piece : 0;
        }
    }
    return all > 0 ? straight / all : 0;
}

// Of the pixels of lines, those within `beside` pixels of a border; letters count for neither.
double explained_by(const FlatRegions& regions, const cv::Mat& inner, double beside, double letter) {
    cv::Mat away, far(regions.height, regions.width, CV_8UC1), label, sizes, middles;
    cv::distanceTransform(inner, away, cv::DIST_L2, cv::DIST_MASK_5);
    std::size_t near = 0, unexplained = 0;
    for (int y = 0; y < regions.height; ++y)
        for (int x = 0; x < regions.width; ++x) {
            const bool line = regions.is_line(regions.index(x, y)), is_near = static_cast<double>(away.at<float>(y, x)) <= beside;
            near += line && is_near ? 1 : 0;
            far.ptr(y)[x] = line && !is_near ? 255 : 0;
        }
    const int count = cv::connectedComponentsWithStats(far, label, sizes, middles, 8, CV_32S);
    for (int i = 1; i < count; ++i)
        if (std::max(sizes.at<int>(i, cv::CC_STAT_WIDTH), sizes.at<int>(i, cv::CC_STAT_HEIGHT)) > letter)
            unexplained += static_cast<std::size_t>(sizes.at<int>(i, cv::CC_STAT_AREA));
    return share_of(near, near + unexplained);
}

}  // namespace

MapTraits map_traits_of(const Image& picture) {
    constexpr double kSeed = 0.006, kWide = 0.018, kBesideBorder = 0.006, kLetter = 0.04;  // of the longer side
    Image small = picture;
    if (const double by = static_cast<double>(kMapSide) / std::max(picture.width, picture.height); by < 1) {
        small = make_image(std::max(1, static_cast<int>(by * picture.width)), std::max(1, static_cast<int>(by * picture.height)),
                           picture.channels, 0, 0);
        cv::resize(view_of(picture), view_of(small), {small.width, small.height}, 0, 0, cv::INTER_AREA);
    }
    const double side = std::max(small.width, small.height);
    const FlatRegions regions = flat_regions_of(small, kSeed * side, 0);
    MapTraits traits;
    if (regions.count() == 0) return traits;
    std::vector<std::size_t> areas(regions.count()), wide;
    for (std::size_t i = 0; i < regions.region.size(); ++i) areas[regions.region[i]] += regions.flat[i] ? 1 : 0;
    for (const std::size_t area : areas) traits.flat += share_of(area, regions.region.size());
    std::vector<bool> coloured(regions.count());
    for (std::size_t i = 0; i < regions.count(); ++i)
        if (static_cast<double>(regions.wide[i]) >= kWide * side) wide.push_back(i);
    const auto ground = ground_of(regions, areas, wide);
    std::vector<std::array<std::uint8_t, 3>> colours;
    for (const std::size_t i : wide) {
        const auto& own = regions.colour[i];
        if (unlike(own, ground) <= kAlikeColours) continue;
        coloured[i] = true;
        ++traits.regions;
        if (std::none_of(colours.begin(), colours.end(), [&](const auto& other) { return unlike(own, other) <= kAlikeColours; }))
            colours.push_back(own);
    }
    traits.colours = colours.size();
    cv::Mat inner(small.height, small.width, CV_8UC1, cv::Scalar(255));
    std::size_t sides = 0, bordering = 0;
    const auto meet = [&](std::size_t a, std::size_t b) {
        if (regions.region[a] == regions.region[b]) return;
        ++sides;
        bordering += coloured[regions.region[a]] && coloured[regions.region[b]] ? 1 : 0;
        inner.data[a] = 0;
    };
    for (int y = 0; y < small.height; ++y)
        for (int x = 0; x < small.width; ++x) {
            const std::size_t i = regions.index(x, y);
            if (x > 0) meet(i, i - 1);
            if (y > 0) meet(i, regions.index(x, y - 1));
        }
    traits.bordering = share_of(bordering, sides);
    traits.straight = straight_share(regions, coloured, side);
    traits.explained = explained_by(regions, inner, kBesideBorder * side, kLetter * side);
    return traits;
}

// Of political maps a fifth or more of the borders lie between colours and are crooked, and .7 or more of the lines are borders.
// `convert` takes 47 of 52 maps of KGeography for such, and 7 of 278 figures in the documentation of Python packages, most of
// which have flat fields as a map has.
bool is_coloured_map(const MapTraits& traits) {
    return traits.flat >= 0.6 && traits.regions >= 5 && traits.colours >= 3 && traits.bordering >= 0.2 &&
           traits.explained >= 0.7 && traits.straight <= 0.75;
}

}  // namespace tactics
