// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/outlined_words.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "tactics/geometry/box.h"

namespace tactics {

namespace {

// Limits: of a figure 200 mm wide or high, letters are no larger; shapes, and shapes of one path.
constexpr double kLargestLetter = 14, kLeastLetter = 0.4;  // mm
constexpr std::size_t kMostRings = 20'000, kMostOfPath = 1'000, kMostRows = 500;
constexpr double kDarkLetter = 0.5, kSameShade = 0.1;  // lightness
// Settings, in heights of the letters: from one to the next of a row, and signs above and below them.
constexpr double kNextInRow = 1.4, kMarkAbove = 0.5, kMarkBelow = 0.35;
constexpr double kOnOneLine = 0.5;         // of the lower one's height
constexpr double kLikeHeight = 2.2;        // times as high
constexpr double kSmallSign = 0.8;         // of a row's height: dots, signs and accents, which tell nothing of where a row is
constexpr double kOverEachOther = 0.5;     // of the narrower one's width: parts of one letter
constexpr std::size_t kFewestLetters = 5;  // letters in a figure with words: fewer are icons

// A ring where it was.
struct Taken {
    bool stroke;           // a closed one, else a ring of an area
    std::size_t of, ring;  // its number in the page, and in the area
    std::vector<Point> points;
};

struct Glyph {
    Box box;
    std::vector<std::size_t> rings;
};

double height_of(const Glyph& glyph) { return glyph.box.height(); }

Box together(const Box& a, const Box& b) {
    return {std::min(a.left, b.left), std::min(a.top, b.top), std::max(a.right, b.right), std::max(a.bottom, b.bottom)};
}

bool within(const Box& inner, const Box& outer) {
    return inner.left > outer.left && inner.right < outer.right && inner.top > outer.top && inner.bottom < outer.bottom;
}

double middle_value(std::vector<double> values) {
    const auto half = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), half, values.end());
    return *half;
}

// Which of them belong together.
class Groups {
public:
    explicit Groups(std::size_t count) : of_(count) { std::iota(of_.begin(), of_.end(), std::size_t{0}); }
    std::size_t of(std::size_t i) {
        while (of_[i] != i) i = of_[i] = of_[of_[i]];
        return i;
    }
    void unite(std::size_t a, std::size_t b) { of_[of(a)] = of(b); }

private:
    std::vector<std::size_t> of_;
};

// Rows of letters, each from the left to the right.
std::vector<std::vector<Glyph>> rows_of(std::vector<Glyph> glyphs) {
    std::sort(glyphs.begin(), glyphs.end(), [](const Glyph& a, const Glyph& b) {
        return a.box.left != b.box.left ? a.box.left < b.box.left : a.box.top < b.box.top;
    });
    double tallest = 0;
    for (const Glyph& glyph : glyphs) tallest = std::max(tallest, height_of(glyph));
    Groups groups(glyphs.size());
    std::size_t budget = 4'000'000;  // comparisons
    for (std::size_t i = 0; i < glyphs.size(); ++i)
        for (std::size_t j = i + 1; j < glyphs.size() && budget > 0; ++j, --budget) {
            const Box &a = glyphs[i].box, &b = glyphs[j].box;
            if (b.left - a.right > kNextInRow * tallest) {
                if (b.left - a.left > kLargestLetter + kNextInRow * tallest) break;
                continue;
            }
            const double high = std::max(a.height(), b.height()), low = std::min(a.height(), b.height());
            if (high > kLikeHeight * low || b.left - a.right > kNextInRow * high) continue;
            if (std::min(a.bottom, b.bottom) - std::max(a.top, b.top) > kOnOneLine * low) groups.unite(i, j);
        }
    std::vector<std::vector<std::size_t>> members(glyphs.size());
    for (std::size_t i = 0; i < glyphs.size(); ++i) members[groups.of(i)].push_back(i);
    std::vector<std::vector<Glyph>> rows;
    std::vector<bool> used(glyphs.size(), false);
    for (const auto& row : members) {
        if (row.size() < 2) continue;
        std::vector<Glyph>& letters = rows.emplace_back();
        for (const std::size_t i : row) {
            letters.push_back(glyphs[i]);
            used[i] = true;
        }
    }
    // Dots, accents and signs.
    for (std::vector<Glyph>& row : rows) {
        std::vector<double> heights;
        Box all = kNothing;
        for (const Glyph& glyph : row) {
            heights.push_back(height_of(glyph));
            all = together(all, glyph.box);
        }
        const double high = middle_value(heights);
        const Box around{all.left - high / 2, all.top - kMarkAbove * high, all.right + high / 2, all.bottom + kMarkBelow * high};
        const auto from = std::lower_bound(glyphs.begin(), glyphs.end(), around.left,
                                           [](const Glyph& glyph, double left) { return glyph.box.left < left; });
        for (auto at = from; at != glyphs.end() && at->box.left < around.right; ++at) {
            const auto number = static_cast<std::size_t>(at - glyphs.begin());
            if (used[number] || !around.holds(at->box.middle()) || height_of(*at) > kSmallSign * high) continue;
            used[number] = true;
            row.push_back(*at);
        }
        std::sort(row.begin(), row.end(), [](const Glyph& a, const Glyph& b) { return a.box.left < b.box.left; });
    }
    return rows;
}

