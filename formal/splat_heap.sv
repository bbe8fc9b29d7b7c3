// splat_heap: every entry comes out once, and of those inside the first in the order of docs/units/splat/heap.md.
//
// Two symbolic entries are watched by their pointers, which, as in the reorder unit, no two entries have that are inside together. All
// else is free: the source may withdraw what it offers, and the sink may stall as it likes.
module proof (input clk);
    `include "sizes.vh"
    localparam CAPACITY = 2**LEVELS - 1;

    reg rst = 1;
    always @(posedge clk) rst <= 0;

    (* anyseq *) reg in_valid, out_ready;
    (* anyseq *) reg [TILE_BITS-1:0] in_tile;
    (* anyseq *) reg [LEVELS-1:0] in_pointer;
    wire in_ready, out_valid, empty;
    wire [TILE_BITS-1:0] out_tile;
    wire [LEVELS-1:0] out_pointer;
    `UNIT unit (.*);

    // What the page says of every cycle: when an operation begins, entries in the heap and behind it, the tile that left last, and the
    // arrivals since an epoch began.
    reg [1:0] resting = 0;
    reg [LEVELS-1:0] count = 0;
    reg [1:0] queued = 0;
    reg [TILE_BITS-1:0] current = 0;
    reg [SEQUENCE_BITS-2:0] arrivals = 0;
    wire push = in_valid && in_ready;
    wire pop = resting == 0 && count != 0 && queued < 2;
    wire leaves = out_valid && out_ready;
    always @(posedge clk) if (!rst) begin
        resting <= resting == 0 ? INTERVAL - 1 : resting - 1;
        count <= count + push - pop;
        queued <= queued + pop - leaves;
        arrivals <= arrivals + push;
        if (leaves) current <= out_tile;
    end
    wire may_push = resting == 0 && (count < CAPACITY || pop);

    // The watched entries: inside, or in the queue behind the heap.
    (* anyconst *) reg [LEVELS-1:0] pointer_a, pointer_b;
    reg has_a = 0, has_b = 0, a_came_first;
    reg [TILE_BITS-1:0] tile_a, tile_b;
    wire pushes_a = push && in_pointer == pointer_a;
    wire pushes_b = push && in_pointer == pointer_b;
    wire shows_a = out_valid && out_pointer == pointer_a;
    wire shows_b = out_valid && out_pointer == pointer_b;
    always @* begin
        assume (pointer_a != pointer_b);
        assume (!(pushes_a && has_a) && !(pushes_b && has_b));
    end
    always @(posedge clk) if (!rst) begin
        if (pushes_a) tile_a <= in_tile;
        if (pushes_b) tile_b <= in_tile;
        if (pushes_a || pushes_b) a_came_first <= pushes_b;
        has_a <= pushes_a || (has_a && !(shows_a && leaves));
        has_b <= pushes_b || (has_b && !(shows_b && leaves));
    end

    // Of each entry in the queue: whether `b` was inside when it left the heap, and has not come out since.
    reg b_stayed_0, b_stayed_1;
    wire b_stays = has_b && !(shows_b && leaves);
    always @(posedge clk) if (!rst) begin
        if (leaves) b_stayed_0 <= b_stayed_1 && b_stays;
        else b_stayed_0 <= b_stayed_0 && b_stays;
        b_stayed_1 <= b_stayed_1 && b_stays;
        if (pop) begin
            if (queued == leaves) b_stayed_0 <= b_stays;
            else b_stayed_1 <= b_stays;
        end
    end
    wire [1:0] lap_a = tile_a < current, lap_b = tile_b < current;
    wire a_before_b = {lap_a, tile_a, !a_came_first} < {lap_b, tile_b, a_came_first};

    // Entries that left while `a` was inside: those that were in the queue or inside when it came, and those that may come before its
    // epoch's number would be used again.
    localparam PATIENCE = 2 + (CAPACITY - 1) + (2**SEQUENCE_BITS - 1);
    reg [5:0] overtaken;
    always @(posedge clk) if (!rst) overtaken <= pushes_a ? 0 : overtaken + (leaves && !shows_a);

    // What is shown stays until it is taken.
    reg stalled = 0;
    reg [TILE_BITS+LEVELS-1:0] shown;
    always @(posedge clk) begin
        stalled <= !rst && out_valid && !out_ready;
        shown <= {out_tile, out_pointer};
    end

    always @(posedge clk) if (!rst) begin
        none_from_nothing: assert (out_valid == (queued != 0));
        empty_when_nothing_is_left: assert (empty == (count == 0 && queued == 0));
        comes_out_once: assert (!shows_a || (has_a && out_tile == tile_a));
        none_lost: assert (!(empty && has_a));
        in_order: assert (!(shows_a && has_b && b_stayed_0) || a_before_b);
        none_held_for_ever: assert (!has_a || overtaken <= PATIENCE);
        no_overflow: assert (!push || may_push);
        room_is_used: assert (!(may_push && (arrivals != 0 || count == 0)) || in_ready);
        shown_stays: assert (!stalled || (out_valid && {out_tile, out_pointer} == shown));
    end

    reg filled = 0;
    always @(posedge clk) if (!rst) filled <= filled || count == CAPACITY;

    // Out of a heap that was full come an entry before one of its tile, and one whose tile is behind that of the entry before; an epoch
    // waits for the last of its number.
    always @(posedge clk) if (!rst) begin
        cover (filled && leaves && shows_a && has_b && b_stayed_0 && tile_a == tile_b);
        cover (filled && leaves && shows_a && tile_a < current);
        cover (resting == 0 && !in_ready && may_push);
    end
endmodule
