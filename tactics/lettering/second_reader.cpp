// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>

#include "tactics/lettering/agreement.h"
#include "tactics/lettering/beyond_end.h"
#include "tactics/lettering/form_words.h"
#include "tactics/lettering/meant_letters.h"
#include "tactics/lettering/pale_ink.h"
#include "tactics/lettering/read_line.h"
#include "tactics/lettering/strange_print.h"
#include "tactics/lettering/strip.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

constexpr int kLeastPrint = 7;  // pixels, of the tallest letter of a line; smaller print is reported, not set. A setting

// Of the height of letters, what must be free beyond the ends of a line.
constexpr double kRoomOfWords = 0.3, kRoomOfLetters = 0.5;

bool hides_sign(const Image& grey, const LetteringLine& line, const FormReading& reading) {
    return !reading.letters.empty() && is_digit(reading.letters.back().code) && may_hide_sign(grey, line);
}

// A letter by itself is one of a word if something is nearer to it than words are to each other; a figure may stand beside a
// tick.
double room_of(const FormReading& reading) {
    return reading.letters.size() == 1 && !is_digit(reading.letters.front().code) ? kRoomOfLetters : kRoomOfWords;
}

// A line with what fonts say of it.
struct Held {
    ReadLine read;
    FormWords form;
    bool open = false;  // as Belief has it
    bool sure() const { return read.words.sure; }
    double foot() const {
        return (read.line.upwards ? read.line.box.left : read.line.box.top) + form.reading.foot;
    }  // for two that are compared
};

Held held(const Image& grey, ReadLine read, FormWords form) {
    Belief belief = believe(form, {read.words.text, read.words.sureness, read.alike, read.words.sure});
    const bool cut = (belief.sure || belief.nearly || belief.open) &&
                     (is_cut(grey, read.line, room_of(form.reading)) || hides_sign(grey, read.line, form.reading) ||
                      has_strange_ink(grey, read.line));
    // If the readers divide words differently, or the gaps disagree, one may have missed a point.
    // Wide gaps and narrow ones tell.
    const auto parts = static_cast<std::size_t>(std::count(belief.text.begin(), belief.text.end(), ' ')) + 1;
    const WordCount count = words_in(read.line);
    const bool formula = form.sized && form.agreed && form.thin;
    const bool parted = is_words(read.line) && !formula && (parts < count.least || parts > count.most);
    const bool same = parted && form.agreed && read.counted && read.words.sure;
    const auto told = same ? with_its_gaps(form.reading, belief.text, read.words.text) : std::nullopt;
    if (same) belief.text = told.value_or(read.words.text);
    for (const std::string& text : {form.text, form.reading.text})
        if (!text.empty()) read.readings.push_back(text);
    const bool lost = parted && !told && belief.text != read.words.text;
    read.words.text = std::move(belief.text);
    read.words.sureness = belief.sureness;
    // "new" has no letter as high as others of its size.
    constexpr double kCapital = 0.7;  // em
    const bool large = read.line.letter_height >= kLeastPrint || (form.sized && kCapital * form.reading.em >= kLeastPrint);
    read.words.sure = belief.sure && !cut && !lost && large;
    read.tell = belief.tell || belief.sure || belief.open;
    read.nearly = belief.nearly && !cut && !lost && large;
    return {std::move(read), std::move(form), belief.open && !cut && !lost && large};
}

// Print in a font that is not installed is accepted only with the highest confidence. Leaves and stones, which match no font
// either, are read as words with up to 90 of 100.
void doubt(const Image& grey, ReadLine& one) {
    constexpr double kSure = 93;  // settings, both
    constexpr std::size_t kLetters = 4;
    one.tell = one.words.sure;
    const WordCount count = words_in(one.line);
    one.words.sure = one.words.sure && one.words.sureness >= kSure && one.line.letters.size() >= kLetters &&
                     count.least == count.most && !names_letter_in_formula(one.words.text) &&
                     !is_cut(grey, one.line, kRoomOfWords);
}

bool has_ink_of(const PixelBox& box, const std::vector<Held>& lines) {
    return std::any_of(lines.begin(), lines.end(),
                       [&](const Held& one) { return one.sure() && overlap(one.read.line.box, box); });
}

