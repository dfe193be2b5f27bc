// SPDX-License-Identifier: Apache-2.0
#include "tactics/transport/unfinished.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <ctime>
#include <filesystem>
#include <mutex>
#include <set>
#include <string_view>
#include <system_error>

#include "tactics/transport/file.h"

namespace tactics {

namespace {

constexpr std::string_view kBegin = ".tactics-";
constexpr std::time_t kStale = 24 * 60 * 60;  // s, of a name whose process cannot be asked after: ours

// Never destroyed, as other threads may still write while the program ends.
struct Known {
    std::mutex mutex;
    std::set<std::string> names;    // of files that are being written
    std::set<std::string> cleaned;  // folders
};
Known& known() {
    static Known* const all = new Known;
    return *all;
}

std::string first_of(const char* path, std::size_t most) {
    std::array<char, 1024> text{};
    const int file = open(path, O_RDONLY | O_CLOEXEC);
    if (file < 0) return "";
    const ssize_t size = read(file, text.data(), std::min(most, text.size()));
    close(file);
    return {text.data(), size > 0 ? static_cast<std::size_t>(size) : 0};
}

// Start time of a process, in ticks since boot; empty: no such process. proc(5), /proc/pid/stat, field 22, counted after the name
// in brackets, which may hold anything.
std::string start_of(const std::string& pid) {
    const std::string text = first_of(("/proc/" + pid + "/stat").c_str(), 1024);
    std::size_t at = text.rfind(')');
    for (int field = 2; field < 22 && at != std::string::npos; ++field) at = text.find(' ', at + 1);
    return at == std::string::npos ? "" : text.substr(at + 1, text.find(' ', at + 1) - at - 1);
}

// Identifies this boot of the machine and the visible processes, because containers have their own numbers. Empty: unknown on
// this system.
std::string own_boot() {
    const std::string boot = first_of("/proc/sys/kernel/random/boot_id", 8);
    struct stat space {};
    return boot.empty() || stat("/proc/self/ns/pid", &space) != 0 ? "" : boot + std::to_string(space.st_ino);
}

// ".tactics-BOOT-PID-START-NUMBER"
bool is_left_behind(const std::string& path, const std::string& name) {
    std::array<std::string, 4> part;
    std::size_t at = kBegin.size();
    for (std::size_t i = 0; i < part.size(); ++i) {
        const std::size_t end = i + 1 < part.size() ? name.find('-', at) : name.size();
        if (end == std::string::npos) return false;
        part[i] = name.substr(at, end - at);
        if (part[i].empty() || part[i].find_first_not_of("0123456789abcdef") != std::string::npos) return false;
        at = end + 1;
    }
    if (part[0] == own_boot()) return start_of(part[1]) != part[2];
    struct stat file {};
    return lstat(path.c_str(), &file) == 0 && S_ISREG(file.st_mode) && std::time(nullptr) - file.st_mtime > kStale;
}

void clean(const std::string& folder) {
    std::error_code fault;
    for (auto entry = std::filesystem::directory_iterator(folder, fault);
         !fault && entry != std::filesystem::directory_iterator(); entry.increment(fault)) {
        const std::string path = entry->path().string(), name = entry->path().filename().string();
        if (name.starts_with(kBegin) && is_left_behind(path, name)) unlink(path.c_str());
    }
}

}  // namespace

UnfinishedName::UnfinishedName(const std::string& folder) {
    static std::atomic<unsigned> counter = 0;
    const std::string boot = own_boot(), pid = std::to_string(getpid()), start = start_of(pid);
    name_ = folder + "/" + std::string(kBegin) + (boot.empty() ? "0" : boot) + "-" + pid + "-" + (start.empty() ? "0" : start) +
            "-" + std::to_string(counter++);
    const std::lock_guard lock(known().mutex);
    if (known().cleaned.insert(folder).second) clean(folder);
    known().names.insert(name_);
}

UnfinishedName::~UnfinishedName() {
    if (exists_) unlink(name_.c_str());
    const std::lock_guard lock(known().mutex);
    known().names.erase(name_);
}

void remove_unfinished_files() {
    const std::lock_guard lock(known().mutex);
    for (const std::string& name : known().names) unlink(name.c_str());
}

}  // namespace tactics
