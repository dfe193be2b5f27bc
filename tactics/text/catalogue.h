// SPDX-License-Identifier: Apache-2.0
// The languages that the program speaks besides English: what its phrases are called in each. The catalogues are gettext's PO
// files, tactics/text/po/TAG.po, and part of the program: a page's language is none of the process's, nothing needs to be
// installed or found, and any number of threads may ask.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tactics {

struct CatalogueEntry {
    std::string english;             ///< msgid
    std::string plural;              ///< msgid_plural; empty: it has none
    std::vector<std::string> words;  ///< msgstr, or msgstr[0], msgstr[1] ...
    bool fuzzy = false;              ///< not looked over, and so not used
};

/// The entries of a PO file, its head (an empty msgid) among them. Throws std::logic_error with the line for what is none.
std::vector<CatalogueEntry> entries_of(std::string_view po);

struct Language {
    std::string_view tag;                ///< "de"
    const std::string_view* po;          ///< the text of the file
    std::size_t (*form)(std::size_t n);  ///< which of the plural forms goes with a number (gettext manual, "Plural forms")
};

/// Besides English.
std::span<const Language> languages();

/// That of a catalogue for who reads the language of a tag: "de" for de-AT. "en" where there is none.
std::string_view spoken_language(std::string_view tag);

/// What a phrase is called in that language; empty: it is to be said in English.
std::string_view translated(std::string_view tag, std::string_view english);
/// The same for a number of things.
std::string_view translated(std::string_view tag, std::string_view english, std::size_t count);

}  // namespace tactics