// Signs between two sides: the text on both sides is one label, however wide the gaps. So is what stands between two brackets.
bool is_sign(std::string_view text) {
    constexpr std::string_view kSigns[] = {"=", "<", ">", "\u2248", "\u2264", "\u2265", "\u2260"};
    return std::find(std::begin(kSigns), std::end(kSigns), text) != std::end(kSigns);
}
// A minus sign that lies across two rows of pixels looks like "=" right before a figure.
bool is_pale_minus(std::string_view text) { return text.size() > 1 && text[0] == '=' && text[1] != ' '; }
bool ends_with_sign(std::string_view text) { return is_sign(text.substr(text.rfind(' ') + 1)); }
bool begins_with_sign(std::string_view text) { return is_sign(text.substr(0, text.find(' '))) || text.starts_with("\u00b0"); }

// Along its line, from where it begins to where it ends.
std::pair<int, int> reach_of(const LetteringLine& line) {
    return line.upwards ? std::pair(-line.box.bottom, -line.box.top) : std::pair(line.box.left, line.box.right);
}

bool go_together(const Held& a, const Held& b) {
    constexpr double kGap = 0.75;  // em; a setting
    const auto may = [](const Held& one) {
        return one.form.sized && !one.form.text.empty() && (one.sure() || one.open || is_sign(one.form.text));
    };
    const LetteringLine &one = a.read.line, &other = b.read.line;
    if (!may(a) || !may(b) || a.form.font != b.form.font || one.light != other.light || one.upwards != other.upwards)
        return false;
    const double em = a.form.reading.em;
    const int gap = reach_of(other).first - reach_of(one).second;
    const bool closes = a.open && b.open && has_pairs(a.form.text + b.form.text);
    return (closes || ends_with_sign(a.form.text) || begins_with_sign(b.form.text)) && gap >= 0 && gap <= kGap * em &&
           std::abs(b.form.reading.em - em) <= 0.08 * em && std::abs(a.foot() - b.foot()) <= 1 + 0.05 * em;
}

// "mm" beside an axis: letters right beside each other, some of which look otherwise from the side, as rings and crosses do not.
bool is_short_name(const Held& one) {
    constexpr double kMean = 0.95, kBeside = 0.2;  // em
    constexpr std::u32string_view kAlikeFromTheSide = U"oOxXsSzZNHIl";
    const std::vector<FormLetter>& letters = one.form.reading.letters;
    if (!one.sure() || !one.form.sized || one.form.reading.mean < kMean || letters.size() < 2) return false;
    bool telling = false;
    for (std::size_t i = 0; i < letters.size(); ++i) {
        if (!is_lower(letters[i].code) && !is_upper(letters[i].code)) return false;
        telling = telling || kAlikeFromTheSide.find(letters[i].code) == std::u32string_view::npos;
        if (i > 0 && letters[i].box.left - letters[i - 1].box.right > kBeside * one.form.reading.em) return false;
    }
    return telling;
}

// Numbers at an upright axis may climb, as its name does: two of them above each other, or what goes on with a line that climbs;
// and so may its unit.
// Letters that were read from the left to the right there are none then. One that is not sure is kept for its axis, which may
// bear it out, or else to be told.
void add_climbing(std::vector<Held>& lines, std::vector<Held> climbing) {
    std::erase_if(climbing, [&](const Held& one) { return one.form.font < 0 || has_ink_of(one.read.line.box, lines); });
    const auto in_column = [](const Held& a, const Held& b) {
        const PixelBox &one = a.read.line.box, &other = b.read.line.box;
        return a.form.font == b.form.font && std::abs(one.right - other.right) <= 2 &&
               std::abs(one.left - other.left) <= 0.3 * one.width();
    };
    const auto is_read = [](const Held& one) { return one.sure() || one.read.nearly || one.read.tell; };
    std::vector<Held> kept;
    for (std::size_t i = 0; i < climbing.size(); ++i) {
        std::size_t sure = 0, others = 0;
        for (std::size_t k = 0; k < climbing.size(); ++k) {
            if (i == k || !in_column(climbing[i], climbing[k])) continue;
            sure += climbing[k].sure() ? 1 : 0;
            others += is_read(climbing[k]) ? 1 : 0;
        }
        for (const Held& line : lines) others += line.read.line.upwards && is_read(line) && in_column(climbing[i], line) ? 1 : 0;
        // A ring is a 0 only where others are numbers.
        const std::size_t least = is_read(climbing[i]) ? 1 : 2;
        if (!(climbing[i].sure() && sure > 0) && others < least && !is_short_name(climbing[i])) continue;
        kept.push_back(climbing[i]);
        kept.back().read.tell = true;
    }
    std::erase_if(climbing, [](const Held& one) { return !one.sure(); });
    for (const Held& one : climbing)
        if (std::any_of(lines.begin(), lines.end(), [&](const Held& line) { return line.sure() && go_together(line, one); }))
            kept.push_back(one);
    for (Held& one : kept) {
        std::erase_if(lines, [&](const Held& other) { return overlap(other.read.line.box, one.read.line.box); });
        lines.push_back(std::move(one));
    }
}

