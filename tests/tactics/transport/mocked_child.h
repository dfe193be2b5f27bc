// SPDX-License-Identifier: Apache-2.0
// A program that is run among devices of umockdev, to its end.
#pragma once

#include <linux/hidraw.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <umockdev.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <span>
#include <string>

namespace tactics::tests {

constexpr int kNoMock = 99;

inline int no_mock(const GError* error) {
    std::fprintf(stderr, "no pretended device: %s\n", error != nullptr ? error->message : "?");
    return kNoMock;
}

/// As a testbed takes binary attributes.
inline std::string in_hexadecimal(std::span<const std::uint8_t> bytes) {
    std::string text;
    for (const std::uint8_t byte : bytes) {
        char digits[3];
        std::snprintf(digits, sizeof digits, "%02X", byte);
        text += digits;
    }
    return text;
}

/// What the kernel answers to who opens a hidraw device: nothing but its descriptor is known. Whether that was asked for.
inline bool answer_descriptor(UMockdevIoctlClient* client, std::span<const std::uint8_t> descriptor) {
    const unsigned long request = umockdev_ioctl_client_get_request(client);
    const int size = static_cast<int>(descriptor.size());
    if (request != HIDIOCGRDESCSIZE && request != HIDIOCGRDESC) {
        umockdev_ioctl_client_complete(client, -1, ENOTTY);
        return false;
    }
    UMockdevIoctlData* data = umockdev_ioctl_data_resolve(umockdev_ioctl_client_get_arg(client), 0, _IOC_SIZE(request), nullptr);
    std::memcpy(data->data, &size, sizeof size);
    if (request == HIDIOCGRDESC)
        std::memcpy(data->data + offsetof(hidraw_report_descriptor, value), descriptor.data(), descriptor.size());
    umockdev_ioctl_client_complete(client, 0, 0);
    return true;
}

/// The process that answers for a simulated device.
struct Answers {
    GCallback asked = nullptr, written = nullptr, read = nullptr;  ///< the last two may be missing
    gpointer machine = nullptr;
};

inline bool answer_for(UMockdevTestbed* testbed, const char* device, const Answers& answers, GError** error) {
    UMockdevIoctlBase* base = umockdev_ioctl_base_new();
    g_signal_connect(base, "handle-ioctl", answers.asked, answers.machine);
    if (answers.written != nullptr) g_signal_connect(base, "handle-write", answers.written, answers.machine);
    if (answers.read != nullptr) g_signal_connect(base, "handle-read", answers.read, answers.machine);
    return umockdev_testbed_attach_ioctl(testbed, device, base, error);
}

/// `device` is in the testbed, which goes when it has ended. The exit code. `child` is told its number, unless it is null.
inline int run_beside(UMockdevTestbed* testbed, const char* device, const Answers& answers, char** words, GPid* child = nullptr) {
    struct Run {
        GMainLoop* loop = nullptr;
        int status = 0;
    } run{g_main_loop_new(nullptr, FALSE)};
    GError* error = nullptr;
    if (!answer_for(testbed, device, answers, &error)) return no_mock(error);
    GPid id = 0;
    const auto flags = static_cast<GSpawnFlags>(G_SPAWN_DO_NOT_REAP_CHILD | G_SPAWN_SEARCH_PATH | G_SPAWN_CHILD_INHERITS_STDIN);
    if (!g_spawn_async(nullptr, words, nullptr, flags, nullptr, nullptr, &id, &error)) return no_mock(error);
    if (child != nullptr) *child = id;
    const auto ended = [](GPid, gint status, gpointer told) {
        static_cast<Run*>(told)->status = status;
        g_main_loop_quit(static_cast<Run*>(told)->loop);
    };
    g_child_watch_add(id, ended, &run);
    g_main_loop_run(run.loop);
    g_object_unref(testbed);
    return WIFEXITED(run.status) ? WEXITSTATUS(run.status) : 128 + WTERMSIG(run.status);
}

}  // namespace tactics::tests
