#ifndef POINTCORE_H
#define POINTCORE_H

/* Written by cbindgen from bindings/c/src; never edit it by hand. */

#include <stddef.h>
#include <stdint.h>

// How a call ended.
typedef enum {
  // As it should.
  POINTCORE_STATUS_OK = 0,
  // What was given makes no sense.
  POINTCORE_STATUS_INPUT = 1,
  // A file cannot be read or written.
  POINTCORE_STATUS_FILE = 2,
  // The hardware could not be generated, built or run, a tool is missing, or hardware and model differ.
  POINTCORE_STATUS_HARDWARE = 3,
  // A fault of pointcore itself.
  POINTCORE_STATUS_INTERNAL = 4,
} PointcoreStatus;

// What computes. There will be more.
typedef enum {
  // The bit-exact, cycle-accurate golden model; needs no tools.
  POINTCORE_BACK_END_GOLDEN = 0,
  // The generated Verilog under Verilator.
  POINTCORE_BACK_END_VERILOG = 1,
  // The generated Verilog under Verilator, every output compared with the golden model in every cycle.
  POINTCORE_BACK_END_VERILOG_IN_LOCKSTEP = 2,
  // The golden interpreter of programs: bit-exact, without time.
  POINTCORE_BACK_END_INTERPRETER = 3,
} PointcoreBackEnd;

// A frame.
typedef struct PointcoreFrame PointcoreFrame;

// Hardware that something calls for.
typedef struct PointcorePlan PointcorePlan;

// A program, and what carries it out.
typedef struct PointcoreProcess PointcoreProcess;

// What left with queries.
typedef struct PointcoreProcessed PointcoreProcessed;

// A scene, and the core that renders it.
typedef struct PointcoreRender PointcoreRender;

// A scene, ready to be rendered.
typedef struct PointcoreScene PointcoreScene;

// Points in a tree, and a core that searches it.
typedef struct PointcoreSearch PointcoreSearch;

// Numbers that have a name: an attribute of points, or a setting.
typedef struct {
  // The name.
  const char *name;
  // `components * count` numbers.
  const double *values;
  // 1, or 3 of a vector.
  size_t components;
  // One for each point, or 1: the same for all. 1 of a setting.
  size_t count;
} PointcoreNamedNumbers;

// Points with their attributes, which are copied.
typedef struct {
  // Where they are: three numbers each.
  const double *points;
  // How many there are.
  size_t count;
  // What is known of each: `attributes_count` attributes. Normals, areas and masses that are missing are estimated.
  const PointcoreNamedNumbers *attributes;
  // How many attributes there are.
  size_t attributes_count;
} PointcoreCloud;

// What is asked of a program.
typedef struct {
  // Neighbors of a query at most, 1 to 64, itself among them.
  uint32_t k;
  // Only neighbors nearer than this count; INFINITY for all.
  double radius;
  // Iterations of a query at most, 1 to 65535; one that is not done by then is capped.
  uint32_t iterations;
  // How often the points are replaced by what leaves, 1 at least.
  uint32_t passes;
  // Columns and rows of queries around each point, for "resample"; 0 and 0 for the usual ones.
  uint32_t pattern[2];
  // Settings, `settings_count`; those that are not given follow from the points.
  const PointcoreNamedNumbers *settings;
  // How many settings there are.
  size_t settings_count;
} PointcoreProcessOptions;

// The arrays of what left with queries, in their order, valid until it is closed.
typedef struct {
  // How many queries there were.
  size_t count;
  // Where they lie in the end, three numbers each: the output `position`, or where they began without it.
  const double *positions;
  // Iterations of each.
  const uint32_t *iterations;
  // Neighbors of each in its last iteration; NULL of a point processor, which does not tell.
  const uint32_t *neighbors;
  // 1 for a query that was not done, but had no iteration left, 0 for others.
  const uint8_t *capped;
  // The output `valid`: 0 where there is no surface, say; NULL of a program without it.
  const uint8_t *valid;
  // Cycles from the first query to the last result, of all programs and passes; 0 of the interpreter.
  uint64_t cycles;
  // The report's figures, a JSON object.
  const char *report;
} PointcoreProcessedArrays;

// The arrays of a frame, row by row from the top left, valid until it is closed.
typedef struct {
  // Samples a row: one a pixel, unless a scene file asks for more.
  size_t width;
  // Rows of samples.
  size_t height;
  // Linear RGB of the surface, three a sample, not shaded; zero where there is none.
  const float *color;
  // Distance from the eye's plane; INFINITY where there is no surface.
  const float *depth;
  // World-space normal, three a sample, of a length up to one; zero where there is no surface.
  const float *normal;
  // 1 where there is a surface, 0 elsewhere.
  const uint8_t *mask;
  // Pixels a row of the picture.
  size_t picture_width;
  // Rows of the picture.
  size_t picture_height;
  // The shaded picture on its background: sRGB, three bytes a pixel.
  const uint8_t *picture;
  // Cycles from the first splat to the end of the frame.
  uint64_t cycles;
  // The report's figures, a JSON object.
  const char *report;
} PointcoreFrameArrays;

