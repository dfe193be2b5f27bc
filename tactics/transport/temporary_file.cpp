// SPDX-License-Identifier: Apache-2.0
#include "tactics/transport/temporary_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <string>
#include <vector>

namespace tactics {

namespace {

std::vector<std::string> folders() {
    std::vector<std::string> all;
    const auto add = [&](const char* variable) {
        const char* folder = std::getenv(variable);
        if (folder != nullptr && folder[0] == '/') all.emplace_back(folder);
    };
    add("TMPDIR");
    all.insert(all.end(), {"/tmp", "/var/tmp"});
    add("XDG_RUNTIME_DIR");
    return all;
}

// Not every file system knows files without a name; there it has one for a moment.
int open_in(const std::string& folder) {
    const int without = open(folder.c_str(), O_TMPFILE | O_RDWR | O_EXCL | O_CLOEXEC, 0600);
    if (without >= 0) return without;
    std::string name = folder + "/.tactics-XXXXXX";
    const int named = mkostemp(name.data(), O_CLOEXEC);
    if (named >= 0) unlink(name.c_str());
    return named;
}

}  // namespace

TemporaryFile temporary_file() {
    int first = 0;
    for (const std::string& folder : folders()) {
        const int number = open_in(folder);
        if (std::FILE* file = number >= 0 ? fdopen(number, "w+b") : nullptr) return {file, &std::fclose};
        if (first == 0) first = errno;
        if (number >= 0) close(number);
    }
    errno = first;
    return {nullptr, &std::fclose};
}

Phrase temporary_file_cure() { return phrase("make room in {0}, or name another folder with TMPDIR", folders().front()); }

}  // namespace tactics
