// SPDX-License-Identifier: Apache-2.0
// Print jobs of the printer application: documents and rasters, converted by a child and sent to the device sheet after sheet.
#pragma once

#include <pappl/pappl.h>

namespace tactics {

/// The functions of a driver.
void add_printing(pappl_pr_driver_data_t& driver);

/// A document of one of kDocuments.
bool print_document(pappl_job_t* job, pappl_device_t* device, void* data);

}  // namespace tactics
