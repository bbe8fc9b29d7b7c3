/*
 * pointcore from C: the neighbors of 1,000 points, checked against a search through all of them, the hardware for that
 * as Verilog, a picture of a sphere, and one of a splat behind a triangle. Exits with 0 if all is as it should be.
 *
 *   cc -I bindings/c/include bindings/c/examples/search_and_render.c -L target/debug -lpointcore -lm
 */
#include <math.h>
#include <pointcore.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { POINTS = 1000, QUERIES = 200, K = 5 };

#define CHECK(condition) \
    do { \
        if (!(condition)) { \
            fprintf(stderr, "line %d: not so: %s (%s)\n", __LINE__, #condition, pointcore_error_message()); \
            exit(1); \
        } \
    } while (0)

/* A number in 0..1 of a linear congruential generator: the same on every machine. */
static double random_number(void) {
    static uint64_t state = 1;
    state = state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (double)(state >> 40) / (1 << 24);
}

static double distance2(const double *a, const double *b) {
    double sum = 0.0;
    for (int axis = 0; axis < 3; axis++) sum += (a[axis] - b[axis]) * (a[axis] - b[axis]);
    return sum;
}

/* Whether these are the nearest of all points: each at its distance, and none left out is nearer than the last. */
static void check_neighbors(const double *points, const double *query, const int64_t *indices, const float *found,
                            uint32_t count, double limit2) {
    uint32_t nearer = 0;
    CHECK(count <= K);
    for (uint32_t rank = 0; rank < count; rank++) {
        CHECK(indices[rank] >= 0 && indices[rank] < POINTS);
        double exact = distance2(points + 3 * indices[rank], query);
        CHECK(fabs(found[rank] - exact) <= 1e-5 * exact && exact < limit2 * 1.00001);
        CHECK(rank == 0 || found[rank - 1] <= found[rank]);
    }
    double last = count == K ? found[K - 1] : limit2;
    for (int point = 0; point < POINTS; point++) nearer += distance2(points + 3 * point, query) < last * 0.99999;
    CHECK(nearer <= count);
    for (uint32_t rank = count; rank < K; rank++) CHECK(indices[rank] == -1 && isinf(found[rank]));
}

static void search(uint32_t back_end) {
    static double points[3 * POINTS], queries[3 * QUERIES];
    static int64_t indices[K * QUERIES];
    static float distances2[K * QUERIES];
    static uint32_t counts[QUERIES];
    for (int i = 0; i < 3 * POINTS; i++) points[i] = random_number();
    for (int i = 0; i < 3 * QUERIES; i++) queries[i] = random_number();

    PointcoreSearch *search;
    uint64_t cycles = 0, found = 0;
    CHECK(pointcore_search_open(points, POINTS, K, NULL, back_end, &search) == POINTCORE_STATUS_OK);
    const double radii[] = {INFINITY, 0.1};
    for (int i = 0; i < 2; i++) {
        CHECK(pointcore_search(search, queries, QUERIES, K, radii[i], indices, distances2, counts, &cycles) ==
              POINTCORE_STATUS_OK);
        CHECK(cycles > QUERIES);
        for (int query = 0; query < QUERIES; query++) {
            check_neighbors(points, queries + 3 * query, indices + K * query, distances2 + K * query, counts[query],
                            radii[i] * radii[i]);
            found += counts[query];
        }
        CHECK(i == 1 || found == K * QUERIES);
    }
    printf("%llu neighbors of %d queries among %d points, the last in %llu cycles\n", (unsigned long long)found,
           2 * QUERIES, POINTS, (unsigned long long)cycles);

    CHECK(pointcore_search(search, queries, 1, 0, INFINITY, NULL, NULL, NULL, NULL) == POINTCORE_STATUS_INPUT);
    CHECK(strstr(pointcore_error_message(), "k is 0") != NULL);
    CHECK(pointcore_search(search, NULL, 1, K, INFINITY, NULL, NULL, NULL, NULL) == POINTCORE_STATUS_INPUT);
    CHECK(strstr(pointcore_error_message(), "`queries` is NULL") != NULL);
    pointcore_search_close(search);
    CHECK(pointcore_search_open(points, POINTS, K, NULL, 99, &search) == POINTCORE_STATUS_INPUT);
}

static void plan_and_generate(const char *folder) {
    PointcorePlan *plan;
    CHECK(pointcore_plan_search(POINTS, K, &plan) == POINTCORE_STATUS_OK);
    CHECK(strstr(pointcore_plan_text(plan), "tree_depth") != NULL);
    CHECK(pointcore_generate(pointcore_plan_toml(plan), folder, "example") == POINTCORE_STATUS_OK);
    char path[4096];
    snprintf(path, sizeof path, "%s/search_top.v", folder);
    FILE *verilog = fopen(path, "r");
    CHECK(verilog != NULL);
    fclose(verilog);
    /* A file is no folder. */
    CHECK(pointcore_generate(pointcore_plan_toml(plan), path, "example") == POINTCORE_STATUS_FILE);
    pointcore_plan_close(plan);
}

static void render(uint32_t back_end) {
    enum { SPLATS = 500, EDGE = 48, MIDDLE = (EDGE / 2) * EDGE + EDGE / 2 };
    static double centers[3 * SPLATS], colors[3 * SPLATS];
    for (int i = 0; i < SPLATS; i++) {
        double z = 1.0 - (2.0 * i + 1.0) / SPLATS, around = 2.399963229728653 * i, across = sqrt(1.0 - z * z);
        const double center[] = {across * cos(around), across * sin(around), z}, red[] = {1.0, 0.0, 0.0};
        memcpy(centers + 3 * i, center, sizeof center);
        memcpy(colors + 3 * i, red, sizeof red);
    }
    /* On a unit sphere a center is its normal. */
    const double radius = 0.15;
    const PointcoreSplats splats = {
        .count = SPLATS, .points = centers, .normals = centers, .radii = &radius, .radii_count = 1, .colors = colors};
    const PointcoreCamera camera = {.eye = {0.0, 0.0, 5.0}, .up = {0.0, 1.0, 0.0}, .fov_degrees = 30.0};
    const PointcoreImage image = {.width = EDGE, .height = EDGE, .background = {0.0, 0.0, 1.0}};
    PointcoreScene *scene;
    PointcorePlan *plan;
    PointcoreRender *render;
    PointcoreFrame *frame;
    CHECK(pointcore_scene_open(&splats, NULL, &camera, &image, &scene) == POINTCORE_STATUS_OK);
    CHECK(pointcore_plan_scene(scene, &plan) == POINTCORE_STATUS_OK);
    CHECK(strstr(pointcore_plan_toml(plan), "kind = \"splat\"") != NULL);
    CHECK(pointcore_render_open(scene, pointcore_plan_toml(plan), back_end, &render) == POINTCORE_STATUS_OK);
    CHECK(pointcore_render_frames(render) == 1);
    CHECK(pointcore_render_frame(render, 1, &frame) == POINTCORE_STATUS_INPUT);
    CHECK(pointcore_render_frame(render, 0, &frame) == POINTCORE_STATUS_OK);
    pointcore_render_close(render);
    pointcore_plan_close(plan);
    pointcore_scene_close(scene);

    const PointcoreFrameArrays arrays = pointcore_frame_arrays(frame);
    CHECK(arrays.width == EDGE && arrays.height == EDGE && arrays.cycles > 0);
    int covered = 0;
    for (int i = 0; i < EDGE * EDGE; i++) {
        covered += arrays.mask[i];
        CHECK(arrays.mask[i] ? isfinite(arrays.depth[i]) : isinf(arrays.depth[i]));
    }
    CHECK(covered > EDGE * EDGE / 4 && covered < EDGE * EDGE);
    /* In the middle of the picture is the sphere's nearest point. */
    CHECK(arrays.mask[MIDDLE] && fabs(arrays.depth[MIDDLE] - 4.0) < 0.05 && arrays.normal[3 * MIDDLE + 2] > 0.9f);
    CHECK(arrays.color[3 * MIDDLE] > 0.98f && arrays.color[3 * MIDDLE + 1] < 0.02f);
    CHECK(arrays.picture_width == EDGE && !arrays.mask[0] && arrays.picture[2] == 255);
    CHECK(strstr(arrays.report, "\"psnr_db\"") != NULL);
    printf("%d of %d pixels covered in %llu cycles\n", covered, EDGE * EDGE, (unsigned long long)arrays.cycles);
    pointcore_frame_close(frame);
    CHECK(pointcore_frame_arrays(NULL).mask == NULL);
}

/* A triangle before the right half of a splat, in green. */
static void hide(uint32_t back_end) {
    enum { EDGE = 16, LEFT = (EDGE / 2) * EDGE + EDGE / 4, RIGHT = LEFT + EDGE / 2 };
    const double center[] = {0.0, 0.0, 0.0}, radius = 2.0, vertices[] = {0, -9, 1, 9, 0, 1, 0, 9, 1};
    const double green[] = {0, 1, 0, 0, 1, 0, 0, 1, 0};
    const uint32_t face[] = {0, 1, 2}, wrong[] = {0, 1, 3};
    const PointcoreSplats splats = {.count = 1, .points = center, .radii = &radius, .radii_count = 1};
    const PointcoreCamera camera = {.eye = {0.0, 0.0, 5.0}, .up = {0.0, 1.0, 0.0}, .fov_degrees = 30.0};
    const PointcoreImage image = {.width = EDGE, .height = EDGE};
    PointcoreMesh mesh = {.vertex_count = 3, .vertices = vertices, .colors = green, .face_count = 1, .faces = wrong};
    PointcoreScene *scene;
    PointcoreRender *render;
    PointcoreFrame *frame;
    CHECK(pointcore_scene_open(&splats, &mesh, &camera, &image, &scene) == POINTCORE_STATUS_INPUT);
    CHECK(strstr(pointcore_error_message(), "face 0 is [0, 1, 3]") != NULL);
    mesh.faces = face;
    CHECK(pointcore_scene_open(&splats, &mesh, &camera, &image, &scene) == POINTCORE_STATUS_OK);
    CHECK(pointcore_render_open(scene, NULL, back_end, &render) == POINTCORE_STATUS_OK);
    CHECK(pointcore_render_frame(render, 0, &frame) == POINTCORE_STATUS_OK);
    pointcore_render_close(render);
    pointcore_scene_close(scene);
    const PointcoreFrameArrays arrays = pointcore_frame_arrays(frame);
    CHECK(arrays.mask[LEFT] && !arrays.mask[RIGHT]);
    CHECK(arrays.picture[3 * LEFT] > 200 && arrays.picture[3 * RIGHT] < 100 && arrays.picture[3 * RIGHT + 1] > 200);
    pointcore_frame_close(frame);
}

int main(int count, char **arguments) {
    CHECK(count == 2); /* a folder for the Verilog */
    CHECK(pointcore_error_message()[0] == '\0');
    search(POINTCORE_BACK_END_GOLDEN);
    search(POINTCORE_BACK_END_VERILOG_IN_LOCKSTEP);
    plan_and_generate(arguments[1]);
    render(POINTCORE_BACK_END_GOLDEN);
    render(POINTCORE_BACK_END_VERILOG);
    hide(POINTCORE_BACK_END_GOLDEN);
    printf("pointcore %s: all is as it should be\n", pointcore_version());
    return 0;
}
