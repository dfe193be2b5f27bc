// SPDX-License-Identifier: Apache-2.0
#include "print/page_relief.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tactics/error.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr double kMostSamples = 400e6;  // A4 at 0.0125 mm; about ten seconds

// A raised piece of line with round ends; a dot if both ends are one.
struct Ridge {
    Point from;
    Point to;
    double radius = 0;
    double height = 0;
    bool flat = false;
    double top() const { return std::min(from.y, to.y) - radius; }
    double bottom() const { return std::max(from.y, to.y) + radius; }
};

// A side of an area's outline, from top to bottom.
struct Side {
    Point from;
    Point to;
    std::size_t area = 0;
    double top() const { return from.y; }
    double bottom() const { return to.y; }
};

// Those things that a row from the top downwards can meet.
template <typename Thing>
class Meeting {
public:
    explicit Meeting(std::vector<Thing> things) : waiting_(std::move(things)) {
        std::sort(waiting_.begin(), waiting_.end(), [](const Thing& a, const Thing& b) { return a.top() > b.top(); });
    }
    const std::vector<Thing>& at(double y) {
        std::erase_if(present_, [y](const Thing& thing) { return thing.bottom() < y; });
        while (!waiting_.empty() && waiting_.back().top() <= y) {
            if (waiting_.back().bottom() >= y) present_.push_back(waiting_.back());
            waiting_.pop_back();
        }
        return present_;
    }

private:
    std::vector<Thing> waiting_;  // the next one last
    std::vector<Thing> present_;
};

// Height over the ground at `distance` from the middle of a ridge: an arc of a circle through its edges and its crest,
// half an ellipse where it is higher than half as wide.
double round_height(double squared_distance, double radius, double height) {
    if (height > radius) return height * std::sqrt(std::max(0.0, 1 - squared_distance / (radius * radius)));
    const double arc = (radius * radius + height * height) / (2 * height);
    return std::sqrt(arc * arc - squared_distance) - (arc - height);
}

struct ReliefShape {
    double pitch = 0;           // mm
    double height = 0;          // mm
    bool flat = false;          // lines have a flat top and upright sides
    double grid = 1, axes = 1;  // as parts of height

    // mm, of a line.
    double height_of(const PageStroke& stroke) const {
        switch (kind_of(stroke)) {
            case LineKind::values: return height * axes;
            case LineKind::grid: return height * grid;
            case LineKind::drawn:
            case LineKind::inner:
            case LineKind::pattern: break;
        }
        return height;
    }
};

ReliefShape relief_shape(const Settings& settings) {
    return {settings.number("pitch"), settings.number("height"), settings.choice("profile") == "flat",
            settings.number("grid") / 100, settings.number("axes") / 100};
}

}  // namespace

class PageRelief::Surface {
public:
    Surface(const Page& page, const ReliefShape& shape)
        : page_(page), pitch_(shape.pitch), height_(shape.height), ridges_(ridges(page, shape)), sides_(sides(page)) {}

    // Heights in mm along the row at `y`.
    void row(double y, std::span<float> heights) {
        std::fill(heights.begin(), heights.end(), 0.0f);
        if (page_.picture) picture(*page_.picture, y, heights);
        areas(y, heights);
        for (const Ridge& ridge : ridges_.at(y)) raise(ridge, y, heights);
    }

private:
    static std::vector<Ridge> ridges(const Page& page, const ReliefShape& shape) {
        std::vector<Ridge> found;
        for (const PageStroke& stroke : page.strokes) {
            const std::size_t count = stroke.points.size();
            const double height = shape.height_of(stroke);
            for (std::size_t i = 0; i + 1 < count; ++i)
                found.push_back({stroke.points[i], stroke.points[i + 1], stroke.width / 2, height, shape.flat});
            if (stroke.closed && count > 0)
                found.push_back({stroke.points[count - 1], stroke.points[0], stroke.width / 2, height, shape.flat});
        }
        for (const BrailleLine& line : page.braille)
            for (const Point& dot : dots_of(line, page.cell))
                found.push_back({dot, dot, page.braille_dot / 2, shape.height, false});
        std::erase_if(found, [](const Ridge& ridge) { return !(ridge.radius > 0); });
        return found;
    }

    static std::vector<Side> sides(const Page& page) {
        std::vector<Side> found;
        for (std::size_t area = 0; area < page.areas.size(); ++area)
            for (const auto& ring : page.areas[area].rings)
                for (std::size_t i = 0; i < ring.size(); ++i) {
                    const Point a = ring[i], b = ring[(i + 1) % ring.size()];
                    if (a.y < b.y) found.push_back({a, b, area});
                    if (a.y > b.y) found.push_back({b, a, area});
                }
        return found;
    }

    // The first sample at or right of x.
    std::size_t first_from(double x, std::span<const float> heights) const {
        return static_cast<std::size_t>(std::clamp(std::ceil(x / pitch_ - 0.5), 0.0, static_cast<double>(heights.size())));
    }

