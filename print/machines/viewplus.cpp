// SPDX-License-Identifier: Apache-2.0
// ViewPlus: its driver raises a dot for each pixel of a picture of 20 dots per inch, the higher the darker.
#include "print/machines/machines.h"
#include "print/machines/sheet_feed.h"
#include "tactics/error.h"
#include "tactics/readers/read.h"

namespace tactics {

Punched punch_viewplus(std::string_view bytes, const Settings&) {
    constexpr double kInch = 25.4 / 20;
    SheetFeed feed({});
    try {
        Source source = memory_source({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()}, "the picture");
        const Image picture = to_grey(read_picture(source, {}));
        for (int y = 0; y < picture.height; ++y)
            for (int x = 0; x < picture.width; ++x)
                if (const int white = picture.row(y)[x]; white < 255)
                    feed.set_dot({(x + 0.5) * kInch, (y + 0.5) * kInch}, (255 - white) / 255.0);
    } catch (const Error& error) {
        feed.note(0, error.told());
    }
    return feed.finish(bytes.size());
}

}  // namespace tactics
