/* splat_axi: registers, packets and memory records. Written by pointcore; docs/interfaces.md says how they are used. */
#ifndef POINTCORE_SPLAT_REGISTERS_H
#define POINTCORE_SPLAT_REGISTERS_H

#include <stdint.h>

#ifndef POINTCORE_STATIC_ASSERT
#ifdef __cplusplus
#define POINTCORE_STATIC_ASSERT static_assert
#elif defined(__STDC_VERSION__) && __STDC_VERSION__ >= 201112L
#define POINTCORE_STATIC_ASSERT _Static_assert
#else
#define POINTCORE_STATIC_ASSERT(holds, text) extern int pointcore_static_assert[(holds) ? 1 : -1]
#endif
#endif

#define SPLAT_STREAM_BITS 64
#define SPLAT_MEMORY_BITS 64

/* Byte addresses of registers, and their bits. */
#define SPLAT_ID 0x000u /* read: "PC", the core (0x0A, 0x0B or 0x0C), the layout's version (1) */
#define SPLAT_CONTROL 0x004u /* write: commands */
#define SPLAT_CONTROL_START (UINT32_C(1) << 0) /* begins a run, clears `done` and the run's counters */
#define SPLAT_CONTROL_RESET (UINT32_C(1) << 1) /* resets the core's state (caches, threads); uniforms and the tree stay */
#define SPLAT_CONTROL_CLEAR_ERRORS (UINT32_C(1) << 2) /* clears the error counters */
#define SPLAT_CONTROL_ABORT (UINT32_C(1) << 3) /* ends the run under way: the core is reset, what is under way on the buses is taken and dropped; without a run, nothing */
#define SPLAT_STATUS 0x008u /* read: where the core is */
#define SPLAT_STATUS_BUSY (UINT32_C(1) << 0) /* a run is under way */
#define SPLAT_STATUS_DONE (UINT32_C(1) << 1) /* a run has ended since the last start */
#define SPLAT_STATUS_ERROR (UINT32_C(1) << 2) /* an error counter is not zero */
#define SPLAT_STATUS_WAITING (UINT32_C(1) << 3) /* a start waits until its frame may begin */
#define SPLAT_INTERRUPT_ENABLE 0x00cu /* read, write: what raises `irq` */
#define SPLAT_INTERRUPT_ENABLE_DONE (UINT32_C(1) << 0) /* `irq` is high while `done` is */
#define SPLAT_ACCESS_ERRORS 0x010u /* read: register accesses refused: outside the map, not of a whole aligned word, written where only read or read where only written, a value that makes no sense */
#define SPLAT_BUSY_ERRORS 0x014u /* read: accesses refused because a run is under way */
#define SPLAT_BURST_ERRORS 0x018u /* read: bursts refused by `s_axi`, read bursts from memory whose `rlast` was not at their end, beats from memory that nobody asked for, and leaves without beats, read as of one */
#define SPLAT_PACKET_ERRORS 0x01cu /* read: packets refused: `tlast` before or after their end, or a field out of its range */
#define SPLAT_MEMORY_ERRORS 0x020u /* read: responses from memory that were not OKAY */
#define SPLAT_CYCLES 0x024u /* read: cycles of the run, to its end or so far */
#define SPLAT_PACKETS_IN 0x028u /* read: packets taken in the run */
#define SPLAT_PACKETS_OUT 0x02cu /* read: packets sent in the run */
#define SPLAT_EVENT_SAMPLE 0x040u /* read: cycles of the run in which `event_sample` was high */
#define SPLAT_EVENT_STARVED 0x044u /* read: cycles of the run in which `event_starved` was high */
#define SPLAT_EVENT_BLOCKED 0x048u /* read: cycles of the run in which `event_blocked` was high */
#define SPLAT_EVENT_ACCUMULATE 0x04cu /* read: cycles of the run in which `event_accumulate` was high */
#define SPLAT_EVENT_HAZARD 0x050u /* read: cycles of the run in which `event_hazard` was high */
#define SPLAT_EVENT_SLOT_WAIT 0x054u /* read: cycles of the run in which `event_slot_wait` was high */
#define SPLAT_BUFFER_BASE 0x080u /* read, write: address of the reconstruction buffer, a multiple of 4096 */
#define SPLAT_M00 0x100u /* write: uniform `m00`, in f24-ftz */
#define SPLAT_M01 0x104u /* write: uniform `m01`, in f24-ftz */
#define SPLAT_M02 0x108u /* write: uniform `m02`, in f24-ftz */
#define SPLAT_M03 0x10cu /* write: uniform `m03`, in f24-ftz */
#define SPLAT_M10 0x110u /* write: uniform `m10`, in f24-ftz */
#define SPLAT_M11 0x114u /* write: uniform `m11`, in f24-ftz */
#define SPLAT_M12 0x118u /* write: uniform `m12`, in f24-ftz */
#define SPLAT_M13 0x11cu /* write: uniform `m13`, in f24-ftz */
#define SPLAT_M20 0x120u /* write: uniform `m20`, in f24-ftz */
#define SPLAT_M21 0x124u /* write: uniform `m21`, in f24-ftz */
#define SPLAT_M22 0x128u /* write: uniform `m22`, in f24-ftz */
#define SPLAT_M23 0x12cu /* write: uniform `m23`, in f24-ftz */
#define SPLAT_SCALE_X 0x130u /* write: uniform `scale_x`, in f24-ftz */
#define SPLAT_SCALE_Y 0x134u /* write: uniform `scale_y`, in f24-ftz */
#define SPLAT_ORIGIN_X 0x138u /* write: uniform `origin_x`, in f24-ftz */
#define SPLAT_ORIGIN_Y 0x13cu /* write: uniform `origin_y`, in f24-ftz */
#define SPLAT_DEPTH_A 0x140u /* write: uniform `depth_a`, in f24-ftz */
#define SPLAT_DEPTH_B 0x144u /* write: uniform `depth_b`, in f24-ftz */
#define SPLAT_NEAR_PLANE 0x148u /* write: uniform `near_plane`, in f24-ftz */
#define SPLAT_EPSILON_SCALE 0x14cu /* write: uniform `epsilon_scale`, in f24-ftz */
#define SPLAT_EPSILON_BIAS 0x150u /* write: uniform `epsilon_bias`, in f24-ftz */
#define SPLAT_FILTER_RADIUS 0x154u /* write: uniform `filter_radius`, in f24-ftz */
#define SPLAT_FILTER_SCALE 0x158u /* write: uniform `filter_scale`, in f24-ftz */
#define SPLAT_IDENTITY UINT32_C(0x50430a01) /* what SPLAT_ID reads */

