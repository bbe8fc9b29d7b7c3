// search_stack: every thread has a stack of its own, last in, first out, of DEPTH paths.
//
// A symbolic place is tracked: a path pushed there comes back unchanged when that place is popped. Assumed: a thread never
// holds more than DEPTH paths, and no thread is pushed and popped in one cycle.
module proof (input clk);
    `include "sizes.vh"

    reg rst = 1;
    always @(posedge clk) rst <= 0;

    (* anyseq *) reg push_valid, pop_valid;
    (* anyseq *) reg [THREAD_BITS-1:0] push_thread, pop_thread;
    (* anyseq *) reg [NODE_BITS-1:0] push_node;
    (* anyseq *) reg [SQUARE_BITS-1:0] push_distance2;
    wire top_empty;
    wire [NODE_BITS-1:0] top_node;
    wire [SQUARE_BITS-1:0] top_distance2;
    `UNIT unit (.*);

    // Paths that each thread holds, as the ports tell.
    localparam COUNT_BITS = $clog2(DEPTH + 1);
    reg [COUNT_BITS-1:0] count [0:THREADS-1];
    wire [COUNT_BITS-1:0] push_count = count[push_thread];
    wire [COUNT_BITS-1:0] pop_count = count[pop_thread];
    integer thread;
    initial for (thread = 0; thread < THREADS; thread = thread + 1) count[thread] = 0;
    always @(posedge clk) if (!rst) begin
        if (push_valid) count[push_thread] <= push_count + 1;
        if (pop_valid && pop_count != 0) count[pop_thread] <= pop_count - 1;
    end

    always @* if (!rst) begin
        assume (push_thread < THREADS && pop_thread < THREADS);
        assume (!(push_valid && push_count == DEPTH));
        assume (!(push_valid && pop_valid && push_thread == pop_thread));
    end else assume (!push_valid && !pop_valid);

    // The tracked place, its path, and what the last pop shows.
    (* anyconst *) reg [THREAD_BITS-1:0] place_thread;
    (* anyconst *) reg [COUNT_BITS-1:0] place;
    localparam PATH_BITS = NODE_BITS + SQUARE_BITS;
    wire [PATH_BITS-1:0] top = {top_node, top_distance2};
    reg [PATH_BITS-1:0] path, top_before;
    reg empty = 1, shown = 0, popped_nothing = 0;
    always @(posedge clk) if (!rst) begin
        if (push_valid && push_thread == place_thread && push_count == place) path <= {push_node, push_distance2};
        if (pop_valid) empty <= pop_count == 0;
        if (pop_valid && pop_count != 0) shown <= pop_thread == place_thread && pop_count == place + 1;
        else if (push_valid && push_thread == place_thread && push_count == place) shown <= 0;
        popped_nothing <= !(pop_valid && pop_count != 0);
        top_before <= top;
    end

    always @(posedge clk) if (!rst) begin
        empty_when_nothing_is_left: assert (top_empty == empty);
        last_in_first_out: assert (!shown || top == path);
        top_stays: assert (!popped_nothing || top == top_before);
    end

    // The deepest place, filled and popped.
    always @(posedge clk) if (!rst) cover (shown && place == DEPTH - 1);
endmodule
