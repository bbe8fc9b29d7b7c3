// The whole design is one file, named after its top.
/* verilator lint_off DECLFILENAME */

// Surface-splat renderer: splats in, normalized fragments out.
module splat_top (
    input  wire clk, input wire rst,
    input  wire uniform_valid,  // Write to a uniform register: after `frame_set_up` of the last frame and before the first splat of the next, `filter_scale` while no frame is under way.
    input  wire [4:0] uniform_address,  // Its place among the frame's uniforms.
    input  wire [23:0] uniform_data,  // Its new value.
    input  wire splat_valid, output wire splat_ready,  // Splats in world space.
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
    output reg  frame_set_up,  // All splats of a frame were set up in the last cycle.
    output wire read_valid, input wire read_ready,  // Request for pixels of a tile.
    output wire read_surface,  // The frame is one of those with odd numbers.
    output wire [11:0] read_tile,  // Tile index.
    output wire [5:0] read_pixel,  // The first pixel of the tile.
    output wire [3:0] read_count,  // How many there are, at least one.
    input  wire data_valid, output wire data_ready,  // The pixels requested, in order.
    input  wire [27:0] data_weight,  // Sum of weights.
    input  wire [51:0] data_depth,  // Sum of weighted depths.
    input  wire [39:0] data_attribute_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [39:0] data_attribute_1,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [39:0] data_attribute_2,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire write_valid, input wire write_ready,  // Pixels of evicted tiles.
    output wire write_surface,  // The frame is one of those with odd numbers: two have a place in the buffer.
    output wire [11:0] write_tile,  // Tile index.
    output wire [5:0] write_pixel,  // Pixel of the tile.
    output wire [27:0] write_weight,  // Sum of weights.
    output wire [51:0] write_depth,  // Sum of weighted depths.
    output wire [39:0] write_attribute_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [39:0] write_attribute_1,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [39:0] write_attribute_2,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire fragment_valid, input wire fragment_ready,  // Fragments of the image, each of one stream; a frame ends when all streams have ended it.
    output wire fragment_end,  // Closes the frame.
    output wire [8:0] fragment_column,  // Column of the image.
    output wire [8:0] fragment_row,  // Row of the image.
    output wire [23:0] fragment_depth,  // Depth in the geometry format.
    output wire [11:0] fragment_attribute_0,  // Attributes.
    output wire [11:0] fragment_attribute_1,  // Attributes.
    output wire [11:0] fragment_attribute_2,  // Attributes.
    output wire event_sample,  // Rasterizers that evaluated a sample.
    output wire event_starved,  // Rasterizers that had no copy to work on.
    output wire event_blocked,  // Rasterizers whose pipeline was held by what follows it.
    output wire event_accumulate,  // Accumulators that took a sample.
    output wire event_hazard,  // Accumulators that waited for an earlier sample of the same pixel.
    output wire event_slot_wait  // Accumulators that waited for a tile to arrive in the cache.
);
    reg [23:0] uniform_m00, uniform_m01, uniform_m02, uniform_m03, uniform_m10, uniform_m11, uniform_m12;
    reg [23:0] uniform_m13, uniform_m20, uniform_m21, uniform_m22, uniform_m23, uniform_scale_x, uniform_scale_y;
    reg [23:0] uniform_origin_x, uniform_origin_y, uniform_depth_a, uniform_depth_b, uniform_near_plane;
    reg [23:0] uniform_epsilon_scale, uniform_epsilon_bias, uniform_filter_radius;
    reg [15:0] uniform_filter_scale;

    wire transform_out_valid, transform_out_end;
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
    wire setup_out_sight_negative;
    wire [19:0] setup_out_sight_near, setup_out_sight_far;
    wire setup_out_sight_turned, setup_out_sight_disc;
    wire [23:0] setup_out_depth, setup_out_depth_low, setup_out_depth_high;
    wire [11:0] setup_out_attribute_0, setup_out_attribute_1, setup_out_attribute_2;
    wire [8:0] setup_out_left, setup_out_right, setup_out_top, setup_out_bottom;
    wire [9:0] setup_out_first_sum, setup_out_last_sum, setup_out_first_difference, setup_out_last_difference;
    wire splitter_in_ready, splitter_out_valid, splitter_out_end, splitter_out_first;
    wire [25:0] splitter_out_center_x, splitter_out_center_y;
    wire [15:0] splitter_out_ax, splitter_out_bx, splitter_out_ay, splitter_out_by;
    wire [19:0] splitter_out_delta;
    wire [15:0] splitter_out_mx, splitter_out_my;
    wire [3:0] splitter_out_shift;
    wire splitter_out_sight_negative;
    wire [19:0] splitter_out_sight_near, splitter_out_sight_far;
    wire splitter_out_sight_turned, splitter_out_sight_disc;
    wire [23:0] splitter_out_depth, splitter_out_depth_low, splitter_out_depth_high;
    wire [11:0] splitter_out_attribute_0, splitter_out_attribute_1, splitter_out_attribute_2;
    wire [2:0] splitter_out_left, splitter_out_right, splitter_out_top, splitter_out_bottom;
    wire [3:0] splitter_out_first_sum, splitter_out_last_sum, splitter_out_first_difference;
    wire [3:0] splitter_out_last_difference;
    wire [11:0] splitter_out_tile;
    wire lane_0_in_ready, lane_0_pixel_valid, lane_0_pixel_end;
    wire [11:0] lane_0_pixel_tile;
    wire [5:0] lane_0_pixel_pixel;
    wire [27:0] lane_0_pixel_weight;
    wire [51:0] lane_0_pixel_depth;
    wire [39:0] lane_0_pixel_attribute_0, lane_0_pixel_attribute_1, lane_0_pixel_attribute_2;
    wire normalizer_in_ready;

    splat_transform transform (
        .clk(clk), .rst(rst), .in_valid(splat_valid), .in_ready(splat_ready), .in_end(splat_end),
        .in_center_x(splat_center_x), .in_center_y(splat_center_y), .in_center_z(splat_center_z),
        .in_tangent1_x(splat_tangent1_x), .in_tangent1_y(splat_tangent1_y), .in_tangent1_z(splat_tangent1_z),
        .in_tangent2_x(splat_tangent2_x), .in_tangent2_y(splat_tangent2_y), .in_tangent2_z(splat_tangent2_z),
        .in_attribute_0(splat_attribute_0), .in_attribute_1(splat_attribute_1),
        .in_attribute_2(splat_attribute_2),
        .m00(uniform_m00), .m01(uniform_m01), .m02(uniform_m02), .m03(uniform_m03), .m10(uniform_m10),
        .m11(uniform_m11), .m12(uniform_m12), .m13(uniform_m13), .m20(uniform_m20), .m21(uniform_m21),
        .m22(uniform_m22), .m23(uniform_m23), .near_plane(uniform_near_plane),
        .out_valid(transform_out_valid), .out_ready(setup_in_ready), .out_end(transform_out_end),
        .out_center_x(transform_out_center_x), .out_center_y(transform_out_center_y),
        .out_center_z(transform_out_center_z), .out_tangent1_x(transform_out_tangent1_x),
        .out_tangent1_y(transform_out_tangent1_y), .out_tangent1_z(transform_out_tangent1_z),
        .out_tangent2_x(transform_out_tangent2_x), .out_tangent2_y(transform_out_tangent2_y),
        .out_tangent2_z(transform_out_tangent2_z), .out_attribute_0(transform_out_attribute_0),
        .out_attribute_1(transform_out_attribute_1), .out_attribute_2(transform_out_attribute_2)
    );

    splat_setup setup (
        .clk(clk), .rst(rst), .in_valid(transform_out_valid), .in_ready(setup_in_ready),
        .in_end(transform_out_end), .in_center_x(transform_out_center_x),
        .in_center_y(transform_out_center_y), .in_center_z(transform_out_center_z),
        .in_tangent1_x(transform_out_tangent1_x), .in_tangent1_y(transform_out_tangent1_y),
        .in_tangent1_z(transform_out_tangent1_z), .in_tangent2_x(transform_out_tangent2_x),
        .in_tangent2_y(transform_out_tangent2_y), .in_tangent2_z(transform_out_tangent2_z),
        .in_attribute_0(transform_out_attribute_0), .in_attribute_1(transform_out_attribute_1),
        .in_attribute_2(transform_out_attribute_2),
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
        .out_mx(setup_out_mx), .out_my(setup_out_my), .out_shift(setup_out_shift),
        .out_sight_negative(setup_out_sight_negative), .out_sight_near(setup_out_sight_near),
        .out_sight_far(setup_out_sight_far), .out_sight_turned(setup_out_sight_turned),
        .out_sight_disc(setup_out_sight_disc), .out_depth(setup_out_depth),
        .out_depth_low(setup_out_depth_low), .out_depth_high(setup_out_depth_high),
        .out_attribute_0(setup_out_attribute_0), .out_attribute_1(setup_out_attribute_1),
        .out_attribute_2(setup_out_attribute_2), .out_left(setup_out_left), .out_right(setup_out_right),
        .out_top(setup_out_top), .out_bottom(setup_out_bottom), .out_first_sum(setup_out_first_sum),
        .out_last_sum(setup_out_last_sum), .out_first_difference(setup_out_first_difference),
        .out_last_difference(setup_out_last_difference)
    );

    splat_splitter splitter (
        .clk(clk), .rst(rst), .in_valid(setup_out_valid), .in_ready(splitter_in_ready),
        .in_end(setup_out_end), .in_center_x(setup_out_center_x), .in_center_y(setup_out_center_y),
        .in_ax(setup_out_ax), .in_bx(setup_out_bx), .in_ay(setup_out_ay), .in_by(setup_out_by),
        .in_delta(setup_out_delta), .in_mx(setup_out_mx), .in_my(setup_out_my), .in_shift(setup_out_shift),
        .in_sight_negative(setup_out_sight_negative), .in_sight_near(setup_out_sight_near),
        .in_sight_far(setup_out_sight_far), .in_sight_turned(setup_out_sight_turned),
        .in_sight_disc(setup_out_sight_disc), .in_depth(setup_out_depth), .in_depth_low(setup_out_depth_low),
        .in_depth_high(setup_out_depth_high), .in_attribute_0(setup_out_attribute_0),
        .in_attribute_1(setup_out_attribute_1), .in_attribute_2(setup_out_attribute_2),
        .in_left(setup_out_left), .in_right(setup_out_right), .in_top(setup_out_top),
        .in_bottom(setup_out_bottom), .in_first_sum(setup_out_first_sum), .in_last_sum(setup_out_last_sum),
        .in_first_difference(setup_out_first_difference), .in_last_difference(setup_out_last_difference),
        .out_valid(splitter_out_valid), .out_ready(lane_0_in_ready), .out_end(splitter_out_end),
        .out_first(splitter_out_first), .out_center_x(splitter_out_center_x),
        .out_center_y(splitter_out_center_y), .out_ax(splitter_out_ax), .out_bx(splitter_out_bx),
        .out_ay(splitter_out_ay), .out_by(splitter_out_by), .out_delta(splitter_out_delta),
        .out_mx(splitter_out_mx), .out_my(splitter_out_my), .out_shift(splitter_out_shift),
        .out_sight_negative(splitter_out_sight_negative), .out_sight_near(splitter_out_sight_near),
        .out_sight_far(splitter_out_sight_far), .out_sight_turned(splitter_out_sight_turned),
        .out_sight_disc(splitter_out_sight_disc), .out_depth(splitter_out_depth),
        .out_depth_low(splitter_out_depth_low), .out_depth_high(splitter_out_depth_high),
        .out_attribute_0(splitter_out_attribute_0), .out_attribute_1(splitter_out_attribute_1),
        .out_attribute_2(splitter_out_attribute_2), .out_left(splitter_out_left),
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
        .in_mx(splitter_out_mx), .in_my(splitter_out_my), .in_shift(splitter_out_shift),
        .in_sight_negative(splitter_out_sight_negative), .in_sight_near(splitter_out_sight_near),
        .in_sight_far(splitter_out_sight_far), .in_sight_turned(splitter_out_sight_turned),
        .in_sight_disc(splitter_out_sight_disc), .in_depth(splitter_out_depth),
        .in_depth_low(splitter_out_depth_low), .in_depth_high(splitter_out_depth_high),
        .in_attribute_0(splitter_out_attribute_0), .in_attribute_1(splitter_out_attribute_1),
        .in_attribute_2(splitter_out_attribute_2), .in_left(splitter_out_left), .in_right(splitter_out_right),
        .in_top(splitter_out_top), .in_bottom(splitter_out_bottom), .in_first_sum(splitter_out_first_sum),
        .in_last_sum(splitter_out_last_sum), .in_first_difference(splitter_out_first_difference),
        .in_last_difference(splitter_out_last_difference), .in_tile(splitter_out_tile),
        .read_valid(read_valid), .read_ready(read_ready), .read_surface(read_surface), .read_tile(read_tile),
        .read_pixel(read_pixel), .read_count(read_count),
        .data_valid(data_valid), .data_ready(data_ready), .data_weight(data_weight), .data_depth(data_depth),
        .data_attribute_0(data_attribute_0), .data_attribute_1(data_attribute_1),
        .data_attribute_2(data_attribute_2),
        .write_valid(write_valid), .write_ready(write_ready), .write_surface(write_surface),
        .write_tile(write_tile), .write_pixel(write_pixel), .write_weight(write_weight),
        .write_depth(write_depth), .write_attribute_0(write_attribute_0),
        .write_attribute_1(write_attribute_1), .write_attribute_2(write_attribute_2),
        .pixel_valid(lane_0_pixel_valid), .pixel_ready(normalizer_in_ready), .pixel_end(lane_0_pixel_end),
        .pixel_tile(lane_0_pixel_tile), .pixel_pixel(lane_0_pixel_pixel), .pixel_weight(lane_0_pixel_weight),
        .pixel_depth(lane_0_pixel_depth), .pixel_attribute_0(lane_0_pixel_attribute_0),
        .pixel_attribute_1(lane_0_pixel_attribute_1), .pixel_attribute_2(lane_0_pixel_attribute_2),
        .filter_scale(uniform_filter_scale),
        .event_sample(event_sample), .event_starved(event_starved), .event_blocked(event_blocked),
        .event_accumulate(event_accumulate), .event_hazard(event_hazard), .event_slot_wait(event_slot_wait)
    );

    splat_normalizer normalizer (
        .clk(clk), .rst(rst), .in_valid(lane_0_pixel_valid), .in_ready(normalizer_in_ready),
        .in_end(lane_0_pixel_end), .in_tile(lane_0_pixel_tile), .in_pixel(lane_0_pixel_pixel),
        .in_weight(lane_0_pixel_weight), .in_depth(lane_0_pixel_depth),
        .in_attribute_0(lane_0_pixel_attribute_0), .in_attribute_1(lane_0_pixel_attribute_1),
        .in_attribute_2(lane_0_pixel_attribute_2),
        .out_valid(fragment_valid), .out_ready(fragment_ready), .out_end(fragment_end),
        .out_column(fragment_column), .out_row(fragment_row), .out_depth(fragment_depth),
        .out_attribute_0(fragment_attribute_0), .out_attribute_1(fragment_attribute_1),
        .out_attribute_2(fragment_attribute_2)
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
        if (uniform_valid & (uniform_address == 5'd22)) begin
            uniform_filter_scale <= uniform_data[15:0];
        end
    end
endmodule

// A finished pixel's sums divided by its weight.
// latency = 32
// initiation_interval = 1
module splat_normalizer (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready,  // Pixels of a finished frame.
    input  wire in_end,  // Closes the frame.
    input  wire [11:0] in_tile,  // Tile index.
    input  wire [5:0] in_pixel,  // Pixel of the tile.
    input  wire [27:0] in_weight,  // Sum of weights.
    input  wire [51:0] in_depth,  // Sum of weighted depths.
    input  wire [39:0] in_attribute_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [39:0] in_attribute_1,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [39:0] in_attribute_2,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire out_valid, input wire out_ready,  // Fragments.
    output wire out_end,  // Closes the frame.
    output wire [8:0] out_column,  // Column of the image.
    output wire [8:0] out_row,  // Row of the image.
    output wire [23:0] out_depth,  // Depth in the geometry format.
    output wire [11:0] out_attribute_0,  // Attributes.
    output wire [11:0] out_attribute_1,  // Attributes.
    output wire [11:0] out_attribute_2  // Attributes.
);
    (* ram_style = "distributed" *)
    reg [71:0] delay_19_from_0 [0:17];
    (* ram_style = "distributed" *)
    reg [23:0] delay_20_from_0 [0:18];
    (* ram_style = "distributed" *)
    reg [18:0] delay_32_from_0 [0:30];
    reg [6:0] credits;
    reg [4:0] delay_19_from_0_pointer;
    reg [71:0] delay_19_from_0_out;
    reg [4:0] delay_20_from_0_pointer;
    reg [23:0] delay_20_from_0_out;
    reg [4:0] delay_32_from_0_pointer;
    reg [18:0] delay_32_from_0_out;
    reg [23:0] depth_out_d1, depth_out_d2, depth_out_d3, depth_out_d4;
    reg [13:0] attribute_0_out_shifted_d1, attribute_1_out_shifted_d1, attribute_2_out_shifted_d1;
    reg [31:0] in_flight;
    reg left;

    wire [23:0] to_float_u28q16_f24_ftz_unit_y, recip_f24_ftz_unit_y, to_float_u52q40_f24_ftz_unit_y;
    wire [23:0] mul_f24_ftz_unit_y, mul_f24_ftz_unit_copy2_y, mul_f24_ftz_unit_copy3_y, mul_f24_ftz_unit_copy4_y;
    wire [23:0] to_float_s40q27_f24_ftz_unit_y, to_float_s40q27_f24_ftz_unit_copy2_y;
    wire [23:0] to_float_s40q27_f24_ftz_unit_copy3_y;
    wire [12:0] to_fixed_f24_ftz_s13q12_unit_y, to_fixed_f24_ftz_s13q12_unit_copy2_y;
    wire [12:0] to_fixed_f24_ftz_s13q12_unit_copy3_y;
    wire queue_1_in_ready;
    wire [78:0] queue_1_out_data;

    assign in_ready = ~credits[6];
    wire [23:0] attribute_0_float_d19 = delay_19_from_0_out[23:0];
    wire [23:0] attribute_1_float_d19 = delay_19_from_0_out[47:24];
    wire [23:0] attribute_2_float_d19 = delay_19_from_0_out[71:48];
    wire kept = in_flight[31];
    wire end_d32 = delay_32_from_0_out[0];
    wire [8:0] column_out_d32 = delay_32_from_0_out[9:1];
    wire [8:0] row_out_d32 = delay_32_from_0_out[18:10];
    wire [13:0] attribute_0_out_lesser = ($signed(14'h7ff) < $signed(attribute_0_out_shifted_d1)) ? 14'h7ff : attribute_0_out_shifted_d1;
    wire [13:0] attribute_1_out_lesser = ($signed(attribute_1_out_shifted_d1) < $signed(14'h7ff)) ? attribute_1_out_shifted_d1 : 14'h7ff;
    wire [13:0] attribute_2_out_lesser = ($signed(attribute_2_out_shifted_d1) < $signed(14'h7ff)) ? attribute_2_out_shifted_d1 : 14'h7ff;
    wire in_valid_and_in_ready = in_valid & in_ready;
    wire not_attribute_0_out_fixed_sign = ~to_fixed_f24_ftz_s13q12_unit_y[12];
    wire [13:0] attribute_0_out_sum_bits = {to_fixed_f24_ftz_s13q12_unit_y[12], to_fixed_f24_ftz_s13q12_unit_y};
    wire [13:0] attribute_0_out_sum = {13'd0, not_attribute_0_out_fixed_sign} + attribute_0_out_sum_bits;
    wire not_attribute_1_out_fixed_sign = ~to_fixed_f24_ftz_s13q12_unit_copy2_y[12];
    wire [13:0] attribute_1_out_sum_bits = {to_fixed_f24_ftz_s13q12_unit_copy2_y[12], to_fixed_f24_ftz_s13q12_unit_copy2_y};
    wire [13:0] attribute_1_out_sum = {13'd0, not_attribute_1_out_fixed_sign} + attribute_1_out_sum_bits;
    wire not_attribute_2_out_fixed_sign = ~to_fixed_f24_ftz_s13q12_unit_copy3_y[12];
    wire [13:0] attribute_2_out_sum_bits = {to_fixed_f24_ftz_s13q12_unit_copy3_y[12], to_fixed_f24_ftz_s13q12_unit_copy3_y};
    wire [13:0] attribute_2_out_sum = {13'd0, not_attribute_2_out_fixed_sign} + attribute_2_out_sum_bits;

    assign {out_end, out_column, out_row, out_depth, out_attribute_0, out_attribute_1, out_attribute_2} = queue_1_out_data;

    float_from_fixed_s4_f24ftz_w28_f16_unsigned to_float_u28q16_f24_ftz_unit (
        .clk(clk), .enable(1'd1), .a(in_weight), .y(to_float_u28q16_f24_ftz_unit_y)
    );

    float_recip_s20_f24ftz recip_f24_ftz_unit (
        .clk(clk), .enable(1'd1), .a(to_float_u28q16_f24_ftz_unit_y), .y(recip_f24_ftz_unit_y)
    );

    float_from_fixed_s4_f24ftz_w52_f40_unsigned to_float_u52q40_f24_ftz_unit (
        .clk(clk), .enable(1'd1), .a(in_depth), .y(to_float_u52q40_f24_ftz_unit_y)
    );

    float_mul_s4_f24ftz mul_f24_ftz_unit (
        .clk(clk), .enable(1'd1), .a(recip_f24_ftz_unit_y), .b(delay_20_from_0_out), .y(mul_f24_ftz_unit_y)
    );

    float_mul_s4_f24ftz mul_f24_ftz_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(recip_f24_ftz_unit_y), .b(attribute_0_float_d19),
        .y(mul_f24_ftz_unit_copy2_y)
    );

    float_mul_s4_f24ftz mul_f24_ftz_unit_copy3 (
        .clk(clk), .enable(1'd1), .a(recip_f24_ftz_unit_y), .b(attribute_1_float_d19),
        .y(mul_f24_ftz_unit_copy3_y)
    );

    float_mul_s4_f24ftz mul_f24_ftz_unit_copy4 (
        .clk(clk), .enable(1'd1), .a(recip_f24_ftz_unit_y), .b(attribute_2_float_d19),
        .y(mul_f24_ftz_unit_copy4_y)
    );

    float_from_fixed_s5_f24ftz_w40_f27_signed to_float_s40q27_f24_ftz_unit (
        .clk(clk), .enable(1'd1), .a(in_attribute_0), .y(to_float_s40q27_f24_ftz_unit_y)
    );

    float_from_fixed_s5_f24ftz_w40_f27_signed to_float_s40q27_f24_ftz_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(in_attribute_1), .y(to_float_s40q27_f24_ftz_unit_copy2_y)
    );

    float_from_fixed_s5_f24ftz_w40_f27_signed to_float_s40q27_f24_ftz_unit_copy3 (
        .clk(clk), .enable(1'd1), .a(in_attribute_2), .y(to_float_s40q27_f24_ftz_unit_copy3_y)
    );

    float_to_fixed_s3_f24ftz_w13_f12_signed to_fixed_f24_ftz_s13q12_unit (
        .clk(clk), .enable(1'd1), .a(mul_f24_ftz_unit_copy2_y), .y(to_fixed_f24_ftz_s13q12_unit_y)
    );

    float_to_fixed_s3_f24ftz_w13_f12_signed to_fixed_f24_ftz_s13q12_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(mul_f24_ftz_unit_copy3_y), .y(to_fixed_f24_ftz_s13q12_unit_copy2_y)
    );

    float_to_fixed_s3_f24ftz_w13_f12_signed to_fixed_f24_ftz_s13q12_unit_copy3 (
        .clk(clk), .enable(1'd1), .a(mul_f24_ftz_unit_copy4_y), .y(to_fixed_f24_ftz_s13q12_unit_copy3_y)
    );

    stream_fifo_d36_w79_distributed queue_1 (
        .clk(clk), .rst(rst), .in_valid(kept), .in_ready(queue_1_in_ready),
        .in_data({
            end_d32, column_out_d32, row_out_d32, depth_out_d4, attribute_0_out_lesser[11:0],
            attribute_1_out_lesser[11:0], attribute_2_out_lesser[11:0]
        }),
        .out_valid(out_valid), .out_ready(out_ready), .out_data(queue_1_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            credits <= 7'd35;
            delay_19_from_0_pointer <= 5'd0;
            delay_20_from_0_pointer <= 5'd0;
            delay_32_from_0_pointer <= 5'd0;
            in_flight <= 32'd0;
            left <= 1'd0;
        end else begin
            credits <= (credits - {6'd0, in_valid_and_in_ready}) + {6'd0, left};
            delay_19_from_0_pointer <= (delay_19_from_0_pointer == 5'd17) ? (delay_19_from_0_pointer - 5'd17) : (delay_19_from_0_pointer + 5'd1);
            delay_20_from_0_pointer <= (delay_20_from_0_pointer == 5'd18) ? (delay_20_from_0_pointer - 5'd18) : (delay_20_from_0_pointer + 5'd1);
            delay_32_from_0_pointer <= (delay_32_from_0_pointer == 5'd30) ? (delay_32_from_0_pointer - 5'd30) : (delay_32_from_0_pointer + 5'd1);
            in_flight <= {in_flight[30:0], in_valid_and_in_ready};
            left <= out_valid & out_ready;
        end
    end
    always @(posedge clk) begin
        depth_out_d1 <= mul_f24_ftz_unit_y;
        depth_out_d2 <= depth_out_d1;
        depth_out_d3 <= depth_out_d2;
        depth_out_d4 <= depth_out_d3;
        attribute_0_out_shifted_d1 <= {attribute_0_out_sum[13], attribute_0_out_sum[13:1]};
        attribute_1_out_shifted_d1 <= {attribute_1_out_sum[13], attribute_1_out_sum[13:1]};
        attribute_2_out_shifted_d1 <= {attribute_2_out_sum[13], attribute_2_out_sum[13:1]};
    end
    always @(posedge clk) begin
        delay_19_from_0[delay_19_from_0_pointer] <= {
            to_float_s40q27_f24_ftz_unit_copy3_y, to_float_s40q27_f24_ftz_unit_copy2_y,
            to_float_s40q27_f24_ftz_unit_y
        };
        delay_19_from_0_out <= delay_19_from_0[delay_19_from_0_pointer];
    end
    always @(posedge clk) begin
        delay_20_from_0[delay_20_from_0_pointer] <= to_float_u52q40_f24_ftz_unit_y;
        delay_20_from_0_out <= delay_20_from_0[delay_20_from_0_pointer];
    end
    always @(posedge clk) begin
        delay_32_from_0[delay_32_from_0_pointer] <= {in_tile[11:6], in_pixel[5:3], in_tile[5:0], in_pixel[2:0], in_end};
        delay_32_from_0_out <= delay_32_from_0[delay_32_from_0_pointer];
    end

    wire _unused = &{
        1'b0, attribute_0_out_lesser[13:12], attribute_0_out_sum[0], attribute_1_out_lesser[13:12],
        attribute_1_out_sum[0], attribute_2_out_lesser[13:12], attribute_2_out_sum[0], queue_1_in_ready
    };

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        queue_1_has_a_place_for_each_result: assert (~kept | queue_1_in_ready);
`else
        if (!(~kept | queue_1_in_ready)) begin
            $display("assertion failed: queue_1_has_a_place_for_each_result in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue in a memory with a registered output.
// depth = 36
// width = 79
// storage = distributed
module stream_fifo_d36_w79_distributed (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [78:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [78:0] out_data
);
    (* ram_style = "distributed" *)
    reg [78:0] entries [0:35];
    reg [5:0] held, waiting;
    reg is_full, any_waits;
    reg [5:0] write_address, read_address;
    reg [78:0] item;

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
                is_full <= push & (held == 6'd35);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 6'd1);
            end
            if (push) write_address <= (write_address == 6'd35) ? 6'd0 : (write_address + 6'd1);
            if (fetch) read_address <= (read_address == 6'd35) ? 6'd0 : (read_address + 6'd1);
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
        held_in_range: assert (held <= 6'd36);
        held_is_waiting_and_shown: assert (held == (waiting + {5'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 6'd36)) & (any_waits == |waiting));
`else
        if (!(held <= 6'd36)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {5'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 6'd36)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Floating to fixed point.
// stages = 3
// format = f24-ftz
// width = 13
// fraction = 12
// integer = signed
module float_to_fixed_s3_f24ftz_w13_f12_signed (
    input  wire clk, input wire enable, input wire [23:0] a,
    output reg  [12:0] y
);
    reg [3:0] distance_s1;
    reg [15:0] significand_s1;
    reg [12:0] magnitude_s2;
    reg sign_s1, sign_s2, nan_s1, nan_s2, vanishes_s1, vanishes_s2, saturates_s1, saturates_s2;

    wire [7:0] a_field = a[22:15];
    wire [10:0] saturates_s1_sum = {3'd0, a_field} + 11'h78e;
    wire [10:0] distance_s1_difference = 11'd16 - saturates_s1_sum;
    wire [14:0] a_fraction = a[14:0];
    wire [15:0] magnitude_s2_shifted = significand_s1 >> distance_s1;
    wire vanishes_s1_either = saturates_s1_sum[10] | (saturates_s1_sum == 11'd0);
    wire vanishes_s1_both = &a_field & (a_fraction == 15'd0);
    wire [12:0] y_choice = saturates_s2 ? (sign_s2 ? 13'h1000 : 13'hfff) : sign_s2 ? (~magnitude_s2 + 13'd1) : magnitude_s2;

    always @(posedge clk) begin
        if (enable) begin
            distance_s1 <= distance_s1_difference[3:0];
            significand_s1 <= {|a_field, a_fraction & {15{|a_field}}};
            magnitude_s2 <= magnitude_s2_shifted[12:0];
            sign_s1 <= a[23];
            sign_s2 <= sign_s1;
            nan_s1 <= &a_field & |a_fraction;
            nan_s2 <= nan_s1;
            vanishes_s1 <= (vanishes_s1_either & ~vanishes_s1_both) | ~(|a_field);
            vanishes_s2 <= vanishes_s1;
            saturates_s1 <= (~vanishes_s1_either & (11'd13 <= saturates_s1_sum) & |a_field) | vanishes_s1_both;
            saturates_s2 <= saturates_s1;
            y <= (vanishes_s2 | nan_s2) ? 13'd0 : y_choice;
        end
    end

    wire _unused = &{1'b0, distance_s1_difference[10:4], magnitude_s2_shifted[15:13]};
endmodule

// Fixed to floating point.
// stages = 5
// format = f24-ftz
// width = 40
// fraction = 27
// integer = signed
module float_from_fixed_s5_f24ftz_w40_f27_signed (
    input  wire clk, input wire enable, input wire [39:0] a,
    output reg  [23:0] y
);
    reg [39:0] magnitude_s1, magnitude_s2;
    reg [5:0] zeros_s2;
    reg [39:0] shifted_s3;
    reg [5:0] zeros_s3;
    reg [8:0] exponent_s4;
    reg [17:0] significand_s4;
    reg sign_s1, sign_s2, sign_s3, sign_s4, zero_s1, zero_s2, zero_s3, zero_s4;

    wire [39:0] magnitude_s1_choice = a[39] ? (~a + 40'd1) : a;
    wire zeros_s2_both = ~magnitude_s1[39] & ~magnitude_s1[38];
    wire zeros_s2_both_2 = zeros_s2_both & (~magnitude_s1[37] & ~magnitude_s1[36]);
    wire zeros_s2_both_3 = ~magnitude_s1[35] & ~magnitude_s1[34];
    wire zeros_s2_both_4 = zeros_s2_both_2 & (zeros_s2_both_3 & (~magnitude_s1[33] & ~magnitude_s1[32]));
    wire zeros_s2_both_5 = ~magnitude_s1[31] & ~magnitude_s1[30];
    wire zeros_s2_both_6 = zeros_s2_both_5 & (~magnitude_s1[29] & ~magnitude_s1[28]);
    wire zeros_s2_both_7 = ~magnitude_s1[27] & ~magnitude_s1[26];
    wire zeros_s2_both_8 = zeros_s2_both_6 & (zeros_s2_both_7 & (~magnitude_s1[25] & ~magnitude_s1[24]));
    wire zeros_s2_both_9 = zeros_s2_both_4 & zeros_s2_both_8;
    wire zeros_s2_both_10 = ~magnitude_s1[23] & ~magnitude_s1[22];
    wire zeros_s2_both_11 = zeros_s2_both_10 & (~magnitude_s1[21] & ~magnitude_s1[20]);
    wire zeros_s2_both_12 = ~magnitude_s1[19] & ~magnitude_s1[18];
    wire zeros_s2_both_13 = zeros_s2_both_11 & (zeros_s2_both_12 & (~magnitude_s1[17] & ~magnitude_s1[16]));
    wire zeros_s2_both_14 = ~magnitude_s1[15] & ~magnitude_s1[14];
    wire zeros_s2_both_15 = zeros_s2_both_14 & (~magnitude_s1[13] & ~magnitude_s1[12]);
    wire zeros_s2_both_16 = ~magnitude_s1[11] & ~magnitude_s1[10];
    wire zeros_s2_both_17 = zeros_s2_both_15 & (zeros_s2_both_16 & (~magnitude_s1[9] & ~magnitude_s1[8]));
    wire zeros_s2_both_18 = zeros_s2_both_9 & (zeros_s2_both_13 & zeros_s2_both_17);
    wire zeros_s2_both_19 = ~magnitude_s1[7] & ~magnitude_s1[6];
    wire zeros_s2_both_20 = zeros_s2_both_19 & (~magnitude_s1[5] & ~magnitude_s1[4]);
    wire zeros_s2_both_21 = ~magnitude_s1[3] & ~magnitude_s1[2];
    wire zeros_s2_both_22 = zeros_s2_both_20 & (zeros_s2_both_21 & (~magnitude_s1[1] & ~magnitude_s1[0]));
    wire [1:0] zeros_s2_bits = {zeros_s2_both_21, zeros_s2_both_21 ? ~magnitude_s1[1] : ~magnitude_s1[3]};
    wire [1:0] zeros_s2_bits_2 = {zeros_s2_both_19, zeros_s2_both_19 ? ~magnitude_s1[5] : ~magnitude_s1[7]};
    wire [2:0] zeros_s2_bits_3 = {zeros_s2_both_20, zeros_s2_both_20 ? zeros_s2_bits : zeros_s2_bits_2};
    wire [4:0] zeros_s2_bits_4 = {1'd0, zeros_s2_both_22, zeros_s2_both_22 ? 3'd0 : zeros_s2_bits_3};
    wire [1:0] zeros_s2_bits_5 = {zeros_s2_both_16, zeros_s2_both_16 ? ~magnitude_s1[9] : ~magnitude_s1[11]};
    wire [1:0] zeros_s2_bits_6 = {zeros_s2_both_14, zeros_s2_both_14 ? ~magnitude_s1[13] : ~magnitude_s1[15]};
    wire [2:0] zeros_s2_bits_7 = {zeros_s2_both_15, zeros_s2_both_15 ? zeros_s2_bits_5 : zeros_s2_bits_6};
    wire [1:0] zeros_s2_bits_8 = {zeros_s2_both_12, zeros_s2_both_12 ? ~magnitude_s1[17] : ~magnitude_s1[19]};
    wire [1:0] zeros_s2_bits_9 = {zeros_s2_both_10, zeros_s2_both_10 ? ~magnitude_s1[21] : ~magnitude_s1[23]};
    wire [2:0] zeros_s2_bits_10 = {zeros_s2_both_11, zeros_s2_both_11 ? zeros_s2_bits_8 : zeros_s2_bits_9};
    wire [3:0] zeros_s2_bits_11 = {zeros_s2_both_13, zeros_s2_both_13 ? zeros_s2_bits_7 : zeros_s2_bits_10};
    wire [1:0] zeros_s2_bits_12 = {zeros_s2_both_7, zeros_s2_both_7 ? ~magnitude_s1[25] : ~magnitude_s1[27]};
    wire [1:0] zeros_s2_bits_13 = {zeros_s2_both_5, zeros_s2_both_5 ? ~magnitude_s1[29] : ~magnitude_s1[31]};
    wire [2:0] zeros_s2_bits_14 = {zeros_s2_both_6, zeros_s2_both_6 ? zeros_s2_bits_12 : zeros_s2_bits_13};
    wire [1:0] zeros_s2_bits_15 = {zeros_s2_both_3, zeros_s2_both_3 ? ~magnitude_s1[33] : ~magnitude_s1[35]};
    wire [1:0] zeros_s2_bits_16 = {zeros_s2_both, zeros_s2_both ? ~magnitude_s1[37] : ~magnitude_s1[39]};
    wire [2:0] zeros_s2_bits_17 = {zeros_s2_both_2, zeros_s2_both_2 ? zeros_s2_bits_15 : zeros_s2_bits_16};
    wire [3:0] zeros_s2_bits_18 = {zeros_s2_both_4, zeros_s2_both_4 ? zeros_s2_bits_14 : zeros_s2_bits_17};
    wire [4:0] zeros_s2_bits_19 = {zeros_s2_both_9, zeros_s2_both_9 ? zeros_s2_bits_11 : zeros_s2_bits_18};
    wire y_both = (exponent_s4 == 9'd0) & ~(&significand_s4[16:2] & significand_s4[1]);
    wire round_up = significand_s4[1] & (significand_s4[0] | significand_s4[2]);
    wire [22:0] rounded = {exponent_s4[7:0], significand_s4[16:2]} + {22'd0, round_up};
    wire [22:0] y_choice = (~exponent_s4[8] & (9'd255 <= exponent_s4)) ? 23'h7f8000 : rounded;

    always @(posedge clk) begin
        if (enable) begin
            magnitude_s1 <= magnitude_s1_choice;
            magnitude_s2 <= magnitude_s1;
            zeros_s2 <= {zeros_s2_both_18, zeros_s2_both_18 ? zeros_s2_bits_4 : zeros_s2_bits_19};
            shifted_s3 <= magnitude_s2 << zeros_s2;
            zeros_s3 <= zeros_s2;
            exponent_s4 <= 9'd139 - {3'd0, zeros_s3};
            significand_s4 <= {shifted_s3[39:23], |shifted_s3[22:0]};
            sign_s1 <= a[39];
            sign_s2 <= sign_s1;
            sign_s3 <= sign_s2;
            sign_s4 <= sign_s3;
            zero_s1 <= magnitude_s1_choice == 40'd0;
            zero_s2 <= zero_s1;
            zero_s3 <= zero_s2;
            zero_s4 <= zero_s3;
            y <= {sign_s4, (zero_s4 | (exponent_s4[8] | y_both)) ? 23'd0 : y_choice};
        end
    end

    wire _unused = &{1'b0, significand_s4[17]};
endmodule

// Fixed to floating point.
// stages = 4
// format = f24-ftz
// width = 52
// fraction = 40
// integer = unsigned
module float_from_fixed_s4_f24ftz_w52_f40_unsigned (
    input  wire clk, input wire enable, input wire [51:0] a,
    output reg  [23:0] y
);
    reg [51:0] magnitude_s1;
    reg [5:0] zeros_s1;
    reg [51:0] shifted_s2;
    reg [5:0] zeros_s2;
    reg [8:0] exponent_s3;
    reg [17:0] significand_s3;
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
    wire y_both = (exponent_s3 == 9'd0) & ~(&significand_s3[16:2] & significand_s3[1]);
    wire round_up = significand_s3[1] & (significand_s3[0] | significand_s3[2]);
    wire [22:0] rounded = {exponent_s3[7:0], significand_s3[16:2]} + {22'd0, round_up};
    wire [22:0] y_choice = (~exponent_s3[8] & (9'd255 <= exponent_s3)) ? 23'h7f8000 : rounded;

    always @(posedge clk) begin
        if (enable) begin
            magnitude_s1 <= a;
            zeros_s1 <= {zeros_s1_both_9, zeros_s1_choice_13};
            shifted_s2 <= magnitude_s1 << zeros_s1;
            zeros_s2 <= zeros_s1;
            exponent_s3 <= 9'd138 - {3'd0, zeros_s2};
            significand_s3 <= {shifted_s2[51:35], |shifted_s2[34:0]};
            zero_s1 <= a == 52'd0;
            zero_s2 <= zero_s1;
            zero_s3 <= zero_s2;
            y <= {1'd0, (zero_s3 | (exponent_s3[8] | y_both)) ? 23'd0 : y_choice};
        end
    end

    wire _unused = &{1'b0, significand_s3[17]};
endmodule

// Fixed to floating point.
// stages = 4
// format = f24-ftz
// width = 28
// fraction = 16
// integer = unsigned
module float_from_fixed_s4_f24ftz_w28_f16_unsigned (
    input  wire clk, input wire enable, input wire [27:0] a,
    output reg  [23:0] y
);
    reg [27:0] magnitude_s1;
    reg [4:0] zeros_s1;
    reg [27:0] shifted_s2;
    reg [4:0] zeros_s2;
    reg [8:0] exponent_s3;
    reg [17:0] significand_s3;
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
    wire y_both = (exponent_s3 == 9'd0) & ~(&significand_s3[16:2] & significand_s3[1]);
    wire round_up = significand_s3[1] & (significand_s3[0] | significand_s3[2]);
    wire [22:0] rounded = {exponent_s3[7:0], significand_s3[16:2]} + {22'd0, round_up};
    wire [22:0] y_choice = (~exponent_s3[8] & (9'd255 <= exponent_s3)) ? 23'h7f8000 : rounded;

    always @(posedge clk) begin
        if (enable) begin
            magnitude_s1 <= a;
            zeros_s1 <= {zeros_s1_both_4, zeros_s1_choice_7};
            shifted_s2 <= magnitude_s1 << zeros_s1;
            zeros_s2 <= zeros_s1;
            exponent_s3 <= 9'd138 - {4'd0, zeros_s2};
            significand_s3 <= {shifted_s2[27:11], |shifted_s2[10:0]};
            zero_s1 <= a == 28'd0;
            zero_s2 <= zero_s1;
            zero_s3 <= zero_s2;
            y <= {1'd0, (zero_s3 | (exponent_s3[8] | y_both)) ? 23'd0 : y_choice};
        end
    end

    wire _unused = &{1'b0, significand_s3[17]};
endmodule

// A rasterizer with the lists, slots and sums of its share of the tiles.
module splat_lane (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready,  // Copies for its tiles.
    input  wire in_end,  // Closes the frame.
    input  wire in_first,  // It is the first of its splat.
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
    input  wire in_sight_negative,  // `D` is negative before the eye.
    input  wire [19:0] in_sight_near,  // The magnitude of `D` at the near plane; all ones where no sample lies before it.
    input  wire [19:0] in_sight_far,  // The magnitude of `D` at the far plane; zero where no sample lies behind it.
    input  wire in_sight_turned,  // The origin is the vanishing point of a tangent: `s1` and `D` have changed places.
    input  wire in_sight_disc,  // The origin is the splat's centre, and lies between near and far plane: the filter's disc is drawn.
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
    input  wire [39:0] data_attribute_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [39:0] data_attribute_1,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [39:0] data_attribute_2,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire write_valid, input wire write_ready,  // Pixels of evicted tiles.
    output wire write_surface,  // The frame is one of those with odd numbers: two have a place in the buffer.
    output wire [11:0] write_tile,  // Tile index.
    output wire [5:0] write_pixel,  // Pixel of the tile.
    output wire [27:0] write_weight,  // Sum of weights.
    output wire [51:0] write_depth,  // Sum of weighted depths.
    output wire [39:0] write_attribute_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [39:0] write_attribute_1,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [39:0] write_attribute_2,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire pixel_valid, input wire pixel_ready,  // Pixels of a finished frame.
    output wire pixel_end,  // Closes the frame.
    output wire [11:0] pixel_tile,  // Tile index.
    output wire [5:0] pixel_pixel,  // Pixel of the tile.
    output wire [27:0] pixel_weight,  // Sum of weights.
    output wire [51:0] pixel_depth,  // Sum of weighted depths.
    output wire [39:0] pixel_attribute_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [39:0] pixel_attribute_1,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [39:0] pixel_attribute_2,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] filter_scale,  // The reciprocal of the squared radius of the screen filter.
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
    wire [9:0] payloads_copy_splat;
    wire payloads_placed_ready, payloads_out_valid;
    wire [25:0] payloads_out_center_x, payloads_out_center_y;
    wire [15:0] payloads_out_ax, payloads_out_bx, payloads_out_ay, payloads_out_by;
    wire [19:0] payloads_out_delta;
    wire [15:0] payloads_out_mx, payloads_out_my;
    wire [3:0] payloads_out_shift;
    wire payloads_out_sight_negative;
    wire [19:0] payloads_out_sight_near, payloads_out_sight_far;
    wire payloads_out_sight_turned, payloads_out_sight_disc;
    wire [23:0] payloads_out_depth, payloads_out_depth_low, payloads_out_depth_high;
    wire [11:0] payloads_out_attribute_0, payloads_out_attribute_1, payloads_out_attribute_2;
    wire [2:0] payloads_out_left, payloads_out_right, payloads_out_top, payloads_out_bottom;
    wire [3:0] payloads_out_first_sum, payloads_out_last_sum, payloads_out_first_difference;
    wire [3:0] payloads_out_last_difference;
    wire [11:0] payloads_out_tile;
    wire payloads_out_slot, reorder_in_ready, reorder_out_valid, reorder_out_end;
    wire [2:0] reorder_out_left, reorder_out_right, reorder_out_top, reorder_out_bottom;
    wire [3:0] reorder_out_first_sum, reorder_out_last_sum, reorder_out_first_difference;
    wire [3:0] reorder_out_last_difference;
    wire [11:0] reorder_out_tile;
    wire [9:0] reorder_out_splat;
    wire tile_cache_in_ready, tile_cache_out_valid;
    wire [2:0] tile_cache_out_left, tile_cache_out_right, tile_cache_out_top, tile_cache_out_bottom;
    wire [3:0] tile_cache_out_first_sum, tile_cache_out_last_sum, tile_cache_out_first_difference;
    wire [3:0] tile_cache_out_last_difference;
    wire [11:0] tile_cache_out_tile;
    wire [9:0] tile_cache_out_splat;
    wire tile_cache_out_slot;
    wire [1:0] tile_cache_slot_ready;
    wire tile_cache_full, tile_cache_change_valid, tile_cache_change_slot;
    wire [1:0] tile_cache_change_banks;
    wire [63:0] tile_cache_change_held;
    wire tile_cache_drain_enable, tile_cache_drain_slot;
    wire [5:0] tile_cache_drain_pixel;
    wire tile_cache_fill_valid, tile_cache_fill_slot;
    wire [5:0] tile_cache_fill_pixel;
    wire [27:0] tile_cache_fill_weight;
    wire [51:0] tile_cache_fill_depth;
    wire [39:0] tile_cache_fill_attribute_0, tile_cache_fill_attribute_1, tile_cache_fill_attribute_2;
    wire rasterizer_in_ready, rasterizer_out_valid, rasterizer_out_last, rasterizer_out_inside;
    wire rasterizer_out_slot;
    wire [5:0] rasterizer_out_pixel;
    wire [15:0] rasterizer_out_weight;
    wire [23:0] rasterizer_out_depth, rasterizer_out_depth_low, rasterizer_out_depth_high;
    wire [11:0] rasterizer_out_attribute_0, rasterizer_out_attribute_1, rasterizer_out_attribute_2;
    wire weighting_in_ready, weighting_out_valid, weighting_out_last, weighting_out_inside, weighting_out_slot;
    wire [5:0] weighting_out_pixel;
    wire [15:0] weighting_out_weight;
    wire [39:0] weighting_out_weighted_depth;
    wire [23:0] weighting_out_depth_low, weighting_out_depth_high;
    wire [27:0] weighting_out_attribute_0, weighting_out_attribute_1, weighting_out_attribute_2;
    wire accumulator_in_ready, accumulator_retire_valid, accumulator_retire_slot;
    wire [1:0] accumulator_sample_reads, accumulator_sample_writes;
    wire [63:0] accumulator_masks_written, accumulator_masks_dirty;
    wire accumulator_drained_valid;
    wire [5:0] accumulator_drained_pixel;
    wire [27:0] accumulator_drained_weight;
    wire [51:0] accumulator_drained_depth;
    wire [39:0] accumulator_drained_attribute_0, accumulator_drained_attribute_1, accumulator_drained_attribute_2;

    wire payloads_copy_ready = reorder_in_ready & ~tile_cache_full;
    wire copy_comes = payloads_copy_valid & ~tile_cache_full;

    splat_payloads payloads (
        .clk(clk), .rst(rst), .in_valid(in_valid), .in_ready(in_ready), .in_end(in_end), .in_first(in_first),
        .in_center_x(in_center_x), .in_center_y(in_center_y), .in_ax(in_ax), .in_bx(in_bx), .in_ay(in_ay),
        .in_by(in_by), .in_delta(in_delta), .in_mx(in_mx), .in_my(in_my), .in_shift(in_shift),
        .in_sight_negative(in_sight_negative), .in_sight_near(in_sight_near), .in_sight_far(in_sight_far),
        .in_sight_turned(in_sight_turned), .in_sight_disc(in_sight_disc), .in_depth(in_depth),
        .in_depth_low(in_depth_low), .in_depth_high(in_depth_high), .in_attribute_0(in_attribute_0),
        .in_attribute_1(in_attribute_1), .in_attribute_2(in_attribute_2), .in_left(in_left),
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
        .out_mx(payloads_out_mx), .out_my(payloads_out_my), .out_shift(payloads_out_shift),
        .out_sight_negative(payloads_out_sight_negative), .out_sight_near(payloads_out_sight_near),
        .out_sight_far(payloads_out_sight_far), .out_sight_turned(payloads_out_sight_turned),
        .out_sight_disc(payloads_out_sight_disc), .out_depth(payloads_out_depth),
        .out_depth_low(payloads_out_depth_low), .out_depth_high(payloads_out_depth_high),
        .out_attribute_0(payloads_out_attribute_0), .out_attribute_1(payloads_out_attribute_1),
        .out_attribute_2(payloads_out_attribute_2), .out_left(payloads_out_left),
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
        .pixel_attribute_0(pixel_attribute_0), .pixel_attribute_1(pixel_attribute_1),
        .pixel_attribute_2(pixel_attribute_2),
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
        .drained_attribute_0(accumulator_drained_attribute_0),
        .drained_attribute_1(accumulator_drained_attribute_1),
        .drained_attribute_2(accumulator_drained_attribute_2),
        .write_valid(write_valid), .write_ready(write_ready), .write_surface(write_surface),
        .write_tile(write_tile), .write_pixel(write_pixel), .write_weight(write_weight),
        .write_depth(write_depth), .write_attribute_0(write_attribute_0),
        .write_attribute_1(write_attribute_1), .write_attribute_2(write_attribute_2),
        .data_valid(data_valid), .data_ready(data_ready), .data_weight(data_weight), .data_depth(data_depth),
        .data_attribute_0(data_attribute_0), .data_attribute_1(data_attribute_1),
        .data_attribute_2(data_attribute_2),
        .fill_valid(tile_cache_fill_valid), .fill_slot(tile_cache_fill_slot),
        .fill_pixel(tile_cache_fill_pixel), .fill_weight(tile_cache_fill_weight),
        .fill_depth(tile_cache_fill_depth), .fill_attribute_0(tile_cache_fill_attribute_0),
        .fill_attribute_1(tile_cache_fill_attribute_1), .fill_attribute_2(tile_cache_fill_attribute_2)
    );

    splat_rasterizer rasterizer (
        .clk(clk), .rst(rst), .in_valid(payloads_out_valid), .in_ready(rasterizer_in_ready),
        .in_center_x(payloads_out_center_x), .in_center_y(payloads_out_center_y), .in_ax(payloads_out_ax),
        .in_bx(payloads_out_bx), .in_ay(payloads_out_ay), .in_by(payloads_out_by),
        .in_delta(payloads_out_delta), .in_mx(payloads_out_mx), .in_my(payloads_out_my),
        .in_shift(payloads_out_shift), .in_sight_negative(payloads_out_sight_negative),
        .in_sight_near(payloads_out_sight_near), .in_sight_far(payloads_out_sight_far),
        .in_sight_turned(payloads_out_sight_turned), .in_sight_disc(payloads_out_sight_disc),
        .in_depth(payloads_out_depth), .in_depth_low(payloads_out_depth_low),
        .in_depth_high(payloads_out_depth_high), .in_attribute_0(payloads_out_attribute_0),
        .in_attribute_1(payloads_out_attribute_1), .in_attribute_2(payloads_out_attribute_2),
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
        .out_attribute_2(rasterizer_out_attribute_2),
        .filter_scale(filter_scale),
        .event_sample(event_sample), .event_starved(event_starved), .event_blocked(event_blocked)
    );

    splat_weighting weighting (
        .clk(clk), .rst(rst), .in_valid(rasterizer_out_valid), .in_ready(weighting_in_ready),
        .in_last(rasterizer_out_last), .in_inside(rasterizer_out_inside), .in_slot(rasterizer_out_slot),
        .in_pixel(rasterizer_out_pixel), .in_weight(rasterizer_out_weight), .in_depth(rasterizer_out_depth),
        .in_depth_low(rasterizer_out_depth_low), .in_depth_high(rasterizer_out_depth_high),
        .in_attribute_0(rasterizer_out_attribute_0), .in_attribute_1(rasterizer_out_attribute_1),
        .in_attribute_2(rasterizer_out_attribute_2),
        .out_valid(weighting_out_valid), .out_ready(accumulator_in_ready), .out_last(weighting_out_last),
        .out_inside(weighting_out_inside), .out_slot(weighting_out_slot), .out_pixel(weighting_out_pixel),
        .out_weight(weighting_out_weight), .out_weighted_depth(weighting_out_weighted_depth),
        .out_depth_low(weighting_out_depth_low), .out_depth_high(weighting_out_depth_high),
        .out_attribute_0(weighting_out_attribute_0), .out_attribute_1(weighting_out_attribute_1),
        .out_attribute_2(weighting_out_attribute_2)
    );

    splat_accumulator accumulator (
        .clk(clk), .rst(rst), .in_valid(weighting_out_valid), .in_ready(accumulator_in_ready),
        .in_last(weighting_out_last), .in_inside(weighting_out_inside), .in_slot(weighting_out_slot),
        .in_pixel(weighting_out_pixel), .in_weight(weighting_out_weight),
        .in_weighted_depth(weighting_out_weighted_depth), .in_depth_low(weighting_out_depth_low),
        .in_depth_high(weighting_out_depth_high), .in_attribute_0(weighting_out_attribute_0),
        .in_attribute_1(weighting_out_attribute_1), .in_attribute_2(weighting_out_attribute_2),
        .slot_ready(tile_cache_slot_ready),
        .retire_valid(accumulator_retire_valid), .retire_slot(accumulator_retire_slot),
        .change_valid(tile_cache_change_valid), .change_slot(tile_cache_change_slot),
        .change_banks(tile_cache_change_banks), .change_held(tile_cache_change_held),
        .fill_valid(tile_cache_fill_valid), .fill_slot(tile_cache_fill_slot),
        .fill_pixel(tile_cache_fill_pixel), .fill_weight(tile_cache_fill_weight),
        .fill_depth(tile_cache_fill_depth), .fill_attribute_0(tile_cache_fill_attribute_0),
        .fill_attribute_1(tile_cache_fill_attribute_1), .fill_attribute_2(tile_cache_fill_attribute_2),
        .drain_enable(tile_cache_drain_enable), .drain_slot(tile_cache_drain_slot),
        .drain_pixel(tile_cache_drain_pixel),
        .sample_reads(accumulator_sample_reads), .sample_writes(accumulator_sample_writes),
        .masks_written(accumulator_masks_written), .masks_dirty(accumulator_masks_dirty),
        .drained_valid(accumulator_drained_valid), .drained_pixel(accumulator_drained_pixel),
        .drained_weight(accumulator_drained_weight), .drained_depth(accumulator_drained_depth),
        .drained_attribute_0(accumulator_drained_attribute_0),
        .drained_attribute_1(accumulator_drained_attribute_1),
        .drained_attribute_2(accumulator_drained_attribute_2),
        .event_accumulate(event_accumulate), .event_hazard(event_hazard), .event_slot_wait(event_slot_wait)
    );
endmodule

// Blends samples into the pixels of the tile slots.
// slots = 2
// banks = 2
// stages = 7
module splat_accumulator (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready,  // Samples with their contributions.
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
    input  wire change_valid,  // A slot gets another tile, until that is carried out in every bank.
    input  wire change_slot,  // Slot of the tile cache.
    input  wire [1:0] change_banks,  // A bit for each bank in which that is to be carried out.
    input  wire [63:0] change_held,  // A bit for each pixel that will be filled.
    input  wire fill_valid,  // Write to a slot, until it is carried out.
    input  wire fill_slot,  // Slot of the tile cache.
    input  wire [5:0] fill_pixel,  // Pixel of the tile.
    input  wire [27:0] fill_weight,  // Sum of weights.
    input  wire [51:0] fill_depth,  // Sum of weighted depths.
    input  wire [39:0] fill_attribute_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [39:0] fill_attribute_1,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [39:0] fill_attribute_2,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire drain_enable,  // Read of a slot, until it is carried out.
    input  wire drain_slot,  // Slot of the tile cache.
    input  wire [5:0] drain_pixel,  // Pixel of the tile.
    output wire [1:0] sample_reads,  // A bit for each bank that a sample may read: no drain and no change of it is carried out.
    output wire [1:0] sample_writes,  // A bit for each bank that a sample may write in the next cycle: no fill of it is carried out then.
    output wire [63:0] masks_written,  // A bit for each pixel that was filled or that a sample came to.
    output wire [63:0] masks_dirty,  // A bit for each pixel that a sample came to.
    output wire drained_valid,  // A pixel that was read.
    output wire [5:0] drained_pixel,  // Pixel of the tile.
    output wire [27:0] drained_weight,  // Sum of weights.
    output wire [51:0] drained_depth,  // Sum of weighted depths.
    output wire [39:0] drained_attribute_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [39:0] drained_attribute_1,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [39:0] drained_attribute_2,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output reg  event_accumulate,  // The accumulator took a sample.
    output reg  event_hazard,  // The accumulator waited for an earlier sample of the same pixel.
    output reg  event_slot_wait  // The accumulator waited for its tile to arrive in the cache.
);
    (* ram_style = "distributed" *)
    reg [63:0] bank_0_masks [0:1];
    (* ram_style = "distributed" *)
    reg [63:0] bank_1_masks [0:1];
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
    reg head_valid;
    reg head_last;  // Closes its copy.
    reg head_inside;  // Lies inside the splat.
    reg head_slot;  // Slot of the tile cache.
    reg [5:0] head_pixel;  // Pixel of the tile.
    reg [15:0] head_weight;  // Kernel weight.
    reg [39:0] head_weighted_depth;  // Weighted depth.
    reg [23:0] head_depth_low;  // Near end of the depth band.
    reg [23:0] head_depth_high;  // Far end of the depth band.
    reg [27:0] head_attribute_0;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [27:0] head_attribute_1;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [27:0] head_attribute_2;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [7:0] collisions;
    reg on_the_way, arrived;
    reg [31:0] bank_0_was_written, bank_0_was_dirty;
    reg [3:0] bank_0_was_near;
    reg [31:0] bank_1_was_written, bank_1_was_dirty;
    reg [3:0] bank_1_was_near;
    reg [1:0] near_place;
    reg near_bank, is_written;
    wire [199:0] bank_0_read;
    reg [199:0] bank_0_pixel;
    wire [199:0] bank_1_read;
    reg [199:0] bank_1_pixel;
    reg drains_1;
    reg [5:0] drained_pixel_1;
    reg drains_2;
    reg [5:0] drained_pixel_2;
    reg [199:0] stored;
    reg [15:0] sample_1_weight;  // Kernel weight.
    reg [39:0] sample_1_weighted_depth;  // Weighted depth.
    reg [23:0] sample_1_depth_low;  // Near end of the depth band.
    reg [23:0] sample_1_depth_high;  // Far end of the depth band.
    reg [27:0] sample_1_attribute_0;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [27:0] sample_1_attribute_1;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [27:0] sample_1_attribute_2;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] sample_2_weight;  // Kernel weight.
    reg [39:0] sample_2_weighted_depth;  // Weighted depth.
    reg [23:0] sample_2_depth_low;  // Near end of the depth band.
    reg [23:0] sample_2_depth_high;  // Far end of the depth band.
    reg [27:0] sample_2_attribute_0;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [27:0] sample_2_attribute_1;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [27:0] sample_2_attribute_2;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [15:0] sample_3_weight;  // Kernel weight.
    reg [39:0] sample_3_weighted_depth;  // Weighted depth.
    reg [23:0] sample_3_depth_low;  // Near end of the depth band.
    reg [23:0] sample_3_depth_high;  // Far end of the depth band.
    reg [27:0] sample_3_attribute_0;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [27:0] sample_3_attribute_1;  // Weighted continuous attributes, and cardinal ones as they are.
    reg [27:0] sample_3_attribute_2;  // Weighted continuous attributes, and cardinal ones as they are.
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

    wire places_out_valid;
    wire [8:0] places_out_data;
    wire samples_in_ready, samples_out_valid;
    wire [187:0] samples_out_data;
    wire depth_test_fail, depth_test_pass;

    wire may_issue_inside = head_valid & head_inside;
    wire reads = may_issue_inside & arrived;
    wire sample_reads_1 = reads & head_pixel[0];
    wire sample_reads_0 = reads & ~head_pixel[0];
    wire [1:0] reads_bank = {sample_reads_1, sample_reads_0};
    wire [1:0] will_write_bank = {inside_7 & pixel_7[0], inside_7 & ~pixel_7[0]};
    wire [199:0] drained_word = drained_pixel_2[0] ? bank_1_pixel : bank_0_pixel;
    wire sample_ends_in_0 = inside_8 & ~pixel_8[0];
    wire changes = ~late_fail_5 & (late_pass_5 | ~weight_sum_8[28]);
    wire writes_0 = sample_ends_in_0 ? changes : (fill_valid & ~fill_pixel[0]);
    wire [5:0] bank_1_pixels_address_bits = {slot_8, pixel_8[5:1]};
    wire [5:0] bank_1_pixels_address_bits_2 = {fill_slot, fill_pixel[5:1]};
    wire [39:0] result_choice = late_pass_5 ? {{12{attribute_0_8[27]}}, attribute_0_8} : sum_of_attribute_0_8;
    wire [39:0] result_choice_2 = late_pass_5 ? {{12{attribute_1_8[27]}}, attribute_1_8} : sum_of_attribute_1_8;
    wire [39:0] result_choice_3 = late_pass_5 ? {{12{attribute_2_8[27]}}, attribute_2_8} : sum_of_attribute_2_8;
    wire [199:0] result = {
        late_pass_5 ? {12'd0, weight_8} : weight_sum_8[27:0], late_pass_5 ? {12'd0, depth_8} : depth_sum_8,
        result_choice, result_choice_2, result_choice_3
    };
    wire [199:0] bank_1_pixels_data_bits = {fill_weight, fill_depth, fill_attribute_0, fill_attribute_1, fill_attribute_2};
    wire [5:0] bank_1_read_address_bits = {head_slot, head_pixel[5:1]};
    wire [5:0] bank_1_read_address_bits_2 = {drain_slot, drain_pixel[5:1]};
    wire sample_ends_in_1 = inside_8 & pixel_8[0];
    wire writes_1 = sample_ends_in_1 ? changes : (fill_valid & fill_pixel[0]);
    wire slot_wait = may_issue_inside & ~arrived;
    wire hazard = may_issue_inside & (arrived & on_the_way);
    wire issue = head_valid & ~(slot_wait | hazard);
    wire head_takes = ~head_valid | issue;
    wire issue_inside = may_issue_inside & (arrived & ~on_the_way);
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
    wire collisions_both = may_issue_inside & (places_out_data[6:0] == {head_slot, head_pixel});
    wire [7:0] collisions_bits = {
        inside_7 & (places_out_data[6:0] == {slot_7, pixel_7}),
        inside_6 & (places_out_data[6:0] == {slot_6, pixel_6}),
        inside_5 & (places_out_data[6:0] == {slot_5, pixel_5}),
        inside_4 & (places_out_data[6:0] == {slot_4, pixel_4}),
        inside_3 & (places_out_data[6:0] == {slot_3, pixel_3}),
        inside_2 & (places_out_data[6:0] == {slot_2, pixel_2}),
        inside_1 & (places_out_data[6:0] == {slot_1, pixel_1}), collisions_both
    };
    wire [7:0] collisions_shifted_by_1 = collisions << 1;
    wire [1:0] arrived_shifted = slot_ready >> places_out_slot;
    wire [1:0] arrived_shifted_2 = slot_ready >> head_slot;
    wire changes_0 = change_valid & change_banks[0] & ~sample_reads_0;
    wire masked_slot_0 = sample_reads_0 ? head_slot : change_slot;
    wire [63:0] bank_0_mask = bank_0_masks[masked_slot_0];
    wire [4:0] bank_1_near_bits = {head_pixel[5:3], 2'd0};
    wire [31:0] bank_0_near_shifted = bank_0_mask[63:32] >> bank_1_near_bits;
    wire [3:0] bank_0_near = bank_0_near_shifted[3:0];
    wire changes_1 = change_valid & change_banks[1] & ~sample_reads_1;
    wire masked_slot_1 = sample_reads_1 ? head_slot : change_slot;
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
    assign {drained_weight, drained_depth, drained_attribute_0, drained_attribute_1, drained_attribute_2} = drained_word;

    memory_1w1r_unordered #(.WIDTH(200), .DEPTH(64)) bank_0_pixels (
        .clk(clk), .write(writes_0),
        .write_address(sample_ends_in_0 ? bank_1_pixels_address_bits : bank_1_pixels_address_bits_2),
        .write_data(sample_ends_in_0 ? result : bank_1_pixels_data_bits),
        .read(sample_reads_0 | (drain_enable & ~drain_pixel[0])),
        .read_address(sample_reads_0 ? bank_1_read_address_bits : bank_1_read_address_bits_2),
        .read_data(bank_0_read)
    );

    memory_1w1r_unordered #(.WIDTH(200), .DEPTH(64)) bank_1_pixels (
        .clk(clk), .write(writes_1),
        .write_address(sample_ends_in_1 ? bank_1_pixels_address_bits : bank_1_pixels_address_bits_2),
        .write_data(sample_ends_in_1 ? result : bank_1_pixels_data_bits),
        .read(sample_reads_1 | (drain_enable & drain_pixel[0])),
        .read_address(sample_reads_1 ? bank_1_read_address_bits : bank_1_read_address_bits_2),
        .read_data(bank_1_read)
    );

    stream_fifo_d64_w9_distributed places (
        .clk(clk), .rst(rst), .in_valid(in_valid), .in_ready(in_ready),
        .in_data({in_last, in_inside, in_slot, in_pixel}),
        .out_valid(places_out_valid), .out_ready(head_takes), .out_data(places_out_data)
    );

    stream_fifo_d64_w188 samples (
        .clk(clk), .rst(rst), .in_valid(in_valid), .in_ready(samples_in_ready),
        .in_data({
            in_weight, in_weighted_depth, in_depth_low, in_depth_high, in_attribute_0, in_attribute_1,
            in_attribute_2
        }),
        .out_valid(samples_out_valid), .out_ready(head_takes), .out_data(samples_out_data)
    );

    splat_depth_test depth_test (
        .clk(clk), .rst(rst), .weight(stored[199:172]), .depth(stored[171:120]),
        .depth_low(sample_3_depth_low), .depth_high(sample_3_depth_high),
        .fail(depth_test_fail), .pass(depth_test_pass)
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
        stored <= {200{is_written}} & (pixel_2[0] ? bank_1_pixel : bank_0_pixel);
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
        1'b0, arrived_shifted[1], arrived_shifted_2[1], bank_0_near_shifted[31:4], bank_1_near_shifted[31:4],
        is_written_shifted[3:1], is_written_shifted_2[3:1], samples_in_ready, samples_out_valid
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
// width = 188
module stream_fifo_d64_w188 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [187:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [187:0] out_data
);
    reg [6:0] held, waiting;
    reg is_full, any_waits;
    reg [5:0] write_address, read_address;
    wire [187:0] item;

    wire has_room = ~is_full;
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [6:0] held_bits = {{6{~push}}, 1'd1};
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    memory_1w1r_unordered #(.WIDTH(188), .DEPTH(64)) entries (
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
// width = 9
// storage = distributed
module stream_fifo_d64_w9_distributed (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [8:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [8:0] out_data
);
    (* ram_style = "distributed" *)
    reg [8:0] entries [0:63];
    reg [6:0] held, waiting;
    reg is_full, any_waits;
    reg [5:0] write_address, read_address;
    reg [8:0] item;

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
// latency = 4
// initiation_interval = 1
module splat_weighting (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready,  // Samples.
    input  wire in_last,  // Closes its copy.
    input  wire in_inside,  // Lies inside the splat; one outside is passed on only to say so.
    input  wire in_slot,  // Slot of the tile cache.
    input  wire [5:0] in_pixel,  // Pixel of the tile: row above column.
    input  wire [15:0] in_weight,  // Kernel weight.
    input  wire [23:0] in_depth,  // Depth.
    input  wire [23:0] in_depth_low,  // What is nearer hides the splat.
    input  wire [23:0] in_depth_high,  // What is farther is hidden by the splat.
    input  wire [11:0] in_attribute_0,  // Attributes.
    input  wire [11:0] in_attribute_1,  // Attributes.
    input  wire [11:0] in_attribute_2,  // Attributes.
    output wire out_valid, input wire out_ready,  // Samples with their contributions.
    output wire out_last,  // Closes its copy.
    output wire out_inside,  // Lies inside the splat; one outside is passed on only to say so.
    output wire out_slot,  // Slot of the tile cache.
    output wire [5:0] out_pixel,  // Pixel of the tile: row above column.
    output wire [15:0] out_weight,  // Kernel weight.
    output wire [39:0] out_weighted_depth,  // Weighted depth.
    output wire [23:0] out_depth_low,  // Near end of the depth band.
    output wire [23:0] out_depth_high,  // Far end of the depth band.
    output wire [27:0] out_attribute_0,  // Weighted continuous attributes, and cardinal ones as they are.
    output wire [27:0] out_attribute_1,  // Weighted continuous attributes, and cardinal ones as they are.
    output wire [27:0] out_attribute_2  // Weighted continuous attributes, and cardinal ones as they are.
);
    reg [3:0] credits;
    reg last_d1, last_d2, last_d3, last_d4, inside_d1, inside_d2, inside_d3, inside_d4, slot_d1, slot_d2;
    reg slot_d3, slot_d4;
    reg [5:0] pixel_d1, pixel_d2, pixel_d3, pixel_d4;
    reg [15:0] weight_d1, weight_d2, weight_d3, weight_d4;
    reg [23:0] depth_d1, depth_low_d1, depth_low_d2, depth_low_d3, depth_low_d4, depth_high_d1, depth_high_d2;
    reg [23:0] depth_high_d3, depth_high_d4;
    reg [16:0] factor_d1;
    reg [11:0] attribute_0_d1;
    reg [27:0] attribute_0_out_d1;
    reg [11:0] attribute_1_d1;
    reg [27:0] attribute_1_out_d1;
    reg [11:0] attribute_2_d1;
    reg [27:0] attribute_2_out_d1;
    reg [3:0] in_flight;
    reg left;

    wire [39:0] mul_u16_u24_unit_y;
    wire [28:0] mul_s17_s12_unit_y, mul_s17_s12_unit_copy2_y, mul_s17_s12_unit_copy3_y;
    wire queue_1_in_ready;
    wire [112:0] queue_1_out_data;
    wire queue_2_in_ready, queue_2_out_valid;
    wire [83:0] queue_2_out_data;

    assign in_ready = ~credits[3];
    wire kept = in_flight[3];
    wire in_valid_and_in_ready = in_valid & in_ready;
    wire [16:0] factor = {1'd0, in_weight};

    assign {
        out_last, out_inside, out_slot, out_pixel, out_weight, out_weighted_depth, out_depth_low,
        out_depth_high
    } = queue_1_out_data;
    assign {out_attribute_0, out_attribute_1, out_attribute_2} = queue_2_out_data;

    integer_mul_s3_u16_u24 mul_u16_u24_unit (
        .clk(clk), .enable(1'd1), .a(weight_d1), .b(depth_d1), .y(mul_u16_u24_unit_y)
    );

    integer_mul_s2_s17_s12 mul_s17_s12_unit (
        .clk(clk), .enable(1'd1), .a(factor_d1), .b(attribute_0_d1), .y(mul_s17_s12_unit_y)
    );

    integer_mul_s2_s17_s12 mul_s17_s12_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(factor_d1), .b(attribute_1_d1), .y(mul_s17_s12_unit_copy2_y)
    );

    integer_mul_s2_s17_s12 mul_s17_s12_unit_copy3 (
        .clk(clk), .enable(1'd1), .a(factor_d1), .b(attribute_2_d1), .y(mul_s17_s12_unit_copy3_y)
    );

    stream_fifo_d8_w113_distributed queue_1 (
        .clk(clk), .rst(rst), .in_valid(kept), .in_ready(queue_1_in_ready),
        .in_data({last_d4, inside_d4, slot_d4, pixel_d4, weight_d4, mul_u16_u24_unit_y, depth_low_d4, depth_high_d4}),
        .out_valid(out_valid), .out_ready(out_ready), .out_data(queue_1_out_data)
    );

    stream_fifo_d8_w84_distributed queue_2 (
        .clk(clk), .rst(rst), .in_valid(kept), .in_ready(queue_2_in_ready),
        .in_data({attribute_0_out_d1, attribute_1_out_d1, attribute_2_out_d1}),
        .out_valid(queue_2_out_valid), .out_ready(out_ready), .out_data(queue_2_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            credits <= 4'd7;
            in_flight <= 4'd0;
            left <= 1'd0;
        end else begin
            credits <= (credits - {3'd0, in_valid_and_in_ready}) + {3'd0, left};
            in_flight <= {in_flight[2:0], in_valid_and_in_ready};
            left <= out_valid & out_ready;
        end
    end
    always @(posedge clk) begin
        last_d1 <= in_last;
        last_d2 <= last_d1;
        last_d3 <= last_d2;
        last_d4 <= last_d3;
        inside_d1 <= in_inside;
        inside_d2 <= inside_d1;
        inside_d3 <= inside_d2;
        inside_d4 <= inside_d3;
        slot_d1 <= in_slot;
        slot_d2 <= slot_d1;
        slot_d3 <= slot_d2;
        slot_d4 <= slot_d3;
        pixel_d1 <= in_pixel;
        pixel_d2 <= pixel_d1;
        pixel_d3 <= pixel_d2;
        pixel_d4 <= pixel_d3;
        weight_d1 <= in_weight;
        weight_d2 <= weight_d1;
        weight_d3 <= weight_d2;
        weight_d4 <= weight_d3;
        depth_d1 <= in_depth;
        depth_low_d1 <= in_depth_low;
        depth_low_d2 <= depth_low_d1;
        depth_low_d3 <= depth_low_d2;
        depth_low_d4 <= depth_low_d3;
        depth_high_d1 <= in_depth_high;
        depth_high_d2 <= depth_high_d1;
        depth_high_d3 <= depth_high_d2;
        depth_high_d4 <= depth_high_d3;
        factor_d1 <= factor;
        attribute_0_d1 <= in_attribute_0;
        attribute_0_out_d1 <= mul_s17_s12_unit_y[27:0];
        attribute_1_d1 <= in_attribute_1;
        attribute_1_out_d1 <= mul_s17_s12_unit_copy2_y[27:0];
        attribute_2_d1 <= in_attribute_2;
        attribute_2_out_d1 <= mul_s17_s12_unit_copy3_y[27:0];
    end

    wire _unused = &{
        1'b0, mul_s17_s12_unit_copy2_y[28], mul_s17_s12_unit_copy3_y[28], mul_s17_s12_unit_y[28],
        queue_1_in_ready, queue_2_in_ready, queue_2_out_valid
    };

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
// depth = 8
// width = 84
// storage = distributed
module stream_fifo_d8_w84_distributed (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [83:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [83:0] out_data
);
    (* ram_style = "distributed" *)
    reg [83:0] entries [0:7];
    reg [3:0] held, waiting;
    reg is_full, any_waits;
    reg [2:0] write_address, read_address;
    reg [83:0] item;

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
// depth = 8
// width = 113
// storage = distributed
module stream_fifo_d8_w113_distributed (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [112:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [112:0] out_data
);
    (* ram_style = "distributed" *)
    reg [112:0] entries [0:7];
    reg [3:0] held, waiting;
    reg is_full, any_waits;
    reg [2:0] write_address, read_address;
    reg [112:0] item;

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

// Integer product, pipelined.
// stages = 2
// a = s17
// b = s12
module integer_mul_s2_s17_s12 (
    input  wire clk, input wire enable, input wire [16:0] a, input wire [11:0] b,
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

// Samples of a splat copy, one a cycle, with their kernel weights.
module splat_rasterizer (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready,  // Copies with their slots.
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
    input  wire in_sight_negative,  // `D` is negative before the eye.
    input  wire [19:0] in_sight_near,  // The magnitude of `D` at the near plane; all ones where no sample lies before it.
    input  wire [19:0] in_sight_far,  // The magnitude of `D` at the far plane; zero where no sample lies behind it.
    input  wire in_sight_turned,  // The origin is the vanishing point of a tangent: `s1` and `D` have changed places.
    input  wire in_sight_disc,  // The origin is the splat's centre, and lies between near and far plane: the filter's disc is drawn.
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
    input  wire [3:0] in_first_sum,  // Smallest sum.
    input  wire [3:0] in_last_sum,  // Largest sum.
    input  wire [3:0] in_first_difference,  // Smallest difference.
    input  wire [3:0] in_last_difference,  // Largest difference.
    input  wire [11:0] in_tile,  // Tile index: row above column.
    input  wire in_slot,  // Slot of the tile cache.
    output wire out_valid, input wire out_ready,  // Samples.
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
    reg busy, idle, walks, is_last, slot;
    reg [11:0] tile;
    reg [2:0] column, row, row_end, next_begin, next_end, bottom, left, right;
    reg [3:0] first_sum;  // Smallest sum.
    reg [3:0] last_sum;  // Largest sum.
    reg [3:0] first_difference;  // Smallest difference.
    reg [3:0] last_difference;  // Largest difference.
    reg [25:0] center_x;  // Projected center (px), the origin of what follows.
    reg [25:0] center_y;  // Projected center (px), the origin of what follows.
    reg [15:0] ax;  // `A` in x.
    reg [15:0] bx;  // `B` in x.
    reg [15:0] ay;  // `A` in y.
    reg [15:0] by;  // `B` in y.
    reg [19:0] delta;  // The determinant of `A` and `B`.
    reg [15:0] mx;  // `m` in x.
    reg [15:0] my;  // `m` in y.
    reg [3:0] shift;  // In fixed point, places by which offsets from the centre are shifted.
    reg sight_negative;  // `D` is negative before the eye.
    reg [19:0] sight_near;  // The magnitude of `D` at the near plane; all ones where no sample lies before it.
    reg [19:0] sight_far;  // The magnitude of `D` at the far plane; zero where no sample lies behind it.
    reg sight_turned;  // The origin is the vanishing point of a tangent: `s1` and `D` have changed places.
    reg sight_disc;  // The origin is the splat's centre, and lies between near and far plane: the filter's disc is drawn.

    wire evaluation_in_ready, shared_in_ready, shared_out_valid;
    wire [107:0] shared_out_data;

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
    assign {out_depth, out_depth_low, out_depth_high, out_attribute_0, out_attribute_1, out_attribute_2} = shared_out_data;

    splat_evaluation evaluation (
        .clk(clk), .rst(rst), .in_valid(busy), .in_ready(evaluation_in_ready), .in_last(is_last),
        .in_slot(slot), .in_column({tile[5:0], column}), .in_row({tile[11:6], row}), .in_center_x(center_x),
        .in_center_y(center_y), .in_ax(ax), .in_bx(bx), .in_ay(ay), .in_by(by), .in_delta(delta), .in_mx(mx),
        .in_my(my), .in_shift(shift), .in_sight_negative(sight_negative), .in_sight_near(sight_near),
        .in_sight_far(sight_far), .in_sight_turned(sight_turned), .in_sight_disc(sight_disc),
        .filter_scale(filter_scale),
        .out_valid(out_valid), .out_ready(out_ready), .out_last(out_last), .out_inside(out_inside),
        .out_slot(out_slot), .out_pixel(out_pixel), .out_weight(out_weight)
    );

    stream_fifo_d64_w108 shared (
        .clk(clk), .rst(rst), .in_valid(load), .in_ready(shared_in_ready),
        .in_data({in_depth, in_depth_low, in_depth_high, in_attribute_0, in_attribute_1, in_attribute_2}),
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
            shift <= in_shift;
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
// depth = 64
// width = 108
module stream_fifo_d64_w108 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [107:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [107:0] out_data
);
    reg [6:0] held, waiting;
    reg is_full, any_waits;
    reg [5:0] write_address, read_address;
    wire [107:0] item;

    wire has_room = ~is_full;
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [6:0] held_bits = {{6{~push}}, 1'd1};
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    memory_1w1r_unordered #(.WIDTH(108), .DEPTH(64)) entries (
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

// Distance of a sample from its splat's centre, and its kernel weight.
// latency = 37
// initiation_interval = 1
module splat_evaluation (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire in_last, input wire in_slot,
    input  wire [8:0] in_column, input wire [8:0] in_row, input wire [25:0] in_center_x,
    input  wire [25:0] in_center_y, input wire [15:0] in_ax, input wire [15:0] in_bx,
    input  wire [15:0] in_ay, input wire [15:0] in_by, input wire [19:0] in_delta,
    input  wire [15:0] in_mx, input wire [15:0] in_my, input wire [3:0] in_shift,
    input  wire in_sight_negative, input wire [19:0] in_sight_near, input wire [19:0] in_sight_far,
    input  wire in_sight_turned, input wire in_sight_disc,
    input  wire [15:0] filter_scale,
    output wire out_valid, input wire out_ready, output wire out_last, output wire out_inside,
    output wire out_slot, output wire [5:0] out_pixel, output wire [15:0] out_weight
);
    (* ram_style = "distributed" *)
    reg [2:0] delay_6_from_0 [0:4];
    (* ram_style = "distributed" *)
    reg [40:0] delay_7_from_0 [0:5];
    (* ram_style = "distributed" *)
    reg [1:0] delay_9_from_0 [0:7];
    (* ram_style = "distributed" *)
    reg delay_11_from_0 [0:9];
    (* ram_style = "distributed" *)
    reg delay_14_from_0 [0:12];
    (* ram_style = "distributed" *)
    reg [15:0] delay_25_from_0 [0:23];
    (* ram_style = "distributed" *)
    reg delay_30_from_0 [0:28];
    (* ram_style = "distributed" *)
    reg [7:0] delay_37_from_0 [0:35];
    reg [6:0] credits;
    reg [2:0] delay_6_from_0_pointer, delay_6_from_0_out, delay_7_from_0_pointer;
    reg [40:0] delay_7_from_0_out;
    reg [2:0] delay_9_from_0_pointer;
    reg [1:0] delay_9_from_0_out;
    reg [3:0] delay_11_from_0_pointer;
    reg delay_11_from_0_out;
    reg [3:0] delay_14_from_0_pointer;
    reg delay_14_from_0_out;
    reg [4:0] delay_25_from_0_pointer;
    reg [15:0] delay_25_from_0_out;
    reg [4:0] delay_30_from_0_pointer;
    reg delay_30_from_0_out;
    reg [5:0] delay_37_from_0_pointer;
    reg [7:0] delay_37_from_0_out;
    reg [22:0] s1_chosen_d1;
    reg shift_bits_d1, shift_bits_d1_copy2, shift_bits_d1_copy3;
    reg [15:0] s1_chosen_d1_copy2;
    reg [22:0] s1_chosen_d1_copy3;
    reg [15:0] s1_chosen_d1_copy4, ay_d1, ay_d2, ax_d1, ax_d2;
    reg [31:0] s1_d1, s1_d2;
    reg [15:0] by_d1, by_d2, bx_d1, bx_d2;
    reg [31:0] s2_d1;
    reg [15:0] mx_d1, mx_d2, my_d1, my_d2;
    reg [31:0] s1_chosen_times_my_d1;
    reg [32:0] d_shifted_d1, d_shifted_d2, d_shifted_d3, d_shifted_d4, d_sum_d1, d_d1;
    reg [31:0] weight_out_chosen_bits_d1, weight_out_chosen_bits_d2, weight_out_chosen_bits_d1_copy2;
    reg [31:0] weight_out_chosen_bits_d2_copy2, weight_out_chosen_bits_d1_copy3, weight_out_chosen_bits_d2_copy3;
    reg [31:0] weight_out_chosen_bits_d3;
    reg weight_out_same_d1, weight_out_same_d1_copy2, weight_out_same_d1_copy3, weight_out_same_d2;
    reg weight_out_both_d1, weight_out_both_d2;
    reg [31:0] weight_out_chosen_d1, weight_out_chosen_d1_copy2, weight_out_chosen_d1_copy3;
    reg weight_out_chosen_bits_is_zero_d1, zero_is_weight_out_chosen_bits_d1;
    reg zero_is_weight_out_chosen_bits_d1_copy2, weight_out_both_d1_copy2, weight_out_either_d1;
    reg [24:0] weight_out_chosen_bits_d1_copy4, weight_out_chosen_bits_d1_copy5, weight_out_chosen_bits_d1_copy6;
    reg weight_out_same_d1_copy4, weight_out_same_d1_copy5, weight_out_same_d1_copy6;
    reg weight_out_both_d1_copy3, weight_out_same_d1_copy7, weight_out_both_d1_copy4;
    reg weight_out_either_d1_copy2;
    reg [18:0] weight_out_chosen_bits_d1_copy7, weight_out_chosen_bits_d1_copy8, weight_out_chosen_bits_d1_copy9;
    reg weight_out_same_d1_copy8, not_weight_out_both_d1;
    reg [17:0] denominator_chosen_bits_d1, weight_out_chosen_bits_d1_copy10, weight_out_chosen_bits_d1_copy11;
    reg [35:0] denominator_d1;
    reg [36:0] weight_out_sum_d1;
    reg weight_out_in_order_d1, not_weight_out_either_d1, not_weight_out_either_d2, not_weight_out_either_d3;
    reg not_weight_out_either_d4, weight_out_both_d1_copy5;
    reg [23:0] denominator_bits_d1, denominator_bits_d2, denominator_bits_d3, denominator_bits_d4;
    reg [23:0] denominator_bits_d5, denominator_bits_d6, denominator_bits_d7, denominator_bits_d8;
    reg [23:0] denominator_bits_d9, denominator_bits_d10, denominator_bits_d11, denominator_bits_d12;
    reg [23:0] denominator_bits_d13, denominator_bits_d14, denominator_bits_d15, denominator_bits_d16;
    reg [23:0] weight_out_shifted_d1;
    reg not_weight_out_difference_sign_d1;
    reg [23:0] weight_out_shifted_d1_copy2;
    reg [1:0] weight_out_joined_d1;
    reg [23:0] weight_out_shifted_d1_copy3;
    reg [2:0] weight_out_joined_d1_copy2;
    reg [23:0] weight_out_shifted_d1_copy4;
    reg [3:0] weight_out_joined_d1_copy3;
    reg [23:0] weight_out_shifted_d1_copy5;
    reg [4:0] weight_out_joined_d1_copy4;
    reg [23:0] weight_out_shifted_d1_copy6;
    reg [5:0] weight_out_joined_d1_copy5;
    reg [23:0] weight_out_shifted_d1_copy7;
    reg [6:0] weight_out_joined_d1_copy6;
    reg [23:0] weight_out_shifted_d1_copy8;
    reg [7:0] weight_out_joined_d1_copy7;
    reg [23:0] weight_out_shifted_d1_copy9;
    reg [8:0] weight_out_joined_d1_copy8;
    reg [23:0] weight_out_shifted_d1_copy10;
    reg [9:0] weight_out_joined_d1_copy9;
    reg [23:0] weight_out_shifted_d1_copy11;
    reg [10:0] weight_out_joined_d1_copy10;
    reg [23:0] weight_out_shifted_d1_copy12;
    reg [11:0] weight_out_joined_d1_copy11;
    reg [23:0] weight_out_shifted_d1_copy13;
    reg [12:0] weight_out_joined_d1_copy12;
    reg [23:0] weight_out_shifted_d1_copy14;
    reg [13:0] weight_out_joined_d1_copy13;
    reg [23:0] weight_out_shifted_d1_copy15;
    reg [14:0] weight_out_joined_d1_copy14;
    reg [23:0] weight_out_shifted_d1_copy16;
    reg [15:0] weight_out_joined_d1_copy15, weight_out_chosen_d1_copy4;
    reg [11:0] x_bits_d1;
    reg weight_out_either_d1_copy3;
    reg [15:0] x_bits_d1_copy2;
    reg [11:0] y_bits_d1;
    reg weight_out_either_d1_copy4;
    reg [15:0] y_bits_d1_copy2;
    reg weight_out_both_d1_copy6, weight_out_both_d2_copy2;
    reg [3:0] weight_out_sum_bits_d1;
    reg weight_out_both_d1_copy7, weight_out_both_d2_copy3;
    reg [17:0] weight_out_sum_bits_d1_copy2;
    reg weight_out_both_d1_copy8;
    reg [15:0] weight_out_product_bits_d1, weight_out_lesser_d1;
    reg [36:0] in_flight;
    reg left, dropped;

    wire [31:0] mul_s16_s16_unit_y, mul_s16_s16_unit_copy2_y, mul_s16_s16_unit_copy3_y, mul_s16_s16_unit_copy4_y;
    wire [31:0] mul_s16_s16_unit_copy5_y, mul_s16_s16_unit_copy6_y, mul_s16_s16_unit_copy7_y;
    wire [31:0] mul_s16_s16_unit_copy8_y;
    wire [35:0] mul_u18_u18_unit_y, mul_u18_u18_unit_copy2_y, mul_u18_u18_unit_copy3_y;
    wire [33:0] mul_u18_u16_unit_y;
    wire [15:0] interpolate_8_8_16_unit_y;
    wire queue_1_in_ready;
    wire [24:0] queue_1_out_data;

    assign in_ready = ~credits[6];
    wire last_d37 = delay_37_from_0_out[0];
    wire weight_out_both_d20 = delay_6_from_0_out[2];
    wire covered = weight_out_both_d20 | delay_30_from_0_out;
    wire last_or_covered = last_d37 | covered;
    wire kept = in_flight[36] & last_or_covered;
    wire slot_d37 = delay_37_from_0_out[1];
    wire [5:0] pixel_out_d37 = delay_37_from_0_out[7:2];
    wire in_valid_and_in_ready = in_valid & in_ready;
    wire [26:0] x = ({17'd0, in_column, 1'd1} << 11) - {in_center_x[25], in_center_x};
    wire [26:0] s1_chosen = in_shift[3] ? {{8{x[26]}}, x[26:8]} : x;
    wire [22:0] s1_chosen_copy2 = shift_bits_d1 ? {{4{s1_chosen_d1[22]}}, s1_chosen_d1[22:4]} : s1_chosen_d1;
    wire [18:0] s1_chosen_copy3 = shift_bits_d1_copy2 ? {{2{s1_chosen_copy2[18]}}, s1_chosen_copy2[18:2]} : s1_chosen_copy2[18:0];
    wire [16:0] s1_chosen_copy4 = shift_bits_d1_copy3 ? {s1_chosen_copy3[16], s1_chosen_copy3[16:1]} : s1_chosen_copy3[16:0];
    wire [26:0] y = ({17'd0, in_row, 1'd1} << 11) - {in_center_y[25], in_center_y};
    wire [26:0] s1_chosen_copy5 = in_shift[3] ? {{8{y[26]}}, y[26:8]} : y;
    wire [22:0] s1_chosen_copy6 = shift_bits_d1 ? {{4{s1_chosen_d1_copy3[22]}}, s1_chosen_d1_copy3[22:4]} : s1_chosen_d1_copy3;
    wire [18:0] s1_chosen_copy7 = shift_bits_d1_copy2 ? {{2{s1_chosen_copy6[18]}}, s1_chosen_copy6[18:2]} : s1_chosen_copy6[18:0];
    wire [16:0] s1_chosen_copy8 = shift_bits_d1_copy3 ? {s1_chosen_copy7[16], s1_chosen_copy7[16:1]} : s1_chosen_copy7[16:0];
    wire [31:0] s1 = mul_s16_s16_unit_y - mul_s16_s16_unit_copy2_y;
    wire [31:0] s2 = mul_s16_s16_unit_copy3_y - mul_s16_s16_unit_copy4_y;
    wire [32:0] d_sum = {mul_s16_s16_unit_copy5_y[31], mul_s16_s16_unit_copy5_y} + d_shifted_d4;
    wire [32:0] d = {s1_chosen_times_my_d1[31], s1_chosen_times_my_d1} + d_sum_d1;
    wire sight_turned_d6 = delay_6_from_0_out[1];
    wire [32:0] weight_out_chosen_bits = {s1_d2[31], s1_d2};
    wire [32:0] weight_out_chosen_copy2 = sight_turned_d6 ? weight_out_chosen_bits : d_d1;
    wire [32:0] not_weight_out_chosen = ~weight_out_chosen_copy2;
    wire [32:0] weight_out_chosen_copy3 = weight_out_chosen_copy2[32] ? not_weight_out_chosen : weight_out_chosen_copy2;
    wire [32:0] weight_out_chosen = sight_turned_d6 ? d_d1 : weight_out_chosen_bits;
    wire [32:0] not_weight_out_chosen_copy2 = ~weight_out_chosen;
    wire [32:0] weight_out_chosen_copy4 = weight_out_chosen[32] ? not_weight_out_chosen_copy2 : weight_out_chosen;
    wire [32:0] not_s2_bits = {s2_d1[31], s2_d1};
    wire [32:0] not_s2 = ~not_s2_bits;
    wire [32:0] weight_out_chosen_copy5 = s2_d1[31] ? not_s2 : not_s2_bits;
    wire weight_out_same = weight_out_chosen_bits_d1[31:16] == 16'd0;
    wire weight_out_same_copy2 = 16'd0 == weight_out_chosen_bits_d1_copy2[31:16];
    wire weight_out_same_copy3 = 16'd0 == weight_out_chosen_bits_d1_copy3[31:16];
    wire weight_out_both = weight_out_same_d1_copy2 & weight_out_same_d2;
    wire not_weight_out_both = ~weight_out_both;
    wire weight_out_both_copy2 = weight_out_same_d1 & not_weight_out_both;
    wire [31:0] weight_out_chosen_copy6 = weight_out_same_d1 ? (weight_out_chosen_bits_d2 << 16) : weight_out_chosen_bits_d2;
    wire [31:0] weight_out_chosen_copy7 = weight_out_same_d1 ? (weight_out_chosen_bits_d2_copy2 << 16) : weight_out_chosen_bits_d2_copy2;
    wire [31:0] weight_out_chosen_copy8 = weight_out_same_d1 ? (weight_out_chosen_bits_d3 << 16) : weight_out_chosen_bits_d3;
    wire weight_out_chosen_bits_is_zero = weight_out_chosen_copy6[31:24] == 8'd0;
    wire zero_is_weight_out_chosen_bits = 8'd0 == weight_out_chosen_copy7[31:24];
    wire zero_is_weight_out_chosen_bits_copy2 = 8'd0 == weight_out_chosen_copy8[31:24];
    wire weight_out_both_copy3 = zero_is_weight_out_chosen_bits_d1 & zero_is_weight_out_chosen_bits_d1_copy2;
    wire not_weight_out_both_copy2 = ~weight_out_both_copy3;
    wire weight_out_both_copy4 = weight_out_chosen_bits_is_zero_d1 & not_weight_out_both_copy2;
    wire weight_out_either = weight_out_both_d2 | weight_out_both_d1_copy2;
    wire [31:0] weight_out_chosen_copy9 = weight_out_chosen_bits_is_zero_d1 ? (weight_out_chosen_d1 << 8) : weight_out_chosen_d1;
    wire [31:0] weight_out_chosen_copy10 = weight_out_chosen_bits_is_zero_d1 ? (weight_out_chosen_d1_copy2 << 8) : weight_out_chosen_d1_copy2;
    wire [31:0] weight_out_chosen_copy11 = weight_out_chosen_bits_is_zero_d1 ? (weight_out_chosen_d1_copy3 << 8) : weight_out_chosen_d1_copy3;
    wire weight_out_same_copy4 = weight_out_chosen_copy9[31:28] == 4'd0;
    wire weight_out_same_copy5 = 4'd0 == weight_out_chosen_copy10[31:28];
    wire weight_out_same_copy6 = 4'd0 == weight_out_chosen_copy11[31:28];
    wire weight_out_both_copy5 = weight_out_same_d1_copy5 & weight_out_same_d1_copy6;
    wire not_weight_out_both_copy3 = ~weight_out_both_copy5;
    wire weight_out_both_copy6 = weight_out_same_d1_copy4 & not_weight_out_both_copy3;
    wire [24:0] weight_out_chosen_copy12 = weight_out_same_d1_copy4 ? (weight_out_chosen_bits_d1_copy4 << 4) : weight_out_chosen_bits_d1_copy4;
    wire weight_out_same_copy7 = weight_out_chosen_copy12[24:23] == 2'd0;
    wire [24:0] weight_out_chosen_copy13 = weight_out_same_d1_copy4 ? (weight_out_chosen_bits_d1_copy5 << 4) : weight_out_chosen_bits_d1_copy5;
    wire weight_out_same_copy8 = 2'd0 == weight_out_chosen_copy13[24:23];
    wire [24:0] weight_out_chosen_copy14 = weight_out_same_d1_copy4 ? (weight_out_chosen_bits_d1_copy6 << 4) : weight_out_chosen_bits_d1_copy6;
    wire weight_out_same_copy9 = 2'd0 == weight_out_chosen_copy14[24:23];
    wire weight_out_both_copy7 = weight_out_same_copy8 & weight_out_same_copy9;
    wire weight_out_either_copy2 = weight_out_either_d1 | weight_out_both_d1_copy3;
    wire not_weight_out_both_copy4 = ~weight_out_both_d1_copy4;
    wire weight_out_both_copy8 = weight_out_same_d1_copy7 & not_weight_out_both_copy4;
    wire weight_out_either_copy3 = weight_out_either_copy2 | weight_out_both_copy8;
    wire [20:0] weight_out_chosen_copy15 = weight_out_same_copy7 ? (weight_out_chosen_copy12[24:4] << 2) : weight_out_chosen_copy12[24:4];
    wire [20:0] weight_out_chosen_copy16 = weight_out_same_copy7 ? (weight_out_chosen_copy13[24:4] << 2) : weight_out_chosen_copy13[24:4];
    wire [20:0] weight_out_chosen_copy17 = weight_out_same_copy7 ? (weight_out_chosen_copy14[24:4] << 2) : weight_out_chosen_copy14[24:4];
    wire weight_out_same_copy10 = ~weight_out_chosen_bits_d1_copy7[18];
    wire weight_out_same_copy11 = ~weight_out_chosen_bits_d1_copy8[18];
    wire weight_out_same_copy12 = ~weight_out_chosen_bits_d1_copy9[18];
    wire weight_out_both_copy9 = weight_out_same_copy11 & weight_out_same_copy12;
    wire not_weight_out_both_copy5 = ~weight_out_both_copy9;
    wire [18:0] denominator_chosen = weight_out_same_copy10 ? (weight_out_chosen_bits_d1_copy7 << 1) : weight_out_chosen_bits_d1_copy7;
    wire [18:0] weight_out_chosen_copy18 = weight_out_same_copy10 ? (weight_out_chosen_bits_d1_copy8 << 1) : weight_out_chosen_bits_d1_copy8;
    wire [18:0] weight_out_chosen_copy19 = weight_out_same_copy10 ? (weight_out_chosen_bits_d1_copy9 << 1) : weight_out_chosen_bits_d1_copy9;
    wire [36:0] weight_out_sum = {1'd0, mul_u18_u18_unit_copy2_y} + {1'd0, mul_u18_u18_unit_copy3_y};
    wire weight_out_in_order = weight_out_sum_d1 < {1'd0, denominator_d1};
    wire weight_out_both_copy10 = weight_out_same_d1_copy8 & not_weight_out_both_d1;
    wire weight_out_either_copy4 = weight_out_either_d1_copy2 | weight_out_both_copy10;
    wire not_weight_out_either = ~weight_out_either_copy4;
    wire weight_out_both_copy11 = weight_out_in_order_d1 & not_weight_out_either_d4;
    wire weight_out_in_order_d9 = delay_9_from_0_out[0];
    wire weight_out_both_copy12 = weight_out_both_copy11 & weight_out_in_order_d9;
    wire weight_out_in_order_d9_copy2 = delay_9_from_0_out[1];
    wire weight_out_both_copy13 = weight_out_both_copy12 & weight_out_in_order_d9_copy2;
    wire [23:0] weight_out_difference = weight_out_shifted_d1 - denominator_bits_d1;
    wire not_weight_out_difference_sign = ~weight_out_difference[23];
    wire [23:0] weight_out_chosen_copy20 = weight_out_difference[23] ? weight_out_shifted_d1 : weight_out_difference;
    wire [23:0] weight_out_difference_copy2 = weight_out_shifted_d1_copy2 - denominator_bits_d2;
    wire not_weight_out_difference_sign_copy2 = ~weight_out_difference_copy2[23];
    wire [23:0] weight_out_chosen_copy21 = weight_out_difference_copy2[23] ? weight_out_shifted_d1_copy2 : weight_out_difference_copy2;
    wire [23:0] weight_out_difference_copy3 = weight_out_shifted_d1_copy3 - denominator_bits_d3;
    wire not_weight_out_difference_sign_copy3 = ~weight_out_difference_copy3[23];
    wire [23:0] weight_out_chosen_copy22 = weight_out_difference_copy3[23] ? weight_out_shifted_d1_copy3 : weight_out_difference_copy3;
    wire [23:0] weight_out_difference_copy4 = weight_out_shifted_d1_copy4 - denominator_bits_d4;
    wire not_weight_out_difference_sign_copy4 = ~weight_out_difference_copy4[23];
    wire [23:0] weight_out_chosen_copy23 = weight_out_difference_copy4[23] ? weight_out_shifted_d1_copy4 : weight_out_difference_copy4;
    wire [23:0] weight_out_difference_copy5 = weight_out_shifted_d1_copy5 - denominator_bits_d5;
    wire not_weight_out_difference_sign_copy5 = ~weight_out_difference_copy5[23];
    wire [23:0] weight_out_chosen_copy24 = weight_out_difference_copy5[23] ? weight_out_shifted_d1_copy5 : weight_out_difference_copy5;
    wire [23:0] weight_out_difference_copy6 = weight_out_shifted_d1_copy6 - denominator_bits_d6;
    wire not_weight_out_difference_sign_copy6 = ~weight_out_difference_copy6[23];
    wire [23:0] weight_out_chosen_copy25 = weight_out_difference_copy6[23] ? weight_out_shifted_d1_copy6 : weight_out_difference_copy6;
    wire [23:0] weight_out_difference_copy7 = weight_out_shifted_d1_copy7 - denominator_bits_d7;
    wire not_weight_out_difference_sign_copy7 = ~weight_out_difference_copy7[23];
    wire [23:0] weight_out_chosen_copy26 = weight_out_difference_copy7[23] ? weight_out_shifted_d1_copy7 : weight_out_difference_copy7;
    wire [23:0] weight_out_difference_copy8 = weight_out_shifted_d1_copy8 - denominator_bits_d8;
    wire not_weight_out_difference_sign_copy8 = ~weight_out_difference_copy8[23];
    wire [23:0] weight_out_chosen_copy27 = weight_out_difference_copy8[23] ? weight_out_shifted_d1_copy8 : weight_out_difference_copy8;
    wire [23:0] weight_out_difference_copy9 = weight_out_shifted_d1_copy9 - denominator_bits_d9;
    wire not_weight_out_difference_sign_copy9 = ~weight_out_difference_copy9[23];
    wire [23:0] weight_out_chosen_copy28 = weight_out_difference_copy9[23] ? weight_out_shifted_d1_copy9 : weight_out_difference_copy9;
    wire [23:0] weight_out_difference_copy10 = weight_out_shifted_d1_copy10 - denominator_bits_d10;
    wire not_weight_out_difference_sign_copy10 = ~weight_out_difference_copy10[23];
    wire [23:0] weight_out_chosen_copy29 = weight_out_difference_copy10[23] ? weight_out_shifted_d1_copy10 : weight_out_difference_copy10;
    wire [23:0] weight_out_difference_copy11 = weight_out_shifted_d1_copy11 - denominator_bits_d11;
    wire not_weight_out_difference_sign_copy11 = ~weight_out_difference_copy11[23];
    wire [23:0] weight_out_chosen_copy30 = weight_out_difference_copy11[23] ? weight_out_shifted_d1_copy11 : weight_out_difference_copy11;
    wire [23:0] weight_out_difference_copy12 = weight_out_shifted_d1_copy12 - denominator_bits_d12;
    wire not_weight_out_difference_sign_copy12 = ~weight_out_difference_copy12[23];
    wire [23:0] weight_out_chosen_copy31 = weight_out_difference_copy12[23] ? weight_out_shifted_d1_copy12 : weight_out_difference_copy12;
    wire [23:0] weight_out_difference_copy13 = weight_out_shifted_d1_copy13 - denominator_bits_d13;
    wire not_weight_out_difference_sign_copy13 = ~weight_out_difference_copy13[23];
    wire [23:0] weight_out_chosen_copy32 = weight_out_difference_copy13[23] ? weight_out_shifted_d1_copy13 : weight_out_difference_copy13;
    wire [23:0] weight_out_difference_copy14 = weight_out_shifted_d1_copy14 - denominator_bits_d14;
    wire not_weight_out_difference_sign_copy14 = ~weight_out_difference_copy14[23];
    wire [23:0] weight_out_chosen_copy33 = weight_out_difference_copy14[23] ? weight_out_shifted_d1_copy14 : weight_out_difference_copy14;
    wire [23:0] weight_out_difference_copy15 = weight_out_shifted_d1_copy15 - denominator_bits_d15;
    wire not_weight_out_difference_sign_copy15 = ~weight_out_difference_copy15[23];
    wire [23:0] weight_out_chosen_copy34 = weight_out_difference_copy15[23] ? weight_out_shifted_d1_copy15 : weight_out_difference_copy15;
    wire [23:0] weight_out_difference_copy16 = weight_out_shifted_d1_copy16 - denominator_bits_d16;
    wire not_weight_out_difference_sign_copy16 = ~weight_out_difference_copy16[23];
    wire [15:0] weight_out_chosen_copy35 = delay_14_from_0_out ? weight_out_joined_d1_copy15 : 16'hffff;
    wire x_bits_is_zero = x_bits_d1 == 12'd0;
    wire weight_out_same_copy13 = x_bits_d1 == 12'hfff;
    wire weight_out_either_copy5 = x_bits_is_zero | weight_out_same_copy13;
    wire zero_is_y_bits = 12'd0 == y_bits_d1;
    wire weight_out_same_copy14 = 12'hfff == y_bits_d1;
    wire weight_out_either_copy6 = zero_is_y_bits | weight_out_same_copy14;
    wire weight_out_both_copy15 = weight_out_either_d1_copy3 & weight_out_either_d1_copy4;
    wire [31:0] weight_out_sum_copy2 = mul_s16_s16_unit_copy7_y + mul_s16_s16_unit_copy8_y;
    wire zero_is_weight_out_sum_bits = 4'd0 == weight_out_sum_bits_d1;
    wire weight_out_both_copy16 = weight_out_both_d2_copy2 & zero_is_weight_out_sum_bits;
    wire weight_out_same_copy15 = 8'd0 == mul_u18_u16_unit_y[33:26];
    wire weight_out_both_copy17 = weight_out_both_d2_copy3 & weight_out_same_copy15;
    wire [15:0] weight_out_lesser = (delay_25_from_0_out < weight_out_chosen_d1_copy4) ? delay_25_from_0_out : weight_out_chosen_d1_copy4;
    wire [19:0] sight_far_d7 = delay_7_from_0_out[39:20];
    wire weight_out_in_order_copy3 = ~(weight_out_chosen_bits_d1[31:12] < sight_far_d7);
    wire [19:0] sight_near_d7 = delay_7_from_0_out[19:0];
    wire weight_out_in_order_copy2 = ~(sight_near_d7 < weight_out_chosen_bits_d1[31:12]);
    wire sight_negative_d6 = delay_6_from_0_out[0];
    wire weight_out_unequal = sight_negative_d6 ^ weight_out_chosen_copy2[32];
    wire not_weight_out_unequal = ~weight_out_unequal;
    wire weight_out_both_copy14 = weight_out_both_d1_copy5 & delay_11_from_0_out;
    wire sight_disc_d7 = delay_7_from_0_out[40];
    wire sight_disc_and_weight_out_both = sight_disc_d7 & weight_out_both_d1_copy8;
    wire [15:0] weight_out_chosen_copy36 = weight_out_both_d1_copy8 ? weight_out_product_bits_d1 : 16'hffff;
    wire [15:0] weight_out_chosen_copy37 = sight_disc_and_weight_out_both ? weight_out_chosen_copy36 : 16'hffff;

    assign {out_last, out_inside, out_slot, out_pixel, out_weight} = queue_1_out_data;

    integer_mul_s2_s16_s16 mul_s16_s16_unit (
        .clk(clk), .enable(1'd1), .a(s1_chosen_d1_copy2), .b(ay_d2), .y(mul_s16_s16_unit_y)
    );

    integer_mul_s2_s16_s16 mul_s16_s16_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(s1_chosen_d1_copy4), .b(ax_d2), .y(mul_s16_s16_unit_copy2_y)
    );

    integer_mul_s2_s16_s16 mul_s16_s16_unit_copy3 (
        .clk(clk), .enable(1'd1), .a(s1_chosen_d1_copy2), .b(by_d2), .y(mul_s16_s16_unit_copy3_y)
    );

    integer_mul_s2_s16_s16 mul_s16_s16_unit_copy4 (
        .clk(clk), .enable(1'd1), .a(s1_chosen_d1_copy4), .b(bx_d2), .y(mul_s16_s16_unit_copy4_y)
    );

    integer_mul_s2_s16_s16 mul_s16_s16_unit_copy5 (
        .clk(clk), .enable(1'd1), .a(s1_chosen_d1_copy2), .b(mx_d2), .y(mul_s16_s16_unit_copy5_y)
    );

    integer_mul_s2_s16_s16 mul_s16_s16_unit_copy6 (
        .clk(clk), .enable(1'd1), .a(s1_chosen_d1_copy4), .b(my_d2), .y(mul_s16_s16_unit_copy6_y)
    );

    integer_mul_s2_s16_s16 mul_s16_s16_unit_copy7 (
        .clk(clk), .enable(1'd1), .a(x_bits_d1_copy2), .b(x_bits_d1_copy2), .y(mul_s16_s16_unit_copy7_y)
    );

    integer_mul_s2_s16_s16 mul_s16_s16_unit_copy8 (
        .clk(clk), .enable(1'd1), .a(y_bits_d1_copy2), .b(y_bits_d1_copy2), .y(mul_s16_s16_unit_copy8_y)
    );

    integer_mul_s2_u18_u18 mul_u18_u18_unit (
        .clk(clk), .enable(1'd1), .a(denominator_chosen_bits_d1), .b(denominator_chosen_bits_d1),
        .y(mul_u18_u18_unit_y)
    );

    integer_mul_s2_u18_u18 mul_u18_u18_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(weight_out_chosen_bits_d1_copy10), .b(weight_out_chosen_bits_d1_copy10),
        .y(mul_u18_u18_unit_copy2_y)
    );

    integer_mul_s2_u18_u18 mul_u18_u18_unit_copy3 (
        .clk(clk), .enable(1'd1), .a(weight_out_chosen_bits_d1_copy11), .b(weight_out_chosen_bits_d1_copy11),
        .y(mul_u18_u18_unit_copy3_y)
    );

    integer_mul_s2_u18_u16 mul_u18_u16_unit (
        .clk(clk), .enable(1'd1), .a(weight_out_sum_bits_d1_copy2), .b(filter_scale), .y(mul_u18_u16_unit_y)
    );

    float_table_s4_i8_f8 interpolate_8_8_16_unit (
        .clk(clk), .enable(1'd1), .a(weight_out_lesser_d1), .y(interpolate_8_8_16_unit_y)
    );

    stream_fifo_d41_w25_distributed queue_1 (
        .clk(clk), .rst(rst), .in_valid(kept), .in_ready(queue_1_in_ready),
        .in_data({last_d37, covered, slot_d37, pixel_out_d37, interpolate_8_8_16_unit_y}),
        .out_valid(out_valid), .out_ready(out_ready), .out_data(queue_1_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            credits <= 7'd40;
            delay_6_from_0_pointer <= 3'd0;
            delay_7_from_0_pointer <= 3'd0;
            delay_9_from_0_pointer <= 3'd0;
            delay_11_from_0_pointer <= 4'd0;
            delay_14_from_0_pointer <= 4'd0;
            delay_25_from_0_pointer <= 5'd0;
            delay_30_from_0_pointer <= 5'd0;
            delay_37_from_0_pointer <= 6'd0;
            in_flight <= 37'd0;
            left <= 1'd0;
            dropped <= 1'd0;
        end else begin
            credits <= (credits - {6'd0, in_valid_and_in_ready}) + {6'd0, left} + {6'd0, dropped};
            delay_6_from_0_pointer <= (delay_6_from_0_pointer == 3'd4) ? (delay_6_from_0_pointer - 3'd4) : (delay_6_from_0_pointer + 3'd1);
            delay_7_from_0_pointer <= (delay_7_from_0_pointer == 3'd5) ? (delay_7_from_0_pointer - 3'd5) : (delay_7_from_0_pointer + 3'd1);
            delay_9_from_0_pointer <= (delay_9_from_0_pointer == 3'd7) ? (delay_9_from_0_pointer - 3'd7) : (delay_9_from_0_pointer + 3'd1);
            delay_11_from_0_pointer <= (delay_11_from_0_pointer == 4'd9) ? (delay_11_from_0_pointer - 4'd9) : (delay_11_from_0_pointer + 4'd1);
            delay_14_from_0_pointer <= (delay_14_from_0_pointer == 4'd12) ? (delay_14_from_0_pointer - 4'd12) : (delay_14_from_0_pointer + 4'd1);
            delay_25_from_0_pointer <= (delay_25_from_0_pointer == 5'd23) ? (delay_25_from_0_pointer - 5'd23) : (delay_25_from_0_pointer + 5'd1);
            delay_30_from_0_pointer <= (delay_30_from_0_pointer == 5'd28) ? (delay_30_from_0_pointer - 5'd28) : (delay_30_from_0_pointer + 5'd1);
            delay_37_from_0_pointer <= (delay_37_from_0_pointer == 6'd35) ? (delay_37_from_0_pointer - 6'd35) : (delay_37_from_0_pointer + 6'd1);
            in_flight <= {in_flight[35:0], in_valid_and_in_ready};
            left <= out_valid & out_ready;
            dropped <= in_flight[36] & ~last_or_covered;
        end
    end
    always @(posedge clk) begin
        s1_chosen_d1 <= s1_chosen[22:0];
        shift_bits_d1 <= in_shift[2];
        shift_bits_d1_copy2 <= in_shift[1];
        shift_bits_d1_copy3 <= in_shift[0];
        s1_chosen_d1_copy2 <= s1_chosen_copy4[15:0];
        s1_chosen_d1_copy3 <= s1_chosen_copy5[22:0];
        s1_chosen_d1_copy4 <= s1_chosen_copy8[15:0];
        ay_d1 <= in_ay;
        ay_d2 <= ay_d1;
        ax_d1 <= in_ax;
        ax_d2 <= ax_d1;
        s1_d1 <= s1;
        s1_d2 <= s1_d1;
        by_d1 <= in_by;
        by_d2 <= by_d1;
        bx_d1 <= in_bx;
        bx_d2 <= bx_d1;
        s2_d1 <= s2;
        mx_d1 <= in_mx;
        mx_d2 <= mx_d1;
        my_d1 <= in_my;
        my_d2 <= my_d1;
        s1_chosen_times_my_d1 <= mul_s16_s16_unit_copy6_y;
        d_shifted_d1 <= {{13{in_delta[19]}}, in_delta} << 12;
        d_shifted_d2 <= d_shifted_d1;
        d_shifted_d3 <= d_shifted_d2;
        d_shifted_d4 <= d_shifted_d3;
        d_sum_d1 <= d_sum;
        d_d1 <= d;
        weight_out_chosen_bits_d1 <= weight_out_chosen_copy3[31:0];
        weight_out_chosen_bits_d2 <= weight_out_chosen_bits_d1;
        weight_out_chosen_bits_d1_copy2 <= weight_out_chosen_copy4[31:0];
        weight_out_chosen_bits_d2_copy2 <= weight_out_chosen_bits_d1_copy2;
        weight_out_chosen_bits_d1_copy3 <= weight_out_chosen_copy5[31:0];
        weight_out_chosen_bits_d2_copy3 <= weight_out_chosen_bits_d1_copy3;
        weight_out_chosen_bits_d3 <= weight_out_chosen_bits_d2_copy3;
        weight_out_same_d1 <= weight_out_same;
        weight_out_same_d1_copy2 <= weight_out_same_copy2;
        weight_out_same_d1_copy3 <= weight_out_same_copy3;
        weight_out_same_d2 <= weight_out_same_d1_copy3;
        weight_out_both_d1 <= weight_out_both_copy2;
        weight_out_both_d2 <= weight_out_both_d1;
        weight_out_chosen_d1 <= weight_out_chosen_copy6;
        weight_out_chosen_d1_copy2 <= weight_out_chosen_copy7;
        weight_out_chosen_d1_copy3 <= weight_out_chosen_copy8;
        weight_out_chosen_bits_is_zero_d1 <= weight_out_chosen_bits_is_zero;
        zero_is_weight_out_chosen_bits_d1 <= zero_is_weight_out_chosen_bits;
        zero_is_weight_out_chosen_bits_d1_copy2 <= zero_is_weight_out_chosen_bits_copy2;
        weight_out_both_d1_copy2 <= weight_out_both_copy4;
        weight_out_either_d1 <= weight_out_either;
        weight_out_chosen_bits_d1_copy4 <= weight_out_chosen_copy9[31:7];
        weight_out_chosen_bits_d1_copy5 <= weight_out_chosen_copy10[31:7];
        weight_out_chosen_bits_d1_copy6 <= weight_out_chosen_copy11[31:7];
        weight_out_same_d1_copy4 <= weight_out_same_copy4;
        weight_out_same_d1_copy5 <= weight_out_same_copy5;
        weight_out_same_d1_copy6 <= weight_out_same_copy6;
        weight_out_both_d1_copy3 <= weight_out_both_copy6;
        weight_out_same_d1_copy7 <= weight_out_same_copy7;
        weight_out_both_d1_copy4 <= weight_out_both_copy7;
        weight_out_either_d1_copy2 <= weight_out_either_copy3;
        weight_out_chosen_bits_d1_copy7 <= weight_out_chosen_copy15[20:2];
        weight_out_chosen_bits_d1_copy8 <= weight_out_chosen_copy16[20:2];
        weight_out_chosen_bits_d1_copy9 <= weight_out_chosen_copy17[20:2];
        weight_out_same_d1_copy8 <= weight_out_same_copy10;
        not_weight_out_both_d1 <= not_weight_out_both_copy5;
        denominator_chosen_bits_d1 <= denominator_chosen[18:1];
        weight_out_chosen_bits_d1_copy10 <= weight_out_chosen_copy18[18:1];
        weight_out_chosen_bits_d1_copy11 <= weight_out_chosen_copy19[18:1];
        denominator_d1 <= mul_u18_u18_unit_y;
        weight_out_sum_d1 <= weight_out_sum;
        weight_out_in_order_d1 <= weight_out_in_order;
        not_weight_out_either_d1 <= not_weight_out_either;
        not_weight_out_either_d2 <= not_weight_out_either_d1;
        not_weight_out_either_d3 <= not_weight_out_either_d2;
        not_weight_out_either_d4 <= not_weight_out_either_d3;
        weight_out_both_d1_copy5 <= weight_out_both_copy13;
        denominator_bits_d1 <= {2'd0, mul_u18_u18_unit_y[35:14]};
        denominator_bits_d2 <= denominator_bits_d1;
        denominator_bits_d3 <= denominator_bits_d2;
        denominator_bits_d4 <= denominator_bits_d3;
        denominator_bits_d5 <= denominator_bits_d4;
        denominator_bits_d6 <= denominator_bits_d5;
        denominator_bits_d7 <= denominator_bits_d6;
        denominator_bits_d8 <= denominator_bits_d7;
        denominator_bits_d9 <= denominator_bits_d8;
        denominator_bits_d10 <= denominator_bits_d9;
        denominator_bits_d11 <= denominator_bits_d10;
        denominator_bits_d12 <= denominator_bits_d11;
        denominator_bits_d13 <= denominator_bits_d12;
        denominator_bits_d14 <= denominator_bits_d13;
        denominator_bits_d15 <= denominator_bits_d14;
        denominator_bits_d16 <= denominator_bits_d15;
        weight_out_shifted_d1 <= {2'd0, weight_out_sum[35:14]} << 1;
        not_weight_out_difference_sign_d1 <= not_weight_out_difference_sign;
        weight_out_shifted_d1_copy2 <= {2'd0, weight_out_chosen_copy20[21:0]} << 1;
        weight_out_joined_d1 <= {not_weight_out_difference_sign_d1, not_weight_out_difference_sign_copy2};
        weight_out_shifted_d1_copy3 <= {2'd0, weight_out_chosen_copy21[21:0]} << 1;
        weight_out_joined_d1_copy2 <= {weight_out_joined_d1, not_weight_out_difference_sign_copy3};
        weight_out_shifted_d1_copy4 <= {2'd0, weight_out_chosen_copy22[21:0]} << 1;
        weight_out_joined_d1_copy3 <= {weight_out_joined_d1_copy2, not_weight_out_difference_sign_copy4};
        weight_out_shifted_d1_copy5 <= {2'd0, weight_out_chosen_copy23[21:0]} << 1;
        weight_out_joined_d1_copy4 <= {weight_out_joined_d1_copy3, not_weight_out_difference_sign_copy5};
        weight_out_shifted_d1_copy6 <= {2'd0, weight_out_chosen_copy24[21:0]} << 1;
        weight_out_joined_d1_copy5 <= {weight_out_joined_d1_copy4, not_weight_out_difference_sign_copy6};
        weight_out_shifted_d1_copy7 <= {2'd0, weight_out_chosen_copy25[21:0]} << 1;
        weight_out_joined_d1_copy6 <= {weight_out_joined_d1_copy5, not_weight_out_difference_sign_copy7};
        weight_out_shifted_d1_copy8 <= {2'd0, weight_out_chosen_copy26[21:0]} << 1;
        weight_out_joined_d1_copy7 <= {weight_out_joined_d1_copy6, not_weight_out_difference_sign_copy8};
        weight_out_shifted_d1_copy9 <= {2'd0, weight_out_chosen_copy27[21:0]} << 1;
        weight_out_joined_d1_copy8 <= {weight_out_joined_d1_copy7, not_weight_out_difference_sign_copy9};
        weight_out_shifted_d1_copy10 <= {2'd0, weight_out_chosen_copy28[21:0]} << 1;
        weight_out_joined_d1_copy9 <= {weight_out_joined_d1_copy8, not_weight_out_difference_sign_copy10};
        weight_out_shifted_d1_copy11 <= {2'd0, weight_out_chosen_copy29[21:0]} << 1;
        weight_out_joined_d1_copy10 <= {weight_out_joined_d1_copy9, not_weight_out_difference_sign_copy11};
        weight_out_shifted_d1_copy12 <= {2'd0, weight_out_chosen_copy30[21:0]} << 1;
        weight_out_joined_d1_copy11 <= {weight_out_joined_d1_copy10, not_weight_out_difference_sign_copy12};
        weight_out_shifted_d1_copy13 <= {2'd0, weight_out_chosen_copy31[21:0]} << 1;
        weight_out_joined_d1_copy12 <= {weight_out_joined_d1_copy11, not_weight_out_difference_sign_copy13};
        weight_out_shifted_d1_copy14 <= {2'd0, weight_out_chosen_copy32[21:0]} << 1;
        weight_out_joined_d1_copy13 <= {weight_out_joined_d1_copy12, not_weight_out_difference_sign_copy14};
        weight_out_shifted_d1_copy15 <= {2'd0, weight_out_chosen_copy33[21:0]} << 1;
        weight_out_joined_d1_copy14 <= {weight_out_joined_d1_copy13, not_weight_out_difference_sign_copy15};
        weight_out_shifted_d1_copy16 <= {2'd0, weight_out_chosen_copy34[21:0]} << 1;
        weight_out_joined_d1_copy15 <= {weight_out_joined_d1_copy14, not_weight_out_difference_sign_copy16};
        weight_out_chosen_d1_copy4 <= weight_out_chosen_copy35;
        x_bits_d1 <= x[26:15];
        weight_out_either_d1_copy3 <= weight_out_either_copy5;
        x_bits_d1_copy2 <= x[15:0];
        y_bits_d1 <= y[26:15];
        weight_out_either_d1_copy4 <= weight_out_either_copy6;
        y_bits_d1_copy2 <= y[15:0];
        weight_out_both_d1_copy6 <= weight_out_both_copy15;
        weight_out_both_d2_copy2 <= weight_out_both_d1_copy6;
        weight_out_sum_bits_d1 <= weight_out_sum_copy2[31:28];
        weight_out_both_d1_copy7 <= weight_out_both_copy16;
        weight_out_both_d2_copy3 <= weight_out_both_d1_copy7;
        weight_out_sum_bits_d1_copy2 <= weight_out_sum_copy2[27:10];
        weight_out_both_d1_copy8 <= weight_out_both_copy17;
        weight_out_product_bits_d1 <= mul_u18_u16_unit_y[25:10];
        weight_out_lesser_d1 <= weight_out_lesser;
    end
    always @(posedge clk) begin
        delay_6_from_0[delay_6_from_0_pointer] <= {delay_14_from_0_out, in_sight_turned, in_sight_negative};
        delay_6_from_0_out <= delay_6_from_0[delay_6_from_0_pointer];
    end
    always @(posedge clk) begin
        delay_7_from_0[delay_7_from_0_pointer] <= {in_sight_disc, in_sight_far, in_sight_near};
        delay_7_from_0_out <= delay_7_from_0[delay_7_from_0_pointer];
    end
    always @(posedge clk) begin
        delay_9_from_0[delay_9_from_0_pointer] <= {weight_out_in_order_copy3, weight_out_in_order_copy2};
        delay_9_from_0_out <= delay_9_from_0[delay_9_from_0_pointer];
    end
    always @(posedge clk) begin
        delay_11_from_0[delay_11_from_0_pointer] <= not_weight_out_unequal;
        delay_11_from_0_out <= delay_11_from_0[delay_11_from_0_pointer];
    end
    always @(posedge clk) begin
        delay_14_from_0[delay_14_from_0_pointer] <= weight_out_both_copy14;
        delay_14_from_0_out <= delay_14_from_0[delay_14_from_0_pointer];
    end
    always @(posedge clk) begin
        delay_25_from_0[delay_25_from_0_pointer] <= weight_out_chosen_copy37;
        delay_25_from_0_out <= delay_25_from_0[delay_25_from_0_pointer];
    end
    always @(posedge clk) begin
        delay_30_from_0[delay_30_from_0_pointer] <= sight_disc_and_weight_out_both;
        delay_30_from_0_out <= delay_30_from_0[delay_30_from_0_pointer];
    end
    always @(posedge clk) begin
        delay_37_from_0[delay_37_from_0_pointer] <= {in_row[2:0], in_column[2:0], in_slot, in_last};
        delay_37_from_0_out <= delay_37_from_0[delay_37_from_0_pointer];
    end

    wire _unused = &{
        1'b0, denominator_chosen[0], mul_u18_u16_unit_y[9:0], queue_1_in_ready, s1_chosen[26:23],
        s1_chosen_copy2[22:19], s1_chosen_copy3[18:17], s1_chosen_copy4[16], s1_chosen_copy5[26:23],
        s1_chosen_copy6[22:19], s1_chosen_copy7[18:17], s1_chosen_copy8[16], weight_out_chosen_copy10[6:0],
        weight_out_chosen_copy11[6:0], weight_out_chosen_copy12[3:0], weight_out_chosen_copy13[3:0],
        weight_out_chosen_copy14[3:0], weight_out_chosen_copy15[1:0], weight_out_chosen_copy16[1:0],
        weight_out_chosen_copy17[1:0], weight_out_chosen_copy18[0], weight_out_chosen_copy19[0],
        weight_out_chosen_copy20[23:22], weight_out_chosen_copy21[23:22], weight_out_chosen_copy22[23:22],
        weight_out_chosen_copy23[23:22], weight_out_chosen_copy24[23:22], weight_out_chosen_copy25[23:22],
        weight_out_chosen_copy26[23:22], weight_out_chosen_copy27[23:22], weight_out_chosen_copy28[23:22],
        weight_out_chosen_copy29[23:22], weight_out_chosen_copy3[32], weight_out_chosen_copy30[23:22],
        weight_out_chosen_copy31[23:22], weight_out_chosen_copy32[23:22], weight_out_chosen_copy33[23:22],
        weight_out_chosen_copy34[23:22], weight_out_chosen_copy4[32], weight_out_chosen_copy5[32],
        weight_out_chosen_copy9[6:0], weight_out_difference_copy16[22:0], weight_out_sum_copy2[9:0]
    };

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        queue_1_has_a_place_for_each_result: assert (~kept | queue_1_in_ready);
`else
        if (!(~kept | queue_1_in_ready)) begin
            $display("assertion failed: queue_1_has_a_place_for_each_result in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue in a memory with a registered output.
// depth = 41
// width = 25
// storage = distributed
module stream_fifo_d41_w25_distributed (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [24:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [24:0] out_data
);
    (* ram_style = "distributed" *)
    reg [24:0] entries [0:40];
    reg [5:0] held, waiting;
    reg is_full, any_waits;
    reg [5:0] write_address, read_address;
    reg [24:0] item;

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
                is_full <= push & (held == 6'd40);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 6'd1);
            end
            if (push) write_address <= (write_address == 6'd40) ? 6'd0 : (write_address + 6'd1);
            if (fetch) read_address <= (read_address == 6'd40) ? 6'd0 : (read_address + 6'd1);
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
        held_in_range: assert (held <= 6'd41);
        held_is_waiting_and_shown: assert (held == (waiting + {5'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 6'd41)) & (any_waits == |waiting));
`else
        if (!(held <= 6'd41)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {5'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 6'd41)) & (any_waits == |waiting))) begin
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

// Integer product, pipelined.
// stages = 2
// a = u18
// b = u16
module integer_mul_s2_u18_u16 (
    input  wire clk, input wire enable, input wire [17:0] a, input wire [15:0] b,
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
    input  wire clk, input wire enable, input wire [17:0] a, input wire [17:0] b,
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
    input  wire clk, input wire enable, input wire [15:0] a, input wire [15:0] b,
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

// Control of the tile slots: placement, exchange with memory, end of frame.
// slots = 2
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
    input  wire [9:0] in_splat,  // Place of its splat's payload.
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
    output wire [9:0] out_splat,  // Place of its splat's payload.
    output wire out_slot,  // Slot of the tile cache.
    output wire pixel_valid, input wire pixel_ready,  // Pixels of a finished frame.
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
    input  wire [63:0] masks_written,  // A bit for each pixel that was filled or that a sample came to.
    input  wire [63:0] masks_dirty,  // A bit for each pixel that a sample came to.
    input  wire arrives_valid,  // Copies as they come before they are put in order.
    input  wire arrives_end,  // Closes the frame.
    input  wire [11:0] arrives_tile,  // Tile index: row above column.
    input  wire [9:0] arrives_splat,  // Place of its splat's payload: no other copy for the tile has it before the tile cache has passed this one on.
    output wire full,  // As many frames are under way as there are surfaces: no copy of another may come.
    output wire change_valid,  // A slot gets another tile, until that is carried out in every bank.
    output wire change_slot,  // Slot of the tile cache.
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
    output wire drain_slot,  // Slot of the tile cache.
    output wire [5:0] drain_pixel,  // Pixel of the tile.
    input  wire drained_valid,  // A pixel that was read.
    input  wire [5:0] drained_pixel,  // Pixel of the tile.
    input  wire [27:0] drained_weight,  // Sum of weights.
    input  wire [51:0] drained_depth,  // Sum of weighted depths.
    input  wire [39:0] drained_attribute_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [39:0] drained_attribute_1,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [39:0] drained_attribute_2,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire write_valid, input wire write_ready,  // Pixels of evicted tiles.
    output wire write_surface,  // The frame is one of those with odd numbers: two have a place in the buffer.
    output wire [11:0] write_tile,  // Tile index.
    output wire [5:0] write_pixel,  // Pixel of the tile.
    output wire [27:0] write_weight,  // Sum of weights.
    output wire [51:0] write_depth,  // Sum of weighted depths.
    output wire [39:0] write_attribute_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [39:0] write_attribute_1,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [39:0] write_attribute_2,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire data_valid, output wire data_ready,  // The pixels requested, in order.
    input  wire [27:0] data_weight,  // Sum of weights.
    input  wire [51:0] data_depth,  // Sum of weighted depths.
    input  wire [39:0] data_attribute_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [39:0] data_attribute_1,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [39:0] data_attribute_2,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire fill_valid,  // Write to a slot, until it is carried out.
    output wire fill_slot,  // Slot of the tile cache.
    output reg  [5:0] fill_pixel,  // Pixel of the tile.
    output reg  [27:0] fill_weight,  // Sum of weights.
    output reg  [51:0] fill_depth,  // Sum of weighted depths.
    output reg  [39:0] fill_attribute_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output reg  [39:0] fill_attribute_1,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output reg  [39:0] fill_attribute_2  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
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
    reg [9:0] head_splat;  // Place of its splat's payload.
    reg clearing, clearing_second;
    reg [12:0] cleared;
    reg surface;
    reg [64:0] mask;
    reg looking, looks_not;
    reg [1:0] unchanged;
    reg changed, keeps, keeps_none, moving, slot, comes;
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
    reg next;
    reg [11:0] tile_0;
    reg resident_0, ready_0;
    reg [7:0] in_flight_0;
    reg used_0, is_of_copy_0;
    reg [11:0] tile_1;
    reg resident_1, ready_1;
    reg [7:0] in_flight_1;
    reg used_1, is_of_copy_1, next_idle, turn_is_new, frame_leaves, frame_is_given;
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
    reg [9:0] arrived_splat;  // Place of its splat's payload: no other copy for the tile has it before the tile cache has passed this one on.
    reg arriving_surface;
    reg [1:0] whole_frames;
    wire [10:0] last_copy;
    reg looked_up, compared;
    reg found_valid;  // Copies are still to come.
    reg [9:0] found_splat;  // The splat of the last one that came.
    reg overtaken, forgets;
    reg [12:0] forgotten;

    wire in_queue_out_valid;
    wire [50:0] in_queue_out_data;
    wire out_queue_in_ready;
    wire [50:0] out_queue_out_data;
    wire pixel_queue_in_ready;
    wire [218:0] pixel_queue_out_data;
    wire gone_tiles_in_ready, gone_tiles_out_valid;
    wire [11:0] gone_tiles_out_data;
    wire read_queue_in_ready;
    wire [22:0] read_queue_out_data;
    wire asked_runs_in_ready, asked_runs_out_valid;
    wire [22:0] asked_runs_out_data;
    wire write_queue_in_ready;
    wire [218:0] write_queue_out_data;

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
    wire copy_hit = |{is_of_copy_0, is_of_copy_1};
    wire end_waits_either_2 = end_waits_either | (changed | moving);
    wire not_end_waits_either_2 = ~end_waits_either_2;
    wire misses = head_waits_and_not_head_end & ~copy_hit & (not_end_waits_either_2 & next_idle);
    wire [12:0] any_is_stored_address_choice = misses ? {surface, head_tile} : stored_masks_address_bits;
    wire copy_enters = arrived & ~arrived_end;
    wire look_is_read_both = head_empty & in_queue_out_valid;
    wire [11:0] in_queue_out_tile = in_queue_out_data[21:10];
    wire send_both = out_queue_in_ready & ~((is_of_copy_0 & &in_flight_0) | (is_of_copy_1 & &in_flight_1));
    wire send = head_waits_and_not_head_end & (copy_hit & send_both);
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
    wire any_resident = |{resident_0, resident_1};
    wire switches = end_waits & draws_what_leaves & ~any_resident;
    wire head_valid_choice = head_valid ? ~(send | switches) : in_queue_out_valid;
    wire in_queue_out_end = in_queue_out_data[50];
    wire [2:0] in_queue_out_left = in_queue_out_data[49:47];
    wire [2:0] in_queue_out_right = in_queue_out_data[46:44];
    wire [2:0] in_queue_out_top = in_queue_out_data[43:41];
    wire [2:0] in_queue_out_bottom = in_queue_out_data[40:38];
    wire [3:0] in_queue_out_first_sum = in_queue_out_data[37:34];
    wire [3:0] in_queue_out_last_sum = in_queue_out_data[33:30];
    wire [3:0] in_queue_out_first_difference = in_queue_out_data[29:26];
    wire [3:0] in_queue_out_last_difference = in_queue_out_data[25:22];
    wire [9:0] in_queue_out_splat = in_queue_out_data[9:0];
    wire [12:0] cleared_plus_1 = cleared + 13'd1;
    wire start = misses & (~any_wanted & ~sends);
    wire goes_either = (~next & resident_0) | (next & resident_1);
    wire vacate = end_waits & (goes_either & next_idle);
    wire job_starts = start | vacate;
    wire [1:0] still_unchanged = unchanged & sample_reads;
    wire change = |unchanged & (still_unchanged == 2'd0);
    wire change_and_goes = change & goes;
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
    wire skips = (~next & used_0) | (next & used_1);
    wire turns = starts | skips | (end_waits & ~(switches | (turn_is_new & goes_either)));
    wire start_and_not_next = start & ~next;
    wire starts_and_not_next = starts & ~next;
    wire done_and_comes = done & comes;
    wire done_and_comes_and_not_slot = done_and_comes & ~slot;
    wire send_and_not_is_of_copy_1 = send & ~is_of_copy_1;
    wire in_flight_0_enable_both = retire_valid & ~retire_slot;
    wire not_starts_and_not_next = ~starts_and_not_next;
    wire is_of_copy_0_both = resident_0 & not_starts_and_not_next & (tile_0 == in_queue_out_tile);
    wire start_and_next = start & next;
    wire starts_and_next = starts & next;
    wire done_and_comes_and_slot = done_and_comes & slot;
    wire send_and_is_of_copy_1 = send & is_of_copy_1;
    wire retire_valid_and_retire_slot = retire_valid & retire_slot;
    wire not_starts_and_next = ~starts_and_next;
    wire next_idle_either = (in_flight_0 == 8'd0) | ((in_flight_0 == 8'd1) & in_flight_0_enable_both);
    wire next_idle_both = ~next & (next_idle_either & ~(send_and_not_is_of_copy_1 | used_0));
    wire next_idle_either_2 = (in_flight_1 == 8'd0) | ((in_flight_1 == 8'd1) & retire_valid_and_retire_slot);
    wire next_idle_either_3 = next_idle_both | (next & (next_idle_either_2 & ~(send_and_is_of_copy_1 | used_1)));
    wire frame_begins_to_leave = |whole_frames & ~frame_leaves;
    wire looks_at_next = looks & ~gone_tiles_out_valid & any_next_place;
    wire next_place_enable_either = frame_begins_to_leave | looks_at_next;
    wire look_is_read = look_reads & ~(look_is_read_both | (misses | vacate));
    wire [1:0] seen_stays_bits = {resident_0 & (tile_0 == looked_at), resident_1 & (tile_1 == looked_at)};
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
        pixel_end, pixel_tile, pixel_pixel, pixel_weight, pixel_depth, pixel_attribute_0, pixel_attribute_1,
        pixel_attribute_2
    } = pixel_queue_out_data;
    assign slot_ready = {ready_1, ready_0};
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
        write_surface, write_tile, write_pixel, write_weight, write_depth, write_attribute_0,
        write_attribute_1, write_attribute_2
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

    memory_1w1r_unordered #(.WIDTH(11), .DEPTH(8192)) last_copies (
        .clk(clk), .write(word_is_cleared | (copy_enters | forgets)),
        .write_address(word_is_cleared ? cleared : copy_enters ? {arriving_surface, arrived_tile} : forgotten),
        .write_data({copy_enters & ~word_is_cleared, arrived_splat}),
        .read(1'd1),
        .read_address(look_is_read_both ? {surface, in_queue_out_tile} : stored_masks_address_bits),
        .read_data(last_copy)
    );

    stream_half_buffer_w51 in_queue (
        .clk(clk), .rst(rst), .in_valid(in_valid), .in_ready(in_ready),
        .in_data({
            in_end, in_left, in_right, in_top, in_bottom, in_first_sum, in_last_sum, in_first_difference,
            in_last_difference, in_tile, in_splat
        }),
        .out_valid(in_queue_out_valid), .out_ready(head_empty), .out_data(in_queue_out_data)
    );

    stream_fifo_d16_w51_distributed out_queue (
        .clk(clk), .rst(rst), .in_valid(send), .in_ready(out_queue_in_ready),
        .in_data({
            head_left, head_right, head_top, head_bottom, head_first_sum, head_last_sum, head_first_difference,
            head_last_difference, head_tile, head_splat, is_of_copy_1
        }),
        .out_valid(out_valid), .out_ready(out_ready), .out_data(out_queue_out_data)
    );

    stream_skid_w219 pixel_queue (
        .clk(clk), .rst(rst), .in_valid(closes | visible), .in_ready(pixel_queue_in_ready),
        .in_data({
            closes, asked_runs_out_tile, coming_pixel, data_weight, data_depth, data_attribute_0,
            data_attribute_1, data_attribute_2
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

    stream_fifo_d8_w219_distributed write_queue (
        .clk(clk), .rst(rst), .in_valid(drained_valid), .in_ready(write_queue_in_ready),
        .in_data({
            surface, goes_tile, drained_pixel, drained_weight, drained_depth, drained_attribute_0,
            drained_attribute_1, drained_attribute_2
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
            next <= 1'd0;
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
            used_0 <= send_and_not_is_of_copy_1 | (used_0 & next);
            is_of_copy_0 <= head_empty ? is_of_copy_0_both : (start_and_not_next | (is_of_copy_0 & not_starts_and_not_next));
            used_1 <= send_and_is_of_copy_1 | (used_1 & ~next);
            is_of_copy_1 <= head_empty ? (resident_1 & not_starts_and_next & (tile_1 == in_queue_out_tile)) : (start_and_next | (is_of_copy_1 & not_starts_and_next));
            next_idle <= next_idle_either_3 & ~turns;
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
            if (turns) next <= next ? 1'd0 : (next + 1'd1);
            if (starts_and_not_next) resident_0 <= start_and_not_next;
            if (done_and_comes_and_not_slot | starts_and_not_next) begin
                ready_0 <= done_and_comes_and_not_slot;
            end
            if (send_and_not_is_of_copy_1 ^ in_flight_0_enable_both) begin
                in_flight_0 <= send_and_not_is_of_copy_1 ? (in_flight_0 + 8'd1) : (in_flight_0 - 8'd1);
            end
            if (starts_and_next) resident_1 <= start_and_next;
            if (done_and_comes_and_slot | starts_and_next) ready_1 <= done_and_comes_and_slot;
            if (send_and_is_of_copy_1 ^ retire_valid_and_retire_slot) begin
                in_flight_1 <= send_and_is_of_copy_1 ? (in_flight_1 + 8'd1) : (in_flight_1 - 8'd1);
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
            goes <= goes_either;
            goes_tile <= ({12{~next}} & tile_0) | ({12{next}} & tile_1);
        end
        if (begins) begin
            wanted_mask <= wanted_mask_choice[63:0];
            wanted_surface <= sends ? surface_xor_frame_is_given : surface;
            wanted_tile <= sends ? looked_at : tile;
        end
        if (wanted_row_ends) wanted_row <= wanted_row_either_7 | {3{wanted_row_both}};
        if (keeps) leaving_mask <= masks_dirty;
        if (leaving_row_ends) leaving_row <= leaving_row_either_8 | {3{leaving_row_both}};
        if (start_and_not_next) tile_0 <= head_tile;
        if (start_and_next) tile_1 <= head_tile;
        if (next_place_enable_either) begin
            next_place <= frame_begins_to_leave ? 12'd0 : (next_place + 12'd1);
        end
        if (looks) looked_at <= gone_tiles_out_valid ? gone_tiles_out_data : next_place;
        if (look_is_shown) begin
            seen_mask <= {any_is_stored, stored_mask};
            seen_stays <= last_copy[10] | (seen_stays_either_2 & ~frame_is_given);
        end
        arrived_end <= arrives_end;
        arrived_tile <= arrives_tile;
        arrived_splat <= arrives_splat;
        found_valid <= last_copy[10];
        found_splat <= last_copy[9:0];
        overtaken <= look_is_read_both ? overtaken_both : overtaken_or_overtaken_both_2;
        if (last_reached) forgotten <= {surface, head_tile};
        if (fill_is_free) begin
            fill_pixel <= coming_pixel;
            fill_weight <= data_weight;
            fill_depth <= data_depth;
            fill_attribute_0 <= data_attribute_0;
            fill_attribute_1 <= data_attribute_1;
            fill_attribute_2 <= data_attribute_2;
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
        slot_1_retires_what_entered: assert (~retire_valid_and_retire_slot | |in_flight_1);
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
        if (!(~retire_valid_and_retire_slot | |in_flight_1)) begin
            $display("assertion failed: slot_1_retires_what_entered in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue in a memory with a registered output.
// depth = 8
// width = 219
// storage = distributed
module stream_fifo_d8_w219_distributed (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [218:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [218:0] out_data
);
    (* ram_style = "distributed" *)
    reg [218:0] entries [0:7];
    reg [3:0] held, waiting;
    reg is_full, any_waits;
    reg [2:0] write_address, read_address;
    reg [218:0] item;

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
// width = 219
module stream_skid_w219 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [218:0] in_data,
    output wire out_valid, input wire out_ready, output wire [218:0] out_data
);
    reg head_filled, second_filled, room;
    reg [218:0] head, second;

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
// width = 51
// storage = distributed
module stream_fifo_d16_w51_distributed (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [50:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [50:0] out_data
);
    (* ram_style = "distributed" *)
    reg [50:0] entries [0:15];
    reg [4:0] held, waiting;
    reg is_full, any_waits;
    reg [3:0] write_address, read_address;
    reg [50:0] item;

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
// levels = 10
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
    input  wire [9:0] in_splat,  // Place of its splat's payload.
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
    output wire [9:0] out_splat  // Place of its splat's payload.
);
    reg free_valid;
    reg [9:0] free;
    reg [10:0] fresh;
    reg draining, stage_valid;
    reg [11:0] stage_tile;
    wire [37:0] stage_rest;

    wire in_queue_out_valid;
    wire [50:0] in_queue_out_data;
    wire out_queue_in_ready;
    wire [50:0] out_queue_out_data;
    wire heap_in_ready, heap_out_valid;
    wire [11:0] heap_out_tile;
    wire [9:0] heap_out_pointer;
    wire heap_empty, returned_in_ready, returned_out_valid;
    wire [9:0] returned_out_data;

    wire open = in_queue_out_valid & ~draining;
    wire in_queue_out_end = in_queue_out_data[50];
    wire offer = open & ~in_queue_out_end & free_valid;
    wire [9:0] in_queue_out_splat = in_queue_out_data[9:0];
    wire advance = ~stage_valid | out_queue_in_ready;
    wire insert = offer & heap_in_ready;
    wire take_end = open & in_queue_out_end;
    wire in_queue_out_ready = insert | take_end;
    wire close = draining & (heap_empty & ~stage_valid & out_queue_in_ready);
    wire [11:0] in_queue_out_tile = in_queue_out_data[21:10];
    wire leaving = heap_out_valid & advance;
    wire all_used = fresh[10];
    wire returned_out_ready = ~free_valid & all_used;

    assign {
        out_end, out_left, out_right, out_top, out_bottom, out_first_sum, out_last_sum, out_first_difference,
        out_last_difference, out_tile, out_splat
    } = out_queue_out_data;

    memory_1w1r_unordered #(.WIDTH(38), .DEPTH(1024), .SLICE(18)) rests (
        .clk(clk), .write(offer), .write_address(free),
        .write_data({in_queue_out_data[49:22], in_queue_out_splat}),
        .read(advance), .read_address(heap_out_pointer), .read_data(stage_rest)
    );

    stream_half_buffer_w51 in_queue (
        .clk(clk), .rst(rst), .in_valid(in_valid), .in_ready(in_ready),
        .in_data({
            in_end, in_left, in_right, in_top, in_bottom, in_first_sum, in_last_sum, in_first_difference,
            in_last_difference, in_tile, in_splat
        }),
        .out_valid(in_queue_out_valid), .out_ready(in_queue_out_ready), .out_data(in_queue_out_data)
    );

    stream_half_buffer_w51 out_queue (
        .clk(clk), .rst(rst), .in_valid(close | (stage_valid & out_queue_in_ready)),
        .in_ready(out_queue_in_ready), .in_data({close, stage_rest[37:10], stage_tile, stage_rest[9:0]}),
        .out_valid(out_valid), .out_ready(out_ready), .out_data(out_queue_out_data)
    );

    splat_heap heap (
        .clk(clk), .rst(rst), .in_valid(offer), .in_ready(heap_in_ready), .in_tile(in_queue_out_tile),
        .in_pointer(free),
        .out_valid(heap_out_valid), .out_ready(advance), .out_tile(heap_out_tile),
        .out_pointer(heap_out_pointer),
        .empty(heap_empty)
    );

    stream_fifo_d1024_w10 returned (
        .clk(clk), .rst(rst), .in_valid(leaving), .in_ready(returned_in_ready), .in_data(heap_out_pointer),
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

// Pipelined heap that orders splat copies by tile, then by arrival.
// levels = 10
// interval = 2
// sequence_bits = 14
module splat_heap (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready,  // Entries in any order.
    input  wire [11:0] in_tile,  // Tile index.
    input  wire [9:0] in_pointer,  // Place of the rest.
    output wire out_valid, input wire out_ready,  // Entries in order.
    output wire [11:0] out_tile,  // Tile index.
    output wire [9:0] out_pointer,  // Place of the rest.
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

    wire out_queue_in_ready;
    wire [21:0] out_queue_out_data;
    wire [36:0] stage_0_root;
    wire stage_0_below_valid, stage_0_below_hole, stage_0_below_carry, stage_0_below_right;
    wire stage_0_below_left_exists, stage_0_below_right_exists, stage_0_below_follows;
    wire [36:0] stage_0_below_entry;
    wire [26:0] stage_0_below_sibling;
    wire [1:0] stage_0_below_row;
    wire [36:0] stage_2_promoted_entry;
    wire stage_2_promoted_ahead, stage_2_promoted_right, stage_2_promoted_childless;
    wire [1:0] stage_2_promoted_node;
    wire stage_2_below_valid, stage_2_below_hole, stage_2_below_carry, stage_2_below_right;
    wire stage_2_below_left_exists, stage_2_below_right_exists, stage_2_below_follows;
    wire [36:0] stage_2_below_entry;
    wire [26:0] stage_2_below_sibling;
    wire [3:0] stage_2_below_row;
    wire [36:0] stage_4_promoted_entry;
    wire stage_4_promoted_ahead, stage_4_promoted_right, stage_4_promoted_childless;
    wire [3:0] stage_4_promoted_node;
    wire stage_4_below_valid, stage_4_below_hole, stage_4_below_carry, stage_4_below_right;
    wire stage_4_below_left_exists, stage_4_below_right_exists, stage_4_below_follows;
    wire [36:0] stage_4_below_entry;
    wire [26:0] stage_4_below_sibling;
    wire [5:0] stage_4_below_row;
    wire [36:0] stage_6_promoted_entry;
    wire stage_6_promoted_ahead, stage_6_promoted_right, stage_6_promoted_childless;
    wire [5:0] stage_6_promoted_node;
    wire stage_6_below_valid, stage_6_below_hole, stage_6_below_carry, stage_6_below_right;
    wire stage_6_below_left_exists, stage_6_below_right_exists, stage_6_below_follows;
    wire [36:0] stage_6_below_entry;
    wire [26:0] stage_6_below_sibling;
    wire [7:0] stage_6_below_row;
    wire [36:0] stage_8_promoted_entry;
    wire stage_8_promoted_ahead, stage_8_promoted_right, stage_8_promoted_childless;
    wire [7:0] stage_8_promoted_node;

    wire begins = ~lower;
    wire pop = begins & (occupied & out_queue_in_ready);
    wire ready = begins & ~fresh_epoch_blocked & (~full | pop);
    wire push = ready & in_valid;
    wire newcomer_lap = lap ^ (newcomer_tile < current);
    wire push_and_not_arrival_13 = push & ~arrival[13];
    wire push_and_arrival_13 = push & arrival[13];

    assign in_ready = ready;
    assign {out_tile, out_pointer} = out_queue_out_data;
    assign empty = ~(|count | out_valid);

    stream_skid_w22 out_queue (
        .clk(clk), .rst(rst), .in_valid(pop), .in_ready(out_queue_in_ready),
        .in_data({stage_0_root[35:24], stage_0_root[9:0]}),
        .out_valid(out_valid), .out_ready(out_ready), .out_data(out_queue_out_data)
    );

    splat_heap_stage_l0 stage_0 (
        .clk(clk), .rst(rst), .lap(lap), .last_epoch(last_epoch),
        .step_valid(push | pop), .step_hole(pop), .step_carry(push), .step_right(1'd1),
        .step_left_exists(1'd0), .step_right_exists(occupied), .step_follows(1'd1),
        .step_entry({1'd0, in_tile, arrival, in_pointer}), .step_sibling(27'd0),
        .newcomer_lap(newcomer_lap),
        .below_promoted_entry(stage_2_promoted_entry), .below_promoted_ahead(stage_2_promoted_ahead),
        .below_promoted_right(stage_2_promoted_right), .below_promoted_childless(stage_2_promoted_childless),
        .below_promoted_node(stage_2_promoted_node),
        .root(stage_0_root), .below_valid(stage_0_below_valid), .below_hole(stage_0_below_hole),
        .below_carry(stage_0_below_carry), .below_right(stage_0_below_right),
        .below_left_exists(stage_0_below_left_exists), .below_right_exists(stage_0_below_right_exists),
        .below_follows(stage_0_below_follows), .below_entry(stage_0_below_entry),
        .below_sibling(stage_0_below_sibling), .below_row(stage_0_below_row)
    );

    splat_heap_stage_l2 stage_2 (
        .clk(clk), .rst(rst), .lap(lap), .last_epoch(last_epoch),
        .step_valid(stage_0_below_valid), .step_hole(stage_0_below_hole), .step_carry(stage_0_below_carry),
        .step_right(stage_0_below_right), .step_left_exists(stage_0_below_left_exists),
        .step_right_exists(stage_0_below_right_exists), .step_follows(stage_0_below_follows),
        .step_entry(stage_0_below_entry), .step_sibling(stage_0_below_sibling), .step_row(stage_0_below_row),
        .below_promoted_entry(stage_4_promoted_entry), .below_promoted_ahead(stage_4_promoted_ahead),
        .below_promoted_right(stage_4_promoted_right), .below_promoted_childless(stage_4_promoted_childless),
        .below_promoted_node(stage_4_promoted_node),
        .promoted_entry(stage_2_promoted_entry), .promoted_ahead(stage_2_promoted_ahead),
        .promoted_right(stage_2_promoted_right), .promoted_childless(stage_2_promoted_childless),
        .promoted_node(stage_2_promoted_node),
        .below_valid(stage_2_below_valid), .below_hole(stage_2_below_hole), .below_carry(stage_2_below_carry),
        .below_right(stage_2_below_right), .below_left_exists(stage_2_below_left_exists),
        .below_right_exists(stage_2_below_right_exists), .below_follows(stage_2_below_follows),
        .below_entry(stage_2_below_entry), .below_sibling(stage_2_below_sibling),
        .below_row(stage_2_below_row)
    );

    splat_heap_stage_l4 stage_4 (
        .clk(clk), .rst(rst), .lap(lap), .last_epoch(last_epoch),
        .step_valid(stage_2_below_valid), .step_hole(stage_2_below_hole), .step_carry(stage_2_below_carry),
        .step_right(stage_2_below_right), .step_left_exists(stage_2_below_left_exists),
        .step_right_exists(stage_2_below_right_exists), .step_follows(stage_2_below_follows),
        .step_entry(stage_2_below_entry), .step_sibling(stage_2_below_sibling), .step_row(stage_2_below_row),
        .below_promoted_entry(stage_6_promoted_entry), .below_promoted_ahead(stage_6_promoted_ahead),
        .below_promoted_right(stage_6_promoted_right), .below_promoted_childless(stage_6_promoted_childless),
        .below_promoted_node(stage_6_promoted_node),
        .promoted_entry(stage_4_promoted_entry), .promoted_ahead(stage_4_promoted_ahead),
        .promoted_right(stage_4_promoted_right), .promoted_childless(stage_4_promoted_childless),
        .promoted_node(stage_4_promoted_node),
        .below_valid(stage_4_below_valid), .below_hole(stage_4_below_hole), .below_carry(stage_4_below_carry),
        .below_right(stage_4_below_right), .below_left_exists(stage_4_below_left_exists),
        .below_right_exists(stage_4_below_right_exists), .below_follows(stage_4_below_follows),
        .below_entry(stage_4_below_entry), .below_sibling(stage_4_below_sibling),
        .below_row(stage_4_below_row)
    );

    splat_heap_stage_l6 stage_6 (
        .clk(clk), .rst(rst), .lap(lap), .last_epoch(last_epoch),
        .step_valid(stage_4_below_valid), .step_hole(stage_4_below_hole), .step_carry(stage_4_below_carry),
        .step_right(stage_4_below_right), .step_left_exists(stage_4_below_left_exists),
        .step_right_exists(stage_4_below_right_exists), .step_follows(stage_4_below_follows),
        .step_entry(stage_4_below_entry), .step_sibling(stage_4_below_sibling), .step_row(stage_4_below_row),
        .below_promoted_entry(stage_8_promoted_entry), .below_promoted_ahead(stage_8_promoted_ahead),
        .below_promoted_right(stage_8_promoted_right), .below_promoted_childless(stage_8_promoted_childless),
        .below_promoted_node(stage_8_promoted_node),
        .promoted_entry(stage_6_promoted_entry), .promoted_ahead(stage_6_promoted_ahead),
        .promoted_right(stage_6_promoted_right), .promoted_childless(stage_6_promoted_childless),
        .promoted_node(stage_6_promoted_node),
        .below_valid(stage_6_below_valid), .below_hole(stage_6_below_hole), .below_carry(stage_6_below_carry),
        .below_right(stage_6_below_right), .below_left_exists(stage_6_below_left_exists),
        .below_right_exists(stage_6_below_right_exists), .below_follows(stage_6_below_follows),
        .below_entry(stage_6_below_entry), .below_sibling(stage_6_below_sibling),
        .below_row(stage_6_below_row)
    );

    splat_heap_stage_l8 stage_8 (
        .clk(clk), .rst(rst), .lap(lap), .last_epoch(last_epoch),
        .step_valid(stage_6_below_valid), .step_hole(stage_6_below_hole), .step_carry(stage_6_below_carry),
        .step_right(stage_6_below_right), .step_left_exists(stage_6_below_left_exists),
        .step_right_exists(stage_6_below_right_exists), .step_follows(stage_6_below_follows),
        .step_entry(stage_6_below_entry), .step_sibling(stage_6_below_sibling), .step_row(stage_6_below_row),
        .promoted_entry(stage_8_promoted_entry), .promoted_ahead(stage_8_promoted_ahead),
        .promoted_right(stage_8_promoted_right), .promoted_childless(stage_8_promoted_childless),
        .promoted_node(stage_8_promoted_node)
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
            if (push_and_not_arrival_13 ^ (pop & ~stage_0_root[23])) begin
                alive_even <= push_and_not_arrival_13 ? (alive_even + 10'd1) : (alive_even - 10'd1);
            end
            if (push_and_arrival_13 ^ (pop & stage_0_root[23])) begin
                alive_odd <= push_and_arrival_13 ? (alive_odd + 10'd1) : (alive_odd - 10'd1);
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
    input  wire clk, input wire rst, input wire lap, input wire last_epoch,
    input  wire step_valid, input wire step_hole, input wire step_carry, input wire step_right,
    input  wire step_left_exists, input wire step_right_exists, input wire step_follows,
    input  wire [36:0] step_entry, input wire [26:0] step_sibling, input wire [7:0] step_row,
    output wire [36:0] promoted_entry, output wire promoted_ahead, output wire promoted_right,
    output wire promoted_childless, output wire [7:0] promoted_node
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
    wire compared_carried_36_is_lap = compared_carried[36] == lap;
    wire [25:0] before_sibling_bits = {compared_carried[35:24], compared_carried[23] == last_epoch, compared_carried[22:10]};
    wire [25:0] sibling_stays_bits = {chosen_entry[35:24], chosen_entry[23] == last_epoch, chosen_entry[22:10]};
    wire before_chosen = (compared_carried[36] ^ chosen_entry[36]) ? compared_carried_36_is_lap : (before_sibling_bits < sibling_stays_bits);
    wire carried_first = compared_carry & (~compared_exists | before_chosen);
    wire [36:0] first = carried_first ? compared_carried : chosen_entry;
    wire [25:0] sibling_stays_bits_2 = {
        compared_parent_sibling[25:14], compared_parent_sibling[13] == last_epoch,
        compared_parent_sibling[12:0]
    };
    wire sibling_stays = (compared_parent_sibling[26] ^ chosen_entry[36]) ? (compared_parent_sibling[26] == lap) : (sibling_stays_bits_2 < sibling_stays_bits);
    wire promoted_ahead_both = compared_exists & ~sibling_stays;
    wire chosen_left_count = compared_chosen_stored ? stored[0] : compared_left_count;
    wire chosen_right_below = compared_chosen_stored ? stored[1] : compared_right_below;
    wire promoted_childless_inverted = ~(chosen_left_count | chosen_right_below);
    wire [9:0] side_choice = lower ? last_row_before : {1'd0, row_before};
    wire side = side_choice[0];
    wire [36:0] entry_to_store = (write_back_hole & ~lower) ? first : write_back_entry;
    wire is_first_either = ~write_back_sibling_exists | write_back_ahead | (promoted_ahead_both & ~lower);
    wire is_first = write_back_hole ? is_first_either : write_back_ahead;
    wire first_side = side ^ ~is_first;
    wire node_to_store_unequal = first_side ^ (write_back_sibling_exists & write_back_sibling_mark);
    wire node_to_store_both = write_back_hole & ~write_back_carry;
    wire node_to_store_both_2 = node_to_store_both & compared_right & promoted_childless_inverted;
    wire node_to_store_both_3 = ~write_back_hole & write_back_existed;
    wire node_to_store_either = (write_back_right_below & ~node_to_store_both_2) | (node_to_store_both_3 & compared_right);
    wire node_to_store_either_2 = (node_to_store_both & ~compared_right) | (node_to_store_both_3 & ~compared_right);
    wire [39:0] node_to_store = {
        entry_to_store, node_to_store_unequal, node_to_store_either,
        write_back_left_count + node_to_store_either_2
    };
    wire compared_hole_choice = lower ? compared_hole : step_hole;
    wire compared_exists_choice = lower ? chosen_left_count : step_left_exists;
    wire compared_exists_choice_2 = lower ? chosen_right_below : step_right_exists;
    wire compared_follows_choice = lower ? compared_follows : step_follows;
    wire newer = compared_follows_choice & write_back_valid;
    wire compared_was_first_choice = (compared_exists_choice & compared_exists_choice_2) ? (newer ? first_side : (left_shown[2] ^ right_shown[2])) : compared_exists_choice_2;
    wire goes_right = compared_hole_choice ? compared_was_first_choice : lower ? (chosen_left_count | ~lower) : step_right;
    wire [9:0] next_row = {row, goes_right};
    wire [8:0] row_choice = lower ? {1'd0, step_row} : next_row[8:0];
    wire same_side = goes_right ^ ~side;
    wire [26:0] sibling = compared_sibling_stored ? stored[39:13] : compared_sibling;
    wire [36:0] compared_sibling_choice = ~goes_right ? right_shown[39:3] : left_shown[39:3];
    wire before_sibling_in_order = before_sibling_bits < {sibling[25:14], sibling[13] == last_epoch, sibling[12:0]};
    wire before_sibling = (compared_carried[36] ^ sibling[26]) ? compared_carried_36_is_lap : before_sibling_in_order;
    wire write_back_ahead_either = (compared_exists & compared_was_first) | (carried_first & (before_sibling | ~compared_sibling_exists));

    assign promoted_entry = first;
    assign promoted_ahead = promoted_ahead_both;
    assign promoted_right = compared_right;
    assign promoted_childless = promoted_childless_inverted;
    assign promoted_node = row_before[7:0];

    memory_1w1r_unordered #(.WIDTH(40), .DEPTH(512)) left_nodes (
        .clk(clk), .write(write_back_valid & ~side), .write_address(side_choice[9:1]),
        .write_data(node_to_store),
        .read(1'd1), .read_address(row_choice), .read_data(left_shown)
    );

    memory_1w1r_unordered #(.WIDTH(40), .DEPTH(512)) right_nodes (
        .clk(clk), .write(write_back_valid & side), .write_address(side_choice[9:1]),
        .write_data(node_to_store),
        .read(1'd1), .read_address(row_choice), .read_data(right_shown)
    );

    always @(posedge clk) begin
        if (rst) begin
            lower <= 1'd0;
            compared_valid <= 1'd0;
            write_back_valid <= 1'd0;
        end else begin
            lower <= ~lower;
            compared_valid <= lower ? (compared_valid & compared_exists) : step_valid;
            write_back_valid <= compared_valid;
        end
    end
    always @(posedge clk) begin
        compared_hole <= compared_hole_choice;
        compared_carry <= lower ? compared_carry : step_carry;
        compared_follows <= compared_follows_choice & same_side;
        compared_carried <= lower ? (carried_first ? chosen_entry : compared_carried) : step_entry;
        compared_exists <= goes_right ? compared_exists_choice_2 : compared_exists_choice;
        compared_right <= goes_right;
        compared_was_first <= goes_right == compared_was_first_choice;
        compared_parent_sibling <= lower ? sibling : step_sibling;
        compared_chosen_stored <= newer & same_side;
        compared_sibling_stored <= newer & ~same_side;
        compared_sibling <= compared_sibling_choice[36:10];
        compared_sibling_exists <= goes_right ? compared_exists_choice : compared_exists_choice_2;
        compared_sibling_mark <= ~goes_right ? right_shown[2] : left_shown[2];
        compared_entry <= goes_right ? right_shown[39:3] : left_shown[39:3];
        compared_right_below <= goes_right ? right_shown[1] : left_shown[1];
        compared_left_count <= goes_right ? right_shown[0] : left_shown[0];
        write_back_hole <= compared_hole;
        write_back_carry <= compared_carry;
        write_back_existed <= compared_exists;
        write_back_ahead <= compared_hole ? (compared_carry & before_sibling) : write_back_ahead_either;
        write_back_sibling_exists <= compared_sibling_exists;
        write_back_sibling_mark <= compared_sibling_stored ? stored[2] : compared_sibling_mark;
        write_back_entry <= (carried_first ^ (compared_hole & ~lower)) ? compared_carried : chosen_entry;
        write_back_right_below <= chosen_right_below & compared_exists;
        write_back_left_count <= chosen_left_count & compared_exists;
        stored <= node_to_store;
        row <= row_choice;
        row_before <= row;
        last_row <= next_row;
        last_row_before <= last_row;
    end

    wire _unused = &{1'b0, compared_sibling_choice[9:0]};
endmodule

// Two neighboring levels of the pipelined heap.
// level = 6
// levels = 10
// interval = 2
module splat_heap_stage_l6 (
    input  wire clk, input wire rst, input wire lap, input wire last_epoch,
    input  wire step_valid, input wire step_hole, input wire step_carry, input wire step_right,
    input  wire step_left_exists, input wire step_right_exists, input wire step_follows,
    input  wire [36:0] step_entry, input wire [26:0] step_sibling, input wire [5:0] step_row,
    input  wire [36:0] below_promoted_entry, input wire below_promoted_ahead,
    input  wire below_promoted_right, input wire below_promoted_childless,
    input  wire [7:0] below_promoted_node,
    output wire [36:0] promoted_entry, output wire promoted_ahead, output wire promoted_right,
    output wire promoted_childless, output wire [5:0] promoted_node,
    output wire below_valid, output wire below_hole, output wire below_carry, output wire below_right,
    output wire below_left_exists, output wire below_right_exists, output wire below_follows,
    output wire [36:0] below_entry, output wire [26:0] below_sibling, output wire [7:0] below_row
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
    wire compared_carried_36_is_lap = compared_carried[36] == lap;
    wire [25:0] before_chosen_bits = {compared_carried[35:24], compared_carried[23] == last_epoch, compared_carried[22:10]};
    wire [25:0] sibling_stays_bits = {chosen_entry[35:24], chosen_entry[23] == last_epoch, chosen_entry[22:10]};
    wire before_chosen = (compared_carried[36] ^ chosen_entry[36]) ? compared_carried_36_is_lap : (before_chosen_bits < sibling_stays_bits);
    wire carried_first = compared_carry & (~compared_exists | before_chosen);
    wire [36:0] first = carried_first ? compared_carried : chosen_entry;
    wire [25:0] sibling_stays_bits_2 = {
        compared_parent_sibling[25:14], compared_parent_sibling[13] == last_epoch,
        compared_parent_sibling[12:0]
    };
    wire sibling_stays = (compared_parent_sibling[26] ^ chosen_entry[36]) ? (compared_parent_sibling[26] == lap) : (sibling_stays_bits_2 < sibling_stays_bits);
    wire promoted_ahead_both = compared_exists & ~sibling_stays;
    wire [2:0] chosen_left_count = compared_chosen_stored ? stored[2:0] : compared_left_count;
    wire chosen_right_below = compared_chosen_stored ? stored[3] : compared_right_below;
    wire promoted_childless_inverted = ~(|chosen_left_count | chosen_right_below);
    wire below_valid_both = compared_valid & compared_exists;
    wire below_right_both = &chosen_left_count[1:0] & (chosen_left_count[2] | ~lower);
    wire [36:0] below_entry_choice = carried_first ? chosen_entry : compared_carried;
    wire [26:0] sibling = compared_sibling_stored ? stored[41:15] : compared_sibling;
    wire compared_hole_choice = lower ? compared_hole : step_hole;
    wire compared_exists_choice = lower ? |chosen_left_count : step_left_exists;
    wire compared_exists_choice_2 = lower ? chosen_right_below : step_right_exists;
    wire compared_follows_choice = lower ? compared_follows : step_follows;
    wire newer = compared_follows_choice & write_back_valid;
    wire [7:0] side_choice = lower ? below_promoted_node : {1'd0, row_before};
    wire side = side_choice[0];
    wire is_first_either = ~write_back_sibling_exists | write_back_ahead | (lower ? below_promoted_ahead : promoted_ahead_both);
    wire is_first = write_back_hole ? is_first_either : write_back_ahead;
    wire first_side = side ^ ~is_first;
    wire compared_was_first_choice = (compared_exists_choice & compared_exists_choice_2) ? (newer ? first_side : (left_shown[4] ^ right_shown[4])) : compared_exists_choice_2;
    wire goes_right = compared_hole_choice ? compared_was_first_choice : lower ? below_right_both : step_right;
    wire [7:0] next_row = {row, goes_right};
    wire [36:0] entry_to_store = write_back_hole ? (lower ? below_promoted_entry : first) : write_back_entry;
    wire node_to_store_unequal = first_side ^ (write_back_sibling_exists & write_back_sibling_mark);
    wire node_to_store_both = write_back_hole & ~write_back_carry;
    wire node_to_store_choice = lower ? below_promoted_right : compared_right;
    wire node_to_store_both_2 = node_to_store_both & node_to_store_choice & (lower ? below_promoted_childless : promoted_childless_inverted);
    wire node_to_store_both_3 = ~write_back_hole & write_back_existed;
    wire node_to_store_either = (write_back_right_below & ~node_to_store_both_2) | (node_to_store_both_3 & node_to_store_choice);
    wire not_node_to_store_choice = ~node_to_store_choice;
    wire node_to_store_both_4 = node_to_store_both & not_node_to_store_choice;
    wire node_to_store_either_2 = node_to_store_both_4 | (node_to_store_both_3 & not_node_to_store_choice);
    wire [2:0] node_to_store_sum = write_back_left_count + {{2{node_to_store_both_4}}, node_to_store_either_2};
    wire [41:0] node_to_store = {entry_to_store, node_to_store_unequal, node_to_store_either, node_to_store_sum};
    wire [6:0] row_choice = lower ? {1'd0, step_row} : next_row[6:0];
    wire same_side = goes_right ^ ~side;
    wire [36:0] compared_sibling_choice = ~goes_right ? right_shown[41:5] : left_shown[41:5];
    wire before_sibling_in_order = before_chosen_bits < {sibling[25:14], sibling[13] == last_epoch, sibling[12:0]};
    wire before_sibling = (compared_carried[36] ^ sibling[26]) ? compared_carried_36_is_lap : before_sibling_in_order;
    wire write_back_ahead_either = (compared_exists & compared_was_first) | (carried_first & (before_sibling | ~compared_sibling_exists));

    assign promoted_entry = first;
    assign promoted_ahead = promoted_ahead_both;
    assign promoted_right = compared_right;
    assign promoted_childless = promoted_childless_inverted;
    assign promoted_node = row_before[5:0];
    assign below_valid = below_valid_both;
    assign below_hole = compared_hole;
    assign below_carry = compared_carry;
    assign below_right = below_right_both;
    assign below_left_exists = |chosen_left_count;
    assign below_right_exists = chosen_right_below;
    assign below_follows = compared_follows;
    assign below_entry = below_entry_choice;
    assign below_sibling = sibling;
    assign below_row = next_row;

    memory_1w1r_unordered #(.WIDTH(42), .DEPTH(128)) left_nodes (
        .clk(clk), .write(write_back_valid & ~side), .write_address(side_choice[7:1]),
        .write_data(node_to_store),
        .read(1'd1), .read_address(row_choice), .read_data(left_shown)
    );

    memory_1w1r_unordered #(.WIDTH(42), .DEPTH(128)) right_nodes (
        .clk(clk), .write(write_back_valid & side), .write_address(side_choice[7:1]),
        .write_data(node_to_store),
        .read(1'd1), .read_address(row_choice), .read_data(right_shown)
    );

    always @(posedge clk) begin
        if (rst) begin
            lower <= 1'd0;
            compared_valid <= 1'd0;
            write_back_valid <= 1'd0;
        end else begin
            lower <= ~lower;
            compared_valid <= lower ? below_valid_both : step_valid;
            write_back_valid <= compared_valid;
        end
    end
    always @(posedge clk) begin
        compared_hole <= compared_hole_choice;
        compared_carry <= lower ? compared_carry : step_carry;
        compared_follows <= compared_follows_choice & same_side;
        compared_carried <= lower ? below_entry_choice : step_entry;
        compared_exists <= goes_right ? compared_exists_choice_2 : compared_exists_choice;
        compared_right <= goes_right;
        compared_was_first <= goes_right == compared_was_first_choice;
        compared_parent_sibling <= lower ? sibling : step_sibling;
        compared_chosen_stored <= newer & same_side;
        compared_sibling_stored <= newer & ~same_side;
        compared_sibling <= compared_sibling_choice[36:10];
        compared_sibling_exists <= goes_right ? compared_exists_choice : compared_exists_choice_2;
        compared_sibling_mark <= ~goes_right ? right_shown[4] : left_shown[4];
        compared_entry <= goes_right ? right_shown[41:5] : left_shown[41:5];
        compared_right_below <= goes_right ? right_shown[3] : left_shown[3];
        compared_left_count <= goes_right ? right_shown[2:0] : left_shown[2:0];
        write_back_hole <= compared_hole;
        write_back_carry <= compared_carry;
        write_back_existed <= compared_exists;
        write_back_ahead <= compared_hole ? (compared_carry & before_sibling) : write_back_ahead_either;
        write_back_sibling_exists <= compared_sibling_exists;
        write_back_sibling_mark <= compared_sibling_stored ? stored[4] : compared_sibling_mark;
        write_back_entry <= first;
        write_back_right_below <= chosen_right_below & compared_exists;
        write_back_left_count <= chosen_left_count & {3{compared_exists}};
        stored <= node_to_store;
        row <= row_choice;
        row_before <= row;
    end

    wire _unused = &{1'b0, compared_sibling_choice[9:0]};
endmodule

// Two neighboring levels of the pipelined heap.
// level = 4
// levels = 10
// interval = 2
module splat_heap_stage_l4 (
    input  wire clk, input wire rst, input wire lap, input wire last_epoch,
    input  wire step_valid, input wire step_hole, input wire step_carry, input wire step_right,
    input  wire step_left_exists, input wire step_right_exists, input wire step_follows,
    input  wire [36:0] step_entry, input wire [26:0] step_sibling, input wire [3:0] step_row,
    input  wire [36:0] below_promoted_entry, input wire below_promoted_ahead,
    input  wire below_promoted_right, input wire below_promoted_childless,
    input  wire [5:0] below_promoted_node,
    output wire [36:0] promoted_entry, output wire promoted_ahead, output wire promoted_right,
    output wire promoted_childless, output wire [3:0] promoted_node,
    output wire below_valid, output wire below_hole, output wire below_carry, output wire below_right,
    output wire below_left_exists, output wire below_right_exists, output wire below_follows,
    output wire [36:0] below_entry, output wire [26:0] below_sibling, output wire [5:0] below_row
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
    wire compared_carried_36_is_lap = compared_carried[36] == lap;
    wire [25:0] before_chosen_bits = {compared_carried[35:24], compared_carried[23] == last_epoch, compared_carried[22:10]};
    wire [25:0] sibling_stays_bits = {chosen_entry[35:24], chosen_entry[23] == last_epoch, chosen_entry[22:10]};
    wire before_chosen = (compared_carried[36] ^ chosen_entry[36]) ? compared_carried_36_is_lap : (before_chosen_bits < sibling_stays_bits);
    wire carried_first = compared_carry & (~compared_exists | before_chosen);
    wire [36:0] first = carried_first ? compared_carried : chosen_entry;
    wire [25:0] sibling_stays_bits_2 = {
        compared_parent_sibling[25:14], compared_parent_sibling[13] == last_epoch,
        compared_parent_sibling[12:0]
    };
    wire sibling_stays = (compared_parent_sibling[26] ^ chosen_entry[36]) ? (compared_parent_sibling[26] == lap) : (sibling_stays_bits_2 < sibling_stays_bits);
    wire promoted_ahead_both = compared_exists & ~sibling_stays;
    wire [4:0] chosen_left_count = compared_chosen_stored ? stored[4:0] : compared_left_count;
    wire chosen_right_below = compared_chosen_stored ? stored[5] : compared_right_below;
    wire promoted_childless_inverted = ~(|chosen_left_count | chosen_right_below);
    wire below_valid_both = compared_valid & compared_exists;
    wire below_right_both = &chosen_left_count[3:0] & (chosen_left_count[4] | ~lower);
    wire [36:0] below_entry_choice = carried_first ? chosen_entry : compared_carried;
    wire [26:0] sibling = compared_sibling_stored ? stored[43:17] : compared_sibling;
    wire compared_hole_choice = lower ? compared_hole : step_hole;
    wire compared_exists_choice = lower ? |chosen_left_count : step_left_exists;
    wire compared_exists_choice_2 = lower ? chosen_right_below : step_right_exists;
    wire compared_follows_choice = lower ? compared_follows : step_follows;
    wire newer = compared_follows_choice & write_back_valid;
    wire [5:0] side_choice = lower ? below_promoted_node : {1'd0, row_before};
    wire side = side_choice[0];
    wire is_first_either = ~write_back_sibling_exists | write_back_ahead | (lower ? below_promoted_ahead : promoted_ahead_both);
    wire is_first = write_back_hole ? is_first_either : write_back_ahead;
    wire first_side = side ^ ~is_first;
    wire compared_was_first_choice = (compared_exists_choice & compared_exists_choice_2) ? (newer ? first_side : (left_shown[6] ^ right_shown[6])) : compared_exists_choice_2;
    wire goes_right = compared_hole_choice ? compared_was_first_choice : lower ? below_right_both : step_right;
    wire [5:0] next_row = {row, goes_right};
    wire [36:0] entry_to_store = write_back_hole ? (lower ? below_promoted_entry : first) : write_back_entry;
    wire node_to_store_unequal = first_side ^ (write_back_sibling_exists & write_back_sibling_mark);
    wire node_to_store_both = write_back_hole & ~write_back_carry;
    wire node_to_store_choice = lower ? below_promoted_right : compared_right;
    wire node_to_store_both_2 = node_to_store_both & node_to_store_choice & (lower ? below_promoted_childless : promoted_childless_inverted);
    wire node_to_store_both_3 = ~write_back_hole & write_back_existed;
    wire node_to_store_either = (write_back_right_below & ~node_to_store_both_2) | (node_to_store_both_3 & node_to_store_choice);
    wire not_node_to_store_choice = ~node_to_store_choice;
    wire node_to_store_both_4 = node_to_store_both & not_node_to_store_choice;
    wire node_to_store_either_2 = node_to_store_both_4 | (node_to_store_both_3 & not_node_to_store_choice);
    wire [4:0] node_to_store_sum = write_back_left_count + {{4{node_to_store_both_4}}, node_to_store_either_2};
    wire [43:0] node_to_store = {entry_to_store, node_to_store_unequal, node_to_store_either, node_to_store_sum};
    wire [4:0] row_choice = lower ? {1'd0, step_row} : next_row[4:0];
    wire same_side = goes_right ^ ~side;
    wire [36:0] compared_sibling_choice = ~goes_right ? right_shown[43:7] : left_shown[43:7];
    wire before_sibling_in_order = before_chosen_bits < {sibling[25:14], sibling[13] == last_epoch, sibling[12:0]};
    wire before_sibling = (compared_carried[36] ^ sibling[26]) ? compared_carried_36_is_lap : before_sibling_in_order;
    wire write_back_ahead_either = (compared_exists & compared_was_first) | (carried_first & (before_sibling | ~compared_sibling_exists));

    assign promoted_entry = first;
    assign promoted_ahead = promoted_ahead_both;
    assign promoted_right = compared_right;
    assign promoted_childless = promoted_childless_inverted;
    assign promoted_node = row_before[3:0];
    assign below_valid = below_valid_both;
    assign below_hole = compared_hole;
    assign below_carry = compared_carry;
    assign below_right = below_right_both;
    assign below_left_exists = |chosen_left_count;
    assign below_right_exists = chosen_right_below;
    assign below_follows = compared_follows;
    assign below_entry = below_entry_choice;
    assign below_sibling = sibling;
    assign below_row = next_row;

    memory_1w1r_unordered #(.WIDTH(44), .DEPTH(32)) left_nodes (
        .clk(clk), .write(write_back_valid & ~side), .write_address(side_choice[5:1]),
        .write_data(node_to_store),
        .read(1'd1), .read_address(row_choice), .read_data(left_shown)
    );

    memory_1w1r_unordered #(.WIDTH(44), .DEPTH(32)) right_nodes (
        .clk(clk), .write(write_back_valid & side), .write_address(side_choice[5:1]),
        .write_data(node_to_store),
        .read(1'd1), .read_address(row_choice), .read_data(right_shown)
    );

    always @(posedge clk) begin
        if (rst) begin
            lower <= 1'd0;
            compared_valid <= 1'd0;
            write_back_valid <= 1'd0;
        end else begin
            lower <= ~lower;
            compared_valid <= lower ? below_valid_both : step_valid;
            write_back_valid <= compared_valid;
        end
    end
    always @(posedge clk) begin
        compared_hole <= compared_hole_choice;
        compared_carry <= lower ? compared_carry : step_carry;
        compared_follows <= compared_follows_choice & same_side;
        compared_carried <= lower ? below_entry_choice : step_entry;
        compared_exists <= goes_right ? compared_exists_choice_2 : compared_exists_choice;
        compared_right <= goes_right;
        compared_was_first <= goes_right == compared_was_first_choice;
        compared_parent_sibling <= lower ? sibling : step_sibling;
        compared_chosen_stored <= newer & same_side;
        compared_sibling_stored <= newer & ~same_side;
        compared_sibling <= compared_sibling_choice[36:10];
        compared_sibling_exists <= goes_right ? compared_exists_choice : compared_exists_choice_2;
        compared_sibling_mark <= ~goes_right ? right_shown[6] : left_shown[6];
        compared_entry <= goes_right ? right_shown[43:7] : left_shown[43:7];
        compared_right_below <= goes_right ? right_shown[5] : left_shown[5];
        compared_left_count <= goes_right ? right_shown[4:0] : left_shown[4:0];
        write_back_hole <= compared_hole;
        write_back_carry <= compared_carry;
        write_back_existed <= compared_exists;
        write_back_ahead <= compared_hole ? (compared_carry & before_sibling) : write_back_ahead_either;
        write_back_sibling_exists <= compared_sibling_exists;
        write_back_sibling_mark <= compared_sibling_stored ? stored[6] : compared_sibling_mark;
        write_back_entry <= first;
        write_back_right_below <= chosen_right_below & compared_exists;
        write_back_left_count <= chosen_left_count & {5{compared_exists}};
        stored <= node_to_store;
        row <= row_choice;
        row_before <= row;
    end

    wire _unused = &{1'b0, compared_sibling_choice[9:0]};
endmodule

// Two neighboring levels of the pipelined heap.
// level = 2
// levels = 10
// interval = 2
module splat_heap_stage_l2 (
    input  wire clk, input wire rst, input wire lap, input wire last_epoch,
    input  wire step_valid, input wire step_hole, input wire step_carry, input wire step_right,
    input  wire step_left_exists, input wire step_right_exists, input wire step_follows,
    input  wire [36:0] step_entry, input wire [26:0] step_sibling, input wire [1:0] step_row,
    input  wire [36:0] below_promoted_entry, input wire below_promoted_ahead,
    input  wire below_promoted_right, input wire below_promoted_childless,
    input  wire [3:0] below_promoted_node,
    output wire [36:0] promoted_entry, output wire promoted_ahead, output wire promoted_right,
    output wire promoted_childless, output wire [1:0] promoted_node,
    output wire below_valid, output wire below_hole, output wire below_carry, output wire below_right,
    output wire below_left_exists, output wire below_right_exists, output wire below_follows,
    output wire [36:0] below_entry, output wire [26:0] below_sibling, output wire [3:0] below_row
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
    wire compared_carried_36_is_lap = compared_carried[36] == lap;
    wire [25:0] before_chosen_bits = {compared_carried[35:24], compared_carried[23] == last_epoch, compared_carried[22:10]};
    wire [25:0] sibling_stays_bits = {chosen_entry[35:24], chosen_entry[23] == last_epoch, chosen_entry[22:10]};
    wire before_chosen = (compared_carried[36] ^ chosen_entry[36]) ? compared_carried_36_is_lap : (before_chosen_bits < sibling_stays_bits);
    wire carried_first = compared_carry & (~compared_exists | before_chosen);
    wire [36:0] first = carried_first ? compared_carried : chosen_entry;
    wire [25:0] sibling_stays_bits_2 = {
        compared_parent_sibling[25:14], compared_parent_sibling[13] == last_epoch,
        compared_parent_sibling[12:0]
    };
    wire sibling_stays = (compared_parent_sibling[26] ^ chosen_entry[36]) ? (compared_parent_sibling[26] == lap) : (sibling_stays_bits_2 < sibling_stays_bits);
    wire promoted_ahead_both = compared_exists & ~sibling_stays;
    wire [6:0] chosen_left_count = compared_chosen_stored ? stored[6:0] : compared_left_count;
    wire chosen_right_below = compared_chosen_stored ? stored[7] : compared_right_below;
    wire promoted_childless_inverted = ~(|chosen_left_count | chosen_right_below);
    wire below_valid_both = compared_valid & compared_exists;
    wire below_right_both = &chosen_left_count[5:0] & (chosen_left_count[6] | ~lower);
    wire [36:0] below_entry_choice = carried_first ? chosen_entry : compared_carried;
    wire [26:0] sibling = compared_sibling_stored ? stored[45:19] : compared_sibling;
    wire compared_hole_choice = lower ? compared_hole : step_hole;
    wire compared_exists_choice = lower ? |chosen_left_count : step_left_exists;
    wire compared_exists_choice_2 = lower ? chosen_right_below : step_right_exists;
    wire compared_follows_choice = lower ? compared_follows : step_follows;
    wire newer = compared_follows_choice & write_back_valid;
    wire [3:0] side_choice = lower ? below_promoted_node : {1'd0, row_before};
    wire side = side_choice[0];
    wire is_first_either = ~write_back_sibling_exists | write_back_ahead | (lower ? below_promoted_ahead : promoted_ahead_both);
    wire is_first = write_back_hole ? is_first_either : write_back_ahead;
    wire first_side = side ^ ~is_first;
    wire compared_was_first_choice = (compared_exists_choice & compared_exists_choice_2) ? (newer ? first_side : (left_shown[8] ^ right_shown[8])) : compared_exists_choice_2;
    wire goes_right = compared_hole_choice ? compared_was_first_choice : lower ? below_right_both : step_right;
    wire [3:0] next_row = {row, goes_right};
    wire [36:0] entry_to_store = write_back_hole ? (lower ? below_promoted_entry : first) : write_back_entry;
    wire node_to_store_unequal = first_side ^ (write_back_sibling_exists & write_back_sibling_mark);
    wire node_to_store_both = write_back_hole & ~write_back_carry;
    wire node_to_store_choice = lower ? below_promoted_right : compared_right;
    wire node_to_store_both_2 = node_to_store_both & node_to_store_choice & (lower ? below_promoted_childless : promoted_childless_inverted);
    wire node_to_store_both_3 = ~write_back_hole & write_back_existed;
    wire node_to_store_either = (write_back_right_below & ~node_to_store_both_2) | (node_to_store_both_3 & node_to_store_choice);
    wire not_node_to_store_choice = ~node_to_store_choice;
    wire node_to_store_both_4 = node_to_store_both & not_node_to_store_choice;
    wire node_to_store_either_2 = node_to_store_both_4 | (node_to_store_both_3 & not_node_to_store_choice);
    wire [6:0] node_to_store_sum = write_back_left_count + {{6{node_to_store_both_4}}, node_to_store_either_2};
    wire [45:0] node_to_store = {entry_to_store, node_to_store_unequal, node_to_store_either, node_to_store_sum};
    wire [2:0] row_choice = lower ? {1'd0, step_row} : next_row[2:0];
    wire same_side = goes_right ^ ~side;
    wire [36:0] compared_sibling_choice = ~goes_right ? right_shown[45:9] : left_shown[45:9];
    wire before_sibling_in_order = before_chosen_bits < {sibling[25:14], sibling[13] == last_epoch, sibling[12:0]};
    wire before_sibling = (compared_carried[36] ^ sibling[26]) ? compared_carried_36_is_lap : before_sibling_in_order;
    wire write_back_ahead_either = (compared_exists & compared_was_first) | (carried_first & (before_sibling | ~compared_sibling_exists));

    assign promoted_entry = first;
    assign promoted_ahead = promoted_ahead_both;
    assign promoted_right = compared_right;
    assign promoted_childless = promoted_childless_inverted;
    assign promoted_node = row_before[1:0];
    assign below_valid = below_valid_both;
    assign below_hole = compared_hole;
    assign below_carry = compared_carry;
    assign below_right = below_right_both;
    assign below_left_exists = |chosen_left_count;
    assign below_right_exists = chosen_right_below;
    assign below_follows = compared_follows;
    assign below_entry = below_entry_choice;
    assign below_sibling = sibling;
    assign below_row = next_row;

    memory_1w1r_unordered #(.WIDTH(46), .DEPTH(8)) left_nodes (
        .clk(clk), .write(write_back_valid & ~side), .write_address(side_choice[3:1]),
        .write_data(node_to_store),
        .read(1'd1), .read_address(row_choice), .read_data(left_shown)
    );

    memory_1w1r_unordered #(.WIDTH(46), .DEPTH(8)) right_nodes (
        .clk(clk), .write(write_back_valid & side), .write_address(side_choice[3:1]),
        .write_data(node_to_store),
        .read(1'd1), .read_address(row_choice), .read_data(right_shown)
    );

    always @(posedge clk) begin
        if (rst) begin
            lower <= 1'd0;
            compared_valid <= 1'd0;
            write_back_valid <= 1'd0;
        end else begin
            lower <= ~lower;
            compared_valid <= lower ? below_valid_both : step_valid;
            write_back_valid <= compared_valid;
        end
    end
    always @(posedge clk) begin
        compared_hole <= compared_hole_choice;
        compared_carry <= lower ? compared_carry : step_carry;
        compared_follows <= compared_follows_choice & same_side;
        compared_carried <= lower ? below_entry_choice : step_entry;
        compared_exists <= goes_right ? compared_exists_choice_2 : compared_exists_choice;
        compared_right <= goes_right;
        compared_was_first <= goes_right == compared_was_first_choice;
        compared_parent_sibling <= lower ? sibling : step_sibling;
        compared_chosen_stored <= newer & same_side;
        compared_sibling_stored <= newer & ~same_side;
        compared_sibling <= compared_sibling_choice[36:10];
        compared_sibling_exists <= goes_right ? compared_exists_choice : compared_exists_choice_2;
        compared_sibling_mark <= ~goes_right ? right_shown[8] : left_shown[8];
        compared_entry <= goes_right ? right_shown[45:9] : left_shown[45:9];
        compared_right_below <= goes_right ? right_shown[7] : left_shown[7];
        compared_left_count <= goes_right ? right_shown[6:0] : left_shown[6:0];
        write_back_hole <= compared_hole;
        write_back_carry <= compared_carry;
        write_back_existed <= compared_exists;
        write_back_ahead <= compared_hole ? (compared_carry & before_sibling) : write_back_ahead_either;
        write_back_sibling_exists <= compared_sibling_exists;
        write_back_sibling_mark <= compared_sibling_stored ? stored[8] : compared_sibling_mark;
        write_back_entry <= first;
        write_back_right_below <= chosen_right_below & compared_exists;
        write_back_left_count <= chosen_left_count & {7{compared_exists}};
        stored <= node_to_store;
        row <= row_choice;
        row_before <= row;
    end

    wire _unused = &{1'b0, compared_sibling_choice[9:0]};
endmodule

// Two neighboring levels of the pipelined heap.
// level = 0
// levels = 10
// interval = 2
module splat_heap_stage_l0 (
    input  wire clk, input wire rst, input wire lap, input wire last_epoch,
    input  wire step_valid, input wire step_hole, input wire step_carry, input wire step_right,
    input  wire step_left_exists, input wire step_right_exists, input wire step_follows,
    input  wire [36:0] step_entry, input wire [26:0] step_sibling,
    input  wire newcomer_lap,
    input  wire [36:0] below_promoted_entry, input wire below_promoted_ahead,
    input  wire below_promoted_right, input wire below_promoted_childless,
    input  wire [1:0] below_promoted_node,
    output wire [36:0] root,
    output wire below_valid, output wire below_hole, output wire below_carry, output wire below_right,
    output wire below_left_exists, output wire below_right_exists, output wire below_follows,
    output wire [36:0] below_entry, output wire [26:0] below_sibling, output wire [1:0] below_row
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

    wire newer_choice = lower ? compared_follows : step_follows;
    wire newer = newer_choice & write_back_valid;
    wire before_chosen_choice = lower ? newcomer_lap : compared_carried[36];
    wire [36:0] chosen_entry = compared_chosen_stored ? stored[47:11] : compared_entry;
    wire before_chosen_choice_is_lap = before_chosen_choice == lap;
    wire [25:0] before_chosen_bits = {compared_carried[35:24], compared_carried[23] == last_epoch, compared_carried[22:10]};
    wire [25:0] before_chosen_bits_2 = {chosen_entry[35:24], chosen_entry[23] == last_epoch, chosen_entry[22:10]};
    wire before_chosen = (before_chosen_choice ^ chosen_entry[36]) ? before_chosen_choice_is_lap : (before_chosen_bits < before_chosen_bits_2);
    wire carried_first = compared_carry & (~compared_exists | before_chosen);
    wire [36:0] write_back_entry_bits = {before_chosen_choice, compared_carried[35:0]};
    wire [36:0] first = carried_first ? write_back_entry_bits : chosen_entry;
    wire [36:0] entry_to_store = write_back_hole ? (lower ? below_promoted_entry : first) : write_back_entry;
    wire below_valid_both = compared_valid & compared_exists;
    wire [8:0] chosen_left_count = compared_chosen_stored ? stored[8:0] : compared_left_count;
    wire below_right_both = &chosen_left_count[7:0] & (chosen_left_count[8] | ~lower);
    wire chosen_right_below = compared_chosen_stored ? stored[9] : compared_right_below;
    wire [36:0] below_entry_choice = carried_first ? chosen_entry : write_back_entry_bits;
    wire [26:0] sibling = compared_sibling_stored ? stored[47:21] : compared_sibling;
    wire compared_hole_choice = lower ? compared_hole : step_hole;
    wire compared_exists_choice = lower ? |chosen_left_count : step_left_exists;
    wire compared_exists_choice_2 = lower ? chosen_right_below : step_right_exists;
    wire [1:0] side_choice = lower ? below_promoted_node : {1'd0, row_before};
    wire side = side_choice[0];
    wire [25:0] sibling_stays_bits = {
        compared_parent_sibling[25:14], compared_parent_sibling[13] == last_epoch,
        compared_parent_sibling[12:0]
    };
    wire sibling_stays = (compared_parent_sibling[26] ^ chosen_entry[36]) ? (compared_parent_sibling[26] == lap) : (sibling_stays_bits < before_chosen_bits_2);
    wire is_first_choice = lower ? below_promoted_ahead : (compared_exists & ~sibling_stays);
    wire is_first = write_back_hole ? (~write_back_sibling_exists | write_back_ahead | is_first_choice) : write_back_ahead;
    wire first_side = side ^ ~is_first;
    wire compared_was_first_choice = (compared_exists_choice & compared_exists_choice_2) ? (newer ? first_side : (left_shown[10] ^ right_shown[10])) : compared_exists_choice_2;
    wire goes_right = compared_hole_choice ? compared_was_first_choice : lower ? below_right_both : step_right;
    wire [1:0] next_row = {row, goes_right};
    wire node_to_store_unequal = first_side ^ (write_back_sibling_exists & write_back_sibling_mark);
    wire node_to_store_both = write_back_hole & ~write_back_carry;
    wire node_to_store_choice = lower ? below_promoted_right : compared_right;
    wire node_to_store_choice_2 = lower ? below_promoted_childless : ~(|chosen_left_count | chosen_right_below);
    wire node_to_store_both_2 = node_to_store_both & node_to_store_choice & node_to_store_choice_2;
    wire node_to_store_both_3 = ~write_back_hole & write_back_existed;
    wire node_to_store_either = (write_back_right_below & ~node_to_store_both_2) | (node_to_store_both_3 & node_to_store_choice);
    wire not_node_to_store_choice = ~node_to_store_choice;
    wire node_to_store_both_4 = node_to_store_both & not_node_to_store_choice;
    wire node_to_store_either_2 = node_to_store_both_4 | (node_to_store_both_3 & not_node_to_store_choice);
    wire [8:0] node_to_store_sum = write_back_left_count + {{8{node_to_store_both_4}}, node_to_store_either_2};
    wire [47:0] node_to_store = {entry_to_store, node_to_store_unequal, node_to_store_either, node_to_store_sum};
    wire row_choice = lower ? 1'd0 : next_row[0];
    wire same_side = goes_right ^ ~side;
    wire [36:0] compared_sibling_choice = ~goes_right ? right_shown[47:11] : left_shown[47:11];
    wire before_sibling_in_order = before_chosen_bits < {sibling[25:14], sibling[13] == last_epoch, sibling[12:0]};
    wire before_sibling = (before_chosen_choice ^ sibling[26]) ? before_chosen_choice_is_lap : before_sibling_in_order;
    wire write_back_ahead_either = (compared_exists & compared_was_first) | (carried_first & (before_sibling | ~compared_sibling_exists));

    assign root = newer ? entry_to_store : right_shown[47:11];
    assign below_valid = below_valid_both;
    assign below_hole = compared_hole;
    assign below_carry = compared_carry;
    assign below_right = below_right_both;
    assign below_left_exists = |chosen_left_count;
    assign below_right_exists = chosen_right_below;
    assign below_follows = compared_follows;
    assign below_entry = below_entry_choice;
    assign below_sibling = sibling;
    assign below_row = next_row;

    memory_1w1r_unordered #(.WIDTH(48), .DEPTH(2)) left_nodes (
        .clk(clk), .write(write_back_valid & ~side), .write_address(side_choice[1]),
        .write_data(node_to_store),
        .read(1'd1), .read_address(row_choice), .read_data(left_shown)
    );

    memory_1w1r_unordered #(.WIDTH(48), .DEPTH(2)) right_nodes (
        .clk(clk), .write(write_back_valid & side), .write_address(side_choice[1]),
        .write_data(node_to_store),
        .read(1'd1), .read_address(row_choice), .read_data(right_shown)
    );

    always @(posedge clk) begin
        if (rst) begin
            lower <= 1'd0;
            compared_valid <= 1'd0;
            write_back_valid <= 1'd0;
        end else begin
            lower <= ~lower;
            compared_valid <= lower ? below_valid_both : step_valid;
            write_back_valid <= compared_valid;
        end
    end
    always @(posedge clk) begin
        compared_hole <= compared_hole_choice;
        compared_carry <= lower ? compared_carry : step_carry;
        compared_follows <= newer_choice & same_side;
        compared_carried <= lower ? below_entry_choice : step_entry;
        compared_exists <= goes_right ? compared_exists_choice_2 : compared_exists_choice;
        compared_right <= goes_right;
        compared_was_first <= goes_right == compared_was_first_choice;
        compared_parent_sibling <= lower ? sibling : step_sibling;
        compared_chosen_stored <= newer & same_side;
        compared_sibling_stored <= newer & ~same_side;
        compared_sibling <= compared_sibling_choice[36:10];
        compared_sibling_exists <= goes_right ? compared_exists_choice : compared_exists_choice_2;
        compared_sibling_mark <= ~goes_right ? right_shown[10] : left_shown[10];
        compared_entry <= goes_right ? right_shown[47:11] : left_shown[47:11];
        compared_right_below <= goes_right ? right_shown[9] : left_shown[9];
        compared_left_count <= goes_right ? right_shown[8:0] : left_shown[8:0];
        write_back_hole <= compared_hole;
        write_back_carry <= compared_carry;
        write_back_existed <= compared_exists;
        write_back_ahead <= compared_hole ? (compared_carry & before_sibling) : write_back_ahead_either;
        write_back_sibling_exists <= compared_sibling_exists;
        write_back_sibling_mark <= compared_sibling_stored ? stored[10] : compared_sibling_mark;
        write_back_entry <= first;
        write_back_right_below <= chosen_right_below & compared_exists;
        write_back_left_count <= chosen_left_count & {9{compared_exists}};
        stored <= node_to_store;
        row <= row_choice;
        row_before <= row;
    end

    wire _unused = &{1'b0, compared_sibling_choice[9:0]};
endmodule

// Queue of two in registers.
// width = 22
module stream_skid_w22 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [21:0] in_data,
    output wire out_valid, input wire out_ready, output wire [21:0] out_data
);
    reg head_filled, second_filled, room;
    reg [21:0] head, second;

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

// One item in a register, at half rate.
// width = 51
module stream_half_buffer_w51 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [50:0] in_data,
    output wire out_valid, input wire out_ready, output wire [50:0] out_data
);
    reg filled;
    reg [50:0] item;

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
// places = 1024
// beats = 2
module splat_payloads (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready,  // Copies, those of a splat one after the other.
    input  wire in_end,  // Closes the frame.
    input  wire in_first,  // It is the first of its splat.
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
    input  wire in_sight_negative,  // `D` is negative before the eye.
    input  wire [19:0] in_sight_near,  // The magnitude of `D` at the near plane; all ones where no sample lies before it.
    input  wire [19:0] in_sight_far,  // The magnitude of `D` at the far plane; zero where no sample lies behind it.
    input  wire in_sight_turned,  // The origin is the vanishing point of a tangent: `s1` and `D` have changed places.
    input  wire in_sight_disc,  // The origin is the splat's centre, and lies between near and far plane: the filter's disc is drawn.
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
    output wire [9:0] copy_splat,  // Place of its splat's payload.
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
    input  wire [9:0] placed_splat,  // Place of its splat's payload.
    input  wire placed_slot,  // Slot of the tile cache.
    output wire out_valid, input wire out_ready,  // The same with their payload.
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
    output wire out_sight_negative,  // `D` is negative before the eye.
    output wire [19:0] out_sight_near,  // The magnitude of `D` at the near plane; all ones where no sample lies before it.
    output wire [19:0] out_sight_far,  // The magnitude of `D` at the far plane; zero where no sample lies behind it.
    output wire out_sight_turned,  // The origin is the vanishing point of a tangent: `s1` and `D` have changed places.
    output wire out_sight_disc,  // The origin is the splat's centre, and lies between near and far plane: the filter's disc is drawn.
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
    output wire [3:0] out_first_sum,  // Smallest sum.
    output wire [3:0] out_last_sum,  // Largest sum.
    output wire [3:0] out_first_difference,  // Smallest difference.
    output wire [3:0] out_last_difference,  // Largest difference.
    output wire [11:0] out_tile,  // Tile index: row above column.
    output wire out_slot  // Slot of the tile cache.
);
    reg clearing;
    reg [9:0] cleared;
    reg has_free;
    reg [9:0] free;
    reg holds, passes;
    reg [9:0] place;
    reg [12:0] copies;
    reg open, writing, word;
    reg [161:0] word_1;
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
    reg [9:0] current_splat;  // Place of its splat's payload.
    reg current_slot;  // Slot of the tile cache.
    wire [161:0] shown_word;
    reg [161:0] kept_0;
    reg [25:0] complete_center_x;  // Projected center (px), the origin of what follows.
    reg [25:0] complete_center_y;  // Projected center (px), the origin of what follows.
    reg [15:0] complete_ax;  // `A` in x.
    reg [15:0] complete_bx;  // `B` in x.
    reg [15:0] complete_ay;  // `A` in y.
    reg [15:0] complete_by;  // `B` in y.
    reg [19:0] complete_delta;  // The determinant of `A` and `B`.
    reg [15:0] complete_mx;  // `m` in x.
    reg [15:0] complete_my;  // `m` in y.
    reg [3:0] complete_shift;  // In fixed point, places by which offsets from the centre are shifted.
    reg complete_sight_negative;  // `D` is negative before the eye.
    reg [19:0] complete_sight_near;  // The magnitude of `D` at the near plane; all ones where no sample lies before it.
    reg [19:0] complete_sight_far;  // The magnitude of `D` at the far plane; zero where no sample lies behind it.
    reg complete_sight_turned;  // The origin is the vanishing point of a tangent: `s1` and `D` have changed places.
    reg complete_sight_disc;  // The origin is the splat's centre, and lies between near and far plane: the filter's disc is drawn.
    reg [23:0] complete_depth;  // Depth.
    reg [23:0] complete_depth_low;  // What is nearer hides the splat.
    reg [23:0] complete_depth_high;  // What is farther is hidden by the splat.
    reg [11:0] complete_attribute_0;  // Attributes.
    reg [11:0] complete_attribute_1;  // Attributes.
    reg [11:0] complete_attribute_2;  // Attributes.
    reg [2:0] complete_left;  // First column.
    reg [2:0] complete_right;  // Last column.
    reg [2:0] complete_top;  // First row.
    reg [2:0] complete_bottom;  // Last row.
    reg [3:0] complete_first_sum;  // Smallest sum.
    reg [3:0] complete_last_sum;  // Largest sum.
    reg [3:0] complete_first_difference;  // Smallest difference.
    reg [3:0] complete_last_difference;  // Largest difference.
    reg [11:0] complete_tile;  // Tile index: row above column.
    reg complete_slot;  // Slot of the tile cache.
    reg [25:0] held_out_center_x;  // Projected center (px), the origin of what follows.
    reg [25:0] held_out_center_y;  // Projected center (px), the origin of what follows.
    reg [15:0] held_out_ax;  // `A` in x.
    reg [15:0] held_out_bx;  // `B` in x.
    reg [15:0] held_out_ay;  // `A` in y.
    reg [15:0] held_out_by;  // `B` in y.
    reg [19:0] held_out_delta;  // The determinant of `A` and `B`.
    reg [15:0] held_out_mx;  // `m` in x.
    reg [15:0] held_out_my;  // `m` in y.
    reg [3:0] held_out_shift;  // In fixed point, places by which offsets from the centre are shifted.
    reg held_out_sight_negative;  // `D` is negative before the eye.
    reg [19:0] held_out_sight_near;  // The magnitude of `D` at the near plane; all ones where no sample lies before it.
    reg [19:0] held_out_sight_far;  // The magnitude of `D` at the far plane; zero where no sample lies behind it.
    reg held_out_sight_turned;  // The origin is the vanishing point of a tangent: `s1` and `D` have changed places.
    reg held_out_sight_disc;  // The origin is the splat's centre, and lies between near and far plane: the filter's disc is drawn.
    reg [23:0] held_out_depth;  // Depth.
    reg [23:0] held_out_depth_low;  // What is nearer hides the splat.
    reg [23:0] held_out_depth_high;  // What is farther is hidden by the splat.
    reg [11:0] held_out_attribute_0;  // Attributes.
    reg [11:0] held_out_attribute_1;  // Attributes.
    reg [11:0] held_out_attribute_2;  // Attributes.
    reg [2:0] held_out_left;  // First column.
    reg [2:0] held_out_right;  // Last column.
    reg [2:0] held_out_top;  // First row.
    reg [2:0] held_out_bottom;  // Last row.
    reg [3:0] held_out_first_sum;  // Smallest sum.
    reg [3:0] held_out_last_sum;  // Largest sum.
    reg [3:0] held_out_first_difference;  // Smallest difference.
    reg [3:0] held_out_last_difference;  // Largest difference.
    reg [11:0] held_out_tile;  // Tile index: row above column.
    reg held_out_slot;  // Slot of the tile cache.
    reg left_valid;
    reg [9:0] left_place;
    wire [12:0] shown_balance;
    reg reading_valid;
    reg [9:0] reading_place;
    reg [12:0] reading_number;
    reg caught_valid;
    reg [9:0] caught_place;
    reg [12:0] caught_number, balance;
    reg added_valid;
    reg [9:0] added_place;
    reg [12:0] added_number;
    reg earlier_valid;
    reg [9:0] earlier_place;
    reg [12:0] earlier_number, earliest_number;
    reg follows_added, follows_earlier, follows_earliest;

    wire closes_in_ready, closes_out_valid;
    wire [22:0] closes_out_data;
    wire released_in_ready, released_out_valid;
    wire [9:0] released_out_data;
    wire placed_queue_out_valid;
    wire [50:0] placed_queue_out_data;

    wire ready = ~holds & (closes_in_ready & (has_free | passes));
    wire copy_shown = holds & (~writing | word);
    wire [161:0] payload_words_data_bits = {in_center_x, in_center_y, in_ax, in_bx, in_ay, in_by, in_delta, in_mx, in_my[15:6]};
    wire leaves = current_valid & beat & complete_room;
    wire advance = ~current_valid | leaves;
    wire advance_or_not_beat = advance | ~beat;
    wire beat_choice = advance ? 1'd0 : (beat + 1'd1);
    wire [9:0] placed_queue_out_splat = placed_queue_out_data[10:1];
    wire [9:0] balances_address_choice = added_valid ? added_place : cleared;
    wire [9:0] closes_out_place = closes_out_data[22:13];
    wire [9:0] begins_place = left_valid ? left_place : closes_out_place;
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
    wire [2:0] placed_queue_out_left = placed_queue_out_data[50:48];
    wire [2:0] placed_queue_out_right = placed_queue_out_data[47:45];
    wire [2:0] placed_queue_out_top = placed_queue_out_data[44:42];
    wire [2:0] placed_queue_out_bottom = placed_queue_out_data[41:39];
    wire [3:0] placed_queue_out_first_sum = placed_queue_out_data[38:35];
    wire [3:0] placed_queue_out_last_sum = placed_queue_out_data[34:31];
    wire [3:0] placed_queue_out_first_difference = placed_queue_out_data[30:27];
    wire [3:0] placed_queue_out_last_difference = placed_queue_out_data[26:23];
    wire [11:0] placed_queue_out_tile = placed_queue_out_data[22:11];
    wire placed_queue_out_slot = placed_queue_out_data[0];
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
    assign out_shift = held_out_shift;
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

    memory_1w1r_unordered #(.WIDTH(162), .DEPTH(2048), .SLICE(9)) payload_words (
        .clk(clk), .write(writing | (~holds & has_free)), .write_address({word, writing ? place : free}),
        .write_data(word ? word_1 : payload_words_data_bits),
        .read(advance_or_not_beat),
        .read_address({beat_choice, advance ? placed_queue_out_splat : current_splat}),
        .read_data(shown_word)
    );

    memory_1w1r_unordered #(.WIDTH(13), .DEPTH(1024)) balances (
        .clk(clk), .write(clearing | added_valid), .write_address(balances_address_choice),
        .write_data({13{added_valid}} & added_number),
        .read(1'd1), .read_address(begins_place), .read_data(shown_balance)
    );

    stream_skid_w23 closes (
        .clk(clk), .rst(rst), .in_valid(closes_splat), .in_ready(closes_in_ready), .in_data({place, copies}),
        .out_valid(closes_out_valid), .out_ready(closes_out_ready), .out_data(closes_out_data)
    );

    stream_fifo_d1024_w10 released (
        .clk(clk), .rst(rst), .in_valid(releases), .in_ready(released_in_ready),
        .in_data(balances_address_choice),
        .out_valid(released_out_valid), .out_ready(takes_free), .out_data(released_out_data)
    );

    stream_skid_w51 placed_queue (
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
            cleared <= 10'd0;
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
            clearing <= clearing & ~(clears & (cleared == 10'd1023));
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
            if (clears) cleared <= cleared + 10'd1;
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
                in_my[5:0], in_shift, in_sight_negative, in_sight_near, in_sight_far, in_sight_turned, in_sight_disc,
                in_depth, in_depth_low, in_depth_high, in_attribute_0, in_attribute_1, in_attribute_2, 1'd0
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
            complete_center_x <= kept_0[161:136];
            complete_center_y <= kept_0[135:110];
            complete_ax <= kept_0[109:94];
            complete_bx <= kept_0[93:78];
            complete_ay <= kept_0[77:62];
            complete_by <= kept_0[61:46];
            complete_delta <= kept_0[45:26];
            complete_mx <= kept_0[25:10];
            complete_my <= {kept_0[9:0], shown_word[161:156]};
            complete_shift <= shown_word[155:152];
            complete_sight_negative <= shown_word[151];
            complete_sight_near <= shown_word[150:131];
            complete_sight_far <= shown_word[130:111];
            complete_sight_turned <= shown_word[110];
            complete_sight_disc <= shown_word[109];
            complete_depth <= shown_word[108:85];
            complete_depth_low <= shown_word[84:61];
            complete_depth_high <= shown_word[60:37];
            complete_attribute_0 <= shown_word[36:25];
            complete_attribute_1 <= shown_word[24:13];
            complete_attribute_2 <= shown_word[12:1];
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
            held_out_shift <= complete_shift;
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
// width = 51
module stream_skid_w51 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [50:0] in_data,
    output wire out_valid, input wire out_ready, output wire [50:0] out_data
);
    reg head_filled, second_filled, room;
    reg [50:0] head, second;

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
// depth = 1024
// width = 10
module stream_fifo_d1024_w10 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [9:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [9:0] out_data
);
    reg [10:0] held, waiting;
    reg is_full, any_waits;
    reg [9:0] write_address, read_address;
    wire [9:0] item;

    wire has_room = ~is_full;
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [10:0] held_bits = {{10{~push}}, 1'd1};
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    memory_1w1r_unordered #(.WIDTH(10), .DEPTH(1024)) entries (
        .clk(clk), .write(has_room), .write_address(write_address), .write_data(in_data),
        .read(fetch), .read_address(read_address), .read_data(item)
    );

    always @(posedge clk) begin
        if (rst) begin
            held <= 11'd0;
            waiting <= 11'd0;
            is_full <= 1'd0;
            any_waits <= 1'd0;
            write_address <= 10'd0;
            read_address <= 10'd0;
            out_valid <= 1'd0;
        end else begin
            if (push_xor_pop) begin
                held <= held + held_bits;
                is_full <= push & (held == 11'd1023);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 11'd1);
            end
            if (push) write_address <= write_address + 10'd1;
            if (fetch) read_address <= read_address + 10'd1;
            out_valid <= fetch | (out_valid & ~out_ready);
        end
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        held_in_range: assert (held <= 11'h400);
        held_is_waiting_and_shown: assert (held == (waiting + {10'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 11'h400)) & (any_waits == |waiting));
`else
        if (!(held <= 11'h400)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {10'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 11'h400)) & (any_waits == |waiting))) begin
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

// Splits a splat's octagon into one copy per tile.
module splat_splitter (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready,  // Footprints with bounds in the image.
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
    input  wire in_sight_negative,  // `D` is negative before the eye.
    input  wire [19:0] in_sight_near,  // The magnitude of `D` at the near plane; all ones where no sample lies before it.
    input  wire [19:0] in_sight_far,  // The magnitude of `D` at the far plane; zero where no sample lies behind it.
    input  wire in_sight_turned,  // The origin is the vanishing point of a tangent: `s1` and `D` have changed places.
    input  wire in_sight_disc,  // The origin is the splat's centre, and lies between near and far plane: the filter's disc is drawn.
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
    input  wire [9:0] in_first_sum,  // Smallest sum.
    input  wire [9:0] in_last_sum,  // Largest sum.
    input  wire [9:0] in_first_difference,  // Smallest difference.
    input  wire [9:0] in_last_difference,  // Largest difference.
    output wire out_valid, input wire out_ready,  // Copies with bounds in their tiles.
    output wire out_end,  // Closes the frame.
    output wire out_first,  // It is the first of its splat.
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
    output wire out_sight_negative,  // `D` is negative before the eye.
    output wire [19:0] out_sight_near,  // The magnitude of `D` at the near plane; all ones where no sample lies before it.
    output wire [19:0] out_sight_far,  // The magnitude of `D` at the far plane; zero where no sample lies behind it.
    output wire out_sight_turned,  // The origin is the vanishing point of a tangent: `s1` and `D` have changed places.
    output wire out_sight_disc,  // The origin is the splat's centre, and lies between near and far plane: the filter's disc is drawn.
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
    output wire [3:0] out_first_sum,  // Smallest sum.
    output wire [3:0] out_last_sum,  // Largest sum.
    output wire [3:0] out_first_difference,  // Smallest difference.
    output wire [3:0] out_last_difference,  // Largest difference.
    output wire [11:0] out_tile  // Tile index: row above column.
);
    reg none_made, room, busy, open, ready, closed;
    reg splat_end;  // Closes the frame.
    reg [25:0] splat_center_x;  // Projected center (px), the origin of what follows.
    reg [25:0] splat_center_y;  // Projected center (px), the origin of what follows.
    reg [15:0] splat_ax;  // `A` in x.
    reg [15:0] splat_bx;  // `B` in x.
    reg [15:0] splat_ay;  // `A` in y.
    reg [15:0] splat_by;  // `B` in y.
    reg [19:0] splat_delta;  // The determinant of `A` and `B`.
    reg [15:0] splat_mx;  // `m` in x.
    reg [15:0] splat_my;  // `m` in y.
    reg [3:0] splat_shift;  // In fixed point, places by which offsets from the centre are shifted.
    reg splat_sight_negative;  // `D` is negative before the eye.
    reg [19:0] splat_sight_near;  // The magnitude of `D` at the near plane; all ones where no sample lies before it.
    reg [19:0] splat_sight_far;  // The magnitude of `D` at the far plane; zero where no sample lies behind it.
    reg splat_sight_turned;  // The origin is the vanishing point of a tangent: `s1` and `D` have changed places.
    reg splat_sight_disc;  // The origin is the splat's centre, and lies between near and far plane: the filter's disc is drawn.
    reg [23:0] splat_depth;  // Depth.
    reg [23:0] splat_depth_low;  // What is nearer hides the splat.
    reg [23:0] splat_depth_high;  // What is farther is hidden by the splat.
    reg [11:0] splat_attribute_0;  // Attributes.
    reg [11:0] splat_attribute_1;  // Attributes.
    reg [11:0] splat_attribute_2;  // Attributes.
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
    wire [368:0] out_queue_out_data;

    wire [3:0] out_queue_out_made = out_queue_out_data[368:365];
    wire made = &out_queue_out_made;
    wire out_queue_out_first = out_queue_out_data[363];
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
    assign out_end = out_queue_out_data[364];
    assign out_first = out_first_either;
    assign {
        out_center_x, out_center_y, out_ax, out_bx, out_ay, out_by, out_delta, out_mx, out_my, out_shift,
        out_sight_negative, out_sight_near, out_sight_far, out_sight_turned, out_sight_disc, out_depth,
        out_depth_low, out_depth_high, out_attribute_0, out_attribute_1, out_attribute_2, out_left, out_right,
        out_top, out_bottom, out_first_sum, out_last_sum, out_first_difference, out_last_difference, out_tile
    } = out_queue_out_data[362:0];

    stream_half_buffer_w369 out_queue (
        .clk(clk), .rst(rst), .in_valid(room & busy), .in_ready(out_queue_in_ready),
        .in_data({
            splat_end | out_queue_in_data_both_2, splat_end | out_queue_in_data_both_5,
            splat_end | out_queue_in_data_both_8, out_queue_in_data_either, splat_end, first, splat_center_x,
            splat_center_y, splat_ax, splat_bx, splat_ay, splat_by, splat_delta, splat_mx, splat_my, splat_shift,
            splat_sight_negative, splat_sight_near, splat_sight_far, splat_sight_turned, splat_sight_disc,
            splat_depth, splat_depth_low, splat_depth_high, splat_attribute_0, splat_attribute_1,
            splat_attribute_2, left, right, out_queue_in_data_either_4[2:0], out_queue_in_data_either_7[2:0],
            first_sum, last_sum[3:0], ~not_first_difference, last_difference[3:0], row, column
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
            splat_shift <= in_shift;
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
// width = 369
module stream_half_buffer_w369 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [368:0] in_data,
    output wire out_valid, input wire out_ready, output wire [368:0] out_data
);
    reg filled;
    reg [368:0] item;

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
// latency = 171
// initiation_interval = 8
module splat_setup (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready,  // Splats in camera space.
    input  wire in_end,  // Closes the frame.
    input  wire [23:0] in_center_x,  // Center.
    input  wire [23:0] in_center_y,  // Center.
    input  wire [23:0] in_center_z,  // Center.
    input  wire [23:0] in_tangent1_x,  // Tangents, whose ends lie at rho = 1.
    input  wire [23:0] in_tangent1_y,  // Tangents, whose ends lie at rho = 1.
    input  wire [23:0] in_tangent1_z,  // Tangents, whose ends lie at rho = 1.
    input  wire [23:0] in_tangent2_x,  // Tangents, whose ends lie at rho = 1.
    input  wire [23:0] in_tangent2_y,  // Tangents, whose ends lie at rho = 1.
    input  wire [23:0] in_tangent2_z,  // Tangents, whose ends lie at rho = 1.
    input  wire [11:0] in_attribute_0,  // Attributes.
    input  wire [11:0] in_attribute_1,  // Attributes.
    input  wire [11:0] in_attribute_2,  // Attributes.
    input  wire [23:0] near_plane,  // Near plane.
    input  wire [23:0] filter_radius,  // Radius of the screen filter (px).
    input  wire [23:0] depth_a,  // Depth is `depth_a + depth_b/z`, in `[0, 1]`.
    input  wire [23:0] depth_b,  // See `depth_a`.
    input  wire [23:0] epsilon_scale,  // Scale of the splat's own depth range.
    input  wire [23:0] epsilon_bias,  // Constant part.
    input  wire [23:0] scale_x,  // Scale (px).
    input  wire [23:0] origin_x,  // Where the optical axis meets the image (px).
    input  wire [23:0] scale_y,  // Scale (px).
    input  wire [23:0] origin_y,  // Where the optical axis meets the image (px).
    output wire out_valid, input wire out_ready,  // Footprints with bounds.
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
    output wire out_sight_negative,  // `D` is negative before the eye.
    output wire [19:0] out_sight_near,  // The magnitude of `D` at the near plane; all ones where no sample lies before it.
    output wire [19:0] out_sight_far,  // The magnitude of `D` at the far plane; zero where no sample lies behind it.
    output wire out_sight_turned,  // The origin is the vanishing point of a tangent: `s1` and `D` have changed places.
    output wire out_sight_disc,  // The origin is the splat's centre, and lies between near and far plane: the filter's disc is drawn.
    output wire [23:0] out_depth,  // Depth.
    output wire [23:0] out_depth_low,  // What is nearer hides the splat.
    output wire [23:0] out_depth_high,  // What is farther is hidden by the splat.
    output wire [11:0] out_attribute_0,  // Attributes.
    output wire [11:0] out_attribute_1,  // Attributes.
    output wire [11:0] out_attribute_2,  // Attributes.
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
    reg [23:0] delay_7_from_0 [0:5];
    (* ram_style = "distributed" *)
    reg [23:0] delay_9_from_0 [0:7];
    (* ram_style = "distributed" *)
    reg delay_12_from_0 [0:10];
    (* ram_style = "distributed" *)
    reg delay_21_from_0 [0:19];
    (* ram_style = "distributed" *)
    reg [35:0] delay_22_from_0 [0:20];
    (* ram_style = "distributed" *)
    reg [8:0] delay_5_from_1 [0:3];
    (* ram_style = "distributed" *)
    reg [23:0] delay_6_from_1 [0:4];
    (* ram_style = "distributed" *)
    reg delay_7_from_1 [0:5];
    (* ram_style = "distributed" *)
    reg [1:0] delay_11_from_1 [0:9];
    (* ram_style = "distributed" *)
    reg [23:0] delay_6_from_2 [0:4];
    (* ram_style = "distributed" *)
    reg [47:0] delay_7_from_2 [0:5];
    (* ram_style = "distributed" *)
    reg [51:0] delay_10_from_3 [0:8];
    (* ram_style = "distributed" *)
    reg delay_11_from_3 [0:9];
    (* ram_style = "distributed" *)
    reg delay_12_from_3 [0:10];
    (* ram_style = "distributed" *)
    reg [53:0] delay_14_from_3 [0:12];
    (* ram_style = "distributed" *)
    reg delay_8_from_4 [0:6];
    (* ram_style = "distributed" *)
    reg [23:0] delay_6_from_5 [0:4];
    (* ram_style = "distributed" *)
    reg [23:0] delay_7_from_5 [0:5];
    (* ram_style = "distributed" *)
    reg [10:0] delay_8_from_5 [0:6];
    (* ram_style = "distributed" *)
    reg [93:0] delay_9_from_5 [0:7];
    (* ram_style = "distributed" *)
    reg [64:0] delay_11_from_5 [0:9];
    (* ram_style = "distributed" *)
    reg [56:0] delay_5_from_6 [0:3];
    (* ram_style = "distributed" *)
    reg delay_6_from_6 [0:4];
    (* ram_style = "distributed" *)
    reg delay_7_from_6 [0:5];
    (* ram_style = "distributed" *)
    reg [10:0] delay_8_from_6 [0:6];
    (* ram_style = "distributed" *)
    reg [36:0] delay_9_from_6 [0:7];
    (* ram_style = "distributed" *)
    reg [4:0] delay_10_from_6 [0:8];
    (* ram_style = "distributed" *)
    reg [32:0] delay_11_from_6 [0:9];
    (* ram_style = "distributed" *)
    reg delay_14_from_6 [0:12];
    (* ram_style = "distributed" *)
    reg [23:0] delay_9_from_7 [0:7];
    (* ram_style = "distributed" *)
    reg [15:0] delay_10_from_7 [0:8];
    (* ram_style = "distributed" *)
    reg [1:0] delay_11_from_7 [0:9];
    (* ram_style = "distributed" *)
    reg delay_12_from_7 [0:10];
    (* ram_style = "distributed" *)
    reg delay_19_from_7 [0:17];
    reg [5:0] credits;
    reg [7:0] phases_1;
    reg [2:0] delay_7_from_0_pointer;
    reg [23:0] delay_7_from_0_out;
    reg [2:0] delay_9_from_0_pointer;
    reg [23:0] delay_9_from_0_out;
    reg [3:0] delay_12_from_0_pointer;
    reg delay_12_from_0_out;
    reg [4:0] delay_21_from_0_pointer;
    reg delay_21_from_0_out;
    reg [4:0] delay_22_from_0_pointer;
    reg [35:0] delay_22_from_0_out;
    reg [1:0] delay_5_from_1_pointer;
    reg [8:0] delay_5_from_1_out;
    reg [2:0] delay_6_from_1_pointer;
    reg [23:0] delay_6_from_1_out;
    reg [2:0] delay_7_from_1_pointer;
    reg delay_7_from_1_out;
    reg [3:0] delay_11_from_1_pointer;
    reg [1:0] delay_11_from_1_out;
    reg [2:0] delay_6_from_2_pointer;
    reg [23:0] delay_6_from_2_out;
    reg [2:0] delay_7_from_2_pointer;
    reg [47:0] delay_7_from_2_out;
    reg [3:0] delay_10_from_3_pointer;
    reg [51:0] delay_10_from_3_out;
    reg [3:0] delay_11_from_3_pointer;
    reg delay_11_from_3_out;
    reg [3:0] delay_12_from_3_pointer;
    reg delay_12_from_3_out;
    reg [3:0] delay_14_from_3_pointer;
    reg [53:0] delay_14_from_3_out;
    reg [2:0] delay_8_from_4_pointer;
    reg delay_8_from_4_out;
    reg [2:0] delay_6_from_5_pointer;
    reg [23:0] delay_6_from_5_out;
    reg [2:0] delay_7_from_5_pointer;
    reg [23:0] delay_7_from_5_out;
    reg [2:0] delay_8_from_5_pointer;
    reg [10:0] delay_8_from_5_out;
    reg [7:0] phases_2;
    reg [2:0] delay_9_from_5_pointer;
    reg [93:0] delay_9_from_5_out;
    reg [7:0] phases_3;
    reg [3:0] delay_11_from_5_pointer;
    reg [64:0] delay_11_from_5_out;
    reg [1:0] delay_5_from_6_pointer;
    reg [56:0] delay_5_from_6_out;
    reg [2:0] delay_6_from_6_pointer;
    reg delay_6_from_6_out;
    reg [2:0] delay_7_from_6_pointer;
    reg delay_7_from_6_out;
    reg [2:0] delay_8_from_6_pointer;
    reg [10:0] delay_8_from_6_out;
    reg [2:0] delay_9_from_6_pointer;
    reg [36:0] delay_9_from_6_out;
    reg [3:0] delay_10_from_6_pointer;
    reg [4:0] delay_10_from_6_out;
    reg [3:0] delay_11_from_6_pointer;
    reg [32:0] delay_11_from_6_out;
    reg [3:0] delay_14_from_6_pointer;
    reg delay_14_from_6_out;
    reg [2:0] delay_9_from_7_pointer;
    reg [23:0] delay_9_from_7_out;
    reg [3:0] delay_10_from_7_pointer;
    reg [15:0] delay_10_from_7_out;
    reg [3:0] delay_11_from_7_pointer;
    reg [1:0] delay_11_from_7_out;
    reg [3:0] delay_12_from_7_pointer;
    reg delay_12_from_7_out;
    reg [4:0] delay_19_from_7_pointer;
    reg delay_19_from_7_out, end_d22;
    reg [23:0] center_x_d1, center_y_d1, center_z_d1, center_z_d2, tangent1_x_d1, tangent1_y_d1, tangent1_z_d1;
    reg [23:0] tangent2_x_d1, tangent2_y_d1, tangent2_z_d1;
    reg [10:0] first_x_greater_bits_d1, first_x_greater_bits_plus_1_d1;
    reg first_x_in_order_d1, first_x_inverted_d1, first_x_greater_bits_is_255_d1, first_x_in_order_d1_copy2;
    reg first_x_both_d1;
    reg [14:0] first_x_greater_bits_d1_copy2;
    reg first_x_either_d1, first_x_greater_sign_d1;
    reg [23:0] first_x_joined_d1;
    reg [10:0] first_y_greater_bits_d1, first_y_greater_bits_plus_1_d1;
    reg first_y_in_order_d1, first_y_inverted_d1, first_y_greater_bits_is_255_d1, first_y_in_order_d1_copy2;
    reg first_y_both_d1;
    reg [14:0] first_y_greater_bits_d1_copy2;
    reg first_y_either_d1, first_y_greater_sign_d1;
    reg [23:0] first_y_joined_d1;
    reg [10:0] reaches_near_greater_bits_d1, reaches_near_sum_d1;
    reg zero_below_reaches_near_sum_d1, not_reaches_near_same_d1, reaches_near_same_d1;
    reg reaches_near_in_order_d1, reaches_near_both_d1;
    reg [14:0] reaches_near_greater_bits_d1_copy2;
    reg reaches_near_either_d1, reaches_near_greater_sign_d1;
    reg [23:0] reaches_near_joined_d1;
    reg beyond_near_d1, beyond_near_d2, swapped_d1;
    reg [10:0] turned_greater_d1;
    reg [7:0] phases_4;
    reg [10:0] center_z_bits_plus_4_d1;
    reg turned_either_d1, turned_d1;
    reg [23:0] v_x_chosen_d1, v_x_chosen_d2, v_x_chosen_d3, v_y_chosen_d1, v_y_chosen_d2, v_y_chosen_d3;
    reg [23:0] lowered_chosen_d1;
    reg [10:0] lowered_chosen_bits_d1, lowered_chosen_bits_d1_copy2, lowered_greater_d1;
    reg [10:0] lowered_chosen_bits_d1_copy3, lowered_greater_d1_copy2;
    reg [7:0] phases_5;
    reg [10:0] lowered_chosen_bits_d1_copy4, lowered_greater_d1_copy3, lowered_chosen_bits_d1_copy5;
    reg [10:0] lowered_greater_d1_copy4, lowered_chosen_bits_d1_copy6, lowered_greater_d1_copy5;
    reg [10:0] lowered_chosen_bits_plus_60_d1, lowered_d1, lowered_d2, lowered_d3, lowered_d4, lowered_d5;
    reg [10:0] lowered_d6;
    reg a_x_inverted_d1, a_x_in_order_and_a_x_inverted_d1, lowered_chosen_bits_is_255_d1;
    reg [14:0] lowered_chosen_bits_d1_copy7;
    reg [7:0] a_x_chosen_d1;
    reg lowered_chosen_sign_d1;
    reg [23:0] a_x_joined_d1, a_x_joined_d2, a_x_joined_d3;
    reg a_y_inverted_d1, a_y_in_order_and_a_y_inverted_d1, lowered_chosen_bits_is_255_d1_copy2;
    reg [7:0] phases_6;
    reg [14:0] lowered_chosen_bits_d1_copy8;
    reg [7:0] a_y_chosen_d1;
    reg lowered_chosen_sign_d1_copy2;
    reg [23:0] a_y_joined_d1, a_y_joined_d2, a_y_joined_d3;
    reg alpha_inverted_d1, alpha_both_d1, lowered_chosen_bits_is_255_d1_copy3;
    reg [14:0] lowered_chosen_bits_d1_copy9;
    reg [7:0] alpha_chosen_d1;
    reg lowered_chosen_sign_d1_copy3;
    reg [23:0] alpha_joined_d1;
    reg [7:0] phases_7;
    reg [23:0] alpha_joined_d2;
    reg b_x_inverted_d1, b_x_in_order_and_b_x_inverted_d1, lowered_chosen_bits_is_255_d1_copy4;
    reg [14:0] lowered_chosen_bits_d1_copy10;
    reg [7:0] b_x_chosen_d1;
    reg lowered_chosen_sign_d1_copy4;
    reg [23:0] b_x_joined_d1, b_x_joined_d2, b_x_joined_d3;
    reg b_y_inverted_d1, b_y_in_order_and_b_y_inverted_d1, lowered_chosen_bits_is_255_d1_copy5;
    reg [14:0] lowered_chosen_bits_d1_copy11;
    reg [7:0] b_y_chosen_d1;
    reg lowered_chosen_sign_d1_copy5;
    reg [7:0] phases_8;
    reg [23:0] b_y_joined_d1, b_y_joined_d2, b_y_joined_d3;
    reg beta_inverted_d1, beta_both_d1, lowered_chosen_bits_is_255_d1_copy6;
    reg [14:0] lowered_chosen_bits_d1_copy12;
    reg [7:0] beta_chosen_d1;
    reg lowered_chosen_sign_d1_copy6;
    reg [23:0] beta_joined_d1;
    reg [7:0] phases_9;
    reg [23:0] beta_joined_d2;
    reg not_turned_d1, not_turned_d2, not_turned_d3, not_turned_d4, not_turned_d5, not_turned_d6;
    reg beyond_near_and_not_turned_d1, beyond_near_and_not_turned_d2, beyond_near_and_not_turned_d3;
    reg beyond_near_and_not_turned_d4;
    reg [23:0] r_d1, alpha_d1, alpha_d2, alpha_d3, beta_d1, beta_d2, beta_d3, q_d1, q_d2, q_d3, q_d4, e_d1;
    reg zero_is_lowered_d1, whole_d1, whole_d8, whole_d9;
    reg [23:0] f_d1, f_d2, b_depth_d1, b_depth_d2, b_depth_d3, b_depth_d4, b_depth_d5, b_depth_d6, center_depth_d7;
    reg [23:0] center_depth_d8, center_depth_d9, spread_middle_d1, spread_middle_d2, root_of_q_d1;
    reg [23:0] f_times_root_of_q_d1, spread_half_d1, spread_half_d2;
    reg beyond_near_d1_copy2;
    reg [23:0] one_minus_depth_a_d1, before_far_sum_d1, before_far_joined_d1;
    reg before_far_in_order_d1, sight_disc_out_d12, sight_disc_out_d13, sight_disc_out_d14;
    reg sight_disc_out_d15, sight_disc_out_d16;
    reg [23:0] middle_depth_d1, middle_depth_d2, half_depth_d1, half_depth_times_epsilon_scale_d1, epsilon_d1;
    reg [23:0] v_x_d1, a_x_d1, b_x_d1, center_x_d6, center_x_d7, center_x_d8, center_x_d9, t_x_sum_d1, t_x_sum_d2;
    reg [23:0] t_x_d1, h_x_sum_d1, h_x_sum_d2, h_x_sum_d3, h_x_sum_d1_copy2, center_x_minus_t_x_d1;
    reg [23:0] center_x_minus_t_x_d2, center_x_minus_t_x_d3, center_x_minus_t_x_d4, minus_h_x_d1;
    reg [7:0] phases_10;
    reg [23:0] center_x_minus_first_x_joined_d1, center_x_plus_first_x_joined_d1, f_times_scale_x_d1;
    reg [23:0] first_x_joined_d1_copy2, first_x_chosen_d1, first_x_chosen_d2, first_x_chosen_d3, last_x_chosen_d1;
    reg [23:0] last_x_chosen_d2, last_x_chosen_d3, first_x_chosen_d1_copy2, last_x_chosen_d1_copy2;
    reg [23:0] center_x_minus_filter_radius_d1, filter_radius_plus_center_x_d1, first_x_chosen_d1_copy3;
    reg [23:0] last_x_chosen_d1_copy3;
    reg [21:0] first_x_shifted_d1, last_x_shifted_d1, last_x_lesser_d1;
    reg [8:0] last_x_d1, last_x_d2, last_x_d3, last_x_d4, last_x_d5;
    reg [23:0] v_y_d1, a_y_d1, b_y_d1, center_y_d1_copy2, center_y_d7, center_y_d8, center_y_d9, t_y_sum_d1, t_y_d1;
    reg [23:0] h_y_sum_d1, h_y_sum_d2, h_y_sum_d3, minus_t_y_d1, center_y_minus_t_y_d1, center_y_minus_t_y_d2;
    reg [23:0] center_y_minus_t_y_d3, center_y_minus_first_y_joined_d1, center_y_plus_first_y_joined_d1;
    reg first_y_in_order_d1_copy3;
    reg [23:0] f_times_scale_y_d1;
    reg [7:0] phases_11;
    reg [23:0] first_y_joined_d1_copy2, first_y_chosen_d1, first_y_chosen_d2, first_y_chosen_d3, last_y_chosen_d1;
    reg [7:0] phases_12;
    reg [23:0] last_y_chosen_d2, last_y_chosen_d3, first_y_chosen_d1_copy2, last_y_chosen_d1_copy2;
    reg [23:0] center_y_minus_filter_radius_d1, filter_radius_plus_center_y_d1, first_y_chosen_d1_copy3;
    reg [23:0] last_y_chosen_d1_copy3;
    reg [21:0] first_y_shifted_d1, last_y_shifted_d1, last_y_lesser_d1;
    reg [8:0] last_y_d1, last_y_d2, last_y_d3, last_y_d4;
    reg [10:0] a_x_bits_d1, a_x_bits_d2, a_x_bits_d3, a_x_bits_d4, a_y_bits_d1, a_y_bits_d2, a_y_bits_d3;
    reg [10:0] a_exponent_d1, b_x_bits_d1, b_x_bits_d2, b_x_bits_d3, b_y_bits_d1, b_y_bits_d2, b_y_bits_d3;
    reg [10:0] b_exponent_d1, a_x_bits_plus_127_d1;
    reg not_zero_is_a_x_bits_d1, not_zero_is_a_x_bits_d2, not_zero_is_a_x_bits_d3, not_zero_is_a_x_bits_d4;
    reg unit_delta_both_d1, a_x_bits_is_255_d1, a_x_bits_is_255_d2, a_x_bits_is_255_d3;
    reg [14:0] a_x_bits_d1_copy2;
    reg [7:0] phases_13;
    reg [14:0] a_x_bits_d2_copy2, a_x_bits_d3_copy2;
    reg [7:0] unit_delta_chosen_d1;
    reg a_x_sign_d1, a_x_sign_d2, a_x_sign_d3;
    reg [23:0] unit_delta_joined_d1;
    reg [10:0] a_y_bits_plus_127_d1;
    reg not_zero_is_a_y_bits_d1, not_zero_is_a_y_bits_d2, not_zero_is_a_y_bits_d3, unit_delta_both_d1_copy2;
    reg a_y_bits_is_255_d1, a_y_bits_is_255_d2, a_y_bits_is_255_d3;
    reg [14:0] a_y_bits_d1_copy2, a_y_bits_d2_copy2, a_y_bits_d3_copy2;
    reg [7:0] unit_delta_chosen_d1_copy2;
    reg a_y_sign_d1, a_y_sign_d2, a_y_sign_d3;
    reg [23:0] unit_delta_joined_d1_copy2, unit_delta_joined_d2;
    reg [10:0] b_x_bits_plus_127_d1;
    reg not_zero_is_b_x_bits_d1, not_zero_is_b_x_bits_d2, not_zero_is_b_x_bits_d3, unit_delta_both_d1_copy3;
    reg b_x_bits_is_255_d1, b_x_bits_is_255_d2, b_x_bits_is_255_d3;
    reg [14:0] b_x_bits_d1_copy2, b_x_bits_d2_copy2, b_x_bits_d3_copy2;
    reg [7:0] unit_delta_chosen_d1_copy3;
    reg b_x_sign_d1, b_x_sign_d2, b_x_sign_d3;
    reg [23:0] unit_delta_joined_d1_copy3, unit_delta_joined_d2_copy2;
    reg [10:0] b_y_bits_plus_127_d1;
    reg not_zero_is_b_y_bits_d1, not_zero_is_b_y_bits_d2, not_zero_is_b_y_bits_d3, unit_delta_both_d1_copy4;
    reg b_y_bits_is_255_d1, b_y_bits_is_255_d2, b_y_bits_is_255_d3;
    reg [14:0] b_y_bits_d1_copy2, b_y_bits_d2_copy2, b_y_bits_d3_copy2;
    reg [7:0] unit_delta_chosen_d1_copy4;
    reg b_y_sign_d1, b_y_sign_d2, b_y_sign_d3;
    reg [23:0] unit_delta_joined_d1_copy4, unit_delta_product_d1, minus_unit_delta_product_d1;
    reg [10:0] beta_bits_d1, beta_bits_d2, beta_bits_d3, a_exponent_plus_beta_bits_d1, alpha_bits_d1, alpha_bits_d2;
    reg [10:0] alpha_bits_d3, b_exponent_plus_alpha_bits_d1, m_exponent_d1, mx_sum_d1;
    reg not_zero_is_beta_bits_d1, not_zero_is_beta_bits_d2, not_zero_is_beta_bits_d3, mx_both_d1;
    reg beta_bits_is_255_d1;
    reg [7:0] mx_chosen_d1;
    reg [23:0] mx_joined_d1;
    reg [10:0] mx_sum_d1_copy2;
    reg not_zero_is_alpha_bits_d1, not_zero_is_alpha_bits_d2, not_zero_is_alpha_bits_d3, mx_both_d1_copy2;
    reg alpha_bits_is_255_d1;
    reg [7:0] mx_chosen_d1_copy2;
    reg [23:0] mx_joined_d1_copy2, minus_unit_delta_joined_d1;
    reg [10:0] largest_sum_d1, largest_sum_d2, largest_sum_d3, unit_delta_bits_d1, largest_greater_d1;
    reg [10:0] largest_greater_plus_154_d1, largest_greater_plus_154_d2;
    reg largest_sum_below_100_d1;
    reg [10:0] largest_sum_minus_100_d1, largest_chosen_d1, largest_greater_d1_copy2, largest_sum_plus_127_d1;
    reg [10:0] largest_chosen_d1_copy2, largest_greater_d1_copy3, largest_sum_d1_copy2, largest_sum_d2_copy2;
    reg [10:0] largest_sum_d3_copy2, largest_d1, a_x_bits_plus_381_d1;
    reg exponent_both_d1;
    reg [7:0] exponent_chosen_d1, phases_14;
    reg [23:0] exponent_joined_d1;
    reg [10:0] a_y_bits_plus_381_d1;
    reg exponent_both_d1_copy2;
    reg [22:0] exponent_joined_d1_copy2;
    reg [23:0] exponent_joined_d1_copy3;
    reg [10:0] b_x_bits_plus_381_d1;
    reg exponent_both_d1_copy3;
    reg [22:0] exponent_joined_d1_copy4;
    reg [10:0] b_y_bits_plus_381_d1;
    reg exponent_both_d1_copy4;
    reg [7:0] exponent_chosen_d1_copy2;
    reg [10:0] delta_sum_d1;
    reg not_zero_is_unit_delta_bits_d1, delta_both_d1, unit_delta_bits_is_255_d1;
    reg [14:0] unit_delta_bits_d1_copy2;
    reg [7:0] delta_chosen_d1;
    reg unit_delta_sign_d1;
    reg [23:0] delta_d1;
    reg [10:0] mx_sum_d1_copy3, mx_sum_d2, mx_sum_d3, mx_sum_bits_d1, mx_sum_plus_mx_sum_bits_d1;
    reg not_zero_is_mx_sum_bits_d1, mx_both_d1_copy3, mx_sum_bits_is_255_d1;
    reg [14:0] mx_sum_bits_d1_copy2;
    reg [7:0] mx_chosen_d1_copy3;
    reg mx_sum_sign_d1;
    reg [10:0] my_sum_bits_d1;
    reg my_in_order_d1, not_zero_is_my_sum_bits_d1, my_sum_bits_is_255_d1;
    reg [10:0] my_difference_d1;
    reg [14:0] my_sum_bits_d1_copy2;
    reg my_sum_sign_d1;
    reg [10:0] edge_on_lesser_d1;
    reg edge_on_lesser_below_32_d1, edge_on_lesser_below_32_d2, unit_delta_bits_is_zero_d1;
    reg [7:0] unit_delta_product_bits_d1;
    reg edge_on_in_order_d1;
    reg [23:0] first_sum_sum_d1, first_sum_sum_d2, first_sum_sum_d3, first_sum_sum_d1_copy2, first_sum_product_d1;
    reg [23:0] t_x_plus_t_y_d7, first_difference_sum_d1, root_of_first_sum_sum_d1, first_sum_sum_d1_copy3;
    reg [23:0] first_sum_chosen_d1;
    reg [26:0] first_sum_sum_d1_copy4;
    reg [23:0] last_sum_sum_d1, last_sum_chosen_d1;
    reg [26:0] last_sum_sum_d1_copy2;
    reg [23:0] first_difference_sum_d1_copy2, first_difference_chosen_d1;
    reg [26:0] first_difference_sum_d1_copy3;
    reg [23:0] last_difference_sum_d1, last_difference_chosen_d1;
    reg [26:0] last_difference_sum_d1_copy2;
    reg [21:0] center_x_fixed_d1;
    reg first_sum_both_d1;
    reg [26:0] first_sum_difference_d1, first_sum_shifted_d1, last_sum_sum_d1_copy3, last_sum_shifted_d1;
    reg [26:0] first_sum_greater_d1, last_sum_lesser_d1, first_difference_difference_d1, first_difference_shifted_d1;
    reg [26:0] first_difference_sum_d1_copy4, last_difference_sum_d1_copy3, last_difference_shifted_d1;
    reg [26:0] last_difference_sum_d1_copy4, first_difference_greater_d1, first_difference_d1;
    reg [26:0] last_difference_lesser_d1;
    reg first_sum_up_to_last_sum_d1, visible_in_order_d1;
    reg [9:0] first_sum_out_d1, last_sum_out_d1, last_difference_out_d1;
    reg before_far_and_occupied_x_d1, visible_both_d1, visible_both_d2, visible_both_d3, visible_both_d4;
    reg sight_negative_out_d1, visible_both_d1_copy2;
    reg [7:0] phases_15;
    reg [23:0] exponent_joined_d1_copy5, exponent_joined_d1_copy6, delta_times_one_over_b_depth_d1;
    reg end_or_visible_d1, placed_d1, placed_d2;
    reg [27:0] center_x_out_shifted_d1;
    reg [25:0] center_x_out_lesser_d1, center_x_out_d11, center_x_out_d12, center_x_out_d13, center_x_out_d14;
    reg [27:0] center_y_out_shifted_d1;
    reg [25:0] center_y_out_lesser_d1, center_y_out_d11, center_y_out_d12, center_y_out_d13, center_y_out_d14;
    reg [26:0] shift_shifted_d1, center_x_out_d1, shift_difference_d1, shift_shifted_d1_copy2;
    reg [26:0] shift_difference_d1_copy2;
    reg [25:0] shift_chosen_bits_d1;
    reg [26:0] not_shift_difference_d1, shift_shifted_d1_copy3, center_y_out_d1, shift_difference_d1_copy3;
    reg [26:0] shift_shifted_d1_copy4, shift_difference_d1_copy4;
    reg [25:0] shift_chosen_bits_d1_copy2, shift_either_d1;
    reg [26:0] not_shift_difference_d1_copy2;
    reg [10:0] shift_either_bits_d1;
    reg not_zero_is_shift_either_bits_d1;
    reg [9:0] shift_either_bits_d1_copy2;
    reg not_shift_either_bits_is_zero_d1;
    reg [8:0] shift_either_bits_d1_copy3;
    reg not_zero_is_shift_either_bits_d1_copy2;
    reg [3:0] shift_chosen_d1;
    reg [7:0] shift_either_bits_d1_copy4;
    reg not_shift_either_bits_is_zero_d1_copy2;
    reg [6:0] shift_either_bits_d1_copy5;
    reg not_shift_either_bits_is_zero_d1_copy3;
    reg [5:0] shift_either_bits_d1_copy6;
    reg not_shift_either_bits_is_zero_d1_copy4;
    reg [3:0] shift_chosen_d1_copy2;
    reg [4:0] shift_either_bits_d1_copy7;
    reg not_shift_either_bits_is_zero_d1_copy5;
    reg [3:0] shift_either_bits_d1_copy8;
    reg not_zero_is_shift_either_bits_d1_copy3, shift_either_bits_is_zero_d1;
    reg [3:0] shift_chosen_d1_copy3;
    reg shift_either_bits_is_zero_d1_copy2, shift_either_sign_is_zero_d1;
    reg [3:0] shift_d1, shift_d2, shift_d3;
    reg [9:0] shift_plus_4_d1, delta_bits_d1, delta_bits_d11, exponent_chosen_d1_copy3, exponent_chosen_bits_d10;
    reg [9:0] exponent_joined_bits_d1, exponent_chosen_bits_d10_copy2, exponent_joined_bits_d1_copy2;
    reg [7:0] phases_16;
    reg [9:0] mx_bits_d1, my_bits_d1, exponent_greater_d1, exponent_greater_d1_copy2, exponent_greater_d1_copy3;
    reg [9:0] exponent_greater_d1_copy4, exponent_greater_d1_copy5, exponent_d1, exponent_chosen_bits_plus_126_d1;
    reg zero_is_exponent_chosen_bits_d1, ax_out_both_d1;
    reg [23:0] ax_out_joined_d1;
    reg [17:0] ax_out_shifted_d1;
    reg [15:0] ax_out_lesser_d1;
    reg [9:0] exponent_joined_bits_plus_126_d1;
    reg bx_out_both_d1;
    reg [23:0] bx_out_joined_d1;
    reg [17:0] bx_out_shifted_d1;
    reg [15:0] bx_out_lesser_d1;
    reg [9:0] exponent_chosen_bits_plus_126_d1_copy2;
    reg zero_is_exponent_chosen_bits_d1_copy2, ay_out_both_d1;
    reg [23:0] ay_out_joined_d1;
    reg [17:0] ay_out_shifted_d1;
    reg [15:0] ay_out_lesser_d1;
    reg [9:0] exponent_joined_bits_plus_126_d1_copy2;
    reg by_out_both_d1;
    reg [23:0] by_out_joined_d1;
    reg [17:0] by_out_shifted_d1;
    reg [15:0] by_out_lesser_d1;
    reg [9:0] mx_bits_plus_126_d1;
    reg mx_out_both_d1;
    reg [23:0] mx_out_joined_d1;
    reg [17:0] mx_out_shifted_d1;
    reg [15:0] mx_out_lesser_d1;
    reg [9:0] my_bits_plus_126_d1;
    reg my_out_both_d1;
    reg [23:0] my_out_joined_d1;
    reg [17:0] my_out_shifted_d1;
    reg [15:0] my_out_lesser_d1;
    reg vanishes_in_order_d1;
    reg [9:0] vanishes_difference_d1;
    reg [23:0] vanishes_joined_d1;
    reg [21:0] vanishes_shifted_d1;
    reg [19:0] vanishes_lesser_d1;
    reg exponent_chosen_bits_is_255_d1, exponent_joined_bits_is_255_d1, exponent_chosen_bits_is_255_d1_copy2;
    reg odd_either_d1, mx_bits_is_255_d1, my_bits_is_255_d1, odd_d1, vanishes_d1, not_placed_d1;
    reg not_placed_d2, edge_on_or_not_placed_d1, edge_on_or_not_placed_d2, covers_nothing_d1;
    reg [10:0] sight_near_out_bits_d9, sight_near_out_bits_plus_126_d1;
    reg sight_near_out_in_order_d1, sight_near_out_bits_is_255_d1;
    reg [10:0] sight_near_out_sum_d1;
    reg sight_near_out_both_d1, not_sight_near_out_bits_is_255_d1;
    reg [10:0] sight_near_out_difference_d1;
    reg sight_near_out_either_d1;
    reg [22:0] sight_near_out_joined_d1;
    reg [19:0] sight_near_out_chosen_d1;
    reg [10:0] abs_sight_far_out_product_bits_d9, sight_far_out_sum_d1;
    reg sight_far_out_in_order_d1, sight_far_out_same_d1, sight_far_out_both_d1, not_sight_far_out_same_d1;
    reg [10:0] sight_far_out_difference_d1;
    reg sight_far_out_either_d1;
    reg [22:0] sight_far_out_joined_d1;
    reg [23:0] sight_far_out_joined_d1_copy2;
    reg [19:0] sight_far_out_d1;
    reg [23:0] middle_depth_minus_epsilon_d1, depth_low_out_greater_d1, depth_low_out_d1, depth_low_out_d2;
    reg [23:0] depth_low_out_d3, middle_depth_plus_epsilon_d1, depth_high_out_greater_d1, depth_high_out_d1;
    reg [23:0] depth_high_out_d2, depth_high_out_d3;
    reg [2:0] max_f24_ftz_unit_phase;
    reg [23:0] max_f24_ftz_unit_a;
    reg [2:0] max_f24_ftz_unit_phase_copy2;
    reg [23:0] max_f24_ftz_unit_b;
    reg [2:0] max_f24_ftz_unit_copy2_phase;
    reg [23:0] max_f24_ftz_unit_copy2_a;
    reg [2:0] max_f24_ftz_unit_copy2_phase_copy2;
    reg [23:0] max_f24_ftz_unit_copy2_b;
    reg [2:0] add_f24_ftz_unit_phase;
    reg [23:0] add_f24_ftz_unit_a;
    reg [2:0] add_f24_ftz_unit_phase_copy2;
    reg [23:0] add_f24_ftz_unit_b;
    reg [2:0] add_f24_ftz_unit_copy2_phase;
    reg [23:0] add_f24_ftz_unit_copy2_a;
    reg [2:0] add_f24_ftz_unit_copy2_phase_copy2;
    reg [23:0] add_f24_ftz_unit_copy2_b;
    reg [2:0] add_f24_ftz_unit_copy3_phase;
    reg [23:0] add_f24_ftz_unit_copy3_a;
    reg [2:0] add_f24_ftz_unit_copy3_phase_copy2;
    reg [23:0] add_f24_ftz_unit_copy3_b;
    reg [2:0] add_f24_ftz_unit_copy4_phase;
    reg [23:0] add_f24_ftz_unit_copy4_a;
    reg [2:0] add_f24_ftz_unit_copy4_phase_copy2;
    reg [23:0] add_f24_ftz_unit_copy4_b;
    reg [2:0] add_f24_ftz_unit_copy5_phase;
    reg [23:0] add_f24_ftz_unit_copy5_a;
    reg [2:0] add_f24_ftz_unit_copy5_phase_copy2;
    reg [23:0] add_f24_ftz_unit_copy5_b;
    reg [2:0] recip_f24_ftz_unit_phase;
    reg [23:0] recip_f24_ftz_unit_a;
    reg [2:0] mul_f24_ftz_unit_phase;
    reg [23:0] mul_f24_ftz_unit_a;
    reg [2:0] mul_f24_ftz_unit_phase_copy2;
    reg [23:0] mul_f24_ftz_unit_b;
    reg [2:0] mul_f24_ftz_unit_copy2_phase;
    reg [23:0] mul_f24_ftz_unit_copy2_a;
    reg [2:0] mul_f24_ftz_unit_copy2_phase_copy2;
    reg [23:0] mul_f24_ftz_unit_copy2_b;
    reg [2:0] mul_f24_ftz_unit_copy3_phase;
    reg [23:0] mul_f24_ftz_unit_copy3_a;
    reg [2:0] mul_f24_ftz_unit_copy3_phase_copy2;
    reg [23:0] mul_f24_ftz_unit_copy3_b;
    reg [2:0] mul_f24_ftz_unit_copy4_phase;
    reg [23:0] mul_f24_ftz_unit_copy4_a;
    reg [2:0] mul_f24_ftz_unit_copy4_phase_copy2;
    reg [23:0] mul_f24_ftz_unit_copy4_b;
    reg [2:0] mul_mul_add_f24_ftz_unit_phase;
    reg [23:0] mul_mul_add_f24_ftz_unit_a;
    reg [2:0] mul_mul_add_f24_ftz_unit_phase_copy2;
    reg [23:0] mul_mul_add_f24_ftz_unit_b;
    reg [2:0] mul_mul_add_f24_ftz_unit_phase_copy3;
    reg [23:0] mul_mul_add_f24_ftz_unit_c;
    reg [2:0] mul_mul_add_f24_ftz_unit_phase_copy4;
    reg [23:0] mul_mul_add_f24_ftz_unit_d;
    reg [2:0] mul_mul_add_f24_ftz_unit_copy2_phase;
    reg [23:0] mul_mul_add_f24_ftz_unit_copy2_a;
    reg [2:0] mul_mul_add_f24_ftz_unit_copy2_phase_copy2;
    reg [23:0] mul_mul_add_f24_ftz_unit_copy2_b;
    reg [2:0] mul_mul_add_f24_ftz_unit_copy2_phase_copy3;
    reg [23:0] mul_mul_add_f24_ftz_unit_copy2_c;
    reg [2:0] mul_mul_add_f24_ftz_unit_copy2_phase_copy4;
    reg [23:0] mul_mul_add_f24_ftz_unit_copy2_d;
    reg [2:0] sqrt_f24_ftz_unit_phase;
    reg [23:0] sqrt_f24_ftz_unit_a;
    reg [2:0] min_f24_ftz_unit_phase;
    reg [23:0] min_f24_ftz_unit_a;
    reg [2:0] min_f24_ftz_unit_phase_copy2;
    reg [23:0] min_f24_ftz_unit_b;
    reg [2:0] min_f24_ftz_unit_copy2_phase;
    reg [23:0] min_f24_ftz_unit_copy2_a, min_f24_ftz_unit_copy2_b;
    reg [2:0] to_fixed_f24_ftz_u21q8_unit_phase;
    reg [23:0] to_fixed_f24_ftz_u21q8_unit_a;
    reg [2:0] to_fixed_f24_ftz_u23q8_unit_phase;
    reg [23:0] to_fixed_f24_ftz_u23q8_unit_a;
    reg [2:0] to_fixed_f24_ftz_s22q8_unit_phase;
    reg [23:0] to_fixed_f24_ftz_s22q8_unit_a;
    reg [2:0] to_fixed_f24_ftz_s27q13_unit_phase;
    reg [23:0] to_fixed_f24_ftz_s27q13_unit_a;
    reg [2:0] to_fixed_f24_ftz_s17q16_unit_phase;
    reg [23:0] to_fixed_f24_ftz_s17q16_unit_a;
    reg [2:0] to_fixed_f24_ftz_u20q19_unit_phase;
    reg [23:0] to_fixed_f24_ftz_u20q19_unit_a;
    reg [2:0] to_fixed_f24_ftz_u24q24_unit_phase;
    reg [23:0] to_fixed_f24_ftz_u24q24_unit_a;
    reg [21:0] in_flight;
    reg left, dropped;

    wire [23:0] max_f24_ftz_unit_y, max_f24_ftz_unit_copy2_y;
    wire lt_f24_ftz_unit_y, lt_f24_ftz_unit_copy2_y, lt_f24_ftz_unit_copy3_y, lt_f24_ftz_unit_copy4_y;
    wire lt_f24_ftz_unit_copy5_y, lt_f24_ftz_unit_copy6_y, lt_f24_ftz_unit_copy7_y, lt_f24_ftz_unit_copy8_y;
    wire lt_f24_ftz_unit_copy9_y;
    wire [23:0] add_f24_ftz_unit_y, add_f24_ftz_unit_copy2_y, add_f24_ftz_unit_copy3_y, add_f24_ftz_unit_copy4_y;
    wire [23:0] add_f24_ftz_unit_copy5_y, recip_f24_ftz_unit_y, mul_f24_ftz_unit_y, mul_f24_ftz_unit_copy2_y;
    wire [23:0] mul_f24_ftz_unit_copy3_y, mul_f24_ftz_unit_copy4_y, mul_mul_add_f24_ftz_unit_y;
    wire [23:0] mul_mul_add_f24_ftz_unit_copy2_y, sqrt_f24_ftz_unit_y;
    wire le_f24_ftz_unit_y, le_f24_ftz_unit_copy2_y, le_f24_ftz_unit_copy3_y, le_f24_ftz_unit_copy4_y;
    wire [23:0] min_f24_ftz_unit_y, min_f24_ftz_unit_copy2_y;
    wire [20:0] to_fixed_f24_ftz_u21q8_unit_y;
    wire [22:0] to_fixed_f24_ftz_u23q8_unit_y;
    wire [21:0] to_fixed_f24_ftz_s22q8_unit_y;
    wire [26:0] to_fixed_f24_ftz_s27q13_unit_y;
    wire [16:0] to_fixed_f24_ftz_s17q16_unit_y;
    wire [20:0] to_fixed_f24_ftz_s21q20_unit_y;
    wire [19:0] to_fixed_f24_ftz_u20q19_unit_y;
    wire [23:0] to_fixed_f24_ftz_u24q24_unit_y;
    wire queue_1_in_ready;
    wire [116:0] queue_1_out_data;
    wire queue_2_in_ready, queue_2_out_valid;
    wire [122:0] queue_2_out_data;
    wire queue_3_in_ready, queue_3_out_valid;
    wire [119:0] queue_3_out_data;
    wire queue_4_in_ready, queue_4_out_valid;
    wire [39:0] queue_4_out_data;

    assign in_ready = ~credits[5] & phases_1[0];
    wire [23:0] lt_f24_ftz_unit_copy2_a_bits = {1'd0, in_tangent1_z[22:0]};
    wire [23:0] lt_f24_ftz_unit_copy2_b_bits = {1'd0, in_tangent2_z[22:0]};
    wire in_flight_21_and_phases_4_3 = in_flight[21] & phases_4[3];
    wire kept = in_flight_21_and_phases_4_3 & end_or_visible_d1;
    wire [15:0] ax_out = covers_nothing_d1 ? 16'd0 : ax_out_lesser_d1;
    wire [15:0] bx_out = covers_nothing_d1 ? 16'd0 : bx_out_lesser_d1;
    wire [15:0] ay_out = covers_nothing_d1 ? 16'd0 : ay_out_lesser_d1;
    wire [15:0] by_out = covers_nothing_d1 ? 16'd0 : by_out_lesser_d1;
    wire [19:0] delta_out = covers_nothing_d1 ? 20'd0 : vanishes_lesser_d1;
    wire [15:0] mx_out = covers_nothing_d1 ? 16'd0 : mx_out_lesser_d1;
    wire [15:0] my_out = covers_nothing_d1 ? 16'd0 : my_out_lesser_d1;
    wire [19:0] sight_near_out = covers_nothing_d1 ? 20'd0 : sight_near_out_chosen_d1;
    wire turned_d21 = delay_11_from_5_out[0];
    wire [11:0] attribute_0_d22 = delay_22_from_0_out[11:0];
    wire [11:0] attribute_1_d22 = delay_22_from_0_out[23:12];
    wire [11:0] attribute_2_d22 = delay_22_from_0_out[35:24];
    wire [8:0] first_x_d5 = delay_5_from_6_out[32:24];
    wire in_valid_and_in_ready = in_valid & in_ready;
    wire [10:0] first_x_greater_bits_d1_bits = {3'd0, max_f24_ftz_unit_y[22:15]};
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
    wire [14:0] first_x_chosen_copy3 = first_x_both_d1 ? 15'd0 : first_x_greater_bits_d1_copy2;
    wire [22:0] first_x_chosen_copy4 = first_x_either_d1 ? {first_x_chosen_copy2[7:0], first_x_chosen_copy3} : 23'd0;
    wire [10:0] first_y_greater_bits_plus_1 = first_x_greater_bits_plus_1;
    wire first_y_in_order = 11'd0 < first_y_greater_bits_plus_1;
    wire zero_is_first_y_greater_bits = zero_is_first_x_greater_bits;
    wire first_y_inverted = ~zero_is_first_y_greater_bits;
    wire first_y_greater_bits_is_255 = 11'd255 == first_x_greater_bits_d1_bits;
    wire first_y_in_order_copy2 = ~(first_y_greater_bits_plus_1 < 11'd255);
    wire first_y_both = first_y_in_order_d1 & first_y_inverted_d1;
    wire first_y_both_copy2 = first_y_both & first_y_in_order_d1_copy2;
    wire first_y_inverted_copy2 = ~first_y_greater_bits_is_255_d1;
    wire first_y_both_copy3 = first_y_both_copy2 & first_y_inverted_copy2;
    wire first_y_either = first_y_both | first_y_greater_bits_is_255_d1;
    wire [10:0] first_y_chosen = first_y_both_d1 ? 11'd255 : first_y_greater_bits_plus_1_d1;
    wire [10:0] first_y_chosen_copy2 = first_y_greater_bits_is_255_d1 ? first_y_greater_bits_d1 : first_y_chosen;
    wire [14:0] first_y_chosen_copy3 = first_y_both_d1 ? 15'd0 : first_y_greater_bits_d1_copy2;
    wire [22:0] first_y_chosen_copy4 = first_y_either_d1 ? {first_y_chosen_copy2[7:0], first_y_chosen_copy3} : 23'd0;
    wire [10:0] reaches_near_greater_bits_d1_bits = {3'd0, max_f24_ftz_unit_copy2_y[22:15]};
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
    wire [14:0] reaches_near_chosen_copy3 = reaches_near_both_d1 ? 15'd0 : reaches_near_greater_bits_d1_copy2;
    wire [22:0] reaches_near_chosen_copy4 = reaches_near_either_d1 ? {reaches_near_chosen_copy2[7:0], reaches_near_chosen_copy3} : 23'd0;
    wire [10:0] turned_greater_bits = {3'd0, in_center_x[22:15]};
    wire [10:0] turned_greater_bits_2 = {3'd0, in_center_y[22:15]};
    wire [10:0] turned_greater = (turned_greater_bits < turned_greater_bits_2) ? turned_greater_bits_2 : turned_greater_bits;
    wire [10:0] center_z_bits_plus_4 = {3'd0, in_center_z[22:15]} + 11'd4;
    wire turned_in_order = center_z_bits_plus_4_d1 < turned_greater_d1;
    wire not_beyond_near = ~lt_f24_ftz_unit_y;
    wire turned_either = turned_in_order | not_beyond_near;
    wire turned = lt_f24_ftz_unit_copy3_y & turned_either_d1;
    wire [23:0] v_x_chosen = swapped_d1 ? tangent2_x_d1 : tangent1_x_d1;
    wire [23:0] v_x_chosen_copy2 = turned ? v_x_chosen : center_x_d1;
    wire [23:0] v_y_chosen = swapped_d1 ? tangent2_y_d1 : tangent1_y_d1;
    wire [23:0] v_y_chosen_copy2 = turned ? v_y_chosen : center_y_d1;
    wire [23:0] lowered_chosen = swapped_d1 ? tangent2_z_d1 : tangent1_z_d1;
    wire [23:0] lowered_chosen_copy5 = turned ? lowered_chosen : center_z_d1;
    wire [23:0] lowered_chosen_copy2 = swapped_d1 ? tangent1_x_d1 : tangent2_x_d1;
    wire [23:0] lowered_chosen_copy6 = turned ? lowered_chosen_copy2 : tangent1_x_d1;
    wire [23:0] lowered_chosen_copy3 = swapped_d1 ? tangent1_y_d1 : tangent2_y_d1;
    wire [23:0] lowered_chosen_copy7 = turned ? lowered_chosen_copy3 : tangent1_y_d1;
    wire [10:0] lowered_greater = (lowered_chosen_bits_d1 < lowered_chosen_bits_d1_copy2) ? lowered_chosen_bits_d1_copy2 : lowered_chosen_bits_d1;
    wire [23:0] lowered_chosen_copy4 = swapped_d1 ? tangent1_z_d1 : tangent2_z_d1;
    wire [23:0] lowered_chosen_copy8 = turned ? lowered_chosen_copy4 : tangent1_z_d1;
    wire [10:0] lowered_greater_copy2 = (lowered_greater_d1 < lowered_chosen_bits_d1_copy3) ? lowered_chosen_bits_d1_copy3 : lowered_greater_d1;
    wire [23:0] lowered_chosen_copy9 = turned ? center_x_d1 : tangent2_x_d1;
    wire [10:0] lowered_greater_copy3 = (lowered_greater_d1_copy2 < lowered_chosen_bits_d1_copy4) ? lowered_chosen_bits_d1_copy4 : lowered_greater_d1_copy2;
    wire [23:0] lowered_chosen_copy10 = turned ? center_y_d1 : tangent2_y_d1;
    wire [10:0] lowered_greater_copy4 = (lowered_greater_d1_copy3 < lowered_chosen_bits_d1_copy5) ? lowered_chosen_bits_d1_copy5 : lowered_greater_d1_copy3;
    wire [23:0] lowered_chosen_copy11 = turned ? center_z_d1 : tangent2_z_d1;
    wire [10:0] lowered_greater_copy5 = (lowered_greater_d1_copy4 < lowered_chosen_bits_d1_copy6) ? lowered_chosen_bits_d1_copy6 : lowered_greater_d1_copy4;
    wire [10:0] lowered_chosen_bits_plus_60 = {3'd0, lowered_chosen_d1[22:15]} + 11'd60;
    wire lowered_in_order = lowered_greater_d1_copy5 < lowered_chosen_bits_plus_60_d1;
    wire [10:0] lowered_difference = lowered_greater_d1_copy5 - lowered_chosen_bits_plus_60_d1;
    wire [10:0] lowered = lowered_in_order ? 11'd0 : lowered_difference;
    wire zero_is_lowered_chosen_bits = 11'd0 == lowered_chosen_bits_d1;
    wire a_x_inverted = ~zero_is_lowered_chosen_bits;
    wire a_x_in_order = lowered_d1 < lowered_chosen_bits_d1;
    wire a_x_in_order_and_a_x_inverted = a_x_in_order & a_x_inverted_d1;
    wire lowered_chosen_bits_is_255 = 11'd255 == lowered_chosen_bits_d1;
    wire [10:0] a_x_difference = lowered_chosen_bits_d1 - lowered_d1;
    wire [10:0] a_x_chosen = lowered_chosen_bits_is_255_d1 ? lowered_chosen_bits_d1 : a_x_difference;
    wire a_x_either = a_x_in_order_and_a_x_inverted_d1 | lowered_chosen_bits_is_255_d1;
    wire [22:0] a_x_chosen_copy2 = a_x_either ? {a_x_chosen_d1, lowered_chosen_bits_d1_copy7} : 23'd0;
    wire zero_is_lowered_chosen_bits_copy2 = 11'd0 == lowered_chosen_bits_d1_copy2;
    wire a_y_inverted = ~zero_is_lowered_chosen_bits_copy2;
    wire a_y_in_order = lowered_d1 < lowered_chosen_bits_d1_copy2;
    wire a_y_in_order_and_a_y_inverted = a_y_in_order & a_y_inverted_d1;
    wire lowered_chosen_bits_is_255_copy2 = 11'd255 == lowered_chosen_bits_d1_copy2;
    wire [10:0] a_y_difference = lowered_chosen_bits_d1_copy2 - lowered_d1;
    wire [10:0] a_y_chosen = lowered_chosen_bits_is_255_d1_copy2 ? lowered_chosen_bits_d1_copy2 : a_y_difference;
    wire a_y_either = a_y_in_order_and_a_y_inverted_d1 | lowered_chosen_bits_is_255_d1_copy2;
    wire [22:0] a_y_chosen_copy2 = a_y_either ? {a_y_chosen_d1, lowered_chosen_bits_d1_copy8} : 23'd0;
    wire zero_is_lowered_chosen_bits_copy3 = 11'd0 == lowered_chosen_bits_d1_copy3;
    wire alpha_inverted = ~zero_is_lowered_chosen_bits_copy3;
    wire alpha_in_order = lowered_d1 < lowered_chosen_bits_d1_copy3;
    wire alpha_both = alpha_in_order & alpha_inverted_d1;
    wire lowered_chosen_bits_is_255_copy3 = 11'd255 == lowered_chosen_bits_d1_copy3;
    wire [10:0] alpha_difference = lowered_chosen_bits_d1_copy3 - lowered_d1;
    wire [10:0] alpha_chosen = lowered_chosen_bits_is_255_d1_copy3 ? lowered_chosen_bits_d1_copy3 : alpha_difference;
    wire alpha_either = alpha_both_d1 | lowered_chosen_bits_is_255_d1_copy3;
    wire [22:0] alpha_chosen_copy2 = alpha_either ? {alpha_chosen_d1, lowered_chosen_bits_d1_copy9} : 23'd0;
    wire zero_is_lowered_chosen_bits_copy4 = 11'd0 == lowered_chosen_bits_d1_copy4;
    wire b_x_inverted = ~zero_is_lowered_chosen_bits_copy4;
    wire b_x_in_order = lowered_d1 < lowered_chosen_bits_d1_copy4;
    wire b_x_in_order_and_b_x_inverted = b_x_in_order & b_x_inverted_d1;
    wire lowered_chosen_bits_is_255_copy4 = 11'd255 == lowered_chosen_bits_d1_copy4;
    wire [10:0] b_x_difference = lowered_chosen_bits_d1_copy4 - lowered_d1;
    wire [10:0] b_x_chosen = lowered_chosen_bits_is_255_d1_copy4 ? lowered_chosen_bits_d1_copy4 : b_x_difference;
    wire b_x_either = b_x_in_order_and_b_x_inverted_d1 | lowered_chosen_bits_is_255_d1_copy4;
    wire [22:0] b_x_chosen_copy2 = b_x_either ? {b_x_chosen_d1, lowered_chosen_bits_d1_copy10} : 23'd0;
    wire zero_is_lowered_chosen_bits_copy5 = 11'd0 == lowered_chosen_bits_d1_copy5;
    wire b_y_inverted = ~zero_is_lowered_chosen_bits_copy5;
    wire b_y_in_order = lowered_d1 < lowered_chosen_bits_d1_copy5;
    wire b_y_in_order_and_b_y_inverted = b_y_in_order & b_y_inverted_d1;
    wire lowered_chosen_bits_is_255_copy5 = 11'd255 == lowered_chosen_bits_d1_copy5;
    wire [10:0] b_y_difference = lowered_chosen_bits_d1_copy5 - lowered_d1;
    wire [10:0] b_y_chosen = lowered_chosen_bits_is_255_d1_copy5 ? lowered_chosen_bits_d1_copy5 : b_y_difference;
    wire b_y_either = b_y_in_order_and_b_y_inverted_d1 | lowered_chosen_bits_is_255_d1_copy5;
    wire [22:0] b_y_chosen_copy2 = b_y_either ? {b_y_chosen_d1, lowered_chosen_bits_d1_copy11} : 23'd0;
    wire zero_is_lowered_chosen_bits_copy6 = 11'd0 == lowered_chosen_bits_d1_copy6;
    wire beta_inverted = ~zero_is_lowered_chosen_bits_copy6;
    wire beta_in_order = lowered_d1 < lowered_chosen_bits_d1_copy6;
    wire beta_both = beta_in_order & beta_inverted_d1;
    wire lowered_chosen_bits_is_255_copy6 = 11'd255 == lowered_chosen_bits_d1_copy6;
    wire [10:0] beta_difference = lowered_chosen_bits_d1_copy6 - lowered_d1;
    wire [10:0] beta_chosen = lowered_chosen_bits_is_255_d1_copy6 ? lowered_chosen_bits_d1_copy6 : beta_difference;
    wire beta_either = beta_both_d1 | lowered_chosen_bits_is_255_d1_copy6;
    wire [22:0] beta_chosen_copy2 = beta_either ? {beta_chosen_d1, lowered_chosen_bits_d1_copy12} : 23'd0;
    wire not_turned = ~turned_d1;
    wire beyond_near_and_not_turned = beyond_near_d2 & not_turned_d1;
    wire zero_is_lowered = 11'd0 == lowered_d5;
    wire not_turned_and_whole_in_order = not_turned_d6 & lt_f24_ftz_unit_copy5_y;
    wire whole = not_turned_and_whole_in_order & zero_is_lowered_d1;
    wire beyond_near = delay_6_from_6_out & le_f24_ftz_unit_y;
    wire before_far_in_order = mul_f24_ftz_unit_y[22:0] < 23'd16;
    wire [22:0] before_far_difference = mul_f24_ftz_unit_y[22:0] - 23'd16;
    wire [22:0] before_far_chosen = before_far_in_order ? 23'd0 : before_far_difference;
    wire [23:0] middle_depth_chosen = delay_8_from_4_out ? center_depth_d9 : 24'd0;
    wire [23:0] middle_depth = beyond_near_d1_copy2 ? spread_middle_d2 : middle_depth_chosen;
    wire [23:0] half_depth_chosen_d9 = delay_9_from_5_out[24:1];
    wire [23:0] half_depth = beyond_near ? spread_half_d2 : half_depth_chosen_d9;
    wire [23:0] center_x_d5 = delay_5_from_6_out[23:0];
    wire [23:0] minus_sqrt_f24_ftz_unit_y = {~sqrt_f24_ftz_unit_y[23], sqrt_f24_ftz_unit_y[22:0]};
    wire first_x_product_bits_below_16 = before_far_in_order;
    wire [22:0] first_x_product_bits_minus_16 = before_far_difference;
    wire [22:0] first_x_chosen_copy6 = first_x_product_bits_below_16 ? 23'd0 : first_x_product_bits_minus_16;
    wire first_x_chosen_d11 = delay_11_from_7_out[0];
    wire [23:0] first_x_chosen_copy8 = first_x_chosen_d11 ? add_f24_ftz_unit_copy3_y : 24'd0;
    wire last_x_chosen_d11 = delay_11_from_7_out[1];
    wire [23:0] last_x_chosen_copy2 = last_x_chosen_d11 ? add_f24_ftz_unit_copy3_y : 24'h45fff8;
    wire [23:0] first_x_chosen_copy9 = whole_d9 ? add_f24_ftz_unit_y : first_x_chosen_d3;
    wire [23:0] last_x_chosen_copy3 = whole_d9 ? add_f24_ftz_unit_copy3_y : last_x_chosen_d3;
    wire [23:0] first_x_chosen_copy10 = delay_11_from_3_out ? min_f24_ftz_unit_y : first_x_chosen_d1_copy2;
    wire [23:0] last_x_chosen_copy4 = delay_11_from_3_out ? max_f24_ftz_unit_y : last_x_chosen_d1_copy2;
    wire [21:0] first_x_greater_fixed_plus_126 = {1'd0, to_fixed_f24_ftz_u21q8_unit_y} + 22'd126;
    wire [21:0] first_x_shifted_d1_shifted = first_x_greater_fixed_plus_126 >> 8;
    wire [21:0] last_x_greater_fixed_plus_130 = {1'd0, to_fixed_f24_ftz_u21q8_unit_y} + 22'd130;
    wire [21:0] last_x_lesser = (22'd512 < last_x_shifted_d1) ? 22'd512 : last_x_shifted_d1;
    wire [21:0] last_x_lesser_minus_1 = last_x_lesser_d1 - 22'd1;
    wire [8:0] last_x = last_x_lesser_minus_1[8:0];
    wire [23:0] center_y_d6 = delay_5_from_6_out[56:33];
    wire first_y_product_bits_below_16 = before_far_in_order;
    wire [22:0] first_y_product_bits_minus_16 = before_far_difference;
    wire [22:0] first_y_chosen_copy6 = first_y_product_bits_below_16 ? 23'd0 : first_y_product_bits_minus_16;
    wire first_y_chosen_d11 = delay_11_from_1_out[0];
    wire [23:0] first_y_chosen_copy8 = first_y_chosen_d11 ? add_f24_ftz_unit_copy5_y : 24'd0;
    wire last_y_chosen_d11 = delay_11_from_1_out[1];
    wire [23:0] last_y_chosen_copy2 = last_y_chosen_d11 ? add_f24_ftz_unit_copy5_y : 24'h45fff8;
    wire [23:0] first_y_chosen_copy9 = whole_d9 ? add_f24_ftz_unit_copy4_y : first_y_chosen_d3;
    wire [23:0] last_y_chosen_copy3 = whole_d9 ? add_f24_ftz_unit_copy5_y : last_y_chosen_d3;
    wire [23:0] first_y_chosen_copy10 = delay_11_from_3_out ? min_f24_ftz_unit_y : first_y_chosen_d1_copy2;
    wire [23:0] last_y_chosen_copy4 = delay_11_from_3_out ? max_f24_ftz_unit_y : last_y_chosen_d1_copy2;
    wire [21:0] first_y_greater_fixed_plus_126 = 22'd126 + {1'd0, to_fixed_f24_ftz_u21q8_unit_y};
    wire [21:0] first_y_shifted_d1_shifted = first_y_greater_fixed_plus_126 >> 8;
    wire [21:0] last_y_greater_fixed_plus_130 = 22'd130 + {1'd0, to_fixed_f24_ftz_u21q8_unit_y};
    wire [21:0] last_y_lesser = (last_y_shifted_d1 < 22'd512) ? last_y_shifted_d1 : 22'd512;
    wire [21:0] last_y_lesser_minus_1 = last_y_lesser_d1 - 22'd1;
    wire [8:0] last_y = last_y_lesser_minus_1[8:0];
    wire [10:0] a_x_bits_d1_bits = {3'd0, mul_f24_ftz_unit_copy3_y[22:15]};
    wire [10:0] a_y_bits_d1_bits = {3'd0, mul_f24_ftz_unit_copy2_y[22:15]};
    wire [10:0] a_exponent = (a_x_bits_d1 < a_y_bits_d1_bits) ? a_y_bits_d1_bits : a_x_bits_d1;
    wire [10:0] b_exponent = (b_x_bits_d1 < a_y_bits_d1_bits) ? a_y_bits_d1_bits : b_x_bits_d1;
    wire [10:0] a_x_bits_plus_127 = 11'd127 + a_x_bits_d1_bits;
    wire zero_is_a_x_bits = 11'd0 == a_x_bits_d1_bits;
    wire not_zero_is_a_x_bits = ~zero_is_a_x_bits;
    wire unit_delta_in_order = a_exponent_d1 < a_x_bits_plus_127_d1;
    wire unit_delta_both = unit_delta_in_order & not_zero_is_a_x_bits_d1;
    wire a_x_bits_is_255 = 11'd255 == a_x_bits_d1;
    wire [10:0] unit_delta_difference = a_x_bits_plus_127_d1 - a_exponent_d1;
    wire [10:0] unit_delta_chosen = a_x_bits_is_255 ? a_x_bits_d1 : unit_delta_difference;
    wire unit_delta_either = unit_delta_both_d1 | a_x_bits_is_255_d1;
    wire [22:0] unit_delta_chosen_copy2 = unit_delta_either ? {unit_delta_chosen_d1, a_x_bits_d1_copy2} : 23'd0;
    wire [10:0] a_y_bits_plus_127 = 11'd127 + a_y_bits_d1_bits;
    wire zero_is_a_y_bits = 11'd0 == a_y_bits_d1_bits;
    wire not_zero_is_a_y_bits = ~zero_is_a_y_bits;
    wire unit_delta_in_order_copy2 = a_exponent_d1 < a_y_bits_plus_127_d1;
    wire unit_delta_both_copy2 = unit_delta_in_order_copy2 & not_zero_is_a_y_bits_d1;
    wire a_y_bits_is_255 = 11'd255 == a_y_bits_d1;
    wire [10:0] unit_delta_difference_copy2 = a_y_bits_plus_127_d1 - a_exponent_d1;
    wire [10:0] unit_delta_chosen_copy3 = a_y_bits_is_255 ? a_y_bits_d1 : unit_delta_difference_copy2;
    wire unit_delta_either_copy2 = unit_delta_both_d1_copy2 | a_y_bits_is_255_d1;
    wire [22:0] unit_delta_chosen_copy4 = unit_delta_either_copy2 ? {unit_delta_chosen_d1_copy2, a_y_bits_d1_copy2} : 23'd0;
    wire [10:0] b_x_bits_plus_127 = a_x_bits_plus_127;
    wire zero_is_b_x_bits = zero_is_a_x_bits;
    wire not_zero_is_b_x_bits = ~zero_is_b_x_bits;
    wire unit_delta_in_order_copy3 = b_exponent_d1 < b_x_bits_plus_127_d1;
    wire unit_delta_both_copy3 = unit_delta_in_order_copy3 & not_zero_is_b_x_bits_d1;
    wire b_x_bits_is_255 = 11'd255 == b_x_bits_d1;
    wire [10:0] unit_delta_difference_copy3 = b_x_bits_plus_127_d1 - b_exponent_d1;
    wire [10:0] unit_delta_chosen_copy5 = b_x_bits_is_255_d1 ? b_x_bits_d1 : unit_delta_difference_copy3;
    wire unit_delta_either_copy3 = unit_delta_both_d1_copy3 | b_x_bits_is_255_d1;
    wire [22:0] unit_delta_chosen_copy6 = unit_delta_either_copy3 ? {unit_delta_chosen_d1_copy3, b_x_bits_d1_copy2} : 23'd0;
    wire [10:0] b_y_bits_plus_127 = a_y_bits_plus_127;
    wire zero_is_b_y_bits = zero_is_a_y_bits;
    wire not_zero_is_b_y_bits = ~zero_is_b_y_bits;
    wire unit_delta_in_order_copy4 = b_exponent_d1 < b_y_bits_plus_127_d1;
    wire unit_delta_both_copy4 = unit_delta_in_order_copy4 & not_zero_is_b_y_bits_d1;
    wire b_y_bits_is_255 = 11'd255 == a_y_bits_d1_bits;
    wire [10:0] unit_delta_difference_copy4 = b_y_bits_plus_127_d1 - b_exponent_d1;
    wire [10:0] unit_delta_chosen_copy7 = b_y_bits_is_255_d1 ? b_y_bits_d1 : unit_delta_difference_copy4;
    wire unit_delta_either_copy4 = unit_delta_both_d1_copy4 | b_y_bits_is_255_d1;
    wire [22:0] unit_delta_chosen_copy8 = unit_delta_either_copy4 ? {unit_delta_chosen_d1_copy4, b_y_bits_d1_copy2} : 23'd0;
    wire [10:0] a_exponent_plus_beta_bits = a_exponent_d1 + beta_bits_d3;
    wire [10:0] alpha_bits_d1_bits = {3'd0, mul_f24_ftz_unit_y[22:15]};
    wire [10:0] b_exponent_plus_alpha_bits = b_exponent_d1 + alpha_bits_d3;
    wire [10:0] m_exponent = (a_exponent_plus_beta_bits_d1 < b_exponent_plus_alpha_bits_d1) ? b_exponent_plus_alpha_bits_d1 : a_exponent_plus_beta_bits_d1;
    wire [10:0] a_exponent_plus_127 = 11'd127 + a_exponent_d1;
    wire [10:0] mx_sum = beta_bits_d3 + a_exponent_plus_127;
    wire zero_is_beta_bits = zero_is_a_y_bits;
    wire not_zero_is_beta_bits = ~zero_is_beta_bits;
    wire m_exponent_below_mx_sum = m_exponent_d1 < mx_sum_d1;
    wire mx_both = m_exponent_below_mx_sum & not_zero_is_beta_bits_d3;
    wire beta_bits_is_255 = 11'd255 == beta_bits_d2;
    wire [10:0] mx_sum_minus_m_exponent = mx_sum_d1 - m_exponent_d1;
    wire [10:0] mx_chosen = beta_bits_is_255_d1 ? beta_bits_d3 : mx_sum_minus_m_exponent;
    wire mx_both_or_beta_bits_is_255 = mx_both_d1 | beta_bits_is_255_d1;
    wire [22:0] mx_chosen_copy2 = mx_both_or_beta_bits_is_255 ? {mx_chosen_d1, beta_d3[14:0]} : 23'd0;
    wire [10:0] b_exponent_plus_127 = 11'd127 + b_exponent_d1;
    wire [10:0] mx_sum_copy2 = alpha_bits_d3 + b_exponent_plus_127;
    wire zero_is_alpha_bits = 11'd0 == alpha_bits_d1_bits;
    wire not_zero_is_alpha_bits = ~zero_is_alpha_bits;
    wire m_exponent_below_mx_sum_copy2 = m_exponent_d1 < mx_sum_d1_copy2;
    wire mx_both_copy2 = m_exponent_below_mx_sum_copy2 & not_zero_is_alpha_bits_d3;
    wire alpha_bits_is_255 = 11'd255 == alpha_bits_d2;
    wire [10:0] mx_sum_minus_m_exponent_copy2 = mx_sum_d1_copy2 - m_exponent_d1;
    wire [10:0] mx_chosen_copy3 = alpha_bits_is_255_d1 ? alpha_bits_d3 : mx_sum_minus_m_exponent_copy2;
    wire mx_both_or_alpha_bits_is_255 = mx_both_d1_copy2 | alpha_bits_is_255_d1;
    wire [22:0] mx_chosen_copy4 = mx_both_or_alpha_bits_is_255 ? {mx_chosen_d1_copy2, alpha_d3[14:0]} : 23'd0;
    wire [10:0] a_exponent_plus_b_exponent = a_exponent_d1 + b_exponent_d1;
    wire [10:0] largest_sum = lowered_d6 + a_exponent_plus_b_exponent;
    wire [10:0] unit_delta_bits_d1_bits = {3'd0, add_f24_ftz_unit_copy5_y[22:15]};
    wire [10:0] largest_greater = (a_exponent_d1 < b_exponent_d1) ? b_exponent_d1 : a_exponent_d1;
    wire [10:0] largest_greater_plus_154 = largest_greater_d1 + 11'd154;
    wire [10:0] largest_sum_copy2 = largest_sum_d3 + unit_delta_bits_d1_bits;
    wire largest_sum_below_100 = largest_sum_copy2 < 11'd100;
    wire [10:0] largest_sum_minus_100 = largest_sum_copy2 - 11'd100;
    wire [10:0] largest_chosen = largest_sum_below_100_d1 ? 11'd0 : largest_sum_minus_100_d1;
    wire [10:0] largest_greater_copy2 = (largest_greater_plus_154_d2 < largest_chosen_d1) ? largest_chosen_d1 : largest_greater_plus_154_d2;
    wire [10:0] largest_sum_plus_127 = 11'd127 + largest_sum_copy2;
    wire [10:0] largest_in_order_bits = {3'd0, b_depth_d5[22:15]};
    wire largest_in_order = largest_sum_plus_127_d1 < largest_in_order_bits;
    wire [10:0] largest_difference = largest_sum_plus_127_d1 - largest_in_order_bits;
    wire [10:0] largest_chosen_copy2 = largest_in_order ? 11'd0 : largest_difference;
    wire [10:0] largest_greater_copy3 = (largest_greater_d1_copy2 < largest_chosen_d1_copy2) ? largest_chosen_d1_copy2 : largest_greater_d1_copy2;
    wire [10:0] lowered_plus_m_exponent = lowered_d6 + m_exponent_d1;
    wire [10:0] largest_sum_copy3 = lowered_plus_m_exponent + 11'd27;
    wire [10:0] largest = (largest_greater_d1_copy3 < largest_sum_d3_copy2) ? largest_sum_d3_copy2 : largest_greater_d1_copy3;
    wire [10:0] a_x_bits_plus_381 = a_x_bits_d3 + 11'd381;
    wire exponent_in_order = largest_d1 < a_x_bits_plus_381_d1;
    wire exponent_both = not_zero_is_a_x_bits_d4 & exponent_in_order;
    wire [10:0] exponent_difference = a_x_bits_plus_381_d1 - largest_d1;
    wire [10:0] exponent_chosen = a_x_bits_is_255_d3 ? a_x_bits_d4 : exponent_difference;
    wire exponent_either = a_x_bits_is_255_d3 | exponent_both_d1;
    wire [22:0] exponent_chosen_copy2 = exponent_either ? {exponent_chosen_d1, a_x_bits_d3_copy2} : 23'd0;
    wire [10:0] a_y_bits_plus_381 = a_y_bits_d2 + 11'd381;
    wire exponent_in_order_copy2 = largest_d1 < a_y_bits_plus_381_d1;
    wire exponent_both_copy2 = not_zero_is_a_y_bits_d3 & exponent_in_order_copy2;
    wire [10:0] exponent_difference_copy2 = a_y_bits_plus_381_d1 - largest_d1;
    wire [10:0] exponent_chosen_copy3 = a_y_bits_is_255_d3 ? a_y_bits_d3 : exponent_difference_copy2;
    wire exponent_either_copy2 = a_y_bits_is_255_d3 | exponent_both_d1_copy2;
    wire [22:0] exponent_chosen_copy4 = exponent_either_copy2 ? exponent_joined_d1_copy2 : 23'd0;
    wire [10:0] b_x_bits_plus_381 = b_x_bits_d2 + 11'd381;
    wire exponent_in_order_copy3 = largest_d1 < b_x_bits_plus_381_d1;
    wire exponent_both_copy3 = not_zero_is_b_x_bits_d3 & exponent_in_order_copy3;
    wire [10:0] exponent_difference_copy3 = b_x_bits_plus_381_d1 - largest_d1;
    wire [10:0] exponent_chosen_copy5 = b_x_bits_is_255_d3 ? b_x_bits_d3 : exponent_difference_copy3;
    wire [10:0] b_y_bits_plus_381 = b_y_bits_d2 + 11'd381;
    wire exponent_in_order_copy4 = largest_d1 < b_y_bits_plus_381_d1;
    wire exponent_both_copy4 = not_zero_is_b_y_bits_d3 & exponent_in_order_copy4;
    wire [10:0] exponent_difference_copy4 = b_y_bits_plus_381_d1 - largest_d1;
    wire [10:0] exponent_chosen_copy7 = b_y_bits_is_255_d3 ? b_y_bits_d3 : exponent_difference_copy4;
    wire [10:0] largest_sum_plus_127_copy2 = 11'd127 + largest_sum_d3;
    wire [10:0] delta_sum = unit_delta_bits_d1_bits + largest_sum_plus_127_copy2;
    wire zero_is_unit_delta_bits = 11'd0 == unit_delta_bits_d1_bits;
    wire not_zero_is_unit_delta_bits = ~zero_is_unit_delta_bits;
    wire largest_below_delta_sum = largest_d1 < delta_sum_d1;
    wire delta_both = largest_below_delta_sum & not_zero_is_unit_delta_bits_d1;
    wire unit_delta_bits_is_255 = 11'd255 == unit_delta_bits_d1_bits;
    wire [10:0] delta_sum_minus_largest = delta_sum_d1 - largest_d1;
    wire [10:0] delta_chosen = unit_delta_bits_is_255_d1 ? unit_delta_bits_d1 : delta_sum_minus_largest;
    wire delta_either = delta_both_d1 | unit_delta_bits_is_255_d1;
    wire [22:0] delta_chosen_copy2 = delta_either ? {delta_chosen_d1, unit_delta_bits_d1_copy2} : 23'd0;
    wire [23:0] delta = {unit_delta_sign_d1, delta_chosen_copy2};
    wire [10:0] mx_sum_copy3 = 11'd127 + lowered_plus_m_exponent;
    wire [10:0] mx_sum_bits_d1_bits = {3'd0, mul_mul_add_f24_ftz_unit_y[22:15]};
    wire [10:0] mx_sum_plus_mx_sum_bits = mx_sum_d3 + mx_sum_bits_d1_bits;
    wire zero_is_mx_sum_bits = 11'd0 == mx_sum_bits_d1_bits;
    wire not_zero_is_mx_sum_bits = ~zero_is_mx_sum_bits;
    wire mx_in_order = largest_d1 < mx_sum_plus_mx_sum_bits_d1;
    wire mx_both_copy3 = mx_in_order & not_zero_is_mx_sum_bits_d1;
    wire mx_sum_bits_is_255 = 11'd255 == mx_sum_bits_d1_bits;
    wire [10:0] mx_difference = mx_sum_plus_mx_sum_bits_d1 - largest_d1;
    wire [10:0] mx_chosen_copy5 = mx_sum_bits_is_255_d1 ? mx_sum_bits_d1 : mx_difference;
    wire [10:0] my_sum_bits_d1_bits = {3'd0, mul_mul_add_f24_ftz_unit_copy2_y[22:15]};
    wire [10:0] mx_sum_plus_my_sum_bits = mx_sum_d3 + my_sum_bits_d1_bits;
    wire my_in_order = largest_d1 < mx_sum_plus_my_sum_bits;
    wire zero_is_my_sum_bits = 11'd0 == my_sum_bits_d1_bits;
    wire not_zero_is_my_sum_bits = ~zero_is_my_sum_bits;
    wire my_sum_bits_is_255 = 11'd255 == my_sum_bits_d1_bits;
    wire [10:0] my_difference = mx_sum_plus_my_sum_bits - largest_d1;
    wire [10:0] edge_on_lesser = (b_exponent_d1 < a_exponent_d1) ? b_exponent_d1 : a_exponent_d1;
    wire edge_on_lesser_below_32 = edge_on_lesser_d1 < 11'd32;
    wire [8:0] unit_delta_bits_is_zero_bits = {1'd0, add_f24_ftz_unit_copy5_y[22:15]};
    wire unit_delta_bits_is_zero = unit_delta_bits_is_zero_bits == 9'd0;
    wire [8:0] unit_delta_bits_plus_12 = unit_delta_bits_is_zero_bits + 9'd12;
    wire edge_on_in_order = unit_delta_bits_plus_12 < {1'd0, unit_delta_product_bits_d1};
    wire [23:0] first_sum_chosen = sight_disc_out_d14 ? max_f24_ftz_unit_y : first_sum_sum_d1_copy3;
    wire [26:0] first_sum_sum = {4'd0, to_fixed_f24_ftz_u23q8_unit_y} + ({4'd0, to_fixed_f24_ftz_u23q8_unit_y} >> 7);
    wire [23:0] last_sum_chosen = sight_disc_out_d14 ? max_f24_ftz_unit_copy2_y : last_sum_sum_d1;
    wire [26:0] last_sum_sum = first_sum_sum;
    wire [23:0] first_difference_chosen = sight_disc_out_d14 ? max_f24_ftz_unit_y : first_difference_sum_d1_copy2;
    wire [26:0] first_difference_sum = first_sum_sum;
    wire [23:0] last_difference_chosen = sight_disc_out_d14 ? max_f24_ftz_unit_copy2_y : last_difference_sum_d1;
    wire [26:0] last_difference_sum = first_sum_sum;
    wire center_x_bits_below_140 = {3'd0, add_f24_ftz_unit_y[22:15]} < 11'd140;
    wire center_y_bits_below_140 = {3'd0, add_f24_ftz_unit_copy2_y[22:15]} < 11'd140;
    wire first_sum_both = center_x_bits_below_140 & center_y_bits_below_140;
    wire [26:0] first_sum_sum_d14 = delay_14_from_3_out[26:0];
    wire [26:0] first_sum_difference = first_sum_sum_d14 - first_sum_sum_d1_copy4;
    wire [26:0] first_sum_sum_copy3 = first_sum_difference_d1 + 27'h7fffff7;
    wire [26:0] last_sum_sum_copy2 = last_sum_sum_d1_copy2 + first_sum_sum_d14;
    wire [26:0] last_sum_sum_copy3 = last_sum_sum_d1_copy3 + 27'h7ffff08;
    wire [26:0] first_sum_greater = ($signed(27'd0) < $signed(first_sum_shifted_d1)) ? first_sum_shifted_d1 : 27'd0;
    wire [26:0] last_sum_lesser = ($signed(last_sum_shifted_d1) < $signed(27'd1023)) ? last_sum_shifted_d1 : 27'd1023;
    wire [26:0] first_difference_difference_d14 = delay_14_from_3_out[53:27];
    wire [26:0] first_difference_difference_copy2 = first_difference_difference_d14 - first_difference_sum_d1_copy3;
    wire [26:0] first_difference_sum_copy2 = first_difference_difference_d1 + 27'd247;
    wire [26:0] first_difference_sum_copy3 = first_difference_shifted_d1 + 27'd511;
    wire [26:0] last_difference_sum_copy2 = last_difference_sum_d1_copy2 + first_difference_difference_d14;
    wire [26:0] last_difference_sum_copy3 = last_difference_sum_d1_copy3 + 27'd8;
    wire [26:0] last_difference_sum_copy4 = 27'd511 + last_difference_shifted_d1;
    wire [26:0] first_difference_greater = ($signed(27'd0) < $signed(first_difference_sum_d1_copy4)) ? first_difference_sum_d1_copy4 : 27'd0;
    wire [26:0] first_difference = delay_14_from_6_out ? first_difference_greater_d1 : 27'd0;
    wire [26:0] last_difference_lesser = ($signed(last_difference_sum_d1_copy4) < $signed(27'd1023)) ? last_difference_sum_d1_copy4 : 27'd1023;
    wire [26:0] last_sum = delay_14_from_6_out ? last_sum_lesser_d1 : 27'd1023;
    wire [26:0] first_sum = delay_14_from_6_out ? first_sum_greater_d1 : 27'd0;
    wire first_sum_up_to_last_sum = ~($signed(last_sum) < $signed(first_sum));
    wire [26:0] last_difference = delay_14_from_6_out ? last_difference_lesser_d1 : 27'd1023;
    wire visible_in_order = ~($signed(last_difference) < $signed(first_difference_d1));
    wire occupied_x = first_x_shifted_d1 < last_x_lesser_d1;
    wire before_far_and_occupied_x = delay_12_from_3_out & occupied_x;
    wire occupied_y = first_y_shifted_d1 < last_y_lesser_d1;
    wire visible_both_copy2 = occupied_y & before_far_and_occupied_x_d1;
    wire turned_and_lowered_chosen_sign_d9 = delay_9_from_5_out[25];
    wire sight_negative_out = add_f24_ftz_unit_copy5_y[23] ^ turned_and_lowered_chosen_sign_d9;
    wire visible_both = first_sum_up_to_last_sum_d1 & visible_in_order_d1;
    wire visible_both_and_visible_both = visible_both & visible_both_d4;
    wire visible_both_copy3 = delay_19_from_7_out & visible_both_and_visible_both;
    wire not_exponent_joined_sign = ~a_x_sign_d3;
    wire not_exponent_joined_sign_copy2 = ~a_y_sign_d3;
    wire visible = visible_both_d1_copy2 & delay_12_from_0_out;
    wire end_or_visible = delay_21_from_0_out | visible;
    wire center_x_bits_below_140_copy2 = {2'd0, add_f24_ftz_unit_y[22:15]} < 10'd140;
    wire center_y_bits_below_140_copy2 = {2'd0, add_f24_ftz_unit_copy2_y[22:15]} < 10'd140;
    wire placed = center_x_bits_below_140_copy2 & center_y_bits_below_140_copy2;
    wire [27:0] center_y_out_sum_bits = {to_fixed_f24_ftz_s27q13_unit_y[26], to_fixed_f24_ftz_s27q13_unit_y};
    wire not_center_x_fixed_sign = ~to_fixed_f24_ftz_s27q13_unit_y[26];
    wire [27:0] center_x_out_sum = center_y_out_sum_bits + {27'd0, not_center_x_fixed_sign};
    wire [27:0] center_x_out_lesser = ($signed(center_x_out_shifted_d1) < $signed(28'h1ffffff)) ? center_x_out_shifted_d1 : 28'h1ffffff;
    wire [25:0] center_x_out_d10 = delay_10_from_3_out[25:0];
    wire not_center_y_fixed_sign = not_center_x_fixed_sign;
    wire [27:0] center_y_out_sum = center_y_out_sum_bits + {27'd0, not_center_y_fixed_sign};
    wire [27:0] center_y_out_lesser = ($signed(center_y_out_shifted_d1) < $signed(28'h1ffffff)) ? center_y_out_shifted_d1 : 28'h1ffffff;
    wire [25:0] center_y_out_d10 = delay_10_from_3_out[51:26];
    wire [8:0] first_x = first_x_shifted_d1_shifted[8:0];
    wire [26:0] shift_difference = shift_shifted_d1 - center_x_out_d1;
    wire [26:0] last_x_plus_1 = 27'd1 + {18'd0, last_x_d1};
    wire [26:0] shift_difference_copy2 = shift_shifted_d1_copy2 - center_x_out_d1;
    wire [26:0] not_shift_difference = ~shift_difference_d1;
    wire [26:0] shift_chosen = shift_difference_d1[26] ? not_shift_difference : shift_difference_d1;
    wire [26:0] not_shift_difference_copy2 = ~shift_difference_copy2;
    wire [8:0] first_y = first_y_shifted_d1_shifted[8:0];
    wire [26:0] shift_difference_copy3 = shift_shifted_d1_copy3 - center_y_out_d1;
    wire [26:0] last_y_plus_1 = 27'd1 + {18'd0, last_y_d1};
    wire [26:0] shift_difference_copy4 = shift_shifted_d1_copy4 - center_y_out_d1;
    wire [26:0] not_shift_difference_copy3 = ~shift_difference_d1_copy3;
    wire [26:0] shift_chosen_copy3 = shift_difference_d1_copy3[26] ? not_shift_difference_copy3 : shift_difference_d1_copy3;
    wire [26:0] shift_chosen_copy2 = shift_difference_d1_copy2[26] ? not_shift_difference_d1 : shift_difference_d1_copy2;
    wire [25:0] shift_either = shift_chosen_bits_d1 | shift_chosen_copy2[25:0];
    wire [25:0] shift_either_copy2 = shift_either | shift_chosen_bits_d1_copy2;
    wire [26:0] not_shift_difference_copy4 = ~shift_difference_copy4;
    wire [26:0] shift_chosen_copy4 = shift_difference_d1_copy4[26] ? not_shift_difference_d1_copy2 : shift_difference_d1_copy4;
    wire [25:0] shift_either_copy3 = shift_either_d1 | shift_chosen_copy4[25:0];
    wire zero_is_shift_either_bits = 11'd0 == shift_either_bits_d1;
    wire not_zero_is_shift_either_bits = ~zero_is_shift_either_bits;
    wire shift_either_bits_is_zero = shift_either_bits_d1_copy2 == 10'd0;
    wire not_shift_either_bits_is_zero = ~shift_either_bits_is_zero;
    wire zero_is_shift_either_bits_copy2 = 9'd0 == shift_either_bits_d1_copy3;
    wire not_zero_is_shift_either_bits_copy2 = ~zero_is_shift_either_bits_copy2;
    wire [3:0] shift_chosen_copy5 = not_zero_is_shift_either_bits_d1 ? 4'd1 : 4'd0;
    wire [3:0] shift_chosen_copy6 = not_shift_either_bits_is_zero_d1 ? 4'd2 : shift_chosen_copy5;
    wire [3:0] shift_chosen_copy7 = not_zero_is_shift_either_bits_d1_copy2 ? 4'd3 : shift_chosen_copy6;
    wire shift_either_bits_is_zero_copy2 = shift_either_bits_d1_copy4 == 8'd0;
    wire not_shift_either_bits_is_zero_copy2 = ~shift_either_bits_is_zero_copy2;
    wire shift_either_bits_is_zero_copy3 = shift_either_bits_d1_copy5 == 7'd0;
    wire not_shift_either_bits_is_zero_copy3 = ~shift_either_bits_is_zero_copy3;
    wire shift_either_bits_is_zero_copy4 = shift_either_bits_d1_copy6 == 6'd0;
    wire not_shift_either_bits_is_zero_copy4 = ~shift_either_bits_is_zero_copy4;
    wire [3:0] shift_chosen_copy8 = not_shift_either_bits_is_zero_d1_copy2 ? 4'd4 : shift_chosen_d1;
    wire [3:0] shift_chosen_copy9 = not_shift_either_bits_is_zero_d1_copy3 ? 4'd5 : shift_chosen_copy8;
    wire [3:0] shift_chosen_copy10 = not_shift_either_bits_is_zero_d1_copy4 ? 4'd6 : shift_chosen_copy9;
    wire shift_either_bits_is_zero_copy5 = shift_either_bits_d1_copy7 == 5'd0;
    wire not_shift_either_bits_is_zero_copy5 = ~shift_either_bits_is_zero_copy5;
    wire zero_is_shift_either_bits_copy3 = 4'd0 == shift_either_bits_d1_copy8;
    wire not_zero_is_shift_either_bits_copy3 = ~zero_is_shift_either_bits_copy3;
    wire shift_either_bits_is_zero_copy6 = shift_either_copy3[25:23] == 3'd0;
    wire not_shift_either_bits_is_zero_copy6 = ~shift_either_bits_is_zero_d1;
    wire [3:0] shift_chosen_copy11 = not_shift_either_bits_is_zero_d1_copy5 ? 4'd7 : shift_chosen_d1_copy2;
    wire [3:0] shift_chosen_copy12 = not_zero_is_shift_either_bits_d1_copy3 ? 4'd8 : shift_chosen_copy11;
    wire [3:0] shift_chosen_copy13 = not_shift_either_bits_is_zero_copy6 ? 4'd9 : shift_chosen_copy12;
    wire shift_either_bits_is_zero_copy7 = shift_either_copy3[25:24] == 2'd0;
    wire shift_either_sign_is_zero = ~shift_either_copy3[25];
    wire not_shift_either_sign_is_zero = ~shift_either_sign_is_zero_d1;
    wire not_shift_either_bits_is_zero_copy7 = ~shift_either_bits_is_zero_d1_copy2;
    wire [3:0] shift_chosen_copy14 = not_shift_either_bits_is_zero_copy7 ? 4'd10 : shift_chosen_d1_copy3;
    wire [3:0] shift = not_shift_either_sign_is_zero ? 4'd11 : shift_chosen_copy14;
    wire [9:0] shift_plus_4 = {6'd0, shift_d1} + 10'd4;
    wire [9:0] delta_bits_d10 = delay_9_from_5_out[36:27];
    wire shift_plus_4_below_delta_bits = shift_plus_4_d1 < delta_bits_d10;
    wire [9:0] delta_bits_minus_shift_plus_4 = delta_bits_d10 - shift_plus_4_d1;
    wire [9:0] exponent_chosen_copy11 = shift_plus_4_below_delta_bits ? delta_bits_minus_shift_plus_4 : 10'd0;
    wire [9:0] exponent_chosen_bits_d9 = delay_9_from_6_out[9:0];
    wire exponent_either_copy3 = b_x_bits_is_255_d3 | exponent_both_d1_copy3;
    wire [22:0] exponent_chosen_copy6 = exponent_either_copy3 ? exponent_joined_d1_copy4 : 23'd0;
    wire [9:0] exponent_chosen_bits_d9_copy2 = delay_9_from_6_out[19:10];
    wire exponent_either_copy4 = b_y_bits_is_255_d3 | exponent_both_d1_copy4;
    wire [22:0] exponent_chosen_copy8 = exponent_either_copy4 ? {exponent_chosen_d1_copy2, b_y_bits_d3_copy2} : 23'd0;
    wire mx_both_or_mx_sum_bits_is_255 = mx_both_d1_copy3 | mx_sum_bits_is_255_d1;
    wire [22:0] mx_chosen_copy6 = mx_both_or_mx_sum_bits_is_255 ? {mx_chosen_d1_copy3, mx_sum_bits_d1_copy2} : 23'd0;
    wire [23:0] mx = {mx_sum_sign_d1, mx_chosen_copy6};
    wire my_both = my_in_order_d1 & not_zero_is_my_sum_bits_d1;
    wire my_both_or_my_sum_bits_is_255 = my_both | my_sum_bits_is_255_d1;
    wire [10:0] my_chosen = my_sum_bits_is_255_d1 ? my_sum_bits_d1 : my_difference_d1;
    wire [22:0] my_chosen_copy2 = my_both_or_my_sum_bits_is_255 ? {my_chosen[7:0], my_sum_bits_d1_copy2} : 23'd0;
    wire [23:0] my = {my_sum_sign_d1, my_chosen_copy2};
    wire [9:0] exponent_greater = (exponent_chosen_d1_copy3 < exponent_chosen_bits_d10) ? exponent_chosen_bits_d10 : exponent_chosen_d1_copy3;
    wire [9:0] exponent_joined_bits_d10 = delay_9_from_5_out[46:37];
    wire [9:0] exponent_greater_copy2 = (exponent_joined_bits_d10 < exponent_greater_d1) ? exponent_greater_d1 : exponent_joined_bits_d10;
    wire [9:0] exponent_greater_copy3 = (exponent_chosen_bits_d10_copy2 < exponent_greater_d1_copy2) ? exponent_greater_d1_copy2 : exponent_chosen_bits_d10_copy2;
    wire [9:0] exponent_joined_bits_d10_copy2 = delay_9_from_5_out[56:47];
    wire [9:0] exponent_greater_copy4 = (exponent_joined_bits_d10_copy2 < exponent_greater_d1_copy3) ? exponent_greater_d1_copy3 : exponent_joined_bits_d10_copy2;
    wire [9:0] mx_bits_d10 = delay_9_from_5_out[66:57];
    wire [9:0] exponent_greater_copy5 = (mx_bits_d10 < exponent_greater_d1_copy4) ? exponent_greater_d1_copy4 : mx_bits_d10;
    wire [9:0] my_bits_d10 = delay_9_from_5_out[76:67];
    wire [9:0] exponent = (my_bits_d10 < exponent_greater_d1_copy5) ? exponent_greater_d1_copy5 : my_bits_d10;
    wire [9:0] exponent_chosen_bits_plus_126 = exponent_chosen_bits_d10 + 10'd126;
    wire zero_is_exponent_chosen_bits = 10'd0 == exponent_chosen_bits_d9;
    wire ax_out_in_order = exponent_d1 < exponent_chosen_bits_plus_126_d1;
    wire ax_out_inverted = ~zero_is_exponent_chosen_bits_d1;
    wire ax_out_both = ax_out_in_order & ax_out_inverted;
    wire exponent_chosen_sign_d11 = delay_11_from_6_out[0];
    wire [9:0] ax_out_difference = exponent_chosen_bits_plus_126_d1 - exponent_d1;
    wire [9:0] ax_out_chosen = ax_out_both_d1 ? ax_out_difference : 10'd0;
    wire [14:0] exponent_chosen_bits_d11 = delay_11_from_6_out[15:1];
    wire [17:0] ax_out_sum_bits = {to_fixed_f24_ftz_s17q16_unit_y[16], to_fixed_f24_ftz_s17q16_unit_y};
    wire not_ax_out_joined_fixed_sign = ~to_fixed_f24_ftz_s17q16_unit_y[16];
    wire [17:0] ax_out_sum = ax_out_sum_bits + {17'd0, not_ax_out_joined_fixed_sign};
    wire [17:0] ax_out_lesser = ($signed(ax_out_shifted_d1) < $signed(18'h7fff)) ? ax_out_shifted_d1 : 18'h7fff;
    wire [9:0] exponent_joined_bits_plus_126 = exponent_joined_bits_d10 + 10'd126;
    wire bx_out_in_order = exponent_d1 < exponent_joined_bits_plus_126_d1;
    wire bx_out_inverted_d10 = delay_10_from_6_out[0];
    wire bx_out_both = bx_out_in_order & bx_out_inverted_d10;
    wire exponent_joined_sign_d11 = delay_11_from_5_out[1];
    wire [9:0] bx_out_difference = exponent_joined_bits_plus_126_d1 - exponent_d1;
    wire [9:0] bx_out_chosen = bx_out_both_d1 ? bx_out_difference : 10'd0;
    wire [14:0] exponent_joined_bits_d11 = delay_11_from_5_out[16:2];
    wire not_bx_out_joined_fixed_sign = not_ax_out_joined_fixed_sign;
    wire [17:0] bx_out_sum = ax_out_sum_bits + {17'd0, not_bx_out_joined_fixed_sign};
    wire [17:0] bx_out_lesser = ($signed(bx_out_shifted_d1) < $signed(18'h7fff)) ? bx_out_shifted_d1 : 18'h7fff;
    wire [9:0] exponent_chosen_bits_plus_126_copy2 = exponent_chosen_bits_d10_copy2 + 10'd126;
    wire zero_is_exponent_chosen_bits_copy2 = 10'd0 == exponent_chosen_bits_d9_copy2;
    wire ay_out_in_order = exponent_d1 < exponent_chosen_bits_plus_126_d1_copy2;
    wire ay_out_inverted = ~zero_is_exponent_chosen_bits_d1_copy2;
    wire ay_out_both = ay_out_in_order & ay_out_inverted;
    wire exponent_chosen_sign_d11_copy2 = delay_11_from_6_out[16];
    wire [9:0] ay_out_difference = exponent_chosen_bits_plus_126_d1_copy2 - exponent_d1;
    wire [9:0] ay_out_chosen = ay_out_both_d1 ? ay_out_difference : 10'd0;
    wire [14:0] exponent_chosen_bits_d11_copy2 = delay_11_from_6_out[31:17];
    wire not_ay_out_joined_fixed_sign = not_ax_out_joined_fixed_sign;
    wire [17:0] ay_out_sum = ax_out_sum_bits + {17'd0, not_ay_out_joined_fixed_sign};
    wire [17:0] ay_out_lesser = ($signed(ay_out_shifted_d1) < $signed(18'h7fff)) ? ay_out_shifted_d1 : 18'h7fff;
    wire [9:0] exponent_joined_bits_plus_126_copy2 = exponent_joined_bits_d10_copy2 + 10'd126;
    wire by_out_in_order = exponent_d1 < exponent_joined_bits_plus_126_d1_copy2;
    wire by_out_inverted_d10 = delay_10_from_6_out[1];
    wire by_out_both = by_out_in_order & by_out_inverted_d10;
    wire exponent_joined_sign_d11_copy2 = delay_11_from_5_out[17];
    wire [9:0] by_out_difference = exponent_joined_bits_plus_126_d1_copy2 - exponent_d1;
    wire [9:0] by_out_chosen = by_out_both_d1 ? by_out_difference : 10'd0;
    wire [14:0] exponent_joined_bits_d11_copy2 = delay_11_from_5_out[32:18];
    wire not_by_out_joined_fixed_sign = not_ax_out_joined_fixed_sign;
    wire [17:0] by_out_sum = ax_out_sum_bits + {17'd0, not_by_out_joined_fixed_sign};
    wire [17:0] by_out_lesser = ($signed(by_out_shifted_d1) < $signed(18'h7fff)) ? by_out_shifted_d1 : 18'h7fff;
    wire [9:0] mx_bits_plus_126 = mx_bits_d10 + 10'd126;
    wire mx_out_in_order = exponent_d1 < mx_bits_plus_126_d1;
    wire not_zero_is_mx_bits_d10 = delay_10_from_6_out[2];
    wire mx_out_both = mx_out_in_order & not_zero_is_mx_bits_d10;
    wire mx_sign_d11 = delay_11_from_5_out[33];
    wire [9:0] mx_out_difference = mx_bits_plus_126_d1 - exponent_d1;
    wire [9:0] mx_out_chosen = mx_out_both_d1 ? mx_out_difference : 10'd0;
    wire [14:0] mx_bits_d11 = delay_11_from_5_out[48:34];
    wire not_mx_out_joined_fixed_sign = not_ax_out_joined_fixed_sign;
    wire [17:0] mx_out_sum = ax_out_sum_bits + {17'd0, not_mx_out_joined_fixed_sign};
    wire [17:0] mx_out_lesser = ($signed(mx_out_shifted_d1) < $signed(18'h7fff)) ? mx_out_shifted_d1 : 18'h7fff;
    wire [9:0] my_bits_plus_126 = my_bits_d10 + 10'd126;
    wire my_out_in_order = exponent_d1 < my_bits_plus_126_d1;
    wire not_zero_is_my_bits_d10 = delay_10_from_6_out[3];
    wire my_out_both = my_out_in_order & not_zero_is_my_bits_d10;
    wire my_sign_d11 = delay_11_from_5_out[49];
    wire [9:0] my_out_difference = my_bits_plus_126_d1 - exponent_d1;
    wire [9:0] my_out_chosen = my_out_both_d1 ? my_out_difference : 10'd0;
    wire [14:0] my_bits_d11 = delay_11_from_5_out[64:50];
    wire not_my_out_joined_fixed_sign = not_ax_out_joined_fixed_sign;
    wire [17:0] my_out_sum = ax_out_sum_bits + {17'd0, not_my_out_joined_fixed_sign};
    wire [17:0] my_out_lesser = ($signed(my_out_shifted_d1) < $signed(18'h7fff)) ? my_out_shifted_d1 : 18'h7fff;
    wire [9:0] shift_plus_4_plus_exponent = shift_plus_4_d1 + exponent_d1;
    wire [9:0] delta_bits_plus_126 = delta_bits_d11 + 10'd126;
    wire vanishes_in_order = shift_plus_4_plus_exponent < delta_bits_plus_126;
    wire [9:0] vanishes_difference = delta_bits_plus_126 - shift_plus_4_plus_exponent;
    wire delta_sign_d10 = delay_10_from_7_out[0];
    wire not_zero_is_delta_bits_d11 = delay_11_from_6_out[32];
    wire vanishes_both = vanishes_in_order_d1 & not_zero_is_delta_bits_d11;
    wire [9:0] vanishes_chosen = vanishes_both ? vanishes_difference_d1 : 10'd0;
    wire [14:0] delta_bits_d10_copy2 = delay_10_from_7_out[15:1];
    wire [21:0] vanishes_sum_bits = {to_fixed_f24_ftz_s21q20_unit_y[20], to_fixed_f24_ftz_s21q20_unit_y};
    wire not_vanishes_joined_fixed_sign = ~to_fixed_f24_ftz_s21q20_unit_y[20];
    wire [21:0] vanishes_sum = vanishes_sum_bits + {21'd0, not_vanishes_joined_fixed_sign};
    wire [21:0] vanishes_lesser = ($signed(vanishes_shifted_d1) < $signed(22'h7ffff)) ? vanishes_shifted_d1 : 22'h7ffff;
    wire turned_d10 = delay_9_from_5_out[0];
    wire [23:0] exponent_chosen_copy9 = turned_d10 ? exponent_joined_d1_copy5 : exponent_joined_d1;
    wire exponent_chosen_bits_is_255 = {2'd0, exponent_chosen_copy9[22:15]} == 10'd255;
    wire exponent_joined_bits_is_255 = exponent_joined_bits_d1 == 10'd255;
    wire [23:0] exponent_chosen_copy10 = turned_d10 ? exponent_joined_d1_copy6 : exponent_joined_d1_copy3;
    wire exponent_chosen_bits_is_255_copy2 = {2'd0, exponent_chosen_copy10[22:15]} == 10'd255;
    wire odd_either = exponent_chosen_bits_is_255_d1 | exponent_joined_bits_is_255_d1;
    wire odd_either_copy2 = odd_either | exponent_chosen_bits_is_255_d1_copy2;
    wire exponent_joined_bits_is_255_copy2 = exponent_joined_bits_d1_copy2 == 10'd255;
    wire odd_either_copy3 = odd_either_copy2 | exponent_joined_bits_is_255_copy2;
    wire mx_bits_is_255 = mx_bits_d1 == 10'd255;
    wire my_bits_is_255 = my_bits_d1 == 10'd255;
    wire odd_either_or_mx_bits_is_255 = odd_either_d1 | mx_bits_is_255_d1;
    wire odd_either_copy4 = odd_either_or_mx_bits_is_255 | my_bits_is_255_d1;
    wire delta_bits_is_255 = delta_bits_d1 == 10'd255;
    wire odd = odd_either_copy4 | delta_bits_is_255;
    wire vanishes_in_order_copy2 = $signed(vanishes_lesser_d1) < $signed(20'd32);
    wire vanishes_in_order_copy3 = $signed(20'hfffe0) < $signed(vanishes_lesser_d1);
    wire vanishes = vanishes_in_order_copy2 & vanishes_in_order_copy3;
    wire not_placed = ~placed_d2;
    wire edge_on_either = unit_delta_bits_is_zero_d1 | edge_on_in_order_d1;
    wire edge_on = edge_on_lesser_below_32_d2 | edge_on_either;
    wire edge_on_or_not_placed = edge_on | not_placed_d2;
    wire odd_or_edge_on_or_not_placed_d10 = delay_10_from_6_out[4];
    wire covers_nothing = vanishes_d1 | odd_or_edge_on_or_not_placed_d10;
    wire [10:0] sight_near_out_bits_plus_126 = 11'd126 + delay_8_from_5_out;
    wire sight_near_out_in_order = {1'd0, shift_plus_4_plus_exponent} < sight_near_out_bits_plus_126_d1;
    wire sight_near_out_bits_is_255 = 11'd255 == delay_8_from_5_out;
    wire [10:0] sight_near_out_sum = 11'd255 + {1'd0, shift_plus_4_plus_exponent};
    wire sight_near_out_inverted_d9 = delay_9_from_5_out[77];
    wire sight_near_out_both = sight_near_out_in_order_d1 & sight_near_out_inverted_d9;
    wire sight_near_out_in_order_copy2 = ~(sight_near_out_bits_plus_126_d1 < sight_near_out_sum_d1);
    wire sight_near_out_both_copy2 = sight_near_out_both & sight_near_out_in_order_copy2;
    wire not_sight_near_out_bits_is_255 = ~sight_near_out_bits_is_255;
    wire [10:0] sight_near_out_difference = sight_near_out_bits_plus_126_d1 - {1'd0, shift_plus_4_plus_exponent};
    wire sight_near_out_either = sight_near_out_both | sight_near_out_bits_is_255_d1;
    wire sight_near_out_both_copy3 = sight_near_out_both_d1 & not_sight_near_out_bits_is_255_d1;
    wire [10:0] sight_near_out_chosen = sight_near_out_both_copy3 ? 11'd255 : sight_near_out_difference_d1;
    wire [10:0] sight_near_out_chosen_copy2 = sight_near_out_bits_is_255_d1 ? sight_near_out_bits_d9 : sight_near_out_chosen;
    wire [14:0] sight_near_out_bits_d9_copy2 = delay_9_from_5_out[92:78];
    wire [14:0] sight_near_out_chosen_copy3 = sight_near_out_both_copy3 ? 15'd0 : sight_near_out_bits_d9_copy2;
    wire [19:0] sight_near_out_chosen_copy5 = delay_7_from_1_out ? 20'hfffff : to_fixed_f24_ftz_u20q19_unit_y;
    wire [10:0] sight_far_out_sum = 11'd126 + delay_8_from_6_out;
    wire sight_far_out_in_order = {1'd0, shift_plus_4_plus_exponent} < sight_far_out_sum_d1;
    wire sight_far_out_same_copy2 = 11'd255 == delay_8_from_6_out;
    wire not_sight_far_out_same_d9 = delay_9_from_6_out[20];
    wire sight_far_out_both = sight_far_out_in_order_d1 & not_sight_far_out_same_d9;
    wire sight_far_out_in_order_copy2 = ~(sight_far_out_sum_d1 < sight_near_out_sum_d1);
    wire sight_far_out_both_copy2 = sight_far_out_both & sight_far_out_in_order_copy2;
    wire not_sight_far_out_same_copy2 = ~sight_far_out_same_copy2;
    wire [10:0] sight_far_out_difference = sight_far_out_sum_d1 - {1'd0, shift_plus_4_plus_exponent};
    wire sight_far_out_either = sight_far_out_both | sight_far_out_same_d1;
    wire sight_far_out_both_copy3 = sight_far_out_both_d1 & not_sight_far_out_same_d1;
    wire [10:0] sight_far_out_chosen = sight_far_out_both_copy3 ? 11'd255 : sight_far_out_difference_d1;
    wire [10:0] sight_far_out_chosen_copy2 = sight_far_out_same_d1 ? abs_sight_far_out_product_bits_d9 : sight_far_out_chosen;
    wire [14:0] abs_sight_far_out_product_bits_d9_copy2 = delay_9_from_6_out[35:21];
    wire [14:0] sight_far_out_chosen_copy3 = sight_far_out_both_copy3 ? 15'd0 : abs_sight_far_out_product_bits_d9_copy2;
    wire abs_sight_far_out_product_sign_d9 = delay_9_from_6_out[36];
    wire [22:0] sight_far_out_chosen_copy4 = sight_far_out_either_d1 ? sight_far_out_joined_d1 : 23'd0;
    wire [19:0] sight_far_out_chosen_copy5 = delay_7_from_6_out ? 20'd0 : to_fixed_f24_ftz_u20q19_unit_y;
    wire [19:0] sight_far_out = covers_nothing ? 20'd0 : sight_far_out_chosen_copy5;
    wire [23:0] max_f24_ftz_unit_a_choice = max_f24_ftz_unit_phase[0] ? last_y_chosen_d1_copy2 : first_sum_product_d1;
    wire [23:0] max_f24_ftz_unit_a_choice_2 = max_f24_ftz_unit_phase[1] ? (max_f24_ftz_unit_phase[0] ? 24'd0 : 24'd0) : max_f24_ftz_unit_a_choice;
    wire [23:0] max_f24_ftz_unit_a_choice_3 = max_f24_ftz_unit_phase[0] ? first_sum_product_d1 : last_x_chosen_d1_copy2;
    wire [23:0] max_f24_ftz_unit_a_choice_4 = max_f24_ftz_unit_phase[0] ? {1'd0, tangent1_y_d1[22:0]} : {1'd0, in_tangent1_x[22:0]};
    wire [23:0] max_f24_ftz_unit_a_choice_5 = max_f24_ftz_unit_phase[1] ? max_f24_ftz_unit_a_choice_3 : max_f24_ftz_unit_a_choice_4;
    wire [23:0] max_f24_ftz_unit_b_choice = max_f24_ftz_unit_phase_copy2[0] ? first_x_chosen_d1_copy3 : middle_depth_minus_epsilon_d1;
    wire [23:0] max_f24_ftz_unit_b_choice_2 = max_f24_ftz_unit_phase_copy2[0] ? filter_radius_plus_center_y_d1 : first_difference_sum_d1_copy2;
    wire [23:0] max_f24_ftz_unit_b_choice_3 = max_f24_ftz_unit_phase_copy2[1] ? max_f24_ftz_unit_b_choice : max_f24_ftz_unit_b_choice_2;
    wire [23:0] max_f24_ftz_unit_b_choice_4 = max_f24_ftz_unit_phase_copy2[0] ? first_sum_sum_d1_copy3 : filter_radius_plus_center_x_d1;
    wire [23:0] max_f24_ftz_unit_b_choice_5 = max_f24_ftz_unit_phase_copy2[0] ? {1'd0, tangent2_y_d1[22:0]} : {1'd0, in_tangent2_x[22:0]};
    wire [23:0] max_f24_ftz_unit_b_choice_6 = max_f24_ftz_unit_phase_copy2[1] ? max_f24_ftz_unit_b_choice_4 : max_f24_ftz_unit_b_choice_5;
    wire [23:0] max_f24_ftz_unit_copy2_a_choice = max_f24_ftz_unit_copy2_phase[0] ? first_sum_product_d1 : 24'd0;
    wire [23:0] max_f24_ftz_unit_copy2_a_choice_2 = max_f24_ftz_unit_copy2_phase[1] ? (max_f24_ftz_unit_copy2_phase[0] ? 24'd0 : 24'd0) : max_f24_ftz_unit_copy2_a_choice;
    wire [23:0] max_f24_ftz_unit_copy2_a_choice_3 = max_f24_ftz_unit_copy2_phase[0] ? 24'd0 : lt_f24_ftz_unit_copy2_a_bits;
    wire [23:0] max_f24_ftz_unit_copy2_a_choice_4 = max_f24_ftz_unit_copy2_phase[1] ? max_f24_ftz_unit_copy2_a_choice : max_f24_ftz_unit_copy2_a_choice_3;
    wire [23:0] max_f24_ftz_unit_copy2_b_choice = max_f24_ftz_unit_copy2_phase_copy2[0] ? middle_depth_plus_epsilon_d1 : middle_depth_d1;
    wire [23:0] max_f24_ftz_unit_copy2_b_choice_2 = max_f24_ftz_unit_copy2_phase_copy2[0] ? last_difference_sum_d1 : min_f24_ftz_unit_y;
    wire [23:0] max_f24_ftz_unit_copy2_b_choice_3 = max_f24_ftz_unit_copy2_phase_copy2[1] ? max_f24_ftz_unit_copy2_b_choice : max_f24_ftz_unit_copy2_b_choice_2;
    wire [23:0] max_f24_ftz_unit_copy2_b_choice_4 = max_f24_ftz_unit_copy2_phase_copy2[0] ? last_sum_sum_d1 : first_y_chosen_d1_copy3;
    wire [23:0] max_f24_ftz_unit_copy2_b_choice_5 = max_f24_ftz_unit_copy2_phase_copy2[0] ? min_f24_ftz_unit_y : lt_f24_ftz_unit_copy2_b_bits;
    wire [23:0] max_f24_ftz_unit_copy2_b_choice_6 = max_f24_ftz_unit_copy2_phase_copy2[1] ? max_f24_ftz_unit_copy2_b_choice_4 : max_f24_ftz_unit_copy2_b_choice_5;
    wire [23:0] add_f24_ftz_unit_a_choice = add_f24_ftz_unit_phase[1] ? (add_f24_ftz_unit_phase[0] ? origin_x : center_z_d1) : add_f24_ftz_unit_phase[0] ? 24'h3f8000 : center_z_d2;
    wire [23:0] add_f24_ftz_unit_a_choice_2 = add_f24_ftz_unit_phase[1] ? (add_f24_ftz_unit_phase[0] ? center_x_minus_t_x_d4 : depth_a) : add_f24_ftz_unit_phase[0] ? 24'h3f8000 : delay_6_from_1_out;
    wire [23:0] add_f24_ftz_unit_b_choice = add_f24_ftz_unit_phase_copy2[0] ? mul_f24_ftz_unit_copy3_y : reaches_near_joined_d1;
    wire [23:0] add_f24_ftz_unit_b_bits = {~mul_mul_add_f24_ftz_unit_y[23], mul_mul_add_f24_ftz_unit_y[22:0]};
    wire [23:0] add_f24_ftz_unit_b_choice_2 = add_f24_ftz_unit_phase_copy2[0] ? add_f24_ftz_unit_b_bits : {~reaches_near_joined_d1[23], reaches_near_joined_d1[22:0]};
    wire [23:0] add_f24_ftz_unit_b_choice_3 = add_f24_ftz_unit_phase_copy2[1] ? add_f24_ftz_unit_b_choice : add_f24_ftz_unit_b_choice_2;
    wire [23:0] add_f24_ftz_unit_b_choice_4 = add_f24_ftz_unit_phase_copy2[0] ? minus_h_x_d1 : mul_f24_ftz_unit_y;
    wire not_depth_a_sign = ~depth_a[23];
    wire [23:0] add_f24_ftz_unit_b_choice_5 = add_f24_ftz_unit_phase_copy2[0] ? {not_depth_a_sign, depth_a[22:0]} : mul_f24_ftz_unit_y;
    wire [23:0] add_f24_ftz_unit_b_choice_6 = add_f24_ftz_unit_phase_copy2[1] ? add_f24_ftz_unit_b_choice_4 : add_f24_ftz_unit_b_choice_5;
    wire [23:0] t_x_minus_t_y_d7 = delay_7_from_2_out[47:24];
    wire [23:0] add_f24_ftz_unit_copy2_a_choice = add_f24_ftz_unit_copy2_phase[0] ? spread_middle_d1 : t_x_minus_t_y_d7;
    wire [23:0] add_f24_ftz_unit_copy2_a_choice_2 = add_f24_ftz_unit_copy2_phase[1] ? (add_f24_ftz_unit_copy2_phase[0] ? origin_y : center_x_d1) : add_f24_ftz_unit_copy2_a_choice;
    wire [23:0] add_f24_ftz_unit_copy2_a_choice_3 = add_f24_ftz_unit_copy2_phase[0] ? mul_mul_add_f24_ftz_unit_copy2_y : center_x_d5;
    wire [23:0] add_f24_ftz_unit_copy2_a_choice_4 = add_f24_ftz_unit_copy2_phase[0] ? half_depth_times_epsilon_scale_d1 : spread_middle_d1;
    wire [23:0] add_f24_ftz_unit_copy2_a_choice_5 = add_f24_ftz_unit_copy2_phase[1] ? add_f24_ftz_unit_copy2_a_choice_3 : add_f24_ftz_unit_copy2_a_choice_4;
    wire [23:0] add_f24_ftz_unit_copy2_b_choice = add_f24_ftz_unit_copy2_phase_copy2[0] ? mul_f24_ftz_unit_copy2_y : {~first_x_joined_d1[23], first_x_joined_d1[22:0]};
    wire [23:0] add_f24_ftz_unit_copy2_b_choice_2 = add_f24_ftz_unit_copy2_phase_copy2[0] ? spread_half_d2 : sqrt_f24_ftz_unit_y;
    wire [23:0] add_f24_ftz_unit_copy2_b_choice_3 = add_f24_ftz_unit_copy2_phase_copy2[1] ? add_f24_ftz_unit_copy2_b_choice : add_f24_ftz_unit_copy2_b_choice_2;
    wire [23:0] add_f24_ftz_unit_copy2_b_choice_4 = add_f24_ftz_unit_copy2_phase_copy2[0] ? mul_mul_add_f24_ftz_unit_copy2_y : {~mul_f24_ftz_unit_copy3_y[23], mul_f24_ftz_unit_copy3_y[22:0]};
    wire [23:0] add_f24_ftz_unit_copy2_b_choice_5 = add_f24_ftz_unit_copy2_phase_copy2[0] ? epsilon_bias : {~spread_half_d1[23], spread_half_d1[22:0]};
    wire [23:0] add_f24_ftz_unit_copy2_b_choice_6 = add_f24_ftz_unit_copy2_phase_copy2[1] ? add_f24_ftz_unit_copy2_b_choice_4 : add_f24_ftz_unit_copy2_b_choice_5;
    wire [23:0] add_f24_ftz_unit_copy3_a_choice = add_f24_ftz_unit_copy3_phase[1] ? (add_f24_ftz_unit_copy3_phase[0] ? center_y_d1 : center_x_d1) : add_f24_ftz_unit_copy3_phase[0] ? origin_x : sqrt_f24_ftz_unit_y;
    wire [23:0] add_f24_ftz_unit_copy3_a_choice_2 = add_f24_ftz_unit_copy3_phase[1] ? (add_f24_ftz_unit_copy3_phase[0] ? t_x_d1 : sqrt_f24_ftz_unit_y) : add_f24_ftz_unit_copy3_phase[0] ? center_x_d9 : center_y_d1;
    wire [23:0] add_f24_ftz_unit_copy3_b_choice = add_f24_ftz_unit_copy3_phase_copy2[0] ? {~first_y_joined_d1[23], first_y_joined_d1[22:0]} : first_x_joined_d1;
    wire [23:0] add_f24_ftz_unit_copy3_b_choice_2 = add_f24_ftz_unit_copy3_phase_copy2[0] ? first_x_joined_d1_copy2 : {~t_x_minus_t_y_d7[23], t_x_minus_t_y_d7[22:0]};
    wire [23:0] add_f24_ftz_unit_copy3_b_choice_3 = add_f24_ftz_unit_copy3_phase_copy2[1] ? add_f24_ftz_unit_copy3_b_choice : add_f24_ftz_unit_copy3_b_choice_2;
    wire [23:0] add_f24_ftz_unit_copy3_b_choice_4 = add_f24_ftz_unit_copy3_phase_copy2[0] ? t_y_d1 : center_x_minus_t_x_d4;
    wire [23:0] minus_filter_radius = {~filter_radius[23], filter_radius[22:0]};
    wire [23:0] add_f24_ftz_unit_copy3_b_choice_5 = add_f24_ftz_unit_copy3_phase_copy2[0] ? minus_filter_radius : first_y_joined_d1;
    wire [23:0] add_f24_ftz_unit_copy3_b_choice_6 = add_f24_ftz_unit_copy3_phase_copy2[1] ? add_f24_ftz_unit_copy3_b_choice_4 : add_f24_ftz_unit_copy3_b_choice_5;
    wire [23:0] add_f24_ftz_unit_copy4_a_choice = add_f24_ftz_unit_copy4_phase[0] ? mul_f24_ftz_unit_copy4_y : filter_radius;
    wire [23:0] add_f24_ftz_unit_copy4_a_choice_2 = add_f24_ftz_unit_copy4_phase[0] ? center_y_minus_t_y_d3 : middle_depth_d2;
    wire [23:0] add_f24_ftz_unit_copy4_a_choice_3 = add_f24_ftz_unit_copy4_phase[1] ? add_f24_ftz_unit_copy4_a_choice : add_f24_ftz_unit_copy4_a_choice_2;
    wire [23:0] add_f24_ftz_unit_copy4_a_choice_4 = add_f24_ftz_unit_copy4_phase[0] ? minus_filter_radius : filter_radius;
    wire [23:0] add_f24_ftz_unit_copy4_a_choice_5 = add_f24_ftz_unit_copy4_phase[1] ? (add_f24_ftz_unit_copy4_phase[0] ? t_x_d1 : center_y_d6) : add_f24_ftz_unit_copy4_a_choice_4;
    wire [23:0] add_f24_ftz_unit_copy4_b_choice = add_f24_ftz_unit_copy4_phase_copy2[0] ? first_sum_sum_d1_copy2 : center_x_d8;
    wire [23:0] add_f24_ftz_unit_copy4_b_choice_2 = add_f24_ftz_unit_copy4_phase_copy2[0] ? minus_sqrt_f24_ftz_unit_y : {~epsilon_d1[23], epsilon_d1[22:0]};
    wire [23:0] add_f24_ftz_unit_copy4_b_choice_3 = add_f24_ftz_unit_copy4_phase_copy2[1] ? add_f24_ftz_unit_copy4_b_choice : add_f24_ftz_unit_copy4_b_choice_2;
    wire [23:0] add_f24_ftz_unit_copy4_b_choice_4 = add_f24_ftz_unit_copy4_phase_copy2[1] ? minus_t_y_d1 : center_y_d9;
    wire [23:0] add_f24_ftz_unit_copy5_a_choice = add_f24_ftz_unit_copy5_phase[0] ? mul_f24_ftz_unit_copy4_y : origin_y;
    wire [23:0] add_f24_ftz_unit_copy5_a_choice_2 = add_f24_ftz_unit_copy5_phase[0] ? sqrt_f24_ftz_unit_y : middle_depth_d2;
    wire [23:0] add_f24_ftz_unit_copy5_a_choice_3 = add_f24_ftz_unit_copy5_phase[1] ? add_f24_ftz_unit_copy5_a_choice : add_f24_ftz_unit_copy5_a_choice_2;
    wire [23:0] add_f24_ftz_unit_copy5_a_choice_4 = add_f24_ftz_unit_copy5_phase[0] ? root_of_first_sum_sum_d1 : h_x_sum_d1_copy2;
    wire [23:0] add_f24_ftz_unit_copy5_a_choice_5 = add_f24_ftz_unit_copy5_phase[0] ? delay_6_from_2_out : unit_delta_product_d1;
    wire [23:0] add_f24_ftz_unit_copy5_a_choice_6 = add_f24_ftz_unit_copy5_phase[1] ? add_f24_ftz_unit_copy5_a_choice_4 : add_f24_ftz_unit_copy5_a_choice_5;
    wire [23:0] add_f24_ftz_unit_copy5_b_choice = add_f24_ftz_unit_copy5_phase_copy2[0] ? {~first_sum_sum_d1_copy2[23], first_sum_sum_d1_copy2[22:0]} : first_y_joined_d1_copy2;
    wire [23:0] add_f24_ftz_unit_copy5_b_choice_2 = add_f24_ftz_unit_copy5_phase_copy2[0] ? center_y_minus_t_y_d3 : epsilon_d1;
    wire [23:0] add_f24_ftz_unit_copy5_b_choice_3 = add_f24_ftz_unit_copy5_phase_copy2[1] ? add_f24_ftz_unit_copy5_b_choice : add_f24_ftz_unit_copy5_b_choice_2;
    wire [23:0] add_f24_ftz_unit_copy5_b_choice_4 = add_f24_ftz_unit_copy5_phase_copy2[0] ? {~t_x_plus_t_y_d7[23], t_x_plus_t_y_d7[22:0]} : mul_mul_add_f24_ftz_unit_y;
    wire [23:0] add_f24_ftz_unit_copy5_b_choice_5 = add_f24_ftz_unit_copy5_phase_copy2[0] ? sqrt_f24_ftz_unit_y : minus_unit_delta_product_d1;
    wire [23:0] add_f24_ftz_unit_copy5_b_choice_6 = add_f24_ftz_unit_copy5_phase_copy2[1] ? add_f24_ftz_unit_copy5_b_choice_4 : add_f24_ftz_unit_copy5_b_choice_5;
    wire [23:0] f_chosen = whole_d1 ? e_d1 : delay_6_from_5_out;
    wire [23:0] mul_f24_ftz_unit_a_choice = mul_f24_ftz_unit_phase[0] ? f_times_scale_y_d1 : f_times_scale_x_d1;
    wire [23:0] mul_f24_ftz_unit_a_choice_2 = mul_f24_ftz_unit_phase[1] ? mul_f24_ftz_unit_a_choice : mul_f24_ftz_unit_phase[0] ? f_d1 : r_d1;
    wire [23:0] mul_f24_ftz_unit_a_choice_3 = mul_f24_ftz_unit_phase[0] ? one_minus_depth_a_d1 : unit_delta_joined_d1;
    wire [23:0] mul_f24_ftz_unit_a_choice_4 = mul_f24_ftz_unit_phase[1] ? (mul_f24_ftz_unit_phase[0] ? alpha_joined_d2 : b_depth_d6) : mul_f24_ftz_unit_a_choice_3;
    wire [23:0] mul_f24_ftz_unit_b_choice = mul_f24_ftz_unit_phase_copy2[0] ? delay_9_from_0_out : delay_9_from_7_out;
    wire [23:0] mul_f24_ftz_unit_b_choice_2 = mul_f24_ftz_unit_phase_copy2[1] ? mul_f24_ftz_unit_b_choice : mul_f24_ftz_unit_phase_copy2[0] ? root_of_q_d1 : depth_b;
    wire [23:0] mul_f24_ftz_unit_b_choice_3 = mul_f24_ftz_unit_phase_copy2[0] ? recip_f24_ftz_unit_y : mul_f24_ftz_unit_copy2_y;
    wire [23:0] mul_f24_ftz_unit_b_choice_4 = mul_f24_ftz_unit_phase_copy2[0] ? before_far_sum_d1 : unit_delta_joined_d1_copy4;
    wire [23:0] mul_f24_ftz_unit_b_choice_5 = mul_f24_ftz_unit_phase_copy2[1] ? mul_f24_ftz_unit_b_choice_3 : mul_f24_ftz_unit_b_choice_4;
    wire [23:0] abs_b_depth_d7 = delay_7_from_2_out[23:0];
    wire [23:0] mul_f24_ftz_unit_copy2_a_choice = mul_f24_ftz_unit_copy2_phase[1] ? scale_y : mul_f24_ftz_unit_copy2_phase[0] ? abs_b_depth_d7 : q_d4;
    wire [23:0] mul_f24_ftz_unit_copy2_a_choice_2 = mul_f24_ftz_unit_copy2_phase[0] ? scale_y : unit_delta_joined_d1_copy2;
    wire [23:0] mul_f24_ftz_unit_copy2_a_choice_3 = mul_f24_ftz_unit_copy2_phase[1] ? (mul_f24_ftz_unit_copy2_phase[0] ? beta_joined_d2 : half_depth_d1) : mul_f24_ftz_unit_copy2_a_choice_2;
    wire [23:0] mul_f24_ftz_unit_copy2_b_choice = mul_f24_ftz_unit_copy2_phase_copy2[0] ? mul_mul_add_f24_ftz_unit_copy2_y : mul_mul_add_f24_ftz_unit_y;
    wire [23:0] mul_f24_ftz_unit_copy2_b_choice_2 = mul_f24_ftz_unit_copy2_phase_copy2[0] ? f_times_root_of_q_d1 : recip_f24_ftz_unit_y;
    wire [23:0] mul_f24_ftz_unit_copy2_b_choice_3 = mul_f24_ftz_unit_copy2_phase_copy2[1] ? mul_f24_ftz_unit_copy2_b_choice : mul_f24_ftz_unit_copy2_b_choice_2;
    wire [23:0] mul_f24_ftz_unit_copy2_b_choice_4 = mul_f24_ftz_unit_copy2_phase_copy2[0] ? recip_f24_ftz_unit_y : epsilon_scale;
    wire [23:0] mul_f24_ftz_unit_copy2_b_choice_5 = mul_f24_ftz_unit_copy2_phase_copy2[0] ? mul_f24_ftz_unit_copy4_y : unit_delta_joined_d1_copy3;
    wire [23:0] mul_f24_ftz_unit_copy2_b_choice_6 = mul_f24_ftz_unit_copy2_phase_copy2[1] ? mul_f24_ftz_unit_copy2_b_choice_4 : mul_f24_ftz_unit_copy2_b_choice_5;
    wire [23:0] mul_f24_ftz_unit_copy3_a_choice = mul_f24_ftz_unit_copy3_phase[1] ? (mul_f24_ftz_unit_copy3_phase[0] ? delta_d1 : scale_x) : mul_f24_ftz_unit_copy3_phase[0] ? scale_x : recip_f24_ftz_unit_y;
    wire [23:0] mul_f24_ftz_unit_copy3_a_choice_2 = mul_f24_ftz_unit_copy3_phase[1] ? v_x_chosen_d3 : mul_f24_ftz_unit_copy3_phase[0] ? scale_x : filter_radius;
    wire [23:0] mul_f24_ftz_unit_copy3_b_choice = mul_f24_ftz_unit_copy3_phase_copy2[0] ? recip_f24_ftz_unit_y : mul_mul_add_f24_ftz_unit_copy2_y;
    wire [23:0] mul_f24_ftz_unit_copy3_b_choice_2 = mul_f24_ftz_unit_copy3_phase_copy2[0] ? mul_mul_add_f24_ftz_unit_copy2_y : t_x_sum_d2;
    wire [23:0] mul_f24_ftz_unit_copy3_b_choice_3 = mul_f24_ftz_unit_copy3_phase_copy2[1] ? mul_f24_ftz_unit_copy3_b_choice : mul_f24_ftz_unit_copy3_b_choice_2;
    wire [23:0] mul_f24_ftz_unit_copy3_b_choice_4 = mul_f24_ftz_unit_copy3_phase_copy2[0] ? mul_f24_ftz_unit_copy3_y : 24'h3fb600;
    wire [23:0] mul_f24_ftz_unit_copy3_b_choice_5 = mul_f24_ftz_unit_copy3_phase_copy2[1] ? recip_f24_ftz_unit_y : mul_f24_ftz_unit_copy3_b_choice_4;
    wire [23:0] mul_f24_ftz_unit_copy4_a_choice = mul_f24_ftz_unit_copy4_phase[0] ? delta_times_one_over_b_depth_d1 : f_d1;
    wire [23:0] mul_f24_ftz_unit_copy4_a_choice_2 = mul_f24_ftz_unit_copy4_phase[1] ? mul_f24_ftz_unit_copy4_a_choice : mul_f24_ftz_unit_copy4_phase[0] ? f_d1 : recip_f24_ftz_unit_y;
    wire [23:0] mul_f24_ftz_unit_copy4_a_choice_3 = mul_f24_ftz_unit_copy4_phase[0] ? 24'h3f8008 : delay_7_from_0_out;
    wire [23:0] mul_f24_ftz_unit_copy4_a_choice_4 = mul_f24_ftz_unit_copy4_phase[1] ? v_y_chosen_d3 : mul_f24_ftz_unit_copy4_a_choice_3;
    wire [23:0] sight_near_out_joined = {not_depth_a_sign, depth_a[22:0]};
    wire [23:0] mul_f24_ftz_unit_copy4_b_choice = mul_f24_ftz_unit_copy4_phase_copy2[0] ? sight_near_out_joined : scale_y;
    wire [23:0] mul_f24_ftz_unit_copy4_b_choice_2 = mul_f24_ftz_unit_copy4_phase_copy2[1] ? mul_f24_ftz_unit_copy4_b_choice : mul_f24_ftz_unit_copy4_phase_copy2[0] ? scale_x : t_y_sum_d1;
    wire [23:0] mul_f24_ftz_unit_copy4_b_choice_3 = mul_f24_ftz_unit_copy4_phase_copy2[0] ? add_f24_ftz_unit_copy5_y : delta_times_one_over_b_depth_d1;
    wire [23:0] mul_f24_ftz_unit_copy4_b_choice_4 = mul_f24_ftz_unit_copy4_phase_copy2[1] ? recip_f24_ftz_unit_y : mul_f24_ftz_unit_copy4_b_choice_3;
    wire [23:0] mul_mul_add_f24_ftz_unit_a_choice = mul_mul_add_f24_ftz_unit_phase[0] ? unit_delta_joined_d2 : t_y_d1;
    wire [23:0] mul_mul_add_f24_ftz_unit_a_choice_2 = mul_mul_add_f24_ftz_unit_phase[1] ? mul_mul_add_f24_ftz_unit_a_choice : mul_mul_add_f24_ftz_unit_phase[0] ? a_y_d1 : alpha_d3;
    wire [23:0] mul_mul_add_f24_ftz_unit_a_choice_3 = mul_mul_add_f24_ftz_unit_phase[0] ? mul_f24_ftz_unit_y : alpha_d3;
    wire [23:0] mul_mul_add_f24_ftz_unit_a_choice_4 = mul_mul_add_f24_ftz_unit_phase[1] ? (mul_mul_add_f24_ftz_unit_phase[0] ? t_x_d1 : a_y_joined_d3) : mul_mul_add_f24_ftz_unit_a_choice_3;
    wire [23:0] mul_mul_add_f24_ftz_unit_b_choice = mul_mul_add_f24_ftz_unit_phase_copy2[1] ? (mul_mul_add_f24_ftz_unit_phase_copy2[0] ? mx_joined_d1 : t_y_d1) : mul_mul_add_f24_ftz_unit_phase_copy2[0] ? a_y_d1 : a_x_d1;
    wire [23:0] mul_mul_add_f24_ftz_unit_b_choice_2 = mul_mul_add_f24_ftz_unit_phase_copy2[0] ? mul_f24_ftz_unit_y : a_y_d1;
    wire [23:0] mul_mul_add_f24_ftz_unit_b_choice_3 = mul_mul_add_f24_ftz_unit_phase_copy2[1] ? (mul_mul_add_f24_ftz_unit_phase_copy2[0] ? t_x_d1 : r_d1) : mul_mul_add_f24_ftz_unit_b_choice_2;
    wire [23:0] mul_mul_add_f24_ftz_unit_c_bits = {~unit_delta_joined_d1_copy4[23], unit_delta_joined_d1_copy4[22:0]};
    wire [23:0] mul_mul_add_f24_ftz_unit_c_choice = mul_mul_add_f24_ftz_unit_phase_copy3[0] ? mul_mul_add_f24_ftz_unit_c_bits : f_d2;
    wire [23:0] mul_mul_add_f24_ftz_unit_c_choice_2 = mul_mul_add_f24_ftz_unit_phase_copy3[0] ? mul_f24_ftz_unit_copy2_y : beta_d3;
    wire [23:0] mul_mul_add_f24_ftz_unit_c_choice_3 = mul_mul_add_f24_ftz_unit_phase_copy3[1] ? mul_mul_add_f24_ftz_unit_c_choice : mul_mul_add_f24_ftz_unit_c_choice_2;
    wire [23:0] mul_mul_add_f24_ftz_unit_c_choice_4 = mul_mul_add_f24_ftz_unit_phase_copy3[0] ? f_d1 : {~alpha_d1[23], alpha_d1[22:0]};
    wire [23:0] mul_mul_add_f24_ftz_unit_c_choice_5 = mul_mul_add_f24_ftz_unit_phase_copy3[1] ? mul_mul_add_f24_ftz_unit_c_choice_4 : mul_mul_add_f24_ftz_unit_c_choice_2;
    wire [23:0] mul_mul_add_f24_ftz_unit_d_choice = mul_mul_add_f24_ftz_unit_phase_copy4[0] ? mx_joined_d1_copy2 : h_y_sum_d3;
    wire [23:0] mul_mul_add_f24_ftz_unit_d_choice_2 = mul_mul_add_f24_ftz_unit_phase_copy4[0] ? mul_f24_ftz_unit_copy2_y : mul_f24_ftz_unit_copy3_y;
    wire [23:0] mul_mul_add_f24_ftz_unit_d_choice_3 = mul_mul_add_f24_ftz_unit_phase_copy4[1] ? mul_mul_add_f24_ftz_unit_d_choice : mul_mul_add_f24_ftz_unit_d_choice_2;
    wire [23:0] mul_mul_add_f24_ftz_unit_d_choice_4 = mul_mul_add_f24_ftz_unit_phase_copy4[0] ? mul_f24_ftz_unit_copy2_y : b_y_d1;
    wire [23:0] mul_mul_add_f24_ftz_unit_d_choice_5 = mul_mul_add_f24_ftz_unit_phase_copy4[1] ? (mul_mul_add_f24_ftz_unit_phase_copy4[0] ? h_x_sum_d3 : v_y_d1) : mul_mul_add_f24_ftz_unit_d_choice_4;
    wire [23:0] mul_mul_add_f24_ftz_unit_copy2_a_choice = mul_mul_add_f24_ftz_unit_copy2_phase[1] ? (mul_mul_add_f24_ftz_unit_copy2_phase[0] ? t_x_d1 : a_x_d1) : a_x_d1;
    wire [23:0] mul_mul_add_f24_ftz_unit_copy2_a_choice_2 = mul_mul_add_f24_ftz_unit_copy2_phase[0] ? b_y_joined_d3 : b_x_joined_d3;
    wire [23:0] mul_mul_add_f24_ftz_unit_copy2_a_choice_3 = mul_mul_add_f24_ftz_unit_copy2_phase[0] ? a_x_joined_d3 : unit_delta_joined_d2_copy2;
    wire [23:0] mul_mul_add_f24_ftz_unit_copy2_a_choice_4 = mul_mul_add_f24_ftz_unit_copy2_phase[1] ? mul_mul_add_f24_ftz_unit_copy2_a_choice_2 : mul_mul_add_f24_ftz_unit_copy2_a_choice_3;
    wire [23:0] mul_mul_add_f24_ftz_unit_copy2_b_choice = mul_mul_add_f24_ftz_unit_copy2_phase_copy2[1] ? (mul_mul_add_f24_ftz_unit_copy2_phase_copy2[0] ? t_y_d1 : a_y_d1) : a_x_d1;
    wire [23:0] mul_mul_add_f24_ftz_unit_copy2_b_choice_2 = mul_mul_add_f24_ftz_unit_copy2_phase_copy2[0] ? r_d1 : mx_joined_d1_copy2;
    wire [23:0] mul_mul_add_f24_ftz_unit_copy2_b_choice_3 = mul_mul_add_f24_ftz_unit_copy2_phase_copy2[1] ? r_d1 : mul_mul_add_f24_ftz_unit_copy2_b_choice_2;
    wire [23:0] mul_mul_add_f24_ftz_unit_copy2_c_choice = mul_mul_add_f24_ftz_unit_copy2_phase_copy3[1] ? (mul_mul_add_f24_ftz_unit_copy2_phase_copy3[0] ? f_d2 : b_x_d1) : mul_f24_ftz_unit_copy3_y;
    wire [23:0] minus_beta_d1 = {~beta_d1[23], beta_d1[22:0]};
    wire [23:0] mul_mul_add_f24_ftz_unit_copy2_c_choice_2 = mul_mul_add_f24_ftz_unit_copy2_phase_copy3[0] ? minus_beta_d1 : minus_beta_d1;
    wire [23:0] mul_mul_add_f24_ftz_unit_copy2_c_choice_3 = mul_mul_add_f24_ftz_unit_copy2_phase_copy3[0] ? {~mul_f24_ftz_unit_y[23], mul_f24_ftz_unit_y[22:0]} : minus_unit_delta_joined_d1;
    wire [23:0] mul_mul_add_f24_ftz_unit_copy2_c_choice_4 = mul_mul_add_f24_ftz_unit_copy2_phase_copy3[1] ? mul_mul_add_f24_ftz_unit_copy2_c_choice_2 : mul_mul_add_f24_ftz_unit_copy2_c_choice_3;
    wire [23:0] mul_mul_add_f24_ftz_unit_copy2_d_choice = mul_mul_add_f24_ftz_unit_copy2_phase_copy4[0] ? first_sum_sum_d3 : b_y_d1;
    wire [23:0] mul_mul_add_f24_ftz_unit_copy2_d_choice_2 = mul_mul_add_f24_ftz_unit_copy2_phase_copy4[1] ? mul_mul_add_f24_ftz_unit_copy2_d_choice : mul_f24_ftz_unit_copy3_y;
    wire [23:0] mul_mul_add_f24_ftz_unit_copy2_d_choice_3 = mul_mul_add_f24_ftz_unit_copy2_phase_copy4[0] ? mul_f24_ftz_unit_copy3_y : mx_joined_d1;
    wire [23:0] mul_mul_add_f24_ftz_unit_copy2_d_choice_4 = mul_mul_add_f24_ftz_unit_copy2_phase_copy4[1] ? (mul_mul_add_f24_ftz_unit_copy2_phase_copy4[0] ? v_y_d1 : v_x_d1) : mul_mul_add_f24_ftz_unit_copy2_d_choice_3;
    wire [23:0] sqrt_f24_ftz_unit_a_choice = sqrt_f24_ftz_unit_phase[0] ? mul_mul_add_f24_ftz_unit_y : add_f24_ftz_unit_copy4_y;
    wire [23:0] sqrt_f24_ftz_unit_a_choice_2 = sqrt_f24_ftz_unit_phase[1] ? (sqrt_f24_ftz_unit_phase[0] ? q_d1 : mul_mul_add_f24_ftz_unit_y) : first_difference_sum_d1;
    wire [23:0] min_f24_ftz_unit_a_choice = min_f24_ftz_unit_phase[1] ? (min_f24_ftz_unit_phase[0] ? 24'h470000 : 24'h45fff8) : first_y_chosen_d1_copy2;
    wire [23:0] min_f24_ftz_unit_a_choice_2 = min_f24_ftz_unit_phase[1] ? (min_f24_ftz_unit_phase[0] ? first_x_chosen_d1_copy2 : 24'h3f8000) : min_f24_ftz_unit_phase[0] ? 24'h45fff8 : 24'h470000;
    wire [23:0] min_f24_ftz_unit_b_choice = min_f24_ftz_unit_phase_copy2[0] ? first_sum_chosen_d1 : last_x_chosen_d1_copy3;
    wire [23:0] min_f24_ftz_unit_b_choice_2 = min_f24_ftz_unit_phase_copy2[1] ? min_f24_ftz_unit_b_choice : center_y_minus_filter_radius_d1;
    wire [23:0] min_f24_ftz_unit_b_choice_3 = min_f24_ftz_unit_phase_copy2[0] ? center_x_minus_filter_radius_d1 : {1'd0, mul_f24_ftz_unit_y[22:0]};
    wire [23:0] min_f24_ftz_unit_b_choice_4 = min_f24_ftz_unit_phase_copy2[0] ? last_y_chosen_d1_copy3 : last_sum_chosen_d1;
    wire [23:0] min_f24_ftz_unit_b_choice_5 = min_f24_ftz_unit_phase_copy2[1] ? min_f24_ftz_unit_b_choice_3 : min_f24_ftz_unit_b_choice_4;
    wire [23:0] to_fixed_f24_ftz_s17q16_unit_a_choice = to_fixed_f24_ftz_s17q16_unit_phase[0] ? my_out_joined_d1 : mx_out_joined_d1;
    wire [23:0] to_fixed_f24_ftz_s17q16_unit_a_choice_2 = to_fixed_f24_ftz_s17q16_unit_phase[0] ? by_out_joined_d1 : ay_out_joined_d1;
    wire [23:0] to_fixed_f24_ftz_s17q16_unit_a_choice_3 = to_fixed_f24_ftz_s17q16_unit_phase[0] ? bx_out_joined_d1 : ax_out_joined_d1;
    wire [23:0] to_fixed_f24_ftz_s17q16_unit_a_choice_4 = to_fixed_f24_ftz_s17q16_unit_phase[1] ? to_fixed_f24_ftz_s17q16_unit_a_choice_2 : to_fixed_f24_ftz_s17q16_unit_a_choice_3;
    wire sight_near_out_bits_d9_copy3 = delay_9_from_5_out[93];
    wire [22:0] sight_near_out_chosen_copy4 = sight_near_out_either_d1 ? sight_near_out_joined_d1 : 23'd0;
    wire [23:0] to_fixed_f24_ftz_u24q24_unit_a_choice = to_fixed_f24_ftz_u24q24_unit_phase[0] ? max_f24_ftz_unit_copy2_y : depth_low_out_greater_d1;
    wire [23:0] first_y_chosen_copy5 = lt_f24_ftz_unit_copy8_y ? center_y_minus_first_y_joined_d1 : center_y_plus_first_y_joined_d1;
    wire visible_unequal_d9 = delay_9_from_5_out[26];
    wire visible_unequal_copy3 = sight_negative_out_d1 ^ visible_unequal_d9;
    wire edge_on_or_visible_unequal = edge_on | visible_unequal_copy3;
    wire last_y_chosen = scale_y[23] ? first_y_in_order_d1_copy3 : lt_f24_ftz_unit_copy9_y;
    wire first_y_chosen_copy7 = scale_y[23] ? lt_f24_ftz_unit_copy9_y : first_y_in_order_d1_copy3;
    wire [25:0] center_y_out = placed_d2 ? center_y_out_lesser_d1 : 26'h2000000;
    wire [25:0] center_x_out = placed_d2 ? center_x_out_lesser_d1 : 26'h2000000;
    wire before_far_both = not_turned_d5 & le_f24_ftz_unit_copy2_y;
    wire sight_disc_out = beyond_near_and_not_turned_d4 & before_far_both;
    wire before_far = before_far_both | before_far_in_order_d1;
    wire [26:0] first_difference_difference_bits = {{5{center_x_fixed_d1[21]}}, center_x_fixed_d1};
    wire [26:0] first_difference_difference_bits_2 = {{5{to_fixed_f24_ftz_s22q8_unit_y[21]}}, to_fixed_f24_ftz_s22q8_unit_y};
    wire [26:0] first_difference_difference = first_difference_difference_bits - first_difference_difference_bits_2;
    wire [26:0] first_sum_sum_copy2 = first_difference_difference_bits + first_difference_difference_bits_2;
    wire [10:0] delay_8_from_5_data_bits = {3'd0, mul_f24_ftz_unit_copy4_y[22:15]};
    wire zero_is_sight_near_out_bits = 11'd0 == delay_8_from_5_data_bits;
    wire sight_near_out_inverted = ~zero_is_sight_near_out_bits;
    wire visible_unequal = scale_x[23] ^ scale_y[23];
    wire swapped_and_turned = swapped_d1 & turned;
    wire visible_unequal_copy2 = visible_unequal ^ swapped_and_turned;
    wire turned_and_lowered_chosen_sign = turned & lowered_chosen_copy5[23];
    wire [23:0] half_depth_chosen = beyond_near_and_not_turned_d4 ? min_f24_ftz_unit_y : 24'h3f8000;
    wire all_before_far = delay_6_from_6_out & le_f24_ftz_unit_copy4_y;
    wire sight_far_out_same = zero_is_sight_near_out_bits;
    wire not_sight_far_out_same = ~sight_far_out_same;
    wire odd_or_edge_on_or_not_placed = odd_d1 | edge_on_or_not_placed_d2;
    wire zero_is_my_bits = 10'd0 == my_bits_d1;
    wire not_zero_is_my_bits = ~zero_is_my_bits;
    wire zero_is_mx_bits = 10'd0 == mx_bits_d1;
    wire not_zero_is_mx_bits = ~zero_is_mx_bits;
    wire zero_is_exponent_joined_bits_copy2 = 10'd0 == exponent_joined_bits_d1_copy2;
    wire by_out_inverted = ~zero_is_exponent_joined_bits_copy2;
    wire zero_is_exponent_joined_bits = 10'd0 == exponent_joined_bits_d1;
    wire bx_out_inverted = ~zero_is_exponent_joined_bits;
    wire zero_is_delta_bits = 10'd0 == delta_bits_d1;
    wire not_zero_is_delta_bits = ~zero_is_delta_bits;
    wire whole_and_first_sum_both = whole & first_sum_both_d1;
    wire [23:0] first_x_chosen_copy5 = lt_f24_ftz_unit_copy6_y ? center_x_minus_first_x_joined_d1 : center_x_plus_first_x_joined_d1;
    wire last_x_chosen = scale_x[23] ? lt_f24_ftz_unit_copy6_y : lt_f24_ftz_unit_copy7_y;
    wire first_x_chosen_copy7 = scale_x[23] ? lt_f24_ftz_unit_copy7_y : lt_f24_ftz_unit_copy6_y;
    wire reaches_near = beyond_near_d2 | lt_f24_ftz_unit_copy4_y;

    assign {out_end, out_center_x, out_center_y, out_ax, out_bx, out_ay, out_by} = queue_1_out_data;
    assign {
        out_delta, out_mx, out_my, out_shift, out_sight_negative, out_sight_near, out_sight_far,
        out_sight_turned, out_sight_disc, out_depth
    } = queue_2_out_data;
    assign {
        out_depth_low, out_depth_high, out_attribute_0, out_attribute_1, out_attribute_2, out_left, out_right,
        out_top, out_bottom
    } = queue_3_out_data;
    assign {out_first_sum, out_last_sum, out_first_difference, out_last_difference} = queue_4_out_data;

    float_max_s2_f24ftz max_f24_ftz_unit (
        .clk(clk), .enable(1'd1), .a(max_f24_ftz_unit_a), .b(max_f24_ftz_unit_b), .y(max_f24_ftz_unit_y)
    );

    float_max_s2_f24ftz max_f24_ftz_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(max_f24_ftz_unit_copy2_a), .b(max_f24_ftz_unit_copy2_b),
        .y(max_f24_ftz_unit_copy2_y)
    );

    float_lt_s2_f24ftz lt_f24_ftz_unit (
        .clk(clk), .enable(1'd1), .a(near_plane), .b(in_center_z), .y(lt_f24_ftz_unit_y)
    );

    float_lt_s2_f24ftz lt_f24_ftz_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(lt_f24_ftz_unit_copy2_a_bits), .b(lt_f24_ftz_unit_copy2_b_bits),
        .y(lt_f24_ftz_unit_copy2_y)
    );

    float_lt_s2_f24ftz lt_f24_ftz_unit_copy3 (
        .clk(clk), .enable(1'd1), .a(center_z_d1), .b(max_f24_ftz_unit_copy2_y), .y(lt_f24_ftz_unit_copy3_y)
    );

    float_lt_s2_f24ftz lt_f24_ftz_unit_copy4 (
        .clk(clk), .enable(1'd1), .a(near_plane), .b(add_f24_ftz_unit_y), .y(lt_f24_ftz_unit_copy4_y)
    );

    float_lt_s2_f24ftz lt_f24_ftz_unit_copy5 (
        .clk(clk), .enable(1'd1), .a(24'h3d0000), .b(add_f24_ftz_unit_y), .y(lt_f24_ftz_unit_copy5_y)
    );

    float_lt_s2_f24ftz lt_f24_ftz_unit_copy6 (
        .clk(clk), .enable(1'd1), .a(24'd0), .b(add_f24_ftz_unit_copy2_y), .y(lt_f24_ftz_unit_copy6_y)
    );

    float_lt_s2_f24ftz lt_f24_ftz_unit_copy7 (
        .clk(clk), .enable(1'd1), .a(add_f24_ftz_unit_copy3_y), .b(24'd0), .y(lt_f24_ftz_unit_copy7_y)
    );

    float_lt_s2_f24ftz lt_f24_ftz_unit_copy8 (
        .clk(clk), .enable(1'd1), .a(24'd0), .b(add_f24_ftz_unit_copy3_y), .y(lt_f24_ftz_unit_copy8_y)
    );

    float_lt_s2_f24ftz lt_f24_ftz_unit_copy9 (
        .clk(clk), .enable(1'd1), .a(add_f24_ftz_unit_copy3_y), .b(24'd0), .y(lt_f24_ftz_unit_copy9_y)
    );

    float_add_s6_f24ftz add_f24_ftz_unit (
        .clk(clk), .enable(1'd1), .a(add_f24_ftz_unit_a), .b(add_f24_ftz_unit_b), .y(add_f24_ftz_unit_y)
    );

    float_add_s6_f24ftz add_f24_ftz_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(add_f24_ftz_unit_copy2_a), .b(add_f24_ftz_unit_copy2_b),
        .y(add_f24_ftz_unit_copy2_y)
    );

    float_add_s6_f24ftz add_f24_ftz_unit_copy3 (
        .clk(clk), .enable(1'd1), .a(add_f24_ftz_unit_copy3_a), .b(add_f24_ftz_unit_copy3_b),
        .y(add_f24_ftz_unit_copy3_y)
    );

    float_add_s6_f24ftz add_f24_ftz_unit_copy4 (
        .clk(clk), .enable(1'd1), .a(add_f24_ftz_unit_copy4_a), .b(add_f24_ftz_unit_copy4_b),
        .y(add_f24_ftz_unit_copy4_y)
    );

    float_add_s6_f24ftz add_f24_ftz_unit_copy5 (
        .clk(clk), .enable(1'd1), .a(add_f24_ftz_unit_copy5_a), .b(add_f24_ftz_unit_copy5_b),
        .y(add_f24_ftz_unit_copy5_y)
    );

    float_recip_s20_f24ftz recip_f24_ftz_unit (
        .clk(clk), .enable(1'd1), .a(recip_f24_ftz_unit_a), .y(recip_f24_ftz_unit_y)
    );

    float_mul_s5_f24ftz mul_f24_ftz_unit (
        .clk(clk), .enable(1'd1), .a(mul_f24_ftz_unit_a), .b(mul_f24_ftz_unit_b), .y(mul_f24_ftz_unit_y)
    );

    float_mul_s5_f24ftz mul_f24_ftz_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(mul_f24_ftz_unit_copy2_a), .b(mul_f24_ftz_unit_copy2_b),
        .y(mul_f24_ftz_unit_copy2_y)
    );

    float_mul_s5_f24ftz mul_f24_ftz_unit_copy3 (
        .clk(clk), .enable(1'd1), .a(mul_f24_ftz_unit_copy3_a), .b(mul_f24_ftz_unit_copy3_b),
        .y(mul_f24_ftz_unit_copy3_y)
    );

    float_mul_s5_f24ftz mul_f24_ftz_unit_copy4 (
        .clk(clk), .enable(1'd1), .a(mul_f24_ftz_unit_copy4_a), .b(mul_f24_ftz_unit_copy4_b),
        .y(mul_f24_ftz_unit_copy4_y)
    );

    mul_mul_add_p5_s6_f24ftz mul_mul_add_f24_ftz_unit (
        .clk(clk), .enable(1'd1), .a(mul_mul_add_f24_ftz_unit_a), .b(mul_mul_add_f24_ftz_unit_b),
        .c(mul_mul_add_f24_ftz_unit_c), .d(mul_mul_add_f24_ftz_unit_d), .y(mul_mul_add_f24_ftz_unit_y)
    );

    mul_mul_add_p5_s6_f24ftz mul_mul_add_f24_ftz_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(mul_mul_add_f24_ftz_unit_copy2_a), .b(mul_mul_add_f24_ftz_unit_copy2_b),
        .c(mul_mul_add_f24_ftz_unit_copy2_c), .d(mul_mul_add_f24_ftz_unit_copy2_d),
        .y(mul_mul_add_f24_ftz_unit_copy2_y)
    );

    float_sqrt_s18_f24ftz sqrt_f24_ftz_unit (
        .clk(clk), .enable(1'd1), .a(sqrt_f24_ftz_unit_a), .y(sqrt_f24_ftz_unit_y)
    );

    float_le_s2_f24ftz le_f24_ftz_unit (
        .clk(clk), .enable(1'd1), .a(24'd0), .b(add_f24_ftz_unit_copy2_y), .y(le_f24_ftz_unit_y)
    );

    float_le_s2_f24ftz le_f24_ftz_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(add_f24_ftz_unit_y), .b(24'h3f8000), .y(le_f24_ftz_unit_copy2_y)
    );

    float_le_s2_f24ftz le_f24_ftz_unit_copy3 (
        .clk(clk), .enable(1'd1), .a(depth_b), .b(before_far_joined_d1), .y(le_f24_ftz_unit_copy3_y)
    );

    float_le_s2_f24ftz le_f24_ftz_unit_copy4 (
        .clk(clk), .enable(1'd1), .a(add_f24_ftz_unit_copy2_y), .b(24'h3f8000), .y(le_f24_ftz_unit_copy4_y)
    );

    float_min_s2_f24ftz min_f24_ftz_unit (
        .clk(clk), .enable(1'd1), .a(min_f24_ftz_unit_a), .b(min_f24_ftz_unit_b), .y(min_f24_ftz_unit_y)
    );

    float_min_s2_f24ftz min_f24_ftz_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(min_f24_ftz_unit_copy2_a), .b(min_f24_ftz_unit_copy2_b),
        .y(min_f24_ftz_unit_copy2_y)
    );

    float_to_fixed_s3_f24ftz_w21_f8_unsigned to_fixed_f24_ftz_u21q8_unit (
        .clk(clk), .enable(1'd1), .a(to_fixed_f24_ftz_u21q8_unit_a), .y(to_fixed_f24_ftz_u21q8_unit_y)
    );

    float_to_fixed_s3_f24ftz_w23_f8_unsigned to_fixed_f24_ftz_u23q8_unit (
        .clk(clk), .enable(1'd1), .a(to_fixed_f24_ftz_u23q8_unit_a), .y(to_fixed_f24_ftz_u23q8_unit_y)
    );

    float_to_fixed_s3_f24ftz_w22_f8_signed to_fixed_f24_ftz_s22q8_unit (
        .clk(clk), .enable(1'd1), .a(to_fixed_f24_ftz_s22q8_unit_a), .y(to_fixed_f24_ftz_s22q8_unit_y)
    );

    float_to_fixed_s3_f24ftz_w27_f13_signed to_fixed_f24_ftz_s27q13_unit (
        .clk(clk), .enable(1'd1), .a(to_fixed_f24_ftz_s27q13_unit_a), .y(to_fixed_f24_ftz_s27q13_unit_y)
    );

    float_to_fixed_s3_f24ftz_w17_f16_signed to_fixed_f24_ftz_s17q16_unit (
        .clk(clk), .enable(1'd1), .a(to_fixed_f24_ftz_s17q16_unit_a), .y(to_fixed_f24_ftz_s17q16_unit_y)
    );

    float_to_fixed_s3_f24ftz_w21_f20_signed to_fixed_f24_ftz_s21q20_unit (
        .clk(clk), .enable(1'd1), .a(vanishes_joined_d1), .y(to_fixed_f24_ftz_s21q20_unit_y)
    );

    float_to_fixed_s3_f24ftz_w20_f19_unsigned to_fixed_f24_ftz_u20q19_unit (
        .clk(clk), .enable(1'd1), .a(to_fixed_f24_ftz_u20q19_unit_a), .y(to_fixed_f24_ftz_u20q19_unit_y)
    );

    float_to_fixed_s3_f24ftz_w24_f24_unsigned to_fixed_f24_ftz_u24q24_unit (
        .clk(clk), .enable(1'd1), .a(to_fixed_f24_ftz_u24q24_unit_a), .y(to_fixed_f24_ftz_u24q24_unit_y)
    );

    stream_fifo_d23_w117_distributed queue_1 (
        .clk(clk), .rst(rst), .in_valid(kept), .in_ready(queue_1_in_ready),
        .in_data({end_d22, center_x_out_d14, center_y_out_d14, ax_out, bx_out, ay_out, by_out}),
        .out_valid(out_valid), .out_ready(out_ready), .out_data(queue_1_out_data)
    );

    stream_fifo_d23_w123_distributed queue_2 (
        .clk(clk), .rst(rst), .in_valid(kept), .in_ready(queue_2_in_ready),
        .in_data({
            delta_out, mx_out, my_out, shift_d3, delay_12_from_7_out, sight_near_out, sight_far_out_d1,
            turned_d21, sight_disc_out_d16, delay_7_from_5_out
        }),
        .out_valid(queue_2_out_valid), .out_ready(out_ready), .out_data(queue_2_out_data)
    );

    stream_fifo_d23_w120_distributed queue_3 (
        .clk(clk), .rst(rst), .in_valid(kept), .in_ready(queue_3_in_ready),
        .in_data({
            depth_low_out_d3, depth_high_out_d3, attribute_0_d22, attribute_1_d22, attribute_2_d22, first_x_d5,
            last_x_d5, delay_5_from_1_out, last_y_d4
        }),
        .out_valid(queue_3_out_valid), .out_ready(out_ready), .out_data(queue_3_out_data)
    );

    stream_fifo_d23_w40_distributed queue_4 (
        .clk(clk), .rst(rst), .in_valid(kept), .in_ready(queue_4_in_ready),
        .in_data({first_sum_out_d1, last_sum_out_d1, first_difference_d1[9:0], last_difference_out_d1}),
        .out_valid(queue_4_out_valid), .out_ready(out_ready), .out_data(queue_4_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            credits <= 6'd22;
            phases_1 <= 8'd1;
            delay_7_from_0_pointer <= 3'd0;
            delay_9_from_0_pointer <= 3'd0;
            delay_12_from_0_pointer <= 4'd0;
            delay_21_from_0_pointer <= 5'd0;
            delay_22_from_0_pointer <= 5'd0;
            delay_5_from_1_pointer <= 2'd0;
            delay_6_from_1_pointer <= 3'd0;
            delay_7_from_1_pointer <= 3'd0;
            delay_11_from_1_pointer <= 4'd0;
            delay_6_from_2_pointer <= 3'd0;
            delay_7_from_2_pointer <= 3'd0;
            delay_10_from_3_pointer <= 4'd0;
            delay_11_from_3_pointer <= 4'd0;
            delay_12_from_3_pointer <= 4'd0;
            delay_14_from_3_pointer <= 4'd0;
            delay_8_from_4_pointer <= 3'd0;
            delay_6_from_5_pointer <= 3'd0;
            delay_7_from_5_pointer <= 3'd0;
            delay_8_from_5_pointer <= 3'd0;
            phases_2 <= 8'd1;
            delay_9_from_5_pointer <= 3'd0;
            phases_3 <= 8'd1;
            delay_11_from_5_pointer <= 4'd0;
            delay_5_from_6_pointer <= 2'd0;
            delay_6_from_6_pointer <= 3'd0;
            delay_7_from_6_pointer <= 3'd0;
            delay_8_from_6_pointer <= 3'd0;
            delay_9_from_6_pointer <= 3'd0;
            delay_10_from_6_pointer <= 4'd0;
            delay_11_from_6_pointer <= 4'd0;
            delay_14_from_6_pointer <= 4'd0;
            delay_9_from_7_pointer <= 3'd0;
            delay_10_from_7_pointer <= 4'd0;
            delay_11_from_7_pointer <= 4'd0;
            delay_12_from_7_pointer <= 4'd0;
            delay_19_from_7_pointer <= 5'd0;
            phases_4 <= 8'd1;
            phases_5 <= 8'd1;
            phases_6 <= 8'd1;
            phases_7 <= 8'd1;
            phases_8 <= 8'd1;
            phases_9 <= 8'd1;
            phases_10 <= 8'd1;
            phases_11 <= 8'd1;
            phases_12 <= 8'd1;
            phases_13 <= 8'd1;
            phases_14 <= 8'd1;
            phases_15 <= 8'd1;
            phases_16 <= 8'd1;
            max_f24_ftz_unit_phase <= 3'd0;
            max_f24_ftz_unit_phase_copy2 <= 3'd0;
            max_f24_ftz_unit_copy2_phase <= 3'd0;
            max_f24_ftz_unit_copy2_phase_copy2 <= 3'd0;
            add_f24_ftz_unit_phase <= 3'd0;
            add_f24_ftz_unit_phase_copy2 <= 3'd0;
            add_f24_ftz_unit_copy2_phase <= 3'd0;
            add_f24_ftz_unit_copy2_phase_copy2 <= 3'd0;
            add_f24_ftz_unit_copy3_phase <= 3'd0;
            add_f24_ftz_unit_copy3_phase_copy2 <= 3'd0;
            add_f24_ftz_unit_copy4_phase <= 3'd0;
            add_f24_ftz_unit_copy4_phase_copy2 <= 3'd0;
            add_f24_ftz_unit_copy5_phase <= 3'd0;
            add_f24_ftz_unit_copy5_phase_copy2 <= 3'd0;
            recip_f24_ftz_unit_phase <= 3'd0;
            mul_f24_ftz_unit_phase <= 3'd0;
            mul_f24_ftz_unit_phase_copy2 <= 3'd0;
            mul_f24_ftz_unit_copy2_phase <= 3'd0;
            mul_f24_ftz_unit_copy2_phase_copy2 <= 3'd0;
            mul_f24_ftz_unit_copy3_phase <= 3'd0;
            mul_f24_ftz_unit_copy3_phase_copy2 <= 3'd0;
            mul_f24_ftz_unit_copy4_phase <= 3'd0;
            mul_f24_ftz_unit_copy4_phase_copy2 <= 3'd0;
            mul_mul_add_f24_ftz_unit_phase <= 3'd0;
            mul_mul_add_f24_ftz_unit_phase_copy2 <= 3'd0;
            mul_mul_add_f24_ftz_unit_phase_copy3 <= 3'd0;
            mul_mul_add_f24_ftz_unit_phase_copy4 <= 3'd0;
            mul_mul_add_f24_ftz_unit_copy2_phase <= 3'd0;
            mul_mul_add_f24_ftz_unit_copy2_phase_copy2 <= 3'd0;
            mul_mul_add_f24_ftz_unit_copy2_phase_copy3 <= 3'd0;
            mul_mul_add_f24_ftz_unit_copy2_phase_copy4 <= 3'd0;
            sqrt_f24_ftz_unit_phase <= 3'd0;
            min_f24_ftz_unit_phase <= 3'd0;
            min_f24_ftz_unit_phase_copy2 <= 3'd0;
            min_f24_ftz_unit_copy2_phase <= 3'd0;
            to_fixed_f24_ftz_u21q8_unit_phase <= 3'd0;
            to_fixed_f24_ftz_u23q8_unit_phase <= 3'd0;
            to_fixed_f24_ftz_s22q8_unit_phase <= 3'd0;
            to_fixed_f24_ftz_s27q13_unit_phase <= 3'd0;
            to_fixed_f24_ftz_s17q16_unit_phase <= 3'd0;
            to_fixed_f24_ftz_u20q19_unit_phase <= 3'd0;
            to_fixed_f24_ftz_u24q24_unit_phase <= 3'd0;
            in_flight <= 22'd0;
            left <= 1'd0;
            dropped <= 1'd0;
        end else begin
            credits <= (credits - {5'd0, in_valid_and_in_ready}) + {5'd0, left} + {5'd0, dropped};
            phases_1 <= {phases_1[6:0], phases_1[7]};
            phases_2 <= {phases_2[6:0], phases_2[7]};
            phases_3 <= {phases_3[6:0], phases_3[7]};
            phases_4 <= {phases_4[6:0], phases_4[7]};
            phases_5 <= {phases_5[6:0], phases_5[7]};
            phases_6 <= {phases_6[6:0], phases_6[7]};
            phases_7 <= {phases_7[6:0], phases_7[7]};
            phases_8 <= {phases_8[6:0], phases_8[7]};
            phases_9 <= {phases_9[6:0], phases_9[7]};
            phases_10 <= {phases_10[6:0], phases_10[7]};
            phases_11 <= {phases_11[6:0], phases_11[7]};
            phases_12 <= {phases_12[6:0], phases_12[7]};
            phases_13 <= {phases_13[6:0], phases_13[7]};
            phases_14 <= {phases_14[6:0], phases_14[7]};
            phases_15 <= {phases_15[6:0], phases_15[7]};
            phases_16 <= {phases_16[6:0], phases_16[7]};
            max_f24_ftz_unit_phase <= (max_f24_ftz_unit_phase == 3'd7) ? (max_f24_ftz_unit_phase - 3'd7) : (max_f24_ftz_unit_phase + 3'd1);
            max_f24_ftz_unit_phase_copy2 <= (max_f24_ftz_unit_phase_copy2 == 3'd7) ? (max_f24_ftz_unit_phase_copy2 - 3'd7) : (max_f24_ftz_unit_phase_copy2 + 3'd1);
            max_f24_ftz_unit_copy2_phase <= (max_f24_ftz_unit_copy2_phase == 3'd7) ? (max_f24_ftz_unit_copy2_phase - 3'd7) : (max_f24_ftz_unit_copy2_phase + 3'd1);
            max_f24_ftz_unit_copy2_phase_copy2 <= (max_f24_ftz_unit_copy2_phase_copy2 == 3'd7) ? (max_f24_ftz_unit_copy2_phase_copy2 - 3'd7) : (max_f24_ftz_unit_copy2_phase_copy2 + 3'd1);
            add_f24_ftz_unit_phase <= (add_f24_ftz_unit_phase == 3'd7) ? (add_f24_ftz_unit_phase - 3'd7) : (add_f24_ftz_unit_phase + 3'd1);
            add_f24_ftz_unit_phase_copy2 <= (add_f24_ftz_unit_phase_copy2 == 3'd7) ? (add_f24_ftz_unit_phase_copy2 - 3'd7) : (add_f24_ftz_unit_phase_copy2 + 3'd1);
            add_f24_ftz_unit_copy2_phase <= (add_f24_ftz_unit_copy2_phase == 3'd7) ? (add_f24_ftz_unit_copy2_phase - 3'd7) : (add_f24_ftz_unit_copy2_phase + 3'd1);
            add_f24_ftz_unit_copy2_phase_copy2 <= (add_f24_ftz_unit_copy2_phase_copy2 == 3'd7) ? (add_f24_ftz_unit_copy2_phase_copy2 - 3'd7) : (add_f24_ftz_unit_copy2_phase_copy2 + 3'd1);
            add_f24_ftz_unit_copy3_phase <= (add_f24_ftz_unit_copy3_phase == 3'd7) ? (add_f24_ftz_unit_copy3_phase - 3'd7) : (add_f24_ftz_unit_copy3_phase + 3'd1);
            add_f24_ftz_unit_copy3_phase_copy2 <= (add_f24_ftz_unit_copy3_phase_copy2 == 3'd7) ? (add_f24_ftz_unit_copy3_phase_copy2 - 3'd7) : (add_f24_ftz_unit_copy3_phase_copy2 + 3'd1);
            add_f24_ftz_unit_copy4_phase <= (add_f24_ftz_unit_copy4_phase == 3'd7) ? (add_f24_ftz_unit_copy4_phase - 3'd7) : (add_f24_ftz_unit_copy4_phase + 3'd1);
            add_f24_ftz_unit_copy4_phase_copy2 <= (add_f24_ftz_unit_copy4_phase_copy2 == 3'd7) ? (add_f24_ftz_unit_copy4_phase_copy2 - 3'd7) : (add_f24_ftz_unit_copy4_phase_copy2 + 3'd1);
            add_f24_ftz_unit_copy5_phase <= (add_f24_ftz_unit_copy5_phase == 3'd7) ? (add_f24_ftz_unit_copy5_phase - 3'd7) : (add_f24_ftz_unit_copy5_phase + 3'd1);
            add_f24_ftz_unit_copy5_phase_copy2 <= (add_f24_ftz_unit_copy5_phase_copy2 == 3'd7) ? (add_f24_ftz_unit_copy5_phase_copy2 - 3'd7) : (add_f24_ftz_unit_copy5_phase_copy2 + 3'd1);
            recip_f24_ftz_unit_phase <= (recip_f24_ftz_unit_phase == 3'd7) ? (recip_f24_ftz_unit_phase - 3'd7) : (recip_f24_ftz_unit_phase + 3'd1);
            mul_f24_ftz_unit_phase <= (mul_f24_ftz_unit_phase == 3'd7) ? (mul_f24_ftz_unit_phase - 3'd7) : (mul_f24_ftz_unit_phase + 3'd1);
            mul_f24_ftz_unit_phase_copy2 <= (mul_f24_ftz_unit_phase_copy2 == 3'd7) ? (mul_f24_ftz_unit_phase_copy2 - 3'd7) : (mul_f24_ftz_unit_phase_copy2 + 3'd1);
            mul_f24_ftz_unit_copy2_phase <= (mul_f24_ftz_unit_copy2_phase == 3'd7) ? (mul_f24_ftz_unit_copy2_phase - 3'd7) : (mul_f24_ftz_unit_copy2_phase + 3'd1);
            mul_f24_ftz_unit_copy2_phase_copy2 <= (mul_f24_ftz_unit_copy2_phase_copy2 == 3'd7) ? (mul_f24_ftz_unit_copy2_phase_copy2 - 3'd7) : (mul_f24_ftz_unit_copy2_phase_copy2 + 3'd1);
            mul_f24_ftz_unit_copy3_phase <= (mul_f24_ftz_unit_copy3_phase == 3'd7) ? (mul_f24_ftz_unit_copy3_phase - 3'd7) : (mul_f24_ftz_unit_copy3_phase + 3'd1);
            mul_f24_ftz_unit_copy3_phase_copy2 <= (mul_f24_ftz_unit_copy3_phase_copy2 == 3'd7) ? (mul_f24_ftz_unit_copy3_phase_copy2 - 3'd7) : (mul_f24_ftz_unit_copy3_phase_copy2 + 3'd1);
            mul_f24_ftz_unit_copy4_phase <= (mul_f24_ftz_unit_copy4_phase == 3'd7) ? (mul_f24_ftz_unit_copy4_phase - 3'd7) : (mul_f24_ftz_unit_copy4_phase + 3'd1);
            mul_f24_ftz_unit_copy4_phase_copy2 <= (mul_f24_ftz_unit_copy4_phase_copy2 == 3'd7) ? (mul_f24_ftz_unit_copy4_phase_copy2 - 3'd7) : (mul_f24_ftz_unit_copy4_phase_copy2 + 3'd1);
            mul_mul_add_f24_ftz_unit_phase <= (mul_mul_add_f24_ftz_unit_phase == 3'd7) ? (mul_mul_add_f24_ftz_unit_phase - 3'd7) : (mul_mul_add_f24_ftz_unit_phase + 3'd1);
            mul_mul_add_f24_ftz_unit_phase_copy2 <= (mul_mul_add_f24_ftz_unit_phase_copy2 == 3'd7) ? (mul_mul_add_f24_ftz_unit_phase_copy2 - 3'd7) : (mul_mul_add_f24_ftz_unit_phase_copy2 + 3'd1);
            mul_mul_add_f24_ftz_unit_phase_copy3 <= (mul_mul_add_f24_ftz_unit_phase_copy3 == 3'd7) ? (mul_mul_add_f24_ftz_unit_phase_copy3 - 3'd7) : (mul_mul_add_f24_ftz_unit_phase_copy3 + 3'd1);
            mul_mul_add_f24_ftz_unit_phase_copy4 <= (mul_mul_add_f24_ftz_unit_phase_copy4 == 3'd7) ? (mul_mul_add_f24_ftz_unit_phase_copy4 - 3'd7) : (mul_mul_add_f24_ftz_unit_phase_copy4 + 3'd1);
            mul_mul_add_f24_ftz_unit_copy2_phase <= (mul_mul_add_f24_ftz_unit_copy2_phase == 3'd7) ? (mul_mul_add_f24_ftz_unit_copy2_phase - 3'd7) : (mul_mul_add_f24_ftz_unit_copy2_phase + 3'd1);
            mul_mul_add_f24_ftz_unit_copy2_phase_copy2 <= (mul_mul_add_f24_ftz_unit_copy2_phase_copy2 == 3'd7) ? (mul_mul_add_f24_ftz_unit_copy2_phase_copy2 - 3'd7) : (mul_mul_add_f24_ftz_unit_copy2_phase_copy2 + 3'd1);
            mul_mul_add_f24_ftz_unit_copy2_phase_copy3 <= (mul_mul_add_f24_ftz_unit_copy2_phase_copy3 == 3'd7) ? (mul_mul_add_f24_ftz_unit_copy2_phase_copy3 - 3'd7) : (mul_mul_add_f24_ftz_unit_copy2_phase_copy3 + 3'd1);
            mul_mul_add_f24_ftz_unit_copy2_phase_copy4 <= (mul_mul_add_f24_ftz_unit_copy2_phase_copy4 == 3'd7) ? (mul_mul_add_f24_ftz_unit_copy2_phase_copy4 - 3'd7) : (mul_mul_add_f24_ftz_unit_copy2_phase_copy4 + 3'd1);
            sqrt_f24_ftz_unit_phase <= (sqrt_f24_ftz_unit_phase == 3'd7) ? (sqrt_f24_ftz_unit_phase - 3'd7) : (sqrt_f24_ftz_unit_phase + 3'd1);
            min_f24_ftz_unit_phase <= (min_f24_ftz_unit_phase == 3'd7) ? (min_f24_ftz_unit_phase - 3'd7) : (min_f24_ftz_unit_phase + 3'd1);
            min_f24_ftz_unit_phase_copy2 <= (min_f24_ftz_unit_phase_copy2 == 3'd7) ? (min_f24_ftz_unit_phase_copy2 - 3'd7) : (min_f24_ftz_unit_phase_copy2 + 3'd1);
            min_f24_ftz_unit_copy2_phase <= (min_f24_ftz_unit_copy2_phase == 3'd7) ? (min_f24_ftz_unit_copy2_phase - 3'd7) : (min_f24_ftz_unit_copy2_phase + 3'd1);
            to_fixed_f24_ftz_u21q8_unit_phase <= (to_fixed_f24_ftz_u21q8_unit_phase == 3'd7) ? (to_fixed_f24_ftz_u21q8_unit_phase - 3'd7) : (to_fixed_f24_ftz_u21q8_unit_phase + 3'd1);
            to_fixed_f24_ftz_u23q8_unit_phase <= (to_fixed_f24_ftz_u23q8_unit_phase == 3'd7) ? (to_fixed_f24_ftz_u23q8_unit_phase - 3'd7) : (to_fixed_f24_ftz_u23q8_unit_phase + 3'd1);
            to_fixed_f24_ftz_s22q8_unit_phase <= (to_fixed_f24_ftz_s22q8_unit_phase == 3'd7) ? (to_fixed_f24_ftz_s22q8_unit_phase - 3'd7) : (to_fixed_f24_ftz_s22q8_unit_phase + 3'd1);
            to_fixed_f24_ftz_s27q13_unit_phase <= (to_fixed_f24_ftz_s27q13_unit_phase == 3'd7) ? (to_fixed_f24_ftz_s27q13_unit_phase - 3'd7) : (to_fixed_f24_ftz_s27q13_unit_phase + 3'd1);
            to_fixed_f24_ftz_s17q16_unit_phase <= (to_fixed_f24_ftz_s17q16_unit_phase == 3'd7) ? (to_fixed_f24_ftz_s17q16_unit_phase - 3'd7) : (to_fixed_f24_ftz_s17q16_unit_phase + 3'd1);
            to_fixed_f24_ftz_u20q19_unit_phase <= (to_fixed_f24_ftz_u20q19_unit_phase == 3'd7) ? (to_fixed_f24_ftz_u20q19_unit_phase - 3'd7) : (to_fixed_f24_ftz_u20q19_unit_phase + 3'd1);
            to_fixed_f24_ftz_u24q24_unit_phase <= (to_fixed_f24_ftz_u24q24_unit_phase == 3'd7) ? (to_fixed_f24_ftz_u24q24_unit_phase - 3'd7) : (to_fixed_f24_ftz_u24q24_unit_phase + 3'd1);
            left <= out_valid & out_ready;
            dropped <= in_flight_21_and_phases_4_3 & ~end_or_visible_d1;
            if (phases_1[0]) begin
                delay_7_from_0_pointer <= (delay_7_from_0_pointer == 3'd5) ? (delay_7_from_0_pointer - 3'd5) : (delay_7_from_0_pointer + 3'd1);
                delay_9_from_0_pointer <= (delay_9_from_0_pointer == 3'd7) ? (delay_9_from_0_pointer - 3'd7) : (delay_9_from_0_pointer + 3'd1);
                delay_12_from_0_pointer <= (delay_12_from_0_pointer == 4'd10) ? (delay_12_from_0_pointer - 4'd10) : (delay_12_from_0_pointer + 4'd1);
                delay_21_from_0_pointer <= (delay_21_from_0_pointer == 5'd19) ? (delay_21_from_0_pointer - 5'd19) : (delay_21_from_0_pointer + 5'd1);
                delay_22_from_0_pointer <= (delay_22_from_0_pointer == 5'd20) ? (delay_22_from_0_pointer - 5'd20) : (delay_22_from_0_pointer + 5'd1);
            end
            if (phases_1[1]) begin
                delay_5_from_1_pointer <= (delay_5_from_1_pointer == 2'd3) ? (delay_5_from_1_pointer - 2'd3) : (delay_5_from_1_pointer + 2'd1);
                delay_6_from_1_pointer <= (delay_6_from_1_pointer == 3'd4) ? (delay_6_from_1_pointer - 3'd4) : (delay_6_from_1_pointer + 3'd1);
                delay_7_from_1_pointer <= (delay_7_from_1_pointer == 3'd5) ? (delay_7_from_1_pointer - 3'd5) : (delay_7_from_1_pointer + 3'd1);
                delay_11_from_1_pointer <= (delay_11_from_1_pointer == 4'd9) ? (delay_11_from_1_pointer - 4'd9) : (delay_11_from_1_pointer + 4'd1);
            end
            if (phases_1[2]) begin
                delay_6_from_2_pointer <= (delay_6_from_2_pointer == 3'd4) ? (delay_6_from_2_pointer - 3'd4) : (delay_6_from_2_pointer + 3'd1);
                delay_7_from_2_pointer <= (delay_7_from_2_pointer == 3'd5) ? (delay_7_from_2_pointer - 3'd5) : (delay_7_from_2_pointer + 3'd1);
            end
            if (phases_1[3]) begin
                delay_10_from_3_pointer <= (delay_10_from_3_pointer == 4'd8) ? (delay_10_from_3_pointer - 4'd8) : (delay_10_from_3_pointer + 4'd1);
                delay_11_from_3_pointer <= (delay_11_from_3_pointer == 4'd9) ? (delay_11_from_3_pointer - 4'd9) : (delay_11_from_3_pointer + 4'd1);
                delay_12_from_3_pointer <= (delay_12_from_3_pointer == 4'd10) ? (delay_12_from_3_pointer - 4'd10) : (delay_12_from_3_pointer + 4'd1);
                delay_14_from_3_pointer <= (delay_14_from_3_pointer == 4'd12) ? (delay_14_from_3_pointer - 4'd12) : (delay_14_from_3_pointer + 4'd1);
            end
            if (phases_1[4]) begin
                delay_8_from_4_pointer <= (delay_8_from_4_pointer == 3'd6) ? (delay_8_from_4_pointer - 3'd6) : (delay_8_from_4_pointer + 3'd1);
            end
            if (phases_1[5]) begin
                delay_6_from_5_pointer <= (delay_6_from_5_pointer == 3'd4) ? (delay_6_from_5_pointer - 3'd4) : (delay_6_from_5_pointer + 3'd1);
                delay_7_from_5_pointer <= (delay_7_from_5_pointer == 3'd5) ? (delay_7_from_5_pointer - 3'd5) : (delay_7_from_5_pointer + 3'd1);
                delay_8_from_5_pointer <= (delay_8_from_5_pointer == 3'd6) ? (delay_8_from_5_pointer - 3'd6) : (delay_8_from_5_pointer + 3'd1);
            end
            if (phases_2[5]) begin
                delay_9_from_5_pointer <= (delay_9_from_5_pointer == 3'd7) ? (delay_9_from_5_pointer - 3'd7) : (delay_9_from_5_pointer + 3'd1);
            end
            if (phases_3[5]) begin
                delay_11_from_5_pointer <= (delay_11_from_5_pointer == 4'd9) ? (delay_11_from_5_pointer - 4'd9) : (delay_11_from_5_pointer + 4'd1);
            end
            if (phases_1[6]) begin
                delay_5_from_6_pointer <= (delay_5_from_6_pointer == 2'd3) ? (delay_5_from_6_pointer - 2'd3) : (delay_5_from_6_pointer + 2'd1);
                delay_6_from_6_pointer <= (delay_6_from_6_pointer == 3'd4) ? (delay_6_from_6_pointer - 3'd4) : (delay_6_from_6_pointer + 3'd1);
                delay_7_from_6_pointer <= (delay_7_from_6_pointer == 3'd5) ? (delay_7_from_6_pointer - 3'd5) : (delay_7_from_6_pointer + 3'd1);
                delay_8_from_6_pointer <= (delay_8_from_6_pointer == 3'd6) ? (delay_8_from_6_pointer - 3'd6) : (delay_8_from_6_pointer + 3'd1);
                delay_9_from_6_pointer <= (delay_9_from_6_pointer == 3'd7) ? (delay_9_from_6_pointer - 3'd7) : (delay_9_from_6_pointer + 3'd1);
                delay_14_from_6_pointer <= (delay_14_from_6_pointer == 4'd12) ? (delay_14_from_6_pointer - 4'd12) : (delay_14_from_6_pointer + 4'd1);
            end
            if (phases_2[6]) begin
                delay_10_from_6_pointer <= (delay_10_from_6_pointer == 4'd8) ? (delay_10_from_6_pointer - 4'd8) : (delay_10_from_6_pointer + 4'd1);
                delay_11_from_6_pointer <= (delay_11_from_6_pointer == 4'd9) ? (delay_11_from_6_pointer - 4'd9) : (delay_11_from_6_pointer + 4'd1);
            end
            if (phases_1[7]) begin
                delay_9_from_7_pointer <= (delay_9_from_7_pointer == 3'd7) ? (delay_9_from_7_pointer - 3'd7) : (delay_9_from_7_pointer + 3'd1);
                delay_10_from_7_pointer <= (delay_10_from_7_pointer == 4'd8) ? (delay_10_from_7_pointer - 4'd8) : (delay_10_from_7_pointer + 4'd1);
                delay_11_from_7_pointer <= (delay_11_from_7_pointer == 4'd9) ? (delay_11_from_7_pointer - 4'd9) : (delay_11_from_7_pointer + 4'd1);
                delay_12_from_7_pointer <= (delay_12_from_7_pointer == 4'd10) ? (delay_12_from_7_pointer - 4'd10) : (delay_12_from_7_pointer + 4'd1);
                delay_19_from_7_pointer <= (delay_19_from_7_pointer == 5'd17) ? (delay_19_from_7_pointer - 5'd17) : (delay_19_from_7_pointer + 5'd1);
            end
            if (phases_10[0]) in_flight <= {in_flight[20:0], in_valid_and_in_ready};
        end
    end
    always @(posedge clk) begin
        if (phases_1[0]) begin
            end_d22 <= delay_21_from_0_out;
            turned_greater_d1 <= turned_greater;
            first_y_in_order_d1_copy3 <= lt_f24_ftz_unit_copy8_y;
            mx_both_d1 <= mx_both;
            mx_both_d1_copy2 <= mx_both_copy2;
            edge_on_lesser_below_32_d1 <= edge_on_lesser_below_32;
            edge_on_lesser_below_32_d2 <= edge_on_lesser_below_32_d1;
            end_or_visible_d1 <= end_or_visible;
            shift_either_bits_is_zero_d1 <= shift_either_bits_is_zero_copy6;
            shift_either_bits_is_zero_d1_copy2 <= shift_either_bits_is_zero_copy7;
            shift_either_sign_is_zero_d1 <= shift_either_sign_is_zero;
        end
        if (phases_2[0]) begin
            center_x_d1 <= in_center_x;
            center_y_d1 <= in_center_y;
            center_z_d1 <= in_center_z;
            center_z_d2 <= center_z_d1;
            tangent1_x_d1 <= in_tangent1_x;
            mx_chosen_d1 <= mx_chosen[7:0];
        end
        if (phases_3[0]) begin
            tangent1_y_d1 <= in_tangent1_y;
            tangent1_z_d1 <= in_tangent1_z;
            tangent2_x_d1 <= in_tangent2_x;
            tangent2_y_d1 <= in_tangent2_y;
            tangent2_z_d1 <= in_tangent2_z;
            mx_chosen_d1_copy2 <= mx_chosen_copy3[7:0];
        end
        if (phases_2[3]) begin
            first_x_greater_bits_d1 <= first_x_greater_bits_d1_bits;
            first_x_greater_bits_plus_1_d1 <= first_x_greater_bits_plus_1;
            first_x_greater_bits_d1_copy2 <= max_f24_ftz_unit_y[14:0];
            first_x_greater_sign_d1 <= max_f24_ftz_unit_y[23];
            reaches_near_greater_bits_d1 <= reaches_near_greater_bits_d1_bits;
            reaches_near_sum_d1 <= reaches_near_sum;
            zero_below_reaches_near_sum_d1 <= zero_below_reaches_near_sum;
            not_reaches_near_same_d1 <= not_reaches_near_same;
            reaches_near_same_d1 <= reaches_near_same_copy2;
            reaches_near_in_order_d1 <= reaches_near_in_order;
            reaches_near_greater_bits_d1_copy2 <= max_f24_ftz_unit_copy2_y[14:0];
            reaches_near_greater_sign_d1 <= max_f24_ftz_unit_copy2_y[23];
            lowered_d1 <= lowered;
            lowered_d2 <= lowered_d1;
            lowered_d3 <= lowered_d2;
            lowered_d4 <= lowered_d3;
            before_far_in_order_d1 <= le_f24_ftz_unit_copy3_y;
            sight_disc_out_d12 <= delay_11_from_3_out;
            sight_disc_out_d13 <= sight_disc_out_d12;
            sight_disc_out_d14 <= sight_disc_out_d13;
        end
        if (phases_1[3]) begin
            first_x_in_order_d1 <= first_x_in_order;
            first_x_inverted_d1 <= first_x_inverted;
            first_x_greater_bits_is_255_d1 <= first_x_greater_bits_is_255;
            first_x_in_order_d1_copy2 <= first_x_in_order_copy2;
        end
        if (phases_1[4]) begin
            first_x_both_d1 <= first_x_both_copy3;
            first_x_either_d1 <= first_x_either;
            first_y_greater_bits_d1 <= first_x_greater_bits_d1_bits;
            first_y_greater_bits_plus_1_d1 <= first_y_greater_bits_plus_1;
            first_y_in_order_d1 <= first_y_in_order;
            first_y_inverted_d1 <= first_y_inverted;
            first_y_greater_bits_is_255_d1 <= first_y_greater_bits_is_255;
            first_y_in_order_d1_copy2 <= first_y_in_order_copy2;
            first_y_greater_bits_d1_copy2 <= max_f24_ftz_unit_y[14:0];
            first_y_greater_sign_d1 <= max_f24_ftz_unit_y[23];
            reaches_near_both_d1 <= reaches_near_both_copy3;
            reaches_near_either_d1 <= reaches_near_either;
            a_x_in_order_and_a_x_inverted_d1 <= a_x_in_order_and_a_x_inverted;
            a_x_chosen_d1 <= a_x_chosen[7:0];
            a_y_in_order_and_a_y_inverted_d1 <= a_y_in_order_and_a_y_inverted;
            a_y_chosen_d1 <= a_y_chosen[7:0];
            alpha_both_d1 <= alpha_both;
            alpha_chosen_d1 <= alpha_chosen[7:0];
            b_x_in_order_and_b_x_inverted_d1 <= b_x_in_order_and_b_x_inverted;
            b_x_chosen_d1 <= b_x_chosen[7:0];
            b_y_in_order_and_b_y_inverted_d1 <= b_y_in_order_and_b_y_inverted;
            b_y_chosen_d1 <= b_y_chosen[7:0];
            beta_both_d1 <= beta_both;
            beta_chosen_d1 <= beta_chosen[7:0];
            beyond_near_and_not_turned_d1 <= beyond_near_and_not_turned;
            beyond_near_and_not_turned_d2 <= beyond_near_and_not_turned_d1;
            beyond_near_and_not_turned_d3 <= beyond_near_and_not_turned_d2;
            beyond_near_and_not_turned_d4 <= beyond_near_and_not_turned_d3;
            a_y_bits_d1 <= a_y_bits_d1_bits;
            not_zero_is_a_y_bits_d1 <= not_zero_is_a_y_bits;
            not_zero_is_a_y_bits_d2 <= not_zero_is_a_y_bits_d1;
            not_zero_is_a_y_bits_d3 <= not_zero_is_a_y_bits_d2;
            not_zero_is_b_x_bits_d1 <= not_zero_is_b_x_bits;
            not_zero_is_b_x_bits_d2 <= not_zero_is_b_x_bits_d1;
            not_zero_is_b_x_bits_d3 <= not_zero_is_b_x_bits_d2;
            exponent_both_d1 <= exponent_both;
            exponent_both_d1_copy2 <= exponent_both_copy2;
            exponent_both_d1_copy3 <= exponent_both_copy3;
        end
        if (phases_1[5]) begin
            first_x_joined_d1 <= {first_x_greater_sign_d1, first_x_chosen_copy4};
            first_y_both_d1 <= first_y_both_copy3;
            first_y_either_d1 <= first_y_either;
            reaches_near_joined_d1 <= {reaches_near_greater_sign_d1, reaches_near_chosen_copy4};
            turned_d1 <= turned;
            lowered_chosen_sign_d1 <= lowered_chosen_copy6[23];
            lowered_chosen_sign_d1_copy2 <= lowered_chosen_copy7[23];
            lowered_chosen_sign_d1_copy3 <= lowered_chosen_copy8[23];
            lowered_chosen_sign_d1_copy4 <= lowered_chosen_copy9[23];
            lowered_chosen_sign_d1_copy5 <= lowered_chosen_copy10[23];
            lowered_chosen_sign_d1_copy6 <= lowered_chosen_copy11[23];
            unit_delta_both_d1 <= unit_delta_both;
            a_x_bits_is_255_d1 <= a_x_bits_is_255;
            a_x_bits_is_255_d2 <= a_x_bits_is_255_d1;
        end
        if (phases_2[6]) begin
            first_y_joined_d1 <= {first_y_greater_sign_d1, first_y_chosen_copy4};
            lowered_greater_d1 <= lowered_greater;
            lowered_chosen_bits_plus_60_d1 <= lowered_chosen_bits_plus_60;
            a_y_inverted_d1 <= a_y_inverted;
            lowered_chosen_bits_is_255_d1_copy2 <= lowered_chosen_bits_is_255_copy2;
            alpha_inverted_d1 <= alpha_inverted;
            lowered_chosen_bits_is_255_d1_copy3 <= lowered_chosen_bits_is_255_copy3;
            b_x_inverted_d1 <= b_x_inverted;
            lowered_chosen_bits_is_255_d1_copy4 <= lowered_chosen_bits_is_255_copy4;
            b_y_inverted_d1 <= b_y_inverted;
            lowered_chosen_bits_is_255_d1_copy5 <= lowered_chosen_bits_is_255_copy5;
            beta_inverted_d1 <= beta_inverted;
            lowered_chosen_bits_is_255_d1_copy6 <= lowered_chosen_bits_is_255_copy6;
            not_turned_d1 <= not_turned;
            not_turned_d2 <= not_turned_d1;
            not_turned_d3 <= not_turned_d2;
            not_turned_d4 <= not_turned_d3;
            not_turned_d5 <= not_turned_d4;
            not_turned_d6 <= not_turned_d5;
            zero_is_lowered_d1 <= zero_is_lowered;
            whole_d1 <= whole;
            whole_d8 <= delay_6_from_6_out;
            whole_d9 <= whole_d8;
            unit_delta_both_d1_copy3 <= unit_delta_both_copy3;
            unit_delta_chosen_d1_copy3 <= unit_delta_chosen_copy5[7:0];
            unit_delta_both_d1_copy4 <= unit_delta_both_copy4;
            first_sum_both_d1 <= first_sum_both;
            visible_in_order_d1 <= visible_in_order;
            placed_d1 <= placed;
            placed_d2 <= placed_d1;
            zero_is_exponent_chosen_bits_d1 <= zero_is_exponent_chosen_bits;
            ax_out_both_d1 <= ax_out_both;
        end
        if (phases_1[2]) begin
            beyond_near_d1 <= lt_f24_ftz_unit_y;
            beyond_near_d2 <= beyond_near_d1;
            swapped_d1 <= lt_f24_ftz_unit_copy2_y;
            turned_either_d1 <= turned_either;
            lowered_greater_d1_copy5 <= lowered_greater_copy5;
            b_depth_d1 <= mul_f24_ftz_unit_y;
            last_x_d1 <= last_x;
            before_far_and_occupied_x_d1 <= before_far_and_occupied_x;
        end
        if (phases_4[0]) begin
            center_z_bits_plus_4_d1 <= center_z_bits_plus_4;
            lowered_greater_d1_copy3 <= lowered_greater_copy3;
            one_minus_depth_a_d1 <= add_f24_ftz_unit_y;
            half_depth_times_epsilon_scale_d1 <= mul_f24_ftz_unit_copy2_y;
            epsilon_d1 <= add_f24_ftz_unit_copy2_y;
            t_x_sum_d1 <= mul_mul_add_f24_ftz_unit_y;
            shift_either_bits_d1_copy2 <= shift_either_copy3[25:16];
        end
        if (phases_2[5]) begin
            v_x_chosen_d1 <= v_x_chosen_copy2;
            a_x_bits_is_255_d3 <= a_x_bits_is_255_d2;
            a_x_sign_d1 <= a_x_d1[23];
            a_x_sign_d2 <= a_x_sign_d1;
            a_x_sign_d3 <= a_x_sign_d2;
            unit_delta_both_d1_copy2 <= unit_delta_both_copy2;
            a_y_bits_is_255_d1 <= a_y_bits_is_255;
            a_y_bits_is_255_d2 <= a_y_bits_is_255_d1;
        end
        if (phases_3[5]) begin
            v_x_chosen_d2 <= v_x_chosen_d1;
            v_x_chosen_d3 <= v_x_chosen_d2;
            lowered_chosen_bits_d1 <= {3'd0, lowered_chosen_copy6[22:15]};
        end
        if (phases_4[5]) begin
            v_y_chosen_d1 <= v_y_chosen_copy2;
            v_y_chosen_d2 <= v_y_chosen_d1;
            v_y_chosen_d3 <= v_y_chosen_d2;
            lowered_chosen_d1 <= lowered_chosen_copy5;
            lowered_chosen_bits_d1_copy2 <= {3'd0, lowered_chosen_copy7[22:15]};
            lowered_chosen_bits_d1_copy3 <= {3'd0, lowered_chosen_copy8[22:15]};
            last_y_d1 <= last_y;
            a_y_bits_is_255_d3 <= a_y_bits_is_255_d2;
        end
        if (phases_1[7]) begin
            lowered_greater_d1_copy2 <= lowered_greater_copy2;
            spread_middle_d1 <= add_f24_ftz_unit_y;
            spread_middle_d2 <= spread_middle_d1;
            largest_sum_below_100_d1 <= largest_sum_below_100;
            not_zero_is_unit_delta_bits_d1 <= not_zero_is_unit_delta_bits;
            unit_delta_bits_is_255_d1 <= unit_delta_bits_is_255;
            unit_delta_sign_d1 <= add_f24_ftz_unit_copy5_y[23];
            unit_delta_bits_is_zero_d1 <= unit_delta_bits_is_zero;
        end
        if (phases_5[5]) begin
            lowered_chosen_bits_d1_copy4 <= {3'd0, lowered_chosen_copy9[22:15]};
            lowered_chosen_bits_d1_copy5 <= {3'd0, lowered_chosen_copy10[22:15]};
            lowered_chosen_bits_d1_copy6 <= {3'd0, lowered_chosen_copy11[22:15]};
            lowered_chosen_bits_d1_copy7 <= lowered_chosen_copy6[14:0];
            a_x_joined_d1 <= {lowered_chosen_sign_d1, a_x_chosen_copy2};
            a_x_joined_d2 <= a_x_joined_d1;
            a_x_joined_d3 <= a_x_joined_d2;
            unit_delta_chosen_d1 <= unit_delta_chosen[7:0];
        end
        if (phases_1[1]) begin
            lowered_greater_d1_copy4 <= lowered_greater_copy4;
            alpha_d1 <= mul_f24_ftz_unit_y;
            alpha_d2 <= alpha_d1;
            beyond_near_d1_copy2 <= beyond_near;
            beta_bits_d1 <= a_y_bits_d1_bits;
            not_zero_is_beta_bits_d1 <= not_zero_is_beta_bits;
            not_zero_is_beta_bits_d2 <= not_zero_is_beta_bits_d1;
            not_zero_is_beta_bits_d3 <= not_zero_is_beta_bits_d2;
            beta_bits_is_255_d1 <= beta_bits_is_255;
            not_zero_is_alpha_bits_d1 <= not_zero_is_alpha_bits;
            not_zero_is_alpha_bits_d2 <= not_zero_is_alpha_bits_d1;
            not_zero_is_alpha_bits_d3 <= not_zero_is_alpha_bits_d2;
            alpha_bits_is_255_d1 <= alpha_bits_is_255;
            not_zero_is_shift_either_bits_d1 <= not_zero_is_shift_either_bits;
        end
        if (phases_3[3]) begin
            lowered_d5 <= lowered_d4;
            lowered_d6 <= lowered_d5;
            r_d1 <= recip_f24_ftz_unit_y;
            f_times_root_of_q_d1 <= mul_f24_ftz_unit_y;
            spread_half_d1 <= mul_f24_ftz_unit_copy2_y;
            spread_half_d2 <= spread_half_d1;
            sight_disc_out_d15 <= sight_disc_out_d14;
            sight_disc_out_d16 <= sight_disc_out_d15;
            not_zero_is_a_x_bits_d1 <= not_zero_is_a_x_bits;
            not_zero_is_a_x_bits_d2 <= not_zero_is_a_x_bits_d1;
            not_zero_is_a_x_bits_d3 <= not_zero_is_a_x_bits_d2;
            not_zero_is_a_x_bits_d4 <= not_zero_is_a_x_bits_d3;
            not_zero_is_mx_sum_bits_d1 <= not_zero_is_mx_sum_bits;
            mx_sum_bits_is_255_d1 <= mx_sum_bits_is_255;
            mx_sum_sign_d1 <= mul_mul_add_f24_ftz_unit_y[23];
            first_sum_up_to_last_sum_d1 <= first_sum_up_to_last_sum;
        end
        if (phases_1[6]) begin
            a_x_inverted_d1 <= a_x_inverted;
            lowered_chosen_bits_is_255_d1 <= lowered_chosen_bits_is_255;
        end
        if (phases_6[5]) begin
            lowered_chosen_bits_d1_copy8 <= lowered_chosen_copy7[14:0];
            a_y_joined_d1 <= {lowered_chosen_sign_d1_copy2, a_y_chosen_copy2};
            a_y_joined_d2 <= a_y_joined_d1;
            a_y_joined_d3 <= a_y_joined_d2;
            lowered_chosen_bits_d1_copy9 <= lowered_chosen_copy8[14:0];
            alpha_joined_d1 <= {lowered_chosen_sign_d1_copy3, alpha_chosen_copy2};
            a_y_sign_d1 <= a_y_d1[23];
            a_y_sign_d2 <= a_y_sign_d1;
        end
        if (phases_7[5]) begin
            alpha_joined_d2 <= alpha_joined_d1;
            lowered_chosen_bits_d1_copy10 <= lowered_chosen_copy9[14:0];
            b_x_joined_d1 <= {lowered_chosen_sign_d1_copy4, b_x_chosen_copy2};
            b_x_joined_d2 <= b_x_joined_d1;
            b_x_joined_d3 <= b_x_joined_d2;
            lowered_chosen_bits_d1_copy11 <= lowered_chosen_copy10[14:0];
            a_y_sign_d3 <= a_y_sign_d2;
            b_x_bits_is_255_d1 <= b_x_bits_is_255;
        end
        if (phases_8[5]) begin
            b_y_joined_d1 <= {lowered_chosen_sign_d1_copy5, b_y_chosen_copy2};
            b_y_joined_d2 <= b_y_joined_d1;
            b_y_joined_d3 <= b_y_joined_d2;
            lowered_chosen_bits_d1_copy12 <= lowered_chosen_copy11[14:0];
            beta_joined_d1 <= {lowered_chosen_sign_d1_copy6, beta_chosen_copy2};
            last_y_d2 <= last_y_d1;
            unit_delta_chosen_d1_copy2 <= unit_delta_chosen_copy3[7:0];
        end
        if (phases_9[5]) begin
            beta_joined_d2 <= beta_joined_d1;
            q_d1 <= mul_mul_add_f24_ftz_unit_y;
            q_d2 <= q_d1;
            q_d3 <= q_d2;
            q_d4 <= q_d3;
            b_x_bits_is_255_d2 <= b_x_bits_is_255_d1;
            b_x_bits_is_255_d3 <= b_x_bits_is_255_d2;
            b_x_sign_d1 <= b_x_d1[23];
            b_x_sign_d2 <= b_x_sign_d1;
            b_x_sign_d3 <= b_x_sign_d2;
            not_zero_is_b_y_bits_d1 <= not_zero_is_b_y_bits;
            not_zero_is_b_y_bits_d2 <= not_zero_is_b_y_bits_d1;
            not_zero_is_b_y_bits_d3 <= not_zero_is_b_y_bits_d2;
        end
        if (phases_2[1]) begin
            alpha_d3 <= alpha_d2;
            beta_d1 <= mul_f24_ftz_unit_copy2_y;
            beta_d2 <= beta_d1;
            beta_d3 <= beta_d2;
            center_depth_d7 <= delay_6_from_1_out;
            not_shift_either_bits_is_zero_d1 <= not_shift_either_bits_is_zero;
            not_zero_is_shift_either_bits_d1_copy2 <= not_zero_is_shift_either_bits_copy2;
            not_shift_either_bits_is_zero_d1_copy2 <= not_shift_either_bits_is_zero_copy2;
            not_shift_either_bits_is_zero_d1_copy3 <= not_shift_either_bits_is_zero_copy3;
            not_shift_either_bits_is_zero_d1_copy4 <= not_shift_either_bits_is_zero_copy4;
            not_shift_either_bits_is_zero_d1_copy5 <= not_shift_either_bits_is_zero_copy5;
            not_zero_is_shift_either_bits_d1_copy3 <= not_zero_is_shift_either_bits_copy3;
        end
        if (phases_2[4]) begin
            e_d1 <= add_f24_ftz_unit_y;
            f_d1 <= recip_f24_ftz_unit_y;
            f_d2 <= f_d1;
            middle_depth_d1 <= middle_depth;
            middle_depth_d2 <= middle_depth_d1;
            exponent_chosen_d1 <= exponent_chosen[7:0];
        end
        if (phases_2[2]) begin
            b_depth_d2 <= b_depth_d1;
            b_depth_d3 <= b_depth_d2;
            b_depth_d4 <= b_depth_d3;
            b_depth_d5 <= b_depth_d4;
            b_depth_d6 <= b_depth_d5;
            shift_chosen_d1 <= shift_chosen_copy7;
        end
        if (phases_3[1]) begin
            center_depth_d8 <= center_depth_d7;
            center_depth_d9 <= center_depth_d8;
            half_depth_d1 <= half_depth;
            v_x_d1 <= mul_f24_ftz_unit_copy3_y;
            center_x_minus_t_x_d1 <= add_f24_ftz_unit_copy2_y;
        end
        if (phases_3[6]) begin
            root_of_q_d1 <= sqrt_f24_ftz_unit_y;
            center_x_d6 <= center_x_d5;
            center_x_d7 <= center_x_d6;
            center_x_d8 <= center_x_d7;
            center_x_d9 <= center_x_d8;
            unit_delta_chosen_d1_copy4 <= unit_delta_chosen_copy7[7:0];
        end
        if (phases_4[3]) begin
            before_far_sum_d1 <= add_f24_ftz_unit_y;
            a_x_d1 <= mul_f24_ftz_unit_copy3_y;
            f_times_scale_x_d1 <= mul_f24_ftz_unit_copy4_y;
            last_y_shifted_d1 <= last_y_greater_fixed_plus_130 >> 8;
            a_x_bits_d1 <= a_x_bits_d1_bits;
            a_x_bits_d2 <= a_x_bits_d1;
            a_x_bits_d3 <= a_x_bits_d2;
        end
        if (phases_2[7]) begin
            before_far_joined_d1 <= {mul_f24_ftz_unit_y[23], before_far_chosen};
            h_x_sum_d1_copy2 <= mul_mul_add_f24_ftz_unit_y;
            center_y_plus_first_y_joined_d1 <= add_f24_ftz_unit_copy3_y;
            filter_radius_plus_center_y_d1 <= add_f24_ftz_unit_copy4_y;
            unit_delta_joined_d1_copy3 <= {b_x_sign_d1, unit_delta_chosen_copy6};
            unit_delta_product_bits_d1 <= unit_delta_product_d1[22:15];
        end
        if (phases_3[4]) begin
            b_x_d1 <= mul_f24_ftz_unit_copy3_y;
            first_x_joined_d1_copy2 <= {mul_f24_ftz_unit_y[23], first_x_chosen_copy6};
            first_x_chosen_d1 <= first_x_chosen_copy8;
            first_x_chosen_d2 <= first_x_chosen_d1;
            first_x_chosen_d3 <= first_x_chosen_d2;
            exponent_both_d1_copy4 <= exponent_both_copy4;
            delta_both_d1 <= delta_both;
            mx_both_d1_copy3 <= mx_both_copy3;
            my_in_order_d1 <= my_in_order;
            not_zero_is_my_sum_bits_d1 <= not_zero_is_my_sum_bits;
            my_sum_bits_is_255_d1 <= my_sum_bits_is_255;
            my_sum_sign_d1 <= mul_mul_add_f24_ftz_unit_copy2_y[23];
        end
        if (phases_5[0]) begin
            t_x_sum_d2 <= t_x_sum_d1;
            h_x_sum_d1 <= mul_mul_add_f24_ftz_unit_copy2_y;
            h_x_sum_d2 <= h_x_sum_d1;
            h_x_sum_d3 <= h_x_sum_d2;
            center_x_minus_filter_radius_d1 <= add_f24_ftz_unit_copy3_y;
            shift_either_bits_d1_copy4 <= shift_either_copy3[25:18];
        end
        if (phases_3[2]) begin
            t_x_d1 <= mul_f24_ftz_unit_copy3_y;
            minus_h_x_d1 <= minus_sqrt_f24_ftz_unit_y;
            first_x_chosen_d1_copy2 <= first_x_chosen_copy9;
            last_x_d2 <= last_x_d1;
            last_x_d3 <= last_x_d2;
            last_x_d4 <= last_x_d3;
            last_x_d5 <= last_x_d4;
            largest_greater_d1_copy3 <= largest_greater_copy3;
        end
        if (phases_4[1]) begin
            center_x_minus_t_x_d2 <= center_x_minus_t_x_d1;
            center_x_minus_t_x_d3 <= center_x_minus_t_x_d2;
            center_x_minus_t_x_d4 <= center_x_minus_t_x_d3;
            last_x_chosen_d1_copy2 <= last_x_chosen_copy3;
            last_x_lesser_d1 <= last_x_lesser;
            exponent_greater_d1_copy2 <= exponent_greater_copy2;
        end
        if (phases_10[5]) begin
            center_x_minus_first_x_joined_d1 <= add_f24_ftz_unit_copy2_y;
            center_x_plus_first_x_joined_d1 <= add_f24_ftz_unit_copy3_y;
            filter_radius_plus_center_x_d1 <= add_f24_ftz_unit_copy4_y;
            last_x_chosen_d1_copy3 <= last_x_chosen_copy4;
            b_y_d1 <= mul_f24_ftz_unit_copy2_y;
            b_y_bits_is_255_d1 <= b_y_bits_is_255;
            b_y_bits_is_255_d2 <= b_y_bits_is_255_d1;
            b_y_bits_is_255_d3 <= b_y_bits_is_255_d2;
            b_y_sign_d1 <= mul_f24_ftz_unit_copy2_y[23];
            b_y_sign_d2 <= b_y_sign_d1;
            b_y_sign_d3 <= b_y_sign_d2;
            visible_both_d1 <= visible_both_copy2;
            visible_both_d2 <= visible_both_d1;
        end
        if (phases_4[4]) begin
            last_x_chosen_d1 <= last_x_chosen_copy2;
            last_x_chosen_d2 <= last_x_chosen_d1;
            last_x_chosen_d3 <= last_x_chosen_d2;
            a_y_d1 <= mul_f24_ftz_unit_copy2_y;
            t_y_sum_d1 <= mul_mul_add_f24_ftz_unit_y;
            exponent_chosen_d1_copy2 <= exponent_chosen_copy7[7:0];
        end
        if (phases_4[6]) begin
            first_x_chosen_d1_copy3 <= first_x_chosen_copy10;
            first_x_shifted_d1 <= first_x_shifted_d1_shifted;
            center_y_d1_copy2 <= add_f24_ftz_unit_copy2_y;
            center_y_d7 <= center_y_d6;
            center_y_d8 <= center_y_d7;
            last_difference_out_d1 <= last_difference[9:0];
        end
        if (phases_6[0]) begin
            last_x_shifted_d1 <= last_x_greater_fixed_plus_130 >> 8;
            center_y_minus_filter_radius_d1 <= add_f24_ftz_unit_copy4_y;
            first_y_chosen_d1_copy3 <= first_y_chosen_copy10;
            last_y_chosen_d1_copy3 <= last_y_chosen_copy4;
            minus_unit_delta_joined_d1 <= {~unit_delta_joined_d1[23], unit_delta_joined_d1[22:0]};
            shift_either_bits_d1_copy3 <= shift_either_copy3[25:17];
            odd_d1 <= odd;
        end
        if (phases_5[1]) begin
            v_y_d1 <= mul_f24_ftz_unit_copy4_y;
            h_y_sum_d1 <= mul_mul_add_f24_ftz_unit_y;
            h_y_sum_d2 <= h_y_sum_d1;
            h_y_sum_d3 <= h_y_sum_d2;
            center_y_minus_t_y_d1 <= add_f24_ftz_unit_copy4_y;
        end
        if (phases_5[6]) begin
            center_y_d9 <= center_y_d8;
            center_y_minus_first_y_joined_d1 <= add_f24_ftz_unit_copy3_y;
            unit_delta_joined_d1 <= {a_x_sign_d1, unit_delta_chosen_copy2};
            unit_delta_joined_d1_copy2 <= {a_y_sign_d1, unit_delta_chosen_copy4};
            unit_delta_joined_d2 <= unit_delta_joined_d1_copy2;
            bx_out_both_d1 <= bx_out_both;
            zero_is_exponent_chosen_bits_d1_copy2 <= zero_is_exponent_chosen_bits_copy2;
            ay_out_both_d1 <= ay_out_both;
            by_out_both_d1 <= by_out_both;
            mx_out_both_d1 <= mx_out_both;
            my_out_both_d1 <= my_out_both;
            vanishes_in_order_d1 <= vanishes_in_order;
            exponent_chosen_bits_is_255_d1 <= exponent_chosen_bits_is_255;
        end
        if (phases_4[2]) begin
            t_y_d1 <= mul_f24_ftz_unit_copy4_y;
            minus_t_y_d1 <= {~mul_f24_ftz_unit_copy4_y[23], mul_f24_ftz_unit_copy4_y[22:0]};
            first_sum_sum_d1 <= mul_mul_add_f24_ftz_unit_copy2_y;
            first_sum_sum_d2 <= first_sum_sum_d1;
            first_sum_sum_d3 <= first_sum_sum_d2;
        end
        if (phases_6[1]) begin
            center_y_minus_t_y_d2 <= center_y_minus_t_y_d1;
            center_y_minus_t_y_d3 <= center_y_minus_t_y_d2;
            first_y_shifted_d1 <= first_y_shifted_d1_shifted;
            beta_bits_d2 <= beta_bits_d1;
            beta_bits_d3 <= beta_bits_d2;
            alpha_bits_d1 <= alpha_bits_d1_bits;
            alpha_bits_d2 <= alpha_bits_d1;
            alpha_bits_d3 <= alpha_bits_d2;
        end
        if (phases_5[4]) begin
            f_times_scale_y_d1 <= mul_f24_ftz_unit_copy4_y;
            first_y_chosen_d1_copy2 <= first_y_chosen_copy9;
            last_y_chosen_d1_copy2 <= last_y_chosen_copy3;
            last_y_lesser_d1 <= last_y_lesser;
            a_y_bits_d2 <= a_y_bits_d1;
            a_y_bits_d3 <= a_y_bits_d2;
            a_exponent_d1 <= a_exponent;
        end
        if (phases_11[5]) begin
            first_y_joined_d1_copy2 <= {mul_f24_ftz_unit_y[23], first_y_chosen_copy6};
            first_y_chosen_d1 <= first_y_chosen_copy8;
            first_y_chosen_d2 <= first_y_chosen_d1;
            first_y_chosen_d3 <= first_y_chosen_d2;
            last_y_chosen_d1 <= last_y_chosen_copy2;
            visible_both_d3 <= visible_both_d2;
            visible_both_d4 <= visible_both_d3;
            shift_d1 <= shift;
            vanishes_d1 <= vanishes;
        end
        if (phases_12[5]) begin
            last_y_chosen_d2 <= last_y_chosen_d1;
            last_y_chosen_d3 <= last_y_chosen_d2;
            last_y_d3 <= last_y_d2;
            last_y_d4 <= last_y_d3;
            b_y_bits_d1 <= a_y_bits_d1_bits;
            b_y_bits_d2 <= b_y_bits_d1;
            b_y_bits_d3 <= b_y_bits_d2;
            b_exponent_d1 <= b_exponent;
            a_x_bits_d1_copy2 <= a_x_d1[14:0];
        end
        if (phases_5[3]) begin
            a_x_bits_d4 <= a_x_bits_d3;
            a_x_bits_plus_127_d1 <= a_x_bits_plus_127;
            largest_d1 <= largest;
            mx_sum_bits_d1 <= mx_sum_bits_d1_bits;
            mx_sum_plus_mx_sum_bits_d1 <= mx_sum_plus_mx_sum_bits;
            mx_sum_bits_d1_copy2 <= mul_mul_add_f24_ftz_unit_y[14:0];
            first_difference_sum_d1_copy2 <= add_f24_ftz_unit_copy2_y;
            last_difference_sum_d1 <= add_f24_ftz_unit_copy3_y;
            first_sum_out_d1 <= first_sum[9:0];
        end
        if (phases_6[4]) begin
            b_x_bits_d1 <= a_x_bits_d1_bits;
            b_x_bits_d2 <= b_x_bits_d1;
            b_x_bits_d3 <= b_x_bits_d2;
            a_y_bits_plus_127_d1 <= a_y_bits_plus_127;
            a_y_bits_d1_copy2 <= mul_f24_ftz_unit_copy2_y[14:0];
            a_y_bits_d2_copy2 <= a_y_bits_d1_copy2;
            a_y_bits_d3_copy2 <= a_y_bits_d2_copy2;
            b_x_bits_plus_127_d1 <= b_x_bits_plus_127;
            b_x_bits_d1_copy2 <= mul_f24_ftz_unit_copy3_y[14:0];
            a_x_bits_plus_381_d1 <= a_x_bits_plus_381;
        end
        if (phases_13[5]) begin
            a_x_bits_d2_copy2 <= a_x_bits_d1_copy2;
            a_x_bits_d3_copy2 <= a_x_bits_d2_copy2;
            b_y_bits_plus_127_d1 <= b_y_bits_plus_127;
            b_y_bits_d1_copy2 <= mul_f24_ftz_unit_copy2_y[14:0];
            b_y_bits_d2_copy2 <= b_y_bits_d1_copy2;
            b_y_bits_d3_copy2 <= b_y_bits_d2_copy2;
            a_exponent_plus_beta_bits_d1 <= a_exponent_plus_beta_bits;
            mx_sum_d1 <= mx_sum;
            shift_d2 <= shift_d1;
            shift_d3 <= shift_d2;
            delta_bits_d1 <= {2'd0, delta[22:15]};
        end
        if (phases_7[4]) begin
            b_x_bits_d2_copy2 <= b_x_bits_d1_copy2;
            b_x_bits_d3_copy2 <= b_x_bits_d2_copy2;
            a_y_bits_plus_381_d1 <= a_y_bits_plus_381;
            exponent_joined_d1_copy2 <= {exponent_chosen_copy3[7:0], a_y_bits_d3_copy2};
            b_x_bits_plus_381_d1 <= b_x_bits_plus_381;
            exponent_joined_d1_copy4 <= {exponent_chosen_copy5[7:0], b_x_bits_d3_copy2};
            b_y_bits_plus_381_d1 <= b_y_bits_plus_381;
            delta_chosen_d1 <= delta_chosen[7:0];
            mx_chosen_d1_copy3 <= mx_chosen_copy5[7:0];
        end
        if (phases_3[7]) begin
            unit_delta_joined_d2_copy2 <= unit_delta_joined_d1_copy3;
            unit_delta_joined_d1_copy4 <= {b_y_sign_d1, unit_delta_chosen_copy8};
            m_exponent_d1 <= m_exponent;
            unit_delta_bits_d1 <= unit_delta_bits_d1_bits;
            largest_sum_minus_100_d1 <= largest_sum_minus_100;
            largest_sum_plus_127_d1 <= largest_sum_plus_127;
            delta_sum_d1 <= delta_sum;
            unit_delta_bits_d1_copy2 <= add_f24_ftz_unit_copy5_y[14:0];
            edge_on_in_order_d1 <= edge_on_in_order;
            sight_negative_out_d1 <= sight_negative_out;
            visible_both_d1_copy2 <= visible_both_copy3;
            odd_either_d1 <= odd_either_copy3;
            sight_near_out_both_d1 <= sight_near_out_both_copy2;
            sight_near_out_either_d1 <= sight_near_out_either;
            sight_far_out_both_d1 <= sight_far_out_both_copy2;
            sight_far_out_either_d1 <= sight_far_out_either;
        end
        if (phases_6[6]) begin
            unit_delta_product_d1 <= mul_f24_ftz_unit_y;
            minus_unit_delta_product_d1 <= {~mul_f24_ftz_unit_copy2_y[23], mul_f24_ftz_unit_copy2_y[22:0]};
            b_exponent_plus_alpha_bits_d1 <= b_exponent_plus_alpha_bits;
            mx_sum_d1_copy2 <= mx_sum_copy2;
            largest_sum_d1 <= largest_sum;
            largest_sum_d2 <= largest_sum_d1;
            largest_sum_d3 <= largest_sum_d2;
            largest_greater_d1 <= largest_greater;
            edge_on_lesser_d1 <= edge_on_lesser;
            exponent_joined_bits_is_255_d1 <= exponent_joined_bits_is_255;
            exponent_chosen_bits_is_255_d1_copy2 <= exponent_chosen_bits_is_255_copy2;
            mx_bits_is_255_d1 <= mx_bits_is_255;
        end
        if (phases_7[1]) begin
            mx_joined_d1 <= {beta_d3[23], mx_chosen_copy2};
            mx_joined_d1_copy2 <= {alpha_d3[23], mx_chosen_copy4};
            largest_greater_plus_154_d1 <= largest_greater_plus_154;
            largest_greater_plus_154_d2 <= largest_greater_plus_154_d1;
            largest_greater_d1_copy2 <= largest_greater_copy2;
            root_of_first_sum_sum_d1 <= sqrt_f24_ftz_unit_y;
            mx_out_lesser_d1 <= mx_out_lesser[15:0];
        end
        if (phases_7[0]) begin
            largest_chosen_d1 <= largest_chosen;
            largest_chosen_d1_copy2 <= largest_chosen_copy2;
            largest_sum_d1_copy2 <= largest_sum_copy3;
            largest_sum_d2_copy2 <= largest_sum_d1_copy2;
            largest_sum_d3_copy2 <= largest_sum_d2_copy2;
            mx_sum_d1_copy3 <= mx_sum_copy3;
            mx_sum_d2 <= mx_sum_d1_copy3;
            mx_sum_d3 <= mx_sum_d2;
            first_sum_sum_d1_copy3 <= add_f24_ftz_unit_copy5_y;
            shift_either_bits_d1 <= shift_either_copy3[25:15];
            shift_either_bits_d1_copy7 <= shift_either_copy3[25:21];
        end
        if (phases_14[5]) begin
            exponent_joined_d1 <= {a_x_sign_d3, exponent_chosen_copy2};
            exponent_joined_d1_copy3 <= {a_y_sign_d3, exponent_chosen_copy4};
            delta_d1 <= delta;
            first_difference_d1 <= first_difference;
            last_difference_lesser_d1 <= last_difference_lesser;
        end
        if (phases_8[4]) begin
            my_sum_bits_d1 <= my_sum_bits_d1_bits;
            my_difference_d1 <= my_difference;
            my_sum_bits_d1_copy2 <= mul_mul_add_f24_ftz_unit_copy2_y[14:0];
            last_difference_sum_d1_copy4 <= last_difference_sum_copy4;
            first_difference_greater_d1 <= first_difference_greater;
            center_y_out_lesser_d1 <= center_y_out_lesser[25:0];
            shift_chosen_d1_copy3 <= shift_chosen_copy13;
        end
        if (phases_5[2]) begin
            first_sum_sum_d1_copy2 <= add_f24_ftz_unit_copy2_y;
            t_x_plus_t_y_d7 <= delay_6_from_2_out;
            last_sum_sum_d1 <= add_f24_ftz_unit_copy5_y;
            center_x_fixed_d1 <= to_fixed_f24_ftz_s22q8_unit_y;
            last_sum_lesser_d1 <= last_sum_lesser;
        end
        if (phases_7[6]) begin
            first_sum_product_d1 <= mul_f24_ftz_unit_copy3_y;
            first_difference_sum_d1 <= add_f24_ftz_unit_copy5_y;
            first_sum_chosen_d1 <= first_sum_chosen;
            first_sum_sum_d1_copy4 <= first_sum_sum;
            last_sum_chosen_d1 <= last_sum_chosen;
            my_bits_is_255_d1 <= my_bits_is_255;
            covers_nothing_d1 <= covers_nothing;
            sight_near_out_in_order_d1 <= sight_near_out_in_order;
            sight_far_out_in_order_d1 <= sight_far_out_in_order;
        end
        if (phases_4[7]) begin
            last_sum_sum_d1_copy2 <= last_sum_sum;
            first_difference_chosen_d1 <= first_difference_chosen;
            first_sum_difference_d1 <= first_sum_difference;
            shift_difference_d1 <= shift_difference;
            exponent_chosen_d1_copy3 <= exponent_chosen_copy11;
            exponent_chosen_bits_plus_126_d1 <= exponent_chosen_bits_plus_126;
        end
        if (phases_8[0]) begin
            first_difference_sum_d1_copy3 <= first_difference_sum;
            last_difference_chosen_d1 <= last_difference_chosen;
            first_sum_shifted_d1 <= {{8{first_sum_sum_copy3[26]}}, first_sum_sum_copy3[26:8]};
            last_sum_sum_d1_copy3 <= last_sum_sum_copy2;
            shift_either_bits_d1_copy5 <= shift_either_copy3[25:19];
            shift_either_bits_d1_copy6 <= shift_either_copy3[25:20];
            shift_either_bits_d1_copy8 <= shift_either_copy3[25:22];
            not_placed_d1 <= not_placed;
            not_placed_d2 <= not_placed_d1;
            edge_on_or_not_placed_d1 <= edge_on_or_not_placed;
            edge_on_or_not_placed_d2 <= edge_on_or_not_placed_d1;
            sight_near_out_bits_is_255_d1 <= sight_near_out_bits_is_255;
            not_sight_near_out_bits_is_255_d1 <= not_sight_near_out_bits_is_255;
        end
        if (phases_8[1]) begin
            last_difference_sum_d1_copy2 <= last_difference_sum;
            last_sum_shifted_d1 <= {{8{last_sum_sum_copy3[26]}}, last_sum_sum_copy3[26:8]};
            first_sum_greater_d1 <= first_sum_greater;
            first_difference_difference_d1 <= first_difference_difference_copy2;
            my_out_shifted_d1 <= {my_out_sum[17], my_out_sum[17:1]};
        end
        if (phases_6[2]) begin
            first_difference_shifted_d1 <= {{8{first_difference_sum_copy2[26]}}, first_difference_sum_copy2[26:8]};
            last_difference_sum_d1_copy3 <= last_difference_sum_copy2;
            center_x_out_shifted_d1 <= {center_x_out_sum[27], center_x_out_sum[27:1]};
            shift_difference_d1_copy3 <= shift_difference_copy3;
            exponent_greater_d1_copy3 <= exponent_greater_copy3;
        end
        if (phases_6[3]) begin
            first_difference_sum_d1_copy4 <= first_difference_sum_copy3;
            last_difference_shifted_d1 <= {{8{last_difference_sum_copy3[26]}}, last_difference_sum_copy3[26:8]};
            last_sum_out_d1 <= last_sum[9:0];
            center_x_out_lesser_d1 <= center_x_out_lesser[25:0];
            center_x_out_d11 <= center_x_out_d10;
            shift_chosen_d1_copy2 <= shift_chosen_copy10;
        end
        if (phases_15[5]) begin
            exponent_joined_d1_copy5 <= {not_exponent_joined_sign, exponent_chosen_copy2};
            exponent_joined_d1_copy6 <= {not_exponent_joined_sign_copy2, exponent_chosen_copy4};
            delta_times_one_over_b_depth_d1 <= mul_f24_ftz_unit_copy3_y;
            shift_either_d1 <= shift_either_copy2;
            delta_bits_d11 <= delta_bits_d10;
            exponent_joined_bits_d1 <= {2'd0, exponent_chosen_copy6[22:15]};
            exponent_joined_bits_d1_copy2 <= {2'd0, exponent_chosen_copy8[22:15]};
        end
        if (phases_7[3]) begin
            center_x_out_d12 <= center_x_out_d11;
            center_x_out_d13 <= center_x_out_d12;
            center_x_out_d14 <= center_x_out_d13;
            center_y_out_shifted_d1 <= {center_y_out_sum[27], center_y_out_sum[27:1]};
            exponent_greater_d1_copy4 <= exponent_greater_copy4;
        end
        if (phases_8[3]) begin
            center_y_out_d11 <= center_y_out_d10;
            center_y_out_d12 <= center_y_out_d11;
            center_y_out_d13 <= center_y_out_d12;
            center_y_out_d14 <= center_y_out_d13;
            vanishes_shifted_d1 <= {vanishes_sum[21], vanishes_sum[21:1]};
        end
        if (phases_8[6]) begin
            shift_shifted_d1 <= {18'd0, first_x} << 12;
            shift_shifted_d1_copy4 <= last_y_plus_1 << 12;
            shift_plus_4_d1 <= shift_plus_4;
            exponent_chosen_bits_d10 <= exponent_chosen_bits_d9;
            exponent_chosen_bits_d10_copy2 <= exponent_chosen_bits_d9_copy2;
            bx_out_lesser_d1 <= bx_out_lesser[15:0];
            ay_out_shifted_d1 <= {ay_out_sum[17], ay_out_sum[17:1]};
            vanishes_difference_d1 <= vanishes_difference;
        end
        if (phases_9[4]) begin
            center_x_out_d1 <= {center_x_out_d10[25], center_x_out_d10};
            shift_difference_d1_copy2 <= shift_difference_copy2;
            not_shift_difference_d1 <= not_shift_difference_copy2;
            exponent_greater_d1_copy5 <= exponent_greater_copy5;
            ax_out_shifted_d1 <= {ax_out_sum[17], ax_out_sum[17:1]};
        end
        if (phases_9[3]) begin
            shift_shifted_d1_copy2 <= last_x_plus_1 << 12;
            shift_chosen_bits_d1_copy2 <= shift_chosen_copy3[25:0];
            middle_depth_minus_epsilon_d1 <= add_f24_ftz_unit_copy4_y;
            middle_depth_plus_epsilon_d1 <= add_f24_ftz_unit_copy5_y;
            depth_high_out_d1 <= to_fixed_f24_ftz_u24q24_unit_y;
        end
        if (phases_9[0]) begin
            shift_chosen_bits_d1 <= shift_chosen[25:0];
            exponent_greater_d1 <= exponent_greater;
            by_out_lesser_d1 <= by_out_lesser[15:0];
            mx_out_shifted_d1 <= {mx_out_sum[17], mx_out_sum[17:1]};
            sight_near_out_joined_d1 <= {sight_near_out_chosen_copy2[7:0], sight_near_out_chosen_copy3};
            sight_far_out_same_d1 <= sight_far_out_same_copy2;
            not_sight_far_out_same_d1 <= not_sight_far_out_same_copy2;
            sight_far_out_joined_d1 <= {sight_far_out_chosen_copy2[7:0], sight_far_out_chosen_copy3};
        end
        if (phases_9[1]) begin
            shift_shifted_d1_copy3 <= {18'd0, first_y} << 12;
            sight_far_out_joined_d1_copy2 <= {abs_sight_far_out_product_sign_d9, sight_far_out_chosen_copy4};
            depth_low_out_greater_d1 <= max_f24_ftz_unit_y;
        end
        if (phases_5[7]) begin
            center_y_out_d1 <= {center_y_out_d10[25], center_y_out_d10};
            shift_difference_d1_copy4 <= shift_difference_copy4;
            not_shift_difference_d1_copy2 <= not_shift_difference_copy4;
            ax_out_joined_d1 <= {exponent_chosen_sign_d11, ax_out_chosen[7:0], exponent_chosen_bits_d11};
            exponent_joined_bits_plus_126_d1 <= exponent_joined_bits_plus_126;
            exponent_chosen_bits_plus_126_d1_copy2 <= exponent_chosen_bits_plus_126_copy2;
        end
        if (phases_16[5]) begin
            mx_bits_d1 <= {2'd0, mx[22:15]};
            my_bits_d1 <= {2'd0, my[22:15]};
            exponent_d1 <= exponent;
            ax_out_lesser_d1 <= ax_out_lesser[15:0];
            bx_out_shifted_d1 <= {bx_out_sum[17], bx_out_sum[17:1]};
            sight_near_out_bits_d9 <= delay_8_from_5_out;
            sight_near_out_chosen_d1 <= sight_near_out_chosen_copy5;
        end
        if (phases_6[7]) begin
            bx_out_joined_d1 <= {exponent_joined_sign_d11, bx_out_chosen[7:0], exponent_joined_bits_d11};
            ay_out_joined_d1 <= {exponent_chosen_sign_d11_copy2, ay_out_chosen[7:0], exponent_chosen_bits_d11_copy2};
            ay_out_lesser_d1 <= ay_out_lesser[15:0];
            exponent_joined_bits_plus_126_d1_copy2 <= exponent_joined_bits_plus_126_copy2;
            by_out_joined_d1 <= {exponent_joined_sign_d11_copy2, by_out_chosen[7:0], exponent_joined_bits_d11_copy2};
            by_out_shifted_d1 <= {by_out_sum[17], by_out_sum[17:1]};
            mx_bits_plus_126_d1 <= mx_bits_plus_126;
        end
        if (phases_7[7]) begin
            mx_out_joined_d1 <= {mx_sign_d11, mx_out_chosen[7:0], mx_bits_d11};
            my_bits_plus_126_d1 <= my_bits_plus_126;
            my_out_joined_d1 <= {my_sign_d11, my_out_chosen[7:0], my_bits_d11};
            vanishes_joined_d1 <= {delta_sign_d10, vanishes_chosen[7:0], delta_bits_d10_copy2};
            sight_near_out_bits_plus_126_d1 <= sight_near_out_bits_plus_126;
            sight_far_out_sum_d1 <= sight_far_out_sum;
        end
        if (phases_7[2]) begin
            my_out_lesser_d1 <= my_out_lesser[15:0];
            depth_high_out_greater_d1 <= max_f24_ftz_unit_copy2_y;
        end
        if (phases_10[4]) begin
            vanishes_lesser_d1 <= vanishes_lesser[19:0];
            depth_low_out_d1 <= to_fixed_f24_ftz_u24q24_unit_y;
            depth_low_out_d2 <= depth_low_out_d1;
            depth_low_out_d3 <= depth_low_out_d2;
        end
        if (phases_9[6]) begin
            sight_near_out_sum_d1 <= sight_near_out_sum;
            sight_near_out_difference_d1 <= sight_near_out_difference;
            abs_sight_far_out_product_bits_d9 <= delay_8_from_6_out;
            sight_far_out_difference_d1 <= sight_far_out_difference;
            sight_far_out_d1 <= sight_far_out;
        end
        if (phases_10[3]) begin
            depth_high_out_d2 <= depth_high_out_d1;
            depth_high_out_d3 <= depth_high_out_d2;
        end
        max_f24_ftz_unit_a <= max_f24_ftz_unit_phase[2] ? max_f24_ftz_unit_a_choice_2 : max_f24_ftz_unit_a_choice_5;
        max_f24_ftz_unit_b <= max_f24_ftz_unit_phase_copy2[2] ? max_f24_ftz_unit_b_choice_3 : max_f24_ftz_unit_b_choice_6;
        max_f24_ftz_unit_copy2_a <= max_f24_ftz_unit_copy2_phase[2] ? max_f24_ftz_unit_copy2_a_choice_2 : max_f24_ftz_unit_copy2_a_choice_4;
        max_f24_ftz_unit_copy2_b <= max_f24_ftz_unit_copy2_phase_copy2[2] ? max_f24_ftz_unit_copy2_b_choice_3 : max_f24_ftz_unit_copy2_b_choice_6;
        add_f24_ftz_unit_a <= add_f24_ftz_unit_phase[2] ? add_f24_ftz_unit_a_choice : add_f24_ftz_unit_a_choice_2;
        add_f24_ftz_unit_b <= add_f24_ftz_unit_phase_copy2[2] ? add_f24_ftz_unit_b_choice_3 : add_f24_ftz_unit_b_choice_6;
        add_f24_ftz_unit_copy2_a <= add_f24_ftz_unit_copy2_phase[2] ? add_f24_ftz_unit_copy2_a_choice_2 : add_f24_ftz_unit_copy2_a_choice_5;
        add_f24_ftz_unit_copy2_b <= add_f24_ftz_unit_copy2_phase_copy2[2] ? add_f24_ftz_unit_copy2_b_choice_3 : add_f24_ftz_unit_copy2_b_choice_6;
        add_f24_ftz_unit_copy3_a <= add_f24_ftz_unit_copy3_phase[2] ? add_f24_ftz_unit_copy3_a_choice : add_f24_ftz_unit_copy3_a_choice_2;
        add_f24_ftz_unit_copy3_b <= add_f24_ftz_unit_copy3_phase_copy2[2] ? add_f24_ftz_unit_copy3_b_choice_3 : add_f24_ftz_unit_copy3_b_choice_6;
        add_f24_ftz_unit_copy4_a <= add_f24_ftz_unit_copy4_phase[2] ? add_f24_ftz_unit_copy4_a_choice_3 : add_f24_ftz_unit_copy4_a_choice_5;
        add_f24_ftz_unit_copy4_b <= add_f24_ftz_unit_copy4_phase_copy2[2] ? add_f24_ftz_unit_copy4_b_choice_3 : add_f24_ftz_unit_copy4_b_choice_4;
        add_f24_ftz_unit_copy5_a <= add_f24_ftz_unit_copy5_phase[2] ? add_f24_ftz_unit_copy5_a_choice_3 : add_f24_ftz_unit_copy5_a_choice_6;
        add_f24_ftz_unit_copy5_b <= add_f24_ftz_unit_copy5_phase_copy2[2] ? add_f24_ftz_unit_copy5_b_choice_3 : add_f24_ftz_unit_copy5_b_choice_6;
        recip_f24_ftz_unit_a <= recip_f24_ftz_unit_phase[2] ? (recip_f24_ftz_unit_phase[0] ? f_chosen : lowered_chosen_d1) : b_depth_d3;
        mul_f24_ftz_unit_a <= mul_f24_ftz_unit_phase[2] ? mul_f24_ftz_unit_a_choice_2 : mul_f24_ftz_unit_a_choice_4;
        mul_f24_ftz_unit_b <= mul_f24_ftz_unit_phase_copy2[2] ? mul_f24_ftz_unit_b_choice_2 : mul_f24_ftz_unit_b_choice_5;
        mul_f24_ftz_unit_copy2_a <= mul_f24_ftz_unit_copy2_phase[2] ? mul_f24_ftz_unit_copy2_a_choice : mul_f24_ftz_unit_copy2_a_choice_3;
        mul_f24_ftz_unit_copy2_b <= mul_f24_ftz_unit_copy2_phase_copy2[2] ? mul_f24_ftz_unit_copy2_b_choice_3 : mul_f24_ftz_unit_copy2_b_choice_6;
        mul_f24_ftz_unit_copy3_a <= mul_f24_ftz_unit_copy3_phase[2] ? mul_f24_ftz_unit_copy3_a_choice : mul_f24_ftz_unit_copy3_a_choice_2;
        mul_f24_ftz_unit_copy3_b <= mul_f24_ftz_unit_copy3_phase_copy2[2] ? mul_f24_ftz_unit_copy3_b_choice_3 : mul_f24_ftz_unit_copy3_b_choice_5;
        mul_f24_ftz_unit_copy4_a <= mul_f24_ftz_unit_copy4_phase[2] ? mul_f24_ftz_unit_copy4_a_choice_2 : mul_f24_ftz_unit_copy4_a_choice_4;
        mul_f24_ftz_unit_copy4_b <= mul_f24_ftz_unit_copy4_phase_copy2[2] ? mul_f24_ftz_unit_copy4_b_choice_2 : mul_f24_ftz_unit_copy4_b_choice_4;
        mul_mul_add_f24_ftz_unit_a <= mul_mul_add_f24_ftz_unit_phase[2] ? mul_mul_add_f24_ftz_unit_a_choice_2 : mul_mul_add_f24_ftz_unit_a_choice_4;
        mul_mul_add_f24_ftz_unit_b <= mul_mul_add_f24_ftz_unit_phase_copy2[2] ? mul_mul_add_f24_ftz_unit_b_choice : mul_mul_add_f24_ftz_unit_b_choice_3;
        mul_mul_add_f24_ftz_unit_c <= mul_mul_add_f24_ftz_unit_phase_copy3[2] ? mul_mul_add_f24_ftz_unit_c_choice_3 : mul_mul_add_f24_ftz_unit_c_choice_5;
        mul_mul_add_f24_ftz_unit_d <= mul_mul_add_f24_ftz_unit_phase_copy4[2] ? mul_mul_add_f24_ftz_unit_d_choice_3 : mul_mul_add_f24_ftz_unit_d_choice_5;
        mul_mul_add_f24_ftz_unit_copy2_a <= mul_mul_add_f24_ftz_unit_copy2_phase[2] ? mul_mul_add_f24_ftz_unit_copy2_a_choice : mul_mul_add_f24_ftz_unit_copy2_a_choice_4;
        mul_mul_add_f24_ftz_unit_copy2_b <= mul_mul_add_f24_ftz_unit_copy2_phase_copy2[2] ? mul_mul_add_f24_ftz_unit_copy2_b_choice : mul_mul_add_f24_ftz_unit_copy2_b_choice_3;
        mul_mul_add_f24_ftz_unit_copy2_c <= mul_mul_add_f24_ftz_unit_copy2_phase_copy3[2] ? mul_mul_add_f24_ftz_unit_copy2_c_choice : mul_mul_add_f24_ftz_unit_copy2_c_choice_4;
        mul_mul_add_f24_ftz_unit_copy2_d <= mul_mul_add_f24_ftz_unit_copy2_phase_copy4[2] ? mul_mul_add_f24_ftz_unit_copy2_d_choice_2 : mul_mul_add_f24_ftz_unit_copy2_d_choice_4;
        sqrt_f24_ftz_unit_a <= sqrt_f24_ftz_unit_phase[2] ? sqrt_f24_ftz_unit_a_choice : sqrt_f24_ftz_unit_a_choice_2;
        min_f24_ftz_unit_a <= min_f24_ftz_unit_phase[2] ? min_f24_ftz_unit_a_choice : min_f24_ftz_unit_a_choice_2;
        min_f24_ftz_unit_b <= min_f24_ftz_unit_phase_copy2[2] ? min_f24_ftz_unit_b_choice_2 : min_f24_ftz_unit_b_choice_5;
        min_f24_ftz_unit_copy2_a <= min_f24_ftz_unit_copy2_phase[1] ? 24'h470000 : 24'h470000;
        min_f24_ftz_unit_copy2_b <= min_f24_ftz_unit_copy2_phase[1] ? last_difference_chosen_d1 : first_difference_chosen_d1;
        to_fixed_f24_ftz_u21q8_unit_a <= to_fixed_f24_ftz_u21q8_unit_phase[2] ? max_f24_ftz_unit_copy2_y : max_f24_ftz_unit_y;
        to_fixed_f24_ftz_u23q8_unit_a <= to_fixed_f24_ftz_u23q8_unit_phase[2] ? min_f24_ftz_unit_copy2_y : min_f24_ftz_unit_y;
        to_fixed_f24_ftz_s22q8_unit_a <= to_fixed_f24_ftz_s22q8_unit_phase[0] ? center_y_d1_copy2 : add_f24_ftz_unit_y;
        to_fixed_f24_ftz_s27q13_unit_a <= to_fixed_f24_ftz_s27q13_unit_phase[0] ? center_y_d1_copy2 : add_f24_ftz_unit_y;
        to_fixed_f24_ftz_s17q16_unit_a <= to_fixed_f24_ftz_s17q16_unit_phase[2] ? to_fixed_f24_ftz_s17q16_unit_a_choice : to_fixed_f24_ftz_s17q16_unit_a_choice_4;
        to_fixed_f24_ftz_u20q19_unit_a <= to_fixed_f24_ftz_u20q19_unit_phase[1] ? sight_far_out_joined_d1_copy2 : {sight_near_out_bits_d9_copy3, sight_near_out_chosen_copy4};
        to_fixed_f24_ftz_u24q24_unit_a <= to_fixed_f24_ftz_u24q24_unit_phase[2] ? depth_high_out_greater_d1 : to_fixed_f24_ftz_u24q24_unit_a_choice;
    end
    always @(posedge clk) begin
        if (phases_1[0]) delay_7_from_0[delay_7_from_0_pointer] <= one_minus_depth_a_d1;
        if (phases_1[0]) delay_7_from_0_out <= delay_7_from_0[delay_7_from_0_pointer];
    end
    always @(posedge clk) begin
        if (phases_1[0]) delay_9_from_0[delay_9_from_0_pointer] <= first_y_chosen_copy5;
        if (phases_1[0]) delay_9_from_0_out <= delay_9_from_0[delay_9_from_0_pointer];
    end
    always @(posedge clk) begin
        if (phases_1[0]) delay_12_from_0[delay_12_from_0_pointer] <= edge_on_or_visible_unequal;
        if (phases_1[0]) delay_12_from_0_out <= delay_12_from_0[delay_12_from_0_pointer];
    end
    always @(posedge clk) begin
        if (phases_1[0]) delay_21_from_0[delay_21_from_0_pointer] <= in_end;
        if (phases_1[0]) delay_21_from_0_out <= delay_21_from_0[delay_21_from_0_pointer];
    end
    always @(posedge clk) begin
        if (phases_1[0]) begin
            delay_22_from_0[delay_22_from_0_pointer] <= {in_attribute_2, in_attribute_1, in_attribute_0};
        end
        if (phases_1[0]) delay_22_from_0_out <= delay_22_from_0[delay_22_from_0_pointer];
    end
    always @(posedge clk) begin
        if (phases_1[1]) delay_5_from_1[delay_5_from_1_pointer] <= first_y;
        if (phases_1[1]) delay_5_from_1_out <= delay_5_from_1[delay_5_from_1_pointer];
    end
    always @(posedge clk) begin
        if (phases_1[1]) delay_6_from_1[delay_6_from_1_pointer] <= add_f24_ftz_unit_y;
        if (phases_1[1]) delay_6_from_1_out <= delay_6_from_1[delay_6_from_1_pointer];
    end
    always @(posedge clk) begin
        if (phases_1[1]) delay_7_from_1[delay_7_from_1_pointer] <= beyond_near_d1_copy2;
        if (phases_1[1]) delay_7_from_1_out <= delay_7_from_1[delay_7_from_1_pointer];
    end
    always @(posedge clk) begin
        if (phases_1[1]) begin
            delay_11_from_1[delay_11_from_1_pointer] <= {last_y_chosen, first_y_chosen_copy7};
        end
        if (phases_1[1]) delay_11_from_1_out <= delay_11_from_1[delay_11_from_1_pointer];
    end
    always @(posedge clk) begin
        if (phases_1[2]) delay_6_from_2[delay_6_from_2_pointer] <= add_f24_ftz_unit_copy3_y;
        if (phases_1[2]) delay_6_from_2_out <= delay_6_from_2[delay_6_from_2_pointer];
    end
    always @(posedge clk) begin
        if (phases_1[2]) begin
            delay_7_from_2[delay_7_from_2_pointer] <= {add_f24_ftz_unit_copy4_y, 1'd0, mul_f24_ftz_unit_y[22:0]};
        end
        if (phases_1[2]) delay_7_from_2_out <= delay_7_from_2[delay_7_from_2_pointer];
    end
    always @(posedge clk) begin
        if (phases_1[3]) delay_10_from_3[delay_10_from_3_pointer] <= {center_y_out, center_x_out};
        if (phases_1[3]) delay_10_from_3_out <= delay_10_from_3[delay_10_from_3_pointer];
    end
    always @(posedge clk) begin
        if (phases_1[3]) delay_11_from_3[delay_11_from_3_pointer] <= sight_disc_out;
        if (phases_1[3]) delay_11_from_3_out <= delay_11_from_3[delay_11_from_3_pointer];
    end
    always @(posedge clk) begin
        if (phases_1[3]) delay_12_from_3[delay_12_from_3_pointer] <= before_far;
        if (phases_1[3]) delay_12_from_3_out <= delay_12_from_3[delay_12_from_3_pointer];
    end
    always @(posedge clk) begin
        if (phases_1[3]) begin
            delay_14_from_3[delay_14_from_3_pointer] <= {first_difference_difference, first_sum_sum_copy2};
        end
        if (phases_1[3]) delay_14_from_3_out <= delay_14_from_3[delay_14_from_3_pointer];
    end
    always @(posedge clk) begin
        if (phases_1[4]) delay_8_from_4[delay_8_from_4_pointer] <= beyond_near_and_not_turned_d4;
        if (phases_1[4]) delay_8_from_4_out <= delay_8_from_4[delay_8_from_4_pointer];
    end
    always @(posedge clk) begin
        if (phases_1[5]) delay_6_from_5[delay_6_from_5_pointer] <= add_f24_ftz_unit_y;
        if (phases_1[5]) delay_6_from_5_out <= delay_6_from_5[delay_6_from_5_pointer];
    end
    always @(posedge clk) begin
        if (phases_1[5]) delay_7_from_5[delay_7_from_5_pointer] <= to_fixed_f24_ftz_u24q24_unit_y;
        if (phases_1[5]) delay_7_from_5_out <= delay_7_from_5[delay_7_from_5_pointer];
    end
    always @(posedge clk) begin
        if (phases_1[5]) delay_8_from_5[delay_8_from_5_pointer] <= delay_8_from_5_data_bits;
        if (phases_1[5]) delay_8_from_5_out <= delay_8_from_5[delay_8_from_5_pointer];
    end
    always @(posedge clk) begin
        if (phases_2[5]) begin
            delay_9_from_5[delay_9_from_5_pointer] <= {
                1'd0, mul_f24_ftz_unit_copy4_y[14:0], sight_near_out_inverted, my_bits_d1, mx_bits_d1,
                exponent_joined_bits_d1_copy2, exponent_joined_bits_d1, delta_bits_d1, visible_unequal_copy2,
                turned_and_lowered_chosen_sign, half_depth_chosen, turned_d1
            };
        end
        if (phases_2[5]) delay_9_from_5_out <= delay_9_from_5[delay_9_from_5_pointer];
    end
    always @(posedge clk) begin
        if (phases_3[5]) begin
            delay_11_from_5[delay_11_from_5_pointer] <= {
                my[14:0], my[23], mx[14:0], mx[23], exponent_chosen_copy8[14:0], b_y_sign_d3,
                exponent_chosen_copy6[14:0], b_x_sign_d3, turned_d10
            };
        end
        if (phases_3[5]) delay_11_from_5_out <= delay_11_from_5[delay_11_from_5_pointer];
    end
    always @(posedge clk) begin
        if (phases_1[6]) begin
            delay_5_from_6[delay_5_from_6_pointer] <= {center_y_d1_copy2, first_x, add_f24_ftz_unit_y};
        end
        if (phases_1[6]) delay_5_from_6_out <= delay_5_from_6[delay_5_from_6_pointer];
    end
    always @(posedge clk) begin
        if (phases_1[6]) delay_6_from_6[delay_6_from_6_pointer] <= whole_d1;
        if (phases_1[6]) delay_6_from_6_out <= delay_6_from_6[delay_6_from_6_pointer];
    end
    always @(posedge clk) begin
        if (phases_1[6]) delay_7_from_6[delay_7_from_6_pointer] <= all_before_far;
        if (phases_1[6]) delay_7_from_6_out <= delay_7_from_6[delay_7_from_6_pointer];
    end
    always @(posedge clk) begin
        if (phases_1[6]) delay_8_from_6[delay_8_from_6_pointer] <= delay_8_from_5_data_bits;
        if (phases_1[6]) delay_8_from_6_out <= delay_8_from_6[delay_8_from_6_pointer];
    end
    always @(posedge clk) begin
        if (phases_1[6]) begin
            delay_9_from_6[delay_9_from_6_pointer] <= {
                1'd0, mul_f24_ftz_unit_copy4_y[14:0], not_sight_far_out_same, 2'd0, exponent_chosen_copy10[22:15],
                2'd0, exponent_chosen_copy9[22:15]
            };
        end
        if (phases_1[6]) delay_9_from_6_out <= delay_9_from_6[delay_9_from_6_pointer];
    end
    always @(posedge clk) begin
        if (phases_2[6]) begin
            delay_10_from_6[delay_10_from_6_pointer] <= {
                odd_or_edge_on_or_not_placed, not_zero_is_my_bits, not_zero_is_mx_bits, by_out_inverted,
                bx_out_inverted
            };
        end
        if (phases_2[6]) delay_10_from_6_out <= delay_10_from_6[delay_10_from_6_pointer];
    end
    always @(posedge clk) begin
        if (phases_2[6]) begin
            delay_11_from_6[delay_11_from_6_pointer] <= {
                not_zero_is_delta_bits, exponent_chosen_copy10[14:0], exponent_chosen_copy10[23],
                exponent_chosen_copy9[14:0], exponent_chosen_copy9[23]
            };
        end
        if (phases_2[6]) delay_11_from_6_out <= delay_11_from_6[delay_11_from_6_pointer];
    end
    always @(posedge clk) begin
        if (phases_1[6]) delay_14_from_6[delay_14_from_6_pointer] <= whole_and_first_sum_both;
        if (phases_1[6]) delay_14_from_6_out <= delay_14_from_6[delay_14_from_6_pointer];
    end
    always @(posedge clk) begin
        if (phases_1[7]) delay_9_from_7[delay_9_from_7_pointer] <= first_x_chosen_copy5;
        if (phases_1[7]) delay_9_from_7_out <= delay_9_from_7[delay_9_from_7_pointer];
    end
    always @(posedge clk) begin
        if (phases_1[7]) begin
            delay_10_from_7[delay_10_from_7_pointer] <= {delta_d1[14:0], delta_d1[23]};
        end
        if (phases_1[7]) delay_10_from_7_out <= delay_10_from_7[delay_10_from_7_pointer];
    end
    always @(posedge clk) begin
        if (phases_1[7]) begin
            delay_11_from_7[delay_11_from_7_pointer] <= {last_x_chosen, first_x_chosen_copy7};
        end
        if (phases_1[7]) delay_11_from_7_out <= delay_11_from_7[delay_11_from_7_pointer];
    end
    always @(posedge clk) begin
        if (phases_1[7]) delay_12_from_7[delay_12_from_7_pointer] <= sight_negative_out_d1;
        if (phases_1[7]) delay_12_from_7_out <= delay_12_from_7[delay_12_from_7_pointer];
    end
    always @(posedge clk) begin
        if (phases_1[7]) delay_19_from_7[delay_19_from_7_pointer] <= reaches_near;
        if (phases_1[7]) delay_19_from_7_out <= delay_19_from_7[delay_19_from_7_pointer];
    end

    wire _unused = &{
        1'b0, a_x_chosen[10:8], a_y_chosen[10:8], alpha_chosen[10:8], ax_out_chosen[9:8],
        ax_out_lesser[17:16], ax_out_sum[0], ay_out_chosen[9:8], ay_out_lesser[17:16], ay_out_sum[0],
        b_x_chosen[10:8], b_y_chosen[10:8], beta_chosen[10:8], bx_out_chosen[9:8], bx_out_lesser[17:16],
        bx_out_sum[0], by_out_chosen[9:8], by_out_lesser[17:16], by_out_sum[0], center_x_out_lesser[27:26],
        center_x_out_sum[0], center_y_out_lesser[27:26], center_y_out_sum[0], delta_chosen[10:8],
        exponent_chosen[10:8], exponent_chosen_copy3[10:8], exponent_chosen_copy5[10:8],
        exponent_chosen_copy7[10:8], first_difference_sum_copy2[7:0], first_sum_sum_copy3[7:0],
        first_x_chosen_copy2[10:8], first_y_chosen_copy2[10:8], last_difference_sum_copy3[7:0],
        last_sum_sum_copy3[7:0], last_x_lesser_minus_1[21:9], last_y_lesser_minus_1[21:9], mx_chosen[10:8],
        mx_chosen_copy3[10:8], mx_chosen_copy5[10:8], mx_out_chosen[9:8], mx_out_lesser[17:16], mx_out_sum[0],
        my_chosen[10:8], my_out_chosen[9:8], my_out_lesser[17:16], my_out_sum[0], queue_1_in_ready,
        queue_2_in_ready, queue_2_out_valid, queue_3_in_ready, queue_3_out_valid, queue_4_in_ready,
        queue_4_out_valid, reaches_near_chosen_copy2[10:8], shift_chosen[26], shift_chosen_copy2[26],
        shift_chosen_copy3[26], shift_chosen_copy4[26], shift_either_copy3[14:0],
        sight_far_out_chosen_copy2[10:8], sight_near_out_chosen_copy2[10:8], unit_delta_chosen[10:8],
        unit_delta_chosen_copy3[10:8], unit_delta_chosen_copy5[10:8], unit_delta_chosen_copy7[10:8],
        vanishes_chosen[9:8], vanishes_lesser[21:20], vanishes_sum[0]
    };

`ifdef RTL_ASSERT
    wire check_both = (phases_2 == phases_1) & (phases_3 == phases_1) & (phases_4 == phases_1);
    wire check_both_2 = check_both & (phases_5 == phases_1) & (phases_6 == phases_1) & (phases_7 == phases_1);
    wire check_both_3 = check_both_2 & (phases_8 == phases_1) & (phases_9 == phases_1) & (phases_10 == phases_1);
    wire check_both_4 = check_both_3 & (phases_11 == phases_1) & (phases_12 == phases_1) & (phases_13 == phases_1);
    wire check_both_5 = check_both_4 & (phases_14 == phases_1) & (phases_15 == phases_1) & (phases_16 == phases_1);
    wire check_both_6 = check_both_5 & ((max_f24_ftz_unit_phase == 3'd0) == phases_1[0]) & ((max_f24_ftz_unit_phase_copy2 == 3'd0) == phases_1[0]);
    wire check_both_7 = check_both_6 & ((max_f24_ftz_unit_copy2_phase == 3'd0) == phases_1[0]);
    wire check_both_8 = check_both_7 & ((max_f24_ftz_unit_copy2_phase_copy2 == 3'd0) == phases_1[0]);
    wire check_both_9 = check_both_8 & ((add_f24_ftz_unit_phase == 3'd0) == phases_1[0]) & ((add_f24_ftz_unit_phase_copy2 == 3'd0) == phases_1[0]);
    wire check_both_10 = check_both_9 & ((add_f24_ftz_unit_copy2_phase == 3'd0) == phases_1[0]);
    wire check_both_11 = check_both_10 & ((add_f24_ftz_unit_copy2_phase_copy2 == 3'd0) == phases_1[0]);
    wire check_both_12 = check_both_11 & ((add_f24_ftz_unit_copy3_phase == 3'd0) == phases_1[0]);
    wire check_both_13 = check_both_12 & ((add_f24_ftz_unit_copy3_phase_copy2 == 3'd0) == phases_1[0]);
    wire check_both_14 = check_both_13 & ((add_f24_ftz_unit_copy4_phase == 3'd0) == phases_1[0]);
    wire check_both_15 = check_both_14 & ((add_f24_ftz_unit_copy4_phase_copy2 == 3'd0) == phases_1[0]);
    wire check_both_16 = check_both_15 & ((add_f24_ftz_unit_copy5_phase == 3'd0) == phases_1[0]);
    wire check_both_17 = check_both_16 & ((add_f24_ftz_unit_copy5_phase_copy2 == 3'd0) == phases_1[0]);
    wire check_both_18 = check_both_17 & ((recip_f24_ftz_unit_phase == 3'd0) == phases_1[0]);
    wire check_both_19 = check_both_18 & ((mul_f24_ftz_unit_phase == 3'd0) == phases_1[0]);
    wire check_both_20 = check_both_19 & ((mul_f24_ftz_unit_phase_copy2 == 3'd0) == phases_1[0]);
    wire check_both_21 = check_both_20 & ((mul_f24_ftz_unit_copy2_phase == 3'd0) == phases_1[0]);
    wire check_both_22 = check_both_21 & ((mul_f24_ftz_unit_copy2_phase_copy2 == 3'd0) == phases_1[0]);
    wire check_both_23 = check_both_22 & ((mul_f24_ftz_unit_copy3_phase == 3'd0) == phases_1[0]);
    wire check_both_24 = check_both_23 & ((mul_f24_ftz_unit_copy3_phase_copy2 == 3'd0) == phases_1[0]);
    wire check_both_25 = check_both_24 & ((mul_f24_ftz_unit_copy4_phase == 3'd0) == phases_1[0]);
    wire check_both_26 = check_both_25 & ((mul_f24_ftz_unit_copy4_phase_copy2 == 3'd0) == phases_1[0]);
    wire check_both_27 = check_both_26 & ((mul_mul_add_f24_ftz_unit_phase == 3'd0) == phases_1[0]);
    wire check_both_28 = check_both_27 & ((mul_mul_add_f24_ftz_unit_phase_copy2 == 3'd0) == phases_1[0]);
    wire check_both_29 = check_both_28 & ((mul_mul_add_f24_ftz_unit_phase_copy3 == 3'd0) == phases_1[0]);
    wire check_both_30 = check_both_29 & ((mul_mul_add_f24_ftz_unit_phase_copy4 == 3'd0) == phases_1[0]);
    wire check_both_31 = check_both_30 & ((mul_mul_add_f24_ftz_unit_copy2_phase == 3'd0) == phases_1[0]);
    wire check_same = (mul_mul_add_f24_ftz_unit_copy2_phase_copy2 == 3'd0) == phases_1[0];
    wire check_same_2 = (mul_mul_add_f24_ftz_unit_copy2_phase_copy3 == 3'd0) == phases_1[0];
    wire check_same_3 = (mul_mul_add_f24_ftz_unit_copy2_phase_copy4 == 3'd0) == phases_1[0];
    wire check_both_32 = check_both_31 & check_same & check_same_2 & check_same_3 & ((sqrt_f24_ftz_unit_phase == 3'd0) == phases_1[0]);
    wire check_both_33 = check_both_32 & ((min_f24_ftz_unit_phase == 3'd0) == phases_1[0]);
    wire check_both_34 = check_both_33 & ((min_f24_ftz_unit_phase_copy2 == 3'd0) == phases_1[0]);
    wire check_both_35 = check_both_34 & ((min_f24_ftz_unit_copy2_phase == 3'd0) == phases_1[0]);
    wire check_both_36 = check_both_35 & ((to_fixed_f24_ftz_u21q8_unit_phase == 3'd0) == phases_1[0]);
    wire check_both_37 = check_both_36 & ((to_fixed_f24_ftz_u23q8_unit_phase == 3'd0) == phases_1[0]);
    wire check_both_38 = check_both_37 & ((to_fixed_f24_ftz_s22q8_unit_phase == 3'd0) == phases_1[0]);
    wire check_both_39 = check_both_38 & ((to_fixed_f24_ftz_s27q13_unit_phase == 3'd0) == phases_1[0]);
    wire check_both_40 = check_both_39 & ((to_fixed_f24_ftz_s17q16_unit_phase == 3'd0) == phases_1[0]);
    wire check_both_41 = check_both_40 & ((to_fixed_f24_ftz_u20q19_unit_phase == 3'd0) == phases_1[0]);

    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        queue_1_has_a_place_for_each_result: assert (~kept | queue_1_in_ready);
        queue_2_has_a_place_for_each_result: assert (~kept | queue_2_in_ready);
        queue_3_has_a_place_for_each_result: assert (~kept | queue_3_in_ready);
        queue_4_has_a_place_for_each_result: assert (~kept | queue_4_in_ready);
        queue_2_in_step: assert (queue_2_out_valid == out_valid);
        queue_3_in_step: assert (queue_3_out_valid == out_valid);
        queue_4_in_step: assert (queue_4_out_valid == out_valid);
        phases_are_in_step: assert (check_both_41 & ((to_fixed_f24_ftz_u24q24_unit_phase == 3'd0) == phases_1[0]));
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
        if (!(queue_2_out_valid == out_valid)) begin
            $display("assertion failed: queue_2_in_step in %m"); $stop;
        end
        if (!(queue_3_out_valid == out_valid)) begin
            $display("assertion failed: queue_3_in_step in %m"); $stop;
        end
        if (!(queue_4_out_valid == out_valid)) begin
            $display("assertion failed: queue_4_in_step in %m"); $stop;
        end
        if (!(check_both_41 & ((to_fixed_f24_ftz_u24q24_unit_phase == 3'd0) == phases_1[0]))) begin
            $display("assertion failed: phases_are_in_step in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue in a memory with a registered output.
// depth = 23
// width = 40
// storage = distributed
module stream_fifo_d23_w40_distributed (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [39:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [39:0] out_data
);
    (* ram_style = "distributed" *)
    reg [39:0] entries [0:22];
    reg [4:0] held, waiting;
    reg is_full, any_waits;
    reg [4:0] write_address, read_address;
    reg [39:0] item;

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
            write_address <= 5'd0;
            read_address <= 5'd0;
            out_valid <= 1'd0;
        end else begin
            if (push_xor_pop) begin
                held <= held + held_bits;
                is_full <= push & (held == 5'd22);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 5'd1);
            end
            if (push) write_address <= (write_address == 5'd22) ? 5'd0 : (write_address + 5'd1);
            if (fetch) read_address <= (read_address == 5'd22) ? 5'd0 : (read_address + 5'd1);
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
        held_in_range: assert (held <= 5'd23);
        held_is_waiting_and_shown: assert (held == (waiting + {4'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 5'd23)) & (any_waits == |waiting));
`else
        if (!(held <= 5'd23)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {4'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 5'd23)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue in a memory with a registered output.
// depth = 23
// width = 120
// storage = distributed
module stream_fifo_d23_w120_distributed (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [119:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [119:0] out_data
);
    (* ram_style = "distributed" *)
    reg [119:0] entries [0:22];
    reg [4:0] held, waiting;
    reg is_full, any_waits;
    reg [4:0] write_address, read_address;
    reg [119:0] item;

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
            write_address <= 5'd0;
            read_address <= 5'd0;
            out_valid <= 1'd0;
        end else begin
            if (push_xor_pop) begin
                held <= held + held_bits;
                is_full <= push & (held == 5'd22);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 5'd1);
            end
            if (push) write_address <= (write_address == 5'd22) ? 5'd0 : (write_address + 5'd1);
            if (fetch) read_address <= (read_address == 5'd22) ? 5'd0 : (read_address + 5'd1);
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
        held_in_range: assert (held <= 5'd23);
        held_is_waiting_and_shown: assert (held == (waiting + {4'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 5'd23)) & (any_waits == |waiting));
`else
        if (!(held <= 5'd23)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {4'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 5'd23)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue in a memory with a registered output.
// depth = 23
// width = 123
// storage = distributed
module stream_fifo_d23_w123_distributed (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [122:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [122:0] out_data
);
    (* ram_style = "distributed" *)
    reg [122:0] entries [0:22];
    reg [4:0] held, waiting;
    reg is_full, any_waits;
    reg [4:0] write_address, read_address;
    reg [122:0] item;

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
            write_address <= 5'd0;
            read_address <= 5'd0;
            out_valid <= 1'd0;
        end else begin
            if (push_xor_pop) begin
                held <= held + held_bits;
                is_full <= push & (held == 5'd22);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 5'd1);
            end
            if (push) write_address <= (write_address == 5'd22) ? 5'd0 : (write_address + 5'd1);
            if (fetch) read_address <= (read_address == 5'd22) ? 5'd0 : (read_address + 5'd1);
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
        held_in_range: assert (held <= 5'd23);
        held_is_waiting_and_shown: assert (held == (waiting + {4'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 5'd23)) & (any_waits == |waiting));
`else
        if (!(held <= 5'd23)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {4'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 5'd23)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue in a memory with a registered output.
// depth = 23
// width = 117
// storage = distributed
module stream_fifo_d23_w117_distributed (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [116:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [116:0] out_data
);
    (* ram_style = "distributed" *)
    reg [116:0] entries [0:22];
    reg [4:0] held, waiting;
    reg is_full, any_waits;
    reg [4:0] write_address, read_address;
    reg [116:0] item;

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
            write_address <= 5'd0;
            read_address <= 5'd0;
            out_valid <= 1'd0;
        end else begin
            if (push_xor_pop) begin
                held <= held + held_bits;
                is_full <= push & (held == 5'd22);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 5'd1);
            end
            if (push) write_address <= (write_address == 5'd22) ? 5'd0 : (write_address + 5'd1);
            if (fetch) read_address <= (read_address == 5'd22) ? 5'd0 : (read_address + 5'd1);
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
        held_in_range: assert (held <= 5'd23);
        held_is_waiting_and_shown: assert (held == (waiting + {4'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 5'd23)) & (any_waits == |waiting));
`else
        if (!(held <= 5'd23)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {4'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 5'd23)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
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
    input  wire clk, input wire enable, input wire [23:0] a,
    output reg  [23:0] y
);
    reg [4:0] distance_s1;
    reg [15:0] significand_s1;
    reg [23:0] magnitude_s2;
    reg sign_s1, sign_s2, nan_s1, nan_s2, vanishes_s1, vanishes_s2, saturates_s1, saturates_s2;

    wire [7:0] a_field = a[22:15];
    wire [10:0] saturates_s1_sum = {3'd0, a_field} + 11'h79a;
    wire [10:0] distance_s1_difference = 11'd24 - saturates_s1_sum;
    wire [14:0] a_fraction = a[14:0];
    wire vanishes_s1_either = saturates_s1_sum[10] | (saturates_s1_sum == 11'd0);
    wire vanishes_s1_both = &a_field & (a_fraction == 15'd0);

    always @(posedge clk) begin
        if (enable) begin
            distance_s1 <= distance_s1_difference[4:0];
            significand_s1 <= {|a_field, a_fraction & {15{|a_field}}};
            magnitude_s2 <= ({8'd0, significand_s1} << 8) >> distance_s1;
            sign_s1 <= a[23];
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
// format = f24-ftz
// width = 20
// fraction = 19
// integer = unsigned
module float_to_fixed_s3_f24ftz_w20_f19_unsigned (
    input  wire clk, input wire enable, input wire [23:0] a,
    output reg  [19:0] y
);
    reg [4:0] distance_s1;
    reg [15:0] significand_s1;
    reg [19:0] magnitude_s2;
    reg sign_s1, sign_s2, nan_s1, nan_s2, vanishes_s1, vanishes_s2, saturates_s1, saturates_s2;

    wire [7:0] a_field = a[22:15];
    wire [10:0] saturates_s1_sum = {3'd0, a_field} + 11'h795;
    wire [10:0] distance_s1_difference = 11'd20 - saturates_s1_sum;
    wire [14:0] a_fraction = a[14:0];
    wire vanishes_s1_either = saturates_s1_sum[10] | (saturates_s1_sum == 11'd0);
    wire vanishes_s1_both = &a_field & (a_fraction == 15'd0);

    always @(posedge clk) begin
        if (enable) begin
            distance_s1 <= distance_s1_difference[4:0];
            significand_s1 <= {|a_field, a_fraction & {15{|a_field}}};
            magnitude_s2 <= ({4'd0, significand_s1} << 4) >> distance_s1;
            sign_s1 <= a[23];
            sign_s2 <= sign_s1;
            nan_s1 <= &a_field & |a_fraction;
            nan_s2 <= nan_s1;
            vanishes_s1 <= (vanishes_s1_either & ~vanishes_s1_both) | ~(|a_field);
            vanishes_s2 <= vanishes_s1;
            saturates_s1 <= (~vanishes_s1_either & (11'd21 <= saturates_s1_sum) & |a_field) | vanishes_s1_both;
            saturates_s2 <= saturates_s1;
            y <= (vanishes_s2 | nan_s2 | sign_s2) ? 20'd0 : saturates_s2 ? 20'hfffff : magnitude_s2;
        end
    end

    wire _unused = &{1'b0, distance_s1_difference[10:5]};
endmodule

// Floating to fixed point.
// stages = 3
// format = f24-ftz
// width = 21
// fraction = 20
// integer = signed
module float_to_fixed_s3_f24ftz_w21_f20_signed (
    input  wire clk, input wire enable, input wire [23:0] a,
    output reg  [20:0] y
);
    reg [4:0] distance_s1;
    reg [15:0] significand_s1;
    reg [20:0] magnitude_s2;
    reg sign_s1, sign_s2, nan_s1, nan_s2, vanishes_s1, vanishes_s2, saturates_s1, saturates_s2;

    wire [7:0] a_field = a[22:15];
    wire [10:0] saturates_s1_sum = {3'd0, a_field} + 11'h796;
    wire [10:0] distance_s1_difference = 11'd21 - saturates_s1_sum;
    wire [14:0] a_fraction = a[14:0];
    wire vanishes_s1_either = saturates_s1_sum[10] | (saturates_s1_sum == 11'd0);
    wire vanishes_s1_both = &a_field & (a_fraction == 15'd0);
    wire [20:0] y_choice = saturates_s2 ? (sign_s2 ? 21'h100000 : 21'hfffff) : sign_s2 ? (~magnitude_s2 + 21'd1) : magnitude_s2;

    always @(posedge clk) begin
        if (enable) begin
            distance_s1 <= distance_s1_difference[4:0];
            significand_s1 <= {|a_field, a_fraction & {15{|a_field}}};
            magnitude_s2 <= ({5'd0, significand_s1} << 5) >> distance_s1;
            sign_s1 <= a[23];
            sign_s2 <= sign_s1;
            nan_s1 <= &a_field & |a_fraction;
            nan_s2 <= nan_s1;
            vanishes_s1 <= (vanishes_s1_either & ~vanishes_s1_both) | ~(|a_field);
            vanishes_s2 <= vanishes_s1;
            saturates_s1 <= (~vanishes_s1_either & (11'd21 <= saturates_s1_sum) & |a_field) | vanishes_s1_both;
            saturates_s2 <= saturates_s1;
            y <= (vanishes_s2 | nan_s2) ? 21'd0 : y_choice;
        end
    end

    wire _unused = &{1'b0, distance_s1_difference[10:5]};
endmodule

// Floating to fixed point.
// stages = 3
// format = f24-ftz
// width = 17
// fraction = 16
// integer = signed
module float_to_fixed_s3_f24ftz_w17_f16_signed (
    input  wire clk, input wire enable, input wire [23:0] a,
    output reg  [16:0] y
);
    reg [4:0] distance_s1;
    reg [15:0] significand_s1;
    reg [16:0] magnitude_s2;
    reg sign_s1, sign_s2, nan_s1, nan_s2, vanishes_s1, vanishes_s2, saturates_s1, saturates_s2;

    wire [7:0] a_field = a[22:15];
    wire [10:0] saturates_s1_sum = {3'd0, a_field} + 11'h792;
    wire [10:0] distance_s1_difference = 11'd17 - saturates_s1_sum;
    wire [14:0] a_fraction = a[14:0];
    wire vanishes_s1_either = saturates_s1_sum[10] | (saturates_s1_sum == 11'd0);
    wire vanishes_s1_both = &a_field & (a_fraction == 15'd0);
    wire [16:0] y_choice = saturates_s2 ? (sign_s2 ? 17'h10000 : 17'hffff) : sign_s2 ? (~magnitude_s2 + 17'd1) : magnitude_s2;

    always @(posedge clk) begin
        if (enable) begin
            distance_s1 <= distance_s1_difference[4:0];
            significand_s1 <= {|a_field, a_fraction & {15{|a_field}}};
            magnitude_s2 <= ({1'd0, significand_s1} << 1) >> distance_s1;
            sign_s1 <= a[23];
            sign_s2 <= sign_s1;
            nan_s1 <= &a_field & |a_fraction;
            nan_s2 <= nan_s1;
            vanishes_s1 <= (vanishes_s1_either & ~vanishes_s1_both) | ~(|a_field);
            vanishes_s2 <= vanishes_s1;
            saturates_s1 <= (~vanishes_s1_either & (11'd17 <= saturates_s1_sum) & |a_field) | vanishes_s1_both;
            saturates_s2 <= saturates_s1;
            y <= (vanishes_s2 | nan_s2) ? 17'd0 : y_choice;
        end
    end

    wire _unused = &{1'b0, distance_s1_difference[10:5]};
endmodule

// Floating to fixed point.
// stages = 3
// format = f24-ftz
// width = 27
// fraction = 13
// integer = signed
module float_to_fixed_s3_f24ftz_w27_f13_signed (
    input  wire clk, input wire enable, input wire [23:0] a,
    output reg  [26:0] y
);
    reg [4:0] distance_s1;
    reg [15:0] significand_s1;
    reg [26:0] magnitude_s2;
    reg sign_s1, sign_s2, nan_s1, nan_s2, vanishes_s1, vanishes_s2, saturates_s1, saturates_s2;

    wire [7:0] a_field = a[22:15];
    wire [10:0] saturates_s1_sum = {3'd0, a_field} + 11'h78f;
    wire [10:0] distance_s1_difference = 11'd27 - saturates_s1_sum;
    wire [14:0] a_fraction = a[14:0];
    wire vanishes_s1_either = saturates_s1_sum[10] | (saturates_s1_sum == 11'd0);
    wire vanishes_s1_both = &a_field & (a_fraction == 15'd0);
    wire [26:0] y_choice = saturates_s2 ? (sign_s2 ? 27'h4000000 : 27'h3ffffff) : sign_s2 ? (~magnitude_s2 + 27'd1) : magnitude_s2;

    always @(posedge clk) begin
        if (enable) begin
            distance_s1 <= distance_s1_difference[4:0];
            significand_s1 <= {|a_field, a_fraction & {15{|a_field}}};
            magnitude_s2 <= ({11'd0, significand_s1} << 11) >> distance_s1;
            sign_s1 <= a[23];
            sign_s2 <= sign_s1;
            nan_s1 <= &a_field & |a_fraction;
            nan_s2 <= nan_s1;
            vanishes_s1 <= (vanishes_s1_either & ~vanishes_s1_both) | ~(|a_field);
            vanishes_s2 <= vanishes_s1;
            saturates_s1 <= (~vanishes_s1_either & (11'd27 <= saturates_s1_sum) & |a_field) | vanishes_s1_both;
            saturates_s2 <= saturates_s1;
            y <= (vanishes_s2 | nan_s2) ? 27'd0 : y_choice;
        end
    end

    wire _unused = &{1'b0, distance_s1_difference[10:5]};
endmodule

// Floating to fixed point.
// stages = 3
// format = f24-ftz
// width = 22
// fraction = 8
// integer = signed
module float_to_fixed_s3_f24ftz_w22_f8_signed (
    input  wire clk, input wire enable, input wire [23:0] a,
    output reg  [21:0] y
);
    reg [4:0] distance_s1;
    reg [15:0] significand_s1;
    reg [21:0] magnitude_s2;
    reg sign_s1, sign_s2, nan_s1, nan_s2, vanishes_s1, vanishes_s2, saturates_s1, saturates_s2;

    wire [7:0] a_field = a[22:15];
    wire [10:0] saturates_s1_sum = {3'd0, a_field} + 11'h78a;
    wire [10:0] distance_s1_difference = 11'd22 - saturates_s1_sum;
    wire [14:0] a_fraction = a[14:0];
    wire vanishes_s1_either = saturates_s1_sum[10] | (saturates_s1_sum == 11'd0);
    wire vanishes_s1_both = &a_field & (a_fraction == 15'd0);
    wire [21:0] y_choice = saturates_s2 ? (sign_s2 ? 22'h200000 : 22'h1fffff) : sign_s2 ? (~magnitude_s2 + 22'd1) : magnitude_s2;

    always @(posedge clk) begin
        if (enable) begin
            distance_s1 <= distance_s1_difference[4:0];
            significand_s1 <= {|a_field, a_fraction & {15{|a_field}}};
            magnitude_s2 <= ({6'd0, significand_s1} << 6) >> distance_s1;
            sign_s1 <= a[23];
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

    wire _unused = &{1'b0, distance_s1_difference[10:5]};
endmodule

// Floating to fixed point.
// stages = 3
// format = f24-ftz
// width = 23
// fraction = 8
// integer = unsigned
module float_to_fixed_s3_f24ftz_w23_f8_unsigned (
    input  wire clk, input wire enable, input wire [23:0] a,
    output reg  [22:0] y
);
    reg [4:0] distance_s1;
    reg [15:0] significand_s1;
    reg [22:0] magnitude_s2;
    reg sign_s1, sign_s2, nan_s1, nan_s2, vanishes_s1, vanishes_s2, saturates_s1, saturates_s2;

    wire [7:0] a_field = a[22:15];
    wire [10:0] saturates_s1_sum = {3'd0, a_field} + 11'h78a;
    wire [10:0] distance_s1_difference = 11'd23 - saturates_s1_sum;
    wire [14:0] a_fraction = a[14:0];
    wire vanishes_s1_either = saturates_s1_sum[10] | (saturates_s1_sum == 11'd0);
    wire vanishes_s1_both = &a_field & (a_fraction == 15'd0);

    always @(posedge clk) begin
        if (enable) begin
            distance_s1 <= distance_s1_difference[4:0];
            significand_s1 <= {|a_field, a_fraction & {15{|a_field}}};
            magnitude_s2 <= ({7'd0, significand_s1} << 7) >> distance_s1;
            sign_s1 <= a[23];
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

    wire _unused = &{1'b0, distance_s1_difference[10:5]};
endmodule

// Floating to fixed point.
// stages = 3
// format = f24-ftz
// width = 21
// fraction = 8
// integer = unsigned
module float_to_fixed_s3_f24ftz_w21_f8_unsigned (
    input  wire clk, input wire enable, input wire [23:0] a,
    output reg  [20:0] y
);
    reg [4:0] distance_s1;
    reg [15:0] significand_s1;
    reg [20:0] magnitude_s2;
    reg sign_s1, sign_s2, nan_s1, nan_s2, vanishes_s1, vanishes_s2, saturates_s1, saturates_s2;

    wire [7:0] a_field = a[22:15];
    wire [10:0] saturates_s1_sum = {3'd0, a_field} + 11'h78a;
    wire [10:0] distance_s1_difference = 11'd21 - saturates_s1_sum;
    wire [14:0] a_fraction = a[14:0];
    wire vanishes_s1_either = saturates_s1_sum[10] | (saturates_s1_sum == 11'd0);
    wire vanishes_s1_both = &a_field & (a_fraction == 15'd0);

    always @(posedge clk) begin
        if (enable) begin
            distance_s1 <= distance_s1_difference[4:0];
            significand_s1 <= {|a_field, a_fraction & {15{|a_field}}};
            magnitude_s2 <= ({5'd0, significand_s1} << 5) >> distance_s1;
            sign_s1 <= a[23];
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

    wire _unused = &{1'b0, distance_s1_difference[10:5]};
endmodule

// Lesser of two floating-point numbers.
// stages = 2
// format = f24-ftz
module float_min_s2_f24ftz (
    input  wire clk, input wire enable, input wire [23:0] a, input wire [23:0] b,
    output reg  [23:0] y
);
    reg a_nan_s1, b_nan_s1, less_s1;
    reg [23:0] a_s1, b_s1;

    always @(posedge clk) begin
        if (enable) begin
            a_nan_s1 <= &a[22:15] & |a[14:0];
            b_nan_s1 <= &b[22:15] & |b[14:0];
            less_s1 <= {~a[23], a[22:0] ^ {23{a[23]}}} < {~b[23], b[22:0] ^ {23{b[23]}}};
            a_s1 <= {a[23:15], a[14:0] & {15{|a[22:15]}}};
            b_s1 <= {b[23:15], b[14:0] & {15{|b[22:15]}}};
            y <= (a_nan_s1 & b_nan_s1) ? 24'h7fc000 : (b_nan_s1 | (~a_nan_s1 & less_s1)) ? a_s1 : b_s1;
        end
    end
endmodule

// Whether one floating-point number is less than another or equal.
// stages = 2
// format = f24-ftz
module float_le_s2_f24ftz (
    input  wire clk, input wire enable, input wire [23:0] a, input wire [23:0] b,
    output reg  y
);
    reg unordered_s1, both_zero_s1, compared_s1;

    always @(posedge clk) begin
        if (enable) begin
            unordered_s1 <= (&a[22:15] & |a[14:0]) | (&b[22:15] & |b[14:0]);
            both_zero_s1 <= (a[22:15] == 8'd0) & (b[22:15] == 8'd0);
            compared_s1 <= {~a[23], a[22:0] ^ {23{a[23]}}} <= {~b[23], b[22:0] ^ {23{b[23]}}};
            y <= (compared_s1 | both_zero_s1) & ~unordered_s1;
        end
    end
endmodule

// Floating-point square root, correctly rounded.
// stages = 18
// format = f24-ftz
module float_sqrt_s18_f24ftz (
    input  wire clk, input wire enable, input wire [23:0] a,
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
    wire [14:0] remainder_s1_both = a_fraction & {15{|a_field}};
    wire [16:0] remainder_s1_choice = ~a_field[0] ? {|a_field, remainder_s1_both, 1'd0} : {1'd0, |a_field, remainder_s1_both};
    wire [1:0] remainder_s1_difference = remainder_s1_choice[16:15] - 2'd1;
    wire [4:0] remainder_s1_difference_2 = {1'd0, remainder_s1_difference, remainder_s1_choice[14:13]} - 5'd5;
    wire [5:0] remainder_s2_difference = {1'd0, remainder_s1, pending_s1[12:11]} - {2'd0, root_s1, 2'd1};
    wire [6:0] remainder_s3_difference = {1'd0, remainder_s2, pending_s2[10:9]} - {2'd0, root_s2, 2'd1};
    wire [7:0] remainder_s4_difference = {1'd0, remainder_s3, pending_s3[8:7]} - {2'd0, root_s3, 2'd1};
    wire [8:0] remainder_s5_difference = {1'd0, remainder_s4, pending_s4[6:5]} - {2'd0, root_s4, 2'd1};
    wire [9:0] remainder_s6_difference = {1'd0, remainder_s5, pending_s5[4:3]} - {2'd0, root_s5, 2'd1};
    wire [10:0] remainder_s7_difference = {1'd0, remainder_s6, pending_s6[2:1]} - {2'd0, root_s6, 2'd1};
    wire [11:0] remainder_s8_difference = {1'd0, remainder_s7, pending_s7, 1'd0} - {2'd0, root_s7, 2'd1};
    wire [12:0] remainder_s9_difference = {1'd0, remainder_s8, 2'd0} - {2'd0, root_s8, 2'd1};
    wire [13:0] remainder_s10_difference = {1'd0, remainder_s9, 2'd0} - {2'd0, root_s9, 2'd1};
    wire [14:0] remainder_s11_difference = {1'd0, remainder_s10, 2'd0} - {2'd0, root_s10, 2'd1};
    wire [15:0] remainder_s12_difference = {1'd0, remainder_s11, 2'd0} - {2'd0, root_s11, 2'd1};
    wire [16:0] remainder_s13_difference = {1'd0, remainder_s12, 2'd0} - {2'd0, root_s12, 2'd1};
    wire [17:0] remainder_s14_difference = {1'd0, remainder_s13, 2'd0} - {2'd0, root_s13, 2'd1};
    wire [18:0] remainder_s15_difference = {1'd0, remainder_s14, 2'd0} - {2'd0, root_s14, 2'd1};
    wire [19:0] remainder_s16_difference = {1'd0, remainder_s15, 2'd0} - {2'd0, root_s15, 2'd1};
    wire [9:0] a_field_plus_127 = {2'd0, a_field} + 10'd127;
    wire zero_s17_either = exponent_s16[9] | ((exponent_s16 == 10'd0) & ~(&root_s16[15:1] & root_s16[0]));
    wire round_up = root_s16[0] & (|remainder_s16 | root_s16[1]);
    wire [22:0] rounded = {exponent_s16[7:0], root_s16[15:1]} + {22'd0, round_up};
    wire [23:0] y_bits = {sign_s17, zero_s17 ? 23'd0 : infinite_s17 ? 23'h7f8000 : rounded_s17};

    always @(posedge clk) begin
        if (enable) begin
            remainder_s1 <= ~remainder_s1_difference_2[4] ? remainder_s1_difference_2[2:0] : {remainder_s1_difference[0], remainder_s1_choice[14:13]};
            root_s1 <= {1'd1, ~remainder_s1_difference_2[4]};
            pending_s1 <= remainder_s1_choice[12:0];
            remainder_s2 <= ~remainder_s2_difference[5] ? remainder_s2_difference[3:0] : {remainder_s1[1:0], pending_s1[12:11]};
            root_s2 <= {root_s1, ~remainder_s2_difference[5]};
            pending_s2 <= pending_s1[10:0];
            remainder_s3 <= ~remainder_s3_difference[6] ? remainder_s3_difference[4:0] : {remainder_s2[2:0], pending_s2[10:9]};
            root_s3 <= {root_s2, ~remainder_s3_difference[6]};
            pending_s3 <= pending_s2[8:0];
            remainder_s4 <= ~remainder_s4_difference[7] ? remainder_s4_difference[5:0] : {remainder_s3[3:0], pending_s3[8:7]};
            root_s4 <= {root_s3, ~remainder_s4_difference[7]};
            pending_s4 <= pending_s3[6:0];
            remainder_s5 <= ~remainder_s5_difference[8] ? remainder_s5_difference[6:0] : {remainder_s4[4:0], pending_s4[6:5]};
            root_s5 <= {root_s4, ~remainder_s5_difference[8]};
            pending_s5 <= pending_s4[4:0];
            remainder_s6 <= ~remainder_s6_difference[9] ? remainder_s6_difference[7:0] : {remainder_s5[5:0], pending_s5[4:3]};
            root_s6 <= {root_s5, ~remainder_s6_difference[9]};
            pending_s6 <= pending_s5[2:0];
            remainder_s7 <= ~remainder_s7_difference[10] ? remainder_s7_difference[8:0] : {remainder_s6[6:0], pending_s6[2:1]};
            root_s7 <= {root_s6, ~remainder_s7_difference[10]};
            pending_s7 <= pending_s6[0];
            remainder_s8 <= ~remainder_s8_difference[11] ? remainder_s8_difference[9:0] : {remainder_s7[7:0], pending_s7, 1'd0};
            root_s8 <= {root_s7, ~remainder_s8_difference[11]};
            remainder_s9 <= ~remainder_s9_difference[12] ? remainder_s9_difference[10:0] : {remainder_s8[8:0], 2'd0};
            root_s9 <= {root_s8, ~remainder_s9_difference[12]};
            remainder_s10 <= ~remainder_s10_difference[13] ? remainder_s10_difference[11:0] : {remainder_s9[9:0], 2'd0};
            root_s10 <= {root_s9, ~remainder_s10_difference[13]};
            remainder_s11 <= ~remainder_s11_difference[14] ? remainder_s11_difference[12:0] : {remainder_s10[10:0], 2'd0};
            root_s11 <= {root_s10, ~remainder_s11_difference[14]};
            remainder_s12 <= ~remainder_s12_difference[15] ? remainder_s12_difference[13:0] : {remainder_s11[11:0], 2'd0};
            root_s12 <= {root_s11, ~remainder_s12_difference[15]};
            remainder_s13 <= ~remainder_s13_difference[16] ? remainder_s13_difference[14:0] : {remainder_s12[12:0], 2'd0};
            root_s13 <= {root_s12, ~remainder_s13_difference[16]};
            remainder_s14 <= ~remainder_s14_difference[17] ? remainder_s14_difference[15:0] : {remainder_s13[13:0], 2'd0};
            root_s14 <= {root_s13, ~remainder_s14_difference[17]};
            remainder_s15 <= ~remainder_s15_difference[18] ? remainder_s15_difference[16:0] : {remainder_s14[14:0], 2'd0};
            root_s15 <= {root_s14, ~remainder_s15_difference[18]};
            remainder_s16 <= ~remainder_s16_difference[19] ? remainder_s16_difference[17:0] : {remainder_s15[15:0], 2'd0};
            root_s16 <= {root_s15, ~remainder_s16_difference[19]};
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
            zero_s17 <= zero_s16 | (zero_s17_either & ~infinite_s16);
            rounded_s17 <= rounded;
            y <= nan_s17 ? 24'h7fc000 : y_bits;
        end
    end

    wire _unused = &{
        1'b0, a_field_plus_127[0], remainder_s10_difference[12], remainder_s11_difference[13],
        remainder_s12_difference[14], remainder_s13_difference[15], remainder_s14_difference[16],
        remainder_s15_difference[17], remainder_s16_difference[18], remainder_s1_difference_2[3],
        remainder_s2_difference[4], remainder_s3_difference[5], remainder_s4_difference[6],
        remainder_s5_difference[7], remainder_s6_difference[8], remainder_s7_difference[9],
        remainder_s8_difference[10], remainder_s9_difference[11], root_s16[16]
    };
endmodule

// Floating-point sum with products, each of them rounded.
// product_stages = 5
// sum_stages = 6
// format = f24-ftz
module mul_mul_add_p5_s6_f24ftz (
    input  wire clk, input wire enable, input wire [23:0] a, input wire [23:0] b, input wire [23:0] c,
    input  wire [23:0] d,
    output wire [23:0] y
);
    wire [23:0] product_y, second_product_y;

    float_mul_s5_f24ftz product (.clk(clk), .enable(enable), .a(a), .b(b), .y(product_y));
    float_mul_s5_f24ftz second_product (.clk(clk), .enable(enable), .a(c), .b(d), .y(second_product_y));
    float_add_s6_f24ftz sum (.clk(clk), .enable(enable), .a(product_y), .b(second_product_y), .y(y));
endmodule

// Floating-point product.
// stages = 5
// format = f24-ftz
module float_mul_s5_f24ftz (
    input  wire clk, input wire enable, input wire [23:0] a, input wire [23:0] b,
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
    wire [31:0] significand_s3_choice = product_s2[31] ? product_s2 : (product_s2 << 1);
    wire nan_s1_both = &a_field & (a_fraction == 15'd0);
    wire nan_s1_inverted = ~(|b_field);
    wire nan_s1_either = (&a_field & |a_fraction) | (&b_field & |b_fraction) | (nan_s1_both & nan_s1_inverted);
    wire nan_s1_inverted_2 = ~(|a_field);
    wire nan_s1_both_2 = &b_field & (b_fraction == 15'd0);
    wire zero_s4_both = (exponent_s3 == 10'd0) & ~(&significand_s3[16:2] & significand_s3[1]);
    wire round_up = significand_s3[1] & (significand_s3[0] | significand_s3[2]);
    wire [22:0] rounded = {exponent_s3[7:0], significand_s3[16:2]} + {22'd0, round_up};
    wire [23:0] y_bits = {sign_s4, zero_s4 ? 23'd0 : infinite_s4 ? 23'h7f8000 : rounded_s4};

    always @(posedge clk) begin
        if (enable) begin
            left_s1 <= {|a_field, a_fraction & {15{|a_field}}};
            right_s1 <= {|b_field, b_fraction & {15{|b_field}}};
            exponent_s1 <= {2'd0, a_field} + {2'd0, b_field};
            product_s2 <= {16'd0, left_s1} * {16'd0, right_s1};
            exponent_s2 <= exponent_s1 - 10'd127;
            exponent_s3 <= exponent_s2 + {9'd0, product_s2[31]};
            significand_s3 <= {significand_s3_choice[31:15], |significand_s3_choice[14:0]};
            sign_s1 <= a[23] ^ b[23];
            sign_s2 <= sign_s1;
            sign_s3 <= sign_s2;
            nan_s1 <= nan_s1_either | (nan_s1_inverted_2 & nan_s1_both_2);
            nan_s2 <= nan_s1;
            nan_s3 <= nan_s2;
            infinite_s1 <= nan_s1_both | nan_s1_both_2;
            infinite_s2 <= infinite_s1;
            infinite_s3 <= infinite_s2;
            zero_s1 <= nan_s1_inverted_2 | nan_s1_inverted;
            zero_s2 <= zero_s1;
            zero_s3 <= zero_s2;
            sign_s4 <= sign_s3;
            nan_s4 <= nan_s3;
            infinite_s4 <= infinite_s3 | (~exponent_s3[9] & (10'd255 <= exponent_s3));
            zero_s4 <= zero_s3 | ((exponent_s3[9] | zero_s4_both) & ~infinite_s3);
            rounded_s4 <= rounded;
            y <= nan_s4 ? 24'h7fc000 : y_bits;
        end
    end

    wire _unused = &{1'b0, significand_s3[17]};
endmodule

// Floating-point reciprocal, correctly rounded.
// stages = 20
// format = f24-ftz
module float_recip_s20_f24ftz (
    input  wire clk, input wire enable, input wire [23:0] a,
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
    wire [14:0] remainder_s1_both = a_fraction & {15{|a_field}};
    wire [17:0] remainder_s1_difference = 18'h8000 - {2'd0, |a_field, remainder_s1_both};
    wire [15:0] remainder_s1_choice = ~remainder_s1_difference[17] ? remainder_s1_difference[15:0] : 16'h8000;
    wire [17:0] remainder_s1_minus_divisor_s1 = {1'd0, remainder_s1} - {2'd0, divisor_s1};
    wire [15:0] remainder_s2_choice = ~remainder_s1_minus_divisor_s1[17] ? remainder_s1_minus_divisor_s1[15:0] : remainder_s1[15:0];
    wire [17:0] remainder_s2_minus_divisor_s2 = {1'd0, remainder_s2} - {2'd0, divisor_s2};
    wire [15:0] remainder_s3_choice = ~remainder_s2_minus_divisor_s2[17] ? remainder_s2_minus_divisor_s2[15:0] : remainder_s2[15:0];
    wire [17:0] remainder_s3_minus_divisor_s3 = {1'd0, remainder_s3} - {2'd0, divisor_s3};
    wire [15:0] remainder_s4_choice = ~remainder_s3_minus_divisor_s3[17] ? remainder_s3_minus_divisor_s3[15:0] : remainder_s3[15:0];
    wire [17:0] remainder_s4_minus_divisor_s4 = {1'd0, remainder_s4} - {2'd0, divisor_s4};
    wire [15:0] remainder_s5_choice = ~remainder_s4_minus_divisor_s4[17] ? remainder_s4_minus_divisor_s4[15:0] : remainder_s4[15:0];
    wire [17:0] remainder_s5_minus_divisor_s5 = {1'd0, remainder_s5} - {2'd0, divisor_s5};
    wire [15:0] remainder_s6_choice = ~remainder_s5_minus_divisor_s5[17] ? remainder_s5_minus_divisor_s5[15:0] : remainder_s5[15:0];
    wire [17:0] remainder_s6_minus_divisor_s6 = {1'd0, remainder_s6} - {2'd0, divisor_s6};
    wire [15:0] remainder_s7_choice = ~remainder_s6_minus_divisor_s6[17] ? remainder_s6_minus_divisor_s6[15:0] : remainder_s6[15:0];
    wire [17:0] remainder_s7_minus_divisor_s7 = {1'd0, remainder_s7} - {2'd0, divisor_s7};
    wire [15:0] remainder_s8_choice = ~remainder_s7_minus_divisor_s7[17] ? remainder_s7_minus_divisor_s7[15:0] : remainder_s7[15:0];
    wire [17:0] remainder_s8_minus_divisor_s8 = {1'd0, remainder_s8} - {2'd0, divisor_s8};
    wire [15:0] remainder_s9_choice = ~remainder_s8_minus_divisor_s8[17] ? remainder_s8_minus_divisor_s8[15:0] : remainder_s8[15:0];
    wire [17:0] remainder_s9_minus_divisor_s9 = {1'd0, remainder_s9} - {2'd0, divisor_s9};
    wire [15:0] remainder_s10_choice = ~remainder_s9_minus_divisor_s9[17] ? remainder_s9_minus_divisor_s9[15:0] : remainder_s9[15:0];
    wire [17:0] remainder_s11_difference = {1'd0, remainder_s10} - {2'd0, divisor_s10};
    wire [15:0] remainder_s11_choice = ~remainder_s11_difference[17] ? remainder_s11_difference[15:0] : remainder_s10[15:0];
    wire [17:0] remainder_s12_difference = {1'd0, remainder_s11} - {2'd0, divisor_s11};
    wire [15:0] remainder_s12_choice = ~remainder_s12_difference[17] ? remainder_s12_difference[15:0] : remainder_s11[15:0];
    wire [17:0] remainder_s13_difference = {1'd0, remainder_s12} - {2'd0, divisor_s12};
    wire [15:0] remainder_s13_choice = ~remainder_s13_difference[17] ? remainder_s13_difference[15:0] : remainder_s12[15:0];
    wire [17:0] remainder_s14_difference = {1'd0, remainder_s13} - {2'd0, divisor_s13};
    wire [15:0] remainder_s14_choice = ~remainder_s14_difference[17] ? remainder_s14_difference[15:0] : remainder_s13[15:0];
    wire [17:0] remainder_s15_difference = {1'd0, remainder_s14} - {2'd0, divisor_s14};
    wire [15:0] remainder_s15_choice = ~remainder_s15_difference[17] ? remainder_s15_difference[15:0] : remainder_s14[15:0];
    wire [17:0] remainder_s16_difference = {1'd0, remainder_s15} - {2'd0, divisor_s15};
    wire [15:0] remainder_s16_choice = ~remainder_s16_difference[17] ? remainder_s16_difference[15:0] : remainder_s15[15:0];
    wire [17:0] remainder_s17_difference = {1'd0, remainder_s16} - {2'd0, divisor_s16};
    wire [15:0] remainder_s17_choice = ~remainder_s17_difference[17] ? remainder_s17_difference[15:0] : remainder_s16[15:0];
    wire [17:0] remainder_s18_difference = {1'd0, remainder_s17} - {2'd0, divisor_s17};
    wire [15:0] remainder_s18_choice = ~remainder_s18_difference[17] ? remainder_s18_difference[15:0] : remainder_s17[15:0];
    wire [18:0] significand_s19_bits = {quotient_s18, |remainder_s18};
    wire [18:0] significand_s19_choice = ~quotient_s18[17] ? (significand_s19_bits << 1) : significand_s19_bits;
    wire y_both = (exponent_s19 == 10'd0) & ~(&significand_s19[16:2] & significand_s19[1]);
    wire round_up = significand_s19[1] & (significand_s19[0] | significand_s19[2]);
    wire [22:0] rounded = {exponent_s19[7:0], significand_s19[16:2]} + {22'd0, round_up};
    wire [22:0] y_choice = (infinite_s19 | (~exponent_s19[9] & (10'd255 <= exponent_s19))) ? 23'h7f8000 : rounded;
    wire [22:0] y_choice_2 = (zero_s19 | ((exponent_s19[9] | y_both) & ~infinite_s19)) ? 23'd0 : y_choice;

    always @(posedge clk) begin
        if (enable) begin
            remainder_s1 <= {remainder_s1_choice, 1'd0};
            quotient_s1 <= ~remainder_s1_difference[17];
            divisor_s1 <= {|a_field, remainder_s1_both};
            remainder_s2 <= {remainder_s2_choice, 1'd0};
            quotient_s2 <= {quotient_s1, ~remainder_s1_minus_divisor_s1[17]};
            divisor_s2 <= divisor_s1;
            remainder_s3 <= {remainder_s3_choice, 1'd0};
            quotient_s3 <= {quotient_s2, ~remainder_s2_minus_divisor_s2[17]};
            divisor_s3 <= divisor_s2;
            remainder_s4 <= {remainder_s4_choice, 1'd0};
            quotient_s4 <= {quotient_s3, ~remainder_s3_minus_divisor_s3[17]};
            divisor_s4 <= divisor_s3;
            remainder_s5 <= {remainder_s5_choice, 1'd0};
            quotient_s5 <= {quotient_s4, ~remainder_s4_minus_divisor_s4[17]};
            divisor_s5 <= divisor_s4;
            remainder_s6 <= {remainder_s6_choice, 1'd0};
            quotient_s6 <= {quotient_s5, ~remainder_s5_minus_divisor_s5[17]};
            divisor_s6 <= divisor_s5;
            remainder_s7 <= {remainder_s7_choice, 1'd0};
            quotient_s7 <= {quotient_s6, ~remainder_s6_minus_divisor_s6[17]};
            divisor_s7 <= divisor_s6;
            remainder_s8 <= {remainder_s8_choice, 1'd0};
            quotient_s8 <= {quotient_s7, ~remainder_s7_minus_divisor_s7[17]};
            divisor_s8 <= divisor_s7;
            remainder_s9 <= {remainder_s9_choice, 1'd0};
            quotient_s9 <= {quotient_s8, ~remainder_s8_minus_divisor_s8[17]};
            divisor_s9 <= divisor_s8;
            remainder_s10 <= {remainder_s10_choice, 1'd0};
            quotient_s10 <= {quotient_s9, ~remainder_s9_minus_divisor_s9[17]};
            divisor_s10 <= divisor_s9;
            remainder_s11 <= {remainder_s11_choice, 1'd0};
            quotient_s11 <= {quotient_s10, ~remainder_s11_difference[17]};
            divisor_s11 <= divisor_s10;
            remainder_s12 <= {remainder_s12_choice, 1'd0};
            quotient_s12 <= {quotient_s11, ~remainder_s12_difference[17]};
            divisor_s12 <= divisor_s11;
            remainder_s13 <= {remainder_s13_choice, 1'd0};
            quotient_s13 <= {quotient_s12, ~remainder_s13_difference[17]};
            divisor_s13 <= divisor_s12;
            remainder_s14 <= {remainder_s14_choice, 1'd0};
            quotient_s14 <= {quotient_s13, ~remainder_s14_difference[17]};
            divisor_s14 <= divisor_s13;
            remainder_s15 <= {remainder_s15_choice, 1'd0};
            quotient_s15 <= {quotient_s14, ~remainder_s15_difference[17]};
            divisor_s15 <= divisor_s14;
            remainder_s16 <= {remainder_s16_choice, 1'd0};
            quotient_s16 <= {quotient_s15, ~remainder_s16_difference[17]};
            divisor_s16 <= divisor_s15;
            remainder_s17 <= {remainder_s17_choice, 1'd0};
            quotient_s17 <= {quotient_s16, ~remainder_s17_difference[17]};
            divisor_s17 <= divisor_s16;
            remainder_s18 <= {remainder_s18_choice, 1'd0};
            quotient_s18 <= {quotient_s17, ~remainder_s18_difference[17]};
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
            significand_s19 <= {significand_s19_choice[18:2], |significand_s19_choice[1:0]};
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
            y <= nan_s19 ? 24'h7fc000 : {sign_s19, y_choice_2};
        end
    end

    wire _unused = &{
        1'b0, remainder_s11_difference[16], remainder_s12_difference[16], remainder_s13_difference[16],
        remainder_s14_difference[16], remainder_s15_difference[16], remainder_s16_difference[16],
        remainder_s17_difference[16], remainder_s18_difference[16], remainder_s1_difference[16],
        remainder_s1_minus_divisor_s1[16], remainder_s2_minus_divisor_s2[16],
        remainder_s3_minus_divisor_s3[16], remainder_s4_minus_divisor_s4[16],
        remainder_s5_minus_divisor_s5[16], remainder_s6_minus_divisor_s6[16],
        remainder_s7_minus_divisor_s7[16], remainder_s8_minus_divisor_s8[16],
        remainder_s9_minus_divisor_s9[16], significand_s19[17]
    };
endmodule

// World space to camera space.
// latency = 34
// initiation_interval = 8
module splat_transform (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready,  // Splats in world space.
    input  wire in_end,  // Closes the frame.
    input  wire [23:0] in_center_x,  // Center.
    input  wire [23:0] in_center_y,  // Center.
    input  wire [23:0] in_center_z,  // Center.
    input  wire [23:0] in_tangent1_x,  // Tangents, whose ends lie at rho = 1.
    input  wire [23:0] in_tangent1_y,  // Tangents, whose ends lie at rho = 1.
    input  wire [23:0] in_tangent1_z,  // Tangents, whose ends lie at rho = 1.
    input  wire [23:0] in_tangent2_x,  // Tangents, whose ends lie at rho = 1.
    input  wire [23:0] in_tangent2_y,  // Tangents, whose ends lie at rho = 1.
    input  wire [23:0] in_tangent2_z,  // Tangents, whose ends lie at rho = 1.
    input  wire [11:0] in_attribute_0,  // Attributes.
    input  wire [11:0] in_attribute_1,  // Attributes.
    input  wire [11:0] in_attribute_2,  // Attributes.
    input  wire [23:0] m00,  // By rows; the last row is (0, 0, 0, 1).
    input  wire [23:0] m01,  // By rows; the last row is (0, 0, 0, 1).
    input  wire [23:0] m02,  // By rows; the last row is (0, 0, 0, 1).
    input  wire [23:0] m03,  // By rows; the last row is (0, 0, 0, 1).
    input  wire [23:0] m10,  // By rows; the last row is (0, 0, 0, 1).
    input  wire [23:0] m11,  // By rows; the last row is (0, 0, 0, 1).
    input  wire [23:0] m12,  // By rows; the last row is (0, 0, 0, 1).
    input  wire [23:0] m13,  // By rows; the last row is (0, 0, 0, 1).
    input  wire [23:0] m20,  // By rows; the last row is (0, 0, 0, 1).
    input  wire [23:0] m21,  // By rows; the last row is (0, 0, 0, 1).
    input  wire [23:0] m22,  // By rows; the last row is (0, 0, 0, 1).
    input  wire [23:0] m23,  // By rows; the last row is (0, 0, 0, 1).
    input  wire [23:0] near_plane,  // Near plane.
    output wire out_valid, input wire out_ready,  // Splats in camera space.
    output wire out_end,  // Closes the frame.
    output wire [23:0] out_center_x,  // Center.
    output wire [23:0] out_center_y,  // Center.
    output wire [23:0] out_center_z,  // Center.
    output wire [23:0] out_tangent1_x,  // Tangents, whose ends lie at rho = 1.
    output wire [23:0] out_tangent1_y,  // Tangents, whose ends lie at rho = 1.
    output wire [23:0] out_tangent1_z,  // Tangents, whose ends lie at rho = 1.
    output wire [23:0] out_tangent2_x,  // Tangents, whose ends lie at rho = 1.
    output wire [23:0] out_tangent2_y,  // Tangents, whose ends lie at rho = 1.
    output wire [23:0] out_tangent2_z,  // Tangents, whose ends lie at rho = 1.
    output wire [11:0] out_attribute_0,  // Attributes.
    output wire [11:0] out_attribute_1,  // Attributes.
    output wire [11:0] out_attribute_2  // Attributes.
);
    (* ram_style = "distributed" *)
    reg [36:0] delay_5_from_0 [0:3];
    reg [3:0] credits;
    reg [7:0] phases_1;
    reg [1:0] delay_5_from_0_pointer;
    reg [36:0] delay_5_from_0_out;
    reg [23:0] center_x_d1, center_y_d1, center_z_d1;
    reg [7:0] phases_2;
    reg [23:0] center_z_d2, u_y_sum_d1, u_x_d1, u_z_d1, u_z_d2, tangent1_x_d1, tangent1_y_d1, tangent1_z_d1;
    reg [23:0] tangent1_z_d2, v1_x_d1, v1_x_d2, v1_y_d1, v1_y_d2, v1_z_d1, v1_z_d2;
    reg [7:0] phases_3;
    reg [23:0] tangent2_x_d1, tangent2_y_d1, tangent2_z_d1, tangent2_z_d2, v2_x_d1;
    reg [7:0] phases_4;
    reg [23:0] v2_x_d2, v2_y_d1, v2_y_d2, m20_times_tangent2_x_d1, m22_times_tangent2_z_d1, v2_z_d1, v2_z_d2;
    reg [23:0] kept_joined_d1;
    reg kept_greater_bits_is_zero_d1;
    reg [23:0] kept_chosen_d1;
    reg [2:0] mul_mul_add_f24_ftz_unit_phase;
    reg [23:0] mul_mul_add_f24_ftz_unit_a;
    reg [2:0] mul_mul_add_f24_ftz_unit_phase_copy2;
    reg [23:0] mul_mul_add_f24_ftz_unit_b;
    reg [2:0] mul_mul_add_f24_ftz_unit_phase_copy3;
    reg [23:0] mul_mul_add_f24_ftz_unit_c;
    reg [2:0] mul_mul_add_f24_ftz_unit_phase_copy4;
    reg [23:0] mul_mul_add_f24_ftz_unit_d;
    reg [2:0] mul_add_f24_ftz_unit_phase;
    reg [23:0] mul_add_f24_ftz_unit_a;
    reg [2:0] mul_add_f24_ftz_unit_phase_copy2;
    reg [23:0] mul_add_f24_ftz_unit_b, mul_add_f24_ftz_unit_c;
    reg [2:0] add_f24_ftz_unit_phase;
    reg [23:0] add_f24_ftz_unit_a;
    reg [2:0] add_f24_ftz_unit_phase_copy2;
    reg [23:0] add_f24_ftz_unit_b;
    reg [2:0] mul_f24_ftz_unit_phase;
    reg [23:0] mul_f24_ftz_unit_a, mul_f24_ftz_unit_b;
    reg [4:0] in_flight;
    reg left, dropped;

    wire [23:0] mul_mul_add_f24_ftz_unit_y, mul_add_f24_ftz_unit_y, add_f24_ftz_unit_y, mul_f24_ftz_unit_y;
    wire lt_f24_ftz_unit_y, lt_f24_ftz_unit_copy2_y;
    wire [23:0] max_f24_ftz_unit_y;
    wire queue_1_in_ready;
    wire [120:0] queue_1_out_data;
    wire queue_2_in_ready, queue_2_out_valid;
    wire [119:0] queue_2_out_data;
    wire queue_3_in_ready, queue_3_out_valid;

    assign in_ready = ~credits[3] & phases_1[0];
    wire in_flight_4_and_phases_1_2 = in_flight[4] & phases_1[2];
    wire end_d5 = delay_5_from_0_out[0];
    wire kept_either = lt_f24_ftz_unit_y | lt_f24_ftz_unit_copy2_y;
    wire end_or_kept_either = end_d5 | kept_either;
    wire kept = in_flight_4_and_phases_1_2 & end_or_kept_either;
    wire [11:0] attribute_0_d5 = delay_5_from_0_out[12:1];
    wire [11:0] attribute_1_d5 = delay_5_from_0_out[24:13];
    wire [11:0] attribute_2_d5 = delay_5_from_0_out[36:25];
    wire in_valid_and_in_ready = in_valid & in_ready;
    wire kept_greater_bits_is_255 = max_f24_ftz_unit_y[22:15] == 8'd255;
    wire [7:0] kept_greater_bits_plus_1 = max_f24_ftz_unit_y[22:15] + 8'd1;
    wire [7:0] kept_chosen = kept_greater_bits_is_255 ? max_f24_ftz_unit_y[22:15] : kept_greater_bits_plus_1;
    wire kept_greater_bits_is_254 = max_f24_ftz_unit_y[22:15] == 8'd254;
    wire [14:0] kept_chosen_copy2 = kept_greater_bits_is_254 ? 15'd0 : max_f24_ftz_unit_y[14:0];
    wire kept_greater_bits_is_zero = max_f24_ftz_unit_y[22:15] == 8'd0;
    wire [23:0] kept_chosen_copy3 = kept_greater_bits_is_zero_d1 ? 24'd0 : kept_joined_d1;
    wire [23:0] mul_mul_add_f24_ftz_unit_a_choice = mul_mul_add_f24_ftz_unit_phase[0] ? m10 : m00;
    wire [23:0] mul_mul_add_f24_ftz_unit_a_choice_2 = mul_mul_add_f24_ftz_unit_phase[1] ? mul_mul_add_f24_ftz_unit_a_choice : mul_mul_add_f24_ftz_unit_a_choice;
    wire [23:0] mul_mul_add_f24_ftz_unit_a_choice_3 = mul_mul_add_f24_ftz_unit_phase[1] ? mul_mul_add_f24_ftz_unit_a_choice : m20;
    wire [23:0] mul_mul_add_f24_ftz_unit_b_choice = mul_mul_add_f24_ftz_unit_phase_copy2[1] ? tangent2_x_d1 : tangent1_x_d1;
    wire [23:0] mul_mul_add_f24_ftz_unit_b_choice_2 = mul_mul_add_f24_ftz_unit_phase_copy2[0] ? tangent1_x_d1 : in_center_x;
    wire [23:0] mul_mul_add_f24_ftz_unit_b_choice_3 = mul_mul_add_f24_ftz_unit_phase_copy2[1] ? center_x_d1 : mul_mul_add_f24_ftz_unit_b_choice_2;
    wire [23:0] mul_mul_add_f24_ftz_unit_c_choice = mul_mul_add_f24_ftz_unit_phase_copy3[0] ? m11 : m01;
    wire [23:0] mul_mul_add_f24_ftz_unit_c_choice_2 = mul_mul_add_f24_ftz_unit_phase_copy3[1] ? mul_mul_add_f24_ftz_unit_c_choice : mul_mul_add_f24_ftz_unit_c_choice;
    wire [23:0] mul_mul_add_f24_ftz_unit_c_choice_3 = mul_mul_add_f24_ftz_unit_phase_copy3[1] ? mul_mul_add_f24_ftz_unit_c_choice : m21;
    wire [23:0] mul_mul_add_f24_ftz_unit_d_choice = mul_mul_add_f24_ftz_unit_phase_copy4[1] ? tangent2_y_d1 : tangent1_y_d1;
    wire [23:0] mul_mul_add_f24_ftz_unit_d_choice_2 = mul_mul_add_f24_ftz_unit_phase_copy4[0] ? tangent1_y_d1 : in_center_y;
    wire [23:0] mul_mul_add_f24_ftz_unit_d_choice_3 = mul_mul_add_f24_ftz_unit_phase_copy4[1] ? center_y_d1 : mul_mul_add_f24_ftz_unit_d_choice_2;
    wire [23:0] mul_add_f24_ftz_unit_a_choice = mul_add_f24_ftz_unit_phase[0] ? m02 : m12;
    wire [23:0] mul_add_f24_ftz_unit_a_choice_2 = mul_add_f24_ftz_unit_phase[1] ? (mul_add_f24_ftz_unit_phase[0] ? m22 : m12) : mul_add_f24_ftz_unit_a_choice;
    wire [23:0] mul_add_f24_ftz_unit_a_choice_3 = mul_add_f24_ftz_unit_phase[1] ? mul_add_f24_ftz_unit_a_choice : mul_add_f24_ftz_unit_phase[0] ? m02 : m22;
    wire [23:0] mul_add_f24_ftz_unit_b_choice = mul_add_f24_ftz_unit_phase_copy2[0] ? center_z_d1 : tangent2_z_d2;
    wire [23:0] mul_add_f24_ftz_unit_b_choice_2 = mul_add_f24_ftz_unit_phase_copy2[0] ? tangent2_z_d2 : tangent1_z_d2;
    wire [23:0] mul_add_f24_ftz_unit_b_choice_3 = mul_add_f24_ftz_unit_phase_copy2[1] ? mul_add_f24_ftz_unit_b_choice : mul_add_f24_ftz_unit_b_choice_2;
    wire [23:0] mul_add_f24_ftz_unit_b_choice_4 = mul_add_f24_ftz_unit_phase_copy2[0] ? tangent1_z_d2 : center_z_d2;
    wire [23:0] mul_add_f24_ftz_unit_b_choice_5 = mul_add_f24_ftz_unit_phase_copy2[0] ? center_z_d2 : tangent1_z_d1;
    wire [23:0] mul_add_f24_ftz_unit_b_choice_6 = mul_add_f24_ftz_unit_phase_copy2[1] ? mul_add_f24_ftz_unit_b_choice_4 : mul_add_f24_ftz_unit_b_choice_5;
    wire [23:0] add_f24_ftz_unit_a_choice = add_f24_ftz_unit_phase[1] ? m20_times_tangent2_x_d1 : add_f24_ftz_unit_phase[0] ? add_f24_ftz_unit_y : m03;
    wire [23:0] add_f24_ftz_unit_a_choice_2 = add_f24_ftz_unit_phase[1] ? (add_f24_ftz_unit_phase[0] ? m13 : m23) : add_f24_ftz_unit_y;
    wire [23:0] add_f24_ftz_unit_b_choice = add_f24_ftz_unit_phase_copy2[0] ? m22_times_tangent2_z_d1 : mul_add_f24_ftz_unit_y;
    wire [23:0] add_f24_ftz_unit_b_choice_2 = add_f24_ftz_unit_phase_copy2[1] ? mul_f24_ftz_unit_y : add_f24_ftz_unit_b_choice;
    wire [23:0] add_f24_ftz_unit_b_choice_3 = add_f24_ftz_unit_phase_copy2[0] ? u_y_sum_d1 : mul_add_f24_ftz_unit_y;
    wire [23:0] add_f24_ftz_unit_b_choice_4 = add_f24_ftz_unit_phase_copy2[1] ? add_f24_ftz_unit_b_choice_3 : kept_chosen_d1;

    assign {out_end, out_center_x, out_center_y, out_center_z, out_tangent1_x, out_tangent1_y} = queue_1_out_data;
    assign {out_tangent1_z, out_tangent2_x, out_tangent2_y, out_tangent2_z, out_attribute_0, out_attribute_1} = queue_2_out_data;

    mul_mul_add_p4_s6_f24ftz mul_mul_add_f24_ftz_unit (
        .clk(clk), .enable(1'd1), .a(mul_mul_add_f24_ftz_unit_a), .b(mul_mul_add_f24_ftz_unit_b),
        .c(mul_mul_add_f24_ftz_unit_c), .d(mul_mul_add_f24_ftz_unit_d), .y(mul_mul_add_f24_ftz_unit_y)
    );

    mul_add_p4_s6_f24ftz mul_add_f24_ftz_unit (
        .clk(clk), .enable(1'd1), .a(mul_add_f24_ftz_unit_a), .b(mul_add_f24_ftz_unit_b),
        .c(mul_add_f24_ftz_unit_c), .y(mul_add_f24_ftz_unit_y)
    );

    float_add_s6_f24ftz add_f24_ftz_unit (
        .clk(clk), .enable(1'd1), .a(add_f24_ftz_unit_a), .b(add_f24_ftz_unit_b), .y(add_f24_ftz_unit_y)
    );

    float_mul_s4_f24ftz mul_f24_ftz_unit (
        .clk(clk), .enable(1'd1), .a(mul_f24_ftz_unit_a), .b(mul_f24_ftz_unit_b), .y(mul_f24_ftz_unit_y)
    );

    float_lt_s2_f24ftz lt_f24_ftz_unit (
        .clk(clk), .enable(1'd1), .a(near_plane), .b(u_z_d1), .y(lt_f24_ftz_unit_y)
    );

    float_lt_s2_f24ftz lt_f24_ftz_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(near_plane), .b(add_f24_ftz_unit_y), .y(lt_f24_ftz_unit_copy2_y)
    );

    float_max_s2_f24ftz max_f24_ftz_unit (
        .clk(clk), .enable(1'd1), .a({1'd0, v1_z_d1[22:0]}), .b({1'd0, add_f24_ftz_unit_y[22:0]}),
        .y(max_f24_ftz_unit_y)
    );

    stream_fifo_d6_w121_distributed queue_1 (
        .clk(clk), .rst(rst), .in_valid(kept), .in_ready(queue_1_in_ready),
        .in_data({end_d5, u_x_d1, add_f24_ftz_unit_y, u_z_d2, v1_x_d2, v1_y_d2}),
        .out_valid(out_valid), .out_ready(out_ready), .out_data(queue_1_out_data)
    );

    stream_fifo_d6_w120_distributed queue_2 (
        .clk(clk), .rst(rst), .in_valid(kept), .in_ready(queue_2_in_ready),
        .in_data({v1_z_d2, v2_x_d2, v2_y_d2, v2_z_d2, attribute_0_d5, attribute_1_d5}),
        .out_valid(queue_2_out_valid), .out_ready(out_ready), .out_data(queue_2_out_data)
    );

    stream_fifo_d6_w12_distributed queue_3 (
        .clk(clk), .rst(rst), .in_valid(kept), .in_ready(queue_3_in_ready), .in_data(attribute_2_d5),
        .out_valid(queue_3_out_valid), .out_ready(out_ready), .out_data(out_attribute_2)
    );

    always @(posedge clk) begin
        if (rst) begin
            credits <= 4'd5;
            phases_1 <= 8'd1;
            delay_5_from_0_pointer <= 2'd0;
            phases_2 <= 8'd1;
            phases_3 <= 8'd1;
            phases_4 <= 8'd1;
            mul_mul_add_f24_ftz_unit_phase <= 3'd0;
            mul_mul_add_f24_ftz_unit_phase_copy2 <= 3'd0;
            mul_mul_add_f24_ftz_unit_phase_copy3 <= 3'd0;
            mul_mul_add_f24_ftz_unit_phase_copy4 <= 3'd0;
            mul_add_f24_ftz_unit_phase <= 3'd0;
            mul_add_f24_ftz_unit_phase_copy2 <= 3'd0;
            add_f24_ftz_unit_phase <= 3'd0;
            add_f24_ftz_unit_phase_copy2 <= 3'd0;
            mul_f24_ftz_unit_phase <= 3'd0;
            in_flight <= 5'd0;
            left <= 1'd0;
            dropped <= 1'd0;
        end else begin
            credits <= (credits - {3'd0, in_valid_and_in_ready}) + {3'd0, left} + {3'd0, dropped};
            phases_1 <= {phases_1[6:0], phases_1[7]};
            phases_2 <= {phases_2[6:0], phases_2[7]};
            phases_3 <= {phases_3[6:0], phases_3[7]};
            phases_4 <= {phases_4[6:0], phases_4[7]};
            mul_mul_add_f24_ftz_unit_phase <= (mul_mul_add_f24_ftz_unit_phase == 3'd7) ? (mul_mul_add_f24_ftz_unit_phase - 3'd7) : (mul_mul_add_f24_ftz_unit_phase + 3'd1);
            mul_mul_add_f24_ftz_unit_phase_copy2 <= (mul_mul_add_f24_ftz_unit_phase_copy2 == 3'd7) ? (mul_mul_add_f24_ftz_unit_phase_copy2 - 3'd7) : (mul_mul_add_f24_ftz_unit_phase_copy2 + 3'd1);
            mul_mul_add_f24_ftz_unit_phase_copy3 <= (mul_mul_add_f24_ftz_unit_phase_copy3 == 3'd7) ? (mul_mul_add_f24_ftz_unit_phase_copy3 - 3'd7) : (mul_mul_add_f24_ftz_unit_phase_copy3 + 3'd1);
            mul_mul_add_f24_ftz_unit_phase_copy4 <= (mul_mul_add_f24_ftz_unit_phase_copy4 == 3'd7) ? (mul_mul_add_f24_ftz_unit_phase_copy4 - 3'd7) : (mul_mul_add_f24_ftz_unit_phase_copy4 + 3'd1);
            mul_add_f24_ftz_unit_phase <= (mul_add_f24_ftz_unit_phase == 3'd7) ? (mul_add_f24_ftz_unit_phase - 3'd7) : (mul_add_f24_ftz_unit_phase + 3'd1);
            mul_add_f24_ftz_unit_phase_copy2 <= (mul_add_f24_ftz_unit_phase_copy2 == 3'd7) ? (mul_add_f24_ftz_unit_phase_copy2 - 3'd7) : (mul_add_f24_ftz_unit_phase_copy2 + 3'd1);
            add_f24_ftz_unit_phase <= (add_f24_ftz_unit_phase == 3'd7) ? (add_f24_ftz_unit_phase - 3'd7) : (add_f24_ftz_unit_phase + 3'd1);
            add_f24_ftz_unit_phase_copy2 <= (add_f24_ftz_unit_phase_copy2 == 3'd7) ? (add_f24_ftz_unit_phase_copy2 - 3'd7) : (add_f24_ftz_unit_phase_copy2 + 3'd1);
            mul_f24_ftz_unit_phase <= (mul_f24_ftz_unit_phase == 3'd7) ? (mul_f24_ftz_unit_phase - 3'd7) : (mul_f24_ftz_unit_phase + 3'd1);
            left <= out_valid & out_ready;
            dropped <= in_flight_4_and_phases_1_2 & ~end_or_kept_either;
            if (phases_1[0]) begin
                delay_5_from_0_pointer <= (delay_5_from_0_pointer == 2'd3) ? (delay_5_from_0_pointer - 2'd3) : (delay_5_from_0_pointer + 2'd1);
                in_flight <= {in_flight[3:0], in_valid_and_in_ready};
            end
        end
    end
    always @(posedge clk) begin
        if (phases_1[0]) begin
            center_x_d1 <= in_center_x;
            center_y_d1 <= in_center_y;
            center_z_d1 <= in_center_z;
        end
        if (phases_2[0]) begin
            center_z_d2 <= center_z_d1;
            tangent1_x_d1 <= in_tangent1_x;
            tangent1_y_d1 <= in_tangent1_y;
            tangent1_z_d1 <= in_tangent1_z;
            tangent1_z_d2 <= tangent1_z_d1;
        end
        if (phases_1[5]) begin
            u_y_sum_d1 <= mul_add_f24_ftz_unit_y;
            m20_times_tangent2_x_d1 <= mul_f24_ftz_unit_y;
        end
        if (phases_1[3]) begin
            u_x_d1 <= add_f24_ftz_unit_y;
            v1_z_d1 <= mul_add_f24_ftz_unit_y;
            v1_z_d2 <= v1_z_d1;
        end
        if (phases_1[1]) begin
            u_z_d1 <= add_f24_ftz_unit_y;
            u_z_d2 <= u_z_d1;
            v2_y_d1 <= mul_add_f24_ftz_unit_y;
            v2_y_d2 <= v2_y_d1;
        end
        if (phases_1[6]) begin
            v1_x_d1 <= mul_add_f24_ftz_unit_y;
            v1_x_d2 <= v1_x_d1;
            kept_joined_d1 <= {1'd0, kept_chosen, kept_chosen_copy2};
            kept_greater_bits_is_zero_d1 <= kept_greater_bits_is_zero;
        end
        if (phases_1[7]) begin
            v1_y_d1 <= mul_add_f24_ftz_unit_y;
            v1_y_d2 <= v1_y_d1;
            m22_times_tangent2_z_d1 <= mul_f24_ftz_unit_y;
            kept_chosen_d1 <= kept_chosen_copy3;
        end
        if (phases_3[0]) begin
            tangent2_x_d1 <= in_tangent2_x;
            tangent2_y_d1 <= in_tangent2_y;
            tangent2_z_d1 <= in_tangent2_z;
            tangent2_z_d2 <= tangent2_z_d1;
            v2_x_d1 <= mul_add_f24_ftz_unit_y;
        end
        if (phases_4[0]) v2_x_d2 <= v2_x_d1;
        if (phases_1[4]) begin
            v2_z_d1 <= add_f24_ftz_unit_y;
            v2_z_d2 <= v2_z_d1;
        end
        mul_mul_add_f24_ftz_unit_a <= mul_mul_add_f24_ftz_unit_phase[2] ? mul_mul_add_f24_ftz_unit_a_choice_2 : mul_mul_add_f24_ftz_unit_a_choice_3;
        mul_mul_add_f24_ftz_unit_b <= mul_mul_add_f24_ftz_unit_phase_copy2[2] ? mul_mul_add_f24_ftz_unit_b_choice : mul_mul_add_f24_ftz_unit_b_choice_3;
        mul_mul_add_f24_ftz_unit_c <= mul_mul_add_f24_ftz_unit_phase_copy3[2] ? mul_mul_add_f24_ftz_unit_c_choice_2 : mul_mul_add_f24_ftz_unit_c_choice_3;
        mul_mul_add_f24_ftz_unit_d <= mul_mul_add_f24_ftz_unit_phase_copy4[2] ? mul_mul_add_f24_ftz_unit_d_choice : mul_mul_add_f24_ftz_unit_d_choice_3;
        mul_add_f24_ftz_unit_a <= mul_add_f24_ftz_unit_phase[2] ? mul_add_f24_ftz_unit_a_choice_2 : mul_add_f24_ftz_unit_a_choice_3;
        mul_add_f24_ftz_unit_b <= mul_add_f24_ftz_unit_phase_copy2[2] ? mul_add_f24_ftz_unit_b_choice_3 : mul_add_f24_ftz_unit_b_choice_6;
        mul_add_f24_ftz_unit_c <= mul_mul_add_f24_ftz_unit_y;
        add_f24_ftz_unit_a <= add_f24_ftz_unit_phase[2] ? add_f24_ftz_unit_a_choice : add_f24_ftz_unit_a_choice_2;
        add_f24_ftz_unit_b <= add_f24_ftz_unit_phase_copy2[2] ? add_f24_ftz_unit_b_choice_2 : add_f24_ftz_unit_b_choice_4;
        mul_f24_ftz_unit_a <= mul_f24_ftz_unit_phase[1] ? m22 : mul_f24_ftz_unit_phase[0] ? m21 : m20;
        mul_f24_ftz_unit_b <= mul_f24_ftz_unit_phase[1] ? tangent2_z_d1 : mul_f24_ftz_unit_phase[0] ? tangent2_y_d1 : in_tangent2_x;
    end
    always @(posedge clk) begin
        if (phases_1[0]) begin
            delay_5_from_0[delay_5_from_0_pointer] <= {in_attribute_2, in_attribute_1, in_attribute_0, in_end};
        end
        if (phases_1[0]) delay_5_from_0_out <= delay_5_from_0[delay_5_from_0_pointer];
    end

    wire _unused = &{
        1'b0, max_f24_ftz_unit_y[23], queue_1_in_ready, queue_2_in_ready, queue_2_out_valid, queue_3_in_ready,
        queue_3_out_valid
    };

`ifdef RTL_ASSERT
    reg [2:0] mul_add_f24_ftz_unit_phase_copy3;

    wire check_both = (phases_2 == phases_1) & (phases_3 == phases_1) & (phases_4 == phases_1);
    wire check_both_2 = check_both & ((mul_mul_add_f24_ftz_unit_phase == 3'd0) == phases_1[0]);
    wire check_both_3 = check_both_2 & ((mul_mul_add_f24_ftz_unit_phase_copy2 == 3'd0) == phases_1[0]);
    wire check_both_4 = check_both_3 & ((mul_mul_add_f24_ftz_unit_phase_copy3 == 3'd0) == phases_1[0]);
    wire check_both_5 = check_both_4 & ((mul_mul_add_f24_ftz_unit_phase_copy4 == 3'd0) == phases_1[0]);
    wire check_both_6 = check_both_5 & ((mul_add_f24_ftz_unit_phase == 3'd0) == phases_1[0]);
    wire check_both_7 = check_both_6 & ((mul_add_f24_ftz_unit_phase_copy2 == 3'd0) == phases_1[0]);
    wire check_both_8 = check_both_7 & ((mul_add_f24_ftz_unit_phase_copy3 == 3'd0) == phases_1[0]);
    wire check_both_9 = check_both_8 & ((add_f24_ftz_unit_phase == 3'd0) == phases_1[0]) & ((add_f24_ftz_unit_phase_copy2 == 3'd0) == phases_1[0]);

    always @(posedge clk) begin
        if (rst) begin
            mul_add_f24_ftz_unit_phase_copy3 <= 3'd0;
        end else begin
            mul_add_f24_ftz_unit_phase_copy3 <= (mul_add_f24_ftz_unit_phase_copy3 == 3'd7) ? (mul_add_f24_ftz_unit_phase_copy3 - 3'd7) : (mul_add_f24_ftz_unit_phase_copy3 + 3'd1);
        end
    end

    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        queue_1_has_a_place_for_each_result: assert (~kept | queue_1_in_ready);
        queue_2_has_a_place_for_each_result: assert (~kept | queue_2_in_ready);
        queue_3_has_a_place_for_each_result: assert (~kept | queue_3_in_ready);
        queue_2_in_step: assert (queue_2_out_valid == out_valid);
        queue_3_in_step: assert (queue_3_out_valid == out_valid);
        phases_are_in_step: assert (check_both_9 & ((mul_f24_ftz_unit_phase == 3'd0) == phases_1[0]));
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
        if (!(check_both_9 & ((mul_f24_ftz_unit_phase == 3'd0) == phases_1[0]))) begin
            $display("assertion failed: phases_are_in_step in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue in a memory with a registered output.
// depth = 6
// width = 12
// storage = distributed
module stream_fifo_d6_w12_distributed (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [11:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [11:0] out_data
);
    (* ram_style = "distributed" *)
    reg [11:0] entries [0:5];
    reg [2:0] held, waiting;
    reg is_full, any_waits;
    reg [2:0] write_address, read_address;
    reg [11:0] item;

    wire has_room = ~is_full;
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [2:0] held_bits = {{2{~push}}, 1'd1};
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    always @(posedge clk) begin
        if (rst) begin
            held <= 3'd0;
            waiting <= 3'd0;
            is_full <= 1'd0;
            any_waits <= 1'd0;
            write_address <= 3'd0;
            read_address <= 3'd0;
            out_valid <= 1'd0;
        end else begin
            if (push_xor_pop) begin
                held <= held + held_bits;
                is_full <= push & (held == 3'd5);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 3'd1);
            end
            if (push) write_address <= (write_address == 3'd5) ? 3'd0 : (write_address + 3'd1);
            if (fetch) read_address <= (read_address == 3'd5) ? 3'd0 : (read_address + 3'd1);
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
        held_in_range: assert (held <= 3'd6);
        held_is_waiting_and_shown: assert (held == (waiting + {2'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 3'd6)) & (any_waits == |waiting));
`else
        if (!(held <= 3'd6)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {2'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 3'd6)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue in a memory with a registered output.
// depth = 6
// width = 120
// storage = distributed
module stream_fifo_d6_w120_distributed (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [119:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [119:0] out_data
);
    (* ram_style = "distributed" *)
    reg [119:0] entries [0:5];
    reg [2:0] held, waiting;
    reg is_full, any_waits;
    reg [2:0] write_address, read_address;
    reg [119:0] item;

    wire has_room = ~is_full;
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [2:0] held_bits = {{2{~push}}, 1'd1};
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    always @(posedge clk) begin
        if (rst) begin
            held <= 3'd0;
            waiting <= 3'd0;
            is_full <= 1'd0;
            any_waits <= 1'd0;
            write_address <= 3'd0;
            read_address <= 3'd0;
            out_valid <= 1'd0;
        end else begin
            if (push_xor_pop) begin
                held <= held + held_bits;
                is_full <= push & (held == 3'd5);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 3'd1);
            end
            if (push) write_address <= (write_address == 3'd5) ? 3'd0 : (write_address + 3'd1);
            if (fetch) read_address <= (read_address == 3'd5) ? 3'd0 : (read_address + 3'd1);
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
        held_in_range: assert (held <= 3'd6);
        held_is_waiting_and_shown: assert (held == (waiting + {2'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 3'd6)) & (any_waits == |waiting));
`else
        if (!(held <= 3'd6)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {2'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 3'd6)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue in a memory with a registered output.
// depth = 6
// width = 121
// storage = distributed
module stream_fifo_d6_w121_distributed (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [120:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [120:0] out_data
);
    (* ram_style = "distributed" *)
    reg [120:0] entries [0:5];
    reg [2:0] held, waiting;
    reg is_full, any_waits;
    reg [2:0] write_address, read_address;
    reg [120:0] item;

    wire has_room = ~is_full;
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [2:0] held_bits = {{2{~push}}, 1'd1};
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    always @(posedge clk) begin
        if (rst) begin
            held <= 3'd0;
            waiting <= 3'd0;
            is_full <= 1'd0;
            any_waits <= 1'd0;
            write_address <= 3'd0;
            read_address <= 3'd0;
            out_valid <= 1'd0;
        end else begin
            if (push_xor_pop) begin
                held <= held + held_bits;
                is_full <= push & (held == 3'd5);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 3'd1);
            end
            if (push) write_address <= (write_address == 3'd5) ? 3'd0 : (write_address + 3'd1);
            if (fetch) read_address <= (read_address == 3'd5) ? 3'd0 : (read_address + 3'd1);
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
        held_in_range: assert (held <= 3'd6);
        held_is_waiting_and_shown: assert (held == (waiting + {2'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 3'd6)) & (any_waits == |waiting));
`else
        if (!(held <= 3'd6)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {2'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 3'd6)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Greater of two floating-point numbers.
// stages = 2
// format = f24-ftz
module float_max_s2_f24ftz (
    input  wire clk, input wire enable, input wire [23:0] a, input wire [23:0] b,
    output reg  [23:0] y
);
    reg a_nan_s1, b_nan_s1, less_s1;
    reg [23:0] a_s1, b_s1;

    always @(posedge clk) begin
        if (enable) begin
            a_nan_s1 <= &a[22:15] & |a[14:0];
            b_nan_s1 <= &b[22:15] & |b[14:0];
            less_s1 <= {~a[23], a[22:0] ^ {23{a[23]}}} < {~b[23], b[22:0] ^ {23{b[23]}}};
            a_s1 <= {a[23:15], a[14:0] & {15{|a[22:15]}}};
            b_s1 <= {b[23:15], b[14:0] & {15{|b[22:15]}}};
            y <= (a_nan_s1 & b_nan_s1) ? 24'h7fc000 : (b_nan_s1 | (~a_nan_s1 & ~less_s1)) ? a_s1 : b_s1;
        end
    end
endmodule

// Whether one floating-point number is less than another.
// stages = 2
// format = f24-ftz
module float_lt_s2_f24ftz (
    input  wire clk, input wire enable, input wire [23:0] a, input wire [23:0] b,
    output reg  y
);
    reg unordered_s1, both_zero_s1, compared_s1;

    always @(posedge clk) begin
        if (enable) begin
            unordered_s1 <= (&a[22:15] & |a[14:0]) | (&b[22:15] & |b[14:0]);
            both_zero_s1 <= (a[22:15] == 8'd0) & (b[22:15] == 8'd0);
            compared_s1 <= {~a[23], a[22:0] ^ {23{a[23]}}} < {~b[23], b[22:0] ^ {23{b[23]}}};
            y <= compared_s1 & ~both_zero_s1 & ~unordered_s1;
        end
    end
endmodule

// Floating-point sum with products, each of them rounded.
// product_stages = 4
// sum_stages = 6
// format = f24-ftz
module mul_add_p4_s6_f24ftz (
    input  wire clk, input wire enable, input wire [23:0] a, input wire [23:0] b, input wire [23:0] c,
    output wire [23:0] y
);
    wire [23:0] product_y;

    float_mul_s4_f24ftz product (.clk(clk), .enable(enable), .a(a), .b(b), .y(product_y));
    float_add_s6_f24ftz sum (.clk(clk), .enable(enable), .a(product_y), .b(c), .y(y));
endmodule

// Floating-point sum with products, each of them rounded.
// product_stages = 4
// sum_stages = 6
// format = f24-ftz
module mul_mul_add_p4_s6_f24ftz (
    input  wire clk, input wire enable, input wire [23:0] a, input wire [23:0] b, input wire [23:0] c,
    input  wire [23:0] d,
    output wire [23:0] y
);
    wire [23:0] product_y, second_product_y;

    float_mul_s4_f24ftz product (.clk(clk), .enable(enable), .a(a), .b(b), .y(product_y));
    float_mul_s4_f24ftz second_product (.clk(clk), .enable(enable), .a(c), .b(d), .y(second_product_y));
    float_add_s6_f24ftz sum (.clk(clk), .enable(enable), .a(product_y), .b(second_product_y), .y(y));
endmodule

// Floating-point sum.
// stages = 6
// format = f24-ftz
module float_add_s6_f24ftz (
    input  wire clk, input wire enable, input wire [23:0] a, input wire [23:0] b,
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
    wire large_s1_inverted = ~(|a_field);
    wire large_s1_inverted_2 = ~(|b_field);
    wire large_s1_inverted_3 = ~(large_s1_inverted & large_s1_inverted_2);
    wire [14:0] b_fraction = b[14:0];
    wire [14:0] a_fraction = a[14:0];
    wire small_s1_inverted = ~(large_s1_inverted | large_s1_inverted_2);
    wire [18:0] aligned_s2_choice = distance_s1[4] ? ({small_s1, 3'd0} >> 16) : {small_s1, 3'd0};
    wire [18:0] aligned_s2_choice_2 = distance_s1[3] ? (aligned_s2_choice >> 8) : aligned_s2_choice;
    wire [18:0] aligned_s2_choice_3 = distance_s1[2] ? (aligned_s2_choice_2 >> 4) : aligned_s2_choice_2;
    wire [18:0] aligned_s2_choice_4 = distance_s1[1] ? (aligned_s2_choice_3 >> 2) : aligned_s2_choice_3;
    wire [18:0] aligned_s2_choice_5 = distance_s1[0] ? (aligned_s2_choice_4 >> 1) : aligned_s2_choice_4;
    wire aligned_s2_either = (distance_s1[4] & |{small_s1[12:0], 3'd0}) | (distance_s1[3] & |aligned_s2_choice[7:0]);
    wire aligned_s2_either_2 = aligned_s2_either | (distance_s1[2] & |aligned_s2_choice_2[3:0]) | (distance_s1[1] & |aligned_s2_choice_3[1:0]);
    wire aligned_s2_either_3 = aligned_s2_choice_5[0] | (aligned_s2_either_2 | (distance_s1[0] & aligned_s2_choice_4[0]));
    wire a_23_xor_b_23 = a[23] ^ b[23];
    wire [20:0] sum_s3_sum = {1'd0, large_s2, 4'd1} + {{1'd0, aligned_s2} ^ {20{subtract_s2}}, subtract_s2};
    wire nan_s1_both = &a_field & (a_fraction == 15'd0);
    wire nan_s1_both_2 = &b_field & (b_fraction == 15'd0);
    wire zeros_s4_both = ~sum_s3[19] & ~sum_s3[18];
    wire zeros_s4_both_2 = zeros_s4_both & (~sum_s3[17] & ~sum_s3[16]);
    wire zeros_s4_both_3 = ~sum_s3[15] & ~sum_s3[14];
    wire zeros_s4_both_4 = zeros_s4_both_2 & (zeros_s4_both_3 & (~sum_s3[13] & ~sum_s3[12]));
    wire zeros_s4_both_5 = ~sum_s3[11] & ~sum_s3[10];
    wire zeros_s4_both_6 = zeros_s4_both_5 & (~sum_s3[9] & ~sum_s3[8]);
    wire not_sum_s3_7_and_not_sum_s3_6 = ~sum_s3[7] & ~sum_s3[6];
    wire zeros_s4_both_7 = zeros_s4_both_6 & (not_sum_s3_7_and_not_sum_s3_6 & (~sum_s3[5] & ~sum_s3[4]));
    wire zeros_s4_both_8 = zeros_s4_both_4 & zeros_s4_both_7;
    wire not_sum_s3_3_and_not_sum_s3_2 = ~sum_s3[3] & ~sum_s3[2];
    wire zeros_s4_both_9 = not_sum_s3_3_and_not_sum_s3_2 & (~sum_s3[1] & ~sum_s3[0]);
    wire [1:0] zeros_s4_bits = {not_sum_s3_3_and_not_sum_s3_2, not_sum_s3_3_and_not_sum_s3_2 ? ~sum_s3[1] : ~sum_s3[3]};
    wire [1:0] zeros_s4_bits_2 = {not_sum_s3_7_and_not_sum_s3_6, not_sum_s3_7_and_not_sum_s3_6 ? ~sum_s3[5] : ~sum_s3[7]};
    wire [1:0] zeros_s4_choice = zeros_s4_both_6 ? zeros_s4_bits_2 : {zeros_s4_both_5, zeros_s4_both_5 ? ~sum_s3[9] : ~sum_s3[11]};
    wire [1:0] zeros_s4_choice_2 = zeros_s4_both_2 ? {zeros_s4_both_3, zeros_s4_both_3 ? ~sum_s3[13] : ~sum_s3[15]} : {zeros_s4_both, zeros_s4_both ? ~sum_s3[17] : ~sum_s3[19]};
    wire [2:0] zeros_s4_choice_3 = zeros_s4_both_4 ? {zeros_s4_both_6, zeros_s4_choice} : {zeros_s4_both_2, zeros_s4_choice_2};
    wire [3:0] zeros_s4_choice_4 = zeros_s4_both_8 ? {1'd0, zeros_s4_both_9, zeros_s4_both_9 ? 2'd0 : zeros_s4_bits} : {zeros_s4_both_4, zeros_s4_choice_3};
    wire [19:0] value_s4_shifted_by_zeros_s4 = value_s4 << zeros_s4;
    wire sum_s3_is_0 = sum_s3 == 20'd0;
    wire y_both = (exponent_s5 == 10'd0) & ~(&significand_s5[16:2] & significand_s5[1]);
    wire round_up = significand_s5[1] & (significand_s5[0] | significand_s5[2]);
    wire [22:0] rounded = {exponent_s5[7:0], significand_s5[16:2]} + {22'd0, round_up};
    wire [22:0] y_choice = (infinite_s5 | (~exponent_s5[9] & (10'd255 <= exponent_s5))) ? 23'h7f8000 : rounded;
    wire [22:0] y_choice_2 = (zero_s5 | ((exponent_s5[9] | y_both) & ~infinite_s5)) ? 23'd0 : y_choice;

    always @(posedge clk) begin
        if (enable) begin
            distance_s1 <= swap ? ({2'd0, b_field} - {2'd0, a_field}) : ({2'd0, a_field} - {2'd0, b_field});
            large_s1 <= {large_s1_inverted_3, (swap ? b_fraction : a_fraction) & {15{large_s1_inverted_3}}};
            small_s1 <= {small_s1_inverted, (swap ? a_fraction : b_fraction) & {15{small_s1_inverted}}};
            large_s2 <= large_s1;
            aligned_s2 <= |distance_s1[7:5] ? {18'd0, |{small_s1, 3'd0}} : {aligned_s2_choice_5[18:1], aligned_s2_either_3};
            subtract_s1 <= a_23_xor_b_23;
            subtract_s2 <= subtract_s1;
            sum_s3 <= sum_s3_sum[20:1];
            sign_s1 <= swap ? b[23] : a[23];
            sign_s2 <= sign_s1;
            sign_s3 <= sign_s2;
            nan_s1 <= (&a_field & |a_fraction) | (&b_field & |b_fraction) | (nan_s1_both & nan_s1_both_2 & a_23_xor_b_23);
            nan_s2 <= nan_s1;
            nan_s3 <= nan_s2;
            infinite_s1 <= nan_s1_both | nan_s1_both_2;
            infinite_s2 <= infinite_s1;
            infinite_s3 <= infinite_s2;
            subtract_s3 <= subtract_s2;
            value_s4 <= sum_s3;
            zeros_s4 <= {zeros_s4_both_8, zeros_s4_choice_4};
            limit_s1 <= swap ? {2'd0, b_field} : {2'd0, a_field};
            limit_s2 <= limit_s1;
            limit_s3 <= limit_s2;
            limit_s4 <= limit_s3;
            exponent_s5 <= (limit_s4 + 10'd1) - {5'd0, zeros_s4};
            significand_s5 <= {value_s4_shifted_by_zeros_s4[19:3], |value_s4_shifted_by_zeros_s4[2:0]};
            sign_s4 <= sign_s3 & ~(sum_s3_is_0 & subtract_s3);
            sign_s5 <= sign_s4;
            nan_s4 <= nan_s3;
            nan_s5 <= nan_s4;
            infinite_s4 <= infinite_s3;
            infinite_s5 <= infinite_s4;
            zero_s4 <= sum_s3_is_0 & ~infinite_s3;
            zero_s5 <= zero_s4;
            y <= nan_s5 ? 24'h7fc000 : {sign_s5, y_choice_2};
        end
    end

    wire _unused = &{1'b0, distance_s1[9:8], significand_s5[17], sum_s3_sum[0]};
endmodule

// Floating-point product.
// stages = 4
// format = f24-ftz
module float_mul_s4_f24ftz (
    input  wire clk, input wire enable, input wire [23:0] a, input wire [23:0] b,
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
    wire [31:0] significand_s3_choice = product_s2[31] ? product_s2 : (product_s2 << 1);
    wire nan_s1_both = &a_field & (a_fraction == 15'd0);
    wire nan_s1_inverted = ~(|b_field);
    wire nan_s1_either = (&a_field & |a_fraction) | (&b_field & |b_fraction) | (nan_s1_both & nan_s1_inverted);
    wire nan_s1_inverted_2 = ~(|a_field);
    wire nan_s1_both_2 = &b_field & (b_fraction == 15'd0);
    wire y_both = (exponent_s3 == 10'd0) & ~(&significand_s3[16:2] & significand_s3[1]);
    wire round_up = significand_s3[1] & (significand_s3[0] | significand_s3[2]);
    wire [22:0] rounded = {exponent_s3[7:0], significand_s3[16:2]} + {22'd0, round_up};
    wire [22:0] y_choice = (infinite_s3 | (~exponent_s3[9] & (10'd255 <= exponent_s3))) ? 23'h7f8000 : rounded;
    wire [22:0] y_choice_2 = (zero_s3 | ((exponent_s3[9] | y_both) & ~infinite_s3)) ? 23'd0 : y_choice;

    always @(posedge clk) begin
        if (enable) begin
            left_s1 <= {|a_field, a_fraction & {15{|a_field}}};
            right_s1 <= {|b_field, b_fraction & {15{|b_field}}};
            exponent_s1 <= {2'd0, a_field} + {2'd0, b_field};
            product_s2 <= {16'd0, left_s1} * {16'd0, right_s1};
            exponent_s2 <= exponent_s1 - 10'd127;
            exponent_s3 <= exponent_s2 + {9'd0, product_s2[31]};
            significand_s3 <= {significand_s3_choice[31:15], |significand_s3_choice[14:0]};
            sign_s1 <= a[23] ^ b[23];
            sign_s2 <= sign_s1;
            sign_s3 <= sign_s2;
            nan_s1 <= nan_s1_either | (nan_s1_inverted_2 & nan_s1_both_2);
            nan_s2 <= nan_s1;
            nan_s3 <= nan_s2;
            infinite_s1 <= nan_s1_both | nan_s1_both_2;
            infinite_s2 <= infinite_s1;
            infinite_s3 <= infinite_s2;
            zero_s1 <= nan_s1_inverted_2 | nan_s1_inverted;
            zero_s2 <= zero_s1;
            zero_s3 <= zero_s2;
            y <= nan_s3 ? 24'h7fc000 : {sign_s3, y_choice_2};
        end
    end

    wire _unused = &{1'b0, significand_s3[17]};
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
