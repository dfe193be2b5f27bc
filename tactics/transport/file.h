// SPDX-License-Identifier: Apache-2.0
// The door to files: a file appears whole or not at all.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace tactics {

/// Throws as write_file does where a new file of that name has no folder or no permission: before long work, whose end would be
/// lost.
void check_folder_of(const std::string& path);

/// Writes all of `bytes` to `path`.
/// - A file is written without a name in its folder and takes its name when it is whole; until then the old one stays.
///   It always gets a new time, even if nothing in it changed, as make needs it.
/// - An existing file keeps its permission bits, and its owner if we may set it; a new one gets what umask leaves of
///   rw-rw-rw-. A file that we may not write is not replaced, even where the folder would allow it. Its other hard
///   links keep the old content.
/// - Of a symbolic link the target is written, so that a link to where pages are kept stays one.
/// - "-" and /dev/stdout are standard output; devices and pipes are written straight. If the reader of a pipe has gone
///   (`tactics ... | head`), that is not an error: it has what it wanted. SIGPIPE and SIGXFSZ do not reach the program.
/// - When it is done the file and its name are on the disk (fsync of both), as far as the disk tells the truth.
/// Throws Error(failed) with the path; what was there before is then still there, and nothing else. Thread-safe.
void write_file(const std::string& path, std::string_view bytes);

struct NewFile {
    std::string path;
    std::string_view bytes;
};

/// The same for files that belong together: all are written whole before the first takes its name. Standard output,
/// devices and pipes come in between. The first takes its name last: where it is, the others are. Should it be the taking of a
/// name that fails (a file that is mounted there), those that replaced a file stay.
void write_files(const std::vector<NewFile>& files);

enum class Keep {
    on_disk,   ///< finished files are safely on the disk, whatever happens to the machine
    by_system  ///< when the system comes to it: some ms a file quicker
};

/// The same one after another, so that the bytes of all are never needed at once; only some descriptors are open.
class NewFiles {
public:
    explicit NewFiles(Keep keep = Keep::on_disk);
    ~NewFiles();  ///< without take_names() there is nothing
    NewFiles(const NewFiles&) = delete;
    NewFiles& operator=(const NewFiles&) = delete;
    void add(const std::string& path, std::string_view bytes);
    void take_names();  ///< once, after all

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

/// Flushes an open file to the disk, as far as its file system stores anything. Returns 0 or errno.
int keep_open(int descriptor);
/// Flushes the names in a folder to the disk; for a new folder, flush the folder that contains it. Returns 0 or errno.
int keep_folder(const std::string& folder);

/// Where a file system knows no files without a name (network and FAT file systems), and where files are very many, unfinished
/// ones have a name of unfinished.h. This removes all of them, for a program that ends while other threads still write: their
/// write_file fails, and what was there before stays. Not for a signal handler. Thread-safe.
void remove_unfinished_files();

}  // namespace tactics
