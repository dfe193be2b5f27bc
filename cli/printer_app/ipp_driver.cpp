// SPDX-License-Identifier: Apache-2.0
#include "cli/printer_app/ipp_driver.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <mutex>
#include <set>

#include "cli/printer_app/printing.h"
#include "cli/verbs/ppd.h"
#include "tactics/error.h"

namespace tactics {

namespace {

// Of pages that come as pixels. Print in pictures is read at 300 dpi; a finger needs a tenth.
constexpr int kResolution = 300;  // dpi
constexpr double kSlip = 0.5;     // mm

int hundredths(double mm) { return static_cast<int>(std::lround(mm * 100)); }

// PAPPL keeps pointers for as long as it runs.
const char* kept(const std::string& word) {
    static std::mutex lock;
    static std::set<std::string> words;
    const std::lock_guard guard(lock);
    return words.insert(word).first->c_str();
}

// "iso_a4_210x297mm"; a paper that PWG 5101.1 does not name gets a name of ours.
std::string media_of(const Paper& paper) {
    const pwg_media_t* known = pwgMediaForSize(hundredths(paper.width), hundredths(paper.height));
    const std::string name = known == nullptr ? "" : known->pwg;
    if (!name.empty() && !name.starts_with("custom_")) return name;
    std::array<char, 80> text{};
    std::snprintf(text.data(), text.size(), "custom_%s_%gx%gmm", std::string(paper.name).c_str(), paper.width, paper.height);
    return text.data();
}

pappl_media_col_t sheet_of(const Paper& paper, int margin) {
    pappl_media_col_t sheet{};
    const std::string name = media_of(paper);
    papplCopyString(sheet.size_name, name.c_str(), sizeof sheet.size_name);
    sheet.size_width = hundredths(paper.width);
    sheet.size_length = hundredths(paper.height);
    sheet.left_margin = sheet.right_margin = sheet.top_margin = sheet.bottom_margin = margin;
    papplCopyString(sheet.source, "main", sizeof sheet.source);
    papplCopyString(sheet.type, "stationery", sizeof sheet.type);
    return sheet;
}

void offer_papers(const MachineDriver& driver, pappl_pr_driver_data_t& offered) {
    const int margin = hundredths(find_medium(driver.format->medium, driver.name).margin);
    offered.left_right = offered.bottom_top = margin;
    for (const Paper& paper : papers_of(driver)) {
        offered.media_ready[0] = offered.num_media == 0 ? sheet_of(paper, margin) : offered.media_ready[0];
        offered.media[offered.num_media++] = kept(media_of(paper));
    }
    offered.media_default = offered.media_ready[0];
    offered.num_source = offered.num_type = 1;
    offered.source[0] = "main";
    offered.type[0] = "stationery";
}

void offer_option(pappl_pr_driver_data_t& offered, const std::string& option, const std::set<std::string>& choices,
                  const std::string& fallback, ipp_t* attributes) {
    const std::string name = attribute_of(option);
    offered.vendor[offered.num_vendor++] = kept(name);
    const bool any = takes_any_words(option);
    if (!any) {
        std::vector<const char*> values;
        for (const std::string& choice : choices) values.push_back(choice.c_str());
        ippAddStrings(attributes, IPP_TAG_PRINTER, IPP_TAG_KEYWORD, (name + "-supported").c_str(),
                      static_cast<int>(values.size()), nullptr, values.data());
    }
    ippAddString(attributes, IPP_TAG_PRINTER, any ? IPP_TAG_TEXT : IPP_TAG_KEYWORD, (name + "-default").c_str(), nullptr,
                 fallback.c_str());
}

ipp_t* options_of(const MachineDriver& driver, pappl_pr_driver_data_t& offered) {
    const PpdWords words = words_of(driver);
    ipp_t* attributes = ippNew();
    for (const auto& [option, fallback] : own_options(words))
        if (offered.num_vendor < PAPPL_MAX_VENDOR - 1)
            offer_option(offered, option, words.choices.at(option), fallback, attributes);
    offer_option(offered, "TacticsLabels", {}, "", attributes);
    return attributes;
}

void describe_machine(const MachineDriver& driver, pappl_pr_driver_data_t& offered) {
    papplCopyString(offered.make_and_model, driver.people.c_str(), sizeof offered.make_and_model);
    offered.format = kMachineBytes;
    offered.ppm = 1;
    offered.kind = PAPPL_KIND_DOCUMENT | PAPPL_KIND_LARGE_FORMAT;
    offered.orient_default = IPP_ORIENT_NONE;
    offered.color_supported = PAPPL_COLOR_MODE_MONOCHROME;
    offered.color_default = PAPPL_COLOR_MODE_MONOCHROME;
    offered.content_default = PAPPL_CONTENT_AUTO;
    offered.quality_default = IPP_QUALITY_NORMAL;
    offered.scaling_default = PAPPL_SCALING_AUTO;
    offered.raster_types = PAPPL_PWG_RASTER_TYPE_BLACK_8 | PAPPL_PWG_RASTER_TYPE_SGRAY_8;
    offered.duplex = PAPPL_DUPLEX_NONE;
    offered.sides_supported = PAPPL_SIDES_ONE_SIDED;
    offered.sides_default = PAPPL_SIDES_ONE_SIDED;
    offered.num_resolution = 1;
    offered.x_resolution[0] = offered.y_resolution[0] = kResolution;
    offered.x_default = offered.y_default = kResolution;
}

std::string text_of(ipp_attribute_t* attribute) {
    if (attribute == nullptr) return "";
    if (const char* text = ippGetString(attribute, 0, nullptr)) return text;
    std::array<char, 1024> text{};
    ippAttributeString(attribute, text.data(), text.size());
    return text.data();
}

// The sizes that are offered are those of papers.
std::string page_size_of(const pappl_media_col_t& sheet) {
    for (const Paper& paper : papers())
        if (std::abs(sheet.size_width / 100.0 - paper.width) < kSlip &&
            std::abs(sheet.size_length / 100.0 - paper.height) < kSlip)
            return ppd_size_of(paper);
    return "";
}

}  // namespace

const char* kind_of_document(const unsigned char* bytes, std::size_t count, void*) {
    const std::string_view begin(reinterpret_cast<const char*>(bytes), count);
    using namespace std::string_view_literals;
    if (begin.starts_with("II*\0"sv) || begin.starts_with("MM\0*"sv)) return "image/tiff";
    const auto is_control = [](char c) {
        return static_cast<unsigned char>(c) < ' ' && c != '\n' && c != '\r' && c != '\t' && c != '\f';
    };
    if (begin.empty() || std::any_of(begin.begin(), begin.end(), is_control)) return nullptr;
    const auto first = begin.find_first_not_of("\xEF\xBB\xBF \t\r\n");
    return first != begin.npos && begin[first] == '<' && begin.find("<svg") != begin.npos ? "image/svg+xml" : "text/plain";
}

bool may_send_to(const std::string& device, const ServerWish& server) {
    if (device.empty()) return true;
    std::array<char, 32> scheme{};
    std::array<char, 256> user{}, host{}, resource{};
    int port = 0;
    const http_uri_status_t status =
        httpSeparateURI(HTTP_URI_CODING_ALL, device.c_str(), scheme.data(), scheme.size(), user.data(), user.size(), host.data(),
                        host.size(), &port, resource.data(), resource.size());
    // A path alone is taken for a file, with a warning.
    if (status < HTTP_URI_STATUS_OK || status == HTTP_URI_STATUS_MISSING_SCHEME) return false;
    const std::string_view way = scheme.data();
    if (way == "file") return server.to_files && geteuid() != 0;
    return way == "socket" || way == "usb" || way == "dnssd" || way == "snmp";
}

bool offer_driver(pappl_system_t* system, const char* name, const char* device, const char* id, pappl_pr_driver_data_t* offered,
                  ipp_t** attributes, void* data) {
    const std::string_view asked = name == nullptr ? "" : name, where = device == nullptr ? "" : device;
    const MachineDriver* driver = asked == "auto" ? driver_of_device(id == nullptr ? "" : id) : find_driver(asked);
    if (driver == nullptr) {
        papplLog(system, PAPPL_LOGLEVEL_ERROR, "There is no driver '%s'; tactics-printer-app drivers lists them.",
                 std::string(asked).c_str());
        return false;
    }
    if (!may_send_to(std::string(where), *static_cast<const ServerWish*>(data))) {
        papplLog(system, PAPPL_LOGLEVEL_ERROR,
                 "Bytes go to socket:, usb:, dnssd: and snmp: addresses, and to file: ones if a user's server runs with "
                 "-o file-devices=yes; not to '%s'.",
                 std::string(where).c_str());
        return false;
    }
    try {
        describe_machine(*driver, *offered);
        offer_papers(*driver, *offered);
        *attributes = options_of(*driver, *offered);
        add_printing(*offered);
        return true;
    } catch (const std::exception& error) {
        papplLog(system, PAPPL_LOGLEVEL_ERROR, "%s", error.what());
        return false;
    }
}

JobRequest request_of(pappl_job_t* job, bool is_text) {
    pappl_printer_t* printer = papplJobGetPrinter(job);
    const MachineDriver* driver = find_driver(papplPrinterGetDriverName(printer));
    if (driver == nullptr)
        throw Error(Fault::failed, papplPrinterGetDriverName(printer), phrase("there is no such driver any more"));
    JobRequest request;
    request.driver = driver->name;
    request.title = papplJobGetName(job);
    request.job.is_text = is_text;
    pappl_pr_options_t* chosen = papplJobCreatePrintOptions(job, 0, false);
    if (chosen == nullptr) throw Error(Fault::failed, "", phrase("there is not enough memory"));
    request.job.copies = chosen->copies;
    request.job.first_page = static_cast<int>(chosen->first_page);
    request.job.last_page = static_cast<int>(std::min(chosen->last_page, static_cast<unsigned>(PrintJob::kAllPages)));
    if (const std::string size = page_size_of(chosen->media); !size.empty()) request.options.emplace_back("PageSize", size);
    papplJobDeletePrintOptions(chosen);
    // PAPPL 1.3 looks for the printer's own defaults among the attributes of the job, and finds none.
    ipp_t* set = papplPrinterGetDriverAttributes(printer);
    std::vector<std::string> names{"TacticsLabels"};
    for (const auto& option : own_options(words_of(*driver))) names.push_back(option.first);
    for (const std::string& name : names) {
        const std::string attribute = attribute_of(name);
        if (ipp_attribute_t* known = ippFindAttribute(set, (attribute + "-default").c_str(), IPP_TAG_ZERO))
            request.defaults.emplace_back(name, text_of(known));
        if (ipp_attribute_t* known = papplJobGetAttribute(job, attribute.c_str()))
            request.options.emplace_back(name, text_of(known));
    }
    ippDelete(set);
    return request;
}

}  // namespace tactics
