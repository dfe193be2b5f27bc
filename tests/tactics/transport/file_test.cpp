// SPDX-License-Identifier: Apache-2.0
#include "tactics/transport/file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <thread>

#include "tests/tactics/transport/own_folder.h"

namespace tactics::file_test {
namespace {

namespace fs = std::filesystem;
using namespace tests;

TEST_F(File, IsWrittenWhole) {
    std::string bytes(3'000'000, '\0');
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(i * 7 + i / 256);
    write_file(in("page.pdf"), bytes);
    EXPECT_EQ(read(in("page.pdf")), bytes);
    write_file(in("page.pdf"), "short");
    EXPECT_EQ(read(in("page.pdf")), "short");
    write_file(in("empty"), "");
    EXPECT_EQ(fs::file_size(in("empty")), 0u);
    EXPECT_EQ(names(), (std::vector<std::string>{"empty", "page.pdf"}));
}

TEST_F(File, RelativeNamesAreInTheCurrentFolder) {
    EXPECT_EQ(in_child([&] {
                  if (chdir(folder_.c_str()) != 0) return kCannot;
                  write_file("page.pdf", "one");
                  write_file("./page.pdf", "two");
                  return read("page.pdf") == "two" ? 0 : 1;
              }),
              0);
    EXPECT_EQ(names(), std::vector<std::string>{"page.pdf"});
}

TEST_F(File, PermissionsAreTheUmasksOrTheOldOnes) {
    const mode_t before = umask(027);
    write_file(in("new"), "new");
    umask(before);
    EXPECT_EQ(mode_of(in("new")), 0640u);
    chmod(in("new").c_str(), 0604);
    write_file(in("new"), "again");
    EXPECT_EQ(mode_of(in("new")), 0604u);
}

TEST_F(File, LinksStayLinks) {
    fs::create_directory(in("pages"));
    write_file(in("pages/real"), "old");
    fs::create_symlink("pages/real", in("link"));
    fs::create_symlink(in("link"), in("second"));
    write_file(in("second"), "new");
    EXPECT_EQ(read(in("pages/real")), "new");
    fs::create_symlink("pages/later", in("dangling"));
    write_file(in("dangling"), "made");
    EXPECT_EQ(read(in("pages/later")), "made");
    for (const char* link : {"link", "second", "dangling"}) EXPECT_TRUE(fs::is_symlink(in(link))) << link;
    fs::create_symlink("round", in("round"));
    EXPECT_EQ(message_of(in("round")), in("round") + ": this symbolic link leads round in a circle; remove it");
    fs::create_symlink("nowhere/page", in("lost"));
    EXPECT_EQ(message_of(in("lost")),
              in("lost") + ": there is no folder " + folder_ + "/nowhere; make it first: mkdir -p " + folder_ + "/nowhere");
    EXPECT_EQ(names(), (std::vector<std::string>{"dangling", "link", "lost", "pages", "round", "second"}));
}

TEST_F(File, SaysWhatIsWrongAndHowToMendIt) {
    EXPECT_EQ(message_of(folder_), folder_ + ": this is a folder; add the name of a file");
    EXPECT_EQ(message_of(in("no/such/page.pdf")),
              in("no/such/page.pdf") + ": there is no folder " + in("no/such") + "; make it first: mkdir -p " + in("no/such"));
    EXPECT_EQ(message_of(in("none/")),
              in("none/") + ": there is no folder " + in("none") + "; make it first: mkdir -p " + in("none"));
    write_file(in("file"), "x");
    EXPECT_EQ(message_of(in("file/page.pdf")),
              in("file/page.pdf") + ": " + in("file") + " is not a folder; write to another place");
    EXPECT_EQ(message_of(in(std::string(300, 'n'))), in(std::string(300, 'n')) + ": the name is too long; choose a shorter one");
    EXPECT_EQ(message_of("/proc/page.pdf"),
              "/proc/page.pdf: no permission to write here; write to a folder of your own, or change the permissions");
    EXPECT_EQ(message_of(""), "an output has no name; give one, or - for standard output");
    EXPECT_EQ(message_of(std::string("a\0b", 3)), "the name of an output holds a zero byte; choose another");
    EXPECT_EQ(names(), std::vector<std::string>{"file"});
}

TEST_F(File, AReadOnlyFileOrFolderIsRespected) {
    if (geteuid() != 0) GTEST_SKIP() << "needs root, to become somebody else";
    write_file(in("page.pdf"), "old");
    chmod(in("page.pdf").c_str(), 0444);
    chmod(folder_.c_str(), 0777);
    const std::string refused = ": no permission to write here; write to a folder of your own, or change the permissions";
    EXPECT_EQ(in_child([&] { return seteuid(65534) != 0 || message_of(in("page.pdf")) != in("page.pdf") + refused; }), 0);
    chmod(folder_.c_str(), 0755);
    EXPECT_EQ(in_child([&] { return seteuid(65534) != 0 || message_of(in("other")) != in("other") + refused; }), 0);
    EXPECT_EQ(read(in("page.pdf")), "old");
    EXPECT_EQ(names(), std::vector<std::string>{"page.pdf"});
}

TEST_F(File, DevicesAndPipesAreWrittenStraight) {
    EXPECT_EQ(message_of("/dev/full"), "/dev/full: there is no space left; free some, or write to another disk");
    EXPECT_EQ(message_of("/dev/null"), "no error");
    for (const char* device : {"/dev/full", "/dev/null"}) EXPECT_TRUE(fs::is_character_file(device));

    ASSERT_EQ(mkfifo(in("pipe").c_str(), 0600), 0);
    std::string got;
    std::thread reader([&] { got = read(in("pipe")); });
    const std::string bytes(500'000, 'p');
    write_file(in("pipe"), bytes);
    reader.join();
    EXPECT_EQ(got, bytes);
    EXPECT_TRUE(fs::is_fifo(in("pipe")));
}

TEST_F(File, ProcessSubstitutionIsAPipe) {
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    write_file("/dev/fd/" + std::to_string(ends[1]), "through");
    char got[10] = {};
    EXPECT_EQ(::read(ends[0], got, sizeof(got)), 7);
    EXPECT_STREQ(got, "through");
    close(ends[0]);
    close(ends[1]);
}

TEST_F(File, StandardOutput) {
    for (const std::string name : {"-", "/dev/stdout"}) {
        const std::string log = in("log");
        EXPECT_EQ(in_child([&] {
                      const int file = open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
                      dup2(file, STDOUT_FILENO);
                      write_file(name, "page ");
                      return 0;
                  }),
                  0);
    }
    EXPECT_EQ(read(in("log")), "page page ");
    EXPECT_EQ(in_child([&] {
                  dup2(open("/dev/full", O_WRONLY), STDOUT_FILENO);
                  return message_of("-") == "standard output: there is no space left; free some, or write to another disk" ? 0
                                                                                                                           : 1;
              }),
              0);
}

TEST_F(File, AReaderThatHasGoneIsNoError) {
    EXPECT_EQ(in_child([&] {
                  signal(SIGPIPE, SIG_DFL);  // in case a library changed it
                  int ends[2];
                  if (pipe(ends) != 0) return kCannot;
                  close(ends[0]);
                  dup2(ends[1], STDOUT_FILENO);
                  write_file("-", std::string(1'000'000, 'x'));
                  // And the program still ends of a broken pipe elsewhere, as before.
                  return write(STDOUT_FILENO, "x", 1) == 1 ? 1 : 2;
              }),
              1000 + SIGPIPE);
}

TEST_F(File, APipeThatDoesNotWaitIsWaitedFor) {
    int ends[2];
    ASSERT_EQ(pipe2(ends, O_NONBLOCK), 0);
    std::string got;
    std::thread reader([&] {
        char buffer[1000];
        for (;;) {
            const ssize_t count = ::read(ends[0], buffer, sizeof(buffer));
            if (count > 0) got.append(buffer, static_cast<std::size_t>(count));
            if (got.size() == 300'000) return;
            if (count < 0) std::this_thread::yield();
        }
    });
    EXPECT_EQ(in_child([&] {
                  dup2(ends[1], STDOUT_FILENO);
                  write_file("-", std::string(300'000, 'y'));
                  return 0;
              }),
              0);
    reader.join();
    close(ends[0]);
    close(ends[1]);
    EXPECT_EQ(got, std::string(300'000, 'y'));
}

TEST_F(File, AFullDiskLeavesTheOldFile) {
    const int result = in_child([&] {
        if (!mount_over(folder_, "size=256k")) return kCannot;
        write_file(in("page.pdf"), "old");
        if (message_of(in("page.pdf"), std::string(2'000'000, 'x')) !=
            in("page.pdf") + ": there is no space left; free some, or write to another disk")
            return 1;
        if (read(in("page.pdf")) != "old" || names() != std::vector<std::string>{"page.pdf"}) return 2;
        write_file(in("page.pdf"), std::string(100'000, 'y'));
        return 0;
    });
    if (result == kCannot) GTEST_SKIP() << "needs root, to mount a small file system";
    EXPECT_EQ(result, 0);
}

TEST_F(File, ALimitOnFilesIsAnError) {
    EXPECT_EQ(in_child([&] {
                  write_file(in("page.pdf"), "old");
                  const rlimit limit{10'000, 10'000};
                  if (setrlimit(RLIMIT_FSIZE, &limit) != 0) return kCannot;
                  const std::string message = message_of(in("page.pdf"), std::string(20'000, 'x'));
                  return message.find("larger than is allowed") != std::string::npos && read(in("page.pdf")) == "old" ? 0 : 1;
              }),
              0);
    EXPECT_EQ(names(), std::vector<std::string>{"page.pdf"});
}

TEST_F(File, WritersAtOnceNeverMixTheirBytes) {
    std::vector<std::thread> writers;
    std::atomic<bool> mixed = false;
    for (char letter = 'a'; letter < 'e'; ++letter)
        writers.emplace_back([&, letter] {
            for (int i = 0; i < 50; ++i) {
                write_file(in("page"), std::string(50'000, letter));
                const std::string seen = read(in("page"));
                if (seen != std::string(50'000, seen.empty() ? '?' : seen[0])) mixed = true;
            }
        });
    for (auto& writer : writers) writer.join();
    EXPECT_FALSE(mixed);
    EXPECT_EQ(names(), std::vector<std::string>{"page"});
}

// A program that writes one large file over and over is ended at many moments.
TEST_F(File, EndedInTheMiddleTheFileIsWhole) {
    const std::string bytes(8'000'000, 'z');
    for (int i = 0; i < 8; ++i) {
        const pid_t child = fork();
        if (child == 0)
            for (;;) write_file(in("page"), bytes);
        usleep(static_cast<useconds_t>(4000 + 2900 * i));
        kill(child, SIGTERM);
        int status = 0;
        waitpid(child, &status, 0);
        EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGTERM);
        if (fs::exists(in("page"))) {
            EXPECT_EQ(fs::file_size(in("page")), bytes.size());
        }
    }
}

TEST_F(File, UnfinishedFilesAreRemoved) {
    const int result = in_child([&] {
        if (!hide_proc()) return kCannot;
        write_file(in("page"), "old");
        const std::vector<std::string> before = names();
        const std::string bytes(100'000'000, 'z');
        std::atomic<bool> failed = false;
        std::thread writer([&] {
            try {
                write_file(in("page"), bytes);
            } catch (const Error&) {
                failed = true;
            }
        });
        while (names() == before && fs::file_size(in("page")) == 3) std::this_thread::yield();
        remove_unfinished_files();
        const bool gone = names() == before;
        writer.join();
        if (!gone || names() != before) return 1;
        return failed == (read(in("page")) == "old") ? 0 : 2;
    });
    if (result == kCannot) GTEST_SKIP() << "needs root, to hide /proc";
    EXPECT_EQ(result, 0);
    EXPECT_EQ(names(), std::vector<std::string>{"page"});
}

TEST_F(File, WhereFilesNeedANameTheyAreTheSame) {
    const int result = in_child([&] {
        if (!hide_proc()) return kCannot;
        umask(027);
        write_file(in("fresh"), "one");
        if (read(in("fresh")) != "one" || mode_of(in("fresh")) != 0640) return 1;
        chmod(in("fresh").c_str(), 0600);
        write_file(in("fresh"), "two");
        if (read(in("fresh")) != "two" || mode_of(in("fresh")) != 0600) return 2;
        const rlimit limit{10'000, 10'000};
        setrlimit(RLIMIT_FSIZE, &limit);
        if (message_of(in("fresh"), std::string(20'000, 'x')).find("larger than is allowed") == std::string::npos) return 3;
        return read(in("fresh")) == "two" ? 0 : 4;
    });
    if (result == kCannot) GTEST_SKIP() << "needs root, to hide /proc";
    EXPECT_EQ(result, 0);
    EXPECT_EQ(names(), std::vector<std::string>{"fresh"});
}

TEST_F(File, ARenameThatFailsLeavesNothing) {
    // A file that is mounted on its own, as into a container, cannot be replaced.
    for (const bool hidden : {false, true}) {
        const int result = in_child([&] {
            write_file(in("page"), "old");
            write_file(in("other"), "other");
            if (hidden ? !hide_proc() : unshare(CLONE_NEWNS) != 0) return kCannot;
            if (mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0) return kCannot;
            if (mount(in("other").c_str(), in("page").c_str(), nullptr, MS_BIND, nullptr) != 0) return kCannot;
            return message_of(in("page")).find(": cannot be written: ") != std::string::npos ? 0 : 1;
        });
        if (result == kCannot) GTEST_SKIP() << "needs root, to mount a file";
        EXPECT_EQ(result, 0);
        EXPECT_EQ(names(), (std::vector<std::string>{"other", "page"}));
        EXPECT_EQ(read(in("page")), "old");
        EXPECT_EQ(read(in("other")), "other");
    }
}

}  // namespace
}  // namespace tactics::file_test
