// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/letter_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "tactics/job/loose_shapes.h"
#include "tactics/job/shape_set.h"
#include "tactics/text/formula_letters.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

// Limits: fonts to try first, and for their signs; sizes for which letters may be hinted; shapes in a figure.
constexpr std::size_t kLikelyFonts = 48, kMostWide = 60, kMostSizes = 12, kMostShapes = 2000;
// Settings: what parts words, of em beyond the letter's own width, and of heights where that is not known.
constexpr double kSpace = 0.12, kGap = 0.5;

// In the order in which one is taken of those that look the same in a font.
std::vector<char32_t> codes_of(std::initializer_list<std::pair<char32_t, char32_t>> ranges) {
    std::vector<char32_t> codes;
    for (const auto& [from, to] : ranges)
        for (char32_t code = from; code <= to; ++code) codes.push_back(code);
    return codes;
}

const std::vector<char32_t>& common_codes() {
    static const std::vector<char32_t> codes = codes_of({{0x21, 0x7E}});
    return codes;
}

const std::vector<char32_t>& all_codes() {
    static const std::vector<char32_t> codes = codes_of({{0x21, 0x7E},
                                                         {0xA1, 0xAC},
                                                         {0xAE, 0x17F},
                                                         {0x391, 0x3D6},
                                                         {0x2010, 0x2022},
                                                         {0x2026, 0x2026},
                                                         {0x2030, 0x2033},
                                                         {0x2070, 0x2099},
                                                         {0x20AC, 0x20AC},
                                                         {0x2150, 0x215E},
                                                         {0x2190, 0x2195},
                                                         {0x2200, 0x222B},
                                                         {0x2245, 0x2265},
                                                         {0x25A0, 0x25FF},
                                                         {0xFB00, 0xFB04},
                                                         {0x400, 0x45F},
                                                         {0x218, 0x21B}});
    return codes;
}

// Α is Greek where its neighbours are.
const FontLetter* letter_in(const std::vector<FontLetter>& choices, char script) {
    for (const FontLetter& one : choices)
        if (!is_alphabetic(one.code) || script_of(one.code) == script) return &one;
    return choices.empty() ? nullptr : &choices.front();
}

class ShapeReading {
public:
    ShapeReading(FoundPage& figure, const Fonts& fonts) : figure_(figure), read_(figure.letter_shapes.size()) {
        std::map<std::string, std::vector<std::size_t>> by_font;
        for (const LetterShape& shape : figure.letter_shapes) {
            if (!shape.lone && shape.code == 0 && outlines_.size() < kMostShapes) by_font[shape.font].push_back(outlines_.size());
            outlines_.push_back(measure_rings(shape.rings));
        }
        for (auto& [name, own] : by_font) sets_.emplace_back(outlines_, std::move(own));
        // Letters of English tell one font from another fast; signs are looked for when they did not.
        const std::size_t all = std::numeric_limits<std::size_t>::max();
        look(fonts, common_codes(), 0, kLikelyFonts);
        look_bent(fonts);
        look(fonts, common_codes(), kLikelyFonts, all);
        look_bent(fonts);
        look(fonts, all_codes(), 0, kMostWide);
        look_for_loose(fonts);
        look_beside(fonts);
    }

    void fill(FoundWords& words) const {
        for (const char script : {'g', 'c', 'l'}) {
            bool all = true;
            words.text = text_of(words, script, all);
            if (all && script != 'l' && !latin(words)) return;
        }
    }

private:
    std::vector<ShapeSet*> unread() {
        std::vector<ShapeSet*> left;
        for (ShapeSet& set : sets_)
            if (!set.is_read(read_)) left.push_back(&set);
        return left;
    }

