// SPDX-License-Identifier: Apache-2.0
// Lines of a text put together again, and the words that were parted at their ends.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace tactics {

/// Puts a line behind the text before it, as whoever typed the hyphen wrote it: "e-" and "mail" become "e-mail". A soft hyphen
/// (U+00AD) and U+2010 part a word, and go; a hyphen that leaves out what comes later stays as it is: "Vor- und Nachteile". All
/// other lines are parted by a blank.
void join_typed_line(std::string& text, std::string_view line);

/// Of a text that was set in lines by a program: a hyphen at the end of a line may be the program's or the word's own.
class PartedWords {
public:
    /// Shows it a line of the text. All are shown before the first is put behind another.
    void show(std::string_view line);

    /// As join_typed_line, but the hyphen goes if the text has the word without it elsewhere, or tells nothing of the word and
    /// the next line begins with a small letter.
    void join(std::string& text, std::string_view line);

    /// How many words were put together although the text does not show elsewhere how they are written, and the first of them.
    std::size_t guesses() const { return guesses_; }
    const std::vector<std::string>& guessed() const { return guessed_; }

private:
    bool is_parted(std::string_view before, std::string_view next);

    std::unordered_set<std::string> seen_;  // in small letters
    std::size_t guesses_ = 0;
    std::vector<std::string> guessed_;
};

/// Whether it ends with a word that a hyphen parts.
bool ends_parted(std::string_view text);
bool begins_small(std::string_view text);

}  // namespace tactics
