// The whole design is one file, named after its top.
/* verilator lint_off DECLFILENAME */

// Surface-splat renderer on AXI.
module splat_axi (
    input  wire clk,
    input  wire rst,
    input  wire s_axil_awvalid,
    output wire s_axil_awready,
    input  wire [11:0] s_axil_awaddr,
    input  wire s_axil_wvalid,
    output wire s_axil_wready,
    input  wire [31:0] s_axil_wdata,
    input  wire [3:0] s_axil_wstrb,
    output wire s_axil_bvalid,
    input  wire s_axil_bready,
    output wire [1:0] s_axil_bresp,
    input  wire s_axil_arvalid,
    output wire s_axil_arready,
    input  wire [11:0] s_axil_araddr,
    output wire s_axil_rvalid,
    input  wire s_axil_rready,
    output wire [31:0] s_axil_rdata,
    output wire [1:0] s_axil_rresp,
    input  wire s_axis_splat_tvalid,
    output wire s_axis_splat_tready,
    input  wire [63:0] s_axis_splat_tdata,
    input  wire s_axis_splat_tlast,
    output wire m_axis_fragment_tvalid,
    input  wire m_axis_fragment_tready,
    output wire [63:0] m_axis_fragment_tdata,
    output wire m_axis_fragment_tlast,
    output wire m_axi_arvalid,
    input  wire m_axi_arready,
    output wire [3:0] m_axi_arid,
    output wire [31:0] m_axi_araddr,
    output wire [7:0] m_axi_arlen,
    output wire [2:0] m_axi_arsize,
    output wire [1:0] m_axi_arburst,
    input  wire m_axi_rvalid,
    output wire m_axi_rready,
    input  wire [3:0] m_axi_rid,
    input  wire [63:0] m_axi_rdata,
    input  wire [1:0] m_axi_rresp,
    input  wire m_axi_rlast,
    output wire m_axi_awvalid,
    input  wire m_axi_awready,
    output wire [3:0] m_axi_awid,
    output wire [31:0] m_axi_awaddr,
    output wire [7:0] m_axi_awlen,
    output wire [2:0] m_axi_awsize,
    output wire [1:0] m_axi_awburst,
    output wire m_axi_wvalid,
    input  wire m_axi_wready,
    output wire [63:0] m_axi_wdata,
    output wire [7:0] m_axi_wstrb,
    output wire m_axi_wlast,
    input  wire m_axi_bvalid,
    output wire m_axi_bready,
    input  wire [3:0] m_axi_bid,
    input  wire [1:0] m_axi_bresp,
    output wire irq
);
    reg has_ended;

    wire core_splat_ready, core_read_valid;
    wire [11:0] core_read_tile;
    wire core_data_ready, core_write_valid;
    wire [11:0] core_write_tile;
    wire [5:0] core_write_pixel;
    wire [27:0] core_write_weight;
    wire [51:0] core_write_depth;
    wire [15:0] core_write_peak, core_write_attribute_0, core_write_attribute_1, core_write_attribute_2;
    wire [15:0] core_write_attribute_3, core_write_attribute_4, core_write_attribute_5, core_write_attribute_6;
    wire [15:0] core_write_attribute_7, core_write_attribute_8, core_write_attribute_9, core_write_attribute_10;
    wire [15:0] core_write_attribute_11, core_write_attribute_12, core_write_cardinal_0;
    wire core_fragment_valid, core_fragment_end;
    wire [8:0] core_fragment_column, core_fragment_row;
    wire [23:0] core_fragment_depth;
    wire [15:0] core_fragment_attribute_0, core_fragment_attribute_1, core_fragment_attribute_2;
    wire [15:0] core_fragment_attribute_3, core_fragment_attribute_4, core_fragment_attribute_5;
    wire [15:0] core_fragment_attribute_6, core_fragment_attribute_7, core_fragment_attribute_8;
    wire [15:0] core_fragment_attribute_9, core_fragment_attribute_10, core_fragment_attribute_11;
    wire [15:0] core_fragment_attribute_12, core_fragment_cardinal_0;
    wire core_event_sample, core_event_starved, core_event_blocked, core_event_accumulate, core_event_hazard;
    wire core_event_slot_wait, registers_s_axil_awready, registers_s_axil_wready, registers_s_axil_bvalid;
    wire [1:0] registers_s_axil_bresp;
    wire registers_busy, registers_start, registers_core_reset, registers_uniform_valid;
    wire [4:0] registers_uniform_address;
    wire [23:0] registers_uniform_data;
    wire registers_s_axil_arready, registers_s_axil_rvalid;
    wire [31:0] registers_s_axil_rdata;
    wire [1:0] registers_s_axil_rresp;
    wire registers_irq;
    wire [31:0] registers_buffer_base;
    wire splats_s_axis_tready, splats_out_valid, splats_out_end;
    wire [23:0] splats_out_center_x, splats_out_center_y, splats_out_center_z, splats_out_tangent1_x;
    wire [23:0] splats_out_tangent1_y, splats_out_tangent1_z, splats_out_tangent2_x, splats_out_tangent2_y;
    wire [23:0] splats_out_tangent2_z;
    wire [15:0] splats_out_attribute_0, splats_out_attribute_1, splats_out_attribute_2, splats_out_attribute_3;
    wire [15:0] splats_out_attribute_4, splats_out_attribute_5, splats_out_attribute_6, splats_out_attribute_7;
    wire [15:0] splats_out_attribute_8, splats_out_attribute_9, splats_out_attribute_10, splats_out_attribute_11;
    wire [15:0] splats_out_attribute_12, splats_out_cardinal_0;
    wire splats_taken, splats_refused, fragments_in_ready, fragments_m_axis_tvalid;
    wire [63:0] fragments_m_axis_tdata;
    wire fragments_m_axis_tlast, fragments_sent, fragments_idle, reads_request_ready, reads_m_axi_arvalid;
    wire [3:0] reads_m_axi_arid;
    wire [31:0] reads_m_axi_araddr;
    wire [7:0] reads_m_axi_arlen;
    wire [2:0] reads_m_axi_arsize;
    wire [1:0] reads_m_axi_arburst;
    wire reads_m_axi_rready, reads_record_valid;
    wire [27:0] reads_record_weight;
    wire [51:0] reads_record_depth;
    wire [15:0] reads_record_peak, reads_record_attribute_0, reads_record_attribute_1, reads_record_attribute_2;
    wire [15:0] reads_record_attribute_3, reads_record_attribute_4, reads_record_attribute_5;
    wire [15:0] reads_record_attribute_6, reads_record_attribute_7, reads_record_attribute_8;
    wire [15:0] reads_record_attribute_9, reads_record_attribute_10, reads_record_attribute_11;
    wire [15:0] reads_record_attribute_12, reads_record_cardinal_0;
    wire reads_error, reads_misplaced, writes_in_ready, writes_m_axi_awvalid;
    wire [3:0] writes_m_axi_awid;
    wire [31:0] writes_m_axi_awaddr;
    wire [7:0] writes_m_axi_awlen;
    wire [2:0] writes_m_axi_awsize;
    wire [1:0] writes_m_axi_awburst;
    wire writes_m_axi_wvalid;
    wire [63:0] writes_m_axi_wdata;
    wire [7:0] writes_m_axi_wstrb;
    wire writes_m_axi_wlast, writes_m_axi_bready, writes_error, writes_idle;

    wire core_read_ready = reads_request_ready & writes_idle;
    wire no_read = ~core_read_valid;
    wire core_write_ready = writes_in_ready & no_read;
    wire term_1 = has_ended & ~registers_start;
    wire [31:0] tile_address = registers_buffer_base + {8'd0, core_read_tile, 12'd0};
    wire [31:0] pixel_address = registers_buffer_base + {8'd0, core_write_tile, core_write_pixel, 6'd0};
    wire is_last = core_fragment_valid & fragments_in_ready & core_fragment_end;

    assign s_axil_awready = registers_s_axil_awready;
    assign s_axil_wready = registers_s_axil_wready;
    assign s_axil_bvalid = registers_s_axil_bvalid;
    assign s_axil_bresp = registers_s_axil_bresp;
    assign s_axil_arready = registers_s_axil_arready;
    assign s_axil_rvalid = registers_s_axil_rvalid;
    assign s_axil_rdata = registers_s_axil_rdata;
    assign s_axil_rresp = registers_s_axil_rresp;
    assign s_axis_splat_tready = splats_s_axis_tready;
    assign m_axis_fragment_tvalid = fragments_m_axis_tvalid;
    assign m_axis_fragment_tdata = fragments_m_axis_tdata;
    assign m_axis_fragment_tlast = fragments_m_axis_tlast;
    assign m_axi_arvalid = reads_m_axi_arvalid;
    assign m_axi_arid = reads_m_axi_arid;
    assign m_axi_araddr = reads_m_axi_araddr;
    assign m_axi_arlen = reads_m_axi_arlen;
    assign m_axi_arsize = reads_m_axi_arsize;
    assign m_axi_arburst = reads_m_axi_arburst;
    assign m_axi_rready = reads_m_axi_rready;
    assign m_axi_awvalid = writes_m_axi_awvalid;
    assign m_axi_awid = writes_m_axi_awid;
    assign m_axi_awaddr = writes_m_axi_awaddr;
    assign m_axi_awlen = writes_m_axi_awlen;
    assign m_axi_awsize = writes_m_axi_awsize;
    assign m_axi_awburst = writes_m_axi_awburst;
    assign m_axi_wvalid = writes_m_axi_wvalid;
    assign m_axi_wdata = writes_m_axi_wdata;
    assign m_axi_wstrb = writes_m_axi_wstrb;
    assign m_axi_wlast = writes_m_axi_wlast;
    assign m_axi_bready = writes_m_axi_bready;
    assign irq = registers_irq;

    splat_top core (
        .clk(clk), .rst(rst | registers_core_reset),
        .uniform_valid(registers_uniform_valid), .uniform_address(registers_uniform_address),
        .uniform_data(registers_uniform_data),
        .splat_valid(splats_out_valid), .splat_ready(core_splat_ready), .splat_end(splats_out_end),
        .splat_center_x(splats_out_center_x), .splat_center_y(splats_out_center_y),
        .splat_center_z(splats_out_center_z), .splat_tangent1_x(splats_out_tangent1_x),
        .splat_tangent1_y(splats_out_tangent1_y), .splat_tangent1_z(splats_out_tangent1_z),
        .splat_tangent2_x(splats_out_tangent2_x), .splat_tangent2_y(splats_out_tangent2_y),
        .splat_tangent2_z(splats_out_tangent2_z), .splat_attribute_0(splats_out_attribute_0),
        .splat_attribute_1(splats_out_attribute_1), .splat_attribute_2(splats_out_attribute_2),
        .splat_attribute_3(splats_out_attribute_3), .splat_attribute_4(splats_out_attribute_4),
        .splat_attribute_5(splats_out_attribute_5), .splat_attribute_6(splats_out_attribute_6),
        .splat_attribute_7(splats_out_attribute_7), .splat_attribute_8(splats_out_attribute_8),
        .splat_attribute_9(splats_out_attribute_9), .splat_attribute_10(splats_out_attribute_10),
        .splat_attribute_11(splats_out_attribute_11), .splat_attribute_12(splats_out_attribute_12),
        .splat_cardinal_0(splats_out_cardinal_0),
        .read_valid(core_read_valid), .read_ready(core_read_ready), .read_tile(core_read_tile),
        .data_valid(reads_record_valid), .data_ready(core_data_ready), .data_weight(reads_record_weight),
        .data_depth(reads_record_depth), .data_peak(reads_record_peak),
        .data_attribute_0(reads_record_attribute_0), .data_attribute_1(reads_record_attribute_1),
        .data_attribute_2(reads_record_attribute_2), .data_attribute_3(reads_record_attribute_3),
        .data_attribute_4(reads_record_attribute_4), .data_attribute_5(reads_record_attribute_5),
        .data_attribute_6(reads_record_attribute_6), .data_attribute_7(reads_record_attribute_7),
        .data_attribute_8(reads_record_attribute_8), .data_attribute_9(reads_record_attribute_9),
        .data_attribute_10(reads_record_attribute_10), .data_attribute_11(reads_record_attribute_11),
        .data_attribute_12(reads_record_attribute_12), .data_cardinal_0(reads_record_cardinal_0),
        .write_valid(core_write_valid), .write_ready(core_write_ready), .write_tile(core_write_tile),
        .write_pixel(core_write_pixel), .write_weight(core_write_weight), .write_depth(core_write_depth),
        .write_peak(core_write_peak), .write_attribute_0(core_write_attribute_0),
        .write_attribute_1(core_write_attribute_1), .write_attribute_2(core_write_attribute_2),
        .write_attribute_3(core_write_attribute_3), .write_attribute_4(core_write_attribute_4),
        .write_attribute_5(core_write_attribute_5), .write_attribute_6(core_write_attribute_6),
        .write_attribute_7(core_write_attribute_7), .write_attribute_8(core_write_attribute_8),
        .write_attribute_9(core_write_attribute_9), .write_attribute_10(core_write_attribute_10),
        .write_attribute_11(core_write_attribute_11), .write_attribute_12(core_write_attribute_12),
        .write_cardinal_0(core_write_cardinal_0),
        .fragment_valid(core_fragment_valid), .fragment_ready(fragments_in_ready),
        .fragment_end(core_fragment_end), .fragment_column(core_fragment_column),
        .fragment_row(core_fragment_row), .fragment_depth(core_fragment_depth),
        .fragment_attribute_0(core_fragment_attribute_0), .fragment_attribute_1(core_fragment_attribute_1),
        .fragment_attribute_2(core_fragment_attribute_2), .fragment_attribute_3(core_fragment_attribute_3),
        .fragment_attribute_4(core_fragment_attribute_4), .fragment_attribute_5(core_fragment_attribute_5),
        .fragment_attribute_6(core_fragment_attribute_6), .fragment_attribute_7(core_fragment_attribute_7),
        .fragment_attribute_8(core_fragment_attribute_8), .fragment_attribute_9(core_fragment_attribute_9),
        .fragment_attribute_10(core_fragment_attribute_10),
        .fragment_attribute_11(core_fragment_attribute_11),
        .fragment_attribute_12(core_fragment_attribute_12), .fragment_cardinal_0(core_fragment_cardinal_0),
        .event_sample(core_event_sample), .event_starved(core_event_starved),
        .event_blocked(core_event_blocked), .event_accumulate(core_event_accumulate),
        .event_hazard(core_event_hazard), .event_slot_wait(core_event_slot_wait)
    );

    bus_registers registers (
        .clk(clk), .rst(rst),
        .s_axil_awvalid(s_axil_awvalid), .s_axil_awready(registers_s_axil_awready),
        .s_axil_awaddr(s_axil_awaddr), .s_axil_wvalid(s_axil_wvalid), .s_axil_wready(registers_s_axil_wready),
        .s_axil_wdata(s_axil_wdata), .s_axil_wstrb(s_axil_wstrb), .s_axil_bvalid(registers_s_axil_bvalid),
        .s_axil_bready(s_axil_bready), .s_axil_bresp(registers_s_axil_bresp),
        .finished(term_1 & (fragments_idle & writes_idle)), .occupied(1'd0), .busy(registers_busy),
        .start(registers_start),
        .core_reset(registers_core_reset),
        .uniform_valid(registers_uniform_valid), .uniform_address(registers_uniform_address),
        .uniform_data(registers_uniform_data),
        .burst_error(reads_misplaced),
        .packet_error(splats_refused),
        .memory_error({writes_error, reads_error}),
        .packet_taken(splats_taken), .packet_sent(fragments_sent),
        .event_sample(core_event_sample), .event_starved(core_event_starved),
        .event_blocked(core_event_blocked), .event_accumulate(core_event_accumulate),
        .event_hazard(core_event_hazard), .event_slot_wait(core_event_slot_wait),
        .s_axil_arvalid(s_axil_arvalid), .s_axil_arready(registers_s_axil_arready),
        .s_axil_araddr(s_axil_araddr), .s_axil_rvalid(registers_s_axil_rvalid), .s_axil_rready(s_axil_rready),
        .s_axil_rdata(registers_s_axil_rdata), .s_axil_rresp(registers_s_axil_rresp),
        .irq(registers_irq),
        .buffer_base(registers_buffer_base)
    );

    bus_packet_in splats (
        .clk(clk), .rst(rst), .opens(registers_start),
        .s_axis_tvalid(s_axis_splat_tvalid), .s_axis_tready(splats_s_axis_tready),
        .s_axis_tdata(s_axis_splat_tdata), .s_axis_tlast(s_axis_splat_tlast),
        .out_valid(splats_out_valid), .out_ready(core_splat_ready), .out_end(splats_out_end),
        .out_center_x(splats_out_center_x), .out_center_y(splats_out_center_y),
        .out_center_z(splats_out_center_z), .out_tangent1_x(splats_out_tangent1_x),
        .out_tangent1_y(splats_out_tangent1_y), .out_tangent1_z(splats_out_tangent1_z),
        .out_tangent2_x(splats_out_tangent2_x), .out_tangent2_y(splats_out_tangent2_y),
        .out_tangent2_z(splats_out_tangent2_z), .out_attribute_0(splats_out_attribute_0),
        .out_attribute_1(splats_out_attribute_1), .out_attribute_2(splats_out_attribute_2),
        .out_attribute_3(splats_out_attribute_3), .out_attribute_4(splats_out_attribute_4),
        .out_attribute_5(splats_out_attribute_5), .out_attribute_6(splats_out_attribute_6),
        .out_attribute_7(splats_out_attribute_7), .out_attribute_8(splats_out_attribute_8),
        .out_attribute_9(splats_out_attribute_9), .out_attribute_10(splats_out_attribute_10),
        .out_attribute_11(splats_out_attribute_11), .out_attribute_12(splats_out_attribute_12),
        .out_cardinal_0(splats_out_cardinal_0),
        .taken(splats_taken), .refused(splats_refused)
    );

    bus_packet_out fragments (
        .clk(clk), .rst(rst),
        .in_valid(core_fragment_valid), .in_ready(fragments_in_ready), .in_end(core_fragment_end),
        .in_column(core_fragment_column), .in_row(core_fragment_row), .in_depth(core_fragment_depth),
        .in_attribute_0(core_fragment_attribute_0), .in_attribute_1(core_fragment_attribute_1),
        .in_attribute_2(core_fragment_attribute_2), .in_attribute_3(core_fragment_attribute_3),
        .in_attribute_4(core_fragment_attribute_4), .in_attribute_5(core_fragment_attribute_5),
        .in_attribute_6(core_fragment_attribute_6), .in_attribute_7(core_fragment_attribute_7),
        .in_attribute_8(core_fragment_attribute_8), .in_attribute_9(core_fragment_attribute_9),
        .in_attribute_10(core_fragment_attribute_10), .in_attribute_11(core_fragment_attribute_11),
        .in_attribute_12(core_fragment_attribute_12), .in_cardinal_0(core_fragment_cardinal_0),
        .m_axis_tvalid(fragments_m_axis_tvalid), .m_axis_tready(m_axis_fragment_tready),
        .m_axis_tdata(fragments_m_axis_tdata), .m_axis_tlast(fragments_m_axis_tlast),
        .sent(fragments_sent), .idle(fragments_idle)
    );

    bus_reader reads (
        .clk(clk), .rst(rst),
        .request_valid(core_read_valid & writes_idle), .request_ready(reads_request_ready),
        .request_address(tile_address), .request_records(7'd64),
        .m_axi_arvalid(reads_m_axi_arvalid), .m_axi_arready(m_axi_arready), .m_axi_arid(reads_m_axi_arid),
        .m_axi_araddr(reads_m_axi_araddr), .m_axi_arlen(reads_m_axi_arlen), .m_axi_arsize(reads_m_axi_arsize),
        .m_axi_arburst(reads_m_axi_arburst), .m_axi_rvalid(m_axi_rvalid), .m_axi_rready(reads_m_axi_rready),
        .m_axi_rid(m_axi_rid), .m_axi_rdata(m_axi_rdata), .m_axi_rresp(m_axi_rresp),
        .m_axi_rlast(m_axi_rlast),
        .record_valid(reads_record_valid), .record_ready(core_data_ready),
        .record_weight(reads_record_weight), .record_depth(reads_record_depth),
        .record_peak(reads_record_peak), .record_attribute_0(reads_record_attribute_0),
        .record_attribute_1(reads_record_attribute_1), .record_attribute_2(reads_record_attribute_2),
        .record_attribute_3(reads_record_attribute_3), .record_attribute_4(reads_record_attribute_4),
        .record_attribute_5(reads_record_attribute_5), .record_attribute_6(reads_record_attribute_6),
        .record_attribute_7(reads_record_attribute_7), .record_attribute_8(reads_record_attribute_8),
        .record_attribute_9(reads_record_attribute_9), .record_attribute_10(reads_record_attribute_10),
        .record_attribute_11(reads_record_attribute_11), .record_attribute_12(reads_record_attribute_12),
        .record_cardinal_0(reads_record_cardinal_0),
        .error(reads_error), .misplaced(reads_misplaced)
    );

    bus_writer writes (
        .clk(clk), .rst(rst),
        .in_valid(core_write_valid & no_read), .in_ready(writes_in_ready), .in_address(pixel_address),
        .in_weight(core_write_weight), .in_depth(core_write_depth), .in_peak(core_write_peak),
        .in_attribute_0(core_write_attribute_0), .in_attribute_1(core_write_attribute_1),
        .in_attribute_2(core_write_attribute_2), .in_attribute_3(core_write_attribute_3),
        .in_attribute_4(core_write_attribute_4), .in_attribute_5(core_write_attribute_5),
        .in_attribute_6(core_write_attribute_6), .in_attribute_7(core_write_attribute_7),
        .in_attribute_8(core_write_attribute_8), .in_attribute_9(core_write_attribute_9),
        .in_attribute_10(core_write_attribute_10), .in_attribute_11(core_write_attribute_11),
        .in_attribute_12(core_write_attribute_12), .in_cardinal_0(core_write_cardinal_0),
        .m_axi_awvalid(writes_m_axi_awvalid), .m_axi_awready(m_axi_awready), .m_axi_awid(writes_m_axi_awid),
        .m_axi_awaddr(writes_m_axi_awaddr), .m_axi_awlen(writes_m_axi_awlen),
        .m_axi_awsize(writes_m_axi_awsize), .m_axi_awburst(writes_m_axi_awburst),
        .m_axi_wvalid(writes_m_axi_wvalid), .m_axi_wready(m_axi_wready), .m_axi_wdata(writes_m_axi_wdata),
        .m_axi_wstrb(writes_m_axi_wstrb), .m_axi_wlast(writes_m_axi_wlast), .m_axi_bvalid(m_axi_bvalid),
        .m_axi_bready(writes_m_axi_bready), .m_axi_bid(m_axi_bid), .m_axi_bresp(m_axi_bresp),
        .error(writes_error), .idle(writes_idle)
    );

    always @(posedge clk) begin
        if (rst) begin
            has_ended <= 1'd0;
        end else begin
            has_ended <= is_last | term_1;
        end
    end

    wire _unused = &{1'b0, registers_busy};
endmodule

// Writes records to memory, each in a burst.
// beats = 8
// width = 64
module bus_writer (
    input  wire clk,
    input  wire rst,
    input  wire in_valid,
    output wire in_ready,
    input  wire [31:0] in_address,
    input  wire [27:0] in_weight,
    input  wire [51:0] in_depth,
    input  wire [15:0] in_peak,
    input  wire [15:0] in_attribute_0,
    input  wire [15:0] in_attribute_1,
    input  wire [15:0] in_attribute_2,
    input  wire [15:0] in_attribute_3,
    input  wire [15:0] in_attribute_4,
    input  wire [15:0] in_attribute_5,
    input  wire [15:0] in_attribute_6,
    input  wire [15:0] in_attribute_7,
    input  wire [15:0] in_attribute_8,
    input  wire [15:0] in_attribute_9,
    input  wire [15:0] in_attribute_10,
    input  wire [15:0] in_attribute_11,
    input  wire [15:0] in_attribute_12,
    input  wire [15:0] in_cardinal_0,
    output wire m_axi_awvalid,
    input  wire m_axi_awready,
    output wire [3:0] m_axi_awid,
    output wire [31:0] m_axi_awaddr,
    output wire [7:0] m_axi_awlen,
    output wire [2:0] m_axi_awsize,
    output wire [1:0] m_axi_awburst,
    output wire m_axi_wvalid,
    input  wire m_axi_wready,
    output wire [63:0] m_axi_wdata,
    output wire [7:0] m_axi_wstrb,
    output wire m_axi_wlast,
    input  wire m_axi_bvalid,
    output wire m_axi_bready,
    input  wire [3:0] m_axi_bid,
    input  wire [1:0] m_axi_bresp,
    output reg  error,
    output wire idle
);
    reg [4:0] unanswered;
    reg held;
    reg [2:0] place;
    reg [27:0] held_weight;
    reg [51:0] held_depth;
    reg [15:0] held_peak, held_attribute_0, held_attribute_1, held_attribute_2, held_attribute_3, held_attribute_4;
    reg [15:0] held_attribute_5, held_attribute_6, held_attribute_7, held_attribute_8, held_attribute_9;
    reg [15:0] held_attribute_10, held_attribute_11, held_attribute_12, held_cardinal_0;

    wire address_queue_in_ready, address_queue_out_valid;
    wire [33:0] address_queue_out_data;
    wire beat_queue_in_ready, beat_queue_out_valid;
    wire [64:0] beat_queue_out_data;

    wire moves = held & beat_queue_in_ready;
    wire at_end = place == 3'd7;
    wire leaves = moves & at_end;
    wire below_limit = ~(unanswered == 5'd16);
    wire accepts = address_queue_in_ready & below_limit;
    wire takes_record = (~held | leaves) & accepts;
    wire [25:0] address_queue_out_address = address_queue_out_data[33:8];
    wire takes = in_valid & takes_record;
    wire accepted = takes;
    wire [63:0] joined_1 = {16'd0, held_cardinal_0, held_attribute_12, held_attribute_11};
    wire [63:0] joined_2 = {held_attribute_10, held_attribute_9, held_attribute_8, held_attribute_7};
    wire [63:0] choice_3 = place[1] ? (place[0] ? 64'd0 : 64'd0) : place[0] ? joined_1 : joined_2;
    wire [63:0] joined_4 = {held_attribute_6, held_attribute_5, held_attribute_4, held_attribute_3};
    wire [63:0] joined_5 = {held_attribute_2, held_attribute_1, held_attribute_0, held_peak};
    wire [63:0] choice_6 = place[1] ? (place[0] ? joined_4 : joined_5) : place[0] ? {12'd0, held_depth} : {36'd0, held_weight};

    assign in_ready = takes_record;
    assign m_axi_awvalid = address_queue_out_valid;
    assign m_axi_awid = 4'd0;
    assign m_axi_awaddr = {address_queue_out_address, 6'd0};
    assign m_axi_awlen = address_queue_out_data[7:0];
    assign m_axi_awsize = 3'd3;
    assign m_axi_awburst = 2'd1;
    assign m_axi_wvalid = beat_queue_out_valid;
    assign m_axi_wdata = beat_queue_out_data[64:1];
    assign m_axi_wstrb = 8'd255;
    assign m_axi_wlast = beat_queue_out_data[0];
    assign m_axi_bready = 1'd1;
    assign idle = unanswered == 5'd0;

    stream_skid_w34 address_queue (
        .clk(clk), .rst(rst),
        .in_valid(accepted), .in_ready(address_queue_in_ready), .in_data({in_address[31:6], 8'd7}),
        .out_valid(address_queue_out_valid), .out_ready(m_axi_awready), .out_data(address_queue_out_data)
    );

    stream_skid_w65 beat_queue (
        .clk(clk), .rst(rst),
        .in_valid(held), .in_ready(beat_queue_in_ready), .in_data({place[2] ? choice_3 : choice_6, at_end}),
        .out_valid(beat_queue_out_valid), .out_ready(m_axi_wready), .out_data(beat_queue_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            unanswered <= 5'd0;
            held <= 1'd0;
            place <= 3'd0;
            error <= 1'd0;
        end else begin
            unanswered <= (unanswered + {4'd0, accepted}) - {4'd0, m_axi_bvalid};
            held <= takes | (held & ~leaves);
            error <= m_axi_bvalid & |m_axi_bresp;
            if (moves) place <= at_end ? 3'd0 : (place + 3'd1);
        end
    end
    always @(posedge clk) begin
        if (takes) begin
            held_weight <= in_weight;
            held_depth <= in_depth;
            held_peak <= in_peak;
            held_attribute_0 <= in_attribute_0;
            held_attribute_1 <= in_attribute_1;
            held_attribute_2 <= in_attribute_2;
            held_attribute_3 <= in_attribute_3;
            held_attribute_4 <= in_attribute_4;
            held_attribute_5 <= in_attribute_5;
            held_attribute_6 <= in_attribute_6;
            held_attribute_7 <= in_attribute_7;
            held_attribute_8 <= in_attribute_8;
            held_attribute_9 <= in_attribute_9;
            held_attribute_10 <= in_attribute_10;
            held_attribute_11 <= in_attribute_11;
            held_attribute_12 <= in_attribute_12;
            held_cardinal_0 <= in_cardinal_0;
        end
    end

    wire _unused = &{1'b0, in_address[5:0], m_axi_bid};
endmodule

// Reads records from memory in bursts.
// beats = 8
// width = 64
// records = 64
module bus_reader (
    input  wire clk,
    input  wire rst,
    input  wire request_valid,  // Records wanted.
    output wire request_ready,
    input  wire [31:0] request_address,  // Where the first one lies.
    input  wire [6:0] request_records,  // How many.
    output wire m_axi_arvalid,
    input  wire m_axi_arready,
    output wire [3:0] m_axi_arid,
    output wire [31:0] m_axi_araddr,
    output wire [7:0] m_axi_arlen,
    output wire [2:0] m_axi_arsize,
    output wire [1:0] m_axi_arburst,
    input  wire m_axi_rvalid,
    output wire m_axi_rready,
    input  wire [3:0] m_axi_rid,
    input  wire [63:0] m_axi_rdata,
    input  wire [1:0] m_axi_rresp,
    input  wire m_axi_rlast,
    output reg  record_valid,
    input  wire record_ready,
    output wire [27:0] record_weight,
    output wire [51:0] record_depth,
    output wire [15:0] record_peak,
    output wire [15:0] record_attribute_0,
    output wire [15:0] record_attribute_1,
    output wire [15:0] record_attribute_2,
    output wire [15:0] record_attribute_3,
    output wire [15:0] record_attribute_4,
    output wire [15:0] record_attribute_5,
    output wire [15:0] record_attribute_6,
    output wire [15:0] record_attribute_7,
    output wire [15:0] record_attribute_8,
    output wire [15:0] record_attribute_9,
    output wire [15:0] record_attribute_10,
    output wire [15:0] record_attribute_11,
    output wire [15:0] record_attribute_12,
    output wire [15:0] record_cardinal_0,
    output reg  error,
    output reg  misplaced
);
    reg held;
    reg [25:0] address;
    reg [6:0] records;
    reg [7:0] number;
    reg [27:0] held_weight_0;
    reg [51:0] held_depth_0;
    reg [15:0] held_peak_0, held_attribute_0_0, held_attribute_1_0, held_attribute_2_0, held_attribute_3_0;
    reg [15:0] held_attribute_4_0, held_attribute_5_0, held_attribute_6_0, held_attribute_7_0, held_attribute_8_0;
    reg [15:0] held_attribute_9_0, held_attribute_10_0, held_attribute_11_0, held_attribute_12_0, held_cardinal_0_0;
    reg is_wrong;

    wire address_queue_in_ready, address_queue_out_valid;
    wire [33:0] address_queue_out_data;
    wire length_queue_in_ready, length_queue_out_valid;
    wire [7:0] length_queue_out_data;
    wire beat_queue_in_ready, beat_queue_out_valid;
    wire [64:0] beat_queue_out_data;

    wire issues = held & (address_queue_in_ready & length_queue_in_ready);
    wire [6:0] room_records = 7'd32 - {2'd0, address[4:0]};
    wire crosses = room_records < records;
    wire takes_request = ~held | (issues & ~crosses);
    wire [25:0] address_queue_out_address = address_queue_out_data[33:8];
    wire [6:0] burst = crosses ? room_records : records;
    wire [8:0] difference_1 = {burst[5:0], 3'd0} - 9'd1;
    wire [7:0] length = difference_1[7:0];
    wire advance = ~record_valid | record_ready;
    wire beat_queue_out_ready = advance & length_queue_out_valid;
    wire moves = beat_queue_out_valid & beat_queue_out_ready;
    wire ends = number == length_queue_out_data;
    wire length_queue_out_ready = moves & ends;
    wire term_2 = takes_request | issues;
    wire takes_beat_0 = moves & (number[2:0] == 3'd0);
    wire takes_beat_1 = moves & (number[2:0] == 3'd1);
    wire takes_beat_2 = moves & (number[2:0] == 3'd2);
    wire takes_beat_3 = moves & (number[2:0] == 3'd3);
    wire takes_beat_4 = moves & (number[2:0] == 3'd4);
    wire takes_beat_5 = moves & (number[2:0] == 3'd5);
    wire beat_queue_out_last = beat_queue_out_data[0];
    wire term_3 = is_wrong | (beat_queue_out_last ^ ends);

    assign request_ready = takes_request;
    assign m_axi_arvalid = address_queue_out_valid;
    assign m_axi_arid = 4'd0;
    assign m_axi_araddr = {address_queue_out_address, 6'd0};
    assign m_axi_arlen = address_queue_out_data[7:0];
    assign m_axi_arsize = 3'd3;
    assign m_axi_arburst = 2'd1;
    assign m_axi_rready = beat_queue_in_ready;
    assign record_weight = held_weight_0;
    assign record_depth = held_depth_0;
    assign record_peak = held_peak_0;
    assign record_attribute_0 = held_attribute_0_0;
    assign record_attribute_1 = held_attribute_1_0;
    assign record_attribute_2 = held_attribute_2_0;
    assign record_attribute_3 = held_attribute_3_0;
    assign record_attribute_4 = held_attribute_4_0;
    assign record_attribute_5 = held_attribute_5_0;
    assign record_attribute_6 = held_attribute_6_0;
    assign record_attribute_7 = held_attribute_7_0;
    assign record_attribute_8 = held_attribute_8_0;
    assign record_attribute_9 = held_attribute_9_0;
    assign record_attribute_10 = held_attribute_10_0;
    assign record_attribute_11 = held_attribute_11_0;
    assign record_attribute_12 = held_attribute_12_0;
    assign record_cardinal_0 = held_cardinal_0_0;

    stream_skid_w34 address_queue (
        .clk(clk), .rst(rst),
        .in_valid(issues), .in_ready(address_queue_in_ready), .in_data({address, length}),
        .out_valid(address_queue_out_valid), .out_ready(m_axi_arready), .out_data(address_queue_out_data)
    );

    stream_fifo_d16_w8 length_queue (
        .clk(clk), .rst(rst),
        .in_valid(issues), .in_ready(length_queue_in_ready), .in_data(length),
        .out_valid(length_queue_out_valid), .out_ready(length_queue_out_ready),
        .out_data(length_queue_out_data)
    );

    stream_skid_w65 beat_queue (
        .clk(clk), .rst(rst),
        .in_valid(m_axi_rvalid), .in_ready(beat_queue_in_ready), .in_data({m_axi_rdata, m_axi_rlast}),
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
            if (advance) record_valid <= moves & (number[2:0] == 3'd7);
            if (moves) begin
                number <= ends ? 8'd0 : (number + 8'd1);
                is_wrong <= ~ends & term_3;
            end
            error <= m_axi_rvalid & beat_queue_in_ready & |m_axi_rresp;
            misplaced <= moves & (ends & term_3);
        end
    end
    always @(posedge clk) begin
        if (term_2) begin
            address <= takes_request ? request_address[31:6] : {address[25:5] + 21'd1, 5'd0};
            records <= takes_request ? request_records : (records - room_records);
        end
        if (takes_beat_0) held_weight_0 <= beat_queue_out_data[28:1];
        if (takes_beat_1) held_depth_0 <= beat_queue_out_data[52:1];
        if (takes_beat_2) begin
            held_peak_0 <= beat_queue_out_data[16:1];
            held_attribute_0_0 <= beat_queue_out_data[32:17];
            held_attribute_1_0 <= beat_queue_out_data[48:33];
            held_attribute_2_0 <= beat_queue_out_data[64:49];
        end
        if (takes_beat_3) begin
            held_attribute_3_0 <= beat_queue_out_data[16:1];
            held_attribute_4_0 <= beat_queue_out_data[32:17];
            held_attribute_5_0 <= beat_queue_out_data[48:33];
            held_attribute_6_0 <= beat_queue_out_data[64:49];
        end
        if (takes_beat_4) begin
            held_attribute_7_0 <= beat_queue_out_data[16:1];
            held_attribute_8_0 <= beat_queue_out_data[32:17];
            held_attribute_9_0 <= beat_queue_out_data[48:33];
            held_attribute_10_0 <= beat_queue_out_data[64:49];
        end
        if (takes_beat_5) begin
            held_attribute_11_0 <= beat_queue_out_data[16:1];
            held_attribute_12_0 <= beat_queue_out_data[32:17];
            held_cardinal_0_0 <= beat_queue_out_data[48:33];
        end
    end

    wire _unused = &{1'b0, burst[6], difference_1[8], m_axi_rid, request_address[5:0]};
endmodule

// Queue in a memory with a registered output.
// depth = 16
// width = 8
module stream_fifo_d16_w8 (
    input  wire clk,
    input  wire rst,
    input  wire in_valid,
    output wire in_ready,
    input  wire [7:0] in_data,
    output reg  out_valid,
    input  wire out_ready,
    output wire [7:0] out_data
);
    reg [4:0] held, waiting;
    reg [3:0] write_address, read_address;
    wire [7:0] item;

    wire has_room = ~held[4];
    wire push = in_valid & has_room;
    wire fetch = |waiting & (~out_valid | out_ready);
    wire pop = out_valid & out_ready;

    assign in_ready = has_room;
    assign out_data = item;

    memory_1w1r_unordered #(.WIDTH(8), .DEPTH(16)) entries (
        .clk(clk),
        .write(push), .write_address(write_address), .write_data(in_data),
        .read(fetch), .read_address(read_address), .read_data(item)
    );

    always @(posedge clk) begin
        if (rst) begin
            held <= 5'd0;
            waiting <= 5'd0;
            write_address <= 4'd0;
            read_address <= 4'd0;
            out_valid <= 1'd0;
        end else begin
            held <= (held + {4'd0, push}) - {4'd0, pop};
            waiting <= (waiting + {4'd0, push}) - {4'd0, fetch};
            out_valid <= fetch | (out_valid & ~out_ready);
            if (push) write_address <= write_address + 4'd1;
            if (fetch) read_address <= read_address + 4'd1;
        end
    end

`ifdef RTL_ASSERT
    always @(posedge clk) begin
        if (!rst) begin
            if (!(held <= 5'd16)) begin
`ifdef FORMAL
                held_in_range: assert (0);
`else
                $display("assertion failed: held_in_range in %m");
                $stop;
`endif
            end
            if (!(held == (waiting + {4'd0, out_valid}))) begin
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

// Queue of two in registers.
// width = 34
module stream_skid_w34 (
    input  wire clk,
    input  wire rst,
    input  wire in_valid,
    output wire in_ready,
    input  wire [33:0] in_data,
    output reg  out_valid,
    input  wire out_ready,
    output wire [33:0] out_data
);
    reg second_valid;
    reg [33:0] head, second;

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

// Spreads records over the beats of packets.
// beats = 5
// width = 64
module bus_packet_out (
    input  wire clk,
    input  wire rst,
    input  wire in_valid,
    output wire in_ready,
    input  wire in_end,
    input  wire [8:0] in_column,
    input  wire [8:0] in_row,
    input  wire [23:0] in_depth,
    input  wire [15:0] in_attribute_0,
    input  wire [15:0] in_attribute_1,
    input  wire [15:0] in_attribute_2,
    input  wire [15:0] in_attribute_3,
    input  wire [15:0] in_attribute_4,
    input  wire [15:0] in_attribute_5,
    input  wire [15:0] in_attribute_6,
    input  wire [15:0] in_attribute_7,
    input  wire [15:0] in_attribute_8,
    input  wire [15:0] in_attribute_9,
    input  wire [15:0] in_attribute_10,
    input  wire [15:0] in_attribute_11,
    input  wire [15:0] in_attribute_12,
    input  wire [15:0] in_cardinal_0,
    output wire m_axis_tvalid,
    input  wire m_axis_tready,
    output wire [63:0] m_axis_tdata,
    output wire m_axis_tlast,
    output reg  sent,
    output wire idle
);
    reg held;
    reg [2:0] place;
    reg held_end;
    reg [8:0] held_column, held_row;
    reg [23:0] held_depth;
    reg [15:0] held_attribute_0, held_attribute_1, held_attribute_2, held_attribute_3, held_attribute_4;
    reg [15:0] held_attribute_5, held_attribute_6, held_attribute_7, held_attribute_8, held_attribute_9;
    reg [15:0] held_attribute_10, held_attribute_11, held_attribute_12, held_cardinal_0;

    wire beat_queue_in_ready, beat_queue_out_valid;
    wire [64:0] beat_queue_out_data;

    wire moves = held & beat_queue_in_ready;
    wire at_end = place == 3'd4;
    wire leaves = moves & at_end;
    wire takes_record = ~held | leaves;
    wire [63:0] joined_1 = {held_cardinal_0, held_attribute_12, held_attribute_11, held_attribute_10};
    wire [63:0] joined_2 = {held_attribute_9, held_attribute_8, held_attribute_7, held_attribute_6};
    wire [63:0] joined_3 = {held_attribute_5, held_attribute_4, held_attribute_3, held_attribute_2};
    wire [63:0] choice_4 = place[0] ? {held_attribute_1, held_attribute_0, 8'd0, held_depth} : {23'd0, held_row, 7'd0, held_column, 15'd0, held_end};
    wire [63:0] choice_5 = place[2] ? joined_1 : place[1] ? (place[0] ? joined_2 : joined_3) : choice_4;
    wire takes = in_valid & takes_record;
    wire beat_queue_out_last = beat_queue_out_data[0];

    assign in_ready = takes_record;
    assign m_axis_tvalid = beat_queue_out_valid;
    assign {m_axis_tdata, m_axis_tlast} = beat_queue_out_data;
    assign idle = ~held & ~beat_queue_out_valid;

    stream_skid_w65 beat_queue (
        .clk(clk), .rst(rst),
        .in_valid(held), .in_ready(beat_queue_in_ready), .in_data({choice_5, at_end}),
        .out_valid(beat_queue_out_valid), .out_ready(m_axis_tready), .out_data(beat_queue_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            held <= 1'd0;
            place <= 3'd0;
            sent <= 1'd0;
        end else begin
            held <= takes | (held & ~leaves);
            sent <= beat_queue_out_valid & m_axis_tready & beat_queue_out_last;
            if (moves) place <= at_end ? 3'd0 : (place + 3'd1);
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
            held_attribute_3 <= in_attribute_3;
            held_attribute_4 <= in_attribute_4;
            held_attribute_5 <= in_attribute_5;
            held_attribute_6 <= in_attribute_6;
            held_attribute_7 <= in_attribute_7;
            held_attribute_8 <= in_attribute_8;
            held_attribute_9 <= in_attribute_9;
            held_attribute_10 <= in_attribute_10;
            held_attribute_11 <= in_attribute_11;
            held_attribute_12 <= in_attribute_12;
            held_cardinal_0 <= in_cardinal_0;
        end
    end
endmodule

// Queue of two in registers.
// width = 65
module stream_skid_w65 (
    input  wire clk,
    input  wire rst,
    input  wire in_valid,
    output wire in_ready,
    input  wire [64:0] in_data,
    output reg  out_valid,
    input  wire out_ready,
    output wire [64:0] out_data
);
    reg second_valid;
    reg [64:0] head, second;

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

// Gathers the beats of packets into records.
// beats = 9
// width = 64
module bus_packet_in (
    input  wire clk,
    input  wire rst,
    input  wire opens,
    input  wire s_axis_tvalid,
    output wire s_axis_tready,
    input  wire [63:0] s_axis_tdata,
    input  wire s_axis_tlast,
    output reg  out_valid,
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
    output wire [15:0] out_attribute_0,
    output wire [15:0] out_attribute_1,
    output wire [15:0] out_attribute_2,
    output wire [15:0] out_attribute_3,
    output wire [15:0] out_attribute_4,
    output wire [15:0] out_attribute_5,
    output wire [15:0] out_attribute_6,
    output wire [15:0] out_attribute_7,
    output wire [15:0] out_attribute_8,
    output wire [15:0] out_attribute_9,
    output wire [15:0] out_attribute_10,
    output wire [15:0] out_attribute_11,
    output wire [15:0] out_attribute_12,
    output wire [15:0] out_cardinal_0,
    output reg  taken,
    output reg  refused
);
    reg [3:0] place;
    reg is_overlong, begun, ends, is_open, held_end_0;
    reg [23:0] held_center_x_0, held_center_y_0, held_center_z_0, held_tangent1_x_0, held_tangent1_y_0;
    reg [23:0] held_tangent1_z_0, held_tangent2_x_0, held_tangent2_y_0, held_tangent2_z_0;
    reg [15:0] held_attribute_0_0, held_attribute_1_0, held_attribute_2_0, held_attribute_3_0, held_attribute_4_0;
    reg [15:0] held_attribute_5_0, held_attribute_6_0, held_attribute_7_0, held_attribute_8_0, held_attribute_9_0;
    reg [15:0] held_attribute_10_0, held_attribute_11_0, held_attribute_12_0, held_cardinal_0_0;

    wire beat_queue_in_ready, beat_queue_out_valid;
    wire [68:0] beat_queue_out_data;

    wire s_axis_ready = beat_queue_in_ready & (begun | is_open);
    wire takes = s_axis_tvalid & s_axis_ready;
    wire term_1 = takes & ~is_overlong;
    wire term_2 = place == 4'd8;
    wire whole = takes & (s_axis_tlast & (term_2 & ~is_overlong));
    wire advance = ~out_valid | out_ready;
    wire beat_queue_out_good = beat_queue_out_data[68];
    wire moves = beat_queue_out_valid & advance;
    wire [3:0] beat_queue_out_place = beat_queue_out_data[3:0];
    wire takes_beat_0 = moves & (beat_queue_out_place == 4'd0);
    wire takes_beat_1 = moves & (beat_queue_out_place == 4'd1);
    wire takes_beat_2 = moves & (beat_queue_out_place == 4'd2);
    wire takes_beat_3 = moves & (beat_queue_out_place == 4'd3);
    wire takes_beat_4 = moves & (beat_queue_out_place == 4'd4);
    wire takes_beat_5 = moves & (beat_queue_out_place == 4'd5);
    wire takes_beat_6 = moves & (beat_queue_out_place == 4'd6);
    wire takes_beat_7 = moves & (beat_queue_out_place == 4'd7);
    wire takes_beat_8 = moves & (beat_queue_out_place == 4'd8);

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
    assign out_attribute_3 = held_attribute_3_0;
    assign out_attribute_4 = held_attribute_4_0;
    assign out_attribute_5 = held_attribute_5_0;
    assign out_attribute_6 = held_attribute_6_0;
    assign out_attribute_7 = held_attribute_7_0;
    assign out_attribute_8 = held_attribute_8_0;
    assign out_attribute_9 = held_attribute_9_0;
    assign out_attribute_10 = held_attribute_10_0;
    assign out_attribute_11 = held_attribute_11_0;
    assign out_attribute_12 = held_attribute_12_0;
    assign out_cardinal_0 = held_cardinal_0_0;

    stream_skid_w69 beat_queue (
        .clk(clk), .rst(rst),
        .in_valid(term_1), .in_ready(beat_queue_in_ready), .in_data({whole, s_axis_tdata, place}),
        .out_valid(beat_queue_out_valid), .out_ready(advance), .out_data(beat_queue_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            place <= 4'd0;
            is_overlong <= 1'd0;
            begun <= 1'd0;
            is_open <= 1'd0;
            out_valid <= 1'd0;
            taken <= 1'd0;
            refused <= 1'd0;
        end else begin
            if (term_1) place <= (s_axis_tlast | term_2) ? 4'd0 : (place + 4'd1);
            if (takes) begin
                is_overlong <= ~s_axis_tlast & (is_overlong | term_2);
                begun <= ~s_axis_tlast;
            end
            is_open <= opens | (is_open & ~(whole & ends));
            taken <= whole;
            refused <= takes & ((s_axis_tlast ^ term_2) & ~is_overlong);
            if (advance) out_valid <= beat_queue_out_valid & beat_queue_out_good;
        end
    end
    always @(posedge clk) begin
        if (takes & (place == 4'd0)) ends <= s_axis_tdata[0];
        if (takes_beat_0) begin
            held_end_0 <= beat_queue_out_data[4];
            held_center_x_0 <= beat_queue_out_data[59:36];
        end
        if (takes_beat_1) begin
            held_center_y_0 <= beat_queue_out_data[27:4];
            held_center_z_0 <= beat_queue_out_data[59:36];
        end
        if (takes_beat_2) begin
            held_tangent1_x_0 <= beat_queue_out_data[27:4];
            held_tangent1_y_0 <= beat_queue_out_data[59:36];
        end
        if (takes_beat_3) begin
            held_tangent1_z_0 <= beat_queue_out_data[27:4];
            held_tangent2_x_0 <= beat_queue_out_data[59:36];
        end
        if (takes_beat_4) begin
            held_tangent2_y_0 <= beat_queue_out_data[27:4];
            held_tangent2_z_0 <= beat_queue_out_data[59:36];
        end
        if (takes_beat_5) begin
            held_attribute_0_0 <= beat_queue_out_data[19:4];
            held_attribute_1_0 <= beat_queue_out_data[35:20];
            held_attribute_2_0 <= beat_queue_out_data[51:36];
            held_attribute_3_0 <= beat_queue_out_data[67:52];
        end
        if (takes_beat_6) begin
            held_attribute_4_0 <= beat_queue_out_data[19:4];
            held_attribute_5_0 <= beat_queue_out_data[35:20];
            held_attribute_6_0 <= beat_queue_out_data[51:36];
            held_attribute_7_0 <= beat_queue_out_data[67:52];
        end
        if (takes_beat_7) begin
            held_attribute_8_0 <= beat_queue_out_data[19:4];
            held_attribute_9_0 <= beat_queue_out_data[35:20];
            held_attribute_10_0 <= beat_queue_out_data[51:36];
            held_attribute_11_0 <= beat_queue_out_data[67:52];
        end
        if (takes_beat_8) begin
            held_attribute_12_0 <= beat_queue_out_data[19:4];
            held_cardinal_0_0 <= beat_queue_out_data[35:20];
        end
    end
endmodule

// Queue of two in registers.
// width = 69
module stream_skid_w69 (
    input  wire clk,
    input  wire rst,
    input  wire in_valid,
    output wire in_ready,
    input  wire [68:0] in_data,
    output reg  out_valid,
    input  wire out_ready,
    output wire [68:0] out_data
);
    reg second_valid;
    reg [68:0] head, second;

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

// Registers of a core.
// registers = 42
module bus_registers (
    input  wire clk,
    input  wire rst,
    input  wire s_axil_awvalid,
    output wire s_axil_awready,
    input  wire [11:0] s_axil_awaddr,
    input  wire s_axil_wvalid,
    output wire s_axil_wready,
    input  wire [31:0] s_axil_wdata,
    input  wire [3:0] s_axil_wstrb,
    output reg  s_axil_bvalid,
    input  wire s_axil_bready,
    output wire [1:0] s_axil_bresp,
    input  wire finished,
    input  wire occupied,
    output reg  busy,
    output reg  start,
    output reg  core_reset,
    output reg  uniform_valid,
    output reg  [4:0] uniform_address,
    output reg  [23:0] uniform_data,
    input  wire burst_error,
    input  wire packet_error,
    input  wire [1:0] memory_error,
    input  wire packet_taken,
    input  wire packet_sent,
    input  wire event_sample,
    input  wire event_starved,
    input  wire event_blocked,
    input  wire event_accumulate,
    input  wire event_hazard,
    input  wire event_slot_wait,
    input  wire s_axil_arvalid,
    output wire s_axil_arready,
    input  wire [11:0] s_axil_araddr,
    output reg  s_axil_rvalid,
    input  wire s_axil_rready,
    output reg  [31:0] s_axil_rdata,
    output wire [1:0] s_axil_rresp,
    output reg  irq,
    output wire [31:0] buffer_base
);
    (* ram_style = "distributed" *)
    reg [31:0] words [0:13];
    reg has_address, has_data;
    reg [11:0] write_address;
    reg [31:0] write_data;
    reg write_strobes, write_is_okay, interrupt_enable_bits;
    reg [19:0] buffer_base_bits;
    reg clear_errors, done, has_read_address;
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
    wire term_1 = write_address[11:2] == 10'd1;
    wire term_2 = write_address[11:2] == 10'd3;
    wire term_3 = write_address[11:2] == 10'd32;
    wire term_4 = (10'd64 <= write_address[11:2]) & ~(10'd86 < write_address[11:2]);
    wire shaped = write_strobes & (write_address[1:0] == 2'd0) & (term_1 | term_2 | term_3 | term_4);
    wire idle_only = (term_1 & (write_data[0] | write_data[1])) | term_3 | term_4;
    wire wants_start = term_1 & write_data[0];
    wire blocked = (idle_only & busy) | (wants_start & occupied);
    wire senseless = term_3 & |write_data[11:0];
    wire write_accepted = judges & (shaped & ~(blocked | senseless));
    wire commands = write_accepted & term_1;
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
    wire term_5 = read_address[11:2] == 10'd0;
    wire term_6 = read_address[11:2] == 10'd2;
    wire term_7 = read_address[11:2] == 10'd3;
    wire term_8 = read_address[11:2] == 10'd32;
    wire term_9 = (read_address[1:0] == 2'd0) & (term_5 | term_6 | term_7 | term_8 | reads_counter);
    wire refused_read = has_read_address & ~term_9;
    wire asks = has_read_address & (reads_counter & ~refused_read);
    wire answers = has_read_address & (~asks | read_valid);
    wire refused_write = judges & (~shaped | (~blocked & senseless));
    wire refused_busy = judges & (shaped & blocked);
    wire term_10 = refused_write | refused_read | refused_busy | burst_error;
    wire term_11 = term_10 | packet_error | memory_error[0] | memory_error[1];
    wire looks = ~adds;
    wire turns_aside = asks & ~for_read;
    wire visits_0 = looks & (visited == 4'd0);
    wire [6:0] sum_12 = {6'd0, refused_write} + {6'd0, refused_read};
    wire visits_1 = looks & (visited == 4'd1);
    wire visits_2 = looks & (visited == 4'd2);
    wire visits_3 = looks & (visited == 4'd3);
    wire visits_4 = looks & (visited == 4'd4);
    wire [6:0] sum_13 = {6'd0, memory_error[0]} + {6'd0, memory_error[1]};
    wire visits_5 = looks & (visited == 4'd5);
    wire visits_6 = looks & (visited == 4'd6);
    wire term_14 = packet_taken & busy;
    wire [5:0] joined_15 = {5'd0, term_14};
    wire visits_7 = looks & (visited == 4'd7);
    wire term_16 = packet_sent & busy;
    wire [5:0] joined_17 = {5'd0, term_16};
    wire visits_8 = looks & (visited == 4'd8);
    wire term_18 = event_sample & busy;
    wire [5:0] joined_19 = {5'd0, term_18};
    wire visits_9 = looks & (visited == 4'd9);
    wire term_20 = event_starved & busy;
    wire [5:0] joined_21 = {5'd0, term_20};
    wire visits_10 = looks & (visited == 4'd10);
    wire term_22 = event_blocked & busy;
    wire [5:0] joined_23 = {5'd0, term_22};
    wire visits_11 = looks & (visited == 4'd11);
    wire term_24 = event_accumulate & busy;
    wire [5:0] joined_25 = {5'd0, term_24};
    wire visits_12 = looks & (visited == 4'd12);
    wire term_26 = event_hazard & busy;
    wire [5:0] joined_27 = {5'd0, term_26};
    wire visits_13 = looks & (visited == 4'd13);
    wire term_28 = event_slot_wait & busy;
    wire [5:0] joined_29 = {5'd0, term_28};
    wire [6:0] choice_30 = visited[1] ? {1'd0, part_13} : visited[0] ? {1'd0, part_13} : {1'd0, part_12};
    wire [6:0] choice_31 = visited[1] ? (visited[0] ? {1'd0, part_11} : {1'd0, part_10}) : visited[0] ? {1'd0, part_9} : {1'd0, part_8};
    wire [6:0] choice_32 = visited[1] ? (visited[0] ? {1'd0, part_7} : {1'd0, part_6}) : visited[0] ? {1'd0, part_5} : part_4;
    wire [6:0] choice_33 = visited[1] ? (visited[0] ? {1'd0, part_3} : {1'd0, part_2}) : visited[0] ? {1'd0, part_1} : part_0;
    wire choice_34 = visited[1] ? (visited[0] ? void_11 : void_10) : visited[0] ? void_9 : void_8;
    wire choice_35 = visited[2] ? (visited[1] ? void_13 : visited[0] ? void_13 : void_12) : choice_34;
    wire choice_36 = visited[1] ? (visited[0] ? void_7 : void_6) : visited[0] ? void_5 : void_4;
    wire choice_37 = visited[1] ? (visited[0] ? void_3 : void_2) : visited[0] ? void_1 : void_0;
    wire [32:0] sum = {1'd0, is_void ? 32'd0 : word} + {26'd0, part};
    wire [31:0] saturated = sum[31:0] | {32{sum[32]}};
    wire [31:0] term_38 = ({32{term_5}} & 32'h50430a01) | ({32{term_6}} & {29'd0, error, done, busy});
    wire [31:0] term_39 = term_38 | ({32{term_7}} & {31'd0, interrupt_enable_bits});
    wire [31:0] term_40 = (term_39 | ({32{term_8}} & {buffer_base_bits, 12'd0})) & {32{~refused_read}};

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
            start <= 1'd0;
            core_reset <= 1'd0;
            clear_errors <= 1'd0;
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
            start <= starts;
            core_reset <= commands & write_data[1];
            clear_errors <= commands & write_data[2];
            done <= ~starts & (done | (busy & finished));
            uniform_valid <= write_accepted & term_4;
            has_read_address <= (read_ready & s_axil_arvalid) | (has_read_address & ~answers);
            error <= term_11 | (error & ~clear_errors);
            adds <= looks;
            part_0 <= (visits_0 | clear_errors) ? sum_12 : (part_0 + sum_12);
            void_0 <= clear_errors | (void_0 & ~visits_0);
            part_1 <= (visits_1 | clear_errors) ? {5'd0, refused_busy} : (part_1 + {5'd0, refused_busy});
            void_1 <= clear_errors | (void_1 & ~visits_1);
            part_2 <= (visits_2 | clear_errors) ? {5'd0, burst_error} : (part_2 + {5'd0, burst_error});
            void_2 <= clear_errors | (void_2 & ~visits_2);
            part_3 <= (visits_3 | clear_errors) ? {5'd0, packet_error} : (part_3 + {5'd0, packet_error});
            void_3 <= clear_errors | (void_3 & ~visits_3);
            part_4 <= (visits_4 | clear_errors) ? sum_13 : (part_4 + sum_13);
            void_4 <= clear_errors | (void_4 & ~visits_4);
            part_5 <= (visits_5 | start) ? {5'd0, busy} : (part_5 + {5'd0, busy});
            void_5 <= start | (void_5 & ~visits_5);
            part_6 <= (visits_6 | start) ? joined_15 : (part_6 + joined_15);
            void_6 <= start | (void_6 & ~visits_6);
            part_7 <= (visits_7 | start) ? joined_17 : (part_7 + joined_17);
            void_7 <= start | (void_7 & ~visits_7);
            part_8 <= (visits_8 | start) ? joined_19 : (part_8 + joined_19);
            void_8 <= start | (void_8 & ~visits_8);
            part_9 <= (visits_9 | start) ? joined_21 : (part_9 + joined_21);
            void_9 <= start | (void_9 & ~visits_9);
            part_10 <= (visits_10 | start) ? joined_23 : (part_10 + joined_23);
            void_10 <= start | (void_10 & ~visits_10);
            part_11 <= (visits_11 | start) ? joined_25 : (part_11 + joined_25);
            void_11 <= start | (void_11 & ~visits_11);
            part_12 <= (visits_12 | start) ? joined_27 : (part_12 + joined_27);
            void_12 <= start | (void_12 & ~visits_12);
            part_13 <= (visits_13 | start) ? joined_29 : (part_13 + joined_29);
            void_13 <= start | (void_13 & ~visits_13);
            read_valid <= adds & for_read;
            s_axil_rvalid <= answers | (s_axil_rvalid & ~s_axil_rready);
            irq <= done & interrupt_enable_bits;
            if (write_accepted & term_2) interrupt_enable_bits <= write_data[0];
            if (write_accepted & term_3) buffer_base_bits <= write_data[31:12];
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
        part <= visited[3] ? (visited[2] ? choice_30 : choice_31) : visited[2] ? choice_32 : choice_33;
        is_void <= visited[3] ? choice_35 : visited[2] ? choice_36 : choice_37;
        read_value <= saturated;
        if (read_ready) read_address <= s_axil_araddr;
        if (answers) begin
            s_axil_rdata <= asks ? read_value : term_40;
            read_is_error <= refused_read;
        end
    end
    always @(posedge clk) begin
        if (adds) words[visited] <= saturated;
        word <= words[visited];
    end

`ifdef RTL_ASSERT
    wire [7:0] sum_41 = {1'd0, part_0} + {1'd0, sum_12};
    wire [6:0] sum_42 = {1'd0, part_1} + {6'd0, refused_busy};
    wire [6:0] sum_43 = {1'd0, part_2} + {6'd0, burst_error};
    wire [6:0] sum_44 = {1'd0, part_3} + {6'd0, packet_error};
    wire [7:0] sum_45 = {1'd0, part_4} + {1'd0, sum_13};
    wire [6:0] sum_46 = {1'd0, part_5} + {6'd0, busy};
    wire [6:0] sum_47 = {1'd0, part_6} + {6'd0, term_14};
    wire [6:0] sum_48 = {1'd0, part_7} + {6'd0, term_16};
    wire [6:0] sum_49 = {1'd0, part_8} + {6'd0, term_18};
    wire [6:0] sum_50 = {1'd0, part_9} + {6'd0, term_20};
    wire [6:0] sum_51 = {1'd0, part_10} + {6'd0, term_22};
    wire [6:0] sum_52 = {1'd0, part_11} + {6'd0, term_24};
    wire [6:0] sum_53 = {1'd0, part_12} + {6'd0, term_26};
    wire [6:0] sum_54 = {1'd0, part_13} + {6'd0, term_28};

    always @(posedge clk) begin
        if (!rst) begin
            if (!(~sum_41[7])) begin
`ifdef FORMAL
                part_0_has_room: assert (0);
`else
                $display("assertion failed: part_0_has_room in %m");
                $stop;
`endif
            end
            if (!(~sum_42[6])) begin
`ifdef FORMAL
                part_1_has_room: assert (0);
`else
                $display("assertion failed: part_1_has_room in %m");
                $stop;
`endif
            end
            if (!(~sum_43[6])) begin
`ifdef FORMAL
                part_2_has_room: assert (0);
`else
                $display("assertion failed: part_2_has_room in %m");
                $stop;
`endif
            end
            if (!(~sum_44[6])) begin
`ifdef FORMAL
                part_3_has_room: assert (0);
`else
                $display("assertion failed: part_3_has_room in %m");
                $stop;
`endif
            end
            if (!(~sum_45[7])) begin
`ifdef FORMAL
                part_4_has_room: assert (0);
`else
                $display("assertion failed: part_4_has_room in %m");
                $stop;
`endif
            end
            if (!(~sum_46[6])) begin
`ifdef FORMAL
                part_5_has_room: assert (0);
`else
                $display("assertion failed: part_5_has_room in %m");
                $stop;
`endif
            end
            if (!(~sum_47[6])) begin
`ifdef FORMAL
                part_6_has_room: assert (0);
`else
                $display("assertion failed: part_6_has_room in %m");
                $stop;
`endif
            end
            if (!(~sum_48[6])) begin
`ifdef FORMAL
                part_7_has_room: assert (0);
`else
                $display("assertion failed: part_7_has_room in %m");
                $stop;
`endif
            end
            if (!(~sum_49[6])) begin
`ifdef FORMAL
                part_8_has_room: assert (0);
`else
                $display("assertion failed: part_8_has_room in %m");
                $stop;
`endif
            end
            if (!(~sum_50[6])) begin
`ifdef FORMAL
                part_9_has_room: assert (0);
`else
                $display("assertion failed: part_9_has_room in %m");
                $stop;
`endif
            end
            if (!(~sum_51[6])) begin
`ifdef FORMAL
                part_10_has_room: assert (0);
`else
                $display("assertion failed: part_10_has_room in %m");
                $stop;
`endif
            end
            if (!(~sum_52[6])) begin
`ifdef FORMAL
                part_11_has_room: assert (0);
`else
                $display("assertion failed: part_11_has_room in %m");
                $stop;
`endif
            end
            if (!(~sum_53[6])) begin
`ifdef FORMAL
                part_12_has_room: assert (0);
`else
                $display("assertion failed: part_12_has_room in %m");
                $stop;
`endif
            end
            if (!(~sum_54[6])) begin
`ifdef FORMAL
                part_13_has_room: assert (0);
`else
                $display("assertion failed: part_13_has_room in %m");
                $stop;
`endif
            end
        end
    end

    wire _unused_by_checks = &{
        1'b0, sum_41[6:0], sum_42[5:0], sum_43[5:0], sum_44[5:0], sum_45[6:0], sum_46[5:0], sum_47[5:0],
        sum_48[5:0], sum_49[5:0], sum_50[5:0], sum_51[5:0], sum_52[5:0], sum_53[5:0], sum_54[5:0]
    };
`endif
endmodule
