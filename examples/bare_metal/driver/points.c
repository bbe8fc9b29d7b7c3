#include "points.h"

enum core_status points_open(struct points *points, const struct platform *platform, uint32_t patience,
                             uint32_t points_base, uint32_t tree_base, uint32_t lines_base)
{
    const enum core_status status = tree_open(&points->tree, platform, patience, points_base, tree_base);
    points->lines_base = lines_base;
    return status == CORE_OK ? core_write(&points->tree.core, POINTS_LINES_BASE, lines_base) : status;
}

void points_write_point(const struct points *points, uint32_t place, const uint8_t point[POINTS_POINT_BYTES])
{
    const struct platform *platform = points->tree.core.platform;
    const uint32_t address = points->lines_base + place * POINTS_POINT_STRIDE;
    platform->write_memory(platform->context, address, point, POINTS_POINT_BYTES);
}

/* Takes a result, if one has come, to its query's place; true if so. */
static bool take_result(const struct core *core, uint32_t count, uint8_t (*results)[POINTS_RESULT_BYTES],
                        bool *is_sound)
{
    uint8_t packet[POINTS_RESULT_BYTES];
    uint32_t number;
    if (!core_receive(core, packet, sizeof packet))
        return false;
    number = (uint32_t)core_get(packet, FIELD(points_result, number));
    if (number >= count) {
        *is_sound = false;
        return true;
    }
    for (size_t byte = 0; byte < sizeof packet; byte++)
        results[number][byte] = packet[byte];
    return true;
}

/* What holds of a run, and its start. */
static enum core_status begin(const struct core *core, const struct points_rules *rules, uint32_t count)
{
    enum core_status status = core_write(core, POINTS_K, rules->k);
    if (status == CORE_OK)
        status = core_write(core, POINTS_RADIUS2, rules->radius2);
    if (status == CORE_OK)
        status = core_write(core, POINTS_ITERATIONS_MAX, rules->iterations_max);
    if (status == CORE_OK)
        status = core_write(core, POINTS_QUERIES, count);
    return status == CORE_OK ? core_start(core) : status;
}

enum core_status points_run(const struct points *points, const struct points_rules *rules,
                            uint8_t (*queries)[POINTS_QUERY_BYTES], uint32_t count,
                            uint8_t (*results)[POINTS_RESULT_BYTES])
{
    const struct core *core = &points->tree.core;
    uint32_t sent = 0, answered = 0, idle = 0;
    bool is_sound = true;
    enum core_status status;

    if (count == 0 || ((uint64_t)count - 1) >> POINTS_QUERY_NUMBER_BITS)
        return CORE_WRONG_ARGUMENT;
    status = begin(core, rules, count);
    if (status != CORE_OK)
        return status;
    /* Results are taken while queries are sent: the core does not hold all of either. */
    while (answered < count && is_sound && idle <= core->patience) {
        idle++;
        if (sent < count) {
            core_put(queries[sent], FIELD(points_query, number), sent);
            if (core_send(core, queries[sent], POINTS_QUERY_BYTES)) {
                sent++;
                idle = 0;
            }
        }
        if (take_result(core, count, results, &is_sound)) {
            answered++;
            idle = 0;
        }
    }
    if (answered < count || !is_sound) {
        uint8_t packet[POINTS_RESULT_BYTES];
        return core_abort(core, packet, sizeof packet);
    }
    return core_finish(core);
}
