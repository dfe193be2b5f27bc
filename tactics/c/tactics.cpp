// SPDX-License-Identifier: Apache-2.0
#include "tactics/c/tactics.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/command.h"
#include "cli/report/report.h"
#include "cli/report/say.h"
#include "cli/request.h"
#include "tactics/error.h"
#include "tactics/job/make_pages.h"
#include "tactics/job/open_input.h"

namespace tactics {
extern const Command convert_command;
}

struct tactics_job {
    std::string input;
    int bytes = -1;  // a file in memory that holds the input; -1: the input is a path
    std::vector<std::pair<std::string, std::optional<std::string>>> flags;  // as convert has them, outputs too
    tactics_watch watch = nullptr;
    void* user = nullptr;
    std::atomic<bool> cancelled = false;

    std::string message;
    const char* fixed_message = nullptr;  // where there is no memory for another
    struct Told {
        std::string text;  // in English
        bool asks = false;
    };
    std::vector<Told> told;
    std::string json;

    tactics_job() = default;
    tactics_job(const tactics_job&) = delete;
    tactics_job& operator=(const tactics_job&) = delete;
    ~tactics_job() { forget_bytes(); }
    void forget_bytes() {
        if (bytes >= 0) close(std::exchange(bytes, -1));
    }
};

namespace {

using namespace tactics;

static_assert(TACTICS_USAGE == static_cast<int>(Fault::usage) && TACTICS_FAILED == static_cast<int>(Fault::failed) &&
              TACTICS_RULE_BROKEN == kRuleBroken);
static_assert(TACTICS_READING == static_cast<int>(JobStep::reading) && TACTICS_DRAWING == static_cast<int>(JobStep::drawing) &&
              TACTICS_LAYING_OUT == static_cast<int>(JobStep::laying_out) &&
              TACTICS_WRITING == static_cast<int>(JobStep::writing));

// Of convert's options, those that mean nothing here.
constexpr std::string_view kNotHere[] = {"files-from", "jobs",        "json", "no-defaults", "null",    "output",  "progress",
                                         "quiet",      "save-recipe", "to",   "update",      "verbose", "warnings"};

// A caller of this library has options and no command line: "--title" of convert is its "title".
std::string as_options(std::string text) {
    for (const Flag& flag : convert_command.flags) {
        const std::string name(flag.name);
        for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
            const char before = at == 0 ? ' ' : text[at - 1],
                       after = at + name.size() < text.size() ? text[at + name.size()] : ' ';
            constexpr std::string_view kBefore = " (\"", kAfter = " :;,)?=\"";  // a file may have such a name in its own
            if (kBefore.find(before) != kBefore.npos && kAfter.find(after) != kAfter.npos) text.erase(at, 2);
        }
    }
    return text;
}

std::string told_line(const Phrase& words) { return as_options(one_line(words.english())); }

tactics_code failed_with(tactics_job& job, tactics_code code, std::string_view message) {
    job.message = as_options(one_line(message));
    return code;
}

// A file over the limit of its size (ulimit -f) is a fault of this job, and no end of the program; so is a pipe that nobody
// reads.
class NoSignals {
public:
    NoSignals() noexcept {
        sigemptyset(&ours_);
        for (const int signal : {SIGXFSZ, SIGPIPE}) sigaddset(&ours_, signal);
        pthread_sigmask(SIG_BLOCK, &ours_, &before_);
    }
    ~NoSignals() {
        const timespec now{};
        while (sigtimedwait(&ours_, nullptr, &now) > 0) {
        }
        pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    }
    NoSignals(const NoSignals&) = delete;
    NoSignals& operator=(const NoSignals&) = delete;

private:
    sigset_t ours_{}, before_{};
};

// Whatever goes wrong in `act` becomes a code and a message.
template <typename Act>
tactics_code guarded(tactics_job* job, const Act& act) noexcept {
    if (job == nullptr) return TACTICS_USAGE;
    const NoSignals quiet;
    try {
        // The words that it parses are those of convert; as_options takes the dashes off again.
        [[maybe_unused]] static const bool kSpelled = (spell_wishes_with("--"), true);
        job->fixed_message = nullptr;
        job->message.clear();
        try {
            return act(*job);
        } catch (const Error& error) {
            return failed_with(*job, static_cast<tactics_code>(error.fault()), error.what());
        } catch (const std::bad_alloc&) {
            throw;
        } catch (const std::exception& error) {
            return failed_with(*job, TACTICS_FAILED, error.what());
        }
    } catch (...) {
        job->fixed_message = "there is not enough memory";
        return TACTICS_NO_MEMORY;
    }
}

