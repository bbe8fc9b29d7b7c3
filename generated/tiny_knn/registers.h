/* search_axi: registers, packets and memory records. Written by pointcore; docs/interfaces.md says how they are used. */
#ifndef POINTCORE_SEARCH_REGISTERS_H
#define POINTCORE_SEARCH_REGISTERS_H

#include <stdint.h>

#ifndef POINTCORE_STATIC_ASSERT
#ifdef __cplusplus
#define POINTCORE_STATIC_ASSERT static_assert
#elif defined(__STDC_VERSION__) && __STDC_VERSION__ >= 201112L
#define POINTCORE_STATIC_ASSERT _Static_assert
#else
#define POINTCORE_STATIC_ASSERT(holds, text) extern int pointcore_static_assert[(holds) ? 1 : -1]
#endif
#endif

#define SEARCH_STREAM_BITS 64
#define SEARCH_MEMORY_BITS 64

/* Byte addresses of registers, and their bits. */
#define SEARCH_ID 0x000u /* read: "PC", the core (0x0A, 0x0B or 0x0C), the layout's version (1) */
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
#define SEARCH_EVENT_THREAD_WAIT 0x050u /* read: cycles of the run in which `event_thread_wait` was high */
#define SEARCH_POINTS_BASE 0x080u /* read, write: address of the points, a multiple of 4096 */
#define SEARCH_QUERIES 0x088u /* read, write: queries of the next run, at least 1 */
#define SEARCH_IDENTITY UINT32_C(0x50430b01) /* what SEARCH_ID reads */

/* What the configuration fixes. */
#define SEARCH_NEIGHBORS 8u /* the largest `k` of a query */
#define SEARCH_INDEX_BITS 16u /* of a point's index and of a query's number */
#define SEARCH_LANES 1u /* points in a beat: a record of `points` */
#define SEARCH_BUCKET 8u /* points of a leaf at most */
#define SEARCH_LEAF_BEATS 8u /* beats of a leaf at most */
#define SEARCH_POINT_BEATS 65536u /* beats of points at most: what indices reach */
#define SEARCH_TREE_DEPTH 6u /* levels of internal nodes */
#define SEARCH_TREE_RECORDS 128u /* nodes and leaves: `2^(tree_depth + 1)` */
#define SEARCH_TREE_STRIDE 8u /* bytes from one record of the tree to the next */
#define SEARCH_TREE_BYTES 1024u /* the whole tree */
#define SEARCH_TREE_IN_MEMORY 0 /* the tree lies in memory, at `tree_base`; else behind `s_axi` */
#define SEARCH_NEIGHBORHOODS 0u /* what the neighbor cache holds; 0 where there is none */
#define SEARCH_GEOMETRY_EXPONENT_BITS 8u /* of f24-ftz, docs/numbers.md */
#define SEARCH_GEOMETRY_MANTISSA_BITS 15u /* behind the leading one */
#define SEARCH_GEOMETRY_INFINITY UINT32_C(0x7f8000) /* positive */
#define SEARCH_GEOMETRY_NAN UINT32_C(0x7fc000) /* the one that operators return */

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
#define SEARCH_QUERY_BYTES 24u
#define SEARCH_QUERY_NUMBER_BITS 16u
#define SEARCH_QUERY_K_BITS 4u
#define SEARCH_QUERY_RADIUS2_BITS 24u
#define SEARCH_QUERY_X_BITS 24u
#define SEARCH_QUERY_Y_BITS 24u
#define SEARCH_QUERY_Z_BITS 24u

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
#define SEARCH_RESULT_BYTES 16u
#define SEARCH_RESULT_NUMBER_BITS 16u
#define SEARCH_RESULT_LAST_BITS 1u
#define SEARCH_RESULT_FOUND_BITS 1u
#define SEARCH_RESULT_INDEX_BITS 16u
#define SEARCH_RESULT_DISTANCE2_BITS 24u

/* As many points as the core has lanes; a lane without a point holds NaN. */
struct search_points {
    uint32_t x0; /* 24 bits */
    uint32_t y0; /* 24 bits */
    uint32_t z0; /* 24 bits */
    uint8_t padding_0[4];
};
POINTCORE_STATIC_ASSERT(sizeof(struct search_points) == 16, "search_points takes 16 bytes");
#define SEARCH_POINTS_BYTES 16u
#define SEARCH_POINTS_X0_BITS 24u
#define SEARCH_POINTS_Y0_BITS 24u
#define SEARCH_POINTS_Z0_BITS 24u

/* An internal node of the tree. */
struct search_tree_node {
    uint32_t split; /* 24 bits */
    uint8_t dimension; /* 2 bits */
    uint8_t internal_leaf; /* 1 bits */
    uint8_t padding_0[2];
};
POINTCORE_STATIC_ASSERT(sizeof(struct search_tree_node) == 8, "search_tree_node takes 8 bytes");
#define SEARCH_TREE_NODE_BYTES 8u
#define SEARCH_TREE_NODE_SPLIT_BITS 24u
#define SEARCH_TREE_NODE_DIMENSION_BITS 2u
#define SEARCH_TREE_NODE_INTERNAL_LEAF_BITS 1u

/* Where the points of a leaf lie, in beats. */
struct search_tree_leaf {
    uint16_t begin; /* 16 bits */
    uint8_t beats; /* 4 bits */
    uint8_t padding_0[5];
};
POINTCORE_STATIC_ASSERT(sizeof(struct search_tree_leaf) == 8, "search_tree_leaf takes 8 bytes");
#define SEARCH_TREE_LEAF_BYTES 8u
#define SEARCH_TREE_LEAF_BEGIN_BITS 16u
#define SEARCH_TREE_LEAF_BEATS_BITS 4u

#endif
