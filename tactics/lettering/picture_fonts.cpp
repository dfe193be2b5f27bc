// SPDX-License-Identifier: Apache-2.0
#include "tactics/lettering/picture_fonts.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tactics/lettering/meant_letters.h"
#include "tactics/lettering/strange_print.h"
#include "tactics/text/formula_letters.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

// Settings: the largest number of fonts in a picture; how well a font must match the known words; how much better a further font
// must match some of them.
constexpr std::size_t kMostFonts = 4, kMostSamples = 12;
constexpr double kLeastFit = 0.76, kBetter = 0.04, kFitsAlone = 0.92;
constexpr double kFitsBoth = 0.8, kLeastOfBoth = 0.7;  // of words that two readers say
constexpr double kLeastLone = 0.86;                    // of a letter of a font that is chosen by its looks
constexpr double kSameSize = 0.06;                     // of an em
// Letters of one size that tell a font where no word does: so many that fit by themselves, or more that fit less well.
constexpr std::size_t kLeast = 3, kMany = 4;
constexpr double kFitsWithMany = 0.85;

constexpr std::string_view kPlainLetters =
    "0 1 2 3 4 5 6 7 8 9 A B C D E F G H I J K L M N O P Q R S T U V W X Y Z a b c d e f g h i j k l m n o p q r s t u v w x y z "
    "- \u2212";

bool is_of_size(double em, double other) { return std::abs(em - other) <= kSameSize * other; }

bool is_read_well(const FormWords& words) {
    return words.font >= 0 && words.settled && !words.text.empty() && !words.reading.either &&
           words.reading.mean >= kFitsWithMany;
}

bool is_telling(const FormLetter& letter) {
    return letter.code < 0x80 && letter.alike.empty() &&
           (is_digit(letter.code) || is_lower(letter.code) || is_upper(letter.code)) && !may_be_drawn(letter.code);
}

bool tells(const FormReading& reading) {
    return std::all_of(reading.letters.begin(), reading.letters.end(),
                       [](const FormLetter& letter) { return is_telling(letter) || is_minus(letter.code); });
}

// False: they are there already.
bool add_telling(const FormReading& reading, std::set<char32_t>& letters) {
    const std::size_t before = letters.size();
    for (const FormLetter& letter : reading.letters)
        if (is_telling(letter)) letters.insert(letter.code);
    return letters.size() > before;
}

bool are_as_wide(const FontShapes& one, const FontShapes& other) {
    return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                      [](const auto& a, const auto& b) { return a.first == b.first && a.second.advance == b.second.advance; });
}

bool is_without_doubt(const FormReading& reading) {
    return !reading.text.empty() && reading.mean >= kFitsAlone && reading.least >= kLeastLone;
}

bool says_letters(std::string_view text) {
    constexpr std::ptrdiff_t kLetters = 3;
    return std::count_if(text.begin(), text.end(), [](unsigned char c) { return is_lower(c) || is_upper(c); }) >= kLetters;
}

// What it may say: of "SO" another font would be told than of "S0".
std::vector<std::string> texts_of(const std::string& text) {
    constexpr std::size_t kShort = 3;
    std::vector<std::string> texts{text};
    const bool small = std::any_of(text.begin(), text.end(), [](unsigned char c) { return is_lower(c); });
    if (small || text.size() > kShort || text.find('O') == text.npos) return texts;
    texts.push_back(text);
    std::replace(texts.back().begin(), texts.back().end(), 'O', '0');
    return texts;
}

void keep_gaps(FormWords& words, const std::string& other) {
    if (const auto text = with_its_gaps(words.reading, words.text, with_letters(other, words.reading)))
        words.text = *text;
    else
        words.settled = false;
}

}  // namespace

bool PictureFonts::choose(const PrintFonts& fonts) {
    fonts(letters_asked_for(), [&](PrintFont font) {
        base_.push_back(fonts_.size());
        std::function<FontShapes()> more;
        if (font.more) more = [all = std::move(font.more)] { return all(letters_of_figures()); };
        fonts_.emplace_back(std::move(font.shapes), std::move(more));
        bent_.push_back(std::move(font.bent));
        formulas_.push_back(std::move(font.formula));
        return true;
    });
    std::vector<std::size_t> lines;
    for (std::size_t i = 0; i < strips_.size(); ++i)
        if (others_[i].alike && strips_[i].units() > 1) lines.push_back(i);
    sizes_.resize(fonts_.size());
    widths_.resize(fonts_.size());
    choose_by_words(lines);
    if (chosen_.empty()) choose_by_looks();
    return !fonts_.empty();
}

