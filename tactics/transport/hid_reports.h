// SPDX-License-Identifier: Apache-2.0
// A HID device with reports of one size, without ids.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace tactics {

class HidReports {
public:
    virtual ~HidReports() = default;
    /// One report. false: the device is gone.
    virtual bool write(std::span<const std::uint8_t> report) noexcept = 0;
    /// The next report, waiting at most that long: how many bytes it has; 0: none came; -1: gone.
    virtual int read(std::span<std::uint8_t> report, std::chrono::milliseconds time) noexcept = 0;
};

/// Paths of the devices whose report descriptor begins with that usage page and usage, as the kernel lists them below `root` (""
/// but in tests).
std::vector<std::string> hid_paths(std::uint16_t page, std::uint8_t usage, const std::string& root);

/// The kernel's name for it; empty: none.
std::string hid_name(const std::string& path, const std::string& root);

/// By its path, /dev/hidraw0. Throws Error(failed): missing, not permitted.
std::unique_ptr<HidReports> open_hid_reports(const std::string& path);

}  // namespace tactics