    void look(const Fonts& fonts, const std::vector<char32_t>& codes, std::size_t from, std::size_t end) {
        if (unread().empty()) return;
        std::size_t number = 0;
        fonts([&](const FontLetters& font) {
            if (number < from) return ++number > 0;
            for (const FontLetters::Of& own : forms_of(font)) {
                const std::vector<FontLetter> letters = measured(own(codes, Hinting::none, 0), codes);
                if (!has_letters(letters)) continue;
                for (ShapeSet* set : unread())
                    if (set->matches(letters, number))
                        take(*set, codes.size() > common_codes().size() ? letters : all_of(own), font.formula);
            }
            return ++number < end && !unread().empty();
        });
    }

    // Of that font and size.
    void take(const ShapeSet& set, const std::vector<FontLetter>& letters, const FontLetters::Of& formula = {}) {
        set.take(letters, read_);
        known_.push_back({letters, set.em(), formula});
    }

    // First in the fonts of other words. Marks of a plot that lie on each other may look like letters: few fonts are tried.
    void look_for_loose(const Fonts& fonts) {
        LooseShapes loose(figure_, outlines_, read_);
        for (const KnownFont& one : known_) {
            loose.read_as(one.letters, one.em);
            if (one.formula && loose.any()) loose.read_as(all_of(one.formula), one.em);
        }
        each_likely(
            fonts, [&] { return loose.may_tell_font(); },
            [&](const FontLetters& font) {
                std::optional<double> em;  // formulas are of the size of their font
                for (const FontLetters::Of& own : forms_of(font)) {
                    const std::vector<FontLetter> letters = measured(own(common_codes(), Hinting::none, 0), common_codes());
                    if (!em && has_letters(letters)) em = loose.em_in(letters);
                    if (em) loose.read_as(all_of(own), *em);
                }
            });
        each_likely(
            fonts, [&] { return loose.has_indices(); },
            [&](const FontLetters& font) {
                loose.read_indices(measured(font.plain(common_codes(), Hinting::none, 0), common_codes()));
            });
    }

    // Reads with one likely font after the other while something is left to read.
    template <typename Left, typename Read>
    static void each_likely(const Fonts& fonts, const Left& is_left, const Read& read) {
        std::size_t number = 0;
        if (is_left())
            fonts([&](const FontLetters& font) {
                read(font);
                return ++number < kLikelyFonts && is_left();
            });
    }

    static std::vector<FontLetters::Of> forms_of(const FontLetters& font) {
        std::vector<FontLetters::Of> forms{font.plain};
        if (font.formula) forms.push_back(font.formula);
        return forms;
    }

    // A formula has some letters of fonts that have no others in the figure: the 1 of an index, a minus sign.
    void look_beside(const Fonts& fonts) {
        std::map<std::size_t, double> open;  // shapes, and the em of the letters beside
        for (const FoundWords& words : figure_.words) {
            const double em = line_of(words, 'l').em;
            for (const DrawnLetter& one : words.letters) {
                const LetterShape& shape = figure_.letter_shapes[one.shape];
                if (em > 0 && shape.code == 0 && !shape.inked && !shape.rings.empty() && read_[one.shape].empty())
                    open[one.shape] = em;
            }
        }
        std::erase_if(open, [&](const auto& one) { return is_nearly_known(one.first, one.second); });
        each_likely(
            fonts, [&] { return !open.empty(); },
            [&](const FontLetters& font) {
                for (const FontLetters::Of& own : forms_of(font)) {
                    const std::vector<FontLetter> letters = all_of(own);
                    std::erase_if(open, [&](const auto& one) { return read_beside(one.first, one.second, letters); });
                }
            });
    }

    // A letter of the font beside it, in another edition.
    bool is_nearly_known(std::size_t shape, double em) {
        constexpr double kSameSize = 0.01;
        for (const KnownFont& font : known_) {
            const FontLetter* letter =
                std::abs(font.em / em - 1) < kSameSize ? nearly_same(font.letters, outlines_[shape], em) : nullptr;
            if (letter != nullptr) read_[shape] = {*letter};
        }
        return !read_[shape].empty();
    }

