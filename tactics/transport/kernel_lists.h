// SPDX-License-Identifier: Apache-2.0
// Reads the kernel's small files about devices below /sys, for all lists of devices.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tactics/text/phrase.h"

namespace tactics {

/// A small file as one line; empty if it is not there.
std::string line_of(const std::filesystem::path& path);

/// Sorted by name; none if there is no such folder.
std::vector<std::filesystem::path> entries_of(const std::filesystem::path& folder);

/// Maker and product of the USB device that an interface, or what hangs on it, belongs to.
std::string product_of(const std::filesystem::path& place);

/// That a device below `root` is not there; empty: it is.
Phrase note_if_missing(const std::string& root, const std::string& path);

/// Why a device below `root` cannot be used, and what to do; empty: it can.
Phrase note_for(const std::string& root, const std::string& path, std::string_view group);

}  // namespace tactics
