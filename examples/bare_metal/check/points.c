/*
 * Moving least squares through the driver, compared with an evaluation in double precision over a search through all
 * points. Neither shares anything with the driver.
 */
#include "points.h"

#include "nearest.h"

#ifndef POINTS_SETTING_TOLERANCE
#error "this check is of the program mls"
#endif

#define POINTS_BASE 0x100000u
#define TREE_BASE 0x10000u
#define LINES_BASE 0x400000u
#define QUERIES 40
#define POINTS_MAX 1200
#define PLACES_MAX 65536

/* Radius of the sphere that points lie about, within which they weigh, and at which a query is done. */
#define SPHERE 4.0f
#define REACH 1.0f
#define TOLERANCE 0.001f

static float points[POINTS_MAX][3], normals[POINTS_MAX][3];
static uint32_t count, order[POINTS_MAX], places[PLACES_MAX];
static uint8_t queries[QUERIES][POINTS_QUERY_BYTES], results[QUERIES][POINTS_RESULT_BYTES];

/* What a query should come to. */
struct expected {
    double position[3], normal[3];
    uint32_t iterations;
    bool is_valid, is_capped;
    /* A residual came so near to the tolerance that rounding may decide. */
    bool is_close;
};

/* What rounding may amount to: more units in the last place of the largest coordinate than a query has neighbors. */
static double rounding(void)
{
    return ldexp(64 * SPHERE, -(int)POINTS_GEOMETRY_MANTISSA_BITS);
}

/* Points about a sphere, rougher than it, with the sphere's normals. */
static void scatter(uint32_t points_wanted)
{
    count = points_wanted;
    for (uint32_t i = 0; i < count; i++) {
        float length = 0;
        while (length < 0.1f) {
            for (int axis = 0; axis < 3; axis++)
                normals[i][axis] = random_float(-1, 1);
            length = sqrtf(normals[i][0] * normals[i][0] + normals[i][1] * normals[i][1] +
                           normals[i][2] * normals[i][2]);
        }
        for (int axis = 0; axis < 3; axis++) {
            normals[i][axis] /= length;
            points[i][axis] = normals[i][axis] * (SPHERE + random_float(-0.05f, 0.05f));
        }
    }
}

static void put_position(uint32_t query, const uint32_t position[3])
{
    core_clear(queries[query], POINTS_QUERY_BYTES);
    core_put(queries[query], FIELD(points_query, query_position_x), position[0]);
    core_put(queries[query], FIELD(points_query, query_position_y), position[1]);
    core_put(queries[query], FIELD(points_query, query_position_z), position[2]);
}

static void get_position(uint32_t query, uint32_t position[3])
{
    position[0] = (uint32_t)core_get(queries[query], FIELD(points_query, query_position_x));
    position[1] = (uint32_t)core_get(queries[query], FIELD(points_query, query_position_y));
    position[2] = (uint32_t)core_get(queries[query], FIELD(points_query, query_position_z));
}

/* Near the surface; one far from it, one nowhere. */
static void ask(void)
{
    for (uint32_t i = 0; i < QUERIES; i++) {
        const float *near = points[random_word() % count];
        uint32_t position[3];
        for (int axis = 0; axis < 3; axis++)
            position[axis] = tree_number(i == 1 ? 99 : near[axis] + random_float(-0.2f, 0.2f));
        if (i == 2)
            position[1] = POINTS_GEOMETRY_NAN;
        put_position(i, position);
    }
}

static void set(const struct points *device, uint32_t setting, float value)
{
    CHECK_STATUS(core_write(&device->tree.core, setting, tree_number(value)), CORE_OK);
}

static void write_point(const struct points *device, uint32_t place, uint32_t point)
{
    uint8_t record[POINTS_POINT_BYTES];
    core_clear(record, sizeof record);
    core_put(record, FIELD(points_point, position_x), tree_number(points[point][0]));
    core_put(record, FIELD(points_point, position_y), tree_number(points[point][1]));
    core_put(record, FIELD(points_point, position_z), tree_number(points[point][2]));
    core_put(record, FIELD(points_point, normal_x), tree_number(normals[point][0]));
    core_put(record, FIELD(points_point, normal_y), tree_number(normals[point][1]));
    core_put(record, FIELD(points_point, normal_z), tree_number(normals[point][2]));
    points_write_point(device, place, record);
}

static void build(const struct points *device, uint32_t leaf_points)
{
    const uint32_t all = tree_places(count, leaf_points);
    CHECK(all <= PLACES_MAX, "no room");
    CHECK_STATUS(tree_build(&device->tree, (const float(*)[3])points, count, leaf_points, order, places), CORE_OK);
    for (uint32_t place = 0; place < all; place++)
        if (places[place] < count)
            write_point(device, place, places[place]);
    CHECK_STATUS(tree_changed(&device->tree), CORE_OK);
}

