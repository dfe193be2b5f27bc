// SPDX-License-Identifier: Apache-2.0
#include "cli/choice_value.h"

#include <algorithm>
#include <string>

#include "tactics/error.h"
#include "tactics/text/words.h"

namespace tactics {

std::optional<std::size_t> choice_value(const Given& given, std::string_view name, const std::vector<std::string_view>& words) {
    if (!given.has(name)) return std::nullopt;
    const std::string text = given.value(name);
    const auto found = std::find(words.begin(), words.end(), text);
    if (found == words.end())
        throw Error(Fault::usage, name,
                    phrase("it cannot be \"{0}\"{1}; it is {2}", text.substr(0, 80), did_you_mean(text, words),
                           either_of({words.begin(), words.end()})));
    return static_cast<std::size_t>(found - words.begin());
}

}  // namespace tactics
