// SPDX-License-Identifier: Apache-2.0
// Joins the lines of a text, and the words that were divided at their ends.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace tactics {

/// Appends a line to the text before it and keeps typed hyphens: "e-" and "mail" become "e-mail". A soft hyphen (U+00AD) and
/// U+2010 divide a word and are removed; a hyphen for an omitted part stays: "Vor- und Nachteile". Other lines are separated by a
/// blank.
void join_typed_line(std::string& text, std::string_view line);

/// For text set in lines by a program: a hyphen at the end of a line may come from the program or belong to the word.
class PartedWords {
public:
    /// Passes it a line of the text. Pass all lines before joining the first.
    void show(std::string_view line);

    /// As join_typed_line, but removes the hyphen if the word occurs elsewhere without it, or if the word does not occur and the
    /// next line begins with a lower-case letter.
    void join(std::string& text, std::string_view line);

    /// The number of words joined without evidence elsewhere in the text, and the first of them.
    std::size_t guesses() const { return guesses_; }
    const std::vector<std::string>& guessed() const { return guessed_; }

private:
    bool is_parted(std::string_view before, std::string_view next);

    std::unordered_set<std::string> seen_;  // in small letters
    std::size_t guesses_ = 0;
    std::vector<std::string> guessed_;
};

/// Whether it ends with a word divided by a hyphen.
bool ends_parted(std::string_view text);
bool begins_small(std::string_view text);

}  // namespace tactics
