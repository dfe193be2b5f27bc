// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/loose_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "tactics/text/utf8.h"

namespace tactics {

namespace {

// Settings: by how much sizes of letters of one font may differ, and of outlines that are one in another size, of their width.
constexpr double kSameEm = 0.01, kOneOutline = 0.03;
constexpr std::size_t kFewestLetters = 3;  // that tell a font
constexpr std::size_t kPlainCorners = 4;   // a stem is a bar as well
constexpr std::size_t kMostOutlines = 60;  // by which a font is known

bool is_of_words(char32_t code) { return is_digit(code) || is_alphabetic(code); }

// Whether one may be the other in another size: marks of a plot are many shapes, but few outlines.
bool is_one_outline(const OutlineMeasure& a, const OutlineMeasure& b) {
    const double scale = std::sqrt(a.area / b.area);
    const auto same = [&](std::size_t i) { return std::abs(a.lengths[i] / scale - b.lengths[i]) <= kOneOutline * b.lengths[0]; };
    constexpr std::array<std::size_t, 4> kAcross{0, 3, 5, 6};  // those that are the same wherever its line is
    return a.rings == b.rings && std::all_of(kAcross.begin(), kAcross.end(), same);
}

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

}  // namespace

LooseShapes::LooseShapes(const FoundPage& figure, const std::vector<OutlineMeasure>& outlines, LettersOfShapes& read)
    : figure_(figure), outlines_(outlines), read_(read) {
    for (std::size_t i = 0; i < outlines.size(); ++i)
        if (figure.letter_shapes[i].inked) own_.push_back(i);
}

bool LooseShapes::is_open(std::size_t shape) const { return read_[shape].empty() && outlines_[shape].area > 0; }

// It is not read, and no stem.
bool LooseShapes::tells(std::size_t shape) const { return is_open(shape) && outlines_[shape].corners > kPlainCorners; }

std::vector<std::size_t> LooseShapes::outlines_that_tell() const {
    std::vector<std::size_t> found;
    for (const std::size_t shape : own_) {
        if (found.size() == kMostOutlines) break;
        const auto known = [&](std::size_t one) { return is_one_outline(outlines_[shape], outlines_[one]); };
        if (tells(shape) && std::none_of(found.begin(), found.end(), known)) found.push_back(shape);
    }
    return found;
}

bool LooseShapes::any() const {
    return std::any_of(own_.begin(), own_.end(), [&](std::size_t shape) { return tells(shape); });
}

bool LooseShapes::may_tell_font() const { return outlines_that_tell().size() >= kFewestLetters; }

std::optional<double> LooseShapes::em_in(const std::vector<FontLetter>& font) const {
    struct Possible {
        double em;
        char32_t code;
    };
    std::vector<Possible> all;
    for (const std::size_t shape : outlines_that_tell())
        for (const FontLetter& letter : font)
            if (is_of_words(letter.code))
                if (const double em = em_of(outlines_[shape], letter);
                    apart_anywhere(outlines_[shape], letter, em) < kSameOutline)
                    all.push_back({em, letter.code});
    std::sort(all.begin(), all.end(), [](const Possible& a, const Possible& b) { return a.em < b.em; });
    std::size_t most = kFewestLetters - 1;
    std::optional<double> best;
    for (std::size_t from = 0; from < all.size(); ++from) {
        std::set<char32_t> codes;
        double sum = 0;
        std::size_t count = 0;
        for (std::size_t i = from; i < all.size() && all[i].em < all[from].em * (1 + kSameEm); ++i, ++count) {
            codes.insert(all[i].code);
            sum += all[i].em;
        }
        if (codes.size() <= most) continue;
        most = codes.size();
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
    for (const DrawnLetter& one : words.letters) {
        if (!is_open(one.shape)) continue;
        const OutlineMeasure shape = moved(outlines_[one.shape], *middle);
        std::vector<FontLetter>& read = read_[one.shape];
        read = letters_like(font, [&](const FontLetter& letter) { return apart_at(shape, letter.outline, em); });
        if (read.empty())
            if (const FontLetter* letter = nearly_same(font, shape, em)) read.push_back(*letter);
    }
}

void LooseShapes::read_as(const std::vector<FontLetter>& font, double em) {
    for (const std::size_t shape : own_)
        if (tells(shape))
            read_[shape] = letters_like(font, [&](const FontLetter& letter) {
                return is_of_words(letter.code) ? apart_anywhere(outlines_[shape], letter, em) : 1;
            });
    for (const FoundWords& words : figure_.words)
        if (!words.letters.empty() && figure_.letter_shapes[words.letters.front().shape].inked) read_beside(words, font, em);
    for (const std::size_t shape : own_) read_figure(shape, font);
}

void LooseShapes::read_figure(std::size_t shape, const std::vector<FontLetter>& font) {
    if (!is_open(shape)) return;
    std::vector<FontLetter> alike;
    for (const FontLetter& letter : font)
        if (is_digit(letter.code) && apart_anywhere(outlines_[shape], letter, em_of(outlines_[shape], letter)) < kSameOutline)
            alike.push_back(letter);
    if (alike.size() == 1) read_[shape] = std::move(alike);
}

bool LooseShapes::is_beside_letters(const FoundWords& words) const {
    const auto is_open_one = [&](const DrawnLetter& one) { return is_open(one.shape); };
    const auto is_read = [&](const DrawnLetter& one) { return !read_[one.shape].empty(); };
    return !words.letters.empty() && figure_.letter_shapes[words.letters.front().shape].inked &&
           std::any_of(words.letters.begin(), words.letters.end(), is_open_one) &&
           std::any_of(words.letters.begin(), words.letters.end(), is_read);
}

bool LooseShapes::has_indices() const {
    return std::any_of(figure_.words.begin(), figure_.words.end(), [&](const FoundWords& one) { return is_beside_letters(one); });
}

void LooseShapes::read_indices(const std::vector<FontLetter>& font) {
    for (const FoundWords& words : figure_.words)
        if (is_beside_letters(words))
            for (const DrawnLetter& one : words.letters) read_figure(one.shape, font);
}

}  // namespace tactics
