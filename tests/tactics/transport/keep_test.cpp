// SPDX-License-Identifier: Apache-2.0
// What is called done is on the disk: the order in which files, names and folders are handed to it, as the kernel sees the calls;
// and what dead processes leave.
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>

#include <array>
#include <cerrno>
#include <climits>
#include <mutex>

#include "tests/tactics/transport/own_folder.h"

namespace tactics::keep_test {
namespace {

std::mutex calls_mutex;
std::vector<std::string>* calls = nullptr;  // nullptr: no listener
int refused_with = 0;                       // what fsync answers

void note(const std::string& call) {
    const std::lock_guard lock(calls_mutex);
    if (calls != nullptr) calls->push_back(call);
}

std::string last_of(const std::string& path) { return path.substr(path.rfind('/') + 1); }

}  // namespace

// In place of the C library's, for the whole test program; it does the same.
extern "C" int fsync(int number) {
    std::array<char, PATH_MAX> path{};
    struct stat file {};
    if (fstat(number, &file) == 0 && readlink(("/proc/self/fd/" + std::to_string(number)).c_str(), path.data(), PATH_MAX - 1) > 0)
        note(std::string("keep ") + (S_ISDIR(file.st_mode) ? "folder " : "file ") + std::to_string(file.st_size));
    if (refused_with != 0) {
        errno = refused_with;
        return -1;
    }
    return static_cast<int>(syscall(SYS_fsync, number));
}

extern "C" int rename(const char* from, const char* to) noexcept {
    note("name " + last_of(to));
    return static_cast<int>(syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0));
}

namespace {

using namespace tests;

class Kept : public File {
protected:
    void SetUp() override {
        File::SetUp();
        calls = &seen_;
        refused_with = 0;
    }
    void TearDown() override {
        calls = nullptr;
        refused_with = 0;
        File::TearDown();
    }
    // Without sizes of folders, which are the file system's own.
    std::vector<std::string> seen() const {
        std::vector<std::string> all = seen_;
        for (std::string& call : all)
            if (call.starts_with("keep folder")) call = "keep folder";
        return all;
    }
    std::vector<std::string> seen_;
};

TEST_F(Kept, AFileThenItsNameThenTheFolder) {
    write_file(in("page"), "12345");
    EXPECT_EQ(seen(), (std::vector<std::string>{"keep file 5", "name page", "keep folder"}));
}

TEST_F(Kept, NoNameBeforeAllFilesAndTheFirstNameLast) {
    write_files({{in("page.png"), "1"}, {in("page-2.png"), "22"}, {in("page-3.png"), "333"}});
    EXPECT_EQ(seen(), (std::vector<std::string>{"keep file 1", "keep file 2", "keep file 3", "name page-3.png", "name page-2.png",
                                                "name page.png", "keep folder"}));
}

TEST_F(Kept, BySystemNothingIsWaitedFor) {
    NewFiles files(Keep::by_system);
    files.add(in("page"), "1");
    files.take_names();
    EXPECT_EQ(seen(), std::vector<std::string>{"name page"});
    EXPECT_EQ(read(in("page")), "1");
}

TEST_F(Kept, ADiskThatFailsIsAnErrorAndLeavesTheOldFile) {
    write_file(in("page"), "old");
    refused_with = EIO;
    EXPECT_NE(message_of(in("page")).find("cannot be written"), std::string::npos);
    refused_with = ENOSPC;
    EXPECT_NE(message_of(in("new")).find("no space left"), std::string::npos);
    refused_with = EINVAL;  // a file system that keeps nothing, such as one in memory
    EXPECT_EQ(message_of(in("page"), "memory"), "no error");
    EXPECT_EQ(names(), std::vector<std::string>{"page"});
    EXPECT_EQ(read(in("page")), "memory");
}

int open_descriptors() {
    const auto all = std::filesystem::directory_iterator("/proc/self/fd");
    return static_cast<int>(std::distance(begin(all), end(all)));
}

TEST_F(Kept, ManyFilesNeedFewDescriptors) {
    const int before = open_descriptors();
    NewFiles files(Keep::by_system);
    for (int i = 0; i < 2000; ++i) {
        files.add(in("page-" + std::to_string(i)), std::to_string(i));
        ASSERT_LT(open_descriptors(), before + 40);
    }
    files.take_names();
    EXPECT_EQ(names().size(), 2000u);
    EXPECT_EQ(read(in("page-1999")), "1999");
}

TEST_F(Kept, OfManyFilesThatAreGivenUpNoneStays) {
    {
        NewFiles files(Keep::by_system);
        for (int i = 0; i < 100; ++i) files.add(in("page-" + std::to_string(i)), "1");
    }
    EXPECT_EQ(names(), std::vector<std::string>{});
}

// A child that is killed in the middle leaves names; the next that writes many files there takes them away, and no others.
TEST_F(Kept, WhatADeadProcessLeftIsTakenAwayAndNothingOfALivingOne) {
    const auto write_many = [&] {
        NewFiles files(Keep::by_system);
        for (int i = 0; i < 40; ++i) files.add(in("page-" + std::to_string(i)), "1");
        files.take_names();
    };
    std::array<int, 2> ready{};
    ASSERT_EQ(pipe(ready.data()), 0);
    const pid_t child = fork();
    if (child == 0) {
        NewFiles files(Keep::by_system);
        for (int i = 0; i < 40; ++i) files.add(in("child-" + std::to_string(i)), "1");
        static_cast<void>(!::write(ready[1], "x", 1));
        for (;;) pause();
    }
    char word = 0;
    ASSERT_EQ(::read(ready[0], &word, 1), 1);
    const std::size_t left = names().size();
    EXPECT_GT(left, 0u);
    for (const char* own : {".tactics-notes", ".tactics-1-2-3", ".tactics-0-1-2-x", "tactics-0-1-2-3"})
        std::ofstream(in(own)) << "mine";
    EXPECT_EQ(in_child([&] {
                  write_many();
                  return names().size() == left + 4 + 40 ? 0 : 1;
              }),
              0)
        << "the child lives";
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    EXPECT_EQ(in_child([&] {
                  write_many();
                  return names().size() == 4 + 40 ? 0 : 1;
              }),
              0);
    close(ready[0]);
    close(ready[1]);
}

}  // namespace
}  // namespace tactics::keep_test
