// SPDX-License-Identifier: Apache-2.0
// tactics-printer-app: every embosser of TACTICS as an IPP printer, for which no system needs a driver.
#include <pappl/pappl.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "cli/printer_app/ipp_driver.h"
#include "cli/printer_app/printing.h"
#include "cli/report/user_language.h"
#include "cli/report/wrapped_help.h"

namespace {

using namespace tactics;

constexpr const char* kName = "tactics-printer-app";

void complain(const Phrase& words) { std::fprintf(stderr, "%s: %s\n", kName, words.in(user_language()).c_str()); }

struct Use {
    const char* command;
    Phrase what;
};

std::vector<Use> uses() {
    return {
        {"server -o server-port=8631",
         phrase("runs it until it is ended. Other computers can print, too, with -o listen-hostname=*.")},
        {"drivers", phrase("names the embossers. What stands on your machine is among them, such as everest-d-v5.")},
        {"choices -m everest-d-v5",
         phrase("lists the options of its pages with their choices. (The sub-command options lists those that every printer "
                "has.)")},
        {"devices", phrase("names the machines that are connected or answer on the network.")},
        {"add -d Everest -m everest-d-v5 -v socket://192.168.1.20", phrase("makes a printer of the machine at that address.")},
        {"-d Everest -o tactics-language=de -o media=iso_a4_210x297mm photo.jpg",
         phrase("prints a file. Title and labels: -o tactics-title='Our town' -o \"tactics-label='30%,40%=City Park'\".")},
        {"modify -d Everest -o tactics-detail-default=contours",
         phrase("changes what is used where a job does not say otherwise.")},
        {"options|printers|jobs|status|cancel|pause|resume|delete|default|shutdown [-d PRINTER]",
         phrase("Why a job was aborted is in the log, log-file=FILE, and goes to other programs as its job-state-message.")},
    };
}

void print_usage(void*) {
    std::string text =
        line_for_user(phrase("tactics-printer-app makes braille embossers printers that need no driver: it takes PDF, JPEG, "
                             "PNG, TIFF, SVG and text from any program on this computer, makes tactile pages of them as "
                             "tactics convert does, and embosses them.")) +
        "\n";
    for (const Use& use : uses()) text += std::string("  ") + kName + " " + use.command + "\n      " + line_for_user(use.what);
    text +=
        "\n" + line_for_user(phrase("Settings of the server: {0}. Its printers are also in the web browser, at {1}. See {2}.",
                                    "-o server-port=NUMBER -o listen-hostname=NAME -o spool-directory=FOLDER -o log-file=FILE "
                                    "-o log-level=debug|info|warn|error -o admin-group=GROUP -o auth-service=NAME -o "
                                    "file-devices=yes",
                                    "http://localhost:PORT", "man tactics-printer-app"));
    print_help(text);
}

pappl_loglevel_t level_of(const char* word) {
    const std::string name = word == nullptr ? "" : word;
    if (name == "debug") return PAPPL_LOGLEVEL_DEBUG;
    if (name == "info") return PAPPL_LOGLEVEL_INFO;
    if (name == "error") return PAPPL_LOGLEVEL_ERROR;
    return PAPPL_LOGLEVEL_WARN;
}

// Where jobs wait: beside what the server keeps of its printers, or where the user says.
std::string spool_folder() {
    if (const char* home = std::getenv("HOME"); home != nullptr && *home != '\0') return std::string(home) + "/." + kName;
    return std::string(papplGetTempDir()) + "/" + kName;
}

pappl_system_t* make_system(int count, cups_option_t* options, void* data) {
    const auto option = [&](const char* name) { return cupsGetOption(name, count, options); };
    const char* files = option("file-devices");
    static_cast<ServerWish*>(data)->to_files = files != nullptr && std::string_view(files) == "yes";
    const char* port = option("server-port");
    const char* folder = option("spool-directory");
    const std::string spool = folder != nullptr ? folder : spool_folder();
    pappl_system_t* system = papplSystemCreate(PAPPL_SOPTIONS_MULTI_QUEUE | PAPPL_SOPTIONS_WEB_INTERFACE, kName,
                                               port == nullptr ? 0 : std::atoi(port), "_print,_universal", spool.c_str(),
                                               option("log-file"), level_of(option("log-level")), option("auth-service"), false);
    if (system == nullptr) return nullptr;
    for (const char* kind : kDocuments) papplSystemAddMIMEFilter(system, kind, kMachineBytes, print_document, nullptr);
    papplSystemSetMIMECallback(system, kind_of_document, nullptr);
    if (const char* group = option("admin-group")) papplSystemSetAdminGroup(system, group);
    // A printer that only this computer reaches is not announced to others under another name.
    const char* called = option("server-hostname");
    if (called == nullptr && option("listen-hostname") == nullptr) called = "localhost";
    if (called != nullptr) papplSystemSetHostName(system, called);
    if (option("private-server") == nullptr) {
        const char* host = option("listen-hostname");
        const std::string name = host == nullptr ? "localhost" : host;
        if (!papplSystemAddListeners(system, name == "*" ? nullptr : name.c_str())) {
            complain(phrase("cannot listen on {0}; choose a free port by {1}", name, "-o server-port=NUMBER"));
            papplSystemDelete(system);
            return nullptr;
        }
    }
    return system;
}

// PAPPL would start a server to answer that.
int list_drivers() {
    for (const MachineDriver& driver : machine_drivers()) {
        const bool entry = driver.name == driver.format->name;
        std::printf("%s: %s\n", driver.name.c_str(),
                    entry ? std::string(driver.format->summary).c_str() : ("as " + std::string(driver.format->name)).c_str());
    }
    return 0;
}

// The options of a driver's printers with their choices, which PAPPL's own sub-command options leaves out.
int list_choices(const char*, int count, cups_option_t* options, int, char**, void*) {
    const char* name = cupsGetOption("smi55357-driver", count, options);
    const MachineDriver* driver = name == nullptr ? nullptr : find_driver(name);
    if (driver == nullptr) {
        complain(phrase("name a driver by {0}; {1} lists them", "-m", std::string(kName) + " drivers"));
        return 1;
    }
    const PpdWords offered = words_of(*driver);
    for (const auto& [option, fallback] : own_options(offered)) {
        const bool any = takes_any_words(option);
        std::string choices;
        for (const std::string& choice : offered.choices.at(option)) choices += (choices.empty() ? "" : " ") + choice;
        const std::string name_and_own = attribute_of(option) + "=" + fallback;
        std::fputs(line_for_user(any ? phrase("{0}; choices: {1}, or any words", name_and_own, choices)
                                     : phrase("{0}; choices: {1}", name_and_own, choices))
                       .c_str(),
                   stdout);
    }
    std::fputs(line_for_user(phrase("tactics-label=PLACE=WORDS; for example: {0}", "30%,40%=City Park;60%,20%=Lake")).c_str(),
               stdout);
    return 0;
}

const char* driver_for(const char*, const char*, const char* id, void*) {
    const MachineDriver* driver = driver_of_device(id == nullptr ? "" : id);
    return driver == nullptr ? nullptr : driver->name.c_str();
}

}  // namespace

int main(int count, char** words) {
    std::signal(SIGXFSZ, SIG_IGN);
    std::signal(SIGCHLD, SIG_DFL);  // how a job's child ended is asked for
    if (count > 1 && words[1] == kJobChild) return run_job_child();
    if (count == 2 && std::string_view(words[1]) == "drivers") return list_drivers();
    ServerWish server;
    std::vector<pappl_pr_driver_t> drivers;
    for (const MachineDriver& driver : machine_drivers())
        drivers.push_back({driver.name.c_str(), driver.people.c_str(), nullptr, nullptr});
    return papplMainloop(count, words, TACTICS_VERSION, "<p>TACTICS: pages to be read by touch</p>",
                         static_cast<int>(drivers.size()), drivers.data(), driver_for, offer_driver, "choices", list_choices,
                         make_system, print_usage, &server);
}
