// SPDX-License-Identifier: Apache-2.0
#include "tactics/transport/cage.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cstddef>
#include <cstdint>

#if __has_include(<linux/landlock.h>)
#include <linux/landlock.h>
#endif

namespace tactics {

namespace {

void limit(__rlimit_resource what, std::size_t value) {
    const rlimit wanted{value, value};
    setrlimit(what, &wanted);
}

// One file may be read and none written. A rule may name a file as well as a folder (landlock(7)).
void open_one_file_only([[maybe_unused]] int readable) {
#if defined(LANDLOCK_ACCESS_FS_READ_FILE) && defined(SYS_landlock_create_ruleset)
    landlock_ruleset_attr handled{};
    handled.handled_access_fs = LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_WRITE_FILE | LANDLOCK_ACCESS_FS_READ_FILE |
                                LANDLOCK_ACCESS_FS_READ_DIR | LANDLOCK_ACCESS_FS_REMOVE_DIR | LANDLOCK_ACCESS_FS_REMOVE_FILE |
                                LANDLOCK_ACCESS_FS_MAKE_CHAR | LANDLOCK_ACCESS_FS_MAKE_DIR | LANDLOCK_ACCESS_FS_MAKE_REG |
                                LANDLOCK_ACCESS_FS_MAKE_SOCK | LANDLOCK_ACCESS_FS_MAKE_FIFO | LANDLOCK_ACCESS_FS_MAKE_BLOCK |
                                LANDLOCK_ACCESS_FS_MAKE_SYM;
    const int rules = static_cast<int>(syscall(SYS_landlock_create_ruleset, &handled, sizeof handled, 0));
    if (rules < 0) return;
    landlock_path_beneath_attr one{};
    one.allowed_access = LANDLOCK_ACCESS_FS_READ_FILE;
    one.parent_fd = readable;
    // A file that lies in memory alone cannot be named, and need not be: Landlock lets it be.
    syscall(SYS_landlock_add_rule, rules, LANDLOCK_RULE_PATH_BENEATH, &one, 0);
    syscall(SYS_landlock_restrict_self, rules, 0);
    close(rules);
#endif
}

#if defined(__x86_64__)
constexpr std::uint32_t kMachine = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t kMachine = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t kMachine = 0;  // calls are not looked at
#endif

// What decoding needs of the kernel: memory, threads, time, and files that are open.
constexpr auto kAllowed = std::to_array<std::uint32_t>({
    SYS_read,
    SYS_write,
    SYS_readv,
    SYS_writev,
    SYS_pread64,
    SYS_preadv,
    SYS_lseek,
    SYS_close,
    SYS_fstat,
    SYS_newfstatat,
    SYS_statx,
    SYS_fcntl,
    SYS_dup,
    SYS_getcwd,
    SYS_readlinkat,
    SYS_faccessat,
    SYS_mmap,
    SYS_munmap,
    SYS_mprotect,
    SYS_mremap,
    SYS_madvise,
    SYS_brk,
    SYS_futex,
    SYS_set_robust_list,
    SYS_rt_sigaction,
    SYS_rt_sigprocmask,
    SYS_rt_sigreturn,
    SYS_sigaltstack,
    SYS_tgkill,
    SYS_restart_syscall,
    SYS_gettid,
    SYS_getpid,
    SYS_getuid,
    SYS_geteuid,
    SYS_getgid,
    SYS_getegid,
    SYS_exit,
    SYS_exit_group,
    SYS_sched_yield,
    SYS_sched_getaffinity,
    SYS_getrusage,
    SYS_sysinfo,
    SYS_uname,
    SYS_getrandom,
    SYS_clock_gettime,
    SYS_clock_getres,
    SYS_clock_nanosleep,
    SYS_nanosleep,
    SYS_gettimeofday,
#ifdef SYS_rseq
    SYS_rseq,
#endif
#ifdef SYS_stat
    SYS_stat,
    SYS_lstat,
    SYS_access,
    SYS_readlink,
    SYS_time,
#endif
});

// A program of the kernel's packet filter over struct seccomp_data (seccomp(2)): a call that is not in the list fails with
// EPERM, as it would for lack of rights, and the library goes on or gives up by itself.
void allow_few_calls() {
    if (kMachine == 0) return;
    constexpr std::uint32_t kAllow = SECCOMP_RET_ALLOW, kRefuse = SECCOMP_RET_ERRNO | EPERM;
    constexpr std::size_t kMost = 2 * kAllowed.size() + 32;
    std::array<sock_filter, kMost> code{};
    std::size_t used = 0;
    const auto put = [&](std::uint16_t what, std::uint32_t value, std::uint8_t if_so = 0, std::uint8_t if_not = 0) {
        code[used++] = {what, if_so, if_not, value};
    };
    const auto load = [&](std::size_t at) { put(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(at)); };
    const auto end = [&](std::uint32_t verdict) { put(BPF_RET | BPF_K, verdict); };
    constexpr std::uint16_t kEqual = BPF_JMP | BPF_JEQ | BPF_K, kAnyBit = BPF_JMP | BPF_JSET | BPF_K;
    const auto argument = [](std::size_t number) { return offsetof(seccomp_data, args) + 8 * number; };  // its low half

    load(offsetof(seccomp_data, arch));
    put(kEqual, kMachine, 1, 0);
    end(SECCOMP_RET_KILL_PROCESS);
    load(offsetof(seccomp_data, nr));
    for (const std::uint32_t call : kAllowed) {
        put(kEqual, call, 0, 1);
        end(kAllow);
    }
    // Its flags lie in memory, where a filter cannot see them. Without it the C library takes clone.
    put(kEqual, SYS_clone3, 0, 1);
    end(SECCOMP_RET_ERRNO | ENOSYS);
    put(kEqual, SYS_clone, 0, 4);  // a thread, no process
    load(argument(0));
    put(kAnyBit, CLONE_THREAD, 0, 1);
    end(kAllow);
    end(kRefuse);
    constexpr std::uint32_t kWriting = O_WRONLY | O_RDWR | O_CREAT | O_TRUNC;
    const auto open_to_read = [&](std::uint32_t call, std::size_t flags) {
        put(kEqual, call, 0, 4);
        load(argument(flags));
        put(kAnyBit, kWriting, 1, 0);
        end(kAllow);
        end(kRefuse);
    };
    open_to_read(SYS_openat, 2);
#ifdef SYS_open
    open_to_read(SYS_open, 1);
#endif
    end(kRefuse);
    const sock_fprog program{static_cast<unsigned short>(used), code.data()};
    prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program, 0, 0);
}

}  // namespace

void shut_in(int readable, const CageLimits& limits) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, 0);
    limit(RLIMIT_DATA, limits.memory);
    limit(RLIMIT_CPU, limits.processor_seconds);
    alarm(limits.seconds);
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return;
    open_one_file_only(readable);
    allow_few_calls();
}

}  // namespace tactics
