// SPDX-License-Identifier: Apache-2.0
#include "cli/printer_app/job_child.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>

#include "cli/interrupt.h"
#include "cli/report/say.h"
#include "tactics/error.h"
#include "tactics/job/open_input.h"
#include "tactics/text/number.h"
#include "tactics/transport/lesser_rights.h"

extern char** environ;

namespace tactics {

namespace {

constexpr std::chrono::seconds kTimeToEnd{5};
constexpr std::string_view kError = "ERROR: ", kInfo = "INFO: ", kPage = "PAGE: ";
constexpr std::string_view kAny = "any", kText = "text", kOptions = "--";

constexpr int kRequest = STDERR_FILENO + 1;  // where the child reads it

std::vector<std::string> words_of(const JobRequest& request) {
    std::vector<std::string> words{request.driver,
                                   request.title,
                                   std::to_string(request.job.copies),
                                   std::to_string(request.job.first_page),
                                   std::to_string(request.job.last_page),
                                   std::string(request.job.is_text ? kText : kAny)};
    for (const auto& [name, value] : request.defaults) words.push_back(name + "=" + value);
    words.emplace_back(kOptions);
    for (const auto& [name, value] : request.options) words.push_back(name + "=" + value);
    return words;
}

JobRequest request_of(const std::vector<std::string>& words) {
    constexpr std::size_t kFixed = 6;
    if (words.size() <= kFixed)
        throw Error(Fault::usage, std::string(kJobChild), phrase("is how the printer application calls itself; see --help"));
    const auto number = [&](std::size_t at) { return static_cast<int>(parse_number(words[at]).value_or(1)); };
    JobRequest request{words[0], words[1], {copies_of(words[2]), number(3), number(4), words[5] == kText}, {}, {}};
    PrintOptions* taken = &request.defaults;
    for (std::size_t i = kFixed; i < words.size(); ++i) {
        const auto equals = words[i].find('=');
        if (words[i] == kOptions)
            taken = &request.options;
        else if (equals != std::string::npos)
            taken->emplace_back(words[i].substr(0, equals), words[i].substr(equals + 1));
    }
    return request;
}

void check_choice(const PpdWords& words, const std::string& option, const std::string& value, std::string_view behind = "") {
    const auto offered = words.choices.find(option);
    if (takes_any_words(option) || offered == words.choices.end() || offered->second.contains(value)) return;
    const std::vector<std::string_view> names(offered->second.begin(), offered->second.end());
    throw Error(Fault::usage, attribute_of(option).append(behind),
                phrase("this printer has no choice \"{0}\"{1}; tactics-printer-app choices lists them", value.substr(0, 80),
                       did_you_mean(value, names)));
}

// The words in memory. Whoever lists processes reads their arguments, and the title and labels of a job are its user's.
class Words {
public:
    explicit Words(const std::vector<std::string>& words) : file_(memfd_create("job", MFD_CLOEXEC)) {
        std::string text;
        for (const std::string& word : words) text += word + '\0';
        std::string_view rest = text;
        while (file_ >= 0 && !rest.empty()) {
            const ssize_t count = write(file_, rest.data(), rest.size());
            if (count < 0 && errno == EINTR) continue;
            if (count <= 0) break;
            rest.remove_prefix(static_cast<std::size_t>(count));
        }
        if (file_ < 0 || !rest.empty() || lseek(file_, 0, SEEK_SET) != 0)
            throw Error(Fault::failed, "", phrase("there is no memory for another print job"));
    }
    ~Words() {
        if (file_ >= 0) close(file_);
    }
    Words(const Words&) = delete;
    Words& operator=(const Words&) = delete;
    int file() const { return file_; }

