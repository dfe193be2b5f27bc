// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/read.h"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>
#include <vector>

#include "tactics/error.h"
#include "tactics/readers/lookalike.h"
#include "tactics/transport/temporary_file.h"

namespace tactics {

#define READER(name) extern const Reader name##_reader;
#include "tactics/readers/list.inc"
#undef READER

std::span<const Reader* const> readers() {
    static const Reader* const kReaders[] = {
#define READER(name) &name##_reader,
#include "tactics/readers/list.inc"
#undef READER
    };
    return kReaders;
}

namespace {

constexpr std::size_t kHeadBytes = 64;
constexpr std::size_t kBufferBytes = 256 * 1024;  // libjpeg reads 4 KiB at a time; without this each is a system call

// Not strerror: it is not safe in threads.
std::string reason() { return std::generic_category().message(errno); }

[[noreturn]] void fail(const std::string& name, const Phrase& message) { throw Error(Fault::failed, name, message); }

[[noreturn]] void fail_empty(const std::string& name) { fail(name, phrase("is empty; get a complete copy of it")); }

[[noreturn]] void fail_large(const std::string& name) {
    fail(name, phrase("is larger than {0} GiB; make the picture smaller first", std::to_string(kMaxInputBytes >> 30)));
}

// Names the nearest file there: mostly a slip of the keyboard.
[[noreturn]] void fail_missing(const std::string& path) {
    namespace fs = std::filesystem;
    constexpr int kMostNames = 10'000;
    const fs::path whole(path);
    const fs::path folder = whole.has_parent_path() ? whole.parent_path() : fs::path(".");
    std::error_code fault;
    if (!fs::is_directory(folder, fault)) fail(path, phrase("there is no folder {0}; check how it is spelled", folder.string()));
    std::vector<std::string> files;
    for (fs::directory_iterator at(folder, fault), end; !fault && at != end && files.size() < kMostNames; at.increment(fault)) {
        std::error_code unknown;
        if (!at->is_directory(unknown)) files.push_back(at->path().filename().string());
    }
    std::sort(files.begin(), files.end());  // folders list their files in any order
    const std::string near = did_you_mean(whole.filename().string(), {files.begin(), files.end()});
    fail(path, near.empty() ? phrase("there is no such file; see what is there with: ls {0}", folder.string())
                            : phrase("there is no such file{0}", near));
}

// A pipe can be read once, and pictures are read in any order.
Source spool(std::FILE* from, const std::string& name) {
    Source source{name, temporary_file()};
    if (source.file == nullptr)
        fail(name, phrase("cannot be kept in a temporary file: {0}; {1}", reason(), temporary_file_cure()));
    std::vector<char> buffer(kBufferBytes);
    long long total = 0;
    while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), from)) {
        total += static_cast<long long>(count);
        if (total > kMaxInputBytes) fail_large(name);
        if (std::fwrite(buffer.data(), 1, count, source.file.get()) != count)
            fail(name, phrase("cannot be kept in a temporary file: {0}; {1}", reason(), temporary_file_cure()));
    }
    if (std::ferror(from) != 0) fail(name, phrase("cannot be read: {0}", reason()));
    if (total == 0) fail_empty(name);
    if (std::fflush(source.file.get()) != 0)
        fail(name, phrase("cannot be kept in a temporary file: {0}; {1}", reason(), temporary_file_cure()));
    std::rewind(source.file.get());
    return source;
}

std::vector<unsigned char> head_of(Source& source, std::size_t size) {
    std::vector<unsigned char> head(size);
    std::rewind(source.file.get());
    head.resize(std::fread(head.data(), 1, size, source.file.get()));
    if (std::ferror(source.file.get()) != 0) fail(source.name, phrase("cannot be read: {0}", reason()));
    std::rewind(source.file.get());
    return head;
}

const Reader& reader_of(Source& source) {
    if (source.file == nullptr) fail_empty(source.name);
    const auto head = head_of(source, kHeadBytes);
    if (head.empty()) fail_empty(source.name);
    for (const Reader* reader : readers())
        if (reader->recognises(head)) return *reader;
    fail(source.name, lookalike(head_of(source, kLookBytes)));
}

}  // namespace

Source open_source(const std::string& path) {
    if (path == "-") return spool(stdin, "standard input");
    Source source{path, {std::fopen(path.c_str(), "rbe"), &std::fclose}};
    if (source.file == nullptr) {
        if (errno == ENOENT) fail_missing(path);
        if (errno == EACCES) fail(path, phrase("may not be read; change its permissions or copy it"));
        fail(path, phrase("cannot be opened: {0}", reason()));
    }
    struct stat facts {};
    if (fstat(fileno(source.file.get()), &facts) != 0) fail(path, phrase("cannot be examined: {0}", reason()));
    if (S_ISDIR(facts.st_mode)) fail(path, phrase("is a folder; name the pictures in it"));
    if (S_ISFIFO(facts.st_mode) || S_ISSOCK(facts.st_mode)) return spool(source.file.get(), path);
    if (!S_ISREG(facts.st_mode)) fail(path, phrase("is a device, not a file"));
    if (facts.st_size == 0) fail_empty(path);
    if (facts.st_size > kMaxInputBytes) fail_large(path);
    std::setvbuf(source.file.get(), nullptr, _IOFBF, kBufferBytes);
    return source;
}

Source memory_source(std::span<const unsigned char> bytes, std::string name) {
    Source source{std::move(name), {nullptr, &std::fclose}};
    if (bytes.empty()) return source;
    // fmemopen takes a writable buffer; in mode "r" it never writes.
    source.file.reset(fmemopen(const_cast<unsigned char*>(bytes.data()), bytes.size(), "rb"));
    if (source.file == nullptr) fail(source.name, phrase("cannot be opened in memory: {0}", reason()));
    return source;
}

PictureInfo inspect_picture(Source& source) { return reader_of(source).inspect(source); }

Image read_picture(Source& source, const ReadRequest& request) { return reader_of(source).read(source, request); }

}  // namespace tactics
