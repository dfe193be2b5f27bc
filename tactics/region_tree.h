// SPDX-License-Identifier: Apache-2.0
// A picture as nested regions: closed boundaries by construction, from the finest regions up to the whole picture.
//
// It has three linked parts. *Faces*, the finest regions, are connected sets of pixels and cover the picture. *Arcs* are the
// boundaries between two faces, from junction to junction along the edges of pixels; *junctions* are the corners of pixels where
// three or four faces meet, or two faces and the picture's frame. *Nodes* are the tree: first the faces, then the nodes merged
// from two others, in order of merging, last the whole picture. Any set of nodes in which none contains another is a set of
// things with closed outlines.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tactics/drawing.h"
#include "tactics/image.h"

namespace tactics {

/// The outside of the picture's frame.
inline constexpr std::uint32_t kNoFace = 0xffffffff;

struct RegionArc {
    std::vector<Point>
        points;           ///< corners of pixels, in pixels, neighbours one pixel apart; a closed one does not repeat its first
    bool closed = false;  ///< a loop that meets no junction
    std::array<int, 2> junctions{-1, -1};                  ///< at its first and last point; -1 if it is closed
    std::array<std::uint32_t, 2> faces{kNoFace, kNoFace};  ///< to the left and right of its direction, y pointing down
    float strength = 0;                                    ///< strength of the contour map, 0 to 255: the mean along it
    float coarse = 0;                                      ///< the same in the coarse map
    float weakest = 0;                                     ///< a fifth of it is weaker than this
    float level = 0;                ///< 0 to 255: it is a boundary until nodes of a higher level are merged
    std::array<float, 3> unlike{};  ///< difference of its two nodes at their merging: lightness, colour, texture; 0 to 1
};

struct RegionNode {
    int parent = -1;                      ///< -1: the whole picture
    std::array<int, 2> children{-1, -1};  ///< -1: a face
    float level = 0;                      ///< of the merging that made it, 0 for a face; never above that of its parent
    double area = 0;                      ///< square pixels
    PixelBox box;
    std::array<float, 3> colour{};  ///< mean, CIELAB
};

/// A thin thing that bounds no region, such as a mast, a wire or a whisker; pixels as in RegionArc, but anywhere.
struct RegionLine {
    std::vector<Point> points;
    float strength = 0;                      ///< as an arc's
    std::array<std::size_t, 2> leads{0, 0};  ///< number of points at its beginning and end that are not part of it but lead on
                                             ///< from it
};

struct RegionTree {
    int width = 0;
    int height = 0;
    double mm_per_pixel = 0;
    PixelBox inside;                  ///< the picture within bars and borders
    bool learned = false;             ///< made from a map fitted to people's contours
    std::vector<std::uint32_t> face;  ///< of each pixel
    std::vector<Point> junctions;
    std::vector<RegionArc> arcs;
    std::vector<RegionNode> nodes;  ///< 2 n - 1 for n faces; node i of a face i; the root last
    std::vector<RegionLine> lines;

    std::size_t faces() const { return (nodes.size() + 1) / 2; }
};

/// The region of each pixel after everything below that level is merged, numbered from 0 in the order of their first pixels.
std::vector<std::uint32_t> regions_at(const RegionTree& tree, float level);

/// The boundaries as an edge map: each arc's level at the pixels beside it. Thinned: one pixel wide except at corners.
EdgeMap levels_of(const RegionTree& tree);

/// Number of pixel sides along an arc.
double steps_of(const RegionArc& arc);

/// Calls visit(x, y) for each step of an arc, with the pixel whose left or upper side the step is.
template <typename Visit>
void for_each_side(const RegionArc& arc, Visit visit) {
    for (std::size_t i = 0; i + (arc.closed ? 0 : 1) < arc.points.size(); ++i) {
        const Point a = arc.points[i], b = arc.points[(i + 1) % arc.points.size()];
        visit(static_cast<int>(a.x < b.x ? a.x : b.x), static_cast<int>(a.y < b.y ? a.y : b.y));
    }
}

}  // namespace tactics
