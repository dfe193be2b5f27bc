// SPDX-License-Identifier: Apache-2.0
#include "filters/colour_fields.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "filters/darken.h"
#include "filters/opencv.h"

namespace tactics {

namespace {

constexpr int kLikeGround = 24;  // levels in any channel; JPEG leaves less around a frame
constexpr int kFieldFrame = 3;   // pixels of a field's or bar's rim that its frame and blur may have

using PlainGround = std::array<int, 3>;

bool is_like_ground(const std::uint8_t* at, const PlainGround& ground) {
    return std::max({std::abs(at[0] - ground[0]), std::abs(at[1] - ground[1]), std::abs(at[2] - ground[2])}) <= kLikeGround;
}

// 255 where the ground is not reached from outside `box`: what stands on it, and all within.
cv::Mat things_on(const cv::Mat& picture, const PixelBox& box, const PlainGround& ground) {
    cv::Mat open(box.height() + 2, box.width() + 2, CV_8UC1, cv::Scalar(255)), label;
    for (int y = 0; y < box.height(); ++y)
        for (int x = 0; x < box.width(); ++x)
            if (!is_like_ground(picture.ptr(y + box.top) + static_cast<std::ptrdiff_t>(3) * (x + box.left), ground))
                open.ptr(y + 1)[x + 1] = 0;
    cv::connectedComponents(open, label, 4, CV_32S);
    return label(cv::Rect(1, 1, box.width(), box.height())) != label.at<int>(0, 0);
}

// Full rectangles among the things; ticks and words that touch them are no part of one.
std::vector<PixelBox> rectangles_in(const cv::Mat& picture, const PixelBox& box, const PlainGround& ground) {
    constexpr int kTick = 5;           // pixels; what is narrower is a tick, a line or a letter
    constexpr double kFull = 0.97;     // of its box
    constexpr int kShortest = 24;      // pixels of the longer side
    constexpr int kMostPieces = 4000;  // print has some hundred
    cv::Mat solid, label, sizes, middles;
    cv::morphologyEx(things_on(picture, box, ground), solid, cv::MORPH_OPEN,
                     cv::getStructuringElement(cv::MORPH_RECT, {kTick, kTick}), {-1, -1}, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
    const int count = std::min(cv::connectedComponentsWithStats(solid, label, sizes, middles, 4, CV_32S), kMostPieces);
    std::vector<PixelBox> found;
    for (int i = 1; i < count; ++i) {
        const int left = sizes.at<int>(i, cv::CC_STAT_LEFT), top = sizes.at<int>(i, cv::CC_STAT_TOP),
                  wide = sizes.at<int>(i, cv::CC_STAT_WIDTH), high = sizes.at<int>(i, cv::CC_STAT_HEIGHT);
        if (std::max(wide, high) < kShortest || sizes.at<int>(i, cv::CC_STAT_AREA) < kFull * wide * high) continue;
        found.push_back({box.left + left, box.top + top, box.left + left + wide, box.top + top + high});
    }
    return found;
}

PixelBox shrunk_by(const PixelBox& box, int by) { return {box.left + by, box.top + by, box.right - by, box.bottom - by}; }

// The middle colour along the rim, and the share of the rim that looks like it.
std::pair<PlainGround, double> rim_colour_of(const cv::Mat& picture, const PixelBox& box) {
    std::vector<const std::uint8_t*> rim;
    const auto add = [&](int x, int y) { rim.push_back(picture.ptr(y) + static_cast<std::ptrdiff_t>(3) * x); };
    for (int x = box.left; x < box.right; ++x) add(x, box.top), add(x, box.bottom - 1);
    for (int y = box.top; y < box.bottom; ++y) add(box.left, y), add(box.right - 1, y);
    PlainGround middle{};
    std::vector<int> channel(rim.size());
    for (std::size_t c = 0; c < 3; ++c) {
        std::transform(rim.begin(), rim.end(), channel.begin(), [c](const std::uint8_t* at) { return at[c]; });
        std::nth_element(channel.begin(), channel.begin() + static_cast<std::ptrdiff_t>(channel.size() / 2), channel.end());
        middle[c] = channel[channel.size() / 2];
    }
    const auto like = std::count_if(rim.begin(), rim.end(), [&](const std::uint8_t* at) { return is_like_ground(at, middle); });
    return {middle, static_cast<double>(like) / static_cast<double>(rim.size())};
}

struct BarStrip {
    ColourBar bar;
    ColourScale scale;
};

// The strips with a scale among the rectangles, taken out of them.
std::vector<BarStrip> take_bars(const cv::Mat& picture, std::vector<PixelBox>& boxes, double side) {
    constexpr double kNarrow = 4.5, kShortest = 0.12;  // times as long as wide; of the picture's longer side
    std::vector<BarStrip> strips;
    std::erase_if(boxes, [&](const PixelBox& box) {
        const int longer = std::max(box.width(), box.height()), shorter = std::min(box.width(), box.height());
        if (longer < kNarrow * shorter) return false;
        const int frame = std::min(kFieldFrame, shorter / 4);
        if (longer < kShortest * side) return true;
        if (auto scale = scale_of_bar(picture, shrunk_by(box, frame)))
            strips.push_back({{box, box.height() > box.width()}, std::move(*scale)});
        return true;
    });
    return strips;
}

// How much of a box is in the colours of a scale, and of how much of the scale.
struct ScaleAgreement {
    double on_scale = 0, span = 0, plain = 0;
    bool holes = false;
};

ScaleAgreement agreement_with(const cv::Mat& picture, const PixelBox& box, const ColourScale& scale, const PlainGround& ground,
                              double side) {
    constexpr double kEnds = 0.05;  // of the pixels are beyond each end of the span
    constexpr double kHole = 0.02;  // of the picture's side: wider than a line
    constexpr double kMostHoles = 0.02;
    cv::Mat off(box.height(), box.width(), CV_8UC1, cv::Scalar(0));
    std::vector<double> positions;
    std::size_t plain = 0;
    for (int y = box.top; y < box.bottom; ++y)
        for (int x = box.left; x < box.right; ++x) {
            const std::uint8_t* at = picture.ptr(y) + static_cast<std::ptrdiff_t>(3) * x;
            plain += is_like_ground(at, ground) ? 1 : 0;
            if (const auto found = scale.nearest(at); found.away <= kOnScale)
                positions.push_back(found.position);
            else
                off.ptr(y - box.top)[x - box.left] = 255;
        }
    ScaleAgreement agreement;
    const double all = static_cast<double>(box.width()) * box.height();
    agreement.on_scale = static_cast<double>(positions.size()) / all;
    agreement.plain = static_cast<double>(plain) / all;
    if (positions.empty()) return agreement;
    std::sort(positions.begin(), positions.end());
    const auto at = [&](double share) {
        return positions[static_cast<std::size_t>(share * static_cast<double>(positions.size() - 1))];
    };
    agreement.span = at(1 - kEnds) - at(kEnds);
    const int hole = 2 * static_cast<int>(std::ceil(kHole * side / 2)) + 1;
    cv::morphologyEx(off, off, cv::MORPH_OPEN, cv::getStructuringElement(cv::MORPH_RECT, {hole, hole}));
    agreement.holes = cv::countNonZero(off) > kMostHoles * all;
    return agreement;
}

bool is_field(const ScaleAgreement& agreement) {
    constexpr double kFilled = 0.8, kSpan = 0.2, kMostPlain = 0.6;
    return agreement.on_scale >= kFilled && agreement.span >= kSpan && agreement.plain <= kMostPlain && !agreement.holes;
}

double boxes_apart(const PixelBox& a, const PixelBox& b) {
    return std::hypot(std::max({0, a.left - b.right, b.left - a.right}), std::max({0, a.top - b.bottom, b.top - a.bottom}));
}

// Numbers or ticks stand beside it, as beside no framed photograph.
bool has_axes(const cv::Mat& picture, const PixelBox& box, const PlainGround& ground) {
    constexpr int kBesideField = 6;  // pixels: the frame, its blur and a shadow
    constexpr int kFewLetters = 60;  // pixels of ink
    const PixelBox around = shrunk_by(box, -kBesideField);
    int ink = 0;
    for (int y = 0; y < picture.rows && ink < kFewLetters; ++y)
        for (int x = 0; x < picture.cols; ++x) {
            const bool beside = x < around.left || y < around.top || x >= around.right || y >= around.bottom;
            ink += beside && !is_like_ground(picture.ptr(y) + static_cast<std::ptrdiff_t>(3) * x, ground) ? 1 : 0;
        }
    return ink >= kFewLetters;
}

// The nearest bar that has its colours.
std::optional<ColourField> field_of_bar(const cv::Mat& picture, const PixelBox& box, std::vector<BarStrip> strips,
                                        const PlainGround& ground, double side) {
    std::stable_sort(strips.begin(), strips.end(), [&](const BarStrip& a, const BarStrip& b) {
        return boxes_apart(a.bar.box, box) < boxes_apart(b.bar.box, box);
    });
    for (BarStrip& strip : strips)
        if (is_field(agreement_with(picture, shrunk_by(box, kFieldFrame), strip.scale, ground, side)))
            return ColourField{box, std::move(strip.scale), strip.bar};
    return std::nullopt;
}

}  // namespace

cv::Mat three_channels(const Image& picture) {
    const cv::Mat own = view_of(picture);
    if (picture.channels == 3) return own;
    cv::Mat colours;
    cv::cvtColor(own, colours, cv::COLOR_GRAY2RGB);
    return colours;
}

std::vector<ColourField> colour_fields_in(const Image& picture) {
    constexpr double kRim = 0.6, kLeastSide = 0.12, kLeastArea = 0.04, kLeastAlone = 0.2;
    if (std::min(picture.width, picture.height) < 40) return {};
    const cv::Mat pixels = three_channels(picture);
    const PixelBox all = all_of(picture.width, picture.height);
    auto [ground, share] = rim_colour_of(pixels, all);
    // What is cut off close to the frame has its ground within.
    if (share < kRim) ground = ground_of(picture);
    const double side = std::max(picture.width, picture.height), area = static_cast<double>(picture.width) * picture.height;
    std::vector<PixelBox> boxes = rectangles_in(pixels, all, ground);
    const std::vector<BarStrip> strips = take_bars(pixels, boxes, side);
    std::vector<ColourField> fields;
    for (const PixelBox& box : boxes) {
        const double own = static_cast<double>(box.width()) * box.height();
        if (std::min(box.width(), box.height()) < kLeastSide * side || own < kLeastArea * area) continue;
        // A frame may hold more than the field: the panel that it stands on.
        std::vector<PixelBox> inner{box};
        if (const auto [rim, plain] = rim_colour_of(pixels, shrunk_by(box, kFieldFrame + 1)); plain >= kRim) {
            std::vector<PixelBox> within = rectangles_in(pixels, shrunk_by(box, kFieldFrame + 1), rim);
            std::erase_if(within, [&](const PixelBox& one) { return 2.0 * one.width() * one.height() < own; });
            inner.insert(inner.begin(), within.begin(), within.end());
        }
        for (const PixelBox& one : inner) {
            std::optional<ColourField> field = field_of_bar(pixels, one, strips, ground, side);
            if (!field && strips.empty() && own >= kLeastAlone * area && has_axes(pixels, box, ground))
                if (auto scale = scale_of_colours(pixels, shrunk_by(one, kFieldFrame)))
                    if (is_field(agreement_with(pixels, shrunk_by(one, kFieldFrame), *scale, ground, side)))
                        field = ColourField{one, std::move(*scale), std::nullopt};
            if (field) {
                fields.push_back(std::move(*field));
                break;
            }
        }
    }
    return fields;
}

}  // namespace tactics
