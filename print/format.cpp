#include "print/format.h"

#include "tactics/words.h"

namespace tactics {

#define FORMAT(name) extern const Format name##_format;
#include "print/list.inc"
#undef FORMAT

std::span<const Format* const> formats() {
    static const Format* const kFormats[] = {
#define FORMAT(name) &name##_format,
#include "print/list.inc"
#undef FORMAT
    };
    return kFormats;
}

const Format* find_format(std::string_view name) {
    for (const Format* format : formats())
        if (format->name == name) return format;
    return nullptr;
}

const Format* format_of_path(std::string_view path) {
    // The longest matching end wins, so that "page.height.png" is a height map and not a picture.
    const Format* best = nullptr;
    std::size_t best_size = 0;
    for (const Format* format : formats()) {
        for (const auto extension : words_of(format->extensions)) {
            const std::string ending = "." + std::string(extension);
            if (path.size() <= ending.size() || ending.size() <= best_size) continue;
            std::string tail(path.substr(path.size() - ending.size()));
            for (char& c : tail)
                if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
            if (tail == ending) {
                best = format;
                best_size = ending.size();
            }
        }
    }
    return best;
}

}  // namespace tactics
