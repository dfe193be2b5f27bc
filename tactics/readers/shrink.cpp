// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/shrink.h"

#include <sys/mman.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <stdexcept>

namespace tactics {

Size shrunk_size(Size size, int longest) {
    const int longer = std::max(size.width, size.height);
    if (longest <= 0 || longer <= longest) return size;
    const auto scaled = [&](int side) {
        const long long twice = 2LL * side * longest + longer;  // rounded to nearest
        return std::max(1, static_cast<int>(twice / (2LL * longer)));
    };
    return {scaled(size.width), scaled(size.height)};
}

namespace {

// Of memory that is not touched yet. Where rows come one after the other, a fault for each 4 kB takes a fifth of the time of
// decoding them. If the kernel has no large pages, all is as without.
void ask_for_large_pages(void* begin, std::size_t bytes) {
    constexpr std::size_t kLarge = 2u << 20;
    std::size_t room = bytes;
    if (std::align(kLarge, kLarge, begin, room) != nullptr) madvise(begin, room / kLarge * kLarge, MADV_HUGEPAGE);
}

}  // namespace

// Both grids are laid over a finer one of whole parts: an input pixel is 8 * `to` parts long and an output pixel `eighths`
// parts (both divided by their common factor). All weights are then integers. The sums cannot overflow: a column sum is
// at most 255 * 8 * kMaxSide < 2^29, a pixel sum at most 255 * 64 * kMaxPixels < 2^44.
template <class Sample>
RowShrinker<Sample>::RowShrinker(Size from, Size to, int channels, Size eighths) : from_(from), to_(to), channels_(channels) {
    const auto fits = [](int pixels, int result, int extent) {
        return result >= 1 && extent >= 8 * result && extent > 8 * (pixels - 1) && extent <= 8 * pixels;
    };
    if (!fits(from.width, to.width, eighths.width) || !fits(from.height, to.height, eighths.height))
        throw std::logic_error("RowShrinker: not a smaller picture");
    const int common_x = std::gcd(eighths.width, 8 * to.width);
    const int common_y = std::gcd(eighths.height, 8 * to.height);
    width_parts_ = static_cast<std::uint32_t>(eighths.width / common_x);
    pixel_parts_x_ = static_cast<std::uint32_t>(8 * to.width / common_x);
    height_parts_ = static_cast<std::uint32_t>(eighths.height / common_y);
    pixel_parts_y_ = static_cast<std::uint32_t>(8 * to.height / common_y);
    const auto samples = static_cast<std::size_t>(from.width) * static_cast<std::size_t>(channels);
    if (width_parts_ != pixel_parts_x_ || height_parts_ != pixel_parts_y_) {
        // A pixel more, of which no part is ever taken.
        sums_.assign(samples + static_cast<std::size_t>(channels), Sum{});
        find_covers();
    }
    // A claimed size is not trusted: more memory than this is allocated only when the rows have arrived.
    constexpr std::size_t kTrustedBytes = 64u << 20;
    const auto all =
        static_cast<std::size_t>(to.width) * static_cast<std::size_t>(to.height) * static_cast<std::size_t>(channels);
    pixels_.reserve(std::min(all, kTrustedBytes / sizeof(Sample)));
    ask_for_large_pages(pixels_.data(), pixels_.capacity() * sizeof(Sample));
}

namespace {

template <class Sample, class Sum>
void add_weighted(Sum* sums, const Sample* row, std::uint32_t weight, std::size_t count) {
    if (weight == 1) {
        for (std::size_t i = 0; i < count; ++i) sums[i] += static_cast<Sum>(row[i]);
    } else {
        const Sum factor = static_cast<Sum>(weight);
        for (std::size_t i = 0; i < count; ++i) sums[i] += factor * static_cast<Sum>(row[i]);
    }
}

// Rounded quotients by one multiplication. `sum` + 1/2 stays at least 1/2 away from every multiple of `parts`, which is
// more than a double can lose below 2^44 when `parts` is below 2^36.
class Quotient {
public:
    explicit Quotient(std::uint64_t parts) : half_(parts / 2), inverse_(1.0 / static_cast<double>(parts)) {}
    std::uint8_t of(std::uint64_t sum) const {
        return static_cast<std::uint8_t>((static_cast<double>(static_cast<std::int64_t>(sum + half_)) + 0.5) * inverse_);
    }

private:
    std::uint64_t half_;
    double inverse_;
};

struct Mean {
    explicit Mean(double parts) : inverse(1.0 / parts) {}
    float of(double sum) const { return static_cast<float>(sum * inverse); }
    double inverse;
};

}  // namespace

template <class Sample>
void RowShrinker<Sample>::add(const Sample* row) {
    const std::size_t samples = static_cast<std::size_t>(from_.width) * static_cast<std::size_t>(channels_);
    if (sums_.empty()) {
        pixels_.insert(pixels_.end(), row, row + samples);
        return;
    }
    const std::uint32_t room = height_parts_ - filled_;
    if (pixel_parts_y_ < room) {
        add_weighted(sums_.data(), row, pixel_parts_y_, samples);
        filled_ += pixel_parts_y_;
        return;
    }
    add_weighted(sums_.data(), row, room, samples);
    emit();
    filled_ = pixel_parts_y_ - room;
    if (filled_ == 0)
        std::fill(sums_.begin(), sums_.end(), Sum{});
    else
        for (std::size_t i = 0; i < samples; ++i) sums_[i] = static_cast<Sum>(filled_) * static_cast<Sum>(row[i]);
}

template <class Sample>
void RowShrinker<Sample>::find_covers() {
    covers_.reserve(static_cast<std::size_t>(to_.width));
    std::uint32_t at = 0, carried = 0;  // the parts of pixel `at` that the output pixel before has not used
    for (int x = 0; x < to_.width; ++x) {
        Cover cover{at, 0, carried, 0};
        std::uint32_t open = width_parts_ - carried;
        if (carried > 0) ++at;
        cover.whole = open / pixel_parts_x_;
        at += cover.whole;
        cover.last_parts = open % pixel_parts_x_;
        carried = cover.last_parts > 0 ? pixel_parts_x_ - cover.last_parts : 0;
        covers_.push_back(cover);
    }
}

// The sums of a finished row, averaged from left to right in the same way.
template <class Sample>
void RowShrinker<Sample>::emit() {
    using Wide = std::conditional_t<std::is_same_v<Sample, float>, double, std::uint64_t>;
    using Divide = std::conditional_t<std::is_same_v<Sample, float>, Mean, Quotient>;
    const Divide divide(static_cast<Wide>(width_parts_) * static_cast<Wide>(height_parts_));
    const auto start = pixels_.size(), step = static_cast<std::size_t>(channels_);
    pixels_.resize(start + static_cast<std::size_t>(to_.width) * step);
    const Wide parts = static_cast<Wide>(pixel_parts_x_);
    for (std::size_t c = 0; c < step; ++c) {
        Sample* out = pixels_.data() + start + c;
        for (const Cover& cover : covers_) {
            const Sum* in = sums_.data() + cover.first * step + c;
            Wide sum = static_cast<Wide>(cover.first_parts) * static_cast<Wide>(*in);
            if (cover.first_parts > 0) in += step;
            Wide whole = 0;
            for (std::uint32_t i = 0; i < cover.whole; ++i, in += step) whole += static_cast<Wide>(*in);
            sum += parts * whole;
            sum += static_cast<Wide>(cover.last_parts) * static_cast<Wide>(*in);
            *out = divide.of(sum);
            out += step;
        }
    }
}

template class RowShrinker<std::uint8_t>;
template class RowShrinker<float>;

}  // namespace tactics
