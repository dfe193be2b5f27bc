// SPDX-License-Identifier: Apache-2.0
// The first and only program of a virtual machine whose power is cut: `tactics` converts a batch to its disk, and a job is sent
// to an embosser on a serial line. Whatever is told of either goes out at once: to the console, and, where the disk has room
// behind its file system, as a sector there, so that a log of the disk's writes has each word in its place. tests/bench/power_cut
// starts it.
#include <signal.h>
#include <sys/reboot.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "tests/bench/guest/guest.h"

namespace {

using namespace tactics::tests;

constexpr std::size_t kSector = 512;

class Told {
public:
    explicit Told(off_t begin) : disk_(open("/dev/vda", O_WRONLY | O_DIRECT)), at_(begin) {
        if (disk_ < 0 || posix_memalign(&sector_, 4096, kSector) != 0) std::printf("no sectors behind the file system\n");
    }
    // Past all caches and without asking the disk to empty its own, which would keep what `tactics` itself should have kept.
    void add(const std::string& line) {
        const std::lock_guard lock(busy_);
        std::memset(sector_, 0, kSector);
        std::snprintf(static_cast<char*>(sector_), kSector, "TOLD %s", line.c_str());
        if (pwrite(disk_, sector_, kSector, at_) != static_cast<ssize_t>(kSector))
            std::printf("cannot mark: %s\n", std::strerror(errno));
        at_ += kSector;
        std::printf("TOLD %s\n", line.c_str());
        std::fflush(stdout);
    }

private:
    std::mutex busy_;
    int disk_;
    off_t at_;
    void* sector_ = nullptr;
};

// Its words, a line at a time, as soon as they are there.
void run(Told& told, const std::vector<std::string>& given) {
    std::vector<char*> words;
    for (const std::string& word : given) words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) return;
    const pid_t child = fork();
    if (child == 0) {
        dup2(ends[1], 1);
        dup2(ends[1], 2);
        close(ends[0]);
        close(ends[1]);
        execv(words[0], words.data());
        _exit(127);
    }
    close(ends[1]);
    std::FILE* lines = fdopen(ends[0], "r");
    std::array<char, 400> line{};
    while (std::fgets(line.data(), line.size(), lines) != nullptr) {
        line[std::strcspn(line.data(), "\n")] = 0;
        told.add(line.data());
    }
    std::fclose(lines);
    int status = 0;
    waitpid(child, &status, 0);
    told.add("exit " + std::to_string(WEXITSTATUS(status)) + " of " + given[1]);
}

}  // namespace

int main() {
    set_up_guest();
    setenv("HOME", "/tmp", 1);
    setenv("LC_ALL", "C.UTF-8", 1);
    mkdir("/tmp", 01777);
    mkdir("/disk", 0755);
    if (mount("/dev/vda", "/disk", "ext4", MS_NOATIME, nullptr) != 0)
        std::printf("cannot mount the disk: %s\n", std::strerror(errno));
    const char* size = std::getenv("FILE_SYSTEM");  // of the kernel's words: bytes
    Told told(std::atoll(size == nullptr ? "0" : size));
    std::printf("BEGIN\n");
    std::fflush(stdout);
    std::thread job([&] {
        run(told, {"/tactics", "emboss", "/job.brf", "--to", "/dev/ttyS1@115200,none", "--embosser", "index-v4"});
    });
    std::vector<std::string> batch{"/tactics", "convert", "-o",        "/disk/pages/", "--to",
                                   "pdf",      "--to",    "heightmap", "--to",         "brf"};
    for (const auto& picture : std::filesystem::directory_iterator("/pictures")) batch.push_back(picture.path());
    std::sort(batch.begin() + 10, batch.end());
    run(told, batch);
    job.join();
    std::printf("END\n");
    std::fflush(stdout);
    rest(300);
    reboot(RB_AUTOBOOT);
}
