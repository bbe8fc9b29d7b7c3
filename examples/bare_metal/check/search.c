/* Neighbor search through the driver, compared with a search through all points that shares nothing with it. */
#include "search.h"

#include "nearest.h"

#define POINTS_BASE 0x100000u
#define TREE_BASE 0x10000u
#define QUERIES 48
#define PLACES_MAX 65536

static float points[4096][3];
static uint32_t count, order[4096], places[PLACES_MAX];
static struct search_wanted wanted[QUERIES];
static struct search_neighbor neighbors[QUERIES * SEARCH_NEIGHBORS];
static uint32_t counts[QUERIES];

/* Whether a query found what there is: the right distances in order, each of the point it names, no point twice. */
static bool is_right(uint32_t query)
{
    static double distances[4096];
    const struct search_neighbor *found = &neighbors[(size_t)query * SEARCH_NEIGHBORS];
    uint32_t near = 0;
    for (uint32_t point = 0; point < count; point++) {
        const double distance = distance2(points[point], wanted[query].point);
        if (distance < value_of(wanted[query].radius2))
            distances[near++] = distance;
    }
    qsort(distances, near, sizeof distances[0], by_value);
    if (counts[query] != (near < wanted[query].k ? near : wanted[query].k))
        return false;
    for (uint32_t rank = 0; rank < counts[query]; rank++) {
        const uint32_t point = found[rank].index < PLACES_MAX ? places[found[rank].index] : UINT32_MAX;
        if (point >= count || value_of(found[rank].distance2) != distances[rank] ||
            distance2(points[point], wanted[query].point) != distances[rank])
            return false;
        for (uint32_t before = 0; before < rank; before++)
            if (found[before].index == found[rank].index)
                return false;
    }
    return true;
}

static uint32_t wrong_queries(void)
{
    uint32_t wrong = 0;
    for (uint32_t query = 0; query < QUERIES; query++)
        wrong += !is_right(query);
    return wrong;
}

/* On a coarse grid, so that many lie in a plane and many are equally far. */
static void scatter(uint32_t points_wanted, float step)
{
    count = points_wanted;
    for (uint32_t i = 0; i < count; i++)
        for (int axis = 0; axis < 3; axis++)
            points[i][axis] = step > 0 ? step * (float)(random_word() % 9) - 4 * step : random_float(-10, 10);
}

static void ask(void)
{
    for (uint32_t i = 0; i < QUERIES; i++) {
        for (int axis = 0; axis < 3; axis++)
            wanted[i].point[axis] = tree_number(i % 5 ? random_float(-10, 10) : points[random_word() % count][axis]);
        wanted[i].k = i % 3 ? 1 + random_word() % SEARCH_NEIGHBORS : SEARCH_NEIGHBORS;
        wanted[i].radius2 = i % 4 ? SEARCH_GEOMETRY_INFINITY : tree_number(random_float(0, 30));
    }
    /* Nothing is nearer than no distance at all, nor than a NaN. */
    wanted[1].radius2 = 0;
    wanted[2].point[1] = SEARCH_GEOMETRY_NAN;
}

static void build(const struct tree *search, uint32_t leaf_points)
{
    CHECK(tree_places(count, leaf_points) <= PLACES_MAX, "no room");
    CHECK_STATUS(tree_build(search, (const float(*)[3])points, count, leaf_points, order, places), CORE_OK);
}

/* A tree over points, and queries that must all be right. */
static void check_search(const struct tree *search, uint32_t points_wanted, float step, uint32_t leaf_points)
{
    uint32_t found = 0, empty = 0;
    scatter(points_wanted, step);
    ask();
    build(search, leaf_points);
    CHECK_STATUS(search_run(search, wanted, QUERIES, neighbors, counts), CORE_OK);
    for (uint32_t query = 0; query < QUERIES; query++) {
        CHECK(is_right(query), "query %u of %u points, %u a leaf", query, count, leaf_points);
        found += counts[query];
        empty += counts[query] == 0;
    }
    CHECK(found > QUERIES && counts[1] == 0 && counts[2] == 0, "%u neighbors found", found);
    CHECK(core_read(&search->core, SEARCH_PACKETS_IN) == QUERIES, "queries taken");
    CHECK(core_read(&search->core, SEARCH_PACKETS_OUT) == found + empty, "results sent");
}

/* Whatever a tree holds that nobody has written, its run comes to an end. */
static void check_unwritten(const struct tree *search)
{
    enum core_status status;
    count = 1;
    ask();
    status = search_run(search, wanted, QUERIES, neighbors, counts);
    CHECK(status == CORE_OK || status == CORE_ERRORS, "status %d", status);
    CHECK_STATUS(core_clear_errors(&search->core), CORE_OK);
}

