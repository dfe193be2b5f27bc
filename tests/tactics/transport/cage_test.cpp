// SPDX-License-Identifier: Apache-2.0
// A process that has shut itself in tries what it must not do, and tells by letters what it was let do.
#include "tactics/transport/cage.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <linux/fs.h>
#include <netinet/in.h>
#include <pthread.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/inotify.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/shm.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/cli/tool.h"

namespace tactics::cage_test {
namespace {

struct Told {
    std::string letters;
    int status = 0;
};

// What `trial` writes to its descriptor, from a copy of this process. It asks for no memory of the library's: locks of other
// threads may be held in the copy.
const pid_t kTests = getpid();

template <class Trial>
Told from_a_copy(const Trial& trial) {
    std::array<int, 2> ends{};
    EXPECT_EQ(pipe(ends.data()), 0);
    const pid_t copy = fork();
    if (copy == 0) {
        trial(ends[1]);
        _exit(0);
    }
    close(ends[1]);
    Told told;
    std::array<char, 100> buffer{};
    for (ssize_t count; (count = read(ends[0], buffer.data(), buffer.size())) > 0;)
        told.letters.append(buffer.data(), static_cast<std::size_t>(count));
    close(ends[0]);
    waitpid(copy, &told.status, 0);
    return told;
}

void tell(int to, bool could, char letter) {
    if (could) static_cast<void>(!write(to, &letter, 1));
}

void* nothing(void*) { return nullptr; }

TEST(Cage, ReadsOneFileComputesAndAnswersAndNoMore) {
    const tests::Folder folder;
    std::ofstream(folder / "given") << "given";
    std::ofstream(folder / "other") << "other";
    const std::string other = (folder / "other").string(), fresh = (folder / "fresh").string();
    const int given = open((folder / "given").c_str(), O_RDONLY);
    const std::string again = "/dev/fd/" + std::to_string(given);
    const auto trials = [&](int to) {
        tell(to, open(again.c_str(), O_RDONLY) >= 0, 'r');
        tell(to, open(other.c_str(), O_RDONLY) >= 0, 'o');
        tell(to, open(other.c_str(), O_WRONLY) >= 0, 'w');
        tell(to, open(fresh.c_str(), O_WRONLY | O_CREAT, 0600) >= 0, 'c');
        tell(to, unlink(other.c_str()) == 0, 'u');
        tell(to, rename(other.c_str(), fresh.c_str()) == 0, 'm');
        tell(to, socket(AF_INET, SOCK_STREAM, 0) >= 0, 's');
        const pid_t one = fork();
        if (one == 0) _exit(0);
        tell(to, one > 0, 'f');
        tell(to, kill(getppid(), 0) == 0, 'k');
        execl("/bin/sh", "sh", "-c", "true", static_cast<char*>(nullptr));
        pthread_t thread{};
        tell(to, pthread_create(&thread, nullptr, nothing, nullptr) == 0 && pthread_join(thread, nullptr) == 0, 't');
    };
    // A thread wants memory, of which a sanitizer has taken more than there is.
    const CageLimits roomy{.memory = ~std::size_t{0}};
    const Told free = from_a_copy([&](int to) {
        tell(to, open(other.c_str(), O_RDONLY) >= 0, 'o');
        tell(to, socket(AF_INET, SOCK_STREAM, 0) >= 0, 's');
    });
    EXPECT_EQ(free.letters, "os");
    const Told told = from_a_copy([&](int to) {
        shut_in(given, kTests, roomy);
        trials(to);
    });
    // Where the kernel has no Landlock, files may be read, and never written.
    EXPECT_TRUE(told.letters == "rt" || told.letters == "rot") << told.letters;
    EXPECT_EQ(told.status, 0);
    EXPECT_TRUE(std::filesystem::exists(other));
    close(given);
}

TEST(Cage, AsksForNoMoreThanItsMemoryAndTime) {
    constexpr std::size_t kMemory = std::size_t{1} << 30;
    const auto could_take = [](std::size_t size) {
        return mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0) != MAP_FAILED;
    };
    EXPECT_EQ(from_a_copy([&](int to) { tell(to, could_take(2 * kMemory), 'm'); }).letters, "m");
    const Told told = from_a_copy([&](int to) {
        shut_in(0, kTests, {.memory = kMemory});
        tell(to, could_take(2 * kMemory), 'm');
    });
    EXPECT_EQ(told.letters, "");
    // What is only read costs its tables, and a stack is none of what RLIMIT_DATA counts.
    const auto could_look_into = [](std::size_t size) {
        return mmap(nullptr, size, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0) != MAP_FAILED;
    };
    EXPECT_EQ(from_a_copy([&](int to) { tell(to, could_look_into(1024 * kMemory), 'm'); }).letters, "m");
    const Told reading = from_a_copy([&](int to) {
        shut_in(0, kTests, {.memory = kMemory});
        tell(to, could_look_into(1024 * kMemory), 'm');
    });
    EXPECT_EQ(reading.letters, "");
    const Told deep = from_a_copy([&](int to) {
        rlimit stack{RLIM_INFINITY, RLIM_INFINITY};
        setrlimit(RLIMIT_STACK, &stack);
        shut_in_program({}, kTests, {.memory = kMemory});
        tell(to, getrlimit(RLIMIT_STACK, &stack) != 0 || stack.rlim_max > kMemory, 's');
    });
    EXPECT_EQ(deep.letters, "");
    const Told busy = from_a_copy([](int) {
        shut_in(0, kTests, {.memory = ~std::size_t{0}, .processor_seconds = 1, .seconds = 20});
        for (volatile bool forever = true; forever;) continue;
    });
    EXPECT_TRUE(WIFSIGNALED(busy.status) && (WTERMSIG(busy.status) == SIGXCPU || WTERMSIG(busy.status) == SIGKILL))
        << busy.status;
    const Told asleep = from_a_copy([](int) {
        shut_in(0, kTests, {.memory = ~std::size_t{0}, .seconds = 1});
        signal(SIGALRM, SIG_IGN);  // as a program that was broken into would
        for (int second = 0; second < 20; ++second) sleep(1);
    });
    EXPECT_TRUE(WIFSIGNALED(asleep.status) && WTERMSIG(asleep.status) == SIGKILL) << asleep.status;
}

// What a program that was broken into could do to others without opening anything: signals by the number of a thread or by a
// descriptor that tells of its input, and memory that no limit counts.
void reach_out(int to) {
    const auto could_map = [](int flags) {
        return mmap(nullptr, 4096, PROT_READ | PROT_WRITE, flags | MAP_ANONYMOUS, -1, 0) != MAP_FAILED;
    };
    tell(to, fcntl(to, F_SETFD, FD_CLOEXEC) == 0 && fcntl(to, F_GETFL) >= 0, 'f');
    tell(to, could_map(MAP_PRIVATE), 'p');
    tell(to, syscall(SYS_tgkill, getpid(), getpid(), 0) == 0, 'o');
    tell(to, syscall(SYS_tgkill, kTests, kTests, 0) == 0, 'K');
    tell(to, fcntl(to, F_SETOWN, kTests) == 0, 'O');
    tell(to, fcntl(to, F_SETSIG, SIGKILL) == 0, 'S');
    tell(to, could_map(MAP_SHARED), 'M');
    tell(to, could_map(MAP_PRIVATE | MAP_GROWSDOWN), 'G');
    tell(to, fcntl(to, F_SETPIPE_SZ, 1 << 17) > 0, 'L');
    tell(to, dup2(to, 300) == 300, 'D');
    tell(to, fcntl(to, F_DUPFD_CLOEXEC, 0) >= 0, 'd');
    // Locks and watches that others would feel; a delegation is known from Linux 6.19 on, and refused before.
    constexpr int kSetDelegation = 1024 + 16;
    struct flock lock {};
    lock.l_type = F_RDLCK;
    tell(to, fcntl(STDIN_FILENO, F_SETLK, &lock) == 0 || errno != EPERM, 'R');
    tell(to, fcntl(to, kSetDelegation, 0) == 0 || errno != EPERM, 'F');
    tell(to, flock(to, LOCK_SH) == 0 || errno != EPERM, 'X');
    tell(to, inotify_init1(0) >= 0 || errno != EPERM, 'W');
    // Refused before the kernel examines the rest, which is invalid: only root would get further.
    tell(to, syscall(SYS_clone, CLONE_THREAD | CLONE_NEWNET, 0, 0, 0, 0) >= 0 || errno != EPERM, 'N');
}

TEST(Cage, LetsAlone) {
    EXPECT_EQ(from_a_copy(reach_out).letters, "fpoKOSMGLDdRFXWN");
    const CageLimits roomy{.memory = ~std::size_t{0}};
    const Told few = from_a_copy([&](int to) {
        shut_in(0, kTests, roomy);
        reach_out(to);
    });
    EXPECT_EQ(few.letters, "fpod");
    const Told many = from_a_copy([&](int to) {
        shut_in_program({}, kTests, roomy);
        reach_out(to);
    });
    EXPECT_EQ(many.letters, "fpod");
}

// A program is refused calls by name, and no name is known of those that a later kernel has: fchmodat2 is 452 everywhere.
TEST(Cage, OfAProgramChangesNothingThatOthersHave) {
    const tests::Folder folder;
    const std::string file = (folder / "file").string();
    tests::write_bytes(file, "x");
    const auto trials = [&](int to) {
        constexpr long kFchmodat2 = 452;
        long flags = 0;
        const int given = open(file.c_str(), O_RDONLY);
        tell(to, isatty(STDIN_FILENO) == 1 || errno == ENOTTY, 'i');
        tell(to, syscall(SYS_sched_setaffinity, 0, 0, nullptr) != 0 && errno != EPERM, 'a');
        tell(to, syscall(kFchmodat2, AT_FDCWD, file.c_str(), 0640, 0) == 0 || errno != ENOSYS, 'C');
        tell(to, ioctl(given, FS_IOC_GETFLAGS, &flags) == 0 || (errno != ENOTTY && errno != EBADF), 'I');
        tell(to, syscall(SYS_quotactl_fd, -1, 0, 0, nullptr) == 0 || errno != EPERM, 'Q');
        constexpr int kNoOrder = 99;
        tell(to, prctl(PR_SCHED_CORE, kNoOrder, 0, 0, 0) == 0 || errno != EPERM, 'S');
        tell(to, setpriority(PRIO_PROCESS, 0, getpriority(PRIO_PROCESS, 0)) == 0, 'P');
        tell(to, syscall(SYS_sched_setaffinity, kTests, 0, nullptr) == 0 || errno != EPERM, 'A');
        const int shared = shmget(IPC_PRIVATE, 4096, IPC_CREAT | 0600);
        tell(to, shared >= 0, 'M');
        if (shared >= 0) shmctl(shared, IPC_RMID, nullptr);
    };
    const Told told = from_a_copy([&](int to) {
        shut_in_program({}, kTests, {.memory = ~std::size_t{0}});
        trials(to);
    });
    EXPECT_EQ(told.letters, "ia");
    EXPECT_NE(from_a_copy(trials).letters.find("QSPAM"), std::string::npos);
}

}  // namespace
}  // namespace tactics::cage_test
