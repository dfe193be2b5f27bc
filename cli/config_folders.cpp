// SPDX-License-Identifier: Apache-2.0
#include "cli/config_folders.h"

#include <algorithm>
#include <cstdlib>
#include <string_view>

namespace tactics {

namespace {

std::string_view environment(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
}

std::string within(std::string_view folder) {
    while (folder.size() > 1 && folder.back() == '/') folder.remove_suffix(1);
    return std::string(folder) + "/tactics";
}

}  // namespace

std::string own_config_folder() {
    if (const auto config = environment("XDG_CONFIG_HOME"); config.starts_with('/')) return within(config);
    if (const auto home = environment("HOME"); home.starts_with('/')) return within(std::string(home) + "/.config");
    return "";
}

std::vector<std::string> config_folders() {
    std::vector<std::string> folders;
    const auto add = [&](std::string folder) {
        if (!folder.empty() && std::find(folders.begin(), folders.end(), folder) == folders.end())
            folders.push_back(std::move(folder));
    };
    add(own_config_folder());
    std::string_view rest = environment("XDG_CONFIG_DIRS");
    if (rest.empty()) rest = "/etc/xdg";
    while (!rest.empty()) {
        const auto colon = std::min(rest.find(':'), rest.size());
        if (const auto folder = rest.substr(0, colon); folder.starts_with('/')) add(within(folder));
        rest.remove_prefix(std::min(colon + 1, rest.size()));
    }
    return folders;
}

}  // namespace tactics
