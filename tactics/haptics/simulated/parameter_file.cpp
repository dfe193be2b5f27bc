// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/simulated/parameter_file.h"

#include <algorithm>
#include <set>
#include <vector>

#include "tactics/error.h"
#include "tactics/text/words.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr std::size_t kMostBytes = 64 * 1024;

Phrase range_of(const FileParameter& parameter) {
    return phrase("{0} to {1} {2}", to_text(parameter.least), to_text(parameter.most), parameter.unit);
}

double value_in(const FileParameter& parameter, std::string_view text, const std::string& place) {
    const std::size_t blank = text.find_first_of(kBlanks);
    const auto value = parse_number(text.substr(0, blank));
    const std::string_view unit = blank == std::string_view::npos ? std::string_view{} : trimmed(text.substr(blank));
    const std::string name(parameter.name);
    if (!value) throw Error(Fault::usage, place, phrase("{0} is no number (give {1})", name, range_of(parameter)));
    if (unit != parameter.unit)
        throw Error(Fault::usage, place, phrase("{0} has no unit that fits (give {1})", name, range_of(parameter)));
    if (*value < parameter.least || *value > parameter.most)
        throw Error(Fault::usage, place, phrase("{0} is out of range (give {1})", name, range_of(parameter)));
    return *value;
}

using Seen = std::set<std::string, std::less<>>;

void read_line(std::string_view line, const ParameterFile& file, Seen& seen, const std::string& place) {
    const std::size_t equals = line.find('=');
    if (equals == std::string_view::npos) throw Error(Fault::usage, place, phrase("no \"=\" (write NAME = VALUE UNIT)"));
    const std::string_view name = trimmed(line.substr(0, equals)), text = trimmed(line.substr(equals + 1));
    if (!seen.emplace(name).second) throw Error(Fault::usage, place, phrase("{0} is given twice (take one of them out)", name));
    if (std::find(file.presets.begin(), file.presets.end(), name) != file.presets.end()) {
        const auto later = seen.lower_bound(std::string(name) + ".");
        if (later != seen.end() && later->starts_with(std::string(name) + "."))
            throw Error(Fault::usage, place, phrase("{0} would undo {1} above it (put it first)", name, *later));
        file.take(name, text, place);
        return;
    }
    const auto known =
        std::find_if(file.parameters.begin(), file.parameters.end(), [&](const FileParameter& p) { return p.name == name; });
    if (known == file.parameters.end()) {
        std::vector<std::string_view> names(file.presets.begin(), file.presets.end());
        for (const FileParameter& parameter : file.parameters) names.push_back(parameter.name);
        throw Error(Fault::usage, place, phrase("{0} has no \"{1}\"{2}", file.of, name, did_you_mean(name, names)));
    }
    file.set(static_cast<std::size_t>(known - file.parameters.begin()), value_in(*known, text, place));
}

}  // namespace

void read_parameters(std::string_view text, std::string_view origin, const ParameterFile& file) {
    if (text.size() > kMostBytes)
        throw Error(Fault::usage, origin, phrase("longer than any file of parameters (give one of at most 64 kB)"));
    Seen seen;
    for (std::size_t number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = trimmed(text.substr(0, std::min(end, text.find('#'))));
        text.remove_prefix(std::min(end + 1, text.size()));
        if (!line.empty()) read_line(line, file, seen, std::string(origin) + ":" + std::to_string(number));
    }
}

std::string parameter_line(const FileParameter& parameter, double value) {
    return std::string(parameter.name) + " = " + to_text(value) + " " + std::string(parameter.unit) + "  # " +
           range_of(parameter).english() + "; " + std::string(parameter.what) + "\n";
}

void no_preset(std::string_view what, std::string_view name, std::span<const std::string_view> names, const std::string& place) {
    throw Error(Fault::usage, place,
                phrase("no {0} is called \"{1}\"{2}", what, name, did_you_mean(name, {names.begin(), names.end()})));
}

}  // namespace tactics
