#include "cli/evaluate_run.h"

#include <sys/resource.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <ctime>
#include <mutex>
#include <new>
#include <thread>

#include "cli/progress.h"
#include "cli/reading.h"
#include "filters/list.h"
#include "tactics/error.h"
#include "tactics/measure/lines.h"

namespace tactics {

namespace {

// Of this thread, so that other pictures at work do not count.
double cpu_ms() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) / 1e6;
}

double peak_memory_mib() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024;  // Linux counts in KiB
}

// All about one picture.
struct Rows {
    std::size_t annotators = 0;
    Counts people;
    std::vector<std::vector<Trial>> trials;  // by candidate and setting
    std::vector<std::string> problems;
};

class Examination {
public:
    Examination(const EvaluateRequest& request, const Subject& subject) : request_(request), subject_(subject) {}

    Rows rows() {
        Rows rows;
        read_truths(rows);
        rows.annotators = truths_.size();
        if (rows.problems.empty()) rows.people = score_people(truths_);
        const std::string unscored = rows.problems.empty() ? "" : rows.problems.front();
        for (const Candidate& candidate : request_.candidates) {
            auto& trials = rows.trials.emplace_back();
            for (std::size_t setting = 0; setting < candidate.settings.size(); ++setting) {
                Trial trial;
                trial.error = unscored;
                if (unscored.empty()) {
                    trial.error = fault_of(subject_.picture, [&] { run(candidate, setting, trial); });
                    if (!trial.scored()) rows.problems.push_back("recipe " + label(candidate, setting) + ": " + trial.error);
                }
                trials.push_back(std::move(trial));
            }
        }
        return rows;
    }

private:
    static std::string label(const Candidate& candidate, std::size_t setting) {
        return candidate.name + (candidate.settings[setting].empty() ? "" : " " + candidate.settings[setting]);
    }

    void read_truths(Rows& rows) {
        const auto add = [&](std::string problem) {
            if (!problem.empty()) rows.problems.push_back(std::move(problem));
        };
        if (subject_.truths.empty())
            add(subject_.picture + ": it has no contour map; add " + subject_.name + "_gt1.png, or take the picture away");
        add(fault_of(subject_.picture, [&] {
            Source source = open_source(subject_.picture);
            info_ = inspect_picture(source);
            read_picture(source, {1, false});  // a file that is cut off is found out once, not by every recipe
        }));
        if (!rows.problems.empty()) return;
        for (const auto& path : subject_.truths)
            add(fault_of(path, [&] { truths_.push_back(read_truth(path, info_.width, info_.height)); }));
    }

    void run(const Candidate& candidate, std::size_t setting, Trial& trial) const {
        const double start = cpu_ms();
        Source source = open_source(subject_.picture);
        const PictureInfo info = inspect_picture(source);
        Reading reading(source);
        const Recipe recipe =
            fit_to(*request_.sheet.medium, candidate.recipes.empty()
                                               ? assemble(candidate.chain, find_recipe(choose(reading).recipe, "auto"))
                                               : candidate.recipes[setting]);
        if (const Kept kept = kept_by(recipe); kept.width < 1 || kept.height < 1)
            throw Error(Fault::failed, "", "only a part of the picture is left, which no contour map fits; leave out crop");
        const Rect place = place_on(request_.sheet, aspect_of(info)).drawing;
        Image image = read_for(recipe, place, reading);
        const double read = cpu_ms();
        const Artwork artwork = tactics::run(recipe, std::move(image));
        const double end = cpu_ms();
        trial.recipe_ms = end - read;
        trial.whole_ms = end - start;
        const Medium& medium = *request_.sheet.medium;
        if (const auto* drawing = std::get_if<Drawing>(&artwork)) trial.touch = touch_load(*drawing, medium.gap + medium.line);
        trial.curve = score_at_levels(lines_of(artwork, info_.width, info_.height), truths_);
    }

    const EvaluateRequest& request_;
    const Subject& subject_;
    PictureInfo info_;
    std::vector<PixelSet> truths_;
};

Evaluation collect(const EvaluateRequest& request, std::vector<Rows> all) {
    Evaluation evaluation;
    evaluation.problems = request.problems;
    for (const Candidate& candidate : request.candidates) evaluation.recipes.push_back({candidate.name, candidate.settings, {}});
    for (std::size_t i = 0; i < all.size(); ++i) {
        Rows& rows = all[i];
        evaluation.pictures.push_back(request.subjects[i].name);
        evaluation.annotators.push_back(rows.annotators);
        evaluation.people.push_back(rows.people);
        evaluation.problems.insert(evaluation.problems.end(), rows.problems.begin(), rows.problems.end());
        for (std::size_t c = 0; c < rows.trials.size(); ++c) evaluation.recipes[c].trials.push_back(std::move(rows.trials[c]));
    }
    evaluation.peak_memory_mib = peak_memory_mib();
    return evaluation;
}

}  // namespace

std::string fault_of(const std::string& name, const std::function<void()>& work) {
    std::string message;
    try {
        work();
        return "";
    } catch (const Error& error) {
        message = error.what();
    } catch (const std::bad_alloc&) {
        message = "there is not enough memory for it; try --jobs 1 or a smaller picture";
    } catch (const std::exception& error) {
        message = std::string("this should not happen, please report it: ") + error.what();
    }
    return message.starts_with(name + ":") ? message : name + ": " + message;
}

void share_out(std::size_t count, int workers, const std::function<void(std::size_t)>& work) {
    std::atomic<std::size_t> next = 0;
    const auto take = [&] {
        for (std::size_t i = next++; i < count; i = next++) work(i);
    };
    const std::size_t wanted = workers > 0 ? static_cast<std::size_t>(workers) : std::max(1u, std::thread::hardware_concurrency());
    std::vector<std::jthread> others(std::max<std::size_t>(1, std::min(wanted, count)) - 1);
    for (auto& other : others) other = std::jthread(take);
    take();
}

Evaluation evaluate(const EvaluateRequest& request) {
    const std::size_t count = request.subjects.size();
    std::vector<Rows> all(count);
    std::mutex mutex;
    Progress progress(count, request.quiet);
    for (const auto& problem : request.problems) progress.say_line("tactics: " + problem);
    std::size_t done = 0;
    share_out(count, request.workers, [&](std::size_t i) {
        Rows rows = Examination(request, request.subjects[i]).rows();
        const std::lock_guard lock(mutex);
        for (const auto& problem : rows.problems) progress.say_line("tactics: " + problem);
        all[i] = std::move(rows);
        progress.show(++done);
    });
    progress.clear();
    return collect(request, std::move(all));
}

}  // namespace tactics
