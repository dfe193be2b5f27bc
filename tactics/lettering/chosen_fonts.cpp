// SPDX-License-Identifier: Apache-2.0
// Which fonts and sizes the print of a picture tells.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tactics/lettering/meant_letters.h"
#include "tactics/lettering/picture_fonts.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

// Settings: the largest number of fonts in a picture; how well a font must match the known words; how much better a further font
// must match some of them.
constexpr std::size_t kMostFonts = 4, kMostSamples = 12;
constexpr double kLeastFit = 0.76, kBetter = 0.04;
constexpr double kLeastLone = 0.86;  // of a letter of a font that is chosen by its looks
// Letters of one size that tell a font where no word does: so many that fit by themselves, or more that fit less well.
constexpr std::size_t kFewest = 2, kLeast = 3, kMany = 4;
constexpr double kFitsWithMany = 0.85;
// So many tell it, too, that fit so well and are of one size nearly to the pixel, in print that is large enough for that. Of a
// font that other print of the picture has, fewer tell a size: its formulas have small letters beside their arrows.
struct Witnesses {
    std::size_t letters;
    double fit;
    bool known_font;
};
constexpr Witnesses kWitnesses[] = {{3, 0.88, false}, {2, kFitsAlone, false}, {2, 0.86, true}};
constexpr double kOneSize = 0.03, kLeastOneSize = 18;  // of an em; pixels for an em

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

// Few letters that fit well.
bool bear_out_size(const std::vector<FormReading>& readings, double em, bool known_font) {
    const auto count = [&](double fit, double off) {
        std::set<char32_t> letters;
        for (const FormReading& one : readings)
            if (one.mean >= fit && std::abs(one.em - em) <= off * em) add_telling(one, letters);
        return letters.size();
    };
    if (count(kFitsAlone, kSameSize) >= kLeast) return true;
    return em >= kLeastOneSize && std::any_of(std::begin(kWitnesses), std::end(kWitnesses), [&](const Witnesses& of) {
               return (known_font || !of.known_font) && count(of.fit, kOneSize) >= of.letters;
           });
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
        if (others_[i].alike && strips_[i].units() > 1 && !strips_[i].has_veil()) lines.push_back(i);
    sizes_.resize(fonts_.size());
    widths_.resize(fonts_.size());
    choose_by_words(lines);
    if (chosen_.empty()) choose_by_looks();
    return !fonts_.empty();
}

void PictureFonts::choose_by_words(const std::vector<std::size_t>& lines) {
    std::vector<double> weight(fonts_.size(), 0);
    std::vector<std::vector<double>> fit(fonts_.size(), std::vector<double>(lines.size(), 0));
    std::vector<std::vector<std::string>> texts;
    for (const std::size_t line : lines) texts.push_back(texts_of(others_[line].text));
    for (std::size_t f = 0; f < fonts_.size(); ++f)
        for (std::size_t i = 0; i < lines.size(); ++i) {
            double em = 0;
            for (const std::string& text : texts[i])
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

bool PictureFonts::choose_by_letters(const std::vector<std::size_t>& lines) {
    const std::vector<std::size_t> samples = samples_of(lines);
    if (samples.size() < kFewest) return false;
    struct Choice {
        double sum = 0, size = 0;
        std::size_t font = 0;
        FontShapes formula;  // if these are the letters that tell it
    } best;
    const auto look = [&](std::size_t f, FormFont& font, const FontShapes& formula) {
        const bool known = std::find(chosen_.begin(), chosen_.end(), f) != chosen_.end();
        const auto [sum, size] = size_told_by(samples, font, known);
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

std::pair<double, double> PictureFonts::size_told_by(const std::vector<std::size_t>& samples, FormFont& font, bool known) const {
    std::vector<FormReading> readings;
    for (const std::size_t i : samples) {
        FormReading reading = read_by_forms(strips_[i], font, {}, kPlainLetters, true);
        if (!reading.text.empty() && reading.mean >= kFitsWithMany && tells(reading)) readings.push_back(std::move(reading));
    }
    std::pair<double, double> best{0, 0};
    for (const FormReading& one : readings) {
        std::set<char32_t> letters;
        double sum = 0;
        for (const FormReading& other : readings)
            if (is_of_size(other.em, one.em) && add_telling(other, letters)) sum += other.value;
        if (sum > best.first && (letters.size() >= kMany || bear_out_size(readings, one.em, known))) best = {sum, one.em};
    }
    return best;
}

std::vector<std::size_t> PictureFonts::samples_of(const std::vector<std::size_t>& lines) const {
    constexpr double kSameHeight = 0.12, kWidest = 2.5;  // of a height
    constexpr double kSameWidth = 0.03, kSameInk = 0.015;
    constexpr double kLowest = 0.55, kHighest = 1.8;  // an x of a b, and a b of an x
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
    // Of a drawing with few letters the small ones and the capitals tell their font together, among bits of what is drawn.
    const std::size_t most = chosen_.empty() ? 2 * kMostSamples : kMostSamples;
    if (!best.empty()) {
        const double height = best.front().height;
        for (const Look& one : looks)
            if (best.size() < most && one.height >= kLowest * height && one.height <= kHighest * height &&
                std::none_of(best.begin(), best.end(),
                             [&](const Look& other) { return one.line == other.line || one.is_like(other); }))
                best.push_back(one);
    }
    std::vector<std::size_t> found;
    for (const Look& one : best) found.push_back(one.line);
    return found;
}

}  // namespace tactics
