// A fusion works in a loop of a thousand steps a second and more: after it is made it may not ask for memory.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "tactics/haptics/fusion.h"

namespace {
std::atomic<long> asked{0};
}  // namespace

// Weak: where another counts already, that one is taken, and this test finds that its own does not count.
__attribute__((weak)) void* operator new(std::size_t size) {
    ++asked;
    if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
    throw std::bad_alloc();
}
__attribute__((weak)) void operator delete(void* memory) noexcept { std::free(memory); }
__attribute__((weak)) void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace tactics {
namespace {

TEST(Fusion, AsksForNoMemoryOnceItIsMade) {
    const long before = asked;
    const std::unique_ptr<Fusion> fusions[] = {paper_fusion({}), learning_fusion({})};
    if (asked == before) GTEST_SKIP() << "another counts what is asked for";
    const long made = asked;
    double seen = 0;
    for (const auto& fusion : fusions)
        for (int i = 1; i < 20000; ++i) {  // more than the history holds
            fusion->step({i / 8000.0, {0.01, 0}, {0.01, 0.0001}});
            if (i % 133 == 0) fusion->overlay({i / 8000.0, {i < 15000 ? 0.01 * i : 500, 0}});  // with a jump, for the resets
            seen += fusion->pose().at.x;
        }
    EXPECT_EQ(asked, made);
    EXPECT_GT(fusions[1]->resets(), 0u);
    EXPECT_GT(seen, 0);
}

}  // namespace
}  // namespace tactics
