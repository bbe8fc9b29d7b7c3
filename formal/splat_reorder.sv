// splat_reorder: every copy comes out once with its tile and what it carries, those of a tile in the order in which they came, and the
// end of a frame in its place.
//
// Two symbolic copies are watched by their tags, in the place of their splats', and carry a few bits more; the rest is zero, and lies in
// the same words. The source may withdraw what it offers, and the sink may stall as it likes. That tiles come in the heap's order is
// proved of the heap; lists promise none.
module proof (input clk);
    `include "sizes.vh"

    reg rst = 1;
    always @(posedge clk) rst <= 0;

    (* anyseq *) reg in_valid, in_end, out_ready;
    (* anyseq *) reg [1:0] in_tile;
    (* anyseq *) reg [1:0] tag, in_payload;
    wire [2:0] in_left = 0, in_right = 0, in_top = 0, in_bottom = in_payload;
    wire [1:0] in_splat = tag;
    wire [3:0] in_first_sum = 0, in_last_sum = 0, in_first_difference = 0, in_last_difference = 0;
    wire in_ready, out_valid, out_end;
    wire [1:0] out_splat;
    wire [2:0] out_bottom;
    wire [1:0] out_tile;
    `UNIT unit (
        .out_left(), .out_right(), .out_top(),
        .out_first_sum(), .out_last_sum(), .out_first_difference(), .out_last_difference(), .*
    );

    wire push = in_valid && in_ready;
    wire leaves = out_valid && out_ready;
    localparam A = 1, B = 2;
    wire pushes_a = push && !in_end && tag == A;
    wire pushes_b = push && !in_end && tag == B;
    wire shows_a = out_valid && !out_end && out_splat == A;
    wire shows_b = out_valid && !out_end && out_splat == B;

    // The watched copies that are inside, and copies and ends in all.
    reg has_a = 0, has_b = 0, a_came_first;
    reg [1:0] tile_a, tile_b, payload_a;
    reg [3:0] held = 0;
    reg [2:0] ends = 0, ends_before_a;
    always @* assume (!(pushes_a && has_a) && !(pushes_b && has_b));
    always @(posedge clk) if (!rst) begin
        if (pushes_a) {tile_a, payload_a} <= {in_tile, in_payload};
        if (pushes_b) tile_b <= in_tile;
        if (pushes_a || pushes_b) a_came_first <= pushes_b;
        has_a <= pushes_a || (has_a && !(shows_a && leaves));
        has_b <= pushes_b || (has_b && !(shows_b && leaves));
        held <= held + (push && !in_end) - (leaves && !out_end);
        ends <= ends + (push && in_end) - (leaves && out_end);
        ends_before_a <= pushes_a ? ends - (leaves && out_end) : ends_before_a - (leaves && out_end);
    end

    // With a sink that takes, something goes in or out every few cycles: PATIENCE covers the way of an entry through heap or lists.
    reg [4:0] stands = 0;
    wire waits = (in_valid && !in_ready) || held != 0 || ends != 0;
    always @(posedge clk) if (!rst) stands <= leaves || push || !waits ? 0 : stands + out_ready;

    // Where nothing moves for want of a pointer, one copy waits for it, as many have one, and two have given theirs back.
    localparam FULL = 1 + POINTERS + 2;
    reg [3:0] refused = 0;
    always @(posedge clk) if (!rst) refused <= !in_valid || in_ready || leaves || ends != 0 ? 0 : refused + !refused[3];

    always @(posedge clk) if (!rst) begin
        no_pointer_lost: assert (!refused[3] || held == FULL);
        comes_out_once: assert (!shows_a || (has_a && out_tile == tile_a && out_bottom == payload_a));
        none_from_nothing: assert (!(out_valid && !out_end) || held != 0);
        none_lost: assert (!(has_a && held == 0));
        in_order_of_arrival: assert (!(shows_a && has_b && tile_a == tile_b) || a_came_first);
        end_from_nothing: assert (!(out_valid && out_end) || ends != 0);
        end_keeps_its_place: assert (!(out_valid && out_end && has_a) || ends_before_a != 0);
        none_before_the_end: assert (!shows_a || ends_before_a == 0);
        no_overflow: assert (!(push && &held) && !(push && in_end && &ends));
        goes_on: assert (stands <= PATIENCE);
    end
    axi_channel #(.OURS(1), .WIDTH(8)) out_stays (
        clk, rst, out_valid, out_ready, {out_end, {out_tile, out_splat, out_bottom} | {7{out_end}}}
    );

`ifdef STALLED
    // Straight to where all pointers are in use: the sink does not take before the source has been refused for longer than the heap rests.
    reg exhausted = 0;
    always @(posedge clk) if (!rst) exhausted <= exhausted || refused == 5;
    always @* assume (rst || exhausted || (in_valid && !in_end && !out_ready));
`endif

    // As many copies as there are pointers are inside, another takes a pointer that came back, and comes out; a frame follows another.
    reg [3:0] copies = 0;
    reg was_end = 0;
    always @(posedge clk) if (!rst) begin
        if (push && !in_end && !&copies) copies <= copies + 1;
        was_end <= was_end || (leaves && out_end);
        cover (copies > POINTERS + 1 && leaves && shows_a && has_b);
        cover (was_end && leaves && shows_a && tile_a == tile_b && has_b);
    end
endmodule
