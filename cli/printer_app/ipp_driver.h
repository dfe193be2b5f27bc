// SPDX-License-Identifier: Apache-2.0
// An embosser in IPP: what a printer of it offers (IPP Everywhere, PWG 5100.14), and what a print job chose of that.
#pragma once

#include <pappl/pappl.h>

#include <string>

#include "cli/printer_app/job_child.h"

namespace tactics {

/// The kind of document that an embosser takes as it is: bytes that `tactics convert` wrote for it.
inline constexpr const char* kMachineBytes = "application/vnd.tactics";
/// What is converted for it.
inline constexpr const char* kDocuments[] = {"application/pdf", "image/jpeg",    "image/png",
                                             "image/tiff",      "image/svg+xml", "text/plain"};

/// The kind of a document that begins so, of those that PAPPL does not know itself; nullptr: none that is printed.
const char* kind_of_document(const unsigned char* bytes, std::size_t count, void* data);

struct ServerWish {
    bool to_files = false;  ///< for tests: anyone who may add a printer could write to any file of the server's user
};

/// Whether the server sends bytes to such an address: to files only where that is wished, and never as root.
bool may_send_to(const std::string& device, const ServerWish& server);

/// Fills in sizes, resolution and options; the functions that print are added by add_printing (printing.h). False: there is no
/// such driver, or the device is none to send to. `data` is a ServerWish.
bool offer_driver(pappl_system_t* system, const char* name, const char* device, const char* id, pappl_pr_driver_data_t* offered,
                  ipp_t** attributes, void* data);

/// What a job asks for, with what its printer was set to.
JobRequest request_of(pappl_job_t* job, bool is_text);

}  // namespace tactics
