// SPDX-License-Identifier: Apache-2.0
#include "filters/traits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "filters/edge_noise.h"
#include "filters/frame.h"
#include "filters/opencv.h"

namespace tactics {

namespace {

constexpr int kSoftRange = 40;  // grey levels between neighbours; more is an edge

// Pixels of the longer side: from here on pictures are halved at least, which takes half of the grain.
constexpr int kSmallSide = 250;

// Deviation that a scan's grain or a camera's noise leaves; more is texture.
constexpr double kGrainLeft = 2.5;

struct Look {
    int width = 0, height = 0;
    double noise = 0;  // deviation that is left
    std::vector<std::uint8_t> rgb;
    std::vector<std::uint8_t> grey;

    std::size_t count() const { return grey.size(); }
    const std::uint8_t* row(int y) const { return grey.data() + static_cast<std::ptrdiff_t>(y) * width; }
    double share(std::size_t n) const { return static_cast<double>(n) / static_cast<double>(count()); }
    // What a flat place may vary by: nine samples of noise about three deviations, rounding and compression two or three levels.
    int flat_range() const { return 3 + static_cast<int>(std::lround(3 * noise)); }
    int alike() const { return 8 + static_cast<int>(std::lround(2 * noise)); }  // levels from a colour to what is taken for it

