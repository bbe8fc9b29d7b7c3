// bus_window: an accepted write burst writes each beat once at its index, a refused one nothing; every burst is answered once, in full.
//
// Assumed: the host holds what it offers. Its bursts may be of any kind, with any strobes and `wlast`.
module proof (input clk);
    `include "sizes.vh"

    reg rst = 1;
    always @(posedge clk) rst <= 0;

    (* anyseq *) reg s_axi_awvalid, s_axi_wvalid, s_axi_wlast, s_axi_bready, s_axi_arvalid, s_axi_rready, locked;
    (* anyseq *) reg [ADDRESS_BITS-1:0] s_axi_awaddr, s_axi_araddr;
    (* anyseq *) reg [7:0] s_axi_awlen, s_axi_arlen;
    (* anyseq *) reg [2:0] s_axi_awsize, s_axi_arsize;
    (* anyseq *) reg [1:0] s_axi_awburst, s_axi_arburst;
    (* anyseq *) reg [3:0] s_axi_awid, s_axi_arid;
    (* anyseq *) reg [63:0] s_axi_wdata;
    (* anyseq *) reg [7:0] s_axi_wstrb;
    wire s_axi_awready, s_axi_wready, s_axi_bvalid, s_axi_arready, s_axi_rvalid, s_axi_rlast;
    wire [1:0] s_axi_bresp, s_axi_rresp;
    wire [3:0] s_axi_bid, s_axi_rid;
    wire [63:0] s_axi_rdata;
    wire write_valid, refused_burst, refused_busy, occupied;
    wire [INDEX_BITS-1:0] write_index;
    wire [63:0] write_data;
    `UNIT unit (.*);

    localparam OKAY = 2'b00, SLVERR = 2'b10;
    wire addressed = s_axi_awvalid && s_axi_awready;
    wire beat = s_axi_wvalid && s_axi_wready;
    wire answered = s_axi_bvalid && s_axi_bready;
    wire asked = s_axi_arvalid && s_axi_arready;
    wire read_beat = s_axi_rvalid && s_axi_rready;
    axi_channel #(.WIDTH(ADDRESS_BITS + 8 + 3 + 2 + 4)) addresses (
        clk, rst, s_axi_awvalid, s_axi_awready, {s_axi_awaddr, s_axi_awlen, s_axi_awsize, s_axi_awburst, s_axi_awid}
    );
    axi_channel #(.WIDTH(64 + 8 + 1)) data (clk, rst, s_axi_wvalid, s_axi_wready, {s_axi_wdata, s_axi_wstrb, s_axi_wlast});
    axi_channel #(.WIDTH(ADDRESS_BITS + 8 + 3 + 2 + 4)) read_addresses (
        clk, rst, s_axi_arvalid, s_axi_arready, {s_axi_araddr, s_axi_arlen, s_axi_arsize, s_axi_arburst, s_axi_arid}
    );
    axi_channel #(.OURS(1), .WIDTH(6)) answers (clk, rst, s_axi_bvalid, s_axi_bready, {s_axi_bid, s_axi_bresp});
    axi_channel #(.OURS(1), .WIDTH(64 + 2 + 1 + 4)) read_data (
        clk, rst, s_axi_rvalid, s_axi_rready, {s_axi_rdata, s_axi_rresp, s_axi_rlast, s_axi_rid}
    );

    // Reads: as many beats of nothing as were asked for.
    wire [9:0] owed;
    wire watched, ends;
    wire [4:0] behind;
    axi_read_answers #(.OURS(1), .BEAT_BITS(10), .ID_BITS(4)) reads (
        clk, rst, asked, s_axi_arlen, s_axi_arid, s_axi_rvalid, read_beat, s_axi_rlast, s_axi_rid, owed, watched, ends, behind
    );
    always @(posedge clk) if (!rst) begin
        reads_are_refused: assert (!s_axi_rvalid || (s_axi_rdata == 0 && s_axi_rresp == SLVERR));
        one_read_at_a_time: assert (!asked || owed == 0);
    end

    // The write burst under way: its beats left, and what it may do.
    wire [3:0] open_addresses, open_ends;
    reg open = 0, was_addressed = 0, is_fit, is_locked, is_spoiled;
    reg [3:0] id;
    reg [8:0] left = 0;
    reg [28:0] index;
    wire last_beat = beat && left == 1;
    axi_write_answers #(.OURS(1)) writes (clk, rst, addressed, last_beat, s_axi_bvalid, answered, open_addresses, open_ends);
    wire [31:0] first = s_axi_awaddr >> 3;
    wire fits = s_axi_awburst == 2'b01 && s_axi_awsize == 3 && s_axi_awaddr[2:0] == 0 && first + s_axi_awlen < (1 << INDEX_BITS);
    wire sound = &s_axi_wstrb && s_axi_wlast == (left == 1);
    // A beat is taken two cycles after the address at the earliest: whether the window was locked is known.
    wire writes_beat = beat && is_fit && !is_locked && sound;
    always @(posedge clk) if (!rst) begin
        if (addressed) begin
            open <= 1;
            id <= s_axi_awid;
            is_fit <= fits;
            is_locked <= 0;
            is_spoiled <= 0;
            left <= s_axi_awlen + 1;
            index <= first;
        end
        if (beat) begin
            left <= left - 1;
            index <= index + 1;
            if (!sound) is_spoiled <= 1;
        end
        if (was_addressed) is_locked <= locked;
        was_addressed <= addressed;
        if (answered) open <= 0;
    end
    always @(posedge clk) if (!rst) begin
        one_write_at_a_time: assert (!addressed || !open);
        beats_of_a_burst: assert (!beat || (left != 0 && !was_addressed));
        occupied_from_address_to_end: assert (occupied == (left != 0));
        asked_id: assert (!s_axi_bvalid || s_axi_bid == id);
        as_it_went: assert (!s_axi_bvalid || s_axi_bresp == (is_fit && !is_locked && !is_spoiled ? OKAY : SLVERR));
    end

    // What the last cycle brought.
    reg wrote = 0;
    reg [INDEX_BITS-1:0] wrote_index;
    reg [63:0] wrote_word;
    always @(posedge clk) begin
        wrote <= !rst && writes_beat;
        wrote_index <= index;
        wrote_word <= s_axi_wdata;
    end
    always @(posedge clk) if (!rst) begin
        once_each: assert (write_valid == wrote);
        at_its_index: assert (!write_valid || (write_index == wrote_index && write_data == wrote_word));
    end

    // Refusals: of a write at its end, of a read when it begins or soon after.
    wire refuses_busy = last_beat && is_fit && is_locked;
    wire refuses_write = last_beat && (!is_fit || (!is_locked && (is_spoiled || !sound)));
    reg was_busy = 0;
    reg [1:0] untold = 0;
    reg [2:0] late = 0;
    always @(posedge clk) begin
        was_busy <= !rst && refuses_busy;
        untold <= rst ? 0 : untold + refuses_write + asked - refused_burst;
        late <= rst || untold == 0 || refused_burst ? 0 : late + 1;
    end
    always @(posedge clk) if (!rst) begin
        busy_is_told: assert (refused_busy == was_busy);
        refusals_only: assert (!refused_burst || untold != 0);
        told_soon: assert (untold <= 2 && late <= 1);
    end

    // A burst of several beats that is accepted after one that was spoiled, one refused for the lock, and a read.
    reg [2:0] seen = 0;
    reg [1:0] written = 0;
    always @(posedge clk) if (!rst) begin
        if (refuses_busy) seen[0] <= 1;
        if (refuses_write && is_fit) seen[1] <= 1;
        if (read_beat && s_axi_rlast) seen[2] <= 1;
        if (writes_beat) written <= written + 1;
        if (addressed) written <= 0;
        cover (&seen && answered && s_axi_bresp == OKAY && written == 2);
    end
endmodule
