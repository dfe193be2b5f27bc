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
#include <sys/stat.h>
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

// All rights that Linux 5.13 knows: none is given for writing. A rule may name a file as well as a folder (landlock(7)).
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

// A program of the kernel's packet filter over struct seccomp_data (seccomp(2)): a call that is refused fails with EPERM, as it
// would for lack of rights, and the library goes on or gives up by itself.
constexpr std::uint32_t kAllow = SECCOMP_RET_ALLOW, kRefuse = SECCOMP_RET_ERRNO | EPERM;
constexpr std::uint16_t kEqual = BPF_JMP | BPF_JEQ | BPF_K, kAnyBit = BPF_JMP | BPF_JSET | BPF_K;

class CallRules {
public:
    CallRules() {
        load(offsetof(seccomp_data, arch));
        put(kEqual, kMachine, 1, 0);
        end(SECCOMP_RET_KILL_PROCESS);
        load(offsetof(seccomp_data, nr));
    }
    void on(std::uint32_t call, std::uint32_t verdict) {
        put(kEqual, call, 0, 1);
        end(verdict);
    }
    // The low half of an argument decides: these are numbers of 32 bits.
    void on_bits(std::uint32_t call, unsigned argument, std::uint32_t bits, std::uint32_t if_any, std::uint32_t if_none) {
        on_argument(call, argument, kAnyBit, bits, if_any, if_none);
    }
    void on_value(std::uint32_t call, unsigned argument, std::uint32_t value, std::uint32_t if_so, std::uint32_t if_not) {
        on_argument(call, argument, kEqual, value, if_so, if_not);
    }
    void unless_null(std::uint32_t call, unsigned argument, std::uint32_t verdict) {
        put(kEqual, call, 0, 6);
        load(offsetof(seccomp_data, args) + 8 * argument);
        put(kEqual, 0, 0, 3);
        load(offsetof(seccomp_data, args) + 8 * argument + 4);
        put(kEqual, 0, 0, 1);
        end(kAllow);
        end(verdict);
    }
    void end(std::uint32_t verdict) { put(BPF_RET | BPF_K, verdict); }
    // Threads, no processes. The flags of clone3 lie in memory, where a filter cannot see them. Without it the C library takes
    // clone.
    void threads_only() {
        on(SYS_clone3, SECCOMP_RET_ERRNO | ENOSYS);
        on_bits(SYS_clone, 0, CLONE_THREAD, kAllow, kRefuse);
    }
    void open_to_read_only() {
        constexpr std::uint32_t kWriting = O_WRONLY | O_RDWR | O_CREAT | O_TRUNC;
        on_bits(SYS_openat, 2, kWriting, kRefuse, kAllow);
#ifdef SYS_open
        on_bits(SYS_open, 1, kWriting, kRefuse, kAllow);
#endif
    }
    void hold() const {
        const sock_fprog program{static_cast<unsigned short>(used_), const_cast<sock_filter*>(code_.data())};
        prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program, 0, 0);
    }
    void put(std::uint16_t what, std::uint32_t value, std::uint8_t if_so = 0, std::uint8_t if_not = 0) {
        code_[used_++] = {what, if_so, if_not, value};
    }

private:
    void load(std::size_t at) { put(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(at)); }
    void on_argument(std::uint32_t call, unsigned argument, std::uint16_t test, std::uint32_t value, std::uint32_t if_so,
                     std::uint32_t if_not) {
        put(kEqual, call, 0, 4);
        load(offsetof(seccomp_data, args) + 8 * argument);
        put(test, value, 0, 1);
        end(if_so);
        end(if_not);
    }
    std::array<sock_filter, 512> code_{};
    std::size_t used_ = 0;
};

void allow_few_calls() {
    if (kMachine == 0) return;
    CallRules rules;
    for (const std::uint32_t call : kAllowed) rules.on(call, kAllow);
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
    SYS_capset,
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
#ifdef SYS_fork
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

void refuse_many_calls() {
    if (kMachine == 0) return;
    CallRules rules;
#if defined(__x86_64__)
    rules.put(BPF_JMP | BPF_JGE | BPF_K, __X32_SYSCALL_BIT, 0, 1);  // the same calls by other numbers
    rules.end(kRefuse);
#endif
    for (const std::uint32_t call : kRefused) rules.on(call, kRefuse);
    rules.threads_only();
    rules.open_to_read_only();
    rules.on(SYS_openat2, SECCOMP_RET_ERRNO | ENOSYS);      // its flags lie in memory, too
    const auto own = static_cast<std::uint32_t>(getpid());  // stays through exec
    rules.on_value(SYS_kill, 0, own, kAllow, kRefuse);
    rules.on_value(SYS_tgkill, 0, own, kAllow, kRefuse);
    rules.on_value(SYS_prctl, 0, PR_SET_PDEATHSIG, kRefuse, kAllow);
    rules.unless_null(SYS_prlimit64, 2, kRefuse);  // limits may be asked for, not set
    rules.end(kAllow);
    rules.hold();
}

// True: nothing can be won by a program that has more rights than this one.
bool begin(pid_t parent, const CageLimits& limits) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(1);  // it ended before it was listened to
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, 0);
    limit(RLIMIT_DATA, limits.memory);
    limit(RLIMIT_CPU, limits.processor_seconds);
    alarm(limits.seconds);
    return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0;
}

}  // namespace

void shut_in(int readable, pid_t parent, const CageLimits& limits) {
    if (!begin(parent, limits)) return;
    const FileRules files;
    files.read(readable);
    files.hold();
    allow_few_calls();
}

void shut_in_program(std::span<const std::string> readable, pid_t parent, const CageLimits& limits) {
    if (!begin(parent, limits)) return;
    const FileRules files;
    files.read(STDIN_FILENO);
    for (const std::string& path : readable) files.use(path.c_str());
    files.hold();
    refuse_many_calls();
}

}  // namespace tactics
