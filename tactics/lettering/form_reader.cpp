// SPDX-License-Identifier: Apache-2.0
#include "tactics/lettering/form_reader.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "tactics/lettering/alike_letters.h"
#include "tactics/lettering/veiled_letter.h"
#include "tactics/lettering/weighed_groups.h"
#include "tactics/text/formula_letters.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

// Settings. Similarity: of a possible letter, of one of a size that is known, and of one that determines the size of the others.
constexpr double kMayBe = 0.6, kIsOfKnown = 0.7, kTells = 0.8;
constexpr double kAsAlike = 0.03;     // what is less likely than another by no more may be either
constexpr double kAsPair = 0.06;      // the same of two letters that touch
constexpr double kAccent = 0.12;      // in small print a letter with an accent and one without hardly differ
constexpr double kKnownBonus = 1.03;  // of the value in a size that other words have
constexpr double kNeutral = 0.5;      // likeness that speaks neither for nor against a letter
constexpr double kOffLine = 0.05;     // by so much must a raised letter be more likely than one on the line
constexpr double kLow = 0.65;         // of the height of a line: an underscore begins below
constexpr double kHighEnough = 14;    // pixels of a line that has lowered figures
constexpr double kOffPixels = 1.3;    // a point of less than a pixel lies on two
constexpr std::size_t kMostSizes = 6, kMostFeet = 5, kMostUnits = 120, kMostLetterPieces = 4;
constexpr std::size_t kMostVeiled = 4;  // of a line that can be read

// Pieces side by side that may be one letter.
constexpr std::u32string_view kWide = U"%\u2030\u00bd\u00bc\u00be\"\u201c\u201d\u2033\u2026";

bool may_be_off_line(char32_t code) {
    return is_digit(code) || is_minus(code) || code == '+' || (code >= 'a' && code <= 'z') || (code >= 'A' && code <= 'Z');
}

struct Choice {
    char32_t code;  // of the plain letter
    bool slanted;
    double likeness;
    double size;  // pixels for an em
    const LetterForm* form;
};

// Neighbouring units as one letter.
struct Span {
    InkBox box;
    std::vector<Choice> choices;  // the likeliest first
};

// Where letters stand, and how large.
struct Rule {
    double em, foot;
};

class Reader {
public:
    // `only_guessed`: no letter is looked for but those.
    Reader(const InkStrip& strip, FormFont& font, std::string_view guess, bool only_guessed)
        : strip_(strip), font_(font), count_(strip.units()), only_guessed_(only_guessed) {
        if (!guess.empty()) join_letters(guess);
        for (const std::u32string_view pair : kLikeOne)
            if (const char32_t code = font_.join(pair); code != 0) pairs_.push_back(code);
        for (std::size_t length = 1; length <= kMostLetterPieces; ++length)
            for (std::size_t i = 0; i < count_; ++i) {
                spans_.emplace_back();
                if (i + 1 >= length) look(i + 1 - length, i, spans_.back());
            }
    }

    FormReading run(const std::vector<double>& known) {
        const auto is_known = [&](double em) {
            return std::any_of(known.begin(), known.end(), [&](double one) { return std::abs(one - em) < 0.05 * one; });
        };
        FormReading best, second;
        for (const double em : strip_.has_veil() ? apart(sizes(known), is_known) : sizes(known)) {
            for (const double foot : feet(em)) {
                if (strip_.has_veil() && !is_readable({em, foot})) continue;
                FormReading reading = read_at({em, foot});
                if (is_known(em)) reading.value *= kKnownBonus;
                const bool better = reading.value > best.value;
                if (better) std::swap(reading, best);
                if (differs(reading, best) && reading.value > second.value) second = std::move(reading);
            }
        }
        const bool decided = is_known(best.em) && !is_known(second.em);
        const bool near = second.value > 0.96 * best.value || is_letter_in_two_sizes(best, second);
        best.either = !decided && near && differs(second, best);
        return best;
    }

private:
    // Those that are known, once each: what is hidden takes long to find.
    template <typename Is>
    static std::vector<double> apart(const std::vector<double>& sizes, Is is_known) {
        std::vector<double> found;
        for (const double em : sizes) {
            const auto is_again = [&](double one) { return std::abs(one - em) < 0.02 * em; };
            if (is_known(em) && std::none_of(found.begin(), found.end(), is_again)) found.push_back(em);
        }
        return found;
    }

    static bool differs(const FormReading& a, const FormReading& b) {
        return a.text != b.text && std::abs(a.em - b.em) > 0.1 * b.em;
    }

