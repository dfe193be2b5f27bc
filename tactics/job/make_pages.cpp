// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/make_pages.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <mutex>
#include <set>

#include "tactics/braille/foreign_letters.h"
#include "tactics/error.h"
#include "tactics/geometry/dashed_line.h"
#include "tactics/job/cut_cells.h"
#include "tactics/job/drawable.h"
#include "tactics/job/layout_told.h"
#include "tactics/job/mending.h"
#include "tactics/job/open_input.h"
#include "tactics/job/output_settings.h"
#include "tactics/job/own_pages.h"
#include "tactics/job/page_files.h"
#include "tactics/job/reading.h"
#include "tactics/job/room_for_names.h"
#include "tactics/job/scale_numbers.h"
#include "tactics/job/told_heights.h"
#include "tactics/job/workers.h"
#include "tactics/job/written.h"
#include "tactics/layout/lay_out.h"
#include "tactics/layout/place.h"
#include "tactics/text/utf8.h"
#include "tactics/transport/file.h"
#include "tactics/units.h"

namespace tactics {

namespace {

int page_of(const Job& job) { return job.pdf_page > 0 ? job.pdf_page : job.page; }

class PageMaking {
public:
    PageMaking(const Job& job, const Watch& watch, Outcome& outcome) : job_(job), watch_(watch), outcome_(outcome) {}

    void run(Source source) {
        if (job_.outputs.empty()) throw Error(Fault::usage, "", phrase("no output is named, so nothing would be made"));
        begin(JobStep::reading);
        if (job_.as_text) return run_text(source);
        const Sheet sheet = sheet_for(job_, *job_.outputs.front().format, job_);
        from_ = drawable_of(source, job_, sheet, outcome_.notes);
        if (may_trim(job_, sheet)) trim(from_);
        outcome_.picture = from_.info;
        outcome_.part = from_.part;
        outcome_.recipe = from_.recipe.name;
        outcome_.reason = from_.reason;
        outcome_.keeps_some = keeps_some(from_.recipe);
        outcome_.words = from_.words.told;
        outcome_.model_json = from_.model_json;
        outcome_.notes.insert(outcome_.notes.end(), from_.words.notes.begin(), from_.words.notes.end());
        plan_layouts();
        for (std::size_t i = 0; i < outcome_.layouts.size(); ++i) {
            Layout& layout = outcome_.layouts[i];
            make_room_for_words(layout, arranged_[i]);
            if (stays_[i]) begin(JobStep::laying_out);
            const Pages pages =
                stays_[i] ? pages_of_own(*from_.own, layout.sheet.heights) : lay_out_one(layout.sheet, std::move(arranged_[i]));
            tell_layout(layout, pages);
            if (from_.own && !asks_for_other_size(layout.sheet, *from_.own, job_))
                tell_once(to_act_on(note_of_smaller(layout, from_.own->drawing.width, more_room_)));
            layout.mended = mended_.told;
            layout.detail = detail_;
            if (detail_) tell_once(explained(*detail_, *layout.sheet.medium));
            layout.broken = rules_broken_by(pages.all, *layout.sheet.medium);
            show(i, pages);
            encode(i, pages.all);
        }
        tell_once(to_act_on(cut_.note()));
        write();
    }

private:
    // Pages of braille, without a drawing.
    void run_text(Source& source) {
        const int page = page_of(job_);
        const Written written = text_in(source, {page, std::max(page, job_.last_page)});
        for (const Phrase& note : written.notes) outcome_.notes.push_back(to_act_on(note));
        from_.aspect = [](const Sheet& sheet) { return sheet.paper.width / sheet.paper.height; };
        outcome_.picture.format = "text";
        plan_layouts();
        begin(JobStep::laying_out);
        for (std::size_t i = 0; i < outcome_.layouts.size(); ++i) {
            Layout& layout = outcome_.layouts[i];
            const TextPages made = text_pages(written.blocks, layout.sheet, job_.first_number);
            layout.place.page_width = made.pages.front().width;
            layout.place.page_height = made.pages.front().height;
            layout.pages = made.pages.size();
            layout.text_lines = lines_of_braille(made.pages);
            tell_once(to_act_on(note_of_unknown(made.unknown)));
            if (shows(i)) layout.shown = made.pages;
            layout.broken = rules_broken_by(made.pages, *layout.sheet.medium);
            encode(i, made.pages);
        }
        tell_once(to_act_on(cut_.note()));
        write();
    }

    void begin(JobStep step) const {
        if (watch_.goes_on && !watch_.goes_on(step)) throw Error(Fault::failed, "", phrase("given up; nothing was written"));
    }

