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