// An i and its dot are one letter.
std::vector<Glyph> letters_of_row(const std::vector<Glyph>& row) {
    std::vector<Glyph> letters;
    for (const Glyph& glyph : row) {
        if (!letters.empty()) {
            Glyph& last = letters.back();
            const double common = std::min(last.box.right, glyph.box.right) - std::max(last.box.left, glyph.box.left);
            if (common > kOverEachOther * std::min(last.box.width(), glyph.box.width())) {
                last.box = together(last.box, glyph.box);
                last.rings.insert(last.rings.end(), glyph.rings.begin(), glyph.rings.end());
                continue;
            }
        }
        letters.push_back(glyph);
    }
    return letters;
}

// Points, ticks and boxes in a row are all alike.
bool has_different(const std::vector<Glyph>& row) {
    const Box& first = row.front().box;
    return std::any_of(row.begin() + 1, row.end(), [&](const Glyph& glyph) {
        constexpr double kAlike = 0.05;
        return std::abs(glyph.box.width() - first.width()) > kAlike * first.height() ||
               std::abs(height_of(glyph) - first.height()) > kAlike * first.height();
    });
}

bool is_letter_size(const std::vector<Point>& points) {
    const Box box = box_of(points);
    return points.size() > 2 && std::max(box.width(), box.height()) <= kLargestLetter && box.height() >= kLeastLetter / 4;
}

// Shapes of a figure that are dark all over and no larger than letters.
class DarkShapes {
public:
    explicit DarkShapes(const FoundPage& figure) {
        for (const FoundLook& look : figure.looks) {
            if (look.fill < 0 || look.fill > kDarkLetter) continue;
            if (look.line >= 0 && std::abs(look.line - look.fill) > kSameShade) continue;
            const std::size_t from = rings.size();
            for (std::size_t i = look.stroke; i < look.strokes_end; ++i)
                if (const PageStroke& stroke = figure.page.strokes[i]; stroke.closed && stroke.role == Role::line)
                    add({true, i, 0, stroke.points});
            for (std::size_t i = look.area; i < look.areas_end; ++i)
                for (std::size_t k = 0; k < figure.page.areas[i].rings.size(); ++k)
                    if (figure.page.areas[i].role == Role::line) add({false, i, k, figure.page.areas[i].rings[k]});
            if (rings.size() > kMostRings) {
                glyphs.clear();
                return;
            }
            gather(from);
        }
    }

    std::vector<Taken> rings;
    std::vector<Glyph> glyphs;

private:
    void add(Taken ring) {
        if (is_letter_size(ring.points)) rings.push_back(std::move(ring));
    }

    // Those of a path, from that one on: what lies within another is a hole in it.
    void gather(std::size_t from) {
        if (rings.size() - from > kMostOfPath) return;
        std::vector<std::pair<Box, std::size_t>> boxes;
        for (std::size_t i = from; i < rings.size(); ++i) boxes.push_back({box_of(rings[i].points), i});
        std::stable_sort(boxes.begin(), boxes.end(), [](const auto& a, const auto& b) {
            return a.first.width() * a.first.height() > b.first.width() * b.first.height();
        });
        const auto first = static_cast<std::ptrdiff_t>(glyphs.size());
        for (const auto& [box, ring] : boxes) {
            const Box inner = box;
            const auto around =
                std::find_if(glyphs.begin() + first, glyphs.end(), [&](const Glyph& glyph) { return within(inner, glyph.box); });
            if (around != glyphs.end())
                around->rings.push_back(ring);
            else
                glyphs.push_back({box, {ring}});
        }
    }
};

