// Written by pointcore 0.1.0; do not edit.
// Plays a script at the ports of splat_axi, with models of the buses around it that pause, and compares every answer with what
// the contract and the bit-exact model say. For Verilator, whose registers start at random values.

// verilator lint_off WIDTH
// verilator lint_off UNUSED
// verilator lint_off BLKSEQ

// Offers items on a channel: with pauses, and with noise where nothing is offered.
module axi_test_source #(parameter WIDTH = 1, parameter [31:0] SEED = 1) (
    input  wire clk, input wire rst,
    input  wire [7:0] share,  // Of 256 cycles, those that pause; 255 holds everything back.
    input  wire available, input wire [WIDTH-1:0] item,
    output wire take,  // The item goes on offer.
    output reg  valid, input wire ready, output reg [WIDTH-1:0] payload
);
    localparam WORDS = (WIDTH + 31) / 32;
    reg [31:0] random = SEED;
    wire [31:0] random_1 = random ^ (random << 13);
    wire [31:0] random_2 = random_1 ^ (random_1 >> 17);
    wire [32*WORDS-1:0] noise = {WORDS{random}};
    wire pauses = share != 8'd0 && random[7:0] <= share;
    assign take = !rst && available && !pauses && (!valid || ready);

    always @(posedge clk) begin
        random <= random_2 ^ (random_2 << 5);
        if (rst) valid <= 1'b0;
        else if (!valid || ready) begin
            if (ready === 1'bx) $fatal(1, "FAILED: %m: ready is unknown");
            valid <= take;
            payload <= take ? item : noise[WIDTH-1:0];
        end
    end
endmodule

// Takes what a channel offers, with pauses; what is on offer must stay until it is taken.
module axi_test_sink #(parameter WIDTH = 1, parameter [31:0] SEED = 1) (
    input  wire clk, input wire rst,
    input  wire [7:0] share,
    input  wire valid, output reg ready, input wire [WIDTH-1:0] payload,
    output wire moves  // What is on offer is taken.
);
    reg [31:0] random = SEED;
    wire [31:0] random_1 = random ^ (random << 13);
    wire [31:0] random_2 = random_1 ^ (random_1 >> 17);
    reg was_reset = 1'b0;
    reg waits = 1'b0;
    reg [WIDTH-1:0] offered;
    assign moves = valid && ready && !rst;

    initial ready = 1'b0;
    always @(posedge clk) begin
        random <= random_2 ^ (random_2 << 5);
        ready <= share == 8'd0 || random[7:0] > share;
        was_reset <= rst;
        waits <= valid && !ready && !rst;
        offered <= payload;
        if (was_reset && valid !== 1'b0) $fatal(1, "FAILED: %m: valid during reset");
        if (!rst && (valid === 1'bx || (valid && ^payload === 1'bx))) $fatal(1, "FAILED: %m: unknown values are offered");
        if (!rst && waits && (!valid || payload !== offered)) $fatal(1, "FAILED: %m: an offer was withdrawn or changed");
    end
endmodule

// Memory that is read: takes bursts, and gives their beats late, in their order. Spoils answers where it is told to, and counts that.
module axi_test_reads #(parameter BITS = 64, parameter [31:0] SEED = 1) (
    input  wire clk, input wire rst,
    input  wire [7:0] address_share, input wire [7:0] data_share,
    input  wire [7:0] delay,  // Bits of the random number of cycles before a burst.
    input  wire [7:0] error_share, input wire [7:0] misplaced_share,  // Of 256 beats, those that are spoilt.
    input  wire [31:0] unasked,  // Beats that nobody asked for, so far.
    input  wire arvalid, output wire arready, input wire [3:0] arid, input wire [31:0] araddr,
    input  wire [7:0] arlen, input wire [2:0] arsize, input wire [1:0] arburst,
    output wire rvalid, input wire rready, output wire [3:0] rid, output wire [BITS-1:0] rdata,
    output wire [1:0] rresp, output wire rlast,
    output wire asks,  // A burst is asked for.
    output wire gives, output wire [31:0] address, input wire [BITS-1:0] data,  // The beat that is given.
    output wire idle,
    output reg  [31:0] errors, output reg [31:0] misplaced, output reg [31:0] beats
);
    localparam BYTES = BITS / 8;
    localparam BURSTS_MAX = 16;
    reg [31:0] burst_address [0:31];
    integer burst_beats [0:31];
    integer asked = 0;
    integer given = 0;
    integer beat = 0;
    integer waiting = 0;
    integer unasked_given = 0;
    reg is_wrong = 1'b0;
    reg [31:0] random = ~SEED;
    wire [31:0] random_1 = random ^ (random << 13);
    wire [31:0] random_2 = random_1 ^ (random_1 >> 17);

    wire stray = unasked_given != unasked;
    wire under_way = asked != given && waiting == 0;
    wire at_end = beat + 1 == burst_beats[given & 31];
    wire spoils_response = error_share != 8'd0 && random[15:8] <= error_share;
    wire spoils_last = misplaced_share != 8'd0 && random[23:16] <= misplaced_share;
    wire take;
    assign gives = take && !stray;
    assign address = burst_address[given & 31] + beat * BYTES;
    assign idle = asked == given && !rvalid && !stray;

    axi_test_sink #(.WIDTH(49), .SEED(SEED + 32'd7)) addresses (
        .clk(clk), .rst(rst), .share(address_share), .valid(arvalid), .ready(arready),
        .payload({arid, araddr, arlen, arsize, arburst}), .moves(asks)
    );
    axi_test_source #(.WIDTH(BITS + 7), .SEED(SEED + 32'd9)) answers (
        .clk(clk), .rst(rst), .share(data_share), .available(stray || under_way),
        .item({4'd0, stray ? ~data : data, spoils_response ? {1'b1, random[24]} : 2'd0, at_end ^ spoils_last}),
        .take(take), .valid(rvalid), .ready(rready), .payload({rid, rdata, rresp, rlast})
    );

    initial begin errors = 0; misplaced = 0; beats = 0; end
    always @(posedge clk) begin
        random <= random_2 ^ (random_2 << 5);
        if (rst) begin
            asked <= 0;
            given <= 0;
            beat <= 0;
        end else if (asks) begin
            if (arid != 4'd0 || arsize != $clog2(BYTES) || arburst != 2'd1) $fatal(1, "FAILED: %m: no plain burst");
            if (araddr % BYTES != 0 || araddr[11:0] + (arlen + 1) * BYTES > 4096)
                $fatal(1, "FAILED: %m: a burst of %0d beats at %h", arlen + 1, araddr);
            if (asked - given >= BURSTS_MAX) $fatal(1, "FAILED: %m: too many bursts under way");
            burst_address[asked & 31] <= araddr;
            burst_beats[asked & 31] <= arlen + 1;
            asked <= asked + 1;
        end
        if (waiting != 0) waiting <= waiting - 1;
        if (take) begin
            if (spoils_response) errors <= errors + 1;
            if (stray) begin
                unasked_given <= unasked_given + 1;
                misplaced <= misplaced + 1;
            end else begin
                beats <= beats + 1;
                beat <= at_end ? 0 : beat + 1;
                is_wrong <= !at_end && (is_wrong || spoils_last);
                if (at_end) begin
                    given <= given + 1;
                    waiting <= random[31:24] & delay;
                    if (is_wrong || spoils_last) misplaced <= misplaced + 1;
                end
            end
        end
    end