void check_path(const char* path, const char* place) {
    if (path == nullptr || *path == '\0') throw Error(Fault::usage, place, phrase("the name of a file is missing"));
}

void forget_outcome(tactics_job& job) {
    job.told.clear();
    job.json.clear();
}

int memory_file(const void* bytes, std::size_t size, const std::string& name) {
    const int file = memfd_create("input", MFD_CLOEXEC);
    const char* from = static_cast<const char*>(bytes);
    while (file >= 0 && size > 0) {
        const auto written = write(file, from, size);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) {
            const int fault = errno;
            close(file);
            throw Error(Fault::failed, name, phrase("it cannot be kept in memory: {0}", std::strerror(fault)));
        }
        from += written;
        size -= static_cast<std::size_t>(written);
    }
    if (file < 0) throw Error(Fault::failed, name, phrase("it cannot be kept in memory: {0}", std::strerror(errno)));
    return file;
}

// Of a PDF the page that is wanted.
Source source_of(const tactics_job& job, const Job& wanted, std::vector<Phrase>& notes) {
    Source source{job.input, {nullptr, &std::fclose}};
    const int file = fcntl(job.bytes, F_DUPFD_CLOEXEC, 3);
    if (file >= 0) source.file.reset(fdopen(file, "rb"));
    if (source.file == nullptr) {
        if (file >= 0) close(file);
        throw Error(Fault::failed, job.input, phrase("it cannot be opened again; perhaps too many files are open"));
    }
    std::rewind(source.file.get());
    return wanted.as_text ? std::move(source) : page_of_input(std::move(source), job.input, page_wish(wanted), notes);
}

// The job's request, as if typed after `tactics convert`.
Request request_of(const tactics_job& job) {
    if (job.input.empty()) throw Error(Fault::usage, "", phrase("there is no input; name one with tactics_input"));
    std::vector<std::string> words;
    bool writes = false;
    for (const auto& [name, value] : job.flags) {
        writes = writes || name == spelled("output");
        words.push_back(value ? name + "=" + *value : name);
    }
    if (!writes) throw Error(Fault::usage, "", phrase("there is no output; name one with tactics_output"));
    // A program gets the same pages whoever runs it.
    words.insert(words.end(), {spelled("no-defaults"), "--", job.input});
    Request request = plan(parse_words(convert_command, words), real_disk());
    if (request.items.size() != 1)
        throw Error(Fault::usage, spelled("page"), phrase("a job makes one page of a PDF; run a job for each page"));
    return request;
}

tactics_code make(tactics_job& job) {
    forget_outcome(job);
    const Request request = request_of(job);
    Job wanted;
    static_cast<Item&>(wanted) = request.items.front();
    static_cast<Wishes&>(wanted) = request;
    bool given_up = false;
    Watch watch;
    watch.goes_on = [&](JobStep step) {
        given_up = job.cancelled.load() || (job.watch != nullptr && job.watch(static_cast<tactics_step>(step), job.user) != 0) ||
                   job.cancelled.load();
        return !given_up;
    };
    std::vector<Phrase> notes = request.notes;
    const Outcome outcome = job.bytes < 0 ? make_pages(wanted, watch) : make_pages(source_of(job, wanted, notes), wanted, watch);
    job.cancelled = false;
    if (given_up) return failed_with(job, TACTICS_CANCELLED, outcome.error.english());
    if (!outcome.error.empty()) return failed_with(job, static_cast<tactics_code>(outcome.fault), outcome.error.english());
    for (const Phrase& note : notes) job.told.push_back({told_line(note)});
    for (const Phrase& line : choice_lines(outcome)) job.told.push_back({told_line(line)});
    job.told.push_back({told_line(result_line(outcome))});
    for (const Note& note : further_lines(outcome)) job.told.push_back({told_line(note.words), note.asks()});
    job.json = result_json(outcome);
    if (request.strict && breaks_a_rule(outcome))
        return failed_with(job, TACTICS_RULE_BROKEN, "a page breaks a hard rule; the remarks say which");
    return TACTICS_DONE;
}

