// SPDX-License-Identifier: Apache-2.0
#include "filters/region_map.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <set>

#include "filters/components.h"
#include "filters/opencv.h"

namespace tactics {

namespace {

// How far each pixel is from the border of its region; pixels at a border have half a pixel.
cv::Mat depth_of(const RegionMap& map) {
    Image inner = make_image(map.width, map.height, 1, 0, 255);
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x) {
            const std::uint32_t own = map.region[map.index(x, y)];
            const bool border = x == 0 || y == 0 || x + 1 == map.width || y + 1 == map.height ||
                                map.region[map.index(x - 1, y)] != own || map.region[map.index(x + 1, y)] != own ||
                                map.region[map.index(x, y - 1)] != own || map.region[map.index(x, y + 1)] != own;
            if (border) inner.row(y)[x] = 0;
        }
    cv::Mat depth;
    cv::distanceTransform(view_of(inner), depth, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    return depth + 0.5;
}

}  // namespace

RegionMap regions_of(const ClassMap& map) {
    RegionMap regions{map.width, map.height, std::vector<std::uint32_t>(map.classes.size()), {}};
    // One class after the other, each with the components that its pixels make.
    std::vector<bool> occurs(256, false);
    for (const std::uint8_t c : map.classes) occurs[c] = true;
    for (unsigned c = 0; c < 256; ++c) {
        if (!occurs[c]) continue;
        const Components pieces =
            find_components(map.width, map.height, Joined::by_sides, [&](std::size_t i) { return map.classes[i] == c; });
        const auto first = static_cast<std::uint32_t>(regions.class_of.size());
        for (const Run& run : pieces.runs)
            std::fill_n(regions.region.begin() + static_cast<std::ptrdiff_t>(map.index(run.begin, run.row)), run.length(),
                        first + run.component);
        regions.class_of.resize(first + pieces.count, static_cast<std::uint8_t>(c));
    }
    return regions;
}

Merging::Merging(RegionMap map, const std::vector<std::vector<double>>& apart)
    : map_(std::move(map)),
      apart_(apart),
      parent_(map_.class_of.size()),
      neighbours_(parent_.size()),
      width_(parent_.size(), 1),
      count_(parent_.size()) {
    std::iota(parent_.begin(), parent_.end(), 0u);
    const cv::Mat depth = depth_of(map_);
    const auto meet = [&](std::uint32_t a, std::uint32_t b) {
        if (a == b) return;
        for (const auto& [one, other] : {std::pair(a, b), std::pair(b, a)}) {
            auto& list = neighbours_[one];
            if (!list.empty() && list.back().region == other)
                ++list.back().border;
            else
                list.push_back({other, 1});
        }
    };
    for (int y = 0; y < map_.height; ++y)
        for (int x = 0; x < map_.width; ++x) {
            const std::uint32_t own = map_.region[map_.index(x, y)];
            width_[own] = std::max(width_[own], 2 * depth.at<float>(y, x));
            if (x + 1 < map_.width) meet(own, map_.region[map_.index(x + 1, y)]);
            if (y + 1 < map_.height) meet(own, map_.region[map_.index(x, y + 1)]);
        }
    for (std::uint32_t i = 0; i < parent_.size(); ++i) queue_.push_back({width_[i], i});
    std::make_heap(queue_.begin(), queue_.end(), std::greater<>());
}

std::uint32_t Merging::root(std::uint32_t region) const {
    while (parent_[region] != region) region = parent_[region] = parent_[parent_[region]];
    return region;
}

std::vector<Merging::Neighbour> Merging::neighbours_of(std::uint32_t region) const {
    std::vector<Neighbour> all;
    for (const Neighbour& n : neighbours_[region])
        if (const std::uint32_t now = root(n.region); now != region) all.push_back({now, n.border});
    std::sort(all.begin(), all.end(), [](const Neighbour& a, const Neighbour& b) { return a.region < b.region; });
    std::vector<Neighbour> each;
    for (const Neighbour& n : all) {
        if (!each.empty() && each.back().region == n.region)
            each.back().border += n.border;
        else
            each.push_back(n);
    }
    return each;
}

void Merging::join(std::uint32_t from, std::uint32_t to) {
    parent_[from] = to;
    --count_;
    width_[to] = std::max(width_[to], width_[from]);
    if (neighbours_[to].size() < neighbours_[from].size())
        std::swap(neighbours_[to], neighbours_[from]);  // the longer list stays in place
    neighbours_[to].insert(neighbours_[to].end(), neighbours_[from].begin(), neighbours_[from].end());
    neighbours_[from] = {};
}

void Merging::merge_narrowest() {
    std::pop_heap(queue_.begin(), queue_.end(), std::greater<>());
    const auto [width, region] = queue_.back();
    queue_.pop_back();
    if (parent_[region] != region) return;
    if (width_[region] > width) {
        queue_.push_back({width_[region], region});
        std::push_heap(queue_.begin(), queue_.end(), std::greater<>());
        return;
    }
    const std::vector<Neighbour> around = neighbours_of(region);
    const auto& apart = apart_[map_.class_of[region]];
    const auto worth = [&](const Neighbour& n) { return n.border / apart[map_.class_of[n.region]]; };
    const auto most = std::max_element(around.begin(), around.end(),
                                       [&](const Neighbour& a, const Neighbour& b) { return worth(a) < worth(b); });
    if (most == around.end()) return;
    const std::uint32_t to = most->region;
    neighbours_[region].assign(around.begin(), around.end());
    join(region, to);
    // What it parted before is one now.
    for (const Neighbour& n : around)
        if (n.region != to && map_.class_of[n.region] == map_.class_of[to]) join(n.region, to);
}

void Merging::merge(double least, std::size_t most) {
    while (count_ > 1 && !queue_.empty() &&
           (count_ > std::max<std::size_t>(most, 1) || static_cast<double>(queue_.front().first) < least))
        merge_narrowest();
}

double Merging::narrowest() const {
    float least = std::numeric_limits<float>::max();
    for (std::uint32_t i = 0; i < parent_.size(); ++i)
        if (parent_[i] == i) least = std::min(least, width_[i]);
    return static_cast<double>(least);
}

ClassMap Merging::result() const {
    ClassMap map{map_.width, map_.height, std::vector<std::uint8_t>(map_.region.size())};
    for (std::size_t i = 0; i < map.classes.size(); ++i) map.classes[i] = map_.class_of[root(map_.region[i])];
    return map;
}

RegionMap Merging::regions() const {
    RegionMap regions = map_;
    for (std::uint32_t& region : regions.region) region = root(region);
    return regions;
}

// The middle of each region, half the width away from its border, grows again until it meets the others': a border between two
// wide regions comes back to where it was, a thin part has no middle that it could come back from.
ClassMap without_thin_parts(const ClassMap& map, double width) {
    const cv::Mat depth = depth_of(regions_of(map));
    Image outside = make_image(map.width, map.height, 1, 0, 255);
    bool any = false;
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x)
            if (static_cast<double>(depth.at<float>(y, x)) >= width / 2) {
                outside.row(y)[x] = 0;
                any = true;
            }
    if (!any) return map;
    cv::Mat away, nearest;
    cv::distanceTransform(view_of(outside), away, nearest, cv::DIST_L2, cv::DIST_MASK_5, cv::DIST_LABEL_PIXEL);
    const auto middle_of = [&](int x, int y) { return static_cast<std::size_t>(nearest.at<int>(y, x)); };
    std::vector<std::uint8_t> class_of(map.classes.size() + 1);
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x)
            if (outside.row(y)[x] == 0) class_of[middle_of(x, y)] = map.classes[map.index(x, y)];
    ClassMap grown = map;
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x) grown.classes[map.index(x, y)] = class_of[middle_of(x, y)];
    return grown;
}

