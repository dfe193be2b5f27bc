// SPDX-License-Identifier: Apache-2.0
// Text files of named numbers with units, one a line, that anyone can change: `lever.mass = 30 g  # weighed`.
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

/// What a file is about, for its messages and its words.
struct ParameterFile {
    std::string_view of;                        ///< "a mouse"
    std::span<const std::string_view> presets;  ///< names that take a word: it stands before what changes parts of it
    std::span<const FileParameter> parameters;
    std::function<void(std::string_view name, std::string_view word, const std::string& place)>
        take;                                                  ///< of a preset; throws Error
    std::function<void(std::size_t index, double value)> set;  ///< of a parameter
};

/// `#` starts a comment. Throws Error(usage) at `origin` and line: no such name, a number, unit or range that does not fit, twice
/// the same, a preset that would undo what stands above it, over 64 kB.
void read_parameters(std::string_view text, std::string_view origin, const ParameterFile& file);

/// A line of such a file, with range and meaning behind it.
std::string parameter_line(const FileParameter& parameter, double value);

[[noreturn]] void no_preset(std::string_view what, std::string_view name, std::span<const std::string_view> names,
                            const std::string& place);

/// Of entries with a `name`, the one of that name. Throws Error(usage) at `place`, with the nearest.
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
