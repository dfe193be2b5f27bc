// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/terminal_keys.h"

#include <poll.h>
#include <signal.h>
#include <termios.h>
#include <unistd.h>

#include <cctype>
#include <cerrno>
#include <iterator>

namespace tactics {

namespace {

// State of the one terminal, for a signal handler.
termios before, single;
volatile sig_atomic_t changed = 0, ending = 0;
// Those that end or stop a program and are not counted by the play (interrupt_count.h).
constexpr int kEnding[] = {SIGQUIT, SIGTSTP, SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL};
struct sigaction kept[std::size(kEnding)];

bool in_foreground() noexcept { return tcgetpgrp(STDIN_FILENO) == getpgrp(); }

void set_single() noexcept {
    if (in_foreground() && tcsetattr(STDIN_FILENO, TCSANOW, &single) == 0) changed = 1;
}

// In the background it would stop the program, and the shell has done it.
void set_back() noexcept {
    if (changed != 0 && in_foreground()) tcsetattr(STDIN_FILENO, TCSANOW, &before);
    changed = 0;
}

// Once the terminal is as it was, the signal does what it did without us.
void on_ending(int number) {
    const int fault = errno;
    ending = 1;
    set_back();
    struct sigaction ours {};
    for (std::size_t i = 0; i < std::size(kEnding); ++i)
        if (kEnding[i] == number) sigaction(number, &kept[i], &ours);
    sigset_t one;
    sigemptyset(&one);
    sigaddset(&one, number);
    raise(number);
    pthread_sigmask(SIG_UNBLOCK, &one, nullptr);  // here it ends, or stops until it is told to go on
    sigaction(number, &ours, nullptr);
    ending = 0;
    set_single();
    errno = fault;
}

void keep_signals() {
    struct sigaction action {};
    action.sa_handler = on_ending;
    action.sa_flags = SA_RESTART;
    for (std::size_t i = 0; i < std::size(kEnding); ++i) sigaction(kEnding[i], &action, &kept[i]);
}

void give_signals_back() {
    for (std::size_t i = 0; i < std::size(kEnding); ++i) sigaction(kEnding[i], &kept[i], nullptr);
}

void press(char key, TypedKeys& typed) {
    const auto keys = plot_keys();
    for (std::size_t i = 0; i < keys.size(); ++i)
        if ((i < kNumberedKeys && key == static_cast<char>('1' + i)) ||
            (keys[i].letter != 0 && std::tolower(static_cast<unsigned char>(key)) == keys[i].letter))
            typed.press(i);
}

}  // namespace

TerminalKeys::TerminalKeys(TypedKeys& typed) {
    if (isatty(STDIN_FILENO) == 0 || !in_foreground() || tcgetattr(STDIN_FILENO, &before) != 0) return;
    single = before;
    single.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
    single.c_cc[VMIN] = 1;
    single.c_cc[VTIME] = 0;
    keep_signals();
    set_single();
    // Signals are for the thread that plays.
    sigset_t all, mask;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &mask);
    reader_ = std::thread([this, &typed] { read_keys(typed); });
    pthread_sigmask(SIG_SETMASK, &mask, nullptr);
}

TerminalKeys::~TerminalKeys() {
    if (!reader_.joinable()) return;
    over_ = true;
    reader_.join();
    give_signals_back();
    set_back();
}

void TerminalKeys::read_keys(TypedKeys& typed) {
    constexpr int kWait = 50;  // ms
    while (!over_) {
        // Reading in the background would stop the program, and there is no notice when it comes to the foreground again.
        const bool here = in_foreground();
        if (here && changed == 0 && ending == 0) set_single();
        pollfd terminal{STDIN_FILENO, POLLIN, 0};
        if (poll(here ? &terminal : nullptr, here ? 1 : 0, kWait) <= 0 || !in_foreground()) continue;
        char keys[64];
        const ssize_t count = read(STDIN_FILENO, keys, sizeof keys);
        if (count <= 0) return;  // the terminal has gone
        for (ssize_t i = 0; i < count; ++i) press(keys[i], typed);
    }
}

}  // namespace tactics
