// SPDX-License-Identifier: Apache-2.0
// `tactics emboss`: files sent to an embosser.
#include <algorithm>
#include <chrono>
#include <cmath>

#include "cli/command.h"
#include "cli/embosser_flags.h"
#include "cli/interrupt_count.h"
#include "cli/report/say.h"
#include "cli/request.h"
#include "cli/verbs/job_end.h"
#include "cli/verbs/wrong_machine.h"
#include "print/embosser.h"
#include "print/format.h"
#include "print/text_pages.h"
#include "tactics/error.h"
#include "tactics/readers/append_file.h"
#include "tactics/text/json.h"
#include "tactics/text/utf8.h"
#include "tactics/transport/channels.h"
#include "tactics/transport/child.h"
#include "tactics/transport/devices.h"
#include "tactics/transport/file.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr Flag kEmbossFlags[] = {
    {"--to", "-t", "ADDRESS",
     "where to send: queue:NAME, tcp:HOST[:PORT], /dev/usb/lp0, usb: (the only USB printer; or usb:VID:PID[:SERIAL], "
     "usb:BUS-PORT), /dev/ttyUSB0@9600 (append ,xonxoff or ,none for a line without RTS and CTS), or a file; see tactics "
     "devices",
     false, "files"},
    {"--embosser", "-e", "NAME", "the machine that the files were written for; needed to count pages and for --from-page", false,
     "embossers"},
    {"--set", "-s", "NAME.OPTION=VALUE", "a setting of the machine, as given to convert. May be given several times", true,
     "settings"},
    {"--paper", "-p", "PAPER", "the sheet for text files (.brf), with --embosser; default: what convert uses for the machine",
     false, "papers"},
    {"--from-page", "", "NUMBER", "begin with this page, to resume a job that ended early", false, ""},
    {"--wait", "", "SECONDS", "how long the machine may accept nothing, with or without paper, before the job ends; default: 300",
     false, ""},
    {"--any-device", "", "", "send even to a printer whose id matches no known embosser", false, ""},
    {"--quiet", "-q", "", "say nothing but errors", false, ""},
    {"--json", "", "", "report how the job ended on standard output, as a JSON object", false, ""},
};

// Ctrl-C ends the job after the current page, a second one at once.
DeliveryWish::Cancel cancel_by_key() {
    const int count = interrupts();
    return count == 0 ? DeliveryWish::Cancel::no : count == 1 ? DeliveryWish::Cancel::behind_page : DeliveryWish::Cancel::at_once;
}

// Refuses files that are neither text nor embosser bytes, before a machine punches them letter by letter.
void refuse_others(const std::string& name, std::string_view bytes, const Format* format) {
    bytes = bytes.substr(0, 16);
    if (bytes.starts_with("\x89PNG")) {
        if (format != nullptr && format->name == "viewplus") return;
        throw Error(Fault::usage, name,
                    phrase("is a picture: if convert wrote it for a ViewPlus, add --embosser viewplus; else first tactics "
                           "convert {0} -o index-v4:page.prn, for example",
                           name));
    }
    if (bytes.starts_with("<?xml") || bytes.starts_with("<pef"))
        throw Error(Fault::usage, name,
                    phrase("is XML (SVG, PEF), which no embosser takes as it is; convert the drawing for the machine: -o "
                           "index-v4:page.prn, for example"));
    for (const std::string_view start : {"%PDF", "\xFF\xD8\xFF", "GIF8", "II*", "MM", "<svg", "RIFF", "BM"})
        if (bytes.starts_with(start) && (start != "MM" || bytes.substr(2, 2) == std::string_view("\0*", 2)) &&
            (start != "BM" || bytes.find('\0') != std::string_view::npos))
            throw Error(
                Fault::usage, name,
                phrase(
                    "is a picture, which no embosser takes as it is; first tactics convert {0} -o index-v4:page.prn, for example",
                    name));
}

// The job, and where its pages end.
struct EmbossJob {
    std::string bytes;
    std::vector<std::size_t> files;  // where each ends
    std::vector<std::size_t> pages;
    std::string end;         // the bytes that end a job of the machine, sent if it is cancelled after a page
    std::size_t packet = 0;  // of the machine
    std::size_t first = 0;   // pages before it, which are left out
    bool by_driver = false;  // they are pictures that the machine's own driver raises dots from
};

