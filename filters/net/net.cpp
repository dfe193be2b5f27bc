// SPDX-License-Identifier: Apache-2.0
#include "filters/net/net.h"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "filters/net/input.h"
#include "filters/net/plane.h"

namespace tactics {

namespace {

// The largest of 2 x 2 pixels.
void pool(const NetPlane& from, NetPlane& to) {
    const int channels = from.channels();
    for (int y = 0; y < to.height(); ++y)
        for (int x = 0; x < to.width(); ++x) {
            const std::int16_t *upper = from.at(2 * x, 2 * y), *lower = from.at(2 * x, 2 * y + 1);
            std::int16_t* out = to.at(x, y);
            for (int group = 0; group < channels; group += kChannelGroup)
                for (int c = group; c < group + kChannelGroup; ++c)
                    out[c] = std::max(std::max(upper[c], upper[c + channels]), std::max(lower[c], lower[c + channels]));
        }
}

// `fine`, plus `coarse` twice as large: a sample is 9, 3, 3 and 1 sixteenths of the four around it. With a ReLU.
void join(const NetPlane& coarse, NetPlane& fine) {
    const int channels = coarse.channels(), width = coarse.width();
    // Three parts of a row and one of the next one: at most 4 * kMostActivation, an int16. The ends are there twice.
    std::vector<std::int16_t> mixed(static_cast<std::size_t>((width + 2) * channels));
    for (int y = 0; y < fine.height(); ++y) {
        const int near = y / 2, far = std::clamp(y % 2 == 0 ? near - 1 : near + 1, 0, coarse.height() - 1);
        const std::int16_t *three = coarse.at(0, near), *one = coarse.at(0, far);
        std::int16_t* middle = mixed.data() + channels;
        for (int i = 0; i < width * channels; ++i) middle[i] = static_cast<std::int16_t>(3 * three[i] + one[i]);
        std::copy_n(middle, channels, mixed.data());
        std::copy_n(middle + (width - 1) * channels, channels, middle + width * channels);
        for (int x = 0; x < fine.width(); ++x) {
            const std::int16_t* here = middle + x / 2 * channels;
            const std::int16_t* beside = x % 2 == 0 ? here - channels : here + channels;
            std::int16_t* out = fine.at(x, y);
            for (int group = 0; group < channels; group += kChannelGroup)
                for (int c = group; c < group + kChannelGroup; ++c)
                    out[c] =
                        static_cast<std::int16_t>(std::clamp(out[c] + ((3 * here[c] + beside[c] + 8) >> 4), 0, kMostActivation));
        }
    }
}

// Runs the layers in their order.
class Runner {
public:
    Runner(const ContourNet& net, const NetKernel& kernel) : net_(net), kernel_(kernel), next_(net.layers().begin()) {}

    // `input` is what see() made; calls `row_done(y, row)` with rows of 8 channels, of which the first is the logit.
    template <class RowDone>
    void run(const NetPlane& input, const RowDone& row_done) {
        const auto& channels = net_.channels();
        const int width = input.width(), height = input.height();
        std::vector<NetPlane> planes, spare, pooled;
        for (std::size_t scale = 0; scale < 4; ++scale) {
            const int down = 1 << scale;
            if (scale > 0) pooled.emplace_back(width / down, height / down, channels[scale - 1]);
            planes.emplace_back(width / down, height / down, channels[scale]);
            spare.emplace_back(width / down, height / down, channels[scale]);
        }
        for (std::size_t scale = 0; scale < 4; ++scale) {
            if (scale > 0) pool(planes[scale - 1], pooled[scale - 1]);
            dense(scale == 0 ? input : pooled[scale - 1], planes[scale], 0);
            for (int i = 0; i < net_.blocks()[scale]; ++i) residual(planes[scale], spare[scale]);
        }
        for (std::size_t scale = 3; scale-- > 0;) {
            dense(planes[scale + 1], pooled[scale], -kMostActivation);
            join(pooled[scale], planes[scale]);
            if (scale > 0) residual(planes[scale], spare[scale]);
        }
        const NetLayer &last = *next_++, &out = *next_;
        std::vector<std::int16_t> features(row_size(last, width)), logits(row_size(out, width));
        for (int y = 0; y < height; ++y) {
            dense_row(last, planes[0], y, nullptr, features.data(), 0);
            kernel_.dense({&out, {features.data()}, nullptr, logits.data(), width, -kMostActivation});
            row_done(y, logits.data());
        }
    }

private:
    static std::size_t row_size(const NetLayer& layer, int width) {
        return static_cast<std::size_t>((width + kReadBeyond) * layer.outputs);
    }

    void dense_row(const NetLayer& layer, const NetPlane& in, int y, const std::int16_t* add, std::int16_t* out,
                   int least) const {
        DenseRow row{&layer, {}, add, out, in.width(), least};
        const int reach = layer.side / 2;
        for (int down = 0; down < layer.side; ++down) row.in[static_cast<std::size_t>(down)] = in.at(-reach, y + down - reach);
        kernel_.dense(row);
    }