FormWords PictureFonts::read(std::size_t line) {
    FormWords best;
    for (const std::size_t font : chosen_) {
        FormReading reading = read_by_forms(strips_[line], fonts_[font], sizes_[base_[font]], others_[line].text);
        if (reading.letters.empty() || (best.font >= 0 && reading.value <= best.reading.value)) continue;
        best.reading = std::move(reading);
        best.font = static_cast<int>(font);
    }
    if (best.font < 0) return best;
    const std::size_t font = std::exchange(best.font, static_cast<int>(base_[static_cast<std::size_t>(best.font)]));
    if (best.reading.text.empty()) return best;
    settle(best, others_[line]);
    best.text = text_of(best.reading, fonts_[font]);
    best.thin = has_thin_spaces(best.reading, fonts_[font]);
    const std::string& other = others_[line].text;
    best.agreed = others_[line].alike && (same_letters(best.text, other) || same_but_for_signs(best.text, other));
    if (best.agreed && best.text != other && best.reading.mean < kFitsAlone) keep_gaps(best, other);
    return best;
}

void PictureFonts::bear_out_in_any(std::size_t line, FormWords& words) {
    const OtherReading& other = others_[line];
    const bool fits = words.reading.mean >= kFitsBoth && words.reading.least >= kLeastOfBoth;
    // Small print of a known font has its own rules.
    if (!other.alike || (words.agreed && ((words.settled && fits) || words.reading.em < kSmallPrint))) return;
    const auto reading = bear_out(strips_[line], other.text, all_fonts());
    if (reading && (words.text.empty() || same_letters(words.text, other.text) || reading->mean > words.reading.mean)) {
        words.reading = *reading;
        settle(words, other);
        words.settled = words.settled && !reading->text.empty();
        words.text = with_letters(other.text, words.reading);
        words.sized = false;
        words.agreed = words.strange = true;
    }
}

bool PictureFonts::knows(const FormWords& words) const {
    const auto& sizes = sizes_[static_cast<std::size_t>(words.font)];
    const double em = words.reading.em;
    return std::any_of(sizes.begin(), sizes.end(), [&](double one) { return std::abs(one - em) <= kSameSize * em + 0.3; });
}

void PictureFonts::know(const FormWords& words) {
    const auto font = static_cast<std::size_t>(words.font);
    sizes_[font].push_back(words.reading.em);
    Widths widths{words.reading.em};
    for (const FormLetter& letter : words.reading.letters) {
        const LetterForm& form = fonts_[font].form(letter.code);
        if (form.empty() || letter.touches || letter.slanted || letter.place != FormLetter::Place::on_line) continue;
        widths.is += letter.box.width();
        widths.of += form.width();
    }
    if (widths.of > 0) widths_[font].push_back(widths);
}

// Letters are bent upwards and downwards only, so that their widths tell which size they have.
void PictureFonts::bend() {
    constexpr double kMostBent = 20, kOneSize = 0.05;  // pixels for an em; of that
    const std::vector<std::size_t> chosen = chosen_;
    for (const std::size_t font : chosen) {
        if (base_[font] != font || !bent_[font]) continue;
        std::vector<Widths> lines = widths_[font];
        std::sort(lines.begin(), lines.end(), [](const Widths& a, const Widths& b) { return a.em < b.em; });
        for (std::size_t i = 0, end = 0; i < lines.size() && lines[i].em < kMostBent; i = end) {
            Widths all{0};
            for (; end < lines.size() && lines[end].em <= (1 + kOneSize) * lines[i].em; ++end) {
                all.is += lines[end].is;
                all.of += lines[end].of;
            }
            add_bent(font, all.is / all.of);
        }
    }
}

bool PictureFonts::add_formulas() {
    const std::vector<std::size_t> chosen = chosen_;
    for (const std::size_t font : chosen)
        if (base_[font] == font && formulas_[font])
            add(font, with_slanted(font, std::exchange(formulas_[font], {})(letters_of_figures())));
    return chosen_.size() > chosen.size();
}

void PictureFonts::know_by_company(const std::vector<FormWords>& words) {
    for (const FormWords& one : words) {
        if (one.sized || !is_read_well(one)) continue;
        std::set<char32_t> letters;
        for (const FormWords& other : words)
            if (other.font == one.font && is_read_well(other) && is_of_size(other.reading.em, one.reading.em))
                add_telling(other.reading, letters);
        if (letters.size() >= kMany) know(one);
    }
}

