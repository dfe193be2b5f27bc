// SPDX-License-Identifier: Apache-2.0
// Augmenting paths in the bipartite graph of neighbours (C. Berge 1957; H. W. Kuhn 1955). Two facts make a sweep of
// thresholds cheap: a line pixel that has a partner keeps one while lines are only added, and where one search found no way
// to a free truth pixel, no later search does.
#include "tactics/measure/matching.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tactics {

Matching::Matching(const PixelSet& truth, double reach) : width_(truth.width), height_(truth.height) {
    const int far = static_cast<int>(std::floor(reach));
    for (int y = -far; y <= far; ++y)
        for (int x = -far; x <= far; ++x)
            if (const int square = x * x + y * y; square <= reach * reach) offsets_.push_back({x, y, square});
    std::stable_sort(offsets_.begin(), offsets_.end(), [](const Offset& a, const Offset& b) { return a.square < b.square; });
    const std::size_t size = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    truth_at_.assign(size, kNone);
    line_at_.assign(size, kNone);
    for (std::size_t i = 0; i < truth.pixels.size(); ++i) truth_at_[truth.pixels[i]] = static_cast<std::int32_t>(i);
    owner_.assign(truth.pixels.size(), kNone);
    closed_.assign(truth.pixels.size(), 0);
    reached_from_.assign(truth.pixels.size(), kNone);
}

bool Matching::has_pair(std::uint32_t line_pixel) const {
    const std::int32_t line = line_at_[line_pixel];
    return line != kNone && lines_[static_cast<std::size_t>(line)].partner != kNone;
}

// The line pixel's index; its neighbours are looked up the first time.
std::int32_t Matching::line_of(std::uint32_t pixel) {
    if (line_at_[pixel] != kNone) return line_at_[pixel];
    Line line;
    line.pixel = pixel;
    line.first = static_cast<std::uint32_t>(near_.size());
    const int px = static_cast<int>(pixel % static_cast<std::uint32_t>(width_));
    const int py = static_cast<int>(pixel / static_cast<std::uint32_t>(width_));
    for (const Offset& offset : offsets_) {
        const int x = px + offset.x, y = py + offset.y;
        if (x < 0 || y < 0 || x >= width_ || y >= height_) continue;
        const std::int32_t truth =
            truth_at_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
        if (truth != kNone) near_.push_back({truth, offset.square});
    }
    line.end = static_cast<std::uint32_t>(near_.size());
    lines_.push_back(line);
    return line_at_[pixel] = static_cast<std::int32_t>(lines_.size() - 1);
}

void Matching::pair(std::int32_t line, std::int32_t truth) {
    lines_[static_cast<std::size_t>(line)].partner = truth;
    owner_[static_cast<std::size_t>(truth)] = line;
}

// Takes out what is no line any more. Whether a truth pixel lost its partner by that.
bool Matching::leave(const PixelSet& lines) {
    bool freed = false;
    auto kept = lines.pixels.begin();
    // present_ is in the order of the pixels, as the set is.
    for (const std::int32_t index : present_) {
        Line& line = lines_[static_cast<std::size_t>(index)];
        kept = std::lower_bound(kept, lines.pixels.end(), line.pixel);
        if (kept != lines.pixels.end() && *kept == line.pixel) continue;
        line.present = false;
        if (line.partner == kNone) continue;
        owner_[static_cast<std::size_t>(line.partner)] = kNone;
        line.partner = kNone;
        --pairs_;
        freed = true;
    }
    return freed;
}

void Matching::match(const PixelSet& lines) {
    if (lines.width != width_ || lines.height != height_)
        throw std::logic_error("lines and truth of different sizes are matched");
    const bool freed = leave(lines);
    if (freed) std::fill(closed_.begin(), closed_.end(), std::uint8_t{0});
    std::vector<std::int32_t> waiting;
    present_.clear();
    for (const std::uint32_t pixel : lines.pixels) {
        const std::int32_t index = line_of(pixel);
        Line& line = lines_[static_cast<std::size_t>(index)];
        present_.push_back(index);
        const bool fresh = !line.present;
        line.present = true;
        // A pixel that found no partner before will find none now, unless one was released.
        if (line.partner == kNone && line.first < line.end && (fresh || freed)) waiting.push_back(index);
    }
    pair_nearest(waiting);
    for (const std::int32_t index : waiting)
        if (lines_[static_cast<std::size_t>(index)].partner == kNone) find_partner(index);
}

// Pairs without conflict, the nearest first: most of all there will be. The benchmark asks for the least sum of distances
// among the largest matchings; this comes near it where it matters, in which line pixels are left over.
void Matching::pair_nearest(std::vector<std::int32_t> waiting) {
    std::vector<std::uint32_t> next(waiting.size());
    for (std::size_t i = 0; i < waiting.size(); ++i) next[i] = lines_[static_cast<std::size_t>(waiting[i])].first;
    int square = -1;
    for (const Offset& offset : offsets_) {
        if (offset.square == square) continue;
        square = offset.square;
        std::size_t left = 0;
        for (std::size_t i = 0; i < waiting.size(); ++i) {
            const Line& line = lines_[static_cast<std::size_t>(waiting[i])];
            std::uint32_t at = next[i];
            for (; at < line.end && near_[at].square == square; ++at) {
                if (line.partner != kNone || owner_[static_cast<std::size_t>(near_[at].truth)] != kNone) continue;
                pair(waiting[i], near_[at].truth);
                ++pairs_;
            }
            if (line.partner != kNone || at == line.end) continue;
            waiting[left] = waiting[i];
            next[left++] = at;
        }
        waiting.resize(left);
        next.resize(left);
        if (left == 0) return;
    }
}

// From the free truth pixel back to the line pixel where the search began, each line pixel takes the next partner.
void Matching::lead_back(std::int32_t truth, std::int32_t start) {
    for (;;) {
        const std::int32_t line = reached_from_[static_cast<std::size_t>(truth)];
        const std::int32_t given_up = lines_[static_cast<std::size_t>(line)].partner;
        pair(line, truth);
        if (line == start) break;
        truth = given_up;
    }
    ++pairs_;
}

void Matching::find_partner(std::int32_t start) {
    std::vector<std::int32_t> queue{start}, seen;
    for (std::size_t at = 0; at < queue.size(); ++at) {
        const Line& line = lines_[static_cast<std::size_t>(queue[at])];
        for (std::uint32_t i = line.first; i < line.end; ++i) {
            const std::int32_t truth = near_[i].truth;
            const auto t = static_cast<std::size_t>(truth);
            if (closed_[t] != 0) continue;
            closed_[t] = 1;
            seen.push_back(truth);
            reached_from_[t] = queue[at];
            if (owner_[t] == kNone) {
                lead_back(truth, start);
                for (const std::int32_t open : seen) closed_[static_cast<std::size_t>(open)] = 0;
                return;
            }
            queue.push_back(owner_[t]);
        }
    }
}

}  // namespace tactics
