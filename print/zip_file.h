// SPDX-License-Identifier: Apache-2.0
// A ZIP archive (PKWARE APPNOTE 6.3), for book packages. It uses no clock, so the same files give the same bytes.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace tactics {

class ZipFile {
public:
    enum class Packing { stored, deflated };

    /// `day`, as 2026-03-31, is the date of all files. A date is mandatory: the default is 1980-01-01, the earliest possible.
    /// Month 0 would be invalid: Java takes it for 1979 and unzip shows 1980-00-00.
    explicit ZipFile(std::string_view day = "1980-01-01");

    /// `name` is in UTF-8 with / between folders. All must stay below 4 GiB together; throws std::length_error.
    void add(std::string_view name, std::string_view bytes, Packing packing);
    std::string finish();

private:
    std::string bytes_;
    std::string directory_;
    std::uint32_t count_ = 0;
    std::uint32_t day_;
};

}  // namespace tactics
