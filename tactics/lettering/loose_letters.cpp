// SPDX-License-Identifier: Apache-2.0
// Letters by themselves that touch a long stroke, such as the name of a link or of a point of a curve.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "tactics/lettering/long_strokes.h"
#include "tactics/lettering/mark_shape.h"
#include "tactics/lettering/read_line.h"

namespace tactics {

namespace {

// Of the height of letters. Settings: what reaches so far straight on is no stroke of a letter; small letters are no lower, and
// one with a stem no higher; none is wider or narrower; letters of one label stand no farther apart.
constexpr double kLongStrokeOf = 2.2, kLowestLoose = 0.6, kHighestLoose = 1.25, kWidestLoose = 1.3, kNarrowestLoose = 0.3,
                 kBesideLoose = 0.5;
constexpr std::size_t kFewestSure = 2;  // lines of print, that tell how large it is
constexpr std::size_t kMostLoose = 6;   // more are a texture

// The line of print that is as high as most are; nothing if there is too little print.
const LetteringLine* typical_line(const std::vector<ReadLine>& lines) {
    std::vector<const LetteringLine*> sure;
    for (const ReadLine& one : lines)
        if (one.words.sure && !one.line.upwards) sure.push_back(&one.line);
    if (sure.size() < kFewestSure) return nullptr;
    const auto middle = sure.begin() + static_cast<std::ptrdiff_t>(sure.size() / 2);
    std::nth_element(sure.begin(), middle, sure.end(), [](const LetteringLine* a, const LetteringLine* b) {
        return std::pair(a->letter_height, a->box.top) < std::pair(b->letter_height, b->box.top);
    });
    return *middle;
}

// Of its box, what a piece encloses.
double hole_of(const InkPiece& piece) {
    Image grid = make_image(piece.box.width() + 2, piece.box.height() + 2, 1, 0, 255);
    for (const InkRun& run : piece.runs) {
        std::uint8_t* row = grid.row(run.y - piece.box.top + 1) - piece.box.left + 1;
        std::fill(row + run.left, row + run.right, std::uint8_t{0});
    }
    int hole = 0;
    for (const InkPiece& ground : pieces_of(grid, 128, true, std::max(grid.width, grid.height)))
        if (ground.box.left > 0)
            for (const InkRun& run : ground.runs) hole += run.right - run.left;
    return static_cast<double>(hole) / (piece.box.width() * piece.box.height());
}

class LooseLetters {
public:
    LooseLetters(const Image& grey, const std::vector<ReadLine>& lines, const LetteringLine& typical)
        : typical_(typical), drawn_(make_image(grey.width, grey.height, 1, 0, 0)) {
        for (std::size_t i = 0; i < grey.pixels.size(); ++i)
            drawn_.pixels[i] = (grey.pixels[i] < typical.level) != typical.light ? 1 : 0;
        for (const ReadLine& one : lines)
            if (one.words.sure || one.tell)
                for (const auto* pieces : {&one.line.letters, &one.line.marks, &one.line.raised})
                    for (const InkPiece& piece : *pieces)
                        for (const InkRun& run : piece.runs)
                            std::fill(drawn_.row(run.y) + run.left, drawn_.row(run.y) + run.right, 0);
        long_ = long_strokes(drawn_, {0, 0, grey.width, grey.height},
                             static_cast<int>(std::ceil(kLongStrokeOf * typical.letter_height)));
    }

    std::vector<LetteringLine> run() const {
        Image left = make_image(drawn_.width, drawn_.height, 1, 0, 255);
        for (std::size_t i = 0; i < left.pixels.size(); ++i)
            if (drawn_.pixels[i] != 0 && long_.beside.pixels[i] == 0) left.pixels[i] = 0;
        std::vector<InkPiece> pieces = pieces_of(left, 128, false, 2 * typical_.letter_height);
        std::erase_if(pieces, [&](const InkPiece& piece) { return !is_as_letter(piece) || !touches_stroke(piece); });
        std::vector<LetteringLine> found;
        while (!pieces.empty() && found.size() <= kMostLoose) found.push_back(take_row(pieces));
        if (found.size() > kMostLoose) found.clear();
        return found;
    }

private:
    bool is_as_letter(const InkPiece& piece) const {
        const double height = typical_.letter_height, own = piece.box.height(), wide = piece.box.width();
        return own >= kLowestLoose * height && own <= kHighestLoose * height && wide <= kWidestLoose * height &&
               wide >= kNarrowestLoose * height && is_letter_like(mark_shape(piece)) && !is_bent_band(piece) &&
               is_of_strokes(piece);
    }

