// SPDX-License-Identifier: Apache-2.0
// What is said to Haply's Inverse Service and by it: JSON over a WebSocket, by Haply's public documentation of the Inverse
// SDK 3.5 (docs.haply.co/inverseSDK/service: "WebSocket Protocol", "Simulation Channel", "Device Configuration", "Basis
// Permutation").
//
// Port 10001. As soon as it is connected the service tells what is there, with the id of each device; from then on it answers
// each message with exactly one that has the state of all devices. A device is named by its id, and a force that it shall give,
// in N, is the command set_cursor_force; one of zero keeps the answers coming. Places come in metres.
//
// Where sources differ: buttons of a VerseGrip are `button` (wired, 3.1), or `buttons` with a, b, c (wireless), or with button_0
// to button_3 (a grip of one's own), and all are taken; the state of control is `mode` in 3.1 and `control_mode` in 3.5, and not
// looked at; `status` has other members in each, of which a missing one is taken to be well. The format of services before 3.1
// and their ports (10000; events on 10020) are not spoken. What the device does by itself when messages stop is not documented
// there.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/haptics/devices/arm_talk.h"
#include "tactics/point3.h"

namespace tactics {

inline constexpr std::string_view kInversePort = "10001";
/// Bytes; a longer message is none of it. One with four devices and their configuration has 8,000.
inline constexpr std::size_t kMostInverseMessage = 256 * 1024;

/// Ids of the devices that a message names; nothing where it is no JSON object of the service. Those that cannot be an id (empty,
/// over 64 letters, other than letters, digits, - and _) are left out.
std::optional<std::vector<std::string>> inverse3_ids(std::string_view message);

/// What a message tells of that device: the cursor is the middle of its ball, or the tip of what is in its place. Keys are those
/// of the first grip that tells of any: bit 0 is a, 1 b, 2 c. At fault is who is not ready, not calibrated or without power.
/// Nothing: no JSON, no such device, or its place is not three numbers within 1 m.
std::optional<ArmWord> inverse3_word(std::string_view message, std::string_view id);

/// The message that has the device give that force, N. The first says who speaks and asks for the preset arm_front_centered: axes
/// of Haply's, right-handed, x to the right, y forward, z up, from the middle of what the arm reaches. Here and in a word they
/// are those of arm_devices.h.
std::string inverse3_request(std::string_view id, const Point3& force, bool first);

}  // namespace tactics
