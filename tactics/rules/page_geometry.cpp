// SPDX-License-Identifier: Apache-2.0
#include "tactics/rules/page_geometry.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tactics {

namespace {

// Short enough that what is said of a piece (where it is near to what, how far along) is said of a fingertip.
constexpr double kPiece = 1.5;
constexpr double kMostPieces = 1e6;  // then pieces get longer
constexpr std::size_t kMostContacts = 1'000'000;
constexpr std::size_t kMostPairs = 300'000'000;
// Two parts of one line that touch although the way along it is longer than this many widths have come back to each other.
constexpr double kComesBack = 4;

double length_of(const std::vector<Point>& points, bool closed) { return tactics::length_of(Stroke{points, closed}); }

std::optional<Box> box_of(const BrailleLine& line, const Page& page) {
    std::size_t first = 0, end = line.cells.size();
    while (first < end && line.cells[first] == 0) ++first;
    while (end > first && line.cells[end - 1] == 0) --end;
    if (first == end) return std::nullopt;
    bool eight = false;
    for (const std::uint8_t cell : line.cells) eight = eight || (cell & 0xc0) != 0;
    const double reach = page.braille_dot / 2, pitch = page.cell.dot_pitch;
    return Box{line.first_dot.x + static_cast<double>(first) * page.cell.cell_pitch - reach, line.first_dot.y - reach,
               line.first_dot.x + static_cast<double>(end - 1) * page.cell.cell_pitch + pitch + reach,
               line.first_dot.y + (eight ? 3 : 2) * pitch + reach};
}

}  // namespace

PageGeometry::PageGeometry(const Page& of) : page(of) {
    double total = 0;
    for (const PageStroke& stroke : page.strokes) total += length_of(stroke.points, stroke.closed);
    for (const Area& area : page.areas)
        for (const auto& ring : area.rings) total += length_of(ring, true);
    const double step = std::max(kPiece, total / kMostPieces);
    for (std::size_t i = 0; i < page.strokes.size(); ++i)
        add_chain(page.strokes[i].points, {.owner = i, .closed = page.strokes[i].closed, .half_width = page.strokes[i].width / 2},
                  step);
    for (std::size_t i = 0; i < page.areas.size(); ++i)
        for (const auto& ring : page.areas[i].rings) add_chain(ring, {.ring = true, .owner = i, .closed = true}, step);
    for (const BrailleLine& line : page.braille)
        if (const auto box = box_of(line, page)) braille.push_back(*box);
    sort_into_bands();
    find_contacts();
    find_figures();
}

