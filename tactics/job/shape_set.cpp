// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/shape_set.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tactics {

namespace {

// Settings. By how much sizes of letters of one font may differ.
constexpr double kSameSize = 0.01;
constexpr double kMostOfFont = 0.6;  // of its shapes, for a font to be it
constexpr double kNearFont = 0.35;   // for one to be looked at as programs bend it, which few are nearly without that
constexpr double kBent = 0.045;      // bent to pixels, a letter of 12 pixels is half a pixel off at most
// Bounds: of shapes by which a font is known, and of fonts that came near.
constexpr std::size_t kMostAsked = 60, kMostCandidates = 4;

// The possible letters of a shape in a font, if the font's em is that many of its units.
struct Match {
    std::size_t shape, letter;
    double em, apart;
};

bool is_share(std::size_t found, std::size_t inked, double share) {
    return found > 0 && static_cast<double>(found) >= share * static_cast<double>(inked);
}

double mean_em(const std::map<std::size_t, Match>& matches) {
    double sum = 0;
    for (const auto& [shape, match] : matches) sum += match.em;
    return sum / static_cast<double>(matches.size());
}

// Of the matches at nearly the same size the most shapes, each with its nearest letter.
std::map<std::size_t, Match> common_size(std::vector<Match>& all, double apart) {
    std::sort(all.begin(), all.end(), [](const Match& a, const Match& b) { return a.em < b.em; });
    std::map<std::size_t, Match> best;
    for (std::size_t from = 0; from < all.size(); ++from) {
        std::map<std::size_t, Match> here;
        for (std::size_t i = from; i < all.size() && all[i].em < all[from].em * (1 + apart); ++i) {
            const auto [place, fresh] = here.try_emplace(all[i].shape, all[i]);
            if (!fresh && all[i].apart < place->second.apart) place->second = all[i];
        }
        if (here.size() > best.size()) best = std::move(here);
    }
    return best;
}

}  // namespace

namespace {

// Corners of curves may lie beyond them, but the leftmost of most letters do not.
double left_of(const Letter& letter) {
    int left = 0;
    bool any = false;
    for (const OutlineStep& step : letter.outline) {
        const LetterCorner& end = step.corners[step.kind == OutlineStep::Kind::curve ? 2 : 0];
        left = any ? std::min(left, end.x) : end.x;
        any = true;
    }
    return left / 1000.0;
}

}  // namespace

std::vector<FontLetter> measured(const std::map<char32_t, Letter>& letters, const std::vector<char32_t>& order) {
    std::vector<FontLetter> out;
    for (const char32_t code : order)
        if (const auto found = letters.find(code); found != letters.end())
            if (auto outline = measure_letter(found->second); outline.area > 0)
                out.push_back({code, found->second.advance / 1000.0, left_of(found->second), outline});
    return out;
}

double em_of(const OutlineMeasure& shape, const FontLetter& letter) { return std::sqrt(shape.area / letter.outline.area); }

// An o without a hole is none.
bool has_letters(const std::vector<FontLetter>& font) {
    struct Holes {
        char32_t code;
        std::size_t rings;
    };
    constexpr Holes kHoles[] = {{'o', 2}, {'i', 2}, {'x', 1}, {':', 2}, {'=', 2}, {'<', 1}, {'>', 1}, {'\\', 1}, {'1', 1}};
    return std::all_of(std::begin(kHoles), std::end(kHoles), [&](const Holes& one) {
        const auto found =
            std::find_if(font.begin(), font.end(), [&](const FontLetter& letter) { return letter.code == one.code; });
        return found != font.end() && found->outline.rings == one.rings;
    });
}

bool is_alphabetic(char32_t code) { return ((code | 32) >= 'a' && (code | 32) <= 'z') || (code >= 0xC0 && code < 0x500); }

char script_of(char32_t code) { return code >= 0x370 && code < 0x400 ? 'g' : code >= 0x400 && code < 0x500 ? 'c' : 'l'; }

namespace {

// Settings.
constexpr double kSameBar = 0.06;     // em: bars of two fonts as long, as thick and as high as each other
constexpr double kNearlySame = 0.02;  // em: outlines of two editions of a font

bool is_bar(char32_t code) { return code == '-' || code == 0x2212 || code == 0x2013; }

bool is_same_bar(const OutlineMeasure& shape, const FontLetter& letter, double em) {
    for (const std::size_t i : {0, 1, 2})  // width, bottom and top
        if (std::abs(shape.lengths[i] / em - letter.outline.lengths[i]) > kSameBar) return false;
    return shape.rings == 1 && is_bar(letter.code);
}

}  // namespace

