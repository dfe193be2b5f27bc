// SPDX-License-Identifier: Apache-2.0
// A service that speaks to an Inverse3 on loopback, as Haply's documents have it (inverse3_messages.h names them), with a handle
// behind it; and all that such a service could do wrong. It is written with sockets alone: of what it is to test, it has nothing.
#pragma once

#include <atomic>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "tactics/point3.h"

namespace tactics::tests {

/// What it does from the message number `after` on, counted from 0 in each connection; -1 for the inventory, too.
enum class Misbehaviour {
    none,
    mute,           ///< reads, and answers nothing
    deaf,           ///< does not even read
    not_json,       ///< a text that is none
    half_json,      ///< the answer, cut in two
    not_a_number,   ///< NaN where a place should be
    huge,           ///< a place of 1e300 m, and one past all numbers in turn
    far,            ///< a place of 40 m
    no_place,       ///< no cursor_position
    a_text_for_x,   ///< "x": "0.1"
    another_id,     ///< the state of another device
    no_device,      ///< an empty list
    deep,           ///< 100,000 brackets
    ten_megabytes,  ///< a message of that size
    binary,         ///< the answer in a binary frame
    fragments,      ///< each answer in single letters: allowed
    pings,          ///< a ping before each answer: allowed
    twice,          ///< two answers to each message
    broken_frame,   ///< a frame with an opcode that there is not
    masked_frame,   ///< a frame that a client may send only
    closes,         ///< the farewell of the protocol
    vanishes,       ///< the connection is reset
    no_web_socket,  ///< answers the handshake with 404
    not_even_http,  ///< answers the handshake with something else
};

class Inverse3Server {
public:
    /// Listens on a port of the kernel's choice. `after`: see Misbehaviour.
    explicit Inverse3Server(Misbehaviour what = Misbehaviour::none, int after = 0);
    ~Inverse3Server();
    Inverse3Server(const Inverse3Server&) = delete;
    Inverse3Server& operator=(const Inverse3Server&) = delete;

    unsigned short port() const { return port_; }
    std::string where() const { return "localhost:" + std::to_string(port_); }

    std::atomic<Misbehaviour> what;
    std::atomic<int> after;
    std::atomic<int> devices{1};  ///< how many Inverse3 are there: 049D, 04BA
    std::atomic<bool> ready{true}, calibrated{true}, button{false};
    std::atomic<bool> held{true};  ///< a hand holds the handle where it is; else the force moves it

    struct Heard {
        double time = 0;  ///< s
        Point3 force;     ///< N
        int connection = 0;
    };
    std::vector<Heard> heard() const;           ///< set_cursor_force of 049D, in their order
    std::vector<std::string> messages() const;  ///< the first of each connection
    Point3 handle() const;                      ///< m
    int connections() const { return accepted_; }
    int bad_messages() const { return bad_; }  ///< that this service does not understand
    int pongs() const { return pongs_; }
    int farewells() const { return farewells_; }  ///< that were said to it

private:
    void serve();
    void talk(int socket);
    bool answer(int socket, int number);
    bool take(const std::string& message, int number);
    void move();
    std::string state(bool inventory);
    std::string wrong(int number, const std::string& right);

    int listener_ = -1;
    unsigned short port_ = 0;
    std::atomic<bool> ended_{false};
    std::atomic<int> accepted_{0}, bad_{0}, pongs_{0}, farewells_{0};
    mutable std::mutex mutex_;
    std::vector<Heard> heard_;
    std::vector<std::string> messages_;
    Point3 place_{0.01, -0.02, 0.03}, velocity_, force_;
    double moved_ = 0;  // s
    std::thread thread_;
};

}  // namespace tactics::tests
