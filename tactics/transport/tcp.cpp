// SPDX-License-Identifier: Apache-2.0
// Raw bytes to a machine in the network, as printers take them at port 9100.
#include <fcntl.h>
#include <netdb.h>
#include <poll.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "tactics/error.h"
#include "tactics/transport/channels.h"
#include "tactics/transport/descriptor.h"

namespace tactics {

namespace {

class Tcp : public Channel {
public:
    explicit Tcp(Descriptor socket) : socket_(std::move(socket)) {}

    Taken take(std::string_view bytes) override {
        for (;;) {
            const ssize_t count = send(socket_.number(), bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
            if (count >= 0) return {static_cast<std::size_t>(count)};
            if (errno == EINTR) continue;
            if (errno == EAGAIN) return {};
            if (errno == EPIPE || errno == ECONNRESET || errno == ETIMEDOUT || errno == EHOSTUNREACH) return {0, Ending::gone};
            return {0, Ending::failed, std::strerror(errno)};
        }
    }
    bool wait(std::chrono::milliseconds time) override { return wait_for(socket_.number(), time); }
    Ending trouble() override { return is_closed() ? Ending::gone : Ending::stalled; }
    // What the other side has not confirmed yet.
    std::size_t on_the_way() override {
        int count = 0;
        if (ioctl(socket_.number(), TIOCOUTQ, &count) != 0 || count < 0) return 0;
        return static_cast<std::size_t>(count);
    }

    void discard() override {
        const linger at_once{1, 0};
        setsockopt(socket_.number(), SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
    }

private:
    bool is_closed() const {
        pollfd state{socket_.number(), 0, 0};
        return poll(&state, 1, 0) > 0 && (state.revents & (POLLERR | POLLHUP)) != 0;
    }
    Descriptor socket_;
};

}  // namespace

std::unique_ptr<Channel> open_tcp(const std::string& host, const std::string& port) {
    constexpr int kPatience = 10'000;  // ms for each address
    const std::string place = host + ":" + port;
    addrinfo wish{};
    wish.ai_socktype = SOCK_STREAM;
    wish.ai_flags = AI_ADDRCONFIG;
    addrinfo* found = nullptr;
    if (const int fault = getaddrinfo(host.c_str(), port.c_str(), &wish, &found); fault != 0)
        throw Error(Fault::failed, place,
                    phrase("is not found in the network: {0}; look its address up on the machine", gai_strerror(fault)));
    const std::unique_ptr<addrinfo, void (*)(addrinfo*)> all(found, &freeaddrinfo);
    std::string why = "it does not answer";
    for (const addrinfo* one = all.get(); one != nullptr; one = one->ai_next) {
        Descriptor socket(::socket(one->ai_family, one->ai_socktype | SOCK_NONBLOCK | SOCK_CLOEXEC, one->ai_protocol));
        if (socket.number() < 0) continue;
        int fault = connect(socket.number(), one->ai_addr, one->ai_addrlen) == 0 ? 0 : errno;
        if (fault == EINPROGRESS) {
            pollfd ready{socket.number(), POLLOUT, 0};
            socklen_t size = sizeof fault;
            if (poll(&ready, 1, kPatience) <= 0)
                fault = ETIMEDOUT;
            else
                getsockopt(socket.number(), SOL_SOCKET, SO_ERROR, &fault, &size);
        }
        if (fault == 0) return std::make_unique<Tcp>(std::move(socket));
        why = std::strerror(fault);
    }
    throw Error(Fault::failed, place,
                phrase("no connection: {0}; switch the machine on, and see that it takes raw bytes at this port", why));
}

}  // namespace tactics
