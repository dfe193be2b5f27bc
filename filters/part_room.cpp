// SPDX-License-Identifier: Apache-2.0
#include "filters/part_room.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "filters/opencv.h"

namespace tactics {

namespace {

constexpr std::uint32_t kNoPart = 0xffffffff;

// Corners of a right angle are not thin, though no disc fills them.
constexpr double kCorner = 1.45;
// So many times longer than the gap, and it is a line and not a bump.
constexpr double kSlender = 2.5;

class Room {
public:
    Room(std::vector<std::uint32_t>& part, std::span<const float> worth, int width, int height, double gap)
        : part_(part), worth_(worth), width_(width), height_(height), gap_(gap) {}

    // Gives whether anything was thin.
    bool take_from_thin(InkMap& slender) {
        const std::vector<bool> thin = thin_pixels();
        std::vector<std::uint32_t> piece(part_.size(), kNoPart);
        std::vector<std::vector<std::uint32_t>> pieces;
        for (std::uint32_t i = 0; i < part_.size(); ++i)
            if (thin[i] && piece[i] == kNoPart)
                pieces.push_back(flood(i, thin, piece, static_cast<std::uint32_t>(pieces.size())));
        // The smallest first, and each as what is beside it now is.
        std::stable_sort(pieces.begin(), pieces.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); });
        bool any = false;
        for (const auto& pixels : pieces) any = give_away(pixels, slender) || any;
        return any;
    }

private:
    template <typename Visit>
    void neighbours(std::uint32_t i, Visit visit) const {
        const int x = static_cast<int>(i) % width_;
        const auto row = static_cast<std::uint32_t>(width_);
        if (x > 0) visit(i - 1, worth_[i]);
        if (x + 1 < width_) visit(i + 1, worth_[i + 1]);
        if (i >= row) visit(i - row, worth_[i]);
        if (i + row < part_.size()) visit(i + row, worth_[i + row]);
    }

    std::vector<bool> thin_pixels() const {
        cv::Mat inside(height_, width_, CV_8U, cv::Scalar(1));
        for (std::uint32_t i = 0; i < part_.size(); ++i)
            neighbours(i, [&](std::uint32_t j, float) {
                if (part_[j] != part_[i]) inside.ptr<std::uint8_t>()[i] = 0;
            });
        cv::Mat away, out, label;
        cv::distanceTransform(inside, away, cv::DIST_L2, cv::DIST_MASK_PRECISE);
        const double half = gap_ / 2;
        const cv::Mat wide = away + 0.5 < half;  // 0 in the middle of what is wide enough
        std::vector<bool> thin(part_.size(), false);
        if (cv::countNonZero(wide) == static_cast<int>(part_.size())) {
            thin.assign(part_.size(), true);
            return thin;
        }
        cv::distanceTransform(wide, out, label, cv::DIST_L2, cv::DIST_MASK_5, cv::DIST_LABEL_PIXEL);
        std::vector<std::uint32_t> part_of_label(part_.size() + 1, kNoPart);
        for (std::uint32_t i = 0; i < part_.size(); ++i)
            if (wide.ptr<std::uint8_t>()[i] == 0) part_of_label[static_cast<std::size_t>(label.ptr<int>()[i])] = part_[i];
        for (std::uint32_t i = 0; i < part_.size(); ++i)
            thin[i] = static_cast<double>(out.ptr<float>()[i]) > half * kCorner + 0.5 ||
                      part_of_label[static_cast<std::size_t>(label.ptr<int>()[i])] != part_[i];
        return thin;
    }

    std::vector<std::uint32_t> flood(std::uint32_t start, const std::vector<bool>& among, std::vector<std::uint32_t>& piece,
                                     std::uint32_t number) const {
        std::vector<std::uint32_t> pixels{start};
        piece[start] = number;
        for (std::size_t n = 0; n < pixels.size(); ++n)
            neighbours(pixels[n], [&](std::uint32_t j, float) {
                if (!among[j] || piece[j] != kNoPart || part_[j] != part_[start]) return;
                piece[j] = number;
                pixels.push_back(j);
            });
        return pixels;
    }

    bool give_away(const std::vector<std::uint32_t>& pixels, InkMap& slender) {
        struct Beside {
            double length = 0, worth = 0;
        };
        std::map<std::uint32_t, Beside> beside;
        PixelBox box{width_, height_, 0, 0};
        for (const std::uint32_t i : pixels) {
            const int x = static_cast<int>(i) % width_, y = static_cast<int>(i) / width_;
            box = around(box, {x, y, x + 1, y + 1});
            neighbours(i, [&](std::uint32_t j, float worth) {
                if (part_[j] == part_[i]) return;
                Beside& b = beside[part_[j]];
                b.length += 1;
                b.worth += static_cast<double>(worth);
            });
        }
        if (beside.empty()) return false;
        double longest = 0;
        for (const auto& [part, b] : beside) longest = std::max(longest, b.length);
        std::uint32_t to = kNoPart;
        double least = std::numeric_limits<double>::infinity();
        for (const auto& [part, b] : beside) {
            // A neighbour at an end of a strip only is none beside it.
            if (b.length < 0.4 * longest) continue;
            if (const double mean = b.worth / b.length; mean < least) {
                least = mean;
                to = part;
            }
        }
        const double extent = std::hypot(box.width(), box.height());
        if (beside.size() == 1 && extent > kSlender * gap_ && static_cast<double>(pixels.size()) < extent * extent / 2)
            for (const std::uint32_t i : pixels) slender.row(static_cast<int>(i) / width_)[static_cast<int>(i) % width_] = 1;
        for (const std::uint32_t i : pixels) part_[i] = to;
        return true;
    }

    std::vector<std::uint32_t>& part_;
    std::span<const float> worth_;
    int width_, height_;
    double gap_;
};

}  // namespace

RoomyParts with_room(std::vector<std::uint32_t> part, std::span<const float> worth, int width, int height, double gap) {
    RoomyParts roomy{std::move(part), InkMap(width, height)};
    constexpr int kRounds = 3;  // what was given away may leave its old neighbour thin
    for (int i = 0; i < kRounds; ++i)
        if (!Room(roomy.part, worth, width, height, gap).take_from_thin(roomy.slender)) break;
    return roomy;
}

}  // namespace tactics
