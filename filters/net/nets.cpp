// SPDX-License-Identifier: Apache-2.0
#include "filters/net/nets.h"

#include <sys/stat.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "tactics/error.h"
#include "tactics/transport/program_folder.h"

namespace tactics {

namespace {

constexpr std::string_view kFile = "bsds500.net";
constexpr std::size_t kMostBytes = 1 << 20;

bool is_there(const std::string& path) {
    struct stat about {};
    return stat(path.c_str(), &about) == 0;
}

std::string read(const std::string& path) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
    std::string bytes(kMostBytes + 1, '\0');
    if (file != nullptr) bytes.resize(std::fread(bytes.data(), 1, bytes.size(), file.get()));
    if (file == nullptr || std::ferror(file.get()) != 0)
        throw Error(Fault::failed, path, phrase("the contour net cannot be read (let it be read, or delete it to do without)"));
    if (bytes.size() > kMostBytes) throw Error(Fault::failed, path, phrase("is no contour net (install program and nets again)"));
    return bytes;
}

}  // namespace

std::shared_ptr<const ContourNet> find_net_in(std::span<const std::string> folders) {
    for (const std::string& folder : folders) {
        if (folder.empty()) continue;
        const std::string path = folder + "/" + std::string(kFile);
        if (is_there(path)) return std::make_shared<const ContourNet>(ContourNet::from_bytes(read(path), path));
    }
    return nullptr;
}

std::shared_ptr<const ContourNet> find_net() {
    static const std::shared_ptr<const ContourNet> kNet = [] {
        std::vector<std::string> folders;
        if (const char* named = std::getenv("TACTICS_NETS"); named != nullptr) folders.emplace_back(named);
        // A build folder has them beside the program; what was installed may have been moved as a whole.
        if (const std::string program = folder_of_program(); !program.empty()) {
            folders.push_back(program + "/nets");
            folders.push_back(program + "/../share/tactics/nets");
        }
        if (const std::string library = folder_of_library(); !library.empty()) {  // in a program that is not ours
            folders.push_back(library + "/nets");
            folders.push_back(library + "/" TACTICS_NETS_FROM_LIBRARY);
        }
        folders.insert(folders.end(), {TACTICS_NET_DIR, "/usr/local/share/tactics/nets", "/usr/share/tactics/nets"});
        return find_net_in(folders);
    }();
    return kNet;
}

}  // namespace tactics
