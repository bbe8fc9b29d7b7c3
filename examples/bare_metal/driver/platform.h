/* What a driver asks of the board it runs on: everything that is not the same on every board. */
#ifndef POINTCORE_PLATFORM_H
#define POINTCORE_PLATFORM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Access to one core. Each function gets `context` back. */
struct platform {
    void *context;

    /* Reads or writes a register behind `s_axil`; false where the answer is not OKAY. */
    bool (*read32)(void *context, uint32_t address, uint32_t *value);
    bool (*write32)(void *context, uint32_t address, uint32_t value);

    /* Writes words through `s_axi`, in bursts of whole words; false where an answer is not OKAY. None of the renderer's. */
    bool (*write_window)(void *context, uint32_t address, const uint64_t *words, size_t count);

    /* Writes memory that the core reads. The core sees it when this returns: caches are written back. */
    void (*write_memory)(void *context, uint32_t address, const uint8_t *bytes, size_t count);

    /* Hands a packet over to be sent, if there is room for it. */
    bool (*send)(void *context, const uint8_t *packet, size_t bytes);

    /* Takes the next packet that has come, if there is one. It is never waited for; time goes on with every call. */
    bool (*receive)(void *context, uint8_t *packet, size_t bytes);

    /* Forgets what was to be sent and is not yet, and what has come and was not taken. */
    void (*forget)(void *context);
};

#endif
