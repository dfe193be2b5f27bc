// SPDX-License-Identifier: Apache-2.0
#include "tests/filters/artwork_laws.h"

#include <cmath>

namespace tactics {

namespace {

constexpr double kWidest = 4.0;  // mm; the thickest line of any medium

std::string law_of(const Image& image) {
    if (image.width < 1 || image.height < 1) return "a picture without pixels";
    if (image.channels != 1 && image.channels != 3) return "a picture of " + std::to_string(image.channels) + " channels";
    if (image.pixels.size() != image.row_bytes() * static_cast<std::size_t>(image.height))
        return "a picture whose pixels do not fill its shape";
    if (!(image.mm_per_pixel > 0) || !std::isfinite(image.mm_per_pixel)) return "a picture that has lost its size in mm";
    return "";
}

std::string law_of(const EdgeMap& edges) {
    const std::size_t count = static_cast<std::size_t>(edges.width) * static_cast<std::size_t>(edges.height);
    if (edges.width < 1 || edges.height < 1) return "an edge map without pixels";
    if (edges.strength.size() != count) return "strengths that do not fill the map";
    if (!edges.normal.empty() && edges.normal.size() != count) return "normals that do not fill the map";
    if (!(edges.mm_per_pixel > 0) || !std::isfinite(edges.mm_per_pixel)) return "an edge map that has lost its size in mm";
    for (const float s : edges.strength)
        if (!std::isfinite(s) || s < 0) return "a strength of " + std::to_string(s);
    for (const float n : edges.normal)
        if (!(n >= 0) || n >= 3.1415928f) return "a normal of " + std::to_string(n);
    return "";
}

std::string law_of(const Drawing& drawing) {
    if (!(drawing.width > 0) || !(drawing.height > 0) || !std::isfinite(drawing.width) || !std::isfinite(drawing.height))
        return "a drawing without size";
    const auto outside = [&](Point p) {
        constexpr double kSlack = kWidest / 2;
        return !(p.x >= -kSlack) || !(p.y >= -kSlack) || !(p.x <= drawing.width + kSlack) || !(p.y <= drawing.height + kSlack);
    };
    for (const Stroke& stroke : drawing.strokes) {
        if (stroke.points.size() < (stroke.closed ? 3u : 2u))
            return "a stroke of " + std::to_string(stroke.points.size()) + " points";
        if (!std::isfinite(stroke.strength) || stroke.strength < 0)
            return "a stroke of strength " + std::to_string(stroke.strength);
        for (const Point p : stroke.points)
            if (outside(p)) return "a stroke that leaves the drawing at " + std::to_string(p.x) + " " + std::to_string(p.y);
    }
    for (const Area& area : drawing.areas) {
        if (area.rings.empty()) return "an area without a ring";
        for (const auto& ring : area.rings) {
            if (ring.size() < 3) return "a ring of " + std::to_string(ring.size()) + " points";
            for (const Point p : ring)
                if (outside(p)) return "an area that leaves the drawing";
        }
    }
    if (!drawing.picture) return "";
    if (drawing.picture->channels != 1) return "a picture in colour under a drawing";
    for (const std::uint8_t v : drawing.picture->pixels)
        if (v != 0 && v != 255) return "grey in the picture under a drawing";
    return law_of(*drawing.picture);
}

std::string law_of(const RegionTree& tree) {
    const std::size_t count = static_cast<std::size_t>(tree.width) * static_cast<std::size_t>(tree.height), faces = tree.faces();
    if (tree.width < 1 || tree.height < 1 || tree.face.size() != count) return "faces that do not fill the picture";
    if (!(tree.mm_per_pixel > 0)) return "regions that have lost their size in mm";
    if (tree.nodes.size() != 2 * faces - 1) return "not as many nodes as a tree of its faces has";
    for (const std::uint32_t face : tree.face)
        if (face >= faces) return "a pixel of no face";
    double area = 0;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        const RegionNode& node = tree.nodes[i];
        if (i < faces) area += node.area;
        if ((node.children[0] < 0) != (i < faces)) return "a face with children, or a node without";
        if ((node.parent < 0) != (i + 1 == tree.nodes.size())) return "more or fewer than one whole";
        if (node.parent >= 0 && tree.nodes[static_cast<std::size_t>(node.parent)].level < node.level)
            return "a node above its parent's level";
        if (!(node.level >= 0) || node.level > 255) return "a level of " + std::to_string(node.level);
    }
    if (area != static_cast<double>(count)) return "faces whose areas are not the picture";
    for (const RegionArc& arc : tree.arcs)
        if (arc.faces[0] >= faces || arc.faces[1] >= faces || arc.faces[0] == arc.faces[1] || !(arc.strength >= 0))
            return "an arc between no two faces";
    return "";
}

bool same(const RegionTree& a, const RegionTree& b) {
    if (a.face != b.face || a.arcs.size() != b.arcs.size() || a.nodes.size() != b.nodes.size()) return false;
    for (std::size_t i = 0; i < a.arcs.size(); ++i)
        if (a.arcs[i].level != b.arcs[i].level || a.arcs[i].faces != b.arcs[i].faces) return false;
    for (std::size_t i = 0; i < a.nodes.size(); ++i)
        if (a.nodes[i].level != b.nodes[i].level || a.nodes[i].parent != b.nodes[i].parent) return false;
    return true;
}

bool same(const Image& a, const Image& b) {
    return a.width == b.width && a.height == b.height && a.channels == b.channels && a.mm_per_pixel == b.mm_per_pixel &&
           a.pixels == b.pixels;
}

bool same(const EdgeMap& a, const EdgeMap& b) {
    return a.width == b.width && a.height == b.height && a.thinned == b.thinned && a.strength == b.strength &&
           a.normal == b.normal;
}

bool same(const std::vector<Point>& a, const std::vector<Point>& b) {
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (a[i].x != b[i].x || a[i].y != b[i].y) return false;
    return true;
}

bool same(const Drawing& a, const Drawing& b) {
    if (a.width != b.width || a.height != b.height || a.strokes.size() != b.strokes.size() || a.areas.size() != b.areas.size())
        return false;
    for (std::size_t i = 0; i < a.strokes.size(); ++i) {
        const Stroke &s = a.strokes[i], &t = b.strokes[i];
        if (s.closed != t.closed || s.line != t.line || s.strength != t.strength || !same(s.points, t.points)) return false;
    }
    for (std::size_t i = 0; i < a.areas.size(); ++i) {
        if (a.areas[i].rings.size() != b.areas[i].rings.size()) return false;
        for (std::size_t k = 0; k < a.areas[i].rings.size(); ++k)
            if (!same(a.areas[i].rings[k], b.areas[i].rings[k])) return false;
    }
    if (a.picture.has_value() != b.picture.has_value()) return false;
    return !a.picture || same(*a.picture, *b.picture);
}

}  // namespace

std::string broken_law(const Artwork& artwork) {
    return std::visit([](const auto& a) { return law_of(a); }, artwork);
}

bool same(const Artwork& a, const Artwork& b) {
    if (a.index() != b.index()) return false;
    return std::visit([&](const auto& x) { return same(x, std::get<std::decay_t<decltype(x)>>(b)); }, a);
}

Kind kind_after(const Filter& filter, Kind given) { return filter.gives == 0 ? given : static_cast<Kind>(filter.gives); }

}  // namespace tactics