// Splats as arrays, which are copied.
typedef struct {
  // How many there are.
  size_t count;
  // Where they are: three numbers each.
  const double *points;
  // Out of the surface: three numbers each, of any length, zero for a splat that faces the eye; NULL if all do.
  const double *normals;
  // Radii: `radii_count` numbers.
  const double *radii;
  // One for all, or one for each.
  size_t radii_count;
  // sRGB from 0 to 1: three numbers each; NULL for white.
  const double *colors;
  // Other than 0 if they are seen from behind, too.
  uint8_t two_sided;
} PointcoreSplats;

// Triangles as arrays, which are copied: drawn before the splats, they hide what lies behind them. They are seen from both sides.
typedef struct {
  // How many vertices there are.
  size_t vertex_count;
  // Where they are: three numbers each.
  const double *vertices;
  // Their normals: three numbers each, of any length; NULL for the means of those of their faces.
  const double *normals;
  // sRGB from 0 to 1: three numbers each; NULL for white.
  const double *colors;
  // How many triangles there are.
  size_t face_count;
  // Indices of their vertices: three each.
  const uint32_t *faces;
} PointcoreMesh;

// A camera.
typedef struct {
  // The eye.
  double eye[3];
  // What it looks at.
  double target[3];
  // What is up in the image.
  double up[3];
  // The vertical opening angle.
  double fov_degrees;
} PointcoreCamera;

// An image.
typedef struct {
  // Pixels a row.
  size_t width;
  // Rows.
  size_t height;
  // sRGB from 0 to 1 where there is no splat.
  double background[3];
} PointcoreImage;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

// Plans the search core for so many points and up to `k` neighbors of each query. `pointcore_plan_close` ends it.
//
// # Safety
// `plan` is a place for a handle.
PointcoreStatus pointcore_plan_search(size_t points,
                                      uint32_t k,
                                      PointcorePlan **plan);

// What was chosen and why, and what it takes, for people; valid until the plan is closed. NULL for NULL.
//
// # Safety
// `plan` is NULL or open.
const char *pointcore_plan_text(const PointcorePlan *plan);

// The hardware's configuration as TOML; valid until the plan is closed. NULL for NULL.
//
// # Safety
// `plan` is NULL or open.
const char *pointcore_plan_toml(const PointcorePlan *plan);

// Ends a plan; NULL is none.
//
// # Safety
// `plan` is NULL or open, and no thread uses it any more.
void pointcore_plan_close(PointcorePlan *plan);

// Writes the Verilog of a configuration, given as TOML, and what goes with it, into a folder, which is made if it is
// missing. The FuseSoC core among the files bears `name`: letters, digits, `_` and `-`.
//
// # Safety
// `configuration`, `folder` and `name` are C strings.
PointcoreStatus pointcore_generate(const char *configuration,
                                   const char *folder,
                                   const char *name);

// Reads a program: the name of an operation, such as "normals", or of one of its programs, the path of a `.pasm` file,
// or a text of several lines (docs/programs.md).
//
// `configuration` is the point processor's, as TOML, or NULL for one that follows from the points; `back_end` is one of
// `PointcoreBackEnd`. The hardware is generated when it is first used. `pointcore_process_close` ends it.
//
// # Safety
// `program` is a C string, `configuration` NULL or one, `process` a place for a handle.
PointcoreStatus pointcore_process_open(const char *program,
                                       const char *configuration,
                                       uint32_t back_end,
                                       PointcoreProcess **process);

// Carries a program out for each point, or for each of some queries instead (NULL for none). Options may be NULL: 16
// neighbors, 16 iterations, one pass. `pointcore_processed_close` ends what is given.
//
// # Safety
// `process` is open, `points`, `queries` and `options` are structures whose pointers hold what they say, the latter two
// or NULL, `processed` is a place for a handle.
PointcoreStatus pointcore_process(const PointcoreProcess *process,
                                  const PointcoreCloud *points,
                                  const PointcoreCloud *queries,
                                  const PointcoreProcessOptions *options,
                                  PointcoreProcessed **processed);

// Ends a program; NULL is none. What left stays.
//
// # Safety
// `process` is NULL or open, and no thread uses it any more.
void pointcore_process_close(PointcoreProcess *process);

// What left under a name, `components` numbers for each query, in their order: ints and truth values, too, all exact;
// NULL if there is no output of the name. Valid until what left is closed. `components` may be NULL.
//
// # Safety
// `processed` is open, `name` a C string, `components` NULL or a place for a number.
const double *pointcore_processed_output(const PointcoreProcessed *processed,
                                         const char *name,
                                         size_t *components);

// The name of the program's output of this number, which counts from 0; NULL if there are not as many. Valid until
// what left is closed.
//
// # Safety
// `processed` is NULL or open.
const char *pointcore_processed_name(const PointcoreProcessed *processed,
                                     size_t index);

