// SPDX-License-Identifier: Apache-2.0
#include "tactics/transport/program_folder.h"

#include <unistd.h>

#include <array>
#include <charconv>
#include <climits>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <string_view>
#include <vector>

namespace tactics {

namespace {

std::string parent_of(std::string_view path) {
    const auto slash = path.rfind('/');
    return std::string(path.substr(0, slash == std::string_view::npos ? 0 : slash));
}

// From /proc/self/maps, "55d0-55d4 r-xp 00000000 08:01 123   /usr/lib/libtactics.so.0.1.0": the kernel's own word, which stays
// right when a program has loaded the library by a relative path and then changed its folder.
std::string file_with(std::uintptr_t address) {
    std::ifstream maps("/proc/self/maps");
    for (std::string line; std::getline(maps, line);) {
        const auto dash = line.find('-'), space = line.find(' '), slash = line.find('/');
        if (dash == std::string::npos || space == std::string::npos || dash > space) continue;
        std::uintptr_t begin = 0, end = 0;
        std::from_chars(line.data(), line.data() + dash, begin, 16);
        std::from_chars(line.data() + dash + 1, line.data() + space, end, 16);
        if (address >= begin && address < end) return slash == std::string::npos ? "" : line.substr(slash);
    }
    return "";
}

}  // namespace

std::string folder_of_program() {
    std::array<char, PATH_MAX> path{};
    const auto size = readlink("/proc/self/exe", path.data(), path.size());
    return parent_of(std::string_view(path.data(), size > 0 ? static_cast<std::size_t>(size) : 0));
}

std::string folder_of_library() {
    static const std::string kFolder = parent_of(file_with(reinterpret_cast<std::uintptr_t>(&folder_of_library)));
    return kFolder;
}

std::string own_program(std::string_view name) {
    const std::string program = folder_of_program(), library = folder_of_library();
    std::vector<std::string> folders;
    // Not for a program that has more rights than its user.
    if (const char* named = secure_getenv("TACTICS_PROGRAMS"); named != nullptr && *named != '\0') folders.emplace_back(named);
    if (!program.empty()) folders.insert(folders.end(), {program, program + "/" TACTICS_PROGRAMS});
    if (!library.empty() && library != program) folders.insert(folders.end(), {library, library + "/tactics"});
    // The library may be linked into a program of another place.
    folders.insert(folders.end(), {TACTICS_PROGRAMS_INSTALLED, "/usr/local/lib/tactics", "/usr/lib/tactics"});
    for (const std::string& folder : folders) {
        std::string path = folder + '/' + std::string(name);
        if (access(path.c_str(), X_OK) == 0) return path;
    }
    return "";
}

}  // namespace tactics
