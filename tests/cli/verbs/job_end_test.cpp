// SPDX-License-Identifier: Apache-2.0
// The end of a job that was cancelled, on machines that are not there.
#include "cli/verbs/job_end.h"

#include <gtest/gtest.h>

namespace tactics::job_end_test {
namespace {

// Time is counted, not spent.
class Machine : public Channel {
public:
    explicit Machine(int takes_after) : takes_after_(takes_after) {}
    Taken take(std::string_view bytes) override {
        if (waits < takes_after_) return {};
        got += bytes;
        return {bytes.size()};
    }
    bool wait(std::chrono::milliseconds time) override {
        ++waits;
        waited += time;
        return waits >= takes_after_;
    }
    Ending trouble() override { return Ending::stalled; }
    std::size_t on_the_way() override { return 0; }

    std::string got;
    int waits = 0;
    std::chrono::milliseconds waited{0};

private:
    int takes_after_;
};

bool never() { return false; }

TEST(JobEnd, GoesToAMachineThatTakesIt) {
    for (const int takes_after : {0, 20}) {
        Machine machine(takes_after);
        EXPECT_TRUE(end_job(machine, "\x1a", never).empty());
        EXPECT_EQ(machine.got, "\x1a");
    }
    Machine mute(1000);
    EXPECT_TRUE(end_job(mute, "", never).empty());  // it has none
    EXPECT_EQ(mute.waits, 0);
}

TEST(JobEnd, IsSaidNotToHaveGone) {
    Machine mute(1000);
    EXPECT_TRUE(end_job(mute, "\x1a", never).english().starts_with("what ends a job did not go to the machine"));
    EXPECT_EQ(mute.waited, std::chrono::seconds{5});
    EXPECT_EQ(mute.got, "");
}

TEST(JobEnd, IsNotWaitedForIfTheUserGivesUp) {
    Machine mute(1000);
    EXPECT_NE(end_job(mute, "\x1a", [&] { return mute.waits >= 3; }), "");
    EXPECT_EQ(mute.waits, 3);
    Machine ready(0);
    EXPECT_NE(end_job(ready, "\x1a", [] { return true; }), "");
    EXPECT_EQ(ready.got, "");
}

}  // namespace
}  // namespace tactics::job_end_test