// It may be what is left of a line.
bool has_sign_at_end(std::string_view text) {
    constexpr std::string_view kSigns = ".,:;'`\"-_^";
    return text.empty() || kSigns.find(text.front()) != text.npos || kSigns.find(text.back()) != text.npos ||
           text.starts_with("\u2212");
}

bool is_believed(const Held& freed) {
    return freed.sure() && freed.form.sized && !freed.form.text.empty() && !freed.read.freed->lacks &&
           !has_sign_at_end(freed.read.words.text);
}

bool is_part(const Held& one, const Held& whole) {
    const PixelBox &box = one.read.line.box, &all = whole.read.line.box;
    const int x = (box.left + box.right) / 2, y = (box.top + box.bottom) / 2;
    return x >= all.left && x < all.right && y >= all.top && y < all.bottom;
}

// What was freed of lines that are drawn is believed and takes the place of its parts; else these are as they were before, but
// for those with which it goes on.
void keep_freed(std::vector<Held>& lines) {
    const auto own = std::stable_partition(lines.begin(), lines.end(), [](const Held& one) { return !one.read.freed; });
    std::vector<Held> freed(std::make_move_iterator(own), std::make_move_iterator(lines.end())), kept;
    lines.erase(own, lines.end());
    for (Held& whole : freed) {
        const bool known = std::any_of(kept.begin(), kept.end(),
                                       [&](const Held& other) { return overlap(other.read.line.box, whole.read.line.box); });
        if (known) continue;
        if (is_believed(whole)) {
            std::erase_if(lines, [&](const Held& one) { return is_part(one, whole); });
            kept.push_back(std::move(whole));
        } else if (whole.read.freed->goes_on)
            for (Held& one : lines)
                if (one.sure() && is_part(one, whole)) {
                    one.read.words.sure = false;
                    one.read.tell = true;
                }
    }
    std::move(kept.begin(), kept.end(), std::back_inserter(lines));
}

void put_together(Held& a, const Held& b) {
    ReadLine &one = a.read, other = b.read;
    const auto add = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    const double foot = a.foot();
    add(one.line.letters, other.line.letters);
    add(one.line.marks, other.line.marks);
    add(one.line.raised, other.line.raised);
    add(one.words.ink, other.words.ink);
    one.line.box = one.words.box = around(one.line.box, other.line.box);
    one.line.letter_height = one.words.letter_height = std::max(one.line.letter_height, other.line.letter_height);
    one.words.text += " " + b.read.words.text;
    one.words.sureness = std::min(one.words.sureness, other.words.sureness);
    a.form.text = one.words.text;
    a.form.reading.foot = foot - (one.line.upwards ? one.line.box.left : one.line.box.top);
    a.open = (a.open || b.open) && !has_pairs(one.words.text);
    one.words.sure = !a.open;
}

void join_at_signs(std::vector<Held>& lines) {
    std::stable_sort(lines.begin(), lines.end(),
                     [](const Held& a, const Held& b) { return reach_of(a.read.line).first < reach_of(b.read.line).first; });
    for (std::size_t i = 0; i < lines.size(); ++i)
        for (bool more = true; more;) {
            const auto next = std::find_if(lines.begin() + static_cast<std::ptrdiff_t>(i) + 1, lines.end(),
                                           [&](const Held& other) { return go_together(lines[i], other); });
            more = next != lines.end();
            if (!more) break;
            put_together(lines[i], *next);
            lines.erase(next);
        }
    // A sign that is left alone is none, or is not known to be one.
    for (Held& one : lines)
        if (is_sign(one.form.text) || (one.form.text.starts_with("\u00b0") && !is_degrees(one.form.text)) ||
            is_pale_minus(one.form.text))
            one.read.words.sure = false;
}

}  // namespace

