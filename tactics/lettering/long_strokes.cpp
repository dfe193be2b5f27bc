// SPDX-License-Identifier: Apache-2.0
#include "tactics/lettering/long_strokes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <queue>
#include <tuple>
#include <vector>

namespace tactics {

namespace {

constexpr std::size_t kDirections = 36;  // of half a turn

class StrokeFinder {
public:
    StrokeFinder(const Image& ink, const PixelBox& window, int least)
        : ink_(ink),
          window_(window),
          least_(least),
          found_{make_image(window.width(), window.height(), 1, 0, 0), make_image(window.width(), window.height(), 1, 0, 0)} {}

    LongStrokes run() {
        find_level_and_upright();
        find_leaning();
        find_ways();
        return std::move(found_);
    }

private:
    bool is_ink(int x, int y) const { return x >= 0 && y >= 0 && x < ink_.width && y < ink_.height && ink_.row(y)[x] != 0; }
    bool is_in_window(int x, int y) const {
        return x >= window_.left && y >= window_.top && x < window_.right && y < window_.bottom;
    }
    static std::uint8_t& at(Image& image, int x, int y, const PixelBox& window) {
        return image.row(y - window.top)[x - window.left];
    }

    // `bare_` is the ink without what is level or upright: what leans does not go on in that.
    void find_level_and_upright() {
        bare_ = ink_;
        const auto take = [&](int x, int y) {
            bare_.row(y)[x] = 0;
            if (is_in_window(x, y)) mark(x, y, 0);
        };
        std::vector<int> above(static_cast<std::size_t>(ink_.width), 0);  // ink of the column that ends there
        for (int y = 0; y <= ink_.height; ++y) {
            const std::uint8_t* row = y < ink_.height ? ink_.row(y) : nullptr;
            for (int x = 0, before = 0; x <= ink_.width; ++x) {
                const bool is = row != nullptr && x < ink_.width && row[x] != 0;
                if (!is && before >= least_)
                    for (int k = x - before; k < x; ++k) take(k, y);
                before = is ? before + 1 : 0;
                if (x == ink_.width) break;
                int& run = above[static_cast<std::size_t>(x)];
                if (!is && run >= least_)
                    for (int k = y - run; k < y; ++k) take(x, k);
                run = is ? run + 1 : 0;
            }
        }
    }

    // In a grid with an empty frame, so wide that no way leaves it.
    void find_leaning() {
        const int wide = bare_.width + 2 * least_, high = bare_.height + 2 * least_;
        std::vector<std::uint8_t> framed(static_cast<std::size_t>(wide) * static_cast<std::size_t>(high), 0);
        const auto start_of = [&](int x, int y) {
            return &framed[static_cast<std::size_t>(y + least_) * static_cast<std::size_t>(wide) +
                           static_cast<std::size_t>(x + least_)];
        };
        for (int y = 0; y < bare_.height; ++y) std::copy_n(bare_.row(y), bare_.width, start_of(0, y));
        const std::vector<std::vector<std::ptrdiff_t>> ways = ways_on(wide);
        const auto is_long = [&](const std::uint8_t* pixel) {
            return std::any_of(ways.begin(), ways.end(), [&](const std::vector<std::ptrdiff_t>& way) {
                if (!may_be_long(pixel, way)) return false;
                int length = 1;
                for (std::size_t i = 0; i < way.size() && pixel[way[i]] != 0; ++i) ++length;
                for (std::size_t i = 0; i < way.size() && pixel[-way[i]] != 0; ++i) ++length;
                return length >= least_;
            });
        };
        for (int y = window_.top; y < window_.bottom; ++y)
            for (int x = window_.left; x < window_.right; ++x)
                if (const std::uint8_t* pixel = start_of(x, y); *pixel != 0 && is_long(pixel)) mark(x, y, 1);
    }

    // To one side a long way goes half of the length at least: at a few places most ways are seen not to.
    bool may_be_long(const std::uint8_t* pixel, const std::vector<std::ptrdiff_t>& way) const {
        bool on = true, back = true;
        for (int far = least_ / 2; far > 0 && (on || back); far /= 2) {
            const std::ptrdiff_t there = way[static_cast<std::size_t>(far) - 1];
            on = on && pixel[there] != 0;
            back = back && pixel[-there] != 0;
        }
        return on || back;
    }

    // Where the pixels of each direction are in rows of so many.
    std::vector<std::vector<std::ptrdiff_t>> ways_on(int wide) const {
        std::vector<std::vector<std::ptrdiff_t>> ways(kDirections);
        for (std::size_t i = 0; i < kDirections; ++i) {
            const double angle = static_cast<double>(i) * std::numbers::pi / static_cast<double>(kDirections);
            for (int step = 1; step < least_; ++step)
                ways[i].push_back(std::lround(step * std::sin(angle)) * wide + std::lround(step * std::cos(angle)));
        }
        return ways;
    }

    // A pixel of a stroke, and its stairs at both sides.
    void mark(int x, int y, int sides) {
        at(found_.strokes, x, y, window_) = 1;
        for (int v = y - sides; v <= y + sides; ++v)
            for (int u = x - sides; u <= x + sides; ++u)
                if (is_in_window(u, v) && is_ink(u, v)) at(found_.beside, u, v, window_) = 1;
    }