    // The outputs that share a sheet, and the place of the drawing on each.
    void plan_layouts() {
        made_.resize(job_.outputs.size());
        for (const Output& output : job_.outputs) {
            Sheet sheet = planned_sheet(*output.format);
            const bool stays = from_.own && stays_as_it_is(sheet, *from_.own, job_, *output.format);
            if (from_.own && !stays) keep_size(sheet, *from_.own, job_);
            std::size_t at = 0;
            while (at < outcome_.layouts.size() && !same_sheet(outcome_.layouts[at].sheet, sheet)) ++at;
            if (at == outcome_.layouts.size()) {
                Layout layout;
                layout.sheet = sheet;
                stays_.push_back(stays);
                arranged_.push_back(stays ? Arrangement{pages_of_own(*from_.own, sheet.heights).place, {}, {}, {}, {}, {}}
                                          : arrange(sheet, from_.aspect(sheet)));
                layout.place = arranged_.back().place;
                check_machine(job_, *output.format, layout.sheet, layout.place);
                outcome_.layouts.push_back(std::move(layout));
            }
            layout_of_.push_back(at);
        }
    }

    Sheet planned_sheet(const Format& format) {
        Sheet sheet = sheet_for(job_, format, job_);
        if (from_.own) take_own(sheet, *from_.own, job_, format);
        if (sheet.scale && !sheet.real_width) sheet.real_width = own_width();
        if (sheet.title.empty() && !from_.title.empty() && !sheet.bare) {
            sheet.title = from_.title;
            sheet.title_origin = from_.title_origin;
        }
        if (Phrase note = note_of_foreign_letters(sheet.title, sheet.braille_table); !note.empty())
            tell_once(to_act_on(std::move(note)));
        if (sheet.window) more_room_ = phrase("show {0} 2", spelled("zoom"));
        if (Phrase note = note_of_long_title(sheet); !note.empty()) outcome_.notes.push_back(to_act_on(std::move(note)));
        // Letters are set one after the other to the right, so such print would come out reversed. Braille always runs so.
        if (sheet.print_title && !sheet.bare && runs_from_right(sheet.title)) {
            sheet.print_title = false;
            if (from_right_++ == 0)
                outcome_.notes.push_back(
                    sheet.braille_table.empty()
                        ? to_act_on(phrase("the title runs from right to left, which print does not do here, and is left out; "
                                           "name a {0} table",
                                           spelled("braille")))
                        : phrase("the title runs from right to left and is in braille only, as print does not do that here"));
        }
        return sheet;
    }

    // A plan that is drawn in mm is as wide in the world as it says itself.
    double own_width() const {
        if (!from_.width)
            throw Error(
                Fault::usage, spelled("scale"),
                phrase("a picture does not tell how large it is in the world; add for example {0} 12m", spelled("real-width")));
        return *from_.width;
    }

    // Whole pixels and whole dots may have made it a little wider or narrower than was planned.
    void fit_shape(const Sheet& sheet, const Drawing& drawing, Arrangement& arrangement) const {
        constexpr double kSame = 1e-12;
        Rect& place = arrangement.place.drawing;
        if (std::abs(place.height * drawing.width - place.width * drawing.height) <= kSame * place.height * drawing.width) return;
        if (!beside_names_) {
            arrangement = arrange(sheet, drawing.width / drawing.height);
            return;
        }
        const double scale = std::min(place.width / drawing.width, place.height / drawing.height);
        place.width = scale * drawing.width;
        place.height = scale * drawing.height;
    }

    // The drawing for that place: the last one, if it is as large in mm and for the same medium.
    const Drawing& draw(const Sheet& sheet, Arrangement& arrangement) {
        constexpr double kSame = 1e-6;  // mm
        const Rect place = arrangement.place.drawing;
        if (std::abs(place.width - drawn_.width) > kSame || std::abs(place.height - drawn_.height) > kSame ||
            sheet.medium != drawn_medium_ || from_.made_for_sheet) {
            begin(JobStep::drawing);
            DrawingWay way;
            Drawing drawing = from_.draw(sheet, place, from_.part, from_.words, way);
            finer_ = way.finer, detail_ = std::move(way.detail);
            for (const Phrase& told : way.told) tell_once(to_act_on(told));
            fit_shape(sheet, drawing, arrangement);
            mended_ = mend_for(*sheet.medium, arrangement.place.drawing.width, std::move(drawing),
                               job_.chain.as_drawn || from_.made_for_sheet);
            // For the first layout; others differ in the needs of their media.
            if (outcome_.steps.empty()) outcome_.steps = std::move(way.steps), outcome_.chosen = std::move(way.chosen);
            if (outcome_.chart_json.empty()) outcome_.chart_json = std::move(way.chart_json);
            drawn_ = place;
            drawn_medium_ = sheet.medium;
        } else {
            fit_shape(sheet, mended_.drawing, arrangement);
        }
        return mended_.drawing;
    }

