// SPDX-License-Identifier: Apache-2.0
#include "filters/gradient.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "filters/edge_noise.h"
#include "filters/lab.h"
#include "filters/opencv.h"

namespace tactics {

double step_height_per_slope(double sigma) { return sigma < 0.1 ? 2.0 : 2.0 / std::erf(1.0 / (sigma * std::numbers::sqrt2)); }

float undirected(float angle) {
    constexpr float kPi = std::numbers::pi_v<float>;
    const float turned = angle < 0 ? angle + kPi : angle;
    return turned < kPi ? turned : 0;  // the sum of pi and a tiny negative angle is pi
}

namespace {

// The power that brings the mean of these samples, 0 to 1, to middle grey, or nearer to it: so a picture that was stored
// lighter or darker than another has the same contours.
double tone_of(const std::array<double, 256>& samples, const std::array<std::uint64_t, 256>& counts) {
    constexpr double kMiddle = 0.36;  // what is brighter has its shadows' noise and blocks raised with them
    constexpr double kMost = 1.5;
    const auto mean = [&](double power) {
        double sum = 0, all = 0;
        for (std::size_t v = 0; v < samples.size(); ++v) {
            const auto count = static_cast<double>(counts[v]);
            if (count > 0) sum += count * std::pow(samples[v], power);
            all += count;
        }
        return sum / all;
    };
    double low = 1 / kMost, high = kMost;
    constexpr int kHalvings = 10;
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = (low + high) / 2;
        (mean(middle) > kMiddle ? low : high) = middle;
    }
    return (low + high) / 2;
}

// A colour picture as an eye sees it that is used to its light: black, white and the middle between are the picture's own.
struct Adapted {
    Image picture;
    double gain = 1;  // levels here for one level of the picture, on the whole
};

Adapted adapted(const Image& picture) {
    constexpr double kOutside = 0.005;  // share of the pixels that may be darker or brighter
    std::array<std::uint64_t, 256> counts{};
    for (const std::uint8_t sample : picture.pixels) ++counts[sample];  // of all channels: colours may have one lightness
    const double most = kOutside * static_cast<double>(picture.pixels.size());
    const auto end = [&](int level, int step) {
        const auto count = [&] { return static_cast<double>(counts[static_cast<std::size_t>(level)]); };
        for (double outside = count(); outside <= most && level + step >= 0 && level + step < 256; outside += count())
            level += step;
        return level;
    };
    const int darkest = end(0, 1), brightest = end(255, -1);
    // Noise is not stretched to black and white: what has no more range than that is one grey.
    constexpr double kRangeOfNoise = 30;
    const double range =
        std::clamp(kRangeOfNoise * noise_level(to_grey(picture)), std::max(1.0, 0.0 + brightest - darkest), 255.0);
    const double black = std::clamp((darkest + brightest - range) / 2, 0.0, 255 - range);
    std::array<double, 256> stretched{};
    for (std::size_t v = 0; v < stretched.size(); ++v)
        stretched[v] = std::clamp((static_cast<double>(v) - black) / range, 0.0, 1.0);
    const double power = tone_of(stretched, counts);
    Adapted out{picture, 255 / range};
    std::array<std::uint8_t, 256> table{};
    std::transform(stretched.begin(), stretched.end(), table.begin(),
                   [power](double v) { return static_cast<std::uint8_t>(std::lround(255 * std::pow(v, power))); });
    for (auto& sample : out.picture.pixels) sample = table[sample];
    return out;
}

// Neighbours share noise if the picture was shrunk, blurred or compressed; at half the size it shows again. Of white noise
// the mean of four pixels has half.
double noise_of_plane(const std::vector<float>& plane, int width, int height, float middle) {
    Image image = make_image(width, height, 1, 0, 0);
    std::transform(plane.begin(), plane.end(), image.pixels.begin(),
                   [middle](float v) { return cv::saturate_cast<std::uint8_t>(v + middle); });
    const double whole = noise_level(image);
    if (width < 2 || height < 2) return whole;
    // Whole pairs of pixels are quick to average; the last odd ones are left out.
    Image half = make_image(width / 2, height / 2, 1, 0, 0);
    cv::Mat to = view_of(half);
    cv::resize(view_of(image)(cv::Rect(0, 0, 2 * half.width, 2 * half.height)), to, to.size(), 0, 0, cv::INTER_AREA);
    return std::max(whole, 2 * noise_level(half));
}

void add_plane(GradientTensor& tensor, const cv::Mat& plane, float scale) {
    const int width = tensor.width, last = width - 1;
    for (int y = 0; y < tensor.height; ++y) {
        const float* row = plane.ptr<float>(y);
        const float* above = plane.ptr<float>(std::max(y - 1, 0));
        const float* below = plane.ptr<float>(std::min(y + 1, tensor.height - 1));
        const std::size_t at = static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
        float *xx = &tensor.xx[at], *xy = &tensor.xy[at], *yy = &tensor.yy[at];
        const auto add = [&](int x, float left, float right) {
            const float gx = scale * (right - left);
            const float gy = scale * (below[x] - above[x]);
            xx[x] += gx * gx;
            xy[x] += gx * gy;
            yy[x] += gy * gy;
        };
        add(0, row[0], row[std::min(1, last)]);
        for (int x = 1; x < last; ++x) add(x, row[x - 1], row[x + 1]);
        if (last > 0) add(last, row[last - 1], row[last]);
    }
}

}  // namespace

