// SPDX-License-Identifier: Apache-2.0
// Other programs, the well-behaved and the others.
#include "tactics/transport/child.h"

#include <gtest/gtest.h>

#include "tests/cli/tool.h"

namespace tactics::child_test {
namespace {

using End = ChildAnswer::End;

ChildAnswer shell(const std::string& script, std::string_view input = "", const ChildLimits& limits = {}) {
    return run_child({"sh", "-c", script}, input, limits);
}

TEST(Child, GetsItsInputAndIsHeardToTheEnd) {
    const std::string long_input(3'000'000, 'x');  // more than any pipe holds
    const ChildAnswer answer = shell("cat; echo \"$WORD\" >&2", long_input);
    EXPECT_EQ(answer.end, End::done);
    EXPECT_EQ(answer.out, long_input);
    EXPECT_EQ(shell("echo out; echo why >&2; exit 1").err, "why\n");
    const ChildAnswer loud = shell("head -c 200000 /dev/zero >&2; echo done");  // more than a pipe holds
    EXPECT_EQ(loud.end, End::done);
    EXPECT_EQ(loud.out, "done\n");
    EXPECT_EQ(loud.err.size(), 4096u);
    EXPECT_EQ(shell("cat").out, "");
    EXPECT_EQ(run_child({"sh", "-c", "echo $WORD $HOME"}, "", {}, {"WORD=a b", "HOME=none"}).out, "a b none\n");
    EXPECT_EQ(run_child({"printf", "%s", "$(echo no) *"}, "", {}).out, "$(echo no) *");  // no shell reads the words
}

TEST(Child, ThatFailsIsTold) {
    EXPECT_EQ(shell("echo half; exit 3").end, End::failed);
    EXPECT_EQ(shell("kill -SEGV $$").end, End::failed);
    EXPECT_EQ(run_child({"no-such-program-anywhere"}, "", {}).end, End::missing);
    const tests::Folder folder;
    tests::write_bytes(folder / "plain", "text");
    const ChildAnswer plain = run_child({(folder / "plain").string()}, "", {});
    EXPECT_EQ(plain.end, End::failed);
    EXPECT_FALSE(plain.fault.empty());
}

TEST(Child, ThatDoesNotEndIsEnded) {
    using std::chrono::milliseconds;
    const tests::Folder folder;
    const std::string mark = (folder / "alive").string();
    // Also what it started itself, and one that closed its output before.
    EXPECT_EQ(shell("(sleep 600; echo x > " + mark + ") & sleep 600", "", {milliseconds(100), 100}).end, End::too_long);
    EXPECT_EQ(shell("exec >&-; sleep 600", "", {milliseconds(100), 100}).end, End::too_long);
    EXPECT_EQ(shell("yes", "", {milliseconds(60'000), 1000}).end, End::too_much);
}

}  // namespace
}  // namespace tactics::child_test
