// SPDX-License-Identifier: Apache-2.0
// The main program's side of `tactics-openimageio` and similar programs: each is found and started on first use, and ends when we
// end.
#pragma once

#include <algorithm>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/readers/caged/protocol.h"

namespace tactics {

struct CagedRequest {
    std::string_view verb, format;
    std::vector<std::string> rest = {};
    int file = -1;  ///< a descriptor; it is opened anew, so its place in the file plays no part
    const caged::Program* program = &caged::kOpenImageIo;
};

/// The answer about one file, frame by frame. Several may be in progress in different threads.
class CagedAnswer {
public:
    /// Throws Error(failed) at `place` if the program is not installed or cannot be started.
    CagedAnswer(const std::string& place, const CagedRequest& request);
    /// Reads from a descriptor, which it owns.
    explicit CagedAnswer(int pipe) : pipe_(pipe) {}
    ~CagedAnswer();
    CagedAnswer(const CagedAnswer&) = delete;
    CagedAnswer& operator=(const CagedAnswer&) = delete;

    /// A frame of just that size. False where the answer has a fault or ends instead; why() says it.
    bool read(caged::Frame kind, void* bytes, std::size_t size);
    /// The same, of any size up to `most`.
    bool read(caged::Frame kind, std::string& bytes, std::size_t most);

    /// The same for that many values; memory grows as they arrive.
    template <typename Value>
    bool read(caged::Frame kind, std::vector<Value>& values, std::size_t count) {
        constexpr std::size_t kBatch = 1 << 16;
        if (!begins(kind, count * sizeof(Value))) return false;
        values.clear();
        while (values.size() < count) {
            const std::size_t first = values.size();
            values.resize(std::min(count, first + kBatch));
            if (!take(values.data() + first, (values.size() - first) * sizeof(Value))) return false;
        }
        return true;
    }

    const std::string& why() const { return why_; }  ///< one line

private:
    bool take(void* bytes, std::size_t size);
    bool head(caged::Frame kind, std::size_t& size);
    bool begins(caged::Frame kind, std::size_t size);

    int pipe_ = -1;
    std::string why_;
};

}  // namespace tactics