EmbossJob job_of(const Given& given) {
    const Format* format = machine_of(given, MachineKinds::embossers);
    const auto is_text = [](const std::string& name) { return ending_size(*find_format("brf"), name) > 0; };
    for (const std::string_view flag : {"--set", "--paper"})
        if (format == nullptr && given.has(flag))
            throw Error(
                Fault::usage, flag,
                phrase(
                    "no machine is named that it would be for, so this would do nothing; add --embosser NAME, or leave it out"));
    if (given.has("--paper") && std::none_of(given.words.begin(), given.words.end(), is_text))
        throw Error(Fault::usage, "--paper",
                    phrase("no file is text (.brf) that would be set on it, so this would do nothing; leave it out"));
    const Settings settings = format == nullptr ? Settings({}) : embosser_settings(*format, given);
    const Paper paper = sheet_in(given, format, settings);
    EmbossJob job;
    job.by_driver = format != nullptr && format->name == "viewplus";
    for (const std::string& name : given.words) {
        const std::size_t begin = job.bytes.size();
        append_file(job.bytes, name);
        if (format != nullptr && is_text(name))
            job.bytes.replace(begin, std::string::npos,
                              text_for(std::string_view(job.bytes).substr(begin), *format, settings, paper, name));
        if (name != "-") refuse_others(name, std::string_view(job.bytes).substr(begin), format);
        if (format != nullptr && !is_text(name) && !job.by_driver)
            refuse_wrong_machine(name, std::string_view(job.bytes).substr(begin), *format, settings);
        job.files.push_back(job.bytes.size());
    }
    const auto from = static_cast<std::size_t>(number_value(given, "--from-page", 1, 1, 1e6, true));
    if (format == nullptr) {
        if (from > 1) throw Error(Fault::usage, "--from-page", phrase("where pages begin is known with --embosser NAME only"));
        return job;
    }
    const Punched punched = format->embosser->punch(job.bytes, settings);
    for (const PunchedSheet& sheet : punched.sheets) job.pages.push_back(sheet.end);
    job.end = job.bytes.substr(punched.job_end_begin, punched.job_end_end - punched.job_end_begin);
    if (from > job.pages.size())
        throw Error(Fault::usage, "--from-page", phrase("there are {0} pages", std::to_string(job.pages.size())));
    if (from > 1) {
        // What last set the machine up, then that page.
        const PunchedSheet& first = punched.sheets[from - 1];
        const std::string set_up =
            first.set_up_begin >= first.begin ? "" : job.bytes.substr(first.set_up_begin, first.set_up_end - first.set_up_begin);
        const std::size_t left_out = first.begin - set_up.size();
        job.bytes.replace(0, first.begin, set_up);
        job.first = from - 1;
        job.pages.erase(job.pages.begin(), job.pages.begin() + static_cast<std::ptrdiff_t>(from - 1));
        for (std::size_t& end : job.pages) end -= left_out;
    }
    job.packet = format->embosser->packet;
    job.bytes += packet_end(job.packet, job.bytes.size());
    return job;
}

void ask_lp(const std::string& queue, std::vector<std::string> words, std::string_view input) {
    words.insert(words.begin(), {"lp", "-d", queue, "-t", "tactics"});
    const ChildAnswer answer = run_child(words, input, {std::chrono::minutes{10}, 1u << 20});
    if (answer.end == ChildAnswer::End::missing)
        throw Error(Fault::failed, "lp", phrase("is not installed; install cups-client, or send to the device itself"));
    if (answer.end != ChildAnswer::End::done)
        throw Error(Fault::failed, "queue:" + queue,
                    answer.err.empty()
                        ? phrase("lp did not take the job; look at lpstat -p {0}, or see tactics devices for the names", queue)
                        : phrase("lp did not take the job: {0}; look at lpstat -p {1}, or see tactics devices for the names",
                                 to_line(answer.err), queue));
}

// Bytes are sent unchanged, except for a picture from which the queue's own driver makes dots.
Delivery send_to_queue(const std::string& queue, const EmbossJob& job) {
    if (job.by_driver) {
        std::size_t begin = 0;
        for (const std::size_t end : job.files) {
            ask_lp(queue, {"-o", "ppi=20"}, std::string_view(job.bytes).substr(begin, end - begin));
            begin = end;
        }
    } else {
        ask_lp(queue, {"-o", "raw"}, job.bytes);
    }
    return {Ending::done, job.bytes.size(), ""};
}