endmodule

// Memory that is written, a record a burst: tells of a record when its answer goes out, late and in the order of the bursts.
module axi_test_writes #(parameter BITS = 64, parameter BEATS = 1, parameter TILE_BYTES = 64, parameter [31:0] SEED = 1) (
    input  wire clk, input wire rst,
    input  wire [7:0] address_share, input wire [7:0] data_share, input wire [7:0] answer_share,
    input  wire [7:0] error_share,  // Of 256 answers, those that are errors.
    input  wire awvalid, output wire awready, input wire [3:0] awid, input wire [31:0] awaddr,
    input  wire [7:0] awlen, input wire [2:0] awsize, input wire [1:0] awburst,
    input  wire wvalid, output wire wready, input wire [BITS-1:0] wdata, input wire [BITS/8-1:0] wstrb, input wire wlast,
    output wire bvalid, input wire bready, output wire [3:0] bid, output wire [1:0] bresp,
    output wire stores, output wire [31:0] address, output wire [BEATS*BITS-1:0] record,  // A record is answered.
    input  wire reads, input wire [31:0] read_address,  // A burst is asked for, which must find all writes to its tile answered.
    output reg  [31:0] errors, output reg [31:0] records
);
    localparam BYTES = BITS / 8;
    localparam WRITES_MAX = 16;
    reg [31:0] burst_address [0:31];
    reg [BEATS*BITS-1:0] burst_data [0:31];
    reg [BEATS*BITS-1:0] gathered;
    integer addressed = 0;
    integer given = 0;
    integer answered = 0;
    integer beat = 0;
    integer i;
    reg [31:0] random = ~SEED;
    wire [31:0] random_1 = random ^ (random << 13);
    wire [31:0] random_2 = random_1 ^ (random_1 >> 17);
    wire spoils = error_share != 8'd0 && random[15:8] <= error_share;
    wire address_moves, data_moves;
    assign address = burst_address[answered & 31];
    assign record = burst_data[answered & 31];

    axi_test_sink #(.WIDTH(49), .SEED(SEED + 32'd7)) addresses (
        .clk(clk), .rst(rst), .share(address_share), .valid(awvalid), .ready(awready),
        .payload({awid, awaddr, awlen, awsize, awburst}), .moves(address_moves)
    );
    axi_test_sink #(.WIDTH(BITS + BYTES + 1), .SEED(SEED + 32'd9)) data (
        .clk(clk), .rst(rst), .share(data_share), .valid(wvalid), .ready(wready), .payload({wdata, wstrb, wlast}),
        .moves(data_moves)
    );
    axi_test_source #(.WIDTH(6), .SEED(SEED + 32'd11)) answers (
        .clk(clk), .rst(rst), .share(answer_share), .available(answered != addressed && answered != given),
        .item({4'd0, spoils ? {1'b1, random[24]} : 2'd0}), .take(stores), .valid(bvalid), .ready(bready),
        .payload({bid, bresp})
    );

    initial begin errors = 0; records = 0; end
    always @(posedge clk) begin
        random <= random_2 ^ (random_2 << 5);
        if (rst) begin
            addressed <= 0;
            given <= 0;
            answered <= 0;
            beat <= 0;
        end
        if (address_moves) begin
            if (awid != 4'd0 || awsize != $clog2(BYTES) || awburst != 2'd1 || awlen != BEATS - 1 || awaddr % (BEATS * BYTES) != 0)
                $fatal(1, "FAILED: %m: a burst of %0d beats at %h", awlen + 1, awaddr);
            burst_address[addressed & 31] <= awaddr;
            addressed <= addressed + 1;
        end
        if (data_moves) begin
            if (!(&wstrb) || wlast != (beat == BEATS - 1)) $fatal(1, "FAILED: %m: strobes, or the place of the last beat");
            gathered[beat*BITS +: BITS] <= wdata;
            burst_data[given & 31] <= gathered;
            burst_data[given & 31][beat*BITS +: BITS] <= wdata;
            beat <= wlast ? 0 : beat + 1;
            if (wlast) given <= given + 1;
        end
        if (addressed - answered > WRITES_MAX || given - answered > WRITES_MAX) $fatal(1, "FAILED: %m: too many writes under way");
        if (stores) begin
            answered <= answered + 1;
            records <= records + 1;
            if (spoils) errors <= errors + 1;
        end
        for (i = answered; reads && i != addressed; i = i + 1)
            if (burst_address[i & 31] / TILE_BYTES == read_address / TILE_BYTES)
                $fatal(1, "FAILED: %m: a tile is read before a write to it is answered");
    end
