// SPDX-License-Identifier: Apache-2.0
#include "tactics/lettering/pale_ink.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tactics {

namespace {

// Settings. Letters that high have no strokes of less than a pixel; darkness of pale ink, of that of letters; how much ink it is
// at least, of the square of that height: a point of DejaVu Sans is 0.029.
constexpr int kThinStrokes = 20;
constexpr double kPale = 0.22, kFading = 0.08, kLeastInk = 0.01;
constexpr double kReach = 0.5, kBelow = 0.35;  // beyond the ends of the line, and below it; of the height

class PaleInk {
public:
    PaleInk(const Image& grey, const LetteringLine& line) : grey_(grey), line_(line) {
        const int along = static_cast<int>(std::lround(kReach * line.letter_height)) + 2, across = line.letter_height / 2 + 2;
        const PixelBox& box = line.box;
        const int wide = line.upwards ? across : along, high = line.upwards ? along : across;
        window_ = {std::max(0, box.left - wide), std::max(0, box.top - high), std::min(grey.width, box.right + wide),
                   std::min(grey.height, box.bottom + high)};
        measure_tones();
    }

    std::vector<InkPiece> pieces() const {
        std::vector<InkPiece> found;
        if (ground_ == deepest_) return found;
        // Cut out as an image of its own: 0 is pale ink.
        Image pale = make_image(window_.width(), window_.height(), 1, 0, 255);
        for (int y = window_.top; y < window_.bottom; ++y)
            for (int x = window_.left; x < window_.right; ++x)
                if (darkness(x, y) >= kPale && !is_beside_dark(x, y)) pale.row(y - window_.top)[x - window_.left] = 0;
        for (InkPiece& piece : pieces_of(pale, 128, false, kMostInkHeight)) {
            if (!ends_within(piece, pale)) continue;
            move_piece(piece, window_.left, window_.top);
            if (ink_on(piece.box) >= kLeastInk * line_.letter_height * line_.letter_height) found.push_back(std::move(piece));
        }
        return found;
    }

    // Those with dark ink of the line, and what is pale of them; nothing if one goes on beyond.
    std::vector<InkPiece> whole_pieces() const {
        if (ground_ == deepest_) return {};
        Image ink = make_image(window_.width(), window_.height(), 1, 0, 255);
        for (int y = window_.top; y < window_.bottom; ++y)
            for (int x = window_.left; x < window_.right; ++x)
                if (darkness(x, y) >= kPale) ink.row(y - window_.top)[x - window_.left] = 0;
        Image own = make_image(window_.width(), window_.height(), 1, 0, 0);
        for (const auto* pieces : {&line_.letters, &line_.marks})
            for (const InkPiece& piece : *pieces)
                for (const InkRun& run : piece.runs)
                    std::fill(own.row(run.y - window_.top) + (run.left - window_.left),
                              own.row(run.y - window_.top) + (run.right - window_.left), std::uint8_t{1});
        std::vector<InkPiece> found = pieces_of(ink, 128, false, kMostInkHeight);
        std::erase_if(found, [&](const InkPiece& piece) {
            return std::none_of(piece.runs.begin(), piece.runs.end(), [&](const InkRun& run) {
                return std::any_of(own.row(run.y) + run.left, own.row(run.y) + run.right,
                                   [](std::uint8_t is) { return is != 0; });
            });
        });
        if (!std::all_of(found.begin(), found.end(), [&](const InkPiece& piece) { return ends_within(piece, ink); })) return {};
        for (InkPiece& piece : found) move_piece(piece, window_.left, window_.top);
        return found;
    }

private:
    void measure_tones() {
        deepest_ = line_.light ? 0 : 255;
        for (const InkPiece& piece : line_.letters)
            for (const InkRun& run : piece.runs)
                for (int x = run.left; x < run.right; ++x) {
                    const int value = grey_.row(run.y)[x];
                    deepest_ = line_.light ? std::max(deepest_, value) : std::min(deepest_, value);
                }
        std::vector<int> ground;
        for (int y = window_.top; y < window_.bottom; ++y)
            for (int x = window_.left; x < window_.right; ++x)
                if (!is_dark(x, y)) ground.push_back(grey_.row(y)[x]);
        const auto middle = ground.begin() + static_cast<std::ptrdiff_t>(ground.size() / 2);
        std::nth_element(ground.begin(), middle, ground.end());
        ground_ = ground.empty() ? deepest_ : *middle;
    }

