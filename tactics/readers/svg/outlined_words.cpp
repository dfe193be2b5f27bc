// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/outlined_words.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "tactics/geometry/box.h"
#include "tactics/readers/svg/chart_parts.h"
#include "tactics/readers/svg/clip.h"
#include "tactics/readers/svg/letter_rows.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

// Limits: of a figure 200 mm wide or high, letters are no smaller; shapes, and shapes of one path.
constexpr double kLeastLetter = 0.4;  // mm
constexpr std::size_t kMostRings = 8'000, kMostOfPath = 1'000, kMostRows = 500;
constexpr double kDarkLetter = 0.9, kSameShade = 0.1;  // lightness
constexpr std::size_t kFewestLetters = 5;              // letters in a figure with words: fewer may be parts of an icon

// A ring where it was.
struct Taken {
    bool stroke;           // a closed one, else a ring of an area
    std::size_t of, ring;  // its number in the page, and in the area
    std::vector<Point> points;
    bool twin = false;  // of another: letters with a line around them are there twice
};

bool is_same(const Box& a, const Box& b) {
    constexpr double kSameRing = 0.02;  // mm
    return std::abs(a.left - b.left) < kSameRing && std::abs(a.right - b.right) < kSameRing &&
           std::abs(a.top - b.top) < kSameRing && std::abs(a.bottom - b.bottom) < kSameRing;
}

bool within(const Box& inner, const Box& outer) {
    return inner.left > outer.left && inner.right < outer.right && inner.top > outer.top && inner.bottom < outer.bottom;
}

bool is_letter_size(const std::vector<Point>& points) {
    const Box box = box_of(points);
    return points.size() > 2 && std::max(box.width(), box.height()) <= kLargestLetter && box.height() >= kLeastLetter / 4;
}

bool is_filled(const FoundLook& look) {
    return look.fill >= 0 && look.fill <= kDarkLetter && (look.line < 0 || std::abs(look.line - look.fill) <= kSameShade);
}
bool is_outlined(const FoundLook& look) { return look.fill < 0 && look.line >= 0 && look.line <= kDarkLetter; }

// Letters of one word have one paint: all over, or as their outlines alone, or as light as paper, which is not drawn.
struct LetterPaint {
    enum class Kind { filled, outlined, light } kind;
    double from = 0, to = 0;  // lightness

    bool is_of(const FoundLook& look) const {
        if (kind == Kind::outlined) return is_outlined(look);
        return kind == Kind::filled && is_filled(look) && look.fill >= from && look.fill <= to;
    }
};

// The fills that shapes have, each with what is as light, and outlines.
std::vector<LetterPaint> paints_of(const FoundPage& figure) {
    std::vector<double> fills;
    for (const FoundLook& look : figure.looks)
        if (is_filled(look)) fills.push_back(look.fill);
    std::sort(fills.begin(), fills.end());
    std::vector<LetterPaint> paints;
    for (const double fill : fills)
        if (paints.empty() || fill - paints.back().to > kSameShade)
            paints.push_back({LetterPaint::Kind::filled, fill, fill});
        else
            paints.back().to = fill;
    paints.push_back({LetterPaint::Kind::outlined});
    paints.push_back({LetterPaint::Kind::light});
    return paints;
}

// Shapes of a figure that are so painted and no larger than letters.
class SmallShapes {
public:
    SmallShapes(const FoundPage& figure, const LetterPaint& paint) {
        for (const FoundLook& look : figure.looks) {
            if (!paint.is_of(look)) continue;
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
        if (paint.kind == LetterPaint::Kind::light) add_light(figure);
    }

    std::vector<Taken> rings;
    Glyphs glyphs;

private:
    void add_light(const FoundPage& figure) {
        for (const auto& shape : figure.light_shapes) {
            const std::size_t from = rings.size();
            for (const auto& ring : shape) add({false, 0, 0, ring});
            gather(from);
        }
    }

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
            const auto around = std::find_if(glyphs.begin() + first, glyphs.end(), [&](const Glyph& glyph) {
                return within(inner, glyph.box) || is_same(inner, glyph.box);
            });
            const std::size_t corners = rings[ring].points.size();
            if (around == glyphs.end()) {
                glyphs.push_back({box, {ring}, corners});
                continue;
            }
            rings[ring].twin = std::any_of(around->rings.begin(), around->rings.end(),
                                           [&](std::size_t i) { return is_same(box_of(rings[i].points), inner); });
            around->rings.push_back(ring);
            around->corners += rings[ring].twin ? 0 : corners;
        }
    }
};

