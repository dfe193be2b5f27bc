// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <new>

#include "cli/command.h"
#include "cli/help/describe.h"
#include "cli/help/thing_texts.h"
#include "cli/kept_choices.h"
#include "cli/report/say.h"
#include "cli/report/wrapped_help.h"
#include "cli/verbs/cups_driver.h"
#include "cli/verbs/cups_filter.h"
#include "cli/verbs/ppd.h"
#include "tactics/error.h"

namespace tactics {

namespace {

[[noreturn]] void refuse_unknown(const std::string& word) {
    std::vector<std::string_view> names{"--version", "--help"};
    for (const Command* command : commands()) names.push_back(command->name);
    const bool file = word.find_first_of("./") != std::string::npos;
    throw Error(Fault::usage, "",
                file ? phrase("there is no command {0}{1}; to make a page from a picture: tactics convert {0} -o page.pdf",
                              word.substr(0, 80), did_you_mean(word, names))
                     : phrase("there is no command {0}{1}; see tactics --help", word.substr(0, 80), did_you_mean(word, names)));
}

int dispatch(const std::vector<std::string>& words) {
    if (words.empty()) {
        say(phrase("tactics: no command; for example: tactics convert photo.jpg -o photo.pdf; see tactics --help"));
        return static_cast<int>(Fault::usage);
    }
    if (words[0] == "--version" || words[0] == "-V") {
        print_out("tactics " TACTICS_VERSION "\n");
        return 0;
    }
    if (words[0] == "--help" || words[0] == "-h") {
        print_help(describe_program());
        return 0;
    }
    const Command* command = find_command(words[0]);
    if (command == nullptr) refuse_unknown(words[0]);
    Given given = parse_words(*command, {words.begin() + 1, words.end()});
    if (given.has("--help")) {
        print_help(explain_command(*command));
        return 0;
    }
    if (command->takes_kept && !given.has("--no-defaults")) take_kept_choices(given);
    return command->run(given);
}

}  // namespace

int run_program(int count, char** words) {
    spell_wishes_with("--");
    Fault fault = Fault::failed;
    Phrase message;
    try {
        const std::vector<std::string> given(words + (count > 0 ? 1 : 0), words + count);
        if (is_started_as(kCupsFilterName)) return run_cups_filter(given);
        if (is_started_as(kCupsDriverName)) return run_cups_driver(given);
        return dispatch(given);
    } catch (const Error& error) {
        fault = error.fault();
        message = error.told();
    } catch (const std::bad_alloc&) {
        message = phrase("there is not enough memory");
    } catch (const std::exception& error) {
        message = phrase("this should not happen, please report it: {0}", error.what());
    }
    say(phrase("tactics: {0}", message));
    return static_cast<int>(fault);
}

}  // namespace tactics
