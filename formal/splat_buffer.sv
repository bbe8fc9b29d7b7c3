// splat_buffer: no burst of a read is asked for before all writes handed over before that read are answered; reads and writes go to the
// addresses of their pixels; neither is held longer than memory and core need to take and answer what is under way.
//
// Assumed: the core and the memory hold what they offer; a read stays within a row of so many pixels, and where a row takes several
// bursts it is of all of the row; the base is a multiple of 4,096, and may change at any time. The memory answers
// each write once, in any order, even before it has taken all of it (but not with WAITS); other reads and writes, and the data that
// answer reads, are free.
module proof (input clk);
    `include "sizes.vh"
    `include "record.vh"
    localparam BYTES = BITS / 8;
    localparam STRIDE = BEATS * BYTES;
    localparam RUN_BYTES = RUN_PIXELS * STRIDE;
    // A row begins at a multiple of its size: a read of all of it takes bursts of the same length.
    localparam CHUNK_BYTES = 256 * BYTES < 4096 ? 256 * BYTES : 4096;
    localparam BURST_BYTES = RUN_BYTES < CHUNK_BYTES ? RUN_BYTES : CHUNK_BYTES;
    localparam BURSTS = RUN_BYTES / BURST_BYTES;
    localparam COUNT_BITS = $clog2(LIMIT + 4 * BURSTS);

    reg rst = 1;
    always @(posedge clk) rst <= 0;

    (* anyseq *) reg read_valid, write_valid, write_c, data_ready;
    (* anyseq *) reg m_axi_awready, m_axi_wready, m_axi_bvalid, m_axi_arready, m_axi_rvalid, m_axi_rlast;
    (* anyseq *) reg [31:0] base;
    (* anyseq *) reg [TILE_BITS-1:0] read_tile, write_tile;
    (* anyseq *) reg [PIXEL_BITS-1:0] read_pixel, write_pixel;
    (* anyseq *) reg [RUN_BITS-1:0] read_count;
    (* anyseq *) reg [2:0] write_a;
    (* anyseq *) reg [19:0] write_b;
    (* anyseq *) reg [8:0] write_d;
    (* anyseq *) reg [BITS-1:0] m_axi_rdata;
    (* anyseq *) reg [1:0] m_axi_bresp, m_axi_rresp;
    (* anyseq *) reg [3:0] m_axi_bid, m_axi_rid;
    wire read_ready, write_ready, data_valid, data_c;
    wire m_axi_awvalid, m_axi_wvalid, m_axi_wlast, m_axi_bready, m_axi_arvalid, m_axi_rready;
    wire [31:0] m_axi_awaddr, m_axi_araddr;
    wire [7:0] m_axi_awlen, m_axi_arlen;
    wire [2:0] m_axi_awsize, m_axi_arsize, data_a;
    wire [1:0] m_axi_awburst, m_axi_arburst;
    wire [3:0] m_axi_awid, m_axi_arid;
    wire [BITS-1:0] m_axi_wdata;
    wire [BYTES-1:0] m_axi_wstrb;
    wire [19:0] data_b;
    wire [8:0] data_d;
    `UNIT unit (.*);

    wire read = read_valid && read_ready;
    wire written = write_valid && write_ready;
    wire addressed = m_axi_awvalid && m_axi_awready;
    wire beat = m_axi_wvalid && m_axi_wready;
    wire answered = m_axi_bvalid && m_axi_bready;
    wire asked = m_axi_arvalid && m_axi_arready;
    wire data_beat = m_axi_rvalid && m_axi_rready;
    axi_channel #(.WIDTH(TILE_BITS + PIXEL_BITS + RUN_BITS)) reads (clk, rst, read_valid, read_ready, {read_tile, read_pixel, read_count});
    axi_channel #(.WIDTH(TILE_BITS + PIXEL_BITS + 33)) writes (
        clk, rst, write_valid, write_ready, {write_tile, write_pixel, write_a, write_b, write_c, write_d}
    );
    axi_channel #(.WIDTH(4 + 2)) write_answers (clk, rst, m_axi_bvalid, m_axi_bready, {m_axi_bid, m_axi_bresp});
    axi_channel #(.WIDTH(BITS + 4 + 3)) data (clk, rst, m_axi_rvalid, m_axi_rready, {m_axi_rdata, m_axi_rid, m_axi_rresp, m_axi_rlast});
    always @* assume (base[11:0] == 0);
    localparam PLACE_BITS = $clog2(RUN_PIXELS);
    wire is_whole_row = read_pixel[PLACE_BITS-1:0] == 0 && read_count == RUN_PIXELS;
    always @* assume (BURSTS > 1 ? is_whole_row : read_count != 0 && read_pixel[PLACE_BITS-1:0] + read_count <= RUN_PIXELS);

    // Writes handed over and not answered; a symbolic one of them, which an answer names or not.
    (* anyseq *) reg follow_write, named;
    reg [COUNT_BITS-1:0] unanswered = 0;
    reg is_open = 0;
    always @* assume (!m_axi_bvalid || (named ? is_open : unanswered > is_open));
    // Bursts of reads handed over and not asked for; those of reads before the symbolic write.
    reg [COUNT_BITS-1:0] unasked = 0, before = 0;
    always @(posedge clk) if (!rst) begin
        unanswered <= unanswered + written - answered;
        unasked <= unasked + (read ? BURSTS : 0) - asked;
        if (!is_open) begin
            is_open <= written && follow_write;
            before <= unasked - asked;
        end else begin
            is_open <= !(answered && named);
            before <= before - (asked && before != 0);
        end
    end
    always @(posedge clk) if (!rst) begin
        no_read_before_the_answer: assert (!(read && is_open));
        no_burst_before_the_answer: assert (!(m_axi_arvalid && is_open && before == 0));
        a_read_for_a_burst: assert (!m_axi_arvalid || unasked != 0);
        no_overflow: assert (!(written && &unanswered) && unasked < 2**COUNT_BITS - BURSTS);
    end

    // A read that waited for the symbolic write comes to memory; one before the symbolic write does while that is open.
    reg waited = 0;
    always @(posedge clk) if (!rst) begin
        if (read_valid && is_open) waited <= 1;
        cover (waited && asked && !is_open);
        cover (is_open && asked);
    end

`ifdef ADDRESSES
    // The first burst of a symbolic read, behind those of `ahead`, asks for its pixels.
    (* anyseq *) reg follow_read;
    reg is_asked_for = 0;
    reg [COUNT_BITS-1:0] ahead = 0;
    reg [31:0] run_address;
    reg [RUN_BITS-1:0] run_count;
    always @(posedge clk) if (!rst) begin
        if (!is_asked_for) begin
            is_asked_for <= read && follow_read;
            ahead <= unasked - asked;
            run_address <= base + (read_tile * TILE_PIXELS + read_pixel) * STRIDE;
            run_count <= read_count;
        end else if (asked) begin
            is_asked_for <= ahead != 0;
            ahead <= ahead - 1;
        end
    end
    wire shows_burst = m_axi_arvalid && is_asked_for && ahead == 0;
    // Addresses of writes leave in their order.
    in_order #(.WIDTH(32), .COUNT_BITS(COUNT_BITS)) pixel_addresses (
        .clk, .rst, .push(written), .pushed(base + (write_tile * TILE_PIXELS + write_pixel) * STRIDE),
        .offered(m_axi_awvalid), .valid(m_axi_awvalid), .ready(m_axi_awready), .shown(m_axi_awaddr)
    );
    always @(posedge clk) if (!rst) begin
        its_pixels: assert (!shows_burst || (m_axi_araddr == run_address && m_axi_arlen == run_count * BEATS - 1));
        cover (shows_burst && ahead != unasked - 1);
    end