    void find_grey() {
        grey.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
        for (std::size_t i = 0; i < grey.size(); ++i) grey[i] = luma(&rgb[3 * i]);
    }
};

Look small_and_clean(const Image& picture) {
    const PixelBox part = picture_within(picture);
    const int longest = std::max(part.width(), part.height());
    // Whole numbers of pixels are quick to average; the last odd ones are left out.
    const int wanted = longest < kSmallSide ? 1 : std::max(2, longest / kSmallSide);
    const int by = std::min({wanted, part.width(), part.height()});
    Look look;
    look.width = part.width() / by;
    look.height = part.height() / by;
    cv::Mat small = view_of(picture)(cv::Rect(part.left, part.top, look.width * by, look.height * by));
    if (by > 1) cv::resize(small, small, cv::Size(look.width, look.height), 0, 0, cv::INTER_AREA);
    if (picture.channels == 1) cv::cvtColor(small, small, cv::COLOR_GRAY2RGB);
    Image copy = make_image(look.width, look.height, 3, 0, 0);
    small.copyTo(view_of(copy));
    // The median of nine leaves 0.42 of white noise.
    constexpr double kMedianOfNine = 0.42;
    look.noise = std::min(kMedianOfNine * noise_level(to_grey(copy)), kGrainLeft);
    look.rgb.resize(copy.pixels.size());
    cv::medianBlur(small, cv::Mat(look.height, look.width, CV_8UC3, look.rgb.data()), 3);
    look.find_grey();
    return look;
}

// Small slopes are light, large ones are paint (E. H. Land, J. J. McCann, "Lightness and retinex theory", 1971): the logarithm
// of the light is the square polynomial whose slopes fit those of the flat places best.
using Light = std::array<double, 5>;  // of u, v, u^2, u v, v^2, with u and v from -1 to 1

Light light_of(const Look& look) {
    constexpr int kStep = 4;            // pixels between the two ends of a slope
    constexpr std::uint8_t kDark = 32;  // in the dark the logarithm is all noise
    std::array<float, 256> logarithm{};
    for (std::size_t i = kDark; i < logarithm.size(); ++i) logarithm[i] = std::log(static_cast<float>(i));
    cv::Matx<double, 5, 5> squares = 1e-6 * cv::Matx<double, 5, 5>::eye();  // no slopes, no light
    cv::Vec<double, 5> slopes;
    const auto add = [&](std::uint8_t from, std::uint8_t to, const cv::Vec<double, 5>& terms) {
        if (std::abs(from - to) > look.flat_range() + 2 || from < kDark || to < kDark) return;
        const double slope = static_cast<double>(logarithm[to] - logarithm[from]);
        for (int i = 0; i < 5; ++i) {
            slopes[i] += terms[i] * slope;
            for (int j = 0; j <= i; ++j) squares(i, j) += terms[i] * terms[j];
        }
    };
    const double du = 2.0 * kStep / look.width, dv = 2.0 * kStep / look.height;
    for (int y = 0; y + kStep < look.height; y += 3)
        for (int x = 0; x + kStep < look.width; x += 3) {
            const double u = (2.0 * x + kStep) / look.width - 1, v = (2.0 * y + kStep) / look.height - 1;
            const std::uint8_t here = look.row(y)[x];
            add(here, look.row(y)[x + kStep], {du, 0, 2 * u * du, v * du, 0});
            add(here, look.row(y + kStep)[x], {0, dv, 0, u * dv, 2 * v * dv});
        }
    for (int i = 0; i < 5; ++i)
        for (int j = 0; j < i; ++j) squares(j, i) = squares(i, j);
    const cv::Vec<double, 5> found = squares.solve(slopes, cv::DECOMP_CHOLESKY);
    return {found[0], found[1], found[2], found[3], found[4]};
}

void even_out(Look& look, const Light& light) {
    // Light that differs by more than twice is no lamp beside a page.
    constexpr double kMost = 0.7;
    std::uint8_t *at = look.rgb.data(), *grey = look.grey.data();
    for (int y = 0; y < look.height; ++y) {
        const double v = 2.0 * y / look.height - 1;
        // Along a row it is exp of a square polynomial: two products a pixel.
        const auto exponent = [&](double u) {
            return -(light[0] * u + light[1] * v + light[2] * u * u + light[3] * u * v + light[4] * v * v);
        };
        const double step = 2.0 / look.width;
        double factor = std::exp(exponent(-1)), ratio = std::exp(exponent(step - 1) - exponent(-1));
        const double bend = std::exp(-2 * light[2] * step * step);
        for (int x = 0; x < look.width; ++x, at += 3) {
            const float by = static_cast<float>(std::clamp(factor, std::exp(-kMost), std::exp(kMost)));
            for (int c = 0; c < 3; ++c)
                at[c] = static_cast<std::uint8_t>(std::min(static_cast<float>(at[c]) * by + 0.5f, 255.0f));
            *grey++ = luma(at);
            factor *= ratio;
            ratio *= bend;
        }
    }
}

// A dark or faint picture has few greys, as a drawing has; looked at in its own light it has not.
void strengthen(Look& look) {
    // A scan in dim light is brighter than that; fog has fewer levels than the pale maps; with fewer than the least there is only
    // grain.
    constexpr int kDark = 128, kFaint = 110, kLeast = 20;
    // A little ink on a white page is no less black for being little; single specks went with the median.
    constexpr double kOutside = 0.0002, kMost = 1.4 * kGrainLeft;
    // A table a channel: neighbours of one level do not wait for each other.
    std::array<std::array<std::uint32_t, 256>, 3> tables{};
    for (std::size_t i = 0; i < look.rgb.size(); i += 3)
        for (std::size_t c = 0; c < 3; ++c) ++tables[c][look.rgb[i + c]];
    std::array<std::size_t, 256> counts{};
    for (const auto& table : tables)
        for (std::size_t i = 0; i < counts.size(); ++i) counts[i] += table[i];
    const auto end = [&](int level, int step) {
        for (double outside = kOutside * static_cast<double>(look.rgb.size()); level > 0 - step && level < 255 - step;
             level += step)
            if ((outside -= static_cast<double>(counts[static_cast<std::size_t>(level)])) < 0) break;
        return level;
    };
    const int dark = end(0, 1), bright = end(255, -1);
    if (bright >= kDark && bright - dark >= kFaint) return;
    const double gain = 255.0 / std::max(bright - dark, kLeast);
    for (auto& sample : look.rgb) sample = static_cast<std::uint8_t>(std::lround(std::clamp((sample - dark) * gain, 0.0, 255.0)));
    look.find_grey();
    look.noise = std::min(look.noise * gain, kMost);
}

void compare_neighbours(Traits& traits, const Look& look) {
    traits.flat = 1;
    if (look.width < 3 || look.height < 3) return;
    const int limit = look.flat_range();
    std::vector<std::uint8_t> low(static_cast<std::size_t>(look.width)), high(low.size());
    std::size_t flat = 0, within = 0;
    for (int y = 1; y + 1 < look.height; ++y) {
        const std::uint8_t *a = look.row(y - 1), *b = look.row(y), *c = look.row(y + 1);
        for (std::size_t x = 0; x < low.size(); ++x) {
            low[x] = std::min({a[x], b[x], c[x]});
            high[x] = std::max({a[x], b[x], c[x]});
        }
        for (std::size_t x = 1; x + 1 < low.size(); ++x) {
            const int range = std::max({high[x - 1], high[x], high[x + 1]}) - std::min({low[x - 1], low[x], low[x + 1]});
            flat += range <= limit ? 1 : 0;
            within += range <= kSoftRange ? 1 : 0;
        }
    }
    const double places = static_cast<double>(look.width - 2) * static_cast<double>(look.height - 2);
    traits.flat = static_cast<double>(flat) / places;
    traits.soft = static_cast<double>(within - flat) / places;  // noise that is left never reaches the soft range
}

// What is drawn steps from one plain part to another; a step in a photograph has shades and textures beside it.
double share_clear(const Look& look) {
    constexpr int kHalf = 2;      // pixels from the middle of a step to its ends: what is left of a blur of five in the picture
    constexpr int kLeast = 16;    // levels; blocks on pale maps are that faint
    constexpr int kPlainer = 16;  // what is plain varies so much less than the step is high
    // Two differences of noise and their sum: nine of ten plain places are within.
    const int grain = static_cast<int>(std::lround(3 * look.noise));
    std::size_t steps = 0, clear = 0;
    const auto count = [&](const std::uint8_t* at, std::ptrdiff_t next) {
        const int before = at[-kHalf * next], after = at[kHalf * next], height = std::abs(after - before);
        if (height <= kLeast + 2 * grain) return;
        ++steps;
        const int beside = std::abs(before - at[-2 * kHalf * next]) + std::abs(at[2 * kHalf * next] - after);
        clear += beside <= height / kPlainer + grain ? 1 : 0;
    };
    constexpr int kEvery = 2;
    for (int y = 0; y < look.height; y += kEvery)
        for (int x = 2 * kHalf; x + 2 * kHalf < look.width; ++x) count(look.row(y) + x, 1);
    for (int y = 2 * kHalf; y + 2 * kHalf < look.height; ++y)
        for (int x = 0; x < look.width; x += kEvery) count(look.row(y) + x, look.width);
    return steps == 0 ? 0 : static_cast<double>(clear) / static_cast<double>(steps);
}

// Lightness, and blue and red beside it.
using Tone = std::array<int, 3>;
Tone tone_of(const std::uint8_t* rgb, std::uint8_t grey) { return {grey, rgb[2] - grey, rgb[0] - grey}; }

// Pixels of nearly one colour, gathered in cells 4 levels deep and 8 wide.
struct Cell {
    std::array<std::size_t, 3> sum{};
    std::size_t count = 0;

