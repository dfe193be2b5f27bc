// SPDX-License-Identifier: Apache-2.0
#include "tactics/transport/file.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <cstring>
#include <deque>
#include <memory>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include "tactics/error.h"
#include "tactics/transport/terminal.h"
#include "tactics/transport/unfinished.h"

namespace tactics {

namespace {

class OpenFile {
public:
    explicit OpenFile(int number) : number_(number) {}
    ~OpenFile() { end(); }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;
    int number() const { return number_; }
    void end() {
        if (number_ >= 0) close(number_);
        number_ = -1;
    }

private:
    int number_;
};

// A closed pipe and a file that grows too large raise signals that end the program. Here they must be errors instead, without
// changing how other threads or the program handle signals.
class SignalsAsErrors {
public:
    SignalsAsErrors() {
        sigset_t pending;
        sigemptyset(&ours_);
        sigpending(&pending);
        for (const int signal : {SIGPIPE, SIGXFSZ})
            if (sigismember(&pending, signal) == 0) sigaddset(&ours_, signal);
        pthread_sigmask(SIG_BLOCK, &ours_, &before_);
    }
    ~SignalsAsErrors() {
        const timespec at_once{};
        while (sigtimedwait(&ours_, nullptr, &at_once) > 0 || errno == EINTR) {
        }
        pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    }
    SignalsAsErrors(const SignalsAsErrors&) = delete;
    SignalsAsErrors& operator=(const SignalsAsErrors&) = delete;

private:
    sigset_t ours_{};
    sigset_t before_{};
};

std::string folder_of(const std::string& path) {
    const auto slash = path.rfind('/');
    if (slash == std::string::npos) return ".";
    return slash == 0 ? "/" : path.substr(0, slash);
}

// The user's name for the output, and its place after all symbolic links.
struct Output {
    std::string path;
    std::string end;
};

[[noreturn]] void fail_writing(const Output& output, int reason) {
    const std::string folder = folder_of(output.end);
    struct stat there {};
    // /proc and similar file systems answer in this way to a new file.
    if (reason == ENOENT && stat(folder.c_str(), &there) == 0) reason = EACCES;
    Phrase message;
    switch (reason) {
        case ENOENT: message = phrase("there is no folder {0}; make it first: mkdir -p {0}", folder); break;
        case ENOTDIR: message = phrase("{0} is not a folder; write to another place", folder); break;
        case EISDIR: message = phrase("this is a folder; add the name of a file"); break;
        case EACCES:
        case EPERM:
            message = phrase("no permission to write here; write to a folder of your own, or change the permissions");
            break;
        case EROFS: message = phrase("this file system is read-only; write to another place"); break;
        case ENOSPC:
        case EDQUOT: message = phrase("there is no space left; free some, or write to another disk"); break;
        case EFBIG:
            message =
                phrase("the file would be larger than is allowed here; raise the limit (ulimit -f), or choose a smaller page");
            break;
        case ENAMETOOLONG: message = phrase("the name is too long; choose a shorter one"); break;
        case ELOOP: message = phrase("this symbolic link leads round in a circle; remove it"); break;
        default:
            message = phrase("cannot be written: {0}; write to another place",
                             std::error_code(reason, std::generic_category()).message());
    }
    throw Error(Fault::failed, output.path, message);
}

int open_again(const char* path, int flags, mode_t mode = 0) {
    for (;;) {
        const int number = open(path, flags | O_CLOEXEC, mode);
        if (number >= 0 || errno != EINTR) return number;
    }
}

// 0, or what went wrong. A full buffer of a pipe that does not wait is waited for.
int write_all(int number, std::string_view bytes) {
    constexpr std::size_t kMost = 1u << 30;  // Linux writes at most 2 GiB at once
    while (!bytes.empty()) {
        const ssize_t count = write(number, bytes.data(), std::min(bytes.size(), kMost));
        if (count > 0) {
            bytes.remove_prefix(static_cast<std::size_t>(count));
        } else if (count == 0) {
            return EIO;
        } else if (errno == EAGAIN) {
            pollfd room{number, POLLOUT, 0};
            poll(&room, 1, -1);
        } else if (errno != EINTR) {
            return errno;
        }
    }
    return 0;
}

void write_straight(const Output& output, int number, std::string_view bytes) {
    const int reason = write_all(number, bytes);
    if (reason != 0 && reason != EPIPE) fail_writing(output, reason);
}

// The end of the symbolic links, whether or not a file exists yet.
std::string follow_links(const std::string& path) {
    std::string end = path;
    for (int links = 0; links < 40; ++links) {  // as many as Linux follows
        std::array<char, PATH_MAX> target{};
        const ssize_t size = readlink(end.c_str(), target.data(), target.size());
        if (size <= 0) return end;
        const std::string next(target.data(), static_cast<std::size_t>(size));
        end = next[0] == '/' ? next : folder_of(end) + "/" + next;
    }
    fail_writing({path, path}, ELOOP);
}

constexpr int kTries = 100;  // of names that somebody else has left

// Fills a file that is still without its name; 0 or what went wrong.
int complete(int number, std::string_view bytes, const struct stat* old) {
    if (const int reason = write_all(number, bytes)) return reason;
    if (old != nullptr) {
        if ((old->st_uid != geteuid() || old->st_gid != getegid()) && fchown(number, old->st_uid, old->st_gid) != 0) {
            // Not ours to give away: it becomes ours, as with any other editor.
        }
        if (fchmod(number, old->st_mode & 07777) != 0) return errno;
    }
    // Network file systems tell of a full disk only when a file is closed.
    const int copy = dup(number);
    return copy < 0 || close(copy) != 0 ? errno : 0;
}

// A whole file on its way to its name. Until it has that, it goes away with this.
class Waiting {
public:
    // `old` is the file that it replaces, or nullptr. `kept`: it is on the disk when it is written.
    Waiting(Output output, std::string_view bytes, const struct stat* old, bool kept)
        : output_(std::move(output)),
          old_(old != nullptr ? std::optional(*old) : std::nullopt),
          kept_(kept),
          file_(open_again(folder_of(output_.end).c_str(), O_TMPFILE | O_RDWR, 0666)) {
        if (file_.number() >= 0)
            fill(file_.number(), bytes);
        else if (errno == EOPNOTSUPP || errno == EISDIR || errno == EINVAL || errno == ENOENT)
            write_named(bytes);  // not every file system knows files without a name
        else
            fail_writing(output_, errno);
    }