    // Where ink crosses the border of the window: pixels in a row along it.
    struct Crossing {
        std::vector<std::pair<int, int>> pixels;
    };
    std::vector<Crossing> crossings() const {
        std::vector<std::pair<int, int>> border;
        for (int x = window_.left; x < window_.right; ++x) border.emplace_back(x, window_.top);
        for (int y = window_.top + 1; y < window_.bottom; ++y) border.emplace_back(window_.right - 1, y);
        for (int x = window_.right - 2; x >= window_.left; --x) border.emplace_back(x, window_.bottom - 1);
        for (int y = window_.bottom - 2; y > window_.top; --y) border.emplace_back(window_.left, y);
        std::vector<Crossing> found;
        bool before = false;
        for (const auto& [x, y] : border) {
            const bool is = is_ink(x, y);
            if (is && !before) found.emplace_back();
            if (is) found.back().pixels.emplace_back(x, y);
            before = is;
        }
        return found;
    }

    void find_ways() {
        constexpr std::size_t kMostCrossings = 12;  // more is a texture
        const std::vector<Crossing> ends = crossings();
        if (ends.size() < 2 || ends.size() > kMostCrossings) return;
        straight_ = found_.strokes;
        measure_thickness();
        for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
            spread(ends[i]);
            for (std::size_t k = i + 1; k < ends.size(); ++k) mark_way(ends[k]);
        }
    }

    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y - window_.top) * static_cast<std::size_t>(window_.width()) +
               static_cast<std::size_t>(x - window_.left);
    }

    // How many pixels of ink are around each, in all directions.
    void measure_thickness() {
        constexpr int kThickest = 6;
        thick_.assign(static_cast<std::size_t>(window_.width()) * static_cast<std::size_t>(window_.height()), 0);
        for (int y = window_.top; y < window_.bottom; ++y)
            for (int x = window_.left; x < window_.right; ++x)
                for (int& thick = thick_[index(x, y)]; thick < kThickest && is_filled(x, y, thick); ++thick) {
                }
    }
    bool is_filled(int x, int y, int around) const {
        for (int v = y - around; v <= y + around; ++v)
            for (int u = x - around; u <= x + around; ++u)
                if (!is_ink(u, v)) return false;
        return true;
    }

    // The shortest ways from there; those through the middle of a stroke are shorter than those along its side.
    void spread(const Crossing& from) {
        constexpr int kStep = 10, kDiagonal = 14;
        far_.assign(thick_.size(), std::numeric_limits<int>::max());
        from_.assign(thick_.size(), {-1, -1});
        using Next = std::tuple<int, int, int>;
        std::priority_queue<Next, std::vector<Next>, std::greater<>> next;
        const auto reach = [&](int x, int y, int far, int back_x, int back_y) {
            if (far >= far_[index(x, y)]) return;
            far_[index(x, y)] = far;
            from_[index(x, y)] = {back_x, back_y};
            next.emplace(far, x, y);
        };
        for (const auto& [x, y] : from.pixels) reach(x, y, 0, -1, -1);
        while (!next.empty()) {
            const auto [far, x, y] = next.top();
            next.pop();
            if (far > far_[index(x, y)]) continue;
            for (int v = y - 1; v <= y + 1; ++v)
                for (int u = x - 1; u <= x + 1; ++u) {
                    if ((u == x && v == y) || !is_in_window(u, v) || !is_ink(u, v)) continue;
                    const int step = u != x && v != y ? kDiagonal : kStep;
                    reach(u, v, far + step + step / std::max(1, thick_[index(u, v)]), x, y);
                }
        }
    }

    // As thick as the stroke is along most of it.
    void mark_way(const Crossing& to) {
        const auto nearest = std::min_element(to.pixels.begin(), to.pixels.end(), [&](const auto& a, const auto& b) {
            return far_[index(a.first, a.second)] < far_[index(b.first, b.second)];
        });
        auto [x, y] = *nearest;
        if (far_[index(x, y)] == std::numeric_limits<int>::max()) return;
        std::vector<std::pair<int, int>> way;
        std::vector<int> thick;
        while (x >= 0) {
            way.emplace_back(x, y);
            thick.push_back(thick_[index(x, y)]);
            std::tie(x, y) = from_[index(x, y)];
        }
        const double straight = static_cast<double>(std::count_if(
            way.begin(), way.end(), [&](const auto& pixel) { return at(straight_, pixel.first, pixel.second, window_) != 0; }));
        constexpr double kMostStraight = 0.8;  // of a way; what is straight is known better
        if (static_cast<int>(way.size()) < least_ || straight > kMostStraight * static_cast<double>(way.size())) return;
        const auto middle = thick.begin() + static_cast<std::ptrdiff_t>(thick.size() / 2);
        std::nth_element(thick.begin(), middle, thick.end());
        for (const auto& [u, v] : way) mark(u, v, *middle);
    }

    const Image& ink_;
    const PixelBox window_;
    const int least_;
    Image bare_, straight_;
    LongStrokes found_;
    std::vector<int> thick_, far_;
    std::vector<std::pair<int, int>> from_;
};

}  // namespace

LongStrokes long_strokes(const Image& ink, const PixelBox& window, int least) { return StrokeFinder(ink, window, least).run(); }

}  // namespace tactics
