// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/devices/mouse_kind.h"

namespace tactics {

#define MOUSE(name) extern const MouseKind name##_mouse_kind;
#include "tactics/haptics/devices/list.inc"
#undef MOUSE

std::span<const MouseKind* const> mouse_kinds() {
    static const MouseKind* const kKinds[] = {
#define MOUSE(name) &name##_mouse_kind,
#include "tactics/haptics/devices/list.inc"
#undef MOUSE
    };
    return kKinds;
}

}  // namespace tactics