    void dense(const NetPlane& in, NetPlane& out, int least) {
        const NetLayer& layer = *next_++;
        for (int y = 0; y < in.height(); ++y) dense_row(layer, in, y, nullptr, out.at(0, y), least);
    }

    // What comes in, plus two convolutions of it; `spare` is of the same size.
    void residual(NetPlane& plane, NetPlane& spare) {
        const NetLayer &first = *next_++, &second = *next_++;
        if (!first.each) {
            for (int y = 0; y < plane.height(); ++y) dense_row(first, plane, y, nullptr, spare.at(0, y), 0);
            for (int y = 0; y < plane.height(); ++y) dense_row(second, spare, y, plane.at(0, y), plane.at(0, y), 0);
            return;
        }
        std::vector<std::int16_t> between(row_size(first, plane.width()));
        const int reach = first.side / 2;
        for (int y = 0; y < plane.height(); ++y) {
            EachRow row{&first, {}, between.data(), plane.width()};
            for (int down = 0; down < first.side; ++down)
                row.in[static_cast<std::size_t>(down)] = plane.at(-reach, y + down - reach);
            kernel_.each(row);
            kernel_.dense({&second, {between.data()}, plane.at(0, y), spare.at(0, y), plane.width(), 0});
        }
        std::swap(plane, spare);
    }

    const ContourNet& net_;
    const NetKernel& kernel_;
    std::span<const NetLayer>::iterator next_;
};

constexpr int kCoarsest = 16;  // pixels of the picture to a pixel of the coarsest scale

int whole(int pixels) { return (pixels + kCoarsest - 1) / kCoarsest * kCoarsest; }

// How far a logit sees, in pixels of the picture, in whole pixels of the coarsest scale: the reach of every layer on the way
// down and up, at its scale, in samples of the input, which has half the picture's size. What is kept of a tile begins and ends
// between pixels of the coarsest scale, so that pooling adds nothing.
int reach_of(const ContourNet& net) {
    const auto& blocks = net.blocks();
    const int down = (1 + 2 * blocks[0]) + 2 * (1 + 2 * blocks[1]) + 4 * (1 + 2 * blocks[2]) + 8 * 2 * blocks[3];
    const int up = 8 + 4 * 2 + 4 + 2 + 2 + 1;
    return whole(2 * (kInputReach + down + up));
}

// A part of the picture's width or height: run from `begin` to `end`, of which `first` to `last` is kept.
struct Part {
    int begin, end, first, last;
};

std::vector<Part> parts_of(int length, int most, int reach) {
    if (length <= most) return {{0, length, 0, length}};
    std::vector<Part> parts;
    for (int first = 0; first < length;) {
        const int begin = std::max(0, first - reach), end = std::min(length, begin + most);
        const int last = end == length ? length : end - reach;
        parts.push_back({begin, end, first, last});
        first = last;
    }
    return parts;
}

}  // namespace

ContourLogits logits_of(const ContourNet& net, const Image& image, const NetLevels& levels, const NetRun& run) {
    if (image.width < 1 || image.height < 1 || (image.channels != 1 && image.channels != 3))
        throw std::logic_error("logits_of: not a picture");
    const NetKernel& kernel = run.kernel != nullptr ? *run.kernel : *net_kernels().front();
    const int width = whole(image.width), height = whole(image.height), reach = reach_of(net);
    ContourLogits logits{(image.width + 1) / 2, (image.height + 1) / 2, {}};
    logits.values.resize(static_cast<std::size_t>(logits.width) * static_cast<std::size_t>(logits.height));

    // A tile keeps at least as much as it throws away on one side; broad ones are low.
    const auto side_of = [&](long long most) {
        return static_cast<int>(std::max<long long>(most / kCoarsest * kCoarsest, 3 * reach));
    };
    const int widest = side_of(static_cast<long long>(std::sqrt(static_cast<double>(run.most_pixels))));
    const int highest = side_of(run.most_pixels / std::min(width, widest));
    for (const Part& rows : parts_of(height, highest, reach))
        for (const Part& columns : parts_of(width, widest, reach)) {
            NetPlane input((columns.end - columns.begin) / 2, (rows.end - rows.begin) / 2, net.layers().front().inputs);
            see(image, levels, columns.begin, rows.begin, input);
            const int first = columns.first / 2, last = std::min(columns.last / 2, logits.width);
            Runner(net, kernel).run(input, [&](int y, const std::int16_t* row) {
                const int to = rows.begin / 2 + y;
                if (to < rows.first / 2 || to >= std::min(rows.last / 2, logits.height)) return;
                std::int16_t* out = &logits.values[static_cast<std::size_t>(to) * static_cast<std::size_t>(logits.width)];
                for (int x = first; x < last; ++x) out[x] = row[(x - columns.begin / 2) * kChannelGroup];
            });
        }
    return logits;
}

ContourLogits logits_of(const ContourNet& net, const Image& image, const NetRun& run) {
    return logits_of(net, image, net_levels(image), run);
}

}  // namespace tactics
