// SPDX-License-Identifier: Apache-2.0
#include "cli/command.h"

#include <stdexcept>

namespace tactics {

#define COMMAND(name) extern const Command name##_command;
#include "cli/list.inc"
#undef COMMAND

std::span<const Command* const> commands() {
    static const Command* const kCommands[] = {
#define COMMAND(name) &name##_command,
#include "cli/list.inc"
#undef COMMAND
    };
    return kCommands;
}

const Command* find_command(std::string_view name) {
    for (const Command* command : commands())
        if (command->name == name) return command;
    return nullptr;
}

Given::Given(std::span<const Flag> flags) {
    for (const Flag& flag : flags) values_.push_back({flag.name, {}});
    values_.push_back({kHelpFlag.name, {}});
}

const std::vector<std::string>& Given::all(std::string_view name) const {
    for (const auto& [flag, values] : values_)
        if (flag == name) return values;
    throw std::logic_error("no option " + std::string(name));  // a command asks for what it did not describe
}

std::string Given::value(std::string_view name, std::string_view fallback) const {
    const auto& values = all(name);
    return values.empty() ? std::string(fallback) : values.back();
}

void Given::add(std::string_view name, std::string value) {
    for (auto& [flag, values] : values_)
        if (flag == name) return values.push_back(std::move(value));
    throw std::logic_error("no option " + std::string(name));
}

Given handed_on(const Given& given, const Command& command, std::span<const std::string_view> names) {
    Given same(command.flags);
    for (const std::string_view name : names)
        for (const std::string& value : given.all(name)) same.add(name, value);
    return same;
}

}  // namespace tactics
