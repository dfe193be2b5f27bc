// SPDX-License-Identifier: Apache-2.0
#include "tactics/transport/child.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

extern char** environ;

namespace tactics {

namespace {

using Clock = std::chrono::steady_clock;

// A descriptor that is closed at the end.
class Open {
public:
    explicit Open(int number = -1) : number_(number) {}
    ~Open() { shut(); }
    Open(const Open&) = delete;
    Open& operator=(const Open&) = delete;
    void shut() {
        if (number_ >= 0) close(number_);
        number_ = -1;
    }
    int number_;
};

// The input as a file in memory: it is there as a whole, so that nobody waits for the other to read or write.
bool put(int file, std::string_view input) {
    while (!input.empty()) {
        const ssize_t count = write(file, input.data(), input.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return false;
        input.remove_prefix(static_cast<std::size_t>(count));
    }
    return lseek(file, 0, SEEK_SET) == 0;
}

constexpr std::size_t kMostComplaint = 4096;

// What is there of its standard error, without waiting; only the beginning is kept.
void hear_complaint(int from, std::string& err) {
    std::array<char, 1024> buffer{};
    for (ssize_t count; (count = read(from, buffer.data(), buffer.size())) > 0 || (count < 0 && errno == EINTR);)
        if (count > 0)
            err.append(buffer.data(),
                       std::min(static_cast<std::size_t>(count), kMostComplaint - std::min(kMostComplaint, err.size())));
}

ChildAnswer::End hear(int from, int complaint, ChildAnswer& answer, Clock::time_point end, std::size_t most) {
    std::array<char, 1 << 16> buffer{};
    for (;;) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
        pollfd ready[2]{{from, POLLIN, 0}, {complaint, POLLIN, 0}};
        const int polled = left > 0 ? poll(ready, 2, static_cast<int>(std::min<long long>(left, 60'000))) : 0;
        if (polled < 0 && errno == EINTR) continue;
        if (polled < 0) return ChildAnswer::End::failed;
        if (polled == 0) {
            if (left > 60'000) continue;
            return ChildAnswer::End::too_long;
        }
        if ((ready[1].revents & POLLIN) != 0)
            hear_complaint(complaint, answer.err);
        else if (ready[1].revents != 0)
            complaint = -1;  // it closed that; poll looks at it no more
        if (ready[0].revents == 0) continue;
        const ssize_t count = read(from, buffer.data(), buffer.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return ChildAnswer::End::failed;
        if (count == 0) return ChildAnswer::End::done;
        answer.out.append(buffer.data(), static_cast<std::size_t>(count));
        if (answer.out.size() > most) return ChildAnswer::End::too_much;
    }
}

std::vector<char*> pointers_to(std::vector<std::string>& texts) {
    std::vector<char*> pointers;
    for (std::string& text : texts) pointers.push_back(text.data());
    pointers.push_back(nullptr);
    return pointers;
}

std::vector<std::string> environment_with(std::vector<std::string> settings) {
    const std::size_t own = settings.size();
    for (char** one = environ; one != nullptr && *one != nullptr; ++one) {
        const std::string_view text = *one;
        const auto name = text.substr(0, text.find('=') + 1);
        const bool replaced = std::any_of(settings.begin(), settings.begin() + static_cast<std::ptrdiff_t>(own),
                                          [&](const std::string& setting) { return setting.starts_with(name); });
        if (!replaced) settings.emplace_back(text);
    }
    return settings;
}

// A program may close its output and go on. It has until `end`, too.
int wait_for(pid_t child, Clock::time_point end) {
    int status = 0;
    for (;;) {
        const pid_t gone = waitpid(child, &status, WNOHANG);
        if (gone == child) return status;
        if (gone < 0 && errno != EINTR) return -1;
        if (Clock::now() >= end) kill(-child, SIGKILL);
        poll(nullptr, 0, 2);
    }
}

}  // namespace

ChildAnswer run_child(const std::vector<std::string>& words, std::string_view input, const ChildLimits& limits,
                      const std::vector<std::string>& settings) {
    const auto end = Clock::now() + limits.time;
    ChildAnswer answer;
    const auto fault = [&](int number) {
        answer.end = number == ENOENT ? ChildAnswer::End::missing : ChildAnswer::End::failed;
        answer.fault = std::strerror(number);
        return answer;
    };
    Open in(input.empty() ? open("/dev/null", O_RDONLY | O_CLOEXEC) : memfd_create("input", MFD_CLOEXEC));
    if (in.number_ < 0 || (!input.empty() && !put(in.number_, input))) return fault(errno == ENOENT ? EIO : errno);
    int ends[2] = {-1, -1};
    if (pipe2(ends, O_CLOEXEC) != 0) return fault(errno);
    Open from(ends[0]), to(ends[1]);
    if (pipe2(ends, O_CLOEXEC) != 0) return fault(errno);
    Open complaint(ends[0]), complained(ends[1]);
    fcntl(complaint.number_, F_SETFL, O_NONBLOCK);

    std::vector<std::string> own_words = words, own_settings = environment_with(settings);
    std::vector<char*> arguments = pointers_to(own_words), environment = pointers_to(own_settings);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, in.number_, 0);
    posix_spawn_file_actions_adddup2(&actions, to.number_, 1);
    posix_spawn_file_actions_adddup2(&actions, complained.number_, 2);
    // A group of its own, so that what it starts ends with it; and Ctrl-C, which a batch holds back for itself, is not held back
    // from it.
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t none;
    sigemptyset(&none);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);
    pid_t child = -1;
    const int number = posix_spawnp(&child, arguments[0], &actions, &attributes, arguments.data(), environment.data());
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
    if (number != 0) return fault(number);
    to.shut();
    complained.shut();
    answer.end = hear(from.number_, complaint.number_, answer, end, limits.bytes);
    from.shut();
    const bool heard = answer.end == ChildAnswer::End::done;
    const int status = wait_for(child, heard ? end : Clock::now());
    hear_complaint(complaint.number_, answer.err);
    if (heard && (!WIFEXITED(status) || WEXITSTATUS(status) != 0))
        answer.end = Clock::now() >= end ? ChildAnswer::End::too_long : ChildAnswer::End::failed;
    return answer;
}

}  // namespace tactics
