/* Driver of `search_axi`. */
#ifndef POINTCORE_SEARCH_DRIVER_H
#define POINTCORE_SEARCH_DRIVER_H

#include "core.h"

#if SEARCH_NEIGHBORHOODS > 0
#error "this driver does not know the neighbor cache: generate a core with neighbor_cache = 0"
#endif

/* A search core with its points and its tree. */
struct search {
    struct core core;
    /* Where points lie, and the tree if it lies in memory; multiples of 4,096. */
    uint32_t points_base;
    uint32_t tree_base;
};

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

/* From the host's `float` to the geometry format, and back. */
uint32_t search_number(float value);
float search_value(uint32_t number);

/* Where points and tree are to lie; the core's caches forget those before. */
enum core_status search_open(struct search *search, const struct platform *platform, uint32_t patience,
                             uint32_t points_base, uint32_t tree_base);

/* A node of the tree, with a plane or as the end of its branch; records are counted as in docs/interfaces.md. */
enum core_status search_write_node(const struct search *search, uint32_t node, uint32_t split, unsigned dimension);
enum core_status search_write_internal_leaf(const struct search *search, uint32_t node);

/* Where the points of a leaf lie. */
enum core_status search_write_leaf(const struct search *search, uint32_t record, uint32_t begin, uint32_t beats);

/* Writes so many points from a beat on, the rest of the last beat empty; none take a beat, too. Returns the beats. */
uint32_t search_write_points(const struct search *search, uint32_t beat, const uint32_t (*points)[3], uint32_t count);

/* To be called when points, or a tree in memory, have changed. */
enum core_status search_changed(const struct search *search);

/*
 * Builds a tree by medians over points that are numbers, and writes both. Leaves have `leaf_points` points at most, 1
 * to SEARCH_BUCKET. Points come to lie in another order: a neighbor of `index` i is then the point `places[i]`. There is
 * room for `count` entries in `order`, for `search_places(count, leaf_points)` in `places`.
 */
uint32_t search_places(uint32_t count, uint32_t leaf_points);
enum core_status search_build(const struct search *search, const float (*points)[3], uint32_t count,
                              uint32_t leaf_points, uint32_t *order, uint32_t *places);

/*
 * Answers queries. Query `i` finds `counts[i]` neighbors, the nearest first, from `neighbors[i * SEARCH_NEIGHBORS]` on.
 * After CORE_ABORTED the core is ready for another run.
 */
enum core_status search_run(const struct search *search, const struct search_wanted *wanted, uint32_t count,
                            struct search_neighbor *neighbors, uint32_t *counts);

#endif
