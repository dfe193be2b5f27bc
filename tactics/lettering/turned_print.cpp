// SPDX-License-Identifier: Apache-2.0
#include "tactics/lettering/turned_print.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "tactics/lettering/dotted_rows.h"
#include "tactics/lettering/pale_lines.h"
#include "tactics/lettering/read_line.h"
#include "tactics/lettering/sloped_words.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

constexpr int kPatchMargin = 3;      // pixels around a patch, in which letters fade
constexpr double kPatchesApart = 3;  // heights between pieces of print, so that none is taken for the next word of another

// What most pixels around its ink have.
std::uint8_t ground_of(const Image& grey, const SlopedWords& words) {
    std::vector<std::uint8_t> values;
    const PixelBox& box = words.box;
    for (int y = std::max(0, box.top - 1); y < std::min(grey.height, box.bottom + 1); ++y)
        for (int x = std::max(0, box.left - 1); x < std::min(grey.width, box.right + 1); ++x)
            if ((grey.row(y)[x] < words.level) == words.light) values.push_back(grey.row(y)[x]);
    if (values.empty()) return words.light ? 0 : 255;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

// Its own ink and what fades from it; 0 elsewhere.
Image own_ink(const Image& grey, const SlopedWords& words, const PixelBox& box) {
    constexpr int kFades = 2;
    Image own = make_image(box.width(), box.height(), 1, 0, 0);
    for (const InkPiece& piece : words.pieces)
        for (const InkRun& run : piece.runs)
            for (int y = std::max(box.top, run.y - kFades); y < std::min(box.bottom, run.y + kFades + 1); ++y)
                for (int x = std::max(box.left, run.left - kFades); x < std::min(box.right, run.right + kFades); ++x) {
                    const bool is_own = y == run.y && x >= run.left && x < run.right;
                    if (is_own || (grey.row(y)[x] < words.level) == words.light) own.row(y - box.top)[x - box.left] = 1;
                }
    return own;
}

PixelBox wider(const PixelBox& box, int by, const Image& in) {
    return {std::max(0, box.left - by), std::max(0, box.top - by), std::min(in.width, box.right + by),
            std::min(in.height, box.bottom + by)};
}

// Catmull-Rom weights of four samples around a place between the second and the third.
void weigh(double t, double (&weights)[4]) {
    weights[0] = t * (-0.5 + t * (1 - 0.5 * t));
    weights[1] = 1 + t * t * (-2.5 + 1.5 * t);
    weights[2] = t * (0.5 + t * (2 - 1.5 * t));
    weights[3] = t * t * (-0.5 + 0.5 * t);
}

std::uint8_t sampled(const Image& image, double x, double y) {
    const double left = std::floor(x - 0.5), top = std::floor(y - 0.5);
    double across[4], down[4], sum = 0;
    weigh(x - 0.5 - left, across);
    weigh(y - 0.5 - top, down);
    for (int v = 0; v < 4; ++v) {
        const std::uint8_t* row = image.row(std::clamp(static_cast<int>(top) + v - 1, 0, image.height - 1));
        for (int u = 0; u < 4; ++u)
            sum += down[v] * across[u] * row[std::clamp(static_cast<int>(left) + u - 1, 0, image.width - 1)];
    }
    return static_cast<std::uint8_t>(std::lround(std::clamp(sum, 0.0, 255.0)));
}

// How many marks may stand above the letters of a text: dots, and accents, which may come in two pieces.
std::size_t marks_above(std::string_view text) {
    constexpr char32_t kFirstOther = 0xC0;
    std::size_t count = 0;
    while (!text.empty()) {
        const char32_t letter = take_letter(text);
        const bool sign = letter == '"' || letter == '\'' || letter == '*' || letter == '^' || letter == '%' || letter == 0xB0;
        count += letter == 'i' || letter == 'j' ? 1 : letter >= kFirstOther || sign ? 2 : 0;
    }
    return count;
}

// Small ink by itself in the upper part of a word, however pale, such as what few pixels leave of an accent.
std::size_t small_ink_above(const Image& grey, const SlopedWords& words, std::uint8_t ground) {
    constexpr int kPale = 40, kDark = 110;         // grey levels off the ground
    constexpr double kSmall = 0.5, kUpper = 0.35;  // of the height
    const PixelBox box = wider(words.box, static_cast<int>(words.height / 2), grey);
    const auto off = [&](int x, int y) { return words.light ? grey.row(y)[x] - ground : ground - grey.row(y)[x]; };
    const auto is_near_dark = [&](int x, int y) {
        for (int v = std::max(box.top, y - 1); v <= std::min(box.bottom - 1, y + 1); ++v)
            for (int u = std::max(box.left, x - 1); u <= std::min(box.right - 1, x + 1); ++u)
                if (off(u, v) >= kDark) return true;
        return false;
    };
    // Dark ink, and what is pale without fading from it.
    Image dark = make_image(box.width(), box.height(), 1, 0, 255), pale = dark;
    for (int y = box.top; y < box.bottom; ++y)
        for (int x = box.left; x < box.right; ++x) {
            if (off(x, y) >= kDark)
                dark.row(y - box.top)[x - box.left] = 0;
            else if (off(x, y) >= kPale && !is_near_dark(x, y))
                pale.row(y - box.top)[x - box.left] = 0;
        }
    const SlopedAxes axes(words.slope);
    Leaning word;
    for (const InkPiece& piece : words.pieces) word.add(leaning(piece, axes));
    const double across = axes.across(box.left, box.top), along = axes.along(box.left, box.top);
    std::vector<Leaning> small;
    double top = 1e9;
    for (const Image* part : {&dark, &pale})
        for (const InkPiece& piece : pieces_of(*part, 128, false, std::max(part->width, part->height))) {
            Leaning one = leaning(piece, axes);
            one.left += along, one.right += along, one.top += across, one.bottom += across;
            const bool is_own = one.right > word.left && one.left < word.right && one.bottom > word.top - kUpper * words.height &&
                                one.top < word.bottom;
            if (!is_own) continue;
            if (std::max(one.width(), one.height()) > kSmall * words.height)
                top = std::min(top, one.top);
            else
                small.push_back(one);
        }
    return static_cast<std::size_t>(std::count_if(small.begin(), small.end(), [&](const Leaning& one) {
        return (one.top + one.bottom) / 2 < top + kUpper * words.height;
    }));
}

}  // namespace

