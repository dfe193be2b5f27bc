// SPDX-License-Identifier: Apache-2.0
// Where a person and a machine keep choices, as the XDG Base Directory Specification (0.8) has it.
#pragma once

#include <string>
#include <vector>

namespace tactics {

/// The person's own: $XDG_CONFIG_HOME/tactics, or ~/.config/tactics; empty if the environment names neither. It need not exist.
std::string own_config_folder();

/// That folder, then those for everybody, the most important first: tactics in each of $XDG_CONFIG_DIRS, or /etc/xdg/tactics.
/// Paths that do not begin at the root are passed over, as the specification asks.
std::vector<std::string> config_folders();

}  // namespace tactics
