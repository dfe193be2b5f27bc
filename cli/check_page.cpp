#include "cli/check_page.h"

#include "cli/conversion.h"
#include "cli/figure.h"
#include "cli/mending.h"
#include "cli/reading.h"
#include "filters/list.h"
#include "tactics/pages/pdf.h"

namespace tactics {

namespace {

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
    sheet.paper = wish.paper ? *wish.paper : find_paper(has_fixed_dots(*wish.medium) ? "11x11.5" : "a4", "--paper");
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
