/* Driver of `search_axi`. */
#ifndef POINTCORE_SEARCH_DRIVER_H
#define POINTCORE_SEARCH_DRIVER_H

#include "tree.h"

/* What is sought: numbers in the geometry format. */
struct search_wanted {
    uint32_t point[3];
    uint32_t k;
    uint32_t radius2;
};

/* A neighbor: where it lies, and its squared distance in the geometry format. */
struct search_neighbor {
    uint32_t index;
    uint32_t distance2;
};

/*
 * Answers queries. Query `i` finds `counts[i]` neighbors, the nearest first, from `neighbors[i * SEARCH_NEIGHBORS]` on.
 * After CORE_ABORTED the core is ready for another run.
 */
enum core_status search_run(const struct tree *tree, const struct search_wanted *wanted, uint32_t count,
                            struct search_neighbor *neighbors, uint32_t *counts);

#endif
