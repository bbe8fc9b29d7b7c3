// What the proofs of the AXI units share: the rules of a channel and of the channels that belong together, and a watch over the order of
// what passes through a unit. A rule with OURS = 1 is asserted of the unit, with OURS = 0 assumed of what it is connected to.

// Whoever sends on a channel: what is offered stays until it is taken, and nothing is offered in reset.
module axi_channel #(parameter OURS = 0, parameter WIDTH = 1) (input clk, rst, valid, ready, input [WIDTH-1:0] payload);
    reg stalled = 0, was_reset = 0;
    reg [WIDTH-1:0] offered;
    always @(posedge clk) begin
        stalled <= !rst && valid && !ready;
        was_reset <= rst;
        offered <= payload;
    end
    generate if (OURS) begin
        always @(posedge clk) if (!rst) begin
            offer_stays: assert (!stalled || (valid && payload == offered));
            silent_in_reset: assert (!was_reset || !valid);
        end
    end else begin
        always @* assume (!stalled || (valid && payload == offered));
        always @* assume (!rst || !valid);
    end endgenerate
endmodule

// Whoever asks for bursts: rising addresses, beats of BYTES, never across a border of 4,096 bytes.
module axi_burst #(parameter BYTES = 8) (
    input clk, rst, valid, input [31:0] address, input [7:0] len, input [2:0] size, input [1:0] burst
);
    wire [16:0] end_in_page = address[11:0] + (len + 1) * BYTES;
    always @(posedge clk) if (!rst && valid) begin
        rising: assert (burst == 2'b01);
        full_width: assert (8'd1 << size == BYTES);
        aligned: assert (address % BYTES == 0);
        inside_a_page: assert (end_in_page <= 4096);
    end
endmodule

// Whoever answers reads: data for accepted addresses only; of ours also `last` exactly at a burst's end, and its id, as the addresses
// came. `asked` and `answered` are transfers; `owed` are beats; `watched` marks those of a symbolic burst, `ends` its last one; `behind`
// are the bursts asked for since it was.
module axi_read_answers #(parameter OURS = 0, parameter BEAT_BITS = 10, parameter ID_BITS = 1) (
    input clk, rst, asked, input [7:0] len, input [ID_BITS-1:0] id,
    input valid, answered, last, input [ID_BITS-1:0] answer_id,
    output [BEAT_BITS-1:0] owed, output watched, ends, output [4:0] behind
);
    (* anyseq *) reg watch;
    reg [BEAT_BITS-1:0] beats = 0, ahead = 0;
    reg [8:0] left = 0;
    reg [ID_BITS-1:0] watched_id;
    reg [4:0] bursts_behind = 0;
    assign owed = beats;
    assign behind = bursts_behind;
    assign watched = left != 0 && ahead == 0;
    assign ends = left == 1;
    always @(posedge clk) if (!rst) begin
        beats <= beats + (asked ? len + 1 : 0) - answered;
        bursts_behind <= left == 0 || (watched && ends && answered) ? 0 : bursts_behind + asked;
        if (left == 0) begin
            if (asked && watch) begin
                left <= len + 1;
                ahead <= beats - answered;
                watched_id <= id;
            end
        end else if (answered) begin
            if (ahead != 0) ahead <= ahead - 1;
            else left <= left - 1;
        end
    end
    generate if (OURS) begin
        always @(posedge clk) if (!rst && valid) begin
            asked_for: assert (beats != 0);
            last_at_the_end: assert (!watched || last == ends);
            asked_id: assert (!watched || answer_id == watched_id);
        end
    end else begin
        always @* assume (!valid || beats != 0);
    end endgenerate
endmodule

// Whoever answers writes: one answer a burst, after its address and its last beat, which may come in either order. `owed` are bursts
// of which address and data have come.
module axi_write_answers #(parameter OURS = 0, parameter BITS = 4) (
    input clk, rst, addressed, ended, valid, answered, output [BITS-1:0] addresses, ends
);
    reg [BITS-1:0] open_addresses = 0, open_ends = 0;
    assign addresses = open_addresses;
    assign ends = open_ends;
    always @(posedge clk) if (!rst) begin
        open_addresses <= open_addresses + addressed - answered;
        open_ends <= open_ends + ended - answered;
    end
    generate if (OURS) begin
        always @(posedge clk) if (!rst) asked_for: assert (!valid || (open_addresses != 0 && open_ends != 0));
    end else begin
        always @* assume (!valid || (open_addresses != 0 && open_ends != 0));
    end endgenerate
endmodule

// Items that enter come out once, unchanged, in order; no more than PATIENCE cycles pass without some of an item being `offered`. A
// symbolic item is followed: `known` when it is shown, with what was noted of it beside its content.
module in_order #(parameter WIDTH = 1, parameter NOTES = 1, parameter COUNT_BITS = 3, parameter PATIENCE = 2) (
    input clk, rst, push, input [WIDTH-1:0] pushed, input [NOTES-1:0] noted,
    input offered, valid, ready, input [WIDTH-1:0] shown, output known, output [NOTES-1:0] notes, output [COUNT_BITS-1:0] count
);
    (* anyseq *) reg follow;
    reg [COUNT_BITS-1:0] held = 0, ahead = 0;
    reg following = 0;
    reg [WIDTH-1:0] item;
    reg [NOTES-1:0] item_notes;
    reg [3:0] waited = 0;
    wire pop = valid && ready;
    assign count = held;
    assign known = valid && following && ahead == 0;
    assign notes = item_notes;
    always @(posedge clk) if (!rst) begin
        held <= held + push - pop;
        waited <= held != 0 && !offered ? waited + 1 : 0;
        if (!following) begin
            following <= push && follow;
            ahead <= held - pop;
            item <= pushed;
            item_notes <= noted;
        end else if (pop) begin
            following <= ahead != 0;
            ahead <= ahead - 1;
        end
    end
    always @(posedge clk) if (!rst) begin
        no_overflow: assert (!(push && &held));
        nothing_from_nothing: assert (!valid || held != 0);
        unchanged: assert (!known || shown == item);
        comes_out: assert (waited <= PATIENCE);
    end
    always @(posedge clk) if (!rst) cover (known && ready);
endmodule