    // Alone, a c is more like a C than pixels tell.
    static bool is_letter_in_two_sizes(const FormReading& a, const FormReading& b) {
        return a.letters.size() == 1 && b.letters.size() == 1 && is_same_in_two_sizes(a.letters[0].code, b.letters[0].code);
    }

    const Span& span(std::size_t first, std::size_t last) const { return spans_[(last - first) * count_ + last]; }

    void look(std::size_t first, std::size_t last, Span& span) {
        span.box = strip_.measure(first, last);
        ink_.reset();
        if (strip_.veiled(first, last)) return;
        if (first == last)
            look_at_one(first, span);
        else if (span.box.width() < 2.5 * span.box.height()) {
            if (!only_guessed_ && strip_.tied(first, last))
                for (const auto& [code, shape] : font_.shapes()) add(code, first, last, span);
            else if (!only_guessed_ && last - first < 3)
                for (const char32_t code : kWide) add(code, first, last, span);
            for (const char32_t code : guessed_) add(code, first, last, span);
        }
        std::stable_sort(span.choices.begin(), span.choices.end(),
                         [](const Choice& a, const Choice& b) { return a.likeness > b.likeness; });
    }

    void look_at_one(std::size_t unit, Span& span) {
        if (only_guessed_)
            for (const char32_t code : guessed_) add(code, unit, unit, span);
        else
            for (const auto& [code, shape] : font_.shapes())
                if (may_be_here(code, span.box)) add(code, unit, unit, span);
        for (const char32_t code : joined_) add(code, unit, unit, span);
        for (const char32_t code : pairs_)
            if (std::find(joined_.begin(), joined_.end(), code) == joined_.end()) add(code, unit, unit, span);
    }

    // A hyphen of another size is no underscore. A lowered figure follows something, and in few pixels looks like what stands on
    // the line.
    bool may_be_here(char32_t code, const InkBox& box) const {
        if (code == '_') return lies_low(box);
        return !is_lowered_figure(code) || (count_ > 1 && strip_.measure(0, count_ - 1).height() >= kHighEnough);
    }

    bool lies_low(const InkBox& box) const {
        const InkBox line = strip_.measure(0, count_ - 1);
        return box.top > line.top + kLow * line.height();
    }

    // Letters of a word that stand side by side may touch.
    void join_letters(std::string_view guess) {
        constexpr std::size_t kMostJoined = 5, kMostGuessed = 130;
        std::u32string letters;
        while (!guess.empty()) letters += take_letter(guess);
        if (letters.size() > kMostGuessed) return;
        guessed_.insert(letters.begin(), letters.end());
        guessed_.erase(U' ');
        if (count_ + 1 > letters.size()) return;
        std::set<char32_t> codes;
        for (std::size_t i = 0; i < letters.size(); ++i)
            for (std::size_t length = 2; length <= kMostJoined && i + length <= letters.size(); ++length) {
                const std::u32string part = letters.substr(i, length);
                if (part.find(U' ') != part.npos) break;
                if (const char32_t code = font_.join(part); code != 0) codes.insert(code);
            }
        joined_.assign(codes.begin(), codes.end());
    }

    void add(char32_t code, std::size_t first, std::size_t last, Span& span) {
        const InkBox& box = span.box;
        const LetterForm& form = font_.form(code);
        if (form.empty()) return;
        const bool upright = form.height() >= form.width();
        const double size = upright ? box.height() / form.height() : box.width() / form.width();
        const double small = upright ? box.width() : box.height(), wanted = size * (upright ? form.width() : form.height());
        if (std::abs(small - wanted) > kOffPixels + 0.08 * wanted) return;
        if (!ink_) ink_.emplace(strip_, first, last, box);
        const double likeness = ink_->likeness(font_.drawn(code), kMayBe);
        if (likeness >= kMayBe) span.choices.push_back({plain_code(code), plain_code(code) != code, likeness, size, &form});
    }

    // Those that most letters speak for.
    std::vector<double> sizes(const std::vector<double>& known) const {
        std::vector<std::pair<double, double>> votes;  // size, weight
        for (const Span& one : spans_)
            for (std::size_t k = 0; k < std::min<std::size_t>(one.choices.size(), 8); ++k)
                if (one.choices[k].likeness >= kTells)
                    votes.push_back({one.choices[k].size, one.choices[k].likeness * std::max(one.box.width(), one.box.height())});
        std::vector<double> found = heaviest_groups(votes, 0.05, 0, kMostSizes);
        for (const double one : known)
            if (may_be_of(one)) found.push_back(one);
        return found;
    }

