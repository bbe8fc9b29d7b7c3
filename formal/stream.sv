// stream_fifo, stream_half_buffer, stream_skid: every item comes out once, unchanged, in order, and none is lost.
//
// A symbolic item is tracked: it is pushed behind `ahead` others, each of which leaves before it. Nothing is assumed: the
// source may withdraw what it offers, and the sink may stall as it likes.
module proof (input clk);
    `include "sizes.vh"

    reg rst = 1;
    always @(posedge clk) rst <= 0;

    (* anyseq *) reg in_valid;
    (* anyseq *) reg [WIDTH-1:0] in_data;
    (* anyseq *) reg out_ready;
    wire in_ready, out_valid;
    wire [WIDTH-1:0] out_data;
    `UNIT unit (.*);

    // Items in the queue, as the ports tell, and one of them.
    localparam COUNT_BITS = $clog2(DEPTH + 2);
    reg [COUNT_BITS-1:0] held = 0;
    reg tracked = 0;
    reg [COUNT_BITS-1:0] ahead;
    reg [WIDTH-1:0] item;
    (* anyseq *) reg track;
    wire push = in_valid && in_ready;
    wire pop = out_valid && out_ready;

    always @(posedge clk) if (!rst) begin
        held <= held + push - pop;
        if (!tracked && push && track) begin
            tracked <= 1;
            ahead <= held - pop;
            item <= in_data;
        end else if (tracked && pop) begin
            tracked <= ahead != 0;
            ahead <= ahead - 1;
        end
    end

    // What is shown stays until it is taken.
    reg stalled = 0;
    reg [WIDTH-1:0] shown;
    always @(posedge clk) begin
        stalled <= !rst && out_valid && !out_ready;
        shown <= out_data;
    end

    always @(posedge clk) if (!rst) begin
        no_overflow: assert (held <= DEPTH);
        nothing_from_nothing: assert (!out_valid || held != 0);
        room_is_used: assert (in_ready == (held != DEPTH));
        in_order: assert (!(tracked && ahead == 0 && out_valid) || out_data == item);
        shown_stays: assert (!stalled || (out_valid && out_data == shown));
    end

    // What is held is shown two cycles after it came at the latest.
    reg [1:0] held_before = 0;
    always @(posedge clk) held_before <= rst ? 0 : {held_before[0], held != 0 && !pop};
    always @(posedge clk) if (!rst) comes_out: assert (!(held != 0 && &held_before) || out_valid);

    // The item that filled the queue leaves.
    reg filled = 0;
    always @(posedge clk) if (!rst) begin
        if (push && track && !tracked) filled <= held + 1 == DEPTH;
        cover (tracked && filled && ahead == 0 && pop);
    end
endmodule
