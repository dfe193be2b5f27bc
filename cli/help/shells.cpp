// SPDX-License-Identifier: Apache-2.0
#include "cli/help/shells.h"

#include "cli/command.h"
#include "cli/help/catalogue.h"
#include "tactics/text/words.h"

namespace tactics {

namespace {

// What `offers` of a Flag stands for.
struct Offer {
    std::vector<std::string> words;
    bool files = false;
    bool folders = false;
};

Offer offer_of(std::string_view offers) {
    Offer offer;
    for (const auto word : words_of(offers)) {
        if (word == "files") {
            offer.files = true;
        } else if (word == "folders") {
            offer.folders = true;
        } else if (word == "settings") {
            for (const auto& name : setting_names()) offer.words.push_back(name + "=");
        } else if (word == "limits") {
            for (const auto& name : limit_names()) offer.words.push_back(name + "=");
        } else if (word == "groups") {
            for (const Group& group : groups()) offer.words.emplace_back(group.name);
        } else if (const Group* group = find_group(word)) {
            for (const Entry& entry : group->entries()) offer.words.emplace_back(entry.name);
        } else {
            offer.words.emplace_back(word);
        }
    }
    return offer;
}

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const auto& word : words) text += (text.empty() ? "" : " ") + word;
    return text;
}

// In single quotes, for any of the three shells.
std::string quoted(std::string_view text) {
    std::string safe = "'";
    for (const char c : text) safe += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return safe + "'";
}

std::string command_names() {
    std::vector<std::string> names;
    for (const Command* command : commands()) names.emplace_back(command->name);
    return joined(names);
}

// The bash words that fill COMPREPLY for an offer.
std::string bash_reply(const Offer& offer) {
    std::string lines;
    if (!offer.words.empty()) lines += "COMPREPLY+=($(compgen -W " + quoted(joined(offer.words)) + " -- \"$word\")); ";
    if (offer.files)
        lines +=
            "compopt -o filenames 2>/dev/null; mapfile -t found < <(compgen -f -- \"$word\"); COMPREPLY+=(\"${found[@]}\"); ";
    else if (offer.folders)
        lines +=
            "compopt -o filenames 2>/dev/null; mapfile -t found < <(compgen -d -- \"$word\"); COMPREPLY+=(\"${found[@]}\"); ";
    return lines.empty() ? "" : lines;
}

std::string bash_command(const Command& command) {
    std::string values;
    std::string names;
    for (const Flag& flag : all_flags(command)) {
        names += (names.empty() ? "" : " ") + std::string(flag.name);
        if (flag.value.empty()) continue;
        const Offer offer = offer_of(flag.offers);
        const bool unfinished = flag.offers.ends_with("settings");  // NAME.OPTION= wants its value without a space
        values += "                " + (flag.letter.empty() ? "" : std::string(flag.letter) + "|") + std::string(flag.name) +
                  ") " + bash_reply(offer) + (unfinished ? "compopt -o nospace 2>/dev/null; " : "") + "return ;;\n";
    }
    return "        " + std::string(command.name) + ")\n            case $before in\n" + values +
           "            esac\n            if [[ $word == -* ]]; then COMPREPLY=($(compgen -W " + quoted(names) +
           " -- \"$word\"));\n            else " + bash_reply(offer_of(command.offers)) + ":; fi ;;\n";
}

// In _arguments a colon and brackets mean something in a description.
std::string zsh_text(std::string_view text) {
    std::string safe;
    for (const char c : text) {
        if (c == ':' || c == '[' || c == ']' || c == '\\') safe += '\\';
        safe += c;
    }
    return safe;
}

std::string zsh_action(std::string_view offers) {
    const Offer offer = offer_of(offers);
    std::vector<std::string> ways;
    if (!offer.words.empty()) ways.push_back("compadd -- " + joined(offer.words));
    if (offer.files)
        ways.push_back("_files");
    else if (offer.folders)
        ways.push_back("_files -/");
    std::string action;
    for (const auto& way : ways) action += (action.empty() ? "" : "; ") + way;
    return action.empty() ? " " : "{ " + action + " }";
}

std::string zsh_command(const Command& command) {
    std::string text = "        " + std::string(command.name) + ") _arguments -s \\\n";
    for (const Flag& flag : all_flags(command)) {
        const std::string rest = "[" + zsh_text(flag.summary) + "]" +
                                 (flag.value.empty() ? "" : ":" + zsh_text(flag.value) + ":" + zsh_action(flag.offers));
        for (const auto name : {flag.letter, flag.name})
            if (!name.empty()) text += "            " + quoted((flag.repeatable ? "*" : "") + std::string(name) + rest) + " \\\n";
    }
    return text + "            " + quoted("*:word:" + zsh_action(command.offers)) + " ;;\n";
}

std::string fish_command(const Command& command) {
    const std::string here = "complete -c tactics -n " + quoted("__fish_seen_subcommand_from " + std::string(command.name));
    const auto offered = [](std::string_view offers) {
        const Offer offer = offer_of(offers);
        std::string words = joined(offer.words);
        if (offer.folders && !offer.files) words += " (__fish_complete_directories)";
        return (offer.files ? " -F" : " -f") + (words.empty() ? "" : " -a " + quoted(words));
    };
    std::string text = "complete -c tactics -n __fish_use_subcommand -f -a " + std::string(command.name) + " -d " +
                       quoted(command.summary) + "\n" + here + offered(command.offers) + "\n";
    for (const Flag& flag : all_flags(command)) {
        text += here;
        if (!flag.letter.empty()) text += " -s " + std::string(flag.letter.substr(1));
        text += " -l " + std::string(flag.name.substr(2));
        if (!flag.value.empty()) text += " -r" + offered(flag.offers);
        text += " -d " + quoted(flag.summary) + "\n";
    }
    return text;
}

}  // namespace

std::string bash_completion() {
    std::string text =
        "# bash completion for tactics; made by: tactics completion bash\n"
        "_tactics() {\n"
        "    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} found=()\n"
        "    COMPREPLY=()\n"
        "    if [[ $COMP_CWORD -eq 1 ]]; then\n"
        "        COMPREPLY=($(compgen -W " +
        quoted(command_names() + " --help --version") +
        " -- \"$word\"))\n"
        "        return\n"
        "    fi\n"
        "    case ${COMP_WORDS[1]} in\n";
    for (const Command* command : commands()) text += bash_command(*command);
    return text + "    esac\n}\ncomplete -F _tactics tactics\n";
}

std::string zsh_completion() {
    std::string text =
        "#compdef tactics\n"
        "# zsh completion for tactics; made by: tactics completion zsh\n"
        "_tactics() {\n"
        "    if (( CURRENT == 2 )); then\n"
        "        compadd -- " +
        command_names() +
        " --help --version\n"
        "        return\n"
        "    fi\n"
        "    local command=$words[2]\n"
        "    shift words; (( CURRENT-- ))\n"
        "    case $command in\n";
    for (const Command* command : commands()) text += zsh_command(*command);
    return text + "    esac\n}\n_tactics \"$@\"\n";
}

std::string fish_completion() {
    std::string text =
        "# fish completion for tactics; made by: tactics completion fish\n"
        "complete -c tactics -n __fish_use_subcommand -f -s h -l help -d 'show the help'\n"
        "complete -c tactics -n __fish_use_subcommand -f -s V -l version -d 'show the version'\n";
    for (const Command* command : commands()) text += fish_command(*command);
    return text;
}

}  // namespace tactics
