// SPDX-License-Identifier: Apache-2.0
#include "tactics/text/catalogue.h"

#include <stdexcept>
#include <unordered_map>

#include "tactics/text/words.h"

namespace tactics {

// The text of each file, from a source that CMake makes.
#define LANGUAGE(tag, plural) extern const std::string_view kPo_##tag;
#include "tactics/text/languages.inc"
#undef LANGUAGE

namespace {

constexpr Language kLanguages[] = {
#define LANGUAGE(tag, plural) {#tag, &kPo_##tag, [](std::size_t n) -> std::size_t { return plural; }},
#include "tactics/text/languages.inc"
#undef LANGUAGE
};

const Language* language_for(std::string_view tag) {
    const std::string_view base = tag.substr(0, tag.find_first_of("-_"));
    for (const Language& language : kLanguages)
        if (language.tag == base) return &language;
    return nullptr;
}

[[noreturn]] void refuse(std::size_t line) {
    throw std::logic_error("line " + std::to_string(line) + " of a catalogue is none of gettext's");
}

// "a\"b\n" without its marks.
std::string unquoted(std::string_view text, std::size_t line) {
    if (text.size() < 2 || text.front() != '"' || text.back() != '"') refuse(line);
    text = text.substr(1, text.size() - 2);
    std::string plain;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '\\') {
            plain += text[i];
        } else {
            if (++i == text.size()) refuse(line);
            plain += text[i] == 'n' ? '\n' : text[i] == 't' ? '\t' : text[i];
        }
    }
    return plain;
}

struct ByWords {
    std::unordered_map<std::string_view, const CatalogueEntry*> found;
    std::vector<CatalogueEntry> entries;

    explicit ByWords(std::string_view po) : entries(entries_of(po)) {
        for (const CatalogueEntry& entry : entries)
            if (!entry.english.empty() && !entry.fuzzy) found.emplace(entry.english, &entry);
    }
};

// Read when it is first asked for: in English nothing is.
const ByWords& catalogue_of(const Language& language) {
    static const std::vector<ByWords> all = [] {
        std::vector<ByWords> read;
        for (const Language& one : kLanguages) read.emplace_back(*one.po);
        return read;
    }();
    return all[static_cast<std::size_t>(&language - kLanguages)];
}

}  // namespace

std::vector<CatalogueEntry> entries_of(std::string_view po) {
    std::vector<CatalogueEntry> entries;
    std::string* open = nullptr;  // what the next line goes on with
    bool fuzzy = false;
    for (std::size_t number = 1; !po.empty(); ++number) {
        const std::string_view line = trimmed(po.substr(0, po.find('\n')));
        po.remove_prefix(std::min(po.size(), po.find('\n') == po.npos ? po.size() : po.find('\n') + 1));
        if (line.empty() || line.front() == '#') {
            if (line.starts_with("#,")) fuzzy = line.find("fuzzy") != line.npos;
            continue;
        }
        std::string_view word = line.substr(0, line.find_first_of(" \""));
        const std::string text = unquoted(trimmed(line.substr(word.size())), number);
        if (word == "msgid") {
            entries.emplace_back().fuzzy = fuzzy;
            fuzzy = false;
            open = &entries.back().english;
        } else if (entries.empty()) {
            refuse(number);
        } else if (word == "msgid_plural") {
            open = &entries.back().plural;
        } else if (word == "msgstr" || word == "msgstr[" + std::to_string(entries.back().words.size()) + "]") {
            open = &entries.back().words.emplace_back();
        } else if (!word.empty()) {
            refuse(number);
        }
        *open += text;
    }
    return entries;
}

std::span<const Language> languages() { return kLanguages; }

std::string_view spoken_language(std::string_view tag) {
    const Language* language = language_for(tag);
    return language != nullptr ? language->tag : "en";
}

std::string_view translated(std::string_view tag, std::string_view english) { return translated(tag, english, 1); }

std::string_view translated(std::string_view tag, std::string_view english, std::size_t count) {
    const Language* language = language_for(tag);
    if (language == nullptr) return {};
    const auto& found = catalogue_of(*language).found;
    const auto entry = found.find(english);
    if (entry == found.end()) return {};
    const std::vector<std::string>& words = entry->second->words;
    const std::size_t form = entry->second->plural.empty() ? 0 : language->form(count);
    return form < words.size() ? std::string_view(words[form]) : std::string_view();
}

}  // namespace tactics