void PageGeometry::add_chain(const std::vector<Point>& points, Chain chain, double step) {
    if (points.empty()) return;
    chain.first = pieces.size();
    const std::size_t sides = chain.closed ? points.size() : std::max<std::size_t>(points.size() - 1, 1);
    for (std::size_t i = 0; i < sides; ++i) {
        const Point a = points[i], b = points[i + 1 < points.size() ? i + 1 : chain.closed ? 0 : i];
        const double side = distance(a, b);
        if (side == 0 && (i > 0 || sides > 1)) continue;
        const auto cuts = static_cast<std::size_t>(std::max(1.0, std::ceil(side / step)));
        const auto at = [&](std::size_t k) {
            const double t = static_cast<double>(k) / static_cast<double>(cuts);
            return k == cuts ? b : Point{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
        };
        for (std::size_t k = 0; k < cuts; ++k)
            pieces.push_back({{at(k), at(k + 1)},
                              static_cast<std::uint32_t>(chains.size()),
                              chain.length + side * static_cast<double>(k) / static_cast<double>(cuts)});
        longest_piece = std::max(longest_piece, side / static_cast<double>(cuts));
        chain.length += side;
    }
    if (pieces.size() == chain.first) pieces.push_back({{points[0], points[0]}, static_cast<std::uint32_t>(chains.size()), 0});
    chain.count = pieces.size() - chain.first;
    chains.push_back(chain);
}

Point PageGeometry::point_at(const Station& station) const {
    const Chain& chain = chains[station.chain];
    double along = station.along;
    if (chain.closed && chain.length > 0) along -= std::floor(along / chain.length) * chain.length;
    const auto begin = pieces.begin() + static_cast<std::ptrdiff_t>(chain.first);
    auto piece = std::upper_bound(begin, begin + static_cast<std::ptrdiff_t>(chain.count), along,
                                  [](double value, const Piece& p) { return value < p.along; });
    if (piece != begin) --piece;
    const Segment& line = piece->line;
    const double length = distance(line.a, line.b), t = length > 0 ? std::clamp((along - piece->along) / length, 0.0, 1.0) : 0;
    return {line.a.x + t * (line.b.x - line.a.x), line.a.y + t * (line.b.y - line.a.y)};
}

Box PageGeometry::box_of_piece(std::size_t piece, double margin) const {
    return tactics::box_of(pieces[piece].line, chains[pieces[piece].chain].half_width + margin);
}

std::vector<Point> PageGeometry::points_of(const Chain& chain) const {
    std::vector<Point> points;
    for (std::size_t i = chain.first; i < chain.first + chain.count; ++i) points.push_back(pieces[i].line.a);
    if (!chain.closed) points.push_back(pieces[chain.first + chain.count - 1].line.b);
    return points;
}

double PageGeometry::extent_of(const std::vector<std::uint32_t>& of, double enough) const {
    std::vector<Point> points;
    double widest = 0;
    Box box = kNothing;
    for (const std::uint32_t c : of) {
        widest = std::max(widest, chains[c].half_width * 2);
        for (std::size_t i = chains[c].first; i < chains[c].first + chains[c].count; ++i)
            for (const Point& p : {pieces[i].line.a, pieces[i].line.b}) {
                box.take(p);
                if (std::max(box.width(), box.height()) + widest >= enough) return std::max(box.width(), box.height()) + widest;
                points.push_back(p);
            }
    }
    return greatest_extent(points) + widest;
}

void PageGeometry::sort_into_bands() {
    constexpr double kMostBands = 4000;
    band_ = std::max(1.0, page.height / kMostBands);
    bands_.resize(static_cast<std::size_t>(page.height / band_) + 1);
    const auto band_of = [this](double y) {
        return y > 0 ? std::min(static_cast<std::size_t>(std::min(y / band_, kMostBands + 1)), bands_.size() - 1) : 0;
    };
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (!chains[pieces[i].chain].ring) continue;
        const Box box = tactics::box_of(pieces[i].line, 0);
        const std::size_t area = chains[pieces[i].chain].owner;
        for (std::size_t b = band_of(box.top); b <= band_of(box.bottom); ++b) {
            // The pieces stand in the order of their areas.
            if (bands_[b].empty() || bands_[b].back().area != area) bands_[b].push_back({area, box.left, box.right});
            Part& part = bands_[b].back();
            part.left = std::min(part.left, box.left);
            part.right = std::max(part.right, box.right);
            part.pieces.push_back(static_cast<std::uint32_t>(i));
        }
    }
    for (auto& band : bands_) {
        std::sort(band.begin(), band.end(), [](const Part& a, const Part& b) { return a.left < b.left; });
        tell_farthest(band);
    }
}

double PageGeometry::tell_farthest(std::span<Part> parts) {
    if (parts.empty()) return -kNowhere;
    const std::size_t middle = parts.size() / 2;
    const double beside = std::max(tell_farthest(parts.first(middle)), tell_farthest(parts.subspan(middle + 1)));
    return parts[middle].farthest = std::max(parts[middle].right, beside);
}

bool PageGeometry::black_among(std::span<const Part> parts, Point p) const {
    if (parts.empty()) return false;
    const std::size_t middle = parts.size() / 2;
    const Part& part = parts[middle];
    if (!(p.x <= part.farthest)) return false;
    if (black_among(parts.first(middle), p)) return true;
    if (!(p.x >= part.left)) return false;  // nor are later ones, which begin farther right
    bool inside = false;
    if (p.x <= part.right)
        for (const std::uint32_t i : part.pieces)
            if (ray_meets(p, pieces[i].line.a, pieces[i].line.b)) inside = !inside;
    return inside || black_among(parts.subspan(middle + 1), p);
}

