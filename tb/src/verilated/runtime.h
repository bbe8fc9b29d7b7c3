// What a shim shares with Verilator's run-time library; precompiled, because its headers cost a second a build.
#ifndef POINTCORE_RUNTIME_H
#define POINTCORE_RUNTIME_H

#include "verilated.h"

#include <cstdint>
#include <mutex>
#include <string>

// A function that the loading program finds by its name; everything else stays inside the library.
#define EXPORT extern "C" __attribute__((visibility("default")))

// What the model said while it was evaluated.
struct Report {
    bool stopped = false;
    std::string text;
};

// Where $display, $stop and fatal errors of the model evaluated on this thread go.
extern __thread Report* current_report;

// Thrown by fatal errors, which must not return into the generated code.
struct Fatal {};

#endif
