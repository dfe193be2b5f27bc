// SPDX-License-Identifier: Apache-2.0
// An optional library: opened on demand, and never linked.
#pragma once

#include <span>
#include <string>

namespace tactics {

class SharedLibrary {
public:
    /// Opens the first of these names or paths that the system finds; it stays open until the program ends, because libraries
    /// have threads. Throws Error(failed) at `place` if none exists, with `advice` on where to get it, or with the loader's
    /// message.
    SharedLibrary(std::span<const std::string> names, std::string place, std::string advice);

    /// Throws Error(failed): it has none of that name.
    template <typename Function>
    void find(Function& function, const char* name) const {
        function = reinterpret_cast<Function>(symbol(name));
    }

private:
    void* symbol(const char* name) const;

    void* handle_ = nullptr;
    std::string place_, advice_;
};

}  // namespace tactics