// Most letters end where it is, the round ones of them a little below.
double base_of(const std::vector<Glyph>& row, double height) {
    constexpr double kSameBase = 0.002, kRound = 0.03;  // of the height
    std::vector<double> bottoms;
    for (const Glyph& glyph : row) bottoms.push_back(glyph.box.bottom);
    std::sort(bottoms.begin(), bottoms.end());
    std::size_t most = 0;
    double base = bottoms.front();
    for (std::size_t i = 0, end = 0; i < bottoms.size(); ++i) {
        while (end < bottoms.size() && bottoms[end] - bottoms[i] <= kSameBase * height) ++end;
        if (end - i <= most) continue;
        most = end - i;
        base = bottoms[(i + end) / 2];
    }
    return *std::lower_bound(bottoms.begin(), bottoms.end(), base - kRound * height);
}

class OutlinedWords {
public:
    explicit OutlinedWords(FoundPage& figure) {
        DarkShapes dark(figure);
        std::vector<std::vector<Glyph>> rows = rows_of(std::move(dark.glyphs));
        std::erase_if(rows, [](const std::vector<Glyph>& row) { return !has_different(row); });
        std::size_t letters = 0;
        for (const auto& row : rows) letters += row.size();
        if (letters < kFewestLetters || rows.size() > kMostRows) return;
        std::sort(rows.begin(), rows.end(),
                  [](const auto& a, const auto& b) { return a.front().box.bottom < b.front().box.bottom; });
        for (const auto& row : rows) {
            Row& taken = rows_.emplace_back(Row{figure.words.size(), {}});
            add_words(figure, row, dark.rings);
            for (const Glyph& glyph : row)
                for (const std::size_t i : glyph.rings) {
                    const Taken& ring = taken.rings.emplace_back(std::move(dark.rings[i]));
                    (ring.stroke ? figure.page.strokes[ring.of].points : figure.page.areas[ring.of].rings[ring.ring]).clear();
                }
        }
        for (Area& area : figure.page.areas) std::erase_if(area.rings, [](const auto& ring) { return ring.empty(); });
    }

    void settle(FoundPage& figure) {
        std::size_t read = 0;
        for (const Row& row : rows_) read += figure.words[row.words].text.empty() ? 0 : 1;
        const bool all_print = 2 * read >= rows_.size();
        for (auto row = rows_.rbegin(); row != rows_.rend(); ++row) {
            const FoundWords& words = figure.words[row->words];
            if (!words.text.empty() || words.seen || all_print) continue;
            for (Taken& ring : row->rings) {
                if (ring.stroke)
                    figure.page.strokes[ring.of].points = std::move(ring.points);
                else
                    figure.page.areas[ring.of].rings.push_back(std::move(ring.points));
            }
            figure.words.erase(figure.words.begin() + static_cast<std::ptrdiff_t>(row->words));
        }
    }

private:
    struct Row {
        std::size_t words;  // its number in the figure
        std::vector<Taken> rings;
    };

    static void add_words(FoundPage& figure, const std::vector<Glyph>& row, const std::vector<Taken>& rings) {
        Box all = kNothing;
        for (const Glyph& glyph : row) all = together(all, glyph.box);
        const double base = base_of(row, all.height());
        FoundWords words;
        words.middle = all.middle();
        words.height = std::max(kLeastLetter, base - all.top);
        words.width = all.width();
        words.start = {all.left, base};
        words.unit = 1;
        // Rows of one size are of one font, maybe.
        const std::string font = "outlines " + std::to_string(std::lround(30 * std::log(words.height)));
        for (const Glyph& letter : letters_of_row(row)) {
            words.letters.push_back({figure.letter_shapes.size(), letter.box.left - all.left});
            LetterShape& shape = figure.letter_shapes.emplace_back(LetterShape{font, {}});
            for (const std::size_t i : letter.rings) {
                auto& ring = shape.rings.emplace_back(rings[i].points);
                for (Point& p : ring) p = {p.x - letter.box.left, p.y - base};
            }
        }
        figure.words.push_back(std::move(words));
    }

    std::vector<Row> rows_;
};

}  // namespace

void read_with_outlined_words(FoundPage& figure, const std::function<void(FoundPage& figure)>& read) {
    OutlinedWords outlined(figure);
    if (!figure.letter_shapes.empty()) read(figure);
    outlined.settle(figure);
}

}  // namespace tactics
