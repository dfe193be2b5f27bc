// SPDX-License-Identifier: Apache-2.0
// A folder of its own for each test of files, and children that may break their view of the machine.
#pragma once

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "tactics/error.h"
#include "tactics/transport/file.h"

namespace tactics::tests {

class File : public testing::Test {
protected:
    void SetUp() override {
        std::string name = testing::TempDir() + "tactics-file-XXXXXX";
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        folder_ = name;
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }
    std::string in(const std::string& name) const { return folder_ + "/" + name; }
    std::vector<std::string> names() const {
        std::vector<std::string> found;
        for (const auto& entry : std::filesystem::directory_iterator(folder_)) found.push_back(entry.path().filename());
        std::sort(found.begin(), found.end());
        return found;
    }
    std::string folder_;
};

inline std::string read(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

inline std::string message_of(const std::string& path, std::string_view bytes = "new") {
    try {
        write_file(path, bytes);
    } catch (const Error& error) {
        EXPECT_EQ(error.fault(), Fault::failed);
        return error.what();
    }
    return "no error";
}

inline mode_t mode_of(const std::string& path) {
    struct stat status {};
    EXPECT_EQ(stat(path.c_str(), &status), 0) << path;
    return status.st_mode & 07777;
}

inline constexpr int kCannot = 77;  // a child's answer: this machine does not let me

// Runs `task` in a child process; its exit code, or 1000 + the signal that ended it.
inline int in_child(const std::function<int()>& task) {
    const pid_t child = fork();
    if (child == 0) {
        try {
            _exit(task());
        } catch (const std::exception& error) {
            std::fprintf(stderr, "in the child: %s\n", error.what());
            _exit(99);
        }
    }
    int status = 0;
    while (waitpid(child, &status, 0) < 0) {
    }
    return WIFSIGNALED(status) ? 1000 + WTERMSIG(status) : WEXITSTATUS(status);
}

// In a child: a file system of its own over `folder`, or over /proc an empty one.
inline bool mount_over(const std::string& folder, const char* size) {
    return unshare(CLONE_NEWNS) == 0 && mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
           mount("none", folder.c_str(), "tmpfs", 0, size) == 0;
}

// Without /proc a file without a name cannot be given one, so the other road is taken.
inline bool hide_proc() { return mount_over("/proc", "size=4k"); }

}  // namespace tactics::tests
