// SPDX-License-Identifier: Apache-2.0
// The user that a print filter becomes where root starts it.
#pragma once

#include <pwd.h>
#include <sys/wait.h>
#include <unistd.h>

namespace tactics::tests {

/// lp, else nobody.
inline const passwd* print_user() {
    const passwd* user = getpwnam("lp");
    return user != nullptr ? user : getpwnam("nobody");
}

/// False: this is root, and that user may not enter the folder that we were built in, as where that is in root's own.
inline bool print_user_reaches(const char* program) {
    if (geteuid() != 0) return true;
    const passwd* user = print_user();
    if (user == nullptr) return false;
    const uid_t id = user->pw_uid;
    const pid_t copy = fork();
    if (copy == 0) _exit(setresuid(id, id, id) == 0 && access(program, X_OK) == 0 ? 0 : 1);
    int status = 1;
    waitpid(copy, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace tactics::tests
