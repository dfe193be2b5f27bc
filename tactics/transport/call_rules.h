// SPDX-License-Identifier: Apache-2.0
// Which calls a process may make of the kernel from now on, and with which arguments: a program for its packet filter
// (seccomp(2)).
#pragma once

#include <errno.h>
#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>

namespace tactics {

#if defined(__x86_64__)
constexpr std::uint32_t kMachine = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t kMachine = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t kMachine = 0;  // calls are not examined
#endif

// A program of the kernel's packet filter over struct seccomp_data (seccomp(2)): a call that is refused fails with EPERM, as it
// would for lack of rights, and the library continues or gives up on its own.
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
    void on_value_else_go_on(std::uint32_t call, unsigned argument, std::uint32_t value, std::uint32_t if_so) {
        put(kEqual, call, 0, 4);
        load(offsetof(seccomp_data, args) + 8 * argument);
        put(kEqual, value, 0, 1);
        end(if_so);
        load(offsetof(seccomp_data, nr));
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
    // Dangerous uses of fcntl: making a descriptor send signals, even SIGKILL, to any process of the same user; making a pipe
    // hold a megabyte while it is open, which no memory limit counts; making others wait for a file (locks, leases; F_SETDELEG of
    // Linux 6.19).
    void descriptors_as_they_are() {
        for (const std::uint32_t order : {F_DUPFD, F_DUPFD_CLOEXEC, F_GETFD, F_SETFD, F_GETFL, F_SETFL})
            on_value_else_go_on(SYS_fcntl, 1, order, kAllow);
        on(SYS_fcntl, kRefuse);
    }
    // RLIMIT_DATA counts private mappings that do not grow automatically (mm/mmap.c, is_data_mapping); other mappings would have
    // no limit.
    void memory_that_counts() {
        constexpr std::uint32_t kShared = MAP_ANONYMOUS | MAP_SHARED;
        put(kEqual, SYS_mmap, 0, 6);
        load(offsetof(seccomp_data, args) + 8 * 3);
        put(kAnyBit, MAP_GROWSDOWN, 2, 0);
        put(BPF_ALU | BPF_AND | BPF_K, kShared);
        put(kEqual, kShared, 0, 1);
        end(SECCOMP_RET_ERRNO | ENOMEM);
        end(kAllow);
    }
    // Signals go to this process alone; its number stays through exec.
    void signals_to_itself(std::initializer_list<std::uint32_t> calls) {
        const auto own = static_cast<std::uint32_t>(getpid());
        for (const std::uint32_t call : calls) on_value(call, 0, own, kAllow, kRefuse);
    }
    // Threads, no processes, and none with a network, mounts or names of its own, as root may have. The flags of clone3 lie in
    // memory, where a filter cannot see them. Without it the C library takes clone.
    void threads_only() {
        constexpr std::uint32_t kApart =
            CLONE_NEWNS | CLONE_NEWCGROUP | CLONE_NEWUTS | CLONE_NEWIPC | CLONE_NEWUSER | CLONE_NEWPID | CLONE_NEWNET;
        on(SYS_clone3, SECCOMP_RET_ERRNO | ENOSYS);
        put(kEqual, SYS_clone, 0, 5);
        load(offsetof(seccomp_data, args));
        put(BPF_ALU | BPF_AND | BPF_K, CLONE_THREAD | kApart);
        put(kEqual, CLONE_THREAD, 0, 1);
        end(kAllow);
        end(kRefuse);
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

}  // namespace tactics
