/*
 * Programs on neighborhoods from C: the normals of a sphere, which are known, a program of one's own, checked against a
 * loop over all points, and the same by the model of the point processor and by its hardware, bit by bit. Exits with 0
 * if all is as it should be.
 *
 *   cc -I bindings/c/include bindings/c/examples/process.c -L target/debug -lpointcore -lm
 */
#include <math.h>
#include <pointcore.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { POINTS = 600 };

#define CHECK(condition) \
    do { \
        if (!(condition)) { \
            fprintf(stderr, "line %d: not so: %s (%s)\n", __LINE__, #condition, pointcore_error_message()); \
            exit(1); \
        } \
    } while (0)

/* Whether a call fails with this status, and with a message that has this in it. */
#define FAILS(call, wanted, part) \
    do { \
        CHECK((call) == (wanted)); \
        CHECK(strstr(pointcore_error_message(), (part)) != NULL); \
    } while (0)

static const char HEAT[] =
    ".program heat\n"
    ".setting gain: float\n"
    ".neighbor heat: float\n"
    ".kernel\n"
    "d = sub neighbor.position, query.position\n"
    "squared = length2 d\n"
    "share = mul squared, neighbor.heat\n"
    "accumulate shares, share\n"
    ".final\n"
    "total = mul shares, gain\n"
    "output total, total\n"
    "output count, neighbors\n";

static double points[3 * POINTS], heats[POINTS];

/* Points on a unit sphere, evenly spread. */
static void make_points(void) {
    for (int i = 0; i < POINTS; i++) {
        double z = 1.0 - (2.0 * i + 1.0) / POINTS, around = 2.399963229728653 * i, across = sqrt(1.0 - z * z);
        const double point[] = {across * cos(around), across * sin(around), z};
        memcpy(points + 3 * i, point, sizeof point);
        heats[i] = 1.0 + i % 7;
    }
}

static void normals(void) {
    const PointcoreCloud cloud = {.points = points, .count = POINTS};
    PointcoreProcess *process;
    PointcoreProcessed *processed;
    size_t components = 0;
    CHECK(pointcore_process_open("normals", NULL, POINTCORE_BACK_END_INTERPRETER, &process) == POINTCORE_STATUS_OK);
    CHECK(pointcore_process(process, &cloud, NULL, NULL, &processed) == POINTCORE_STATUS_OK);
    const PointcoreProcessedArrays arrays = pointcore_processed_arrays(processed);
    const double *normal = pointcore_processed_output(processed, "normal", &components);
    CHECK(arrays.count == POINTS && normal != NULL && components == 3 && arrays.cycles == 0);
    CHECK(arrays.valid != NULL && strstr(arrays.report, "\"operation\":\"normals\"") != NULL);
    for (int i = 0; i < POINTS; i++) {
        double dot = 0.0;
        for (int axis = 0; axis < 3; axis++) dot += normal[3 * i + axis] * points[3 * i + axis];
        CHECK(fabs(dot) > 0.99 && arrays.valid[i] == 1 && arrays.capped[i] == 0 && arrays.neighbors[i] == 16);
        CHECK(arrays.iterations[i] == 1 && arrays.positions[3 * i] == points[3 * i]);
    }
    CHECK(strcmp(pointcore_processed_name(processed, 0), "normal") == 0);
    CHECK(pointcore_processed_name(processed, 3) == NULL);
    CHECK(pointcore_processed_output(processed, "position", NULL) == NULL);
    pointcore_processed_close(processed);
    pointcore_process_close(process);
    printf("normals of %d points\n", POINTS);
}

/* A program of one's own: its sums within a radius, for points and for some queries, by one back end. */
static void heat(uint32_t back_end, double *totals) {
    const double gain = 2.0, radius = 0.3, queries[] = {0.0, 0.0, 1.0, 0.0, 0.0, 5.0};
    const PointcoreNamedNumbers attribute = {.name = "heat", .values = heats, .components = 1, .count = POINTS};
    const PointcoreNamedNumbers setting = {.name = "gain", .values = &gain, .components = 1, .count = 1};
    const PointcoreCloud cloud = {.points = points, .count = POINTS, .attributes = &attribute, .attributes_count = 1};
    const PointcoreCloud asked = {.points = queries, .count = 2};
    const PointcoreProcessOptions options = {
        .k = 64, .radius = radius, .iterations = 1, .passes = 1, .settings = &setting, .settings_count = 1};
    PointcoreProcess *process;
    PointcoreProcessed *processed;
    CHECK(pointcore_process_open(HEAT, NULL, back_end, &process) == POINTCORE_STATUS_OK);
    CHECK(pointcore_process(process, &cloud, NULL, &options, &processed) == POINTCORE_STATUS_OK);
    const PointcoreProcessedArrays arrays = pointcore_processed_arrays(processed);
    const double *total = pointcore_processed_output(processed, "total", NULL);
    const double *count = pointcore_processed_output(processed, "count", NULL);
    CHECK(total != NULL && count != NULL && arrays.valid == NULL);
    CHECK((back_end == POINTCORE_BACK_END_INTERPRETER) == (arrays.cycles == 0));
    CHECK((back_end == POINTCORE_BACK_END_INTERPRETER) == (arrays.neighbors != NULL));
    for (int i = 0; i < POINTS; i++) {
        double sum = 0.0;
        int near = 0;
        for (int j = 0; j < POINTS; j++) {
            double squared = 0.0;
            for (int axis = 0; axis < 3; axis++) squared += pow(points[3 * j + axis] - points[3 * i + axis], 2.0);
            if (squared >= radius * radius) continue;
            sum += gain * heats[j] * squared;
            near++;
        }
        CHECK(count[i] == near && fabs(total[i] - sum) <= 1e-5 * sum);
    }
    memcpy(totals, total, POINTS * sizeof *total);
    pointcore_processed_close(processed);
    CHECK(pointcore_process(process, &cloud, &asked, &options, &processed) == POINTCORE_STATUS_OK);
    total = pointcore_processed_output(processed, "total", NULL);
    CHECK(pointcore_processed_arrays(processed).count == 2 && total[0] > 0.0 && total[1] == 0.0);
    pointcore_processed_close(processed);
    pointcore_process_close(process);
}

static void mistakes(void) {
    const double one = 1.0;
    PointcoreNamedNumbers attribute = {.name = "heat", .values = heats, .components = 1, .count = POINTS - 1};
    PointcoreNamedNumbers setting = {.name = "speed", .values = &one, .components = 1, .count = 1};
    PointcoreCloud cloud = {.points = points, .count = POINTS, .attributes = &attribute, .attributes_count = 1};
    PointcoreProcessOptions options = {
        .k = 65, .radius = INFINITY, .iterations = 1, .passes = 1, .settings = &setting, .settings_count = 0};
    PointcoreProcess *process = NULL;
    PointcoreProcessed *processed = NULL;
    const uint32_t interpreter = POINTCORE_BACK_END_INTERPRETER;
    FAILS(pointcore_process_open("smoothe", NULL, interpreter, &process), POINTCORE_STATUS_INPUT, "`smoothe`");
    FAILS(pointcore_process_open(NULL, NULL, interpreter, &process), POINTCORE_STATUS_INPUT, "`program` is NULL");
    FAILS(pointcore_process_open("no.pasm", NULL, interpreter, &process), POINTCORE_STATUS_FILE, "no.pasm");
    FAILS(pointcore_process_open(".program x\n.kernel\na = add 1, 1.0\n", NULL, interpreter, &process),
          POINTCORE_STATUS_INPUT, "program:3:");
    CHECK(pointcore_process_open(HEAT, NULL, interpreter, &process) == POINTCORE_STATUS_OK);
    FAILS(pointcore_process(process, &cloud, NULL, NULL, &processed), POINTCORE_STATUS_INPUT, "shape (599,)");
    attribute.components = 2;
    FAILS(pointcore_process(process, &cloud, NULL, NULL, &processed), POINTCORE_STATUS_INPUT, "2 components");
    attribute.components = 3;
    attribute.count = SIZE_MAX / 2;
    FAILS(pointcore_process(process, &cloud, NULL, NULL, &processed), POINTCORE_STATUS_INPUT, "too many");
    attribute.components = attribute.count = 1;
    FAILS(pointcore_process(process, &cloud, NULL, NULL, &processed), POINTCORE_STATUS_INPUT, "setting `gain`");
    FAILS(pointcore_process(process, &cloud, NULL, &options, &processed), POINTCORE_STATUS_INPUT, "k is 65");
    options.k = 8;
    options.settings_count = 1;
    FAILS(pointcore_process(process, &cloud, NULL, &options, &processed), POINTCORE_STATUS_INPUT, "setting `speed`");
    cloud.count = 0;
    FAILS(pointcore_process(process, &cloud, NULL, NULL, &processed), POINTCORE_STATUS_INPUT, "empty");
    FAILS(pointcore_process(process, NULL, NULL, NULL, &processed), POINTCORE_STATUS_INPUT, "`points` is NULL");
    CHECK(processed == NULL && pointcore_processed_arrays(NULL).capped == NULL);
    pointcore_process_close(process);
}

int main(void) {
    static double expected[POINTS], totals[POINTS];
    const uint32_t others[] = {POINTCORE_BACK_END_GOLDEN, POINTCORE_BACK_END_VERILOG_IN_LOCKSTEP};
    make_points();
    normals();
    heat(POINTCORE_BACK_END_INTERPRETER, expected);
    for (int i = 0; i < 2; i++) {
        heat(others[i], totals);
        CHECK(memcmp(totals, expected, sizeof totals) == 0);
    }
    mistakes();
    PointcoreSearch *search;
    FAILS(pointcore_search_open(points, POINTS, 4, NULL, POINTCORE_BACK_END_INTERPRETER, &search),
          POINTCORE_STATUS_INPUT, "programs alone");
    printf("pointcore %s: all is as it should be\n", pointcore_version());
    return 0;
}
