// SPDX-License-Identifier: Apache-2.0
#include <sched.h>
#include <sys/prctl.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>
#include <utility>

#include "tactics/error.h"
#include "tactics/haptics/devices/arm_devices.h"
#include "tactics/haptics/devices/device_kind.h"
#include "tactics/haptics/devices/inverse3_messages.h"
#include "tactics/transport/web_socket.h"
#include "tactics/units.h"

namespace tactics {

namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

constexpr microseconds kInverse3Pace{500};  // between two messages: twice as often as a loop asks, and no core is worn out
constexpr milliseconds kOpens{1000};        // until the service has answered at all
constexpr milliseconds kAnswers{500};       // until it is taken to be gone
constexpr milliseconds kDoubted{20};        // without an answer: zero force is sent once more
constexpr milliseconds kPiece{5};           // of a wait, to see whether somebody ends it
constexpr milliseconds kFarewell{100};      // until it has answered that there is no force any more
constexpr int kMostUnasked = 64;            // messages of a turn
// Just below that of the loop that it serves.
constexpr int kInverse3Priority = 79;

// One connection: its thread sends a force, waits for the answer and hands it over, until it is ended or the service is gone.
class Exchange {
public:
    Exchange(std::unique_ptr<WebSocket> socket, std::string id, ArmTalk& talk)
        : socket_(std::move(socket)), id_(std::move(id)), talk_(talk), thread_([this] { run(); }) {}
    ~Exchange() {
        ended_ = true;
        thread_.join();
    }
    Exchange(const Exchange&) = delete;
    Exchange& operator=(const Exchange&) = delete;

private:
    void send(const Point3& force, bool first) {
        if (!socket_->send(inverse3_request(id_, force, first), kAnswers)) talk_.lose();
        ++unanswered_;
    }

    // false: none came in that time.
    bool hear(milliseconds time) {
        const WebSocket::State state = socket_->receive(text_, time);
        if (state == WebSocket::State::gone) talk_.lose();
        if (state != WebSocket::State::message) return false;
        if (unanswered_ > 0) --unanswered_;
        if (const auto word = inverse3_word(text_, id_)) {
            // The first answer may still be in the axes of who spoke before.
            if (answered_) talk_.tell(*word);
            answered_ = true;
            sensible_ = Clock::now();
        }
        return true;
    }

    void hear_answers(Clock::time_point begun) {
        bool doubted = false;
        while (!talk_.gone() && unanswered_ > 0) {
            hear(kPiece);
            const auto silent = Clock::now() - begun;
            if (unanswered_ > 0 && silent > kDoubted && !doubted) {
                doubted = true;
                send({}, false);
            }
            if (silent > (ended_ ? kFarewell : kAnswers)) talk_.lose();
        }
        // A service that answers more often than asked would be read later and later.
        for (int i = 0; i < kMostUnasked && hear(milliseconds{0}); ++i) {
        }
    }

    void run() noexcept {
        prctl(PR_SET_TIMERSLACK, 1, 0, 0, 0);
        sched_param priority{};
        priority.sched_priority = kInverse3Priority;
        sched_setscheduler(0, SCHED_FIFO, &priority);
        try {
            talk();
        } catch (...) {
            // No memory: as if it were gone.
        }
        talk_.lose();
    }

    void talk() {
        sensible_ = Clock::now();
        bool first = true, over = false;
        while (!talk_.gone() && !over) {
            const auto begun = Clock::now();
            over = ended_.load();
            const bool zero = over || talk_.lets_go();
            // Until it has answered, who knows in whose axes a force would be taken.
            send(zero || !answered_ ? Point3{} : talk_.force(), first);
            first = false;
            hear_answers(begun);
            if (zero && !talk_.gone()) talk_.has_let_go();
            if (Clock::now() - sensible_ > kAnswers) talk_.lose();
            std::this_thread::sleep_until(begun + kInverse3Pace);
        }
    }

