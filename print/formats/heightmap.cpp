// A picture of heights for milling, 3-D printing and haptic devices: 16-bit grey PNG, lines raised from a flat ground.
//
// A sample is the height at the centre of its pixel: 0 (black) is the ground, 65535 (white) the full height. What that
// means stands in the file: pHYs holds pixels per metre, and four tEXt entries hold text without a unit:
//     tactics:pitch-mm    distance of two samples, exactly (pHYs is a whole number)
//     tactics:black-mm    height of a sample of 0
//     tactics:white-mm    height of a sample of 65535
//     tactics:profile     cross-section of the lines: round or flat
// Rows are made one after the other from the geometry, so a page needs the memory of one row.
#include <algorithm>
#include <cmath>

#include "print/format.h"
#include "print/png_file.h"
#include "tactics/error.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr double kMostPixels = 400e6;  // A4 at 0.0125 mm; about ten seconds

constexpr Option kOptions[] = {
    // Coarser than 0.5 mm, a line of 0.7 mm could fall between two samples.
    {.name = "pitch", .type = Option::Type::length, .fallback = 0.1, .min = 0.02, .max = 0.5, .unit = "mm",
     .summary = "distance of two samples", .choices = ""},
    // Braille dots are 0.48 (NLS Specification 800) to 0.5 mm high (Marburg Medium).
    {.name = "height", .type = Option::Type::length, .fallback = 0.5, .min = 0.05, .max = 10, .unit = "mm",
     .summary = "height of lines, areas and dots", .choices = ""},
    {.name = "profile", .type = Option::Type::choice, .fallback = 0, .min = 0, .max = 1, .unit = "",
     .summary = "cross-section of the lines", .choices = "round flat"},
};

// A raised piece of line with round ends; a dot if both ends are one.
struct Ridge {
    Point from;
    Point to;
    double radius = 0;
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

class Surface {
public:
    Surface(const Page& page, double pitch, double height, bool flat)
        : page_(page), pitch_(pitch), height_(height), ridges_(ridges(page, flat)), sides_(sides(page)) {}

    // Heights in mm along the row at `y`.
    void row(double y, std::vector<float>& heights) {
        std::fill(heights.begin(), heights.end(), 0.0f);
        if (page_.picture) picture(*page_.picture, y, heights);
        areas(y, heights);
        for (const Ridge& ridge : ridges_.at(y)) raise(ridge, y, heights);
    }

private:
    static std::vector<Ridge> ridges(const Page& page, bool flat) {
        std::vector<Ridge> found;
        for (const PageStroke& stroke : page.strokes) {
            const std::size_t count = stroke.points.size();
            for (std::size_t i = 0; i + 1 < count; ++i)
                found.push_back({stroke.points[i], stroke.points[i + 1], stroke.width / 2, flat});
            if (stroke.closed && count > 0) found.push_back({stroke.points[count - 1], stroke.points[0], stroke.width / 2, flat});
        }
        for (const BrailleLine& line : page.braille)
            for (const Point& dot : dots_of(line, page.cell)) found.push_back({dot, dot, page.braille_dot / 2, false});
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
    std::size_t first_from(double x, const std::vector<float>& heights) const {
        return static_cast<std::size_t>(std::clamp(std::ceil(x / pitch_ - 0.5), 0.0, static_cast<double>(heights.size())));
    }

    void fill(double left, double right, std::vector<float>& heights) const {
        const std::size_t end = first_from(right, heights);
        for (std::size_t x = first_from(left, heights); x < end; ++x) heights[x] = static_cast<float>(height_);
    }

    void picture(const Bitmap& bitmap, double y, std::vector<float>& heights) const {
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
    void areas(double y, std::vector<float>& heights) {
        crossings_.clear();
        for (const Side& side : sides_.at(y))
            if (y < side.to.y)  // a corner between two sides counts once
                crossings_.push_back(
                    {side.area, side.from.x + (side.to.x - side.from.x) * ((y - side.from.y) / (side.to.y - side.from.y))});
        std::sort(crossings_.begin(), crossings_.end());
        for (std::size_t i = 0; i + 1 < crossings_.size(); i += 2) fill(crossings_[i].second, crossings_[i + 1].second, heights);
    }

    void raise(const Ridge& ridge, double y, std::vector<float>& heights) const {
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
            const double raised = ridge.flat ? height_ : round_height(squared_distance, ridge.radius, height_);
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

// Samples of 16 bits as PNG wants them.
class HeightRows {
public:
    explicit HeightRows(std::size_t width) : above_(2 * width), line_(2 * width + 1) {}

    const std::vector<std::uint8_t>& next(const std::vector<std::uint16_t>& samples) {
        line_[0] = 2;  // filter "up": most rows repeat the one above
        for (std::size_t i = 0; i < above_.size(); ++i) {
            const auto byte = static_cast<std::uint8_t>(i % 2 == 0 ? samples[i / 2] >> 8 : samples[i / 2] & 0xFF);
            line_[i + 1] = static_cast<std::uint8_t>(byte - above_[i]);
            above_[i] = byte;
        }
        return line_;
    }

private:
    std::vector<std::uint8_t> above_;
    std::vector<std::uint8_t> line_;
};

std::string encode(const Page& page, const Settings& settings) {
    const double pitch = settings.number("pitch"), height = settings.number("height");
    const std::string_view profile = settings.choice("profile");
    const double columns = std::max(1.0, std::round(page.width / pitch)), rows = std::max(1.0, std::round(page.height / pitch));
    if (!(columns * rows <= kMostPixels))
        throw Error(Fault::usage, "heightmap",
                    to_text(columns) + " x " + to_text(rows) +
                        " samples are over the limit of 400 million; take a larger pitch or smaller paper");

    PngFile png(static_cast<std::uint32_t>(columns), static_cast<std::uint32_t>(rows), 16);
    png.scale(1000 / pitch, 1000 / pitch);
    png.text("tactics:pitch-mm", to_text(pitch));
    png.text("tactics:black-mm", "0");
    png.text("tactics:white-mm", to_text(height));
    png.text("tactics:profile", profile);
    Surface surface(page, pitch, height, profile == "flat");
    std::vector<float> heights(static_cast<std::size_t>(columns));
    std::vector<std::uint16_t> samples(heights.size());
    HeightRows lines(samples.size());
    for (std::uint32_t y = 0; y < static_cast<std::uint32_t>(rows); ++y) {
        surface.row((y + 0.5) * pitch, heights);
        for (std::size_t x = 0; x < heights.size(); ++x)
            samples[x] = static_cast<std::uint16_t>(std::clamp(std::lround(heights[x] / height * 65535), 0L, 65535L));
        png.add_row(lines.next(samples));
    }
    return png.finish();
}

}  // namespace

extern const Format heightmap_format;
const Format heightmap_format{
    .name = "heightmap",
    .summary = "heights as a 16-bit grey PNG, for milling and haptic devices",
    .extensions = "height.png",
    .medium = "swell",
    .paper = "a4",
    .options = kOptions,
    .encode_page = encode,
};

}  // namespace tactics
