// search_queue: a query's results are its nearest candidates in order, and none of them is lost.
//
// A symbolic query is watched, and of its candidates a symbolic point. Assumed of the environment, with the words of
// docs/units/search/queue.md:
// - `start` names a thread that is not busy: it was never started, or `released` came since;
// - 1 <= k <= NEIGHBORS;
// - beats come for busy threads; a thread's `finish` comes once, after `radius` has answered its last beat, which has `last`;
// - the watched query's number and its point's beat come once.
// Distances and radii may be anything that is not negative, and no stream has to hold what it offers.
module proof (input clk);
    `include "sizes.vh"
    localparam LANE_BITS = LANES == 1 ? 1 : $clog2(LANES);

    reg rst = 1;
    always @(posedge clk) rst <= 0;

    (* anyseq *) reg start_valid, candidates_valid, candidates_last, finish_valid, result_ready;
    (* anyseq *) reg [THREAD_BITS-1:0] start_thread, candidates_thread, finish_thread;
    (* anyseq *) reg [INDEX_BITS-1:0] start_number;
    (* anyseq *) reg [RANK_BITS-1:0] start_k;
    (* anyseq *) reg [SQUARE_BITS:0] start_radius2, start_x, start_y, start_z;
    (* anyseq *) reg [BEAT_BITS-1:0] candidates_address;
    (* anyseq *) reg [SQUARE_BITS-1:0] candidates_distance0, candidates_distance1;
    wire candidates_ready, finish_ready, radius_valid, released_valid, result_valid, result_last, result_found;
    wire event_beat, event_insert, event_insert_wait;
    wire [THREAD_BITS-1:0] radius_thread, released_thread;
    wire [INDEX_BITS-1:0] result_number, result_index;
    wire [SQUARE_BITS-1:0] radius_radius2;
    wire [SQUARE_BITS:0] result_distance2;
    `UNIT unit (.*);

    wire fed = candidates_valid && candidates_ready;
    wire finished = finish_valid && finish_ready;
    wire sent = result_valid && result_ready;

    // Each thread: whether it has a query, whether it was finished, whether beats of it are under way.
    reg [THREADS-1:0] busy = 0, finishing = 0, leaf_open = 0;
    reg [2:0] unanswered [0:THREADS-1];
    integer thread;
    initial for (thread = 0; thread < THREADS; thread = thread + 1) unanswered[thread] = 0;
    always @(posedge clk) if (!rst) begin
        if (start_valid) busy[start_thread] <= 1;
        if (released_valid) begin
            busy[released_thread] <= 0;
            finishing[released_thread] <= 0;
        end
        if (finished) finishing[finish_thread] <= 1;
        if (fed) leaf_open[candidates_thread] <= !candidates_last;
        for (thread = 0; thread < THREADS; thread = thread + 1)
            unanswered[thread] <= unanswered[thread] + (fed && candidates_last && candidates_thread == thread)
                - (radius_valid && radius_thread == thread);
    end
    always @* begin
        assume (!rst || !(start_valid || candidates_valid || finish_valid));
        assume (start_thread < THREADS && candidates_thread < THREADS && finish_thread < THREADS);
        assume (!start_radius2[SQUARE_BITS]);
        assume (!start_valid || !busy[start_thread]);
        assume (!start_valid || (start_k >= 1 && start_k <= NEIGHBORS));
        assume (!fed || (busy[candidates_thread] && !finishing[candidates_thread]));
        assume (!finished || (busy[finish_thread] && !finishing[finish_thread]));
        assume (!finished || (!leaf_open[finish_thread] && unanswered[finish_thread] == 0));
        assume (!(finished && fed && finish_thread == candidates_thread));
    end

    // The watched query.
    (* anyconst *) reg [THREAD_BITS-1:0] query_thread;
    (* anyconst *) reg [INDEX_BITS-1:0] query_number;
    (* anyconst *) reg [RANK_BITS-1:0] k;
    (* anyconst *) reg [SQUARE_BITS:0] radius2;
    reg met = 0, searching = 0, answered = 0;
    wire starts = start_valid && start_number == query_number;
    always @* assume (!starts || (!met && start_thread == query_thread && start_k == k && start_radius2 == radius2));
    wire result = sent && result_number == query_number;
    always @(posedge clk) if (!rst) begin
        if (starts) {met, searching} <= 2'b11;
        if (finished && finish_thread == query_thread) searching <= 0;
        if (result && result_last) answered <= 1;
    end

    // Its symbolic point.
    (* anyconst *) reg [BEAT_BITS-1:0] beat;
    (* anyconst *) reg [LANE_BITS-1:0] lane;
    wire [INDEX_BITS-1:0] point = LANES == 1 ? beat : {beat, lane};
    wire point_fed = fed && searching && candidates_thread == query_thread && candidates_address == beat;
    reg was_fed = 0, seen = 0;
    reg [SQUARE_BITS-1:0] distance2;
    always @* assume (lane < LANES && (!point_fed || !was_fed));
    wire shows_point = result && result_found && result_index == point;
    always @(posedge clk) if (!rst) begin
        if (point_fed) begin
            was_fed <= 1;
            distance2 <= lane == 0 ? candidates_distance0 : candidates_distance1;
        end
        seen <= seen || shows_point;
    end

    // What it has been told, and what it has told.
    reg [SQUARE_BITS:0] known_radius2, previous;
    reg [RANK_BITS:0] count = 0;
    wire narrows = radius_valid && met && !answered && radius_thread == query_thread;
    always @(posedge clk) if (!rst) begin
        if (starts) known_radius2 <= radius2;
        if (narrows && (searching || finishing[query_thread])) known_radius2 <= radius_radius2;
        if (result) begin
            count <= count + 1;
            previous <= result_distance2;
        end
    end

    always @(posedge clk) if (!rst) begin
        one_last: assert (!result || (met && !searching && !answered));
        k_at_most: assert (!result || count < k);
        sorted: assert (!result || count == 0 || result_distance2 >= previous);
        found_unless_alone: assert (!result || result_found || (count == 0 && result_last));
        none_from_nothing: assert (!shows_point || (was_fed && result_distance2 == distance2 && distance2 < radius2));
        none_twice: assert (!shows_point || !seen);
        none_lost: assert (!(result && result_last && was_fed && distance2 < radius2) || seen || shows_point
            || (count + 1 == k && result_found && result_distance2 <= distance2));
        radius_is_the_farthest: assert (!(result && result_last)
            || known_radius2 == (count + 1 == k && result_found ? result_distance2 : radius2));
    end

    // Once it is finished its last result is `PATIENCE` cycles away at most, not counting those in which the sink stalls.
    localparam PATIENCE = 2 * (NEIGHBORS + 3);
    reg [7:0] waited = 0;
    always @(posedge clk) if (!rst) begin
        waited <= waited + (met && !searching && !answered && result_ready);
        comes_to_an_end: assert (waited <= PATIENCE);
    end

    // A full row that pushed the point out.
    always @(posedge clk) if (!rst) cover (result && result_last && count + 1 == NEIGHBORS && was_fed && !seen);
endmodule
