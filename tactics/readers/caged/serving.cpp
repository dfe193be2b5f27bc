// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/caged/serving.h"

#include <signal.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <exception>
#include <new>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace tactics::caged {

namespace {

using Answer = void (*)(const std::vector<std::string>& lines);
using LimitsFor = CageLimits (*)(const std::vector<std::string>& lines);

void put_all(const void* bytes, std::size_t size) {
    const char* at = static_cast<const char*>(bytes);
    while (size > 0) {
        const ssize_t count = write(kAnswer, at, size);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) _exit(1);  // the reader is gone
        at += count;
        size -= static_cast<std::size_t>(count);
    }
}

std::vector<std::string> lines_of(std::string_view text) {
    std::vector<std::string> lines(1);
    for (const char c : text)
        if (c == '\n')
            lines.emplace_back();
        else
            lines.back() += c;
    return lines;
}

}  // namespace

void put(Frame kind, const void* bytes, std::size_t size) {
    if (size > UINT32_MAX) throw std::runtime_error("there is too much of it");
    const FrameHead head{kind, static_cast<std::uint32_t>(size)};
    put_all(&head, sizeof head);
    put_all(bytes, size);
}

[[noreturn]] void fail(std::string text) {
    throw std::runtime_error(text.empty() ? "its data end too early or make no sense" : std::move(text));
}

namespace {

void answer_or_complain(const std::string& request, Answer answer) {
    std::string why;
    try {
        const auto lines = lines_of(request);
        if (lines.size() < 3 || lines[0] != kVersion)
            fail("the program that reads it is of another version; install both together");
        return answer(lines);
    } catch (const std::bad_alloc&) {
        why = "it asks for more memory than it may have";
    } catch (const std::exception& error) {
        why = error.what();
    } catch (...) {
        why = "its data make no sense";
    }
    put(Frame::fault, why.data(), why.size());
}

struct Request {
    std::string text;
    std::array<int, 2> descriptors{-1, -1};
};

// Nothing where the program has gone.
std::optional<Request> next_request() {
    std::array<char, kMostRequest> text{};
    Request request;
    alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof request.descriptors)> control{};
    iovec part{text.data(), text.size()};
    msghdr message{};
    message.msg_iov = &part;
    message.msg_iovlen = 1;
    message.msg_control = control.data();
    message.msg_controllen = control.size();
    ssize_t count = 0;
    do count = recvmsg(kSocket, &message, MSG_CMSG_CLOEXEC);
    while (count < 0 && errno == EINTR);
    if (count <= 0) return {};
    request.text.assign(text.data(), static_cast<std::size_t>(count));
    const cmsghdr* held = CMSG_FIRSTHDR(&message);
    if (held != nullptr && held->cmsg_type == SCM_RIGHTS && held->cmsg_len == CMSG_LEN(sizeof request.descriptors))
        std::memcpy(request.descriptors.data(), CMSG_DATA(held), sizeof request.descriptors);
    return request;
}

[[noreturn]] void serve(const Request& request, pid_t parent, Answer answer, LimitsFor limits_for) {
    signal(SIGCHLD, SIG_DFL);
    if (dup2(request.descriptors[0], kFile) < 0 || dup2(request.descriptors[1], kAnswer) < 0) _exit(1);
    for (const int descriptor : request.descriptors) close(descriptor);
    close(kSocket);
    shut_in(kFile, parent, limits_for == nullptr ? CageLimits{} : limits_for(lines_of(request.text)));
    answer_or_complain(request.text, answer);
    _exit(0);
}

}  // namespace

void serve_requests(Answer answer, LimitsFor limits_for) {
    signal(SIGCHLD, SIG_IGN);  // no parent waits for them
    const pid_t own = getpid();
    while (const auto request = next_request()) {
        const pid_t copy = fork();
        if (copy == 0) serve(*request, own, answer, limits_for);
        for (const int descriptor : request->descriptors) close(descriptor);
    }
    _exit(0);  // without the libraries' taking leave
}

}  // namespace tactics::caged