    // With what fades from it into the ground, and without that of dark letters.
    double ink_on(const PixelBox& box) const {
        double ink = 0;
        for (int y = box.top - 1; y <= box.bottom; ++y)
            for (int x = box.left - 1; x <= box.right; ++x)
                if (darkness(x, y) > kFading && !is_beside_dark(x, y)) ink += darkness(x, y);
        return ink;
    }

    bool is_dark(int x, int y) const { return (grey_.row(y)[x] < line_.level) != line_.light; }
    double darkness(int x, int y) const { return static_cast<double>(ground_ - grey_.row(y)[x]) / (ground_ - deepest_); }
    bool is_beside_dark(int x, int y) const {
        for (int v = std::max(0, y - 1); v <= std::min(grey_.height - 1, y + 1); ++v)
            for (int u = std::max(0, x - 1); u <= std::min(grey_.width - 1, x + 1); ++u)
                if (is_dark(u, v)) return true;
        return false;
    }

    const Image& grey_;
    const LetteringLine& line_;
    PixelBox window_;
    int ground_ = 255, deepest_ = 0;
};

}  // namespace

void add_pale_ink(const Image& grey, LetteringLine& line) {
    if (line.letter_height > kThinStrokes) return;
    // As its reader sees it, x along the line and y down.
    const auto seen = [&](const PixelBox& box) {
        return line.upwards ? PixelBox{-box.bottom, box.left, -box.top, box.right} : box;
    };
    const PixelBox own = seen(line.box);
    const double height = line.letter_height;
    for (InkPiece& piece : PaleInk(grey, line).pieces()) {
        const PixelBox box = seen(piece.box);
        if (box.top < own.top - 1 || box.bottom > own.bottom + kBelow * height) continue;
        const bool mark = box.height() < 0.6 * height;
        if (box.width() > (mark ? 0.6 : 0.4) * height) continue;
        line.box = around(line.box, piece.box);
        std::vector<InkPiece>& to = mark ? line.marks : line.letters;
        const auto after =
            std::find_if(to.begin(), to.end(), [&](const InkPiece& other) { return seen(other.box).left > box.left; });
        to.insert(mark ? to.end() : after, std::move(piece));
    }
}

LetteringLine joined_by_pale_ink(const Image& grey, const LetteringLine& line) {
    LetteringLine whole = line;
    if (!line.raised.empty()) return whole;
    std::vector<InkPiece> pieces = PaleInk(grey, line).whole_pieces();
    if (pieces.empty()) return whole;
    const auto start = [&](const InkPiece& piece) { return line.upwards ? -piece.box.bottom : piece.box.left; };
    std::stable_sort(pieces.begin(), pieces.end(), [&](const InkPiece& a, const InkPiece& b) { return start(a) < start(b); });
    for (const InkPiece& piece : pieces) whole.box = around(whole.box, piece.box);
    whole.letters = std::move(pieces);
    whole.marks.clear();
    return whole;
}

LetteringLine whole_if_broken(const Image& grey, LetteringLine line) {
    constexpr std::size_t kMarks = 3;  // a single letter in several pieces has as many
    constexpr int kWidest = 2;         // times the height: in a soft scan pale ink joins all letters of a word
    const std::size_t pieces = line.letters.size() + line.marks.size();
    if (line.marks.size() < kMarks || 2 * line.marks.size() < line.letters.size()) return line;
    LetteringLine whole = joined_by_pale_ink(grey, line);
    if (!whole.marks.empty() || 5 * whole.letters.size() > 3 * pieces) return line;
    whole.letter_height = 0;
    int widest = 0;
    for (const InkPiece& piece : whole.letters) {
        const int along = line.upwards ? piece.box.height() : piece.box.width();
        whole.letter_height = std::max(whole.letter_height, line.upwards ? piece.box.width() : piece.box.height());
        widest = std::max(widest, along);
    }
    return widest <= kWidest * whole.letter_height ? whole : line;
}

}  // namespace tactics
