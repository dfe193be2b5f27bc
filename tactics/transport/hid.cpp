// SPDX-License-Identifier: Apache-2.0
// HID devices by the kernel's hidraw, through hidapi: braille displays of the standard, and devices of our own reports. A
// display's report is sent as its id (0 where reports have none) and its cells, bit 0 = dot 1, as the drivers of screen readers
// do.
#include <hidapi.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <stdexcept>

#include "tactics/error.h"
#include "tactics/transport/cell_display.h"
#include "tactics/transport/hid_displays.h"
#include "tactics/transport/hid_reports.h"

namespace tactics {

namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

struct CloseDevice {
    void operator()(hid_device* device) const { hid_close(device); }
};
using Device = std::unique_ptr<hid_device, CloseDevice>;

class HidCells : public CellDisplay {
public:
    HidCells(Device device, HidDisplay display)
        : device_(std::move(device)), display_(std::move(display)), keys_(display_.reports) {}

    CellDisplaySize size() const override {
        const BrailleReports& reports = display_.reports;
        return {reports.columns, static_cast<int>(reports.lines.size()), reports.dots};
    }

    void show(std::span<const std::uint8_t> cells) override {
        const BrailleReports& reports = display_.reports;
        const auto columns = static_cast<std::size_t>(reports.columns);
        if (cells.size() != columns * reports.lines.size()) throw std::logic_error("cells of another display");
        for (const auto& [id, bytes] : reports.sizes) {
            std::vector<std::uint8_t> report(1 + bytes);
            report[0] = static_cast<std::uint8_t>(id);
            for (std::size_t line = 0; line < reports.lines.size(); ++line)
                if (reports.lines[line].report == id)
                    std::transform(
                        cells.begin() + static_cast<std::ptrdiff_t>(line * columns),
                        cells.begin() + static_cast<std::ptrdiff_t>((line + 1) * columns),
                        report.begin() + 1 + static_cast<std::ptrdiff_t>(reports.lines[line].begin),
                        [&](std::uint8_t cell) { return static_cast<std::uint8_t>(reports.dots == 6 ? cell & 0x3F : cell); });
            if (hid_write(device_.get(), report.data(), report.size()) != static_cast<int>(report.size())) gone();
        }
    }

    // Reports contain the keys that are down, and also batteries and other things.
    bool key_within(milliseconds time) override {
        std::array<std::uint8_t, 4096> report{};
        const auto end = Clock::now() + time;
        for (;;) {
            const auto left = std::max(milliseconds{0}, std::chrono::duration_cast<milliseconds>(end - Clock::now()));
            errno = 0;
            const int count = hid_read_timeout(device_.get(), report.data(), report.size(), static_cast<int>(left.count()));
            if (count < 0 && errno == EINTR) return false;  // Ctrl-C is for who asked
            if (count < 0) gone();
            if (count > 0 && keys_.pressed(std::span(report).first(static_cast<std::size_t>(count)))) return true;
            if (count == 0 && left.count() == 0) return false;
        }
    }

private:
    [[noreturn]] void gone() const {
        throw Error(Fault::failed, display_.path, phrase("the braille display is gone; plug it in and switch it on"));
    }

    Device device_;
    HidDisplay display_;
    KeyWatch keys_;
};

class Reports : public HidReports {
public:
    explicit Reports(Device device) : device_(std::move(device)) {}
    bool write(std::span<const std::uint8_t> report) noexcept override {
        std::array<std::uint8_t, 1 + kMostBytes> numbered{};  // the first is the id: 0, none
        const std::size_t size = std::min(report.size(), kMostBytes);
        std::copy_n(report.begin(), size, numbered.begin() + 1);
        for (int time = 0; time < 3; ++time) {
            errno = 0;
            const int count = hid_write(device_.get(), numbered.data(), 1 + size);
            if (count >= 0 || errno != EINTR) return count == static_cast<int>(1 + size);
        }
        return true;  // Ctrl-C does not mean that it was unplugged
    }
    int read(std::span<std::uint8_t> report, milliseconds time) noexcept override {
        errno = 0;
        const int count = hid_read_timeout(device_.get(), report.data(), report.size(), static_cast<int>(time.count()));
        return count < 0 && errno == EINTR ? 0 : count;
    }

private:
    static constexpr std::size_t kMostBytes = 1024;  // of one report at high speed
    Device device_;
};

// `permission`: what to do if it may not be opened.
Device open_path(const std::string& path, const Phrase& permission) {
    errno = 0;
    Device device(hid_open_path(path.c_str()));
    if (device == nullptr) {
        const bool forbidden =
            errno == EACCES || errno == EPERM || (access(path.c_str(), F_OK) == 0 && access(path.c_str(), R_OK | W_OK) != 0);
        throw Error(Fault::failed, path, forbidden ? permission : phrase("cannot be opened; unplug it and plug it in again"));
    }
    return device;
}

}  // namespace

std::unique_ptr<CellDisplay> open_hid_display(const std::string& path) {
    HidDisplay display = hid_display(path, "");
    Device device = open_path(display.path, how_to_be_permitted(display));
    return std::make_unique<HidCells>(std::move(device), std::move(display));
}

std::unique_ptr<HidReports> open_hid_reports(const std::string& path) {
    return std::make_unique<Reports>(open_path(path, how_to_be_permitted(path, "")));
}

}  // namespace tactics