bool PictureFonts::choose_by_letters(const std::vector<std::size_t>& lines) {
    const std::vector<std::size_t> samples = samples_of(lines);
    if (samples.size() < kLeast) return false;
    struct Choice {
        double sum = 0, size = 0;
        std::size_t font = 0;
        FontShapes formula;  // if these are the letters that tell it
    } best;
    const auto look = [&](std::size_t f, FormFont& font, const FontShapes& formula) {
        const auto [sum, size] = size_told_by(samples, font);
        if (sum > best.sum) best = {sum, size, f, formula};
    };
    // Where words tell fonts, numbers are in one of these, or one like them.
    constexpr std::size_t kLikeThose = 12;
    const bool told = !chosen_.empty();
    for (std::size_t i = 0; i < by_fit_.size() && (!told || i < kLikeThose); ++i) look(by_fit_[i], fonts_[by_fit_[i]], {});
    for (std::size_t f = by_fit_.size(); f < fonts_.size(); ++f) look(f, fonts_[f], {});
    FontShapes last;  // fonts of one family have the same letters for formulas, one after the other
    for (std::size_t f = 0; f < formulas_.size(); ++f) {
        const FontShapes shapes = formulas_[f] ? formulas_[f](letters_of_figures()) : FontShapes{};
        if (shapes.empty() || are_as_wide(shapes, last)) continue;
        FormFont font{FontShapes(shapes)};
        look(f, font, shapes);
        last = shapes;
    }
    if (!(best.sum > 0)) return false;
    if (std::find(chosen_.begin(), chosen_.end(), best.font) == chosen_.end()) chosen_.push_back(best.font);
    if (!best.formula.empty()) {
        formulas_[best.font] = {};
        add(best.font, std::move(best.formula));
    }
    sizes_[base_[best.font]].push_back(best.size);
    widths_[base_[best.font]].push_back({best.size, best.size, 1});
    return true;
}

bool PictureFonts::choose_by_formulas() {
    if (!chosen_.empty()) return false;
    const std::vector<std::size_t> lines = telling_lines([&](std::size_t i) { return says_letters(others_[i].text); });
    for (std::size_t f = 0; f < formulas_.size() && !lines.empty(); ++f) {
        FontShapes shapes = formulas_[f] ? with_slanted(f, formulas_[f](letters_of_figures())) : FontShapes{};
        if (shapes.empty()) continue;
        FormFont font{FontShapes(shapes)};
        for (const std::size_t i : lines) {
            const FormReading reading = read_by_forms(strips_[i], font, {}, others_[i].text);
            if (!is_without_doubt(reading)) continue;
            chosen_.push_back(f);
            formulas_[f] = {};
            add(f, std::move(shapes));
            sizes_[f].push_back(reading.em);
            return true;
        }
    }
    return false;
}

std::pair<double, double> PictureFonts::size_told_by(const std::vector<std::size_t>& samples, FormFont& font) const {
    std::vector<FormReading> readings;
    for (const std::size_t i : samples) {
        FormReading reading = read_by_forms(strips_[i], font, {}, kPlainLetters, true);
        if (!reading.text.empty() && reading.mean >= kFitsWithMany && tells(reading)) readings.push_back(std::move(reading));
    }
    std::pair<double, double> best{0, 0};
    for (const FormReading& one : readings) {
        std::set<char32_t> letters, fitting;
        double sum = 0;
        for (const FormReading& other : readings) {
            if (!is_of_size(other.em, one.em)) continue;
            if (other.mean >= kFitsAlone) add_telling(other, fitting);
            if (add_telling(other, letters)) sum += other.value;
        }
        if ((fitting.size() >= kLeast || letters.size() >= kMany) && sum > best.first) best = {sum, one.em};
    }
    return best;
}

std::string PictureFonts::figure_like(std::size_t line) {
    constexpr double kLeastLike = 0.6, kOffWidth = 0.2;  // settings; of its height
    constexpr std::size_t kLikelyFonts = 24;
    const InkBox box = strips_[line].measure(0, 0);
    LetterInk ink(strips_[line], 0, 0, box);
    double best = kLeastLike;
    std::string figure;
    for (std::size_t f = 0; f < std::min(kLikelyFonts, by_fit_.size()); ++f)
        for (char32_t code = '0'; code <= '9'; ++code) {
            FormFont& font = fonts_[by_fit_[f]];
            const LetterForm& form = font.form(code);
            if (form.empty() || std::abs(box.width() / box.height() - form.width() / form.height()) > kOffWidth) continue;
            const double likeness = ink.likeness(font.drawn(code), best);
            if (likeness <= best) continue;
            best = likeness;
            figure = static_cast<char>(code);
        }
    return figure;
}

std::vector<char32_t> PictureFonts::letters_asked_for() const {
    std::set<char32_t> letters;
    for (const char figure : std::string_view("0123456789")) letters.insert(static_cast<unsigned char>(figure));
    for (const std::u32string_view pair : kLikeOne) letters.insert(pair.begin(), pair.end());
    for (const OtherReading& other : others_)
        for (std::string_view rest = other.text; !rest.empty();) letters.insert(take_letter(rest));
    return {letters.begin(), letters.end()};
}

std::vector<FormFont*> PictureFonts::all_fonts() {
    std::vector<FormFont*> fonts;
    for (const std::size_t f : by_fit_) fonts.push_back(&fonts_[f]);
    return fonts;
}

