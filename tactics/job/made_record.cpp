// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/made_record.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>

#include "tactics/error.h"
#include "tactics/job/page_files.h"
#include "tactics/text/number.h"
#include "tactics/text/utf8.h"
#include "tactics/transport/file.h"

namespace tactics {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostBytes = 1 << 24;  // of a record; a batch that is bound into one file has a line for each picture
constexpr std::string_view kFiles = "files", kMark = "file ";  // and its number
constexpr std::string_view kRules = "rules", kKept = "kept";

fs::path record_path(const Output& output) {
    const fs::path path(output.path);
    return path.parent_path() / kRecordFolder / path.filename();
}

std::string text_of_record(const std::string& path, std::size_t most) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rbe"), std::fclose);
    std::string bytes;
    if (!file) return bytes;
    bytes.resize(most);
    bytes.resize(std::fread(bytes.data(), 1, bytes.size(), file.get()));
    return bytes;
}

using Values = std::map<std::string_view, std::string_view>;

Values by_name(const MadeWith& with) {
    Values values;
    for (const auto& [name, value] : with) values.emplace(name, value);
    return values;
}

}  // namespace

std::string mark_of_file(const std::string& path) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rbe"), std::fclose);
    if (!file) return "missing";
    std::uint64_t mark = 0xcbf29ce484222325u, length = 0;
    char block[1 << 14];
    for (std::size_t count = 0; (count = std::fread(block, 1, sizeof block, file.get())) > 0; length += count)
        for (std::size_t i = 0; i < count; ++i) mark = (mark ^ static_cast<unsigned char>(block[i])) * 0x100000001b3u;
    char text[64];
    std::snprintf(text, sizeof text, "%llu bytes %016llx", static_cast<unsigned long long>(length),
                  static_cast<unsigned long long>(mark));
    return text;
}

std::optional<MadeWith> made_with(const MadeWith& settings, const Item& item, const Output& output) {
    std::error_code fault;
    const auto size = fs::file_size(item.input, fault);
    if (fault) return std::nullopt;
    const auto time = fs::last_write_time(item.input, fault);
    if (fault) return std::nullopt;
    const fs::path whole = fs::absolute(item.input, fault).lexically_normal();
    MadeWith with{{"picture", to_line(whole.string()) + ", " + std::to_string(size) + " bytes of " +
                                  std::to_string(time.time_since_epoch().count())},
                  {"format", std::string(output.format->name)}};
    if (!item.label_file.empty()) with.emplace_back("labels", mark_of_file(item.label_file));
    for (const auto& [name, value] : settings) with.emplace_back(to_line(name), to_line(value));
    return with;
}

std::optional<MadeWith> made_with(const MadeWith& settings, std::span<const Item> items, const Output& output) {
    MadeWith all{{"format", std::string(output.format->name)}};
    for (std::size_t i = 0; i < items.size(); ++i) {
        const auto own = made_with({}, items[i], output);
        if (!own) return std::nullopt;
        for (const auto& [name, value] : *own)
            if (name != "format") all.emplace_back(name + " " + std::to_string(i + 1), value);
    }
    for (const auto& [name, value] : settings) all.emplace_back(to_line(name), to_line(value));
    return all;
}

std::optional<Record> record_of(const Output& output) {
    const std::string text = text_of_record(record_path(output).string(), kMostBytes);
    Record record;
    for (std::string_view rest = text; !rest.empty();) {
        const auto end = rest.find('\n');
        if (end == std::string_view::npos) return std::nullopt;  // cut off
        const std::string_view line = rest.substr(0, end);
        const auto tab = line.find('\t');
        if (tab == std::string_view::npos) return std::nullopt;
        const std::string name(line.substr(0, tab)), value(line.substr(tab + 1));
        rest.remove_prefix(end + 1);
        if (name.starts_with(kMark)) {
            record.marks.push_back(value);
            continue;
        }
        if (name == kRules) {
            record.keeps_rules = value == kKept;
            continue;
        }
        if (name != kFiles) {
            record.with.emplace_back(name, value);
            continue;
        }
        const auto files = parse_number(value);
        if (!rest.empty() || !files || *files < 1 || *files > 1e6) return std::nullopt;
        record.files = static_cast<std::size_t>(*files);
    }
    if (record.files == 0 || record.marks.size() != record.files) return std::nullopt;
    return record;
}

void keep_record(const Output& output, const Record& record, bool new_folder) {
    std::error_code fault;
    const fs::path path = record_path(output);
    if (output.path.empty() || !fs::is_regular_file(output.path, fault)) return;  // standard output, a device
    if (!fs::is_directory(path.parent_path(), fault) && (!new_folder || !fs::create_directory(path.parent_path(), fault))) {
        // Another thread may have made it meanwhile.
        if (!new_folder || !fs::is_directory(path.parent_path(), fault)) return;
    }
    std::string text;
    for (const auto& [name, value] : record.with) text.append(name).append("\t").append(value).append("\n");
    for (std::size_t file = 1; file <= record.files; ++file)
        text.append(kMark)
            .append(std::to_string(file))
            .append("\t")
            .append(mark_of_file(path_of_page(output, file)))
            .append("\n");
    if (record.keeps_rules) text.append(kRules).append("\t").append(kKept).append("\n");
    text.append(kFiles).append("\t").append(std::to_string(record.files)).append("\n");
    try {
        NewFiles files(Keep::by_system);
        files.add(path.string(), text);
        files.take_names();
    } catch (const Error&) {
        fs::remove(path, fault);  // an older one would tell what is no longer so
    }
}

namespace {

std::string name_and(const std::string& value, const std::string& name) { return value.empty() ? name : name + " " + value; }

}  // namespace

std::vector<Phrase> differences(const MadeWith& before, const MadeWith& now) {
    std::vector<Phrase> told;
    const Values earlier = by_name(before), later = by_name(now);
    for (const auto& [name, value] : now) {
        const auto was = earlier.find(name);
        if (was != earlier.end() && was->second == value) continue;
        if (name == "picture")
            told.emplace_back(phrase("the picture is another"));
        else if (name == "labels")
            told.emplace_back(phrase("its labels are others"));
        else if (name.starts_with("picture ") || name.starts_with("labels "))
            told.push_back(was == earlier.end() ? phrase("{0} is new", name) : phrase("{0} is another", name));
        else
            told.push_back(was == earlier.end() ? phrase("{0} is new", name_and(value, name))
                                                : phrase("{0}, was {1}", name_and(value, name), was->second));
    }
    for (const auto& [name, value] : before)
        if (later.count(name) == 0)
            told.push_back(name == "labels"    ? phrase("its labels are gone")
                           : name == "picture" ? phrase("it was made of one picture")
                           : name.starts_with("picture ") || name.starts_with("labels ")
                               ? phrase("{0} is gone", name)
                               : phrase("{0} is gone", name_and(value, name)));
    return told;
}

}  // namespace tactics
