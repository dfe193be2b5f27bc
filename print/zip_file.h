// SPDX-License-Identifier: Apache-2.0
// A ZIP archive (PKWARE APPNOTE 6.3), as packages of books are: no dates but the first that the format knows, so that the
// same files give the same bytes.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace tactics {

class ZipFile {
public:
    enum class Packing { stored, deflated };

    /// `name` is in UTF-8 with / between folders. All must stay below 4 GiB together; throws std::length_error.
    void add(std::string_view name, std::string_view bytes, Packing packing);
    std::string finish();

private:
    std::string bytes_;
    std::string directory_;
    std::uint32_t count_ = 0;
};

}  // namespace tactics