    void fill(double left, double right, std::span<float> heights) const {
        const std::size_t end = first_from(right, heights);
        for (std::size_t x = first_from(left, heights); x < end; ++x) heights[x] = static_cast<float>(height_);
    }

    void picture(const Bitmap& bitmap, double y, std::span<float> heights) const {
        const Rect& place = bitmap.place;
        const double line = std::floor((y - place.top) / place.height * bitmap.height);
        if (!(line >= 0) || line >= bitmap.height) return;
        const std::uint8_t* bits = bitmap.bits.data() + bitmap.row_bytes() * static_cast<std::size_t>(line);
        const auto black = [&](int x) { return (bits[x / 8] >> (7 - x % 8) & 1u) != 0; };
        for (int x = 0; x < bitmap.width;) {
            int end = x + 1;
            while (end < bitmap.width && black(end) == black(x)) ++end;
            if (black(x))
                fill(place.left + place.width * x / bitmap.width, place.left + place.width * end / bitmap.width, heights);
            x = end;
        }
    }

    // Between the first and second side of an area, the third and fourth ... (even-odd).
    void areas(double y, std::span<float> heights) {
        crossings_.clear();
        for (const Side& side : sides_.at(y))
            if (y < side.to.y)  // a corner between two sides counts once
                crossings_.push_back(
                    {side.area, side.from.x + (side.to.x - side.from.x) * ((y - side.from.y) / (side.to.y - side.from.y))});
        std::sort(crossings_.begin(), crossings_.end());
        for (std::size_t i = 0; i + 1 < crossings_.size(); i += 2) fill(crossings_[i].second, crossings_[i + 1].second, heights);
    }

    void raise(const Ridge& ridge, double y, std::span<float> heights) const {
        const double dx = ridge.to.x - ridge.from.x, dy = ridge.to.y - ridge.from.y, square = dx * dx + dy * dy;
        // The part of the centre line that is near enough to the row.
        double first = 0, last = 1;
        if (dy != 0) {
            const double a = (y - ridge.radius - ridge.from.y) / dy, b = (y + ridge.radius - ridge.from.y) / dy;
            first = std::clamp(std::min(a, b), 0.0, 1.0);
            last = std::clamp(std::max(a, b), 0.0, 1.0);
        }
        const double ends[2] = {ridge.from.x + first * dx, ridge.from.x + last * dx};
        const std::size_t end = first_from(std::max(ends[0], ends[1]) + ridge.radius + pitch_, heights);
        for (std::size_t i = first_from(std::min(ends[0], ends[1]) - ridge.radius, heights); i < end; ++i) {
            const double x = (static_cast<double>(i) + 0.5) * pitch_ - ridge.from.x, down = y - ridge.from.y;
            const double t = square > 0 ? std::clamp((x * dx + down * dy) / square, 0.0, 1.0) : 0.0;
            const double squared_distance = (x - t * dx) * (x - t * dx) + (down - t * dy) * (down - t * dy);
            if (squared_distance > ridge.radius * ridge.radius) continue;
            const double raised = ridge.flat ? ridge.height : round_height(squared_distance, ridge.radius, ridge.height);
            heights[i] = std::max(heights[i], static_cast<float>(raised));
        }
    }

    const Page& page_;
    double pitch_;
    double height_;
    Meeting<Ridge> ridges_;
    Meeting<Side> sides_;
    std::vector<std::pair<std::size_t, double>> crossings_;
};

PageRelief::PageRelief(const Page& page, const Settings& settings, std::string_view format) {
    const ReliefShape shape = relief_shape(settings);
    const double columns = std::max(1.0, std::round(page.width / shape.pitch)),
                 rows = std::max(1.0, std::round(page.height / shape.pitch));
    if (!(columns * rows <= kMostSamples))
        throw Error(Fault::usage, format,
                    phrase("{0} x {1} samples are over the limit of 400 million; take a larger pitch or smaller paper",
                           to_text(columns), to_text(rows)));
    sheet_ = {static_cast<int>(columns), static_cast<int>(rows), shape.pitch, 0, shape.height, settings.choice("profile")};
    surface_ = std::make_unique<Surface>(page, shape);
}

PageRelief::~PageRelief() = default;

HeightRows PageRelief::rows() {
    return [this](int row, std::span<float> heights) { surface_->row((row + 0.5) * sheet_.pitch, heights); };
}

HeightMap PageRelief::map() {
    HeightMap map{sheet_.columns, sheet_.rows, sheet_.pitch, {}};
    const auto columns = static_cast<std::size_t>(sheet_.columns);
    map.heights.resize(columns * static_cast<std::size_t>(sheet_.rows));
    const HeightRows fill = rows();
    for (int y = 0; y < sheet_.rows; ++y) fill(y, {map.heights.data() + static_cast<std::size_t>(y) * columns, columns});
    return map;
}

}  // namespace tactics