/* What the configuration fixes. */
#define SPLAT_WIDTH 512u /* columns of samples */
#define SPLAT_HEIGHT 512u /* rows of samples */
#define SPLAT_FLIPQUAD 0 /* two columns of samples a pixel, else one in its middle */
#define SPLAT_TIME_BINS 0u /* columns that each sample has for parts of the exposure, none where nothing moves */
#define SPLAT_TILE_SIZE 8u /* edge of a tile, in samples */
#define SPLAT_BUFFER_BYTES 16777216u /* the reconstruction buffer */
#define SPLAT_CONTINUOUS 6u /* attributes that are blended */
#define SPLAT_CARDINAL 1u /* attributes that are selected */
#define SPLAT_CULLING 1 /* splats that face away from the eye are not drawn */
#define SPLAT_SCREEN_FILTER 1 /* splats cover `filter_radius` around their centre at least */
#define SPLAT_EYE_PLANE 1 /* splats may reach behind the eye */
#define SPLAT_DEPTH_PLANE 0 /* samples have the depth of the splat's plane, else of its centre */
#define SPLAT_KERNEL_GAMMA 2.0 /* weights are exp(-gamma rho^2) */
#define SPLAT_GEOMETRY_EXPONENT_BITS 8u /* of f24-ftz, docs/numbers.md */
#define SPLAT_GEOMETRY_MANTISSA_BITS 15u /* behind the leading one */
#define SPLAT_GEOMETRY_INFINITY UINT32_C(0x7f8000) /* positive */
#define SPLAT_GEOMETRY_NAN UINT32_C(0x7fc000) /* the one that operators return */
#define SPLAT_ATTRIBUTE_EXPONENT_BITS 5u /* of f16, docs/numbers.md */
#define SPLAT_ATTRIBUTE_MANTISSA_BITS 10u /* behind the leading one */
#define SPLAT_ATTRIBUTE_INFINITY UINT32_C(0x7c00) /* positive */
#define SPLAT_ATTRIBUTE_NAN UINT32_C(0x7e00) /* the one that operators return */
#define SPLAT_FILTER_SCALE_EXPONENT_BITS 8u /* of f24-ftz, docs/numbers.md */
#define SPLAT_FILTER_SCALE_MANTISSA_BITS 15u /* behind the leading one */
#define SPLAT_FILTER_SCALE_INFINITY UINT32_C(0x7f8000) /* positive */
#define SPLAT_FILTER_SCALE_NAN UINT32_C(0x7fc000) /* the one that operators return */

