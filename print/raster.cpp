// SPDX-License-Identifier: Apache-2.0
#include "print/raster.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "print/band.h"
#include "print/letters.h"
#include "tactics/error.h"
#include "tactics/readers/read.h"
#include "tactics/text/utf8.h"
#include "tactics/units.h"

namespace tactics {

namespace {

PixelSize checked(const Page& page, double width, double height, std::string_view format) {
    const double side = std::max(width, height);
    if (side > kMaxSide || width * height > static_cast<double>(kMaxPixels)) {
        const double shrink = std::min(kMaxSide / side, std::sqrt(static_cast<double>(kMaxPixels) / (width * height)));
        // A hundredth less, so that the rounding to whole pixels stays inside too.
        const double dpi = std::floor(width * shrink * 0.99 / page.width * kMmPerInch);
        throw Error(
            Fault::usage, format,
            phrase("the page would be {0} x {1} pixels; ask for at most {2} dpi ({3} pixels across)", to_text(std::round(width)),
                   to_text(std::round(height)), to_text(dpi), to_text(std::floor(width * shrink * 0.99))));
    }
    return {std::max(1, static_cast<int>(std::lround(width))), std::max(1, static_cast<int>(std::lround(height)))};
}

std::vector<Edge> edges_of(const Area& area) {
    std::vector<Edge> edges;
    for (const auto& ring : area.rings)
        for (std::size_t i = 0; i < ring.size(); ++i) add_edge(edges, ring[i], ring[(i + 1) % ring.size()]);
    sort_edges(edges);
    return edges;
}

// The outlines of letters on the page, with curves as short straight edges.
std::vector<Edge> edges_of(const PrintLine& line, const std::map<char32_t, Letter>& letters) {
    constexpr int kPieces = 8;  // of a curve, which spans at most a quarter of a letter
    std::vector<Edge> edges;
    const double scale = line.size / 1000;
    double pen = 0;
    for (std::string_view rest = line.text; !rest.empty();) {
        const auto found = letters.find(take_letter(rest));
        if (found == letters.end()) continue;
        const auto corner = [&](const LetterCorner& c) {
            return Point{line.baseline.x + (pen + c.x) * scale, line.baseline.y - c.y * scale};
        };
        Point start, last;
        for (const OutlineStep& step : found->second.outline) {
            const LetterCorner* c = step.corners;
            if (step.kind == OutlineStep::Kind::move) {
                add_edge(edges, last, start);
                start = last = corner(c[0]);
            } else if (step.kind == OutlineStep::Kind::line) {
                add_edge(edges, last, corner(c[0]));
                last = corner(c[0]);
            } else {
                const Point a = last, b = corner(c[0]), d = corner(c[1]), e = corner(c[2]);
                for (int i = 1; i <= kPieces; ++i) {
                    const double t = static_cast<double>(i) / kPieces, u = 1 - t;
                    const double wa = u * u * u, wb = 3 * u * u * t, wd = 3 * u * t * t, we = t * t * t;
                    const Point p{wa * a.x + wb * b.x + wd * d.x + we * e.x, wa * a.y + wb * b.y + wd * d.y + we * e.y};
                    add_edge(edges, last, p);
                    last = p;
                }
            }
        }
        add_edge(edges, last, start);
        pen += found->second.advance;
    }
    sort_edges(edges);
    return edges;
}

// Nearest pixel: at the picture's own size every pixel falls on itself.
class PictureDrawer {
public:
    PictureDrawer(const Bitmap& picture, const Page& page, PixelSize size) : picture_(picture), page_(page), size_(size) {
        columns_.resize(static_cast<std::size_t>(size.width));
        for (int x = 0; x < size.width; ++x) {
            const double mm = (x + 0.5) / size.width * page.width;
            columns_[static_cast<std::size_t>(x)] = index(mm - picture.place.left, picture.place.width, picture.width);
        }
    }

    void draw(Band& band) const {
        for (int y = band.first(); y < band.end(); ++y) {
            const double mm = (y + 0.5) / size_.height * page_.height;
            const int from_row = index(mm - picture_.place.top, picture_.place.height, picture_.height);
            if (from_row < 0) continue;
            const std::uint8_t* from = picture_.bits.data() + picture_.row_bytes() * static_cast<std::size_t>(from_row);
            std::uint8_t* to = band.row(y);
            for (std::size_t x = 0; x < columns_.size(); ++x) {
                const int column = columns_[x];
                if (column >= 0 && (from[column / 8] & (0x80 >> (column % 8))) != 0)
                    to[x / 8] = static_cast<std::uint8_t>(to[x / 8] | (0x80u >> (x % 8)));
            }
        }
    }

private:
    static int index(double mm, double length, int count) {
        const double at = std::floor(mm / length * count);
        return at >= 0 && at < count ? static_cast<int>(at) : -1;
    }

    const Bitmap& picture_;
    const Page& page_;
    PixelSize size_;
    std::vector<int> columns_;
};

}  // namespace

PixelSize pixels_at(const Page& page, double dpi, std::string_view format) {
    return checked(page, page.width / kMmPerInch * dpi, page.height / kMmPerInch * dpi, format);
}

PixelSize pixels_across(const Page& page, int width, int height, std::string_view format) {
    return checked(page, width, height > 0 ? height : width * page.height / page.width, format);
}

void draw_rows(const Page& page, PixelSize size, const RowSink& sink) {
    constexpr std::size_t kBandBytes = 4'000'000;
    Band band(page, size.width, size.height);
    const std::size_t fit = kBandBytes / band.row_bytes();
    const int rows = static_cast<int>(std::clamp<std::size_t>(fit, 1, static_cast<std::size_t>(size.height)));

    std::vector<std::vector<Edge>> areas;
    for (const Area& area : page.areas) areas.push_back(edges_of(area));
    const auto letters = letters_of(page);
    std::vector<std::vector<Edge>> print;
    for (const PrintLine& line : page.print) print.push_back(edges_of(line, letters));
    std::vector<Point> dots;
    for (const BrailleLine& line : page.braille)
        for (const Point& dot : dots_of(line, page.cell)) dots.push_back(dot);
    std::optional<PictureDrawer> picture;
    if (page.picture) picture.emplace(*page.picture, page, size);

    for (int first = 0; first < size.height; first += rows) {
        band.begin(first, std::min(rows, size.height - first));
        if (picture) picture->draw(band);
        for (const auto& edges : areas) band.fill(edges, FillRule::even_odd);
        for (const PageStroke& stroke : page.strokes) band.stroke(stroke);
        for (const Point& dot : dots) band.segment(dot, dot, page.braille_dot / 2);
        for (const auto& edges : print) band.fill(edges, FillRule::non_zero);
        for (int y = band.first(); y < band.end(); ++y) sink(band.row(y));
    }
}

}  // namespace tactics