const FontLetter* nearly_same(const std::vector<FontLetter>& font, const OutlineMeasure& shape, double em) {
    const FontLetter* best = nullptr;
    double least = 1, next = 1;
    for (const FontLetter& letter : font) {
        if (is_same_bar(shape, letter, em)) return &letter;
        const double apart = apart_at(shape, letter.outline, em);
        if (apart < least) {
            next = least;
            least = apart;
            best = &letter;
        } else {
            next = std::min(next, apart);
        }
    }
    return least <= kNearlySame && next >= 2 * least ? best : nullptr;
}

std::vector<FontLetter> letters_like(const std::vector<FontLetter>& font, const std::function<double(const FontLetter&)>& apart) {
    std::map<char, double> nearest;
    for (const FontLetter& letter : font) {
        double& least = nearest.try_emplace(script_of(letter.code), kSameOutline).first->second;
        least = std::min(least, apart(letter));
    }
    std::vector<FontLetter> alike;
    for (const FontLetter& letter : font)
        if (const double off = apart(letter); off < kSameOutline && off <= nearest[script_of(letter.code)] + kSameOutline / 4)
            alike.push_back(letter);
    return alike;
}

ShapeSet::ShapeSet(const std::vector<OutlineMeasure>& outlines, std::vector<std::size_t> own) : own_(std::move(own)) {
    for (const std::size_t shape : own_) outlines_.push_back(outlines[shape]);
}

bool ShapeSet::matches(const std::vector<FontLetter>& font, std::size_t number) {
    std::vector<Match> all, rough;
    std::size_t inked = 0, only_one = 0;
    for (std::size_t i = 0; i < own_.size() && inked < kMostAsked; ++i) {
        if (!(outlines_[i].area > 0)) continue;
        ++inked;
        const std::size_t before = all.size();
        for (std::size_t k = 0; k < font.size(); ++k) {
            const double em = em_of(outlines_[i], font[k]);
            const double apart = apart_at(outlines_[i], font[k].outline, em);
            if (apart < kSameOutline) all.push_back({i, k, em, apart});
            if (apart < kBent) rough.push_back({i, k, em, apart});
            // Upwards and downwards letters are bent more than along their line, and their ink is more.
            const double wide = outlines_[i].lengths[0] / font[k].outline.lengths[0];
            if (const double off = apart_but_for_ink(outlines_[i], font[k].outline, wide); off < kBent)
                rough.push_back({i, k, wide, off});
        }
        const auto other = [&](const Match& match) { return std::abs(match.em / all.back().em - 1) > kSameSize; };
        const bool one_size =
            all.size() > before && std::none_of(all.begin() + static_cast<std::ptrdiff_t>(before), all.end(), other);
        only_one += one_size && outlines_[i].corners > 4 ? 1 : 0;
    }
    const auto best = common_size(all, kSameSize);
    if (only_one > 0 && is_share(best.size(), inked, kMostOfFont)) {
        em_ = mean_em(best);
        candidates_ = {{number, best.size(), em_, 0}};
        return true;
    }
    if (const auto near = common_size(rough, kBentSize); is_share(near.size(), inked, kNearFont)) {
        double apart = 0;
        for (const auto& [shape, match] : near) apart += match.apart;
        candidates_.push_back({number, near.size(), mean_em(near), apart});
        std::sort(candidates_.begin(), candidates_.end());
        if (candidates_.size() > kMostCandidates) candidates_.pop_back();
    }
    return false;
}

bool ShapeSet::matches_at(const std::vector<FontLetter>& font, double em) {
    std::size_t inked = 0, found = 0;
    for (const OutlineMeasure& one : outlines_) {
        if (!(one.area > 0) || inked == kMostAsked) continue;
        ++inked;
        found += std::any_of(font.begin(), font.end(),
                             [&](const FontLetter& letter) { return apart_at(one, letter.outline, em) < kSameOutline; });
    }
    em_ = em;
    return is_share(found, inked, kMostOfFont);
}

std::vector<char32_t> ShapeSet::near(const std::vector<FontLetter>& font, double em) const {
    std::vector<char32_t> codes;
    for (const FontLetter& letter : font)
        if (std::any_of(outlines_.begin(), outlines_.end(),
                        [&](const OutlineMeasure& one) { return one.area > 0 && apart_at(one, letter.outline, em) < 2 * kBent; }))
            codes.push_back(letter.code);
    return codes;
}

void ShapeSet::take(const std::vector<FontLetter>& font, LettersOfShapes& read) const {
    for (std::size_t i = 0; i < own_.size(); ++i)
        if (outlines_[i].area > 0 && read[own_[i]].empty())
            read[own_[i]] =
                letters_like(font, [&](const FontLetter& letter) { return apart_at(outlines_[i], letter.outline, em_); });
}

bool ShapeSet::is_read(const LettersOfShapes& read) const {
    for (std::size_t i = 0; i < own_.size(); ++i)
        if (outlines_[i].area > 0 && read[own_[i]].empty()) return false;
    return true;
}

}  // namespace tactics
