// SPDX-License-Identifier: Apache-2.0
#include "cli/labels.h"

#include <filesystem>

#include "cli/named_subject.h"
#include "tactics/error.h"
#include "tactics/text/words.h"

namespace tactics {

namespace {

// The file of labels for a picture; empty: none.
std::string file_for(const std::string& labels, const std::string& picture, const Disk& disk) {
    if (!disk.is_folder(labels)) return labels;
    const std::string file = (std::filesystem::path(labels) / (stem_of(picture) + ".labels")).string();
    return disk.exists(file) ? file : "";
}

std::vector<PlacedWords> said_labels(const Given& given) {
    std::vector<PlacedWords> labels;
    const auto& words = given.all("--label");
    if (words.size() > kMostLabels)
        throw Error(Fault::usage, "--label", phrase("these are over 1000 labels, more than a page has room for"));
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string origin = "--label " + std::to_string(i + 1);
        const std::string_view word = words[i];
        const auto equals = word.find('=');
        if (equals == std::string_view::npos)
            throw Error(
                Fault::usage, origin,
                phrase("\"{0}\" is no label; write X,Y=WORDS, for example \"30%,40%=City Park\"", words[i].substr(0, 80)));
        labels.push_back(label_of(word.substr(0, equals), trimmed(word.substr(equals + 1)), origin));
    }
    return labels;
}

}  // namespace

void plan_labels(std::vector<Item>& items, const Given& given, const Disk& disk) {
    const std::vector<PlacedWords> said = said_labels(given);
    const std::string from = given.value("--labels");
    if (given.has("--labels") && !disk.is_folder(from) && items.size() > 1)
        throw Error(
            Fault::usage, "--labels",
            phrase("{0} would label every picture alike; name a folder with a file for each, such as map.labels for map.png",
                   from));
    if (given.has("--bare") && (given.has("--label") || given.has("--labels")))
        throw Error(Fault::usage, "--bare", phrase("the drawing alone has no labels; leave out --bare or the labels"));
    const SubjectWish wish = subject_value(given);
    for (Item& item : items) {
        item.labels = said;
        item.wish = wish;
        if (!given.has("--labels")) continue;
        item.label_file = file_for(from, item.input, disk);
        if (item.label_file.empty()) continue;
        const std::string text = disk.read_text(item.label_file);
        for (PlacedWords& label : parse_labels(text, item.label_file)) item.labels.push_back(std::move(label));
        item.wish = parse_subject(text, item.label_file, std::move(item.wish));
    }
}

}  // namespace tactics
