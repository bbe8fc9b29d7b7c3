#include "tree.h"

#include "numbers.h"

static const struct number_format geometry = {CORE_(GEOMETRY_EXPONENT_BITS), CORE_(GEOMETRY_MANTISSA_BITS)};

uint32_t tree_number(float value)
{
    return number_of(geometry, value);
}

float tree_value(uint32_t number)
{
    return number_value(geometry, number);
}

enum core_status tree_changed(const struct tree *tree)
{
    return core_write(&tree->core, CORE_(CONTROL), CORE_(CONTROL_RESET));
}

enum core_status tree_open(struct tree *tree, const struct platform *platform, uint32_t patience,
                           uint32_t points_base, uint32_t tree_base)
{
    enum core_status status = core_open(&tree->core, platform, patience);
    tree->points_base = points_base;
    tree->tree_base = tree_base;
    if (status == CORE_OK)
        status = core_write(&tree->core, CORE_(POINTS_BASE), points_base);
#if CORE_(TREE_IN_MEMORY)
    if (status == CORE_OK)
        status = core_write(&tree->core, CORE_(TREE_BASE), tree_base);
#endif
    return status == CORE_OK ? tree_changed(tree) : status;
}

/* A record of the tree, to where the core has it. */
static enum core_status write_record(const struct tree *tree, uint32_t record, const uint8_t *bytes)
{
    const struct platform *platform = tree->core.platform;
    const uint32_t place = record * CORE_(TREE_STRIDE);
#if CORE_(TREE_IN_MEMORY)
    platform->write_memory(platform->context, tree->tree_base + place, bytes, CORE_(TREE_STRIDE));
    return CORE_OK;
#else
    const uint64_t word = core_get(bytes, 0, sizeof word);
    return platform->write_window(platform->context, place, &word, 1) ? CORE_OK : CORE_REFUSED;
#endif
}

static enum core_status write_node(const struct tree *tree, uint32_t node, uint32_t split, unsigned dimension,
                                   bool is_leaf)
{
    uint8_t bytes[CORE_(TREE_STRIDE)];
    core_clear(bytes, sizeof bytes);
    core_put(bytes, FIELD(RECORD_(tree_node), split), split);
    core_put(bytes, FIELD(RECORD_(tree_node), dimension), dimension);
    core_put(bytes, FIELD(RECORD_(tree_node), internal_leaf), is_leaf);
    return write_record(tree, node, bytes);
}

enum core_status tree_write_node(const struct tree *tree, uint32_t node, uint32_t split, unsigned dimension)
{
    return write_node(tree, node, split, dimension, false);
}

enum core_status tree_write_internal_leaf(const struct tree *tree, uint32_t node)
{
    return write_node(tree, node, 0, 0, true);
}

enum core_status tree_write_leaf(const struct tree *tree, uint32_t record, uint32_t begin, uint32_t beats)
{
    uint8_t bytes[CORE_(TREE_STRIDE)];
    core_clear(bytes, sizeof bytes);
    core_put(bytes, FIELD(RECORD_(tree_leaf), begin), begin);
    core_put(bytes, FIELD(RECORD_(tree_leaf), beats), beats);
    return write_record(tree, record, bytes);
}

uint32_t tree_write_points(const struct tree *tree, uint32_t beat, const uint32_t (*points)[3], uint32_t count)
{
    const struct platform *platform = tree->core.platform;
    const size_t coordinate = sizeof(((struct RECORD_(points) *)0)->x0);
    const uint32_t beats = count ? (count + CORE_(LANES) - 1) / CORE_(LANES) : 1;
    for (uint32_t i = 0; i < beats; i++) {
        uint8_t bytes[CORE_(POINTS_BYTES)];
        core_clear(bytes, sizeof bytes);
        for (uint32_t lane = 0; lane < CORE_(LANES); lane++)
            for (uint32_t axis = 0; axis < 3; axis++) {
                const uint32_t point = i * CORE_(LANES) + lane;
                const uint32_t number = point < count ? points[point][axis] : CORE_(GEOMETRY_NAN);
                core_put(bytes, (lane * 3 + axis) * coordinate, coordinate, number);
            }
        platform->write_memory(platform->context, tree->points_base + (beat + i) * CORE_(POINTS_BYTES), bytes,
                               sizeof bytes);
    }
    return beats;
}