TurnedPrint::TurnedPrint(Image grey) : grey_(std::move(grey)), sloped_(find_sloped_print(grey_)) {
    if (sloped_.empty()) return;
    double height = 0;
    for (const SlopedWords& words : sloped_) height = std::max(height, words.height);
    const int far = static_cast<int>(kPatchesApart * height);
    int x = 0, top = grey_.height + far, next = top, width = grey_.width;
    for (const SlopedWords& words : sloped_) {
        const SlopedAxes axes(words.slope);
        double left = 1e9, right = -1e9, upper = 1e9, lower = -1e9;
        for (const InkPiece& piece : words.pieces)
            for (const InkRun& run : piece.runs)
                for (const int column : {run.left, run.right})
                    for (const int row : {run.y, run.y + 1}) {
                        left = std::min(left, axes.along(column, row)), right = std::max(right, axes.along(column, row));
                        upper = std::min(upper, axes.across(column, row)), lower = std::max(lower, axes.across(column, row));
                    }
        const int wide = static_cast<int>(std::ceil(right - left + 2 * kPatchMargin)),
                  high = static_cast<int>(std::ceil(lower - upper + 2 * kPatchMargin));
        if (x > 0 && x + wide > std::max(grey_.width, 1000)) x = 0, top = next + far;
        patches_.push_back({{x + far, top, x + far + wide, top + high}, left - kPatchMargin, upper - kPatchMargin});
        x += wide + far;
        next = std::max(next, top + high);
        width = std::max(width, x + far);
    }
    const std::uint8_t ground = ground_of(grey_, sloped_.front());
    turned_ = make_image(width, next + far, 1, 0, ground);
    for (int y = 0; y < grey_.height; ++y) std::copy_n(grey_.row(y), grey_.width, turned_.row(y));
    for (std::size_t i = 0; i < sloped_.size(); ++i) {
        erase_from(turned_, sloped_[i]);
        set_upright(sloped_[i], patches_[i]);
    }
}

