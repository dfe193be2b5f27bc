// SPDX-License-Identifier: Apache-2.0
// A WebSocket (RFC 6455) to a service of this machine. Messages of text, each wait bounded.
#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace tactics {

class WebSocket {
public:
    enum class State { message, nothing, gone };
    virtual ~WebSocket() = default;
    /// false: gone.
    virtual bool send(std::string_view text, std::chrono::milliseconds time) noexcept = 0;
    /// The next message, waiting at most that long. What is longer than `most` bytes, or breaks the protocol, ends the
    /// connection.
    virtual State receive(std::string& text, std::chrono::milliseconds time) noexcept = 0;
};

/// Connects to a port of this machine, by IPv4 or else by IPv6, without looking up names; nothing leaves the machine. `place` is
/// for its errors. Throws Error(failed) if nothing listens there, or it is no WebSocket. Takes at most `time` for each of the
/// two.
std::unique_ptr<WebSocket> open_local_web_socket(unsigned short port, std::size_t most, std::chrono::milliseconds time,
                                                 const std::string& place);

}  // namespace tactics
