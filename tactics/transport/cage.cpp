// SPDX-License-Identifier: Apache-2.0
#include "tactics/transport/cage.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "tactics/transport/call_rules.h"

#if __has_include(<linux/landlock.h>)
#include <linux/landlock.h>
#endif

namespace tactics {

namespace {

void limit(__rlimit_resource what, std::size_t value) {
    const rlimit wanted{value, value};
    setrlimit(what, &wanted);
}

// All rights of Linux 5.13; none for writing is granted. A rule may name a file as well as a folder (landlock(7)).
#if defined(LANDLOCK_ACCESS_FS_READ_FILE) && defined(SYS_landlock_create_ruleset)
class FileRules {
public:
    FileRules() {
        landlock_ruleset_attr handled{};
        handled.handled_access_fs = LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_WRITE_FILE | LANDLOCK_ACCESS_FS_READ_FILE |
                                    LANDLOCK_ACCESS_FS_READ_DIR | LANDLOCK_ACCESS_FS_REMOVE_DIR | LANDLOCK_ACCESS_FS_REMOVE_FILE |
                                    LANDLOCK_ACCESS_FS_MAKE_CHAR | LANDLOCK_ACCESS_FS_MAKE_DIR | LANDLOCK_ACCESS_FS_MAKE_REG |
                                    LANDLOCK_ACCESS_FS_MAKE_SOCK | LANDLOCK_ACCESS_FS_MAKE_FIFO | LANDLOCK_ACCESS_FS_MAKE_BLOCK |
                                    LANDLOCK_ACCESS_FS_MAKE_SYM;
        rules_ = static_cast<int>(syscall(SYS_landlock_create_ruleset, &handled, sizeof handled, 0));
    }
    // A file that lies in memory alone cannot be named, and need not be: Landlock lets it be.
    void read(int file) const { allow(file, LANDLOCK_ACCESS_FS_READ_FILE); }
    // A program, its libraries and data.
    void use(const char* path) const {
        const int place = open(path, O_PATH | O_CLOEXEC);
        struct stat facts {};
        if (place < 0 || fstat(place, &facts) != 0) return;
        constexpr std::uint64_t kFile = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_EXECUTE;
        allow(place, S_ISDIR(facts.st_mode) ? kFile | LANDLOCK_ACCESS_FS_READ_DIR : kFile);
        close(place);
    }
    void hold() const {
        if (rules_ < 0) return;
        syscall(SYS_landlock_restrict_self, rules_, 0);
        close(rules_);
    }

private:
    void allow(int place, std::uint64_t rights) const {
        if (rules_ < 0) return;
        landlock_path_beneath_attr one{};
        one.allowed_access = rights;
        one.parent_fd = place;
        syscall(SYS_landlock_add_rule, rules_, LANDLOCK_RULE_PATH_BENEATH, &one, 0);
    }
    int rules_ = -1;
};
#else
struct FileRules {
    void read(int) const {}
    void use(const char*) const {}
    void hold() const {}
};
#endif

// The system calls that decoding needs: memory, threads, time, and open files.
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
    SYS_dup,
    SYS_getcwd,
    SYS_readlinkat,
    SYS_faccessat,
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

void allow_few_calls() {
    if (kMachine == 0) return;
    CallRules rules;
    for (const std::uint32_t call : kAllowed) rules.on(call, kAllow);
    rules.descriptors_as_they_are();
    rules.memory_that_counts();
    rules.signals_to_itself({SYS_tgkill});
    rules.threads_only();
    rules.open_to_read_only();
    rules.end(kRefuse);
    rules.hold();
}

// What no program that reads a document needs.
constexpr auto kRefused = std::to_array<std::uint32_t>({
    // the network, and other processes
    SYS_socket,
    SYS_socketpair,
    SYS_ptrace,
    SYS_process_vm_readv,
    SYS_process_vm_writev,
    SYS_tkill,
    SYS_rt_sigqueueinfo,
    SYS_rt_tgsigqueueinfo,
    SYS_pidfd_open,
    SYS_pidfd_send_signal,
    SYS_pidfd_getfd,
    SYS_setpriority,
    SYS_ioprio_set,
    SYS_migrate_pages,
    SYS_move_pages,
    SYS_kcmp,
    // memory and messages that others share, which no limit counts and which stay
    SYS_shmget,
    SYS_shmat,
    SYS_shmctl,
    SYS_msgget,
    SYS_msgsnd,
    SYS_msgrcv,
    SYS_msgctl,
    SYS_semget,
    SYS_semop,
    SYS_semtimedop,
    SYS_semctl,
    SYS_mq_open,
    SYS_mq_unlink,
    // locks that others wait for, and what they do with their files
    SYS_flock,
    SYS_inotify_init1,
    SYS_inotify_add_watch,
    // its own limits, group and rights
    SYS_setrlimit,
    SYS_setpgid,
    SYS_setsid,
    SYS_unshare,
    SYS_setns,
    SYS_chroot,
    SYS_pivot_root,
    SYS_mount,
    SYS_umount2,
    SYS_open_tree,
    SYS_move_mount,
    SYS_fsopen,
    SYS_fspick,
    SYS_mount_setattr,
    SYS_capset,
    SYS_setuid,
    SYS_setgid,
    SYS_setreuid,
    SYS_setregid,
    SYS_setresuid,
    SYS_setresgid,
    SYS_setfsuid,
    SYS_setfsgid,
    SYS_setgroups,
    // the machine, where root runs this
    SYS_reboot,
    SYS_swapon,
    SYS_swapoff,
    SYS_sethostname,
    SYS_setdomainname,
    SYS_settimeofday,
    SYS_clock_settime,
    SYS_clock_adjtime,
    SYS_adjtimex,
    SYS_acct,
    SYS_quotactl,
    SYS_quotactl_fd,
    SYS_syslog,
    SYS_vhangup,
    // files changed
    SYS_unlinkat,
    SYS_renameat2,
    SYS_mkdirat,
    SYS_mknodat,
    SYS_linkat,
    SYS_symlinkat,
    SYS_fchmod,
    SYS_fchmodat,
    SYS_fchown,
    SYS_fchownat,
    SYS_truncate,
    SYS_ftruncate,
    SYS_fallocate,
    SYS_utimensat,
    SYS_setxattr,
    SYS_lsetxattr,
    SYS_fsetxattr,
    SYS_removexattr,
    SYS_lremovexattr,
    SYS_fremovexattr,
    SYS_name_to_handle_at,
    SYS_open_by_handle_at,
    // parts of the kernel that are broken into most
    SYS_bpf,
    SYS_perf_event_open,
    SYS_userfaultfd,
    SYS_keyctl,
    SYS_add_key,
    SYS_request_key,
    SYS_io_uring_setup,
    SYS_io_uring_enter,
    SYS_io_uring_register,
    SYS_init_module,
    SYS_finit_module,
    SYS_kexec_load,
    SYS_kexec_file_load,
    SYS_delete_module,
    SYS_fanotify_init,
#ifdef SYS_iopl
    SYS_iopl,
    SYS_ioperm,
    SYS_modify_ldt,
#endif
#ifdef SYS_fork
    SYS_inotify_init,
    SYS_fork,
    SYS_vfork,
    SYS_creat,
    SYS_unlink,
    SYS_rename,
    SYS_mkdir,
    SYS_rmdir,
    SYS_mknod,
    SYS_link,
    SYS_symlink,
    SYS_chmod,
    SYS_chown,
    SYS_lchown,
    SYS_utime,
    SYS_utimes,
    SYS_futimesat,
#endif
#ifdef SYS_renameat
    SYS_renameat,
#endif
});

// The newest that the list was made with: futex_waitv, Linux 5.16. What came later does what is refused in other words
// (fchmodat2, setxattrat), and programs must do without it on older kernels. The old calls of x32 lie above it, too.
constexpr std::uint32_t kNewestKnown = 449;

// The queries of a library about a file that may be a terminal.
constexpr auto kHarmlessOrders = std::to_array<std::uint32_t>({TCGETS, TIOCGWINSZ, FIONREAD, FIONBIO, FIOCLEX, FIONCLEX});

void refuse_many_calls() {
    if (kMachine == 0) return;
    CallRules rules;
    rules.put(BPF_JMP | BPF_JGT | BPF_K, kNewestKnown, 0, 1);
    rules.end(SECCOMP_RET_ERRNO | ENOSYS);
    for (const std::uint32_t call : kRefused) rules.on(call, kRefuse);
    for (const std::uint32_t order : kHarmlessOrders) rules.on_value_else_go_on(SYS_ioctl, 1, order, kAllow);
    rules.on(SYS_ioctl, SECCOMP_RET_ERRNO | ENOTTY);
    rules.descriptors_as_they_are();
    rules.memory_that_counts();
    rules.threads_only();
    rules.open_to_read_only();
    rules.on(SYS_openat2, SECCOMP_RET_ERRNO | ENOSYS);  // its flags lie in memory, too
    rules.signals_to_itself({SYS_kill, SYS_tgkill});
    for (const std::uint32_t call : {SYS_sched_setaffinity, SYS_sched_setscheduler, SYS_sched_setparam, SYS_sched_setattr})
        rules.on_value(call, 0, 0, kAllow, kRefuse);  // 0: the thread that asks
    // Core scheduling could also be set for other processes.
    rules.on_value_else_go_on(SYS_prctl, 0, PR_SCHED_CORE, kRefuse);
    rules.on_value(SYS_prctl, 0, PR_SET_PDEATHSIG, kRefuse, kAllow);
    rules.unless_null(SYS_prlimit64, 2, kRefuse);  // limits may be read, not set
    rules.end(kAllow);
    rules.hold();
}

// A signal that cannot be held back, from a clock that a few calls cannot stop. A program that takes over (exec) has no such
// clocks.
void end_after(unsigned seconds) {
    sigevent told{};
    told.sigev_notify = SIGEV_SIGNAL;
    told.sigev_signo = SIGKILL;
    itimerspec once{};
    once.it_value.tv_sec = static_cast<time_t>(seconds);
    timer_t clock{};
    if (timer_create(CLOCK_MONOTONIC, &told, &clock) != 0 || timer_settime(clock, 0, &once, nullptr) != 0) alarm(seconds);
}

// A pipe keeps 64 kB that no limit of memory counts.
constexpr std::size_t kMostOpen = 256;

// RLIMIT_DATA counts neither memory that can only be read, which costs the kernel a table of 4 kB for each 2 MB that are looked
// into, nor a stack, which may be without end (ulimit -s). Addresses that a library keeps for its threads are far fewer.
constexpr std::size_t kMoreAddresses = std::size_t{64} << 30, kStack = std::size_t{8} << 20;

// True: nothing can be won by a program that has more rights than this one.
bool begin(pid_t parent, const CageLimits& limits) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(1);  // it ended before it was listened to
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, 0);
    limit(RLIMIT_DATA, limits.memory);
    limit(RLIMIT_AS, std::max(limits.memory, limits.memory + kMoreAddresses));
    limit(RLIMIT_STACK, kStack);
    limit(RLIMIT_RTPRIO, 0);
    limit(RLIMIT_CPU, limits.processor_seconds);
    limit(RLIMIT_NOFILE, kMostOpen);
    return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0;
}

}  // namespace

void shut_in(int readable, pid_t parent, const CageLimits& limits) {
    if (!begin(parent, limits)) return;
    const FileRules files;
    files.read(readable);
    files.hold();
    end_after(limits.seconds);
    allow_few_calls();
}

void shut_in_program(std::span<const std::string> readable, pid_t parent, const CageLimits& limits) {
    if (!begin(parent, limits)) return;
    const FileRules files;
    files.read(STDIN_FILENO);
    for (const std::string& path : readable) files.use(path.c_str());
    files.hold();
    alarm(limits.seconds);  // it can be put off; who started it watches the clock, too
    refuse_many_calls();
}

}  // namespace tactics
