// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/voice/speaking.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

#include "tests/haptics/allocations.h"

namespace tactics::speaking_test {
namespace {

using namespace std::chrono_literals;

// Keeps what it is told; may hang until it is let go.
struct Heard {
    std::mutex guard;
    std::condition_variable changed;
    std::vector<std::string> said;
    int stopped = 0, closed = 0;
    bool hangs = false;
    std::string trouble = "a trouble";

    bool wait_for(std::size_t count) {
        std::unique_lock lock(guard);
        return changed.wait_for(lock, 20s, [&] { return said.size() >= count; });
    }
    void let_go() {
        const std::lock_guard lock(guard);
        hangs = false;
        changed.notify_all();
    }
};

class Listener : public Voice {
public:
    Listener(std::shared_ptr<Heard> heard, bool turns) : heard_(std::move(heard)), turns_(turns) {}
    ~Listener() override {
        const std::lock_guard lock(heard_->guard);
        ++heard_->closed;
        heard_->changed.notify_all();
    }
    std::string_view name() const override { return "listener"; }
    bool takes_turns() const override { return turns_; }
    void say(const std::string& text) override {
        std::unique_lock lock(heard_->guard);
        heard_->said.push_back(text);
        heard_->changed.notify_all();
        heard_->changed.wait(lock, [&] { return !heard_->hangs; });
    }
    void stop() override {
        const std::lock_guard lock(heard_->guard);
        ++heard_->stopped;
    }
    Phrase trouble() override { return heard_->trouble; }

private:
    std::shared_ptr<Heard> heard_;
    bool turns_;
};

std::string number_words(const Announcement& one) { return "number " + std::to_string(static_cast<int>(one.x)); }

TEST(Speaking, SaysAllInOrderToAVoiceThatTakesTurns) {
    const auto heard = std::make_shared<Heard>();
    Speaking speaking(std::make_unique<Listener>(heard, true), &number_words);
    for (int i = 0; i < 40; ++i) EXPECT_TRUE(speaking.ask({.x = static_cast<double>(i)}));
    EXPECT_TRUE(speaking.finish());
    ASSERT_EQ(heard->said.size(), 40u);
    for (int i = 0; i < 40; ++i) EXPECT_EQ(heard->said[static_cast<std::size_t>(i)], "number " + std::to_string(i));
    EXPECT_EQ(speaking.counts().said, 40u);
    EXPECT_EQ(heard->closed, 1);
    EXPECT_EQ(speaking.note().english(), "a trouble");
}

TEST(Speaking, TheNewestOvertakes) {
    const auto heard = std::make_shared<Heard>();
    heard->hangs = true;
    Speaking speaking(std::make_unique<Listener>(heard, false), &number_words);
    speaking.ask({.x = 0});
    ASSERT_TRUE(heard->wait_for(1));
    for (int i = 1; i <= 5; ++i) speaking.ask({.x = static_cast<double>(i)});
    heard->let_go();
    ASSERT_TRUE(heard->wait_for(2));
    EXPECT_EQ(heard->said[1], "number 5");
    EXPECT_EQ(speaking.counts().overtaken, 4u);
    speaking.ask({.telling = Telling::hush});
    EXPECT_TRUE(speaking.finish());
    EXPECT_GE(heard->stopped, 1);
}

TEST(Speaking, EndsAlthoughTheVoiceHangs) {
    const auto heard = std::make_shared<Heard>();
    heard->hangs = true;
    heard->trouble = "";  // otherwise the order would depend on timing
    {
        Speaking speaking(std::make_unique<Listener>(heard, false), &number_words);
        speaking.ask({.x = 0});
        ASSERT_TRUE(heard->wait_for(1));
        unsigned dropped = 0;
        for (int i = 0; i < 1000; ++i) dropped += !speaking.ask({.x = static_cast<double>(i)});
        EXPECT_GT(dropped, 900u);
        EXPECT_EQ(speaking.counts().dropped, dropped);
        EXPECT_FALSE(speaking.finish());
        EXPECT_NE(speaking.note().english().find("does not answer"), std::string::npos);
    }
    heard->let_go();
    std::unique_lock lock(heard->guard);
    EXPECT_TRUE(heard->changed.wait_for(lock, 20s, [&] { return heard->closed == 1; })) << "the thread has lost its voice";
}

TEST(Speaking, AskingAllocatesNothing) {
    if (!tests::counts_allocations()) GTEST_SKIP() << "a sanitizer has its own allocator";
    Speaking speaking(open_voice({.kind = "none"}).voice, [](const Announcement&) { return std::string(); });
    const auto before = tests::allocations();
    for (int i = 0; i < 100; ++i) speaking.ask({.x = static_cast<double>(i)});
    EXPECT_EQ(tests::allocations(), before);
}

TEST(Speaking, WordsOfManyLinesAreOne) {
    const auto heard = std::make_shared<Heard>();
    Speaking speaking(std::make_unique<Listener>(heard, true),
                      [](const Announcement&) { return "a\nb\x1b[c " + std::string(5000, 'x'); });
    speaking.ask({});
    EXPECT_TRUE(speaking.finish());
    ASSERT_EQ(heard->said.size(), 1u);
    EXPECT_TRUE(heard->said[0].starts_with("a b")) << heard->said[0];
    EXPECT_EQ(heard->said[0].size(), kMostSpoken);
    EXPECT_EQ(heard->said[0].find_first_of("\n\x1b"), std::string::npos);
}

}  // namespace
}  // namespace tactics::speaking_test
