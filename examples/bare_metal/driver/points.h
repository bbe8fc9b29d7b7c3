/* Driver of `points_axi`. What is asked, what a point has and what comes depends on the program: registers.h has it. */
#ifndef POINTCORE_POINTS_DRIVER_H
#define POINTCORE_POINTS_DRIVER_H

#include "tree.h"

/* A point processor with its points, which lie in memory twice, and its tree. */
struct points {
    struct tree tree;
    /* Where points lie as the program reads them; a multiple of 4,096. */
    uint32_t lines_base;
};

/* What holds of all queries of a run. */
struct points_rules {
    uint32_t k;
    uint32_t radius2; /* in the geometry format */
    uint32_t iterations_max;
};

/* Where points and tree are to lie; the core's caches forget those before. */
enum core_status points_open(struct points *points, const struct platform *platform, uint32_t patience,
                             uint32_t points_base, uint32_t tree_base, uint32_t lines_base);

/*
 * Writes a `struct points_point`, fields put by `core_put`, for the point that the tree has at `place`. After the last
 * one tree_changed(&points->tree) is called.
 */
void points_write_point(const struct points *points, uint32_t place, const uint8_t point[POINTS_POINT_BYTES]);

/*
 * Answers queries: `struct points_query`, fields put by `core_put`, their `number` by this call. Result `i`, a `struct
 * points_result`, is that of query `i`. Settings of the program are registers, which core_write writes before. After
 * CORE_ABORTED the core is ready for another run.
 */
enum core_status points_run(const struct points *points, const struct points_rules *rules,
                            uint8_t (*queries)[POINTS_QUERY_BYTES], uint32_t count,
                            uint8_t (*results)[POINTS_RESULT_BYTES]);

#endif