endmodule

module splat_axi_test;
    localparam WORDS = 84145, ANSWERS = 76;
    localparam [31:0] MAGIC = 32'h5043a71e;
    localparam FILE = "splat_axi_test.hex";
    localparam STREAM_BITS = 64, MEMORY_BITS = 64, PACKET_WORDS = 8, EVENTS = 6, EVENT_BITS = 1;
    localparam [255:0] NAME_MASK = 256'h000000000000000000000000000000000000000000000000000001f801f80000;
    localparam [31:0] END_MASK = 32'h1;
    localparam TILES = 8192, PIXEL_BEATS = 4;
    localparam [255:0] PIXEL_HELD = 256'hffffffffffffffffffffffffffffffff000fffffffffffff000000000fffffff;
    wire s_axil_awvalid;
    wire s_axil_awready;
    wire [11:0] s_axil_awaddr;
    wire s_axil_wvalid;
    wire s_axil_wready;
    wire [31:0] s_axil_wdata;
    wire [3:0] s_axil_wstrb;
    wire s_axil_bvalid;
    wire s_axil_bready;
    wire [1:0] s_axil_bresp;
    wire s_axil_arvalid;
    wire s_axil_arready;
    wire [11:0] s_axil_araddr;
    wire s_axil_rvalid;
    wire s_axil_rready;
    wire [31:0] s_axil_rdata;
    wire [1:0] s_axil_rresp;
    wire send_tvalid;
    wire send_tready;
    wire [63:0] send_tdata;
    wire send_tlast;
    wire receive_tvalid;
    wire receive_tready;
    wire [63:0] receive_tdata;
    wire receive_tlast;
    wire m_axi_arvalid;
    wire m_axi_arready;
    wire [3:0] m_axi_arid;
    wire [31:0] m_axi_araddr;
    wire [7:0] m_axi_arlen;
    wire [2:0] m_axi_arsize;
    wire [1:0] m_axi_arburst;
    wire m_axi_rvalid;
    wire m_axi_rready;
    wire [3:0] m_axi_rid;
    wire [63:0] m_axi_rdata;
    wire [1:0] m_axi_rresp;
    wire m_axi_rlast;
    wire m_axi_awvalid;
    wire m_axi_awready;
    wire [3:0] m_axi_awid;
    wire [31:0] m_axi_awaddr;
    wire [7:0] m_axi_awlen;
    wire [2:0] m_axi_awsize;
    wire [1:0] m_axi_awburst;
    wire m_axi_wvalid;
    wire m_axi_wready;
    wire [63:0] m_axi_wdata;
    wire [7:0] m_axi_wstrb;
    wire m_axi_wlast;
    wire m_axi_bvalid;
    wire m_axi_bready;
    wire [3:0] m_axi_bid;
    wire [1:0] m_axi_bresp;
    wire irq;
    wire something_moves, memory_idle;
    wire [31:0] all_memory_errors, all_misplaced;
    wire [EVENTS*EVENT_BITS-1:0] events;

    // Channels, as pauses are told by.
    localparam AW = 0, W = 1, B = 2, AR = 3, R = 4, SEND = 5, RECEIVE = 6, READ_ADDRESS = 7, READ_DATA = 8;
    localparam WINDOW_AW = 9, WINDOW_W = 10, WINDOW_B = 11, WINDOW_AR = 12, WINDOW_R = 13, TREE_ADDRESS = 14, TREE_DATA = 15;
    localparam WRITE_ADDRESS = 16, WRITE_DATA = 17, WRITE_ANSWER = 18, CHANNELS = 19;
    // Cycles in which nothing moves before the test counts as stuck, and reads of `status` that find a run under way.
    localparam STUCK_CYCLES = 60000;
    localparam STUCK_POLLS = 20000;

    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [31:0] words [0:WORDS-1];
    reg [7:0] share [0:CHANNELS-1];
    reg [7:0] delay = 8'd0;
    reg [7:0] error_share = 8'd0;
    reg [7:0] misplaced_share = 8'd0;
    reg [7:0] answer_error_share = 8'd0;
    reg [31:0] unasked [0:1];
    reg [31:0] image [0:1];
    integer still = 0;
    reg waits_by_script = 1'b0;
    integer at = 0;

    always #5 clk = !clk;

    always @(posedge clk) begin
        still <= something_moves ? 0 : still + 1;
        if (still > STUCK_CYCLES) $fatal(1, "FAILED: nothing has moved for %0d cycles, at word %0d of the script", still, at);
    end

    // The host at the registers: accesses wait in queues; answers must be as the script has them.
    reg [11:0] write_address [0:63];
    reg [35:0] write_data [0:63];
    reg [2:0] write_answer [0:63];  // Whether a run begins; the response.
    reg [11:0] read_address [0:63];
    reg [9:0] read_answer [0:63];  // What is expected: any value, a counter of the bench's and which; the response.
    reg [31:0] read_value [0:63];
    integer writes_asked = 0, writes_addressed = 0, writes_given = 0, writes_answered = 0;
    integer reads_asked = 0, reads_addressed = 0, reads_answered = 0;
    integer addresses_moved = 0, data_moved = 0, read_addresses_moved = 0;
    reg [31:0] last_value = 32'd0;
    wire aw_take, w_take, ar_take, b_moves, r_moves;
    wire [2:0] expected_answer = write_answer[writes_answered & 63];
    wire [9:0] expected_kind = read_answer[reads_answered & 63];
    reg [31:0] expected_value;

    axi_test_source #(.WIDTH(12), .SEED(32'h1001)) aw (
        .clk(clk), .rst(rst), .share(share[AW]), .available(writes_addressed != writes_asked),
        .item(write_address[writes_addressed & 63]), .take(aw_take), .valid(s_axil_awvalid), .ready(s_axil_awready),
        .payload(s_axil_awaddr)
    );
    axi_test_source #(.WIDTH(36), .SEED(32'h2002)) w (
        .clk(clk), .rst(rst), .share(share[W]), .available(writes_given != writes_asked), .item(write_data[writes_given & 63]),
        .take(w_take), .valid(s_axil_wvalid), .ready(s_axil_wready), .payload({s_axil_wstrb, s_axil_wdata})
    );
    axi_test_sink #(.WIDTH(2), .SEED(32'h3003)) b (
        .clk(clk), .rst(rst), .share(share[B]), .valid(s_axil_bvalid), .ready(s_axil_bready), .payload(s_axil_bresp),
        .moves(b_moves)
    );
    axi_test_source #(.WIDTH(12), .SEED(32'h4004)) ar (
        .clk(clk), .rst(rst), .share(share[AR]), .available(reads_addressed != reads_asked),
        .item(read_address[reads_addressed & 63]), .take(ar_take), .valid(s_axil_arvalid), .ready(s_axil_arready),
        .payload(s_axil_araddr)
    );
    axi_test_sink #(.WIDTH(34), .SEED(32'h5005)) r (
        .clk(clk), .rst(rst), .share(share[R]), .valid(s_axil_rvalid), .ready(s_axil_rready),
        .payload({s_axil_rdata, s_axil_rresp}), .moves(r_moves)
    );

    always @(posedge clk) begin
        if (aw_take) writes_addressed <= writes_addressed + 1;
        if (w_take) writes_given <= writes_given + 1;
        if (ar_take) reads_addressed <= reads_addressed + 1;
        if (!rst && s_axil_awvalid && s_axil_awready) addresses_moved <= addresses_moved + 1;
        if (!rst && s_axil_wvalid && s_axil_wready) data_moved <= data_moved + 1;
        if (!rst && s_axil_arvalid && s_axil_arready) read_addresses_moved <= read_addresses_moved + 1;
        if (!rst && s_axil_bvalid && (writes_answered >= addresses_moved || writes_answered >= data_moved))
            $fatal(1, "FAILED: an answer to no write");
        if (!rst && s_axil_rvalid && reads_answered >= read_addresses_moved) $fatal(1, "FAILED: an answer to no read");
        if (b_moves) begin
            writes_answered <= writes_answered + 1;
            if (s_axil_bresp !== expected_answer[1:0])
                $fatal(1, "FAILED: write %0d, to %h, is answered %0d, not %0d; word %0d", writes_answered,
                    write_address[writes_answered & 63], s_axil_bresp, expected_answer[1:0], at);
        end
        if (r_moves) begin
            reads_answered <= reads_answered + 1;
            last_value <= s_axil_rdata;
            expected_value = read_value[reads_answered & 63] + (expected_kind[2] ? counted(expected_kind[9:4]) : 32'd0);
            if (s_axil_rresp !== expected_kind[1:0] || (!expected_kind[3] && s_axil_rdata !== expected_value))
                $fatal(1, "FAILED: read %0d, of %h, is answered %0d with %h, not %0d with %h; word %0d", reads_answered,
                    read_address[reads_answered & 63], s_axil_rresp, s_axil_rdata, expected_kind[1:0], expected_value, at);
        end
    end

    // The run under way. What a start does shows with its answer; `irq` rises two cycles after the last cycle of a run.
    reg in_run = 1'b0;
    reg [1:0] in_run_before = 2'd0;
    reg saw_answer = 1'b0;
    reg was_reset = 1'b0;
    reg [EVENTS*EVENT_BITS-1:0] events_1, events_2;
    reg [31:0] event_count [0:EVENTS-1];
    reg [31:0] run_cycles = 32'd0;
    reg [31:0] packets_out = 32'd0;
    wire begins_run = s_axil_bvalid && !saw_answer && expected_answer == 3'b100;
    wire was_in_run = in_run_before[1];

    always @(posedge clk) begin
        saw_answer <= s_axil_bvalid && !s_axil_bready;
        was_reset <= rst;
        if (was_reset && irq !== 1'b0) $fatal(1, "FAILED: irq during reset");
        events_1 <= events;
        events_2 <= events_1;
        in_run_before <= {in_run_before[0], begins_run || in_run};
        if (begins_run) begin
            in_run <= 1'b1;
            in_run_before <= 2'b01;
            run_cycles <= 32'd0;
            packets_out <= 32'd0;
            for (int k = 0; k < EVENTS; k = k + 1) event_count[k] <= 32'd0;
        end else if (was_in_run) begin
            run_cycles <= run_cycles + 32'd1;
            for (int k = 0; k < EVENTS; k = k + 1) event_count[k] <= event_count[k] + 32'd0 + events_2[k*EVENT_BITS +: EVENT_BITS];
            if (irq) begin
                in_run <= 1'b0;
                in_run_before <= 2'b00;
            end
        end
        if (received_packet) packets_out <= begins_run ? 32'd1 : packets_out + 32'd1;
        if (rst) in_run <= 1'b0;
    end

    // A counter of the bench's.
    function [31:0] counted(input [5:0] which);
        case (which)
            6'd0: counted = run_cycles;
            6'd1: counted = packets_out;
            6'd2: counted = memory_errors;
            6'd3: counted = memory_misplaced;
            default: counted = event_count[which - 6'd4];
        endcase
    endfunction

    // Packets to the core.
    integer packet_first [0:255];
    integer packet_beats [0:255];
    integer packets_asked = 0, packets_given = 0, packet_beat = 0, held_beat = 0;
    reg holds = 1'b0;
    wire send_take;
    wire [STREAM_BITS-1:0] send_data;
    wire send_last = packet_beat + 1 == packet_beats[packets_given & 255];
    genvar part;
    generate
        for (part = 0; part < STREAM_BITS / 32; part = part + 1) begin : sent
            assign send_data[32*part +: 32] = words[packet_first[packets_given & 255] + packet_beat * (STREAM_BITS / 32) + part];
        end
    endgenerate

    axi_test_source #(.WIDTH(STREAM_BITS + 1), .SEED(32'h6006)) sends (
        .clk(clk), .rst(rst), .share(share[SEND]), .available(packets_given != packets_asked && !(holds && packet_beat >= held_beat)),
        .item({send_last, send_data}), .take(send_take), .valid(send_tvalid), .ready(send_tready),
        .payload({send_tlast, send_tdata})
    );
    always @(posedge clk) begin
        if (send_take) begin
            packet_beat <= send_last ? 0 : packet_beat + 1;
            if (send_last) packets_given <= packets_given + 1;
        end
        // A reset takes back what was to be sent.
        if (rst) begin
            packet_beat <= 0;
            packets_given <= packets_asked;
        end
    end

    // Packets from the core: those of an answer in their order, answers in any order. Some of its bits name the answer, but of a packet
    // that closes a frame, which is the last of it: answers behind it are another frame's.
    integer answer_next [0:ANSWERS-1];
    integer answer_packets [0:ANSWERS-1];
    integer answers = 0, packets_left = 0, packets_received = 0, receive_beat = 0, found, frame_packets;
    reg [32*PACKET_WORDS-1:0] packet;
    reg received_packet = 1'b0;
    reg closes;
    reg [31:0] counts;
    wire receive_moves;
    localparam RECEIVE_BEATS = 32 * PACKET_WORDS / STREAM_BITS;

    axi_test_sink #(.WIDTH(STREAM_BITS + 1), .SEED(32'h7007)) receives (
        .clk(clk), .rst(rst), .share(share[RECEIVE]), .valid(receive_tvalid), .ready(receive_tready),
        .payload({receive_tlast, receive_tdata}), .moves(receive_moves)
    );

    function is_of_answer(input integer next);
        if (((packet[31:0] | words[next]) & END_MASK) != 0) is_of_answer = (packet[31:0] & words[next] & END_MASK) != 0;
        else begin
            is_of_answer = 1'b1;
            for (int k = 0; k < PACKET_WORDS; k = k + 1)
                if (((packet[32*k +: 32] ^ words[next + k]) & NAME_MASK[32*k +: 32]) != 0) is_of_answer = 1'b0;
        end
    endfunction

    task compare;
        begin
            found = -1;
            frame_packets = 0;
            closes = 1'b0;
            for (int k = 0; k < answers && !closes; k = k + 1) if (answer_packets[k] != 0) begin
                if (is_of_answer(answer_next[k])) found = k;
                frame_packets = frame_packets + answer_packets[k];
                closes = (words[answer_next[k]] & END_MASK) != 0;
            end
            if (found < 0) $fatal(1, "FAILED: a packet that must not come: %h", packet);
            else begin
                // Of the packet that closes a frame nothing else counts.
                closes = (words[answer_next[found]] & END_MASK) != 0;
                if (closes && frame_packets != 1) $fatal(1, "FAILED: a frame ends, and %0d packets are missing", frame_packets - 1);
                for (int k = 0; k < PACKET_WORDS; k = k + 1) begin
                    counts = !closes ? ~32'd0 : k == 0 ? END_MASK : 32'd0;
                    if (((packet[32*k +: 32] ^ words[answer_next[found] + k]) & counts) != 0)
                        $fatal(1, "FAILED: word %0d of a packet is %h, not %h", k, packet[32*k +: 32], words[answer_next[found] + k]);
                end
                answer_next[found] = answer_next[found] + PACKET_WORDS;
                answer_packets[found] = answer_packets[found] - 1;
            end
            packets_left = packets_left - 1;
            packets_received = packets_received + 1;
        end
    endtask

    always @(posedge clk) begin
        received_packet <= receive_moves && receive_tlast;
        if (receive_moves) begin
            packet[receive_beat*STREAM_BITS +: STREAM_BITS] = receive_tdata;
            if (receive_tlast != (receive_beat == RECEIVE_BEATS - 1)) $fatal(1, "FAILED: a packet of a wrong length");
            receive_beat <= receive_tlast ? 0 : receive_beat + 1;
            if (receive_tlast) compare;
        end
        if (rst) receive_beat <= 0;
    end

    // The reconstruction buffer: a page for each tile that is written, and which of its pixels have been. A tile that is written has
    // fragments, an answer of its own for each frame.
    localparam PAGES = ANSWERS;
    localparam TILE_BYTES = 64 * PIXEL_BEATS * (MEMORY_BITS / 8);
    reg [31:0] buffer_base = 32'd0;
    reg [PIXEL_BEATS*MEMORY_BITS-1:0] pixels [0:64*PAGES-1];
    reg [64*PAGES-1:0] is_written = 0;
    integer page_tile [0:PAGES-1];
    integer pages = 0;
    integer page, i_page;
    wire m_axi_asks, m_axi_gives, m_axi_idle, stores;
    wire [31:0] m_axi_address, m_axi_errors, m_axi_misplaced, m_axi_beats, store_address, write_errors, records_written;
    wire [PIXEL_BEATS*MEMORY_BITS-1:0] record;
    wire [31:0] store_place = store_address - buffer_base;
    wire [31:0] read_place = m_axi_address - buffer_base;
    wire [31:0] read_pixel = read_place % TILE_BYTES / (PIXEL_BEATS * (MEMORY_BITS / 8));
    wire [31:0] read_part = read_place / (MEMORY_BITS / 8) % PIXEL_BEATS;
    integer read_page;
    always @* begin
        read_page = -1;
        for (i_page = 0; i_page < pages; i_page = i_page + 1)
            if (page_tile[i_page] == read_place / TILE_BYTES) read_page = i_page;
    end
    wire [PIXEL_BEATS*MEMORY_BITS-1:0] read_record = pixels[read_page < 0 ? 0 : 64 * read_page + read_pixel];

    axi_test_reads #(.BITS(MEMORY_BITS), .SEED(32'hd00d)) m_axi_reads (
        .clk(clk), .rst(rst), .address_share(share[READ_ADDRESS]), .data_share(share[READ_DATA]), .delay(delay),
        .error_share(error_share), .misplaced_share(misplaced_share), .unasked(unasked[0]),
        .arvalid(m_axi_arvalid), .arready(m_axi_arready), .arid(m_axi_arid), .araddr(m_axi_araddr), .arlen(m_axi_arlen),
        .arsize(m_axi_arsize), .arburst(m_axi_arburst), .rvalid(m_axi_rvalid), .rready(m_axi_rready), .rid(m_axi_rid),
        .rdata(m_axi_rdata), .rresp(m_axi_rresp), .rlast(m_axi_rlast), .asks(m_axi_asks), .gives(m_axi_gives),
        .address(m_axi_address), .data(read_record[read_part*MEMORY_BITS +: MEMORY_BITS]), .idle(m_axi_idle),
        .errors(m_axi_errors), .misplaced(m_axi_misplaced), .beats(m_axi_beats)
    );
    axi_test_writes #(.BITS(MEMORY_BITS), .BEATS(PIXEL_BEATS), .TILE_BYTES(TILE_BYTES), .SEED(32'he00e)) m_axi_writes (
        .clk(clk), .rst(rst), .address_share(share[WRITE_ADDRESS]), .data_share(share[WRITE_DATA]),
        .answer_share(share[WRITE_ANSWER]), .error_share(answer_error_share),
        .awvalid(m_axi_awvalid), .awready(m_axi_awready), .awid(m_axi_awid), .awaddr(m_axi_awaddr), .awlen(m_axi_awlen),
        .awsize(m_axi_awsize), .awburst(m_axi_awburst), .wvalid(m_axi_wvalid), .wready(m_axi_wready), .wdata(m_axi_wdata),
        .wstrb(m_axi_wstrb), .wlast(m_axi_wlast), .bvalid(m_axi_bvalid), .bready(m_axi_bready), .bid(m_axi_bid),
        .bresp(m_axi_bresp), .stores(stores), .address(store_address), .record(record),
        .reads(m_axi_asks), .read_address(m_axi_araddr), .errors(write_errors), .records(records_written)
    );

    always @(posedge clk) begin
        if (m_axi_gives && (read_place >= TILES * TILE_BYTES || read_page < 0 || !is_written[64 * read_page + read_pixel]))
            $fatal(1, "FAILED: %h is read, which has not been written", m_axi_address);
        if (stores) begin
            if ((record & ~PIXEL_HELD) != 0) $fatal(1, "FAILED: %h is written, and not zero where a pixel holds nothing", record);
            if (store_place >= TILES * TILE_BYTES) $fatal(1, "FAILED: %h is written, outside the buffer", store_address);
            page = -1;
            for (i_page = 0; i_page < pages; i_page = i_page + 1)
                if (page_tile[i_page] == store_place / TILE_BYTES) page = i_page;
            if (page < 0) begin
                if (pages == PAGES) $fatal(1, "FAILED: more tiles are written than there are");
                page = pages;
                page_tile[page] = store_place / TILE_BYTES;
                pages = pages + 1;
            end
            pixels[64 * page + store_place % TILE_BYTES / (TILE_BYTES / 64)] <= record;
            is_written[64 * page + store_place % TILE_BYTES / (TILE_BYTES / 64)] <= 1'b1;
        end
    end

    wire window_idle = 1'b1;
    assign something_moves = b_moves || r_moves || send_take || receive_moves || waits_by_script || stores || m_axi_gives;
    assign memory_idle = m_axi_idle;
    assign all_memory_errors = m_axi_errors + write_errors;
    assign all_misplaced = m_axi_misplaced;

    splat_axi dut (
        .clk(clk), .rst(rst),
        .s_axil_awvalid(s_axil_awvalid),
        .s_axil_awready(s_axil_awready),
        .s_axil_awaddr(s_axil_awaddr),
        .s_axil_wvalid(s_axil_wvalid),
        .s_axil_wready(s_axil_wready),
        .s_axil_wdata(s_axil_wdata),
        .s_axil_wstrb(s_axil_wstrb),
        .s_axil_bvalid(s_axil_bvalid),
        .s_axil_bready(s_axil_bready),
        .s_axil_bresp(s_axil_bresp),
        .s_axil_arvalid(s_axil_arvalid),
        .s_axil_arready(s_axil_arready),
        .s_axil_araddr(s_axil_araddr),
        .s_axil_rvalid(s_axil_rvalid),
        .s_axil_rready(s_axil_rready),
        .s_axil_rdata(s_axil_rdata),
        .s_axil_rresp(s_axil_rresp),
        .s_axis_splat_tvalid(send_tvalid),
        .s_axis_splat_tready(send_tready),
        .s_axis_splat_tdata(send_tdata),
        .s_axis_splat_tlast(send_tlast),
        .m_axis_fragment_tvalid(receive_tvalid),
        .m_axis_fragment_tready(receive_tready),
        .m_axis_fragment_tdata(receive_tdata),
        .m_axis_fragment_tlast(receive_tlast),
        .m_axi_arvalid(m_axi_arvalid),
        .m_axi_arready(m_axi_arready),
        .m_axi_arid(m_axi_arid),
        .m_axi_araddr(m_axi_araddr),
        .m_axi_arlen(m_axi_arlen),
        .m_axi_arsize(m_axi_arsize),
        .m_axi_arburst(m_axi_arburst),
        .m_axi_rvalid(m_axi_rvalid),
        .m_axi_rready(m_axi_rready),
        .m_axi_rid(m_axi_rid),
        .m_axi_rdata(m_axi_rdata),
        .m_axi_rresp(m_axi_rresp),
        .m_axi_rlast(m_axi_rlast),
        .m_axi_awvalid(m_axi_awvalid),
        .m_axi_awready(m_axi_awready),
        .m_axi_awid(m_axi_awid),
        .m_axi_awaddr(m_axi_awaddr),
        .m_axi_awlen(m_axi_awlen),
        .m_axi_awsize(m_axi_awsize),
        .m_axi_awburst(m_axi_awburst),
        .m_axi_wvalid(m_axi_wvalid),
        .m_axi_wready(m_axi_wready),
        .m_axi_wdata(m_axi_wdata),
        .m_axi_wstrb(m_axi_wstrb),
        .m_axi_wlast(m_axi_wlast),
        .m_axi_bvalid(m_axi_bvalid),
        .m_axi_bready(m_axi_bready),
        .m_axi_bid(m_axi_bid),
        .m_axi_bresp(m_axi_bresp),
        .irq(irq)
    );
    assign events = {dut.core.event_slot_wait, dut.core.event_hazard, dut.core.event_accumulate, dut.core.event_blocked, dut.core.event_starved, dut.core.event_sample};


    localparam PIXEL_WIDTH = 208;
    reg [PIXEL_WIDTH-1:0] kept [int];

    // What the core reads of a pixel is what it wrote there last, whatever buses and memory did to it in between.
    reg [PIXEL_WIDTH-1:0] data_expected [0:255];
    integer data_asked = 0, data_taken = 0, data_i;
    always @(posedge clk) begin
        if (dut.core.rst) begin
            data_asked = 0;
            data_taken = 0;
        end else begin
            if (dut.core.write_valid && dut.core.write_ready)
                kept[{dut.core.write_surface, dut.core.write_tile, dut.core.write_pixel}] = {dut.core.write_weight, dut.core.write_depth, dut.core.write_peak, dut.core.write_attribute_0, dut.core.write_attribute_1, dut.core.write_attribute_2, dut.core.write_attribute_3, dut.core.write_attribute_4, dut.core.write_attribute_5, dut.core.write_cardinal_0};
            if (dut.core.read_valid && dut.core.read_ready)
                for (data_i = 0; data_i < dut.core.read_count; data_i = data_i + 1) begin
                    data_expected[data_asked & 255] = kept[{dut.core.read_surface, dut.core.read_tile, dut.core.read_pixel} + data_i];
                    data_asked = data_asked + 1;
                end
            if (dut.core.data_valid && dut.core.data_ready) begin
                if (data_taken == data_asked || {dut.core.data_weight, dut.core.data_depth, dut.core.data_peak, dut.core.data_attribute_0, dut.core.data_attribute_1, dut.core.data_attribute_2, dut.core.data_attribute_3, dut.core.data_attribute_4, dut.core.data_attribute_5, dut.core.data_cardinal_0} != data_expected[data_taken & 255])
                    $fatal(1, "FAILED: the core reads %h, and wrote %h", {dut.core.data_weight, dut.core.data_depth, dut.core.data_peak, dut.core.data_attribute_0, dut.core.data_attribute_1, dut.core.data_attribute_2, dut.core.data_attribute_3, dut.core.data_attribute_4, dut.core.data_attribute_5, dut.core.data_cardinal_0}, data_expected[data_taken & 255]);
                data_taken = data_taken + 1;
            end
        end
    end
    // The script. What it hands to the channels shows in the next cycle.
    reg [31:0] word, value;
    integer polls = 0, polls_before = 0;
    integer packets_dropped = 0;
    reg [31:0] errors_before = 32'd0, misplaced_before = 32'd0;
    wire [31:0] memory_errors = all_memory_errors - errors_before;
    wire [31:0] memory_misplaced = all_misplaced - misplaced_before;
    wire registers_idle = writes_answered == writes_asked && reads_answered == reads_asked;
    wire all_sent = packets_given == packets_asked && !send_tvalid;

    // What the script hands over, and a clock later the channels have.
    reg [7:0] mail = 8'd0;
    reg [31:0] mail_word, mail_value;
    reg [9:0] mail_answer;
    integer mail_at;

    always @(posedge clk) begin
        case (mail)
            8'd1: share[mail_word[15:8]] <= mail_word[23:16];
            8'd3: begin
                write_address[writes_asked & 63] <= mail_word[19:8];
                write_data[writes_asked & 63] <= {mail_word[23:20], mail_value};
                write_answer[writes_asked & 63] <= mail_word[26:24];
                writes_asked <= writes_asked + 1;
            end
            8'd4: begin
                read_address[reads_asked & 63] <= mail_word[19:8];
                read_answer[reads_asked & 63] <= mail_answer;
                read_value[reads_asked & 63] <= mail_value;
                reads_asked <= reads_asked + 1;
            end
            8'd7: begin
                packet_first[packets_asked & 255] <= mail_value;
                packet_beats[packets_asked & 255] <= mail_word[31:8];
                packets_asked <= packets_asked + 1;
            end
            8'd15: unasked[mail_word[8]] <= unasked[mail_word[8]] + mail_word[31:16];
            8'd21: begin
                image[0] <= words[mail_at];
                image[1] <= words[mail_at + 1];
            end
            default: ;
        endcase
    end

    task post(input [7:0] operation);
        begin
            mail <= operation;
            @(negedge clk);
            mail <= 8'd0;
        end
    endtask

    task push_write(input [11:0] address, input [31:0] data, input [3:0] strb, input [2:0] answer);
        begin
            while (writes_asked - writes_answered >= 32) @(negedge clk);
            mail_word <= {5'd0, answer, strb, address, 8'd3};
            mail_value <= data;
            post(8'd3);
        end
    endtask

    task push_read(input [11:0] address, input [9:0] answer, input [31:0] expected);
        begin
            while (reads_asked - reads_answered >= 32) @(negedge clk);
            mail_word <= {12'd0, address, 8'd4};
            mail_answer <= answer;
            mail_value <= expected;
            post(8'd4);
        end
    endtask

    // Hands the operation over as it is.
    task pass;
        begin
            mail_word <= word;
            mail_value <= value;
            mail_at <= at;
            post(word[7:0]);
        end
    endtask

    task poll;
        begin
            push_read(12'h008, 10'b1000, 32'd0);
            polls = polls + 1;
            if (polls - polls_before > STUCK_POLLS) $fatal(1, "FAILED: status stays %h", last_value);
            settle;
        end
    endtask

    // What was asked for in this cycle shows in the next.
    task settle;
        begin
            @(negedge clk);
            while (!registers_idle || !window_idle) @(negedge clk);
        end
    endtask

    task next(output [31:0] operand);
        begin
            operand = words[at];
            at = at + 1;
        end
    endtask

    task step;
        begin
            next(word);
            case (word[7:0])
                8'd1: pass;  // Pauses of a channel.
                8'd2: begin  // Wait.
                    waits_by_script <= 1'b1;
                    repeat (word[31:8]) @(negedge clk);
                    waits_by_script <= 1'b0;
                end
                8'd3: begin  // Write.
                    next(value);
                    push_write(word[19:8], value, word[23:20], word[26:24]);
                end
                8'd4: begin  // Read.
                    next(value);
                    push_read(word[19:8], {6'd0, 2'b00, word[25:24]}, value);
                end
                8'd5: begin  // Read a counter that the bench counts, too; a number is added.
                    next(value);
                    push_read(word[19:8], {word[25:20], 4'b0100}, value);
                end
                8'd6: settle;
                8'd7: begin  // Send a packet.
                    next(value);
                    while (packets_asked - packets_given >= 255) @(negedge clk);
                    pass;
                end
                8'd8: begin  // Wait until all packets are taken.
                    @(negedge clk);
                    while (!all_sent) @(negedge clk);
                end
                8'd9: begin  // Expect packets; what is missing of those before will not come.
                    packets_dropped = packets_dropped + packets_left;
                    answers = word[31:8];
                    packets_left = 0;
                    for (int k = 0; k < answers; k = k + 1) begin
                        answer_next[k] = words[at];
                        answer_packets[k] = words[at + 1];
                        packets_left = packets_left + words[at + 1];
                        at = at + 2;
                    end
                end
                8'd10: while (packets_left > word[31:8]) @(negedge clk);
                8'd11: begin  // Wait for the interrupt, which comes after some cycles in which nothing moves.
                    while (!irq) @(negedge clk);
                    if (still < word[31:8]) $fatal(1, "FAILED: irq is high %0d cycles after something moved; word %0d", still, at);
                end
                8'd12: begin  // Hold packets from a beat on.
                    holds <= word[8];
                    held_beat <= word[31:16];
                end
                8'd13: delay <= word[15:8];
                8'd14: {answer_error_share, misplaced_share, error_share} <= word[31:8];
                8'd15: begin  // Beats that nobody asked for.
                    pass;
                    @(negedge clk);
                    while (!memory_idle) @(negedge clk);
                end
                8'd16: begin  // Wait until bits of `status` are low.
                    settle;
                    polls_before = polls;
                    poll;
                    while ((last_value[3:0] & word[11:8]) != 0) poll;
                end
                8'd17: if (irq !== word[8]) $fatal(1, "FAILED: irq is %b; word %0d", irq, at);
                8'd18: begin  // Reset.
                    rst <= 1'b1;
                    repeat (word[31:8]) @(negedge clk);
                    rst <= 1'b0;
                end
                8'd19: begin  // Writes that are refused: from a word to another.
                    next(value);
                    for (int k = word[19:8]; k <= word[31:20]; k = k + 4) push_write(k, value, 4'hf, 3'd2);
                end
                8'd20: for (int k = word[19:8]; k <= word[31:20]; k = k + 4) push_read(k, 10'd2, 32'd0);
                8'd21: begin  // Contents of memory.
                    pass;
                    at = at + 2;
                end
                8'd22: begin  // Nothing more may be offered or taken.
                    settle;
                    if (send_tready || packets_left != word[31:8] || !memory_idle) $fatal(1, "FAILED: something is left over; word %0d", at);
                end
                8'd23: begin  // Error counters have been cleared.
                    errors_before <= all_memory_errors;
                    misplaced_before <= all_misplaced;
                end
                8'd24: rst <= 1'b1;  // Reset, until it ends.
                8'd34: begin  // Place an empty buffer.
                    buffer_base <= words[at];
                    pages = 0;
                    is_written = 0;
                    at = at + 1;
                end
                default: $fatal(1, "FAILED: the script has no operation %0d at word %0d", word[7:0], at - 1);
            endcase
        end
    endtask

    always begin
        for (int k = 0; k < CHANNELS; k = k + 1) share[k] = 8'd0;
        for (int k = 0; k < 2; k = k + 1) begin
            unasked[k] = 32'd0;
            image[k] = 32'd0;
        end
        for (int k = 0; k < EVENTS; k = k + 1) event_count[k] = 32'd0;
        $readmemh(FILE, words);
        if (words[0] !== MAGIC) $fatal(1, "FAILED: %s is missing or another's", FILE);
        at = words[1];
        repeat (4) @(negedge clk);
        rst = 1'b0;
        @(negedge clk);
        while (words[at] != 32'd0) begin
            step;
            @(negedge clk);
        end
        settle;
        if (writes_answered != words[at + 1] || reads_answered - polls != words[at + 2] || packets_given != words[at + 3] || packets_received + packets_dropped != words[at + 4])
            $fatal(1, "FAILED: %0d writes, %0d reads, %0d packets sent, %0d received", writes_answered, reads_answered, packets_given, packets_received);
        $display("PASSED: %0d writes and %0d reads of registers, %0d packets in, %0d packets out", writes_answered, reads_answered, packets_given, packets_received);
        $finish;
        forever @(negedge clk);
    end
endmodule
