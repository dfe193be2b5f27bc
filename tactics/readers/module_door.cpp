// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/module_door.h"

#include <dlfcn.h>
#include <unistd.h>

#include <string>

#include "tactics/error.h"
#include "tactics/transport/program_folder.h"

namespace tactics {

namespace {

struct Module {
    const TacticsOiio* functions = nullptr;
    std::string why;
};

Module load() {
    Module module;
    // Beside the program, as in a build folder, or where it is installed.
    const std::string program = folder_of_program();
    for (const std::string& folder : {program, program + "/" TACTICS_MODULES}) {
        const std::string path = folder + "/tactics-openimageio.so";
        if (program.empty() || access(path.c_str(), R_OK) != 0) continue;
        // Never closed: OpenImageIO's own threads and tables live until the end.
        void* handle = dlopen(path.c_str(), RTLD_LAZY | RTLD_LOCAL);
        if (handle == nullptr) {
            const char* error = dlerror();
            module.why = "the OpenImageIO module cannot be loaded (" + std::string(error != nullptr ? error : path) +
                         "); install OpenImageIO again, or convert the picture to PNG first";
            continue;
        }
        using Entry = decltype(&tactics_oiio_2);
        const auto entry = reinterpret_cast<Entry>(dlsym(handle, "tactics_oiio_2"));
        if (entry != nullptr) return {entry(), {}};
        module.why = path + " is of another version; install program and module together";
    }
    if (module.why.empty())
        module.why =
            "needs the OpenImageIO module, which is not installed; install tactics-openimageio.so, or convert to PNG first";
    return module;
}

}  // namespace

// Opened once for the process, by the first thread that needs it.
const TacticsOiio& openimageio_module(const std::string& place) {
    static const Module kModule = load();
    if (kModule.functions == nullptr) throw Error(Fault::failed, place, kModule.why);
    return *kModule.functions;
}

}  // namespace tactics
