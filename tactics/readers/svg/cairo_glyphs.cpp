// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/cairo_glyphs.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>
#include <utility>

#include "tactics/geometry/box.h"
#include "tactics/readers/svg/svg_path.h"

namespace tactics {

namespace {

constexpr double kEdge = 0.001;  // points: what begins at a word's right edge belongs to the next
constexpr double kSlack = 0.5;   // points that a letter may begin outside of its word's box; never behind it
constexpr std::string_view kEnd = "/>";

// Reads a number where the text begins, and takes it off.
std::optional<double> take_number(std::string_view& text) {
    while (text.starts_with(' ')) text.remove_prefix(1);
    double number = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (fault != std::errc() || !std::isfinite(number)) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return number;
}

std::optional<double> number_behind(std::string_view element, std::string_view name) {
    const auto at = element.find(name);
    if (at == std::string_view::npos) return std::nullopt;
    std::string_view value = element.substr(at + name.size());
    return take_number(value);
}

// The box of "M 21.16 295.46 L 27.41 295.46 C ... Z".
std::optional<Rect> box_of_path(std::string_view path) {
    Pen pen(Transform{});
    if (draw_path(path.substr(0, path.find('"')), pen)) return std::nullopt;
    Box box = kNothing;
    for (const Subpath& part : pen.finish())
        for (const Point& p : part.points) box.take(p);
    if (!(box.left <= box.right)) return std::nullopt;
    return Rect{box.left, box.top, box.width(), box.height()};
}

// A disc, a square, a diamond or a triangle, as wide as high: a mark at a point rather than a letter.
bool is_mark(std::string_view path, const Rect& box) {
    constexpr double kRound = 0.08, kEven = 0.3;
    path = path.substr(0, path.find('"'));
    const auto lines = std::count(path.begin(), path.end(), 'L'), curves = std::count(path.begin(), path.end(), 'C');
    const double larger = std::max(box.width, box.height), uneven = std::abs(box.width - box.height);
    return (lines == 0 && uneven < kRound * larger) || (curves == 0 && lines <= 4 && uneven < kEven * larger);
}

// From letter to letter neither across nor down, by more than two degrees, and no further than letters stand apart.
bool is_slanted(double dx, double dy) {
    constexpr double kTangent = 0.03, kFar = 40;  // points
    const double across = std::abs(dx), down = std::abs(dy);
    return std::hypot(dx, dy) < kFar && across > kTangent * down && down > kTangent * across;
}

constexpr std::size_t kAdopted = 900'000;  // numbers of letters that were shapes, beyond those of cairo

// Where something is on a line: along it, and above it.
struct Stretch {
    double from = 0, to = 0, down = 0, up = 0;
};
Stretch stretch_of(const Rect& box, LineRuns runs, double base) {
    const double right = box.left + box.width, bottom = box.top + box.height;
    if (runs == LineRuns::upwards) return {-bottom, -box.top, base - right, base - box.left};
    if (runs == LineRuns::downwards) return {box.top, bottom, box.left - base, right - base};
    return {box.left, right, base - bottom, base - box.top};
}

// Of letters of that size, in shares of it: how far they reach up and down from their line, and how small and wide they are.
constexpr double kUp = 1.2, kDown = 0.5, kLeast = 0.1, kMost = 1.6;

bool is_like_a_letter(const Stretch& there, double size) {
    const double wide = there.to - there.from, high = there.up - there.down;
    return there.up <= kUp * size && there.down >= -kDown * size && wide <= kMost * size && std::max(wide, high) >= kLeast * size;
}

// Between which heights the tops of such shapes can be that meet the line from there to there.
std::pair<double, double> tops_of(const Stretch& there, LineRuns runs, double base, double size) {
    if (runs == LineRuns::upwards) return {-there.to - kMost * size, -there.from};
    if (runs == LineRuns::downwards) return {there.from - kMost * size, there.to};
    return {base - kUp * size, base + kDown * size};
}

}  // namespace

CairoGlyphs::CairoGlyphs(std::string_view svg) : svg_(svg) {
    find_letters();
    find_shapes();
    for (std::vector<Piece>* pieces : {&letters_, &shapes_})
        std::stable_sort(pieces->begin(), pieces->end(), [](const Piece& a, const Piece& b) { return a.box.top < b.box.top; });
}

// <use xlink:href="#glyph0-1" x="150" y="30"/>; those of one font that follow each other are a line.
void CairoGlyphs::find_letters() {
    constexpr std::string_view kUse = "<use xlink:href=\"#glyph";
    constexpr std::size_t kBetween = 4;        // a line end and blanks
    std::set<std::string_view> slanted_fonts;  // cairo has one for each way in which letters are turned
    std::string_view font;
    std::size_t first = 0;
    const auto end_line = [&] {
        std::size_t slanted = 0;
        for (std::size_t i = first + 1; i < letters_.size(); ++i)
            slanted += is_slanted(letters_[i].box.left - letters_[i - 1].box.left, letters_[i].box.top - letters_[i - 1].box.top);
        const bool most = 2 * slanted > letters_.size() - std::min(first + 1, letters_.size()) && slanted > 0;
        if (most) slanted_fonts.insert(font);
        first = letters_.size();
    };
    for (auto at = svg_.find(kUse); at != std::string_view::npos; at = svg_.find(kUse, at + 1)) {
        const auto end = svg_.find(kEnd, at);
        if (end == std::string_view::npos) break;
        const std::string_view element = svg_.substr(at, end - at);
        const auto x = number_behind(element, " x=\""), y = number_behind(element, " y=\"");
        if (!x || !y) continue;
        const std::string_view number = element.substr(kUse.size());
        const std::string_view own = number.substr(0, number.find('-', 1));
        if (own != font || letters_.empty() || at > letters_.back().end + kBetween) end_line();
        font = own;
        letters_.push_back({at, end + kEnd.size(), {*x, *y, 0, 0}, own});
    }
    end_line();
    for (Piece& letter : letters_) letter.slanted = slanted_fonts.contains(letter.font);
}

// Filled, in a colour that is seen, and no larger than letters are.
void CairoGlyphs::find_shapes() {
    constexpr std::string_view kPath = "<path style=\" stroke:none;", kData = " d=\"", kWhite = "fill:rgb(100%,100%,100%)";
    constexpr double kLargest = 150;  // points
    for (auto at = svg_.find(kPath); at != std::string_view::npos; at = svg_.find(kPath, at + 1)) {
        const auto end = svg_.find(kEnd, at);
        if (end == std::string_view::npos) break;
        const std::string_view element = svg_.substr(at, end - at);
        const auto data = element.find(kData);
        if (data == std::string_view::npos || element.find(" transform=") != std::string_view::npos ||
            element.find("fill:rgb(") == std::string_view::npos || element.find(kWhite) != std::string_view::npos)
            continue;
        const std::string_view path = element.substr(data + kData.size());
        const auto box = box_of_path(path);
        if (box && !is_mark(path, *box) && box->width < kLargest && box->height < kLargest)
            shapes_.push_back({at, end + kEnd.size(), *box});
    }
}

// Asks about each piece that begins between these heights, until one is it; gives whether one is.
template <typename Visit>
bool CairoGlyphs::any_from(std::vector<Piece>& pieces, double least, double most, const Visit& visit) {
    constexpr std::size_t kMostLooked = 200'000'000;  // a second; of a hostile page, whose words all lie over all of its letters
    auto at =
        std::lower_bound(pieces.begin(), pieces.end(), least, [](const Piece& piece, double top) { return piece.box.top < top; });
    for (; at != pieces.end() && at->box.top <= most; ++at) {
        if (++looked_ > kMostLooked) return false;
        if (!at->taken && visit(*at)) return true;
    }
    return false;
}

std::vector<std::size_t> CairoGlyphs::claim(const Rect& word) {
    std::vector<std::size_t> claimed;
    any_from(letters_, word.top - kSlack, word.top + word.height + kSlack, [&](Piece& letter) {
        const bool within = letter.box.left >= word.left - kSlack && letter.box.left <= word.left + word.width - kEdge;
        if (within && !std::exchange(letter.claimed, true))
            claimed.push_back(static_cast<std::size_t>(&letter - letters_.data()));
        return false;
    });
    return claimed;
}

double CairoGlyphs::base_of(const std::vector<std::size_t>& letters, LineRuns runs) const {
    std::vector<double> bases;
    for (const std::size_t i : letters) bases.push_back(runs == LineRuns::across ? letters_[i].box.top : letters_[i].box.left);
    std::nth_element(bases.begin(), bases.begin() + static_cast<std::ptrdiff_t>(bases.size() / 2), bases.end());
    return bases[bases.size() / 2];
}

bool CairoGlyphs::are_slanted(const std::vector<std::size_t>& letters) const {
    return std::any_of(letters.begin(), letters.end(), [&](std::size_t i) { return letters_[i].slanted; });
}

void CairoGlyphs::take(const std::vector<std::size_t>& letters) {
    for (const std::size_t i : letters) letters_[i].taken = true;
}

// As a minus is, in shares of the size of the letters.
bool CairoGlyphs::is_bar(const Piece& shape, double size) const {
    constexpr double kShort = 0.3, kLong = 0.9, kThick = 0.16;
    return shape.box.width >= kShort * size && shape.box.width <= kLong * size && shape.box.height <= kThick * size;
}

bool CairoGlyphs::take_minus(const Rect& number, double size, double base) {
    constexpr double kGap = 0.45, kLow = 0.1, kHigh = 0.6;  // of the size: before the number, and over the line
    return any_from(shapes_, base - kHigh * size, base - kLow * size, [&](Piece& shape) {
        const double gap = number.left - (shape.box.left + shape.box.width);
        shape.taken = is_bar(shape, size) && gap >= -kSlack && gap <= kGap * size;
        return shape.taken;
    });
}

bool CairoGlyphs::has_shape_between(const Rect& word, const Rect& next, const std::vector<std::size_t>& letters, LineRuns runs,
                                    double size) {
    const double base = base_of(letters, runs), from = stretch_of(word, runs, base).to, to = stretch_of(next, runs, base).from;
    const auto [least, most] = tops_of({from - kSlack, to + kSlack}, runs, base, size);
    return any_from(shapes_, least, most, [&](Piece& shape) {
        const Stretch there = stretch_of(shape.box, runs, base);
        return is_like_a_letter(there, size) && there.from >= from - kSlack && there.to <= to + kSlack;
    });
}

bool CairoGlyphs::adopt_shapes(const std::vector<std::size_t>& letters, const Rect& line, LineRuns runs, double size) {
    constexpr double kBeside = 0.5;  // of the size: how far beside a word a letter of it stands
    const double base = base_of(letters, runs);
    Stretch reach = stretch_of(line, runs, base);
    bool any = false;
    for (bool more = true; more;) {
        const double from = reach.from - kBeside * size, to = reach.to + kBeside * size;
        const auto [least, most] = tops_of({from, to}, runs, base, size);
        more = any_from(shapes_, least, most, [&](Piece& shape) {
            const Stretch there = stretch_of(shape.box, runs, base);
            if (!is_like_a_letter(there, size) || there.from > to || there.to < from) return false;
            adopt(shape, letters, runs, base);
            reach.from = std::min(reach.from, there.from);
            reach.to = std::max(reach.to, there.to);
            return true;
        });
        any = any || more;
    }
    return any;
}

void CairoGlyphs::adopt(Piece& shape, const std::vector<std::size_t>& letters, LineRuns runs, double base) {
    // Behind the letter before it, in its font, so that whoever reads lines of letters finds it there.
    const double from = stretch_of(shape.box, runs, base).from;
    const auto from_of = [&](std::size_t i) { return stretch_of(letters_[i].box, runs, base).from; };
    std::size_t before = letters.front();
    for (const std::size_t i : letters)
        if (from_of(i) <= from ? from_of(before) > from || from_of(i) > from_of(before)
                               : from_of(before) > from && from_of(i) < from_of(before))
            before = i;
    const Piece& neighbour = letters_[before];
    const Point place = runs == LineRuns::across    ? Point{shape.box.left, base}
                        : runs == LineRuns::upwards ? Point{base, shape.box.top + shape.box.height}
                                                    : Point{base, shape.box.top};
    const auto number = [](double value) { return std::to_string(value); };
    const std::string name = "glyph" + std::string(neighbour.font) + "-" + std::to_string(kAdopted + adopted_++);
    std::string path(svg_.substr(shape.begin, shape.end - shape.begin));
    path.insert(path.find(' '), " transform=\"translate(" + number(-place.x) + "," + number(-place.y) + ")\"");
    symbols_ += "<symbol overflow=\"visible\" id=\"" + name + "\">" + path + "</symbol>\n";
    behind_[{from_of(before) > from ? neighbour.begin : neighbour.end, from}] +=
        "<use xlink:href=\"#" + name + "\" x=\"" + number(place.x) + "\" y=\"" + number(place.y) + "\"/>";
    shape.taken = true;
}

std::string CairoGlyphs::without_taken(std::string_view more) const {
    struct Change {
        std::size_t begin, end;
        std::string_view instead;
    };
    std::vector<Change> changes;
    for (const std::vector<Piece>* pieces : {&letters_, &shapes_})
        for (const Piece& piece : *pieces)
            if (piece.taken) changes.push_back({piece.begin, piece.end, {}});
    for (const auto& [place, text] : behind_) changes.push_back({place.first, place.first, text});
    std::stable_sort(changes.begin(), changes.end(), [](const Change& a, const Change& b) { return a.begin < b.begin; });
    std::string out;
    std::size_t copied = 0;
    for (const Change& change : changes) {
        out += svg_.substr(copied, change.begin - copied);
        out += change.instead;
        copied = std::max(copied, change.end);
    }
    const auto end = std::max(copied, std::min(svg_.rfind("</svg>"), svg_.size()));
    out += svg_.substr(copied, end - copied);
    if (!symbols_.empty()) out += "<defs>\n" + symbols_ + "</defs>\n";
    return out + std::string(more) + std::string(svg_.substr(end));
}

bool is_adopted(std::string_view number) {
    std::size_t found = 0;
    return std::from_chars(number.data(), number.data() + number.size(), found).ec == std::errc() && found >= kAdopted;
}

std::size_t drawn_in(std::string_view svg) {
    // Outlines of letters and clips have no colour.
    constexpr std::string_view kPath = "<path ", kFill = "fill:rgb(", kLine = "stroke:rgb(", kWhite = "100%,100%,100%)";
    std::size_t drawn = 0;
    for (auto at = svg.find(kPath); at != std::string_view::npos; at = svg.find(kPath, at + 1)) {
        const std::string_view element = svg.substr(at, std::min(svg.find(kEnd, at), svg.size()) - at);
        const auto paints = [&](std::string_view how) {
            const auto colour = element.find(how);
            return colour != std::string_view::npos && !element.substr(colour + how.size()).starts_with(kWhite);
        };
        drawn += paints(kFill) || paints(kLine);
    }
    constexpr std::string_view kImage = "<image";
    for (auto at = svg.find(kImage); at != std::string_view::npos; at = svg.find(kImage, at + 1)) ++drawn;
    return drawn;
}

}  // namespace tactics
