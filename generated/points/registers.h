/* points_axi: registers, packets and memory records. Written by pointcore; docs/interfaces.md says how they are used. */
#ifndef POINTCORE_POINTS_REGISTERS_H
#define POINTCORE_POINTS_REGISTERS_H

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

#define POINTS_STREAM_BITS 64
#define POINTS_MEMORY_BITS 64

/* Byte addresses of registers, and their bits. */
#define POINTS_ID 0x000u /* read: "PC", the core (0x0A, 0x0B or 0x0C), the layout's version (1) */
#define POINTS_CONTROL 0x004u /* write: commands */
#define POINTS_CONTROL_START (UINT32_C(1) << 0) /* begins a run, clears `done` and the run's counters */
#define POINTS_CONTROL_RESET (UINT32_C(1) << 1) /* resets the core's state (caches, threads); uniforms and the tree stay */
#define POINTS_CONTROL_CLEAR_ERRORS (UINT32_C(1) << 2) /* clears the error counters */
#define POINTS_CONTROL_ABORT (UINT32_C(1) << 3) /* ends the run under way: the core is reset, what is under way on the buses is taken and dropped; without a run, nothing */
#define POINTS_STATUS 0x008u /* read: where the core is */
#define POINTS_STATUS_BUSY (UINT32_C(1) << 0) /* a run is under way */
#define POINTS_STATUS_DONE (UINT32_C(1) << 1) /* a run has ended since the last start */
#define POINTS_STATUS_ERROR (UINT32_C(1) << 2) /* an error counter is not zero */
#define POINTS_INTERRUPT_ENABLE 0x00cu /* read, write: what raises `irq` */
#define POINTS_INTERRUPT_ENABLE_DONE (UINT32_C(1) << 0) /* `irq` is high while `done` is */
#define POINTS_ACCESS_ERRORS 0x010u /* read: register accesses refused: outside the map, not of a whole aligned word, written where only read or read where only written, a value that makes no sense */
#define POINTS_BUSY_ERRORS 0x014u /* read: accesses refused because a run is under way */
#define POINTS_BURST_ERRORS 0x018u /* read: bursts refused by `s_axi`, read bursts from memory whose `rlast` was not at their end, beats from memory that nobody asked for, and leaves without beats, read as of one */
#define POINTS_PACKET_ERRORS 0x01cu /* read: packets refused: `tlast` before or after their end, or a field out of its range */
#define POINTS_MEMORY_ERRORS 0x020u /* read: responses from memory that were not OKAY */
#define POINTS_CYCLES 0x024u /* read: cycles of the run, to its end or so far */
#define POINTS_PACKETS_IN 0x028u /* read: packets taken in the run */
#define POINTS_PACKETS_OUT 0x02cu /* read: packets sent in the run */
#define POINTS_EVENT_NODE 0x040u /* read: cycles of the run in which `event_node` was high */
#define POINTS_EVENT_POP 0x044u /* read: cycles of the run in which `event_pop` was high */
#define POINTS_EVENT_BEAT 0x048u /* read: cycles of the run in which `event_beat` was high */
#define POINTS_EVENT_INSERT 0x04cu /* read: cycles of the run in which `event_insert` was high */
#define POINTS_EVENT_INSERT_WAIT 0x050u /* read: cycles of the run in which `event_insert_wait` was high */
#define POINTS_EVENT_THREAD_WAIT 0x054u /* read: cycles of the run in which `event_thread_wait` was high */
#define POINTS_EVENT_POINT_HIT 0x058u /* read: cycles of the run in which `event_point_hit` was high */
#define POINTS_EVENT_POINT_MISS 0x05cu /* read: cycles of the run in which `event_point_miss` was high */
#define POINTS_EVENT_QUERY_WAIT 0x060u /* read: cycles of the run in which `event_query_wait` was high */
#define POINTS_EVENT_KERNEL 0x064u /* read: cycles of the run in which `event_kernel` was high */
#define POINTS_EVENT_KERNEL_WAIT 0x068u /* read: cycles of the run in which `event_kernel_wait` was high */
#define POINTS_EVENT_AGAIN 0x06cu /* read: cycles of the run in which `event_again` was high */
#define POINTS_EVENT_LINE_HIT 0x070u /* read: cycles of the run in which `event_line_hit` was high */
#define POINTS_EVENT_LINE_MISS 0x074u /* read: cycles of the run in which `event_line_miss` was high */
#define POINTS_POINTS_BASE 0x0c0u /* read, write: address of the positions, as the search reads them, a multiple of 4096 */
#define POINTS_LINES_BASE 0x0c8u /* read, write: address of the points, as the program reads them, a multiple of 4096 */
#define POINTS_QUERIES 0x0ccu /* read, write: queries of the next run, at least 1 */
#define POINTS_K 0x0d0u /* read, write: neighbors wanted, 1 to 32 */
#define POINTS_RADIUS2 0x0d4u /* read, write: squared radius within which neighbors count, in f32-ftz, from zero to infinity */
#define POINTS_ITERATIONS_MAX 0x0e8u /* read, write: iterations of a query at most, 1 to 65535 */
#define POINTS_SETTING_INVERSE_RADIUS2 0x100u /* read, write: a constant of the program, in f32-ftz */
#define POINTS_SETTING_TOLERANCE 0x104u /* read, write: a constant of the program, in f32-ftz */
#define POINTS_IDENTITY UINT32_C(0x50430c01) /* what POINTS_ID reads */

