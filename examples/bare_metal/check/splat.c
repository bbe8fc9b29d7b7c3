/* Frames through the driver, compared with the splats' geometry in real numbers, which shares nothing with it. */
#include "splat.h"

#include "check.h"

#include <string.h>

#define BUFFER_BASE 0x100000u
#define DISCS 40
/* The header's counts have no sign. */
enum { CONTINUOUS = SPLAT_CONTINUOUS, CARDINAL = SPLAT_CARDINAL };
#define SAMPLES (SPLAT_WIDTH * SPLAT_HEIGHT)
/* How far from a rim rounding may decide otherwise, and how far numbers may be off. */
#define RIM 0.03
#define DEPTH_TOLERANCE 2e-3
#define ATTRIBUTE_TOLERANCE 0.01
#define WEIGHT_TOLERANCE 0.03

static struct splat_disc discs[DISCS];
static struct splat_sample frame[SAMPLES], before[SAMPLES];

/* Seen from (0, 0, -5) along +z; the picture is as wide as the view at a distance of 2. */
static const struct splat_frame view = {
    .model_view = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 5}},
    .scale = {SPLAT_WIDTH, SPLAT_HEIGHT},
    .origin = {SPLAT_WIDTH / 2.0f, SPLAT_HEIGHT / 2.0f},
    .depth_a = 1.1111111f, /* (far) / (far - near) of 1 and 10 */
    .depth_b = -1.1111111f,
    .near_plane = 1,
    .epsilon_scale = 0,
    .epsilon_bias = 0.02f,
    .filter_radius = 1,
};

/* What a splat is at a sample. */
struct hit {
    double rho2;
    bool is_near_rim;
};

static double camera(const struct splat_frame *seen, const float point[3], int axis, double one)
{
    return seen->model_view[axis][0] * (double)point[0] + seen->model_view[axis][1] * (double)point[1] +
           seen->model_view[axis][2] * (double)point[2] + seen->model_view[axis][3] * one;
}

