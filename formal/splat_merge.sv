// splat_merge: of the fragments of a surface those leave, in their order, that are nearer than what memory held, whatever was written
// before its end and whoever waits; the others are told of, once each. What leaves is written once.
//
// Fragments lie in a row of two tiles, two places of each. Memory answers with what it holds when a read is taken.
module proof (input clk);
    `include "sizes.vh"

    reg rst = 1;
    always @(posedge clk) rst <= 0;

    (* anyseq *) reg in_valid, in_end, out_ready, depth_read_ready, depth_data_willing, depth_write_ready;
    (* anyseq *) reg [1:0] in_place;
    (* anyseq *) reg [DEPTH_BITS-1:0] in_depth;
    (* anyseq *) reg [31-DEPTH_BITS:0] noise;
    (* anyseq *) reg tag;
    // Places 0 and 1 end a row of the first tile, 2 and 3 begin one of the second.
    wire [3:0] in_column = 4'd6 + in_place, in_row = 0;
    wire [ATTRIBUTE_BITS-1:0] in_attribute_0 = tag;
    wire in_ready, out_valid, out_end, depth_read_valid, depth_data_ready, depth_write_valid, event_hidden;
    wire [3:0] out_column, out_row, depth_read_count;
    wire [DEPTH_BITS-1:0] out_depth;
    wire [ATTRIBUTE_BITS-1:0] out_attribute_0;
    wire [1:0] depth_read_tile, depth_write_tile;
    wire [5:0] depth_read_pixel, depth_write_pixel;
    wire [31:0] depth_write_depth;
    wire depth_data_valid;
    wire [31:0] depth_data_depth;
    `UNIT unit (.*);

    wire push = in_valid && in_ready;
    wire leaves = out_valid && out_ready;
    wire asks = depth_read_valid && depth_read_ready;
    wire comes = depth_data_valid && depth_data_ready;
    wire writes = depth_write_valid && depth_write_ready;

    // The contract's: what is offered stays until it is taken, and a surface has a place once.
    axi_channel #(.OURS(0), .WIDTH(4 + DEPTH_BITS)) in_stays (clk, rst, in_valid, in_ready, {in_end, in_place, in_depth, tag});
    reg [3:0] seen = 0;
    reg begins = 1;
    always @(posedge clk) if (!rst && push) begin
        seen <= in_end ? 0 : seen | (4'd1 << in_place);
        begins <= in_end;
    end
    always @* assume (!in_valid || in_end || !seen[in_place]);

    // Where a pixel lies, by its tile and its place in it.
    function [1:0] place(input [1:0] tile, input [5:0] pixel);
        place = {tile[0], pixel[0]};
    endfunction
    function is_place(input [1:0] tile, input [5:0] pixel);
        is_place = !tile[1] && pixel[5:3] == 0 && (tile[0] ? pixel[2:1] == 0 : pixel[2:1] == 2'b11);
    endfunction

    // Memory.
    (* anyconst *) reg [4*DEPTH_BITS-1:0] held_first;
    reg [DEPTH_BITS-1:0] held [0:3];
    reg began = 0;
    integer i;
    always @(posedge clk) begin
        began <= 1;
        if (!began) for (i = 0; i < 4; i = i + 1) held[i] <= held_first[i*DEPTH_BITS +: DEPTH_BITS];
        else if (writes) held[place(depth_write_tile, depth_write_pixel)] <= depth_write_depth[31 -: DEPTH_BITS];
    end

    // Fragments whose depth was not asked for, the first at place 0; then those that are to leave, ends among them, and those to be
    // written; depths on their way; how many are to be hidden; whether an end waits until all before it has been asked for.
    localparam ENTRY = 3 + DEPTH_BITS;
    reg [ENTRY-1:0] unasked [0:3], unwritten [0:7];
    reg [ENTRY:0] leaving [0:7];
    reg [DEPTH_BITS-1:0] coming [0:7];
    reg [2:0] unasked_count = 0;
    reg [3:0] leaving_count = 0, unwritten_count = 0, coming_count = 0, hidden_count = 0;
    reg closing = 0;

    wire [1:0] asked = asks ? depth_read_count[1:0] : 0;
    wire [ENTRY-1:0] first = unasked[0], second = unasked[1];
    wire [1:0] first_place = first[ENTRY-1 -: 2], second_place = second[ENTRY-1 -: 2];
    wire [DEPTH_BITS-1:0] first_depth = first[DEPTH_BITS:1], second_depth = second[DEPTH_BITS:1];
    wire first_seen = asked >= 1 && first_depth < held[first_place];
    wire second_seen = asked == 2 && second_depth < held[second_place];
    wire closes = closing && unasked_count == 0;
    wire [3:0] leaving_left = leaving_count - leaves, unwritten_left = unwritten_count - writes;
    wire [3:0] coming_left = coming_count - comes;
    wire [2:0] unasked_left = unasked_count - asked;
    always @(posedge clk) if (!rst) begin
        for (i = 0; i < 3; i = i + 1) unasked[i] <= i + asked < 4 ? unasked[i + asked] : 0;
        if (push && !in_end) unasked[unasked_left[1:0]] <= {in_place, in_depth, tag};
        unasked_count <= unasked_left + (push && !in_end);
        for (i = 0; i < 7; i = i + 1) begin
            if (leaves) leaving[i] <= leaving[i + 1];
            if (writes) unwritten[i] <= unwritten[i + 1];
            if (comes) coming[i] <= coming[i + 1];
        end
        if (closes) leaving[leaving_left[2:0]] <= {1'b1, first};
        if (first_seen) leaving[leaving_left[2:0]] <= {1'b0, first};
        if (first_seen) unwritten[unwritten_left[2:0]] <= first;
        if (second_seen) leaving[leaving_left[2:0] + first_seen] <= {1'b0, second};
        if (second_seen) unwritten[unwritten_left[2:0] + first_seen] <= second;
        if (asked >= 1) coming[coming_left[2:0]] <= held[first_place];
        if (asked == 2) coming[coming_left[2:0] + 3'd1] <= held[second_place];
        leaving_count <= leaving_left + first_seen + second_seen + closes;
        unwritten_count <= unwritten_left + first_seen + second_seen;
        coming_count <= coming_left + asked;
        hidden_count <= hidden_count + asked - first_seen - second_seen - event_hidden;
        closing <= (closing && !closes) || (push && in_end);
    end
    // A write that is taken in the cycle of a read is before it or after it.
    always @* assume (!(asks && writes));
    assign depth_data_valid = coming_count != 0 && depth_data_willing;
    assign depth_data_depth = {coming[0], noise};

    // With neighbors that take and give, something moves every few cycles.
    reg [3:0] stands = 0;
    wire willing = out_ready && depth_read_ready && depth_write_ready && (depth_data_valid || coming_count == 0);
    wire work = in_valid || unasked_count != 0 || leaving_count != 0 || unwritten_count != 0 || hidden_count != 0 || closing;
    wire moves = push || leaves || asks || comes || writes || event_hidden;
    always @(posedge clk) if (!rst) stands <= moves || !work ? 0 : stands + willing;

    wire [ENTRY:0] next_leaving = leaving[0];
    wire [ENTRY-1:0] next_unwritten = unwritten[0];
    wire [1:0] run_place = place(depth_read_tile, depth_read_pixel);
    always @(posedge clk) if (!rst) begin
        asks_for_fragments: assert (!depth_read_valid || depth_read_count <= unasked_count);
        asks_for_some: assert (!depth_read_valid || depth_read_count == 1 || depth_read_count == 2);
        asks_where_they_are: assert (!depth_read_valid || (is_place(depth_read_tile, depth_read_pixel) && run_place == first_place));
        a_run_stays_in_a_row: assert (!depth_read_valid || depth_read_count == 1 || (!run_place[0] && second_place == run_place + 1));
        depths_have_room: assert (!depth_data_valid || depth_data_ready);
        leaves_what_is_nearer: assert (!out_valid || leaving_count != 0);
        ends_in_place: assert (!out_valid || out_end == next_leaving[ENTRY]);
        leaves_in_order: assert (!out_valid || out_end
            || {out_column - 4'd6, out_row, out_depth, out_attribute_0[0]} == {2'd0, next_leaving[ENTRY-1 -: 2], 4'd0, next_leaving[DEPTH_BITS:0]});
        writes_what_leaves: assert (!depth_write_valid || unwritten_count != 0);
        writes_its_depth: assert (!depth_write_valid || (is_place(depth_write_tile, depth_write_pixel)
            && {place(depth_write_tile, depth_write_pixel), depth_write_depth[31 -: DEPTH_BITS]} == next_unwritten[ENTRY-1:1]));
        nothing_below: assert (!depth_write_valid || depth_write_depth[31-DEPTH_BITS:0] == 0);
        hides_what_is_not: assert (!event_hidden || hidden_count != 0);
        begins_when_written: assert (!(push && begins) || (unwritten_count == 0 && !closing));
        nothing_behind_an_end: assert (!(push && closing));
        none_too_many: assert (leaving_left <= 6 && unwritten_left <= 6 && unasked_count <= 4);
        goes_on: assert (stands <= PATIENCE);
    end
    axi_channel #(.OURS(1), .WIDTH(1 + 8 + DEPTH_BITS + 1)) out_stays (
        clk, rst, out_valid, out_ready, {out_end, {out_column, out_row, out_depth, out_attribute_0[0]} & {(9 + DEPTH_BITS){!out_end}}}
    );
    axi_channel #(.OURS(1), .WIDTH(12)) read_stays (
        clk, rst, depth_read_valid, depth_read_ready, {depth_read_tile, depth_read_pixel, depth_read_count}
    );
    axi_channel #(.OURS(1), .WIDTH(40)) write_stays (
        clk, rst, depth_write_valid, depth_write_ready, {depth_write_tile, depth_write_pixel, depth_write_depth}
    );

`ifdef STEADY
    // Nobody waits but memory's data: so more cycles are searched in the same time, and faults are found that take many.
    always @* assume (rst || (in_valid && out_ready && depth_read_ready && (depth_write_ready || asks)));
`endif

    // A place of the second surface is hidden by the one of the first, another one is not.
    reg [1:0] ends = 0;
    always @(posedge clk) if (!rst && leaves && out_end) ends <= ends + 1;
    reg hid = 0;
    always @(posedge clk) if (!rst && event_hidden && ends == 1) hid <= 1;
    always @(posedge clk) if (!rst) cover (hid && ends == 1 && leaves && !out_end);
endmodule