namespace {

constexpr int kEightAround[8][2] = {{-1, -1}, {0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}};

// How many pieces, joined by corners too, the pixels fall into.
std::size_t pieces_of(std::vector<std::pair<int, int>> pixels) {
    std::size_t pieces = 0;
    std::set<std::pair<int, int>> left(pixels.begin(), pixels.end());
    while (!left.empty()) {
        ++pieces;
        pixels.assign(1, *left.begin());
        left.erase(left.begin());
        while (!pixels.empty()) {
            const auto [x, y] = pixels.back();
            pixels.pop_back();
            for (const auto& [dx, dy] : kEightAround)
                if (const auto found = left.find({x + dx, y + dy}); found != left.end()) {
                    pixels.push_back(*found);
                    left.erase(found);
                }
        }
    }
    return pieces;
}

}  // namespace

// A corner of a region is thin as well, but it touches the wide part that it belongs to in one piece; a neck does in two.
ClassMap without_necks(const ClassMap& map, double width) {
    const RegionMap regions = regions_of(map);
    const cv::Mat depth = depth_of(regions);
    Image outside = make_image(map.width, map.height, 1, 0, 255);
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x)
            if (static_cast<double>(depth.at<float>(y, x)) >= width / 2) outside.row(y)[x] = 0;
    cv::Mat away;
    cv::distanceTransform(view_of(outside), away, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    const auto is_thin = [&](int x, int y) { return static_cast<double>(away.at<float>(y, x)) > width / 2 * 1.05; };
    const auto is_in = [&](int x, int y) { return x >= 0 && y >= 0 && x < map.width && y < map.height; };
    std::vector<bool> seen(map.classes.size(), false);
    ClassMap cut = map;
    for (int top = 0; top < map.height; ++top)
        for (int first = 0; first < map.width; ++first) {
            if (seen[map.index(first, top)] || !is_thin(first, top)) continue;
            const std::uint32_t region = regions.region[map.index(first, top)];
            std::vector<std::pair<int, int>> neck{{first, top}}, beside;
            std::map<std::uint8_t, std::size_t> borders;
            seen[map.index(first, top)] = true;
            double sum_x = 0, sum_y = 0;
            for (std::size_t i = 0; i < neck.size(); ++i) {
                const auto [x, y] = neck[i];
                sum_x += x;
                sum_y += y;
                for (const auto& [dx, dy] : kEightAround) {
                    if (!is_in(x + dx, y + dy)) continue;
                    const std::size_t next = map.index(x + dx, y + dy);
                    if (regions.region[next] != region) {
                        ++borders[map.classes[next]];
                    } else if (!is_thin(x + dx, y + dy)) {
                        beside.push_back({x + dx, y + dy});
                    } else if (!seen[next]) {
                        seen[next] = true;
                        neck.push_back({x + dx, y + dy});
                    }
                }
            }
            if (borders.empty() || pieces_of(std::move(beside)) < 2) continue;
            const auto most = std::max_element(borders.begin(), borders.end(),
                                               [](const auto& a, const auto& b) { return a.second < b.second; });
            const double cx = sum_x / static_cast<double>(neck.size()), cy = sum_y / static_cast<double>(neck.size());
            for (const auto& [x, y] : neck) cut.classes[map.index(x, y)] = most->first;
            // Half a pixel here and there must not make a thin part of the way that is made.
            const double radius = 0.6 * width + 1;
            const int reach = static_cast<int>(std::ceil(radius));
            for (int dy = -reach; dy <= reach; ++dy)
                for (int dx = -reach; dx <= reach; ++dx) {
                    const int x = static_cast<int>(std::lround(cx)) + dx, y = static_cast<int>(std::lround(cy)) + dy;
                    if (is_in(x, y) && dx * dx + dy * dy <= radius * radius && regions.region[map.index(x, y)] == region)
                        cut.classes[map.index(x, y)] = most->first;
                }
        }
    return cut;
}

}  // namespace tactics
