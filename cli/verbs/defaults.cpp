// SPDX-License-Identifier: Apache-2.0
// `tactics defaults`: choices that are kept for all jobs.
#include <algorithm>
#include <filesystem>

#include "cli/command.h"
#include "cli/config_folders.h"
#include "cli/kept_choices.h"
#include "cli/report/say.h"
#include "cli/report/user_language.h"
#include "tactics/error.h"
#include "tactics/text/json.h"
#include "tactics/transport/file.h"

namespace tactics {

namespace {

constexpr Flag kDefaultsFlags[] = {
    {"--json", "", "",
     "one JSON object per line for each choice: its name and, if it is kept, its value, its place and what it "
     "overrides",
     false, ""},
};

std::string json_line(const KeptWord& word, const std::vector<KeptChoice>& choices) {
    JsonAnswer json;
    json.add("name", word.name);
    json.add("summary", word.summary.text);
    std::vector<std::string> others;
    bool first = true;
    for (const KeptChoice& choice : choices) {
        if (choice.word != &word) continue;
        if (first) {
            json.add("value", choice.value);
            json.add("place", choice.place);
        } else {
            JsonObject other;
            other.add("value", choice.value);
            other.add("place", choice.place);
            others.push_back(other.text());
        }
        first = false;
    }
    if (!others.empty()) json.add_raw("instead_of", json_array(others));
    return json.text() + "\n";
}

std::string text_line(const KeptWord& word, const std::vector<KeptChoice>& choices) {
    Phrase line;
    for (const KeptChoice& choice : choices) {
        if (choice.word != &word) continue;
        line = line.empty() ? phrase("{0} {1} ({2})", word.name, choice.value, choice.place)
                            : phrase("{0}, instead of {1} ({2})", std::move(line), choice.value, choice.place);
    }
    return line_for_user(line.empty() ? phrase("{0}: not kept; {1}", word.name, phrase(word.summary)) : line);
}

void show(bool json) {
    const auto choices = kept_choices();
    std::string text;
    for (const KeptWord& word : kept_words()) text += json ? json_line(word, choices) : text_line(word, choices);
    print_out(text);
}

void make_folder_of(const std::string& file) {
    namespace fs = std::filesystem;
    const fs::path folder = fs::path(file).parent_path();
    std::error_code fault;
    if (fs::is_directory(folder, fault)) return;
    fs::create_directories(folder, fault);
    if (fault) throw Error(Fault::failed, folder.string(), phrase("this folder cannot be made: {0}", fault.message()));
}

void set(const std::string& name, const std::string& value) {
    const std::string place = "defaults set " + name.substr(0, 80);
    const KeptWord& word = find_kept_word(name, "defaults set");
    if (value.empty() || value.find_first_of("\n\r#") != std::string::npos)
        throw Error(Fault::usage, place, phrase("the value is one line of text without #; write {0}", word.value));
    word.check(value, place);
    if (word.name == "braille") check_kept_table(value, place);
    const std::string file = own_kept_file();
    make_folder_of(file);
    write_file(file, with_choice(text_of_kept(file), name, value));
}

// Also accepts an unknown word, because the file may hold it, which is an error there.
void unset(const std::string& name) {
    const std::string file = own_kept_file();
    const std::string before = text_of_kept(file), after = without_choice(before, name);
    if (after == before) {
        find_kept_word(name, "defaults unset");
        say(phrase("{0} is not kept in {1}", name, file));
        return;
    }
    write_file(file, after);
}

int run_defaults(const Given& given) {
    const auto& words = given.words;
    if (!words.empty() && given.has("--json"))
        throw Error(Fault::usage, "--json", phrase("it is for showing what is kept; leave it out, or leave out {0}", words[0]));
    if (words.empty())
        show(given.has("--json"));
    else if (words[0] == "set" && words.size() == 3)
        set(words[1], words[2]);
    else if (words[0] == "unset" && words.size() == 2)
        unset(words[1]);
    else
        throw Error(Fault::usage, "defaults",
                    words[0] == "set"     ? phrase("name what is to be kept, and its value: tactics defaults set paper a4")
                    : words[0] == "unset" ? phrase("name one thing that is no longer to be kept: tactics defaults unset paper")
                                          : phrase("it cannot be \"{0}\"{1}; it is set, unset, or nothing to show what is kept",
                                                   words[0].substr(0, 80), did_you_mean(words[0], {"set", "unset"})));
    return 0;
}

}  // namespace

extern const Command defaults_command;
const Command defaults_command{
    .name = "defaults",
    .summary = "show and change the choices kept for all jobs: language, paper, machine and others",
    .words = "[set NAME VALUE | unset NAME]",
    .details =
        "Without words it shows the choices that are kept, each with its file and line, and describes the others. convert, "
        "describe, show, chart, check, emboss and preview use a kept choice wherever the command line does not say otherwise "
        "and the output allows it: a kept paper does not apply to an embosser, and a kept braille size does not apply to a "
        "machine that has its own. With --no-defaults they use none; give it in scripts whose pages must be the same "
        "everywhere.\n\n"
        "The file is $XDG_CONFIG_HOME/tactics/defaults, or ~/.config/tactics/defaults if that variable is not set. After it, "
        "for all users of the machine, come tactics/defaults in the folders of $XDG_CONFIG_DIRS, or /etc/xdg/tactics/defaults "
        "if that variable is not set. Each line is a name and a value, such as paper a4; # begins a comment. A wrong line is an "
        "error that names the file and the line number.\n\n"
        "Recipe files called NAME.recipe in the folder recipes beside that file are found by name, --recipe NAME; tactics list "
        "recipes shows them. Print jobs use none of these choices.",
    .example =
        "tactics defaults\ntactics defaults set language de\ntactics defaults set paper letter\n"
        "tactics defaults set machine index-v4\ntactics defaults unset paper",
    .flags = kDefaultsFlags,
    .offers = "set unset",
    .run = run_defaults,
};

}  // namespace tactics
