// SPDX-License-Identifier: Apache-2.0
#include "cli/batch.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <mutex>
#include <optional>
#include <utility>

#include "cli/interrupt.h"
#include "cli/report/progress.h"
#include "cli/report/report.h"
#include "cli/report/say.h"
#include "cli/report/user_language.h"
#include "tactics/error.h"
#include "tactics/job/binding.h"
#include "tactics/job/make_many.h"

namespace tactics {

namespace {

constexpr auto kPatience = std::chrono::seconds(2);  // for a file that is being written when Ctrl-C comes

using Clock = std::chrono::steady_clock;

// Less output than usual also means no progress, unless progress is requested.
ProgressWay shown_way(const Request& request) {
    if (request.loudness == Loudness::errors) return ProgressWay::none;
    const bool plain = request.loudness == Loudness::warnings && request.progress == ProgressWay::automatic;
    return plain ? ProgressWay::none : request.progress;
}

// Talks about the batch while workers hand in their outcomes in any order. Safe from any thread.
class Account {
public:
    Account(const Request& request, WriteGate& gate)
        : request_(request), gate_(gate), progress_(request.items.size(), shown_way(request)), ready_(request.items.size()) {}

    void take(std::size_t index, const Outcome& outcome) {
        count(outcome, index);
        if (request_.answer != nullptr) print_answer(index, request_.answer(outcome));
    }

    // One file of all pictures, which is written when they are done.
    void take(const BoundFile& file) {
        const std::lock_guard lock(mutex_);
        const Phrase name = file.path == "-" ? phrase("standard output") : Phrase(file.path);
        if (!file.error.empty()) {
            failed_ = true;
            progress_.say_line(phrase("tactics: {0}", file.error));
            return;
        }
        files_ += file.pages > 0 ? 1 : 0;
        std::string missing;
        for (const std::string& input : file.missing) missing += (missing.empty() ? "" : ", ") + input;
        if (file.pages == 0)
            progress_.say_line(phrase("tactics: {0} is not written, as there is no page for it", name));
        else if (!missing.empty())
            progress_.say_line(phrase("tactics: {0} has no page of {1}", name, missing));
        if (file.pages > 0 && request_.loudness != Loudness::errors && request_.loudness != Loudness::warnings)
            progress_.say_line(phrase("{0}: {1}", name, phrases(file.pages, "{0} page", "{0} pages")));
    }

    bool breaks_rules() const { return breaks_rules_; }

    // The last words, when all workers are done. Gives the exit code.
    int close() {
        const std::lock_guard lock(mutex_);
        progress_.clear();
        int code = failures_.empty() ? 0 : static_cast<int>(request_.items.size() == 1 ? fault_ : Fault::failed);
        if (code == 0 && request_.strict && breaks_rules_) code = kRuleBroken;
        if (request_.items.size() > 1) sum_up();
        return failed_ ? static_cast<int>(Fault::failed) : code;
    }

    // Ctrl-C: waits for the current writes, then allows no more. Standard output may be a pipe without a reader.
    void stop() {
        const auto end = Clock::now() + kPatience;
        const bool whole = gate_.try_lock_until(end);  // and never let go: the program ends
        static_cast<void>(output_.try_lock_until(end));
        const std::lock_guard lock(mutex_);
        progress_.clear();
        const std::size_t all = request_.items.size();
        const bool writes = !request_.items.front().outputs.front().path.empty();
        std::vector<Phrase> parts{phrase("tactics: stopped")};
        if (all > 1) parts.push_back(phrase("{0} of {1} pictures done", std::to_string(done_), std::to_string(all)));
        if (whole) parts.push_back(phrase("no file is half written"));
        if (all > 1 && writes) parts.push_back(on_from_here());
        Phrase line = parts.front();
        for (std::size_t i = 1; i < parts.size(); ++i) line = phrase("{0}; {1}", std::move(line), parts[i]);
        say(line);
    }

private:
    // What one file has of all pictures is lost.
    Phrase on_from_here() const {
        const std::vector<Output>& outputs = request_.items.front().outputs;
        const auto bound = std::find_if(outputs.begin(), outputs.end(), [](const Output& output) { return output.bound; });
        return bound == outputs.end() ? phrase("add --update to go on from here")
                                      : phrase("{0} is as it was before", bound->path);
    }

    void count(const Outcome& outcome, std::size_t index) {
        const std::lock_guard lock(mutex_);
        ++done_;
        if (outcome.error.empty())
            files_ += static_cast<std::size_t>(
                std::count_if(outcome.made.begin(), outcome.made.end(), [](const Made& made) { return !made.output.bound; }));
        up_to_date_ += outcome.up_to_date ? 1 : 0;
        if (!outcome.error.empty()) {
            failures_.push_back({index, outcome.error});
            fault_ = outcome.fault;
            progress_.say_line(phrase("tactics: {0}", outcome.error));
        } else {
            breaks_rules_ = breaks_rules_ || breaks_a_rule(outcome);
            if (needs_a_look(outcome)) doubts_.push_back({index, outcome.input});
            tell(outcome);
        }
        progress_.show(done_);
    }

