// A program that is run among devices of umockdev, to its end.
#pragma once

#include <sys/wait.h>
#include <umockdev.h>

#include <cstdio>
#include <string>

namespace tactics::tests {

constexpr int kNoMock = 99;

inline int no_mock(const GError* error) {
    std::fprintf(stderr, "no pretended device: %s\n", error != nullptr ? error->message : "?");
    return kNoMock;
}

/// `device` is in the testbed, which goes when it has ended; `asked` and, if there is one, `written` answer for it. The exit code.
inline int run_beside(UMockdevTestbed* testbed, const char* device, GCallback asked, GCallback written, gpointer machine, char** words) {
    struct Run {
        GMainLoop* loop = nullptr;
        int status = 0;
    } run{g_main_loop_new(nullptr, FALSE)};
    GError* error = nullptr;
    UMockdevIoctlBase* base = umockdev_ioctl_base_new();
    g_signal_connect(base, "handle-ioctl", asked, machine);
    if (written != nullptr) g_signal_connect(base, "handle-write", written, machine);
    if (!umockdev_testbed_attach_ioctl(testbed, device, base, &error)) return no_mock(error);
    GPid child = 0;
    const auto flags = static_cast<GSpawnFlags>(G_SPAWN_DO_NOT_REAP_CHILD | G_SPAWN_SEARCH_PATH | G_SPAWN_CHILD_INHERITS_STDIN);
    if (!g_spawn_async(nullptr, words, nullptr, flags, nullptr, nullptr, &child, &error)) return no_mock(error);
    const auto ended = [](GPid, gint status, gpointer told) {
        static_cast<Run*>(told)->status = status;
        g_main_loop_quit(static_cast<Run*>(told)->loop);
    };
    g_child_watch_add(child, ended, &run);
    g_main_loop_run(run.loop);
    g_object_unref(testbed);
    return WIFEXITED(run.status) ? WEXITSTATUS(run.status) : 128 + WTERMSIG(run.status);
}

}  // namespace tactics::tests