    double mean(std::size_t i) const { return static_cast<double>(sum[i]) / static_cast<double>(count) - 256; }
};

std::vector<Cell> cells_of(const Look& look) {
    std::vector<std::uint16_t> number(64 * 64 * 64);
    std::vector<Cell> cells;
    for (std::size_t i = 0; i < look.count(); ++i) {
        const Tone tone = tone_of(&look.rgb[3 * i], look.grey[i]);
        auto& of = number[static_cast<std::size_t>((tone[0] >> 2) << 12 | ((tone[1] + 256) >> 3) << 6 | (tone[2] + 256) >> 3)];
        if (of == 0) {
            if (cells.size() == 65'535) continue;
            cells.emplace_back();
            of = static_cast<std::uint16_t>(cells.size());
        }
        Cell& cell = cells[of - 1u];
        for (std::size_t c = 0; c < 3; ++c) cell.sum[c] += static_cast<std::size_t>(tone[c] + 256);
        ++cell.count;
    }
    return cells;
}

struct CommonColour {
    Tone tone{};
    double share = 0;
};

// The eight commonest colours, each with all that looks like it, the commonest of all first.
std::vector<CommonColour> colours_of(const Look& look) {
    std::vector<Cell> cells = cells_of(look);
    std::vector<CommonColour> colours;
    for (int k = 0; k < 8 && !cells.empty(); ++k) {
        const auto peak =
            std::max_element(cells.begin(), cells.end(), [](const Cell& a, const Cell& b) { return a.count < b.count; });
        const std::array<double, 3> colour{peak->mean(0), peak->mean(1), peak->mean(2)};
        std::size_t count = 0;
        const double deep = 6 + 1.5 * look.noise, wide = 10 + 1.5 * look.noise;
        std::erase_if(cells, [&](const Cell& cell) {
            const bool alike = std::abs(cell.mean(0) - colour[0]) <= deep && std::abs(cell.mean(1) - colour[1]) <= wide &&
                               std::abs(cell.mean(2) - colour[2]) <= wide;
            if (alike) count += cell.count;
            return alike;
        });
        const auto whole = [&](std::size_t c) { return static_cast<int>(std::lround(colour[c])); };
        colours.push_back({{whole(0), whole(1), whole(2)}, look.share(count)});
    }
    std::stable_sort(colours.begin(), colours.end(),
                     [](const CommonColour& a, const CommonColour& b) { return a.share > b.share; });
    return colours;
}

// Of the places along the border, which what stands on a ground has all around, however large it is.
Tone colour_of(std::vector<Tone> rim) {
    Tone middle{};
    for (std::size_t c = 0; c < 3; ++c) {
        const auto half = rim.begin() + static_cast<std::ptrdiff_t>(rim.size() / 2);
        std::nth_element(rim.begin(), half, rim.end(), [c](const Tone& a, const Tone& b) { return a[c] < b[c]; });
        middle[c] = (*half)[c];
    }
    return middle;
}

int apart(const Tone& a, const Tone& b) {
    return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

void compare_with_ground(Traits& traits, const Look& look, const std::vector<CommonColour>& colours, const Tone& rim) {
    constexpr int kHue = 24;
    const int alike = look.alike();
    const Tone of = colours.empty() ? Tone{} : colours.front().tone;
    std::array<std::size_t, 256> levels{};
    std::size_t on_ground = 0, colourful = 0;
    for (std::size_t i = 0; i < look.count(); ++i) {
        const Tone tone = tone_of(&look.rgb[3 * i], look.grey[i]);
        ++levels[look.grey[i]];
        const int blue = tone[1] - of[1], red = tone[2] - of[2];
        on_ground += apart(tone, of) <= alike ? 1 : 0;
        colourful += std::max({std::abs(blue), std::abs(red), std::abs(blue - red)}) > kHue ? 1 : 0;
    }
    traits.ground = look.share(on_ground);
    traits.colourful = look.share(colourful);
    const auto percentile = [&](double share) {
        std::size_t below = 0;
        int level = 0;
        while (level < 255 && look.share(below += levels[static_cast<std::size_t>(level)]) < share) ++level;
        return level;
    };
    const int dark = percentile(0.002), bright = percentile(0.998);
    traits.range = bright - dark;
    traits.lightest = of[0] >= bright - traits.range / 5;
    traits.darkest = of[0] <= dark + traits.range / 5;
    if (colours.size() < 2) return;
    const Tone& other = colours[1].tone;
    const bool on_paper = std::min(apart(rim, of), apart(rim, other)) <= alike && rim[0] >= bright - traits.range / 5;
    if (on_paper && std::min(of[0], other[0]) >= (dark + bright) / 2) traits.paper = colours[0].share + colours[1].share;
    // Light that grows by this much on all sides covers any line: 2.5 % of the longer side.
    constexpr int kGrow = 3;
    const cv::Mat grey(look.height, look.width, CV_8UC1, const_cast<std::uint8_t*>(look.grey.data()));
    cv::Mat grown;
    cv::dilate(grey, grown, cv::getStructuringElement(cv::MORPH_RECT, cv::Size(2 * kGrow + 1, 2 * kGrow + 1)));
    traits.thick = look.share(static_cast<std::size_t>(cv::countNonZero(grown < of[0] - kHue)));
    constexpr int kPaint = 5;  // pixels; what a scan leaves of the white between two lines is narrower, or of many greys
    cv::Mat lightest, darkest;
    const cv::Mat square = cv::getStructuringElement(cv::MORPH_RECT, cv::Size(kPaint, kPaint));
    cv::dilate(grey, lightest, square);
    cv::erode(grey, darkest, square);
    const cv::Mat painted =
        (lightest < of[0] - kHue) & (darkest > (dark + bright) / 2) & (lightest - darkest <= look.flat_range());
    traits.painted = look.share(static_cast<std::size_t>(cv::countNonZero(painted)));
}

std::vector<Tone> rim_of(const Look& look) {
    std::vector<Tone> rim;
    const auto add = [&](int x, int y) {
        const auto i = static_cast<std::size_t>(y) * static_cast<std::size_t>(look.width) + static_cast<std::size_t>(x);
        rim.push_back(tone_of(&look.rgb[3 * i], look.grey[i]));
    };
    for (int x = 0; x < look.width; ++x) add(x, 0), add(x, look.height - 1);
    for (int y = 0; y < look.height; ++y) add(0, y), add(look.width - 1, y);
    return rim;
}

}  // namespace

Traits traits_of(const Image& picture) {
    Look look = small_and_clean(picture);
    even_out(look, light_of(look));
    strengthen(look);
    Traits traits;
    traits.noise = look.noise;
    compare_neighbours(traits, look);
    traits.clear = share_clear(look);
    const std::vector<CommonColour> colours = colours_of(look);
    for (const CommonColour& colour : colours) traits.few += colour.share;
    const std::vector<Tone> rim = rim_of(look);
    const Tone middle = colour_of(rim);
    compare_with_ground(traits, look, colours, middle);
    const auto same =
        std::count_if(rim.begin(), rim.end(), [&](const Tone& tone) { return apart(tone, middle) <= look.alike(); });
    traits.rim = static_cast<double>(same) / static_cast<double>(rim.size());
    return traits;
}

}  // namespace tactics
