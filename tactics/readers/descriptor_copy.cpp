// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/descriptor_copy.h"

#include <vector>

namespace tactics {

TemporaryFile with_descriptor(std::FILE* from) {
    TemporaryFile copy = temporary_file();
    std::vector<char> buffer(64 * 1024);
    std::rewind(from);
    while (const std::size_t count = copy != nullptr ? std::fread(buffer.data(), 1, buffer.size(), from) : 0)
        if (std::fwrite(buffer.data(), 1, count, copy.get()) != count) copy.reset();
    if (copy != nullptr && std::fflush(copy.get()) != 0) copy.reset();
    return copy;
}

}  // namespace tactics
