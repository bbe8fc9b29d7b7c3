// The whole design is one file, named after its top.
/* verilator lint_off DECLFILENAME */

// Neighbor search on AXI.
module search_axi (
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
    input  wire s_axis_query_tvalid, output wire s_axis_query_tready,  // Beats of packets.
    input  wire [63:0] s_axis_query_tdata,  // Its bytes.
    input  wire s_axis_query_tlast,  // Closes its packet.
    output wire m_axis_result_tvalid, input wire m_axis_result_tready,  // Beats of packets.
    output wire [63:0] m_axis_result_tdata,  // Its bytes.
    output wire m_axis_result_tlast,  // Closes its packet.
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
    output wire m_axi_tree_arvalid, input wire m_axi_tree_arready,  // Bursts wanted.
    output wire [3:0] m_axi_tree_arid,  // The burst's identifier, which its answers bear.
    output wire [31:0] m_axi_tree_araddr,  // Its first byte.
    output wire [7:0] m_axi_tree_arlen,  // One less than its beats.
    output wire [2:0] m_axi_tree_arsize,  // The binary logarithm of a beat's bytes.
    output wire [1:0] m_axi_tree_arburst,  // How the address goes on: up, where it is 1.
    input  wire m_axi_tree_rvalid, output wire m_axi_tree_rready,  // Their beats.
    input  wire [3:0] m_axi_tree_rid,  // The burst's identifier.
    input  wire [63:0] m_axi_tree_rdata,  // Its bytes.
    input  wire [1:0] m_axi_tree_rresp,  // Whether all is well: 0 if so.
    input  wire m_axi_tree_rlast,  // Closes its burst.
    output wire irq  // Interrupt.
);
    reg sets_up;
    reg [31:0] queries_left, answers_left;
    reg empty_leaf;
    reg [2:0] beat;

    wire core_lookup_valid;
    wire [3:0] core_lookup_thread;
    wire [20:0] core_lookup_address;
    wire core_record_ready, core_query_ready, core_fetch_valid;
    wire [3:0] core_fetch_thread;
    wire [21:0] core_fetch_address;
    wire [2:0] core_fetch_beats;
    wire core_beat_ready, core_result_valid;
    wire [23:0] core_result_number;
    wire core_result_last, core_result_found;
    wire [23:0] core_result_index;
    wire [31:0] core_result_distance2;
    wire core_result_cached, core_event_node, core_event_pop, core_event_beat, core_event_insert;
    wire core_event_insert_wait, core_event_thread_wait, core_event_point_hit, core_event_point_miss;
    wire core_event_tree_hit, core_event_tree_miss, core_event_cache_hit, core_event_cache_miss;
    wire registers_busy, registers_start, registers_core_reset, registers_aborts;
    wire [31:0] registers_points_base, registers_tree_base, registers_queries;
    wire registers_cache_ball;
    wire [31:0] registers_cache_far_scale, registers_cache_margin_scale;
    wire queries_out_valid;
    wire [23:0] queries_out_number;
    wire [5:0] queries_out_k;
    wire [31:0] queries_out_radius2, queries_out_x, queries_out_y, queries_out_z, queries_out_reach;
    wire queries_taken, queries_refused, results_in_ready, results_sent, results_idle, early_end_aborts;
    wire early_end_ended, points_request_ready, points_record_valid;
    wire [31:0] points_record_x0, points_record_y0, points_record_z0, points_record_x1, points_record_y1;
    wire [31:0] points_record_z1, points_record_x2, points_record_y2, points_record_z2, points_record_x3;
    wire [31:0] points_record_y3, points_record_z3;
    wire points_error, points_misplaced, fetches_in_ready, fetches_out_valid;
    wire [28:0] fetches_out_data;
    wire tree_request_ready, tree_record_valid;
    wire [63:0] tree_record_word;
    wire tree_error, tree_misplaced, lookups_in_ready, lookups_out_valid;
    wire [24:0] lookups_out_data;

    wire core_lookup_ready = tree_request_ready & lookups_in_ready;
    wire gives_record = tree_record_valid & lookups_out_valid;
    wire [3:0] lookups_out_thread = lookups_out_data[24:21];
    wire [20:0] lookups_out_address = lookups_out_data[20:0];
    wire core_fetch_ready = points_request_ready & fetches_in_ready;
    wire gives_beat = points_record_valid & fetches_out_valid;
    wire [3:0] fetches_out_thread = fetches_out_data[28:25];
    wire [21:0] fetches_out_address = fetches_out_data[24:3];
    wire [2:0] beat_plus_1 = beat + 3'd1;
    wire [2:0] fetches_out_beats = fetches_out_data[2:0];
    wire last_beat = beat_plus_1 == fetches_out_beats;
    wire registers_finished_both = ~(|answers_left) & ~registers_start & results_idle & ~early_end_aborts;
    wire queries_last_choice = queries_taken ? (queries_left[1:0] == 2'd2) : (queries_left[1:0] == 2'd1);
    wire quiet = results_idle & (~fetches_out_valid & ~lookups_out_valid);
    wire [31:0] points_address = registers_points_base + {4'd0, core_fetch_address, 6'd0};
    wire is_empty = core_fetch_beats == 3'd0;
    wire [2:0] beats = core_fetch_beats | {2'd0, is_empty};
    wire points_record_ready_either = core_beat_ready | early_end_aborts;
    wire points_record_ready = points_record_ready_either & fetches_out_valid;
    wire beat_moves = gives_beat & points_record_ready_either;
    wire fetches_out_ready = beat_moves & last_beat;
    wire [31:0] tree_address = registers_tree_base + {8'd0, core_lookup_address, 3'd0};
    wire tree_record_ready_either = core_record_ready | early_end_aborts;
    wire tree_record_ready = tree_record_ready_either & lookups_out_valid;
    wire lookups_out_ready = tree_record_ready_either & tree_record_valid;
    wire answered = core_result_valid & results_in_ready & core_result_last;

    search_top core (
        .clk(clk), .rst(rst | (registers_core_reset | early_end_aborts)), .lookup_valid(core_lookup_valid),
        .lookup_ready(core_lookup_ready), .lookup_thread(core_lookup_thread),
        .lookup_address(core_lookup_address),
        .record_valid(gives_record), .record_ready(core_record_ready), .record_thread(lookups_out_thread),
        .record_address(lookups_out_address), .record_split(tree_record_word[31:0]),
        .record_dimension(tree_record_word[33:32]), .record_internal_leaf(tree_record_word[40]),
        .record_begin(tree_record_word[21:0]), .record_beats(tree_record_word[34:32]),
        .setup_valid(sets_up), .setup_ball(registers_cache_ball), .setup_far_scale(registers_cache_far_scale),
        .setup_margin_scale(registers_cache_margin_scale),
        .query_valid(queries_out_valid), .query_ready(core_query_ready), .query_number(queries_out_number),
        .query_k(queries_out_k), .query_radius2(queries_out_radius2), .query_x(queries_out_x),
        .query_y(queries_out_y), .query_z(queries_out_z), .query_reach(queries_out_reach),
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
        .result_distance2(core_result_distance2), .result_cached(core_result_cached),
        .event_node(core_event_node), .event_pop(core_event_pop), .event_beat(core_event_beat),
        .event_insert(core_event_insert), .event_insert_wait(core_event_insert_wait),
        .event_thread_wait(core_event_thread_wait), .event_point_hit(core_event_point_hit),
        .event_point_miss(core_event_point_miss), .event_tree_hit(core_event_tree_hit),
        .event_tree_miss(core_event_tree_miss), .event_cache_hit(core_event_cache_hit),
        .event_cache_miss(core_event_cache_miss)
    );

    bus_registers registers (
        .clk(clk), .rst(rst), .s_axil_awvalid(s_axil_awvalid), .s_axil_awready(s_axil_awready),
        .s_axil_awaddr(s_axil_awaddr), .s_axil_wvalid(s_axil_wvalid), .s_axil_wready(s_axil_wready),
        .s_axil_wdata(s_axil_wdata), .s_axil_wstrb(s_axil_wstrb), .s_axil_bvalid(s_axil_bvalid),
        .s_axil_bready(s_axil_bready), .s_axil_bresp(s_axil_bresp),
        .finished(registers_finished_both | early_end_ended), .occupied(early_end_aborts),
        .busy(registers_busy), .start(registers_start), .core_reset(registers_core_reset),
        .aborts(registers_aborts), .burst_error({empty_leaf, points_misplaced, tree_misplaced}),
        .packet_error(queries_refused),
        .memory_error({points_error, tree_error}),
        .packet_taken(queries_taken), .packet_sent(results_sent),
        .event_node(core_event_node), .event_pop(core_event_pop), .event_beat(core_event_beat),
        .event_insert(core_event_insert), .event_insert_wait(core_event_insert_wait),
        .event_thread_wait(core_event_thread_wait), .event_point_hit(core_event_point_hit),
        .event_point_miss(core_event_point_miss), .event_tree_hit(core_event_tree_hit),
        .event_tree_miss(core_event_tree_miss), .event_cache_hit(core_event_cache_hit),
        .event_cache_miss(core_event_cache_miss),
        .s_axil_arvalid(s_axil_arvalid), .s_axil_arready(s_axil_arready), .s_axil_araddr(s_axil_araddr),
        .s_axil_rvalid(s_axil_rvalid), .s_axil_rready(s_axil_rready), .s_axil_rdata(s_axil_rdata),
        .s_axil_rresp(s_axil_rresp),
        .irq(irq), .points_base(registers_points_base),
        .tree_base(registers_tree_base),
        .queries(registers_queries), .cache_ball(registers_cache_ball),
        .cache_far_scale(registers_cache_far_scale), .cache_margin_scale(registers_cache_margin_scale)
    );

    bus_packet_in queries (
        .clk(clk), .rst(rst | early_end_aborts), .opens(registers_start),
        .last((queries_left[31:2] == 30'd0) & queries_last_choice), .s_axis_tvalid(s_axis_query_tvalid),
        .s_axis_tready(s_axis_query_tready), .s_axis_tdata(s_axis_query_tdata),
        .s_axis_tlast(s_axis_query_tlast),
        .out_valid(queries_out_valid), .out_ready(core_query_ready), .out_number(queries_out_number),
        .out_k(queries_out_k), .out_radius2(queries_out_radius2), .out_x(queries_out_x),
        .out_y(queries_out_y), .out_z(queries_out_z), .out_reach(queries_out_reach),
        .taken(queries_taken), .refused(queries_refused)
    );

    bus_packet_out results (
        .clk(clk), .rst(rst), .in_valid(core_result_valid), .in_ready(results_in_ready),
        .in_number(core_result_number), .in_last(core_result_last), .in_found(core_result_found),
        .in_index(core_result_index), .in_distance2(core_result_distance2), .in_cached(core_result_cached),
        .m_axis_tvalid(m_axis_result_tvalid), .m_axis_tready(m_axis_result_tready),
        .m_axis_tdata(m_axis_result_tdata), .m_axis_tlast(m_axis_result_tlast),
        .sent(results_sent), .idle(results_idle)
    );

    bus_abort early_end (
        .clk(clk), .rst(rst), .asked(registers_aborts), .running(registers_busy), .quiet(quiet),
        .aborts(early_end_aborts), .ended(early_end_ended)
    );

    bus_reader points (
        .clk(clk), .rst(rst), .request_valid(core_fetch_valid & fetches_in_ready),
        .request_ready(points_request_ready), .request_address(points_address), .request_records(beats),
        .m_axi_arvalid(m_axi_arvalid), .m_axi_arready(m_axi_arready), .m_axi_arid(m_axi_arid),
        .m_axi_araddr(m_axi_araddr), .m_axi_arlen(m_axi_arlen), .m_axi_arsize(m_axi_arsize),
        .m_axi_arburst(m_axi_arburst), .m_axi_rvalid(m_axi_rvalid), .m_axi_rready(m_axi_rready),
        .m_axi_rid(m_axi_rid), .m_axi_rdata(m_axi_rdata), .m_axi_rresp(m_axi_rresp),
        .m_axi_rlast(m_axi_rlast),
        .record_valid(points_record_valid), .record_ready(points_record_ready), .record_x0(points_record_x0),
        .record_y0(points_record_y0), .record_z0(points_record_z0), .record_x1(points_record_x1),
        .record_y1(points_record_y1), .record_z1(points_record_z1), .record_x2(points_record_x2),
        .record_y2(points_record_y2), .record_z2(points_record_z2), .record_x3(points_record_x3),
        .record_y3(points_record_y3), .record_z3(points_record_z3),
        .error(points_error), .misplaced(points_misplaced)
    );

    stream_fifo_d16_w29 fetches (
        .clk(clk), .rst(rst), .in_valid(core_fetch_valid & points_request_ready), .in_ready(fetches_in_ready),
        .in_data({core_fetch_thread, core_fetch_address, beats}),
        .out_valid(fetches_out_valid), .out_ready(fetches_out_ready), .out_data(fetches_out_data)
    );

    bus_reader_v2 tree (
        .clk(clk), .rst(rst), .request_valid(core_lookup_valid & lookups_in_ready),
        .request_ready(tree_request_ready), .request_address(tree_address), .request_records(1'd1),
        .m_axi_arvalid(m_axi_tree_arvalid), .m_axi_arready(m_axi_tree_arready), .m_axi_arid(m_axi_tree_arid),
        .m_axi_araddr(m_axi_tree_araddr), .m_axi_arlen(m_axi_tree_arlen), .m_axi_arsize(m_axi_tree_arsize),
        .m_axi_arburst(m_axi_tree_arburst), .m_axi_rvalid(m_axi_tree_rvalid),
        .m_axi_rready(m_axi_tree_rready), .m_axi_rid(m_axi_tree_rid), .m_axi_rdata(m_axi_tree_rdata),
        .m_axi_rresp(m_axi_tree_rresp), .m_axi_rlast(m_axi_tree_rlast),
        .record_valid(tree_record_valid), .record_ready(tree_record_ready), .record_word(tree_record_word),
        .error(tree_error), .misplaced(tree_misplaced)
    );

    stream_fifo_d16_w25 lookups (
        .clk(clk), .rst(rst), .in_valid(core_lookup_valid & tree_request_ready), .in_ready(lookups_in_ready),
        .in_data({core_lookup_thread, core_lookup_address}),
        .out_valid(lookups_out_valid), .out_ready(lookups_out_ready), .out_data(lookups_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            sets_up <= 1'd0;
            queries_left <= 32'd0;
            answers_left <= 32'd0;
            empty_leaf <= 1'd0;
            beat <= 3'd0;
        end else begin
            sets_up <= registers_start;
            queries_left <= registers_start ? registers_queries : (queries_left - {31'd0, queries_taken});
            answers_left <= registers_start ? registers_queries : (answers_left - {31'd0, answered});
            empty_leaf <= core_fetch_valid & core_fetch_ready & is_empty;
            if (beat_moves) beat <= last_beat ? 3'd0 : beat_plus_1;
        end
    end

    wire _unused = &{1'b0, tree_record_word[39:35], tree_record_word[63:41]};
endmodule

// Reads records from memory in bursts.
// beats = 1
// width = 64
// records = 1
module bus_reader_v2 (
    input  wire clk, input wire rst,
    input  wire request_valid, output wire request_ready,  // Records wanted.
    input  wire [31:0] request_address,  // Where the first one lies.
    input  wire request_records,  // How many.
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
    output wire [63:0] record_word,  // What a node or a leaf holds.
    output reg  error,  // An answer was none of success.
    output reg  misplaced  // A burst ended whose last beat was not marked so, or another was; or a beat came that nobody asked for.
);
    reg held;
    reg [28:0] address;
    reg [4:0] under_way;
    reg [63:0] held_word_0;

    wire address_queue_in_ready;
    wire [36:0] address_queue_out_data;
    wire beat_queue_out_valid;
    wire [64:0] beat_queue_out_data;

    wire below_limit = ~(under_way == 5'd16);
    wire issues = held & (address_queue_in_ready & below_limit);
    wire takes_request = ~held | issues;
    wire [28:0] address_queue_out_address = address_queue_out_data[36:8];
    wire advance = ~record_valid | record_ready;
    wire misplaced_inverted = ~(|under_way);
    wire beat_queue_out_ready = advance | misplaced_inverted;
    wire moves = beat_queue_out_valid & (advance & |under_way);
    wire beat_queue_out_last = beat_queue_out_data[0];

    assign request_ready = takes_request;
    assign m_axi_arid = 4'd0;
    assign m_axi_araddr = {address_queue_out_address, 3'd0};
    assign m_axi_arlen = address_queue_out_data[7:0];
    assign m_axi_arsize = 3'd3;
    assign m_axi_arburst = 2'd1;
    assign record_word = held_word_0;

    stream_skid_w37 address_queue (
        .clk(clk), .rst(rst), .in_valid(issues), .in_ready(address_queue_in_ready), .in_data({address, 8'd0}),
        .out_valid(m_axi_arvalid), .out_ready(m_axi_arready), .out_data(address_queue_out_data)
    );

    stream_skid_w65 beat_queue (
        .clk(clk), .rst(rst), .in_valid(m_axi_rvalid), .in_ready(m_axi_rready),
        .in_data({m_axi_rdata, m_axi_rlast}),
        .out_valid(beat_queue_out_valid), .out_ready(beat_queue_out_ready), .out_data(beat_queue_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            held <= 1'd0;
            under_way <= 5'd0;
            record_valid <= 1'd0;
            error <= 1'd0;
            misplaced <= 1'd0;
        end else begin
            if (takes_request) held <= request_valid;
            under_way <= (under_way + {4'd0, issues}) - {4'd0, moves};
            error <= m_axi_rvalid & m_axi_rready & |m_axi_rresp;
            misplaced <= (beat_queue_out_valid & misplaced_inverted) | (moves & (beat_queue_out_last ^ 1'd1));
            if (advance) record_valid <= moves;
        end
    end
    always @(posedge clk) begin
        if (takes_request) address <= request_address[31:3];
        if (moves) held_word_0 <= beat_queue_out_data[64:1];
    end

    wire _unused = &{1'b0, m_axi_rid, request_address[2:0], request_records};

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        a_request_is_for_some_and_no_more_than_any_may_be: assert (~request_valid | request_records);
`else
        if (!(~request_valid | request_records)) begin
            $display("assertion failed: a_request_is_for_some_and_no_more_than_any_may_be in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue of two in registers.
// width = 37
module stream_skid_w37 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [36:0] in_data,
    output wire out_valid, input wire out_ready, output wire [36:0] out_data
);
    reg head_filled, second_filled, room;
    reg [36:0] head, second;

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
// width = 29
module stream_fifo_d16_w29 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [28:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [28:0] out_data
);
    reg [4:0] held, waiting;
    reg is_full, any_waits;
    reg [3:0] write_address, read_address;
    wire [28:0] item;

    wire has_room = ~is_full;
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [4:0] held_bits = {{4{~push}}, 1'd1};
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    memory_1w1r_unordered #(.WIDTH(29), .DEPTH(16)) entries (
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

// Reads records from memory in bursts.
// beats = 8
// width = 64
// records = 4
module bus_reader (
    input  wire clk, input wire rst,
    input  wire request_valid, output wire request_ready,  // Records wanted.
    input  wire [31:0] request_address,  // Where the first one lies.
    input  wire [2:0] request_records,  // How many.
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
    output wire [31:0] record_x0,  // A point a lane; NaN where there is none.
    output wire [31:0] record_y0,  // A point a lane; NaN where there is none.
    output wire [31:0] record_z0,  // A point a lane; NaN where there is none.
    output wire [31:0] record_x1,  // A point a lane; NaN where there is none.
    output wire [31:0] record_y1,  // A point a lane; NaN where there is none.
    output wire [31:0] record_z1,  // A point a lane; NaN where there is none.
    output wire [31:0] record_x2,  // A point a lane; NaN where there is none.
    output wire [31:0] record_y2,  // A point a lane; NaN where there is none.
    output wire [31:0] record_z2,  // A point a lane; NaN where there is none.
    output wire [31:0] record_x3,  // A point a lane; NaN where there is none.
    output wire [31:0] record_y3,  // A point a lane; NaN where there is none.
    output wire [31:0] record_z3,  // A point a lane; NaN where there is none.
    output reg  error,  // An answer was none of success.
    output reg  misplaced  // A burst ended whose last beat was not marked so, or another was; or a beat came that nobody asked for.
);
    reg held;
    reg [25:0] address;
    reg [2:0] records;
    reg [7:0] number;
    reg [31:0] held_x0_0, held_y0_0, held_z0_0, held_x1_0, held_y1_0, held_z1_0, held_x2_0, held_y2_0, held_z2_0;
    reg [31:0] held_x3_0, held_y3_0, held_z3_0;
    reg is_wrong;

    wire address_queue_in_ready;
    wire [33:0] address_queue_out_data;
    wire length_queue_in_ready, length_queue_out_valid;
    wire [7:0] length_queue_out_data;
    wire beat_queue_out_valid;
    wire [64:0] beat_queue_out_data;

    wire issues = held & (address_queue_in_ready & length_queue_in_ready);
    wire [5:0] room_records = 6'd32 - {1'd0, address[4:0]};
    wire crosses = room_records < {3'd0, records};
    wire takes_request = ~held | (issues & ~crosses);
    wire [25:0] address_queue_out_address = address_queue_out_data[33:8];
    wire [5:0] burst = crosses ? room_records : {3'd0, records};
    wire [8:0] length_difference = {burst, 3'd0} - 9'd1;
    wire [7:0] length = length_difference[7:0];
    wire advance = ~record_valid | record_ready;
    wire moves = beat_queue_out_valid & (advance & length_queue_out_valid);
    wire ends = number == length_queue_out_data;
    wire length_queue_out_ready = moves & ends;
    wire beat_queue_out_ready = advance | ~length_queue_out_valid;
    wire takes_request_or_issues = takes_request | issues;
    wire [5:0] records_minus_room_records = {3'd0, records} - room_records;
    wire takes_beat_0 = moves & (number[2:0] == 3'd0);
    wire takes_beat_1 = moves & (number[2:0] == 3'd1);
    wire takes_beat_2 = moves & (number[2:0] == 3'd2);
    wire takes_beat_3 = moves & (number[2:0] == 3'd3);
    wire takes_beat_4 = moves & (number[2:0] == 3'd4);
    wire takes_beat_5 = moves & (number[2:0] == 3'd5);
    wire beat_queue_out_last = beat_queue_out_data[0];
    wire is_wrong_either = is_wrong | (beat_queue_out_last ^ ends);

    assign request_ready = takes_request;
    assign m_axi_arid = 4'd0;
    assign m_axi_araddr = {address_queue_out_address, 6'd0};
    assign m_axi_arlen = address_queue_out_data[7:0];
    assign m_axi_arsize = 3'd3;
    assign m_axi_arburst = 2'd1;
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
        .clk(clk), .rst(rst), .in_valid(issues), .in_ready(address_queue_in_ready),
        .in_data({address, length}),
        .out_valid(m_axi_arvalid), .out_ready(m_axi_arready), .out_data(address_queue_out_data)
    );

    stream_fifo_d16_w8 length_queue (
        .clk(clk), .rst(rst), .in_valid(issues), .in_ready(length_queue_in_ready), .in_data(length),
        .out_valid(length_queue_out_valid), .out_ready(length_queue_out_ready),
        .out_data(length_queue_out_data)
    );

    stream_skid_w65 beat_queue (
        .clk(clk), .rst(rst), .in_valid(m_axi_rvalid), .in_ready(m_axi_rready),
        .in_data({m_axi_rdata, m_axi_rlast}),
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
                is_wrong <= ~ends & is_wrong_either;
            end
            error <= m_axi_rvalid & m_axi_rready & |m_axi_rresp;
            misplaced <= (beat_queue_out_valid & ~length_queue_out_valid) | (moves & (ends & is_wrong_either));
        end
    end
    always @(posedge clk) begin
        if (takes_request_or_issues) begin
            address <= takes_request ? request_address[31:6] : {address[25:5] + 21'd1, 5'd0};
            records <= takes_request ? request_records : records_minus_room_records[2:0];
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

    wire _unused = &{1'b0, length_difference[8], m_axi_rid, records_minus_room_records[5:3], request_address[5:0]};

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        a_request_is_for_some_and_no_more_than_any_may_be: assert (~request_valid | (|request_records & ~(3'd4 < request_records)));
        no_burst_is_longer_than_any_may_be: assert (~length_queue_out_valid | (length_queue_out_data < 8'd32));
        no_burst_is_longer_than_asked_for: assert (~length_queue_out_valid | ~(length_queue_out_data < number));
`else
        if (!(~request_valid | (|request_records & ~(3'd4 < request_records)))) begin
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
// width = 34
module stream_skid_w34 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [33:0] in_data,
    output wire out_valid, input wire out_ready, output wire [33:0] out_data
);
    reg head_filled, second_filled, room;
    reg [33:0] head, second;

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

// Spreads records over the beats of packets.
// beats = 3
// width = 64
module bus_packet_out (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready,  // Records.
    input  wire [23:0] in_number,  // The query's number.
    input  wire in_last,  // Closes the query.
    input  wire in_found,  // Low for a query without any neighbor.
    input  wire [23:0] in_index,  // The neighbor's place in the point memory.
    input  wire [31:0] in_distance2,  // Its squared distance.
    input  wire in_cached,  // With a neighbor cache, its squared distance is that to the query whose neighborhood is reused.
    output wire m_axis_tvalid, input wire m_axis_tready,  // Beats of packets.
    output wire [63:0] m_axis_tdata,  // Its bytes.
    output wire m_axis_tlast,  // Closes its packet.
    output reg  sent,  // A packet was sent.
    output wire idle  // Nothing is on its way.
);
    reg held;
    reg [1:0] place;
    reg [23:0] held_number;
    reg held_last, held_found;
    reg [23:0] held_index;
    reg [31:0] held_distance2;
    reg held_cached;

    wire beat_queue_in_ready;
    wire [64:0] beat_queue_out_data;

    wire moves = held & beat_queue_in_ready;
    wire at_end = place == 2'd2;
    wire leaves = moves & at_end;
    wire takes_record = ~held | leaves;
    wire [63:0] beat_queue_in_data_choice = place[0] ? {held_distance2, 8'd0, held_index} : {23'd0, held_found, 7'd0, held_last, 8'd0, held_number};
    wire takes = in_valid & takes_record;
    wire beat_queue_out_last = beat_queue_out_data[0];

    assign in_ready = takes_record;
    assign {m_axis_tdata, m_axis_tlast} = beat_queue_out_data;
    assign idle = ~held & ~m_axis_tvalid;

    stream_skid_w65 beat_queue (
        .clk(clk), .rst(rst), .in_valid(held), .in_ready(beat_queue_in_ready),
        .in_data({place[1] ? {63'd0, held_cached} : beat_queue_in_data_choice, at_end}),
        .out_valid(m_axis_tvalid), .out_ready(m_axis_tready), .out_data(beat_queue_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            held <= 1'd0;
            place <= 2'd0;
            sent <= 1'd0;
        end else begin
            held <= takes | (held & ~leaves);
            sent <= m_axis_tvalid & m_axis_tready & beat_queue_out_last;
            if (moves) place <= at_end ? 2'd0 : (place + 2'd1);
        end
    end
    always @(posedge clk) begin
        if (takes) begin
            held_number <= in_number;
            held_last <= in_last;
            held_found <= in_found;
            held_index <= in_index;
            held_distance2 <= in_distance2;
            held_cached <= in_cached;
        end
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        in_distance2_in_range: assert (~in_valid | (in_distance2 < 32'h80000000));
`else
        if (!(~in_valid | (in_distance2 < 32'h80000000))) begin
            $display("assertion failed: in_distance2_in_range in %m"); $stop;
        end
`endif
    end
`endif
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

// Gathers the beats of packets into records.
// beats = 4
// width = 64
module bus_packet_in (
    input  wire clk, input wire rst,
    input  wire opens,  // A run begins.
    input  wire last,  // The packet that comes next is the run's last, where packets do not say so themselves.
    input  wire s_axis_tvalid, output wire s_axis_tready,  // Beats of packets.
    input  wire [63:0] s_axis_tdata,  // Its bytes.
    input  wire s_axis_tlast,  // Closes its packet.
    output reg  out_valid, input wire out_ready,  // The records of good packets.
    output wire [23:0] out_number,  // Its number, which its results bear.
    output wire [5:0] out_k,  // Neighbors wanted.
    output wire [31:0] out_radius2,  // Squared radius within which neighbors count.
    output wire [31:0] out_x,  // Where.
    output wire [31:0] out_y,  // Where.
    output wire [31:0] out_z,  // Where.
    output wire [31:0] out_reach,  // With a neighbor cache, the radius around it within which a neighborhood must be complete to cover it: 0 for k nearest neighbors, the radius of a ball query.
    output reg  taken,  // A packet was taken.
    output reg  refused  // A packet was refused.
);
    reg [1:0] place;
    reg is_overlong, k_in_range, radius2_in_range, begun, is_open;
    reg [23:0] held_number_0;
    reg [5:0] held_k_0;
    reg [31:0] held_radius2_0, held_x_0, held_y_0, held_z_0, held_reach_0;

    wire beat_queue_in_ready, beat_queue_out_valid;
    wire [66:0] beat_queue_out_data;

    wire s_axis_ready = beat_queue_in_ready & (begun | is_open);
    wire takes = s_axis_tvalid & s_axis_ready;
    wire takes_and_not_is_overlong = takes & ~is_overlong;
    wire place_is_3 = place == 2'd3;
    wire whole = takes & (s_axis_tlast & (place_is_3 & ~is_overlong));
    wire in_range = k_in_range & radius2_in_range;
    wire good = whole & in_range;
    wire advance = ~out_valid | out_ready;
    wire beat_queue_out_good = beat_queue_out_data[66];
    wire moves = beat_queue_out_valid & advance;
    wire [1:0] beat_queue_out_place = beat_queue_out_data[1:0];
    wire takes_beat_0 = moves & (beat_queue_out_place == 2'd0);
    wire takes_beat_1 = moves & (beat_queue_out_place == 2'd1);
    wire takes_beat_2 = moves & (beat_queue_out_place == 2'd2);
    wire takes_beat_3 = moves & (beat_queue_out_place == 2'd3);

    assign s_axis_tready = s_axis_ready;
    assign out_number = held_number_0;
    assign out_k = held_k_0;
    assign out_radius2 = held_radius2_0;
    assign out_x = held_x_0;
    assign out_y = held_y_0;
    assign out_z = held_z_0;
    assign out_reach = held_reach_0;

    stream_skid_w67 beat_queue (
        .clk(clk), .rst(rst), .in_valid(takes_and_not_is_overlong), .in_ready(beat_queue_in_ready),
        .in_data({good, s_axis_tdata, place}),
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
            if (takes_and_not_is_overlong) begin
                place <= (s_axis_tlast | place_is_3) ? 2'd0 : (place + 2'd1);
            end
            if (takes) begin
                is_overlong <= ~s_axis_tlast & (is_overlong | place_is_3);
                begun <= ~s_axis_tlast;
            end
            is_open <= opens | (is_open & ~(good & last));
            taken <= good;
            refused <= (takes & ((s_axis_tlast ^ place_is_3) & ~is_overlong)) | (whole & ~in_range);
            if (advance) out_valid <= beat_queue_out_valid & beat_queue_out_good;
        end
    end
    always @(posedge clk) begin
        if (takes & (place == 2'd0)) begin
            k_in_range <= (6'd1 <= s_axis_tdata[37:32]) & ~(6'd32 < s_axis_tdata[37:32]);
        end
        if (takes & (place == 2'd1)) radius2_in_range <= ~(32'h7f800000 < s_axis_tdata[31:0]);
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
        if (takes_beat_3) held_reach_0 <= beat_queue_out_data[33:2];
    end
endmodule

// Queue of two in registers.
// width = 67
module stream_skid_w67 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [66:0] in_data,
    output wire out_valid, input wire out_ready, output wire [66:0] out_data
);
    reg head_filled, second_filled, room;
    reg [66:0] head, second;

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
// registers = 30
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
    output reg  busy,  // A run is under way.
    output reg  start,  // A run begins.
    output reg  core_reset,  // The core is to be reset.
    output reg  aborts,  // The run is to end.
    input  wire [2:0] burst_error,  // A burst was refused, or ended where it must not.
    input  wire packet_error,  // A packet was refused.
    input  wire [1:0] memory_error,  // Memory answered with an error.
    input  wire packet_taken,  // A packet was taken.
    input  wire packet_sent,  // A packet was sent.
    input  wire event_node,  // A node was visited.
    input  wire event_pop,  // A path was popped.
    input  wire event_beat,  // A priority queue was done with a beat of points.
    input  wire event_insert,  // A neighbor was inserted.
    input  wire event_insert_wait,  // A beat stayed for one more insertion.
    input  wire event_thread_wait,  // A query waited for a free thread.
    input  wire event_point_hit,  // The point cache had a leaf that was wanted.
    input  wire event_point_miss,  // The point cache lacked a leaf that was wanted.
    input  wire event_tree_hit,  // The tree cache had a record that was wanted.
    input  wire event_tree_miss,  // The tree cache lacked a record that was wanted.
    input  wire event_cache_hit,  // A neighborhood of the neighbor cache covered a query.
    input  wire event_cache_miss,  // No neighborhood of the neighbor cache covered a query.
    input  wire s_axil_arvalid, output wire s_axil_arready,  // Registers to be read.
    input  wire [11:0] s_axil_araddr,  // Its first byte.
    output reg  s_axil_rvalid, input wire s_axil_rready,  // What is read from them.
    output reg  [31:0] s_axil_rdata,  // The value.
    output wire [1:0] s_axil_rresp,  // Whether all is well: 0 if so.
    output reg  irq,  // Interrupt.
    output wire [31:0] points_base,  // Address of the points.
    output wire [31:0] tree_base,  // Address of the tree.
    output wire [31:0] queries,  // Queries of the next run.
    output wire cache_ball,  // Whether queries are balls (neighbor cache).
    output wire [31:0] cache_far_scale,  // Factor of the distance to the farthest neighbor.
    output wire [31:0] cache_margin_scale  // Factor of what is left of it.
);
    (* ram_style = "distributed" *)
    reg [31:0] words [0:19];
    reg has_address, has_data;
    reg [11:0] write_address;
    reg [31:0] write_data;
    reg write_strobes, write_is_okay, interrupt_enable_bits;
    reg [19:0] points_base_bits, tree_base_bits;
    reg [31:0] queries_bits;
    reg cache_ball_bits;
    reg [31:0] cache_far_scale_bits, cache_margin_scale_bits;
    reg clear_errors, done, has_read_address;
    reg [11:0] read_address;
    reg error, adds;
    reg [4:0] visited;
    reg [6:0] part_0;
    reg void_0;
    reg [5:0] part_1;
    reg void_1;
    reg [7:0] part_2;
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
    reg [5:0] part_14;
    reg void_14;
    reg [5:0] part_15;
    reg void_15;
    reg [5:0] part_16;
    reg void_16;
    reg [5:0] part_17;
    reg void_17;
    reg [5:0] part_18;
    reg void_18;
    reg [5:0] part_19;
    reg void_19;
    reg [7:0] part;
    reg is_void;
    reg [31:0] word;
    reg [4:0] round;
    reg for_read, read_valid;
    reg [31:0] read_value;
    reg read_is_error;

    wire read_ready = ~(has_read_address | s_axil_rvalid);
    wire judges = has_address & (has_data & ~s_axil_bvalid);
    wire write_address_11_2_is_1 = write_address[11:2] == 10'd1;
    wire write_address_11_2_is_3 = write_address[11:2] == 10'd3;
    wire write_address_11_2_is_32 = write_address[11:2] == 10'd32;
    wire shaped_either = write_address_11_2_is_1 | write_address_11_2_is_3 | write_address_11_2_is_32;
    wire write_address_11_2_is_33 = write_address[11:2] == 10'd33;
    wire write_address_11_2_is_34 = write_address[11:2] == 10'd34;
    wire shaped_either_2 = shaped_either | write_address_11_2_is_33 | write_address_11_2_is_34;
    wire write_address_11_2_is_35 = write_address[11:2] == 10'd35;
    wire write_address_11_2_is_36 = write_address[11:2] == 10'd36;
    wire shaped_either_3 = shaped_either_2 | write_address_11_2_is_35 | write_address_11_2_is_36;
    wire write_address_11_2_is_37 = write_address[11:2] == 10'd37;
    wire shaped = write_strobes & (write_address[1:0] == 2'd0) & (shaped_either_3 | write_address_11_2_is_37);
    wire wants_start = write_address_11_2_is_1 & write_data[0];
    wire idle_only_either = wants_start | write_address_11_2_is_32 | write_address_11_2_is_33;
    wire idle_only_either_2 = idle_only_either | write_address_11_2_is_34 | write_address_11_2_is_35;
    wire idle_only_either_3 = idle_only_either_2 | write_address_11_2_is_36 | write_address_11_2_is_37;
    wire idle_only = idle_only_either_3 | (write_address_11_2_is_1 & write_data[1]);
    wire blocked = (idle_only & busy) | (wants_start & occupied);
    wire senseless_either = (write_address_11_2_is_32 & |write_data[11:0]) | (write_address_11_2_is_33 & |write_data[11:0]);
    wire senseless = senseless_either | (wants_start & (queries_bits == 32'd0));
    wire write_accepted = judges & (shaped & ~(blocked | senseless));
    wire commands = write_accepted & write_address_11_2_is_1;
    wire starts = commands & write_data[0];
    reg [5:0] found;
    always @(*) begin
        case (read_address[6:2])
            5'd0: found = 6'd0;
            5'd1: found = 6'd0;
            5'd2: found = 6'd0;
            5'd3: found = 6'd0;
            5'd4: found = 6'd32;
            5'd5: found = 6'd33;
            5'd6: found = 6'd34;
            5'd7: found = 6'd35;
            5'd8: found = 6'd36;
            5'd9: found = 6'd37;
            5'd10: found = 6'd38;
            5'd11: found = 6'd39;
            5'd12: found = 6'd0;
            5'd13: found = 6'd0;
            5'd14: found = 6'd0;
            5'd15: found = 6'd0;
            5'd16: found = 6'd40;
            5'd17: found = 6'd41;
            5'd18: found = 6'd42;
            5'd19: found = 6'd43;
            5'd20: found = 6'd44;
            5'd21: found = 6'd45;
            5'd22: found = 6'd46;
            5'd23: found = 6'd47;
            5'd24: found = 6'd48;
            5'd25: found = 6'd49;
            5'd26: found = 6'd50;
            5'd27: found = 6'd51;
            5'd28: found = 6'd0;
            5'd29: found = 6'd0;
            5'd30: found = 6'd0;
            default: found = 6'd0;
        endcase
    end
    wire reads_counter = found[5] & (read_address[11:7] == 5'd0);
    wire read_address_11_2_is_0 = read_address[11:2] == 10'd0;
    wire read_address_11_2_is_2 = read_address[11:2] == 10'd2;
    wire read_address_11_2_is_3 = read_address[11:2] == 10'd3;
    wire refused_read_either = read_address_11_2_is_0 | read_address_11_2_is_2 | read_address_11_2_is_3;
    wire read_address_11_2_is_32 = read_address[11:2] == 10'd32;
    wire read_address_11_2_is_33 = read_address[11:2] == 10'd33;
    wire refused_read_either_2 = refused_read_either | read_address_11_2_is_32 | read_address_11_2_is_33;
    wire read_address_11_2_is_34 = read_address[11:2] == 10'd34;
    wire read_address_11_2_is_35 = read_address[11:2] == 10'd35;
    wire refused_read_either_3 = refused_read_either_2 | read_address_11_2_is_34 | read_address_11_2_is_35;
    wire read_address_11_2_is_36 = read_address[11:2] == 10'd36;
    wire read_address_11_2_is_37 = read_address[11:2] == 10'd37;
    wire refused_read_either_4 = refused_read_either_3 | read_address_11_2_is_36 | read_address_11_2_is_37;
    wire refused_read_both = (read_address[1:0] == 2'd0) & (refused_read_either_4 | reads_counter);
    wire refused_read = has_read_address & ~refused_read_both;
    wire asks = has_read_address & (reads_counter & ~refused_read);
    wire answers = has_read_address & (~asks | read_valid);
    wire refused_write = judges & (~shaped | (~blocked & senseless));
    wire refused_busy = judges & (shaped & blocked);
    wire error_either = refused_write | refused_read | refused_busy | burst_error[0] | burst_error[1];
    wire error_either_2 = error_either | burst_error[2] | packet_error | memory_error[0] | memory_error[1];
    wire looks = ~adds;
    wire turns_aside = asks & ~for_read;
    wire visits_0 = looks & (visited == 5'd0);
    wire [6:0] part_0_sum = {6'd0, refused_write} + {6'd0, refused_read};
    wire visits_1 = looks & (visited == 5'd1);
    wire visits_2 = looks & (visited == 5'd2);
    wire [7:0] part_2_sum = {7'd0, burst_error[0]} + {7'd0, burst_error[1]} + {7'd0, burst_error[2]};
    wire visits_3 = looks & (visited == 5'd3);
    wire visits_4 = looks & (visited == 5'd4);
    wire [6:0] part_4_sum = {6'd0, memory_error[0]} + {6'd0, memory_error[1]};
    wire visits_5 = looks & (visited == 5'd5);
    wire visits_6 = looks & (visited == 5'd6);
    wire packet_taken_and_busy = packet_taken & busy;
    wire [5:0] part_6_bits = {5'd0, packet_taken_and_busy};
    wire visits_7 = looks & (visited == 5'd7);
    wire packet_sent_and_busy = packet_sent & busy;
    wire [5:0] part_7_bits = {5'd0, packet_sent_and_busy};
    wire visits_8 = looks & (visited == 5'd8);
    wire event_node_and_busy = event_node & busy;
    wire [5:0] part_8_bits = {5'd0, event_node_and_busy};
    wire visits_9 = looks & (visited == 5'd9);
    wire event_pop_and_busy = event_pop & busy;
    wire [5:0] part_9_bits = {5'd0, event_pop_and_busy};
    wire visits_10 = looks & (visited == 5'd10);
    wire event_beat_and_busy = event_beat & busy;
    wire [5:0] part_10_bits = {5'd0, event_beat_and_busy};
    wire visits_11 = looks & (visited == 5'd11);
    wire event_insert_and_busy = event_insert & busy;
    wire [5:0] part_11_bits = {5'd0, event_insert_and_busy};
    wire visits_12 = looks & (visited == 5'd12);
    wire event_insert_wait_and_busy = event_insert_wait & busy;
    wire [5:0] part_12_bits = {5'd0, event_insert_wait_and_busy};
    wire visits_13 = looks & (visited == 5'd13);
    wire event_thread_wait_and_busy = event_thread_wait & busy;
    wire [5:0] part_13_bits = {5'd0, event_thread_wait_and_busy};
    wire visits_14 = looks & (visited == 5'd14);
    wire event_point_hit_and_busy = event_point_hit & busy;
    wire [5:0] part_14_bits = {5'd0, event_point_hit_and_busy};
    wire visits_15 = looks & (visited == 5'd15);
    wire event_point_miss_and_busy = event_point_miss & busy;
    wire [5:0] part_15_bits = {5'd0, event_point_miss_and_busy};
    wire visits_16 = looks & (visited == 5'd16);
    wire event_tree_hit_and_busy = event_tree_hit & busy;
    wire [5:0] part_16_bits = {5'd0, event_tree_hit_and_busy};
    wire visits_17 = looks & (visited == 5'd17);
    wire event_tree_miss_and_busy = event_tree_miss & busy;
    wire [5:0] part_17_bits = {5'd0, event_tree_miss_and_busy};
    wire visits_18 = looks & (visited == 5'd18);
    wire event_cache_hit_and_busy = event_cache_hit & busy;
    wire [5:0] part_18_bits = {5'd0, event_cache_hit_and_busy};
    wire visits_19 = looks & (visited == 5'd19);
    wire event_cache_miss_and_busy = event_cache_miss & busy;
    wire [5:0] part_19_bits = {5'd0, event_cache_miss_and_busy};
    wire [7:0] part_choice = visited[1] ? (visited[0] ? {2'd0, part_19} : {2'd0, part_18}) : visited[0] ? {2'd0, part_17} : {2'd0, part_16};
    wire [7:0] part_choice_2 = visited[3] ? {2'd0, part_19} : visited[2] ? {2'd0, part_19} : part_choice;
    wire [7:0] part_choice_3 = visited[1] ? (visited[0] ? {2'd0, part_15} : {2'd0, part_14}) : visited[0] ? {2'd0, part_13} : {2'd0, part_12};
    wire [7:0] part_choice_4 = visited[1] ? (visited[0] ? {2'd0, part_11} : {2'd0, part_10}) : visited[0] ? {2'd0, part_9} : {2'd0, part_8};
    wire [7:0] part_choice_5 = visited[1] ? (visited[0] ? {2'd0, part_7} : {2'd0, part_6}) : visited[0] ? {2'd0, part_5} : {1'd0, part_4};
    wire [7:0] part_choice_6 = visited[1] ? (visited[0] ? {2'd0, part_3} : part_2) : visited[0] ? {2'd0, part_1} : {1'd0, part_0};
    wire [7:0] part_choice_7 = visited[3] ? (visited[2] ? part_choice_3 : part_choice_4) : visited[2] ? part_choice_5 : part_choice_6;
    wire is_void_choice = visited[1] ? (visited[0] ? void_19 : void_18) : visited[0] ? void_17 : void_16;
    wire is_void_choice_2 = visited[1] ? (visited[0] ? void_15 : void_14) : visited[0] ? void_13 : void_12;
    wire is_void_choice_3 = visited[1] ? (visited[0] ? void_11 : void_10) : visited[0] ? void_9 : void_8;
    wire is_void_choice_4 = visited[1] ? (visited[0] ? void_7 : void_6) : visited[0] ? void_5 : void_4;
    wire is_void_choice_5 = visited[1] ? (visited[0] ? void_3 : void_2) : visited[0] ? void_1 : void_0;
    wire is_void_choice_6 = visited[3] ? (visited[2] ? is_void_choice_2 : is_void_choice_3) : visited[2] ? is_void_choice_4 : is_void_choice_5;
    wire [32:0] sum = {1'd0, is_void ? 32'd0 : word} + {25'd0, part};
    wire [31:0] saturated = sum[31:0] | {32{sum[32]}};
    wire [31:0] s_axil_rdata_either = ({32{read_address_11_2_is_0}} & 32'h50430b01) | ({32{read_address_11_2_is_2}} & {29'd0, error, done, busy});
    wire [31:0] s_axil_rdata_either_2 = s_axil_rdata_either | ({32{read_address_11_2_is_3}} & {31'd0, interrupt_enable_bits});
    wire [31:0] s_axil_rdata_either_3 = s_axil_rdata_either_2 | ({32{read_address_11_2_is_32}} & {points_base_bits, 12'd0});
    wire [31:0] s_axil_rdata_either_4 = s_axil_rdata_either_3 | ({32{read_address_11_2_is_33}} & {tree_base_bits, 12'd0});
    wire [31:0] s_axil_rdata_either_5 = s_axil_rdata_either_4 | ({32{read_address_11_2_is_34}} & queries_bits);
    wire [31:0] s_axil_rdata_either_6 = s_axil_rdata_either_5 | ({32{read_address_11_2_is_35}} & {31'd0, cache_ball_bits});
    wire [31:0] s_axil_rdata_either_7 = s_axil_rdata_either_6 | ({32{read_address_11_2_is_36}} & cache_far_scale_bits);
    wire [31:0] s_axil_rdata_either_8 = s_axil_rdata_either_7 | ({32{read_address_11_2_is_37}} & cache_margin_scale_bits);

    assign s_axil_awready = ~has_address;
    assign s_axil_wready = ~has_data;
    assign s_axil_bresp = write_is_okay ? 2'd0 : 2'd2;
    assign s_axil_arready = read_ready;
    assign s_axil_rresp = read_is_error ? 2'd2 : 2'd0;
    assign points_base = {points_base_bits, 12'd0};
    assign tree_base = {tree_base_bits, 12'd0};
    assign queries = queries_bits;
    assign cache_ball = cache_ball_bits;
    assign cache_far_scale = cache_far_scale_bits;
    assign cache_margin_scale = cache_margin_scale_bits;

    always @(posedge clk) begin
        if (rst) begin
            has_address <= 1'd0;
            has_data <= 1'd0;
            s_axil_bvalid <= 1'd0;
            busy <= 1'd0;
            interrupt_enable_bits <= 1'd0;
            points_base_bits <= 20'd0;
            tree_base_bits <= 20'd0;
            queries_bits <= 32'd0;
            cache_ball_bits <= 1'd0;
            cache_far_scale_bits <= 32'd0;
            cache_margin_scale_bits <= 32'd0;
            start <= 1'd0;
            core_reset <= 1'd0;
            clear_errors <= 1'd0;
            aborts <= 1'd0;
            done <= 1'd0;
            has_read_address <= 1'd0;
            error <= 1'd0;
            adds <= 1'd0;
            visited <= 5'd0;
            part_0 <= 7'd0;
            void_0 <= 1'd1;
            part_1 <= 6'd0;
            void_1 <= 1'd1;
            part_2 <= 8'd0;
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
            part_14 <= 6'd0;
            void_14 <= 1'd1;
            part_15 <= 6'd0;
            void_15 <= 1'd1;
            part_16 <= 6'd0;
            void_16 <= 1'd1;
            part_17 <= 6'd0;
            void_17 <= 1'd1;
            part_18 <= 6'd0;
            void_18 <= 1'd1;
            part_19 <= 6'd0;
            void_19 <= 1'd1;
            round <= 5'd0;
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
            aborts <= commands & write_data[3];
            done <= ~starts & (done | (busy & finished));
            has_read_address <= (read_ready & s_axil_arvalid) | (has_read_address & ~answers);
            error <= error_either_2 | (error & ~clear_errors);
            adds <= looks;
            part_0 <= (visits_0 | clear_errors) ? part_0_sum : (part_0 + part_0_sum);
            void_0 <= clear_errors | (void_0 & ~visits_0);
            part_1 <= (visits_1 | clear_errors) ? {5'd0, refused_busy} : (part_1 + {5'd0, refused_busy});
            void_1 <= clear_errors | (void_1 & ~visits_1);
            part_2 <= (visits_2 | clear_errors) ? part_2_sum : (part_2 + part_2_sum);
            void_2 <= clear_errors | (void_2 & ~visits_2);
            part_3 <= (visits_3 | clear_errors) ? {5'd0, packet_error} : (part_3 + {5'd0, packet_error});
            void_3 <= clear_errors | (void_3 & ~visits_3);
            part_4 <= (visits_4 | clear_errors) ? part_4_sum : (part_4 + part_4_sum);
            void_4 <= clear_errors | (void_4 & ~visits_4);
            part_5 <= (visits_5 | start) ? {5'd0, busy} : (part_5 + {5'd0, busy});
            void_5 <= start | (void_5 & ~visits_5);
            part_6 <= (visits_6 | start) ? part_6_bits : (part_6 + part_6_bits);
            void_6 <= start | (void_6 & ~visits_6);
            part_7 <= (visits_7 | start) ? part_7_bits : (part_7 + part_7_bits);
            void_7 <= start | (void_7 & ~visits_7);
            part_8 <= (visits_8 | start) ? part_8_bits : (part_8 + part_8_bits);
            void_8 <= start | (void_8 & ~visits_8);
            part_9 <= (visits_9 | start) ? part_9_bits : (part_9 + part_9_bits);
            void_9 <= start | (void_9 & ~visits_9);
            part_10 <= (visits_10 | start) ? part_10_bits : (part_10 + part_10_bits);
            void_10 <= start | (void_10 & ~visits_10);
            part_11 <= (visits_11 | start) ? part_11_bits : (part_11 + part_11_bits);
            void_11 <= start | (void_11 & ~visits_11);
            part_12 <= (visits_12 | start) ? part_12_bits : (part_12 + part_12_bits);
            void_12 <= start | (void_12 & ~visits_12);
            part_13 <= (visits_13 | start) ? part_13_bits : (part_13 + part_13_bits);
            void_13 <= start | (void_13 & ~visits_13);
            part_14 <= (visits_14 | start) ? part_14_bits : (part_14 + part_14_bits);
            void_14 <= start | (void_14 & ~visits_14);
            part_15 <= (visits_15 | start) ? part_15_bits : (part_15 + part_15_bits);
            void_15 <= start | (void_15 & ~visits_15);
            part_16 <= (visits_16 | start) ? part_16_bits : (part_16 + part_16_bits);
            void_16 <= start | (void_16 & ~visits_16);
            part_17 <= (visits_17 | start) ? part_17_bits : (part_17 + part_17_bits);
            void_17 <= start | (void_17 & ~visits_17);
            part_18 <= (visits_18 | start) ? part_18_bits : (part_18 + part_18_bits);
            void_18 <= start | (void_18 & ~visits_18);
            part_19 <= (visits_19 | start) ? part_19_bits : (part_19 + part_19_bits);
            void_19 <= start | (void_19 & ~visits_19);
            read_valid <= adds & for_read;
            s_axil_rvalid <= answers | (s_axil_rvalid & ~s_axil_rready);
            irq <= done & interrupt_enable_bits;
            if (write_accepted & write_address_11_2_is_3) interrupt_enable_bits <= write_data[0];
            if (write_accepted & write_address_11_2_is_32) points_base_bits <= write_data[31:12];
            if (write_accepted & write_address_11_2_is_33) tree_base_bits <= write_data[31:12];
            if (write_accepted & write_address_11_2_is_34) queries_bits <= write_data;
            if (write_accepted & write_address_11_2_is_35) cache_ball_bits <= write_data[0];
            if (write_accepted & write_address_11_2_is_36) cache_far_scale_bits <= write_data;
            if (write_accepted & write_address_11_2_is_37) cache_margin_scale_bits <= write_data;
            if (adds) begin
                visited <= turns_aside ? found[4:0] : round;
                for_read <= turns_aside;
            end
            if (adds & ~turns_aside) round <= (round == 5'd19) ? 5'd0 : (round + 5'd1);
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
        part <= visited[4] ? part_choice_2 : part_choice_7;
        is_void <= visited[4] ? (visited[3] ? void_19 : visited[2] ? void_19 : is_void_choice) : is_void_choice_6;
        read_value <= saturated;
        if (answers) begin
            s_axil_rdata <= asks ? read_value : (s_axil_rdata_either_8 & {32{~refused_read}});
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
    wire [8:0] part_2_plus_part_2_sum = {1'd0, part_2} + {1'd0, part_2_sum};
    wire [6:0] part_3_plus_packet_error = {1'd0, part_3} + {6'd0, packet_error};
    wire [7:0] part_4_plus_part_4_sum = {1'd0, part_4} + {1'd0, part_4_sum};
    wire [6:0] part_5_plus_busy = {1'd0, part_5} + {6'd0, busy};
    wire [6:0] check_sum = {1'd0, part_6} + {6'd0, packet_taken_and_busy};
    wire [6:0] check_sum_2 = {1'd0, part_7} + {6'd0, packet_sent_and_busy};
    wire [6:0] check_sum_3 = {1'd0, part_8} + {6'd0, event_node_and_busy};
    wire [6:0] part_9_plus_event_pop_and_busy = {1'd0, part_9} + {6'd0, event_pop_and_busy};
    wire [6:0] check_sum_4 = {1'd0, part_10} + {6'd0, event_beat_and_busy};
    wire [6:0] check_sum_5 = {1'd0, part_11} + {6'd0, event_insert_and_busy};
    wire [6:0] check_sum_6 = {1'd0, part_12} + {6'd0, event_insert_wait_and_busy};
    wire [6:0] check_sum_7 = {1'd0, part_13} + {6'd0, event_thread_wait_and_busy};
    wire [6:0] check_sum_8 = {1'd0, part_14} + {6'd0, event_point_hit_and_busy};
    wire [6:0] check_sum_9 = {1'd0, part_15} + {6'd0, event_point_miss_and_busy};
    wire [6:0] check_sum_10 = {1'd0, part_16} + {6'd0, event_tree_hit_and_busy};
    wire [6:0] check_sum_11 = {1'd0, part_17} + {6'd0, event_tree_miss_and_busy};
    wire [6:0] check_sum_12 = {1'd0, part_18} + {6'd0, event_cache_hit_and_busy};
    wire [6:0] check_sum_13 = {1'd0, part_19} + {6'd0, event_cache_miss_and_busy};

    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        part_0_has_room: assert (~part_0_plus_part_0_sum[7]);
        part_1_has_room: assert (~part_1_plus_refused_busy[6]);
        part_2_has_room: assert (~part_2_plus_part_2_sum[8]);
        part_3_has_room: assert (~part_3_plus_packet_error[6]);
        part_4_has_room: assert (~part_4_plus_part_4_sum[7]);
        part_5_has_room: assert (~part_5_plus_busy[6]);
        part_6_has_room: assert (~check_sum[6]);
        part_7_has_room: assert (~check_sum_2[6]);
        part_8_has_room: assert (~check_sum_3[6]);
        part_9_has_room: assert (~part_9_plus_event_pop_and_busy[6]);
        part_10_has_room: assert (~check_sum_4[6]);
        part_11_has_room: assert (~check_sum_5[6]);
        part_12_has_room: assert (~check_sum_6[6]);
        part_13_has_room: assert (~check_sum_7[6]);
        part_14_has_room: assert (~check_sum_8[6]);
        part_15_has_room: assert (~check_sum_9[6]);
        part_16_has_room: assert (~check_sum_10[6]);
        part_17_has_room: assert (~check_sum_11[6]);
        part_18_has_room: assert (~check_sum_12[6]);
        part_19_has_room: assert (~check_sum_13[6]);
`else
        if (!(~part_0_plus_part_0_sum[7])) begin
            $display("assertion failed: part_0_has_room in %m"); $stop;
        end
        if (!(~part_1_plus_refused_busy[6])) begin
            $display("assertion failed: part_1_has_room in %m"); $stop;
        end
        if (!(~part_2_plus_part_2_sum[8])) begin
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
        if (!(~part_9_plus_event_pop_and_busy[6])) begin
            $display("assertion failed: part_9_has_room in %m"); $stop;
        end
        if (!(~check_sum_4[6])) begin $display("assertion failed: part_10_has_room in %m"); $stop; end
        if (!(~check_sum_5[6])) begin $display("assertion failed: part_11_has_room in %m"); $stop; end
        if (!(~check_sum_6[6])) begin $display("assertion failed: part_12_has_room in %m"); $stop; end
        if (!(~check_sum_7[6])) begin $display("assertion failed: part_13_has_room in %m"); $stop; end
        if (!(~check_sum_8[6])) begin $display("assertion failed: part_14_has_room in %m"); $stop; end
        if (!(~check_sum_9[6])) begin $display("assertion failed: part_15_has_room in %m"); $stop; end
        if (!(~check_sum_10[6])) begin $display("assertion failed: part_16_has_room in %m"); $stop; end
        if (!(~check_sum_11[6])) begin $display("assertion failed: part_17_has_room in %m"); $stop; end
        if (!(~check_sum_12[6])) begin $display("assertion failed: part_18_has_room in %m"); $stop; end
        if (!(~check_sum_13[6])) begin $display("assertion failed: part_19_has_room in %m"); $stop; end
`endif
    end

    wire _unused_by_checks = &{
        1'b0, check_sum[5:0], check_sum_10[5:0], check_sum_11[5:0], check_sum_12[5:0], check_sum_13[5:0],
        check_sum_2[5:0], check_sum_3[5:0], check_sum_4[5:0], check_sum_5[5:0], check_sum_6[5:0],
        check_sum_7[5:0], check_sum_8[5:0], check_sum_9[5:0], part_0_plus_part_0_sum[6:0],
        part_1_plus_refused_busy[5:0], part_2_plus_part_2_sum[7:0], part_3_plus_packet_error[5:0],
        part_4_plus_part_4_sum[6:0], part_5_plus_busy[5:0], part_9_plus_event_pop_and_busy[5:0]
    };
`endif
endmodule
