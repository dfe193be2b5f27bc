// SPDX-License-Identifier: Apache-2.0
// Programs that read what strangers wrote: what they may do, and that none outlives us.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <thread>

#include "tactics/transport/child.h"
#include "tests/cli/tool.h"
#include "tests/tactics/transport/processes.h"

namespace tactics::caged_child_test {
namespace {

using End = ChildAnswer::End;

ChildAnswer shell(const std::string& script, std::string_view input = "") {
    return run_caged({.words = {"sh", "-c", script}, .input = input});
}

TEST(CagedChild, ReadsItsInputAndAnswers) {
    EXPECT_EQ(shell("exec cat", "given").out, "given");
    const tests::Folder folder;
    tests::write_bytes(folder / "file", "from its beginning");
    const int file = open((folder / "file").c_str(), O_RDWR | O_CLOEXEC);
    lseek(file, 5, SEEK_SET);
    EXPECT_EQ(run_caged({.words = {"cat"}, .file = file}).out, "from its beginning");
    EXPECT_EQ(run_caged({.words = {"cat", "/dev/fd/0"}, .file = file}).out, "from its beginning");
    EXPECT_EQ(run_caged({.words = {"sh", "-c", "echo no >&0"}, .file = file}).end, End::failed);
    EXPECT_EQ(tests::bytes_of(folder / "file"), "from its beginning");
    close(file);
    EXPECT_EQ(run_caged({.words = {"sh", "-c", "echo $WORD"}, .settings = {"WORD=a b"}}).out, "a b\n");
}

TEST(CagedChild, DoesNothingElse) {
    const tests::Folder folder;
    tests::write_bytes(folder / "file", "x");
    const std::string file = (folder / "file").string(), fresh = (folder / "fresh").string();
    // Each is tried without the cage, too.
    const auto free = [](const std::vector<std::string>& words) { return run_child(words, "", {}).end; };
    const auto caged = [](const std::vector<std::string>& words) { return run_caged({.words = words}).end; };
    const std::vector<std::vector<std::string>> trials = {
        {"sh", "-c", "(exit 0)"},                             // another process
        {"sh", "-c", "echo x > " + fresh},                    // a file made
        {"sh", "-c", "echo x >> " + file},                    // and changed
        {"chmod", "600", file},                               //
        {"touch", file},                                      //
        {"mv", file, fresh},                                  //
        {"mv", fresh, file},                                  //
        {"sh", "-c", "kill -0 " + std::to_string(getpid())},  // a signal to us
        {"setsid", "true"},                                   // out of its group, so that it would not end with it
    };
    for (const auto& words : trials) {
        EXPECT_EQ(caged(words), End::failed) << words.back();
        EXPECT_EQ(free(words), End::done) << words.back();
    }
    if (caged({"cat", file}) == End::done) GTEST_SKIP() << "this kernel has no Landlock: a caged program reads any file";
    EXPECT_EQ(run_caged({.words = {"cat", file}, .readable = {folder.path().string()}}).out, "xx\n");
}

TEST(CagedChild, HasItsLimits) {
    using std::chrono::milliseconds;
    EXPECT_EQ(run_caged({.words = {"sleep", "600"}, .limits = {milliseconds(100), 100}}).end, End::too_long);
    EXPECT_EQ(run_caged({.words = {"yes"}, .limits = {milliseconds(60'000), 1000}}).end, End::too_much);
    const auto fill = [](std::size_t memory) {
        return run_caged({.words = {"head", "-c", "10", "/dev/null"}, .memory = memory}).end;
    };
    EXPECT_EQ(fill(std::size_t{1} << 30), End::done);
    EXPECT_EQ(fill(4096), End::failed);
    EXPECT_EQ(run_caged({.words = {"no-such-program-anywhere"}}).end, End::missing);
    const ChildAnswer crash = shell("kill -SEGV $$");
    EXPECT_EQ(crash.end, End::failed);
    EXPECT_TRUE(crash.crashed);
}

TEST(CagedChild, EndsWithUsHoweverWeEnd) {
    const pid_t copy = fork();
    if (copy == 0) {
        run_caged({.words = {"sleep", "600"}});
        _exit(0);
    }
    const pid_t child = tests::wait_for_child(copy, "sleep");
    ASSERT_NE(child, 0);
    kill(copy, SIGKILL);
    waitpid(copy, nullptr, 0);
    EXPECT_TRUE(tests::wait_until_gone(child));
}

// Its parent ended before it could ask to be ended with the parent.
TEST(CagedChild, OfAParentThatIsGoneDoesNotBegin) {
    const std::string cage = TACTICS_BINARY_DIR "/tactics-cage";
    const auto said = [&](pid_t parent) {
        return run_child({cage, std::to_string(parent), "1000000000", "9", "9", "/usr", "/lib", "/lib64", "/bin",
                          "/etc/ld.so.cache", "--", "/bin/echo", "begun"},
                         "", {})
            .out;
    };
    EXPECT_EQ(said(getpid()), "begun\n");
    EXPECT_EQ(said(getpid() + 1), "");
    EXPECT_NE(run_child({cage}, "", {}).err.find("is started by tactics for other programs"), std::string::npos);
}

TEST(Child, AllEndWhereTheProgramIsAboutTo) {
    const pid_t copy = fork();
    if (copy == 0) {
        ChildAnswer answer;
        std::thread waiting([&] { answer = run_child({"sh", "-c", "sleep 600; true"}, "", {}); });
        tests::wait_for_child(tests::wait_for_child(getpid(), "sh"), "sleep");
        end_children();
        waiting.join();
        const bool refused = !run_child({"true"}, "", {}).fault.empty();
        _exit(answer.end == End::failed && refused ? 7 : 8);
    }
    int status = 0;
    waitpid(copy, &status, 0);
    EXPECT_EQ(WEXITSTATUS(status), 7);
}

}  // namespace
}  // namespace tactics::caged_child_test