/* An iteration at `at`: the plane through the neighbors' weighted mean. False if nothing weighs. */
static bool fit(const double at[3], const struct points_rules *rules, double mean[3], double normal[3])
{
    static double distances[POINTS_MAX], sorted[POINTS_MAX];
    uint32_t place[3], near = 0;
    double weight = 0, length = 0, limit;
    for (int axis = 0; axis < 3; axis++) {
        place[axis] = tree_number((float)at[axis]);
        mean[axis] = normal[axis] = 0;
    }
    for (uint32_t point = 0; point < count; point++) {
        distances[point] = distance2(points[point], place);
        if (distances[point] < value_of(rules->radius2))
            sorted[near++] = distances[point];
    }
    qsort(sorted, near, sizeof sorted[0], by_value);
    if (near == 0)
        return false;
    limit = sorted[(near < rules->k ? near : rules->k) - 1];
    for (uint32_t point = 0; point < count; point++) {
        const double below = 1 - distances[point] / (REACH * REACH);
        const double theta = below > 0 ? below * below * below * below : 0;
        if (!(distances[point] < value_of(rules->radius2) && distances[point] <= limit))
            continue;
        weight += theta;
        for (int axis = 0; axis < 3; axis++) {
            mean[axis] += theta * (rounded(points[point][axis]) - at[axis]);
            normal[axis] += theta * rounded(normals[point][axis]);
        }
    }
    for (int axis = 0; axis < 3; axis++)
        length += normal[axis] * normal[axis];
    for (int axis = 0; axis < 3; axis++) {
        mean[axis] /= weight;
        normal[axis] /= sqrt(length);
    }
    return weight > 0 && length > 0;
}

/* Thesis 6.2: the foot of the start on the plane, again and again. */
static struct expected project(uint32_t query, const struct points_rules *rules)
{
    struct expected expected = {.is_valid = false};
    uint32_t bits[3];
    double start[3];
    get_position(query, bits);
    for (int axis = 0; axis < 3; axis++)
        start[axis] = expected.position[axis] = value_of(bits[axis]);
    for (bool is_done = false; !is_done && expected.iterations < rules->iterations_max;) {
        double mean[3], normal[3], residual = 0, along = 0;
        expected.iterations++;
        expected.is_valid = fit(expected.position, rules, mean, normal);
        if (!expected.is_valid)
            return expected;
        for (int axis = 0; axis < 3; axis++) {
            residual += normal[axis] * mean[axis];
            along += normal[axis] * (expected.position[axis] - start[axis] + mean[axis]);
        }
        for (int axis = 0; axis < 3; axis++) {
            expected.position[axis] = start[axis] + normal[axis] * along;
            expected.normal[axis] = normal[axis];
        }
        is_done = fabs(residual) <= TOLERANCE;
        expected.is_close = expected.is_close || fabs(fabs(residual) - TOLERANCE) < rounding();
        expected.is_capped = !is_done;
    }
    return expected;
}

/* Whether a result is what its query should come to; `close` counts those that rounding may decide. */
static bool is_right(uint32_t query, const struct points_rules *rules, uint32_t *close)
{
    const uint8_t *result = results[query];
    const struct expected expected = project(query, rules);
    const uint32_t position[3] = {(uint32_t)core_get(result, FIELD(points_result, output_position_x)),
                                  (uint32_t)core_get(result, FIELD(points_result, output_position_y)),
                                  (uint32_t)core_get(result, FIELD(points_result, output_position_z))};
    const uint32_t normal[3] = {(uint32_t)core_get(result, FIELD(points_result, output_normal_x)),
                                (uint32_t)core_get(result, FIELD(points_result, output_normal_y)),
                                (uint32_t)core_get(result, FIELD(points_result, output_normal_z))};
    uint32_t start[3];

    if (core_get(result, FIELD(points_result, number)) != query ||
        core_get(result, FIELD(points_result, output_valid)) != expected.is_valid)
        return false;
    if (!expected.is_valid) {
        /* Where nothing weighs the query stays, bit for bit. */
        get_position(query, start);
        for (int axis = 0; axis < 3; axis++)
            if (position[axis] != start[axis] || normal[axis] != 0)
                return false;
        return core_get(result, FIELD(points_result, iterations)) == expected.iterations;
    }
    if (expected.is_close) {
        ++*close;
        return true;
    }
    for (int axis = 0; axis < 3; axis++)
        if (!(fabs(value_of(position[axis]) - expected.position[axis]) <= rounding()) ||
            !(fabs(value_of(normal[axis]) - expected.normal[axis]) <= 4 * rounding()))
            return false;
    return core_get(result, FIELD(points_result, iterations)) == expected.iterations &&
           core_get(result, FIELD(points_result, capped)) == expected.is_capped;
}

