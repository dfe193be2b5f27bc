// SPDX-License-Identifier: Apache-2.0
// Bytes on their way to a device: each at most once, and what is told is what the device got.
#include "tactics/transport/delivery.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace tactics::delivery_test {
namespace {

using std::chrono::milliseconds;
using Cancel = DeliveryWish::Cancel;

std::string some_bytes(std::size_t count, unsigned seed) {
    std::mt19937 random(seed);
    std::string bytes(count, '\0');
    for (char& c : bytes) c = static_cast<char>(random());
    return bytes;
}

// A machine with a buffer that it empties while it is waited for. Time is counted, not spent.
class Machine : public Channel {
public:
    std::string got;
    std::size_t room = 4096;        // of its buffer
    std::size_t no_paper_at = ~0u;  // after it has accepted this many bytes
    int paper_after = 1'000'000;    // waits
    std::size_t unplugged_at = ~0u;
    std::size_t stalls_at = ~0u;
    std::size_t odd_take = 0;  // takes this many at a time at most
    int waits = 0;

    Taken take(std::string_view bytes) override {
        if (got.size() >= unplugged_at) return {0, Ending::gone};
        std::size_t count = std::min({bytes.size(), room - held_, stop() - got.size()});
        if (odd_take > 0) count = std::min(count, odd_take);
        got += bytes.substr(0, count);
        held_ += count;
        return {count};
    }
    bool wait(milliseconds) override {
        ++waits;
        if (got.size() >= unplugged_at) return true;
        if (got.size() >= no_paper_at && --paper_after <= 0) no_paper_at = ~0u;
        if (got.size() >= no_paper_at || got.size() >= stalls_at) return false;
        held_ = 0;
        return true;
    }
    Ending trouble() override { return got.size() >= no_paper_at ? Ending::paper_out : Ending::stalled; }
    std::size_t on_the_way() override { return 0; }

private:
    std::size_t stop() const { return std::min({no_paper_at, unplugged_at, stalls_at, std::size_t{1} << 40}); }
    std::size_t held_ = 0;
};

TEST(Delivery, AllBytesArriveInTheirOrder) {
    for (const std::size_t size : {0u, 1u, 8191u, 8192u, 8193u, 1'000'000u}) {
        for (const std::size_t odd : {0u, 7u, 4096u}) {
            if (odd == 7 && size > 10'000) continue;
            const std::string bytes = some_bytes(size, 1);
            Machine machine;
            machine.odd_take = odd;
            const Delivery delivery = deliver(machine, bytes, {});
            EXPECT_EQ(delivery.ending, Ending::done);
            EXPECT_EQ(delivery.accepted, size);
            EXPECT_TRUE(machine.got == bytes);
        }
    }
}

TEST(Delivery, UnpluggedAnywhereTellsWhatWasTaken) {
    const std::string bytes = some_bytes(100'000, 2);
    std::mt19937 random(5);
    for (int trial = 0; trial < 10; ++trial) {
        Machine machine;
        machine.unplugged_at = random() % bytes.size();
        const Delivery delivery = deliver(machine, bytes, {});
        EXPECT_EQ(delivery.ending, Ending::gone);
        EXPECT_EQ(delivery.accepted, machine.got.size());
        EXPECT_EQ(machine.got, bytes.substr(0, machine.unplugged_at));
    }
}

TEST(Delivery, GoesOnWhenThereIsPaperAgainAndSendsNothingTwice) {
    const std::string bytes = some_bytes(50'000, 3);
    Machine machine;
    machine.no_paper_at = 20'001;
    machine.paper_after = 20;
    std::vector<Ending> troubles;
    DeliveryWish wish;
    wish.tell = [&](std::size_t accepted, std::optional<Ending> trouble) {
        EXPECT_LE(accepted, bytes.size());
        if (trouble) troubles.push_back(*trouble);
    };
    const Delivery delivery = deliver(machine, bytes, wish);
    EXPECT_EQ(delivery.ending, Ending::done);
    EXPECT_TRUE(machine.got == bytes);
    EXPECT_EQ(troubles, std::vector<Ending>{Ending::paper_out});  // told once
}

TEST(Delivery, EndsWhenPatienceIsOver) {
    const std::string bytes = some_bytes(50'000, 4);
    for (const bool paper : {true, false}) {
        Machine machine;
        (paper ? machine.no_paper_at : machine.stalls_at) = 30'000;
        DeliveryWish wish;
        wish.patience = milliseconds(1000);
        const Delivery delivery = deliver(machine, bytes, wish);
        EXPECT_EQ(delivery.ending, paper ? Ending::paper_out : Ending::stalled);
        EXPECT_EQ(delivery.accepted, 30'000u);
        EXPECT_LT(machine.waits, 40);
    }
}

TEST(Delivery, CancelledItEndsBehindThePageThatWasBegun) {
    const std::string bytes = some_bytes(60'000, 5);
    const std::vector<std::size_t> pages{10'000, 25'000, 40'000, 60'000};
    for (const std::size_t after : {0u, 1u, 9'000u, 10'000u, 12'000u, 39'999u, 45'000u}) {
        Machine machine;
        machine.odd_take = 1000;
        DeliveryWish wish;
        wish.pages = pages;
        wish.cancel = [&] { return machine.got.size() >= after ? Cancel::behind_page : Cancel::no; };
        const Delivery delivery = deliver(machine, bytes, wish);
        EXPECT_EQ(delivery.accepted, machine.got.size());
        if (after == 0) {
            EXPECT_EQ(delivery.accepted, 0u);
        } else {
            EXPECT_NE(std::find(pages.begin(), pages.end(), delivery.accepted), pages.end()) << after;
            EXPECT_GE(delivery.accepted, after);
        }
        EXPECT_EQ(delivery.ending, delivery.accepted == bytes.size() ? Ending::done : Ending::cancelled);
    }
    Machine machine;  // without pages at once
    DeliveryWish wish;
    wish.cancel = [&] { return machine.got.size() >= 5000 ? Cancel::behind_page : Cancel::no; };
    const Delivery delivery = deliver(machine, bytes, wish);
    EXPECT_EQ(delivery.accepted, machine.got.size());
    EXPECT_LT(machine.got.size(), 20'000u);
}

TEST(Delivery, CancelledTwiceItEndsAtOnce) {
    const std::string bytes = some_bytes(60'000, 6);
    Machine machine;
    machine.odd_take = 1000;
    DeliveryWish wish;
    wish.pages = {10'000, 60'000};
    wish.cancel = [&] { return machine.got.size() >= 15'000 ? Cancel::at_once : Cancel::no; };
    const Delivery delivery = deliver(machine, bytes, wish);
    EXPECT_EQ(delivery.ending, Ending::cancelled);
    EXPECT_EQ(delivery.accepted, machine.got.size());
    EXPECT_LT(delivery.accepted, 17'000u);
}

// A line that takes all and sends it slowly: what has not left when the job ends is thrown away and not counted.
class Line : public Channel {
public:
    std::size_t taken = 0, sent = 0, stops_at = ~std::size_t{0}, thrown_away = 0;
    bool gone = false;

    Taken take(std::string_view bytes) override {
        taken += bytes.size();
        return {bytes.size()};
    }
    bool wait(milliseconds) override { return true; }
    Ending trouble() override { return gone && sent >= stops_at ? Ending::gone : Ending::stalled; }
    std::size_t on_the_way() override {
        sent = std::min({taken, stops_at, sent + 500});
        return taken - sent;
    }
    void discard() override {
        thrown_away = taken - sent;
        taken = sent;
    }
};

TEST(Delivery, WaitsUntilAllHasLeft) {
    Line line;
    const Delivery delivery = deliver(line, some_bytes(20'000, 7), {});
    EXPECT_EQ(delivery.ending, Ending::done);
    EXPECT_EQ(delivery.accepted, 20'000u);
    EXPECT_EQ(line.sent, 20'000u);
}

TEST(Delivery, WhatHasNotLeftIsNotCountedAndNotSentLater) {
    for (const bool gone : {true, false}) {
        Line line;
        line.stops_at = 7'000;
        line.gone = gone;
        DeliveryWish wish;
        wish.patience = milliseconds(200);
        const Delivery delivery = deliver(line, some_bytes(20'000, 8), wish);
        EXPECT_EQ(delivery.ending, gone ? Ending::gone : Ending::stalled);
        EXPECT_EQ(delivery.accepted, 7'000u);
        EXPECT_EQ(line.thrown_away, 13'000u);
    }
}

// A machine that takes its time is in no trouble.
TEST(Delivery, IsQuietAboutShortPauses) {
    Machine machine;
    machine.room = 512;
    std::size_t told = 0;
    DeliveryWish wish;
    wish.tell = [&](std::size_t, std::optional<Ending> trouble) { told += trouble ? 1 : 0; };
    EXPECT_EQ(deliver(machine, some_bytes(100'000, 9), wish).ending, Ending::done);
    EXPECT_EQ(told, 0u);
}

TEST(Delivery, CountsCompletePages) {
    EXPECT_EQ(pages_within({10, 20, 30}, 0), 0u);
    EXPECT_EQ(pages_within({10, 20, 30}, 9), 0u);
    EXPECT_EQ(pages_within({10, 20, 30}, 10), 1u);
    EXPECT_EQ(pages_within({10, 20, 30}, 29), 2u);
    EXPECT_EQ(pages_within({10, 20, 30}, 30), 3u);
    EXPECT_EQ(pages_within({}, 30), 0u);
}

}  // namespace
}  // namespace tactics::delivery_test
