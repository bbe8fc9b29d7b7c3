// bus_reader: requests become bursts that ask for exactly their addresses, and the beats that answer them become records in order.
//
// Assumed: requests are whole (a multiple of the stride, at least one record, not beyond the last address), and the memory answers
// accepted addresses only; `rlast`, `rresp` and `rid` may be anything.
module proof (input clk);
    `include "sizes.vh"
    `include "record.vh"
    localparam BYTES = BITS / 8;
    localparam STRIDE = BEATS * BYTES;
    // Requests that may wait in the unit.
    localparam REQUESTS = 3;

    reg rst = 1;
    always @(posedge clk) rst <= 0;

    (* anyseq *) reg request_valid, m_axi_arready, m_axi_rvalid, m_axi_rlast, record_ready;
    (* anyseq *) reg [31:0] request_address;
    (* anyseq *) reg [RECORDS_BITS-1:0] request_records;
    (* anyseq *) reg [BITS-1:0] m_axi_rdata;
    (* anyseq *) reg [1:0] m_axi_rresp;
    (* anyseq *) reg [3:0] m_axi_rid;
    wire request_ready, m_axi_arvalid, m_axi_rready, record_valid, record_c, error, misplaced;
    wire [31:0] m_axi_araddr;
    wire [7:0] m_axi_arlen;
    wire [2:0] m_axi_arsize;
    wire [1:0] m_axi_arburst;
    wire [3:0] m_axi_arid;
    wire [2:0] record_a;
    wire [19:0] record_b;
    wire [8:0] record_d;
    `UNIT unit (.*);

    wire [RECORD_BITS-1:0] record = layout(record_a, record_b, record_c, record_d);
    wire [8:0] burst_beats = m_axi_arlen + 1;
    wire requested = request_valid && request_ready;
    wire asked = m_axi_arvalid && m_axi_arready;
    wire beat = m_axi_rvalid && m_axi_rready;
    axi_channel #(.WIDTH(32 + RECORDS_BITS)) requests (clk, rst, request_valid, request_ready, {request_address, request_records});
    axi_channel #(.WIDTH(BITS + 4 + 3)) data (clk, rst, m_axi_rvalid, m_axi_rready, {m_axi_rdata, m_axi_rid, m_axi_rresp, m_axi_rlast});
    axi_channel #(.OURS(1), .WIDTH(32 + 8 + 3 + 2 + 4)) addresses (
        clk, rst, m_axi_arvalid, m_axi_arready, {m_axi_araddr, m_axi_arlen, m_axi_arsize, m_axi_arburst, m_axi_arid}
    );
    axi_channel #(.OURS(1), .WIDTH(RECORD_BITS)) records (clk, rst, record_valid, record_ready, record);
    axi_burst #(.BYTES(BYTES)) bursts (clk, rst, m_axi_arvalid, m_axi_araddr, m_axi_arlen, m_axi_arsize, m_axi_arburst);
    wire [11:0] owed;
    wire watched, ends;
    wire [4:0] behind;
    axi_read_answers #(.BEAT_BITS(12), .ID_BITS(4)) answers (
        clk, rst, asked, m_axi_arlen, m_axi_arid, m_axi_rvalid, beat, m_axi_rlast, m_axi_rid, owed, watched, ends, behind
    );
    wire [35:0] request_bytes = request_records * STRIDE;
    always @* assume (!request_valid || (request_address % STRIDE == 0 && request_records != 0 && request_records <= RECORDS_MAX
        && request_address + request_bytes <= 36'h1_0000_0000));

    // The requests that are not wholly asked for, the oldest in the lowest place: where each goes on, and the beats left of it.
    localparam LEFT_BITS = RECORDS_BITS + $clog2(BEATS);
    reg [32*REQUESTS-1:0] next = 0;
    reg [LEFT_BITS*REQUESTS-1:0] left = 0;
    reg [$clog2(REQUESTS+1)-1:0] open = 0;
    wire [31:0] head_next = next[31:0];
    wire [LEFT_BITS-1:0] head_left = left[LEFT_BITS-1:0];
    wire finishes = asked && burst_beats == head_left;
    wire [$clog2(REQUESTS+1)-1:0] stay = open - finishes;
    integer place_in_queue;
    always @(posedge clk) if (!rst) begin
        if (finishes) begin
            next <= next >> 32;
            left <= left >> LEFT_BITS;
        end else if (asked) begin
            next[31:0] <= head_next + burst_beats * BYTES;
            left[LEFT_BITS-1:0] <= head_left - burst_beats;
        end
        if (requested) for (place_in_queue = 0; place_in_queue < REQUESTS; place_in_queue = place_in_queue + 1)
            if (place_in_queue == stay) begin
                next[32*place_in_queue +: 32] <= request_address;
                left[LEFT_BITS*place_in_queue +: LEFT_BITS] <= request_records * BEATS;
            end
        open <= stay + requested;
    end
    always @(posedge clk) if (!rst) begin
        few_wait: assert (!(requested && stay == REQUESTS));
        requested_only: assert (!m_axi_arvalid || open != 0);
        its_addresses: assert (!m_axi_arvalid || m_axi_araddr == head_next);
        its_length: assert (!m_axi_arvalid || burst_beats <= head_left);
        one_id: assert (!m_axi_arvalid || m_axi_arid == 0);
        not_too_many: assert (behind < LIMIT);
    end

    // The next beat's place in its record, and what came before it.
    reg [$clog2(BEATS+1)-1:0] place = 0;
    reg [BEATS*BITS-1:0] beats;
    wire [BEATS*BITS-1:0] whole = {m_axi_rdata, beats} >> BITS;
    always @(posedge clk) if (!rst && beat) begin
        place <= place == BEATS - 1 ? 0 : place + 1;
        beats <= whole;
    end
    // Of a symbolic burst, whether `rlast` has been wrong so far. Its last record is noted with it; others of it as fine.
    reg was_wrong = 0;
    wire is_wrong = (watched && was_wrong) || m_axi_rlast != ends;
    always @(posedge clk) if (!rst && beat) was_wrong <= watched && is_wrong && !ends;
    wire [3:0] waiting;
    wire known, is_judged, is_misplaced;
    in_order #(.WIDTH(RECORD_BITS), .NOTES(2), .COUNT_BITS(4)) records_in_order (
        .clk, .rst, .push(beat && place == BEATS - 1), .pushed(whole[RECORD_BITS-1:0] & USED), .noted({watched, ends && is_wrong}),
        .offered(record_valid), .valid(record_valid), .ready(record_ready), .shown(record),
        .known, .notes({is_judged, is_misplaced}), .count(waiting)
    );

    // What the last cycle brought.
    reg shown = 0, was_error = 0;
    reg [2:0] unhindered = 0;
    always @(posedge clk) begin
        shown <= !rst && record_valid && !record_ready;
        was_error <= !rst && beat && m_axi_rresp != 0;
        unhindered <= rst ? 0 : {unhindered[1:0], record_ready};
    end
    always @(posedge clk) if (!rst) begin
        error_is_told: assert (error == was_error);
        misplaced_is_told: assert (!(known && is_judged && !shown) || misplaced == is_misplaced);
        told_at_an_end: assert (!misplaced || (record_valid && !shown));
        a_beat_a_cycle: assert (!(&unhindered) || m_axi_rready);
    end

    // A request that takes two bursts because of a page's end, asked for while the one before it is not answered.
    reg split = 0;
    always @(posedge clk) if (!rst) begin
        if (asked && !finishes && owed != 0 && !beat) split <= 1;
        cover (split && finishes);
    end
endmodule