    // Bent to few pixels, a letter may be less than certain of itself; of a size that other words have it counts all the same.
    bool may_be_of(double em) const {
        for (const Span& one : spans_)
            for (const Choice& choice : one.choices)
                if (choice.likeness >= kIsOfKnown && has_size(choice, em)) return true;
        return false;
    }

    std::vector<double> feet(double em) const {
        std::vector<std::pair<double, double>> votes;
        for (const Span& one : spans_)
            for (const Choice& choice : one.choices)
                if (choice.likeness >= kIsOfKnown && has_size(choice, em))
                    votes.push_back({foot_of(one.box, choice, em), choice.likeness * one.box.width()});
        return heaviest_groups(votes, 0, 0.7, kMostFeet);
    }

    // Letters that are bent to pixels are larger or smaller by a part of one.
    static bool has_size(const Choice& choice, double em) {
        const double whole = std::max(choice.form->width(), choice.form->height()) * em;
        return std::abs(choice.size - em) / em * whole <= 0.9 + 0.03 * whole;
    }
    static double foot_of(const InkBox& box, const Choice& choice, double em) { return box.bottom + choice.form->bottom() * em; }

    std::optional<FormLetter::Place> place_of(const InkBox& box, const Choice& choice, const Rule& rule) const {
        const double off = foot_of(box, choice, rule.em) - rule.foot;
        if (has_size(choice, rule.em) && std::abs(off) <= 0.8 + 0.02 * rule.em) return FormLetter::Place::on_line;
        const double ratio = choice.size / rule.em;
        if (ratio < 0.5 || ratio > 0.87 || !may_be_off_line(choice.code)) return std::nullopt;
        const double foot = foot_of(box, choice, choice.size) - rule.foot;
        if (foot < -0.2 * rule.em && foot > -0.7 * rule.em) return FormLetter::Place::raised;
        if (is_minus(choice.code)) return std::nullopt;  // it would be a point
        if (foot > 0.08 * rule.em && foot < 0.4 * rule.em) return FormLetter::Place::lowered;
        return std::nullopt;
    }

    // What is raised or lowered follows something: figures of an axis with a larger em and a lower foot would be such.
    bool may_be_at(std::size_t unit, const FormLetter::Place place, char32_t code) const {
        return unit > 0 || (place == FormLetter::Place::on_line && !is_raised_figure(code));
    }

    FormLetter letter_of(std::size_t first, std::size_t last, const Rule& rule) const {
        if (strip_.veiled(first, last) && (first == last || strip_.tied(first, last)))
            return veiled_letter(strip_, first, last, font_, rule.em, rule.foot);
        const Span& one = span(first, last);
        FormLetter letter;
        letter.box = one.box;
        double best = 0;
        for (const Choice& choice : one.choices) {
            const auto place = place_of(one.box, choice, rule);
            if (!place || !may_be_at(first, *place, choice.code)) continue;
            const double worth = choice.likeness - (*place == FormLetter::Place::on_line ? 0 : kOffLine);
            if (worth > best) {
                best = worth;
                letter.code = choice.code;
                letter.slanted = choice.slanted;
                letter.likeness = choice.likeness;
                letter.place = *place;
            }
        }
        for (const Choice& choice : one.choices) {
            const bool thin = rule.em < kSmallPrint && is_thin(letter.code) && is_thin(choice.code);
            const bool sizes = rule.em < kSmallPrint && is_same_in_two_sizes(letter.code, choice.code);
            const double off = thin || sizes || (is_accented(letter.code) && choice.code < 0x80) ? kAccent : kAsAlike;
            const auto place = place_of(one.box, choice, rule);
            if (choice.code == letter.code || !place || !may_be_at(first, *place, choice.code)) continue;
            letter.pair = letter.pair || (rule.em < kSmallPrint && choice.likeness >= letter.likeness - kAsPair &&
                                          !font_.joined(choice.code).empty() && font_.joined(letter.code).empty());
            if (choice.likeness >= letter.likeness - off)
                letter.alike.push_back(choice.code);
            else if (!is_accented(choice.code))
                letter.margin = std::min(letter.margin, letter.likeness - choice.likeness);
        }
        return letter;
    }

