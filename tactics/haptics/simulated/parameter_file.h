// SPDX-License-Identifier: Apache-2.0
// Text files of named numbers with units, one per line, that anyone can edit: `lever.mass = 30 g # weighed`.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tactics {

struct FileParameter {
    std::string_view name;
    std::string_view unit;
    double least, most;
    std::string_view what;
};

/// The subject of a file, for its messages and its words.
struct ParameterFile {
    std::string_view of;                        ///< "a mouse"
    std::span<const std::string_view> presets;  ///< names that take a word; they come before settings that change parts of the
                                                ///< preset
    std::span<const FileParameter> parameters;
    std::function<void(std::string_view name, std::string_view word, const std::string& place)>
        take;                                                  ///< called for a preset; throws Error
    std::function<void(std::size_t index, double value)> set;  ///< called for a parameter
};

/// `#` starts a comment. Throws Error(usage) at `origin` and line for an unknown name, an invalid number, unit or range, a
/// repeated name, a preset that would undo earlier lines, and more than 64 kB.
void read_parameters(std::string_view text, std::string_view origin, const ParameterFile& file);

/// A line of such a file, followed by range and meaning.
std::string parameter_line(const FileParameter& parameter, double value);

[[noreturn]] void no_preset(std::string_view what, std::string_view name, std::span<const std::string_view> names,
                            const std::string& place);

/// The entry with that `name`. Throws Error(usage) at `place`, with the nearest name.
template <typename Presets>
const auto& preset(const Presets& presets, std::string_view name, const std::string& place, std::string_view what) {
    std::vector<std::string_view> names;
    for (const auto& entry : presets) {
        if (entry.name == name) return entry;
        names.push_back(entry.name);
    }
    no_preset(what, name, names, place);
}

}  // namespace tactics