`endif

`ifdef WAITS
    // While a read or a write waits no other is handed over, so what is under way gets less with every transfer: it goes on if a
    // transfer is never more than PATIENCE cycles away in which memory and core take what is offered and answer what is owed.
    localparam PATIENCE = 2;
    wire [COUNT_BITS-1:0] addresses_open, ends_open;
    localparam OWED_BITS = $clog2(LIMIT * BURST_BYTES / BYTES + 1) + 1;
    wire [OWED_BITS-1:0] owed;
    axi_write_answers #(.BITS(COUNT_BITS)) write_answers_owed (
        clk, rst, addressed, beat && m_axi_wlast, m_axi_bvalid, answered, addresses_open, ends_open
    );
    axi_read_answers #(.BEAT_BITS(OWED_BITS), .ID_BITS(4)) data_owed (
        .clk, .rst, .asked, .len(m_axi_arlen), .id(m_axi_arid), .valid(m_axi_rvalid), .answered(data_beat), .last(m_axi_rlast),
        .answer_id(m_axi_rid), .owed
    );
    wire read_waits = read_valid && !read_ready;
    wire write_waits = write_valid && !write_ready && !read_valid;
    wire takes = (m_axi_awready || !m_axi_awvalid) && (m_axi_wready || !m_axi_wvalid) && (m_axi_arready || !m_axi_arvalid) && data_ready;
    wire answers = (m_axi_bvalid || addresses_open == 0 || ends_open == 0) && (m_axi_rvalid || owed == 0);
    wire moves = addressed || beat || answered || asked || data_beat || (data_valid && data_ready);
    reg [2:0] stands = 0;
    always @(posedge clk) if (!rst) begin
        stands <= moves || !(read_waits || write_waits) ? 0 : stands + (takes && answers);
        // What is under way is offered, and no more is than may be: with this the solver finds its invariant.
        addresses_are_offered: assert (m_axi_awvalid == (unanswered != addresses_open));
        data_are_offered: assert (m_axi_wvalid == (unanswered != ends_open));
        bursts_are_offered: assert (m_axi_arvalid || unasked <= BURSTS);
        few_owed: assert (owed <= LIMIT * BURST_BYTES / BYTES);
        few_written: assert (addresses_open <= unanswered && ends_open <= unanswered);
        none_goes_before: assert (!(read_valid && written));
        goes_on: assert (stands <= PATIENCE);
        cover (write_waits && unanswered == LIMIT);
        cover (read_waits && unanswered == 0 && unasked > LIMIT * BURSTS);
    end
`endif
endmodule
