/* Points and the tree over them: what the drivers of the search core and of the point processor share. */
#ifndef POINTCORE_TREE_H
#define POINTCORE_TREE_H

#include "core.h"

#if CORE_(NEIGHBORHOODS) > 0
#error "this driver does not know the neighbor cache: generate a core with neighbor_cache = 0"
#endif

/* A core with its points and its tree. */
struct tree {
    struct core core;
    /* Where points lie, and the tree if it lies in memory; multiples of 4,096. */
    uint32_t points_base;
    uint32_t tree_base;
};

/* From the host's `float` to the geometry format, and back. */
uint32_t tree_number(float value);
float tree_value(uint32_t number);

/* Where points and tree are to lie; the core's caches forget those before. */
enum core_status tree_open(struct tree *tree, const struct platform *platform, uint32_t patience,
                           uint32_t points_base, uint32_t tree_base);

/* A node of the tree, with a plane or as the end of its branch; records are counted as in docs/interfaces.md. */
enum core_status tree_write_node(const struct tree *tree, uint32_t node, uint32_t split, unsigned dimension);
enum core_status tree_write_internal_leaf(const struct tree *tree, uint32_t node);

/* Where the points of a leaf lie. */
enum core_status tree_write_leaf(const struct tree *tree, uint32_t record, uint32_t begin, uint32_t beats);

/* Writes so many points from a beat on, the rest of the last beat empty; none take a beat, too. Returns the beats. */
uint32_t tree_write_points(const struct tree *tree, uint32_t beat, const uint32_t (*points)[3], uint32_t count);

/* To be called when points, or a tree in memory, have changed. */
enum core_status tree_changed(const struct tree *tree);

/*
 * Builds a tree by medians over points that are numbers, and writes both. Leaves have `leaf_points` points at most, 1
 * to BUCKET. Points come to lie in another order: a neighbor of `index` i is then the point `places[i]`. There is
 * room for `count` entries in `order`, for `tree_places(count, leaf_points)` in `places`.
 */
uint32_t tree_places(uint32_t count, uint32_t leaf_points);
enum core_status tree_build(const struct tree *tree, const float (*points)[3], uint32_t count,
                           uint32_t leaf_points, uint32_t *order, uint32_t *places);

#endif
