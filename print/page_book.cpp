// SPDX-License-Identifier: Apache-2.0
#include "print/page_book.h"

#include <utility>
#include <vector>

#include "tactics/error.h"

namespace tactics {

namespace {

std::size_t points_of(const Page& page) {
    std::size_t points = page.picture ? page.picture->bits.size() / sizeof(Point) : 0;
    for (const PageStroke& stroke : page.strokes) points += stroke.points.size() + sizeof(PageStroke) / sizeof(Point);
    for (const Area& area : page.areas)
        for (const auto& ring : area.rings) points += ring.size();
    for (const Area& area : page.textured)
        for (const auto& ring : area.rings) points += ring.size();
    return points;
}

class KeptPages : public PageBook {
public:
    KeptPages(const Format& format, Settings settings) : format_(format), settings_(std::move(settings)) {}

    void add(std::span<const Page> pages, const std::string&) override {
        for (const Page& page : pages) points_ += points_of(page);
        if (points_ > kMostBookPoints)
            throw Error(Fault::failed, "",
                        phrase("the pages before it fill all the memory that one {0} may take; make several files of fewer "
                               "pictures each, or a pdf, which takes less",
                               format_.name));
        pages_.insert(pages_.end(), pages.begin(), pages.end());
    }

    std::string finish(const std::string&) override {
        std::string file;
        each_file(format_, pages_, settings_, [&](std::string_view bytes) { file = bytes; });
        return file;
    }

private:
    const Format& format_;
    const Settings settings_;
    std::vector<Page> pages_;
    std::size_t points_ = 0;
};

}  // namespace

std::unique_ptr<PageBook> book_of(const Format& format, const Settings& settings) {
    if (format.open_book != nullptr) return format.open_book();
    return std::make_unique<KeptPages>(format, settings);
}

bool holds_several_sizes(const Format& format) { return format.open_book != nullptr; }

}  // namespace tactics
