// SPDX-License-Identifier: Apache-2.0
#include "tactics/transport/shared_library.h"

#include <dlfcn.h>

#include "tactics/error.h"

namespace tactics {

SharedLibrary::SharedLibrary(std::span<const std::string> names, std::string place, std::string advice)
    : place_(std::move(place)), advice_(std::move(advice)) {
    std::string why;
    for (const std::string& name : names) {
        handle_ = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);
        if (handle_ != nullptr) return;
        const char* fault = dlerror();
        if (why.empty() && fault != nullptr) why = fault;
    }
    throw Error(Fault::failed, place_, why.empty() ? Phrase(advice_) : phrase("{0} ({1})", advice_, why));
}

void* SharedLibrary::symbol(const char* name) const {
    void* found = dlsym(handle_, name);
    if (found == nullptr) throw Error(Fault::failed, place_, phrase("the library has no {0}; {1}", name, advice_));
    return found;
}

}  // namespace tactics