bool PageGeometry::black_area_at(Point p) const {
    const double number = p.y / band_;
    const std::size_t band = number > 0 ? std::min(static_cast<std::size_t>(std::min(number, 1e9)), bands_.size() - 1) : 0;
    return black_among(bands_[band], p);
}

bool PageGeometry::is_hole(const Chain& ring) const {
    constexpr double kBeside = 1e-3;
    double doubled_area = 0;
    std::size_t longest = ring.first;
    for (std::size_t i = ring.first; i < ring.first + ring.count; ++i) {
        const Segment &s = pieces[i].line, &l = pieces[longest].line;
        doubled_area += s.a.x * s.b.y - s.b.x * s.a.y;
        if (distance(s.a, s.b) > distance(l.a, l.b)) longest = i;
    }
    const Segment& s = pieces[longest].line;
    const double length = distance(s.a, s.b), side = doubled_area > 0 ? kBeside : -kBeside;
    if (!(length > 0)) return false;
    return !black_area_at(
        {(s.a.x + s.b.x) / 2 - (s.b.y - s.a.y) / length * side, (s.a.y + s.b.y) / 2 + (s.b.x - s.a.x) / length * side});
}

Grid PageGeometry::grid_of_ink() const {
    std::vector<Box> boxes;
    boxes.reserve(pieces.size());
    for (std::size_t i = 0; i < pieces.size(); ++i) boxes.push_back(box_of_piece(i, kTouch / 2));
    return {std::move(boxes), page.width, page.height};
}

void PageGeometry::find_contacts() {
    ink = grid_of_ink();
    contacts_of.resize(chains.size());
    complete = ink.pairs(kMostPairs, [this](std::size_t i, std::size_t j) {
        const Piece &p = pieces[i], &q = pieces[j];
        const Chain &a = chains[p.chain], &b = chains[q.chain];
        const double reach = a.half_width + b.half_width + kTouch;
        // Most pairs in a busy page are neighbours on one line.
        if (p.chain == q.chain && (j == i + 1 || way(a, p.along, q.along) <= kComesBack * reach)) return true;
        const Nearest near = nearest(p.line, q.line);
        if (near.distance > reach) return true;
        const double from = p.along + distance(p.line.a, near.one), to = q.along + distance(q.line.a, near.other);
        if (p.chain == q.chain && way(a, from, to) <= kComesBack * reach) return true;
        const auto index = static_cast<std::uint32_t>(contacts.size());
        contacts_of[p.chain].push_back({from, index, false});
        contacts_of[q.chain].push_back({to, index, true});
        contacts.push_back({{p.chain, from}, {q.chain, to}, near.distance, near.one});
        return contacts.size() < kMostContacts;
    });
    for (auto& meetings : contacts_of)
        std::sort(meetings.begin(), meetings.end(), [](const Meets& a, const Meets& b) {
            return a.along < b.along || (a.along == b.along && a.contact < b.contact);
        });
}

void PageGeometry::find_figures() {
    std::vector<std::uint32_t> parent(chains.size());
    std::iota(parent.begin(), parent.end(), 0u);
    const auto root = [&parent](std::uint32_t c) {
        while (parent[c] != c) c = parent[c] = parent[parent[c]];
        return c;
    };
    for (const Contact& contact : contacts) {
        const std::uint32_t a = root(static_cast<std::uint32_t>(contact.one.chain)),
                            b = root(static_cast<std::uint32_t>(contact.other.chain));
        parent[std::max(a, b)] = std::min(a, b);
    }
    figure_of.resize(chains.size());
    for (std::uint32_t c = 0; c < chains.size(); ++c) {
        if (root(c) == c) {
            figure_of[c] = static_cast<std::uint32_t>(figures.size());
            figures.emplace_back();
        }
        figure_of[c] = figure_of[root(c)];
        figures[figure_of[c]].push_back(c);
    }
}

}  // namespace tactics
