// splat_accumulator: a pixel is what its samples make of it, one after the other: none is lost, taken twice, or taken out of order.
//
// One pixel of two, each in a bank of its own, in one slot of two, is watched. Samples are such that sums and depth test, which are in the proof as they are,
// count them: one in front of all others begins again at one. Each has the weight and depth of one unit; the ends of its band are zero
// and zero, or zero and the largest. What samples of other pixels, and fills of them, carry is the same.
// What the tile cache wants is carried out in cycles that the page names, by what the unit shows of its samples.
//
// Assumed, with the words of docs/units/splat/accumulator.md and tile_cache.md:
// - a copy's samples have one slot and come one after the other, the last one marked;
// - a slot that still expects samples does not cease to be ready: those of all copies that came and have not retired;
// - slots change, are filled and drained while they are not ready, and no pixel is read while it is filled;
// - a slot becomes ready after a change, when all that it is said to hold was filled.
module proof (input clk);
    `include "sizes.vh"

    reg rst = 1;
    always @(posedge clk) rst <= 0;

    (* anyseq *) reg in_valid, in_last, in_inside, in_slot, in_front, fill_valid, fill_slot, fill_any, drain_enable, drain_slot;
    (* anyseq *) reg change_valid, change_slot;
    (* anyseq *) reg in_place, fill_place, drain_place;
    wire [5:0] in_pixel = in_place, fill_pixel = fill_place, drain_pixel = drain_place;
    (* anyseq *) reg [1:0] slot_ready, change_any, change_banks;
    wire [63:0] change_held = change_any;
    wire [15:0] in_weight = 1;
    wire [39:0] in_weighted_depth = 1;
    wire [23:0] in_depth_low = 0, in_depth_high = in_front ? 0 : 24'hffffff, in_attribute_0 = 1;
    wire [27:0] fill_weight = fill_any, drained_weight;
    wire [51:0] fill_depth = fill_any, drained_depth;
    wire [35:0] fill_attribute_0 = fill_any, drained_attribute_0;
    wire [5:0] drained_pixel;
    wire [63:0] masks_written, masks_dirty;
    wire [1:0] sample_reads, sample_writes;
    wire drained_valid, in_ready, retire_valid, retire_slot, event_accumulate, event_hazard, event_slot_wait;
    `UNIT unit (.*);

    (* anyconst *) reg slot;
    (* anyconst *) reg pixel;

    // Copies that came and have not retired, and whether one has begun.
    wire comes = in_valid && in_ready;
    reg begun = 0, begun_slot;
    reg [2:0] pending [0:1];
    wire begins = comes && !begun;
    initial {pending[0], pending[1]} = 6'd0;
    always @(posedge clk) if (!rst) begin
        if (comes) {begun, begun_slot} <= {!in_last, in_slot};
        pending[0] <= pending[0] + (begins && !in_slot) - (retire_valid && !retire_slot);
        pending[1] <= pending[1] + (begins && in_slot) - (retire_valid && retire_slot);
    end
    reg [1:0] was_ready = 0, write_taken = 0;
    always @(posedge clk) begin
        was_ready <= slot_ready & {2{!rst}};
        write_taken <= sample_writes & {2{!rst}};
    end
    always @* begin
        assume (!rst || !(in_valid || change_valid || fill_valid || drain_enable || slot_ready));
        assume (!begun || in_slot == begun_slot);
        assume (!(begins && &pending[in_slot]));
        assume (!(was_ready[0] && !slot_ready[0]) || pending[0] == 0);
        assume (!(was_ready[1] && !slot_ready[1]) || pending[1] == 0);
        assume (!(fill_valid && slot_ready[fill_slot]) && !(drain_enable && slot_ready[drain_slot]));
        assume (!(change_valid && slot_ready[change_slot]));
        assume (!(fill_valid && drain_enable && fill_slot == drain_slot && fill_pixel == drain_pixel));
    end

    // What is carried out.
    wire changes = change_valid && change_slot == slot && change_banks[pixel] && !sample_reads[pixel];
    wire fills = fill_valid && fill_slot == slot && fill_pixel == pixel && !write_taken[pixel];
    wire drains = drain_enable && !sample_reads[drain_place];

    // What the watched pixel must be: what it was filled with, or zero, and its samples; those that come before the fill follow it.
    localparam COUNT_BITS = 5;
    reg [COUNT_BITS-1:0] must, samples = 0;
    reg front = 0;
    wire is_sample = comes && in_inside && in_slot == slot && in_pixel == pixel;
    wire falls = was_ready[slot] && !slot_ready[slot];
    reg is_held, filled_value;
    wire [COUNT_BITS-1:0] now = samples + (front || !is_held ? 0 : filled_value);
    always @(posedge clk) if (!rst) begin
        if (falls) begin
            must <= now;
            samples <= is_sample;
            front <= is_sample && in_front;
        end else if (is_sample) begin
            samples <= in_front ? 1 : samples + 1;
            front <= front || in_front;
        end
        if (changes) is_held <= change_any[pixel];
        if (fills) filled_value <= fill_any;
    end

    // The slot changed since it was ready, and its pixel has to be filled.
    reg has_changed = 0, lacks = 0;
    always @* assume (!(slot_ready[slot] && !was_ready[slot]) || (has_changed && !lacks));
    // What its masks are, once it had a tile, and whether the pixel is what it must be.
    reg is_known = 0, is_written, is_dirty, is_whole = 0;
    wire written = falls ? samples != 0 || is_held : is_written;
    wire dirty = falls ? samples != 0 : is_dirty;
    wire whole = falls ? written : is_whole;
    always @(posedge clk) if (!rst) begin
        has_changed <= (has_changed || changes) && !slot_ready[slot];
        lacks <= changes ? change_any[pixel] : lacks && !fills;
        is_known <= is_known || changes;
        is_written <= changes ? change_any[pixel] : written;
        is_dirty <= !changes && dirty;
        is_whole <= whole && !changes && !fills;
    end

    // What was drained and what was told of a slot that changed.
    reg [1:0] drained = 0, any_drained = 0;
    reg tells = 0, told_written, told_dirty;
    wire shows = drained[1];
    always @(posedge clk) if (!rst) begin
        drained <= {drained[0], drains && drain_slot == slot && drain_place == pixel && whole};
        any_drained <= {any_drained[0], drains};
        tells <= changes && is_known;
        {told_written, told_dirty} <= {written, dirty};
    end

    always @(posedge clk) if (!rst) begin
        shows_what_was_drained: assert (drained_valid == any_drained[1] && (!shows || drained_pixel == pixel));
        as_samples_made_it: assert (!shows || (drained_weight == must && drained_depth == must && drained_attribute_0 == must));
        tells_what_was_held: assert (!tells || {masks_written[pixel], masks_dirty[pixel]} == {told_written, told_dirty});
        // Only samples that came hold up the tile cache.
        leaves_banks: assert (sample_reads != 3 && sample_writes != 3);
        waits_for_samples: assert ((sample_reads == 0 && sample_writes == 0) || pending[0] != 0 || pending[1] != 0);
        retires_what_came: assert (!retire_valid || pending[retire_slot] != 0);
        one_or_the_other: assert (event_accumulate + event_hazard + event_slot_wait <= 1);
    end
    // Samples that waited for each other are in a pixel that is drained.
    reg waited = 0;
    always @(posedge clk) if (!rst) begin
        waited <= waited || event_hazard;
        cover (shows && must == 2);
        cover (tells && told_written && !told_dirty);
        cover (retire_valid && waited);
    end
endmodule
