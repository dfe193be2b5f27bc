// SPDX-License-Identifier: Apache-2.0
// An Inverse3 through a correct service and through faulty ones: for any message, the force is bounded and nothing hangs.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <thread>

#include "tactics/error.h"
#include "tactics/haptics/devices/arm_devices.h"
#include "tactics/haptics/devices/arm_talk.h"
#include "tactics/haptics/devices/latest.h"
#include "tactics/haptics/loop/play_loop.h"
#include "tests/haptics/allocations.h"
#include "tests/haptics/inverse3_server.h"

namespace tactics::inverse3_test {
namespace {

using tests::Inverse3Server;
using tests::Misbehaviour;
using State = HapticDevice::State;

constexpr double kMostForce = 8;  // N

double length(const Point3& force) { return std::hypot(force.x, force.y, force.z); }

// Ticks of a millisecond that push with what is asked for, until `over` or for ten seconds; the last state.
State ticks(HapticDevice& device, HapticSample& sample, const Point3& force, const std::function<bool()>& over) {
    State state = State::nothing;
    for (int i = 0; i < 10'000 && !over(); ++i) {
        state = device.read(sample, 0.001);
        if (state == State::gone || !device.push(force)) return State::gone;
        std::this_thread::sleep_for(std::chrono::milliseconds{1});
    }
    return state;
}

// Whether it comes true, however busy the machine is.
bool eventually(const std::function<bool()>& is_so) {
    for (int i = 0; i < 10'000 && !is_so(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds{1});
    return is_so();
}

bool lies(const Inverse3Server& server) { return !server.heard().empty() && server.heard().back().force == Point3{}; }

std::string why_not(const std::string& where) {
    try {
        inverse3_arm(where);
    } catch (const Error& error) {
        return error.what();
    }
    return "opened";
}

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(LatestThreads, NothingIsTornAndTheLastArrives) {
    struct Pair {
        long a = 0, b = 0;
    };
    Latest<Pair> latest;
    constexpr long kCount = 200'000;
    std::thread teller([&] {
        for (long i = 1; i <= kCount; ++i) latest.tell({i, -i});
    });
    Pair pair;
    long before = 0;
    while (pair.a < kCount) {
        if (!latest.ask(pair)) continue;
        ASSERT_EQ(pair.a, -pair.b);
        ASSERT_GT(pair.a, before);
        before = pair.a;
    }
    teller.join();
    EXPECT_FALSE(latest.ask(pair));
}

TEST(Inverse3Loop, TellsWhereItIsAndTakesForces) {
    Inverse3Server server;
    server.button = true;
    const auto device = inverse3_arm(server.where());
    HapticSample sample;
    unsigned words = 0;
    ticks(*device, sample, {1, 0.5, 2}, [&] { return (words += sample.words) > 200; });
    EXPECT_TRUE(sample.knows_place);
    EXPECT_NEAR(sample.place.x, 10, 1e-6);
    EXPECT_NEAR(sample.place.y, 30, 1e-6);
    EXPECT_NEAR(sample.height, 20, 1e-6);
    EXPECT_EQ(sample.keys, 2u);
    EXPECT_FALSE(sample.fault);
    const double now = std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
    EXPECT_GT(sample.place_time, now - 60);
    EXPECT_LE(sample.place_time, now);
    device->let_go();
    EXPECT_TRUE(eventually([&] { return lies(server); }));
    const auto heard = server.heard();
    ASSERT_GT(heard.size(), 100u);
    EXPECT_EQ(heard.front().force, Point3{});  // who begins is not pushed
    EXPECT_EQ(heard.back().force, Point3{});
    EXPECT_EQ(std::count_if(heard.begin(), heard.end(),
                            [](const auto& one) {
                                return one.force == Point3{1, -2, 0.5};
                            }) +
                  std::count_if(heard.begin(), heard.end(), [](const auto& one) { return one.force == Point3{}; }),
              static_cast<long>(heard.size()));
    EXPECT_GT(std::count_if(heard.begin(), heard.end(), [](const auto& one) { return one.force.x == 1; }), 20);
    ASSERT_EQ(server.messages().size(), 1u);
    EXPECT_TRUE(holds(server.messages()[0], R"("preset":{"preset":"arm_front_centered"})"));
    EXPECT_EQ(server.bad_messages(), 0);
}

TEST(Inverse3Loop, ForcesArriveInTheirOrderAndBounded) {
    Inverse3Server server;
    const auto device = inverse3_arm(server.where());
    HapticSample sample;
    for (int i = 1; i <= 400; ++i) {
        device->read(sample, 0.001);
        ASSERT_TRUE(device->push({0.01 * i, 0, 0}));
        std::this_thread::sleep_for(std::chrono::milliseconds{1});
    }
    const double none = std::numeric_limits<double>::quiet_NaN(), endless = std::numeric_limits<double>::infinity();
    for (const Point3 wild : {Point3{1e9, 0, 0}, {-5e5, 5e5, 5e5}, {none, 1, 1}, {0, endless, 0}})
        ticks(*device, sample, wild, [n = 0]() mutable { return ++n > 50; });
    device->let_go();
    double before = 0;
    for (const auto& one : server.heard()) {
        EXPECT_LE(length(one.force), kMostForce * (1 + 1e-6));
        // A loop that is late is let go of for a moment.
        if (one.force.y != 0 || one.force.x >= 7.9 || one.force == Point3{}) continue;
        EXPECT_GE(one.force.x, before);
        before = one.force.x;
    }
    EXPECT_GT(before, 1);
    EXPECT_EQ(server.bad_messages(), 0);
}

TEST(Inverse3Loop, AWishThatIsNotRepeatedEnds) {
    Inverse3Server server;
    const auto device = inverse3_arm(server.where());
    HapticSample sample;
    ticks(*device, sample, {0, 3, 0}, [&] { return server.heard().size() > 100; });
    // The loop hangs.
    const std::size_t then = server.heard().size();
    for (int i = 0; i < 1000 && server.heard().size() < then + 200; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds{10});
    EXPECT_EQ(server.heard().back().force, Point3{});
}

TEST(Inverse3Loop, LetsGoForGoodAndWithAFarewell) {
    Inverse3Server server;
    HapticSample sample;
    {
        const auto device = inverse3_arm(server.where());
        ticks(*device, sample, {0, 3, 0}, [&] { return server.heard().size() > 100; });
        device->let_go();
        EXPECT_TRUE(eventually([&] { return lies(server); }));
        device->push({0, 3, 0});
        std::this_thread::sleep_for(std::chrono::milliseconds{20});
        EXPECT_TRUE(lies(server));
    }
    EXPECT_TRUE(lies(server));
    EXPECT_TRUE(eventually([&] { return server.farewells() == 1; }));
    {
        const auto device = inverse3_arm(server.where());
        ticks(*device, sample, {0, 3, 0}, [&] { return !server.heard().empty() && server.heard().back().force.z == 3; });
    }
    // Closed in the middle of it, too.
    EXPECT_TRUE(eventually([&] { return lies(server); }));
}

TEST(Inverse3Loop, AHandleThatNobodyHoldsIsMovedByTheForce) {
    Inverse3Server server;
    server.held = false;
    const auto device = inverse3_arm(server.where());
    HapticSample sample;
    ticks(*device, sample, {0, 1, 0}, [&] { return sample.place.y > 60; });
    EXPECT_GT(sample.place.y, 60);
    EXPECT_NEAR(sample.place.x, 10, 1e-6);
}

TEST(Inverse3Loop, OfFaultAndKeysItTells) {
    Inverse3Server server;
    const auto device = inverse3_arm(server.where());
    HapticSample sample;
    for (const bool well : {true, false, true}) {
        server.ready = well;
        ticks(*device, sample, {}, [&] { return sample.knows_place && sample.fault != well; });
        EXPECT_NE(sample.fault, well);
    }
}

TEST(ArmTalkThreads, NeitherSideTakesMemory) {
    if (!tests::counts_allocations()) GTEST_SKIP() << "a sanitizer has its own allocator";
    ArmTalk talk;
    HapticSample sample;
    const std::size_t before = tests::allocations();
    for (int i = 0; i < 100; ++i) {
        talk.tell({{1, 2, 3}, 4, false});
        ASSERT_EQ(talk.read(sample), State::fine);
        ASSERT_EQ(talk.read(sample), State::nothing);
        ASSERT_TRUE(talk.push({0, 0, 1}));
        talk.force();
    }
    talk.lose();
    ASSERT_EQ(talk.read(sample), State::gone);
    EXPECT_EQ(tests::allocations(), before);
    EXPECT_EQ(sample.keys, 4u);
}

// What is allowed is borne: a message in pieces, a ping between, more answers than questions.
TEST(Inverse3Loop, WhatTheProtocolAllowsIsBorne) {
    for (const auto what : {Misbehaviour::fragments, Misbehaviour::pings, Misbehaviour::twice, Misbehaviour::binary}) {
        Inverse3Server server(what, 0);
        const auto device = inverse3_arm(server.where());
        HapticSample sample;
        ticks(*device, sample, {0, 0, 1}, [&] { return server.heard().size() > 60 && sample.knows_place; });
        EXPECT_GT(server.heard().size(), 60u) << static_cast<int>(what);
        EXPECT_NEAR(sample.place.x, 10, 1e-6) << static_cast<int>(what);
        EXPECT_EQ(server.pongs() > 0, what == Misbehaviour::pings) << static_cast<int>(what);
        device->let_go();
        EXPECT_TRUE(eventually([&] { return lies(server); })) << static_cast<int>(what);
    }
}

constexpr Misbehaviour kWrong[] = {Misbehaviour::mute,          Misbehaviour::deaf,         Misbehaviour::not_json,
                                   Misbehaviour::half_json,     Misbehaviour::not_a_number, Misbehaviour::huge,
                                   Misbehaviour::far,           Misbehaviour::no_place,     Misbehaviour::a_text_for_x,
                                   Misbehaviour::another_id,    Misbehaviour::no_device,    Misbehaviour::deep,
                                   Misbehaviour::ten_megabytes, Misbehaviour::broken_frame, Misbehaviour::masked_frame,
                                   Misbehaviour::closes,        Misbehaviour::vanishes};

class Inverse3LoopWrong : public testing::TestWithParam<Misbehaviour> {};
INSTANTIATE_TEST_SUITE_P(EachWay, Inverse3LoopWrong, testing::ValuesIn(kWrong));

TEST_P(Inverse3LoopWrong, ItIsGoneAndComesBack) {
    Inverse3Server server(GetParam(), 60);
    const auto device = inverse3_arm(server.where());
    HapticSample sample;
    EXPECT_EQ(ticks(*device, sample, {0, 2, 0}, [] { return false; }), State::gone);
    // What it was told last was within a metre, and is what it was.
    EXPECT_NEAR(sample.place.x, 10, 1e-6);
    for (const auto& one : server.heard()) EXPECT_LE(length(one.force), kMostForce);
    EXPECT_FALSE(device->push({0, 1, 0}));
    EXPECT_EQ(device->read(sample, 0.001), State::gone);
    device->let_go();
    // The service is mended, and the next begins without force.
    server.what = Misbehaviour::none;
    std::string why;
    EXPECT_TRUE(eventually([&] { return device->reopen(why); })) << why;
    const int connection = server.connections();
    EXPECT_EQ(ticks(*device, sample, {0, 1, 0}, [&] { return sample.words > 0 && server.heard().back().force.z == 1; }),
              State::fine);
    const auto heard = server.heard();
    const auto first = std::find_if(heard.begin(), heard.end(), [&](const auto& one) { return one.connection == connection; });
    ASSERT_NE(first, heard.end());
    EXPECT_EQ(first->force, Point3{});
}

// While no answer comes it is told that there is no force, before it is given up.
TEST(Inverse3Loop, WhoDoesNotAnswerIsToldOfNoForce) {
    Inverse3Server server(Misbehaviour::mute, 100);
    const auto device = inverse3_arm(server.where());
    HapticSample sample;
    ticks(*device, sample, {0, 0, 4}, [] { return false; });
    EXPECT_EQ(server.heard().back().force, Point3{});
}

TEST(Inverse3Loop, OpeningTellsWhatIsWrong) {
    EXPECT_TRUE(holds(why_not("example.org:10001"), "\"example.org\" is another machine"));
    EXPECT_TRUE(holds(why_not("192.168.1.5"), "is another machine"));
    EXPECT_TRUE(holds(why_not("localhost:99999"), "a port is a number"));
    EXPECT_TRUE(holds(why_not("localhost:"), "a port is a number"));
    unsigned short port = 0;
    {
        Inverse3Server server;
        port = server.port();
    }
    const std::string nobody = why_not("localhost:" + std::to_string(port));
    EXPECT_TRUE(holds(nobody, "nobody listens at port " + std::to_string(port))) << nobody;
    const struct {
        Misbehaviour what;
        const char* why;
    } cases[] = {{Misbehaviour::no_web_socket, "is no WebSocket"},   {Misbehaviour::not_even_http, "is no WebSocket"},
                 {Misbehaviour::mute, "does not say what devices"},  {Misbehaviour::vanishes, "does not say what devices"},
                 {Misbehaviour::not_json, "is no Inverse Service"},  {Misbehaviour::deep, "has no Inverse3; plug"},
                 {Misbehaviour::no_device, "has no Inverse3; plug"}, {Misbehaviour::ten_megabytes, "does not say what devices"}};
    for (const auto& one : cases) {
        Inverse3Server server(one.what, -1);
        const std::string why = why_not(server.where());
        EXPECT_TRUE(holds(why, one.why)) << why;
    }
}

TEST(Inverse3Loop, OfSeveralOneIsNamed) {
    Inverse3Server server;
    server.devices = 2;
    const std::string why = why_not(server.where());
    EXPECT_TRUE(
        holds(why, "several devices are there: inverse3:" + server.where() + "/049D, inverse3:" + server.where() + "/04BA"))
        << why;
    EXPECT_TRUE(holds(why_not(server.where() + "/04BB"), "there is no device 04BB"));
    const auto device = inverse3_arm(server.where() + "/049D");
    HapticSample sample;
    ticks(*device, sample, {}, [&] { return sample.knows_place; });
    EXPECT_TRUE(sample.knows_place);
}

// A scene that pushes upwards everywhere.
class Push : public Scene {
public:
    Felt feel(const Touch&, double) noexcept override { return {{0, 2, 0}, 0, 0}; }
    void begin_again() noexcept override {}
};

TEST(Inverse3Loop, APlayWaitsForAServiceThatStarts) {
    Inverse3Server server(Misbehaviour::closes, 300);
    const auto device = inverse3_arm(server.where());
    Push scene;
    Playing play(scene, nullptr, {});
    std::string news;
    const double begin = MonotonicClock(false).now();
    const PlayLoop loop{
        1000, std::nullopt,
        [&] {
            const auto heard = server.heard();
            return MonotonicClock(false).now() > begin + 20 ||
                   (server.connections() > 1 && !heard.empty() && heard.back().connection > 1 && heard.back().force.z > 0.5);
        },
        [&](DeviceNews what, const std::string&) {
            news += what == DeviceNews::gone ? "gone " : what == DeviceNews::back ? "back " : "other ";
            server.what = Misbehaviour::none;
        }};
    MonotonicClock clock(false);
    const PlayLoopReport report = run_play(loop, clock, *device, play);
    EXPECT_EQ(report.gone, 1u);
    EXPECT_EQ(news, "gone back ");
    EXPECT_EQ(server.heard().back().force, Point3{});
}

}  // namespace
}  // namespace tactics::inverse3_test