    std::unique_ptr<WebSocket> socket_;
    std::string id_, text_;
    ArmTalk& talk_;
    unsigned unanswered_ = 0;
    bool answered_ = false;
    Clock::time_point sensible_;  // when it said something that could be
    std::atomic<bool> ended_{false};
    std::thread thread_;  // the last, as it needs the others
};

struct Place {
    unsigned short port = 0;
    std::string id;      // empty: the only one
    std::string spoken;  // for messages
};

Place place_of(const std::string& where) {
    Place place;
    const auto slash = where.find('/');
    if (slash != std::string::npos) place.id = where.substr(slash + 1);
    std::string host = where.substr(0, slash), port(kInversePort);
    const auto colon = host.rfind(':');
    const bool bracketed = colon != std::string::npos && host.find(']', colon) != std::string::npos;
    if (colon != std::string::npos && !bracketed) {
        port = host.substr(colon + 1);
        host.resize(colon);
    } else if (!host.empty() && host.find_first_not_of("0123456789") == std::string::npos) {
        port = std::exchange(host, "");
    }
    if (!host.empty() && host != "localhost" && host != "127.0.0.1" && host != "[::1]")
        throw Error(Fault::usage, spelled("device"),
                    phrase("\"{0}\" is another machine; the Inverse Service is asked on this one only, as nothing on the way is "
                           "encrypted: inverse3: or inverse3:localhost:10001",
                           host.substr(0, 80)));
    const auto number = parse_number(port);
    if (!number || *number < 1 || *number > 65535 || port.find_first_not_of("0123456789") != std::string::npos)
        throw Error(Fault::usage, spelled("device"), phrase("a port is a number from 1 to 65535: inverse3:localhost:10001"));
    place.port = static_cast<unsigned short>(*number);
    place.spoken = "inverse3:localhost:" + port;
    return place;
}

class Inverse3 : public TalkedArm {
public:
    explicit Inverse3(const std::string& where) : place_(place_of(where)) { open(); }

    bool reopen(std::string& why) override {
        why.clear();
        exchange_.reset();
        talk_.reset();
        try {
            open();
            return true;
        } catch (const Error& error) {
            // Waits for a missing device; reports if the user has to choose.
            if (several_) why = error.what();
            return false;
        }
    }

private:
    void open() {
        several_ = false;
        std::unique_ptr<WebSocket> socket = open_local_web_socket(place_.port, kMostInverseMessage, kOpens, place_.spoken);
        std::string text;
        if (socket->receive(text, kOpens) != WebSocket::State::message)
            throw Error(Fault::failed, place_.spoken,
                        phrase("who listens there does not say what devices it has, as an Inverse Service does"));
        const auto ids = inverse3_ids(text);
        if (!ids)
            throw Error(Fault::failed, place_.spoken, phrase("who listens there is no Inverse Service from version 3.1 on"));
        const std::string id = chosen(*ids);
        talk_ = std::make_unique<ArmTalk>();
        exchange_ = std::make_unique<Exchange>(std::move(socket), id, *talk_);
    }

    std::string chosen(const std::vector<std::string>& ids) {
        if (ids.empty())
            throw Error(Fault::failed, place_.spoken,
                        phrase("the Inverse Service has no Inverse3; plug it in, with its power supply"));
        if (place_.id.empty() && ids.size() == 1) return ids[0];
        if (std::find(ids.begin(), ids.end(), place_.id) != ids.end()) return place_.id;
        std::string all;
        for (std::size_t i = 0; i < std::min<std::size_t>(ids.size(), 8); ++i)
            all += (all.empty() ? "" : ", ") + place_.spoken + "/" + ids[i];
        several_ = place_.id.empty();
        throw Error(Fault::failed, place_.spoken,
                    several_ ? phrase("several devices are there: {0}; name one of them", all)
                             : phrase("there is no device {0}; there are: {1}; name one of them", place_.id.substr(0, 80), all));
    }

    Place place_;
    bool several_ = false;
    std::unique_ptr<Exchange> exchange_;  // after the talk, which it needs
};

std::unique_ptr<HapticDevice> open_inverse3(const DeviceWish& wish) { return inverse3_arm(wish.where); }

}  // namespace

std::unique_ptr<HapticDevice> inverse3_arm(const std::string& where) { return std::make_unique<Inverse3>(where); }

extern const DeviceKind inverse3_device;
const DeviceKind inverse3_device{.name = "inverse3",
                                 .address = "localhost:10001",
                                 .example = "inverse3:, inverse3:localhost:10001",
                                 .real = true,
                                 .axes = 3,
                                 .open = open_inverse3};

}  // namespace tactics