void PictureFonts::add_bent(std::size_t font, double em) {
    em = std::round(10 * em) / 10;
    if (!bends_.insert({font, em}).second) return;
    add(font, bent_[font](letters_of_figures(), em));
}

FontShapes PictureFonts::with_slanted(std::size_t font, const FontShapes& formula) {
    if (formula.empty()) return {};
    FontShapes all = fonts_[font].shapes();
    for (const auto& [code, shape] : formula)
        if (slanted(code) != code) all[slanted(code)] = shape;
    return all;
}

void PictureFonts::add(std::size_t font, FontShapes shapes) {
    if (shapes.empty()) return;
    chosen_.push_back(fonts_.size());
    base_.push_back(font);
    fonts_.emplace_back(std::move(shapes));
}

void PictureFonts::choose_by_words(const std::vector<std::size_t>& lines) {
    std::vector<double> weight(fonts_.size(), 0);
    std::vector<std::vector<double>> fit(fonts_.size(), std::vector<double>(lines.size(), 0));
    for (std::size_t f = 0; f < fonts_.size(); ++f)
        for (std::size_t i = 0; i < lines.size(); ++i) {
            double em = 0;
            for (const std::string& text : texts_of(others_[lines[i]].text))
                fit[f][i] = std::max(fit[f][i], likeness_to(strips_[lines[i]], fonts_[f], text, em));
            weight[f] += fit[f][i] * static_cast<double>(strips_[lines[i]].units());
        }
    by_fit_.resize(fonts_.size());
    std::iota(by_fit_.begin(), by_fit_.end(), std::size_t{0});
    std::stable_sort(by_fit_.begin(), by_fit_.end(), [&](std::size_t a, std::size_t b) { return weight[a] > weight[b]; });
    std::vector<double> best(lines.size(), 0);
    while (chosen_.size() < kMostFonts) {
        double most = 0;
        std::size_t next = 0;
        for (std::size_t f = 0; f < fonts_.size(); ++f) {
            double gain = 0;
            for (std::size_t i = 0; i < lines.size(); ++i)
                if (fit[f][i] >= kLeastFit && fit[f][i] >= best[i] + kBetter)
                    gain += (fit[f][i] - best[i]) * static_cast<double>(strips_[lines[i]].units());
            if (gain > most) {
                most = gain;
                next = f;
            }
        }
        if (!(most > 0)) return;
        chosen_.push_back(next);
        for (std::size_t i = 0; i < lines.size(); ++i) best[i] = std::max(best[i], fit[next][i]);
    }
}

void PictureFonts::choose_by_looks() {
    const std::vector<std::size_t> lines = telling_lines([&](std::size_t i) { return others_[i].alike; });
    for (std::size_t f = 0; f < fonts_.size() && !lines.empty(); ++f)
        for (const std::size_t i : lines)
            if (is_without_doubt(read_by_forms(strips_[i], fonts_[f], {}))) {
                chosen_.push_back(f);
                return;
            }
}

std::vector<std::size_t> PictureFonts::samples_of(const std::vector<std::size_t>& lines) const {
    constexpr double kSameHeight = 0.12, kWidest = 2.5;  // of a height
    constexpr double kSameWidth = 0.03, kSameInk = 0.015;
    struct Look {
        double height;
        std::size_t line;
        double width, ink;  // of the height; of the box
        bool is_like(const Look& other) const {
            return std::abs(other.width - width) < kSameWidth && std::abs(other.ink - ink) < kSameInk;
        }
    };
    std::vector<Look> looks;
    for (const std::size_t i : lines) {
        const InkBox box = strips_[i].measure(0, strips_[i].units() - 1);
        if (strips_[i].is_stroke()) continue;
        if (box.height() > 6 && box.width() < kWidest * box.height() && box.height() < 6 * box.width())
            looks.push_back({box.height(), i, box.width() / box.height(), strips_[i].ink() / (box.width() * box.height())});
    }
    std::sort(looks.begin(), looks.end(),
              [](const Look& a, const Look& b) { return std::pair(a.height, a.line) < std::pair(b.height, b.line); });
    std::vector<Look> best;
    for (std::size_t i = 0; i < looks.size(); ++i) {
        std::vector<Look> samples;
        for (std::size_t k = i; k < looks.size() && looks[k].height <= (1 + kSameHeight) * looks[i].height; ++k) {
            const bool known =
                std::any_of(samples.begin(), samples.end(), [&](const Look& one) { return one.is_like(looks[k]); });
            if (!known && samples.size() < kMostSamples) samples.push_back(looks[k]);
        }
        if (samples.size() > best.size()) best = std::move(samples);
    }
    std::vector<std::size_t> found;
    for (const Look& one : best) found.push_back(one.line);
    return found;
}

}  // namespace tactics
