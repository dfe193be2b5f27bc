#include "cli/tick_log.h"

#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>

#include "tactics/error.h"

namespace tactics {

namespace {

constexpr std::chrono::milliseconds kPause{100};

bool is_file(const std::string& path) {
    std::error_code fault;
    const auto status = std::filesystem::status(path, fault);
    return path != "-" && (!std::filesystem::exists(status) || std::filesystem::is_regular_file(status));
}

// Of a link the target is written.
std::string target_of(const std::string& path) {
    std::error_code fault;
    const auto target = std::filesystem::canonical(path, fault);
    return fault ? path : target.string();
}

}  // namespace

TickLog::TickLog(std::string path, const Recorder& recorder, bool truth) : path_(std::move(path)), recorder_(recorder), truth_(truth), file_(nullptr, std::fclose) {
    if (is_file(path_)) part_ = target_of(path_) + ".part";
    const std::string opened = path_ == "-" ? "/dev/stdout" : part_.empty() ? path_ : part_;
    file_.reset(std::fopen(opened.c_str(), "we"));
    if (file_ == nullptr) throw Error(Fault::failed, opened, std::string("cannot be written (") + std::strerror(errno) + "); name another file, or make its folder first");
    const std::string header = csv_header(truth_);
    if (std::fwrite(header.data(), 1, header.size(), file_.get()) != header.size()) fault_ = errno;
}

TickLog::~TickLog() {
    done_ = true;
    if (writer_.joinable()) writer_.join();
}

void TickLog::write_beside() {
    writer_ = std::thread([this] {
        while (!done_) {
            write_new();
            if (std::fflush(file_.get()) != 0 && fault_ == 0) fault_ = errno;
            std::this_thread::sleep_for(kPause);
        }
    });
}

void TickLog::keep_up() {
    if (recorder_.added() - written_ >= recorder_.most() / 2) write_new();
}

void TickLog::write_new() {
    std::string lines;
    for (const std::size_t end = recorder_.added(); written_ < end; ++written_) add_csv(lines, recorder_.at(written_), truth_);
    if (fault_ == 0 && std::fwrite(lines.data(), 1, lines.size(), file_.get()) != lines.size()) fault_ = errno;
}

void TickLog::finish() {
    done_ = true;
    if (writer_.joinable()) writer_.join();
    write_new();
    if (std::fclose(file_.release()) != 0 && fault_ == 0) fault_ = errno;
    if (fault_ != 0)
        throw Error(Fault::failed, path_, std::string("the log could not be written to its end (") + std::strerror(fault_) + ")" + (part_.empty() ? "" : "; what could is in " + part_));
    std::error_code fault;
    if (!part_.empty()) std::filesystem::rename(part_, target_of(path_), fault);
    if (fault) throw Error(Fault::failed, path_, "cannot take its name (" + fault.message() + "); the log is in " + part_);
}

}  // namespace tactics
