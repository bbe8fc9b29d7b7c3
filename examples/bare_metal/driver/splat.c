#include "splat.h"

#include "numbers.h"

static const struct number_format geometry = {SPLAT_GEOMETRY_EXPONENT_BITS, SPLAT_GEOMETRY_MANTISSA_BITS};

static uint32_t filter_scale_of(float value)
{
#ifdef SPLAT_FILTER_SCALE_FRACTION_BITS
    return unsigned_of(SPLAT_FILTER_SCALE_BITS, SPLAT_FILTER_SCALE_FRACTION_BITS, value);
#else
    const struct number_format format = {SPLAT_FILTER_SCALE_EXPONENT_BITS, SPLAT_FILTER_SCALE_MANTISSA_BITS};
    return number_of(format, value);
#endif
}

#if SPLAT_CONTINUOUS > 0
#ifdef SPLAT_ATTRIBUTE_FRACTION_BITS
static uint32_t attribute_of(float value)
{
    return fraction_of(SPLAT_ATTRIBUTE_FRACTION_BITS, value);
}

static float attribute_value(uint32_t bits)
{
    return fraction_value(SPLAT_ATTRIBUTE_FRACTION_BITS, bits);
}
#else
static const struct number_format attribute = {SPLAT_ATTRIBUTE_EXPONENT_BITS, SPLAT_ATTRIBUTE_MANTISSA_BITS};

static uint32_t attribute_of(float value)
{
    return number_of(attribute, value);
}

static float attribute_value(uint32_t bits)
{
    return number_value(attribute, bits);
}
#endif
#endif

enum core_status splat_open(struct splat_core *splat, const struct platform *platform, uint32_t patience,
                            uint32_t buffer_base)
{
    const enum core_status status = core_open(&splat->core, platform, patience);
    return status == CORE_OK ? core_write(&splat->core, SPLAT_BUFFER_BASE, buffer_base) : status;
}

enum core_status splat_set_frame(const struct splat_core *splat, const struct splat_frame *frame)
{
    const float filter_scale = 1.0f / (frame->filter_radius * frame->filter_radius);
    const struct {
        uint32_t address;
        float value;
    } numbers[] = {
        {SPLAT_M00, frame->model_view[0][0]},      {SPLAT_M01, frame->model_view[0][1]},
        {SPLAT_M02, frame->model_view[0][2]},      {SPLAT_M03, frame->model_view[0][3]},
        {SPLAT_M10, frame->model_view[1][0]},      {SPLAT_M11, frame->model_view[1][1]},
        {SPLAT_M12, frame->model_view[1][2]},      {SPLAT_M13, frame->model_view[1][3]},
        {SPLAT_M20, frame->model_view[2][0]},      {SPLAT_M21, frame->model_view[2][1]},
        {SPLAT_M22, frame->model_view[2][2]},      {SPLAT_M23, frame->model_view[2][3]},
        {SPLAT_SCALE_X, frame->scale[0]},          {SPLAT_SCALE_Y, frame->scale[1]},
        {SPLAT_ORIGIN_X, frame->origin[0]},        {SPLAT_ORIGIN_Y, frame->origin[1]},
        {SPLAT_DEPTH_A, frame->depth_a},           {SPLAT_DEPTH_B, frame->depth_b},
        {SPLAT_NEAR_PLANE, frame->near_plane},     {SPLAT_EPSILON_SCALE, frame->epsilon_scale},
        {SPLAT_EPSILON_BIAS, frame->epsilon_bias}, {SPLAT_FILTER_RADIUS, frame->filter_radius},
    };
    enum core_status status = core_write(&splat->core, SPLAT_FILTER_SCALE, filter_scale_of(filter_scale));
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0] && status == CORE_OK; i++)
        status = core_write(&splat->core, numbers[i].address, number_of(geometry, numbers[i].value));
    return status;
}

/* A splat, or where there is none the end of the frame. */
static void make_splat(uint8_t *packet, const struct splat_disc *disc)
{
    core_clear(packet, SPLAT_SPLAT_BYTES);
    core_put(packet, FIELD(splat_splat, end), !disc);
    if (!disc)
        return;
    core_put(packet, FIELD(splat_splat, center_x), number_of(geometry, disc->center[0]));
    core_put(packet, FIELD(splat_splat, center_y), number_of(geometry, disc->center[1]));
    core_put(packet, FIELD(splat_splat, center_z), number_of(geometry, disc->center[2]));
    core_put(packet, FIELD(splat_splat, tangent1_x), number_of(geometry, disc->tangents[0][0]));
    core_put(packet, FIELD(splat_splat, tangent1_y), number_of(geometry, disc->tangents[0][1]));
    core_put(packet, FIELD(splat_splat, tangent1_z), number_of(geometry, disc->tangents[0][2]));
    core_put(packet, FIELD(splat_splat, tangent2_x), number_of(geometry, disc->tangents[1][0]));
    core_put(packet, FIELD(splat_splat, tangent2_y), number_of(geometry, disc->tangents[1][1]));
    core_put(packet, FIELD(splat_splat, tangent2_z), number_of(geometry, disc->tangents[1][2]));
    /* Fields of the same size lie one behind the other. */
#if SPLAT_CONTINUOUS > 0
    for (size_t i = 0, bytes = sizeof(((struct splat_splat *)0)->attribute_0); i < SPLAT_CONTINUOUS; i++)
        core_put(packet, offsetof(struct splat_splat, attribute_0) + i * bytes, bytes,
                 attribute_of(disc->continuous[i]));
#endif
#if SPLAT_CARDINAL > 0
    for (size_t i = 0, bytes = sizeof(((struct splat_splat *)0)->cardinal_0); i < SPLAT_CARDINAL; i++)
        core_put(packet, offsetof(struct splat_splat, cardinal_0) + i * bytes, bytes, disc->cardinal[i]);
#endif
}

