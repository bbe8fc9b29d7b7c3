/* What the drivers of all cores have in common: registers, runs, packets. Each includes its own registers.h. */
#ifndef POINTCORE_CORE_H
#define POINTCORE_CORE_H

#include "platform.h"
#include "registers.h"

/* A constant of registers.h, and a record. */
#if defined POINTCORE_SEARCH_REGISTERS_H
#define CORE_(name) SEARCH_##name
#define RECORD_(name) search_##name
#elif defined POINTCORE_POINTS_REGISTERS_H
#define CORE_(name) POINTS_##name
#define RECORD_(name) points_##name
#else
#define CORE_(name) SPLAT_##name
#endif

/* How a call ended. */
enum core_status {
    CORE_OK,
    CORE_WRONG_IDENTITY, /* another core answers, or another version of its layout */
    CORE_WRONG_ARGUMENT, /* the call asks for what the configuration cannot do */
    CORE_REFUSED,        /* the core refused an access */
    CORE_ABORTED,        /* nothing moved for `patience` calls of the platform, or packets came that make no sense */
    CORE_STUCK,          /* the core did not even end when it was told to */
    CORE_ERRORS,         /* the run has ended, and an error counter is not zero */
};

struct core {
    const struct platform *platform;
    /* Calls of the platform without any progress after which a run is given up. */
    uint32_t patience;
};

/* The error counters. */
struct core_errors {
    uint32_t access, busy, burst, packet, memory;
};

/* A field's place in a packet or a memory record. */
#define FIELD(record, field) offsetof(struct record, field), sizeof(((struct record *)0)->field)

/* Writes a field: containers are little-endian, whatever the host is. */
static inline void core_put(uint8_t *record, size_t place, size_t bytes, uint64_t value)
{
    for (size_t byte = 0; byte < bytes; byte++)
        record[place + byte] = (uint8_t)(value >> (8 * byte));
}

/* Reads a field. */
static inline uint64_t core_get(const uint8_t *record, size_t place, size_t bytes)
{
    uint64_t value = 0;
    for (size_t byte = 0; byte < bytes; byte++)
        value |= (uint64_t)record[place + byte] << (8 * byte);
    return value;
}

static inline void core_clear(uint8_t *record, size_t bytes)
{
    for (size_t byte = 0; byte < bytes; byte++)
        record[byte] = 0;
}

static inline uint32_t core_read(const struct core *core, uint32_t address)
{
    uint32_t value = 0;
    core->platform->read32(core->platform->context, address, &value);
    return value;
}

static inline enum core_status core_write(const struct core *core, uint32_t address, uint32_t value)
{
    return core->platform->write32(core->platform->context, address, value) ? CORE_OK : CORE_REFUSED;
}

static inline bool core_send(const struct core *core, const uint8_t *packet, size_t bytes)
{
    return core->platform->send(core->platform->context, packet, bytes);
}

static inline bool core_receive(const struct core *core, uint8_t *packet, size_t bytes)
{
    return core->platform->receive(core->platform->context, packet, bytes);
}

static inline struct core_errors core_errors(const struct core *core)
{
    const struct core_errors errors = {
        core_read(core, CORE_(ACCESS_ERRORS)), core_read(core, CORE_(BUSY_ERRORS)),
        core_read(core, CORE_(BURST_ERRORS)),  core_read(core, CORE_(PACKET_ERRORS)),
        core_read(core, CORE_(MEMORY_ERRORS)),
    };
    return errors;
}

static inline enum core_status core_clear_errors(const struct core *core)
{
    return core_write(core, CORE_(CONTROL), CORE_(CONTROL_CLEAR_ERRORS));
}

/* Makes sure that the core is the one of registers.h, at rest. */
static inline enum core_status core_open(struct core *core, const struct platform *platform, uint32_t patience)
{
    core->platform = platform;
    core->patience = patience;
    if (core_read(core, CORE_(ID)) != CORE_(IDENTITY))
        return CORE_WRONG_IDENTITY;
    if (core_write(core, CORE_(INTERRUPT_ENABLE), 0) != CORE_OK)
        return CORE_REFUSED;
    return core_clear_errors(core);
}

static inline bool core_is_busy(const struct core *core)
{
    return core_read(core, CORE_(STATUS)) & CORE_(STATUS_BUSY);
}

/*
 * Ends a run that cannot end by itself, and tells of it. Packets have to be taken until it has ended: the core completes
 * what has begun to leave.
 */
static inline enum core_status core_abort(const struct core *core, uint8_t *packet, size_t bytes)
{
    if (core_write(core, CORE_(CONTROL), CORE_(CONTROL_ABORT)) != CORE_OK)
        return CORE_REFUSED;
    for (uint32_t waited = 0; core_is_busy(core); waited++) {
        if (waited > core->patience)
            return CORE_STUCK;
        core_receive(core, packet, bytes);
    }
    core->platform->forget(core->platform->context);
    return CORE_ABORTED;
}

/* Begins a run. Right after an abort a core may refuse it for some cycles, so it is written again. */
static inline enum core_status core_start(const struct core *core)
{
    for (uint32_t waited = 0; waited <= core->patience; waited++) {
        const uint32_t refused = core_read(core, CORE_(BUSY_ERRORS));
        if (core_write(core, CORE_(CONTROL), CORE_(CONTROL_START)) == CORE_OK)
            return CORE_OK;
        if (core_is_busy(core) || core_read(core, CORE_(BUSY_ERRORS)) == refused)
            return CORE_REFUSED; /* a run is under way, or the start makes no sense */
    }
    return CORE_REFUSED;
}

/* Waits for the end of a run whose packets have all come. */
static inline enum core_status core_finish(const struct core *core)
{
    uint32_t waited = 0;
    while (core_is_busy(core))
        if (++waited > core->patience)
            return CORE_STUCK;
    return core_read(core, CORE_(STATUS)) & CORE_(STATUS_ERROR) ? CORE_ERRORS : CORE_OK;
}

#endif