void TurnedPrint::erase_from(Image& picture, const SlopedWords& words) const {
    const PixelBox box = wider(words.box, kPatchMargin, grey_);
    const Image own = own_ink(grey_, words, box);
    const std::uint8_t ground = ground_of(grey_, words);
    for (int y = box.top; y < box.bottom; ++y)
        for (int x = box.left; x < box.right; ++x)
            if (own.row(y - box.top)[x - box.left] != 0) picture.row(y)[x] = ground;
}

void TurnedPrint::set_upright(const SlopedWords& words, const Patch& patch) {
    const PixelBox box = wider(words.box, kPatchMargin, grey_);
    const std::uint8_t ground = ground_of(grey_, words);
    Image alone = own_ink(grey_, words, box);
    for (int y = box.top; y < box.bottom; ++y)
        for (int x = box.left; x < box.right; ++x) {
            std::uint8_t& pixel = alone.row(y - box.top)[x - box.left];
            pixel = pixel != 0 ? grey_.row(y)[x] : ground;
        }
    const SlopedAxes axes(words.slope);
    for (int y = 0; y < patch.box.height(); ++y)
        for (int x = 0; x < patch.box.width(); ++x) {
            const double along = patch.along + x + 0.5, across = patch.across + y + 0.5;
            const double px = along * axes.cosine + across * axes.sine - box.left,
                         py = across * axes.cosine - along * axes.sine - box.top;
            if (px < -1 || py < -1 || px > alone.width + 1 || py > alone.height + 1) continue;
            turned_.row(patch.box.top + y)[patch.box.left + x] = sampled(alone, px, py);
        }
}

// Print under an axis ends at what it names, or has its middle there; ticks tell which.
Point TurnedPrint::end_of(const SlopedWords& words) const {
    constexpr double kReach = 1.5, kBroad = 0.4;  // of the height: a tick is narrower, an axis is not
    const PixelBox& box = words.box;
    const double height = words.height;
    // Upper ends are at one height under an axis, lower ones above it.
    int highest = box.top, lowest = box.bottom, top = box.top, bottom = box.bottom;
    for (const SlopedWords& other : sloped_) {
        top = std::max(top, other.box.top), highest = std::min(highest, other.box.top);
        bottom = std::min(bottom, other.box.bottom), lowest = std::max(lowest, other.box.bottom);
    }
    const bool above = top - highest <= lowest - bottom + height / 2;
    const bool right = (words.slope > 0) == above;
    const double side = height / 2;
    Point end{right ? box.right - side : box.left + side, above ? box.top + side : box.bottom - side};
    const int from = std::max(0, box.left - (right ? 0 : static_cast<int>(height))),
              to = std::min(grey_.width, box.right + (right ? static_cast<int>(height) : 0));
    for (int step = 1; step <= kReach * height; ++step) {
        const int y = above ? box.top - step : box.bottom - 1 + step;
        if (y < 0 || y >= grey_.height) break;
        std::vector<double> ticks;
        bool broad = false;
        for (int x = from; x < to; ++x) {
            if (grey_.row(y)[x] >= words.level) continue;
            const int left = x;
            while (x < to && grey_.row(y)[x] < words.level) ++x;
            broad = broad || x - left > std::max(3.0, kBroad * height);
            ticks.push_back((left + x) / 2.0);
        }
        if (broad) break;
        if (ticks.empty()) continue;
        const auto off = [&](double x) { return std::min(std::abs(x - end.x), std::abs(x - (box.left + box.right) / 2.0)); };
        end.x = *std::min_element(ticks.begin(), ticks.end(), [&](double a, double b) { return off(a) < off(b); });
        break;
    }
    return end;
}