    // The last that may need room on the disk. A link cannot replace a file, so it gets a name for the moment.
    void name_for_now() {
        if (name_) return;
        const std::string self = "/proc/self/fd/" + std::to_string(file_.number());
        for (int i = 0; i < kTries; ++i) {
            name_.emplace(folder_of(output_.end));
            if (linkat(AT_FDCWD, self.c_str(), AT_FDCWD, name_->text(), AT_SYMLINK_FOLLOW) == 0) {
                name_->exists(true);
                return file_.end();
            }
            if (errno == ENOENT) return copy_named();  // no /proc, or the folder has gone: the other road says which
            if (errno != EEXIST) fail_writing(output_, errno);
        }
        fail_writing(output_, EEXIST);
    }

    void take_name() {
        if (rename(name_->text(), output_.end.c_str()) != 0) fail_writing(output_, errno);
        name_->exists(false);
    }

    // After take_name: as it was before, unless a file was replaced.
    void withdraw() const {
        if (!old_) unlink(output_.end.c_str());
    }

    std::string folder() const { return folder_of(output_.end); }
    const Output& output() const { return output_; }

private:
    void fill(int number, std::string_view bytes) const {
        if (const int reason = complete(number, bytes, old_ ? &*old_ : nullptr)) fail_writing(output_, reason);
        if (!kept_) return;
        if (const int reason = keep_open(number)) fail_writing(output_, reason);
    }

    void copy_named() {
        struct stat whole {};
        if (fstat(file_.number(), &whole) != 0) fail_writing(output_, errno);
        std::string bytes(static_cast<std::size_t>(whole.st_size), '\0');
        std::size_t at = 0;
        while (at < bytes.size()) {
            const ssize_t count = pread(file_.number(), bytes.data() + at, bytes.size() - at, static_cast<off_t>(at));
            if (count <= 0 && errno != EINTR) fail_writing(output_, count == 0 ? EIO : errno);
            if (count > 0) at += static_cast<std::size_t>(count);
        }
        write_named(bytes);
        file_.end();
    }

    void write_named(std::string_view bytes) {
        for (int i = 0; i < kTries; ++i) {
            name_.emplace(folder_of(output_.end));
            const OpenFile file(open_again(name_->text(), O_WRONLY | O_CREAT | O_EXCL, 0666));
            if (file.number() >= 0) {
                name_->exists(true);
                return fill(file.number(), bytes);
            }
            if (errno != EEXIST) fail_writing(output_, errno);
        }
        fail_writing(output_, EEXIST);
    }

