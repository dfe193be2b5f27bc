// SPDX-License-Identifier: Apache-2.0
#include "tactics/text/phrase.h"

#include <algorithm>
#include <optional>

#include "tactics/text/catalogue.h"
#include "tactics/text/decimal_comma.h"
#include "tactics/text/number.h"

namespace tactics {

namespace {

// The number between the braces of a place that `text` begins with; nothing: it is no place.
struct FoundPlace {
    std::size_t part = 0, letters = 0;
};
std::optional<FoundPlace> place_at(std::string_view text) {
    std::size_t part = 0, at = 1;
    for (; at < text.size() && at < 4 && text[at] >= '0' && text[at] <= '9'; ++at)
        part = part * 10 + static_cast<std::size_t>(text[at] - '0');
    if (at == 1 || at >= text.size() || text[at] != '}') return std::nullopt;
    return FoundPlace{part, at + 1};
}

// A row is of two rows. If each of ten thousand were the row before and one more, a copy of it would be ten thousand deep.
Phrase row_of_halves(const Phrase* parts, std::size_t count) {
    if (count == 1) return *parts;
    return phrase("{0}, {1}", row_of_halves(parts, count / 2), row_of_halves(parts + count / 2, count - count / 2));
}

}  // namespace

Phrase phrase_of(SourceWords one, SourceWords many, std::size_t count, std::vector<Phrase> parts) {
    Phrase made;
    made.source_ = one.text;
    made.many_ = many.text;
    made.count_ = count;
    made.parts_ = std::move(parts);
    return made;
}

Phrase numeral(double value) { return numeral_of(to_text(value)); }

Phrase numeral_of(std::string digits) {
    Phrase made(std::move(digits));
    made.numeral_ = true;
    return made;
}

std::string Phrase::in(std::string_view language) const {
    if (source_.empty()) {
        std::string text = words_;
        if (numeral_ && spoken_language(language) == language.substr(0, language.find('-')) && writes_comma(language))
            std::replace(text.begin(), text.end(), '.', ',');
        return text;
    }
    std::string_view words = many_.empty() ? translated(language, source_) : translated(language, source_, count_);
    if (words.empty()) words = many_.empty() || count_ == 1 ? source_ : many_;
    if (parts_.empty()) return std::string(words);
    std::string text;
    while (!words.empty()) {
        const auto place = words.front() == '{' ? place_at(words) : std::nullopt;
        if (place && place->part < parts_.size()) {
            text += parts_[place->part].in(language);
            words.remove_prefix(place->letters);
        } else {
            text += words.front();
            words.remove_prefix(1);
        }
    }
    return text;
}

Phrase row_of(const std::vector<Phrase>& parts) { return parts.empty() ? Phrase() : row_of_halves(parts.data(), parts.size()); }

Phrase listed(const std::vector<Phrase>& parts) {
    if (parts.size() < 2) return row_of(parts);
    return phrase("{0} and {1}", row_of({parts.begin(), parts.end() - 1}), parts.back());
}

Phrase either_of(const std::vector<Phrase>& parts) {
    if (parts.size() < 2) return row_of(parts);
    return phrase("{0} or {1}", row_of({parts.begin(), parts.end() - 1}), parts.back());
}

std::string as_sentence(std::string text) {
    if (text.empty()) return text;
    if (text[0] >= 'a' && text[0] <= 'z') {
        text[0] = static_cast<char>(text[0] - 'a' + 'A');
    } else if (text.size() > 1 && text[0] == '\xC3' && text[1] >= '\xA0' && text[1] <= '\xBE' && text[1] != '\xB7') {
        text[1] = static_cast<char>(text[1] - 0x20);  // U+00E0 to U+00FE: à, é, ö ...
    }
    return text;
}

std::vector<std::string> in_language(const std::vector<Phrase>& phrases, std::string_view language) {
    std::vector<std::string> texts;
    for (const Phrase& one : phrases) texts.push_back(one.in(language));
    return texts;
}

}  // namespace tactics