class OutlinedWords {
public:
    explicit OutlinedWords(FoundPage& figure) {
        std::vector<PaintedRows> all;
        std::size_t letters = 0;
        for (const LetterPaint& paint : paints_of(figure)) {
            SmallShapes shapes(figure, paint);
            PaintedRows painted{paint.kind, letter_rows(std::move(shapes.glyphs)), std::move(shapes.rings)};
            for (const LetterRow& row : painted.rows)
                letters += paint.kind != LetterPaint::Kind::filled || row.lone || row.alike ? 0 : row.glyphs.size();
            all.push_back(std::move(painted));
        }
        for (PaintedRows& painted : all)
            take_rows(figure, painted, letters >= kFewestLetters && painted.kind == LetterPaint::Kind::filled);
        for (Area& area : figure.page.areas) std::erase_if(area.rings, [](const auto& ring) { return ring.empty(); });
    }

    void settle(FoundPage& figure) {
        std::size_t read = 0, all = 0;
        const std::vector<Rect> surfaces = surfaces_below(figure);
        for (Row& row : rows_) {
            FoundWords& words = figure.words[row.words];
            free_mark(figure, row, words);
            words.text = without_spacing(words.text);
            if (row.doubt || is_torn(words.text) || !fits(words, figure.letter_shapes) ||
                (row.only_read && !has_letter(words.text)) || (row.light && !is_seen(figure, row.words, surfaces))) {
                words.seen = words.seen || !words.text.empty();
                words.text.clear();
            }
            read += row.only_read || words.text.empty() ? 0 : 1;
            all += row.only_read ? 0 : 1;
        }
        const bool all_print = 2 * read >= all;
        for (auto row = rows_.rbegin(); row != rows_.rend(); ++row) {
            const FoundWords& words = figure.words[row->words];
            if (!words.text.empty() || (!row->only_read && (words.seen || all_print))) continue;
            for (Taken& ring : row->rings) give_back(figure, std::move(ring));
            figure.words.erase(figure.words.begin() + static_cast<std::ptrdiff_t>(row->words));
        }
    }

private:
    struct Row {
        std::size_t words;  // its number in the figure
        std::vector<Taken> rings;
        bool only_read;  // it is print only if it is read
        bool doubt;
        bool light = false;
    };

    struct PaintedRows {
        LetterPaint::Kind kind;
        std::vector<LetterRow> rows;
        std::vector<Taken> rings;
    };

    static void give_back(FoundPage& figure, Taken ring) {
        if (ring.stroke)
            figure.page.strokes[ring.of].points = std::move(ring.points);
        else
            figure.page.areas[ring.of].rings.push_back(std::move(ring.points));
    }

    // The point of a sample in a legend, right before its words, is none of their letters.
    static void free_mark(FoundPage& figure, Row& row, FoundWords& words) {
        constexpr std::string_view kDisc = "\u25CF";
        if (!words.text.starts_with(kDisc) || words.upwards || words.letters.size() < 2) return;
        const double next = words.letters[1].at, edge = words.start.x + next;
        const auto marks = std::stable_partition(row.rings.begin(), row.rings.end(),
                                                 [&](const Taken& ring) { return box_of(ring.points).middle().x > edge; });
        for (auto ring = marks; ring != row.rings.end(); ++ring) give_back(figure, std::move(*ring));
        row.rings.erase(marks, row.rings.end());
        words.letters.erase(words.letters.begin());
        for (DrawnLetter& letter : words.letters) letter.at -= next;
        words.text = to_line(words.text.substr(kDisc.size()));
        words.start.x = edge;
        words.width -= next;
        words.middle.x += next / 2;
    }

