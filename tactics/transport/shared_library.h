// SPDX-License-Identifier: Apache-2.0
// An optional library: opened on demand, and never linked.
#pragma once

#include <span>
#include <string>

namespace tactics {

class SharedLibrary {
public:
    /// The first of these names, or paths, that the system finds; it stays open until the program ends, as libraries have
    /// threads. Throws Error(failed) at `place`: none is there, and `advice` says where to get it; or what its loader says.
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