Planes grey_plane(const Image& grey) {
    Planes planes{grey.width, grey.height, {}};
    planes.planes.push_back({std::vector<float>(grey.pixels.begin(), grey.pixels.end())});
    return planes;
}

// Colour is followed at this many times the scale of lightness. JPEG stores it at half the resolution, a camera's sensor
// has seen it at that, and an eye sees no finer (K. T. Mullen 1985: colour gratings to 12, grey ones to 35 periods a degree).
constexpr double kChromaWidth = 1.6;

// CIELAB bends: unadapted, a dark or faint copy of a picture has other strong contours.
Planes see(const Image& picture, double chroma_weight) {
    if (picture.channels == 1) {
        Planes planes = grey_plane(picture);
        planes.planes[0].noise = noise_of_plane(planes.planes[0].values, picture.width, picture.height, 0);
        return planes;
    }
    const Adapted light = adapted(picture);
    Planes planes{picture.width, picture.height, {}};
    auto lab = lab_planes(light.picture);
    constexpr float kLevelsPerL = 2.55f;
    for (std::size_t i = 0; i < lab.size(); ++i) {
        Plane plane{std::move(lab[i]), i == 0 ? 1 : kChromaWidth};
        const float scale = i == 0 ? kLevelsPerL : kLevelsPerL * static_cast<float>(chroma_weight);
        for (float& v : plane.values) v *= scale;
        plane.noise = noise_of_plane(plane.values, picture.width, picture.height, i == 0 ? 0.0f : 128.0f) / light.gain;
        for (float& v : plane.values) v /= static_cast<float>(light.gain);
        planes.planes.push_back(std::move(plane));
    }
    return planes;
}

double noise_of_gradient(const Planes& planes, double sigma) {
    double scale = 0;
    for (const Plane& plane : planes.planes) scale = std::hypot(scale, noise_scale(plane.noise, plane.width * sigma));
    return scale;
}

GradientTensor gradient_tensor(Planes planes, double sigma) {
    GradientTensor tensor{planes.width, planes.height, {}, {}, {}};
    const std::size_t count = static_cast<std::size_t>(planes.width) * static_cast<std::size_t>(planes.height);
    for (auto* moments : {&tensor.xx, &tensor.xy, &tensor.yy}) moments->assign(count, 0.0f);
    for (Plane& each : planes.planes) {
        const cv::Mat plane = view_of(each.values, planes.width, planes.height);
        const double wide = sigma * each.width;
        cv::Mat blurred = plane;
        if (wide >= 0.1) cv::GaussianBlur(plane, blurred, cv::Size(), wide, wide, cv::BORDER_REFLECT);
        add_plane(tensor, blurred, static_cast<float>(step_height_per_slope(wide) / 2));
    }
    return tensor;
}

namespace {

EdgeMap empty_map(const GradientTensor& tensor, double mm_per_pixel) {
    EdgeMap map;
    map.width = tensor.width;
    map.height = tensor.height;
    map.mm_per_pixel = mm_per_pixel;
    map.strength.resize(tensor.xx.size());
    map.normal.resize(tensor.xx.size());
    return map;
}

// The larger eigenvalue and its direction, without pooling.
EdgeMap principal_direction(const GradientTensor& tensor, double mm_per_pixel) {
    EdgeMap map = empty_map(tensor, mm_per_pixel);
    for (std::size_t i = 0; i < map.strength.size(); ++i) {
        const float half_difference = (tensor.xx[i] - tensor.yy[i]) / 2;
        map.strength[i] = std::sqrt((tensor.xx[i] + tensor.yy[i]) / 2 + std::hypot(half_difference, tensor.xy[i]));
        map.normal[i] = undirected(0.5f * std::atan2(tensor.xy[i], half_difference));
    }
    return map;
}

// Pixels whose sums are made at once.
constexpr std::size_t kBlock = 16;

// A plane with a border of mirrored pixels, so that sums along lines need no bounds; and a block more at its end, as rows
// are read in whole blocks.
struct Padded {
    int pad;
    std::size_t stride;
    std::vector<float> values;

