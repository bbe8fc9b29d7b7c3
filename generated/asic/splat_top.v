// The whole design is one file, named after its top.
/* verilator lint_off DECLFILENAME */

// Surface-splat renderer: splats in, normalized fragments out.
module splat_top (
    input  wire clk,
    input  wire rst,
    input  wire uniform_valid,  // Write to a uniform register, not while a frame is under way.
    input  wire [4:0] uniform_address,  // Its place among the frame's uniforms.
    input  wire [23:0] uniform_data,  // Its new value.
    input  wire splat_valid,  // Splats in world space.
    output wire splat_ready,
    input  wire splat_end,  // Closes the frame.
    input  wire [23:0] splat_center_x,  // Center.
    input  wire [23:0] splat_center_y,  // Center.
    input  wire [23:0] splat_center_z,  // Center.
    input  wire [23:0] splat_tangent1_x,  // Tangents, whose ends lie at rho = 1.
    input  wire [23:0] splat_tangent1_y,  // Tangents, whose ends lie at rho = 1.
    input  wire [23:0] splat_tangent1_z,  // Tangents, whose ends lie at rho = 1.
    input  wire [23:0] splat_tangent2_x,  // Tangents, whose ends lie at rho = 1.
    input  wire [23:0] splat_tangent2_y,  // Tangents, whose ends lie at rho = 1.
    input  wire [23:0] splat_tangent2_z,  // Tangents, whose ends lie at rho = 1.
    input  wire [11:0] splat_attribute_0,  // Attributes.
    input  wire [11:0] splat_attribute_1,  // Attributes.
    input  wire [11:0] splat_attribute_2,  // Attributes.
    output wire read_valid,  // Request for the pixels of a tile.
    input  wire read_ready,
    output wire [11:0] read_tile,  // Tile index.
    input  wire data_valid,  // Pixels of the tiles requested, in pixel order.
    output wire data_ready,
    input  wire [27:0] data_weight,  // Sum of weights.
    input  wire [51:0] data_depth,  // Sum of weighted depths.
    input  wire [39:0] data_attribute_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [39:0] data_attribute_1,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [39:0] data_attribute_2,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire write_valid,  // Pixels of evicted tiles.
    input  wire write_ready,
    output wire [11:0] write_tile,  // Tile index.
    output wire [5:0] write_pixel,  // Pixel of the tile.
    output wire [27:0] write_weight,  // Sum of weights.
    output wire [51:0] write_depth,  // Sum of weighted depths.
    output wire [39:0] write_attribute_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [39:0] write_attribute_1,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [39:0] write_attribute_2,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire fragment_valid,  // Fragments of the image.
    input  wire fragment_ready,
    output wire fragment_end,  // Closes the frame.
    output wire [8:0] fragment_column,  // Column of the image.
    output wire [8:0] fragment_row,  // Row of the image.
    output wire [23:0] fragment_depth,  // Depth in the geometry format.
    output wire [11:0] fragment_attribute_0,  // Attributes.
    output wire [11:0] fragment_attribute_1,  // Attributes.
    output wire [11:0] fragment_attribute_2,  // Attributes.
    output wire event_sample,  // The rasterizer evaluated a sample.
    output wire event_starved,  // The rasterizer had no copy to work on.
    output wire event_blocked,  // The rasterizer's pipeline was held by what follows it.
    output wire event_accumulate,  // The accumulator took a sample.
    output wire event_hazard,  // The accumulator waited for an earlier sample of the same pixel.
    output wire event_slot_wait  // The accumulator waited for its tile to arrive in the cache.
);
    reg [23:0] uniform_m00, uniform_m01, uniform_m02, uniform_m03, uniform_m10, uniform_m11, uniform_m12;
    reg [23:0] uniform_m13, uniform_m20, uniform_m21, uniform_m22, uniform_m23, uniform_scale_x, uniform_scale_y;
    reg [23:0] uniform_origin_x, uniform_origin_y, uniform_depth_a, uniform_depth_b, uniform_near_plane;
    reg [23:0] uniform_epsilon_scale, uniform_epsilon_bias, uniform_filter_radius;
    reg [15:0] uniform_filter_scale;

    wire transform_in_ready, transform_out_valid, transform_out_end;
    wire [23:0] transform_out_center_x, transform_out_center_y, transform_out_center_z, transform_out_tangent1_x;
    wire [23:0] transform_out_tangent1_y, transform_out_tangent1_z, transform_out_tangent2_x;
    wire [23:0] transform_out_tangent2_y, transform_out_tangent2_z;
    wire [11:0] transform_out_attribute_0, transform_out_attribute_1, transform_out_attribute_2;
    wire setup_in_ready, setup_out_valid, setup_out_end;
    wire [25:0] setup_out_center_x, setup_out_center_y;
    wire [15:0] setup_out_ax, setup_out_bx, setup_out_ay, setup_out_by;
    wire [19:0] setup_out_delta;
    wire [15:0] setup_out_mx, setup_out_my;
    wire [3:0] setup_out_shift;
    wire [23:0] setup_out_depth, setup_out_depth_low, setup_out_depth_high;
    wire [11:0] setup_out_attribute_0, setup_out_attribute_1, setup_out_attribute_2;
    wire [8:0] setup_out_left, setup_out_right, setup_out_top, setup_out_bottom;
    wire splitter_in_ready, splitter_out_valid, splitter_out_end;
    wire [25:0] splitter_out_center_x, splitter_out_center_y;
    wire [15:0] splitter_out_ax, splitter_out_bx, splitter_out_ay, splitter_out_by;
    wire [19:0] splitter_out_delta;
    wire [15:0] splitter_out_mx, splitter_out_my;
    wire [3:0] splitter_out_shift;
    wire [23:0] splitter_out_depth, splitter_out_depth_low, splitter_out_depth_high;
    wire [11:0] splitter_out_attribute_0, splitter_out_attribute_1, splitter_out_attribute_2;
    wire [2:0] splitter_out_left, splitter_out_right, splitter_out_top, splitter_out_bottom;
    wire [11:0] splitter_out_tile;
    wire reorder_in_ready, reorder_out_valid, reorder_out_end;
    wire [25:0] reorder_out_center_x, reorder_out_center_y;
    wire [15:0] reorder_out_ax, reorder_out_bx, reorder_out_ay, reorder_out_by;
    wire [19:0] reorder_out_delta;
    wire [15:0] reorder_out_mx, reorder_out_my;
    wire [3:0] reorder_out_shift;
    wire [23:0] reorder_out_depth, reorder_out_depth_low, reorder_out_depth_high;
    wire [11:0] reorder_out_attribute_0, reorder_out_attribute_1, reorder_out_attribute_2;
    wire [2:0] reorder_out_left, reorder_out_right, reorder_out_top, reorder_out_bottom;
    wire [11:0] reorder_out_tile;
    wire tile_cache_in_ready, tile_cache_out_valid, tile_cache_out_end;
    wire [25:0] tile_cache_out_center_x, tile_cache_out_center_y;
    wire [15:0] tile_cache_out_ax, tile_cache_out_bx, tile_cache_out_ay, tile_cache_out_by;
    wire [19:0] tile_cache_out_delta;
    wire [15:0] tile_cache_out_mx, tile_cache_out_my;
    wire [3:0] tile_cache_out_shift;
    wire [23:0] tile_cache_out_depth, tile_cache_out_depth_low, tile_cache_out_depth_high;
    wire [11:0] tile_cache_out_attribute_0, tile_cache_out_attribute_1, tile_cache_out_attribute_2;
    wire [2:0] tile_cache_out_left, tile_cache_out_right, tile_cache_out_top, tile_cache_out_bottom;
    wire [11:0] tile_cache_out_tile;
    wire tile_cache_out_slot, tile_cache_read_valid;
    wire [11:0] tile_cache_read_tile;
    wire tile_cache_data_ready, tile_cache_write_valid;
    wire [11:0] tile_cache_write_tile;
    wire [5:0] tile_cache_write_pixel;
    wire [27:0] tile_cache_write_weight;
    wire [51:0] tile_cache_write_depth;
    wire [39:0] tile_cache_write_attribute_0, tile_cache_write_attribute_1, tile_cache_write_attribute_2;
    wire tile_cache_pixel_valid, tile_cache_pixel_end;
    wire [11:0] tile_cache_pixel_tile;
    wire [5:0] tile_cache_pixel_pixel;
    wire [27:0] tile_cache_pixel_weight;
    wire [51:0] tile_cache_pixel_depth;
    wire [39:0] tile_cache_pixel_attribute_0, tile_cache_pixel_attribute_1, tile_cache_pixel_attribute_2;
    wire [1:0] tile_cache_slot_ready;
    wire tile_cache_fill_valid, tile_cache_fill_slot;
    wire [5:0] tile_cache_fill_pixel;
    wire [27:0] tile_cache_fill_weight;
    wire [51:0] tile_cache_fill_depth;
    wire [39:0] tile_cache_fill_attribute_0, tile_cache_fill_attribute_1, tile_cache_fill_attribute_2;
    wire tile_cache_drain_enable, tile_cache_drain_slot;
    wire [5:0] tile_cache_drain_pixel;
    wire rasterizer_in_ready, rasterizer_out_valid, rasterizer_out_end, rasterizer_out_last;
    wire rasterizer_out_inside, rasterizer_out_slot;
    wire [5:0] rasterizer_out_pixel;
    wire [15:0] rasterizer_out_weight;
    wire [23:0] rasterizer_out_depth, rasterizer_out_depth_low, rasterizer_out_depth_high;
    wire [11:0] rasterizer_out_attribute_0, rasterizer_out_attribute_1, rasterizer_out_attribute_2;
    wire rasterizer_event_sample, rasterizer_event_starved, rasterizer_event_blocked, weighting_in_ready;
    wire weighting_out_valid, weighting_out_end, weighting_out_last, weighting_out_inside, weighting_out_slot;
    wire [5:0] weighting_out_pixel;
    wire [15:0] weighting_out_weight;
    wire [39:0] weighting_out_weighted_depth;
    wire [23:0] weighting_out_depth_low, weighting_out_depth_high;
    wire [27:0] weighting_out_attribute_0, weighting_out_attribute_1, weighting_out_attribute_2;
    wire accumulator_in_ready, accumulator_retire_valid, accumulator_retire_slot, accumulator_frame_end;
    wire [27:0] accumulator_drain_weight;
    wire [51:0] accumulator_drain_depth;
    wire [39:0] accumulator_drain_attribute_0, accumulator_drain_attribute_1, accumulator_drain_attribute_2;
    wire accumulator_event_accumulate, accumulator_event_hazard, accumulator_event_slot_wait;
    wire normalizer_in_ready, normalizer_out_valid, normalizer_out_end;
    wire [8:0] normalizer_out_column, normalizer_out_row;
    wire [23:0] normalizer_out_depth;
    wire [11:0] normalizer_out_attribute_0, normalizer_out_attribute_1, normalizer_out_attribute_2;

    assign splat_ready = transform_in_ready;
    assign read_valid = tile_cache_read_valid;
    assign read_tile = tile_cache_read_tile;
    assign data_ready = tile_cache_data_ready;
    assign write_valid = tile_cache_write_valid;
    assign write_tile = tile_cache_write_tile;
    assign write_pixel = tile_cache_write_pixel;
    assign write_weight = tile_cache_write_weight;
    assign write_depth = tile_cache_write_depth;
    assign write_attribute_0 = tile_cache_write_attribute_0;
    assign write_attribute_1 = tile_cache_write_attribute_1;
    assign write_attribute_2 = tile_cache_write_attribute_2;
    assign fragment_valid = normalizer_out_valid;
    assign fragment_end = normalizer_out_end;
    assign fragment_column = normalizer_out_column;
    assign fragment_row = normalizer_out_row;
    assign fragment_depth = normalizer_out_depth;
    assign fragment_attribute_0 = normalizer_out_attribute_0;
    assign fragment_attribute_1 = normalizer_out_attribute_1;
    assign fragment_attribute_2 = normalizer_out_attribute_2;
    assign event_sample = rasterizer_event_sample;
    assign event_starved = rasterizer_event_starved;
    assign event_blocked = rasterizer_event_blocked;
    assign event_accumulate = accumulator_event_accumulate;
    assign event_hazard = accumulator_event_hazard;
    assign event_slot_wait = accumulator_event_slot_wait;

    splat_transform transform (
        .clk(clk), .rst(rst),
        .in_valid(splat_valid), .in_ready(transform_in_ready), .in_end(splat_end),
        .in_center_x(splat_center_x), .in_center_y(splat_center_y), .in_center_z(splat_center_z),
        .in_tangent1_x(splat_tangent1_x), .in_tangent1_y(splat_tangent1_y), .in_tangent1_z(splat_tangent1_z),
        .in_tangent2_x(splat_tangent2_x), .in_tangent2_y(splat_tangent2_y), .in_tangent2_z(splat_tangent2_z),
        .in_attribute_0(splat_attribute_0), .in_attribute_1(splat_attribute_1),
        .in_attribute_2(splat_attribute_2),
        .m00(uniform_m00), .m01(uniform_m01), .m02(uniform_m02), .m03(uniform_m03), .m10(uniform_m10),
        .m11(uniform_m11), .m12(uniform_m12), .m13(uniform_m13), .m20(uniform_m20), .m21(uniform_m21),
        .m22(uniform_m22), .m23(uniform_m23),
        .near_plane(uniform_near_plane),
        .out_valid(transform_out_valid), .out_ready(setup_in_ready), .out_end(transform_out_end),
        .out_center_x(transform_out_center_x), .out_center_y(transform_out_center_y),
        .out_center_z(transform_out_center_z), .out_tangent1_x(transform_out_tangent1_x),
        .out_tangent1_y(transform_out_tangent1_y), .out_tangent1_z(transform_out_tangent1_z),
        .out_tangent2_x(transform_out_tangent2_x), .out_tangent2_y(transform_out_tangent2_y),
        .out_tangent2_z(transform_out_tangent2_z), .out_attribute_0(transform_out_attribute_0),
        .out_attribute_1(transform_out_attribute_1), .out_attribute_2(transform_out_attribute_2)
    );

    splat_setup setup (
        .clk(clk), .rst(rst),
        .in_valid(transform_out_valid), .in_ready(setup_in_ready), .in_end(transform_out_end),
        .in_center_x(transform_out_center_x), .in_center_y(transform_out_center_y),
        .in_center_z(transform_out_center_z), .in_tangent1_x(transform_out_tangent1_x),
        .in_tangent1_y(transform_out_tangent1_y), .in_tangent1_z(transform_out_tangent1_z),
        .in_tangent2_x(transform_out_tangent2_x), .in_tangent2_y(transform_out_tangent2_y),
        .in_tangent2_z(transform_out_tangent2_z), .in_attribute_0(transform_out_attribute_0),
        .in_attribute_1(transform_out_attribute_1), .in_attribute_2(transform_out_attribute_2),
        .filter_radius(uniform_filter_radius),
        .scale_x(uniform_scale_x),
        .origin_x(uniform_origin_x),
        .scale_y(uniform_scale_y),
        .origin_y(uniform_origin_y),
        .depth_b(uniform_depth_b), .depth_a(uniform_depth_a),
        .epsilon_scale(uniform_epsilon_scale), .epsilon_bias(uniform_epsilon_bias),
        .out_valid(setup_out_valid), .out_ready(splitter_in_ready), .out_end(setup_out_end),
        .out_center_x(setup_out_center_x), .out_center_y(setup_out_center_y), .out_ax(setup_out_ax),
        .out_bx(setup_out_bx), .out_ay(setup_out_ay), .out_by(setup_out_by), .out_delta(setup_out_delta),
        .out_mx(setup_out_mx), .out_my(setup_out_my), .out_shift(setup_out_shift),
        .out_depth(setup_out_depth), .out_depth_low(setup_out_depth_low),
        .out_depth_high(setup_out_depth_high), .out_attribute_0(setup_out_attribute_0),
        .out_attribute_1(setup_out_attribute_1), .out_attribute_2(setup_out_attribute_2),
        .out_left(setup_out_left), .out_right(setup_out_right), .out_top(setup_out_top),
        .out_bottom(setup_out_bottom)
    );

    splat_splitter splitter (
        .clk(clk), .rst(rst),
        .in_valid(setup_out_valid), .in_ready(splitter_in_ready), .in_end(setup_out_end),
        .in_center_x(setup_out_center_x), .in_center_y(setup_out_center_y), .in_ax(setup_out_ax),
        .in_bx(setup_out_bx), .in_ay(setup_out_ay), .in_by(setup_out_by), .in_delta(setup_out_delta),
        .in_mx(setup_out_mx), .in_my(setup_out_my), .in_shift(setup_out_shift), .in_depth(setup_out_depth),
        .in_depth_low(setup_out_depth_low), .in_depth_high(setup_out_depth_high),
        .in_attribute_0(setup_out_attribute_0), .in_attribute_1(setup_out_attribute_1),
        .in_attribute_2(setup_out_attribute_2), .in_left(setup_out_left), .in_right(setup_out_right),
        .in_top(setup_out_top), .in_bottom(setup_out_bottom),
        .out_valid(splitter_out_valid), .out_ready(reorder_in_ready), .out_end(splitter_out_end),
        .out_center_x(splitter_out_center_x), .out_center_y(splitter_out_center_y), .out_ax(splitter_out_ax),
        .out_bx(splitter_out_bx), .out_ay(splitter_out_ay), .out_by(splitter_out_by),
        .out_delta(splitter_out_delta), .out_mx(splitter_out_mx), .out_my(splitter_out_my),
        .out_shift(splitter_out_shift), .out_depth(splitter_out_depth),
        .out_depth_low(splitter_out_depth_low), .out_depth_high(splitter_out_depth_high),
        .out_attribute_0(splitter_out_attribute_0), .out_attribute_1(splitter_out_attribute_1),
        .out_attribute_2(splitter_out_attribute_2), .out_left(splitter_out_left),
        .out_right(splitter_out_right), .out_top(splitter_out_top), .out_bottom(splitter_out_bottom),
        .out_tile(splitter_out_tile)
    );

    splat_reorder reorder (
        .clk(clk), .rst(rst),
        .in_valid(splitter_out_valid), .in_ready(reorder_in_ready), .in_end(splitter_out_end),
        .in_center_x(splitter_out_center_x), .in_center_y(splitter_out_center_y), .in_ax(splitter_out_ax),
        .in_bx(splitter_out_bx), .in_ay(splitter_out_ay), .in_by(splitter_out_by),
        .in_delta(splitter_out_delta), .in_mx(splitter_out_mx), .in_my(splitter_out_my),
        .in_shift(splitter_out_shift), .in_depth(splitter_out_depth), .in_depth_low(splitter_out_depth_low),
        .in_depth_high(splitter_out_depth_high), .in_attribute_0(splitter_out_attribute_0),
        .in_attribute_1(splitter_out_attribute_1), .in_attribute_2(splitter_out_attribute_2),
        .in_left(splitter_out_left), .in_right(splitter_out_right), .in_top(splitter_out_top),
        .in_bottom(splitter_out_bottom), .in_tile(splitter_out_tile),
        .out_valid(reorder_out_valid), .out_ready(tile_cache_in_ready), .out_end(reorder_out_end),
        .out_center_x(reorder_out_center_x), .out_center_y(reorder_out_center_y), .out_ax(reorder_out_ax),
        .out_bx(reorder_out_bx), .out_ay(reorder_out_ay), .out_by(reorder_out_by),
        .out_delta(reorder_out_delta), .out_mx(reorder_out_mx), .out_my(reorder_out_my),
        .out_shift(reorder_out_shift), .out_depth(reorder_out_depth), .out_depth_low(reorder_out_depth_low),
        .out_depth_high(reorder_out_depth_high), .out_attribute_0(reorder_out_attribute_0),
        .out_attribute_1(reorder_out_attribute_1), .out_attribute_2(reorder_out_attribute_2),
        .out_left(reorder_out_left), .out_right(reorder_out_right), .out_top(reorder_out_top),
        .out_bottom(reorder_out_bottom), .out_tile(reorder_out_tile)
    );

    splat_tile_cache tile_cache (
        .clk(clk), .rst(rst),
        .in_valid(reorder_out_valid), .in_ready(tile_cache_in_ready), .in_end(reorder_out_end),
        .in_center_x(reorder_out_center_x), .in_center_y(reorder_out_center_y), .in_ax(reorder_out_ax),
        .in_bx(reorder_out_bx), .in_ay(reorder_out_ay), .in_by(reorder_out_by), .in_delta(reorder_out_delta),
        .in_mx(reorder_out_mx), .in_my(reorder_out_my), .in_shift(reorder_out_shift),
        .in_depth(reorder_out_depth), .in_depth_low(reorder_out_depth_low),
        .in_depth_high(reorder_out_depth_high), .in_attribute_0(reorder_out_attribute_0),
        .in_attribute_1(reorder_out_attribute_1), .in_attribute_2(reorder_out_attribute_2),
        .in_left(reorder_out_left), .in_right(reorder_out_right), .in_top(reorder_out_top),
        .in_bottom(reorder_out_bottom), .in_tile(reorder_out_tile),
        .out_valid(tile_cache_out_valid), .out_ready(rasterizer_in_ready), .out_end(tile_cache_out_end),
        .out_center_x(tile_cache_out_center_x), .out_center_y(tile_cache_out_center_y),
        .out_ax(tile_cache_out_ax), .out_bx(tile_cache_out_bx), .out_ay(tile_cache_out_ay),
        .out_by(tile_cache_out_by), .out_delta(tile_cache_out_delta), .out_mx(tile_cache_out_mx),
        .out_my(tile_cache_out_my), .out_shift(tile_cache_out_shift), .out_depth(tile_cache_out_depth),
        .out_depth_low(tile_cache_out_depth_low), .out_depth_high(tile_cache_out_depth_high),
        .out_attribute_0(tile_cache_out_attribute_0), .out_attribute_1(tile_cache_out_attribute_1),
        .out_attribute_2(tile_cache_out_attribute_2), .out_left(tile_cache_out_left),
        .out_right(tile_cache_out_right), .out_top(tile_cache_out_top), .out_bottom(tile_cache_out_bottom),
        .out_tile(tile_cache_out_tile), .out_slot(tile_cache_out_slot),
        .read_valid(tile_cache_read_valid), .read_ready(read_ready), .read_tile(tile_cache_read_tile),
        .data_valid(data_valid), .data_ready(tile_cache_data_ready), .data_weight(data_weight),
        .data_depth(data_depth), .data_attribute_0(data_attribute_0), .data_attribute_1(data_attribute_1),
        .data_attribute_2(data_attribute_2),
        .write_valid(tile_cache_write_valid), .write_ready(write_ready), .write_tile(tile_cache_write_tile),
        .write_pixel(tile_cache_write_pixel), .write_weight(tile_cache_write_weight),
        .write_depth(tile_cache_write_depth), .write_attribute_0(tile_cache_write_attribute_0),
        .write_attribute_1(tile_cache_write_attribute_1), .write_attribute_2(tile_cache_write_attribute_2),
        .pixel_valid(tile_cache_pixel_valid), .pixel_ready(normalizer_in_ready),
        .pixel_end(tile_cache_pixel_end), .pixel_tile(tile_cache_pixel_tile),
        .pixel_pixel(tile_cache_pixel_pixel), .pixel_weight(tile_cache_pixel_weight),
        .pixel_depth(tile_cache_pixel_depth), .pixel_attribute_0(tile_cache_pixel_attribute_0),
        .pixel_attribute_1(tile_cache_pixel_attribute_1), .pixel_attribute_2(tile_cache_pixel_attribute_2),
        .slot_ready(tile_cache_slot_ready),
        .retire_valid(accumulator_retire_valid), .retire_slot(accumulator_retire_slot),
        .frame_end(accumulator_frame_end),
        .fill_valid(tile_cache_fill_valid), .fill_slot(tile_cache_fill_slot),
        .fill_pixel(tile_cache_fill_pixel), .fill_weight(tile_cache_fill_weight),
        .fill_depth(tile_cache_fill_depth), .fill_attribute_0(tile_cache_fill_attribute_0),
        .fill_attribute_1(tile_cache_fill_attribute_1), .fill_attribute_2(tile_cache_fill_attribute_2),
        .drain_enable(tile_cache_drain_enable), .drain_slot(tile_cache_drain_slot),
        .drain_pixel(tile_cache_drain_pixel), .drain_weight(accumulator_drain_weight),
        .drain_depth(accumulator_drain_depth), .drain_attribute_0(accumulator_drain_attribute_0),
        .drain_attribute_1(accumulator_drain_attribute_1), .drain_attribute_2(accumulator_drain_attribute_2)
    );

    splat_rasterizer rasterizer (
        .clk(clk), .rst(rst),
        .in_valid(tile_cache_out_valid), .in_ready(rasterizer_in_ready), .in_end(tile_cache_out_end),
        .in_center_x(tile_cache_out_center_x), .in_center_y(tile_cache_out_center_y),
        .in_ax(tile_cache_out_ax), .in_bx(tile_cache_out_bx), .in_ay(tile_cache_out_ay),
        .in_by(tile_cache_out_by), .in_delta(tile_cache_out_delta), .in_mx(tile_cache_out_mx),
        .in_my(tile_cache_out_my), .in_shift(tile_cache_out_shift), .in_depth(tile_cache_out_depth),
        .in_depth_low(tile_cache_out_depth_low), .in_depth_high(tile_cache_out_depth_high),
        .in_attribute_0(tile_cache_out_attribute_0), .in_attribute_1(tile_cache_out_attribute_1),
        .in_attribute_2(tile_cache_out_attribute_2), .in_left(tile_cache_out_left),
        .in_right(tile_cache_out_right), .in_top(tile_cache_out_top), .in_bottom(tile_cache_out_bottom),
        .in_tile(tile_cache_out_tile), .in_slot(tile_cache_out_slot),
        .out_valid(rasterizer_out_valid), .out_ready(weighting_in_ready), .out_end(rasterizer_out_end),
        .out_last(rasterizer_out_last), .out_inside(rasterizer_out_inside), .out_slot(rasterizer_out_slot),
        .out_pixel(rasterizer_out_pixel), .out_weight(rasterizer_out_weight),
        .out_depth(rasterizer_out_depth), .out_depth_low(rasterizer_out_depth_low),
        .out_depth_high(rasterizer_out_depth_high), .out_attribute_0(rasterizer_out_attribute_0),
        .out_attribute_1(rasterizer_out_attribute_1), .out_attribute_2(rasterizer_out_attribute_2),
        .filter_scale(uniform_filter_scale),
        .event_sample(rasterizer_event_sample), .event_starved(rasterizer_event_starved),
        .event_blocked(rasterizer_event_blocked)
    );

    splat_weighting weighting (
        .clk(clk), .rst(rst),
        .in_valid(rasterizer_out_valid), .in_ready(weighting_in_ready), .in_end(rasterizer_out_end),
        .in_last(rasterizer_out_last), .in_inside(rasterizer_out_inside), .in_slot(rasterizer_out_slot),
        .in_pixel(rasterizer_out_pixel), .in_weight(rasterizer_out_weight), .in_depth(rasterizer_out_depth),
        .in_depth_low(rasterizer_out_depth_low), .in_depth_high(rasterizer_out_depth_high),
        .in_attribute_0(rasterizer_out_attribute_0), .in_attribute_1(rasterizer_out_attribute_1),
        .in_attribute_2(rasterizer_out_attribute_2),
        .out_valid(weighting_out_valid), .out_ready(accumulator_in_ready), .out_end(weighting_out_end),
        .out_last(weighting_out_last), .out_inside(weighting_out_inside), .out_slot(weighting_out_slot),
        .out_pixel(weighting_out_pixel), .out_weight(weighting_out_weight),
        .out_weighted_depth(weighting_out_weighted_depth), .out_depth_low(weighting_out_depth_low),
        .out_depth_high(weighting_out_depth_high), .out_attribute_0(weighting_out_attribute_0),
        .out_attribute_1(weighting_out_attribute_1), .out_attribute_2(weighting_out_attribute_2)
    );

    splat_accumulator accumulator (
        .clk(clk), .rst(rst),
        .in_valid(weighting_out_valid), .in_ready(accumulator_in_ready), .in_end(weighting_out_end),
        .in_last(weighting_out_last), .in_inside(weighting_out_inside), .in_slot(weighting_out_slot),
        .in_pixel(weighting_out_pixel), .in_weight(weighting_out_weight),
        .in_weighted_depth(weighting_out_weighted_depth), .in_depth_low(weighting_out_depth_low),
        .in_depth_high(weighting_out_depth_high), .in_attribute_0(weighting_out_attribute_0),
        .in_attribute_1(weighting_out_attribute_1), .in_attribute_2(weighting_out_attribute_2),
        .slot_ready(tile_cache_slot_ready),
        .retire_valid(accumulator_retire_valid), .retire_slot(accumulator_retire_slot),
        .frame_end(accumulator_frame_end),
        .fill_valid(tile_cache_fill_valid), .fill_slot(tile_cache_fill_slot),
        .fill_pixel(tile_cache_fill_pixel), .fill_weight(tile_cache_fill_weight),
        .fill_depth(tile_cache_fill_depth), .fill_attribute_0(tile_cache_fill_attribute_0),
        .fill_attribute_1(tile_cache_fill_attribute_1), .fill_attribute_2(tile_cache_fill_attribute_2),
        .drain_enable(tile_cache_drain_enable), .drain_slot(tile_cache_drain_slot),
        .drain_pixel(tile_cache_drain_pixel), .drain_weight(accumulator_drain_weight),
        .drain_depth(accumulator_drain_depth), .drain_attribute_0(accumulator_drain_attribute_0),
        .drain_attribute_1(accumulator_drain_attribute_1), .drain_attribute_2(accumulator_drain_attribute_2),
        .event_accumulate(accumulator_event_accumulate), .event_hazard(accumulator_event_hazard),
        .event_slot_wait(accumulator_event_slot_wait)
    );

    splat_normalizer normalizer (
        .clk(clk), .rst(rst),
        .in_valid(tile_cache_pixel_valid), .in_ready(normalizer_in_ready), .in_end(tile_cache_pixel_end),
        .in_tile(tile_cache_pixel_tile), .in_pixel(tile_cache_pixel_pixel),
        .in_weight(tile_cache_pixel_weight), .in_depth(tile_cache_pixel_depth),
        .in_attribute_0(tile_cache_pixel_attribute_0), .in_attribute_1(tile_cache_pixel_attribute_1),
        .in_attribute_2(tile_cache_pixel_attribute_2),
        .out_valid(normalizer_out_valid), .out_ready(fragment_ready), .out_end(normalizer_out_end),
        .out_column(normalizer_out_column), .out_row(normalizer_out_row), .out_depth(normalizer_out_depth),
        .out_attribute_0(normalizer_out_attribute_0), .out_attribute_1(normalizer_out_attribute_1),
        .out_attribute_2(normalizer_out_attribute_2)
    );

    always @(posedge clk) begin
        if (uniform_valid & (uniform_address == 5'd0)) uniform_m00 <= uniform_data;
        if (uniform_valid & (uniform_address == 5'd1)) uniform_m01 <= uniform_data;
        if (uniform_valid & (uniform_address == 5'd2)) uniform_m02 <= uniform_data;
        if (uniform_valid & (uniform_address == 5'd3)) uniform_m03 <= uniform_data;
        if (uniform_valid & (uniform_address == 5'd4)) uniform_m10 <= uniform_data;
        if (uniform_valid & (uniform_address == 5'd5)) uniform_m11 <= uniform_data;
        if (uniform_valid & (uniform_address == 5'd6)) uniform_m12 <= uniform_data;
        if (uniform_valid & (uniform_address == 5'd7)) uniform_m13 <= uniform_data;
        if (uniform_valid & (uniform_address == 5'd8)) uniform_m20 <= uniform_data;
        if (uniform_valid & (uniform_address == 5'd9)) uniform_m21 <= uniform_data;
        if (uniform_valid & (uniform_address == 5'd10)) uniform_m22 <= uniform_data;
        if (uniform_valid & (uniform_address == 5'd11)) uniform_m23 <= uniform_data;
        if (uniform_valid & (uniform_address == 5'd12)) uniform_scale_x <= uniform_data;
        if (uniform_valid & (uniform_address == 5'd13)) uniform_scale_y <= uniform_data;
        if (uniform_valid & (uniform_address == 5'd14)) uniform_origin_x <= uniform_data;
        if (uniform_valid & (uniform_address == 5'd15)) uniform_origin_y <= uniform_data;
        if (uniform_valid & (uniform_address == 5'd16)) uniform_depth_a <= uniform_data;
        if (uniform_valid & (uniform_address == 5'd17)) uniform_depth_b <= uniform_data;
        if (uniform_valid & (uniform_address == 5'd18)) uniform_near_plane <= uniform_data;
        if (uniform_valid & (uniform_address == 5'd19)) uniform_epsilon_scale <= uniform_data;
        if (uniform_valid & (uniform_address == 5'd20)) uniform_epsilon_bias <= uniform_data;
        if (uniform_valid & (uniform_address == 5'd21)) uniform_filter_radius <= uniform_data;
        if (uniform_valid & (uniform_address == 5'd22)) begin
            uniform_filter_scale <= uniform_data[15:0];
        end
    end
endmodule

// A finished pixel's sums divided by its weight.
// latency = 31
// initiation_interval = 1
module splat_normalizer (
    input  wire clk,
    input  wire rst,
    input  wire in_valid,
    output wire in_ready,
    input  wire in_end,
    input  wire [11:0] in_tile,
    input  wire [5:0] in_pixel,
    input  wire [27:0] in_weight,
    input  wire [51:0] in_depth,
    input  wire [39:0] in_attribute_0,
    input  wire [39:0] in_attribute_1,
    input  wire [39:0] in_attribute_2,
    output wire out_valid,
    input  wire out_ready,
    output wire out_end,
    output wire [8:0] out_column,
    output wire [8:0] out_row,
    output wire [23:0] out_depth,
    output wire [11:0] out_attribute_0,
    output wire [11:0] out_attribute_1,
    output wire [11:0] out_attribute_2
);
    (* ram_style = "distributed" *)
    reg [71:0] delay_19_from_0 [0:17];
    (* ram_style = "distributed" *)
    reg [23:0] delay_20_from_0 [0:18];
    (* ram_style = "distributed" *)
    reg [18:0] delay_31_from_0 [0:29];
    reg [4:0] delay_19_from_0_pointer;
    reg [71:0] delay_19_from_0_out;
    reg [4:0] delay_20_from_0_pointer;
    reg [23:0] delay_20_from_0_out;
    reg [4:0] delay_31_from_0_pointer;
    reg [18:0] delay_31_from_0_out;
    reg [23:0] mul_11_d1, mul_11_d2, mul_11_d3, mul_11_d4;
    reg [13:0] shr_28_d1, shr_42_d1, shr_55_d1;
    reg [30:0] in_flight;

    wire queue_in_ready, queue_out_valid;
    wire [78:0] queue_out_data;
    wire [23:0] to_float_u28q16_f24_ftz_unit_y, recip_f24_ftz_unit_y, to_float_u52q40_f24_ftz_unit_y;
    wire [23:0] mul_f24_ftz_unit_y, mul_f24_ftz_unit_copy2_y, mul_f24_ftz_unit_copy3_y, mul_f24_ftz_unit_copy4_y;
    wire [23:0] to_float_s40q27_f24_ftz_unit_y, to_float_s40q27_f24_ftz_unit_copy2_y;
    wire [23:0] to_float_s40q27_f24_ftz_unit_copy3_y;
    wire [12:0] to_fixed_f24_ftz_s13q12_unit_y, to_fixed_f24_ftz_s13q12_unit_copy2_y;
    wire [12:0] to_fixed_f24_ftz_s13q12_unit_copy3_y;

    wire [13:0] min_30 = ($signed(14'h7ff) < $signed(shr_28_d1)) ? 14'h7ff : shr_28_d1;
    wire [13:0] min_43 = ($signed(shr_42_d1) < $signed(14'h7ff)) ? shr_42_d1 : 14'h7ff;
    wire [13:0] min_56 = ($signed(shr_55_d1) < $signed(14'h7ff)) ? shr_55_d1 : 14'h7ff;
    wire not_23 = ~to_fixed_f24_ftz_s13q12_unit_y[12];
    wire [13:0] joined_1 = {to_fixed_f24_ftz_s13q12_unit_y[12], to_fixed_f24_ftz_s13q12_unit_y};
    wire [13:0] add_27 = {13'd0, not_23} + joined_1;
    wire not_37 = ~to_fixed_f24_ftz_s13q12_unit_copy2_y[12];
    wire [13:0] joined_2 = {to_fixed_f24_ftz_s13q12_unit_copy2_y[12], to_fixed_f24_ftz_s13q12_unit_copy2_y};
    wire [13:0] add_41 = {13'd0, not_37} + joined_2;
    wire not_50 = ~to_fixed_f24_ftz_s13q12_unit_copy3_y[12];
    wire [13:0] joined_3 = {to_fixed_f24_ftz_s13q12_unit_copy3_y[12], to_fixed_f24_ftz_s13q12_unit_copy3_y};
    wire [13:0] add_54 = {13'd0, not_50} + joined_3;

    assign in_ready = queue_in_ready;
    assign out_valid = queue_out_valid;
    assign {out_end, out_column, out_row, out_depth, out_attribute_0, out_attribute_1, out_attribute_2} = queue_out_data;

    stream_skid_w79 queue (
        .clk(clk), .rst(rst),
        .in_valid(in_flight[30]), .in_ready(queue_in_ready),
        .in_data({
            delay_31_from_0_out[0], delay_31_from_0_out[9:1], delay_31_from_0_out[18:10], mul_11_d4, min_30[11:0],
            min_43[11:0], min_56[11:0]
        }),
        .out_valid(queue_out_valid), .out_ready(out_ready), .out_data(queue_out_data)
    );

    float_from_fixed_s3_f24ftz_w28_f16_unsigned to_float_u28q16_f24_ftz_unit (
        .clk(clk), .enable(queue_in_ready), .a(in_weight), .y(to_float_u28q16_f24_ftz_unit_y)
    );

    float_recip_s20_f24ftz recip_f24_ftz_unit (
        .clk(clk), .enable(queue_in_ready), .a(to_float_u28q16_f24_ftz_unit_y), .y(recip_f24_ftz_unit_y)
    );

    float_from_fixed_s3_f24ftz_w52_f40_unsigned to_float_u52q40_f24_ftz_unit (
        .clk(clk), .enable(queue_in_ready), .a(in_depth), .y(to_float_u52q40_f24_ftz_unit_y)
    );

    float_mul_s4_f24ftz mul_f24_ftz_unit (
        .clk(clk), .enable(queue_in_ready), .a(recip_f24_ftz_unit_y), .b(delay_20_from_0_out),
        .y(mul_f24_ftz_unit_y)
    );

    float_mul_s4_f24ftz mul_f24_ftz_unit_copy2 (
        .clk(clk), .enable(queue_in_ready), .a(recip_f24_ftz_unit_y), .b(delay_19_from_0_out[23:0]),
        .y(mul_f24_ftz_unit_copy2_y)
    );

    float_mul_s4_f24ftz mul_f24_ftz_unit_copy3 (
        .clk(clk), .enable(queue_in_ready), .a(recip_f24_ftz_unit_y), .b(delay_19_from_0_out[47:24]),
        .y(mul_f24_ftz_unit_copy3_y)
    );

    float_mul_s4_f24ftz mul_f24_ftz_unit_copy4 (
        .clk(clk), .enable(queue_in_ready), .a(recip_f24_ftz_unit_y), .b(delay_19_from_0_out[71:48]),
        .y(mul_f24_ftz_unit_copy4_y)
    );

    float_from_fixed_s4_f24ftz_w40_f27_signed to_float_s40q27_f24_ftz_unit (
        .clk(clk), .enable(queue_in_ready), .a(in_attribute_0), .y(to_float_s40q27_f24_ftz_unit_y)
    );

    float_from_fixed_s4_f24ftz_w40_f27_signed to_float_s40q27_f24_ftz_unit_copy2 (
        .clk(clk), .enable(queue_in_ready), .a(in_attribute_1), .y(to_float_s40q27_f24_ftz_unit_copy2_y)
    );

    float_from_fixed_s4_f24ftz_w40_f27_signed to_float_s40q27_f24_ftz_unit_copy3 (
        .clk(clk), .enable(queue_in_ready), .a(in_attribute_2), .y(to_float_s40q27_f24_ftz_unit_copy3_y)
    );

    float_to_fixed_s3_f24ftz_w13_f12_signed to_fixed_f24_ftz_s13q12_unit (
        .clk(clk), .enable(queue_in_ready), .a(mul_f24_ftz_unit_copy2_y), .y(to_fixed_f24_ftz_s13q12_unit_y)
    );

    float_to_fixed_s3_f24ftz_w13_f12_signed to_fixed_f24_ftz_s13q12_unit_copy2 (
        .clk(clk), .enable(queue_in_ready), .a(mul_f24_ftz_unit_copy3_y),
        .y(to_fixed_f24_ftz_s13q12_unit_copy2_y)
    );

    float_to_fixed_s3_f24ftz_w13_f12_signed to_fixed_f24_ftz_s13q12_unit_copy3 (
        .clk(clk), .enable(queue_in_ready), .a(mul_f24_ftz_unit_copy4_y),
        .y(to_fixed_f24_ftz_s13q12_unit_copy3_y)
    );

    always @(posedge clk) begin
        if (rst) begin
            delay_19_from_0_pointer <= 5'd0;
            delay_20_from_0_pointer <= 5'd0;
            delay_31_from_0_pointer <= 5'd0;
            in_flight <= 31'd0;
        end else if (queue_in_ready) begin
            delay_19_from_0_pointer <= (delay_19_from_0_pointer == 5'd17) ? (delay_19_from_0_pointer - 5'd17) : (delay_19_from_0_pointer + 5'd1);
            delay_20_from_0_pointer <= (delay_20_from_0_pointer == 5'd18) ? (delay_20_from_0_pointer - 5'd18) : (delay_20_from_0_pointer + 5'd1);
            delay_31_from_0_pointer <= (delay_31_from_0_pointer == 5'd29) ? (delay_31_from_0_pointer - 5'd29) : (delay_31_from_0_pointer + 5'd1);
            in_flight <= {in_flight[29:0], in_valid};
        end
    end
    always @(posedge clk) begin
        if (queue_in_ready) begin
            mul_11_d1 <= mul_f24_ftz_unit_y;
            mul_11_d2 <= mul_11_d1;
            mul_11_d3 <= mul_11_d2;
            mul_11_d4 <= mul_11_d3;
            shr_28_d1 <= {add_27[13], add_27[13:1]};
            shr_42_d1 <= {add_41[13], add_41[13:1]};
            shr_55_d1 <= {add_54[13], add_54[13:1]};
        end
    end
    always @(posedge clk) begin
        if (queue_in_ready) begin
            delay_19_from_0[delay_19_from_0_pointer] <= {
                to_float_s40q27_f24_ftz_unit_copy3_y, to_float_s40q27_f24_ftz_unit_copy2_y,
                to_float_s40q27_f24_ftz_unit_y
            };
        end
        if (queue_in_ready) delay_19_from_0_out <= delay_19_from_0[delay_19_from_0_pointer];
    end
    always @(posedge clk) begin
        if (queue_in_ready) begin
            delay_20_from_0[delay_20_from_0_pointer] <= to_float_u52q40_f24_ftz_unit_y;
        end
        if (queue_in_ready) delay_20_from_0_out <= delay_20_from_0[delay_20_from_0_pointer];
    end
    always @(posedge clk) begin
        if (queue_in_ready) begin
            delay_31_from_0[delay_31_from_0_pointer] <= {in_tile[11:6], in_pixel[5:3], in_tile[5:0], in_pixel[2:0], in_end};
        end
        if (queue_in_ready) delay_31_from_0_out <= delay_31_from_0[delay_31_from_0_pointer];
    end

    wire _unused = &{1'b0, add_27[0], add_41[0], add_54[0], min_30[13:12], min_43[13:12], min_56[13:12]};
endmodule

// Floating to fixed point.
// stages = 3
// format = f24-ftz
// width = 13
// fraction = 12
// integer = signed
module float_to_fixed_s3_f24ftz_w13_f12_signed (
    input  wire clk,
    input  wire enable,
    input  wire [23:0] a,
    output reg  [12:0] y
);
    reg [3:0] distance_s1;
    reg [15:0] significand_s1;
    reg [12:0] magnitude_s2;
    reg sign_s1, sign_s2, nan_s1, nan_s2, vanishes_s1, vanishes_s2, saturates_s1, saturates_s2;

    wire [7:0] a_field = a[22:15];
    wire [10:0] sum_1 = {3'd0, a_field} + 11'h78e;
    wire [10:0] difference_2 = 11'd16 - sum_1;
    wire [14:0] a_fraction = a[14:0];
    wire [15:0] shifted_3 = significand_s1 >> distance_s1;
    wire term_4 = sum_1[10] | (sum_1 == 11'd0);
    wire term_5 = &a_field & (a_fraction == 15'd0);
    wire [12:0] choice_6 = saturates_s2 ? (sign_s2 ? 13'h1000 : 13'hfff) : sign_s2 ? (~magnitude_s2 + 13'd1) : magnitude_s2;

    always @(posedge clk) begin
        if (enable) begin
            distance_s1 <= difference_2[3:0];
            significand_s1 <= {|a_field, a_fraction & {15{|a_field}}};
            magnitude_s2 <= shifted_3[12:0];
            sign_s1 <= a[23];
            sign_s2 <= sign_s1;
            nan_s1 <= &a_field & |a_fraction;
            nan_s2 <= nan_s1;
            vanishes_s1 <= (term_4 & ~term_5) | ~(|a_field);
            vanishes_s2 <= vanishes_s1;
            saturates_s1 <= (~term_4 & (11'd13 <= sum_1) & |a_field) | term_5;
            saturates_s2 <= saturates_s1;
            y <= (vanishes_s2 | nan_s2) ? 13'd0 : choice_6;
        end
    end

    wire _unused = &{1'b0, difference_2[10:4], shifted_3[15:13]};
endmodule

// Fixed to floating point.
// stages = 4
// format = f24-ftz
// width = 40
// fraction = 27
// integer = signed
module float_from_fixed_s4_f24ftz_w40_f27_signed (
    input  wire clk,
    input  wire enable,
    input  wire [39:0] a,
    output reg  [23:0] y
);
    reg [39:0] magnitude_s1, magnitude_s2;
    reg [5:0] zeros_s2;
    reg [8:0] exponent_s3;
    reg [17:0] significand_s3;
    reg sign_s1, sign_s2, sign_s3, zero_s1, zero_s2, zero_s3;

    wire [39:0] choice_1 = a[39] ? (~a + 40'd1) : a;
    wire term_2 = ~magnitude_s1[39] & ~magnitude_s1[38];
    wire term_3 = term_2 & (~magnitude_s1[37] & ~magnitude_s1[36]);
    wire term_4 = ~magnitude_s1[35] & ~magnitude_s1[34];
    wire term_5 = term_3 & (term_4 & (~magnitude_s1[33] & ~magnitude_s1[32]));
    wire term_6 = ~magnitude_s1[31] & ~magnitude_s1[30];
    wire term_7 = term_6 & (~magnitude_s1[29] & ~magnitude_s1[28]);
    wire term_8 = ~magnitude_s1[27] & ~magnitude_s1[26];
    wire term_9 = term_7 & (term_8 & (~magnitude_s1[25] & ~magnitude_s1[24]));
    wire term_10 = term_5 & term_9;
    wire term_11 = ~magnitude_s1[23] & ~magnitude_s1[22];
    wire term_12 = term_11 & (~magnitude_s1[21] & ~magnitude_s1[20]);
    wire term_13 = ~magnitude_s1[19] & ~magnitude_s1[18];
    wire term_14 = term_12 & (term_13 & (~magnitude_s1[17] & ~magnitude_s1[16]));
    wire term_15 = ~magnitude_s1[15] & ~magnitude_s1[14];
    wire term_16 = term_15 & (~magnitude_s1[13] & ~magnitude_s1[12]);
    wire term_17 = ~magnitude_s1[11] & ~magnitude_s1[10];
    wire term_18 = term_16 & (term_17 & (~magnitude_s1[9] & ~magnitude_s1[8]));
    wire term_19 = term_10 & (term_14 & term_18);
    wire term_20 = ~magnitude_s1[7] & ~magnitude_s1[6];
    wire term_21 = term_20 & (~magnitude_s1[5] & ~magnitude_s1[4]);
    wire term_22 = ~magnitude_s1[3] & ~magnitude_s1[2];
    wire term_23 = term_21 & (term_22 & (~magnitude_s1[1] & ~magnitude_s1[0]));
    wire [1:0] choice_24 = term_21 ? {term_22, term_22 ? ~magnitude_s1[1] : ~magnitude_s1[3]} : {term_20, term_20 ? ~magnitude_s1[5] : ~magnitude_s1[7]};
    wire [1:0] joined_25 = {term_17, term_17 ? ~magnitude_s1[9] : ~magnitude_s1[11]};
    wire [1:0] joined_26 = {term_15, term_15 ? ~magnitude_s1[13] : ~magnitude_s1[15]};
    wire [1:0] joined_27 = {term_13, term_13 ? ~magnitude_s1[17] : ~magnitude_s1[19]};
    wire [1:0] joined_28 = {term_11, term_11 ? ~magnitude_s1[21] : ~magnitude_s1[23]};
    wire [2:0] choice_29 = term_14 ? {term_16, term_16 ? joined_25 : joined_26} : {term_12, term_12 ? joined_27 : joined_28};
    wire [1:0] choice_30 = term_7 ? {term_8, term_8 ? ~magnitude_s1[25] : ~magnitude_s1[27]} : {term_6, term_6 ? ~magnitude_s1[29] : ~magnitude_s1[31]};
    wire [1:0] choice_31 = term_3 ? {term_4, term_4 ? ~magnitude_s1[33] : ~magnitude_s1[35]} : {term_2, term_2 ? ~magnitude_s1[37] : ~magnitude_s1[39]};
    wire [3:0] joined_32 = {term_5, term_5 ? {term_7, choice_30} : {term_3, choice_31}};
    wire [4:0] choice_33 = term_19 ? {1'd0, term_23, term_23 ? 3'd0 : {term_21, choice_24}} : {term_10, term_10 ? {term_14, choice_29} : joined_32};
    wire [39:0] shifted_34 = magnitude_s2 << zeros_s2;
    wire term_35 = (exponent_s3 == 9'd0) & ~(&significand_s3[16:2] & significand_s3[1]);
    wire round_up = significand_s3[1] & (significand_s3[0] | significand_s3[2]);
    wire [22:0] rounded = {exponent_s3[7:0], significand_s3[16:2]} + {22'd0, round_up};
    wire [22:0] choice_36 = (~exponent_s3[8] & (9'd255 <= exponent_s3)) ? 23'h7f8000 : rounded;
    wire [22:0] choice_37 = (zero_s3 | (exponent_s3[8] | term_35)) ? 23'd0 : choice_36;

    always @(posedge clk) begin
        if (enable) begin
            magnitude_s1 <= choice_1;
            magnitude_s2 <= magnitude_s1;
            zeros_s2 <= {term_19, choice_33};
            exponent_s3 <= 9'd139 - {3'd0, zeros_s2};
            significand_s3 <= {shifted_34[39:23], |shifted_34[22:0]};
            sign_s1 <= a[39];
            sign_s2 <= sign_s1;
            sign_s3 <= sign_s2;
            zero_s1 <= choice_1 == 40'd0;
            zero_s2 <= zero_s1;
            zero_s3 <= zero_s2;
            y <= {sign_s3, choice_37};
        end
    end

    wire _unused = &{1'b0, significand_s3[17]};
endmodule

// Fixed to floating point.
// stages = 3
// format = f24-ftz
// width = 52
// fraction = 40
// integer = unsigned
module float_from_fixed_s3_f24ftz_w52_f40_unsigned (
    input  wire clk,
    input  wire enable,
    input  wire [51:0] a,
    output reg  [23:0] y
);
    reg [51:0] magnitude_s1;
    reg [5:0] zeros_s1;
    reg [8:0] exponent_s2;
    reg [17:0] significand_s2;
    reg zero_s1, zero_s2;

    wire term_1 = ~a[51] & ~a[50];
    wire term_2 = term_1 & (~a[49] & ~a[48]);
    wire term_3 = ~a[47] & ~a[46];
    wire term_4 = term_2 & (term_3 & (~a[45] & ~a[44]));
    wire term_5 = ~a[43] & ~a[42];
    wire term_6 = term_5 & (~a[41] & ~a[40]);
    wire term_7 = ~a[39] & ~a[38];
    wire term_8 = term_4 & (term_6 & (term_7 & (~a[37] & ~a[36])));
    wire term_9 = ~a[35] & ~a[34];
    wire term_10 = term_9 & (~a[33] & ~a[32]);
    wire term_11 = ~a[31] & ~a[30];
    wire term_12 = term_10 & (term_11 & (~a[29] & ~a[28]));
    wire term_13 = ~a[27] & ~a[26];
    wire term_14 = term_13 & (~a[25] & ~a[24]);
    wire term_15 = ~a[23] & ~a[22];
    wire term_16 = term_8 & (term_12 & (term_14 & (term_15 & (~a[21] & ~a[20]))));
    wire term_17 = ~a[19] & ~a[18];
    wire term_18 = term_17 & (~a[17] & ~a[16]);
    wire term_19 = ~a[15] & ~a[14];
    wire term_20 = term_18 & (term_19 & (~a[13] & ~a[12]));
    wire term_21 = ~a[11] & ~a[10];
    wire term_22 = term_21 & (~a[9] & ~a[8]);
    wire term_23 = ~a[7] & ~a[6];
    wire term_24 = term_20 & (term_22 & (term_23 & (~a[5] & ~a[4])));
    wire term_25 = ~a[3] & ~a[2];
    wire term_26 = term_25 & (~a[1] & ~a[0]);
    wire [3:0] joined_27 = {1'd0, term_26, term_26 ? 2'd0 : {term_25, term_25 ? ~a[1] : ~a[3]}};
    wire [1:0] choice_28 = term_22 ? {term_23, term_23 ? ~a[5] : ~a[7]} : {term_21, term_21 ? ~a[9] : ~a[11]};
    wire [1:0] choice_29 = term_18 ? {term_19, term_19 ? ~a[13] : ~a[15]} : {term_17, term_17 ? ~a[17] : ~a[19]};
    wire [3:0] joined_30 = {term_20, term_20 ? {term_22, choice_28} : {term_18, choice_29}};
    wire [1:0] choice_31 = term_14 ? {term_15, term_15 ? ~a[21] : ~a[23]} : {term_13, term_13 ? ~a[25] : ~a[27]};
    wire [1:0] choice_32 = term_10 ? {term_11, term_11 ? ~a[29] : ~a[31]} : {term_9, term_9 ? ~a[33] : ~a[35]};
    wire [3:0] joined_33 = {term_12, term_12 ? {term_14, choice_31} : {term_10, choice_32}};
    wire [1:0] choice_34 = term_6 ? {term_7, term_7 ? ~a[37] : ~a[39]} : {term_5, term_5 ? ~a[41] : ~a[43]};
    wire [1:0] choice_35 = term_2 ? {term_3, term_3 ? ~a[45] : ~a[47]} : {term_1, term_1 ? ~a[49] : ~a[51]};
    wire [3:0] joined_36 = {term_4, term_4 ? {term_6, choice_34} : {term_2, choice_35}};
    wire [4:0] choice_37 = term_16 ? {term_24, term_24 ? joined_27 : joined_30} : {term_8, term_8 ? joined_33 : joined_36};
    wire [51:0] shifted_38 = magnitude_s1 << zeros_s1;
    wire term_39 = (exponent_s2 == 9'd0) & ~(&significand_s2[16:2] & significand_s2[1]);
    wire round_up = significand_s2[1] & (significand_s2[0] | significand_s2[2]);
    wire [22:0] rounded = {exponent_s2[7:0], significand_s2[16:2]} + {22'd0, round_up};
    wire [22:0] choice_40 = (~exponent_s2[8] & (9'd255 <= exponent_s2)) ? 23'h7f8000 : rounded;
    wire [22:0] choice_41 = (zero_s2 | (exponent_s2[8] | term_39)) ? 23'd0 : choice_40;

    always @(posedge clk) begin
        if (enable) begin
            magnitude_s1 <= a;
            zeros_s1 <= {term_16, choice_37};
            exponent_s2 <= 9'd138 - {3'd0, zeros_s1};
            significand_s2 <= {shifted_38[51:35], |shifted_38[34:0]};
            zero_s1 <= a == 52'd0;
            zero_s2 <= zero_s1;
            y <= {1'd0, choice_41};
        end
    end

    wire _unused = &{1'b0, significand_s2[17]};
endmodule

// Fixed to floating point.
// stages = 3
// format = f24-ftz
// width = 28
// fraction = 16
// integer = unsigned
module float_from_fixed_s3_f24ftz_w28_f16_unsigned (
    input  wire clk,
    input  wire enable,
    input  wire [27:0] a,
    output reg  [23:0] y
);
    reg [27:0] magnitude_s1;
    reg [4:0] zeros_s1;
    reg [8:0] exponent_s2;
    reg [17:0] significand_s2;
    reg zero_s1, zero_s2;

    wire term_1 = ~a[27] & ~a[26];
    wire term_2 = term_1 & (~a[25] & ~a[24]);
    wire term_3 = ~a[23] & ~a[22];
    wire term_4 = term_2 & (term_3 & (~a[21] & ~a[20]));
    wire term_5 = ~a[19] & ~a[18];
    wire term_6 = term_5 & (~a[17] & ~a[16]);
    wire term_7 = ~a[15] & ~a[14];
    wire term_8 = term_4 & (term_6 & (term_7 & (~a[13] & ~a[12])));
    wire term_9 = ~a[11] & ~a[10];
    wire term_10 = term_9 & (~a[9] & ~a[8]);
    wire term_11 = ~a[7] & ~a[6];
    wire term_12 = term_10 & (term_11 & (~a[5] & ~a[4]));
    wire term_13 = ~a[3] & ~a[2];
    wire term_14 = term_13 & (~a[1] & ~a[0]);
    wire [2:0] joined_15 = {term_14, term_14 ? 2'd0 : {term_13, term_13 ? ~a[1] : ~a[3]}};
    wire [1:0] choice_16 = term_10 ? {term_11, term_11 ? ~a[5] : ~a[7]} : {term_9, term_9 ? ~a[9] : ~a[11]};
    wire [1:0] choice_17 = term_6 ? {term_7, term_7 ? ~a[13] : ~a[15]} : {term_5, term_5 ? ~a[17] : ~a[19]};
    wire [1:0] choice_18 = term_2 ? {term_3, term_3 ? ~a[21] : ~a[23]} : {term_1, term_1 ? ~a[25] : ~a[27]};
    wire [3:0] joined_19 = {term_4, term_4 ? {term_6, choice_17} : {term_2, choice_18}};
    wire [3:0] choice_20 = term_8 ? {term_12, term_12 ? joined_15 : {term_10, choice_16}} : joined_19;
    wire [27:0] shifted_21 = magnitude_s1 << zeros_s1;
    wire term_22 = (exponent_s2 == 9'd0) & ~(&significand_s2[16:2] & significand_s2[1]);
    wire round_up = significand_s2[1] & (significand_s2[0] | significand_s2[2]);
    wire [22:0] rounded = {exponent_s2[7:0], significand_s2[16:2]} + {22'd0, round_up};
    wire [22:0] choice_23 = (~exponent_s2[8] & (9'd255 <= exponent_s2)) ? 23'h7f8000 : rounded;
    wire [22:0] choice_24 = (zero_s2 | (exponent_s2[8] | term_22)) ? 23'd0 : choice_23;

    always @(posedge clk) begin
        if (enable) begin
            magnitude_s1 <= a;
            zeros_s1 <= {term_8, choice_20};
            exponent_s2 <= 9'd138 - {4'd0, zeros_s1};
            significand_s2 <= {shifted_21[27:11], |shifted_21[10:0]};
            zero_s1 <= a == 28'd0;
            zero_s2 <= zero_s1;
            y <= {1'd0, choice_24};
        end
    end

    wire _unused = &{1'b0, significand_s2[17]};
endmodule

// Queue of two in registers.
// width = 79
module stream_skid_w79 (
    input  wire clk,
    input  wire rst,
    input  wire in_valid,
    output wire in_ready,
    input  wire [78:0] in_data,
    output reg  out_valid,
    input  wire out_ready,
    output wire [78:0] out_data
);
    reg second_valid;
    reg [78:0] head, second;

    assign in_ready = ~second_valid;
    wire advance = ~out_valid | out_ready;
    wire some_item = second_valid | in_valid;

    assign out_data = head;

    always @(posedge clk) begin
        if (rst) begin
            out_valid <= 1'd0;
            second_valid <= 1'd0;
        end else begin
            if (advance) out_valid <= some_item;
            second_valid <= ~advance & some_item;
        end
    end
    always @(posedge clk) begin
        if (advance) head <= second_valid ? second : in_data;
        if (in_ready) second <= in_data;
    end

`ifdef RTL_ASSERT
    always @(posedge clk) begin
        if (!rst) begin
            if (!(out_valid | in_ready)) begin
`ifdef FORMAL
                second_waits_behind_head: assert (0);
`else
                $display("assertion failed: second_waits_behind_head in %m");
                $stop;
`endif
            end
        end
    end
`endif
endmodule

// Blends samples into the pixels of the tile slots.
// slots = 2
// stages = 7
module splat_accumulator (
    input  wire clk,
    input  wire rst,
    input  wire in_valid,  // Samples with their contributions.
    output wire in_ready,
    input  wire in_end,  // Closes the frame.
    input  wire in_last,  // Closes its copy.
    input  wire in_inside,  // Lies inside the splat; one outside is passed on only to say so.
    input  wire in_slot,  // Slot of the tile cache.
    input  wire [5:0] in_pixel,  // Pixel of the tile: row above column.
    input  wire [15:0] in_weight,  // Kernel weight.
    input  wire [39:0] in_weighted_depth,  // Weighted depth.
    input  wire [23:0] in_depth_low,  // Near end of the depth band.
    input  wire [23:0] in_depth_high,  // Far end of the depth band.
    input  wire [27:0] in_attribute_0,  // Weighted continuous attributes, and cardinal ones as they are.
    input  wire [27:0] in_attribute_1,  // Weighted continuous attributes, and cardinal ones as they are.
    input  wire [27:0] in_attribute_2,  // Weighted continuous attributes, and cardinal ones as they are.
    input  wire [1:0] slot_ready,  // A bit for each slot that may be accumulated into.
    output reg  retire_valid,  // A copy is done with.
    output reg  retire_slot,  // Slot of the tile cache.
    output reg  frame_end,  // The frame is done with.
    input  wire fill_valid,  // Write to a slot.
    input  wire fill_slot,  // Slot of the tile cache.
    input  wire [5:0] fill_pixel,  // Pixel of the tile.
    input  wire [27:0] fill_weight,  // Sum of weights.
    input  wire [51:0] fill_depth,  // Sum of weighted depths.
    input  wire [39:0] fill_attribute_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [39:0] fill_attribute_1,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [39:0] fill_attribute_2,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire drain_enable,  // Read of a slot.
    input  wire drain_slot,  // Slot of the tile cache.
    input  wire [5:0] drain_pixel,  // Pixel of the tile.
    output wire [27:0] drain_weight,  // Sum of weights.
    output wire [51:0] drain_depth,  // Sum of weighted depths.
    output wire [39:0] drain_attribute_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [39:0] drain_attribute_1,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [39:0] drain_attribute_2,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output reg  event_accumulate,  // The accumulator took a sample.
    output reg  event_hazard,  // The accumulator waited for an earlier sample of the same pixel.
    output reg  event_slot_wait  // The accumulator waited for its tile to arrive in the cache.
);
    reg valid_1, inside_1, last_1, slot_1;
    reg [5:0] pixel_1;
    reg valid_2, inside_2, last_2, slot_2;
    reg [5:0] pixel_2;
    reg valid_3, inside_3, last_3, slot_3;
    reg [5:0] pixel_3;
    reg valid_4, inside_4, last_4, slot_4;
    reg [5:0] pixel_4;
    reg valid_5, inside_5, last_5, slot_5;
    reg [5:0] pixel_5;
    reg valid_6, inside_6, last_6, slot_6;
    reg [5:0] pixel_6;
    reg valid_7, inside_7, last_7, slot_7;
    reg [5:0] pixel_7;
    reg valid_8, inside_8, last_8, slot_8;
    reg [5:0] pixel_8;
    reg head_valid, head_end, head_last, head_inside, head_slot;
    reg [5:0] head_pixel;
    reg [15:0] head_weight;
    reg [39:0] head_weighted_depth;
    reg [23:0] head_depth_low, head_depth_high;
    reg [27:0] head_attribute_0, head_attribute_1, head_attribute_2;
    reg [7:0] collisions;
    reg arrived;
    wire [199:0] slot_0_read;
    reg [199:0] slot_0_pixel;
    wire [199:0] slot_1_read;
    reg [199:0] slot_1_pixel, stored;
    reg drained_slot;
    reg [15:0] sample_1_weight;
    reg [39:0] sample_1_weighted_depth;
    reg [23:0] sample_1_depth_low, sample_1_depth_high;
    reg [27:0] sample_1_attribute_0, sample_1_attribute_1, sample_1_attribute_2;
    reg [15:0] sample_2_weight;
    reg [39:0] sample_2_weighted_depth;
    reg [23:0] sample_2_depth_low, sample_2_depth_high;
    reg [27:0] sample_2_attribute_0, sample_2_attribute_1, sample_2_attribute_2;
    reg [15:0] sample_3_weight;
    reg [39:0] sample_3_weighted_depth;
    reg [23:0] sample_3_depth_low, sample_3_depth_high;
    reg [27:0] sample_3_attribute_0, sample_3_attribute_1, sample_3_attribute_2;
    reg late_fail_4, late_fail_5, late_pass_4, late_pass_5;
    reg [28:0] weight_sum_4, weight_sum_5, weight_sum_6, weight_sum_7, weight_sum_8;
    reg [15:0] weight_4, weight_5, weight_6, weight_7, weight_8;
    reg [51:0] depth_sum_4, depth_sum_5, depth_sum_6, depth_sum_7, depth_sum_8;
    reg [39:0] depth_4, depth_5, depth_6, depth_7, depth_8;
    reg [27:0] attribute_0_4, attribute_0_5, attribute_0_6, attribute_0_7, attribute_0_8;
    reg [39:0] sum_of_attribute_0_4, sum_of_attribute_0_5, sum_of_attribute_0_6, sum_of_attribute_0_7;
    reg [39:0] sum_of_attribute_0_8;
    reg [27:0] attribute_1_4, attribute_1_5, attribute_1_6, attribute_1_7, attribute_1_8;
    reg [39:0] sum_of_attribute_1_4, sum_of_attribute_1_5, sum_of_attribute_1_6, sum_of_attribute_1_7;
    reg [39:0] sum_of_attribute_1_8;
    reg [27:0] attribute_2_4, attribute_2_5, attribute_2_6, attribute_2_7, attribute_2_8;
    reg [39:0] sum_of_attribute_2_4, sum_of_attribute_2_5, sum_of_attribute_2_6, sum_of_attribute_2_7;
    reg [39:0] sum_of_attribute_2_8;

    wire places_in_ready, places_out_valid;
    wire [9:0] places_out_data;
    wire samples_in_ready, samples_out_valid;
    wire [187:0] samples_out_data;
    wire depth_test_fail, depth_test_pass;

    wire [199:0] drained = drained_slot ? slot_1_pixel : slot_0_pixel;
    wire filling_0 = fill_valid & ~fill_slot;
    wire writes = inside_8 & (~late_fail_5 & (late_pass_5 | ~weight_sum_8[28]));
    wire [199:0] joined_1 = {fill_weight, fill_depth, fill_attribute_0, fill_attribute_1, fill_attribute_2};
    wire [39:0] choice_2 = late_pass_5 ? {{12{attribute_0_8[27]}}, attribute_0_8} : sum_of_attribute_0_8;
    wire [39:0] choice_3 = late_pass_5 ? {{12{attribute_1_8[27]}}, attribute_1_8} : sum_of_attribute_1_8;
    wire [39:0] choice_4 = late_pass_5 ? {{12{attribute_2_8[27]}}, attribute_2_8} : sum_of_attribute_2_8;
    wire [199:0] result = {
        late_pass_5 ? {12'd0, weight_8} : weight_sum_8[27:0], late_pass_5 ? {12'd0, depth_8} : depth_sum_8,
        choice_2, choice_3, choice_4
    };
    wire term_5 = head_valid & ~head_end;
    wire may_issue_inside = term_5 & head_inside;
    wire on_the_way = |collisions;
    wire issue_inside = may_issue_inside & (arrived & ~on_the_way);
    wire term_6 = drain_enable & ~drain_slot;
    wire filling_1 = fill_valid & fill_slot;
    wire term_7 = drain_enable & drain_slot;
    wire slot_wait = may_issue_inside & ~arrived;
    wire hazard = may_issue_inside & (arrived & on_the_way);
    wire issue = term_5 & ~(slot_wait | hazard);
    wire term_8 = valid_1 | valid_2 | valid_3 | valid_4 | valid_5 | valid_6;
    wire issue_end = head_valid & head_end & ~(term_8 | valid_7 | valid_8);
    wire head_takes = ~head_valid | (issue | issue_end);
    wire places_out_end = places_out_data[9];
    wire places_out_last = places_out_data[8];
    wire places_out_inside = places_out_data[7];
    wire places_out_slot = places_out_data[6];
    wire [5:0] places_out_pixel = places_out_data[5:0];
    wire [15:0] samples_out_weight = samples_out_data[187:172];
    wire [39:0] samples_out_weighted_depth = samples_out_data[171:132];
    wire [23:0] samples_out_depth_low = samples_out_data[131:108];
    wire [23:0] samples_out_depth_high = samples_out_data[107:84];
    wire [27:0] samples_out_attribute_0 = samples_out_data[83:56];
    wire [27:0] samples_out_attribute_1 = samples_out_data[55:28];
    wire [27:0] samples_out_attribute_2 = samples_out_data[27:0];
    wire term_9 = head_valid & (head_inside & ~head_end) & (places_out_data[6:0] == {head_slot, head_pixel});
    wire [7:0] joined_10 = {
        inside_7 & (places_out_data[6:0] == {slot_7, pixel_7}),
        inside_6 & (places_out_data[6:0] == {slot_6, pixel_6}),
        inside_5 & (places_out_data[6:0] == {slot_5, pixel_5}),
        inside_4 & (places_out_data[6:0] == {slot_4, pixel_4}),
        inside_3 & (places_out_data[6:0] == {slot_3, pixel_3}),
        inside_2 & (places_out_data[6:0] == {slot_2, pixel_2}),
        inside_1 & (places_out_data[6:0] == {slot_1, pixel_1}), term_9
    };
    wire [1:0] shifted_11 = slot_ready >> places_out_slot;
    wire [1:0] shifted_12 = slot_ready >> head_slot;

    assign in_ready = places_in_ready;
    assign {drain_weight, drain_depth, drain_attribute_0, drain_attribute_1, drain_attribute_2} = drained;

    memory_1w1r_unordered #(.WIDTH(200), .DEPTH(64)) slot_0_pixels (
        .clk(clk),
        .write(filling_0 | (writes & ~slot_8)), .write_address(filling_0 ? fill_pixel : pixel_8),
        .write_data(filling_0 ? joined_1 : result),
        .read(slot_ready[0] ? (issue_inside & ~head_slot) : term_6),
        .read_address(slot_ready[0] ? head_pixel : drain_pixel), .read_data(slot_0_read)
    );

    memory_1w1r_unordered #(.WIDTH(200), .DEPTH(64)) slot_1_pixels (
        .clk(clk),
        .write(filling_1 | (writes & slot_8)), .write_address(filling_1 ? fill_pixel : pixel_8),
        .write_data(filling_1 ? joined_1 : result),
        .read(slot_ready[1] ? (issue_inside & head_slot) : term_7),
        .read_address(slot_ready[1] ? head_pixel : drain_pixel), .read_data(slot_1_read)
    );

    stream_fifo_d64_w10_distributed places (
        .clk(clk), .rst(rst),
        .in_valid(in_valid), .in_ready(places_in_ready),
        .in_data({in_end, in_last, in_inside, in_slot, in_pixel}),
        .out_valid(places_out_valid), .out_ready(head_takes), .out_data(places_out_data)
    );

    stream_fifo_d64_w188 samples (
        .clk(clk), .rst(rst),
        .in_valid(in_valid), .in_ready(samples_in_ready),
        .in_data({
            in_weight, in_weighted_depth, in_depth_low, in_depth_high, in_attribute_0, in_attribute_1,
            in_attribute_2
        }),
        .out_valid(samples_out_valid), .out_ready(head_takes), .out_data(samples_out_data)
    );

    splat_depth_test depth_test (
        .clk(clk), .rst(rst), .weight(stored[199:172]),
        .depth(stored[171:120]), .depth_low(sample_3_depth_low), .depth_high(sample_3_depth_high),
        .fail(depth_test_fail), .pass(depth_test_pass)
    );

    always @(posedge clk) begin
        if (rst) begin
            retire_valid <= 1'd0;
            frame_end <= 1'd0;
            valid_1 <= 1'd0;
            inside_1 <= 1'd0;
            valid_2 <= 1'd0;
            inside_2 <= 1'd0;
            valid_3 <= 1'd0;
            inside_3 <= 1'd0;
            valid_4 <= 1'd0;
            inside_4 <= 1'd0;
            valid_5 <= 1'd0;
            inside_5 <= 1'd0;
            valid_6 <= 1'd0;
            inside_6 <= 1'd0;
            valid_7 <= 1'd0;
            inside_7 <= 1'd0;
            valid_8 <= 1'd0;
            inside_8 <= 1'd0;
            head_valid <= 1'd0;
            event_accumulate <= 1'd0;
            event_hazard <= 1'd0;
            event_slot_wait <= 1'd0;
        end else begin
            retire_valid <= valid_8 & last_8;
            frame_end <= issue_end;
            valid_1 <= issue;
            inside_1 <= issue_inside;
            valid_2 <= valid_1;
            inside_2 <= inside_1;
            valid_3 <= valid_2;
            inside_3 <= inside_2;
            valid_4 <= valid_3;
            inside_4 <= inside_3;
            valid_5 <= valid_4;
            inside_5 <= inside_4;
            valid_6 <= valid_5;
            inside_6 <= inside_5;
            valid_7 <= valid_6;
            inside_7 <= inside_6;
            valid_8 <= valid_7;
            inside_8 <= inside_7;
            event_accumulate <= issue_inside;
            event_hazard <= hazard;
            event_slot_wait <= slot_wait;
            if (head_takes) head_valid <= places_out_valid;
        end
    end
    always @(posedge clk) begin
        retire_slot <= slot_8;
        last_1 <= head_last;
        slot_1 <= head_slot;
        pixel_1 <= head_pixel;
        last_2 <= last_1;
        slot_2 <= slot_1;
        pixel_2 <= pixel_1;
        last_3 <= last_2;
        slot_3 <= slot_2;
        pixel_3 <= pixel_2;
        last_4 <= last_3;
        slot_4 <= slot_3;
        pixel_4 <= pixel_3;
        last_5 <= last_4;
        slot_5 <= slot_4;
        pixel_5 <= pixel_4;
        last_6 <= last_5;
        slot_6 <= slot_5;
        pixel_6 <= pixel_5;
        last_7 <= last_6;
        slot_7 <= slot_6;
        pixel_7 <= pixel_6;
        last_8 <= last_7;
        slot_8 <= slot_7;
        pixel_8 <= pixel_7;
        collisions <= head_takes ? joined_10 : (collisions << 1);
        arrived <= head_takes ? shifted_11[0] : shifted_12[0];
        stored <= slot_2 ? slot_1_pixel : slot_0_pixel;
        sample_1_weight <= head_weight;
        sample_1_weighted_depth <= head_weighted_depth;
        sample_1_depth_low <= head_depth_low;
        sample_1_depth_high <= head_depth_high;
        sample_1_attribute_0 <= head_attribute_0;
        sample_1_attribute_1 <= head_attribute_1;
        sample_1_attribute_2 <= head_attribute_2;
        sample_2_weight <= sample_1_weight;
        sample_2_weighted_depth <= sample_1_weighted_depth;
        sample_2_depth_low <= sample_1_depth_low;
        sample_2_depth_high <= sample_1_depth_high;
        sample_2_attribute_0 <= sample_1_attribute_0;
        sample_2_attribute_1 <= sample_1_attribute_1;
        sample_2_attribute_2 <= sample_1_attribute_2;
        sample_3_weight <= sample_2_weight;
        sample_3_weighted_depth <= sample_2_weighted_depth;
        sample_3_depth_low <= sample_2_depth_low;
        sample_3_depth_high <= sample_2_depth_high;
        sample_3_attribute_0 <= sample_2_attribute_0;
        sample_3_attribute_1 <= sample_2_attribute_1;
        sample_3_attribute_2 <= sample_2_attribute_2;
        late_fail_4 <= depth_test_fail;
        late_fail_5 <= late_fail_4;
        late_pass_4 <= depth_test_pass;
        late_pass_5 <= late_pass_4;
        weight_sum_4 <= {1'd0, stored[199:172]} + {13'd0, sample_3_weight};
        weight_sum_5 <= weight_sum_4;
        weight_sum_6 <= weight_sum_5;
        weight_sum_7 <= weight_sum_6;
        weight_sum_8 <= weight_sum_7;
        weight_4 <= sample_3_weight;
        weight_5 <= weight_4;
        weight_6 <= weight_5;
        weight_7 <= weight_6;
        weight_8 <= weight_7;
        depth_sum_4 <= stored[171:120] + {12'd0, sample_3_weighted_depth};
        depth_sum_5 <= depth_sum_4;
        depth_sum_6 <= depth_sum_5;
        depth_sum_7 <= depth_sum_6;
        depth_sum_8 <= depth_sum_7;
        depth_4 <= sample_3_weighted_depth;
        depth_5 <= depth_4;
        depth_6 <= depth_5;
        depth_7 <= depth_6;
        depth_8 <= depth_7;
        attribute_0_4 <= sample_3_attribute_0;
        attribute_0_5 <= attribute_0_4;
        attribute_0_6 <= attribute_0_5;
        attribute_0_7 <= attribute_0_6;
        attribute_0_8 <= attribute_0_7;
        sum_of_attribute_0_4 <= stored[119:80] + {{12{sample_3_attribute_0[27]}}, sample_3_attribute_0};
        sum_of_attribute_0_5 <= sum_of_attribute_0_4;
        sum_of_attribute_0_6 <= sum_of_attribute_0_5;
        sum_of_attribute_0_7 <= sum_of_attribute_0_6;
        sum_of_attribute_0_8 <= sum_of_attribute_0_7;
        attribute_1_4 <= sample_3_attribute_1;
        attribute_1_5 <= attribute_1_4;
        attribute_1_6 <= attribute_1_5;
        attribute_1_7 <= attribute_1_6;
        attribute_1_8 <= attribute_1_7;
        sum_of_attribute_1_4 <= stored[79:40] + {{12{sample_3_attribute_1[27]}}, sample_3_attribute_1};
        sum_of_attribute_1_5 <= sum_of_attribute_1_4;
        sum_of_attribute_1_6 <= sum_of_attribute_1_5;
        sum_of_attribute_1_7 <= sum_of_attribute_1_6;
        sum_of_attribute_1_8 <= sum_of_attribute_1_7;
        attribute_2_4 <= sample_3_attribute_2;
        attribute_2_5 <= attribute_2_4;
        attribute_2_6 <= attribute_2_5;
        attribute_2_7 <= attribute_2_6;
        attribute_2_8 <= attribute_2_7;
        sum_of_attribute_2_4 <= stored[39:0] + {{12{sample_3_attribute_2[27]}}, sample_3_attribute_2};
        sum_of_attribute_2_5 <= sum_of_attribute_2_4;
        sum_of_attribute_2_6 <= sum_of_attribute_2_5;
        sum_of_attribute_2_7 <= sum_of_attribute_2_6;
        sum_of_attribute_2_8 <= sum_of_attribute_2_7;
        if (head_takes) begin
            head_end <= places_out_end;
            head_last <= places_out_last;
            head_inside <= places_out_inside;
            head_slot <= places_out_slot;
            head_pixel <= places_out_pixel;
            head_weight <= samples_out_weight;
            head_weighted_depth <= samples_out_weighted_depth;
            head_depth_low <= samples_out_depth_low;
            head_depth_high <= samples_out_depth_high;
            head_attribute_0 <= samples_out_attribute_0;
            head_attribute_1 <= samples_out_attribute_1;
            head_attribute_2 <= samples_out_attribute_2;
        end
        if (slot_ready[0] | term_6) slot_0_pixel <= slot_0_read;
        if (slot_ready[1] | term_7) slot_1_pixel <= slot_1_read;
        if (drain_enable) drained_slot <= drain_slot;
    end

    wire _unused = &{1'b0, samples_in_ready, samples_out_valid, shifted_11[1], shifted_12[1]};

`ifdef RTL_ASSERT
    always @(posedge clk) begin
        if (!rst) begin
            if (!(places_out_valid == samples_out_valid)) begin
`ifdef FORMAL
                queues_move_together: assert (0);
`else
                $display("assertion failed: queues_move_together in %m");
                $stop;
`endif
            end
        end
    end
`endif
endmodule

// Compares a pixel's normalized depth with a splat's depth band.
module splat_depth_test (
    input  wire clk,
    input  wire rst,
    input  wire [27:0] weight,  // The pixel's sum of weights.
    input  wire [51:0] depth,  // The pixel's sum of weighted depths.
    input  wire [23:0] depth_low,  // Near end of the sample's depth band.
    input  wire [23:0] depth_high,  // Far end of the sample's depth band.
    output reg  fail,  // The pixel hides the sample.
    output reg  pass  // The sample hides the pixel.
);
    reg [51:0] arrived, stored;
    reg [25:0] low_bound_low_low, low_bound_high_high, low_bound_high_low, low_bound_low_high;
    reg [51:0] low_bound;
    reg [25:0] high_bound_low_low, high_bound_high_high, high_bound_high_low, high_bound_low_high;
    reg [51:0] high_bound;

    wire [51:0] term_1 = {26'd0, low_bound_low_low} | ({26'd0, low_bound_high_high} << 26);
    wire [51:0] term_2 = {26'd0, high_bound_low_low} | ({26'd0, high_bound_high_high} << 26);

    always @(posedge clk) begin
        if (rst) begin
            fail <= 1'd0;
            pass <= 1'd0;
        end else begin
            fail <= stored < low_bound;
            pass <= high_bound < stored;
        end
    end
    always @(posedge clk) begin
        arrived <= depth;
        stored <= arrived;
        low_bound_low_low <= {14'd0, depth_low[11:0]} * {12'd0, weight[13:0]};
        low_bound_high_high <= {14'd0, depth_low[23:12]} * {12'd0, weight[27:14]};
        low_bound_high_low <= {14'd0, depth_low[23:12]} * {12'd0, weight[13:0]};
        low_bound_low_high <= {14'd0, depth_low[11:0]} * {12'd0, weight[27:14]};
        low_bound <= term_1 + ({26'd0, low_bound_high_low} << 12) + ({26'd0, low_bound_low_high} << 14);
        high_bound_low_low <= {14'd0, depth_high[11:0]} * {12'd0, weight[13:0]};
        high_bound_high_high <= {14'd0, depth_high[23:12]} * {12'd0, weight[27:14]};
        high_bound_high_low <= {14'd0, depth_high[23:12]} * {12'd0, weight[13:0]};
        high_bound_low_high <= {14'd0, depth_high[11:0]} * {12'd0, weight[27:14]};
        high_bound <= term_2 + ({26'd0, high_bound_high_low} << 12) + ({26'd0, high_bound_low_high} << 14);
    end
endmodule

// Queue in a memory with a registered output.
// depth = 64
// width = 188
module stream_fifo_d64_w188 (
    input  wire clk,
    input  wire rst,
    input  wire in_valid,
    output wire in_ready,
    input  wire [187:0] in_data,
    output reg  out_valid,
    input  wire out_ready,
    output wire [187:0] out_data
);
    reg [6:0] held, waiting;
    reg [5:0] write_address, read_address;
    wire [187:0] item;

    wire has_room = ~held[6];
    wire push = in_valid & has_room;
    wire fetch = |waiting & (~out_valid | out_ready);
    wire pop = out_valid & out_ready;

    assign in_ready = has_room;
    assign out_data = item;

    memory_1w1r_unordered #(.WIDTH(188), .DEPTH(64)) entries (
        .clk(clk),
        .write(push), .write_address(write_address), .write_data(in_data),
        .read(fetch), .read_address(read_address), .read_data(item)
    );

    always @(posedge clk) begin
        if (rst) begin
            held <= 7'd0;
            waiting <= 7'd0;
            write_address <= 6'd0;
            read_address <= 6'd0;
            out_valid <= 1'd0;
        end else begin
            held <= (held + {6'd0, push}) - {6'd0, pop};
            waiting <= (waiting + {6'd0, push}) - {6'd0, fetch};
            out_valid <= fetch | (out_valid & ~out_ready);
            if (push) write_address <= write_address + 6'd1;
            if (fetch) read_address <= read_address + 6'd1;
        end
    end

`ifdef RTL_ASSERT
    always @(posedge clk) begin
        if (!rst) begin
            if (!(held <= 7'd64)) begin
`ifdef FORMAL
                held_in_range: assert (0);
`else
                $display("assertion failed: held_in_range in %m");
                $stop;
`endif
            end
            if (!(held == (waiting + {6'd0, out_valid}))) begin
`ifdef FORMAL
                held_is_waiting_and_shown: assert (0);
`else
                $display("assertion failed: held_is_waiting_and_shown in %m");
                $stop;
`endif
            end
        end
    end
`endif
endmodule

// Queue in a memory with a registered output.
// depth = 64
// width = 10
// storage = distributed
module stream_fifo_d64_w10_distributed (
    input  wire clk,
    input  wire rst,
    input  wire in_valid,
    output wire in_ready,
    input  wire [9:0] in_data,
    output reg  out_valid,
    input  wire out_ready,
    output wire [9:0] out_data
);
    (* ram_style = "distributed" *)
    reg [9:0] entries [0:63];
    reg [6:0] held, waiting;
    reg [5:0] write_address, read_address;
    reg [9:0] item;

    wire has_room = ~held[6];
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire fetch = |waiting & (~out_valid | out_ready);

    assign in_ready = has_room;
    assign out_data = item;

    always @(posedge clk) begin
        if (rst) begin
            held <= 7'd0;
            waiting <= 7'd0;
            write_address <= 6'd0;
            read_address <= 6'd0;
            out_valid <= 1'd0;
        end else begin
            held <= (held + {6'd0, push}) - {6'd0, pop};
            waiting <= (waiting + {6'd0, push}) - {6'd0, fetch};
            out_valid <= fetch | (out_valid & ~out_ready);
            if (push) write_address <= write_address + 6'd1;
            if (fetch) read_address <= read_address + 6'd1;
        end
    end
    always @(posedge clk) begin
        if (push) entries[write_address] <= in_data;
        if (fetch) item <= entries[read_address];
    end

`ifdef RTL_ASSERT
    always @(posedge clk) begin
        if (!rst) begin
            if (!(held <= 7'd64)) begin
`ifdef FORMAL
                held_in_range: assert (0);
`else
                $display("assertion failed: held_in_range in %m");
                $stop;
`endif
            end
            if (!(held == (waiting + {6'd0, out_valid}))) begin
`ifdef FORMAL
                held_is_waiting_and_shown: assert (0);
`else
                $display("assertion failed: held_is_waiting_and_shown in %m");
                $stop;
`endif
            end
        end
    end
`endif
endmodule

// Weighted depth and attributes of a sample.
// latency = 3
// initiation_interval = 1
module splat_weighting (
    input  wire clk,
    input  wire rst,
    input  wire in_valid,
    output wire in_ready,
    input  wire in_end,
    input  wire in_last,
    input  wire in_inside,
    input  wire in_slot,
    input  wire [5:0] in_pixel,
    input  wire [15:0] in_weight,
    input  wire [23:0] in_depth,
    input  wire [23:0] in_depth_low,
    input  wire [23:0] in_depth_high,
    input  wire [11:0] in_attribute_0,
    input  wire [11:0] in_attribute_1,
    input  wire [11:0] in_attribute_2,
    output wire out_valid,
    input  wire out_ready,
    output wire out_end,
    output wire out_last,
    output wire out_inside,
    output wire out_slot,
    output wire [5:0] out_pixel,
    output wire [15:0] out_weight,
    output wire [39:0] out_weighted_depth,
    output wire [23:0] out_depth_low,
    output wire [23:0] out_depth_high,
    output wire [27:0] out_attribute_0,
    output wire [27:0] out_attribute_1,
    output wire [27:0] out_attribute_2
);
    reg end_d1, end_d2, end_d3, last_d1, last_d2, last_d3, inside_d1, inside_d2, inside_d3, slot_d1, slot_d2;
    reg slot_d3;
    reg [5:0] pixel_d1, pixel_d2, pixel_d3;
    reg [15:0] weight_d1, weight_d2, weight_d3;
    reg [23:0] depth_low_d1, depth_low_d2, depth_low_d3, depth_high_d1, depth_high_d2, depth_high_d3;
    reg [27:0] resize_17_d1, resize_20_d1, resize_23_d1;
    reg [2:0] in_flight;

    wire queue_in_ready, queue_out_valid;
    wire [197:0] queue_out_data;
    wire [39:0] mul_u16_u24_unit_y;
    wire [28:0] mul_s17_s12_unit_y, mul_s17_s12_unit_copy2_y, mul_s17_s12_unit_copy3_y;

    assign in_ready = queue_in_ready;
    assign out_valid = queue_out_valid;
    assign {
        out_end, out_last, out_inside, out_slot, out_pixel, out_weight, out_weighted_depth, out_depth_low,
        out_depth_high, out_attribute_0, out_attribute_1, out_attribute_2
    } = queue_out_data;

    stream_skid_w198 queue (
        .clk(clk), .rst(rst),
        .in_valid(in_flight[2]), .in_ready(queue_in_ready),
        .in_data({
            end_d3, last_d3, inside_d3, slot_d3, pixel_d3, weight_d3, mul_u16_u24_unit_y, depth_low_d3,
            depth_high_d3, resize_17_d1, resize_20_d1, resize_23_d1
        }),
        .out_valid(queue_out_valid), .out_ready(out_ready), .out_data(queue_out_data)
    );

    integer_mul_s3_u16_u24 mul_u16_u24_unit (
        .clk(clk), .enable(queue_in_ready), .a(in_weight), .b(in_depth), .y(mul_u16_u24_unit_y)
    );

    integer_mul_s2_s17_s12 mul_s17_s12_unit (
        .clk(clk), .enable(queue_in_ready), .a({1'd0, in_weight}), .b(in_attribute_0), .y(mul_s17_s12_unit_y)
    );

    integer_mul_s2_s17_s12 mul_s17_s12_unit_copy2 (
        .clk(clk), .enable(queue_in_ready), .a({1'd0, in_weight}), .b(in_attribute_1),
        .y(mul_s17_s12_unit_copy2_y)
    );

    integer_mul_s2_s17_s12 mul_s17_s12_unit_copy3 (
        .clk(clk), .enable(queue_in_ready), .a({1'd0, in_weight}), .b(in_attribute_2),
        .y(mul_s17_s12_unit_copy3_y)
    );

    always @(posedge clk) begin
        if (rst) begin
            in_flight <= 3'd0;
        end else if (queue_in_ready) begin
            in_flight <= {in_flight[1:0], in_valid};
        end
    end
    always @(posedge clk) begin
        if (queue_in_ready) begin
            end_d1 <= in_end;
            end_d2 <= end_d1;
            end_d3 <= end_d2;
            last_d1 <= in_last;
            last_d2 <= last_d1;
            last_d3 <= last_d2;
            inside_d1 <= in_inside;
            inside_d2 <= inside_d1;
            inside_d3 <= inside_d2;
            slot_d1 <= in_slot;
            slot_d2 <= slot_d1;
            slot_d3 <= slot_d2;
            pixel_d1 <= in_pixel;
            pixel_d2 <= pixel_d1;
            pixel_d3 <= pixel_d2;
            weight_d1 <= in_weight;
            weight_d2 <= weight_d1;
            weight_d3 <= weight_d2;
            depth_low_d1 <= in_depth_low;
            depth_low_d2 <= depth_low_d1;
            depth_low_d3 <= depth_low_d2;
            depth_high_d1 <= in_depth_high;
            depth_high_d2 <= depth_high_d1;
            depth_high_d3 <= depth_high_d2;
            resize_17_d1 <= mul_s17_s12_unit_y[27:0];
            resize_20_d1 <= mul_s17_s12_unit_copy2_y[27:0];
            resize_23_d1 <= mul_s17_s12_unit_copy3_y[27:0];
        end
    end

    wire _unused = &{1'b0, mul_s17_s12_unit_copy2_y[28], mul_s17_s12_unit_copy3_y[28], mul_s17_s12_unit_y[28]};
endmodule

// Integer product, pipelined.
// stages = 2
// a = s17
// b = s12
module integer_mul_s2_s17_s12 (
    input  wire clk,
    input  wire enable,
    input  wire [16:0] a,
    input  wire [11:0] b,
    output reg  [28:0] y
);
    reg [16:0] a_s1;
    reg [11:0] b_s1;

    always @(posedge clk) begin
        if (enable) begin
            a_s1 <= a;
            b_s1 <= b;
            y <= $signed({{12{a_s1[16]}}, a_s1}) * $signed({{17{b_s1[11]}}, b_s1});
        end
    end
endmodule

// Integer product, pipelined.
// stages = 3
// a = u16
// b = u24
module integer_mul_s3_u16_u24 (
    input  wire clk,
    input  wire enable,
    input  wire [15:0] a,
    input  wire [23:0] b,
    output reg  [39:0] y
);
    reg [15:0] a_s1;
    reg [23:0] b_s1;
    reg [27:0] partial_0_0_s2, partial_0_12_s2;

    always @(posedge clk) begin
        if (enable) begin
            a_s1 <= a;
            b_s1 <= b;
            partial_0_0_s2 <= {12'd0, a_s1} * {16'd0, b_s1[11:0]};
            partial_0_12_s2 <= {12'd0, a_s1} * {16'd0, b_s1[23:12]};
            y <= {12'd0, partial_0_0_s2} + ({12'd0, partial_0_12_s2} << 12);
        end
    end
endmodule

// Queue of two in registers.
// width = 198
module stream_skid_w198 (
    input  wire clk,
    input  wire rst,
    input  wire in_valid,
    output wire in_ready,
    input  wire [197:0] in_data,
    output reg  out_valid,
    input  wire out_ready,
    output wire [197:0] out_data
);
    reg second_valid;
    reg [197:0] head, second;

    assign in_ready = ~second_valid;
    wire advance = ~out_valid | out_ready;
    wire some_item = second_valid | in_valid;

    assign out_data = head;

    always @(posedge clk) begin
        if (rst) begin
            out_valid <= 1'd0;
            second_valid <= 1'd0;
        end else begin
            if (advance) out_valid <= some_item;
            second_valid <= ~advance & some_item;
        end
    end
    always @(posedge clk) begin
        if (advance) head <= second_valid ? second : in_data;
        if (in_ready) second <= in_data;
    end

`ifdef RTL_ASSERT
    always @(posedge clk) begin
        if (!rst) begin
            if (!(out_valid | in_ready)) begin
`ifdef FORMAL
                second_waits_behind_head: assert (0);
`else
                $display("assertion failed: second_waits_behind_head in %m");
                $stop;
`endif
            end
        end
    end
`endif
endmodule

// Samples of a splat copy, one a cycle, with their kernel weights.
module splat_rasterizer (
    input  wire clk,
    input  wire rst,
    input  wire in_valid,  // Copies with their slots.
    output wire in_ready,
    input  wire in_end,  // Closes the frame.
    input  wire [25:0] in_center_x,  // Projected center (px), the origin of what follows.
    input  wire [25:0] in_center_y,  // Projected center (px), the origin of what follows.
    input  wire [15:0] in_ax,  // `A` in x.
    input  wire [15:0] in_bx,  // `B` in x.
    input  wire [15:0] in_ay,  // `A` in y.
    input  wire [15:0] in_by,  // `B` in y.
    input  wire [19:0] in_delta,  // The determinant of `A` and `B`.
    input  wire [15:0] in_mx,  // `m` in x.
    input  wire [15:0] in_my,  // `m` in y.
    input  wire [3:0] in_shift,  // In fixed point, places by which offsets from the centre are shifted.
    input  wire [23:0] in_depth,  // Depth.
    input  wire [23:0] in_depth_low,  // What is nearer hides the splat.
    input  wire [23:0] in_depth_high,  // What is farther is hidden by the splat.
    input  wire [11:0] in_attribute_0,  // Attributes.
    input  wire [11:0] in_attribute_1,  // Attributes.
    input  wire [11:0] in_attribute_2,  // Attributes.
    input  wire [2:0] in_left,  // First column.
    input  wire [2:0] in_right,  // Last column.
    input  wire [2:0] in_top,  // First row.
    input  wire [2:0] in_bottom,  // Last row.
    input  wire [11:0] in_tile,  // Tile index: row above column.
    input  wire in_slot,  // Slot of the tile cache.
    output wire out_valid,  // Samples.
    input  wire out_ready,
    output wire out_end,  // Closes the frame.
    output wire out_last,  // Closes its copy.
    output wire out_inside,  // Lies inside the splat; one outside is passed on only to say so.
    output wire out_slot,  // Slot of the tile cache.
    output wire [5:0] out_pixel,  // Pixel of the tile: row above column.
    output wire [15:0] out_weight,  // Kernel weight.
    output wire [23:0] out_depth,  // Depth.
    output wire [23:0] out_depth_low,  // What is nearer hides the splat.
    output wire [23:0] out_depth_high,  // What is farther is hidden by the splat.
    output wire [11:0] out_attribute_0,  // Attributes.
    output wire [11:0] out_attribute_1,  // Attributes.
    output wire [11:0] out_attribute_2,  // Attributes.
    input  wire [15:0] filter_scale,  // The reciprocal of the squared radius of the screen filter.
    output reg  event_sample,  // The rasterizer evaluated a sample.
    output reg  event_starved,  // The rasterizer had no copy to work on.
    output reg  event_blocked  // The rasterizer's pipeline was held by what follows it.
);
    reg busy, idle, is_end, is_last, slot;
    reg [11:0] tile;
    reg [2:0] column, row, left, right, bottom;
    reg [25:0] center_x, center_y;
    reg [15:0] ax, bx, ay, by;
    reg [19:0] delta;
    reg [15:0] mx, my;
    reg [3:0] shift;

    wire evaluation_in_ready, evaluation_out_valid, evaluation_out_end, evaluation_out_last;
    wire evaluation_out_inside, evaluation_out_slot;
    wire [5:0] evaluation_out_pixel;
    wire [15:0] evaluation_out_weight;
    wire shared_in_ready, shared_out_valid;
    wire [107:0] shared_out_data;

    wire take = evaluation_in_ready & idle & shared_in_ready;
    wire load = take & in_valid;
    wire term_1 = in_end | ({in_left, in_top} == {in_right, in_bottom});
    wire term_2 = column == right;
    wire [2:0] choice_3 = term_2 ? left : (column + 3'd1);
    wire [2:0] choice_4 = term_2 ? (row + 3'd1) : row;
    wire term_5 = {choice_3, choice_4} == {right, bottom};

    assign in_ready = take;
    assign out_valid = evaluation_out_valid;
    assign out_end = evaluation_out_end;
    assign out_last = evaluation_out_last;
    assign out_inside = evaluation_out_inside;
    assign out_slot = evaluation_out_slot;
    assign out_pixel = evaluation_out_pixel;
    assign out_weight = evaluation_out_weight;
    assign {out_depth, out_depth_low, out_depth_high, out_attribute_0, out_attribute_1, out_attribute_2} = shared_out_data;

    splat_evaluation evaluation (
        .clk(clk), .rst(rst),
        .in_valid(busy), .in_ready(evaluation_in_ready), .in_end(is_end), .in_last(is_last & ~is_end),
        .in_slot(slot), .in_column({tile[5:0], column}), .in_row({tile[11:6], row}), .in_center_x(center_x),
        .in_center_y(center_y), .in_ax(ax), .in_bx(bx), .in_ay(ay), .in_by(by), .in_delta(delta), .in_mx(mx),
        .in_my(my), .in_shift(shift),
        .filter_scale(filter_scale),
        .out_valid(evaluation_out_valid), .out_ready(out_ready), .out_end(evaluation_out_end),
        .out_last(evaluation_out_last), .out_inside(evaluation_out_inside), .out_slot(evaluation_out_slot),
        .out_pixel(evaluation_out_pixel), .out_weight(evaluation_out_weight)
    );

    stream_fifo_d64_w108 shared (
        .clk(clk), .rst(rst),
        .in_valid(load & ~in_end), .in_ready(shared_in_ready),
        .in_data({in_depth, in_depth_low, in_depth_high, in_attribute_0, in_attribute_1, in_attribute_2}),
        .out_valid(shared_out_valid), .out_ready(out_ready & evaluation_out_valid & evaluation_out_last),
        .out_data(shared_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            busy <= 1'd0;
            idle <= 1'd1;
            event_sample <= 1'd0;
            event_starved <= 1'd0;
            event_blocked <= 1'd0;
        end else begin
            if (evaluation_in_ready) begin
                busy <= load | (busy & ~is_last);
                idle <= load ? term_1 : (~busy | (is_last | term_5));
            end
            event_sample <= evaluation_in_ready & busy & ~is_end;
            event_starved <= evaluation_in_ready & ~busy;
            event_blocked <= busy & ~evaluation_in_ready;
        end
    end
    always @(posedge clk) begin
        if (take) begin
            is_end <= in_end;
            slot <= in_slot;
            tile <= in_tile;
            left <= in_left;
            right <= in_right;
            bottom <= in_bottom;
            center_x <= in_center_x;
            center_y <= in_center_y;
            ax <= in_ax;
            bx <= in_bx;
            ay <= in_ay;
            by <= in_by;
            delta <= in_delta;
            mx <= in_mx;
            my <= in_my;
            shift <= in_shift;
        end
        if (evaluation_in_ready) begin
            is_last <= load ? term_1 : term_5;
            column <= load ? in_left : choice_3;
            row <= load ? in_top : choice_4;
        end
    end

    wire _unused = &{1'b0, shared_out_valid};
endmodule

// Queue in a memory with a registered output.
// depth = 64
// width = 108
module stream_fifo_d64_w108 (
    input  wire clk,
    input  wire rst,
    input  wire in_valid,
    output wire in_ready,
    input  wire [107:0] in_data,
    output reg  out_valid,
    input  wire out_ready,
    output wire [107:0] out_data
);
    reg [6:0] held, waiting;
    reg [5:0] write_address, read_address;
    wire [107:0] item;

    wire has_room = ~held[6];
    wire push = in_valid & has_room;
    wire fetch = |waiting & (~out_valid | out_ready);
    wire pop = out_valid & out_ready;

    assign in_ready = has_room;
    assign out_data = item;

    memory_1w1r_unordered #(.WIDTH(108), .DEPTH(64)) entries (
        .clk(clk),
        .write(push), .write_address(write_address), .write_data(in_data),
        .read(fetch), .read_address(read_address), .read_data(item)
    );

    always @(posedge clk) begin
        if (rst) begin
            held <= 7'd0;
            waiting <= 7'd0;
            write_address <= 6'd0;
            read_address <= 6'd0;
            out_valid <= 1'd0;
        end else begin
            held <= (held + {6'd0, push}) - {6'd0, pop};
            waiting <= (waiting + {6'd0, push}) - {6'd0, fetch};
            out_valid <= fetch | (out_valid & ~out_ready);
            if (push) write_address <= write_address + 6'd1;
            if (fetch) read_address <= read_address + 6'd1;
        end
    end

`ifdef RTL_ASSERT
    always @(posedge clk) begin
        if (!rst) begin
            if (!(held <= 7'd64)) begin
`ifdef FORMAL
                held_in_range: assert (0);
`else
                $display("assertion failed: held_in_range in %m");
                $stop;
`endif
            end
            if (!(held == (waiting + {6'd0, out_valid}))) begin
`ifdef FORMAL
                held_is_waiting_and_shown: assert (0);
`else
                $display("assertion failed: held_is_waiting_and_shown in %m");
                $stop;
`endif
            end
        end
    end
`endif
endmodule

// Distance of a sample from its splat's centre, and its kernel weight.
// latency = 37
// initiation_interval = 1
module splat_evaluation (
    input  wire clk,
    input  wire rst,
    input  wire in_valid,
    output wire in_ready,
    input  wire in_end,
    input  wire in_last,
    input  wire in_slot,
    input  wire [8:0] in_column,
    input  wire [8:0] in_row,
    input  wire [25:0] in_center_x,
    input  wire [25:0] in_center_y,
    input  wire [15:0] in_ax,
    input  wire [15:0] in_bx,
    input  wire [15:0] in_ay,
    input  wire [15:0] in_by,
    input  wire [19:0] in_delta,
    input  wire [15:0] in_mx,
    input  wire [15:0] in_my,
    input  wire [3:0] in_shift,
    input  wire [15:0] filter_scale,
    output wire out_valid,
    input  wire out_ready,
    output wire out_end,
    output wire out_last,
    output wire out_inside,
    output wire out_slot,
    output wire [5:0] out_pixel,
    output wire [15:0] out_weight
);
    (* ram_style = "distributed" *)
    reg delay_6_from_0 [0:4];
    (* ram_style = "distributed" *)
    reg delay_9_from_0 [0:7];
    (* ram_style = "distributed" *)
    reg delay_10_from_0 [0:8];
    (* ram_style = "distributed" *)
    reg delay_15_from_0 [0:13];
    (* ram_style = "distributed" *)
    reg delay_16_from_0 [0:14];
    (* ram_style = "distributed" *)
    reg delay_17_from_0 [0:15];
    (* ram_style = "distributed" *)
    reg [3:0] delay_20_from_0 [0:18];
    (* ram_style = "distributed" *)
    reg [15:0] delay_25_from_0 [0:23];
    (* ram_style = "distributed" *)
    reg [6:0] delay_37_from_0 [0:35];
    reg [2:0] delay_6_from_0_pointer;
    reg delay_6_from_0_out;
    reg [2:0] delay_9_from_0_pointer;
    reg delay_9_from_0_out;
    reg [3:0] delay_10_from_0_pointer;
    reg delay_10_from_0_out;
    reg [3:0] delay_15_from_0_pointer;
    reg delay_15_from_0_out;
    reg [3:0] delay_16_from_0_pointer;
    reg delay_16_from_0_out;
    reg [3:0] delay_17_from_0_pointer;
    reg delay_17_from_0_out;
    reg [4:0] delay_20_from_0_pointer;
    reg [3:0] delay_20_from_0_out;
    reg [4:0] delay_25_from_0_pointer;
    reg [15:0] delay_25_from_0_out;
    reg [5:0] delay_37_from_0_pointer;
    reg [6:0] delay_37_from_0_out;
    reg end_d17;
    reg [22:0] resize_33_d1;
    reg bits_34_d1, bits_38_d1, bits_42_d1;
    reg [15:0] resize_45_d1;
    reg [22:0] resize_48_d1;
    reg [15:0] resize_57_d1, reinterpret_58_d1, reinterpret_58_d2, reinterpret_60_d1, reinterpret_60_d2;
    reg [31:0] sub_62_d1;
    reg [15:0] reinterpret_63_d1, reinterpret_63_d2, reinterpret_65_d1, reinterpret_65_d2;
    reg [31:0] sub_67_d1;
    reg [15:0] reinterpret_69_d1, reinterpret_69_d2, reinterpret_71_d1, reinterpret_71_d2;
    reg [31:0] mul_72_d1;
    reg [32:0] shl_76_d1, shl_76_d2, shl_76_d3, shl_76_d4, add_77_d1, add_78_d1;
    reg [31:0] bits_82_d1, bits_82_d2;
    reg [30:0] bits_86_d1;
    reg [31:0] resize_87_d1, resize_87_d2;
    reg [30:0] bits_91_d1;
    reg [31:0] resize_92_d1, resize_92_d2;
    reg equal_96_d1, equal_98_d1, equal_100_d1, not_102_d1, and_103_d1, and_103_d2;
    reg [31:0] select_105_d1, select_107_d1, select_109_d1;
    reg equal_112_d1, equal_114_d1, equal_116_d1, and_119_d1, or_120_d1;
    reg [24:0] bits_123_d1, bits_126_d1, bits_129_d1;
    reg equal_132_d1, equal_134_d1, equal_136_d1, and_139_d1, equal_152_d1, and_157_d1, or_160_d1;
    reg [18:0] bits_163_d1, bits_166_d1, bits_169_d1;
    reg equal_171_d1, not_177_d1;
    reg [17:0] bits_182_d1, bits_185_d1, bits_188_d1;
    reg [35:0] mul_189_d1;
    reg [36:0] add_194_d1;
    reg lt_196_d1, not_197_d1, not_197_d2, not_197_d3, not_197_d4;
    reg [23:0] resize_205_d1, resize_205_d2, resize_205_d3, resize_205_d4, resize_205_d5, resize_205_d6;
    reg [23:0] resize_205_d7, resize_205_d8, resize_205_d9, resize_205_d10, resize_205_d11, resize_205_d12;
    reg [23:0] resize_205_d13, resize_205_d14, resize_205_d15, resize_205_d16, shl_207_d1;
    reg not_212_d1;
    reg [23:0] shl_214_d1;
    reg [1:0] concat_220_d1;
    reg [23:0] shl_222_d1;
    reg [2:0] concat_228_d1;
    reg [23:0] shl_230_d1;
    reg [3:0] concat_236_d1;
    reg [23:0] shl_238_d1;
    reg [4:0] concat_244_d1;
    reg [23:0] shl_246_d1;
    reg [5:0] concat_252_d1;
    reg [23:0] shl_254_d1;
    reg [6:0] concat_260_d1;
    reg [23:0] shl_262_d1;
    reg [7:0] concat_268_d1;
    reg [23:0] shl_270_d1;
    reg [8:0] concat_276_d1;
    reg [23:0] shl_278_d1;
    reg [9:0] concat_284_d1;
    reg [23:0] shl_286_d1;
    reg [10:0] concat_292_d1;
    reg [23:0] shl_294_d1;
    reg [11:0] concat_300_d1;
    reg [23:0] shl_302_d1;
    reg [12:0] concat_308_d1;
    reg [23:0] shl_310_d1;
    reg [13:0] concat_316_d1;
    reg [23:0] shl_318_d1;
    reg [14:0] concat_324_d1;
    reg [23:0] shl_326_d1;
    reg [15:0] concat_330_d1, select_332_d1;
    reg [11:0] bits_333_d1;
    reg or_338_d1;
    reg [15:0] reinterpret_340_d1;
    reg [11:0] bits_343_d1;
    reg or_346_d1;
    reg [15:0] reinterpret_348_d1;
    reg and_352_d1, and_352_d2;
    reg [3:0] bits_353_d1;
    reg and_355_d1, and_355_d2;
    reg [17:0] bits_356_d1;
    reg and_361_d1;
    reg [15:0] bits_362_d1;
    reg or_364_d1;
    reg [15:0] min_365_d1;
    reg not_366_d1;
    reg [36:0] in_flight;

    wire queue_in_ready, queue_out_valid;
    wire [25:0] queue_out_data;
    wire [31:0] mul_s16_s16_unit_y, mul_s16_s16_unit_copy2_y, mul_s16_s16_unit_copy3_y, mul_s16_s16_unit_copy4_y;
    wire [31:0] mul_s16_s16_unit_copy5_y, mul_s16_s16_unit_copy6_y, mul_s16_s16_unit_copy7_y;
    wire [31:0] mul_s16_s16_unit_copy8_y;
    wire [35:0] mul_u18_u18_unit_y, mul_u18_u18_unit_copy2_y, mul_u18_u18_unit_copy3_y;
    wire [33:0] mul_u18_u16_unit_y;
    wire [15:0] interpolate_8_8_16_unit_y;

    wire [26:0] sub_23 = ({17'd0, in_column, 1'd1} << 11) - {in_center_x[25], in_center_x};
    wire [26:0] select_32 = in_shift[3] ? {{8{sub_23[26]}}, sub_23[26:8]} : sub_23;
    wire [22:0] select_36 = bits_34_d1 ? {{4{resize_33_d1[22]}}, resize_33_d1[22:4]} : resize_33_d1;
    wire [18:0] select_40 = bits_38_d1 ? {{2{select_36[18]}}, select_36[18:2]} : select_36[18:0];
    wire [16:0] select_44 = bits_42_d1 ? {select_40[16], select_40[16:1]} : select_40[16:0];
    wire [26:0] sub_29 = ({17'd0, in_row, 1'd1} << 11) - {in_center_y[25], in_center_y};
    wire [26:0] select_47 = in_shift[3] ? {{8{sub_29[26]}}, sub_29[26:8]} : sub_29;
    wire [22:0] select_50 = bits_34_d1 ? {{4{resize_48_d1[22]}}, resize_48_d1[22:4]} : resize_48_d1;
    wire [18:0] select_53 = bits_38_d1 ? {{2{select_50[18]}}, select_50[18:2]} : select_50[18:0];
    wire [16:0] select_56 = bits_42_d1 ? {select_53[16], select_53[16:1]} : select_53[16:0];
    wire [31:0] sub_62 = mul_s16_s16_unit_y - mul_s16_s16_unit_copy2_y;
    wire [31:0] sub_67 = mul_s16_s16_unit_copy3_y - mul_s16_s16_unit_copy4_y;
    wire [32:0] add_77 = {mul_s16_s16_unit_copy5_y[31], mul_s16_s16_unit_copy5_y} + shl_76_d4;
    wire [32:0] add_78 = {mul_72_d1[31], mul_72_d1} + add_77_d1;
    wire [32:0] not_80 = ~add_78_d1;
    wire [32:0] select_81 = add_78_d1[32] ? not_80 : add_78_d1;
    wire [31:0] not_84 = ~sub_62_d1;
    wire [31:0] select_85 = sub_62_d1[31] ? not_84 : sub_62_d1;
    wire [31:0] not_89 = ~sub_67_d1;
    wire [31:0] select_90 = sub_67_d1[31] ? not_89 : sub_67_d1;
    wire equal_96 = bits_82_d1[31:16] == 16'd0;
    wire equal_98 = 16'd0 == {1'd0, bits_86_d1[30:16]};
    wire equal_100 = 16'd0 == {1'd0, bits_91_d1[30:16]};
    wire and_101 = equal_98_d1 & equal_100_d1;
    wire not_102 = ~and_101;
    wire and_103 = equal_96_d1 & not_102_d1;
    wire [31:0] select_105 = equal_96_d1 ? (bits_82_d2 << 16) : bits_82_d2;
    wire [31:0] select_107 = equal_96_d1 ? (resize_87_d2 << 16) : resize_87_d2;
    wire [31:0] select_109 = equal_96_d1 ? (resize_92_d2 << 16) : resize_92_d2;
    wire equal_112 = select_105[31:24] == 8'd0;
    wire equal_114 = 8'd0 == select_107[31:24];
    wire equal_116 = 8'd0 == select_109[31:24];
    wire and_117 = equal_114_d1 & equal_116_d1;
    wire not_118 = ~and_117;
    wire and_119 = equal_112_d1 & not_118;
    wire or_120 = and_103_d2 | and_119_d1;
    wire [31:0] select_122 = equal_112_d1 ? (select_105_d1 << 8) : select_105_d1;
    wire [31:0] select_125 = equal_112_d1 ? (select_107_d1 << 8) : select_107_d1;
    wire [31:0] select_128 = equal_112_d1 ? (select_109_d1 << 8) : select_109_d1;
    wire equal_132 = select_122[31:28] == 4'd0;
    wire equal_134 = 4'd0 == select_125[31:28];
    wire equal_136 = 4'd0 == select_128[31:28];
    wire and_137 = equal_134_d1 & equal_136_d1;
    wire not_138 = ~and_137;
    wire and_139 = equal_132_d1 & not_138;
    wire [24:0] select_142 = equal_132_d1 ? (bits_123_d1 << 4) : bits_123_d1;
    wire equal_152 = select_142[24:23] == 2'd0;
    wire [24:0] select_145 = equal_132_d1 ? (bits_126_d1 << 4) : bits_126_d1;
    wire equal_154 = 2'd0 == select_145[24:23];
    wire [24:0] select_148 = equal_132_d1 ? (bits_129_d1 << 4) : bits_129_d1;
    wire equal_156 = 2'd0 == select_148[24:23];
    wire and_157 = equal_154 & equal_156;
    wire or_140 = or_120_d1 | and_139_d1;
    wire not_158 = ~and_157_d1;
    wire and_159 = equal_152_d1 & not_158;
    wire or_160 = or_140 | and_159;
    wire [20:0] select_162 = equal_152 ? (select_142[24:4] << 2) : select_142[24:4];
    wire [20:0] select_165 = equal_152 ? (select_145[24:4] << 2) : select_145[24:4];
    wire [20:0] select_168 = equal_152 ? (select_148[24:4] << 2) : select_148[24:4];
    wire equal_171 = ~bits_163_d1[18];
    wire equal_173 = ~bits_166_d1[18];
    wire equal_175 = ~bits_169_d1[18];
    wire and_176 = equal_173 & equal_175;
    wire not_177 = ~and_176;
    wire [18:0] select_181 = equal_171 ? (bits_163_d1 << 1) : bits_163_d1;
    wire [18:0] select_184 = equal_171 ? (bits_166_d1 << 1) : bits_166_d1;
    wire [18:0] select_187 = equal_171 ? (bits_169_d1 << 1) : bits_169_d1;
    wire [36:0] add_194 = {1'd0, mul_u18_u18_unit_copy2_y} + {1'd0, mul_u18_u18_unit_copy3_y};
    wire lt_196 = add_194_d1 < {1'd0, mul_189_d1};
    wire and_178 = equal_171_d1 & not_177_d1;
    wire or_179 = or_160_d1 | and_178;
    wire not_197 = ~or_179;
    wire [23:0] sub_208 = shl_207_d1 - resize_205_d1;
    wire not_212 = ~sub_208[23];
    wire [23:0] select_210 = sub_208[23] ? shl_207_d1 : sub_208;
    wire [23:0] sub_215 = shl_214_d1 - resize_205_d2;
    wire not_219 = ~sub_215[23];
    wire [23:0] select_217 = sub_215[23] ? shl_214_d1 : sub_215;
    wire [23:0] sub_223 = shl_222_d1 - resize_205_d3;
    wire not_227 = ~sub_223[23];
    wire [23:0] select_225 = sub_223[23] ? shl_222_d1 : sub_223;
    wire [23:0] sub_231 = shl_230_d1 - resize_205_d4;
    wire not_235 = ~sub_231[23];
    wire [23:0] select_233 = sub_231[23] ? shl_230_d1 : sub_231;
    wire [23:0] sub_239 = shl_238_d1 - resize_205_d5;
    wire not_243 = ~sub_239[23];
    wire [23:0] select_241 = sub_239[23] ? shl_238_d1 : sub_239;
    wire [23:0] sub_247 = shl_246_d1 - resize_205_d6;
    wire not_251 = ~sub_247[23];
    wire [23:0] select_249 = sub_247[23] ? shl_246_d1 : sub_247;
    wire [23:0] sub_255 = shl_254_d1 - resize_205_d7;
    wire not_259 = ~sub_255[23];
    wire [23:0] select_257 = sub_255[23] ? shl_254_d1 : sub_255;
    wire [23:0] sub_263 = shl_262_d1 - resize_205_d8;
    wire not_267 = ~sub_263[23];
    wire [23:0] select_265 = sub_263[23] ? shl_262_d1 : sub_263;
    wire [23:0] sub_271 = shl_270_d1 - resize_205_d9;
    wire not_275 = ~sub_271[23];
    wire [23:0] select_273 = sub_271[23] ? shl_270_d1 : sub_271;
    wire [23:0] sub_279 = shl_278_d1 - resize_205_d10;
    wire not_283 = ~sub_279[23];
    wire [23:0] select_281 = sub_279[23] ? shl_278_d1 : sub_279;
    wire [23:0] sub_287 = shl_286_d1 - resize_205_d11;
    wire not_291 = ~sub_287[23];
    wire [23:0] select_289 = sub_287[23] ? shl_286_d1 : sub_287;
    wire [23:0] sub_295 = shl_294_d1 - resize_205_d12;
    wire not_299 = ~sub_295[23];
    wire [23:0] select_297 = sub_295[23] ? shl_294_d1 : sub_295;
    wire [23:0] sub_303 = shl_302_d1 - resize_205_d13;
    wire not_307 = ~sub_303[23];
    wire [23:0] select_305 = sub_303[23] ? shl_302_d1 : sub_303;
    wire [23:0] sub_311 = shl_310_d1 - resize_205_d14;
    wire not_315 = ~sub_311[23];
    wire [23:0] select_313 = sub_311[23] ? shl_310_d1 : sub_311;
    wire [23:0] sub_319 = shl_318_d1 - resize_205_d15;
    wire not_323 = ~sub_319[23];
    wire [23:0] select_321 = sub_319[23] ? shl_318_d1 : sub_319;
    wire [23:0] sub_327 = shl_326_d1 - resize_205_d16;
    wire not_329 = ~sub_327[23];
    wire [15:0] select_332 = delay_15_from_0_out ? concat_330_d1 : 16'hffff;
    wire equal_336 = bits_333_d1 == 12'd0;
    wire equal_337 = bits_333_d1 == 12'hfff;
    wire or_338 = equal_336 | equal_337;
    wire equal_344 = 12'd0 == bits_343_d1;
    wire equal_345 = 12'hfff == bits_343_d1;
    wire or_346 = equal_344 | equal_345;
    wire and_352 = or_338_d1 & or_346_d1;
    wire [31:0] add_351 = mul_s16_s16_unit_copy7_y + mul_s16_s16_unit_copy8_y;
    wire equal_354 = 4'd0 == bits_353_d1;
    wire and_355 = and_352_d2 & equal_354;
    wire equal_360 = 8'd0 == mul_u18_u16_unit_y[33:26];
    wire and_361 = and_355_d2 & equal_360;
    wire and_198 = lt_196_d1 & not_197_d4;
    wire and_202 = and_198 & delay_10_from_0_out;
    wire or_364 = and_202 | delay_9_from_0_out;
    wire [15:0] min_365 = (delay_25_from_0_out < select_332_d1) ? delay_25_from_0_out : select_332_d1;
    wire not_366 = ~delay_16_from_0_out;
    wire xor_200 = add_78_d1[32] ^ delay_6_from_0_out;
    wire not_201 = ~xor_200;
    wire and_367 = or_364_d1 & not_366_d1;
    wire or_368 = delay_17_from_0_out | and_367;
    wire or_369 = end_d17 | or_368;
    wire [15:0] select_363 = and_361_d1 ? bits_362_d1 : 16'hffff;

    assign in_ready = queue_in_ready;
    assign out_valid = queue_out_valid;
    assign {out_end, out_last, out_inside, out_slot, out_pixel, out_weight} = queue_out_data;

    stream_skid_w26 queue (
        .clk(clk), .rst(rst),
        .in_valid(in_flight[36] & delay_20_from_0_out[3]), .in_ready(queue_in_ready),
        .in_data({
            delay_20_from_0_out[0], delay_20_from_0_out[1], delay_20_from_0_out[2], delay_37_from_0_out[0],
            delay_37_from_0_out[6:1], interpolate_8_8_16_unit_y
        }),
        .out_valid(queue_out_valid), .out_ready(out_ready), .out_data(queue_out_data)
    );

    integer_mul_s2_s16_s16 mul_s16_s16_unit (
        .clk(clk), .enable(queue_in_ready), .a(resize_45_d1), .b(reinterpret_58_d2), .y(mul_s16_s16_unit_y)
    );

    integer_mul_s2_s16_s16 mul_s16_s16_unit_copy2 (
        .clk(clk), .enable(queue_in_ready), .a(resize_57_d1), .b(reinterpret_60_d2),
        .y(mul_s16_s16_unit_copy2_y)
    );

    integer_mul_s2_s16_s16 mul_s16_s16_unit_copy3 (
        .clk(clk), .enable(queue_in_ready), .a(resize_45_d1), .b(reinterpret_63_d2),
        .y(mul_s16_s16_unit_copy3_y)
    );

    integer_mul_s2_s16_s16 mul_s16_s16_unit_copy4 (
        .clk(clk), .enable(queue_in_ready), .a(resize_57_d1), .b(reinterpret_65_d2),
        .y(mul_s16_s16_unit_copy4_y)
    );

    integer_mul_s2_s16_s16 mul_s16_s16_unit_copy5 (
        .clk(clk), .enable(queue_in_ready), .a(resize_45_d1), .b(reinterpret_69_d2),
        .y(mul_s16_s16_unit_copy5_y)
    );

    integer_mul_s2_s16_s16 mul_s16_s16_unit_copy6 (
        .clk(clk), .enable(queue_in_ready), .a(resize_57_d1), .b(reinterpret_71_d2),
        .y(mul_s16_s16_unit_copy6_y)
    );

    integer_mul_s2_s16_s16 mul_s16_s16_unit_copy7 (
        .clk(clk), .enable(queue_in_ready), .a(reinterpret_340_d1), .b(reinterpret_340_d1),
        .y(mul_s16_s16_unit_copy7_y)
    );

    integer_mul_s2_s16_s16 mul_s16_s16_unit_copy8 (
        .clk(clk), .enable(queue_in_ready), .a(reinterpret_348_d1), .b(reinterpret_348_d1),
        .y(mul_s16_s16_unit_copy8_y)
    );

    integer_mul_s2_u18_u18 mul_u18_u18_unit (
        .clk(clk), .enable(queue_in_ready), .a(bits_182_d1), .b(bits_182_d1), .y(mul_u18_u18_unit_y)
    );

    integer_mul_s2_u18_u18 mul_u18_u18_unit_copy2 (
        .clk(clk), .enable(queue_in_ready), .a(bits_185_d1), .b(bits_185_d1), .y(mul_u18_u18_unit_copy2_y)
    );

    integer_mul_s2_u18_u18 mul_u18_u18_unit_copy3 (
        .clk(clk), .enable(queue_in_ready), .a(bits_188_d1), .b(bits_188_d1), .y(mul_u18_u18_unit_copy3_y)
    );

    integer_mul_s2_u18_u16 mul_u18_u16_unit (
        .clk(clk), .enable(queue_in_ready), .a(bits_356_d1), .b(filter_scale), .y(mul_u18_u16_unit_y)
    );

    float_table_s4_i8_f8 interpolate_8_8_16_unit (
        .clk(clk), .enable(queue_in_ready), .a(min_365_d1), .y(interpolate_8_8_16_unit_y)
    );

    always @(posedge clk) begin
        if (rst) begin
            delay_6_from_0_pointer <= 3'd0;
            delay_9_from_0_pointer <= 3'd0;
            delay_10_from_0_pointer <= 4'd0;
            delay_15_from_0_pointer <= 4'd0;
            delay_16_from_0_pointer <= 4'd0;
            delay_17_from_0_pointer <= 4'd0;
            delay_20_from_0_pointer <= 5'd0;
            delay_25_from_0_pointer <= 5'd0;
            delay_37_from_0_pointer <= 6'd0;
            in_flight <= 37'd0;
        end else if (queue_in_ready) begin
            delay_6_from_0_pointer <= (delay_6_from_0_pointer == 3'd4) ? (delay_6_from_0_pointer - 3'd4) : (delay_6_from_0_pointer + 3'd1);
            delay_9_from_0_pointer <= (delay_9_from_0_pointer == 3'd7) ? (delay_9_from_0_pointer - 3'd7) : (delay_9_from_0_pointer + 3'd1);
            delay_10_from_0_pointer <= (delay_10_from_0_pointer == 4'd8) ? (delay_10_from_0_pointer - 4'd8) : (delay_10_from_0_pointer + 4'd1);
            delay_15_from_0_pointer <= (delay_15_from_0_pointer == 4'd13) ? (delay_15_from_0_pointer - 4'd13) : (delay_15_from_0_pointer + 4'd1);
            delay_16_from_0_pointer <= (delay_16_from_0_pointer == 4'd14) ? (delay_16_from_0_pointer - 4'd14) : (delay_16_from_0_pointer + 4'd1);
            delay_17_from_0_pointer <= (delay_17_from_0_pointer == 4'd15) ? (delay_17_from_0_pointer - 4'd15) : (delay_17_from_0_pointer + 4'd1);
            delay_20_from_0_pointer <= (delay_20_from_0_pointer == 5'd18) ? (delay_20_from_0_pointer - 5'd18) : (delay_20_from_0_pointer + 5'd1);
            delay_25_from_0_pointer <= (delay_25_from_0_pointer == 5'd23) ? (delay_25_from_0_pointer - 5'd23) : (delay_25_from_0_pointer + 5'd1);
            delay_37_from_0_pointer <= (delay_37_from_0_pointer == 6'd35) ? (delay_37_from_0_pointer - 6'd35) : (delay_37_from_0_pointer + 6'd1);
            in_flight <= {in_flight[35:0], in_valid};
        end
    end
    always @(posedge clk) begin
        if (queue_in_ready) begin
            end_d17 <= delay_16_from_0_out;
            resize_33_d1 <= select_32[22:0];
            bits_34_d1 <= in_shift[2];
            bits_38_d1 <= in_shift[1];
            bits_42_d1 <= in_shift[0];
            resize_45_d1 <= select_44[15:0];
            resize_48_d1 <= select_47[22:0];
            resize_57_d1 <= select_56[15:0];
            reinterpret_58_d1 <= in_ay;
            reinterpret_58_d2 <= reinterpret_58_d1;
            reinterpret_60_d1 <= in_ax;
            reinterpret_60_d2 <= reinterpret_60_d1;
            sub_62_d1 <= sub_62;
            reinterpret_63_d1 <= in_by;
            reinterpret_63_d2 <= reinterpret_63_d1;
            reinterpret_65_d1 <= in_bx;
            reinterpret_65_d2 <= reinterpret_65_d1;
            sub_67_d1 <= sub_67;
            reinterpret_69_d1 <= in_mx;
            reinterpret_69_d2 <= reinterpret_69_d1;
            reinterpret_71_d1 <= in_my;
            reinterpret_71_d2 <= reinterpret_71_d1;
            mul_72_d1 <= mul_s16_s16_unit_copy6_y;
            shl_76_d1 <= {{13{in_delta[19]}}, in_delta} << 12;
            shl_76_d2 <= shl_76_d1;
            shl_76_d3 <= shl_76_d2;
            shl_76_d4 <= shl_76_d3;
            add_77_d1 <= add_77;
            add_78_d1 <= add_78;
            bits_82_d1 <= select_81[31:0];
            bits_82_d2 <= bits_82_d1;
            bits_86_d1 <= select_85[30:0];
            resize_87_d1 <= {1'd0, bits_86_d1};
            resize_87_d2 <= resize_87_d1;
            bits_91_d1 <= select_90[30:0];
            resize_92_d1 <= {1'd0, bits_91_d1};
            resize_92_d2 <= resize_92_d1;
            equal_96_d1 <= equal_96;
            equal_98_d1 <= equal_98;
            equal_100_d1 <= equal_100;
            not_102_d1 <= not_102;
            and_103_d1 <= and_103;
            and_103_d2 <= and_103_d1;
            select_105_d1 <= select_105;
            select_107_d1 <= select_107;
            select_109_d1 <= select_109;
            equal_112_d1 <= equal_112;
            equal_114_d1 <= equal_114;
            equal_116_d1 <= equal_116;
            and_119_d1 <= and_119;
            or_120_d1 <= or_120;
            bits_123_d1 <= select_122[31:7];
            bits_126_d1 <= select_125[31:7];
            bits_129_d1 <= select_128[31:7];
            equal_132_d1 <= equal_132;
            equal_134_d1 <= equal_134;
            equal_136_d1 <= equal_136;
            and_139_d1 <= and_139;
            equal_152_d1 <= equal_152;
            and_157_d1 <= and_157;
            or_160_d1 <= or_160;
            bits_163_d1 <= select_162[20:2];
            bits_166_d1 <= select_165[20:2];
            bits_169_d1 <= select_168[20:2];
            equal_171_d1 <= equal_171;
            not_177_d1 <= not_177;
            bits_182_d1 <= select_181[18:1];
            bits_185_d1 <= select_184[18:1];
            bits_188_d1 <= select_187[18:1];
            mul_189_d1 <= mul_u18_u18_unit_y;
            add_194_d1 <= add_194;
            lt_196_d1 <= lt_196;
            not_197_d1 <= not_197;
            not_197_d2 <= not_197_d1;
            not_197_d3 <= not_197_d2;
            not_197_d4 <= not_197_d3;
            resize_205_d1 <= {2'd0, mul_u18_u18_unit_y[35:14]};
            resize_205_d2 <= resize_205_d1;
            resize_205_d3 <= resize_205_d2;
            resize_205_d4 <= resize_205_d3;
            resize_205_d5 <= resize_205_d4;
            resize_205_d6 <= resize_205_d5;
            resize_205_d7 <= resize_205_d6;
            resize_205_d8 <= resize_205_d7;
            resize_205_d9 <= resize_205_d8;
            resize_205_d10 <= resize_205_d9;
            resize_205_d11 <= resize_205_d10;
            resize_205_d12 <= resize_205_d11;
            resize_205_d13 <= resize_205_d12;
            resize_205_d14 <= resize_205_d13;
            resize_205_d15 <= resize_205_d14;
            resize_205_d16 <= resize_205_d15;
            shl_207_d1 <= {2'd0, add_194[35:14]} << 1;
            not_212_d1 <= not_212;
            shl_214_d1 <= {2'd0, select_210[21:0]} << 1;
            concat_220_d1 <= {not_212_d1, not_219};
            shl_222_d1 <= {2'd0, select_217[21:0]} << 1;
            concat_228_d1 <= {concat_220_d1, not_227};
            shl_230_d1 <= {2'd0, select_225[21:0]} << 1;
            concat_236_d1 <= {concat_228_d1, not_235};
            shl_238_d1 <= {2'd0, select_233[21:0]} << 1;
            concat_244_d1 <= {concat_236_d1, not_243};
            shl_246_d1 <= {2'd0, select_241[21:0]} << 1;
            concat_252_d1 <= {concat_244_d1, not_251};
            shl_254_d1 <= {2'd0, select_249[21:0]} << 1;
            concat_260_d1 <= {concat_252_d1, not_259};
            shl_262_d1 <= {2'd0, select_257[21:0]} << 1;
            concat_268_d1 <= {concat_260_d1, not_267};
            shl_270_d1 <= {2'd0, select_265[21:0]} << 1;
            concat_276_d1 <= {concat_268_d1, not_275};
            shl_278_d1 <= {2'd0, select_273[21:0]} << 1;
            concat_284_d1 <= {concat_276_d1, not_283};
            shl_286_d1 <= {2'd0, select_281[21:0]} << 1;
            concat_292_d1 <= {concat_284_d1, not_291};
            shl_294_d1 <= {2'd0, select_289[21:0]} << 1;
            concat_300_d1 <= {concat_292_d1, not_299};
            shl_302_d1 <= {2'd0, select_297[21:0]} << 1;
            concat_308_d1 <= {concat_300_d1, not_307};
            shl_310_d1 <= {2'd0, select_305[21:0]} << 1;
            concat_316_d1 <= {concat_308_d1, not_315};
            shl_318_d1 <= {2'd0, select_313[21:0]} << 1;
            concat_324_d1 <= {concat_316_d1, not_323};
            shl_326_d1 <= {2'd0, select_321[21:0]} << 1;
            concat_330_d1 <= {concat_324_d1, not_329};
            select_332_d1 <= select_332;
            bits_333_d1 <= sub_23[26:15];
            or_338_d1 <= or_338;
            reinterpret_340_d1 <= sub_23[15:0];
            bits_343_d1 <= sub_29[26:15];
            or_346_d1 <= or_346;
            reinterpret_348_d1 <= sub_29[15:0];
            and_352_d1 <= and_352;
            and_352_d2 <= and_352_d1;
            bits_353_d1 <= add_351[31:28];
            and_355_d1 <= and_355;
            and_355_d2 <= and_355_d1;
            bits_356_d1 <= add_351[27:10];
            and_361_d1 <= and_361;
            bits_362_d1 <= mul_u18_u16_unit_y[25:10];
            or_364_d1 <= or_364;
            min_365_d1 <= min_365;
            not_366_d1 <= not_366;
        end
    end
    always @(posedge clk) begin
        if (queue_in_ready) delay_6_from_0[delay_6_from_0_pointer] <= in_delta[19];
        if (queue_in_ready) delay_6_from_0_out <= delay_6_from_0[delay_6_from_0_pointer];
    end
    always @(posedge clk) begin
        if (queue_in_ready) delay_9_from_0[delay_9_from_0_pointer] <= and_361_d1;
        if (queue_in_ready) delay_9_from_0_out <= delay_9_from_0[delay_9_from_0_pointer];
    end
    always @(posedge clk) begin
        if (queue_in_ready) delay_10_from_0[delay_10_from_0_pointer] <= not_201;
        if (queue_in_ready) delay_10_from_0_out <= delay_10_from_0[delay_10_from_0_pointer];
    end
    always @(posedge clk) begin
        if (queue_in_ready) delay_15_from_0[delay_15_from_0_pointer] <= and_202;
        if (queue_in_ready) delay_15_from_0_out <= delay_15_from_0[delay_15_from_0_pointer];
    end
    always @(posedge clk) begin
        if (queue_in_ready) delay_16_from_0[delay_16_from_0_pointer] <= in_end;
        if (queue_in_ready) delay_16_from_0_out <= delay_16_from_0[delay_16_from_0_pointer];
    end
    always @(posedge clk) begin
        if (queue_in_ready) delay_17_from_0[delay_17_from_0_pointer] <= in_last;
        if (queue_in_ready) delay_17_from_0_out <= delay_17_from_0[delay_17_from_0_pointer];
    end
    always @(posedge clk) begin
        if (queue_in_ready) begin
            delay_20_from_0[delay_20_from_0_pointer] <= {or_369, and_367, delay_17_from_0_out, end_d17};
        end
        if (queue_in_ready) delay_20_from_0_out <= delay_20_from_0[delay_20_from_0_pointer];
    end
    always @(posedge clk) begin
        if (queue_in_ready) delay_25_from_0[delay_25_from_0_pointer] <= select_363;
        if (queue_in_ready) delay_25_from_0_out <= delay_25_from_0[delay_25_from_0_pointer];
    end
    always @(posedge clk) begin
        if (queue_in_ready) begin
            delay_37_from_0[delay_37_from_0_pointer] <= {in_row[2:0], in_column[2:0], in_slot};
        end
        if (queue_in_ready) delay_37_from_0_out <= delay_37_from_0[delay_37_from_0_pointer];
    end

    wire _unused = &{
        1'b0, add_351[9:0], mul_u18_u16_unit_y[9:0], select_122[6:0], select_125[6:0], select_128[6:0],
        select_142[3:0], select_145[3:0], select_148[3:0], select_162[1:0], select_165[1:0], select_168[1:0],
        select_181[0], select_184[0], select_187[0], select_210[23:22], select_217[23:22], select_225[23:22],
        select_233[23:22], select_241[23:22], select_249[23:22], select_257[23:22], select_265[23:22],
        select_273[23:22], select_281[23:22], select_289[23:22], select_297[23:22], select_305[23:22],
        select_313[23:22], select_32[26:23], select_321[23:22], select_36[22:19], select_40[18:17],
        select_44[16], select_47[26:23], select_50[22:19], select_53[18:17], select_56[16], select_81[32],
        select_85[31], select_90[31], sub_327[22:0]
    };
endmodule

// Sampled function, interpolated linearly.
// stages = 4
// index_bits = 8
// fraction_bits = 8
module float_table_s4_i8_f8 (
    input  wire clk,
    input  wire enable,
    input  wire [15:0] a,
    output reg  [15:0] y
);
    reg [32:0] entry_s1;
    reg [7:0] fraction_s1;
    reg [16:0] slope_s2;
    reg [7:0] fraction_s2;
    reg [15:0] rise_s3, start_s2, start_s3;

    reg [32:0] samples;
    always @(*) begin
        case (a[15:8])
            8'd0: samples = 33'h1fffffe02;
            8'd1: samples = 33'h1fc03fe06;
            8'd2: samples = 33'h1f80ffe0a;
            8'd3: samples = 33'h1f423fe0e;
            8'd4: samples = 33'h1f03ffe11;
            8'd5: samples = 33'h1ec61fe16;
            8'd6: samples = 33'h1e88dfe19;
            8'd7: samples = 33'h1e4bffe1d;
            8'd8: samples = 33'h1e0f9fe21;
            8'd9: samples = 33'h1dd3bfe25;
            8'd10: samples = 33'h1d985fe28;
            8'd11: samples = 33'h1d5d5fe2c;
            8'd12: samples = 33'h1d22dfe30;
            8'd13: samples = 33'h1ce8dfe33;
            8'd14: samples = 33'h1caf3fe37;
            8'd15: samples = 33'h1c761fe3a;
            8'd16: samples = 33'h1c3d5fe3e;
            8'd17: samples = 33'h1c051fe42;
            8'd18: samples = 33'h1bcd5fe45;
            8'd19: samples = 33'h1b95ffe48;
            8'd20: samples = 33'h1b5effe4c;
            8'd21: samples = 33'h1b287fe4f;
            8'd22: samples = 33'h1af25fe53;
            8'd23: samples = 33'h1abcbfe55;
            8'd24: samples = 33'h1a875fe5a;
            8'd25: samples = 33'h1a529fe5c;
            8'd26: samples = 33'h1a1e1fe60;
            8'd27: samples = 33'h19ea1fe63;
            8'd28: samples = 33'h19b67fe66;
            8'd29: samples = 33'h19833fe69;
            8'd30: samples = 33'h19505fe6d;
            8'd31: samples = 33'h191dffe70;
            8'd32: samples = 33'h18ebffe73;
            8'd33: samples = 33'h18ba5fe75;
            8'd34: samples = 33'h1888ffe79;
            8'd35: samples = 33'h18581fe7c;
            8'd36: samples = 33'h18279fe7f;
            8'd37: samples = 33'h17f77fe82;
            8'd38: samples = 33'h17c7bfe85;
            8'd39: samples = 33'h17985fe88;
            8'd40: samples = 33'h17695fe8b;
            8'd41: samples = 33'h173abfe8e;
            8'd42: samples = 33'h170c7fe91;
            8'd43: samples = 33'h16de9fe93;
            8'd44: samples = 33'h16b0ffe97;
            8'd45: samples = 33'h1683dfe99;
            8'd46: samples = 33'h1656ffe9c;
            8'd47: samples = 33'h162a7fe9f;
            8'd48: samples = 33'h15fe5fea1;
            8'd49: samples = 33'h15d27fea4;
            8'd50: samples = 33'h15a6ffea7;
            8'd51: samples = 33'h157bdfeaa;
            8'd52: samples = 33'h15511feac;
            8'd53: samples = 33'h15269feaf;
            8'd54: samples = 33'h14fc7feb1;
            8'd55: samples = 33'h14d29feb5;
            8'd56: samples = 33'h14a93feb6;
            8'd57: samples = 33'h147fffeba;
            8'd58: samples = 33'h14573febb;
            8'd59: samples = 33'h142e9febf;
            8'd60: samples = 33'h14067fec1;
            8'd61: samples = 33'h13de9fec3;
            8'd62: samples = 33'h13b6ffec6;
            8'd63: samples = 33'h138fbfec8;
            8'd64: samples = 33'h1368bfecb;
            8'd65: samples = 33'h13421fecd;
            8'd66: samples = 33'h131bbfecf;
            8'd67: samples = 33'h12f59fed2;
            8'd68: samples = 33'h12cfdfed4;
            8'd69: samples = 33'h12aa5fed7;
            8'd70: samples = 33'h12853fed9;
            8'd71: samples = 33'h12605fedb;
            8'd72: samples = 33'h123bbfedd;
            8'd73: samples = 33'h12175fee0;
            8'd74: samples = 33'h11f35fee2;
            8'd75: samples = 33'h11cf9fee4;
            8'd76: samples = 33'h11ac1fee6;
            8'd77: samples = 33'h1188dfee9;
            8'd78: samples = 33'h1165ffeea;
            8'd79: samples = 33'h11433feed;
            8'd80: samples = 33'h1120dfeef;
            8'd81: samples = 33'h10febfef2;
            8'd82: samples = 33'h10dcffef3;
            8'd83: samples = 33'h10bb5fef5;
            8'd84: samples = 33'h1099ffef8;
            8'd85: samples = 33'h1078ffef9;
            8'd86: samples = 33'h10581fefc;
            8'd87: samples = 33'h10379fefd;
            8'd88: samples = 33'h10173ff00;
            8'd89: samples = 33'hff73ff01;
            8'd90: samples = 33'hfd75ff04;
            8'd91: samples = 33'hfb7dff05;
            8'd92: samples = 33'hf987ff08;
            8'd93: samples = 33'hf797ff09;
            8'd94: samples = 33'hf5a9ff0b;
            8'd95: samples = 33'hf3bfff0e;
            8'd96: samples = 33'hf1dbff0f;
            8'd97: samples = 33'heff9ff11;
            8'd98: samples = 33'hee1bff12;
            8'd99: samples = 33'hec3fff15;
            8'd100: samples = 33'hea69ff17;
            8'd101: samples = 33'he897ff18;
            8'd102: samples = 33'he6c7ff1a;
            8'd103: samples = 33'he4fbff1c;
            8'd104: samples = 33'he333ff1e;
            8'd105: samples = 33'he16fff1f;
            8'd106: samples = 33'hdfadff21;
            8'd107: samples = 33'hddefff23;
            8'd108: samples = 33'hdc35ff25;
            8'd109: samples = 33'hda7fff26;
            8'd110: samples = 33'hd8cbff28;
            8'd111: samples = 33'hd71bff2a;
            8'd112: samples = 33'hd56fff2b;
            8'd113: samples = 33'hd3c5ff2e;
            8'd114: samples = 33'hd221ff2e;
            8'd115: samples = 33'hd07dff31;
            8'd116: samples = 33'hcedfff31;
            8'd117: samples = 33'hcd41ff34;
            8'd118: samples = 33'hcba9ff35;
            8'd119: samples = 33'hca13ff37;
            8'd120: samples = 33'hc881ff38;
            8'd121: samples = 33'hc6f1ff3a;
            8'd122: samples = 33'hc565ff3b;
            8'd123: samples = 33'hc3dbff3d;
            8'd124: samples = 33'hc255ff3f;
            8'd125: samples = 33'hc0d3ff40;
            8'd126: samples = 33'hbf53ff41;
            8'd127: samples = 33'hbdd5ff43;
            8'd128: samples = 33'hbc5bff44;
            8'd129: samples = 33'hbae3ff46;
            8'd130: samples = 33'hb96fff47;
            8'd131: samples = 33'hb7fdff49;
            8'd132: samples = 33'hb68fff4a;
            8'd133: samples = 33'hb523ff4c;
            8'd134: samples = 33'hb3bbff4d;
            8'd135: samples = 33'hb255ff4e;
            8'd136: samples = 33'hb0f1ff50;
            8'd137: samples = 33'haf91ff51;
            8'd138: samples = 33'hae33ff53;
            8'd139: samples = 33'hacd9ff53;
            8'd140: samples = 33'hab7fff56;
            8'd141: samples = 33'haa2bff56;
            8'd142: samples = 33'ha8d7ff58;
            8'd143: samples = 33'ha787ff59;
            8'd144: samples = 33'ha639ff5b;
            8'd145: samples = 33'ha4efff5b;
            8'd146: samples = 33'ha3a5ff5d;
            8'd147: samples = 33'ha25fff5f;
            8'd148: samples = 33'ha11dff5f;
            8'd149: samples = 33'h9fdbff61;
            8'd150: samples = 33'h9e9dff62;
            8'd151: samples = 33'h9d61ff63;
            8'd152: samples = 33'h9c27ff65;
            8'd153: samples = 33'h9af1ff65;
            8'd154: samples = 33'h99bbff67;
            8'd155: samples = 33'h9889ff68;
            8'd156: samples = 33'h9759ff69;
            8'd157: samples = 33'h962bff6b;
            8'd158: samples = 33'h9501ff6b;
            8'd159: samples = 33'h93d7ff6d;
            8'd160: samples = 33'h92b1ff6e;
            8'd161: samples = 33'h918dff6f;
            8'd162: samples = 33'h906bff70;
            8'd163: samples = 33'h8f4bff71;
            8'd164: samples = 33'h8e2dff73;
            8'd165: samples = 33'h8d13ff73;
            8'd166: samples = 33'h8bf9ff75;
            8'd167: samples = 33'h8ae3ff76;
            8'd168: samples = 33'h89cfff76;
            8'd169: samples = 33'h88bbff78;
            8'd170: samples = 33'h87abff79;
            8'd171: samples = 33'h869dff7a;
            8'd172: samples = 33'h8591ff7b;
            8'd173: samples = 33'h8487ff7c;
            8'd174: samples = 33'h837fff7d;
            8'd175: samples = 33'h8279ff7e;
            8'd176: samples = 33'h8175ff7f;
            8'd177: samples = 33'h8073ff80;
            8'd178: samples = 33'h7f73ff81;
            8'd179: samples = 33'h7e75ff82;
            8'd180: samples = 33'h7d79ff83;
            8'd181: samples = 33'h7c7fff84;
            8'd182: samples = 33'h7b87ff85;
            8'd183: samples = 33'h7a91ff86;
            8'd184: samples = 33'h799dff87;
            8'd185: samples = 33'h78abff88;
            8'd186: samples = 33'h77bbff88;
            8'd187: samples = 33'h76cbff8a;
            8'd188: samples = 33'h75dfff8b;
            8'd189: samples = 33'h74f5ff8b;
            8'd190: samples = 33'h740bff8d;
            8'd191: samples = 33'h7325ff8d;
            8'd192: samples = 33'h723fff8e;
            8'd193: samples = 33'h715bff8f;
            8'd194: samples = 33'h7079ff90;
            8'd195: samples = 33'h6f99ff91;
            8'd196: samples = 33'h6ebbff92;
            8'd197: samples = 33'h6ddfff92;
            8'd198: samples = 33'h6d03ff94;
            8'd199: samples = 33'h6c2bff94;
            8'd200: samples = 33'h6b53ff95;
            8'd201: samples = 33'h6a7dff96;
            8'd202: samples = 33'h69a9ff97;
            8'd203: samples = 33'h68d7ff97;
            8'd204: samples = 33'h6805ff99;
            8'd205: samples = 33'h6737ff99;
            8'd206: samples = 33'h6669ff9a;
            8'd207: samples = 33'h659dff9b;
            8'd208: samples = 33'h64d3ff9b;
            8'd209: samples = 33'h6409ff9d;
            8'd210: samples = 33'h6343ff9d;
            8'd211: samples = 33'h627dff9e;
            8'd212: samples = 33'h61b9ff9e;
            8'd213: samples = 33'h60f5ffa0;
            8'd214: samples = 33'h6035ffa0;
            8'd215: samples = 33'h5f75ffa1;
            8'd216: samples = 33'h5eb7ffa1;
            8'd217: samples = 33'h5df9ffa3;
            8'd218: samples = 33'h5d3fffa3;
            8'd219: samples = 33'h5c85ffa4;
            8'd220: samples = 33'h5bcdffa4;
            8'd221: samples = 33'h5b15ffa6;
            8'd222: samples = 33'h5a61ffa6;
            8'd223: samples = 33'h59adffa6;
            8'd224: samples = 33'h58f9ffa8;
            8'd225: samples = 33'h5849ffa8;
            8'd226: samples = 33'h5799ffa8;
            8'd227: samples = 33'h56e9ffaa;
            8'd228: samples = 33'h563dffaa;
            8'd229: samples = 33'h5591ffab;
            8'd230: samples = 33'h54e7ffab;
            8'd231: samples = 33'h543dffac;
            8'd232: samples = 33'h5395ffad;
            8'd233: samples = 33'h52efffad;
            8'd234: samples = 33'h5249ffae;
            8'd235: samples = 33'h51a5ffaf;
            8'd236: samples = 33'h5103ffaf;
            8'd237: samples = 33'h5061ffb0;
            8'd238: samples = 33'h4fc1ffb1;
            8'd239: samples = 33'h4f23ffb1;
            8'd240: samples = 33'h4e85ffb2;
            8'd241: samples = 33'h4de9ffb2;
            8'd242: samples = 33'h4d4dffb3;
            8'd243: samples = 33'h4cb3ffb4;
            8'd244: samples = 33'h4c1bffb4;
            8'd245: samples = 33'h4b83ffb5;
            8'd246: samples = 33'h4aedffb5;
            8'd247: samples = 33'h4a57ffb6;
            8'd248: samples = 33'h49c3ffb7;
            8'd249: samples = 33'h4931ffb7;
            8'd250: samples = 33'h489fffb8;
            8'd251: samples = 33'h480fffb8;
            8'd252: samples = 33'h477fffb9;
            8'd253: samples = 33'h46f1ffb9;
            8'd254: samples = 33'h4663ffba;
            default: samples = 33'h45d7ffba;
        endcase
    end
    wire [8:0] joined_1 = {1'd0, fraction_s2};
    wire [25:0] product_2 = $signed({{9{slope_s2[16]}}, slope_s2}) * $signed({{17{joined_1[8]}}, joined_1});

    always @(posedge clk) begin
        if (enable) begin
            entry_s1 <= samples;
            fraction_s1 <= a[7:0];
            slope_s2 <= entry_s1[16:0];
            fraction_s2 <= fraction_s1;
            rise_s3 <= product_2[23:8];
            start_s2 <= entry_s1[32:17];
            start_s3 <= start_s2;
            y <= start_s3 + rise_s3;
        end
    end

    wire _unused = &{1'b0, product_2[7:0], product_2[25:24]};
endmodule

// Integer product, pipelined.
// stages = 2
// a = u18
// b = u16
module integer_mul_s2_u18_u16 (
    input  wire clk,
    input  wire enable,
    input  wire [17:0] a,
    input  wire [15:0] b,
    output reg  [33:0] y
);
    reg [17:0] a_s1;
    reg [15:0] b_s1;

    always @(posedge clk) begin
        if (enable) begin
            a_s1 <= a;
            b_s1 <= b;
            y <= {16'd0, a_s1} * {18'd0, b_s1};
        end
    end
endmodule

// Integer product, pipelined.
// stages = 2
// a = u18
// b = u18
module integer_mul_s2_u18_u18 (
    input  wire clk,
    input  wire enable,
    input  wire [17:0] a,
    input  wire [17:0] b,
    output reg  [35:0] y
);
    reg [17:0] a_s1, b_s1;

    always @(posedge clk) begin
        if (enable) begin
            a_s1 <= a;
            b_s1 <= b;
            y <= {18'd0, a_s1} * {18'd0, b_s1};
        end
    end
endmodule

// Integer product, pipelined.
// stages = 2
// a = s16
// b = s16
module integer_mul_s2_s16_s16 (
    input  wire clk,
    input  wire enable,
    input  wire [15:0] a,
    input  wire [15:0] b,
    output reg  [31:0] y
);
    reg [15:0] a_s1, b_s1;

    always @(posedge clk) begin
        if (enable) begin
            a_s1 <= a;
            b_s1 <= b;
            y <= $signed({{16{a_s1[15]}}, a_s1}) * $signed({{16{b_s1[15]}}, b_s1});
        end
    end
endmodule

// Queue of two in registers.
// width = 26
module stream_skid_w26 (
    input  wire clk,
    input  wire rst,
    input  wire in_valid,
    output wire in_ready,
    input  wire [25:0] in_data,
    output reg  out_valid,
    input  wire out_ready,
    output wire [25:0] out_data
);
    reg second_valid;
    reg [25:0] head, second;

    assign in_ready = ~second_valid;
    wire advance = ~out_valid | out_ready;
    wire some_item = second_valid | in_valid;

    assign out_data = head;

    always @(posedge clk) begin
        if (rst) begin
            out_valid <= 1'd0;
            second_valid <= 1'd0;
        end else begin
            if (advance) out_valid <= some_item;
            second_valid <= ~advance & some_item;
        end
    end
    always @(posedge clk) begin
        if (advance) head <= second_valid ? second : in_data;
        if (in_ready) second <= in_data;
    end

`ifdef RTL_ASSERT
    always @(posedge clk) begin
        if (!rst) begin
            if (!(out_valid | in_ready)) begin
`ifdef FORMAL
                second_waits_behind_head: assert (0);
`else
                $display("assertion failed: second_waits_behind_head in %m");
                $stop;
`endif
            end
        end
    end
`endif
endmodule

// Control of the tile slots: placement, exchange with memory, end of frame.
// slots = 2
module splat_tile_cache (
    input  wire clk,
    input  wire rst,
    input  wire in_valid,  // Copies in order of tiles.
    output wire in_ready,
    input  wire in_end,  // Closes the frame.
    input  wire [25:0] in_center_x,  // Projected center (px), the origin of what follows.
    input  wire [25:0] in_center_y,  // Projected center (px), the origin of what follows.
    input  wire [15:0] in_ax,  // `A` in x.
    input  wire [15:0] in_bx,  // `B` in x.
    input  wire [15:0] in_ay,  // `A` in y.
    input  wire [15:0] in_by,  // `B` in y.
    input  wire [19:0] in_delta,  // The determinant of `A` and `B`.
    input  wire [15:0] in_mx,  // `m` in x.
    input  wire [15:0] in_my,  // `m` in y.
    input  wire [3:0] in_shift,  // In fixed point, places by which offsets from the centre are shifted.
    input  wire [23:0] in_depth,  // Depth.
    input  wire [23:0] in_depth_low,  // What is nearer hides the splat.
    input  wire [23:0] in_depth_high,  // What is farther is hidden by the splat.
    input  wire [11:0] in_attribute_0,  // Attributes.
    input  wire [11:0] in_attribute_1,  // Attributes.
    input  wire [11:0] in_attribute_2,  // Attributes.
    input  wire [2:0] in_left,  // First column.
    input  wire [2:0] in_right,  // Last column.
    input  wire [2:0] in_top,  // First row.
    input  wire [2:0] in_bottom,  // Last row.
    input  wire [11:0] in_tile,  // Tile index: row above column.
    output wire out_valid,  // Copies with their slots.
    input  wire out_ready,
    output wire out_end,  // Closes the frame.
    output wire [25:0] out_center_x,  // Projected center (px), the origin of what follows.
    output wire [25:0] out_center_y,  // Projected center (px), the origin of what follows.
    output wire [15:0] out_ax,  // `A` in x.
    output wire [15:0] out_bx,  // `B` in x.
    output wire [15:0] out_ay,  // `A` in y.
    output wire [15:0] out_by,  // `B` in y.
    output wire [19:0] out_delta,  // The determinant of `A` and `B`.
    output wire [15:0] out_mx,  // `m` in x.
    output wire [15:0] out_my,  // `m` in y.
    output wire [3:0] out_shift,  // In fixed point, places by which offsets from the centre are shifted.
    output wire [23:0] out_depth,  // Depth.
    output wire [23:0] out_depth_low,  // What is nearer hides the splat.
    output wire [23:0] out_depth_high,  // What is farther is hidden by the splat.
    output wire [11:0] out_attribute_0,  // Attributes.
    output wire [11:0] out_attribute_1,  // Attributes.
    output wire [11:0] out_attribute_2,  // Attributes.
    output wire [2:0] out_left,  // First column.
    output wire [2:0] out_right,  // Last column.
    output wire [2:0] out_top,  // First row.
    output wire [2:0] out_bottom,  // Last row.
    output wire [11:0] out_tile,  // Tile index: row above column.
    output wire out_slot,  // Slot of the tile cache.
    output reg  read_valid,  // Request for the pixels of a tile.
    input  wire read_ready,
    output reg  [11:0] read_tile,  // Tile index.
    input  wire data_valid,  // Pixels of the tiles requested, in pixel order.
    output wire data_ready,
    input  wire [27:0] data_weight,  // Sum of weights.
    input  wire [51:0] data_depth,  // Sum of weighted depths.
    input  wire [39:0] data_attribute_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [39:0] data_attribute_1,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [39:0] data_attribute_2,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire write_valid,  // Pixels of evicted tiles.
    input  wire write_ready,
    output wire [11:0] write_tile,  // Tile index.
    output wire [5:0] write_pixel,  // Pixel of the tile.
    output wire [27:0] write_weight,  // Sum of weights.
    output wire [51:0] write_depth,  // Sum of weighted depths.
    output wire [39:0] write_attribute_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [39:0] write_attribute_1,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [39:0] write_attribute_2,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire pixel_valid,  // Pixels of a finished frame.
    input  wire pixel_ready,
    output wire pixel_end,  // Closes the frame.
    output wire [11:0] pixel_tile,  // Tile index.
    output wire [5:0] pixel_pixel,  // Pixel of the tile.
    output wire [27:0] pixel_weight,  // Sum of weights.
    output wire [51:0] pixel_depth,  // Sum of weighted depths.
    output wire [39:0] pixel_attribute_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [39:0] pixel_attribute_1,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [39:0] pixel_attribute_2,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [1:0] slot_ready,  // A bit for each slot that may be accumulated into.
    input  wire retire_valid,  // The accumulator is done with a copy.
    input  wire retire_slot,  // Slot of the tile cache.
    input  wire frame_end,  // The accumulator is done with the frame.
    output reg  fill_valid,  // Write to a slot.
    output wire fill_slot,  // Slot of the tile cache.
    output reg  [5:0] fill_pixel,  // Pixel of the tile.
    output reg  [27:0] fill_weight,  // Sum of weights.
    output reg  [51:0] fill_depth,  // Sum of weighted depths.
    output reg  [39:0] fill_attribute_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output reg  [39:0] fill_attribute_1,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output reg  [39:0] fill_attribute_2,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire drain_enable,  // Read of a slot.
    output wire drain_slot,  // Slot of the tile cache.
    output wire [5:0] drain_pixel,  // Pixel of the tile.
    input  wire [27:0] drain_weight,  // Sum of weights.
    input  wire [51:0] drain_depth,  // Sum of weighted depths.
    input  wire [39:0] drain_attribute_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [39:0] drain_attribute_1,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [39:0] drain_attribute_2  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
);
    reg head_valid, head_end;
    reg [25:0] head_center_x, head_center_y;
    reg [15:0] head_ax, head_bx, head_ay, head_by;
    reg [19:0] head_delta;
    reg [15:0] head_mx, head_my;
    reg [3:0] head_shift;
    reg [23:0] head_depth, head_depth_low, head_depth_high;
    reg [11:0] head_attribute_0, head_attribute_1, head_attribute_2;
    reg [2:0] head_left, head_right, head_top, head_bottom;
    reg [11:0] head_tile;
    reg [2:0] mode;
    reg frame_ended;
    reg [11:0] code;
    reg code_read, looking, looked, moving, slot, evict;
    reg [11:0] evict_tile;
    reg load;
    reg [6:0] drained;
    reg showing;
    reg [5:0] shown_pixel;
    reg holding;
    reg [5:0] held_pixel;
    reg [6:0] filled;
    reg next;
    reg [11:0] tile_0;
    reg resident_0, ready_0;
    reg [7:0] in_flight_0;
    reg is_of_copy_0, is_of_code_0;
    reg [11:0] tile_1;
    reg resident_1, ready_1;
    reg [7:0] in_flight_1;
    reg is_of_copy_1, is_of_code_1;
    wire stored_touched;
    reg touched;

    wire in_queue_in_ready, in_queue_out_valid;
    wire [304:0] in_queue_out_data;
    wire out_queue_in_ready, out_queue_out_valid;
    wire [305:0] out_queue_out_data;
    wire write_queue_in_ready, write_queue_out_valid;
    wire [217:0] write_queue_out_data;
    wire pixel_queue_in_ready, pixel_queue_out_valid;
    wire [218:0] pixel_queue_out_data;

    wire may_fill = moving & (~filled[6] & (~evict | (filled < drained)));
    wire term_1 = mode == 3'd6;
    wire take_data = (may_fill & load) | (term_1 & (pixel_queue_in_ready & ~drained[6]));
    wire term_2 = mode == 3'd5;
    wire draining = term_2 | (moving & evict);
    wire term_3 = ~holding | (term_2 ? pixel_queue_in_ready : write_queue_in_ready);
    wire drain_step = draining & term_3;
    wire term_4 = mode == 3'd0;
    wire term_5 = mode == 3'd4;
    wire term_6 = mode == 3'd3;
    wire head_takes = ~head_valid;
    wire head_waits = (mode == 3'd1) & head_valid;
    wire term_7 = head_waits & ~head_end;
    wire term_8 = resident_0 & is_of_copy_0;
    wire copy_slot = resident_1 & is_of_copy_1;
    wire copy_hit = |{term_8, copy_slot};
    wire term_9 = out_queue_in_ready & ~((term_8 & &in_flight_0) | (copy_slot & &in_flight_1));
    wire send = term_7 & (copy_hit & term_9);
    wire send_end = head_waits & (head_end & out_queue_in_ready);
    wire term_10 = send | send_end;
    wire held_leaves = holding & drain_step;
    wire close = (mode == 3'd7) & pixel_queue_in_ready;
    wire beat = take_data & data_valid;
    wire term_11 = term_1 & beat;
    wire [27:0] choice_12 = term_2 ? drain_weight : data_weight;
    wire visible = |choice_12;
    wire in_queue_out_end = in_queue_out_data[304];
    wire [25:0] in_queue_out_center_x = in_queue_out_data[303:278];
    wire [25:0] in_queue_out_center_y = in_queue_out_data[277:252];
    wire [15:0] in_queue_out_ax = in_queue_out_data[251:236];
    wire [15:0] in_queue_out_bx = in_queue_out_data[235:220];
    wire [15:0] in_queue_out_ay = in_queue_out_data[219:204];
    wire [15:0] in_queue_out_by = in_queue_out_data[203:188];
    wire [19:0] in_queue_out_delta = in_queue_out_data[187:168];
    wire [15:0] in_queue_out_mx = in_queue_out_data[167:152];
    wire [15:0] in_queue_out_my = in_queue_out_data[151:136];
    wire [3:0] in_queue_out_shift = in_queue_out_data[135:132];
    wire [23:0] in_queue_out_depth = in_queue_out_data[131:108];
    wire [23:0] in_queue_out_depth_low = in_queue_out_data[107:84];
    wire [23:0] in_queue_out_depth_high = in_queue_out_data[83:60];
    wire [11:0] in_queue_out_attribute_0 = in_queue_out_data[59:48];
    wire [11:0] in_queue_out_attribute_1 = in_queue_out_data[47:36];
    wire [11:0] in_queue_out_attribute_2 = in_queue_out_data[35:24];
    wire [2:0] in_queue_out_left = in_queue_out_data[23:21];
    wire [2:0] in_queue_out_right = in_queue_out_data[20:18];
    wire [2:0] in_queue_out_top = in_queue_out_data[17:15];
    wire [2:0] in_queue_out_bottom = in_queue_out_data[14:12];
    wire [11:0] in_queue_out_tile = in_queue_out_data[11:0];
    wire last_code = &code;
    wire term_13 = ~(looking | looked | moving);
    wire finish = (mode == 3'd2) & (frame_ended & term_13);
    wire term_14 = showing | holding;
    wire term_15 = (term_2 & (drained[6] & ~term_14)) | (term_1 & drained[6]);
    wire next_tile = term_15 | (term_5 & ~touched);
    wire sent_slot = resident_1 & is_of_code_1;
    wire sent_hit = |{resident_0 & is_of_code_0, sent_slot};
    wire [2:0] choice_16 = next_tile ? (last_code ? 3'd7 : 3'd3) : term_5 ? (sent_hit ? 3'd5 : 3'd6) : mode;
    wire [2:0] choice_17 = send_end ? 3'd2 : finish ? 3'd3 : (term_6 & code_read) ? 3'd4 : choice_16;
    wire term_18 = (~next & (in_flight_0 == 8'd0)) | (next & (in_flight_1 == 8'd0));
    wire start = term_7 & (~copy_hit & (term_13 & term_18));
    wire term_19 = ~evict | (drained[6] & ~(term_14 | write_queue_out_valid));
    wire done = moving & (filled[6] & (~fill_valid & term_19));
    wire term_20 = start | term_5;
    wire term_21 = touched & (looked | (term_5 & ~sent_hit));
    wire term_22 = looked | term_5;
    wire drain_next = drain_step & ~drained[6];
    wire fill = may_fill & (~load | data_valid);
    wire term_23 = start & ~next;
    wire term_24 = done & ~slot;
    wire term_25 = send & ~copy_slot;
    wire term_26 = retire_valid & ~retire_slot;
    wire term_27 = start & next;
    wire term_28 = done & slot;
    wire term_29 = send & copy_slot;
    wire term_30 = retire_valid & retire_slot;

    assign in_ready = in_queue_in_ready;
    assign out_valid = out_queue_out_valid;
    assign {
        out_end, out_center_x, out_center_y, out_ax, out_bx, out_ay, out_by, out_delta, out_mx, out_my,
        out_shift, out_depth, out_depth_low, out_depth_high, out_attribute_0, out_attribute_1,
        out_attribute_2, out_left, out_right, out_top, out_bottom, out_tile, out_slot
    } = out_queue_out_data;
    assign data_ready = take_data;
    assign write_valid = write_queue_out_valid;
    assign {
        write_tile, write_pixel, write_weight, write_depth, write_attribute_0, write_attribute_1,
        write_attribute_2
    } = write_queue_out_data;
    assign pixel_valid = pixel_queue_out_valid;
    assign {
        pixel_end, pixel_tile, pixel_pixel, pixel_weight, pixel_depth, pixel_attribute_0, pixel_attribute_1,
        pixel_attribute_2
    } = pixel_queue_out_data;
    assign slot_ready = {ready_1, ready_0};
    assign fill_slot = slot;
    assign drain_enable = drain_step;
    assign drain_slot = slot;
    assign drain_pixel = drained[5:0];

    memory_1w1r_unordered #(.WIDTH(1), .DEPTH(4096)) touched_tiles (
        .clk(clk),
        .write(looked | (term_4 | (term_5 & touched))), .write_address(looked ? read_tile : code),
        .write_data(looked),
        .read(1'd1), .read_address(term_6 ? code : head_tile), .read_data(stored_touched)
    );

    stream_half_buffer_w305 in_queue (
        .clk(clk), .rst(rst),
        .in_valid(in_valid), .in_ready(in_queue_in_ready),
        .in_data({
            in_end, in_center_x, in_center_y, in_ax, in_bx, in_ay, in_by, in_delta, in_mx, in_my, in_shift,
            in_depth, in_depth_low, in_depth_high, in_attribute_0, in_attribute_1, in_attribute_2, in_left,
            in_right, in_top, in_bottom, in_tile
        }),
        .out_valid(in_queue_out_valid), .out_ready(head_takes), .out_data(in_queue_out_data)
    );

    stream_half_buffer_w306 out_queue (
        .clk(clk), .rst(rst),
        .in_valid(term_10), .in_ready(out_queue_in_ready),
        .in_data({
            head_end, head_center_x, head_center_y, head_ax, head_bx, head_ay, head_by, head_delta, head_mx,
            head_my, head_shift, head_depth, head_depth_low, head_depth_high, head_attribute_0, head_attribute_1,
            head_attribute_2, head_left, head_right, head_top, head_bottom, head_tile, copy_slot
        }),
        .out_valid(out_queue_out_valid), .out_ready(out_ready), .out_data(out_queue_out_data)
    );

    stream_skid_w218 write_queue (
        .clk(clk), .rst(rst),
        .in_valid(moving & held_leaves), .in_ready(write_queue_in_ready),
        .in_data({
            evict_tile, held_pixel, drain_weight, drain_depth, drain_attribute_0, drain_attribute_1,
            drain_attribute_2
        }),
        .out_valid(write_queue_out_valid), .out_ready(write_ready), .out_data(write_queue_out_data)
    );

    stream_skid_w219 pixel_queue (
        .clk(clk), .rst(rst),
        .in_valid(close | (((term_2 & held_leaves) | term_11) & visible)), .in_ready(pixel_queue_in_ready),
        .in_data({
            close, code, term_2 ? held_pixel : drained[5:0], choice_12, term_2 ? drain_depth : data_depth,
            term_2 ? drain_attribute_0 : data_attribute_0, term_2 ? drain_attribute_1 : data_attribute_1,
            term_2 ? drain_attribute_2 : data_attribute_2
        }),
        .out_valid(pixel_queue_out_valid), .out_ready(pixel_ready), .out_data(pixel_queue_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            head_valid <= 1'd0;
            mode <= 3'd0;
            frame_ended <= 1'd0;
            code <= 12'd0;
            code_read <= 1'd0;
            looking <= 1'd0;
            looked <= 1'd0;
            moving <= 1'd0;
            read_valid <= 1'd0;
            showing <= 1'd0;
            holding <= 1'd0;
            next <= 1'd0;
            resident_0 <= 1'd0;
            ready_0 <= 1'd0;
            in_flight_0 <= 8'd0;
            resident_1 <= 1'd0;
            ready_1 <= 1'd0;
            in_flight_1 <= 8'd0;
            fill_valid <= 1'd0;
        end else begin
            head_valid <= head_valid ? ~term_10 : in_queue_out_valid;
            mode <= ((term_4 & last_code) | close) ? 3'd1 : choice_17;
            code_read <= term_6 & ~code_read;
            looking <= start;
            looked <= looking;
            fill_valid <= fill;
            if (frame_end | finish) frame_ended <= frame_end;
            if (term_4 | next_tile) code <= code + 12'd1;
            if (looked | done) moving <= looked;
            if (term_21 | read_ready) read_valid <= term_21;
            if (drain_step) begin
                showing <= drain_next;
                holding <= showing;
            end
            if (start | close) next <= (next | close) ? 1'd0 : (next + 1'd1);
            if (term_23 | close) resident_0 <= term_23;
            if (term_24 | term_23 | finish) ready_0 <= term_24;
            if (term_25 ^ term_26) begin
                in_flight_0 <= term_25 ? (in_flight_0 + 8'd1) : (in_flight_0 - 8'd1);
            end
            if (term_27 | close) resident_1 <= term_27;
            if (term_28 | term_27 | finish) ready_1 <= term_28;
            if (term_29 ^ term_30) begin
                in_flight_1 <= term_29 ? (in_flight_1 + 8'd1) : (in_flight_1 - 8'd1);
            end
        end
    end
    always @(posedge clk) begin
        if (head_takes) begin
            head_end <= in_queue_out_end;
            head_center_x <= in_queue_out_center_x;
            head_center_y <= in_queue_out_center_y;
            head_ax <= in_queue_out_ax;
            head_bx <= in_queue_out_bx;
            head_ay <= in_queue_out_ay;
            head_by <= in_queue_out_by;
            head_delta <= in_queue_out_delta;
            head_mx <= in_queue_out_mx;
            head_my <= in_queue_out_my;
            head_shift <= in_queue_out_shift;
            head_depth <= in_queue_out_depth;
            head_depth_low <= in_queue_out_depth_low;
            head_depth_high <= in_queue_out_depth_high;
            head_attribute_0 <= in_queue_out_attribute_0;
            head_attribute_1 <= in_queue_out_attribute_1;
            head_attribute_2 <= in_queue_out_attribute_2;
            head_left <= in_queue_out_left;
            head_right <= in_queue_out_right;
            head_top <= in_queue_out_top;
            head_bottom <= in_queue_out_bottom;
            head_tile <= in_queue_out_tile;
        end
        if (term_20) begin
            slot <= term_5 ? sent_slot : next;
            read_tile <= term_5 ? code : head_tile;
        end
        if (start) begin
            evict <= (~next & resident_0) | (next & resident_1);
            evict_tile <= ({12{~next}} & tile_0) | ({12{next}} & tile_1);
        end
        if (looked) load <= touched;
        if (term_22 | (drain_next | term_11)) drained <= term_22 ? 7'd0 : (drained + 7'd1);
        if (drain_next) shown_pixel <= drained[5:0];
        if (drain_step) held_pixel <= shown_pixel;
        if (term_22 | fill) filled <= term_22 ? 7'd0 : (filled + 7'd1);
        if (term_23) tile_0 <= head_tile;
        is_of_copy_0 <= head_takes ? (tile_0 == in_queue_out_tile) : (is_of_copy_0 | term_23);
        is_of_code_0 <= tile_0 == code;
        is_of_copy_1 <= head_takes ? (tile_1 == in_queue_out_tile) : (is_of_copy_1 | term_27);
        is_of_code_1 <= tile_1 == code;
        touched <= stored_touched;
        if (term_27) tile_1 <= head_tile;
        if (fill) begin
            fill_pixel <= filled[5:0];
            fill_weight <= load ? data_weight : 28'd0;
            fill_depth <= load ? data_depth : 52'd0;
            fill_attribute_0 <= load ? data_attribute_0 : 40'd0;
            fill_attribute_1 <= load ? data_attribute_1 : 40'd0;
            fill_attribute_2 <= load ? data_attribute_2 : 40'd0;
        end
    end

`ifdef RTL_ASSERT
    always @(posedge clk) begin
        if (!rst) begin
            if (!(~term_26 | |in_flight_0)) begin
`ifdef FORMAL
                slot_0_retires_what_entered: assert (0);
`else
                $display("assertion failed: slot_0_retires_what_entered in %m");
                $stop;
`endif
            end
            if (!(~term_30 | |in_flight_1)) begin
`ifdef FORMAL
                slot_1_retires_what_entered: assert (0);
`else
                $display("assertion failed: slot_1_retires_what_entered in %m");
                $stop;
`endif
            end
        end
    end
`endif
endmodule

// Queue of two in registers.
// width = 219
module stream_skid_w219 (
    input  wire clk,
    input  wire rst,
    input  wire in_valid,
    output wire in_ready,
    input  wire [218:0] in_data,
    output reg  out_valid,
    input  wire out_ready,
    output wire [218:0] out_data
);
    reg second_valid;
    reg [218:0] head, second;

    assign in_ready = ~second_valid;
    wire advance = ~out_valid | out_ready;
    wire some_item = second_valid | in_valid;

    assign out_data = head;

    always @(posedge clk) begin
        if (rst) begin
            out_valid <= 1'd0;
            second_valid <= 1'd0;
        end else begin
            if (advance) out_valid <= some_item;
            second_valid <= ~advance & some_item;
        end
    end
    always @(posedge clk) begin
        if (advance) head <= second_valid ? second : in_data;
        if (in_ready) second <= in_data;
    end

`ifdef RTL_ASSERT
    always @(posedge clk) begin
        if (!rst) begin
            if (!(out_valid | in_ready)) begin
`ifdef FORMAL
                second_waits_behind_head: assert (0);
`else
                $display("assertion failed: second_waits_behind_head in %m");
                $stop;
`endif
            end
        end
    end
`endif
endmodule

// Queue of two in registers.
// width = 218
module stream_skid_w218 (
    input  wire clk,
    input  wire rst,
    input  wire in_valid,
    output wire in_ready,
    input  wire [217:0] in_data,
    output reg  out_valid,
    input  wire out_ready,
    output wire [217:0] out_data
);
    reg second_valid;
    reg [217:0] head, second;

    assign in_ready = ~second_valid;
    wire advance = ~out_valid | out_ready;
    wire some_item = second_valid | in_valid;

    assign out_data = head;

    always @(posedge clk) begin
        if (rst) begin
            out_valid <= 1'd0;
            second_valid <= 1'd0;
        end else begin
            if (advance) out_valid <= some_item;
            second_valid <= ~advance & some_item;
        end
    end
    always @(posedge clk) begin
        if (advance) head <= second_valid ? second : in_data;
        if (in_ready) second <= in_data;
    end

`ifdef RTL_ASSERT
    always @(posedge clk) begin
        if (!rst) begin
            if (!(out_valid | in_ready)) begin
`ifdef FORMAL
                second_waits_behind_head: assert (0);
`else
                $display("assertion failed: second_waits_behind_head in %m");
                $stop;
`endif
            end
        end
    end
`endif
endmodule

// One item in a register, at half rate.
// width = 306
module stream_half_buffer_w306 (
    input  wire clk,
    input  wire rst,
    input  wire in_valid,
    output wire in_ready,
    input  wire [305:0] in_data,
    output wire out_valid,
    input  wire out_ready,
    output wire [305:0] out_data
);
    reg full;
    reg [305:0] item;

    assign in_ready = ~full;

    assign out_valid = full;
    assign out_data = item;

    always @(posedge clk) begin
        if (rst) begin
            full <= 1'd0;
        end else begin
            full <= full ? ~out_ready : in_valid;
        end
    end
    always @(posedge clk) begin
        if (in_ready) item <= in_data;
    end
endmodule

// Orders splat copies by tile; their payloads wait in a memory.
// levels = 10
module splat_reorder (
    input  wire clk,
    input  wire rst,
    input  wire in_valid,  // Copies in any order.
    output wire in_ready,
    input  wire in_end,  // Closes the frame.
    input  wire [25:0] in_center_x,  // Projected center (px), the origin of what follows.
    input  wire [25:0] in_center_y,  // Projected center (px), the origin of what follows.
    input  wire [15:0] in_ax,  // `A` in x.
    input  wire [15:0] in_bx,  // `B` in x.
    input  wire [15:0] in_ay,  // `A` in y.
    input  wire [15:0] in_by,  // `B` in y.
    input  wire [19:0] in_delta,  // The determinant of `A` and `B`.
    input  wire [15:0] in_mx,  // `m` in x.
    input  wire [15:0] in_my,  // `m` in y.
    input  wire [3:0] in_shift,  // In fixed point, places by which offsets from the centre are shifted.
    input  wire [23:0] in_depth,  // Depth.
    input  wire [23:0] in_depth_low,  // What is nearer hides the splat.
    input  wire [23:0] in_depth_high,  // What is farther is hidden by the splat.
    input  wire [11:0] in_attribute_0,  // Attributes.
    input  wire [11:0] in_attribute_1,  // Attributes.
    input  wire [11:0] in_attribute_2,  // Attributes.
    input  wire [2:0] in_left,  // First column.
    input  wire [2:0] in_right,  // Last column.
    input  wire [2:0] in_top,  // First row.
    input  wire [2:0] in_bottom,  // Last row.
    input  wire [11:0] in_tile,  // Tile index: row above column.
    output wire out_valid,  // Copies in order of tiles.
    input  wire out_ready,
    output wire out_end,  // Closes the frame.
    output wire [25:0] out_center_x,  // Projected center (px), the origin of what follows.
    output wire [25:0] out_center_y,  // Projected center (px), the origin of what follows.
    output wire [15:0] out_ax,  // `A` in x.
    output wire [15:0] out_bx,  // `B` in x.
    output wire [15:0] out_ay,  // `A` in y.
    output wire [15:0] out_by,  // `B` in y.
    output wire [19:0] out_delta,  // The determinant of `A` and `B`.
    output wire [15:0] out_mx,  // `m` in x.
    output wire [15:0] out_my,  // `m` in y.
    output wire [3:0] out_shift,  // In fixed point, places by which offsets from the centre are shifted.
    output wire [23:0] out_depth,  // Depth.
    output wire [23:0] out_depth_low,  // What is nearer hides the splat.
    output wire [23:0] out_depth_high,  // What is farther is hidden by the splat.
    output wire [11:0] out_attribute_0,  // Attributes.
    output wire [11:0] out_attribute_1,  // Attributes.
    output wire [11:0] out_attribute_2,  // Attributes.
    output wire [2:0] out_left,  // First column.
    output wire [2:0] out_right,  // Last column.
    output wire [2:0] out_top,  // First row.
    output wire [2:0] out_bottom,  // Last row.
    output wire [11:0] out_tile  // Tile index: row above column.
);
    reg free_valid;
    reg [9:0] free;
    reg [10:0] fresh;
    reg draining, stage_valid;
    reg [11:0] stage_tile;
    wire [291:0] stage_payload;

    wire in_queue_in_ready, in_queue_out_valid;
    wire [304:0] in_queue_out_data;
    wire out_queue_in_ready, out_queue_out_valid;
    wire [304:0] out_queue_out_data;
    wire caught_in_ready, caught_out_valid;
    wire [304:0] caught_out_data;
    wire heap_in_ready, heap_out_valid;
    wire [11:0] heap_out_tile;
    wire [9:0] heap_out_pointer;
    wire heap_empty, returned_in_ready, returned_out_valid;
    wire [9:0] returned_out_data;

    wire open = in_queue_out_valid & ~draining;
    wire in_queue_out_end = in_queue_out_data[304];
    wire offer = open & ~in_queue_out_end & free_valid;
    wire advance = ~stage_valid | caught_in_ready;
    wire insert = offer & heap_in_ready;
    wire take_end = open & in_queue_out_end;
    wire in_queue_out_ready = insert | take_end;
    wire close = draining & (heap_empty & ~stage_valid & caught_in_ready);
    wire [11:0] in_queue_out_tile = in_queue_out_data[11:0];
    wire leaving = heap_out_valid & advance;
    wire all_used = fresh[10];
    wire returned_out_ready = ~free_valid & all_used;

    assign in_ready = in_queue_in_ready;
    assign out_valid = out_queue_out_valid;
    assign {
        out_end, out_center_x, out_center_y, out_ax, out_bx, out_ay, out_by, out_delta, out_mx, out_my,
        out_shift, out_depth, out_depth_low, out_depth_high, out_attribute_0, out_attribute_1,
        out_attribute_2, out_left, out_right, out_top, out_bottom, out_tile
    } = out_queue_out_data;

    memory_1w1r_unordered #(.WIDTH(292), .DEPTH(1024), .SLICE(18)) payloads (
        .clk(clk),
        .write(offer), .write_address(free), .write_data(in_queue_out_data[303:12]),
        .read(advance), .read_address(heap_out_pointer), .read_data(stage_payload)
    );

    stream_half_buffer_w305 in_queue (
        .clk(clk), .rst(rst),
        .in_valid(in_valid), .in_ready(in_queue_in_ready),
        .in_data({
            in_end, in_center_x, in_center_y, in_ax, in_bx, in_ay, in_by, in_delta, in_mx, in_my, in_shift,
            in_depth, in_depth_low, in_depth_high, in_attribute_0, in_attribute_1, in_attribute_2, in_left,
            in_right, in_top, in_bottom, in_tile
        }),
        .out_valid(in_queue_out_valid), .out_ready(in_queue_out_ready), .out_data(in_queue_out_data)
    );

    stream_half_buffer_w305 out_queue (
        .clk(clk), .rst(rst),
        .in_valid(caught_out_valid & out_queue_in_ready), .in_ready(out_queue_in_ready),
        .in_data(caught_out_data),
        .out_valid(out_queue_out_valid), .out_ready(out_ready), .out_data(out_queue_out_data)
    );

    stream_half_buffer_w305 caught (
        .clk(clk), .rst(rst),
        .in_valid(close | (stage_valid & caught_in_ready)), .in_ready(caught_in_ready),
        .in_data({close, stage_payload, stage_tile}),
        .out_valid(caught_out_valid), .out_ready(out_queue_in_ready), .out_data(caught_out_data)
    );

    splat_heap heap (
        .clk(clk), .rst(rst),
        .in_valid(offer), .in_ready(heap_in_ready), .in_tile(in_queue_out_tile), .in_pointer(free),
        .out_valid(heap_out_valid), .out_ready(advance), .out_tile(heap_out_tile),
        .out_pointer(heap_out_pointer),
        .empty(heap_empty)
    );

    stream_fifo_d1024_w10 returned (
        .clk(clk), .rst(rst),
        .in_valid(leaving), .in_ready(returned_in_ready), .in_data(heap_out_pointer),
        .out_valid(returned_out_valid), .out_ready(returned_out_ready), .out_data(returned_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            free_valid <= 1'd0;
            fresh <= 11'd0;
            draining <= 1'd0;
            stage_valid <= 1'd0;
        end else begin
            free_valid <= free_valid ? ~insert : (~all_used | returned_out_valid);
            if (~(free_valid | all_used)) fresh <= fresh + 11'd1;
            if (take_end | close) draining <= take_end;
            if (advance) stage_valid <= leaving;
        end
    end
    always @(posedge clk) begin
        if (~free_valid) free <= all_used ? returned_out_data : fresh[9:0];
        if (advance) stage_tile <= heap_out_tile;
    end

    wire _unused = &{1'b0, returned_in_ready};

`ifdef RTL_ASSERT
    always @(posedge clk) begin
        if (!rst) begin
            if (!(~leaving | returned_in_ready)) begin
`ifdef FORMAL
                pointers_fit: assert (0);
`else
                $display("assertion failed: pointers_fit in %m");
                $stop;
`endif
            end
        end
    end
`endif
endmodule

// Queue in a memory with a registered output.
// depth = 1024
// width = 10
module stream_fifo_d1024_w10 (
    input  wire clk,
    input  wire rst,
    input  wire in_valid,
    output wire in_ready,
    input  wire [9:0] in_data,
    output reg  out_valid,
    input  wire out_ready,
    output wire [9:0] out_data
);
    reg [10:0] held, waiting;
    reg [9:0] write_address, read_address;
    wire [9:0] item;

    wire has_room = ~held[10];
    wire push = in_valid & has_room;
    wire fetch = |waiting & (~out_valid | out_ready);
    wire pop = out_valid & out_ready;

    assign in_ready = has_room;
    assign out_data = item;

    memory_1w1r_unordered #(.WIDTH(10), .DEPTH(1024)) entries (
        .clk(clk),
        .write(push), .write_address(write_address), .write_data(in_data),
        .read(fetch), .read_address(read_address), .read_data(item)
    );

    always @(posedge clk) begin
        if (rst) begin
            held <= 11'd0;
            waiting <= 11'd0;
            write_address <= 10'd0;
            read_address <= 10'd0;
            out_valid <= 1'd0;
        end else begin
            held <= (held + {10'd0, push}) - {10'd0, pop};
            waiting <= (waiting + {10'd0, push}) - {10'd0, fetch};
            out_valid <= fetch | (out_valid & ~out_ready);
            if (push) write_address <= write_address + 10'd1;
            if (fetch) read_address <= read_address + 10'd1;
        end
    end

`ifdef RTL_ASSERT
    always @(posedge clk) begin
        if (!rst) begin
            if (!(held <= 11'h400)) begin
`ifdef FORMAL
                held_in_range: assert (0);
`else
                $display("assertion failed: held_in_range in %m");
                $stop;
`endif
            end
            if (!(held == (waiting + {10'd0, out_valid}))) begin
`ifdef FORMAL
                held_is_waiting_and_shown: assert (0);
`else
                $display("assertion failed: held_is_waiting_and_shown in %m");
                $stop;
`endif
            end
        end
    end
`endif
endmodule

// Pipelined heap that orders splat copies by tile, then by arrival.
// levels = 10
// interval = 2
// sequence_bits = 14
module splat_heap (
    input  wire clk,
    input  wire rst,
    input  wire in_valid,  // Entries in any order.
    output wire in_ready,
    input  wire [11:0] in_tile,  // Tile index.
    input  wire [9:0] in_pointer,  // Place of the payload.
    output wire out_valid,  // Entries in order.
    input  wire out_ready,
    output wire [11:0] out_tile,  // Tile index.
    output wire [9:0] out_pointer,  // Place of the payload.
    output wire empty  // It holds no entry.
);
    reg lower;
    reg [9:0] count;
    reg [13:0] arrival;
    reg [9:0] alive_even, alive_odd;
    reg occupied, full, fresh_epoch_blocked;
    reg [11:0] current;
    reg lap, last_epoch;
    reg [11:0] newcomer_tile;

    wire out_queue_in_ready, out_queue_out_valid;
    wire [21:0] out_queue_out_data;
    wire [36:0] stage_0_root;
    wire stage_0_below_valid, stage_0_below_hole, stage_0_below_carry, stage_0_below_right;
    wire stage_0_below_left_exists, stage_0_below_right_exists, stage_0_below_follows;
    wire [36:0] stage_0_below_entry;
    wire [26:0] stage_0_below_sibling;
    wire [1:0] stage_0_below_row;
    wire [36:0] stage_2_promoted_entry;
    wire stage_2_promoted_exists, stage_2_promoted_ahead, stage_2_promoted_right, stage_2_promoted_childless;
    wire [1:0] stage_2_promoted_node;
    wire stage_2_below_valid, stage_2_below_hole, stage_2_below_carry, stage_2_below_right;
    wire stage_2_below_left_exists, stage_2_below_right_exists, stage_2_below_follows;
    wire [36:0] stage_2_below_entry;
    wire [26:0] stage_2_below_sibling;
    wire [3:0] stage_2_below_row;
    wire [36:0] stage_4_promoted_entry;
    wire stage_4_promoted_exists, stage_4_promoted_ahead, stage_4_promoted_right, stage_4_promoted_childless;
    wire [3:0] stage_4_promoted_node;
    wire stage_4_below_valid, stage_4_below_hole, stage_4_below_carry, stage_4_below_right;
    wire stage_4_below_left_exists, stage_4_below_right_exists, stage_4_below_follows;
    wire [36:0] stage_4_below_entry;
    wire [26:0] stage_4_below_sibling;
    wire [5:0] stage_4_below_row;
    wire [36:0] stage_6_promoted_entry;
    wire stage_6_promoted_exists, stage_6_promoted_ahead, stage_6_promoted_right, stage_6_promoted_childless;
    wire [5:0] stage_6_promoted_node;
    wire stage_6_below_valid, stage_6_below_hole, stage_6_below_carry, stage_6_below_right;
    wire stage_6_below_left_exists, stage_6_below_right_exists, stage_6_below_follows;
    wire [36:0] stage_6_below_entry;
    wire [26:0] stage_6_below_sibling;
    wire [7:0] stage_6_below_row;
    wire [36:0] stage_8_promoted_entry;
    wire stage_8_promoted_exists, stage_8_promoted_ahead, stage_8_promoted_right, stage_8_promoted_childless;
    wire [7:0] stage_8_promoted_node;

    wire begins = ~lower;
    wire pop = begins & (occupied & out_queue_in_ready);
    wire ready = begins & ~fresh_epoch_blocked & (~full | pop);
    wire push = ready & in_valid;
    wire newcomer_lap = lap ^ (newcomer_tile < current);
    wire term_1 = push & ~arrival[13];
    wire term_2 = push & arrival[13];

    assign in_ready = ready;
    assign out_valid = out_queue_out_valid;
    assign {out_tile, out_pointer} = out_queue_out_data;
    assign empty = ~(|count | out_queue_out_valid);

    stream_skid_w22 out_queue (
        .clk(clk), .rst(rst),
        .in_valid(pop), .in_ready(out_queue_in_ready), .in_data({stage_0_root[35:24], stage_0_root[9:0]}),
        .out_valid(out_queue_out_valid), .out_ready(out_ready), .out_data(out_queue_out_data)
    );

    splat_heap_stage_l0 stage_0 (
        .clk(clk), .rst(rst), .lap(lap),
        .last_epoch(last_epoch),
        .step_valid(push | pop), .step_hole(pop), .step_carry(push), .step_right(1'd1),
        .step_left_exists(1'd0), .step_right_exists(occupied), .step_follows(1'd1),
        .step_entry({1'd0, in_tile, arrival, in_pointer}), .step_sibling(27'd0),
        .newcomer_lap(newcomer_lap),
        .below_promoted_entry(stage_2_promoted_entry), .below_promoted_exists(stage_2_promoted_exists),
        .below_promoted_ahead(stage_2_promoted_ahead), .below_promoted_right(stage_2_promoted_right),
        .below_promoted_childless(stage_2_promoted_childless), .below_promoted_node(stage_2_promoted_node),
        .root(stage_0_root),
        .below_valid(stage_0_below_valid), .below_hole(stage_0_below_hole), .below_carry(stage_0_below_carry),
        .below_right(stage_0_below_right), .below_left_exists(stage_0_below_left_exists),
        .below_right_exists(stage_0_below_right_exists), .below_follows(stage_0_below_follows),
        .below_entry(stage_0_below_entry), .below_sibling(stage_0_below_sibling),
        .below_row(stage_0_below_row)
    );

    splat_heap_stage_l2 stage_2 (
        .clk(clk), .rst(rst), .lap(lap),
        .last_epoch(last_epoch),
        .step_valid(stage_0_below_valid), .step_hole(stage_0_below_hole), .step_carry(stage_0_below_carry),
        .step_right(stage_0_below_right), .step_left_exists(stage_0_below_left_exists),
        .step_right_exists(stage_0_below_right_exists), .step_follows(stage_0_below_follows),
        .step_entry(stage_0_below_entry), .step_sibling(stage_0_below_sibling), .step_row(stage_0_below_row),
        .below_promoted_entry(stage_4_promoted_entry), .below_promoted_exists(stage_4_promoted_exists),
        .below_promoted_ahead(stage_4_promoted_ahead), .below_promoted_right(stage_4_promoted_right),
        .below_promoted_childless(stage_4_promoted_childless), .below_promoted_node(stage_4_promoted_node),
        .promoted_entry(stage_2_promoted_entry), .promoted_exists(stage_2_promoted_exists),
        .promoted_ahead(stage_2_promoted_ahead), .promoted_right(stage_2_promoted_right),
        .promoted_childless(stage_2_promoted_childless), .promoted_node(stage_2_promoted_node),
        .below_valid(stage_2_below_valid), .below_hole(stage_2_below_hole), .below_carry(stage_2_below_carry),
        .below_right(stage_2_below_right), .below_left_exists(stage_2_below_left_exists),
        .below_right_exists(stage_2_below_right_exists), .below_follows(stage_2_below_follows),
        .below_entry(stage_2_below_entry), .below_sibling(stage_2_below_sibling),
        .below_row(stage_2_below_row)
    );

    splat_heap_stage_l4 stage_4 (
        .clk(clk), .rst(rst), .lap(lap),
        .last_epoch(last_epoch),
        .step_valid(stage_2_below_valid), .step_hole(stage_2_below_hole), .step_carry(stage_2_below_carry),
        .step_right(stage_2_below_right), .step_left_exists(stage_2_below_left_exists),
        .step_right_exists(stage_2_below_right_exists), .step_follows(stage_2_below_follows),
        .step_entry(stage_2_below_entry), .step_sibling(stage_2_below_sibling), .step_row(stage_2_below_row),
        .below_promoted_entry(stage_6_promoted_entry), .below_promoted_exists(stage_6_promoted_exists),
        .below_promoted_ahead(stage_6_promoted_ahead), .below_promoted_right(stage_6_promoted_right),
        .below_promoted_childless(stage_6_promoted_childless), .below_promoted_node(stage_6_promoted_node),
        .promoted_entry(stage_4_promoted_entry), .promoted_exists(stage_4_promoted_exists),
        .promoted_ahead(stage_4_promoted_ahead), .promoted_right(stage_4_promoted_right),
        .promoted_childless(stage_4_promoted_childless), .promoted_node(stage_4_promoted_node),
        .below_valid(stage_4_below_valid), .below_hole(stage_4_below_hole), .below_carry(stage_4_below_carry),
        .below_right(stage_4_below_right), .below_left_exists(stage_4_below_left_exists),
        .below_right_exists(stage_4_below_right_exists), .below_follows(stage_4_below_follows),
        .below_entry(stage_4_below_entry), .below_sibling(stage_4_below_sibling),
        .below_row(stage_4_below_row)
    );

    splat_heap_stage_l6 stage_6 (
        .clk(clk), .rst(rst), .lap(lap),
        .last_epoch(last_epoch),
        .step_valid(stage_4_below_valid), .step_hole(stage_4_below_hole), .step_carry(stage_4_below_carry),
        .step_right(stage_4_below_right), .step_left_exists(stage_4_below_left_exists),
        .step_right_exists(stage_4_below_right_exists), .step_follows(stage_4_below_follows),
        .step_entry(stage_4_below_entry), .step_sibling(stage_4_below_sibling), .step_row(stage_4_below_row),
        .below_promoted_entry(stage_8_promoted_entry), .below_promoted_exists(stage_8_promoted_exists),
        .below_promoted_ahead(stage_8_promoted_ahead), .below_promoted_right(stage_8_promoted_right),
        .below_promoted_childless(stage_8_promoted_childless), .below_promoted_node(stage_8_promoted_node),
        .promoted_entry(stage_6_promoted_entry), .promoted_exists(stage_6_promoted_exists),
        .promoted_ahead(stage_6_promoted_ahead), .promoted_right(stage_6_promoted_right),
        .promoted_childless(stage_6_promoted_childless), .promoted_node(stage_6_promoted_node),
        .below_valid(stage_6_below_valid), .below_hole(stage_6_below_hole), .below_carry(stage_6_below_carry),
        .below_right(stage_6_below_right), .below_left_exists(stage_6_below_left_exists),
        .below_right_exists(stage_6_below_right_exists), .below_follows(stage_6_below_follows),
        .below_entry(stage_6_below_entry), .below_sibling(stage_6_below_sibling),
        .below_row(stage_6_below_row)
    );

    splat_heap_stage_l8 stage_8 (
        .clk(clk), .rst(rst), .lap(lap),
        .last_epoch(last_epoch),
        .step_valid(stage_6_below_valid), .step_hole(stage_6_below_hole), .step_carry(stage_6_below_carry),
        .step_right(stage_6_below_right), .step_left_exists(stage_6_below_left_exists),
        .step_right_exists(stage_6_below_right_exists), .step_follows(stage_6_below_follows),
        .step_entry(stage_6_below_entry), .step_sibling(stage_6_below_sibling), .step_row(stage_6_below_row),
        .promoted_entry(stage_8_promoted_entry), .promoted_exists(stage_8_promoted_exists),
        .promoted_ahead(stage_8_promoted_ahead), .promoted_right(stage_8_promoted_right),
        .promoted_childless(stage_8_promoted_childless), .promoted_node(stage_8_promoted_node)
    );

    always @(posedge clk) begin
        if (rst) begin
            lower <= 1'd0;
            count <= 10'd0;
            arrival <= 14'd0;
            alive_even <= 10'd0;
            alive_odd <= 10'd0;
            occupied <= 1'd0;
            full <= 1'd0;
            fresh_epoch_blocked <= 1'd0;
            current <= 12'd0;
            lap <= 1'd0;
        end else begin
            lower <= begins;
            occupied <= |count;
            full <= &count;
            fresh_epoch_blocked <= (arrival[12:0] == 13'd0) & (arrival[13] ? |alive_odd : |alive_even);
            if (push ^ pop) count <= push ? (count + 10'd1) : (count - 10'd1);
            if (push) arrival <= arrival + 14'd1;
            if (term_1 ^ (pop & ~stage_0_root[23])) begin
                alive_even <= term_1 ? (alive_even + 10'd1) : (alive_even - 10'd1);
            end
            if (term_2 ^ (pop & stage_0_root[23])) begin
                alive_odd <= term_2 ? (alive_odd + 10'd1) : (alive_odd - 10'd1);
            end
            if (pop) begin
                current <= stage_0_root[35:24];
                lap <= stage_0_root[36];
            end
        end
    end
    always @(posedge clk) begin
        if (push) last_epoch <= arrival[13];
        newcomer_tile <= in_tile;
    end

    wire _unused = &{1'b0, stage_0_root[22:10]};
endmodule

// Two neighboring levels of the pipelined heap.
// level = 8
// levels = 10
// interval = 2
module splat_heap_stage_l8 (
    input  wire clk,
    input  wire rst,
    input  wire lap,
    input  wire last_epoch,
    input  wire step_valid,
    input  wire step_hole,
    input  wire step_carry,
    input  wire step_right,
    input  wire step_left_exists,
    input  wire step_right_exists,
    input  wire step_follows,
    input  wire [36:0] step_entry,
    input  wire [26:0] step_sibling,
    input  wire [7:0] step_row,
    output wire [36:0] promoted_entry,
    output wire promoted_exists,
    output wire promoted_ahead,
    output wire promoted_right,
    output wire promoted_childless,
    output wire [7:0] promoted_node
);
    reg lower, compared_valid, compared_hole, compared_carry, compared_follows;
    reg [36:0] compared_carried;
    reg compared_exists, compared_right, compared_was_first;
    reg [26:0] compared_parent_sibling;
    reg compared_chosen_stored, compared_sibling_stored;
    reg [26:0] compared_sibling;
    reg compared_sibling_exists, compared_sibling_mark;
    reg [36:0] compared_entry;
    reg compared_right_below, compared_left_count, write_back_valid, write_back_hole, write_back_carry;
    reg write_back_existed, write_back_ahead, write_back_sibling_exists, write_back_sibling_mark;
    reg [36:0] write_back_entry;
    reg write_back_right_below, write_back_left_count;
    reg [39:0] stored;
    reg [8:0] row, row_before;
    reg [9:0] last_row, last_row_before;
    wire [39:0] left_shown, right_shown;

    wire [36:0] chosen_entry = compared_chosen_stored ? stored[39:3] : compared_entry;
    wire term_1 = compared_carried[36] == lap;
    wire [25:0] joined_2 = {compared_carried[35:24], compared_carried[23] == last_epoch, compared_carried[22:10]};
    wire [25:0] joined_3 = {chosen_entry[35:24], chosen_entry[23] == last_epoch, chosen_entry[22:10]};
    wire before_chosen = (compared_carried[36] ^ chosen_entry[36]) ? term_1 : (joined_2 < joined_3);
    wire carried_first = compared_carry & (~compared_exists | before_chosen);
    wire [36:0] first = carried_first ? compared_carried : chosen_entry;
    wire [25:0] joined_4 = {
        compared_parent_sibling[25:14], compared_parent_sibling[13] == last_epoch,
        compared_parent_sibling[12:0]
    };
    wire sibling_stays = (compared_parent_sibling[26] ^ chosen_entry[36]) ? (compared_parent_sibling[26] == lap) : (joined_4 < joined_3);
    wire term_5 = compared_exists & ~sibling_stays;
    wire chosen_left_count = compared_chosen_stored ? stored[0] : compared_left_count;
    wire chosen_right_below = compared_chosen_stored ? stored[1] : compared_right_below;
    wire term_6 = ~(chosen_left_count | chosen_right_below);
    wire [9:0] choice_7 = lower ? last_row_before : {1'd0, row_before};
    wire side = choice_7[0];
    wire [36:0] entry_to_store = (write_back_hole & ~lower) ? first : write_back_entry;
    wire choice_8 = lower ? 1'd0 : compared_exists;
    wire term_9 = ~write_back_sibling_exists | write_back_ahead | (lower ? 1'd0 : term_5);
    wire is_first = write_back_hole ? ((write_back_carry | choice_8) & term_9) : write_back_ahead;
    wire first_side = side ^ ~is_first;
    wire term_10 = first_side ^ (write_back_sibling_exists & write_back_sibling_mark);
    wire term_11 = write_back_hole & ~write_back_carry & choice_8;
    wire choice_12 = lower ? 1'd0 : compared_right;
    wire term_13 = write_back_right_below & ~(term_11 & choice_12 & (lower ? 1'd0 : term_6));
    wire term_14 = ~write_back_hole & write_back_existed;
    wire term_15 = ~choice_12;
    wire sum_16 = write_back_left_count + ((term_11 & term_15) | (term_14 & term_15));
    wire [39:0] node_to_store = {entry_to_store, term_10, term_13 | (term_14 & choice_12), sum_16};
    wire choice_17 = lower ? compared_hole : step_hole;
    wire choice_18 = lower ? chosen_left_count : step_left_exists;
    wire choice_19 = lower ? chosen_right_below : step_right_exists;
    wire choice_20 = lower ? compared_follows : step_follows;
    wire newer = choice_20 & write_back_valid;
    wire choice_21 = (choice_18 & choice_19) ? (newer ? first_side : (left_shown[2] ^ right_shown[2])) : choice_19;
    wire goes_right = choice_17 ? choice_21 : lower ? (chosen_left_count | ~lower) : step_right;
    wire [9:0] next_row = {row, goes_right};
    wire [8:0] choice_22 = lower ? {1'd0, step_row} : next_row[8:0];
    wire same_side = goes_right ^ ~side;
    wire [26:0] sibling = compared_sibling_stored ? stored[39:13] : compared_sibling;
    wire [36:0] choice_23 = ~goes_right ? right_shown[39:3] : left_shown[39:3];
    wire [25:0] joined_24 = {sibling[25:14], sibling[13] == last_epoch, sibling[12:0]};
    wire before_sibling = (compared_carried[36] ^ sibling[26]) ? term_1 : (joined_2 < joined_24);
    wire term_25 = carried_first & (before_sibling | ~compared_sibling_exists);

    assign promoted_entry = first;
    assign promoted_exists = compared_exists;
    assign promoted_ahead = term_5;
    assign promoted_right = compared_right;
    assign promoted_childless = term_6;
    assign promoted_node = row_before[7:0];

    memory_1w1r_unordered #(.WIDTH(40), .DEPTH(512)) left_nodes (
        .clk(clk),
        .write(write_back_valid & ~side), .write_address(choice_7[9:1]), .write_data(node_to_store),
        .read(1'd1), .read_address(choice_22), .read_data(left_shown)
    );

    memory_1w1r_unordered #(.WIDTH(40), .DEPTH(512)) right_nodes (
        .clk(clk),
        .write(write_back_valid & side), .write_address(choice_7[9:1]), .write_data(node_to_store),
        .read(1'd1), .read_address(choice_22), .read_data(right_shown)
    );

    always @(posedge clk) begin
        if (rst) begin
            lower <= 1'd0;
            compared_valid <= 1'd0;
            write_back_valid <= 1'd0;
        end else begin
            lower <= ~lower;
            compared_valid <= lower ? (compared_valid & compared_exists) : step_valid;
            write_back_valid <= compared_valid & (compared_exists | ~compared_hole);
        end
    end
    always @(posedge clk) begin
        compared_hole <= choice_17;
        compared_carry <= lower ? compared_carry : step_carry;
        compared_follows <= choice_20 & same_side;
        compared_carried <= lower ? (carried_first ? chosen_entry : compared_carried) : step_entry;
        compared_exists <= goes_right ? choice_19 : choice_18;
        compared_right <= goes_right;
        compared_was_first <= goes_right == choice_21;
        compared_parent_sibling <= lower ? sibling : step_sibling;
        compared_chosen_stored <= newer & same_side;
        compared_sibling_stored <= newer & ~same_side;
        compared_sibling <= choice_23[36:10];
        compared_sibling_exists <= goes_right ? choice_18 : choice_19;
        compared_sibling_mark <= ~goes_right ? right_shown[2] : left_shown[2];
        compared_entry <= goes_right ? right_shown[39:3] : left_shown[39:3];
        compared_right_below <= goes_right ? right_shown[1] : left_shown[1];
        compared_left_count <= goes_right ? right_shown[0] : left_shown[0];
        write_back_hole <= compared_hole;
        write_back_carry <= compared_carry;
        write_back_existed <= compared_exists;
        write_back_ahead <= compared_hole ? (compared_carry & before_sibling) : ((compared_exists & compared_was_first) | term_25);
        write_back_sibling_exists <= compared_sibling_exists;
        write_back_sibling_mark <= compared_sibling_stored ? stored[2] : compared_sibling_mark;
        write_back_entry <= (carried_first ^ (compared_hole & ~lower)) ? compared_carried : chosen_entry;
        write_back_right_below <= chosen_right_below & compared_exists;
        write_back_left_count <= chosen_left_count & compared_exists;
        stored <= node_to_store;
        row <= choice_22;
        row_before <= row;
        last_row <= next_row;
        last_row_before <= last_row;
    end

    wire _unused = &{1'b0, choice_23[9:0]};
endmodule

// Two neighboring levels of the pipelined heap.
// level = 6
// levels = 10
// interval = 2
module splat_heap_stage_l6 (
    input  wire clk,
    input  wire rst,
    input  wire lap,
    input  wire last_epoch,
    input  wire step_valid,
    input  wire step_hole,
    input  wire step_carry,
    input  wire step_right,
    input  wire step_left_exists,
    input  wire step_right_exists,
    input  wire step_follows,
    input  wire [36:0] step_entry,
    input  wire [26:0] step_sibling,
    input  wire [5:0] step_row,
    input  wire [36:0] below_promoted_entry,
    input  wire below_promoted_exists,
    input  wire below_promoted_ahead,
    input  wire below_promoted_right,
    input  wire below_promoted_childless,
    input  wire [7:0] below_promoted_node,
    output wire [36:0] promoted_entry,
    output wire promoted_exists,
    output wire promoted_ahead,
    output wire promoted_right,
    output wire promoted_childless,
    output wire [5:0] promoted_node,
    output wire below_valid,
    output wire below_hole,
    output wire below_carry,
    output wire below_right,
    output wire below_left_exists,
    output wire below_right_exists,
    output wire below_follows,
    output wire [36:0] below_entry,
    output wire [26:0] below_sibling,
    output wire [7:0] below_row
);
    reg lower, compared_valid, compared_hole, compared_carry, compared_follows;
    reg [36:0] compared_carried;
    reg compared_exists, compared_right, compared_was_first;
    reg [26:0] compared_parent_sibling;
    reg compared_chosen_stored, compared_sibling_stored;
    reg [26:0] compared_sibling;
    reg compared_sibling_exists, compared_sibling_mark;
    reg [36:0] compared_entry;
    reg compared_right_below;
    reg [2:0] compared_left_count;
    reg write_back_valid, write_back_hole, write_back_carry, write_back_existed, write_back_ahead;
    reg write_back_sibling_exists, write_back_sibling_mark;
    reg [36:0] write_back_entry;
    reg write_back_right_below;
    reg [2:0] write_back_left_count;
    reg [41:0] stored;
    reg [6:0] row, row_before;
    wire [41:0] left_shown, right_shown;

    wire [36:0] chosen_entry = compared_chosen_stored ? stored[41:5] : compared_entry;
    wire term_1 = compared_carried[36] == lap;
    wire [25:0] joined_2 = {compared_carried[35:24], compared_carried[23] == last_epoch, compared_carried[22:10]};
    wire [25:0] joined_3 = {chosen_entry[35:24], chosen_entry[23] == last_epoch, chosen_entry[22:10]};
    wire before_chosen = (compared_carried[36] ^ chosen_entry[36]) ? term_1 : (joined_2 < joined_3);
    wire carried_first = compared_carry & (~compared_exists | before_chosen);
    wire [36:0] first = carried_first ? compared_carried : chosen_entry;
    wire [25:0] joined_4 = {
        compared_parent_sibling[25:14], compared_parent_sibling[13] == last_epoch,
        compared_parent_sibling[12:0]
    };
    wire sibling_stays = (compared_parent_sibling[26] ^ chosen_entry[36]) ? (compared_parent_sibling[26] == lap) : (joined_4 < joined_3);
    wire term_5 = compared_exists & ~sibling_stays;
    wire [2:0] chosen_left_count = compared_chosen_stored ? stored[2:0] : compared_left_count;
    wire chosen_right_below = compared_chosen_stored ? stored[3] : compared_right_below;
    wire term_6 = ~(|chosen_left_count | chosen_right_below);
    wire term_7 = compared_valid & compared_exists;
    wire term_8 = &chosen_left_count[1:0] & (chosen_left_count[2] | ~lower);
    wire [36:0] choice_9 = carried_first ? chosen_entry : compared_carried;
    wire [26:0] sibling = compared_sibling_stored ? stored[41:15] : compared_sibling;
    wire choice_10 = lower ? compared_hole : step_hole;
    wire choice_11 = lower ? |chosen_left_count : step_left_exists;
    wire choice_12 = lower ? chosen_right_below : step_right_exists;
    wire choice_13 = lower ? compared_follows : step_follows;
    wire newer = choice_13 & write_back_valid;
    wire [7:0] choice_14 = lower ? below_promoted_node : {1'd0, row_before};
    wire side = choice_14[0];
    wire choice_15 = lower ? below_promoted_exists : compared_exists;
    wire term_16 = ~write_back_sibling_exists | write_back_ahead | (lower ? below_promoted_ahead : term_5);
    wire is_first = write_back_hole ? ((write_back_carry | choice_15) & term_16) : write_back_ahead;
    wire first_side = side ^ ~is_first;
    wire choice_17 = (choice_11 & choice_12) ? (newer ? first_side : (left_shown[4] ^ right_shown[4])) : choice_12;
    wire goes_right = choice_10 ? choice_17 : lower ? term_8 : step_right;
    wire [7:0] next_row = {row, goes_right};
    wire [36:0] entry_to_store = write_back_hole ? (lower ? below_promoted_entry : first) : write_back_entry;
    wire term_18 = first_side ^ (write_back_sibling_exists & write_back_sibling_mark);
    wire term_19 = write_back_hole & ~write_back_carry & choice_15;
    wire choice_20 = lower ? below_promoted_right : compared_right;
    wire term_21 = term_19 & choice_20 & (lower ? below_promoted_childless : term_6);
    wire term_22 = ~write_back_hole & write_back_existed;
    wire term_23 = (write_back_right_below & ~term_21) | (term_22 & choice_20);
    wire term_24 = ~choice_20;
    wire term_25 = term_19 & term_24;
    wire [2:0] sum_26 = write_back_left_count + {{2{term_25}}, term_25 | (term_22 & term_24)};
    wire [41:0] node_to_store = {entry_to_store, term_18, term_23, sum_26};
    wire [6:0] choice_27 = lower ? {1'd0, step_row} : next_row[6:0];
    wire same_side = goes_right ^ ~side;
    wire [36:0] choice_28 = ~goes_right ? right_shown[41:5] : left_shown[41:5];
    wire [25:0] joined_29 = {sibling[25:14], sibling[13] == last_epoch, sibling[12:0]};
    wire before_sibling = (compared_carried[36] ^ sibling[26]) ? term_1 : (joined_2 < joined_29);
    wire term_30 = carried_first & (before_sibling | ~compared_sibling_exists);

    assign promoted_entry = first;
    assign promoted_exists = compared_exists;
    assign promoted_ahead = term_5;
    assign promoted_right = compared_right;
    assign promoted_childless = term_6;
    assign promoted_node = row_before[5:0];
    assign below_valid = term_7;
    assign below_hole = compared_hole;
    assign below_carry = compared_carry;
    assign below_right = term_8;
    assign below_left_exists = |chosen_left_count;
    assign below_right_exists = chosen_right_below;
    assign below_follows = compared_follows;
    assign below_entry = choice_9;
    assign below_sibling = sibling;
    assign below_row = next_row;

    memory_1w1r_unordered #(.WIDTH(42), .DEPTH(128)) left_nodes (
        .clk(clk),
        .write(write_back_valid & ~side), .write_address(choice_14[7:1]), .write_data(node_to_store),
        .read(1'd1), .read_address(choice_27), .read_data(left_shown)
    );

    memory_1w1r_unordered #(.WIDTH(42), .DEPTH(128)) right_nodes (
        .clk(clk),
        .write(write_back_valid & side), .write_address(choice_14[7:1]), .write_data(node_to_store),
        .read(1'd1), .read_address(choice_27), .read_data(right_shown)
    );

    always @(posedge clk) begin
        if (rst) begin
            lower <= 1'd0;
            compared_valid <= 1'd0;
            write_back_valid <= 1'd0;
        end else begin
            lower <= ~lower;
            compared_valid <= lower ? term_7 : step_valid;
            write_back_valid <= compared_valid & (compared_exists | ~compared_hole);
        end
    end
    always @(posedge clk) begin
        compared_hole <= choice_10;
        compared_carry <= lower ? compared_carry : step_carry;
        compared_follows <= choice_13 & same_side;
        compared_carried <= lower ? choice_9 : step_entry;
        compared_exists <= goes_right ? choice_12 : choice_11;
        compared_right <= goes_right;
        compared_was_first <= goes_right == choice_17;
        compared_parent_sibling <= lower ? sibling : step_sibling;
        compared_chosen_stored <= newer & same_side;
        compared_sibling_stored <= newer & ~same_side;
        compared_sibling <= choice_28[36:10];
        compared_sibling_exists <= goes_right ? choice_11 : choice_12;
        compared_sibling_mark <= ~goes_right ? right_shown[4] : left_shown[4];
        compared_entry <= goes_right ? right_shown[41:5] : left_shown[41:5];
        compared_right_below <= goes_right ? right_shown[3] : left_shown[3];
        compared_left_count <= goes_right ? right_shown[2:0] : left_shown[2:0];
        write_back_hole <= compared_hole;
        write_back_carry <= compared_carry;
        write_back_existed <= compared_exists;
        write_back_ahead <= compared_hole ? (compared_carry & before_sibling) : ((compared_exists & compared_was_first) | term_30);
        write_back_sibling_exists <= compared_sibling_exists;
        write_back_sibling_mark <= compared_sibling_stored ? stored[4] : compared_sibling_mark;
        write_back_entry <= first;
        write_back_right_below <= chosen_right_below & compared_exists;
        write_back_left_count <= chosen_left_count & {3{compared_exists}};
        stored <= node_to_store;
        row <= choice_27;
        row_before <= row;
    end

    wire _unused = &{1'b0, choice_28[9:0]};
endmodule

// Two neighboring levels of the pipelined heap.
// level = 4
// levels = 10
// interval = 2
module splat_heap_stage_l4 (
    input  wire clk,
    input  wire rst,
    input  wire lap,
    input  wire last_epoch,
    input  wire step_valid,
    input  wire step_hole,
    input  wire step_carry,
    input  wire step_right,
    input  wire step_left_exists,
    input  wire step_right_exists,
    input  wire step_follows,
    input  wire [36:0] step_entry,
    input  wire [26:0] step_sibling,
    input  wire [3:0] step_row,
    input  wire [36:0] below_promoted_entry,
    input  wire below_promoted_exists,
    input  wire below_promoted_ahead,
    input  wire below_promoted_right,
    input  wire below_promoted_childless,
    input  wire [5:0] below_promoted_node,
    output wire [36:0] promoted_entry,
    output wire promoted_exists,
    output wire promoted_ahead,
    output wire promoted_right,
    output wire promoted_childless,
    output wire [3:0] promoted_node,
    output wire below_valid,
    output wire below_hole,
    output wire below_carry,
    output wire below_right,
    output wire below_left_exists,
    output wire below_right_exists,
    output wire below_follows,
    output wire [36:0] below_entry,
    output wire [26:0] below_sibling,
    output wire [5:0] below_row
);
    reg lower, compared_valid, compared_hole, compared_carry, compared_follows;
    reg [36:0] compared_carried;
    reg compared_exists, compared_right, compared_was_first;
    reg [26:0] compared_parent_sibling;
    reg compared_chosen_stored, compared_sibling_stored;
    reg [26:0] compared_sibling;
    reg compared_sibling_exists, compared_sibling_mark;
    reg [36:0] compared_entry;
    reg compared_right_below;
    reg [4:0] compared_left_count;
    reg write_back_valid, write_back_hole, write_back_carry, write_back_existed, write_back_ahead;
    reg write_back_sibling_exists, write_back_sibling_mark;
    reg [36:0] write_back_entry;
    reg write_back_right_below;
    reg [4:0] write_back_left_count;
    reg [43:0] stored;
    reg [4:0] row, row_before;
    wire [43:0] left_shown, right_shown;

    wire [36:0] chosen_entry = compared_chosen_stored ? stored[43:7] : compared_entry;
    wire term_1 = compared_carried[36] == lap;
    wire [25:0] joined_2 = {compared_carried[35:24], compared_carried[23] == last_epoch, compared_carried[22:10]};
    wire [25:0] joined_3 = {chosen_entry[35:24], chosen_entry[23] == last_epoch, chosen_entry[22:10]};
    wire before_chosen = (compared_carried[36] ^ chosen_entry[36]) ? term_1 : (joined_2 < joined_3);
    wire carried_first = compared_carry & (~compared_exists | before_chosen);
    wire [36:0] first = carried_first ? compared_carried : chosen_entry;
    wire [25:0] joined_4 = {
        compared_parent_sibling[25:14], compared_parent_sibling[13] == last_epoch,
        compared_parent_sibling[12:0]
    };
    wire sibling_stays = (compared_parent_sibling[26] ^ chosen_entry[36]) ? (compared_parent_sibling[26] == lap) : (joined_4 < joined_3);
    wire term_5 = compared_exists & ~sibling_stays;
    wire [4:0] chosen_left_count = compared_chosen_stored ? stored[4:0] : compared_left_count;
    wire chosen_right_below = compared_chosen_stored ? stored[5] : compared_right_below;
    wire term_6 = ~(|chosen_left_count | chosen_right_below);
    wire term_7 = compared_valid & compared_exists;
    wire term_8 = &chosen_left_count[3:0] & (chosen_left_count[4] | ~lower);
    wire [36:0] choice_9 = carried_first ? chosen_entry : compared_carried;
    wire [26:0] sibling = compared_sibling_stored ? stored[43:17] : compared_sibling;
    wire choice_10 = lower ? compared_hole : step_hole;
    wire choice_11 = lower ? |chosen_left_count : step_left_exists;
    wire choice_12 = lower ? chosen_right_below : step_right_exists;
    wire choice_13 = lower ? compared_follows : step_follows;
    wire newer = choice_13 & write_back_valid;
    wire [5:0] choice_14 = lower ? below_promoted_node : {1'd0, row_before};
    wire side = choice_14[0];
    wire choice_15 = lower ? below_promoted_exists : compared_exists;
    wire term_16 = ~write_back_sibling_exists | write_back_ahead | (lower ? below_promoted_ahead : term_5);
    wire is_first = write_back_hole ? ((write_back_carry | choice_15) & term_16) : write_back_ahead;
    wire first_side = side ^ ~is_first;
    wire choice_17 = (choice_11 & choice_12) ? (newer ? first_side : (left_shown[6] ^ right_shown[6])) : choice_12;
    wire goes_right = choice_10 ? choice_17 : lower ? term_8 : step_right;
    wire [5:0] next_row = {row, goes_right};
    wire [36:0] entry_to_store = write_back_hole ? (lower ? below_promoted_entry : first) : write_back_entry;
    wire term_18 = first_side ^ (write_back_sibling_exists & write_back_sibling_mark);
    wire term_19 = write_back_hole & ~write_back_carry & choice_15;
    wire choice_20 = lower ? below_promoted_right : compared_right;
    wire term_21 = term_19 & choice_20 & (lower ? below_promoted_childless : term_6);
    wire term_22 = ~write_back_hole & write_back_existed;
    wire term_23 = (write_back_right_below & ~term_21) | (term_22 & choice_20);
    wire term_24 = ~choice_20;
    wire term_25 = term_19 & term_24;
    wire [4:0] sum_26 = write_back_left_count + {{4{term_25}}, term_25 | (term_22 & term_24)};
    wire [43:0] node_to_store = {entry_to_store, term_18, term_23, sum_26};
    wire [4:0] choice_27 = lower ? {1'd0, step_row} : next_row[4:0];
    wire same_side = goes_right ^ ~side;
    wire [36:0] choice_28 = ~goes_right ? right_shown[43:7] : left_shown[43:7];
    wire [25:0] joined_29 = {sibling[25:14], sibling[13] == last_epoch, sibling[12:0]};
    wire before_sibling = (compared_carried[36] ^ sibling[26]) ? term_1 : (joined_2 < joined_29);
    wire term_30 = carried_first & (before_sibling | ~compared_sibling_exists);

    assign promoted_entry = first;
    assign promoted_exists = compared_exists;
    assign promoted_ahead = term_5;
    assign promoted_right = compared_right;
    assign promoted_childless = term_6;
    assign promoted_node = row_before[3:0];
    assign below_valid = term_7;
    assign below_hole = compared_hole;
    assign below_carry = compared_carry;
    assign below_right = term_8;
    assign below_left_exists = |chosen_left_count;
    assign below_right_exists = chosen_right_below;
    assign below_follows = compared_follows;
    assign below_entry = choice_9;
    assign below_sibling = sibling;
    assign below_row = next_row;

    memory_1w1r_unordered #(.WIDTH(44), .DEPTH(32)) left_nodes (
        .clk(clk),
        .write(write_back_valid & ~side), .write_address(choice_14[5:1]), .write_data(node_to_store),
        .read(1'd1), .read_address(choice_27), .read_data(left_shown)
    );

    memory_1w1r_unordered #(.WIDTH(44), .DEPTH(32)) right_nodes (
        .clk(clk),
        .write(write_back_valid & side), .write_address(choice_14[5:1]), .write_data(node_to_store),
        .read(1'd1), .read_address(choice_27), .read_data(right_shown)
    );

    always @(posedge clk) begin
        if (rst) begin
            lower <= 1'd0;
            compared_valid <= 1'd0;
            write_back_valid <= 1'd0;
        end else begin
            lower <= ~lower;
            compared_valid <= lower ? term_7 : step_valid;
            write_back_valid <= compared_valid & (compared_exists | ~compared_hole);
        end
    end
    always @(posedge clk) begin
        compared_hole <= choice_10;
        compared_carry <= lower ? compared_carry : step_carry;
        compared_follows <= choice_13 & same_side;
        compared_carried <= lower ? choice_9 : step_entry;
        compared_exists <= goes_right ? choice_12 : choice_11;
        compared_right <= goes_right;
        compared_was_first <= goes_right == choice_17;
        compared_parent_sibling <= lower ? sibling : step_sibling;
        compared_chosen_stored <= newer & same_side;
        compared_sibling_stored <= newer & ~same_side;
        compared_sibling <= choice_28[36:10];
        compared_sibling_exists <= goes_right ? choice_11 : choice_12;
        compared_sibling_mark <= ~goes_right ? right_shown[6] : left_shown[6];
        compared_entry <= goes_right ? right_shown[43:7] : left_shown[43:7];
        compared_right_below <= goes_right ? right_shown[5] : left_shown[5];
        compared_left_count <= goes_right ? right_shown[4:0] : left_shown[4:0];
        write_back_hole <= compared_hole;
        write_back_carry <= compared_carry;
        write_back_existed <= compared_exists;
        write_back_ahead <= compared_hole ? (compared_carry & before_sibling) : ((compared_exists & compared_was_first) | term_30);
        write_back_sibling_exists <= compared_sibling_exists;
        write_back_sibling_mark <= compared_sibling_stored ? stored[6] : compared_sibling_mark;
        write_back_entry <= first;
        write_back_right_below <= chosen_right_below & compared_exists;
        write_back_left_count <= chosen_left_count & {5{compared_exists}};
        stored <= node_to_store;
        row <= choice_27;
        row_before <= row;
    end

    wire _unused = &{1'b0, choice_28[9:0]};
endmodule

// Two neighboring levels of the pipelined heap.
// level = 2
// levels = 10
// interval = 2
module splat_heap_stage_l2 (
    input  wire clk,
    input  wire rst,
    input  wire lap,
    input  wire last_epoch,
    input  wire step_valid,
    input  wire step_hole,
    input  wire step_carry,
    input  wire step_right,
    input  wire step_left_exists,
    input  wire step_right_exists,
    input  wire step_follows,
    input  wire [36:0] step_entry,
    input  wire [26:0] step_sibling,
    input  wire [1:0] step_row,
    input  wire [36:0] below_promoted_entry,
    input  wire below_promoted_exists,
    input  wire below_promoted_ahead,
    input  wire below_promoted_right,
    input  wire below_promoted_childless,
    input  wire [3:0] below_promoted_node,
    output wire [36:0] promoted_entry,
    output wire promoted_exists,
    output wire promoted_ahead,
    output wire promoted_right,
    output wire promoted_childless,
    output wire [1:0] promoted_node,
    output wire below_valid,
    output wire below_hole,
    output wire below_carry,
    output wire below_right,
    output wire below_left_exists,
    output wire below_right_exists,
    output wire below_follows,
    output wire [36:0] below_entry,
    output wire [26:0] below_sibling,
    output wire [3:0] below_row
);
    reg lower, compared_valid, compared_hole, compared_carry, compared_follows;
    reg [36:0] compared_carried;
    reg compared_exists, compared_right, compared_was_first;
    reg [26:0] compared_parent_sibling;
    reg compared_chosen_stored, compared_sibling_stored;
    reg [26:0] compared_sibling;
    reg compared_sibling_exists, compared_sibling_mark;
    reg [36:0] compared_entry;
    reg compared_right_below;
    reg [6:0] compared_left_count;
    reg write_back_valid, write_back_hole, write_back_carry, write_back_existed, write_back_ahead;
    reg write_back_sibling_exists, write_back_sibling_mark;
    reg [36:0] write_back_entry;
    reg write_back_right_below;
    reg [6:0] write_back_left_count;
    reg [45:0] stored;
    reg [2:0] row, row_before;
    wire [45:0] left_shown, right_shown;

    wire [36:0] chosen_entry = compared_chosen_stored ? stored[45:9] : compared_entry;
    wire term_1 = compared_carried[36] == lap;
    wire [25:0] joined_2 = {compared_carried[35:24], compared_carried[23] == last_epoch, compared_carried[22:10]};
    wire [25:0] joined_3 = {chosen_entry[35:24], chosen_entry[23] == last_epoch, chosen_entry[22:10]};
    wire before_chosen = (compared_carried[36] ^ chosen_entry[36]) ? term_1 : (joined_2 < joined_3);
    wire carried_first = compared_carry & (~compared_exists | before_chosen);
    wire [36:0] first = carried_first ? compared_carried : chosen_entry;
    wire [25:0] joined_4 = {
        compared_parent_sibling[25:14], compared_parent_sibling[13] == last_epoch,
        compared_parent_sibling[12:0]
    };
    wire sibling_stays = (compared_parent_sibling[26] ^ chosen_entry[36]) ? (compared_parent_sibling[26] == lap) : (joined_4 < joined_3);
    wire term_5 = compared_exists & ~sibling_stays;
    wire [6:0] chosen_left_count = compared_chosen_stored ? stored[6:0] : compared_left_count;
    wire chosen_right_below = compared_chosen_stored ? stored[7] : compared_right_below;
    wire term_6 = ~(|chosen_left_count | chosen_right_below);
    wire term_7 = compared_valid & compared_exists;
    wire term_8 = &chosen_left_count[5:0] & (chosen_left_count[6] | ~lower);
    wire [36:0] choice_9 = carried_first ? chosen_entry : compared_carried;
    wire [26:0] sibling = compared_sibling_stored ? stored[45:19] : compared_sibling;
    wire choice_10 = lower ? compared_hole : step_hole;
    wire choice_11 = lower ? |chosen_left_count : step_left_exists;
    wire choice_12 = lower ? chosen_right_below : step_right_exists;
    wire choice_13 = lower ? compared_follows : step_follows;
    wire newer = choice_13 & write_back_valid;
    wire [3:0] choice_14 = lower ? below_promoted_node : {1'd0, row_before};
    wire side = choice_14[0];
    wire choice_15 = lower ? below_promoted_exists : compared_exists;
    wire term_16 = ~write_back_sibling_exists | write_back_ahead | (lower ? below_promoted_ahead : term_5);
    wire is_first = write_back_hole ? ((write_back_carry | choice_15) & term_16) : write_back_ahead;
    wire first_side = side ^ ~is_first;
    wire choice_17 = (choice_11 & choice_12) ? (newer ? first_side : (left_shown[8] ^ right_shown[8])) : choice_12;
    wire goes_right = choice_10 ? choice_17 : lower ? term_8 : step_right;
    wire [3:0] next_row = {row, goes_right};
    wire [36:0] entry_to_store = write_back_hole ? (lower ? below_promoted_entry : first) : write_back_entry;
    wire term_18 = first_side ^ (write_back_sibling_exists & write_back_sibling_mark);
    wire term_19 = write_back_hole & ~write_back_carry & choice_15;
    wire choice_20 = lower ? below_promoted_right : compared_right;
    wire term_21 = term_19 & choice_20 & (lower ? below_promoted_childless : term_6);
    wire term_22 = ~write_back_hole & write_back_existed;
    wire term_23 = (write_back_right_below & ~term_21) | (term_22 & choice_20);
    wire term_24 = ~choice_20;
    wire term_25 = term_19 & term_24;
    wire [6:0] sum_26 = write_back_left_count + {{6{term_25}}, term_25 | (term_22 & term_24)};
    wire [45:0] node_to_store = {entry_to_store, term_18, term_23, sum_26};
    wire [2:0] choice_27 = lower ? {1'd0, step_row} : next_row[2:0];
    wire same_side = goes_right ^ ~side;
    wire [36:0] choice_28 = ~goes_right ? right_shown[45:9] : left_shown[45:9];
    wire [25:0] joined_29 = {sibling[25:14], sibling[13] == last_epoch, sibling[12:0]};
    wire before_sibling = (compared_carried[36] ^ sibling[26]) ? term_1 : (joined_2 < joined_29);
    wire term_30 = carried_first & (before_sibling | ~compared_sibling_exists);

    assign promoted_entry = first;
    assign promoted_exists = compared_exists;
    assign promoted_ahead = term_5;
    assign promoted_right = compared_right;
    assign promoted_childless = term_6;
    assign promoted_node = row_before[1:0];
    assign below_valid = term_7;
    assign below_hole = compared_hole;
    assign below_carry = compared_carry;
    assign below_right = term_8;
    assign below_left_exists = |chosen_left_count;
    assign below_right_exists = chosen_right_below;
    assign below_follows = compared_follows;
    assign below_entry = choice_9;
    assign below_sibling = sibling;
    assign below_row = next_row;

    memory_1w1r_unordered #(.WIDTH(46), .DEPTH(8)) left_nodes (
        .clk(clk),
        .write(write_back_valid & ~side), .write_address(choice_14[3:1]), .write_data(node_to_store),
        .read(1'd1), .read_address(choice_27), .read_data(left_shown)
    );

    memory_1w1r_unordered #(.WIDTH(46), .DEPTH(8)) right_nodes (
        .clk(clk),
        .write(write_back_valid & side), .write_address(choice_14[3:1]), .write_data(node_to_store),
        .read(1'd1), .read_address(choice_27), .read_data(right_shown)
    );

    always @(posedge clk) begin
        if (rst) begin
            lower <= 1'd0;
            compared_valid <= 1'd0;
            write_back_valid <= 1'd0;
        end else begin
            lower <= ~lower;
            compared_valid <= lower ? term_7 : step_valid;
            write_back_valid <= compared_valid & (compared_exists | ~compared_hole);
        end
    end
    always @(posedge clk) begin
        compared_hole <= choice_10;
        compared_carry <= lower ? compared_carry : step_carry;
        compared_follows <= choice_13 & same_side;
        compared_carried <= lower ? choice_9 : step_entry;
        compared_exists <= goes_right ? choice_12 : choice_11;
        compared_right <= goes_right;
        compared_was_first <= goes_right == choice_17;
        compared_parent_sibling <= lower ? sibling : step_sibling;
        compared_chosen_stored <= newer & same_side;
        compared_sibling_stored <= newer & ~same_side;
        compared_sibling <= choice_28[36:10];
        compared_sibling_exists <= goes_right ? choice_11 : choice_12;
        compared_sibling_mark <= ~goes_right ? right_shown[8] : left_shown[8];
        compared_entry <= goes_right ? right_shown[45:9] : left_shown[45:9];
        compared_right_below <= goes_right ? right_shown[7] : left_shown[7];
        compared_left_count <= goes_right ? right_shown[6:0] : left_shown[6:0];
        write_back_hole <= compared_hole;
        write_back_carry <= compared_carry;
        write_back_existed <= compared_exists;
        write_back_ahead <= compared_hole ? (compared_carry & before_sibling) : ((compared_exists & compared_was_first) | term_30);
        write_back_sibling_exists <= compared_sibling_exists;
        write_back_sibling_mark <= compared_sibling_stored ? stored[8] : compared_sibling_mark;
        write_back_entry <= first;
        write_back_right_below <= chosen_right_below & compared_exists;
        write_back_left_count <= chosen_left_count & {7{compared_exists}};
        stored <= node_to_store;
        row <= choice_27;
        row_before <= row;
    end

    wire _unused = &{1'b0, choice_28[9:0]};
endmodule

// Two neighboring levels of the pipelined heap.
// level = 0
// levels = 10
// interval = 2
module splat_heap_stage_l0 (
    input  wire clk,
    input  wire rst,
    input  wire lap,
    input  wire last_epoch,
    input  wire step_valid,
    input  wire step_hole,
    input  wire step_carry,
    input  wire step_right,
    input  wire step_left_exists,
    input  wire step_right_exists,
    input  wire step_follows,
    input  wire [36:0] step_entry,
    input  wire [26:0] step_sibling,
    input  wire newcomer_lap,
    input  wire [36:0] below_promoted_entry,
    input  wire below_promoted_exists,
    input  wire below_promoted_ahead,
    input  wire below_promoted_right,
    input  wire below_promoted_childless,
    input  wire [1:0] below_promoted_node,
    output wire [36:0] root,
    output wire below_valid,
    output wire below_hole,
    output wire below_carry,
    output wire below_right,
    output wire below_left_exists,
    output wire below_right_exists,
    output wire below_follows,
    output wire [36:0] below_entry,
    output wire [26:0] below_sibling,
    output wire [1:0] below_row
);
    reg lower, compared_valid, compared_hole, compared_carry, compared_follows;
    reg [36:0] compared_carried;
    reg compared_exists, compared_right, compared_was_first;
    reg [26:0] compared_parent_sibling;
    reg compared_chosen_stored, compared_sibling_stored;
    reg [26:0] compared_sibling;
    reg compared_sibling_exists, compared_sibling_mark;
    reg [36:0] compared_entry;
    reg compared_right_below;
    reg [8:0] compared_left_count;
    reg write_back_valid, write_back_hole, write_back_carry, write_back_existed, write_back_ahead;
    reg write_back_sibling_exists, write_back_sibling_mark;
    reg [36:0] write_back_entry;
    reg write_back_right_below;
    reg [8:0] write_back_left_count;
    reg [47:0] stored;
    reg row, row_before;
    wire [47:0] left_shown, right_shown;

    wire choice_1 = lower ? compared_follows : step_follows;
    wire newer = choice_1 & write_back_valid;
    wire choice_2 = lower ? newcomer_lap : compared_carried[36];
    wire [36:0] chosen_entry = compared_chosen_stored ? stored[47:11] : compared_entry;
    wire term_3 = choice_2 == lap;
    wire [25:0] joined_4 = {compared_carried[35:24], compared_carried[23] == last_epoch, compared_carried[22:10]};
    wire [25:0] joined_5 = {chosen_entry[35:24], chosen_entry[23] == last_epoch, chosen_entry[22:10]};
    wire before_chosen = (choice_2 ^ chosen_entry[36]) ? term_3 : (joined_4 < joined_5);
    wire carried_first = compared_carry & (~compared_exists | before_chosen);
    wire [36:0] joined_6 = {choice_2, compared_carried[35:0]};
    wire [36:0] first = carried_first ? joined_6 : chosen_entry;
    wire [36:0] entry_to_store = write_back_hole ? (lower ? below_promoted_entry : first) : write_back_entry;
    wire term_7 = compared_valid & compared_exists;
    wire [8:0] chosen_left_count = compared_chosen_stored ? stored[8:0] : compared_left_count;
    wire term_8 = &chosen_left_count[7:0] & (chosen_left_count[8] | ~lower);
    wire chosen_right_below = compared_chosen_stored ? stored[9] : compared_right_below;
    wire [36:0] choice_9 = carried_first ? chosen_entry : joined_6;
    wire [26:0] sibling = compared_sibling_stored ? stored[47:21] : compared_sibling;
    wire choice_10 = lower ? compared_hole : step_hole;
    wire choice_11 = lower ? |chosen_left_count : step_left_exists;
    wire choice_12 = lower ? chosen_right_below : step_right_exists;
    wire [1:0] choice_13 = lower ? below_promoted_node : {1'd0, row_before};
    wire side = choice_13[0];
    wire choice_14 = lower ? below_promoted_exists : compared_exists;
    wire [25:0] joined_15 = {
        compared_parent_sibling[25:14], compared_parent_sibling[13] == last_epoch,
        compared_parent_sibling[12:0]
    };
    wire sibling_stays = (compared_parent_sibling[26] ^ chosen_entry[36]) ? (compared_parent_sibling[26] == lap) : (joined_15 < joined_5);
    wire choice_16 = lower ? below_promoted_ahead : (compared_exists & ~sibling_stays);
    wire term_17 = ~write_back_sibling_exists | write_back_ahead | choice_16;
    wire is_first = write_back_hole ? ((write_back_carry | choice_14) & term_17) : write_back_ahead;
    wire first_side = side ^ ~is_first;
    wire choice_18 = (choice_11 & choice_12) ? (newer ? first_side : (left_shown[10] ^ right_shown[10])) : choice_12;
    wire goes_right = choice_10 ? choice_18 : lower ? term_8 : step_right;
    wire [1:0] next_row = {row, goes_right};
    wire term_19 = first_side ^ (write_back_sibling_exists & write_back_sibling_mark);
    wire term_20 = write_back_hole & ~write_back_carry & choice_14;
    wire choice_21 = lower ? below_promoted_right : compared_right;
    wire choice_22 = lower ? below_promoted_childless : ~(|chosen_left_count | chosen_right_below);
    wire term_23 = write_back_right_below & ~(term_20 & choice_21 & choice_22);
    wire term_24 = ~write_back_hole & write_back_existed;
    wire term_25 = ~choice_21;
    wire term_26 = term_20 & term_25;
    wire [8:0] sum_27 = write_back_left_count + {{8{term_26}}, term_26 | (term_24 & term_25)};
    wire [47:0] node_to_store = {entry_to_store, term_19, term_23 | (term_24 & choice_21), sum_27};
    wire choice_28 = lower ? 1'd0 : next_row[0];
    wire same_side = goes_right ^ ~side;
    wire [36:0] choice_29 = ~goes_right ? right_shown[47:11] : left_shown[47:11];
    wire [25:0] joined_30 = {sibling[25:14], sibling[13] == last_epoch, sibling[12:0]};
    wire before_sibling = (choice_2 ^ sibling[26]) ? term_3 : (joined_4 < joined_30);
    wire term_31 = carried_first & (before_sibling | ~compared_sibling_exists);

    assign root = newer ? entry_to_store : right_shown[47:11];
    assign below_valid = term_7;
    assign below_hole = compared_hole;
    assign below_carry = compared_carry;
    assign below_right = term_8;
    assign below_left_exists = |chosen_left_count;
    assign below_right_exists = chosen_right_below;
    assign below_follows = compared_follows;
    assign below_entry = choice_9;
    assign below_sibling = sibling;
    assign below_row = next_row;

    memory_1w1r_unordered #(.WIDTH(48), .DEPTH(2)) left_nodes (
        .clk(clk),
        .write(write_back_valid & ~side), .write_address(choice_13[1]), .write_data(node_to_store),
        .read(1'd1), .read_address(choice_28), .read_data(left_shown)
    );

    memory_1w1r_unordered #(.WIDTH(48), .DEPTH(2)) right_nodes (
        .clk(clk),
        .write(write_back_valid & side), .write_address(choice_13[1]), .write_data(node_to_store),
        .read(1'd1), .read_address(choice_28), .read_data(right_shown)
    );

    always @(posedge clk) begin
        if (rst) begin
            lower <= 1'd0;
            compared_valid <= 1'd0;
            write_back_valid <= 1'd0;
        end else begin
            lower <= ~lower;
            compared_valid <= lower ? term_7 : step_valid;
            write_back_valid <= compared_valid & (compared_exists | ~compared_hole);
        end
    end
    always @(posedge clk) begin
        compared_hole <= choice_10;
        compared_carry <= lower ? compared_carry : step_carry;
        compared_follows <= choice_1 & same_side;
        compared_carried <= lower ? choice_9 : step_entry;
        compared_exists <= goes_right ? choice_12 : choice_11;
        compared_right <= goes_right;
        compared_was_first <= goes_right == choice_18;
        compared_parent_sibling <= lower ? sibling : step_sibling;
        compared_chosen_stored <= newer & same_side;
        compared_sibling_stored <= newer & ~same_side;
        compared_sibling <= choice_29[36:10];
        compared_sibling_exists <= goes_right ? choice_11 : choice_12;
        compared_sibling_mark <= ~goes_right ? right_shown[10] : left_shown[10];
        compared_entry <= goes_right ? right_shown[47:11] : left_shown[47:11];
        compared_right_below <= goes_right ? right_shown[9] : left_shown[9];
        compared_left_count <= goes_right ? right_shown[8:0] : left_shown[8:0];
        write_back_hole <= compared_hole;
        write_back_carry <= compared_carry;
        write_back_existed <= compared_exists;
        write_back_ahead <= compared_hole ? (compared_carry & before_sibling) : ((compared_exists & compared_was_first) | term_31);
        write_back_sibling_exists <= compared_sibling_exists;
        write_back_sibling_mark <= compared_sibling_stored ? stored[10] : compared_sibling_mark;
        write_back_entry <= first;
        write_back_right_below <= chosen_right_below & compared_exists;
        write_back_left_count <= chosen_left_count & {9{compared_exists}};
        stored <= node_to_store;
        row <= choice_28;
        row_before <= row;
    end

    wire _unused = &{1'b0, choice_29[9:0]};
endmodule

// Queue of two in registers.
// width = 22
module stream_skid_w22 (
    input  wire clk,
    input  wire rst,
    input  wire in_valid,
    output wire in_ready,
    input  wire [21:0] in_data,
    output reg  out_valid,
    input  wire out_ready,
    output wire [21:0] out_data
);
    reg second_valid;
    reg [21:0] head, second;

    assign in_ready = ~second_valid;
    wire advance = ~out_valid | out_ready;
    wire some_item = second_valid | in_valid;

    assign out_data = head;

    always @(posedge clk) begin
        if (rst) begin
            out_valid <= 1'd0;
            second_valid <= 1'd0;
        end else begin
            if (advance) out_valid <= some_item;
            second_valid <= ~advance & some_item;
        end
    end
    always @(posedge clk) begin
        if (advance) head <= second_valid ? second : in_data;
        if (in_ready) second <= in_data;
    end

`ifdef RTL_ASSERT
    always @(posedge clk) begin
        if (!rst) begin
            if (!(out_valid | in_ready)) begin
`ifdef FORMAL
                second_waits_behind_head: assert (0);
`else
                $display("assertion failed: second_waits_behind_head in %m");
                $stop;
`endif
            end
        end
    end
`endif
endmodule

// Splits a splat's rectangle into one copy per tile.
module splat_splitter (
    input  wire clk,
    input  wire rst,
    input  wire in_valid,  // Footprints with bounds in the image.
    output wire in_ready,
    input  wire in_end,  // Closes the frame.
    input  wire [25:0] in_center_x,  // Projected center (px), the origin of what follows.
    input  wire [25:0] in_center_y,  // Projected center (px), the origin of what follows.
    input  wire [15:0] in_ax,  // `A` in x.
    input  wire [15:0] in_bx,  // `B` in x.
    input  wire [15:0] in_ay,  // `A` in y.
    input  wire [15:0] in_by,  // `B` in y.
    input  wire [19:0] in_delta,  // The determinant of `A` and `B`.
    input  wire [15:0] in_mx,  // `m` in x.
    input  wire [15:0] in_my,  // `m` in y.
    input  wire [3:0] in_shift,  // In fixed point, places by which offsets from the centre are shifted.
    input  wire [23:0] in_depth,  // Depth.
    input  wire [23:0] in_depth_low,  // What is nearer hides the splat.
    input  wire [23:0] in_depth_high,  // What is farther is hidden by the splat.
    input  wire [11:0] in_attribute_0,  // Attributes.
    input  wire [11:0] in_attribute_1,  // Attributes.
    input  wire [11:0] in_attribute_2,  // Attributes.
    input  wire [8:0] in_left,  // First column.
    input  wire [8:0] in_right,  // Last column.
    input  wire [8:0] in_top,  // First row.
    input  wire [8:0] in_bottom,  // Last row.
    output wire out_valid,  // Copies with bounds in their tiles.
    input  wire out_ready,
    output wire out_end,  // Closes the frame.
    output wire [25:0] out_center_x,  // Projected center (px), the origin of what follows.
    output wire [25:0] out_center_y,  // Projected center (px), the origin of what follows.
    output wire [15:0] out_ax,  // `A` in x.
    output wire [15:0] out_bx,  // `B` in x.
    output wire [15:0] out_ay,  // `A` in y.
    output wire [15:0] out_by,  // `B` in y.
    output wire [19:0] out_delta,  // The determinant of `A` and `B`.
    output wire [15:0] out_mx,  // `m` in x.
    output wire [15:0] out_my,  // `m` in y.
    output wire [3:0] out_shift,  // In fixed point, places by which offsets from the centre are shifted.
    output wire [23:0] out_depth,  // Depth.
    output wire [23:0] out_depth_low,  // What is nearer hides the splat.
    output wire [23:0] out_depth_high,  // What is farther is hidden by the splat.
    output wire [11:0] out_attribute_0,  // Attributes.
    output wire [11:0] out_attribute_1,  // Attributes.
    output wire [11:0] out_attribute_2,  // Attributes.
    output wire [2:0] out_left,  // First column.
    output wire [2:0] out_right,  // Last column.
    output wire [2:0] out_top,  // First row.
    output wire [2:0] out_bottom,  // Last row.
    output wire [11:0] out_tile  // Tile index: row above column.
);
    reg busy, idle, last, splat_end;
    reg [25:0] splat_center_x, splat_center_y;
    reg [15:0] splat_ax, splat_bx, splat_ay, splat_by;
    reg [19:0] splat_delta;
    reg [15:0] splat_mx, splat_my;
    reg [3:0] splat_shift;
    reg [23:0] splat_depth, splat_depth_low, splat_depth_high;
    reg [11:0] splat_attribute_0, splat_attribute_1, splat_attribute_2;
    reg [8:0] splat_left, splat_right, splat_top, splat_bottom;
    reg [5:0] column, row;

    wire out_queue_in_ready, out_queue_out_valid;
    wire [304:0] out_queue_out_data;

    wire ready = out_queue_in_ready & idle;
    wire right_most = column == splat_right[8:3];
    wire take = ready & in_valid;
    wire term_1 = {in_top[8:3], in_left[8:3]} == {in_bottom[8:3], in_right[8:3]};
    wire term_2 = in_end | term_1;
    wire [5:0] choice_3 = right_most ? (row + 6'd1) : row;
    wire [5:0] choice_4 = right_most ? splat_left[8:3] : (column + 6'd1);
    wire term_5 = {choice_3, choice_4} == {splat_bottom[8:3], splat_right[8:3]};

    assign in_ready = ready;
    assign out_valid = out_queue_out_valid;
    assign {
        out_end, out_center_x, out_center_y, out_ax, out_bx, out_ay, out_by, out_delta, out_mx, out_my,
        out_shift, out_depth, out_depth_low, out_depth_high, out_attribute_0, out_attribute_1,
        out_attribute_2, out_left, out_right, out_top, out_bottom, out_tile
    } = out_queue_out_data;

    stream_half_buffer_w305 out_queue (
        .clk(clk), .rst(rst),
        .in_valid(out_queue_in_ready & busy), .in_ready(out_queue_in_ready),
        .in_data({
            splat_end, splat_center_x, splat_center_y, splat_ax, splat_bx, splat_ay, splat_by, splat_delta,
            splat_mx, splat_my, splat_shift, splat_depth, splat_depth_low, splat_depth_high, splat_attribute_0,
            splat_attribute_1, splat_attribute_2, (column == splat_left[8:3]) ? splat_left[2:0] : 3'd0,
            right_most ? splat_right[2:0] : 3'd7, (row == splat_top[8:3]) ? splat_top[2:0] : 3'd0,
            (row == splat_bottom[8:3]) ? splat_bottom[2:0] : 3'd7, row, column
        }),
        .out_valid(out_queue_out_valid), .out_ready(out_ready), .out_data(out_queue_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            busy <= 1'd0;
            idle <= 1'd1;
        end else if (out_queue_in_ready) begin
            busy <= take | (busy & ~last);
            idle <= take ? term_2 : (~busy | (last | term_5));
        end
    end
    always @(posedge clk) begin
        if (out_queue_in_ready) begin
            last <= take ? term_2 : term_5;
            column <= take ? in_left[8:3] : choice_4;
            row <= take ? in_top[8:3] : choice_3;
        end
        if (ready) begin
            splat_end <= in_end;
            splat_center_x <= in_center_x;
            splat_center_y <= in_center_y;
            splat_ax <= in_ax;
            splat_bx <= in_bx;
            splat_ay <= in_ay;
            splat_by <= in_by;
            splat_delta <= in_delta;
            splat_mx <= in_mx;
            splat_my <= in_my;
            splat_shift <= in_shift;
            splat_depth <= in_depth;
            splat_depth_low <= in_depth_low;
            splat_depth_high <= in_depth_high;
            splat_attribute_0 <= in_attribute_0;
            splat_attribute_1 <= in_attribute_1;
            splat_attribute_2 <= in_attribute_2;
            splat_left <= in_left;
            splat_right <= in_right;
            splat_top <= in_top;
            splat_bottom <= in_bottom;
        end
    end
endmodule

// One item in a register, at half rate.
// width = 305
module stream_half_buffer_w305 (
    input  wire clk,
    input  wire rst,
    input  wire in_valid,
    output wire in_ready,
    input  wire [304:0] in_data,
    output wire out_valid,
    input  wire out_ready,
    output wire [304:0] out_data
);
    reg full;
    reg [304:0] item;

    assign in_ready = ~full;

    assign out_valid = full;
    assign out_data = item;

    always @(posedge clk) begin
        if (rst) begin
            full <= 1'd0;
        end else begin
            full <= full ? ~out_ready : in_valid;
        end
    end
    always @(posedge clk) begin
        if (in_ready) item <= in_data;
    end
endmodule

// Footprint, depth band and bounding rectangle of a splat.
// latency = 161
// initiation_interval = 8
module splat_setup (
    input  wire clk,
    input  wire rst,
    input  wire in_valid,
    output wire in_ready,
    input  wire in_end,
    input  wire [23:0] in_center_x,
    input  wire [23:0] in_center_y,
    input  wire [23:0] in_center_z,
    input  wire [23:0] in_tangent1_x,
    input  wire [23:0] in_tangent1_y,
    input  wire [23:0] in_tangent1_z,
    input  wire [23:0] in_tangent2_x,
    input  wire [23:0] in_tangent2_y,
    input  wire [23:0] in_tangent2_z,
    input  wire [11:0] in_attribute_0,
    input  wire [11:0] in_attribute_1,
    input  wire [11:0] in_attribute_2,
    input  wire [23:0] filter_radius,
    input  wire [23:0] scale_x,
    input  wire [23:0] origin_x,
    input  wire [23:0] scale_y,
    input  wire [23:0] origin_y,
    input  wire [23:0] depth_b,
    input  wire [23:0] depth_a,
    input  wire [23:0] epsilon_scale,
    input  wire [23:0] epsilon_bias,
    output wire out_valid,
    input  wire out_ready,
    output wire out_end,
    output wire [25:0] out_center_x,
    output wire [25:0] out_center_y,
    output wire [15:0] out_ax,
    output wire [15:0] out_bx,
    output wire [15:0] out_ay,
    output wire [15:0] out_by,
    output wire [19:0] out_delta,
    output wire [15:0] out_mx,
    output wire [15:0] out_my,
    output wire [3:0] out_shift,
    output wire [23:0] out_depth,
    output wire [23:0] out_depth_low,
    output wire [23:0] out_depth_high,
    output wire [11:0] out_attribute_0,
    output wire [11:0] out_attribute_1,
    output wire [11:0] out_attribute_2,
    output wire [8:0] out_left,
    output wire [8:0] out_right,
    output wire [8:0] out_top,
    output wire [8:0] out_bottom
);
    (* ram_style = "distributed" *)
    reg [8:0] delay_5_from_0 [0:3];
    (* ram_style = "distributed" *)
    reg delay_17_from_0 [0:15];
    (* ram_style = "distributed" *)
    reg [35:0] delay_21_from_0 [0:19];
    (* ram_style = "distributed" *)
    reg delay_6_from_1 [0:4];
    (* ram_style = "distributed" *)
    reg [23:0] delay_7_from_1 [0:5];
    (* ram_style = "distributed" *)
    reg [51:0] delay_9_from_1 [0:7];
    (* ram_style = "distributed" *)
    reg [9:0] delay_10_from_1 [0:8];
    (* ram_style = "distributed" *)
    reg [16:0] delay_11_from_1 [0:9];
    (* ram_style = "distributed" *)
    reg delay_12_from_2 [0:10];
    (* ram_style = "distributed" *)
    reg [8:0] delay_5_from_3 [0:3];
    (* ram_style = "distributed" *)
    reg [47:0] delay_5_from_5 [0:3];
    (* ram_style = "distributed" *)
    reg [63:0] delay_12_from_5 [0:10];
    (* ram_style = "distributed" *)
    reg [20:0] delay_10_from_6 [0:8];
    (* ram_style = "distributed" *)
    reg [42:0] delay_11_from_6 [0:9];
    (* ram_style = "distributed" *)
    reg [29:0] delay_12_from_6 [0:10];
    (* ram_style = "distributed" *)
    reg [3:0] delay_13_from_6 [0:11];
    (* ram_style = "distributed" *)
    reg delay_9_from_7 [0:7];
    reg [2:0] phase;
    reg load_0, load_1, load_2, load_3, load_4, load_5, load_6, load_7;
    reg [1:0] delay_5_from_0_pointer;
    reg [8:0] delay_5_from_0_out;
    reg [3:0] delay_17_from_0_pointer;
    reg delay_17_from_0_out;
    reg [4:0] delay_21_from_0_pointer;
    reg [35:0] delay_21_from_0_out;
    reg [2:0] delay_6_from_1_pointer;
    reg delay_6_from_1_out;
    reg [2:0] delay_7_from_1_pointer;
    reg [23:0] delay_7_from_1_out;
    reg [2:0] delay_9_from_1_pointer;
    reg [51:0] delay_9_from_1_out;
    reg [3:0] delay_10_from_1_pointer;
    reg [9:0] delay_10_from_1_out;
    reg [3:0] delay_11_from_1_pointer;
    reg [16:0] delay_11_from_1_out;
    reg [3:0] delay_12_from_2_pointer;
    reg delay_12_from_2_out;
    reg [1:0] delay_5_from_3_pointer;
    reg [8:0] delay_5_from_3_out;
    reg [1:0] delay_5_from_5_pointer;
    reg [47:0] delay_5_from_5_out;
    reg [3:0] delay_12_from_5_pointer;
    reg [63:0] delay_12_from_5_out;
    reg [3:0] delay_10_from_6_pointer;
    reg [20:0] delay_10_from_6_out;
    reg [3:0] delay_11_from_6_pointer;
    reg [42:0] delay_11_from_6_out;
    reg [3:0] delay_12_from_6_pointer;
    reg [29:0] delay_12_from_6_out;
    reg [3:0] delay_13_from_6_pointer, delay_13_from_6_out;
    reg [2:0] delay_9_from_7_pointer;
    reg delay_9_from_7_out, end_d18, end_d19, end_d20, end_d21;
    reg [23:0] recip_15_d1, reinterpret_16_d1, reinterpret_16_d2, reinterpret_16_d3, mul_17_d1, mul_17_d2, mul_17_d3;
    reg [23:0] reinterpret_18_d1, reinterpret_18_d2, reinterpret_18_d3, mul_19_d1, mul_19_d2, mul_19_d3, add_22_d1;
    reg [23:0] add_22_d2, add_22_d3, add_22_d4;
    reg whole_d7, whole_d8, whole_d9, whole_d10, whole_d11;
    reg [23:0] reinterpret_30_d1, reinterpret_30_d2, reinterpret_30_d3, mul_31_d1, reinterpret_32_d1;
    reg [23:0] reinterpret_32_d2, reinterpret_32_d3, mul_33_d1, mul_37_d1, reinterpret_38_d1, reinterpret_38_d2;
    reg [23:0] reinterpret_38_d3, mul_39_d1, mul_43_d1, add_46_d1, add_46_d2, add_46_d3, add_46_d4, add_46_d5;
    reg [23:0] add_46_d6, add_46_d7, add_49_d1, add_49_d2, add_54_d1, mul_55_d1, add_59_d1, add_59_d2, add_59_d3;
    reg [23:0] add_59_d4, add_64_d1, add_66_d1;
    reg [21:0] shr_82_d1, select_85_d1, min_86_d1;
    reg [8:0] resize_91_d1, resize_91_d2, resize_91_d3, resize_91_d4, resize_91_d5;
    reg lt_92_d1;
    reg [23:0] reinterpret_95_d1, reinterpret_95_d2, reinterpret_95_d3, mul_96_d1, reinterpret_97_d1;
    reg [23:0] reinterpret_97_d2, reinterpret_97_d3, mul_98_d1, mul_102_d1, reinterpret_103_d1, reinterpret_103_d2;
    reg [23:0] reinterpret_103_d3, mul_104_d1, mul_108_d1, add_111_d1, add_111_d2, add_111_d3, add_111_d4;
    reg [23:0] add_111_d5, add_111_d6, add_111_d7, add_111_d8, add_111_d9, add_114_d1, add_114_d2, add_119_d1;
    reg [23:0] mul_120_d1, add_121_d1, add_124_d1, add_124_d2, add_124_d3, add_124_d4, neg_125_d1, min_129_d1;
    reg [23:0] max_131_d1;
    reg [21:0] shr_142_d1, select_143_d1, min_144_d1;
    reg [8:0] resize_148_d1, resize_148_d2, resize_148_d3, resize_148_d4;
    reg lt_149_d1;
    reg [23:0] mul_151_d1;
    reg equal_160_d1, lt_163_d1;
    reg [23:0] mul_169_d1, neg_171_d1, mul_174_d6, add_176_d1, add_176_d2, add_176_d3, add_179_d1, add_179_d2;
    reg [23:0] abs_180_d1, abs_180_d2, sqrt_181_d1, mul_183_d1, mul_183_d2, mul_183_d3, select_188_d1, select_188_d2;
    reg [23:0] min_189_d1, select_190_d1;
    reg le_195_d1, le_195_d2, le_195_d3, le_195_d4, and_196_d1, bits_198_d1, or_203_d1, or_203_d2, or_203_d3;
    reg or_203_d4, lt_207_d1, placed_d1, placed_d2;
    reg [27:0] shr_221_d1;
    reg [25:0] resize_223_d1, select_224_d10, select_224_d11, select_224_d12, select_224_d13;
    reg [27:0] shr_232_d1;
    reg [25:0] resize_234_d1, select_235_d10, select_235_d11, select_235_d12, select_235_d13;
    reg [26:0] reinterpret_241_d1, resize_242_d1, sub_243_d1, reinterpret_245_d1, sub_246_d1;
    reg [25:0] bits_250_d1;
    reg [26:0] not_252_d1, reinterpret_260_d1, resize_261_d1, sub_262_d1, reinterpret_264_d1, sub_265_d1;
    reg [25:0] bits_269_d1, or_270_d1;
    reg [26:0] not_272_d1;
    reg [10:0] bits_277_d1;
    reg not_280_d1;
    reg [9:0] bits_283_d1;
    reg not_286_d1;
    reg [8:0] bits_289_d1;
    reg not_291_d1;
    reg [3:0] select_293_d1;
    reg [7:0] bits_294_d1;
    reg not_297_d1;
    reg [6:0] bits_300_d1;
    reg not_303_d1;
    reg [5:0] bits_306_d1;
    reg not_309_d1;
    reg [3:0] select_311_d1;
    reg [4:0] bits_312_d1;
    reg not_315_d1;
    reg [3:0] bits_318_d1;
    reg not_320_d1, equal_325_d1;
    reg [3:0] select_328_d1;
    reg equal_331_d1, equal_337_d1;
    reg [3:0] shift_d1, shift_d2, shift_d3;
    reg [9:0] add_343_d1, resize_344_d11, select_347_d1, resize_351_d13, resize_353_d13, resize_355_d1;
    reg [9:0] resize_355_d13, resize_357_d11, resize_359_d11, max_360_d1, max_361_d1, max_362_d1, max_363_d1;
    reg [9:0] max_364_d1, exponent_d1, add_367_d1;
    reg and_371_d1;
    reg [23:0] reinterpret_379_d1;
    reg [17:0] shr_388_d1;
    reg [15:0] resize_390_d1;
    reg [9:0] add_391_d1;
    reg and_395_d1;
    reg [23:0] reinterpret_403_d1;
    reg [17:0] shr_411_d1;
    reg [15:0] resize_413_d1;
    reg [9:0] add_414_d1;
    reg and_418_d1;
    reg [23:0] reinterpret_426_d1;
    reg [17:0] shr_434_d1;
    reg [15:0] resize_436_d1;
    reg [9:0] add_437_d1;
    reg and_441_d1;
    reg [23:0] reinterpret_449_d1;
    reg [17:0] shr_457_d1;
    reg [15:0] resize_459_d1;
    reg [9:0] add_460_d1;
    reg and_464_d1;
    reg [23:0] reinterpret_472_d1;
    reg [17:0] shr_480_d1;
    reg [15:0] resize_482_d1;
    reg [9:0] add_483_d1;
    reg and_487_d1;
    reg [23:0] reinterpret_495_d1;
    reg [17:0] shr_503_d1;
    reg [15:0] resize_505_d1;
    reg lt_508_d1;
    reg [9:0] sub_512_d1;
    reg [23:0] reinterpret_518_d1;
    reg [21:0] shr_527_d1;
    reg [19:0] resize_529_d1;
    reg or_533_d1, equal_534_d1, or_537_d1, or_537_d2, or_539_d1, or_541_d1, equal_542_d1, vanishes_d1;
    reg not_549_d1, or_550_d1;
    reg [23:0] max_569_d1, to_fixed_570_d1, to_fixed_570_d2, to_fixed_570_d3, to_fixed_570_d4, recip_f24_ftz_unit_a;
    reg [23:0] mul_f24_ftz_unit_a, mul_f24_ftz_unit_b, mul_f24_ftz_unit_copy2_a, mul_f24_ftz_unit_copy2_b;
    reg [23:0] mul_f24_ftz_unit_copy3_a, mul_f24_ftz_unit_copy3_b, mul_f24_ftz_unit_copy4_a;
    reg [23:0] mul_f24_ftz_unit_copy4_b, mul_f24_ftz_unit_copy5_a, mul_f24_ftz_unit_copy5_b;
    reg [23:0] mul_f24_ftz_unit_copy6_a, mul_f24_ftz_unit_copy6_b, add_f24_ftz_unit_a, add_f24_ftz_unit_b;
    reg [23:0] add_f24_ftz_unit_copy2_a, add_f24_ftz_unit_copy2_b, add_f24_ftz_unit_copy3_a;
    reg [23:0] add_f24_ftz_unit_copy3_b, add_f24_ftz_unit_copy4_a, add_f24_ftz_unit_copy4_b;
    reg [23:0] add_f24_ftz_unit_copy5_a, add_f24_ftz_unit_copy5_b, sqrt_f24_ftz_unit_a, min_f24_ftz_unit_a;
    reg [23:0] min_f24_ftz_unit_b, max_f24_ftz_unit_a, max_f24_ftz_unit_b, max_f24_ftz_unit_copy2_a;
    reg [23:0] max_f24_ftz_unit_copy2_b, to_fixed_f24_ftz_u21q8_unit_a, le_f24_ftz_unit_a, le_f24_ftz_unit_b;
    reg [23:0] to_fixed_f24_ftz_s27q13_unit_a, to_fixed_f24_ftz_s17q16_unit_a, to_fixed_f24_ftz_u24q24_unit_a;
    reg [20:0] in_flight;

    wire queue_in_ready, queue_out_valid;
    wire [316:0] queue_out_data;
    wire [23:0] recip_f24_ftz_unit_y, mul_f24_ftz_unit_y, mul_f24_ftz_unit_copy2_y, mul_f24_ftz_unit_copy3_y;
    wire [23:0] mul_f24_ftz_unit_copy4_y, mul_f24_ftz_unit_copy5_y, mul_f24_ftz_unit_copy6_y, add_f24_ftz_unit_y;
    wire [23:0] add_f24_ftz_unit_copy2_y, add_f24_ftz_unit_copy3_y, add_f24_ftz_unit_copy4_y;
    wire [23:0] add_f24_ftz_unit_copy5_y;
    wire lt_f24_ftz_unit_y;
    wire [23:0] sqrt_f24_ftz_unit_y, min_f24_ftz_unit_y, max_f24_ftz_unit_y, max_f24_ftz_unit_copy2_y;
    wire [20:0] to_fixed_f24_ftz_u21q8_unit_y;
    wire le_f24_ftz_unit_y;
    wire [26:0] to_fixed_f24_ftz_s27q13_unit_y;
    wire [16:0] to_fixed_f24_ftz_s17q16_unit_y;
    wire [20:0] to_fixed_f24_ftz_s21q20_unit_y;
    wire [23:0] to_fixed_f24_ftz_u24q24_unit_y;

    wire term_1 = phase == 3'd1;
    wire term_2 = in_flight[20] & or_203_d4 & term_1;
    wire covers_nothing = vanishes_d1 | delay_12_from_2_out;
    wire [15:0] select_554 = covers_nothing ? 16'd0 : resize_390_d1;
    wire [15:0] select_555 = covers_nothing ? 16'd0 : resize_413_d1;
    wire [15:0] select_556 = covers_nothing ? 16'd0 : resize_436_d1;
    wire [15:0] select_557 = covers_nothing ? 16'd0 : resize_459_d1;
    wire [19:0] select_559 = covers_nothing ? 20'd0 : resize_529_d1;
    wire [15:0] select_560 = covers_nothing ? 16'd0 : resize_482_d1;
    wire [15:0] select_561 = covers_nothing ? 16'd0 : resize_505_d1;
    wire term_3 = phase == 3'd7;
    wire [2:0] phase_next = queue_in_ready ? (term_3 ? (phase - 3'd7) : (phase + 3'd1)) : phase;
    wire term_4 = queue_out_valid & ~out_ready & (~queue_in_ready | term_2);
    wire advance_next = ~term_4;
    wire [21:0] add_81 = {1'd0, to_fixed_f24_ftz_u21q8_unit_y} + 22'd130;
    wire [21:0] add_73 = {1'd0, to_fixed_f24_ftz_u21q8_unit_y} + 22'd126;
    wire [21:0] select_85 = whole_d10 ? (add_73 >> 8) : 22'd0;
    wire [21:0] min_86 = (22'd512 < shr_82_d1) ? 22'd512 : shr_82_d1;
    wire [21:0] select_87 = whole_d10 ? min_86_d1 : 22'd512;
    wire [21:0] sub_89 = select_87 - 22'd1;
    wire lt_92 = select_85_d1 < select_87;
    wire [23:0] joined_5 = {~sqrt_f24_ftz_unit_y[23], sqrt_f24_ftz_unit_y[22:0]};
    wire [21:0] add_141 = 22'd130 + {1'd0, to_fixed_f24_ftz_u21q8_unit_y};
    wire [21:0] add_135 = 22'd126 + {1'd0, to_fixed_f24_ftz_u21q8_unit_y};
    wire [21:0] select_143 = whole_d10 ? (add_135 >> 8) : 22'd0;
    wire [21:0] min_144 = (shr_142_d1 < 22'd512) ? shr_142_d1 : 22'd512;
    wire [21:0] select_145 = whole_d11 ? min_144_d1 : 22'd512;
    wire [21:0] sub_146 = select_145 - 22'd1;
    wire lt_149 = select_143_d1 < select_145;
    wire [8:0] joined_6 = {1'd0, add_f24_ftz_unit_y[22:15]};
    wire equal_160 = joined_6 == 9'd0;
    wire [8:0] add_158 = joined_6 + 9'd12;
    wire lt_163 = add_158 < {1'd0, mul_151_d1[22:15]};
    wire [23:0] joined_7 = {~mul_f24_ftz_unit_copy6_y[23], mul_f24_ftz_unit_copy6_y[22:0]};
    wire beyond_near = delay_6_from_1_out & le_f24_ftz_unit_y;
    wire [23:0] select_188 = beyond_near ? add_179_d2 : add_176_d3;
    wire [23:0] select_190 = beyond_near ? mul_183_d3 : min_189_d1;
    wire and_196 = lt_92_d1 & le_195_d4;
    wire and_197 = lt_149_d1 & and_196_d1;
    wire and_202 = and_197 & delay_9_from_7_out;
    wire or_203 = delay_17_from_0_out | and_202;
    wire [9:0] joined_8 = {2'd0, add_f24_ftz_unit_y[22:15]};
    wire lt_207 = joined_8 < 10'd140;
    wire lt_210 = lt_207;
    wire placed = lt_207_d1 & lt_210;
    wire [27:0] joined_9 = {to_fixed_f24_ftz_s27q13_unit_y[26], to_fixed_f24_ftz_s27q13_unit_y};
    wire not_215 = ~to_fixed_f24_ftz_s27q13_unit_y[26];
    wire [27:0] add_219 = joined_9 + {27'd0, not_215};
    wire [27:0] min_222 = ($signed(shr_221_d1) < $signed(28'h1ffffff)) ? shr_221_d1 : 28'h1ffffff;
    wire not_227 = not_215;
    wire [27:0] add_231 = joined_9 + {27'd0, not_227};
    wire [27:0] min_233 = ($signed(shr_232_d1) < $signed(28'h1ffffff)) ? shr_232_d1 : 28'h1ffffff;
    wire [26:0] sub_243 = reinterpret_241_d1 - resize_242_d1;
    wire [26:0] add_238 = 27'd1 + {18'd0, resize_91_d1};
    wire [26:0] sub_246 = reinterpret_245_d1 - resize_242_d1;
    wire [26:0] not_248 = ~sub_243_d1;
    wire [26:0] select_249 = sub_243_d1[26] ? not_248 : sub_243_d1;
    wire [26:0] not_252 = ~sub_246;
    wire [26:0] sub_262 = reinterpret_260_d1 - resize_261_d1;
    wire [26:0] add_257 = 27'd1 + {18'd0, resize_148_d1};
    wire [26:0] sub_265 = reinterpret_264_d1 - resize_261_d1;
    wire [26:0] not_267 = ~sub_262_d1;
    wire [26:0] select_268 = sub_262_d1[26] ? not_267 : sub_262_d1;
    wire [26:0] select_253 = sub_246_d1[26] ? not_252_d1 : sub_246_d1;
    wire [25:0] or_255 = bits_250_d1 | select_253[25:0];
    wire [25:0] or_270 = or_255 | bits_269_d1;
    wire [26:0] not_272 = ~sub_265;
    wire [26:0] select_273 = sub_265_d1[26] ? not_272_d1 : sub_265_d1;
    wire [25:0] or_275 = or_270_d1 | select_273[25:0];
    wire equal_279 = bits_277_d1 == 11'd0;
    wire not_280 = ~equal_279;
    wire equal_285 = bits_283_d1 == 10'd0;
    wire not_286 = ~equal_285;
    wire equal_290 = 9'd0 == bits_289_d1;
    wire not_291 = ~equal_290;
    wire [3:0] select_282 = not_280_d1 ? 4'd1 : 4'd0;
    wire [3:0] select_288 = not_286_d1 ? 4'd2 : select_282;
    wire [3:0] select_293 = not_291_d1 ? 4'd3 : select_288;
    wire equal_296 = bits_294_d1 == 8'd0;
    wire not_297 = ~equal_296;
    wire equal_302 = bits_300_d1 == 7'd0;
    wire not_303 = ~equal_302;
    wire equal_308 = bits_306_d1 == 6'd0;
    wire not_309 = ~equal_308;
    wire [3:0] select_299 = not_297_d1 ? 4'd4 : select_293_d1;
    wire [3:0] select_305 = not_303_d1 ? 4'd5 : select_299;
    wire [3:0] select_311 = not_309_d1 ? 4'd6 : select_305;
    wire equal_314 = bits_312_d1 == 5'd0;
    wire not_315 = ~equal_314;
    wire equal_319 = 4'd0 == bits_318_d1;
    wire not_320 = ~equal_319;
    wire equal_325 = or_275[25:23] == 3'd0;
    wire not_326 = ~equal_325_d1;
    wire [3:0] select_317 = not_315_d1 ? 4'd7 : select_311_d1;
    wire [3:0] select_322 = not_320_d1 ? 4'd8 : select_317;
    wire [3:0] select_328 = not_326 ? 4'd9 : select_322;
    wire equal_331 = or_275[25:24] == 2'd0;
    wire equal_337 = ~or_275[25];
    wire not_338 = ~equal_337_d1;
    wire not_332 = ~equal_331_d1;
    wire [3:0] select_334 = not_332 ? 4'd10 : select_328_d1;
    wire [3:0] shift = not_338 ? 4'd11 : select_334;
    wire [9:0] add_343 = {6'd0, shift_d1} + 10'd4;
    wire lt_345 = add_343_d1 < delay_10_from_6_out[10:1];
    wire [9:0] sub_346 = delay_10_from_6_out[10:1] - add_343_d1;
    wire [9:0] select_347 = lt_345 ? sub_346 : 10'd0;
    wire [9:0] joined_10 = {2'd0, mul_f24_ftz_unit_copy4_y[22:15]};
    wire [9:0] max_360 = (select_347_d1 < delay_12_from_6_out[9:0]) ? delay_12_from_6_out[9:0] : select_347_d1;
    wire [9:0] max_361 = (resize_351_d13 < max_360_d1) ? max_360_d1 : resize_351_d13;
    wire [9:0] max_362 = (resize_353_d13 < max_361_d1) ? max_361_d1 : resize_353_d13;
    wire [9:0] max_363 = (resize_355_d13 < max_362_d1) ? max_362_d1 : resize_355_d13;
    wire [9:0] max_364 = (resize_357_d11 < max_363_d1) ? max_363_d1 : resize_357_d11;
    wire [9:0] exponent = (resize_359_d11 < max_364_d1) ? max_364_d1 : resize_359_d11;
    wire [9:0] add_367 = delay_12_from_6_out[9:0] + 10'd126;
    wire lt_368 = exponent_d1 < add_367_d1;
    wire and_371 = lt_368 & delay_13_from_6_out[0];
    wire [9:0] sub_372 = add_367_d1 - exponent_d1;
    wire [9:0] select_373 = and_371_d1 ? sub_372 : 10'd0;
    wire [17:0] joined_11 = {to_fixed_f24_ftz_s17q16_unit_y[16], to_fixed_f24_ftz_s17q16_unit_y};
    wire not_382 = ~to_fixed_f24_ftz_s17q16_unit_y[16];
    wire [17:0] add_386 = joined_11 + {17'd0, not_382};
    wire [17:0] min_389 = ($signed(shr_388_d1) < $signed(18'h7fff)) ? shr_388_d1 : 18'h7fff;
    wire [9:0] add_391 = delay_12_from_6_out[19:10] + 10'd126;
    wire lt_392 = exponent_d1 < add_391_d1;
    wire and_395 = lt_392 & delay_13_from_6_out[1];
    wire [9:0] sub_396 = add_391_d1 - exponent_d1;
    wire [9:0] select_397 = and_395_d1 ? sub_396 : 10'd0;
    wire not_406 = not_382;
    wire [17:0] add_410 = joined_11 + {17'd0, not_406};
    wire [17:0] min_412 = ($signed(shr_411_d1) < $signed(18'h7fff)) ? shr_411_d1 : 18'h7fff;
    wire [9:0] add_414 = delay_12_from_6_out[29:20] + 10'd126;
    wire lt_415 = exponent_d1 < add_414_d1;
    wire and_418 = lt_415 & delay_13_from_6_out[2];
    wire [9:0] sub_419 = add_414_d1 - exponent_d1;
    wire [9:0] select_420 = and_418_d1 ? sub_419 : 10'd0;
    wire not_429 = not_382;
    wire [17:0] add_433 = joined_11 + {17'd0, not_429};
    wire [17:0] min_435 = ($signed(shr_434_d1) < $signed(18'h7fff)) ? shr_434_d1 : 18'h7fff;
    wire [9:0] add_437 = delay_11_from_6_out[9:0] + 10'd126;
    wire lt_438 = exponent_d1 < add_437_d1;
    wire and_441 = lt_438 & delay_13_from_6_out[3];
    wire [9:0] sub_442 = add_437_d1 - exponent_d1;
    wire [9:0] select_443 = and_441_d1 ? sub_442 : 10'd0;
    wire not_452 = not_382;
    wire [17:0] add_456 = joined_11 + {17'd0, not_452};
    wire [17:0] min_458 = ($signed(shr_457_d1) < $signed(18'h7fff)) ? shr_457_d1 : 18'h7fff;
    wire [9:0] add_460 = delay_10_from_6_out[20:11] + 10'd126;
    wire lt_461 = exponent_d1 < add_460_d1;
    wire and_464 = lt_461 & delay_11_from_6_out[10];
    wire [9:0] sub_465 = add_460_d1 - exponent_d1;
    wire [9:0] select_466 = and_464_d1 ? sub_465 : 10'd0;
    wire not_475 = not_382;
    wire [17:0] add_479 = joined_11 + {17'd0, not_475};
    wire [17:0] min_481 = ($signed(shr_480_d1) < $signed(18'h7fff)) ? shr_480_d1 : 18'h7fff;
    wire [9:0] add_483 = delay_10_from_1_out + 10'd126;
    wire lt_484 = exponent_d1 < add_483_d1;
    wire and_487 = lt_484 & delay_11_from_1_out[0];
    wire [9:0] sub_488 = add_483_d1 - exponent_d1;
    wire [9:0] select_489 = and_487_d1 ? sub_488 : 10'd0;
    wire not_498 = not_382;
    wire [17:0] add_502 = joined_11 + {17'd0, not_498};
    wire [17:0] min_504 = ($signed(shr_503_d1) < $signed(18'h7fff)) ? shr_503_d1 : 18'h7fff;
    wire [9:0] add_506 = add_343_d1 + exponent_d1;
    wire [9:0] add_507 = resize_344_d11 + 10'd126;
    wire lt_508 = add_506 < add_507;
    wire [9:0] sub_512 = add_507 - add_506;
    wire and_511 = lt_508_d1 & delay_11_from_6_out[27];
    wire [9:0] select_513 = and_511 ? sub_512_d1 : 10'd0;
    wire [21:0] joined_12 = {to_fixed_f24_ftz_s21q20_unit_y[20], to_fixed_f24_ftz_s21q20_unit_y};
    wire not_521 = ~to_fixed_f24_ftz_s21q20_unit_y[20];
    wire [21:0] add_525 = joined_12 + {21'd0, not_521};
    wire [21:0] min_528 = ($signed(shr_527_d1) < $signed(22'h7ffff)) ? shr_527_d1 : 22'h7ffff;
    wire [9:0] joined_13 = {2'd0, mul_f24_ftz_unit_y[22:15]};
    wire equal_531 = joined_13 == 10'd255;
    wire [9:0] joined_14 = {2'd0, mul_f24_ftz_unit_copy2_y[22:15]};
    wire equal_532 = joined_14 == 10'd255;
    wire or_533 = equal_531 | equal_532;
    wire [9:0] joined_15 = {2'd0, mul_f24_ftz_unit_copy3_y[22:15]};
    wire equal_534 = joined_15 == 10'd255;
    wire or_535 = or_533_d1 | equal_534_d1;
    wire equal_536 = resize_355_d1 == 10'd255;
    wire or_537 = or_535 | equal_536;
    wire [9:0] joined_16 = {2'd0, add_f24_ftz_unit_copy2_y[22:15]};
    wire equal_538 = joined_16 == 10'd255;
    wire or_539 = or_537_d2 | equal_538;
    wire [9:0] joined_17 = {2'd0, add_f24_ftz_unit_copy5_y[22:15]};
    wire equal_540 = joined_17 == 10'd255;
    wire or_541 = or_539_d1 | equal_540;
    wire equal_542 = joined_8 == 10'd255;
    wire lt_545 = $signed(resize_529_d1) < $signed(20'd32);
    wire lt_547 = $signed(20'hfffe0) < $signed(resize_529_d1);
    wire vanishes = lt_545 & lt_547;
    wire not_549 = ~placed_d2;
    wire edge_on = equal_160_d1 | lt_163_d1;
    wire or_550 = edge_on | not_549_d1;
    wire [23:0] choice_18 = phase[1] ? (phase[0] ? add_f24_ftz_unit_y : in_center_z) : in_center_z;
    wire [23:0] choice_19 = phase[1] ? (phase[0] ? scale_x : mul_17_d3) : recip_f24_ftz_unit_y;
    wire [23:0] choice_20 = phase[1] ? mul_f24_ftz_unit_y : phase[0] ? mul_17_d3 : scale_x;
    wire [23:0] choice_21 = phase[1] ? (phase[0] ? mul_31_d1 : mul_f24_ftz_unit_y) : phase[0] ? reinterpret_16_d3 : add_49_d2;
    wire [23:0] choice_22 = phase[1] ? mul_f24_ftz_unit_y : phase[0] ? mul_43_d1 : add_f24_ftz_unit_copy2_y;
    wire [23:0] choice_23 = phase[1] ? (phase[0] ? mul_37_d1 : mul_19_d3) : recip_f24_ftz_unit_y;
    wire [23:0] choice_24 = phase[0] ? mul_f24_ftz_unit_copy2_y : mul_f24_ftz_unit_copy3_y;
    wire [23:0] choice_25 = phase[1] ? (phase[0] ? mul_37_d1 : mul_f24_ftz_unit_copy2_y) : phase[0] ? reinterpret_18_d3 : add_54_d1;
    wire [23:0] choice_26 = phase[1] ? choice_24 : phase[0] ? mul_102_d1 : add_f24_ftz_unit_copy3_y;
    wire [23:0] choice_27 = phase[1] ? (phase[0] ? mul_43_d1 : recip_15_d1) : recip_f24_ftz_unit_y;
    wire [23:0] choice_28 = phase[1] ? (phase[0] ? mul_f24_ftz_unit_y : mul_174_d6) : phase[0] ? mul_43_d1 : scale_y;
    wire [23:0] choice_29 = phase[1] ? (phase[0] ? mul_43_d1 : reinterpret_97_d3) : phase[0] ? reinterpret_30_d3 : add_114_d2;
    wire [23:0] choice_30 = phase[0] ? mul_f24_ftz_unit_copy3_y : mul_f24_ftz_unit_copy5_y;
    wire [23:0] choice_31 = phase[1] ? choice_30 : phase[0] ? mul_102_d1 : add_f24_ftz_unit_copy4_y;
    wire [23:0] choice_32 = phase[1] ? (phase[0] ? mul_102_d1 : recip_15_d1) : recip_f24_ftz_unit_y;
    wire [23:0] choice_33 = phase[1] ? (phase[0] ? mul_f24_ftz_unit_copy2_y : abs_180_d1) : scale_y;
    wire [23:0] choice_34 = phase[1] ? (phase[0] ? mul_102_d1 : reinterpret_103_d3) : phase[0] ? reinterpret_32_d3 : add_119_d1;
    wire [23:0] choice_35 = phase[0] ? mul_f24_ftz_unit_copy3_y : mul_f24_ftz_unit_copy6_y;
    wire [23:0] choice_36 = phase[1] ? (phase[0] ? mul_108_d1 : mul_17_d3) : phase[0] ? recip_f24_ftz_unit_y : add_22_d4;
    wire [23:0] choice_37 = phase[1] ? (phase[0] ? mul_f24_ftz_unit_y : select_190_d1) : phase[0] ? mul_17_d3 : scale_y;
    wire [23:0] choice_38 = phase[1] ? (phase[0] ? mul_108_d1 : mul_f24_ftz_unit_copy3_y) : phase[0] ? reinterpret_38_d3 : recip_f24_ftz_unit_y;
    wire [23:0] choice_39 = phase[1] ? (phase[0] ? mul_f24_ftz_unit_copy6_y : epsilon_scale) : phase[0] ? mul_108_d1 : mul_96_d1;
    wire [23:0] choice_40 = phase[1] ? (phase[0] ? recip_15_d1 : mul_19_d3) : recip_f24_ftz_unit_y;
    wire [23:0] choice_41 = phase[1] ? (phase[0] ? mul_f24_ftz_unit_copy2_y : mul_19_d3) : phase[0] ? mul_19_d3 : mul_37_d1;
    wire [23:0] choice_42 = phase[1] ? (phase[0] ? depth_b : mul_f24_ftz_unit_copy4_y) : phase[0] ? reinterpret_95_d3 : sqrt_181_d1;
    wire [23:0] choice_43 = phase[1] ? (phase[0] ? mul_f24_ftz_unit_copy6_y : mul_37_d1) : phase[0] ? mul_37_d1 : mul_108_d1;
    wire [23:0] choice_44 = phase[1] ? (phase[0] ? mul_151_d1 : mul_f24_ftz_unit_copy5_y) : mul_f24_ftz_unit_y;
    wire [23:0] choice_45 = phase[1] ? (phase[0] ? add_46_d7 : add_46_d4) : phase[0] ? mul_f24_ftz_unit_y : 24'h3f8000;
    wire [23:0] joined_46 = {~mul_f24_ftz_unit_copy3_y[23], mul_f24_ftz_unit_copy3_y[22:0]};
    wire [23:0] choice_47 = phase[1] ? (phase[0] ? joined_46 : origin_y) : phase[0] ? origin_x : mul_f24_ftz_unit_copy2_y;
    wire [23:0] joined_48 = {~filter_radius[23], filter_radius[22:0]};
    wire [23:0] choice_49 = phase[0] ? joined_48 : {~mul_f24_ftz_unit_y[23], mul_f24_ftz_unit_y[22:0]};
    wire [23:0] choice_50 = phase[0] ? mul_f24_ftz_unit_copy2_y : {~add_f24_ftz_unit_y[23], add_f24_ftz_unit_y[22:0]};
    wire [23:0] choice_51 = phase[0] ? mul_f24_ftz_unit_copy2_y : mul_f24_ftz_unit_copy5_y;
    wire [23:0] choice_52 = phase[1] ? (phase[0] ? mul_f24_ftz_unit_copy2_y : add_124_d4) : choice_51;
    wire [23:0] choice_53 = phase[1] ? (phase[0] ? filter_radius : add_59_d4) : phase[0] ? mul_33_d1 : mul_f24_ftz_unit_y;
    wire [23:0] joined_54 = {~mul_f24_ftz_unit_copy5_y[23], mul_f24_ftz_unit_copy5_y[22:0]};
    wire [23:0] choice_55 = phase[1] ? (phase[0] ? joined_54 : neg_125_d1) : choice_35;
    wire [23:0] choice_56 = phase[1] ? (phase[0] ? add_46_d7 : joined_5) : phase[0] ? joined_46 : mul_55_d1;
    wire [23:0] choice_57 = phase[0] ? mul_f24_ftz_unit_copy4_y : sqrt_f24_ftz_unit_y;
    wire [23:0] choice_58 = phase[1] ? (phase[0] ? add_f24_ftz_unit_copy4_y : joined_48) : choice_57;
    wire [23:0] choice_59 = phase[0] ? delay_5_from_5_out[23:0] : sqrt_f24_ftz_unit_y;
    wire [23:0] choice_60 = phase[1] ? choice_59 : phase[0] ? mul_39_d1 : mul_f24_ftz_unit_copy2_y;
    wire [23:0] choice_61 = phase[0] ? {~mul_183_d1[23], mul_183_d1[22:0]} : add_111_d9;
    wire [23:0] choice_62 = phase[1] ? choice_61 : phase[0] ? mul_f24_ftz_unit_copy5_y : add_124_d4;
    wire [23:0] joined_63 = {~mul_f24_ftz_unit_copy4_y[23], mul_f24_ftz_unit_copy4_y[22:0]};
    wire [23:0] choice_64 = phase[1] ? (phase[0] ? depth_a : add_59_d4) : phase[0] ? joined_63 : mul_120_d1;
    wire [23:0] choice_65 = phase[1] ? (phase[0] ? select_188_d2 : filter_radius) : filter_radius;
    wire [23:0] choice_66 = phase[1] ? add_111_d4 : phase[0] ? mul_98_d1 : add_176_d1;
    wire [23:0] joined_67 = {~add_f24_ftz_unit_copy5_y[23], add_f24_ftz_unit_copy5_y[22:0]};
    wire [23:0] choice_68 = phase[1] ? (phase[0] ? joined_67 : add_111_d8) : add_111_d8;
    wire [23:0] choice_69 = phase[1] ? joined_46 : phase[0] ? joined_54 : mul_f24_ftz_unit_copy3_y;
    wire [23:0] choice_70 = phase[1] ? (phase[0] ? select_188_d2 : mul_169_d1) : mul_169_d1;
    wire [23:0] choice_71 = phase[1] ? mul_169_d1 : phase[0] ? mul_104_d1 : mul_f24_ftz_unit_copy5_y;
    wire [23:0] choice_72 = phase[1] ? (phase[0] ? add_f24_ftz_unit_copy5_y : neg_171_d1) : neg_171_d1;
    wire [23:0] choice_73 = phase[1] ? neg_171_d1 : phase[0] ? joined_7 : epsilon_bias;
    wire [23:0] choice_74 = phase[1] ? (phase[0] ? add_f24_ftz_unit_copy2_y : add_22_d1) : add_22_d1;
    wire [23:0] choice_75 = phase[1] ? (phase[0] ? 24'h45fff8 : add_f24_ftz_unit_copy2_y) : phase[0] ? add_f24_ftz_unit_copy2_y : max_f24_ftz_unit_y;
    wire [23:0] choice_76 = phase[1] ? add_f24_ftz_unit_copy2_y : phase[0] ? add_f24_ftz_unit_copy2_y : 24'h3f8000;
    wire [23:0] choice_77 = phase[1] ? (phase[0] ? max_131_d1 : add_f24_ftz_unit_copy3_y) : phase[0] ? add_f24_ftz_unit_copy3_y : 24'h45fff8;
    wire [23:0] choice_78 = phase[1] ? (phase[0] ? add_f24_ftz_unit_copy3_y : 24'd0) : add_f24_ftz_unit_copy3_y;
    wire [23:0] choice_79 = phase[1] ? (phase[0] ? min_f24_ftz_unit_y : add_f24_ftz_unit_copy4_y) : 24'd0;
    wire [23:0] choice_80 = phase[1] ? (phase[0] ? add_f24_ftz_unit_copy4_y : min_f24_ftz_unit_y) : add_66_d1;
    wire [23:0] choice_81 = phase[1] ? max_f24_ftz_unit_y : phase[0] ? max_f24_ftz_unit_y : max_f24_ftz_unit_copy2_y;
    wire [23:0] choice_82 = phase[1] ? (phase[0] ? 24'h3f8000 : add_f24_ftz_unit_copy3_y) : add_f24_ftz_unit_copy3_y;
    wire [23:0] choice_83 = phase[1] ? (phase[0] ? reinterpret_403_d1 : reinterpret_379_d1) : reinterpret_495_d1;
    wire [23:0] choice_84 = phase[1] ? (phase[0] ? reinterpret_495_d1 : reinterpret_472_d1) : phase[0] ? reinterpret_449_d1 : reinterpret_426_d1;
    wire [23:0] choice_85 = phase[1] ? max_569_d1 : phase[0] ? max_f24_ftz_unit_copy2_y : max_f24_ftz_unit_y;
    wire [25:0] select_235 = placed_d2 ? resize_234_d1 : 26'h2000000;
    wire [25:0] select_224 = placed_d2 ? resize_223_d1 : 26'h2000000;
    wire equal_485 = 10'd0 == joined_17;
    wire not_486 = ~equal_485;
    wire odd = or_541_d1 | equal_542_d1;
    wire or_551 = odd | or_550_d1;
    wire equal_509 = 10'd0 == joined_8;
    wire not_510 = ~equal_509;
    wire equal_462 = 10'd0 == joined_16;
    wire not_463 = ~equal_462;
    wire equal_439 = 10'd0 == joined_10;
    wire not_440 = ~equal_439;
    wire equal_416 = 10'd0 == joined_15;
    wire not_417 = ~equal_416;
    wire equal_393 = 10'd0 == joined_14;
    wire not_394 = ~equal_393;
    wire equal_369 = 10'd0 == joined_13;
    wire not_370 = ~equal_369;
    wire xor_199 = scale_x[23] ^ scale_y[23];
    wire xor_200 = bits_198_d1 ^ xor_199;
    wire or_201 = edge_on | xor_200;

    assign in_ready = load_0;
    assign out_valid = queue_out_valid;
    assign {
        out_end, out_center_x, out_center_y, out_ax, out_bx, out_ay, out_by, out_delta, out_mx, out_my,
        out_shift, out_depth, out_depth_low, out_depth_high, out_attribute_0, out_attribute_1,
        out_attribute_2, out_left, out_right, out_top, out_bottom
    } = queue_out_data;

    stream_skid_w317 queue (
        .clk(clk), .rst(rst),
        .in_valid(term_2), .in_ready(queue_in_ready),
        .in_data({
            end_d21, select_224_d13, select_235_d13, select_554, select_555, select_556, select_557, select_559,
            select_560, select_561, shift_d3, delay_7_from_1_out, delay_5_from_5_out[47:24], to_fixed_570_d4,
            delay_21_from_0_out[11:0], delay_21_from_0_out[23:12], delay_21_from_0_out[35:24], delay_5_from_3_out,
            resize_91_d5, delay_5_from_0_out, resize_148_d4
        }),
        .out_valid(queue_out_valid), .out_ready(out_ready), .out_data(queue_out_data)
    );

    float_recip_s20_f24ftz recip_f24_ftz_unit (
        .clk(clk), .enable(queue_in_ready), .a(recip_f24_ftz_unit_a), .y(recip_f24_ftz_unit_y)
    );

    float_mul_s5_f24ftz mul_f24_ftz_unit (
        .clk(clk), .enable(queue_in_ready), .a(mul_f24_ftz_unit_a), .b(mul_f24_ftz_unit_b),
        .y(mul_f24_ftz_unit_y)
    );

    float_mul_s5_f24ftz mul_f24_ftz_unit_copy2 (
        .clk(clk), .enable(queue_in_ready), .a(mul_f24_ftz_unit_copy2_a), .b(mul_f24_ftz_unit_copy2_b),
        .y(mul_f24_ftz_unit_copy2_y)
    );

    float_mul_s5_f24ftz mul_f24_ftz_unit_copy3 (
        .clk(clk), .enable(queue_in_ready), .a(mul_f24_ftz_unit_copy3_a), .b(mul_f24_ftz_unit_copy3_b),
        .y(mul_f24_ftz_unit_copy3_y)
    );

    float_mul_s5_f24ftz mul_f24_ftz_unit_copy4 (
        .clk(clk), .enable(queue_in_ready), .a(mul_f24_ftz_unit_copy4_a), .b(mul_f24_ftz_unit_copy4_b),
        .y(mul_f24_ftz_unit_copy4_y)
    );

    float_mul_s5_f24ftz mul_f24_ftz_unit_copy5 (
        .clk(clk), .enable(queue_in_ready), .a(mul_f24_ftz_unit_copy5_a), .b(mul_f24_ftz_unit_copy5_b),
        .y(mul_f24_ftz_unit_copy5_y)
    );

    float_mul_s5_f24ftz mul_f24_ftz_unit_copy6 (
        .clk(clk), .enable(queue_in_ready), .a(mul_f24_ftz_unit_copy6_a), .b(mul_f24_ftz_unit_copy6_b),
        .y(mul_f24_ftz_unit_copy6_y)
    );

    float_add_s6_f24ftz add_f24_ftz_unit (
        .clk(clk), .enable(queue_in_ready), .a(add_f24_ftz_unit_a), .b(add_f24_ftz_unit_b),
        .y(add_f24_ftz_unit_y)
    );

    float_add_s6_f24ftz add_f24_ftz_unit_copy2 (
        .clk(clk), .enable(queue_in_ready), .a(add_f24_ftz_unit_copy2_a), .b(add_f24_ftz_unit_copy2_b),
        .y(add_f24_ftz_unit_copy2_y)
    );

    float_add_s6_f24ftz add_f24_ftz_unit_copy3 (
        .clk(clk), .enable(queue_in_ready), .a(add_f24_ftz_unit_copy3_a), .b(add_f24_ftz_unit_copy3_b),
        .y(add_f24_ftz_unit_copy3_y)
    );

    float_add_s6_f24ftz add_f24_ftz_unit_copy4 (
        .clk(clk), .enable(queue_in_ready), .a(add_f24_ftz_unit_copy4_a), .b(add_f24_ftz_unit_copy4_b),
        .y(add_f24_ftz_unit_copy4_y)
    );

    float_add_s6_f24ftz add_f24_ftz_unit_copy5 (
        .clk(clk), .enable(queue_in_ready), .a(add_f24_ftz_unit_copy5_a), .b(add_f24_ftz_unit_copy5_b),
        .y(add_f24_ftz_unit_copy5_y)
    );

    float_lt_s2_f24ftz lt_f24_ftz_unit (
        .clk(clk), .enable(queue_in_ready), .a(24'h3d0000), .b(add_f24_ftz_unit_y), .y(lt_f24_ftz_unit_y)
    );

    float_sqrt_s18_f24ftz sqrt_f24_ftz_unit (
        .clk(clk), .enable(queue_in_ready), .a(sqrt_f24_ftz_unit_a), .y(sqrt_f24_ftz_unit_y)
    );

    float_min_s2_f24ftz min_f24_ftz_unit (
        .clk(clk), .enable(queue_in_ready), .a(min_f24_ftz_unit_a), .b(min_f24_ftz_unit_b),
        .y(min_f24_ftz_unit_y)
    );

    float_max_s2_f24ftz max_f24_ftz_unit (
        .clk(clk), .enable(queue_in_ready), .a(max_f24_ftz_unit_a), .b(max_f24_ftz_unit_b),
        .y(max_f24_ftz_unit_y)
    );

    float_max_s2_f24ftz max_f24_ftz_unit_copy2 (
        .clk(clk), .enable(queue_in_ready), .a(max_f24_ftz_unit_copy2_a), .b(max_f24_ftz_unit_copy2_b),
        .y(max_f24_ftz_unit_copy2_y)
    );

    float_to_fixed_s3_f24ftz_w21_f8_unsigned to_fixed_f24_ftz_u21q8_unit (
        .clk(clk), .enable(queue_in_ready), .a(to_fixed_f24_ftz_u21q8_unit_a),
        .y(to_fixed_f24_ftz_u21q8_unit_y)
    );

    float_le_s2_f24ftz le_f24_ftz_unit (
        .clk(clk), .enable(queue_in_ready), .a(le_f24_ftz_unit_a), .b(le_f24_ftz_unit_b),
        .y(le_f24_ftz_unit_y)
    );

    float_to_fixed_s3_f24ftz_w27_f13_signed to_fixed_f24_ftz_s27q13_unit (
        .clk(clk), .enable(queue_in_ready), .a(to_fixed_f24_ftz_s27q13_unit_a),
        .y(to_fixed_f24_ftz_s27q13_unit_y)
    );

    float_to_fixed_s3_f24ftz_w17_f16_signed to_fixed_f24_ftz_s17q16_unit (
        .clk(clk), .enable(queue_in_ready), .a(to_fixed_f24_ftz_s17q16_unit_a),
        .y(to_fixed_f24_ftz_s17q16_unit_y)
    );

    float_to_fixed_s3_f24ftz_w21_f20_signed to_fixed_f24_ftz_s21q20_unit (
        .clk(clk), .enable(queue_in_ready), .a(reinterpret_518_d1), .y(to_fixed_f24_ftz_s21q20_unit_y)
    );

    float_to_fixed_s3_f24ftz_w24_f24_unsigned to_fixed_f24_ftz_u24q24_unit (
        .clk(clk), .enable(queue_in_ready), .a(to_fixed_f24_ftz_u24q24_unit_a),
        .y(to_fixed_f24_ftz_u24q24_unit_y)
    );

    always @(posedge clk) begin
        if (rst) begin
            phase <= 3'd0;
            load_0 <= 1'd1;
            load_1 <= 1'd0;
            load_2 <= 1'd0;
            load_3 <= 1'd0;
            load_4 <= 1'd0;
            load_5 <= 1'd0;
            load_6 <= 1'd0;
            load_7 <= 1'd0;
            delay_5_from_0_pointer <= 2'd0;
            delay_17_from_0_pointer <= 4'd0;
            delay_21_from_0_pointer <= 5'd0;
            delay_6_from_1_pointer <= 3'd0;
            delay_7_from_1_pointer <= 3'd0;
            delay_9_from_1_pointer <= 3'd0;
            delay_10_from_1_pointer <= 4'd0;
            delay_11_from_1_pointer <= 4'd0;
            delay_12_from_2_pointer <= 4'd0;
            delay_5_from_3_pointer <= 2'd0;
            delay_5_from_5_pointer <= 2'd0;
            delay_12_from_5_pointer <= 4'd0;
            delay_10_from_6_pointer <= 4'd0;
            delay_11_from_6_pointer <= 4'd0;
            delay_12_from_6_pointer <= 4'd0;
            delay_13_from_6_pointer <= 4'd0;
            delay_9_from_7_pointer <= 3'd0;
            in_flight <= 21'd0;
        end else begin
            phase <= phase_next;
            load_0 <= advance_next & (phase_next == 3'd0);
            load_1 <= advance_next & (phase_next == 3'd1);
            load_2 <= advance_next & (phase_next == 3'd2);
            load_3 <= advance_next & (phase_next == 3'd3);
            load_4 <= advance_next & (phase_next == 3'd4);
            load_5 <= advance_next & (phase_next == 3'd5);
            load_6 <= advance_next & (phase_next == 3'd6);
            load_7 <= advance_next & (phase_next == 3'd7);
            if (load_0) begin
                delay_5_from_0_pointer <= (delay_5_from_0_pointer == 2'd3) ? (delay_5_from_0_pointer - 2'd3) : (delay_5_from_0_pointer + 2'd1);
                delay_17_from_0_pointer <= (delay_17_from_0_pointer == 4'd15) ? (delay_17_from_0_pointer - 4'd15) : (delay_17_from_0_pointer + 4'd1);
                delay_21_from_0_pointer <= (delay_21_from_0_pointer == 5'd19) ? (delay_21_from_0_pointer - 5'd19) : (delay_21_from_0_pointer + 5'd1);
                in_flight <= {in_flight[19:0], in_valid};
            end
            if (load_1) begin
                delay_6_from_1_pointer <= (delay_6_from_1_pointer == 3'd4) ? (delay_6_from_1_pointer - 3'd4) : (delay_6_from_1_pointer + 3'd1);
                delay_7_from_1_pointer <= (delay_7_from_1_pointer == 3'd5) ? (delay_7_from_1_pointer - 3'd5) : (delay_7_from_1_pointer + 3'd1);
                delay_9_from_1_pointer <= (delay_9_from_1_pointer == 3'd7) ? (delay_9_from_1_pointer - 3'd7) : (delay_9_from_1_pointer + 3'd1);
                delay_10_from_1_pointer <= (delay_10_from_1_pointer == 4'd8) ? (delay_10_from_1_pointer - 4'd8) : (delay_10_from_1_pointer + 4'd1);
                delay_11_from_1_pointer <= (delay_11_from_1_pointer == 4'd9) ? (delay_11_from_1_pointer - 4'd9) : (delay_11_from_1_pointer + 4'd1);
            end
            if (load_2) begin
                delay_12_from_2_pointer <= (delay_12_from_2_pointer == 4'd10) ? (delay_12_from_2_pointer - 4'd10) : (delay_12_from_2_pointer + 4'd1);
            end
            if (load_3) begin
                delay_5_from_3_pointer <= (delay_5_from_3_pointer == 2'd3) ? (delay_5_from_3_pointer - 2'd3) : (delay_5_from_3_pointer + 2'd1);
            end
            if (load_5) begin
                delay_5_from_5_pointer <= (delay_5_from_5_pointer == 2'd3) ? (delay_5_from_5_pointer - 2'd3) : (delay_5_from_5_pointer + 2'd1);
                delay_12_from_5_pointer <= (delay_12_from_5_pointer == 4'd10) ? (delay_12_from_5_pointer - 4'd10) : (delay_12_from_5_pointer + 4'd1);
            end
            if (load_6) begin
                delay_10_from_6_pointer <= (delay_10_from_6_pointer == 4'd8) ? (delay_10_from_6_pointer - 4'd8) : (delay_10_from_6_pointer + 4'd1);
                delay_11_from_6_pointer <= (delay_11_from_6_pointer == 4'd9) ? (delay_11_from_6_pointer - 4'd9) : (delay_11_from_6_pointer + 4'd1);
                delay_12_from_6_pointer <= (delay_12_from_6_pointer == 4'd10) ? (delay_12_from_6_pointer - 4'd10) : (delay_12_from_6_pointer + 4'd1);
                delay_13_from_6_pointer <= (delay_13_from_6_pointer == 4'd11) ? (delay_13_from_6_pointer - 4'd11) : (delay_13_from_6_pointer + 4'd1);
            end
            if (load_7) begin
                delay_9_from_7_pointer <= (delay_9_from_7_pointer == 3'd7) ? (delay_9_from_7_pointer - 3'd7) : (delay_9_from_7_pointer + 3'd1);
            end
        end
    end
    always @(posedge clk) begin
        if (load_0) begin
            end_d18 <= delay_17_from_0_out;
            end_d19 <= end_d18;
            end_d20 <= end_d19;
            end_d21 <= end_d20;
            reinterpret_16_d1 <= in_tangent1_z;
            reinterpret_16_d2 <= reinterpret_16_d1;
            reinterpret_16_d3 <= reinterpret_16_d2;
            reinterpret_18_d1 <= in_tangent2_z;
            reinterpret_18_d2 <= reinterpret_18_d1;
            reinterpret_18_d3 <= reinterpret_18_d2;
            add_22_d1 <= add_f24_ftz_unit_y;
            add_22_d2 <= add_22_d1;
            add_22_d3 <= add_22_d2;
            add_22_d4 <= add_22_d3;
            reinterpret_30_d1 <= in_center_x;
            reinterpret_30_d2 <= reinterpret_30_d1;
            reinterpret_30_d3 <= reinterpret_30_d2;
            reinterpret_32_d1 <= in_tangent1_x;
            reinterpret_32_d2 <= reinterpret_32_d1;
            reinterpret_32_d3 <= reinterpret_32_d2;
            reinterpret_38_d1 <= in_tangent2_x;
            reinterpret_38_d2 <= reinterpret_38_d1;
            reinterpret_38_d3 <= reinterpret_38_d2;
            resize_91_d1 <= sub_89[8:0];
            resize_91_d2 <= resize_91_d1;
            resize_91_d3 <= resize_91_d2;
            resize_91_d4 <= resize_91_d3;
            resize_91_d5 <= resize_91_d4;
            lt_92_d1 <= lt_92;
            reinterpret_95_d1 <= in_center_y;
            reinterpret_95_d2 <= reinterpret_95_d1;
            reinterpret_95_d3 <= reinterpret_95_d2;
            reinterpret_97_d1 <= in_tangent1_y;
            reinterpret_97_d2 <= reinterpret_97_d1;
            reinterpret_97_d3 <= reinterpret_97_d2;
            reinterpret_103_d1 <= in_tangent2_y;
            reinterpret_103_d2 <= reinterpret_103_d1;
            reinterpret_103_d3 <= reinterpret_103_d2;
            min_129_d1 <= min_f24_ftz_unit_y;
            select_143_d1 <= select_143;
            abs_180_d1 <= {1'd0, mul_174_d6[22:0]};
            abs_180_d2 <= abs_180_d1;
            mul_183_d1 <= mul_f24_ftz_unit_copy4_y;
            mul_183_d2 <= mul_183_d1;
            mul_183_d3 <= mul_183_d2;
            shr_221_d1 <= {add_219[27], add_219[27:1]};
            reinterpret_260_d1 <= {18'd0, select_143[8:0]} << 12;
            select_293_d1 <= select_293;
            max_362_d1 <= max_362;
            resize_505_d1 <= min_504[15:0];
        end
        if (load_5) begin
            recip_15_d1 <= recip_f24_ftz_unit_y;
            add_111_d1 <= add_f24_ftz_unit_y;
            add_111_d2 <= add_111_d1;
            add_111_d3 <= add_111_d2;
            add_111_d4 <= add_111_d3;
            add_111_d5 <= add_111_d4;
            add_111_d6 <= add_111_d5;
            add_111_d7 <= add_111_d6;
            add_111_d8 <= add_111_d7;
            add_111_d9 <= add_111_d8;
            mul_174_d6 <= delay_5_from_5_out[23:0];
            sqrt_181_d1 <= sqrt_f24_ftz_unit_y;
            placed_d1 <= placed;
            placed_d2 <= placed_d1;
            bits_250_d1 <= select_249[25:0];
            resize_261_d1 <= {delay_9_from_1_out[51], delay_9_from_1_out[51:26]};
            sub_265_d1 <= sub_265;
            not_272_d1 <= not_272;
            select_347_d1 <= select_347;
            add_367_d1 <= add_367;
            reinterpret_379_d1 <= {delay_12_from_5_out[0], select_373[7:0], delay_12_from_5_out[15:1]};
            add_391_d1 <= add_391;
            reinterpret_403_d1 <= {delay_12_from_5_out[16], select_397[7:0], delay_12_from_5_out[31:17]};
            add_414_d1 <= add_414;
            reinterpret_426_d1 <= {delay_12_from_5_out[32], select_420[7:0], delay_12_from_5_out[47:33]};
            resize_436_d1 <= min_435[15:0];
            add_437_d1 <= add_437;
            reinterpret_449_d1 <= {delay_12_from_5_out[48], select_443[7:0], delay_12_from_5_out[63:49]};
            shr_457_d1 <= {add_456[17], add_456[17:1]};
            add_460_d1 <= add_460;
            reinterpret_472_d1 <= {delay_11_from_6_out[11], select_466[7:0], delay_11_from_6_out[26:12]};
            add_483_d1 <= add_483;
            reinterpret_495_d1 <= {delay_11_from_1_out[1], select_489[7:0], delay_11_from_1_out[16:2]};
            reinterpret_518_d1 <= {delay_10_from_6_out[0], select_513[7:0], delay_11_from_6_out[42:28]};
        end
        if (load_3) begin
            mul_17_d1 <= mul_f24_ftz_unit_y;
            mul_17_d2 <= mul_17_d1;
            mul_17_d3 <= mul_17_d2;
            mul_19_d1 <= mul_f24_ftz_unit_copy2_y;
            mul_19_d2 <= mul_19_d1;
            mul_19_d3 <= mul_19_d2;
            mul_31_d1 <= mul_f24_ftz_unit_copy3_y;
            mul_33_d1 <= mul_f24_ftz_unit_copy4_y;
            mul_39_d1 <= mul_f24_ftz_unit_copy5_y;
            add_49_d1 <= add_f24_ftz_unit_y;
            add_49_d2 <= add_49_d1;
            select_85_d1 <= select_85;
            mul_96_d1 <= mul_f24_ftz_unit_copy6_y;
            add_114_d1 <= add_f24_ftz_unit_copy2_y;
            add_114_d2 <= add_114_d1;
            resize_148_d1 <= sub_146[8:0];
            resize_148_d2 <= resize_148_d1;
            resize_148_d3 <= resize_148_d2;
            resize_148_d4 <= resize_148_d3;
            lt_149_d1 <= lt_149;
            min_189_d1 <= min_f24_ftz_unit_y;
            reinterpret_241_d1 <= {18'd0, select_85[8:0]} << 12;
            or_270_d1 <= or_270;
            shift_d1 <= shift;
            shift_d2 <= shift_d1;
            shift_d3 <= shift_d2;
            exponent_d1 <= exponent;
            resize_390_d1 <= min_389[15:0];
            shr_411_d1 <= {add_410[17], add_410[17:1]};
            vanishes_d1 <= vanishes;
        end
        if (load_1) begin
            whole_d7 <= delay_6_from_1_out;
            whole_d8 <= whole_d7;
            whole_d9 <= whole_d8;
            whole_d10 <= whole_d9;
            whole_d11 <= whole_d10;
            add_59_d1 <= add_f24_ftz_unit_y;
            add_59_d2 <= add_59_d1;
            add_59_d3 <= add_59_d2;
            add_59_d4 <= add_59_d3;
            add_124_d1 <= add_f24_ftz_unit_copy4_y;
            add_124_d2 <= add_124_d1;
            add_124_d3 <= add_124_d2;
            add_124_d4 <= add_124_d3;
            shr_142_d1 <= add_141 >> 8;
            select_188_d1 <= select_188;
            select_188_d2 <= select_188_d1;
            select_190_d1 <= select_190;
            and_196_d1 <= and_196;
            resize_223_d1 <= min_222[25:0];
            select_224_d10 <= delay_9_from_1_out[25:0];
            select_224_d11 <= select_224_d10;
            select_224_d12 <= select_224_d11;
            select_224_d13 <= select_224_d12;
            shr_232_d1 <= {add_231[27], add_231[27:1]};
            select_235_d10 <= delay_9_from_1_out[51:26];
            select_235_d11 <= select_235_d10;
            select_235_d12 <= select_235_d11;
            select_235_d13 <= select_235_d12;
            reinterpret_245_d1 <= add_238 << 12;
            sub_262_d1 <= sub_262;
            select_311_d1 <= select_311;
            resize_359_d11 <= delay_10_from_1_out;
            max_363_d1 <= max_363;
            shr_527_d1 <= {add_525[21], add_525[21:1]};
            or_541_d1 <= or_541;
            max_569_d1 <= max_f24_ftz_unit_copy2_y;
        end
        if (load_6) begin
            mul_37_d1 <= mul_f24_ftz_unit_y;
            mul_43_d1 <= mul_f24_ftz_unit_copy2_y;
            shr_82_d1 <= add_81 >> 8;
            mul_102_d1 <= mul_f24_ftz_unit_copy3_y;
            mul_108_d1 <= mul_f24_ftz_unit_copy4_y;
            max_131_d1 <= max_f24_ftz_unit_y;
            mul_151_d1 <= mul_f24_ftz_unit_copy6_y;
            equal_160_d1 <= equal_160;
            lt_163_d1 <= lt_163;
            bits_198_d1 <= add_f24_ftz_unit_y[23];
            bits_277_d1 <= or_275[25:15];
            bits_283_d1 <= or_275[25:16];
            bits_289_d1 <= or_275[25:17];
            bits_294_d1 <= or_275[25:18];
            bits_300_d1 <= or_275[25:19];
            bits_306_d1 <= or_275[25:20];
            bits_312_d1 <= or_275[25:21];
            bits_318_d1 <= or_275[25:22];
            equal_325_d1 <= equal_325;
            equal_331_d1 <= equal_331;
            equal_337_d1 <= equal_337;
            resize_344_d11 <= delay_10_from_6_out[10:1];
            resize_351_d13 <= delay_12_from_6_out[19:10];
            resize_353_d13 <= delay_12_from_6_out[29:20];
            resize_355_d1 <= joined_10;
            resize_355_d13 <= delay_11_from_6_out[9:0];
            resize_357_d11 <= delay_10_from_6_out[20:11];
            max_360_d1 <= max_360;
            resize_459_d1 <= min_458[15:0];
            shr_480_d1 <= {add_479[17], add_479[17:1]};
            or_533_d1 <= or_533;
            equal_534_d1 <= equal_534;
            or_539_d1 <= or_539;
            equal_542_d1 <= equal_542;
        end
        if (load_4) begin
            add_46_d1 <= add_f24_ftz_unit_y;
            add_46_d2 <= add_46_d1;
            add_46_d3 <= add_46_d2;
            add_46_d4 <= add_46_d3;
            add_46_d5 <= add_46_d4;
            add_46_d6 <= add_46_d5;
            add_46_d7 <= add_46_d6;
            add_54_d1 <= add_f24_ftz_unit_copy2_y;
            mul_98_d1 <= mul_f24_ftz_unit_copy3_y;
            mul_104_d1 <= mul_f24_ftz_unit_copy4_y;
            add_119_d1 <= add_f24_ftz_unit_copy3_y;
            neg_125_d1 <= joined_5;
            or_203_d1 <= or_203;
            or_203_d2 <= or_203_d1;
            or_203_d3 <= or_203_d2;
            or_203_d4 <= or_203_d3;
            lt_207_d1 <= lt_207;
            sub_243_d1 <= sub_243;
            reinterpret_264_d1 <= add_257 << 12;
            add_343_d1 <= add_343;
            and_371_d1 <= and_371;
            and_395_d1 <= and_395;
            resize_413_d1 <= min_412[15:0];
            and_418_d1 <= and_418;
            shr_434_d1 <= {add_433[17], add_433[17:1]};
            and_441_d1 <= and_441;
            and_464_d1 <= and_464;
            and_487_d1 <= and_487;
            lt_508_d1 <= lt_508;
            sub_512_d1 <= sub_512;
        end
        if (load_2) begin
            mul_55_d1 <= mul_f24_ftz_unit_copy2_y;
            add_64_d1 <= add_f24_ftz_unit_y;
            add_66_d1 <= add_f24_ftz_unit_copy2_y;
            mul_120_d1 <= mul_f24_ftz_unit_copy4_y;
            min_144_d1 <= min_144;
            add_176_d1 <= add_f24_ftz_unit_copy3_y;
            add_176_d2 <= add_176_d1;
            add_176_d3 <= add_176_d2;
            le_195_d1 <= le_f24_ftz_unit_y;
            le_195_d2 <= le_195_d1;
            le_195_d3 <= le_195_d2;
            le_195_d4 <= le_195_d3;
            resize_234_d1 <= min_233[25:0];
            resize_242_d1 <= {delay_9_from_1_out[25], delay_9_from_1_out[25:0]};
            sub_246_d1 <= sub_246;
            not_252_d1 <= not_252;
            bits_269_d1 <= select_268[25:0];
            select_328_d1 <= select_328;
            max_364_d1 <= max_364;
            shr_388_d1 <= {add_386[17], add_386[17:1]};
            resize_529_d1 <= min_528[19:0];
            to_fixed_570_d1 <= to_fixed_f24_ftz_u24q24_unit_y;
            to_fixed_570_d2 <= to_fixed_570_d1;
            to_fixed_570_d3 <= to_fixed_570_d2;
            to_fixed_570_d4 <= to_fixed_570_d3;
        end
        if (load_7) begin
            min_86_d1 <= min_86;
            add_121_d1 <= add_f24_ftz_unit_copy3_y;
            mul_169_d1 <= mul_f24_ftz_unit_y;
            neg_171_d1 <= joined_7;
            add_179_d1 <= add_f24_ftz_unit_copy4_y;
            add_179_d2 <= add_179_d1;
            not_280_d1 <= not_280;
            not_286_d1 <= not_286;
            not_291_d1 <= not_291;
            not_297_d1 <= not_297;
            not_303_d1 <= not_303;
            not_309_d1 <= not_309;
            not_315_d1 <= not_315;
            not_320_d1 <= not_320;
            max_361_d1 <= max_361;
            resize_482_d1 <= min_481[15:0];
            shr_503_d1 <= {add_502[17], add_502[17:1]};
            or_537_d1 <= or_537;
            or_537_d2 <= or_537_d1;
            not_549_d1 <= not_549;
            or_550_d1 <= or_550;
        end
        if (queue_in_ready) begin
            recip_f24_ftz_unit_a <= phase[2] ? choice_18 : in_center_z;
            mul_f24_ftz_unit_a <= phase[2] ? choice_19 : choice_20;
            mul_f24_ftz_unit_b <= phase[2] ? choice_21 : choice_22;
            mul_f24_ftz_unit_copy2_a <= phase[2] ? choice_23 : phase[1] ? choice_24 : phase[0] ? mul_19_d3 : scale_x;
            mul_f24_ftz_unit_copy2_b <= phase[2] ? choice_25 : choice_26;
            mul_f24_ftz_unit_copy3_a <= phase[2] ? choice_27 : choice_28;
            mul_f24_ftz_unit_copy3_b <= phase[2] ? choice_29 : choice_31;
            mul_f24_ftz_unit_copy4_a <= phase[2] ? choice_32 : choice_33;
            mul_f24_ftz_unit_copy4_b <= phase[2] ? choice_34 : phase[1] ? choice_35 : add_f24_ftz_unit_copy5_y;
            mul_f24_ftz_unit_copy5_a <= phase[2] ? choice_36 : choice_37;
            mul_f24_ftz_unit_copy5_b <= phase[2] ? choice_38 : choice_39;
            mul_f24_ftz_unit_copy6_a <= phase[2] ? choice_40 : choice_41;
            mul_f24_ftz_unit_copy6_b <= phase[2] ? choice_42 : choice_43;
            add_f24_ftz_unit_a <= phase[2] ? choice_44 : choice_45;
            add_f24_ftz_unit_b <= phase[2] ? choice_47 : phase[1] ? choice_49 : choice_50;
            add_f24_ftz_unit_copy2_a <= phase[2] ? choice_52 : choice_53;
            add_f24_ftz_unit_copy2_b <= phase[2] ? choice_55 : choice_56;
            add_f24_ftz_unit_copy3_a <= phase[2] ? choice_58 : choice_60;
            add_f24_ftz_unit_copy3_b <= phase[2] ? choice_62 : choice_64;
            add_f24_ftz_unit_copy4_a <= phase[2] ? choice_65 : choice_66;
            add_f24_ftz_unit_copy4_b <= phase[2] ? choice_68 : choice_69;
            add_f24_ftz_unit_copy5_a <= phase[2] ? choice_70 : choice_71;
            add_f24_ftz_unit_copy5_b <= phase[2] ? choice_72 : choice_73;
            sqrt_f24_ftz_unit_a <= phase[2] ? choice_74 : phase[1] ? add_22_d1 : add_121_d1;
            min_f24_ftz_unit_a <= phase[2] ? choice_75 : choice_76;
            min_f24_ftz_unit_b <= phase[2] ? choice_77 : phase[1] ? add_64_d1 : phase[0] ? add_64_d1 : abs_180_d2;
            max_f24_ftz_unit_a <= phase[2] ? (phase[1] ? 24'd0 : min_f24_ftz_unit_y) : choice_78;
            max_f24_ftz_unit_b <= phase[2] ? choice_79 : choice_80;
            max_f24_ftz_unit_copy2_a <= 24'd0;
            max_f24_ftz_unit_copy2_b <= phase[2] ? (phase[1] ? add_f24_ftz_unit_copy5_y : select_188_d1) : phase[1] ? select_188_d1 : min_129_d1;
            to_fixed_f24_ftz_u21q8_unit_a <= phase[2] ? choice_81 : max_f24_ftz_unit_y;
            le_f24_ftz_unit_a <= phase[2] ? (phase[1] ? (phase[0] ? add_176_d3 : 24'd0) : 24'd0) : 24'd0;
            le_f24_ftz_unit_b <= phase[2] ? choice_82 : add_f24_ftz_unit_copy3_y;
            to_fixed_f24_ftz_s27q13_unit_a <= add_f24_ftz_unit_y;
            to_fixed_f24_ftz_s17q16_unit_a <= phase[2] ? choice_83 : choice_84;
            to_fixed_f24_ftz_u24q24_unit_a <= phase[2] ? choice_85 : max_f24_ftz_unit_y;
        end
    end
    always @(posedge clk) begin
        if (load_0) delay_5_from_0[delay_5_from_0_pointer] <= select_143[8:0];
        if (load_0) delay_5_from_0_out <= delay_5_from_0[delay_5_from_0_pointer];
    end
    always @(posedge clk) begin
        if (load_0) delay_17_from_0[delay_17_from_0_pointer] <= in_end;
        if (load_0) delay_17_from_0_out <= delay_17_from_0[delay_17_from_0_pointer];
    end
    always @(posedge clk) begin
        if (load_0) begin
            delay_21_from_0[delay_21_from_0_pointer] <= {in_attribute_2, in_attribute_1, in_attribute_0};
        end
        if (load_0) delay_21_from_0_out <= delay_21_from_0[delay_21_from_0_pointer];
    end
    always @(posedge clk) begin
        if (load_1) delay_6_from_1[delay_6_from_1_pointer] <= lt_f24_ftz_unit_y;
        if (load_1) delay_6_from_1_out <= delay_6_from_1[delay_6_from_1_pointer];
    end
    always @(posedge clk) begin
        if (load_1) delay_7_from_1[delay_7_from_1_pointer] <= to_fixed_f24_ftz_u24q24_unit_y;
        if (load_1) delay_7_from_1_out <= delay_7_from_1[delay_7_from_1_pointer];
    end
    always @(posedge clk) begin
        if (load_1) delay_9_from_1[delay_9_from_1_pointer] <= {select_235, select_224};
        if (load_1) delay_9_from_1_out <= delay_9_from_1[delay_9_from_1_pointer];
    end
    always @(posedge clk) begin
        if (load_1) delay_10_from_1[delay_10_from_1_pointer] <= joined_17;
        if (load_1) delay_10_from_1_out <= delay_10_from_1[delay_10_from_1_pointer];
    end
    always @(posedge clk) begin
        if (load_1) begin
            delay_11_from_1[delay_11_from_1_pointer] <= {add_f24_ftz_unit_copy5_y[14:0], add_f24_ftz_unit_copy5_y[23], not_486};
        end
        if (load_1) delay_11_from_1_out <= delay_11_from_1[delay_11_from_1_pointer];
    end
    always @(posedge clk) begin
        if (load_2) delay_12_from_2[delay_12_from_2_pointer] <= or_551;
        if (load_2) delay_12_from_2_out <= delay_12_from_2[delay_12_from_2_pointer];
    end
    always @(posedge clk) begin
        if (load_3) delay_5_from_3[delay_5_from_3_pointer] <= select_85[8:0];
        if (load_3) delay_5_from_3_out <= delay_5_from_3[delay_5_from_3_pointer];
    end
    always @(posedge clk) begin
        if (load_5) begin
            delay_5_from_5[delay_5_from_5_pointer] <= {to_fixed_f24_ftz_u24q24_unit_y, mul_f24_ftz_unit_copy6_y};
        end
        if (load_5) delay_5_from_5_out <= delay_5_from_5[delay_5_from_5_pointer];
    end
    always @(posedge clk) begin
        if (load_5) begin
            delay_12_from_5[delay_12_from_5_pointer] <= {
                mul_108_d1[14:0], mul_108_d1[23], mul_102_d1[14:0], mul_102_d1[23], mul_43_d1[14:0], mul_43_d1[23],
                mul_37_d1[14:0], mul_37_d1[23]
            };
        end
        if (load_5) delay_12_from_5_out <= delay_12_from_5[delay_12_from_5_pointer];
    end
    always @(posedge clk) begin
        if (load_6) begin
            delay_10_from_6[delay_10_from_6_pointer] <= {2'd0, add_f24_ftz_unit_copy2_y[22:15], 2'd0, add_f24_ftz_unit_y[22:15], bits_198_d1};
        end
        if (load_6) delay_10_from_6_out <= delay_10_from_6[delay_10_from_6_pointer];
    end
    always @(posedge clk) begin
        if (load_6) begin
            delay_11_from_6[delay_11_from_6_pointer] <= {
                add_f24_ftz_unit_y[14:0], not_510, add_f24_ftz_unit_copy2_y[14:0], add_f24_ftz_unit_copy2_y[23],
                not_463, resize_355_d1
            };
        end
        if (load_6) delay_11_from_6_out <= delay_11_from_6[delay_11_from_6_pointer];
    end
    always @(posedge clk) begin
        if (load_6) begin
            delay_12_from_6[delay_12_from_6_pointer] <= {
                2'd0, mul_f24_ftz_unit_copy3_y[22:15], 2'd0, mul_f24_ftz_unit_copy2_y[22:15], 2'd0,
                mul_f24_ftz_unit_y[22:15]
            };
        end
        if (load_6) delay_12_from_6_out <= delay_12_from_6[delay_12_from_6_pointer];
    end
    always @(posedge clk) begin
        if (load_6) begin
            delay_13_from_6[delay_13_from_6_pointer] <= {not_440, not_417, not_394, not_370};
        end
        if (load_6) delay_13_from_6_out <= delay_13_from_6[delay_13_from_6_pointer];
    end
    always @(posedge clk) begin
        if (load_7) delay_9_from_7[delay_9_from_7_pointer] <= or_201;
        if (load_7) delay_9_from_7_out <= delay_9_from_7[delay_9_from_7_pointer];
    end

    wire _unused = &{
        1'b0, add_219[0], add_231[0], add_386[0], add_410[0], add_433[0], add_456[0], add_479[0], add_502[0],
        add_525[0], min_222[27:26], min_233[27:26], min_389[17:16], min_412[17:16], min_435[17:16],
        min_458[17:16], min_481[17:16], min_504[17:16], min_528[21:20], or_275[14:0], select_249[26],
        select_253[26], select_268[26], select_273[26], select_373[9:8], select_397[9:8], select_420[9:8],
        select_443[9:8], select_466[9:8], select_489[9:8], select_513[9:8], sub_146[21:9], sub_89[21:9]
    };

`ifdef RTL_ASSERT
    always @(posedge clk) begin
        if (!rst) begin
            if (!(load_0 == (queue_in_ready & (phase == 3'd0)))) begin
`ifdef FORMAL
                load_0_in_phase: assert (0);
`else
                $display("assertion failed: load_0_in_phase in %m");
                $stop;
`endif
            end
            if (!(load_1 == (queue_in_ready & term_1))) begin
`ifdef FORMAL
                load_1_in_phase: assert (0);
`else
                $display("assertion failed: load_1_in_phase in %m");
                $stop;
`endif
            end
            if (!(load_2 == (queue_in_ready & (phase == 3'd2)))) begin
`ifdef FORMAL
                load_2_in_phase: assert (0);
`else
                $display("assertion failed: load_2_in_phase in %m");
                $stop;
`endif
            end
            if (!(load_3 == (queue_in_ready & (phase == 3'd3)))) begin
`ifdef FORMAL
                load_3_in_phase: assert (0);
`else
                $display("assertion failed: load_3_in_phase in %m");
                $stop;
`endif
            end
            if (!(load_4 == (queue_in_ready & (phase == 3'd4)))) begin
`ifdef FORMAL
                load_4_in_phase: assert (0);
`else
                $display("assertion failed: load_4_in_phase in %m");
                $stop;
`endif
            end
            if (!(load_5 == (queue_in_ready & (phase == 3'd5)))) begin
`ifdef FORMAL
                load_5_in_phase: assert (0);
`else
                $display("assertion failed: load_5_in_phase in %m");
                $stop;
`endif
            end
            if (!(load_6 == (queue_in_ready & (phase == 3'd6)))) begin
`ifdef FORMAL
                load_6_in_phase: assert (0);
`else
                $display("assertion failed: load_6_in_phase in %m");
                $stop;
`endif
            end
            if (!(load_7 == (queue_in_ready & term_3))) begin
`ifdef FORMAL
                load_7_in_phase: assert (0);
`else
                $display("assertion failed: load_7_in_phase in %m");
                $stop;
`endif
            end
        end
    end
`endif
endmodule

// Floating to fixed point.
// stages = 3
// format = f24-ftz
// width = 24
// fraction = 24
// integer = unsigned
module float_to_fixed_s3_f24ftz_w24_f24_unsigned (
    input  wire clk,
    input  wire enable,
    input  wire [23:0] a,
    output reg  [23:0] y
);
    reg [4:0] distance_s1;
    reg [15:0] significand_s1;
    reg [23:0] magnitude_s2;
    reg sign_s1, sign_s2, nan_s1, nan_s2, vanishes_s1, vanishes_s2, saturates_s1, saturates_s2;

    wire [7:0] a_field = a[22:15];
    wire [10:0] sum_1 = {3'd0, a_field} + 11'h79a;
    wire [10:0] difference_2 = 11'd24 - sum_1;
    wire [14:0] a_fraction = a[14:0];
    wire term_3 = sum_1[10] | (sum_1 == 11'd0);
    wire term_4 = &a_field & (a_fraction == 15'd0);

    always @(posedge clk) begin
        if (enable) begin
            distance_s1 <= difference_2[4:0];
            significand_s1 <= {|a_field, a_fraction & {15{|a_field}}};
            magnitude_s2 <= ({8'd0, significand_s1} << 8) >> distance_s1;
            sign_s1 <= a[23];
            sign_s2 <= sign_s1;
            nan_s1 <= &a_field & |a_fraction;
            nan_s2 <= nan_s1;
            vanishes_s1 <= (term_3 & ~term_4) | ~(|a_field);
            vanishes_s2 <= vanishes_s1;
            saturates_s1 <= (~term_3 & (11'd25 <= sum_1) & |a_field) | term_4;
            saturates_s2 <= saturates_s1;
            y <= (vanishes_s2 | nan_s2 | sign_s2) ? 24'd0 : saturates_s2 ? 24'hffffff : magnitude_s2;
        end
    end

    wire _unused = &{1'b0, difference_2[10:5]};
endmodule

// Floating to fixed point.
// stages = 3
// format = f24-ftz
// width = 21
// fraction = 20
// integer = signed
module float_to_fixed_s3_f24ftz_w21_f20_signed (
    input  wire clk,
    input  wire enable,
    input  wire [23:0] a,
    output reg  [20:0] y
);
    reg [4:0] distance_s1;
    reg [15:0] significand_s1;
    reg [20:0] magnitude_s2;
    reg sign_s1, sign_s2, nan_s1, nan_s2, vanishes_s1, vanishes_s2, saturates_s1, saturates_s2;

    wire [7:0] a_field = a[22:15];
    wire [10:0] sum_1 = {3'd0, a_field} + 11'h796;
    wire [10:0] difference_2 = 11'd21 - sum_1;
    wire [14:0] a_fraction = a[14:0];
    wire term_3 = sum_1[10] | (sum_1 == 11'd0);
    wire term_4 = &a_field & (a_fraction == 15'd0);
    wire [20:0] choice_5 = saturates_s2 ? (sign_s2 ? 21'h100000 : 21'hfffff) : sign_s2 ? (~magnitude_s2 + 21'd1) : magnitude_s2;

    always @(posedge clk) begin
        if (enable) begin
            distance_s1 <= difference_2[4:0];
            significand_s1 <= {|a_field, a_fraction & {15{|a_field}}};
            magnitude_s2 <= ({5'd0, significand_s1} << 5) >> distance_s1;
            sign_s1 <= a[23];
            sign_s2 <= sign_s1;
            nan_s1 <= &a_field & |a_fraction;
            nan_s2 <= nan_s1;
            vanishes_s1 <= (term_3 & ~term_4) | ~(|a_field);
            vanishes_s2 <= vanishes_s1;
            saturates_s1 <= (~term_3 & (11'd21 <= sum_1) & |a_field) | term_4;
            saturates_s2 <= saturates_s1;
            y <= (vanishes_s2 | nan_s2) ? 21'd0 : choice_5;
        end
    end

    wire _unused = &{1'b0, difference_2[10:5]};
endmodule

// Floating to fixed point.
// stages = 3
// format = f24-ftz
// width = 17
// fraction = 16
// integer = signed
module float_to_fixed_s3_f24ftz_w17_f16_signed (
    input  wire clk,
    input  wire enable,
    input  wire [23:0] a,
    output reg  [16:0] y
);
    reg [4:0] distance_s1;
    reg [15:0] significand_s1;
    reg [16:0] magnitude_s2;
    reg sign_s1, sign_s2, nan_s1, nan_s2, vanishes_s1, vanishes_s2, saturates_s1, saturates_s2;

    wire [7:0] a_field = a[22:15];
    wire [10:0] sum_1 = {3'd0, a_field} + 11'h792;
    wire [10:0] difference_2 = 11'd17 - sum_1;
    wire [14:0] a_fraction = a[14:0];
    wire term_3 = sum_1[10] | (sum_1 == 11'd0);
    wire term_4 = &a_field & (a_fraction == 15'd0);
    wire [16:0] choice_5 = saturates_s2 ? (sign_s2 ? 17'h10000 : 17'hffff) : sign_s2 ? (~magnitude_s2 + 17'd1) : magnitude_s2;

    always @(posedge clk) begin
        if (enable) begin
            distance_s1 <= difference_2[4:0];
            significand_s1 <= {|a_field, a_fraction & {15{|a_field}}};
            magnitude_s2 <= ({1'd0, significand_s1} << 1) >> distance_s1;
            sign_s1 <= a[23];
            sign_s2 <= sign_s1;
            nan_s1 <= &a_field & |a_fraction;
            nan_s2 <= nan_s1;
            vanishes_s1 <= (term_3 & ~term_4) | ~(|a_field);
            vanishes_s2 <= vanishes_s1;
            saturates_s1 <= (~term_3 & (11'd17 <= sum_1) & |a_field) | term_4;
            saturates_s2 <= saturates_s1;
            y <= (vanishes_s2 | nan_s2) ? 17'd0 : choice_5;
        end
    end

    wire _unused = &{1'b0, difference_2[10:5]};
endmodule

// Floating to fixed point.
// stages = 3
// format = f24-ftz
// width = 27
// fraction = 13
// integer = signed
module float_to_fixed_s3_f24ftz_w27_f13_signed (
    input  wire clk,
    input  wire enable,
    input  wire [23:0] a,
    output reg  [26:0] y
);
    reg [4:0] distance_s1;
    reg [15:0] significand_s1;
    reg [26:0] magnitude_s2;
    reg sign_s1, sign_s2, nan_s1, nan_s2, vanishes_s1, vanishes_s2, saturates_s1, saturates_s2;

    wire [7:0] a_field = a[22:15];
    wire [10:0] sum_1 = {3'd0, a_field} + 11'h78f;
    wire [10:0] difference_2 = 11'd27 - sum_1;
    wire [14:0] a_fraction = a[14:0];
    wire term_3 = sum_1[10] | (sum_1 == 11'd0);
    wire term_4 = &a_field & (a_fraction == 15'd0);
    wire [26:0] choice_5 = saturates_s2 ? (sign_s2 ? 27'h4000000 : 27'h3ffffff) : sign_s2 ? (~magnitude_s2 + 27'd1) : magnitude_s2;

    always @(posedge clk) begin
        if (enable) begin
            distance_s1 <= difference_2[4:0];
            significand_s1 <= {|a_field, a_fraction & {15{|a_field}}};
            magnitude_s2 <= ({11'd0, significand_s1} << 11) >> distance_s1;
            sign_s1 <= a[23];
            sign_s2 <= sign_s1;
            nan_s1 <= &a_field & |a_fraction;
            nan_s2 <= nan_s1;
            vanishes_s1 <= (term_3 & ~term_4) | ~(|a_field);
            vanishes_s2 <= vanishes_s1;
            saturates_s1 <= (~term_3 & (11'd27 <= sum_1) & |a_field) | term_4;
            saturates_s2 <= saturates_s1;
            y <= (vanishes_s2 | nan_s2) ? 27'd0 : choice_5;
        end
    end

    wire _unused = &{1'b0, difference_2[10:5]};
endmodule

// Whether one floating-point number is less than another or equal.
// stages = 2
// format = f24-ftz
module float_le_s2_f24ftz (
    input  wire clk,
    input  wire enable,
    input  wire [23:0] a,
    input  wire [23:0] b,
    output reg  y
);
    reg unordered_s1, both_zero_s1, compared_s1;

    wire [14:0] term_1 = a[14:0] & {15{|a[22:15]}};
    wire [14:0] term_2 = b[14:0] & {15{|b[22:15]}};
    wire [22:0] joined_3 = {a[22:15], term_1};
    wire [22:0] joined_4 = {b[22:15], term_2};

    always @(posedge clk) begin
        if (enable) begin
            unordered_s1 <= (&a[22:15] & |term_1) | (&b[22:15] & |term_2);
            both_zero_s1 <= (joined_3 | joined_4) == 23'd0;
            compared_s1 <= {~a[23], joined_3 ^ {23{a[23]}}} <= {~b[23], joined_4 ^ {23{b[23]}}};
            y <= (compared_s1 | both_zero_s1) & ~unordered_s1;
        end
    end
endmodule

// Floating to fixed point.
// stages = 3
// format = f24-ftz
// width = 21
// fraction = 8
// integer = unsigned
module float_to_fixed_s3_f24ftz_w21_f8_unsigned (
    input  wire clk,
    input  wire enable,
    input  wire [23:0] a,
    output reg  [20:0] y
);
    reg [4:0] distance_s1;
    reg [15:0] significand_s1;
    reg [20:0] magnitude_s2;
    reg sign_s1, sign_s2, nan_s1, nan_s2, vanishes_s1, vanishes_s2, saturates_s1, saturates_s2;

    wire [7:0] a_field = a[22:15];
    wire [10:0] sum_1 = {3'd0, a_field} + 11'h78a;
    wire [10:0] difference_2 = 11'd21 - sum_1;
    wire [14:0] a_fraction = a[14:0];
    wire term_3 = sum_1[10] | (sum_1 == 11'd0);
    wire term_4 = &a_field & (a_fraction == 15'd0);

    always @(posedge clk) begin
        if (enable) begin
            distance_s1 <= difference_2[4:0];
            significand_s1 <= {|a_field, a_fraction & {15{|a_field}}};
            magnitude_s2 <= ({5'd0, significand_s1} << 5) >> distance_s1;
            sign_s1 <= a[23];
            sign_s2 <= sign_s1;
            nan_s1 <= &a_field & |a_fraction;
            nan_s2 <= nan_s1;
            vanishes_s1 <= (term_3 & ~term_4) | ~(|a_field);
            vanishes_s2 <= vanishes_s1;
            saturates_s1 <= (~term_3 & (11'd22 <= sum_1) & |a_field) | term_4;
            saturates_s2 <= saturates_s1;
            y <= (vanishes_s2 | nan_s2 | sign_s2) ? 21'd0 : saturates_s2 ? 21'h1fffff : magnitude_s2;
        end
    end

    wire _unused = &{1'b0, difference_2[10:5]};
endmodule

// Greater of two floating-point numbers.
// stages = 2
// format = f24-ftz
module float_max_s2_f24ftz (
    input  wire clk,
    input  wire enable,
    input  wire [23:0] a,
    input  wire [23:0] b,
    output reg  [23:0] y
);
    reg a_nan_s1, b_nan_s1, less_s1;
    reg [23:0] a_s1, b_s1;

    wire [14:0] term_1 = a[14:0] & {15{|a[22:15]}};
    wire [14:0] term_2 = b[14:0] & {15{|b[22:15]}};

    always @(posedge clk) begin
        if (enable) begin
            a_nan_s1 <= &a[22:15] & |term_1;
            b_nan_s1 <= &b[22:15] & |term_2;
            less_s1 <= {~a[23], {a[22:15], term_1} ^ {23{a[23]}}} < {~b[23], {b[22:15], term_2} ^ {23{b[23]}}};
            a_s1 <= {a[23:15], term_1};
            b_s1 <= {b[23:15], term_2};
            y <= (a_nan_s1 & b_nan_s1) ? 24'h7fc000 : (b_nan_s1 | (~a_nan_s1 & ~less_s1)) ? a_s1 : b_s1;
        end
    end
endmodule

// Lesser of two floating-point numbers.
// stages = 2
// format = f24-ftz
module float_min_s2_f24ftz (
    input  wire clk,
    input  wire enable,
    input  wire [23:0] a,
    input  wire [23:0] b,
    output reg  [23:0] y
);
    reg a_nan_s1, b_nan_s1, less_s1;
    reg [23:0] a_s1, b_s1;

    wire [14:0] term_1 = a[14:0] & {15{|a[22:15]}};
    wire [14:0] term_2 = b[14:0] & {15{|b[22:15]}};

    always @(posedge clk) begin
        if (enable) begin
            a_nan_s1 <= &a[22:15] & |term_1;
            b_nan_s1 <= &b[22:15] & |term_2;
            less_s1 <= {~a[23], {a[22:15], term_1} ^ {23{a[23]}}} < {~b[23], {b[22:15], term_2} ^ {23{b[23]}}};
            a_s1 <= {a[23:15], term_1};
            b_s1 <= {b[23:15], term_2};
            y <= (a_nan_s1 & b_nan_s1) ? 24'h7fc000 : (b_nan_s1 | (~a_nan_s1 & less_s1)) ? a_s1 : b_s1;
        end
    end
endmodule

// Floating-point square root, correctly rounded.
// stages = 18
// format = f24-ftz
module float_sqrt_s18_f24ftz (
    input  wire clk,
    input  wire enable,
    input  wire [23:0] a,
    output reg  [23:0] y
);
    reg [2:0] remainder_s1;
    reg [1:0] root_s1;
    reg [12:0] pending_s1;
    reg [3:0] remainder_s2;
    reg [2:0] root_s2;
    reg [10:0] pending_s2;
    reg [4:0] remainder_s3;
    reg [3:0] root_s3;
    reg [8:0] pending_s3;
    reg [5:0] remainder_s4;
    reg [4:0] root_s4;
    reg [6:0] pending_s4, remainder_s5;
    reg [5:0] root_s5;
    reg [4:0] pending_s5;
    reg [7:0] remainder_s6;
    reg [6:0] root_s6;
    reg [2:0] pending_s6;
    reg [8:0] remainder_s7;
    reg [7:0] root_s7;
    reg pending_s7;
    reg [9:0] remainder_s8;
    reg [8:0] root_s8;
    reg [10:0] remainder_s9;
    reg [9:0] root_s9;
    reg [11:0] remainder_s10;
    reg [10:0] root_s10;
    reg [12:0] remainder_s11;
    reg [11:0] root_s11;
    reg [13:0] remainder_s12;
    reg [12:0] root_s12;
    reg [14:0] remainder_s13;
    reg [13:0] root_s13;
    reg [15:0] remainder_s14;
    reg [14:0] root_s14;
    reg [16:0] remainder_s15;
    reg [15:0] root_s15;
    reg [17:0] remainder_s16;
    reg [16:0] root_s16;
    reg [9:0] exponent_s1, exponent_s2, exponent_s3, exponent_s4, exponent_s5, exponent_s6, exponent_s7;
    reg [9:0] exponent_s8, exponent_s9, exponent_s10, exponent_s11, exponent_s12, exponent_s13, exponent_s14;
    reg [9:0] exponent_s15, exponent_s16;
    reg sign_s1, sign_s2, sign_s3, sign_s4, sign_s5, sign_s6, sign_s7, sign_s8, sign_s9, sign_s10, sign_s11;
    reg sign_s12, sign_s13, sign_s14, sign_s15, sign_s16, nan_s1, nan_s2, nan_s3, nan_s4, nan_s5, nan_s6;
    reg nan_s7, nan_s8, nan_s9, nan_s10, nan_s11, nan_s12, nan_s13, nan_s14, nan_s15, nan_s16, infinite_s1;
    reg infinite_s2, infinite_s3, infinite_s4, infinite_s5, infinite_s6, infinite_s7, infinite_s8;
    reg infinite_s9, infinite_s10, infinite_s11, infinite_s12, infinite_s13, infinite_s14, infinite_s15;
    reg infinite_s16, zero_s1, zero_s2, zero_s3, zero_s4, zero_s5, zero_s6, zero_s7, zero_s8, zero_s9;
    reg zero_s10, zero_s11, zero_s12, zero_s13, zero_s14, zero_s15, zero_s16, sign_s17, nan_s17, infinite_s17;
    reg zero_s17;
    reg [22:0] rounded_s17;

    wire [7:0] a_field = a[22:15];
    wire [14:0] a_fraction = a[14:0];
    wire [14:0] term_1 = a_fraction & {15{|a_field}};
    wire [16:0] choice_2 = ~a_field[0] ? {|a_field, term_1, 1'd0} : {1'd0, |a_field, term_1};
    wire [1:0] difference_3 = choice_2[16:15] - 2'd1;
    wire [4:0] difference_4 = {1'd0, difference_3, choice_2[14:13]} - 5'd5;
    wire [5:0] difference_5 = {1'd0, remainder_s1, pending_s1[12:11]} - {2'd0, root_s1, 2'd1};
    wire [6:0] difference_6 = {1'd0, remainder_s2, pending_s2[10:9]} - {2'd0, root_s2, 2'd1};
    wire [7:0] difference_7 = {1'd0, remainder_s3, pending_s3[8:7]} - {2'd0, root_s3, 2'd1};
    wire [8:0] difference_8 = {1'd0, remainder_s4, pending_s4[6:5]} - {2'd0, root_s4, 2'd1};
    wire [9:0] difference_9 = {1'd0, remainder_s5, pending_s5[4:3]} - {2'd0, root_s5, 2'd1};
    wire [10:0] difference_10 = {1'd0, remainder_s6, pending_s6[2:1]} - {2'd0, root_s6, 2'd1};
    wire [11:0] difference_11 = {1'd0, remainder_s7, pending_s7, 1'd0} - {2'd0, root_s7, 2'd1};
    wire [12:0] difference_12 = {1'd0, remainder_s8, 2'd0} - {2'd0, root_s8, 2'd1};
    wire [13:0] difference_13 = {1'd0, remainder_s9, 2'd0} - {2'd0, root_s9, 2'd1};
    wire [14:0] difference_14 = {1'd0, remainder_s10, 2'd0} - {2'd0, root_s10, 2'd1};
    wire [15:0] difference_15 = {1'd0, remainder_s11, 2'd0} - {2'd0, root_s11, 2'd1};
    wire [16:0] difference_16 = {1'd0, remainder_s12, 2'd0} - {2'd0, root_s12, 2'd1};
    wire [17:0] difference_17 = {1'd0, remainder_s13, 2'd0} - {2'd0, root_s13, 2'd1};
    wire [18:0] difference_18 = {1'd0, remainder_s14, 2'd0} - {2'd0, root_s14, 2'd1};
    wire [19:0] difference_19 = {1'd0, remainder_s15, 2'd0} - {2'd0, root_s15, 2'd1};
    wire [9:0] sum_20 = {2'd0, a_field} + 10'd127;
    wire term_21 = (exponent_s16 == 10'd0) & ~(&root_s16[15:1] & root_s16[0]);
    wire round_up = root_s16[0] & (|remainder_s16 | root_s16[1]);
    wire [22:0] rounded = {exponent_s16[7:0], root_s16[15:1]} + {22'd0, round_up};
    wire [22:0] choice_22 = zero_s17 ? 23'd0 : infinite_s17 ? 23'h7f8000 : rounded_s17;

    always @(posedge clk) begin
        if (enable) begin
            remainder_s1 <= ~difference_4[4] ? difference_4[2:0] : {difference_3[0], choice_2[14:13]};
            root_s1 <= {1'd1, ~difference_4[4]};
            pending_s1 <= choice_2[12:0];
            remainder_s2 <= ~difference_5[5] ? difference_5[3:0] : {remainder_s1[1:0], pending_s1[12:11]};
            root_s2 <= {root_s1, ~difference_5[5]};
            pending_s2 <= pending_s1[10:0];
            remainder_s3 <= ~difference_6[6] ? difference_6[4:0] : {remainder_s2[2:0], pending_s2[10:9]};
            root_s3 <= {root_s2, ~difference_6[6]};
            pending_s3 <= pending_s2[8:0];
            remainder_s4 <= ~difference_7[7] ? difference_7[5:0] : {remainder_s3[3:0], pending_s3[8:7]};
            root_s4 <= {root_s3, ~difference_7[7]};
            pending_s4 <= pending_s3[6:0];
            remainder_s5 <= ~difference_8[8] ? difference_8[6:0] : {remainder_s4[4:0], pending_s4[6:5]};
            root_s5 <= {root_s4, ~difference_8[8]};
            pending_s5 <= pending_s4[4:0];
            remainder_s6 <= ~difference_9[9] ? difference_9[7:0] : {remainder_s5[5:0], pending_s5[4:3]};
            root_s6 <= {root_s5, ~difference_9[9]};
            pending_s6 <= pending_s5[2:0];
            remainder_s7 <= ~difference_10[10] ? difference_10[8:0] : {remainder_s6[6:0], pending_s6[2:1]};
            root_s7 <= {root_s6, ~difference_10[10]};
            pending_s7 <= pending_s6[0];
            remainder_s8 <= ~difference_11[11] ? difference_11[9:0] : {remainder_s7[7:0], pending_s7, 1'd0};
            root_s8 <= {root_s7, ~difference_11[11]};
            remainder_s9 <= ~difference_12[12] ? difference_12[10:0] : {remainder_s8[8:0], 2'd0};
            root_s9 <= {root_s8, ~difference_12[12]};
            remainder_s10 <= ~difference_13[13] ? difference_13[11:0] : {remainder_s9[9:0], 2'd0};
            root_s10 <= {root_s9, ~difference_13[13]};
            remainder_s11 <= ~difference_14[14] ? difference_14[12:0] : {remainder_s10[10:0], 2'd0};
            root_s11 <= {root_s10, ~difference_14[14]};
            remainder_s12 <= ~difference_15[15] ? difference_15[13:0] : {remainder_s11[11:0], 2'd0};
            root_s12 <= {root_s11, ~difference_15[15]};
            remainder_s13 <= ~difference_16[16] ? difference_16[14:0] : {remainder_s12[12:0], 2'd0};
            root_s13 <= {root_s12, ~difference_16[16]};
            remainder_s14 <= ~difference_17[17] ? difference_17[15:0] : {remainder_s13[13:0], 2'd0};
            root_s14 <= {root_s13, ~difference_17[17]};
            remainder_s15 <= ~difference_18[18] ? difference_18[16:0] : {remainder_s14[14:0], 2'd0};
            root_s15 <= {root_s14, ~difference_18[18]};
            remainder_s16 <= ~difference_19[19] ? difference_19[17:0] : {remainder_s15[15:0], 2'd0};
            root_s16 <= {root_s15, ~difference_19[19]};
            exponent_s1 <= {sum_20[9], sum_20[9:1]};
            exponent_s2 <= exponent_s1;
            exponent_s3 <= exponent_s2;
            exponent_s4 <= exponent_s3;
            exponent_s5 <= exponent_s4;
            exponent_s6 <= exponent_s5;
            exponent_s7 <= exponent_s6;
            exponent_s8 <= exponent_s7;
            exponent_s9 <= exponent_s8;
            exponent_s10 <= exponent_s9;
            exponent_s11 <= exponent_s10;
            exponent_s12 <= exponent_s11;
            exponent_s13 <= exponent_s12;
            exponent_s14 <= exponent_s13;
            exponent_s15 <= exponent_s14;
            exponent_s16 <= exponent_s15;
            sign_s1 <= a[23];
            sign_s2 <= sign_s1;
            sign_s3 <= sign_s2;
            sign_s4 <= sign_s3;
            sign_s5 <= sign_s4;
            sign_s6 <= sign_s5;
            sign_s7 <= sign_s6;
            sign_s8 <= sign_s7;
            sign_s9 <= sign_s8;
            sign_s10 <= sign_s9;
            sign_s11 <= sign_s10;
            sign_s12 <= sign_s11;
            sign_s13 <= sign_s12;
            sign_s14 <= sign_s13;
            sign_s15 <= sign_s14;
            sign_s16 <= sign_s15;
            nan_s1 <= (&a_field & |a_fraction) | (a[23] & |a_field);
            nan_s2 <= nan_s1;
            nan_s3 <= nan_s2;
            nan_s4 <= nan_s3;
            nan_s5 <= nan_s4;
            nan_s6 <= nan_s5;
            nan_s7 <= nan_s6;
            nan_s8 <= nan_s7;
            nan_s9 <= nan_s8;
            nan_s10 <= nan_s9;
            nan_s11 <= nan_s10;
            nan_s12 <= nan_s11;
            nan_s13 <= nan_s12;
            nan_s14 <= nan_s13;
            nan_s15 <= nan_s14;
            nan_s16 <= nan_s15;
            infinite_s1 <= &a_field & (a_fraction == 15'd0);
            infinite_s2 <= infinite_s1;
            infinite_s3 <= infinite_s2;
            infinite_s4 <= infinite_s3;
            infinite_s5 <= infinite_s4;
            infinite_s6 <= infinite_s5;
            infinite_s7 <= infinite_s6;
            infinite_s8 <= infinite_s7;
            infinite_s9 <= infinite_s8;
            infinite_s10 <= infinite_s9;
            infinite_s11 <= infinite_s10;
            infinite_s12 <= infinite_s11;
            infinite_s13 <= infinite_s12;
            infinite_s14 <= infinite_s13;
            infinite_s15 <= infinite_s14;
            infinite_s16 <= infinite_s15;
            zero_s1 <= ~(|a_field);
            zero_s2 <= zero_s1;
            zero_s3 <= zero_s2;
            zero_s4 <= zero_s3;
            zero_s5 <= zero_s4;
            zero_s6 <= zero_s5;
            zero_s7 <= zero_s6;
            zero_s8 <= zero_s7;
            zero_s9 <= zero_s8;
            zero_s10 <= zero_s9;
            zero_s11 <= zero_s10;
            zero_s12 <= zero_s11;
            zero_s13 <= zero_s12;
            zero_s14 <= zero_s13;
            zero_s15 <= zero_s14;
            zero_s16 <= zero_s15;
            sign_s17 <= sign_s16;
            nan_s17 <= nan_s16;
            infinite_s17 <= infinite_s16 | (~exponent_s16[9] & (10'd255 <= exponent_s16));
            zero_s17 <= zero_s16 | ((exponent_s16[9] | term_21) & ~infinite_s16);
            rounded_s17 <= rounded;
            y <= nan_s17 ? 24'h7fc000 : {sign_s17, choice_22};
        end
    end

    wire _unused = &{
        1'b0, difference_10[9], difference_11[10], difference_12[11], difference_13[12], difference_14[13],
        difference_15[14], difference_16[15], difference_17[16], difference_18[17], difference_19[18],
        difference_4[3], difference_5[4], difference_6[5], difference_7[6], difference_8[7], difference_9[8],
        root_s16[16], sum_20[0]
    };
endmodule

// Floating-point product.
// stages = 5
// format = f24-ftz
module float_mul_s5_f24ftz (
    input  wire clk,
    input  wire enable,
    input  wire [23:0] a,
    input  wire [23:0] b,
    output reg  [23:0] y
);
    reg [15:0] left_s1, right_s1;
    reg [9:0] exponent_s1;
    reg [31:0] product_s2;
    reg [9:0] exponent_s2, exponent_s3;
    reg [17:0] significand_s3;
    reg sign_s1, sign_s2, sign_s3, nan_s1, nan_s2, nan_s3, infinite_s1, infinite_s2, infinite_s3, zero_s1;
    reg zero_s2, zero_s3, sign_s4, nan_s4, infinite_s4, zero_s4;
    reg [22:0] rounded_s4;

    wire [7:0] a_field = a[22:15];
    wire [14:0] a_fraction = a[14:0];
    wire [7:0] b_field = b[22:15];
    wire [14:0] b_fraction = b[14:0];
    wire [31:0] choice_1 = product_s2[31] ? product_s2 : (product_s2 << 1);
    wire term_2 = &a_field & (a_fraction == 15'd0);
    wire term_3 = ~(|b_field);
    wire term_4 = (&a_field & |a_fraction) | (&b_field & |b_fraction) | (term_2 & term_3);
    wire term_5 = ~(|a_field);
    wire term_6 = &b_field & (b_fraction == 15'd0);
    wire term_7 = (exponent_s3 == 10'd0) & ~(&significand_s3[16:2] & significand_s3[1]);
    wire round_up = significand_s3[1] & (significand_s3[0] | significand_s3[2]);
    wire [22:0] rounded = {exponent_s3[7:0], significand_s3[16:2]} + {22'd0, round_up};
    wire [23:0] joined_8 = {sign_s4, zero_s4 ? 23'd0 : infinite_s4 ? 23'h7f8000 : rounded_s4};

    always @(posedge clk) begin
        if (enable) begin
            left_s1 <= {|a_field, a_fraction & {15{|a_field}}};
            right_s1 <= {|b_field, b_fraction & {15{|b_field}}};
            exponent_s1 <= {2'd0, a_field} + {2'd0, b_field};
            product_s2 <= {16'd0, left_s1} * {16'd0, right_s1};
            exponent_s2 <= exponent_s1 - 10'd127;
            exponent_s3 <= exponent_s2 + {9'd0, product_s2[31]};
            significand_s3 <= {choice_1[31:15], |choice_1[14:0]};
            sign_s1 <= a[23] ^ b[23];
            sign_s2 <= sign_s1;
            sign_s3 <= sign_s2;
            nan_s1 <= term_4 | (term_5 & term_6);
            nan_s2 <= nan_s1;
            nan_s3 <= nan_s2;
            infinite_s1 <= term_2 | term_6;
            infinite_s2 <= infinite_s1;
            infinite_s3 <= infinite_s2;
            zero_s1 <= term_5 | term_3;
            zero_s2 <= zero_s1;
            zero_s3 <= zero_s2;
            sign_s4 <= sign_s3;
            nan_s4 <= nan_s3;
            infinite_s4 <= infinite_s3 | (~exponent_s3[9] & (10'd255 <= exponent_s3));
            zero_s4 <= zero_s3 | ((exponent_s3[9] | term_7) & ~infinite_s3);
            rounded_s4 <= rounded;
            y <= nan_s4 ? 24'h7fc000 : joined_8;
        end
    end

    wire _unused = &{1'b0, significand_s3[17]};
endmodule

// Floating-point reciprocal, correctly rounded.
// stages = 20
// format = f24-ftz
module float_recip_s20_f24ftz (
    input  wire clk,
    input  wire enable,
    input  wire [23:0] a,
    output reg  [23:0] y
);
    reg [16:0] remainder_s1;
    reg quotient_s1;
    reg [15:0] divisor_s1;
    reg [16:0] remainder_s2;
    reg [1:0] quotient_s2;
    reg [15:0] divisor_s2;
    reg [16:0] remainder_s3;
    reg [2:0] quotient_s3;
    reg [15:0] divisor_s3;
    reg [16:0] remainder_s4;
    reg [3:0] quotient_s4;
    reg [15:0] divisor_s4;
    reg [16:0] remainder_s5;
    reg [4:0] quotient_s5;
    reg [15:0] divisor_s5;
    reg [16:0] remainder_s6;
    reg [5:0] quotient_s6;
    reg [15:0] divisor_s6;
    reg [16:0] remainder_s7;
    reg [6:0] quotient_s7;
    reg [15:0] divisor_s7;
    reg [16:0] remainder_s8;
    reg [7:0] quotient_s8;
    reg [15:0] divisor_s8;
    reg [16:0] remainder_s9;
    reg [8:0] quotient_s9;
    reg [15:0] divisor_s9;
    reg [16:0] remainder_s10;
    reg [9:0] quotient_s10;
    reg [15:0] divisor_s10;
    reg [16:0] remainder_s11;
    reg [10:0] quotient_s11;
    reg [15:0] divisor_s11;
    reg [16:0] remainder_s12;
    reg [11:0] quotient_s12;
    reg [15:0] divisor_s12;
    reg [16:0] remainder_s13;
    reg [12:0] quotient_s13;
    reg [15:0] divisor_s13;
    reg [16:0] remainder_s14;
    reg [13:0] quotient_s14;
    reg [15:0] divisor_s14;
    reg [16:0] remainder_s15;
    reg [14:0] quotient_s15;
    reg [15:0] divisor_s15;
    reg [16:0] remainder_s16;
    reg [15:0] quotient_s16, divisor_s16;
    reg [16:0] remainder_s17, quotient_s17;
    reg [15:0] divisor_s17;
    reg [16:0] remainder_s18;
    reg [17:0] quotient_s18;
    reg [9:0] exponent_s1, exponent_s2, exponent_s3, exponent_s4, exponent_s5, exponent_s6, exponent_s7;
    reg [9:0] exponent_s8, exponent_s9, exponent_s10, exponent_s11, exponent_s12, exponent_s13, exponent_s14;
    reg [9:0] exponent_s15, exponent_s16, exponent_s17, exponent_s18, exponent_s19;
    reg [17:0] significand_s19;
    reg sign_s1, sign_s2, sign_s3, sign_s4, sign_s5, sign_s6, sign_s7, sign_s8, sign_s9, sign_s10, sign_s11;
    reg sign_s12, sign_s13, sign_s14, sign_s15, sign_s16, sign_s17, sign_s18, sign_s19, nan_s1, nan_s2;
    reg nan_s3, nan_s4, nan_s5, nan_s6, nan_s7, nan_s8, nan_s9, nan_s10, nan_s11, nan_s12, nan_s13, nan_s14;
    reg nan_s15, nan_s16, nan_s17, nan_s18, nan_s19, infinite_s1, infinite_s2, infinite_s3, infinite_s4;
    reg infinite_s5, infinite_s6, infinite_s7, infinite_s8, infinite_s9, infinite_s10, infinite_s11;
    reg infinite_s12, infinite_s13, infinite_s14, infinite_s15, infinite_s16, infinite_s17, infinite_s18;
    reg infinite_s19, zero_s1, zero_s2, zero_s3, zero_s4, zero_s5, zero_s6, zero_s7, zero_s8, zero_s9;
    reg zero_s10, zero_s11, zero_s12, zero_s13, zero_s14, zero_s15, zero_s16, zero_s17, zero_s18, zero_s19;

    wire [7:0] a_field = a[22:15];
    wire [14:0] a_fraction = a[14:0];
    wire [14:0] term_1 = a_fraction & {15{|a_field}};
    wire [17:0] difference_2 = 18'h8000 - {2'd0, |a_field, term_1};
    wire [17:0] difference_3 = {1'd0, remainder_s1} - {2'd0, divisor_s1};
    wire [15:0] choice_4 = ~difference_3[17] ? difference_3[15:0] : remainder_s1[15:0];
    wire [17:0] difference_5 = {1'd0, remainder_s2} - {2'd0, divisor_s2};
    wire [15:0] choice_6 = ~difference_5[17] ? difference_5[15:0] : remainder_s2[15:0];
    wire [17:0] difference_7 = {1'd0, remainder_s3} - {2'd0, divisor_s3};
    wire [15:0] choice_8 = ~difference_7[17] ? difference_7[15:0] : remainder_s3[15:0];
    wire [17:0] difference_9 = {1'd0, remainder_s4} - {2'd0, divisor_s4};
    wire [15:0] choice_10 = ~difference_9[17] ? difference_9[15:0] : remainder_s4[15:0];
    wire [17:0] difference_11 = {1'd0, remainder_s5} - {2'd0, divisor_s5};
    wire [15:0] choice_12 = ~difference_11[17] ? difference_11[15:0] : remainder_s5[15:0];
    wire [17:0] difference_13 = {1'd0, remainder_s6} - {2'd0, divisor_s6};
    wire [15:0] choice_14 = ~difference_13[17] ? difference_13[15:0] : remainder_s6[15:0];
    wire [17:0] difference_15 = {1'd0, remainder_s7} - {2'd0, divisor_s7};
    wire [15:0] choice_16 = ~difference_15[17] ? difference_15[15:0] : remainder_s7[15:0];
    wire [17:0] difference_17 = {1'd0, remainder_s8} - {2'd0, divisor_s8};
    wire [15:0] choice_18 = ~difference_17[17] ? difference_17[15:0] : remainder_s8[15:0];
    wire [17:0] difference_19 = {1'd0, remainder_s9} - {2'd0, divisor_s9};
    wire [15:0] choice_20 = ~difference_19[17] ? difference_19[15:0] : remainder_s9[15:0];
    wire [17:0] difference_21 = {1'd0, remainder_s10} - {2'd0, divisor_s10};
    wire [15:0] choice_22 = ~difference_21[17] ? difference_21[15:0] : remainder_s10[15:0];
    wire [17:0] difference_23 = {1'd0, remainder_s11} - {2'd0, divisor_s11};
    wire [15:0] choice_24 = ~difference_23[17] ? difference_23[15:0] : remainder_s11[15:0];
    wire [17:0] difference_25 = {1'd0, remainder_s12} - {2'd0, divisor_s12};
    wire [15:0] choice_26 = ~difference_25[17] ? difference_25[15:0] : remainder_s12[15:0];
    wire [17:0] difference_27 = {1'd0, remainder_s13} - {2'd0, divisor_s13};
    wire [15:0] choice_28 = ~difference_27[17] ? difference_27[15:0] : remainder_s13[15:0];
    wire [17:0] difference_29 = {1'd0, remainder_s14} - {2'd0, divisor_s14};
    wire [15:0] choice_30 = ~difference_29[17] ? difference_29[15:0] : remainder_s14[15:0];
    wire [17:0] difference_31 = {1'd0, remainder_s15} - {2'd0, divisor_s15};
    wire [15:0] choice_32 = ~difference_31[17] ? difference_31[15:0] : remainder_s15[15:0];
    wire [17:0] difference_33 = {1'd0, remainder_s16} - {2'd0, divisor_s16};
    wire [15:0] choice_34 = ~difference_33[17] ? difference_33[15:0] : remainder_s16[15:0];
    wire [17:0] difference_35 = {1'd0, remainder_s17} - {2'd0, divisor_s17};
    wire [15:0] choice_36 = ~difference_35[17] ? difference_35[15:0] : remainder_s17[15:0];
    wire [18:0] joined_37 = {quotient_s18, |remainder_s18};
    wire [18:0] choice_38 = ~quotient_s18[17] ? (joined_37 << 1) : joined_37;
    wire term_39 = (exponent_s19 == 10'd0) & ~(&significand_s19[16:2] & significand_s19[1]);
    wire term_40 = infinite_s19 | (~exponent_s19[9] & (10'd255 <= exponent_s19));
    wire round_up = significand_s19[1] & (significand_s19[0] | significand_s19[2]);
    wire [22:0] rounded = {exponent_s19[7:0], significand_s19[16:2]} + {22'd0, round_up};
    wire [22:0] choice_41 = (zero_s19 | ((exponent_s19[9] | term_39) & ~infinite_s19)) ? 23'd0 : term_40 ? 23'h7f8000 : rounded;

    always @(posedge clk) begin
        if (enable) begin
            remainder_s1 <= {~difference_2[17] ? difference_2[15:0] : 16'h8000, 1'd0};
            quotient_s1 <= ~difference_2[17];
            divisor_s1 <= {|a_field, term_1};
            remainder_s2 <= {choice_4, 1'd0};
            quotient_s2 <= {quotient_s1, ~difference_3[17]};
            divisor_s2 <= divisor_s1;
            remainder_s3 <= {choice_6, 1'd0};
            quotient_s3 <= {quotient_s2, ~difference_5[17]};
            divisor_s3 <= divisor_s2;
            remainder_s4 <= {choice_8, 1'd0};
            quotient_s4 <= {quotient_s3, ~difference_7[17]};
            divisor_s4 <= divisor_s3;
            remainder_s5 <= {choice_10, 1'd0};
            quotient_s5 <= {quotient_s4, ~difference_9[17]};
            divisor_s5 <= divisor_s4;
            remainder_s6 <= {choice_12, 1'd0};
            quotient_s6 <= {quotient_s5, ~difference_11[17]};
            divisor_s6 <= divisor_s5;
            remainder_s7 <= {choice_14, 1'd0};
            quotient_s7 <= {quotient_s6, ~difference_13[17]};
            divisor_s7 <= divisor_s6;
            remainder_s8 <= {choice_16, 1'd0};
            quotient_s8 <= {quotient_s7, ~difference_15[17]};
            divisor_s8 <= divisor_s7;
            remainder_s9 <= {choice_18, 1'd0};
            quotient_s9 <= {quotient_s8, ~difference_17[17]};
            divisor_s9 <= divisor_s8;
            remainder_s10 <= {choice_20, 1'd0};
            quotient_s10 <= {quotient_s9, ~difference_19[17]};
            divisor_s10 <= divisor_s9;
            remainder_s11 <= {choice_22, 1'd0};
            quotient_s11 <= {quotient_s10, ~difference_21[17]};
            divisor_s11 <= divisor_s10;
            remainder_s12 <= {choice_24, 1'd0};
            quotient_s12 <= {quotient_s11, ~difference_23[17]};
            divisor_s12 <= divisor_s11;
            remainder_s13 <= {choice_26, 1'd0};
            quotient_s13 <= {quotient_s12, ~difference_25[17]};
            divisor_s13 <= divisor_s12;
            remainder_s14 <= {choice_28, 1'd0};
            quotient_s14 <= {quotient_s13, ~difference_27[17]};
            divisor_s14 <= divisor_s13;
            remainder_s15 <= {choice_30, 1'd0};
            quotient_s15 <= {quotient_s14, ~difference_29[17]};
            divisor_s15 <= divisor_s14;
            remainder_s16 <= {choice_32, 1'd0};
            quotient_s16 <= {quotient_s15, ~difference_31[17]};
            divisor_s16 <= divisor_s15;
            remainder_s17 <= {choice_34, 1'd0};
            quotient_s17 <= {quotient_s16, ~difference_33[17]};
            divisor_s17 <= divisor_s16;
            remainder_s18 <= {choice_36, 1'd0};
            quotient_s18 <= {quotient_s17, ~difference_35[17]};
            exponent_s1 <= (10'd127 - {2'd0, a_field}) + 10'd127;
            exponent_s2 <= exponent_s1;
            exponent_s3 <= exponent_s2;
            exponent_s4 <= exponent_s3;
            exponent_s5 <= exponent_s4;
            exponent_s6 <= exponent_s5;
            exponent_s7 <= exponent_s6;
            exponent_s8 <= exponent_s7;
            exponent_s9 <= exponent_s8;
            exponent_s10 <= exponent_s9;
            exponent_s11 <= exponent_s10;
            exponent_s12 <= exponent_s11;
            exponent_s13 <= exponent_s12;
            exponent_s14 <= exponent_s13;
            exponent_s15 <= exponent_s14;
            exponent_s16 <= exponent_s15;
            exponent_s17 <= exponent_s16;
            exponent_s18 <= exponent_s17;
            exponent_s19 <= exponent_s18 - {9'd0, ~quotient_s18[17]};
            significand_s19 <= {choice_38[18:2], |choice_38[1:0]};
            sign_s1 <= a[23];
            sign_s2 <= sign_s1;
            sign_s3 <= sign_s2;
            sign_s4 <= sign_s3;
            sign_s5 <= sign_s4;
            sign_s6 <= sign_s5;
            sign_s7 <= sign_s6;
            sign_s8 <= sign_s7;
            sign_s9 <= sign_s8;
            sign_s10 <= sign_s9;
            sign_s11 <= sign_s10;
            sign_s12 <= sign_s11;
            sign_s13 <= sign_s12;
            sign_s14 <= sign_s13;
            sign_s15 <= sign_s14;
            sign_s16 <= sign_s15;
            sign_s17 <= sign_s16;
            sign_s18 <= sign_s17;
            sign_s19 <= sign_s18;
            nan_s1 <= &a_field & |a_fraction;
            nan_s2 <= nan_s1;
            nan_s3 <= nan_s2;
            nan_s4 <= nan_s3;
            nan_s5 <= nan_s4;
            nan_s6 <= nan_s5;
            nan_s7 <= nan_s6;
            nan_s8 <= nan_s7;
            nan_s9 <= nan_s8;
            nan_s10 <= nan_s9;
            nan_s11 <= nan_s10;
            nan_s12 <= nan_s11;
            nan_s13 <= nan_s12;
            nan_s14 <= nan_s13;
            nan_s15 <= nan_s14;
            nan_s16 <= nan_s15;
            nan_s17 <= nan_s16;
            nan_s18 <= nan_s17;
            nan_s19 <= nan_s18;
            infinite_s1 <= ~(|a_field);
            infinite_s2 <= infinite_s1;
            infinite_s3 <= infinite_s2;
            infinite_s4 <= infinite_s3;
            infinite_s5 <= infinite_s4;
            infinite_s6 <= infinite_s5;
            infinite_s7 <= infinite_s6;
            infinite_s8 <= infinite_s7;
            infinite_s9 <= infinite_s8;
            infinite_s10 <= infinite_s9;
            infinite_s11 <= infinite_s10;
            infinite_s12 <= infinite_s11;
            infinite_s13 <= infinite_s12;
            infinite_s14 <= infinite_s13;
            infinite_s15 <= infinite_s14;
            infinite_s16 <= infinite_s15;
            infinite_s17 <= infinite_s16;
            infinite_s18 <= infinite_s17;
            infinite_s19 <= infinite_s18;
            zero_s1 <= &a_field & (a_fraction == 15'd0);
            zero_s2 <= zero_s1;
            zero_s3 <= zero_s2;
            zero_s4 <= zero_s3;
            zero_s5 <= zero_s4;
            zero_s6 <= zero_s5;
            zero_s7 <= zero_s6;
            zero_s8 <= zero_s7;
            zero_s9 <= zero_s8;
            zero_s10 <= zero_s9;
            zero_s11 <= zero_s10;
            zero_s12 <= zero_s11;
            zero_s13 <= zero_s12;
            zero_s14 <= zero_s13;
            zero_s15 <= zero_s14;
            zero_s16 <= zero_s15;
            zero_s17 <= zero_s16;
            zero_s18 <= zero_s17;
            zero_s19 <= zero_s18;
            y <= nan_s19 ? 24'h7fc000 : {sign_s19, choice_41};
        end
    end

    wire _unused = &{
        1'b0, difference_11[16], difference_13[16], difference_15[16], difference_17[16], difference_19[16],
        difference_2[16], difference_21[16], difference_23[16], difference_25[16], difference_27[16],
        difference_29[16], difference_3[16], difference_31[16], difference_33[16], difference_35[16],
        difference_5[16], difference_7[16], difference_9[16], significand_s19[17]
    };
endmodule

// Queue of two in registers.
// width = 317
module stream_skid_w317 (
    input  wire clk,
    input  wire rst,
    input  wire in_valid,
    output wire in_ready,
    input  wire [316:0] in_data,
    output reg  out_valid,
    input  wire out_ready,
    output wire [316:0] out_data
);
    reg second_valid;
    reg [316:0] head, second;

    assign in_ready = ~second_valid;
    wire advance = ~out_valid | out_ready;
    wire some_item = second_valid | in_valid;

    assign out_data = head;

    always @(posedge clk) begin
        if (rst) begin
            out_valid <= 1'd0;
            second_valid <= 1'd0;
        end else begin
            if (advance) out_valid <= some_item;
            second_valid <= ~advance & some_item;
        end
    end
    always @(posedge clk) begin
        if (advance) head <= second_valid ? second : in_data;
        if (in_ready) second <= in_data;
    end

`ifdef RTL_ASSERT
    always @(posedge clk) begin
        if (!rst) begin
            if (!(out_valid | in_ready)) begin
`ifdef FORMAL
                second_waits_behind_head: assert (0);
`else
                $display("assertion failed: second_waits_behind_head in %m");
                $stop;
`endif
            end
        end
    end
`endif
endmodule

// World space to camera space.
// latency = 28
// initiation_interval = 8
module splat_transform (
    input  wire clk,
    input  wire rst,
    input  wire in_valid,
    output wire in_ready,
    input  wire in_end,
    input  wire [23:0] in_center_x,
    input  wire [23:0] in_center_y,
    input  wire [23:0] in_center_z,
    input  wire [23:0] in_tangent1_x,
    input  wire [23:0] in_tangent1_y,
    input  wire [23:0] in_tangent1_z,
    input  wire [23:0] in_tangent2_x,
    input  wire [23:0] in_tangent2_y,
    input  wire [23:0] in_tangent2_z,
    input  wire [11:0] in_attribute_0,
    input  wire [11:0] in_attribute_1,
    input  wire [11:0] in_attribute_2,
    input  wire [23:0] m00,
    input  wire [23:0] m01,
    input  wire [23:0] m02,
    input  wire [23:0] m03,
    input  wire [23:0] m10,
    input  wire [23:0] m11,
    input  wire [23:0] m12,
    input  wire [23:0] m13,
    input  wire [23:0] m20,
    input  wire [23:0] m21,
    input  wire [23:0] m22,
    input  wire [23:0] m23,
    input  wire [23:0] near_plane,
    output wire out_valid,
    input  wire out_ready,
    output wire out_end,
    output wire [23:0] out_center_x,
    output wire [23:0] out_center_y,
    output wire [23:0] out_center_z,
    output wire [23:0] out_tangent1_x,
    output wire [23:0] out_tangent1_y,
    output wire [23:0] out_tangent1_z,
    output wire [23:0] out_tangent2_x,
    output wire [23:0] out_tangent2_y,
    output wire [23:0] out_tangent2_z,
    output wire [11:0] out_attribute_0,
    output wire [11:0] out_attribute_1,
    output wire [11:0] out_attribute_2
);
    reg [2:0] phase;
    reg load_0, load_1, load_2, load_3, load_5, load_6, load_7, end_d1, end_d2, end_d3, end_d4;
    reg [11:0] attribute_0_d1, attribute_0_d2, attribute_0_d3, attribute_0_d4, attribute_1_d1, attribute_1_d2;
    reg [11:0] attribute_1_d3, attribute_1_d4, attribute_2_d1, attribute_2_d2, attribute_2_d3, attribute_2_d4;
    reg [23:0] reinterpret_26_d1, reinterpret_27_d1, reinterpret_28_d1, mul_37_d1, add_44_d1, add_45_d1, add_46_d1;
    reg [23:0] reinterpret_47_d1, reinterpret_48_d1, reinterpret_49_d1, mul_53_d1, add_54_d1, mul_55_d1, mul_58_d1;
    reg [23:0] add_59_d1, mul_63_d1, add_64_d1, reinterpret_65_d1, reinterpret_66_d1, reinterpret_67_d1, mul_68_d1;
    reg [23:0] mul_71_d1, add_72_d1, add_75_d1, mul_76_d1, add_77_d1, mul_78_d1, add_80_d1, mul_81_d1, add_82_d1;
    reg [23:0] mul_f24_ftz_unit_a, mul_f24_ftz_unit_b, mul_f24_ftz_unit_copy2_a, mul_f24_ftz_unit_copy2_b;
    reg [23:0] mul_f24_ftz_unit_copy3_a, mul_f24_ftz_unit_copy3_b, mul_f24_ftz_unit_copy4_a;
    reg [23:0] mul_f24_ftz_unit_copy4_b, add_f24_ftz_unit_a, add_f24_ftz_unit_b, add_f24_ftz_unit_copy2_a;
    reg [23:0] add_f24_ftz_unit_copy2_b, add_f24_ftz_unit_copy3_a, add_f24_ftz_unit_copy3_b;
    reg [3:0] in_flight;

    wire queue_in_ready, queue_out_valid;
    wire [252:0] queue_out_data;
    wire [23:0] mul_f24_ftz_unit_y, mul_f24_ftz_unit_copy2_y, mul_f24_ftz_unit_copy3_y, mul_f24_ftz_unit_copy4_y;
    wire [23:0] add_f24_ftz_unit_y, add_f24_ftz_unit_copy2_y, add_f24_ftz_unit_copy3_y;
    wire lt_f24_ftz_unit_y;

    wire or_84 = end_d4 | lt_f24_ftz_unit_y;
    wire term_1 = phase == 3'd4;
    wire term_2 = in_flight[3] & or_84 & term_1;
    wire term_3 = phase == 3'd7;
    wire [2:0] phase_next = queue_in_ready ? (term_3 ? (phase - 3'd7) : (phase + 3'd1)) : phase;
    wire term_4 = queue_out_valid & ~out_ready & (~queue_in_ready | term_2);
    wire advance_next = ~term_4;
    wire [23:0] choice_5 = phase[0] ? reinterpret_28_d1 : reinterpret_67_d1;
    wire [23:0] choice_6 = phase[1] ? choice_5 : phase[0] ? reinterpret_49_d1 : reinterpret_65_d1;
    wire [23:0] choice_7 = phase[1] ? (phase[0] ? reinterpret_65_d1 : reinterpret_28_d1) : phase[0] ? reinterpret_26_d1 : in_center_x;
    wire [23:0] choice_8 = phase[0] ? reinterpret_49_d1 : reinterpret_66_d1;
    wire [23:0] choice_9 = phase[0] ? reinterpret_48_d1 : reinterpret_47_d1;
    wire [23:0] choice_10 = phase[1] ? choice_9 : phase[0] ? reinterpret_27_d1 : in_center_y;
    wire [23:0] choice_11 = phase[1] ? (phase[0] ? reinterpret_47_d1 : reinterpret_48_d1) : in_center_x;
    wire [23:0] choice_12 = phase[1] ? reinterpret_66_d1 : phase[0] ? reinterpret_66_d1 : reinterpret_65_d1;
    wire [23:0] choice_13 = phase[0] ? mul_f24_ftz_unit_copy2_y : mul_f24_ftz_unit_y;
    wire [23:0] choice_14 = phase[1] ? choice_13 : phase[0] ? mul_f24_ftz_unit_y : add_f24_ftz_unit_y;
    wire [23:0] choice_15 = phase[1] ? (phase[0] ? m03 : mul_78_d1) : phase[0] ? mul_68_d1 : mul_55_d1;
    wire [23:0] choice_16 = phase[0] ? mul_f24_ftz_unit_copy3_y : mul_f24_ftz_unit_copy2_y;
    wire [23:0] choice_17 = phase[1] ? (phase[0] ? add_f24_ftz_unit_y : mul_f24_ftz_unit_copy4_y) : mul_f24_ftz_unit_copy2_y;
    wire [23:0] choice_18 = phase[1] ? add_f24_ftz_unit_y : phase[0] ? add_f24_ftz_unit_y : add_f24_ftz_unit_copy3_y;
    wire [23:0] choice_19 = phase[1] ? (phase[0] ? m23 : add_80_d1) : phase[0] ? mul_f24_ftz_unit_y : mul_f24_ftz_unit_copy3_y;
    wire [23:0] choice_20 = phase[1] ? (phase[0] ? mul_58_d1 : mul_53_d1) : phase[0] ? mul_37_d1 : mul_f24_ftz_unit_copy2_y;
    wire [23:0] choice_21 = phase[0] ? mul_f24_ftz_unit_copy3_y : mul_f24_ftz_unit_copy4_y;
    wire [23:0] choice_22 = phase[1] ? (phase[0] ? add_f24_ftz_unit_copy2_y : mul_81_d1) : choice_21;
    wire [23:0] choice_23 = phase[0] ? add_f24_ftz_unit_copy2_y : mul_f24_ftz_unit_copy3_y;
    wire [23:0] choice_24 = phase[1] ? choice_23 : phase[0] ? mul_f24_ftz_unit_copy3_y : m13;
    wire [23:0] choice_25 = phase[1] ? add_75_d1 : phase[0] ? add_75_d1 : add_f24_ftz_unit_y;
    wire [23:0] choice_26 = phase[0] ? mul_f24_ftz_unit_copy4_y : add_f24_ftz_unit_copy2_y;
    wire [23:0] choice_27 = phase[1] ? (phase[0] ? mul_63_d1 : mul_f24_ftz_unit_copy4_y) : choice_26;

    assign in_ready = load_0;
    assign out_valid = queue_out_valid;
    assign {
        out_end, out_center_x, out_center_y, out_center_z, out_tangent1_x, out_tangent1_y, out_tangent1_z,
        out_tangent2_x, out_tangent2_y, out_tangent2_z, out_attribute_0, out_attribute_1, out_attribute_2
    } = queue_out_data;

    stream_skid_w253 queue (
        .clk(clk), .rst(rst),
        .in_valid(term_2), .in_ready(queue_in_ready),
        .in_data({
            end_d4, add_44_d1, add_45_d1, add_46_d1, add_54_d1, add_59_d1, add_64_d1, add_72_d1, add_77_d1,
            add_82_d1, attribute_0_d4, attribute_1_d4, attribute_2_d4
        }),
        .out_valid(queue_out_valid), .out_ready(out_ready), .out_data(queue_out_data)
    );

    float_mul_s4_f24ftz mul_f24_ftz_unit (
        .clk(clk), .enable(queue_in_ready), .a(mul_f24_ftz_unit_a), .b(mul_f24_ftz_unit_b),
        .y(mul_f24_ftz_unit_y)
    );

    float_mul_s4_f24ftz mul_f24_ftz_unit_copy2 (
        .clk(clk), .enable(queue_in_ready), .a(mul_f24_ftz_unit_copy2_a), .b(mul_f24_ftz_unit_copy2_b),
        .y(mul_f24_ftz_unit_copy2_y)
    );

    float_mul_s4_f24ftz mul_f24_ftz_unit_copy3 (
        .clk(clk), .enable(queue_in_ready), .a(mul_f24_ftz_unit_copy3_a), .b(mul_f24_ftz_unit_copy3_b),
        .y(mul_f24_ftz_unit_copy3_y)
    );

    float_mul_s4_f24ftz mul_f24_ftz_unit_copy4 (
        .clk(clk), .enable(queue_in_ready), .a(mul_f24_ftz_unit_copy4_a), .b(mul_f24_ftz_unit_copy4_b),
        .y(mul_f24_ftz_unit_copy4_y)
    );

    float_add_s6_f24ftz add_f24_ftz_unit (
        .clk(clk), .enable(queue_in_ready), .a(add_f24_ftz_unit_a), .b(add_f24_ftz_unit_b),
        .y(add_f24_ftz_unit_y)
    );

    float_add_s6_f24ftz add_f24_ftz_unit_copy2 (
        .clk(clk), .enable(queue_in_ready), .a(add_f24_ftz_unit_copy2_a), .b(add_f24_ftz_unit_copy2_b),
        .y(add_f24_ftz_unit_copy2_y)
    );

    float_add_s6_f24ftz add_f24_ftz_unit_copy3 (
        .clk(clk), .enable(queue_in_ready), .a(add_f24_ftz_unit_copy3_a), .b(add_f24_ftz_unit_copy3_b),
        .y(add_f24_ftz_unit_copy3_y)
    );

    float_lt_s2_f24ftz lt_f24_ftz_unit (
        .clk(clk), .enable(queue_in_ready), .a(near_plane), .b(add_f24_ftz_unit_copy2_y),
        .y(lt_f24_ftz_unit_y)
    );

    always @(posedge clk) begin
        if (rst) begin
            phase <= 3'd0;
            load_0 <= 1'd1;
            load_1 <= 1'd0;
            load_2 <= 1'd0;
            load_3 <= 1'd0;
            load_5 <= 1'd0;
            load_6 <= 1'd0;
            load_7 <= 1'd0;
            in_flight <= 4'd0;
        end else begin
            phase <= phase_next;
            load_0 <= advance_next & (phase_next == 3'd0);
            load_1 <= advance_next & (phase_next == 3'd1);
            load_2 <= advance_next & (phase_next == 3'd2);
            load_3 <= advance_next & (phase_next == 3'd3);
            load_5 <= advance_next & (phase_next == 3'd5);
            load_6 <= advance_next & (phase_next == 3'd6);
            load_7 <= advance_next & (phase_next == 3'd7);
            if (load_0) in_flight <= {in_flight[2:0], in_valid};
        end
    end
    always @(posedge clk) begin
        if (load_0) begin
            end_d1 <= in_end;
            end_d2 <= end_d1;
            end_d3 <= end_d2;
            end_d4 <= end_d3;
            attribute_0_d1 <= in_attribute_0;
            attribute_0_d2 <= attribute_0_d1;
            attribute_0_d3 <= attribute_0_d2;
            attribute_0_d4 <= attribute_0_d3;
            attribute_1_d1 <= in_attribute_1;
            attribute_1_d2 <= attribute_1_d1;
            attribute_1_d3 <= attribute_1_d2;
            attribute_1_d4 <= attribute_1_d3;
            attribute_2_d1 <= in_attribute_2;
            attribute_2_d2 <= attribute_2_d1;
            attribute_2_d3 <= attribute_2_d2;
            attribute_2_d4 <= attribute_2_d3;
            reinterpret_26_d1 <= in_center_x;
            reinterpret_27_d1 <= in_center_y;
            reinterpret_28_d1 <= in_center_z;
            reinterpret_47_d1 <= in_tangent1_x;
            reinterpret_48_d1 <= in_tangent1_y;
            reinterpret_49_d1 <= in_tangent1_z;
            reinterpret_65_d1 <= in_tangent2_x;
            reinterpret_66_d1 <= in_tangent2_y;
            reinterpret_67_d1 <= in_tangent2_z;
            mul_68_d1 <= mul_f24_ftz_unit_y;
            add_75_d1 <= add_f24_ftz_unit_copy2_y;
            add_77_d1 <= add_f24_ftz_unit_copy3_y;
        end
        if (load_7) begin
            mul_37_d1 <= mul_f24_ftz_unit_y;
            mul_55_d1 <= mul_f24_ftz_unit_copy4_y;
            add_72_d1 <= add_f24_ftz_unit_copy3_y;
        end
        if (load_2) begin
            add_44_d1 <= add_f24_ftz_unit_y;
            add_46_d1 <= add_f24_ftz_unit_copy2_y;
            mul_53_d1 <= mul_f24_ftz_unit_y;
            mul_58_d1 <= mul_f24_ftz_unit_copy2_y;
            mul_63_d1 <= mul_f24_ftz_unit_copy3_y;
        end
        if (load_3) begin
            add_45_d1 <= add_f24_ftz_unit_copy3_y;
            mul_71_d1 <= mul_f24_ftz_unit_y;
            mul_76_d1 <= mul_f24_ftz_unit_copy2_y;
            mul_81_d1 <= mul_f24_ftz_unit_copy3_y;
        end
        if (load_5) add_54_d1 <= add_f24_ftz_unit_copy2_y;
        if (load_6) begin
            add_59_d1 <= add_f24_ftz_unit_copy2_y;
            add_64_d1 <= add_f24_ftz_unit_copy3_y;
        end
        if (load_1) begin
            mul_78_d1 <= mul_f24_ftz_unit_copy4_y;
            add_80_d1 <= add_f24_ftz_unit_y;
            add_82_d1 <= add_f24_ftz_unit_copy2_y;
        end
        if (queue_in_ready) begin
            mul_f24_ftz_unit_a <= phase[2] ? (phase[1] ? m02 : phase[0] ? m02 : m10) : phase[1] ? (phase[0] ? m00 : m12) : phase[0] ? m10 : m00;
            mul_f24_ftz_unit_b <= phase[2] ? choice_6 : choice_7;
            mul_f24_ftz_unit_copy2_a <= phase[2] ? (phase[1] ? (phase[0] ? m22 : m12) : phase[0] ? m12 : m01) : phase[1] ? (phase[0] ? m11 : m00) : phase[0] ? m11 : m01;
            mul_f24_ftz_unit_copy2_b <= phase[2] ? (phase[1] ? choice_5 : choice_8) : choice_10;
            mul_f24_ftz_unit_copy3_a <= phase[2] ? (phase[1] ? m22 : phase[0] ? m22 : m11) : phase[1] ? (phase[0] ? m20 : m01) : m20;
            mul_f24_ftz_unit_copy3_b <= phase[2] ? (phase[1] ? reinterpret_67_d1 : choice_8) : choice_11;
            mul_f24_ftz_unit_copy4_a <= phase[2] ? (phase[1] ? m21 : phase[0] ? m21 : m20) : phase[1] ? (phase[0] ? m21 : m10) : m21;
            mul_f24_ftz_unit_copy4_b <= phase[2] ? choice_12 : phase[1] ? choice_9 : in_center_y;
            add_f24_ftz_unit_a <= phase[2] ? choice_14 : choice_15;
            add_f24_ftz_unit_b <= phase[2] ? (phase[1] ? choice_16 : choice_13) : choice_17;
            add_f24_ftz_unit_copy2_a <= phase[2] ? choice_18 : choice_19;
            add_f24_ftz_unit_copy2_b <= phase[2] ? choice_20 : choice_22;
            add_f24_ftz_unit_copy3_a <= phase[2] ? choice_24 : choice_25;
            add_f24_ftz_unit_copy3_b <= phase[2] ? choice_27 : phase[1] ? mul_76_d1 : phase[0] ? mul_76_d1 : mul_71_d1;
        end
    end

`ifdef RTL_ASSERT
    reg load_4;

    always @(posedge clk) begin
        if (rst) begin
            load_4 <= 1'd0;
        end else begin
            load_4 <= advance_next & (phase_next == 3'd4);
        end
    end

    always @(posedge clk) begin
        if (!rst) begin
            if (!(load_0 == (queue_in_ready & (phase == 3'd0)))) begin
`ifdef FORMAL
                load_0_in_phase: assert (0);
`else
                $display("assertion failed: load_0_in_phase in %m");
                $stop;
`endif
            end
            if (!(load_1 == (queue_in_ready & (phase == 3'd1)))) begin
`ifdef FORMAL
                load_1_in_phase: assert (0);
`else
                $display("assertion failed: load_1_in_phase in %m");
                $stop;
`endif
            end
            if (!(load_2 == (queue_in_ready & (phase == 3'd2)))) begin
`ifdef FORMAL
                load_2_in_phase: assert (0);
`else
                $display("assertion failed: load_2_in_phase in %m");
                $stop;
`endif
            end
            if (!(load_3 == (queue_in_ready & (phase == 3'd3)))) begin
`ifdef FORMAL
                load_3_in_phase: assert (0);
`else
                $display("assertion failed: load_3_in_phase in %m");
                $stop;
`endif
            end
            if (!(load_4 == (queue_in_ready & term_1))) begin
`ifdef FORMAL
                load_4_in_phase: assert (0);
`else
                $display("assertion failed: load_4_in_phase in %m");
                $stop;
`endif
            end
            if (!(load_5 == (queue_in_ready & (phase == 3'd5)))) begin
`ifdef FORMAL
                load_5_in_phase: assert (0);
`else
                $display("assertion failed: load_5_in_phase in %m");
                $stop;
`endif
            end
            if (!(load_6 == (queue_in_ready & (phase == 3'd6)))) begin
`ifdef FORMAL
                load_6_in_phase: assert (0);
`else
                $display("assertion failed: load_6_in_phase in %m");
                $stop;
`endif
            end
            if (!(load_7 == (queue_in_ready & term_3))) begin
`ifdef FORMAL
                load_7_in_phase: assert (0);
`else
                $display("assertion failed: load_7_in_phase in %m");
                $stop;
`endif
            end
        end
    end
`endif
endmodule

// Whether one floating-point number is less than another.
// stages = 2
// format = f24-ftz
module float_lt_s2_f24ftz (
    input  wire clk,
    input  wire enable,
    input  wire [23:0] a,
    input  wire [23:0] b,
    output reg  y
);
    reg unordered_s1, both_zero_s1, compared_s1;

    wire [14:0] term_1 = a[14:0] & {15{|a[22:15]}};
    wire [14:0] term_2 = b[14:0] & {15{|b[22:15]}};
    wire [22:0] joined_3 = {a[22:15], term_1};
    wire [22:0] joined_4 = {b[22:15], term_2};

    always @(posedge clk) begin
        if (enable) begin
            unordered_s1 <= (&a[22:15] & |term_1) | (&b[22:15] & |term_2);
            both_zero_s1 <= (joined_3 | joined_4) == 23'd0;
            compared_s1 <= {~a[23], joined_3 ^ {23{a[23]}}} < {~b[23], joined_4 ^ {23{b[23]}}};
            y <= compared_s1 & ~both_zero_s1 & ~unordered_s1;
        end
    end
endmodule

// Floating-point sum.
// stages = 6
// format = f24-ftz
module float_add_s6_f24ftz (
    input  wire clk,
    input  wire enable,
    input  wire [23:0] a,
    input  wire [23:0] b,
    output reg  [23:0] y
);
    reg [9:0] distance_s1;
    reg [15:0] large_s1, small_s1, large_s2;
    reg [18:0] aligned_s2;
    reg subtract_s1, subtract_s2;
    reg [19:0] sum_s3;
    reg sign_s1, sign_s2, sign_s3, nan_s1, nan_s2, nan_s3, infinite_s1, infinite_s2, infinite_s3, subtract_s3;
    reg [19:0] value_s4;
    reg [4:0] zeros_s4;
    reg [9:0] limit_s1, limit_s2, limit_s3, limit_s4, exponent_s5;
    reg [17:0] significand_s5;
    reg sign_s4, sign_s5, nan_s4, nan_s5, infinite_s4, infinite_s5, zero_s4, zero_s5;

    wire swap = a[22:0] < b[22:0];
    wire [7:0] b_field = b[22:15];
    wire [7:0] a_field = a[22:15];
    wire [14:0] b_fraction = b[14:0];
    wire [15:0] joined_1 = {|b_field, b_fraction & {15{|b_field}}};
    wire [14:0] a_fraction = a[14:0];
    wire [15:0] joined_2 = {|a_field, a_fraction & {15{|a_field}}};
    wire [18:0] choice_3 = distance_s1[4] ? ({small_s1, 3'd0} >> 16) : {small_s1, 3'd0};
    wire [18:0] choice_4 = distance_s1[3] ? (choice_3 >> 8) : choice_3;
    wire [18:0] choice_5 = distance_s1[2] ? (choice_4 >> 4) : choice_4;
    wire [18:0] choice_6 = distance_s1[1] ? (choice_5 >> 2) : choice_5;
    wire [18:0] choice_7 = distance_s1[0] ? (choice_6 >> 1) : choice_6;
    wire term_8 = (distance_s1[4] & |{small_s1[12:0], 3'd0}) | (distance_s1[3] & |choice_3[7:0]);
    wire term_9 = term_8 | (distance_s1[2] & |choice_4[3:0]) | (distance_s1[1] & |choice_5[1:0]);
    wire [18:0] joined_10 = {choice_7[18:1], choice_7[0] | (term_9 | (distance_s1[0] & choice_6[0]))};
    wire term_11 = a[23] ^ b[23];
    wire [20:0] sum_12 = {1'd0, large_s2, 4'd1} + {{1'd0, aligned_s2} ^ {20{subtract_s2}}, subtract_s2};
    wire term_13 = &a_field & (a_fraction == 15'd0);
    wire term_14 = &b_field & (b_fraction == 15'd0);
    wire term_15 = ~sum_s3[19] & ~sum_s3[18];
    wire term_16 = term_15 & (~sum_s3[17] & ~sum_s3[16]);
    wire term_17 = ~sum_s3[15] & ~sum_s3[14];
    wire term_18 = term_16 & (term_17 & (~sum_s3[13] & ~sum_s3[12]));
    wire term_19 = ~sum_s3[11] & ~sum_s3[10];
    wire term_20 = term_19 & (~sum_s3[9] & ~sum_s3[8]);
    wire term_21 = ~sum_s3[7] & ~sum_s3[6];
    wire term_22 = term_18 & (term_20 & (term_21 & (~sum_s3[5] & ~sum_s3[4])));
    wire term_23 = ~sum_s3[3] & ~sum_s3[2];
    wire term_24 = term_23 & (~sum_s3[1] & ~sum_s3[0]);
    wire [1:0] choice_25 = term_24 ? 2'd0 : {term_23, term_23 ? ~sum_s3[1] : ~sum_s3[3]};
    wire [1:0] choice_26 = term_20 ? {term_21, term_21 ? ~sum_s3[5] : ~sum_s3[7]} : {term_19, term_19 ? ~sum_s3[9] : ~sum_s3[11]};
    wire [1:0] choice_27 = term_16 ? {term_17, term_17 ? ~sum_s3[13] : ~sum_s3[15]} : {term_15, term_15 ? ~sum_s3[17] : ~sum_s3[19]};
    wire [3:0] joined_28 = {term_18, term_18 ? {term_20, choice_26} : {term_16, choice_27}};
    wire [19:0] shifted_29 = value_s4 << zeros_s4;
    wire term_30 = sum_s3 == 20'd0;
    wire term_31 = (exponent_s5 == 10'd0) & ~(&significand_s5[16:2] & significand_s5[1]);
    wire term_32 = infinite_s5 | (~exponent_s5[9] & (10'd255 <= exponent_s5));
    wire round_up = significand_s5[1] & (significand_s5[0] | significand_s5[2]);
    wire [22:0] rounded = {exponent_s5[7:0], significand_s5[16:2]} + {22'd0, round_up};
    wire [22:0] choice_33 = (zero_s5 | ((exponent_s5[9] | term_31) & ~infinite_s5)) ? 23'd0 : term_32 ? 23'h7f8000 : rounded;

    always @(posedge clk) begin
        if (enable) begin
            distance_s1 <= swap ? ({2'd0, b_field} - {2'd0, a_field}) : ({2'd0, a_field} - {2'd0, b_field});
            large_s1 <= swap ? joined_1 : joined_2;
            small_s1 <= swap ? joined_2 : joined_1;
            large_s2 <= large_s1;
            aligned_s2 <= |distance_s1[7:5] ? {18'd0, |{small_s1, 3'd0}} : joined_10;
            subtract_s1 <= term_11;
            subtract_s2 <= subtract_s1;
            sum_s3 <= sum_12[20:1];
            sign_s1 <= swap ? b[23] : a[23];
            sign_s2 <= sign_s1;
            sign_s3 <= sign_s2;
            nan_s1 <= (&a_field & |a_fraction) | (&b_field & |b_fraction) | (term_13 & term_14 & term_11);
            nan_s2 <= nan_s1;
            nan_s3 <= nan_s2;
            infinite_s1 <= term_13 | term_14;
            infinite_s2 <= infinite_s1;
            infinite_s3 <= infinite_s2;
            subtract_s3 <= subtract_s2;
            value_s4 <= sum_s3;
            zeros_s4 <= {term_22, term_22 ? {1'd0, term_24, choice_25} : joined_28};
            limit_s1 <= swap ? {2'd0, b_field} : {2'd0, a_field};
            limit_s2 <= limit_s1;
            limit_s3 <= limit_s2;
            limit_s4 <= limit_s3;
            exponent_s5 <= (limit_s4 + 10'd1) - {5'd0, zeros_s4};
            significand_s5 <= {shifted_29[19:3], |shifted_29[2:0]};
            sign_s4 <= sign_s3 & ~(term_30 & subtract_s3);
            sign_s5 <= sign_s4;
            nan_s4 <= nan_s3;
            nan_s5 <= nan_s4;
            infinite_s4 <= infinite_s3;
            infinite_s5 <= infinite_s4;
            zero_s4 <= term_30 & ~infinite_s3;
            zero_s5 <= zero_s4;
            y <= nan_s5 ? 24'h7fc000 : {sign_s5, choice_33};
        end
    end

    wire _unused = &{1'b0, distance_s1[9:8], significand_s5[17], sum_12[0]};
endmodule

// Floating-point product.
// stages = 4
// format = f24-ftz
module float_mul_s4_f24ftz (
    input  wire clk,
    input  wire enable,
    input  wire [23:0] a,
    input  wire [23:0] b,
    output reg  [23:0] y
);
    reg [15:0] left_s1, right_s1;
    reg [9:0] exponent_s1;
    reg [31:0] product_s2;
    reg [9:0] exponent_s2, exponent_s3;
    reg [17:0] significand_s3;
    reg sign_s1, sign_s2, sign_s3, nan_s1, nan_s2, nan_s3, infinite_s1, infinite_s2, infinite_s3, zero_s1;
    reg zero_s2, zero_s3;

    wire [7:0] a_field = a[22:15];
    wire [14:0] a_fraction = a[14:0];
    wire [7:0] b_field = b[22:15];
    wire [14:0] b_fraction = b[14:0];
    wire [31:0] choice_1 = product_s2[31] ? product_s2 : (product_s2 << 1);
    wire term_2 = &a_field & (a_fraction == 15'd0);
    wire term_3 = ~(|b_field);
    wire term_4 = (&a_field & |a_fraction) | (&b_field & |b_fraction) | (term_2 & term_3);
    wire term_5 = ~(|a_field);
    wire term_6 = &b_field & (b_fraction == 15'd0);
    wire term_7 = (exponent_s3 == 10'd0) & ~(&significand_s3[16:2] & significand_s3[1]);
    wire term_8 = infinite_s3 | (~exponent_s3[9] & (10'd255 <= exponent_s3));
    wire round_up = significand_s3[1] & (significand_s3[0] | significand_s3[2]);
    wire [22:0] rounded = {exponent_s3[7:0], significand_s3[16:2]} + {22'd0, round_up};
    wire [22:0] choice_9 = (zero_s3 | ((exponent_s3[9] | term_7) & ~infinite_s3)) ? 23'd0 : term_8 ? 23'h7f8000 : rounded;

    always @(posedge clk) begin
        if (enable) begin
            left_s1 <= {|a_field, a_fraction & {15{|a_field}}};
            right_s1 <= {|b_field, b_fraction & {15{|b_field}}};
            exponent_s1 <= {2'd0, a_field} + {2'd0, b_field};
            product_s2 <= {16'd0, left_s1} * {16'd0, right_s1};
            exponent_s2 <= exponent_s1 - 10'd127;
            exponent_s3 <= exponent_s2 + {9'd0, product_s2[31]};
            significand_s3 <= {choice_1[31:15], |choice_1[14:0]};
            sign_s1 <= a[23] ^ b[23];
            sign_s2 <= sign_s1;
            sign_s3 <= sign_s2;
            nan_s1 <= term_4 | (term_5 & term_6);
            nan_s2 <= nan_s1;
            nan_s3 <= nan_s2;
            infinite_s1 <= term_2 | term_6;
            infinite_s2 <= infinite_s1;
            infinite_s3 <= infinite_s2;
            zero_s1 <= term_5 | term_3;
            zero_s2 <= zero_s1;
            zero_s3 <= zero_s2;
            y <= nan_s3 ? 24'h7fc000 : {sign_s3, choice_9};
        end
    end

    wire _unused = &{1'b0, significand_s3[17]};
endmodule

// Queue of two in registers.
// width = 253
module stream_skid_w253 (
    input  wire clk,
    input  wire rst,
    input  wire in_valid,
    output wire in_ready,
    input  wire [252:0] in_data,
    output reg  out_valid,
    input  wire out_ready,
    output wire [252:0] out_data
);
    reg second_valid;
    reg [252:0] head, second;

    assign in_ready = ~second_valid;
    wire advance = ~out_valid | out_ready;
    wire some_item = second_valid | in_valid;

    assign out_data = head;

    always @(posedge clk) begin
        if (rst) begin
            out_valid <= 1'd0;
            second_valid <= 1'd0;
        end else begin
            if (advance) out_valid <= some_item;
            second_valid <= ~advance & some_item;
        end
    end
    always @(posedge clk) begin
        if (advance) head <= second_valid ? second : in_data;
        if (in_ready) second <= in_data;
    end

`ifdef RTL_ASSERT
    always @(posedge clk) begin
        if (!rst) begin
            if (!(out_valid | in_ready)) begin
`ifdef FORMAL
                second_waits_behind_head: assert (0);
`else
                $display("assertion failed: second_waits_behind_head in %m");
                $stop;
`endif
            end
        end
    end
`endif
endmodule

// Memory with registered reads, in slices that are memories of the device each.
// A word that is read while it is written is anything: with assertions, the old one inverted.
module memory_1w1r_unordered #(
    parameter WIDTH = 8,
    parameter DEPTH = 2,
    parameter SLICE = WIDTH
) (
    input  wire clk,
    input  wire write,
    input  wire [$clog2(DEPTH)-1:0] write_address,
    input  wire [WIDTH-1:0] write_data,
    input  wire read,
    input  wire [$clog2(DEPTH)-1:0] read_address,
    output wire [WIDTH-1:0] read_data
);
    genvar low;
    generate
        for (low = 0; low < WIDTH; low = low + SLICE) begin : slice
            localparam BITS = low + SLICE <= WIDTH ? SLICE : WIDTH - low;
            (* no_rw_check *)
            reg [BITS-1:0] words [0:DEPTH-1];
            reg [BITS-1:0] read_word;
            assign read_data[low +: BITS] = read_word;
            always @(posedge clk) begin
                if (write) words[write_address] <= write_data[low +: BITS];
                if (read) read_word <= words[read_address];
`ifdef RTL_ASSERT
                if (read && write && read_address == write_address) read_word <= ~words[read_address];
`endif
            end
        end
    endgenerate
endmodule
