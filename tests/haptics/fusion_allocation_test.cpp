// SPDX-License-Identifier: Apache-2.0
// A fusion works in a loop of a thousand steps a second and more: after it is made it may not ask for memory.
#include <gtest/gtest.h>

#include "tactics/haptics/sensing/fusion.h"
#include "tests/haptics/allocations.h"

namespace tactics::fusion_allocation_test {
namespace {

TEST(Fusion, AsksForNoMemoryOnceItIsMade) {
    const std::unique_ptr<Fusion> fusions[] = {paper_fusion({}), learning_fusion({})};
    if (!tests::counts_allocations()) GTEST_SKIP() << "sanitizers count for themselves";
    const std::size_t made = tests::allocations();
    double seen = 0;
    for (const auto& fusion : fusions)
        for (int i = 1; i < 20000; ++i) {  // more than the history holds
            fusion->step({i / 8000.0, {0.01, 0}, {0.01, 0.0001}});
            if (i % 133 == 0) fusion->overlay({i / 8000.0, {i < 15000 ? 0.01 * i : 500, 0}});  // with a jump, for the resets
            seen += fusion->pose().at.x;
        }
    EXPECT_EQ(tests::allocations(), made);
    EXPECT_GT(fusions[1]->resets(), 0u);
    EXPECT_GT(seen, 0);
}

}  // namespace
}  // namespace tactics::fusion_allocation_test