    // With the labels and the words of the picture, at their places for its size.
    Drawing named(Drawing drawing) const {
        std::vector<Name> names = names_on(drawing, job_.labels, from_.part);
        for (Name& name : from_.words.names_on(drawing, from_.part)) {
            name.optional = job_.words == WordsWish::automatic;
            names.push_back(std::move(name));
        }
        draw_near(names, drawing.width, drawing.height);
        std::move(drawing.names.begin(), drawing.names.end(), std::back_inserter(names));
        drawing.names = std::move(names);
        return drawing;
    }

    // Words of the picture that no page of braille has room for.
    void tell_left_out(const Page& page) {
        if (!page.left_out.empty()) tell_once(to_act_on(left_out_words(page.left_out, more_room_)));
        outcome_.words = without(page.left_out, from_.words.told);
    }

    // Even a smaller drawing has no room for its words. The layout then refuses words that the user asked for.
    void give_up_words() {
        if (job_.words != WordsWish::automatic || !from_.words.any_set()) return;
        from_.words = PrintWords{};
        for (ToldWords& one : outcome_.words) one.set = false;
        outcome_.notes = {to_act_on(no_room_for_words(from_.print_is_left, more_room_))};
        drawn_medium_ = nullptr;
    }

    // Braille is several times larger than the print it replaces, so the drawing may have to shrink, and to move.
    void make_room_for_words(Layout& layout, Arrangement& arrangement) {
        beside_names_ = (from_.words.any_set() || any_outside(job_.labels, from_.part)) && !layout.sheet.drawing_width;
        if (!beside_names_) return;
        const Rect whole = arrangement.place.drawing;
        const double aspect = whole.width / whole.height;
        drawn_medium_ = nullptr;
        // Drawn anew only for the first width, which is probably the best.
        const SizedDrawing sized{[&](double width) {
                                     return named({width, width / aspect, {}, {}, {}}).names;
                                 },
                                 [&](double width) {
                                     if (drawn_medium_ == nullptr) {
                                         Arrangement first = arrangement;
                                         first.place.drawing = {whole.left, whole.top, width, width / aspect};
                                         draw(layout.sheet, first);
                                     }
                                     return named(scaled_to(mended_.drawing, width));
                                 }};
        std::optional<RoomFound> found, tried;
        const auto left_out = [&] {
            tried = place_with_room(layout.sheet, aspect, sized);
            return tried ? tried->left_out : from_.words.told.size();
        };
        const std::size_t thinned = thin_out_for_room(from_.words.told, left_out, [&] { found = std::move(tried); });
        if (thinned > 0) outcome_.notes.push_back(to_act_on(thinned_words(thinned, more_room_)));
        beside_names_ = found.has_value();
        if (!found) give_up_words();
        arrangement = found ? std::move(found->arrangement) : arrange(layout.sheet, aspect);
    }

    Pages lay_out_one(const Sheet& sheet, Arrangement arrangement) {
        const Drawing drawing = named(draw(sheet, arrangement));
        check_places(job_.labels, drawing.width, drawing.height);
        begin(JobStep::laying_out);
        advise(sheet, mended_, finer_);
        Pages pages = pages_of(drawing, sheet, std::move(arrangement));
        tell_left_out(pages.whole());
        return pages;
    }

    // Pages that are not written are shown.
    bool shows(std::size_t layout) const {
        for (std::size_t i = 0; i < job_.outputs.size(); ++i)
            if (layout_of_[i] == layout && job_.outputs[i].path.empty()) return true;
        return false;
    }
    void show(std::size_t index, const Pages& pages) {
        if (!shows(index)) return;
        std::vector<Page>& shown = outcome_.layouts[index].shown;
        shown.push_back(pages.whole());
        for (const Page& each : pages.all)
            if (each.is_key) shown.push_back(each);
    }