/* What the configuration fixes. */
#define POINTS_NEIGHBORS 32u /* the largest `k` of a query */
#define POINTS_INDEX_BITS 24u /* of a point's index and of a query's number */
#define POINTS_LANES 4u /* points in a beat: a record of `points` */
#define POINTS_BUCKET 16u /* points of a leaf at most */
#define POINTS_LEAF_BEATS 4u /* beats of a leaf at most */
#define POINTS_POINT_BEATS 4194304u /* beats of points at most: what indices reach */
#define POINTS_TREE_DEPTH 14u /* levels of internal nodes */
#define POINTS_TREE_RECORDS 32768u /* nodes and leaves: `2^(tree_depth + 1)` */
#define POINTS_TREE_STRIDE 8u /* bytes from one record of the tree to the next */
#define POINTS_TREE_BYTES 262144u /* the whole tree */
#define POINTS_TREE_IN_MEMORY 0 /* the tree lies in memory, at `tree_base`; else behind `s_axi` */
#define POINTS_NEIGHBORHOODS 0u /* what the neighbor cache holds; 0 where there is none */
#define POINTS_GEOMETRY_EXPONENT_BITS 8u /* of f32-ftz, docs/numbers.md */
#define POINTS_GEOMETRY_MANTISSA_BITS 23u /* behind the leading one */
#define POINTS_GEOMETRY_INFINITY UINT32_C(0x7f800000) /* positive */
#define POINTS_GEOMETRY_NAN UINT32_C(0x7fc00000) /* the one that operators return */
#define POINTS_LINE_POINTS 4u /* points of a line, which are read together */
#define POINTS_POINT_STRIDE 32u /* bytes from one point to the next at `lines_base` */
#define POINTS_THREADS 128u /* queries under way at a time */

/* What the program is asked. */
struct points_query {
    uint32_t number; /* 24 bits */
    uint32_t query_position_x; /* 32 bits */
    uint32_t query_position_y; /* 32 bits */
    uint32_t query_position_z; /* 32 bits */
};
POINTCORE_STATIC_ASSERT(sizeof(struct points_query) == 16, "points_query takes 16 bytes");
#define POINTS_QUERY_BYTES 16u
#define POINTS_QUERY_NUMBER_BITS 24u
#define POINTS_QUERY_QUERY_POSITION_X_BITS 32u
#define POINTS_QUERY_QUERY_POSITION_Y_BITS 32u
#define POINTS_QUERY_QUERY_POSITION_Z_BITS 32u

/* What leaves with a query. */
struct points_result {
    uint32_t number; /* 24 bits */
    uint16_t iterations; /* 16 bits */
    uint8_t capped; /* 1 bits */
    uint8_t padding_0[1];
    uint32_t output_position_x; /* 32 bits */
    uint32_t output_position_y; /* 32 bits */
    uint32_t output_position_z; /* 32 bits */
    uint32_t output_normal_x; /* 32 bits */
    uint32_t output_normal_y; /* 32 bits */
    uint32_t output_normal_z; /* 32 bits */
    uint32_t output_residual; /* 32 bits */
    uint8_t output_valid; /* 1 bits */
    uint8_t padding_1[3];
};
POINTCORE_STATIC_ASSERT(sizeof(struct points_result) == 40, "points_result takes 40 bytes");
#define POINTS_RESULT_BYTES 40u
#define POINTS_RESULT_NUMBER_BITS 24u
#define POINTS_RESULT_ITERATIONS_BITS 16u
#define POINTS_RESULT_CAPPED_BITS 1u
#define POINTS_RESULT_OUTPUT_POSITION_X_BITS 32u
#define POINTS_RESULT_OUTPUT_POSITION_Y_BITS 32u
#define POINTS_RESULT_OUTPUT_POSITION_Z_BITS 32u
#define POINTS_RESULT_OUTPUT_NORMAL_X_BITS 32u
#define POINTS_RESULT_OUTPUT_NORMAL_Y_BITS 32u
#define POINTS_RESULT_OUTPUT_NORMAL_Z_BITS 32u
#define POINTS_RESULT_OUTPUT_RESIDUAL_BITS 32u
#define POINTS_RESULT_OUTPUT_VALID_BITS 1u

