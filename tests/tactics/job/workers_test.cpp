// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/workers.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <new>
#include <stdexcept>
#include <thread>
#include <vector>

namespace tactics::workers_test {
namespace {

TEST(Workers, DoEachOnce) {
    for (const int workers : {0, 1, 3, 16}) {
        std::vector<std::atomic<int>> done(100);
        share_out(done.size(), workers, [&](std::size_t i) { ++done[i]; });
        for (const auto& times : done) EXPECT_EQ(times, 1);
    }
    share_out(0, 4, [](std::size_t) { FAIL(); });
}

TEST(Workers, WhatIsThrownReachesTheCallerAndNoMoreIsBegun) {
    std::atomic<std::size_t> begun = 0;
    const auto work = [&](std::size_t i) {
        ++begun;
        if (i == 3) throw std::bad_alloc();
        std::this_thread::sleep_for(std::chrono::milliseconds(1));  // so that the rest could not be done before it is noticed
    };
    EXPECT_THROW(share_out(100'000, 4, work), std::bad_alloc);
    EXPECT_LT(begun, 100'000u);
}

TEST(Workers, AFailureNamesWhatWasWorkedOnOnce) {
    EXPECT_EQ(failure_of("a.jpg", [] {}).text.english(), "");
    EXPECT_EQ(failure_of("a.jpg", [] { throw Error(Fault::usage, "a.jpg", "no"); }).text.english(), "a.jpg: no");
    EXPECT_EQ(failure_of("a.jpg", [] { throw Error(Fault::usage, "--paper", "no"); }).text.english(), "a.jpg: --paper: no");
    EXPECT_EQ(failure_of("a.jpg", [] { throw Error(Fault::usage, "", "no"); }).fault, Fault::usage);
    EXPECT_NE(failure_of("a.jpg", [] { throw std::bad_alloc(); }).text.english().find("a.jpg: there is not enough memory"),
              std::string::npos);
    EXPECT_NE(failure_of("a.jpg", [] { throw std::logic_error("x"); }).text.english().find("please report it: x"),
              std::string::npos);
}

}  // namespace
}  // namespace tactics::workers_test
