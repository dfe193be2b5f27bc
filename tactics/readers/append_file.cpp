// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/append_file.h"

#include <cerrno>
#include <cstring>

#include "tactics/error.h"
#include "tactics/readers/read.h"

namespace tactics {

void append_file(std::string& bytes, const std::string& name) {
    constexpr std::size_t kMost = 256u << 20;
    const Source source = open_source(name);
    char block[1 << 16];
    while (const std::size_t count = std::fread(block, 1, sizeof block, source.file.get())) {
        bytes.append(block, count);
        if (bytes.size() > kMost)
            throw Error(Fault::failed, name, phrase("is over 256 MB with what stands before it; take fewer files at a time"));
    }
    if (std::ferror(source.file.get()) != 0)
        throw Error(Fault::failed, name, phrase("cannot be read to its end: {0}; get a fresh copy of it", std::strerror(errno)));
}

}  // namespace tactics