/* A splat in world space, or with `end` set the end of the frame. */
struct splat_splat {
    uint8_t end; /* 1 bits */
    uint8_t padding_0[3];
    uint32_t center_x; /* 24 bits */
    uint32_t center_y; /* 24 bits */
    uint32_t center_z; /* 24 bits */
    uint32_t tangent1_x; /* 24 bits */
    uint32_t tangent1_y; /* 24 bits */
    uint32_t tangent1_z; /* 24 bits */
    uint32_t tangent2_x; /* 24 bits */
    uint32_t tangent2_y; /* 24 bits */
    uint32_t tangent2_z; /* 24 bits */
    uint16_t attribute_0; /* 16 bits */
    uint16_t attribute_1; /* 16 bits */
    uint16_t attribute_2; /* 16 bits */
    uint16_t attribute_3; /* 16 bits */
    uint16_t attribute_4; /* 16 bits */
    uint16_t attribute_5; /* 16 bits */
    uint16_t cardinal_0; /* 16 bits */
    uint8_t padding_1[2];
};
POINTCORE_STATIC_ASSERT(sizeof(struct splat_splat) == 56, "splat_splat takes 56 bytes");
#define SPLAT_SPLAT_BYTES 56u
#define SPLAT_SPLAT_END_BITS 1u
#define SPLAT_SPLAT_CENTER_X_BITS 24u
#define SPLAT_SPLAT_CENTER_Y_BITS 24u
#define SPLAT_SPLAT_CENTER_Z_BITS 24u
#define SPLAT_SPLAT_TANGENT1_X_BITS 24u
#define SPLAT_SPLAT_TANGENT1_Y_BITS 24u
#define SPLAT_SPLAT_TANGENT1_Z_BITS 24u
#define SPLAT_SPLAT_TANGENT2_X_BITS 24u
#define SPLAT_SPLAT_TANGENT2_Y_BITS 24u
#define SPLAT_SPLAT_TANGENT2_Z_BITS 24u
#define SPLAT_SPLAT_ATTRIBUTE_0_BITS 16u
#define SPLAT_SPLAT_ATTRIBUTE_1_BITS 16u
#define SPLAT_SPLAT_ATTRIBUTE_2_BITS 16u
#define SPLAT_SPLAT_ATTRIBUTE_3_BITS 16u
#define SPLAT_SPLAT_ATTRIBUTE_4_BITS 16u
#define SPLAT_SPLAT_ATTRIBUTE_5_BITS 16u
#define SPLAT_SPLAT_CARDINAL_0_BITS 16u

/* A pixel of the picture, or with `end` set the end of the frame. */
struct splat_fragment {
    uint8_t end; /* 1 bits */
    uint8_t padding_0[1];
    uint16_t column; /* 9 bits */
    uint16_t row; /* 9 bits */
    uint8_t padding_1[2];
    uint32_t depth; /* 24 bits */
    uint16_t attribute_0; /* 16 bits */
    uint16_t attribute_1; /* 16 bits */
    uint16_t attribute_2; /* 16 bits */
    uint16_t attribute_3; /* 16 bits */
    uint16_t attribute_4; /* 16 bits */
    uint16_t attribute_5; /* 16 bits */
    uint16_t cardinal_0; /* 16 bits */
    uint8_t padding_2[6];
};
POINTCORE_STATIC_ASSERT(sizeof(struct splat_fragment) == 32, "splat_fragment takes 32 bytes");
#define SPLAT_FRAGMENT_BYTES 32u
#define SPLAT_FRAGMENT_END_BITS 1u
#define SPLAT_FRAGMENT_COLUMN_BITS 9u
#define SPLAT_FRAGMENT_ROW_BITS 9u
#define SPLAT_FRAGMENT_DEPTH_BITS 24u
#define SPLAT_FRAGMENT_ATTRIBUTE_0_BITS 16u
#define SPLAT_FRAGMENT_ATTRIBUTE_1_BITS 16u
#define SPLAT_FRAGMENT_ATTRIBUTE_2_BITS 16u
#define SPLAT_FRAGMENT_ATTRIBUTE_3_BITS 16u
#define SPLAT_FRAGMENT_ATTRIBUTE_4_BITS 16u
#define SPLAT_FRAGMENT_ATTRIBUTE_5_BITS 16u
#define SPLAT_FRAGMENT_CARDINAL_0_BITS 16u

/* A pixel of the reconstruction buffer, which only the core reads and writes. */
struct splat_pixel {
    uint32_t weight; /* 28 bits */
    uint8_t padding_0[4];
    uint64_t depth; /* 52 bits */
    uint16_t peak; /* 16 bits */
    uint16_t attribute_0; /* 16 bits */
    uint16_t attribute_1; /* 16 bits */
    uint16_t attribute_2; /* 16 bits */
    uint16_t attribute_3; /* 16 bits */
    uint16_t attribute_4; /* 16 bits */
    uint16_t attribute_5; /* 16 bits */
    uint16_t cardinal_0; /* 16 bits */
};
POINTCORE_STATIC_ASSERT(sizeof(struct splat_pixel) == 32, "splat_pixel takes 32 bytes");
#define SPLAT_PIXEL_BYTES 32u
#define SPLAT_PIXEL_WEIGHT_BITS 28u
#define SPLAT_PIXEL_DEPTH_BITS 52u
#define SPLAT_PIXEL_PEAK_BITS 16u
#define SPLAT_PIXEL_ATTRIBUTE_0_BITS 16u
#define SPLAT_PIXEL_ATTRIBUTE_1_BITS 16u
#define SPLAT_PIXEL_ATTRIBUTE_2_BITS 16u
#define SPLAT_PIXEL_ATTRIBUTE_3_BITS 16u
#define SPLAT_PIXEL_ATTRIBUTE_4_BITS 16u
#define SPLAT_PIXEL_ATTRIBUTE_5_BITS 16u
#define SPLAT_PIXEL_CARDINAL_0_BITS 16u

#endif
