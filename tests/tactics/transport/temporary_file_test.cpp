// SPDX-License-Identifier: Apache-2.0
#include "tactics/transport/temporary_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

#include "tests/tactics/transport/own_folder.h"

namespace tactics::temporary_file_test {
namespace {

class TemporaryFiles : public tests::File {};

// An environment variable for as long as this lives.
class Set {
public:
    Set(const char* name, const std::string& value) : name_(name) {
        if (const char* before = std::getenv(name)) before_ = before;
        setenv(name, value.c_str(), 1);
    }
    ~Set() { before_ ? setenv(name_, before_->c_str(), 1) : unsetenv(name_); }

private:
    const char* name_;
    std::optional<std::string> before_;
};

std::string folder_of(std::FILE* file) {
    const auto link = std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(fileno(file))).string();
    return link.substr(0, link.rfind('/'));
}

TEST_F(TemporaryFiles, AreWhereTmpdirSaysAndHaveNoName) {
    const Set tmpdir("TMPDIR", folder_);
    const TemporaryFile file = temporary_file();
    ASSERT_NE(file, nullptr);
    EXPECT_EQ(folder_of(file.get()), folder_);
    EXPECT_TRUE(std::filesystem::is_empty(folder_));
    struct stat facts {};
    ASSERT_EQ(fstat(fileno(file.get()), &facts), 0);
    EXPECT_EQ(facts.st_nlink, 0u);
    EXPECT_EQ(facts.st_mode & 0777, 0600u);
}

TEST_F(TemporaryFiles, AreElsewhereIfThatFolderTakesNone) {
    for (const std::string& given : {folder_ + "/none", std::string("relative"), std::string()}) {
        const Set tmpdir("TMPDIR", given);
        const TemporaryFile file = temporary_file();
        ASSERT_NE(file, nullptr) << given;
        EXPECT_NE(folder_of(file.get()), given);
    }
}

TEST_F(TemporaryFiles, KeepWhatIsWritten) {
    const TemporaryFile file = temporary_file();
    ASSERT_NE(file, nullptr);
    ASSERT_GE(std::fputs("dots", file.get()), 0);
    std::rewind(file.get());
    char text[8] = {};
    EXPECT_STREQ(std::fgets(text, sizeof text, file.get()), "dots");
}

TEST_F(TemporaryFiles, CureNamesTheFolderThatIsAskedFirst) {
    const Set tmpdir("TMPDIR", "/somewhere");
    EXPECT_EQ(temporary_file_cure().english(), "make room in /somewhere, or name another folder with TMPDIR");
}

}  // namespace
}  // namespace tactics::temporary_file_test
