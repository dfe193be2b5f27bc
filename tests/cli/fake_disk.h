// SPDX-License-Identifier: Apache-2.0
// A file system that is only a list of names, for planning without a disk.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>

#include "tactics/error.h"
#include "tactics/job/disk.h"

namespace tactics::tests {

struct FakeDisk {
    std::set<std::string> folders;
    std::map<std::string, std::string> files;  ///< name -> text

    Disk disk() const {
        Disk door;
        door.is_folder = [this](const std::string& path) { return folders.contains(path); };
        door.exists = [this](const std::string& path) { return folders.contains(path) || files.contains(path); };
        door.identity = [](const std::string& path) { return std::filesystem::path(path).lexically_normal().string(); };
        door.read_text = [this](const std::string& path) {
            const auto file = files.find(path);
            if (file == files.end()) throw Error(Fault::failed, path, "there is no such file");
            return file->second;
        };
        return door;
    }
};

/// The message of the error that `work` throws, with its exit code in front: "1 PLACE: message"; or "no error".
template <typename Work>
std::string error_of(const Work& work) {
    try {
        work();
    } catch (const Error& error) {
        return std::to_string(static_cast<int>(error.fault())) + " " + error.what();
    }
    return "no error";
}

}  // namespace tactics::tests
