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
    values_.push_back({kNoDefaultsFlag.name, {}});
    values_.push_back({kHelpFlag.name, {}});
}

const std::vector<std::string>& Given::all(std::string_view name) const {
    static const std::vector<std::string> kNone;
    for (const auto& [flag, values] : values_)
        if (flag == name) return values;
    return kNone;
}

std::string Given::value(std::string_view name, std::string_view fallback) const {
    const auto& values = all(name);
    return values.empty() ? std::string(fallback) : values.back();
}

const KeptValue* Given::kept(std::string_view word) const {
    if (has("--" + std::string(word))) return nullptr;
    for (const auto& [name, kept] : kept_)
        if (name == word) return &kept;
    return nullptr;
}

void Given::keep(std::string_view word, KeptValue kept) { kept_.emplace_back(word, std::move(kept)); }

std::vector<Flag> all_flags(const Command& command) {
    std::vector<Flag> flags(command.flags.begin(), command.flags.end());
    if (command.takes_kept) flags.push_back(kNoDefaultsFlag);
    flags.push_back(kHelpFlag);
    return flags;
}

void Given::add(std::string_view name, std::string value) {
    for (auto& [flag, values] : values_)
        if (flag == name) return values.push_back(std::move(value));
    throw std::logic_error("no option " + std::string(name));
}

}  // namespace tactics
