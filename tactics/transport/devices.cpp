#include "tactics/transport/devices.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "tactics/transport/child.h"
#include "tactics/utf8.h"

namespace tactics {

namespace {

namespace fs = std::filesystem;

// A small file of the kernel as one line; empty if it is not there.
std::string line_of(const fs::path& path) {
    std::ifstream file(path);
    std::string text(1024, '\0');
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(std::max<std::streamsize>(0, file.gcount())));
    return to_line(text);
}

std::vector<fs::path> entries_of(const fs::path& folder) {
    std::vector<fs::path> entries;
    std::error_code fault;
    for (fs::directory_iterator at(folder, fault), end; !fault && at != end; at.increment(fault)) entries.push_back(at->path());
    std::sort(entries.begin(), entries.end());
    return entries;
}

// Of the USB device that an interface or what hangs on it belongs to.
std::string product_of(const fs::path& place) {
    std::error_code fault;
    fs::path folder = fs::canonical(place, fault);
    for (int up = 0; !fault && up < 4 && folder.has_relative_path(); ++up, folder = folder.parent_path()) {
        const std::string product = line_of(folder / "product"), maker = line_of(folder / "manufacturer");
        if (!product.empty()) return maker.empty() ? product : maker + " " + product;
    }
    return "";
}

std::string note_for(const std::string& root, const std::string& path, std::string_view group) {
    if (access((root + path).c_str(), F_OK) != 0) return "the kernel names it, but there is no " + path;
    if (access((root + path).c_str(), W_OK) != 0)
        return "you are not permitted to use it: become a member of the group " + std::string(group) + " (sudo adduser $USER " + std::string(group) + ")";
    return "";
}

}  // namespace

std::string printer_id(const std::string& path, const std::string& root) {
    const std::string name = fs::path(path).filename().string();
    return line_of(root + "/sys/class/usbmisc/" + name + "/device/ieee1284_id");
}

std::vector<AttachedDevice> attached_devices(const std::string& root) {
    std::vector<AttachedDevice> devices;
    for (const fs::path& entry : entries_of(root + "/sys/class/usbmisc")) {
        const std::string name = entry.filename().string();
        if (!name.starts_with("lp")) continue;
        const std::string path = "/dev/usb/" + name;
        std::string id = printer_id(path, root);
        if (id.empty()) id = product_of(entry / "device");
        devices.push_back({path, id, note_for(root, path, "lp")});
    }
    // Printers that no driver of the kernel has taken: CUPS took them, or usblp is not loaded.
    for (const fs::path& entry : entries_of(root + "/sys/bus/usb/devices")) {
        if (line_of(entry / "bInterfaceClass") != "07") continue;
        std::error_code fault;
        if (fs::exists(entry / "driver", fault)) continue;
        devices.push_back({"", product_of(entry), "it has no driver: sudo modprobe usblp, or use its print queue"});
    }
    for (const fs::path& entry : entries_of(root + "/sys/class/tty")) {
        const std::string name = entry.filename().string();
        if (!name.starts_with("ttyUSB") && !name.starts_with("ttyACM")) continue;
        devices.push_back({"/dev/" + name, product_of(entry / "device"), note_for(root, "/dev/" + name, "dialout")});
    }
    return devices;
}

std::vector<AttachedDevice> print_queues() {
    std::vector<AttachedDevice> queues;
    // "device for NAME: URI" a line.
    const ChildAnswer answer = run_child({"lpstat", "-v"}, "", {std::chrono::milliseconds{5'000}, 1u << 20}, {"LC_ALL=C"});
    if (answer.end != ChildAnswer::End::done) return queues;
    std::string_view rest = answer.out;
    while (!rest.empty()) {
        const std::string_view line = rest.substr(0, rest.find('\n'));
        rest.remove_prefix(std::min(rest.size(), line.size() + 1));
        constexpr std::string_view kStart = "device for ";
        const auto colon = line.find(": ");
        if (!line.starts_with(kStart) || colon == std::string_view::npos) continue;
        queues.push_back({"queue:" + std::string(line.substr(kStart.size(), colon - kStart.size())), to_line(line.substr(colon + 2)), ""});
    }
    return queues;
}

}  // namespace tactics