void refuse_stranger(const Given& given, const std::string& place, const std::string& id) {
    if (!given.has("--any-device") && !id.empty() && taken_for(id).empty())
        throw Error(Fault::usage, place,
                    phrase("is no embosser known here but \"{0}\"; if it is one, add --any-device", id.substr(0, 120)));
}

std::unique_ptr<Channel> open_channel(const Address& address, const Given& given) {
    switch (address.kind) {
        case Address::Kind::tcp: return open_tcp(address.name, address.port);
        case Address::Kind::serial: return open_serial(address.name, address.baud, address.flow);
        case Address::Kind::usb:
            return open_usb(address.name, [&](const std::string& id) {
                refuse_stranger(given, address.name.empty() ? "usb" : "usb:" + address.name, id);
            });
        default: break;
    }
    refuse_stranger(given, address.name, printer_id(address.name, ""));
    return open_usblp(address.name);
}

std::string name_of_emboss(Ending ending) {
    switch (ending) {
        case Ending::done: return "done";
        case Ending::paper_out: return "paper-out";
        case Ending::stalled: return "stalled";
        case Ending::gone: return "gone";
        case Ending::cancelled: return "cancelled";
        case Ending::failed: return "failed";
    }
    return "";
}

int exit_code_of(Ending ending) {
    switch (ending) {
        case Ending::done: return 0;
        case Ending::paper_out: return 4;
        case Ending::gone: return 5;
        case Ending::stalled: return 6;
        case Ending::cancelled: return 7;
        case Ending::failed: break;
    }
    return 2;
}

Phrase words_for(Ending ending, const std::string& why) {
    switch (ending) {
        case Ending::paper_out: return phrase("the machine is out of paper");
        case Ending::stalled:
            return phrase(
                "the machine takes nothing; look whether it is switched to ready, and on a serial line whether speed "
                "and flow are its own");
        case Ending::gone: return phrase("the machine is gone: unplugged, switched off or out of the network");
        case Ending::cancelled: return phrase("cancelled");
        default: return why;
    }
}

Phrase accepted_line(const EmbossJob& job, std::size_t accepted) {
    Phrase line = phrase("{0} of {1} bytes accepted", std::to_string(accepted), std::to_string(job.bytes.size()));
    if (job.pages.empty()) return line;
    const std::size_t complete = pages_within(job.pages, accepted), all = job.first + job.pages.size();
    line = complete == 0 ? phrase("{0}, no page complete", std::move(line))
                         : phrase("{0}, page {1} of {2} complete", std::move(line), std::to_string(job.first + complete),
                                  std::to_string(all));
    if (accepted < job.bytes.size() && complete < job.pages.size())
        line = phrase("{0}; go on with --from-page {1}", std::move(line), std::to_string(job.first + complete + 1));
    return line;
}

// The rest to send after that many bytes.
std::string job_end(const EmbossJob& job, std::size_t accepted) {
    return job.end + std::string(packet_end(job.packet, accepted + job.end.size()));
}

// To a machine that answers. `place` is its name for messages.
Delivery deliver_to(const Address& address, const std::string& place, const EmbossJob& job, std::chrono::milliseconds patience,
                    const Given& given) {
    const auto channel = open_channel(address, given);
    count_interrupts();
    DeliveryWish wish;
    wish.patience = patience;
    wish.pages = job.pages;
    wish.cancel = cancel_by_key;
    std::size_t told = 0;
    wish.tell = [&](std::size_t accepted, std::optional<Ending> trouble) {
        const std::size_t complete = pages_within(job.pages, accepted);
        if (given.has("--quiet")) return;
        if (trouble)
            say(*trouble == Ending::paper_out
                    ? phrase("{0}: {1}; put paper in, the job goes on by itself", place, words_for(*trouble, ""))
                    : phrase("{0}: {1}", place, words_for(*trouble, "")));
        else if (complete > told && complete < job.pages.size())
            say(phrase("{0}: page {1} of {2} accepted", place, std::to_string(job.first + complete),
                       std::to_string(job.first + job.pages.size())));
        told = complete;
    };
    Delivery delivery = deliver(*channel, job.bytes, wish);
    // The machine is left as after a whole job. The page is complete, so nothing is sent twice.
    if (delivery.ending == Ending::cancelled && std::binary_search(job.pages.begin(), job.pages.end(), delivery.accepted))
        if (const Phrase why = end_job(*channel, job_end(job, delivery.accepted),
                                       [] { return cancel_by_key() == DeliveryWish::Cancel::at_once; });
            !why.empty())
            say(phrase("tactics: {0}: {1}", place, why));
    return delivery;
}

