// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/ticks_in.h"

#include "tactics/job/holds.h"
#include "tactics/readers/felt_file.h"

namespace tactics {

std::optional<TickTable> ticks_in(Source& source) {
    if (is_felt(source)) {
        const std::string bytes = felt_bytes(source);
        const Container container(bytes, source.name);
        if (container.kind() == ContainerKind::heights) return std::nullopt;
        return TickTable{decode_recording(container), {}};
    }
    if (look_at(source) != Holds::table || !has_ticks(source)) return std::nullopt;
    return read_ticks(source);
}

}  // namespace tactics