void add_option(tactics_job& job, const char* name, const char* value) {
    const std::string_view asked = name == nullptr ? "" : name;
    const std::string option = spelled(asked);
    std::vector<std::string_view> names;
    const Flag* found = nullptr;
    for (const Flag& flag : convert_command.flags) {
        if (std::find(std::begin(kNotHere), std::end(kNotHere), flag.name.substr(2)) != std::end(kNotHere)) continue;
        names.push_back(flag.name.substr(2));
        if (flag.name == option) found = &flag;
    }
    if (found == nullptr) throw Error(Fault::usage, asked, phrase("a job has no such option{0}", did_you_mean(asked, names)));
    if (found->value.empty() && value != nullptr)
        throw Error(Fault::usage, option, phrase("it takes no value; pass a null pointer"));
    if (!found->value.empty() && value == nullptr)
        throw Error(Fault::usage, option, phrase("its value is missing: {0}", found->value));
    if (!found->repeatable) std::erase_if(job.flags, [&](const auto& other) { return other.first == option; });
    job.flags.emplace_back(option, value == nullptr ? std::nullopt : std::optional<std::string>(value));
}

}  // namespace

const char* tactics_version(void) { return TACTICS_VERSION; }

tactics_job* tactics_new(void) { return new (std::nothrow) tactics_job; }

void tactics_free(tactics_job* job) { delete job; }

tactics_code tactics_input(tactics_job* job, const char* path) {
    return guarded(job, [&](tactics_job& own) {
        check_path(path, "tactics_input");
        if (std::strcmp(path, "-") == 0)
            throw Error(Fault::usage, "tactics_input",
                        phrase("standard input is not read here; read it and pass its bytes to tactics_input_bytes"));
        own.input = path;
        own.forget_bytes();
        return TACTICS_DONE;
    });
}

tactics_code tactics_input_bytes(tactics_job* job, const void* bytes, size_t size, const char* name) {
    return guarded(job, [&](tactics_job& own) {
        check_path(name, "tactics_input_bytes");
        if (bytes == nullptr || size == 0) throw Error(Fault::usage, name, phrase("it is empty"));
        const int file = memory_file(bytes, size, name);
        own.forget_bytes();
        own.bytes = file;
        own.input = name;
        return TACTICS_DONE;
    });
}

tactics_code tactics_output(tactics_job* job, const char* path) {
    return guarded(job, [&](tactics_job& own) {
        check_path(path, "tactics_output");
        const std::string_view text = path;
        if (text == "-" || text.ends_with(":-"))
            throw Error(Fault::usage, path, phrase("the library does not write to standard output; name a file"));
        own.flags.emplace_back(spelled("output"), path);
        return TACTICS_DONE;
    });
}

tactics_code tactics_option(tactics_job* job, const char* name, const char* value) {
    return guarded(job, [&](tactics_job& own) {
        add_option(own, name, value);
        return TACTICS_DONE;
    });
}

void tactics_on_step(tactics_job* job, tactics_watch watch, void* user) {
    if (job == nullptr) return;
    job->watch = watch;
    job->user = user;
}

void tactics_cancel(tactics_job* job) {
    if (job != nullptr) job->cancelled = true;
}

tactics_code tactics_run(tactics_job* job) { return guarded(job, make); }

const char* tactics_message(const tactics_job* job) {
    if (job == nullptr) return "there is no job";
    return job->fixed_message != nullptr ? job->fixed_message : job->message.c_str();
}

size_t tactics_told_count(const tactics_job* job) { return job == nullptr ? 0 : job->told.size(); }

const char* tactics_told(const tactics_job* job, size_t index) {
    return job == nullptr || index >= job->told.size() ? "" : job->told[index].text.c_str();
}

int tactics_told_asks(const tactics_job* job, size_t index) {
    return job != nullptr && index < job->told.size() && job->told[index].asks ? 1 : 0;
}

const char* tactics_json(const tactics_job* job) { return job == nullptr ? "" : job->json.c_str(); }