PrintedWords print_of(const Image& grey, const LetteringLine& line) {
    constexpr int kHalo = 2;  // pixels; JPEG spreads letters over two
    PrintedWords words;
    words.upwards = line.upwards;
    words.letter_height = line.letter_height;
    words.level = line.level;
    words.light = line.light;
    words.box = line.box;
    const PixelBox wide{std::max(0, line.box.left - kHalo), std::max(0, line.box.top - kHalo),
                        std::min(grey.width, line.box.right + kHalo), std::min(grey.height, line.box.bottom + kHalo)};
    constexpr std::uint8_t kNear = 1, kOwn = 2;
    Image own = make_image(wide.width(), wide.height(), 1, 0, 0);
    for (const auto* pieces : {&line.letters, &line.marks, &line.raised})
        for (const InkPiece& piece : *pieces)
            for (const InkRun& run : piece.runs)
                for (int y = std::max(wide.top, run.y - kHalo); y <= std::min(wide.bottom - 1, run.y + kHalo); ++y)
                    for (int x = std::max(wide.left, run.left - kHalo); x < std::min(wide.right, run.right + kHalo); ++x) {
                        std::uint8_t& pixel = own.row(y - wide.top)[x - wide.left];
                        pixel = std::max(pixel, y == run.y && x >= run.left && x < run.right ? kOwn : kNear);
                    }
    for (int y = wide.top; y < wide.bottom; ++y)
        for (int x = wide.left; x < wide.right;) {
            const auto goes = [&](int at) {
                const std::uint8_t mark = own.row(y - wide.top)[at - wide.left];
                return mark == kOwn || (mark == kNear && (grey.row(y)[at] < line.level) == line.light);
            };
            const int left = x;
            while (x < wide.right && goes(x)) ++x;
            if (x > left)
                words.ink.push_back({y, left, x});
            else
                ++x;
        }
    return words;
}

namespace {

// Its ink; if it has more pieces than letters, thin strokes may be too pale, and it is joined by them where that helps.
InkStrip with_thin_strokes(const Image& grey, ReadLine& one) {
    constexpr std::size_t kOfOne = 4;
    InkStrip strip(grey, one.line);
    const std::string& text = one.words.text;
    const std::size_t pieces = strip.units(),
                      letters = letters_in(text) - static_cast<std::size_t>(std::count(text.begin(), text.end(), ' '));
    const bool halves = !one.alike && pieces > 1 && pieces <= kOfOne;  // of a 0, read as "()"
    if (!halves && (!one.alike || pieces <= letters)) return strip;
    LetteringLine whole = joined_by_pale_ink(grey, one.line);
    InkStrip joined(grey, whole);
    const std::size_t units = joined.units();
    if (halves ? units > 1 : std::max(units, letters) - std::min(units, letters) >= pieces - letters) return strip;
    one.line = std::move(whole);
    if (halves) one.words.text.clear();
    const PrintedWords print = print_of(grey, one.line);
    one.words.ink = print.ink;
    one.words.box = print.box;
    return joined;
}

}  // namespace

bool hold_against_fonts(const Image& grey, std::vector<ReadLine>& lines, std::vector<LetteringLine> climbing,
                        const PrintFonts& fonts) {
    std::vector<InkStrip> strips;
    std::vector<OtherReading> others;
    for (ReadLine& one : lines) {
        strips.push_back(with_thin_strokes(grey, one));
        others.push_back({one.words.text, one.alike});
    }
    for (const LetteringLine& line : climbing) strips.emplace_back(grey, line);
    others.resize(strips.size());
    std::vector<FormWords> read = read_in_fonts(strips, others, fonts);
    const auto drop_freed = [&] { std::erase_if(lines, [](const ReadLine& one) { return one.freed.has_value(); }); };
    if (read.size() < strips.size()) {
        drop_freed();
        return false;
    }
    if (std::none_of(read.begin(), read.end(), [](const FormWords& one) { return one.font >= 0; })) {
        for (std::size_t i = 0; i < lines.size(); ++i) {
            ReadLine& one = lines[i];
            if (read[i].strange)
                one = held(grey, std::move(one), std::move(read[i])).read;
            else
                doubt(grey, one);
        }
        drop_freed();
        return true;
    }
    std::vector<Held> upright, turned;
    for (std::size_t i = 0; i < lines.size(); ++i) upright.push_back(held(grey, std::move(lines[i]), std::move(read[i])));
    for (std::size_t i = 0; i < climbing.size(); ++i) {
        ReadLine line{std::move(climbing[i]), {}};
        line.words = print_of(grey, line.line);
        turned.push_back(held(grey, std::move(line), std::move(read[lines.size() + i])));
    }
    keep_freed(upright);
    add_climbing(upright, std::move(turned));
    join_at_signs(upright);
    lines.clear();
    for (Held& one : upright) lines.push_back(std::move(one.read));
    return true;
}

}  // namespace tactics