PrintedWords TurnedPrint::told(std::size_t which, const std::vector<const PrintedWords*>& read) const {
    const SlopedWords& words = sloped_[which];
    const Patch& patch = patches_[which];
    const SlopedAxes axes(words.slope);
    LetteringLine line;
    line.light = words.light;
    line.level = words.level;
    line.box = words.box;
    line.letter_height = static_cast<int>(std::lround(words.height));
    line.letters = words.pieces;
    PrintedWords one = print_of(grey_, line);
    double held = 0, all = 0;
    for (const InkPiece& piece : words.pieces)
        for (const InkRun& run : piece.runs) {
            const double x = (run.left + run.right) / 2.0, y = run.y + 0.5, ink = run.right - run.left;
            const int u = patch.box.left + static_cast<int>(axes.along(x, y) - patch.along),
                      v = patch.box.top + static_cast<int>(axes.across(x, y) - patch.across);
            all += ink;
            if (std::any_of(read.begin(), read.end(), [&](const PrintedWords* part) {
                    const PixelBox& box = part->box;
                    return u >= box.left - 1 && u <= box.right && v >= box.top - 1 && v <= box.bottom;
                }))
                held += ink;
        }
    constexpr double kWhole = 0.97;  // of its ink: a lost letter has more
    one.sureness = read.empty() ? 0 : 100;
    one.sure = !read.empty() && held >= kWhole * all;
    for (const PrintedWords* part : read) {
        one.text += (one.text.empty() ? "" : " ") + part->text;
        one.sure = one.sure && part->sure && !part->upwards;
        one.sureness = std::min(one.sureness, part->sureness);
        one.letter_height = part->letter_height;
    }
    constexpr double kTiny = 12;  // pixels from the highest to the lowest ink of a line
    if (one.sure && words.height <= kTiny && small_ink_above(grey_, words, ground_of(grey_, words)) > marks_above(one.text))
        one.sure = false;
    one.print = true;
    one.out = !one.sure;
    if (!words.name) one.at = end_of(words);
    return one;
}

bool TurnedPrint::put_back(Lettering& lettering) const {
    std::vector<PrintedWords>& words = lettering.words;
    std::vector<PrintedWords> back;
    std::size_t sure = 0, likely = 0;
    for (std::size_t i = 0; i < sloped_.size(); ++i) {
        std::vector<const PrintedWords*> read;
        for (const PrintedWords& one : words)
            if (overlap(one.box, patches_[i].box)) read.push_back(&one);
        std::sort(read.begin(), read.end(),
                  [](const PrintedWords* a, const PrintedWords* b) { return a->box.left < b->box.left; });
        back.push_back(told(i, read));
        sure += back.back().sure ? 1 : 0;
        likely += !read.empty() && std::all_of(read.begin(), read.end(), [](const PrintedWords* one) { return one->print; });
    }
    if (sloped_.front().name) {
        // What nobody read may be no name, and stays where it is.
        bool any = false;
        for (PrintedWords& one : back) {
            any = any || !one.text.empty();
            if (one.text.empty()) one.print = one.out = false;
        }
        if (!any) return false;
    } else if (4 * sure < sloped_.size() && 2 * likely < sloped_.size()) {
        return false;
    }
    std::erase_if(words, [&](const PrintedWords& one) { return one.box.bottom > grey_.height; });
    words.insert(words.end(), back.begin(), back.end());
    return true;
}

void sort_by_place(std::vector<PrintedWords>& words) {
    std::stable_sort(words.begin(), words.end(), [](const PrintedWords& a, const PrintedWords& b) {
        return a.box.top != b.box.top ? a.box.top < b.box.top : a.box.left < b.box.left;
    });
}

Lettering read_lettering(const Image& picture, std::string_view language, double least_sure, const PrintFonts& fonts,
                         const std::string& program) {
    const TurnedPrint turned(without_dotted_rows(without_pale_lines(to_grey(picture))));
    Lettering lettering = read_upright(turned.picture(), language, least_sure, fonts, program);
    if (turned.any() && lettering.trouble.empty() && !turned.put_back(lettering))
        lettering = read_upright(turned.given(), language, least_sure, fonts, program);
    lettering.width = picture.width;
    lettering.height = picture.height;
    sort_by_place(lettering.words);
    return lettering;
}

}  // namespace tactics