    Padded(int width, int height, int border)
        : pad(border),
          stride(static_cast<std::size_t>(width + 2 * border)),
          values(stride * static_cast<std::size_t>(height + 2 * border) + kBlock) {}
    float* row(int y) { return values.data() + stride * static_cast<std::size_t>(y + pad) + pad; }
};

int mirrored(int at, int size) {
    const int period = 2 * size;
    const int folded = ((at % period) + period) % period;
    return folded < size ? folded : period - 1 - folded;
}

// Apart, and saying that nothing overlaps, so that the compiler makes four sums at a time.
void weighted_sum(const float* __restrict a, float of_a, const float* __restrict b, float of_b, const float* __restrict c,
                  float of_c, float* __restrict to, int count) {
    for (int x = 0; x < count; ++x) to[x] = of_a * a[x] + of_b * b[x] + of_c * c[x];
}

// Energy of the gradient's component in direction (c, s).
void directional_energy(Padded& energy, const GradientTensor& tensor, float c, float s) {
    const int width = tensor.width;
    for (int y = 0; y < tensor.height; ++y) {
        const std::size_t at = static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
        float* to = energy.row(y);
        weighted_sum(&tensor.xx[at], c * c, &tensor.xy[at], 2 * c * s, &tensor.yy[at], s * s, to, width);
        for (int x = 1; x <= energy.pad; ++x) {
            to[-x] = to[mirrored(-x, width)];
            to[width - 1 + x] = to[mirrored(width - 1 + x, width)];
        }
    }
    const auto copy_row = [&](int to, int from) {
        std::copy_n(energy.row(from) - energy.pad, energy.stride, energy.row(to) - energy.pad);
    };
    for (int y = 1; y <= energy.pad; ++y) {
        copy_row(-y, mirrored(-y, tensor.height));
        copy_row(tensor.height - 1 + y, mirrored(tensor.height - 1 + y, tensor.height));
    }
}

struct Tap {
    std::ptrdiff_t offset;
    float weight;
};

// Samples along the line across (c, s), as offsets in the padded plane, with Gaussian weights that add up to one.
std::vector<Tap> taps_along(double along, double c, double s, std::size_t stride) {
    const int reach = static_cast<int>(std::ceil(2 * along));
    std::vector<Tap> taps;
    float total = 0;
    for (int t = -reach; t <= reach; ++t) {
        const auto weight = static_cast<float>(std::exp(-0.5 * t * t / (along * along)));
        taps.push_back({std::lround(t * c) * static_cast<std::ptrdiff_t>(stride) + std::lround(-t * s), weight});
        total += weight;
    }
    for (auto& tap : taps) tap.weight /= total;
    return taps;
}

// The best answer so far, in rows that end on whole blocks.
struct Best {
    std::size_t stride;
    std::vector<float> energy, angle;

    Best(int width, int height)
        : stride((static_cast<std::size_t>(width) + kBlock - 1) / kBlock * kBlock),
          energy(stride * static_cast<std::size_t>(height)),
          angle(energy.size()) {}
};

// Collects a row of energy along the taps and keeps what is stronger than before, with its angle. A block stays in
// registers over all taps, which is what makes this cheap: it is most of the work of the filter.
void keep_stronger(const float* energy, std::span<const Tap> taps, float angle, float* best, float* best_angle,
                   std::size_t count) {
    constexpr std::size_t kLanes = cv::v_float32x4::nlanes;
    static_assert(kBlock == 4 * kLanes);
    const cv::v_float32x4 angles = cv::v_setall_f32(angle);
    for (std::size_t x = 0; x < count; x += kBlock) {
        std::array<cv::v_float32x4, 4> sums;
        sums.fill(cv::v_setzero_f32());
        for (const Tap& tap : taps) {
            const float* at = energy + static_cast<std::ptrdiff_t>(x) + tap.offset;
            const cv::v_float32x4 weight = cv::v_setall_f32(tap.weight);
            for (std::size_t i = 0; i < 4; ++i) sums[i] += weight * cv::v_load(at + i * kLanes);
        }
        for (std::size_t i = 0; i < 4; ++i) {
            float *to = best + x + i * kLanes, *to_angle = best_angle + x + i * kLanes;
            const cv::v_float32x4 before = cv::v_load(to), stronger = sums[i] > before;
            cv::v_store(to, cv::v_select(stronger, sums[i], before));
            cv::v_store(to_angle, cv::v_select(stronger, angles, cv::v_load(to_angle)));
        }
    }
}

}  // namespace

EdgeMap strongest_direction(const GradientTensor& tensor, double along, double mm_per_pixel) {
    if (along < 0.5) return principal_direction(tensor, mm_per_pixel);
    EdgeMap map = empty_map(tensor, mm_per_pixel);
    const auto width = static_cast<std::size_t>(tensor.width);
    Padded energy(tensor.width, tensor.height, static_cast<int>(std::ceil(2 * along)) + 1);
    Best best(tensor.width, tensor.height);
    for (int k = 0; k < kPoolingDirections; ++k) {
        const double angle = std::numbers::pi * k / kPoolingDirections;
        directional_energy(energy, tensor, static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)));
        const auto taps = taps_along(along, std::cos(angle), std::sin(angle), energy.stride);
        for (int y = 0; y < tensor.height; ++y) {
            const std::size_t at = static_cast<std::size_t>(y) * best.stride;
            keep_stronger(energy.row(y), taps, static_cast<float>(angle), &best.energy[at], &best.angle[at], width);
        }
    }
    for (std::size_t y = 0; y < static_cast<std::size_t>(tensor.height); ++y) {
        const float* from = &best.energy[y * best.stride];
        std::transform(from, from + width, &map.strength[y * width], [](float e) { return std::sqrt(e); });
        std::copy_n(&best.angle[y * best.stride], width, &map.normal[y * width]);
    }
    return map;
}

}  // namespace tactics
