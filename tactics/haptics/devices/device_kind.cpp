// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/devices/device_kind.h"

namespace tactics {

#define DEVICE(name) extern const DeviceKind name##_device;
#include "tactics/haptics/devices/list.inc"
#undef DEVICE

std::span<const DeviceKind* const> device_kinds() {
    static const DeviceKind* const kKinds[] = {
#define DEVICE(name) &name##_device,
#include "tactics/haptics/devices/list.inc"
#undef DEVICE
    };
    return kKinds;
}

}  // namespace tactics
