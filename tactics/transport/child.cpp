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
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <mutex>
#include <set>

#include "tactics/transport/program_folder.h"

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

bool put(int file, std::string_view input) {
    while (!input.empty()) {
        const ssize_t count = write(file, input.data(), input.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return false;
        input.remove_prefix(static_cast<std::size_t>(count));
    }
    return lseek(file, 0, SEEK_SET) == 0;
}

// The input as a file in memory: it is complete from the start, so neither side waits for the other. -1: no memory.
int kept_in_memory(std::string_view input) {
    if (input.empty()) return open("/dev/null", O_RDONLY | O_CLOEXEC);
    const int file = memfd_create("input", MFD_CLOEXEC);
    if (file < 0 || put(file, input)) return file;
    close(file);
    return -1;
}

constexpr std::size_t kMostComplaint = 4096;

// The available part of its standard error, without waiting; only the beginning is kept.
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

// The running children, each in its own process group. An id is removed before another process can get it.
struct Running {
    std::mutex guard;
    std::set<pid_t> groups;
    bool over = false;
};

Running& running() {
    static Running all;
    return all;
}

// A program may close its output and go on. It has until `end`, too.
int wait_for_end(pid_t child, Clock::time_point end) {
    int status = 0;
    for (;;) {
        {
            const std::lock_guard lock(running().guard);
            const pid_t gone = waitpid(child, &status, WNOHANG);
            if (gone == child || (gone < 0 && errno != EINTR)) {
                running().groups.erase(child);
                return gone == child ? status : -1;
            }
            if (Clock::now() >= end) kill(-child, SIGKILL);
        }
        poll(nullptr, 0, 2);
    }
}

// 0, or what went wrong.
int start(pid_t& child, std::vector<std::string> words, std::vector<std::string> settings, int in, int out, int err) {
    settings = environment_with(std::move(settings));
    std::vector<char*> arguments = pointers_to(words), environment = pointers_to(settings);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, in, 0);
    posix_spawn_file_actions_adddup2(&actions, out, 1);
    posix_spawn_file_actions_adddup2(&actions, err, 2);
    // A separate process group, so that its own children end with it; and so that Ctrl-C, which a batch blocks for itself, is not
    // blocked for it.
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t none;
    sigemptyset(&none);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);
    const std::lock_guard lock(running().guard);
    const int number = running().over
                           ? ECANCELED
                           : posix_spawnp(&child, arguments[0], &actions, &attributes, arguments.data(), environment.data());
    if (number == 0) running().groups.insert(child);
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
    return number;
}

ChildAnswer fault_of(int number) {
    ChildAnswer answer;
    answer.end = number == ENOENT ? ChildAnswer::End::missing : ChildAnswer::End::failed;
    answer.fault = std::strerror(number);
    return answer;
}

ChildAnswer run(const std::vector<std::string>& words, int in, const ChildLimits& limits,
                const std::vector<std::string>& settings) {
    const auto end = Clock::now() + limits.time;
    int ends[2] = {-1, -1};
    if (pipe2(ends, O_CLOEXEC) != 0) return fault_of(errno);
    Open from(ends[0]), to(ends[1]);
    if (pipe2(ends, O_CLOEXEC) != 0) return fault_of(errno);
    Open complaint(ends[0]), complained(ends[1]);
    fcntl(complaint.number_, F_SETFL, O_NONBLOCK);
    pid_t child = -1;
    if (const int number = start(child, words, settings, in, to.number_, complained.number_); number != 0)
        return fault_of(number);
    to.shut();
    complained.shut();
    ChildAnswer answer;
    answer.end = hear(from.number_, complaint.number_, answer, end, limits.bytes);
    from.shut();
    const bool heard = answer.end == ChildAnswer::End::done;
    const int status = wait_for_end(child, heard ? end : Clock::now());
    hear_complaint(complaint.number_, answer.err);
    if (heard && (!WIFEXITED(status) || WEXITSTATUS(status) != 0)) {
        answer.end = Clock::now() >= end ? ChildAnswer::End::too_long : ChildAnswer::End::failed;
        answer.crashed = WIFSIGNALED(status);
    }
    return answer;
}