    // Each file is on its way to the disk when it is encoded.
    void encode(std::size_t index, const std::vector<Page>& pages) {
        for (std::size_t i = 0; i < job_.outputs.size(); ++i) {
            if (layout_of_[i] != index) continue;
            const Output& output = job_.outputs[i];
            Made made{output, 0, index, 0, pages.size()};
            cut_.count(*output.format, job_.settings_of(*output.format), pages);
            made.heights = heights_to_tell(*output.format, pages.front());
            if (made.heights && (made.heights->used > 1 || detail_)) tell_once(explained(*made.heights, *output.format));
            if (output.format->untold != nullptr && !output.path.empty())
                tell_once(output.format->untold(job_.settings_of(*output.format)));
            if (output.path.empty() || output.bound) {
                made.page = 1;
                if (output.bound) outcome_.to_bind.push_back({i, pages});
                made_[i].push_back(made);
                continue;
            }
            if (from_.heights && output.format->encode_heights != nullptr) {
                encode_heights(output, outcome_.layouts[index].place.drawing.width, made);
                made_[i].push_back(made);
                continue;
            }
            const std::size_t count = count_files(*output.format, pages);
            check_page_files(output, count, taken_, real_disk());
            each_file(*output.format, pages, settings_for(job_, *output.format, outcome_.picture, kept_by(from_.recipe)),
                      [&](std::string_view bytes) {
                          made.output.path = path_of_page(output, ++made.page);
                          made.bytes = bytes.size();
                          if (count > 1) made.pages = 1;
                          made_[i].push_back(made);
                          files_.add(made.output.path, bytes);
                      });
        }
    }

    void tell_once(const Note& note) {
        if (!note.words.empty() && std::find(outcome_.notes.begin(), outcome_.notes.end(), note) == outcome_.notes.end())
            outcome_.notes.push_back(note);
    }

    // What has heights of its own.
    void encode_heights(const Output& output, double width, Made& made) {
        const HeightFile file = from_.heights(width);
        const std::string bytes = output.format->encode_heights(sheet_of(file.map, file.low, file.high), rows_of(file.map),
                                                                job_.settings_of(*output.format));
        made.page = made.pages = 1;
        made.bytes = bytes.size();
        files_.add(output.path, bytes);
    }

    // Together, so that a failing picture leaves no files; the first page gets its name last, on which is_up_to_date relies.
    void write() {
        for (std::size_t i = 0; i < made_.size(); ++i) {
            outcome_.made.insert(outcome_.made.end(), made_[i].begin(), made_[i].end());
            const std::size_t files = job_.outputs[i].path.empty() ? 0 : made_[i].size();
            if (const std::string path = left_over_behind(job_.outputs[i], files, taken_, real_disk()); !path.empty())
                outcome_.left_over.push_back(path);
        }
        if (!job_.save_recipe.empty() && !job_.recipe) files_.add(job_.save_recipe, to_text(from_.recipe));
        begin(JobStep::writing);
        if (watch_.gate == nullptr) return files_.take_names();
        const std::shared_lock lock(*watch_.gate);
        files_.take_names();
    }

    const Job& job_;
    const Watch& watch_;
    const std::set<std::string> none_ = {};
    const std::set<std::string>& taken_ = watch_.taken != nullptr ? *watch_.taken : none_;
    Outcome& outcome_;
    Phrase more_room_ = phrase("larger paper or {0} 2x1", spelled("tiles"));  // as the user would get it
    int from_right_ = 0;                                                      // outputs whose title is not printed
    std::vector<Arrangement> arranged_;                                       // for each layout
    std::vector<bool> stays_;                                                 // each is the page that was read
    std::vector<std::size_t> layout_of_;                                      // each output's
    std::vector<std::vector<Made>> made_;                                     // of each output
    CutCells cut_;
    NewFiles files_{job_.keep};
    Drawable from_;
    Mended mended_;
    Rect drawn_;
    const Medium* drawn_medium_ = nullptr;
    std::optional<DetailChoice> detail_;
    bool finer_ = false;         // more would be drawn on a larger sheet
    bool beside_names_ = false;  // the drawing stands where its names have room, on the layout that is being made
};

Outcome outcome_of(const Job& job, const Watch& watch, const std::function<Source(std::vector<Phrase>& notes)>& open) {
    const auto start = std::chrono::steady_clock::now();
    Outcome outcome;
    outcome.input = job.input;
    outcome.pdf_page = job.pdf_page;
    // The messages of a batch must say which picture they are about.
    Failure failure = failure_of(name_of_input(outcome), [&] {
        std::vector<Phrase> told;
        Source source = open(told);
        outcome.notes.assign(told.begin(), told.end());
        source.allowed = job.allowed;
        PageMaking(job, watch, outcome).run(std::move(source));
    });
    outcome.error = std::move(failure.text);
    outcome.fault = failure.fault;
    outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return outcome;
}

}  // namespace

Outcome make_pages(const Job& job, const Watch& watch) {
    return outcome_of(job, watch, [&](std::vector<Phrase>& notes) {
        return job.as_text ? open_source(job.input) : open_input(job.input, {page_of(job), page_wish(job).as_picture}, notes);
    });
}

Outcome make_pages(Source source, const Job& job, const Watch& watch) {
    return outcome_of(job, watch, [&](std::vector<Phrase>&) { return std::move(source); });
}

}  // namespace tactics
