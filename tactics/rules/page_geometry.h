// SPDX-License-Identifier: Apache-2.0
// The geometry of a page for the rules, computed once: lines and edges cut into short pieces, contacts of ink, connected parts,
// black areas.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "tactics/geometry/grid.h"
#include "tactics/page.h"

namespace tactics {

/// Edges no further apart than this touch: what a file's hundredths of a millimetre can do to two points.
inline constexpr double kTouch = 0.02;

/// One thing that has an edge: a line, or one ring of an area.
struct Chain {
    bool ring = false;
    std::size_t owner = 0;  ///< index into the page's strokes or areas
    bool closed = false;
    double half_width = 0;  ///< 0 for a ring
    double length = 0;      ///< mm of its middle line
    std::size_t first = 0;  ///< piece
    std::size_t count = 0;  ///< of pieces, at least 1
};

/// A short straight part of a chain.
struct Piece {
    Segment line;
    std::uint32_t chain = 0;
    double along = 0;  ///< mm from the chain's beginning to line.a
};

/// A place on the middle line of a chain.
struct Station {
    std::size_t chain = 0;
    double along = 0;
};

/// The ink of two chains, or of one chain that comes back to itself, meets here.
struct Contact {
    Station one;
    Station other;
    double apart = 0;  ///< mm between the two places on the middle lines
    Point at;          ///< the place of `one`
};

struct PageGeometry {
    explicit PageGeometry(const Page& page);

    const Page& page;
    std::vector<Chain> chains;
    std::vector<Piece> pieces;
    double longest_piece = 0;  ///< mm
    Grid ink;                  ///< the boxes of the pieces' ink
    std::vector<Contact> contacts;
    /// A contact as one of its chains has it.
    struct Meets {
        double along = 0;  ///< mm from the chain's beginning
        std::uint32_t contact = 0;
        bool turned = false;  ///< this chain is `other` of the contact
    };
    std::vector<std::vector<Meets>> contacts_of;      ///< of each chain, in their order along it; with itself: twice
    std::vector<std::uint32_t> figure_of;             ///< chains that touch, directly or through others, are one figure
    std::vector<std::vector<std::uint32_t>> figures;  ///< their chains
    std::vector<Box> braille;                         ///< each line of braille from its first cell with a dot to its last
    bool complete = true;                             ///< false: there is too much on the page to know all contacts

    Role role_of(const Chain& chain) const { return chain.ring ? page.areas[chain.owner].role : page.strokes[chain.owner].role; }
    /// Mm along a chain between two of its places, the short way round if it is closed.
    static double way(const Chain& chain, double from, double to) {
        const double straight = from > to ? from - to : to - from;
        return chain.closed && chain.length - straight < straight ? chain.length - straight : straight;
    }
    Point point_at(const Station& station) const;  ///< beyond an open end: the end
    /// Whether it is within an area, by the even-odd rule for each. Ignores lines.
    bool black_area_at(Point point) const;
    /// The inside of this ring, just beside its edge, is white.
    bool is_hole(const Chain& ring) const;
    /// The greatest distance within the ink of these chains; where that is `enough` or more, only that it is.
    double extent_of(const std::vector<std::uint32_t>& of, double enough) const;
    std::vector<Point> points_of(const Chain& chain) const;
    Box box_of_piece(std::size_t piece, double margin) const;

private:
    void add_chain(const std::vector<Point>& points, Chain chain, double step);
    Grid grid_of_ink() const;
    void find_contacts();
    void find_figures();
    void sort_into_bands();

    /// Pieces of an area's rings within a band, and from where to where they go.
    struct Part {
        std::size_t area = 0;
        double left = 0, right = 0;
        std::vector<std::uint32_t> pieces = {};
        double farthest = 0;  ///< right of all in the half, quarter ... of its band that it is the middle of
    };
    /// A band's parts are sorted by their beginnings and searched by halving, so only few of thousands are visited.
    static double tell_farthest(std::span<Part> parts);
    bool black_among(std::span<const Part> parts, Point point) const;
    double band_ = 1;
    std::vector<std::vector<Part>> bands_;  ///< what each strip of the page, band_ high, holds
};

}  // namespace tactics
