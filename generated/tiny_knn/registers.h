/* search_axi: registers, packets and memory records. Written by pointcore; docs/interfaces.md says how they are used. */
#ifndef POINTCORE_SEARCH_REGISTERS_H
#define POINTCORE_SEARCH_REGISTERS_H

#include <stdint.h>

#ifndef POINTCORE_STATIC_ASSERT
#ifdef __cplusplus
#define POINTCORE_STATIC_ASSERT static_assert
#else
#define POINTCORE_STATIC_ASSERT _Static_assert
#endif
#endif

#define SEARCH_STREAM_BITS 64
#define SEARCH_MEMORY_BITS 64

/* Byte addresses of registers, and their bits. */
#define SEARCH_ID 0x000u /* read: "PC", the core (0x0A or 0x0B), the layout's version (1) */
#define SEARCH_CONTROL 0x004u /* write: commands */
#define SEARCH_CONTROL_START (UINT32_C(1) << 0) /* begins a run, clears `done` and the run's counters */
#define SEARCH_CONTROL_RESET (UINT32_C(1) << 1) /* resets the core's state (caches, threads); uniforms and the tree stay */
#define SEARCH_CONTROL_CLEAR_ERRORS (UINT32_C(1) << 2) /* clears the error counters */
#define SEARCH_CONTROL_ABORT (UINT32_C(1) << 3) /* ends the run under way: the core is reset, what is under way on the buses is taken and dropped; without a run, nothing */
#define SEARCH_STATUS 0x008u /* read: where the core is */
#define SEARCH_STATUS_BUSY (UINT32_C(1) << 0) /* a run is under way */
#define SEARCH_STATUS_DONE (UINT32_C(1) << 1) /* a run has ended since the last start */
#define SEARCH_STATUS_ERROR (UINT32_C(1) << 2) /* an error counter is not zero */
#define SEARCH_INTERRUPT_ENABLE 0x00cu /* read, write: what raises `irq` */
#define SEARCH_INTERRUPT_ENABLE_DONE (UINT32_C(1) << 0) /* `irq` is high while `done` is */
#define SEARCH_ACCESS_ERRORS 0x010u /* read: register accesses refused: outside the map, not of a whole aligned word, written where only read or read where only written, a value that makes no sense */
#define SEARCH_BUSY_ERRORS 0x014u /* read: accesses refused because a run is under way */
#define SEARCH_BURST_ERRORS 0x018u /* read: bursts refused by `s_axi`, read bursts from memory whose `rlast` was not at their end, beats from memory that nobody asked for, and leaves without beats, read as of one */
#define SEARCH_PACKET_ERRORS 0x01cu /* read: packets refused: `tlast` before or after their end, or a field out of its range */
#define SEARCH_MEMORY_ERRORS 0x020u /* read: responses from memory that were not OKAY */
#define SEARCH_CYCLES 0x024u /* read: cycles of the run, to its end or so far */
#define SEARCH_PACKETS_IN 0x028u /* read: packets taken in the run */
#define SEARCH_PACKETS_OUT 0x02cu /* read: packets sent in the run */
#define SEARCH_EVENT_NODE 0x040u /* read: cycles of the run in which `event_node` was high */
#define SEARCH_EVENT_POP 0x044u /* read: cycles of the run in which `event_pop` was high */
#define SEARCH_EVENT_BEAT 0x048u /* read: cycles of the run in which `event_beat` was high */
#define SEARCH_EVENT_INSERT 0x04cu /* read: cycles of the run in which `event_insert` was high */
#define SEARCH_EVENT_INSERT_WAIT 0x050u /* read: cycles of the run in which `event_insert_wait` was high */
#define SEARCH_EVENT_THREAD_WAIT 0x054u /* read: cycles of the run in which `event_thread_wait` was high */
#define SEARCH_POINTS_BASE 0x080u /* read, write: address of the points, a multiple of 4096 */
#define SEARCH_QUERIES 0x088u /* read, write: queries of the next run, at least 1 */
#define SEARCH_IDENTITY UINT32_C(0x50430b01) /* what SEARCH_ID reads */

/* A point whose neighbors are sought. */
struct search_query {
    uint16_t number; /* 16 bits */
    uint8_t k; /* 4 bits */
    uint8_t padding_0[1];
    uint32_t radius2; /* 24 bits */
    uint32_t x; /* 24 bits */
    uint32_t y; /* 24 bits */
    uint32_t z; /* 24 bits */
    uint8_t padding_1[4];
};
POINTCORE_STATIC_ASSERT(sizeof(struct search_query) == 24, "search_query takes 24 bytes");

/* A neighbor, nearest first; `last` closes its query. */
struct search_result {
    uint16_t number; /* 16 bits */
    uint8_t last; /* 1 bits */
    uint8_t found; /* 1 bits */
    uint16_t index; /* 16 bits */
    uint8_t padding_0[2];
    uint32_t distance2; /* 24 bits */
    uint8_t padding_1[4];
};
POINTCORE_STATIC_ASSERT(sizeof(struct search_result) == 16, "search_result takes 16 bytes");

/* As many points as the core has lanes; a lane without a point holds NaN. */
struct search_points {
    uint32_t x0; /* 24 bits */
    uint32_t y0; /* 24 bits */
    uint32_t z0; /* 24 bits */
    uint8_t padding_0[4];
};
POINTCORE_STATIC_ASSERT(sizeof(struct search_points) == 16, "search_points takes 16 bytes");

/* An internal node of the tree. */
struct search_tree_node {
    uint32_t split; /* 24 bits */
    uint8_t dimension; /* 2 bits */
    uint8_t internal_leaf; /* 1 bits */
    uint8_t padding_0[2];
};
POINTCORE_STATIC_ASSERT(sizeof(struct search_tree_node) == 8, "search_tree_node takes 8 bytes");

/* Where the points of a leaf lie, in beats. */
struct search_tree_leaf {
    uint16_t begin; /* 16 bits */
    uint8_t beats; /* 4 bits */
    uint8_t padding_0[5];
};
POINTCORE_STATIC_ASSERT(sizeof(struct search_tree_leaf) == 8, "search_tree_leaf takes 8 bytes");

#endif
