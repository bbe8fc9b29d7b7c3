#include "search.h"

/* A run under way. */
struct run {
    uint32_t sent, answered;
};

/* Takes a result, if one has come; true if so. */
static bool take_result(const struct tree *tree, struct run *run, uint32_t count,
                        struct search_neighbor *neighbors, uint32_t *counts, bool *is_sound)
{
    uint8_t packet[SEARCH_RESULT_BYTES];
    uint32_t number;
    if (!core_receive(&tree->core, packet, sizeof packet))
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

enum core_status search_run(const struct tree *tree, const struct search_wanted *wanted, uint32_t count,
                            struct search_neighbor *neighbors, uint32_t *counts)
{
    const struct core *core = &tree->core;
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
        if (take_result(tree, &run, count, neighbors, counts, &is_sound))
            idle = 0;
    }
    if (run.answered < count || !is_sound)
        return core_abort(core, packet, SEARCH_RESULT_BYTES);
    return core_finish(core);
}
