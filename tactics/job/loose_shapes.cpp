// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/loose_shapes.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace tactics {

namespace {

// Settings: by how much sizes of letters of one font may differ.
constexpr double kSameEm = 0.01;
constexpr std::size_t kFewestOfFont = 3, kFewestCodes = 2;  // that tell a font: shapes, and letters
constexpr double kOtherShape = 0.03;                        // of the width of one that is as large
constexpr std::size_t kPlainCorners = 4;                    // a stem is a bar as well

bool is_figure(char32_t code) { return code >= '0' && code <= '9'; }
bool is_of_words(char32_t code) { return is_figure(code) || is_alphabetic(code); }

// Moved down by that many units.
OutlineMeasure moved(OutlineMeasure shape, double down) {
    for (const std::size_t height : {1, 2, 4}) shape.lengths[height] += down;
    return shape;
}

// By which the shape must go down to stand as the letter does.
double down_to(const OutlineMeasure& shape, const FontLetter& letter, double em) {
    return letter.outline.lengths[1] * em - shape.lengths[1];
}

double apart_anywhere(const OutlineMeasure& shape, const FontLetter& letter, double em) {
    return apart_at(moved(shape, down_to(shape, letter, em)), letter.outline, em);
}

double em_of(const OutlineMeasure& shape, const FontLetter& letter) { return std::sqrt(shape.area / letter.outline.area); }

}  // namespace

LooseShapes::LooseShapes(const FoundPage& figure, const std::vector<OutlineMeasure>& outlines, LettersOfShapes& read)
    : figure_(figure), outlines_(outlines), read_(read) {
    for (std::size_t i = 0; i < outlines.size(); ++i)
        if (figure.letter_shapes[i].inked) own_.push_back(i);
}

bool LooseShapes::is_open(std::size_t shape) const { return read_[shape].empty() && outlines_[shape].area > 0; }

// It is not read, and no stem.
bool LooseShapes::tells(std::size_t shape) const { return is_open(shape) && outlines_[shape].corners > kPlainCorners; }

bool LooseShapes::may_tell_font() const {
    std::size_t count = 0;
    const OutlineMeasure* first = nullptr;
    bool differ = false;
    for (const std::size_t shape : own_) {
        if (!tells(shape)) continue;
        const OutlineMeasure& one = outlines_[shape];
        if (first == nullptr) first = &one;
        const double scale = std::sqrt(one.area / first->area);
        differ = differ || one.rings != first->rings ||
                 std::abs(one.lengths[0] / scale - first->lengths[0]) > kOtherShape * first->lengths[0];
        ++count;
    }
    return differ && count >= kFewestOfFont;
}

std::optional<double> LooseShapes::em_in(const std::vector<FontLetter>& font) const {
    struct Possible {
        double em;
        std::size_t shape;
        char32_t code;
    };
    std::vector<Possible> all;
    for (const std::size_t shape : own_)
        if (tells(shape))
            for (const FontLetter& letter : font)
                if (is_of_words(letter.code))
                    if (const double em = em_of(outlines_[shape], letter);
                        apart_anywhere(outlines_[shape], letter, em) < kSameOutline)
                        all.push_back({em, shape, letter.code});
    std::sort(all.begin(), all.end(), [](const Possible& a, const Possible& b) { return a.em < b.em; });
    std::size_t most = 0;
    std::optional<double> best;
    for (std::size_t from = 0; from < all.size(); ++from) {
        std::set<std::size_t> shapes;
        std::set<char32_t> codes;
        double sum = 0;
        std::size_t count = 0;
        for (std::size_t i = from; i < all.size() && all[i].em < all[from].em * (1 + kSameEm); ++i, ++count) {
            shapes.insert(all[i].shape);
            codes.insert(all[i].code);
            sum += all[i].em;
        }
        if (shapes.size() < std::max(kFewestOfFont, most + 1) || codes.size() < kFewestCodes) continue;
        most = shapes.size();
        best = sum / static_cast<double>(count);
    }
    return best;
}

void LooseShapes::read_beside(const FoundWords& words, const std::vector<FontLetter>& font, double em) {
    std::vector<double> downs;
    for (const DrawnLetter& one : words.letters)
        if (!read_[one.shape].empty() && outlines_[one.shape].area > 0) {
            const FontLetter& letter = read_[one.shape].front();
            if (std::abs(em_of(outlines_[one.shape], letter) / em - 1) < kSameEm)
                downs.push_back(down_to(outlines_[one.shape], letter, em));
        }
    if (downs.empty()) return;
    const auto middle = downs.begin() + static_cast<std::ptrdiff_t>(downs.size() / 2);
    std::nth_element(downs.begin(), middle, downs.end());
    for (const DrawnLetter& one : words.letters)
        if (is_open(one.shape))
            read_[one.shape] = letters_like(font, [&](const FontLetter& letter) {
                return apart_at(moved(outlines_[one.shape], *middle), letter.outline, em);
            });
}

void LooseShapes::read_as(const std::vector<FontLetter>& font, double em) {
    for (const std::size_t shape : own_)
        if (tells(shape))
            read_[shape] = letters_like(font, [&](const FontLetter& letter) {
                return is_of_words(letter.code) ? apart_anywhere(outlines_[shape], letter, em) : 1;
            });
    for (const FoundWords& words : figure_.words)
        if (!words.letters.empty() && figure_.letter_shapes[words.letters.front().shape].inked) read_beside(words, font, em);
    for (const std::size_t shape : own_) {
        if (!is_open(shape)) continue;
        std::vector<FontLetter> alike;
        for (const FontLetter& letter : font)
            if (is_figure(letter.code) &&
                apart_anywhere(outlines_[shape], letter, em_of(outlines_[shape], letter)) < kSameOutline)
                alike.push_back(letter);
        if (alike.size() == 1) read_[shape] = std::move(alike);
    }
}

}  // namespace tactics