static uint32_t wrong_queries(const struct points_rules *rules)
{
    uint32_t wrong = 0, close = 0;
    for (uint32_t query = 0; query < QUERIES; query++)
        wrong += !is_right(query, rules, &close);
    CHECK(close < QUERIES / 4, "rounding may decide %u of %u queries", close, QUERIES);
    return wrong;
}

static enum core_status run(const struct points *device, const struct points_rules *rules)
{
    for (uint32_t query = 0; query < QUERIES; query++)
        for (size_t byte = 0; byte < POINTS_RESULT_BYTES; byte++)
            results[query][byte] = 0xff;
    return points_run(device, rules, queries, QUERIES, results);
}

static void check_run(const struct points *device, const struct points_rules *rules)
{
    const struct core *core = &device->tree.core;
    uint32_t valid = 0;
    CHECK_STATUS(run(device, rules), CORE_OK);
    CHECK(wrong_queries(rules) == 0, "%u of %u, k %u", wrong_queries(rules), QUERIES, rules->k);
    for (uint32_t query = 0; query < QUERIES; query++)
        valid += (uint32_t)core_get(results[query], FIELD(points_result, output_valid));
    CHECK(valid > QUERIES * 3 / 4 && valid <= QUERIES - 2, "%u of %u are valid", valid, QUERIES);
    CHECK(core_read(core, POINTS_PACKETS_IN) == QUERIES, "queries taken");
    CHECK(core_read(core, POINTS_PACKETS_OUT) == QUERIES, "results sent");
    CHECK(core_read(core, POINTS_EVENT_KERNEL) > QUERIES, "neighbors summed");
}

/* Refused accesses change nothing and are counted. */
static void check_refusals(const struct points *device, const struct points_rules *rules)
{
    const struct core *core = &device->tree.core;
    const uint32_t negative = tree_number(-1);
    CHECK_STATUS(core_write(core, POINTS_K, 0), CORE_REFUSED);
    CHECK_STATUS(core_write(core, POINTS_K, POINTS_NEIGHBORS + 1), CORE_REFUSED);
    CHECK_STATUS(core_write(core, POINTS_RADIUS2, negative), CORE_REFUSED);
    CHECK_STATUS(core_write(core, POINTS_RADIUS2, POINTS_GEOMETRY_NAN), CORE_REFUSED);
    CHECK_STATUS(core_write(core, POINTS_ITERATIONS_MAX, 0), CORE_REFUSED);
    CHECK_STATUS(core_write(core, POINTS_LINES_BASE, LINES_BASE + 64), CORE_REFUSED);
    CHECK_STATUS(core_write(core, POINTS_STATUS, 1), CORE_REFUSED);
    CHECK_STATUS(core_write(core, POINTS_QUERIES, 0), CORE_OK);
    CHECK_STATUS(core_start(core), CORE_REFUSED);
    CHECK(core_read(core, POINTS_K) == rules->k && core_read(core, POINTS_LINES_BASE) == LINES_BASE,
          "what was refused is there");
    check_errors(core, (struct core_errors){8, 0, 0, 0, 0});
    CHECK_STATUS(run(device, rules), CORE_ERRORS);
    CHECK(wrong_queries(rules) == 0, "after refusals");
    CHECK_STATUS(core_clear_errors(core), CORE_OK);
    check_errors(core, (struct core_errors){0, 0, 0, 0, 0});
}

/* A run that misses queries is given up; while it waits, settings are locked. The next run is as ever. */
static void check_abort(const struct points *device, const struct points_rules *rules)
{
    const struct core *core = &device->tree.core;
    struct points lossy = *device;
    const struct platform link = losing(core->platform, QUERIES / 2);
    uint8_t packet[POINTS_RESULT_BYTES];
    lossy.tree.core.platform = &link;
    lossy.tree.core.patience = IMPATIENCE;
    CHECK_STATUS(run(&lossy, rules), CORE_ABORTED);
    CHECK_STATUS(run(device, rules), CORE_OK);
    CHECK(wrong_queries(rules) == 0, "after an abort");

    CHECK_STATUS(core_write(core, POINTS_QUERIES, 1), CORE_OK);
    CHECK_STATUS(core_start(core), CORE_OK);
    CHECK_STATUS(core_write(core, POINTS_SETTING_TOLERANCE, 0), CORE_REFUSED);
    CHECK_STATUS(core_write(core, POINTS_LINES_BASE, 0), CORE_REFUSED);
    CHECK_STATUS(core_write(core, POINTS_K, 1), CORE_REFUSED);
    check_errors(core, (struct core_errors){0, 3, 0, 0, 0});
    CHECK_STATUS(core_abort(core, packet, sizeof packet), CORE_ABORTED);
    CHECK_STATUS(core_clear_errors(core), CORE_OK);
    CHECK_STATUS(run(device, rules), CORE_OK);
    CHECK(wrong_queries(rules) == 0, "after a second abort");
}

