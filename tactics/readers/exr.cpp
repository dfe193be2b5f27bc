// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/exr.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <memory>

#include "tactics/error.h"
#include "tactics/readers/caged_answer.h"

namespace tactics {

namespace {

[[noreturn]] void fail(const Phrase& why) {
    throw Error(Fault::failed, "EXR", phrase("could not be written: {0}; write .tif instead", why));
}

void put(std::FILE* file, const void* bytes, std::size_t size) {
    if (std::fwrite(bytes, 1, size, file) != size) fail(std::strerror(errno));
}

}  // namespace

std::string write_exr(int width, int height, const std::vector<std::pair<std::string_view, std::string>>& words,
                      const std::function<void(int row, std::span<float> samples)>& rows) {
    const int memory = memfd_create("samples", MFD_CLOEXEC);
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> plan(memory < 0 ? nullptr : fdopen(memory, "w"), &std::fclose);
    if (plan == nullptr) fail(std::strerror(errno));
    const caged::WritingPlan size{width, height};
    put(plan.get(), &size, sizeof size);
    std::vector<float> row(static_cast<std::size_t>(width));
    for (int y = 0; y < height; ++y) {
        rows(y, row);
        put(plan.get(), row.data(), row.size() * sizeof(float));
    }
    if (std::fflush(plan.get()) != 0) fail(std::strerror(errno));
    CagedRequest request{"write", "openexr", {}, memory};
    for (const auto& [name, text] : words) {
        request.rest.emplace_back(name);
        request.rest.push_back(text);
    }
    CagedAnswer answer("EXR", request);
    std::string file;
    const std::size_t most = row.size() * static_cast<std::size_t>(height) * sizeof(float) * 2 + (std::size_t{1} << 20);
    if (!answer.read(caged::Frame::file, file, most)) fail(answer.why());
    return file;
}

}  // namespace tactics
