// The whole design is one file, named after its top.
/* verilator lint_off DECLFILENAME */

// Neighbor search on AXI.
module search_axi (
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
    input  wire s_axis_query_tvalid,
    output wire s_axis_query_tready,
    input  wire [63:0] s_axis_query_tdata,
    input  wire s_axis_query_tlast,
    output wire m_axis_result_tvalid,
    input  wire m_axis_result_tready,
    output wire [63:0] m_axis_result_tdata,
    output wire m_axis_result_tlast,
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
    input  wire s_axi_awvalid,
    output wire s_axi_awready,
    input  wire [3:0] s_axi_awid,
    input  wire [31:0] s_axi_awaddr,
    input  wire [7:0] s_axi_awlen,
    input  wire [2:0] s_axi_awsize,
    input  wire [1:0] s_axi_awburst,
    input  wire s_axi_wvalid,
    output wire s_axi_wready,
    input  wire [63:0] s_axi_wdata,
    input  wire [7:0] s_axi_wstrb,
    input  wire s_axi_wlast,
    output wire s_axi_bvalid,
    input  wire s_axi_bready,
    output wire [3:0] s_axi_bid,
    output wire [1:0] s_axi_bresp,
    input  wire s_axi_arvalid,
    output wire s_axi_arready,
    input  wire [3:0] s_axi_arid,
    input  wire [31:0] s_axi_araddr,
    input  wire [7:0] s_axi_arlen,
    input  wire [2:0] s_axi_arsize,
    input  wire [1:0] s_axi_arburst,
    output wire s_axi_rvalid,
    input  wire s_axi_rready,
    output wire [3:0] s_axi_rid,
    output wire [63:0] s_axi_rdata,
    output wire [1:0] s_axi_rresp,
    output wire s_axi_rlast,
    output wire irq
);
    reg [31:0] queries_left, answers_left;
    reg [2:0] beat;

    wire core_query_ready, core_fetch_valid;
    wire [3:0] core_fetch_thread;
    wire [21:0] core_fetch_address;
    wire [2:0] core_fetch_beats;
    wire core_beat_ready, core_result_valid;
    wire [23:0] core_result_number;
    wire core_result_last, core_result_found;
    wire [23:0] core_result_index;
    wire [31:0] core_result_distance2;
    wire core_event_node, core_event_pop, core_event_beat, core_event_insert, core_event_insert_wait;
    wire core_event_thread_wait, core_event_point_hit, core_event_point_miss, registers_s_axil_awready;
    wire registers_s_axil_wready, registers_s_axil_bvalid;
    wire [1:0] registers_s_axil_bresp;
    wire registers_busy, registers_start, registers_core_reset, registers_s_axil_arready;
    wire registers_s_axil_rvalid;
    wire [31:0] registers_s_axil_rdata;
    wire [1:0] registers_s_axil_rresp;
    wire registers_irq;
    wire [31:0] registers_points_base, registers_queries;
    wire queries_s_axis_tready, queries_out_valid;
    wire [23:0] queries_out_number;
    wire [5:0] queries_out_k;
    wire [31:0] queries_out_radius2, queries_out_x, queries_out_y, queries_out_z;
    wire queries_taken, queries_refused, results_in_ready, results_m_axis_tvalid;
    wire [63:0] results_m_axis_tdata;
    wire results_m_axis_tlast, results_sent, results_idle, points_request_ready, points_m_axi_arvalid;
    wire [3:0] points_m_axi_arid;
    wire [31:0] points_m_axi_araddr;
    wire [7:0] points_m_axi_arlen;
    wire [2:0] points_m_axi_arsize;
    wire [1:0] points_m_axi_arburst;
    wire points_m_axi_rready, points_record_valid;
    wire [31:0] points_record_x0, points_record_y0, points_record_z0, points_record_x1, points_record_y1;
    wire [31:0] points_record_z1, points_record_x2, points_record_y2, points_record_z2, points_record_x3;
    wire [31:0] points_record_y3, points_record_z3;
    wire points_error, points_misplaced, fetches_in_ready, fetches_out_valid;
    wire [28:0] fetches_out_data;
    wire tree_s_axi_awready, tree_s_axi_wready, tree_write_valid;
    wire [14:0] tree_write_index;
    wire [63:0] tree_write_data;
    wire tree_s_axi_bvalid;
    wire [3:0] tree_s_axi_bid;
    wire [1:0] tree_s_axi_bresp;
    wire tree_refused_busy, tree_occupied, tree_s_axi_arready, tree_s_axi_rvalid;
    wire [3:0] tree_s_axi_rid;
    wire [63:0] tree_s_axi_rdata;
    wire [1:0] tree_s_axi_rresp;
    wire tree_s_axi_rlast, tree_refused_burst;

    wire core_fetch_ready = points_request_ready & fetches_in_ready;
    wire gives_beat = points_record_valid & fetches_out_valid;
    wire [3:0] fetches_out_thread = fetches_out_data[28:25];
    wire [21:0] fetches_out_address = fetches_out_data[24:3];
    wire [2:0] sum_1 = beat + 3'd1;
    wire [2:0] fetches_out_beats = fetches_out_data[2:0];
    wire last_beat = sum_1 == fetches_out_beats;
    wire choice_2 = queries_taken ? (queries_left[1:0] == 2'd2) : (queries_left[1:0] == 2'd1);
    wire [31:0] points_address = registers_points_base + {4'd0, core_fetch_address, 6'd0};
    wire points_record_ready = core_beat_ready & fetches_out_valid;
    wire beat_moves = gives_beat & core_beat_ready;
    wire fetches_out_ready = beat_moves & last_beat;
    wire answered = core_result_valid & results_in_ready & core_result_last;

    assign s_axil_awready = registers_s_axil_awready;
    assign s_axil_wready = registers_s_axil_wready;
    assign s_axil_bvalid = registers_s_axil_bvalid;
    assign s_axil_bresp = registers_s_axil_bresp;
    assign s_axil_arready = registers_s_axil_arready;
    assign s_axil_rvalid = registers_s_axil_rvalid;
    assign s_axil_rdata = registers_s_axil_rdata;
    assign s_axil_rresp = registers_s_axil_rresp;
    assign s_axis_query_tready = queries_s_axis_tready;
    assign m_axis_result_tvalid = results_m_axis_tvalid;
    assign m_axis_result_tdata = results_m_axis_tdata;
    assign m_axis_result_tlast = results_m_axis_tlast;
    assign m_axi_arvalid = points_m_axi_arvalid;
    assign m_axi_arid = points_m_axi_arid;
    assign m_axi_araddr = points_m_axi_araddr;
    assign m_axi_arlen = points_m_axi_arlen;
    assign m_axi_arsize = points_m_axi_arsize;
    assign m_axi_arburst = points_m_axi_arburst;
    assign m_axi_rready = points_m_axi_rready;
    assign s_axi_awready = tree_s_axi_awready;
    assign s_axi_wready = tree_s_axi_wready;
    assign s_axi_bvalid = tree_s_axi_bvalid;
    assign s_axi_bid = tree_s_axi_bid;
    assign s_axi_bresp = tree_s_axi_bresp;
    assign s_axi_arready = tree_s_axi_arready;
    assign s_axi_rvalid = tree_s_axi_rvalid;
    assign s_axi_rid = tree_s_axi_rid;
    assign s_axi_rdata = tree_s_axi_rdata;
    assign s_axi_rresp = tree_s_axi_rresp;
    assign s_axi_rlast = tree_s_axi_rlast;
    assign irq = registers_irq;

    search_top core (
        .clk(clk), .rst(rst | registers_core_reset),
        .tree_valid(tree_write_valid), .tree_is_leaf(tree_write_index[14]),
        .tree_address(tree_write_index[13:0]), .tree_split(tree_write_data[31:0]),
        .tree_dimension(tree_write_data[33:32]), .tree_internal_leaf(tree_write_data[40]),
        .tree_begin(tree_write_data[21:0]), .tree_beats(tree_write_data[34:32]),
        .query_valid(queries_out_valid), .query_ready(core_query_ready), .query_number(queries_out_number),
        .query_k(queries_out_k), .query_radius2(queries_out_radius2), .query_x(queries_out_x),
        .query_y(queries_out_y), .query_z(queries_out_z),
        .fetch_valid(core_fetch_valid), .fetch_ready(core_fetch_ready), .fetch_thread(core_fetch_thread),
        .fetch_address(core_fetch_address), .fetch_beats(core_fetch_beats),
        .beat_valid(gives_beat), .beat_ready(core_beat_ready), .beat_thread(fetches_out_thread),
        .beat_address(fetches_out_address + {19'd0, beat}), .beat_last(last_beat), .beat_x0(points_record_x0),
        .beat_y0(points_record_y0), .beat_z0(points_record_z0), .beat_x1(points_record_x1),
        .beat_y1(points_record_y1), .beat_z1(points_record_z1), .beat_x2(points_record_x2),
        .beat_y2(points_record_y2), .beat_z2(points_record_z2), .beat_x3(points_record_x3),
        .beat_y3(points_record_y3), .beat_z3(points_record_z3),
        .result_valid(core_result_valid), .result_ready(results_in_ready), .result_number(core_result_number),
        .result_last(core_result_last), .result_found(core_result_found), .result_index(core_result_index),
        .result_distance2(core_result_distance2),
        .event_node(core_event_node), .event_pop(core_event_pop), .event_beat(core_event_beat),
        .event_insert(core_event_insert), .event_insert_wait(core_event_insert_wait),
        .event_thread_wait(core_event_thread_wait), .event_point_hit(core_event_point_hit),
        .event_point_miss(core_event_point_miss)
    );

    bus_registers registers (
        .clk(clk), .rst(rst),
        .s_axil_awvalid(s_axil_awvalid), .s_axil_awready(registers_s_axil_awready),
        .s_axil_awaddr(s_axil_awaddr), .s_axil_wvalid(s_axil_wvalid), .s_axil_wready(registers_s_axil_wready),
        .s_axil_wdata(s_axil_wdata), .s_axil_wstrb(s_axil_wstrb), .s_axil_bvalid(registers_s_axil_bvalid),
        .s_axil_bready(s_axil_bready), .s_axil_bresp(registers_s_axil_bresp),
        .finished(~(|answers_left) & ~registers_start & results_idle), .occupied(tree_occupied),
        .busy(registers_busy),
        .start(registers_start),
        .core_reset(registers_core_reset),
        .busy_error(tree_refused_busy),
        .burst_error({points_misplaced, tree_refused_burst}),
        .packet_error(queries_refused),
        .memory_error(points_error),
        .packet_taken(queries_taken), .packet_sent(results_sent),
        .event_node(core_event_node), .event_pop(core_event_pop), .event_beat(core_event_beat),
        .event_insert(core_event_insert), .event_insert_wait(core_event_insert_wait),
        .event_thread_wait(core_event_thread_wait), .event_point_hit(core_event_point_hit),
        .event_point_miss(core_event_point_miss),
        .s_axil_arvalid(s_axil_arvalid), .s_axil_arready(registers_s_axil_arready),
        .s_axil_araddr(s_axil_araddr), .s_axil_rvalid(registers_s_axil_rvalid), .s_axil_rready(s_axil_rready),
        .s_axil_rdata(registers_s_axil_rdata), .s_axil_rresp(registers_s_axil_rresp),
        .irq(registers_irq),
        .points_base(registers_points_base),
        .queries(registers_queries)
    );

    bus_packet_in queries (
        .clk(clk), .rst(rst), .opens(registers_start), .last((queries_left[31:2] == 30'd0) & choice_2),
        .s_axis_tvalid(s_axis_query_tvalid), .s_axis_tready(queries_s_axis_tready),
        .s_axis_tdata(s_axis_query_tdata), .s_axis_tlast(s_axis_query_tlast),
        .out_valid(queries_out_valid), .out_ready(core_query_ready), .out_number(queries_out_number),
        .out_k(queries_out_k), .out_radius2(queries_out_radius2), .out_x(queries_out_x),
        .out_y(queries_out_y), .out_z(queries_out_z),
        .taken(queries_taken), .refused(queries_refused)
    );

    bus_packet_out results (
        .clk(clk), .rst(rst),
        .in_valid(core_result_valid), .in_ready(results_in_ready), .in_number(core_result_number),
        .in_last(core_result_last), .in_found(core_result_found), .in_index(core_result_index),
        .in_distance2(core_result_distance2),
        .m_axis_tvalid(results_m_axis_tvalid), .m_axis_tready(m_axis_result_tready),
        .m_axis_tdata(results_m_axis_tdata), .m_axis_tlast(results_m_axis_tlast),
        .sent(results_sent), .idle(results_idle)
    );

    bus_reader points (
        .clk(clk), .rst(rst),
        .request_valid(core_fetch_valid & fetches_in_ready), .request_ready(points_request_ready),
        .request_address(points_address), .request_records(core_fetch_beats),
        .m_axi_arvalid(points_m_axi_arvalid), .m_axi_arready(m_axi_arready), .m_axi_arid(points_m_axi_arid),
        .m_axi_araddr(points_m_axi_araddr), .m_axi_arlen(points_m_axi_arlen),
        .m_axi_arsize(points_m_axi_arsize), .m_axi_arburst(points_m_axi_arburst), .m_axi_rvalid(m_axi_rvalid),
        .m_axi_rready(points_m_axi_rready), .m_axi_rid(m_axi_rid), .m_axi_rdata(m_axi_rdata),
        .m_axi_rresp(m_axi_rresp), .m_axi_rlast(m_axi_rlast),
        .record_valid(points_record_valid), .record_ready(points_record_ready), .record_x0(points_record_x0),
        .record_y0(points_record_y0), .record_z0(points_record_z0), .record_x1(points_record_x1),
        .record_y1(points_record_y1), .record_z1(points_record_z1), .record_x2(points_record_x2),
        .record_y2(points_record_y2), .record_z2(points_record_z2), .record_x3(points_record_x3),
        .record_y3(points_record_y3), .record_z3(points_record_z3),
        .error(points_error), .misplaced(points_misplaced)
    );

    stream_fifo_d16_w29 fetches (
        .clk(clk), .rst(rst),
        .in_valid(core_fetch_valid & points_request_ready), .in_ready(fetches_in_ready),
        .in_data({core_fetch_thread, core_fetch_address, core_fetch_beats}),
        .out_valid(fetches_out_valid), .out_ready(fetches_out_ready), .out_data(fetches_out_data)
    );

    bus_window tree (
        .clk(clk), .rst(rst), .locked(registers_busy),
        .s_axi_awvalid(s_axi_awvalid), .s_axi_awready(tree_s_axi_awready), .s_axi_awid(s_axi_awid),
        .s_axi_awaddr(s_axi_awaddr), .s_axi_awlen(s_axi_awlen), .s_axi_awsize(s_axi_awsize),
        .s_axi_awburst(s_axi_awburst), .s_axi_wvalid(s_axi_wvalid), .s_axi_wready(tree_s_axi_wready),
        .s_axi_wdata(s_axi_wdata), .s_axi_wstrb(s_axi_wstrb), .s_axi_wlast(s_axi_wlast),
        .write_valid(tree_write_valid), .write_index(tree_write_index), .write_data(tree_write_data),
        .s_axi_bvalid(tree_s_axi_bvalid), .s_axi_bready(s_axi_bready), .s_axi_bid(tree_s_axi_bid),
        .s_axi_bresp(tree_s_axi_bresp),
        .refused_busy(tree_refused_busy),
        .occupied(tree_occupied),
        .s_axi_arvalid(s_axi_arvalid), .s_axi_arready(tree_s_axi_arready), .s_axi_arid(s_axi_arid),
        .s_axi_araddr(s_axi_araddr), .s_axi_arlen(s_axi_arlen), .s_axi_arsize(s_axi_arsize),
        .s_axi_arburst(s_axi_arburst), .s_axi_rvalid(tree_s_axi_rvalid), .s_axi_rready(s_axi_rready),
        .s_axi_rid(tree_s_axi_rid), .s_axi_rdata(tree_s_axi_rdata), .s_axi_rresp(tree_s_axi_rresp),
        .s_axi_rlast(tree_s_axi_rlast),
        .refused_burst(tree_refused_burst)
    );

    always @(posedge clk) begin
        if (rst) begin
            queries_left <= 32'd0;
            answers_left <= 32'd0;
            beat <= 3'd0;
        end else begin
            queries_left <= registers_start ? registers_queries : (queries_left - {31'd0, queries_taken});
            answers_left <= registers_start ? registers_queries : (answers_left - {31'd0, answered});
            if (beat_moves) beat <= last_beat ? 3'd0 : sum_1;
        end
    end

    wire _unused = &{1'b0, tree_write_data[39:35], tree_write_data[63:41]};
endmodule

// Takes bursts of words into a memory, and refuses all others.
// index_bits = 15
module bus_window (
    input  wire clk,
    input  wire rst,
    input  wire locked,
    input  wire s_axi_awvalid,
    output wire s_axi_awready,
    input  wire [3:0] s_axi_awid,
    input  wire [31:0] s_axi_awaddr,
    input  wire [7:0] s_axi_awlen,
    input  wire [2:0] s_axi_awsize,
    input  wire [1:0] s_axi_awburst,
    input  wire s_axi_wvalid,
    output wire s_axi_wready,
    input  wire [63:0] s_axi_wdata,
    input  wire [7:0] s_axi_wstrb,
    input  wire s_axi_wlast,
    output reg  write_valid,
    output reg  [14:0] write_index,
    output reg  [63:0] write_data,
    output reg  s_axi_bvalid,
    input  wire s_axi_bready,
    output reg  [3:0] s_axi_bid,
    output wire [1:0] s_axi_bresp,
    output reg  refused_busy,
    output wire occupied,
    input  wire s_axi_arvalid,
    output wire s_axi_arready,
    input  wire [3:0] s_axi_arid,
    input  wire [31:0] s_axi_araddr,
    input  wire [7:0] s_axi_arlen,
    input  wire [2:0] s_axi_arsize,
    input  wire [1:0] s_axi_arburst,
    output reg  s_axi_rvalid,
    input  wire s_axi_rready,
    output reg  [3:0] s_axi_rid,
    output wire [63:0] s_axi_rdata,
    output wire [1:0] s_axi_rresp,
    output wire s_axi_rlast,
    output reg  refused_burst
);
    reg is_judged, takes_words, is_plain;
    reg [14:0] index;
    reg [7:0] left;
    reg is_refused, is_busy, is_unfit, is_error;
    reg [7:0] beats_left;
    reg read_waits;

    wire term_1 = is_judged | takes_words;
    wire address_ready = ~(term_1 | s_axi_bvalid);
    wire reads_last = beats_left == 8'd0;
    wire begins = s_axi_awvalid & address_ready;
    wire takes = takes_words & s_axi_wvalid;
    wire at_end = left == 8'd0;
    wire ends = takes & at_end;
    wire term_2 = begins | takes;
    wire [15:0] sum_3 = {1'd0, index} + {8'd0, left};
    wire fits = is_plain & ~sum_3[15];
    wire is_bad = ~(&s_axi_wstrb) | (s_axi_wlast ^ at_end);
    wire term_4 = is_refused | (is_bad & ~is_busy);
    wire read_begins = s_axi_arvalid & ~s_axi_rvalid;
    wire beat_goes = s_axi_rvalid & s_axi_rready;
    wire refused_write = ends & term_4;

    assign s_axi_awready = address_ready;
    assign s_axi_wready = takes_words;
    assign s_axi_bresp = is_error ? 2'd2 : 2'd0;
    assign occupied = term_1;
    assign s_axi_arready = ~s_axi_rvalid;
    assign s_axi_rdata = 64'd0;
    assign s_axi_rresp = 2'd2;
    assign s_axi_rlast = reads_last;

    always @(posedge clk) begin
        if (rst) begin
            is_judged <= 1'd0;
            takes_words <= 1'd0;
            s_axi_bvalid <= 1'd0;
            write_valid <= 1'd0;
            refused_busy <= 1'd0;
            s_axi_rvalid <= 1'd0;
            read_waits <= 1'd0;
            refused_burst <= 1'd0;
        end else begin
            is_judged <= begins;
            takes_words <= is_judged | (takes_words & ~ends);
            s_axi_bvalid <= ends | (s_axi_bvalid & ~s_axi_bready);
            write_valid <= takes & ~(is_bad | (is_busy | is_unfit));
            refused_busy <= ends & is_busy;
            s_axi_rvalid <= read_begins | (s_axi_rvalid & ~(beat_goes & reads_last));
            read_waits <= read_begins | (read_waits & refused_write);
            refused_burst <= refused_write | read_waits;
        end
    end
    always @(posedge clk) begin
        if (begins) begin
            s_axi_bid <= s_axi_awid;
            is_plain <= (s_axi_awburst == 2'd1) & (s_axi_awsize == 3'd3) & (s_axi_awaddr[2:0] == 3'd0);
        end
        if (term_2) begin
            index <= begins ? s_axi_awaddr[17:3] : (index + 15'd1);
            left <= begins ? s_axi_awlen : (left - 8'd1);
        end
        if (is_judged | takes) is_refused <= is_judged ? ~fits : term_4;
        if (is_judged) begin
            is_busy <= fits & locked;
            is_unfit <= ~fits;
        end
        write_index <= index;
        write_data <= s_axi_wdata;
        if (ends) is_error <= term_4 | is_busy;
        if (read_begins) s_axi_rid <= s_axi_arid;
        if (read_begins | beat_goes) begin
            beats_left <= read_begins ? s_axi_arlen : (beats_left - 8'd1);
        end
    end

    wire _unused = &{1'b0, s_axi_araddr, s_axi_arburst, s_axi_arsize, s_axi_awaddr[31:18], sum_3[14:0]};
endmodule

// Queue in a memory with a registered output.
// depth = 16
// width = 29
module stream_fifo_d16_w29 (
    input  wire clk,
    input  wire rst,
    input  wire in_valid,
    output wire in_ready,
    input  wire [28:0] in_data,
    output reg  out_valid,
    input  wire out_ready,
    output wire [28:0] out_data
);
    reg [4:0] held, waiting;
    reg [3:0] write_address, read_address;
    wire [28:0] item;

    wire has_room = ~held[4];
    wire push = in_valid & has_room;
    wire fetch = |waiting & (~out_valid | out_ready);
    wire pop = out_valid & out_ready;

    assign in_ready = has_room;
    assign out_data = item;

    memory_1w1r_unordered #(.WIDTH(29), .DEPTH(16)) entries (
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

// Reads records from memory in bursts.
// beats = 8
// width = 64
// records = 4
module bus_reader (
    input  wire clk,
    input  wire rst,
    input  wire request_valid,  // Records wanted.
    output wire request_ready,
    input  wire [31:0] request_address,  // Where the first one lies.
    input  wire [2:0] request_records,  // How many.
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
    output wire [31:0] record_x0,
    output wire [31:0] record_y0,
    output wire [31:0] record_z0,
    output wire [31:0] record_x1,
    output wire [31:0] record_y1,
    output wire [31:0] record_z1,
    output wire [31:0] record_x2,
    output wire [31:0] record_y2,
    output wire [31:0] record_z2,
    output wire [31:0] record_x3,
    output wire [31:0] record_y3,
    output wire [31:0] record_z3,
    output reg  error,
    output reg  misplaced
);
    reg held;
    reg [25:0] address;
    reg [2:0] records;
    reg [7:0] number;
    reg [31:0] held_x0_0, held_y0_0, held_z0_0, held_x1_0, held_y1_0, held_z1_0, held_x2_0, held_y2_0, held_z2_0;
    reg [31:0] held_x3_0, held_y3_0, held_z3_0;
    reg is_wrong;

    wire address_queue_in_ready, address_queue_out_valid;
    wire [33:0] address_queue_out_data;
    wire length_queue_in_ready, length_queue_out_valid;
    wire [7:0] length_queue_out_data;
    wire beat_queue_in_ready, beat_queue_out_valid;
    wire [64:0] beat_queue_out_data;

    wire issues = held & (address_queue_in_ready & length_queue_in_ready);
    wire [5:0] room_records = 6'd32 - {1'd0, address[4:0]};
    wire crosses = room_records < {3'd0, records};
    wire takes_request = ~held | (issues & ~crosses);
    wire [25:0] address_queue_out_address = address_queue_out_data[33:8];
    wire [5:0] burst = crosses ? room_records : {3'd0, records};
    wire [8:0] difference_1 = {burst, 3'd0} - 9'd1;
    wire [7:0] length = difference_1[7:0];
    wire advance = ~record_valid | record_ready;
    wire beat_queue_out_ready = advance & length_queue_out_valid;
    wire moves = beat_queue_out_valid & beat_queue_out_ready;
    wire ends = number == length_queue_out_data;
    wire length_queue_out_ready = moves & ends;
    wire term_2 = takes_request | issues;
    wire [5:0] difference_3 = {3'd0, records} - room_records;
    wire takes_beat_0 = moves & (number[2:0] == 3'd0);
    wire takes_beat_1 = moves & (number[2:0] == 3'd1);
    wire takes_beat_2 = moves & (number[2:0] == 3'd2);
    wire takes_beat_3 = moves & (number[2:0] == 3'd3);
    wire takes_beat_4 = moves & (number[2:0] == 3'd4);
    wire takes_beat_5 = moves & (number[2:0] == 3'd5);
    wire beat_queue_out_last = beat_queue_out_data[0];
    wire term_4 = is_wrong | (beat_queue_out_last ^ ends);

    assign request_ready = takes_request;
    assign m_axi_arvalid = address_queue_out_valid;
    assign m_axi_arid = 4'd0;
    assign m_axi_araddr = {address_queue_out_address, 6'd0};
    assign m_axi_arlen = address_queue_out_data[7:0];
    assign m_axi_arsize = 3'd3;
    assign m_axi_arburst = 2'd1;
    assign m_axi_rready = beat_queue_in_ready;
    assign record_x0 = held_x0_0;
    assign record_y0 = held_y0_0;
    assign record_z0 = held_z0_0;
    assign record_x1 = held_x1_0;
    assign record_y1 = held_y1_0;
    assign record_z1 = held_z1_0;
    assign record_x2 = held_x2_0;
    assign record_y2 = held_y2_0;
    assign record_z2 = held_z2_0;
    assign record_x3 = held_x3_0;
    assign record_y3 = held_y3_0;
    assign record_z3 = held_z3_0;

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
                is_wrong <= ~ends & term_4;
            end
            error <= m_axi_rvalid & beat_queue_in_ready & |m_axi_rresp;
            misplaced <= moves & (ends & term_4);
        end
    end
    always @(posedge clk) begin
        if (term_2) begin
            address <= takes_request ? request_address[31:6] : {address[25:5] + 21'd1, 5'd0};
            records <= takes_request ? request_records : difference_3[2:0];
        end
        if (takes_beat_0) begin
            held_x0_0 <= beat_queue_out_data[32:1];
            held_y0_0 <= beat_queue_out_data[64:33];
        end
        if (takes_beat_1) begin
            held_z0_0 <= beat_queue_out_data[32:1];
            held_x1_0 <= beat_queue_out_data[64:33];
        end
        if (takes_beat_2) begin
            held_y1_0 <= beat_queue_out_data[32:1];
            held_z1_0 <= beat_queue_out_data[64:33];
        end
        if (takes_beat_3) begin
            held_x2_0 <= beat_queue_out_data[32:1];
            held_y2_0 <= beat_queue_out_data[64:33];
        end
        if (takes_beat_4) begin
            held_z2_0 <= beat_queue_out_data[32:1];
            held_x3_0 <= beat_queue_out_data[64:33];
        end
        if (takes_beat_5) begin
            held_y3_0 <= beat_queue_out_data[32:1];
            held_z3_0 <= beat_queue_out_data[64:33];
        end
    end

    wire _unused = &{1'b0, difference_1[8], difference_3[5:3], m_axi_rid, request_address[5:0]};
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
// beats = 2
// width = 64
module bus_packet_out (
    input  wire clk,
    input  wire rst,
    input  wire in_valid,
    output wire in_ready,
    input  wire [23:0] in_number,
    input  wire in_last,
    input  wire in_found,
    input  wire [23:0] in_index,
    input  wire [31:0] in_distance2,
    output wire m_axis_tvalid,
    input  wire m_axis_tready,
    output wire [63:0] m_axis_tdata,
    output wire m_axis_tlast,
    output reg  sent,
    output wire idle
);
    reg held, place;
    reg [23:0] held_number;
    reg held_last, held_found;
    reg [23:0] held_index;
    reg [31:0] held_distance2;

    wire beat_queue_in_ready, beat_queue_out_valid;
    wire [64:0] beat_queue_out_data;

    wire moves = held & beat_queue_in_ready;
    wire leaves = moves & place;
    wire takes_record = ~held | leaves;
    wire [63:0] choice_1 = place ? {held_distance2, 8'd0, held_index} : {23'd0, held_found, 7'd0, held_last, 8'd0, held_number};
    wire takes = in_valid & takes_record;
    wire beat_queue_out_last = beat_queue_out_data[0];

    assign in_ready = takes_record;
    assign m_axis_tvalid = beat_queue_out_valid;
    assign {m_axis_tdata, m_axis_tlast} = beat_queue_out_data;
    assign idle = ~held & ~beat_queue_out_valid;

    stream_skid_w65 beat_queue (
        .clk(clk), .rst(rst),
        .in_valid(held), .in_ready(beat_queue_in_ready), .in_data({choice_1, place}),
        .out_valid(beat_queue_out_valid), .out_ready(m_axis_tready), .out_data(beat_queue_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            held <= 1'd0;
            place <= 1'd0;
            sent <= 1'd0;
        end else begin
            held <= takes | (held & ~leaves);
            sent <= beat_queue_out_valid & m_axis_tready & beat_queue_out_last;
            if (moves) place <= place ? 1'd0 : (place + 1'd1);
        end
    end
    always @(posedge clk) begin
        if (takes) begin
            held_number <= in_number;
            held_last <= in_last;
            held_found <= in_found;
            held_index <= in_index;
            held_distance2 <= in_distance2;
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
// beats = 3
// width = 64
module bus_packet_in (
    input  wire clk,
    input  wire rst,
    input  wire opens,
    input  wire last,
    input  wire s_axis_tvalid,
    output wire s_axis_tready,
    input  wire [63:0] s_axis_tdata,
    input  wire s_axis_tlast,
    output reg  out_valid,
    input  wire out_ready,
    output wire [23:0] out_number,
    output wire [5:0] out_k,
    output wire [31:0] out_radius2,
    output wire [31:0] out_x,
    output wire [31:0] out_y,
    output wire [31:0] out_z,
    output reg  taken,
    output reg  refused
);
    reg [1:0] place;
    reg is_overlong, in_range, begun, is_open;
    reg [23:0] held_number_0;
    reg [5:0] held_k_0;
    reg [31:0] held_radius2_0, held_x_0, held_y_0, held_z_0;

    wire beat_queue_in_ready, beat_queue_out_valid;
    wire [66:0] beat_queue_out_data;

    wire s_axis_ready = beat_queue_in_ready & (begun | is_open);
    wire takes = s_axis_tvalid & s_axis_ready;
    wire term_1 = takes & ~is_overlong;
    wire term_2 = place == 2'd2;
    wire whole = takes & (s_axis_tlast & (term_2 & ~is_overlong));
    wire good = whole & in_range;
    wire advance = ~out_valid | out_ready;
    wire beat_queue_out_good = beat_queue_out_data[66];
    wire moves = beat_queue_out_valid & advance;
    wire [1:0] beat_queue_out_place = beat_queue_out_data[1:0];
    wire takes_beat_0 = moves & (beat_queue_out_place == 2'd0);
    wire takes_beat_1 = moves & (beat_queue_out_place == 2'd1);
    wire takes_beat_2 = moves & (beat_queue_out_place == 2'd2);

    assign s_axis_tready = s_axis_ready;
    assign out_number = held_number_0;
    assign out_k = held_k_0;
    assign out_radius2 = held_radius2_0;
    assign out_x = held_x_0;
    assign out_y = held_y_0;
    assign out_z = held_z_0;

    stream_skid_w67 beat_queue (
        .clk(clk), .rst(rst),
        .in_valid(term_1), .in_ready(beat_queue_in_ready), .in_data({good, s_axis_tdata, place}),
        .out_valid(beat_queue_out_valid), .out_ready(advance), .out_data(beat_queue_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            place <= 2'd0;
            is_overlong <= 1'd0;
            begun <= 1'd0;
            is_open <= 1'd0;
            out_valid <= 1'd0;
            taken <= 1'd0;
            refused <= 1'd0;
        end else begin
            if (term_1) place <= (s_axis_tlast | term_2) ? 2'd0 : (place + 2'd1);
            if (takes) begin
                is_overlong <= ~s_axis_tlast & (is_overlong | term_2);
                begun <= ~s_axis_tlast;
            end
            is_open <= opens | (is_open & ~(good & last));
            taken <= good;
            refused <= (takes & ((s_axis_tlast ^ term_2) & ~is_overlong)) | (whole & ~in_range);
            if (advance) out_valid <= beat_queue_out_valid & beat_queue_out_good;
        end
    end
    always @(posedge clk) begin
        if (takes & (place == 2'd0)) begin
            in_range <= (6'd1 <= s_axis_tdata[37:32]) & ~(6'd32 < s_axis_tdata[37:32]);
        end
        if (takes_beat_0) begin
            held_number_0 <= beat_queue_out_data[25:2];
            held_k_0 <= beat_queue_out_data[39:34];
        end
        if (takes_beat_1) begin
            held_radius2_0 <= beat_queue_out_data[33:2];
            held_x_0 <= beat_queue_out_data[65:34];
        end
        if (takes_beat_2) begin
            held_y_0 <= beat_queue_out_data[33:2];
            held_z_0 <= beat_queue_out_data[65:34];
        end
    end
endmodule

// Queue of two in registers.
// width = 67
module stream_skid_w67 (
    input  wire clk,
    input  wire rst,
    input  wire in_valid,
    output wire in_ready,
    input  wire [66:0] in_data,
    output reg  out_valid,
    input  wire out_ready,
    output wire [66:0] out_data
);
    reg second_valid;
    reg [66:0] head, second;

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
// registers = 22
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
    input  wire busy_error,
    input  wire [1:0] burst_error,
    input  wire packet_error,
    input  wire memory_error,
    input  wire packet_taken,
    input  wire packet_sent,
    input  wire event_node,
    input  wire event_pop,
    input  wire event_beat,
    input  wire event_insert,
    input  wire event_insert_wait,
    input  wire event_thread_wait,
    input  wire event_point_hit,
    input  wire event_point_miss,
    input  wire s_axil_arvalid,
    output wire s_axil_arready,
    input  wire [11:0] s_axil_araddr,
    output reg  s_axil_rvalid,
    input  wire s_axil_rready,
    output reg  [31:0] s_axil_rdata,
    output wire [1:0] s_axil_rresp,
    output reg  irq,
    output wire [31:0] points_base,
    output wire [31:0] queries
);
    (* ram_style = "distributed" *)
    reg [31:0] words [0:15];
    reg has_address, has_data;
    reg [11:0] write_address;
    reg [31:0] write_data;
    reg write_strobes, write_is_okay, interrupt_enable_bits;
    reg [19:0] points_base_bits;
    reg [31:0] queries_bits;
    reg clear_errors, done, has_read_address;
    reg [11:0] read_address;
    reg error, adds;
    reg [3:0] visited;
    reg [7:0] part_0;
    reg void_0;
    reg [7:0] part_1;
    reg void_1;
    reg [7:0] part_2;
    reg void_2;
    reg [6:0] part_3;
    reg void_3;
    reg [6:0] part_4;
    reg void_4;
    reg [6:0] part_5;
    reg void_5;
    reg [6:0] part_6;
    reg void_6;
    reg [6:0] part_7;
    reg void_7;
    reg [6:0] part_8;
    reg void_8;
    reg [6:0] part_9;
    reg void_9;
    reg [6:0] part_10;
    reg void_10;
    reg [6:0] part_11;
    reg void_11;
    reg [6:0] part_12;
    reg void_12;
    reg [6:0] part_13;
    reg void_13;
    reg [6:0] part_14;
    reg void_14;
    reg [6:0] part_15;
    reg void_15;
    reg [7:0] part;
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
    wire term_4 = write_address[11:2] == 10'd34;
    wire shaped = write_strobes & (write_address[1:0] == 2'd0) & (term_1 | term_2 | term_3 | term_4);
    wire idle_only = (term_1 & (write_data[0] | write_data[1])) | term_3 | term_4;
    wire wants_start = term_1 & write_data[0];
    wire blocked = (idle_only & busy) | (wants_start & occupied);
    wire senseless = (term_3 & |write_data[11:0]) | (wants_start & (queries_bits == 32'd0));
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
            5'd22: found = 5'd30;
            5'd23: found = 5'd31;
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
    wire term_9 = read_address[11:2] == 10'd34;
    wire term_10 = term_5 | term_6 | term_7 | term_8 | term_9 | reads_counter;
    wire refused_read = has_read_address & ~((read_address[1:0] == 2'd0) & term_10);
    wire asks = has_read_address & (reads_counter & ~refused_read);
    wire answers = has_read_address & (~asks | read_valid);
    wire refused_write = judges & (~shaped | (~blocked & senseless));
    wire refused_busy = judges & (shaped & blocked);
    wire term_11 = refused_write | refused_read | refused_busy | busy_error | burst_error[0];
    wire looks = ~adds;
    wire turns_aside = asks & ~for_read;
    wire visits_0 = looks & (visited == 4'd0);
    wire [7:0] sum_12 = {7'd0, refused_write} + {7'd0, refused_read};
    wire visits_1 = looks & (visited == 4'd1);
    wire [7:0] sum_13 = {7'd0, refused_busy} + {7'd0, busy_error};
    wire visits_2 = looks & (visited == 4'd2);
    wire [7:0] sum_14 = {7'd0, burst_error[0]} + {7'd0, burst_error[1]};
    wire visits_3 = looks & (visited == 4'd3);
    wire visits_4 = looks & (visited == 4'd4);
    wire visits_5 = looks & (visited == 4'd5);
    wire visits_6 = looks & (visited == 4'd6);
    wire term_15 = packet_taken & busy;
    wire [6:0] joined_16 = {6'd0, term_15};
    wire visits_7 = looks & (visited == 4'd7);
    wire term_17 = packet_sent & busy;
    wire [6:0] joined_18 = {6'd0, term_17};
    wire visits_8 = looks & (visited == 4'd8);
    wire term_19 = event_node & busy;
    wire [6:0] joined_20 = {6'd0, term_19};
    wire visits_9 = looks & (visited == 4'd9);
    wire term_21 = event_pop & busy;
    wire [6:0] joined_22 = {6'd0, term_21};
    wire visits_10 = looks & (visited == 4'd10);
    wire term_23 = event_beat & busy;
    wire [6:0] joined_24 = {6'd0, term_23};
    wire visits_11 = looks & (visited == 4'd11);
    wire term_25 = event_insert & busy;
    wire [6:0] joined_26 = {6'd0, term_25};
    wire visits_12 = looks & (visited == 4'd12);
    wire term_27 = event_insert_wait & busy;
    wire [6:0] joined_28 = {6'd0, term_27};
    wire visits_13 = looks & (visited == 4'd13);
    wire term_29 = event_thread_wait & busy;
    wire [6:0] joined_30 = {6'd0, term_29};
    wire visits_14 = looks & (visited == 4'd14);
    wire term_31 = event_point_hit & busy;
    wire [6:0] joined_32 = {6'd0, term_31};
    wire visits_15 = looks & (visited == 4'd15);
    wire term_33 = event_point_miss & busy;
    wire [6:0] joined_34 = {6'd0, term_33};
    wire [7:0] choice_35 = visited[1] ? (visited[0] ? {1'd0, part_15} : {1'd0, part_14}) : visited[0] ? {1'd0, part_13} : {1'd0, part_12};
    wire [7:0] choice_36 = visited[1] ? (visited[0] ? {1'd0, part_11} : {1'd0, part_10}) : visited[0] ? {1'd0, part_9} : {1'd0, part_8};
    wire [7:0] choice_37 = visited[1] ? (visited[0] ? {1'd0, part_7} : {1'd0, part_6}) : visited[0] ? {1'd0, part_5} : {1'd0, part_4};
    wire [7:0] choice_38 = visited[1] ? (visited[0] ? {1'd0, part_3} : part_2) : visited[0] ? part_1 : part_0;
    wire choice_39 = visited[1] ? (visited[0] ? void_15 : void_14) : visited[0] ? void_13 : void_12;
    wire choice_40 = visited[1] ? (visited[0] ? void_11 : void_10) : visited[0] ? void_9 : void_8;
    wire choice_41 = visited[1] ? (visited[0] ? void_7 : void_6) : visited[0] ? void_5 : void_4;
    wire choice_42 = visited[1] ? (visited[0] ? void_3 : void_2) : visited[0] ? void_1 : void_0;
    wire [32:0] sum = {1'd0, is_void ? 32'd0 : word} + {25'd0, part};
    wire [31:0] saturated = sum[31:0] | {32{sum[32]}};
    wire [31:0] term_43 = ({32{term_5}} & 32'h50430b01) | ({32{term_6}} & {29'd0, error, done, busy});
    wire [31:0] term_44 = term_43 | ({32{term_7}} & {31'd0, interrupt_enable_bits});
    wire [31:0] term_45 = term_44 | ({32{term_8}} & {points_base_bits, 12'd0}) | ({32{term_9}} & queries_bits);

    assign s_axil_awready = ~has_address;
    assign s_axil_wready = ~has_data;
    assign s_axil_bresp = write_is_okay ? 2'd0 : 2'd2;
    assign s_axil_arready = read_ready;
    assign s_axil_rresp = read_is_error ? 2'd2 : 2'd0;
    assign points_base = {points_base_bits, 12'd0};
    assign queries = queries_bits;

    always @(posedge clk) begin
        if (rst) begin
            has_address <= 1'd0;
            has_data <= 1'd0;
            s_axil_bvalid <= 1'd0;
            busy <= 1'd0;
            interrupt_enable_bits <= 1'd0;
            points_base_bits <= 20'd0;
            queries_bits <= 32'd0;
            start <= 1'd0;
            core_reset <= 1'd0;
            clear_errors <= 1'd0;
            done <= 1'd0;
            has_read_address <= 1'd0;
            error <= 1'd0;
            adds <= 1'd0;
            visited <= 4'd0;
            part_0 <= 8'd0;
            void_0 <= 1'd1;
            part_1 <= 8'd0;
            void_1 <= 1'd1;
            part_2 <= 8'd0;
            void_2 <= 1'd1;
            part_3 <= 7'd0;
            void_3 <= 1'd1;
            part_4 <= 7'd0;
            void_4 <= 1'd1;
            part_5 <= 7'd0;
            void_5 <= 1'd1;
            part_6 <= 7'd0;
            void_6 <= 1'd1;
            part_7 <= 7'd0;
            void_7 <= 1'd1;
            part_8 <= 7'd0;
            void_8 <= 1'd1;
            part_9 <= 7'd0;
            void_9 <= 1'd1;
            part_10 <= 7'd0;
            void_10 <= 1'd1;
            part_11 <= 7'd0;
            void_11 <= 1'd1;
            part_12 <= 7'd0;
            void_12 <= 1'd1;
            part_13 <= 7'd0;
            void_13 <= 1'd1;
            part_14 <= 7'd0;
            void_14 <= 1'd1;
            part_15 <= 7'd0;
            void_15 <= 1'd1;
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
            has_read_address <= (read_ready & s_axil_arvalid) | (has_read_address & ~answers);
            error <= term_11 | burst_error[1] | packet_error | memory_error | (error & ~clear_errors);
            adds <= looks;
            part_0 <= (visits_0 | clear_errors) ? sum_12 : (part_0 + sum_12);
            void_0 <= clear_errors | (void_0 & ~visits_0);
            part_1 <= (visits_1 | clear_errors) ? sum_13 : (part_1 + sum_13);
            void_1 <= clear_errors | (void_1 & ~visits_1);
            part_2 <= (visits_2 | clear_errors) ? sum_14 : (part_2 + sum_14);
            void_2 <= clear_errors | (void_2 & ~visits_2);
            part_3 <= (visits_3 | clear_errors) ? {6'd0, packet_error} : (part_3 + {6'd0, packet_error});
            void_3 <= clear_errors | (void_3 & ~visits_3);
            part_4 <= (visits_4 | clear_errors) ? {6'd0, memory_error} : (part_4 + {6'd0, memory_error});
            void_4 <= clear_errors | (void_4 & ~visits_4);
            part_5 <= (visits_5 | start) ? {6'd0, busy} : (part_5 + {6'd0, busy});
            void_5 <= start | (void_5 & ~visits_5);
            part_6 <= (visits_6 | start) ? joined_16 : (part_6 + joined_16);
            void_6 <= start | (void_6 & ~visits_6);
            part_7 <= (visits_7 | start) ? joined_18 : (part_7 + joined_18);
            void_7 <= start | (void_7 & ~visits_7);
            part_8 <= (visits_8 | start) ? joined_20 : (part_8 + joined_20);
            void_8 <= start | (void_8 & ~visits_8);
            part_9 <= (visits_9 | start) ? joined_22 : (part_9 + joined_22);
            void_9 <= start | (void_9 & ~visits_9);
            part_10 <= (visits_10 | start) ? joined_24 : (part_10 + joined_24);
            void_10 <= start | (void_10 & ~visits_10);
            part_11 <= (visits_11 | start) ? joined_26 : (part_11 + joined_26);
            void_11 <= start | (void_11 & ~visits_11);
            part_12 <= (visits_12 | start) ? joined_28 : (part_12 + joined_28);
            void_12 <= start | (void_12 & ~visits_12);
            part_13 <= (visits_13 | start) ? joined_30 : (part_13 + joined_30);
            void_13 <= start | (void_13 & ~visits_13);
            part_14 <= (visits_14 | start) ? joined_32 : (part_14 + joined_32);
            void_14 <= start | (void_14 & ~visits_14);
            part_15 <= (visits_15 | start) ? joined_34 : (part_15 + joined_34);
            void_15 <= start | (void_15 & ~visits_15);
            read_valid <= adds & for_read;
            s_axil_rvalid <= answers | (s_axil_rvalid & ~s_axil_rready);
            irq <= done & interrupt_enable_bits;
            if (write_accepted & term_2) interrupt_enable_bits <= write_data[0];
            if (write_accepted & term_3) points_base_bits <= write_data[31:12];
            if (write_accepted & term_4) queries_bits <= write_data;
            if (adds) begin
                visited <= turns_aside ? found[3:0] : round;
                for_read <= turns_aside;
            end
            if (adds & ~turns_aside) round <= (round == 4'd15) ? 4'd0 : (round + 4'd1);
        end
    end
    always @(posedge clk) begin
        if (~has_address) write_address <= s_axil_awaddr;
        if (~has_data) begin
            write_data <= s_axil_wdata;
            write_strobes <= &s_axil_wstrb;
        end
        if (judges) write_is_okay <= write_accepted;
        if (read_ready) read_address <= s_axil_araddr;
        part <= visited[3] ? (visited[2] ? choice_35 : choice_36) : visited[2] ? choice_37 : choice_38;
        is_void <= visited[3] ? (visited[2] ? choice_39 : choice_40) : visited[2] ? choice_41 : choice_42;
        read_value <= saturated;
        if (answers) begin
            s_axil_rdata <= asks ? read_value : (term_45 & {32{~refused_read}});
            read_is_error <= refused_read;
        end
    end
    always @(posedge clk) begin
        if (adds) words[visited] <= saturated;
        word <= words[visited];
    end

`ifdef RTL_ASSERT
    wire [8:0] sum_46 = {1'd0, part_0} + {1'd0, sum_12};
    wire [8:0] sum_47 = {1'd0, part_1} + {1'd0, sum_13};
    wire [8:0] sum_48 = {1'd0, part_2} + {1'd0, sum_14};
    wire [7:0] sum_49 = {1'd0, part_3} + {7'd0, packet_error};
    wire [7:0] sum_50 = {1'd0, part_4} + {7'd0, memory_error};
    wire [7:0] sum_51 = {1'd0, part_5} + {7'd0, busy};
    wire [7:0] sum_52 = {1'd0, part_6} + {7'd0, term_15};
    wire [7:0] sum_53 = {1'd0, part_7} + {7'd0, term_17};
    wire [7:0] sum_54 = {1'd0, part_8} + {7'd0, term_19};
    wire [7:0] sum_55 = {1'd0, part_9} + {7'd0, term_21};
    wire [7:0] sum_56 = {1'd0, part_10} + {7'd0, term_23};
    wire [7:0] sum_57 = {1'd0, part_11} + {7'd0, term_25};
    wire [7:0] sum_58 = {1'd0, part_12} + {7'd0, term_27};
    wire [7:0] sum_59 = {1'd0, part_13} + {7'd0, term_29};
    wire [7:0] sum_60 = {1'd0, part_14} + {7'd0, term_31};
    wire [7:0] sum_61 = {1'd0, part_15} + {7'd0, term_33};

    always @(posedge clk) begin
        if (!rst) begin
            if (!(~sum_46[8])) begin
`ifdef FORMAL
                part_0_has_room: assert (0);
`else
                $display("assertion failed: part_0_has_room in %m");
                $stop;
`endif
            end
            if (!(~sum_47[8])) begin
`ifdef FORMAL
                part_1_has_room: assert (0);
`else
                $display("assertion failed: part_1_has_room in %m");
                $stop;
`endif
            end
            if (!(~sum_48[8])) begin
`ifdef FORMAL
                part_2_has_room: assert (0);
`else
                $display("assertion failed: part_2_has_room in %m");
                $stop;
`endif
            end
            if (!(~sum_49[7])) begin
`ifdef FORMAL
                part_3_has_room: assert (0);
`else
                $display("assertion failed: part_3_has_room in %m");
                $stop;
`endif
            end
            if (!(~sum_50[7])) begin
`ifdef FORMAL
                part_4_has_room: assert (0);
`else
                $display("assertion failed: part_4_has_room in %m");
                $stop;
`endif
            end
            if (!(~sum_51[7])) begin
`ifdef FORMAL
                part_5_has_room: assert (0);
`else
                $display("assertion failed: part_5_has_room in %m");
                $stop;
`endif
            end
            if (!(~sum_52[7])) begin
`ifdef FORMAL
                part_6_has_room: assert (0);
`else
                $display("assertion failed: part_6_has_room in %m");
                $stop;
`endif
            end
            if (!(~sum_53[7])) begin
`ifdef FORMAL
                part_7_has_room: assert (0);
`else
                $display("assertion failed: part_7_has_room in %m");
                $stop;
`endif
            end
            if (!(~sum_54[7])) begin
`ifdef FORMAL
                part_8_has_room: assert (0);
`else
                $display("assertion failed: part_8_has_room in %m");
                $stop;
`endif
            end
            if (!(~sum_55[7])) begin
`ifdef FORMAL
                part_9_has_room: assert (0);
`else
                $display("assertion failed: part_9_has_room in %m");
                $stop;
`endif
            end
            if (!(~sum_56[7])) begin
`ifdef FORMAL
                part_10_has_room: assert (0);
`else
                $display("assertion failed: part_10_has_room in %m");
                $stop;
`endif
            end
            if (!(~sum_57[7])) begin
`ifdef FORMAL
                part_11_has_room: assert (0);
`else
                $display("assertion failed: part_11_has_room in %m");
                $stop;
`endif
            end
            if (!(~sum_58[7])) begin
`ifdef FORMAL
                part_12_has_room: assert (0);
`else
                $display("assertion failed: part_12_has_room in %m");
                $stop;
`endif
            end
            if (!(~sum_59[7])) begin
`ifdef FORMAL
                part_13_has_room: assert (0);
`else
                $display("assertion failed: part_13_has_room in %m");
                $stop;
`endif
            end
            if (!(~sum_60[7])) begin
`ifdef FORMAL
                part_14_has_room: assert (0);
`else
                $display("assertion failed: part_14_has_room in %m");
                $stop;
`endif
            end
            if (!(~sum_61[7])) begin
`ifdef FORMAL
                part_15_has_room: assert (0);
`else
                $display("assertion failed: part_15_has_room in %m");
                $stop;
`endif
            end
        end
    end

    wire _unused_by_checks = &{
        1'b0, sum_46[7:0], sum_47[7:0], sum_48[7:0], sum_49[6:0], sum_50[6:0], sum_51[6:0], sum_52[6:0],
        sum_53[6:0], sum_54[6:0], sum_55[6:0], sum_56[6:0], sum_57[6:0], sum_58[6:0], sum_59[6:0],
        sum_60[6:0], sum_61[6:0]
    };
`endif
endmodule
