/* What the checks of both drivers share: a count of what was seen, and a link to a core that loses packets. */
#ifndef POINTCORE_CHECK_H
#define POINTCORE_CHECK_H

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "board.h"
#include "core.h"

/* Calls of the platform without progress after which a driver gives up: more than any run is quiet for, and few. */
#define PATIENCE 4000000
#define IMPATIENCE 20000

static unsigned checks, failures;

/* Counts a check; tells of it if it fails. */
#define CHECK(holds, ...)                                                    \
    do {                                                                     \
        checks++;                                                            \
        if (!(holds)) {                                                      \
            failures++;                                                      \
            fprintf(stderr, "%s:%d: %s: ", __FILE__, __LINE__, #holds);      \
            fprintf(stderr, __VA_ARGS__);                                    \
            fputc('\n', stderr);                                             \
        }                                                                    \
    } while (0)

#define CHECK_STATUS(call, expected)                                         \
    do {                                                                     \
        const enum core_status status_of_call = (call);                      \
        CHECK(status_of_call == (expected), "status %d", status_of_call);    \
    } while (0)

/* Random numbers from a seed, the same everywhere: a linear congruence, of which the upper bits count. */
static uint64_t random_state;

static inline uint32_t random_word(void)
{
    random_state = random_state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (uint32_t)(random_state >> 32);
}

/* From `low` up to, but not, `high`. */
static inline float random_float(float low, float high)
{
    return low + (high - low) * (float)(random_word() >> 8) / 16777216.0f;
}

/* A link that loses the packet after so many. */
static bool (*whole_send)(void *context, const uint8_t *packet, size_t bytes);
static uint32_t packets_to_loss;

static bool losing_send(void *context, const uint8_t *packet, size_t bytes)
{
    if (packets_to_loss == 0)
        return true;
    if (!whole_send(context, packet, bytes))
        return false;
    packets_to_loss--;
    return true;
}

static inline struct platform losing(const struct platform *platform, uint32_t packets)
{
    struct platform made = *platform;
    whole_send = platform->send;
    made.send = losing_send;
    packets_to_loss = packets;
    return made;
}

static inline void check_errors(const struct core *core, struct core_errors expected)
{
    const struct core_errors errors = core_errors(core);
    CHECK(errors.access == expected.access && errors.busy == expected.busy && errors.burst == expected.burst &&
              errors.packet == expected.packet && errors.memory == expected.memory,
          "access %u, busy %u, burst %u, packet %u, memory %u", errors.access, errors.busy, errors.burst,
          errors.packet, errors.memory);
}

/* Tells how it went; the exit code. */
static inline int finished(const char *name, uint64_t cycles)
{
    printf("%s: %u checks, %u failed, %llu cycles\n", name, checks, failures, (unsigned long long)cycles);
    return failures || !checks;
}

#endif
