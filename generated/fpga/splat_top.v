// The whole design is one file, named after its top.
/* verilator lint_off DECLFILENAME */

// Surface-splat renderer: splats in, normalized fragments out.
module splat_top (
    input  wire clk, input wire rst,
    input  wire uniform_valid,  // Write to a uniform register: after `frame_set_up` of the last frame and before the first splat of the next, `filter_scale` while no frame is under way.
    input  wire [4:0] uniform_address,  // Its place among the frame's uniforms.
    input  wire [31:0] uniform_data,  // Its new value.
    input  wire splat_valid, output wire splat_ready,  // Splats in world space.
    input  wire splat_end,  // Closes the frame.
    input  wire [31:0] splat_center_x,  // Center.
    input  wire [31:0] splat_center_y,  // Center.
    input  wire [31:0] splat_center_z,  // Center.
    input  wire [31:0] splat_tangent1_x,  // Tangents, whose ends lie at rho = 1.
    input  wire [31:0] splat_tangent1_y,  // Tangents, whose ends lie at rho = 1.
    input  wire [31:0] splat_tangent1_z,  // Tangents, whose ends lie at rho = 1.
    input  wire [31:0] splat_tangent2_x,  // Tangents, whose ends lie at rho = 1.
    input  wire [31:0] splat_tangent2_y,  // Tangents, whose ends lie at rho = 1.
    input  wire [31:0] splat_tangent2_z,  // Tangents, whose ends lie at rho = 1.
    input  wire [15:0] splat_attribute_0,  // Attributes.
    input  wire [15:0] splat_attribute_1,  // Attributes.
    input  wire [15:0] splat_attribute_2,  // Attributes.
    input  wire [15:0] splat_attribute_3,  // Attributes.
    input  wire [15:0] splat_attribute_4,  // Attributes.
    input  wire [15:0] splat_attribute_5,  // Attributes.
    input  wire [15:0] splat_attribute_6,  // Attributes.
    input  wire [15:0] splat_attribute_7,  // Attributes.
    input  wire [15:0] splat_attribute_8,  // Attributes.
    input  wire [15:0] splat_attribute_9,  // Attributes.
    input  wire [15:0] splat_attribute_10,  // Attributes.
    input  wire [15:0] splat_attribute_11,  // Attributes.
    input  wire [15:0] splat_attribute_12,  // Attributes.
    input  wire [15:0] splat_cardinal_0,  // Attributes.
    output reg  frame_set_up,  // All splats of a frame were set up in the last cycle.
    output wire read_valid, input wire read_ready,  // Request for pixels of a tile.
    output wire read_surface,  // The frame is one of those with odd numbers.
    output wire [11:0] read_tile,  // Tile index.
    output wire [5:0] read_pixel,  // The first pixel of the tile.
    output wire [3:0] read_count,  // How many there are, at least one.
    input  wire data_valid, output wire data_ready,  // The pixels requested, in order.
    input  wire [27:0] data_weight,  // Sum of weights.
    input  wire [51:0] data_depth,  // Sum of weighted depths.
    input  wire [15:0] data_peak,  // The largest single weight, with cardinal attributes only.
    input  wire [15:0] data_attribute_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] data_attribute_1,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] data_attribute_2,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] data_attribute_3,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] data_attribute_4,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] data_attribute_5,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] data_attribute_6,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] data_attribute_7,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] data_attribute_8,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] data_attribute_9,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] data_attribute_10,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] data_attribute_11,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] data_attribute_12,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] data_cardinal_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire write_valid, input wire write_ready,  // Pixels of evicted tiles.
    output wire write_surface,  // The frame is one of those with odd numbers: two have a place in the buffer.
    output wire [11:0] write_tile,  // Tile index.
    output wire [5:0] write_pixel,  // Pixel of the tile.
    output wire [27:0] write_weight,  // Sum of weights.
    output wire [51:0] write_depth,  // Sum of weighted depths.
    output wire [15:0] write_peak,  // The largest single weight, with cardinal attributes only.
    output wire [15:0] write_attribute_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] write_attribute_1,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] write_attribute_2,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] write_attribute_3,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] write_attribute_4,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] write_attribute_5,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] write_attribute_6,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] write_attribute_7,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] write_attribute_8,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] write_attribute_9,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] write_attribute_10,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] write_attribute_11,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] write_attribute_12,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] write_cardinal_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire fragment_valid, input wire fragment_ready,  // Fragments of the image, each of one stream; a frame ends when all streams have ended it.
    output wire fragment_end,  // Closes the frame.
    output wire [8:0] fragment_column,  // Column of the image.
    output wire [8:0] fragment_row,  // Row of the image.
    output wire [31:0] fragment_depth,  // Depth in the geometry format.
    output wire [15:0] fragment_attribute_0,  // Attributes.
    output wire [15:0] fragment_attribute_1,  // Attributes.
    output wire [15:0] fragment_attribute_2,  // Attributes.
    output wire [15:0] fragment_attribute_3,  // Attributes.
    output wire [15:0] fragment_attribute_4,  // Attributes.
    output wire [15:0] fragment_attribute_5,  // Attributes.
    output wire [15:0] fragment_attribute_6,  // Attributes.
    output wire [15:0] fragment_attribute_7,  // Attributes.
    output wire [15:0] fragment_attribute_8,  // Attributes.
    output wire [15:0] fragment_attribute_9,  // Attributes.
    output wire [15:0] fragment_attribute_10,  // Attributes.
    output wire [15:0] fragment_attribute_11,  // Attributes.
    output wire [15:0] fragment_attribute_12,  // Attributes.
    output wire [15:0] fragment_cardinal_0,  // Attributes.
    output wire event_sample,  // Rasterizers that evaluated a sample.
    output wire event_starved,  // Rasterizers that had no copy to work on.
    output wire event_blocked,  // Rasterizers whose pipeline was held by what follows it.
    output wire event_accumulate,  // Accumulators that took a sample.
    output wire event_hazard,  // Accumulators that waited for an earlier sample of the same pixel.
    output wire event_slot_wait  // Accumulators that waited for a tile to arrive in the cache.
);
    reg [31:0] uniform_m00, uniform_m01, uniform_m02, uniform_m03, uniform_m10, uniform_m11, uniform_m12;
    reg [31:0] uniform_m13, uniform_m20, uniform_m21, uniform_m22, uniform_m23, uniform_scale_x, uniform_scale_y;
    reg [31:0] uniform_origin_x, uniform_origin_y, uniform_depth_a, uniform_depth_b, uniform_near_plane;
    reg [31:0] uniform_epsilon_scale, uniform_epsilon_bias, uniform_filter_radius, uniform_filter_scale;

    wire transform_out_valid, transform_out_end;
    wire [31:0] transform_out_center_x, transform_out_center_y, transform_out_center_z, transform_out_tangent1_x;
    wire [31:0] transform_out_tangent1_y, transform_out_tangent1_z, transform_out_tangent2_x;
    wire [31:0] transform_out_tangent2_y, transform_out_tangent2_z;
    wire [15:0] transform_out_attribute_0, transform_out_attribute_1, transform_out_attribute_2;
    wire [15:0] transform_out_attribute_3, transform_out_attribute_4, transform_out_attribute_5;
    wire [15:0] transform_out_attribute_6, transform_out_attribute_7, transform_out_attribute_8;
    wire [15:0] transform_out_attribute_9, transform_out_attribute_10, transform_out_attribute_11;
    wire [15:0] transform_out_attribute_12, transform_out_cardinal_0;
    wire setup_in_ready, setup_out_valid, setup_out_end;
    wire [31:0] setup_out_center_x, setup_out_center_y, setup_out_ax, setup_out_bx, setup_out_ay, setup_out_by;
    wire [31:0] setup_out_delta, setup_out_mx, setup_out_my;
    wire setup_out_sight_negative;
    wire [30:0] setup_out_sight_near, setup_out_sight_far;
    wire setup_out_sight_turned, setup_out_sight_disc;
    wire [23:0] setup_out_depth, setup_out_depth_low, setup_out_depth_high;
    wire [15:0] setup_out_attribute_0, setup_out_attribute_1, setup_out_attribute_2, setup_out_attribute_3;
    wire [15:0] setup_out_attribute_4, setup_out_attribute_5, setup_out_attribute_6, setup_out_attribute_7;
    wire [15:0] setup_out_attribute_8, setup_out_attribute_9, setup_out_attribute_10, setup_out_attribute_11;
    wire [15:0] setup_out_attribute_12, setup_out_cardinal_0;
    wire [8:0] setup_out_left, setup_out_right, setup_out_top, setup_out_bottom;
    wire [9:0] setup_out_first_sum, setup_out_last_sum, setup_out_first_difference, setup_out_last_difference;
    wire splitter_in_ready, splitter_out_valid, splitter_out_end, splitter_out_first;
    wire [31:0] splitter_out_center_x, splitter_out_center_y, splitter_out_ax, splitter_out_bx, splitter_out_ay;
    wire [31:0] splitter_out_by, splitter_out_delta, splitter_out_mx, splitter_out_my;
    wire splitter_out_sight_negative;
    wire [30:0] splitter_out_sight_near, splitter_out_sight_far;
    wire splitter_out_sight_turned, splitter_out_sight_disc;
    wire [23:0] splitter_out_depth, splitter_out_depth_low, splitter_out_depth_high;
    wire [15:0] splitter_out_attribute_0, splitter_out_attribute_1, splitter_out_attribute_2;
    wire [15:0] splitter_out_attribute_3, splitter_out_attribute_4, splitter_out_attribute_5;
    wire [15:0] splitter_out_attribute_6, splitter_out_attribute_7, splitter_out_attribute_8;
    wire [15:0] splitter_out_attribute_9, splitter_out_attribute_10, splitter_out_attribute_11;
    wire [15:0] splitter_out_attribute_12, splitter_out_cardinal_0;
    wire [2:0] splitter_out_left, splitter_out_right, splitter_out_top, splitter_out_bottom;
    wire [3:0] splitter_out_first_sum, splitter_out_last_sum, splitter_out_first_difference;
    wire [3:0] splitter_out_last_difference;
    wire [11:0] splitter_out_tile;
    wire lane_0_in_ready, lane_0_pixel_valid, lane_0_pixel_end;
    wire [11:0] lane_0_pixel_tile;
    wire [5:0] lane_0_pixel_pixel;
    wire [27:0] lane_0_pixel_weight;
    wire [51:0] lane_0_pixel_depth;
    wire [15:0] lane_0_pixel_peak, lane_0_pixel_attribute_0, lane_0_pixel_attribute_1, lane_0_pixel_attribute_2;
    wire [15:0] lane_0_pixel_attribute_3, lane_0_pixel_attribute_4, lane_0_pixel_attribute_5;
    wire [15:0] lane_0_pixel_attribute_6, lane_0_pixel_attribute_7, lane_0_pixel_attribute_8;
    wire [15:0] lane_0_pixel_attribute_9, lane_0_pixel_attribute_10, lane_0_pixel_attribute_11;
    wire [15:0] lane_0_pixel_attribute_12, lane_0_pixel_cardinal_0;
    wire normalizer_in_ready;

    splat_transform transform (
        .clk(clk), .rst(rst), .in_valid(splat_valid), .in_ready(splat_ready), .in_end(splat_end),
        .in_center_x(splat_center_x), .in_center_y(splat_center_y), .in_center_z(splat_center_z),
        .in_tangent1_x(splat_tangent1_x), .in_tangent1_y(splat_tangent1_y), .in_tangent1_z(splat_tangent1_z),
        .in_tangent2_x(splat_tangent2_x), .in_tangent2_y(splat_tangent2_y), .in_tangent2_z(splat_tangent2_z),
        .in_attribute_0(splat_attribute_0), .in_attribute_1(splat_attribute_1),
        .in_attribute_2(splat_attribute_2), .in_attribute_3(splat_attribute_3),
        .in_attribute_4(splat_attribute_4), .in_attribute_5(splat_attribute_5),
        .in_attribute_6(splat_attribute_6), .in_attribute_7(splat_attribute_7),
        .in_attribute_8(splat_attribute_8), .in_attribute_9(splat_attribute_9),
        .in_attribute_10(splat_attribute_10), .in_attribute_11(splat_attribute_11),
        .in_attribute_12(splat_attribute_12), .in_cardinal_0(splat_cardinal_0),
        .m00(uniform_m00), .m01(uniform_m01), .m02(uniform_m02), .m03(uniform_m03), .m10(uniform_m10),
        .m11(uniform_m11), .m12(uniform_m12), .m13(uniform_m13), .m20(uniform_m20), .m21(uniform_m21),
        .m22(uniform_m22), .m23(uniform_m23), .near_plane(uniform_near_plane),
        .out_valid(transform_out_valid), .out_ready(setup_in_ready), .out_end(transform_out_end),
        .out_center_x(transform_out_center_x), .out_center_y(transform_out_center_y),
        .out_center_z(transform_out_center_z), .out_tangent1_x(transform_out_tangent1_x),
        .out_tangent1_y(transform_out_tangent1_y), .out_tangent1_z(transform_out_tangent1_z),
        .out_tangent2_x(transform_out_tangent2_x), .out_tangent2_y(transform_out_tangent2_y),
        .out_tangent2_z(transform_out_tangent2_z), .out_attribute_0(transform_out_attribute_0),
        .out_attribute_1(transform_out_attribute_1), .out_attribute_2(transform_out_attribute_2),
        .out_attribute_3(transform_out_attribute_3), .out_attribute_4(transform_out_attribute_4),
        .out_attribute_5(transform_out_attribute_5), .out_attribute_6(transform_out_attribute_6),
        .out_attribute_7(transform_out_attribute_7), .out_attribute_8(transform_out_attribute_8),
        .out_attribute_9(transform_out_attribute_9), .out_attribute_10(transform_out_attribute_10),
        .out_attribute_11(transform_out_attribute_11), .out_attribute_12(transform_out_attribute_12),
        .out_cardinal_0(transform_out_cardinal_0)
    );

    splat_setup setup (
        .clk(clk), .rst(rst), .in_valid(transform_out_valid), .in_ready(setup_in_ready),
        .in_end(transform_out_end), .in_center_x(transform_out_center_x),
        .in_center_y(transform_out_center_y), .in_center_z(transform_out_center_z),
        .in_tangent1_x(transform_out_tangent1_x), .in_tangent1_y(transform_out_tangent1_y),
        .in_tangent1_z(transform_out_tangent1_z), .in_tangent2_x(transform_out_tangent2_x),
        .in_tangent2_y(transform_out_tangent2_y), .in_tangent2_z(transform_out_tangent2_z),
        .in_attribute_0(transform_out_attribute_0), .in_attribute_1(transform_out_attribute_1),
        .in_attribute_2(transform_out_attribute_2), .in_attribute_3(transform_out_attribute_3),
        .in_attribute_4(transform_out_attribute_4), .in_attribute_5(transform_out_attribute_5),
        .in_attribute_6(transform_out_attribute_6), .in_attribute_7(transform_out_attribute_7),
        .in_attribute_8(transform_out_attribute_8), .in_attribute_9(transform_out_attribute_9),
        .in_attribute_10(transform_out_attribute_10), .in_attribute_11(transform_out_attribute_11),
        .in_attribute_12(transform_out_attribute_12), .in_cardinal_0(transform_out_cardinal_0),
        .near_plane(uniform_near_plane),
        .filter_radius(uniform_filter_radius),
        .depth_a(uniform_depth_a), .depth_b(uniform_depth_b),
        .epsilon_scale(uniform_epsilon_scale), .epsilon_bias(uniform_epsilon_bias),
        .scale_x(uniform_scale_x),
        .origin_x(uniform_origin_x),
        .scale_y(uniform_scale_y),
        .origin_y(uniform_origin_y),
        .out_valid(setup_out_valid), .out_ready(splitter_in_ready), .out_end(setup_out_end),
        .out_center_x(setup_out_center_x), .out_center_y(setup_out_center_y), .out_ax(setup_out_ax),
        .out_bx(setup_out_bx), .out_ay(setup_out_ay), .out_by(setup_out_by), .out_delta(setup_out_delta),
        .out_mx(setup_out_mx), .out_my(setup_out_my), .out_sight_negative(setup_out_sight_negative),
        .out_sight_near(setup_out_sight_near), .out_sight_far(setup_out_sight_far),
        .out_sight_turned(setup_out_sight_turned), .out_sight_disc(setup_out_sight_disc),
        .out_depth(setup_out_depth), .out_depth_low(setup_out_depth_low),
        .out_depth_high(setup_out_depth_high), .out_attribute_0(setup_out_attribute_0),
        .out_attribute_1(setup_out_attribute_1), .out_attribute_2(setup_out_attribute_2),
        .out_attribute_3(setup_out_attribute_3), .out_attribute_4(setup_out_attribute_4),
        .out_attribute_5(setup_out_attribute_5), .out_attribute_6(setup_out_attribute_6),
        .out_attribute_7(setup_out_attribute_7), .out_attribute_8(setup_out_attribute_8),
        .out_attribute_9(setup_out_attribute_9), .out_attribute_10(setup_out_attribute_10),
        .out_attribute_11(setup_out_attribute_11), .out_attribute_12(setup_out_attribute_12),
        .out_cardinal_0(setup_out_cardinal_0), .out_left(setup_out_left), .out_right(setup_out_right),
        .out_top(setup_out_top), .out_bottom(setup_out_bottom), .out_first_sum(setup_out_first_sum),
        .out_last_sum(setup_out_last_sum), .out_first_difference(setup_out_first_difference),
        .out_last_difference(setup_out_last_difference)
    );

    splat_splitter splitter (
        .clk(clk), .rst(rst), .in_valid(setup_out_valid), .in_ready(splitter_in_ready),
        .in_end(setup_out_end), .in_center_x(setup_out_center_x), .in_center_y(setup_out_center_y),
        .in_ax(setup_out_ax), .in_bx(setup_out_bx), .in_ay(setup_out_ay), .in_by(setup_out_by),
        .in_delta(setup_out_delta), .in_mx(setup_out_mx), .in_my(setup_out_my),
        .in_sight_negative(setup_out_sight_negative), .in_sight_near(setup_out_sight_near),
        .in_sight_far(setup_out_sight_far), .in_sight_turned(setup_out_sight_turned),
        .in_sight_disc(setup_out_sight_disc), .in_depth(setup_out_depth), .in_depth_low(setup_out_depth_low),
        .in_depth_high(setup_out_depth_high), .in_attribute_0(setup_out_attribute_0),
        .in_attribute_1(setup_out_attribute_1), .in_attribute_2(setup_out_attribute_2),
        .in_attribute_3(setup_out_attribute_3), .in_attribute_4(setup_out_attribute_4),
        .in_attribute_5(setup_out_attribute_5), .in_attribute_6(setup_out_attribute_6),
        .in_attribute_7(setup_out_attribute_7), .in_attribute_8(setup_out_attribute_8),
        .in_attribute_9(setup_out_attribute_9), .in_attribute_10(setup_out_attribute_10),
        .in_attribute_11(setup_out_attribute_11), .in_attribute_12(setup_out_attribute_12),
        .in_cardinal_0(setup_out_cardinal_0), .in_left(setup_out_left), .in_right(setup_out_right),
        .in_top(setup_out_top), .in_bottom(setup_out_bottom), .in_first_sum(setup_out_first_sum),
        .in_last_sum(setup_out_last_sum), .in_first_difference(setup_out_first_difference),
        .in_last_difference(setup_out_last_difference),
        .out_valid(splitter_out_valid), .out_ready(lane_0_in_ready), .out_end(splitter_out_end),
        .out_first(splitter_out_first), .out_center_x(splitter_out_center_x),
        .out_center_y(splitter_out_center_y), .out_ax(splitter_out_ax), .out_bx(splitter_out_bx),
        .out_ay(splitter_out_ay), .out_by(splitter_out_by), .out_delta(splitter_out_delta),
        .out_mx(splitter_out_mx), .out_my(splitter_out_my), .out_sight_negative(splitter_out_sight_negative),
        .out_sight_near(splitter_out_sight_near), .out_sight_far(splitter_out_sight_far),
        .out_sight_turned(splitter_out_sight_turned), .out_sight_disc(splitter_out_sight_disc),
        .out_depth(splitter_out_depth), .out_depth_low(splitter_out_depth_low),
        .out_depth_high(splitter_out_depth_high), .out_attribute_0(splitter_out_attribute_0),
        .out_attribute_1(splitter_out_attribute_1), .out_attribute_2(splitter_out_attribute_2),
        .out_attribute_3(splitter_out_attribute_3), .out_attribute_4(splitter_out_attribute_4),
        .out_attribute_5(splitter_out_attribute_5), .out_attribute_6(splitter_out_attribute_6),
        .out_attribute_7(splitter_out_attribute_7), .out_attribute_8(splitter_out_attribute_8),
        .out_attribute_9(splitter_out_attribute_9), .out_attribute_10(splitter_out_attribute_10),
        .out_attribute_11(splitter_out_attribute_11), .out_attribute_12(splitter_out_attribute_12),
        .out_cardinal_0(splitter_out_cardinal_0), .out_left(splitter_out_left),
        .out_right(splitter_out_right), .out_top(splitter_out_top), .out_bottom(splitter_out_bottom),
        .out_first_sum(splitter_out_first_sum), .out_last_sum(splitter_out_last_sum),
        .out_first_difference(splitter_out_first_difference),
        .out_last_difference(splitter_out_last_difference), .out_tile(splitter_out_tile)
    );

    splat_lane lane_0 (
        .clk(clk), .rst(rst), .in_valid(splitter_out_valid), .in_ready(lane_0_in_ready),
        .in_end(splitter_out_end), .in_first(splitter_out_first), .in_center_x(splitter_out_center_x),
        .in_center_y(splitter_out_center_y), .in_ax(splitter_out_ax), .in_bx(splitter_out_bx),
        .in_ay(splitter_out_ay), .in_by(splitter_out_by), .in_delta(splitter_out_delta),
        .in_mx(splitter_out_mx), .in_my(splitter_out_my), .in_sight_negative(splitter_out_sight_negative),
        .in_sight_near(splitter_out_sight_near), .in_sight_far(splitter_out_sight_far),
        .in_sight_turned(splitter_out_sight_turned), .in_sight_disc(splitter_out_sight_disc),
        .in_depth(splitter_out_depth), .in_depth_low(splitter_out_depth_low),
        .in_depth_high(splitter_out_depth_high), .in_attribute_0(splitter_out_attribute_0),
        .in_attribute_1(splitter_out_attribute_1), .in_attribute_2(splitter_out_attribute_2),
        .in_attribute_3(splitter_out_attribute_3), .in_attribute_4(splitter_out_attribute_4),
        .in_attribute_5(splitter_out_attribute_5), .in_attribute_6(splitter_out_attribute_6),
        .in_attribute_7(splitter_out_attribute_7), .in_attribute_8(splitter_out_attribute_8),
        .in_attribute_9(splitter_out_attribute_9), .in_attribute_10(splitter_out_attribute_10),
        .in_attribute_11(splitter_out_attribute_11), .in_attribute_12(splitter_out_attribute_12),
        .in_cardinal_0(splitter_out_cardinal_0), .in_left(splitter_out_left), .in_right(splitter_out_right),
        .in_top(splitter_out_top), .in_bottom(splitter_out_bottom), .in_first_sum(splitter_out_first_sum),
        .in_last_sum(splitter_out_last_sum), .in_first_difference(splitter_out_first_difference),
        .in_last_difference(splitter_out_last_difference), .in_tile(splitter_out_tile),
        .read_valid(read_valid), .read_ready(read_ready), .read_surface(read_surface), .read_tile(read_tile),
        .read_pixel(read_pixel), .read_count(read_count),
        .data_valid(data_valid), .data_ready(data_ready), .data_weight(data_weight), .data_depth(data_depth),
        .data_peak(data_peak), .data_attribute_0(data_attribute_0), .data_attribute_1(data_attribute_1),
        .data_attribute_2(data_attribute_2), .data_attribute_3(data_attribute_3),
        .data_attribute_4(data_attribute_4), .data_attribute_5(data_attribute_5),
        .data_attribute_6(data_attribute_6), .data_attribute_7(data_attribute_7),
        .data_attribute_8(data_attribute_8), .data_attribute_9(data_attribute_9),
        .data_attribute_10(data_attribute_10), .data_attribute_11(data_attribute_11),
        .data_attribute_12(data_attribute_12), .data_cardinal_0(data_cardinal_0),
        .write_valid(write_valid), .write_ready(write_ready), .write_surface(write_surface),
        .write_tile(write_tile), .write_pixel(write_pixel), .write_weight(write_weight),
        .write_depth(write_depth), .write_peak(write_peak), .write_attribute_0(write_attribute_0),
        .write_attribute_1(write_attribute_1), .write_attribute_2(write_attribute_2),
        .write_attribute_3(write_attribute_3), .write_attribute_4(write_attribute_4),
        .write_attribute_5(write_attribute_5), .write_attribute_6(write_attribute_6),
        .write_attribute_7(write_attribute_7), .write_attribute_8(write_attribute_8),
        .write_attribute_9(write_attribute_9), .write_attribute_10(write_attribute_10),
        .write_attribute_11(write_attribute_11), .write_attribute_12(write_attribute_12),
        .write_cardinal_0(write_cardinal_0),
        .pixel_valid(lane_0_pixel_valid), .pixel_ready(normalizer_in_ready), .pixel_end(lane_0_pixel_end),
        .pixel_tile(lane_0_pixel_tile), .pixel_pixel(lane_0_pixel_pixel), .pixel_weight(lane_0_pixel_weight),
        .pixel_depth(lane_0_pixel_depth), .pixel_peak(lane_0_pixel_peak),
        .pixel_attribute_0(lane_0_pixel_attribute_0), .pixel_attribute_1(lane_0_pixel_attribute_1),
        .pixel_attribute_2(lane_0_pixel_attribute_2), .pixel_attribute_3(lane_0_pixel_attribute_3),
        .pixel_attribute_4(lane_0_pixel_attribute_4), .pixel_attribute_5(lane_0_pixel_attribute_5),
        .pixel_attribute_6(lane_0_pixel_attribute_6), .pixel_attribute_7(lane_0_pixel_attribute_7),
        .pixel_attribute_8(lane_0_pixel_attribute_8), .pixel_attribute_9(lane_0_pixel_attribute_9),
        .pixel_attribute_10(lane_0_pixel_attribute_10), .pixel_attribute_11(lane_0_pixel_attribute_11),
        .pixel_attribute_12(lane_0_pixel_attribute_12), .pixel_cardinal_0(lane_0_pixel_cardinal_0),
        .filter_scale(uniform_filter_scale),
        .event_sample(event_sample), .event_starved(event_starved), .event_blocked(event_blocked),
        .event_accumulate(event_accumulate), .event_hazard(event_hazard), .event_slot_wait(event_slot_wait)
    );

    splat_normalizer normalizer (
        .clk(clk), .rst(rst), .in_valid(lane_0_pixel_valid), .in_ready(normalizer_in_ready),
        .in_end(lane_0_pixel_end), .in_tile(lane_0_pixel_tile), .in_pixel(lane_0_pixel_pixel),
        .in_weight(lane_0_pixel_weight), .in_depth(lane_0_pixel_depth), .in_peak(lane_0_pixel_peak),
        .in_attribute_0(lane_0_pixel_attribute_0), .in_attribute_1(lane_0_pixel_attribute_1),
        .in_attribute_2(lane_0_pixel_attribute_2), .in_attribute_3(lane_0_pixel_attribute_3),
        .in_attribute_4(lane_0_pixel_attribute_4), .in_attribute_5(lane_0_pixel_attribute_5),
        .in_attribute_6(lane_0_pixel_attribute_6), .in_attribute_7(lane_0_pixel_attribute_7),
        .in_attribute_8(lane_0_pixel_attribute_8), .in_attribute_9(lane_0_pixel_attribute_9),
        .in_attribute_10(lane_0_pixel_attribute_10), .in_attribute_11(lane_0_pixel_attribute_11),
        .in_attribute_12(lane_0_pixel_attribute_12), .in_cardinal_0(lane_0_pixel_cardinal_0),
        .out_valid(fragment_valid), .out_ready(fragment_ready), .out_end(fragment_end),
        .out_column(fragment_column), .out_row(fragment_row), .out_depth(fragment_depth),
        .out_attribute_0(fragment_attribute_0), .out_attribute_1(fragment_attribute_1),
        .out_attribute_2(fragment_attribute_2), .out_attribute_3(fragment_attribute_3),
        .out_attribute_4(fragment_attribute_4), .out_attribute_5(fragment_attribute_5),
        .out_attribute_6(fragment_attribute_6), .out_attribute_7(fragment_attribute_7),
        .out_attribute_8(fragment_attribute_8), .out_attribute_9(fragment_attribute_9),
        .out_attribute_10(fragment_attribute_10), .out_attribute_11(fragment_attribute_11),
        .out_attribute_12(fragment_attribute_12), .out_cardinal_0(fragment_cardinal_0)
    );

    always @(posedge clk) begin
        if (rst) frame_set_up <= 1'd0;
        else frame_set_up <= setup_out_valid & splitter_in_ready & setup_out_end;
    end
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
        if (uniform_valid & (uniform_address == 5'd22)) uniform_filter_scale <= uniform_data;
    end
endmodule

// A finished pixel's sums divided by its weight.
// latency = 40
// initiation_interval = 1
module splat_normalizer (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready,  // Pixels of a finished frame.
    input  wire in_end,  // Closes the frame.
    input  wire [11:0] in_tile,  // Tile index.
    input  wire [5:0] in_pixel,  // Pixel of the tile.
    input  wire [27:0] in_weight,  // Sum of weights.
    input  wire [51:0] in_depth,  // Sum of weighted depths.
    input  wire [15:0] in_peak,  // The largest single weight, with cardinal attributes only.
    input  wire [15:0] in_attribute_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] in_attribute_1,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] in_attribute_2,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] in_attribute_3,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] in_attribute_4,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] in_attribute_5,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] in_attribute_6,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] in_attribute_7,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] in_attribute_8,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] in_attribute_9,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] in_attribute_10,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] in_attribute_11,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] in_attribute_12,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] in_cardinal_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire out_valid, input wire out_ready,  // Fragments.
    output wire out_end,  // Closes the frame.
    output wire [8:0] out_column,  // Column of the image.
    output wire [8:0] out_row,  // Row of the image.
    output wire [31:0] out_depth,  // Depth in the geometry format.
    output wire [15:0] out_attribute_0,  // Attributes.
    output wire [15:0] out_attribute_1,  // Attributes.
    output wire [15:0] out_attribute_2,  // Attributes.
    output wire [15:0] out_attribute_3,  // Attributes.
    output wire [15:0] out_attribute_4,  // Attributes.
    output wire [15:0] out_attribute_5,  // Attributes.
    output wire [15:0] out_attribute_6,  // Attributes.
    output wire [15:0] out_attribute_7,  // Attributes.
    output wire [15:0] out_attribute_8,  // Attributes.
    output wire [15:0] out_attribute_9,  // Attributes.
    output wire [15:0] out_attribute_10,  // Attributes.
    output wire [15:0] out_attribute_11,  // Attributes.
    output wire [15:0] out_attribute_12,  // Attributes.
    output wire [15:0] out_cardinal_0  // Attributes.
);
    (* ram_style = "distributed" *)
    reg [31:0] delay_28_from_0 [0:26];
    (* ram_style = "distributed" *)
    reg [95:0] delay_29_from_0 [0:27];
    (* ram_style = "distributed" *)
    reg [95:0] delay_29_from_0_copy2 [0:27];
    (* ram_style = "distributed" *)
    reg [15:0] delay_29_from_0_copy3 [0:27];
    (* ram_style = "distributed" *)
    reg [34:0] delay_40_from_0 [0:38];
    reg [6:0] credits;
    reg [4:0] delay_28_from_0_pointer;
    reg [31:0] delay_28_from_0_out;
    reg [4:0] delay_29_from_0_pointer;
    reg [95:0] delay_29_from_0_out;
    reg [4:0] delay_29_from_0_copy2_pointer;
    reg [95:0] delay_29_from_0_copy2_out;
    reg [4:0] delay_29_from_0_copy3_pointer;
    reg [15:0] delay_29_from_0_copy3_out;
    reg [5:0] delay_40_from_0_pointer;
    reg [34:0] delay_40_from_0_out;
    reg [31:0] depth_out_d1, depth_out_d2, depth_out_d3;
    reg [39:0] in_flight;
    reg left;

    wire [31:0] to_float_u28q16_f32_ftz_unit_y, recip_f32_ftz_unit_y, to_float_u52q40_f32_ftz_unit_y;
    wire [31:0] mul_f32_ftz_unit_y, mul_f32_ftz_unit_copy2_y, mul_f32_ftz_unit_copy3_y, mul_f32_ftz_unit_copy4_y;
    wire [31:0] mul_f32_ftz_unit_copy5_y, mul_f32_ftz_unit_copy6_y, mul_f32_ftz_unit_copy7_y;
    wire [31:0] mul_f32_ftz_unit_copy8_y, mul_f32_ftz_unit_copy9_y, mul_f32_ftz_unit_copy10_y;
    wire [31:0] mul_f32_ftz_unit_copy11_y, mul_f32_ftz_unit_copy12_y, mul_f32_ftz_unit_copy13_y;
    wire [31:0] mul_f32_ftz_unit_copy14_y, convert_f16_f32_ftz_unit_y, convert_f16_f32_ftz_unit_copy2_y;
    wire [31:0] convert_f16_f32_ftz_unit_copy3_y, convert_f16_f32_ftz_unit_copy4_y, convert_f16_f32_ftz_unit_copy5_y;
    wire [31:0] convert_f16_f32_ftz_unit_copy6_y, convert_f16_f32_ftz_unit_copy7_y, convert_f16_f32_ftz_unit_copy8_y;
    wire [31:0] convert_f16_f32_ftz_unit_copy9_y, convert_f16_f32_ftz_unit_copy10_y;
    wire [31:0] convert_f16_f32_ftz_unit_copy11_y, convert_f16_f32_ftz_unit_copy12_y;
    wire [31:0] convert_f16_f32_ftz_unit_copy13_y;
    wire [15:0] convert_f32_ftz_f16_unit_y, convert_f32_ftz_f16_unit_copy2_y, convert_f32_ftz_f16_unit_copy3_y;
    wire [15:0] convert_f32_ftz_f16_unit_copy4_y, convert_f32_ftz_f16_unit_copy5_y, convert_f32_ftz_f16_unit_copy6_y;
    wire [15:0] convert_f32_ftz_f16_unit_copy7_y, convert_f32_ftz_f16_unit_copy8_y, convert_f32_ftz_f16_unit_copy9_y;
    wire [15:0] convert_f32_ftz_f16_unit_copy10_y, convert_f32_ftz_f16_unit_copy11_y;
    wire [15:0] convert_f32_ftz_f16_unit_copy12_y, convert_f32_ftz_f16_unit_copy13_y;
    wire queue_1_in_ready;
    wire [114:0] queue_1_out_data;
    wire queue_2_in_ready, queue_2_out_valid;
    wire [127:0] queue_2_out_data;
    wire queue_3_in_ready, queue_3_out_valid;
    wire [31:0] queue_3_out_data;

    assign in_ready = ~credits[6];
    wire [15:0] attribute_0_d29 = delay_29_from_0_out[15:0];
    wire [15:0] attribute_1_d29 = delay_29_from_0_out[31:16];
    wire [15:0] attribute_2_d29 = delay_29_from_0_out[47:32];
    wire [15:0] attribute_3_d29 = delay_29_from_0_out[63:48];
    wire [15:0] attribute_4_d29 = delay_29_from_0_out[79:64];
    wire [15:0] attribute_5_d29 = delay_29_from_0_out[95:80];
    wire [15:0] attribute_6_d29 = delay_29_from_0_copy2_out[15:0];
    wire [15:0] attribute_7_d29 = delay_29_from_0_copy2_out[31:16];
    wire [15:0] attribute_8_d29 = delay_29_from_0_copy2_out[47:32];
    wire [15:0] attribute_9_d29 = delay_29_from_0_copy2_out[63:48];
    wire [15:0] attribute_10_d29 = delay_29_from_0_copy2_out[79:64];
    wire [15:0] attribute_11_d29 = delay_29_from_0_copy2_out[95:80];
    wire kept = in_flight[39];
    wire end_d40 = delay_40_from_0_out[0];
    wire [8:0] column_out_d40 = delay_40_from_0_out[25:17];
    wire [8:0] row_out_d40 = delay_40_from_0_out[34:26];
    wire [15:0] cardinal_0_d40 = delay_40_from_0_out[16:1];
    wire in_valid_and_in_ready = in_valid & in_ready;

    assign {
        out_end, out_column, out_row, out_depth, out_attribute_0, out_attribute_1, out_attribute_2,
        out_attribute_3
    } = queue_1_out_data;
    assign {
        out_attribute_4, out_attribute_5, out_attribute_6, out_attribute_7, out_attribute_8, out_attribute_9,
        out_attribute_10, out_attribute_11
    } = queue_2_out_data;
    assign {out_attribute_12, out_cardinal_0} = queue_3_out_data;

    float_from_fixed_s4_f32ftz_w28_f16_unsigned to_float_u28q16_f32_ftz_unit (
        .clk(clk), .enable(1'd1), .a(in_weight), .y(to_float_u28q16_f32_ftz_unit_y)
    );

    float_recip_s28_f32ftz recip_f32_ftz_unit (
        .clk(clk), .enable(1'd1), .a(to_float_u28q16_f32_ftz_unit_y), .y(recip_f32_ftz_unit_y)
    );

    float_from_fixed_s4_f32ftz_w52_f40_unsigned to_float_u52q40_f32_ftz_unit (
        .clk(clk), .enable(1'd1), .a(in_depth), .y(to_float_u52q40_f32_ftz_unit_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit (
        .clk(clk), .enable(1'd1), .a(recip_f32_ftz_unit_y), .b(delay_28_from_0_out), .y(mul_f32_ftz_unit_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(recip_f32_ftz_unit_y), .b(convert_f16_f32_ftz_unit_y),
        .y(mul_f32_ftz_unit_copy2_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy3 (
        .clk(clk), .enable(1'd1), .a(recip_f32_ftz_unit_y), .b(convert_f16_f32_ftz_unit_copy2_y),
        .y(mul_f32_ftz_unit_copy3_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy4 (
        .clk(clk), .enable(1'd1), .a(recip_f32_ftz_unit_y), .b(convert_f16_f32_ftz_unit_copy3_y),
        .y(mul_f32_ftz_unit_copy4_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy5 (
        .clk(clk), .enable(1'd1), .a(recip_f32_ftz_unit_y), .b(convert_f16_f32_ftz_unit_copy4_y),
        .y(mul_f32_ftz_unit_copy5_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy6 (
        .clk(clk), .enable(1'd1), .a(recip_f32_ftz_unit_y), .b(convert_f16_f32_ftz_unit_copy5_y),
        .y(mul_f32_ftz_unit_copy6_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy7 (
        .clk(clk), .enable(1'd1), .a(recip_f32_ftz_unit_y), .b(convert_f16_f32_ftz_unit_copy6_y),
        .y(mul_f32_ftz_unit_copy7_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy8 (
        .clk(clk), .enable(1'd1), .a(recip_f32_ftz_unit_y), .b(convert_f16_f32_ftz_unit_copy7_y),
        .y(mul_f32_ftz_unit_copy8_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy9 (
        .clk(clk), .enable(1'd1), .a(recip_f32_ftz_unit_y), .b(convert_f16_f32_ftz_unit_copy8_y),
        .y(mul_f32_ftz_unit_copy9_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy10 (
        .clk(clk), .enable(1'd1), .a(recip_f32_ftz_unit_y), .b(convert_f16_f32_ftz_unit_copy9_y),
        .y(mul_f32_ftz_unit_copy10_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy11 (
        .clk(clk), .enable(1'd1), .a(recip_f32_ftz_unit_y), .b(convert_f16_f32_ftz_unit_copy10_y),
        .y(mul_f32_ftz_unit_copy11_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy12 (
        .clk(clk), .enable(1'd1), .a(recip_f32_ftz_unit_y), .b(convert_f16_f32_ftz_unit_copy11_y),
        .y(mul_f32_ftz_unit_copy12_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy13 (
        .clk(clk), .enable(1'd1), .a(recip_f32_ftz_unit_y), .b(convert_f16_f32_ftz_unit_copy12_y),
        .y(mul_f32_ftz_unit_copy13_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy14 (
        .clk(clk), .enable(1'd1), .a(recip_f32_ftz_unit_y), .b(convert_f16_f32_ftz_unit_copy13_y),
        .y(mul_f32_ftz_unit_copy14_y)
    );

    float_convert_s3_f16_f32ftz convert_f16_f32_ftz_unit (
        .clk(clk), .enable(1'd1), .a(attribute_0_d29), .y(convert_f16_f32_ftz_unit_y)
    );

    float_convert_s3_f16_f32ftz convert_f16_f32_ftz_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(attribute_1_d29), .y(convert_f16_f32_ftz_unit_copy2_y)
    );

    float_convert_s3_f16_f32ftz convert_f16_f32_ftz_unit_copy3 (
        .clk(clk), .enable(1'd1), .a(attribute_2_d29), .y(convert_f16_f32_ftz_unit_copy3_y)
    );

    float_convert_s3_f16_f32ftz convert_f16_f32_ftz_unit_copy4 (
        .clk(clk), .enable(1'd1), .a(attribute_3_d29), .y(convert_f16_f32_ftz_unit_copy4_y)
    );

    float_convert_s3_f16_f32ftz convert_f16_f32_ftz_unit_copy5 (
        .clk(clk), .enable(1'd1), .a(attribute_4_d29), .y(convert_f16_f32_ftz_unit_copy5_y)
    );

    float_convert_s3_f16_f32ftz convert_f16_f32_ftz_unit_copy6 (
        .clk(clk), .enable(1'd1), .a(attribute_5_d29), .y(convert_f16_f32_ftz_unit_copy6_y)
    );

    float_convert_s3_f16_f32ftz convert_f16_f32_ftz_unit_copy7 (
        .clk(clk), .enable(1'd1), .a(attribute_6_d29), .y(convert_f16_f32_ftz_unit_copy7_y)
    );

    float_convert_s3_f16_f32ftz convert_f16_f32_ftz_unit_copy8 (
        .clk(clk), .enable(1'd1), .a(attribute_7_d29), .y(convert_f16_f32_ftz_unit_copy8_y)
    );

    float_convert_s3_f16_f32ftz convert_f16_f32_ftz_unit_copy9 (
        .clk(clk), .enable(1'd1), .a(attribute_8_d29), .y(convert_f16_f32_ftz_unit_copy9_y)
    );

    float_convert_s3_f16_f32ftz convert_f16_f32_ftz_unit_copy10 (
        .clk(clk), .enable(1'd1), .a(attribute_9_d29), .y(convert_f16_f32_ftz_unit_copy10_y)
    );

    float_convert_s3_f16_f32ftz convert_f16_f32_ftz_unit_copy11 (
        .clk(clk), .enable(1'd1), .a(attribute_10_d29), .y(convert_f16_f32_ftz_unit_copy11_y)
    );

    float_convert_s3_f16_f32ftz convert_f16_f32_ftz_unit_copy12 (
        .clk(clk), .enable(1'd1), .a(attribute_11_d29), .y(convert_f16_f32_ftz_unit_copy12_y)
    );

    float_convert_s3_f16_f32ftz convert_f16_f32_ftz_unit_copy13 (
        .clk(clk), .enable(1'd1), .a(delay_29_from_0_copy3_out), .y(convert_f16_f32_ftz_unit_copy13_y)
    );

    float_convert_s3_f32ftz_f16 convert_f32_ftz_f16_unit (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_copy2_y), .y(convert_f32_ftz_f16_unit_y)
    );

    float_convert_s3_f32ftz_f16 convert_f32_ftz_f16_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_copy3_y), .y(convert_f32_ftz_f16_unit_copy2_y)
    );

    float_convert_s3_f32ftz_f16 convert_f32_ftz_f16_unit_copy3 (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_copy4_y), .y(convert_f32_ftz_f16_unit_copy3_y)
    );

    float_convert_s3_f32ftz_f16 convert_f32_ftz_f16_unit_copy4 (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_copy5_y), .y(convert_f32_ftz_f16_unit_copy4_y)
    );

    float_convert_s3_f32ftz_f16 convert_f32_ftz_f16_unit_copy5 (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_copy6_y), .y(convert_f32_ftz_f16_unit_copy5_y)
    );

    float_convert_s3_f32ftz_f16 convert_f32_ftz_f16_unit_copy6 (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_copy7_y), .y(convert_f32_ftz_f16_unit_copy6_y)
    );

    float_convert_s3_f32ftz_f16 convert_f32_ftz_f16_unit_copy7 (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_copy8_y), .y(convert_f32_ftz_f16_unit_copy7_y)
    );

    float_convert_s3_f32ftz_f16 convert_f32_ftz_f16_unit_copy8 (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_copy9_y), .y(convert_f32_ftz_f16_unit_copy8_y)
    );

    float_convert_s3_f32ftz_f16 convert_f32_ftz_f16_unit_copy9 (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_copy10_y), .y(convert_f32_ftz_f16_unit_copy9_y)
    );

    float_convert_s3_f32ftz_f16 convert_f32_ftz_f16_unit_copy10 (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_copy11_y), .y(convert_f32_ftz_f16_unit_copy10_y)
    );

    float_convert_s3_f32ftz_f16 convert_f32_ftz_f16_unit_copy11 (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_copy12_y), .y(convert_f32_ftz_f16_unit_copy11_y)
    );

    float_convert_s3_f32ftz_f16 convert_f32_ftz_f16_unit_copy12 (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_copy13_y), .y(convert_f32_ftz_f16_unit_copy12_y)
    );

    float_convert_s3_f32ftz_f16 convert_f32_ftz_f16_unit_copy13 (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_copy14_y), .y(convert_f32_ftz_f16_unit_copy13_y)
    );

    stream_fifo_d44_w115_distributed queue_1 (
        .clk(clk), .rst(rst), .in_valid(kept), .in_ready(queue_1_in_ready),
        .in_data({
            end_d40, column_out_d40, row_out_d40, depth_out_d3, convert_f32_ftz_f16_unit_y,
            convert_f32_ftz_f16_unit_copy2_y, convert_f32_ftz_f16_unit_copy3_y, convert_f32_ftz_f16_unit_copy4_y
        }),
        .out_valid(out_valid), .out_ready(out_ready), .out_data(queue_1_out_data)
    );

    stream_fifo_d44_w128_distributed queue_2 (
        .clk(clk), .rst(rst), .in_valid(kept), .in_ready(queue_2_in_ready),
        .in_data({
            convert_f32_ftz_f16_unit_copy5_y, convert_f32_ftz_f16_unit_copy6_y, convert_f32_ftz_f16_unit_copy7_y,
            convert_f32_ftz_f16_unit_copy8_y, convert_f32_ftz_f16_unit_copy9_y, convert_f32_ftz_f16_unit_copy10_y,
            convert_f32_ftz_f16_unit_copy11_y, convert_f32_ftz_f16_unit_copy12_y
        }),
        .out_valid(queue_2_out_valid), .out_ready(out_ready), .out_data(queue_2_out_data)
    );

    stream_fifo_d44_w32_distributed queue_3 (
        .clk(clk), .rst(rst), .in_valid(kept), .in_ready(queue_3_in_ready),
        .in_data({convert_f32_ftz_f16_unit_copy13_y, cardinal_0_d40}),
        .out_valid(queue_3_out_valid), .out_ready(out_ready), .out_data(queue_3_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            credits <= 7'd43;
            delay_28_from_0_pointer <= 5'd0;
            delay_29_from_0_pointer <= 5'd0;
            delay_29_from_0_copy2_pointer <= 5'd0;
            delay_29_from_0_copy3_pointer <= 5'd0;
            delay_40_from_0_pointer <= 6'd0;
            in_flight <= 40'd0;
            left <= 1'd0;
        end else begin
            credits <= (credits - {6'd0, in_valid_and_in_ready}) + {6'd0, left};
            delay_28_from_0_pointer <= (delay_28_from_0_pointer == 5'd26) ? (delay_28_from_0_pointer - 5'd26) : (delay_28_from_0_pointer + 5'd1);
            delay_29_from_0_pointer <= (delay_29_from_0_pointer == 5'd27) ? (delay_29_from_0_pointer - 5'd27) : (delay_29_from_0_pointer + 5'd1);
            delay_29_from_0_copy2_pointer <= (delay_29_from_0_copy2_pointer == 5'd27) ? (delay_29_from_0_copy2_pointer - 5'd27) : (delay_29_from_0_copy2_pointer + 5'd1);
            delay_29_from_0_copy3_pointer <= (delay_29_from_0_copy3_pointer == 5'd27) ? (delay_29_from_0_copy3_pointer - 5'd27) : (delay_29_from_0_copy3_pointer + 5'd1);
            delay_40_from_0_pointer <= (delay_40_from_0_pointer == 6'd38) ? (delay_40_from_0_pointer - 6'd38) : (delay_40_from_0_pointer + 6'd1);
            in_flight <= {in_flight[38:0], in_valid_and_in_ready};
            left <= out_valid & out_ready;
        end
    end
    always @(posedge clk) begin
        depth_out_d1 <= mul_f32_ftz_unit_y;
        depth_out_d2 <= depth_out_d1;
        depth_out_d3 <= depth_out_d2;
    end
    always @(posedge clk) begin
        delay_28_from_0[delay_28_from_0_pointer] <= to_float_u52q40_f32_ftz_unit_y;
        delay_28_from_0_out <= delay_28_from_0[delay_28_from_0_pointer];
    end
    always @(posedge clk) begin
        delay_29_from_0[delay_29_from_0_pointer] <= {in_attribute_5, in_attribute_4, in_attribute_3, in_attribute_2, in_attribute_1, in_attribute_0};
        delay_29_from_0_out <= delay_29_from_0[delay_29_from_0_pointer];
    end
    always @(posedge clk) begin
        delay_29_from_0_copy2[delay_29_from_0_copy2_pointer] <= {in_attribute_11, in_attribute_10, in_attribute_9, in_attribute_8, in_attribute_7, in_attribute_6};
        delay_29_from_0_copy2_out <= delay_29_from_0_copy2[delay_29_from_0_copy2_pointer];
    end
    always @(posedge clk) begin
        delay_29_from_0_copy3[delay_29_from_0_copy3_pointer] <= in_attribute_12;
        delay_29_from_0_copy3_out <= delay_29_from_0_copy3[delay_29_from_0_copy3_pointer];
    end
    always @(posedge clk) begin
        delay_40_from_0[delay_40_from_0_pointer] <= {in_tile[11:6], in_pixel[5:3], in_tile[5:0], in_pixel[2:0], in_cardinal_0, in_end};
        delay_40_from_0_out <= delay_40_from_0[delay_40_from_0_pointer];
    end

    wire _unused = &{
        1'b0, in_peak, queue_1_in_ready, queue_2_in_ready, queue_2_out_valid, queue_3_in_ready,
        queue_3_out_valid
    };

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        queue_1_has_a_place_for_each_result: assert (~kept | queue_1_in_ready);
        queue_2_has_a_place_for_each_result: assert (~kept | queue_2_in_ready);
        queue_3_has_a_place_for_each_result: assert (~kept | queue_3_in_ready);
        queue_2_in_step: assert (queue_2_out_valid == out_valid);
        queue_3_in_step: assert (queue_3_out_valid == out_valid);
`else
        if (!(~kept | queue_1_in_ready)) begin
            $display("assertion failed: queue_1_has_a_place_for_each_result in %m"); $stop;
        end
        if (!(~kept | queue_2_in_ready)) begin
            $display("assertion failed: queue_2_has_a_place_for_each_result in %m"); $stop;
        end
        if (!(~kept | queue_3_in_ready)) begin
            $display("assertion failed: queue_3_has_a_place_for_each_result in %m"); $stop;
        end
        if (!(queue_2_out_valid == out_valid)) begin
            $display("assertion failed: queue_2_in_step in %m"); $stop;
        end
        if (!(queue_3_out_valid == out_valid)) begin
            $display("assertion failed: queue_3_in_step in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue in a memory with a registered output.
// depth = 44
// width = 32
// storage = distributed
module stream_fifo_d44_w32_distributed (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [31:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [31:0] out_data
);
    (* ram_style = "distributed" *)
    reg [31:0] entries [0:43];
    reg [5:0] held, waiting;
    reg is_full, any_waits;
    reg [5:0] write_address, read_address;
    reg [31:0] item;

    wire has_room = ~is_full;
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [5:0] held_bits = {{5{~push}}, 1'd1};
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    always @(posedge clk) begin
        if (rst) begin
            held <= 6'd0;
            waiting <= 6'd0;
            is_full <= 1'd0;
            any_waits <= 1'd0;
            write_address <= 6'd0;
            read_address <= 6'd0;
            out_valid <= 1'd0;
        end else begin
            if (push_xor_pop) begin
                held <= held + held_bits;
                is_full <= push & (held == 6'd43);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 6'd1);
            end
            if (push) write_address <= (write_address == 6'd43) ? 6'd0 : (write_address + 6'd1);
            if (fetch) read_address <= (read_address == 6'd43) ? 6'd0 : (read_address + 6'd1);
            out_valid <= fetch | (out_valid & ~out_ready);
        end
    end
    always @(posedge clk) begin
        if (has_room) entries[write_address] <= in_data;
        if (fetch) item <= entries[read_address];
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        held_in_range: assert (held <= 6'd44);
        held_is_waiting_and_shown: assert (held == (waiting + {5'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 6'd44)) & (any_waits == |waiting));
`else
        if (!(held <= 6'd44)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {5'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 6'd44)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue in a memory with a registered output.
// depth = 44
// width = 128
// storage = distributed
module stream_fifo_d44_w128_distributed (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [127:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [127:0] out_data
);
    (* ram_style = "distributed" *)
    reg [127:0] entries [0:43];
    reg [5:0] held, waiting;
    reg is_full, any_waits;
    reg [5:0] write_address, read_address;
    reg [127:0] item;

    wire has_room = ~is_full;
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [5:0] held_bits = {{5{~push}}, 1'd1};
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    always @(posedge clk) begin
        if (rst) begin
            held <= 6'd0;
            waiting <= 6'd0;
            is_full <= 1'd0;
            any_waits <= 1'd0;
            write_address <= 6'd0;
            read_address <= 6'd0;
            out_valid <= 1'd0;
        end else begin
            if (push_xor_pop) begin
                held <= held + held_bits;
                is_full <= push & (held == 6'd43);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 6'd1);
            end
            if (push) write_address <= (write_address == 6'd43) ? 6'd0 : (write_address + 6'd1);
            if (fetch) read_address <= (read_address == 6'd43) ? 6'd0 : (read_address + 6'd1);
            out_valid <= fetch | (out_valid & ~out_ready);
        end
    end
    always @(posedge clk) begin
        if (has_room) entries[write_address] <= in_data;
        if (fetch) item <= entries[read_address];
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        held_in_range: assert (held <= 6'd44);
        held_is_waiting_and_shown: assert (held == (waiting + {5'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 6'd44)) & (any_waits == |waiting));
`else
        if (!(held <= 6'd44)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {5'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 6'd44)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue in a memory with a registered output.
// depth = 44
// width = 115
// storage = distributed
module stream_fifo_d44_w115_distributed (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [114:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [114:0] out_data
);
    (* ram_style = "distributed" *)
    reg [114:0] entries [0:43];
    reg [5:0] held, waiting;
    reg is_full, any_waits;
    reg [5:0] write_address, read_address;
    reg [114:0] item;

    wire has_room = ~is_full;
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [5:0] held_bits = {{5{~push}}, 1'd1};
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    always @(posedge clk) begin
        if (rst) begin
            held <= 6'd0;
            waiting <= 6'd0;
            is_full <= 1'd0;
            any_waits <= 1'd0;
            write_address <= 6'd0;
            read_address <= 6'd0;
            out_valid <= 1'd0;
        end else begin
            if (push_xor_pop) begin
                held <= held + held_bits;
                is_full <= push & (held == 6'd43);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 6'd1);
            end
            if (push) write_address <= (write_address == 6'd43) ? 6'd0 : (write_address + 6'd1);
            if (fetch) read_address <= (read_address == 6'd43) ? 6'd0 : (read_address + 6'd1);
            out_valid <= fetch | (out_valid & ~out_ready);
        end
    end
    always @(posedge clk) begin
        if (has_room) entries[write_address] <= in_data;
        if (fetch) item <= entries[read_address];
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        held_in_range: assert (held <= 6'd44);
        held_is_waiting_and_shown: assert (held == (waiting + {5'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 6'd44)) & (any_waits == |waiting));
`else
        if (!(held <= 6'd44)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {5'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 6'd44)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Floating-point format conversion.
// stages = 3
// from = f32-ftz
// to = f16
module float_convert_s3_f32ftz_f16 (
    input  wire clk, input wire enable, input wire [31:0] a,
    output reg  [15:0] y
);
    reg [9:0] distance_s1;
    reg [12:0] significand_s1, significand_s2;
    reg [9:0] exponent_s1, exponent_s2;
    reg sign_s1, sign_s2, nan_s1, nan_s2, infinite_s1, infinite_s2, zero_s1, zero_s2;

    wire [7:0] a_field = a[30:23];
    wire [9:0] a_field_plus_912 = {2'd0, a_field} + 10'd912;
    wire exponent_s1_either = a_field_plus_912[9] | (a_field_plus_912 == 10'd0);
    wire [22:0] a_fraction = a[22:0];
    wire [22:0] significand_s1_both = a_fraction & {23{|a_field}};
    wire [12:0] significand_s2_choice = distance_s1[3] ? (significand_s1 >> 8) : significand_s1;
    wire [12:0] significand_s2_choice_2 = distance_s1[2] ? (significand_s2_choice >> 4) : significand_s2_choice;
    wire [12:0] significand_s2_choice_3 = distance_s1[1] ? (significand_s2_choice_2 >> 2) : significand_s2_choice_2;
    wire [12:0] significand_s2_choice_4 = distance_s1[0] ? (significand_s2_choice_3 >> 1) : significand_s2_choice_3;
    wire significand_s2_either = (distance_s1[3] & |significand_s1[7:0]) | (distance_s1[2] & |significand_s2_choice[3:0]);
    wire significand_s2_either_2 = significand_s2_either | (distance_s1[1] & |significand_s2_choice_2[1:0]);
    wire significand_s2_either_3 = significand_s2_either_2 | (distance_s1[0] & significand_s2_choice_3[0]);
    wire [12:0] significand_s2_bits = {significand_s2_choice_4[12:1], significand_s2_choice_4[0] | significand_s2_either_3};
    wire [14:0] rounded_bits = {exponent_s2[4:0] & {5{significand_s2[12]}}, significand_s2[11:2]};
    wire round_up = significand_s2[1] & (significand_s2[0] | significand_s2[2]);
    wire [14:0] rounded = rounded_bits + {14'd0, round_up};
    wire [14:0] y_choice = (infinite_s2 | (~exponent_s2[9] & (10'd31 <= exponent_s2))) ? 15'h7c00 : rounded;

    always @(posedge clk) begin
        if (enable) begin
            distance_s1 <= (10'd1 - a_field_plus_912) & {10{exponent_s1_either}};
            significand_s1 <= {|a_field, significand_s1_both[22:12], |significand_s1_both[11:0]};
            significand_s2 <= |distance_s1[9:4] ? {12'd0, |significand_s1} : significand_s2_bits;
            exponent_s1 <= exponent_s1_either ? 10'd1 : a_field_plus_912;
            exponent_s2 <= exponent_s1;
            sign_s1 <= a[31];
            sign_s2 <= sign_s1;
            nan_s1 <= &a_field & |a_fraction;
            nan_s2 <= nan_s1;
            infinite_s1 <= &a_field & (a_fraction == 23'd0);
            infinite_s2 <= infinite_s1;
            zero_s1 <= ~(|a_field);
            zero_s2 <= zero_s1;
            y <= nan_s2 ? 16'h7e00 : {sign_s2, zero_s2 ? 15'd0 : y_choice};
        end
    end
endmodule

// Floating-point format conversion.
// stages = 3
// from = f16
// to = f32-ftz
module float_convert_s3_f16_f32ftz (
    input  wire clk, input wire enable, input wire [15:0] a,
    output reg  [31:0] y
);
    reg [3:0] a_zeros_s1;
    reg [7:0] a_exponent_s1;
    reg [10:0] a_significand_s1;
    reg [9:0] exponent_s2;
    reg [25:0] significand_s2;
    reg sign_s1, sign_s2, nan_s1, nan_s2, infinite_s1, infinite_s2, zero_s1, zero_s2;

    wire [4:0] a_field = a[14:10];
    wire a_exponent_s1_inverted = ~(|a_field);
    wire [9:0] a_fraction = a[9:0];
    wire a_zeros_s1_both = a_exponent_s1_inverted & ~a_fraction[9];
    wire a_zeros_s1_both_2 = a_zeros_s1_both & (~a_fraction[8] & ~a_fraction[7]);
    wire a_zeros_s1_both_3 = ~a_fraction[6] & ~a_fraction[5];
    wire a_zeros_s1_both_4 = a_zeros_s1_both_2 & (a_zeros_s1_both_3 & (~a_fraction[4] & ~a_fraction[3]));
    wire a_zeros_s1_both_5 = ~a_fraction[2] & ~a_fraction[1];
    wire [2:0] a_zeros_s1_bits = {1'd0, a_zeros_s1_both_5, a_zeros_s1_both_5 ? ~a_fraction[0] : ~a_fraction[2]};
    wire [1:0] a_zeros_s1_bits_2 = {a_zeros_s1_both_3, a_zeros_s1_both_3 ? ~a_fraction[4] : ~a_fraction[6]};
    wire [1:0] a_zeros_s1_bits_3 = {a_zeros_s1_both, a_zeros_s1_both ? ~a_fraction[8] : a_exponent_s1_inverted};
    wire [2:0] a_zeros_s1_bits_4 = {a_zeros_s1_both_2, a_zeros_s1_both_2 ? a_zeros_s1_bits_2 : a_zeros_s1_bits_3};
    wire [7:0] a_exponent_s1_minus_a_zeros_s1 = a_exponent_s1 - {4'd0, a_zeros_s1};
    wire [9:0] exponent_s2_bits = {{2{a_exponent_s1_minus_a_zeros_s1[7]}}, a_exponent_s1_minus_a_zeros_s1};
    wire y_both = (exponent_s2 == 10'd0) & ~(&significand_s2[24:2] & significand_s2[1]);
    wire round_up = significand_s2[1] & (significand_s2[0] | significand_s2[2]);
    wire [30:0] rounded = {exponent_s2[7:0], significand_s2[24:2]} + {30'd0, round_up};
    wire [30:0] y_choice = (infinite_s2 | (~exponent_s2[9] & (10'd255 <= exponent_s2))) ? 31'h7f800000 : rounded;
    wire [30:0] y_choice_2 = (zero_s2 | ((exponent_s2[9] | y_both) & ~infinite_s2)) ? 31'd0 : y_choice;

    always @(posedge clk) begin
        if (enable) begin
            a_zeros_s1 <= {a_zeros_s1_both_4, a_zeros_s1_both_4 ? a_zeros_s1_bits : a_zeros_s1_bits_4};
            a_exponent_s1 <= {3'd0, a_field[4:1], a_field[0] | a_exponent_s1_inverted};
            a_significand_s1 <= {|a_field, a_fraction};
            exponent_s2 <= exponent_s2_bits + 10'd112;
            significand_s2 <= {a_significand_s1 << a_zeros_s1, 15'd0};
            sign_s1 <= a[15];
            sign_s2 <= sign_s1;
            nan_s1 <= &a_field & |a_fraction;
            nan_s2 <= nan_s1;
            infinite_s1 <= &a_field & (a_fraction == 10'd0);
            infinite_s2 <= infinite_s1;
            zero_s1 <= ~(|a_field | |a_fraction);
            zero_s2 <= zero_s1;
            y <= nan_s2 ? 32'h7fc00000 : {sign_s2, y_choice_2};
        end
    end

    wire _unused = &{1'b0, significand_s2[25]};
endmodule

// Fixed to floating point.
// stages = 4
// format = f32-ftz
// width = 52
// fraction = 40
// integer = unsigned
module float_from_fixed_s4_f32ftz_w52_f40_unsigned (
    input  wire clk, input wire enable, input wire [51:0] a,
    output reg  [31:0] y
);
    reg [51:0] magnitude_s1;
    reg [5:0] zeros_s1;
    reg [51:0] shifted_s2;
    reg [5:0] zeros_s2;
    reg [8:0] exponent_s3;
    reg [25:0] significand_s3;
    reg zero_s1, zero_s2, zero_s3;

    wire not_a_51_and_not_a_50 = ~a[51] & ~a[50];
    wire zeros_s1_both = not_a_51_and_not_a_50 & (~a[49] & ~a[48]);
    wire not_a_47_and_not_a_46 = ~a[47] & ~a[46];
    wire zeros_s1_both_2 = zeros_s1_both & (not_a_47_and_not_a_46 & (~a[45] & ~a[44]));
    wire not_a_43_and_not_a_42 = ~a[43] & ~a[42];
    wire zeros_s1_both_3 = not_a_43_and_not_a_42 & (~a[41] & ~a[40]);
    wire not_a_39_and_not_a_38 = ~a[39] & ~a[38];
    wire zeros_s1_both_4 = zeros_s1_both_2 & (zeros_s1_both_3 & (not_a_39_and_not_a_38 & (~a[37] & ~a[36])));
    wire not_a_35_and_not_a_34 = ~a[35] & ~a[34];
    wire zeros_s1_both_5 = not_a_35_and_not_a_34 & (~a[33] & ~a[32]);
    wire not_a_31_and_not_a_30 = ~a[31] & ~a[30];
    wire zeros_s1_both_6 = zeros_s1_both_5 & (not_a_31_and_not_a_30 & (~a[29] & ~a[28]));
    wire not_a_27_and_not_a_26 = ~a[27] & ~a[26];
    wire zeros_s1_both_7 = not_a_27_and_not_a_26 & (~a[25] & ~a[24]);
    wire not_a_23_and_not_a_22 = ~a[23] & ~a[22];
    wire zeros_s1_both_8 = zeros_s1_both_6 & (zeros_s1_both_7 & (not_a_23_and_not_a_22 & (~a[21] & ~a[20])));
    wire zeros_s1_both_9 = zeros_s1_both_4 & zeros_s1_both_8;
    wire not_a_19_and_not_a_18 = ~a[19] & ~a[18];
    wire zeros_s1_both_10 = not_a_19_and_not_a_18 & (~a[17] & ~a[16]);
    wire not_a_15_and_not_a_14 = ~a[15] & ~a[14];
    wire zeros_s1_both_11 = zeros_s1_both_10 & (not_a_15_and_not_a_14 & (~a[13] & ~a[12]));
    wire not_a_11_and_not_a_10 = ~a[11] & ~a[10];
    wire zeros_s1_both_12 = not_a_11_and_not_a_10 & (~a[9] & ~a[8]);
    wire not_a_7_and_not_a_6 = ~a[7] & ~a[6];
    wire zeros_s1_both_13 = zeros_s1_both_11 & (zeros_s1_both_12 & (not_a_7_and_not_a_6 & (~a[5] & ~a[4])));
    wire not_a_3_and_not_a_2 = ~a[3] & ~a[2];
    wire zeros_s1_both_14 = not_a_3_and_not_a_2 & (~a[1] & ~a[0]);
    wire [1:0] zeros_s1_choice = zeros_s1_both_14 ? 2'd0 : {not_a_3_and_not_a_2, not_a_3_and_not_a_2 ? ~a[1] : ~a[3]};
    wire [1:0] zeros_s1_choice_2 = zeros_s1_both_12 ? {not_a_7_and_not_a_6, not_a_7_and_not_a_6 ? ~a[5] : ~a[7]} : {not_a_11_and_not_a_10, not_a_11_and_not_a_10 ? ~a[9] : ~a[11]};
    wire [1:0] zeros_s1_choice_3 = zeros_s1_both_10 ? {not_a_15_and_not_a_14, not_a_15_and_not_a_14 ? ~a[13] : ~a[15]} : {not_a_19_and_not_a_18, not_a_19_and_not_a_18 ? ~a[17] : ~a[19]};
    wire [2:0] zeros_s1_choice_4 = zeros_s1_both_11 ? {zeros_s1_both_12, zeros_s1_choice_2} : {zeros_s1_both_10, zeros_s1_choice_3};
    wire [3:0] zeros_s1_choice_5 = zeros_s1_both_13 ? {1'd0, zeros_s1_both_14, zeros_s1_choice} : {zeros_s1_both_11, zeros_s1_choice_4};
    wire [1:0] zeros_s1_choice_6 = zeros_s1_both_7 ? {not_a_23_and_not_a_22, not_a_23_and_not_a_22 ? ~a[21] : ~a[23]} : {not_a_27_and_not_a_26, not_a_27_and_not_a_26 ? ~a[25] : ~a[27]};
    wire [1:0] zeros_s1_choice_7 = zeros_s1_both_5 ? {not_a_31_and_not_a_30, not_a_31_and_not_a_30 ? ~a[29] : ~a[31]} : {not_a_35_and_not_a_34, not_a_35_and_not_a_34 ? ~a[33] : ~a[35]};
    wire [2:0] zeros_s1_choice_8 = zeros_s1_both_6 ? {zeros_s1_both_7, zeros_s1_choice_6} : {zeros_s1_both_5, zeros_s1_choice_7};
    wire [1:0] zeros_s1_choice_9 = zeros_s1_both_3 ? {not_a_39_and_not_a_38, not_a_39_and_not_a_38 ? ~a[37] : ~a[39]} : {not_a_43_and_not_a_42, not_a_43_and_not_a_42 ? ~a[41] : ~a[43]};
    wire [1:0] zeros_s1_choice_10 = zeros_s1_both ? {not_a_47_and_not_a_46, not_a_47_and_not_a_46 ? ~a[45] : ~a[47]} : {not_a_51_and_not_a_50, not_a_51_and_not_a_50 ? ~a[49] : ~a[51]};
    wire [2:0] zeros_s1_choice_11 = zeros_s1_both_2 ? {zeros_s1_both_3, zeros_s1_choice_9} : {zeros_s1_both, zeros_s1_choice_10};
    wire [3:0] zeros_s1_choice_12 = zeros_s1_both_4 ? {zeros_s1_both_6, zeros_s1_choice_8} : {zeros_s1_both_2, zeros_s1_choice_11};
    wire [4:0] zeros_s1_choice_13 = zeros_s1_both_9 ? {zeros_s1_both_13, zeros_s1_choice_5} : {zeros_s1_both_4, zeros_s1_choice_12};
    wire y_both = (exponent_s3 == 9'd0) & ~(&significand_s3[24:2] & significand_s3[1]);
    wire round_up = significand_s3[1] & (significand_s3[0] | significand_s3[2]);
    wire [30:0] rounded = {exponent_s3[7:0], significand_s3[24:2]} + {30'd0, round_up};
    wire [30:0] y_choice = (~exponent_s3[8] & (9'd255 <= exponent_s3)) ? 31'h7f800000 : rounded;

    always @(posedge clk) begin
        if (enable) begin
            magnitude_s1 <= a;
            zeros_s1 <= {zeros_s1_both_9, zeros_s1_choice_13};
            shifted_s2 <= magnitude_s1 << zeros_s1;
            zeros_s2 <= zeros_s1;
            exponent_s3 <= 9'd138 - {3'd0, zeros_s2};
            significand_s3 <= {shifted_s2[51:27], |shifted_s2[26:0]};
            zero_s1 <= a == 52'd0;
            zero_s2 <= zero_s1;
            zero_s3 <= zero_s2;
            y <= {1'd0, (zero_s3 | (exponent_s3[8] | y_both)) ? 31'd0 : y_choice};
        end
    end

    wire _unused = &{1'b0, significand_s3[25]};
endmodule

// Fixed to floating point.
// stages = 4
// format = f32-ftz
// width = 28
// fraction = 16
// integer = unsigned
module float_from_fixed_s4_f32ftz_w28_f16_unsigned (
    input  wire clk, input wire enable, input wire [27:0] a,
    output reg  [31:0] y
);
    reg [27:0] magnitude_s1;
    reg [4:0] zeros_s1;
    reg [27:0] shifted_s2;
    reg [4:0] zeros_s2;
    reg [8:0] exponent_s3;
    reg [25:0] significand_s3;
    reg zero_s1, zero_s2, zero_s3;

    wire not_a_27_and_not_a_26 = ~a[27] & ~a[26];
    wire zeros_s1_both = not_a_27_and_not_a_26 & (~a[25] & ~a[24]);
    wire not_a_23_and_not_a_22 = ~a[23] & ~a[22];
    wire zeros_s1_both_2 = zeros_s1_both & (not_a_23_and_not_a_22 & (~a[21] & ~a[20]));
    wire not_a_19_and_not_a_18 = ~a[19] & ~a[18];
    wire zeros_s1_both_3 = not_a_19_and_not_a_18 & (~a[17] & ~a[16]);
    wire not_a_15_and_not_a_14 = ~a[15] & ~a[14];
    wire zeros_s1_both_4 = zeros_s1_both_2 & (zeros_s1_both_3 & (not_a_15_and_not_a_14 & (~a[13] & ~a[12])));
    wire not_a_11_and_not_a_10 = ~a[11] & ~a[10];
    wire zeros_s1_both_5 = not_a_11_and_not_a_10 & (~a[9] & ~a[8]);
    wire not_a_7_and_not_a_6 = ~a[7] & ~a[6];
    wire zeros_s1_both_6 = zeros_s1_both_5 & (not_a_7_and_not_a_6 & (~a[5] & ~a[4]));
    wire not_a_3_and_not_a_2 = ~a[3] & ~a[2];
    wire zeros_s1_both_7 = not_a_3_and_not_a_2 & (~a[1] & ~a[0]);
    wire [1:0] zeros_s1_choice = zeros_s1_both_7 ? 2'd0 : {not_a_3_and_not_a_2, not_a_3_and_not_a_2 ? ~a[1] : ~a[3]};
    wire [1:0] zeros_s1_choice_2 = zeros_s1_both_5 ? {not_a_7_and_not_a_6, not_a_7_and_not_a_6 ? ~a[5] : ~a[7]} : {not_a_11_and_not_a_10, not_a_11_and_not_a_10 ? ~a[9] : ~a[11]};
    wire [2:0] zeros_s1_choice_3 = zeros_s1_both_6 ? {zeros_s1_both_7, zeros_s1_choice} : {zeros_s1_both_5, zeros_s1_choice_2};
    wire [1:0] zeros_s1_choice_4 = zeros_s1_both_3 ? {not_a_15_and_not_a_14, not_a_15_and_not_a_14 ? ~a[13] : ~a[15]} : {not_a_19_and_not_a_18, not_a_19_and_not_a_18 ? ~a[17] : ~a[19]};
    wire [1:0] zeros_s1_choice_5 = zeros_s1_both ? {not_a_23_and_not_a_22, not_a_23_and_not_a_22 ? ~a[21] : ~a[23]} : {not_a_27_and_not_a_26, not_a_27_and_not_a_26 ? ~a[25] : ~a[27]};
    wire [2:0] zeros_s1_choice_6 = zeros_s1_both_2 ? {zeros_s1_both_3, zeros_s1_choice_4} : {zeros_s1_both, zeros_s1_choice_5};
    wire [3:0] zeros_s1_choice_7 = zeros_s1_both_4 ? {zeros_s1_both_6, zeros_s1_choice_3} : {zeros_s1_both_2, zeros_s1_choice_6};
    wire y_both = (exponent_s3 == 9'd0) & ~(&significand_s3[24:2] & significand_s3[1]);
    wire round_up = significand_s3[1] & (significand_s3[0] | significand_s3[2]);
    wire [30:0] rounded = {exponent_s3[7:0], significand_s3[24:2]} + {30'd0, round_up};
    wire [30:0] y_choice = (~exponent_s3[8] & (9'd255 <= exponent_s3)) ? 31'h7f800000 : rounded;

    always @(posedge clk) begin
        if (enable) begin
            magnitude_s1 <= a;
            zeros_s1 <= {zeros_s1_both_4, zeros_s1_choice_7};
            shifted_s2 <= magnitude_s1 << zeros_s1;
            zeros_s2 <= zeros_s1;
            exponent_s3 <= 9'd138 - {4'd0, zeros_s2};
            significand_s3 <= {shifted_s2[27:3], |shifted_s2[2:0]};
            zero_s1 <= a == 28'd0;
            zero_s2 <= zero_s1;
            zero_s3 <= zero_s2;
            y <= {1'd0, (zero_s3 | (exponent_s3[8] | y_both)) ? 31'd0 : y_choice};
        end
    end

    wire _unused = &{1'b0, significand_s3[25]};
endmodule

// A rasterizer with the lists, slots and sums of its share of the tiles.
module splat_lane (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready,  // Copies for its tiles.
    input  wire in_end,  // Closes the frame.
    input  wire in_first,  // It is the first of its splat.
    input  wire [31:0] in_center_x,  // Projected center (px), the origin of what follows.
    input  wire [31:0] in_center_y,  // Projected center (px), the origin of what follows.
    input  wire [31:0] in_ax,  // `A` in x.
    input  wire [31:0] in_bx,  // `B` in x.
    input  wire [31:0] in_ay,  // `A` in y.
    input  wire [31:0] in_by,  // `B` in y.
    input  wire [31:0] in_delta,  // The determinant of `A` and `B`.
    input  wire [31:0] in_mx,  // `m` in x.
    input  wire [31:0] in_my,  // `m` in y.
    input  wire in_sight_negative,  // `D` is negative before the eye.
    input  wire [30:0] in_sight_near,  // The magnitude of `D` at the near plane; all ones where no sample lies before it.
    input  wire [30:0] in_sight_far,  // The magnitude of `D` at the far plane; zero where no sample lies behind it.
    input  wire in_sight_turned,  // The origin is the vanishing point of a tangent: `s1` and `D` have changed places.
    input  wire in_sight_disc,  // The origin is the splat's centre, and lies between near and far plane: the filter's disc is drawn.
    input  wire [23:0] in_depth,  // Depth.
    input  wire [23:0] in_depth_low,  // What is nearer hides the splat.
    input  wire [23:0] in_depth_high,  // What is farther is hidden by the splat.
    input  wire [15:0] in_attribute_0,  // Attributes.
    input  wire [15:0] in_attribute_1,  // Attributes.
    input  wire [15:0] in_attribute_2,  // Attributes.
    input  wire [15:0] in_attribute_3,  // Attributes.
    input  wire [15:0] in_attribute_4,  // Attributes.
    input  wire [15:0] in_attribute_5,  // Attributes.
    input  wire [15:0] in_attribute_6,  // Attributes.
    input  wire [15:0] in_attribute_7,  // Attributes.
    input  wire [15:0] in_attribute_8,  // Attributes.
    input  wire [15:0] in_attribute_9,  // Attributes.
    input  wire [15:0] in_attribute_10,  // Attributes.
    input  wire [15:0] in_attribute_11,  // Attributes.
    input  wire [15:0] in_attribute_12,  // Attributes.
    input  wire [15:0] in_cardinal_0,  // Attributes.
    input  wire [2:0] in_left,  // First column.
    input  wire [2:0] in_right,  // Last column.
    input  wire [2:0] in_top,  // First row.
    input  wire [2:0] in_bottom,  // Last row.
    input  wire [3:0] in_first_sum,  // Smallest sum.
    input  wire [3:0] in_last_sum,  // Largest sum.
    input  wire [3:0] in_first_difference,  // Smallest difference.
    input  wire [3:0] in_last_difference,  // Largest difference.
    input  wire [11:0] in_tile,  // Tile index: row above column.
    output wire read_valid, input wire read_ready,  // Request for pixels of a tile.
    output wire read_surface,  // The frame is one of those with odd numbers.
    output wire [11:0] read_tile,  // Tile index.
    output wire [5:0] read_pixel,  // The first pixel of the tile.
    output wire [3:0] read_count,  // How many there are, at least one.
    input  wire data_valid, output wire data_ready,  // The pixels requested, in order.
    input  wire [27:0] data_weight,  // Sum of weights.
    input  wire [51:0] data_depth,  // Sum of weighted depths.
    input  wire [15:0] data_peak,  // The largest single weight, with cardinal attributes only.
    input  wire [15:0] data_attribute_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] data_attribute_1,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] data_attribute_2,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] data_attribute_3,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] data_attribute_4,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] data_attribute_5,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] data_attribute_6,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] data_attribute_7,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] data_attribute_8,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] data_attribute_9,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] data_attribute_10,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] data_attribute_11,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] data_attribute_12,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] data_cardinal_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire write_valid, input wire write_ready,  // Pixels of evicted tiles.
    output wire write_surface,  // The frame is one of those with odd numbers: two have a place in the buffer.
    output wire [11:0] write_tile,  // Tile index.
    output wire [5:0] write_pixel,  // Pixel of the tile.
    output wire [27:0] write_weight,  // Sum of weights.
    output wire [51:0] write_depth,  // Sum of weighted depths.
    output wire [15:0] write_peak,  // The largest single weight, with cardinal attributes only.
    output wire [15:0] write_attribute_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] write_attribute_1,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] write_attribute_2,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] write_attribute_3,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] write_attribute_4,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] write_attribute_5,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] write_attribute_6,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] write_attribute_7,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] write_attribute_8,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] write_attribute_9,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] write_attribute_10,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] write_attribute_11,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] write_attribute_12,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] write_cardinal_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire pixel_valid, input wire pixel_ready,  // Pixels of a finished frame.
    output wire pixel_end,  // Closes the frame.
    output wire [11:0] pixel_tile,  // Tile index.
    output wire [5:0] pixel_pixel,  // Pixel of the tile.
    output wire [27:0] pixel_weight,  // Sum of weights.
    output wire [51:0] pixel_depth,  // Sum of weighted depths.
    output wire [15:0] pixel_peak,  // The largest single weight, with cardinal attributes only.
    output wire [15:0] pixel_attribute_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] pixel_attribute_1,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] pixel_attribute_2,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] pixel_attribute_3,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] pixel_attribute_4,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] pixel_attribute_5,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] pixel_attribute_6,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] pixel_attribute_7,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] pixel_attribute_8,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] pixel_attribute_9,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] pixel_attribute_10,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] pixel_attribute_11,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] pixel_attribute_12,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] pixel_cardinal_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [31:0] filter_scale,  // The reciprocal of the squared radius of the screen filter.
    output wire event_sample,  // The rasterizer evaluated a sample.
    output wire event_starved,  // The rasterizer had no copy to work on.
    output wire event_blocked,  // The rasterizer's pipeline was held by what follows it.
    output wire event_accumulate,  // The accumulator took a sample.
    output wire event_hazard,  // The accumulator waited for an earlier sample of the same pixel.
    output wire event_slot_wait  // The accumulator waited for its tile to arrive in the cache.
);
    wire payloads_copy_valid, payloads_copy_end;
    wire [2:0] payloads_copy_left, payloads_copy_right, payloads_copy_top, payloads_copy_bottom;
    wire [3:0] payloads_copy_first_sum, payloads_copy_last_sum, payloads_copy_first_difference;
    wire [3:0] payloads_copy_last_difference;
    wire [11:0] payloads_copy_tile;
    wire [10:0] payloads_copy_splat;
    wire payloads_placed_ready, payloads_out_valid;
    wire [31:0] payloads_out_center_x, payloads_out_center_y, payloads_out_ax, payloads_out_bx, payloads_out_ay;
    wire [31:0] payloads_out_by, payloads_out_delta, payloads_out_mx, payloads_out_my;
    wire payloads_out_sight_negative;
    wire [30:0] payloads_out_sight_near, payloads_out_sight_far;
    wire payloads_out_sight_turned, payloads_out_sight_disc;
    wire [23:0] payloads_out_depth, payloads_out_depth_low, payloads_out_depth_high;
    wire [15:0] payloads_out_attribute_0, payloads_out_attribute_1, payloads_out_attribute_2;
    wire [15:0] payloads_out_attribute_3, payloads_out_attribute_4, payloads_out_attribute_5;
    wire [15:0] payloads_out_attribute_6, payloads_out_attribute_7, payloads_out_attribute_8;
    wire [15:0] payloads_out_attribute_9, payloads_out_attribute_10, payloads_out_attribute_11;
    wire [15:0] payloads_out_attribute_12, payloads_out_cardinal_0;
    wire [2:0] payloads_out_left, payloads_out_right, payloads_out_top, payloads_out_bottom;
    wire [3:0] payloads_out_first_sum, payloads_out_last_sum, payloads_out_first_difference;
    wire [3:0] payloads_out_last_difference;
    wire [11:0] payloads_out_tile;
    wire [2:0] payloads_out_slot;
    wire reorder_in_ready, reorder_out_valid, reorder_out_end;
    wire [2:0] reorder_out_left, reorder_out_right, reorder_out_top, reorder_out_bottom;
    wire [3:0] reorder_out_first_sum, reorder_out_last_sum, reorder_out_first_difference;
    wire [3:0] reorder_out_last_difference;
    wire [11:0] reorder_out_tile;
    wire [10:0] reorder_out_splat;
    wire tile_cache_in_ready, tile_cache_out_valid;
    wire [2:0] tile_cache_out_left, tile_cache_out_right, tile_cache_out_top, tile_cache_out_bottom;
    wire [3:0] tile_cache_out_first_sum, tile_cache_out_last_sum, tile_cache_out_first_difference;
    wire [3:0] tile_cache_out_last_difference;
    wire [11:0] tile_cache_out_tile;
    wire [10:0] tile_cache_out_splat;
    wire [2:0] tile_cache_out_slot;
    wire [7:0] tile_cache_slot_ready;
    wire tile_cache_full, tile_cache_change_valid;
    wire [2:0] tile_cache_change_slot;
    wire [1:0] tile_cache_change_banks;
    wire [63:0] tile_cache_change_held;
    wire tile_cache_drain_enable;
    wire [2:0] tile_cache_drain_slot;
    wire [5:0] tile_cache_drain_pixel;
    wire tile_cache_fill_valid;
    wire [2:0] tile_cache_fill_slot;
    wire [5:0] tile_cache_fill_pixel;
    wire [27:0] tile_cache_fill_weight;
    wire [51:0] tile_cache_fill_depth;
    wire [15:0] tile_cache_fill_peak, tile_cache_fill_attribute_0, tile_cache_fill_attribute_1;
    wire [15:0] tile_cache_fill_attribute_2, tile_cache_fill_attribute_3, tile_cache_fill_attribute_4;
    wire [15:0] tile_cache_fill_attribute_5, tile_cache_fill_attribute_6, tile_cache_fill_attribute_7;
    wire [15:0] tile_cache_fill_attribute_8, tile_cache_fill_attribute_9, tile_cache_fill_attribute_10;
    wire [15:0] tile_cache_fill_attribute_11, tile_cache_fill_attribute_12, tile_cache_fill_cardinal_0;
    wire rasterizer_in_ready, rasterizer_out_valid, rasterizer_out_last, rasterizer_out_inside;
    wire [2:0] rasterizer_out_slot;
    wire [5:0] rasterizer_out_pixel;
    wire [15:0] rasterizer_out_weight;
    wire [23:0] rasterizer_out_depth, rasterizer_out_depth_low, rasterizer_out_depth_high;
    wire [15:0] rasterizer_out_attribute_0, rasterizer_out_attribute_1, rasterizer_out_attribute_2;
    wire [15:0] rasterizer_out_attribute_3, rasterizer_out_attribute_4, rasterizer_out_attribute_5;
    wire [15:0] rasterizer_out_attribute_6, rasterizer_out_attribute_7, rasterizer_out_attribute_8;
    wire [15:0] rasterizer_out_attribute_9, rasterizer_out_attribute_10, rasterizer_out_attribute_11;
    wire [15:0] rasterizer_out_attribute_12, rasterizer_out_cardinal_0;
    wire weighting_in_ready, weighting_out_valid, weighting_out_last, weighting_out_inside;
    wire [2:0] weighting_out_slot;
    wire [5:0] weighting_out_pixel;
    wire [15:0] weighting_out_weight;
    wire [39:0] weighting_out_weighted_depth;
    wire [23:0] weighting_out_depth_low, weighting_out_depth_high;
    wire [15:0] weighting_out_attribute_0, weighting_out_attribute_1, weighting_out_attribute_2;
    wire [15:0] weighting_out_attribute_3, weighting_out_attribute_4, weighting_out_attribute_5;
    wire [15:0] weighting_out_attribute_6, weighting_out_attribute_7, weighting_out_attribute_8;
    wire [15:0] weighting_out_attribute_9, weighting_out_attribute_10, weighting_out_attribute_11;
    wire [15:0] weighting_out_attribute_12, weighting_out_cardinal_0;
    wire accumulator_in_ready, accumulator_retire_valid;
    wire [2:0] accumulator_retire_slot;
    wire [1:0] accumulator_sample_reads, accumulator_sample_writes;
    wire [63:0] accumulator_masks_written, accumulator_masks_dirty;
    wire accumulator_drained_valid;
    wire [5:0] accumulator_drained_pixel;
    wire [27:0] accumulator_drained_weight;
    wire [51:0] accumulator_drained_depth;
    wire [15:0] accumulator_drained_peak, accumulator_drained_attribute_0, accumulator_drained_attribute_1;
    wire [15:0] accumulator_drained_attribute_2, accumulator_drained_attribute_3, accumulator_drained_attribute_4;
    wire [15:0] accumulator_drained_attribute_5, accumulator_drained_attribute_6, accumulator_drained_attribute_7;
    wire [15:0] accumulator_drained_attribute_8, accumulator_drained_attribute_9, accumulator_drained_attribute_10;
    wire [15:0] accumulator_drained_attribute_11, accumulator_drained_attribute_12, accumulator_drained_cardinal_0;

    wire payloads_copy_ready = reorder_in_ready & ~tile_cache_full;
    wire copy_comes = payloads_copy_valid & ~tile_cache_full;

    splat_payloads payloads (
        .clk(clk), .rst(rst), .in_valid(in_valid), .in_ready(in_ready), .in_end(in_end), .in_first(in_first),
        .in_center_x(in_center_x), .in_center_y(in_center_y), .in_ax(in_ax), .in_bx(in_bx), .in_ay(in_ay),
        .in_by(in_by), .in_delta(in_delta), .in_mx(in_mx), .in_my(in_my),
        .in_sight_negative(in_sight_negative), .in_sight_near(in_sight_near), .in_sight_far(in_sight_far),
        .in_sight_turned(in_sight_turned), .in_sight_disc(in_sight_disc), .in_depth(in_depth),
        .in_depth_low(in_depth_low), .in_depth_high(in_depth_high), .in_attribute_0(in_attribute_0),
        .in_attribute_1(in_attribute_1), .in_attribute_2(in_attribute_2), .in_attribute_3(in_attribute_3),
        .in_attribute_4(in_attribute_4), .in_attribute_5(in_attribute_5), .in_attribute_6(in_attribute_6),
        .in_attribute_7(in_attribute_7), .in_attribute_8(in_attribute_8), .in_attribute_9(in_attribute_9),
        .in_attribute_10(in_attribute_10), .in_attribute_11(in_attribute_11),
        .in_attribute_12(in_attribute_12), .in_cardinal_0(in_cardinal_0), .in_left(in_left),
        .in_right(in_right), .in_top(in_top), .in_bottom(in_bottom), .in_first_sum(in_first_sum),
        .in_last_sum(in_last_sum), .in_first_difference(in_first_difference),
        .in_last_difference(in_last_difference), .in_tile(in_tile),
        .copy_valid(payloads_copy_valid), .copy_ready(payloads_copy_ready), .copy_end(payloads_copy_end),
        .copy_left(payloads_copy_left), .copy_right(payloads_copy_right), .copy_top(payloads_copy_top),
        .copy_bottom(payloads_copy_bottom), .copy_first_sum(payloads_copy_first_sum),
        .copy_last_sum(payloads_copy_last_sum), .copy_first_difference(payloads_copy_first_difference),
        .copy_last_difference(payloads_copy_last_difference), .copy_tile(payloads_copy_tile),
        .copy_splat(payloads_copy_splat),
        .placed_valid(tile_cache_out_valid), .placed_ready(payloads_placed_ready),
        .placed_left(tile_cache_out_left), .placed_right(tile_cache_out_right),
        .placed_top(tile_cache_out_top), .placed_bottom(tile_cache_out_bottom),
        .placed_first_sum(tile_cache_out_first_sum), .placed_last_sum(tile_cache_out_last_sum),
        .placed_first_difference(tile_cache_out_first_difference),
        .placed_last_difference(tile_cache_out_last_difference), .placed_tile(tile_cache_out_tile),
        .placed_splat(tile_cache_out_splat), .placed_slot(tile_cache_out_slot),
        .out_valid(payloads_out_valid), .out_ready(rasterizer_in_ready), .out_center_x(payloads_out_center_x),
        .out_center_y(payloads_out_center_y), .out_ax(payloads_out_ax), .out_bx(payloads_out_bx),
        .out_ay(payloads_out_ay), .out_by(payloads_out_by), .out_delta(payloads_out_delta),
        .out_mx(payloads_out_mx), .out_my(payloads_out_my), .out_sight_negative(payloads_out_sight_negative),
        .out_sight_near(payloads_out_sight_near), .out_sight_far(payloads_out_sight_far),
        .out_sight_turned(payloads_out_sight_turned), .out_sight_disc(payloads_out_sight_disc),
        .out_depth(payloads_out_depth), .out_depth_low(payloads_out_depth_low),
        .out_depth_high(payloads_out_depth_high), .out_attribute_0(payloads_out_attribute_0),
        .out_attribute_1(payloads_out_attribute_1), .out_attribute_2(payloads_out_attribute_2),
        .out_attribute_3(payloads_out_attribute_3), .out_attribute_4(payloads_out_attribute_4),
        .out_attribute_5(payloads_out_attribute_5), .out_attribute_6(payloads_out_attribute_6),
        .out_attribute_7(payloads_out_attribute_7), .out_attribute_8(payloads_out_attribute_8),
        .out_attribute_9(payloads_out_attribute_9), .out_attribute_10(payloads_out_attribute_10),
        .out_attribute_11(payloads_out_attribute_11), .out_attribute_12(payloads_out_attribute_12),
        .out_cardinal_0(payloads_out_cardinal_0), .out_left(payloads_out_left),
        .out_right(payloads_out_right), .out_top(payloads_out_top), .out_bottom(payloads_out_bottom),
        .out_first_sum(payloads_out_first_sum), .out_last_sum(payloads_out_last_sum),
        .out_first_difference(payloads_out_first_difference),
        .out_last_difference(payloads_out_last_difference), .out_tile(payloads_out_tile),
        .out_slot(payloads_out_slot)
    );

    splat_reorder reorder (
        .clk(clk), .rst(rst), .in_valid(copy_comes), .in_ready(reorder_in_ready), .in_end(payloads_copy_end),
        .in_left(payloads_copy_left), .in_right(payloads_copy_right), .in_top(payloads_copy_top),
        .in_bottom(payloads_copy_bottom), .in_first_sum(payloads_copy_first_sum),
        .in_last_sum(payloads_copy_last_sum), .in_first_difference(payloads_copy_first_difference),
        .in_last_difference(payloads_copy_last_difference), .in_tile(payloads_copy_tile),
        .in_splat(payloads_copy_splat),
        .out_valid(reorder_out_valid), .out_ready(tile_cache_in_ready), .out_end(reorder_out_end),
        .out_left(reorder_out_left), .out_right(reorder_out_right), .out_top(reorder_out_top),
        .out_bottom(reorder_out_bottom), .out_first_sum(reorder_out_first_sum),
        .out_last_sum(reorder_out_last_sum), .out_first_difference(reorder_out_first_difference),
        .out_last_difference(reorder_out_last_difference), .out_tile(reorder_out_tile),
        .out_splat(reorder_out_splat)
    );

    splat_tile_cache tile_cache (
        .clk(clk), .rst(rst), .in_valid(reorder_out_valid), .in_ready(tile_cache_in_ready),
        .in_end(reorder_out_end), .in_left(reorder_out_left), .in_right(reorder_out_right),
        .in_top(reorder_out_top), .in_bottom(reorder_out_bottom), .in_first_sum(reorder_out_first_sum),
        .in_last_sum(reorder_out_last_sum), .in_first_difference(reorder_out_first_difference),
        .in_last_difference(reorder_out_last_difference), .in_tile(reorder_out_tile),
        .in_splat(reorder_out_splat),
        .out_valid(tile_cache_out_valid), .out_ready(payloads_placed_ready), .out_left(tile_cache_out_left),
        .out_right(tile_cache_out_right), .out_top(tile_cache_out_top), .out_bottom(tile_cache_out_bottom),
        .out_first_sum(tile_cache_out_first_sum), .out_last_sum(tile_cache_out_last_sum),
        .out_first_difference(tile_cache_out_first_difference),
        .out_last_difference(tile_cache_out_last_difference), .out_tile(tile_cache_out_tile),
        .out_splat(tile_cache_out_splat), .out_slot(tile_cache_out_slot),
        .pixel_valid(pixel_valid), .pixel_ready(pixel_ready), .pixel_end(pixel_end), .pixel_tile(pixel_tile),
        .pixel_pixel(pixel_pixel), .pixel_weight(pixel_weight), .pixel_depth(pixel_depth),
        .pixel_peak(pixel_peak), .pixel_attribute_0(pixel_attribute_0), .pixel_attribute_1(pixel_attribute_1),
        .pixel_attribute_2(pixel_attribute_2), .pixel_attribute_3(pixel_attribute_3),
        .pixel_attribute_4(pixel_attribute_4), .pixel_attribute_5(pixel_attribute_5),
        .pixel_attribute_6(pixel_attribute_6), .pixel_attribute_7(pixel_attribute_7),
        .pixel_attribute_8(pixel_attribute_8), .pixel_attribute_9(pixel_attribute_9),
        .pixel_attribute_10(pixel_attribute_10), .pixel_attribute_11(pixel_attribute_11),
        .pixel_attribute_12(pixel_attribute_12), .pixel_cardinal_0(pixel_cardinal_0),
        .slot_ready(tile_cache_slot_ready),
        .retire_valid(accumulator_retire_valid), .retire_slot(accumulator_retire_slot),
        .masks_written(accumulator_masks_written), .masks_dirty(accumulator_masks_dirty),
        .arrives_valid(copy_comes & reorder_in_ready), .arrives_end(payloads_copy_end),
        .arrives_tile(payloads_copy_tile), .arrives_splat(payloads_copy_splat),
        .full(tile_cache_full), .change_valid(tile_cache_change_valid), .change_slot(tile_cache_change_slot),
        .change_banks(tile_cache_change_banks), .change_held(tile_cache_change_held),
        .sample_reads(accumulator_sample_reads), .sample_writes(accumulator_sample_writes),
        .read_valid(read_valid), .read_ready(read_ready), .read_surface(read_surface), .read_tile(read_tile),
        .read_pixel(read_pixel), .read_count(read_count),
        .drain_enable(tile_cache_drain_enable), .drain_slot(tile_cache_drain_slot),
        .drain_pixel(tile_cache_drain_pixel),
        .drained_valid(accumulator_drained_valid), .drained_pixel(accumulator_drained_pixel),
        .drained_weight(accumulator_drained_weight), .drained_depth(accumulator_drained_depth),
        .drained_peak(accumulator_drained_peak), .drained_attribute_0(accumulator_drained_attribute_0),
        .drained_attribute_1(accumulator_drained_attribute_1),
        .drained_attribute_2(accumulator_drained_attribute_2),
        .drained_attribute_3(accumulator_drained_attribute_3),
        .drained_attribute_4(accumulator_drained_attribute_4),
        .drained_attribute_5(accumulator_drained_attribute_5),
        .drained_attribute_6(accumulator_drained_attribute_6),
        .drained_attribute_7(accumulator_drained_attribute_7),
        .drained_attribute_8(accumulator_drained_attribute_8),
        .drained_attribute_9(accumulator_drained_attribute_9),
        .drained_attribute_10(accumulator_drained_attribute_10),
        .drained_attribute_11(accumulator_drained_attribute_11),
        .drained_attribute_12(accumulator_drained_attribute_12),
        .drained_cardinal_0(accumulator_drained_cardinal_0),
        .write_valid(write_valid), .write_ready(write_ready), .write_surface(write_surface),
        .write_tile(write_tile), .write_pixel(write_pixel), .write_weight(write_weight),
        .write_depth(write_depth), .write_peak(write_peak), .write_attribute_0(write_attribute_0),
        .write_attribute_1(write_attribute_1), .write_attribute_2(write_attribute_2),
        .write_attribute_3(write_attribute_3), .write_attribute_4(write_attribute_4),
        .write_attribute_5(write_attribute_5), .write_attribute_6(write_attribute_6),
        .write_attribute_7(write_attribute_7), .write_attribute_8(write_attribute_8),
        .write_attribute_9(write_attribute_9), .write_attribute_10(write_attribute_10),
        .write_attribute_11(write_attribute_11), .write_attribute_12(write_attribute_12),
        .write_cardinal_0(write_cardinal_0),
        .data_valid(data_valid), .data_ready(data_ready), .data_weight(data_weight), .data_depth(data_depth),
        .data_peak(data_peak), .data_attribute_0(data_attribute_0), .data_attribute_1(data_attribute_1),
        .data_attribute_2(data_attribute_2), .data_attribute_3(data_attribute_3),
        .data_attribute_4(data_attribute_4), .data_attribute_5(data_attribute_5),
        .data_attribute_6(data_attribute_6), .data_attribute_7(data_attribute_7),
        .data_attribute_8(data_attribute_8), .data_attribute_9(data_attribute_9),
        .data_attribute_10(data_attribute_10), .data_attribute_11(data_attribute_11),
        .data_attribute_12(data_attribute_12), .data_cardinal_0(data_cardinal_0),
        .fill_valid(tile_cache_fill_valid), .fill_slot(tile_cache_fill_slot),
        .fill_pixel(tile_cache_fill_pixel), .fill_weight(tile_cache_fill_weight),
        .fill_depth(tile_cache_fill_depth), .fill_peak(tile_cache_fill_peak),
        .fill_attribute_0(tile_cache_fill_attribute_0), .fill_attribute_1(tile_cache_fill_attribute_1),
        .fill_attribute_2(tile_cache_fill_attribute_2), .fill_attribute_3(tile_cache_fill_attribute_3),
        .fill_attribute_4(tile_cache_fill_attribute_4), .fill_attribute_5(tile_cache_fill_attribute_5),
        .fill_attribute_6(tile_cache_fill_attribute_6), .fill_attribute_7(tile_cache_fill_attribute_7),
        .fill_attribute_8(tile_cache_fill_attribute_8), .fill_attribute_9(tile_cache_fill_attribute_9),
        .fill_attribute_10(tile_cache_fill_attribute_10), .fill_attribute_11(tile_cache_fill_attribute_11),
        .fill_attribute_12(tile_cache_fill_attribute_12), .fill_cardinal_0(tile_cache_fill_cardinal_0)
    );

    splat_rasterizer rasterizer (
        .clk(clk), .rst(rst), .in_valid(payloads_out_valid), .in_ready(rasterizer_in_ready),
        .in_center_x(payloads_out_center_x), .in_center_y(payloads_out_center_y), .in_ax(payloads_out_ax),
        .in_bx(payloads_out_bx), .in_ay(payloads_out_ay), .in_by(payloads_out_by),
        .in_delta(payloads_out_delta), .in_mx(payloads_out_mx), .in_my(payloads_out_my),
        .in_sight_negative(payloads_out_sight_negative), .in_sight_near(payloads_out_sight_near),
        .in_sight_far(payloads_out_sight_far), .in_sight_turned(payloads_out_sight_turned),
        .in_sight_disc(payloads_out_sight_disc), .in_depth(payloads_out_depth),
        .in_depth_low(payloads_out_depth_low), .in_depth_high(payloads_out_depth_high),
        .in_attribute_0(payloads_out_attribute_0), .in_attribute_1(payloads_out_attribute_1),
        .in_attribute_2(payloads_out_attribute_2), .in_attribute_3(payloads_out_attribute_3),
        .in_attribute_4(payloads_out_attribute_4), .in_attribute_5(payloads_out_attribute_5),
        .in_attribute_6(payloads_out_attribute_6), .in_attribute_7(payloads_out_attribute_7),
        .in_attribute_8(payloads_out_attribute_8), .in_attribute_9(payloads_out_attribute_9),
        .in_attribute_10(payloads_out_attribute_10), .in_attribute_11(payloads_out_attribute_11),
        .in_attribute_12(payloads_out_attribute_12), .in_cardinal_0(payloads_out_cardinal_0),
        .in_left(payloads_out_left), .in_right(payloads_out_right), .in_top(payloads_out_top),
        .in_bottom(payloads_out_bottom), .in_first_sum(payloads_out_first_sum),
        .in_last_sum(payloads_out_last_sum), .in_first_difference(payloads_out_first_difference),
        .in_last_difference(payloads_out_last_difference), .in_tile(payloads_out_tile),
        .in_slot(payloads_out_slot),
        .out_valid(rasterizer_out_valid), .out_ready(weighting_in_ready), .out_last(rasterizer_out_last),
        .out_inside(rasterizer_out_inside), .out_slot(rasterizer_out_slot), .out_pixel(rasterizer_out_pixel),
        .out_weight(rasterizer_out_weight), .out_depth(rasterizer_out_depth),
        .out_depth_low(rasterizer_out_depth_low), .out_depth_high(rasterizer_out_depth_high),
        .out_attribute_0(rasterizer_out_attribute_0), .out_attribute_1(rasterizer_out_attribute_1),
        .out_attribute_2(rasterizer_out_attribute_2), .out_attribute_3(rasterizer_out_attribute_3),
        .out_attribute_4(rasterizer_out_attribute_4), .out_attribute_5(rasterizer_out_attribute_5),
        .out_attribute_6(rasterizer_out_attribute_6), .out_attribute_7(rasterizer_out_attribute_7),
        .out_attribute_8(rasterizer_out_attribute_8), .out_attribute_9(rasterizer_out_attribute_9),
        .out_attribute_10(rasterizer_out_attribute_10), .out_attribute_11(rasterizer_out_attribute_11),
        .out_attribute_12(rasterizer_out_attribute_12), .out_cardinal_0(rasterizer_out_cardinal_0),
        .filter_scale(filter_scale),
        .event_sample(event_sample), .event_starved(event_starved), .event_blocked(event_blocked)
    );

    splat_weighting weighting (
        .clk(clk), .rst(rst), .in_valid(rasterizer_out_valid), .in_ready(weighting_in_ready),
        .in_last(rasterizer_out_last), .in_inside(rasterizer_out_inside), .in_slot(rasterizer_out_slot),
        .in_pixel(rasterizer_out_pixel), .in_weight(rasterizer_out_weight), .in_depth(rasterizer_out_depth),
        .in_depth_low(rasterizer_out_depth_low), .in_depth_high(rasterizer_out_depth_high),
        .in_attribute_0(rasterizer_out_attribute_0), .in_attribute_1(rasterizer_out_attribute_1),
        .in_attribute_2(rasterizer_out_attribute_2), .in_attribute_3(rasterizer_out_attribute_3),
        .in_attribute_4(rasterizer_out_attribute_4), .in_attribute_5(rasterizer_out_attribute_5),
        .in_attribute_6(rasterizer_out_attribute_6), .in_attribute_7(rasterizer_out_attribute_7),
        .in_attribute_8(rasterizer_out_attribute_8), .in_attribute_9(rasterizer_out_attribute_9),
        .in_attribute_10(rasterizer_out_attribute_10), .in_attribute_11(rasterizer_out_attribute_11),
        .in_attribute_12(rasterizer_out_attribute_12), .in_cardinal_0(rasterizer_out_cardinal_0),
        .out_valid(weighting_out_valid), .out_ready(accumulator_in_ready), .out_last(weighting_out_last),
        .out_inside(weighting_out_inside), .out_slot(weighting_out_slot), .out_pixel(weighting_out_pixel),
        .out_weight(weighting_out_weight), .out_weighted_depth(weighting_out_weighted_depth),
        .out_depth_low(weighting_out_depth_low), .out_depth_high(weighting_out_depth_high),
        .out_attribute_0(weighting_out_attribute_0), .out_attribute_1(weighting_out_attribute_1),
        .out_attribute_2(weighting_out_attribute_2), .out_attribute_3(weighting_out_attribute_3),
        .out_attribute_4(weighting_out_attribute_4), .out_attribute_5(weighting_out_attribute_5),
        .out_attribute_6(weighting_out_attribute_6), .out_attribute_7(weighting_out_attribute_7),
        .out_attribute_8(weighting_out_attribute_8), .out_attribute_9(weighting_out_attribute_9),
        .out_attribute_10(weighting_out_attribute_10), .out_attribute_11(weighting_out_attribute_11),
        .out_attribute_12(weighting_out_attribute_12), .out_cardinal_0(weighting_out_cardinal_0)
    );

    splat_accumulator accumulator (
        .clk(clk), .rst(rst), .in_valid(weighting_out_valid), .in_ready(accumulator_in_ready),
        .in_last(weighting_out_last), .in_inside(weighting_out_inside), .in_slot(weighting_out_slot),
        .in_pixel(weighting_out_pixel), .in_weight(weighting_out_weight),
        .in_weighted_depth(weighting_out_weighted_depth), .in_depth_low(weighting_out_depth_low),
        .in_depth_high(weighting_out_depth_high), .in_attribute_0(weighting_out_attribute_0),
        .in_attribute_1(weighting_out_attribute_1), .in_attribute_2(weighting_out_attribute_2),
        .in_attribute_3(weighting_out_attribute_3), .in_attribute_4(weighting_out_attribute_4),
        .in_attribute_5(weighting_out_attribute_5), .in_attribute_6(weighting_out_attribute_6),
        .in_attribute_7(weighting_out_attribute_7), .in_attribute_8(weighting_out_attribute_8),
        .in_attribute_9(weighting_out_attribute_9), .in_attribute_10(weighting_out_attribute_10),
        .in_attribute_11(weighting_out_attribute_11), .in_attribute_12(weighting_out_attribute_12),
        .in_cardinal_0(weighting_out_cardinal_0),
        .slot_ready(tile_cache_slot_ready),
        .retire_valid(accumulator_retire_valid), .retire_slot(accumulator_retire_slot),
        .change_valid(tile_cache_change_valid), .change_slot(tile_cache_change_slot),
        .change_banks(tile_cache_change_banks), .change_held(tile_cache_change_held),
        .fill_valid(tile_cache_fill_valid), .fill_slot(tile_cache_fill_slot),
        .fill_pixel(tile_cache_fill_pixel), .fill_weight(tile_cache_fill_weight),
        .fill_depth(tile_cache_fill_depth), .fill_peak(tile_cache_fill_peak),
        .fill_attribute_0(tile_cache_fill_attribute_0), .fill_attribute_1(tile_cache_fill_attribute_1),
        .fill_attribute_2(tile_cache_fill_attribute_2), .fill_attribute_3(tile_cache_fill_attribute_3),
        .fill_attribute_4(tile_cache_fill_attribute_4), .fill_attribute_5(tile_cache_fill_attribute_5),
        .fill_attribute_6(tile_cache_fill_attribute_6), .fill_attribute_7(tile_cache_fill_attribute_7),
        .fill_attribute_8(tile_cache_fill_attribute_8), .fill_attribute_9(tile_cache_fill_attribute_9),
        .fill_attribute_10(tile_cache_fill_attribute_10), .fill_attribute_11(tile_cache_fill_attribute_11),
        .fill_attribute_12(tile_cache_fill_attribute_12), .fill_cardinal_0(tile_cache_fill_cardinal_0),
        .drain_enable(tile_cache_drain_enable), .drain_slot(tile_cache_drain_slot),
        .drain_pixel(tile_cache_drain_pixel),
        .sample_reads(accumulator_sample_reads), .sample_writes(accumulator_sample_writes),
        .masks_written(accumulator_masks_written), .masks_dirty(accumulator_masks_dirty),
        .drained_valid(accumulator_drained_valid), .drained_pixel(accumulator_drained_pixel),
        .drained_weight(accumulator_drained_weight), .drained_depth(accumulator_drained_depth),
        .drained_peak(accumulator_drained_peak), .drained_attribute_0(accumulator_drained_attribute_0),
        .drained_attribute_1(accumulator_drained_attribute_1),
        .drained_attribute_2(accumulator_drained_attribute_2),
        .drained_attribute_3(accumulator_drained_attribute_3),
        .drained_attribute_4(accumulator_drained_attribute_4),
        .drained_attribute_5(accumulator_drained_attribute_5),
        .drained_attribute_6(accumulator_drained_attribute_6),
        .drained_attribute_7(accumulator_drained_attribute_7),
        .drained_attribute_8(accumulator_drained_attribute_8),
        .drained_attribute_9(accumulator_drained_attribute_9),
        .drained_attribute_10(accumulator_drained_attribute_10),
        .drained_attribute_11(accumulator_drained_attribute_11),
        .drained_attribute_12(accumulator_drained_attribute_12),
        .drained_cardinal_0(accumulator_drained_cardinal_0),
        .event_accumulate(event_accumulate), .event_hazard(event_hazard), .event_slot_wait(event_slot_wait)
    );
endmodule

// Blends samples into the pixels of the tile slots.
// slots = 8
// banks = 2
// stages = 7
module splat_accumulator (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready,  // Samples with their contributions.
    input  wire in_last,  // Closes its copy.
    input  wire in_inside,  // Lies inside the splat; one outside is passed on only to say so.
    input  wire [2:0] in_slot,  // Slot of the tile cache.
    input  wire [5:0] in_pixel,  // Pixel of the tile: row above column.
    input  wire [15:0] in_weight,  // Kernel weight.
    input  wire [39:0] in_weighted_depth,  // Weighted depth.
    input  wire [23:0] in_depth_low,  // Near end of the depth band.
    input  wire [23:0] in_depth_high,  // Far end of the depth band.
    input  wire [15:0] in_attribute_0,  // Weighted continuous attributes, and cardinal ones as they are.
    input  wire [15:0] in_attribute_1,  // Weighted continuous attributes, and cardinal ones as they are.
    input  wire [15:0] in_attribute_2,  // Weighted continuous attributes, and cardinal ones as they are.
    input  wire [15:0] in_attribute_3,  // Weighted continuous attributes, and cardinal ones as they are.
    input  wire [15:0] in_attribute_4,  // Weighted continuous attributes, and cardinal ones as they are.
    input  wire [15:0] in_attribute_5,  // Weighted continuous attributes, and cardinal ones as they are.
    input  wire [15:0] in_attribute_6,  // Weighted continuous attributes, and cardinal ones as they are.
    input  wire [15:0] in_attribute_7,  // Weighted continuous attributes, and cardinal ones as they are.
    input  wire [15:0] in_attribute_8,  // Weighted continuous attributes, and cardinal ones as they are.
    input  wire [15:0] in_attribute_9,  // Weighted continuous attributes, and cardinal ones as they are.
    input  wire [15:0] in_attribute_10,  // Weighted continuous attributes, and cardinal ones as they are.
    input  wire [15:0] in_attribute_11,  // Weighted continuous attributes, and cardinal ones as they are.
    input  wire [15:0] in_attribute_12,  // Weighted continuous attributes, and cardinal ones as they are.
    input  wire [15:0] in_cardinal_0,  // Weighted continuous attributes, and cardinal ones as they are.
    input  wire [7:0] slot_ready,  // A bit for each slot that may be accumulated into.
    output reg  retire_valid,  // A copy is done with.
    output reg  [2:0] retire_slot,  // Slot of the tile cache.
    input  wire change_valid,  // A slot gets another tile, until that is carried out in every bank.
    input  wire [2:0] change_slot,  // Slot of the tile cache.
    input  wire [1:0] change_banks,  // A bit for each bank in which that is to be carried out.
    input  wire [63:0] change_held,  // A bit for each pixel that will be filled.
    input  wire fill_valid,  // Write to a slot, until it is carried out.
    input  wire [2:0] fill_slot,  // Slot of the tile cache.
    input  wire [5:0] fill_pixel,  // Pixel of the tile.
    input  wire [27:0] fill_weight,  // Sum of weights.
    input  wire [51:0] fill_depth,  // Sum of weighted depths.
    input  wire [15:0] fill_peak,  // The largest single weight, with cardinal attributes only.
    input  wire [15:0] fill_attribute_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] fill_attribute_1,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] fill_attribute_2,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] fill_attribute_3,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] fill_attribute_4,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] fill_attribute_5,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] fill_attribute_6,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] fill_attribute_7,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] fill_attribute_8,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] fill_attribute_9,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] fill_attribute_10,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] fill_attribute_11,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] fill_attribute_12,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] fill_cardinal_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire drain_enable,  // Read of a slot, until it is carried out.
    input  wire [2:0] drain_slot,  // Slot of the tile cache.
    input  wire [5:0] drain_pixel,  // Pixel of the tile.
    output wire [1:0] sample_reads,  // A bit for each bank that a sample may read: no drain and no change of it is carried out.
    output wire [1:0] sample_writes,  // A bit for each bank that a sample may write in the next cycle: no fill of it is carried out then.
    output wire [63:0] masks_written,  // A bit for each pixel that was filled or that a sample came to.
    output wire [63:0] masks_dirty,  // A bit for each pixel that a sample came to.
    output wire drained_valid,  // A pixel that was read.
    output wire [5:0] drained_pixel,  // Pixel of the tile.
    output wire [27:0] drained_weight,  // Sum of weights.
    output wire [51:0] drained_depth,  // Sum of weighted depths.
    output wire [15:0] drained_peak,  // The largest single weight, with cardinal attributes only.
    output wire [15:0] drained_attribute_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] drained_attribute_1,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] drained_attribute_2,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] drained_attribute_3,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] drained_attribute_4,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] drained_attribute_5,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] drained_attribute_6,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] drained_attribute_7,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] drained_attribute_8,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] drained_attribute_9,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] drained_attribute_10,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] drained_attribute_11,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] drained_attribute_12,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] drained_cardinal_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output reg  event_accumulate,  // The accumulator took a sample.
    output reg  event_hazard,  // The accumulator waited for an earlier sample of the same pixel.
    output reg  event_slot_wait  // The accumulator waited for its tile to arrive in the cache.
);
    (* ram_style = "distributed" *)
    reg [63:0] bank_0_masks [0:7];
    (* ram_style = "distributed" *)
    reg [63:0] bank_1_masks [0:7];
    reg valid_1, inside_1, last_1;
    reg [2:0] slot_1;
    reg [5:0] pixel_1;
    reg valid_2, inside_2, last_2;
    reg [2:0] slot_2;
    reg [5:0] pixel_2;
    reg valid_3, inside_3, last_3;
    reg [2:0] slot_3;
    reg [5:0] pixel_3;
    reg valid_4, inside_4, last_4;
    reg [2:0] slot_4;
    reg [5:0] pixel_4;
    reg valid_5, inside_5, last_5;
    reg [2:0] slot_5;
    reg [5:0] pixel_5;
    reg valid_6, inside_6, last_6;
    reg [2:0] slot_6;
    reg [5:0] pixel_6;
    reg valid_7, inside_7, last_7;
    reg [2:0] slot_7;
    reg [5:0] pixel_7;
    reg valid_8, inside_8, last_8;
    reg [2:0] slot_8;
    reg [5:0] pixel_8;
    reg head_valid;
    reg head_last;  // Closes its copy.
    reg head_inside;  // Lies inside the splat.
    reg [2:0] head_slot;  // Slot of the tile cache.
    reg [5:0] head_pixel;  // Pixel of the tile.
    reg [15:0] head_weight;  // Kernel weight.
    reg [39:0] head_weighted_depth;  // Weighted depth.
    reg [23:0] head_depth_low;  // Near end of the depth band.
    reg [23:0] head_depth_high;  // Far end of the depth band.
    reg [15:0] head_attribute_0;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] head_attribute_1;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] head_attribute_2;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] head_attribute_3;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] head_attribute_4;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] head_attribute_5;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] head_attribute_6;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] head_attribute_7;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] head_attribute_8;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] head_attribute_9;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] head_attribute_10;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] head_attribute_11;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] head_attribute_12;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] head_cardinal_0;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [7:0] collisions;
    reg on_the_way, arrived;
    reg [31:0] bank_0_was_written, bank_0_was_dirty;
    reg [3:0] bank_0_was_near;
    reg [31:0] bank_1_was_written, bank_1_was_dirty;
    reg [3:0] bank_1_was_near;
    reg [1:0] near_place;
    reg near_bank, is_written;
    wire [319:0] bank_0_read;
    reg [319:0] bank_0_pixel;
    wire [319:0] bank_1_read;
    reg [319:0] bank_1_pixel;
    reg drains_1;
    reg [5:0] drained_pixel_1;
    reg drains_2;
    reg [5:0] drained_pixel_2;
    reg [319:0] stored;
    reg [15:0] sample_1_weight;  // Kernel weight.
    reg [39:0] sample_1_weighted_depth;  // Weighted depth.
    reg [23:0] sample_1_depth_low;  // Near end of the depth band.
    reg [23:0] sample_1_depth_high;  // Far end of the depth band.
    reg [15:0] sample_1_attribute_0;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] sample_1_attribute_1;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] sample_1_attribute_2;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] sample_1_attribute_3;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] sample_1_attribute_4;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] sample_1_attribute_5;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] sample_1_attribute_6;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] sample_1_attribute_7;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] sample_1_attribute_8;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] sample_1_attribute_9;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] sample_1_attribute_10;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] sample_1_attribute_11;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] sample_1_attribute_12;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] sample_1_cardinal_0;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] sample_2_weight;  // Kernel weight.
    reg [39:0] sample_2_weighted_depth;  // Weighted depth.
    reg [23:0] sample_2_depth_low;  // Near end of the depth band.
    reg [23:0] sample_2_depth_high;  // Far end of the depth band.
    reg [15:0] sample_2_attribute_0;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] sample_2_attribute_1;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] sample_2_attribute_2;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] sample_2_attribute_3;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] sample_2_attribute_4;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] sample_2_attribute_5;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] sample_2_attribute_6;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] sample_2_attribute_7;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] sample_2_attribute_8;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] sample_2_attribute_9;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] sample_2_attribute_10;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] sample_2_attribute_11;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] sample_2_attribute_12;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] sample_2_cardinal_0;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] sample_3_weight;  // Kernel weight.
    reg [39:0] sample_3_weighted_depth;  // Weighted depth.
    reg [23:0] sample_3_depth_low;  // Near end of the depth band.
    reg [23:0] sample_3_depth_high;  // Far end of the depth band.
    reg [15:0] sample_3_attribute_0;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] sample_3_attribute_1;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] sample_3_attribute_2;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] sample_3_attribute_3;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] sample_3_attribute_4;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] sample_3_attribute_5;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] sample_3_attribute_6;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] sample_3_attribute_7;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] sample_3_attribute_8;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] sample_3_attribute_9;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] sample_3_attribute_10;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] sample_3_attribute_11;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] sample_3_attribute_12;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] sample_3_cardinal_0;  // Weighted continuous attributes, and cardinal ones as they are.
    reg late_fail_4, late_fail_5, late_pass_4, late_pass_5;
    reg [28:0] weight_sum_4, weight_sum_5, weight_sum_6, weight_sum_7, weight_sum_8;
    reg [15:0] weight_4, weight_5, weight_6, weight_7, weight_8;
    reg [51:0] depth_sum_4, depth_sum_5, depth_sum_6, depth_sum_7, depth_sum_8;
    reg [39:0] depth_4, depth_5, depth_6, depth_7, depth_8;
    reg stronger_4, stronger_5, stronger_6, stronger_7, stronger_8;
    reg [15:0] peak_4, peak_5, peak_6, peak_7, peak_8, attribute_0_4, attribute_0_5, attribute_0_6, attribute_0_7;
    reg [15:0] attribute_0_8, attribute_1_4, attribute_1_5, attribute_1_6, attribute_1_7, attribute_1_8;
    reg [15:0] attribute_2_4, attribute_2_5, attribute_2_6, attribute_2_7, attribute_2_8, attribute_3_4;
    reg [15:0] attribute_3_5, attribute_3_6, attribute_3_7, attribute_3_8, attribute_4_4, attribute_4_5;
    reg [15:0] attribute_4_6, attribute_4_7, attribute_4_8, attribute_5_4, attribute_5_5, attribute_5_6;
    reg [15:0] attribute_5_7, attribute_5_8, attribute_6_4, attribute_6_5, attribute_6_6, attribute_6_7;
    reg [15:0] attribute_6_8, attribute_7_4, attribute_7_5, attribute_7_6, attribute_7_7, attribute_7_8;
    reg [15:0] attribute_8_4, attribute_8_5, attribute_8_6, attribute_8_7, attribute_8_8, attribute_9_4;
    reg [15:0] attribute_9_5, attribute_9_6, attribute_9_7, attribute_9_8, attribute_10_4, attribute_10_5;
    reg [15:0] attribute_10_6, attribute_10_7, attribute_10_8, attribute_11_4, attribute_11_5, attribute_11_6;
    reg [15:0] attribute_11_7, attribute_11_8, attribute_12_4, attribute_12_5, attribute_12_6, attribute_12_7;
    reg [15:0] attribute_12_8, cardinal_0_4, cardinal_0_5, cardinal_0_6, cardinal_0_7, cardinal_0_8;
    reg [15:0] stored_cardinal_0_4, stored_cardinal_0_5, stored_cardinal_0_6, stored_cardinal_0_7;
    reg [15:0] stored_cardinal_0_8;

    wire places_out_valid;
    wire [10:0] places_out_data;
    wire samples_in_ready, samples_out_valid;
    wire [327:0] samples_out_data;
    wire depth_test_fail, depth_test_pass;
    wire [15:0] add_attribute_0_y, add_attribute_1_y, add_attribute_2_y, add_attribute_3_y, add_attribute_4_y;
    wire [15:0] add_attribute_5_y, add_attribute_6_y, add_attribute_7_y, add_attribute_8_y, add_attribute_9_y;
    wire [15:0] add_attribute_10_y, add_attribute_11_y, add_attribute_12_y;

    wire may_issue_inside = head_valid & head_inside;
    wire reads = may_issue_inside & arrived;
    wire sample_reads_1 = reads & head_pixel[0];
    wire sample_reads_0 = reads & ~head_pixel[0];
    wire [1:0] reads_bank = {sample_reads_1, sample_reads_0};
    wire [1:0] will_write_bank = {inside_7 & pixel_7[0], inside_7 & ~pixel_7[0]};
    wire [319:0] drained_word = drained_pixel_2[0] ? bank_1_pixel : bank_0_pixel;
    wire sample_ends_in_0 = inside_8 & ~pixel_8[0];
    wire changes = ~late_fail_5 & (late_pass_5 | ~weight_sum_8[28]);
    wire writes_0 = sample_ends_in_0 ? changes : (fill_valid & ~fill_pixel[0]);
    wire [7:0] bank_1_pixels_address_bits = {slot_8, pixel_8[5:1]};
    wire [7:0] bank_1_pixels_address_bits_2 = {fill_slot, fill_pixel[5:1]};
    wire selected = late_pass_5 | stronger_8;
    wire overflow_of_attribute_0 = &add_attribute_0_y[14:10];
    wire [15:0] result_bits = {add_attribute_0_y[15], overflow_of_attribute_0 ? 15'h7bff : add_attribute_0_y[14:0]};
    wire overflow_of_attribute_1 = &add_attribute_1_y[14:10];
    wire [15:0] result_bits_2 = {add_attribute_1_y[15], overflow_of_attribute_1 ? 15'h7bff : add_attribute_1_y[14:0]};
    wire overflow_of_attribute_2 = &add_attribute_2_y[14:10];
    wire [15:0] result_bits_3 = {add_attribute_2_y[15], overflow_of_attribute_2 ? 15'h7bff : add_attribute_2_y[14:0]};
    wire overflow_of_attribute_3 = &add_attribute_3_y[14:10];
    wire [15:0] result_bits_4 = {add_attribute_3_y[15], overflow_of_attribute_3 ? 15'h7bff : add_attribute_3_y[14:0]};
    wire overflow_of_attribute_4 = &add_attribute_4_y[14:10];
    wire [15:0] result_bits_5 = {add_attribute_4_y[15], overflow_of_attribute_4 ? 15'h7bff : add_attribute_4_y[14:0]};
    wire overflow_of_attribute_5 = &add_attribute_5_y[14:10];
    wire [15:0] result_bits_6 = {add_attribute_5_y[15], overflow_of_attribute_5 ? 15'h7bff : add_attribute_5_y[14:0]};
    wire overflow_of_attribute_6 = &add_attribute_6_y[14:10];
    wire [15:0] result_bits_7 = {add_attribute_6_y[15], overflow_of_attribute_6 ? 15'h7bff : add_attribute_6_y[14:0]};
    wire overflow_of_attribute_7 = &add_attribute_7_y[14:10];
    wire [15:0] result_bits_8 = {add_attribute_7_y[15], overflow_of_attribute_7 ? 15'h7bff : add_attribute_7_y[14:0]};
    wire overflow_of_attribute_8 = &add_attribute_8_y[14:10];
    wire [15:0] result_bits_9 = {add_attribute_8_y[15], overflow_of_attribute_8 ? 15'h7bff : add_attribute_8_y[14:0]};
    wire overflow_of_attribute_9 = &add_attribute_9_y[14:10];
    wire [15:0] result_bits_10 = {add_attribute_9_y[15], overflow_of_attribute_9 ? 15'h7bff : add_attribute_9_y[14:0]};
    wire overflow_of_attribute_10 = &add_attribute_10_y[14:10];
    wire [15:0] result_bits_11 = {add_attribute_10_y[15], overflow_of_attribute_10 ? 15'h7bff : add_attribute_10_y[14:0]};
    wire overflow_of_attribute_11 = &add_attribute_11_y[14:10];
    wire [15:0] result_bits_12 = {add_attribute_11_y[15], overflow_of_attribute_11 ? 15'h7bff : add_attribute_11_y[14:0]};
    wire overflow_of_attribute_12 = &add_attribute_12_y[14:10];
    wire [15:0] result_bits_13 = {add_attribute_12_y[15], overflow_of_attribute_12 ? 15'h7bff : add_attribute_12_y[14:0]};
    wire [319:0] result = {
        late_pass_5 ? {12'd0, weight_8} : weight_sum_8[27:0], late_pass_5 ? {12'd0, depth_8} : depth_sum_8,
        selected ? weight_8 : peak_8, late_pass_5 ? attribute_0_8 : result_bits,
        late_pass_5 ? attribute_1_8 : result_bits_2, late_pass_5 ? attribute_2_8 : result_bits_3,
        late_pass_5 ? attribute_3_8 : result_bits_4, late_pass_5 ? attribute_4_8 : result_bits_5,
        late_pass_5 ? attribute_5_8 : result_bits_6, late_pass_5 ? attribute_6_8 : result_bits_7,
        late_pass_5 ? attribute_7_8 : result_bits_8, late_pass_5 ? attribute_8_8 : result_bits_9,
        late_pass_5 ? attribute_9_8 : result_bits_10, late_pass_5 ? attribute_10_8 : result_bits_11,
        late_pass_5 ? attribute_11_8 : result_bits_12, late_pass_5 ? attribute_12_8 : result_bits_13,
        selected ? cardinal_0_8 : stored_cardinal_0_8
    };
    wire [319:0] bank_1_pixels_data_bits = {
        fill_weight, fill_depth, fill_peak, fill_attribute_0, fill_attribute_1, fill_attribute_2,
        fill_attribute_3, fill_attribute_4, fill_attribute_5, fill_attribute_6, fill_attribute_7,
        fill_attribute_8, fill_attribute_9, fill_attribute_10, fill_attribute_11, fill_attribute_12,
        fill_cardinal_0
    };
    wire [7:0] bank_1_read_address_bits = {head_slot, head_pixel[5:1]};
    wire [7:0] bank_1_read_address_bits_2 = {drain_slot, drain_pixel[5:1]};
    wire sample_ends_in_1 = inside_8 & pixel_8[0];
    wire writes_1 = sample_ends_in_1 ? changes : (fill_valid & fill_pixel[0]);
    wire slot_wait = may_issue_inside & ~arrived;
    wire hazard = may_issue_inside & (arrived & on_the_way);
    wire issue = head_valid & ~(slot_wait | hazard);
    wire head_takes = ~head_valid | issue;
    wire issue_inside = may_issue_inside & (arrived & ~on_the_way);
    wire places_out_last = places_out_data[10];
    wire places_out_inside = places_out_data[9];
    wire [2:0] places_out_slot = places_out_data[8:6];
    wire [5:0] places_out_pixel = places_out_data[5:0];
    wire [15:0] samples_out_weight = samples_out_data[327:312];
    wire [39:0] samples_out_weighted_depth = samples_out_data[311:272];
    wire [23:0] samples_out_depth_low = samples_out_data[271:248];
    wire [23:0] samples_out_depth_high = samples_out_data[247:224];
    wire [15:0] samples_out_attribute_0 = samples_out_data[223:208];
    wire [15:0] samples_out_attribute_1 = samples_out_data[207:192];
    wire [15:0] samples_out_attribute_2 = samples_out_data[191:176];
    wire [15:0] samples_out_attribute_3 = samples_out_data[175:160];
    wire [15:0] samples_out_attribute_4 = samples_out_data[159:144];
    wire [15:0] samples_out_attribute_5 = samples_out_data[143:128];
    wire [15:0] samples_out_attribute_6 = samples_out_data[127:112];
    wire [15:0] samples_out_attribute_7 = samples_out_data[111:96];
    wire [15:0] samples_out_attribute_8 = samples_out_data[95:80];
    wire [15:0] samples_out_attribute_9 = samples_out_data[79:64];
    wire [15:0] samples_out_attribute_10 = samples_out_data[63:48];
    wire [15:0] samples_out_attribute_11 = samples_out_data[47:32];
    wire [15:0] samples_out_attribute_12 = samples_out_data[31:16];
    wire [15:0] samples_out_cardinal_0 = samples_out_data[15:0];
    wire collisions_both = may_issue_inside & (places_out_data[8:0] == {head_slot, head_pixel});
    wire [7:0] collisions_bits = {
        inside_7 & (places_out_data[8:0] == {slot_7, pixel_7}),
        inside_6 & (places_out_data[8:0] == {slot_6, pixel_6}),
        inside_5 & (places_out_data[8:0] == {slot_5, pixel_5}),
        inside_4 & (places_out_data[8:0] == {slot_4, pixel_4}),
        inside_3 & (places_out_data[8:0] == {slot_3, pixel_3}),
        inside_2 & (places_out_data[8:0] == {slot_2, pixel_2}),
        inside_1 & (places_out_data[8:0] == {slot_1, pixel_1}), collisions_both
    };
    wire [7:0] collisions_shifted_by_1 = collisions << 1;
    wire [7:0] arrived_shifted = slot_ready >> places_out_slot;
    wire [7:0] arrived_shifted_2 = slot_ready >> head_slot;
    wire changes_0 = change_valid & change_banks[0] & ~sample_reads_0;
    wire [2:0] masked_slot_0 = sample_reads_0 ? head_slot : change_slot;
    wire [63:0] bank_0_mask = bank_0_masks[masked_slot_0];
    wire [4:0] bank_1_near_bits = {head_pixel[5:3], 2'd0};
    wire [31:0] bank_0_near_shifted = bank_0_mask[63:32] >> bank_1_near_bits;
    wire [3:0] bank_0_near = bank_0_near_shifted[3:0];
    wire changes_1 = change_valid & change_banks[1] & ~sample_reads_1;
    wire [2:0] masked_slot_1 = sample_reads_1 ? head_slot : change_slot;
    wire [63:0] bank_1_mask = bank_1_masks[masked_slot_1];
    wire [31:0] bank_1_near_shifted = bank_1_mask[63:32] >> bank_1_near_bits;
    wire [3:0] bank_1_near = bank_1_near_shifted[3:0];
    wire [3:0] is_written_shifted = bank_1_was_near >> near_place;
    wire [3:0] is_written_shifted_2 = bank_0_was_near >> near_place;
    wire drains_1_either = (~drain_pixel[0] & reads_bank[0]) | (drain_pixel[0] & reads_bank[1]);
    wire [31:0] pixel_bit = 32'd1 << head_pixel[5:1];
    wire [63:0] bank_0_masks_data_bits = {
        change_held[62], change_held[60], change_held[58], change_held[56], change_held[54], change_held[52],
        change_held[50], change_held[48], change_held[46], change_held[44], change_held[42], change_held[40],
        change_held[38], change_held[36], change_held[34], change_held[32], change_held[30], change_held[28],
        change_held[26], change_held[24], change_held[22], change_held[20], change_held[18], change_held[16],
        change_held[14], change_held[12], change_held[10], change_held[8], change_held[6], change_held[4],
        change_held[2], change_held[0], 32'd0
    };
    wire [63:0] bank_1_masks_data_bits = {
        change_held[63], change_held[61], change_held[59], change_held[57], change_held[55], change_held[53],
        change_held[51], change_held[49], change_held[47], change_held[45], change_held[43], change_held[41],
        change_held[39], change_held[37], change_held[35], change_held[33], change_held[31], change_held[29],
        change_held[27], change_held[25], change_held[23], change_held[21], change_held[19], change_held[17],
        change_held[15], change_held[13], change_held[11], change_held[9], change_held[7], change_held[5],
        change_held[3], change_held[1], 32'd0
    };

    assign sample_reads = reads_bank;
    assign sample_writes = will_write_bank;
    assign masks_written = {
        bank_1_was_written[31], bank_0_was_written[31], bank_1_was_written[30], bank_0_was_written[30],
        bank_1_was_written[29], bank_0_was_written[29], bank_1_was_written[28], bank_0_was_written[28],
        bank_1_was_written[27], bank_0_was_written[27], bank_1_was_written[26], bank_0_was_written[26],
        bank_1_was_written[25], bank_0_was_written[25], bank_1_was_written[24], bank_0_was_written[24],
        bank_1_was_written[23], bank_0_was_written[23], bank_1_was_written[22], bank_0_was_written[22],
        bank_1_was_written[21], bank_0_was_written[21], bank_1_was_written[20], bank_0_was_written[20],
        bank_1_was_written[19], bank_0_was_written[19], bank_1_was_written[18], bank_0_was_written[18],
        bank_1_was_written[17], bank_0_was_written[17], bank_1_was_written[16], bank_0_was_written[16],
        bank_1_was_written[15], bank_0_was_written[15], bank_1_was_written[14], bank_0_was_written[14],
        bank_1_was_written[13], bank_0_was_written[13], bank_1_was_written[12], bank_0_was_written[12],
        bank_1_was_written[11], bank_0_was_written[11], bank_1_was_written[10], bank_0_was_written[10],
        bank_1_was_written[9], bank_0_was_written[9], bank_1_was_written[8], bank_0_was_written[8],
        bank_1_was_written[7], bank_0_was_written[7], bank_1_was_written[6], bank_0_was_written[6],
        bank_1_was_written[5], bank_0_was_written[5], bank_1_was_written[4], bank_0_was_written[4],
        bank_1_was_written[3], bank_0_was_written[3], bank_1_was_written[2], bank_0_was_written[2],
        bank_1_was_written[1], bank_0_was_written[1], bank_1_was_written[0], bank_0_was_written[0]
    };
    assign masks_dirty = {
        bank_1_was_dirty[31], bank_0_was_dirty[31], bank_1_was_dirty[30], bank_0_was_dirty[30],
        bank_1_was_dirty[29], bank_0_was_dirty[29], bank_1_was_dirty[28], bank_0_was_dirty[28],
        bank_1_was_dirty[27], bank_0_was_dirty[27], bank_1_was_dirty[26], bank_0_was_dirty[26],
        bank_1_was_dirty[25], bank_0_was_dirty[25], bank_1_was_dirty[24], bank_0_was_dirty[24],
        bank_1_was_dirty[23], bank_0_was_dirty[23], bank_1_was_dirty[22], bank_0_was_dirty[22],
        bank_1_was_dirty[21], bank_0_was_dirty[21], bank_1_was_dirty[20], bank_0_was_dirty[20],
        bank_1_was_dirty[19], bank_0_was_dirty[19], bank_1_was_dirty[18], bank_0_was_dirty[18],
        bank_1_was_dirty[17], bank_0_was_dirty[17], bank_1_was_dirty[16], bank_0_was_dirty[16],
        bank_1_was_dirty[15], bank_0_was_dirty[15], bank_1_was_dirty[14], bank_0_was_dirty[14],
        bank_1_was_dirty[13], bank_0_was_dirty[13], bank_1_was_dirty[12], bank_0_was_dirty[12],
        bank_1_was_dirty[11], bank_0_was_dirty[11], bank_1_was_dirty[10], bank_0_was_dirty[10],
        bank_1_was_dirty[9], bank_0_was_dirty[9], bank_1_was_dirty[8], bank_0_was_dirty[8],
        bank_1_was_dirty[7], bank_0_was_dirty[7], bank_1_was_dirty[6], bank_0_was_dirty[6],
        bank_1_was_dirty[5], bank_0_was_dirty[5], bank_1_was_dirty[4], bank_0_was_dirty[4],
        bank_1_was_dirty[3], bank_0_was_dirty[3], bank_1_was_dirty[2], bank_0_was_dirty[2],
        bank_1_was_dirty[1], bank_0_was_dirty[1], bank_1_was_dirty[0], bank_0_was_dirty[0]
    };
    assign drained_valid = drains_2;
    assign drained_pixel = drained_pixel_2;
    assign {
        drained_weight, drained_depth, drained_peak, drained_attribute_0, drained_attribute_1,
        drained_attribute_2, drained_attribute_3, drained_attribute_4, drained_attribute_5,
        drained_attribute_6, drained_attribute_7, drained_attribute_8, drained_attribute_9,
        drained_attribute_10, drained_attribute_11, drained_attribute_12, drained_cardinal_0
    } = drained_word;

    memory_1w1r_unordered #(.WIDTH(320), .DEPTH(256)) bank_0_pixels (
        .clk(clk), .write(writes_0),
        .write_address(sample_ends_in_0 ? bank_1_pixels_address_bits : bank_1_pixels_address_bits_2),
        .write_data(sample_ends_in_0 ? result : bank_1_pixels_data_bits),
        .read(sample_reads_0 | (drain_enable & ~drain_pixel[0])),
        .read_address(sample_reads_0 ? bank_1_read_address_bits : bank_1_read_address_bits_2),
        .read_data(bank_0_read)
    );

    memory_1w1r_unordered #(.WIDTH(320), .DEPTH(256)) bank_1_pixels (
        .clk(clk), .write(writes_1),
        .write_address(sample_ends_in_1 ? bank_1_pixels_address_bits : bank_1_pixels_address_bits_2),
        .write_data(sample_ends_in_1 ? result : bank_1_pixels_data_bits),
        .read(sample_reads_1 | (drain_enable & drain_pixel[0])),
        .read_address(sample_reads_1 ? bank_1_read_address_bits : bank_1_read_address_bits_2),
        .read_data(bank_1_read)
    );

    stream_fifo_d64_w11_distributed places (
        .clk(clk), .rst(rst), .in_valid(in_valid), .in_ready(in_ready),
        .in_data({in_last, in_inside, in_slot, in_pixel}),
        .out_valid(places_out_valid), .out_ready(head_takes), .out_data(places_out_data)
    );

    stream_fifo_d64_w328 samples (
        .clk(clk), .rst(rst), .in_valid(in_valid), .in_ready(samples_in_ready),
        .in_data({
            in_weight, in_weighted_depth, in_depth_low, in_depth_high, in_attribute_0, in_attribute_1,
            in_attribute_2, in_attribute_3, in_attribute_4, in_attribute_5, in_attribute_6, in_attribute_7,
            in_attribute_8, in_attribute_9, in_attribute_10, in_attribute_11, in_attribute_12, in_cardinal_0
        }),
        .out_valid(samples_out_valid), .out_ready(head_takes), .out_data(samples_out_data)
    );

    splat_depth_test depth_test (
        .clk(clk), .rst(rst), .weight(stored[319:292]), .depth(stored[291:240]),
        .depth_low(sample_3_depth_low), .depth_high(sample_3_depth_high),
        .fail(depth_test_fail), .pass(depth_test_pass)
    );

    float_add_s5_f16 add_attribute_0 (
        .clk(clk), .enable(1'd1), .a(stored[223:208]), .b(sample_3_attribute_0), .y(add_attribute_0_y)
    );

    float_add_s5_f16 add_attribute_1 (
        .clk(clk), .enable(1'd1), .a(stored[207:192]), .b(sample_3_attribute_1), .y(add_attribute_1_y)
    );

    float_add_s5_f16 add_attribute_2 (
        .clk(clk), .enable(1'd1), .a(stored[191:176]), .b(sample_3_attribute_2), .y(add_attribute_2_y)
    );

    float_add_s5_f16 add_attribute_3 (
        .clk(clk), .enable(1'd1), .a(stored[175:160]), .b(sample_3_attribute_3), .y(add_attribute_3_y)
    );

    float_add_s5_f16 add_attribute_4 (
        .clk(clk), .enable(1'd1), .a(stored[159:144]), .b(sample_3_attribute_4), .y(add_attribute_4_y)
    );

    float_add_s5_f16 add_attribute_5 (
        .clk(clk), .enable(1'd1), .a(stored[143:128]), .b(sample_3_attribute_5), .y(add_attribute_5_y)
    );

    float_add_s5_f16 add_attribute_6 (
        .clk(clk), .enable(1'd1), .a(stored[127:112]), .b(sample_3_attribute_6), .y(add_attribute_6_y)
    );

    float_add_s5_f16 add_attribute_7 (
        .clk(clk), .enable(1'd1), .a(stored[111:96]), .b(sample_3_attribute_7), .y(add_attribute_7_y)
    );

    float_add_s5_f16 add_attribute_8 (
        .clk(clk), .enable(1'd1), .a(stored[95:80]), .b(sample_3_attribute_8), .y(add_attribute_8_y)
    );

    float_add_s5_f16 add_attribute_9 (
        .clk(clk), .enable(1'd1), .a(stored[79:64]), .b(sample_3_attribute_9), .y(add_attribute_9_y)
    );

    float_add_s5_f16 add_attribute_10 (
        .clk(clk), .enable(1'd1), .a(stored[63:48]), .b(sample_3_attribute_10), .y(add_attribute_10_y)
    );

    float_add_s5_f16 add_attribute_11 (
        .clk(clk), .enable(1'd1), .a(stored[47:32]), .b(sample_3_attribute_11), .y(add_attribute_11_y)
    );

    float_add_s5_f16 add_attribute_12 (
        .clk(clk), .enable(1'd1), .a(stored[31:16]), .b(sample_3_attribute_12), .y(add_attribute_12_y)
    );

    always @(posedge clk) begin
        if (rst) begin
            retire_valid <= 1'd0;
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
            drains_1 <= 1'd0;
            drains_2 <= 1'd0;
            event_accumulate <= 1'd0;
            event_hazard <= 1'd0;
            event_slot_wait <= 1'd0;
        end else begin
            retire_valid <= valid_8 & last_8;
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
            drains_1 <= drain_enable & ~drains_1_either;
            drains_2 <= drains_1;
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
        collisions <= head_takes ? collisions_bits : collisions_shifted_by_1;
        on_the_way <= head_takes ? |collisions_bits : |collisions_shifted_by_1;
        arrived <= head_takes ? arrived_shifted[0] : arrived_shifted_2[0];
        bank_0_was_near <= bank_0_near;
        bank_1_was_near <= bank_1_near;
        near_place <= head_pixel[2:1];
        near_bank <= head_pixel[0];
        is_written <= near_bank ? is_written_shifted[0] : is_written_shifted_2[0];
        bank_0_pixel <= bank_0_read;
        bank_1_pixel <= bank_1_read;
        drained_pixel_1 <= drain_pixel;
        drained_pixel_2 <= drained_pixel_1;
        stored <= {320{is_written}} & (pixel_2[0] ? bank_1_pixel : bank_0_pixel);
        sample_1_weight <= head_weight;
        sample_1_weighted_depth <= head_weighted_depth;
        sample_1_depth_low <= head_depth_low;
        sample_1_depth_high <= head_depth_high;
        sample_1_attribute_0 <= head_attribute_0;
        sample_1_attribute_1 <= head_attribute_1;
        sample_1_attribute_2 <= head_attribute_2;
        sample_1_attribute_3 <= head_attribute_3;
        sample_1_attribute_4 <= head_attribute_4;
        sample_1_attribute_5 <= head_attribute_5;
        sample_1_attribute_6 <= head_attribute_6;
        sample_1_attribute_7 <= head_attribute_7;
        sample_1_attribute_8 <= head_attribute_8;
        sample_1_attribute_9 <= head_attribute_9;
        sample_1_attribute_10 <= head_attribute_10;
        sample_1_attribute_11 <= head_attribute_11;
        sample_1_attribute_12 <= head_attribute_12;
        sample_1_cardinal_0 <= head_cardinal_0;
        sample_2_weight <= sample_1_weight;
        sample_2_weighted_depth <= sample_1_weighted_depth;
        sample_2_depth_low <= sample_1_depth_low;
        sample_2_depth_high <= sample_1_depth_high;
        sample_2_attribute_0 <= sample_1_attribute_0;
        sample_2_attribute_1 <= sample_1_attribute_1;
        sample_2_attribute_2 <= sample_1_attribute_2;
        sample_2_attribute_3 <= sample_1_attribute_3;
        sample_2_attribute_4 <= sample_1_attribute_4;
        sample_2_attribute_5 <= sample_1_attribute_5;
        sample_2_attribute_6 <= sample_1_attribute_6;
        sample_2_attribute_7 <= sample_1_attribute_7;
        sample_2_attribute_8 <= sample_1_attribute_8;
        sample_2_attribute_9 <= sample_1_attribute_9;
        sample_2_attribute_10 <= sample_1_attribute_10;
        sample_2_attribute_11 <= sample_1_attribute_11;
        sample_2_attribute_12 <= sample_1_attribute_12;
        sample_2_cardinal_0 <= sample_1_cardinal_0;
        sample_3_weight <= sample_2_weight;
        sample_3_weighted_depth <= sample_2_weighted_depth;
        sample_3_depth_low <= sample_2_depth_low;
        sample_3_depth_high <= sample_2_depth_high;
        sample_3_attribute_0 <= sample_2_attribute_0;
        sample_3_attribute_1 <= sample_2_attribute_1;
        sample_3_attribute_2 <= sample_2_attribute_2;
        sample_3_attribute_3 <= sample_2_attribute_3;
        sample_3_attribute_4 <= sample_2_attribute_4;
        sample_3_attribute_5 <= sample_2_attribute_5;
        sample_3_attribute_6 <= sample_2_attribute_6;
        sample_3_attribute_7 <= sample_2_attribute_7;
        sample_3_attribute_8 <= sample_2_attribute_8;
        sample_3_attribute_9 <= sample_2_attribute_9;
        sample_3_attribute_10 <= sample_2_attribute_10;
        sample_3_attribute_11 <= sample_2_attribute_11;
        sample_3_attribute_12 <= sample_2_attribute_12;
        sample_3_cardinal_0 <= sample_2_cardinal_0;
        late_fail_4 <= depth_test_fail;
        late_fail_5 <= late_fail_4;
        late_pass_4 <= depth_test_pass;
        late_pass_5 <= late_pass_4;
        weight_sum_4 <= {1'd0, stored[319:292]} + {13'd0, sample_3_weight};
        weight_sum_5 <= weight_sum_4;
        weight_sum_6 <= weight_sum_5;
        weight_sum_7 <= weight_sum_6;
        weight_sum_8 <= weight_sum_7;
        weight_4 <= sample_3_weight;
        weight_5 <= weight_4;
        weight_6 <= weight_5;
        weight_7 <= weight_6;
        weight_8 <= weight_7;
        depth_sum_4 <= stored[291:240] + {12'd0, sample_3_weighted_depth};
        depth_sum_5 <= depth_sum_4;
        depth_sum_6 <= depth_sum_5;
        depth_sum_7 <= depth_sum_6;
        depth_sum_8 <= depth_sum_7;
        depth_4 <= sample_3_weighted_depth;
        depth_5 <= depth_4;
        depth_6 <= depth_5;
        depth_7 <= depth_6;
        depth_8 <= depth_7;
        stronger_4 <= stored[239:224] < sample_3_weight;
        stronger_5 <= stronger_4;
        stronger_6 <= stronger_5;
        stronger_7 <= stronger_6;
        stronger_8 <= stronger_7;
        peak_4 <= stored[239:224];
        peak_5 <= peak_4;
        peak_6 <= peak_5;
        peak_7 <= peak_6;
        peak_8 <= peak_7;
        attribute_0_4 <= sample_3_attribute_0;
        attribute_0_5 <= attribute_0_4;
        attribute_0_6 <= attribute_0_5;
        attribute_0_7 <= attribute_0_6;
        attribute_0_8 <= attribute_0_7;
        attribute_1_4 <= sample_3_attribute_1;
        attribute_1_5 <= attribute_1_4;
        attribute_1_6 <= attribute_1_5;
        attribute_1_7 <= attribute_1_6;
        attribute_1_8 <= attribute_1_7;
        attribute_2_4 <= sample_3_attribute_2;
        attribute_2_5 <= attribute_2_4;
        attribute_2_6 <= attribute_2_5;
        attribute_2_7 <= attribute_2_6;
        attribute_2_8 <= attribute_2_7;
        attribute_3_4 <= sample_3_attribute_3;
        attribute_3_5 <= attribute_3_4;
        attribute_3_6 <= attribute_3_5;
        attribute_3_7 <= attribute_3_6;
        attribute_3_8 <= attribute_3_7;
        attribute_4_4 <= sample_3_attribute_4;
        attribute_4_5 <= attribute_4_4;
        attribute_4_6 <= attribute_4_5;
        attribute_4_7 <= attribute_4_6;
        attribute_4_8 <= attribute_4_7;
        attribute_5_4 <= sample_3_attribute_5;
        attribute_5_5 <= attribute_5_4;
        attribute_5_6 <= attribute_5_5;
        attribute_5_7 <= attribute_5_6;
        attribute_5_8 <= attribute_5_7;
        attribute_6_4 <= sample_3_attribute_6;
        attribute_6_5 <= attribute_6_4;
        attribute_6_6 <= attribute_6_5;
        attribute_6_7 <= attribute_6_6;
        attribute_6_8 <= attribute_6_7;
        attribute_7_4 <= sample_3_attribute_7;
        attribute_7_5 <= attribute_7_4;
        attribute_7_6 <= attribute_7_5;
        attribute_7_7 <= attribute_7_6;
        attribute_7_8 <= attribute_7_7;
        attribute_8_4 <= sample_3_attribute_8;
        attribute_8_5 <= attribute_8_4;
        attribute_8_6 <= attribute_8_5;
        attribute_8_7 <= attribute_8_6;
        attribute_8_8 <= attribute_8_7;
        attribute_9_4 <= sample_3_attribute_9;
        attribute_9_5 <= attribute_9_4;
        attribute_9_6 <= attribute_9_5;
        attribute_9_7 <= attribute_9_6;
        attribute_9_8 <= attribute_9_7;
        attribute_10_4 <= sample_3_attribute_10;
        attribute_10_5 <= attribute_10_4;
        attribute_10_6 <= attribute_10_5;
        attribute_10_7 <= attribute_10_6;
        attribute_10_8 <= attribute_10_7;
        attribute_11_4 <= sample_3_attribute_11;
        attribute_11_5 <= attribute_11_4;
        attribute_11_6 <= attribute_11_5;
        attribute_11_7 <= attribute_11_6;
        attribute_11_8 <= attribute_11_7;
        attribute_12_4 <= sample_3_attribute_12;
        attribute_12_5 <= attribute_12_4;
        attribute_12_6 <= attribute_12_5;
        attribute_12_7 <= attribute_12_6;
        attribute_12_8 <= attribute_12_7;
        cardinal_0_4 <= sample_3_cardinal_0;
        cardinal_0_5 <= cardinal_0_4;
        cardinal_0_6 <= cardinal_0_5;
        cardinal_0_7 <= cardinal_0_6;
        cardinal_0_8 <= cardinal_0_7;
        stored_cardinal_0_4 <= stored[15:0];
        stored_cardinal_0_5 <= stored_cardinal_0_4;
        stored_cardinal_0_6 <= stored_cardinal_0_5;
        stored_cardinal_0_7 <= stored_cardinal_0_6;
        stored_cardinal_0_8 <= stored_cardinal_0_7;
        if (head_takes) begin
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
            head_attribute_3 <= samples_out_attribute_3;
            head_attribute_4 <= samples_out_attribute_4;
            head_attribute_5 <= samples_out_attribute_5;
            head_attribute_6 <= samples_out_attribute_6;
            head_attribute_7 <= samples_out_attribute_7;
            head_attribute_8 <= samples_out_attribute_8;
            head_attribute_9 <= samples_out_attribute_9;
            head_attribute_10 <= samples_out_attribute_10;
            head_attribute_11 <= samples_out_attribute_11;
            head_attribute_12 <= samples_out_attribute_12;
            head_cardinal_0 <= samples_out_cardinal_0;
        end
        if (changes_0) begin
            bank_0_was_written <= bank_0_mask[63:32];
            bank_0_was_dirty <= bank_0_mask[31:0];
        end
        if (changes_1) begin
            bank_1_was_written <= bank_1_mask[63:32];
            bank_1_was_dirty <= bank_1_mask[31:0];
        end
    end
    always @(posedge clk) begin
        if ((issue_inside & ~head_pixel[0]) | changes_0) begin
            bank_0_masks[masked_slot_0] <= sample_reads_0 ? (bank_0_mask | {pixel_bit, pixel_bit}) : bank_0_masks_data_bits;
        end
    end
    always @(posedge clk) begin
        if ((issue_inside & head_pixel[0]) | changes_1) begin
            bank_1_masks[masked_slot_1] <= sample_reads_1 ? (bank_1_mask | {pixel_bit, pixel_bit}) : bank_1_masks_data_bits;
        end
    end

    wire _unused = &{
        1'b0, arrived_shifted[7:1], arrived_shifted_2[7:1], bank_0_near_shifted[31:4],
        bank_1_near_shifted[31:4], is_written_shifted[3:1], is_written_shifted_2[3:1], samples_in_ready,
        samples_out_valid
    };

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        queues_move_together: assert (places_out_valid == samples_out_valid);
`else
        if (!(places_out_valid == samples_out_valid)) begin
            $display("assertion failed: queues_move_together in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Floating-point sum.
// stages = 5
// format = f16
module float_add_s5_f16 (
    input  wire clk, input wire enable, input wire [15:0] a, input wire [15:0] b,
    output reg  [15:0] y
);
    reg [7:0] distance_s1;
    reg [10:0] large_s1, small_s1;
    reg [7:0] limit_s1;
    reg subtract_s1;
    reg [14:0] sum_s2, stop_s2;
    reg sign_s1, sign_s2, nan_s1, nan_s2, infinite_s1, infinite_s2, subtract_s2;
    reg [14:0] value_s3;
    reg [3:0] zeros_s3;
    reg [7:0] limit_s2, limit_s3, exponent_s4;
    reg [12:0] significand_s4;
    reg sign_s3, sign_s4, nan_s3, nan_s4, infinite_s3, infinite_s4, zero_s3, zero_s4;

    wire swap = a[14:0] < b[14:0];
    wire [4:0] b_field = b[14:10];
    wire [7:0] distance_s1_bits = {3'd0, b_field[4:1], b_field[0] | ~(|b_field)};
    wire [4:0] a_field = a[14:10];
    wire [7:0] distance_s1_bits_2 = {3'd0, a_field[4:1], a_field[0] | ~(|a_field)};
    wire [9:0] b_fraction = b[9:0];
    wire [10:0] large_s1_bits = {|b_field, b_fraction};
    wire [9:0] a_fraction = a[9:0];
    wire [10:0] large_s1_bits_2 = {|a_field, a_fraction};
    wire a_15_xor_b_15 = a[15] ^ b[15];
    wire [13:0] sum_s2_choice = distance_s1[3] ? ({small_s1, 3'd0} >> 8) : {small_s1, 3'd0};
    wire [13:0] sum_s2_choice_2 = distance_s1[2] ? (sum_s2_choice >> 4) : sum_s2_choice;
    wire [13:0] sum_s2_choice_3 = distance_s1[1] ? (sum_s2_choice_2 >> 2) : sum_s2_choice_2;
    wire [13:0] sum_s2_choice_4 = distance_s1[0] ? (sum_s2_choice_3 >> 1) : sum_s2_choice_3;
    wire sum_s2_either = (distance_s1[3] & |{small_s1[4:0], 3'd0}) | (distance_s1[2] & |sum_s2_choice[3:0]);
    wire sum_s2_either_2 = sum_s2_either | (distance_s1[1] & |sum_s2_choice_2[1:0]) | (distance_s1[0] & sum_s2_choice_3[0]);
    wire [13:0] sum_s2_choice_5 = distance_s1[4] ? {13'd0, |{small_s1, 3'd0}} : {sum_s2_choice_4[13:1], sum_s2_choice_4[0] | sum_s2_either_2};
    wire [15:0] sum_s2_sum = {1'd0, large_s1, 4'd1} + {{1'd0, sum_s2_choice_5} ^ {15{subtract_s1}}, subtract_s1};
    wire nan_s1_both = &a_field & (a_fraction == 10'd0);
    wire nan_s1_both_2 = &b_field & (b_fraction == 10'd0);
    wire [14:0] sum_s2_or_stop_s2 = sum_s2 | stop_s2;
    wire zeros_s3_both = ~sum_s2_or_stop_s2[14] & ~sum_s2_or_stop_s2[13];
    wire zeros_s3_both_2 = zeros_s3_both & (~sum_s2_or_stop_s2[12] & ~sum_s2_or_stop_s2[11]);
    wire zeros_s3_both_3 = ~sum_s2_or_stop_s2[10] & ~sum_s2_or_stop_s2[9];
    wire zeros_s3_both_4 = zeros_s3_both_3 & (~sum_s2_or_stop_s2[8] & ~sum_s2_or_stop_s2[7]);
    wire zeros_s3_both_5 = zeros_s3_both_2 & zeros_s3_both_4;
    wire zeros_s3_both_6 = ~sum_s2_or_stop_s2[6] & ~sum_s2_or_stop_s2[5];
    wire zeros_s3_both_7 = zeros_s3_both_6 & (~sum_s2_or_stop_s2[4] & ~sum_s2_or_stop_s2[3]);
    wire zeros_s3_both_8 = ~sum_s2_or_stop_s2[2] & ~sum_s2_or_stop_s2[1];
    wire [1:0] zeros_s3_bits = {zeros_s3_both_8, zeros_s3_both_8 ? ~sum_s2_or_stop_s2[0] : ~sum_s2_or_stop_s2[2]};
    wire [1:0] zeros_s3_bits_2 = {zeros_s3_both_6, zeros_s3_both_6 ? ~sum_s2_or_stop_s2[4] : ~sum_s2_or_stop_s2[6]};
    wire [2:0] zeros_s3_bits_3 = {zeros_s3_both_7, zeros_s3_both_7 ? zeros_s3_bits : zeros_s3_bits_2};
    wire [1:0] zeros_s3_bits_4 = {zeros_s3_both_3, zeros_s3_both_3 ? ~sum_s2_or_stop_s2[8] : ~sum_s2_or_stop_s2[10]};
    wire [1:0] zeros_s3_bits_5 = {zeros_s3_both, zeros_s3_both ? ~sum_s2_or_stop_s2[12] : ~sum_s2_or_stop_s2[14]};
    wire [2:0] zeros_s3_bits_6 = {zeros_s3_both_2, zeros_s3_both_2 ? zeros_s3_bits_4 : zeros_s3_bits_5};
    wire [14:0] value_s3_shifted_by_zeros_s3 = value_s3 << zeros_s3;
    wire sum_s2_is_0 = sum_s2 == 15'd0;
    wire [14:0] rounded_bits = {exponent_s4[4:0] & {5{significand_s4[12]}}, significand_s4[11:2]};
    wire round_up = significand_s4[1] & (significand_s4[0] | significand_s4[2]);
    wire [14:0] rounded = rounded_bits + {14'd0, round_up};
    wire [14:0] y_choice = (infinite_s4 | (~exponent_s4[7] & (8'd31 <= exponent_s4))) ? 15'h7c00 : rounded;

    always @(posedge clk) begin
        if (enable) begin
            distance_s1 <= swap ? (distance_s1_bits - distance_s1_bits_2) : (distance_s1_bits_2 - distance_s1_bits);
            large_s1 <= swap ? large_s1_bits : large_s1_bits_2;
            small_s1 <= swap ? large_s1_bits_2 : large_s1_bits;
            limit_s1 <= swap ? distance_s1_bits : distance_s1_bits_2;
            subtract_s1 <= a_15_xor_b_15;
            sum_s2 <= sum_s2_sum[15:1];
            stop_s2 <= 15'h4000 >> limit_s1;
            sign_s1 <= swap ? b[15] : a[15];
            sign_s2 <= sign_s1;
            nan_s1 <= (&a_field & |a_fraction) | (&b_field & |b_fraction) | (nan_s1_both & nan_s1_both_2 & a_15_xor_b_15);
            nan_s2 <= nan_s1;
            infinite_s1 <= nan_s1_both | nan_s1_both_2;
            infinite_s2 <= infinite_s1;
            subtract_s2 <= subtract_s1;
            value_s3 <= sum_s2;
            zeros_s3 <= {zeros_s3_both_5, zeros_s3_both_5 ? zeros_s3_bits_3 : zeros_s3_bits_6};
            limit_s2 <= limit_s1;
            limit_s3 <= limit_s2;
            exponent_s4 <= (limit_s3 + 8'd1) - {4'd0, zeros_s3};
            significand_s4 <= {value_s3_shifted_by_zeros_s3[14:3], |value_s3_shifted_by_zeros_s3[2:0]};
            sign_s3 <= sign_s2 & ~(sum_s2_is_0 & subtract_s2);
            sign_s4 <= sign_s3;
            nan_s3 <= nan_s2;
            nan_s4 <= nan_s3;
            infinite_s3 <= infinite_s2;
            infinite_s4 <= infinite_s3;
            zero_s3 <= sum_s2_is_0 & ~infinite_s2;
            zero_s4 <= zero_s3;
            y <= nan_s4 ? 16'h7e00 : {sign_s4, zero_s4 ? 15'd0 : y_choice};
        end
    end

    wire _unused = &{1'b0, distance_s1[7:5], sum_s2_sum[0]};
endmodule

// Compares a pixel's normalized depth with a splat's depth band.
module splat_depth_test (
    input  wire clk, input wire rst,
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

    wire [51:0] low_bound_either = {26'd0, low_bound_low_low} | ({26'd0, low_bound_high_high} << 26);
    wire [51:0] high_bound_either = {26'd0, high_bound_low_low} | ({26'd0, high_bound_high_high} << 26);

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
        low_bound <= low_bound_either + ({26'd0, low_bound_high_low} << 12) + ({26'd0, low_bound_low_high} << 14);
        high_bound_low_low <= {14'd0, depth_high[11:0]} * {12'd0, weight[13:0]};
        high_bound_high_high <= {14'd0, depth_high[23:12]} * {12'd0, weight[27:14]};
        high_bound_high_low <= {14'd0, depth_high[23:12]} * {12'd0, weight[13:0]};
        high_bound_low_high <= {14'd0, depth_high[11:0]} * {12'd0, weight[27:14]};
        high_bound <= high_bound_either + ({26'd0, high_bound_high_low} << 12) + ({26'd0, high_bound_low_high} << 14);
    end
endmodule

// Queue in a memory with a registered output.
// depth = 64
// width = 328
module stream_fifo_d64_w328 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [327:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [327:0] out_data
);
    reg [6:0] held, waiting;
    reg is_full, any_waits;
    reg [5:0] write_address, read_address;
    wire [327:0] item;

    wire has_room = ~is_full;
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [6:0] held_bits = {{6{~push}}, 1'd1};
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    memory_1w1r_unordered #(.WIDTH(328), .DEPTH(64)) entries (
        .clk(clk), .write(has_room), .write_address(write_address), .write_data(in_data),
        .read(fetch), .read_address(read_address), .read_data(item)
    );

    always @(posedge clk) begin
        if (rst) begin
            held <= 7'd0;
            waiting <= 7'd0;
            is_full <= 1'd0;
            any_waits <= 1'd0;
            write_address <= 6'd0;
            read_address <= 6'd0;
            out_valid <= 1'd0;
        end else begin
            if (push_xor_pop) begin
                held <= held + held_bits;
                is_full <= push & (held == 7'd63);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 7'd1);
            end
            if (push) write_address <= write_address + 6'd1;
            if (fetch) read_address <= read_address + 6'd1;
            out_valid <= fetch | (out_valid & ~out_ready);
        end
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        held_in_range: assert (held <= 7'd64);
        held_is_waiting_and_shown: assert (held == (waiting + {6'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 7'd64)) & (any_waits == |waiting));
`else
        if (!(held <= 7'd64)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {6'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 7'd64)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue in a memory with a registered output.
// depth = 64
// width = 11
// storage = distributed
module stream_fifo_d64_w11_distributed (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [10:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [10:0] out_data
);
    (* ram_style = "distributed" *)
    reg [10:0] entries [0:63];
    reg [6:0] held, waiting;
    reg is_full, any_waits;
    reg [5:0] write_address, read_address;
    reg [10:0] item;

    wire has_room = ~is_full;
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [6:0] held_bits = {{6{~push}}, 1'd1};
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    always @(posedge clk) begin
        if (rst) begin
            held <= 7'd0;
            waiting <= 7'd0;
            is_full <= 1'd0;
            any_waits <= 1'd0;
            write_address <= 6'd0;
            read_address <= 6'd0;
            out_valid <= 1'd0;
        end else begin
            if (push_xor_pop) begin
                held <= held + held_bits;
                is_full <= push & (held == 7'd63);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 7'd1);
            end
            if (push) write_address <= write_address + 6'd1;
            if (fetch) read_address <= read_address + 6'd1;
            out_valid <= fetch | (out_valid & ~out_ready);
        end
    end
    always @(posedge clk) begin
        if (has_room) entries[write_address] <= in_data;
        if (fetch) item <= entries[read_address];
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        held_in_range: assert (held <= 7'd64);
        held_is_waiting_and_shown: assert (held == (waiting + {6'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 7'd64)) & (any_waits == |waiting));
`else
        if (!(held <= 7'd64)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {6'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 7'd64)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Weighted depth and attributes of a sample.
// latency = 12
// initiation_interval = 1
module splat_weighting (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready,  // Samples.
    input  wire in_last,  // Closes its copy.
    input  wire in_inside,  // Lies inside the splat; one outside is passed on only to say so.
    input  wire [2:0] in_slot,  // Slot of the tile cache.
    input  wire [5:0] in_pixel,  // Pixel of the tile: row above column.
    input  wire [15:0] in_weight,  // Kernel weight.
    input  wire [23:0] in_depth,  // Depth.
    input  wire [23:0] in_depth_low,  // What is nearer hides the splat.
    input  wire [23:0] in_depth_high,  // What is farther is hidden by the splat.
    input  wire [15:0] in_attribute_0,  // Attributes.
    input  wire [15:0] in_attribute_1,  // Attributes.
    input  wire [15:0] in_attribute_2,  // Attributes.
    input  wire [15:0] in_attribute_3,  // Attributes.
    input  wire [15:0] in_attribute_4,  // Attributes.
    input  wire [15:0] in_attribute_5,  // Attributes.
    input  wire [15:0] in_attribute_6,  // Attributes.
    input  wire [15:0] in_attribute_7,  // Attributes.
    input  wire [15:0] in_attribute_8,  // Attributes.
    input  wire [15:0] in_attribute_9,  // Attributes.
    input  wire [15:0] in_attribute_10,  // Attributes.
    input  wire [15:0] in_attribute_11,  // Attributes.
    input  wire [15:0] in_attribute_12,  // Attributes.
    input  wire [15:0] in_cardinal_0,  // Attributes.
    output wire out_valid, input wire out_ready,  // Samples with their contributions.
    output wire out_last,  // Closes its copy.
    output wire out_inside,  // Lies inside the splat; one outside is passed on only to say so.
    output wire [2:0] out_slot,  // Slot of the tile cache.
    output wire [5:0] out_pixel,  // Pixel of the tile: row above column.
    output wire [15:0] out_weight,  // Kernel weight.
    output wire [39:0] out_weighted_depth,  // Weighted depth.
    output wire [23:0] out_depth_low,  // Near end of the depth band.
    output wire [23:0] out_depth_high,  // Far end of the depth band.
    output wire [15:0] out_attribute_0,  // Weighted continuous attributes, and cardinal ones as they are.
    output wire [15:0] out_attribute_1,  // Weighted continuous attributes, and cardinal ones as they are.
    output wire [15:0] out_attribute_2,  // Weighted continuous attributes, and cardinal ones as they are.
    output wire [15:0] out_attribute_3,  // Weighted continuous attributes, and cardinal ones as they are.
    output wire [15:0] out_attribute_4,  // Weighted continuous attributes, and cardinal ones as they are.
    output wire [15:0] out_attribute_5,  // Weighted continuous attributes, and cardinal ones as they are.
    output wire [15:0] out_attribute_6,  // Weighted continuous attributes, and cardinal ones as they are.
    output wire [15:0] out_attribute_7,  // Weighted continuous attributes, and cardinal ones as they are.
    output wire [15:0] out_attribute_8,  // Weighted continuous attributes, and cardinal ones as they are.
    output wire [15:0] out_attribute_9,  // Weighted continuous attributes, and cardinal ones as they are.
    output wire [15:0] out_attribute_10,  // Weighted continuous attributes, and cardinal ones as they are.
    output wire [15:0] out_attribute_11,  // Weighted continuous attributes, and cardinal ones as they are.
    output wire [15:0] out_attribute_12,  // Weighted continuous attributes, and cardinal ones as they are.
    output wire [15:0] out_cardinal_0  // Weighted continuous attributes, and cardinal ones as they are.
);
    (* ram_style = "distributed" *)
    reg [95:0] delay_6_from_0 [0:4];
    (* ram_style = "distributed" *)
    reg [95:0] delay_6_from_0_copy2 [0:4];
    (* ram_style = "distributed" *)
    reg [15:0] delay_6_from_0_copy3 [0:4];
    (* ram_style = "distributed" *)
    reg [39:0] delay_8_from_0 [0:6];
    (* ram_style = "distributed" *)
    reg [74:0] delay_11_from_0 [0:9];
    reg [4:0] credits;
    reg [2:0] delay_6_from_0_pointer;
    reg [95:0] delay_6_from_0_out;
    reg [2:0] delay_6_from_0_copy2_pointer;
    reg [95:0] delay_6_from_0_copy2_out;
    reg [2:0] delay_6_from_0_copy3_pointer;
    reg [15:0] delay_6_from_0_copy3_out;
    reg [2:0] delay_8_from_0_pointer;
    reg [39:0] delay_8_from_0_out;
    reg [3:0] delay_11_from_0_pointer;
    reg [74:0] delay_11_from_0_out;
    reg last_d1, inside_d1;
    reg [2:0] slot_d1;
    reg [5:0] pixel_d1;
    reg [15:0] weight_d1, weight_d10, weight_d11, weight_d12;
    reg [23:0] depth_d1, depth_low_d1, depth_high_d1;
    reg [15:0] cardinal_0_d1;
    reg [11:0] in_flight;
    reg left;

    wire [15:0] to_float_u16q16_f16_unit_y;
    wire [39:0] mul_u16_u24_unit_y;
    wire [15:0] mul_f16_unit_y, mul_f16_unit_copy2_y, mul_f16_unit_copy3_y, mul_f16_unit_copy4_y;
    wire [15:0] mul_f16_unit_copy5_y, mul_f16_unit_copy6_y, mul_f16_unit_copy7_y, mul_f16_unit_copy8_y;
    wire [15:0] mul_f16_unit_copy9_y, mul_f16_unit_copy10_y, mul_f16_unit_copy11_y, mul_f16_unit_copy12_y;
    wire [15:0] mul_f16_unit_copy13_y;
    wire queue_1_in_ready;
    wire [114:0] queue_1_out_data;
    wire queue_2_in_ready, queue_2_out_valid;
    wire [127:0] queue_2_out_data;
    wire queue_3_in_ready, queue_3_out_valid;
    wire [95:0] queue_3_out_data;

    assign in_ready = ~credits[4];
    wire [15:0] weight_d9 = delay_8_from_0_out[15:0];
    wire [23:0] depth_d9 = delay_8_from_0_out[39:16];
    wire [15:0] attribute_0_d6 = delay_6_from_0_out[15:0];
    wire [15:0] attribute_1_d6 = delay_6_from_0_out[31:16];
    wire [15:0] attribute_2_d6 = delay_6_from_0_out[47:32];
    wire [15:0] attribute_3_d6 = delay_6_from_0_out[63:48];
    wire [15:0] attribute_4_d6 = delay_6_from_0_out[79:64];
    wire [15:0] attribute_5_d6 = delay_6_from_0_out[95:80];
    wire [15:0] attribute_6_d6 = delay_6_from_0_copy2_out[15:0];
    wire [15:0] attribute_7_d6 = delay_6_from_0_copy2_out[31:16];
    wire [15:0] attribute_8_d6 = delay_6_from_0_copy2_out[47:32];
    wire [15:0] attribute_9_d6 = delay_6_from_0_copy2_out[63:48];
    wire [15:0] attribute_10_d6 = delay_6_from_0_copy2_out[79:64];
    wire [15:0] attribute_11_d6 = delay_6_from_0_copy2_out[95:80];
    wire kept = in_flight[11];
    wire last_d12 = delay_11_from_0_out[0];
    wire inside_d12 = delay_11_from_0_out[1];
    wire [2:0] slot_d12 = delay_11_from_0_out[4:2];
    wire [5:0] pixel_d12 = delay_11_from_0_out[10:5];
    wire [23:0] depth_low_d12 = delay_11_from_0_out[34:11];
    wire [23:0] depth_high_d12 = delay_11_from_0_out[58:35];
    wire [15:0] cardinal_0_d12 = delay_11_from_0_out[74:59];
    wire in_valid_and_in_ready = in_valid & in_ready;

    assign {
        out_last, out_inside, out_slot, out_pixel, out_weight, out_weighted_depth, out_depth_low,
        out_depth_high
    } = queue_1_out_data;
    assign {
        out_attribute_0, out_attribute_1, out_attribute_2, out_attribute_3, out_attribute_4, out_attribute_5,
        out_attribute_6, out_attribute_7
    } = queue_2_out_data;
    assign {
        out_attribute_8, out_attribute_9, out_attribute_10, out_attribute_11, out_attribute_12,
        out_cardinal_0
    } = queue_3_out_data;

    float_from_fixed_s5_f16_w16_f16_unsigned to_float_u16q16_f16_unit (.clk(clk), .enable(1'd1), .a(weight_d1), .y(to_float_u16q16_f16_unit_y));

    integer_mul_s3_u16_u24 mul_u16_u24_unit (
        .clk(clk), .enable(1'd1), .a(weight_d9), .b(depth_d9), .y(mul_u16_u24_unit_y)
    );

    float_mul_s6_f16 mul_f16_unit (
        .clk(clk), .enable(1'd1), .a(to_float_u16q16_f16_unit_y), .b(attribute_0_d6), .y(mul_f16_unit_y)
    );

    float_mul_s6_f16 mul_f16_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(to_float_u16q16_f16_unit_y), .b(attribute_1_d6),
        .y(mul_f16_unit_copy2_y)
    );

    float_mul_s6_f16 mul_f16_unit_copy3 (
        .clk(clk), .enable(1'd1), .a(to_float_u16q16_f16_unit_y), .b(attribute_2_d6),
        .y(mul_f16_unit_copy3_y)
    );

    float_mul_s6_f16 mul_f16_unit_copy4 (
        .clk(clk), .enable(1'd1), .a(to_float_u16q16_f16_unit_y), .b(attribute_3_d6),
        .y(mul_f16_unit_copy4_y)
    );

    float_mul_s6_f16 mul_f16_unit_copy5 (
        .clk(clk), .enable(1'd1), .a(to_float_u16q16_f16_unit_y), .b(attribute_4_d6),
        .y(mul_f16_unit_copy5_y)
    );

    float_mul_s6_f16 mul_f16_unit_copy6 (
        .clk(clk), .enable(1'd1), .a(to_float_u16q16_f16_unit_y), .b(attribute_5_d6),
        .y(mul_f16_unit_copy6_y)
    );

    float_mul_s6_f16 mul_f16_unit_copy7 (
        .clk(clk), .enable(1'd1), .a(to_float_u16q16_f16_unit_y), .b(attribute_6_d6),
        .y(mul_f16_unit_copy7_y)
    );

    float_mul_s6_f16 mul_f16_unit_copy8 (
        .clk(clk), .enable(1'd1), .a(to_float_u16q16_f16_unit_y), .b(attribute_7_d6),
        .y(mul_f16_unit_copy8_y)
    );

    float_mul_s6_f16 mul_f16_unit_copy9 (
        .clk(clk), .enable(1'd1), .a(to_float_u16q16_f16_unit_y), .b(attribute_8_d6),
        .y(mul_f16_unit_copy9_y)
    );

    float_mul_s6_f16 mul_f16_unit_copy10 (
        .clk(clk), .enable(1'd1), .a(to_float_u16q16_f16_unit_y), .b(attribute_9_d6),
        .y(mul_f16_unit_copy10_y)
    );

    float_mul_s6_f16 mul_f16_unit_copy11 (
        .clk(clk), .enable(1'd1), .a(to_float_u16q16_f16_unit_y), .b(attribute_10_d6),
        .y(mul_f16_unit_copy11_y)
    );

    float_mul_s6_f16 mul_f16_unit_copy12 (
        .clk(clk), .enable(1'd1), .a(to_float_u16q16_f16_unit_y), .b(attribute_11_d6),
        .y(mul_f16_unit_copy12_y)
    );

    float_mul_s6_f16 mul_f16_unit_copy13 (
        .clk(clk), .enable(1'd1), .a(to_float_u16q16_f16_unit_y), .b(delay_6_from_0_copy3_out),
        .y(mul_f16_unit_copy13_y)
    );

    stream_fifo_d16_w115_distributed queue_1 (
        .clk(clk), .rst(rst), .in_valid(kept), .in_ready(queue_1_in_ready),
        .in_data({
            last_d12, inside_d12, slot_d12, pixel_d12, weight_d12, mul_u16_u24_unit_y, depth_low_d12,
            depth_high_d12
        }),
        .out_valid(out_valid), .out_ready(out_ready), .out_data(queue_1_out_data)
    );

    stream_fifo_d16_w128_distributed queue_2 (
        .clk(clk), .rst(rst), .in_valid(kept), .in_ready(queue_2_in_ready),
        .in_data({
            mul_f16_unit_y, mul_f16_unit_copy2_y, mul_f16_unit_copy3_y, mul_f16_unit_copy4_y,
            mul_f16_unit_copy5_y, mul_f16_unit_copy6_y, mul_f16_unit_copy7_y, mul_f16_unit_copy8_y
        }),
        .out_valid(queue_2_out_valid), .out_ready(out_ready), .out_data(queue_2_out_data)
    );

    stream_fifo_d16_w96_distributed queue_3 (
        .clk(clk), .rst(rst), .in_valid(kept), .in_ready(queue_3_in_ready),
        .in_data({
            mul_f16_unit_copy9_y, mul_f16_unit_copy10_y, mul_f16_unit_copy11_y, mul_f16_unit_copy12_y,
            mul_f16_unit_copy13_y, cardinal_0_d12
        }),
        .out_valid(queue_3_out_valid), .out_ready(out_ready), .out_data(queue_3_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            credits <= 5'd15;
            delay_6_from_0_pointer <= 3'd0;
            delay_6_from_0_copy2_pointer <= 3'd0;
            delay_6_from_0_copy3_pointer <= 3'd0;
            delay_8_from_0_pointer <= 3'd0;
            delay_11_from_0_pointer <= 4'd0;
            in_flight <= 12'd0;
            left <= 1'd0;
        end else begin
            credits <= (credits - {4'd0, in_valid_and_in_ready}) + {4'd0, left};
            delay_6_from_0_pointer <= (delay_6_from_0_pointer == 3'd4) ? (delay_6_from_0_pointer - 3'd4) : (delay_6_from_0_pointer + 3'd1);
            delay_6_from_0_copy2_pointer <= (delay_6_from_0_copy2_pointer == 3'd4) ? (delay_6_from_0_copy2_pointer - 3'd4) : (delay_6_from_0_copy2_pointer + 3'd1);
            delay_6_from_0_copy3_pointer <= (delay_6_from_0_copy3_pointer == 3'd4) ? (delay_6_from_0_copy3_pointer - 3'd4) : (delay_6_from_0_copy3_pointer + 3'd1);
            delay_8_from_0_pointer <= (delay_8_from_0_pointer == 3'd6) ? (delay_8_from_0_pointer - 3'd6) : (delay_8_from_0_pointer + 3'd1);
            delay_11_from_0_pointer <= (delay_11_from_0_pointer == 4'd9) ? (delay_11_from_0_pointer - 4'd9) : (delay_11_from_0_pointer + 4'd1);
            in_flight <= {in_flight[10:0], in_valid_and_in_ready};
            left <= out_valid & out_ready;
        end
    end
    always @(posedge clk) begin
        last_d1 <= in_last;
        inside_d1 <= in_inside;
        slot_d1 <= in_slot;
        pixel_d1 <= in_pixel;
        weight_d1 <= in_weight;
        weight_d10 <= weight_d9;
        weight_d11 <= weight_d10;
        weight_d12 <= weight_d11;
        depth_d1 <= in_depth;
        depth_low_d1 <= in_depth_low;
        depth_high_d1 <= in_depth_high;
        cardinal_0_d1 <= in_cardinal_0;
    end
    always @(posedge clk) begin
        delay_6_from_0[delay_6_from_0_pointer] <= {in_attribute_5, in_attribute_4, in_attribute_3, in_attribute_2, in_attribute_1, in_attribute_0};
        delay_6_from_0_out <= delay_6_from_0[delay_6_from_0_pointer];
    end
    always @(posedge clk) begin
        delay_6_from_0_copy2[delay_6_from_0_copy2_pointer] <= {in_attribute_11, in_attribute_10, in_attribute_9, in_attribute_8, in_attribute_7, in_attribute_6};
        delay_6_from_0_copy2_out <= delay_6_from_0_copy2[delay_6_from_0_copy2_pointer];
    end
    always @(posedge clk) begin
        delay_6_from_0_copy3[delay_6_from_0_copy3_pointer] <= in_attribute_12;
        delay_6_from_0_copy3_out <= delay_6_from_0_copy3[delay_6_from_0_copy3_pointer];
    end
    always @(posedge clk) begin
        delay_8_from_0[delay_8_from_0_pointer] <= {depth_d1, weight_d1};
        delay_8_from_0_out <= delay_8_from_0[delay_8_from_0_pointer];
    end
    always @(posedge clk) begin
        delay_11_from_0[delay_11_from_0_pointer] <= {cardinal_0_d1, depth_high_d1, depth_low_d1, pixel_d1, slot_d1, inside_d1, last_d1};
        delay_11_from_0_out <= delay_11_from_0[delay_11_from_0_pointer];
    end

    wire _unused = &{1'b0, queue_1_in_ready, queue_2_in_ready, queue_2_out_valid, queue_3_in_ready, queue_3_out_valid};

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        queue_1_has_a_place_for_each_result: assert (~kept | queue_1_in_ready);
        queue_2_has_a_place_for_each_result: assert (~kept | queue_2_in_ready);
        queue_3_has_a_place_for_each_result: assert (~kept | queue_3_in_ready);
        queue_2_in_step: assert (queue_2_out_valid == out_valid);
        queue_3_in_step: assert (queue_3_out_valid == out_valid);
`else
        if (!(~kept | queue_1_in_ready)) begin
            $display("assertion failed: queue_1_has_a_place_for_each_result in %m"); $stop;
        end
        if (!(~kept | queue_2_in_ready)) begin
            $display("assertion failed: queue_2_has_a_place_for_each_result in %m"); $stop;
        end
        if (!(~kept | queue_3_in_ready)) begin
            $display("assertion failed: queue_3_has_a_place_for_each_result in %m"); $stop;
        end
        if (!(queue_2_out_valid == out_valid)) begin
            $display("assertion failed: queue_2_in_step in %m"); $stop;
        end
        if (!(queue_3_out_valid == out_valid)) begin
            $display("assertion failed: queue_3_in_step in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue in a memory with a registered output.
// depth = 16
// width = 96
// storage = distributed
module stream_fifo_d16_w96_distributed (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [95:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [95:0] out_data
);
    (* ram_style = "distributed" *)
    reg [95:0] entries [0:15];
    reg [4:0] held, waiting;
    reg is_full, any_waits;
    reg [3:0] write_address, read_address;
    reg [95:0] item;

    wire has_room = ~is_full;
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [4:0] held_bits = {{4{~push}}, 1'd1};
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    always @(posedge clk) begin
        if (rst) begin
            held <= 5'd0;
            waiting <= 5'd0;
            is_full <= 1'd0;
            any_waits <= 1'd0;
            write_address <= 4'd0;
            read_address <= 4'd0;
            out_valid <= 1'd0;
        end else begin
            if (push_xor_pop) begin
                held <= held + held_bits;
                is_full <= push & (held == 5'd15);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 5'd1);
            end
            if (push) write_address <= write_address + 4'd1;
            if (fetch) read_address <= read_address + 4'd1;
            out_valid <= fetch | (out_valid & ~out_ready);
        end
    end
    always @(posedge clk) begin
        if (has_room) entries[write_address] <= in_data;
        if (fetch) item <= entries[read_address];
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        held_in_range: assert (held <= 5'd16);
        held_is_waiting_and_shown: assert (held == (waiting + {4'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 5'd16)) & (any_waits == |waiting));
`else
        if (!(held <= 5'd16)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {4'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 5'd16)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue in a memory with a registered output.
// depth = 16
// width = 128
// storage = distributed
module stream_fifo_d16_w128_distributed (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [127:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [127:0] out_data
);
    (* ram_style = "distributed" *)
    reg [127:0] entries [0:15];
    reg [4:0] held, waiting;
    reg is_full, any_waits;
    reg [3:0] write_address, read_address;
    reg [127:0] item;

    wire has_room = ~is_full;
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [4:0] held_bits = {{4{~push}}, 1'd1};
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    always @(posedge clk) begin
        if (rst) begin
            held <= 5'd0;
            waiting <= 5'd0;
            is_full <= 1'd0;
            any_waits <= 1'd0;
            write_address <= 4'd0;
            read_address <= 4'd0;
            out_valid <= 1'd0;
        end else begin
            if (push_xor_pop) begin
                held <= held + held_bits;
                is_full <= push & (held == 5'd15);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 5'd1);
            end
            if (push) write_address <= write_address + 4'd1;
            if (fetch) read_address <= read_address + 4'd1;
            out_valid <= fetch | (out_valid & ~out_ready);
        end
    end
    always @(posedge clk) begin
        if (has_room) entries[write_address] <= in_data;
        if (fetch) item <= entries[read_address];
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        held_in_range: assert (held <= 5'd16);
        held_is_waiting_and_shown: assert (held == (waiting + {4'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 5'd16)) & (any_waits == |waiting));
`else
        if (!(held <= 5'd16)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {4'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 5'd16)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue in a memory with a registered output.
// depth = 16
// width = 115
// storage = distributed
module stream_fifo_d16_w115_distributed (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [114:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [114:0] out_data
);
    (* ram_style = "distributed" *)
    reg [114:0] entries [0:15];
    reg [4:0] held, waiting;
    reg is_full, any_waits;
    reg [3:0] write_address, read_address;
    reg [114:0] item;

    wire has_room = ~is_full;
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [4:0] held_bits = {{4{~push}}, 1'd1};
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    always @(posedge clk) begin
        if (rst) begin
            held <= 5'd0;
            waiting <= 5'd0;
            is_full <= 1'd0;
            any_waits <= 1'd0;
            write_address <= 4'd0;
            read_address <= 4'd0;
            out_valid <= 1'd0;
        end else begin
            if (push_xor_pop) begin
                held <= held + held_bits;
                is_full <= push & (held == 5'd15);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 5'd1);
            end
            if (push) write_address <= write_address + 4'd1;
            if (fetch) read_address <= read_address + 4'd1;
            out_valid <= fetch | (out_valid & ~out_ready);
        end
    end
    always @(posedge clk) begin
        if (has_room) entries[write_address] <= in_data;
        if (fetch) item <= entries[read_address];
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        held_in_range: assert (held <= 5'd16);
        held_is_waiting_and_shown: assert (held == (waiting + {4'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 5'd16)) & (any_waits == |waiting));
`else
        if (!(held <= 5'd16)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {4'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 5'd16)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Floating-point product.
// stages = 6
// format = f16
module float_mul_s6_f16 (
    input  wire clk, input wire enable, input wire [15:0] a, input wire [15:0] b,
    output reg  [15:0] y
);
    reg [3:0] a_zeros_s1;
    reg [7:0] a_exponent_s1;
    reg [10:0] a_significand_s1;
    reg [3:0] b_zeros_s1;
    reg [7:0] b_exponent_s1;
    reg [10:0] b_significand_s1, left_s2, right_s2;
    reg [7:0] exponent_s2;
    reg [21:0] product_s3;
    reg [7:0] exponent_s3, distance_s4;
    reg [12:0] significand_s4, significand_s5;
    reg [7:0] exponent_s4, exponent_s5;
    reg sign_s1, sign_s2, sign_s3, sign_s4, sign_s5, nan_s1, nan_s2, nan_s3, nan_s4, nan_s5, infinite_s1;
    reg infinite_s2, infinite_s3, infinite_s4, infinite_s5, zero_s1, zero_s2, zero_s3, zero_s4, zero_s5;

    wire [4:0] a_field = a[14:10];
    wire a_exponent_s1_inverted = ~(|a_field);
    wire [9:0] a_fraction = a[9:0];
    wire a_zeros_s1_both = a_exponent_s1_inverted & ~a_fraction[9];
    wire a_zeros_s1_both_2 = a_zeros_s1_both & (~a_fraction[8] & ~a_fraction[7]);
    wire a_zeros_s1_both_3 = ~a_fraction[6] & ~a_fraction[5];
    wire a_zeros_s1_both_4 = a_zeros_s1_both_2 & (a_zeros_s1_both_3 & (~a_fraction[4] & ~a_fraction[3]));
    wire a_zeros_s1_both_5 = ~a_fraction[2] & ~a_fraction[1];
    wire [2:0] a_zeros_s1_bits = {1'd0, a_zeros_s1_both_5, a_zeros_s1_both_5 ? ~a_fraction[0] : ~a_fraction[2]};
    wire [1:0] a_zeros_s1_bits_2 = {a_zeros_s1_both_3, a_zeros_s1_both_3 ? ~a_fraction[4] : ~a_fraction[6]};
    wire [1:0] a_zeros_s1_bits_3 = {a_zeros_s1_both, a_zeros_s1_both ? ~a_fraction[8] : a_exponent_s1_inverted};
    wire [2:0] a_zeros_s1_bits_4 = {a_zeros_s1_both_2, a_zeros_s1_both_2 ? a_zeros_s1_bits_2 : a_zeros_s1_bits_3};
    wire [4:0] b_field = b[14:10];
    wire b_exponent_s1_inverted = ~(|b_field);
    wire [9:0] b_fraction = b[9:0];
    wire b_zeros_s1_both = b_exponent_s1_inverted & ~b_fraction[9];
    wire b_zeros_s1_both_2 = b_zeros_s1_both & (~b_fraction[8] & ~b_fraction[7]);
    wire b_zeros_s1_both_3 = ~b_fraction[6] & ~b_fraction[5];
    wire b_zeros_s1_both_4 = b_zeros_s1_both_2 & (b_zeros_s1_both_3 & (~b_fraction[4] & ~b_fraction[3]));
    wire b_zeros_s1_both_5 = ~b_fraction[2] & ~b_fraction[1];
    wire [2:0] b_zeros_s1_bits = {1'd0, b_zeros_s1_both_5, b_zeros_s1_both_5 ? ~b_fraction[0] : ~b_fraction[2]};
    wire [1:0] b_zeros_s1_bits_2 = {b_zeros_s1_both_3, b_zeros_s1_both_3 ? ~b_fraction[4] : ~b_fraction[6]};
    wire [1:0] b_zeros_s1_bits_3 = {b_zeros_s1_both, b_zeros_s1_both ? ~b_fraction[8] : b_exponent_s1_inverted};
    wire [2:0] b_zeros_s1_bits_4 = {b_zeros_s1_both_2, b_zeros_s1_both_2 ? b_zeros_s1_bits_2 : b_zeros_s1_bits_3};
    wire [7:0] exponent_s3_plus_product_s3_21 = exponent_s3 + {7'd0, product_s3[21]};
    wire exponent_s4_either = exponent_s3_plus_product_s3_21[7] | (exponent_s3_plus_product_s3_21 == 8'd0);
    wire [21:0] significand_s4_choice = product_s3[21] ? product_s3 : (product_s3 << 1);
    wire [12:0] significand_s5_choice = distance_s4[3] ? (significand_s4 >> 8) : significand_s4;
    wire [12:0] significand_s5_choice_2 = distance_s4[2] ? (significand_s5_choice >> 4) : significand_s5_choice;
    wire [12:0] significand_s5_choice_3 = distance_s4[1] ? (significand_s5_choice_2 >> 2) : significand_s5_choice_2;
    wire [12:0] significand_s5_choice_4 = distance_s4[0] ? (significand_s5_choice_3 >> 1) : significand_s5_choice_3;
    wire significand_s5_either = (distance_s4[3] & |significand_s4[7:0]) | (distance_s4[2] & |significand_s5_choice[3:0]);
    wire significand_s5_either_2 = significand_s5_either | (distance_s4[1] & |significand_s5_choice_2[1:0]);
    wire significand_s5_either_3 = significand_s5_either_2 | (distance_s4[0] & significand_s5_choice_3[0]);
    wire [12:0] significand_s5_bits = {significand_s5_choice_4[12:1], significand_s5_choice_4[0] | significand_s5_either_3};
    wire nan_s1_both = &a_field & (a_fraction == 10'd0);
    wire nan_s1_inverted = ~(|b_field | |b_fraction);
    wire nan_s1_either = (&a_field & |a_fraction) | (&b_field & |b_fraction) | (nan_s1_both & nan_s1_inverted);
    wire nan_s1_inverted_2 = ~(|a_field | |a_fraction);
    wire nan_s1_both_2 = &b_field & (b_fraction == 10'd0);
    wire [14:0] rounded_bits = {exponent_s5[4:0] & {5{significand_s5[12]}}, significand_s5[11:2]};
    wire round_up = significand_s5[1] & (significand_s5[0] | significand_s5[2]);
    wire [14:0] rounded = rounded_bits + {14'd0, round_up};
    wire [14:0] y_choice = (infinite_s5 | (~exponent_s5[7] & (8'd31 <= exponent_s5))) ? 15'h7c00 : rounded;

    always @(posedge clk) begin
        if (enable) begin
            a_zeros_s1 <= {a_zeros_s1_both_4, a_zeros_s1_both_4 ? a_zeros_s1_bits : a_zeros_s1_bits_4};
            a_exponent_s1 <= {3'd0, a_field[4:1], a_field[0] | a_exponent_s1_inverted};
            a_significand_s1 <= {|a_field, a_fraction};
            b_zeros_s1 <= {b_zeros_s1_both_4, b_zeros_s1_both_4 ? b_zeros_s1_bits : b_zeros_s1_bits_4};
            b_exponent_s1 <= {3'd0, b_field[4:1], b_field[0] | b_exponent_s1_inverted};
            b_significand_s1 <= {|b_field, b_fraction};
            left_s2 <= a_significand_s1 << a_zeros_s1;
            right_s2 <= b_significand_s1 << b_zeros_s1;
            exponent_s2 <= (a_exponent_s1 - {4'd0, a_zeros_s1}) + (b_exponent_s1 - {4'd0, b_zeros_s1});
            product_s3 <= {11'd0, left_s2} * {11'd0, right_s2};
            exponent_s3 <= exponent_s2 - 8'd15;
            distance_s4 <= (8'd1 - exponent_s3_plus_product_s3_21) & {8{exponent_s4_either}};
            significand_s4 <= {significand_s4_choice[21:10], |significand_s4_choice[9:0]};
            significand_s5 <= |distance_s4[7:4] ? {12'd0, |significand_s4} : significand_s5_bits;
            exponent_s4 <= exponent_s4_either ? 8'd1 : exponent_s3_plus_product_s3_21;
            exponent_s5 <= exponent_s4;
            sign_s1 <= a[15] ^ b[15];
            sign_s2 <= sign_s1;
            sign_s3 <= sign_s2;
            sign_s4 <= sign_s3;
            sign_s5 <= sign_s4;
            nan_s1 <= nan_s1_either | (nan_s1_inverted_2 & nan_s1_both_2);
            nan_s2 <= nan_s1;
            nan_s3 <= nan_s2;
            nan_s4 <= nan_s3;
            nan_s5 <= nan_s4;
            infinite_s1 <= nan_s1_both | nan_s1_both_2;
            infinite_s2 <= infinite_s1;
            infinite_s3 <= infinite_s2;
            infinite_s4 <= infinite_s3;
            infinite_s5 <= infinite_s4;
            zero_s1 <= nan_s1_inverted_2 | nan_s1_inverted;
            zero_s2 <= zero_s1;
            zero_s3 <= zero_s2;
            zero_s4 <= zero_s3;
            zero_s5 <= zero_s4;
            y <= nan_s5 ? 16'h7e00 : {sign_s5, zero_s5 ? 15'd0 : y_choice};
        end
    end
endmodule

// Integer product, pipelined.
// stages = 3
// a = u16
// b = u24
module integer_mul_s3_u16_u24 (
    input  wire clk, input wire enable, input wire [15:0] a, input wire [23:0] b,
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

// Fixed to floating point.
// stages = 5
// format = f16
// width = 16
// fraction = 16
// integer = unsigned
module float_from_fixed_s5_f16_w16_f16_unsigned (
    input  wire clk, input wire enable, input wire [15:0] a,
    output reg  [15:0] y
);
    reg [15:0] magnitude_s1;
    reg [3:0] zeros_s1;
    reg [15:0] shifted_s2;
    reg [3:0] zeros_s2;
    reg [5:0] distance_s3;
    reg [12:0] significand_s3, significand_s4;
    reg [5:0] exponent_s3, exponent_s4;
    reg zero_s1, zero_s2, zero_s3, zero_s4;

    wire not_a_15_and_not_a_14 = ~a[15] & ~a[14];
    wire zeros_s1_both = not_a_15_and_not_a_14 & (~a[13] & ~a[12]);
    wire not_a_11_and_not_a_10 = ~a[11] & ~a[10];
    wire zeros_s1_both_2 = zeros_s1_both & (not_a_11_and_not_a_10 & (~a[9] & ~a[8]));
    wire not_a_7_and_not_a_6 = ~a[7] & ~a[6];
    wire zeros_s1_both_3 = not_a_7_and_not_a_6 & (~a[5] & ~a[4]);
    wire not_a_3_and_not_a_2 = ~a[3] & ~a[2];
    wire [1:0] zeros_s1_choice = zeros_s1_both_3 ? {not_a_3_and_not_a_2, not_a_3_and_not_a_2 ? ~a[1] : ~a[3]} : {not_a_7_and_not_a_6, not_a_7_and_not_a_6 ? ~a[5] : ~a[7]};
    wire [1:0] zeros_s1_choice_2 = zeros_s1_both ? {not_a_11_and_not_a_10, not_a_11_and_not_a_10 ? ~a[9] : ~a[11]} : {not_a_15_and_not_a_14, not_a_15_and_not_a_14 ? ~a[13] : ~a[15]};
    wire [2:0] zeros_s1_choice_3 = zeros_s1_both_2 ? {zeros_s1_both_3, zeros_s1_choice} : {zeros_s1_both, zeros_s1_choice_2};
    wire [5:0] exponent_s3_difference = 6'd14 - {2'd0, zeros_s2};
    wire exponent_s3_either = exponent_s3_difference[5] | (exponent_s3_difference == 6'd0);
    wire [12:0] significand_s4_choice = distance_s3[3] ? (significand_s3 >> 8) : significand_s3;
    wire [12:0] significand_s4_choice_2 = distance_s3[2] ? (significand_s4_choice >> 4) : significand_s4_choice;
    wire [12:0] significand_s4_choice_3 = distance_s3[1] ? (significand_s4_choice_2 >> 2) : significand_s4_choice_2;
    wire [12:0] significand_s4_choice_4 = distance_s3[0] ? (significand_s4_choice_3 >> 1) : significand_s4_choice_3;
    wire significand_s4_either = (distance_s3[3] & |significand_s3[7:0]) | (distance_s3[2] & |significand_s4_choice[3:0]);
    wire significand_s4_either_2 = significand_s4_either | (distance_s3[1] & |significand_s4_choice_2[1:0]);
    wire significand_s4_either_3 = significand_s4_either_2 | (distance_s3[0] & significand_s4_choice_3[0]);
    wire [12:0] significand_s4_bits = {significand_s4_choice_4[12:1], significand_s4_choice_4[0] | significand_s4_either_3};
    wire [14:0] rounded_bits = {exponent_s4[4:0] & {5{significand_s4[12]}}, significand_s4[11:2]};
    wire round_up = significand_s4[1] & (significand_s4[0] | significand_s4[2]);
    wire [14:0] rounded = rounded_bits + {14'd0, round_up};
    wire [14:0] y_choice = zero_s4 ? 15'd0 : (~exponent_s4[5] & (6'd31 <= exponent_s4)) ? 15'h7c00 : rounded;

    always @(posedge clk) begin
        if (enable) begin
            magnitude_s1 <= a;
            zeros_s1 <= {zeros_s1_both_2, zeros_s1_choice_3};
            shifted_s2 <= magnitude_s1 << zeros_s1;
            zeros_s2 <= zeros_s1;
            distance_s3 <= (6'd1 - exponent_s3_difference) & {6{exponent_s3_either}};
            significand_s3 <= {shifted_s2[15:4], |shifted_s2[3:0]};
            significand_s4 <= |distance_s3[5:4] ? {12'd0, |significand_s3} : significand_s4_bits;
            exponent_s3 <= exponent_s3_either ? 6'd1 : exponent_s3_difference;
            exponent_s4 <= exponent_s3;
            zero_s1 <= a == 16'd0;
            zero_s2 <= zero_s1;
            zero_s3 <= zero_s2;
            zero_s4 <= zero_s3;
            y <= {1'd0, y_choice};
        end
    end
endmodule

// Samples of a splat copy, one a cycle, with their kernel weights.
module splat_rasterizer (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready,  // Copies with their slots.
    input  wire [31:0] in_center_x,  // Projected center (px), the origin of what follows.
    input  wire [31:0] in_center_y,  // Projected center (px), the origin of what follows.
    input  wire [31:0] in_ax,  // `A` in x.
    input  wire [31:0] in_bx,  // `B` in x.
    input  wire [31:0] in_ay,  // `A` in y.
    input  wire [31:0] in_by,  // `B` in y.
    input  wire [31:0] in_delta,  // The determinant of `A` and `B`.
    input  wire [31:0] in_mx,  // `m` in x.
    input  wire [31:0] in_my,  // `m` in y.
    input  wire in_sight_negative,  // `D` is negative before the eye.
    input  wire [30:0] in_sight_near,  // The magnitude of `D` at the near plane; all ones where no sample lies before it.
    input  wire [30:0] in_sight_far,  // The magnitude of `D` at the far plane; zero where no sample lies behind it.
    input  wire in_sight_turned,  // The origin is the vanishing point of a tangent: `s1` and `D` have changed places.
    input  wire in_sight_disc,  // The origin is the splat's centre, and lies between near and far plane: the filter's disc is drawn.
    input  wire [23:0] in_depth,  // Depth.
    input  wire [23:0] in_depth_low,  // What is nearer hides the splat.
    input  wire [23:0] in_depth_high,  // What is farther is hidden by the splat.
    input  wire [15:0] in_attribute_0,  // Attributes.
    input  wire [15:0] in_attribute_1,  // Attributes.
    input  wire [15:0] in_attribute_2,  // Attributes.
    input  wire [15:0] in_attribute_3,  // Attributes.
    input  wire [15:0] in_attribute_4,  // Attributes.
    input  wire [15:0] in_attribute_5,  // Attributes.
    input  wire [15:0] in_attribute_6,  // Attributes.
    input  wire [15:0] in_attribute_7,  // Attributes.
    input  wire [15:0] in_attribute_8,  // Attributes.
    input  wire [15:0] in_attribute_9,  // Attributes.
    input  wire [15:0] in_attribute_10,  // Attributes.
    input  wire [15:0] in_attribute_11,  // Attributes.
    input  wire [15:0] in_attribute_12,  // Attributes.
    input  wire [15:0] in_cardinal_0,  // Attributes.
    input  wire [2:0] in_left,  // First column.
    input  wire [2:0] in_right,  // Last column.
    input  wire [2:0] in_top,  // First row.
    input  wire [2:0] in_bottom,  // Last row.
    input  wire [3:0] in_first_sum,  // Smallest sum.
    input  wire [3:0] in_last_sum,  // Largest sum.
    input  wire [3:0] in_first_difference,  // Smallest difference.
    input  wire [3:0] in_last_difference,  // Largest difference.
    input  wire [11:0] in_tile,  // Tile index: row above column.
    input  wire [2:0] in_slot,  // Slot of the tile cache.
    output wire out_valid, input wire out_ready,  // Samples.
    output wire out_last,  // Closes its copy.
    output wire out_inside,  // Lies inside the splat; one outside is passed on only to say so.
    output wire [2:0] out_slot,  // Slot of the tile cache.
    output wire [5:0] out_pixel,  // Pixel of the tile: row above column.
    output wire [15:0] out_weight,  // Kernel weight.
    output wire [23:0] out_depth,  // Depth.
    output wire [23:0] out_depth_low,  // What is nearer hides the splat.
    output wire [23:0] out_depth_high,  // What is farther is hidden by the splat.
    output wire [15:0] out_attribute_0,  // Attributes.
    output wire [15:0] out_attribute_1,  // Attributes.
    output wire [15:0] out_attribute_2,  // Attributes.
    output wire [15:0] out_attribute_3,  // Attributes.
    output wire [15:0] out_attribute_4,  // Attributes.
    output wire [15:0] out_attribute_5,  // Attributes.
    output wire [15:0] out_attribute_6,  // Attributes.
    output wire [15:0] out_attribute_7,  // Attributes.
    output wire [15:0] out_attribute_8,  // Attributes.
    output wire [15:0] out_attribute_9,  // Attributes.
    output wire [15:0] out_attribute_10,  // Attributes.
    output wire [15:0] out_attribute_11,  // Attributes.
    output wire [15:0] out_attribute_12,  // Attributes.
    output wire [15:0] out_cardinal_0,  // Attributes.
    input  wire [31:0] filter_scale,  // The reciprocal of the squared radius of the screen filter.
    output reg  event_sample,  // The rasterizer evaluated a sample.
    output reg  event_starved,  // The rasterizer had no copy to work on.
    output reg  event_blocked  // The rasterizer's pipeline was held by what follows it.
);
    reg busy, idle, walks, is_last;
    reg [2:0] slot;
    reg [11:0] tile;
    reg [2:0] column, row, row_end, next_begin, next_end, bottom, left, right;
    reg [3:0] first_sum;  // Smallest sum.
    reg [3:0] last_sum;  // Largest sum.
    reg [3:0] first_difference;  // Smallest difference.
    reg [3:0] last_difference;  // Largest difference.
    reg [31:0] center_x;  // Projected center (px), the origin of what follows.
    reg [31:0] center_y;  // Projected center (px), the origin of what follows.
    reg [31:0] ax;  // `A` in x.
    reg [31:0] bx;  // `B` in x.
    reg [31:0] ay;  // `A` in y.
    reg [31:0] by;  // `B` in y.
    reg [31:0] delta;  // The determinant of `A` and `B`.
    reg [31:0] mx;  // `m` in x.
    reg [31:0] my;  // `m` in y.
    reg sight_negative;  // `D` is negative before the eye.
    reg [30:0] sight_near;  // The magnitude of `D` at the near plane; all ones where no sample lies before it.
    reg [30:0] sight_far;  // The magnitude of `D` at the far plane; zero where no sample lies behind it.
    reg sight_turned;  // The origin is the vanishing point of a tangent: `s1` and `D` have changed places.
    reg sight_disc;  // The origin is the splat's centre, and lies between near and far plane: the filter's disc is drawn.

    wire evaluation_in_ready, shared_in_ready, shared_out_valid;
    wire [295:0] shared_out_data;

    wire is_ready = evaluation_in_ready & ~walks;
    wire load = is_ready & in_valid;
    wire in_top_is_in_bottom = in_top == in_bottom;
    wire [4:0] in_left_plus_in_top = {2'd0, in_left} + {2'd0, in_top};
    wire is_last_either = ({2'd0, in_right} <= {2'd0, in_left}) | ({1'd0, in_last_sum} <= in_left_plus_in_top);
    wire [4:0] is_last_bits = {2'd0, ~in_top};
    wire [4:0] in_left_plus_is_last_bits = {2'd0, in_left} + is_last_bits;
    wire is_last_either_2 = is_last_either | ({1'd0, in_last_difference} <= in_left_plus_is_last_bits);
    wire [4:0] in_right_plus_in_top = {2'd0, in_right} + {2'd0, in_top};
    wire is_last_either_3 = is_last_either_2 | (in_right_plus_in_top <= {1'd0, in_first_sum});
    wire [4:0] in_last_sum_plus_in_top = {1'd0, in_last_sum} + {2'd0, in_top};
    wire [4:0] in_first_sum_plus_in_top = {1'd0, in_first_sum} + {2'd0, in_top};
    wire is_last_either_4 = is_last_either_3 | (in_last_sum_plus_in_top <= in_first_sum_plus_in_top);
    wire [4:0] in_last_difference_plus_in_top = {1'd0, in_last_difference} + {2'd0, in_top};
    wire [4:0] in_first_sum_plus_is_last_bits = {1'd0, in_first_sum} + is_last_bits;
    wire is_last_either_5 = is_last_either_4 | (in_last_difference_plus_in_top <= in_first_sum_plus_is_last_bits);
    wire [4:0] in_right_plus_is_last_bits = {2'd0, in_right} + is_last_bits;
    wire is_last_either_6 = is_last_either_5 | (in_right_plus_is_last_bits <= {1'd0, in_first_difference});
    wire [4:0] in_last_sum_plus_is_last_bits = {1'd0, in_last_sum} + is_last_bits;
    wire [4:0] column_sum = {1'd0, in_first_difference} + {2'd0, in_top};
    wire [4:0] is_last_sum = {1'd0, in_last_difference} + is_last_bits;
    wire [4:0] is_last_sum_2 = {1'd0, in_first_difference} + is_last_bits;
    wire is_last_either_7 = is_last_either_6 | (in_last_sum_plus_is_last_bits <= column_sum) | (is_last_sum <= is_last_sum_2);
    wire is_last_both = in_top_is_in_bottom & is_last_either_7;
    wire row_done = column == row_end;
    wire [2:0] row_choice = row_done ? (row + 3'd1) : row;
    wire [2:0] column_choice = row_done ? next_begin : (column + 3'd1);
    wire is_last_same = {row_choice, column_choice} == {bottom, row_done ? next_end : row_end};
    wire idle_choice = idle ? (~in_valid | is_last_both) : is_last_same;
    wire take = evaluation_in_ready & idle;
    wire column_in_order = {1'd0, in_first_sum} <= in_left_plus_in_top;
    wire column_in_order_2 = {1'd0, in_first_difference} <= in_left_plus_is_last_bits;
    wire column_in_order_3 = column_sum <= in_first_sum_plus_is_last_bits;
    wire [3:0] column_both = {4{~column_in_order & column_in_order_3}} & (in_first_sum - {1'd0, in_top});
    wire [3:0] column_either = ({4{column_in_order & column_in_order_2}} & {1'd0, in_left}) | column_both;
    wire [3:0] column_bits = {1'd0, ~in_top};
    wire [3:0] column_both_2 = {4{~column_in_order_2 & ~column_in_order_3}} & (in_first_difference - column_bits);
    wire [3:0] column_either_or_column_both_2 = column_either | column_both_2;
    wire row_end_enable_both = evaluation_in_ready & (idle | row_done);
    wire row_end_in_order = in_right_plus_in_top <= {1'd0, in_last_sum};
    wire row_end_in_order_2 = in_right_plus_is_last_bits <= {1'd0, in_last_difference};
    wire row_end_in_order_3 = in_last_sum_plus_is_last_bits <= in_last_difference_plus_in_top;
    wire [3:0] row_end_both = {4{~row_end_in_order & row_end_in_order_3}} & (in_last_sum - {1'd0, in_top});
    wire [3:0] row_end_either = ({4{row_end_in_order & row_end_in_order_2}} & {1'd0, in_right}) | row_end_both;
    wire [3:0] row_end_both_2 = {4{~row_end_in_order_2 & ~row_end_in_order_3}} & (in_last_difference - column_bits);
    wire [3:0] row_end_either_2 = row_end_either | row_end_both_2;
    wire [2:0] in_top_plus_1 = in_top + 3'd1;
    wire [4:0] next_begin_bits = {2'd0, in_top_plus_1};
    wire [4:0] in_left_plus_next_begin_bits = {2'd0, in_left} + next_begin_bits;
    wire next_begin_in_order = {1'd0, in_first_sum} <= in_left_plus_next_begin_bits;
    wire [2:0] not_in_top_plus_1 = ~in_top_plus_1;
    wire [4:0] next_begin_bits_2 = {2'd0, not_in_top_plus_1};
    wire [4:0] in_left_plus_next_begin_bits_2 = {2'd0, in_left} + next_begin_bits_2;
    wire next_begin_in_order_2 = {1'd0, in_first_difference} <= in_left_plus_next_begin_bits_2;
    wire [3:0] next_begin_both = {4{next_begin_in_order & next_begin_in_order_2}} & {1'd0, in_left};
    wire [4:0] next_begin_sum = {1'd0, in_first_difference} + next_begin_bits;
    wire [4:0] next_begin_sum_2 = {1'd0, in_first_sum} + next_begin_bits_2;
    wire next_begin_in_order_3 = next_begin_sum <= next_begin_sum_2;
    wire [3:0] next_begin_bits_3 = {1'd0, in_top_plus_1};
    wire [3:0] next_begin_both_2 = {4{~next_begin_in_order & next_begin_in_order_3}} & (in_first_sum - next_begin_bits_3);
    wire [3:0] next_begin_bits_4 = {1'd0, not_in_top_plus_1};
    wire [3:0] next_begin_both_3 = {4{~next_begin_in_order_2 & ~next_begin_in_order_3}} & (in_first_difference - next_begin_bits_4);
    wire [3:0] next_begin_either = next_begin_both | next_begin_both_2 | next_begin_both_3;
    wire [2:0] row_plus_2 = row + 3'd2;
    wire [4:0] next_begin_bits_5 = {2'd0, row_plus_2};
    wire [4:0] left_plus_next_begin_bits_5 = {2'd0, left} + next_begin_bits_5;
    wire next_begin_in_order_4 = {1'd0, first_sum} <= left_plus_next_begin_bits_5;
    wire [2:0] not_row_plus_2 = ~row_plus_2;
    wire [4:0] next_begin_bits_6 = {2'd0, not_row_plus_2};
    wire [4:0] left_plus_next_begin_bits_6 = {2'd0, left} + next_begin_bits_6;
    wire next_begin_in_order_5 = {1'd0, first_difference} <= left_plus_next_begin_bits_6;
    wire [3:0] next_begin_both_4 = {4{next_begin_in_order_4 & next_begin_in_order_5}} & {1'd0, left};
    wire [4:0] next_begin_sum_3 = {1'd0, first_difference} + next_begin_bits_5;
    wire [4:0] next_begin_sum_4 = {1'd0, first_sum} + next_begin_bits_6;
    wire next_begin_in_order_6 = next_begin_sum_3 <= next_begin_sum_4;
    wire [3:0] next_begin_bits_7 = {1'd0, row_plus_2};
    wire [3:0] next_begin_both_5 = {4{~next_begin_in_order_4 & next_begin_in_order_6}} & (first_sum - next_begin_bits_7);
    wire [3:0] next_begin_bits_8 = {1'd0, not_row_plus_2};
    wire [3:0] next_begin_both_6 = {4{~next_begin_in_order_5 & ~next_begin_in_order_6}} & (first_difference - next_begin_bits_8);
    wire [3:0] next_begin_either_2 = next_begin_both_4 | next_begin_both_5 | next_begin_both_6;
    wire [4:0] in_right_plus_next_begin_bits = {2'd0, in_right} + next_begin_bits;
    wire next_end_in_order = in_right_plus_next_begin_bits <= {1'd0, in_last_sum};
    wire [4:0] next_end_sum = {2'd0, in_right} + next_begin_bits_2;
    wire next_end_in_order_2 = next_end_sum <= {1'd0, in_last_difference};
    wire [4:0] next_end_sum_2 = {1'd0, in_last_sum} + next_begin_bits_2;
    wire [4:0] next_end_sum_3 = {1'd0, in_last_difference} + next_begin_bits;
    wire next_end_in_order_3 = next_end_sum_2 <= next_end_sum_3;
    wire [3:0] next_end_both = {4{~next_end_in_order & next_end_in_order_3}} & (in_last_sum - next_begin_bits_3);
    wire [3:0] next_end_either = ({4{next_end_in_order & next_end_in_order_2}} & {1'd0, in_right}) | next_end_both;
    wire [3:0] next_end_both_2 = {4{~next_end_in_order_2 & ~next_end_in_order_3}} & (in_last_difference - next_begin_bits_4);
    wire [3:0] next_end_either_2 = next_end_either | next_end_both_2;
    wire [4:0] right_plus_next_begin_bits_5 = {2'd0, right} + next_begin_bits_5;
    wire next_end_in_order_4 = right_plus_next_begin_bits_5 <= {1'd0, last_sum};
    wire [4:0] right_plus_next_begin_bits_6 = {2'd0, right} + next_begin_bits_6;
    wire next_end_in_order_5 = right_plus_next_begin_bits_6 <= {1'd0, last_difference};
    wire [4:0] next_end_sum_4 = {1'd0, last_sum} + next_begin_bits_6;
    wire [4:0] next_end_sum_5 = {1'd0, last_difference} + next_begin_bits_5;
    wire next_end_in_order_6 = next_end_sum_4 <= next_end_sum_5;
    wire [3:0] next_end_both_3 = {4{~next_end_in_order_4 & next_end_in_order_6}} & (last_sum - next_begin_bits_7);
    wire [3:0] next_end_either_3 = ({4{next_end_in_order_4 & next_end_in_order_5}} & {1'd0, right}) | next_end_both_3;
    wire [3:0] next_end_both_4 = {4{~next_end_in_order_5 & ~next_end_in_order_6}} & (last_difference - next_begin_bits_8);
    wire [3:0] next_end_either_4 = next_end_either_3 | next_end_both_4;

    assign in_ready = is_ready;
    assign {
        out_depth, out_depth_low, out_depth_high, out_attribute_0, out_attribute_1, out_attribute_2,
        out_attribute_3, out_attribute_4, out_attribute_5, out_attribute_6, out_attribute_7, out_attribute_8,
        out_attribute_9, out_attribute_10, out_attribute_11, out_attribute_12, out_cardinal_0
    } = shared_out_data;

    splat_evaluation evaluation (
        .clk(clk), .rst(rst), .in_valid(busy), .in_ready(evaluation_in_ready), .in_last(is_last),
        .in_slot(slot), .in_column({tile[5:0], column}), .in_row({tile[11:6], row}), .in_center_x(center_x),
        .in_center_y(center_y), .in_ax(ax), .in_bx(bx), .in_ay(ay), .in_by(by), .in_delta(delta), .in_mx(mx),
        .in_my(my), .in_sight_negative(sight_negative), .in_sight_near(sight_near), .in_sight_far(sight_far),
        .in_sight_turned(sight_turned), .in_sight_disc(sight_disc),
        .filter_scale(filter_scale),
        .out_valid(out_valid), .out_ready(out_ready), .out_last(out_last), .out_inside(out_inside),
        .out_slot(out_slot), .out_pixel(out_pixel), .out_weight(out_weight)
    );

    stream_fifo_d128_w296 shared (
        .clk(clk), .rst(rst), .in_valid(load), .in_ready(shared_in_ready),
        .in_data({
            in_depth, in_depth_low, in_depth_high, in_attribute_0, in_attribute_1, in_attribute_2, in_attribute_3,
            in_attribute_4, in_attribute_5, in_attribute_6, in_attribute_7, in_attribute_8, in_attribute_9,
            in_attribute_10, in_attribute_11, in_attribute_12, in_cardinal_0
        }),
        .out_valid(shared_out_valid), .out_ready(out_ready & out_valid & out_last),
        .out_data(shared_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            busy <= 1'd0;
            idle <= 1'd1;
            walks <= 1'd0;
            event_sample <= 1'd0;
            event_starved <= 1'd0;
            event_blocked <= 1'd0;
        end else begin
            if (evaluation_in_ready) begin
                busy <= idle ? in_valid : busy;
                idle <= idle_choice;
                walks <= ~idle_choice;
            end
            event_sample <= evaluation_in_ready & busy;
            event_starved <= evaluation_in_ready & ~busy;
            event_blocked <= busy & ~evaluation_in_ready;
        end
    end
    always @(posedge clk) begin
        if (evaluation_in_ready) begin
            is_last <= idle ? is_last_both : is_last_same;
            column <= idle ? column_either_or_column_both_2[2:0] : column_choice;
            row <= idle ? in_top : row_choice;
        end
        if (take) begin
            slot <= in_slot;
            tile <= in_tile;
            bottom <= in_bottom;
            left <= in_left;
            right <= in_right;
            first_sum <= in_first_sum;
            last_sum <= in_last_sum;
            first_difference <= in_first_difference;
            last_difference <= in_last_difference;
            center_x <= in_center_x;
            center_y <= in_center_y;
            ax <= in_ax;
            bx <= in_bx;
            ay <= in_ay;
            by <= in_by;
            delta <= in_delta;
            mx <= in_mx;
            my <= in_my;
            sight_negative <= in_sight_negative;
            sight_near <= in_sight_near;
            sight_far <= in_sight_far;
            sight_turned <= in_sight_turned;
            sight_disc <= in_sight_disc;
        end
        if (row_end_enable_both) begin
            row_end <= idle ? row_end_either_2[2:0] : next_end;
            next_begin <= idle ? next_begin_either[2:0] : next_begin_either_2[2:0];
            next_end <= idle ? next_end_either_2[2:0] : next_end_either_4[2:0];
        end
    end

    wire _unused = &{
        1'b0, column_either_or_column_both_2[3], next_begin_either[3], next_begin_either_2[3],
        next_end_either_2[3], next_end_either_4[3], row_end_either_2[3], shared_in_ready, shared_out_valid
    };

`ifdef RTL_ASSERT
    wire in_left_up_to_in_right = {2'd0, in_left} <= {2'd0, in_right};
    wire check_both = in_left_up_to_in_right & (in_left_plus_in_top <= {1'd0, in_last_sum});
    wire check_both_2 = check_both & (in_left_plus_is_last_bits <= {1'd0, in_last_difference});
    wire check_both_3 = check_both_2 & ({1'd0, in_first_sum} <= in_right_plus_in_top) & (in_first_sum_plus_in_top <= in_last_sum_plus_in_top);
    wire check_both_4 = check_both_3 & (in_first_sum_plus_is_last_bits <= in_last_difference_plus_in_top);
    wire check_both_5 = check_both_4 & ({1'd0, in_first_difference} <= in_right_plus_is_last_bits);
    wire check_both_6 = check_both_5 & (column_sum <= in_last_sum_plus_is_last_bits) & (is_last_sum_2 <= is_last_sum);
    wire check_both_7 = in_left_up_to_in_right & (in_left_plus_next_begin_bits <= {1'd0, in_last_sum});
    wire check_both_8 = check_both_7 & (in_left_plus_next_begin_bits_2 <= {1'd0, in_last_difference});
    wire check_both_9 = check_both_8 & ({1'd0, in_first_sum} <= in_right_plus_next_begin_bits);
    wire check_in_order = ({1'd0, in_first_sum} + next_begin_bits) <= ({1'd0, in_last_sum} + next_begin_bits);
    wire check_both_10 = check_both_9 & check_in_order & (next_begin_sum_2 <= next_end_sum_3);
    wire check_both_11 = check_both_10 & ({1'd0, in_first_difference} <= next_end_sum) & (next_begin_sum <= next_end_sum_2);
    wire check_in_order_2 = ({1'd0, in_first_difference} + next_begin_bits_2) <= ({1'd0, in_last_difference} + next_begin_bits_2);
    wire check_both_12 = check_both_6 & (in_top_is_in_bottom | (check_both_11 & check_in_order_2));
    wire check_both_13 = ({2'd0, left} <= {2'd0, right}) & (left_plus_next_begin_bits_5 <= {1'd0, last_sum});
    wire check_both_14 = check_both_13 & (left_plus_next_begin_bits_6 <= {1'd0, last_difference});
    wire check_both_15 = check_both_14 & ({1'd0, first_sum} <= right_plus_next_begin_bits_5);
    wire check_in_order_3 = ({1'd0, first_sum} + next_begin_bits_5) <= ({1'd0, last_sum} + next_begin_bits_5);
    wire check_both_16 = check_both_15 & check_in_order_3 & (next_begin_sum_4 <= next_end_sum_5);
    wire check_both_17 = check_both_16 & ({1'd0, first_difference} <= right_plus_next_begin_bits_6);
    wire check_in_order_4 = ({1'd0, first_difference} + next_begin_bits_6) <= ({1'd0, last_difference} + next_begin_bits_6);
    wire check_both_18 = check_both_17 & (next_begin_sum_3 <= next_end_sum_4) & check_in_order_4;
    wire check_either = ~busy | (~(({1'd0, row} + 4'd2) <= {1'd0, bottom}) | check_both_18);

    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        rows_have_samples: assert ((~(take & in_valid) | check_both_12) & check_either);
        walks_unless_idle: assert (walks ^ idle);
        shared_has_room: assert (~load | shared_in_ready);
`else
        if (!((~(take & in_valid) | check_both_12) & check_either)) begin
            $display("assertion failed: rows_have_samples in %m"); $stop;
        end
        if (!(walks ^ idle)) begin $display("assertion failed: walks_unless_idle in %m"); $stop; end
        if (!(~load | shared_in_ready)) begin
            $display("assertion failed: shared_has_room in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue in a memory with a registered output.
// depth = 128
// width = 296
module stream_fifo_d128_w296 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [295:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [295:0] out_data
);
    reg [7:0] held, waiting;
    reg is_full, any_waits;
    reg [6:0] write_address, read_address;
    wire [295:0] item;

    wire has_room = ~is_full;
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [7:0] held_bits = {{7{~push}}, 1'd1};
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    memory_1w1r_unordered #(.WIDTH(296), .DEPTH(128)) entries (
        .clk(clk), .write(has_room), .write_address(write_address), .write_data(in_data),
        .read(fetch), .read_address(read_address), .read_data(item)
    );

    always @(posedge clk) begin
        if (rst) begin
            held <= 8'd0;
            waiting <= 8'd0;
            is_full <= 1'd0;
            any_waits <= 1'd0;
            write_address <= 7'd0;
            read_address <= 7'd0;
            out_valid <= 1'd0;
        end else begin
            if (push_xor_pop) begin
                held <= held + held_bits;
                is_full <= push & (held == 8'd127);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 8'd1);
            end
            if (push) write_address <= write_address + 7'd1;
            if (fetch) read_address <= read_address + 7'd1;
            out_valid <= fetch | (out_valid & ~out_ready);
        end
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        held_in_range: assert (held <= 8'd128);
        held_is_waiting_and_shown: assert (held == (waiting + {7'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 8'd128)) & (any_waits == |waiting));
`else
        if (!(held <= 8'd128)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {7'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 8'd128)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Distance of a sample from its splat's centre, and its kernel weight.
// latency = 74
// initiation_interval = 1
module splat_evaluation (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire in_last, input wire [2:0] in_slot,
    input  wire [8:0] in_column, input wire [8:0] in_row, input wire [31:0] in_center_x,
    input  wire [31:0] in_center_y, input wire [31:0] in_ax, input wire [31:0] in_bx,
    input  wire [31:0] in_ay, input wire [31:0] in_by, input wire [31:0] in_delta,
    input  wire [31:0] in_mx, input wire [31:0] in_my, input wire in_sight_negative,
    input  wire [30:0] in_sight_near, input wire [30:0] in_sight_far, input wire in_sight_turned,
    input  wire in_sight_disc,
    input  wire [31:0] filter_scale,
    output wire out_valid, input wire out_ready, output wire out_last, output wire out_inside,
    output wire [2:0] out_slot, output wire [5:0] out_pixel, output wire [15:0] out_weight
);
    (* ram_style = "distributed" *)
    reg delay_5_from_0 [0:3];
    (* ram_style = "distributed" *)
    reg [95:0] delay_6_from_0 [0:4];
    (* ram_style = "distributed" *)
    reg [31:0] delay_6_from_0_copy2 [0:4];
    (* ram_style = "distributed" *)
    reg [95:0] delay_9_from_0 [0:7];
    (* ram_style = "distributed" *)
    reg [95:0] delay_9_from_0_copy2 [0:7];
    (* ram_style = "distributed" *)
    reg [31:0] delay_14_from_0 [0:12];
    (* ram_style = "distributed" *)
    reg delay_25_from_0 [0:23];
    (* ram_style = "distributed" *)
    reg [63:0] delay_26_from_0 [0:24];
    (* ram_style = "distributed" *)
    reg delay_38_from_0 [0:36];
    (* ram_style = "distributed" *)
    reg [31:0] delay_40_from_0 [0:38];
    reg [7:0] credits;
    reg [1:0] delay_5_from_0_pointer;
    reg delay_5_from_0_out;
    reg [2:0] delay_6_from_0_pointer;
    reg [95:0] delay_6_from_0_out;
    reg [2:0] delay_6_from_0_copy2_pointer;
    reg [31:0] delay_6_from_0_copy2_out;
    reg [2:0] delay_9_from_0_pointer;
    reg [95:0] delay_9_from_0_out;
    reg [2:0] delay_9_from_0_copy2_pointer;
    reg [95:0] delay_9_from_0_copy2_out;
    reg [3:0] delay_14_from_0_pointer;
    reg [31:0] delay_14_from_0_out;
    reg [4:0] delay_25_from_0_pointer;
    reg delay_25_from_0_out;
    reg [4:0] delay_26_from_0_pointer;
    reg [63:0] delay_26_from_0_out;
    reg [5:0] delay_38_from_0_pointer;
    reg delay_38_from_0_out;
    reg [5:0] delay_40_from_0_pointer;
    reg [31:0] delay_40_from_0_out;
    reg [6:0] delay_74_from_0_pointer;
    wire [9:0] delay_74_from_0_out;
    reg [31:0] minus_center_x_d1, minus_center_x_d2, minus_center_x_d3, minus_center_y_d1, minus_center_y_d2;
    reg [31:0] minus_center_y_d3;
    reg not_rho_squared_unequal_d1, rho_squared_in_order_d1, rho_squared_in_order_d1_copy2;
    reg [73:0] in_flight;
    reg left, dropped;

    wire [31:0] to_float_u10q1_f32_ftz_unit_y, to_float_u10q1_f32_ftz_unit_copy2_y, add_f32_ftz_unit_y;
    wire [31:0] add_f32_ftz_unit_copy2_y, add_f32_ftz_unit_copy3_y, add_f32_ftz_unit_copy4_y;
    wire [31:0] add_f32_ftz_unit_copy5_y, add_f32_ftz_unit_copy6_y, add_f32_ftz_unit_copy7_y;
    wire [31:0] add_f32_ftz_unit_copy8_y, mul_f32_ftz_unit_y, mul_f32_ftz_unit_copy2_y, mul_f32_ftz_unit_copy3_y;
    wire [31:0] mul_f32_ftz_unit_copy4_y, mul_f32_ftz_unit_copy5_y, mul_f32_ftz_unit_copy6_y;
    wire [31:0] mul_f32_ftz_unit_copy7_y, mul_f32_ftz_unit_copy8_y, mul_f32_ftz_unit_copy9_y;
    wire [31:0] mul_f32_ftz_unit_copy10_y, mul_f32_ftz_unit_copy11_y, mul_f32_ftz_unit_copy12_y, div_f32_ftz_unit_y;
    wire [31:0] min_f32_ftz_unit_y;
    wire lt_f32_ftz_unit_y;
    wire [15:0] to_fixed_f32_ftz_u16q16_unit_y, interpolate_8_8_16_unit_y;
    wire queue_1_in_ready;
    wire [1:0] queue_1_out_data;
    wire queue_2_in_ready, queue_2_out_valid;
    wire [24:0] queue_2_out_data;

    assign in_ready = ~credits[7];
    wire [31:0] y_times_my_d6 = delay_6_from_0_out[63:32];
    wire [31:0] s2_squared_d6 = delay_6_from_0_out[95:64];
    wire [31:0] ay_d9 = delay_9_from_0_out[31:0];
    wire [31:0] ax_d9 = delay_9_from_0_out[63:32];
    wire [31:0] by_d9 = delay_9_from_0_out[95:64];
    wire [31:0] bx_d9 = delay_9_from_0_copy2_out[31:0];
    wire [31:0] mx_d9 = delay_9_from_0_copy2_out[63:32];
    wire [31:0] my_d9 = delay_9_from_0_copy2_out[95:64];
    wire sight_turned_d26 = delay_26_from_0_out[63];
    wire [31:0] s1_d6 = delay_6_from_0_out[31:0];
    wire [31:0] rho_squared_chosen = sight_turned_d26 ? add_f32_ftz_unit_copy6_y : s1_d6;
    wire [31:0] rho_squared_chosen_copy2 = sight_turned_d26 ? s1_d6 : add_f32_ftz_unit_copy6_y;
    wire [31:0] rho_squared_chosen_copy3 = delay_38_from_0_out ? div_f32_ftz_unit_y : 32'h7f800000;
    wire last_d74 = delay_74_from_0_out[0];
    wire last_or_covered = last_d74 | delay_5_from_0_out;
    wire kept = in_flight[73] & last_or_covered;
    wire [2:0] slot_d74 = delay_74_from_0_out[3:1];
    wire [5:0] pixel_out_d74 = delay_74_from_0_out[9:4];
    wire in_valid_and_in_ready = in_valid & in_ready;
    wire sight_negative_d26 = delay_26_from_0_out[0];
    wire rho_squared_unequal = sight_negative_d26 ^ rho_squared_chosen_copy2[31];
    wire not_rho_squared_unequal = ~rho_squared_unequal;
    wire [30:0] sight_near_d26 = delay_26_from_0_out[31:1];
    wire rho_squared_in_order = ~(sight_near_d26 < rho_squared_chosen_copy2[30:0]);
    wire [30:0] sight_far_d26 = delay_26_from_0_out[62:32];
    wire rho_squared_in_order_copy2 = ~(rho_squared_chosen_copy2[30:0] < sight_far_d26);
    wire rho_squared_both = not_rho_squared_unequal_d1 & rho_squared_in_order_d1;
    wire rho_squared_both_copy2 = rho_squared_both & rho_squared_in_order_d1_copy2;
    wire [31:0] rho_squared_chosen_copy4 = delay_25_from_0_out ? mul_f32_ftz_unit_copy12_y : 32'h7f800000;

    assign {out_last, out_inside} = queue_1_out_data;
    assign {out_slot, out_pixel, out_weight} = queue_2_out_data;

    memory_1w1r #(.WIDTH(10), .DEPTH(73)) delay_74_from_0 (
        .clk(clk), .write(1'd1), .write_address(delay_74_from_0_pointer),
        .write_data({in_row[2:0], in_column[2:0], in_slot, in_last}),
        .read(1'd1), .read_address(delay_74_from_0_pointer), .read_data(delay_74_from_0_out)
    );

    float_from_fixed_s3_f32ftz_w10_f1_unsigned to_float_u10q1_f32_ftz_unit (
        .clk(clk), .enable(1'd1), .a({in_column, 1'd1}), .y(to_float_u10q1_f32_ftz_unit_y)
    );

    float_from_fixed_s3_f32ftz_w10_f1_unsigned to_float_u10q1_f32_ftz_unit_copy2 (
        .clk(clk), .enable(1'd1), .a({in_row, 1'd1}), .y(to_float_u10q1_f32_ftz_unit_copy2_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit (
        .clk(clk), .enable(1'd1), .a(to_float_u10q1_f32_ftz_unit_y), .b(minus_center_x_d3),
        .y(add_f32_ftz_unit_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(to_float_u10q1_f32_ftz_unit_copy2_y), .b(minus_center_y_d3),
        .y(add_f32_ftz_unit_copy2_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy3 (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_y),
        .b({~mul_f32_ftz_unit_copy2_y[31], mul_f32_ftz_unit_copy2_y[30:0]}), .y(add_f32_ftz_unit_copy3_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy4 (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_copy3_y),
        .b({~mul_f32_ftz_unit_copy4_y[31], mul_f32_ftz_unit_copy4_y[30:0]}), .y(add_f32_ftz_unit_copy4_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy5 (
        .clk(clk), .enable(1'd1), .a(delay_14_from_0_out), .b(mul_f32_ftz_unit_copy5_y),
        .y(add_f32_ftz_unit_copy5_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy6 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy5_y), .b(y_times_my_d6),
        .y(add_f32_ftz_unit_copy6_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy7 (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_copy7_y), .b(s2_squared_d6),
        .y(add_f32_ftz_unit_copy7_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy8 (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_copy10_y), .b(mul_f32_ftz_unit_copy11_y),
        .y(add_f32_ftz_unit_copy8_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_y), .b(ay_d9), .y(mul_f32_ftz_unit_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy2_y), .b(ax_d9), .y(mul_f32_ftz_unit_copy2_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy3 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_y), .b(by_d9), .y(mul_f32_ftz_unit_copy3_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy4 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy2_y), .b(bx_d9), .y(mul_f32_ftz_unit_copy4_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy5 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_y), .b(mx_d9), .y(mul_f32_ftz_unit_copy5_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy6 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy2_y), .b(my_d9), .y(mul_f32_ftz_unit_copy6_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy7 (
        .clk(clk), .enable(1'd1), .a(rho_squared_chosen), .b(rho_squared_chosen),
        .y(mul_f32_ftz_unit_copy7_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy8 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy4_y), .b(add_f32_ftz_unit_copy4_y),
        .y(mul_f32_ftz_unit_copy8_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy9 (
        .clk(clk), .enable(1'd1), .a(rho_squared_chosen_copy2), .b(rho_squared_chosen_copy2),
        .y(mul_f32_ftz_unit_copy9_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy10 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_y), .b(add_f32_ftz_unit_y),
        .y(mul_f32_ftz_unit_copy10_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy11 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy2_y), .b(add_f32_ftz_unit_copy2_y),
        .y(mul_f32_ftz_unit_copy11_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy12 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy8_y), .b(filter_scale),
        .y(mul_f32_ftz_unit_copy12_y)
    );

    float_div_s28_f32ftz div_f32_ftz_unit (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy7_y), .b(delay_6_from_0_copy2_out),
        .y(div_f32_ftz_unit_y)
    );

    float_min_s2_f32ftz min_f32_ftz_unit (
        .clk(clk), .enable(1'd1), .a(rho_squared_chosen_copy3), .b(delay_40_from_0_out),
        .y(min_f32_ftz_unit_y)
    );

    float_lt_s2_f32ftz lt_f32_ftz_unit (
        .clk(clk), .enable(1'd1), .a(min_f32_ftz_unit_y), .b(32'h3f800000), .y(lt_f32_ftz_unit_y)
    );

    float_to_fixed_s3_f32ftz_w16_f16_unsigned to_fixed_f32_ftz_u16q16_unit (
        .clk(clk), .enable(1'd1), .a(min_f32_ftz_unit_y), .y(to_fixed_f32_ftz_u16q16_unit_y)
    );

    float_table_s4_i8_f8 interpolate_8_8_16_unit (
        .clk(clk), .enable(1'd1), .a(to_fixed_f32_ftz_u16q16_unit_y), .y(interpolate_8_8_16_unit_y)
    );

    stream_fifo_d78_w2_distributed queue_1 (
        .clk(clk), .rst(rst), .in_valid(kept), .in_ready(queue_1_in_ready),
        .in_data({last_d74, delay_5_from_0_out}),
        .out_valid(out_valid), .out_ready(out_ready), .out_data(queue_1_out_data)
    );

    stream_fifo_d78_w25 queue_2 (
        .clk(clk), .rst(rst), .in_valid(kept), .in_ready(queue_2_in_ready),
        .in_data({slot_d74, pixel_out_d74, interpolate_8_8_16_unit_y}),
        .out_valid(queue_2_out_valid), .out_ready(out_ready), .out_data(queue_2_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            credits <= 8'd77;
            delay_5_from_0_pointer <= 2'd0;
            delay_6_from_0_pointer <= 3'd0;
            delay_6_from_0_copy2_pointer <= 3'd0;
            delay_9_from_0_pointer <= 3'd0;
            delay_9_from_0_copy2_pointer <= 3'd0;
            delay_14_from_0_pointer <= 4'd0;
            delay_25_from_0_pointer <= 5'd0;
            delay_26_from_0_pointer <= 5'd0;
            delay_38_from_0_pointer <= 6'd0;
            delay_40_from_0_pointer <= 6'd0;
            delay_74_from_0_pointer <= 7'd0;
            in_flight <= 74'd0;
            left <= 1'd0;
            dropped <= 1'd0;
        end else begin
            credits <= (credits - {7'd0, in_valid_and_in_ready}) + {7'd0, left} + {7'd0, dropped};
            delay_5_from_0_pointer <= (delay_5_from_0_pointer == 2'd3) ? (delay_5_from_0_pointer - 2'd3) : (delay_5_from_0_pointer + 2'd1);
            delay_6_from_0_pointer <= (delay_6_from_0_pointer == 3'd4) ? (delay_6_from_0_pointer - 3'd4) : (delay_6_from_0_pointer + 3'd1);
            delay_6_from_0_copy2_pointer <= (delay_6_from_0_copy2_pointer == 3'd4) ? (delay_6_from_0_copy2_pointer - 3'd4) : (delay_6_from_0_copy2_pointer + 3'd1);
            delay_9_from_0_pointer <= (delay_9_from_0_pointer == 3'd7) ? (delay_9_from_0_pointer - 3'd7) : (delay_9_from_0_pointer + 3'd1);
            delay_9_from_0_copy2_pointer <= (delay_9_from_0_copy2_pointer == 3'd7) ? (delay_9_from_0_copy2_pointer - 3'd7) : (delay_9_from_0_copy2_pointer + 3'd1);
            delay_14_from_0_pointer <= (delay_14_from_0_pointer == 4'd12) ? (delay_14_from_0_pointer - 4'd12) : (delay_14_from_0_pointer + 4'd1);
            delay_25_from_0_pointer <= (delay_25_from_0_pointer == 5'd23) ? (delay_25_from_0_pointer - 5'd23) : (delay_25_from_0_pointer + 5'd1);
            delay_26_from_0_pointer <= (delay_26_from_0_pointer == 5'd24) ? (delay_26_from_0_pointer - 5'd24) : (delay_26_from_0_pointer + 5'd1);
            delay_38_from_0_pointer <= (delay_38_from_0_pointer == 6'd36) ? (delay_38_from_0_pointer - 6'd36) : (delay_38_from_0_pointer + 6'd1);
            delay_40_from_0_pointer <= (delay_40_from_0_pointer == 6'd38) ? (delay_40_from_0_pointer - 6'd38) : (delay_40_from_0_pointer + 6'd1);
            delay_74_from_0_pointer <= (delay_74_from_0_pointer == 7'd72) ? (delay_74_from_0_pointer - 7'd72) : (delay_74_from_0_pointer + 7'd1);
            in_flight <= {in_flight[72:0], in_valid_and_in_ready};
            left <= out_valid & out_ready;
            dropped <= in_flight[73] & ~last_or_covered;
        end
    end
    always @(posedge clk) begin
        minus_center_x_d1 <= {~in_center_x[31], in_center_x[30:0]};
        minus_center_x_d2 <= minus_center_x_d1;
        minus_center_x_d3 <= minus_center_x_d2;
        minus_center_y_d1 <= {~in_center_y[31], in_center_y[30:0]};
        minus_center_y_d2 <= minus_center_y_d1;
        minus_center_y_d3 <= minus_center_y_d2;
        not_rho_squared_unequal_d1 <= not_rho_squared_unequal;
        rho_squared_in_order_d1 <= rho_squared_in_order;
        rho_squared_in_order_d1_copy2 <= rho_squared_in_order_copy2;
    end
    always @(posedge clk) begin
        delay_5_from_0[delay_5_from_0_pointer] <= lt_f32_ftz_unit_y;
        delay_5_from_0_out <= delay_5_from_0[delay_5_from_0_pointer];
    end
    always @(posedge clk) begin
        delay_6_from_0[delay_6_from_0_pointer] <= {mul_f32_ftz_unit_copy8_y, mul_f32_ftz_unit_copy6_y, add_f32_ftz_unit_copy3_y};
        delay_6_from_0_out <= delay_6_from_0[delay_6_from_0_pointer];
    end
    always @(posedge clk) begin
        delay_6_from_0_copy2[delay_6_from_0_copy2_pointer] <= mul_f32_ftz_unit_copy9_y;
        delay_6_from_0_copy2_out <= delay_6_from_0_copy2[delay_6_from_0_copy2_pointer];
    end
    always @(posedge clk) begin
        delay_9_from_0[delay_9_from_0_pointer] <= {in_by, in_ax, in_ay};
        delay_9_from_0_out <= delay_9_from_0[delay_9_from_0_pointer];
    end
    always @(posedge clk) begin
        delay_9_from_0_copy2[delay_9_from_0_copy2_pointer] <= {in_my, in_mx, in_bx};
        delay_9_from_0_copy2_out <= delay_9_from_0_copy2[delay_9_from_0_copy2_pointer];
    end
    always @(posedge clk) begin
        delay_14_from_0[delay_14_from_0_pointer] <= in_delta;
        delay_14_from_0_out <= delay_14_from_0[delay_14_from_0_pointer];
    end
    always @(posedge clk) begin
        delay_25_from_0[delay_25_from_0_pointer] <= in_sight_disc;
        delay_25_from_0_out <= delay_25_from_0[delay_25_from_0_pointer];
    end
    always @(posedge clk) begin
        delay_26_from_0[delay_26_from_0_pointer] <= {in_sight_turned, in_sight_far, in_sight_near, in_sight_negative};
        delay_26_from_0_out <= delay_26_from_0[delay_26_from_0_pointer];
    end
    always @(posedge clk) begin
        delay_38_from_0[delay_38_from_0_pointer] <= rho_squared_both_copy2;
        delay_38_from_0_out <= delay_38_from_0[delay_38_from_0_pointer];
    end
    always @(posedge clk) begin
        delay_40_from_0[delay_40_from_0_pointer] <= rho_squared_chosen_copy4;
        delay_40_from_0_out <= delay_40_from_0[delay_40_from_0_pointer];
    end

    wire _unused = &{1'b0, queue_1_in_ready, queue_2_in_ready, queue_2_out_valid};

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        queue_1_has_a_place_for_each_result: assert (~kept | queue_1_in_ready);
        queue_2_has_a_place_for_each_result: assert (~kept | queue_2_in_ready);
        queue_2_in_step: assert (queue_2_out_valid == out_valid);
`else
        if (!(~kept | queue_1_in_ready)) begin
            $display("assertion failed: queue_1_has_a_place_for_each_result in %m"); $stop;
        end
        if (!(~kept | queue_2_in_ready)) begin
            $display("assertion failed: queue_2_has_a_place_for_each_result in %m"); $stop;
        end
        if (!(queue_2_out_valid == out_valid)) begin
            $display("assertion failed: queue_2_in_step in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue in a memory with a registered output.
// depth = 78
// width = 25
module stream_fifo_d78_w25 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [24:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [24:0] out_data
);
    reg [6:0] held, waiting;
    reg is_full, any_waits;
    reg [6:0] write_address, read_address;
    wire [24:0] item;

    wire has_room = ~is_full;
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [6:0] held_bits = {{6{~push}}, 1'd1};
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    memory_1w1r_unordered #(.WIDTH(25), .DEPTH(78)) entries (
        .clk(clk), .write(has_room), .write_address(write_address), .write_data(in_data),
        .read(fetch), .read_address(read_address), .read_data(item)
    );

    always @(posedge clk) begin
        if (rst) begin
            held <= 7'd0;
            waiting <= 7'd0;
            is_full <= 1'd0;
            any_waits <= 1'd0;
            write_address <= 7'd0;
            read_address <= 7'd0;
            out_valid <= 1'd0;
        end else begin
            if (push_xor_pop) begin
                held <= held + held_bits;
                is_full <= push & (held == 7'd77);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 7'd1);
            end
            if (push) write_address <= (write_address == 7'd77) ? 7'd0 : (write_address + 7'd1);
            if (fetch) read_address <= (read_address == 7'd77) ? 7'd0 : (read_address + 7'd1);
            out_valid <= fetch | (out_valid & ~out_ready);
        end
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        held_in_range: assert (held <= 7'd78);
        held_is_waiting_and_shown: assert (held == (waiting + {6'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 7'd78)) & (any_waits == |waiting));
`else
        if (!(held <= 7'd78)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {6'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 7'd78)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue in a memory with a registered output.
// depth = 78
// width = 2
// storage = distributed
module stream_fifo_d78_w2_distributed (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [1:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [1:0] out_data
);
    (* ram_style = "distributed" *)
    reg [1:0] entries [0:77];
    reg [6:0] held, waiting;
    reg is_full, any_waits;
    reg [6:0] write_address, read_address;
    reg [1:0] item;

    wire has_room = ~is_full;
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [6:0] held_bits = {{6{~push}}, 1'd1};
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    always @(posedge clk) begin
        if (rst) begin
            held <= 7'd0;
            waiting <= 7'd0;
            is_full <= 1'd0;
            any_waits <= 1'd0;
            write_address <= 7'd0;
            read_address <= 7'd0;
            out_valid <= 1'd0;
        end else begin
            if (push_xor_pop) begin
                held <= held + held_bits;
                is_full <= push & (held == 7'd77);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 7'd1);
            end
            if (push) write_address <= (write_address == 7'd77) ? 7'd0 : (write_address + 7'd1);
            if (fetch) read_address <= (read_address == 7'd77) ? 7'd0 : (read_address + 7'd1);
            out_valid <= fetch | (out_valid & ~out_ready);
        end
    end
    always @(posedge clk) begin
        if (has_room) entries[write_address] <= in_data;
        if (fetch) item <= entries[read_address];
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        held_in_range: assert (held <= 7'd78);
        held_is_waiting_and_shown: assert (held == (waiting + {6'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 7'd78)) & (any_waits == |waiting));
`else
        if (!(held <= 7'd78)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {6'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 7'd78)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Sampled function, interpolated linearly.
// stages = 4
// index_bits = 8
// fraction_bits = 8
module float_table_s4_i8_f8 (
    input  wire clk, input wire enable, input wire [15:0] a,
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
    wire [8:0] rise_s3_bits = {1'd0, fraction_s2};
    wire [25:0] slope_s2_times_rise_s3_bits = $signed({{9{slope_s2[16]}}, slope_s2}) * $signed({{17{rise_s3_bits[8]}}, rise_s3_bits});

    always @(posedge clk) begin
        if (enable) begin
            entry_s1 <= samples;
            fraction_s1 <= a[7:0];
            slope_s2 <= entry_s1[16:0];
            fraction_s2 <= fraction_s1;
            rise_s3 <= slope_s2_times_rise_s3_bits[23:8];
            start_s2 <= entry_s1[32:17];
            start_s3 <= start_s2;
            y <= start_s3 + rise_s3;
        end
    end

    wire _unused = &{1'b0, slope_s2_times_rise_s3_bits[7:0], slope_s2_times_rise_s3_bits[25:24]};
endmodule

// Floating to fixed point.
// stages = 3
// format = f32-ftz
// width = 16
// fraction = 16
// integer = unsigned
module float_to_fixed_s3_f32ftz_w16_f16_unsigned (
    input  wire clk, input wire enable, input wire [31:0] a,
    output reg  [15:0] y
);
    reg [4:0] distance_s1;
    reg [23:0] significand_s1;
    reg [15:0] magnitude_s2;
    reg sign_s1, sign_s2, nan_s1, nan_s2, vanishes_s1, vanishes_s2, saturates_s1, saturates_s2;

    wire [7:0] a_field = a[30:23];
    wire [10:0] saturates_s1_sum = {3'd0, a_field} + 11'h792;
    wire [10:0] distance_s1_difference = 11'd24 - saturates_s1_sum;
    wire [22:0] a_fraction = a[22:0];
    wire [23:0] magnitude_s2_shifted = significand_s1 >> distance_s1;
    wire vanishes_s1_either = saturates_s1_sum[10] | (saturates_s1_sum == 11'd0);
    wire vanishes_s1_both = &a_field & (a_fraction == 23'd0);

    always @(posedge clk) begin
        if (enable) begin
            distance_s1 <= distance_s1_difference[4:0];
            significand_s1 <= {|a_field, a_fraction & {23{|a_field}}};
            magnitude_s2 <= magnitude_s2_shifted[15:0];
            sign_s1 <= a[31];
            sign_s2 <= sign_s1;
            nan_s1 <= &a_field & |a_fraction;
            nan_s2 <= nan_s1;
            vanishes_s1 <= (vanishes_s1_either & ~vanishes_s1_both) | ~(|a_field);
            vanishes_s2 <= vanishes_s1;
            saturates_s1 <= (~vanishes_s1_either & (11'd17 <= saturates_s1_sum) & |a_field) | vanishes_s1_both;
            saturates_s2 <= saturates_s1;
            y <= (vanishes_s2 | nan_s2 | sign_s2) ? 16'd0 : saturates_s2 ? 16'hffff : magnitude_s2;
        end
    end

    wire _unused = &{1'b0, distance_s1_difference[10:5], magnitude_s2_shifted[23:16]};
endmodule

// Floating-point quotient, correctly rounded.
// stages = 28
// format = f32-ftz
module float_div_s28_f32ftz (
    input  wire clk, input wire enable, input wire [31:0] a, input wire [31:0] b,
    output reg  [31:0] y
);
    reg [24:0] remainder_s1;
    reg quotient_s1;
    reg [23:0] divisor_s1;
    reg [24:0] remainder_s2;
    reg [1:0] quotient_s2;
    reg [23:0] divisor_s2;
    reg [24:0] remainder_s3;
    reg [2:0] quotient_s3;
    reg [23:0] divisor_s3;
    reg [24:0] remainder_s4;
    reg [3:0] quotient_s4;
    reg [23:0] divisor_s4;
    reg [24:0] remainder_s5;
    reg [4:0] quotient_s5;
    reg [23:0] divisor_s5;
    reg [24:0] remainder_s6;
    reg [5:0] quotient_s6;
    reg [23:0] divisor_s6;
    reg [24:0] remainder_s7;
    reg [6:0] quotient_s7;
    reg [23:0] divisor_s7;
    reg [24:0] remainder_s8;
    reg [7:0] quotient_s8;
    reg [23:0] divisor_s8;
    reg [24:0] remainder_s9;
    reg [8:0] quotient_s9;
    reg [23:0] divisor_s9;
    reg [24:0] remainder_s10;
    reg [9:0] quotient_s10;
    reg [23:0] divisor_s10;
    reg [24:0] remainder_s11;
    reg [10:0] quotient_s11;
    reg [23:0] divisor_s11;
    reg [24:0] remainder_s12;
    reg [11:0] quotient_s12;
    reg [23:0] divisor_s12;
    reg [24:0] remainder_s13;
    reg [12:0] quotient_s13;
    reg [23:0] divisor_s13;
    reg [24:0] remainder_s14;
    reg [13:0] quotient_s14;
    reg [23:0] divisor_s14;
    reg [24:0] remainder_s15;
    reg [14:0] quotient_s15;
    reg [23:0] divisor_s15;
    reg [24:0] remainder_s16;
    reg [15:0] quotient_s16;
    reg [23:0] divisor_s16;
    reg [24:0] remainder_s17;
    reg [16:0] quotient_s17;
    reg [23:0] divisor_s17;
    reg [24:0] remainder_s18;
    reg [17:0] quotient_s18;
    reg [23:0] divisor_s18;
    reg [24:0] remainder_s19;
    reg [18:0] quotient_s19;
    reg [23:0] divisor_s19;
    reg [24:0] remainder_s20;
    reg [19:0] quotient_s20;
    reg [23:0] divisor_s20;
    reg [24:0] remainder_s21;
    reg [20:0] quotient_s21;
    reg [23:0] divisor_s21;
    reg [24:0] remainder_s22;
    reg [21:0] quotient_s22;
    reg [23:0] divisor_s22;
    reg [24:0] remainder_s23;
    reg [22:0] quotient_s23;
    reg [23:0] divisor_s23;
    reg [24:0] remainder_s24;
    reg [23:0] quotient_s24, divisor_s24;
    reg [24:0] remainder_s25, quotient_s25;
    reg [23:0] divisor_s25;
    reg [24:0] remainder_s26;
    reg [25:0] quotient_s26;
    reg [9:0] exponent_s1, exponent_s2, exponent_s3, exponent_s4, exponent_s5, exponent_s6, exponent_s7;
    reg [9:0] exponent_s8, exponent_s9, exponent_s10, exponent_s11, exponent_s12, exponent_s13, exponent_s14;
    reg [9:0] exponent_s15, exponent_s16, exponent_s17, exponent_s18, exponent_s19, exponent_s20, exponent_s21;
    reg [9:0] exponent_s22, exponent_s23, exponent_s24, exponent_s25, exponent_s26, exponent_s27;
    reg [25:0] significand_s27;
    reg sign_s1, sign_s2, sign_s3, sign_s4, sign_s5, sign_s6, sign_s7, sign_s8, sign_s9, sign_s10, sign_s11;
    reg sign_s12, sign_s13, sign_s14, sign_s15, sign_s16, sign_s17, sign_s18, sign_s19, sign_s20, sign_s21;
    reg sign_s22, sign_s23, sign_s24, sign_s25, sign_s26, sign_s27, nan_s1, nan_s2, nan_s3, nan_s4, nan_s5;
    reg nan_s6, nan_s7, nan_s8, nan_s9, nan_s10, nan_s11, nan_s12, nan_s13, nan_s14, nan_s15, nan_s16;
    reg nan_s17, nan_s18, nan_s19, nan_s20, nan_s21, nan_s22, nan_s23, nan_s24, nan_s25, nan_s26, nan_s27;
    reg infinite_s1, infinite_s2, infinite_s3, infinite_s4, infinite_s5, infinite_s6, infinite_s7;
    reg infinite_s8, infinite_s9, infinite_s10, infinite_s11, infinite_s12, infinite_s13, infinite_s14;
    reg infinite_s15, infinite_s16, infinite_s17, infinite_s18, infinite_s19, infinite_s20, infinite_s21;
    reg infinite_s22, infinite_s23, infinite_s24, infinite_s25, infinite_s26, infinite_s27, zero_s1, zero_s2;
    reg zero_s3, zero_s4, zero_s5, zero_s6, zero_s7, zero_s8, zero_s9, zero_s10, zero_s11, zero_s12, zero_s13;
    reg zero_s14, zero_s15, zero_s16, zero_s17, zero_s18, zero_s19, zero_s20, zero_s21, zero_s22, zero_s23;
    reg zero_s24, zero_s25, zero_s26, zero_s27;

    wire [7:0] a_field = a[30:23];
    wire [22:0] a_fraction = a[22:0];
    wire [22:0] remainder_s1_both = a_fraction & {23{|a_field}};
    wire [7:0] b_field = b[30:23];
    wire [22:0] b_fraction = b[22:0];
    wire [22:0] remainder_s1_both_2 = b_fraction & {23{|b_field}};
    wire [25:0] remainder_s1_difference = {2'd0, |a_field, remainder_s1_both} - {2'd0, |b_field, remainder_s1_both_2};
    wire [23:0] remainder_s1_choice = ~remainder_s1_difference[25] ? remainder_s1_difference[23:0] : {|a_field, remainder_s1_both};
    wire [25:0] remainder_s1_minus_divisor_s1 = {1'd0, remainder_s1} - {2'd0, divisor_s1};
    wire [23:0] remainder_s2_choice = ~remainder_s1_minus_divisor_s1[25] ? remainder_s1_minus_divisor_s1[23:0] : remainder_s1[23:0];
    wire [25:0] remainder_s2_minus_divisor_s2 = {1'd0, remainder_s2} - {2'd0, divisor_s2};
    wire [23:0] remainder_s3_choice = ~remainder_s2_minus_divisor_s2[25] ? remainder_s2_minus_divisor_s2[23:0] : remainder_s2[23:0];
    wire [25:0] remainder_s3_minus_divisor_s3 = {1'd0, remainder_s3} - {2'd0, divisor_s3};
    wire [23:0] remainder_s4_choice = ~remainder_s3_minus_divisor_s3[25] ? remainder_s3_minus_divisor_s3[23:0] : remainder_s3[23:0];
    wire [25:0] remainder_s4_minus_divisor_s4 = {1'd0, remainder_s4} - {2'd0, divisor_s4};
    wire [23:0] remainder_s5_choice = ~remainder_s4_minus_divisor_s4[25] ? remainder_s4_minus_divisor_s4[23:0] : remainder_s4[23:0];
    wire [25:0] remainder_s5_minus_divisor_s5 = {1'd0, remainder_s5} - {2'd0, divisor_s5};
    wire [23:0] remainder_s6_choice = ~remainder_s5_minus_divisor_s5[25] ? remainder_s5_minus_divisor_s5[23:0] : remainder_s5[23:0];
    wire [25:0] remainder_s6_minus_divisor_s6 = {1'd0, remainder_s6} - {2'd0, divisor_s6};
    wire [23:0] remainder_s7_choice = ~remainder_s6_minus_divisor_s6[25] ? remainder_s6_minus_divisor_s6[23:0] : remainder_s6[23:0];
    wire [25:0] remainder_s7_minus_divisor_s7 = {1'd0, remainder_s7} - {2'd0, divisor_s7};
    wire [23:0] remainder_s8_choice = ~remainder_s7_minus_divisor_s7[25] ? remainder_s7_minus_divisor_s7[23:0] : remainder_s7[23:0];
    wire [25:0] remainder_s8_minus_divisor_s8 = {1'd0, remainder_s8} - {2'd0, divisor_s8};
    wire [23:0] remainder_s9_choice = ~remainder_s8_minus_divisor_s8[25] ? remainder_s8_minus_divisor_s8[23:0] : remainder_s8[23:0];
    wire [25:0] remainder_s9_minus_divisor_s9 = {1'd0, remainder_s9} - {2'd0, divisor_s9};
    wire [23:0] remainder_s10_choice = ~remainder_s9_minus_divisor_s9[25] ? remainder_s9_minus_divisor_s9[23:0] : remainder_s9[23:0];
    wire [25:0] remainder_s11_difference = {1'd0, remainder_s10} - {2'd0, divisor_s10};
    wire [23:0] remainder_s11_choice = ~remainder_s11_difference[25] ? remainder_s11_difference[23:0] : remainder_s10[23:0];
    wire [25:0] remainder_s12_difference = {1'd0, remainder_s11} - {2'd0, divisor_s11};
    wire [23:0] remainder_s12_choice = ~remainder_s12_difference[25] ? remainder_s12_difference[23:0] : remainder_s11[23:0];
    wire [25:0] remainder_s13_difference = {1'd0, remainder_s12} - {2'd0, divisor_s12};
    wire [23:0] remainder_s13_choice = ~remainder_s13_difference[25] ? remainder_s13_difference[23:0] : remainder_s12[23:0];
    wire [25:0] remainder_s14_difference = {1'd0, remainder_s13} - {2'd0, divisor_s13};
    wire [23:0] remainder_s14_choice = ~remainder_s14_difference[25] ? remainder_s14_difference[23:0] : remainder_s13[23:0];
    wire [25:0] remainder_s15_difference = {1'd0, remainder_s14} - {2'd0, divisor_s14};
    wire [23:0] remainder_s15_choice = ~remainder_s15_difference[25] ? remainder_s15_difference[23:0] : remainder_s14[23:0];
    wire [25:0] remainder_s16_difference = {1'd0, remainder_s15} - {2'd0, divisor_s15};
    wire [23:0] remainder_s16_choice = ~remainder_s16_difference[25] ? remainder_s16_difference[23:0] : remainder_s15[23:0];
    wire [25:0] remainder_s17_difference = {1'd0, remainder_s16} - {2'd0, divisor_s16};
    wire [23:0] remainder_s17_choice = ~remainder_s17_difference[25] ? remainder_s17_difference[23:0] : remainder_s16[23:0];
    wire [25:0] remainder_s18_difference = {1'd0, remainder_s17} - {2'd0, divisor_s17};
    wire [23:0] remainder_s18_choice = ~remainder_s18_difference[25] ? remainder_s18_difference[23:0] : remainder_s17[23:0];
    wire [25:0] remainder_s19_difference = {1'd0, remainder_s18} - {2'd0, divisor_s18};
    wire [23:0] remainder_s19_choice = ~remainder_s19_difference[25] ? remainder_s19_difference[23:0] : remainder_s18[23:0];
    wire [25:0] remainder_s20_difference = {1'd0, remainder_s19} - {2'd0, divisor_s19};
    wire [23:0] remainder_s20_choice = ~remainder_s20_difference[25] ? remainder_s20_difference[23:0] : remainder_s19[23:0];
    wire [25:0] remainder_s21_difference = {1'd0, remainder_s20} - {2'd0, divisor_s20};
    wire [23:0] remainder_s21_choice = ~remainder_s21_difference[25] ? remainder_s21_difference[23:0] : remainder_s20[23:0];
    wire [25:0] remainder_s22_difference = {1'd0, remainder_s21} - {2'd0, divisor_s21};
    wire [23:0] remainder_s22_choice = ~remainder_s22_difference[25] ? remainder_s22_difference[23:0] : remainder_s21[23:0];
    wire [25:0] remainder_s23_difference = {1'd0, remainder_s22} - {2'd0, divisor_s22};
    wire [23:0] remainder_s23_choice = ~remainder_s23_difference[25] ? remainder_s23_difference[23:0] : remainder_s22[23:0];
    wire [25:0] remainder_s24_difference = {1'd0, remainder_s23} - {2'd0, divisor_s23};
    wire [23:0] remainder_s24_choice = ~remainder_s24_difference[25] ? remainder_s24_difference[23:0] : remainder_s23[23:0];
    wire [25:0] remainder_s25_difference = {1'd0, remainder_s24} - {2'd0, divisor_s24};
    wire [23:0] remainder_s25_choice = ~remainder_s25_difference[25] ? remainder_s25_difference[23:0] : remainder_s24[23:0];
    wire [25:0] remainder_s26_difference = {1'd0, remainder_s25} - {2'd0, divisor_s25};
    wire [23:0] remainder_s26_choice = ~remainder_s26_difference[25] ? remainder_s26_difference[23:0] : remainder_s25[23:0];
    wire [26:0] significand_s27_bits = {quotient_s26, |remainder_s26};
    wire [26:0] significand_s27_choice = ~quotient_s26[25] ? (significand_s27_bits << 1) : significand_s27_bits;
    wire nan_s1_inverted = ~(|a_field);
    wire nan_s1_inverted_2 = ~(|b_field);
    wire nan_s1_either = (&a_field & |a_fraction) | (&b_field & |b_fraction) | (nan_s1_inverted & nan_s1_inverted_2);
    wire nan_s1_both = &a_field & (a_fraction == 23'd0);
    wire nan_s1_both_2 = &b_field & (b_fraction == 23'd0);
    wire y_both = (exponent_s27 == 10'd0) & ~(&significand_s27[24:2] & significand_s27[1]);
    wire round_up = significand_s27[1] & (significand_s27[0] | significand_s27[2]);
    wire [30:0] rounded = {exponent_s27[7:0], significand_s27[24:2]} + {30'd0, round_up};
    wire [30:0] y_choice = (infinite_s27 | (~exponent_s27[9] & (10'd255 <= exponent_s27))) ? 31'h7f800000 : rounded;
    wire [30:0] y_choice_2 = (zero_s27 | ((exponent_s27[9] | y_both) & ~infinite_s27)) ? 31'd0 : y_choice;

    always @(posedge clk) begin
        if (enable) begin
            remainder_s1 <= {remainder_s1_choice, 1'd0};
            quotient_s1 <= ~remainder_s1_difference[25];
            divisor_s1 <= {|b_field, remainder_s1_both_2};
            remainder_s2 <= {remainder_s2_choice, 1'd0};
            quotient_s2 <= {quotient_s1, ~remainder_s1_minus_divisor_s1[25]};
            divisor_s2 <= divisor_s1;
            remainder_s3 <= {remainder_s3_choice, 1'd0};
            quotient_s3 <= {quotient_s2, ~remainder_s2_minus_divisor_s2[25]};
            divisor_s3 <= divisor_s2;
            remainder_s4 <= {remainder_s4_choice, 1'd0};
            quotient_s4 <= {quotient_s3, ~remainder_s3_minus_divisor_s3[25]};
            divisor_s4 <= divisor_s3;
            remainder_s5 <= {remainder_s5_choice, 1'd0};
            quotient_s5 <= {quotient_s4, ~remainder_s4_minus_divisor_s4[25]};
            divisor_s5 <= divisor_s4;
            remainder_s6 <= {remainder_s6_choice, 1'd0};
            quotient_s6 <= {quotient_s5, ~remainder_s5_minus_divisor_s5[25]};
            divisor_s6 <= divisor_s5;
            remainder_s7 <= {remainder_s7_choice, 1'd0};
            quotient_s7 <= {quotient_s6, ~remainder_s6_minus_divisor_s6[25]};
            divisor_s7 <= divisor_s6;
            remainder_s8 <= {remainder_s8_choice, 1'd0};
            quotient_s8 <= {quotient_s7, ~remainder_s7_minus_divisor_s7[25]};
            divisor_s8 <= divisor_s7;
            remainder_s9 <= {remainder_s9_choice, 1'd0};
            quotient_s9 <= {quotient_s8, ~remainder_s8_minus_divisor_s8[25]};
            divisor_s9 <= divisor_s8;
            remainder_s10 <= {remainder_s10_choice, 1'd0};
            quotient_s10 <= {quotient_s9, ~remainder_s9_minus_divisor_s9[25]};
            divisor_s10 <= divisor_s9;
            remainder_s11 <= {remainder_s11_choice, 1'd0};
            quotient_s11 <= {quotient_s10, ~remainder_s11_difference[25]};
            divisor_s11 <= divisor_s10;
            remainder_s12 <= {remainder_s12_choice, 1'd0};
            quotient_s12 <= {quotient_s11, ~remainder_s12_difference[25]};
            divisor_s12 <= divisor_s11;
            remainder_s13 <= {remainder_s13_choice, 1'd0};
            quotient_s13 <= {quotient_s12, ~remainder_s13_difference[25]};
            divisor_s13 <= divisor_s12;
            remainder_s14 <= {remainder_s14_choice, 1'd0};
            quotient_s14 <= {quotient_s13, ~remainder_s14_difference[25]};
            divisor_s14 <= divisor_s13;
            remainder_s15 <= {remainder_s15_choice, 1'd0};
            quotient_s15 <= {quotient_s14, ~remainder_s15_difference[25]};
            divisor_s15 <= divisor_s14;
            remainder_s16 <= {remainder_s16_choice, 1'd0};
            quotient_s16 <= {quotient_s15, ~remainder_s16_difference[25]};
            divisor_s16 <= divisor_s15;
            remainder_s17 <= {remainder_s17_choice, 1'd0};
            quotient_s17 <= {quotient_s16, ~remainder_s17_difference[25]};
            divisor_s17 <= divisor_s16;
            remainder_s18 <= {remainder_s18_choice, 1'd0};
            quotient_s18 <= {quotient_s17, ~remainder_s18_difference[25]};
            divisor_s18 <= divisor_s17;
            remainder_s19 <= {remainder_s19_choice, 1'd0};
            quotient_s19 <= {quotient_s18, ~remainder_s19_difference[25]};
            divisor_s19 <= divisor_s18;
            remainder_s20 <= {remainder_s20_choice, 1'd0};
            quotient_s20 <= {quotient_s19, ~remainder_s20_difference[25]};
            divisor_s20 <= divisor_s19;
            remainder_s21 <= {remainder_s21_choice, 1'd0};
            quotient_s21 <= {quotient_s20, ~remainder_s21_difference[25]};
            divisor_s21 <= divisor_s20;
            remainder_s22 <= {remainder_s22_choice, 1'd0};
            quotient_s22 <= {quotient_s21, ~remainder_s22_difference[25]};
            divisor_s22 <= divisor_s21;
            remainder_s23 <= {remainder_s23_choice, 1'd0};
            quotient_s23 <= {quotient_s22, ~remainder_s23_difference[25]};
            divisor_s23 <= divisor_s22;
            remainder_s24 <= {remainder_s24_choice, 1'd0};
            quotient_s24 <= {quotient_s23, ~remainder_s24_difference[25]};
            divisor_s24 <= divisor_s23;
            remainder_s25 <= {remainder_s25_choice, 1'd0};
            quotient_s25 <= {quotient_s24, ~remainder_s25_difference[25]};
            divisor_s25 <= divisor_s24;
            remainder_s26 <= {remainder_s26_choice, 1'd0};
            quotient_s26 <= {quotient_s25, ~remainder_s26_difference[25]};
            exponent_s1 <= ({2'd0, a_field} - {2'd0, b_field}) + 10'd127;
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
            exponent_s19 <= exponent_s18;
            exponent_s20 <= exponent_s19;
            exponent_s21 <= exponent_s20;
            exponent_s22 <= exponent_s21;
            exponent_s23 <= exponent_s22;
            exponent_s24 <= exponent_s23;
            exponent_s25 <= exponent_s24;
            exponent_s26 <= exponent_s25;
            exponent_s27 <= exponent_s26 - {9'd0, ~quotient_s26[25]};
            significand_s27 <= {significand_s27_choice[26:2], |significand_s27_choice[1:0]};
            sign_s1 <= a[31] ^ b[31];
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
            sign_s20 <= sign_s19;
            sign_s21 <= sign_s20;
            sign_s22 <= sign_s21;
            sign_s23 <= sign_s22;
            sign_s24 <= sign_s23;
            sign_s25 <= sign_s24;
            sign_s26 <= sign_s25;
            sign_s27 <= sign_s26;
            nan_s1 <= nan_s1_either | (nan_s1_both & nan_s1_both_2);
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
            nan_s20 <= nan_s19;
            nan_s21 <= nan_s20;
            nan_s22 <= nan_s21;
            nan_s23 <= nan_s22;
            nan_s24 <= nan_s23;
            nan_s25 <= nan_s24;
            nan_s26 <= nan_s25;
            nan_s27 <= nan_s26;
            infinite_s1 <= nan_s1_both | nan_s1_inverted_2;
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
            infinite_s20 <= infinite_s19;
            infinite_s21 <= infinite_s20;
            infinite_s22 <= infinite_s21;
            infinite_s23 <= infinite_s22;
            infinite_s24 <= infinite_s23;
            infinite_s25 <= infinite_s24;
            infinite_s26 <= infinite_s25;
            infinite_s27 <= infinite_s26;
            zero_s1 <= nan_s1_inverted | nan_s1_both_2;
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
            zero_s20 <= zero_s19;
            zero_s21 <= zero_s20;
            zero_s22 <= zero_s21;
            zero_s23 <= zero_s22;
            zero_s24 <= zero_s23;
            zero_s25 <= zero_s24;
            zero_s26 <= zero_s25;
            zero_s27 <= zero_s26;
            y <= nan_s27 ? 32'h7fc00000 : {sign_s27, y_choice_2};
        end
    end

    wire _unused = &{
        1'b0, remainder_s11_difference[24], remainder_s12_difference[24], remainder_s13_difference[24],
        remainder_s14_difference[24], remainder_s15_difference[24], remainder_s16_difference[24],
        remainder_s17_difference[24], remainder_s18_difference[24], remainder_s19_difference[24],
        remainder_s1_difference[24], remainder_s1_minus_divisor_s1[24], remainder_s20_difference[24],
        remainder_s21_difference[24], remainder_s22_difference[24], remainder_s23_difference[24],
        remainder_s24_difference[24], remainder_s25_difference[24], remainder_s26_difference[24],
        remainder_s2_minus_divisor_s2[24], remainder_s3_minus_divisor_s3[24],
        remainder_s4_minus_divisor_s4[24], remainder_s5_minus_divisor_s5[24],
        remainder_s6_minus_divisor_s6[24], remainder_s7_minus_divisor_s7[24],
        remainder_s8_minus_divisor_s8[24], remainder_s9_minus_divisor_s9[24], significand_s27[25]
    };
endmodule

// Fixed to floating point.
// stages = 3
// format = f32-ftz
// width = 10
// fraction = 1
// integer = unsigned
module float_from_fixed_s3_f32ftz_w10_f1_unsigned (
    input  wire clk, input wire enable, input wire [9:0] a,
    output reg  [31:0] y
);
    reg [9:0] magnitude_s1;
    reg [3:0] zeros_s1;
    reg [8:0] exponent_s2;
    reg [25:0] significand_s2;
    reg zero_s1, zero_s2;

    wire not_a_9_and_not_a_8 = ~a[9] & ~a[8];
    wire zeros_s1_both = not_a_9_and_not_a_8 & (~a[7] & ~a[6]);
    wire not_a_5_and_not_a_4 = ~a[5] & ~a[4];
    wire zeros_s1_both_2 = zeros_s1_both & (not_a_5_and_not_a_4 & (~a[3] & ~a[2]));
    wire not_a_1_and_not_a_0 = ~a[1] & ~a[0];
    wire [1:0] zeros_s1_choice = zeros_s1_both ? {not_a_5_and_not_a_4, not_a_5_and_not_a_4 ? ~a[3] : ~a[5]} : {not_a_9_and_not_a_8, not_a_9_and_not_a_8 ? ~a[7] : ~a[9]};
    wire [2:0] zeros_s1_choice_2 = zeros_s1_both_2 ? {1'd0, not_a_1_and_not_a_0, not_a_1_and_not_a_0 ? 1'd0 : ~a[1]} : {zeros_s1_both, zeros_s1_choice};
    wire y_both = (exponent_s2 == 9'd0) & ~(&significand_s2[24:2] & significand_s2[1]);
    wire round_up = significand_s2[1] & (significand_s2[0] | significand_s2[2]);
    wire [30:0] rounded = {exponent_s2[7:0], significand_s2[24:2]} + {30'd0, round_up};
    wire [30:0] y_choice = (~exponent_s2[8] & (9'd255 <= exponent_s2)) ? 31'h7f800000 : rounded;

    always @(posedge clk) begin
        if (enable) begin
            magnitude_s1 <= a;
            zeros_s1 <= {zeros_s1_both_2, zeros_s1_choice_2};
            exponent_s2 <= 9'd135 - {5'd0, zeros_s1};
            significand_s2 <= {magnitude_s1 << zeros_s1, 16'd0};
            zero_s1 <= a == 10'd0;
            zero_s2 <= zero_s1;
            y <= {1'd0, (zero_s2 | (exponent_s2[8] | y_both)) ? 31'd0 : y_choice};
        end
    end

    wire _unused = &{1'b0, significand_s2[25]};
endmodule

// Control of the tile slots: placement, exchange with memory, end of frame.
// slots = 8
module splat_tile_cache (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready,  // Copies in order of tiles.
    input  wire in_end,  // Closes the frame.
    input  wire [2:0] in_left,  // First column.
    input  wire [2:0] in_right,  // Last column.
    input  wire [2:0] in_top,  // First row.
    input  wire [2:0] in_bottom,  // Last row.
    input  wire [3:0] in_first_sum,  // Smallest sum.
    input  wire [3:0] in_last_sum,  // Largest sum.
    input  wire [3:0] in_first_difference,  // Smallest difference.
    input  wire [3:0] in_last_difference,  // Largest difference.
    input  wire [11:0] in_tile,  // Tile index: row above column.
    input  wire [10:0] in_splat,  // Place of its splat's payload.
    output wire out_valid, input wire out_ready,  // Copies with their slots.
    output wire [2:0] out_left,  // First column.
    output wire [2:0] out_right,  // Last column.
    output wire [2:0] out_top,  // First row.
    output wire [2:0] out_bottom,  // Last row.
    output wire [3:0] out_first_sum,  // Smallest sum.
    output wire [3:0] out_last_sum,  // Largest sum.
    output wire [3:0] out_first_difference,  // Smallest difference.
    output wire [3:0] out_last_difference,  // Largest difference.
    output wire [11:0] out_tile,  // Tile index: row above column.
    output wire [10:0] out_splat,  // Place of its splat's payload.
    output wire [2:0] out_slot,  // Slot of the tile cache.
    output wire pixel_valid, input wire pixel_ready,  // Pixels of a finished frame.
    output wire pixel_end,  // Closes the frame.
    output wire [11:0] pixel_tile,  // Tile index.
    output wire [5:0] pixel_pixel,  // Pixel of the tile.
    output wire [27:0] pixel_weight,  // Sum of weights.
    output wire [51:0] pixel_depth,  // Sum of weighted depths.
    output wire [15:0] pixel_peak,  // The largest single weight, with cardinal attributes only.
    output wire [15:0] pixel_attribute_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] pixel_attribute_1,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] pixel_attribute_2,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] pixel_attribute_3,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] pixel_attribute_4,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] pixel_attribute_5,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] pixel_attribute_6,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] pixel_attribute_7,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] pixel_attribute_8,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] pixel_attribute_9,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] pixel_attribute_10,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] pixel_attribute_11,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] pixel_attribute_12,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] pixel_cardinal_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [7:0] slot_ready,  // A bit for each slot that may be accumulated into.
    input  wire retire_valid,  // The accumulator is done with a copy.
    input  wire [2:0] retire_slot,  // Slot of the tile cache.
    input  wire [63:0] masks_written,  // A bit for each pixel that was filled or that a sample came to.
    input  wire [63:0] masks_dirty,  // A bit for each pixel that a sample came to.
    input  wire arrives_valid,  // Copies as they come before they are put in order.
    input  wire arrives_end,  // Closes the frame.
    input  wire [11:0] arrives_tile,  // Tile index: row above column.
    input  wire [10:0] arrives_splat,  // Place of its splat's payload: no other copy for the tile has it before the tile cache has passed this one on.
    output wire full,  // As many frames are under way as there are surfaces: no copy of another may come.
    output wire change_valid,  // A slot gets another tile, until that is carried out in every bank.
    output wire [2:0] change_slot,  // Slot of the tile cache.
    output wire [1:0] change_banks,  // A bit for each bank in which that is to be carried out.
    output wire [63:0] change_held,  // A bit for each pixel that will be filled.
    input  wire [1:0] sample_reads,  // A bit for each bank that a sample may read: no drain and no change of it is carried out.
    input  wire [1:0] sample_writes,  // A bit for each bank that a sample may write in the next cycle: no fill of it is carried out then.
    output wire read_valid, input wire read_ready,  // Request for pixels of a tile.
    output wire read_surface,  // The frame is one of those with odd numbers.
    output wire [11:0] read_tile,  // Tile index.
    output wire [5:0] read_pixel,  // The first pixel of the tile.
    output wire [3:0] read_count,  // How many there are, at least one.
    output wire drain_enable,  // Read of a slot, until it is carried out.
    output wire [2:0] drain_slot,  // Slot of the tile cache.
    output wire [5:0] drain_pixel,  // Pixel of the tile.
    input  wire drained_valid,  // A pixel that was read.
    input  wire [5:0] drained_pixel,  // Pixel of the tile.
    input  wire [27:0] drained_weight,  // Sum of weights.
    input  wire [51:0] drained_depth,  // Sum of weighted depths.
    input  wire [15:0] drained_peak,  // The largest single weight, with cardinal attributes only.
    input  wire [15:0] drained_attribute_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] drained_attribute_1,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] drained_attribute_2,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] drained_attribute_3,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] drained_attribute_4,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] drained_attribute_5,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] drained_attribute_6,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] drained_attribute_7,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] drained_attribute_8,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] drained_attribute_9,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] drained_attribute_10,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] drained_attribute_11,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] drained_attribute_12,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] drained_cardinal_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire write_valid, input wire write_ready,  // Pixels of evicted tiles.
    output wire write_surface,  // The frame is one of those with odd numbers: two have a place in the buffer.
    output wire [11:0] write_tile,  // Tile index.
    output wire [5:0] write_pixel,  // Pixel of the tile.
    output wire [27:0] write_weight,  // Sum of weights.
    output wire [51:0] write_depth,  // Sum of weighted depths.
    output wire [15:0] write_peak,  // The largest single weight, with cardinal attributes only.
    output wire [15:0] write_attribute_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] write_attribute_1,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] write_attribute_2,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] write_attribute_3,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] write_attribute_4,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] write_attribute_5,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] write_attribute_6,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] write_attribute_7,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] write_attribute_8,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] write_attribute_9,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] write_attribute_10,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] write_attribute_11,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] write_attribute_12,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] write_cardinal_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire data_valid, output wire data_ready,  // The pixels requested, in order.
    input  wire [27:0] data_weight,  // Sum of weights.
    input  wire [51:0] data_depth,  // Sum of weighted depths.
    input  wire [15:0] data_peak,  // The largest single weight, with cardinal attributes only.
    input  wire [15:0] data_attribute_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] data_attribute_1,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] data_attribute_2,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] data_attribute_3,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] data_attribute_4,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] data_attribute_5,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] data_attribute_6,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] data_attribute_7,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] data_attribute_8,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] data_attribute_9,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] data_attribute_10,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] data_attribute_11,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] data_attribute_12,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] data_cardinal_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire fill_valid,  // Write to a slot, until it is carried out.
    output wire [2:0] fill_slot,  // Slot of the tile cache.
    output reg  [5:0] fill_pixel,  // Pixel of the tile.
    output reg  [27:0] fill_weight,  // Sum of weights.
    output reg  [51:0] fill_depth,  // Sum of weighted depths.
    output reg  [15:0] fill_peak,  // The largest single weight, with cardinal attributes only.
    output reg  [15:0] fill_attribute_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output reg  [15:0] fill_attribute_1,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output reg  [15:0] fill_attribute_2,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output reg  [15:0] fill_attribute_3,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output reg  [15:0] fill_attribute_4,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output reg  [15:0] fill_attribute_5,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output reg  [15:0] fill_attribute_6,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output reg  [15:0] fill_attribute_7,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output reg  [15:0] fill_attribute_8,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output reg  [15:0] fill_attribute_9,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output reg  [15:0] fill_attribute_10,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output reg  [15:0] fill_attribute_11,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output reg  [15:0] fill_attribute_12,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output reg  [15:0] fill_cardinal_0  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
);
    reg head_valid;
    reg head_end;  // Closes the frame.
    reg [2:0] head_left;  // First column.
    reg [2:0] head_right;  // Last column.
    reg [2:0] head_top;  // First row.
    reg [2:0] head_bottom;  // Last row.
    reg [3:0] head_first_sum;  // Smallest sum.
    reg [3:0] head_last_sum;  // Largest sum.
    reg [3:0] head_first_difference;  // Smallest difference.
    reg [3:0] head_last_difference;  // Largest difference.
    reg [11:0] head_tile;  // Tile index: row above column.
    reg [10:0] head_splat;  // Place of its splat's payload.
    reg clearing, clearing_second;
    reg [12:0] cleared;
    reg surface;
    reg [64:0] mask;
    reg looking, looks_not;
    reg [1:0] unchanged;
    reg changed, keeps, keeps_none, moving;
    reg [2:0] slot;
    reg comes;
    reg [11:0] tile;
    reg goes;
    reg [11:0] goes_tile;
    reg [63:0] wanted_mask;
    reg [7:0] wanted_rows;
    reg [2:0] wanted_row;
    reg [7:0] wanted_left;
    reg any_wanted, wanted_surface;
    reg [11:0] wanted_tile;
    reg wanted_leaves;
    reg [5:0] awaited_fills, awaited_leaving;
    reg [2:0] came;
    reg filling, fills_none;
    reg [1:0] taken_banks;
    reg [63:0] leaving_mask;
    reg [7:0] leaving_rows;
    reg [2:0] leaving_row;
    reg [7:0] leaving_left;
    reg any_leaving;
    reg [3:0] owed;
    reg [2:0] next;
    reg [11:0] tile_0;
    reg resident_0, ready_0;
    reg [7:0] in_flight_0;
    reg used_0, is_of_copy_0;
    reg [11:0] tile_1;
    reg resident_1, ready_1;
    reg [7:0] in_flight_1;
    reg used_1, is_of_copy_1;
    reg [11:0] tile_2;
    reg resident_2, ready_2;
    reg [7:0] in_flight_2;
    reg used_2, is_of_copy_2;
    reg [11:0] tile_3;
    reg resident_3, ready_3;
    reg [7:0] in_flight_3;
    reg used_3, is_of_copy_3;
    reg [11:0] tile_4;
    reg resident_4, ready_4;
    reg [7:0] in_flight_4;
    reg used_4, is_of_copy_4;
    reg [11:0] tile_5;
    reg resident_5, ready_5;
    reg [7:0] in_flight_5;
    reg used_5, is_of_copy_5;
    reg [11:0] tile_6;
    reg resident_6, ready_6;
    reg [7:0] in_flight_6;
    reg used_6, is_of_copy_6;
    reg [11:0] tile_7;
    reg resident_7, ready_7;
    reg [7:0] in_flight_7;
    reg used_7, is_of_copy_7, next_idle, turn_is_new, frame_leaves, frame_is_given;
    reg [11:0] next_place;
    reg any_next_place;
    reg [11:0] looked_at;
    reg look_reads, look_is_shown, look_is_seen;
    reg [64:0] seen_mask;
    reg seen_stays, missed, head_empty;
    wire any_is_stored;
    wire [63:0] stored_mask;
    reg arrived;
    reg arrived_end;  // Closes the frame.
    reg [11:0] arrived_tile;  // Tile index: row above column.
    reg [10:0] arrived_splat;  // Place of its splat's payload: no other copy for the tile has it before the tile cache has passed this one on.
    reg arriving_surface;
    reg [1:0] whole_frames;
    wire [11:0] last_copy;
    reg looked_up, compared;
    reg found_valid;  // Copies are still to come.
    reg [10:0] found_splat;  // The splat of the last one that came.
    reg overtaken, forgets;
    reg [12:0] forgotten;

    wire in_queue_out_valid;
    wire [51:0] in_queue_out_data;
    wire out_queue_in_ready;
    wire [53:0] out_queue_out_data;
    wire pixel_queue_in_ready;
    wire [338:0] pixel_queue_out_data;
    wire gone_tiles_in_ready, gone_tiles_out_valid;
    wire [11:0] gone_tiles_out_data;
    wire read_queue_in_ready;
    wire [22:0] read_queue_out_data;
    wire asked_runs_in_ready, asked_runs_out_valid;
    wire [22:0] asked_runs_out_data;
    wire write_queue_in_ready;
    wire [338:0] write_queue_out_data;

    wire frame_is_whole = arrived & arrived_end;
    wire full_either = clearing | (clearing_second & (arriving_surface | frame_is_whole));
    wire [63:0] mask_that_comes = {64{comes}} & mask[63:0];
    wire offers_drain = moving & (|leaving_left & ~(owed == 4'd8));
    wire leaving_place_both = leaving_left[1] & ~leaving_left[0];
    wire leaving_place_either = leaving_left[0] | leaving_left[1];
    wire leaving_place_both_2 = leaving_left[2] & ~leaving_place_either;
    wire [2:0] leaving_place_either_2 = ({3{leaving_place_both}} & 3'd1) | ({3{leaving_place_both_2}} & 3'd2);
    wire leaving_place_either_3 = leaving_place_either | leaving_left[2];
    wire leaving_place_both_3 = leaving_left[3] & ~leaving_place_either_3;
    wire leaving_place_either_4 = leaving_place_either_3 | leaving_left[3];
    wire leaving_place_both_4 = leaving_left[4] & ~leaving_place_either_4;
    wire [2:0] leaving_place_either_5 = leaving_place_either_2 | ({3{leaving_place_both_3}} & 3'd3) | ({3{leaving_place_both_4}} & 3'd4);
    wire leaving_place_either_6 = leaving_place_either_4 | leaving_left[4];
    wire leaving_place_both_5 = leaving_left[5] & ~leaving_place_either_6;
    wire leaving_place_either_7 = leaving_place_either_6 | leaving_left[5];
    wire leaving_place_both_6 = leaving_left[6] & ~leaving_place_either_7;
    wire [2:0] leaving_place_either_8 = leaving_place_either_5 | ({3{leaving_place_both_5}} & 3'd5) | ({3{leaving_place_both_6}} & 3'd6);
    wire leaving_place_both_7 = leaving_left[7] & ~(leaving_place_either_7 | leaving_left[6]);
    wire [2:0] leaving_place = leaving_place_either_8 | {3{leaving_place_both_7}};
    wire asked_runs_out_leaves = asked_runs_out_data[22];
    wire [5:0] asked_runs_out_pixel = asked_runs_out_data[9:4];
    wire may_fill_either = ~any_leaving | (|leaving_left & (asked_runs_out_pixel[5:3] < leaving_row));
    wire [1:0] may_fill_shifted = taken_banks >> fill_pixel[0];
    wire may_fill = moving & may_fill_either & (fills_none | ~may_fill_shifted[0]);
    wire takes_data = asked_runs_out_valid & (asked_runs_out_leaves ? pixel_queue_in_ready : may_fill);
    wire word_is_cleared_both = clearing_second & ~(changed | look_is_seen | (arrived | forgets));
    wire word_is_cleared = clearing | word_is_cleared_both;
    wire may_leave = seen_mask[64] & ~seen_stays;
    wire end_waits_either = looking | |unchanged;
    wire sends = look_is_seen & may_leave & (~any_wanted & ~(end_waits_either | missed) & keeps_none);
    wire stored_masks_write_either = ~keeps_none | word_is_cleared | sends;
    wire surface_xor_frame_is_given = surface ^ frame_is_given;
    wire [12:0] stored_masks_address_bits = {surface_xor_frame_is_given, looked_at};
    wire [12:0] stored_masks_address_choice = word_is_cleared ? cleared : keeps_none ? stored_masks_address_bits : {surface, goes_tile};
    wire head_waits = head_valid & ~clearing;
    wire head_waits_and_not_head_end = head_waits & ~head_end;
    wire [7:0] copy_hit_bits = {
        is_of_copy_0, is_of_copy_1, is_of_copy_2, is_of_copy_3, is_of_copy_4, is_of_copy_5, is_of_copy_6,
        is_of_copy_7
    };
    wire copy_hit = |copy_hit_bits;
    wire end_waits_either_2 = end_waits_either | (changed | moving);
    wire not_end_waits_either_2 = ~end_waits_either_2;
    wire misses = head_waits_and_not_head_end & ~copy_hit & (not_end_waits_either_2 & next_idle);
    wire [12:0] any_is_stored_address_choice = misses ? {surface, head_tile} : stored_masks_address_bits;
    wire copy_enters = arrived & ~arrived_end;
    wire look_is_read_both = head_empty & in_queue_out_valid;
    wire [11:0] in_queue_out_tile = in_queue_out_data[22:11];
    wire send_either = (is_of_copy_0 & &in_flight_0) | (is_of_copy_1 & &in_flight_1) | (is_of_copy_2 & &in_flight_2);
    wire send_either_2 = send_either | (is_of_copy_3 & &in_flight_3) | (is_of_copy_4 & &in_flight_4);
    wire send_either_3 = send_either_2 | (is_of_copy_5 & &in_flight_5) | (is_of_copy_6 & &in_flight_6);
    wire send_both = out_queue_in_ready & ~(send_either_3 | (is_of_copy_7 & &in_flight_7));
    wire send = head_waits_and_not_head_end & (copy_hit & send_both);
    wire [2:0] copy_slot_either = ({3{is_of_copy_1}} & 3'd1) | ({3{is_of_copy_2}} & 3'd2) | ({3{is_of_copy_3}} & 3'd3);
    wire [2:0] copy_slot_either_2 = copy_slot_either | ({3{is_of_copy_4}} & 3'd4) | ({3{is_of_copy_5}} & 3'd5);
    wire [2:0] copy_slot = copy_slot_either_2 | ({3{is_of_copy_6}} & 3'd6) | {3{is_of_copy_7}};
    wire looks_at_none = ~(look_reads | (look_is_shown | look_is_seen));
    wire frame_leaves_and_looks_at_none = frame_leaves & looks_at_none;
    wire closes_both = frame_leaves_and_looks_at_none & (frame_is_given & ~any_next_place & ~gone_tiles_out_valid);
    wire closes_both_2 = ~(wanted_leaves & any_wanted) & (awaited_leaving == 6'd0) & pixel_queue_in_ready;
    wire closes = closes_both & closes_both_2;
    wire beat = takes_data & data_valid;
    wire visible = asked_runs_out_leaves & beat & |data_weight;
    wire [11:0] asked_runs_out_tile = asked_runs_out_data[21:10];
    wire [5:0] coming_pixel = asked_runs_out_pixel + {3'd0, came};
    wire done_both = (wanted_leaves | ~any_wanted) & (awaited_fills == 6'd0) & (~filling & (gone_tiles_in_ready | ~goes));
    wire done = moving & (~any_leaving & (owed == 4'd0) & done_both);
    wire draws_what_leaves = frame_leaves & ~frame_is_given;
    wire looks = frame_leaves_and_looks_at_none | (sends | (look_is_seen & ~may_leave));
    wire asks = |wanted_left & (read_queue_in_ready & asked_runs_in_ready);
    wire wanted_place_both = wanted_left[1] & ~wanted_left[0];
    wire wanted_left_0_or_wanted_left_1 = wanted_left[0] | wanted_left[1];
    wire wanted_place_both_2 = wanted_left[2] & ~wanted_left_0_or_wanted_left_1;
    wire [2:0] wanted_place_either = ({3{wanted_place_both}} & 3'd1) | ({3{wanted_place_both_2}} & 3'd2);
    wire wanted_place_either_2 = wanted_left_0_or_wanted_left_1 | wanted_left[2];
    wire wanted_place_both_3 = wanted_left[3] & ~wanted_place_either_2;
    wire wanted_place_either_3 = wanted_place_either_2 | wanted_left[3];
    wire wanted_place_both_4 = wanted_left[4] & ~wanted_place_either_3;
    wire [2:0] wanted_place_either_4 = wanted_place_either | ({3{wanted_place_both_3}} & 3'd3) | ({3{wanted_place_both_4}} & 3'd4);
    wire wanted_place_either_5 = wanted_place_either_3 | wanted_left[4];
    wire wanted_place_both_5 = wanted_left[5] & ~wanted_place_either_5;
    wire wanted_place_either_6 = wanted_place_either_5 | wanted_left[5];
    wire wanted_place_both_6 = wanted_left[6] & ~wanted_place_either_6;
    wire [2:0] wanted_place_either_7 = wanted_place_either_4 | ({3{wanted_place_both_5}} & 3'd5) | ({3{wanted_place_both_6}} & 3'd6);
    wire wanted_place_both_7 = wanted_left[7] & ~(wanted_place_either_6 | wanted_left[6]);
    wire [2:0] wanted_place = wanted_place_either_7 | {3{wanted_place_both_7}};
    wire wanted_count_both = wanted_left[1] & (wanted_place_both | wanted_left[0]);
    wire wanted_count_both_2 = wanted_left[2] & (wanted_place_both_2 | wanted_count_both);
    wire [3:0] wanted_count_either = ({4{wanted_left[0] & ~wanted_count_both}} & 4'd1) | ({4{wanted_count_both & ~wanted_count_both_2}} & 4'd2);
    wire wanted_count_both_3 = wanted_left[3] & (wanted_place_both_3 | wanted_count_both_2);
    wire [3:0] wanted_count_either_2 = wanted_count_either | ({4{wanted_count_both_2 & ~wanted_count_both_3}} & 4'd3);
    wire wanted_count_both_4 = wanted_left[4] & (wanted_place_both_4 | wanted_count_both_3);
    wire [3:0] wanted_count_either_3 = wanted_count_either_2 | ({4{wanted_count_both_3 & ~wanted_count_both_4}} & 4'd4);
    wire wanted_count_both_5 = wanted_left[5] & (wanted_place_both_5 | wanted_count_both_4);
    wire [3:0] wanted_count_either_4 = wanted_count_either_3 | ({4{wanted_count_both_4 & ~wanted_count_both_5}} & 4'd5);
    wire wanted_count_both_6 = wanted_left[6] & (wanted_place_both_6 | wanted_count_both_5);
    wire [3:0] wanted_count_either_5 = wanted_count_either_4 | ({4{wanted_count_both_5 & ~wanted_count_both_6}} & 4'd6);
    wire wanted_count_both_7 = wanted_left[7] & (wanted_place_both_7 | wanted_count_both_6);
    wire [3:0] wanted_count_either_6 = wanted_count_either_5 | ({4{wanted_count_both_6 & ~wanted_count_both_7}} & 4'd7);
    wire [3:0] wanted_count = (wanted_count_either_6 | ({4{wanted_count_both_7}} & 4'd8)) - {1'd0, wanted_place};
    wire [3:0] came_now = {1'd0, came} + 4'd1;
    wire [3:0] asked_runs_out_count = asked_runs_out_data[3:0];
    wire run_ends = beat & (came_now == asked_runs_out_count);
    wire end_waits = head_waits & head_end & not_end_waits_either_2;
    wire [7:0] any_resident_bits = {resident_0, resident_1, resident_2, resident_3, resident_4, resident_5, resident_6, resident_7};
    wire any_resident = |any_resident_bits;
    wire switches = end_waits & draws_what_leaves & ~any_resident;
    wire head_valid_choice = head_valid ? ~(send | switches) : in_queue_out_valid;
    wire in_queue_out_end = in_queue_out_data[51];
    wire [2:0] in_queue_out_left = in_queue_out_data[50:48];
    wire [2:0] in_queue_out_right = in_queue_out_data[47:45];
    wire [2:0] in_queue_out_top = in_queue_out_data[44:42];
    wire [2:0] in_queue_out_bottom = in_queue_out_data[41:39];
    wire [3:0] in_queue_out_first_sum = in_queue_out_data[38:35];
    wire [3:0] in_queue_out_last_sum = in_queue_out_data[34:31];
    wire [3:0] in_queue_out_first_difference = in_queue_out_data[30:27];
    wire [3:0] in_queue_out_last_difference = in_queue_out_data[26:23];
    wire [10:0] in_queue_out_splat = in_queue_out_data[10:0];
    wire [12:0] cleared_plus_1 = cleared + 13'd1;
    wire start = misses & (~any_wanted & ~sends);
    wire next_is_0 = next == 3'd0;
    wire next_is_1 = next == 3'd1;
    wire next_is_2 = next == 3'd2;
    wire goes_either = (next_is_0 & resident_0) | (next_is_1 & resident_1) | (next_is_2 & resident_2);
    wire next_is_3 = next == 3'd3;
    wire next_is_4 = next == 3'd4;
    wire goes_either_2 = goes_either | (next_is_3 & resident_3) | (next_is_4 & resident_4);
    wire next_is_5 = next == 3'd5;
    wire next_is_6 = next == 3'd6;
    wire goes_either_3 = goes_either_2 | (next_is_5 & resident_5) | (next_is_6 & resident_6);
    wire next_is_7 = next == 3'd7;
    wire goes_either_4 = goes_either_3 | (next_is_7 & resident_7);
    wire vacate = end_waits & (goes_either_4 & next_idle);
    wire job_starts = start | vacate;
    wire [1:0] still_unchanged = unchanged & sample_reads;
    wire change = |unchanged & (still_unchanged == 2'd0);
    wire change_and_goes = change & goes;
    wire [11:0] goes_tile_either = ({12{next_is_0}} & tile_0) | ({12{next_is_1}} & tile_1) | ({12{next_is_2}} & tile_2);
    wire [11:0] goes_tile_either_2 = goes_tile_either | ({12{next_is_3}} & tile_3) | ({12{next_is_4}} & tile_4);
    wire [11:0] goes_tile_either_3 = goes_tile_either_2 | ({12{next_is_5}} & tile_5) | ({12{next_is_6}} & tile_6);
    wire fills_are_wanted = change & comes;
    wire begins = sends | fills_are_wanted;
    wire [64:0] wanted_mask_choice = sends ? seen_mask : mask;
    wire [7:0] wanted_run = {
        wanted_count_both_7, wanted_count_both_6, wanted_count_both_5, wanted_count_both_4,
        wanted_count_both_3, wanted_count_both_2, wanted_count_both, wanted_left[0]
    };
    wire [7:0] wanted_left_both = wanted_left & ~({8{asks}} & wanted_run);
    wire wanted_row_ends = wanted_left_both == 8'd0;
    wire [7:0] wanted_rows_bits = {
        |wanted_mask_choice[63:56], |wanted_mask_choice[55:48], |wanted_mask_choice[47:40],
        |wanted_mask_choice[39:32], |wanted_mask_choice[31:24], |wanted_mask_choice[23:16],
        |wanted_mask_choice[15:8], |wanted_mask_choice[7:0]
    };
    wire wanted_rows_0_or_wanted_rows_1 = wanted_rows[0] | wanted_rows[1];
    wire wanted_row_either = wanted_rows_0_or_wanted_rows_1 | wanted_rows[2];
    wire wanted_row_either_2 = wanted_row_either | wanted_rows[3];
    wire wanted_row_either_3 = wanted_row_either_2 | wanted_rows[4];
    wire wanted_row_either_4 = wanted_row_either_3 | wanted_rows[5];
    wire wanted_row_both = wanted_rows[7] & ~(wanted_row_either_4 | wanted_rows[6]);
    wire wanted_row_both_2 = wanted_rows[6] & ~wanted_row_either_4;
    wire wanted_row_both_3 = wanted_rows[5] & ~wanted_row_either_3;
    wire wanted_row_both_4 = wanted_rows[4] & ~wanted_row_either_2;
    wire wanted_row_both_5 = wanted_rows[3] & ~wanted_row_either;
    wire wanted_row_both_6 = wanted_rows[2] & ~wanted_rows_0_or_wanted_rows_1;
    wire wanted_row_both_7 = wanted_rows[1] & ~wanted_rows[0];
    wire [7:0] wanted_rows_bits_2 = {
        wanted_row_both, wanted_row_both_2, wanted_row_both_3, wanted_row_both_4, wanted_row_both_5,
        wanted_row_both_6, wanted_row_both_7, wanted_rows[0]
    };
    wire [2:0] wanted_row_either_5 = ({3{wanted_row_both_7}} & 3'd1) | ({3{wanted_row_both_6}} & 3'd2);
    wire [2:0] wanted_row_either_6 = wanted_row_either_5 | ({3{wanted_row_both_5}} & 3'd3) | ({3{wanted_row_both_4}} & 3'd4);
    wire [2:0] wanted_row_either_7 = wanted_row_either_6 | ({3{wanted_row_both_3}} & 3'd5) | ({3{wanted_row_both_2}} & 3'd6);
    wire [7:0] wanted_left_either = ({8{wanted_rows[0]}} & wanted_mask[7:0]) | ({8{wanted_row_both_7}} & wanted_mask[15:8]);
    wire [7:0] wanted_left_either_2 = wanted_left_either | ({8{wanted_row_both_6}} & wanted_mask[23:16]);
    wire [7:0] wanted_left_either_3 = wanted_left_either_2 | ({8{wanted_row_both_5}} & wanted_mask[31:24]);
    wire [7:0] wanted_left_either_4 = wanted_left_either_3 | ({8{wanted_row_both_4}} & wanted_mask[39:32]);
    wire [7:0] wanted_left_either_5 = wanted_left_either_4 | ({8{wanted_row_both_3}} & wanted_mask[47:40]);
    wire [7:0] wanted_left_either_6 = wanted_left_either_5 | ({8{wanted_row_both_2}} & wanted_mask[55:48]);
    wire [7:0] wanted_left_either_7 = wanted_left_either_6 | ({8{wanted_row_both}} & wanted_mask[63:56]);
    wire fills = filling & ~may_fill_shifted[0];
    wire filling_either = (beat & ~asked_runs_out_leaves) | (filling & ~fills);
    wire [1:0] drains_shifted = sample_reads >> leaving_place[0];
    wire drains = offers_drain & ~drains_shifted[0];
    wire [7:0] leaving_left_bits = {
        leaving_place_both_7, leaving_place_both_6, leaving_place_both_5, leaving_place_both_4,
        leaving_place_both_3, leaving_place_both_2, leaving_place_both, leaving_left[0]
    };
    wire [7:0] leaving_left_both = leaving_left & ~({8{drains}} & leaving_left_bits);
    wire leaving_row_ends = leaving_left_both == 8'd0;
    wire [7:0] leaving_rows_bits = {
        |masks_dirty[63:56], |masks_dirty[55:48], |masks_dirty[47:40], |masks_dirty[39:32],
        |masks_dirty[31:24], |masks_dirty[23:16], |masks_dirty[15:8], |masks_dirty[7:0]
    };
    wire leaving_row_either = leaving_rows[0] | leaving_rows[1];
    wire leaving_row_either_2 = leaving_row_either | leaving_rows[2];
    wire leaving_row_either_3 = leaving_row_either_2 | leaving_rows[3];
    wire leaving_row_either_4 = leaving_row_either_3 | leaving_rows[4];
    wire leaving_row_either_5 = leaving_row_either_4 | leaving_rows[5];
    wire leaving_row_both = leaving_rows[7] & ~(leaving_row_either_5 | leaving_rows[6]);
    wire leaving_row_both_2 = leaving_rows[6] & ~leaving_row_either_5;
    wire leaving_row_both_3 = leaving_rows[5] & ~leaving_row_either_4;
    wire leaving_row_both_4 = leaving_rows[4] & ~leaving_row_either_3;
    wire leaving_row_both_5 = leaving_rows[3] & ~leaving_row_either_2;
    wire leaving_row_both_6 = leaving_rows[2] & ~leaving_row_either;
    wire leaving_row_both_7 = leaving_rows[1] & ~leaving_rows[0];
    wire [7:0] leaving_rows_bits_2 = {
        leaving_row_both, leaving_row_both_2, leaving_row_both_3, leaving_row_both_4, leaving_row_both_5,
        leaving_row_both_6, leaving_row_both_7, leaving_rows[0]
    };
    wire [2:0] leaving_row_either_6 = ({3{leaving_row_both_7}} & 3'd1) | ({3{leaving_row_both_6}} & 3'd2);
    wire [2:0] leaving_row_either_7 = leaving_row_either_6 | ({3{leaving_row_both_5}} & 3'd3) | ({3{leaving_row_both_4}} & 3'd4);
    wire [2:0] leaving_row_either_8 = leaving_row_either_7 | ({3{leaving_row_both_3}} & 3'd5) | ({3{leaving_row_both_2}} & 3'd6);
    wire [7:0] leaving_left_either = ({8{leaving_rows[0]}} & leaving_mask[7:0]) | ({8{leaving_row_both_7}} & leaving_mask[15:8]);
    wire [7:0] leaving_left_either_2 = leaving_left_either | ({8{leaving_row_both_6}} & leaving_mask[23:16]);
    wire [7:0] leaving_left_either_3 = leaving_left_either_2 | ({8{leaving_row_both_5}} & leaving_mask[31:24]);
    wire [7:0] leaving_left_either_4 = leaving_left_either_3 | ({8{leaving_row_both_4}} & leaving_mask[39:32]);
    wire [7:0] leaving_left_either_5 = leaving_left_either_4 | ({8{leaving_row_both_3}} & leaving_mask[47:40]);
    wire [7:0] leaving_left_either_6 = leaving_left_either_5 | ({8{leaving_row_both_2}} & leaving_mask[55:48]);
    wire [7:0] leaving_left_either_7 = leaving_left_either_6 | ({8{leaving_row_both}} & leaving_mask[63:56]);
    wire pixel_leaves = write_valid & write_ready;
    wire starts = job_starts;
    wire skips_either = (next_is_0 & used_0) | (next_is_1 & used_1) | (next_is_2 & used_2);
    wire skips_either_2 = skips_either | (next_is_3 & used_3) | (next_is_4 & used_4) | (next_is_5 & used_5);
    wire skips = skips_either_2 | (next_is_6 & used_6) | (next_is_7 & used_7);
    wire turns = starts | skips | (end_waits & ~(switches | (turn_is_new & goes_either_4)));
    wire start_and_next_is_0 = start & next_is_0;
    wire starts_and_next_is_0 = starts & next_is_0;
    wire done_and_comes = done & comes;
    wire ready_0_both = done_and_comes & (slot == 3'd0);
    wire in_flight_0_both = send & (copy_slot == 3'd0);
    wire in_flight_0_enable_both = retire_valid & (retire_slot == 3'd0);
    wire not_starts_and_next_is_0 = ~starts_and_next_is_0;
    wire is_of_copy_0_both = resident_0 & not_starts_and_next_is_0 & (tile_0 == in_queue_out_tile);
    wire start_and_next_is_1 = start & next_is_1;
    wire starts_and_next_is_1 = starts & next_is_1;
    wire ready_1_both = done_and_comes & (slot == 3'd1);
    wire in_flight_1_both = send & (copy_slot == 3'd1);
    wire in_flight_1_enable_both = retire_valid & (retire_slot == 3'd1);
    wire not_starts_and_next_is_1 = ~starts_and_next_is_1;
    wire is_of_copy_1_both = resident_1 & not_starts_and_next_is_1 & (tile_1 == in_queue_out_tile);
    wire start_and_next_is_2 = start & next_is_2;
    wire starts_and_next_is_2 = starts & next_is_2;
    wire ready_2_both = done_and_comes & (slot == 3'd2);
    wire in_flight_2_both = send & (copy_slot == 3'd2);
    wire in_flight_2_enable_both = retire_valid & (retire_slot == 3'd2);
    wire not_starts_and_next_is_2 = ~starts_and_next_is_2;
    wire is_of_copy_2_both = resident_2 & not_starts_and_next_is_2 & (tile_2 == in_queue_out_tile);
    wire start_and_next_is_3 = start & next_is_3;
    wire starts_and_next_is_3 = starts & next_is_3;
    wire ready_3_both = done_and_comes & (slot == 3'd3);
    wire in_flight_3_both = send & (copy_slot == 3'd3);
    wire in_flight_3_enable_both = retire_valid & (retire_slot == 3'd3);
    wire not_starts_and_next_is_3 = ~starts_and_next_is_3;
    wire is_of_copy_3_both = resident_3 & not_starts_and_next_is_3 & (tile_3 == in_queue_out_tile);
    wire start_and_next_is_4 = start & next_is_4;
    wire starts_and_next_is_4 = starts & next_is_4;
    wire ready_4_both = done_and_comes & (slot == 3'd4);
    wire in_flight_4_both = send & (copy_slot == 3'd4);
    wire in_flight_4_enable_both = retire_valid & (retire_slot == 3'd4);
    wire not_starts_and_next_is_4 = ~starts_and_next_is_4;
    wire is_of_copy_4_both = resident_4 & not_starts_and_next_is_4 & (tile_4 == in_queue_out_tile);
    wire start_and_next_is_5 = start & next_is_5;
    wire starts_and_next_is_5 = starts & next_is_5;
    wire ready_5_both = done_and_comes & (slot == 3'd5);
    wire in_flight_5_both = send & (copy_slot == 3'd5);
    wire in_flight_5_enable_both = retire_valid & (retire_slot == 3'd5);
    wire not_starts_and_next_is_5 = ~starts_and_next_is_5;
    wire is_of_copy_5_both = resident_5 & not_starts_and_next_is_5 & (tile_5 == in_queue_out_tile);
    wire start_and_next_is_6 = start & next_is_6;
    wire starts_and_next_is_6 = starts & next_is_6;
    wire ready_6_both = done_and_comes & (slot == 3'd6);
    wire in_flight_6_both = send & (copy_slot == 3'd6);
    wire in_flight_6_enable_both = retire_valid & (retire_slot == 3'd6);
    wire not_starts_and_next_is_6 = ~starts_and_next_is_6;
    wire is_of_copy_6_both = resident_6 & not_starts_and_next_is_6 & (tile_6 == in_queue_out_tile);
    wire start_and_next_is_7 = start & next_is_7;
    wire starts_and_next_is_7 = starts & next_is_7;
    wire ready_7_both = done_and_comes & (slot == 3'd7);
    wire in_flight_7_both = send & (copy_slot == 3'd7);
    wire in_flight_7_enable_both = retire_valid & (retire_slot == 3'd7);
    wire not_starts_and_next_is_7 = ~starts_and_next_is_7;
    wire is_of_copy_7_both = resident_7 & not_starts_and_next_is_7 & (tile_7 == in_queue_out_tile);
    wire next_idle_either = (in_flight_0 == 8'd0) | ((in_flight_0 == 8'd1) & in_flight_0_enable_both);
    wire next_idle_either_2 = (in_flight_1 == 8'd0) | ((in_flight_1 == 8'd1) & in_flight_1_enable_both);
    wire next_idle_either_3 = (next_is_0 & (next_idle_either & ~(in_flight_0_both | used_0))) | (next_is_1 & (next_idle_either_2 & ~(in_flight_1_both | used_1)));
    wire next_idle_either_4 = (in_flight_2 == 8'd0) | ((in_flight_2 == 8'd1) & in_flight_2_enable_both);
    wire next_idle_either_5 = next_idle_either_3 | (next_is_2 & (next_idle_either_4 & ~(in_flight_2_both | used_2)));
    wire next_idle_either_6 = (in_flight_3 == 8'd0) | ((in_flight_3 == 8'd1) & in_flight_3_enable_both);
    wire next_idle_either_7 = next_idle_either_5 | (next_is_3 & (next_idle_either_6 & ~(in_flight_3_both | used_3)));
    wire next_idle_either_8 = (in_flight_4 == 8'd0) | ((in_flight_4 == 8'd1) & in_flight_4_enable_both);
    wire next_idle_either_9 = next_idle_either_7 | (next_is_4 & (next_idle_either_8 & ~(in_flight_4_both | used_4)));
    wire next_idle_either_10 = (in_flight_5 == 8'd0) | ((in_flight_5 == 8'd1) & in_flight_5_enable_both);
    wire next_idle_either_11 = next_idle_either_9 | (next_is_5 & (next_idle_either_10 & ~(in_flight_5_both | used_5)));
    wire next_idle_either_12 = (in_flight_6 == 8'd0) | ((in_flight_6 == 8'd1) & in_flight_6_enable_both);
    wire next_idle_either_13 = next_idle_either_11 | (next_is_6 & (next_idle_either_12 & ~(in_flight_6_both | used_6)));
    wire next_idle_either_14 = (in_flight_7 == 8'd0) | ((in_flight_7 == 8'd1) & in_flight_7_enable_both);
    wire next_idle_either_15 = next_idle_either_13 | (next_is_7 & (next_idle_either_14 & ~(in_flight_7_both | used_7)));
    wire frame_begins_to_leave = |whole_frames & ~frame_leaves;
    wire looks_at_next = looks & ~gone_tiles_out_valid & any_next_place;
    wire next_place_enable_either = frame_begins_to_leave | looks_at_next;
    wire look_is_read = look_reads & ~(look_is_read_both | (misses | vacate));
    wire [7:0] seen_stays_bits = {
        resident_0 & (tile_0 == looked_at), resident_1 & (tile_1 == looked_at),
        resident_2 & (tile_2 == looked_at), resident_3 & (tile_3 == looked_at),
        resident_4 & (tile_4 == looked_at), resident_5 & (tile_5 == looked_at),
        resident_6 & (tile_6 == looked_at), resident_7 & (tile_7 == looked_at)
    };
    wire seen_stays_either = |seen_stays_bits | (head_valid & ~head_end & (head_tile == looked_at));
    wire seen_stays_either_2 = seen_stays_either | (goes & end_waits_either_2 & (goes_tile == looked_at));
    wire overtaken_both = copy_enters & ({arriving_surface, arrived_tile} == {surface, in_queue_out_tile});
    wire overtaken_both_2 = copy_enters & ({arriving_surface, arrived_tile} == {surface, head_tile});
    wire overtaken_or_overtaken_both_2 = overtaken | overtaken_both_2;
    wire last_reached = compared & (found_valid & (found_splat == head_splat)) & ~overtaken_or_overtaken_both_2;
    wire forgets_both = forgets & (copy_enters & ({arriving_surface, arrived_tile} != forgotten));
    wire fill_is_free = ~filling | fills;

    assign {
        out_left, out_right, out_top, out_bottom, out_first_sum, out_last_sum, out_first_difference,
        out_last_difference, out_tile, out_splat, out_slot
    } = out_queue_out_data;
    assign {
        pixel_end, pixel_tile, pixel_pixel, pixel_weight, pixel_depth, pixel_peak, pixel_attribute_0,
        pixel_attribute_1, pixel_attribute_2, pixel_attribute_3, pixel_attribute_4, pixel_attribute_5,
        pixel_attribute_6, pixel_attribute_7, pixel_attribute_8, pixel_attribute_9, pixel_attribute_10,
        pixel_attribute_11, pixel_attribute_12, pixel_cardinal_0
    } = pixel_queue_out_data;
    assign slot_ready = {ready_7, ready_6, ready_5, ready_4, ready_3, ready_2, ready_1, ready_0};
    assign full = full_either | (whole_frames[1] | (whole_frames[0] & frame_is_given));
    assign change_valid = |unchanged;
    assign change_slot = slot;
    assign change_banks = unchanged;
    assign change_held = mask_that_comes;
    assign {read_surface, read_tile, read_pixel, read_count} = read_queue_out_data;
    assign drain_enable = offers_drain;
    assign drain_slot = slot;
    assign drain_pixel = {leaving_row, leaving_place};
    assign {
        write_surface, write_tile, write_pixel, write_weight, write_depth, write_peak, write_attribute_0,
        write_attribute_1, write_attribute_2, write_attribute_3, write_attribute_4, write_attribute_5,
        write_attribute_6, write_attribute_7, write_attribute_8, write_attribute_9, write_attribute_10,
        write_attribute_11, write_attribute_12, write_cardinal_0
    } = write_queue_out_data;
    assign data_ready = takes_data;
    assign fill_valid = filling;
    assign fill_slot = slot;

    memory_1w1r_unordered #(.WIDTH(64), .DEPTH(8192)) stored_masks (
        .clk(clk), .write(stored_masks_write_either), .write_address(stored_masks_address_choice),
        .write_data({64{keeps}} & masks_written),
        .read(1'd1), .read_address(any_is_stored_address_choice), .read_data(stored_mask)
    );

    memory_1w1r_unordered #(.WIDTH(1), .DEPTH(8192)) stored_any (
        .clk(clk), .write(stored_masks_write_either), .write_address(stored_masks_address_choice),
        .write_data(keeps & |masks_written),
        .read(1'd1), .read_address(any_is_stored_address_choice), .read_data(any_is_stored)
    );

    memory_1w1r_unordered #(.WIDTH(12), .DEPTH(8192)) last_copies (
        .clk(clk), .write(word_is_cleared | (copy_enters | forgets)),
        .write_address(word_is_cleared ? cleared : copy_enters ? {arriving_surface, arrived_tile} : forgotten),
        .write_data({copy_enters & ~word_is_cleared, arrived_splat}),
        .read(1'd1),
        .read_address(look_is_read_both ? {surface, in_queue_out_tile} : stored_masks_address_bits),
        .read_data(last_copy)
    );

    stream_half_buffer_w52 in_queue (
        .clk(clk), .rst(rst), .in_valid(in_valid), .in_ready(in_ready),
        .in_data({
            in_end, in_left, in_right, in_top, in_bottom, in_first_sum, in_last_sum, in_first_difference,
            in_last_difference, in_tile, in_splat
        }),
        .out_valid(in_queue_out_valid), .out_ready(head_empty), .out_data(in_queue_out_data)
    );

    stream_fifo_d16_w54_distributed out_queue (
        .clk(clk), .rst(rst), .in_valid(send), .in_ready(out_queue_in_ready),
        .in_data({
            head_left, head_right, head_top, head_bottom, head_first_sum, head_last_sum, head_first_difference,
            head_last_difference, head_tile, head_splat, copy_slot
        }),
        .out_valid(out_valid), .out_ready(out_ready), .out_data(out_queue_out_data)
    );

    stream_skid_w339 pixel_queue (
        .clk(clk), .rst(rst), .in_valid(closes | visible), .in_ready(pixel_queue_in_ready),
        .in_data({
            closes, asked_runs_out_tile, coming_pixel, data_weight, data_depth, data_peak, data_attribute_0,
            data_attribute_1, data_attribute_2, data_attribute_3, data_attribute_4, data_attribute_5,
            data_attribute_6, data_attribute_7, data_attribute_8, data_attribute_9, data_attribute_10,
            data_attribute_11, data_attribute_12, data_cardinal_0
        }),
        .out_valid(pixel_valid), .out_ready(pixel_ready), .out_data(pixel_queue_out_data)
    );

    stream_fifo_d16_w12_distributed gone_tiles (
        .clk(clk), .rst(rst), .in_valid(done & goes & draws_what_leaves), .in_ready(gone_tiles_in_ready),
        .in_data(goes_tile),
        .out_valid(gone_tiles_out_valid), .out_ready(looks), .out_data(gone_tiles_out_data)
    );

    stream_skid_w23 read_queue (
        .clk(clk), .rst(rst), .in_valid(asks), .in_ready(read_queue_in_ready),
        .in_data({wanted_surface, wanted_tile, wanted_row, wanted_place, wanted_count}),
        .out_valid(read_valid), .out_ready(read_ready), .out_data(read_queue_out_data)
    );

    stream_fifo_d32_w23_distributed asked_runs (
        .clk(clk), .rst(rst), .in_valid(asks), .in_ready(asked_runs_in_ready),
        .in_data({wanted_leaves, wanted_tile, wanted_row, wanted_place, wanted_count}),
        .out_valid(asked_runs_out_valid), .out_ready(run_ends), .out_data(asked_runs_out_data)
    );

    stream_fifo_d8_w339_distributed write_queue (
        .clk(clk), .rst(rst), .in_valid(drained_valid), .in_ready(write_queue_in_ready),
        .in_data({
            surface, goes_tile, drained_pixel, drained_weight, drained_depth, drained_peak, drained_attribute_0,
            drained_attribute_1, drained_attribute_2, drained_attribute_3, drained_attribute_4,
            drained_attribute_5, drained_attribute_6, drained_attribute_7, drained_attribute_8,
            drained_attribute_9, drained_attribute_10, drained_attribute_11, drained_attribute_12,
            drained_cardinal_0
        }),
        .out_valid(write_valid), .out_ready(write_ready), .out_data(write_queue_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            head_valid <= 1'd0;
            clearing <= 1'd1;
            clearing_second <= 1'd1;
            cleared <= 13'd0;
            surface <= 1'd0;
            looking <= 1'd0;
            looks_not <= 1'd1;
            unchanged <= 2'd0;
            changed <= 1'd0;
            keeps <= 1'd0;
            keeps_none <= 1'd1;
            moving <= 1'd0;
            wanted_rows <= 8'd0;
            wanted_left <= 8'd0;
            any_wanted <= 1'd0;
            wanted_leaves <= 1'd0;
            awaited_fills <= 6'd0;
            awaited_leaving <= 6'd0;
            came <= 3'd0;
            filling <= 1'd0;
            fills_none <= 1'd1;
            taken_banks <= 2'd0;
            leaving_rows <= 8'd0;
            leaving_left <= 8'd0;
            any_leaving <= 1'd0;
            owed <= 4'd0;
            next <= 3'd0;
            resident_0 <= 1'd0;
            ready_0 <= 1'd0;
            in_flight_0 <= 8'd0;
            used_0 <= 1'd0;
            is_of_copy_0 <= 1'd0;
            resident_1 <= 1'd0;
            ready_1 <= 1'd0;
            in_flight_1 <= 8'd0;
            used_1 <= 1'd0;
            is_of_copy_1 <= 1'd0;
            resident_2 <= 1'd0;
            ready_2 <= 1'd0;
            in_flight_2 <= 8'd0;
            used_2 <= 1'd0;
            is_of_copy_2 <= 1'd0;
            resident_3 <= 1'd0;
            ready_3 <= 1'd0;
            in_flight_3 <= 8'd0;
            used_3 <= 1'd0;
            is_of_copy_3 <= 1'd0;
            resident_4 <= 1'd0;
            ready_4 <= 1'd0;
            in_flight_4 <= 8'd0;
            used_4 <= 1'd0;
            is_of_copy_4 <= 1'd0;
            resident_5 <= 1'd0;
            ready_5 <= 1'd0;
            in_flight_5 <= 8'd0;
            used_5 <= 1'd0;
            is_of_copy_5 <= 1'd0;
            resident_6 <= 1'd0;
            ready_6 <= 1'd0;
            in_flight_6 <= 8'd0;
            used_6 <= 1'd0;
            is_of_copy_6 <= 1'd0;
            resident_7 <= 1'd0;
            ready_7 <= 1'd0;
            in_flight_7 <= 8'd0;
            used_7 <= 1'd0;
            is_of_copy_7 <= 1'd0;
            next_idle <= 1'd0;
            turn_is_new <= 1'd1;
            frame_leaves <= 1'd0;
            frame_is_given <= 1'd0;
            any_next_place <= 1'd0;
            look_reads <= 1'd0;
            look_is_shown <= 1'd0;
            look_is_seen <= 1'd0;
            missed <= 1'd0;
            head_empty <= 1'd1;
            arrived <= 1'd0;
            arriving_surface <= 1'd0;
            whole_frames <= 2'd0;
            looked_up <= 1'd0;
            compared <= 1'd0;
            forgets <= 1'd0;
        end else begin
            head_valid <= head_valid_choice;
            clearing <= clearing & ~cleared_plus_1[12];
            surface <= surface ^ switches;
            looking <= job_starts;
            looks_not <= ~job_starts;
            unchanged <= still_unchanged | {2{looking}};
            changed <= change;
            keeps <= change_and_goes;
            keeps_none <= ~change_and_goes;
            wanted_left <= wanted_row_ends ? wanted_left_either_7 : wanted_left_both;
            any_wanted <= ~wanted_row_ends | (|wanted_rows | (begins & (sends | mask[64])));
            awaited_fills <= (awaited_fills + {5'd0, asks & ~wanted_leaves}) - {5'd0, run_ends & ~asked_runs_out_leaves};
            awaited_leaving <= (awaited_leaving + {5'd0, asks & wanted_leaves}) - {5'd0, run_ends & asked_runs_out_leaves};
            filling <= filling_either;
            fills_none <= ~filling_either;
            taken_banks <= sample_writes;
            leaving_left <= leaving_row_ends ? leaving_left_either_7 : leaving_left_both;
            any_leaving <= ~leaving_row_ends | (|leaving_rows | (keeps & |masks_dirty));
            owed <= (owed + {3'd0, drains}) - {3'd0, pixel_leaves};
            used_0 <= in_flight_0_both | (used_0 & ~next_is_0);
            is_of_copy_0 <= head_empty ? is_of_copy_0_both : (start_and_next_is_0 | (is_of_copy_0 & not_starts_and_next_is_0));
            used_1 <= in_flight_1_both | (used_1 & ~next_is_1);
            is_of_copy_1 <= head_empty ? is_of_copy_1_both : (start_and_next_is_1 | (is_of_copy_1 & not_starts_and_next_is_1));
            used_2 <= in_flight_2_both | (used_2 & ~next_is_2);
            is_of_copy_2 <= head_empty ? is_of_copy_2_both : (start_and_next_is_2 | (is_of_copy_2 & not_starts_and_next_is_2));
            used_3 <= in_flight_3_both | (used_3 & ~next_is_3);
            is_of_copy_3 <= head_empty ? is_of_copy_3_both : (start_and_next_is_3 | (is_of_copy_3 & not_starts_and_next_is_3));
            used_4 <= in_flight_4_both | (used_4 & ~next_is_4);
            is_of_copy_4 <= head_empty ? is_of_copy_4_both : (start_and_next_is_4 | (is_of_copy_4 & not_starts_and_next_is_4));
            used_5 <= in_flight_5_both | (used_5 & ~next_is_5);
            is_of_copy_5 <= head_empty ? is_of_copy_5_both : (start_and_next_is_5 | (is_of_copy_5 & not_starts_and_next_is_5));
            used_6 <= in_flight_6_both | (used_6 & ~next_is_6);
            is_of_copy_6 <= head_empty ? is_of_copy_6_both : (start_and_next_is_6 | (is_of_copy_6 & not_starts_and_next_is_6));
            used_7 <= in_flight_7_both | (used_7 & ~next_is_7);
            is_of_copy_7 <= head_empty ? is_of_copy_7_both : (start_and_next_is_7 | (is_of_copy_7 & not_starts_and_next_is_7));
            next_idle <= next_idle_either_15 & ~turns;
            turn_is_new <= turns;
            look_reads <= looks_at_next | (looks & gone_tiles_out_valid) | (look_reads & ~look_is_read);
            look_is_shown <= look_is_read;
            look_is_seen <= look_is_shown | (look_is_seen & ~looks);
            missed <= misses;
            head_empty <= ~head_valid_choice;
            arrived <= arrives_valid;
            arriving_surface <= arriving_surface ^ frame_is_whole;
            whole_frames <= (whole_frames + {1'd0, frame_is_whole}) - {1'd0, switches};
            looked_up <= look_is_read_both & ~in_queue_out_end;
            compared <= looked_up;
            forgets <= last_reached | forgets_both;
            if (word_is_cleared & &cleared) clearing_second <= 1'd0;
            if (word_is_cleared) cleared <= cleared_plus_1;
            if (changed | done) moving <= changed;
            if (begins | wanted_row_ends) begin
                wanted_rows <= begins ? wanted_rows_bits : (wanted_rows & ~wanted_rows_bits_2);
            end
            if (begins) wanted_leaves <= sends;
            if (beat) came <= run_ends ? 3'd0 : came_now[2:0];
            if (keeps | leaving_row_ends) begin
                leaving_rows <= keeps ? leaving_rows_bits : (leaving_rows & ~leaving_rows_bits_2);
            end
            if (turns) next <= next_is_7 ? 3'd0 : (next + 3'd1);
            if (starts_and_next_is_0) resident_0 <= start_and_next_is_0;
            if (ready_0_both | starts_and_next_is_0) ready_0 <= ready_0_both;
            if (in_flight_0_both ^ in_flight_0_enable_both) begin
                in_flight_0 <= in_flight_0_both ? (in_flight_0 + 8'd1) : (in_flight_0 - 8'd1);
            end
            if (starts_and_next_is_1) resident_1 <= start_and_next_is_1;
            if (ready_1_both | starts_and_next_is_1) ready_1 <= ready_1_both;
            if (in_flight_1_both ^ in_flight_1_enable_both) begin
                in_flight_1 <= in_flight_1_both ? (in_flight_1 + 8'd1) : (in_flight_1 - 8'd1);
            end
            if (starts_and_next_is_2) resident_2 <= start_and_next_is_2;
            if (ready_2_both | starts_and_next_is_2) ready_2 <= ready_2_both;
            if (in_flight_2_both ^ in_flight_2_enable_both) begin
                in_flight_2 <= in_flight_2_both ? (in_flight_2 + 8'd1) : (in_flight_2 - 8'd1);
            end
            if (starts_and_next_is_3) resident_3 <= start_and_next_is_3;
            if (ready_3_both | starts_and_next_is_3) ready_3 <= ready_3_both;
            if (in_flight_3_both ^ in_flight_3_enable_both) begin
                in_flight_3 <= in_flight_3_both ? (in_flight_3 + 8'd1) : (in_flight_3 - 8'd1);
            end
            if (starts_and_next_is_4) resident_4 <= start_and_next_is_4;
            if (ready_4_both | starts_and_next_is_4) ready_4 <= ready_4_both;
            if (in_flight_4_both ^ in_flight_4_enable_both) begin
                in_flight_4 <= in_flight_4_both ? (in_flight_4 + 8'd1) : (in_flight_4 - 8'd1);
            end
            if (starts_and_next_is_5) resident_5 <= start_and_next_is_5;
            if (ready_5_both | starts_and_next_is_5) ready_5 <= ready_5_both;
            if (in_flight_5_both ^ in_flight_5_enable_both) begin
                in_flight_5 <= in_flight_5_both ? (in_flight_5 + 8'd1) : (in_flight_5 - 8'd1);
            end
            if (starts_and_next_is_6) resident_6 <= start_and_next_is_6;
            if (ready_6_both | starts_and_next_is_6) ready_6 <= ready_6_both;
            if (in_flight_6_both ^ in_flight_6_enable_both) begin
                in_flight_6 <= in_flight_6_both ? (in_flight_6 + 8'd1) : (in_flight_6 - 8'd1);
            end
            if (starts_and_next_is_7) resident_7 <= start_and_next_is_7;
            if (ready_7_both | starts_and_next_is_7) ready_7 <= ready_7_both;
            if (in_flight_7_both ^ in_flight_7_enable_both) begin
                in_flight_7 <= in_flight_7_both ? (in_flight_7 + 8'd1) : (in_flight_7 - 8'd1);
            end
            if (frame_begins_to_leave | closes) frame_leaves <= frame_begins_to_leave;
            if (switches | closes) frame_is_given <= switches;
            if (next_place_enable_either) begin
                any_next_place <= frame_begins_to_leave | ~(&next_place);
            end
        end
    end
    always @(posedge clk) begin
        if (head_empty) begin
            head_end <= in_queue_out_end;
            head_left <= in_queue_out_left;
            head_right <= in_queue_out_right;
            head_top <= in_queue_out_top;
            head_bottom <= in_queue_out_bottom;
            head_first_sum <= in_queue_out_first_sum;
            head_last_sum <= in_queue_out_last_sum;
            head_first_difference <= in_queue_out_first_difference;
            head_last_difference <= in_queue_out_last_difference;
            head_tile <= in_queue_out_tile;
            head_splat <= in_queue_out_splat;
        end
        if (~looks_not) mask <= {any_is_stored, stored_mask};
        if (job_starts) begin
            slot <= next;
            comes <= start;
            tile <= head_tile;
            goes <= goes_either_4;
            goes_tile <= goes_tile_either_3 | ({12{next_is_7}} & tile_7);
        end
        if (begins) begin
            wanted_mask <= wanted_mask_choice[63:0];
            wanted_surface <= sends ? surface_xor_frame_is_given : surface;
            wanted_tile <= sends ? looked_at : tile;
        end
        if (wanted_row_ends) wanted_row <= wanted_row_either_7 | {3{wanted_row_both}};
        if (keeps) leaving_mask <= masks_dirty;
        if (leaving_row_ends) leaving_row <= leaving_row_either_8 | {3{leaving_row_both}};
        if (start_and_next_is_0) tile_0 <= head_tile;
        if (start_and_next_is_1) tile_1 <= head_tile;
        if (start_and_next_is_2) tile_2 <= head_tile;
        if (start_and_next_is_3) tile_3 <= head_tile;
        if (start_and_next_is_4) tile_4 <= head_tile;
        if (start_and_next_is_5) tile_5 <= head_tile;
        if (start_and_next_is_6) tile_6 <= head_tile;
        if (start_and_next_is_7) tile_7 <= head_tile;
        if (next_place_enable_either) begin
            next_place <= frame_begins_to_leave ? 12'd0 : (next_place + 12'd1);
        end
        if (looks) looked_at <= gone_tiles_out_valid ? gone_tiles_out_data : next_place;
        if (look_is_shown) begin
            seen_mask <= {any_is_stored, stored_mask};
            seen_stays <= last_copy[11] | (seen_stays_either_2 & ~frame_is_given);
        end
        arrived_end <= arrives_end;
        arrived_tile <= arrives_tile;
        arrived_splat <= arrives_splat;
        found_valid <= last_copy[11];
        found_splat <= last_copy[10:0];
        overtaken <= look_is_read_both ? overtaken_both : overtaken_or_overtaken_both_2;
        if (last_reached) forgotten <= {surface, head_tile};
        if (fill_is_free) begin
            fill_pixel <= coming_pixel;
            fill_weight <= data_weight;
            fill_depth <= data_depth;
            fill_peak <= data_peak;
            fill_attribute_0 <= data_attribute_0;
            fill_attribute_1 <= data_attribute_1;
            fill_attribute_2 <= data_attribute_2;
            fill_attribute_3 <= data_attribute_3;
            fill_attribute_4 <= data_attribute_4;
            fill_attribute_5 <= data_attribute_5;
            fill_attribute_6 <= data_attribute_6;
            fill_attribute_7 <= data_attribute_7;
            fill_attribute_8 <= data_attribute_8;
            fill_attribute_9 <= data_attribute_9;
            fill_attribute_10 <= data_attribute_10;
            fill_attribute_11 <= data_attribute_11;
            fill_attribute_12 <= data_attribute_12;
            fill_cardinal_0 <= data_cardinal_0;
        end
    end

    wire _unused = &{1'b0, drains_shifted[1], may_fill_shifted[1], wanted_mask_choice[64], write_queue_in_ready};

`ifdef RTL_ASSERT
    wire [7:0] check_bits = {
        |wanted_mask[63:56], |wanted_mask[55:48], |wanted_mask[47:40], |wanted_mask[39:32],
        |wanted_mask[31:24], |wanted_mask[23:16], |wanted_mask[15:8], |wanted_mask[7:0]
    };
    wire [7:0] check_bits_2 = {
        |leaving_mask[63:56], |leaving_mask[55:48], |leaving_mask[47:40], |leaving_mask[39:32],
        |leaving_mask[31:24], |leaving_mask[23:16], |leaving_mask[15:8], |leaving_mask[7:0]
    };

    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        head_empty_or_valid: assert (head_valid ^ head_empty);
        masks_are_kept_of_tiles_that_go: assert ((keeps == (changed & goes)) & (keeps ^ keeps_none));
        one_copy_is_forgotten_at_a_time: assert (~(last_reached & (forgets & copy_enters)));
        it_looks_or_not: assert (looking ^ looks_not);
        wanted_rows_have_pixels: assert ((wanted_rows & ~check_bits) == 8'd0);
        drained_pixels_find_room: assert (~drained_valid | write_queue_in_ready);
        leaving_rows_have_pixels: assert ((leaving_rows & ~check_bits_2) == 8'd0);
        fills_or_none: assert (filling ^ fills_none);
        slot_0_retires_what_entered: assert (~in_flight_0_enable_both | |in_flight_0);
        slot_1_retires_what_entered: assert (~in_flight_1_enable_both | |in_flight_1);
        slot_2_retires_what_entered: assert (~in_flight_2_enable_both | |in_flight_2);
        slot_3_retires_what_entered: assert (~in_flight_3_enable_both | |in_flight_3);
        slot_4_retires_what_entered: assert (~in_flight_4_enable_both | |in_flight_4);
        slot_5_retires_what_entered: assert (~in_flight_5_enable_both | |in_flight_5);
        slot_6_retires_what_entered: assert (~in_flight_6_enable_both | |in_flight_6);
        slot_7_retires_what_entered: assert (~in_flight_7_enable_both | |in_flight_7);
`else
        if (!(head_valid ^ head_empty)) begin
            $display("assertion failed: head_empty_or_valid in %m"); $stop;
        end
        if (!((keeps == (changed & goes)) & (keeps ^ keeps_none))) begin
            $display("assertion failed: masks_are_kept_of_tiles_that_go in %m"); $stop;
        end
        if (!(~(last_reached & (forgets & copy_enters)))) begin
            $display("assertion failed: one_copy_is_forgotten_at_a_time in %m"); $stop;
        end
        if (!(looking ^ looks_not)) begin
            $display("assertion failed: it_looks_or_not in %m"); $stop;
        end
        if (!((wanted_rows & ~check_bits) == 8'd0)) begin
            $display("assertion failed: wanted_rows_have_pixels in %m"); $stop;
        end
        if (!(~drained_valid | write_queue_in_ready)) begin
            $display("assertion failed: drained_pixels_find_room in %m"); $stop;
        end
        if (!((leaving_rows & ~check_bits_2) == 8'd0)) begin
            $display("assertion failed: leaving_rows_have_pixels in %m"); $stop;
        end
        if (!(filling ^ fills_none)) begin $display("assertion failed: fills_or_none in %m"); $stop; end
        if (!(~in_flight_0_enable_both | |in_flight_0)) begin
            $display("assertion failed: slot_0_retires_what_entered in %m"); $stop;
        end
        if (!(~in_flight_1_enable_both | |in_flight_1)) begin
            $display("assertion failed: slot_1_retires_what_entered in %m"); $stop;
        end
        if (!(~in_flight_2_enable_both | |in_flight_2)) begin
            $display("assertion failed: slot_2_retires_what_entered in %m"); $stop;
        end
        if (!(~in_flight_3_enable_both | |in_flight_3)) begin
            $display("assertion failed: slot_3_retires_what_entered in %m"); $stop;
        end
        if (!(~in_flight_4_enable_both | |in_flight_4)) begin
            $display("assertion failed: slot_4_retires_what_entered in %m"); $stop;
        end
        if (!(~in_flight_5_enable_both | |in_flight_5)) begin
            $display("assertion failed: slot_5_retires_what_entered in %m"); $stop;
        end
        if (!(~in_flight_6_enable_both | |in_flight_6)) begin
            $display("assertion failed: slot_6_retires_what_entered in %m"); $stop;
        end
        if (!(~in_flight_7_enable_both | |in_flight_7)) begin
            $display("assertion failed: slot_7_retires_what_entered in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue in a memory with a registered output.
// depth = 8
// width = 339
// storage = distributed
module stream_fifo_d8_w339_distributed (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [338:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [338:0] out_data
);
    (* ram_style = "distributed" *)
    reg [338:0] entries [0:7];
    reg [3:0] held, waiting;
    reg is_full, any_waits;
    reg [2:0] write_address, read_address;
    reg [338:0] item;

    wire has_room = ~is_full;
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [3:0] held_bits = {{3{~push}}, 1'd1};
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    always @(posedge clk) begin
        if (rst) begin
            held <= 4'd0;
            waiting <= 4'd0;
            is_full <= 1'd0;
            any_waits <= 1'd0;
            write_address <= 3'd0;
            read_address <= 3'd0;
            out_valid <= 1'd0;
        end else begin
            if (push_xor_pop) begin
                held <= held + held_bits;
                is_full <= push & (held == 4'd7);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 4'd1);
            end
            if (push) write_address <= write_address + 3'd1;
            if (fetch) read_address <= read_address + 3'd1;
            out_valid <= fetch | (out_valid & ~out_ready);
        end
    end
    always @(posedge clk) begin
        if (has_room) entries[write_address] <= in_data;
        if (fetch) item <= entries[read_address];
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        held_in_range: assert (held <= 4'd8);
        held_is_waiting_and_shown: assert (held == (waiting + {3'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 4'd8)) & (any_waits == |waiting));
`else
        if (!(held <= 4'd8)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {3'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 4'd8)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue in a memory with a registered output.
// depth = 32
// width = 23
// storage = distributed
module stream_fifo_d32_w23_distributed (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [22:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [22:0] out_data
);
    (* ram_style = "distributed" *)
    reg [22:0] entries [0:31];
    reg [5:0] held, waiting;
    reg is_full, any_waits;
    reg [4:0] write_address, read_address;
    reg [22:0] item;

    wire has_room = ~is_full;
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [5:0] held_bits = {{5{~push}}, 1'd1};
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    always @(posedge clk) begin
        if (rst) begin
            held <= 6'd0;
            waiting <= 6'd0;
            is_full <= 1'd0;
            any_waits <= 1'd0;
            write_address <= 5'd0;
            read_address <= 5'd0;
            out_valid <= 1'd0;
        end else begin
            if (push_xor_pop) begin
                held <= held + held_bits;
                is_full <= push & (held == 6'd31);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 6'd1);
            end
            if (push) write_address <= write_address + 5'd1;
            if (fetch) read_address <= read_address + 5'd1;
            out_valid <= fetch | (out_valid & ~out_ready);
        end
    end
    always @(posedge clk) begin
        if (has_room) entries[write_address] <= in_data;
        if (fetch) item <= entries[read_address];
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        held_in_range: assert (held <= 6'd32);
        held_is_waiting_and_shown: assert (held == (waiting + {5'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 6'd32)) & (any_waits == |waiting));
`else
        if (!(held <= 6'd32)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {5'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 6'd32)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue of two in registers.
// width = 23
module stream_skid_w23 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [22:0] in_data,
    output wire out_valid, input wire out_ready, output wire [22:0] out_data
);
    reg head_filled, second_filled, room;
    reg [22:0] head, second;

    wire advance = ~head_filled | out_ready;
    wire some_item = second_filled | in_valid;
    wire not_advance_and_some_item = ~advance & some_item;

    assign in_ready = room;
    assign out_valid = head_filled;
    assign out_data = head;

    always @(posedge clk) begin
        if (rst) begin
            head_filled <= 1'd0;
            second_filled <= 1'd0;
            room <= 1'd1;
        end else begin
            if (advance) head_filled <= some_item;
            second_filled <= not_advance_and_some_item;
            room <= ~not_advance_and_some_item;
        end
    end
    always @(posedge clk) begin
        if (advance) head <= second_filled ? second : in_data;
        if (~second_filled) second <= in_data;
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        second_filled_or_room: assert (second_filled ^ room);
        second_waits_behind_head: assert (head_filled | ~second_filled);
`else
        if (!(second_filled ^ room)) begin
            $display("assertion failed: second_filled_or_room in %m"); $stop;
        end
        if (!(head_filled | ~second_filled)) begin
            $display("assertion failed: second_waits_behind_head in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue in a memory with a registered output.
// depth = 16
// width = 12
// storage = distributed
module stream_fifo_d16_w12_distributed (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [11:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [11:0] out_data
);
    (* ram_style = "distributed" *)
    reg [11:0] entries [0:15];
    reg [4:0] held, waiting;
    reg is_full, any_waits;
    reg [3:0] write_address, read_address;
    reg [11:0] item;

    wire has_room = ~is_full;
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [4:0] held_bits = {{4{~push}}, 1'd1};
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    always @(posedge clk) begin
        if (rst) begin
            held <= 5'd0;
            waiting <= 5'd0;
            is_full <= 1'd0;
            any_waits <= 1'd0;
            write_address <= 4'd0;
            read_address <= 4'd0;
            out_valid <= 1'd0;
        end else begin
            if (push_xor_pop) begin
                held <= held + held_bits;
                is_full <= push & (held == 5'd15);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 5'd1);
            end
            if (push) write_address <= write_address + 4'd1;
            if (fetch) read_address <= read_address + 4'd1;
            out_valid <= fetch | (out_valid & ~out_ready);
        end
    end
    always @(posedge clk) begin
        if (has_room) entries[write_address] <= in_data;
        if (fetch) item <= entries[read_address];
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        held_in_range: assert (held <= 5'd16);
        held_is_waiting_and_shown: assert (held == (waiting + {4'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 5'd16)) & (any_waits == |waiting));
`else
        if (!(held <= 5'd16)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {4'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 5'd16)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue of two in registers.
// width = 339
module stream_skid_w339 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [338:0] in_data,
    output wire out_valid, input wire out_ready, output wire [338:0] out_data
);
    reg head_filled, second_filled, room;
    reg [338:0] head, second;

    wire advance = ~head_filled | out_ready;
    wire some_item = second_filled | in_valid;
    wire not_advance_and_some_item = ~advance & some_item;

    assign in_ready = room;
    assign out_valid = head_filled;
    assign out_data = head;

    always @(posedge clk) begin
        if (rst) begin
            head_filled <= 1'd0;
            second_filled <= 1'd0;
            room <= 1'd1;
        end else begin
            if (advance) head_filled <= some_item;
            second_filled <= not_advance_and_some_item;
            room <= ~not_advance_and_some_item;
        end
    end
    always @(posedge clk) begin
        if (advance) head <= second_filled ? second : in_data;
        if (~second_filled) second <= in_data;
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        second_filled_or_room: assert (second_filled ^ room);
        second_waits_behind_head: assert (head_filled | ~second_filled);
`else
        if (!(second_filled ^ room)) begin
            $display("assertion failed: second_filled_or_room in %m"); $stop;
        end
        if (!(head_filled | ~second_filled)) begin
            $display("assertion failed: second_waits_behind_head in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue in a memory with a registered output.
// depth = 16
// width = 54
// storage = distributed
module stream_fifo_d16_w54_distributed (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [53:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [53:0] out_data
);
    (* ram_style = "distributed" *)
    reg [53:0] entries [0:15];
    reg [4:0] held, waiting;
    reg is_full, any_waits;
    reg [3:0] write_address, read_address;
    reg [53:0] item;

    wire has_room = ~is_full;
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [4:0] held_bits = {{4{~push}}, 1'd1};
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    always @(posedge clk) begin
        if (rst) begin
            held <= 5'd0;
            waiting <= 5'd0;
            is_full <= 1'd0;
            any_waits <= 1'd0;
            write_address <= 4'd0;
            read_address <= 4'd0;
            out_valid <= 1'd0;
        end else begin
            if (push_xor_pop) begin
                held <= held + held_bits;
                is_full <= push & (held == 5'd15);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 5'd1);
            end
            if (push) write_address <= write_address + 4'd1;
            if (fetch) read_address <= read_address + 4'd1;
            out_valid <= fetch | (out_valid & ~out_ready);
        end
    end
    always @(posedge clk) begin
        if (has_room) entries[write_address] <= in_data;
        if (fetch) item <= entries[read_address];
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        held_in_range: assert (held <= 5'd16);
        held_is_waiting_and_shown: assert (held == (waiting + {4'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 5'd16)) & (any_waits == |waiting));
`else
        if (!(held <= 5'd16)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {4'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 5'd16)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Orders splat copies by tile; what else they have waits in a memory.
// levels = 12
module splat_reorder (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready,  // Copies in any order.
    input  wire in_end,  // Closes the frame.
    input  wire [2:0] in_left,  // First column.
    input  wire [2:0] in_right,  // Last column.
    input  wire [2:0] in_top,  // First row.
    input  wire [2:0] in_bottom,  // Last row.
    input  wire [3:0] in_first_sum,  // Smallest sum.
    input  wire [3:0] in_last_sum,  // Largest sum.
    input  wire [3:0] in_first_difference,  // Smallest difference.
    input  wire [3:0] in_last_difference,  // Largest difference.
    input  wire [11:0] in_tile,  // Tile index: row above column.
    input  wire [10:0] in_splat,  // Place of its splat's payload.
    output wire out_valid, input wire out_ready,  // Copies in order of tiles.
    output wire out_end,  // Closes the frame.
    output wire [2:0] out_left,  // First column.
    output wire [2:0] out_right,  // Last column.
    output wire [2:0] out_top,  // First row.
    output wire [2:0] out_bottom,  // Last row.
    output wire [3:0] out_first_sum,  // Smallest sum.
    output wire [3:0] out_last_sum,  // Largest sum.
    output wire [3:0] out_first_difference,  // Smallest difference.
    output wire [3:0] out_last_difference,  // Largest difference.
    output wire [11:0] out_tile,  // Tile index: row above column.
    output wire [10:0] out_splat  // Place of its splat's payload.
);
    reg free_valid;
    reg [11:0] free;
    reg [12:0] fresh;
    reg draining, stage_valid;
    reg [11:0] stage_tile;
    wire [38:0] stage_rest;

    wire in_queue_out_valid;
    wire [51:0] in_queue_out_data;
    wire out_queue_in_ready;
    wire [51:0] out_queue_out_data;
    wire lists_in_ready, lists_out_valid;
    wire [11:0] lists_out_tile, lists_out_pointer;
    wire lists_empty, returned_in_ready, returned_out_valid;
    wire [11:0] returned_out_data;

    wire open = in_queue_out_valid & ~draining;
    wire in_queue_out_end = in_queue_out_data[51];
    wire offer = open & ~in_queue_out_end & free_valid;
    wire [10:0] in_queue_out_splat = in_queue_out_data[10:0];
    wire advance = ~stage_valid | out_queue_in_ready;
    wire insert = offer & lists_in_ready;
    wire take_end = open & in_queue_out_end;
    wire in_queue_out_ready = insert | take_end;
    wire close = draining & (lists_empty & ~stage_valid & out_queue_in_ready);
    wire [11:0] in_queue_out_tile = in_queue_out_data[22:11];
    wire leaving = lists_out_valid & advance;
    wire all_used = fresh[12];
    wire returned_out_ready = ~free_valid & all_used;

    assign {
        out_end, out_left, out_right, out_top, out_bottom, out_first_sum, out_last_sum, out_first_difference,
        out_last_difference, out_tile, out_splat
    } = out_queue_out_data;

    memory_1w1r_unordered #(.WIDTH(39), .DEPTH(4096), .SLICE(4)) rests (
        .clk(clk), .write(offer), .write_address(free),
        .write_data({in_queue_out_data[50:23], in_queue_out_splat}),
        .read(advance), .read_address(lists_out_pointer), .read_data(stage_rest)
    );

    stream_half_buffer_w52 in_queue (
        .clk(clk), .rst(rst), .in_valid(in_valid), .in_ready(in_ready),
        .in_data({
            in_end, in_left, in_right, in_top, in_bottom, in_first_sum, in_last_sum, in_first_difference,
            in_last_difference, in_tile, in_splat
        }),
        .out_valid(in_queue_out_valid), .out_ready(in_queue_out_ready), .out_data(in_queue_out_data)
    );

    stream_half_buffer_w52 out_queue (
        .clk(clk), .rst(rst), .in_valid(close | (stage_valid & out_queue_in_ready)),
        .in_ready(out_queue_in_ready), .in_data({close, stage_rest[38:11], stage_tile, stage_rest[10:0]}),
        .out_valid(out_valid), .out_ready(out_ready), .out_data(out_queue_out_data)
    );

    splat_lists lists (
        .clk(clk), .rst(rst), .in_valid(offer), .in_ready(lists_in_ready), .in_tile(in_queue_out_tile),
        .in_pointer(free),
        .out_valid(lists_out_valid), .out_ready(advance), .out_tile(lists_out_tile),
        .out_pointer(lists_out_pointer),
        .empty(lists_empty)
    );

    stream_fifo_d4096_w12 returned (
        .clk(clk), .rst(rst), .in_valid(leaving), .in_ready(returned_in_ready), .in_data(lists_out_pointer),
        .out_valid(returned_out_valid), .out_ready(returned_out_ready), .out_data(returned_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            free_valid <= 1'd0;
            fresh <= 13'd0;
            draining <= 1'd0;
            stage_valid <= 1'd0;
        end else begin
            free_valid <= free_valid ? ~insert : (~all_used | returned_out_valid);
            if (~(free_valid | all_used)) fresh <= fresh + 13'd1;
            if (take_end | close) draining <= take_end;
            if (advance) stage_valid <= leaving;
        end
    end
    always @(posedge clk) begin
        if (~free_valid) free <= all_used ? returned_out_data : fresh[11:0];
        if (advance) stage_tile <= lists_out_tile;
    end

    wire _unused = &{1'b0, returned_in_ready};

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        pointers_fit: assert (~leaving | returned_in_ready);
`else
        if (!(~leaving | returned_in_ready)) begin
            $display("assertion failed: pointers_fit in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue in a memory with a registered output.
// depth = 4096
// width = 12
module stream_fifo_d4096_w12 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [11:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [11:0] out_data
);
    reg [12:0] held, waiting;
    reg is_full, any_waits;
    reg [11:0] write_address, read_address;
    wire [11:0] item;

    wire has_room = ~is_full;
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [12:0] held_bits = {{12{~push}}, 1'd1};
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    memory_1w1r_unordered #(.WIDTH(12), .DEPTH(4096)) entries (
        .clk(clk), .write(has_room), .write_address(write_address), .write_data(in_data),
        .read(fetch), .read_address(read_address), .read_data(item)
    );

    always @(posedge clk) begin
        if (rst) begin
            held <= 13'd0;
            waiting <= 13'd0;
            is_full <= 1'd0;
            any_waits <= 1'd0;
            write_address <= 12'd0;
            read_address <= 12'd0;
            out_valid <= 1'd0;
        end else begin
            if (push_xor_pop) begin
                held <= held + held_bits;
                is_full <= push & (held == 13'hfff);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 13'd1);
            end
            if (push) write_address <= write_address + 12'd1;
            if (fetch) read_address <= read_address + 12'd1;
            out_valid <= fetch | (out_valid & ~out_ready);
        end
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        held_in_range: assert (held <= 13'h1000);
        held_is_waiting_and_shown: assert (held == (waiting + {12'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 13'h1000)) & (any_waits == |waiting));
`else
        if (!(held <= 13'h1000)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {12'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 13'h1000)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Lists of splat copies, one for each tile; some are served in turn.
// pointers = 4096
// tiles_in_turn = 4
module splat_lists (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready,  // Entries in any order; no pointer comes again before it has left.
    input  wire [11:0] in_tile,  // Tile index.
    input  wire [11:0] in_pointer,  // Place of the rest.
    output wire out_valid, input wire out_ready,  // Entries of a tile in order of arrival, those of some tiles in turn.
    output wire [11:0] out_tile,  // Tile index.
    output wire [11:0] out_pointer,  // Place of the rest.
    output wire empty  // It holds no entry.
);
    reg clearing;
    reg [11:0] cleared;
    reg second, may_open, opening;
    reg [11:0] opened_tile;  // Tile index.
    reg [11:0] opened_pointer;  // Place of the rest.
    reg appending;
    reg [11:0] appended_tile;  // Tile index.
    reg [11:0] appended_pointer;  // Place of the rest.
    wire [12:0] found;
    reg meets_opened, meets_appended, linking, follows;
    reg [11:0] last;
    reg joins;
    reg [11:0] opened_last;
    reg turn_0_valid, turn_1_valid, turn_2_valid, turn_3_valid;
    reg [35:0] turn_0, turn_1, turn_2, turn_3;
    reg goes_on;
    reg [11:0] going_tile;  // Tile index.
    reg [11:0] going_last;  // The pointer of its last one.
    wire [11:0] link;
    reg [11:0] following;
    reg [12:0] count;

    wire out_queue_in_ready;
    wire [23:0] out_queue_out_data;
    wire beginnings_in_ready, beginnings_out_valid;
    wire [23:0] beginnings_out_data;
    wire first_in_ready, first_out_valid;
    wire [23:0] first_out_data;

    wire [11:0] first_out_tile = first_out_data[23:12];
    wire leaves = second & turn_0_valid & out_queue_in_ready;
    wire begins = linking & ~follows;
    wire opens = may_open & ~second;
    wire may_open_either = (turn_0_valid & (turn_0[35:24] == first_out_tile)) | (turn_1_valid & (turn_1[35:24] == first_out_tile));
    wire may_open_either_2 = may_open_either | (turn_2_valid & (turn_2[35:24] == first_out_tile));
    wire may_open_either_3 = may_open_either_2 | (turn_3_valid & (turn_3[35:24] == first_out_tile));
    wire may_open_either_4 = may_open_either_3 | (goes_on & (going_tile == first_out_tile)) | (turn_3_valid | (goes_on & turn_2_valid));
    wire [11:0] first_out_pointer = first_out_data[11:0];
    wire appends = second & in_valid;
    wire turn_0_valid_choice = leaves ? turn_1_valid : turn_0_valid;
    wire turn_0_choice = second ? goes_on : joins;
    wire turn_0_both = turn_0_choice & ~turn_0_valid_choice;
    wire turn_1_valid_choice = leaves ? turn_2_valid : turn_1_valid;
    wire turn_1_valid_both = turn_0_choice & (turn_0_valid_choice & ~turn_1_valid_choice);
    wire turn_2_valid_choice = leaves ? turn_3_valid : turn_2_valid;
    wire turn_2_valid_both = turn_0_choice & (turn_1_valid_choice & ~turn_2_valid_choice);
    wire turn_3_valid_choice = leaves ? 1'd0 : turn_3_valid;
    wire turn_3_valid_both = turn_0_choice & (turn_2_valid_choice & ~turn_3_valid_choice);
    wire [35:0] turn_3_bits = {
        second ? going_tile : opened_tile, second ? following : opened_pointer,
        second ? going_last : opened_last
    };

    assign in_ready = second;
    assign {out_tile, out_pointer} = out_queue_out_data;
    assign empty = ~(|count | out_valid);

    memory_1w1r_unordered #(.WIDTH(13), .DEPTH(4096)) ends (
        .clk(clk), .write(clearing | (appending | opening)),
        .write_address(clearing ? cleared : appending ? appended_tile : opened_tile),
        .write_data({appending, appended_pointer}),
        .read(1'd1), .read_address(second ? in_tile : first_out_tile), .read_data(found)
    );

    memory_1w1r_unordered #(.WIDTH(12), .DEPTH(4096)) links (
        .clk(clk), .write(linking & follows), .write_address(last), .write_data(appended_pointer),
        .read(second), .read_address(turn_0[23:12]), .read_data(link)
    );

    stream_skid_w24 out_queue (
        .clk(clk), .rst(rst), .in_valid(leaves), .in_ready(out_queue_in_ready), .in_data(turn_0[35:12]),
        .out_valid(out_valid), .out_ready(out_ready), .out_data(out_queue_out_data)
    );

    stream_fifo_d4096_w24 beginnings (
        .clk(clk), .rst(rst), .in_valid(begins), .in_ready(beginnings_in_ready),
        .in_data({appended_tile, appended_pointer}),
        .out_valid(beginnings_out_valid), .out_ready(first_in_ready), .out_data(beginnings_out_data)
    );

    stream_half_buffer_w24 first (
        .clk(clk), .rst(rst), .in_valid(beginnings_out_valid), .in_ready(first_in_ready),
        .in_data(beginnings_out_data),
        .out_valid(first_out_valid), .out_ready(opens), .out_data(first_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            clearing <= 1'd1;
            cleared <= 12'd0;
            second <= 1'd0;
            may_open <= 1'd0;
            opening <= 1'd0;
            appending <= 1'd0;
            linking <= 1'd0;
            joins <= 1'd0;
            turn_0_valid <= 1'd0;
            turn_1_valid <= 1'd0;
            turn_2_valid <= 1'd0;
            turn_3_valid <= 1'd0;
            goes_on <= 1'd0;
            count <= 13'd0;
        end else begin
            if (&cleared) clearing <= 1'd0;
            if (clearing) cleared <= cleared + 12'd1;
            second <= ~(clearing | second);
            opening <= opens;
            appending <= appends;
            linking <= appending;
            joins <= opening;
            turn_0_valid <= turn_0_valid_choice | turn_0_both;
            turn_1_valid <= turn_1_valid_choice | turn_1_valid_both;
            turn_2_valid <= turn_2_valid_choice | turn_2_valid_both;
            turn_3_valid <= turn_3_valid_choice | turn_3_valid_both;
            if (second) begin
                may_open <= first_out_valid & ~opening & ~may_open_either_4;
                goes_on <= leaves & (turn_0[23:12] != turn_0[11:0]);
            end
            if (appends ^ leaves) count <= appends ? (count + 13'd1) : (count - 13'd1);
        end
    end
    always @(posedge clk) begin
        if (opens) begin
            opened_tile <= first_out_tile;
            opened_pointer <= first_out_pointer;
        end
        if (appends) begin
            appended_tile <= in_tile;
            appended_pointer <= in_pointer;
        end
        meets_opened <= opening & (in_tile == opened_tile);
        meets_appended <= appending & (first_out_tile == appended_tile);
        if (appending) begin
            follows <= found[12] & ~meets_opened;
            last <= found[11:0];
        end
        if (opening) opened_last <= meets_appended ? appended_pointer : found[11:0];
        if (leaves | turn_0_both) turn_0 <= turn_0_both ? turn_3_bits : turn_1;
        if (leaves | turn_1_valid_both) turn_1 <= turn_1_valid_both ? turn_3_bits : turn_2;
        if (leaves | turn_2_valid_both) turn_2 <= turn_2_valid_both ? turn_3_bits : turn_3;
        if (leaves | turn_3_valid_both) turn_3 <= turn_3_bits;
        if (second) begin
            going_tile <= turn_0[35:24];
            going_last <= turn_0[11:0];
        end
        if (~second) following <= link;
    end

    wire _unused = &{1'b0, beginnings_in_ready};

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        a_list_that_begins_has_room: assert (~begins | beginnings_in_ready);
        a_list_that_waits_has_an_end: assert (~(opening & ~meets_appended) | found[12]);
`else
        if (!(~begins | beginnings_in_ready)) begin
            $display("assertion failed: a_list_that_begins_has_room in %m"); $stop;
        end
        if (!(~(opening & ~meets_appended) | found[12])) begin
            $display("assertion failed: a_list_that_waits_has_an_end in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// One item in a register, at half rate.
// width = 24
module stream_half_buffer_w24 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [23:0] in_data,
    output wire out_valid, input wire out_ready, output wire [23:0] out_data
);
    reg filled;
    reg [23:0] item;

    assign in_ready = ~filled;

    assign out_valid = filled;
    assign out_data = item;

    always @(posedge clk) begin
        if (rst) filled <= 1'd0;
        else filled <= filled ? ~out_ready : in_valid;
    end
    always @(posedge clk) if (in_ready) item <= in_data;
endmodule

// Queue in a memory with a registered output.
// depth = 4096
// width = 24
module stream_fifo_d4096_w24 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [23:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [23:0] out_data
);
    reg [12:0] held, waiting;
    reg is_full, any_waits;
    reg [11:0] write_address, read_address;
    wire [23:0] item;

    wire has_room = ~is_full;
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [12:0] held_bits = {{12{~push}}, 1'd1};
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    memory_1w1r_unordered #(.WIDTH(24), .DEPTH(4096)) entries (
        .clk(clk), .write(has_room), .write_address(write_address), .write_data(in_data),
        .read(fetch), .read_address(read_address), .read_data(item)
    );

    always @(posedge clk) begin
        if (rst) begin
            held <= 13'd0;
            waiting <= 13'd0;
            is_full <= 1'd0;
            any_waits <= 1'd0;
            write_address <= 12'd0;
            read_address <= 12'd0;
            out_valid <= 1'd0;
        end else begin
            if (push_xor_pop) begin
                held <= held + held_bits;
                is_full <= push & (held == 13'hfff);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 13'd1);
            end
            if (push) write_address <= write_address + 12'd1;
            if (fetch) read_address <= read_address + 12'd1;
            out_valid <= fetch | (out_valid & ~out_ready);
        end
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        held_in_range: assert (held <= 13'h1000);
        held_is_waiting_and_shown: assert (held == (waiting + {12'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 13'h1000)) & (any_waits == |waiting));
`else
        if (!(held <= 13'h1000)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {12'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 13'h1000)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// One item in a register, at half rate.
// width = 52
module stream_half_buffer_w52 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [51:0] in_data,
    output wire out_valid, input wire out_ready, output wire [51:0] out_data
);
    reg filled;
    reg [51:0] item;

    assign in_ready = ~filled;

    assign out_valid = filled;
    assign out_data = item;

    always @(posedge clk) begin
        if (rst) filled <= 1'd0;
        else filled <= filled ? ~out_ready : in_valid;
    end
    always @(posedge clk) if (in_ready) item <= in_data;
endmodule

// Keeps what the copies of a splat have in common, once.
// places = 2048
// beats = 2
module splat_payloads (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready,  // Copies, those of a splat one after the other.
    input  wire in_end,  // Closes the frame.
    input  wire in_first,  // It is the first of its splat.
    input  wire [31:0] in_center_x,  // Projected center (px), the origin of what follows.
    input  wire [31:0] in_center_y,  // Projected center (px), the origin of what follows.
    input  wire [31:0] in_ax,  // `A` in x.
    input  wire [31:0] in_bx,  // `B` in x.
    input  wire [31:0] in_ay,  // `A` in y.
    input  wire [31:0] in_by,  // `B` in y.
    input  wire [31:0] in_delta,  // The determinant of `A` and `B`.
    input  wire [31:0] in_mx,  // `m` in x.
    input  wire [31:0] in_my,  // `m` in y.
    input  wire in_sight_negative,  // `D` is negative before the eye.
    input  wire [30:0] in_sight_near,  // The magnitude of `D` at the near plane; all ones where no sample lies before it.
    input  wire [30:0] in_sight_far,  // The magnitude of `D` at the far plane; zero where no sample lies behind it.
    input  wire in_sight_turned,  // The origin is the vanishing point of a tangent: `s1` and `D` have changed places.
    input  wire in_sight_disc,  // The origin is the splat's centre, and lies between near and far plane: the filter's disc is drawn.
    input  wire [23:0] in_depth,  // Depth.
    input  wire [23:0] in_depth_low,  // What is nearer hides the splat.
    input  wire [23:0] in_depth_high,  // What is farther is hidden by the splat.
    input  wire [15:0] in_attribute_0,  // Attributes.
    input  wire [15:0] in_attribute_1,  // Attributes.
    input  wire [15:0] in_attribute_2,  // Attributes.
    input  wire [15:0] in_attribute_3,  // Attributes.
    input  wire [15:0] in_attribute_4,  // Attributes.
    input  wire [15:0] in_attribute_5,  // Attributes.
    input  wire [15:0] in_attribute_6,  // Attributes.
    input  wire [15:0] in_attribute_7,  // Attributes.
    input  wire [15:0] in_attribute_8,  // Attributes.
    input  wire [15:0] in_attribute_9,  // Attributes.
    input  wire [15:0] in_attribute_10,  // Attributes.
    input  wire [15:0] in_attribute_11,  // Attributes.
    input  wire [15:0] in_attribute_12,  // Attributes.
    input  wire [15:0] in_cardinal_0,  // Attributes.
    input  wire [2:0] in_left,  // First column.
    input  wire [2:0] in_right,  // Last column.
    input  wire [2:0] in_top,  // First row.
    input  wire [2:0] in_bottom,  // Last row.
    input  wire [3:0] in_first_sum,  // Smallest sum.
    input  wire [3:0] in_last_sum,  // Largest sum.
    input  wire [3:0] in_first_difference,  // Smallest difference.
    input  wire [3:0] in_last_difference,  // Largest difference.
    input  wire [11:0] in_tile,  // Tile index: row above column.
    output wire copy_valid, input wire copy_ready,  // The same, with where their payload lies in its place.
    output wire copy_end,  // Closes the frame.
    output wire [2:0] copy_left,  // First column.
    output wire [2:0] copy_right,  // Last column.
    output wire [2:0] copy_top,  // First row.
    output wire [2:0] copy_bottom,  // Last row.
    output wire [3:0] copy_first_sum,  // Smallest sum.
    output wire [3:0] copy_last_sum,  // Largest sum.
    output wire [3:0] copy_first_difference,  // Smallest difference.
    output wire [3:0] copy_last_difference,  // Largest difference.
    output wire [11:0] copy_tile,  // Tile index: row above column.
    output wire [10:0] copy_splat,  // Place of its splat's payload.
    input  wire placed_valid, output wire placed_ready,  // Copies that are to be drawn, in any order.
    input  wire [2:0] placed_left,  // First column.
    input  wire [2:0] placed_right,  // Last column.
    input  wire [2:0] placed_top,  // First row.
    input  wire [2:0] placed_bottom,  // Last row.
    input  wire [3:0] placed_first_sum,  // Smallest sum.
    input  wire [3:0] placed_last_sum,  // Largest sum.
    input  wire [3:0] placed_first_difference,  // Smallest difference.
    input  wire [3:0] placed_last_difference,  // Largest difference.
    input  wire [11:0] placed_tile,  // Tile index: row above column.
    input  wire [10:0] placed_splat,  // Place of its splat's payload.
    input  wire [2:0] placed_slot,  // Slot of the tile cache.
    output wire out_valid, input wire out_ready,  // The same with their payload.
    output wire [31:0] out_center_x,  // Projected center (px), the origin of what follows.
    output wire [31:0] out_center_y,  // Projected center (px), the origin of what follows.
    output wire [31:0] out_ax,  // `A` in x.
    output wire [31:0] out_bx,  // `B` in x.
    output wire [31:0] out_ay,  // `A` in y.
    output wire [31:0] out_by,  // `B` in y.
    output wire [31:0] out_delta,  // The determinant of `A` and `B`.
    output wire [31:0] out_mx,  // `m` in x.
    output wire [31:0] out_my,  // `m` in y.
    output wire out_sight_negative,  // `D` is negative before the eye.
    output wire [30:0] out_sight_near,  // The magnitude of `D` at the near plane; all ones where no sample lies before it.
    output wire [30:0] out_sight_far,  // The magnitude of `D` at the far plane; zero where no sample lies behind it.
    output wire out_sight_turned,  // The origin is the vanishing point of a tangent: `s1` and `D` have changed places.
    output wire out_sight_disc,  // The origin is the splat's centre, and lies between near and far plane: the filter's disc is drawn.
    output wire [23:0] out_depth,  // Depth.
    output wire [23:0] out_depth_low,  // What is nearer hides the splat.
    output wire [23:0] out_depth_high,  // What is farther is hidden by the splat.
    output wire [15:0] out_attribute_0,  // Attributes.
    output wire [15:0] out_attribute_1,  // Attributes.
    output wire [15:0] out_attribute_2,  // Attributes.
    output wire [15:0] out_attribute_3,  // Attributes.
    output wire [15:0] out_attribute_4,  // Attributes.
    output wire [15:0] out_attribute_5,  // Attributes.
    output wire [15:0] out_attribute_6,  // Attributes.
    output wire [15:0] out_attribute_7,  // Attributes.
    output wire [15:0] out_attribute_8,  // Attributes.
    output wire [15:0] out_attribute_9,  // Attributes.
    output wire [15:0] out_attribute_10,  // Attributes.
    output wire [15:0] out_attribute_11,  // Attributes.
    output wire [15:0] out_attribute_12,  // Attributes.
    output wire [15:0] out_cardinal_0,  // Attributes.
    output wire [2:0] out_left,  // First column.
    output wire [2:0] out_right,  // Last column.
    output wire [2:0] out_top,  // First row.
    output wire [2:0] out_bottom,  // Last row.
    output wire [3:0] out_first_sum,  // Smallest sum.
    output wire [3:0] out_last_sum,  // Largest sum.
    output wire [3:0] out_first_difference,  // Smallest difference.
    output wire [3:0] out_last_difference,  // Largest difference.
    output wire [11:0] out_tile,  // Tile index: row above column.
    output wire [2:0] out_slot  // Slot of the tile cache.
);
    reg clearing;
    reg [10:0] cleared;
    reg has_free;
    reg [10:0] free;
    reg holds, passes;
    reg [10:0] place;
    reg [12:0] copies;
    reg open, writing, word;
    reg [324:0] word_1;
    reg held_end;
    reg [2:0] held_left;  // First column.
    reg [2:0] held_right;  // Last column.
    reg [2:0] held_top;  // First row.
    reg [2:0] held_bottom;  // Last row.
    reg [3:0] held_first_sum;  // Smallest sum.
    reg [3:0] held_last_sum;  // Largest sum.
    reg [3:0] held_first_difference;  // Smallest difference.
    reg [3:0] held_last_difference;  // Largest difference.
    reg [11:0] held_tile;
    reg current_valid, beat, complete_valid, complete_room, out_holds;
    reg [2:0] current_left;  // First column.
    reg [2:0] current_right;  // Last column.
    reg [2:0] current_top;  // First row.
    reg [2:0] current_bottom;  // Last row.
    reg [3:0] current_first_sum;  // Smallest sum.
    reg [3:0] current_last_sum;  // Largest sum.
    reg [3:0] current_first_difference;  // Smallest difference.
    reg [3:0] current_last_difference;  // Largest difference.
    reg [11:0] current_tile;  // Tile index: row above column.
    reg [10:0] current_splat;  // Place of its splat's payload.
    reg [2:0] current_slot;  // Slot of the tile cache.
    wire [324:0] shown_word;
    reg [324:0] kept_0;
    reg [31:0] complete_center_x;  // Projected center (px), the origin of what follows.
    reg [31:0] complete_center_y;  // Projected center (px), the origin of what follows.
    reg [31:0] complete_ax;  // `A` in x.
    reg [31:0] complete_bx;  // `B` in x.
    reg [31:0] complete_ay;  // `A` in y.
    reg [31:0] complete_by;  // `B` in y.
    reg [31:0] complete_delta;  // The determinant of `A` and `B`.
    reg [31:0] complete_mx;  // `m` in x.
    reg [31:0] complete_my;  // `m` in y.
    reg complete_sight_negative;  // `D` is negative before the eye.
    reg [30:0] complete_sight_near;  // The magnitude of `D` at the near plane; all ones where no sample lies before it.
    reg [30:0] complete_sight_far;  // The magnitude of `D` at the far plane; zero where no sample lies behind it.
    reg complete_sight_turned;  // The origin is the vanishing point of a tangent: `s1` and `D` have changed places.
    reg complete_sight_disc;  // The origin is the splat's centre, and lies between near and far plane: the filter's disc is drawn.
    reg [23:0] complete_depth;  // Depth.
    reg [23:0] complete_depth_low;  // What is nearer hides the splat.
    reg [23:0] complete_depth_high;  // What is farther is hidden by the splat.
    reg [15:0] complete_attribute_0;  // Attributes.
    reg [15:0] complete_attribute_1;  // Attributes.
    reg [15:0] complete_attribute_2;  // Attributes.
    reg [15:0] complete_attribute_3;  // Attributes.
    reg [15:0] complete_attribute_4;  // Attributes.
    reg [15:0] complete_attribute_5;  // Attributes.
    reg [15:0] complete_attribute_6;  // Attributes.
    reg [15:0] complete_attribute_7;  // Attributes.
    reg [15:0] complete_attribute_8;  // Attributes.
    reg [15:0] complete_attribute_9;  // Attributes.
    reg [15:0] complete_attribute_10;  // Attributes.
    reg [15:0] complete_attribute_11;  // Attributes.
    reg [15:0] complete_attribute_12;  // Attributes.
    reg [15:0] complete_cardinal_0;  // Attributes.
    reg [2:0] complete_left;  // First column.
    reg [2:0] complete_right;  // Last column.
    reg [2:0] complete_top;  // First row.
    reg [2:0] complete_bottom;  // Last row.
    reg [3:0] complete_first_sum;  // Smallest sum.
    reg [3:0] complete_last_sum;  // Largest sum.
    reg [3:0] complete_first_difference;  // Smallest difference.
    reg [3:0] complete_last_difference;  // Largest difference.
    reg [11:0] complete_tile;  // Tile index: row above column.
    reg [2:0] complete_slot;  // Slot of the tile cache.
    reg [31:0] held_out_center_x;  // Projected center (px), the origin of what follows.
    reg [31:0] held_out_center_y;  // Projected center (px), the origin of what follows.
    reg [31:0] held_out_ax;  // `A` in x.
    reg [31:0] held_out_bx;  // `B` in x.
    reg [31:0] held_out_ay;  // `A` in y.
    reg [31:0] held_out_by;  // `B` in y.
    reg [31:0] held_out_delta;  // The determinant of `A` and `B`.
    reg [31:0] held_out_mx;  // `m` in x.
    reg [31:0] held_out_my;  // `m` in y.
    reg held_out_sight_negative;  // `D` is negative before the eye.
    reg [30:0] held_out_sight_near;  // The magnitude of `D` at the near plane; all ones where no sample lies before it.
    reg [30:0] held_out_sight_far;  // The magnitude of `D` at the far plane; zero where no sample lies behind it.
    reg held_out_sight_turned;  // The origin is the vanishing point of a tangent: `s1` and `D` have changed places.
    reg held_out_sight_disc;  // The origin is the splat's centre, and lies between near and far plane: the filter's disc is drawn.
    reg [23:0] held_out_depth;  // Depth.
    reg [23:0] held_out_depth_low;  // What is nearer hides the splat.
    reg [23:0] held_out_depth_high;  // What is farther is hidden by the splat.
    reg [15:0] held_out_attribute_0;  // Attributes.
    reg [15:0] held_out_attribute_1;  // Attributes.
    reg [15:0] held_out_attribute_2;  // Attributes.
    reg [15:0] held_out_attribute_3;  // Attributes.
    reg [15:0] held_out_attribute_4;  // Attributes.
    reg [15:0] held_out_attribute_5;  // Attributes.
    reg [15:0] held_out_attribute_6;  // Attributes.
    reg [15:0] held_out_attribute_7;  // Attributes.
    reg [15:0] held_out_attribute_8;  // Attributes.
    reg [15:0] held_out_attribute_9;  // Attributes.
    reg [15:0] held_out_attribute_10;  // Attributes.
    reg [15:0] held_out_attribute_11;  // Attributes.
    reg [15:0] held_out_attribute_12;  // Attributes.
    reg [15:0] held_out_cardinal_0;  // Attributes.
    reg [2:0] held_out_left;  // First column.
    reg [2:0] held_out_right;  // Last column.
    reg [2:0] held_out_top;  // First row.
    reg [2:0] held_out_bottom;  // Last row.
    reg [3:0] held_out_first_sum;  // Smallest sum.
    reg [3:0] held_out_last_sum;  // Largest sum.
    reg [3:0] held_out_first_difference;  // Smallest difference.
    reg [3:0] held_out_last_difference;  // Largest difference.
    reg [11:0] held_out_tile;  // Tile index: row above column.
    reg [2:0] held_out_slot;  // Slot of the tile cache.
    reg left_valid;
    reg [10:0] left_place;
    wire [12:0] shown_balance;
    reg reading_valid;
    reg [10:0] reading_place;
    reg [12:0] reading_number;
    reg caught_valid;
    reg [10:0] caught_place;
    reg [12:0] caught_number, balance;
    reg added_valid;
    reg [10:0] added_place;
    reg [12:0] added_number;
    reg earlier_valid;
    reg [10:0] earlier_place;
    reg [12:0] earlier_number, earliest_number;
    reg follows_added, follows_earlier, follows_earliest;

    wire closes_in_ready, closes_out_valid;
    wire [23:0] closes_out_data;
    wire released_in_ready, released_out_valid;
    wire [10:0] released_out_data;
    wire placed_queue_out_valid;
    wire [53:0] placed_queue_out_data;

    wire ready = ~holds & (closes_in_ready & (has_free | passes));
    wire copy_shown = holds & (~writing | word);
    wire [324:0] payload_words_data_bits = {
        in_center_x, in_center_y, in_ax, in_bx, in_ay, in_by, in_delta, in_mx, in_my, in_sight_negative,
        in_sight_near, in_sight_far[30:26]
    };
    wire leaves = current_valid & beat & complete_room;
    wire advance = ~current_valid | leaves;
    wire advance_or_not_beat = advance | ~beat;
    wire beat_choice = advance ? 1'd0 : (beat + 1'd1);
    wire [10:0] placed_queue_out_splat = placed_queue_out_data[13:3];
    wire [10:0] balances_address_choice = added_valid ? added_place : cleared;
    wire [10:0] closes_out_place = closes_out_data[23:13];
    wire [10:0] begins_place = left_valid ? left_place : closes_out_place;
    wire closes_splat = in_valid & (in_first | in_end) & (open & closes_in_ready);
    wire closes_out_ready = ~left_valid;
    wire clears = clearing & ~added_valid;
    wire releases = clears | (added_valid & (added_number == 13'd0));
    wire takes_free = ~has_free;
    wire take = ready & in_valid;
    wire needs_place = in_first & ~in_end;
    wire begins_splat = take & needs_place;
    wire out_room = ~out_holds | out_ready;
    wire complete_valid_either = leaves | (complete_valid & ~out_room);
    wire [2:0] placed_queue_out_left = placed_queue_out_data[53:51];
    wire [2:0] placed_queue_out_right = placed_queue_out_data[50:48];
    wire [2:0] placed_queue_out_top = placed_queue_out_data[47:45];
    wire [2:0] placed_queue_out_bottom = placed_queue_out_data[44:42];
    wire [3:0] placed_queue_out_first_sum = placed_queue_out_data[41:38];
    wire [3:0] placed_queue_out_last_sum = placed_queue_out_data[37:34];
    wire [3:0] placed_queue_out_first_difference = placed_queue_out_data[33:30];
    wire [3:0] placed_queue_out_last_difference = placed_queue_out_data[29:26];
    wire [11:0] placed_queue_out_tile = placed_queue_out_data[25:14];
    wire [2:0] placed_queue_out_slot = placed_queue_out_data[2:0];
    wire begins = left_valid | closes_out_valid;
    wire [12:0] closes_out_copies = closes_out_data[12:0];
    wire [12:0] sum_choice = follows_earlier ? earlier_number : follows_earliest ? earliest_number : balance;
    wire [12:0] sum = (follows_added ? added_number : sum_choice) + caught_number;

    assign in_ready = ready;
    assign copy_valid = copy_shown;
    assign copy_end = held_end;
    assign copy_left = held_left;
    assign copy_right = held_right;
    assign copy_top = held_top;
    assign copy_bottom = held_bottom;
    assign copy_first_sum = held_first_sum;
    assign copy_last_sum = held_last_sum;
    assign copy_first_difference = held_first_difference;
    assign copy_last_difference = held_last_difference;
    assign copy_tile = held_tile;
    assign copy_splat = place;
    assign out_valid = out_holds;
    assign out_center_x = held_out_center_x;
    assign out_center_y = held_out_center_y;
    assign out_ax = held_out_ax;
    assign out_bx = held_out_bx;
    assign out_ay = held_out_ay;
    assign out_by = held_out_by;
    assign out_delta = held_out_delta;
    assign out_mx = held_out_mx;
    assign out_my = held_out_my;
    assign out_sight_negative = held_out_sight_negative;
    assign out_sight_near = held_out_sight_near;
    assign out_sight_far = held_out_sight_far;
    assign out_sight_turned = held_out_sight_turned;
    assign out_sight_disc = held_out_sight_disc;
    assign out_depth = held_out_depth;
    assign out_depth_low = held_out_depth_low;
    assign out_depth_high = held_out_depth_high;
    assign out_attribute_0 = held_out_attribute_0;
    assign out_attribute_1 = held_out_attribute_1;
    assign out_attribute_2 = held_out_attribute_2;
    assign out_attribute_3 = held_out_attribute_3;
    assign out_attribute_4 = held_out_attribute_4;
    assign out_attribute_5 = held_out_attribute_5;
    assign out_attribute_6 = held_out_attribute_6;
    assign out_attribute_7 = held_out_attribute_7;
    assign out_attribute_8 = held_out_attribute_8;
    assign out_attribute_9 = held_out_attribute_9;
    assign out_attribute_10 = held_out_attribute_10;
    assign out_attribute_11 = held_out_attribute_11;
    assign out_attribute_12 = held_out_attribute_12;
    assign out_cardinal_0 = held_out_cardinal_0;
    assign out_left = held_out_left;
    assign out_right = held_out_right;
    assign out_top = held_out_top;
    assign out_bottom = held_out_bottom;
    assign out_first_sum = held_out_first_sum;
    assign out_last_sum = held_out_last_sum;
    assign out_first_difference = held_out_first_difference;
    assign out_last_difference = held_out_last_difference;
    assign out_tile = held_out_tile;
    assign out_slot = held_out_slot;

    memory_1w1r_unordered #(.WIDTH(325), .DEPTH(4096), .SLICE(4)) payload_words (
        .clk(clk), .write(writing | (~holds & has_free)), .write_address({word, writing ? place : free}),
        .write_data(word ? word_1 : payload_words_data_bits),
        .read(advance_or_not_beat),
        .read_address({beat_choice, advance ? placed_queue_out_splat : current_splat}),
        .read_data(shown_word)
    );

    memory_1w1r_unordered #(.WIDTH(13), .DEPTH(2048)) balances (
        .clk(clk), .write(clearing | added_valid), .write_address(balances_address_choice),
        .write_data({13{added_valid}} & added_number),
        .read(1'd1), .read_address(begins_place), .read_data(shown_balance)
    );

    stream_skid_w24 closes (
        .clk(clk), .rst(rst), .in_valid(closes_splat), .in_ready(closes_in_ready), .in_data({place, copies}),
        .out_valid(closes_out_valid), .out_ready(closes_out_ready), .out_data(closes_out_data)
    );

    stream_fifo_d2048_w11 released (
        .clk(clk), .rst(rst), .in_valid(releases), .in_ready(released_in_ready),
        .in_data(balances_address_choice),
        .out_valid(released_out_valid), .out_ready(takes_free), .out_data(released_out_data)
    );

    stream_skid_w54 placed_queue (
        .clk(clk), .rst(rst), .in_valid(placed_valid), .in_ready(placed_ready),
        .in_data({
            placed_left, placed_right, placed_top, placed_bottom, placed_first_sum, placed_last_sum,
            placed_first_difference, placed_last_difference, placed_tile, placed_splat, placed_slot
        }),
        .out_valid(placed_queue_out_valid), .out_ready(advance), .out_data(placed_queue_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            clearing <= 1'd1;
            cleared <= 11'd0;
            has_free <= 1'd0;
            holds <= 1'd0;
            passes <= 1'd0;
            open <= 1'd0;
            writing <= 1'd0;
            current_valid <= 1'd0;
            complete_valid <= 1'd0;
            complete_room <= 1'd1;
            out_holds <= 1'd0;
            left_valid <= 1'd0;
            reading_valid <= 1'd0;
            caught_valid <= 1'd0;
            added_valid <= 1'd0;
            earlier_valid <= 1'd0;
        end else begin
            clearing <= clearing & ~(clears & (cleared == 11'h7ff));
            has_free <= takes_free ? released_out_valid : (has_free & ~begins_splat);
            holds <= holds ? ~(copy_shown & copy_ready) : take;
            passes <= in_valid & ~ready & ~needs_place;
            open <= begins_splat | (open & ~closes_splat);
            writing <= writing ? ~word : begins_splat;
            complete_valid <= complete_valid_either;
            complete_room <= ~complete_valid_either;
            left_valid <= leaves;
            reading_valid <= begins;
            caught_valid <= reading_valid;
            added_valid <= caught_valid;
            earlier_valid <= added_valid;
            if (clears) cleared <= cleared + 11'd1;
            if (advance) current_valid <= placed_queue_out_valid;
            if (out_room) out_holds <= complete_valid;
        end
    end
    always @(posedge clk) begin
        if (takes_free) free <= released_out_data;
        if (begins_splat) place <= free;
        if (take) copies <= begins_splat ? 13'd1 : (copies + 13'd1);
        word <= writing ? (word ? 1'd0 : (word + 1'd1)) : begins_splat;
        left_place <= current_splat;
        reading_place <= begins_place;
        reading_number <= left_valid ? 13'h1fff : closes_out_copies;
        caught_place <= reading_place;
        caught_number <= reading_number;
        balance <= shown_balance;
        added_place <= caught_place;
        added_number <= sum;
        earlier_place <= added_place;
        earlier_number <= added_number;
        earliest_number <= earlier_number;
        follows_added <= caught_valid & (caught_place == reading_place);
        follows_earlier <= added_valid & (added_place == reading_place);
        follows_earliest <= earlier_valid & (earlier_place == reading_place);
        if (~holds) begin
            word_1 <= {
                in_sight_far[25:0], in_sight_turned, in_sight_disc, in_depth, in_depth_low, in_depth_high,
                in_attribute_0, in_attribute_1, in_attribute_2, in_attribute_3, in_attribute_4, in_attribute_5,
                in_attribute_6, in_attribute_7, in_attribute_8, in_attribute_9, in_attribute_10, in_attribute_11,
                in_attribute_12, in_cardinal_0, 1'd0
            };
            held_end <= in_end;
            held_left <= in_left;
            held_right <= in_right;
            held_top <= in_top;
            held_bottom <= in_bottom;
            held_first_sum <= in_first_sum;
            held_last_sum <= in_last_sum;
            held_first_difference <= in_first_difference;
            held_last_difference <= in_last_difference;
            held_tile <= in_tile;
        end
        if (advance_or_not_beat) beat <= beat_choice;
        if (advance) begin
            current_left <= placed_queue_out_left;
            current_right <= placed_queue_out_right;
            current_top <= placed_queue_out_top;
            current_bottom <= placed_queue_out_bottom;
            current_first_sum <= placed_queue_out_first_sum;
            current_last_sum <= placed_queue_out_last_sum;
            current_first_difference <= placed_queue_out_first_difference;
            current_last_difference <= placed_queue_out_last_difference;
            current_tile <= placed_queue_out_tile;
            current_splat <= placed_queue_out_splat;
            current_slot <= placed_queue_out_slot;
        end
        if (~beat) kept_0 <= shown_word;
        if (~complete_valid) begin
            complete_center_x <= kept_0[324:293];
            complete_center_y <= kept_0[292:261];
            complete_ax <= kept_0[260:229];
            complete_bx <= kept_0[228:197];
            complete_ay <= kept_0[196:165];
            complete_by <= kept_0[164:133];
            complete_delta <= kept_0[132:101];
            complete_mx <= kept_0[100:69];
            complete_my <= kept_0[68:37];
            complete_sight_negative <= kept_0[36];
            complete_sight_near <= kept_0[35:5];
            complete_sight_far <= {kept_0[4:0], shown_word[324:299]};
            complete_sight_turned <= shown_word[298];
            complete_sight_disc <= shown_word[297];
            complete_depth <= shown_word[296:273];
            complete_depth_low <= shown_word[272:249];
            complete_depth_high <= shown_word[248:225];
            complete_attribute_0 <= shown_word[224:209];
            complete_attribute_1 <= shown_word[208:193];
            complete_attribute_2 <= shown_word[192:177];
            complete_attribute_3 <= shown_word[176:161];
            complete_attribute_4 <= shown_word[160:145];
            complete_attribute_5 <= shown_word[144:129];
            complete_attribute_6 <= shown_word[128:113];
            complete_attribute_7 <= shown_word[112:97];
            complete_attribute_8 <= shown_word[96:81];
            complete_attribute_9 <= shown_word[80:65];
            complete_attribute_10 <= shown_word[64:49];
            complete_attribute_11 <= shown_word[48:33];
            complete_attribute_12 <= shown_word[32:17];
            complete_cardinal_0 <= shown_word[16:1];
            complete_left <= current_left;
            complete_right <= current_right;
            complete_top <= current_top;
            complete_bottom <= current_bottom;
            complete_first_sum <= current_first_sum;
            complete_last_sum <= current_last_sum;
            complete_first_difference <= current_first_difference;
            complete_last_difference <= current_last_difference;
            complete_tile <= current_tile;
            complete_slot <= current_slot;
        end
        if (out_room) begin
            held_out_center_x <= complete_center_x;
            held_out_center_y <= complete_center_y;
            held_out_ax <= complete_ax;
            held_out_bx <= complete_bx;
            held_out_ay <= complete_ay;
            held_out_by <= complete_by;
            held_out_delta <= complete_delta;
            held_out_mx <= complete_mx;
            held_out_my <= complete_my;
            held_out_sight_negative <= complete_sight_negative;
            held_out_sight_near <= complete_sight_near;
            held_out_sight_far <= complete_sight_far;
            held_out_sight_turned <= complete_sight_turned;
            held_out_sight_disc <= complete_sight_disc;
            held_out_depth <= complete_depth;
            held_out_depth_low <= complete_depth_low;
            held_out_depth_high <= complete_depth_high;
            held_out_attribute_0 <= complete_attribute_0;
            held_out_attribute_1 <= complete_attribute_1;
            held_out_attribute_2 <= complete_attribute_2;
            held_out_attribute_3 <= complete_attribute_3;
            held_out_attribute_4 <= complete_attribute_4;
            held_out_attribute_5 <= complete_attribute_5;
            held_out_attribute_6 <= complete_attribute_6;
            held_out_attribute_7 <= complete_attribute_7;
            held_out_attribute_8 <= complete_attribute_8;
            held_out_attribute_9 <= complete_attribute_9;
            held_out_attribute_10 <= complete_attribute_10;
            held_out_attribute_11 <= complete_attribute_11;
            held_out_attribute_12 <= complete_attribute_12;
            held_out_cardinal_0 <= complete_cardinal_0;
            held_out_left <= complete_left;
            held_out_right <= complete_right;
            held_out_top <= complete_top;
            held_out_bottom <= complete_bottom;
            held_out_first_sum <= complete_first_sum;
            held_out_last_sum <= complete_last_sum;
            held_out_first_difference <= complete_first_difference;
            held_out_last_difference <= complete_last_difference;
            held_out_tile <= complete_tile;
            held_out_slot <= complete_slot;
        end
    end

    wire _unused = &{1'b0, released_in_ready};

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        complete_or_room: assert (complete_valid ^ complete_room);
        a_place_that_is_free_has_room: assert (~releases | released_in_ready);
`else
        if (!(complete_valid ^ complete_room)) begin
            $display("assertion failed: complete_or_room in %m"); $stop;
        end
        if (!(~releases | released_in_ready)) begin
            $display("assertion failed: a_place_that_is_free_has_room in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue of two in registers.
// width = 54
module stream_skid_w54 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [53:0] in_data,
    output wire out_valid, input wire out_ready, output wire [53:0] out_data
);
    reg head_filled, second_filled, room;
    reg [53:0] head, second;

    wire advance = ~head_filled | out_ready;
    wire some_item = second_filled | in_valid;
    wire not_advance_and_some_item = ~advance & some_item;

    assign in_ready = room;
    assign out_valid = head_filled;
    assign out_data = head;

    always @(posedge clk) begin
        if (rst) begin
            head_filled <= 1'd0;
            second_filled <= 1'd0;
            room <= 1'd1;
        end else begin
            if (advance) head_filled <= some_item;
            second_filled <= not_advance_and_some_item;
            room <= ~not_advance_and_some_item;
        end
    end
    always @(posedge clk) begin
        if (advance) head <= second_filled ? second : in_data;
        if (~second_filled) second <= in_data;
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        second_filled_or_room: assert (second_filled ^ room);
        second_waits_behind_head: assert (head_filled | ~second_filled);
`else
        if (!(second_filled ^ room)) begin
            $display("assertion failed: second_filled_or_room in %m"); $stop;
        end
        if (!(head_filled | ~second_filled)) begin
            $display("assertion failed: second_waits_behind_head in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue in a memory with a registered output.
// depth = 2048
// width = 11
module stream_fifo_d2048_w11 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [10:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [10:0] out_data
);
    reg [11:0] held, waiting;
    reg is_full, any_waits;
    reg [10:0] write_address, read_address;
    wire [10:0] item;

    wire has_room = ~is_full;
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [11:0] held_bits = {{11{~push}}, 1'd1};
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    memory_1w1r_unordered #(.WIDTH(11), .DEPTH(2048)) entries (
        .clk(clk), .write(has_room), .write_address(write_address), .write_data(in_data),
        .read(fetch), .read_address(read_address), .read_data(item)
    );

    always @(posedge clk) begin
        if (rst) begin
            held <= 12'd0;
            waiting <= 12'd0;
            is_full <= 1'd0;
            any_waits <= 1'd0;
            write_address <= 11'd0;
            read_address <= 11'd0;
            out_valid <= 1'd0;
        end else begin
            if (push_xor_pop) begin
                held <= held + held_bits;
                is_full <= push & (held == 12'h7ff);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 12'd1);
            end
            if (push) write_address <= write_address + 11'd1;
            if (fetch) read_address <= read_address + 11'd1;
            out_valid <= fetch | (out_valid & ~out_ready);
        end
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        held_in_range: assert (held <= 12'h800);
        held_is_waiting_and_shown: assert (held == (waiting + {11'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 12'h800)) & (any_waits == |waiting));
`else
        if (!(held <= 12'h800)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {11'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 12'h800)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue of two in registers.
// width = 24
module stream_skid_w24 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [23:0] in_data,
    output wire out_valid, input wire out_ready, output wire [23:0] out_data
);
    reg head_filled, second_filled, room;
    reg [23:0] head, second;

    wire advance = ~head_filled | out_ready;
    wire some_item = second_filled | in_valid;
    wire not_advance_and_some_item = ~advance & some_item;

    assign in_ready = room;
    assign out_valid = head_filled;
    assign out_data = head;

    always @(posedge clk) begin
        if (rst) begin
            head_filled <= 1'd0;
            second_filled <= 1'd0;
            room <= 1'd1;
        end else begin
            if (advance) head_filled <= some_item;
            second_filled <= not_advance_and_some_item;
            room <= ~not_advance_and_some_item;
        end
    end
    always @(posedge clk) begin
        if (advance) head <= second_filled ? second : in_data;
        if (~second_filled) second <= in_data;
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        second_filled_or_room: assert (second_filled ^ room);
        second_waits_behind_head: assert (head_filled | ~second_filled);
`else
        if (!(second_filled ^ room)) begin
            $display("assertion failed: second_filled_or_room in %m"); $stop;
        end
        if (!(head_filled | ~second_filled)) begin
            $display("assertion failed: second_waits_behind_head in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Splits a splat's octagon into one copy per tile.
module splat_splitter (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready,  // Footprints with bounds in the image.
    input  wire in_end,  // Closes the frame.
    input  wire [31:0] in_center_x,  // Projected center (px), the origin of what follows.
    input  wire [31:0] in_center_y,  // Projected center (px), the origin of what follows.
    input  wire [31:0] in_ax,  // `A` in x.
    input  wire [31:0] in_bx,  // `B` in x.
    input  wire [31:0] in_ay,  // `A` in y.
    input  wire [31:0] in_by,  // `B` in y.
    input  wire [31:0] in_delta,  // The determinant of `A` and `B`.
    input  wire [31:0] in_mx,  // `m` in x.
    input  wire [31:0] in_my,  // `m` in y.
    input  wire in_sight_negative,  // `D` is negative before the eye.
    input  wire [30:0] in_sight_near,  // The magnitude of `D` at the near plane; all ones where no sample lies before it.
    input  wire [30:0] in_sight_far,  // The magnitude of `D` at the far plane; zero where no sample lies behind it.
    input  wire in_sight_turned,  // The origin is the vanishing point of a tangent: `s1` and `D` have changed places.
    input  wire in_sight_disc,  // The origin is the splat's centre, and lies between near and far plane: the filter's disc is drawn.
    input  wire [23:0] in_depth,  // Depth.
    input  wire [23:0] in_depth_low,  // What is nearer hides the splat.
    input  wire [23:0] in_depth_high,  // What is farther is hidden by the splat.
    input  wire [15:0] in_attribute_0,  // Attributes.
    input  wire [15:0] in_attribute_1,  // Attributes.
    input  wire [15:0] in_attribute_2,  // Attributes.
    input  wire [15:0] in_attribute_3,  // Attributes.
    input  wire [15:0] in_attribute_4,  // Attributes.
    input  wire [15:0] in_attribute_5,  // Attributes.
    input  wire [15:0] in_attribute_6,  // Attributes.
    input  wire [15:0] in_attribute_7,  // Attributes.
    input  wire [15:0] in_attribute_8,  // Attributes.
    input  wire [15:0] in_attribute_9,  // Attributes.
    input  wire [15:0] in_attribute_10,  // Attributes.
    input  wire [15:0] in_attribute_11,  // Attributes.
    input  wire [15:0] in_attribute_12,  // Attributes.
    input  wire [15:0] in_cardinal_0,  // Attributes.
    input  wire [8:0] in_left,  // First column.
    input  wire [8:0] in_right,  // Last column.
    input  wire [8:0] in_top,  // First row.
    input  wire [8:0] in_bottom,  // Last row.
    input  wire [9:0] in_first_sum,  // Smallest sum.
    input  wire [9:0] in_last_sum,  // Largest sum.
    input  wire [9:0] in_first_difference,  // Smallest difference.
    input  wire [9:0] in_last_difference,  // Largest difference.
    output wire out_valid, input wire out_ready,  // Copies with bounds in their tiles.
    output wire out_end,  // Closes the frame.
    output wire out_first,  // It is the first of its splat.
    output wire [31:0] out_center_x,  // Projected center (px), the origin of what follows.
    output wire [31:0] out_center_y,  // Projected center (px), the origin of what follows.
    output wire [31:0] out_ax,  // `A` in x.
    output wire [31:0] out_bx,  // `B` in x.
    output wire [31:0] out_ay,  // `A` in y.
    output wire [31:0] out_by,  // `B` in y.
    output wire [31:0] out_delta,  // The determinant of `A` and `B`.
    output wire [31:0] out_mx,  // `m` in x.
    output wire [31:0] out_my,  // `m` in y.
    output wire out_sight_negative,  // `D` is negative before the eye.
    output wire [30:0] out_sight_near,  // The magnitude of `D` at the near plane; all ones where no sample lies before it.
    output wire [30:0] out_sight_far,  // The magnitude of `D` at the far plane; zero where no sample lies behind it.
    output wire out_sight_turned,  // The origin is the vanishing point of a tangent: `s1` and `D` have changed places.
    output wire out_sight_disc,  // The origin is the splat's centre, and lies between near and far plane: the filter's disc is drawn.
    output wire [23:0] out_depth,  // Depth.
    output wire [23:0] out_depth_low,  // What is nearer hides the splat.
    output wire [23:0] out_depth_high,  // What is farther is hidden by the splat.
    output wire [15:0] out_attribute_0,  // Attributes.
    output wire [15:0] out_attribute_1,  // Attributes.
    output wire [15:0] out_attribute_2,  // Attributes.
    output wire [15:0] out_attribute_3,  // Attributes.
    output wire [15:0] out_attribute_4,  // Attributes.
    output wire [15:0] out_attribute_5,  // Attributes.
    output wire [15:0] out_attribute_6,  // Attributes.
    output wire [15:0] out_attribute_7,  // Attributes.
    output wire [15:0] out_attribute_8,  // Attributes.
    output wire [15:0] out_attribute_9,  // Attributes.
    output wire [15:0] out_attribute_10,  // Attributes.
    output wire [15:0] out_attribute_11,  // Attributes.
    output wire [15:0] out_attribute_12,  // Attributes.
    output wire [15:0] out_cardinal_0,  // Attributes.
    output wire [2:0] out_left,  // First column.
    output wire [2:0] out_right,  // Last column.
    output wire [2:0] out_top,  // First row.
    output wire [2:0] out_bottom,  // Last row.
    output wire [3:0] out_first_sum,  // Smallest sum.
    output wire [3:0] out_last_sum,  // Largest sum.
    output wire [3:0] out_first_difference,  // Smallest difference.
    output wire [3:0] out_last_difference,  // Largest difference.
    output wire [11:0] out_tile  // Tile index: row above column.
);
    reg none_made, room, busy, open, ready, closed;
    reg splat_end;  // Closes the frame.
    reg [31:0] splat_center_x;  // Projected center (px), the origin of what follows.
    reg [31:0] splat_center_y;  // Projected center (px), the origin of what follows.
    reg [31:0] splat_ax;  // `A` in x.
    reg [31:0] splat_bx;  // `B` in x.
    reg [31:0] splat_ay;  // `A` in y.
    reg [31:0] splat_by;  // `B` in y.
    reg [31:0] splat_delta;  // The determinant of `A` and `B`.
    reg [31:0] splat_mx;  // `m` in x.
    reg [31:0] splat_my;  // `m` in y.
    reg splat_sight_negative;  // `D` is negative before the eye.
    reg [30:0] splat_sight_near;  // The magnitude of `D` at the near plane; all ones where no sample lies before it.
    reg [30:0] splat_sight_far;  // The magnitude of `D` at the far plane; zero where no sample lies behind it.
    reg splat_sight_turned;  // The origin is the vanishing point of a tangent: `s1` and `D` have changed places.
    reg splat_sight_disc;  // The origin is the splat's centre, and lies between near and far plane: the filter's disc is drawn.
    reg [23:0] splat_depth;  // Depth.
    reg [23:0] splat_depth_low;  // What is nearer hides the splat.
    reg [23:0] splat_depth_high;  // What is farther is hidden by the splat.
    reg [15:0] splat_attribute_0;  // Attributes.
    reg [15:0] splat_attribute_1;  // Attributes.
    reg [15:0] splat_attribute_2;  // Attributes.
    reg [15:0] splat_attribute_3;  // Attributes.
    reg [15:0] splat_attribute_4;  // Attributes.
    reg [15:0] splat_attribute_5;  // Attributes.
    reg [15:0] splat_attribute_6;  // Attributes.
    reg [15:0] splat_attribute_7;  // Attributes.
    reg [15:0] splat_attribute_8;  // Attributes.
    reg [15:0] splat_attribute_9;  // Attributes.
    reg [15:0] splat_attribute_10;  // Attributes.
    reg [15:0] splat_attribute_11;  // Attributes.
    reg [15:0] splat_attribute_12;  // Attributes.
    reg [15:0] splat_cardinal_0;  // Attributes.
    reg [8:0] splat_left;  // First column.
    reg [8:0] splat_right;  // Last column.
    reg [8:0] splat_bottom;  // Last row.
    reg right_most, bottom_most;
    reg [5:0] column, row;
    reg [2:0] left, right, top, bottom;
    reg [11:0] first_sum_here, first_sum_row_begins, last_sum_here, last_sum_row_begins, first_difference_here;
    reg [11:0] first_difference_row_begins, last_difference_here, last_difference_row_begins;
    reg [3:0] first_sum;
    reg [4:0] last_sum, last_difference;
    reg [3:0] not_first_difference;
    reg [4:0] not_last_difference;
    reg first_sum_not_half, last_sum_not_half, last_sum_not_negative, last_sum_over_half, first;

    wire out_queue_in_ready, out_queue_out_valid;
    wire [694:0] out_queue_out_data;

    wire [3:0] out_queue_out_made = out_queue_out_data[694:691];
    wire made = &out_queue_out_made;
    wire out_queue_out_first = out_queue_out_data[689];
    wire out_first_either = out_queue_out_first | none_made;
    wire [4:0] out_queue_in_data_difference = {last_sum_not_negative, last_sum[3:0]} - {2'd0, left};
    wire out_queue_in_data_both = ({2'd2, top} <= {2'd2, bottom}) & ({2'd2, top} <= out_queue_in_data_difference);
    wire [4:0] out_queue_in_data_sum = {2'd3, right} + {1'd1, not_first_difference};
    wire [5:0] out_queue_in_data_sum_2 = {1'd1, last_sum_over_half, last_sum_not_half, last_sum[2:0]} + {2'd3, not_first_difference};
    wire out_queue_in_data_both_2 = out_queue_in_data_both & ({2'd2, top} <= out_queue_in_data_sum) & ({2'd2, top} <= out_queue_in_data_sum_2[5:1]);
    wire [4:0] out_queue_in_data_difference_2 = {1'd1, first_sum} - {2'd0, right};
    wire out_queue_in_data_both_3 = (out_queue_in_data_difference_2 <= {2'd2, bottom}) & (out_queue_in_data_difference_2 <= out_queue_in_data_difference);
    wire out_queue_in_data_both_4 = out_queue_in_data_both_3 & (out_queue_in_data_difference_2 <= out_queue_in_data_sum);
    wire out_queue_in_data_both_5 = out_queue_in_data_both_4 & (out_queue_in_data_difference_2 <= out_queue_in_data_sum_2[5:1]);
    wire [4:0] out_queue_in_data_sum_3 = {2'd3, left} + not_last_difference;
    wire out_queue_in_data_both_6 = (out_queue_in_data_sum_3 <= {2'd2, bottom}) & (out_queue_in_data_sum_3 <= out_queue_in_data_difference);
    wire out_queue_in_data_both_7 = out_queue_in_data_both_6 & (out_queue_in_data_sum_3 <= out_queue_in_data_sum);
    wire out_queue_in_data_both_8 = out_queue_in_data_both_7 & (out_queue_in_data_sum_3 <= out_queue_in_data_sum_2[5:1]);
    wire [5:0] out_queue_in_data_difference_3 = {1'd1, first_sum[3], first_sum_not_half, first_sum[2:0]} - {last_difference[4], last_difference};
    wire out_queue_in_data_in_order = out_queue_in_data_difference_3[5:1] <= out_queue_in_data_difference;
    wire out_queue_in_data_both_9 = (out_queue_in_data_difference_3[5:1] <= {2'd2, bottom}) & out_queue_in_data_in_order;
    wire out_queue_in_data_both_10 = out_queue_in_data_both_9 & (out_queue_in_data_difference_3[5:1] <= out_queue_in_data_sum);
    wire out_queue_in_data_in_order_2 = out_queue_in_data_difference_3[5:1] <= out_queue_in_data_sum_2[5:1];
    wire out_queue_in_data_either = splat_end | (out_queue_in_data_both_10 & out_queue_in_data_in_order_2);
    wire out_queue_in_data_in_order_3 = out_queue_in_data_difference_2 <= {2'd2, top};
    wire out_queue_in_data_in_order_4 = out_queue_in_data_sum_3 <= {2'd2, top};
    wire out_queue_in_data_in_order_5 = out_queue_in_data_difference_3[5:1] <= {2'd2, top};
    wire out_queue_in_data_both_11 = out_queue_in_data_in_order_3 & out_queue_in_data_in_order_4 & out_queue_in_data_in_order_5;
    wire out_queue_in_data_in_order_6 = out_queue_in_data_sum_3 <= out_queue_in_data_difference_2;
    wire out_queue_in_data_in_order_7 = out_queue_in_data_difference_3[5:1] <= out_queue_in_data_difference_2;
    wire out_queue_in_data_both_12 = ~out_queue_in_data_in_order_3 & out_queue_in_data_in_order_6 & out_queue_in_data_in_order_7;
    wire [4:0] out_queue_in_data_either_2 = ({5{out_queue_in_data_both_11}} & {2'd2, top}) | ({5{out_queue_in_data_both_12}} & out_queue_in_data_difference_2);
    wire out_queue_in_data_in_order_8 = out_queue_in_data_difference_3[5:1] <= out_queue_in_data_sum_3;
    wire out_queue_in_data_both_13 = ~out_queue_in_data_in_order_4 & ~out_queue_in_data_in_order_6 & out_queue_in_data_in_order_8;
    wire [4:0] out_queue_in_data_either_3 = out_queue_in_data_either_2 | ({5{out_queue_in_data_both_13}} & out_queue_in_data_sum_3);
    wire out_queue_in_data_both_14 = ~out_queue_in_data_in_order_5 & ~out_queue_in_data_in_order_7 & ~out_queue_in_data_in_order_8;
    wire [4:0] out_queue_in_data_both_15 = {5{out_queue_in_data_both_14}} & out_queue_in_data_difference_3[5:1];
    wire [4:0] out_queue_in_data_either_4 = out_queue_in_data_either_3 | out_queue_in_data_both_15;
    wire out_queue_in_data_in_order_9 = {2'd2, bottom} <= out_queue_in_data_difference;
    wire out_queue_in_data_in_order_10 = {2'd2, bottom} <= out_queue_in_data_sum;
    wire out_queue_in_data_in_order_11 = {2'd2, bottom} <= out_queue_in_data_sum_2[5:1];
    wire out_queue_in_data_both_16 = out_queue_in_data_in_order_9 & out_queue_in_data_in_order_10 & out_queue_in_data_in_order_11;
    wire out_queue_in_data_in_order_12 = out_queue_in_data_difference <= out_queue_in_data_sum;
    wire out_queue_in_data_in_order_13 = out_queue_in_data_difference <= out_queue_in_data_sum_2[5:1];
    wire out_queue_in_data_both_17 = ~out_queue_in_data_in_order_9 & out_queue_in_data_in_order_12 & out_queue_in_data_in_order_13;
    wire [4:0] out_queue_in_data_either_5 = ({5{out_queue_in_data_both_16}} & {2'd2, bottom}) | ({5{out_queue_in_data_both_17}} & out_queue_in_data_difference);
    wire out_queue_in_data_in_order_14 = out_queue_in_data_sum <= out_queue_in_data_sum_2[5:1];
    wire out_queue_in_data_both_18 = ~out_queue_in_data_in_order_10 & ~out_queue_in_data_in_order_12 & out_queue_in_data_in_order_14;
    wire [4:0] out_queue_in_data_either_6 = out_queue_in_data_either_5 | ({5{out_queue_in_data_both_18}} & out_queue_in_data_sum);
    wire out_queue_in_data_both_19 = ~out_queue_in_data_in_order_11 & ~out_queue_in_data_in_order_13 & ~out_queue_in_data_in_order_14;
    wire [4:0] out_queue_in_data_either_7 = out_queue_in_data_either_6 | ({5{out_queue_in_data_both_19}} & out_queue_in_data_sum_2[5:1]);
    wire out_queue_out_ready = out_ready | ~made;
    wire next_room = room ? ~busy : out_queue_out_ready;
    wire one_column = in_left[8:3] == in_right[8:3];
    wire one_row = in_top[8:3] == in_bottom[8:3];
    wire [5:0] column_plus_1 = column + 6'd1;
    wire reaches_right = right_most ? (splat_left[8:3] == splat_right[8:3]) : (column_plus_1 == splat_right[8:3]);
    wire [5:0] row_plus_1 = row + 6'd1;
    wire reaches_bottom = row_plus_1 == splat_bottom[8:3];
    wire open_choice = open ? (~in_valid | (in_end | (one_column & one_row))) : (reaches_right & (right_most ? reaches_bottom : bottom_most));
    wire next_ready = next_room & (room ? open_choice : open);
    wire turns = room & (open | right_most);
    wire [11:0] first_difference_arrives_inverted = ~{3'd0, in_left[8:3], 3'd0};
    wire [11:0] last_sum_arrives_inverted = ~{3'd0, in_top[8:3], 3'd0};
    wire [11:0] first_sum_arrives_unequal = {2'd0, in_first_sum} ^ first_difference_arrives_inverted ^ last_sum_arrives_inverted;
    wire [11:0] first_sum_arrives_either = ({2'd0, in_first_sum} & first_difference_arrives_inverted) | ({2'd0, in_first_sum} & last_sum_arrives_inverted);
    wire [11:0] last_sum_arrives_both = first_difference_arrives_inverted & last_sum_arrives_inverted;
    wire [11:0] first_sum_arrives_either_2 = first_sum_arrives_either | last_sum_arrives_both;
    wire [11:0] first_sum_arrives = first_sum_arrives_unequal - ~{first_sum_arrives_either_2[10:0], 1'd1};
    wire [11:0] first_sum_row_begins_minus_8 = first_sum_row_begins - 12'd8;
    wire [11:0] first_sum_moved = right_most ? first_sum_row_begins_minus_8 : (first_sum_here - 12'd8);
    wire [11:0] last_sum_arrives_unequal = {2'd0, in_last_sum} ^ first_difference_arrives_inverted ^ last_sum_arrives_inverted;
    wire [11:0] last_sum_arrives_either = ({2'd0, in_last_sum} & first_difference_arrives_inverted) | ({2'd0, in_last_sum} & last_sum_arrives_inverted);
    wire [11:0] last_sum_arrives_either_2 = last_sum_arrives_either | last_sum_arrives_both;
    wire [11:0] last_sum_arrives = last_sum_arrives_unequal - ~{last_sum_arrives_either_2[10:0], 1'd1};
    wire [11:0] last_sum_row_begins_minus_8 = last_sum_row_begins - 12'd8;
    wire [11:0] last_sum_moved = right_most ? last_sum_row_begins_minus_8 : (last_sum_here - 12'd8);
    wire [11:0] first_difference_arrives_inverted_2 = ~{3'd0, ~in_top[8:3], 3'd0};
    wire [11:0] first_difference_arrives_unequal = {2'd0, in_first_difference} ^ first_difference_arrives_inverted ^ first_difference_arrives_inverted_2;
    wire [11:0] first_difference_arrives_both = {2'd0, in_first_difference} & first_difference_arrives_inverted_2;
    wire [11:0] first_difference_arrives_either = ({2'd0, in_first_difference} & first_difference_arrives_inverted) | first_difference_arrives_both;
    wire [11:0] first_difference_arrives_both_2 = first_difference_arrives_inverted & first_difference_arrives_inverted_2;
    wire [11:0] first_difference_arrives_either_2 = first_difference_arrives_either | first_difference_arrives_both_2;
    wire [11:0] first_difference_arrives = first_difference_arrives_unequal - ~{first_difference_arrives_either_2[10:0], 1'd1};
    wire [11:0] first_difference_row_begins_sum = first_difference_row_begins + 12'd8;
    wire [11:0] first_difference_moved = right_most ? first_difference_row_begins_sum : (first_difference_here - 12'd8);
    wire [11:0] last_difference_arrives_unequal = {2'd0, in_last_difference} ^ first_difference_arrives_inverted ^ first_difference_arrives_inverted_2;
    wire [11:0] last_difference_arrives_either = ({2'd0, in_last_difference} & first_difference_arrives_inverted) | ({2'd0, in_last_difference} & first_difference_arrives_inverted_2);
    wire [11:0] last_difference_arrives_either_2 = last_difference_arrives_either | first_difference_arrives_both_2;
    wire [11:0] last_difference_arrives = last_difference_arrives_unequal - ~{last_difference_arrives_either_2[10:0], 1'd1};
    wire [11:0] last_difference_row_begins_sum = last_difference_row_begins + 12'd8;
    wire [11:0] last_difference_moved = right_most ? last_difference_row_begins_sum : (last_difference_here - 12'd8);
    wire [3:0] first_sum_choice = first_sum_arrives[11] ? 4'd0 : |first_sum_arrives[10:4] ? 4'd15 : first_sum_arrives[3:0];
    wire [3:0] first_sum_choice_2 = first_sum_moved[11] ? 4'd0 : |first_sum_moved[10:4] ? 4'd15 : first_sum_moved[3:0];
    wire [3:0] first_sum_choice_3 = open ? first_sum_choice : first_sum_choice_2;
    wire [3:0] last_sum_choice = (|last_sum_arrives[10:4] | &last_sum_arrives[3:0]) ? 4'd14 : last_sum_arrives[3:0];
    wire [4:0] last_sum_bits = {last_sum_arrives[11], {4{last_sum_arrives[11]}} | last_sum_choice};
    wire [3:0] last_sum_choice_2 = (|last_sum_moved[10:4] | &last_sum_moved[3:0]) ? 4'd14 : last_sum_moved[3:0];
    wire [4:0] last_sum_bits_2 = {last_sum_moved[11], {4{last_sum_moved[11]}} | last_sum_choice_2};
    wire [4:0] last_sum_choice_3 = open ? last_sum_bits : last_sum_bits_2;
    wire [3:0] last_difference_choice = (|last_difference_arrives[10:4] | &last_difference_arrives[3:0]) ? 4'd14 : last_difference_arrives[3:0];
    wire [4:0] last_difference_bits = {last_difference_arrives[11], {4{last_difference_arrives[11]}} | last_difference_choice};
    wire [3:0] last_difference_choice_2 = (|last_difference_moved[10:4] | &last_difference_moved[3:0]) ? 4'd14 : last_difference_moved[3:0];
    wire [4:0] last_difference_bits_2 = {last_difference_moved[11], {4{last_difference_moved[11]}} | last_difference_choice_2};
    wire [4:0] last_difference_choice_3 = open ? last_difference_bits : last_difference_bits_2;
    wire [3:0] not_first_difference_choice = |first_difference_arrives[10:4] ? 4'd15 : first_difference_arrives[3:0];
    wire [3:0] not_first_difference_choice_2 = first_difference_arrives[11] ? 4'd0 : not_first_difference_choice;
    wire [3:0] not_first_difference_choice_3 = |first_difference_moved[10:4] ? 4'd15 : first_difference_moved[3:0];
    wire [3:0] not_first_difference_choice_4 = first_difference_moved[11] ? 4'd0 : not_first_difference_choice_3;
    wire [3:0] not_first_difference_choice_5 = open ? not_first_difference_choice_2 : not_first_difference_choice_4;

    assign in_ready = ready;
    assign out_valid = out_queue_out_valid & made;
    assign out_end = out_queue_out_data[690];
    assign out_first = out_first_either;
    assign {
        out_center_x, out_center_y, out_ax, out_bx, out_ay, out_by, out_delta, out_mx, out_my,
        out_sight_negative, out_sight_near, out_sight_far, out_sight_turned, out_sight_disc, out_depth,
        out_depth_low, out_depth_high, out_attribute_0, out_attribute_1, out_attribute_2, out_attribute_3,
        out_attribute_4, out_attribute_5, out_attribute_6, out_attribute_7, out_attribute_8, out_attribute_9,
        out_attribute_10, out_attribute_11, out_attribute_12, out_cardinal_0, out_left, out_right, out_top,
        out_bottom, out_first_sum, out_last_sum, out_first_difference, out_last_difference, out_tile
    } = out_queue_out_data[688:0];

    stream_half_buffer_w695 out_queue (
        .clk(clk), .rst(rst), .in_valid(room & busy), .in_ready(out_queue_in_ready),
        .in_data({
            splat_end | out_queue_in_data_both_2, splat_end | out_queue_in_data_both_5,
            splat_end | out_queue_in_data_both_8, out_queue_in_data_either, splat_end, first, splat_center_x,
            splat_center_y, splat_ax, splat_bx, splat_ay, splat_by, splat_delta, splat_mx, splat_my,
            splat_sight_negative, splat_sight_near, splat_sight_far, splat_sight_turned, splat_sight_disc,
            splat_depth, splat_depth_low, splat_depth_high, splat_attribute_0, splat_attribute_1,
            splat_attribute_2, splat_attribute_3, splat_attribute_4, splat_attribute_5, splat_attribute_6,
            splat_attribute_7, splat_attribute_8, splat_attribute_9, splat_attribute_10, splat_attribute_11,
            splat_attribute_12, splat_cardinal_0, left, right, out_queue_in_data_either_4[2:0],
            out_queue_in_data_either_7[2:0], first_sum, last_sum[3:0], ~not_first_difference,
            last_difference[3:0], row, column
        }),
        .out_valid(out_queue_out_valid), .out_ready(out_queue_out_ready), .out_data(out_queue_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            room <= 1'd1;
            busy <= 1'd0;
            open <= 1'd1;
            ready <= 1'd1;
            closed <= 1'd0;
        end else begin
            room <= next_room;
            ready <= next_ready;
            closed <= ~next_ready;
            if (room) begin
                busy <= open ? in_valid : busy;
                open <= open_choice;
            end
        end
    end
    always @(posedge clk) begin
        if (out_queue_out_valid & out_queue_out_ready) none_made <= out_first_either & ~made;
        if (~closed) begin
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
            splat_sight_negative <= in_sight_negative;
            splat_sight_near <= in_sight_near;
            splat_sight_far <= in_sight_far;
            splat_sight_turned <= in_sight_turned;
            splat_sight_disc <= in_sight_disc;
            splat_depth <= in_depth;
            splat_depth_low <= in_depth_low;
            splat_depth_high <= in_depth_high;
            splat_attribute_0 <= in_attribute_0;
            splat_attribute_1 <= in_attribute_1;
            splat_attribute_2 <= in_attribute_2;
            splat_attribute_3 <= in_attribute_3;
            splat_attribute_4 <= in_attribute_4;
            splat_attribute_5 <= in_attribute_5;
            splat_attribute_6 <= in_attribute_6;
            splat_attribute_7 <= in_attribute_7;
            splat_attribute_8 <= in_attribute_8;
            splat_attribute_9 <= in_attribute_9;
            splat_attribute_10 <= in_attribute_10;
            splat_attribute_11 <= in_attribute_11;
            splat_attribute_12 <= in_attribute_12;
            splat_cardinal_0 <= in_cardinal_0;
            splat_left <= in_left;
            splat_right <= in_right;
            splat_bottom <= in_bottom;
        end
        if (room) begin
            right_most <= open ? one_column : reaches_right;
            column <= open ? in_left[8:3] : right_most ? splat_left[8:3] : column_plus_1;
            left <= open ? in_left[2:0] : right_most ? splat_left[2:0] : 3'd0;
            right <= open ? (one_column ? in_right[2:0] : 3'd7) : reaches_right ? splat_right[2:0] : 3'd7;
            first_sum_here <= open ? first_sum_arrives : first_sum_moved;
            last_sum_here <= open ? last_sum_arrives : last_sum_moved;
            first_difference_here <= open ? first_difference_arrives : first_difference_moved;
            last_difference_here <= open ? last_difference_arrives : last_difference_moved;
            first_sum <= first_sum_choice_3;
            last_sum <= last_sum_choice_3;
            last_difference <= last_difference_choice_3;
            not_first_difference <= ~not_first_difference_choice_5;
            not_last_difference <= ~last_difference_choice_3;
            first_sum_not_half <= ~first_sum_choice_3[3];
            last_sum_not_half <= ~last_sum_choice_3[3];
            last_sum_not_negative <= ~last_sum_choice_3[4];
            last_sum_over_half <= last_sum_choice_3[3] & ~last_sum_choice_3[4];
            first <= open;
        end
        if (turns) begin
            bottom_most <= open ? one_row : reaches_bottom;
            row <= open ? in_top[8:3] : row_plus_1;
            top <= open ? in_top[2:0] : 3'd0;
            bottom <= open ? (one_row ? in_bottom[2:0] : 3'd7) : reaches_bottom ? splat_bottom[2:0] : 3'd7;
            first_sum_row_begins <= open ? first_sum_arrives : first_sum_row_begins_minus_8;
            last_sum_row_begins <= open ? last_sum_arrives : last_sum_row_begins_minus_8;
            first_difference_row_begins <= open ? first_difference_arrives : first_difference_row_begins_sum;
            last_difference_row_begins <= open ? last_difference_arrives : last_difference_row_begins_sum;
        end
    end

    wire _unused = &{
        1'b0, first_difference_arrives_either_2[11], first_sum_arrives_either_2[11],
        last_difference_arrives_either_2[11], last_sum[4], last_sum_arrives_either_2[11],
        out_queue_in_data_difference_3[0], out_queue_in_data_either_4[4:3], out_queue_in_data_either_7[4:3],
        out_queue_in_data_sum_2[0], out_queue_in_ready
    };

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        room_is_that_of_the_way_out: assert (room == out_queue_in_ready);
        ready_while_open_and_room: assert ((ready == (room & open)) & (ready ^ closed));
`else
        if (!(room == out_queue_in_ready)) begin
            $display("assertion failed: room_is_that_of_the_way_out in %m"); $stop;
        end
        if (!((ready == (room & open)) & (ready ^ closed))) begin
            $display("assertion failed: ready_while_open_and_room in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// One item in a register, at half rate.
// width = 695
module stream_half_buffer_w695 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [694:0] in_data,
    output wire out_valid, input wire out_ready, output wire [694:0] out_data
);
    reg filled;
    reg [694:0] item;

    assign in_ready = ~filled;

    assign out_valid = filled;
    assign out_data = item;

    always @(posedge clk) begin
        if (rst) filled <= 1'd0;
        else filled <= filled ? ~out_ready : in_valid;
    end
    always @(posedge clk) if (in_ready) item <= in_data;
endmodule

// Footprint, depth band and bounding octagon of a splat.
// latency = 186
// initiation_interval = 2
module splat_setup (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready,  // Splats in camera space.
    input  wire in_end,  // Closes the frame.
    input  wire [31:0] in_center_x,  // Center.
    input  wire [31:0] in_center_y,  // Center.
    input  wire [31:0] in_center_z,  // Center.
    input  wire [31:0] in_tangent1_x,  // Tangents, whose ends lie at rho = 1.
    input  wire [31:0] in_tangent1_y,  // Tangents, whose ends lie at rho = 1.
    input  wire [31:0] in_tangent1_z,  // Tangents, whose ends lie at rho = 1.
    input  wire [31:0] in_tangent2_x,  // Tangents, whose ends lie at rho = 1.
    input  wire [31:0] in_tangent2_y,  // Tangents, whose ends lie at rho = 1.
    input  wire [31:0] in_tangent2_z,  // Tangents, whose ends lie at rho = 1.
    input  wire [15:0] in_attribute_0,  // Attributes.
    input  wire [15:0] in_attribute_1,  // Attributes.
    input  wire [15:0] in_attribute_2,  // Attributes.
    input  wire [15:0] in_attribute_3,  // Attributes.
    input  wire [15:0] in_attribute_4,  // Attributes.
    input  wire [15:0] in_attribute_5,  // Attributes.
    input  wire [15:0] in_attribute_6,  // Attributes.
    input  wire [15:0] in_attribute_7,  // Attributes.
    input  wire [15:0] in_attribute_8,  // Attributes.
    input  wire [15:0] in_attribute_9,  // Attributes.
    input  wire [15:0] in_attribute_10,  // Attributes.
    input  wire [15:0] in_attribute_11,  // Attributes.
    input  wire [15:0] in_attribute_12,  // Attributes.
    input  wire [15:0] in_cardinal_0,  // Attributes.
    input  wire [31:0] near_plane,  // Near plane.
    input  wire [31:0] filter_radius,  // Radius of the screen filter (px).
    input  wire [31:0] depth_a,  // Depth is `depth_a + depth_b/z`, in `[0, 1]`.
    input  wire [31:0] depth_b,  // See `depth_a`.
    input  wire [31:0] epsilon_scale,  // Scale of the splat's own depth range.
    input  wire [31:0] epsilon_bias,  // Constant part.
    input  wire [31:0] scale_x,  // Scale (px).
    input  wire [31:0] origin_x,  // Where the optical axis meets the image (px).
    input  wire [31:0] scale_y,  // Scale (px).
    input  wire [31:0] origin_y,  // Where the optical axis meets the image (px).
    output wire out_valid, input wire out_ready,  // Footprints with bounds.
    output wire out_end,  // Closes the frame.
    output wire [31:0] out_center_x,  // Projected center (px), the origin of what follows.
    output wire [31:0] out_center_y,  // Projected center (px), the origin of what follows.
    output wire [31:0] out_ax,  // `A` in x.
    output wire [31:0] out_bx,  // `B` in x.
    output wire [31:0] out_ay,  // `A` in y.
    output wire [31:0] out_by,  // `B` in y.
    output wire [31:0] out_delta,  // The determinant of `A` and `B`.
    output wire [31:0] out_mx,  // `m` in x.
    output wire [31:0] out_my,  // `m` in y.
    output wire out_sight_negative,  // `D` is negative before the eye.
    output wire [30:0] out_sight_near,  // The magnitude of `D` at the near plane; all ones where no sample lies before it.
    output wire [30:0] out_sight_far,  // The magnitude of `D` at the far plane; zero where no sample lies behind it.
    output wire out_sight_turned,  // The origin is the vanishing point of a tangent: `s1` and `D` have changed places.
    output wire out_sight_disc,  // The origin is the splat's centre, and lies between near and far plane: the filter's disc is drawn.
    output wire [23:0] out_depth,  // Depth.
    output wire [23:0] out_depth_low,  // What is nearer hides the splat.
    output wire [23:0] out_depth_high,  // What is farther is hidden by the splat.
    output wire [15:0] out_attribute_0,  // Attributes.
    output wire [15:0] out_attribute_1,  // Attributes.
    output wire [15:0] out_attribute_2,  // Attributes.
    output wire [15:0] out_attribute_3,  // Attributes.
    output wire [15:0] out_attribute_4,  // Attributes.
    output wire [15:0] out_attribute_5,  // Attributes.
    output wire [15:0] out_attribute_6,  // Attributes.
    output wire [15:0] out_attribute_7,  // Attributes.
    output wire [15:0] out_attribute_8,  // Attributes.
    output wire [15:0] out_attribute_9,  // Attributes.
    output wire [15:0] out_attribute_10,  // Attributes.
    output wire [15:0] out_attribute_11,  // Attributes.
    output wire [15:0] out_attribute_12,  // Attributes.
    output wire [15:0] out_cardinal_0,  // Attributes.
    output wire [8:0] out_left,  // First column.
    output wire [8:0] out_right,  // Last column.
    output wire [8:0] out_top,  // First row.
    output wire [8:0] out_bottom,  // Last row.
    output wire [9:0] out_first_sum,  // Smallest sum.
    output wire [9:0] out_last_sum,  // Largest sum.
    output wire [9:0] out_first_difference,  // Smallest difference.
    output wire [9:0] out_last_difference  // Largest difference.
);
    (* ram_style = "distributed" *)
    reg [63:0] delay_6_from_0 [0:4];
    (* ram_style = "distributed" *)
    reg [1:0] delay_7_from_0 [0:5];
    (* ram_style = "distributed" *)
    reg [53:0] delay_8_from_0 [0:6];
    (* ram_style = "distributed" *)
    reg [85:0] delay_9_from_0 [0:7];
    (* ram_style = "distributed" *)
    reg [100:0] delay_10_from_0 [0:8];
    (* ram_style = "distributed" *)
    reg [8:0] delay_11_from_0 [0:9];
    (* ram_style = "distributed" *)
    reg [18:0] delay_12_from_0 [0:10];
    (* ram_style = "distributed" *)
    reg [96:0] delay_14_from_0 [0:12];
    (* ram_style = "distributed" *)
    reg [23:0] delay_18_from_0 [0:16];
    (* ram_style = "distributed" *)
    reg [63:0] delay_20_from_0 [0:18];
    (* ram_style = "distributed" *)
    reg [63:0] delay_22_from_0 [0:20];
    (* ram_style = "distributed" *)
    reg [63:0] delay_23_from_0 [0:21];
    (* ram_style = "distributed" *)
    reg [23:0] delay_28_from_0 [0:26];
    (* ram_style = "distributed" *)
    reg [31:0] delay_29_from_0 [0:27];
    (* ram_style = "distributed" *)
    reg [1:0] delay_32_from_0 [0:30];
    (* ram_style = "distributed" *)
    reg delay_36_from_0 [0:34];
    (* ram_style = "distributed" *)
    reg [63:0] delay_39_from_0 [0:37];
    (* ram_style = "distributed" *)
    reg [61:0] delay_43_from_0 [0:41];
    (* ram_style = "distributed" *)
    reg [96:0] delay_50_from_0 [0:48];
    (* ram_style = "distributed" *)
    reg [95:0] delay_51_from_0 [0:49];
    (* ram_style = "distributed" *)
    reg [31:0] delay_51_from_0_copy2 [0:49];
    (* ram_style = "distributed" *)
    reg delay_53_from_0 [0:51];
    (* ram_style = "distributed" *)
    reg delay_56_from_0 [0:54];
    (* ram_style = "distributed" *)
    reg delay_63_from_0 [0:61];
    (* ram_style = "distributed" *)
    reg [63:0] delay_5_from_1 [0:3];
    (* ram_style = "distributed" *)
    reg delay_6_from_1 [0:4];
    (* ram_style = "distributed" *)
    reg [32:0] delay_8_from_1 [0:6];
    (* ram_style = "distributed" *)
    reg [43:0] delay_9_from_1 [0:7];
    (* ram_style = "distributed" *)
    reg [3:0] delay_10_from_1 [0:8];
    (* ram_style = "distributed" *)
    reg [107:0] delay_11_from_1 [0:9];
    (* ram_style = "distributed" *)
    reg [106:0] delay_11_from_1_copy2 [0:9];
    (* ram_style = "distributed" *)
    reg [43:0] delay_12_from_1 [0:10];
    (* ram_style = "distributed" *)
    reg [63:0] delay_13_from_1 [0:11];
    (* ram_style = "distributed" *)
    reg [95:0] delay_14_from_1 [0:12];
    (* ram_style = "distributed" *)
    reg [31:0] delay_14_from_1_copy2 [0:12];
    (* ram_style = "distributed" *)
    reg [96:0] delay_16_from_1 [0:14];
    (* ram_style = "distributed" *)
    reg [96:0] delay_17_from_1 [0:15];
    (* ram_style = "distributed" *)
    reg [23:0] delay_18_from_1 [0:16];
    (* ram_style = "distributed" *)
    reg [10:0] delay_24_from_1 [0:22];
    (* ram_style = "distributed" *)
    reg [31:0] delay_25_from_1 [0:23];
    (* ram_style = "distributed" *)
    reg [63:0] delay_27_from_1 [0:25];
    (* ram_style = "distributed" *)
    reg [32:0] delay_30_from_1 [0:28];
    (* ram_style = "distributed" *)
    reg delay_36_from_1 [0:34];
    (* ram_style = "distributed" *)
    reg [1:0] delay_37_from_1 [0:35];
    (* ram_style = "distributed" *)
    reg [63:0] delay_43_from_1 [0:41];
    (* ram_style = "distributed" *)
    reg [4:0] delay_50_from_1 [0:48];
    (* ram_style = "distributed" *)
    reg [1:0] delay_54_from_1 [0:52];
    (* ram_style = "distributed" *)
    reg [26:0] delay_60_from_1 [0:58];
    (* ram_style = "distributed" *)
    reg [26:0] delay_61_from_1 [0:59];
    reg [7:0] credits;
    reg [1:0] phases_1;
    reg [2:0] delay_6_from_0_pointer;
    reg [63:0] delay_6_from_0_out;
    reg [2:0] delay_7_from_0_pointer;
    reg [1:0] delay_7_from_0_out, phases_2;
    reg [2:0] delay_8_from_0_pointer;
    reg [53:0] delay_8_from_0_out;
    reg [1:0] phases_3;
    reg [2:0] delay_9_from_0_pointer;
    reg [85:0] delay_9_from_0_out;
    reg [1:0] phases_4;
    reg [3:0] delay_10_from_0_pointer;
    reg [100:0] delay_10_from_0_out;
    reg [3:0] delay_11_from_0_pointer;
    reg [8:0] delay_11_from_0_out;
    reg [3:0] delay_12_from_0_pointer;
    reg [18:0] delay_12_from_0_out;
    reg [1:0] phases_5;
    reg [3:0] delay_14_from_0_pointer;
    reg [96:0] delay_14_from_0_out;
    reg [4:0] delay_18_from_0_pointer;
    reg [23:0] delay_18_from_0_out;
    reg [1:0] phases_6;
    reg [4:0] delay_20_from_0_pointer;
    reg [63:0] delay_20_from_0_out;
    reg [1:0] phases_7;
    reg [4:0] delay_22_from_0_pointer;
    reg [63:0] delay_22_from_0_out;
    reg [1:0] phases_8;
    reg [4:0] delay_23_from_0_pointer;
    reg [63:0] delay_23_from_0_out;
    reg [4:0] delay_28_from_0_pointer;
    reg [23:0] delay_28_from_0_out;
    reg [4:0] delay_29_from_0_pointer;
    reg [31:0] delay_29_from_0_out;
    reg [4:0] delay_32_from_0_pointer;
    reg [1:0] delay_32_from_0_out;
    reg [5:0] delay_36_from_0_pointer;
    reg delay_36_from_0_out;
    reg [1:0] phases_9;
    reg [5:0] delay_39_from_0_pointer;
    reg [63:0] delay_39_from_0_out;
    reg [1:0] phases_10;
    reg [5:0] delay_43_from_0_pointer;
    reg [61:0] delay_43_from_0_out;
    reg [1:0] phases_11;
    reg [5:0] delay_50_from_0_pointer;
    reg [96:0] delay_50_from_0_out;
    reg [1:0] phases_12;
    reg [5:0] delay_51_from_0_pointer;
    reg [95:0] delay_51_from_0_out;
    reg [5:0] delay_51_from_0_copy2_pointer;
    reg [31:0] delay_51_from_0_copy2_out;
    reg [5:0] delay_53_from_0_pointer;
    reg delay_53_from_0_out;
    reg [5:0] delay_56_from_0_pointer;
    reg delay_56_from_0_out;
    reg [5:0] delay_63_from_0_pointer;
    reg delay_63_from_0_out;
    reg [1:0] phases_13;
    reg [6:0] delay_93_from_0_pointer;
    wire [96:0] delay_93_from_0_out;
    reg [1:0] phases_14;
    reg [6:0] delay_93_from_0_copy2_pointer;
    wire [95:0] delay_93_from_0_copy2_out;
    reg [6:0] delay_93_from_0_copy3_pointer;
    wire [31:0] delay_93_from_0_copy3_out;
    reg [1:0] delay_5_from_1_pointer;
    reg [63:0] delay_5_from_1_out;
    reg [2:0] delay_6_from_1_pointer;
    reg delay_6_from_1_out;
    reg [2:0] delay_8_from_1_pointer;
    reg [32:0] delay_8_from_1_out;
    reg [2:0] delay_9_from_1_pointer;
    reg [43:0] delay_9_from_1_out;
    reg [3:0] delay_10_from_1_pointer, delay_10_from_1_out, delay_11_from_1_pointer;
    reg [107:0] delay_11_from_1_out;
    reg [3:0] delay_11_from_1_copy2_pointer;
    reg [106:0] delay_11_from_1_copy2_out;
    reg [3:0] delay_12_from_1_pointer;
    reg [43:0] delay_12_from_1_out;
    reg [3:0] delay_13_from_1_pointer;
    reg [63:0] delay_13_from_1_out;
    reg [3:0] delay_14_from_1_pointer;
    reg [95:0] delay_14_from_1_out;
    reg [3:0] delay_14_from_1_copy2_pointer;
    reg [31:0] delay_14_from_1_copy2_out;
    reg [3:0] delay_16_from_1_pointer;
    reg [96:0] delay_16_from_1_out;
    reg [3:0] delay_17_from_1_pointer;
    reg [96:0] delay_17_from_1_out;
    reg [4:0] delay_18_from_1_pointer;
    reg [23:0] delay_18_from_1_out;
    reg [4:0] delay_24_from_1_pointer;
    reg [10:0] delay_24_from_1_out;
    reg [4:0] delay_25_from_1_pointer;
    reg [31:0] delay_25_from_1_out;
    reg [4:0] delay_27_from_1_pointer;
    reg [63:0] delay_27_from_1_out;
    reg [4:0] delay_30_from_1_pointer;
    reg [32:0] delay_30_from_1_out;
    reg [5:0] delay_36_from_1_pointer;
    reg delay_36_from_1_out;
    reg [5:0] delay_37_from_1_pointer;
    reg [1:0] delay_37_from_1_out;
    reg [5:0] delay_43_from_1_pointer;
    reg [63:0] delay_43_from_1_out;
    reg [5:0] delay_50_from_1_pointer;
    reg [4:0] delay_50_from_1_out;
    reg [5:0] delay_54_from_1_pointer;
    reg [1:0] delay_54_from_1_out;
    reg [5:0] delay_60_from_1_pointer;
    reg [26:0] delay_60_from_1_out;
    reg [5:0] delay_61_from_1_pointer;
    reg [26:0] delay_61_from_1_out;
    reg [6:0] delay_85_from_1_pointer;
    wire delay_85_from_1_out;
    reg [31:0] center_x_d1, center_x_d2, center_x_d3;
    reg [1:0] phases_15;
    reg [31:0] center_y_d1, center_y_d2, center_y_d3, center_z_d1;
    reg [1:0] phases_16;
    reg [31:0] center_z_d2, center_z_d3, center_z_d4, tangent1_x_d1;
    reg [1:0] phases_17;
    reg [31:0] tangent1_x_d2, tangent1_x_d3, tangent1_y_d1, tangent1_y_d2;
    reg [1:0] phases_18;
    reg [31:0] tangent1_y_d3, tangent1_z_d1, tangent1_z_d2, tangent1_z_d3;
    reg [1:0] phases_19;
    reg [31:0] tangent2_x_d1, tangent2_x_d2, tangent2_x_d3, tangent2_y_d1;
    reg [1:0] phases_20;
    reg [31:0] tangent2_y_d2, tangent2_y_d3, tangent2_z_d1, tangent2_z_d2;
    reg [1:0] phases_21;
    reg [31:0] tangent2_z_d3;
    reg [10:0] first_x_greater_bits_d1, first_x_greater_bits_plus_1_d1;
    reg first_x_in_order_d1, first_x_inverted_d1, first_x_greater_bits_is_255_d1, first_x_in_order_d1_copy2;
    reg first_x_both_d1;
    reg [22:0] first_x_greater_bits_d1_copy2;
    reg first_x_either_d1, first_x_greater_sign_d1;
    reg [31:0] first_x_joined_d1;
    reg [10:0] first_y_greater_bits_d1, first_y_greater_bits_plus_1_d1;
    reg first_y_in_order_d1, first_y_inverted_d1, first_y_greater_bits_is_255_d1, first_y_in_order_d1_copy2;
    reg first_y_both_d1;
    reg [22:0] first_y_greater_bits_d1_copy2;
    reg first_y_either_d1, first_y_greater_sign_d1;
    reg [31:0] first_y_joined_d1;
    reg [10:0] reaches_near_greater_bits_d1, reaches_near_sum_d1;
    reg zero_below_reaches_near_sum_d1, not_reaches_near_same_d1, reaches_near_same_d1;
    reg reaches_near_in_order_d1, reaches_near_both_d1;
    reg [22:0] reaches_near_greater_bits_d1_copy2;
    reg reaches_near_either_d1, reaches_near_greater_sign_d1;
    reg [31:0] reaches_near_joined_d1;
    reg swapped_d1, swapped_d2;
    reg [10:0] turned_greater_d1, center_z_bits_plus_10_d1;
    reg turned_either_d1, turned_either_d2, turned_d1, turned_d2, turned_d3, turned_d4, turned_d5;
    reg [7:0] lowered_chosen_bits_d1;
    reg [10:0] lowered_chosen_bits_d1_copy2, lowered_chosen_bits_d2, lowered_chosen_bits_d3;
    reg [7:0] lowered_chosen_bits_d1_copy3;
    reg [10:0] lowered_chosen_bits_d1_copy4, lowered_chosen_bits_d2_copy2, lowered_chosen_bits_d3_copy2;
    reg [10:0] lowered_greater_d1;
    reg [7:0] lowered_chosen_bits_d1_copy5;
    reg [10:0] lowered_chosen_bits_d1_copy6, lowered_chosen_bits_d2_copy3, lowered_chosen_bits_d3_copy3;
    reg [10:0] lowered_greater_d1_copy2;
    reg [7:0] lowered_chosen_bits_d1_copy7;
    reg [10:0] lowered_chosen_bits_d1_copy8, lowered_chosen_bits_d2_copy4, lowered_chosen_bits_d3_copy4;
    reg [10:0] lowered_greater_d1_copy3;
    reg [7:0] lowered_chosen_bits_d1_copy9;
    reg [10:0] lowered_chosen_bits_d1_copy10, lowered_chosen_bits_d2_copy5, lowered_chosen_bits_d3_copy5;
    reg [10:0] lowered_greater_d1_copy4;
    reg [7:0] lowered_chosen_bits_d1_copy11;
    reg [10:0] lowered_chosen_bits_d1_copy12, lowered_chosen_bits_d2_copy6, lowered_chosen_bits_d3_copy6;
    reg [10:0] lowered_greater_d1_copy5;
    reg [7:0] lowered_chosen_bits_d1_copy13;
    reg [10:0] lowered_chosen_bits_plus_60_d1, lowered_chosen_bits_plus_60_d2, lowered_d1, lowered_d26, lowered_d27;
    reg a_x_inverted_d1, a_x_inverted_d2, a_x_inverted_d3, a_x_in_order_and_a_x_inverted_d1;
    reg lowered_chosen_bits_is_255_d1;
    reg [22:0] lowered_chosen_bits_d1_copy14, lowered_chosen_bits_d2_copy7, lowered_chosen_bits_d3_copy7;
    reg [22:0] lowered_chosen_bits_d4;
    reg [7:0] a_x_chosen_d1;
    reg lowered_chosen_sign_d1, lowered_chosen_sign_d2, lowered_chosen_sign_d3, lowered_chosen_sign_d4;
    reg a_y_inverted_d1, a_y_inverted_d2, a_y_inverted_d3, a_y_in_order_and_a_y_inverted_d1;
    reg lowered_chosen_bits_is_255_d1_copy2;
    reg [22:0] lowered_chosen_bits_d1_copy15, lowered_chosen_bits_d2_copy8, lowered_chosen_bits_d3_copy8;
    reg [22:0] lowered_chosen_bits_d4_copy2;
    reg [7:0] a_y_chosen_d1;
    reg lowered_chosen_sign_d1_copy2, lowered_chosen_sign_d2_copy2, lowered_chosen_sign_d3_copy2;
    reg lowered_chosen_sign_d4_copy2, alpha_inverted_d1, alpha_inverted_d2, alpha_inverted_d3, alpha_both_d1;
    reg lowered_chosen_bits_is_255_d1_copy3;
    reg [22:0] lowered_chosen_bits_d1_copy16, lowered_chosen_bits_d2_copy9, lowered_chosen_bits_d3_copy9;
    reg [22:0] lowered_chosen_bits_d4_copy3;
    reg [7:0] alpha_chosen_d1;
    reg lowered_chosen_sign_d1_copy3, lowered_chosen_sign_d2_copy3, lowered_chosen_sign_d3_copy3;
    reg lowered_chosen_sign_d4_copy3, b_x_inverted_d1, b_x_inverted_d2, b_x_inverted_d3;
    reg b_x_in_order_and_b_x_inverted_d1, lowered_chosen_bits_is_255_d1_copy4;
    reg [22:0] lowered_chosen_bits_d1_copy17, lowered_chosen_bits_d2_copy10, lowered_chosen_bits_d3_copy10;
    reg [22:0] lowered_chosen_bits_d4_copy4;
    reg [7:0] b_x_chosen_d1;
    reg lowered_chosen_sign_d1_copy4, lowered_chosen_sign_d2_copy4, lowered_chosen_sign_d3_copy4;
    reg lowered_chosen_sign_d4_copy4, b_y_inverted_d1, b_y_inverted_d2, b_y_inverted_d3;
    reg b_y_in_order_and_b_y_inverted_d1, lowered_chosen_bits_is_255_d1_copy5;
    reg [22:0] lowered_chosen_bits_d1_copy18, lowered_chosen_bits_d2_copy11, lowered_chosen_bits_d3_copy11;
    reg [22:0] lowered_chosen_bits_d4_copy5;
    reg [7:0] b_y_chosen_d1;
    reg lowered_chosen_sign_d1_copy5, lowered_chosen_sign_d2_copy5, lowered_chosen_sign_d3_copy5;
    reg lowered_chosen_sign_d4_copy5, beta_inverted_d1, beta_inverted_d2, beta_inverted_d3, beta_both_d1;
    reg lowered_chosen_bits_is_255_d1_copy6;
    reg [22:0] lowered_chosen_bits_d1_copy19, lowered_chosen_bits_d2_copy12, lowered_chosen_bits_d3_copy12;
    reg [22:0] lowered_chosen_bits_d4_copy6;
    reg [7:0] beta_chosen_d1;
    reg lowered_chosen_sign_d1_copy6, lowered_chosen_sign_d2_copy6, lowered_chosen_sign_d3_copy6;
    reg lowered_chosen_sign_d4_copy6, not_turned_d1, beyond_near_and_not_turned_d15;
    reg beyond_near_and_not_turned_d16, beyond_near_and_not_turned_d17;
    reg [1:0] phases_22;
    reg [31:0] r_d1, r_d2, r_d3, r_d4, alpha_d12, beta_d12, e_d1;
    reg zero_is_lowered_d1, whole_d43;
    reg [31:0] f_chosen_d1, f_d1, f_d2, f_d3, f_d4, spread_half_d1, spread_half_d2, spread_half_d3;
    reg [1:0] phases_23;
    reg [31:0] one_minus_depth_a_d1, before_far_sum_d1, before_far_joined_d1;
    reg sight_disc_out_d51;
    reg [31:0] middle_depth_d1, a_x_d1, b_x_d1, center_x_minus_first_x_joined_d1, center_x_plus_first_x_joined_d1;
    reg [31:0] first_x_joined_d1_copy2, first_x_chosen_d1, first_x_chosen_d2, last_x_chosen_d1, last_x_chosen_d2;
    reg [21:0] first_x_shifted_d1, first_x_shifted_d2;
    reg [1:0] phases_24;
    reg [21:0] first_x_shifted_d3, last_x_shifted_d1, last_x_lesser_d1;
    reg [31:0] a_y_d1, b_y_d1, center_y_d1_copy2, center_y_d44, minus_h_y_d1;
    reg [1:0] phases_25;
    reg [31:0] center_y_minus_first_y_joined_d1, center_y_plus_first_y_joined_d1, first_y_joined_d1_copy2;
    reg [31:0] first_y_chosen_d1, first_y_chosen_d2, last_y_chosen_d1;
    reg [1:0] phases_26;
    reg [31:0] last_y_chosen_d2;
    reg [21:0] first_y_shifted_d1, first_y_shifted_d2, first_y_shifted_d3;
    reg [31:0] last_y_greater_d1;
    reg [21:0] last_y_shifted_d1, last_y_lesser_d1;
    reg [10:0] a_x_bits_d1, a_x_bits_d11, a_y_bits_d1, a_y_bits_d11, a_exponent_d1, b_x_bits_d1, b_x_bits_d11;
    reg [10:0] b_y_bits_d1, b_y_bits_d11, b_exponent_d1, a_x_bits_plus_127_d1;
    reg not_zero_is_a_x_bits_d1, unit_delta_both_d1, a_x_bits_is_255_d1;
    reg [22:0] a_x_bits_d1_copy2;
    reg [7:0] unit_delta_chosen_d1;
    reg a_x_sign_d1;
    reg [10:0] a_y_bits_plus_127_d1;
    reg not_zero_is_a_y_bits_d1, unit_delta_both_d1_copy2, a_y_bits_is_255_d1;
    reg [22:0] a_y_bits_d1_copy2;
    reg [7:0] unit_delta_chosen_d1_copy2;
    reg a_y_sign_d1;
    reg [1:0] phases_27;
    reg [31:0] unit_delta_joined_d1, unit_delta_joined_d2;
    reg [10:0] b_x_bits_plus_127_d1;
    reg not_zero_is_b_x_bits_d1, unit_delta_both_d1_copy3, b_x_bits_is_255_d1;
    reg [22:0] b_x_bits_d1_copy2;
    reg [7:0] unit_delta_chosen_d1_copy3;
    reg b_x_sign_d1;
    reg [31:0] unit_delta_joined_d1_copy2;
    reg [1:0] phases_28;
    reg [31:0] unit_delta_joined_d2_copy2;
    reg [10:0] b_y_bits_plus_127_d1;
    reg not_zero_is_b_y_bits_d1, unit_delta_both_d1_copy4, b_y_bits_is_255_d1;
    reg [22:0] b_y_bits_d1_copy2;
    reg [7:0] unit_delta_chosen_d1_copy4;
    reg b_y_sign_d1;
    reg [31:0] unit_delta_product_d1;
    reg [10:0] beta_bits_d12, a_exponent_plus_beta_bits_d1, alpha_bits_d12, b_exponent_plus_alpha_bits_d1;
    reg [10:0] m_exponent_d1, mx_sum_d1;
    reg mx_both_d1, beta_bits_is_255_d1;
    reg [7:0] mx_chosen_d1;
    reg [31:0] mx_joined_d1;
    reg [10:0] mx_sum_d1_copy2;
    reg mx_both_d1_copy2, alpha_bits_is_255_d1;
    reg [7:0] mx_chosen_d1_copy2;
    reg [1:0] phases_29;
    reg [31:0] mx_joined_d1_copy2, minus_unit_delta_joined_d1, minus_unit_delta_joined_d2;
    reg [31:0] minus_unit_delta_joined_d1_copy2;
    reg [1:0] phases_30;
    reg [31:0] minus_unit_delta_joined_d2_copy2;
    reg [10:0] largest_sum_d9, largest_sum_d10, unit_delta_bits_d1, unit_delta_bits_d2, unit_delta_bits_d3;
    reg [10:0] largest_greater_d1;
    reg largest_sum_below_100_d1;
    reg [10:0] largest_sum_minus_100_d1, largest_chosen_d1, largest_greater_d1_copy2, largest_sum_plus_127_d1;
    reg [10:0] largest_chosen_d1_copy2, largest_greater_d1_copy3, largest_d1, a_x_bits_plus_381_d1;
    reg ax_out_both_d1;
    reg [7:0] ax_out_chosen_d1;
    reg [31:0] ax_out_joined_d1;
    reg [10:0] a_y_bits_plus_381_d1;
    reg ay_out_both_d1;
    reg [7:0] ay_out_chosen_d1;
    reg [31:0] ay_out_joined_d1;
    reg [10:0] b_x_bits_plus_381_d1;
    reg bx_out_both_d1;
    reg [7:0] bx_out_chosen_d1;
    reg [10:0] b_y_bits_plus_381_d1;
    reg by_out_both_d1;
    reg [7:0] by_out_chosen_d1;
    reg [10:0] delta_sum_d1;
    reg not_zero_is_unit_delta_bits_d1, not_zero_is_unit_delta_bits_d2, not_zero_is_unit_delta_bits_d3;
    reg delta_both_d1, unit_delta_bits_is_255_d1;
    reg [22:0] unit_delta_bits_d1_copy2, unit_delta_bits_d2_copy2, unit_delta_bits_d3_copy2;
    reg [7:0] delta_chosen_d1;
    reg unit_delta_sign_d1, unit_delta_sign_d2, unit_delta_sign_d3;
    reg [31:0] delta_d1;
    reg [10:0] mx_sum_bits_d1, mx_sum_bits_d2;
    reg [1:0] phases_31;
    reg [10:0] mx_sum_plus_mx_sum_bits_d1;
    reg not_zero_is_mx_sum_bits_d1, not_zero_is_mx_sum_bits_d2, mx_both_d1_copy3, mx_sum_bits_is_255_d1;
    reg [22:0] mx_sum_bits_d1_copy2, mx_sum_bits_d2_copy2;
    reg [30:0] mx_joined_d1_copy3;
    reg mx_sum_sign_d1, mx_sum_sign_d2, mx_sum_sign_d3;
    reg [10:0] my_sum_bits_d1, my_sum_bits_d2, mx_sum_plus_my_sum_bits_d1;
    reg not_zero_is_my_sum_bits_d1, not_zero_is_my_sum_bits_d2, my_both_d1, my_sum_bits_is_255_d1;
    reg [1:0] phases_32;
    reg [22:0] my_sum_bits_d1_copy2, my_sum_bits_d2_copy2;
    reg [30:0] my_joined_d1;
    reg my_sum_sign_d1, my_sum_sign_d2, my_sum_sign_d3;
    reg [10:0] edge_on_lesser_d1;
    reg unit_delta_bits_is_zero_d1;
    reg [7:0] unit_delta_product_bits_d1, unit_delta_product_bits_d2, unit_delta_product_bits_d3;
    reg edge_on_in_order_d1, doubtful_in_order_d1;
    reg [31:0] first_sum_sum_d1, first_sum_sum_d2, first_sum_sum_d3, first_sum_sum_d4, first_sum_sum_d1_copy2;
    reg [31:0] first_sum_sum_d2_copy2;
    reg [26:0] first_sum_sum_d1_copy3;
    reg [31:0] last_sum_sum_d1, last_sum_sum_d2;
    reg [26:0] last_sum_sum_d1_copy2;
    reg [1:0] phases_33;
    reg [31:0] first_difference_sum_d1, first_difference_sum_d2, first_difference_lesser_d1;
    reg [26:0] first_difference_sum_d1_copy2;
    reg [31:0] last_difference_sum_d1;
    reg [1:0] phases_34;
    reg [31:0] last_difference_sum_d2, last_difference_chosen_d1;
    reg [26:0] last_difference_sum_d1_copy2;
    reg [21:0] center_x_fixed_d1;
    reg whole_and_first_sum_both_d1, whole_and_first_sum_both_d2;
    reg [26:0] first_sum_difference_d1, first_sum_shifted_d1, last_sum_sum_d1_copy3, last_sum_shifted_d1;
    reg [26:0] first_sum_greater_d1, last_sum_lesser_d1;
    reg [1:0] phases_35;
    reg [26:0] first_difference_difference_d1, first_difference_shifted_d1, first_difference_sum_d1_copy3;
    reg [26:0] last_difference_sum_d1_copy3, last_difference_shifted_d1, last_difference_sum_d1_copy4;
    reg [26:0] first_difference_greater_d1, last_difference_lesser_d1;
    reg first_sum_up_to_last_sum_d1, first_sum_up_to_last_sum_d2, visible_in_order_d1;
    reg [9:0] first_sum_out_d1, first_sum_out_d2, last_sum_out_d1, last_sum_out_d2, first_difference_out_d1;
    reg [1:0] phases_36;
    reg [9:0] last_difference_out_d1;
    reg before_far_and_occupied_x_d1, sight_negative_out_d1, visible_both_d1;
    reg [31:0] ax_out_joined_d1_copy2, ay_out_joined_d1_copy2, delta_times_one_over_b_depth_d1;
    reg [1:0] phases_37;
    reg [31:0] middle_depth_minus_epsilon_d1, middle_depth_plus_epsilon_d1, depth_high_out_greater_d1;
    reg max_f32_ftz_unit_phase;
    reg [31:0] max_f32_ftz_unit_a, max_f32_ftz_unit_b;
    reg max_f32_ftz_unit_copy2_phase;
    reg [31:0] max_f32_ftz_unit_copy2_a, max_f32_ftz_unit_copy2_b;
    reg max_f32_ftz_unit_copy3_phase;
    reg [31:0] max_f32_ftz_unit_copy3_a, max_f32_ftz_unit_copy3_b;
    reg max_f32_ftz_unit_copy4_phase;
    reg [31:0] max_f32_ftz_unit_copy4_a, max_f32_ftz_unit_copy4_b;
    reg max_f32_ftz_unit_copy5_phase;
    reg [31:0] max_f32_ftz_unit_copy5_a, max_f32_ftz_unit_copy5_b;
    reg max_f32_ftz_unit_copy6_phase;
    reg [31:0] max_f32_ftz_unit_copy6_a, max_f32_ftz_unit_copy6_b;
    reg max_f32_ftz_unit_copy7_phase;
    reg [31:0] max_f32_ftz_unit_copy7_a, max_f32_ftz_unit_copy7_b;
    reg max_f32_ftz_unit_copy8_phase;
    reg [31:0] max_f32_ftz_unit_copy8_a, max_f32_ftz_unit_copy8_b;
    reg add_f32_ftz_unit_phase;
    reg [31:0] add_f32_ftz_unit_a, add_f32_ftz_unit_b;
    reg add_f32_ftz_unit_copy2_phase;
    reg [31:0] add_f32_ftz_unit_copy2_a, add_f32_ftz_unit_copy2_b;
    reg add_f32_ftz_unit_copy3_phase;
    reg [31:0] add_f32_ftz_unit_copy3_a, add_f32_ftz_unit_copy3_b;
    reg add_f32_ftz_unit_copy4_phase;
    reg [31:0] add_f32_ftz_unit_copy4_a, add_f32_ftz_unit_copy4_b;
    reg add_f32_ftz_unit_copy5_phase;
    reg [31:0] add_f32_ftz_unit_copy5_a, add_f32_ftz_unit_copy5_b;
    reg add_f32_ftz_unit_copy6_phase;
    reg [31:0] add_f32_ftz_unit_copy6_a, add_f32_ftz_unit_copy6_b;
    reg add_f32_ftz_unit_copy7_phase;
    reg [31:0] add_f32_ftz_unit_copy7_a, add_f32_ftz_unit_copy7_b;
    reg add_f32_ftz_unit_copy8_phase;
    reg [31:0] add_f32_ftz_unit_copy8_a, add_f32_ftz_unit_copy8_b;
    reg add_f32_ftz_unit_copy9_phase;
    reg [31:0] add_f32_ftz_unit_copy9_a, add_f32_ftz_unit_copy9_b;
    reg add_f32_ftz_unit_copy10_phase;
    reg [31:0] add_f32_ftz_unit_copy10_a, add_f32_ftz_unit_copy10_b;
    reg add_f32_ftz_unit_copy11_phase;
    reg [31:0] add_f32_ftz_unit_copy11_a, add_f32_ftz_unit_copy11_b;
    reg add_f32_ftz_unit_copy12_phase;
    reg [31:0] add_f32_ftz_unit_copy12_a, add_f32_ftz_unit_copy12_b;
    reg add_f32_ftz_unit_copy13_phase;
    reg [31:0] add_f32_ftz_unit_copy13_a, add_f32_ftz_unit_copy13_b;
    reg add_f32_ftz_unit_copy14_phase;
    reg [31:0] add_f32_ftz_unit_copy14_a, add_f32_ftz_unit_copy14_b;
    reg add_f32_ftz_unit_copy15_phase;
    reg [31:0] add_f32_ftz_unit_copy15_a, add_f32_ftz_unit_copy15_b;
    reg add_f32_ftz_unit_copy16_phase;
    reg [31:0] add_f32_ftz_unit_copy16_a, add_f32_ftz_unit_copy16_b;
    reg add_f32_ftz_unit_copy17_phase;
    reg [31:0] add_f32_ftz_unit_copy17_a, add_f32_ftz_unit_copy17_b, add_f32_ftz_unit_copy18_a;
    reg [31:0] add_f32_ftz_unit_copy18_b;
    reg recip_f32_ftz_unit_phase;
    reg [31:0] recip_f32_ftz_unit_a, recip_f32_ftz_unit_copy2_a;
    reg mul_f32_ftz_unit_phase;
    reg [31:0] mul_f32_ftz_unit_a, mul_f32_ftz_unit_b;
    reg mul_f32_ftz_unit_copy2_phase;
    reg [31:0] mul_f32_ftz_unit_copy2_a, mul_f32_ftz_unit_copy2_b;
    reg mul_f32_ftz_unit_copy3_phase;
    reg [31:0] mul_f32_ftz_unit_copy3_a, mul_f32_ftz_unit_copy3_b;
    reg mul_f32_ftz_unit_copy4_phase;
    reg [31:0] mul_f32_ftz_unit_copy4_a, mul_f32_ftz_unit_copy4_b;
    reg mul_f32_ftz_unit_copy5_phase;
    reg [31:0] mul_f32_ftz_unit_copy5_a, mul_f32_ftz_unit_copy5_b;
    reg mul_f32_ftz_unit_copy6_phase;
    reg [31:0] mul_f32_ftz_unit_copy6_a, mul_f32_ftz_unit_copy6_b;
    reg mul_f32_ftz_unit_copy7_phase;
    reg [31:0] mul_f32_ftz_unit_copy7_a, mul_f32_ftz_unit_copy7_b;
    reg mul_f32_ftz_unit_copy8_phase;
    reg [31:0] mul_f32_ftz_unit_copy8_a, mul_f32_ftz_unit_copy8_b;
    reg mul_f32_ftz_unit_copy9_phase;
    reg [31:0] mul_f32_ftz_unit_copy9_a, mul_f32_ftz_unit_copy9_b;
    reg mul_f32_ftz_unit_copy10_phase;
    reg [31:0] mul_f32_ftz_unit_copy10_a, mul_f32_ftz_unit_copy10_b;
    reg mul_f32_ftz_unit_copy11_phase;
    reg [31:0] mul_f32_ftz_unit_copy11_a, mul_f32_ftz_unit_copy11_b;
    reg mul_f32_ftz_unit_copy12_phase;
    reg [31:0] mul_f32_ftz_unit_copy12_a, mul_f32_ftz_unit_copy12_b;
    reg mul_f32_ftz_unit_copy13_phase;
    reg [31:0] mul_f32_ftz_unit_copy13_a, mul_f32_ftz_unit_copy13_b;
    reg mul_mul_add_f32_ftz_unit_phase;
    reg [31:0] mul_mul_add_f32_ftz_unit_a, mul_mul_add_f32_ftz_unit_b, mul_mul_add_f32_ftz_unit_c;
    reg [31:0] mul_mul_add_f32_ftz_unit_d;
    reg mul_mul_add_f32_ftz_unit_copy2_phase;
    reg [31:0] mul_mul_add_f32_ftz_unit_copy2_a, mul_mul_add_f32_ftz_unit_copy2_b, mul_mul_add_f32_ftz_unit_copy2_c;
    reg [31:0] mul_mul_add_f32_ftz_unit_copy2_d;
    reg mul_mul_add_f32_ftz_unit_copy3_phase;
    reg [31:0] mul_mul_add_f32_ftz_unit_copy3_a, mul_mul_add_f32_ftz_unit_copy3_b, mul_mul_add_f32_ftz_unit_copy3_c;
    reg [31:0] mul_mul_add_f32_ftz_unit_copy3_d;
    reg mul_mul_add_f32_ftz_unit_copy4_phase;
    reg [31:0] mul_mul_add_f32_ftz_unit_copy4_a, mul_mul_add_f32_ftz_unit_copy4_b, mul_mul_add_f32_ftz_unit_copy4_c;
    reg [31:0] mul_mul_add_f32_ftz_unit_copy4_d;
    reg mul_mul_add_f32_ftz_unit_copy5_phase;
    reg [31:0] mul_mul_add_f32_ftz_unit_copy5_a, mul_mul_add_f32_ftz_unit_copy5_b, mul_mul_add_f32_ftz_unit_copy5_c;
    reg [31:0] mul_mul_add_f32_ftz_unit_copy5_d;
    reg mul_mul_add_f32_ftz_unit_copy6_phase;
    reg [31:0] mul_mul_add_f32_ftz_unit_copy6_a, mul_mul_add_f32_ftz_unit_copy6_b, mul_mul_add_f32_ftz_unit_copy6_c;
    reg [31:0] mul_mul_add_f32_ftz_unit_copy6_d;
    reg mul_mul_add_f32_ftz_unit_copy7_phase;
    reg [31:0] mul_mul_add_f32_ftz_unit_copy7_a, mul_mul_add_f32_ftz_unit_copy7_b, mul_mul_add_f32_ftz_unit_copy7_c;
    reg [31:0] mul_mul_add_f32_ftz_unit_copy7_d;
    reg mul_add_f32_ftz_unit_phase;
    reg [31:0] mul_add_f32_ftz_unit_a, mul_add_f32_ftz_unit_b, mul_add_f32_ftz_unit_c;
    reg mul_add_f32_ftz_unit_copy2_phase;
    reg [31:0] mul_add_f32_ftz_unit_copy2_a, mul_add_f32_ftz_unit_copy2_b, mul_add_f32_ftz_unit_copy2_c;
    reg mul_add_f32_ftz_unit_copy3_phase;
    reg [31:0] mul_add_f32_ftz_unit_copy3_a, mul_add_f32_ftz_unit_copy3_b, mul_add_f32_ftz_unit_copy3_c;
    reg sqrt_f32_ftz_unit_phase;
    reg [31:0] sqrt_f32_ftz_unit_a;
    reg sqrt_f32_ftz_unit_copy2_phase;
    reg [31:0] sqrt_f32_ftz_unit_copy2_a, sqrt_f32_ftz_unit_copy3_a;
    reg min_f32_ftz_unit_phase;
    reg [31:0] min_f32_ftz_unit_a, min_f32_ftz_unit_b;
    reg min_f32_ftz_unit_copy2_phase;
    reg [31:0] min_f32_ftz_unit_copy2_a, min_f32_ftz_unit_copy2_b;
    reg min_f32_ftz_unit_copy3_phase;
    reg [31:0] min_f32_ftz_unit_copy3_a, min_f32_ftz_unit_copy3_b;
    reg min_f32_ftz_unit_copy4_phase;
    reg [31:0] min_f32_ftz_unit_copy4_a, min_f32_ftz_unit_copy4_b, min_f32_ftz_unit_copy5_b;
    reg [31:0] to_fixed_f32_ftz_u21q8_unit_a;
    reg to_fixed_f32_ftz_u21q8_unit_copy2_phase;
    reg [31:0] to_fixed_f32_ftz_u21q8_unit_copy2_a;
    reg to_fixed_f32_ftz_u23q8_unit_phase;
    reg [31:0] to_fixed_f32_ftz_u23q8_unit_a, to_fixed_f32_ftz_u23q8_unit_copy2_a;
    reg to_fixed_f32_ftz_s22q8_unit_phase;
    reg [31:0] to_fixed_f32_ftz_s22q8_unit_a;
    reg to_fixed_f32_ftz_u24q24_unit_phase;
    reg [31:0] to_fixed_f32_ftz_u24q24_unit_a, to_fixed_f32_ftz_u24q24_unit_copy2_a;
    reg [1:0] phases_38;
    reg [92:0] in_flight;
    reg left, dropped;

    wire [31:0] max_f32_ftz_unit_y, max_f32_ftz_unit_copy2_y, max_f32_ftz_unit_copy3_y, max_f32_ftz_unit_copy4_y;
    wire [31:0] max_f32_ftz_unit_copy5_y, max_f32_ftz_unit_copy6_y, max_f32_ftz_unit_copy7_y;
    wire [31:0] max_f32_ftz_unit_copy8_y;
    wire lt_f32_ftz_unit_y, lt_f32_ftz_unit_copy2_y, lt_f32_ftz_unit_copy3_y, lt_f32_ftz_unit_copy4_y;
    wire lt_f32_ftz_unit_copy5_y, lt_f32_ftz_unit_copy6_y, lt_f32_ftz_unit_copy7_y, lt_f32_ftz_unit_copy8_y;
    wire lt_f32_ftz_unit_copy9_y;
    wire [31:0] add_f32_ftz_unit_y, add_f32_ftz_unit_copy2_y, add_f32_ftz_unit_copy3_y, add_f32_ftz_unit_copy4_y;
    wire [31:0] add_f32_ftz_unit_copy5_y, add_f32_ftz_unit_copy6_y, add_f32_ftz_unit_copy7_y;
    wire [31:0] add_f32_ftz_unit_copy8_y, add_f32_ftz_unit_copy9_y, add_f32_ftz_unit_copy10_y;
    wire [31:0] add_f32_ftz_unit_copy11_y, add_f32_ftz_unit_copy12_y, add_f32_ftz_unit_copy13_y;
    wire [31:0] add_f32_ftz_unit_copy14_y, add_f32_ftz_unit_copy15_y, add_f32_ftz_unit_copy16_y;
    wire [31:0] add_f32_ftz_unit_copy17_y, add_f32_ftz_unit_copy18_y, recip_f32_ftz_unit_y;
    wire [31:0] recip_f32_ftz_unit_copy2_y, mul_f32_ftz_unit_y, mul_f32_ftz_unit_copy2_y, mul_f32_ftz_unit_copy3_y;
    wire [31:0] mul_f32_ftz_unit_copy4_y, mul_f32_ftz_unit_copy5_y, mul_f32_ftz_unit_copy6_y;
    wire [31:0] mul_f32_ftz_unit_copy7_y, mul_f32_ftz_unit_copy8_y, mul_f32_ftz_unit_copy9_y;
    wire [31:0] mul_f32_ftz_unit_copy10_y, mul_f32_ftz_unit_copy11_y, mul_f32_ftz_unit_copy12_y;
    wire [31:0] mul_f32_ftz_unit_copy13_y, mul_mul_add_f32_ftz_unit_y, mul_mul_add_f32_ftz_unit_copy2_y;
    wire [31:0] mul_mul_add_f32_ftz_unit_copy3_y, mul_mul_add_f32_ftz_unit_copy4_y, mul_mul_add_f32_ftz_unit_copy5_y;
    wire [31:0] mul_mul_add_f32_ftz_unit_copy6_y, mul_mul_add_f32_ftz_unit_copy7_y, mul_add_f32_ftz_unit_y;
    wire [31:0] mul_add_f32_ftz_unit_copy2_y, mul_add_f32_ftz_unit_copy3_y, sqrt_f32_ftz_unit_y;
    wire [31:0] sqrt_f32_ftz_unit_copy2_y, sqrt_f32_ftz_unit_copy3_y;
    wire le_f32_ftz_unit_y, le_f32_ftz_unit_copy2_y, le_f32_ftz_unit_copy3_y, le_f32_ftz_unit_copy4_y;
    wire [31:0] min_f32_ftz_unit_y, min_f32_ftz_unit_copy2_y, min_f32_ftz_unit_copy3_y, min_f32_ftz_unit_copy4_y;
    wire [31:0] min_f32_ftz_unit_copy5_y;
    wire [20:0] to_fixed_f32_ftz_u21q8_unit_y, to_fixed_f32_ftz_u21q8_unit_copy2_y;
    wire [22:0] to_fixed_f32_ftz_u23q8_unit_y, to_fixed_f32_ftz_u23q8_unit_copy2_y;
    wire [21:0] to_fixed_f32_ftz_s22q8_unit_y;
    wire [23:0] to_fixed_f32_ftz_u24q24_unit_y, to_fixed_f32_ftz_u24q24_unit_copy2_y;
    wire queue_1_in_ready;
    wire [3:0] queue_1_out_data;
    wire queue_2_in_ready, queue_2_out_valid;
    wire [127:0] queue_2_out_data;
    wire queue_3_in_ready, queue_3_out_valid;
    wire [127:0] queue_3_out_data;
    wire queue_4_in_ready, queue_4_out_valid;
    wire [117:0] queue_4_out_data;
    wire queue_5_in_ready, queue_5_out_valid;
    wire [127:0] queue_5_out_data;
    wire queue_6_in_ready, queue_6_out_valid;
    wire [127:0] queue_6_out_data;
    wire queue_7_in_ready, queue_7_out_valid;
    wire [91:0] queue_7_out_data;

    assign in_ready = ~credits[7] & phases_1[0];
    wire beyond_near_d7 = delay_7_from_0_out[0];
    wire reaches_near = beyond_near_d7 | lt_f32_ftz_unit_copy4_y;
    wire [31:0] lt_f32_ftz_unit_copy2_a_bits = {1'd0, in_tangent1_z[30:0]};
    wire [31:0] lt_f32_ftz_unit_copy2_b_bits = {1'd0, in_tangent2_z[30:0]};
    wire in_flight_92_and_phases_36_0 = in_flight[92] & phases_36[0];
    wire end_d93 = delay_93_from_0_out[0];
    wire doubtful_or_visible_unequal_d54 = delay_54_from_1_out[1];
    wire visible = visible_both_d1 & doubtful_or_visible_unequal_d54;
    wire end_or_visible = end_d93 | visible;
    wire kept = in_flight_92_and_phases_36_0 & end_or_visible;
    wire turned_d91 = delay_50_from_1_out[0];
    wire sight_disc_out_d68 = delay_7_from_0_out[1];
    wire [31:0] center_x_d66 = delay_23_from_0_out[63:32];
    wire [31:0] center_y_d66 = delay_22_from_0_out[63:32];
    wire [31:0] ax_out_d50 = delay_50_from_0_out[64:33];
    wire [31:0] bx_out_d51 = delay_51_from_0_out[31:0];
    wire [31:0] ay_out_d50 = delay_50_from_0_out[96:65];
    wire [31:0] by_out_d51 = delay_51_from_0_out[63:32];
    wire edge_on_d54 = delay_54_from_1_out[0];
    wire [31:0] delta_d51 = delay_50_from_0_out[32:1];
    wire [31:0] delta_out = edge_on_d54 ? 32'h7fc00000 : delta_d51;
    wire [31:0] mx_d51 = delay_51_from_0_out[95:64];
    wire beyond_near_d32 = delay_32_from_0_out[0];
    wire [30:0] sight_near_out_product_bits_d43 = delay_43_from_0_out[30:0];
    wire [30:0] sight_near_out = beyond_near_d32 ? 31'h7fffffff : sight_near_out_product_bits_d43;
    wire all_before_far_d32 = delay_32_from_0_out[1];
    wire [30:0] sight_far_out_product_bits_d43 = delay_43_from_0_out[61:31];
    wire [30:0] sight_far_out = all_before_far_d32 ? 31'd0 : sight_far_out_product_bits_d43;
    wire [15:0] attribute_0_d93 = delay_93_from_0_out[16:1];
    wire [15:0] attribute_1_d93 = delay_93_from_0_out[32:17];
    wire [15:0] attribute_2_d93 = delay_93_from_0_out[48:33];
    wire [15:0] attribute_3_d93 = delay_93_from_0_out[64:49];
    wire [15:0] attribute_4_d93 = delay_93_from_0_out[80:65];
    wire [15:0] attribute_5_d93 = delay_93_from_0_out[96:81];
    wire [15:0] attribute_6_d93 = delay_93_from_0_copy2_out[15:0];
    wire [15:0] attribute_7_d93 = delay_93_from_0_copy2_out[31:16];
    wire [15:0] attribute_8_d93 = delay_93_from_0_copy2_out[47:32];
    wire [15:0] attribute_9_d93 = delay_93_from_0_copy2_out[63:48];
    wire [15:0] attribute_10_d93 = delay_93_from_0_copy2_out[79:64];
    wire [15:0] attribute_11_d93 = delay_93_from_0_copy2_out[95:80];
    wire [15:0] attribute_12_d93 = delay_93_from_0_copy3_out[15:0];
    wire [15:0] cardinal_0_d93 = delay_93_from_0_copy3_out[31:16];
    wire [8:0] first_x_d12 = delay_12_from_0_out[9:1];
    wire [8:0] last_x_d12 = delay_12_from_0_out[18:10];
    wire [8:0] last_y_d12 = delay_12_from_1_out[9:1];
    wire in_valid_and_in_ready = in_valid & in_ready;
    wire [10:0] first_x_greater_bits_d1_bits = {3'd0, max_f32_ftz_unit_y[30:23]};
    wire [10:0] first_x_greater_bits_plus_1 = 11'd1 + first_x_greater_bits_d1_bits;
    wire first_x_in_order = 11'd0 < first_x_greater_bits_plus_1;
    wire zero_is_first_x_greater_bits = 11'd0 == first_x_greater_bits_d1_bits;
    wire first_x_inverted = ~zero_is_first_x_greater_bits;
    wire first_x_greater_bits_is_255 = first_x_greater_bits_d1_bits == 11'd255;
    wire first_x_in_order_copy2 = ~(first_x_greater_bits_plus_1 < 11'd255);
    wire first_x_both = first_x_in_order_d1 & first_x_inverted_d1;
    wire first_x_both_copy2 = first_x_both & first_x_in_order_d1_copy2;
    wire first_x_inverted_copy2 = ~first_x_greater_bits_is_255_d1;
    wire first_x_both_copy3 = first_x_both_copy2 & first_x_inverted_copy2;
    wire first_x_either = first_x_both | first_x_greater_bits_is_255_d1;
    wire [10:0] first_x_chosen = first_x_both_d1 ? 11'd255 : first_x_greater_bits_plus_1_d1;
    wire [10:0] first_x_chosen_copy2 = first_x_greater_bits_is_255_d1 ? first_x_greater_bits_d1 : first_x_chosen;
    wire [22:0] first_x_chosen_copy3 = first_x_both_d1 ? 23'd0 : first_x_greater_bits_d1_copy2;
    wire [30:0] first_x_chosen_copy4 = first_x_either_d1 ? {first_x_chosen_copy2[7:0], first_x_chosen_copy3} : 31'd0;
    wire [10:0] first_y_greater_bits_d1_bits = {3'd0, max_f32_ftz_unit_copy2_y[30:23]};
    wire [10:0] first_y_greater_bits_plus_1 = 11'd1 + first_y_greater_bits_d1_bits;
    wire first_y_in_order = 11'd0 < first_y_greater_bits_plus_1;
    wire zero_is_first_y_greater_bits = 11'd0 == first_y_greater_bits_d1_bits;
    wire first_y_inverted = ~zero_is_first_y_greater_bits;
    wire first_y_greater_bits_is_255 = 11'd255 == first_y_greater_bits_d1_bits;
    wire first_y_in_order_copy2 = ~(first_y_greater_bits_plus_1 < 11'd255);
    wire first_y_both = first_y_in_order_d1 & first_y_inverted_d1;
    wire first_y_both_copy2 = first_y_both & first_y_in_order_d1_copy2;
    wire first_y_inverted_copy2 = ~first_y_greater_bits_is_255_d1;
    wire first_y_both_copy3 = first_y_both_copy2 & first_y_inverted_copy2;
    wire first_y_either = first_y_both | first_y_greater_bits_is_255_d1;
    wire [10:0] first_y_chosen = first_y_both_d1 ? 11'd255 : first_y_greater_bits_plus_1_d1;
    wire [10:0] first_y_chosen_copy2 = first_y_greater_bits_is_255_d1 ? first_y_greater_bits_d1 : first_y_chosen;
    wire [22:0] first_y_chosen_copy3 = first_y_both_d1 ? 23'd0 : first_y_greater_bits_d1_copy2;
    wire [30:0] first_y_chosen_copy4 = first_y_either_d1 ? {first_y_chosen_copy2[7:0], first_y_chosen_copy3} : 31'd0;
    wire [10:0] reaches_near_greater_bits_d1_bits = {3'd0, max_f32_ftz_unit_copy3_y[30:23]};
    wire [10:0] reaches_near_sum = 11'd1 + reaches_near_greater_bits_d1_bits;
    wire zero_below_reaches_near_sum = 11'd0 < reaches_near_sum;
    wire reaches_near_same = 11'd0 == reaches_near_greater_bits_d1_bits;
    wire not_reaches_near_same = ~reaches_near_same;
    wire reaches_near_same_copy2 = 11'd255 == reaches_near_greater_bits_d1_bits;
    wire reaches_near_in_order = ~(reaches_near_sum < 11'd255);
    wire reaches_near_both = zero_below_reaches_near_sum_d1 & not_reaches_near_same_d1;
    wire reaches_near_both_copy2 = reaches_near_both & reaches_near_in_order_d1;
    wire not_reaches_near_same_copy2 = ~reaches_near_same_d1;
    wire reaches_near_both_copy3 = reaches_near_both_copy2 & not_reaches_near_same_copy2;
    wire reaches_near_either = reaches_near_both | reaches_near_same_d1;
    wire [10:0] reaches_near_chosen = reaches_near_both_d1 ? 11'd255 : reaches_near_sum_d1;
    wire [10:0] reaches_near_chosen_copy2 = reaches_near_same_d1 ? reaches_near_greater_bits_d1 : reaches_near_chosen;
    wire [22:0] reaches_near_chosen_copy3 = reaches_near_both_d1 ? 23'd0 : reaches_near_greater_bits_d1_copy2;
    wire [30:0] reaches_near_chosen_copy4 = reaches_near_either_d1 ? {reaches_near_chosen_copy2[7:0], reaches_near_chosen_copy3} : 31'd0;
    wire [10:0] turned_greater_bits = {3'd0, in_center_x[30:23]};
    wire [10:0] turned_greater_bits_2 = {3'd0, in_center_y[30:23]};
    wire [10:0] turned_greater = (turned_greater_bits < turned_greater_bits_2) ? turned_greater_bits_2 : turned_greater_bits;
    wire [10:0] center_z_bits_plus_10 = {3'd0, in_center_z[30:23]} + 11'd10;
    wire turned_in_order = center_z_bits_plus_10_d1 < turned_greater_d1;
    wire not_beyond_near = ~lt_f32_ftz_unit_y;
    wire turned_either = turned_in_order | not_beyond_near;
    wire turned = lt_f32_ftz_unit_copy3_y & turned_either_d2;
    wire [31:0] lowered_chosen_copy2 = swapped_d2 ? tangent1_x_d3 : tangent2_x_d3;
    wire [31:0] lowered_chosen_copy6 = turned ? lowered_chosen_copy2 : tangent1_x_d3;
    wire [31:0] lowered_chosen_copy3 = swapped_d2 ? tangent1_y_d3 : tangent2_y_d3;
    wire [31:0] lowered_chosen_copy7 = turned ? lowered_chosen_copy3 : tangent1_y_d3;
    wire lowered_greater_in_order = {3'd0, lowered_chosen_bits_d1} < {3'd0, lowered_chosen_bits_d1_copy3};
    wire [10:0] lowered_greater = lowered_greater_in_order ? {3'd0, lowered_chosen_bits_d1_copy3} : {3'd0, lowered_chosen_bits_d1};
    wire [31:0] lowered_chosen_copy4 = swapped_d2 ? tangent1_z_d3 : tangent2_z_d3;
    wire [31:0] lowered_chosen_copy8 = turned ? lowered_chosen_copy4 : tangent1_z_d3;
    wire [10:0] lowered_greater_copy2 = (lowered_greater_d1 < lowered_chosen_bits_d1_copy6) ? lowered_chosen_bits_d1_copy6 : lowered_greater_d1;
    wire [31:0] lowered_chosen_copy9 = turned ? center_x_d3 : tangent2_x_d3;
    wire [10:0] lowered_greater_copy3 = (lowered_greater_d1_copy2 < lowered_chosen_bits_d1_copy8) ? lowered_chosen_bits_d1_copy8 : lowered_greater_d1_copy2;
    wire [31:0] lowered_chosen_copy10 = turned ? center_y_d3 : tangent2_y_d3;
    wire [10:0] lowered_greater_copy4 = (lowered_greater_d1_copy3 < lowered_chosen_bits_d2_copy5) ? lowered_chosen_bits_d2_copy5 : lowered_greater_d1_copy3;
    wire [31:0] lowered_chosen_copy11 = turned ? center_z_d3 : tangent2_z_d3;
    wire [10:0] lowered_greater_copy5 = (lowered_greater_d1_copy4 < lowered_chosen_bits_d2_copy6) ? lowered_chosen_bits_d2_copy6 : lowered_greater_d1_copy4;
    wire [31:0] lowered_chosen = swapped_d2 ? tangent2_z_d3 : tangent1_z_d3;
    wire [31:0] lowered_chosen_copy5 = turned ? lowered_chosen : center_z_d3;
    wire [10:0] lowered_chosen_bits_plus_60 = {3'd0, lowered_chosen_bits_d1_copy13} + 11'd60;
    wire lowered_in_order = lowered_greater_d1_copy5 < lowered_chosen_bits_plus_60_d2;
    wire [10:0] lowered_difference = lowered_greater_d1_copy5 - lowered_chosen_bits_plus_60_d2;
    wire [10:0] lowered = lowered_in_order ? 11'd0 : lowered_difference;
    wire zero_is_lowered_chosen_bits = 11'd0 == {3'd0, lowered_chosen_bits_d1};
    wire a_x_inverted = ~zero_is_lowered_chosen_bits;
    wire a_x_in_order = lowered_d1 < lowered_chosen_bits_d3;
    wire a_x_in_order_and_a_x_inverted = a_x_in_order & a_x_inverted_d3;
    wire lowered_chosen_bits_is_255 = 11'd255 == lowered_chosen_bits_d3;
    wire [10:0] a_x_difference = lowered_chosen_bits_d3 - lowered_d1;
    wire [10:0] a_x_chosen = lowered_chosen_bits_is_255_d1 ? lowered_chosen_bits_d3 : a_x_difference;
    wire zero_is_lowered_chosen_bits_copy2 = 11'd0 == {3'd0, lowered_chosen_bits_d1_copy3};
    wire a_y_inverted = ~zero_is_lowered_chosen_bits_copy2;
    wire a_y_in_order = lowered_d1 < lowered_chosen_bits_d3_copy2;
    wire a_y_in_order_and_a_y_inverted = a_y_in_order & a_y_inverted_d3;
    wire lowered_chosen_bits_is_255_copy2 = 11'd255 == lowered_chosen_bits_d3_copy2;
    wire [10:0] a_y_difference = lowered_chosen_bits_d3_copy2 - lowered_d1;
    wire [10:0] a_y_chosen = lowered_chosen_bits_is_255_d1_copy2 ? lowered_chosen_bits_d3_copy2 : a_y_difference;
    wire zero_is_lowered_chosen_bits_copy3 = 11'd0 == {3'd0, lowered_chosen_bits_d1_copy5};
    wire alpha_inverted = ~zero_is_lowered_chosen_bits_copy3;
    wire alpha_in_order = lowered_d1 < lowered_chosen_bits_d3_copy3;
    wire alpha_both = alpha_in_order & alpha_inverted_d3;
    wire lowered_chosen_bits_is_255_copy3 = 11'd255 == lowered_chosen_bits_d3_copy3;
    wire [10:0] alpha_difference = lowered_chosen_bits_d3_copy3 - lowered_d1;
    wire [10:0] alpha_chosen = lowered_chosen_bits_is_255_d1_copy3 ? lowered_chosen_bits_d3_copy3 : alpha_difference;
    wire zero_is_lowered_chosen_bits_copy4 = 11'd0 == {3'd0, lowered_chosen_bits_d1_copy7};
    wire b_x_inverted = ~zero_is_lowered_chosen_bits_copy4;
    wire b_x_in_order = lowered_d1 < lowered_chosen_bits_d3_copy4;
    wire b_x_in_order_and_b_x_inverted = b_x_in_order & b_x_inverted_d3;
    wire lowered_chosen_bits_is_255_copy4 = 11'd255 == lowered_chosen_bits_d3_copy4;
    wire [10:0] b_x_difference = lowered_chosen_bits_d3_copy4 - lowered_d1;
    wire [10:0] b_x_chosen = lowered_chosen_bits_is_255_d1_copy4 ? lowered_chosen_bits_d3_copy4 : b_x_difference;
    wire zero_is_lowered_chosen_bits_copy5 = 11'd0 == {3'd0, lowered_chosen_bits_d1_copy9};
    wire b_y_inverted = ~zero_is_lowered_chosen_bits_copy5;
    wire b_y_in_order = lowered_d1 < lowered_chosen_bits_d3_copy5;
    wire b_y_in_order_and_b_y_inverted = b_y_in_order & b_y_inverted_d3;
    wire lowered_chosen_bits_is_255_copy5 = 11'd255 == lowered_chosen_bits_d3_copy5;
    wire [10:0] b_y_difference = lowered_chosen_bits_d3_copy5 - lowered_d1;
    wire [10:0] b_y_chosen = lowered_chosen_bits_is_255_d1_copy5 ? lowered_chosen_bits_d3_copy5 : b_y_difference;
    wire zero_is_lowered_chosen_bits_copy6 = 11'd0 == {3'd0, lowered_chosen_bits_d1_copy11};
    wire beta_inverted = ~zero_is_lowered_chosen_bits_copy6;
    wire beta_in_order = lowered_d1 < lowered_chosen_bits_d3_copy6;
    wire beta_both = beta_in_order & beta_inverted_d3;
    wire lowered_chosen_bits_is_255_copy6 = 11'd255 == lowered_chosen_bits_d3_copy6;
    wire [10:0] beta_difference = lowered_chosen_bits_d3_copy6 - lowered_d1;
    wire [10:0] beta_chosen = lowered_chosen_bits_is_255_d1_copy6 ? lowered_chosen_bits_d3_copy6 : beta_difference;
    wire not_turned = ~turned_d5;
    wire beyond_near_and_not_turned_d14 = delay_14_from_0_out[64];
    wire [31:0] alpha_d11 = delay_11_from_1_out[95:64];
    wire [31:0] beta_d11 = delay_11_from_1_copy2_out[31:0];
    wire zero_is_lowered = 11'd0 == delay_24_from_1_out;
    wire whole_d42 = delay_12_from_1_out[0];
    wire not_turned_and_whole_in_order = delay_6_from_1_out & lt_f32_ftz_unit_copy5_y;
    wire whole = not_turned_and_whole_in_order & zero_is_lowered_d1;
    wire [31:0] f_chosen = whole ? e_d1 : delay_25_from_1_out;
    wire before_far_in_order = mul_f32_ftz_unit_copy3_y[30:0] < 31'd16;
    wire [30:0] before_far_difference = mul_f32_ftz_unit_copy3_y[30:0] - 31'd16;
    wire [30:0] before_far_chosen = before_far_in_order ? 31'd0 : before_far_difference;
    wire sight_disc_out_d50 = delay_50_from_0_out[0];
    wire whole_d30 = delay_30_from_1_out[0];
    wire beyond_near = whole_d30 & le_f32_ftz_unit_y;
    wire [31:0] spread_middle_d5 = delay_5_from_1_out[31:0];
    wire [31:0] center_depth_d37 = delay_8_from_0_out[31:0];
    wire [31:0] middle_depth_chosen = delay_36_from_0_out ? center_depth_d37 : 32'd0;
    wire [31:0] middle_depth = beyond_near ? spread_middle_d5 : middle_depth_chosen;
    wire first_x_product_bits_below_16 = mul_f32_ftz_unit_copy8_y[30:0] < 31'd16;
    wire [30:0] first_x_product_bits_minus_16 = mul_f32_ftz_unit_copy8_y[30:0] - 31'd16;
    wire [30:0] first_x_chosen_copy6 = first_x_product_bits_below_16 ? 31'd0 : first_x_product_bits_minus_16;
    wire [31:0] first_x_chosen_d16 = delay_16_from_1_out[32:1];
    wire [31:0] first_x_chosen_copy9 = whole_d42 ? add_f32_ftz_unit_copy4_y : first_x_chosen_d16;
    wire [31:0] last_x_chosen_d16 = delay_16_from_1_out[64:33];
    wire [31:0] last_x_chosen_copy3 = whole_d42 ? add_f32_ftz_unit_copy5_y : last_x_chosen_d16;
    wire [21:0] first_x_greater_fixed_plus_126 = {1'd0, to_fixed_f32_ftz_u21q8_unit_y} + 22'd126;
    wire [21:0] last_x_greater_fixed_plus_130 = {1'd0, to_fixed_f32_ftz_u21q8_unit_y} + 22'd130;
    wire [21:0] last_x_lesser = (22'd512 < last_x_shifted_d1) ? 22'd512 : last_x_shifted_d1;
    wire [31:0] center_y_d43 = delay_20_from_0_out[63:32];
    wire first_y_product_bits_below_16 = mul_f32_ftz_unit_copy12_y[30:0] < 31'd16;
    wire [30:0] first_y_product_bits_minus_16 = mul_f32_ftz_unit_copy12_y[30:0] - 31'd16;
    wire [30:0] first_y_chosen_copy6 = first_y_product_bits_below_16 ? 31'd0 : first_y_product_bits_minus_16;
    wire [31:0] first_y_chosen_d17 = delay_17_from_1_out[96:65];
    wire [31:0] first_y_chosen_copy9 = whole_d43 ? add_f32_ftz_unit_copy6_y : first_y_chosen_d17;
    wire [31:0] last_y_chosen_d16 = delay_16_from_1_out[96:65];
    wire [31:0] last_y_chosen_copy3 = whole_d42 ? add_f32_ftz_unit_copy12_y : last_y_chosen_d16;
    wire [21:0] first_y_greater_fixed_plus_126 = 22'd126 + {1'd0, to_fixed_f32_ftz_u21q8_unit_copy2_y};
    wire [21:0] last_y_greater_fixed_plus_130 = 22'd130 + {1'd0, to_fixed_f32_ftz_u21q8_unit_copy2_y};
    wire [21:0] last_y_lesser = (last_y_shifted_d1 < 22'd512) ? last_y_shifted_d1 : 22'd512;
    wire [10:0] a_x_bits_d1_bits = {3'd0, mul_f32_ftz_unit_copy6_y[30:23]};
    wire [10:0] a_x_bits_d10 = delay_9_from_1_out[10:0];
    wire [10:0] a_y_bits_d1_bits = {3'd0, mul_f32_ftz_unit_copy10_y[30:23]};
    wire [10:0] a_y_bits_d10 = delay_9_from_1_out[21:11];
    wire [10:0] a_exponent = (a_x_bits_d1_bits < a_y_bits_d1_bits) ? a_y_bits_d1_bits : a_x_bits_d1_bits;
    wire [10:0] b_x_bits_d1_bits = {3'd0, mul_f32_ftz_unit_copy7_y[30:23]};
    wire [10:0] b_x_bits_d10 = delay_9_from_1_out[32:22];
    wire [10:0] b_y_bits_d1_bits = {3'd0, mul_f32_ftz_unit_copy11_y[30:23]};
    wire [10:0] b_y_bits_d10 = delay_9_from_1_out[43:33];
    wire [10:0] b_exponent = (b_x_bits_d1_bits < b_y_bits_d1_bits) ? b_y_bits_d1_bits : b_x_bits_d1_bits;
    wire [10:0] a_x_bits_plus_127 = 11'd127 + a_x_bits_d1_bits;
    wire zero_is_a_x_bits = 11'd0 == a_x_bits_d1_bits;
    wire not_zero_is_a_x_bits = ~zero_is_a_x_bits;
    wire unit_delta_in_order = a_exponent_d1 < a_x_bits_plus_127_d1;
    wire unit_delta_both = unit_delta_in_order & not_zero_is_a_x_bits_d1;
    wire a_x_bits_is_255 = 11'd255 == a_x_bits_d1;
    wire [10:0] unit_delta_difference = a_x_bits_plus_127_d1 - a_exponent_d1;
    wire [10:0] unit_delta_chosen = a_x_bits_is_255 ? a_x_bits_d1 : unit_delta_difference;
    wire [10:0] a_y_bits_plus_127 = 11'd127 + a_y_bits_d1_bits;
    wire zero_is_a_y_bits = 11'd0 == a_y_bits_d1_bits;
    wire not_zero_is_a_y_bits = ~zero_is_a_y_bits;
    wire unit_delta_in_order_copy2 = a_exponent_d1 < a_y_bits_plus_127_d1;
    wire unit_delta_both_copy2 = unit_delta_in_order_copy2 & not_zero_is_a_y_bits_d1;
    wire a_y_bits_is_255 = 11'd255 == a_y_bits_d1;
    wire [10:0] unit_delta_difference_copy2 = a_y_bits_plus_127_d1 - a_exponent_d1;
    wire [10:0] unit_delta_chosen_copy3 = a_y_bits_is_255 ? a_y_bits_d1 : unit_delta_difference_copy2;
    wire unit_delta_either_copy2 = unit_delta_both_d1_copy2 | a_y_bits_is_255_d1;
    wire [30:0] unit_delta_chosen_copy4 = unit_delta_either_copy2 ? {unit_delta_chosen_d1_copy2, a_y_bits_d1_copy2} : 31'd0;
    wire [10:0] b_x_bits_plus_127 = 11'd127 + b_x_bits_d1_bits;
    wire zero_is_b_x_bits = 11'd0 == b_x_bits_d1_bits;
    wire not_zero_is_b_x_bits = ~zero_is_b_x_bits;
    wire unit_delta_in_order_copy3 = b_exponent_d1 < b_x_bits_plus_127_d1;
    wire unit_delta_both_copy3 = unit_delta_in_order_copy3 & not_zero_is_b_x_bits_d1;
    wire b_x_bits_is_255 = 11'd255 == b_x_bits_d1;
    wire [10:0] unit_delta_difference_copy3 = b_x_bits_plus_127_d1 - b_exponent_d1;
    wire [10:0] unit_delta_chosen_copy5 = b_x_bits_is_255 ? b_x_bits_d1 : unit_delta_difference_copy3;
    wire unit_delta_either_copy3 = unit_delta_both_d1_copy3 | b_x_bits_is_255_d1;
    wire [30:0] unit_delta_chosen_copy6 = unit_delta_either_copy3 ? {unit_delta_chosen_d1_copy3, b_x_bits_d1_copy2} : 31'd0;
    wire [10:0] b_y_bits_plus_127 = 11'd127 + b_y_bits_d1_bits;
    wire zero_is_b_y_bits = 11'd0 == b_y_bits_d1_bits;
    wire not_zero_is_b_y_bits = ~zero_is_b_y_bits;
    wire unit_delta_in_order_copy4 = b_exponent_d1 < b_y_bits_plus_127_d1;
    wire unit_delta_both_copy4 = unit_delta_in_order_copy4 & not_zero_is_b_y_bits_d1;
    wire b_y_bits_is_255 = 11'd255 == b_y_bits_d1;
    wire [10:0] unit_delta_difference_copy4 = b_y_bits_plus_127_d1 - b_exponent_d1;
    wire [10:0] unit_delta_chosen_copy7 = b_y_bits_is_255 ? b_y_bits_d1 : unit_delta_difference_copy4;
    wire [10:0] beta_bits_d11 = delay_11_from_1_out[106:96];
    wire [10:0] a_exponent_plus_beta_bits = a_exponent_d1 + beta_bits_d11;
    wire [10:0] alpha_bits_d11 = delay_11_from_1_copy2_out[106:96];
    wire [10:0] b_exponent_plus_alpha_bits = b_exponent_d1 + alpha_bits_d11;
    wire [10:0] m_exponent = (a_exponent_plus_beta_bits_d1 < b_exponent_plus_alpha_bits_d1) ? b_exponent_plus_alpha_bits_d1 : a_exponent_plus_beta_bits_d1;
    wire [10:0] a_exponent_plus_127 = 11'd127 + a_exponent_d1;
    wire [10:0] mx_sum = beta_bits_d11 + a_exponent_plus_127;
    wire m_exponent_below_mx_sum = m_exponent_d1 < mx_sum_d1;
    wire not_zero_is_beta_bits_d12 = delay_12_from_1_out[10];
    wire mx_both = m_exponent_below_mx_sum & not_zero_is_beta_bits_d12;
    wire beta_bits_is_255 = 11'd255 == beta_bits_d11;
    wire [10:0] mx_sum_minus_m_exponent = mx_sum_d1 - m_exponent_d1;
    wire [10:0] mx_chosen = beta_bits_is_255_d1 ? beta_bits_d12 : mx_sum_minus_m_exponent;
    wire mx_both_or_beta_bits_is_255 = mx_both_d1 | beta_bits_is_255_d1;
    wire [30:0] mx_chosen_copy2 = mx_both_or_beta_bits_is_255 ? {mx_chosen_d1, beta_d12[22:0]} : 31'd0;
    wire [10:0] b_exponent_plus_127 = 11'd127 + b_exponent_d1;
    wire [10:0] mx_sum_copy2 = alpha_bits_d11 + b_exponent_plus_127;
    wire m_exponent_below_mx_sum_copy2 = m_exponent_d1 < mx_sum_d1_copy2;
    wire not_zero_is_alpha_bits_d12 = delay_12_from_1_out[11];
    wire mx_both_copy2 = m_exponent_below_mx_sum_copy2 & not_zero_is_alpha_bits_d12;
    wire alpha_bits_is_255 = 11'd255 == alpha_bits_d11;
    wire [10:0] mx_sum_minus_m_exponent_copy2 = mx_sum_d1_copy2 - m_exponent_d1;
    wire [10:0] mx_chosen_copy3 = alpha_bits_is_255_d1 ? alpha_bits_d12 : mx_sum_minus_m_exponent_copy2;
    wire mx_both_or_alpha_bits_is_255 = mx_both_d1_copy2 | alpha_bits_is_255_d1;
    wire [30:0] mx_chosen_copy4 = mx_both_or_alpha_bits_is_255 ? {mx_chosen_d1_copy2, alpha_d12[22:0]} : 31'd0;
    wire unit_delta_either_copy4 = unit_delta_both_d1_copy4 | b_y_bits_is_255_d1;
    wire [30:0] unit_delta_chosen_copy8 = unit_delta_either_copy4 ? {unit_delta_chosen_d1_copy4, b_y_bits_d1_copy2} : 31'd0;
    wire unit_delta_either = unit_delta_both_d1 | a_x_bits_is_255_d1;
    wire [30:0] unit_delta_chosen_copy2 = unit_delta_either ? {unit_delta_chosen_d1, a_x_bits_d1_copy2} : 31'd0;
    wire [10:0] largest_sum_d8 = delay_8_from_0_out[42:32];
    wire [10:0] unit_delta_bits_d1_bits = {3'd0, mul_add_f32_ftz_unit_copy3_y[30:23]};
    wire [10:0] largest_greater = (a_exponent_d1 < b_exponent_d1) ? b_exponent_d1 : a_exponent_d1;
    wire [10:0] largest_sum_copy2 = largest_sum_d8 + unit_delta_bits_d1_bits;
    wire largest_sum_below_100 = largest_sum_copy2 < 11'd100;
    wire [10:0] largest_sum_minus_100 = largest_sum_copy2 - 11'd100;
    wire [10:0] largest_chosen = largest_sum_below_100_d1 ? 11'd0 : largest_sum_minus_100_d1;
    wire [10:0] largest_greater_plus_154_d8 = delay_8_from_0_out[53:43];
    wire [10:0] largest_greater_copy2 = (largest_greater_plus_154_d8 < largest_chosen_d1) ? largest_chosen_d1 : largest_greater_plus_154_d8;
    wire [10:0] largest_sum_plus_127 = 11'd127 + largest_sum_copy2;
    wire [31:0] b_depth_d19 = delay_11_from_1_copy2_out[63:32];
    wire [10:0] largest_in_order_bits = {3'd0, b_depth_d19[30:23]};
    wire largest_in_order = largest_sum_plus_127_d1 < largest_in_order_bits;
    wire [10:0] largest_difference = largest_sum_plus_127_d1 - largest_in_order_bits;
    wire [10:0] largest_chosen_copy2 = largest_in_order ? 11'd0 : largest_difference;
    wire [10:0] largest_greater_copy3 = (largest_greater_d1_copy2 < largest_chosen_d1_copy2) ? largest_chosen_d1_copy2 : largest_greater_d1_copy2;
    wire [10:0] largest_sum_d9_copy2 = delay_9_from_0_out[74:64];
    wire [10:0] largest = (largest_greater_d1_copy3 < largest_sum_d9_copy2) ? largest_sum_d9_copy2 : largest_greater_d1_copy3;
    wire [10:0] a_x_bits_plus_381 = a_x_bits_d10 + 11'd381;
    wire not_zero_is_a_x_bits_d11 = delay_10_from_1_out[0];
    wire ax_out_in_order = largest_d1 < a_x_bits_plus_381_d1;
    wire ax_out_both = not_zero_is_a_x_bits_d11 & ax_out_in_order;
    wire a_x_bits_is_255_d11 = delay_10_from_0_out[1];
    wire [10:0] ax_out_difference = a_x_bits_plus_381_d1 - largest_d1;
    wire [10:0] ax_out_chosen = a_x_bits_is_255_d11 ? a_x_bits_d11 : ax_out_difference;
    wire a_x_sign_d11 = delay_10_from_0_out[25];
    wire a_x_bits_is_255_or_ax_out_both = a_x_bits_is_255_d11 | ax_out_both_d1;
    wire [22:0] a_x_bits_d11_copy2 = delay_10_from_0_out[24:2];
    wire [30:0] ax_out_chosen_copy2 = a_x_bits_is_255_or_ax_out_both ? {ax_out_chosen_d1, a_x_bits_d11_copy2} : 31'd0;
    wire [10:0] a_y_bits_plus_381 = a_y_bits_d10 + 11'd381;
    wire not_zero_is_a_y_bits_d11 = delay_10_from_1_out[1];
    wire ay_out_in_order = largest_d1 < a_y_bits_plus_381_d1;
    wire ay_out_both = not_zero_is_a_y_bits_d11 & ay_out_in_order;
    wire a_y_bits_is_255_d11 = delay_10_from_0_out[26];
    wire [10:0] ay_out_difference = a_y_bits_plus_381_d1 - largest_d1;
    wire [10:0] ay_out_chosen = a_y_bits_is_255_d11 ? a_y_bits_d11 : ay_out_difference;
    wire a_y_sign_d11 = delay_10_from_0_out[50];
    wire a_y_bits_is_255_or_ay_out_both = a_y_bits_is_255_d11 | ay_out_both_d1;
    wire [22:0] a_y_bits_d11_copy2 = delay_10_from_0_out[49:27];
    wire [30:0] ay_out_chosen_copy2 = a_y_bits_is_255_or_ay_out_both ? {ay_out_chosen_d1, a_y_bits_d11_copy2} : 31'd0;
    wire [10:0] b_x_bits_plus_381 = b_x_bits_d10 + 11'd381;
    wire not_zero_is_b_x_bits_d11 = delay_10_from_1_out[2];
    wire bx_out_in_order = largest_d1 < b_x_bits_plus_381_d1;
    wire bx_out_both = not_zero_is_b_x_bits_d11 & bx_out_in_order;
    wire b_x_bits_is_255_d11 = delay_10_from_0_out[51];
    wire [10:0] bx_out_difference = b_x_bits_plus_381_d1 - largest_d1;
    wire [10:0] bx_out_chosen = b_x_bits_is_255_d11 ? b_x_bits_d11 : bx_out_difference;
    wire [10:0] b_y_bits_plus_381 = b_y_bits_d10 + 11'd381;
    wire not_zero_is_b_y_bits_d11 = delay_10_from_1_out[3];
    wire by_out_in_order = largest_d1 < b_y_bits_plus_381_d1;
    wire by_out_both = not_zero_is_b_y_bits_d11 & by_out_in_order;
    wire b_y_bits_is_255_d11 = delay_10_from_0_out[76];
    wire [10:0] by_out_difference = b_y_bits_plus_381_d1 - largest_d1;
    wire [10:0] by_out_chosen = b_y_bits_is_255_d11 ? b_y_bits_d11 : by_out_difference;
    wire [10:0] largest_sum_plus_127_copy2 = 11'd127 + largest_sum_d10;
    wire [10:0] delta_sum = unit_delta_bits_d2 + largest_sum_plus_127_copy2;
    wire zero_is_unit_delta_bits = 11'd0 == unit_delta_bits_d1_bits;
    wire not_zero_is_unit_delta_bits = ~zero_is_unit_delta_bits;
    wire largest_below_delta_sum = largest_d1 < delta_sum_d1;
    wire delta_both = largest_below_delta_sum & not_zero_is_unit_delta_bits_d3;
    wire unit_delta_bits_is_255 = 11'd255 == unit_delta_bits_d2;
    wire [10:0] delta_sum_minus_largest = delta_sum_d1 - largest_d1;
    wire [10:0] delta_chosen = unit_delta_bits_is_255_d1 ? unit_delta_bits_d3 : delta_sum_minus_largest;
    wire delta_either = delta_both_d1 | unit_delta_bits_is_255_d1;
    wire [30:0] delta_chosen_copy2 = delta_either ? {delta_chosen_d1, unit_delta_bits_d3_copy2} : 31'd0;
    wire [31:0] delta = {unit_delta_sign_d3, delta_chosen_copy2};
    wire [10:0] mx_sum_bits_d1_bits = {3'd0, mul_mul_add_f32_ftz_unit_copy3_y[30:23]};
    wire [10:0] mx_sum_d9 = delay_9_from_0_out[85:75];
    wire [10:0] mx_sum_plus_mx_sum_bits = mx_sum_d9 + mx_sum_bits_d1;
    wire zero_is_mx_sum_bits = 11'd0 == mx_sum_bits_d1_bits;
    wire not_zero_is_mx_sum_bits = ~zero_is_mx_sum_bits;
    wire mx_in_order = largest_d1 < mx_sum_plus_mx_sum_bits_d1;
    wire mx_both_copy3 = mx_in_order & not_zero_is_mx_sum_bits_d2;
    wire mx_sum_bits_is_255 = 11'd255 == mx_sum_bits_d2;
    wire [10:0] mx_difference = mx_sum_plus_mx_sum_bits_d1 - largest_d1;
    wire [10:0] mx_chosen_copy5 = mx_sum_bits_is_255_d1 ? mx_sum_bits_d2 : mx_difference;
    wire [10:0] my_sum_bits_d1_bits = {3'd0, mul_mul_add_f32_ftz_unit_copy5_y[30:23]};
    wire [10:0] mx_sum_plus_my_sum_bits = mx_sum_d9 + my_sum_bits_d1;
    wire zero_is_my_sum_bits = 11'd0 == my_sum_bits_d1_bits;
    wire not_zero_is_my_sum_bits = ~zero_is_my_sum_bits;
    wire my_in_order = largest_d1 < mx_sum_plus_my_sum_bits_d1;
    wire my_both = my_in_order & not_zero_is_my_sum_bits_d2;
    wire my_sum_bits_is_255 = 11'd255 == my_sum_bits_d2;
    wire [10:0] my_difference = mx_sum_plus_my_sum_bits_d1 - largest_d1;
    wire [10:0] my_chosen = my_sum_bits_is_255_d1 ? my_sum_bits_d2 : my_difference;
    wire [10:0] edge_on_lesser = (b_exponent_d1 < a_exponent_d1) ? b_exponent_d1 : a_exponent_d1;
    wire [8:0] unit_delta_bits_plus_18_bits = {1'd0, mul_add_f32_ftz_unit_copy3_y[30:23]};
    wire unit_delta_bits_is_zero = unit_delta_bits_plus_18_bits == 9'd0;
    wire [8:0] unit_delta_bits_plus_20 = unit_delta_bits_plus_18_bits + 9'd20;
    wire edge_on_in_order = unit_delta_bits_plus_20 < {1'd0, unit_delta_product_bits_d3};
    wire [8:0] unit_delta_bits_plus_18 = unit_delta_bits_plus_18_bits + 9'd18;
    wire doubtful_in_order = unit_delta_bits_plus_18 < {1'd0, unit_delta_product_bits_d3};
    wire [26:0] first_sum_sum = {4'd0, to_fixed_f32_ftz_u23q8_unit_y} + ({4'd0, to_fixed_f32_ftz_u23q8_unit_y} >> 7);
    wire [26:0] last_sum_sum = {4'd0, to_fixed_f32_ftz_u23q8_unit_copy2_y} + ({4'd0, to_fixed_f32_ftz_u23q8_unit_copy2_y} >> 7);
    wire [26:0] first_difference_sum = first_sum_sum;
    wire sight_disc_out_d61 = delay_10_from_0_out[0];
    wire [31:0] last_difference_chosen = sight_disc_out_d61 ? max_f32_ftz_unit_copy8_y : last_difference_sum_d2;
    wire [26:0] last_difference_sum = last_sum_sum;
    wire whole_d59 = delay_16_from_1_out[0];
    wire whole_and_first_sum_both = whole_d59 & delay_63_from_0_out;
    wire [26:0] first_sum_difference = delay_60_from_1_out - first_sum_sum_d1_copy3;
    wire [26:0] first_sum_sum_copy3 = first_sum_difference_d1 + 27'h7fffff7;
    wire [26:0] last_sum_sum_copy2 = last_sum_sum_d1_copy2 + delay_60_from_1_out;
    wire [26:0] last_sum_sum_copy3 = last_sum_sum_d1_copy3 + 27'h7ffff08;
    wire [26:0] first_sum_greater = ($signed(27'd0) < $signed(first_sum_shifted_d1)) ? first_sum_shifted_d1 : 27'd0;
    wire [26:0] last_sum_lesser = ($signed(last_sum_shifted_d1) < $signed(27'd1023)) ? last_sum_shifted_d1 : 27'd1023;
    wire [26:0] first_difference_difference_copy2 = delay_61_from_1_out - first_difference_sum_d1_copy2;
    wire [26:0] first_difference_sum_copy2 = first_difference_difference_d1 + 27'd247;
    wire [26:0] first_difference_sum_copy3 = first_difference_shifted_d1 + 27'd511;
    wire [26:0] last_difference_sum_copy2 = last_difference_sum_d1_copy2 + delay_61_from_1_out;
    wire [26:0] last_difference_sum_copy3 = last_difference_sum_d1_copy3 + 27'd8;
    wire [26:0] last_difference_sum_copy4 = 27'd511 + last_difference_shifted_d1;
    wire [26:0] first_difference_greater = ($signed(27'd0) < $signed(first_difference_sum_d1_copy3)) ? first_difference_sum_d1_copy3 : 27'd0;
    wire [26:0] last_difference_lesser = ($signed(last_difference_sum_d1_copy4) < $signed(27'd1023)) ? last_difference_sum_d1_copy4 : 27'd1023;
    wire [26:0] last_sum = whole_and_first_sum_both_d1 ? last_sum_lesser_d1 : 27'd1023;
    wire [26:0] first_sum = whole_and_first_sum_both_d1 ? first_sum_greater_d1 : 27'd0;
    wire first_sum_up_to_last_sum = ~($signed(last_sum) < $signed(first_sum));
    wire [26:0] last_difference = whole_and_first_sum_both_d2 ? last_difference_lesser_d1 : 27'd1023;
    wire [26:0] first_difference = whole_and_first_sum_both_d2 ? first_difference_greater_d1 : 27'd0;
    wire visible_in_order = ~($signed(last_difference) < $signed(first_difference));
    wire occupied_x = first_x_shifted_d3 < last_x_lesser_d1;
    wire before_far_and_occupied_x = delay_56_from_0_out & occupied_x;
    wire turned_and_lowered_chosen_sign_d37 = delay_37_from_1_out[0];
    wire sight_negative_out = mul_add_f32_ftz_unit_copy3_y[31] ^ turned_and_lowered_chosen_sign_d37;
    wire visible_both = first_sum_up_to_last_sum_d2 & visible_in_order_d1;
    wire visible_both_d11 = delay_11_from_1_out[107];
    wire visible_both_and_visible_both = visible_both & visible_both_d11;
    wire visible_both_copy3 = delay_85_from_1_out & visible_both_and_visible_both;
    wire not_ax_out_joined_sign = ~a_x_sign_d11;
    wire not_ay_out_joined_sign = ~a_y_sign_d11;
    wire [31:0] first_y_chosen_copy10 = sight_disc_out_d51 ? min_f32_ftz_unit_copy2_y : first_y_chosen_d2;
    wire [31:0] first_x_chosen_copy10 = sight_disc_out_d50 ? min_f32_ftz_unit_copy2_y : first_x_chosen_d2;
    wire [31:0] add_f32_ftz_unit_copy2_b_bits = {~mul_mul_add_f32_ftz_unit_y[31], mul_mul_add_f32_ftz_unit_y[30:0]};
    wire [31:0] center_x_d23 = delay_23_from_0_out[31:0];
    wire not_depth_a_sign = ~depth_a[31];
    wire [31:0] center_x_minus_t_x_d17 = delay_17_from_1_out[32:1];
    wire [31:0] center_y_minus_t_y_d17 = delay_17_from_1_out[64:33];
    wire [31:0] minus_filter_radius = {~filter_radius[31], filter_radius[30:0]};
    wire [31:0] center_x_d43 = delay_20_from_0_out[31:0];
    wire [31:0] center_y_d23 = delay_22_from_0_out[31:0];
    wire [31:0] minus_mul_f32_ftz_unit_copy6_y = {~mul_f32_ftz_unit_copy6_y[31], mul_f32_ftz_unit_copy6_y[30:0]};
    wire [31:0] t_x_plus_t_y_d27 = delay_27_from_1_out[31:0];
    wire [31:0] t_x_minus_t_y_d27 = delay_27_from_1_out[63:32];
    wire [31:0] middle_depth_d7 = delay_6_from_0_out[63:32];
    wire [31:0] add_f32_ftz_unit_copy16_b_bits = {~mul_add_f32_ftz_unit_copy2_y[31], mul_add_f32_ftz_unit_copy2_y[30:0]};
    wire [31:0] b_depth_d8 = delay_8_from_1_out[31:0];
    wire [31:0] q_d20 = delay_14_from_0_out[96:65];
    wire [31:0] alpha_joined_d11 = delay_11_from_1_out[31:0];
    wire [31:0] beta_joined_d11 = delay_11_from_1_out[63:32];
    wire [31:0] abs_b_depth_d30 = delay_30_from_1_out[32:1];
    wire [31:0] t_x_sum_d9 = delay_9_from_0_out[31:0];
    wire [31:0] v_x_chosen_d14 = delay_14_from_0_out[31:0];
    wire [31:0] t_y_sum_d9 = delay_9_from_0_out[63:32];
    wire [31:0] first_x_chosen_d43 = delay_43_from_1_out[31:0];
    wire [31:0] v_y_chosen_d14 = delay_14_from_0_out[63:32];
    wire [31:0] first_sum_sum_d12 = delay_12_from_1_out[43:12];
    wire [31:0] sight_near_out_joined = {not_depth_a_sign, depth_a[30:0]};
    wire [31:0] first_y_chosen_d43 = delay_43_from_1_out[63:32];
    wire [31:0] one_minus_depth_a_d40 = delay_39_from_0_out[63:32];
    wire [31:0] mul_mul_add_f32_ftz_unit_a_choice = mul_mul_add_f32_ftz_unit_phase ? mul_f32_ftz_unit_y : mul_f32_ftz_unit_copy4_y;
    wire [31:0] h_x_sum_d13 = delay_13_from_1_out[31:0];
    wire [31:0] a_x_joined_d14 = delay_14_from_1_out[31:0];
    wire [31:0] minus_mul_f32_ftz_unit_y = {~mul_f32_ftz_unit_y[31], mul_f32_ftz_unit_y[30:0]};
    wire [31:0] h_y_sum_d13 = delay_13_from_1_out[63:32];
    wire [31:0] b_x_joined_d14 = delay_14_from_1_out[95:64];
    wire [31:0] minus_mul_f32_ftz_unit_copy2_y = {~mul_f32_ftz_unit_copy2_y[31], mul_f32_ftz_unit_copy2_y[30:0]};
    wire [31:0] a_y_joined_d14 = delay_14_from_1_out[63:32];
    wire [31:0] b_depth_d30 = delay_11_from_1_copy2_out[95:64];
    wire [31:0] spread_half_d8 = delay_5_from_1_out[63:32];
    wire [31:0] half_depth_chosen_d39 = delay_39_from_0_out[31:0];
    wire [31:0] half_depth = beyond_near ? spread_half_d8 : half_depth_chosen_d39;
    wire [31:0] q_d6 = delay_6_from_0_out[31:0];
    wire [31:0] last_x_chosen_copy4 = sight_disc_out_d50 ? max_f32_ftz_unit_y : last_x_chosen_d2;
    wire [31:0] first_sum_chosen = sight_disc_out_d61 ? max_f32_ftz_unit_copy5_y : first_sum_sum_d2_copy2;
    wire [31:0] last_y_chosen_copy4 = sight_disc_out_d50 ? max_f32_ftz_unit_copy2_y : last_y_chosen_d2;
    wire [31:0] last_sum_chosen = sight_disc_out_d61 ? max_f32_ftz_unit_copy6_y : last_sum_sum_d2;
    wire [31:0] first_difference_chosen = sight_disc_out_d61 ? max_f32_ftz_unit_copy7_y : first_difference_sum_d2;
    wire [10:0] largest_greater_plus_154 = largest_greater_d1 + 11'd154;
    wire [10:0] a_exponent_plus_b_exponent = a_exponent_d1 + b_exponent_d1;
    wire [10:0] largest_sum = lowered_d26 + a_exponent_plus_b_exponent;
    wire [10:0] lowered_plus_m_exponent = lowered_d27 + m_exponent_d1;
    wire [10:0] mx_sum_copy3 = 11'd127 + lowered_plus_m_exponent;
    wire [10:0] largest_sum_copy3 = lowered_plus_m_exponent + 11'd27;
    wire [8:0] first_y = first_y_shifted_d3[8:0];
    wire [21:0] last_x_lesser_minus_1 = last_x_lesser_d1 - 22'd1;
    wire [8:0] last_x = last_x_lesser_minus_1[8:0];
    wire [8:0] first_x = first_x_shifted_d3[8:0];
    wire beyond_near_and_not_turned = beyond_near_d7 & not_turned_d1;
    wire [31:0] v_y_chosen = swapped_d2 ? tangent2_y_d3 : tangent1_y_d3;
    wire [31:0] v_y_chosen_copy2 = turned_d1 ? v_y_chosen : center_y_d3;
    wire [31:0] v_x_chosen = swapped_d2 ? tangent2_x_d3 : tangent1_x_d3;
    wire [31:0] v_x_chosen_copy2 = turned_d1 ? v_x_chosen : center_x_d3;
    wire all_before_far = whole_d30 & le_f32_ftz_unit_copy4_y;
    wire [31:0] half_depth_chosen = beyond_near_and_not_turned_d14 ? min_f32_ftz_unit_y : 32'h3f800000;
    wire [31:0] ay_out = delay_36_from_1_out ? ay_out_joined_d1_copy2 : ay_out_joined_d1;
    wire [31:0] ax_out = delay_36_from_1_out ? ax_out_joined_d1_copy2 : ax_out_joined_d1;
    wire not_turned_d18 = delay_17_from_1_out[0];
    wire before_far_both = not_turned_d18 & le_f32_ftz_unit_copy2_y;
    wire sight_disc_out = beyond_near_and_not_turned_d17 & before_far_both;
    wire mx_both_or_mx_sum_bits_is_255 = mx_both_d1_copy3 | mx_sum_bits_is_255_d1;
    wire [30:0] mx_chosen_copy6 = mx_both_or_mx_sum_bits_is_255 ? mx_joined_d1_copy3 : 31'd0;
    wire [31:0] mx = {mx_sum_sign_d3, mx_chosen_copy6};
    wire b_y_sign_d11 = delay_10_from_0_out[100];
    wire b_y_bits_is_255_or_by_out_both = b_y_bits_is_255_d11 | by_out_both_d1;
    wire [22:0] b_y_bits_d11_copy2 = delay_10_from_0_out[99:77];
    wire [30:0] by_out_chosen_copy2 = b_y_bits_is_255_or_by_out_both ? {by_out_chosen_d1, b_y_bits_d11_copy2} : 31'd0;
    wire b_x_sign_d11 = delay_10_from_0_out[75];
    wire b_x_bits_is_255_or_bx_out_both = b_x_bits_is_255_d11 | bx_out_both_d1;
    wire [22:0] b_x_bits_d11_copy2 = delay_10_from_0_out[74:52];
    wire [30:0] bx_out_chosen_copy2 = b_x_bits_is_255_or_bx_out_both ? {bx_out_chosen_d1, b_x_bits_d11_copy2} : 31'd0;
    wire my_both_or_my_sum_bits_is_255 = my_both_d1 | my_sum_bits_is_255_d1;
    wire [30:0] my_chosen_copy2 = my_both_or_my_sum_bits_is_255 ? my_joined_d1 : 31'd0;
    wire [31:0] my = {my_sum_sign_d3, my_chosen_copy2};
    wire before_far_in_order_d12 = delay_12_from_0_out[0];
    wire before_far = before_far_both | before_far_in_order_d12;
    wire center_x_bits_below_140 = {3'd0, mul_add_f32_ftz_unit_y[30:23]} < 11'd140;
    wire center_y_bits_below_140 = {3'd0, mul_add_f32_ftz_unit_copy2_y[30:23]} < 11'd140;
    wire first_sum_both = center_x_bits_below_140 & center_y_bits_below_140;
    wire edge_on_lesser_below_32 = edge_on_lesser_d1 < 11'd32;
    wire occupied_y = first_y_shifted_d3 < last_y_lesser_d1;
    wire visible_both_copy2 = occupied_y & before_far_and_occupied_x_d1;
    wire beta_either = beta_both_d1 | lowered_chosen_bits_is_255_d1_copy6;
    wire [30:0] beta_chosen_copy2 = beta_either ? {beta_chosen_d1, lowered_chosen_bits_d4_copy6} : 31'd0;
    wire alpha_either = alpha_both_d1 | lowered_chosen_bits_is_255_d1_copy3;
    wire [30:0] alpha_chosen_copy2 = alpha_either ? {alpha_chosen_d1, lowered_chosen_bits_d4_copy3} : 31'd0;
    wire zero_is_alpha_bits = 11'd0 == {3'd0, mul_f32_ftz_unit_y[30:23]};
    wire not_zero_is_alpha_bits = ~zero_is_alpha_bits;
    wire zero_is_beta_bits = 11'd0 == {3'd0, mul_f32_ftz_unit_copy2_y[30:23]};
    wire not_zero_is_beta_bits = ~zero_is_beta_bits;
    wire [21:0] last_y_lesser_minus_1 = last_y_lesser_d1 - 22'd1;
    wire [8:0] last_y = last_y_lesser_minus_1[8:0];
    wire b_x_either = b_x_in_order_and_b_x_inverted_d1 | lowered_chosen_bits_is_255_d1_copy4;
    wire [30:0] b_x_chosen_copy2 = b_x_either ? {b_x_chosen_d1, lowered_chosen_bits_d4_copy4} : 31'd0;
    wire a_y_either = a_y_in_order_and_a_y_inverted_d1 | lowered_chosen_bits_is_255_d1_copy2;
    wire [30:0] a_y_chosen_copy2 = a_y_either ? {a_y_chosen_d1, lowered_chosen_bits_d4_copy2} : 31'd0;
    wire a_x_either = a_x_in_order_and_a_x_inverted_d1 | lowered_chosen_bits_is_255_d1;
    wire [30:0] a_x_chosen_copy2 = a_x_either ? {a_x_chosen_d1, lowered_chosen_bits_d4} : 31'd0;
    wire b_y_either = b_y_in_order_and_b_y_inverted_d1 | lowered_chosen_bits_is_255_d1_copy5;
    wire [30:0] b_y_chosen_copy2 = b_y_either ? {b_y_chosen_d1, lowered_chosen_bits_d4_copy5} : 31'd0;
    wire last_y_chosen_d50 = delay_50_from_1_out[4];
    wire [31:0] last_y_chosen_copy2 = last_y_chosen_d50 ? add_f32_ftz_unit_copy15_y : 32'h45fff800;
    wire last_x_chosen_d50 = delay_50_from_1_out[2];
    wire [31:0] last_x_chosen_copy2 = last_x_chosen_d50 ? add_f32_ftz_unit_copy8_y : 32'h45fff800;
    wire first_x_chosen_d50 = delay_50_from_1_out[1];
    wire [31:0] first_x_chosen_copy8 = first_x_chosen_d50 ? add_f32_ftz_unit_copy8_y : 32'd0;
    wire first_y_chosen_d50 = delay_50_from_1_out[3];
    wire [31:0] first_y_chosen_copy8 = first_y_chosen_d50 ? add_f32_ftz_unit_copy15_y : 32'd0;
    wire visible_unequal = scale_x[31] ^ scale_y[31];
    wire swapped_and_turned = swapped_d2 & turned;
    wire visible_unequal_copy2 = visible_unequal ^ swapped_and_turned;
    wire turned_and_lowered_chosen_sign = turned & lowered_chosen_copy5[31];
    wire [31:0] first_y_chosen_copy5 = lt_f32_ftz_unit_copy8_y ? center_y_minus_first_y_joined_d1 : center_y_plus_first_y_joined_d1;
    wire [31:0] first_x_chosen_copy5 = lt_f32_ftz_unit_copy6_y ? center_x_minus_first_x_joined_d1 : center_x_plus_first_x_joined_d1;
    wire last_y_chosen = scale_y[31] ? lt_f32_ftz_unit_copy8_y : lt_f32_ftz_unit_copy9_y;
    wire first_y_chosen_copy7 = scale_y[31] ? lt_f32_ftz_unit_copy9_y : lt_f32_ftz_unit_copy8_y;
    wire last_x_chosen = scale_x[31] ? lt_f32_ftz_unit_copy6_y : lt_f32_ftz_unit_copy7_y;
    wire first_x_chosen_copy7 = scale_x[31] ? lt_f32_ftz_unit_copy7_y : lt_f32_ftz_unit_copy6_y;
    wire edge_on_lesser_below_32_d8 = delay_8_from_1_out[32];
    wire doubtful_either = unit_delta_bits_is_zero_d1 | doubtful_in_order_d1;
    wire doubtful = edge_on_lesser_below_32_d8 | doubtful_either;
    wire visible_unequal_d37 = delay_37_from_1_out[1];
    wire visible_unequal_copy3 = sight_negative_out_d1 ^ visible_unequal_d37;
    wire doubtful_or_visible_unequal = doubtful | visible_unequal_copy3;
    wire edge_on_either = unit_delta_bits_is_zero_d1 | edge_on_in_order_d1;
    wire edge_on = edge_on_lesser_below_32_d8 | edge_on_either;
    wire [26:0] first_sum_sum_copy2_bits = {{5{center_x_fixed_d1[21]}}, center_x_fixed_d1};
    wire [26:0] first_sum_sum_copy2_bits_2 = {{5{to_fixed_f32_ftz_s22q8_unit_y[21]}}, to_fixed_f32_ftz_s22q8_unit_y};
    wire [26:0] first_sum_sum_copy2 = first_sum_sum_copy2_bits + first_sum_sum_copy2_bits_2;
    wire [26:0] first_difference_difference = first_sum_sum_copy2_bits - first_sum_sum_copy2_bits_2;

    assign out_end = queue_1_out_data[3];
    assign {out_center_x, out_center_y, out_ax, out_bx} = queue_2_out_data;
    assign {out_ay, out_by, out_delta, out_mx} = queue_3_out_data;
    assign out_my = queue_4_out_data[117:86];
    assign out_sight_negative = queue_1_out_data[2];
    assign {out_sight_near, out_sight_far} = queue_4_out_data[85:24];
    assign {out_sight_turned, out_sight_disc} = queue_1_out_data[1:0];
    assign out_depth = queue_4_out_data[23:0];
    assign {
        out_depth_low, out_depth_high, out_attribute_0, out_attribute_1, out_attribute_2, out_attribute_3,
        out_attribute_4
    } = queue_5_out_data;
    assign {
        out_attribute_5, out_attribute_6, out_attribute_7, out_attribute_8, out_attribute_9, out_attribute_10,
        out_attribute_11, out_attribute_12
    } = queue_6_out_data;
    assign {
        out_cardinal_0, out_left, out_right, out_top, out_bottom, out_first_sum, out_last_sum,
        out_first_difference, out_last_difference
    } = queue_7_out_data;

    memory_1w1r #(.WIDTH(97), .DEPTH(92)) delay_93_from_0 (
        .clk(clk), .write(phases_13[0]), .write_address(delay_93_from_0_pointer),
        .write_data({
            in_attribute_5, in_attribute_4, in_attribute_3, in_attribute_2, in_attribute_1, in_attribute_0,
            in_end
        }),
        .read(phases_13[0]), .read_address(delay_93_from_0_pointer), .read_data(delay_93_from_0_out)
    );

    memory_1w1r #(.WIDTH(96), .DEPTH(92)) delay_93_from_0_copy2 (
        .clk(clk), .write(phases_14[0]), .write_address(delay_93_from_0_copy2_pointer),
        .write_data({in_attribute_11, in_attribute_10, in_attribute_9, in_attribute_8, in_attribute_7, in_attribute_6}),
        .read(phases_14[0]), .read_address(delay_93_from_0_copy2_pointer),
        .read_data(delay_93_from_0_copy2_out)
    );

    memory_1w1r #(.WIDTH(32), .DEPTH(92)) delay_93_from_0_copy3 (
        .clk(clk), .write(phases_7[0]), .write_address(delay_93_from_0_copy3_pointer),
        .write_data({in_cardinal_0, in_attribute_12}),
        .read(phases_7[0]), .read_address(delay_93_from_0_copy3_pointer),
        .read_data(delay_93_from_0_copy3_out)
    );

    memory_1w1r #(.WIDTH(1), .DEPTH(84)) delay_85_from_1 (
        .clk(clk), .write(phases_5[1]), .write_address(delay_85_from_1_pointer), .write_data(reaches_near),
        .read(phases_5[1]), .read_address(delay_85_from_1_pointer), .read_data(delay_85_from_1_out)
    );

    float_max_s2_f32ftz max_f32_ftz_unit (
        .clk(clk), .enable(1'd1), .a(max_f32_ftz_unit_a), .b(max_f32_ftz_unit_b), .y(max_f32_ftz_unit_y)
    );

    float_max_s2_f32ftz max_f32_ftz_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(max_f32_ftz_unit_copy2_a), .b(max_f32_ftz_unit_copy2_b),
        .y(max_f32_ftz_unit_copy2_y)
    );

    float_max_s2_f32ftz max_f32_ftz_unit_copy3 (
        .clk(clk), .enable(1'd1), .a(max_f32_ftz_unit_copy3_a), .b(max_f32_ftz_unit_copy3_b),
        .y(max_f32_ftz_unit_copy3_y)
    );

    float_max_s2_f32ftz max_f32_ftz_unit_copy4 (
        .clk(clk), .enable(1'd1), .a(max_f32_ftz_unit_copy4_a), .b(max_f32_ftz_unit_copy4_b),
        .y(max_f32_ftz_unit_copy4_y)
    );

    float_max_s2_f32ftz max_f32_ftz_unit_copy5 (
        .clk(clk), .enable(1'd1), .a(max_f32_ftz_unit_copy5_a), .b(max_f32_ftz_unit_copy5_b),
        .y(max_f32_ftz_unit_copy5_y)
    );

    float_max_s2_f32ftz max_f32_ftz_unit_copy6 (
        .clk(clk), .enable(1'd1), .a(max_f32_ftz_unit_copy6_a), .b(max_f32_ftz_unit_copy6_b),
        .y(max_f32_ftz_unit_copy6_y)
    );

    float_max_s2_f32ftz max_f32_ftz_unit_copy7 (
        .clk(clk), .enable(1'd1), .a(max_f32_ftz_unit_copy7_a), .b(max_f32_ftz_unit_copy7_b),
        .y(max_f32_ftz_unit_copy7_y)
    );

    float_max_s2_f32ftz max_f32_ftz_unit_copy8 (
        .clk(clk), .enable(1'd1), .a(max_f32_ftz_unit_copy8_a), .b(max_f32_ftz_unit_copy8_b),
        .y(max_f32_ftz_unit_copy8_y)
    );

    float_lt_s2_f32ftz lt_f32_ftz_unit (
        .clk(clk), .enable(1'd1), .a(near_plane), .b(in_center_z), .y(lt_f32_ftz_unit_y)
    );

    float_lt_s2_f32ftz lt_f32_ftz_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(lt_f32_ftz_unit_copy2_a_bits), .b(lt_f32_ftz_unit_copy2_b_bits),
        .y(lt_f32_ftz_unit_copy2_y)
    );

    float_lt_s2_f32ftz lt_f32_ftz_unit_copy3 (
        .clk(clk), .enable(1'd1), .a(center_z_d2), .b(max_f32_ftz_unit_copy3_y), .y(lt_f32_ftz_unit_copy3_y)
    );

    float_lt_s2_f32ftz lt_f32_ftz_unit_copy4 (
        .clk(clk), .enable(1'd1), .a(near_plane), .b(add_f32_ftz_unit_y), .y(lt_f32_ftz_unit_copy4_y)
    );

    float_lt_s2_f32ftz lt_f32_ftz_unit_copy5 (
        .clk(clk), .enable(1'd1), .a(32'h39800000), .b(add_f32_ftz_unit_copy2_y), .y(lt_f32_ftz_unit_copy5_y)
    );

    float_lt_s2_f32ftz lt_f32_ftz_unit_copy6 (
        .clk(clk), .enable(1'd1), .a(32'd0), .b(add_f32_ftz_unit_copy6_y), .y(lt_f32_ftz_unit_copy6_y)
    );

    float_lt_s2_f32ftz lt_f32_ftz_unit_copy7 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy7_y), .b(32'd0), .y(lt_f32_ftz_unit_copy7_y)
    );

    float_lt_s2_f32ftz lt_f32_ftz_unit_copy8 (
        .clk(clk), .enable(1'd1), .a(32'd0), .b(add_f32_ftz_unit_copy13_y), .y(lt_f32_ftz_unit_copy8_y)
    );

    float_lt_s2_f32ftz lt_f32_ftz_unit_copy9 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy14_y), .b(32'd0), .y(lt_f32_ftz_unit_copy9_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_a), .b(add_f32_ftz_unit_b), .y(add_f32_ftz_unit_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy2_a), .b(add_f32_ftz_unit_copy2_b),
        .y(add_f32_ftz_unit_copy2_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy3 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy3_a), .b(add_f32_ftz_unit_copy3_b),
        .y(add_f32_ftz_unit_copy3_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy4 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy4_a), .b(add_f32_ftz_unit_copy4_b),
        .y(add_f32_ftz_unit_copy4_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy5 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy5_a), .b(add_f32_ftz_unit_copy5_b),
        .y(add_f32_ftz_unit_copy5_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy6 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy6_a), .b(add_f32_ftz_unit_copy6_b),
        .y(add_f32_ftz_unit_copy6_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy7 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy7_a), .b(add_f32_ftz_unit_copy7_b),
        .y(add_f32_ftz_unit_copy7_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy8 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy8_a), .b(add_f32_ftz_unit_copy8_b),
        .y(add_f32_ftz_unit_copy8_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy9 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy9_a), .b(add_f32_ftz_unit_copy9_b),
        .y(add_f32_ftz_unit_copy9_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy10 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy10_a), .b(add_f32_ftz_unit_copy10_b),
        .y(add_f32_ftz_unit_copy10_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy11 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy11_a), .b(add_f32_ftz_unit_copy11_b),
        .y(add_f32_ftz_unit_copy11_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy12 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy12_a), .b(add_f32_ftz_unit_copy12_b),
        .y(add_f32_ftz_unit_copy12_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy13 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy13_a), .b(add_f32_ftz_unit_copy13_b),
        .y(add_f32_ftz_unit_copy13_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy14 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy14_a), .b(add_f32_ftz_unit_copy14_b),
        .y(add_f32_ftz_unit_copy14_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy15 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy15_a), .b(add_f32_ftz_unit_copy15_b),
        .y(add_f32_ftz_unit_copy15_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy16 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy16_a), .b(add_f32_ftz_unit_copy16_b),
        .y(add_f32_ftz_unit_copy16_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy17 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy17_a), .b(add_f32_ftz_unit_copy17_b),
        .y(add_f32_ftz_unit_copy17_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy18 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy18_a), .b(add_f32_ftz_unit_copy18_b),
        .y(add_f32_ftz_unit_copy18_y)
    );

    float_recip_s28_f32ftz recip_f32_ftz_unit (
        .clk(clk), .enable(1'd1), .a(recip_f32_ftz_unit_a), .y(recip_f32_ftz_unit_y)
    );

    float_recip_s28_f32ftz recip_f32_ftz_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(recip_f32_ftz_unit_copy2_a), .y(recip_f32_ftz_unit_copy2_y)
    );

    float_mul_s6_f32ftz mul_f32_ftz_unit (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_a), .b(mul_f32_ftz_unit_b), .y(mul_f32_ftz_unit_y)
    );

    float_mul_s6_f32ftz mul_f32_ftz_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_copy2_a), .b(mul_f32_ftz_unit_copy2_b),
        .y(mul_f32_ftz_unit_copy2_y)
    );

    float_mul_s6_f32ftz mul_f32_ftz_unit_copy3 (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_copy3_a), .b(mul_f32_ftz_unit_copy3_b),
        .y(mul_f32_ftz_unit_copy3_y)
    );

    float_mul_s6_f32ftz mul_f32_ftz_unit_copy4 (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_copy4_a), .b(mul_f32_ftz_unit_copy4_b),
        .y(mul_f32_ftz_unit_copy4_y)
    );

    float_mul_s6_f32ftz mul_f32_ftz_unit_copy5 (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_copy5_a), .b(mul_f32_ftz_unit_copy5_b),
        .y(mul_f32_ftz_unit_copy5_y)
    );

    float_mul_s6_f32ftz mul_f32_ftz_unit_copy6 (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_copy6_a), .b(mul_f32_ftz_unit_copy6_b),
        .y(mul_f32_ftz_unit_copy6_y)
    );

    float_mul_s6_f32ftz mul_f32_ftz_unit_copy7 (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_copy7_a), .b(mul_f32_ftz_unit_copy7_b),
        .y(mul_f32_ftz_unit_copy7_y)
    );

    float_mul_s6_f32ftz mul_f32_ftz_unit_copy8 (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_copy8_a), .b(mul_f32_ftz_unit_copy8_b),
        .y(mul_f32_ftz_unit_copy8_y)
    );

    float_mul_s6_f32ftz mul_f32_ftz_unit_copy9 (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_copy9_a), .b(mul_f32_ftz_unit_copy9_b),
        .y(mul_f32_ftz_unit_copy9_y)
    );

    float_mul_s6_f32ftz mul_f32_ftz_unit_copy10 (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_copy10_a), .b(mul_f32_ftz_unit_copy10_b),
        .y(mul_f32_ftz_unit_copy10_y)
    );

    float_mul_s6_f32ftz mul_f32_ftz_unit_copy11 (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_copy11_a), .b(mul_f32_ftz_unit_copy11_b),
        .y(mul_f32_ftz_unit_copy11_y)
    );

    float_mul_s6_f32ftz mul_f32_ftz_unit_copy12 (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_copy12_a), .b(mul_f32_ftz_unit_copy12_b),
        .y(mul_f32_ftz_unit_copy12_y)
    );

    float_mul_s6_f32ftz mul_f32_ftz_unit_copy13 (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_copy13_a), .b(mul_f32_ftz_unit_copy13_b),
        .y(mul_f32_ftz_unit_copy13_y)
    );

    mul_mul_add_p6_s6_f32ftz mul_mul_add_f32_ftz_unit (
        .clk(clk), .enable(1'd1), .a(mul_mul_add_f32_ftz_unit_a), .b(mul_mul_add_f32_ftz_unit_b),
        .c(mul_mul_add_f32_ftz_unit_c), .d(mul_mul_add_f32_ftz_unit_d), .y(mul_mul_add_f32_ftz_unit_y)
    );

    mul_mul_add_p6_s6_f32ftz mul_mul_add_f32_ftz_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(mul_mul_add_f32_ftz_unit_copy2_a), .b(mul_mul_add_f32_ftz_unit_copy2_b),
        .c(mul_mul_add_f32_ftz_unit_copy2_c), .d(mul_mul_add_f32_ftz_unit_copy2_d),
        .y(mul_mul_add_f32_ftz_unit_copy2_y)
    );

    mul_mul_add_p6_s6_f32ftz mul_mul_add_f32_ftz_unit_copy3 (
        .clk(clk), .enable(1'd1), .a(mul_mul_add_f32_ftz_unit_copy3_a), .b(mul_mul_add_f32_ftz_unit_copy3_b),
        .c(mul_mul_add_f32_ftz_unit_copy3_c), .d(mul_mul_add_f32_ftz_unit_copy3_d),
        .y(mul_mul_add_f32_ftz_unit_copy3_y)
    );

    mul_mul_add_p6_s6_f32ftz mul_mul_add_f32_ftz_unit_copy4 (
        .clk(clk), .enable(1'd1), .a(mul_mul_add_f32_ftz_unit_copy4_a), .b(mul_mul_add_f32_ftz_unit_copy4_b),
        .c(mul_mul_add_f32_ftz_unit_copy4_c), .d(mul_mul_add_f32_ftz_unit_copy4_d),
        .y(mul_mul_add_f32_ftz_unit_copy4_y)
    );

    mul_mul_add_p6_s6_f32ftz mul_mul_add_f32_ftz_unit_copy5 (
        .clk(clk), .enable(1'd1), .a(mul_mul_add_f32_ftz_unit_copy5_a), .b(mul_mul_add_f32_ftz_unit_copy5_b),
        .c(mul_mul_add_f32_ftz_unit_copy5_c), .d(mul_mul_add_f32_ftz_unit_copy5_d),
        .y(mul_mul_add_f32_ftz_unit_copy5_y)
    );

    mul_mul_add_p6_s6_f32ftz mul_mul_add_f32_ftz_unit_copy6 (
        .clk(clk), .enable(1'd1), .a(mul_mul_add_f32_ftz_unit_copy6_a), .b(mul_mul_add_f32_ftz_unit_copy6_b),
        .c(mul_mul_add_f32_ftz_unit_copy6_c), .d(mul_mul_add_f32_ftz_unit_copy6_d),
        .y(mul_mul_add_f32_ftz_unit_copy6_y)
    );

    mul_mul_add_p6_s6_f32ftz mul_mul_add_f32_ftz_unit_copy7 (
        .clk(clk), .enable(1'd1), .a(mul_mul_add_f32_ftz_unit_copy7_a), .b(mul_mul_add_f32_ftz_unit_copy7_b),
        .c(mul_mul_add_f32_ftz_unit_copy7_c), .d(mul_mul_add_f32_ftz_unit_copy7_d),
        .y(mul_mul_add_f32_ftz_unit_copy7_y)
    );

    mul_add_p6_s6_f32ftz mul_add_f32_ftz_unit (
        .clk(clk), .enable(1'd1), .a(mul_add_f32_ftz_unit_a), .b(mul_add_f32_ftz_unit_b),
        .c(mul_add_f32_ftz_unit_c), .y(mul_add_f32_ftz_unit_y)
    );

    mul_add_p6_s6_f32ftz mul_add_f32_ftz_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(mul_add_f32_ftz_unit_copy2_a), .b(mul_add_f32_ftz_unit_copy2_b),
        .c(mul_add_f32_ftz_unit_copy2_c), .y(mul_add_f32_ftz_unit_copy2_y)
    );

    mul_add_p6_s6_f32ftz mul_add_f32_ftz_unit_copy3 (
        .clk(clk), .enable(1'd1), .a(mul_add_f32_ftz_unit_copy3_a), .b(mul_add_f32_ftz_unit_copy3_b),
        .c(mul_add_f32_ftz_unit_copy3_c), .y(mul_add_f32_ftz_unit_copy3_y)
    );

    float_sqrt_s26_f32ftz sqrt_f32_ftz_unit (
        .clk(clk), .enable(1'd1), .a(sqrt_f32_ftz_unit_a), .y(sqrt_f32_ftz_unit_y)
    );

    float_sqrt_s26_f32ftz sqrt_f32_ftz_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(sqrt_f32_ftz_unit_copy2_a), .y(sqrt_f32_ftz_unit_copy2_y)
    );

    float_sqrt_s26_f32ftz sqrt_f32_ftz_unit_copy3 (
        .clk(clk), .enable(1'd1), .a(sqrt_f32_ftz_unit_copy3_a), .y(sqrt_f32_ftz_unit_copy3_y)
    );

    float_le_s2_f32ftz le_f32_ftz_unit (
        .clk(clk), .enable(1'd1), .a(32'd0), .b(add_f32_ftz_unit_copy2_y), .y(le_f32_ftz_unit_y)
    );

    float_le_s2_f32ftz le_f32_ftz_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_y), .b(32'h3f800000), .y(le_f32_ftz_unit_copy2_y)
    );

    float_le_s2_f32ftz le_f32_ftz_unit_copy3 (
        .clk(clk), .enable(1'd1), .a(depth_b), .b(before_far_joined_d1), .y(le_f32_ftz_unit_copy3_y)
    );

    float_le_s2_f32ftz le_f32_ftz_unit_copy4 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy5_y), .b(32'h3f800000), .y(le_f32_ftz_unit_copy4_y)
    );

    float_min_s2_f32ftz min_f32_ftz_unit (
        .clk(clk), .enable(1'd1), .a(min_f32_ftz_unit_a), .b(min_f32_ftz_unit_b), .y(min_f32_ftz_unit_y)
    );

    float_min_s2_f32ftz min_f32_ftz_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(min_f32_ftz_unit_copy2_a), .b(min_f32_ftz_unit_copy2_b),
        .y(min_f32_ftz_unit_copy2_y)
    );

    float_min_s2_f32ftz min_f32_ftz_unit_copy3 (
        .clk(clk), .enable(1'd1), .a(min_f32_ftz_unit_copy3_a), .b(min_f32_ftz_unit_copy3_b),
        .y(min_f32_ftz_unit_copy3_y)
    );

    float_min_s2_f32ftz min_f32_ftz_unit_copy4 (
        .clk(clk), .enable(1'd1), .a(min_f32_ftz_unit_copy4_a), .b(min_f32_ftz_unit_copy4_b),
        .y(min_f32_ftz_unit_copy4_y)
    );

    float_min_s2_f32ftz min_f32_ftz_unit_copy5 (
        .clk(clk), .enable(1'd1), .a(32'h47000000), .b(min_f32_ftz_unit_copy5_b),
        .y(min_f32_ftz_unit_copy5_y)
    );

    float_to_fixed_s3_f32ftz_w21_f8_unsigned to_fixed_f32_ftz_u21q8_unit (
        .clk(clk), .enable(1'd1), .a(to_fixed_f32_ftz_u21q8_unit_a), .y(to_fixed_f32_ftz_u21q8_unit_y)
    );

    float_to_fixed_s3_f32ftz_w21_f8_unsigned to_fixed_f32_ftz_u21q8_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(to_fixed_f32_ftz_u21q8_unit_copy2_a),
        .y(to_fixed_f32_ftz_u21q8_unit_copy2_y)
    );

    float_to_fixed_s3_f32ftz_w23_f8_unsigned to_fixed_f32_ftz_u23q8_unit (
        .clk(clk), .enable(1'd1), .a(to_fixed_f32_ftz_u23q8_unit_a), .y(to_fixed_f32_ftz_u23q8_unit_y)
    );

    float_to_fixed_s3_f32ftz_w23_f8_unsigned to_fixed_f32_ftz_u23q8_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(to_fixed_f32_ftz_u23q8_unit_copy2_a),
        .y(to_fixed_f32_ftz_u23q8_unit_copy2_y)
    );

    float_to_fixed_s3_f32ftz_w22_f8_signed to_fixed_f32_ftz_s22q8_unit (
        .clk(clk), .enable(1'd1), .a(to_fixed_f32_ftz_s22q8_unit_a), .y(to_fixed_f32_ftz_s22q8_unit_y)
    );

    float_to_fixed_s3_f32ftz_w24_f24_unsigned to_fixed_f32_ftz_u24q24_unit (
        .clk(clk), .enable(1'd1), .a(to_fixed_f32_ftz_u24q24_unit_a), .y(to_fixed_f32_ftz_u24q24_unit_y)
    );

    float_to_fixed_s3_f32ftz_w24_f24_unsigned to_fixed_f32_ftz_u24q24_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(to_fixed_f32_ftz_u24q24_unit_copy2_a),
        .y(to_fixed_f32_ftz_u24q24_unit_copy2_y)
    );

    stream_fifo_d96_w4_distributed queue_1 (
        .clk(clk), .rst(rst), .in_valid(kept), .in_ready(queue_1_in_ready),
        .in_data({end_d93, delay_53_from_0_out, turned_d91, sight_disc_out_d68}),
        .out_valid(out_valid), .out_ready(out_ready), .out_data(queue_1_out_data)
    );

    stream_fifo_d96_w128 queue_2 (
        .clk(clk), .rst(rst), .in_valid(kept), .in_ready(queue_2_in_ready),
        .in_data({center_x_d66, center_y_d66, ax_out_d50, bx_out_d51}),
        .out_valid(queue_2_out_valid), .out_ready(out_ready), .out_data(queue_2_out_data)
    );

    stream_fifo_d96_w128 queue_3 (
        .clk(clk), .rst(rst), .in_valid(kept), .in_ready(queue_3_in_ready),
        .in_data({ay_out_d50, by_out_d51, delta_out, mx_d51}),
        .out_valid(queue_3_out_valid), .out_ready(out_ready), .out_data(queue_3_out_data)
    );

    stream_fifo_d96_w118 queue_4 (
        .clk(clk), .rst(rst), .in_valid(kept), .in_ready(queue_4_in_ready),
        .in_data({delay_51_from_0_copy2_out, sight_near_out, sight_far_out, delay_28_from_0_out}),
        .out_valid(queue_4_out_valid), .out_ready(out_ready), .out_data(queue_4_out_data)
    );

    stream_fifo_d96_w128 queue_5 (
        .clk(clk), .rst(rst), .in_valid(kept), .in_ready(queue_5_in_ready),
        .in_data({
            delay_18_from_0_out, delay_18_from_1_out, attribute_0_d93, attribute_1_d93, attribute_2_d93,
            attribute_3_d93, attribute_4_d93
        }),
        .out_valid(queue_5_out_valid), .out_ready(out_ready), .out_data(queue_5_out_data)
    );

    stream_fifo_d96_w128 queue_6 (
        .clk(clk), .rst(rst), .in_valid(kept), .in_ready(queue_6_in_ready),
        .in_data({
            attribute_5_d93, attribute_6_d93, attribute_7_d93, attribute_8_d93, attribute_9_d93, attribute_10_d93,
            attribute_11_d93, attribute_12_d93
        }),
        .out_valid(queue_6_out_valid), .out_ready(out_ready), .out_data(queue_6_out_data)
    );

    stream_fifo_d96_w92 queue_7 (
        .clk(clk), .rst(rst), .in_valid(kept), .in_ready(queue_7_in_ready),
        .in_data({
            cardinal_0_d93, first_x_d12, last_x_d12, delay_11_from_0_out, last_y_d12, first_sum_out_d2,
            last_sum_out_d2, first_difference_out_d1, last_difference_out_d1
        }),
        .out_valid(queue_7_out_valid), .out_ready(out_ready), .out_data(queue_7_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            credits <= 8'd95;
            phases_1 <= 2'd1;
            delay_6_from_0_pointer <= 3'd0;
            delay_7_from_0_pointer <= 3'd0;
            phases_2 <= 2'd1;
            delay_8_from_0_pointer <= 3'd0;
            phases_3 <= 2'd1;
            delay_9_from_0_pointer <= 3'd0;
            phases_4 <= 2'd1;
            delay_10_from_0_pointer <= 4'd0;
            delay_11_from_0_pointer <= 4'd0;
            delay_12_from_0_pointer <= 4'd0;
            phases_5 <= 2'd1;
            delay_14_from_0_pointer <= 4'd0;
            delay_18_from_0_pointer <= 5'd0;
            phases_6 <= 2'd1;
            delay_20_from_0_pointer <= 5'd0;
            phases_7 <= 2'd1;
            delay_22_from_0_pointer <= 5'd0;
            phases_8 <= 2'd1;
            delay_23_from_0_pointer <= 5'd0;
            delay_28_from_0_pointer <= 5'd0;
            delay_29_from_0_pointer <= 5'd0;
            delay_32_from_0_pointer <= 5'd0;
            delay_36_from_0_pointer <= 6'd0;
            phases_9 <= 2'd1;
            delay_39_from_0_pointer <= 6'd0;
            phases_10 <= 2'd1;
            delay_43_from_0_pointer <= 6'd0;
            phases_11 <= 2'd1;
            delay_50_from_0_pointer <= 6'd0;
            phases_12 <= 2'd1;
            delay_51_from_0_pointer <= 6'd0;
            delay_51_from_0_copy2_pointer <= 6'd0;
            delay_53_from_0_pointer <= 6'd0;
            delay_56_from_0_pointer <= 6'd0;
            delay_63_from_0_pointer <= 6'd0;
            phases_13 <= 2'd1;
            delay_93_from_0_pointer <= 7'd0;
            phases_14 <= 2'd1;
            delay_93_from_0_copy2_pointer <= 7'd0;
            delay_93_from_0_copy3_pointer <= 7'd0;
            delay_5_from_1_pointer <= 2'd0;
            delay_6_from_1_pointer <= 3'd0;
            delay_8_from_1_pointer <= 3'd0;
            delay_9_from_1_pointer <= 3'd0;
            delay_10_from_1_pointer <= 4'd0;
            delay_11_from_1_pointer <= 4'd0;
            delay_11_from_1_copy2_pointer <= 4'd0;
            delay_12_from_1_pointer <= 4'd0;
            delay_13_from_1_pointer <= 4'd0;
            delay_14_from_1_pointer <= 4'd0;
            delay_14_from_1_copy2_pointer <= 4'd0;
            delay_16_from_1_pointer <= 4'd0;
            delay_17_from_1_pointer <= 4'd0;
            delay_18_from_1_pointer <= 5'd0;
            delay_24_from_1_pointer <= 5'd0;
            delay_25_from_1_pointer <= 5'd0;
            delay_27_from_1_pointer <= 5'd0;
            delay_30_from_1_pointer <= 5'd0;
            delay_36_from_1_pointer <= 6'd0;
            delay_37_from_1_pointer <= 6'd0;
            delay_43_from_1_pointer <= 6'd0;
            delay_50_from_1_pointer <= 6'd0;
            delay_54_from_1_pointer <= 6'd0;
            delay_60_from_1_pointer <= 6'd0;
            delay_61_from_1_pointer <= 6'd0;
            delay_85_from_1_pointer <= 7'd0;
            phases_15 <= 2'd1;
            phases_16 <= 2'd1;
            phases_17 <= 2'd1;
            phases_18 <= 2'd1;
            phases_19 <= 2'd1;
            phases_20 <= 2'd1;
            phases_21 <= 2'd1;
            phases_22 <= 2'd1;
            phases_23 <= 2'd1;
            phases_24 <= 2'd1;
            phases_25 <= 2'd1;
            phases_26 <= 2'd1;
            phases_27 <= 2'd1;
            phases_28 <= 2'd1;
            phases_29 <= 2'd1;
            phases_30 <= 2'd1;
            phases_31 <= 2'd1;
            phases_32 <= 2'd1;
            phases_33 <= 2'd1;
            phases_34 <= 2'd1;
            phases_35 <= 2'd1;
            phases_36 <= 2'd1;
            phases_37 <= 2'd1;
            max_f32_ftz_unit_phase <= 1'd0;
            max_f32_ftz_unit_copy2_phase <= 1'd0;
            max_f32_ftz_unit_copy3_phase <= 1'd0;
            max_f32_ftz_unit_copy4_phase <= 1'd0;
            max_f32_ftz_unit_copy5_phase <= 1'd0;
            max_f32_ftz_unit_copy6_phase <= 1'd0;
            max_f32_ftz_unit_copy7_phase <= 1'd0;
            max_f32_ftz_unit_copy8_phase <= 1'd0;
            add_f32_ftz_unit_phase <= 1'd0;
            add_f32_ftz_unit_copy2_phase <= 1'd0;
            add_f32_ftz_unit_copy3_phase <= 1'd0;
            add_f32_ftz_unit_copy4_phase <= 1'd0;
            add_f32_ftz_unit_copy5_phase <= 1'd0;
            add_f32_ftz_unit_copy6_phase <= 1'd0;
            add_f32_ftz_unit_copy7_phase <= 1'd0;
            add_f32_ftz_unit_copy8_phase <= 1'd0;
            add_f32_ftz_unit_copy9_phase <= 1'd0;
            add_f32_ftz_unit_copy10_phase <= 1'd0;
            add_f32_ftz_unit_copy11_phase <= 1'd0;
            add_f32_ftz_unit_copy12_phase <= 1'd0;
            add_f32_ftz_unit_copy13_phase <= 1'd0;
            add_f32_ftz_unit_copy14_phase <= 1'd0;
            add_f32_ftz_unit_copy15_phase <= 1'd0;
            add_f32_ftz_unit_copy16_phase <= 1'd0;
            add_f32_ftz_unit_copy17_phase <= 1'd0;
            recip_f32_ftz_unit_phase <= 1'd0;
            mul_f32_ftz_unit_phase <= 1'd0;
            mul_f32_ftz_unit_copy2_phase <= 1'd0;
            mul_f32_ftz_unit_copy3_phase <= 1'd0;
            mul_f32_ftz_unit_copy4_phase <= 1'd0;
            mul_f32_ftz_unit_copy5_phase <= 1'd0;
            mul_f32_ftz_unit_copy6_phase <= 1'd0;
            mul_f32_ftz_unit_copy7_phase <= 1'd0;
            mul_f32_ftz_unit_copy8_phase <= 1'd0;
            mul_f32_ftz_unit_copy9_phase <= 1'd0;
            mul_f32_ftz_unit_copy10_phase <= 1'd0;
            mul_f32_ftz_unit_copy11_phase <= 1'd0;
            mul_f32_ftz_unit_copy12_phase <= 1'd0;
            mul_f32_ftz_unit_copy13_phase <= 1'd0;
            mul_mul_add_f32_ftz_unit_phase <= 1'd0;
            mul_mul_add_f32_ftz_unit_copy2_phase <= 1'd0;
            mul_mul_add_f32_ftz_unit_copy3_phase <= 1'd0;
            mul_mul_add_f32_ftz_unit_copy4_phase <= 1'd0;
            mul_mul_add_f32_ftz_unit_copy5_phase <= 1'd0;
            mul_mul_add_f32_ftz_unit_copy6_phase <= 1'd0;
            mul_mul_add_f32_ftz_unit_copy7_phase <= 1'd0;
            mul_add_f32_ftz_unit_phase <= 1'd0;
            mul_add_f32_ftz_unit_copy2_phase <= 1'd0;
            mul_add_f32_ftz_unit_copy3_phase <= 1'd0;
            sqrt_f32_ftz_unit_phase <= 1'd0;
            sqrt_f32_ftz_unit_copy2_phase <= 1'd0;
            min_f32_ftz_unit_phase <= 1'd0;
            min_f32_ftz_unit_copy2_phase <= 1'd0;
            min_f32_ftz_unit_copy3_phase <= 1'd0;
            min_f32_ftz_unit_copy4_phase <= 1'd0;
            to_fixed_f32_ftz_u21q8_unit_copy2_phase <= 1'd0;
            to_fixed_f32_ftz_u23q8_unit_phase <= 1'd0;
            to_fixed_f32_ftz_s22q8_unit_phase <= 1'd0;
            to_fixed_f32_ftz_u24q24_unit_phase <= 1'd0;
            phases_38 <= 2'd1;
            in_flight <= 93'd0;
            left <= 1'd0;
            dropped <= 1'd0;
        end else begin
            credits <= (credits - {7'd0, in_valid_and_in_ready}) + {7'd0, left} + {7'd0, dropped};
            phases_1 <= {phases_1[0], phases_1[1]};
            phases_2 <= {phases_2[0], phases_2[1]};
            phases_3 <= {phases_3[0], phases_3[1]};
            phases_4 <= {phases_4[0], phases_4[1]};
            phases_5 <= {phases_5[0], phases_5[1]};
            phases_6 <= {phases_6[0], phases_6[1]};
            phases_7 <= {phases_7[0], phases_7[1]};
            phases_8 <= {phases_8[0], phases_8[1]};
            phases_9 <= {phases_9[0], phases_9[1]};
            phases_10 <= {phases_10[0], phases_10[1]};
            phases_11 <= {phases_11[0], phases_11[1]};
            phases_12 <= {phases_12[0], phases_12[1]};
            phases_13 <= {phases_13[0], phases_13[1]};
            phases_14 <= {phases_14[0], phases_14[1]};
            phases_15 <= {phases_15[0], phases_15[1]};
            phases_16 <= {phases_16[0], phases_16[1]};
            phases_17 <= {phases_17[0], phases_17[1]};
            phases_18 <= {phases_18[0], phases_18[1]};
            phases_19 <= {phases_19[0], phases_19[1]};
            phases_20 <= {phases_20[0], phases_20[1]};
            phases_21 <= {phases_21[0], phases_21[1]};
            phases_22 <= {phases_22[0], phases_22[1]};
            phases_23 <= {phases_23[0], phases_23[1]};
            phases_24 <= {phases_24[0], phases_24[1]};
            phases_25 <= {phases_25[0], phases_25[1]};
            phases_26 <= {phases_26[0], phases_26[1]};
            phases_27 <= {phases_27[0], phases_27[1]};
            phases_28 <= {phases_28[0], phases_28[1]};
            phases_29 <= {phases_29[0], phases_29[1]};
            phases_30 <= {phases_30[0], phases_30[1]};
            phases_31 <= {phases_31[0], phases_31[1]};
            phases_32 <= {phases_32[0], phases_32[1]};
            phases_33 <= {phases_33[0], phases_33[1]};
            phases_34 <= {phases_34[0], phases_34[1]};
            phases_35 <= {phases_35[0], phases_35[1]};
            phases_36 <= {phases_36[0], phases_36[1]};
            phases_37 <= {phases_37[0], phases_37[1]};
            max_f32_ftz_unit_phase <= max_f32_ftz_unit_phase ? (max_f32_ftz_unit_phase - 1'd1) : (max_f32_ftz_unit_phase + 1'd1);
            max_f32_ftz_unit_copy2_phase <= max_f32_ftz_unit_copy2_phase ? (max_f32_ftz_unit_copy2_phase - 1'd1) : (max_f32_ftz_unit_copy2_phase + 1'd1);
            max_f32_ftz_unit_copy3_phase <= max_f32_ftz_unit_copy3_phase ? (max_f32_ftz_unit_copy3_phase - 1'd1) : (max_f32_ftz_unit_copy3_phase + 1'd1);
            max_f32_ftz_unit_copy4_phase <= max_f32_ftz_unit_copy4_phase ? (max_f32_ftz_unit_copy4_phase - 1'd1) : (max_f32_ftz_unit_copy4_phase + 1'd1);
            max_f32_ftz_unit_copy5_phase <= max_f32_ftz_unit_copy5_phase ? (max_f32_ftz_unit_copy5_phase - 1'd1) : (max_f32_ftz_unit_copy5_phase + 1'd1);
            max_f32_ftz_unit_copy6_phase <= max_f32_ftz_unit_copy6_phase ? (max_f32_ftz_unit_copy6_phase - 1'd1) : (max_f32_ftz_unit_copy6_phase + 1'd1);
            max_f32_ftz_unit_copy7_phase <= max_f32_ftz_unit_copy7_phase ? (max_f32_ftz_unit_copy7_phase - 1'd1) : (max_f32_ftz_unit_copy7_phase + 1'd1);
            max_f32_ftz_unit_copy8_phase <= max_f32_ftz_unit_copy8_phase ? (max_f32_ftz_unit_copy8_phase - 1'd1) : (max_f32_ftz_unit_copy8_phase + 1'd1);
            add_f32_ftz_unit_phase <= add_f32_ftz_unit_phase ? (add_f32_ftz_unit_phase - 1'd1) : (add_f32_ftz_unit_phase + 1'd1);
            add_f32_ftz_unit_copy2_phase <= add_f32_ftz_unit_copy2_phase ? (add_f32_ftz_unit_copy2_phase - 1'd1) : (add_f32_ftz_unit_copy2_phase + 1'd1);
            add_f32_ftz_unit_copy3_phase <= add_f32_ftz_unit_copy3_phase ? (add_f32_ftz_unit_copy3_phase - 1'd1) : (add_f32_ftz_unit_copy3_phase + 1'd1);
            add_f32_ftz_unit_copy4_phase <= add_f32_ftz_unit_copy4_phase ? (add_f32_ftz_unit_copy4_phase - 1'd1) : (add_f32_ftz_unit_copy4_phase + 1'd1);
            add_f32_ftz_unit_copy5_phase <= add_f32_ftz_unit_copy5_phase ? (add_f32_ftz_unit_copy5_phase - 1'd1) : (add_f32_ftz_unit_copy5_phase + 1'd1);
            add_f32_ftz_unit_copy6_phase <= add_f32_ftz_unit_copy6_phase ? (add_f32_ftz_unit_copy6_phase - 1'd1) : (add_f32_ftz_unit_copy6_phase + 1'd1);
            add_f32_ftz_unit_copy7_phase <= add_f32_ftz_unit_copy7_phase ? (add_f32_ftz_unit_copy7_phase - 1'd1) : (add_f32_ftz_unit_copy7_phase + 1'd1);
            add_f32_ftz_unit_copy8_phase <= add_f32_ftz_unit_copy8_phase ? (add_f32_ftz_unit_copy8_phase - 1'd1) : (add_f32_ftz_unit_copy8_phase + 1'd1);
            add_f32_ftz_unit_copy9_phase <= add_f32_ftz_unit_copy9_phase ? (add_f32_ftz_unit_copy9_phase - 1'd1) : (add_f32_ftz_unit_copy9_phase + 1'd1);
            add_f32_ftz_unit_copy10_phase <= add_f32_ftz_unit_copy10_phase ? (add_f32_ftz_unit_copy10_phase - 1'd1) : (add_f32_ftz_unit_copy10_phase + 1'd1);
            add_f32_ftz_unit_copy11_phase <= add_f32_ftz_unit_copy11_phase ? (add_f32_ftz_unit_copy11_phase - 1'd1) : (add_f32_ftz_unit_copy11_phase + 1'd1);
            add_f32_ftz_unit_copy12_phase <= add_f32_ftz_unit_copy12_phase ? (add_f32_ftz_unit_copy12_phase - 1'd1) : (add_f32_ftz_unit_copy12_phase + 1'd1);
            add_f32_ftz_unit_copy13_phase <= add_f32_ftz_unit_copy13_phase ? (add_f32_ftz_unit_copy13_phase - 1'd1) : (add_f32_ftz_unit_copy13_phase + 1'd1);
            add_f32_ftz_unit_copy14_phase <= add_f32_ftz_unit_copy14_phase ? (add_f32_ftz_unit_copy14_phase - 1'd1) : (add_f32_ftz_unit_copy14_phase + 1'd1);
            add_f32_ftz_unit_copy15_phase <= add_f32_ftz_unit_copy15_phase ? (add_f32_ftz_unit_copy15_phase - 1'd1) : (add_f32_ftz_unit_copy15_phase + 1'd1);
            add_f32_ftz_unit_copy16_phase <= add_f32_ftz_unit_copy16_phase ? (add_f32_ftz_unit_copy16_phase - 1'd1) : (add_f32_ftz_unit_copy16_phase + 1'd1);
            add_f32_ftz_unit_copy17_phase <= add_f32_ftz_unit_copy17_phase ? (add_f32_ftz_unit_copy17_phase - 1'd1) : (add_f32_ftz_unit_copy17_phase + 1'd1);
            recip_f32_ftz_unit_phase <= recip_f32_ftz_unit_phase ? (recip_f32_ftz_unit_phase - 1'd1) : (recip_f32_ftz_unit_phase + 1'd1);
            mul_f32_ftz_unit_phase <= mul_f32_ftz_unit_phase ? (mul_f32_ftz_unit_phase - 1'd1) : (mul_f32_ftz_unit_phase + 1'd1);
            mul_f32_ftz_unit_copy2_phase <= mul_f32_ftz_unit_copy2_phase ? (mul_f32_ftz_unit_copy2_phase - 1'd1) : (mul_f32_ftz_unit_copy2_phase + 1'd1);
            mul_f32_ftz_unit_copy3_phase <= mul_f32_ftz_unit_copy3_phase ? (mul_f32_ftz_unit_copy3_phase - 1'd1) : (mul_f32_ftz_unit_copy3_phase + 1'd1);
            mul_f32_ftz_unit_copy4_phase <= mul_f32_ftz_unit_copy4_phase ? (mul_f32_ftz_unit_copy4_phase - 1'd1) : (mul_f32_ftz_unit_copy4_phase + 1'd1);
            mul_f32_ftz_unit_copy5_phase <= mul_f32_ftz_unit_copy5_phase ? (mul_f32_ftz_unit_copy5_phase - 1'd1) : (mul_f32_ftz_unit_copy5_phase + 1'd1);
            mul_f32_ftz_unit_copy6_phase <= mul_f32_ftz_unit_copy6_phase ? (mul_f32_ftz_unit_copy6_phase - 1'd1) : (mul_f32_ftz_unit_copy6_phase + 1'd1);
            mul_f32_ftz_unit_copy7_phase <= mul_f32_ftz_unit_copy7_phase ? (mul_f32_ftz_unit_copy7_phase - 1'd1) : (mul_f32_ftz_unit_copy7_phase + 1'd1);
            mul_f32_ftz_unit_copy8_phase <= mul_f32_ftz_unit_copy8_phase ? (mul_f32_ftz_unit_copy8_phase - 1'd1) : (mul_f32_ftz_unit_copy8_phase + 1'd1);
            mul_f32_ftz_unit_copy9_phase <= mul_f32_ftz_unit_copy9_phase ? (mul_f32_ftz_unit_copy9_phase - 1'd1) : (mul_f32_ftz_unit_copy9_phase + 1'd1);
            mul_f32_ftz_unit_copy10_phase <= mul_f32_ftz_unit_copy10_phase ? (mul_f32_ftz_unit_copy10_phase - 1'd1) : (mul_f32_ftz_unit_copy10_phase + 1'd1);
            mul_f32_ftz_unit_copy11_phase <= mul_f32_ftz_unit_copy11_phase ? (mul_f32_ftz_unit_copy11_phase - 1'd1) : (mul_f32_ftz_unit_copy11_phase + 1'd1);
            mul_f32_ftz_unit_copy12_phase <= mul_f32_ftz_unit_copy12_phase ? (mul_f32_ftz_unit_copy12_phase - 1'd1) : (mul_f32_ftz_unit_copy12_phase + 1'd1);
            mul_f32_ftz_unit_copy13_phase <= mul_f32_ftz_unit_copy13_phase ? (mul_f32_ftz_unit_copy13_phase - 1'd1) : (mul_f32_ftz_unit_copy13_phase + 1'd1);
            mul_mul_add_f32_ftz_unit_phase <= mul_mul_add_f32_ftz_unit_phase ? (mul_mul_add_f32_ftz_unit_phase - 1'd1) : (mul_mul_add_f32_ftz_unit_phase + 1'd1);
            mul_mul_add_f32_ftz_unit_copy2_phase <= mul_mul_add_f32_ftz_unit_copy2_phase ? (mul_mul_add_f32_ftz_unit_copy2_phase - 1'd1) : (mul_mul_add_f32_ftz_unit_copy2_phase + 1'd1);
            mul_mul_add_f32_ftz_unit_copy3_phase <= mul_mul_add_f32_ftz_unit_copy3_phase ? (mul_mul_add_f32_ftz_unit_copy3_phase - 1'd1) : (mul_mul_add_f32_ftz_unit_copy3_phase + 1'd1);
            mul_mul_add_f32_ftz_unit_copy4_phase <= mul_mul_add_f32_ftz_unit_copy4_phase ? (mul_mul_add_f32_ftz_unit_copy4_phase - 1'd1) : (mul_mul_add_f32_ftz_unit_copy4_phase + 1'd1);
            mul_mul_add_f32_ftz_unit_copy5_phase <= mul_mul_add_f32_ftz_unit_copy5_phase ? (mul_mul_add_f32_ftz_unit_copy5_phase - 1'd1) : (mul_mul_add_f32_ftz_unit_copy5_phase + 1'd1);
            mul_mul_add_f32_ftz_unit_copy6_phase <= mul_mul_add_f32_ftz_unit_copy6_phase ? (mul_mul_add_f32_ftz_unit_copy6_phase - 1'd1) : (mul_mul_add_f32_ftz_unit_copy6_phase + 1'd1);
            mul_mul_add_f32_ftz_unit_copy7_phase <= mul_mul_add_f32_ftz_unit_copy7_phase ? (mul_mul_add_f32_ftz_unit_copy7_phase - 1'd1) : (mul_mul_add_f32_ftz_unit_copy7_phase + 1'd1);
            mul_add_f32_ftz_unit_phase <= mul_add_f32_ftz_unit_phase ? (mul_add_f32_ftz_unit_phase - 1'd1) : (mul_add_f32_ftz_unit_phase + 1'd1);
            mul_add_f32_ftz_unit_copy2_phase <= mul_add_f32_ftz_unit_copy2_phase ? (mul_add_f32_ftz_unit_copy2_phase - 1'd1) : (mul_add_f32_ftz_unit_copy2_phase + 1'd1);
            mul_add_f32_ftz_unit_copy3_phase <= mul_add_f32_ftz_unit_copy3_phase ? (mul_add_f32_ftz_unit_copy3_phase - 1'd1) : (mul_add_f32_ftz_unit_copy3_phase + 1'd1);
            sqrt_f32_ftz_unit_phase <= sqrt_f32_ftz_unit_phase ? (sqrt_f32_ftz_unit_phase - 1'd1) : (sqrt_f32_ftz_unit_phase + 1'd1);
            sqrt_f32_ftz_unit_copy2_phase <= sqrt_f32_ftz_unit_copy2_phase ? (sqrt_f32_ftz_unit_copy2_phase - 1'd1) : (sqrt_f32_ftz_unit_copy2_phase + 1'd1);
            min_f32_ftz_unit_phase <= min_f32_ftz_unit_phase ? (min_f32_ftz_unit_phase - 1'd1) : (min_f32_ftz_unit_phase + 1'd1);
            min_f32_ftz_unit_copy2_phase <= min_f32_ftz_unit_copy2_phase ? (min_f32_ftz_unit_copy2_phase - 1'd1) : (min_f32_ftz_unit_copy2_phase + 1'd1);
            min_f32_ftz_unit_copy3_phase <= min_f32_ftz_unit_copy3_phase ? (min_f32_ftz_unit_copy3_phase - 1'd1) : (min_f32_ftz_unit_copy3_phase + 1'd1);
            min_f32_ftz_unit_copy4_phase <= min_f32_ftz_unit_copy4_phase ? (min_f32_ftz_unit_copy4_phase - 1'd1) : (min_f32_ftz_unit_copy4_phase + 1'd1);
            to_fixed_f32_ftz_u21q8_unit_copy2_phase <= to_fixed_f32_ftz_u21q8_unit_copy2_phase ? (to_fixed_f32_ftz_u21q8_unit_copy2_phase - 1'd1) : (to_fixed_f32_ftz_u21q8_unit_copy2_phase + 1'd1);
            to_fixed_f32_ftz_u23q8_unit_phase <= to_fixed_f32_ftz_u23q8_unit_phase ? (to_fixed_f32_ftz_u23q8_unit_phase - 1'd1) : (to_fixed_f32_ftz_u23q8_unit_phase + 1'd1);
            to_fixed_f32_ftz_s22q8_unit_phase <= to_fixed_f32_ftz_s22q8_unit_phase ? (to_fixed_f32_ftz_s22q8_unit_phase - 1'd1) : (to_fixed_f32_ftz_s22q8_unit_phase + 1'd1);
            to_fixed_f32_ftz_u24q24_unit_phase <= to_fixed_f32_ftz_u24q24_unit_phase ? (to_fixed_f32_ftz_u24q24_unit_phase - 1'd1) : (to_fixed_f32_ftz_u24q24_unit_phase + 1'd1);
            phases_38 <= {phases_38[0], phases_38[1]};
            left <= out_valid & out_ready;
            dropped <= in_flight_92_and_phases_36_0 & ~end_or_visible;
            if (phases_1[0]) begin
                delay_6_from_0_pointer <= (delay_6_from_0_pointer == 3'd4) ? (delay_6_from_0_pointer - 3'd4) : (delay_6_from_0_pointer + 3'd1);
                delay_7_from_0_pointer <= (delay_7_from_0_pointer == 3'd5) ? (delay_7_from_0_pointer - 3'd5) : (delay_7_from_0_pointer + 3'd1);
                delay_11_from_0_pointer <= (delay_11_from_0_pointer == 4'd9) ? (delay_11_from_0_pointer - 4'd9) : (delay_11_from_0_pointer + 4'd1);
                delay_12_from_0_pointer <= (delay_12_from_0_pointer == 4'd10) ? (delay_12_from_0_pointer - 4'd10) : (delay_12_from_0_pointer + 4'd1);
                delay_32_from_0_pointer <= (delay_32_from_0_pointer == 5'd30) ? (delay_32_from_0_pointer - 5'd30) : (delay_32_from_0_pointer + 5'd1);
                delay_36_from_0_pointer <= (delay_36_from_0_pointer == 6'd34) ? (delay_36_from_0_pointer - 6'd34) : (delay_36_from_0_pointer + 6'd1);
            end
            if (phases_2[0]) begin
                delay_8_from_0_pointer <= (delay_8_from_0_pointer == 3'd6) ? (delay_8_from_0_pointer - 3'd6) : (delay_8_from_0_pointer + 3'd1);
                delay_18_from_0_pointer <= (delay_18_from_0_pointer == 5'd16) ? (delay_18_from_0_pointer - 5'd16) : (delay_18_from_0_pointer + 5'd1);
                delay_28_from_0_pointer <= (delay_28_from_0_pointer == 5'd26) ? (delay_28_from_0_pointer - 5'd26) : (delay_28_from_0_pointer + 5'd1);
                delay_53_from_0_pointer <= (delay_53_from_0_pointer == 6'd51) ? (delay_53_from_0_pointer - 6'd51) : (delay_53_from_0_pointer + 6'd1);
            end
            if (phases_3[0]) begin
                delay_9_from_0_pointer <= (delay_9_from_0_pointer == 3'd7) ? (delay_9_from_0_pointer - 3'd7) : (delay_9_from_0_pointer + 3'd1);
                delay_29_from_0_pointer <= (delay_29_from_0_pointer == 5'd27) ? (delay_29_from_0_pointer - 5'd27) : (delay_29_from_0_pointer + 5'd1);
            end
            if (phases_4[0]) begin
                delay_10_from_0_pointer <= (delay_10_from_0_pointer == 4'd8) ? (delay_10_from_0_pointer - 4'd8) : (delay_10_from_0_pointer + 4'd1);
                delay_56_from_0_pointer <= (delay_56_from_0_pointer == 6'd54) ? (delay_56_from_0_pointer - 6'd54) : (delay_56_from_0_pointer + 6'd1);
                delay_63_from_0_pointer <= (delay_63_from_0_pointer == 6'd61) ? (delay_63_from_0_pointer - 6'd61) : (delay_63_from_0_pointer + 6'd1);
            end
            if (phases_5[0]) begin
                delay_14_from_0_pointer <= (delay_14_from_0_pointer == 4'd12) ? (delay_14_from_0_pointer - 4'd12) : (delay_14_from_0_pointer + 4'd1);
            end
            if (phases_6[0]) begin
                delay_20_from_0_pointer <= (delay_20_from_0_pointer == 5'd18) ? (delay_20_from_0_pointer - 5'd18) : (delay_20_from_0_pointer + 5'd1);
                delay_51_from_0_copy2_pointer <= (delay_51_from_0_copy2_pointer == 6'd49) ? (delay_51_from_0_copy2_pointer - 6'd49) : (delay_51_from_0_copy2_pointer + 6'd1);
            end
            if (phases_7[0]) begin
                delay_22_from_0_pointer <= (delay_22_from_0_pointer == 5'd20) ? (delay_22_from_0_pointer - 5'd20) : (delay_22_from_0_pointer + 5'd1);
                delay_93_from_0_copy3_pointer <= (delay_93_from_0_copy3_pointer == 7'd91) ? (delay_93_from_0_copy3_pointer - 7'd91) : (delay_93_from_0_copy3_pointer + 7'd1);
            end
            if (phases_8[0]) begin
                delay_23_from_0_pointer <= (delay_23_from_0_pointer == 5'd21) ? (delay_23_from_0_pointer - 5'd21) : (delay_23_from_0_pointer + 5'd1);
            end
            if (phases_9[0]) begin
                delay_39_from_0_pointer <= (delay_39_from_0_pointer == 6'd37) ? (delay_39_from_0_pointer - 6'd37) : (delay_39_from_0_pointer + 6'd1);
            end
            if (phases_10[0]) begin
                delay_43_from_0_pointer <= (delay_43_from_0_pointer == 6'd41) ? (delay_43_from_0_pointer - 6'd41) : (delay_43_from_0_pointer + 6'd1);
            end
            if (phases_11[0]) begin
                delay_50_from_0_pointer <= (delay_50_from_0_pointer == 6'd48) ? (delay_50_from_0_pointer - 6'd48) : (delay_50_from_0_pointer + 6'd1);
            end
            if (phases_12[0]) begin
                delay_51_from_0_pointer <= (delay_51_from_0_pointer == 6'd49) ? (delay_51_from_0_pointer - 6'd49) : (delay_51_from_0_pointer + 6'd1);
            end
            if (phases_13[0]) begin
                delay_93_from_0_pointer <= (delay_93_from_0_pointer == 7'd91) ? (delay_93_from_0_pointer - 7'd91) : (delay_93_from_0_pointer + 7'd1);
            end
            if (phases_14[0]) begin
                delay_93_from_0_copy2_pointer <= (delay_93_from_0_copy2_pointer == 7'd91) ? (delay_93_from_0_copy2_pointer - 7'd91) : (delay_93_from_0_copy2_pointer + 7'd1);
            end
            if (phases_1[1]) begin
                delay_5_from_1_pointer <= (delay_5_from_1_pointer == 2'd3) ? (delay_5_from_1_pointer - 2'd3) : (delay_5_from_1_pointer + 2'd1);
                delay_6_from_1_pointer <= (delay_6_from_1_pointer == 3'd4) ? (delay_6_from_1_pointer - 3'd4) : (delay_6_from_1_pointer + 3'd1);
                delay_8_from_1_pointer <= (delay_8_from_1_pointer == 3'd6) ? (delay_8_from_1_pointer - 3'd6) : (delay_8_from_1_pointer + 3'd1);
                delay_10_from_1_pointer <= (delay_10_from_1_pointer == 4'd8) ? (delay_10_from_1_pointer - 4'd8) : (delay_10_from_1_pointer + 4'd1);
                delay_36_from_1_pointer <= (delay_36_from_1_pointer == 6'd34) ? (delay_36_from_1_pointer - 6'd34) : (delay_36_from_1_pointer + 6'd1);
            end
            if (phases_2[1]) begin
                delay_9_from_1_pointer <= (delay_9_from_1_pointer == 3'd7) ? (delay_9_from_1_pointer - 3'd7) : (delay_9_from_1_pointer + 3'd1);
                delay_12_from_1_pointer <= (delay_12_from_1_pointer == 4'd10) ? (delay_12_from_1_pointer - 4'd10) : (delay_12_from_1_pointer + 4'd1);
                delay_18_from_1_pointer <= (delay_18_from_1_pointer == 5'd16) ? (delay_18_from_1_pointer - 5'd16) : (delay_18_from_1_pointer + 5'd1);
            end
            if (phases_3[1]) begin
                delay_11_from_1_pointer <= (delay_11_from_1_pointer == 4'd9) ? (delay_11_from_1_pointer - 4'd9) : (delay_11_from_1_pointer + 4'd1);
                delay_24_from_1_pointer <= (delay_24_from_1_pointer == 5'd22) ? (delay_24_from_1_pointer - 5'd22) : (delay_24_from_1_pointer + 5'd1);
            end
            if (phases_4[1]) begin
                delay_11_from_1_copy2_pointer <= (delay_11_from_1_copy2_pointer == 4'd9) ? (delay_11_from_1_copy2_pointer - 4'd9) : (delay_11_from_1_copy2_pointer + 4'd1);
                delay_37_from_1_pointer <= (delay_37_from_1_pointer == 6'd35) ? (delay_37_from_1_pointer - 6'd35) : (delay_37_from_1_pointer + 6'd1);
                delay_54_from_1_pointer <= (delay_54_from_1_pointer == 6'd52) ? (delay_54_from_1_pointer - 6'd52) : (delay_54_from_1_pointer + 6'd1);
            end
            if (phases_5[1]) begin
                delay_13_from_1_pointer <= (delay_13_from_1_pointer == 4'd11) ? (delay_13_from_1_pointer - 4'd11) : (delay_13_from_1_pointer + 4'd1);
                delay_14_from_1_copy2_pointer <= (delay_14_from_1_copy2_pointer == 4'd12) ? (delay_14_from_1_copy2_pointer - 4'd12) : (delay_14_from_1_copy2_pointer + 4'd1);
                delay_50_from_1_pointer <= (delay_50_from_1_pointer == 6'd48) ? (delay_50_from_1_pointer - 6'd48) : (delay_50_from_1_pointer + 6'd1);
                delay_85_from_1_pointer <= (delay_85_from_1_pointer == 7'd83) ? (delay_85_from_1_pointer - 7'd83) : (delay_85_from_1_pointer + 7'd1);
            end
            if (phases_6[1]) begin
                delay_14_from_1_pointer <= (delay_14_from_1_pointer == 4'd12) ? (delay_14_from_1_pointer - 4'd12) : (delay_14_from_1_pointer + 4'd1);
            end
            if (phases_7[1]) begin
                delay_16_from_1_pointer <= (delay_16_from_1_pointer == 4'd14) ? (delay_16_from_1_pointer - 4'd14) : (delay_16_from_1_pointer + 4'd1);
            end
            if (phases_8[1]) begin
                delay_17_from_1_pointer <= (delay_17_from_1_pointer == 4'd15) ? (delay_17_from_1_pointer - 4'd15) : (delay_17_from_1_pointer + 4'd1);
            end
            if (phases_9[1]) begin
                delay_25_from_1_pointer <= (delay_25_from_1_pointer == 5'd23) ? (delay_25_from_1_pointer - 5'd23) : (delay_25_from_1_pointer + 5'd1);
                delay_27_from_1_pointer <= (delay_27_from_1_pointer == 5'd25) ? (delay_27_from_1_pointer - 5'd25) : (delay_27_from_1_pointer + 5'd1);
            end
            if (phases_10[1]) begin
                delay_30_from_1_pointer <= (delay_30_from_1_pointer == 5'd28) ? (delay_30_from_1_pointer - 5'd28) : (delay_30_from_1_pointer + 5'd1);
                delay_43_from_1_pointer <= (delay_43_from_1_pointer == 6'd41) ? (delay_43_from_1_pointer - 6'd41) : (delay_43_from_1_pointer + 6'd1);
            end
            if (phases_11[1]) begin
                delay_60_from_1_pointer <= (delay_60_from_1_pointer == 6'd58) ? (delay_60_from_1_pointer - 6'd58) : (delay_60_from_1_pointer + 6'd1);
                delay_61_from_1_pointer <= (delay_61_from_1_pointer == 6'd59) ? (delay_61_from_1_pointer - 6'd59) : (delay_61_from_1_pointer + 6'd1);
            end
            if (phases_38[0]) in_flight <= {in_flight[91:0], in_valid_and_in_ready};
        end
    end
    always @(posedge clk) begin
        if (phases_8[0]) begin
            center_x_d1 <= in_center_x;
            lowered_chosen_bits_d3 <= lowered_chosen_bits_d2;
            lowered_chosen_bits_d1_copy4 <= {3'd0, lowered_chosen_bits_d1_copy3};
            b_x_inverted_d1 <= b_x_inverted;
            b_x_inverted_d2 <= b_x_inverted_d1;
            b_x_inverted_d3 <= b_x_inverted_d2;
            b_x_in_order_and_b_x_inverted_d1 <= b_x_in_order_and_b_x_inverted;
            b_y_inverted_d1 <= b_y_inverted;
        end
        if (phases_9[0]) begin
            center_x_d2 <= center_x_d1;
            lowered_chosen_bits_d2_copy2 <= lowered_chosen_bits_d1_copy4;
            lowered_chosen_bits_d3_copy2 <= lowered_chosen_bits_d2_copy2;
            b_y_inverted_d2 <= b_y_inverted_d1;
            b_y_inverted_d3 <= b_y_inverted_d2;
            b_y_in_order_and_b_y_inverted_d1 <= b_y_in_order_and_b_y_inverted;
            beta_inverted_d1 <= beta_inverted;
        end
        if (phases_10[0]) begin
            center_x_d3 <= center_x_d2;
            lowered_greater_d1 <= lowered_greater;
            lowered_chosen_bits_d1_copy6 <= {3'd0, lowered_chosen_bits_d1_copy5};
            beta_inverted_d2 <= beta_inverted_d1;
            beta_inverted_d3 <= beta_inverted_d2;
            beta_both_d1 <= beta_both;
            beyond_near_and_not_turned_d15 <= beyond_near_and_not_turned_d14;
            beyond_near_and_not_turned_d16 <= beyond_near_and_not_turned_d15;
            beyond_near_and_not_turned_d17 <= beyond_near_and_not_turned_d16;
        end
        if (phases_15[0]) begin
            center_y_d1 <= in_center_y;
            center_y_d2 <= center_y_d1;
            center_y_d3 <= center_y_d2;
            center_z_d1 <= in_center_z;
        end
        if (phases_16[0]) begin
            center_z_d2 <= center_z_d1;
            center_z_d3 <= center_z_d2;
            center_z_d4 <= center_z_d3;
            tangent1_x_d1 <= in_tangent1_x;
        end
        if (phases_17[0]) begin
            tangent1_x_d2 <= tangent1_x_d1;
            tangent1_x_d3 <= tangent1_x_d2;
            tangent1_y_d1 <= in_tangent1_y;
            tangent1_y_d2 <= tangent1_y_d1;
        end
        if (phases_18[0]) begin
            tangent1_y_d3 <= tangent1_y_d2;
            tangent1_z_d1 <= in_tangent1_z;
            tangent1_z_d2 <= tangent1_z_d1;
            tangent1_z_d3 <= tangent1_z_d2;
        end
        if (phases_19[0]) begin
            tangent2_x_d1 <= in_tangent2_x;
            tangent2_x_d2 <= tangent2_x_d1;
            tangent2_x_d3 <= tangent2_x_d2;
            tangent2_y_d1 <= in_tangent2_y;
        end
        if (phases_20[0]) begin
            tangent2_y_d2 <= tangent2_y_d1;
            tangent2_y_d3 <= tangent2_y_d2;
            tangent2_z_d1 <= in_tangent2_z;
            tangent2_z_d2 <= tangent2_z_d1;
        end
        if (phases_21[0]) begin
            tangent2_z_d3 <= tangent2_z_d2;
            lowered_chosen_bits_d3_copy5 <= lowered_chosen_bits_d2_copy5;
            lowered_chosen_bits_d1_copy12 <= {3'd0, lowered_chosen_bits_d1_copy11};
            lowered_chosen_bits_d2_copy6 <= lowered_chosen_bits_d1_copy12;
            lowered_chosen_bits_d3_copy6 <= lowered_chosen_bits_d2_copy6;
            lowered_greater_d1_copy5 <= lowered_greater_copy5;
            b_x_chosen_d1 <= b_x_chosen[7:0];
            b_y_chosen_d1 <= b_y_chosen[7:0];
            beta_chosen_d1 <= beta_chosen[7:0];
            unit_delta_chosen_d1 <= unit_delta_chosen[7:0];
            unit_delta_chosen_d1_copy2 <= unit_delta_chosen_copy3[7:0];
            b_y_sign_d1 <= b_y_d1[31];
        end
        if (phases_6[1]) begin
            first_x_greater_bits_d1 <= first_x_greater_bits_d1_bits;
            first_x_greater_bits_plus_1_d1 <= first_x_greater_bits_plus_1;
            turned_d3 <= turned_d2;
            turned_d4 <= turned_d3;
            turned_d5 <= turned_d4;
            lowered_chosen_bits_is_255_d1 <= lowered_chosen_bits_is_255;
            lowered_chosen_sign_d1 <= lowered_chosen_copy6[31];
            lowered_chosen_sign_d2 <= lowered_chosen_sign_d1;
        end
        if (phases_1[1]) begin
            first_x_in_order_d1 <= first_x_in_order;
            first_x_inverted_d1 <= first_x_inverted;
            first_x_greater_bits_is_255_d1 <= first_x_greater_bits_is_255;
            first_x_in_order_d1_copy2 <= first_x_in_order_copy2;
            first_x_greater_sign_d1 <= max_f32_ftz_unit_y[31];
            first_y_in_order_d1 <= first_y_in_order;
            first_y_inverted_d1 <= first_y_inverted;
        end
        if (phases_1[0]) begin
            first_x_both_d1 <= first_x_both_copy3;
            first_x_either_d1 <= first_x_either;
            first_y_both_d1 <= first_y_both_copy3;
            first_y_either_d1 <= first_y_either;
            reaches_near_both_d1 <= reaches_near_both_copy3;
        end
        if (phases_7[1]) begin
            first_x_greater_bits_d1_copy2 <= max_f32_ftz_unit_y[22:0];
            lowered_chosen_sign_d3 <= lowered_chosen_sign_d2;
            lowered_chosen_sign_d4 <= lowered_chosen_sign_d3;
            lowered_chosen_bits_is_255_d1_copy2 <= lowered_chosen_bits_is_255_copy2;
            lowered_chosen_sign_d1_copy2 <= lowered_chosen_copy7[31];
        end
        if (phases_11[1]) begin
            first_x_joined_d1 <= {first_x_greater_sign_d1, first_x_chosen_copy4};
            first_y_greater_bits_d1_copy2 <= max_f32_ftz_unit_copy2_y[22:0];
            lowered_chosen_sign_d1_copy4 <= lowered_chosen_copy9[31];
            lowered_chosen_sign_d2_copy4 <= lowered_chosen_sign_d1_copy4;
            lowered_chosen_sign_d3_copy4 <= lowered_chosen_sign_d2_copy4;
            lowered_chosen_sign_d4_copy4 <= lowered_chosen_sign_d3_copy4;
            lowered_chosen_bits_is_255_d1_copy5 <= lowered_chosen_bits_is_255_copy5;
            lowered_chosen_sign_d1_copy5 <= lowered_chosen_copy10[31];
            lowered_chosen_sign_d2_copy5 <= lowered_chosen_sign_d1_copy5;
        end
        if (phases_8[1]) begin
            first_y_greater_bits_d1 <= first_y_greater_bits_d1_bits;
            first_y_greater_bits_plus_1_d1 <= first_y_greater_bits_plus_1;
            lowered_chosen_sign_d2_copy2 <= lowered_chosen_sign_d1_copy2;
            lowered_chosen_sign_d3_copy2 <= lowered_chosen_sign_d2_copy2;
            lowered_chosen_sign_d4_copy2 <= lowered_chosen_sign_d3_copy2;
            lowered_chosen_bits_is_255_d1_copy3 <= lowered_chosen_bits_is_255_copy3;
            lowered_chosen_sign_d1_copy3 <= lowered_chosen_copy8[31];
        end
        if (phases_2[1]) begin
            first_y_greater_bits_is_255_d1 <= first_y_greater_bits_is_255;
            first_y_in_order_d1_copy2 <= first_y_in_order_copy2;
            first_y_greater_sign_d1 <= max_f32_ftz_unit_copy2_y[31];
            zero_below_reaches_near_sum_d1 <= zero_below_reaches_near_sum;
        end
        if (phases_12[1]) begin
            first_y_joined_d1 <= {first_y_greater_sign_d1, first_y_chosen_copy4};
            reaches_near_greater_bits_d1_copy2 <= max_f32_ftz_unit_copy3_y[22:0];
            reaches_near_joined_d1 <= {reaches_near_greater_sign_d1, reaches_near_chosen_copy4};
            lowered_chosen_bits_d1_copy5 <= lowered_chosen_copy8[30:23];
            lowered_greater_d1_copy2 <= lowered_greater_copy2;
            lowered_chosen_bits_d1_copy7 <= lowered_chosen_copy9[30:23];
            lowered_chosen_bits_d1_copy9 <= lowered_chosen_copy10[30:23];
            lowered_chosen_sign_d3_copy5 <= lowered_chosen_sign_d2_copy5;
            lowered_chosen_sign_d4_copy5 <= lowered_chosen_sign_d3_copy5;
            lowered_chosen_bits_is_255_d1_copy6 <= lowered_chosen_bits_is_255_copy6;
            lowered_chosen_sign_d1_copy6 <= lowered_chosen_copy11[31];
            lowered_chosen_sign_d2_copy6 <= lowered_chosen_sign_d1_copy6;
            lowered_chosen_sign_d3_copy6 <= lowered_chosen_sign_d2_copy6;
        end
        if (phases_9[1]) begin
            reaches_near_greater_bits_d1 <= reaches_near_greater_bits_d1_bits;
            reaches_near_sum_d1 <= reaches_near_sum;
        end
        if (phases_4[1]) not_reaches_near_same_d1 <= not_reaches_near_same;
        if (phases_5[1]) begin
            reaches_near_same_d1 <= reaches_near_same_copy2;
            reaches_near_in_order_d1 <= reaches_near_in_order;
            reaches_near_greater_sign_d1 <= max_f32_ftz_unit_copy3_y[31];
            turned_d1 <= turned;
            turned_d2 <= turned_d1;
        end
        if (phases_2[0]) begin
            reaches_near_either_d1 <= reaches_near_either;
            swapped_d1 <= lt_f32_ftz_unit_copy2_y;
            swapped_d2 <= swapped_d1;
            turned_either_d1 <= turned_either;
            turned_either_d2 <= turned_either_d1;
            a_x_inverted_d1 <= a_x_inverted;
        end
        if (phases_5[0]) begin
            turned_greater_d1 <= turned_greater;
            center_z_bits_plus_10_d1 <= center_z_bits_plus_10;
            a_y_inverted_d1 <= a_y_inverted;
            a_y_inverted_d2 <= a_y_inverted_d1;
            a_y_inverted_d3 <= a_y_inverted_d2;
            a_y_in_order_and_a_y_inverted_d1 <= a_y_in_order_and_a_y_inverted;
            alpha_inverted_d1 <= alpha_inverted;
        end
        if (phases_10[1]) begin
            lowered_chosen_bits_d1 <= lowered_chosen_copy6[30:23];
            lowered_chosen_bits_d1_copy3 <= lowered_chosen_copy7[30:23];
            lowered_chosen_sign_d2_copy3 <= lowered_chosen_sign_d1_copy3;
            lowered_chosen_sign_d3_copy3 <= lowered_chosen_sign_d2_copy3;
            lowered_chosen_sign_d4_copy3 <= lowered_chosen_sign_d3_copy3;
            lowered_chosen_bits_is_255_d1_copy4 <= lowered_chosen_bits_is_255_copy4;
        end
        if (phases_6[0]) begin
            lowered_chosen_bits_d1_copy2 <= {3'd0, lowered_chosen_bits_d1};
            a_y_chosen_d1 <= a_y_chosen[7:0];
            alpha_inverted_d2 <= alpha_inverted_d1;
            alpha_inverted_d3 <= alpha_inverted_d2;
        end
        if (phases_7[0]) begin
            lowered_chosen_bits_d2 <= lowered_chosen_bits_d1_copy2;
            alpha_both_d1 <= alpha_both;
            alpha_chosen_d1 <= alpha_chosen[7:0];
        end
        if (phases_11[0]) begin
            lowered_chosen_bits_d2_copy3 <= lowered_chosen_bits_d1_copy6;
            lowered_chosen_bits_d3_copy3 <= lowered_chosen_bits_d2_copy3;
            sight_disc_out_d51 <= sight_disc_out_d50;
            unit_delta_both_d1 <= unit_delta_both;
            a_x_bits_is_255_d1 <= a_x_bits_is_255;
        end
        if (phases_12[0]) begin
            lowered_chosen_bits_d1_copy8 <= {3'd0, lowered_chosen_bits_d1_copy7};
            lowered_chosen_bits_d2_copy4 <= lowered_chosen_bits_d1_copy8;
            a_x_sign_d1 <= a_x_d1[31];
            unit_delta_both_d1_copy2 <= unit_delta_both_copy2;
            a_y_bits_is_255_d1 <= a_y_bits_is_255;
            a_y_sign_d1 <= a_y_d1[31];
        end
        if (phases_13[0]) begin
            lowered_chosen_bits_d3_copy4 <= lowered_chosen_bits_d2_copy4;
            lowered_greater_d1_copy3 <= lowered_greater_copy3;
            unit_delta_both_d1_copy3 <= unit_delta_both_copy3;
            b_x_bits_is_255_d1 <= b_x_bits_is_255;
        end
        if (phases_14[0]) begin
            lowered_chosen_bits_d1_copy10 <= {3'd0, lowered_chosen_bits_d1_copy9};
            lowered_chosen_bits_d2_copy5 <= lowered_chosen_bits_d1_copy10;
            b_x_sign_d1 <= b_x_d1[31];
            unit_delta_both_d1_copy4 <= unit_delta_both_copy4;
            b_y_bits_is_255_d1 <= b_y_bits_is_255;
        end
        if (phases_13[1]) begin
            lowered_greater_d1_copy4 <= lowered_greater_copy4;
            lowered_chosen_bits_d1_copy11 <= lowered_chosen_copy11[30:23];
            lowered_chosen_bits_d1_copy13 <= lowered_chosen_copy5[30:23];
            lowered_chosen_bits_plus_60_d1 <= lowered_chosen_bits_plus_60;
            lowered_chosen_bits_plus_60_d2 <= lowered_chosen_bits_plus_60_d1;
            lowered_d1 <= lowered;
            lowered_d26 <= delay_24_from_1_out;
            lowered_d27 <= lowered_d26;
            lowered_chosen_bits_d1_copy14 <= lowered_chosen_copy6[22:0];
            lowered_chosen_bits_d2_copy7 <= lowered_chosen_bits_d1_copy14;
        end
        if (phases_3[0]) begin
            a_x_inverted_d2 <= a_x_inverted_d1;
            a_x_inverted_d3 <= a_x_inverted_d2;
        end
        if (phases_4[0]) begin
            a_x_in_order_and_a_x_inverted_d1 <= a_x_in_order_and_a_x_inverted;
            a_x_chosen_d1 <= a_x_chosen[7:0];
        end
        if (phases_14[1]) begin
            lowered_chosen_bits_d3_copy7 <= lowered_chosen_bits_d2_copy7;
            lowered_chosen_bits_d4 <= lowered_chosen_bits_d3_copy7;
            lowered_chosen_bits_d1_copy15 <= lowered_chosen_copy7[22:0];
            lowered_chosen_bits_d2_copy8 <= lowered_chosen_bits_d1_copy15;
            lowered_chosen_bits_d3_copy8 <= lowered_chosen_bits_d2_copy8;
            lowered_chosen_sign_d4_copy6 <= lowered_chosen_sign_d3_copy6;
            not_turned_d1 <= not_turned;
            zero_is_lowered_d1 <= zero_is_lowered;
            whole_d43 <= whole_d42;
            not_zero_is_a_x_bits_d1 <= not_zero_is_a_x_bits;
            not_zero_is_a_y_bits_d1 <= not_zero_is_a_y_bits;
            not_zero_is_b_x_bits_d1 <= not_zero_is_b_x_bits;
            not_zero_is_b_y_bits_d1 <= not_zero_is_b_y_bits;
            beta_bits_is_255_d1 <= beta_bits_is_255;
            alpha_bits_is_255_d1 <= alpha_bits_is_255;
            ax_out_both_d1 <= ax_out_both;
            ay_out_both_d1 <= ay_out_both;
            bx_out_both_d1 <= bx_out_both;
        end
        if (phases_15[1]) begin
            lowered_chosen_bits_d4_copy2 <= lowered_chosen_bits_d3_copy8;
            lowered_chosen_bits_d1_copy16 <= lowered_chosen_copy8[22:0];
            lowered_chosen_bits_d2_copy9 <= lowered_chosen_bits_d1_copy16;
            lowered_chosen_bits_d3_copy9 <= lowered_chosen_bits_d2_copy9;
            lowered_chosen_bits_d4_copy3 <= lowered_chosen_bits_d3_copy9;
            a_x_bits_d1 <= a_x_bits_d1_bits;
            by_out_both_d1 <= by_out_both;
            delta_both_d1 <= delta_both;
        end
        if (phases_16[1]) begin
            lowered_chosen_bits_d1_copy17 <= lowered_chosen_copy9[22:0];
            lowered_chosen_bits_d2_copy10 <= lowered_chosen_bits_d1_copy17;
            lowered_chosen_bits_d3_copy10 <= lowered_chosen_bits_d2_copy10;
            lowered_chosen_bits_d4_copy4 <= lowered_chosen_bits_d3_copy10;
            lowered_chosen_bits_d1_copy18 <= lowered_chosen_copy10[22:0];
            a_x_bits_d11 <= a_x_bits_d10;
            not_zero_is_mx_sum_bits_d1 <= not_zero_is_mx_sum_bits;
            not_zero_is_mx_sum_bits_d2 <= not_zero_is_mx_sum_bits_d1;
        end
        if (phases_17[1]) begin
            lowered_chosen_bits_d2_copy11 <= lowered_chosen_bits_d1_copy18;
            lowered_chosen_bits_d3_copy11 <= lowered_chosen_bits_d2_copy11;
            lowered_chosen_bits_d4_copy5 <= lowered_chosen_bits_d3_copy11;
            lowered_chosen_bits_d1_copy19 <= lowered_chosen_copy11[22:0];
            lowered_chosen_bits_d2_copy12 <= lowered_chosen_bits_d1_copy19;
            a_y_bits_d1 <= a_y_bits_d1_bits;
            mx_both_d1_copy3 <= mx_both_copy3;
            mx_sum_sign_d1 <= mul_mul_add_f32_ftz_unit_copy3_y[31];
        end
        if (phases_18[1]) begin
            lowered_chosen_bits_d3_copy12 <= lowered_chosen_bits_d2_copy12;
            lowered_chosen_bits_d4_copy6 <= lowered_chosen_bits_d3_copy12;
            alpha_d12 <= alpha_d11;
            beta_d12 <= beta_d11;
            a_y_bits_d11 <= a_y_bits_d10;
            mx_sum_sign_d2 <= mx_sum_sign_d1;
            mx_sum_sign_d3 <= mx_sum_sign_d2;
            not_zero_is_my_sum_bits_d1 <= not_zero_is_my_sum_bits;
            not_zero_is_my_sum_bits_d2 <= not_zero_is_my_sum_bits_d1;
            my_both_d1 <= my_both;
            my_sum_sign_d1 <= mul_mul_add_f32_ftz_unit_copy5_y[31];
            my_sum_sign_d2 <= my_sum_sign_d1;
        end
        if (phases_22[0]) begin
            r_d1 <= recip_f32_ftz_unit_y;
            r_d2 <= r_d1;
            r_d3 <= r_d2;
            r_d4 <= r_d3;
        end
        if (phases_19[1]) begin
            e_d1 <= add_f32_ftz_unit_copy2_y;
            f_chosen_d1 <= f_chosen;
            f_d1 <= recip_f32_ftz_unit_y;
            f_d2 <= f_d1;
        end
        if (phases_20[1]) begin
            f_d3 <= f_d2;
            f_d4 <= f_d3;
            spread_half_d1 <= mul_f32_ftz_unit_copy4_y;
            spread_half_d2 <= spread_half_d1;
        end
        if (phases_21[1]) begin
            spread_half_d3 <= spread_half_d2;
            a_x_d1 <= mul_f32_ftz_unit_copy6_y;
            b_x_d1 <= mul_f32_ftz_unit_copy7_y;
            center_x_minus_first_x_joined_d1 <= add_f32_ftz_unit_copy6_y;
        end
        if (phases_23[0]) begin
            one_minus_depth_a_d1 <= add_f32_ftz_unit_copy3_y;
            before_far_sum_d1 <= add_f32_ftz_unit_copy4_y;
            before_far_joined_d1 <= {mul_f32_ftz_unit_copy3_y[31], before_far_chosen};
            middle_depth_d1 <= middle_depth;
        end
        if (phases_22[1]) begin
            center_x_plus_first_x_joined_d1 <= add_f32_ftz_unit_copy7_y;
            first_x_joined_d1_copy2 <= {mul_f32_ftz_unit_copy8_y[31], first_x_chosen_copy6};
            first_x_chosen_d1 <= first_x_chosen_copy9;
            first_x_chosen_d2 <= first_x_chosen_d1;
        end
        if (phases_23[1]) begin
            last_x_chosen_d1 <= last_x_chosen_copy3;
            last_x_chosen_d2 <= last_x_chosen_d1;
            first_x_shifted_d1 <= first_x_greater_fixed_plus_126 >> 8;
            first_x_shifted_d2 <= first_x_shifted_d1;
            a_exponent_d1 <= a_exponent;
            ax_out_chosen_d1 <= ax_out_chosen[7:0];
            my_sum_sign_d3 <= my_sum_sign_d2;
        end
        if (phases_24[1]) begin
            first_x_shifted_d3 <= first_x_shifted_d2;
            last_x_lesser_d1 <= last_x_lesser;
            a_y_d1 <= mul_f32_ftz_unit_copy10_y;
            b_y_d1 <= mul_f32_ftz_unit_copy11_y;
            b_x_bits_d1 <= b_x_bits_d1_bits;
            ay_out_chosen_d1 <= ay_out_chosen[7:0];
            visible_both_d1 <= visible_both_copy3;
        end
        if (phases_24[0]) begin
            last_x_shifted_d1 <= last_x_greater_fixed_plus_130 >> 8;
            center_y_d1_copy2 <= mul_add_f32_ftz_unit_copy2_y;
            center_y_d44 <= center_y_d43;
            minus_h_y_d1 <= {~sqrt_f32_ftz_unit_copy2_y[31], sqrt_f32_ftz_unit_copy2_y[30:0]};
            unit_delta_chosen_d1_copy3 <= unit_delta_chosen_copy5[7:0];
            mx_both_d1 <= mx_both;
            mx_both_d1_copy2 <= mx_both_copy2;
        end
        if (phases_25[1]) begin
            center_y_minus_first_y_joined_d1 <= add_f32_ftz_unit_copy13_y;
            center_y_plus_first_y_joined_d1 <= add_f32_ftz_unit_copy14_y;
            first_y_joined_d1_copy2 <= {mul_f32_ftz_unit_copy12_y[31], first_y_chosen_copy6};
            last_y_chosen_d1 <= last_y_chosen_copy3;
        end
        if (phases_25[0]) begin
            first_y_chosen_d1 <= first_y_chosen_copy9;
            first_y_chosen_d2 <= first_y_chosen_d1;
            first_y_shifted_d1 <= first_y_greater_fixed_plus_126 >> 8;
            first_y_shifted_d2 <= first_y_shifted_d1;
            unit_delta_chosen_d1_copy4 <= unit_delta_chosen_copy7[7:0];
            a_exponent_plus_beta_bits_d1 <= a_exponent_plus_beta_bits;
            largest_sum_below_100_d1 <= largest_sum_below_100;
        end
        if (phases_26[1]) begin
            last_y_chosen_d2 <= last_y_chosen_d1;
            last_y_shifted_d1 <= last_y_greater_fixed_plus_130 >> 8;
            b_x_bits_d11 <= b_x_bits_d10;
            b_y_bits_d1 <= b_y_bits_d1_bits;
            b_y_bits_d11 <= b_y_bits_d10;
            b_exponent_d1 <= b_exponent;
            a_x_bits_plus_127_d1 <= a_x_bits_plus_127;
            a_y_bits_plus_127_d1 <= a_y_bits_plus_127;
            bx_out_chosen_d1 <= bx_out_chosen[7:0];
        end
        if (phases_26[0]) begin
            first_y_shifted_d3 <= first_y_shifted_d2;
            last_y_greater_d1 <= max_f32_ftz_unit_copy5_y;
            last_y_lesser_d1 <= last_y_lesser;
            a_x_bits_d1_copy2 <= a_x_d1[22:0];
            a_y_bits_d1_copy2 <= a_y_d1[22:0];
            not_zero_is_unit_delta_bits_d1 <= not_zero_is_unit_delta_bits;
            not_zero_is_unit_delta_bits_d2 <= not_zero_is_unit_delta_bits_d1;
            not_zero_is_unit_delta_bits_d3 <= not_zero_is_unit_delta_bits_d2;
            unit_delta_bits_is_255_d1 <= unit_delta_bits_is_255;
            unit_delta_sign_d1 <= mul_add_f32_ftz_unit_copy3_y[31];
            unit_delta_sign_d2 <= unit_delta_sign_d1;
        end
        if (phases_27[1]) begin
            unit_delta_joined_d1 <= {a_y_sign_d1, unit_delta_chosen_copy4};
            unit_delta_joined_d2 <= unit_delta_joined_d1;
            b_x_bits_plus_127_d1 <= b_x_bits_plus_127;
            unit_delta_joined_d1_copy2 <= {b_x_sign_d1, unit_delta_chosen_copy6};
            b_y_bits_plus_127_d1 <= b_y_bits_plus_127;
            by_out_chosen_d1 <= by_out_chosen[7:0];
        end
        if (phases_27[0]) begin
            b_x_bits_d1_copy2 <= b_x_d1[22:0];
            b_y_bits_d1_copy2 <= b_y_d1[22:0];
            unit_delta_product_d1 <= mul_f32_ftz_unit_copy8_y;
            b_exponent_plus_alpha_bits_d1 <= b_exponent_plus_alpha_bits;
            mx_sum_d1 <= mx_sum;
            mx_chosen_d1 <= mx_chosen[7:0];
            mx_sum_d1_copy2 <= mx_sum_copy2;
            mx_chosen_d1_copy2 <= mx_chosen_copy3[7:0];
            unit_delta_sign_d3 <= unit_delta_sign_d2;
        end
        if (phases_28[1]) begin
            unit_delta_joined_d2_copy2 <= unit_delta_joined_d1_copy2;
            beta_bits_d12 <= beta_bits_d11;
            alpha_bits_d12 <= alpha_bits_d11;
            m_exponent_d1 <= m_exponent;
            mx_joined_d1 <= {beta_d12[31], mx_chosen_copy2};
            largest_chosen_d1 <= largest_chosen;
            largest_chosen_d1_copy2 <= largest_chosen_copy2;
            delta_chosen_d1 <= delta_chosen[7:0];
        end
        if (phases_29[1]) begin
            mx_joined_d1_copy2 <= {alpha_d12[31], mx_chosen_copy4};
            minus_unit_delta_joined_d1 <= {~b_y_sign_d1, unit_delta_chosen_copy8};
            minus_unit_delta_joined_d2 <= minus_unit_delta_joined_d1;
            minus_unit_delta_joined_d1_copy2 <= {~a_x_sign_d1, unit_delta_chosen_copy2};
        end
        if (phases_30[1]) begin
            minus_unit_delta_joined_d2_copy2 <= minus_unit_delta_joined_d1_copy2;
            largest_greater_d1_copy3 <= largest_greater_copy3;
            a_x_bits_plus_381_d1 <= a_x_bits_plus_381;
            a_y_bits_plus_381_d1 <= a_y_bits_plus_381;
            b_x_bits_plus_381_d1 <= b_x_bits_plus_381;
            b_y_bits_plus_381_d1 <= b_y_bits_plus_381;
            delta_sum_d1 <= delta_sum;
            mx_sum_bits_d1 <= mx_sum_bits_d1_bits;
            mx_sum_bits_d2 <= mx_sum_bits_d1;
        end
        if (phases_28[0]) begin
            largest_sum_d9 <= largest_sum_d8;
            largest_sum_d10 <= largest_sum_d9;
            unit_delta_bits_d1 <= unit_delta_bits_d1_bits;
            unit_delta_bits_d2 <= unit_delta_bits_d1;
            unit_delta_bits_d3 <= unit_delta_bits_d2;
            largest_greater_d1 <= largest_greater;
            largest_sum_minus_100_d1 <= largest_sum_minus_100;
            largest_greater_d1_copy2 <= largest_greater_copy2;
            largest_sum_plus_127_d1 <= largest_sum_plus_127;
            largest_d1 <= largest;
            mx_sum_bits_is_255_d1 <= mx_sum_bits_is_255;
            my_sum_bits_is_255_d1 <= my_sum_bits_is_255;
            edge_on_lesser_d1 <= edge_on_lesser;
            unit_delta_bits_is_zero_d1 <= unit_delta_bits_is_zero;
            edge_on_in_order_d1 <= edge_on_in_order;
            doubtful_in_order_d1 <= doubtful_in_order;
            whole_and_first_sum_both_d1 <= whole_and_first_sum_both;
            whole_and_first_sum_both_d2 <= whole_and_first_sum_both_d1;
        end
        if (phases_29[0]) begin
            ax_out_joined_d1 <= {a_x_sign_d11, ax_out_chosen_copy2};
            ay_out_joined_d1 <= {a_y_sign_d11, ay_out_chosen_copy2};
            unit_delta_bits_d1_copy2 <= mul_add_f32_ftz_unit_copy3_y[22:0];
            unit_delta_bits_d2_copy2 <= unit_delta_bits_d1_copy2;
            unit_delta_product_bits_d1 <= unit_delta_product_d1[30:23];
            unit_delta_product_bits_d2 <= unit_delta_product_bits_d1;
            first_sum_up_to_last_sum_d1 <= first_sum_up_to_last_sum;
            first_sum_up_to_last_sum_d2 <= first_sum_up_to_last_sum_d1;
        end
        if (phases_30[0]) begin
            unit_delta_bits_d3_copy2 <= unit_delta_bits_d2_copy2;
            delta_d1 <= delta;
            unit_delta_product_bits_d3 <= unit_delta_product_bits_d2;
            first_sum_sum_d1 <= add_f32_ftz_unit_copy9_y;
            first_sum_sum_d2 <= first_sum_sum_d1;
            visible_in_order_d1 <= visible_in_order;
        end
        if (phases_31[1]) begin
            mx_sum_plus_mx_sum_bits_d1 <= mx_sum_plus_mx_sum_bits;
            mx_sum_bits_d1_copy2 <= mul_mul_add_f32_ftz_unit_copy3_y[22:0];
            mx_sum_bits_d2_copy2 <= mx_sum_bits_d1_copy2;
            mx_joined_d1_copy3 <= {mx_chosen_copy5[7:0], mx_sum_bits_d2_copy2};
            my_sum_bits_d1 <= my_sum_bits_d1_bits;
            my_sum_bits_d2 <= my_sum_bits_d1;
            mx_sum_plus_my_sum_bits_d1 <= mx_sum_plus_my_sum_bits;
        end
        if (phases_32[1]) begin
            my_sum_bits_d1_copy2 <= mul_mul_add_f32_ftz_unit_copy5_y[22:0];
            my_sum_bits_d2_copy2 <= my_sum_bits_d1_copy2;
            my_joined_d1 <= {my_chosen[7:0], my_sum_bits_d2_copy2};
            first_difference_sum_d1_copy2 <= first_difference_sum;
        end
        if (phases_31[0]) begin
            first_sum_sum_d3 <= first_sum_sum_d2;
            first_sum_sum_d4 <= first_sum_sum_d3;
            first_sum_sum_d1_copy2 <= add_f32_ftz_unit_copy12_y;
            first_sum_sum_d2_copy2 <= first_sum_sum_d1_copy2;
        end
        if (phases_32[0]) begin
            first_sum_sum_d1_copy3 <= first_sum_sum;
            last_sum_sum_d1 <= add_f32_ftz_unit_copy13_y;
            last_sum_sum_d2 <= last_sum_sum_d1;
            last_sum_sum_d1_copy2 <= last_sum_sum;
            first_sum_out_d1 <= first_sum[9:0];
        end
        if (phases_33[0]) begin
            first_difference_sum_d1 <= add_f32_ftz_unit_copy14_y;
            first_difference_sum_d2 <= first_difference_sum_d1;
            first_difference_lesser_d1 <= min_f32_ftz_unit_copy5_y;
            last_difference_sum_d1 <= add_f32_ftz_unit_copy15_y;
        end
        if (phases_34[0]) begin
            last_difference_sum_d2 <= last_difference_sum_d1;
            center_x_fixed_d1 <= to_fixed_f32_ftz_s22q8_unit_y;
            first_sum_shifted_d1 <= {{8{first_sum_sum_copy3[26]}}, first_sum_sum_copy3[26:8]};
            last_sum_shifted_d1 <= {{8{last_sum_sum_copy3[26]}}, last_sum_sum_copy3[26:8]};
            first_sum_out_d2 <= first_sum_out_d1;
            last_sum_out_d1 <= last_sum[9:0];
        end
        if (phases_33[1]) begin
            last_difference_chosen_d1 <= last_difference_chosen;
            last_difference_sum_d1_copy2 <= last_difference_sum;
            first_sum_difference_d1 <= first_sum_difference;
            last_sum_sum_d1_copy3 <= last_sum_sum_copy2;
        end
        if (phases_34[1]) begin
            first_sum_greater_d1 <= first_sum_greater;
            last_sum_lesser_d1 <= last_sum_lesser;
            first_difference_shifted_d1 <= {{8{first_difference_sum_copy2[26]}}, first_difference_sum_copy2[26:8]};
            last_difference_shifted_d1 <= {{8{last_difference_sum_copy3[26]}}, last_difference_sum_copy3[26:8]};
        end
        if (phases_35[0]) begin
            first_difference_difference_d1 <= first_difference_difference_copy2;
            first_difference_sum_d1_copy3 <= first_difference_sum_copy3;
            last_difference_sum_d1_copy3 <= last_difference_sum_copy2;
            last_difference_sum_d1_copy4 <= last_difference_sum_copy4;
            last_sum_out_d2 <= last_sum_out_d1;
            first_difference_out_d1 <= first_difference[9:0];
        end
        if (phases_35[1]) begin
            first_difference_greater_d1 <= first_difference_greater;
            last_difference_lesser_d1 <= last_difference_lesser;
        end
        if (phases_36[0]) begin
            last_difference_out_d1 <= last_difference[9:0];
            before_far_and_occupied_x_d1 <= before_far_and_occupied_x;
            sight_negative_out_d1 <= sight_negative_out;
            ax_out_joined_d1_copy2 <= {not_ax_out_joined_sign, ax_out_chosen_copy2};
            ay_out_joined_d1_copy2 <= {not_ay_out_joined_sign, ay_out_chosen_copy2};
            delta_times_one_over_b_depth_d1 <= mul_f32_ftz_unit_copy11_y;
        end
        if (phases_37[0]) begin
            middle_depth_minus_epsilon_d1 <= add_f32_ftz_unit_copy16_y;
            middle_depth_plus_epsilon_d1 <= add_f32_ftz_unit_copy17_y;
            depth_high_out_greater_d1 <= max_f32_ftz_unit_copy8_y;
        end
        max_f32_ftz_unit_a <= max_f32_ftz_unit_phase ? last_x_chosen_copy3 : {1'd0, in_tangent1_x[30:0]};
        max_f32_ftz_unit_b <= max_f32_ftz_unit_phase ? add_f32_ftz_unit_copy10_y : {1'd0, in_tangent2_x[30:0]};
        max_f32_ftz_unit_copy2_a <= max_f32_ftz_unit_copy2_phase ? last_y_chosen_copy3 : {1'd0, in_tangent1_y[30:0]};
        max_f32_ftz_unit_copy2_b <= max_f32_ftz_unit_copy2_phase ? add_f32_ftz_unit_copy16_y : {1'd0, in_tangent2_y[30:0]};
        max_f32_ftz_unit_copy3_a <= max_f32_ftz_unit_copy3_phase ? 32'd0 : lt_f32_ftz_unit_copy2_a_bits;
        max_f32_ftz_unit_copy3_b <= max_f32_ftz_unit_copy3_phase ? first_y_chosen_copy10 : lt_f32_ftz_unit_copy2_b_bits;
        max_f32_ftz_unit_copy4_a <= max_f32_ftz_unit_copy4_phase ? 32'd0 : 32'd0;
        max_f32_ftz_unit_copy4_b <= max_f32_ftz_unit_copy4_phase ? min_f32_ftz_unit_y : first_x_chosen_copy10;
        max_f32_ftz_unit_copy5_a <= max_f32_ftz_unit_copy5_phase ? 32'd0 : mul_f32_ftz_unit_copy10_y;
        max_f32_ftz_unit_copy5_b <= max_f32_ftz_unit_copy5_phase ? min_f32_ftz_unit_copy3_y : add_f32_ftz_unit_copy12_y;
        max_f32_ftz_unit_copy6_a <= max_f32_ftz_unit_copy6_phase ? 32'd0 : mul_f32_ftz_unit_copy10_y;
        max_f32_ftz_unit_copy6_b <= max_f32_ftz_unit_copy6_phase ? middle_depth_d1 : add_f32_ftz_unit_copy13_y;
        max_f32_ftz_unit_copy7_a <= max_f32_ftz_unit_copy7_phase ? 32'd0 : mul_f32_ftz_unit_copy10_y;
        max_f32_ftz_unit_copy7_b <= max_f32_ftz_unit_copy7_phase ? middle_depth_minus_epsilon_d1 : add_f32_ftz_unit_copy14_y;
        max_f32_ftz_unit_copy8_a <= max_f32_ftz_unit_copy8_phase ? 32'd0 : mul_f32_ftz_unit_copy10_y;
        max_f32_ftz_unit_copy8_b <= max_f32_ftz_unit_copy8_phase ? middle_depth_plus_epsilon_d1 : add_f32_ftz_unit_copy15_y;
        add_f32_ftz_unit_a <= add_f32_ftz_unit_phase ? depth_a : center_z_d3;
        add_f32_ftz_unit_b <= add_f32_ftz_unit_phase ? mul_f32_ftz_unit_copy3_y : reaches_near_joined_d1;
        add_f32_ftz_unit_copy2_a <= add_f32_ftz_unit_copy2_phase ? mul_add_f32_ftz_unit_y : 32'h3f800000;
        add_f32_ftz_unit_copy2_b <= add_f32_ftz_unit_copy2_phase ? {~spread_half_d3[31], spread_half_d3[30:0]} : add_f32_ftz_unit_copy2_b_bits;
        add_f32_ftz_unit_copy3_a <= add_f32_ftz_unit_copy3_phase ? 32'h3f800000 : center_x_d23;
        add_f32_ftz_unit_copy3_b <= add_f32_ftz_unit_copy3_phase ? {not_depth_a_sign, depth_a[30:0]} : {~mul_f32_ftz_unit_copy4_y[31], mul_f32_ftz_unit_copy4_y[30:0]};
        add_f32_ftz_unit_copy4_a <= add_f32_ftz_unit_copy4_phase ? center_z_d4 : center_x_minus_t_x_d17;
        add_f32_ftz_unit_copy4_b <= add_f32_ftz_unit_copy4_phase ? {~reaches_near_joined_d1[31], reaches_near_joined_d1[30:0]} : {~sqrt_f32_ftz_unit_y[31], sqrt_f32_ftz_unit_y[30:0]};
        add_f32_ftz_unit_copy5_a <= add_f32_ftz_unit_copy5_phase ? mul_add_f32_ftz_unit_y : sqrt_f32_ftz_unit_y;
        add_f32_ftz_unit_copy5_b <= add_f32_ftz_unit_copy5_phase ? spread_half_d3 : center_x_minus_t_x_d17;
        add_f32_ftz_unit_copy6_a <= add_f32_ftz_unit_copy6_phase ? center_y_minus_t_y_d17 : center_x_d3;
        add_f32_ftz_unit_copy6_b <= add_f32_ftz_unit_copy6_phase ? minus_h_y_d1 : {~first_x_joined_d1[31], first_x_joined_d1[30:0]};
        add_f32_ftz_unit_copy7_a <= add_f32_ftz_unit_copy7_phase ? minus_filter_radius : center_x_d3;
        add_f32_ftz_unit_copy7_b <= add_f32_ftz_unit_copy7_phase ? center_y_d44 : first_x_joined_d1;
        add_f32_ftz_unit_copy8_a <= add_f32_ftz_unit_copy8_phase ? mul_mul_add_f32_ftz_unit_y : origin_x;
        add_f32_ftz_unit_copy8_b <= add_f32_ftz_unit_copy8_phase ? mul_mul_add_f32_ftz_unit_copy2_y : first_x_joined_d1_copy2;
        add_f32_ftz_unit_copy9_a <= add_f32_ftz_unit_copy9_phase ? mul_add_f32_ftz_unit_copy3_y : center_x_d43;
        add_f32_ftz_unit_copy9_b <= add_f32_ftz_unit_copy9_phase ? mul_add_f32_ftz_unit_copy3_y : minus_filter_radius;
        add_f32_ftz_unit_copy10_a <= add_f32_ftz_unit_copy10_phase ? mul_f32_ftz_unit_copy13_y : filter_radius;
        add_f32_ftz_unit_copy10_b <= add_f32_ftz_unit_copy10_phase ? first_sum_sum_d4 : center_x_d43;
        add_f32_ftz_unit_copy11_a <= add_f32_ftz_unit_copy11_phase ? mul_f32_ftz_unit_copy13_y : center_y_d23;
        add_f32_ftz_unit_copy11_b <= add_f32_ftz_unit_copy11_phase ? {~first_sum_sum_d4[31], first_sum_sum_d4[30:0]} : minus_mul_f32_ftz_unit_copy6_y;
        add_f32_ftz_unit_copy12_a <= add_f32_ftz_unit_copy12_phase ? t_x_plus_t_y_d27 : sqrt_f32_ftz_unit_copy2_y;
        add_f32_ftz_unit_copy12_b <= add_f32_ftz_unit_copy12_phase ? sqrt_f32_ftz_unit_copy2_y : center_y_minus_t_y_d17;
        add_f32_ftz_unit_copy13_a <= add_f32_ftz_unit_copy13_phase ? sqrt_f32_ftz_unit_copy2_y : center_y_d3;
        add_f32_ftz_unit_copy13_b <= add_f32_ftz_unit_copy13_phase ? {~t_x_plus_t_y_d27[31], t_x_plus_t_y_d27[30:0]} : {~first_y_joined_d1[31], first_y_joined_d1[30:0]};
        add_f32_ftz_unit_copy14_a <= add_f32_ftz_unit_copy14_phase ? t_x_minus_t_y_d27 : center_y_d3;
        add_f32_ftz_unit_copy14_b <= add_f32_ftz_unit_copy14_phase ? sqrt_f32_ftz_unit_copy3_y : first_y_joined_d1;
        add_f32_ftz_unit_copy15_a <= add_f32_ftz_unit_copy15_phase ? sqrt_f32_ftz_unit_copy3_y : origin_y;
        add_f32_ftz_unit_copy15_b <= add_f32_ftz_unit_copy15_phase ? {~t_x_minus_t_y_d27[31], t_x_minus_t_y_d27[30:0]} : first_y_joined_d1_copy2;
        add_f32_ftz_unit_copy16_a <= add_f32_ftz_unit_copy16_phase ? middle_depth_d7 : filter_radius;
        add_f32_ftz_unit_copy16_b <= add_f32_ftz_unit_copy16_phase ? add_f32_ftz_unit_copy16_b_bits : center_y_d43;
        add_f32_ftz_unit_copy17_a <= add_f32_ftz_unit_copy17_phase ? middle_depth_d7 : mul_f32_ftz_unit_copy4_y;
        add_f32_ftz_unit_copy17_b <= add_f32_ftz_unit_copy17_phase ? mul_add_f32_ftz_unit_copy2_y : mul_f32_ftz_unit_copy6_y;
        add_f32_ftz_unit_copy18_a <= mul_f32_ftz_unit_copy4_y;
        add_f32_ftz_unit_copy18_b <= minus_mul_f32_ftz_unit_copy6_y;
        recip_f32_ftz_unit_a <= recip_f32_ftz_unit_phase ? lowered_chosen_copy5 : f_chosen_d1;
        recip_f32_ftz_unit_copy2_a <= b_depth_d8;
        mul_f32_ftz_unit_a <= mul_f32_ftz_unit_phase ? q_d20 : alpha_joined_d11;
        mul_f32_ftz_unit_b <= recip_f32_ftz_unit_y;
        mul_f32_ftz_unit_copy2_a <= mul_f32_ftz_unit_copy2_phase ? recip_f32_ftz_unit_y : beta_joined_d11;
        mul_f32_ftz_unit_copy2_b <= mul_f32_ftz_unit_copy2_phase ? sqrt_f32_ftz_unit_y : recip_f32_ftz_unit_y;
        mul_f32_ftz_unit_copy3_a <= mul_f32_ftz_unit_copy3_phase ? one_minus_depth_a_d1 : recip_f32_ftz_unit_y;
        mul_f32_ftz_unit_copy3_b <= mul_f32_ftz_unit_copy3_phase ? before_far_sum_d1 : depth_b;
        mul_f32_ftz_unit_copy4_a <= mul_f32_ftz_unit_copy4_phase ? recip_f32_ftz_unit_y : abs_b_depth_d30;
        mul_f32_ftz_unit_copy4_b <= mul_f32_ftz_unit_copy4_phase ? t_x_sum_d9 : mul_f32_ftz_unit_copy2_y;
        mul_f32_ftz_unit_copy5_a <= mul_f32_ftz_unit_copy5_phase ? recip_f32_ftz_unit_y : v_x_chosen_d14;
        mul_f32_ftz_unit_copy5_b <= mul_f32_ftz_unit_copy5_phase ? scale_x : recip_f32_ftz_unit_y;
        mul_f32_ftz_unit_copy6_a <= mul_f32_ftz_unit_copy6_phase ? recip_f32_ftz_unit_y : scale_x;
        mul_f32_ftz_unit_copy6_b <= mul_f32_ftz_unit_copy6_phase ? t_y_sum_d9 : mul_mul_add_f32_ftz_unit_copy2_y;
        mul_f32_ftz_unit_copy7_a <= mul_f32_ftz_unit_copy7_phase ? recip_f32_ftz_unit_y : scale_x;
        mul_f32_ftz_unit_copy7_b <= mul_f32_ftz_unit_copy7_phase ? scale_y : mul_mul_add_f32_ftz_unit_copy3_y;
        mul_f32_ftz_unit_copy8_a <= mul_f32_ftz_unit_copy8_phase ? {a_x_sign_d1, unit_delta_chosen_copy2} : mul_f32_ftz_unit_copy5_y;
        mul_f32_ftz_unit_copy8_b <= mul_f32_ftz_unit_copy8_phase ? {b_y_sign_d1, unit_delta_chosen_copy8} : first_x_chosen_d43;
        mul_f32_ftz_unit_copy9_a <= mul_f32_ftz_unit_copy9_phase ? f_d3 : v_y_chosen_d14;
        mul_f32_ftz_unit_copy9_b <= mul_f32_ftz_unit_copy9_phase ? first_sum_sum_d12 : recip_f32_ftz_unit_y;
        mul_f32_ftz_unit_copy10_a <= mul_f32_ftz_unit_copy10_phase ? filter_radius : scale_y;
        mul_f32_ftz_unit_copy10_b <= mul_f32_ftz_unit_copy10_phase ? 32'h3fb60000 : mul_mul_add_f32_ftz_unit_copy5_y;
        mul_f32_ftz_unit_copy11_a <= mul_f32_ftz_unit_copy11_phase ? delta_d1 : scale_y;
        mul_f32_ftz_unit_copy11_b <= mul_f32_ftz_unit_copy11_phase ? recip_f32_ftz_unit_copy2_y : mul_mul_add_f32_ftz_unit_copy6_y;
        mul_f32_ftz_unit_copy12_a <= mul_f32_ftz_unit_copy12_phase ? delta_times_one_over_b_depth_d1 : mul_f32_ftz_unit_copy7_y;
        mul_f32_ftz_unit_copy12_b <= mul_f32_ftz_unit_copy12_phase ? sight_near_out_joined : first_y_chosen_d43;
        mul_f32_ftz_unit_copy13_a <= mul_f32_ftz_unit_copy13_phase ? one_minus_depth_a_d40 : 32'h3f800008;
        mul_f32_ftz_unit_copy13_b <= mul_f32_ftz_unit_copy13_phase ? delta_times_one_over_b_depth_d1 : add_f32_ftz_unit_copy8_y;
        mul_mul_add_f32_ftz_unit_a <= mul_mul_add_f32_ftz_unit_a_choice;
        mul_mul_add_f32_ftz_unit_b <= mul_mul_add_f32_ftz_unit_a_choice;
        mul_mul_add_f32_ftz_unit_c <= mul_mul_add_f32_ftz_unit_phase ? mul_f32_ftz_unit_copy2_y : f_d4;
        mul_mul_add_f32_ftz_unit_d <= mul_mul_add_f32_ftz_unit_phase ? mul_f32_ftz_unit_copy2_y : h_x_sum_d13;
        mul_mul_add_f32_ftz_unit_copy2_a <= mul_mul_add_f32_ftz_unit_copy2_phase ? a_x_joined_d14 : mul_f32_ftz_unit_copy6_y;
        mul_mul_add_f32_ftz_unit_copy2_b <= mul_mul_add_f32_ftz_unit_copy2_phase ? r_d4 : mul_f32_ftz_unit_copy6_y;
        mul_mul_add_f32_ftz_unit_copy2_c <= mul_mul_add_f32_ftz_unit_copy2_phase ? minus_mul_f32_ftz_unit_y : f_d4;
        mul_mul_add_f32_ftz_unit_copy2_d <= mul_mul_add_f32_ftz_unit_copy2_phase ? mul_f32_ftz_unit_copy5_y : h_y_sum_d13;
        mul_mul_add_f32_ftz_unit_copy3_a <= mul_mul_add_f32_ftz_unit_copy3_phase ? b_x_joined_d14 : unit_delta_joined_d2;
        mul_mul_add_f32_ftz_unit_copy3_b <= mul_mul_add_f32_ftz_unit_copy3_phase ? r_d4 : mx_joined_d1;
        mul_mul_add_f32_ftz_unit_copy3_c <= mul_mul_add_f32_ftz_unit_copy3_phase ? minus_mul_f32_ftz_unit_copy2_y : minus_unit_delta_joined_d2;
        mul_mul_add_f32_ftz_unit_copy3_d <= mul_mul_add_f32_ftz_unit_copy3_phase ? mul_f32_ftz_unit_copy5_y : mx_joined_d1_copy2;
        mul_mul_add_f32_ftz_unit_copy4_a <= mul_mul_add_f32_ftz_unit_copy4_phase ? alpha_d11 : a_x_d1;
        mul_mul_add_f32_ftz_unit_copy4_b <= a_x_d1;
        mul_mul_add_f32_ftz_unit_copy4_c <= mul_mul_add_f32_ftz_unit_copy4_phase ? beta_d11 : b_x_d1;
        mul_mul_add_f32_ftz_unit_copy4_d <= b_x_d1;
        mul_mul_add_f32_ftz_unit_copy5_a <= mul_mul_add_f32_ftz_unit_copy5_phase ? a_y_joined_d14 : unit_delta_joined_d2_copy2;
        mul_mul_add_f32_ftz_unit_copy5_b <= mul_mul_add_f32_ftz_unit_copy5_phase ? r_d4 : mx_joined_d1_copy2;
        mul_mul_add_f32_ftz_unit_copy5_c <= mul_mul_add_f32_ftz_unit_copy5_phase ? minus_mul_f32_ftz_unit_y : minus_unit_delta_joined_d2_copy2;
        mul_mul_add_f32_ftz_unit_copy5_d <= mul_mul_add_f32_ftz_unit_copy5_phase ? mul_f32_ftz_unit_copy9_y : mx_joined_d1;
        mul_mul_add_f32_ftz_unit_copy6_a <= mul_mul_add_f32_ftz_unit_copy6_phase ? delay_14_from_1_copy2_out : a_x_d1;
        mul_mul_add_f32_ftz_unit_copy6_b <= mul_mul_add_f32_ftz_unit_copy6_phase ? r_d4 : a_y_d1;
        mul_mul_add_f32_ftz_unit_copy6_c <= mul_mul_add_f32_ftz_unit_copy6_phase ? minus_mul_f32_ftz_unit_copy2_y : b_x_d1;
        mul_mul_add_f32_ftz_unit_copy6_d <= mul_mul_add_f32_ftz_unit_copy6_phase ? mul_f32_ftz_unit_copy9_y : b_y_d1;
        mul_mul_add_f32_ftz_unit_copy7_a <= mul_mul_add_f32_ftz_unit_copy7_phase ? alpha_d11 : a_y_d1;
        mul_mul_add_f32_ftz_unit_copy7_b <= a_y_d1;
        mul_mul_add_f32_ftz_unit_copy7_c <= mul_mul_add_f32_ftz_unit_copy7_phase ? beta_d11 : b_y_d1;
        mul_mul_add_f32_ftz_unit_copy7_d <= b_y_d1;
        mul_add_f32_ftz_unit_a <= mul_add_f32_ftz_unit_phase ? scale_x : b_depth_d30;
        mul_add_f32_ftz_unit_b <= mul_add_f32_ftz_unit_phase ? mul_f32_ftz_unit_copy5_y : mul_f32_ftz_unit_y;
        mul_add_f32_ftz_unit_c <= mul_add_f32_ftz_unit_phase ? origin_x : delay_29_from_0_out;
        mul_add_f32_ftz_unit_copy2_a <= mul_add_f32_ftz_unit_copy2_phase ? scale_y : half_depth;
        mul_add_f32_ftz_unit_copy2_b <= mul_add_f32_ftz_unit_copy2_phase ? mul_f32_ftz_unit_copy9_y : epsilon_scale;
        mul_add_f32_ftz_unit_copy2_c <= mul_add_f32_ftz_unit_copy2_phase ? origin_y : epsilon_bias;
        mul_add_f32_ftz_unit_copy3_a <= mul_add_f32_ftz_unit_copy3_phase ? {~unit_delta_joined_d1[31], unit_delta_joined_d1[30:0]} : mul_f32_ftz_unit_copy4_y;
        mul_add_f32_ftz_unit_copy3_b <= mul_add_f32_ftz_unit_copy3_phase ? unit_delta_joined_d1_copy2 : mul_f32_ftz_unit_copy6_y;
        mul_add_f32_ftz_unit_copy3_c <= mul_add_f32_ftz_unit_copy3_phase ? unit_delta_product_d1 : mul_f32_ftz_unit_copy9_y;
        sqrt_f32_ftz_unit_a <= sqrt_f32_ftz_unit_phase ? mul_mul_add_f32_ftz_unit_y : q_d6;
        sqrt_f32_ftz_unit_copy2_a <= sqrt_f32_ftz_unit_copy2_phase ? mul_mul_add_f32_ftz_unit_copy2_y : add_f32_ftz_unit_copy10_y;
        sqrt_f32_ftz_unit_copy3_a <= add_f32_ftz_unit_copy11_y;
        min_f32_ftz_unit_a <= min_f32_ftz_unit_phase ? 32'h3f800000 : 32'h45fff800;
        min_f32_ftz_unit_b <= min_f32_ftz_unit_phase ? {1'd0, mul_f32_ftz_unit_copy3_y[30:0]} : last_x_chosen_copy4;
        min_f32_ftz_unit_copy2_a <= min_f32_ftz_unit_copy2_phase ? first_x_chosen_copy9 : first_y_chosen_copy9;
        min_f32_ftz_unit_copy2_b <= min_f32_ftz_unit_copy2_phase ? add_f32_ftz_unit_copy9_y : add_f32_ftz_unit_copy7_y;
        min_f32_ftz_unit_copy3_a <= min_f32_ftz_unit_copy3_phase ? 32'h47000000 : 32'h45fff800;
        min_f32_ftz_unit_copy3_b <= min_f32_ftz_unit_copy3_phase ? first_sum_chosen : last_y_chosen_copy4;
        min_f32_ftz_unit_copy4_a <= min_f32_ftz_unit_copy4_phase ? 32'h47000000 : 32'h47000000;
        min_f32_ftz_unit_copy4_b <= min_f32_ftz_unit_copy4_phase ? last_sum_chosen : last_difference_chosen_d1;
        min_f32_ftz_unit_copy5_b <= first_difference_chosen;
        to_fixed_f32_ftz_u21q8_unit_a <= max_f32_ftz_unit_copy4_y;
        to_fixed_f32_ftz_u21q8_unit_copy2_a <= to_fixed_f32_ftz_u21q8_unit_copy2_phase ? last_y_greater_d1 : max_f32_ftz_unit_copy3_y;
        to_fixed_f32_ftz_u23q8_unit_a <= to_fixed_f32_ftz_u23q8_unit_phase ? first_difference_lesser_d1 : min_f32_ftz_unit_copy3_y;
        to_fixed_f32_ftz_u23q8_unit_copy2_a <= min_f32_ftz_unit_copy4_y;
        to_fixed_f32_ftz_s22q8_unit_a <= to_fixed_f32_ftz_s22q8_unit_phase ? center_y_d1_copy2 : mul_add_f32_ftz_unit_y;
        to_fixed_f32_ftz_u24q24_unit_a <= to_fixed_f32_ftz_u24q24_unit_phase ? depth_high_out_greater_d1 : max_f32_ftz_unit_copy6_y;
        to_fixed_f32_ftz_u24q24_unit_copy2_a <= max_f32_ftz_unit_copy7_y;
    end
    always @(posedge clk) begin
        if (phases_1[0]) begin
            delay_6_from_0[delay_6_from_0_pointer] <= {middle_depth_d1, mul_mul_add_f32_ftz_unit_y};
        end
        if (phases_1[0]) delay_6_from_0_out <= delay_6_from_0[delay_6_from_0_pointer];
    end
    always @(posedge clk) begin
        if (phases_1[0]) begin
            delay_7_from_0[delay_7_from_0_pointer] <= {sight_disc_out_d61, lt_f32_ftz_unit_y};
        end
        if (phases_1[0]) delay_7_from_0_out <= delay_7_from_0[delay_7_from_0_pointer];
    end
    always @(posedge clk) begin
        if (phases_2[0]) begin
            delay_8_from_0[delay_8_from_0_pointer] <= {largest_greater_plus_154, largest_sum, delay_29_from_0_out};
        end
        if (phases_2[0]) delay_8_from_0_out <= delay_8_from_0[delay_8_from_0_pointer];
    end
    always @(posedge clk) begin
        if (phases_3[0]) begin
            delay_9_from_0[delay_9_from_0_pointer] <= {
                mx_sum_copy3, largest_sum_copy3, mul_mul_add_f32_ftz_unit_copy7_y, mul_mul_add_f32_ftz_unit_copy4_y
            };
        end
        if (phases_3[0]) delay_9_from_0_out <= delay_9_from_0[delay_9_from_0_pointer];
    end
    always @(posedge clk) begin
        if (phases_4[0]) begin
            delay_10_from_0[delay_10_from_0_pointer] <= {
                b_y_sign_d1, b_y_bits_d1_copy2, b_y_bits_is_255_d1, b_x_sign_d1, b_x_bits_d1_copy2,
                b_x_bits_is_255_d1, a_y_sign_d1, a_y_bits_d1_copy2, a_y_bits_is_255_d1, a_x_sign_d1,
                a_x_bits_d1_copy2, a_x_bits_is_255_d1, sight_disc_out_d51
            };
        end
        if (phases_4[0]) delay_10_from_0_out <= delay_10_from_0[delay_10_from_0_pointer];
    end
    always @(posedge clk) begin
        if (phases_1[0]) delay_11_from_0[delay_11_from_0_pointer] <= first_y;
        if (phases_1[0]) delay_11_from_0_out <= delay_11_from_0[delay_11_from_0_pointer];
    end
    always @(posedge clk) begin
        if (phases_1[0]) begin
            delay_12_from_0[delay_12_from_0_pointer] <= {last_x, first_x, le_f32_ftz_unit_copy3_y};
        end
        if (phases_1[0]) delay_12_from_0_out <= delay_12_from_0[delay_12_from_0_pointer];
    end
    always @(posedge clk) begin
        if (phases_5[0]) begin
            delay_14_from_0[delay_14_from_0_pointer] <= {q_d6, beyond_near_and_not_turned, v_y_chosen_copy2, v_x_chosen_copy2};
        end
        if (phases_5[0]) delay_14_from_0_out <= delay_14_from_0[delay_14_from_0_pointer];
    end
    always @(posedge clk) begin
        if (phases_2[0]) begin
            delay_18_from_0[delay_18_from_0_pointer] <= to_fixed_f32_ftz_u24q24_unit_copy2_y;
        end
        if (phases_2[0]) delay_18_from_0_out <= delay_18_from_0[delay_18_from_0_pointer];
    end
    always @(posedge clk) begin
        if (phases_6[0]) delay_20_from_0[delay_20_from_0_pointer] <= {center_y_d23, center_x_d23};
        if (phases_6[0]) delay_20_from_0_out <= delay_20_from_0[delay_20_from_0_pointer];
    end
    always @(posedge clk) begin
        if (phases_7[0]) begin
            delay_22_from_0[delay_22_from_0_pointer] <= {center_y_d44, center_y_d1_copy2};
        end
        if (phases_7[0]) delay_22_from_0_out <= delay_22_from_0[delay_22_from_0_pointer];
    end
    always @(posedge clk) begin
        if (phases_8[0]) begin
            delay_23_from_0[delay_23_from_0_pointer] <= {center_x_d43, mul_add_f32_ftz_unit_y};
        end
        if (phases_8[0]) delay_23_from_0_out <= delay_23_from_0[delay_23_from_0_pointer];
    end
    always @(posedge clk) begin
        if (phases_2[0]) begin
            delay_28_from_0[delay_28_from_0_pointer] <= to_fixed_f32_ftz_u24q24_unit_y;
        end
        if (phases_2[0]) delay_28_from_0_out <= delay_28_from_0[delay_28_from_0_pointer];
    end
    always @(posedge clk) begin
        if (phases_3[0]) delay_29_from_0[delay_29_from_0_pointer] <= add_f32_ftz_unit_y;
        if (phases_3[0]) delay_29_from_0_out <= delay_29_from_0[delay_29_from_0_pointer];
    end
    always @(posedge clk) begin
        if (phases_1[0]) begin
            delay_32_from_0[delay_32_from_0_pointer] <= {all_before_far, beyond_near};
        end
        if (phases_1[0]) delay_32_from_0_out <= delay_32_from_0[delay_32_from_0_pointer];
    end
    always @(posedge clk) begin
        if (phases_1[0]) begin
            delay_36_from_0[delay_36_from_0_pointer] <= beyond_near_and_not_turned_d17;
        end
        if (phases_1[0]) delay_36_from_0_out <= delay_36_from_0[delay_36_from_0_pointer];
    end
    always @(posedge clk) begin
        if (phases_9[0]) begin
            delay_39_from_0[delay_39_from_0_pointer] <= {one_minus_depth_a_d1, half_depth_chosen};
        end
        if (phases_9[0]) delay_39_from_0_out <= delay_39_from_0[delay_39_from_0_pointer];
    end
    always @(posedge clk) begin
        if (phases_10[0]) begin
            delay_43_from_0[delay_43_from_0_pointer] <= {mul_f32_ftz_unit_copy13_y[30:0], mul_f32_ftz_unit_copy12_y[30:0]};
        end
        if (phases_10[0]) delay_43_from_0_out <= delay_43_from_0[delay_43_from_0_pointer];
    end
    always @(posedge clk) begin
        if (phases_11[0]) begin
            delay_50_from_0[delay_50_from_0_pointer] <= {ay_out, ax_out, delta_d1, sight_disc_out};
        end
        if (phases_11[0]) delay_50_from_0_out <= delay_50_from_0[delay_50_from_0_pointer];
    end
    always @(posedge clk) begin
        if (phases_12[0]) begin
            delay_51_from_0[delay_51_from_0_pointer] <= {mx, b_y_sign_d11, by_out_chosen_copy2, b_x_sign_d11, bx_out_chosen_copy2};
        end
        if (phases_12[0]) delay_51_from_0_out <= delay_51_from_0[delay_51_from_0_pointer];
    end
    always @(posedge clk) begin
        if (phases_6[0]) delay_51_from_0_copy2[delay_51_from_0_copy2_pointer] <= my;
        if (phases_6[0]) begin
            delay_51_from_0_copy2_out <= delay_51_from_0_copy2[delay_51_from_0_copy2_pointer];
        end
    end
    always @(posedge clk) begin
        if (phases_2[0]) delay_53_from_0[delay_53_from_0_pointer] <= sight_negative_out_d1;
        if (phases_2[0]) delay_53_from_0_out <= delay_53_from_0[delay_53_from_0_pointer];
    end
    always @(posedge clk) begin
        if (phases_4[0]) delay_56_from_0[delay_56_from_0_pointer] <= before_far;
        if (phases_4[0]) delay_56_from_0_out <= delay_56_from_0[delay_56_from_0_pointer];
    end
    always @(posedge clk) begin
        if (phases_4[0]) delay_63_from_0[delay_63_from_0_pointer] <= first_sum_both;
        if (phases_4[0]) delay_63_from_0_out <= delay_63_from_0[delay_63_from_0_pointer];
    end
    always @(posedge clk) begin
        if (phases_1[1]) begin
            delay_5_from_1[delay_5_from_1_pointer] <= {spread_half_d3, mul_add_f32_ftz_unit_y};
        end
        if (phases_1[1]) delay_5_from_1_out <= delay_5_from_1[delay_5_from_1_pointer];
    end
    always @(posedge clk) begin
        if (phases_1[1]) delay_6_from_1[delay_6_from_1_pointer] <= not_turned_d18;
        if (phases_1[1]) delay_6_from_1_out <= delay_6_from_1[delay_6_from_1_pointer];
    end
    always @(posedge clk) begin
        if (phases_1[1]) begin
            delay_8_from_1[delay_8_from_1_pointer] <= {edge_on_lesser_below_32, mul_f32_ftz_unit_copy3_y};
        end
        if (phases_1[1]) delay_8_from_1_out <= delay_8_from_1[delay_8_from_1_pointer];
    end
    always @(posedge clk) begin
        if (phases_2[1]) begin
            delay_9_from_1[delay_9_from_1_pointer] <= {b_y_bits_d1, b_x_bits_d1, a_y_bits_d1, a_x_bits_d1};
        end
        if (phases_2[1]) delay_9_from_1_out <= delay_9_from_1[delay_9_from_1_pointer];
    end
    always @(posedge clk) begin
        if (phases_1[1]) begin
            delay_10_from_1[delay_10_from_1_pointer] <= {not_zero_is_b_y_bits_d1, not_zero_is_b_x_bits_d1, not_zero_is_a_y_bits_d1, not_zero_is_a_x_bits_d1};
        end
        if (phases_1[1]) delay_10_from_1_out <= delay_10_from_1[delay_10_from_1_pointer];
    end
    always @(posedge clk) begin
        if (phases_3[1]) begin
            delay_11_from_1[delay_11_from_1_pointer] <= {
                visible_both_copy2, 3'd0, mul_f32_ftz_unit_copy2_y[30:23], mul_f32_ftz_unit_y,
                lowered_chosen_sign_d4_copy6, beta_chosen_copy2, lowered_chosen_sign_d4_copy3, alpha_chosen_copy2
            };
        end
        if (phases_3[1]) delay_11_from_1_out <= delay_11_from_1[delay_11_from_1_pointer];
    end
    always @(posedge clk) begin
        if (phases_4[1]) begin
            delay_11_from_1_copy2[delay_11_from_1_copy2_pointer] <= {3'd0, mul_f32_ftz_unit_y[30:23], b_depth_d19, b_depth_d8, mul_f32_ftz_unit_copy2_y};
        end
        if (phases_4[1]) begin
            delay_11_from_1_copy2_out <= delay_11_from_1_copy2[delay_11_from_1_copy2_pointer];
        end
    end
    always @(posedge clk) begin
        if (phases_2[1]) begin
            delay_12_from_1[delay_12_from_1_pointer] <= {mul_mul_add_f32_ftz_unit_copy6_y, not_zero_is_alpha_bits, not_zero_is_beta_bits, last_y, whole_d30};
        end
        if (phases_2[1]) delay_12_from_1_out <= delay_12_from_1[delay_12_from_1_pointer];
    end
    always @(posedge clk) begin
        if (phases_5[1]) begin
            delay_13_from_1[delay_13_from_1_pointer] <= {mul_mul_add_f32_ftz_unit_copy7_y, mul_mul_add_f32_ftz_unit_copy4_y};
        end
        if (phases_5[1]) delay_13_from_1_out <= delay_13_from_1[delay_13_from_1_pointer];
    end
    always @(posedge clk) begin
        if (phases_6[1]) begin
            delay_14_from_1[delay_14_from_1_pointer] <= {
                lowered_chosen_sign_d4_copy4, b_x_chosen_copy2, lowered_chosen_sign_d4_copy2, a_y_chosen_copy2,
                lowered_chosen_sign_d4, a_x_chosen_copy2
            };
        end
        if (phases_6[1]) delay_14_from_1_out <= delay_14_from_1[delay_14_from_1_pointer];
    end
    always @(posedge clk) begin
        if (phases_5[1]) begin
            delay_14_from_1_copy2[delay_14_from_1_copy2_pointer] <= {lowered_chosen_sign_d4_copy5, b_y_chosen_copy2};
        end
        if (phases_5[1]) begin
            delay_14_from_1_copy2_out <= delay_14_from_1_copy2[delay_14_from_1_copy2_pointer];
        end
    end
    always @(posedge clk) begin
        if (phases_7[1]) begin
            delay_16_from_1[delay_16_from_1_pointer] <= {last_y_chosen_copy2, last_x_chosen_copy2, first_x_chosen_copy8, whole_d43};
        end
        if (phases_7[1]) delay_16_from_1_out <= delay_16_from_1[delay_16_from_1_pointer];
    end
    always @(posedge clk) begin
        if (phases_8[1]) begin
            delay_17_from_1[delay_17_from_1_pointer] <= {first_y_chosen_copy8, add_f32_ftz_unit_copy11_y, add_f32_ftz_unit_copy3_y, not_turned_d1};
        end
        if (phases_8[1]) delay_17_from_1_out <= delay_17_from_1[delay_17_from_1_pointer];
    end
    always @(posedge clk) begin
        if (phases_2[1]) begin
            delay_18_from_1[delay_18_from_1_pointer] <= to_fixed_f32_ftz_u24q24_unit_y;
        end
        if (phases_2[1]) delay_18_from_1_out <= delay_18_from_1[delay_18_from_1_pointer];
    end
    always @(posedge clk) begin
        if (phases_3[1]) delay_24_from_1[delay_24_from_1_pointer] <= lowered_d1;
        if (phases_3[1]) delay_24_from_1_out <= delay_24_from_1[delay_24_from_1_pointer];
    end
    always @(posedge clk) begin
        if (phases_9[1]) delay_25_from_1[delay_25_from_1_pointer] <= add_f32_ftz_unit_y;
        if (phases_9[1]) delay_25_from_1_out <= delay_25_from_1[delay_25_from_1_pointer];
    end
    always @(posedge clk) begin
        if (phases_9[1]) begin
            delay_27_from_1[delay_27_from_1_pointer] <= {add_f32_ftz_unit_copy18_y, add_f32_ftz_unit_copy17_y};
        end
        if (phases_9[1]) delay_27_from_1_out <= delay_27_from_1[delay_27_from_1_pointer];
    end
    always @(posedge clk) begin
        if (phases_10[1]) begin
            delay_30_from_1[delay_30_from_1_pointer] <= {1'd0, mul_f32_ftz_unit_copy3_y[30:0], whole};
        end
        if (phases_10[1]) delay_30_from_1_out <= delay_30_from_1[delay_30_from_1_pointer];
    end
    always @(posedge clk) begin
        if (phases_1[1]) delay_36_from_1[delay_36_from_1_pointer] <= turned_d5;
        if (phases_1[1]) delay_36_from_1_out <= delay_36_from_1[delay_36_from_1_pointer];
    end
    always @(posedge clk) begin
        if (phases_4[1]) begin
            delay_37_from_1[delay_37_from_1_pointer] <= {visible_unequal_copy2, turned_and_lowered_chosen_sign};
        end
        if (phases_4[1]) delay_37_from_1_out <= delay_37_from_1[delay_37_from_1_pointer];
    end
    always @(posedge clk) begin
        if (phases_10[1]) begin
            delay_43_from_1[delay_43_from_1_pointer] <= {first_y_chosen_copy5, first_x_chosen_copy5};
        end
        if (phases_10[1]) delay_43_from_1_out <= delay_43_from_1[delay_43_from_1_pointer];
    end
    always @(posedge clk) begin
        if (phases_5[1]) begin
            delay_50_from_1[delay_50_from_1_pointer] <= {last_y_chosen, first_y_chosen_copy7, last_x_chosen, first_x_chosen_copy7, delay_36_from_1_out};
        end
        if (phases_5[1]) delay_50_from_1_out <= delay_50_from_1[delay_50_from_1_pointer];
    end
    always @(posedge clk) begin
        if (phases_4[1]) begin
            delay_54_from_1[delay_54_from_1_pointer] <= {doubtful_or_visible_unequal, edge_on};
        end
        if (phases_4[1]) delay_54_from_1_out <= delay_54_from_1[delay_54_from_1_pointer];
    end
    always @(posedge clk) begin
        if (phases_11[1]) delay_60_from_1[delay_60_from_1_pointer] <= first_sum_sum_copy2;
        if (phases_11[1]) delay_60_from_1_out <= delay_60_from_1[delay_60_from_1_pointer];
    end
    always @(posedge clk) begin
        if (phases_11[1]) delay_61_from_1[delay_61_from_1_pointer] <= first_difference_difference;
        if (phases_11[1]) delay_61_from_1_out <= delay_61_from_1[delay_61_from_1_pointer];
    end

    wire _unused = &{
        1'b0, a_x_chosen[10:8], a_y_chosen[10:8], alpha_chosen[10:8], alpha_d12[30:23], ax_out_chosen[10:8],
        ay_out_chosen[10:8], b_x_chosen[10:8], b_y_chosen[10:8], beta_chosen[10:8], beta_d12[30:23],
        bx_out_chosen[10:8], by_out_chosen[10:8], delta_chosen[10:8], first_difference_sum_copy2[7:0],
        first_sum_sum_copy3[7:0], first_x_chosen_copy2[10:8], first_y_chosen_copy2[10:8],
        last_difference_sum_copy3[7:0], last_sum_sum_copy3[7:0], last_x_lesser_minus_1[21:9],
        last_y_lesser_minus_1[21:9], mx_chosen[10:8], mx_chosen_copy3[10:8], mx_chosen_copy5[10:8],
        my_chosen[10:8], queue_1_in_ready, queue_2_in_ready, queue_2_out_valid, queue_3_in_ready,
        queue_3_out_valid, queue_4_in_ready, queue_4_out_valid, queue_5_in_ready, queue_5_out_valid,
        queue_6_in_ready, queue_6_out_valid, queue_7_in_ready, queue_7_out_valid,
        reaches_near_chosen_copy2[10:8], unit_delta_chosen[10:8], unit_delta_chosen_copy3[10:8],
        unit_delta_chosen_copy5[10:8], unit_delta_chosen_copy7[10:8]
    };

`ifdef RTL_ASSERT
    reg to_fixed_f32_ftz_u21q8_unit_phase, to_fixed_f32_ftz_u23q8_unit_copy2_phase;

    wire check_both = (phases_2 == phases_1) & (phases_3 == phases_1) & (phases_4 == phases_1);
    wire check_both_2 = check_both & (phases_5 == phases_1) & (phases_6 == phases_1) & (phases_7 == phases_1);
    wire check_both_3 = check_both_2 & (phases_8 == phases_1) & (phases_9 == phases_1) & (phases_10 == phases_1);
    wire check_both_4 = check_both_3 & (phases_11 == phases_1) & (phases_12 == phases_1) & (phases_13 == phases_1);
    wire check_both_5 = check_both_4 & (phases_14 == phases_1) & (phases_15 == phases_1) & (phases_16 == phases_1);
    wire check_both_6 = check_both_5 & (phases_17 == phases_1) & (phases_18 == phases_1) & (phases_19 == phases_1);
    wire check_both_7 = check_both_6 & (phases_20 == phases_1) & (phases_21 == phases_1) & (phases_22 == phases_1);
    wire check_both_8 = check_both_7 & (phases_23 == phases_1) & (phases_24 == phases_1) & (phases_25 == phases_1);
    wire check_both_9 = check_both_8 & (phases_26 == phases_1) & (phases_27 == phases_1) & (phases_28 == phases_1);
    wire check_both_10 = check_both_9 & (phases_29 == phases_1) & (phases_30 == phases_1) & (phases_31 == phases_1);
    wire check_both_11 = check_both_10 & (phases_32 == phases_1) & (phases_33 == phases_1);
    wire check_both_12 = check_both_11 & (phases_34 == phases_1) & (phases_35 == phases_1);
    wire check_both_13 = check_both_12 & (phases_36 == phases_1) & (phases_37 == phases_1);
    wire check_both_14 = check_both_13 & (~max_f32_ftz_unit_phase == phases_1[0]) & (~max_f32_ftz_unit_copy2_phase == phases_1[0]);
    wire check_both_15 = check_both_14 & (~max_f32_ftz_unit_copy3_phase == phases_1[0]) & (~max_f32_ftz_unit_copy4_phase == phases_1[0]);
    wire check_both_16 = check_both_15 & (~max_f32_ftz_unit_copy5_phase == phases_1[0]) & (~max_f32_ftz_unit_copy6_phase == phases_1[0]);
    wire check_both_17 = check_both_16 & (~max_f32_ftz_unit_copy7_phase == phases_1[0]) & (~max_f32_ftz_unit_copy8_phase == phases_1[0]);
    wire check_both_18 = check_both_17 & (~add_f32_ftz_unit_phase == phases_1[0]) & (~add_f32_ftz_unit_copy2_phase == phases_1[0]);
    wire check_both_19 = check_both_18 & (~add_f32_ftz_unit_copy3_phase == phases_1[0]) & (~add_f32_ftz_unit_copy4_phase == phases_1[0]);
    wire check_both_20 = check_both_19 & (~add_f32_ftz_unit_copy5_phase == phases_1[0]) & (~add_f32_ftz_unit_copy6_phase == phases_1[0]);
    wire check_both_21 = check_both_20 & (~add_f32_ftz_unit_copy7_phase == phases_1[0]) & (~add_f32_ftz_unit_copy8_phase == phases_1[0]);
    wire check_both_22 = check_both_21 & (~add_f32_ftz_unit_copy9_phase == phases_1[0]) & (~add_f32_ftz_unit_copy10_phase == phases_1[0]);
    wire check_both_23 = check_both_22 & (~add_f32_ftz_unit_copy11_phase == phases_1[0]) & (~add_f32_ftz_unit_copy12_phase == phases_1[0]);
    wire check_both_24 = check_both_23 & (~add_f32_ftz_unit_copy13_phase == phases_1[0]) & (~add_f32_ftz_unit_copy14_phase == phases_1[0]);
    wire check_both_25 = check_both_24 & (~add_f32_ftz_unit_copy15_phase == phases_1[0]) & (~add_f32_ftz_unit_copy16_phase == phases_1[0]);
    wire check_both_26 = check_both_25 & (~add_f32_ftz_unit_copy17_phase == phases_1[0]) & (~recip_f32_ftz_unit_phase == phases_1[0]);
    wire check_both_27 = check_both_26 & (~mul_f32_ftz_unit_phase == phases_1[0]) & (~mul_f32_ftz_unit_copy2_phase == phases_1[0]);
    wire check_both_28 = check_both_27 & (~mul_f32_ftz_unit_copy3_phase == phases_1[0]) & (~mul_f32_ftz_unit_copy4_phase == phases_1[0]);
    wire check_both_29 = check_both_28 & (~mul_f32_ftz_unit_copy5_phase == phases_1[0]) & (~mul_f32_ftz_unit_copy6_phase == phases_1[0]);
    wire check_both_30 = check_both_29 & (~mul_f32_ftz_unit_copy7_phase == phases_1[0]) & (~mul_f32_ftz_unit_copy8_phase == phases_1[0]);
    wire check_both_31 = check_both_30 & (~mul_f32_ftz_unit_copy9_phase == phases_1[0]) & (~mul_f32_ftz_unit_copy10_phase == phases_1[0]);
    wire check_both_32 = check_both_31 & (~mul_f32_ftz_unit_copy11_phase == phases_1[0]) & (~mul_f32_ftz_unit_copy12_phase == phases_1[0]);
    wire check_both_33 = check_both_32 & (~mul_f32_ftz_unit_copy13_phase == phases_1[0]) & (~mul_mul_add_f32_ftz_unit_phase == phases_1[0]);
    wire check_both_34 = check_both_33 & (~mul_mul_add_f32_ftz_unit_copy2_phase == phases_1[0]);
    wire check_both_35 = check_both_34 & (~mul_mul_add_f32_ftz_unit_copy3_phase == phases_1[0]);
    wire check_both_36 = check_both_35 & (~mul_mul_add_f32_ftz_unit_copy4_phase == phases_1[0]);
    wire check_both_37 = check_both_36 & (~mul_mul_add_f32_ftz_unit_copy5_phase == phases_1[0]);
    wire check_both_38 = check_both_37 & (~mul_mul_add_f32_ftz_unit_copy6_phase == phases_1[0]);
    wire check_both_39 = check_both_38 & (~mul_mul_add_f32_ftz_unit_copy7_phase == phases_1[0]);
    wire check_both_40 = check_both_39 & (~mul_add_f32_ftz_unit_phase == phases_1[0]) & (~mul_add_f32_ftz_unit_copy2_phase == phases_1[0]);
    wire check_both_41 = check_both_40 & (~mul_add_f32_ftz_unit_copy3_phase == phases_1[0]);
    wire check_both_42 = check_both_41 & (~sqrt_f32_ftz_unit_phase == phases_1[0]) & (~sqrt_f32_ftz_unit_copy2_phase == phases_1[0]);
    wire check_both_43 = check_both_42 & (~min_f32_ftz_unit_phase == phases_1[0]) & (~min_f32_ftz_unit_copy2_phase == phases_1[0]);
    wire check_both_44 = check_both_43 & (~min_f32_ftz_unit_copy3_phase == phases_1[0]) & (~min_f32_ftz_unit_copy4_phase == phases_1[0]);
    wire check_both_45 = check_both_44 & (~to_fixed_f32_ftz_u21q8_unit_phase == phases_1[0]);
    wire check_both_46 = check_both_45 & (~to_fixed_f32_ftz_u21q8_unit_copy2_phase == phases_1[0]);
    wire check_both_47 = check_both_46 & (~to_fixed_f32_ftz_u23q8_unit_phase == phases_1[0]);
    wire check_both_48 = check_both_47 & (~to_fixed_f32_ftz_u23q8_unit_copy2_phase == phases_1[0]);
    wire check_both_49 = check_both_48 & (~to_fixed_f32_ftz_s22q8_unit_phase == phases_1[0]);
    wire check_both_50 = check_both_49 & (~to_fixed_f32_ftz_u24q24_unit_phase == phases_1[0]);

    always @(posedge clk) begin
        if (rst) begin
            to_fixed_f32_ftz_u21q8_unit_phase <= 1'd0;
            to_fixed_f32_ftz_u23q8_unit_copy2_phase <= 1'd0;
        end else begin
            to_fixed_f32_ftz_u21q8_unit_phase <= to_fixed_f32_ftz_u21q8_unit_phase ? (to_fixed_f32_ftz_u21q8_unit_phase - 1'd1) : (to_fixed_f32_ftz_u21q8_unit_phase + 1'd1);
            to_fixed_f32_ftz_u23q8_unit_copy2_phase <= to_fixed_f32_ftz_u23q8_unit_copy2_phase ? (to_fixed_f32_ftz_u23q8_unit_copy2_phase - 1'd1) : (to_fixed_f32_ftz_u23q8_unit_copy2_phase + 1'd1);
        end
    end

    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        queue_1_has_a_place_for_each_result: assert (~kept | queue_1_in_ready);
        queue_2_has_a_place_for_each_result: assert (~kept | queue_2_in_ready);
        queue_3_has_a_place_for_each_result: assert (~kept | queue_3_in_ready);
        queue_4_has_a_place_for_each_result: assert (~kept | queue_4_in_ready);
        queue_5_has_a_place_for_each_result: assert (~kept | queue_5_in_ready);
        queue_6_has_a_place_for_each_result: assert (~kept | queue_6_in_ready);
        queue_7_has_a_place_for_each_result: assert (~kept | queue_7_in_ready);
        queue_2_in_step: assert (queue_2_out_valid == out_valid);
        queue_3_in_step: assert (queue_3_out_valid == out_valid);
        queue_4_in_step: assert (queue_4_out_valid == out_valid);
        queue_5_in_step: assert (queue_5_out_valid == out_valid);
        queue_6_in_step: assert (queue_6_out_valid == out_valid);
        queue_7_in_step: assert (queue_7_out_valid == out_valid);
        phases_are_in_step: assert (check_both_50 & (phases_38 == phases_1));
`else
        if (!(~kept | queue_1_in_ready)) begin
            $display("assertion failed: queue_1_has_a_place_for_each_result in %m"); $stop;
        end
        if (!(~kept | queue_2_in_ready)) begin
            $display("assertion failed: queue_2_has_a_place_for_each_result in %m"); $stop;
        end
        if (!(~kept | queue_3_in_ready)) begin
            $display("assertion failed: queue_3_has_a_place_for_each_result in %m"); $stop;
        end
        if (!(~kept | queue_4_in_ready)) begin
            $display("assertion failed: queue_4_has_a_place_for_each_result in %m"); $stop;
        end
        if (!(~kept | queue_5_in_ready)) begin
            $display("assertion failed: queue_5_has_a_place_for_each_result in %m"); $stop;
        end
        if (!(~kept | queue_6_in_ready)) begin
            $display("assertion failed: queue_6_has_a_place_for_each_result in %m"); $stop;
        end
        if (!(~kept | queue_7_in_ready)) begin
            $display("assertion failed: queue_7_has_a_place_for_each_result in %m"); $stop;
        end
        if (!(queue_2_out_valid == out_valid)) begin
            $display("assertion failed: queue_2_in_step in %m"); $stop;
        end
        if (!(queue_3_out_valid == out_valid)) begin
            $display("assertion failed: queue_3_in_step in %m"); $stop;
        end
        if (!(queue_4_out_valid == out_valid)) begin
            $display("assertion failed: queue_4_in_step in %m"); $stop;
        end
        if (!(queue_5_out_valid == out_valid)) begin
            $display("assertion failed: queue_5_in_step in %m"); $stop;
        end
        if (!(queue_6_out_valid == out_valid)) begin
            $display("assertion failed: queue_6_in_step in %m"); $stop;
        end
        if (!(queue_7_out_valid == out_valid)) begin
            $display("assertion failed: queue_7_in_step in %m"); $stop;
        end
        if (!(check_both_50 & (phases_38 == phases_1))) begin
            $display("assertion failed: phases_are_in_step in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue in a memory with a registered output.
// depth = 96
// width = 92
module stream_fifo_d96_w92 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [91:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [91:0] out_data
);
    reg [6:0] held, waiting;
    reg is_full, any_waits;
    reg [6:0] write_address, read_address;
    wire [91:0] item;

    wire has_room = ~is_full;
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [6:0] held_bits = {{6{~push}}, 1'd1};
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    memory_1w1r_unordered #(.WIDTH(92), .DEPTH(96)) entries (
        .clk(clk), .write(has_room), .write_address(write_address), .write_data(in_data),
        .read(fetch), .read_address(read_address), .read_data(item)
    );

    always @(posedge clk) begin
        if (rst) begin
            held <= 7'd0;
            waiting <= 7'd0;
            is_full <= 1'd0;
            any_waits <= 1'd0;
            write_address <= 7'd0;
            read_address <= 7'd0;
            out_valid <= 1'd0;
        end else begin
            if (push_xor_pop) begin
                held <= held + held_bits;
                is_full <= push & (held == 7'd95);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 7'd1);
            end
            if (push) write_address <= (write_address == 7'd95) ? 7'd0 : (write_address + 7'd1);
            if (fetch) read_address <= (read_address == 7'd95) ? 7'd0 : (read_address + 7'd1);
            out_valid <= fetch | (out_valid & ~out_ready);
        end
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        held_in_range: assert (held <= 7'd96);
        held_is_waiting_and_shown: assert (held == (waiting + {6'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 7'd96)) & (any_waits == |waiting));
`else
        if (!(held <= 7'd96)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {6'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 7'd96)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue in a memory with a registered output.
// depth = 96
// width = 118
module stream_fifo_d96_w118 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [117:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [117:0] out_data
);
    reg [6:0] held, waiting;
    reg is_full, any_waits;
    reg [6:0] write_address, read_address;
    wire [117:0] item;

    wire has_room = ~is_full;
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [6:0] held_bits = {{6{~push}}, 1'd1};
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    memory_1w1r_unordered #(.WIDTH(118), .DEPTH(96)) entries (
        .clk(clk), .write(has_room), .write_address(write_address), .write_data(in_data),
        .read(fetch), .read_address(read_address), .read_data(item)
    );

    always @(posedge clk) begin
        if (rst) begin
            held <= 7'd0;
            waiting <= 7'd0;
            is_full <= 1'd0;
            any_waits <= 1'd0;
            write_address <= 7'd0;
            read_address <= 7'd0;
            out_valid <= 1'd0;
        end else begin
            if (push_xor_pop) begin
                held <= held + held_bits;
                is_full <= push & (held == 7'd95);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 7'd1);
            end
            if (push) write_address <= (write_address == 7'd95) ? 7'd0 : (write_address + 7'd1);
            if (fetch) read_address <= (read_address == 7'd95) ? 7'd0 : (read_address + 7'd1);
            out_valid <= fetch | (out_valid & ~out_ready);
        end
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        held_in_range: assert (held <= 7'd96);
        held_is_waiting_and_shown: assert (held == (waiting + {6'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 7'd96)) & (any_waits == |waiting));
`else
        if (!(held <= 7'd96)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {6'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 7'd96)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue in a memory with a registered output.
// depth = 96
// width = 128
module stream_fifo_d96_w128 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [127:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [127:0] out_data
);
    reg [6:0] held, waiting;
    reg is_full, any_waits;
    reg [6:0] write_address, read_address;
    wire [127:0] item;

    wire has_room = ~is_full;
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [6:0] held_bits = {{6{~push}}, 1'd1};
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    memory_1w1r_unordered #(.WIDTH(128), .DEPTH(96)) entries (
        .clk(clk), .write(has_room), .write_address(write_address), .write_data(in_data),
        .read(fetch), .read_address(read_address), .read_data(item)
    );

    always @(posedge clk) begin
        if (rst) begin
            held <= 7'd0;
            waiting <= 7'd0;
            is_full <= 1'd0;
            any_waits <= 1'd0;
            write_address <= 7'd0;
            read_address <= 7'd0;
            out_valid <= 1'd0;
        end else begin
            if (push_xor_pop) begin
                held <= held + held_bits;
                is_full <= push & (held == 7'd95);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 7'd1);
            end
            if (push) write_address <= (write_address == 7'd95) ? 7'd0 : (write_address + 7'd1);
            if (fetch) read_address <= (read_address == 7'd95) ? 7'd0 : (read_address + 7'd1);
            out_valid <= fetch | (out_valid & ~out_ready);
        end
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        held_in_range: assert (held <= 7'd96);
        held_is_waiting_and_shown: assert (held == (waiting + {6'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 7'd96)) & (any_waits == |waiting));
`else
        if (!(held <= 7'd96)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {6'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 7'd96)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue in a memory with a registered output.
// depth = 96
// width = 4
// storage = distributed
module stream_fifo_d96_w4_distributed (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [3:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [3:0] out_data
);
    (* ram_style = "distributed" *)
    reg [3:0] entries [0:95];
    reg [6:0] held, waiting;
    reg is_full, any_waits;
    reg [6:0] write_address, read_address;
    reg [3:0] item;

    wire has_room = ~is_full;
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [6:0] held_bits = {{6{~push}}, 1'd1};
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    always @(posedge clk) begin
        if (rst) begin
            held <= 7'd0;
            waiting <= 7'd0;
            is_full <= 1'd0;
            any_waits <= 1'd0;
            write_address <= 7'd0;
            read_address <= 7'd0;
            out_valid <= 1'd0;
        end else begin
            if (push_xor_pop) begin
                held <= held + held_bits;
                is_full <= push & (held == 7'd95);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 7'd1);
            end
            if (push) write_address <= (write_address == 7'd95) ? 7'd0 : (write_address + 7'd1);
            if (fetch) read_address <= (read_address == 7'd95) ? 7'd0 : (read_address + 7'd1);
            out_valid <= fetch | (out_valid & ~out_ready);
        end
    end
    always @(posedge clk) begin
        if (has_room) entries[write_address] <= in_data;
        if (fetch) item <= entries[read_address];
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        held_in_range: assert (held <= 7'd96);
        held_is_waiting_and_shown: assert (held == (waiting + {6'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 7'd96)) & (any_waits == |waiting));
`else
        if (!(held <= 7'd96)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {6'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 7'd96)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Floating to fixed point.
// stages = 3
// format = f32-ftz
// width = 24
// fraction = 24
// integer = unsigned
module float_to_fixed_s3_f32ftz_w24_f24_unsigned (
    input  wire clk, input wire enable, input wire [31:0] a,
    output reg  [23:0] y
);
    reg [4:0] distance_s1;
    reg [23:0] significand_s1, magnitude_s2;
    reg sign_s1, sign_s2, nan_s1, nan_s2, vanishes_s1, vanishes_s2, saturates_s1, saturates_s2;

    wire [7:0] a_field = a[30:23];
    wire [10:0] saturates_s1_sum = {3'd0, a_field} + 11'h79a;
    wire [10:0] distance_s1_difference = 11'd24 - saturates_s1_sum;
    wire [22:0] a_fraction = a[22:0];
    wire vanishes_s1_either = saturates_s1_sum[10] | (saturates_s1_sum == 11'd0);
    wire vanishes_s1_both = &a_field & (a_fraction == 23'd0);

    always @(posedge clk) begin
        if (enable) begin
            distance_s1 <= distance_s1_difference[4:0];
            significand_s1 <= {|a_field, a_fraction & {23{|a_field}}};
            magnitude_s2 <= significand_s1 >> distance_s1;
            sign_s1 <= a[31];
            sign_s2 <= sign_s1;
            nan_s1 <= &a_field & |a_fraction;
            nan_s2 <= nan_s1;
            vanishes_s1 <= (vanishes_s1_either & ~vanishes_s1_both) | ~(|a_field);
            vanishes_s2 <= vanishes_s1;
            saturates_s1 <= (~vanishes_s1_either & (11'd25 <= saturates_s1_sum) & |a_field) | vanishes_s1_both;
            saturates_s2 <= saturates_s1;
            y <= (vanishes_s2 | nan_s2 | sign_s2) ? 24'd0 : saturates_s2 ? 24'hffffff : magnitude_s2;
        end
    end

    wire _unused = &{1'b0, distance_s1_difference[10:5]};
endmodule

// Floating to fixed point.
// stages = 3
// format = f32-ftz
// width = 22
// fraction = 8
// integer = signed
module float_to_fixed_s3_f32ftz_w22_f8_signed (
    input  wire clk, input wire enable, input wire [31:0] a,
    output reg  [21:0] y
);
    reg [4:0] distance_s1;
    reg [23:0] significand_s1;
    reg [21:0] magnitude_s2;
    reg sign_s1, sign_s2, nan_s1, nan_s2, vanishes_s1, vanishes_s2, saturates_s1, saturates_s2;

    wire [7:0] a_field = a[30:23];
    wire [10:0] saturates_s1_sum = {3'd0, a_field} + 11'h78a;
    wire [10:0] distance_s1_difference = 11'd24 - saturates_s1_sum;
    wire [22:0] a_fraction = a[22:0];
    wire [23:0] magnitude_s2_shifted = significand_s1 >> distance_s1;
    wire vanishes_s1_either = saturates_s1_sum[10] | (saturates_s1_sum == 11'd0);
    wire vanishes_s1_both = &a_field & (a_fraction == 23'd0);
    wire [21:0] y_choice = saturates_s2 ? (sign_s2 ? 22'h200000 : 22'h1fffff) : sign_s2 ? (~magnitude_s2 + 22'd1) : magnitude_s2;

    always @(posedge clk) begin
        if (enable) begin
            distance_s1 <= distance_s1_difference[4:0];
            significand_s1 <= {|a_field, a_fraction & {23{|a_field}}};
            magnitude_s2 <= magnitude_s2_shifted[21:0];
            sign_s1 <= a[31];
            sign_s2 <= sign_s1;
            nan_s1 <= &a_field & |a_fraction;
            nan_s2 <= nan_s1;
            vanishes_s1 <= (vanishes_s1_either & ~vanishes_s1_both) | ~(|a_field);
            vanishes_s2 <= vanishes_s1;
            saturates_s1 <= (~vanishes_s1_either & (11'd22 <= saturates_s1_sum) & |a_field) | vanishes_s1_both;
            saturates_s2 <= saturates_s1;
            y <= (vanishes_s2 | nan_s2) ? 22'd0 : y_choice;
        end
    end

    wire _unused = &{1'b0, distance_s1_difference[10:5], magnitude_s2_shifted[23:22]};
endmodule

// Floating to fixed point.
// stages = 3
// format = f32-ftz
// width = 23
// fraction = 8
// integer = unsigned
module float_to_fixed_s3_f32ftz_w23_f8_unsigned (
    input  wire clk, input wire enable, input wire [31:0] a,
    output reg  [22:0] y
);
    reg [4:0] distance_s1;
    reg [23:0] significand_s1;
    reg [22:0] magnitude_s2;
    reg sign_s1, sign_s2, nan_s1, nan_s2, vanishes_s1, vanishes_s2, saturates_s1, saturates_s2;

    wire [7:0] a_field = a[30:23];
    wire [10:0] saturates_s1_sum = {3'd0, a_field} + 11'h78a;
    wire [10:0] distance_s1_difference = 11'd24 - saturates_s1_sum;
    wire [22:0] a_fraction = a[22:0];
    wire [23:0] magnitude_s2_shifted = significand_s1 >> distance_s1;
    wire vanishes_s1_either = saturates_s1_sum[10] | (saturates_s1_sum == 11'd0);
    wire vanishes_s1_both = &a_field & (a_fraction == 23'd0);

    always @(posedge clk) begin
        if (enable) begin
            distance_s1 <= distance_s1_difference[4:0];
            significand_s1 <= {|a_field, a_fraction & {23{|a_field}}};
            magnitude_s2 <= magnitude_s2_shifted[22:0];
            sign_s1 <= a[31];
            sign_s2 <= sign_s1;
            nan_s1 <= &a_field & |a_fraction;
            nan_s2 <= nan_s1;
            vanishes_s1 <= (vanishes_s1_either & ~vanishes_s1_both) | ~(|a_field);
            vanishes_s2 <= vanishes_s1;
            saturates_s1 <= (~vanishes_s1_either & (11'd24 <= saturates_s1_sum) & |a_field) | vanishes_s1_both;
            saturates_s2 <= saturates_s1;
            y <= (vanishes_s2 | nan_s2 | sign_s2) ? 23'd0 : saturates_s2 ? 23'h7fffff : magnitude_s2;
        end
    end

    wire _unused = &{1'b0, distance_s1_difference[10:5], magnitude_s2_shifted[23]};
endmodule

// Floating to fixed point.
// stages = 3
// format = f32-ftz
// width = 21
// fraction = 8
// integer = unsigned
module float_to_fixed_s3_f32ftz_w21_f8_unsigned (
    input  wire clk, input wire enable, input wire [31:0] a,
    output reg  [20:0] y
);
    reg [4:0] distance_s1;
    reg [23:0] significand_s1;
    reg [20:0] magnitude_s2;
    reg sign_s1, sign_s2, nan_s1, nan_s2, vanishes_s1, vanishes_s2, saturates_s1, saturates_s2;

    wire [7:0] a_field = a[30:23];
    wire [10:0] saturates_s1_sum = {3'd0, a_field} + 11'h78a;
    wire [10:0] distance_s1_difference = 11'd24 - saturates_s1_sum;
    wire [22:0] a_fraction = a[22:0];
    wire [23:0] magnitude_s2_shifted = significand_s1 >> distance_s1;
    wire vanishes_s1_either = saturates_s1_sum[10] | (saturates_s1_sum == 11'd0);
    wire vanishes_s1_both = &a_field & (a_fraction == 23'd0);

    always @(posedge clk) begin
        if (enable) begin
            distance_s1 <= distance_s1_difference[4:0];
            significand_s1 <= {|a_field, a_fraction & {23{|a_field}}};
            magnitude_s2 <= magnitude_s2_shifted[20:0];
            sign_s1 <= a[31];
            sign_s2 <= sign_s1;
            nan_s1 <= &a_field & |a_fraction;
            nan_s2 <= nan_s1;
            vanishes_s1 <= (vanishes_s1_either & ~vanishes_s1_both) | ~(|a_field);
            vanishes_s2 <= vanishes_s1;
            saturates_s1 <= (~vanishes_s1_either & (11'd22 <= saturates_s1_sum) & |a_field) | vanishes_s1_both;
            saturates_s2 <= saturates_s1;
            y <= (vanishes_s2 | nan_s2 | sign_s2) ? 21'd0 : saturates_s2 ? 21'h1fffff : magnitude_s2;
        end
    end

    wire _unused = &{1'b0, distance_s1_difference[10:5], magnitude_s2_shifted[23:21]};
endmodule

// Lesser of two floating-point numbers.
// stages = 2
// format = f32-ftz
module float_min_s2_f32ftz (
    input  wire clk, input wire enable, input wire [31:0] a, input wire [31:0] b,
    output reg  [31:0] y
);
    reg a_nan_s1, b_nan_s1, less_s1;
    reg [31:0] a_s1, b_s1;

    always @(posedge clk) begin
        if (enable) begin
            a_nan_s1 <= &a[30:23] & |a[22:0];
            b_nan_s1 <= &b[30:23] & |b[22:0];
            less_s1 <= {~a[31], a[30:0] ^ {31{a[31]}}} < {~b[31], b[30:0] ^ {31{b[31]}}};
            a_s1 <= {a[31:23], a[22:0] & {23{|a[30:23]}}};
            b_s1 <= {b[31:23], b[22:0] & {23{|b[30:23]}}};
            y <= (a_nan_s1 & b_nan_s1) ? 32'h7fc00000 : (b_nan_s1 | (~a_nan_s1 & less_s1)) ? a_s1 : b_s1;
        end
    end
endmodule

// Whether one floating-point number is less than another or equal.
// stages = 2
// format = f32-ftz
module float_le_s2_f32ftz (
    input  wire clk, input wire enable, input wire [31:0] a, input wire [31:0] b,
    output reg  y
);
    reg unordered_s1, both_zero_s1, compared_s1;

    always @(posedge clk) begin
        if (enable) begin
            unordered_s1 <= (&a[30:23] & |a[22:0]) | (&b[30:23] & |b[22:0]);
            both_zero_s1 <= (a[30:23] == 8'd0) & (b[30:23] == 8'd0);
            compared_s1 <= {~a[31], a[30:0] ^ {31{a[31]}}} <= {~b[31], b[30:0] ^ {31{b[31]}}};
            y <= (compared_s1 | both_zero_s1) & ~unordered_s1;
        end
    end
endmodule

// Floating-point square root, correctly rounded.
// stages = 26
// format = f32-ftz
module float_sqrt_s26_f32ftz (
    input  wire clk, input wire enable, input wire [31:0] a,
    output reg  [31:0] y
);
    reg [2:0] remainder_s1;
    reg [1:0] root_s1;
    reg [20:0] pending_s1;
    reg [3:0] remainder_s2;
    reg [2:0] root_s2;
    reg [18:0] pending_s2;
    reg [4:0] remainder_s3;
    reg [3:0] root_s3;
    reg [16:0] pending_s3;
    reg [5:0] remainder_s4;
    reg [4:0] root_s4;
    reg [14:0] pending_s4;
    reg [6:0] remainder_s5;
    reg [5:0] root_s5;
    reg [12:0] pending_s5;
    reg [7:0] remainder_s6;
    reg [6:0] root_s6;
    reg [10:0] pending_s6;
    reg [8:0] remainder_s7;
    reg [7:0] root_s7;
    reg [8:0] pending_s7;
    reg [9:0] remainder_s8;
    reg [8:0] root_s8;
    reg [6:0] pending_s8;
    reg [10:0] remainder_s9;
    reg [9:0] root_s9;
    reg [4:0] pending_s9;
    reg [11:0] remainder_s10;
    reg [10:0] root_s10;
    reg [2:0] pending_s10;
    reg [12:0] remainder_s11;
    reg [11:0] root_s11;
    reg pending_s11;
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
    reg [18:0] remainder_s17;
    reg [17:0] root_s17;
    reg [19:0] remainder_s18;
    reg [18:0] root_s18;
    reg [20:0] remainder_s19;
    reg [19:0] root_s19;
    reg [21:0] remainder_s20;
    reg [20:0] root_s20;
    reg [22:0] remainder_s21;
    reg [21:0] root_s21;
    reg [23:0] remainder_s22;
    reg [22:0] root_s22;
    reg [24:0] remainder_s23;
    reg [23:0] root_s23;
    reg [25:0] remainder_s24;
    reg [24:0] root_s24;
    reg [9:0] exponent_s1, exponent_s2, exponent_s3, exponent_s4, exponent_s5, exponent_s6, exponent_s7;
    reg [9:0] exponent_s8, exponent_s9, exponent_s10, exponent_s11, exponent_s12, exponent_s13, exponent_s14;
    reg [9:0] exponent_s15, exponent_s16, exponent_s17, exponent_s18, exponent_s19, exponent_s20, exponent_s21;
    reg [9:0] exponent_s22, exponent_s23, exponent_s24, exponent_s25;
    reg [25:0] significand_s25;
    reg sign_s1, sign_s2, sign_s3, sign_s4, sign_s5, sign_s6, sign_s7, sign_s8, sign_s9, sign_s10, sign_s11;
    reg sign_s12, sign_s13, sign_s14, sign_s15, sign_s16, sign_s17, sign_s18, sign_s19, sign_s20, sign_s21;
    reg sign_s22, sign_s23, sign_s24, sign_s25, nan_s1, nan_s2, nan_s3, nan_s4, nan_s5, nan_s6, nan_s7;
    reg nan_s8, nan_s9, nan_s10, nan_s11, nan_s12, nan_s13, nan_s14, nan_s15, nan_s16, nan_s17, nan_s18;
    reg nan_s19, nan_s20, nan_s21, nan_s22, nan_s23, nan_s24, nan_s25, infinite_s1, infinite_s2, infinite_s3;
    reg infinite_s4, infinite_s5, infinite_s6, infinite_s7, infinite_s8, infinite_s9, infinite_s10;
    reg infinite_s11, infinite_s12, infinite_s13, infinite_s14, infinite_s15, infinite_s16, infinite_s17;
    reg infinite_s18, infinite_s19, infinite_s20, infinite_s21, infinite_s22, infinite_s23, infinite_s24;
    reg infinite_s25, zero_s1, zero_s2, zero_s3, zero_s4, zero_s5, zero_s6, zero_s7, zero_s8, zero_s9;
    reg zero_s10, zero_s11, zero_s12, zero_s13, zero_s14, zero_s15, zero_s16, zero_s17, zero_s18, zero_s19;
    reg zero_s20, zero_s21, zero_s22, zero_s23, zero_s24, zero_s25;

    wire [7:0] a_field = a[30:23];
    wire [22:0] a_fraction = a[22:0];
    wire [22:0] remainder_s1_both = a_fraction & {23{|a_field}};
    wire [24:0] remainder_s1_choice = ~a_field[0] ? {|a_field, remainder_s1_both, 1'd0} : {1'd0, |a_field, remainder_s1_both};
    wire [1:0] remainder_s1_difference = remainder_s1_choice[24:23] - 2'd1;
    wire [4:0] remainder_s1_difference_2 = {1'd0, remainder_s1_difference, remainder_s1_choice[22:21]} - 5'd5;
    wire [5:0] remainder_s2_difference = {1'd0, remainder_s1, pending_s1[20:19]} - {2'd0, root_s1, 2'd1};
    wire [6:0] remainder_s3_difference = {1'd0, remainder_s2, pending_s2[18:17]} - {2'd0, root_s2, 2'd1};
    wire [7:0] remainder_s4_difference = {1'd0, remainder_s3, pending_s3[16:15]} - {2'd0, root_s3, 2'd1};
    wire [8:0] remainder_s5_difference = {1'd0, remainder_s4, pending_s4[14:13]} - {2'd0, root_s4, 2'd1};
    wire [9:0] remainder_s6_difference = {1'd0, remainder_s5, pending_s5[12:11]} - {2'd0, root_s5, 2'd1};
    wire [10:0] remainder_s7_difference = {1'd0, remainder_s6, pending_s6[10:9]} - {2'd0, root_s6, 2'd1};
    wire [11:0] remainder_s8_difference = {1'd0, remainder_s7, pending_s7[8:7]} - {2'd0, root_s7, 2'd1};
    wire [12:0] remainder_s9_difference = {1'd0, remainder_s8, pending_s8[6:5]} - {2'd0, root_s8, 2'd1};
    wire [13:0] remainder_s10_difference = {1'd0, remainder_s9, pending_s9[4:3]} - {2'd0, root_s9, 2'd1};
    wire [14:0] remainder_s11_difference = {1'd0, remainder_s10, pending_s10[2:1]} - {2'd0, root_s10, 2'd1};
    wire [15:0] remainder_s12_difference = {1'd0, remainder_s11, pending_s11, 1'd0} - {2'd0, root_s11, 2'd1};
    wire [16:0] remainder_s13_difference = {1'd0, remainder_s12, 2'd0} - {2'd0, root_s12, 2'd1};
    wire [17:0] remainder_s14_difference = {1'd0, remainder_s13, 2'd0} - {2'd0, root_s13, 2'd1};
    wire [18:0] remainder_s15_difference = {1'd0, remainder_s14, 2'd0} - {2'd0, root_s14, 2'd1};
    wire [19:0] remainder_s16_difference = {1'd0, remainder_s15, 2'd0} - {2'd0, root_s15, 2'd1};
    wire [20:0] remainder_s17_difference = {1'd0, remainder_s16, 2'd0} - {2'd0, root_s16, 2'd1};
    wire [21:0] remainder_s18_difference = {1'd0, remainder_s17, 2'd0} - {2'd0, root_s17, 2'd1};
    wire [22:0] remainder_s19_difference = {1'd0, remainder_s18, 2'd0} - {2'd0, root_s18, 2'd1};
    wire [23:0] remainder_s20_difference = {1'd0, remainder_s19, 2'd0} - {2'd0, root_s19, 2'd1};
    wire [24:0] remainder_s21_difference = {1'd0, remainder_s20, 2'd0} - {2'd0, root_s20, 2'd1};
    wire [25:0] remainder_s22_difference = {1'd0, remainder_s21, 2'd0} - {2'd0, root_s21, 2'd1};
    wire [26:0] remainder_s23_difference = {1'd0, remainder_s22, 2'd0} - {2'd0, root_s22, 2'd1};
    wire [27:0] remainder_s24_difference = {1'd0, remainder_s23, 2'd0} - {2'd0, root_s23, 2'd1};
    wire [9:0] a_field_plus_127 = {2'd0, a_field} + 10'd127;
    wire y_both = (exponent_s25 == 10'd0) & ~(&significand_s25[24:2] & significand_s25[1]);
    wire round_up = significand_s25[1] & (significand_s25[0] | significand_s25[2]);
    wire [30:0] rounded = {exponent_s25[7:0], significand_s25[24:2]} + {30'd0, round_up};
    wire [30:0] y_choice = (infinite_s25 | (~exponent_s25[9] & (10'd255 <= exponent_s25))) ? 31'h7f800000 : rounded;
    wire [30:0] y_choice_2 = (zero_s25 | ((exponent_s25[9] | y_both) & ~infinite_s25)) ? 31'd0 : y_choice;

    always @(posedge clk) begin
        if (enable) begin
            remainder_s1 <= ~remainder_s1_difference_2[4] ? remainder_s1_difference_2[2:0] : {remainder_s1_difference[0], remainder_s1_choice[22:21]};
            root_s1 <= {1'd1, ~remainder_s1_difference_2[4]};
            pending_s1 <= remainder_s1_choice[20:0];
            remainder_s2 <= ~remainder_s2_difference[5] ? remainder_s2_difference[3:0] : {remainder_s1[1:0], pending_s1[20:19]};
            root_s2 <= {root_s1, ~remainder_s2_difference[5]};
            pending_s2 <= pending_s1[18:0];
            remainder_s3 <= ~remainder_s3_difference[6] ? remainder_s3_difference[4:0] : {remainder_s2[2:0], pending_s2[18:17]};
            root_s3 <= {root_s2, ~remainder_s3_difference[6]};
            pending_s3 <= pending_s2[16:0];
            remainder_s4 <= ~remainder_s4_difference[7] ? remainder_s4_difference[5:0] : {remainder_s3[3:0], pending_s3[16:15]};
            root_s4 <= {root_s3, ~remainder_s4_difference[7]};
            pending_s4 <= pending_s3[14:0];
            remainder_s5 <= ~remainder_s5_difference[8] ? remainder_s5_difference[6:0] : {remainder_s4[4:0], pending_s4[14:13]};
            root_s5 <= {root_s4, ~remainder_s5_difference[8]};
            pending_s5 <= pending_s4[12:0];
            remainder_s6 <= ~remainder_s6_difference[9] ? remainder_s6_difference[7:0] : {remainder_s5[5:0], pending_s5[12:11]};
            root_s6 <= {root_s5, ~remainder_s6_difference[9]};
            pending_s6 <= pending_s5[10:0];
            remainder_s7 <= ~remainder_s7_difference[10] ? remainder_s7_difference[8:0] : {remainder_s6[6:0], pending_s6[10:9]};
            root_s7 <= {root_s6, ~remainder_s7_difference[10]};
            pending_s7 <= pending_s6[8:0];
            remainder_s8 <= ~remainder_s8_difference[11] ? remainder_s8_difference[9:0] : {remainder_s7[7:0], pending_s7[8:7]};
            root_s8 <= {root_s7, ~remainder_s8_difference[11]};
            pending_s8 <= pending_s7[6:0];
            remainder_s9 <= ~remainder_s9_difference[12] ? remainder_s9_difference[10:0] : {remainder_s8[8:0], pending_s8[6:5]};
            root_s9 <= {root_s8, ~remainder_s9_difference[12]};
            pending_s9 <= pending_s8[4:0];
            remainder_s10 <= ~remainder_s10_difference[13] ? remainder_s10_difference[11:0] : {remainder_s9[9:0], pending_s9[4:3]};
            root_s10 <= {root_s9, ~remainder_s10_difference[13]};
            pending_s10 <= pending_s9[2:0];
            remainder_s11 <= ~remainder_s11_difference[14] ? remainder_s11_difference[12:0] : {remainder_s10[10:0], pending_s10[2:1]};
            root_s11 <= {root_s10, ~remainder_s11_difference[14]};
            pending_s11 <= pending_s10[0];
            remainder_s12 <= ~remainder_s12_difference[15] ? remainder_s12_difference[13:0] : {remainder_s11[11:0], pending_s11, 1'd0};
            root_s12 <= {root_s11, ~remainder_s12_difference[15]};
            remainder_s13 <= ~remainder_s13_difference[16] ? remainder_s13_difference[14:0] : {remainder_s12[12:0], 2'd0};
            root_s13 <= {root_s12, ~remainder_s13_difference[16]};
            remainder_s14 <= ~remainder_s14_difference[17] ? remainder_s14_difference[15:0] : {remainder_s13[13:0], 2'd0};
            root_s14 <= {root_s13, ~remainder_s14_difference[17]};
            remainder_s15 <= ~remainder_s15_difference[18] ? remainder_s15_difference[16:0] : {remainder_s14[14:0], 2'd0};
            root_s15 <= {root_s14, ~remainder_s15_difference[18]};
            remainder_s16 <= ~remainder_s16_difference[19] ? remainder_s16_difference[17:0] : {remainder_s15[15:0], 2'd0};
            root_s16 <= {root_s15, ~remainder_s16_difference[19]};
            remainder_s17 <= ~remainder_s17_difference[20] ? remainder_s17_difference[18:0] : {remainder_s16[16:0], 2'd0};
            root_s17 <= {root_s16, ~remainder_s17_difference[20]};
            remainder_s18 <= ~remainder_s18_difference[21] ? remainder_s18_difference[19:0] : {remainder_s17[17:0], 2'd0};
            root_s18 <= {root_s17, ~remainder_s18_difference[21]};
            remainder_s19 <= ~remainder_s19_difference[22] ? remainder_s19_difference[20:0] : {remainder_s18[18:0], 2'd0};
            root_s19 <= {root_s18, ~remainder_s19_difference[22]};
            remainder_s20 <= ~remainder_s20_difference[23] ? remainder_s20_difference[21:0] : {remainder_s19[19:0], 2'd0};
            root_s20 <= {root_s19, ~remainder_s20_difference[23]};
            remainder_s21 <= ~remainder_s21_difference[24] ? remainder_s21_difference[22:0] : {remainder_s20[20:0], 2'd0};
            root_s21 <= {root_s20, ~remainder_s21_difference[24]};
            remainder_s22 <= ~remainder_s22_difference[25] ? remainder_s22_difference[23:0] : {remainder_s21[21:0], 2'd0};
            root_s22 <= {root_s21, ~remainder_s22_difference[25]};
            remainder_s23 <= ~remainder_s23_difference[26] ? remainder_s23_difference[24:0] : {remainder_s22[22:0], 2'd0};
            root_s23 <= {root_s22, ~remainder_s23_difference[26]};
            remainder_s24 <= ~remainder_s24_difference[27] ? remainder_s24_difference[25:0] : {remainder_s23[23:0], 2'd0};
            root_s24 <= {root_s23, ~remainder_s24_difference[27]};
            exponent_s1 <= {a_field_plus_127[9], a_field_plus_127[9:1]};
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
            exponent_s19 <= exponent_s18;
            exponent_s20 <= exponent_s19;
            exponent_s21 <= exponent_s20;
            exponent_s22 <= exponent_s21;
            exponent_s23 <= exponent_s22;
            exponent_s24 <= exponent_s23;
            exponent_s25 <= exponent_s24;
            significand_s25 <= {root_s24, |remainder_s24};
            sign_s1 <= a[31];
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
            sign_s20 <= sign_s19;
            sign_s21 <= sign_s20;
            sign_s22 <= sign_s21;
            sign_s23 <= sign_s22;
            sign_s24 <= sign_s23;
            sign_s25 <= sign_s24;
            nan_s1 <= (&a_field & |a_fraction) | (a[31] & |a_field);
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
            nan_s20 <= nan_s19;
            nan_s21 <= nan_s20;
            nan_s22 <= nan_s21;
            nan_s23 <= nan_s22;
            nan_s24 <= nan_s23;
            nan_s25 <= nan_s24;
            infinite_s1 <= &a_field & (a_fraction == 23'd0);
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
            infinite_s20 <= infinite_s19;
            infinite_s21 <= infinite_s20;
            infinite_s22 <= infinite_s21;
            infinite_s23 <= infinite_s22;
            infinite_s24 <= infinite_s23;
            infinite_s25 <= infinite_s24;
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
            zero_s17 <= zero_s16;
            zero_s18 <= zero_s17;
            zero_s19 <= zero_s18;
            zero_s20 <= zero_s19;
            zero_s21 <= zero_s20;
            zero_s22 <= zero_s21;
            zero_s23 <= zero_s22;
            zero_s24 <= zero_s23;
            zero_s25 <= zero_s24;
            y <= nan_s25 ? 32'h7fc00000 : {sign_s25, y_choice_2};
        end
    end

    wire _unused = &{
        1'b0, a_field_plus_127[0], remainder_s10_difference[12], remainder_s11_difference[13],
        remainder_s12_difference[14], remainder_s13_difference[15], remainder_s14_difference[16],
        remainder_s15_difference[17], remainder_s16_difference[18], remainder_s17_difference[19],
        remainder_s18_difference[20], remainder_s19_difference[21], remainder_s1_difference_2[3],
        remainder_s20_difference[22], remainder_s21_difference[23], remainder_s22_difference[24],
        remainder_s23_difference[25], remainder_s24_difference[26], remainder_s2_difference[4],
        remainder_s3_difference[5], remainder_s4_difference[6], remainder_s5_difference[7],
        remainder_s6_difference[8], remainder_s7_difference[9], remainder_s8_difference[10],
        remainder_s9_difference[11], significand_s25[25]
    };
endmodule

// Floating-point sum with products, each of them rounded.
// product_stages = 6
// sum_stages = 6
// format = f32-ftz
module mul_add_p6_s6_f32ftz (
    input  wire clk, input wire enable, input wire [31:0] a, input wire [31:0] b, input wire [31:0] c,
    output wire [31:0] y
);
    wire [31:0] product_y;

    float_mul_s6_f32ftz product (.clk(clk), .enable(enable), .a(a), .b(b), .y(product_y));
    float_add_s6_f32ftz sum (.clk(clk), .enable(enable), .a(product_y), .b(c), .y(y));
endmodule

// Floating-point sum with products, each of them rounded.
// product_stages = 6
// sum_stages = 6
// format = f32-ftz
module mul_mul_add_p6_s6_f32ftz (
    input  wire clk, input wire enable, input wire [31:0] a, input wire [31:0] b, input wire [31:0] c,
    input  wire [31:0] d,
    output wire [31:0] y
);
    wire [31:0] product_y, second_product_y;

    float_mul_s6_f32ftz product (.clk(clk), .enable(enable), .a(a), .b(b), .y(product_y));
    float_mul_s6_f32ftz second_product (.clk(clk), .enable(enable), .a(c), .b(d), .y(second_product_y));
    float_add_s6_f32ftz sum (.clk(clk), .enable(enable), .a(product_y), .b(second_product_y), .y(y));
endmodule

// Floating-point product.
// stages = 6
// format = f32-ftz
module float_mul_s6_f32ftz (
    input  wire clk, input wire enable, input wire [31:0] a, input wire [31:0] b,
    output reg  [31:0] y
);
    reg [23:0] left_s1, right_s1;
    reg [9:0] exponent_s1;
    reg [23:0] partial_0_0_s2, partial_0_12_s2, partial_12_0_s2, partial_12_12_s2;
    reg [47:0] product_s3;
    reg [9:0] exponent_s2, exponent_s3, exponent_s4;
    reg [25:0] significand_s4;
    reg sign_s1, sign_s2, sign_s3, sign_s4, nan_s1, nan_s2, nan_s3, nan_s4, infinite_s1, infinite_s2;
    reg infinite_s3, infinite_s4, zero_s1, zero_s2, zero_s3, zero_s4, sign_s5, nan_s5, infinite_s5, zero_s5;
    reg [30:0] rounded_s5;

    wire [7:0] a_field = a[30:23];
    wire [22:0] a_fraction = a[22:0];
    wire [7:0] b_field = b[30:23];
    wire [22:0] b_fraction = b[22:0];
    wire [47:0] product_s3_sum = ({24'd0, partial_0_0_s2} | ({24'd0, partial_12_12_s2} << 24)) + ({24'd0, partial_0_12_s2} << 12);
    wire [47:0] significand_s4_choice = product_s3[47] ? product_s3 : (product_s3 << 1);
    wire nan_s1_both = &a_field & (a_fraction == 23'd0);
    wire nan_s1_inverted = ~(|b_field);
    wire nan_s1_either = (&a_field & |a_fraction) | (&b_field & |b_fraction) | (nan_s1_both & nan_s1_inverted);
    wire nan_s1_inverted_2 = ~(|a_field);
    wire nan_s1_both_2 = &b_field & (b_fraction == 23'd0);
    wire zero_s5_both = (exponent_s4 == 10'd0) & ~(&significand_s4[24:2] & significand_s4[1]);
    wire round_up = significand_s4[1] & (significand_s4[0] | significand_s4[2]);
    wire [30:0] rounded = {exponent_s4[7:0], significand_s4[24:2]} + {30'd0, round_up};
    wire [31:0] y_bits = {sign_s5, zero_s5 ? 31'd0 : infinite_s5 ? 31'h7f800000 : rounded_s5};

    always @(posedge clk) begin
        if (enable) begin
            left_s1 <= {|a_field, a_fraction & {23{|a_field}}};
            right_s1 <= {|b_field, b_fraction & {23{|b_field}}};
            exponent_s1 <= {2'd0, a_field} + {2'd0, b_field};
            partial_0_0_s2 <= {12'd0, left_s1[11:0]} * {12'd0, right_s1[11:0]};
            partial_0_12_s2 <= {12'd0, left_s1[11:0]} * {12'd0, right_s1[23:12]};
            partial_12_0_s2 <= {12'd0, left_s1[23:12]} * {12'd0, right_s1[11:0]};
            partial_12_12_s2 <= {12'd0, left_s1[23:12]} * {12'd0, right_s1[23:12]};
            product_s3 <= product_s3_sum + ({24'd0, partial_12_0_s2} << 12);
            exponent_s2 <= exponent_s1 - 10'd127;
            exponent_s3 <= exponent_s2;
            exponent_s4 <= exponent_s3 + {9'd0, product_s3[47]};
            significand_s4 <= {significand_s4_choice[47:23], |significand_s4_choice[22:0]};
            sign_s1 <= a[31] ^ b[31];
            sign_s2 <= sign_s1;
            sign_s3 <= sign_s2;
            sign_s4 <= sign_s3;
            nan_s1 <= nan_s1_either | (nan_s1_inverted_2 & nan_s1_both_2);
            nan_s2 <= nan_s1;
            nan_s3 <= nan_s2;
            nan_s4 <= nan_s3;
            infinite_s1 <= nan_s1_both | nan_s1_both_2;
            infinite_s2 <= infinite_s1;
            infinite_s3 <= infinite_s2;
            infinite_s4 <= infinite_s3;
            zero_s1 <= nan_s1_inverted_2 | nan_s1_inverted;
            zero_s2 <= zero_s1;
            zero_s3 <= zero_s2;
            zero_s4 <= zero_s3;
            sign_s5 <= sign_s4;
            nan_s5 <= nan_s4;
            infinite_s5 <= infinite_s4 | (~exponent_s4[9] & (10'd255 <= exponent_s4));
            zero_s5 <= zero_s4 | ((exponent_s4[9] | zero_s5_both) & ~infinite_s4);
            rounded_s5 <= rounded;
            y <= nan_s5 ? 32'h7fc00000 : y_bits;
        end
    end

    wire _unused = &{1'b0, significand_s4[25]};
endmodule

// Floating-point reciprocal, correctly rounded.
// stages = 28
// format = f32-ftz
module float_recip_s28_f32ftz (
    input  wire clk, input wire enable, input wire [31:0] a,
    output reg  [31:0] y
);
    reg [24:0] remainder_s1;
    reg quotient_s1;
    reg [23:0] divisor_s1;
    reg [24:0] remainder_s2;
    reg [1:0] quotient_s2;
    reg [23:0] divisor_s2;
    reg [24:0] remainder_s3;
    reg [2:0] quotient_s3;
    reg [23:0] divisor_s3;
    reg [24:0] remainder_s4;
    reg [3:0] quotient_s4;
    reg [23:0] divisor_s4;
    reg [24:0] remainder_s5;
    reg [4:0] quotient_s5;
    reg [23:0] divisor_s5;
    reg [24:0] remainder_s6;
    reg [5:0] quotient_s6;
    reg [23:0] divisor_s6;
    reg [24:0] remainder_s7;
    reg [6:0] quotient_s7;
    reg [23:0] divisor_s7;
    reg [24:0] remainder_s8;
    reg [7:0] quotient_s8;
    reg [23:0] divisor_s8;
    reg [24:0] remainder_s9;
    reg [8:0] quotient_s9;
    reg [23:0] divisor_s9;
    reg [24:0] remainder_s10;
    reg [9:0] quotient_s10;
    reg [23:0] divisor_s10;
    reg [24:0] remainder_s11;
    reg [10:0] quotient_s11;
    reg [23:0] divisor_s11;
    reg [24:0] remainder_s12;
    reg [11:0] quotient_s12;
    reg [23:0] divisor_s12;
    reg [24:0] remainder_s13;
    reg [12:0] quotient_s13;
    reg [23:0] divisor_s13;
    reg [24:0] remainder_s14;
    reg [13:0] quotient_s14;
    reg [23:0] divisor_s14;
    reg [24:0] remainder_s15;
    reg [14:0] quotient_s15;
    reg [23:0] divisor_s15;
    reg [24:0] remainder_s16;
    reg [15:0] quotient_s16;
    reg [23:0] divisor_s16;
    reg [24:0] remainder_s17;
    reg [16:0] quotient_s17;
    reg [23:0] divisor_s17;
    reg [24:0] remainder_s18;
    reg [17:0] quotient_s18;
    reg [23:0] divisor_s18;
    reg [24:0] remainder_s19;
    reg [18:0] quotient_s19;
    reg [23:0] divisor_s19;
    reg [24:0] remainder_s20;
    reg [19:0] quotient_s20;
    reg [23:0] divisor_s20;
    reg [24:0] remainder_s21;
    reg [20:0] quotient_s21;
    reg [23:0] divisor_s21;
    reg [24:0] remainder_s22;
    reg [21:0] quotient_s22;
    reg [23:0] divisor_s22;
    reg [24:0] remainder_s23;
    reg [22:0] quotient_s23;
    reg [23:0] divisor_s23;
    reg [24:0] remainder_s24;
    reg [23:0] quotient_s24, divisor_s24;
    reg [24:0] remainder_s25, quotient_s25;
    reg [23:0] divisor_s25;
    reg [24:0] remainder_s26;
    reg [25:0] quotient_s26;
    reg [9:0] exponent_s1, exponent_s2, exponent_s3, exponent_s4, exponent_s5, exponent_s6, exponent_s7;
    reg [9:0] exponent_s8, exponent_s9, exponent_s10, exponent_s11, exponent_s12, exponent_s13, exponent_s14;
    reg [9:0] exponent_s15, exponent_s16, exponent_s17, exponent_s18, exponent_s19, exponent_s20, exponent_s21;
    reg [9:0] exponent_s22, exponent_s23, exponent_s24, exponent_s25, exponent_s26, exponent_s27;
    reg [25:0] significand_s27;
    reg sign_s1, sign_s2, sign_s3, sign_s4, sign_s5, sign_s6, sign_s7, sign_s8, sign_s9, sign_s10, sign_s11;
    reg sign_s12, sign_s13, sign_s14, sign_s15, sign_s16, sign_s17, sign_s18, sign_s19, sign_s20, sign_s21;
    reg sign_s22, sign_s23, sign_s24, sign_s25, sign_s26, sign_s27, nan_s1, nan_s2, nan_s3, nan_s4, nan_s5;
    reg nan_s6, nan_s7, nan_s8, nan_s9, nan_s10, nan_s11, nan_s12, nan_s13, nan_s14, nan_s15, nan_s16;
    reg nan_s17, nan_s18, nan_s19, nan_s20, nan_s21, nan_s22, nan_s23, nan_s24, nan_s25, nan_s26, nan_s27;
    reg infinite_s1, infinite_s2, infinite_s3, infinite_s4, infinite_s5, infinite_s6, infinite_s7;
    reg infinite_s8, infinite_s9, infinite_s10, infinite_s11, infinite_s12, infinite_s13, infinite_s14;
    reg infinite_s15, infinite_s16, infinite_s17, infinite_s18, infinite_s19, infinite_s20, infinite_s21;
    reg infinite_s22, infinite_s23, infinite_s24, infinite_s25, infinite_s26, infinite_s27, zero_s1, zero_s2;
    reg zero_s3, zero_s4, zero_s5, zero_s6, zero_s7, zero_s8, zero_s9, zero_s10, zero_s11, zero_s12, zero_s13;
    reg zero_s14, zero_s15, zero_s16, zero_s17, zero_s18, zero_s19, zero_s20, zero_s21, zero_s22, zero_s23;
    reg zero_s24, zero_s25, zero_s26, zero_s27;

    wire [7:0] a_field = a[30:23];
    wire [22:0] a_fraction = a[22:0];
    wire [22:0] remainder_s1_both = a_fraction & {23{|a_field}};
    wire [25:0] remainder_s1_difference = 26'h800000 - {2'd0, |a_field, remainder_s1_both};
    wire [23:0] remainder_s1_choice = ~remainder_s1_difference[25] ? remainder_s1_difference[23:0] : 24'h800000;
    wire [25:0] remainder_s1_minus_divisor_s1 = {1'd0, remainder_s1} - {2'd0, divisor_s1};
    wire [23:0] remainder_s2_choice = ~remainder_s1_minus_divisor_s1[25] ? remainder_s1_minus_divisor_s1[23:0] : remainder_s1[23:0];
    wire [25:0] remainder_s2_minus_divisor_s2 = {1'd0, remainder_s2} - {2'd0, divisor_s2};
    wire [23:0] remainder_s3_choice = ~remainder_s2_minus_divisor_s2[25] ? remainder_s2_minus_divisor_s2[23:0] : remainder_s2[23:0];
    wire [25:0] remainder_s3_minus_divisor_s3 = {1'd0, remainder_s3} - {2'd0, divisor_s3};
    wire [23:0] remainder_s4_choice = ~remainder_s3_minus_divisor_s3[25] ? remainder_s3_minus_divisor_s3[23:0] : remainder_s3[23:0];
    wire [25:0] remainder_s4_minus_divisor_s4 = {1'd0, remainder_s4} - {2'd0, divisor_s4};
    wire [23:0] remainder_s5_choice = ~remainder_s4_minus_divisor_s4[25] ? remainder_s4_minus_divisor_s4[23:0] : remainder_s4[23:0];
    wire [25:0] remainder_s5_minus_divisor_s5 = {1'd0, remainder_s5} - {2'd0, divisor_s5};
    wire [23:0] remainder_s6_choice = ~remainder_s5_minus_divisor_s5[25] ? remainder_s5_minus_divisor_s5[23:0] : remainder_s5[23:0];
    wire [25:0] remainder_s6_minus_divisor_s6 = {1'd0, remainder_s6} - {2'd0, divisor_s6};
    wire [23:0] remainder_s7_choice = ~remainder_s6_minus_divisor_s6[25] ? remainder_s6_minus_divisor_s6[23:0] : remainder_s6[23:0];
    wire [25:0] remainder_s7_minus_divisor_s7 = {1'd0, remainder_s7} - {2'd0, divisor_s7};
    wire [23:0] remainder_s8_choice = ~remainder_s7_minus_divisor_s7[25] ? remainder_s7_minus_divisor_s7[23:0] : remainder_s7[23:0];
    wire [25:0] remainder_s8_minus_divisor_s8 = {1'd0, remainder_s8} - {2'd0, divisor_s8};
    wire [23:0] remainder_s9_choice = ~remainder_s8_minus_divisor_s8[25] ? remainder_s8_minus_divisor_s8[23:0] : remainder_s8[23:0];
    wire [25:0] remainder_s9_minus_divisor_s9 = {1'd0, remainder_s9} - {2'd0, divisor_s9};
    wire [23:0] remainder_s10_choice = ~remainder_s9_minus_divisor_s9[25] ? remainder_s9_minus_divisor_s9[23:0] : remainder_s9[23:0];
    wire [25:0] remainder_s11_difference = {1'd0, remainder_s10} - {2'd0, divisor_s10};
    wire [23:0] remainder_s11_choice = ~remainder_s11_difference[25] ? remainder_s11_difference[23:0] : remainder_s10[23:0];
    wire [25:0] remainder_s12_difference = {1'd0, remainder_s11} - {2'd0, divisor_s11};
    wire [23:0] remainder_s12_choice = ~remainder_s12_difference[25] ? remainder_s12_difference[23:0] : remainder_s11[23:0];
    wire [25:0] remainder_s13_difference = {1'd0, remainder_s12} - {2'd0, divisor_s12};
    wire [23:0] remainder_s13_choice = ~remainder_s13_difference[25] ? remainder_s13_difference[23:0] : remainder_s12[23:0];
    wire [25:0] remainder_s14_difference = {1'd0, remainder_s13} - {2'd0, divisor_s13};
    wire [23:0] remainder_s14_choice = ~remainder_s14_difference[25] ? remainder_s14_difference[23:0] : remainder_s13[23:0];
    wire [25:0] remainder_s15_difference = {1'd0, remainder_s14} - {2'd0, divisor_s14};
    wire [23:0] remainder_s15_choice = ~remainder_s15_difference[25] ? remainder_s15_difference[23:0] : remainder_s14[23:0];
    wire [25:0] remainder_s16_difference = {1'd0, remainder_s15} - {2'd0, divisor_s15};
    wire [23:0] remainder_s16_choice = ~remainder_s16_difference[25] ? remainder_s16_difference[23:0] : remainder_s15[23:0];
    wire [25:0] remainder_s17_difference = {1'd0, remainder_s16} - {2'd0, divisor_s16};
    wire [23:0] remainder_s17_choice = ~remainder_s17_difference[25] ? remainder_s17_difference[23:0] : remainder_s16[23:0];
    wire [25:0] remainder_s18_difference = {1'd0, remainder_s17} - {2'd0, divisor_s17};
    wire [23:0] remainder_s18_choice = ~remainder_s18_difference[25] ? remainder_s18_difference[23:0] : remainder_s17[23:0];
    wire [25:0] remainder_s19_difference = {1'd0, remainder_s18} - {2'd0, divisor_s18};
    wire [23:0] remainder_s19_choice = ~remainder_s19_difference[25] ? remainder_s19_difference[23:0] : remainder_s18[23:0];
    wire [25:0] remainder_s20_difference = {1'd0, remainder_s19} - {2'd0, divisor_s19};
    wire [23:0] remainder_s20_choice = ~remainder_s20_difference[25] ? remainder_s20_difference[23:0] : remainder_s19[23:0];
    wire [25:0] remainder_s21_difference = {1'd0, remainder_s20} - {2'd0, divisor_s20};
    wire [23:0] remainder_s21_choice = ~remainder_s21_difference[25] ? remainder_s21_difference[23:0] : remainder_s20[23:0];
    wire [25:0] remainder_s22_difference = {1'd0, remainder_s21} - {2'd0, divisor_s21};
    wire [23:0] remainder_s22_choice = ~remainder_s22_difference[25] ? remainder_s22_difference[23:0] : remainder_s21[23:0];
    wire [25:0] remainder_s23_difference = {1'd0, remainder_s22} - {2'd0, divisor_s22};
    wire [23:0] remainder_s23_choice = ~remainder_s23_difference[25] ? remainder_s23_difference[23:0] : remainder_s22[23:0];
    wire [25:0] remainder_s24_difference = {1'd0, remainder_s23} - {2'd0, divisor_s23};
    wire [23:0] remainder_s24_choice = ~remainder_s24_difference[25] ? remainder_s24_difference[23:0] : remainder_s23[23:0];
    wire [25:0] remainder_s25_difference = {1'd0, remainder_s24} - {2'd0, divisor_s24};
    wire [23:0] remainder_s25_choice = ~remainder_s25_difference[25] ? remainder_s25_difference[23:0] : remainder_s24[23:0];
    wire [25:0] remainder_s26_difference = {1'd0, remainder_s25} - {2'd0, divisor_s25};
    wire [23:0] remainder_s26_choice = ~remainder_s26_difference[25] ? remainder_s26_difference[23:0] : remainder_s25[23:0];
    wire [26:0] significand_s27_bits = {quotient_s26, |remainder_s26};
    wire [26:0] significand_s27_choice = ~quotient_s26[25] ? (significand_s27_bits << 1) : significand_s27_bits;
    wire y_both = (exponent_s27 == 10'd0) & ~(&significand_s27[24:2] & significand_s27[1]);
    wire round_up = significand_s27[1] & (significand_s27[0] | significand_s27[2]);
    wire [30:0] rounded = {exponent_s27[7:0], significand_s27[24:2]} + {30'd0, round_up};
    wire [30:0] y_choice = (infinite_s27 | (~exponent_s27[9] & (10'd255 <= exponent_s27))) ? 31'h7f800000 : rounded;
    wire [30:0] y_choice_2 = (zero_s27 | ((exponent_s27[9] | y_both) & ~infinite_s27)) ? 31'd0 : y_choice;

    always @(posedge clk) begin
        if (enable) begin
            remainder_s1 <= {remainder_s1_choice, 1'd0};
            quotient_s1 <= ~remainder_s1_difference[25];
            divisor_s1 <= {|a_field, remainder_s1_both};
            remainder_s2 <= {remainder_s2_choice, 1'd0};
            quotient_s2 <= {quotient_s1, ~remainder_s1_minus_divisor_s1[25]};
            divisor_s2 <= divisor_s1;
            remainder_s3 <= {remainder_s3_choice, 1'd0};
            quotient_s3 <= {quotient_s2, ~remainder_s2_minus_divisor_s2[25]};
            divisor_s3 <= divisor_s2;
            remainder_s4 <= {remainder_s4_choice, 1'd0};
            quotient_s4 <= {quotient_s3, ~remainder_s3_minus_divisor_s3[25]};
            divisor_s4 <= divisor_s3;
            remainder_s5 <= {remainder_s5_choice, 1'd0};
            quotient_s5 <= {quotient_s4, ~remainder_s4_minus_divisor_s4[25]};
            divisor_s5 <= divisor_s4;
            remainder_s6 <= {remainder_s6_choice, 1'd0};
            quotient_s6 <= {quotient_s5, ~remainder_s5_minus_divisor_s5[25]};
            divisor_s6 <= divisor_s5;
            remainder_s7 <= {remainder_s7_choice, 1'd0};
            quotient_s7 <= {quotient_s6, ~remainder_s6_minus_divisor_s6[25]};
            divisor_s7 <= divisor_s6;
            remainder_s8 <= {remainder_s8_choice, 1'd0};
            quotient_s8 <= {quotient_s7, ~remainder_s7_minus_divisor_s7[25]};
            divisor_s8 <= divisor_s7;
            remainder_s9 <= {remainder_s9_choice, 1'd0};
            quotient_s9 <= {quotient_s8, ~remainder_s8_minus_divisor_s8[25]};
            divisor_s9 <= divisor_s8;
            remainder_s10 <= {remainder_s10_choice, 1'd0};
            quotient_s10 <= {quotient_s9, ~remainder_s9_minus_divisor_s9[25]};
            divisor_s10 <= divisor_s9;
            remainder_s11 <= {remainder_s11_choice, 1'd0};
            quotient_s11 <= {quotient_s10, ~remainder_s11_difference[25]};
            divisor_s11 <= divisor_s10;
            remainder_s12 <= {remainder_s12_choice, 1'd0};
            quotient_s12 <= {quotient_s11, ~remainder_s12_difference[25]};
            divisor_s12 <= divisor_s11;
            remainder_s13 <= {remainder_s13_choice, 1'd0};
            quotient_s13 <= {quotient_s12, ~remainder_s13_difference[25]};
            divisor_s13 <= divisor_s12;
            remainder_s14 <= {remainder_s14_choice, 1'd0};
            quotient_s14 <= {quotient_s13, ~remainder_s14_difference[25]};
            divisor_s14 <= divisor_s13;
            remainder_s15 <= {remainder_s15_choice, 1'd0};
            quotient_s15 <= {quotient_s14, ~remainder_s15_difference[25]};
            divisor_s15 <= divisor_s14;
            remainder_s16 <= {remainder_s16_choice, 1'd0};
            quotient_s16 <= {quotient_s15, ~remainder_s16_difference[25]};
            divisor_s16 <= divisor_s15;
            remainder_s17 <= {remainder_s17_choice, 1'd0};
            quotient_s17 <= {quotient_s16, ~remainder_s17_difference[25]};
            divisor_s17 <= divisor_s16;
            remainder_s18 <= {remainder_s18_choice, 1'd0};
            quotient_s18 <= {quotient_s17, ~remainder_s18_difference[25]};
            divisor_s18 <= divisor_s17;
            remainder_s19 <= {remainder_s19_choice, 1'd0};
            quotient_s19 <= {quotient_s18, ~remainder_s19_difference[25]};
            divisor_s19 <= divisor_s18;
            remainder_s20 <= {remainder_s20_choice, 1'd0};
            quotient_s20 <= {quotient_s19, ~remainder_s20_difference[25]};
            divisor_s20 <= divisor_s19;
            remainder_s21 <= {remainder_s21_choice, 1'd0};
            quotient_s21 <= {quotient_s20, ~remainder_s21_difference[25]};
            divisor_s21 <= divisor_s20;
            remainder_s22 <= {remainder_s22_choice, 1'd0};
            quotient_s22 <= {quotient_s21, ~remainder_s22_difference[25]};
            divisor_s22 <= divisor_s21;
            remainder_s23 <= {remainder_s23_choice, 1'd0};
            quotient_s23 <= {quotient_s22, ~remainder_s23_difference[25]};
            divisor_s23 <= divisor_s22;
            remainder_s24 <= {remainder_s24_choice, 1'd0};
            quotient_s24 <= {quotient_s23, ~remainder_s24_difference[25]};
            divisor_s24 <= divisor_s23;
            remainder_s25 <= {remainder_s25_choice, 1'd0};
            quotient_s25 <= {quotient_s24, ~remainder_s25_difference[25]};
            divisor_s25 <= divisor_s24;
            remainder_s26 <= {remainder_s26_choice, 1'd0};
            quotient_s26 <= {quotient_s25, ~remainder_s26_difference[25]};
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
            exponent_s19 <= exponent_s18;
            exponent_s20 <= exponent_s19;
            exponent_s21 <= exponent_s20;
            exponent_s22 <= exponent_s21;
            exponent_s23 <= exponent_s22;
            exponent_s24 <= exponent_s23;
            exponent_s25 <= exponent_s24;
            exponent_s26 <= exponent_s25;
            exponent_s27 <= exponent_s26 - {9'd0, ~quotient_s26[25]};
            significand_s27 <= {significand_s27_choice[26:2], |significand_s27_choice[1:0]};
            sign_s1 <= a[31];
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
            sign_s20 <= sign_s19;
            sign_s21 <= sign_s20;
            sign_s22 <= sign_s21;
            sign_s23 <= sign_s22;
            sign_s24 <= sign_s23;
            sign_s25 <= sign_s24;
            sign_s26 <= sign_s25;
            sign_s27 <= sign_s26;
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
            nan_s20 <= nan_s19;
            nan_s21 <= nan_s20;
            nan_s22 <= nan_s21;
            nan_s23 <= nan_s22;
            nan_s24 <= nan_s23;
            nan_s25 <= nan_s24;
            nan_s26 <= nan_s25;
            nan_s27 <= nan_s26;
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
            infinite_s20 <= infinite_s19;
            infinite_s21 <= infinite_s20;
            infinite_s22 <= infinite_s21;
            infinite_s23 <= infinite_s22;
            infinite_s24 <= infinite_s23;
            infinite_s25 <= infinite_s24;
            infinite_s26 <= infinite_s25;
            infinite_s27 <= infinite_s26;
            zero_s1 <= &a_field & (a_fraction == 23'd0);
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
            zero_s20 <= zero_s19;
            zero_s21 <= zero_s20;
            zero_s22 <= zero_s21;
            zero_s23 <= zero_s22;
            zero_s24 <= zero_s23;
            zero_s25 <= zero_s24;
            zero_s26 <= zero_s25;
            zero_s27 <= zero_s26;
            y <= nan_s27 ? 32'h7fc00000 : {sign_s27, y_choice_2};
        end
    end

    wire _unused = &{
        1'b0, remainder_s11_difference[24], remainder_s12_difference[24], remainder_s13_difference[24],
        remainder_s14_difference[24], remainder_s15_difference[24], remainder_s16_difference[24],
        remainder_s17_difference[24], remainder_s18_difference[24], remainder_s19_difference[24],
        remainder_s1_difference[24], remainder_s1_minus_divisor_s1[24], remainder_s20_difference[24],
        remainder_s21_difference[24], remainder_s22_difference[24], remainder_s23_difference[24],
        remainder_s24_difference[24], remainder_s25_difference[24], remainder_s26_difference[24],
        remainder_s2_minus_divisor_s2[24], remainder_s3_minus_divisor_s3[24],
        remainder_s4_minus_divisor_s4[24], remainder_s5_minus_divisor_s5[24],
        remainder_s6_minus_divisor_s6[24], remainder_s7_minus_divisor_s7[24],
        remainder_s8_minus_divisor_s8[24], remainder_s9_minus_divisor_s9[24], significand_s27[25]
    };
endmodule

// World space to camera space.
// latency = 31
// initiation_interval = 1
module splat_transform (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready,  // Splats in world space.
    input  wire in_end,  // Closes the frame.
    input  wire [31:0] in_center_x,  // Center.
    input  wire [31:0] in_center_y,  // Center.
    input  wire [31:0] in_center_z,  // Center.
    input  wire [31:0] in_tangent1_x,  // Tangents, whose ends lie at rho = 1.
    input  wire [31:0] in_tangent1_y,  // Tangents, whose ends lie at rho = 1.
    input  wire [31:0] in_tangent1_z,  // Tangents, whose ends lie at rho = 1.
    input  wire [31:0] in_tangent2_x,  // Tangents, whose ends lie at rho = 1.
    input  wire [31:0] in_tangent2_y,  // Tangents, whose ends lie at rho = 1.
    input  wire [31:0] in_tangent2_z,  // Tangents, whose ends lie at rho = 1.
    input  wire [15:0] in_attribute_0,  // Attributes.
    input  wire [15:0] in_attribute_1,  // Attributes.
    input  wire [15:0] in_attribute_2,  // Attributes.
    input  wire [15:0] in_attribute_3,  // Attributes.
    input  wire [15:0] in_attribute_4,  // Attributes.
    input  wire [15:0] in_attribute_5,  // Attributes.
    input  wire [15:0] in_attribute_6,  // Attributes.
    input  wire [15:0] in_attribute_7,  // Attributes.
    input  wire [15:0] in_attribute_8,  // Attributes.
    input  wire [15:0] in_attribute_9,  // Attributes.
    input  wire [15:0] in_attribute_10,  // Attributes.
    input  wire [15:0] in_attribute_11,  // Attributes.
    input  wire [15:0] in_attribute_12,  // Attributes.
    input  wire [15:0] in_cardinal_0,  // Attributes.
    input  wire [31:0] m00,  // By rows; the last row is (0, 0, 0, 1).
    input  wire [31:0] m01,  // By rows; the last row is (0, 0, 0, 1).
    input  wire [31:0] m02,  // By rows; the last row is (0, 0, 0, 1).
    input  wire [31:0] m03,  // By rows; the last row is (0, 0, 0, 1).
    input  wire [31:0] m10,  // By rows; the last row is (0, 0, 0, 1).
    input  wire [31:0] m11,  // By rows; the last row is (0, 0, 0, 1).
    input  wire [31:0] m12,  // By rows; the last row is (0, 0, 0, 1).
    input  wire [31:0] m13,  // By rows; the last row is (0, 0, 0, 1).
    input  wire [31:0] m20,  // By rows; the last row is (0, 0, 0, 1).
    input  wire [31:0] m21,  // By rows; the last row is (0, 0, 0, 1).
    input  wire [31:0] m22,  // By rows; the last row is (0, 0, 0, 1).
    input  wire [31:0] m23,  // By rows; the last row is (0, 0, 0, 1).
    input  wire [31:0] near_plane,  // Near plane.
    output wire out_valid, input wire out_ready,  // Splats in camera space.
    output wire out_end,  // Closes the frame.
    output wire [31:0] out_center_x,  // Center.
    output wire [31:0] out_center_y,  // Center.
    output wire [31:0] out_center_z,  // Center.
    output wire [31:0] out_tangent1_x,  // Tangents, whose ends lie at rho = 1.
    output wire [31:0] out_tangent1_y,  // Tangents, whose ends lie at rho = 1.
    output wire [31:0] out_tangent1_z,  // Tangents, whose ends lie at rho = 1.
    output wire [31:0] out_tangent2_x,  // Tangents, whose ends lie at rho = 1.
    output wire [31:0] out_tangent2_y,  // Tangents, whose ends lie at rho = 1.
    output wire [31:0] out_tangent2_z,  // Tangents, whose ends lie at rho = 1.
    output wire [15:0] out_attribute_0,  // Attributes.
    output wire [15:0] out_attribute_1,  // Attributes.
    output wire [15:0] out_attribute_2,  // Attributes.
    output wire [15:0] out_attribute_3,  // Attributes.
    output wire [15:0] out_attribute_4,  // Attributes.
    output wire [15:0] out_attribute_5,  // Attributes.
    output wire [15:0] out_attribute_6,  // Attributes.
    output wire [15:0] out_attribute_7,  // Attributes.
    output wire [15:0] out_attribute_8,  // Attributes.
    output wire [15:0] out_attribute_9,  // Attributes.
    output wire [15:0] out_attribute_10,  // Attributes.
    output wire [15:0] out_attribute_11,  // Attributes.
    output wire [15:0] out_attribute_12,  // Attributes.
    output wire [15:0] out_cardinal_0  // Attributes.
);
    (* ram_style = "distributed" *)
    reg [95:0] delay_6_from_0 [0:4];
    (* ram_style = "distributed" *)
    reg [95:0] delay_6_from_0_copy2 [0:4];
    (* ram_style = "distributed" *)
    reg [95:0] delay_6_from_0_copy3 [0:4];
    (* ram_style = "distributed" *)
    reg [31:0] delay_6_from_0_copy4 [0:4];
    (* ram_style = "distributed" *)
    reg [63:0] delay_8_from_0 [0:6];
    (* ram_style = "distributed" *)
    reg [95:0] delay_14_from_0 [0:12];
    (* ram_style = "distributed" *)
    reg [95:0] delay_14_from_0_copy2 [0:12];
    (* ram_style = "distributed" *)
    reg [95:0] delay_30_from_0 [0:28];
    (* ram_style = "distributed" *)
    reg [95:0] delay_30_from_0_copy2 [0:28];
    (* ram_style = "distributed" *)
    reg [15:0] delay_30_from_0_copy3 [0:28];
    (* ram_style = "distributed" *)
    reg [16:0] delay_31_from_0 [0:29];
    reg [6:0] credits;
    reg [2:0] delay_6_from_0_pointer;
    reg [95:0] delay_6_from_0_out;
    reg [2:0] delay_6_from_0_copy2_pointer;
    reg [95:0] delay_6_from_0_copy2_out;
    reg [2:0] delay_6_from_0_copy3_pointer;
    reg [95:0] delay_6_from_0_copy3_out;
    reg [2:0] delay_6_from_0_copy4_pointer;
    reg [31:0] delay_6_from_0_copy4_out;
    reg [2:0] delay_8_from_0_pointer;
    reg [63:0] delay_8_from_0_out;
    reg [3:0] delay_14_from_0_pointer;
    reg [95:0] delay_14_from_0_out;
    reg [3:0] delay_14_from_0_copy2_pointer;
    reg [95:0] delay_14_from_0_copy2_out;
    reg [4:0] delay_30_from_0_pointer;
    reg [95:0] delay_30_from_0_out;
    reg [4:0] delay_30_from_0_copy2_pointer;
    reg [95:0] delay_30_from_0_copy2_out;
    reg [4:0] delay_30_from_0_copy3_pointer;
    reg [15:0] delay_30_from_0_copy3_out;
    reg [4:0] delay_31_from_0_pointer;
    reg [16:0] delay_31_from_0_out;
    reg [15:0] attribute_0_d1, attribute_1_d1, attribute_2_d1, attribute_3_d1, attribute_4_d1, attribute_5_d1;
    reg [15:0] attribute_6_d1, attribute_7_d1, attribute_8_d1, attribute_9_d1, attribute_10_d1, attribute_11_d1;
    reg [15:0] attribute_12_d1;
    reg [31:0] u_z_d7, u_z_d8, kept_joined_d1;
    reg kept_greater_bits_is_zero_d1;
    reg [31:0] kept_chosen_d1, kept_chosen_d2, kept_chosen_d3;
    reg attribute_0_bits_is_31_d1;
    reg [15:0] attribute_0_out_chosen_d1;
    reg attribute_1_bits_is_31_d1;
    reg [15:0] attribute_1_out_chosen_d1;
    reg attribute_2_bits_is_31_d1;
    reg [15:0] attribute_2_out_chosen_d1;
    reg attribute_3_bits_is_31_d1;
    reg [15:0] attribute_3_out_chosen_d1;
    reg attribute_4_bits_is_31_d1;
    reg [15:0] attribute_4_out_chosen_d1;
    reg attribute_5_bits_is_31_d1;
    reg [15:0] attribute_5_out_chosen_d1;
    reg attribute_6_bits_is_31_d1;
    reg [15:0] attribute_6_out_chosen_d1;
    reg attribute_7_bits_is_31_d1;
    reg [15:0] attribute_7_out_chosen_d1;
    reg attribute_8_bits_is_31_d1;
    reg [15:0] attribute_8_out_chosen_d1;
    reg attribute_9_bits_is_31_d1;
    reg [15:0] attribute_9_out_chosen_d1;
    reg attribute_10_bits_is_31_d1;
    reg [15:0] attribute_10_out_chosen_d1;
    reg attribute_11_bits_is_31_d1;
    reg [15:0] attribute_11_out_chosen_d1;
    reg attribute_12_bits_is_31_d1;
    reg [15:0] attribute_12_out_chosen_d1;
    reg [30:0] in_flight;
    reg left, dropped;

    wire [31:0] mul_f32_ftz_unit_y, mul_f32_ftz_unit_copy2_y, mul_f32_ftz_unit_copy3_y, mul_f32_ftz_unit_copy4_y;
    wire [31:0] mul_f32_ftz_unit_copy5_y, mul_f32_ftz_unit_copy6_y, mul_f32_ftz_unit_copy7_y;
    wire [31:0] mul_f32_ftz_unit_copy8_y, mul_f32_ftz_unit_copy9_y, mul_f32_ftz_unit_copy10_y;
    wire [31:0] mul_f32_ftz_unit_copy11_y, mul_f32_ftz_unit_copy12_y, mul_f32_ftz_unit_copy13_y;
    wire [31:0] mul_f32_ftz_unit_copy14_y, mul_f32_ftz_unit_copy15_y, mul_f32_ftz_unit_copy16_y;
    wire [31:0] mul_f32_ftz_unit_copy17_y, mul_f32_ftz_unit_copy18_y, mul_f32_ftz_unit_copy19_y;
    wire [31:0] mul_f32_ftz_unit_copy20_y, mul_f32_ftz_unit_copy21_y, mul_f32_ftz_unit_copy22_y;
    wire [31:0] mul_f32_ftz_unit_copy23_y, mul_f32_ftz_unit_copy24_y, mul_f32_ftz_unit_copy25_y;
    wire [31:0] mul_f32_ftz_unit_copy26_y, mul_f32_ftz_unit_copy27_y, add_f32_ftz_unit_y, add_f32_ftz_unit_copy2_y;
    wire [31:0] add_f32_ftz_unit_copy3_y, add_f32_ftz_unit_copy4_y, add_f32_ftz_unit_copy5_y;
    wire [31:0] add_f32_ftz_unit_copy6_y, add_f32_ftz_unit_copy7_y, add_f32_ftz_unit_copy8_y;
    wire [31:0] add_f32_ftz_unit_copy9_y, add_f32_ftz_unit_copy10_y, add_f32_ftz_unit_copy11_y;
    wire [31:0] add_f32_ftz_unit_copy12_y, add_f32_ftz_unit_copy13_y, add_f32_ftz_unit_copy14_y;
    wire [31:0] add_f32_ftz_unit_copy15_y, add_f32_ftz_unit_copy16_y, add_f32_ftz_unit_copy17_y;
    wire [31:0] add_f32_ftz_unit_copy18_y, add_f32_ftz_unit_copy19_y, add_f32_ftz_unit_copy20_y;
    wire [31:0] add_f32_ftz_unit_copy21_y, add_f32_ftz_unit_copy22_y;
    wire lt_f32_ftz_unit_y, lt_f32_ftz_unit_copy2_y;
    wire [31:0] max_f32_ftz_unit_y;
    wire queue_1_in_ready;
    wire [96:0] queue_1_out_data;
    wire queue_2_in_ready, queue_2_out_valid;
    wire [127:0] queue_2_out_data;
    wire queue_3_in_ready, queue_3_out_valid;
    wire [127:0] queue_3_out_data;
    wire queue_4_in_ready, queue_4_out_valid;
    wire [127:0] queue_4_out_data;
    wire queue_5_in_ready, queue_5_out_valid;
    wire [31:0] queue_5_out_data;

    assign in_ready = ~credits[6];
    wire [31:0] m02_times_center_z_d6 = delay_6_from_0_out[31:0];
    wire [31:0] m12_times_center_z_d6 = delay_6_from_0_out[63:32];
    wire [31:0] m22_times_center_z_d6 = delay_6_from_0_out[95:64];
    wire [31:0] m02_times_tangent1_z_d6 = delay_6_from_0_copy2_out[63:32];
    wire [31:0] m12_times_tangent1_z_d6 = delay_6_from_0_copy2_out[95:64];
    wire [31:0] m22_times_tangent1_z_d6 = delay_6_from_0_copy3_out[31:0];
    wire [31:0] m02_times_tangent2_z_d6 = delay_6_from_0_copy3_out[63:32];
    wire [31:0] m12_times_tangent2_z_d6 = delay_6_from_0_copy3_out[95:64];
    wire [31:0] u_z_d6 = delay_6_from_0_copy2_out[31:0];
    wire end_d31 = delay_31_from_0_out[0];
    wire kept_either = lt_f32_ftz_unit_y | lt_f32_ftz_unit_copy2_y;
    wire end_or_kept_either = end_d31 | kept_either;
    wire kept = in_flight[30] & end_or_kept_either;
    wire [31:0] u_x_d8 = delay_8_from_0_out[31:0];
    wire [31:0] u_y_d8 = delay_8_from_0_out[63:32];
    wire [31:0] v1_x_d14 = delay_14_from_0_out[31:0];
    wire [31:0] v1_y_d14 = delay_14_from_0_out[63:32];
    wire [31:0] v1_z_d14 = delay_14_from_0_out[95:64];
    wire [31:0] v2_x_d14 = delay_14_from_0_copy2_out[31:0];
    wire [31:0] v2_y_d14 = delay_14_from_0_copy2_out[63:32];
    wire [31:0] v2_z_d14 = delay_14_from_0_copy2_out[95:64];
    wire [15:0] attribute_0_out_d30 = delay_30_from_0_out[15:0];
    wire [15:0] attribute_1_out_d30 = delay_30_from_0_out[31:16];
    wire [15:0] attribute_2_out_d30 = delay_30_from_0_out[47:32];
    wire [15:0] attribute_3_out_d30 = delay_30_from_0_out[63:48];
    wire [15:0] attribute_4_out_d30 = delay_30_from_0_out[79:64];
    wire [15:0] attribute_5_out_d30 = delay_30_from_0_out[95:80];
    wire [15:0] attribute_6_out_d30 = delay_30_from_0_copy2_out[15:0];
    wire [15:0] attribute_7_out_d30 = delay_30_from_0_copy2_out[31:16];
    wire [15:0] attribute_8_out_d30 = delay_30_from_0_copy2_out[47:32];
    wire [15:0] attribute_9_out_d30 = delay_30_from_0_copy2_out[63:48];
    wire [15:0] attribute_10_out_d30 = delay_30_from_0_copy2_out[79:64];
    wire [15:0] attribute_11_out_d30 = delay_30_from_0_copy2_out[95:80];
    wire [15:0] cardinal_0_d31 = delay_31_from_0_out[16:1];
    wire in_valid_and_in_ready = in_valid & in_ready;
    wire kept_greater_bits_is_255 = max_f32_ftz_unit_y[30:23] == 8'd255;
    wire [7:0] kept_greater_bits_plus_1 = max_f32_ftz_unit_y[30:23] + 8'd1;
    wire [7:0] kept_chosen = kept_greater_bits_is_255 ? max_f32_ftz_unit_y[30:23] : kept_greater_bits_plus_1;
    wire kept_greater_bits_is_254 = max_f32_ftz_unit_y[30:23] == 8'd254;
    wire [22:0] kept_chosen_copy2 = kept_greater_bits_is_254 ? 23'd0 : max_f32_ftz_unit_y[22:0];
    wire kept_greater_bits_is_zero = max_f32_ftz_unit_y[30:23] == 8'd0;
    wire [31:0] kept_chosen_copy3 = kept_greater_bits_is_zero_d1 ? 32'd0 : kept_joined_d1;
    wire attribute_0_bits_is_31 = in_attribute_0[14:10] == 5'd31;
    wire attribute_0_bits_is_zero = in_attribute_0[9:0] == 10'd0;
    wire [15:0] attribute_0_out_chosen = attribute_0_bits_is_zero ? {in_attribute_0[15], 15'h7bff} : 16'd0;
    wire attribute_1_bits_is_31 = 5'd31 == in_attribute_1[14:10];
    wire zero_is_attribute_1_bits = 10'd0 == in_attribute_1[9:0];
    wire [15:0] attribute_1_out_chosen = zero_is_attribute_1_bits ? {in_attribute_1[15], 15'h7bff} : 16'd0;
    wire attribute_2_bits_is_31 = 5'd31 == in_attribute_2[14:10];
    wire zero_is_attribute_2_bits = 10'd0 == in_attribute_2[9:0];
    wire [15:0] attribute_2_out_chosen = zero_is_attribute_2_bits ? {in_attribute_2[15], 15'h7bff} : 16'd0;
    wire attribute_3_bits_is_31 = 5'd31 == in_attribute_3[14:10];
    wire zero_is_attribute_3_bits = 10'd0 == in_attribute_3[9:0];
    wire [15:0] attribute_3_out_chosen = zero_is_attribute_3_bits ? {in_attribute_3[15], 15'h7bff} : 16'd0;
    wire attribute_4_bits_is_31 = 5'd31 == in_attribute_4[14:10];
    wire zero_is_attribute_4_bits = 10'd0 == in_attribute_4[9:0];
    wire [15:0] attribute_4_out_chosen = zero_is_attribute_4_bits ? {in_attribute_4[15], 15'h7bff} : 16'd0;
    wire attribute_5_bits_is_31 = 5'd31 == in_attribute_5[14:10];
    wire zero_is_attribute_5_bits = 10'd0 == in_attribute_5[9:0];
    wire [15:0] attribute_5_out_chosen = zero_is_attribute_5_bits ? {in_attribute_5[15], 15'h7bff} : 16'd0;
    wire attribute_6_bits_is_31 = 5'd31 == in_attribute_6[14:10];
    wire zero_is_attribute_6_bits = 10'd0 == in_attribute_6[9:0];
    wire [15:0] attribute_6_out_chosen = zero_is_attribute_6_bits ? {in_attribute_6[15], 15'h7bff} : 16'd0;
    wire attribute_7_bits_is_31 = 5'd31 == in_attribute_7[14:10];
    wire zero_is_attribute_7_bits = 10'd0 == in_attribute_7[9:0];
    wire [15:0] attribute_7_out_chosen = zero_is_attribute_7_bits ? {in_attribute_7[15], 15'h7bff} : 16'd0;
    wire attribute_8_bits_is_31 = 5'd31 == in_attribute_8[14:10];
    wire zero_is_attribute_8_bits = 10'd0 == in_attribute_8[9:0];
    wire [15:0] attribute_8_out_chosen = zero_is_attribute_8_bits ? {in_attribute_8[15], 15'h7bff} : 16'd0;
    wire attribute_9_bits_is_31 = 5'd31 == in_attribute_9[14:10];
    wire zero_is_attribute_9_bits = 10'd0 == in_attribute_9[9:0];
    wire [15:0] attribute_9_out_chosen = zero_is_attribute_9_bits ? {in_attribute_9[15], 15'h7bff} : 16'd0;
    wire attribute_10_bits_is_31 = 5'd31 == in_attribute_10[14:10];
    wire zero_is_attribute_10_bits = 10'd0 == in_attribute_10[9:0];
    wire [15:0] attribute_10_out_chosen = zero_is_attribute_10_bits ? {in_attribute_10[15], 15'h7bff} : 16'd0;
    wire attribute_11_bits_is_31 = 5'd31 == in_attribute_11[14:10];
    wire zero_is_attribute_11_bits = 10'd0 == in_attribute_11[9:0];
    wire [15:0] attribute_11_out_chosen = zero_is_attribute_11_bits ? {in_attribute_11[15], 15'h7bff} : 16'd0;
    wire attribute_12_bits_is_31 = 5'd31 == in_attribute_12[14:10];
    wire zero_is_attribute_12_bits = 10'd0 == in_attribute_12[9:0];
    wire [15:0] attribute_12_out_chosen = zero_is_attribute_12_bits ? {in_attribute_12[15], 15'h7bff} : 16'd0;
    wire [15:0] attribute_5_out = attribute_5_bits_is_31_d1 ? attribute_5_out_chosen_d1 : attribute_5_d1;
    wire [15:0] attribute_4_out = attribute_4_bits_is_31_d1 ? attribute_4_out_chosen_d1 : attribute_4_d1;
    wire [15:0] attribute_3_out = attribute_3_bits_is_31_d1 ? attribute_3_out_chosen_d1 : attribute_3_d1;
    wire [15:0] attribute_2_out = attribute_2_bits_is_31_d1 ? attribute_2_out_chosen_d1 : attribute_2_d1;
    wire [15:0] attribute_1_out = attribute_1_bits_is_31_d1 ? attribute_1_out_chosen_d1 : attribute_1_d1;
    wire [15:0] attribute_0_out = attribute_0_bits_is_31_d1 ? attribute_0_out_chosen_d1 : attribute_0_d1;
    wire [15:0] attribute_11_out = attribute_11_bits_is_31_d1 ? attribute_11_out_chosen_d1 : attribute_11_d1;
    wire [15:0] attribute_10_out = attribute_10_bits_is_31_d1 ? attribute_10_out_chosen_d1 : attribute_10_d1;
    wire [15:0] attribute_9_out = attribute_9_bits_is_31_d1 ? attribute_9_out_chosen_d1 : attribute_9_d1;
    wire [15:0] attribute_8_out = attribute_8_bits_is_31_d1 ? attribute_8_out_chosen_d1 : attribute_8_d1;
    wire [15:0] attribute_7_out = attribute_7_bits_is_31_d1 ? attribute_7_out_chosen_d1 : attribute_7_d1;
    wire [15:0] attribute_6_out = attribute_6_bits_is_31_d1 ? attribute_6_out_chosen_d1 : attribute_6_d1;
    wire [15:0] attribute_12_out = attribute_12_bits_is_31_d1 ? attribute_12_out_chosen_d1 : attribute_12_d1;

    assign {out_end, out_center_x, out_center_y, out_center_z} = queue_1_out_data;
    assign {out_tangent1_x, out_tangent1_y, out_tangent1_z, out_tangent2_x} = queue_2_out_data;
    assign {out_tangent2_y, out_tangent2_z, out_attribute_0, out_attribute_1, out_attribute_2, out_attribute_3} = queue_3_out_data;
    assign {
        out_attribute_4, out_attribute_5, out_attribute_6, out_attribute_7, out_attribute_8, out_attribute_9,
        out_attribute_10, out_attribute_11
    } = queue_4_out_data;
    assign {out_attribute_12, out_cardinal_0} = queue_5_out_data;

    float_mul_s5_f32ftz mul_f32_ftz_unit (
        .clk(clk), .enable(1'd1), .a(m00), .b(in_center_x), .y(mul_f32_ftz_unit_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(m01), .b(in_center_y), .y(mul_f32_ftz_unit_copy2_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy3 (
        .clk(clk), .enable(1'd1), .a(m02), .b(in_center_z), .y(mul_f32_ftz_unit_copy3_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy4 (
        .clk(clk), .enable(1'd1), .a(m10), .b(in_center_x), .y(mul_f32_ftz_unit_copy4_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy5 (
        .clk(clk), .enable(1'd1), .a(m11), .b(in_center_y), .y(mul_f32_ftz_unit_copy5_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy6 (
        .clk(clk), .enable(1'd1), .a(m12), .b(in_center_z), .y(mul_f32_ftz_unit_copy6_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy7 (
        .clk(clk), .enable(1'd1), .a(m20), .b(in_center_x), .y(mul_f32_ftz_unit_copy7_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy8 (
        .clk(clk), .enable(1'd1), .a(m21), .b(in_center_y), .y(mul_f32_ftz_unit_copy8_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy9 (
        .clk(clk), .enable(1'd1), .a(m22), .b(in_center_z), .y(mul_f32_ftz_unit_copy9_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy10 (
        .clk(clk), .enable(1'd1), .a(m00), .b(in_tangent1_x), .y(mul_f32_ftz_unit_copy10_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy11 (
        .clk(clk), .enable(1'd1), .a(m01), .b(in_tangent1_y), .y(mul_f32_ftz_unit_copy11_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy12 (
        .clk(clk), .enable(1'd1), .a(m02), .b(in_tangent1_z), .y(mul_f32_ftz_unit_copy12_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy13 (
        .clk(clk), .enable(1'd1), .a(m10), .b(in_tangent1_x), .y(mul_f32_ftz_unit_copy13_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy14 (
        .clk(clk), .enable(1'd1), .a(m11), .b(in_tangent1_y), .y(mul_f32_ftz_unit_copy14_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy15 (
        .clk(clk), .enable(1'd1), .a(m12), .b(in_tangent1_z), .y(mul_f32_ftz_unit_copy15_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy16 (
        .clk(clk), .enable(1'd1), .a(m20), .b(in_tangent1_x), .y(mul_f32_ftz_unit_copy16_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy17 (
        .clk(clk), .enable(1'd1), .a(m21), .b(in_tangent1_y), .y(mul_f32_ftz_unit_copy17_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy18 (
        .clk(clk), .enable(1'd1), .a(m22), .b(in_tangent1_z), .y(mul_f32_ftz_unit_copy18_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy19 (
        .clk(clk), .enable(1'd1), .a(m00), .b(in_tangent2_x), .y(mul_f32_ftz_unit_copy19_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy20 (
        .clk(clk), .enable(1'd1), .a(m01), .b(in_tangent2_y), .y(mul_f32_ftz_unit_copy20_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy21 (
        .clk(clk), .enable(1'd1), .a(m02), .b(in_tangent2_z), .y(mul_f32_ftz_unit_copy21_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy22 (
        .clk(clk), .enable(1'd1), .a(m10), .b(in_tangent2_x), .y(mul_f32_ftz_unit_copy22_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy23 (
        .clk(clk), .enable(1'd1), .a(m11), .b(in_tangent2_y), .y(mul_f32_ftz_unit_copy23_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy24 (
        .clk(clk), .enable(1'd1), .a(m12), .b(in_tangent2_z), .y(mul_f32_ftz_unit_copy24_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy25 (
        .clk(clk), .enable(1'd1), .a(m20), .b(in_tangent2_x), .y(mul_f32_ftz_unit_copy25_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy26 (
        .clk(clk), .enable(1'd1), .a(m21), .b(in_tangent2_y), .y(mul_f32_ftz_unit_copy26_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy27 (
        .clk(clk), .enable(1'd1), .a(m22), .b(in_tangent2_z), .y(mul_f32_ftz_unit_copy27_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_y), .b(mul_f32_ftz_unit_copy2_y),
        .y(add_f32_ftz_unit_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_y), .b(m02_times_center_z_d6),
        .y(add_f32_ftz_unit_copy2_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy3 (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_copy4_y), .b(mul_f32_ftz_unit_copy5_y),
        .y(add_f32_ftz_unit_copy3_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy4 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy3_y), .b(m12_times_center_z_d6),
        .y(add_f32_ftz_unit_copy4_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy5 (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_copy7_y), .b(mul_f32_ftz_unit_copy8_y),
        .y(add_f32_ftz_unit_copy5_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy6 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy5_y), .b(m22_times_center_z_d6),
        .y(add_f32_ftz_unit_copy6_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy7 (
        .clk(clk), .enable(1'd1), .a(m03), .b(add_f32_ftz_unit_copy2_y), .y(add_f32_ftz_unit_copy7_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy8 (
        .clk(clk), .enable(1'd1), .a(m13), .b(add_f32_ftz_unit_copy4_y), .y(add_f32_ftz_unit_copy8_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy9 (
        .clk(clk), .enable(1'd1), .a(m23), .b(add_f32_ftz_unit_copy6_y), .y(add_f32_ftz_unit_copy9_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy10 (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_copy10_y), .b(mul_f32_ftz_unit_copy11_y),
        .y(add_f32_ftz_unit_copy10_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy11 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy10_y), .b(m02_times_tangent1_z_d6),
        .y(add_f32_ftz_unit_copy11_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy12 (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_copy13_y), .b(mul_f32_ftz_unit_copy14_y),
        .y(add_f32_ftz_unit_copy12_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy13 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy12_y), .b(m12_times_tangent1_z_d6),
        .y(add_f32_ftz_unit_copy13_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy14 (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_copy16_y), .b(mul_f32_ftz_unit_copy17_y),
        .y(add_f32_ftz_unit_copy14_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy15 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy14_y), .b(m22_times_tangent1_z_d6),
        .y(add_f32_ftz_unit_copy15_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy16 (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_copy19_y), .b(mul_f32_ftz_unit_copy20_y),
        .y(add_f32_ftz_unit_copy16_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy17 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy16_y), .b(m02_times_tangent2_z_d6),
        .y(add_f32_ftz_unit_copy17_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy18 (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_copy22_y), .b(mul_f32_ftz_unit_copy23_y),
        .y(add_f32_ftz_unit_copy18_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy19 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy18_y), .b(m12_times_tangent2_z_d6),
        .y(add_f32_ftz_unit_copy19_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy20 (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_copy25_y), .b(mul_f32_ftz_unit_copy26_y),
        .y(add_f32_ftz_unit_copy20_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy21 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy20_y), .b(delay_6_from_0_copy4_out),
        .y(add_f32_ftz_unit_copy21_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy22 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy9_y), .b(kept_chosen_d3),
        .y(add_f32_ftz_unit_copy22_y)
    );

    float_lt_s2_f32ftz lt_f32_ftz_unit (
        .clk(clk), .enable(1'd1), .a(near_plane), .b(u_z_d6), .y(lt_f32_ftz_unit_y)
    );

    float_lt_s2_f32ftz lt_f32_ftz_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(near_plane), .b(add_f32_ftz_unit_copy22_y), .y(lt_f32_ftz_unit_copy2_y)
    );

    float_max_s2_f32ftz max_f32_ftz_unit (
        .clk(clk), .enable(1'd1), .a({1'd0, add_f32_ftz_unit_copy15_y[30:0]}),
        .b({1'd0, add_f32_ftz_unit_copy21_y[30:0]}), .y(max_f32_ftz_unit_y)
    );

    stream_fifo_d35_w97_distributed queue_1 (
        .clk(clk), .rst(rst), .in_valid(kept), .in_ready(queue_1_in_ready),
        .in_data({end_d31, u_x_d8, u_y_d8, u_z_d8}),
        .out_valid(out_valid), .out_ready(out_ready), .out_data(queue_1_out_data)
    );

    stream_fifo_d35_w128_distributed queue_2 (
        .clk(clk), .rst(rst), .in_valid(kept), .in_ready(queue_2_in_ready),
        .in_data({v1_x_d14, v1_y_d14, v1_z_d14, v2_x_d14}),
        .out_valid(queue_2_out_valid), .out_ready(out_ready), .out_data(queue_2_out_data)
    );

    stream_fifo_d35_w128_distributed queue_3 (
        .clk(clk), .rst(rst), .in_valid(kept), .in_ready(queue_3_in_ready),
        .in_data({
            v2_y_d14, v2_z_d14, attribute_0_out_d30, attribute_1_out_d30, attribute_2_out_d30,
            attribute_3_out_d30
        }),
        .out_valid(queue_3_out_valid), .out_ready(out_ready), .out_data(queue_3_out_data)
    );

    stream_fifo_d35_w128_distributed queue_4 (
        .clk(clk), .rst(rst), .in_valid(kept), .in_ready(queue_4_in_ready),
        .in_data({
            attribute_4_out_d30, attribute_5_out_d30, attribute_6_out_d30, attribute_7_out_d30,
            attribute_8_out_d30, attribute_9_out_d30, attribute_10_out_d30, attribute_11_out_d30
        }),
        .out_valid(queue_4_out_valid), .out_ready(out_ready), .out_data(queue_4_out_data)
    );

    stream_fifo_d35_w32_distributed queue_5 (
        .clk(clk), .rst(rst), .in_valid(kept), .in_ready(queue_5_in_ready),
        .in_data({delay_30_from_0_copy3_out, cardinal_0_d31}),
        .out_valid(queue_5_out_valid), .out_ready(out_ready), .out_data(queue_5_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            credits <= 7'd34;
            delay_6_from_0_pointer <= 3'd0;
            delay_6_from_0_copy2_pointer <= 3'd0;
            delay_6_from_0_copy3_pointer <= 3'd0;
            delay_6_from_0_copy4_pointer <= 3'd0;
            delay_8_from_0_pointer <= 3'd0;
            delay_14_from_0_pointer <= 4'd0;
            delay_14_from_0_copy2_pointer <= 4'd0;
            delay_30_from_0_pointer <= 5'd0;
            delay_30_from_0_copy2_pointer <= 5'd0;
            delay_30_from_0_copy3_pointer <= 5'd0;
            delay_31_from_0_pointer <= 5'd0;
            in_flight <= 31'd0;
            left <= 1'd0;
            dropped <= 1'd0;
        end else begin
            credits <= (credits - {6'd0, in_valid_and_in_ready}) + {6'd0, left} + {6'd0, dropped};
            delay_6_from_0_pointer <= (delay_6_from_0_pointer == 3'd4) ? (delay_6_from_0_pointer - 3'd4) : (delay_6_from_0_pointer + 3'd1);
            delay_6_from_0_copy2_pointer <= (delay_6_from_0_copy2_pointer == 3'd4) ? (delay_6_from_0_copy2_pointer - 3'd4) : (delay_6_from_0_copy2_pointer + 3'd1);
            delay_6_from_0_copy3_pointer <= (delay_6_from_0_copy3_pointer == 3'd4) ? (delay_6_from_0_copy3_pointer - 3'd4) : (delay_6_from_0_copy3_pointer + 3'd1);
            delay_6_from_0_copy4_pointer <= (delay_6_from_0_copy4_pointer == 3'd4) ? (delay_6_from_0_copy4_pointer - 3'd4) : (delay_6_from_0_copy4_pointer + 3'd1);
            delay_8_from_0_pointer <= (delay_8_from_0_pointer == 3'd6) ? (delay_8_from_0_pointer - 3'd6) : (delay_8_from_0_pointer + 3'd1);
            delay_14_from_0_pointer <= (delay_14_from_0_pointer == 4'd12) ? (delay_14_from_0_pointer - 4'd12) : (delay_14_from_0_pointer + 4'd1);
            delay_14_from_0_copy2_pointer <= (delay_14_from_0_copy2_pointer == 4'd12) ? (delay_14_from_0_copy2_pointer - 4'd12) : (delay_14_from_0_copy2_pointer + 4'd1);
            delay_30_from_0_pointer <= (delay_30_from_0_pointer == 5'd28) ? (delay_30_from_0_pointer - 5'd28) : (delay_30_from_0_pointer + 5'd1);
            delay_30_from_0_copy2_pointer <= (delay_30_from_0_copy2_pointer == 5'd28) ? (delay_30_from_0_copy2_pointer - 5'd28) : (delay_30_from_0_copy2_pointer + 5'd1);
            delay_30_from_0_copy3_pointer <= (delay_30_from_0_copy3_pointer == 5'd28) ? (delay_30_from_0_copy3_pointer - 5'd28) : (delay_30_from_0_copy3_pointer + 5'd1);
            delay_31_from_0_pointer <= (delay_31_from_0_pointer == 5'd29) ? (delay_31_from_0_pointer - 5'd29) : (delay_31_from_0_pointer + 5'd1);
            in_flight <= {in_flight[29:0], in_valid_and_in_ready};
            left <= out_valid & out_ready;
            dropped <= in_flight[30] & ~end_or_kept_either;
        end
    end
    always @(posedge clk) begin
        attribute_0_d1 <= in_attribute_0;
        attribute_1_d1 <= in_attribute_1;
        attribute_2_d1 <= in_attribute_2;
        attribute_3_d1 <= in_attribute_3;
        attribute_4_d1 <= in_attribute_4;
        attribute_5_d1 <= in_attribute_5;
        attribute_6_d1 <= in_attribute_6;
        attribute_7_d1 <= in_attribute_7;
        attribute_8_d1 <= in_attribute_8;
        attribute_9_d1 <= in_attribute_9;
        attribute_10_d1 <= in_attribute_10;
        attribute_11_d1 <= in_attribute_11;
        attribute_12_d1 <= in_attribute_12;
        u_z_d7 <= u_z_d6;
        u_z_d8 <= u_z_d7;
        kept_joined_d1 <= {1'd0, kept_chosen, kept_chosen_copy2};
        kept_greater_bits_is_zero_d1 <= kept_greater_bits_is_zero;
        kept_chosen_d1 <= kept_chosen_copy3;
        kept_chosen_d2 <= kept_chosen_d1;
        kept_chosen_d3 <= kept_chosen_d2;
        attribute_0_bits_is_31_d1 <= attribute_0_bits_is_31;
        attribute_0_out_chosen_d1 <= attribute_0_out_chosen;
        attribute_1_bits_is_31_d1 <= attribute_1_bits_is_31;
        attribute_1_out_chosen_d1 <= attribute_1_out_chosen;
        attribute_2_bits_is_31_d1 <= attribute_2_bits_is_31;
        attribute_2_out_chosen_d1 <= attribute_2_out_chosen;
        attribute_3_bits_is_31_d1 <= attribute_3_bits_is_31;
        attribute_3_out_chosen_d1 <= attribute_3_out_chosen;
        attribute_4_bits_is_31_d1 <= attribute_4_bits_is_31;
        attribute_4_out_chosen_d1 <= attribute_4_out_chosen;
        attribute_5_bits_is_31_d1 <= attribute_5_bits_is_31;
        attribute_5_out_chosen_d1 <= attribute_5_out_chosen;
        attribute_6_bits_is_31_d1 <= attribute_6_bits_is_31;
        attribute_6_out_chosen_d1 <= attribute_6_out_chosen;
        attribute_7_bits_is_31_d1 <= attribute_7_bits_is_31;
        attribute_7_out_chosen_d1 <= attribute_7_out_chosen;
        attribute_8_bits_is_31_d1 <= attribute_8_bits_is_31;
        attribute_8_out_chosen_d1 <= attribute_8_out_chosen;
        attribute_9_bits_is_31_d1 <= attribute_9_bits_is_31;
        attribute_9_out_chosen_d1 <= attribute_9_out_chosen;
        attribute_10_bits_is_31_d1 <= attribute_10_bits_is_31;
        attribute_10_out_chosen_d1 <= attribute_10_out_chosen;
        attribute_11_bits_is_31_d1 <= attribute_11_bits_is_31;
        attribute_11_out_chosen_d1 <= attribute_11_out_chosen;
        attribute_12_bits_is_31_d1 <= attribute_12_bits_is_31;
        attribute_12_out_chosen_d1 <= attribute_12_out_chosen;
    end
    always @(posedge clk) begin
        delay_6_from_0[delay_6_from_0_pointer] <= {mul_f32_ftz_unit_copy9_y, mul_f32_ftz_unit_copy6_y, mul_f32_ftz_unit_copy3_y};
        delay_6_from_0_out <= delay_6_from_0[delay_6_from_0_pointer];
    end
    always @(posedge clk) begin
        delay_6_from_0_copy2[delay_6_from_0_copy2_pointer] <= {mul_f32_ftz_unit_copy15_y, mul_f32_ftz_unit_copy12_y, add_f32_ftz_unit_copy9_y};
        delay_6_from_0_copy2_out <= delay_6_from_0_copy2[delay_6_from_0_copy2_pointer];
    end
    always @(posedge clk) begin
        delay_6_from_0_copy3[delay_6_from_0_copy3_pointer] <= {mul_f32_ftz_unit_copy24_y, mul_f32_ftz_unit_copy21_y, mul_f32_ftz_unit_copy18_y};
        delay_6_from_0_copy3_out <= delay_6_from_0_copy3[delay_6_from_0_copy3_pointer];
    end
    always @(posedge clk) begin
        delay_6_from_0_copy4[delay_6_from_0_copy4_pointer] <= mul_f32_ftz_unit_copy27_y;
        delay_6_from_0_copy4_out <= delay_6_from_0_copy4[delay_6_from_0_copy4_pointer];
    end
    always @(posedge clk) begin
        delay_8_from_0[delay_8_from_0_pointer] <= {add_f32_ftz_unit_copy8_y, add_f32_ftz_unit_copy7_y};
        delay_8_from_0_out <= delay_8_from_0[delay_8_from_0_pointer];
    end
    always @(posedge clk) begin
        delay_14_from_0[delay_14_from_0_pointer] <= {add_f32_ftz_unit_copy15_y, add_f32_ftz_unit_copy13_y, add_f32_ftz_unit_copy11_y};
        delay_14_from_0_out <= delay_14_from_0[delay_14_from_0_pointer];
    end
    always @(posedge clk) begin
        delay_14_from_0_copy2[delay_14_from_0_copy2_pointer] <= {add_f32_ftz_unit_copy21_y, add_f32_ftz_unit_copy19_y, add_f32_ftz_unit_copy17_y};
        delay_14_from_0_copy2_out <= delay_14_from_0_copy2[delay_14_from_0_copy2_pointer];
    end
    always @(posedge clk) begin
        delay_30_from_0[delay_30_from_0_pointer] <= {
            attribute_5_out, attribute_4_out, attribute_3_out, attribute_2_out, attribute_1_out, attribute_0_out
        };
        delay_30_from_0_out <= delay_30_from_0[delay_30_from_0_pointer];
    end
    always @(posedge clk) begin
        delay_30_from_0_copy2[delay_30_from_0_copy2_pointer] <= {
            attribute_11_out, attribute_10_out, attribute_9_out, attribute_8_out, attribute_7_out,
            attribute_6_out
        };
        delay_30_from_0_copy2_out <= delay_30_from_0_copy2[delay_30_from_0_copy2_pointer];
    end
    always @(posedge clk) begin
        delay_30_from_0_copy3[delay_30_from_0_copy3_pointer] <= attribute_12_out;
        delay_30_from_0_copy3_out <= delay_30_from_0_copy3[delay_30_from_0_copy3_pointer];
    end
    always @(posedge clk) begin
        delay_31_from_0[delay_31_from_0_pointer] <= {in_cardinal_0, in_end};
        delay_31_from_0_out <= delay_31_from_0[delay_31_from_0_pointer];
    end

    wire _unused = &{
        1'b0, max_f32_ftz_unit_y[31], queue_1_in_ready, queue_2_in_ready, queue_2_out_valid, queue_3_in_ready,
        queue_3_out_valid, queue_4_in_ready, queue_4_out_valid, queue_5_in_ready, queue_5_out_valid
    };

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        queue_1_has_a_place_for_each_result: assert (~kept | queue_1_in_ready);
        queue_2_has_a_place_for_each_result: assert (~kept | queue_2_in_ready);
        queue_3_has_a_place_for_each_result: assert (~kept | queue_3_in_ready);
        queue_4_has_a_place_for_each_result: assert (~kept | queue_4_in_ready);
        queue_5_has_a_place_for_each_result: assert (~kept | queue_5_in_ready);
        queue_2_in_step: assert (queue_2_out_valid == out_valid);
        queue_3_in_step: assert (queue_3_out_valid == out_valid);
        queue_4_in_step: assert (queue_4_out_valid == out_valid);
        queue_5_in_step: assert (queue_5_out_valid == out_valid);
`else
        if (!(~kept | queue_1_in_ready)) begin
            $display("assertion failed: queue_1_has_a_place_for_each_result in %m"); $stop;
        end
        if (!(~kept | queue_2_in_ready)) begin
            $display("assertion failed: queue_2_has_a_place_for_each_result in %m"); $stop;
        end
        if (!(~kept | queue_3_in_ready)) begin
            $display("assertion failed: queue_3_has_a_place_for_each_result in %m"); $stop;
        end
        if (!(~kept | queue_4_in_ready)) begin
            $display("assertion failed: queue_4_has_a_place_for_each_result in %m"); $stop;
        end
        if (!(~kept | queue_5_in_ready)) begin
            $display("assertion failed: queue_5_has_a_place_for_each_result in %m"); $stop;
        end
        if (!(queue_2_out_valid == out_valid)) begin
            $display("assertion failed: queue_2_in_step in %m"); $stop;
        end
        if (!(queue_3_out_valid == out_valid)) begin
            $display("assertion failed: queue_3_in_step in %m"); $stop;
        end
        if (!(queue_4_out_valid == out_valid)) begin
            $display("assertion failed: queue_4_in_step in %m"); $stop;
        end
        if (!(queue_5_out_valid == out_valid)) begin
            $display("assertion failed: queue_5_in_step in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue in a memory with a registered output.
// depth = 35
// width = 32
// storage = distributed
module stream_fifo_d35_w32_distributed (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [31:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [31:0] out_data
);
    (* ram_style = "distributed" *)
    reg [31:0] entries [0:34];
    reg [5:0] held, waiting;
    reg is_full, any_waits;
    reg [5:0] write_address, read_address;
    reg [31:0] item;

    wire has_room = ~is_full;
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [5:0] held_bits = {{5{~push}}, 1'd1};
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    always @(posedge clk) begin
        if (rst) begin
            held <= 6'd0;
            waiting <= 6'd0;
            is_full <= 1'd0;
            any_waits <= 1'd0;
            write_address <= 6'd0;
            read_address <= 6'd0;
            out_valid <= 1'd0;
        end else begin
            if (push_xor_pop) begin
                held <= held + held_bits;
                is_full <= push & (held == 6'd34);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 6'd1);
            end
            if (push) write_address <= (write_address == 6'd34) ? 6'd0 : (write_address + 6'd1);
            if (fetch) read_address <= (read_address == 6'd34) ? 6'd0 : (read_address + 6'd1);
            out_valid <= fetch | (out_valid & ~out_ready);
        end
    end
    always @(posedge clk) begin
        if (has_room) entries[write_address] <= in_data;
        if (fetch) item <= entries[read_address];
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        held_in_range: assert (held <= 6'd35);
        held_is_waiting_and_shown: assert (held == (waiting + {5'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 6'd35)) & (any_waits == |waiting));
`else
        if (!(held <= 6'd35)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {5'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 6'd35)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue in a memory with a registered output.
// depth = 35
// width = 128
// storage = distributed
module stream_fifo_d35_w128_distributed (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [127:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [127:0] out_data
);
    (* ram_style = "distributed" *)
    reg [127:0] entries [0:34];
    reg [5:0] held, waiting;
    reg is_full, any_waits;
    reg [5:0] write_address, read_address;
    reg [127:0] item;

    wire has_room = ~is_full;
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [5:0] held_bits = {{5{~push}}, 1'd1};
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    always @(posedge clk) begin
        if (rst) begin
            held <= 6'd0;
            waiting <= 6'd0;
            is_full <= 1'd0;
            any_waits <= 1'd0;
            write_address <= 6'd0;
            read_address <= 6'd0;
            out_valid <= 1'd0;
        end else begin
            if (push_xor_pop) begin
                held <= held + held_bits;
                is_full <= push & (held == 6'd34);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 6'd1);
            end
            if (push) write_address <= (write_address == 6'd34) ? 6'd0 : (write_address + 6'd1);
            if (fetch) read_address <= (read_address == 6'd34) ? 6'd0 : (read_address + 6'd1);
            out_valid <= fetch | (out_valid & ~out_ready);
        end
    end
    always @(posedge clk) begin
        if (has_room) entries[write_address] <= in_data;
        if (fetch) item <= entries[read_address];
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        held_in_range: assert (held <= 6'd35);
        held_is_waiting_and_shown: assert (held == (waiting + {5'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 6'd35)) & (any_waits == |waiting));
`else
        if (!(held <= 6'd35)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {5'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 6'd35)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue in a memory with a registered output.
// depth = 35
// width = 97
// storage = distributed
module stream_fifo_d35_w97_distributed (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [96:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [96:0] out_data
);
    (* ram_style = "distributed" *)
    reg [96:0] entries [0:34];
    reg [5:0] held, waiting;
    reg is_full, any_waits;
    reg [5:0] write_address, read_address;
    reg [96:0] item;

    wire has_room = ~is_full;
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [5:0] held_bits = {{5{~push}}, 1'd1};
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    always @(posedge clk) begin
        if (rst) begin
            held <= 6'd0;
            waiting <= 6'd0;
            is_full <= 1'd0;
            any_waits <= 1'd0;
            write_address <= 6'd0;
            read_address <= 6'd0;
            out_valid <= 1'd0;
        end else begin
            if (push_xor_pop) begin
                held <= held + held_bits;
                is_full <= push & (held == 6'd34);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 6'd1);
            end
            if (push) write_address <= (write_address == 6'd34) ? 6'd0 : (write_address + 6'd1);
            if (fetch) read_address <= (read_address == 6'd34) ? 6'd0 : (read_address + 6'd1);
            out_valid <= fetch | (out_valid & ~out_ready);
        end
    end
    always @(posedge clk) begin
        if (has_room) entries[write_address] <= in_data;
        if (fetch) item <= entries[read_address];
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        held_in_range: assert (held <= 6'd35);
        held_is_waiting_and_shown: assert (held == (waiting + {5'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 6'd35)) & (any_waits == |waiting));
`else
        if (!(held <= 6'd35)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {5'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 6'd35)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Greater of two floating-point numbers.
// stages = 2
// format = f32-ftz
module float_max_s2_f32ftz (
    input  wire clk, input wire enable, input wire [31:0] a, input wire [31:0] b,
    output reg  [31:0] y
);
    reg a_nan_s1, b_nan_s1, less_s1;
    reg [31:0] a_s1, b_s1;

    always @(posedge clk) begin
        if (enable) begin
            a_nan_s1 <= &a[30:23] & |a[22:0];
            b_nan_s1 <= &b[30:23] & |b[22:0];
            less_s1 <= {~a[31], a[30:0] ^ {31{a[31]}}} < {~b[31], b[30:0] ^ {31{b[31]}}};
            a_s1 <= {a[31:23], a[22:0] & {23{|a[30:23]}}};
            b_s1 <= {b[31:23], b[22:0] & {23{|b[30:23]}}};
            y <= (a_nan_s1 & b_nan_s1) ? 32'h7fc00000 : (b_nan_s1 | (~a_nan_s1 & ~less_s1)) ? a_s1 : b_s1;
        end
    end
endmodule

// Whether one floating-point number is less than another.
// stages = 2
// format = f32-ftz
module float_lt_s2_f32ftz (
    input  wire clk, input wire enable, input wire [31:0] a, input wire [31:0] b,
    output reg  y
);
    reg unordered_s1, both_zero_s1, compared_s1;

    always @(posedge clk) begin
        if (enable) begin
            unordered_s1 <= (&a[30:23] & |a[22:0]) | (&b[30:23] & |b[22:0]);
            both_zero_s1 <= (a[30:23] == 8'd0) & (b[30:23] == 8'd0);
            compared_s1 <= {~a[31], a[30:0] ^ {31{a[31]}}} < {~b[31], b[30:0] ^ {31{b[31]}}};
            y <= compared_s1 & ~both_zero_s1 & ~unordered_s1;
        end
    end
endmodule

// Floating-point sum.
// stages = 6
// format = f32-ftz
module float_add_s6_f32ftz (
    input  wire clk, input wire enable, input wire [31:0] a, input wire [31:0] b,
    output reg  [31:0] y
);
    reg [9:0] distance_s1;
    reg [23:0] large_s1, small_s1, large_s2;
    reg [26:0] aligned_s2;
    reg subtract_s1, subtract_s2;
    reg [27:0] sum_s3;
    reg sign_s1, sign_s2, sign_s3, nan_s1, nan_s2, nan_s3, infinite_s1, infinite_s2, infinite_s3, subtract_s3;
    reg [27:0] value_s4;
    reg [4:0] zeros_s4;
    reg [9:0] limit_s1, limit_s2, limit_s3, limit_s4, exponent_s5;
    reg [25:0] significand_s5;
    reg sign_s4, sign_s5, nan_s4, nan_s5, infinite_s4, infinite_s5, zero_s4, zero_s5;

    wire swap = a[30:0] < b[30:0];
    wire [7:0] b_field = b[30:23];
    wire [7:0] a_field = a[30:23];
    wire large_s1_inverted = ~(|a_field);
    wire large_s1_inverted_2 = ~(|b_field);
    wire large_s1_inverted_3 = ~(large_s1_inverted & large_s1_inverted_2);
    wire [22:0] b_fraction = b[22:0];
    wire [22:0] a_fraction = a[22:0];
    wire small_s1_inverted = ~(large_s1_inverted | large_s1_inverted_2);
    wire [26:0] aligned_s2_choice = distance_s1[4] ? ({small_s1, 3'd0} >> 16) : {small_s1, 3'd0};
    wire [26:0] aligned_s2_choice_2 = distance_s1[3] ? (aligned_s2_choice >> 8) : aligned_s2_choice;
    wire [26:0] aligned_s2_choice_3 = distance_s1[2] ? (aligned_s2_choice_2 >> 4) : aligned_s2_choice_2;
    wire [26:0] aligned_s2_choice_4 = distance_s1[1] ? (aligned_s2_choice_3 >> 2) : aligned_s2_choice_3;
    wire [26:0] aligned_s2_choice_5 = distance_s1[0] ? (aligned_s2_choice_4 >> 1) : aligned_s2_choice_4;
    wire aligned_s2_either = (distance_s1[4] & |{small_s1[12:0], 3'd0}) | (distance_s1[3] & |aligned_s2_choice[7:0]);
    wire aligned_s2_either_2 = aligned_s2_either | (distance_s1[2] & |aligned_s2_choice_2[3:0]) | (distance_s1[1] & |aligned_s2_choice_3[1:0]);
    wire aligned_s2_either_3 = aligned_s2_choice_5[0] | (aligned_s2_either_2 | (distance_s1[0] & aligned_s2_choice_4[0]));
    wire a_31_xor_b_31 = a[31] ^ b[31];
    wire [28:0] sum_s3_sum = {1'd0, large_s2, 4'd1} + {{1'd0, aligned_s2} ^ {28{subtract_s2}}, subtract_s2};
    wire nan_s1_both = &a_field & (a_fraction == 23'd0);
    wire nan_s1_both_2 = &b_field & (b_fraction == 23'd0);
    wire zeros_s4_both = ~sum_s3[27] & ~sum_s3[26];
    wire zeros_s4_both_2 = zeros_s4_both & (~sum_s3[25] & ~sum_s3[24]);
    wire zeros_s4_both_3 = ~sum_s3[23] & ~sum_s3[22];
    wire zeros_s4_both_4 = zeros_s4_both_2 & (zeros_s4_both_3 & (~sum_s3[21] & ~sum_s3[20]));
    wire zeros_s4_both_5 = ~sum_s3[19] & ~sum_s3[18];
    wire zeros_s4_both_6 = zeros_s4_both_5 & (~sum_s3[17] & ~sum_s3[16]);
    wire zeros_s4_both_7 = ~sum_s3[15] & ~sum_s3[14];
    wire zeros_s4_both_8 = zeros_s4_both_6 & (zeros_s4_both_7 & (~sum_s3[13] & ~sum_s3[12]));
    wire zeros_s4_both_9 = zeros_s4_both_4 & zeros_s4_both_8;
    wire zeros_s4_both_10 = ~sum_s3[11] & ~sum_s3[10];
    wire zeros_s4_both_11 = zeros_s4_both_10 & (~sum_s3[9] & ~sum_s3[8]);
    wire not_sum_s3_7_and_not_sum_s3_6 = ~sum_s3[7] & ~sum_s3[6];
    wire zeros_s4_both_12 = zeros_s4_both_11 & (not_sum_s3_7_and_not_sum_s3_6 & (~sum_s3[5] & ~sum_s3[4]));
    wire not_sum_s3_3_and_not_sum_s3_2 = ~sum_s3[3] & ~sum_s3[2];
    wire zeros_s4_both_13 = not_sum_s3_3_and_not_sum_s3_2 & (~sum_s3[1] & ~sum_s3[0]);
    wire [1:0] zeros_s4_bits = {not_sum_s3_3_and_not_sum_s3_2, not_sum_s3_3_and_not_sum_s3_2 ? ~sum_s3[1] : ~sum_s3[3]};
    wire [1:0] zeros_s4_bits_2 = {not_sum_s3_7_and_not_sum_s3_6, not_sum_s3_7_and_not_sum_s3_6 ? ~sum_s3[5] : ~sum_s3[7]};
    wire [1:0] zeros_s4_choice = zeros_s4_both_11 ? zeros_s4_bits_2 : {zeros_s4_both_10, zeros_s4_both_10 ? ~sum_s3[9] : ~sum_s3[11]};
    wire [2:0] zeros_s4_choice_2 = zeros_s4_both_12 ? {zeros_s4_both_13, zeros_s4_both_13 ? 2'd0 : zeros_s4_bits} : {zeros_s4_both_11, zeros_s4_choice};
    wire [1:0] zeros_s4_choice_3 = zeros_s4_both_6 ? {zeros_s4_both_7, zeros_s4_both_7 ? ~sum_s3[13] : ~sum_s3[15]} : {zeros_s4_both_5, zeros_s4_both_5 ? ~sum_s3[17] : ~sum_s3[19]};
    wire [1:0] zeros_s4_choice_4 = zeros_s4_both_2 ? {zeros_s4_both_3, zeros_s4_both_3 ? ~sum_s3[21] : ~sum_s3[23]} : {zeros_s4_both, zeros_s4_both ? ~sum_s3[25] : ~sum_s3[27]};
    wire [2:0] zeros_s4_choice_5 = zeros_s4_both_4 ? {zeros_s4_both_6, zeros_s4_choice_3} : {zeros_s4_both_2, zeros_s4_choice_4};
    wire [3:0] zeros_s4_choice_6 = zeros_s4_both_9 ? {zeros_s4_both_12, zeros_s4_choice_2} : {zeros_s4_both_4, zeros_s4_choice_5};
    wire [27:0] value_s4_shifted_by_zeros_s4 = value_s4 << zeros_s4;
    wire sum_s3_is_0 = sum_s3 == 28'd0;
    wire y_both = (exponent_s5 == 10'd0) & ~(&significand_s5[24:2] & significand_s5[1]);
    wire round_up = significand_s5[1] & (significand_s5[0] | significand_s5[2]);
    wire [30:0] rounded = {exponent_s5[7:0], significand_s5[24:2]} + {30'd0, round_up};
    wire [30:0] y_choice = (infinite_s5 | (~exponent_s5[9] & (10'd255 <= exponent_s5))) ? 31'h7f800000 : rounded;
    wire [30:0] y_choice_2 = (zero_s5 | ((exponent_s5[9] | y_both) & ~infinite_s5)) ? 31'd0 : y_choice;

    always @(posedge clk) begin
        if (enable) begin
            distance_s1 <= swap ? ({2'd0, b_field} - {2'd0, a_field}) : ({2'd0, a_field} - {2'd0, b_field});
            large_s1 <= {large_s1_inverted_3, (swap ? b_fraction : a_fraction) & {23{large_s1_inverted_3}}};
            small_s1 <= {small_s1_inverted, (swap ? a_fraction : b_fraction) & {23{small_s1_inverted}}};
            large_s2 <= large_s1;
            aligned_s2 <= |distance_s1[7:5] ? {26'd0, |{small_s1, 3'd0}} : {aligned_s2_choice_5[26:1], aligned_s2_either_3};
            subtract_s1 <= a_31_xor_b_31;
            subtract_s2 <= subtract_s1;
            sum_s3 <= sum_s3_sum[28:1];
            sign_s1 <= swap ? b[31] : a[31];
            sign_s2 <= sign_s1;
            sign_s3 <= sign_s2;
            nan_s1 <= (&a_field & |a_fraction) | (&b_field & |b_fraction) | (nan_s1_both & nan_s1_both_2 & a_31_xor_b_31);
            nan_s2 <= nan_s1;
            nan_s3 <= nan_s2;
            infinite_s1 <= nan_s1_both | nan_s1_both_2;
            infinite_s2 <= infinite_s1;
            infinite_s3 <= infinite_s2;
            subtract_s3 <= subtract_s2;
            value_s4 <= sum_s3;
            zeros_s4 <= {zeros_s4_both_9, zeros_s4_choice_6};
            limit_s1 <= swap ? {2'd0, b_field} : {2'd0, a_field};
            limit_s2 <= limit_s1;
            limit_s3 <= limit_s2;
            limit_s4 <= limit_s3;
            exponent_s5 <= (limit_s4 + 10'd1) - {5'd0, zeros_s4};
            significand_s5 <= {value_s4_shifted_by_zeros_s4[27:3], |value_s4_shifted_by_zeros_s4[2:0]};
            sign_s4 <= sign_s3 & ~(sum_s3_is_0 & subtract_s3);
            sign_s5 <= sign_s4;
            nan_s4 <= nan_s3;
            nan_s5 <= nan_s4;
            infinite_s4 <= infinite_s3;
            infinite_s5 <= infinite_s4;
            zero_s4 <= sum_s3_is_0 & ~infinite_s3;
            zero_s5 <= zero_s4;
            y <= nan_s5 ? 32'h7fc00000 : {sign_s5, y_choice_2};
        end
    end

    wire _unused = &{1'b0, distance_s1[9:8], significand_s5[25], sum_s3_sum[0]};
endmodule

// Floating-point product.
// stages = 5
// format = f32-ftz
module float_mul_s5_f32ftz (
    input  wire clk, input wire enable, input wire [31:0] a, input wire [31:0] b,
    output reg  [31:0] y
);
    reg [23:0] left_s1, right_s1;
    reg [9:0] exponent_s1;
    reg [23:0] partial_0_0_s2, partial_0_12_s2, partial_12_0_s2, partial_12_12_s2;
    reg [47:0] product_s3;
    reg [9:0] exponent_s2, exponent_s3, exponent_s4;
    reg [25:0] significand_s4;
    reg sign_s1, sign_s2, sign_s3, sign_s4, nan_s1, nan_s2, nan_s3, nan_s4, infinite_s1, infinite_s2;
    reg infinite_s3, infinite_s4, zero_s1, zero_s2, zero_s3, zero_s4;

    wire [7:0] a_field = a[30:23];
    wire [22:0] a_fraction = a[22:0];
    wire [7:0] b_field = b[30:23];
    wire [22:0] b_fraction = b[22:0];
    wire [47:0] product_s3_sum = ({24'd0, partial_0_0_s2} | ({24'd0, partial_12_12_s2} << 24)) + ({24'd0, partial_0_12_s2} << 12);
    wire [47:0] significand_s4_choice = product_s3[47] ? product_s3 : (product_s3 << 1);
    wire nan_s1_both = &a_field & (a_fraction == 23'd0);
    wire nan_s1_inverted = ~(|b_field);
    wire nan_s1_either = (&a_field & |a_fraction) | (&b_field & |b_fraction) | (nan_s1_both & nan_s1_inverted);
    wire nan_s1_inverted_2 = ~(|a_field);
    wire nan_s1_both_2 = &b_field & (b_fraction == 23'd0);
    wire y_both = (exponent_s4 == 10'd0) & ~(&significand_s4[24:2] & significand_s4[1]);
    wire round_up = significand_s4[1] & (significand_s4[0] | significand_s4[2]);
    wire [30:0] rounded = {exponent_s4[7:0], significand_s4[24:2]} + {30'd0, round_up};
    wire [30:0] y_choice = (infinite_s4 | (~exponent_s4[9] & (10'd255 <= exponent_s4))) ? 31'h7f800000 : rounded;
    wire [30:0] y_choice_2 = (zero_s4 | ((exponent_s4[9] | y_both) & ~infinite_s4)) ? 31'd0 : y_choice;

    always @(posedge clk) begin
        if (enable) begin
            left_s1 <= {|a_field, a_fraction & {23{|a_field}}};
            right_s1 <= {|b_field, b_fraction & {23{|b_field}}};
            exponent_s1 <= {2'd0, a_field} + {2'd0, b_field};
            partial_0_0_s2 <= {12'd0, left_s1[11:0]} * {12'd0, right_s1[11:0]};
            partial_0_12_s2 <= {12'd0, left_s1[11:0]} * {12'd0, right_s1[23:12]};
            partial_12_0_s2 <= {12'd0, left_s1[23:12]} * {12'd0, right_s1[11:0]};
            partial_12_12_s2 <= {12'd0, left_s1[23:12]} * {12'd0, right_s1[23:12]};
            product_s3 <= product_s3_sum + ({24'd0, partial_12_0_s2} << 12);
            exponent_s2 <= exponent_s1 - 10'd127;
            exponent_s3 <= exponent_s2;
            exponent_s4 <= exponent_s3 + {9'd0, product_s3[47]};
            significand_s4 <= {significand_s4_choice[47:23], |significand_s4_choice[22:0]};
            sign_s1 <= a[31] ^ b[31];
            sign_s2 <= sign_s1;
            sign_s3 <= sign_s2;
            sign_s4 <= sign_s3;
            nan_s1 <= nan_s1_either | (nan_s1_inverted_2 & nan_s1_both_2);
            nan_s2 <= nan_s1;
            nan_s3 <= nan_s2;
            nan_s4 <= nan_s3;
            infinite_s1 <= nan_s1_both | nan_s1_both_2;
            infinite_s2 <= infinite_s1;
            infinite_s3 <= infinite_s2;
            infinite_s4 <= infinite_s3;
            zero_s1 <= nan_s1_inverted_2 | nan_s1_inverted;
            zero_s2 <= zero_s1;
            zero_s3 <= zero_s2;
            zero_s4 <= zero_s3;
            y <= nan_s4 ? 32'h7fc00000 : {sign_s4, y_choice_2};
        end
    end

    wire _unused = &{1'b0, significand_s4[25]};
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

// Memory with registered reads, in slices that are memories of the device each.
// A word that is read while it is written is the old one.
module memory_1w1r #(
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
            reg [BITS-1:0] words [0:DEPTH-1];
            reg [BITS-1:0] read_word;
            assign read_data[low +: BITS] = read_word;
            always @(posedge clk) begin
                if (write) words[write_address] <= write_data[low +: BITS];
                if (read) read_word <= words[read_address];
            end
        end
    endgenerate
endmodule
