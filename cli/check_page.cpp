#include "cli/check_page.h"

#include <algorithm>
#include <string_view>

#include "cli/conversion.h"
#include "cli/mending.h"
#include "cli/reading.h"
#include "filters/list.h"
#include "tactics/pages/pdf.h"
#include "tactics/pages/xml.h"

namespace tactics {

namespace {

enum class Holds { svg, pdf, other };

Holds look_at(std::FILE* file) {
    char head[1024];
    const std::size_t count = std::fread(head, 1, sizeof head, file);
    std::rewind(file);
    std::string_view text(head, count);
    if (text.substr(0, 5) == "%PDF-") return Holds::pdf;
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    // UTF-16 begins with a mark, and a letter below 80h has a byte 0.
    if (text.starts_with("\xff\xfe<") || text.substr(0, 4) == std::string_view("\xfe\xff\0<", 4)) return Holds::svg;
    const auto begin = text.find_first_not_of(" \t\r\n");
    return begin != std::string_view::npos && text[begin] == '<' ? Holds::svg : Holds::other;
}

std::string bytes_of(std::FILE* file) {
    std::string bytes;
    char block[1 << 16];
    for (std::size_t count = 1; count > 0 && bytes.size() <= kMostXmlBytes;) {  // one more than may be: parse_xml says so
        count = std::fread(block, 1, sizeof block, file);
        bytes.append(block, count);
    }
    return bytes;
}

// As convert makes it, for the medium's own size and without a title.
FoundPage page_of_picture(Source& source, const PageWish& wish) {
    const PictureInfo picture = inspect_picture(source);
    Reading reading(source);
    FoundPage found;
    Recipe base;
    if (wish.chain.base) {
        base = *wish.chain.base;
    } else {
        const Choice choice = choose(reading);
        base = find_recipe(choice.recipe, "auto");
    }
    const Recipe recipe = fit_to(*wish.medium, finish(wish.chain, base));
    found.notes.push_back("this is a picture, checked as convert would draw it (recipe " + recipe.name + ", medium " +
                          std::string(wish.medium->name) + "); a page is checked as SVG or PDF");
    Sheet sheet;
    sheet.medium = wish.medium;
    sheet.paper = wish.paper ? *wish.paper : find_paper(wish.medium->name == "embosser" ? "11x11.5" : "a4", "--paper");
    sheet.margin = wish.margin;
    const Kept kept = kept_by(recipe);
    const Place place = place_on(sheet, aspect_of(picture) * kept.width / kept.height);
    Drawing drawing = drawing_of(run(recipe, read_for(recipe, place.drawing, reading)));
    found.page = lay_out(mend_for(sheet, std::move(drawing), wish.chain.as_drawn).drawing, sheet);
    if (found.page.picture) found.notes.push_back("a picture of pixels is looked at for its ink and beside braille only");
    return found;
}

}  // namespace

FoundPage page_of(const std::string& file, const PageWish& wish) {
    Source source = open_source(file);
    const double margin = wish.margin.value_or(wish.medium->margin);
    switch (look_at(source.file.get())) {
        case Holds::svg: return read_svg(bytes_of(source.file.get()), source.name, margin, wish.paper);
        case Holds::pdf:
            if (file == "-")
                throw Error(Fault::failed, source.name, "a PDF is read from a file only; save it to one and name that");
            return read_svg(pdf_as_svg(file), file, margin, wish.paper);
        case Holds::other: break;
    }
    return page_of_picture(source, wish);
}

}  // namespace tactics
