// SPDX-License-Identifier: Apache-2.0
// A sentence for the person who makes a page, and whether it requires action.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tactics/text/phrase.h"

namespace tactics {

struct Note {
    /// know: information on what was done or chosen. act: something on the page is missing or wrong, such as words left out, and
    /// a person must look at it or act.
    enum class Kind { know, act };

    Phrase words;  ///< one line, without the name of the picture
    Kind kind = Kind::know;

    Note(Phrase what_is_said, Kind what = Kind::know) : words(std::move(what_is_said)), kind(what) {}
    Note(std::string what_is_said, Kind what = Kind::know) : words(std::move(what_is_said)), kind(what) {}
    Note(const char* what_is_said, Kind what = Kind::know) : words(what_is_said), kind(what) {}
    bool asks() const { return kind == Kind::act; }
    std::string english() const { return words.english(); }
    bool operator==(const Note& other) const = default;
};

using Notes = std::vector<Note>;

inline Note to_act_on(Phrase words) { return {std::move(words), Note::Kind::act}; }

/// In English, for programs.
inline std::vector<std::string> texts_of(const Notes& notes) {
    std::vector<std::string> texts;
    for (const Note& note : notes) texts.push_back(note.english());
    return texts;
}

}  // namespace tactics
