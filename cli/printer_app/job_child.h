// SPDX-License-Identifier: Apache-2.0
// A document is converted by a program of its own, this one once more: what it reads was sent by a stranger, and a server must
// go on whatever becomes of it.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/printer_app/machine_driver.h"
#include "cli/verbs/print_job.h"

namespace tactics {

struct JobRequest {
    std::string driver;  ///< its name
    std::string title;   ///< of the job
    PrintJob job;
    PrintOptions defaults;  ///< of the printer, by their names in a PPD file
    PrintOptions options;   ///< of the job
};

/// The queue that these make. Throws Error as queue_of does, and for a driver that does not exist.
Queue queue_of(const JobRequest& request);

inline constexpr std::size_t kMostJobBytes = std::size_t{1} << 28;  ///< a book of 10,000 pages has a tenth of it

struct JobWatch {
    std::function<void(std::string_view note)> note;  ///< a line for the log
    std::function<void()> sheet;                      ///< another sheet was made
    std::function<bool()> is_cancelled;               ///< asked several times a second
};

/// The bytes for the machine; empty if the job was cancelled. `document` is read from its beginning and stays open. Throws Error
/// with what the child reports.
std::string convert_job(const JobRequest& request, int document, const JobWatch& watch);

/// The child's command line; the rest of the job would stand there for all who list processes.
inline constexpr std::string_view kJobChild = "convert-job";

/// The child: its request is on the file after standard error, the document on standard input. Returns the exit code. Never
/// throws.
int run_job_child();

}  // namespace tactics