    // As large as the letters beside, or smaller as an index is.
    bool read_beside(std::size_t shape, double line, const std::vector<FontLetter>& letters) {
        constexpr double kSmallest = 0.45, kLargest = 1.03;  // of their em
        const OutlineMeasure& outline = outlines_[shape];
        read_[shape] = letters_like(letters, [&](const FontLetter& letter) {
            const double em = em_of(outline, letter);
            return em < kSmallest * line || em > kLargest * line ? 1 : apart_at(outline, letter.outline, em);
        });
        return !read_[shape].empty();
    }

    static std::vector<FontLetter> all_of(const FontLetters::Of& font) {
        return measured(font(all_codes(), Hinting::none, 0), all_codes());
    }

    void look_bent(const Fonts& fonts) {
        std::set<std::size_t> wanted;
        for (const ShapeSet* set : unread())
            for (const NearFont& one : set->candidates()) wanted.insert(one.font);
        if (wanted.empty()) return;
        std::size_t number = 0;
        fonts([&](const FontLetters& font) {
            if (wanted.contains(number)) {
                const std::vector<FontLetter> letters = all_of(font.plain);
                for (ShapeSet* set : unread())
                    for (const NearFont& one : set->candidates())
                        if (one.font == number) try_bent(font, letters, *set, one.em);
            }
            return ++number <= *wanted.rbegin() && !unread().empty();
        });
    }

    // Hinted shapes depend on the size, which is mostly a whole number of pixels, or tenths of one.
    void try_bent(const FontLetters& font, const std::vector<FontLetter>& letters, ShapeSet& set, double em) {
        const std::vector<char32_t> codes = set.near(letters, em);
        std::vector<double> sizes;
        for (double size = std::floor(em * (1 - kBentSize) * 10) / 10; size < em * (1 + kBentSize); size += 0.1)
            sizes.push_back(std::round(size * 10) / 10);
        const auto oddness = [&](double size) {
            return std::abs(size - em) / em + (size == std::round(size) ? 0 : 2 * size == std::round(2 * size) ? 0.02 : 0.03);
        };
        std::stable_sort(sizes.begin(), sizes.end(), [&](double a, double b) { return oddness(a) < oddness(b); });
        if (sizes.size() > kMostSizes) sizes.resize(kMostSizes);
        for (const double size : sizes)
            for (const Hinting hinting : {Hinting::full, Hinting::light}) {
                const std::vector<FontLetter> bent = measured(font.plain(codes, hinting, size), codes);
                if (!set.matches_at(bent, size)) continue;
                take(set, bent);
                if (set.is_read(read_)) return;
            }
    }

    // Each letter may be one of Latin: then it is.
    bool latin(const FoundWords& words) const {
        bool all = true;
        text_of(words, 'l', all);
        return all;
    }

    // Empty: some letter is not known. `all`: each has a letter of that script.
    std::string text_of(const FoundWords& words, char script, bool& all) const {
        std::string text;
        const Line line = line_of(words, script);
        double edge = 0;  // where the last letter ends
        bool after_letter = false;
        OffLine off_line;
        double tall = 0;
        for (const DrawnLetter& one : words.letters)
            for (const auto& ring : figure_.letter_shapes[one.shape].rings)
                for (const Point& p : ring) tall = std::max(tall, -p.y);
        for (const DrawnLetter& one : words.letters) {
            const LetterShape& shape = figure_.letter_shapes[one.shape];
            if (shape.rings.empty()) {
                text += ' ';
                after_letter = false;
                continue;
            }
            const FontLetter* letter = shape.code != 0 ? nullptr : letter_in(read_[one.shape], script);
            if (shape.code == 0 && letter == nullptr) return "";
            double left = 0, right = 0, space = kGap * tall;
            if (letter != nullptr) {
                const double em = em_of(outlines_[one.shape], *letter);
                left = shape.inked ? -letter->left * em : 0;
                right = left + letter->advance * em;
                space = kSpace * em;
                all = all && (!is_alphabetic(letter->code) || script_of(letter->code) == script);
            } else {
                left = right = shape.rings[0][0].x;
                for (const auto& ring : shape.rings)
                    for (const Point& p : ring) {
                        left = std::min(left, p.x);
                        right = std::max(right, p.x);
                    }
            }
            const Place place = letter != nullptr ? place_of(one, *letter, line) : Place::on_line;
            if (place == Place::nowhere) return "";
            const bool space_before = after_letter && one.at + left - edge > space;
            if (place != off_line.place || space_before) off_line.append_to(text);
            if (space_before) text += ' ';
            off_line.place = place;
            if (place == Place::on_line)
                add(text, plain_code(letter != nullptr ? letter->code : shape.code));
            else
                off_line.letters += plain_code(letter->code);
            edge = one.at + right;
            after_letter = true;
        }
        off_line.append_to(text);
        return to_line(text);
    }

