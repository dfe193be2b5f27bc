// SPDX-License-Identifier: Apache-2.0
#include "filters/inked_fills.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "filters/filled_parts.h"
#include "filters/opencv.h"
#include "filters/outline.h"
#include "filters/outlined_fills.h"
#include "filters/smooth.h"
#include "filters/texture_choice.h"
#include "tactics/geometry/course.h"
#include "tactics/geometry/skeleton.h"
#include "tactics/layout/texture.h"

namespace tactics {

namespace {

// mm on the page. A surface must hold what is felt as a texture (6.4 mm) with the gap to its outline on both sides.
constexpr double kNarrowestTexture = 11;

// Its rings in mm.
Area area_of(const FilledPart& part, double mm) {
    InkMap map(part.mask.width, part.mask.height);
    for (int y = 0; y < part.mask.height; ++y)
        for (int x = 0; x < part.mask.width; ++x) map.row(y)[x] = part.mask.row(y)[x] != 0 ? 1 : 0;
    Area area;
    for (const Outline& outline : outlines_of(map))
        for (const OutlineRing& ring : outline.rings) {
            if (ring.extent * mm < 2) continue;
            std::vector<Point> points = smooth(ring.points, true);
            points.push_back(points.front());
            points = course_of(points, 0.2 / mm);
            points.pop_back();
            if (points.size() < 3) continue;
            for (Point& p : points) p = {(p.x + part.left) * mm, (p.y + part.top) * mm};
            area.rings.push_back(std::move(points));
        }
    return area;
}

// A texture for each kind, in the order of the parts; none if there are too many kinds, or one colour is all there is.
std::vector<int> textures_of(const std::vector<FilledPart>& parts) {
    std::vector<FillKind> kinds;
    std::vector<std::size_t> kind_of;
    for (const FilledPart& part : parts) {
        const auto same =
            std::find_if(kinds.begin(), kinds.end(), [&](const FillKind& kind) { return same_kind(kind, part.kind); });
        kind_of.push_back(static_cast<std::size_t>(same - kinds.begin()));
        if (same == kinds.end()) kinds.push_back(part.kind);
    }
    const bool any_hatch = std::any_of(kinds.begin(), kinds.end(), [](const FillKind& kind) { return kind.hatch; });
    if (kinds.size() > textures().size() || (kinds.size() < 2 && !any_hatch)) return {};
    // The ground stays blank: it is beside all of them.
    std::vector<std::vector<double>> beside(kinds.size() + 1, std::vector<double>(kinds.size() + 1, 1));
    for (std::size_t i = 0; i <= kinds.size(); ++i) beside[i][0] = beside[0][i] = 100;
    std::vector<double> grey{255};
    for (const FillKind& kind : kinds) grey.push_back(0.299 * kind.colour[0] + 0.587 * kind.colour[1] + 0.114 * kind.colour[2]);
    const std::vector<int> chosen = choose_textures(beside, grey);
    std::vector<int> textures;
    for (const std::size_t kind : kind_of) textures.push_back(chosen[kind + 1]);
    return textures;
}

}  // namespace

std::vector<Area> take_fills(Image& picture) {
    const double mm = picture.mm_per_pixel;
    if (std::min(picture.width, picture.height) * mm < kNarrowestTexture) return {};
    FilledParts found = filled_parts_in(picture, mm);
    draw_by_outlines(picture, found);
    std::erase_if(found.parts, [&](const FilledPart& part) {
        return part.width * mm < kNarrowestTexture && part.size < 0.1 * picture.width * picture.height;
    });
    const std::vector<int> textures = textures_of(found.parts);
    std::vector<Area> areas;
    for (std::size_t i = 0; i < textures.size(); ++i) {
        Area area = area_of(found.parts[i], mm);
        area.texture = textures[i];
        if (area.texture > 0 && !area.rings.empty()) areas.push_back(std::move(area));
    }
    return areas;
}

std::optional<Point> hatched_place(const Image& picture) {
    constexpr double kPage = 250;  // mm of the longer side
    const FilledParts found = filled_parts_in(picture, kPage / std::max(picture.width, picture.height));
    std::optional<Point> place;
    double most = 0;
    for (const FilledPart& part : found.parts) {
        if (!part.kind.hatch) continue;
        if (!same_kind(part.kind, found.parts.front().kind)) return std::nullopt;
        cv::Mat deep;
        cv::distanceTransform(view_of(part.mask), deep, cv::DIST_L2, cv::DIST_MASK_PRECISE);
        double own = 0;
        cv::Point at;
        cv::minMaxLoc(deep, nullptr, &own, nullptr, &at);
        if (own > most) {
            most = own;
            place = Point{part.left + at.x + 0.5, part.top + at.y + 0.5};
        }
    }
    return place;
}

}  // namespace tactics
