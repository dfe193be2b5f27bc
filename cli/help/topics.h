// SPDX-License-Identifier: Apache-2.0
// What help explains besides the entries of the lists: what somebody needs who builds or describes a machine.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace tactics {

struct Topic {
    std::string_view name;  ///< as it is typed behind `tactics help`
    std::string_view summary;
    std::string (*text)();  ///< lines of at most 80 characters
};

std::span<const Topic> topics();
const Topic* find_topic(std::string_view name);  ///< nullptr if there is none

}  // namespace tactics
