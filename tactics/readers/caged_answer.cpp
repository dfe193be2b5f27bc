// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/caged_answer.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <map>
#include <mutex>

#include "tactics/error.h"
#include "tactics/transport/program_folder.h"

extern char** environ;

namespace tactics {

namespace {

constexpr std::size_t kMostFault = 1000;

std::string path_of_program(const std::string& place, const caged::Program& wanted) {
    std::string path = own_program(wanted.name);
    if (!path.empty()) return path;
    throw Error(
        Fault::failed, place,
        phrase("needs the program {0}, which is not installed; install it beside tactics, or {1}", wanted.name, wanted.instead));
}

// It hears of our end by the socket's, so that nothing of it stays.
struct Started {
    Started() = default;
    Started(const Started&) = delete;
    Started& operator=(const Started&) = delete;
    ~Started() { end(); }
    void end() {
        if (socket >= 0) close(socket);
        socket = -1;
        while (process > 0 && waitpid(process, nullptr, 0) < 0 && errno == EINTR) continue;
        process = -1;
    }
    int socket = -1;
    pid_t process = -1;
};

void start(const std::string& place, const caged::Program& wanted, Started& program) {
    std::string path = path_of_program(place, wanted);
    int ends[2] = {-1, -1};
    const auto fail = [&](int number) {
        for (const int end : ends)
            if (end >= 0) close(end);
        throw Error(Fault::failed, place, phrase("{0} cannot be started: {1}; {2}", path, std::strerror(number), wanted.instead));
    };
    if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0) fail(errno);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    // If the socket already has that number, this removes its close-on-exec flag.
    posix_spawn_file_actions_adddup2(&actions, ends[1], caged::kSocket);
    for (const int number : {0, 1, 2}) posix_spawn_file_actions_addopen(&actions, number, "/dev/null", O_RDWR, 0);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    // A separate process group: Ctrl-C, which ends a batch after its current pages, must not reach it.
    sigset_t none, usual;
    sigemptyset(&none);
    sigfillset(&usual);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setsigdefault(&attributes, &usual);
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    std::array<char*, 2> arguments{path.data(), nullptr};
    const int number = posix_spawn(&program.process, path.c_str(), &actions, &attributes, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
    if (number != 0) fail(number);
    close(ends[1]);
    program.socket = ends[0];
}

bool send_packet(int socket, const std::string& text, const std::array<int, 2>& descriptors) {
    alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof descriptors)> control{};
    iovec part{const_cast<char*>(text.data()), text.size()};
    msghdr message{};
    message.msg_iov = &part;
    message.msg_iovlen = 1;
    message.msg_control = control.data();
    message.msg_controllen = control.size();
    cmsghdr* held = CMSG_FIRSTHDR(&message);
    held->cmsg_level = SOL_SOCKET;
    held->cmsg_type = SCM_RIGHTS;
    held->cmsg_len = CMSG_LEN(sizeof descriptors);
    std::memcpy(CMSG_DATA(held), descriptors.data(), sizeof descriptors);
    ssize_t count = 0;
    do count = sendmsg(socket, &message, MSG_NOSIGNAL);
    while (count < 0 && errno == EINTR);
    return count == static_cast<ssize_t>(text.size());
}

// Started by the first that asks, and once more where it has gone.
void ask(const std::string& place, const caged::Program& wanted, const std::string& text, const std::array<int, 2>& descriptors) {
    static std::mutex guard;
    static std::map<std::string_view, Started> all;
    const std::lock_guard lock(guard);
    Started& program = all[wanted.name];
    for (int attempt = 0; attempt < 2; ++attempt) {
        if (program.socket < 0) start(place, wanted, program);
        if (send_packet(program.socket, text, descriptors)) return;
        program.end();
    }
    throw Error(Fault::failed, place,
                phrase("{0} does not answer; install it and tactics together, or {1}", wanted.name, wanted.instead));
}

}  // namespace

CagedAnswer::CagedAnswer(const std::string& place, const CagedRequest& request) {
    std::string text = caged::kVersion;
    for (const std::string_view line : {request.verb, request.format}) (text += '\n') += line;
    for (const std::string& line : request.rest) (text += '\n') += line;
    if (text.size() > caged::kMostRequest) throw Error(Fault::failed, place, phrase("has words that are too long"));
    int ends[2] = {-1, -1};
    if (pipe2(ends, O_CLOEXEC) != 0) throw Error(Fault::failed, place, phrase("cannot be read: {0}", std::strerror(errno)));
    pipe_ = ends[0];
    try {
        ask(place, *request.program, text, {request.file, ends[1]});
    } catch (...) {
        close(ends[1]);
        close(pipe_);
        throw;
    }
    close(ends[1]);
}

CagedAnswer::~CagedAnswer() { close(pipe_); }

bool CagedAnswer::take(void* bytes, std::size_t size) {
    char* at = static_cast<char*>(bytes);
    while (size > 0) {
        const ssize_t count = ::read(pipe_, at, size);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) break;
        at += count;
        size -= static_cast<std::size_t>(count);
    }
    if (size > 0) why_ = "the library that reads it gave up on it";
    return size == 0;
}

bool CagedAnswer::head(caged::Frame kind, std::size_t& size) {
    caged::FrameHead head;
    if (!take(&head, sizeof head)) return false;
    size = head.size;
    if (head.kind == kind) return true;
    std::string text(head.kind == caged::Frame::fault ? std::min<std::size_t>(head.size, kMostFault) : 0, ' ');
    if (text.empty() || !take(text.data(), text.size()))
        why_ = "the library that reads it makes no sense of it";
    else
        why_ = text;
    return false;
}

bool CagedAnswer::begins(caged::Frame kind, std::size_t size) {
    std::size_t found = 0;
    if (!head(kind, found)) return false;
    if (found == size) return true;
    why_ = "the library that reads it makes no sense of it";
    return false;
}

bool CagedAnswer::read(caged::Frame kind, void* bytes, std::size_t size) { return begins(kind, size) && take(bytes, size); }

bool CagedAnswer::read(caged::Frame kind, std::string& bytes, std::size_t most) {
    std::size_t found = 0;
    if (!head(kind, found)) return false;
    if (found > most) {
        why_ = "there is too much of it";
        return false;
    }
    bytes.resize(found);
    return take(bytes.data(), found);
}

}  // namespace tactics