// The arrays of what left; all NULL and 0 for NULL.
//
// # Safety
// `processed` is NULL or open.
PointcoreProcessedArrays pointcore_processed_arrays(const PointcoreProcessed *processed);

// Ends what left; NULL is none.
//
// # Safety
// `processed` is NULL or open, and no thread uses it or its arrays any more.
void pointcore_processed_close(PointcoreProcessed *processed);

// Generates the core of a scene, or of a configuration given as TOML instead of NULL; `back_end` is one of
// `PointcoreBackEnd`. `pointcore_render_close` ends it.
//
// # Safety
// `scene` is open, `configuration` NULL or a C string, `render` a place for a handle.
PointcoreStatus pointcore_render_open(const PointcoreScene *scene,
                                      const char *configuration,
                                      uint32_t back_end,
                                      PointcoreRender **render);

// Frames of the scene's sequence, one at least; 0 for NULL.
//
// # Safety
// `render` is NULL or open.
size_t pointcore_render_frames(const PointcoreRender *render);

// Renders a frame of the sequence, which counts from 0. `pointcore_frame_close` ends it.
//
// # Safety
// `render` is open, `frame` a place for a handle.
PointcoreStatus pointcore_render_frame(const PointcoreRender *render,
                                       size_t index,
                                       PointcoreFrame **frame);

// The arrays of a frame; all NULL and 0 for NULL.
//
// # Safety
// `frame` is NULL or open.
PointcoreFrameArrays pointcore_frame_arrays(const PointcoreFrame *frame);

// Ends a frame; NULL is none.
//
// # Safety
// `frame` is NULL or open, and no thread uses it or its arrays any more.
void pointcore_frame_close(PointcoreFrame *frame);

// Ends a rendering; NULL is none. Its frames stay.
//
// # Safety
// `render` is NULL or open, and no thread uses it any more.
void pointcore_render_close(PointcoreRender *render);

// Makes a scene of splats, and of triangles beside them where `mesh` is not NULL; without a camera (NULL) one sees all of it.
// `pointcore_scene_close` ends it.
//
// # Safety
// `splats`, `mesh` and `image` are structures whose pointers hold what they say, `mesh` and `camera` may be NULL, `scene` is a
// place for a handle.
PointcoreStatus pointcore_scene_open(const PointcoreSplats *splats,
                                     const PointcoreMesh *mesh,
                                     const PointcoreCamera *camera,
                                     const PointcoreImage *image,
                                     PointcoreScene **scene);

// Loads a scene file, or a model that a camera fits. `pointcore_scene_close` ends it.
//
// # Safety
// `path` is a C string, `scene` a place for a handle.
PointcoreStatus pointcore_scene_load(const char *path, PointcoreScene **scene);

// Plans the renderer that a scene calls for. `pointcore_plan_close` ends it.
//
// # Safety
// `scene` is open, `plan` is a place for a handle.
PointcoreStatus pointcore_plan_scene(const PointcoreScene *scene, PointcorePlan **plan);

// Ends a scene; NULL is none. What renders it may go on.
//
// # Safety
// `scene` is NULL or open, and no thread uses it any more.
void pointcore_scene_close(PointcoreScene *scene);

// Sorts `count` points, three numbers each, into a tree, and generates a core for up to `k` neighbors of each query.
//
// `configuration` is the hardware's, as TOML, or NULL for one that follows from the points; `back_end` is one of
// `PointcoreBackEnd`. `pointcore_search_close` ends it.
//
// # Safety
// `points` holds 3 * `count` numbers, `configuration` is NULL or a C string, `search` a place for a handle.
PointcoreStatus pointcore_search_open(const double *points,
                                      size_t count,
                                      uint32_t k,
                                      const char *configuration,
                                      uint32_t back_end,
                                      PointcoreSearch **search);

// The nearest `k` neighbors of each of `count` queries, nearer than `radius`; INFINITY for all.
//
// For each query `indices` and `distances2` are given `k` numbers, nearest first: indices of points, -1 where there
// are fewer, and squared distances, INFINITY there; `counts` is given how many there are, and `cycles` the cycles of
// the whole run. Any of these may be NULL.
//
// # Safety
// `search` is open, `queries` holds 3 * `count` numbers, `indices` and `distances2` have places for `k` * `count`,
// `counts` for `count`.
PointcoreStatus pointcore_search(const PointcoreSearch *search,
                                 const double *queries,
                                 size_t count,
                                 uint32_t k,
                                 double radius,
                                 int64_t *indices,
                                 float *distances2,
                                 uint32_t *counts,
                                 uint64_t *cycles);

// Ends a search; NULL is none.
//
// # Safety
// `search` is NULL or open, and no thread uses it any more.
void pointcore_search_close(PointcoreSearch *search);

// What was wrong with this thread's last call that failed; valid until its next one does. Empty if none did.
const char *pointcore_error_message(void);

// The library's version, such as "0.1.0".
const char *pointcore_version(void);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* POINTCORE_H */