/* Refused accesses change nothing and are counted. */
static void check_refusals(const struct tree *search)
{
    const struct core *core = &search->core;
    struct core_errors expected = {0, 0, 0, 0, 0};
    CHECK_STATUS(core_write(core, SEARCH_STATUS, 1), CORE_REFUSED);
    CHECK_STATUS(core_write(core, 0xffc, 1), CORE_REFUSED);
    CHECK_STATUS(core_write(core, SEARCH_POINTS_BASE, POINTS_BASE + 64), CORE_REFUSED);
    CHECK_STATUS(core_write(core, SEARCH_QUERIES, 0), CORE_OK);
    CHECK_STATUS(core_start(core), CORE_REFUSED);
    expected.access = 4;
    CHECK(core_read(core, SEARCH_POINTS_BASE) == POINTS_BASE, "a refused base is there");
#if !SEARCH_TREE_IN_MEMORY
    const uint64_t wrong[2] = {~UINT64_C(0), ~UINT64_C(0)};
    const struct platform *platform = core->platform;
    /* Beyond the window, right behind its end and anywhere in the range of its addresses; across its end. */
    CHECK(!platform->write_window(platform->context, SEARCH_TREE_BYTES, wrong, 1), "beyond the window");
    CHECK(!platform->write_window(platform->context, 2 * SEARCH_TREE_BYTES, wrong, 1), "beyond the window");
    CHECK(!platform->write_window(platform->context, SEARCH_TREE_BYTES - 8, wrong, 2), "across its end");
    expected.burst = SEARCH_TREE_BYTES < 4096 ? 3 : 0;
#endif
    check_errors(core, expected);
    CHECK(core_read(core, SEARCH_STATUS) & SEARCH_STATUS_ERROR, "no error told");
    CHECK_STATUS(search_run(search, wanted, QUERIES, neighbors, counts), CORE_ERRORS);
    CHECK(wrong_queries() == 0, "what was refused has changed the tree");
    CHECK_STATUS(tree_changed(search), CORE_OK);
    check_errors(core, expected);
    CHECK_STATUS(core_clear_errors(core), CORE_OK);
    check_errors(core, (struct core_errors){0, 0, 0, 0, 0});
}

/* A run that misses queries is given up; while it waits, tree and settings are locked. The next run is as ever. */
static void check_abort(const struct tree *search)
{
    struct tree lossy = *search;
    const struct platform link = losing(search->core.platform, QUERIES / 2);
    lossy.core.platform = &link;
    lossy.core.patience = IMPATIENCE;
    CHECK_STATUS(search_run(&lossy, wanted, QUERIES, neighbors, counts), CORE_ABORTED);
    CHECK_STATUS(search_run(search, wanted, QUERIES, neighbors, counts), CORE_OK);
    CHECK(wrong_queries() == 0, "after an abort");

    CHECK_STATUS(core_write(&search->core, SEARCH_QUERIES, 1), CORE_OK);
    CHECK_STATUS(core_start(&search->core), CORE_OK);
    CHECK_STATUS(core_write(&search->core, SEARCH_POINTS_BASE, 0), CORE_REFUSED);
    CHECK_STATUS(core_start(&search->core), CORE_REFUSED);
#if !SEARCH_TREE_IN_MEMORY
    CHECK_STATUS(tree_write_internal_leaf(search, 1), CORE_REFUSED);
#endif
    check_errors(&search->core, (struct core_errors){0, SEARCH_TREE_IN_MEMORY ? 2 : 3, 0, 0, 0});
    uint8_t packet[SEARCH_RESULT_BYTES];
    CHECK_STATUS(core_abort(&search->core, packet, sizeof packet), CORE_ABORTED);
    CHECK_STATUS(core_clear_errors(&search->core), CORE_OK);
    CHECK_STATUS(search_run(search, wanted, QUERIES, neighbors, counts), CORE_OK);
    CHECK(wrong_queries() == 0, "after a second abort");
}

/* The comparison finds what is wrong: a word of the tree, a point that has moved, a wrong base. */
static void check_faults(const struct tree *search)
{
    const uint32_t moved[1][3] = {{tree_number(99), tree_number(99), tree_number(99)}};
    const uint32_t nearest = neighbors[0].index / SEARCH_LANES;

    CHECK_STATUS(tree_write_node(search, 1, tree_number(-9), 0), CORE_OK);
    CHECK_STATUS(search_run(search, wanted, QUERIES, neighbors, counts), CORE_OK);
    CHECK(wrong_queries() > 0, "a wrong plane is not seen");
    build(search, SEARCH_BUCKET);
    CHECK_STATUS(search_run(search, wanted, QUERIES, neighbors, counts), CORE_OK);
    CHECK(wrong_queries() == 0, "the tree is right again");

    tree_write_points(search, nearest, moved, 1);
    CHECK_STATUS(tree_changed(search), CORE_OK);
    CHECK_STATUS(search_run(search, wanted, QUERIES, neighbors, counts), CORE_OK);
    CHECK(!is_right(0), "a wrong point is not seen");

    build(search, SEARCH_BUCKET);
    CHECK_STATUS(core_write(&search->core, SEARCH_POINTS_BASE, POINTS_BASE + 4096), CORE_OK);
    CHECK_STATUS(tree_changed(search), CORE_OK);
    CHECK_STATUS(search_run(search, wanted, QUERIES, neighbors, counts), CORE_OK);
    CHECK(wrong_queries() > 0, "a wrong base is not seen");
}

int main(int arguments, char **argument)
{
    const uint32_t seed = arguments > 1 ? (uint32_t)strtoul(argument[1], NULL, 0) : 1;
    struct platform platform = board_open(seed);
    struct tree search;
    uint32_t many = SEARCH_BUCKET << SEARCH_TREE_DEPTH;
    uint64_t cycles;

    random_state = seed;
    many = many > 3000 ? 3000 : many;
    CHECK_STATUS(tree_open(&search, &platform, PATIENCE, POINTS_BASE, TREE_BASE), CORE_OK);
    check_unwritten(&search);
    check_search(&search, many, 0, SEARCH_BUCKET);
    check_search(&search, many / 2 + 3, 2.5f, SEARCH_BUCKET);
    /* As deep as it goes, leaves of different levels; a few points; one leaf. */
    check_search(&search, SEARCH_TREE_DEPTH < 10 ? (3u << SEARCH_TREE_DEPTH) / 4 : 700, 0, 1);
    check_search(&search, SEARCH_BUCKET, 1, SEARCH_BUCKET);
    check_search(&search, many, 0, SEARCH_BUCKET);
    check_refusals(&search);
    check_abort(&search);
    check_faults(&search);
    cycles = board_cycles(&platform);
    board_close(&platform);
    return finished("search", cycles);
}
