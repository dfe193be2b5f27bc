// SPDX-License-Identifier: Apache-2.0
// The picture is first counted into 32 x 32 x 32 boxes of colour, so that the work depends on its colours, not its size.
// The start is Var-Part (T. Su, J. Dy, "In search of deterministic methods for initializing K-means and Gaussian mixture
// clustering", 2007): the class with the most squared error is cut at its mean across its longest axis, k-1 times. Then
// Lloyd's rounds until nothing changes.
#include "filters/kmeans_colour.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "filters/lab.h"

namespace tactics {

namespace {

constexpr std::size_t kBoxes = 1 << 15;  // 5 bits of each channel

std::size_t box_of(const std::uint8_t* pixel) {
    return static_cast<std::size_t>(pixel[0] >> 3) << 10 | static_cast<std::size_t>(pixel[1] >> 3) << 5 |
           static_cast<std::size_t>(pixel[2] >> 3);
}

struct ColourBox {
    std::uint64_t count = 0;
    std::array<std::uint64_t, 3> sums{};  // red, green, blue
};

struct ColourBin {
    std::size_t box = 0;
    double weight = 0;
    Lab lab{};
    int group = 0;
};

struct Group {
    Lab centre{};
    double squares = 0;
    int longest = 0;  // axis with the most squared error
};

Group group_of(const std::vector<ColourBin>& colours, int number) {
    Group group;
    double weight = 0;
    Lab sum{};
    Lab squares{};
    for (const ColourBin& colour : colours) {
        if (colour.group != number) continue;
        weight += colour.weight;
        for (std::size_t a = 0; a < 3; ++a) sum[a] += colour.weight * colour.lab[a];
    }
    for (std::size_t a = 0; a < 3; ++a) group.centre[a] = sum[a] / weight;
    for (const ColourBin& colour : colours) {
        if (colour.group != number) continue;
        for (std::size_t a = 0; a < 3; ++a)
            squares[a] += colour.weight * (colour.lab[a] - group.centre[a]) * (colour.lab[a] - group.centre[a]);
    }
    group.longest = static_cast<int>(std::max_element(squares.begin(), squares.end()) - squares.begin());
    group.squares = squares[0] + squares[1] + squares[2];
    return group;
}

std::vector<Lab> start(std::vector<ColourBin>& colours, int k) {
    std::vector<Group> groups{group_of(colours, 0)};
    while (static_cast<int>(groups.size()) < k) {
        const auto widest =
            std::max_element(groups.begin(), groups.end(), [](const Group& a, const Group& b) { return a.squares < b.squares; });
        const int old = static_cast<int>(widest - groups.begin());
        const int fresh = static_cast<int>(groups.size());
        const auto axis = static_cast<std::size_t>(widest->longest);
        const auto in_widest = [&](const ColourBin& colour) { return colour.group == old; };
        const auto moves = [&, middle = widest->centre[axis]](const ColourBin& colour) {
            return in_widest(colour) && colour.lab[axis] > middle;
        };
        const auto members = std::count_if(colours.begin(), colours.end(), in_widest);
        const auto moving = std::count_if(colours.begin(), colours.end(), moves);
        if (moving == 0 || moving == members) break;  // every class is one colour
        for (ColourBin& colour : colours)
            if (moves(colour)) colour.group = fresh;
        groups[static_cast<std::size_t>(old)] = group_of(colours, old);
        groups.push_back(group_of(colours, fresh));
    }
    std::vector<Lab> centres;
    for (const Group& group : groups) centres.push_back(group.centre);
    return centres;
}

// One of Lloyd's rounds; says whether a colour changed its class.
bool round_of(std::vector<ColourBin>& colours, std::vector<Lab>& centres) {
    bool changed = false;
    std::vector<Lab> sums(centres.size());
    std::vector<double> weights(centres.size());
    for (ColourBin& colour : colours) {
        std::size_t nearest = 0;
        double least = INFINITY;
        for (std::size_t c = 0; c < centres.size(); ++c) {
            double squares = 0;
            for (std::size_t a = 0; a < 3; ++a) squares += (colour.lab[a] - centres[c][a]) * (colour.lab[a] - centres[c][a]);
            if (squares < least) {
                least = squares;
                nearest = c;
            }
        }
        changed = changed || colour.group != static_cast<int>(nearest);
        colour.group = static_cast<int>(nearest);
        weights[nearest] += colour.weight;
        for (std::size_t a = 0; a < 3; ++a) sums[nearest][a] += colour.weight * colour.lab[a];
    }
    for (std::size_t c = 0; c < centres.size(); ++c)
        for (std::size_t a = 0; a < 3 && weights[c] > 0; ++a) centres[c][a] = sums[c][a] / weights[c];
    return changed;
}

}  // namespace

Image kmeans_colour(Image image, int k) {
    std::vector<ColourBox> boxes(kBoxes);
    const auto end = image.pixels.data() + image.pixels.size();
    for (auto pixel = image.pixels.data(); pixel != end; pixel += 3) {
        ColourBox& box = boxes[box_of(pixel)];
        ++box.count;
        for (std::size_t a = 0; a < 3; ++a) box.sums[a] += pixel[a];
    }
    std::vector<ColourBin> colours;
    for (std::size_t i = 0; i < kBoxes; ++i) {
        const auto mean = [&](std::size_t a) {
            return static_cast<double>(boxes[i].sums[a]) / static_cast<double>(boxes[i].count);
        };
        if (boxes[i].count > 0) colours.push_back({i, static_cast<double>(boxes[i].count), to_lab(mean(0), mean(1), mean(2)), 0});
    }
    std::vector<Lab> centres = start(colours, k);
    constexpr int kMostRounds = 100;
    for (int i = 0; i < kMostRounds && round_of(colours, centres); ++i) {
    }

    std::vector<ColourBox> totals(centres.size());
    for (const ColourBin& colour : colours) {
        ColourBox& total = totals[static_cast<std::size_t>(colour.group)];
        total.count += boxes[colour.box].count;
        for (std::size_t a = 0; a < 3; ++a) total.sums[a] += boxes[colour.box].sums[a];
    }
    std::vector<std::array<std::uint8_t, 3>> answer(kBoxes);
    for (const ColourBin& colour : colours) {
        const ColourBox& total = totals[static_cast<std::size_t>(colour.group)];
        for (std::size_t a = 0; a < 3; ++a)
            answer[colour.box][a] = static_cast<std::uint8_t>((total.sums[a] + total.count / 2) / total.count);
    }
    for (auto pixel = image.pixels.data(); pixel != end; pixel += 3) {
        const auto& colour = answer[box_of(pixel)];
        std::copy(colour.begin(), colour.end(), pixel);
    }
    return image;
}

}  // namespace tactics
