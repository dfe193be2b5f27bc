// SPDX-License-Identifier: Apache-2.0
// `tactics completion`: scripts for the shells.
#include "cli/command.h"
#include "cli/help/shells.h"
#include "cli/report/say.h"
#include "tactics/error.h"

namespace tactics {

namespace {

int run_completion(const Given& given) {
    if (given.words.size() != 1) throw Error(Fault::usage, "completion", phrase("name one shell: bash, zsh or fish"));
    const std::string& shell = given.words[0];
    if (shell == "bash")
        print_out(bash_completion());
    else if (shell == "zsh")
        print_out(zsh_completion());
    else if (shell == "fish")
        print_out(fish_completion());
    else
        throw Error(Fault::usage, "completion", phrase("there is none for \"{0}\"; name bash, zsh or fish", shell.substr(0, 80)));
    return 0;
}

}  // namespace

extern const Command completion_command;
const Command completion_command{
    .name = "completion",
    .summary = "write a shell script that completes tactics command lines",
    .words = "bash|zsh|fish",
    .details =
        "An installed tactics has these scripts in place. For a program that was built but not installed, load the script as "
        "shown below.",
    .example =
        "source <(tactics completion bash)\n"
        "tactics completion zsh > ~/.zfunc/_tactics\n"
        "tactics completion fish > ~/.config/fish/completions/tactics.fish",
    .offers = "bash zsh fish",
    .run = run_completion,
};

}  // namespace tactics