    Output output_;
    std::optional<struct stat> old_;
    bool kept_;
    OpenFile file_;
    std::optional<UnfinishedName> name_;
};

// A file that is there and of another kind, such as a device or a pipe.
struct Straight {
    Output output;
    std::string bytes;
};

void write_straight(const Straight& straight) {
    const auto& [output, bytes] = straight;
    // Opened again, a standard output that goes to the end of a file would begin at its start.
    if (output.end == "-" || output.end == "/dev/stdout") return write_straight(output, STDOUT_FILENO, bytes);
    const OpenFile device(open_again(output.end.c_str(), O_WRONLY | O_NOCTTY));
    if (device.number() < 0) fail_writing(output, errno);
    write_straight(output, device.number(), bytes);
}

// So many descriptors are open at most; the others have a name that is theirs for now.
constexpr std::size_t kMostUnfinished = 32;

}  // namespace

struct NewFiles::Parts {
    bool kept;
    std::deque<Waiting> waiting;
    std::vector<Straight> straight;
};

NewFiles::NewFiles(Keep keep) : parts_(std::make_unique<Parts>(Parts{keep == Keep::on_disk, {}, {}})) {}
NewFiles::~NewFiles() = default;

void NewFiles::add(const std::string& path, std::string_view bytes) {
    const SignalsAsErrors quiet;
    if (path.empty()) throw Error(Fault::failed, "", phrase("an output has no name; give one, or - for standard output"));
    if (path.find('\0') != std::string::npos)
        throw Error(Fault::failed, "", phrase("the name of an output holds a zero byte; choose another"));
    struct stat old {};
    const bool standard = path == "-" || path == "/dev/stdout";
    const bool exists = !standard && stat(path.c_str(), &old) == 0;
    if (!standard && !exists && errno != ENOENT) fail_writing({path, path}, errno);
    if (exists && S_ISDIR(old.st_mode)) fail_writing({path, path}, EISDIR);
    if (standard) check_terminal(bytes);
    if (standard || (exists && !S_ISREG(old.st_mode))) {
        parts_->straight.push_back({{path == "-" ? "standard output" : path, path}, std::string(bytes)});
        return;
    }
    Output output{path, follow_links(path)};
    if (output.end.back() == '/') fail_writing(output, ENOENT);
    if (exists && faccessat(AT_FDCWD, output.end.c_str(), W_OK, AT_EACCESS) != 0) fail_writing(output, errno);
    parts_->waiting.emplace_back(std::move(output), bytes, exists ? &old : nullptr, parts_->kept);
    if (parts_->waiting.size() > kMostUnfinished) parts_->waiting.back().name_for_now();
}

void NewFiles::take_names() {
    const SignalsAsErrors quiet;
    std::deque<Waiting>& waiting = parts_->waiting;
    for (Waiting& file : waiting) file.name_for_now();
    for (const Straight& each : parts_->straight) write_straight(each);
    auto next = waiting.rbegin();
    try {
        for (; next != waiting.rend(); ++next) next->take_name();
        if (!parts_->kept) return;
        std::set<std::string> folders;
        for (const Waiting& file : waiting)
            if (folders.insert(file.folder()).second)
                if (const int reason = keep_folder(file.folder())) fail_writing(file.output(), reason);
    } catch (const Error&) {
        while (next != waiting.rbegin()) (--next)->withdraw();
        throw;
    }
}

int keep_open(int descriptor) {
    // Some file systems keep nothing, and know nothing of it.
    if (fsync(descriptor) == 0 || errno == EINVAL || errno == ENOSYS || errno == EOPNOTSUPP || errno == EROFS) return 0;
    return errno;
}

int keep_folder(const std::string& folder) {
    const OpenFile opened(open_again(folder.c_str(), O_RDONLY | O_DIRECTORY));
    return opened.number() < 0 ? 0 : keep_open(opened.number());  // one that we may write but not list is left to the system
}

void write_files(const std::vector<NewFile>& files) {
    NewFiles all;
    for (const NewFile& file : files) all.add(file.path, file.bytes);
    all.take_names();
}

void check_folder_of(const std::string& path) {
    struct stat there {};
    if (stat(path.c_str(), &there) == 0) return;
    const std::string folder = folder_of(path);
    if (stat(folder.c_str(), &there) != 0) fail_writing({path, path}, errno);
    if (!S_ISDIR(there.st_mode)) fail_writing({path, path}, ENOTDIR);
    if (access(folder.c_str(), W_OK | X_OK) != 0) fail_writing({path, path}, errno);
}

void write_file(const std::string& path, std::string_view bytes) { write_files({{path, bytes}}); }

}  // namespace tactics
