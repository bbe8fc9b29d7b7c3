// bus_packet_in: a packet of BEATS beats becomes a record; a shorter or longer one, or one with its first field out of LOW to HIGH, is refused, once, and leaves no trace.
//
// Assumed: the sender holds what it offers. Packets have any length; `opens`, and `last` of a record without `end`, come at will.
module proof (input clk);
    `include "sizes.vh"
    `include "record.vh"
    localparam PLACE_BITS = $clog2(BEATS + 1);

    reg rst = 1;
    always @(posedge clk) rst <= 0;

    (* anyseq *) reg s_axis_tvalid, s_axis_tlast, opens, out_ready;
    (* anyseq *) reg [BITS-1:0] s_axis_tdata;
    reg [BEATS*BITS-1:0] packet;
    wire [BEATS*BITS-1:0] whole = {s_axis_tdata, packet} >> BITS;
    wire s_axis_tready, out_valid, taken, refused;
    wire [2:0] out_a;
    wire [19:0] out_b;
    wire [8:0] out_d;
`ifdef ENDS
    // The third field is called `end` and says whether the packet is a run's last.
    wire out_end;
    wire out_c = out_end;
    wire closes = whole[C_BIT];
`else
    (* anyseq *) reg last;
    wire out_c;
    wire closes = last;
`endif
    `UNIT unit (.*);

    wire [RECORD_BITS-1:0] record = layout(out_a, out_b, out_c, out_d);
    wire beat = s_axis_tvalid && s_axis_tready;
    axi_channel #(.WIDTH(BITS + 1)) sender (clk, rst, s_axis_tvalid, s_axis_tready, {s_axis_tlast, s_axis_tdata});
    axi_channel #(.OURS(1), .WIDTH(RECORD_BITS)) records (clk, rst, out_valid, out_ready, record);

    // The next beat's place in its packet: BEATS in one that is too long.
    reg [PLACE_BITS-1:0] place = 0;
    always @(posedge clk) if (!rst && beat) begin
        place <= s_axis_tlast ? 0 : place + (place != BEATS);
        packet <= whole;
    end
    wire in_range = whole[2:0] >= LOW && whole[2:0] <= HIGH;
    wire ended = beat && s_axis_tlast && place == BEATS - 1;
    wire good = ended && in_range;
    wire outside = ended && !in_range;
    wire short = beat && s_axis_tlast && place < BEATS - 1;
    wire long = beat && !s_axis_tlast && place == BEATS - 1;

    wire [2:0] waiting;
    in_order #(.WIDTH(RECORD_BITS)) packets (
        .clk, .rst, .push(good), .pushed(whole[RECORD_BITS-1:0] & USED),
        .offered(out_valid), .valid(out_valid), .ready(out_ready),
        .shown(record), .count(waiting)
    );

    // What the last cycle brought.
    reg open = 0, was_good = 0, was_refused = 0;
    reg [2:0] unhindered = 0;
    always @(posedge clk) begin
        open <= !rst && (opens || (open && !(good && closes)));
        was_good <= !rst && good;
        was_refused <= !rst && (short || long || outside);
        unhindered <= rst ? 0 : {unhindered[1:0], out_ready};
    end
    always @(posedge clk) if (!rst) begin
        none_begins_while_closed: assert (!(beat && place == 0) || open);
        good_is_told: assert (taken == was_good);
        refused_is_told: assert (refused == was_refused);
        a_beat_a_cycle: assert (!(&unhindered && (open || place != 0)) || s_axis_tready);
    end

    // Refused packets of all kinds and then a good one.
    reg was_short = 0, was_long = 0, was_outside = 0;
    always @(posedge clk) if (!rst) begin
        if (short) was_short <= 1;
        if (long) was_long <= 1;
        if (outside) was_outside <= 1;
        cover (was_long && (was_short || BEATS == 1) && (was_outside || (LOW == 0 && HIGH == 7)) && out_valid && out_ready);
    end
endmodule
