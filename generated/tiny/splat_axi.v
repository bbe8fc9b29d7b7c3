// The whole design is one file, named after its top.
/* verilator lint_off DECLFILENAME */

// Surface-splat renderer on AXI.
module splat_axi (
    input  wire clk, input wire rst,
    input  wire s_axil_awvalid, output wire s_axil_awready,  // Registers to be written.
    input  wire [11:0] s_axil_awaddr,  // Its first byte.
    input  wire s_axil_wvalid, output wire s_axil_wready,  // What is written to them.
    input  wire [31:0] s_axil_wdata,  // The value.
    input  wire [3:0] s_axil_wstrb,  // A bit for each byte that is to be written.
    output wire s_axil_bvalid, input wire s_axil_bready,  // Answers to writes.
    output wire [1:0] s_axil_bresp,  // Whether all is well: 0 if so.
    input  wire s_axil_arvalid, output wire s_axil_arready,  // Registers to be read.
    input  wire [11:0] s_axil_araddr,  // Its first byte.
    output wire s_axil_rvalid, input wire s_axil_rready,  // What is read from them.
    output wire [31:0] s_axil_rdata,  // The value.
    output wire [1:0] s_axil_rresp,  // Whether all is well: 0 if so.
    input  wire s_axis_splat_tvalid, output wire s_axis_splat_tready,  // Beats of packets.
    input  wire [63:0] s_axis_splat_tdata,  // Its bytes.
    input  wire s_axis_splat_tlast,  // Closes its packet.
    output wire m_axis_fragment_tvalid, input wire m_axis_fragment_tready,  // Beats of packets.
    output wire [63:0] m_axis_fragment_tdata,  // Its bytes.
    output wire m_axis_fragment_tlast,  // Closes its packet.
    output wire m_axi_arvalid, input wire m_axi_arready,  // Bursts wanted.
    output wire [3:0] m_axi_arid,  // The burst's identifier, which its answers bear.
    output wire [31:0] m_axi_araddr,  // Its first byte.
    output wire [7:0] m_axi_arlen,  // One less than its beats.
    output wire [2:0] m_axi_arsize,  // The binary logarithm of a beat's bytes.
    output wire [1:0] m_axi_arburst,  // How the address goes on: up, where it is 1.
    input  wire m_axi_rvalid, output wire m_axi_rready,  // Their beats.
    input  wire [3:0] m_axi_rid,  // The burst's identifier.
    input  wire [63:0] m_axi_rdata,  // Its bytes.
    input  wire [1:0] m_axi_rresp,  // Whether all is well: 0 if so.
    input  wire m_axi_rlast,  // Closes its burst.
    output wire m_axi_awvalid, input wire m_axi_awready,  // Bursts to be written.
    output wire [3:0] m_axi_awid,  // The burst's identifier, which its answers bear.
    output wire [31:0] m_axi_awaddr,  // Its first byte.
    output wire [7:0] m_axi_awlen,  // One less than its beats.
    output wire [2:0] m_axi_awsize,  // The binary logarithm of a beat's bytes.
    output wire [1:0] m_axi_awburst,  // How the address goes on: up, where it is 1.
    output wire m_axi_wvalid, input wire m_axi_wready,  // Their beats.
    output wire [63:0] m_axi_wdata,  // Its bytes.
    output wire [7:0] m_axi_wstrb,  // A bit for each byte that is to be written.
    output wire m_axi_wlast,  // Closes its burst.
    input  wire m_axi_bvalid, output wire m_axi_bready,  // Answers to bursts.
    input  wire [3:0] m_axi_bid,  // The burst's identifier.
    input  wire [1:0] m_axi_bresp,  // Whether all is well: 0 if so.
    output wire irq  // Interrupt.
);
    reg [7:0] pixels_awaited, pixels_held;

    wire core_splat_ready, core_frame_set_up, core_read_valid, core_read_surface;
    wire [7:0] core_read_tile;
    wire [5:0] core_read_pixel;
    wire [3:0] core_read_count;
    wire core_data_ready, core_write_valid, core_write_surface;
    wire [7:0] core_write_tile;
    wire [5:0] core_write_pixel;
    wire [27:0] core_write_weight;
    wire [51:0] core_write_depth;
    wire [15:0] core_write_attribute_0, core_write_attribute_1, core_write_attribute_2;
    wire core_fragment_valid, core_fragment_end;
    wire [6:0] core_fragment_column, core_fragment_row;
    wire [23:0] core_fragment_depth;
    wire [15:0] core_fragment_attribute_0, core_fragment_attribute_1, core_fragment_attribute_2;
    wire core_event_sample, core_event_starved, core_event_blocked, core_event_accumulate, core_event_hazard;
    wire core_event_slot_wait, registers_busy, registers_start, registers_core_reset, registers_aborts;
    wire registers_uniform_valid;
    wire [4:0] registers_uniform_address;
    wire [23:0] registers_uniform_data;
    wire [31:0] registers_buffer_base;
    wire splats_out_valid, splats_out_end;
    wire [23:0] splats_out_center_x, splats_out_center_y, splats_out_center_z, splats_out_tangent1_x;
    wire [23:0] splats_out_tangent1_y, splats_out_tangent1_z, splats_out_tangent2_x, splats_out_tangent2_y;
    wire [23:0] splats_out_tangent2_z;
    wire [15:0] splats_out_attribute_0, splats_out_attribute_1, splats_out_attribute_2;
    wire splats_taken, splats_refused, frames_uniform_valid;
    wire [4:0] frames_uniform_address;
    wire [23:0] frames_uniform_data;
    wire frames_begun, frames_idle, fragments_in_ready, fragments_sent, fragments_idle, reads_request_ready;
    wire reads_record_valid;
    wire [27:0] reads_record_weight;
    wire [51:0] reads_record_depth;
    wire [15:0] reads_record_attribute_0, reads_record_attribute_1, reads_record_attribute_2;
    wire reads_error, reads_misplaced, writes_in_ready, writes_error, writes_idle, early_end_aborts;
    wire early_end_ended, pixels_in_ready, pixels_out_valid;
    wire [127:0] pixels_out_data;

    wire reads_run = reads_request_ready & writes_idle;
    wire run_fits = pixels_held < 8'd121;
    wire core_read_ready = reads_run & run_fits;
    wire [27:0] pixels_out_weight = pixels_out_data[127:100];
    wire [51:0] pixels_out_depth = pixels_out_data[99:48];
    wire [15:0] pixels_out_attribute_0 = pixels_out_data[47:32];
    wire [15:0] pixels_out_attribute_1 = pixels_out_data[31:16];
    wire [15:0] pixels_out_attribute_2 = pixels_out_data[15:0];
    wire core_read_valid_and_run_fits = core_read_valid & run_fits;
    wire no_read = ~core_read_valid_and_run_fits;
    wire core_write_ready = writes_in_ready & no_read;
    wire is_idle = fragments_idle & writes_idle;
    wire rst_or_early_end_aborts = rst | early_end_aborts;
    wire [31:0] run_address_bits = {12'd0, core_read_surface, core_read_tile, core_read_pixel, 5'd0};
    wire [31:0] run_address = registers_buffer_base + run_address_bits;
    wire reads_record_ready = pixels_in_ready | early_end_aborts;
    wire [31:0] pixel_address_bits = {12'd0, core_write_surface, core_write_tile, core_write_pixel, 5'd0};
    wire [31:0] pixel_address = registers_buffer_base + pixel_address_bits;
    wire quiet = is_idle & (pixels_awaited == 8'd0);
    wire run_begins = core_read_valid & core_read_ready;
    wire [7:0] pixels_held_bits = {4'd0, {4{run_begins}} & core_read_count};
    wire [7:0] pixels_held_difference = (pixels_held + pixels_held_bits) - {7'd0, pixels_out_valid & core_data_ready};

    splat_top core (
        .clk(clk), .rst(rst | (registers_core_reset | early_end_aborts)),
        .uniform_valid(frames_uniform_valid), .uniform_address(frames_uniform_address),
        .uniform_data(frames_uniform_data),
        .splat_valid(splats_out_valid), .splat_ready(core_splat_ready), .splat_end(splats_out_end),
        .splat_center_x(splats_out_center_x), .splat_center_y(splats_out_center_y),
        .splat_center_z(splats_out_center_z), .splat_tangent1_x(splats_out_tangent1_x),
        .splat_tangent1_y(splats_out_tangent1_y), .splat_tangent1_z(splats_out_tangent1_z),
        .splat_tangent2_x(splats_out_tangent2_x), .splat_tangent2_y(splats_out_tangent2_y),
        .splat_tangent2_z(splats_out_tangent2_z), .splat_attribute_0(splats_out_attribute_0),
        .splat_attribute_1(splats_out_attribute_1), .splat_attribute_2(splats_out_attribute_2),
        .frame_set_up(core_frame_set_up),
        .read_valid(core_read_valid), .read_ready(core_read_ready), .read_surface(core_read_surface),
        .read_tile(core_read_tile), .read_pixel(core_read_pixel), .read_count(core_read_count),
        .data_valid(pixels_out_valid), .data_ready(core_data_ready), .data_weight(pixels_out_weight),
        .data_depth(pixels_out_depth), .data_attribute_0(pixels_out_attribute_0),
        .data_attribute_1(pixels_out_attribute_1), .data_attribute_2(pixels_out_attribute_2),
        .write_valid(core_write_valid), .write_ready(core_write_ready), .write_surface(core_write_surface),
        .write_tile(core_write_tile), .write_pixel(core_write_pixel), .write_weight(core_write_weight),
        .write_depth(core_write_depth), .write_attribute_0(core_write_attribute_0),
        .write_attribute_1(core_write_attribute_1), .write_attribute_2(core_write_attribute_2),
        .fragment_valid(core_fragment_valid), .fragment_ready(fragments_in_ready),
        .fragment_end(core_fragment_end), .fragment_column(core_fragment_column),
        .fragment_row(core_fragment_row), .fragment_depth(core_fragment_depth),
        .fragment_attribute_0(core_fragment_attribute_0), .fragment_attribute_1(core_fragment_attribute_1),
        .fragment_attribute_2(core_fragment_attribute_2),
        .event_sample(core_event_sample), .event_starved(core_event_starved),
        .event_blocked(core_event_blocked), .event_accumulate(core_event_accumulate),
        .event_hazard(core_event_hazard), .event_slot_wait(core_event_slot_wait)
    );

    bus_registers registers (
        .clk(clk), .rst(rst), .s_axil_awvalid(s_axil_awvalid), .s_axil_awready(s_axil_awready),
        .s_axil_awaddr(s_axil_awaddr), .s_axil_wvalid(s_axil_wvalid), .s_axil_wready(s_axil_wready),
        .s_axil_wdata(s_axil_wdata), .s_axil_wstrb(s_axil_wstrb), .s_axil_bvalid(s_axil_bvalid),
        .s_axil_bready(s_axil_bready), .s_axil_bresp(s_axil_bresp),
        .finished((frames_idle & ~registers_start & is_idle & ~early_end_aborts) | early_end_ended),
        .occupied(early_end_aborts), .begun(frames_begun), .busy(registers_busy), .start(registers_start),
        .core_reset(registers_core_reset),
        .aborts(registers_aborts), .uniform_valid(registers_uniform_valid),
        .uniform_address(registers_uniform_address), .uniform_data(registers_uniform_data),
        .burst_error(reads_misplaced),
        .packet_error(splats_refused),
        .memory_error({writes_error, reads_error}),
        .packet_taken(splats_taken), .packet_sent(fragments_sent),
        .event_sample(core_event_sample), .event_starved(core_event_starved),
        .event_blocked(core_event_blocked), .event_accumulate(core_event_accumulate),
        .event_hazard(core_event_hazard), .event_slot_wait(core_event_slot_wait),
        .s_axil_arvalid(s_axil_arvalid), .s_axil_arready(s_axil_arready), .s_axil_araddr(s_axil_araddr),
        .s_axil_rvalid(s_axil_rvalid), .s_axil_rready(s_axil_rready), .s_axil_rdata(s_axil_rdata),
        .s_axil_rresp(s_axil_rresp),
        .irq(irq), .buffer_base(registers_buffer_base)
    );

    bus_packet_in splats (
        .clk(clk), .rst(rst_or_early_end_aborts), .opens(frames_begun), .s_axis_tvalid(s_axis_splat_tvalid),
        .s_axis_tready(s_axis_splat_tready), .s_axis_tdata(s_axis_splat_tdata),
        .s_axis_tlast(s_axis_splat_tlast),
        .out_valid(splats_out_valid), .out_ready(core_splat_ready), .out_end(splats_out_end),
        .out_center_x(splats_out_center_x), .out_center_y(splats_out_center_y),
        .out_center_z(splats_out_center_z), .out_tangent1_x(splats_out_tangent1_x),
        .out_tangent1_y(splats_out_tangent1_y), .out_tangent1_z(splats_out_tangent1_z),
        .out_tangent2_x(splats_out_tangent2_x), .out_tangent2_y(splats_out_tangent2_y),
        .out_tangent2_z(splats_out_tangent2_z), .out_attribute_0(splats_out_attribute_0),
        .out_attribute_1(splats_out_attribute_1), .out_attribute_2(splats_out_attribute_2),
        .taken(splats_taken), .refused(splats_refused)
    );

    bus_frames frames (
        .clk(clk), .rst(rst_or_early_end_aborts), .start(registers_start), .set_up(core_frame_set_up),
        .sent(core_fragment_valid & fragments_in_ready & core_fragment_end),
        .write_valid(registers_uniform_valid), .write_address(registers_uniform_address),
        .write_data(registers_uniform_data),
        .uniform_valid(frames_uniform_valid), .uniform_address(frames_uniform_address),
        .uniform_data(frames_uniform_data),
        .begun(frames_begun), .idle(frames_idle)
    );

    bus_packet_out fragments (
        .clk(clk), .rst(rst), .in_valid(core_fragment_valid), .in_ready(fragments_in_ready),
        .in_end(core_fragment_end), .in_column(core_fragment_column), .in_row(core_fragment_row),
        .in_depth(core_fragment_depth), .in_attribute_0(core_fragment_attribute_0),
        .in_attribute_1(core_fragment_attribute_1), .in_attribute_2(core_fragment_attribute_2),
        .m_axis_tvalid(m_axis_fragment_tvalid), .m_axis_tready(m_axis_fragment_tready),
        .m_axis_tdata(m_axis_fragment_tdata), .m_axis_tlast(m_axis_fragment_tlast),
        .sent(fragments_sent), .idle(fragments_idle)
    );

    bus_reader reads (
        .clk(clk), .rst(rst), .request_valid(core_read_valid_and_run_fits & writes_idle),
        .request_ready(reads_request_ready), .request_address(run_address), .request_records(core_read_count),
        .m_axi_arvalid(m_axi_arvalid), .m_axi_arready(m_axi_arready), .m_axi_arid(m_axi_arid),
        .m_axi_araddr(m_axi_araddr), .m_axi_arlen(m_axi_arlen), .m_axi_arsize(m_axi_arsize),
        .m_axi_arburst(m_axi_arburst), .m_axi_rvalid(m_axi_rvalid), .m_axi_rready(m_axi_rready),
        .m_axi_rid(m_axi_rid), .m_axi_rdata(m_axi_rdata), .m_axi_rresp(m_axi_rresp),
        .m_axi_rlast(m_axi_rlast),
        .record_valid(reads_record_valid), .record_ready(reads_record_ready),
        .record_weight(reads_record_weight), .record_depth(reads_record_depth),
        .record_attribute_0(reads_record_attribute_0), .record_attribute_1(reads_record_attribute_1),
        .record_attribute_2(reads_record_attribute_2),
        .error(reads_error), .misplaced(reads_misplaced)
    );

    bus_writer writes (
        .clk(clk), .rst(rst), .in_valid(core_write_valid & no_read), .in_ready(writes_in_ready),
        .in_address(pixel_address), .in_weight(core_write_weight), .in_depth(core_write_depth),
        .in_attribute_0(core_write_attribute_0), .in_attribute_1(core_write_attribute_1),
        .in_attribute_2(core_write_attribute_2),
        .m_axi_awvalid(m_axi_awvalid), .m_axi_awready(m_axi_awready), .m_axi_awid(m_axi_awid),
        .m_axi_awaddr(m_axi_awaddr), .m_axi_awlen(m_axi_awlen), .m_axi_awsize(m_axi_awsize),
        .m_axi_awburst(m_axi_awburst), .m_axi_wvalid(m_axi_wvalid), .m_axi_wready(m_axi_wready),
        .m_axi_wdata(m_axi_wdata), .m_axi_wstrb(m_axi_wstrb), .m_axi_wlast(m_axi_wlast),
        .m_axi_bvalid(m_axi_bvalid), .m_axi_bready(m_axi_bready), .m_axi_bid(m_axi_bid),
        .m_axi_bresp(m_axi_bresp),
        .error(writes_error), .idle(writes_idle)
    );

    bus_abort early_end (
        .clk(clk), .rst(rst), .asked(registers_aborts), .running(registers_busy), .quiet(quiet),
        .aborts(early_end_aborts), .ended(early_end_ended)
    );

    stream_fifo_d128_w128 pixels (
        .clk(clk), .rst(rst_or_early_end_aborts), .in_valid(reads_record_valid), .in_ready(pixels_in_ready),
        .in_data({
            reads_record_weight, reads_record_depth, reads_record_attribute_0, reads_record_attribute_1,
            reads_record_attribute_2
        }),
        .out_valid(pixels_out_valid), .out_ready(core_data_ready), .out_data(pixels_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            pixels_awaited <= 8'd0;
            pixels_held <= 8'd0;
        end else begin
            pixels_awaited <= (pixels_awaited + pixels_held_bits) - {7'd0, reads_record_valid & reads_record_ready};
            pixels_held <= early_end_aborts ? 8'd0 : pixels_held_difference;
        end
    end
endmodule

// Queue in a memory with a registered output.
// depth = 128
// width = 128
module stream_fifo_d128_w128 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [127:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [127:0] out_data
);
    reg [7:0] held, waiting;
    reg is_full, any_waits;
    reg [6:0] write_address, read_address;
    wire [127:0] item;

    wire has_room = ~is_full;
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [7:0] held_bits = {{7{~push}}, 1'd1};
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    memory_1w1r_unordered #(.WIDTH(128), .DEPTH(128)) entries (
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

// Ends a run early: keeps the core in reset until nothing is under way.
module bus_abort (
    input  wire clk, input wire rst,
    input  wire asked,  // The run is to end.
    input  wire running,  // A run is under way.
    input  wire quiet,  // Nothing is under way on the buses.
    output wire aborts,  // The core is to stay in reset, and what still comes to be dropped.
    output reg  ended  // The run has ended.
);
    reg is_aborting;
    reg [2:0] quiet_cycles;

    wire counts = is_aborting & quiet;
    wire ends = counts & (quiet_cycles == 3'd7);

    assign aborts = is_aborting;

    always @(posedge clk) begin
        if (rst) begin
            is_aborting <= 1'd0;
            quiet_cycles <= 3'd0;
            ended <= 1'd0;
        end else begin
            is_aborting <= is_aborting ? ~ends : (asked & running);
            quiet_cycles <= counts ? (quiet_cycles + 3'd1) : 3'd0;
            ended <= ends;
        end
    end
endmodule

// Writes records to memory, each in a burst.
// beats = 4
// width = 64
module bus_writer (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready,  // Records.
    input  wire [31:0] in_address,  // Where the record goes.
    input  wire [27:0] in_weight,  // Sum of weights.
    input  wire [51:0] in_depth,  // Sum of weighted depths.
    input  wire [15:0] in_attribute_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] in_attribute_1,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    input  wire [15:0] in_attribute_2,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire m_axi_awvalid, input wire m_axi_awready,  // Bursts to be written.
    output wire [3:0] m_axi_awid,  // The burst's identifier, which its answers bear.
    output wire [31:0] m_axi_awaddr,  // Its first byte.
    output wire [7:0] m_axi_awlen,  // One less than its beats.
    output wire [2:0] m_axi_awsize,  // The binary logarithm of a beat's bytes.
    output wire [1:0] m_axi_awburst,  // How the address goes on: up, where it is 1.
    output wire m_axi_wvalid, input wire m_axi_wready,  // Their beats.
    output wire [63:0] m_axi_wdata,  // Its bytes.
    output wire [7:0] m_axi_wstrb,  // A bit for each byte that is to be written.
    output wire m_axi_wlast,  // Closes its burst.
    input  wire m_axi_bvalid, output wire m_axi_bready,  // Answers to bursts.
    input  wire [3:0] m_axi_bid,  // The burst's identifier.
    input  wire [1:0] m_axi_bresp,  // Whether all is well: 0 if so.
    output reg  error,  // An answer was none of success.
    output wire idle  // All that was taken is written.
);
    reg [4:0] unanswered;
    reg held;
    reg [1:0] place;
    reg [27:0] held_weight;
    reg [51:0] held_depth;
    reg [15:0] held_attribute_0, held_attribute_1, held_attribute_2;

    wire address_queue_in_ready;
    wire [34:0] address_queue_out_data;
    wire beat_queue_in_ready;
    wire [64:0] beat_queue_out_data;

    wire moves = held & beat_queue_in_ready;
    wire at_end = place == 2'd3;
    wire leaves = moves & at_end;
    wire below_limit = ~(unanswered == 5'd16);
    wire accepts = address_queue_in_ready & below_limit;
    wire takes_record = (~held | leaves) & accepts;
    wire [26:0] address_queue_out_address = address_queue_out_data[34:8];
    wire takes = in_valid & takes_record;
    wire accepted = takes;
    wire [63:0] beat_queue_in_data_choice = place[0] ? 64'd0 : {16'd0, held_attribute_2, held_attribute_1, held_attribute_0};
    wire [63:0] beat_queue_in_data_choice_2 = place[1] ? beat_queue_in_data_choice : place[0] ? {12'd0, held_depth} : {36'd0, held_weight};

    assign in_ready = takes_record;
    assign m_axi_awid = 4'd0;
    assign m_axi_awaddr = {address_queue_out_address, 5'd0};
    assign m_axi_awlen = address_queue_out_data[7:0];
    assign m_axi_awsize = 3'd3;
    assign m_axi_awburst = 2'd1;
    assign m_axi_wdata = beat_queue_out_data[64:1];
    assign m_axi_wstrb = 8'd255;
    assign m_axi_wlast = beat_queue_out_data[0];
    assign m_axi_bready = 1'd1;
    assign idle = unanswered == 5'd0;

    stream_skid_w35 address_queue (
        .clk(clk), .rst(rst), .in_valid(accepted), .in_ready(address_queue_in_ready),
        .in_data({in_address[31:5], 8'd3}),
        .out_valid(m_axi_awvalid), .out_ready(m_axi_awready), .out_data(address_queue_out_data)
    );

    stream_skid_w65 beat_queue (
        .clk(clk), .rst(rst), .in_valid(held), .in_ready(beat_queue_in_ready),
        .in_data({beat_queue_in_data_choice_2, at_end}),
        .out_valid(m_axi_wvalid), .out_ready(m_axi_wready), .out_data(beat_queue_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            unanswered <= 5'd0;
            held <= 1'd0;
            place <= 2'd0;
            error <= 1'd0;
        end else begin
            unanswered <= (unanswered + {4'd0, accepted}) - {4'd0, m_axi_bvalid};
            held <= takes | (held & ~leaves);
            error <= m_axi_bvalid & |m_axi_bresp;
            if (moves) place <= at_end ? 2'd0 : (place + 2'd1);
        end
    end
    always @(posedge clk) begin
        if (takes) begin
            held_weight <= in_weight;
            held_depth <= in_depth;
            held_attribute_0 <= in_attribute_0;
            held_attribute_1 <= in_attribute_1;
            held_attribute_2 <= in_attribute_2;
        end
    end

    wire _unused = &{1'b0, in_address[4:0], m_axi_bid};
endmodule

// Reads records from memory in bursts.
// beats = 4
// width = 64
// records = 8
module bus_reader (
    input  wire clk, input wire rst,
    input  wire request_valid, output wire request_ready,  // Records wanted.
    input  wire [31:0] request_address,  // Where the first one lies.
    input  wire [3:0] request_records,  // How many.
    output wire m_axi_arvalid, input wire m_axi_arready,  // Bursts wanted.
    output wire [3:0] m_axi_arid,  // The burst's identifier, which its answers bear.
    output wire [31:0] m_axi_araddr,  // Its first byte.
    output wire [7:0] m_axi_arlen,  // One less than its beats.
    output wire [2:0] m_axi_arsize,  // The binary logarithm of a beat's bytes.
    output wire [1:0] m_axi_arburst,  // How the address goes on: up, where it is 1.
    input  wire m_axi_rvalid, output wire m_axi_rready,  // Their beats.
    input  wire [3:0] m_axi_rid,  // The burst's identifier.
    input  wire [63:0] m_axi_rdata,  // Its bytes.
    input  wire [1:0] m_axi_rresp,  // Whether all is well: 0 if so.
    input  wire m_axi_rlast,  // Closes its burst.
    output reg  record_valid, input wire record_ready,  // The records.
    output wire [27:0] record_weight,  // Sum of weights.
    output wire [51:0] record_depth,  // Sum of weighted depths.
    output wire [15:0] record_attribute_0,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] record_attribute_1,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output wire [15:0] record_attribute_2,  // Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    output reg  error,  // An answer was none of success.
    output reg  misplaced  // A burst ended whose last beat was not marked so, or another was; or a beat came that nobody asked for.
);
    reg held;
    reg [26:0] address;
    reg [3:0] records;
    reg [7:0] number;
    reg [27:0] held_weight_0;
    reg [51:0] held_depth_0;
    reg [15:0] held_attribute_0_0, held_attribute_1_0, held_attribute_2_0;
    reg is_wrong;

    wire address_queue_in_ready;
    wire [34:0] address_queue_out_data;
    wire length_queue_in_ready, length_queue_out_valid;
    wire [7:0] length_queue_out_data;
    wire beat_queue_out_valid;
    wire [52:0] beat_queue_out_data;

    wire issues = held & (address_queue_in_ready & length_queue_in_ready);
    wire [6:0] room_records = 7'd64 - {1'd0, address[5:0]};
    wire crosses = room_records < {3'd0, records};
    wire takes_request = ~held | (issues & ~crosses);
    wire [26:0] address_queue_out_address = address_queue_out_data[34:8];
    wire [6:0] burst = crosses ? room_records : {3'd0, records};
    wire [8:0] length_difference = {burst, 2'd0} - 9'd1;
    wire [7:0] length = length_difference[7:0];
    wire advance = ~record_valid | record_ready;
    wire moves = beat_queue_out_valid & (advance & length_queue_out_valid);
    wire ends = number == length_queue_out_data;
    wire length_queue_out_ready = moves & ends;
    wire beat_queue_out_ready = advance | ~length_queue_out_valid;
    wire takes_request_or_issues = takes_request | issues;
    wire [6:0] records_minus_room_records = {3'd0, records} - room_records;
    wire takes_beat_0 = moves & (number[1:0] == 2'd0);
    wire takes_beat_1 = moves & (number[1:0] == 2'd1);
    wire takes_beat_2 = moves & (number[1:0] == 2'd2);
    wire beat_queue_out_last = beat_queue_out_data[0];
    wire is_wrong_either = is_wrong | (beat_queue_out_last ^ ends);

    assign request_ready = takes_request;
    assign m_axi_arid = 4'd0;
    assign m_axi_araddr = {address_queue_out_address, 5'd0};
    assign m_axi_arlen = address_queue_out_data[7:0];
    assign m_axi_arsize = 3'd3;
    assign m_axi_arburst = 2'd1;
    assign record_weight = held_weight_0;
    assign record_depth = held_depth_0;
    assign record_attribute_0 = held_attribute_0_0;
    assign record_attribute_1 = held_attribute_1_0;
    assign record_attribute_2 = held_attribute_2_0;

    stream_skid_w35 address_queue (
        .clk(clk), .rst(rst), .in_valid(issues), .in_ready(address_queue_in_ready),
        .in_data({address, length}),
        .out_valid(m_axi_arvalid), .out_ready(m_axi_arready), .out_data(address_queue_out_data)
    );

    stream_fifo_d16_w8 length_queue (
        .clk(clk), .rst(rst), .in_valid(issues), .in_ready(length_queue_in_ready), .in_data(length),
        .out_valid(length_queue_out_valid), .out_ready(length_queue_out_ready),
        .out_data(length_queue_out_data)
    );

    stream_skid_w53 beat_queue (
        .clk(clk), .rst(rst), .in_valid(m_axi_rvalid), .in_ready(m_axi_rready),
        .in_data({m_axi_rdata[51:0], m_axi_rlast}),
        .out_valid(beat_queue_out_valid), .out_ready(beat_queue_out_ready), .out_data(beat_queue_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            held <= 1'd0;
            record_valid <= 1'd0;
            number <= 8'd0;
            error <= 1'd0;
            is_wrong <= 1'd0;
            misplaced <= 1'd0;
        end else begin
            if (takes_request) held <= request_valid;
            if (advance) record_valid <= moves & (number[1:0] == 2'd3);
            if (moves) begin
                number <= ends ? 8'd0 : (number + 8'd1);
                is_wrong <= ~ends & is_wrong_either;
            end
            error <= m_axi_rvalid & m_axi_rready & |m_axi_rresp;
            misplaced <= (beat_queue_out_valid & ~length_queue_out_valid) | (moves & (ends & is_wrong_either));
        end
    end
    always @(posedge clk) begin
        if (takes_request_or_issues) begin
            address <= takes_request ? request_address[31:5] : {address[26:6] + 21'd1, 6'd0};
            records <= takes_request ? request_records : records_minus_room_records[3:0];
        end
        if (takes_beat_0) held_weight_0 <= beat_queue_out_data[28:1];
        if (takes_beat_1) held_depth_0 <= beat_queue_out_data[52:1];
        if (takes_beat_2) begin
            held_attribute_0_0 <= beat_queue_out_data[16:1];
            held_attribute_1_0 <= beat_queue_out_data[32:17];
            held_attribute_2_0 <= beat_queue_out_data[48:33];
        end
    end

    wire _unused = &{
        1'b0, length_difference[8], m_axi_rdata[63:52], m_axi_rid, records_minus_room_records[6:4],
        request_address[4:0]
    };

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        a_request_is_for_some_and_no_more_than_any_may_be: assert (~request_valid | (|request_records & ~(4'd8 < request_records)));
        no_burst_is_longer_than_any_may_be: assert (~length_queue_out_valid | (length_queue_out_data < 8'd32));
        no_burst_is_longer_than_asked_for: assert (~length_queue_out_valid | ~(length_queue_out_data < number));
`else
        if (!(~request_valid | (|request_records & ~(4'd8 < request_records)))) begin
            $display("assertion failed: a_request_is_for_some_and_no_more_than_any_may_be in %m"); $stop;
        end
        if (!(~length_queue_out_valid | (length_queue_out_data < 8'd32))) begin
            $display("assertion failed: no_burst_is_longer_than_any_may_be in %m"); $stop;
        end
        if (!(~length_queue_out_valid | ~(length_queue_out_data < number))) begin
            $display("assertion failed: no_burst_is_longer_than_asked_for in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue of two in registers.
// width = 53
module stream_skid_w53 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [52:0] in_data,
    output wire out_valid, input wire out_ready, output wire [52:0] out_data
);
    reg head_filled, second_filled, room;
    reg [52:0] head, second;

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
// width = 8
module stream_fifo_d16_w8 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [7:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [7:0] out_data
);
    reg [4:0] held, waiting;
    reg is_full, any_waits;
    reg [3:0] write_address, read_address;
    wire [7:0] item;

    wire has_room = ~is_full;
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [4:0] held_bits = {{4{~push}}, 1'd1};
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    memory_1w1r_unordered #(.WIDTH(8), .DEPTH(16)) entries (
        .clk(clk), .write(has_room), .write_address(write_address), .write_data(in_data),
        .read(fetch), .read_address(read_address), .read_data(item)
    );

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
// width = 35
module stream_skid_w35 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [34:0] in_data,
    output wire out_valid, input wire out_ready, output wire [34:0] out_data
);
    reg head_filled, second_filled, room;
    reg [34:0] head, second;

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

// Spreads records over the beats of packets.
// beats = 2
// width = 64
module bus_packet_out (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready,  // Records.
    input  wire in_end,  // Closes the frame.
    input  wire [6:0] in_column,  // Column of the image.
    input  wire [6:0] in_row,  // Row of the image.
    input  wire [23:0] in_depth,  // Depth in the geometry format.
    input  wire [15:0] in_attribute_0,  // Attributes.
    input  wire [15:0] in_attribute_1,  // Attributes.
    input  wire [15:0] in_attribute_2,  // Attributes.
    output wire m_axis_tvalid, input wire m_axis_tready,  // Beats of packets.
    output wire [63:0] m_axis_tdata,  // Its bytes.
    output wire m_axis_tlast,  // Closes its packet.
    output reg  sent,  // A packet was sent.
    output wire idle  // Nothing is on its way.
);
    reg held, place, held_end;
    reg [6:0] held_column, held_row;
    reg [23:0] held_depth;
    reg [15:0] held_attribute_0, held_attribute_1, held_attribute_2;

    wire beat_queue_in_ready;
    wire [64:0] beat_queue_out_data;

    wire moves = held & beat_queue_in_ready;
    wire leaves = moves & place;
    wire takes_record = ~held | leaves;
    wire [63:0] beat_queue_in_data_bits = {8'd0, held_depth, 9'd0, held_row, 1'd0, held_column, 7'd0, held_end};
    wire [63:0] beat_queue_in_data_choice = place ? {16'd0, held_attribute_2, held_attribute_1, held_attribute_0} : beat_queue_in_data_bits;
    wire takes = in_valid & takes_record;
    wire beat_queue_out_last = beat_queue_out_data[0];

    assign in_ready = takes_record;
    assign {m_axis_tdata, m_axis_tlast} = beat_queue_out_data;
    assign idle = ~held & ~m_axis_tvalid;

    stream_skid_w65 beat_queue (
        .clk(clk), .rst(rst), .in_valid(held), .in_ready(beat_queue_in_ready),
        .in_data({beat_queue_in_data_choice, place}),
        .out_valid(m_axis_tvalid), .out_ready(m_axis_tready), .out_data(beat_queue_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            held <= 1'd0;
            place <= 1'd0;
            sent <= 1'd0;
        end else begin
            held <= takes | (held & ~leaves);
            sent <= m_axis_tvalid & m_axis_tready & beat_queue_out_last;
            if (moves) place <= place ? 1'd0 : (place + 1'd1);
        end
    end
    always @(posedge clk) begin
        if (takes) begin
            held_end <= in_end;
            held_column <= in_column;
            held_row <= in_row;
            held_depth <= in_depth;
            held_attribute_0 <= in_attribute_0;
            held_attribute_1 <= in_attribute_1;
            held_attribute_2 <= in_attribute_2;
        end
    end
endmodule

// Queue of two in registers.
// width = 65
module stream_skid_w65 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [64:0] in_data,
    output wire out_valid, input wire out_ready, output wire [64:0] out_data
);
    reg head_filled, second_filled, room;
    reg [64:0] head, second;

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

// Begins frames, each with the uniforms written before its start.
// uniforms = 23
module bus_frames (
    input  wire clk, input wire rst,
    input  wire start,  // A frame is asked for.
    input  wire set_up,  // The frame that began last is set up.
    input  wire sent,  // A frame has left.
    input  wire write_valid,  // Writes to uniforms; none comes while a start waits.
    input  wire [4:0] write_address,  // Its place among the frame's uniforms.
    input  wire [23:0] write_data,  // Its new value.
    output reg  uniform_valid,  // The uniforms of the frame that begins.
    output reg  [4:0] uniform_address,  // Its place among the frame's uniforms.
    output reg  [23:0] uniform_data,  // Its new value.
    output reg  begun,  // Its uniforms are written, its splats may come.
    output wire idle  // No frame is asked for or under way.
);
    (* ram_style = "distributed" *)
    reg [23:0] values [0:31];
    reg waiting, setting_up;
    reg [1:0] under_way;
    reg [15:0] filter_scale;
    reg filter_scale_changes, copies;
    reg [4:0] copied;

    wire is_alone = under_way == 2'd0;
    wire ends = copies & (copied == 5'd22);
    wire begins = waiting & ~(setting_up | (under_way == 2'd3)) & (is_alone | ~filter_scale_changes);
    wire writes_filter_scale = write_valid & (write_address == 5'd22);
    wire [23:0] value = values[copied];

    assign idle = ~waiting & is_alone;

    always @(posedge clk) begin
        if (rst) begin
            waiting <= 1'd0;
            setting_up <= 1'd0;
            under_way <= 2'd0;
            filter_scale_changes <= 1'd0;
            copies <= 1'd0;
            uniform_valid <= 1'd0;
            begun <= 1'd0;
        end else begin
            waiting <= start | (waiting & ~ends);
            setting_up <= begins | (setting_up & ~set_up);
            under_way <= (under_way + {1'd0, begins}) - {1'd0, sent};
            filter_scale_changes <= (writes_filter_scale & ~(filter_scale == write_data[15:0])) | (filter_scale_changes & ~begins);
            copies <= begins | (copies & ~ends);
            uniform_valid <= copies;
            begun <= ends;
        end
    end
    always @(posedge clk) begin
        if (writes_filter_scale) filter_scale <= write_data[15:0];
        copied <= begins ? 5'd0 : (copied + 5'd1);
        uniform_address <= copied;
        uniform_data <= value;
    end
    always @(posedge clk) if (write_valid) values[write_address] <= write_data;
endmodule

// Gathers the beats of packets into records.
// beats = 6
// width = 64
module bus_packet_in (
    input  wire clk, input wire rst,
    input  wire opens,  // A run begins.
    input  wire s_axis_tvalid, output wire s_axis_tready,  // Beats of packets.
    input  wire [63:0] s_axis_tdata,  // Its bytes.
    input  wire s_axis_tlast,  // Closes its packet.
    output reg  out_valid, input wire out_ready,  // The records of good packets.
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
    output wire [15:0] out_attribute_0,  // Attributes.
    output wire [15:0] out_attribute_1,  // Attributes.
    output wire [15:0] out_attribute_2,  // Attributes.
    output reg  taken,  // A packet was taken.
    output reg  refused  // A packet was refused.
);
    reg [2:0] place;
    reg is_overlong, begun, ends, is_open, held_end_0;
    reg [23:0] held_center_x_0, held_center_y_0, held_center_z_0, held_tangent1_x_0, held_tangent1_y_0;
    reg [23:0] held_tangent1_z_0, held_tangent2_x_0, held_tangent2_y_0, held_tangent2_z_0;
    reg [15:0] held_attribute_0_0, held_attribute_1_0, held_attribute_2_0;

    wire beat_queue_in_ready, beat_queue_out_valid;
    wire [59:0] beat_queue_out_data;

    wire s_axis_ready = beat_queue_in_ready & (begun | is_open);
    wire takes = s_axis_tvalid & s_axis_ready;
    wire takes_and_not_is_overlong = takes & ~is_overlong;
    wire place_is_5 = place == 3'd5;
    wire whole = takes & (s_axis_tlast & (place_is_5 & ~is_overlong));
    wire advance = ~out_valid | out_ready;
    wire beat_queue_out_good = beat_queue_out_data[59];
    wire moves = beat_queue_out_valid & advance;
    wire [2:0] beat_queue_out_place = beat_queue_out_data[2:0];
    wire takes_beat_0 = moves & (beat_queue_out_place == 3'd0);
    wire takes_beat_1 = moves & (beat_queue_out_place == 3'd1);
    wire takes_beat_2 = moves & (beat_queue_out_place == 3'd2);
    wire takes_beat_3 = moves & (beat_queue_out_place == 3'd3);
    wire takes_beat_4 = moves & (beat_queue_out_place == 3'd4);
    wire takes_beat_5 = moves & (beat_queue_out_place == 3'd5);

    assign s_axis_tready = s_axis_ready;
    assign out_end = held_end_0;
    assign out_center_x = held_center_x_0;
    assign out_center_y = held_center_y_0;
    assign out_center_z = held_center_z_0;
    assign out_tangent1_x = held_tangent1_x_0;
    assign out_tangent1_y = held_tangent1_y_0;
    assign out_tangent1_z = held_tangent1_z_0;
    assign out_tangent2_x = held_tangent2_x_0;
    assign out_tangent2_y = held_tangent2_y_0;
    assign out_tangent2_z = held_tangent2_z_0;
    assign out_attribute_0 = held_attribute_0_0;
    assign out_attribute_1 = held_attribute_1_0;
    assign out_attribute_2 = held_attribute_2_0;

    stream_skid_w60 beat_queue (
        .clk(clk), .rst(rst), .in_valid(takes_and_not_is_overlong), .in_ready(beat_queue_in_ready),
        .in_data({whole, s_axis_tdata[55:0], place}),
        .out_valid(beat_queue_out_valid), .out_ready(advance), .out_data(beat_queue_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            place <= 3'd0;
            is_overlong <= 1'd0;
            begun <= 1'd0;
            is_open <= 1'd0;
            out_valid <= 1'd0;
            taken <= 1'd0;
            refused <= 1'd0;
        end else begin
            if (takes_and_not_is_overlong) begin
                place <= (s_axis_tlast | place_is_5) ? 3'd0 : (place + 3'd1);
            end
            if (takes) begin
                is_overlong <= ~s_axis_tlast & (is_overlong | place_is_5);
                begun <= ~s_axis_tlast;
            end
            is_open <= opens | (is_open & ~(whole & ends));
            taken <= whole;
            refused <= takes & ((s_axis_tlast ^ place_is_5) & ~is_overlong);
            if (advance) out_valid <= beat_queue_out_valid & beat_queue_out_good;
        end
    end
    always @(posedge clk) begin
        if (takes & (place == 3'd0)) ends <= s_axis_tdata[0];
        if (takes_beat_0) begin
            held_end_0 <= beat_queue_out_data[3];
            held_center_x_0 <= beat_queue_out_data[58:35];
        end
        if (takes_beat_1) begin
            held_center_y_0 <= beat_queue_out_data[26:3];
            held_center_z_0 <= beat_queue_out_data[58:35];
        end
        if (takes_beat_2) begin
            held_tangent1_x_0 <= beat_queue_out_data[26:3];
            held_tangent1_y_0 <= beat_queue_out_data[58:35];
        end
        if (takes_beat_3) begin
            held_tangent1_z_0 <= beat_queue_out_data[26:3];
            held_tangent2_x_0 <= beat_queue_out_data[58:35];
        end
        if (takes_beat_4) begin
            held_tangent2_y_0 <= beat_queue_out_data[26:3];
            held_tangent2_z_0 <= beat_queue_out_data[58:35];
        end
        if (takes_beat_5) begin
            held_attribute_0_0 <= beat_queue_out_data[18:3];
            held_attribute_1_0 <= beat_queue_out_data[34:19];
            held_attribute_2_0 <= beat_queue_out_data[50:35];
        end
    end

    wire _unused = &{1'b0, s_axis_tdata[63:56]};
endmodule

// Queue of two in registers.
// width = 60
module stream_skid_w60 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [59:0] in_data,
    output wire out_valid, input wire out_ready, output wire [59:0] out_data
);
    reg head_filled, second_filled, room;
    reg [59:0] head, second;

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

// Registers of a core.
// registers = 42
module bus_registers (
    input  wire clk, input wire rst,
    input  wire s_axil_awvalid, output wire s_axil_awready,  // Registers to be written.
    input  wire [11:0] s_axil_awaddr,  // Its first byte.
    input  wire s_axil_wvalid, output wire s_axil_wready,  // What is written to them.
    input  wire [31:0] s_axil_wdata,  // The value.
    input  wire [3:0] s_axil_wstrb,  // A bit for each byte that is to be written.
    output reg  s_axil_bvalid, input wire s_axil_bready,  // Answers to writes.
    output wire [1:0] s_axil_bresp,  // Whether all is well: 0 if so.
    input  wire finished,  // The run has ended.
    input  wire occupied,  // No run may begin.
    input  wire begun,  // The frame of the start that waited has begun.
    output reg  busy,  // A run is under way.
    output reg  start,  // A run begins.
    output reg  core_reset,  // The core is to be reset.
    output reg  aborts,  // The run is to end.
    output reg  uniform_valid,  // Writes to the core's own registers.
    output reg  [4:0] uniform_address,  // The register's place among them.
    output reg  [23:0] uniform_data,  // Its new value.
    input  wire burst_error,  // A burst was refused, or ended where it must not.
    input  wire packet_error,  // A packet was refused.
    input  wire [1:0] memory_error,  // Memory answered with an error.
    input  wire packet_taken,  // A packet was taken.
    input  wire packet_sent,  // A packet was sent.
    input  wire event_sample,  // Rasterizers that evaluated a sample.
    input  wire event_starved,  // Rasterizers that had no copy to work on.
    input  wire event_blocked,  // Rasterizers whose pipeline was held by what follows it.
    input  wire event_accumulate,  // Accumulators that took a sample.
    input  wire event_hazard,  // Accumulators that waited for an earlier sample of the same pixel.
    input  wire event_slot_wait,  // Accumulators that waited for a tile to arrive in the cache.
    input  wire s_axil_arvalid, output wire s_axil_arready,  // Registers to be read.
    input  wire [11:0] s_axil_araddr,  // Its first byte.
    output reg  s_axil_rvalid, input wire s_axil_rready,  // What is read from them.
    output reg  [31:0] s_axil_rdata,  // The value.
    output wire [1:0] s_axil_rresp,  // Whether all is well: 0 if so.
    output reg  irq,  // Interrupt.
    output wire [31:0] buffer_base  // Address of the reconstruction buffer.
);
    (* ram_style = "distributed" *)
    reg [31:0] words [0:13];
    reg has_address, has_data;
    reg [11:0] write_address;
    reg [31:0] write_data;
    reg write_strobes, write_is_okay, interrupt_enable_bits;
    reg [19:0] buffer_base_bits;
    reg waiting, clear_errors, begins_run, done, has_read_address;
    reg [11:0] read_address;
    reg error, adds;
    reg [3:0] visited;
    reg [6:0] part_0;
    reg void_0;
    reg [5:0] part_1;
    reg void_1;
    reg [5:0] part_2;
    reg void_2;
    reg [5:0] part_3;
    reg void_3;
    reg [6:0] part_4;
    reg void_4;
    reg [5:0] part_5;
    reg void_5;
    reg [5:0] part_6;
    reg void_6;
    reg [5:0] part_7;
    reg void_7;
    reg [5:0] part_8;
    reg void_8;
    reg [5:0] part_9;
    reg void_9;
    reg [5:0] part_10;
    reg void_10;
    reg [5:0] part_11;
    reg void_11;
    reg [5:0] part_12;
    reg void_12;
    reg [5:0] part_13;
    reg void_13;
    reg [6:0] part;
    reg is_void;
    reg [31:0] word;
    reg [3:0] round;
    reg for_read, read_valid;
    reg [31:0] read_value;
    reg read_is_error;

    wire read_ready = ~(has_read_address | s_axil_rvalid);
    wire judges = has_address & (has_data & ~s_axil_bvalid);
    wire write_address_11_2_is_1 = write_address[11:2] == 10'd1;
    wire write_address_11_2_is_3 = write_address[11:2] == 10'd3;
    wire write_address_11_2_is_32 = write_address[11:2] == 10'd32;
    wire shaped_either = write_address_11_2_is_1 | write_address_11_2_is_3 | write_address_11_2_is_32;
    wire uniform_valid_both = (10'd64 <= write_address[11:2]) & ~(10'd86 < write_address[11:2]);
    wire shaped = write_strobes & (write_address[1:0] == 2'd0) & (shaped_either | uniform_valid_both);
    wire idle_only = write_address_11_2_is_32 | (write_address_11_2_is_1 & write_data[1]);
    wire wants_start = write_address_11_2_is_1 & write_data[0];
    wire ahead_only = wants_start | uniform_valid_both;
    wire blocked = (idle_only & busy) | (ahead_only & waiting) | (wants_start & occupied);
    wire senseless = write_address_11_2_is_32 & |write_data[11:0];
    wire write_accepted = judges & (shaped & ~(blocked | senseless));
    wire commands = write_accepted & write_address_11_2_is_1;
    wire starts = commands & write_data[0];
    reg [4:0] found;
    always @(*) begin
        case (read_address[6:2])
            5'd0: found = 5'd0;
            5'd1: found = 5'd0;
            5'd2: found = 5'd0;
            5'd3: found = 5'd0;
            5'd4: found = 5'd16;
            5'd5: found = 5'd17;
            5'd6: found = 5'd18;
            5'd7: found = 5'd19;
            5'd8: found = 5'd20;
            5'd9: found = 5'd21;
            5'd10: found = 5'd22;
            5'd11: found = 5'd23;
            5'd12: found = 5'd0;
            5'd13: found = 5'd0;
            5'd14: found = 5'd0;
            5'd15: found = 5'd0;
            5'd16: found = 5'd24;
            5'd17: found = 5'd25;
            5'd18: found = 5'd26;
            5'd19: found = 5'd27;
            5'd20: found = 5'd28;
            5'd21: found = 5'd29;
            5'd22: found = 5'd0;
            5'd23: found = 5'd0;
            5'd24: found = 5'd0;
            5'd25: found = 5'd0;
            5'd26: found = 5'd0;
            5'd27: found = 5'd0;
            5'd28: found = 5'd0;
            5'd29: found = 5'd0;
            5'd30: found = 5'd0;
            default: found = 5'd0;
        endcase
    end
    wire reads_counter = found[4] & (read_address[11:7] == 5'd0);
    wire read_address_11_2_is_0 = read_address[11:2] == 10'd0;
    wire read_address_11_2_is_2 = read_address[11:2] == 10'd2;
    wire read_address_11_2_is_3 = read_address[11:2] == 10'd3;
    wire refused_read_either = read_address_11_2_is_0 | read_address_11_2_is_2 | read_address_11_2_is_3;
    wire read_address_11_2_is_32 = read_address[11:2] == 10'd32;
    wire refused_read_both = (read_address[1:0] == 2'd0) & (refused_read_either | read_address_11_2_is_32 | reads_counter);
    wire refused_read = has_read_address & ~refused_read_both;
    wire asks = has_read_address & (reads_counter & ~refused_read);
    wire answers = has_read_address & (~asks | read_valid);
    wire refused_write = judges & (~shaped | (~blocked & senseless));
    wire refused_busy = judges & (shaped & blocked);
    wire error_either = refused_write | refused_read | refused_busy | burst_error | packet_error;
    wire looks = ~adds;
    wire turns_aside = asks & ~for_read;
    wire visits_0 = looks & (visited == 4'd0);
    wire [6:0] part_0_sum = {6'd0, refused_write} + {6'd0, refused_read};
    wire visits_1 = looks & (visited == 4'd1);
    wire visits_2 = looks & (visited == 4'd2);
    wire visits_3 = looks & (visited == 4'd3);
    wire visits_4 = looks & (visited == 4'd4);
    wire [6:0] part_4_sum = {6'd0, memory_error[0]} + {6'd0, memory_error[1]};
    wire visits_5 = looks & (visited == 4'd5);
    wire visits_6 = looks & (visited == 4'd6);
    wire packet_taken_and_busy = packet_taken & busy;
    wire [5:0] part_6_bits = {5'd0, packet_taken_and_busy};
    wire visits_7 = looks & (visited == 4'd7);
    wire packet_sent_and_busy = packet_sent & busy;
    wire [5:0] part_7_bits = {5'd0, packet_sent_and_busy};
    wire visits_8 = looks & (visited == 4'd8);
    wire event_sample_and_busy = event_sample & busy;
    wire [5:0] part_8_bits = {5'd0, event_sample_and_busy};
    wire visits_9 = looks & (visited == 4'd9);
    wire event_starved_and_busy = event_starved & busy;
    wire [5:0] part_9_bits = {5'd0, event_starved_and_busy};
    wire visits_10 = looks & (visited == 4'd10);
    wire event_blocked_and_busy = event_blocked & busy;
    wire [5:0] part_10_bits = {5'd0, event_blocked_and_busy};
    wire visits_11 = looks & (visited == 4'd11);
    wire event_accumulate_and_busy = event_accumulate & busy;
    wire [5:0] part_11_bits = {5'd0, event_accumulate_and_busy};
    wire visits_12 = looks & (visited == 4'd12);
    wire event_hazard_and_busy = event_hazard & busy;
    wire [5:0] part_12_bits = {5'd0, event_hazard_and_busy};
    wire visits_13 = looks & (visited == 4'd13);
    wire event_slot_wait_and_busy = event_slot_wait & busy;
    wire [5:0] part_13_bits = {5'd0, event_slot_wait_and_busy};
    wire [6:0] part_choice = visited[1] ? {1'd0, part_13} : visited[0] ? {1'd0, part_13} : {1'd0, part_12};
    wire [6:0] part_choice_2 = visited[1] ? (visited[0] ? {1'd0, part_11} : {1'd0, part_10}) : visited[0] ? {1'd0, part_9} : {1'd0, part_8};
    wire [6:0] part_choice_3 = visited[1] ? (visited[0] ? {1'd0, part_7} : {1'd0, part_6}) : visited[0] ? {1'd0, part_5} : part_4;
    wire [6:0] part_choice_4 = visited[1] ? (visited[0] ? {1'd0, part_3} : {1'd0, part_2}) : visited[0] ? {1'd0, part_1} : part_0;
    wire is_void_choice = visited[1] ? (visited[0] ? void_11 : void_10) : visited[0] ? void_9 : void_8;
    wire is_void_choice_2 = visited[2] ? (visited[1] ? void_13 : visited[0] ? void_13 : void_12) : is_void_choice;
    wire is_void_choice_3 = visited[1] ? (visited[0] ? void_7 : void_6) : visited[0] ? void_5 : void_4;
    wire is_void_choice_4 = visited[1] ? (visited[0] ? void_3 : void_2) : visited[0] ? void_1 : void_0;
    wire [32:0] sum = {1'd0, is_void ? 32'd0 : word} + {26'd0, part};
    wire [31:0] saturated = sum[31:0] | {32{sum[32]}};
    wire [31:0] s_axil_rdata_both = {32{read_address_11_2_is_2}} & {28'd0, waiting, error, done, busy};
    wire [31:0] s_axil_rdata_either = ({32{read_address_11_2_is_0}} & 32'h50430a01) | s_axil_rdata_both;
    wire [31:0] s_axil_rdata_either_2 = s_axil_rdata_either | ({32{read_address_11_2_is_3}} & {31'd0, interrupt_enable_bits});
    wire [31:0] s_axil_rdata_either_3 = s_axil_rdata_either_2 | ({32{read_address_11_2_is_32}} & {buffer_base_bits, 12'd0});

    assign s_axil_awready = ~has_address;
    assign s_axil_wready = ~has_data;
    assign s_axil_bresp = write_is_okay ? 2'd0 : 2'd2;
    assign s_axil_arready = read_ready;
    assign s_axil_rresp = read_is_error ? 2'd2 : 2'd0;
    assign buffer_base = {buffer_base_bits, 12'd0};

    always @(posedge clk) begin
        if (rst) begin
            has_address <= 1'd0;
            has_data <= 1'd0;
            s_axil_bvalid <= 1'd0;
            busy <= 1'd0;
            interrupt_enable_bits <= 1'd0;
            buffer_base_bits <= 20'd0;
            waiting <= 1'd0;
            start <= 1'd0;
            core_reset <= 1'd0;
            clear_errors <= 1'd0;
            aborts <= 1'd0;
            begins_run <= 1'd0;
            done <= 1'd0;
            uniform_valid <= 1'd0;
            has_read_address <= 1'd0;
            error <= 1'd0;
            adds <= 1'd0;
            visited <= 4'd0;
            part_0 <= 7'd0;
            void_0 <= 1'd1;
            part_1 <= 6'd0;
            void_1 <= 1'd1;
            part_2 <= 6'd0;
            void_2 <= 1'd1;
            part_3 <= 6'd0;
            void_3 <= 1'd1;
            part_4 <= 7'd0;
            void_4 <= 1'd1;
            part_5 <= 6'd0;
            void_5 <= 1'd1;
            part_6 <= 6'd0;
            void_6 <= 1'd1;
            part_7 <= 6'd0;
            void_7 <= 1'd1;
            part_8 <= 6'd0;
            void_8 <= 1'd1;
            part_9 <= 6'd0;
            void_9 <= 1'd1;
            part_10 <= 6'd0;
            void_10 <= 1'd1;
            part_11 <= 6'd0;
            void_11 <= 1'd1;
            part_12 <= 6'd0;
            void_12 <= 1'd1;
            part_13 <= 6'd0;
            void_13 <= 1'd1;
            round <= 4'd0;
            for_read <= 1'd0;
            read_valid <= 1'd0;
            s_axil_rvalid <= 1'd0;
            irq <= 1'd0;
        end else begin
            has_address <= has_address ? ~judges : s_axil_awvalid;
            has_data <= has_data ? ~judges : s_axil_wvalid;
            s_axil_bvalid <= judges | (s_axil_bvalid & ~s_axil_bready);
            busy <= starts | (busy & ~finished);
            waiting <= starts | (waiting & ~(begun | finished));
            start <= starts;
            core_reset <= commands & write_data[1];
            clear_errors <= commands & write_data[2];
            aborts <= commands & write_data[3];
            begins_run <= starts & ~busy;
            done <= ~starts & (done | (busy & finished));
            uniform_valid <= write_accepted & uniform_valid_both;
            has_read_address <= (read_ready & s_axil_arvalid) | (has_read_address & ~answers);
            error <= error_either | memory_error[0] | memory_error[1] | (error & ~clear_errors);
            adds <= looks;
            part_0 <= (visits_0 | clear_errors) ? part_0_sum : (part_0 + part_0_sum);
            void_0 <= clear_errors | (void_0 & ~visits_0);
            part_1 <= (visits_1 | clear_errors) ? {5'd0, refused_busy} : (part_1 + {5'd0, refused_busy});
            void_1 <= clear_errors | (void_1 & ~visits_1);
            part_2 <= (visits_2 | clear_errors) ? {5'd0, burst_error} : (part_2 + {5'd0, burst_error});
            void_2 <= clear_errors | (void_2 & ~visits_2);
            part_3 <= (visits_3 | clear_errors) ? {5'd0, packet_error} : (part_3 + {5'd0, packet_error});
            void_3 <= clear_errors | (void_3 & ~visits_3);
            part_4 <= (visits_4 | clear_errors) ? part_4_sum : (part_4 + part_4_sum);
            void_4 <= clear_errors | (void_4 & ~visits_4);
            part_5 <= (visits_5 | begins_run) ? {5'd0, busy} : (part_5 + {5'd0, busy});
            void_5 <= begins_run | (void_5 & ~visits_5);
            part_6 <= (visits_6 | begins_run) ? part_6_bits : (part_6 + part_6_bits);
            void_6 <= begins_run | (void_6 & ~visits_6);
            part_7 <= (visits_7 | begins_run) ? part_7_bits : (part_7 + part_7_bits);
            void_7 <= begins_run | (void_7 & ~visits_7);
            part_8 <= (visits_8 | begins_run) ? part_8_bits : (part_8 + part_8_bits);
            void_8 <= begins_run | (void_8 & ~visits_8);
            part_9 <= (visits_9 | begins_run) ? part_9_bits : (part_9 + part_9_bits);
            void_9 <= begins_run | (void_9 & ~visits_9);
            part_10 <= (visits_10 | begins_run) ? part_10_bits : (part_10 + part_10_bits);
            void_10 <= begins_run | (void_10 & ~visits_10);
            part_11 <= (visits_11 | begins_run) ? part_11_bits : (part_11 + part_11_bits);
            void_11 <= begins_run | (void_11 & ~visits_11);
            part_12 <= (visits_12 | begins_run) ? part_12_bits : (part_12 + part_12_bits);
            void_12 <= begins_run | (void_12 & ~visits_12);
            part_13 <= (visits_13 | begins_run) ? part_13_bits : (part_13 + part_13_bits);
            void_13 <= begins_run | (void_13 & ~visits_13);
            read_valid <= adds & for_read;
            s_axil_rvalid <= answers | (s_axil_rvalid & ~s_axil_rready);
            irq <= done & interrupt_enable_bits;
            if (write_accepted & write_address_11_2_is_3) interrupt_enable_bits <= write_data[0];
            if (write_accepted & write_address_11_2_is_32) buffer_base_bits <= write_data[31:12];
            if (adds) begin
                visited <= turns_aside ? found[3:0] : round;
                for_read <= turns_aside;
            end
            if (adds & ~turns_aside) round <= (round == 4'd13) ? 4'd0 : (round + 4'd1);
        end
    end
    always @(posedge clk) begin
        if (~has_address) write_address <= s_axil_awaddr;
        if (~has_data) begin
            write_data <= s_axil_wdata;
            write_strobes <= &s_axil_wstrb;
        end
        if (judges) write_is_okay <= write_accepted;
        uniform_address <= write_address[6:2];
        uniform_data <= write_data[23:0];
        part <= visited[3] ? (visited[2] ? part_choice : part_choice_2) : visited[2] ? part_choice_3 : part_choice_4;
        is_void <= visited[3] ? is_void_choice_2 : visited[2] ? is_void_choice_3 : is_void_choice_4;
        read_value <= saturated;
        if (read_ready) read_address <= s_axil_araddr;
        if (answers) begin
            s_axil_rdata <= asks ? read_value : (s_axil_rdata_either_3 & {32{~refused_read}});
            read_is_error <= refused_read;
        end
    end
    always @(posedge clk) begin
        if (adds) words[visited] <= saturated;
        word <= words[visited];
    end

`ifdef RTL_ASSERT
    wire [7:0] part_0_plus_part_0_sum = {1'd0, part_0} + {1'd0, part_0_sum};
    wire [6:0] part_1_plus_refused_busy = {1'd0, part_1} + {6'd0, refused_busy};
    wire [6:0] part_2_plus_burst_error = {1'd0, part_2} + {6'd0, burst_error};
    wire [6:0] part_3_plus_packet_error = {1'd0, part_3} + {6'd0, packet_error};
    wire [7:0] part_4_plus_part_4_sum = {1'd0, part_4} + {1'd0, part_4_sum};
    wire [6:0] part_5_plus_busy = {1'd0, part_5} + {6'd0, busy};
    wire [6:0] check_sum = {1'd0, part_6} + {6'd0, packet_taken_and_busy};
    wire [6:0] check_sum_2 = {1'd0, part_7} + {6'd0, packet_sent_and_busy};
    wire [6:0] check_sum_3 = {1'd0, part_8} + {6'd0, event_sample_and_busy};
    wire [6:0] check_sum_4 = {1'd0, part_9} + {6'd0, event_starved_and_busy};
    wire [6:0] check_sum_5 = {1'd0, part_10} + {6'd0, event_blocked_and_busy};
    wire [6:0] check_sum_6 = {1'd0, part_11} + {6'd0, event_accumulate_and_busy};
    wire [6:0] check_sum_7 = {1'd0, part_12} + {6'd0, event_hazard_and_busy};
    wire [6:0] check_sum_8 = {1'd0, part_13} + {6'd0, event_slot_wait_and_busy};

    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        part_0_has_room: assert (~part_0_plus_part_0_sum[7]);
        part_1_has_room: assert (~part_1_plus_refused_busy[6]);
        part_2_has_room: assert (~part_2_plus_burst_error[6]);
        part_3_has_room: assert (~part_3_plus_packet_error[6]);
        part_4_has_room: assert (~part_4_plus_part_4_sum[7]);
        part_5_has_room: assert (~part_5_plus_busy[6]);
        part_6_has_room: assert (~check_sum[6]);
        part_7_has_room: assert (~check_sum_2[6]);
        part_8_has_room: assert (~check_sum_3[6]);
        part_9_has_room: assert (~check_sum_4[6]);
        part_10_has_room: assert (~check_sum_5[6]);
        part_11_has_room: assert (~check_sum_6[6]);
        part_12_has_room: assert (~check_sum_7[6]);
        part_13_has_room: assert (~check_sum_8[6]);
`else
        if (!(~part_0_plus_part_0_sum[7])) begin
            $display("assertion failed: part_0_has_room in %m"); $stop;
        end
        if (!(~part_1_plus_refused_busy[6])) begin
            $display("assertion failed: part_1_has_room in %m"); $stop;
        end
        if (!(~part_2_plus_burst_error[6])) begin
            $display("assertion failed: part_2_has_room in %m"); $stop;
        end
        if (!(~part_3_plus_packet_error[6])) begin
            $display("assertion failed: part_3_has_room in %m"); $stop;
        end
        if (!(~part_4_plus_part_4_sum[7])) begin
            $display("assertion failed: part_4_has_room in %m"); $stop;
        end
        if (!(~part_5_plus_busy[6])) begin
            $display("assertion failed: part_5_has_room in %m"); $stop;
        end
        if (!(~check_sum[6])) begin $display("assertion failed: part_6_has_room in %m"); $stop; end
        if (!(~check_sum_2[6])) begin $display("assertion failed: part_7_has_room in %m"); $stop; end
        if (!(~check_sum_3[6])) begin $display("assertion failed: part_8_has_room in %m"); $stop; end
        if (!(~check_sum_4[6])) begin $display("assertion failed: part_9_has_room in %m"); $stop; end
        if (!(~check_sum_5[6])) begin $display("assertion failed: part_10_has_room in %m"); $stop; end
        if (!(~check_sum_6[6])) begin $display("assertion failed: part_11_has_room in %m"); $stop; end
        if (!(~check_sum_7[6])) begin $display("assertion failed: part_12_has_room in %m"); $stop; end
        if (!(~check_sum_8[6])) begin $display("assertion failed: part_13_has_room in %m"); $stop; end
`endif
    end

    wire _unused_by_checks = &{
        1'b0, check_sum[5:0], check_sum_2[5:0], check_sum_3[5:0], check_sum_4[5:0], check_sum_5[5:0],
        check_sum_6[5:0], check_sum_7[5:0], check_sum_8[5:0], part_0_plus_part_0_sum[6:0],
        part_1_plus_refused_busy[5:0], part_2_plus_burst_error[5:0], part_3_plus_packet_error[5:0],
        part_4_plus_part_4_sum[6:0], part_5_plus_busy[5:0]
    };
`endif
endmodule