    // Heads of arrows are thicker than letters; rings, boxes and diamonds at the end of a line are empty.
    bool is_of_strokes(const InkPiece& piece) const {
        constexpr double kThickest = 0.12, kLargestHole = 0.28;  // half of it, of the height; of the box
        constexpr int kThin = 2;                                 // pixels
        return hole_of(piece) <= kLargestHole &&
               layers_in(piece.box) <= std::max(kThin, static_cast<int>(std::ceil(kThickest * typical_.letter_height)));
    }

    // How often a pixel can be taken off all around until none of the ink there is left.
    int layers_in(const PixelBox& box) const {
        const PixelBox near{std::max(1, box.left - 1), std::max(1, box.top - 1), std::min(drawn_.width - 1, box.right + 1),
                            std::min(drawn_.height - 1, box.bottom + 1)};
        Image left = drawn_window(near);
        int layers = 0;
        for (bool any = true; any && layers < kMostInkHeight; ++layers) {
            any = false;
            const Image before = left;
            for (int y = 1; y + 1 < left.height; ++y)
                for (int x = 1; x + 1 < left.width; ++x) {
                    const bool stays = before.row(y)[x] != 0 && before.row(y - 1)[x] != 0 && before.row(y + 1)[x] != 0 &&
                                       before.row(y)[x - 1] != 0 && before.row(y)[x + 1] != 0;
                    left.row(y)[x] = stays ? 1 : 0;
                    any = any || stays;
                }
        }
        return layers;
    }

    // With a frame of nothing.
    Image drawn_window(const PixelBox& box) const {
        Image window = make_image(box.width() + 2, box.height() + 2, 1, 0, 0);
        for (int y = box.top; y < box.bottom; ++y)
            std::copy(drawn_.row(y) + box.left, drawn_.row(y) + box.right, window.row(y - box.top + 1) + 1);
        return window;
    }

    bool is_stroke(int x, int y) const {
        return x >= 0 && y >= 0 && x < drawn_.width && y < drawn_.height && long_.strokes.row(y)[x] != 0;
    }
    bool touches_stroke(const InkPiece& piece) const {
        return std::any_of(piece.runs.begin(), piece.runs.end(), [&](const InkRun& run) {
            for (int y = run.y - 2; y <= run.y + 2; ++y)
                for (int x = run.left - 2; x < run.right + 2; ++x)
                    if (is_stroke(x, y)) return true;
            return false;
        });
    }

    // The first of them, and those that stand in a row with it.
    LetteringLine take_row(std::vector<InkPiece>& pieces) const {
        LetteringLine line;
        line.light = typical_.light;
        line.level = typical_.level;
        line.box = pieces.front().box;
        const auto take = [&](std::vector<InkPiece>::iterator piece) {
            line.box = around(line.box, piece->box);
            line.letter_height = std::max(line.letter_height, piece->box.height());
            line.letters.push_back(std::move(*piece));
            pieces.erase(piece);
        };
        for (auto next = pieces.begin(); next != pieces.end();) {
            take(next);
            next = std::find_if(pieces.begin(), pieces.end(), [&](const InkPiece& piece) {
                const double height = typical_.letter_height;
                return std::min(line.box.bottom, piece.box.bottom) - std::max(line.box.top, piece.box.top) >=
                           kLowestLoose * height / 2 &&
                       gap_along(line.box, piece.box) <= kBesideLoose * height;
            });
        }
        return line;
    }

    const LetteringLine& typical_;
    Image drawn_;  // 1: ink of no letter
    LongStrokes long_;
};

}  // namespace

std::vector<LetteringLine> loose_letters(const Image& grey, const std::vector<ReadLine>& lines) {
    const LetteringLine* const typical = typical_line(lines);
    return typical == nullptr ? std::vector<LetteringLine>() : LooseLetters(grey, lines, *typical).run();
}

}  // namespace tactics
