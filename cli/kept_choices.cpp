// SPDX-License-Identifier: Apache-2.0
#include "cli/kept_choices.h"

#include <algorithm>
#include <filesystem>

#include "cli/config_folders.h"
#include "cli/flag_values.h"
#include "cli/sheet_values.h"
#include "print/embosser.h"
#include "tactics/braille/braille.h"
#include "tactics/error.h"
#include "tactics/job/disk.h"
#include "tactics/job/print_words.h"
#include "tactics/recipe.h"
#include "tactics/text/words.h"

namespace tactics {

namespace {

constexpr std::string_view kFile = "/defaults";

// A name is looked up where it is used, as that takes reading the table; a path must mean the same file from any folder.
void check_braille_name(const std::string& value, const std::string& place) {
    if (value.find('/') != std::string::npos && !value.starts_with('/'))
        throw Error(Fault::usage, place, phrase("a braille table of your own is kept by its whole path, which begins with /"));
}

constexpr KeptWord kWords[] = {
    {"language", "TAG", SourceWords("language of titles, braille and print that is read; default: en"),
     [](const std::string& value, const std::string& place) { language_of(value, place); }},
    {"braille", "TABLE|none", SourceWords("braille table; default: that of the language"), check_braille_name},
    {"cell", "NAME", SourceWords("size of braille on printed pages; default: marburg-medium"),
     [](const std::string& value, const std::string& place) { find_cell(value, place); }},
    {"paper", "PAPER", SourceWords("paper of printed pages and height maps; default: a4"),
     [](const std::string& value, const std::string& place) { find_paper(value, place); }},
    {"embosser-paper", "PAPER",
     SourceWords("paper of braille files and of embossers that take it; default: that of each machine or format"),
     [](const std::string& value, const std::string& place) { find_paper(value, place); }},
    {"medium", "MEDIUM", SourceWords("medium of printed pages; default: swell"),
     [](const std::string& value, const std::string& place) { find_medium(value, place); }},
    {"margin", "LENGTH", SourceWords("margin of printed pages; default: the medium's own"),
     [](const std::string& value, const std::string& place) { margin_of(value, place); }},
    {"binding", "left|top|right=LENGTH", SourceWords("room for holes on printed pages; default: none"),
     [](const std::string& value, const std::string& place) { binding_of(value, place); }},
    {"words", "auto|read|leave|remove", SourceWords("what to do with print in pictures; default: auto"),
     [](const std::string& value, const std::string& place) { find_words_wish(value, place); }},
    {"machine", "NAME", SourceWords("embosser for emboss, preview and .prn files from convert; default: none"),
     [](const std::string& value, const std::string& place) { find_embosser(value, place); }},
    {"progress", "none|lines|bar", SourceWords("how convert reports progress; default: a bar on a terminal, lines elsewhere"),
     [](const std::string& value, const std::string& place) { progress_of(value, place); }},
};

struct Line {
    std::string_view word, value;
};

// "--paper = a4", as one may write it, too.
Line read_line(std::string_view line) {
    line = trimmed(line.substr(0, line.starts_with('#') ? 0 : line.find(" #")));
    if (line.starts_with("--")) line.remove_prefix(2);
    const auto end = std::min(line.find_first_of(" \t="), line.size());
    std::string_view value = trimmed(line.substr(end));
    if (value.starts_with('=')) value = trimmed(value.substr(1));
    return {line.substr(0, end), value};
}

template <typename Each>
void each_line(std::string_view text, const Each& each) {
    for (std::size_t number = 1; !text.empty(); ++number) {
        const auto end = std::min(text.find('\n'), text.size());
        each(text.substr(0, end), number);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
}

}  // namespace

std::span<const KeptWord> kept_words() { return kWords; }

const KeptWord& find_kept_word(std::string_view name, std::string_view place) {
    std::vector<std::string_view> names;
    for (const KeptWord& word : kWords) {
        if (word.name == name) return word;
        names.push_back(word.name);
    }
    throw Error(
        Fault::usage, place,
        phrase("\"{0}\" cannot be kept{1}; tactics defaults shows what can", name.substr(0, 80), did_you_mean(name, names)));
}

std::vector<KeptChoice> parse_kept(std::string_view text, const std::string& file) {
    if (text.size() > kMaxRecipeBytes)
        throw Error(Fault::usage, file, phrase("it is over 64 KB long; it is to hold a few lines"));
    std::vector<KeptChoice> choices;
    each_line(text, [&](std::string_view line, std::size_t number) {
        const auto [name, value] = read_line(trimmed(line));
        if (name.empty() && value.empty()) return;
        const std::string place = file + ":" + std::to_string(number);
        const KeptWord& word = find_kept_word(name, place);
        if (value.empty())
            throw Error(Fault::usage, place, phrase("the value is missing; write for example {0} {1}", name, word.value));
        const auto other =
            std::find_if(choices.begin(), choices.end(), [&](const KeptChoice& choice) { return choice.word == &word; });
        if (other != choices.end())
            throw Error(Fault::usage, place,
                        phrase("{0} stands in line {1}, too; keep one of the two", name,
                               other->place.substr(other->place.rfind(':') + 1)));
        word.check(std::string(value), place);
        choices.push_back({&word, std::string(value), place});
    });
    return choices;
}

std::vector<KeptChoice> kept_choices() {
    std::vector<KeptChoice> all;
    for (const std::string& folder : config_folders()) {
        const std::string file = folder + std::string(kFile);
        const auto choices = parse_kept(text_of_kept(file), file);
        all.insert(all.end(), choices.begin(), choices.end());
    }
    return all;
}

std::string text_of_kept(const std::string& file) {
    std::error_code fault;
    const bool none = std::filesystem::is_empty(file, fault) || fault == std::errc::no_such_file_or_directory ||
                      fault == std::errc::not_a_directory;
    return none ? "" : real_disk().read_text(file);
}

std::string own_kept_file() {
    const std::string folder = own_config_folder();
    if (folder.empty())
        throw Error(
            Fault::failed, "defaults",
            phrase(
                "neither XDG_CONFIG_HOME nor HOME names a folder to keep them in; set one of them to a path that begins with /"));
    return folder + std::string(kFile);
}

std::string with_choice(std::string_view text, std::string_view word, std::string_view value) {
    const std::string fresh = std::string(word) + " " + std::string(value) + "\n";
    std::string out;
    bool done = false;
    each_line(text, [&](std::string_view line, std::size_t) {
        const bool same = read_line(trimmed(line)).word == word;
        if (!same) out += std::string(line) + "\n";
        if (same && !done) out += fresh;
        done = done || same;
    });
    return done ? out : out + fresh;
}

std::string without_choice(std::string_view text, std::string_view word) {
    std::string out;
    each_line(text, [&](std::string_view line, std::size_t) {
        if (read_line(trimmed(line)).word != word) out += std::string(line) + "\n";
    });
    return out;
}

void check_kept_table(const std::string& table, const std::string& place) {
    if (table == "none") return;
    try {
        to_braille("", table);
    } catch (const Error& error) {
        // Who reads it knows by the place which wish it is.
        const std::string_view message = error.what(), wish = "--braille: ";
        throw Error(error.fault(), place, message.substr(message.starts_with(wish) ? wish.size() : 0));
    }
}

void take_kept_choices(Given& given) {
    for (const KeptChoice& choice : kept_choices())
        if (given.kept(choice.word->name) == nullptr) given.keep(choice.word->name, {choice.value, choice.place});
}

KeptSheet kept_sheet(const Given& given) {
    KeptSheet kept;
    if (const KeptValue* paper = given.kept("paper")) kept.paper = find_paper(paper->value, paper->place);
    // A typed paper applies to every output.
    if (const KeptValue* paper = given.kept("embosser-paper"); paper != nullptr && !given.has("--paper"))
        kept.embosser_paper = find_paper(paper->value, paper->place);
    if (const KeptValue* medium = given.kept("medium")) kept.medium = &find_medium(medium->value, medium->place);
    if (const KeptValue* margin = given.kept("margin")) {
        kept.margin = margin_of(margin->value, margin->place);
        kept.margin_origin = margin->place;
    }
    if (const KeptValue* binding = given.kept("binding")) {
        kept.binding = binding_of(binding->value, binding->place);
        kept.binding_origin = binding->place;
    }
    if (const KeptValue* cell = given.kept("cell")) kept.cell = find_cell(cell->value, cell->place).size;
    return kept;
}

}  // namespace tactics
