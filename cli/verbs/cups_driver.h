// SPDX-License-Identifier: Apache-2.0
// The program as a driver of CUPS: called as tacticsdriver it lists the embossers and gives their PPD files, so that lpinfo -m
// and lpadmin -m know them and nobody handles files.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace tactics {

/// The name that CUPS calls it by, and the scheme of its addresses: "tacticsdriver://index-v4".
inline constexpr std::string_view kCupsDriverName = "tacticsdriver";

/// `words` are "list", or "cat" and an address (CUPS's interface of drivers, as cups-driverd calls them). Throws Error(usage).
int run_cups_driver(std::span<const std::string> words);

}  // namespace tactics
