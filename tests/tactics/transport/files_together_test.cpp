// SPDX-License-Identifier: Apache-2.0
// Files that belong together: all of them or none.
#include <sys/resource.h>

#include <thread>

#include "tests/tactics/transport/own_folder.h"

namespace tactics::files_together_test {
namespace {

using namespace tests;

class FilesTogether : public File {
protected:
    std::string together(const std::vector<NewFile>& files) const {
        try {
            write_files(files);
        } catch (const Error& error) {
            EXPECT_EQ(error.fault(), Fault::failed);
            return error.what();
        }
        return "no error";
    }

    // What is in the folder, before and after a failure: "name=text name=text".
    std::string everything() const {
        std::string all;
        for (const auto& name : names()) {
            std::error_code circle;
            const bool file = std::filesystem::is_regular_file(in(name), circle);
            all += (all.empty() ? "" : " ") + name + (file ? "=" + read(in(name)) : "");
        }
        return all;
    }
};

TEST_F(FilesTogether, AllAreWritten) {
    write_file(in("b.svg"), "old");
    EXPECT_EQ(together({{in("a.pdf"), "one"}, {in("b.svg"), "two"}, {in("c"), ""}}), "no error");
    EXPECT_EQ(everything(), "a.pdf=one b.svg=two c=");
    EXPECT_EQ(together({}), "no error");
}

// For a failure of any of the three, for any reason.
TEST_F(FilesTogether, NoneIsLeftWhenOneFails) {
    write_file(in("old"), "good");
    std::filesystem::create_directory(in("folder"));
    std::filesystem::create_symlink("circle", in("circle"));
    const std::string before = everything();
    const std::string no_targets[] = {
        in("nowhere/page"), in("old/page"), in("folder"), in("circle"), in(std::string(300, 'n')), "/dev/full", ""};
    for (const std::string& bad : no_targets) {
        for (std::size_t place = 0; place < 3; ++place) {
            std::vector<NewFile> files{{in("new"), "new"}, {in("old"), "new"}};
            files.insert(files.begin() + static_cast<std::ptrdiff_t>(place), {bad, "new"});
            EXPECT_NE(together(files), "no error") << bad;
            EXPECT_EQ(everything(), before) << bad << " at " << place;
        }
    }
}

// The second is too large for the disk or for what is allowed; with names for the time being and without.
TEST_F(FilesTogether, NoneIsLeftWhenRoomEnds) {
    const std::string large(2'000'000, 'x');
    const auto fails = [&](std::string_view why) {
        write_file(in("old"), "good");
        for (const auto& files : {std::vector<NewFile>{{in("new"), "new"}, {in("old"), "new"}, {in("large"), large}},
                                  std::vector<NewFile>{{in("new"), "new"}, {in("old"), large}}}) {
            if (together(files).find(why) == std::string::npos) return 1;
            if (everything() != "old=good") return 2;
        }
        return 0;
    };
    const auto limit = [] {
        const rlimit most{10'000, 10'000};
        return setrlimit(RLIMIT_FSIZE, &most) == 0;
    };
    EXPECT_EQ(in_child([&] { return limit() ? fails("larger than is allowed") : kCannot; }), 0);
    const int hidden = in_child([&] { return hide_proc() && limit() ? fails("larger than is allowed") : kCannot; });
    const int full = in_child([&] { return mount_over(folder_, "size=256k") ? fails("no space left") : kCannot; });
    if (hidden == kCannot || full == kCannot) GTEST_SKIP() << "needs root, to hide /proc and to mount a small file system";
    EXPECT_EQ(hidden, 0);
    EXPECT_EQ(full, 0);
}

// Even if a name cannot be taken at the very end, nothing new stays.
TEST_F(FilesTogether, NoneIsLeftWhenANameCannotBeTaken) {
    write_file(in("mounted"), "good");
    const int result = in_child([&] {
        if (!hide_proc()) return kCannot;
        if (mount(in("mounted").c_str(), in("mounted").c_str(), nullptr, MS_BIND, nullptr) != 0) return kCannot;
        if (together({{in("new"), "new"}, {in("mounted"), "new"}, {in("later"), "new"}}) == "no error") return 1;
        return everything() == "mounted=good" ? 0 : 2;
    });
    if (result == kCannot) GTEST_SKIP() << "needs root, to mount a file";
    EXPECT_EQ(result, 0);
}

// What goes into a pipe has gone: so it comes after everything else that can fail for want of room.
TEST_F(FilesTogether, PipesComeBeforeNames) {
    ASSERT_EQ(mkfifo(in("pipe").c_str(), 0600), 0);
    const std::string bytes(500'000, 'p');  // more than a pipe holds, so the writer waits for the reader
    std::string got;
    bool named = true;
    std::thread reader([&] {
        std::ifstream pipe(in("pipe"), std::ios::binary);
        named = std::filesystem::exists(in("page"));
        got = {std::istreambuf_iterator<char>(pipe), {}};
    });
    EXPECT_EQ(together({{in("page"), "page"}, {in("pipe"), bytes}}), "no error");
    reader.join();
    EXPECT_EQ(got, bytes);
    EXPECT_FALSE(named);
    EXPECT_EQ(read(in("page")), "page");
}

}  // namespace
}  // namespace tactics::files_together_test
