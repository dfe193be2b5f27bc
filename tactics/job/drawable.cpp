// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/drawable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>

#include "filters/chart.h"
#include "filters/darken.h"
#include "filters/drawing_of.h"
#include "filters/flat_regions.h"
#include "filters/inked_fills.h"
#include "filters/known_parts.h"
#include "filters/list.h"
#include "tactics/error.h"
#include "tactics/job/chart_json.h"
#include "tactics/job/figure.h"
#include "tactics/job/figure_pictures.h"
#include "tactics/job/holds.h"
#include "tactics/job/left_print.h"
#include "tactics/job/own_pages.h"
#include "tactics/job/reading.h"
#include "tactics/job/surface_heights.h"
#include "tactics/job/table.h"
#include "tactics/job/trimmed.h"
#include "tactics/layout/texture.h"
#include "tactics/readers/model.h"
#include "tactics/readers/svg/figure.h"
#include "tactics/readers/svg/own_page.h"
#include "tactics/relief/height_picture.h"

namespace tactics {

namespace {

// A thing can be named, and a box left out, where regions are looked for, and that is in this recipe.
Choice choice_for(const SubjectWish& wish) {
    return {"photo", wish.subject.empty() ? phrase("it can leave a box out") : phrase("what matters in it is named")};
}

Recipe recipe_for(Reading& reading, const Job& job, Phrase& reason) {
    if (job.recipe) return with_subject(*job.recipe, job.wish);
    if (job.chain.base) return with_subject(finish(job.chain, *job.chain.base), job.wish);
    const Choice choice = job.wish.empty() ? choose(reading) : choice_for(job.wish);
    reason = choice.reason;
    return with_subject(finish(job.chain, find_recipe(choice.recipe, "auto")), job.wish);
}

// The first setting of that name; 0 if no filter of the recipe has it.
double setting_of(const Recipe& recipe, std::string_view name) {
    for (const Step& step : recipe.steps)
        for (const Option& option : step.filter->options)
            if (option.name == name) return step.settings.number(name);
    return 0;
}

// Heads of arrows, dashes and points are as small as print, so only a recipe that looks closely at a figure takes them for what
// they are. One that draws lines by their middle draws surfaces by their outlines, which a texture may fill.
// `ground`: of the whole picture, as little of it may be left in what is drawn. `print`: what is left in the lines.
KnownParts known_parts_of(Image& picture, const Recipe& recipe, bool has_legend, const std::array<int, 3>& ground,
                          const std::vector<Box>& print) {
    constexpr double kClosely = 100;  // dots per inch
    if (!recipe.has_words || !(picture.mm_per_pixel > 0)) return {};
    // Many colours of a map say which regions are neighbours, and no more; few, or those of a legend, may say what a region is.
    const bool is_map =
        std::any_of(recipe.steps.begin(), recipe.steps.end(), [](const Step& step) { return step.filter->name == "borders"; });
    KnownParts parts;
    if (is_map && (has_legend || map_traits_of(picture).colours <= textures().size()))
        parts.areas = without_ground_around(take_fills(picture, ground), picture.width * picture.mm_per_pixel,
                                            picture.height * picture.mm_per_pixel);
    else if (!is_map && setting_of(recipe, "dpi") >= kClosely)
        parts = take_known_parts(picture, setting_of(recipe, "lines") > 0 ? std::optional(ground) : std::nullopt, print);
    return parts;
}

// Pixels from any source. `words` says what to do with print in them.
Drawable drawable_of_pixels(PictureInfo info, const std::shared_ptr<Reading>& reading, WordsWish words, const Job& job,
                            const Sheet& sheet) {
    Drawable drawable{.info = std::move(info)};
    drawable.recipe = recipe_for(*reading, job, drawable.reason);
    drawable.words = words_of(*reading, drawable.recipe, words, sheet);
    drawable.print_is_left = true;
    drawable.title = drawable.words.title;
    drawable.title_origin = "the title of the figure";
    const Kept kept = kept_by(drawable.recipe);
    const double aspect = aspect_of(drawable.info) * kept.width / kept.height;
    drawable.aspect = [aspect](const Sheet&) { return aspect; };
    const bool chooses = job.chain.detail == "best" && keeps_some(drawable.recipe);
    if (chooses) check_chooses_detail(drawable.recipe);
    drawable.draw = [reading, chooses, recipe = drawable.recipe, as_drawn = job.chain.as_drawn,
                     longest = std::max(drawable.info.width, drawable.info.height)](
                        const Sheet& on, const Rect& place, const Rect& part, const PrintWords& print, DrawingWay& way) {
        Recipe fitting = fit_to(*on.medium, recipe);
        Image picture =
            read_for(fitting, {place.left, place.top, place.width / part.width, place.height / part.height}, *reading);
        way.finer = longest > std::max(picture.width, picture.height);
        print.take_from(picture);
        const std::array<int, 3> ground = recipe.has_words ? ground_of(picture) : std::array<int, 3>{};
        const std::vector<Box> left = left_print_in(print, picture, part);
        picture = cut_out(std::move(picture), part);
        if (chooses) way.detail = choose_detail(fitting, picture, on, place, as_drawn);
        KnownParts parts = known_parts_of(picture, recipe, !print.samples.empty(), ground, left);
        const double mm = picture.mm_per_pixel;
        Drawing drawing = drawing_of(run_settling(fitting, std::move(picture), way.chosen));
        if (!drawing.picture) {
            way.told = parts.told();
            drawing.remarks.insert(drawing.remarks.end(), way.told.begin(), way.told.end());
            std::move(parts).add_to(drawing);
            tell_lost_print(left, mm, drawing, way.told);
        }
        if (way.detail) drawing.remarks.push_back(remark_on(*way.detail));
        way.steps = steps_of(fitting);
        return drawing;
    };
    return drawable;
}

Drawable drawable_of_picture(Source& source, const Job& job, const Sheet& sheet) {
    const auto reading = std::make_shared<Reading>(source);
    Drawable drawable = drawable_of_pixels(inspect_picture(source), reading, job.words, job, sheet);
    if (drawable.recipe.has_words && draws_whole(drawable.recipe) && job.wish.empty()) {
        Image left = reading->get({kLookForWords, uses_colour(drawable.recipe)});
        take_out(left, drawable.words.lettering, !drawable.words.remove_all);
        const Rect inked = inked_part(left);
        // Fewer pixels are not spread over a whole sheet: curves would come out as the steps of their pixels.
        constexpr double kFewestPixels = 250;
        const double width = drawable.info.width, height = drawable.info.height,
                     read = std::min(1.0, kMostPixels / std::max(width, height));
        if (read * std::max(inked.width * width, inked.height * height) >= kFewestPixels) drawable.inked = inked;
    }
    return drawable;
}

// What is lines already goes no way through pixels.
void tell_what_does_nothing(const Phrase& what, const Job& job, Notes& notes) {
    if (asks_for_a_way(job.chain))
        notes.push_back(phrase("it is {0}, so {1}, {2}, {3} and settings of filters do nothing to it", what, spelled("recipe"),
                               spelled("filter"), spelled("detail")));
    if (!job.wish.empty())
        notes.push_back(phrase("it is {0}, so {1}, {2} and {3} do nothing to it", what, spelled("subject"),
                               spelled("subject-only"), spelled("leave")));
}

// A file within the file, kept as long as it is drawn from.
std::shared_ptr<Source> source_of(const FoundPicture& picture) {
    struct Kept {
        std::vector<unsigned char> bytes;
        Source source;
    };
    const auto kept = std::make_shared<Kept>();
    kept->bytes.assign(picture.bytes.begin(), picture.bytes.end());
    kept->source = memory_source(kept->bytes, "a picture in it");
    return {kept, &kept->source};
}

std::shared_ptr<const std::vector<FigurePart>> parts_of(const Figure& figure, const Job& job, const Sheet& sheet, Notes& notes) {
    auto parts = std::make_shared<std::vector<FigurePart>>();
    for (const FoundPicture& picture : figure.page.pictures) {
        const auto source = source_of(picture);
        const auto reading = std::make_shared<Reading>(
            [source, mirrored = picture.mirrored, upside_down = picture.upside_down](const ReadRequest& request) {
                return turned_over(read_picture(*source, request), mirrored, upside_down);
            });
        FigurePart part{picture.place, picture.shown,
                        drawable_of_pixels(inspect_picture(*source), reading, job.words, job, sheet)};
        if (!part.drawable.reason.empty())
            notes.push_back(
                phrase("a picture in it is drawn by the recipe {0} ({1})", part.drawable.recipe.name, part.drawable.reason));
        parts->push_back(std::move(part));
    }
    return parts;
}

Drawable drawable_of_figure(Source& source, const Job& job, const Sheet& sheet, Notes& notes) {
    const auto figure = std::make_shared<Figure>(read_figure(source, job.words, sheet));
    const Page& page = figure->page.page;
    Drawable drawable{.info = {"SVG", static_cast<int>(std::lround(figure->page.file_width)),
                               static_cast<int>(std::lround(figure->page.file_height))}};
    drawable.words = figure->words;
    const auto parts = parts_of(*figure, job, sheet, notes);
    take_words(*parts, page.width, page.height, drawable.words);
    if (!page.title.empty() && !sheet.bare) {
        drawable.title = page.title;
        drawable.title_origin = "the title in the SVG";
    } else {
        drawable.title = drawable.words.title;
        drawable.title_origin = "the title of the figure";
    }
    if (figure->page.tells_size) drawable.width = figure->page.file_width;
    drawable.aspect = [aspect = figure->aspect()](const Sheet&) { return aspect; };
    drawable.inked = inked_part(figure->page);
    drawable.draw = [figure, parts](const Sheet& on, const Rect& place, const Rect& part, const PrintWords& words,
                                    DrawingWay& way) {
        const double width = place.width / part.width;
        Drawing drawing = drawing_of_figure(figure->page, width);
        way.told = drawing.remarks;
        draw_parts(*parts, width / figure->page.page.width, !words.told.empty(), on, drawing, way);
        return cut_out(std::move(drawing), part);
    };
    if (parts->empty()) tell_what_does_nothing(phrase("lines already"), job, notes);
    return drawable;
}

// A page that we wrote, which a person may have gone on with; nothing: it is of another maker.
std::optional<Drawable> drawable_of_own_page(Source& source, const Job& job, Notes& notes) {
    auto found = read_own_page(bytes_of(source.file.get()), source.name);
    if (!found) {
        std::rewind(source.file.get());
        return std::nullopt;
    }
    for (Phrase& note : found->notes) notes.push_back(to_act_on(std::move(note)));
    const auto own = std::make_shared<const Page>(std::move(found->page));
    Drawable drawable{.info = {"SVG", static_cast<int>(std::lround(own->width)), static_cast<int>(std::lround(own->height))}};
    drawable.own = own;
    drawable.aspect = [own](const Sheet&) { return own->drawing.height > 0 ? own->drawing.width / own->drawing.height : 1; };
    drawable.draw = [own](const Sheet&, const Rect&, const Rect&, const PrintWords&, DrawingWay&) {
        return drawing_of_page(*own);
    };
    tell_what_does_nothing(phrase("a page of ours already"), job, notes);
    return drawable;
}

Drawable drawable_of_table(Source& source, const Job& job, const Sheet& sheet, Notes& notes) {
    std::vector<Phrase> told;
    TableWish table = job.table;
    table.language = sheet.language;
    const auto plot = std::make_shared<Plot>(plot_of(source, table, told));
    notes.insert(notes.end(), told.begin(), told.end());
    Drawable drawable{.info = {"table", 0, 0}};
    drawable.title = plot->title;
    drawable.title_origin = "its title";
    drawable.made_for_sheet = true;
    drawable.aspect = [plot, wish = job.chart](const Sheet& on) { return chart_aspect(sheet_of_chart(*plot, on, wish)); };
    draw_chart(*plot, sheet_of_chart(*plot, sheet, job.chart), job.chart,
               &notes);  // of the first sheet: others show the same, or more
    drawable.draw = [plot, wish = job.chart](const Sheet& on, const Rect&, const Rect&, const PrintWords&, DrawingWay& way) {
        ChartTold it;
        const Sheet turned = sheet_of_chart(*plot, on, wish);
        Drawing drawing = draw_chart(*plot, turned, wish, nullptr, &it);
        if (wish.told) way.chart_json = chart_json(*plot, it, turned);
        return drawing;
    };
    if (!plot->surfaces.empty() && job.chart.view == SurfaceView::heights)
        drawable.heights = [plot](double width) { return surface_heights(plot->surfaces.front(), {.width = width}); };
    tell_what_does_nothing(phrase("a table"), job, notes);
    return drawable;
}

// No perspective, and every face in its shape.
Drawable drawable_of_folded(std::shared_ptr<const Model> model, std::string_view format, const Job& job, const Sheet& sheet,
                            Notes& notes) {
    ModelDrawingWish wish = job.model;
    wish.fold.unite = !job.chain.as_drawn;
    const auto drawing = std::make_shared<ModelDrawing>(std::move(model), std::move(wish));
    Drawable drawable{.info = {std::string(format), 0, 0}};
    drawable.title = drawing->model().title;
    drawable.title_origin = "the title of the model";
    const std::vector<Phrase> told = fold_lines(drawing->on(sheet));
    notes.insert(notes.end(), drawing->notes().begin(), drawing->notes().end());
    notes.insert(notes.end(), told.begin(), told.end());
    drawable.model_json = fold_json(drawing->on(sheet));
    drawable.aspect = [drawing](const Sheet& on) {
        const Drawing& made = drawing->on(on).drawing;
        return made.width / made.height;
    };
    drawable.draw = [drawing](const Sheet& on, const Rect& place, const Rect&, const PrintWords&, DrawingWay&) {
        return scaled_to(drawing->on(on).drawing, place.width);
    };
    tell_what_does_nothing(phrase("a model"), job, notes);
    return drawable;
}

// Folded out, or seen straight from above: the lowest place is black and the highest white. There is no print on it.
Drawable drawable_of_model(Source& source, const Job& job, const Sheet& sheet, Notes& notes) {
    // A terrain is drawn by its heights, and so is a model for which the user named a recipe.
    const bool automatic = job.model.view == ModelView::automatic, names_way = job.recipe || asks_for_a_way(job.chain);
    if (job.model.view != ModelView::heights && !(automatic && names_way)) {
        const std::string format(model_format(source));
        std::vector<Phrase> told;
        auto model = std::make_shared<const Model>(read_model(source, told, job.model.fold.up));
        if (!automatic || !is_terrain(*model)) {
            notes.insert(notes.end(), told.begin(), told.end());
            return drawable_of_folded(std::move(model), format, job, sheet, notes);
        }
        std::rewind(source.file.get());  // its heights tell the same again
    }
    const auto heights = std::make_shared<HeightFile>(model_for_picture(source, job.model.fold.up));
    const PictureInfo info{heights->format, heights->map.columns, heights->map.rows};
    const auto reading =
        std::make_shared<Reading>([heights](const ReadRequest& request) { return picture_of(*heights, request.longest); });
    // What is smooth has no edges, but levels.
    Job drawn = job;
    if (automatic && !names_way && job.wish.empty() && choose(*reading).recipe == "photo")
        drawn.recipe = find_recipe("regions", "auto");
    return drawable_of_pixels(info, reading, WordsWish::leave, drawn, sheet);
}

}  // namespace

Drawable drawable_of(Source& source, const Job& job, const Sheet& sheet, Notes& notes) {
    switch (job.tables_only ? Holds::table : look_at(source)) {
        case Holds::svg:
            if (auto own = drawable_of_own_page(source, job, notes)) return std::move(*own);
            return drawable_of_figure(source, job, sheet, notes);
        case Holds::table: return drawable_of_table(source, job, sheet, notes);
        case Holds::model: return drawable_of_model(source, job, sheet, notes);
        case Holds::pdf:  // of which open_input has made a picture, unless somebody else opened it
        case Holds::picture: break;
    }
    return drawable_of_picture(source, job, sheet);
}

bool may_trim(const Job& job, const Sheet& sheet) {
    return !sheet.bare && !sheet.drawing_width && !sheet.real_width && !sheet.scale &&
           std::all_of(job.labels.begin(), job.labels.end(), [](const PlacedWords& label) { return label.share; });
}

void trim(Drawable& drawable) {
    const Rect part = drawable.part = drawable.inked;
    if (part.width >= 1 && part.height >= 1) return;
    drawable.aspect = [part, aspect = std::move(drawable.aspect)](const Sheet& sheet) {
        return aspect(sheet) * part.width / part.height;
    };
}

}  // namespace tactics
