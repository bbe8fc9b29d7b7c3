// bus_writer: each record becomes one burst at its address, with its bytes; `idle` exactly when all are answered.
//
// Assumed: who gives the records holds what it offers, and addresses are multiples of the stride; the memory answers a burst after its
// address and its last beat; `bresp` and `bid` may be anything.
module proof (input clk);
    `include "sizes.vh"
    `include "record.vh"
    localparam BYTES = BITS / 8;
    localparam STRIDE = BEATS * BYTES;
    localparam COUNT_BITS = 5;

    reg rst = 1;
    always @(posedge clk) rst <= 0;

    (* anyseq *) reg in_valid, in_c, m_axi_awready, m_axi_wready, m_axi_bvalid;
    (* anyseq *) reg [31:0] in_address;
    (* anyseq *) reg [2:0] in_a;
    (* anyseq *) reg [19:0] in_b;
    (* anyseq *) reg [8:0] in_d;
    (* anyseq *) reg [1:0] m_axi_bresp;
    (* anyseq *) reg [3:0] m_axi_bid;
    wire in_ready, m_axi_awvalid, m_axi_wvalid, m_axi_wlast, m_axi_bready, idle, error;
    wire [31:0] m_axi_awaddr;
    wire [7:0] m_axi_awlen;
    wire [2:0] m_axi_awsize;
    wire [1:0] m_axi_awburst;
    wire [3:0] m_axi_awid;
    wire [BITS-1:0] m_axi_wdata;
    wire [BYTES-1:0] m_axi_wstrb;
    `UNIT unit (.*);

    wire [RECORD_BITS-1:0] record = layout(in_a, in_b, in_c, in_d);
    wire taken = in_valid && in_ready;
    wire addressed = m_axi_awvalid && m_axi_awready;
    wire beat = m_axi_wvalid && m_axi_wready;
    wire answered = m_axi_bvalid && m_axi_bready;
    axi_channel #(.WIDTH(32 + RECORD_BITS)) records (clk, rst, in_valid, in_ready, {in_address, record});
    axi_channel #(.WIDTH(4 + 2)) answers (clk, rst, m_axi_bvalid, m_axi_bready, {m_axi_bid, m_axi_bresp});
    axi_channel #(.OURS(1), .WIDTH(32 + 8 + 3 + 2 + 4)) addresses (
        clk, rst, m_axi_awvalid, m_axi_awready, {m_axi_awaddr, m_axi_awlen, m_axi_awsize, m_axi_awburst, m_axi_awid}
    );
    axi_channel #(.OURS(1), .WIDTH(BITS + BYTES + 1)) data (
        clk, rst, m_axi_wvalid, m_axi_wready, {m_axi_wdata, m_axi_wstrb, m_axi_wlast}
    );
    axi_burst #(.BYTES(BYTES)) bursts (clk, rst, m_axi_awvalid, m_axi_awaddr, m_axi_awlen, m_axi_awsize, m_axi_awburst);
    wire [COUNT_BITS-1:0] addresses_open, ends_open;
    axi_write_answers #(.BITS(COUNT_BITS)) written (
        clk, rst, addressed, beat && m_axi_wlast, m_axi_bvalid, answered, addresses_open, ends_open
    );
    always @* assume (!in_valid || in_address % STRIDE == 0);

    // The next beat's place in its burst, and what came before it.
    reg [$clog2(BEATS+1)-1:0] place = 0;
    reg [BEATS*BITS-1:0] beats;
    wire [BEATS*BITS-1:0] whole = {m_axi_wdata, beats} >> BITS;
    always @(posedge clk) if (!rst && beat) begin
        place <= place == BEATS - 1 ? 0 : place + 1;
        beats <= whole;
    end

    // Addresses and data leave one by one in the order of the records, each on its own way.
    wire [COUNT_BITS-1:0] unaddressed, unended;
    in_order #(.WIDTH(32), .COUNT_BITS(COUNT_BITS)) in_order_addresses (
        .clk, .rst, .push(taken), .pushed(in_address),
        .offered(m_axi_awvalid), .valid(m_axi_awvalid), .ready(m_axi_awready), .shown(m_axi_awaddr), .count(unaddressed)
    );
    in_order #(.WIDTH(BEATS * BITS), .COUNT_BITS(COUNT_BITS)) in_order_data (
        .clk, .rst, .push(taken), .pushed(record),
        .offered(m_axi_wvalid), .valid(m_axi_wvalid && place == BEATS - 1), .ready(m_axi_wready), .shown(whole), .count(unended)
    );

    // Writes that were accepted and not yet answered.
    reg [COUNT_BITS-1:0] unanswered = 0;
    reg was_error = 0;
    always @(posedge clk) begin
        unanswered <= rst ? 0 : unanswered + taken - answered;
        was_error <= !rst && answered && m_axi_bresp != 0;
    end
    always @(posedge clk) if (!rst) begin
        data_of_a_record: assert (!m_axi_wvalid || unended != 0);
        last_at_the_end: assert (!m_axi_wvalid || m_axi_wlast == (place == BEATS - 1));
        one_burst_a_record: assert (!m_axi_awvalid || (m_axi_awlen == BEATS - 1 && m_axi_awid == 0));
        all_bytes: assert (!m_axi_wvalid || &m_axi_wstrb);
        idle_when_answered: assert (idle == (unanswered == 0));
        error_is_told: assert (error == was_error);
        not_too_many: assert (unanswered <= LIMIT);
        answers_are_taken: assert (!m_axi_bvalid || m_axi_bready);
    end

    // As many as may await their answer do; all are answered.
    reg wrote = 0;
    always @(posedge clk) if (!rst) begin
        if (beat && m_axi_wlast) wrote <= 1;
        cover (unanswered == LIMIT);
        cover (wrote && idle);
    end
endmodule
