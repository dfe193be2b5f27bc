// SPDX-License-Identifier: Apache-2.0
// The file system as planning needs it, so that tests and fuzzing can plan without one.
#pragma once

#include <functional>
#include <string>

namespace tactics {

struct Disk {
    std::function<bool(const std::string& path)> is_folder;
    std::function<bool(const std::string& path)> exists;
    /// Gives the same text for two names of one file ("a.png", "./a.png", a link to it), whether it exists yet or not.
    std::function<std::string(const std::string& path)> identity;
    /// A whole small text file. Throws Error(failed).
    std::function<std::string(const std::string& path)> read_text;
};

Disk real_disk();

}  // namespace tactics
