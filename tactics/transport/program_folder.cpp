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

std::string own_program(std::string_view name) {
    const std::string program = folder_of_program();
    for (const std::string& folder : {program, program + "/" TACTICS_PROGRAMS}) {
        std::string path = folder + '/' + std::string(name);
        if (!program.empty() && access(path.c_str(), X_OK) == 0) return path;
    }
    return "";
}

}  // namespace tactics
