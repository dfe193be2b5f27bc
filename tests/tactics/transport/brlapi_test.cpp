// SPDX-License-Identifier: Apache-2.0
// A screen reader that falls silent: a server that speaks BrlAPI (protocol 8; BRLTTY's manual, "BrlAPI's protocol") up to a
// point.
#include <arpa/inet.h>
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <map>
#include <string>
#include <vector>

#include "tactics/error.h"
#include "tactics/transport/cell_display.h"

namespace tactics::brlapi_test {
namespace {

using Packet = std::array<std::uint32_t, 2>;  // its size and its kind, the first byte highest

bool take(int line, void* bytes, std::size_t size) {
    return size == 0 || recv(line, bytes, size, MSG_WAITALL) == static_cast<ssize_t>(size);
}

void say(int line, char kind, const std::vector<std::uint32_t>& numbers) {
    std::vector<std::uint32_t> words{static_cast<std::uint32_t>(4 * numbers.size()), static_cast<std::uint32_t>(kind)};
    words.insert(words.end(), numbers.begin(), numbers.end());
    for (std::uint32_t& word : words) word = htonl(word);
    send(line, words.data(), 4 * words.size(), MSG_NOSIGNAL);
}

// Answers that many packets, then listens silently until the other end has gone.
void serve(int line, int answers) {
    constexpr std::uint32_t kVersion = 8, kNoKeyAsked = 'N', kColumns = 20, kLines = 2;
    const std::map<char, std::vector<std::uint32_t>> words{{'a', {}}, {'s', {kColumns, kLines}}, {'v', {kNoKeyAsked}}};
    if (answers-- > 0) say(line, 'v', {kVersion});
    Packet head{};
    while (take(line, head.data(), sizeof head)) {
        std::vector<char> rest(ntohl(head[0]));
        if (!take(line, rest.data(), rest.size())) return;
        const char kind = static_cast<char>(ntohl(head[1]));
        if (kind == 'w' || answers-- <= 0) continue;  // what is written is not answered
        say(line,
            kind == 'v'   ? 'a'
            : kind == 's' ? 's'
                          : 'A',
            words.contains(kind) ? words.at(kind) : std::vector<std::uint32_t>());
    }
}

// In a process of its own, as what waits in vain waits for the life of one.
std::string used(int port) {
    try {
        const auto display = open_brlapi("127.0.0.1:" + std::to_string(port - 4101), std::chrono::milliseconds(300));
        display->show(std::vector<std::uint8_t>(40, 1));
        return std::to_string(display->size().columns);
    } catch (const Error& error) {
        return error.what();
    }
}

std::string told_by_a_copy(int answers) {
    const int server = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in place{};
    place.sin_family = AF_INET;
    place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof place;
    std::array<int, 2> ends{};
    EXPECT_TRUE(bind(server, reinterpret_cast<sockaddr*>(&place), size) == 0 && listen(server, 1) == 0 &&
                getsockname(server, reinterpret_cast<sockaddr*>(&place), &size) == 0 && pipe(ends.data()) == 0);
    const pid_t copy = fork();
    if (copy == 0) {
        alarm(20);  // and not for ever, where it would wait so long
        close(server);
        const std::string told = used(ntohs(place.sin_port));
        _exit(write(ends[1], told.data(), told.size()) < 0 ? 1 : 0);
    }
    close(ends[1]);
    const int line = accept(server, nullptr, nullptr);
    serve(line, answers);
    std::array<char, 1000> told{};
    const ssize_t count = read(ends[0], told.data(), told.size());
    waitpid(copy, nullptr, 0);
    for (const int end : {server, line, ends[0]}) close(end);
    return {told.data(), static_cast<std::size_t>(count > 0 ? count : 0)};
}

TEST(BrlApi, ASilentScreenReaderIsNotWaitedForWithoutEnd) {
    void* library = dlopen("libbrlapi.so.0.8", RTLD_NOW);
    if (library == nullptr) GTEST_SKIP() << "libbrlapi0.8 is missing";
    // Its version, who may use it, the size, the console; and the fifth word is that the console is given back.
    for (int answers = 0; answers < 4; ++answers)
        EXPECT_NE(told_by_a_copy(answers).find("brlapi: the screen reader does not answer; start BRLTTY"), std::string::npos)
            << answers;
    EXPECT_EQ(told_by_a_copy(4), "20");
    EXPECT_EQ(told_by_a_copy(5), "20");
}

}  // namespace
}  // namespace tactics::brlapi_test
