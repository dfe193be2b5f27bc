// SPDX-License-Identifier: Apache-2.0
#include "tactics/lettering/pale_lines.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tactics {

namespace {

// Settings, grey levels: the darkest that a pale line may be, as print and axes are darker; what is less off the ground than that
// is ground; by how much the pixels of a line differ.
constexpr int kDarkest = 96, kFaintLine = 6, kSameGrey = 8;
constexpr int kLeastLength = 60, kBeside = 4;  // pixels: letters are shorter; so near beside a thin line is ground
constexpr double kOfLine = 0.5,
                 kOfSide = 0.12;  // share of a line that nothing is printed over; its length, of the picture's side
constexpr double kBare = 0.6;     // share of a line that has ground on both sides
constexpr int kLightGround = 200;

// A row or a column of the picture.
class PixelLine {
public:
    PixelLine(const Image& grey, bool upright, int at)
        : first_(upright ? grey.row(0) + at : grey.row(at)),
          step_(upright ? static_cast<std::ptrdiff_t>(grey.row_bytes()) : 1),
          count_(upright ? grey.height : grey.width) {}
    int operator[](int i) const { return first_[static_cast<std::ptrdiff_t>(i) * step_]; }
    int count() const { return count_; }

private:
    const std::uint8_t* first_;
    std::ptrdiff_t step_;
    int count_;
};

struct PaleSegment {
    int begin = 0, end = 0, grey = 0;
};

// The commonest grey.
int ground_of_print(const Image& grey) {
    std::array<std::size_t, 256> counts{};
    for (const std::uint8_t value : grey.pixels) ++counts[value];
    return static_cast<int>(std::max_element(counts.begin(), counts.end()) - counts.begin());
}

// The grey between the faintest and the darkest that most pixels have, if they may be a line; else -1.
int pale_grey_of(const PixelLine& line, int ground, int least) {
    std::array<int, 256> counts{};
    for (int i = 0; i < line.count(); ++i) ++counts[static_cast<std::size_t>(line[i])];
    const auto from = counts.begin() + kDarkest,
               to = counts.begin() + std::max(kDarkest + 1, ground - kFaintLine - kSameGrey + 1);
    const auto most = std::max_element(from, to);
    const int grey = static_cast<int>(most - counts.begin());
    int all = 0;
    for (int value = std::max(kDarkest, grey - kSameGrey); value <= std::min(255, grey + kSameGrey); ++value)
        all += counts[static_cast<std::size_t>(value)];
    return all >= least ? grey : -1;
}

class PaleLines {
public:
    explicit PaleLines(const Image& grey) : grey_(grey), ground_(ground_of_print(grey)) {}

    bool may_be() const { return ground_ >= kLightGround; }

    std::vector<PaleSegment> segments(bool upright, int at) const {
        const int across = upright ? grey_.width : grey_.height;
        const PixelLine line(grey_, upright, at);
        const int least = std::max(kLeastLength, static_cast<int>(kOfSide * line.count()));
        if (at < kBeside || at + kBeside >= across) return {};
        const int grey = pale_grey_of(line, ground_, static_cast<int>(kOfLine * least));
        if (grey < 0) return {};
        const PixelLine before(grey_, upright, at - kBeside), behind(grey_, upright, at + kBeside);
        std::vector<PaleSegment> found;
        for (int begin = 0; begin < line.count();) {
            int end = begin, bare = 0, on_ground[2] = {0, 0};
            for (; end < line.count() && line[end] <= grey + kSameGrey; ++end) {
                bare += line[end] >= grey - kSameGrey ? 1 : 0;
                on_ground[0] += is_ground_like(before[end]) ? 1 : 0;
                on_ground[1] += is_ground_like(behind[end]) ? 1 : 0;
            }
            if (end - begin >= least && bare >= kOfLine * (end - begin) &&
                std::min(on_ground[0], on_ground[1]) >= kBare * (end - begin))
                found.push_back({begin, end, grey});
            begin = end + 1;
        }
        return found;
    }

    // As it was before the line was there, whose grey it has where it is bare.
    std::uint8_t without(int value, int grey) const {
        return static_cast<std::uint8_t>(std::min(ground_, value * ground_ / grey));
    }

private:
    bool is_ground_like(int value) const { return value >= ground_ - kFaintLine; }

    const Image& grey_;
    int ground_;
};

}  // namespace

Image without_pale_lines(Image grey) {
    const PaleLines lines(grey);
    if (!lines.may_be()) return grey;
    Image without = grey;
    for (const bool upright : {false, true})
        for (int at = 0; at < (upright ? grey.width : grey.height); ++at)
            for (const PaleSegment& segment : lines.segments(upright, at))
                for (int i = segment.begin; i < segment.end; ++i) {
                    std::uint8_t& pixel = upright ? without.row(i)[at] : without.row(at)[i];
                    pixel = lines.without(pixel, segment.grey);
                }
    return without;
}

}  // namespace tactics