// As a shell would, but a folder without a name is not the one where we happen to be.
std::string find_program(const std::string& word) {
    if (word.find('/') != std::string::npos) return access(word.c_str(), X_OK) == 0 ? word : "";
    const char* path = std::getenv("PATH");
    for (std::string_view rest = path == nullptr ? "/usr/bin:/bin" : path; !rest.empty();) {
        const auto end = std::min(rest.find(':'), rest.size());
        const std::string place = std::string(rest.substr(0, end)) + '/' + word;
        if (end > 0 && access(place.c_str(), X_OK) == 0) return place;
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return "";
}

// Libraries, fonts, where systems other than Debian keep both, and where a program lies that is not there: its folder, or
// those of libraries and data beside its bin, which may be a person's own: nothing else of hers.
std::vector<std::string> readable_for(const std::string& program) {
    namespace fs = std::filesystem;
    std::vector<std::string> paths = {
        "/usr", "/lib",       "/lib64",     "/bin",      "/etc/fonts",  "/etc/ld.so.cache", "/var/cache/fontconfig",
        "/opt", "/nix/store", "/gnu/store", "/dev/null", "/dev/urandom"};
    std::error_code unknown;
    const fs::path folder = fs::canonical(program, unknown).parent_path(), above = folder.parent_path();
    if (!folder.empty() && folder != folder.root_path()) paths.push_back(folder.string());
    if (folder.filename() == "bin") paths.insert(paths.end(), {(above / "lib").string(), (above / "share").string()});
    return paths;
}

}  // namespace

ChildAnswer run_child(const std::vector<std::string>& words, std::string_view input, const ChildLimits& limits,
                      const std::vector<std::string>& settings) {
    const Open in(kept_in_memory(input));
    return in.number_ < 0 ? fault_of(EIO) : run(words, in.number_, limits, settings);
}

ChildAnswer run_caged(const CagedChild& child) {
    const std::string cage = own_program("tactics-cage"), program = find_program(child.words.at(0));
    if (program.empty()) return fault_of(ENOENT);
    if (cage.empty()) {
        ChildAnswer answer;
        answer.fault = "the program tactics-cage is not there; install it beside tactics, or set TACTICS_PROGRAMS to its folder";
        return answer;
    }
    const std::string file = "/proc/self/fd/" + std::to_string(child.file);
    const Open in(child.file < 0 ? kept_in_memory(child.input) : open(file.c_str(), O_RDONLY | O_CLOEXEC));
    if (in.number_ < 0) return fault_of(EIO);
    const auto seconds = std::chrono::ceil<std::chrono::seconds>(child.limits.time).count() + 1;
    std::vector<std::string> words = {cage, std::to_string(getpid()), std::to_string(child.memory), std::to_string(seconds),
                                      std::to_string(seconds)};
    for (const auto& paths : {readable_for(program), child.readable}) words.insert(words.end(), paths.begin(), paths.end());
    words.insert(words.end(), {"--", program});
    words.insert(words.end(), child.words.begin() + 1, child.words.end());
    return run(words, in.number_, child.limits, child.settings);
}

ChildBeside::ChildBeside(const std::vector<std::string>& words, std::string_view input,
                         const std::vector<std::string>& settings) {
    const Open in(kept_in_memory(input)), out(open("/dev/null", O_WRONLY | O_CLOEXEC));
    const int number =
        in.number_ < 0 || out.number_ < 0 ? EIO : start(child_, words, settings, in.number_, out.number_, out.number_);
    if (number == 0) return;
    child_ = -1;
    how_ = fault_of(number).end;
}

bool ChildBeside::runs() {
    if (child_ < 0) return false;
    const std::lock_guard lock(running().guard);
    int status = 0;
    const pid_t gone = waitpid(child_, &status, WNOHANG);
    if (gone == 0 || (gone < 0 && errno == EINTR)) return true;
    running().groups.erase(child_);
    if (gone < 0 || !WIFEXITED(status) || WEXITSTATUS(status) != 0) how_ = ChildAnswer::End::failed;
    child_ = -1;
    return false;
}

void ChildBeside::end() {
    if (runs()) wait_for_end(child_, Clock::now());
    child_ = -1;
}

ChildAnswer::End ChildBeside::how() { return runs() ? ChildAnswer::End::done : how_; }

void end_children() {
    const std::lock_guard lock(running().guard);
    running().over = true;
    for (const pid_t group : running().groups) kill(-group, SIGKILL);
}

}  // namespace tactics
