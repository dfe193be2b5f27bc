// SPDX-License-Identifier: Apache-2.0
#include "tactics/transport/program_folder.h"

#include <unistd.h>

#include <array>
#include <climits>
#include <string_view>

namespace tactics {

std::string folder_of_program() {
    std::array<char, PATH_MAX> path{};
    const auto size = readlink("/proc/self/exe", path.data(), path.size());
    const std::string_view text(path.data(), size > 0 ? static_cast<std::size_t>(size) : 0);
    return std::string(text.substr(0, text.rfind('/') == std::string_view::npos ? 0 : text.rfind('/')));
}

}  // namespace tactics
