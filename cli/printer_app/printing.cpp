// SPDX-License-Identifier: Apache-2.0
#include "cli/printer_app/printing.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstring>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "cli/printer_app/ipp_driver.h"
#include "cli/printer_app/job_child.h"
#include "cli/verbs/wrong_machine.h"
#include "print/png_file.h"
#include "tactics/error.h"
#include "tactics/readers/append_file.h"
#include "tactics/transport/descriptor.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr std::uint64_t kMostPixels = 400'000'000;  // A3 at 600 dpi has 70 million

Descriptor readable(int file) {
    if (file < 0) throw Error(Fault::failed, "", phrase("the document of the job cannot be read"));
    return Descriptor(file);
}

// Nothing is thrown into PAPPL, which is C; the message is shown with the job.
template <class Work>
bool guarded(pappl_job_t* job, const Work& work) {
    try {
        work();
        return true;
    } catch (const std::exception& error) {
        papplLogJob(job, PAPPL_LOGLEVEL_ERROR, "%s", error.what());
        papplJobSetMessage(job, "%s", error.what());
        papplJobSetReasons(job, PAPPL_JREASON_DOCUMENT_UNPRINTABLE_ERROR, PAPPL_JREASON_NONE);
        return false;
    }
}

// PAPPL waits a minute for jobs when it is told to end, and then takes away what they still use.
std::atomic<bool> server_ends{false};
static_assert(std::atomic<bool>::is_always_lock_free);
struct sigaction before_ours {};

void note_the_end(int signal) {
    server_ends = true;
    if (before_ours.sa_handler != SIG_DFL && before_ours.sa_handler != SIG_IGN) before_ours.sa_handler(signal);
}

// PAPPL has set its own handler when the first job comes.
void watch_for_the_end() {
    static std::once_flag once;
    std::call_once(once, [] {
        struct sigaction ours {};
        ours.sa_handler = note_the_end;
        sigaction(SIGTERM, &ours, &before_ours);
    });
}

bool is_cancelled(pappl_job_t* job) { return server_ends || papplJobIsCanceled(job); }

enum class CountsSheets : bool { no, yes };  // PAPPL itself counts those of a raster

std::string converted(pappl_job_t* job, const JobRequest& request, int document, CountsSheets counts) {
    JobWatch watch;
    watch.note = [&](std::string_view note) { papplLogJob(job, PAPPL_LOGLEVEL_INFO, "%s", std::string(note).c_str()); };
    watch.sheet = [&] {
        if (counts == CountsSheets::yes) papplJobSetImpressionsCompleted(job, 1);
    };
    watch.is_cancelled = [&] { return is_cancelled(job); };
    watch_for_the_end();
    return convert_job(request, document, watch);
}

[[noreturn]] void refuse_device() {
    throw Error(Fault::failed, "", phrase("the embosser takes no more bytes; see whether it is on, and has paper"));
}

void send_all(pappl_device_t* device, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t sent = papplDeviceWrite(device, bytes.data(), std::min<std::size_t>(bytes.size(), 65536));
        if (sent <= 0) refuse_device();
        bytes.remove_prefix(static_cast<std::size_t>(sent));
    }
}

std::size_t taken_by(pappl_device_t* device) {
    pappl_devmetrics_t metrics{};
    papplDeviceGetMetrics(device, &metrics);
    return metrics.write_bytes;
}

// A job that is cancelled ends after a sheet, and with the bytes that end a job: a machine must not wait for the rest of one.
void send(pappl_job_t* job, pappl_device_t* device, const Queue& queue, std::string_view bytes) {
    const Embosser& embosser = *queue.embosser->embosser;
    const Punched punched = embosser.punch(bytes, queue.wishes.settings.front().second);
    const std::size_t taken = taken_by(device);
    std::size_t sent = 0;
    for (const PunchedSheet& sheet : punched.sheets) {
        if (is_cancelled(job)) break;
        send_all(device, bytes.substr(sent, sheet.end - sent));
        sent = sheet.end;
    }
    std::string rest(bytes.substr(sent));
    if (is_cancelled(job))
        rest = sent == 0 ? "" : bytes.substr(punched.job_end_begin, punched.job_end_end - punched.job_end_begin);
    if (sent + rest.size() > 0) rest += packet_end(embosser.packet, sent + rest.size());
    send_all(device, rest);
    papplDeviceFlush(device);
    // Up to 8 kB are written only then, and PAPPL keeps to itself what becomes of them.
    if (taken_by(device) - taken != sent + rest.size()) refuse_device();
}

bool print_bytes(pappl_job_t* job, pappl_pr_options_t* options, pappl_device_t* device) {
    return guarded(job, [&] {
        const Queue queue = queue_of(request_of(job, false));
        std::string bytes;
        append_file(bytes, papplJobGetFilename(job));
        refuse_wrong_machine(papplJobGetName(job), bytes, *queue.embosser, queue.wishes.settings.front().second);
        for (int copy = 0; copy < std::max(1, options->copies) && !is_cancelled(job); ++copy) send(job, device, queue, bytes);
    });
}

