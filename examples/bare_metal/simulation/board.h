/* A board that is simulated: a core on AXI with memory, its bus stalling at random. */
#ifndef POINTCORE_BOARD_H
#define POINTCORE_BOARD_H

#include "platform.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Bytes of memory, from address 0 on; what is beyond answers with an error. */
#define BOARD_MEMORY_BYTES ((uint32_t)1 << 26)

/* Powers a board up, memory and registers holding anything, and resets it. The seed draws these and all stalls. */
struct platform board_open(uint32_t seed);

/* Cycles since the reset. */
uint64_t board_cycles(const struct platform *platform);

/* Switches it off. */
void board_close(struct platform *platform);

#ifdef __cplusplus
}
#endif

#endif
