// SPDX-License-Identifier: Apache-2.0
// What the only program of a virtual machine needs: its file systems, its modules, rows.
#pragma once

#include <fcntl.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <string>
#include <string_view>
#include <thread>

namespace tactics::tests {

inline void put(const std::string& path, std::string_view text) {
    const int file = open(path.c_str(), O_WRONLY);
    if (file < 0 || write(file, text.data(), text.size()) < 0)
        std::printf("cannot write %s: %s\n", path.c_str(), std::strerror(errno));
    if (file >= 0) close(file);
}

inline void rest(int ms) { std::this_thread::sleep_for(std::chrono::milliseconds(ms)); }

/// The modules that machine.sh put there, in their order.
inline void set_up_guest() {
    for (const char* folder : {"/proc", "/sys", "/dev", "/config"}) mkdir(folder, 0755);
    mount("proc", "/proc", "proc", 0, nullptr);
    mount("sysfs", "/sys", "sysfs", 0, nullptr);
    mount("devtmpfs", "/dev", "devtmpfs", 0, nullptr);
    std::ifstream list("/modules/list");
    for (std::string module; std::getline(list, module);) {
        const int file = open(("/modules/" + module + ".ko").c_str(), O_RDONLY);
        if (file < 0 || syscall(SYS_finit_module, file, "", 0) != 0)
            std::printf("cannot load %s: %s\n", module.c_str(), std::strerror(errno));
        if (file >= 0) close(file);
    }
    mount("configfs", "/config", "configfs", 0, nullptr);
}

inline bool is_there(const char* path, bool there = true) {
    for (int i = 0; i < 50 && (access(path, F_OK) == 0) != there; ++i) rest(20);
    return access(path, F_OK) == 0;
}

inline void row(const char* what, bool good) { std::printf("| %s | %s |\n", what, good ? "good" : "BAD"); }

/// A gadget of one HID function, which is not yet on the bus.
inline void make_hid_gadget(const std::string& folder, const char* product, const char* name, std::size_t report,
                            std::string_view descriptor) {
    const std::string function = folder + "/functions/hid.0";
    for (const std::string part : {"", "/strings/0x409", "/configs/c.1", "/functions/hid.0"})
        mkdir((folder + part).c_str(), 0755);
    put(folder + "/idVendor", "0x1209");
    put(folder + "/idProduct", product);
    put(folder + "/strings/0x409/product", name);
    put(function + "/report_length", std::to_string(report));
    put(function + "/report_desc", descriptor);
    if (symlink(function.c_str(), (folder + "/configs/c.1/hid.0").c_str()) != 0) std::printf("no gadget\n");
}

}  // namespace tactics::tests
