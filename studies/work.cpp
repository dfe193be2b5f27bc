// SPDX-License-Identifier: Apache-2.0
#include "studies/work.h"

#include <ctime>
#include <mutex>

#include "tactics/job/workers.h"

namespace tactics {

void work_through(const StudyRequest& request, const StudyWatch& watch, std::size_t count,
                  const std::function<std::vector<Phrase>(std::size_t)>& work) {
    const auto goes_on = [&](std::size_t done) {
        if (watch.goes_on) watch.goes_on(done, count);
    };
    const auto tell = [&](const std::vector<Phrase>& problems) {
        for (const auto& problem : problems)
            if (watch.tell) watch.tell(problem);
    };
    std::mutex mutex;
    std::size_t done = 0;
    goes_on(0);
    tell(request.problems);
    share_out(count, request.workers, [&](std::size_t i) {
        const std::vector<Phrase> problems = work(i);
        const std::lock_guard lock(mutex);
        tell(problems);
        goes_on(++done);
    });
}

double cpu_ms() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) / 1e6;
}

}  // namespace tactics
