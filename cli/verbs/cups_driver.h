// SPDX-License-Identifier: Apache-2.0
// The program as a CUPS driver: called as tacticsdriver, it lists the embossers and prints their PPD files, so that lpinfo -m and
// lpadmin -m offer them and users need no files.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace tactics {

/// The name under which CUPS starts it, and the scheme of its URIs: "tacticsdriver://index-v4".
inline constexpr std::string_view kCupsDriverName = "tacticsdriver";

/// `words` are "list", or "cat" and a URI, as cups-driverd passes them. Throws Error(usage) for anything else.
int run_cups_driver(std::span<const std::string> words);

}  // namespace tactics
