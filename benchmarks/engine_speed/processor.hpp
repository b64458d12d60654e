#pragma once
#include <string>

/// What the operating system reports of time, memory and load.
namespace ringfilm::benchmarks {

/// Processor time that this thread has had [s].
double processor_seconds();

/// Bytes that the program holds on its heap now; 0 where the C library does not report.
double heap_bytes();

/// Starts the peak of `peak_resident_bytes` afresh; false where the system cannot.
bool forget_peak_resident();

/// The most memory that the process has held [byte]; 0 where the system does not report.
double peak_resident_bytes();

/// Model and number of the processors.
std::string processor_name();

/// Processes that ran or waited in the last 1, 5 and 15 minutes.
std::string machine_load();

}  // namespace ringfilm::benchmarks