static void read_fragment(const uint8_t *packet, struct splat_sample *sample)
{
    sample->column = (uint32_t)core_get(packet, FIELD(splat_fragment, column));
    sample->row = (uint32_t)core_get(packet, FIELD(splat_fragment, row));
    sample->depth = number_value(geometry, (uint32_t)core_get(packet, FIELD(splat_fragment, depth)));
#if SPLAT_CONTINUOUS > 0
    for (size_t i = 0, bytes = sizeof(((struct splat_fragment *)0)->attribute_0); i < SPLAT_CONTINUOUS; i++)
        sample->continuous[i] = attribute_value(
            (uint32_t)core_get(packet, offsetof(struct splat_fragment, attribute_0) + i * bytes, bytes));
#endif
#if SPLAT_CARDINAL > 0
    for (size_t i = 0, bytes = sizeof(((struct splat_fragment *)0)->cardinal_0); i < SPLAT_CARDINAL; i++)
        sample->cardinal[i] =
            (uint32_t)core_get(packet, offsetof(struct splat_fragment, cardinal_0) + i * bytes, bytes);
#endif
}

/* Asks for a picture, whose uniforms the core takes when the one before is set up. */
static enum core_status ask_for(const struct splat_core *splat, const struct splat_picture *picture)
{
    const enum core_status status = picture->view ? splat_set_frame(splat, picture->view) : CORE_OK;
    return status == CORE_OK ? core_start(&splat->core) : status;
}

enum core_status splat_draw_all(const struct splat_core *splat, struct splat_picture *pictures, uint32_t count)
{
    const struct core *core = &splat->core;
    uint8_t packet[SPLAT_SPLAT_BYTES > SPLAT_FRAGMENT_BYTES ? SPLAT_SPLAT_BYTES : SPLAT_FRAGMENT_BYTES];
    /* Pictures asked for, those whose splats are sent, those that have come. */
    uint32_t asked = 0, sent = 0, come = 0;
    uint32_t splats = 0, idle = 0;
    enum core_status status = CORE_OK;

    for (uint32_t i = 0; i < count; i++)
        pictures[i].samples = 0;
    /* Fragments are taken while splats are sent: the core does not hold all of either. */
    while (come < count && idle <= core->patience && status == CORE_OK) {
        idle++;
        if (asked < count && asked == sent && !(core_read(core, SPLAT_STATUS) & SPLAT_STATUS_WAITING)) {
            status = ask_for(splat, &pictures[asked++]);
            if (status != CORE_OK && asked == 1)
                return status;
        }
        if (sent < asked) {
            const struct splat_picture *picture = &pictures[sent];
            make_splat(packet, splats < picture->count ? &picture->discs[splats] : NULL);
            if (core_send(core, packet, SPLAT_SPLAT_BYTES)) {
                idle = 0;
                if (splats++ == picture->count) {
                    splats = 0;
                    sent++;
                }
            }
        }
        if (core_receive(core, packet, SPLAT_FRAGMENT_BYTES)) {
            struct splat_picture *picture = &pictures[come];
            idle = 0;
            if (core_get(packet, FIELD(splat_fragment, end)))
                come++;
            else if (picture->samples++ < picture->room)
                read_fragment(packet, &picture->frame[picture->samples - 1]);
        }
    }
    if (come < count) {
        const enum core_status aborted = core_abort(core, packet, SPLAT_FRAGMENT_BYTES);
        return status == CORE_OK ? aborted : status;
    }
    return core_finish(core);
}

enum core_status splat_draw(const struct splat_core *splat, const struct splat_disc *discs, uint32_t count,
                            struct splat_sample *frame, uint32_t room, uint32_t *samples)
{
    struct splat_picture picture = {NULL, discs, count, frame, room, 0};
    const enum core_status status = splat_draw_all(splat, &picture, 1);
    *samples = picture.samples;
    return status;
}
