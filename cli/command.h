// What a command (a verb of the command line) says of itself. One thin file each, one line each in list.inc.
#pragma once

#include <span>
#include <string_view>

namespace CLI {
class App;
}

namespace tactics {

struct Command {
    std::string_view name;
    std::string_view summary;  ///< one line, lower case, no period
    /// Adds the command's options to its sub-command and says, as the sub-command's callback, what to do.
    void (*describe)(CLI::App& command) = nullptr;
};

std::span<const Command* const> commands();

/// The whole program: parses, runs, prints errors. Gives the exit code.
int run_program(int count, char** words);

}  // namespace tactics
