// SPDX-License-Identifier: Apache-2.0
// By Boost.Beast, which is headers alone: the only file that sees it.
#include "tactics/transport/web_socket.h"

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <optional>

#include "tactics/error.h"

namespace tactics {

namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
using Stream = beast::websocket::stream<beast::tcp_stream, false>;  // what is not compressed needs no compressor compiled
using std::chrono::milliseconds;
using Fate = std::optional<beast::error_code>;  // result of the operation; nothing while it is in progress

constexpr milliseconds kFarewell{100};

class LocalWebSocket : public WebSocket {
public:
    LocalWebSocket(unsigned short port, std::size_t most, milliseconds time, const std::string& place) {
        if (!connect(asio::ip::address_v4::loopback(), port, time) && !connect(asio::ip::address_v6::loopback(), port, time))
            throw Error(Fault::failed, place, phrase("nobody listens at port {0} of this machine", std::to_string(port)));
        beast::error_code unheeded;
        beast::get_lowest_layer(*stream_).socket().set_option(asio::ip::tcp::no_delay(true), unheeded);
        stream_->read_message_max(most);
        Fate fate;
        stream_->async_handshake("localhost:" + std::to_string(port), "/", [&](beast::error_code error) { fate = error; });
        if (!finish(fate, time) || *fate)
            throw Error(Fault::failed, place,
                        fate && *fate ? phrase("who listens at port {0} of this machine is no WebSocket ({1})",
                                               std::to_string(port), fate->message())
                                      : phrase("who listens at port {0} of this machine is no WebSocket", std::to_string(port)));
    }
    ~LocalWebSocket() override {
        try {
            if (!gone_) {
                Fate fate;
                stream_->async_close(beast::websocket::close_code::normal, [&](beast::error_code error) { fate = error; });
                finish(fate, kFarewell);
            }
            give_up();
        } catch (...) {
            // It is gone all the same.
        }
    }
    LocalWebSocket(const LocalWebSocket&) = delete;
    LocalWebSocket& operator=(const LocalWebSocket&) = delete;

    bool send(std::string_view text, milliseconds time) noexcept override {
        try {
            if (gone_) return false;
            Fate fate;
            stream_->text(true);
            stream_->async_write(asio::buffer(text.data(), text.size()),
                                 [&](beast::error_code error, std::size_t) { fate = error; });
            if (!finish(fate, time) || *fate) lose();
        } catch (...) {
            lose();
        }
        return !gone_;
    }

    State receive(std::string& text, milliseconds time) noexcept override {
        try {
            if (gone_) return State::gone;
            if (!reading_) {
                read_.reset();
                reading_ = true;
                stream_->async_read(buffer_, [this](beast::error_code error, std::size_t) { read_ = error; });
            }
            run(read_, time);
            if (!read_) return State::nothing;
            reading_ = false;
            if (*read_) {
                lose();
                return State::gone;
            }
            text.assign(static_cast<const char*>(buffer_.data().data()), buffer_.size());
            buffer_.consume(buffer_.size());
            return State::message;
        } catch (...) {
            lose();
            return State::gone;
        }
    }

private:
    bool connect(const asio::ip::address& address, unsigned short port, milliseconds time) {
        stream_.emplace(io_);
        Fate fate;
        beast::get_lowest_layer(*stream_).async_connect(asio::ip::tcp::endpoint(address, port),
                                                        [&](beast::error_code error) { fate = error; });
        return finish(fate, time) && !*fate;
    }
    // Waits until it is sent, at most that long; a message being read continues at the same time.
    void run(const Fate& fate, milliseconds time) {
        const auto end = std::chrono::steady_clock::now() + time;
        io_.restart();
        io_.poll();
        io_.restart();
        while (!fate && io_.run_one_until(end) > 0) {
        }
    }
    // false: not in that time, and it was given up, for what it writes to goes out of sight.
    bool finish(const Fate& fate, milliseconds time) {
        run(fate, time);
        if (fate) return true;
        give_up();
        return false;
    }
    void give_up() {
        beast::error_code ignored;
        beast::get_lowest_layer(*stream_).socket().close(ignored);
        io_.restart();
        io_.run();  // completes the cancelled operation
        reading_ = false;
    }
    void lose() noexcept {
        try {
            give_up();
        } catch (...) {
            // It is gone all the same.
        }
        gone_ = true;
    }

    asio::io_context io_{1};
    std::optional<Stream> stream_;
    beast::flat_buffer buffer_;
    Fate read_;
    bool reading_ = false, gone_ = false;
};

}  // namespace

std::unique_ptr<WebSocket> open_local_web_socket(unsigned short port, std::size_t most, milliseconds time,
                                                 const std::string& place) {
    return std::make_unique<LocalWebSocket>(port, most, time, place);
}

}  // namespace tactics
