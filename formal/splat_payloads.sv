// splat_payloads: every copy comes out once with the payload of its splat, whatever the order in which copies come back, and no place is
// lost: copies go on moving.
//
// Splats have tags, which are a part of the first and of the last word of what they carry. Copies that came out on the one side wait here,
// with the tag that they are to get, until they go in on the other, any of them next. Ends do not come back.
module proof (input clk);
    `include "sizes.vh"

    reg rst = 1;
    always @(posedge clk) rst <= 0;

    (* anyseq *) reg in_valid, in_end, in_first, copy_willing, placed_willing, out_ready;
    (* anyseq *) reg [1:0] in_tile, tag;
    (* anyseq *) reg [1:0] chosen;
    wire [31:0] in_center_x = tag, in_center_y = 0, in_ax = 0, in_bx = 0, in_ay = 0, in_by = 0, in_delta = 0, in_mx = 0, in_my = 0;
    wire [23:0] in_depth = 0, in_depth_low = 0, in_depth_high = 0;
    wire [ATTRIBUTE_BITS-1:0] in_attribute_0 = tag;
    wire [2:0] in_left = 0, in_right = 0, in_top = 0, in_bottom = 0;
    wire [3:0] in_first_sum = 0, in_last_sum = 0, in_first_difference = 0, in_last_difference = 0;
    wire in_ready, copy_valid, copy_end, placed_ready, out_valid;
    wire [1:0] copy_tile, out_tile;
    wire [SPLAT_BITS-1:0] copy_splat;
    wire [31:0] out_center_x;
    wire [ATTRIBUTE_BITS-1:0] out_attribute_0;
    wire copy_ready, placed_valid;
    wire [1:0] placed_tile;
    wire [SPLAT_BITS-1:0] placed_splat;
    wire [2:0] placed_left = 0, placed_right = 0, placed_top = 0, placed_bottom = 0;
    wire [3:0] placed_first_sum = 0, placed_last_sum = 0, placed_first_difference = 0, placed_last_difference = 0;
    wire placed_slot = 0;
    `UNIT unit (
        .copy_left(), .copy_right(), .copy_top(), .copy_bottom(),
        .copy_first_sum(), .copy_last_sum(), .copy_first_difference(), .copy_last_difference(),
        .out_center_y(), .out_ax(), .out_bx(), .out_ay(), .out_by(), .out_delta(), .out_mx(), .out_my(), .out_depth(), .out_depth_low(),
        .out_depth_high(), .out_left(), .out_right(), .out_top(), .out_bottom(), .out_slot(),
        .out_first_sum(), .out_last_sum(), .out_first_difference(), .out_last_difference(), .*
    );

    // The contract's: what is offered stays until it is taken; a splat begins with a first copy, has one for each tile at most, and they
    // carry the same.
    axi_channel #(.OURS(0), .WIDTH(6)) in_stays (clk, rst, in_valid, in_ready, {in_end, in_first, in_tile, tag});
    wire push = in_valid && in_ready;
    reg open = 0;
    reg [1:0] open_tag;
    reg [2:0] open_copies = 0;
    always @(posedge clk) if (!rst && push) begin
        open <= !in_end;
        open_tag <= tag;
        open_copies <= in_first ? 1 : open_copies + 1;
    end
    always @* assume (!in_valid || in_end || in_first || (open && tag == open_tag && open_copies < 4));

    // The copy that went in last and has not come out.
    reg held = 0, held_end;
    reg [1:0] held_tile, held_tag;
    wire comes = copy_valid && copy_ready;
    always @(posedge clk) if (!rst) begin
        held <= push || (held && !comes);
        if (push) {held_end, held_tile, held_tag} <= {in_end, in_tile, tag};
    end

    // Those that wait here.
    reg [3:0] waits = 0;
    reg [1:0] waiting_tile [0:3], waiting_tag [0:3];
    reg [SPLAT_BITS-1:0] waiting_splat [0:3];
    wire [1:0] unused = !waits[0] ? 0 : !waits[1] ? 1 : !waits[2] ? 2 : 3;
    wire goes = placed_valid && placed_ready;
    assign copy_ready = copy_willing && !&waits;
    assign placed_valid = placed_willing && waits[chosen];
    assign placed_tile = waiting_tile[chosen];
    assign placed_splat = waiting_splat[chosen];
    always @(posedge clk) if (!rst) begin
        waits <= (waits & ~({3'b0, goes} << chosen)) | ({3'b0, comes && !copy_end} << unused);
        if (comes) begin
            waiting_tile[unused] <= copy_tile;
            waiting_splat[unused] <= copy_splat;
            waiting_tag[unused] <= held_tag;
        end
    end

    // Those on their way out, the first one at place 0.
    reg [2:0] leaving = 0;
    reg [3:0] outward [0:4]; // five, or one less where LEAVING says so
    wire leaves = out_valid && out_ready;
    wire [2:0] behind = leaving - leaves;
    wire [1:0] first_tile, first_tag;
    assign {first_tile, first_tag} = outward[0];
    always @(posedge clk) if (!rst) begin
        leaving <= behind + goes;
        if (leaves) {outward[0], outward[1], outward[2], outward[3]} <= {outward[1], outward[2], outward[3], outward[4]};
        if (goes) outward[behind] <= {placed_tile, waiting_tag[chosen]};
    end

    // With neighbors that take and give, something moves every few cycles: PATIENCE covers a place's way back.
    reg [5:0] stands = 0;
    wire willing = out_ready && (copy_willing || &waits) && (placed_valid || waits == 0);
    wire work = in_valid || held || waits != 0 || leaving != 0;
    always @(posedge clk) if (!rst) stands <= push || comes || goes || leaves || !work ? 0 : stands + willing;

    always @(posedge clk) if (!rst) begin
        none_from_nothing: assert (!copy_valid || held);
        sent_on_unchanged: assert (!copy_valid || (copy_end == held_end && (copy_end || copy_tile == held_tile)));
        one_at_a_time: assert (!(push && held && !comes));
        none_too_many: assert (!goes || behind < LEAVING);
        none_out_of_nothing: assert (!out_valid || leaving != 0);
        has_its_tile: assert (!out_valid || out_tile == first_tile);
        has_its_payload: assert (!out_valid || (out_center_x == first_tag && out_attribute_0 == first_tag));
        goes_on: assert (stands <= PATIENCE);
    end
    axi_channel #(.OURS(1), .WIDTH(4 + SPLAT_BITS)) copy_stays (
        clk, rst, copy_valid, copy_ready, {copy_end, {copy_tile, copy_splat, 1'b0} | {(3 + SPLAT_BITS){copy_end}}}
    );
    axi_channel #(.OURS(1), .WIDTH(4)) out_stays (clk, rst, out_valid, out_ready, {out_tile, out_center_x[1:0]});

`ifdef STEADY
    // Nobody waits: so more cycles are searched in the same time, and faults are found that take many.
    always @* assume (rst || (in_valid && copy_willing && placed_willing && out_ready));
`endif

    // A place is used again, by a splat of several copies of which the last one has not left.
    reg [2:0] splats = 0;
    reg was_end = 0;
    always @(posedge clk) if (!rst) begin
        if (push && in_first && !in_end && !&splats) splats <= splats + 1;
        was_end <= was_end || (comes && copy_end);
        cover (splats > PLACES && leaves && open_copies == 2 && first_tag == open_tag);
        cover (was_end && leaves);
        cover (&waits && waiting_splat[0] == waiting_splat[3]);
    end
endmodule
