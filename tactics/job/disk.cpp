// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/disk.h"

#include <sys/stat.h>

#include <filesystem>

#include "tactics/error.h"
#include "tactics/readers/read.h"
#include "tactics/recipe.h"

namespace tactics {

namespace {

std::string file_number(const std::string& path) {
    struct stat facts {};
    if (stat(path.c_str(), &facts) != 0) return "";
    return std::to_string(facts.st_dev) + ":" + std::to_string(facts.st_ino);
}

std::string identity(const std::string& path) {
    std::string number = file_number(path);
    if (!number.empty()) return number;
    // Not there yet: its folder and its name.
    const std::filesystem::path clean = std::filesystem::path(path).lexically_normal();
    const std::string folder = clean.parent_path().empty() ? "." : clean.parent_path().string();
    number = file_number(folder);
    return (number.empty() ? folder : number) + "/" + clean.filename().string();
}

std::string read_text(const std::string& path) {
    const Source source = open_source(path);
    std::string text(kMaxRecipeBytes + 1, '\0');  // one byte more tells that it is too long
    text.resize(std::fread(text.data(), 1, text.size(), source.file.get()));
    if (std::ferror(source.file.get()) != 0) throw Error(Fault::failed, path, phrase("it cannot be read"));
    return text;
}

}  // namespace

Disk real_disk() {
    Disk disk;
    disk.is_folder = [](const std::string& path) {
        struct stat facts {};
        return stat(path.c_str(), &facts) == 0 && S_ISDIR(facts.st_mode);
    };
    disk.exists = [](const std::string& path) {
        struct stat facts {};
        return stat(path.c_str(), &facts) == 0;
    };
    disk.identity = identity;
    disk.read_text = read_text;
    return disk;
}

}  // namespace tactics