/* A point as the program reads it, in the places that the search's points have; behind one another from `lines_base` on. */
struct points_point {
    uint32_t position_x; /* 32 bits */
    uint32_t position_y; /* 32 bits */
    uint32_t position_z; /* 32 bits */
    uint32_t normal_x; /* 32 bits */
    uint32_t normal_y; /* 32 bits */
    uint32_t normal_z; /* 32 bits */
    uint8_t padding_0[8];
};
POINTCORE_STATIC_ASSERT(sizeof(struct points_point) == 32, "points_point takes 32 bytes");
#define POINTS_POINT_BYTES 32u
#define POINTS_POINT_POSITION_X_BITS 32u
#define POINTS_POINT_POSITION_Y_BITS 32u
#define POINTS_POINT_POSITION_Z_BITS 32u
#define POINTS_POINT_NORMAL_X_BITS 32u
#define POINTS_POINT_NORMAL_Y_BITS 32u
#define POINTS_POINT_NORMAL_Z_BITS 32u

/* As many points as the core has lanes; a lane without a point holds NaN. */
struct points_points {
    uint32_t x0; /* 32 bits */
    uint32_t y0; /* 32 bits */
    uint32_t z0; /* 32 bits */
    uint32_t x1; /* 32 bits */
    uint32_t y1; /* 32 bits */
    uint32_t z1; /* 32 bits */
    uint32_t x2; /* 32 bits */
    uint32_t y2; /* 32 bits */
    uint32_t z2; /* 32 bits */
    uint32_t x3; /* 32 bits */
    uint32_t y3; /* 32 bits */
    uint32_t z3; /* 32 bits */
    uint8_t padding_0[16];
};
POINTCORE_STATIC_ASSERT(sizeof(struct points_points) == 64, "points_points takes 64 bytes");
#define POINTS_POINTS_BYTES 64u
#define POINTS_POINTS_X0_BITS 32u
#define POINTS_POINTS_Y0_BITS 32u
#define POINTS_POINTS_Z0_BITS 32u
#define POINTS_POINTS_X1_BITS 32u
#define POINTS_POINTS_Y1_BITS 32u
#define POINTS_POINTS_Z1_BITS 32u
#define POINTS_POINTS_X2_BITS 32u
#define POINTS_POINTS_Y2_BITS 32u
#define POINTS_POINTS_Z2_BITS 32u
#define POINTS_POINTS_X3_BITS 32u
#define POINTS_POINTS_Y3_BITS 32u
#define POINTS_POINTS_Z3_BITS 32u

/* An internal node of the tree. */
struct points_tree_node {
    uint32_t split; /* 32 bits */
    uint8_t dimension; /* 2 bits */
    uint8_t internal_leaf; /* 1 bits */
    uint8_t padding_0[2];
};
POINTCORE_STATIC_ASSERT(sizeof(struct points_tree_node) == 8, "points_tree_node takes 8 bytes");
#define POINTS_TREE_NODE_BYTES 8u
#define POINTS_TREE_NODE_SPLIT_BITS 32u
#define POINTS_TREE_NODE_DIMENSION_BITS 2u
#define POINTS_TREE_NODE_INTERNAL_LEAF_BITS 1u

/* Where the points of a leaf lie, in beats. */
struct points_tree_leaf {
    uint32_t begin; /* 22 bits */
    uint8_t beats; /* 3 bits */
    uint8_t padding_0[3];
};
POINTCORE_STATIC_ASSERT(sizeof(struct points_tree_leaf) == 8, "points_tree_leaf takes 8 bytes");
#define POINTS_TREE_LEAF_BYTES 8u
#define POINTS_TREE_LEAF_BEGIN_BITS 22u
#define POINTS_TREE_LEAF_BEATS_BITS 3u

#endif