    enum class Place { on_line, raised, lowered, nowhere };

    // An exponent or an index.
    struct OffLine {
        Place place = Place::on_line;
        std::u32string letters;

        void append_to(std::string& text) {
            if (place == Place::raised) append_raised(text, letters);
            if (place == Place::lowered) append_lowered(text, letters);
            letters.clear();
        }
    };

    // The em of the largest letters, and where their line is, up from where the shapes have it.
    struct Line {
        double em = 0, foot = 0;
    };
    Line line_of(const FoundWords& words, char script) const {
        Line line;
        for (const DrawnLetter& one : words.letters) {
            const FontLetter* letter = letter_in(read_[one.shape], script);
            if (letter == nullptr) continue;
            const double em = em_of(outlines_[one.shape], *letter);
            if (em <= line.em) continue;
            line = {em, foot_of(one, *letter)};
        }
        return line;
    }

    // The line that the letter stands on.
    double foot_of(const DrawnLetter& one, const FontLetter& letter) const {
        const OutlineMeasure& outline = outlines_[one.shape];
        return one.up + outline.lengths[1] - letter.outline.lengths[1] * em_of(outline, letter);
    }

    // Smaller and off the line it is an exponent or an index; off the line and as large, nobody knows.
    Place place_of(const DrawnLetter& one, const FontLetter& letter, const Line& line) const {
        constexpr double kSmaller = 0.85, kRaised = 0.15, kLowered = 0.05;  // of the em
        const double foot = foot_of(one, letter) - line.foot;
        const bool off = foot > kRaised * line.em || foot < -kLowered * line.em;
        if (em_of(outlines_[one.shape], letter) > kSmaller * line.em) return off && one.up != 0 ? Place::nowhere : Place::on_line;
        return !off ? Place::on_line : foot > 0 ? Place::raised : Place::lowered;
    }

    static void add(std::string& text, char32_t code) {
        constexpr std::array<std::string_view, 5> kJoined{"ff", "fi", "fl", "ffi", "ffl"};
        if (code >= 0xFB00 && code < 0xFB00 + kJoined.size())
            text += kJoined[code - 0xFB00];
        else
            append_letter(text, code);
    }

    FoundPage& figure_;
    std::vector<OutlineMeasure> outlines_;  // of its shapes
    std::vector<ShapeSet> sets_;
    struct KnownFont {
        std::vector<FontLetter> letters;
        double em;
        FontLetters::Of formula;
    };
    std::vector<KnownFont> known_;
    LettersOfShapes read_;  // of each shape what it may be: letters that look the same
};

}  // namespace

void read_letter_shapes(FoundPage& figure, const Fonts& fonts) {
    const ShapeReading reading(figure, fonts);
    for (FoundWords& words : figure.words)
        if (!words.letters.empty()) reading.fill(words);
}

}  // namespace tactics