    void tell(const Outcome& outcome) {
        if (request_.loudness == Loudness::errors) return;
        const bool all = request_.loudness == Loudness::all;
        const bool usual = request_.loudness == Loudness::usual && request_.answer == nullptr && !progress_.updates();
        const bool whole = all || (usual && request_.items.size() == 1);
        if (whole)
            for (const Phrase& line : choice_lines(outcome)) progress_.say_line(line);
        if (usual && !whole) return progress_.say_line(result_with_warnings(outcome));
        if (all || usual) progress_.say_line(result_line(outcome));
        for (const Note& line : further_lines(outcome))
            if (whole || line.asks()) progress_.say_line(line.words);
    }

    void sum_up() {
        if (request_.loudness == Loudness::warnings) return;
        if (request_.loudness != Loudness::errors) {
            std::vector<Phrase> parts{
                phrase("{0} of {1} pictures done", std::to_string(done_ - failures_.size()), std::to_string(done_)),
                phrases(files_, "{0} file written", "{0} files written")};
            if (up_to_date_ > 0) parts.push_back(phrase("{0} were up to date", std::to_string(up_to_date_)));
            parts.push_back(phrase("{0} s", std::to_string(std::lround(progress_.seconds()))));
            say(row_of(parts));
            name_doubts();
        }
        if (failures_.empty()) return;
        say(phrase("{0} of {1} failed:", std::to_string(failures_.size()), std::to_string(done_)));
        std::sort(failures_.begin(), failures_.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
        for (const auto& [index, message] : failures_) say("  " + message.in(user_language()));
    }

    // Many names would only repeat what is above.
    void name_doubts() {
        constexpr std::size_t kNamed = 10;
        if (doubts_.empty()) return;
        if (doubts_.size() > kNamed)
            return say(
                phrase("{0} pages need a look before being handed out, as told above; --warnings prints nothing but such lines",
                       std::to_string(doubts_.size())));
        say(phrases(doubts_.size(), "{0} page needs a look before being handed out, as told above:",
                    "{0} pages need a look before being handed out, as told above:"));
        std::sort(doubts_.begin(), doubts_.end());
        for (const auto& [index, input] : doubts_) say("  " + input);
    }

    // In the order of the inputs, regardless of the order in which they finish. It may block for ever, so mutex_ is unlocked
    // meanwhile.
    void print_answer(std::size_t index, std::string answer) {
        const std::lock_guard lock(output_);
        ready_[index] = std::move(answer);
        std::string text;
        for (; printed_ < ready_.size() && ready_[printed_]; ++printed_) text += *std::exchange(ready_[printed_], std::nullopt);
        try {
            print_out(text);
        } catch (const Error& error) {
            if (std::exchange(output_failed_, true)) return;
            const std::lock_guard talk(mutex_);
            failed_ = true;
            progress_.say_line(phrase("tactics: {0}", error.told()));
        }
    }

    const Request& request_;
    WriteGate& gate_;
    std::mutex mutex_;
    Progress progress_;
    std::size_t done_ = 0;
    std::size_t files_ = 0;
    std::size_t up_to_date_ = 0;
    bool breaks_rules_ = false;
    std::vector<std::pair<std::size_t, Phrase>> failures_;
    Fault fault_ = Fault::failed;  // of the one picture
    bool failed_ = false;          // what is not of one picture: a bound file, standard output
    std::vector<std::pair<std::size_t, std::string>> doubts_;

    std::timed_mutex output_;  // standard output and the rest; locked before mutex_, never after it
    bool output_failed_ = false;
    std::vector<std::optional<std::string>> ready_;
    std::size_t printed_ = 0;
};

}  // namespace

int run_batch(const Request& request) {
    constexpr std::size_t kAhead = 64;  // pictures whose pages wait for a slow one before them
    WriteGate gate;
    Account account(request, gate);
    PageBinding binding(request.items, request, kAhead, &gate);
    const Interrupt interrupt([&] { account.stop(); });
    const Many many{request.workers, request.update, request.strict, &gate, request.made_with ? &*request.made_with : nullptr};
    const auto bound = bound_made_with(request.items, many);
    make_many(request.items, request, many, [&](std::size_t index, Outcome& outcome) {
        if (!binding.any()) return account.take(index, outcome);
        binding.take(index, outcome, [&](std::size_t at, const Outcome& done) { account.take(at, done); });
    });
    for (const BoundFile& file : binding.write()) {
        for (const auto& [output, with] : bound)
            if (output.path == file.path && file.error.empty() && file.missing.empty() && file.pages > 0)
                keep_record(output, {with, 1, {}, !account.breaks_rules()}, true);
        account.take(file);
    }
    return account.close();
}

}  // namespace tactics
