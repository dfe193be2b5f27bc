// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/plane_choice.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tactics/solid/largest_first.h"

namespace tactics {

namespace {

constexpr double kWorthLooking = 0.02;  // of the surface, below which nobody would look at it from there
constexpr double kAsMuch = 0.95;        // of the most surface: that much is as good, if it is the side that people look at
constexpr double kNearlyOne = 0.985;    // cosine of two planes that are as good as one: 10 degrees

// A way that faces look in, and the area of those.
struct Look {
    Point3 way;
    double area = 0;
};

// The largest first; of something round, along its axis.
std::vector<Look> looks_of(const std::vector<ModelPart>& parts) {
    constexpr std::size_t kMost = 256;
    std::vector<Look> single, looks;
    for (const ModelPart& part : parts) {
        if (part.round) {
            const double disc = std::numbers::pi * part.round->widest * part.round->widest;
            for (const double sign : {1.0, -1.0}) single.push_back({sign * part.round->axis, disc});
        } else {
            for (const Patch& patch : part.solid.patches) single.push_back({patch.normal, patch.area});
        }
    }
    std::stable_sort(single.begin(), single.end(), [](const Look& a, const Look& b) { return a.area > b.area; });
    for (const Look& one : single) {
        const auto same =
            std::find_if(looks.begin(), looks.end(), [&](const Look& look) { return dot(look.way, one.way) > kAligned; });
        if (same != looks.end())
            same->area += one.area;
        else if (looks.size() < kMost)
            looks.push_back(one);
    }
    std::vector<double> areas;
    for (const Look& look : looks) areas.push_back(look.area);
    std::vector<Look> sorted;
    for (const std::size_t i : largest_first(areas, 1e-3)) sorted.push_back(looks[i]);
    return sorted;
}

// People look from above rather than from below, from the front rather than from behind.
double liking(const Point3& way) { return way.z - 0.1 * way.y + 0.01 * way.x; }

Point3 predominant(const std::vector<Look>& looks) {
    const Look* best = nullptr;
    for (const Look& look : looks)
        if (best == nullptr || (look.area > kAsMuch * looks.front().area && liking(look.way) > liking(best->way) + 1e-4))
            best = &look;
    return best == nullptr ? kFromAbove.toward : best->way;
}

Point3 nearest(const std::vector<Look>& looks, const Point3& from) {
    double all = 0;
    for (const Look& look : looks) all += look.area;
    const Look* best = nullptr;
    for (const Look& look : looks)
        if (look.area >= kWorthLooking * all && (best == nullptr || dot(look.way, from) > dot(best->way, from) + 1e-4))
            best = &look;
    return best == nullptr ? kFromTheFront.toward : best->way;
}

}  // namespace

std::string_view name_of(FoldPlane plane) {
    switch (plane) {
        case FoldPlane::automatic: return "auto";
        case FoldPlane::above: return "above";
        case FoldPlane::front: return "front";
        case FoldPlane::side: return "side";
        case FoldPlane::view: return "view";
        case FoldPlane::face: return "face";
    }
    return "";
}

Phrase seen(FoldPlane plane) {
    switch (plane) {
        case FoldPlane::front: return phrase("from the front");
        case FoldPlane::side: return phrase("from the side");
        case FoldPlane::view: return phrase("from the viewpoint of its file");
        case FoldPlane::face: return phrase("square onto its largest face");
        default: return phrase("from above");
    }
}

ChosenPlane plane_facing(const Point3& toward, FoldPlane otherwise) {
    const ChosenPlane known[] = {
        {FoldPlane::above, kFromAbove}, {FoldPlane::front, kFromTheFront}, {FoldPlane::side, kFromTheSide}};
    for (const ChosenPlane& one : known)
        if (dot(one.view.toward, toward) > kAligned) return one;
    const Point3 up = std::abs(toward.z) < kAligned ? Point3{0, 0, 1} : Point3{0, 1, 0};
    const Point3 down = -1 * unit(up - dot(up, toward) * toward);
    return {otherwise, {cross(toward, down), down, toward}};
}

std::vector<ChosenPlane> planes_for(FoldPlane wish, const std::vector<ModelPart>& parts, const Point3& viewed_from) {
    const auto face = [&] { return plane_facing(predominant(looks_of(parts)), FoldPlane::face); };
    switch (wish) {
        case FoldPlane::above: return {{wish, kFromAbove}};
        case FoldPlane::front: return {{wish, kFromTheFront}};
        case FoldPlane::side: return {{wish, kFromTheSide}};
        case FoldPlane::view:
            if (length_of(viewed_from) < 0.5) return {{FoldPlane::front, kFromTheFront}};
            return {plane_facing(nearest(looks_of(parts), viewed_from), wish)};
        case FoldPlane::face: return {face()};
        case FoldPlane::automatic: break;
    }
    std::vector<ChosenPlane> planes = {{FoldPlane::above, kFromAbove}, {FoldPlane::front, kFromTheFront}};
    // From the side, or the other side of what is known, would be no gain.
    const ChosenPlane leaning = face();
    const Point3& toward = leaning.view.toward;
    if (std::max({std::abs(toward.x), std::abs(toward.y), std::abs(toward.z)}) < kNearlyOne) planes.push_back(leaning);
    return planes;
}

}  // namespace tactics