std::string json_of_emboss(const Delivery& delivery, const EmbossJob& job, const std::string& to) {
    JsonAnswer json;
    json.add("to", to);
    json.add("ending", name_of_emboss(delivery.ending));
    json.add("accepted", static_cast<double>(delivery.accepted));
    json.add("bytes", static_cast<double>(job.bytes.size()));
    if (!job.pages.empty()) {
        json.add("pages", static_cast<double>(job.first + job.pages.size()));
        json.add("pages_complete", static_cast<double>(job.first + pages_within(job.pages, delivery.accepted)));
    }
    return json.text() + "\n";
}

int run_emboss(const Given& given) {
    if (given.words.empty()) throw Error(Fault::usage, "emboss", phrase("name the files to send, in their order"));
    const std::string to = given.value("--to");
    const std::string place = to == "usb:" ? "usb" : to;  // a colon follows
    const Address address = parse_address(to, "--to");
    const EmbossJob job = job_of(given);
    const std::chrono::milliseconds patience(std::lround(1000 * number_value(given, "--wait", 300, 0.1, 1e6)));
    Delivery delivery;
    if (address.kind == Address::Kind::queue) {
        delivery = send_to_queue(address.name, job);
    } else if (job.by_driver) {
        throw Error(Fault::usage, "--to",
                    phrase("a ViewPlus raises dots by its own driver: send to its print queue, --to queue:NAME"));
    } else if (address.kind == Address::Kind::file) {
        write_file(address.name, job.bytes);
        delivery.accepted = job.bytes.size();
        if (!given.has("--quiet") && !given.has("--json"))
            say(phrase("{0}: {1} bytes written", to, std::to_string(job.bytes.size())));
    } else {
        delivery = deliver_to(address, place, job, patience, given);
    }
    if (given.has("--json")) print_out(json_of_emboss(delivery, job, to));
    if (delivery.ending != Ending::done)
        say(phrase("tactics: {0}: {1}. {2}. What the machine punched of them only a look at its paper tells", place,
                   words_for(delivery.ending, delivery.why), accepted_line(job, delivery.accepted)));
    else if (!given.has("--quiet") && address.kind != Address::Kind::file)
        say(phrase("{0}: {1}", place, accepted_line(job, delivery.accepted)));
    return exit_code_of(delivery.ending);
}

}  // namespace

extern const Command emboss_command;
const Command emboss_command{
    .name = "emboss",
    .summary = "send files to an embosser: by print queue, USB, serial line or network",
    .words = "FILE... --to ADDRESS",
    .details =
        "The files are sent in order as one job. Pages from convert are sent unchanged. A file that ends in .brf (text in North "
        "American Braille Computer Code) is formatted for the machine and --paper if --embosser is given, and is sent unchanged "
        "otherwise. If the machine has a print queue, use the queue; CUPS and this program cannot share a device. /dev/usb/lp0 "
        "is the kernel's driver. usb: needs no driver: it takes the printer from the kernel's while it sends, and then gives it "
        "back.\n\n"
        "Nothing is ever sent twice. If the machine stops accepting bytes, tactics reports the reason, as far as the machine "
        "gives one (out of paper, gone, or none), how many bytes it accepted, which page they complete, and how to go on. With "
        "--embosser NAME, tactics knows where pages end: Ctrl-C then ends the job after the current page, and a second Ctrl-C "
        "ends it at once. Without it, the first Ctrl-C ends the job at once.\n\n"
        "Exit codes: 0 all accepted, 1 wrong use, 2 failed, 4 out of paper, 5 gone, 6 nothing accepted for the time of --wait, "
        "7 cancelled.",
    .example =
        "tactics emboss page.prn --to queue:Everest\n"
        "tactics emboss chapter.brf figure.prn rest.brf --to /dev/usb/lp0 --embosser index-v4\n"
        "tactics emboss page.prn --to usb:1-2\n"
        "tactics emboss book.prn --to tcp:192.168.1.20 --embosser index-v4 --from-page 12",
    .flags = kEmbossFlags,
    .offers = "files",
    .takes_kept = true,
    .run = run_emboss,
};

}  // namespace tactics