static double determinant(const double a[3], const double b[3], const double c[3])
{
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/* The ray through the sample's middle meets center + u tangent1 + v tangent2, by Cramer's rule. */
static struct hit hit_of(const struct splat_frame *seen, const struct splat_disc *disc, uint32_t column, uint32_t row)
{
    const double place[2] = {column + 0.5, row + 0.5};
    double center[3], first[3], second[3], ray[3], normal, rho2, filter2 = 0;
    struct hit hit;
    for (int axis = 0; axis < 3; axis++) {
        center[axis] = camera(seen, disc->center, axis, 1);
        first[axis] = camera(seen, disc->tangents[0], axis, 0);
        second[axis] = camera(seen, disc->tangents[1], axis, 0);
        ray[axis] = axis < 2 ? (place[axis] - seen->origin[axis]) / seen->scale[axis] : 1;
    }
    for (int axis = 0; axis < 2; axis++) {
        const double reach = hypot(first[0], first[1]) + hypot(second[0], second[1]);
        const double pixels = fabs(place[axis] - (seen->scale[axis] * center[axis] / center[2] + seen->origin[axis]));
        /* The splats here are all parallel to the picture: farther off, nothing is left to compute. */
        if (pixels > reach * seen->scale[axis] / center[2] + seen->filter_radius + 2)
            return (struct hit){4, false};
    }
    normal = determinant(first, second, ray);
    rho2 = pow(determinant(center, second, ray) / normal, 2) + pow(determinant(first, center, ray) / normal, 2);
    for (int axis = 0; axis < 2; axis++)
        filter2 += pow(place[axis] - (seen->scale[axis] * center[axis] / center[2] + seen->origin[axis]), 2);
    filter2 /= (double)seen->filter_radius * seen->filter_radius;
    hit.rho2 = SPLAT_SCREEN_FILTER && filter2 < rho2 ? filter2 : rho2;
    hit.is_near_rim = fabs(sqrt(hit.rho2) - 1) < RIM + 0.1 * (filter2 < 4);
    return hit;
}

static double depth_of(const struct splat_frame *seen, const struct splat_disc *disc)
{
    return seen->depth_a + seen->depth_b / camera(seen, disc->center, 2, 1);
}

/* A sample as it must be: covered or not, or too near a rim to tell. */
struct expected {
    bool is_covered, is_doubtful;
    double depth;
    double continuous[SPLAT_AT_LEAST_ONE(SPLAT_CONTINUOUS)];
    /* The splats whose cardinal attributes it may have: of the largest weight, or nearly so. */
    bool may_choose[DISCS];
};

/* The nearest surface, and what lies within epsilon of it, blended. Surfaces are farther apart than that, or one. */
static struct expected expected_at(const struct splat_frame *seen, uint32_t drawn, uint32_t column, uint32_t row)
{
    struct expected sample = {0};
    double nearest = 2, weights = 0, heaviest = 0, weight_of[DISCS] = {0};
    for (uint32_t i = 0; i < drawn; i++) {
        const struct hit hit = hit_of(seen, &discs[i], column, row);
        sample.is_doubtful |= hit.is_near_rim;
        if (hit.rho2 < 1 && depth_of(seen, &discs[i]) < nearest)
            nearest = depth_of(seen, &discs[i]);
    }
    for (uint32_t i = 0; i < drawn; i++) {
        const double rho2 = hit_of(seen, &discs[i], column, row).rho2, depth = depth_of(seen, &discs[i]);
        const double weight = exp(-SPLAT_KERNEL_GAMMA * rho2);
        if (rho2 >= 1 || depth - nearest > seen->epsilon_bias)
            continue;
        weight_of[i] = weight;
        heaviest = weight > heaviest ? weight : heaviest;
        weights += weight;
        sample.depth += weight * depth;
        for (int place = 0; place < CONTINUOUS; place++)
            sample.continuous[place] += weight * (double)discs[i].continuous[place];
    }
    for (uint32_t i = 0; i < drawn; i++)
        sample.may_choose[i] = weight_of[i] > 0 && weight_of[i] > heaviest - WEIGHT_TOLERANCE;
    sample.is_covered = weights > 0;
    for (int place = 0; place < CONTINUOUS && weights > 0; place++)
        sample.continuous[place] /= weights;
    sample.depth = weights > 0 ? sample.depth / weights : 0;
    return sample;
}

/* A fragment's place in the order that docs/interfaces.md has: tile by tile, row by row. */
static uint32_t rank(const struct splat_sample *sample)
{
    const uint32_t tiles = (SPLAT_WIDTH + SPLAT_TILE_SIZE - 1) / SPLAT_TILE_SIZE;
    const uint32_t tile = sample->row / SPLAT_TILE_SIZE * tiles + sample->column / SPLAT_TILE_SIZE;
    const uint32_t row = sample->row % SPLAT_TILE_SIZE, column = sample->column % SPLAT_TILE_SIZE;
    return (tile * SPLAT_TILE_SIZE + row) * SPLAT_TILE_SIZE + column;
}

static bool is_right(const struct splat_sample *sample, const struct expected *expected)
{
    if (fabs(sample->depth - expected->depth) > DEPTH_TOLERANCE)
        return false;
    for (int place = 0; place < CONTINUOUS; place++)
        if (fabs(sample->continuous[place] - expected->continuous[place]) > ATTRIBUTE_TOLERANCE)
            return false;
    for (int place = 0; place < CARDINAL; place++)
        if (sample->cardinal[place] >= DISCS || !expected->may_choose[sample->cardinal[place]])
            return false;
    return true;
}

/* How much of a frame is wrong: samples that are there and must not be, or the other way round, or are others. */
static uint32_t wrong_samples(const struct splat_frame *seen, uint32_t drawn, uint32_t samples, uint32_t *sure)
{
    static int32_t found[SAMPLES];
    uint32_t wrong = 0;
    *sure = 0;
    for (uint32_t i = 0; i < SAMPLES; i++)
        found[i] = -1;
    for (uint32_t i = 0; i < samples; i++) {
        const bool is_inside = frame[i].column < SPLAT_WIDTH && frame[i].row < SPLAT_HEIGHT;
        int32_t *place = &found[is_inside ? frame[i].row * SPLAT_WIDTH + frame[i].column : 0];
        const bool is_behind = i && rank(&frame[i]) / 64 == rank(&frame[i - 1]) / 64 && rank(&frame[i]) < rank(&frame[i - 1]);
        if (!is_inside || is_behind || *place >= 0)
            wrong++;
        else
            *place = (int32_t)i;
    }
    for (uint32_t row = 0; row < SPLAT_HEIGHT; row++)
        for (uint32_t column = 0; column < SPLAT_WIDTH; column++) {
            const struct expected expected = expected_at(seen, drawn, column, row);
            const int32_t place = found[row * SPLAT_WIDTH + column];
            if (expected.is_doubtful)
                continue;
            *sure += expected.is_covered;
            wrong += expected.is_covered != (place >= 0) ||
                     (expected.is_covered && !is_right(&frame[place], &expected));
        }
    return wrong;
}

/* Discs and ellipses in three planes before the eye, turned any way in them. */
static void scatter(void)
{
    static const float planes[3] = {-1, 0, 1};
    /* As many samples in any picture. */
    const float zoom = 128.0f / SPLAT_WIDTH;
    for (uint32_t i = 0; i < DISCS; i++) {
        struct splat_disc *disc = &discs[i];
        const float length = zoom * random_float(0.1f, 0.5f), width = zoom * random_float(0.1f, 0.5f);
        const float turn = random_float(0, 6.28f);
        const float made[2][3] = {
            {length * cosf(turn), length * sinf(turn), 0},
            {width * sinf(turn), -width * cosf(turn), 0},
        };
        const float center[3] = {zoom * random_float(-2, 2), zoom * random_float(-2, 2), planes[random_word() % 3]};
        for (int axis = 0; axis < 3; axis++) {
            disc->center[axis] = center[axis];
            disc->tangents[0][axis] = made[0][axis];
            disc->tangents[1][axis] = made[1][axis];
        }
        for (int place = 0; place < CONTINUOUS; place++)
            disc->continuous[place] = random_float(-0.9f, 0.9f);
        for (int place = 0; place < CARDINAL; place++)
            disc->cardinal[place] = i;
    }
    /* Smaller than a sample: what the screen filter makes of it, at a sample's middle. */
    discs[0].center[0] = discs[0].center[1] = (0.5f / SPLAT_WIDTH) * 4;
    discs[0].center[2] = -1;
    for (int axis = 0; axis < 2; axis++)
        discs[0].tangents[0][axis] = discs[0].tangents[1][1 - axis] = 0;
    discs[0].tangents[0][0] = 1e-3f;
    discs[0].tangents[1][1] = -1e-3f;
}

static void check_frame(const struct splat_core *splat, uint32_t *samples)
{
    uint32_t sure, wrong;
    CHECK_STATUS(splat_draw(splat, discs, DISCS, frame, SAMPLES, samples), CORE_OK);
    wrong = wrong_samples(&view, DISCS, *samples, &sure);
    CHECK(wrong == 0, "%u of %u samples, %u of them sure", wrong, *samples, sure);
    CHECK(sure > 2000 && sure <= *samples && *samples < SAMPLES, "%u sure, %u samples", sure, *samples);
    CHECK(core_read(&splat->core, SPLAT_PACKETS_IN) == DISCS + 1, "splats taken");
    CHECK(core_read(&splat->core, SPLAT_PACKETS_OUT) == *samples + 1, "fragments sent");
}

/* Pictures that follow each other: moved aside, without some of the splats, through another screen filter, and as the first again. */
static void check_sequence(const struct splat_core *splat)
{
    static struct splat_sample frames[4][SAMPLES];
    struct splat_frame views[3] = {view, view, view};
    struct splat_picture pictures[4];
    views[1].origin[0] += 3;
    views[2].filter_radius = 1.5f;
    for (uint32_t i = 0; i < 4; i++)
        pictures[i] = (struct splat_picture){&views[i % 3], discs, i == 1 ? DISCS - 1 : DISCS, frames[i], SAMPLES, 0};
    CHECK_STATUS(splat_draw_all(splat, pictures, 4), CORE_OK);
    for (uint32_t i = 0; i < 4; i++) {
        uint32_t sure, wrong;
        memcpy(frame, frames[i], sizeof frame);
        wrong = wrong_samples(pictures[i].view, pictures[i].count, pictures[i].samples, &sure);
        CHECK(wrong == 0 && sure > 2000, "picture %u: %u of %u samples, %u sure", i, wrong, pictures[i].samples, sure);
    }
}

/* What is not to be drawn: behind the near plane, beyond depth 1, turned away. */
static void check_unseen(const struct splat_core *splat)
{
    struct splat_disc unseen[3] = {discs[1], discs[1], discs[1]};
    uint32_t samples;
    unseen[0].center[2] = -4.5f;
    unseen[1].center[2] = 6;
    for (int axis = 0; axis < 3; axis++) {
        unseen[2].tangents[0][axis] = discs[1].tangents[1][axis];
        unseen[2].tangents[1][axis] = discs[1].tangents[0][axis];
    }
    CHECK_STATUS(splat_draw(splat, unseen, 2, frame, SAMPLES, &samples), CORE_OK);
    CHECK(samples == 0, "%u samples of what is too near or too far", samples);
    CHECK_STATUS(splat_draw(splat, &unseen[2], 1, frame, SAMPLES, &samples), CORE_OK);
    CHECK((samples == 0) == SPLAT_CULLING, "%u samples of what is turned away", samples);
    CHECK_STATUS(splat_draw(splat, NULL, 0, frame, SAMPLES, &samples), CORE_OK);
    CHECK(samples == 0, "%u samples of nothing", samples);
}

static void check_refusals(const struct splat_core *splat)
{
    const struct core *core = &splat->core;
    uint8_t packet[SPLAT_FRAGMENT_BYTES];
    uint32_t value;
    CHECK_STATUS(core_write(core, SPLAT_CYCLES, 1), CORE_REFUSED);
    CHECK_STATUS(core_write(core, SPLAT_BUFFER_BASE, BUFFER_BASE + 4), CORE_REFUSED);
    CHECK(!core->platform->read32(core->platform->context, SPLAT_M00, &value) && value == 0, "a uniform is read");
    CHECK_STATUS(core_start(core), CORE_OK);
    CHECK_STATUS(core_write(core, SPLAT_BUFFER_BASE, BUFFER_BASE), CORE_REFUSED);
    CHECK_STATUS(core_write(core, SPLAT_CONTROL, SPLAT_CONTROL_RESET), CORE_REFUSED);
    while (core_read(core, SPLAT_STATUS) & SPLAT_STATUS_WAITING)
        ;
    CHECK_STATUS(core_start(core), CORE_OK);
    CHECK_STATUS(core_start(core), CORE_REFUSED);
    CHECK_STATUS(core_write(core, SPLAT_M00, 0), CORE_REFUSED);
    check_errors(core, (struct core_errors){3, 4, 0, 0, 0});
    CHECK_STATUS(core_abort(core, packet, sizeof packet), CORE_ABORTED);
    CHECK_STATUS(core_clear_errors(core), CORE_OK);
    check_errors(core, (struct core_errors){0, 0, 0, 0, 0});
}

/* The order of the image: tiles come in any. */
static int by_place(const void *one, const void *other)
{
    const struct splat_sample *const a = one, *const b = other;
    const int64_t distance =
        ((int64_t)a->row - b->row) * SPLAT_WIDTH + (int64_t)a->column - b->column;
    return (distance > 0) - (distance < 0);
}

/* The same frame again, sample by sample as it was: after others, after one whose end was lost. */
static void check_abort(const struct splat_core *splat)
{
    struct splat_core lossy = *splat;
    const struct platform link = losing(splat->core.platform, DISCS);
    uint32_t samples, first;
    check_frame(splat, &first);
    qsort(frame, first, sizeof *frame, by_place);
    for (uint32_t i = 0; i < first; i++)
        before[i] = frame[i];
    lossy.core.platform = &link;
    lossy.core.patience = IMPATIENCE;
    CHECK_STATUS(splat_draw(&lossy, discs, DISCS, frame, SAMPLES, &samples), CORE_ABORTED);
    CHECK(samples == 0, "%u fragments before the end was sent", samples);
    check_frame(splat, &samples);
    CHECK(samples == first, "%u and %u samples", first, samples);
    qsort(frame, samples, sizeof *frame, by_place);
    for (uint32_t i = 0; i < samples && i < first; i++) {
        bool is_same = frame[i].column == before[i].column && frame[i].row == before[i].row &&
                       frame[i].depth == before[i].depth;
        for (int place = 0; place < CONTINUOUS; place++)
            is_same = is_same && frame[i].continuous[place] == before[i].continuous[place];
        CHECK(is_same, "sample %u", i);
    }
}

/* The comparison finds what is wrong: one uniform that is off, or in another's place, one splat that is missing. */
static void check_faults(const struct splat_core *splat)
{
    struct splat_frame wrong = view;
    uint32_t samples, sure;
    wrong.origin[0] += 1;
    CHECK_STATUS(splat_set_frame(splat, &wrong), CORE_OK);
    CHECK_STATUS(splat_draw(splat, discs, DISCS, frame, SAMPLES, &samples), CORE_OK);
    CHECK(wrong_samples(&view, DISCS, samples, &sure) > 0, "a wrong origin is not seen");
    wrong = view;
    wrong.depth_a = 1.2f;
    CHECK_STATUS(splat_set_frame(splat, &wrong), CORE_OK);
    CHECK_STATUS(splat_draw(splat, discs, DISCS, frame, SAMPLES, &samples), CORE_OK);
    CHECK(wrong_samples(&view, DISCS, samples, &sure) > 0, "a wrong depth is not seen");
    CHECK_STATUS(splat_set_frame(splat, &view), CORE_OK);
    CHECK_STATUS(splat_draw(splat, discs, DISCS - 1, frame, SAMPLES, &samples), CORE_OK);
    CHECK(wrong_samples(&view, DISCS, samples, &sure) > 0, "a missing splat is not seen");
}

int main(int arguments, char **argument)
{
    const uint32_t seed = arguments > 1 ? (uint32_t)strtoul(argument[1], NULL, 0) : 1;
    struct platform platform = board_open(seed);
    struct splat_core splat;
    uint32_t samples;
    uint64_t cycles;

    random_state = seed;
    scatter();
    CHECK(BUFFER_BASE + SPLAT_BUFFER_BYTES <= BOARD_MEMORY_BYTES, "memory ends within the buffer");
    CHECK_STATUS(splat_open(&splat, &platform, PATIENCE, BUFFER_BASE), CORE_OK);
    CHECK_STATUS(splat_set_frame(&splat, &view), CORE_OK);
    check_frame(&splat, &samples);
    check_sequence(&splat);
    check_unseen(&splat);
    check_refusals(&splat);
    check_abort(&splat);
    check_faults(&splat);
    cycles = board_cycles(&platform);
    board_close(&platform);
    return finished("splat", cycles);
}