    // `sure`: they are print though nobody may read them.
    void take_rows(FoundPage& figure, PaintedRows& painted, bool sure) {
        std::vector<LetterRow>& found = painted.rows;
        if (found.size() > kMostRows) return;
        std::stable_sort(found.begin(), found.end(), [](const LetterRow& a, const LetterRow& b) {
            return a.lone != b.lone ? b.lone : a.glyphs.front().box.bottom < b.glyphs.front().box.bottom;
        });
        for (const LetterRow& row : found) {
            Row& taken = rows_.emplace_back(Row{figure.words.size(), {}, !sure || row.lone || row.alike, row.doubt});
            add_words(figure, row, painted.rings, !sure);
            taken.light = painted.kind == LetterPaint::Kind::light;
            if (taken.light) continue;  // it was not drawn
            for (const Glyph& glyph : row.glyphs)
                for (const std::size_t i : glyph.rings) {
                    const Taken& ring = taken.rings.emplace_back(std::move(painted.rings[i]));
                    (ring.stroke ? figure.page.strokes[ring.of].points : figure.page.areas[ring.of].rings[ring.ring]).clear();
                }
        }
    }

    static void add_words(FoundPage& figure, const LetterRow& row, const std::vector<Taken>& rings, bool lone) {
        const Box all = box_of_row(row.glyphs);
        const double base = row.lone ? all.bottom : base_of_row(row.glyphs);
        const auto on_page = [&](Point p) { return row.upwards ? turned_back(p) : p; };
        FoundWords words;
        words.middle = on_page(all.middle());
        words.height = std::max(kLeastLetter, base - all.top);
        words.width = all.width();
        words.upwards = row.upwards;
        words.start = on_page({all.left, base});
        words.way = on_page({1, 0});
        words.unit = 1;
        // Rows of one size are of one font, maybe.
        const std::string font = "outlines " + std::to_string(std::lround(30 * std::log(words.height)));
        // Of one or two letters nobody knows where their line is: both may be round.
        const Glyphs letters = letters_of_row(row.glyphs);
        const bool few = letters.size() < 3;
        for (const Glyph& letter : letters) {
            words.letters.push_back({figure.letter_shapes.size(), letter.box.left - all.left});
            LetterShape& shape = figure.letter_shapes.emplace_back(LetterShape{font, {}});
            shape.inked = true;
            shape.lone = lone || few;
            for (const std::size_t i : letter.rings) {
                if (rings[i].twin) continue;
                auto& ring = shape.rings.emplace_back(rings[i].points);
                for (Point& p : ring) {
                    if (row.upwards) p = turned(p);
                    p = {p.x - letter.box.left, p.y - base};
                }
            }
        }
        figure.words.push_back(std::move(words));
    }

    // What light letters are seen on, if there are any: something darker, or a picture.
    std::vector<Rect> surfaces_below(const FoundPage& figure) const {
        std::vector<Rect> surfaces;
        if (std::none_of(rows_.begin(), rows_.end(), [](const Row& row) { return row.light; })) return surfaces;
        for (const FoundPicture& picture : figure.pictures) surfaces.push_back(picture.shown);
        for (const FoundLook& look : figure.looks)
            if (look.fill >= 0 && look.fill <= kDarkLetter) surfaces.push_back(box_of(figure, look));
        return surfaces;
    }

    // As a halo behind the same words they are none.
    static bool is_seen(const FoundPage& figure, std::size_t row, const std::vector<Rect>& surfaces) {
        const FoundWords& words = figure.words[row];
        for (std::size_t i = 0; i < figure.words.size(); ++i)
            if (i != row && distance(figure.words[i].middle, words.middle) < words.height / 2) return false;
        return std::any_of(surfaces.begin(), surfaces.end(),
                           [&](const Rect& box) { return box.width > words.width && box.holds(words.middle); });
    }

