/* A tree by medians over points of the host. */
#include "tree.h"

/* What is being built. */
struct build {
    const struct tree *tree;
    const float (*points)[3];
    uint32_t leaf_points;
    uint32_t *order;
    uint32_t *places;
    uint32_t next_beat;
};

static uint32_t beats_of(uint32_t points)
{
    return points ? (points + CORE_(LANES) - 1) / CORE_(LANES) : 1;
}

/* Levels that halving takes until leaves are small enough. */
static uint32_t levels_of(uint32_t count, uint32_t leaf_points)
{
    uint32_t levels = 0;
    while (count > leaf_points) {
        count = count - count / 2;
        levels++;
    }
    return levels;
}

uint32_t tree_places(uint32_t count, uint32_t leaf_points)
{
    const uint32_t leaves = (uint32_t)1 << levels_of(count, leaf_points);
    return leaves * beats_of(leaf_points) * CORE_(LANES);
}

/* Puts the points in an order in which none before `middle` is greater than that there, and none behind it less. */
static void select_middle(const struct build *build, uint32_t first, uint32_t past, uint32_t middle, unsigned axis)
{
    uint32_t *order = build->order;
    int64_t low = first, high = (int64_t)past - 1;
    while (low < high) {
        const float pivot = build->points[order[middle]][axis];
        int64_t up = low, down = high;
        while (up <= down) {
            while (build->points[order[up]][axis] < pivot)
                up++;
            while (build->points[order[down]][axis] > pivot)
                down--;
            if (up <= down) {
                const uint32_t held = order[up];
                order[up++] = order[down];
                order[down--] = held;
            }
        }
        if (down < (int64_t)middle)
            low = up;
        if ((int64_t)middle < up)
            high = down;
    }
}

/* The axis along which the points reach farthest. */
static unsigned longest_axis(const struct build *build, uint32_t first, uint32_t past)
{
    float longest = -1;
    unsigned chosen = 0;
    for (unsigned axis = 0; axis < 3; axis++) {
        float low = build->points[build->order[first]][axis], high = low;
        for (uint32_t i = first; i < past; i++) {
            const float value = build->points[build->order[i]][axis];
            low = value < low ? value : low;
            high = value > high ? value : high;
        }
        if (high - low > longest) {
            longest = high - low;
            chosen = axis;
        }
    }
    return chosen;
}

static enum core_status build_leaf(struct build *build, uint32_t node, uint32_t level, uint32_t first, uint32_t past)
{
    const struct tree *tree = build->tree;
    const uint32_t begin = build->next_beat;
    uint32_t points[CORE_(BUCKET)][3];
    enum core_status status = CORE_OK;

    for (uint32_t i = first; i < past; i++) {
        for (unsigned axis = 0; axis < 3; axis++)
            points[i - first][axis] = tree_number(build->points[build->order[i]][axis]);
        build->places[begin * CORE_(LANES) + (i - first)] = build->order[i];
    }
    build->next_beat += tree_write_points(tree, begin, (const uint32_t(*)[3])points, past - first);
    if (level < CORE_(TREE_DEPTH))
        status = tree_write_internal_leaf(tree, node);
    if (status == CORE_OK)
        status = tree_write_leaf(tree, node << (CORE_(TREE_DEPTH) - level), begin, build->next_beat - begin);
    return status;
}

/* As deep as the tree, which is TREE_DEPTH levels at most. */
static enum core_status build_node(struct build *build, uint32_t node, uint32_t level, uint32_t first, uint32_t past)
{
    enum core_status status;
    uint32_t middle;
    unsigned axis;

    if (past - first <= build->leaf_points)
        return build_leaf(build, node, level, first, past);
    axis = longest_axis(build, first, past);
    middle = first + (past - first) / 2;
    select_middle(build, first, past, middle, axis);
    /* Rounding keeps the order, so what holds of the host's numbers holds of the core's. */
    status = tree_write_node(build->tree, node, tree_number(build->points[build->order[middle]][axis]), axis);
    if (status == CORE_OK)
        status = build_node(build, 2 * node, level + 1, first, middle);
    return status == CORE_OK ? build_node(build, 2 * node + 1, level + 1, middle, past) : status;
}

enum core_status tree_build(const struct tree *tree, const float (*points)[3], uint32_t count,
                           uint32_t leaf_points, uint32_t *order, uint32_t *places)
{
    struct build build = {tree, points, leaf_points, order, places, 0};
    enum core_status status;

    if (leaf_points == 0 || leaf_points > CORE_(BUCKET) || levels_of(count, leaf_points) > CORE_(TREE_DEPTH) ||
        tree_places(count, leaf_points) / CORE_(LANES) > CORE_(POINT_BEATS))
        return CORE_WRONG_ARGUMENT;
    for (uint32_t i = 0; i < count; i++)
        order[i] = i;
    for (uint32_t i = 0; i < tree_places(count, leaf_points); i++)
        places[i] = UINT32_MAX;
    status = build_node(&build, 1, 0, 0, count);
    return status == CORE_OK ? tree_changed(tree) : status;
}
