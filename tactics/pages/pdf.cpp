#include "tactics/pages/pdf.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>

#include "tactics/error.h"
#include "tactics/pages/xml.h"

extern char** environ;

namespace tactics {

namespace {

constexpr std::chrono::seconds kLongest{60};

// Both ends of a pipe, closed at the end.
struct Pipe {
    Pipe() {
        if (pipe2(ends, O_CLOEXEC) != 0) ends[0] = ends[1] = -1;
    }
    ~Pipe() {
        close_end(0);
        close_end(1);
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    void close_end(int end) {
        if (ends[end] >= 0) close(ends[end]);
        ends[end] = -1;
    }
    int ends[2];
};

// All that comes out; false when it takes too long or is too much.
bool read_all(int from, std::string& bytes) {
    const auto end = std::chrono::steady_clock::now() + kLongest;
    std::array<char, 1 << 16> buffer{};
    for (;;) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now()).count();
        pollfd ready{from, POLLIN, 0};
        const int polled = left > 0 ? poll(&ready, 1, static_cast<int>(left)) : 0;
        if (polled < 0 && errno == EINTR) continue;
        if (polled <= 0) return false;
        const ssize_t count = read(from, buffer.data(), buffer.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return false;
        if (count == 0) return true;
        bytes.append(buffer.data(), static_cast<std::size_t>(count));
        if (bytes.size() > kMostXmlBytes) return false;
    }
}

}  // namespace

std::string pdf_as_svg(const std::string& path) {
    // The second page, too, only to know that there is one. Without -noshrink and -nocenter it fits the page to a paper of
    // whole points, 0.1 % smaller. A name must not look like an option.
    std::array<std::string, 8> words{
        "pdftocairo", "-svg", "-noshrink", "-nocenter", "-l", "2", path.starts_with('-') ? "./" + path : path, "-"};
    std::array<char*, words.size() + 1> pointers{};
    for (std::size_t i = 0; i < words.size(); ++i) pointers[i] = words[i].data();
    Pipe pipe;
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, pipe.ends[1], 1);
    posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", O_WRONLY, 0);
    pid_t child = -1;
    const int fault = posix_spawnp(&child, pointers[0], &actions, nullptr, pointers.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (fault != 0)
        throw Error(Fault::failed, path,
                    fault == ENOENT
                        ? "to look at a PDF the program pdftocairo is needed and missing; install poppler-utils, or check the SVG"
                        : std::string("pdftocairo cannot be started: ") + std::strerror(fault) + "; check the SVG instead");
    pipe.close_end(1);
    std::string svg;
    const bool whole = read_all(pipe.ends[0], svg);
    pipe.close_end(0);
    if (!whole) kill(child, SIGKILL);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (!whole) throw Error(Fault::failed, path, "this PDF takes over a minute or 64 MB to be looked at; simplify its drawing");
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || svg.empty())
        throw Error(Fault::failed, path, "pdftocairo cannot read this PDF; open it in a viewer to see what is wrong");
    return svg;
}

}  // namespace tactics
