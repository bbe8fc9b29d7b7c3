// Verilator's run-time library, with its messages collected instead of printed and its errors reported instead of aborting.
#include "runtime.h"

#include <cstdarg>

static int report_print(const char* format, ...) {
    char line[4096];
    va_list arguments;
    va_start(arguments, format);
    const int length = vsnprintf(line, sizeof line, format, arguments);
    va_end(arguments);
    if (current_report) current_report->text += line;
    return length;
}

#undef VL_PRINTF
#define VL_PRINTF report_print
#define VL_USER_STOP
#define VL_USER_FATAL
#include "verilated.cpp"

__thread Report* current_report = nullptr;

static void report_stop(const char* what, const char* file, int line, const char* scope) {
    report_print("%s at %s:%d in %s\n", what, file, line, scope);
    if (current_report) current_report->stopped = true;
}

void vl_stop(const char* file, int line, const char* scope) { report_stop("$stop", file, line, scope); }

void vl_fatal(const char* file, int line, const char* scope, const char* message) {
    report_stop(message, file, line, scope);
    throw Fatal{};
}
