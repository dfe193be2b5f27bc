#include "tactics/transport/hid_displays.h"

#include <algorithm>
#include <fstream>

#include "tactics/error.h"
#include "tactics/transport/kernel_lists.h"
#include "tactics/utf8.h"

namespace tactics {

namespace {

namespace fs = std::filesystem;

constexpr std::streamsize kMostBytes = 4096;  // HID_MAX_DESCRIPTOR_SIZE of the kernel

std::vector<std::uint8_t> descriptor_of(const fs::path& device) {
    std::vector<std::uint8_t> bytes(kMostBytes);
    std::ifstream file(device / "report_descriptor", std::ios::binary);
    file.read(reinterpret_cast<char*>(bytes.data()), kMostBytes);
    bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(0, file.gcount())));
    return bytes;
}

std::string name_of(const fs::path& device) {
    constexpr std::string_view kName = "HID_NAME=";
    std::ifstream file(device / "uevent");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with(kName)) return to_line(std::string_view(line).substr(kName.size()));
    return "";
}

}  // namespace

std::vector<HidDisplay> hid_displays(const std::string& root) {
    std::vector<HidDisplay> displays;
    for (const fs::path& entry : entries_of(root + "/sys/class/hidraw")) {
        const fs::path device = entry / "device";
        BrailleReports reports = braille_reports(descriptor_of(device));
        if (!reports.lines.empty()) displays.push_back({"/dev/" + entry.filename().string(), name_of(device), std::move(reports)});
    }
    return displays;
}

HidDisplay hid_display(const std::string& path, const std::string& root) {
    const std::vector<HidDisplay> displays = hid_displays(root);
    const std::string place = path.empty() ? "hid" : path;
    if (!path.empty()) {
        std::error_code fault;
        const std::string name = fs::weakly_canonical(path, fault).filename().string();
        for (const HidDisplay& display : displays)
            if (display.path == "/dev/" + name) return display;
    }
    if (displays.empty() || !path.empty())
        throw Error(Fault::failed, place, "there is no braille display of the HID standard; plug it in, switch it on and choose HID in its menu; see tactics devices");
    if (displays.size() == 1) return displays.front();
    std::string all;
    for (const HidDisplay& display : displays) all += (all.empty() ? "" : ", ") + display.path + (display.name.empty() ? "" : " (" + display.name + ")");
    throw Error(Fault::failed, place, "several braille displays are there: " + all + "; name one of them");
}

}  // namespace tactics
