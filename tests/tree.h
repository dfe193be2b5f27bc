// SPDX-License-Identifier: Apache-2.0
// The files of the project, read once for the tests of its rules.
#pragma once

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "tests/patterns.h"

namespace tactics::tests {

namespace fs = std::filesystem;

struct SourceFile {
    std::string path;  ///< from the top of the tree
    std::string text;
};

inline std::string read(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

// What git tracks; without git (a released archive) everything but build folders and hidden ones.
inline std::vector<std::string> paths_of_tree() {
    std::vector<std::string> paths;
    const std::string root = TACTICS_SOURCE_DIR;
    if (fs::exists(root + "/.git") && root.find('\'') == std::string::npos)
        if (std::FILE* list = popen(("git -C '" + root + "' ls-files -co --exclude-standard 2>/dev/null").c_str(), "r");
            list != nullptr) {
            std::string line;
            for (int c = std::fgetc(list); c != EOF; c = std::fgetc(list)) {
                if (c != '\n') {
                    line += static_cast<char>(c);
                    continue;
                }
                paths.push_back(line);
                line.clear();
            }
            pclose(list);
        }
    if (!paths.empty()) return paths;
    for (auto at = fs::recursive_directory_iterator(root); at != fs::recursive_directory_iterator(); ++at) {
        const std::string name = at->path().filename().string();
        const bool skip = at->is_directory() && (name.starts_with("build") || name == ".git" || name == "out");
        if (skip)
            at.disable_recursion_pending();
        else if (at->is_regular_file())
            paths.push_back(fs::relative(at->path(), root).generic_string());
    }
    return paths;
}

inline const std::vector<SourceFile>& tree() {
    static const std::vector<SourceFile> kTree = [] {
        std::vector<SourceFile> files;
        for (const auto& path : paths_of_tree())
            if (fs::is_regular_file(fs::path(TACTICS_SOURCE_DIR) / path))
                files.push_back({path, read(fs::path(TACTICS_SOURCE_DIR) / path)});
        std::sort(files.begin(), files.end(), [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
        return files;
    }();
    return kTree;
}

inline bool is_source(const SourceFile& file) {
    return file.path.ends_with(".cpp") || file.path.ends_with(".h") || file.path.ends_with(".inc");
}

inline bool starts_with_any(std::string_view text, const std::vector<std::string_view>& starts) {
    return std::any_of(starts.begin(), starts.end(), [&](std::string_view start) { return text.starts_with(start); });
}

inline std::vector<std::string> includes_of(const SourceFile& file, char open) {
    std::vector<std::string> found;
    for (const Fit& include : all_fits(
             file.text, open == '<' ? R"(^[ \t]*#[ \t]*include[ \t]*<([^>]+)>)" : R"re(^[ \t]*#[ \t]*include[ \t]*"([^"]+)")re"))
        found.push_back(include[1]);
    return found;
}

}  // namespace tactics::tests