    static std::vector<std::string> read_all() {
        std::string text;
        std::array<char, 4096> block;
        for (ssize_t count = 1; count != 0;) {
            count = read(kRequest, block.data(), block.size());
            if (count < 0 && errno != EINTR) break;
            if (count > 0) text.append(block.data(), static_cast<std::size_t>(count));
        }
        close(kRequest);
        std::vector<std::string> words;
        for (std::size_t at = 0, end = 0; (end = text.find('\0', at)) != std::string::npos; at = end + 1)
            words.push_back(text.substr(at, end - at));
        return words;
    }

private:
    int file_;
};

class Pipe {
public:
    Pipe() {
        if (pipe2(ends_.data(), O_CLOEXEC) != 0) throw Error(Fault::failed, "", phrase("there is no room for another pipe"));
    }
    ~Pipe() {
        close_one(0);
        close_one(1);
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    int end(std::size_t which) const { return ends_[which]; }
    void close_one(std::size_t which) {
        if (ends_[which] >= 0) close(ends_[which]);
        ends_[which] = -1;
    }

private:
    std::array<int, 2> ends_{-1, -1};
};

// The child with its output and its lines.
class JobChild {
public:
    JobChild(const std::vector<std::string>& words, int document) {
        const Words request(words);
        // Some of these may be the file that another becomes.
        const int apart = fcntl(request.file(), F_DUPFD_CLOEXEC, kRequest + 1);
        if (apart < 0) throw Error(Fault::failed, "", phrase("there is no room for another file"));
        std::string name = "tactics-printer-app", way(kJobChild);
        const std::array<char*, 3> pointers{name.data(), way.data(), nullptr};
        posix_spawn_file_actions_t files;
        posix_spawnattr_t how;
        posix_spawn_file_actions_init(&files);
        posix_spawnattr_init(&how);
        posix_spawn_file_actions_adddup2(&files, document, STDIN_FILENO);
        posix_spawn_file_actions_adddup2(&files, out_.end(1), STDOUT_FILENO);
        posix_spawn_file_actions_adddup2(&files, told_.end(1), STDERR_FILENO);
        posix_spawn_file_actions_adddup2(&files, apart, kRequest);
        posix_spawn_file_actions_addclosefrom_np(&files, kRequest + 1);  // the device is not the child's
        // The child ends by these, whatever the server does with them.
        sigset_t none, ours;
        sigemptyset(&none);
        sigemptyset(&ours);
        for (const int signal : {SIGTERM, SIGINT, SIGHUP, SIGPIPE}) sigaddset(&ours, signal);
        posix_spawnattr_setsigmask(&how, &none);
        posix_spawnattr_setsigdefault(&how, &ours);
        posix_spawnattr_setpgroup(&how, 0);
        posix_spawnattr_setflags(&how, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
        const int fault = posix_spawn(&child_, "/proc/self/exe", &files, &how, pointers.data(), environ);
        posix_spawn_file_actions_destroy(&files);
        posix_spawnattr_destroy(&how);
        close(apart);
        if (fault != 0) {
            child_ = -1;
            throw Error(Fault::failed, "", phrase("the program that converts print jobs could not be started"));
        }
        out_.close_one(1);
        told_.close_one(1);
    }
    ~JobChild() {
        if (child_ > 0) end(SIGKILL);
    }
    JobChild(const JobChild&) = delete;
    JobChild& operator=(const JobChild&) = delete;

    // Reads what there is; false: both ends are closed.
    bool hear(std::string& bytes, const std::function<void(std::string_view)>& take_line) {
        std::array<pollfd, 2> ends{{{out_.end(0), POLLIN, 0}, {told_.end(0), POLLIN, 0}}};
        if (poll(ends.data(), ends.size(), 200) < 0) return true;
        if (ends[0].revents != 0) read_from(out_, bytes);
        if (ends[1].revents != 0) read_from(told_, lines_);
        for (auto end = lines_.find('\n'); end != std::string::npos; end = lines_.find('\n')) {
            take_line(std::string_view(lines_).substr(0, end));
            lines_.erase(0, end + 1);
        }
        if (lines_.size() > 1u << 16) lines_.clear();
        return out_.end(0) >= 0 || told_.end(0) >= 0;
    }
    // What it starts ends with it (tactics-cage).
    void end(int signal) {
        kill(-child_, signal);
        if (signal == SIGKILL) wait();
    }
    // Whether it ended well.
    bool wait() {
        int status = 0;
        pid_t ended = 0;
        while ((ended = waitpid(child_, &status, 0)) < 0 && errno == EINTR) {
        }
        const bool known = ended == child_;
        child_ = -1;
        return known && WIFEXITED(status) && WEXITSTATUS(status) == 0;
    }

private:
    static void read_from(Pipe& pipe, std::string& text) {
        std::array<char, 65536> block;
        const ssize_t count = read(pipe.end(0), block.data(), block.size());
        if (count > 0)
            text.append(block.data(), static_cast<std::size_t>(count));
        else if (count == 0 || errno != EINTR)
            pipe.close_one(0);
    }

    Pipe out_, told_;
    std::string lines_;
    pid_t child_ = -1;
};

}  // namespace

Queue queue_of(const JobRequest& request) {
    const MachineDriver* driver = find_driver(request.driver);
    if (driver == nullptr)
        throw Error(Fault::usage, request.driver, phrase("there is no such driver; tactics-printer-app drivers lists them"));
    PpdWords words = words_of(*driver);
    for (const auto& [option, value] : request.options) check_choice(words, option, value);
    for (const auto& chosen : request.defaults) {
        check_choice(words, chosen.first, chosen.second, "-default");
        words.defaults.push_back(chosen);
    }
    try {
        return queue_of(words, request.driver, request.options, request.title);
    } catch (const Error& error) {
        throw Error(error.fault(), "", in_attributes(error.what(), words));
    }
}

std::string convert_job(const JobRequest& request, int document, const JobWatch& watch) {
    JobChild child(words_of(request), document);
    std::string bytes, error;
    const auto take_line = [&](std::string_view line) {
        if (line.starts_with(kError))
            error = line.substr(kError.size());
        else if (line.starts_with(kPage))
            watch.sheet();
        else
            watch.note(line.starts_with(kInfo) ? line.substr(kInfo.size()) : line);
    };
    std::chrono::steady_clock::time_point cancelled{};
    while (child.hear(bytes, take_line)) {
        const auto now = std::chrono::steady_clock::now();
        const bool is_cancelled = watch.is_cancelled(), first = cancelled == std::chrono::steady_clock::time_point{};
        if (is_cancelled && first) {
            cancelled = now;
            child.end(SIGTERM);
        }
        if (is_cancelled && !first && now - cancelled > kTimeToEnd) return "";
        if (bytes.size() > kMostJobBytes)
            throw Error(Fault::failed, "", phrase("the job has more pages than an embosser could make"));
    }
    const bool good = child.wait();
    if (watch.is_cancelled()) return "";
    if (!good)
        throw Error(Fault::failed, "",
                    error.empty() ? phrase("the program that converts print jobs ended early") : Phrase(error));
    return bytes;
}

int run_job_child() {
    try {
        fix_print_surroundings();
        take_lesser_rights();
        prctl(PR_SET_PDEATHSIG, SIGKILL);  // asked for again with other rights
        const JobRequest request = request_of(Words::read_all());
        spell_wishes_with("tactics-");
        const Interrupt interrupt([] {});
        Source document = open_source("-");
        document.name = request.title;
        emboss_print_job(std::move(document), queue_of(request), request.job);
        return 0;
    } catch (const std::exception& error) {
        say(std::string(kError) + error.what());
        return 1;
    }
}

}  // namespace tactics
