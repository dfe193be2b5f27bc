// SPDX-License-Identifier: Apache-2.0
#include "cli/model_flags.h"

#include <string>
#include <string_view>

#include "cli/choice_value.h"
#include "tactics/error.h"
#include "tactics/readers/append_file.h"
#include "tactics/solid/fold_options.h"
#include "tactics/text/words.h"

namespace tactics {

namespace {

ModelView model_view_of(const Given& given) {
    constexpr ModelView kAll[] = {ModelView::fold_out, ModelView::views, ModelView::heights};
    const auto view = choice_value(given, "--model", {"fold-out", "views", "heights"});
    return view ? kAll[*view] : ModelView::automatic;
}

void set_one(Settings& settings, std::string_view word, const std::string& place) {
    const auto equals = word.find('=');
    if (equals == std::string_view::npos)
        throw Error(Fault::usage, place,
                    phrase("\"{0}\" is no setting; write SETTING=VALUE, as in tactics help model", word.substr(0, 80)));
    settings.set(word.substr(0, equals), word.substr(equals + 1), place, "fold-out");
}

// "Table/Top: fold=no flat=0.2". A colon belongs to the path where no = stands before it.
void take_words(FoldWish& wish, std::string_view text, const std::string& place) {
    std::string path;
    const auto colon = text.find(':');
    if (colon != std::string_view::npos && colon < text.find('=')) {
        path = text.substr(0, colon);
        text.remove_prefix(colon + 1);
    }
    Settings settings(fold_options());
    for (const std::string_view word : words_of(text)) set_one(settings, word, place);
    take_settings(wish, settings, path, place);
}

void take_reader(FoldWish& wish, const std::string& file) {
    std::string text;
    append_file(text, file);
    Settings settings(fold_options());
    int line = 0;
    for (std::string_view rest = text; !rest.empty();) {
        const auto end = std::min(rest.find('\n'), rest.size());
        std::string one;
        for (const char letter : rest.substr(0, end))
            if (letter != ' ' && letter != '\t' && letter != '\r') one += letter;
        rest.remove_prefix(std::min(end + 1, rest.size()));
        ++line;
        if (!one.empty() && one.front() != '#') set_one(settings, one, file + ":" + std::to_string(line));
    }
    take_settings(wish, settings, "", file);
}

// Objects are distinguished only where they are drawn; which way is up matters to heights, too.
bool asks_for_objects(const Given& given, const char* flag) {
    if (flag != std::string_view("--fold")) return given.has(flag);
    for (const std::string& text : given.all(flag))
        for (const std::string_view word : words_of(text))
            if (!word.starts_with("up=")) return true;
    return false;
}

}  // namespace

ModelDrawingWish model_wish(const Given& given) {
    ModelDrawingWish wish;
    wish.view = model_view_of(given);
    wish.fold.part = given.value("--object");
    for (const char* of_objects : {"--object", "--fold", "--reader"}) {
        if (!asks_for_objects(given, of_objects)) continue;
        if (wish.view == ModelView::heights)
            throw Error(Fault::usage, of_objects,
                        phrase("does nothing with --model heights, which has no objects; leave one of them out"));
        if (wish.view == ModelView::automatic) wish.view = ModelView::fold_out;
    }
    if (given.has("--reader")) take_reader(wish.fold, given.value("--reader"));
    int number = 0;
    for (const std::string& text : given.all("--fold")) take_words(wish.fold, text, "--fold " + std::to_string(++number));
    if (wish.fold.section > 0 && wish.view != ModelView::views)
        throw Error(Fault::usage, "--fold", phrase("section is a setting of --model views; add that, or leave it out"));
    return wish;
}

}  // namespace tactics