    // What is seen whole is of letters. Those that are hidden in part take long to find.
    bool is_readable(const Rule& rule) const {
        std::vector<bool> read(count_, false);
        for (std::size_t length = 1; length <= kMostLetterPieces; ++length)
            for (std::size_t last = length - 1; last < count_; ++last) {
                const std::size_t first = last + 1 - length;
                const bool veiled = strip_.veiled(first, last);
                if (veiled ? length == 1 : letter_of(first, last, rule).code != 0)
                    std::fill(read.begin() + static_cast<std::ptrdiff_t>(first),
                              read.begin() + static_cast<std::ptrdiff_t>(last) + 1, true);
            }
        return std::find(read.begin(), read.end(), false) == read.end();
    }

    static double worth(const FormLetter& letter) {
        if (letter.code == 0) return -0.1 * letter.box.width();
        const double off = letter.place == FormLetter::Place::on_line ? 0 : kOffLine;
        return letter.box.width() * (letter.likeness - off - kNeutral);
    }

    // The best way to part the units into letters.
    FormReading read_at(const Rule& rule) const {
        std::vector<double> best(count_ + 1, 0);
        std::vector<std::size_t> lengths(count_ + 1, 1);
        std::vector<FormLetter> last(count_ + 1);
        for (std::size_t end = 1; end <= count_; ++end) {
            for (std::size_t length = 1; length <= std::min(end, kMostLetterPieces); ++length) {
                FormLetter letter = letter_of(end - length, end - 1, rule);
                if (length > 1 && letter.code == 0) continue;
                const double value = best[end - length] + worth(letter);
                if (length > 1 && value <= best[end]) continue;
                best[end] = value;
                lengths[end] = length;
                last[end] = std::move(letter);
            }
        }
        FormReading reading;
        reading.em = rule.em;
        reading.foot = rule.foot;
        reading.value = best[count_];
        for (std::size_t end = count_; end > 0; end -= lengths[end]) reading.letters.push_back(std::move(last[end]));
        std::reverse(reading.letters.begin(), reading.letters.end());
        take_apart(reading.letters);
        finish(reading);
        return reading;
    }

    // Letters that were found as one become letters.
    void take_apart(std::vector<FormLetter>& letters) const {
        std::vector<FormLetter> all;
        for (FormLetter& letter : letters) {
            const std::u32string_view parts = font_.joined(letter.code);
            if (parts.empty()) {
                std::erase_if(letter.alike, [&](char32_t code) { return !font_.joined(code).empty(); });
                all.push_back(std::move(letter));
                continue;
            }
            const LetterForm& whole = font_.form(letter.code);
            double start = 0;
            for (const char32_t code : parts) {
                const LetterForm& form = font_.form(code);
                FormLetter part = letter;
                part.code = code;
                part.touches = true;
                part.alike.clear();  // but for these, it was looked for as the guess has it
                if (code == 'I' || code == 'l') part.alike.push_back(code == 'I' ? U'l' : U'I');
                const auto at = [&](double x) {
                    return letter.box.left + (start + x - whole.left()) / whole.width() * letter.box.width();
                };
                part.box.left = at(form.left());
                part.box.right = at(form.right());
                all.push_back(std::move(part));
                start += form.advance();
            }
        }
        letters = std::move(all);
    }

    void finish(FormReading& reading) const {
        double width = 0;
        reading.least = reading.margin = 1;
        bool all = true;
        for (const FormLetter& letter : reading.letters) {
            reading.least = std::min(reading.least, letter.likeness);
            reading.margin = std::min(reading.margin, letter.margin);
            reading.pair = reading.pair || letter.pair;
            reading.mean += letter.likeness * letter.box.width();
            width += letter.box.width();
            all = all && letter.code != 0;
        }
        if (width > 0) reading.mean /= width;
        if (all) reading.text = text_of(reading, font_);
    }

    const InkStrip& strip_;
    FormFont& font_;
    std::size_t count_;
    bool only_guessed_;
    std::optional<LetterInk> ink_;  // of the span that is looked at
    std::set<char32_t> guessed_;    // their pieces may have come apart where strokes are thin
    std::vector<char32_t> joined_, pairs_;
    std::vector<Span> spans_;  // by length, then by their last unit
};

}  // namespace

FormReading read_by_forms(const InkStrip& strip, FormFont& font, const std::vector<double>& known, std::string_view guess,
                          bool only_guessed) {
    if (strip.units() == 0 || strip.units() > kMostUnits || strip.veiled_units() > kMostVeiled) return {};
    return Reader(strip, font, guess, only_guessed).run(known);
}

}  // namespace tactics
