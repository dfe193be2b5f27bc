// SPDX-License-Identifier: Apache-2.0
// Help topics besides the entries of the lists, for example for people who build or describe a machine.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace tactics {

struct Topic {
    std::string_view name;  ///< as typed after `tactics help`
    std::string_view summary;
    std::string (*text)();  ///< lines of at most 80 characters
};

std::span<const Topic> topics();
const Topic* find_topic(std::string_view name);  ///< nullptr if there is none

}  // namespace tactics
