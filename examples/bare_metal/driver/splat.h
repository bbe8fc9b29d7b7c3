/* Driver of `splat_axi`. */
#ifndef POINTCORE_SPLAT_DRIVER_H
#define POINTCORE_SPLAT_DRIVER_H

#include "core.h"

/* An array has an element, even if nothing is in it. */
#define SPLAT_AT_LEAST_ONE(count) ((count) > 0 ? (count) : 1)

/* A renderer. */
struct splat_core {
    struct core core;
};

/* The constants of a frame, docs/interfaces.md says which is which. */
struct splat_frame {
    float model_view[3][4];
    float scale[2], origin[2];
    float depth_a, depth_b, near_plane;
    float epsilon_scale, epsilon_bias;
    float filter_radius;
};

/* What is drawn. Continuous attributes first, as numbers; of cardinal ones the low bits of integers. */
struct splat_disc {
    float center[3];
    float tangents[2][3];
    float continuous[SPLAT_AT_LEAST_ONE(SPLAT_CONTINUOUS)];
    uint32_t cardinal[SPLAT_AT_LEAST_ONE(SPLAT_CARDINAL)];
};

/* A sample of the picture. */
struct splat_sample {
    uint32_t column, row;
    float depth;
    float continuous[SPLAT_AT_LEAST_ONE(SPLAT_CONTINUOUS)];
    uint32_t cardinal[SPLAT_AT_LEAST_ONE(SPLAT_CARDINAL)];
};

/* Where the reconstruction buffer lies: SPLAT_BUFFER_BYTES from a multiple of 4,096 on. */
enum core_status splat_open(struct splat_core *splat, const struct platform *platform, uint32_t patience,
                            uint32_t buffer_base);

/* A picture to be drawn. */
struct splat_picture {
    /* How it is seen; as the picture before if there is none. */
    const struct splat_frame *view;
    /* What is seen. */
    const struct splat_disc *discs;
    uint32_t count;
    /* Where the first `room` of its samples go. */
    struct splat_sample *frame;
    uint32_t room;
    /* How many it has. */
    uint32_t samples;
};

/* Writes all uniforms. Between frames they may change in any way. */
enum core_status splat_set_frame(const struct splat_core *splat, const struct splat_frame *frame);

/*
 * Draws pictures one after the other, each while the one before leaves. After CORE_ABORTED the core is ready for others;
 * what has come of these is no whole picture.
 */
enum core_status splat_draw_all(const struct splat_core *splat, struct splat_picture *pictures, uint32_t count);

/* Draws a picture as the uniforms are; counts its samples, and stores the first `room` of them. */
enum core_status splat_draw(const struct splat_core *splat, const struct splat_disc *discs, uint32_t count,
                            struct splat_sample *frame, uint32_t room, uint32_t *samples);

#endif
