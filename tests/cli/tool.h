// SPDX-License-Identifier: Apache-2.0
// Runs the real program, or another one, as a person or a script would.
#pragma once

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace tactics::tests {

using Words = std::vector<std::string>;

inline bool holds(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

inline std::string bytes_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

inline void write_bytes(const std::filesystem::path& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
}

/// A folder of its own for each test, gone after it.
class Folder {
public:
    Folder() {
        std::string name = (std::filesystem::temp_directory_path() / "tactics-test-XXXXXX").string();
        path_ = mkdtemp(name.data());
    }
    ~Folder() { std::filesystem::remove_all(path_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

struct Ending {
    int code = -1;  ///< exit code; 128 + signal if one ended it
    std::string out;
    std::string err;
};

/// Starts `words` in that folder; standard input, output and error are the files in, out and err beside it.
inline pid_t start(const Folder& folder, std::vector<std::string> words, const std::filesystem::path& streams,
                   const std::string& input) {
    write_bytes(streams / "in", input);
    // What the person who runs the tests keeps is none of theirs; a test of that names its own folders with env.
    setenv("XDG_CONFIG_HOME", "/nonexistent", 1);
    setenv("XDG_CONFIG_DIRS", "/nonexistent", 1);
    // Nor is the language of their locale.
    unsetenv("LANGUAGE");
    setenv("LC_MESSAGES", "C", 1);
    unsetenv("LC_ALL");
    std::vector<char*> pointers;
    for (auto& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 0, (streams / "in").c_str(), O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 1, (streams / "out").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_addopen(&actions, 2, (streams / "err").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_addclosefrom_np(&actions, 3);  // the caller of the tests may have left more open
    posix_spawn_file_actions_addchdir_np(&actions, folder.path().c_str());
    pid_t id = -1;
    if (posix_spawnp(&id, pointers[0], &actions, nullptr, pointers.data(), environ) != 0) id = -1;
    posix_spawn_file_actions_destroy(&actions);
    return id;
}

inline Ending end_of(pid_t id, const std::filesystem::path& streams) {
    int status = 0;
    if (id < 0 || waitpid(id, &status, 0) != id) return {127, "", "it could not be started"};
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), bytes_of(streams / "out"),
            bytes_of(streams / "err")};
}

inline Ending run_tool(const Folder& folder, const std::vector<std::string>& words, const std::string& input = "") {
    const Folder streams;
    return end_of(start(folder, words, streams.path(), input), streams.path());
}

inline Ending run_tactics(const Folder& folder, std::vector<std::string> words, const std::string& input = "") {
    words.insert(words.begin(), TACTICS_PROGRAM);
    return run_tool(folder, words, input);
}

/// For GTEST_SKIP: is the program there?
inline bool has_tool(const std::string& name) {
    const Folder folder;
    return run_tool(folder, {"sh", "-c", "command -v " + name}).code == 0;
}

}  // namespace tactics::tests
