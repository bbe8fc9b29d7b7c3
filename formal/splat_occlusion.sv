// splat_occlusion: samples leave in their order, once, but those that lie behind the depth of their pixel in memory, which are told of
// once each; one of these that closes its copy leaves as one outside. None leaves before its tile's depths have come, and those are asked
// for once, row by row. The unit goes on.
//
// Tiles have two rows of two pixels. A depth is one half or three quarters, and a band begins at one half or between both.
//
// Assumed, with the words of docs/units/splat/occlusion.md and tile_cache.md:
// - a slot gets a tile when the last sample of the one before has left, and samples of it come after that, the last one marked.
module proof (input clk);
    `include "sizes.vh"

    reg rst = 1;
    always @(posedge clk) rst <= 0;

    (* anyseq *) reg in_valid, in_last, in_inside, in_slot, in_behind, out_ready, placed_valid, placed_slot;
    (* anyseq *) reg depth_read_ready, depth_data_willing;
    (* anyseq *) reg [1:0] in_place;
    (* anyseq *) reg [2:0] placed_tile;
    (* anyseq *) reg [7:0] in_attribute_0;
    wire [5:0] in_pixel = in_place;
    wire [15:0] in_weight = 0, out_weight, in_early = 0, in_late = 0, out_early, out_late;
    wire [23:0] in_depth = 0, in_depth_high = 0, in_depth_low = in_behind ? 24'ha00000 : 24'h800000;
    wire in_ready, out_valid, out_last, out_inside, out_slot, depth_read_valid, depth_data_valid, depth_data_ready, event_hidden;
    wire [5:0] out_pixel, depth_read_pixel;
    wire [7:0] out_attribute_0;
    wire [23:0] out_depth, out_depth_low, out_depth_high;
    wire [1:0] depth_read_tile;
    wire [3:0] depth_read_count;
    wire [31:0] depth_data_depth;
    `UNIT unit (.*);

    wire comes = in_valid && in_ready, leaves = out_valid && out_ready;
    wire asks = depth_read_valid && depth_read_ready, given = depth_data_valid && depth_data_ready;

    // Which depths are three quarters, by tile of the image and pixel.
    (* anyconst *) reg [15:0] far;

    // Slots: whether they have a tile, which, whether its last sample has come, and how many of its depths.
    reg [1:0] held = 0, ended = 0;
    reg [1:0] tile [0:1];
    reg [2:0] known [0:1];
    // Slots whose depths are to come, the first at place 0, and how many of those of the first were asked for and have come.
    reg [1:0] order = 0, order_count = 0;
    reg [1:0] unasked = 0, unasked_count = 0;
    reg row = 0;
    reg [1:0] pixel = 0;
    always @* begin
        assume (!(placed_valid && (rst || held[placed_slot])));
        assume (!in_valid || (held[in_slot] && !ended[in_slot]));
    end
    axi_channel #(.OURS(0), .WIDTH(14)) in_stays (
        clk, rst, in_valid, in_ready, {in_last, in_inside, in_slot, in_behind, in_place, in_attribute_0}
    );
    wire all_asked = asks && row, all_given = given && &pixel;
    wire [1:0] unasked_left = unasked_count - all_asked, order_left = order_count - all_given;
    always @(posedge clk) if (!rst) begin
        if (comes && in_last) ended[in_slot] <= 1;
        if (leaves && out_last) held[out_slot] <= 0;
        if (leaves && out_last) ended[out_slot] <= 0;
        if (placed_valid) begin
            held[placed_slot] <= 1;
            tile[placed_slot] <= placed_tile[2:1];
            known[placed_slot] <= 0;
        end
        if (all_asked) unasked <= unasked >> 1;
        if (all_given) order <= order >> 1;
        if (placed_valid) unasked[unasked_left[0]] <= placed_slot;
        if (placed_valid) order[order_left[0]] <= placed_slot;
        unasked_count <= unasked_left + placed_valid;
        order_count <= order_left + placed_valid;
        row <= row + asks;
        pixel <= pixel + given;
        if (given) known[order[0]] <= known[order[0]] + 1;
    end

    // Memory answers in the order of requests.
    reg [7:0] answers = 0;
    reg [3:0] answers_count = 0;
    wire [3:0] answers_left = answers_count - given;
    wire [3:0] asked_place = {depth_read_tile, depth_read_pixel[1:0]};
    always @(posedge clk) if (!rst) begin
        answers <= answers >> given;
        if (asks) answers[answers_left[2:0]] <= far[asked_place];
        if (asks) answers[answers_left[2:0] + 3'd1] <= far[asked_place + 4'd1];
        answers_count <= answers_left + (asks ? 2 : 0);
    end
    assign depth_data_valid = answers_count != 0 && depth_data_willing;
    assign depth_data_depth = answers[0] ? 32'h3f400000 : 32'h3f000000;

    // Samples that are to leave, and how many are to be hidden.
    localparam ENTRY = 13;
    reg [ENTRY-1:0] leaving [0:15];
    reg [4:0] leaving_count = 0, hidden_count = 0;
    wire is_hidden = in_inside && in_behind && !far[{tile[in_slot], in_place}];
    wire [4:0] leaving_left = leaving_count - leaves;
    integer i;
    always @(posedge clk) if (!rst) begin
        if (leaves) for (i = 0; i < 15; i = i + 1) leaving[i] <= leaving[i + 1];
        if (comes && (in_last || !is_hidden))
            leaving[leaving_left[3:0]] <= {in_last, in_inside && !is_hidden, in_slot, in_place, in_attribute_0};
        leaving_count <= leaving_left + (comes && (in_last || !is_hidden));
        hidden_count <= hidden_count + (comes && is_hidden) - event_hidden;
    end

    // With neighbors that take and give, something moves every few cycles.
    reg [3:0] stands = 0;
    wire willing = out_ready && depth_read_ready && (depth_data_valid || answers_count == 0);
    wire work = in_valid || unasked_count != 0 || leaving_count != 0 || hidden_count != 0;
    wire moves = comes || leaves || asks || given || placed_valid || event_hidden;
    always @(posedge clk) if (!rst) stands <= moves || !work ? 0 : stands + willing;

    wire [ENTRY-1:0] next = leaving[0];
    always @(posedge clk) if (!rst) begin
        leaves_what_is_to: assert (!out_valid || leaving_count != 0);
        leaves_in_order: assert (!out_valid || {out_last, out_inside, out_slot, out_pixel, out_attribute_0} == {next[12:10], 4'd0, next[9:0]});
        leaves_when_known: assert (!out_valid || known[out_slot] == 4);
        band_stays: assert (!out_valid || (out_depth_low == 24'h800000 || out_depth_low == 24'ha00000));
        hides_what_is_behind: assert (!event_hidden || hidden_count != 0);
        asks_for_tiles: assert (!depth_read_valid || (unasked_count != 0 && depth_read_tile == tile[unasked[0]]));
        asks_for_rows: assert (!depth_read_valid || (depth_read_pixel == {4'd0, row, 1'd0} && depth_read_count == 2));
        depths_have_room: assert (!depth_data_valid || depth_data_ready);
        none_too_many: assert (leaving_left <= 9 && hidden_count <= 9 && answers_left <= 8);
        goes_on: assert (stands <= 10);
    end
    axi_channel #(.OURS(1), .WIDTH(17)) out_stays (
        clk, rst, out_valid, out_ready, {out_last, out_inside, out_slot, out_pixel, out_attribute_0}
    );
    axi_channel #(.OURS(1), .WIDTH(12)) read_stays (
        clk, rst, depth_read_valid, depth_read_ready, {depth_read_tile, depth_read_pixel, depth_read_count}
    );

`ifdef STEADY
    // Nobody waits but samples: so more cycles are searched in the same time, and faults are found that take many.
    always @* assume (rst || (out_ready && depth_read_ready && (depth_data_willing || answers_count == 0)));
`endif

    // Of one tile a sample was hidden, and another is not.
    reg hid = 0;
    always @(posedge clk) if (!rst && event_hidden) hid <= 1;
    always @(posedge clk) if (!rst) cover (hid && leaves && out_inside);
endmodule
