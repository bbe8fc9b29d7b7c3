#include "search.h"

#include "numbers.h"

static const struct number_format geometry = {SEARCH_GEOMETRY_EXPONENT_BITS, SEARCH_GEOMETRY_MANTISSA_BITS};

uint32_t search_number(float value)
{
    return number_of(geometry, value);
}

float search_value(uint32_t number)
{
    return number_value(geometry, number);
}

enum core_status search_changed(const struct search *search)
{
    return core_write(&search->core, SEARCH_CONTROL, SEARCH_CONTROL_RESET);
}

enum core_status search_open(struct search *search, const struct platform *platform, uint32_t patience,
                             uint32_t points_base, uint32_t tree_base)
{
    enum core_status status = core_open(&search->core, platform, patience);
    search->points_base = points_base;
    search->tree_base = tree_base;
    if (status == CORE_OK)
        status = core_write(&search->core, SEARCH_POINTS_BASE, points_base);
#if SEARCH_TREE_IN_MEMORY
    if (status == CORE_OK)
        status = core_write(&search->core, SEARCH_TREE_BASE, tree_base);
#endif
    return status == CORE_OK ? search_changed(search) : status;
}

/* A record of the tree, to where the core has it. */
static enum core_status write_record(const struct search *search, uint32_t record, const uint8_t *bytes)
{
    const struct platform *platform = search->core.platform;
    const uint32_t place = record * SEARCH_TREE_STRIDE;
#if SEARCH_TREE_IN_MEMORY
    platform->write_memory(platform->context, search->tree_base + place, bytes, SEARCH_TREE_STRIDE);
    return CORE_OK;
#else
    const uint64_t word = core_get(bytes, 0, sizeof word);
    return platform->write_window(platform->context, place, &word, 1) ? CORE_OK : CORE_REFUSED;
#endif
}

static enum core_status write_node(const struct search *search, uint32_t node, uint32_t split, unsigned dimension,
                                   bool is_leaf)
{
    uint8_t bytes[SEARCH_TREE_STRIDE];
    core_clear(bytes, sizeof bytes);
    core_put(bytes, FIELD(search_tree_node, split), split);
    core_put(bytes, FIELD(search_tree_node, dimension), dimension);
    core_put(bytes, FIELD(search_tree_node, internal_leaf), is_leaf);
    return write_record(search, node, bytes);
}

enum core_status search_write_node(const struct search *search, uint32_t node, uint32_t split, unsigned dimension)
{
    return write_node(search, node, split, dimension, false);
}

enum core_status search_write_internal_leaf(const struct search *search, uint32_t node)
{
    return write_node(search, node, 0, 0, true);
}

enum core_status search_write_leaf(const struct search *search, uint32_t record, uint32_t begin, uint32_t beats)
{
    uint8_t bytes[SEARCH_TREE_STRIDE];
    core_clear(bytes, sizeof bytes);
    core_put(bytes, FIELD(search_tree_leaf, begin), begin);
    core_put(bytes, FIELD(search_tree_leaf, beats), beats);
    return write_record(search, record, bytes);
}

uint32_t search_write_points(const struct search *search, uint32_t beat, const uint32_t (*points)[3], uint32_t count)
{
    const struct platform *platform = search->core.platform;
    const size_t coordinate = sizeof(((struct search_points *)0)->x0);
    const uint32_t beats = count ? (count + SEARCH_LANES - 1) / SEARCH_LANES : 1;
    for (uint32_t i = 0; i < beats; i++) {
        uint8_t bytes[SEARCH_POINTS_BYTES];
        core_clear(bytes, sizeof bytes);
        for (uint32_t lane = 0; lane < SEARCH_LANES; lane++)
            for (uint32_t axis = 0; axis < 3; axis++) {
                const uint32_t point = i * SEARCH_LANES + lane;
                const uint32_t number = point < count ? points[point][axis] : SEARCH_GEOMETRY_NAN;
                core_put(bytes, (lane * 3 + axis) * coordinate, coordinate, number);
            }
        platform->write_memory(platform->context, search->points_base + (beat + i) * SEARCH_POINTS_BYTES, bytes,
                               sizeof bytes);
    }
    return beats;
}

/* A run under way. */
struct run {
    uint32_t sent, answered;
};

/* Takes a result, if one has come; true if so. */
static bool take_result(const struct search *search, struct run *run, uint32_t count,
                        struct search_neighbor *neighbors, uint32_t *counts, bool *is_sound)
{
    uint8_t packet[SEARCH_RESULT_BYTES];
    uint32_t number;
    if (!core_receive(&search->core, packet, sizeof packet))
        return false;
    number = (uint32_t)core_get(packet, FIELD(search_result, number));
    if (number >= count || counts[number] >= SEARCH_NEIGHBORS) {
        *is_sound = false;
        return true;
    }
    if (core_get(packet, FIELD(search_result, found))) {
        struct search_neighbor *neighbor = &neighbors[(size_t)number * SEARCH_NEIGHBORS + counts[number]++];
        neighbor->index = (uint32_t)core_get(packet, FIELD(search_result, index));
        neighbor->distance2 = (uint32_t)core_get(packet, FIELD(search_result, distance2));
    }
    run->answered += (uint32_t)core_get(packet, FIELD(search_result, last));
    return true;
}

static void make_query(uint8_t *packet, uint32_t number, const struct search_wanted *wanted)
{
    core_clear(packet, SEARCH_QUERY_BYTES);
    core_put(packet, FIELD(search_query, number), number);
    core_put(packet, FIELD(search_query, k), wanted->k);
    core_put(packet, FIELD(search_query, radius2), wanted->radius2);
    core_put(packet, FIELD(search_query, x), wanted->point[0]);
    core_put(packet, FIELD(search_query, y), wanted->point[1]);
    core_put(packet, FIELD(search_query, z), wanted->point[2]);
}

enum core_status search_run(const struct search *search, const struct search_wanted *wanted, uint32_t count,
                            struct search_neighbor *neighbors, uint32_t *counts)
{
    const struct core *core = &search->core;
    uint8_t packet[SEARCH_QUERY_BYTES > SEARCH_RESULT_BYTES ? SEARCH_QUERY_BYTES : SEARCH_RESULT_BYTES];
    struct run run = {0, 0};
    uint32_t idle = 0;
    bool is_sound = true;
    enum core_status status;

    if (count == 0 || ((uint64_t)count - 1) >> SEARCH_INDEX_BITS)
        return CORE_WRONG_ARGUMENT;
    for (uint32_t i = 0; i < count; i++) {
        /* The core would refuse the query, and go on waiting for one. */
        if (wanted[i].k == 0 || wanted[i].k > SEARCH_NEIGHBORS || wanted[i].radius2 > SEARCH_GEOMETRY_INFINITY)
            return CORE_WRONG_ARGUMENT;
        counts[i] = 0;
    }
    status = core_write(core, SEARCH_QUERIES, count);
    if (status == CORE_OK)
        status = core_start(core);
    if (status != CORE_OK)
        return status;
    /* Results are taken while queries are sent: the core does not hold all of either. */
    while (run.answered < count && is_sound && idle <= core->patience) {
        idle++;
        if (run.sent < count) {
            make_query(packet, run.sent, &wanted[run.sent]);
            if (core_send(core, packet, SEARCH_QUERY_BYTES)) {
                run.sent++;
                idle = 0;
            }
        }
        if (take_result(search, &run, count, neighbors, counts, &is_sound))
            idle = 0;
    }
    if (run.answered < count || !is_sound)
        return core_abort(core, packet, SEARCH_RESULT_BYTES);
    return core_finish(core);
}
