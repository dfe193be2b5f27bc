#include "cli/embosser_flags.h"

#include "tactics/error.h"
#include "tactics/read.h"

namespace tactics {

const Format* embosser_given(const Given& given) {
    if (!given.has("--embosser")) return nullptr;
    std::vector<std::string_view> names;
    for (const Format* format : formats())
        if (format->embosser != nullptr) names.push_back(format->name);
    const std::string name = given.value("--embosser");
    const Format* format = find_format(name);
    if (format == nullptr || format->embosser == nullptr)
        throw Error(Fault::usage, "--embosser", "there is no embosser \"" + name.substr(0, 80) + "\"" + did_you_mean(name, names) + "; see tactics list embossers");
    return format;
}

std::string bytes_of_files(const std::vector<std::string>& files) {
    constexpr std::size_t kMost = 256u << 20;
    std::string bytes;
    for (const std::string& name : files) {
        const Source source = open_source(name);
        char block[1 << 16];
        while (const std::size_t count = std::fread(block, 1, sizeof block, source.file.get())) {
            bytes.append(block, count);
            if (bytes.size() > kMost) throw Error(Fault::failed, name, "is over 256 MB with what stands before it; take fewer files at a time");
        }
    }
    return bytes;
}

Settings embosser_settings(const Format& format, const Given& given) {
    Settings settings(format.options);
    for (const std::string& text : given.all("--set")) {
        const auto dot = text.find('.'), equals = text.find('=');
        if (dot == std::string::npos || equals == std::string::npos || dot > equals || text.substr(0, dot) != format.name)
            throw Error(Fault::usage, "--set", "it is " + std::string(format.name) + ".OPTION=VALUE; see tactics help " + std::string(format.name));
        settings.set(text.substr(dot + 1, equals - dot - 1), text.substr(equals + 1), "--set", format.name);
    }
    return settings;
}

}  // namespace tactics
