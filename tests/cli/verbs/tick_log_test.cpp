// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/tick_log.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

namespace tactics::tick_log_test {
namespace {

// What another thread adds meanwhile is written by one of its own. Under ThreadSanitizer this finds what both touch.
TEST(TickLogThread, WritesAllThatIsFeltMeanwhile) {
    const std::filesystem::path path = std::filesystem::temp_directory_path() / ("ticks" + std::to_string(getpid()) + ".csv");
    constexpr int kTicks = 3000;
    Recorder recorder(2 * kTicks);
    TickLog log(path, recorder, {});
    log.write_beside();
    for (int tick = 0; tick < kTicks; ++tick) {
        TickRecord record;
        record.time = tick;
        recorder.add(record);
        if (tick % 1000 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    log.finish();
    std::stringstream written;
    written << std::ifstream(path).rdbuf();
    const std::string text = written.str();
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), kTicks + 1);
    for (const int tick : {0, 1, kTicks - 1}) EXPECT_NE(text.find("\n" + std::to_string(tick) + ","), std::string::npos) << tick;
    std::filesystem::remove(path);
}

}  // namespace
}  // namespace tactics::tick_log_test
