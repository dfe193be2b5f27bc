// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/tick_log.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>

#include "cli/interrupt_count.h"
#include "cli/report/say.h"
#include "tactics/error.h"
#include "tactics/transport/file.h"

namespace tactics {

namespace {

constexpr std::chrono::milliseconds kPause{100};
constexpr std::chrono::seconds kPatienceWithLog{2};  // with a reader that reads nothing, when all is to end
constexpr std::size_t kAtOnce = 4096;                // what poll promises to a pipe (PIPE_BUF): more might wait

bool is_output(const std::string& path) { return path == "-" || path == "/dev/stdout"; }

bool is_file(const std::string& path) {
    std::error_code fault;
    const auto status = std::filesystem::status(path, fault);
    return !is_output(path) && !path.starts_with("/dev/") &&
           (!std::filesystem::exists(status) || std::filesystem::is_regular_file(status));
}

// Writes to the target of a link.
std::string target_of(const std::string& path) {
    std::error_code fault;
    const auto target = std::filesystem::canonical(path, fault);
    return fault ? path : target.string();
}

int open_log(const std::string& path, const std::string& part) {
    if (is_output(path)) return fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3);
    if (part.empty()) return open(path.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC);
    return open(part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
}

}  // namespace

TickLog::TickLog(std::string path, const Recorder& recorder, const TickColumns& columns)
    : path_(std::move(path)), recorder_(recorder), columns_(columns) {
    if (path_.empty()) throw Error(Fault::usage, "--csv", phrase("name a file, for example ticks.csv"));
    if (is_file(path_)) part_ = target_of(path_) + ".part";
    const int number = open_log(path_, part_);
    if (number < 0 && errno == EEXIST)
        throw Error(Fault::failed, path_,
                    phrase("{0} has what was felt in a play that did not end; give it another name, or remove it", part_));
    if (number < 0)
        throw Error(Fault::failed, path_,
                    phrase("cannot be written ({0}); name another file, or make its folder first", std::strerror(errno)));
    file_.emplace(number);
    // write reports a closed pipe.
    std::signal(SIGPIPE, SIG_IGN);
    write(csv_header(columns_));
}

TickLog::~TickLog() {
    if (!file_) return;
    stop_writer();
    write_new(recorder_.most());
}

void TickLog::stop_writer() {
    done_ = true;
    if (writer_.joinable()) writer_.join();
}

void TickLog::write_beside() {
    writer_ = std::thread([this] {
        while (!done_) {
            // Skips ticks that are nearly overwritten while another thread adds, because they might change while they are read.
            write_new(recorder_.most() - recorder_.most() / 8);
            std::this_thread::sleep_for(kPause);
        }
    });
}

void TickLog::keep_up() {
    if (recorder_.added() - written_ >= recorder_.most() / 2) write_new(recorder_.most());
}

void TickLog::write_new(std::size_t sure) {
    std::string lines;
    for (std::size_t end = recorder_.added(); written_ < end; ++written_) {
        if (recorder_.added() - written_ > sure) {
            fail(phrase("it could not be written as quickly as it was felt, and ticks are missing"));
            written_ = recorder_.added() - recorder_.most() / 2;
        }
        add_csv(lines, recorder_.at(written_), columns_);
        if (lines.size() < kAtOnce) continue;
        write(lines);
        lines.clear();
    }
    write(lines);
}

void TickLog::fail(Phrase why) {
    if (!fault_.empty()) return;
    fault_ = std::move(why);
    say(phrase("{0}: the log is not whole: {1}", path_, fault_));
}

void TickLog::write(std::string_view text) {
    auto given_up = std::chrono::steady_clock::time_point::max();
    while (!text.empty() && !closed_ && fault_.empty()) {
        if (!wait_for(file_->number(), kPause)) {
            const auto now = std::chrono::steady_clock::now();
            const bool ends = done_ || interrupts() > 0;
            if (ends && given_up == std::chrono::steady_clock::time_point::max()) given_up = now + kPatienceWithLog;
            if (now >= given_up) fail(phrase("nobody reads it"));
            continue;
        }
        const ssize_t taken = ::write(file_->number(), text.data(), std::min(text.size(), kAtOnce));
        if (taken >= 0)
            text.remove_prefix(static_cast<std::size_t>(taken));
        else if (errno == EPIPE)
            closed_ = true;
        else if (errno != EINTR && errno != EAGAIN)
            fail(std::strerror(errno));
    }
}

void TickLog::finish() {
    stop_writer();
    write_new(recorder_.most());
    if (file_ && !part_.empty())
        if (const int reason = keep_open(file_->number()); reason != 0 && fault_.empty()) fault_ = std::strerror(reason);
    file_.reset();
    if (!fault_.empty())
        throw Error(Fault::failed, path_,
                    part_.empty() ? phrase("the log is not whole: {0}", fault_)
                                  : phrase("the log is not whole: {0}; what could be written is in {1}", fault_, part_));
    std::error_code fault;
    if (!part_.empty()) std::filesystem::rename(part_, target_of(path_), fault);
    if (fault) throw Error(Fault::failed, path_, phrase("cannot take its name ({0}); the log is in {1}", fault.message(), part_));
    if (!part_.empty()) keep_folder(std::filesystem::absolute(target_of(path_)).parent_path().string());
}

}  // namespace tactics
