// SPDX-License-Identifier: Apache-2.0
#include "tactics/rules/coverage.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tactics/geometry/spans.h"

namespace tactics {

namespace {

constexpr double kFinestLines = 0.1;  // mm from line to line
constexpr double kMostLines = 3000;
constexpr std::size_t kMostSpans = 100'000'000;
// Of shapes along all lines; with more of them lines are farther apart. A4 that is covered with lines 1 mm wide has a tenth.
constexpr double kManySpans = 10e6;

class Coverage {
public:
    explicit Coverage(const PageGeometry& geometry) : geometry_(geometry) {
        const Page& page = geometry.page;
        look_every(std::max(kFinestLines, page.height / kMostLines));
        for (const BrailleLine& line : page.braille)
            for (const Point& dot : dots_of(line, page.cell)) dots_.push_back(dot);
    }

    // No less than `percent`, and told without looking where things lie over each other. A line across the page stands for a
    // strip step_ high, so that of a shape at most a strip of its width more is counted than there is.
    double most_percent() const {
        const auto& page = geometry_.page;
        if (page.picture) return 100;
        double black = 0;
        const auto add = [&](double area, double width) { black += area + step_ * width; };
        for (const Chain& chain : geometry_.chains) {
            if (chain.ring) {
                const Box box = box_of(geometry_.points_of(chain));
                add(box.width() * box.height(), box.width());
                continue;
            }
            const double width = 2 * chain.half_width, caps = width * width;
            for (std::size_t i = chain.first; i < chain.first + chain.count; ++i) {
                const Segment& line = geometry_.pieces[i].line;
                const double length = distance(line.a, line.b);
                add(length * width + caps, length + width);
            }
        }
        const double dot = page.braille_dot;
        add(static_cast<double>(dots_.size()) * dot * dot, static_cast<double>(dots_.size()) * dot);
        return 100 * black / (page.width * page.height);
    }

    std::optional<double> percent() {
        if (const double many = count_spans() / kManySpans; many > 1) look_every(step_ * many);
        sort();
        double black = 0;
        for (std::size_t line = 0; line < lines_; ++line) {
            const auto length = black_along(line);
            if (!length) return std::nullopt;
            black += *length;
        }
        return 100 * black / (geometry_.page.width * static_cast<double>(lines_));
    }

private:
    double height_of(std::size_t line) const { return (static_cast<double>(line) + 0.5) * step_; }

    void look_every(double step) {
        const double height = geometry_.page.height;
        lines_ = static_cast<std::size_t>(std::max(1.0, std::floor(height / step)));
        step_ = height / static_cast<double>(lines_);
    }

    // Shapes with the first and the last line that they can touch: pieces, then dots.
    template <typename Visit>
    void for_each_shape(Visit visit) const {
        const auto add = [&](std::size_t shape, double top, double bottom) {
            const double first = std::max(0.0, std::floor(top / step_)),
                         last = std::min(static_cast<double>(lines_ - 1), std::floor(bottom / step_));
            if (first <= last) visit(shape, static_cast<std::size_t>(first), static_cast<std::size_t>(last));
        };
        for (std::size_t i = 0; i < geometry_.pieces.size(); ++i) {
            const Box box = geometry_.box_of_piece(i, 0);
            add(i, box.top, box.bottom);
        }
        for (std::size_t i = 0; i < dots_.size(); ++i)
            add(geometry_.pieces.size() + i, dots_[i].y - geometry_.page.braille_dot / 2,
                dots_[i].y + geometry_.page.braille_dot / 2);
    }

    double count_spans() const {
        double count = 0;
        for_each_shape([&](std::size_t, std::size_t first, std::size_t last) { count += static_cast<double>(last - first + 1); });
        return count;
    }

    void sort() {
        begins_.resize(lines_);
        for_each_shape([&](std::size_t shape, std::size_t first, std::size_t last) { begins_[first].push_back({shape, last}); });
    }

