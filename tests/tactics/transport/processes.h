// SPDX-License-Identifier: Apache-2.0
// Which processes there are, to see that none stays.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

namespace tactics::tests {

struct Process {
    pid_t id = 0, parent = 0;
    std::string name;
};

/// Those that still run: one that ended and was not asked for is gone.
inline std::vector<Process> processes() {
    std::vector<Process> all;
    for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
        const std::string number = entry.path().filename().string();
        if (number.find_first_not_of("0123456789") != std::string::npos) continue;
        std::ifstream file(entry.path() / "stat");  // id (name) state parent ...
        std::string text;
        std::getline(file, text);
        const auto begin = text.find('('), end = text.rfind(')');
        if (begin == std::string::npos || end == std::string::npos) continue;
        Process process;
        char state = 0;
        process.id = std::stoi(text);
        process.name = text.substr(begin + 1, end - begin - 1);
        std::istringstream(text.substr(end + 1)) >> state >> process.parent;
        if (state != 'Z' && state != 'X') all.push_back(process);
    }
    return all;
}

/// Waits until `parent` has a child of that name, as the kernel cuts it (15 letters); 0: there was none in half a minute.
inline pid_t wait_for_child(pid_t parent, const std::string& name) {
    for (int i = 0; i < 3000; ++i) {
        for (const Process& process : processes())
            if (process.parent == parent && process.name == name) return process.id;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return 0;
}

/// Waits until that process runs no more; false: it still does after half a minute.
inline bool wait_until_gone(pid_t id) {
    for (int i = 0; i < 3000; ++i) {
        bool runs = false;
        for (const Process& process : processes()) runs = runs || process.id == id;
        if (!runs) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
}

}  // namespace tactics::tests
