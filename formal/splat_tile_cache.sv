// splat_tile_cache: what samples left in a pixel is there when its tile's next samples come, and in the frame that is sent, while the
// next one is drawn.
//
// One pixel of a symbolic tile is watched: in the slots, which are here with their masks and data as docs/units/splat/accumulator.md has
// them; on both surfaces of the reconstruction buffer, whose other words are free; and as it must be. Samples of copies that are under
// way in a ready slot change it as they like. Values are a bit, repeated in all fields and compared in two of them: it stands for any bit
// of a pixel, with a weight where it is set. Samples come to three pixels of a tile: one alone in its row, and two beside each other in
// another.
//
// Assumed, with the words of docs/units/splat/tile_cache.md:
// - copies and ends arrive, one in two cycles, while the unit is not full; later they come, those of a tile in the order in which they
//   arrived, and all that arrived before an end before it, the others behind it; there are no more than COPIES between both ends;
// - two copies of one tile have different splats until the first of them was passed on;
// - copies retire that are under way, one a cycle, at any time; there are no more than UNDER_WAY in a slot;
// - the buffer answers each read with its pixels in order, at any time, as of all writes accepted before it; what was never written is
//   anything; it takes up to three reads before it has answered;
// - the slots carry out a change, a drain or a fill in a cycle that they choose, as told by `sample_reads` and `sample_writes`, and show
//   masks and pixels when the page says.
module proof (input clk);
    `include "sizes.vh"
    localparam SLOTS = 2;
    localparam COPIES = 4;
    localparam UNDER_WAY = 2;
    localparam FRAME_BITS = 3;

    reg rst = 1;
    always @(posedge clk) rst <= 0;

    (* anyseq *) reg arrives_valid, arrives_end, in_valid, out_ready, read_ready, data_valid, write_ready, pixel_ready, retire_valid, retire_slot;
    (* anyseq *) reg [1:0] arrives_tile, sample_reads, sample_writes;
    (* anyseq *) reg [SPLAT_BITS-1:0] arrives_splat;
    (* anyseq *) reg data_any, held_any, sample;
    (* anyconst *) reg [31:0] any;
    wire [2:0] in_left = any, in_right = any, in_top = any, in_bottom = any;
    wire [3:0] in_first_sum = any, in_last_sum = any, in_first_difference = any, in_last_difference = any;
    wire full, in_end, in_ready, out_valid, out_slot, read_valid, read_surface, data_ready, write_valid, write_surface;
    wire pixel_valid, pixel_end, fill_valid, fill_slot, change_valid, change_slot, drain_enable, drain_slot;
    wire [1:0] change_banks;
    wire [63:0] change_held;
    wire [1:0] in_tile, out_tile, read_tile, write_tile, pixel_tile, slot_ready;
    wire [SPLAT_BITS-1:0] in_splat, out_splat;
    wire [5:0] read_pixel, write_pixel, pixel_pixel, fill_pixel, drain_pixel;
    wire [3:0] read_count;
    wire [ATTRIBUTE_BITS-1:0] write_attribute_0, pixel_attribute_0, fill_attribute_0, data_attribute_0, drained_attribute_0;
    wire [27:0] data_weight, write_weight, pixel_weight, fill_weight, drained_weight;
    wire [51:0] data_depth, write_depth, pixel_depth, fill_depth, drained_depth;
    `UNIT unit (
        .out_left(), .out_right(), .out_top(), .out_bottom(),
        .out_first_sum(), .out_last_sum(), .out_first_difference(), .out_last_difference(), .*
    );
    wire [1:0] written_value = {write_weight[0], write_attribute_0[0]};
    wire [1:0] pixel_value = {pixel_weight[0], pixel_attribute_0[0]};
    wire [1:0] fill_value = {fill_weight[0], fill_attribute_0[0]};

    // The pixels that samples come to, and the watched one of them.
    localparam FIRST = 6'd0, SECOND = 6'd62, THIRD = 6'd63;
    (* anyconst *) reg [1:0] tile, place;
    wire [5:0] pixel = place == 0 ? FIRST : place == 1 ? SECOND : THIRD;
    always @* assume (place < 3);
    function [63:0] of_tile(input [2:0] places);
        of_tile = {places[2:1], 61'd0, places[0]};
    endfunction
    function [2:0] places_of(input [63:0] mask);
        places_of = {mask[63:62], mask[0]};
    endfunction

    // Copies that arrived and were not passed on, and ends that have not come, in the order of arrival. Frames are numbered: which one
    // arrives, is drawn, is sent. One is drawn until all of it has come, and all its copies have retired.
    reg [FRAME_BITS-1:0] arriving = 0, drawn = 0, sending = 0;
    reg [COPIES-1:0] kept = 0, came_in, is_late, is_end;
    wire arrives_late;
    reg [1:0] copy_tile [0:COPIES-1];
    reg [SPLAT_BITS-1:0] copy_splat [0:COPIES-1];
    reg [FRAME_BITS-1:0] copy_frame [0:COPIES-1];
    (* anyseq *) reg [$clog2(COPIES)-1:0] turn;
    reg [COPIES-1:0] may_come, is_drawn, is_watched, is_twin, is_passed, stays, moves_on;
    reg [1:0] under_way [0:SLOTS-1];
    reg [1:0] slot_tile [0:SLOTS-1];
    wire comes = in_valid && in_ready;
    wire placed = out_valid && out_ready;
    wire all_retired = under_way[0] == 0 && under_way[1] == 0;
    assign in_end = is_end[turn], in_tile = copy_tile[turn], in_splat = copy_splat[turn];
    integer copy, other;
    always @* for (copy = 0; copy < COPIES; copy = copy + 1) begin
        may_come[copy] = kept[copy] && !came_in[copy];
        for (other = 0; other < copy; other = other + 1)
            if (kept[other] && !came_in[other] && (is_end[other] || is_end[copy] || copy_tile[other] == copy_tile[copy])) may_come[copy] = 0;
        is_drawn[copy] = kept[copy] && copy_frame[copy] == drawn;
        is_watched[copy] = is_drawn[copy] && !is_end[copy] && copy_tile[copy] == tile;
        is_twin[copy] = kept[copy] && !is_end[copy] && copy_tile[copy] == arrives_tile && copy_splat[copy] == arrives_splat;
        is_passed[copy] = kept[copy] && came_in[copy] && copy_tile[copy] == out_tile && copy_splat[copy] == out_splat;
        stays[copy] = kept[copy] && !(placed && is_passed[copy]) && !(comes && in_end && turn == copy);
        // Those behind one that leaves move on.
        moves_on[copy] = !stays[copy] || (copy != 0 && moves_on[copy-1]);
    end
    reg was_arrival = 0, was_arriving = 0;
    wire turns = arriving != drawn && is_drawn == 0 && all_retired;
    wire closes = pixel_valid && pixel_ready && pixel_end;
    initial {under_way[0], under_way[1]} = 4'd0;
    always @(posedge clk) if (!rst) begin
        for (copy = 0; copy < COPIES; copy = copy + 1)
            if (!moves_on[copy]) begin
                kept[copy] <= 1;
                if (comes && turn == copy) came_in[copy] <= 1;
            end else if (copy + 1 == COPIES) begin
                kept[copy] <= arrives_valid;
                {came_in[copy], is_late[copy], is_end[copy], copy_tile[copy], copy_splat[copy], copy_frame[copy]}
                    <= {1'd0, arrives_late, arrives_end, arrives_tile, arrives_splat, arriving};
            end else begin
                kept[copy] <= stays[copy+1];
                {came_in[copy], is_late[copy], is_end[copy], copy_tile[copy], copy_splat[copy], copy_frame[copy]}
                    <= {came_in[copy+1] || (comes && turn == copy + 1), is_late[copy+1], is_end[copy+1], copy_tile[copy+1], copy_splat[copy+1],
                        copy_frame[copy+1]};
            end
        under_way[0] <= under_way[0] + (placed && !out_slot) - (retire_valid && !retire_slot);
        under_way[1] <= under_way[1] + (placed && out_slot) - (retire_valid && retire_slot);
        if (placed) slot_tile[out_slot] <= out_tile;
        was_arrival <= arrives_valid;
        if (arrives_valid) was_arriving <= !arrives_end;
        arriving <= arriving + (arrives_valid && arrives_end);
        drawn <= drawn + turns;
        sending <= sending + closes;
    end
    always @* begin
        assume (!rst || !(arrives_valid || in_valid || retire_valid || data_valid));
        assume (!arrives_valid || !(full || was_arrival || &kept));
        assume (!arrives_valid || arrives_end || is_twin == 0);
        assume (!in_valid || may_come[turn]);
        assume (!retire_valid || under_way[retire_slot] != 0);
        assume (!placed || under_way[out_slot] < UNDER_WAY);
    end

    // What is carried out of what the unit wants of the slots.
    reg [1:0] write_taken = 0;
    always @(posedge clk) write_taken <= sample_writes & {2{!rst}};
    wire [1:0] changes = {2{change_valid}} & change_banks & ~sample_reads;
    wire drains = drain_enable && !sample_reads[drain_pixel[0]];
    wire fills = fill_valid && !write_taken[fill_pixel[0]];

    // The watched pixel in the slots, in the buffer, and as it must be. A sample may come to any ready slot, and to any place in it.
    (* anyseq *) reg sampled, sampled_slot;
    (* anyseq *) reg [1:0] sampled_place;
    reg held [0:SLOTS-1];
    reg [3:0] written [0:SLOTS-1], dirty [0:SLOTS-1];
    reg [3:0] told_written, told_dirty;
    wire [63:0] masks_written = of_tile(told_written[2:0]), masks_dirty = of_tile(told_dirty[2:0]);
    // On both surfaces, and of the frame that is drawn, from its first copy to that of the next.
    reg [1:0] stored, in_memory = 0;
    reg must = 0, begun = 0, surface = 0;
    // As it was when its frame was drawn: of the frames that were and are not sent.
    reg [3:0] results;
    wire [FRAME_BITS-1:0] unsent = drawn - sending;
    wire sent_value = unsent != 0 ? results[sending[1:0]] : begun && must;
    // Copies of its tile are to come, or to retire.
    wire [1:0] is_in_slot = {under_way[1] != 0 && slot_tile[1] == tile, under_way[0] != 0 && slot_tile[0] == tile};
    wire gets_more = is_watched != 0 || is_in_slot != 0;
    reg [1:0] shows = 0;
    reg shown [0:1];
    reg [5:0] shown_pixel [0:1];
    wire is_filled = fills && fill_pixel == pixel;
    wire samples = sampled && slot_ready[sampled_slot] && under_way[sampled_slot] != 0;
    wire is_sampled = samples && sampled_place == place;
    wire is_own = is_sampled && slot_tile[sampled_slot] == tile;
    wire is_written = write_valid && write_ready && write_tile == tile && write_pixel == pixel;
    wire asks = read_valid && read_ready;
    wire asks_for_it = asks && read_tile == tile && pixel >= read_pixel && pixel - read_pixel < read_count;
    wire asks_to_send = asks_for_it && !(read_surface == drawn[0] && gets_more);
    always @* assume (sampled_place < 3);
    always @(posedge clk) if (!rst) begin
        // The first two places are in one bank, the third in the other.
        if (changes[0]) begin
            {told_written[1:0], told_dirty[1:0]} <= {written[change_slot][1:0], dirty[change_slot][1:0]};
            written[change_slot][1:0] <= {change_held[62], change_held[0]};
            dirty[change_slot][1:0] <= 0;
        end
        if (changes[1]) begin
            {told_written[2], told_dirty[2]} <= {written[change_slot][2], dirty[change_slot][2]};
            written[change_slot][2] <= change_held[63];
            dirty[change_slot][2] <= 0;
        end
        if (is_filled) held[fill_slot] <= fill_value[0];
        if (samples) begin
            written[sampled_slot][sampled_place] <= 1;
            dirty[sampled_slot][sampled_place] <= 1;
        end
        if (is_sampled) held[sampled_slot] <= sample;
        if (is_own) must <= sample;
        else if (placed && !begun) must <= 0;
        if (placed) surface <= drawn[0];
        begun <= placed || (begun && !turns);
        if (turns) results[drawn[1:0]] <= begun && must;
        if (is_written) stored[write_surface] <= written_value[0];
        if (asks_to_send) in_memory[read_surface] <= 0;
        if (is_written) in_memory[write_surface] <= 1;
        shows <= {shows[0], drains};
        shown_pixel[0] <= drain_pixel;
        shown_pixel[1] <= shown_pixel[0];
        shown[0] <= drain_pixel == pixel ? held[drain_slot] : held_any;
        shown[1] <= shown[0];
    end
    wire drained_valid = shows[1];
    wire [5:0] drained_pixel = shown_pixel[1];
    assign drained_weight = {28{shown[1]}}, drained_depth = {52{shown[1]}}, drained_attribute_0 = {ATTRIBUTE_BITS{shown[1]}};

    // The buffer's answers: reads that it took, the oldest first.
    reg [1:0] owed = 0;
    reg [3:0] came = 0;
    reg asked_value [0:2];
    reg [1:0] asked_tile [0:2];
    reg [5:0] asked_pixel [0:2];
    reg [3:0] asked_count [0:2];
    wire answers = data_valid && data_ready;
    wire last_answer = answers && came + 1 == asked_count[0];
    wire is_answered = asked_tile[0] == tile && asked_pixel[0] + came == pixel;
    wire data = is_answered ? asked_value[0] : data_any;
    wire [1:0] left = owed - last_answer;
    always @* begin
        assume (!data_valid || owed != 0);
        assume (!read_ready || owed != 3);
    end
    integer index;
    always @(posedge clk) if (!rst) begin
        owed <= left + asks;
        came <= last_answer ? 0 : came + answers;
        for (index = 0; index < 3; index = index + 1)
            if (asks && left == index) begin
                {asked_tile[index], asked_pixel[index], asked_count[index], asked_value[index]}
                    <= {read_tile, read_pixel, read_count, stored[read_surface]};
            end else if (last_answer && index < 2) begin
                {asked_tile[index], asked_pixel[index], asked_count[index], asked_value[index]}
                    <= {asked_tile[index+1], asked_pixel[index+1], asked_count[index+1], asked_value[index+1]};
            end
    end
    assign data_weight = {28{data}}, data_depth = {52{data}}, data_attribute_0 = {ATTRIBUTE_BITS{data}};

`ifdef STEADY
    // Tiles leave and come back soon, and few ways lead there: copies of three tiles come in turn, each with a sample when its slot is
    // ready, and frames follow each other. Samples have the banks in every second cycle; little else waits.
    (* anyseq *) reg samples_stay;
    (* anyconst *) reg [31:0] ends;
    (* anyconst *) reg [2:0] late;
    (* anyconst *) reg first_go, keeps_second;
    reg samples_go;
    reg [1:0] next_tile;
    wire [1:0] arrives_next;
    reg [4:0] arrived = 0;
    always @(posedge clk) begin
        samples_go <= rst ? first_go : !samples_go;
        if (arrives_valid) arrived <= arrived + 1;
    end
    wire [1:0] done = {slot_ready[1] && under_way[1] != 0 && !keeps_second, slot_ready[0] && under_way[0] != 0};
    wire [COPIES-1:0] waiting = may_come & ~is_late;
    assign arrives_late = arrived == late && !(&late);
    always @* if (!rst) begin
        assume (arrives_valid == !(full || was_arrival || &kept) && arrives_tile == arrives_next && arrives_end == ends[arrived]);
        assume (in_valid == (waiting != 0) && (waiting & ((1 << turn) - 1)) == 0 && (!in_valid || waiting[turn]));
        assume (out_ready && read_ready == (owed != 3) && pixel_ready && data_valid == (owed != 0));
        assume (sample_reads == {2{samples_go || samples_stay}} && sample_writes == {2{samples_go}});
        assume (retire_valid == (done != 0) && retire_slot == !done[0]);
        assume (sampled == retire_valid && sampled_slot == retire_slot);
    end
`ifdef LATE
    // One copy, of the tile of the one before it, does not come, and the second slot may keep what it has, while others go on and a
    // frame ends. The tile looked at last comes first, and samples come to the watched place.
    reg [1:0] same_tile = 3;
    initial next_tile = 3;
    assign arrives_next = arrives_late ? same_tile : next_tile;
    always @(posedge clk) if (arrives_valid && !arrives_end) begin
        same_tile <= arrives_tile;
        if (!arrives_late) next_tile <= next_tile == 1 ? 3 : next_tile - 1;
    end
    always @* if (!rst) begin
        assume (first_go && !samples_stay && write_ready && (!sampled || sampled_place == 0));
        assume (place == 0 && !data_any && !held_any);
    end
`else
    // Samples may stay while a pixel is to be drained, and the buffer's writes wait.
    initial next_tile = 0;
    assign arrives_next = next_tile;
    always @(posedge clk) if (arrives_valid && !arrives_end) next_tile <= next_tile == 2 ? 0 : next_tile + 1;
    always @* assume (&late && !keeps_second);
    always @* if (!rst) assume ((!samples_stay || drain_enable) && (!sampled || sampled_place != 1));
`endif
`else
    assign arrives_late = 0;
`endif

    // What of the frame was sent.
    reg seen = 0, seen_value, is_left = 0, any_sent = 0;
    reg [1:0] last_tile;
    reg [5:0] last_pixel;
    wire sends = pixel_valid && pixel_ready && !pixel_end;
    wire is_sent = sends && pixel_tile == tile && pixel_pixel == pixel;
    always @(posedge clk) if (!rst) begin
        seen <= (seen || is_sent) && !closes;
        if (is_sent) seen_value <= pixel_value[0];
        any_sent <= (any_sent || sends) && !closes;
        if (sends) {last_tile, last_pixel} <= {pixel_tile, pixel_pixel};
        is_left <= (is_left || (sends && any_sent && last_tile == tile && pixel_tile != tile)) && !closes;
    end

    always @(posedge clk) if (!rst) begin
        // In a slot.
        passes_what_came: assert (!out_valid || is_passed != 0);
        frames_in_turn: assert (!placed || (is_passed & is_drawn) != 0);
        one_tile_a_slot: assert (!(placed && under_way[out_slot] != 0) || slot_tile[out_slot] == out_tile);
        one_slot_a_tile: assert (!(placed && under_way[!out_slot] != 0) || slot_tile[!out_slot] != out_tile);
        sample_finds_its_pixel: assert (!is_own || (written[sampled_slot][place] && held[sampled_slot]) == must);
        fills_what_is_not_ready: assert (!(fill_valid && slot_ready[fill_slot]));
        drains_what_is_not_ready: assert (!(drain_enable && slot_ready[drain_slot]));
        changes_what_is_not_ready: assert (!(change_valid && slot_ready[change_slot]));
        fills_what_moves: assert (!is_filled || fill_value == {2{fill_value[0]}});
        holds_no_more: assert (!change_valid || change_held == of_tile(places_of(change_held)));
        // In the buffer.
        writes_what_was_there: assert (!is_written || (written_value == {2{must}} && write_surface == surface));
        asks_for_what_was_written: assert (!asks_for_it || in_memory[read_surface]);
        asks_within_a_row: assert (!asks || (read_count != 0 && read_pixel[2:0] + read_count <= 8));
        finds_its_surface_empty: assert (!(arrives_valid && !was_arriving) || !in_memory[arriving[0]]);
        // In the frame.
        sends_a_whole_frame: assert (!pixel_valid || arriving != sending);
        leaves_with_its_last_copy: assert (!(sends && pixel_tile == tile && unsent == 0) || !gets_more);
        sent_once: assert (!is_sent || (!seen && sent_value && pixel_value == {2{sent_value}}));
        none_lost: assert (!closes || (unsent != 0 && (seen ? seen_value : 1'b0) == sent_value));
        in_order: assert (!(sends && any_sent && pixel_tile == last_tile) || pixel_pixel > last_pixel);
        tile_by_tile: assert (!(sends && is_left) || pixel_tile != tile);
        // What waits for the output has left the unit otherwise.
        two_frames_under_way: assert (pixel_valid || arriving - sending <= 2);
        frames_under_way: assert (arriving - sending <= 4);
    end

`ifdef STEADY
    // It goes on: a step is never more than PATIENCE cycles away in which the neighbors let it. Of a frame of tiles that nothing was
    // drawn to nothing shows while their codes pass.
    localparam PATIENCE = 9;
    wire moves = comes || placed || asks || answers || (write_valid && write_ready) || (pixel_valid && pixel_ready) || fills || drains
        || changes != 0;
    reg [5:0] stands = 0;
    always @(posedge clk) if (!rst) begin
        stands <= moves || keeps_second || (kept & is_late) != 0 ? 0 : stands + ((write_ready || !write_valid) && sample_reads == 0);
        goes_on: assert (stands <= PATIENCE);
    end

    // A pixel that went to the buffer and came back gets another sample; a frame with samples is closed; its pixels are sent while copies
    // of it are to come, and while the next one is drawn; pixels of a second frame are sent.
    reg was_written = 0, was_loaded = 0;
    always @(posedge clk) if (!rst) begin
        was_written <= was_written || (is_written && must);
        was_loaded <= was_loaded || (was_written && is_filled && fill_value[0]);
        comes_back: cover (was_loaded && is_own);
        closed: cover (closes && seen);
        leaves_early: cover (is_sent && unsent == 0);
        leaves_behind: cover (is_sent && unsent != 0 && begun);
        second: cover (is_sent && sending == 1);
    end
`else
    // Copies keep their order and tiles.
    in_order #(.WIDTH(2), .COUNT_BITS(3), .PATIENCE(15)) copies (
        .clk, .rst, .noted(1'd0), .known(), .notes(), .count(), .push(comes && !in_end), .pushed(in_tile),
        .offered(out_valid), .valid(out_valid), .ready(out_ready), .shown(out_tile)
    );

    // What is shown stays until it is taken.
    axi_channel #(.OURS(1), .WIDTH(3)) reads (clk, rst, read_valid, read_ready, {read_surface, read_tile});
    axi_channel #(.OURS(1), .WIDTH(11)) writes (clk, rst, write_valid, write_ready, {write_surface, write_tile, write_pixel, written_value});

    // A copy waits for the slot that it needs, and its tile is the second in it.
    always @(posedge clk) if (!rst) cover (in_valid && !in_ready && is_own);
`endif
endmodule