/* Memory that answers with errors ends the run all the same, and is told of. */
static void check_memory_errors(const struct points *device, const struct points_rules *rules)
{
    const struct core *core = &device->tree.core;
    CHECK_STATUS(core_write(core, POINTS_LINES_BASE, BOARD_MEMORY_BYTES), CORE_OK);
    CHECK_STATUS(tree_changed(&device->tree), CORE_OK);
    CHECK_STATUS(run(device, rules), CORE_ERRORS);
    CHECK(core_errors(core).memory > 0, "memory errors");
    CHECK_STATUS(core_clear_errors(core), CORE_OK);
    CHECK_STATUS(core_write(core, POINTS_LINES_BASE, LINES_BASE), CORE_OK);
    CHECK_STATUS(tree_changed(&device->tree), CORE_OK);
    CHECK_STATUS(run(device, rules), CORE_OK);
    CHECK(wrong_queries(rules) == 0, "after memory errors");
}

static void check_fault(const struct points *device, const struct points_rules *rules, const char *what)
{
    CHECK_STATUS(tree_changed(&device->tree), CORE_OK);
    CHECK_STATUS(run(device, rules), CORE_OK);
    CHECK(wrong_queries(rules) > 0, "%s is not seen", what);
    build(device, POINTS_BUCKET);
}

/* The comparison finds what is wrong: a normal, a point the search knows, a plane, a base, a setting. */
static void check_faults(const struct points *device, const struct points_rules *rules)
{
    const struct core *core = &device->tree.core;
    const uint32_t moved[1][3] = {{tree_number(99), tree_number(99), tree_number(99)}};

    for (uint32_t place = 0; place < tree_places(count, POINTS_BUCKET); place += 16)
        if (places[place] < count)
            write_point(device, place, (places[place] + 1) % count);
    check_fault(device, rules, "another point's line");
    for (uint32_t beat = 0; beat < tree_places(count, POINTS_BUCKET) / POINTS_LANES; beat += 8)
        tree_write_points(&device->tree, beat, moved, 1);
    check_fault(device, rules, "a point that has moved");
    CHECK_STATUS(tree_write_node(&device->tree, 1, tree_number(-9), 0), CORE_OK);
    check_fault(device, rules, "a wrong plane");
    CHECK_STATUS(core_write(core, POINTS_LINES_BASE, LINES_BASE + 4096), CORE_OK);
    check_fault(device, rules, "a wrong base");
    CHECK_STATUS(core_write(core, POINTS_LINES_BASE, LINES_BASE), CORE_OK);
    set(device, POINTS_SETTING_INVERSE_RADIUS2, 2 / (REACH * REACH));
    check_fault(device, rules, "a wrong setting");
    set(device, POINTS_SETTING_INVERSE_RADIUS2, 1 / (REACH * REACH));
    CHECK_STATUS(run(device, rules), CORE_OK);
    CHECK(wrong_queries(rules) == 0, "all is right again");
}

int main(int arguments, char **argument)
{
    const uint32_t seed = arguments > 1 ? (uint32_t)strtoul(argument[1], NULL, 0) : 1;
    struct platform platform = board_open(seed);
    const struct points_rules once = {4, POINTS_GEOMETRY_INFINITY, 1};
    const struct points_rules ball = {POINTS_NEIGHBORS, tree_number(REACH * REACH), 8};
    struct points device;
    uint64_t cycles;

    random_state = seed;
    CHECK_STATUS(points_open(&device, &platform, PATIENCE, POINTS_BASE, TREE_BASE, LINES_BASE), CORE_OK);
    set(&device, POINTS_SETTING_INVERSE_RADIUS2, 1 / (REACH * REACH));
    set(&device, POINTS_SETTING_TOLERANCE, TOLERANCE);
    /* Fewer points within reach than a query may have, so that no neighbor comes and goes by rounding. */
    scatter(POINTS_NEIGHBORS * 12);
    ask();
    build(&device, POINTS_BUCKET);
    check_run(&device, &ball);
    check_run(&device, &once);
    build(&device, 1);
    check_run(&device, &ball);
    build(&device, POINTS_BUCKET);
    check_run(&device, &ball);
    check_refusals(&device, &ball);
    check_abort(&device, &ball);
    check_memory_errors(&device, &ball);
    check_faults(&device, &ball);
    cycles = board_cycles(&platform);
    board_close(&platform);
    return finished("points", cycles);
}
