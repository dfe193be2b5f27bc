// SPDX-License-Identifier: Apache-2.0
// What the program says, as values that are put into words at the end, in the language of whoever reads them: a page and its
// files in that of the page (Page::language), what is said to the user in the user's own, what programs read in English.
//
//     const Phrase size = phrase("{0} wide and {1} high", spoken_length(120), spoken_length(85));
//     size.english();  // "12 cm wide and 8.5 cm high"
//     size.in("de");   // "12 cm breit und 8,5 cm hoch"
//
// The English words are the name of a phrase in the catalogues, tactics/text/po/TAG.po, as with gettext.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tactics {

/// Words that stand in the source, so that a test can look whether every catalogue has them
/// (tests/tactics/text/catalogue_test.cpp).
struct SourceWords {
    consteval SourceWords(const char* words) : text(words) {}
    std::string_view text;
};

class Phrase {
public:
    Phrase() = default;
    /// Names, words of the user's and what no catalogue has: the same in every language.
    Phrase(std::string words) : words_(std::move(words)) {}
    Phrase(std::string_view words) : words_(words) {}
    Phrase(const char* words) : words_(words) {}

    std::string in(std::string_view language) const;  ///< a tag of BCP 47; English where there is no catalogue for it
    std::string english() const { return in("en"); }
    bool empty() const { return words_.empty() && source_.empty(); }
    bool operator==(const Phrase& other) const = default;

private:
    friend Phrase phrase_of(SourceWords one, SourceWords many, std::size_t count, std::vector<Phrase> parts);
    friend Phrase numeral_of(std::string digits);

    std::string words_;          // as they are, if there is no source
    std::string_view source_;    // "{0} line": what the catalogues have it by
    std::string_view many_;      // "{0} lines"; empty: it has no plural
    std::size_t count_ = 0;      // that the plural goes by
    std::vector<Phrase> parts_;  // what stands at {0}, {1} ...
    bool numeral_ = false;       // with a decimal point or comma
};

/// A number: "3.5", and "3,5" where people write it so.
Phrase numeral(double value);
/// The same of a number that is written already, such as "3.50".
Phrase numeral_of(std::string digits);

Phrase phrase_of(SourceWords one, SourceWords many, std::size_t count, std::vector<Phrase> parts);

/// A sentence, or what is one thing within it. {0}, {1} and so on stand for the parts, in any order. Braces stand for nothing
/// else, and without parts for themselves.
template <typename... Parts>
Phrase phrase(SourceWords words, Parts&&... parts) {
    return phrase_of(words, "", 0, {Phrase(std::forward<Parts>(parts))...});
}

/// Of a number of things, which is {0}: phrases(3, "{0} line", "{0} lines").
template <typename... Parts>
Phrase phrases(std::size_t count, SourceWords one, SourceWords many, Parts&&... parts) {
    return phrase_of(one, many, count, {Phrase(std::to_string(count)), Phrase(std::forward<Parts>(parts))...});
}

/// "one, two and three"
Phrase listed(const std::vector<Phrase>& parts);
/// "one, two or three"
Phrase either_of(const std::vector<Phrase>& parts);
/// "one, two, three", with what is said between any two.
Phrase row_of(const std::vector<Phrase>& parts);

/// The first letter as a sentence has it.
std::string as_sentence(std::string text);

/// Each of them put into words.
std::vector<std::string> in_language(const std::vector<Phrase>& phrases, std::string_view language);

}  // namespace tactics