// Pages that a client made into pixels, each of which is converted when its last row has come.
struct RasterJob {
    JobRequest request;
    Queue queue;
    std::unique_ptr<PngFile> page = nullptr;
    std::vector<std::uint8_t> row = {};
    std::string bytes = {};
    int pages = 0, copies = 1;
    bool has_labels = false;
};

RasterJob& raster_of(pappl_job_t* job) { return *static_cast<RasterJob*>(papplJobGetData(job)); }

bool begin_raster(pappl_job_t* job, pappl_pr_options_t*, pappl_device_t*) {
    return guarded(job, [&] {
        auto raster = std::make_unique<RasterJob>();
        raster->request = request_of(job, false);
        PrintJob& pages = raster->request.job;
        pages.first_page = pages.last_page = 1;
        raster->copies = std::max(1, std::exchange(pages.copies, 1));  // of all pages, when they are there
        raster->queue = queue_of(raster->request);
        papplJobSetData(job, raster.release());
    });
}

bool begin_page(pappl_job_t* job, pappl_pr_options_t* options, pappl_device_t*, unsigned) {
    return guarded(job, [&] {
        const auto& header = options->header;
        if (header.cupsBitsPerPixel != 8 || std::uint64_t{header.cupsWidth} * header.cupsHeight > kMostPixels)
            throw Error(Fault::failed, "", phrase("the page has too many pixels, or other than 256 levels of grey"));
        RasterJob& raster = raster_of(job);
        if (++raster.pages > 1 && !raster.queue.labels.empty())
            throw Error(Fault::usage, "tactics-label",
                        phrase("labels are for a job of one page; print the page alone, or leave them out"));
        raster.page = std::make_unique<PngFile>(header.cupsWidth, header.cupsHeight, 8);
        constexpr double kMmPerMetre = 1000;
        raster.page->scale(header.HWResolution[0] / kMmPerInch * kMmPerMetre, header.HWResolution[1] / kMmPerInch * kMmPerMetre);
        raster.row.assign(std::size_t{header.cupsWidth} + 1, 0);
    });
}

bool take_row(pappl_job_t* job, pappl_pr_options_t* options, pappl_device_t*, unsigned, const unsigned char* pixels) {
    return guarded(job, [&] {
        RasterJob& raster = raster_of(job);
        std::memcpy(raster.row.data() + 1, pixels, raster.row.size() - 1);
        if (options->header.cupsColorSpace == CUPS_CSPACE_K)
            for (std::size_t x = 1; x < raster.row.size(); ++x) raster.row[x] = static_cast<std::uint8_t>(255 - raster.row[x]);
        raster.page->add_row(raster.row);
    });
}

bool end_page(pappl_job_t* job, pappl_pr_options_t*, pappl_device_t*, unsigned) {
    return guarded(job, [&] {
        RasterJob& raster = raster_of(job);
        const std::string picture = raster.page->finish();
        raster.page = nullptr;
        const Descriptor file = readable(memfd_create("page", MFD_CLOEXEC));
        if (write(file.number(), picture.data(), picture.size()) != static_cast<ssize_t>(picture.size()) ||
            lseek(file.number(), 0, SEEK_SET) != 0)
            throw Error(Fault::failed, "", phrase("there is not enough memory for the page"));
        raster.bytes += converted(job, raster.request, file.number(), CountsSheets::no);
        if (raster.bytes.size() > kMostJobBytes)
            throw Error(Fault::failed, "", phrase("the job has more pages than an embosser could make"));
    });
}

bool end_raster(pappl_job_t* job, pappl_pr_options_t*, pappl_device_t* device) {
    const std::unique_ptr<RasterJob> raster(&raster_of(job));
    papplJobSetData(job, nullptr);
    return guarded(job, [&] {
        for (int copy = 0; copy < raster->copies && !is_cancelled(job); ++copy) send(job, device, raster->queue, raster->bytes);
    });
}

bool ask_status(pappl_printer_t*) { return true; }

void identify(pappl_printer_t*, pappl_identify_actions_t, const char*) {}  // nothing on it can be made to blink

}  // namespace

void add_printing(pappl_pr_driver_data_t& driver) {
    driver.printfile_cb = print_bytes;
    driver.rstartjob_cb = begin_raster;
    driver.rstartpage_cb = begin_page;
    driver.rwriteline_cb = take_row;
    driver.rendpage_cb = end_page;
    driver.rendjob_cb = end_raster;
    driver.status_cb = ask_status;
    driver.identify_cb = identify;
}

bool print_document(pappl_job_t* job, pappl_device_t* device, void*) {
    return guarded(job, [&] {
        const JobRequest request = request_of(job, std::strcmp(papplJobGetFormat(job), "text/plain") == 0);
        const Queue queue = queue_of(request);  // what is wrong with the options is said before anything is read
        const Descriptor document = readable(open(papplJobGetFilename(job), O_RDONLY | O_CLOEXEC));
        const std::string bytes = converted(job, request, document.number(), CountsSheets::yes);
        send(job, device, queue, bytes);
    });
}

}  // namespace tactics
