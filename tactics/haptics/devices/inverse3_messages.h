// SPDX-License-Identifier: Apache-2.0
// Messages to and from Haply's Inverse Service: JSON over a WebSocket, following Haply's public documentation of the Inverse SDK
// 3.5 (docs.haply.co/inverseSDK/service: "WebSocket Protocol", "Simulation Channel", "Device Configuration", "Basis
// Permutation").
//
// Port 10001. On connection, the service lists its devices with their ids; afterwards it answers each message with exactly one
// that has the state of all devices. The command set_cursor_force names a device by its id and sets a force in N; a force of zero
// keeps the answers coming. Positions are in metres.
//
// Sources differ: the buttons of a VerseGrip are `button` (wired, 3.1), or `buttons` with a, b, c (wireless), or with button_0 to
// button_3 (a custom grip); all are accepted. The control state is `mode` in 3.1 and `control_mode` in 3.5, and ignored. `status`
// has different members in each; a missing one counts as good. The format of services before 3.1 and their ports (10000; events
// on 10020) are not supported. The behaviour of the device when messages stop is not documented there.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/haptics/devices/arm_talk.h"
#include "tactics/point3.h"

namespace tactics {

inline constexpr std::string_view kInversePort = "10001";
/// Bytes; longer messages are rejected. A message with four devices and their configuration has 8,000.
inline constexpr std::size_t kMostInverseMessage = 256 * 1024;

/// Ids of the devices in a message; nothing if it is no JSON object of the service. Invalid ids (empty, over 64 characters, other
/// than letters, digits, - and _) are left out.
std::optional<std::vector<std::string>> inverse3_ids(std::string_view message);

/// The state of that device in a message: the cursor is the middle of its ball, or the tip of the tool in its place. Keys are
/// those of the first grip that reports any: bit 0 is a, 1 b, 2 c. A device that is not ready, not calibrated or without power is
/// at fault. Nothing: no JSON, no such device, or its position is not three numbers within 1 m.
std::optional<ArmWord> inverse3_word(std::string_view message, std::string_view id);

/// The message that sets that force, N. The first one names the client and requests the preset arm_front_centered: Haply's axes,
/// right-handed, x to the right, y forward, z up, from the middle of the arm's reach. Here and in ArmWord the axes are those of
/// arm_devices.h.
std::string inverse3_request(std::string_view id, const Point3& force, bool first);

}  // namespace tactics
