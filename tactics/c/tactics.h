// SPDX-License-Identifier: Apache-2.0
// Tactile pages from pictures, for programs in C (C99) and any language that can call C. Fill in a job, run it, ask for its
// results:
//
//     tactics_job *job = tactics_new();
//     tactics_input(job, "photo.jpg");
//     tactics_output(job, "photo.pdf");
//     tactics_option(job, "title", "Hot air balloon");
//     if (tactics_run(job) != TACTICS_DONE) fprintf(stderr, "%s\n", tactics_message(job));
//     tactics_free(job);
//
// Ownership: the caller owns the job and frees it. The library copies its arguments before a call returns. Returned strings
// belong to the job and stay valid until the next call that changes it: any call that returns a code, or tactics_free. Threads:
// one thread at a time may use a job; different jobs may run at the same time. A program that ignores SIGCHLD cannot wait for the
// programs that read PDF and print, so those fail there. What a user keeps (tactics defaults, recipes) counts for nothing here.
// Only tactics_cancel may be called from any thread,
// or from a signal handler, for as long as the job exists. Text is UTF-8 and ends with a zero byte. File names are the bytes that
// the system uses. Messages are single lines without a line end; a byte that is not valid UTF-8 appears in them as \xNN. The
// library never writes to standard output or standard error. No C++ exception leaves a function. The library reads some kinds of
// file in child processes, with programs that are installed beside it; set the environment variable TACTICS_PROGRAMS to their
// folder if they are somewhere else.
#pragma once

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct tactics_job tactics_job;

/// The result of a call. The first four are also the exit codes of the program.
typedef enum tactics_code {
    TACTICS_DONE = 0,
    TACTICS_USAGE = 1,        ///< the request is wrong: an unknown name or value, or options that exclude each other
    TACTICS_FAILED = 2,       ///< the request is right but cannot be carried out: a damaged file, a full disk
    TACTICS_RULE_BROKEN = 3,  ///< option "strict" only: the pages are written, but one of them breaks a hard rule
    TACTICS_CANCELLED = 4,    ///< cancelled; nothing was written
    TACTICS_NO_MEMORY = 5
} tactics_code;

/// The steps of a job. Drawing and laying out repeat for each size of sheet, and until there is room for all words.
typedef enum tactics_step { TACTICS_READING = 0, TACTICS_DRAWING = 1, TACTICS_LAYING_OUT = 2, TACTICS_WRITING = 3 } tactics_step;

/// The version of the library, such as "0.1.0". Do not free it.
const char* tactics_version(void);

/// Creates an empty job. Returns a null pointer if there is not enough memory.
tactics_job* tactics_new(void);

/// Frees a job. A null pointer is allowed.
void tactics_free(tactics_job* job);

/// Sets the file to read, of any kind that `tactics convert` reads. Replaces an earlier input.
tactics_code tactics_input(tactics_job* job, const char* path);

/// Sets a file in memory as the input; the library keeps a copy. `name` appears in messages.
tactics_code tactics_input_bytes(tactics_job* job, const void* bytes, size_t size, const char* name);

/// Adds a file to write. Its extension names the format ("photo.pdf"), or a prefix does ("everest-d:page.prn"). The folder must
/// exist. Either all outputs are written, each completely, or none.
tactics_code tactics_output(tactics_job* job, const char* path);

/// Sets an option by its name in `tactics help convert`, without the dashes: "title", "paper", "recipe", "label". Pass a null
/// pointer as the value of an option that takes none, such as "strict". Options that the help calls repeatable add up; for all
/// others the last value counts. An unknown name fails at once; tactics_run checks the values. Options that concern several
/// pictures or the command line itself are not available: "files-from", "jobs", "json", "null", "output", "progress", "quiet",
/// "save-recipe", "to", "update", "verbose", "warnings".
tactics_code tactics_option(tactics_job* job, const char* name, const char* value);

/// Sets a function that is called with `user` before each step, in the thread that runs the job. A result other than 0 cancels
/// the job. The function must return; it may call tactics_cancel but nothing else with this job. A null pointer removes it.
typedef int (*tactics_watch)(tactics_step step, void* user);
void tactics_on_step(tactics_job* job, tactics_watch watch, void* user);

/// Cancels the job before its next step; a job that is not running stops before its first. Too late for the last step, it has no
/// effect.
void tactics_cancel(tactics_job* job);

/// Makes the pages and writes them. A job may be run again, with the same options or further ones.
tactics_code tactics_run(tactics_job* job);

/// What went wrong in the last call with this job that returned a code, and how to correct it; empty if nothing did. Options
/// are named as tactics_option takes them: "paper: there is no paper ...".
const char* tactics_message(const tactics_job* job);

/// The number of remarks about the pages, as `tactics convert` prints them but for the dashes of options; 0 until pages are made.
size_t tactics_told_count(const tactics_job* job);
/// One remark; empty if the index is too large.
const char* tactics_told(const tactics_job* job, size_t index);
/// 1 if a person must look at the page because of it, for example when words are left out; otherwise 0.
int tactics_told_asks(const tactics_job* job, size_t index);

/// The results for programs: the object that `tactics convert --json` prints (see `tactics help json`). Empty until pages are
/// made.
const char* tactics_json(const tactics_job* job);

#ifdef __cplusplus
}
#endif
