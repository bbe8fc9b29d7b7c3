    // The host at the window: bursts wait in queues.
    reg [48:0] burst_address [0:15];
    integer burst_first [0:15];
    reg [31:0] burst_bad_strobes [0:15], burst_bad_last [0:15];
    reg [7:0] burst_strobes [0:15];
    reg [1:0] burst_answer [0:15];
    reg [48:0] burst_read [0:15];
    integer bursts_asked = 0, bursts_addressed = 0, bursts_given = 0, bursts_answered = 0, burst_beat = 0;
    integer bursts_read = 0, reads_begun = 0, reads_ended = 0, read_beat = 0;
    integer bursts_moved = 0, bursts_ended = 0, burst_reads_moved = 0;
    wire window_aw_take, window_w_take, window_ar_take, window_b_moves, window_r_moves;
    wire [31:0] burst_bit = burst_beat < 32 ? 32'd1 << burst_beat : 32'd0;
    wire burst_at_end = burst_beat == burst_address[bursts_given & 15][12:5];
    wire [7:0] strobes = (burst_bad_strobes[bursts_given & 15] & burst_bit) != 0 ? burst_strobes[bursts_given & 15] : 8'hff;
    wire burst_last = burst_at_end ^ ((burst_bad_last[bursts_given & 15] & burst_bit) != 0);
    wire window_idle = bursts_answered == bursts_asked && reads_ended == bursts_read;

    axi_test_source #(.WIDTH(49), .SEED(32'h8008)) window_aw (
        .clk(clk), .rst(rst), .share(share[WINDOW_AW]), .available(bursts_addressed != bursts_asked),
        .item(burst_address[bursts_addressed & 15]), .take(window_aw_take), .valid(s_axi_awvalid), .ready(s_axi_awready),
        .payload({s_axi_awid, window_awaddr, s_axi_awlen, s_axi_awsize, s_axi_awburst})
    );
    axi_test_source #(.WIDTH(73), .SEED(32'h9009)) window_w (
        .clk(clk), .rst(rst), .share(share[WINDOW_W]), .available(bursts_given != bursts_asked),
        .item({words[burst_first[bursts_given & 15] + 2*burst_beat + 1], words[burst_first[bursts_given & 15] + 2*burst_beat], strobes, burst_last}),
        .take(window_w_take), .valid(s_axi_wvalid), .ready(s_axi_wready), .payload({s_axi_wdata, s_axi_wstrb, s_axi_wlast})
    );
    axi_test_sink #(.WIDTH(6), .SEED(32'ha00a)) window_b (
        .clk(clk), .rst(rst), .share(share[WINDOW_B]), .valid(s_axi_bvalid), .ready(s_axi_bready),
        .payload({s_axi_bid, s_axi_bresp}), .moves(window_b_moves)
    );
    axi_test_source #(.WIDTH(49), .SEED(32'hb00b)) window_ar (
        .clk(clk), .rst(rst), .share(share[WINDOW_AR]), .available(reads_begun != bursts_read),
        .item(burst_read[reads_begun & 15]), .take(window_ar_take), .valid(s_axi_arvalid), .ready(s_axi_arready),
        .payload({s_axi_arid, window_araddr, s_axi_arlen, s_axi_arsize, s_axi_arburst})
    );
    axi_test_sink #(.WIDTH(71), .SEED(32'hc00c)) window_r (
        .clk(clk), .rst(rst), .share(share[WINDOW_R]), .valid(s_axi_rvalid), .ready(s_axi_rready),
        .payload({s_axi_rid, s_axi_rdata, s_axi_rresp, s_axi_rlast}), .moves(window_r_moves)
    );

    always @(posedge clk) begin
        if (window_aw_take) bursts_addressed <= bursts_addressed + 1;
        if (!rst && s_axi_awvalid && s_axi_awready) bursts_moved <= bursts_moved + 1;
        if (!rst && s_axi_arvalid && s_axi_arready) burst_reads_moved <= burst_reads_moved + 1;
        if (window_ar_take) reads_begun <= reads_begun + 1;
        if (window_w_take) begin
            burst_beat <= burst_at_end ? 0 : burst_beat + 1;
            if (burst_at_end) bursts_given <= bursts_given + 1;
        end
        if (!rst && s_axi_bvalid && bursts_answered >= bursts_moved) $fatal(1, "FAILED: an answer to no burst");
        if (!rst && s_axi_rvalid && reads_ended >= burst_reads_moved) $fatal(1, "FAILED: an answer to no read burst");
        if (window_b_moves) begin
            bursts_answered <= bursts_answered + 1;
            if ({s_axi_bid, s_axi_bresp} !== {burst_address[bursts_answered & 15][48:45], burst_answer[bursts_answered & 15]})
                $fatal(1, "FAILED: burst %0d at %h is answered %0d, id %0d", bursts_answered, burst_address[bursts_answered & 15],
                    s_axi_bresp, s_axi_bid);
        end
        if (window_r_moves) begin
            if ({s_axi_rid, s_axi_rdata, s_axi_rresp} !== {burst_read[reads_ended & 15][48:45], 64'd0, 2'd2}
                || s_axi_rlast !== (read_beat == burst_read[reads_ended & 15][12:5])) $fatal(1, "FAILED: the answer to a read burst");
            read_beat <= s_axi_rlast ? 0 : read_beat + 1;
            if (s_axi_rlast) reads_ended <= reads_ended + 1;
        end
    end

