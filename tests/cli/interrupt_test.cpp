// SPDX-License-Identifier: Apache-2.0
// Ctrl-C while it is waited for.
#include "cli/interrupt.h"

#include <gtest/gtest.h>
#include <pthread.h>

#include <chrono>
#include <cstdio>

namespace tactics::interrupt_test {
namespace {

// Libraries have threads of their own from before the program begins (OpenBLAS has), which mask nothing.
TEST(InterruptDeathTest, ReachesUsByWhicheverThread) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_EXIT(
        {
            signal(SIGINT, SIG_DFL);  // the caller of the tests may ignore it
            std::thread other([] { std::this_thread::sleep_for(std::chrono::seconds(30)); });
            const Interrupt interrupt([] { std::fputs("put away", stderr); });
            pthread_kill(other.native_handle(), SIGINT);
            other.join();
        },
        testing::KilledBySignal(SIGINT), "put away");
}

TEST(InterruptDeathTest, IsUndoneWithIt) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_EXIT(
        {
            signal(SIGTERM, SIG_DFL);
            {
                const Interrupt interrupt([] { std::fputs("put away", stderr); });
            }
            raise(SIGTERM);
        },
        testing::KilledBySignal(SIGTERM), "^$");
}

}  // namespace
}  // namespace tactics::interrupt_test