    // A row of points may be one of full stops.
    static bool has_letter(const std::string& text) {
        return std::any_of(text.begin(), text.end(), [](char c) {
            return (c >= '0' && c <= '9') || ((c | 32) >= 'a' && (c | 32) <= 'z') || static_cast<unsigned char>(c) >= 0x80;
        });
    }

    // "B o b" is a word whose letters stand apart; "n > 0 ?" is none.
    static std::string without_spacing(const std::string& text) {
        const auto blanks = static_cast<std::size_t>(std::count(text.begin(), text.end(), ' '));
        if (blanks < 2 || letters_in(text) != 2 * blanks + 1) return text;
        std::string out;
        bool blank = true;
        for (std::string_view rest = text; !rest.empty(); blank = !blank) {
            const std::string_view before = rest;
            const char32_t letter = take_letter(rest);
            const bool is_sign = letter < 0x80 && !((letter | 32) >= 'a' && (letter | 32) <= 'z');
            if ((letter == U' ') == blank || (is_sign && letter != U' ')) return text;
            if (letter != U' ') out += before.substr(0, before.size() - rest.size());
        }
        return out;
    }

    // "Chur c h": a word whose letters are spaced, but not evenly.
    static bool is_torn(std::string_view text) {
        std::size_t lone = 0;
        while (!text.empty()) {
            const std::string_view part = text.substr(0, text.find(' '));
            lone += part.size() == 1 && part[0] >= 'a' && part[0] <= 'z' ? 1 : 0;
            text.remove_prefix(std::min(part.size() + 1, text.size()));
        }
        return lone > 1;
    }

    // What was read as print is has as many letters as there are, and as many words as they leave gaps; and what is flat is a
    // sign.
    static bool fits(const FoundWords& words, const std::vector<LetterShape>& shapes) {
        constexpr double kGapOfWords = 0.3, kFlat = 0.25;  // heights, from ink to ink; of a letter
        if (words.text.empty() || words.sureness >= 100) return true;
        std::u32string letters;
        for (std::string_view rest = words.text; !rest.empty();)
            if (const char32_t code = take_letter(rest); code != ' ') letters += code;
        std::size_t parts = 1;
        double edge = 0;
        for (std::size_t i = 0; i < words.letters.size(); ++i) {
            const DrawnLetter& letter = words.letters[i];
            if (i > 0 && letter.at - edge > kGapOfWords * words.height) ++parts;
            Extent ink;
            for (const auto& ring : shapes[letter.shape].rings)
                for (const Point p : ring) ink.add(p);
            edge = letter.at + ink.box.left + ink.box.width;
            const bool flat = ink.box.height < kFlat * words.height;
            if (letters.size() == words.letters.size() && flat && is_like_letter(letters[i])) return false;
        }
        const std::size_t blanks = letters_in(words.text) - letters.size();
        // Letters that touch are one shape, and signs of two parts two.
        const std::size_t said = letters.size(), drawn = words.letters.size();
        return std::max(said, drawn) - std::min(said, drawn) <= drawn / 8 && blanks + 1 == parts && drawn > 2;
    }

    // A plain figure or letter.
    static bool is_like_letter(char32_t code) { return is_digit(code) || ((code | 32) >= U'a' && (code | 32) <= U'z'); }

    std::vector<Row> rows_;
};

}  // namespace

void add_light_shape(FoundPage& figure, const std::vector<Subpath>& surface, const Paint& fill, double lightness) {
    if (fill.none || fill.fades || fill.pattern > 0 || lightness <= kDarkLetter || figure.light_shapes.size() > kMostRings)
        return;
    std::vector<std::vector<Point>> rings;
    for (const Subpath& subpath : surface) {
        if (!is_letter_size(subpath.points)) return;
        rings.push_back(subpath.points);
    }
    figure.light_shapes.push_back(std::move(rings));
}

void read_with_outlined_words(FoundPage& figure, const std::function<void(FoundPage& figure)>& read) {
    OutlinedWords outlined(figure);
    if (!figure.letter_shapes.empty()) read(figure);
    outlined.settle(figure);
}

}  // namespace tactics
