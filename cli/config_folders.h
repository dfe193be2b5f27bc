// SPDX-License-Identifier: Apache-2.0
// The folders in which users and machines keep choices, by the XDG Base Directory Specification (0.8).
#pragma once

#include <string>
#include <vector>

namespace tactics {

/// The user's own: $XDG_CONFIG_HOME/tactics, or ~/.config/tactics; empty if the environment names neither. It need not exist.
std::string own_config_folder();

/// That folder, then those for all users, the most important first: tactics in each of $XDG_CONFIG_DIRS, or /etc/xdg/tactics.
/// Relative paths are ignored, as the specification requires.
std::vector<std::string> config_folders();

}  // namespace tactics
