// SPDX-License-Identifier: Apache-2.0
// A sentence for the person who makes a page, and whether it requires action.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace tactics {

struct Note {
    /// know: information on what was done or chosen. act: something on the page is missing or wrong, such as words left out, and
    /// a person must look at it or act.
    enum class Kind { know, act };

    std::string text;  ///< one line, without the name of the picture
    Kind kind = Kind::know;

    Note(std::string words, Kind what = Kind::know) : text(std::move(words)), kind(what) {}
    Note(const char* words, Kind what = Kind::know) : text(words), kind(what) {}
    bool asks() const { return kind == Kind::act; }
    bool operator==(const Note& other) const { return text == other.text && kind == other.kind; }
};

using Notes = std::vector<Note>;

inline Note to_act_on(std::string words) { return {std::move(words), Note::Kind::act}; }

inline std::vector<std::string> texts_of(const Notes& notes) {
    std::vector<std::string> texts;
    for (const Note& note : notes) texts.push_back(note.text);
    return texts;
}

}  // namespace tactics
