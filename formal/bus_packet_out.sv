// bus_packet_out: a record becomes a packet of BEATS beats, lowest bytes first, `tlast` on its last.
//
// Assumed: who gives the records holds what it offers.
module proof (input clk);
    `include "sizes.vh"
    `include "record.vh"
    localparam PLACE_BITS = $clog2(BEATS + 1);

    reg rst = 1;
    always @(posedge clk) rst <= 0;

    (* anyseq *) reg in_valid, in_c, m_axis_tready;
    (* anyseq *) reg [2:0] in_a;
    (* anyseq *) reg [19:0] in_b;
    (* anyseq *) reg [8:0] in_d;
    wire in_ready, m_axis_tvalid, m_axis_tlast, sent, idle;
    wire [BITS-1:0] m_axis_tdata;
    `UNIT unit (.*);

    wire [RECORD_BITS-1:0] record = layout(in_a, in_b, in_c, in_d);
    wire beat = m_axis_tvalid && m_axis_tready;
    axi_channel #(.WIDTH(RECORD_BITS)) records (clk, rst, in_valid, in_ready, record);
    axi_channel #(.OURS(1), .WIDTH(BITS + 1)) sender (clk, rst, m_axis_tvalid, m_axis_tready, {m_axis_tlast, m_axis_tdata});

    // The next beat's place in its packet, and what came before it.
    reg [PLACE_BITS-1:0] place = 0;
    reg [BEATS*BITS-1:0] packet;
    wire [BEATS*BITS-1:0] whole = {m_axis_tdata, packet} >> BITS;
    always @(posedge clk) if (!rst && beat) begin
        place <= place == BEATS - 1 ? 0 : place + 1;
        packet <= whole;
    end
    wire complete = m_axis_tvalid && place == BEATS - 1;

    wire [2:0] waiting;
    in_order #(.WIDTH(BEATS * BITS)) packets (
        .clk, .rst, .push(in_valid && in_ready), .pushed(record),
        .offered(m_axis_tvalid), .valid(complete), .ready(m_axis_tready), .shown(whole), .count(waiting)
    );

    // What the last cycle brought.
    reg was_sent = 0;
    reg [2:0] supplied = 0;
    always @(posedge clk) begin
        was_sent <= !rst && beat && place == BEATS - 1;
        supplied <= rst ? 0 : {supplied[1:0], in_valid};
    end
    always @(posedge clk) if (!rst) begin
        nothing_from_nothing: assert (!m_axis_tvalid || waiting != 0);
        last_at_the_end: assert (!m_axis_tvalid || m_axis_tlast == (place == BEATS - 1));
        idle_when_sent: assert (idle == (waiting == 0));
        sent_is_told: assert (sent == was_sent);
        a_beat_a_cycle: assert (!(&supplied) || m_axis_tvalid);
    end
endmodule
