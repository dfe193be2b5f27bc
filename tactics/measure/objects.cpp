// SPDX-License-Identifier: Apache-2.0
#include "tactics/measure/objects.h"

#include <algorithm>
#include <stdexcept>

#include "tactics/measure/consensus.h"
#include "tactics/measure/distance.h"

namespace tactics {

namespace {

constexpr double kSame = 0.7;
constexpr double kLeast = 0.02, kMost = 0.5;

// A region of an annotator, with that of each other which is most like it.
struct Drawn {
    std::uint32_t annotator = 0, region = 0;
    int people = 1;
    double likeness = 0;                 // summed over the others that agree
    std::vector<std::uint32_t> members;  // by annotator: the region that agrees
};

constexpr std::uint32_t kNobody = 0xffffffff;

std::vector<Drawn> drawn_alike(std::span<const LabelMap> annotators) {
    std::vector<Drawn> regions;
    std::vector<std::size_t> first;  // of each annotator
    for (std::uint32_t a = 0; a < annotators.size(); ++a) {
        first.push_back(regions.size());
        for (std::uint32_t region = 0; region < annotators[a].regions; ++region) {
            Drawn drawn{a, region, 1, 0, std::vector<std::uint32_t>(annotators.size(), kNobody)};
            drawn.members[a] = region;
            regions.push_back(std::move(drawn));
        }
    }
    for (std::uint32_t a = 0; a < annotators.size(); ++a)
        for (std::uint32_t b = 0; b < annotators.size(); ++b) {
            if (a == b) continue;
            const OverlapTable table = overlaps_of(annotators[a].label, annotators[b].label);
            for (const OverlapTable::Part& part : table.parts) {
                const double overlap = static_cast<double>(part.pixels) /
                                       static_cast<double>(table.first[part.first] + table.second[part.second] - part.pixels);
                if (overlap < kSame) continue;  // at 0.7 no second region of b can be as much like this one
                Drawn& drawn = regions[first[a] + part.first];
                ++drawn.people;
                drawn.likeness += overlap;
                drawn.members[b] = part.second;
            }
        }
    std::erase_if(regions, [](const Drawn& drawn) { return drawn.people < kAgree; });
    std::stable_sort(regions.begin(), regions.end(), [](const Drawn& a, const Drawn& b) {
        return a.people != b.people ? a.people > b.people : a.likeness > b.likeness;
    });
    return regions;
}

std::array<int, 2> deepest_in(const std::vector<std::uint8_t>& mask, int width, int height) {
    // Beyond the frame is outside, too: a map one pixel larger on every side.
    PixelSet outside{width + 2, height + 2, {}};
    for (int y = -1; y <= height; ++y)
        for (int x = -1; x <= width; ++x) {
            const bool frame = x < 0 || y < 0 || x == width || y == height;
            if (frame || mask[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)] == 0)
                outside.pixels.push_back(static_cast<std::uint32_t>((y + 1) * (width + 2) + x + 1));
        }
    const std::vector<std::int64_t> squares = squared_distances(outside);
    const auto deepest = static_cast<int>(std::max_element(squares.begin(), squares.end()) - squares.begin());
    return {deepest % (width + 2) - 1, deepest / (width + 2) - 1};
}

AgreedObject object_of(const Drawn& drawn, std::span<const LabelMap> annotators) {
    const int width = annotators.front().width, height = annotators.front().height;
    AgreedObject object;
    object.people = drawn.people;
    object.mask.assign(annotators.front().label.size(), 0);
    object.box = {width, height, 0, 0};
    long long area = 0;
    for (std::size_t i = 0; i < object.mask.size(); ++i) {
        int votes = 0;
        for (std::size_t a = 0; a < annotators.size(); ++a)
            votes += drawn.members[a] != kNobody && annotators[a].label[i] == drawn.members[a] ? 1 : 0;
        if (2 * votes <= drawn.people) continue;
        object.mask[i] = 1;
        ++area;
        const int x = static_cast<int>(i) % width, y = static_cast<int>(i) / width;
        object.box = {std::min(object.box[0], x), std::min(object.box[1], y), std::max(object.box[2], x + 1),
                      std::max(object.box[3], y + 1)};
    }
    object.share = static_cast<double>(area) / static_cast<double>(object.mask.size());
    return object;
}

}  // namespace

std::vector<AgreedObject> agreed_objects(std::span<const LabelMap> annotators) {
    std::vector<AgreedObject> objects;
    if (annotators.empty()) return objects;
    const int width = annotators.front().width, height = annotators.front().height;
    for (const Drawn& drawn : drawn_alike(annotators)) {
        AgreedObject object = object_of(drawn, annotators);
        const bool frame = object.box == std::array<int, 4>{0, 0, width, height};
        if (object.share < kLeast || object.share > kMost || frame) continue;
        if (std::any_of(objects.begin(), objects.end(),
                        [&](const AgreedObject& other) { return overlap_of(other.mask, object.mask) >= kSame; }))
            continue;
        object.inside = deepest_in(object.mask, width, height);
        objects.push_back(std::move(object));
    }
    return objects;
}

double overlap_of(std::span<const std::uint8_t> first, std::span<const std::uint8_t> second) {
    if (first.size() != second.size()) throw std::logic_error("two masks of one picture have as many pixels");
    long long both = 0, any = 0;
    for (std::size_t i = 0; i < first.size(); ++i) {
        both += first[i] != 0 && second[i] != 0 ? 1 : 0;
        any += first[i] != 0 || second[i] != 0 ? 1 : 0;
    }
    return any > 0 ? static_cast<double>(both) / static_cast<double>(any) : 0;
}

std::vector<std::uint8_t> region_at(const LabelMap& map, std::array<int, 2> pixel) {
    const std::uint32_t region =
        map.label[static_cast<std::size_t>(pixel[1]) * static_cast<std::size_t>(map.width) + static_cast<std::size_t>(pixel[0])];
    std::vector<std::uint8_t> mask;
    mask.reserve(map.label.size());
    for (const std::uint32_t label : map.label) mask.push_back(label == region ? 1 : 0);
    return mask;
}

std::vector<std::uint8_t> regions_in(const LabelMap& map, const std::array<int, 4>& box) {
    std::vector<long long> all(map.regions, 0), within(map.regions, 0);
    for (std::size_t i = 0; i < map.label.size(); ++i) {
        const int x = static_cast<int>(i) % map.width, y = static_cast<int>(i) / map.width;
        ++all[map.label[i]];
        if (x >= box[0] && x < box[2] && y >= box[1] && y < box[3]) ++within[map.label[i]];
    }
    std::vector<std::uint8_t> mask;
    mask.reserve(map.label.size());
    for (const std::uint32_t label : map.label) mask.push_back(2 * within[label] > all[label] ? 1 : 0);
    return mask;
}

}  // namespace tactics