    std::optional<double> black_along(std::size_t line) {
        const double y = height_of(line);
        std::erase_if(active_, [line](const Shape& shape) { return shape.last < line; });
        active_.insert(active_.end(), begins_[line].begin(), begins_[line].end());
        looked_ += active_.size();
        if (looked_ > kMostSpans) return std::nullopt;
        spans_.clear();
        crossings_.clear();
        for (const Shape& shape : active_) {
            Span span;
            if (shape.index >= geometry_.pieces.size()) {
                const Point dot = dots_[shape.index - geometry_.pieces.size()];
                if (span_within(dot, dot, geometry_.page.braille_dot / 2, y, span)) spans_.push_back(span);
                continue;
            }
            const Piece& piece = geometry_.pieces[shape.index];
            const Chain& chain = geometry_.chains[piece.chain];
            const Segment& s = piece.line;
            if (!chain.ring) {
                if (span_within(s.a, s.b, chain.half_width, y, span)) spans_.push_back(span);
            } else if ((s.a.y > y) != (s.b.y > y)) {
                crossings_.push_back({chain.owner, s.a.x + (y - s.a.y) / (s.b.y - s.a.y) * (s.b.x - s.a.x)});
            }
        }
        std::sort(crossings_.begin(), crossings_.end());
        for (std::size_t i = 0; i + 1 < crossings_.size(); i += 2)
            spans_.push_back({crossings_[i].second, crossings_[i + 1].second});
        add_picture(y);
        return length_of_union();
    }

    void add_picture(double y) {
        const auto& picture = geometry_.page.picture;
        if (!picture || picture->width <= 0 || picture->height <= 0 || !(picture->place.height > 0)) return;
        const double row = std::floor((y - picture->place.top) / picture->place.height * picture->height);
        if (!(row >= 0 && row < picture->height)) return;
        const std::uint8_t* bits = picture->bits.data() + static_cast<std::size_t>(row) * picture->row_bytes();
        const double across = picture->place.width / picture->width;
        looked_ += static_cast<std::size_t>(picture->width) / 8;
        for (int x = 0; x < picture->width;) {
            const auto black = [&](int at) { return (bits[at / 8] >> (7 - at % 8) & 1) != 0; };
            const int begin = x;
            while (x < picture->width && black(x)) ++x;
            if (x > begin) spans_.push_back({picture->place.left + begin * across, picture->place.left + x * across});
            while (x < picture->width && !black(x)) ++x;
        }
    }

    double length_of_union() {
        std::sort(spans_.begin(), spans_.end());
        double length = 0, reached = 0;  // what is left of the paper does not count
        for (const auto& [from, to] : spans_) {
            const double begin = std::max(from, reached), end = std::min(to, geometry_.page.width);
            if (end <= begin) continue;
            length += end - begin;
            reached = end;
        }
        return length;
    }

    struct Shape {
        std::size_t index;
        std::size_t last;  // line
    };

    const PageGeometry& geometry_;
    double step_ = 0;
    std::size_t lines_ = 0;
    std::vector<Point> dots_;
    std::vector<std::vector<Shape>> begins_;
    std::vector<Shape> active_;
    std::vector<Span> spans_;
    std::vector<std::pair<std::size_t, double>> crossings_;  // area, x
    std::size_t looked_ = 0;
};

}  // namespace

std::optional<double> percent_black(const PageGeometry& geometry) {
    if (!(geometry.page.width > 0) || !(geometry.page.height > 0)) return 0;
    return Coverage(geometry).percent();
}

Findings ink_beyond(const PageGeometry& geometry, double limit) {
    const Page& page = geometry.page;
    if (!(page.width > 0) || !(page.height > 0)) return {};
    Coverage coverage(geometry);
    if (coverage.most_percent() <= limit) return {};
    const auto percent = coverage.percent();
    if (!percent) return {{}, false};
    if (*percent <= limit + kRounding) return {};
    return {{{*percent, {}, {}, phrase("{0} % of the page black", shown(*percent)), true}}};
}

}  // namespace tactics
