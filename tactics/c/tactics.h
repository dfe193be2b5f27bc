// SPDX-License-Identifier: Apache-2.0
// Tactile pages of pictures, for programs in C (C99) and for all that call C. A job is filled in, run, and asked what became of
// it:
//
//     tactics_job *job = tactics_new();
//     tactics_input(job, "photo.jpg");
//     tactics_output(job, "photo.pdf");
//     tactics_option(job, "title", "Hot air balloon");
//     if (tactics_run(job) != TACTICS_DONE) fprintf(stderr, "%s\n", tactics_message(job));
//     tactics_free(job);
//
// Ownership: the caller owns the job and frees it. What is passed in is copied before a call returns. What a function returns
// belongs to the job and is valid until the next call with that job, other than of functions that only ask. Threads: each job
// belongs to one thread at a time; different jobs may run at the same time. tactics_cancel alone may be called from any thread,
// and from a signal handler, while the job lives. Text is UTF-8 and ends with a zero byte; names of files are the bytes that the
// system knows them by. What is told is one line without its end, in which bytes that are no UTF-8 stand as \xNN. No function
// writes to standard output or to standard error. No C++ exception leaves a function. Pictures of some formats are read by
// programs that are installed with the library and that run as children of the calling process; the variable TACTICS_PROGRAMS may
// name their folder.
#pragma once

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct tactics_job tactics_job;

/// What a call came to; the first four are the exit codes of the program.
typedef enum tactics_code {
    TACTICS_DONE = 0,
    TACTICS_USAGE = 1,        ///< something was asked for that does not exist or does not go together
    TACTICS_FAILED = 2,       ///< it was right but could not be carried out: a damaged file, a full disk
    TACTICS_RULE_BROKEN = 3,  ///< with the option "strict": the pages are written, and one of them breaks a hard rule
    TACTICS_CANCELLED = 4,    ///< it was given up; nothing was written
    TACTICS_NO_MEMORY = 5
} tactics_code;

/// Where a job is.
typedef enum tactics_step { TACTICS_READING = 0, TACTICS_DRAWING = 1, TACTICS_LAYING_OUT = 2, TACTICS_WRITING = 3 } tactics_step;

/// "0.1.0"; never freed.
const char* tactics_version(void);

/// An empty job; a null pointer if there is no memory.
tactics_job* tactics_new(void);

/// A null pointer is allowed.
void tactics_free(tactics_job* job);

/// The file to read: a picture, an SVG, a PDF, a table or a model, as `tactics convert` takes it. It replaces what was set
/// before.
tactics_code tactics_input(tactics_job* job, const char* path);

/// The same of a file in memory, which is copied. `name` stands in messages.
tactics_code tactics_input_bytes(tactics_job* job, const void* bytes, size_t size, const char* name);

/// A further file to write: its ending names the format ("photo.pdf"), or what stands before it does ("everest-d:page.prn"). All
/// outputs are written whole, or none is. Its folder must be there.
tactics_code tactics_output(tactics_job* job, const char* path);

/// A wish by the name that `tactics help convert` gives it, without the dashes: "title", "paper", "recipe", "label". `value` is a
/// null pointer for one that takes none ("strict"). One that may be given several times adds up; of others the last value counts.
/// Unknown names are refused at once; values are looked at by tactics_run. Not for wishes about several pictures, or about what a
/// command line says: "files-from", "jobs", "json", "null", "output", "progress", "quiet", "save-recipe", "to", "update",
/// "verbose", "warnings".
tactics_code tactics_option(tactics_job* job, const char* name, const char* value);

/// `watch` is called with `user` before each step, by the thread that runs the job; anything but 0 gives the job up. A null
/// pointer: nobody looks on. It must return, and may call tactics_cancel but no other function with this job.
typedef int (*tactics_watch)(tactics_step step, void* user);
void tactics_on_step(tactics_job* job, tactics_watch watch, void* user);

/// The job is given up before its next step, or before its first if it does not run yet.
void tactics_cancel(tactics_job* job);

/// Makes the pages and writes them. It may be called again, with the same wishes or with more.
tactics_code tactics_run(tactics_job* job);

/// Why the last call with this job that gives a code failed, and how to mend it; empty if it did not. Wishes are written as on a
/// command line: "--paper: there is no paper ...".
const char* tactics_message(const tactics_job* job);

/// What there is to know of the pages that were made, a line each, as `tactics convert` tells it; none before they are.
size_t tactics_told_count(const tactics_job* job);
/// An empty line for an index that is too large.
const char* tactics_told(const tactics_job* job, size_t index);
/// 1: a person must look at the page for it, such as words that are left out; else 0.
int tactics_told_asks(const tactics_job* job, size_t index);

/// The same for programs, the object that `tactics convert --json` writes; empty before pages were made, or if they could not be.
const char* tactics_json(const tactics_job* job);

#ifdef __cplusplus
}
#endif
