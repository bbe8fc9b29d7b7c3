// The whole design is one file, named after its top.
/* verilator lint_off DECLFILENAME */

// Neighbor search: queries in, nearest neighbors out.
module search_top (
    input  wire clk, input wire rst,
    input  wire tree_valid,  // Write to the tree memories, not while a query is under way.
    input  wire tree_is_leaf,  // Chooses the leaf table, else the node memory.
    input  wire [5:0] tree_address,  // The leaf's number or the node.
    input  wire [23:0] tree_split,  // Where its plane cuts its dimension.
    input  wire [1:0] tree_dimension,  // Its dimension.
    input  wire tree_internal_leaf,  // It is a leaf.
    input  wire [15:0] tree_begin,  // The first beat.
    input  wire [3:0] tree_beats,  // The number of beats, at least one.
    input  wire query_valid, output wire query_ready,  // Queries.
    input  wire [15:0] query_number,  // Its number, which its results bear.
    input  wire [3:0] query_k,  // Neighbors wanted.
    input  wire [23:0] query_radius2,  // Squared radius within which neighbors count.
    input  wire [23:0] query_x,  // Where.
    input  wire [23:0] query_y,  // Where.
    input  wire [23:0] query_z,  // Where.
    output wire fetch_valid, input wire fetch_ready,  // Requests to the memory.
    output wire [1:0] fetch_thread,  // Thread.
    output wire [15:0] fetch_address,  // First beat.
    output wire [3:0] fetch_beats,  // Number of beats, at least one.
    input  wire beat_valid, output wire beat_ready,  // Points from memory: the beats of a request in order and together, requests in any order.
    input  wire [1:0] beat_thread,  // Thread.
    input  wire [15:0] beat_address,  // Address in the point memory.
    input  wire beat_last,  // Closes its leaf.
    input  wire [23:0] beat_x0,  // A point a lane; NaN where there is none.
    input  wire [23:0] beat_y0,  // A point a lane; NaN where there is none.
    input  wire [23:0] beat_z0,  // A point a lane; NaN where there is none.
    output wire result_valid, input wire result_ready,  // Neighbors, nearest first, a query after the other.
    output wire [15:0] result_number,  // The query's number.
    output wire result_last,  // Closes the query.
    output wire result_found,  // Low for a query without any neighbor.
    output wire [15:0] result_index,  // The neighbor's place in the point memory.
    output wire [23:0] result_distance2,  // Its squared distance.
    output wire event_node,  // A node was visited.
    output wire event_pop,  // A path was popped.
    output wire event_beat,  // A priority queue was done with a beat of points.
    output wire event_insert,  // A neighbor was inserted.
    output wire event_thread_wait  // A query waited for a free thread.
);
    wire threads_start_valid;
    wire [1:0] threads_start_thread;
    wire [15:0] threads_start_number;
    wire [3:0] threads_start_k;
    wire [23:0] threads_start_radius2, threads_start_x, threads_start_y, threads_start_z;
    wire threads_descend_valid;
    wire [1:0] threads_descend_thread;
    wire [6:0] threads_descend_node;
    wire threads_pop_valid;
    wire [1:0] threads_pop_thread;
    wire threads_finish_valid;
    wire [1:0] threads_finish_thread;
    wire traversal_descend_ready, traversal_resume_ready, traversal_leaf_valid;
    wire [1:0] traversal_leaf_thread;
    wire [5:0] traversal_leaf_leaf;
    wire traversal_push_valid;
    wire [1:0] traversal_push_thread;
    wire [6:0] traversal_push_node;
    wire [22:0] traversal_push_distance2;
    wire traversal_reached_valid;
    wire [1:0] traversal_reached_thread;
    wire stack_top_empty;
    wire [6:0] stack_top_node;
    wire [22:0] stack_top_distance2;
    wire recursion_in_ready, recursion_resume_valid;
    wire [1:0] recursion_resume_thread;
    wire [6:0] recursion_resume_node;
    wire recursion_pop_valid;
    wire [1:0] recursion_pop_thread;
    wire recursion_empty_valid;
    wire [1:0] recursion_empty_thread;
    wire leaf_leaf_ready, leaf_candidates_valid;
    wire [1:0] leaf_candidates_thread;
    wire [15:0] leaf_candidates_address;
    wire leaf_candidates_last;
    wire [22:0] leaf_candidates_distance0;
    wire sieve_candidates_ready, sieve_kept_valid;
    wire [1:0] sieve_kept_thread;
    wire [15:0] sieve_kept_address;
    wire sieve_kept_last;
    wire [22:0] sieve_kept_distance0;
    wire sieve_skipped_valid;
    wire [1:0] sieve_skipped_thread;
    wire queue_candidates_ready, queue_finish_ready, queue_radius_valid;
    wire [1:0] queue_radius_thread;
    wire [22:0] queue_radius_radius2;
    wire queue_released_valid;
    wire [1:0] queue_released_thread;

    search_threads threads (
        .clk(clk), .rst(rst), .query_valid(query_valid), .query_ready(query_ready),
        .query_number(query_number), .query_k(query_k), .query_radius2(query_radius2), .query_x(query_x),
        .query_y(query_y), .query_z(query_z),
        .start_valid(threads_start_valid), .start_thread(threads_start_thread),
        .start_number(threads_start_number), .start_k(threads_start_k), .start_radius2(threads_start_radius2),
        .start_x(threads_start_x), .start_y(threads_start_y), .start_z(threads_start_z),
        .descend_valid(threads_descend_valid), .descend_ready(traversal_descend_ready),
        .descend_thread(threads_descend_thread), .descend_node(threads_descend_node),
        .pop_valid(threads_pop_valid), .pop_ready(recursion_in_ready), .pop_thread(threads_pop_thread),
        .finish_valid(threads_finish_valid), .finish_ready(queue_finish_ready),
        .finish_thread(threads_finish_thread),
        .reached_valid(traversal_reached_valid), .reached_thread(traversal_reached_thread),
        .leaf_done_valid(queue_radius_valid), .leaf_done_thread(queue_radius_thread),
        .skipped_valid(sieve_skipped_valid), .skipped_thread(sieve_skipped_thread),
        .empty_valid(recursion_empty_valid), .empty_thread(recursion_empty_thread),
        .released_valid(queue_released_valid), .released_thread(queue_released_thread),
        .event_thread_wait(event_thread_wait)
    );

    search_traversal traversal (
        .clk(clk), .rst(rst), .start_valid(threads_start_valid), .start_thread(threads_start_thread),
        .start_number(threads_start_number), .start_k(threads_start_k), .start_radius2(threads_start_radius2),
        .start_x(threads_start_x), .start_y(threads_start_y), .start_z(threads_start_z),
        .descend_valid(threads_descend_valid), .descend_ready(traversal_descend_ready),
        .descend_thread(threads_descend_thread), .descend_node(threads_descend_node),
        .resume_valid(recursion_resume_valid), .resume_ready(traversal_resume_ready),
        .resume_thread(recursion_resume_thread), .resume_node(recursion_resume_node),
        .leaf_valid(traversal_leaf_valid), .leaf_ready(leaf_leaf_ready), .leaf_thread(traversal_leaf_thread),
        .leaf_leaf(traversal_leaf_leaf),
        .tree_valid(tree_valid), .tree_is_leaf(tree_is_leaf), .tree_address(tree_address),
        .tree_split(tree_split), .tree_dimension(tree_dimension), .tree_internal_leaf(tree_internal_leaf),
        .tree_begin(tree_begin), .tree_beats(tree_beats),
        .event_node(event_node),
        .push_valid(traversal_push_valid), .push_thread(traversal_push_thread),
        .push_node(traversal_push_node), .push_distance2(traversal_push_distance2),
        .reached_valid(traversal_reached_valid), .reached_thread(traversal_reached_thread)
    );

    search_stack stack (
        .clk(clk), .rst(rst), .push_valid(traversal_push_valid), .push_thread(traversal_push_thread),
        .push_node(traversal_push_node), .push_distance2(traversal_push_distance2),
        .pop_valid(recursion_pop_valid), .pop_thread(recursion_pop_thread),
        .top_empty(stack_top_empty), .top_node(stack_top_node), .top_distance2(stack_top_distance2)
    );

    search_recursion recursion (
        .clk(clk), .rst(rst), .start_valid(threads_start_valid), .start_thread(threads_start_thread),
        .start_number(threads_start_number), .start_k(threads_start_k), .start_radius2(threads_start_radius2),
        .start_x(threads_start_x), .start_y(threads_start_y), .start_z(threads_start_z),
        .radius_valid(queue_radius_valid), .radius_thread(queue_radius_thread),
        .radius_radius2(queue_radius_radius2),
        .in_valid(threads_pop_valid), .in_ready(recursion_in_ready), .in_thread(threads_pop_thread),
        .top_empty(stack_top_empty), .top_node(stack_top_node), .top_distance2(stack_top_distance2),
        .resume_valid(recursion_resume_valid), .resume_ready(traversal_resume_ready),
        .resume_thread(recursion_resume_thread), .resume_node(recursion_resume_node),
        .pop_valid(recursion_pop_valid), .pop_thread(recursion_pop_thread),
        .empty_valid(recursion_empty_valid), .empty_thread(recursion_empty_thread),
        .event_pop(event_pop)
    );

    search_leaf leaf (
        .clk(clk), .rst(rst), .tree_valid(tree_valid), .tree_is_leaf(tree_is_leaf),
        .tree_address(tree_address), .tree_split(tree_split), .tree_dimension(tree_dimension),
        .tree_internal_leaf(tree_internal_leaf), .tree_begin(tree_begin), .tree_beats(tree_beats),
        .leaf_valid(traversal_leaf_valid), .leaf_ready(leaf_leaf_ready), .leaf_thread(traversal_leaf_thread),
        .leaf_leaf(traversal_leaf_leaf),
        .fetch_valid(fetch_valid), .fetch_ready(fetch_ready), .fetch_thread(fetch_thread),
        .fetch_address(fetch_address), .fetch_beats(fetch_beats),
        .start_valid(threads_start_valid), .start_thread(threads_start_thread),
        .start_number(threads_start_number), .start_k(threads_start_k), .start_radius2(threads_start_radius2),
        .start_x(threads_start_x), .start_y(threads_start_y), .start_z(threads_start_z),
        .beat_valid(beat_valid), .beat_ready(beat_ready), .beat_thread(beat_thread),
        .beat_address(beat_address), .beat_last(beat_last), .beat_x0(beat_x0), .beat_y0(beat_y0),
        .beat_z0(beat_z0),
        .candidates_valid(leaf_candidates_valid), .candidates_ready(sieve_candidates_ready),
        .candidates_thread(leaf_candidates_thread), .candidates_address(leaf_candidates_address),
        .candidates_last(leaf_candidates_last), .candidates_distance0(leaf_candidates_distance0)
    );

    search_sieve sieve (
        .clk(clk), .rst(rst), .start_valid(threads_start_valid), .start_thread(threads_start_thread),
        .start_number(threads_start_number), .start_k(threads_start_k), .start_radius2(threads_start_radius2),
        .start_x(threads_start_x), .start_y(threads_start_y), .start_z(threads_start_z),
        .radius_valid(queue_radius_valid), .radius_thread(queue_radius_thread),
        .radius_radius2(queue_radius_radius2),
        .candidates_valid(leaf_candidates_valid), .candidates_ready(sieve_candidates_ready),
        .candidates_thread(leaf_candidates_thread), .candidates_address(leaf_candidates_address),
        .candidates_last(leaf_candidates_last), .candidates_distance0(leaf_candidates_distance0),
        .kept_valid(sieve_kept_valid), .kept_ready(queue_candidates_ready), .kept_thread(sieve_kept_thread),
        .kept_address(sieve_kept_address), .kept_last(sieve_kept_last), .kept_distance0(sieve_kept_distance0),
        .skipped_valid(sieve_skipped_valid), .skipped_thread(sieve_skipped_thread)
    );

    search_queue queue (
        .clk(clk), .rst(rst), .start_valid(threads_start_valid), .start_thread(threads_start_thread),
        .start_number(threads_start_number), .start_k(threads_start_k), .start_radius2(threads_start_radius2),
        .start_x(threads_start_x), .start_y(threads_start_y), .start_z(threads_start_z),
        .candidates_valid(sieve_kept_valid), .candidates_ready(queue_candidates_ready),
        .candidates_thread(sieve_kept_thread), .candidates_address(sieve_kept_address),
        .candidates_last(sieve_kept_last), .candidates_distance0(sieve_kept_distance0),
        .finish_valid(threads_finish_valid), .finish_ready(queue_finish_ready),
        .finish_thread(threads_finish_thread),
        .radius_valid(queue_radius_valid), .radius_thread(queue_radius_thread),
        .radius_radius2(queue_radius_radius2),
        .event_insert(event_insert),
        .released_valid(queue_released_valid), .released_thread(queue_released_thread),
        .result_valid(result_valid), .result_ready(result_ready), .result_number(result_number),
        .result_last(result_last), .result_found(result_found), .result_index(result_index),
        .result_distance2(result_distance2),
        .event_beat(event_beat)
    );

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        query_radius2_in_range: assert (~query_valid | (query_radius2 < 24'h800000));
`else
        if (!(~query_valid | (query_radius2 < 24'h800000))) begin
            $display("assertion failed: query_radius2_in_range in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// A sorted row of neighbors for each thread.
// threads = 4
// neighbors = 8
// lanes = 1
module search_queue (
    input  wire clk, input wire rst,
    input  wire start_valid,  // A thread taking up a query.
    input  wire [1:0] start_thread,  // Thread.
    input  wire [15:0] start_number,  // Its number, which its results bear.
    input  wire [3:0] start_k,  // Neighbors wanted.
    input  wire [23:0] start_radius2,  // Squared radius within which neighbors count.
    input  wire [23:0] start_x,  // Where.
    input  wire [23:0] start_y,  // Where.
    input  wire [23:0] start_z,  // Where.
    input  wire candidates_valid, output wire candidates_ready,  // Squared distances.
    input  wire [1:0] candidates_thread,  // Thread.
    input  wire [15:0] candidates_address,  // Address in the point memory.
    input  wire candidates_last,  // Closes its leaf.
    input  wire [22:0] candidates_distance0,  // A squared distance a lane; NaN where there is no point.
    input  wire finish_valid, output wire finish_ready,  // Threads whose search is over.
    input  wire [1:0] finish_thread,  // Thread.
    output reg  radius_valid,  // A thread's radius after a leaf.
    output reg  [1:0] radius_thread,  // Thread.
    output reg  [22:0] radius_radius2,  // Squared radius.
    output reg  event_insert,  // A neighbor was inserted.
    output reg  released_valid,  // A thread whose results are safe.
    output reg  [1:0] released_thread,  // Thread.
    output wire result_valid, input wire result_ready,  // Neighbors, nearest first.
    output wire [15:0] result_number,  // The query's number.
    output wire result_last,  // Closes the query.
    output wire result_found,  // Low for a query without any neighbor.
    output wire [15:0] result_index,  // The neighbor's place in the point memory.
    output wire [23:0] result_distance2,  // Its squared distance.
    output reg  event_beat  // A priority queue was done with a beat of points.
);
    (* ram_style = "distributed" *)
    reg [3:0] callers [0:1];
    (* ram_style = "distributed" *)
    reg [22:0] query_radii [0:3];
    (* ram_style = "distributed" *)
    reg [22:0] leaf_radii [0:3];
    reg [1:0] first_thread;  // Thread.
    reg [15:0] first_address;  // Address in the point memory.
    reg first_last;  // Closes its leaf.
    reg [22:0] first_distance0;  // A squared distance a lane; NaN where there is no point.
    reg [22:0] first_limit;  // The squared radius of its thread's last leaf as it came in.
    reg [1:0] second_thread;  // Thread.
    reg [15:0] second_address;  // Address in the point memory.
    reg second_last;  // Closes its leaf.
    reg [22:0] second_distance0;  // A squared distance a lane; NaN where there is no point.
    reg [22:0] second_limit;  // The squared radius of its thread's last leaf as it came in.
    reg [1:0] callers_count;
    reg callers_write_address, callers_read_address, callers_has_room, reads_first, owned;
    reg [1:0] owner, not_owner;
    reg [319:0] working;
    reg [3:0] fresh;
    reg beat_valid, beat_reads, beat_began, beat_pending;
    reg [1:0] beat_thread;  // Thread.
    reg [15:0] beat_address;  // Address in the point memory.
    reg beat_last;  // Closes its leaf.
    reg [22:0] beat_distance0;  // A squared distance a lane; NaN where there is no point.
    reg item_valid, item_reads, item_last, item_inserts_here, item_inserts_initial, item_inserts_stored;
    reg [1:0] item_thread;
    reg item_stays, item_fresh;
    reg [15:0] new_index;  // The point's place in the point memory.
    reg [22:0] new_distance2;  // Its squared distance.
    reg [7:0] nearer;
    reg new_last;
    reg [1:0] new_thread;
    reg fetching, sending, readout_idle;
    reg [1:0] readout_thread;
    reg fetch_from_working, fetch_from_nothing;
    wire [319:0] stored;
    wire [49:0] query;
    reg [22:0] item_distance2_inverse, item_distance2_reset, item_distance2_inverse_reset;
    reg [15:0] item_index;  // The point's place in the point memory.
    reg [22:0] item_distance2;  // Its squared distance.
    reg [3:0] from_leaf;
    reg last_known;
    reg [1:0] last_thread;
    reg second_last_known;
    reg [1:0] second_last_thread;
    reg [319:0] sent_row;
    reg [15:0] sent_number;
    reg [3:0] position, next_position;

    wire finish_queue_out_valid;
    wire [1:0] finish_queue_out_data;

    wire last_result_choice = next_position[1] ? (next_position[0] ? sent_row[319] : sent_row[279]) : next_position[0] ? sent_row[239] : sent_row[199];
    wire last_result_choice_2 = next_position[1] ? (next_position[0] ? sent_row[159] : sent_row[119]) : next_position[0] ? sent_row[79] : sent_row[39];
    wire last_result = (position == 4'd7) | ~(next_position[2] ? last_result_choice : last_result_choice_2);
    wire result_found_choice = position[1] ? (position[0] ? sent_row[319] : sent_row[279]) : position[0] ? sent_row[239] : sent_row[199];
    wire result_found_choice_2 = position[1] ? (position[0] ? sent_row[159] : sent_row[119]) : position[0] ? sent_row[79] : sent_row[39];
    wire [15:0] result_index_choice = position[1] ? (position[0] ? sent_row[318:303] : sent_row[278:263]) : position[0] ? sent_row[238:223] : sent_row[198:183];
    wire [15:0] result_index_choice_2 = position[1] ? (position[0] ? sent_row[158:143] : sent_row[118:103]) : position[0] ? sent_row[78:63] : sent_row[38:23];
    wire [22:0] result_distance2_choice = position[1] ? (position[0] ? sent_row[302:280] : sent_row[262:240]) : position[0] ? sent_row[222:200] : sent_row[182:160];
    wire [22:0] result_distance2_choice_2 = position[1] ? (position[0] ? sent_row[142:120] : sent_row[102:80]) : position[0] ? sent_row[62:40] : sent_row[22:0];
    wire [22:0] result_distance2_choice_3 = position[2] ? result_distance2_choice : result_distance2_choice_2;
    wire [15:0] inserted_row_choice = nearer[7] ? (nearer[6] ? working[278:263] : new_index) : working[318:303];
    wire [22:0] radius_radius2_choice = nearer[7] ? (nearer[6] ? working[262:240] : new_distance2) : working[302:280];
    wire [15:0] inserted_row_choice_2 = nearer[6] ? (nearer[5] ? working[238:223] : new_index) : working[278:263];
    wire [22:0] inserted_row_choice_3 = nearer[6] ? (nearer[5] ? working[222:200] : new_distance2) : working[262:240];
    wire [15:0] inserted_row_choice_4 = nearer[5] ? (nearer[4] ? working[198:183] : new_index) : working[238:223];
    wire [22:0] inserted_row_choice_5 = nearer[5] ? (nearer[4] ? working[182:160] : new_distance2) : working[222:200];
    wire [15:0] inserted_row_choice_6 = nearer[4] ? (nearer[3] ? working[158:143] : new_index) : working[198:183];
    wire [22:0] inserted_row_choice_7 = nearer[4] ? (nearer[3] ? working[142:120] : new_distance2) : working[182:160];
    wire [15:0] inserted_row_choice_8 = nearer[3] ? (nearer[2] ? working[118:103] : new_index) : working[158:143];
    wire [22:0] inserted_row_choice_9 = nearer[3] ? (nearer[2] ? working[102:80] : new_distance2) : working[142:120];
    wire [15:0] inserted_row_choice_10 = nearer[2] ? (nearer[1] ? working[78:63] : new_index) : working[118:103];
    wire [22:0] inserted_row_choice_11 = nearer[2] ? (nearer[1] ? working[62:40] : new_distance2) : working[102:80];
    wire [15:0] inserted_row_choice_12 = nearer[1] ? (nearer[0] ? working[38:23] : new_index) : working[78:63];
    wire [22:0] inserted_row_choice_13 = nearer[1] ? (nearer[0] ? working[22:0] : new_distance2) : working[62:40];
    wire [319:0] inserted_row = {
        nearer[7] ? (nearer[6] ? working[279] : 1'd1) : working[319], inserted_row_choice,
        radius_radius2_choice, nearer[6] ? (nearer[5] ? working[239] : 1'd1) : working[279],
        inserted_row_choice_2, inserted_row_choice_3,
        nearer[5] ? (nearer[4] ? working[199] : 1'd1) : working[239], inserted_row_choice_4,
        inserted_row_choice_5, nearer[4] ? (nearer[3] ? working[159] : 1'd1) : working[199],
        inserted_row_choice_6, inserted_row_choice_7,
        nearer[3] ? (nearer[2] ? working[119] : 1'd1) : working[159], inserted_row_choice_8,
        inserted_row_choice_9, nearer[2] ? (nearer[1] ? working[79] : 1'd1) : working[119],
        inserted_row_choice_10, inserted_row_choice_11,
        nearer[1] ? (nearer[0] ? working[39] : 1'd1) : working[79], inserted_row_choice_12,
        inserted_row_choice_13, nearer[0] ? 1'd1 : working[39], nearer[0] ? new_index : working[38:23],
        nearer[0] ? new_distance2 : working[22:0]
    };
    wire readout_reads = finish_queue_out_valid & readout_idle;
    wire [1:0] read_thread = readout_reads ? finish_queue_out_data : beat_thread;
    wire finished_owns = owned & (~not_owner == finish_queue_out_data);
    wire readout_starts = readout_reads & ~(item_reads & finished_owns);
    wire callers_write_address_enable_both = candidates_valid & callers_has_room;
    wire first_thread_enable_both = callers_write_address_enable_both & ~callers_write_address;
    wire [3:0] first_limit_shifted = from_leaf >> candidates_thread;
    wire [22:0] leaf_radius2 = leaf_radii[candidates_thread];
    wire [22:0] query_radius2 = query_radii[candidates_thread];
    wire [22:0] first_limit_choice = first_limit_shifted[0] ? leaf_radius2 : query_radius2;
    wire second_thread_enable_both = callers_write_address_enable_both & callers_write_address;
    wire waits = beat_reads & readout_reads;
    wire moves = beat_valid & ~waits;
    wire beat_free = ~beat_valid | moves;
    wire [3:0] callers_head = callers[callers_read_address];
    wire driven_out = beat_valid & (callers_head[0] & ~callers_head[1] & ~beat_began);
    wire take = |callers_count & (beat_free & ~driven_out);
    wire callers_has_room_either = (callers_count == 2'd2) | ((callers_count == 2'd1) & callers_write_address_enable_both);
    wire [319:0] initial_row = {
        17'd0, query[29:7], 17'd0, query[6] ? 23'd0 : query[29:7], 17'd0, query[5] ? 23'd0 : query[29:7],
        17'd0, query[4] ? 23'd0 : query[29:7], 17'd0, query[3] ? 23'd0 : query[29:7], 17'd0,
        query[2] ? 23'd0 : query[29:7], 17'd0, query[1] ? 23'd0 : query[29:7], 17'd0,
        query[0] ? 23'd0 : query[29:7]
    };
    wire reads = moves & beat_reads;
    wire [3:0] fresh_bits = {
        reads & (beat_thread == 2'd3), reads & (beat_thread == 2'd2), reads & (beat_thread == 2'd1),
        reads & (beat_thread == 2'd0)
    };
    wire [3:0] query_set = {
        start_valid & (start_thread == 2'd3), start_valid & (start_thread == 2'd2),
        start_valid & (start_thread == 2'd1), start_valid & (start_thread == 2'd0)
    };
    wire [1:0] tail = item_valid ? item_thread : ~not_owner;
    wire [3:0] fresh_shifted_by_tail = fresh >> tail;
    wire beat_pending_choice = callers_read_address ? (second_distance0 < second_limit) : (first_distance0 < first_limit);
    wire chosen = beat_pending & (1'd0 - beat_pending);
    wire rest = beat_pending & ~chosen;
    wire left = waits ? beat_pending : rest;
    wire beat_pending_choice_2 = take ? beat_pending_choice : left;
    wire moves_and_beat_pending = moves & beat_pending;
    wire [3:0] fresh_shifted_by_beat_thread = fresh >> beat_thread;
    wire nearer_in_order = ~item_distance2_inverse_reset < working[262:240];
    wire nearer_in_order_2 = item_distance2 < new_distance2;
    wire nearer_choice = nearer[7] ? (nearer[6] ? nearer_in_order : nearer_in_order_2) : (~item_distance2_inverse_reset < working[302:280]);
    wire nearer_in_order_3 = item_distance2_reset < working[222:200];
    wire nearer_choice_2 = nearer[6] ? (nearer[5] ? nearer_in_order_3 : nearer_in_order_2) : nearer_in_order;
    wire nearer_in_order_4 = item_distance2_reset < working[182:160];
    wire nearer_choice_3 = nearer[5] ? (nearer[4] ? nearer_in_order_4 : nearer_in_order_2) : nearer_in_order_3;
    wire nearer_in_order_5 = ~item_distance2_inverse < working[142:120];
    wire nearer_choice_4 = nearer[4] ? (nearer[3] ? nearer_in_order_5 : nearer_in_order_2) : nearer_in_order_4;
    wire nearer_in_order_6 = ~item_distance2_inverse < working[102:80];
    wire nearer_choice_5 = nearer[3] ? (nearer[2] ? nearer_in_order_6 : nearer_in_order_2) : nearer_in_order_5;
    wire nearer_in_order_7 = item_distance2 < working[62:40];
    wire nearer_choice_6 = nearer[2] ? (nearer[1] ? nearer_in_order_7 : nearer_in_order_2) : nearer_in_order_6;
    wire nearer_in_order_8 = item_distance2 < working[22:0];
    wire nearer_choice_7 = nearer[1] ? (nearer[0] ? nearer_in_order_8 : nearer_in_order_2) : nearer_in_order_7;
    wire [7:0] nearer_bits = {
        nearer_choice, nearer_choice_2, nearer_choice_3, nearer_choice_4, nearer_choice_5, nearer_choice_6,
        nearer_choice_7, nearer[0] ? nearer_in_order_2 : nearer_in_order_8
    };
    wire [7:0] nearer_either = (nearer_bits & {8{item_inserts_here}}) | ({1'd1, ~query[6:0]} & {8{item_inserts_initial}});
    wire [7:0] nearer_bits_2 = {
        ~item_distance2_inverse_reset < stored[302:280], ~item_distance2_inverse_reset < stored[262:240],
        item_distance2_reset < stored[222:200], item_distance2_reset < stored[182:160],
        ~item_distance2_inverse < stored[142:120], ~item_distance2_inverse < stored[102:80],
        item_distance2 < stored[62:40], item_distance2 < stored[22:0]
    };
    wire result_transfer = sending & result_ready;
    wire result_ends = result_transfer & last_result;
    wire [3:0] fetch_from_nothing_shifted = fresh >> finish_queue_out_data;
    wire [3:0] leaf_set = {
        radius_valid & (radius_thread == 2'd3), radius_valid & (radius_thread == 2'd2),
        radius_valid & (radius_thread == 2'd1), radius_valid & (radius_thread == 2'd0)
    };
    wire fetching_or_result_transfer = fetching | result_transfer;

    assign candidates_ready = callers_has_room;
    assign result_valid = sending;
    assign result_number = sent_number;
    assign result_last = last_result;
    assign result_found = position[2] ? result_found_choice : result_found_choice_2;
    assign result_index = position[2] ? result_index_choice : result_index_choice_2;
    assign result_distance2 = {1'd0, result_distance2_choice_3};

    memory_1w1r #(.WIDTH(320), .DEPTH(4)) rows (
        .clk(clk), .write(owned), .write_address(owner), .write_data(inserted_row),
        .read(1'd1), .read_address(read_thread), .read_data(stored)
    );

    memory_1w1r #(.WIDTH(50), .DEPTH(4)) queries (
        .clk(clk), .write(start_valid), .write_address(start_thread),
        .write_data({
            start_number, start_k, start_radius2[22:0], start_k < 4'd2, start_k < 4'd3, start_k < 4'd4,
            start_k < 4'd5, start_k < 4'd6, start_k < 4'd7, start_k < 4'd8
        }),
        .read(1'd1), .read_address(read_thread), .read_data(query)
    );

    stream_skid_w2 finish_queue (
        .clk(clk), .rst(rst), .in_valid(finish_valid), .in_ready(finish_ready), .in_data(finish_thread),
        .out_valid(finish_queue_out_valid), .out_ready(readout_starts), .out_data(finish_queue_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            callers_count <= 2'd0;
            callers_write_address <= 1'd0;
            callers_read_address <= 1'd0;
            callers_has_room <= 1'd1;
            reads_first <= 1'd1;
            owned <= 1'd0;
            beat_valid <= 1'd0;
            beat_reads <= 1'd0;
            beat_began <= 1'd0;
            item_valid <= 1'd0;
            item_reads <= 1'd0;
            item_last <= 1'd0;
            item_inserts_here <= 1'd0;
            item_inserts_initial <= 1'd0;
            item_inserts_stored <= 1'd0;
            item_stays <= 1'd1;
            nearer <= 8'd0;
            new_last <= 1'd0;
            radius_valid <= 1'd0;
            event_insert <= 1'd0;
            fetching <= 1'd0;
            sending <= 1'd0;
            readout_idle <= 1'd1;
            item_distance2_reset <= 23'd0;
            item_distance2_inverse_reset <= 23'd0;
            last_known <= 1'd0;
            second_last_known <= 1'd0;
            released_valid <= 1'd0;
            event_beat <= 1'd0;
        end else begin
            callers_count <= (callers_count + {1'd0, callers_write_address_enable_both}) - {1'd0, take};
            callers_has_room <= take | ~callers_has_room_either;
            owned <= owned | item_valid;
            beat_valid <= take | waits;
            beat_reads <= take ? (~callers_head[1] | (~beat_valid & fresh_shifted_by_tail[0])) : (beat_reads & waits);
            beat_began <= ~take & (beat_began | moves);
            item_valid <= moves;
            item_reads <= reads;
            item_last <= moves & beat_last;
            item_inserts_here <= moves_and_beat_pending & ~beat_reads;
            item_inserts_initial <= moves_and_beat_pending & (beat_reads & fresh_shifted_by_beat_thread[0]);
            item_inserts_stored <= moves_and_beat_pending & (beat_reads & ~fresh_shifted_by_beat_thread[0]);
            item_stays <= ~reads;
            nearer <= nearer_either | (nearer_bits_2 & {8{item_inserts_stored}});
            new_last <= item_last;
            radius_valid <= new_last;
            event_insert <= nearer[7];
            fetching <= readout_starts;
            sending <= fetching | (sending & ~result_ends);
            readout_idle <= (readout_idle & ~readout_starts) | result_ends;
            item_distance2_reset <= beat_distance0;
            item_distance2_inverse_reset <= ~beat_distance0;
            released_valid <= fetching;
            event_beat <= moves;
            if (callers_write_address_enable_both) begin
                callers_write_address <= callers_write_address + 1'd1;
                last_known <= 1'd1;
                second_last_known <= last_known;
            end
            if (take) begin
                callers_read_address <= callers_read_address + 1'd1;
                reads_first <= ~reads_first;
            end
        end
    end
    always @(posedge clk) begin
        if (first_thread_enable_both) begin
            first_thread <= candidates_thread;
            first_address <= candidates_address;
            first_last <= candidates_last;
            first_distance0 <= candidates_distance0;
            first_limit <= first_limit_choice;
        end
        if (second_thread_enable_both) begin
            second_thread <= candidates_thread;
            second_address <= candidates_address;
            second_last <= candidates_last;
            second_distance0 <= candidates_distance0;
            second_limit <= first_limit_choice;
        end
        if (item_valid) begin
            owner <= item_thread;
            not_owner <= ~item_thread;
        end
        working <= item_stays ? inserted_row : item_fresh ? initial_row : stored;
        fresh <= (fresh & ~fresh_bits) | query_set;
        beat_pending <= beat_pending_choice_2;
        item_thread <= beat_thread;
        item_fresh <= fresh_shifted_by_beat_thread[0];
        new_index <= item_index;
        new_distance2 <= item_distance2;
        new_thread <= item_thread;
        radius_thread <= new_thread;
        radius_radius2 <= radius_radius2_choice;
        fetch_from_working <= finished_owns;
        fetch_from_nothing <= fetch_from_nothing_shifted[0];
        item_distance2_inverse <= ~beat_distance0;
        item_index <= beat_address;
        item_distance2 <= beat_distance0;
        from_leaf <= (from_leaf & ~query_set) | leaf_set;
        released_thread <= readout_thread;
        if (beat_free) begin
            beat_thread <= reads_first ? first_thread : second_thread;
            beat_address <= reads_first ? first_address : second_address;
            beat_last <= reads_first ? first_last : second_last;
            beat_distance0 <= reads_first ? first_distance0 : second_distance0;
        end
        if (readout_starts) readout_thread <= finish_queue_out_data;
        if (callers_write_address_enable_both) begin
            last_thread <= candidates_thread;
            second_last_thread <= last_thread;
        end
        if (fetching) begin
            sent_row <= fetch_from_nothing ? initial_row : fetch_from_working ? working : stored;
            sent_number <= query[49:34];
        end
        if (fetching_or_result_transfer) begin
            position <= fetching ? (4'd8 - query[33:30]) : next_position;
            next_position <= fetching ? (4'd9 - query[33:30]) : (next_position + 4'd1);
        end
    end
    always @(posedge clk) begin
        if (callers_write_address_enable_both) begin
            callers[callers_write_address] <= {
                candidates_thread, last_known & (last_thread == candidates_thread),
                second_last_known & (second_last_thread == candidates_thread)
            };
        end
    end
    always @(posedge clk) if (start_valid) query_radii[start_thread] <= start_radius2[22:0];
    always @(posedge clk) if (radius_valid) leaf_radii[radius_thread] <= radius_radius2;

    wire _unused = &{
        1'b0, callers_head[3:2], fetch_from_nothing_shifted[3:1], first_limit_shifted[3:1],
        fresh_shifted_by_beat_thread[3:1], fresh_shifted_by_tail[3:1], start_radius2[23], start_x, start_y,
        start_z
    };

`ifdef RTL_ASSERT
    reg beat_settled;

    wire [3:0] check_shifted = fresh >> readout_thread;
    wire check_both = (item_valid | owned) & (tail == callers_head[3:2]);
    wire check_choice = beat_valid ? (callers_head[1] == (beat_thread == callers_head[3:2])) : (callers_head[1] == check_both);
    wire check_both_2 = check_choice & (~beat_valid | (beat_began | (callers_head[0] == check_both)));

    always @(posedge clk) beat_settled <= ~beat_pending_choice_2;

    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        start_radius2_in_range: assert (~start_valid | (start_radius2 < 24'h800000));
        k_fits_a_row: assert (~start_valid | (|start_k & (start_k <= 4'd8)));
        a_fetched_row_stays_where_it_is: assert (~fetching | (fetch_from_working == (owned & (~not_owner == readout_thread))));
        a_fetched_row_stays_fresh: assert (~fetching | (fetch_from_nothing == check_shifted[0]));
        whom_a_beat_follows_is_told: assert (~(|callers_count) | check_both_2);
        callers_go_with_their_beats: assert (reads_first ^ callers_read_address);
        pending_or_settled: assert (~beat_valid | (beat_pending ^ beat_settled));
        owner_or_not: assert (~owned | &(owner ^ not_owner));
        idle_when_neither: assert (readout_idle == ~(fetching | sending));
`else
        if (!(~start_valid | (start_radius2 < 24'h800000))) begin
            $display("assertion failed: start_radius2_in_range in %m"); $stop;
        end
        if (!(~start_valid | (|start_k & (start_k <= 4'd8)))) begin
            $display("assertion failed: k_fits_a_row in %m"); $stop;
        end
        if (!(~fetching | (fetch_from_working == (owned & (~not_owner == readout_thread))))) begin
            $display("assertion failed: a_fetched_row_stays_where_it_is in %m"); $stop;
        end
        if (!(~fetching | (fetch_from_nothing == check_shifted[0]))) begin
            $display("assertion failed: a_fetched_row_stays_fresh in %m"); $stop;
        end
        if (!(~(|callers_count) | check_both_2)) begin
            $display("assertion failed: whom_a_beat_follows_is_told in %m"); $stop;
        end
        if (!(reads_first ^ callers_read_address)) begin
            $display("assertion failed: callers_go_with_their_beats in %m"); $stop;
        end
        if (!(~beat_valid | (beat_pending ^ beat_settled))) begin
            $display("assertion failed: pending_or_settled in %m"); $stop;
        end
        if (!(~owned | &(owner ^ not_owner))) begin
            $display("assertion failed: owner_or_not in %m"); $stop;
        end
        if (!(readout_idle == ~(fetching | sending))) begin
            $display("assertion failed: idle_when_neither in %m"); $stop;
        end
`endif
    end

    wire _unused_by_checks = &{1'b0, check_shifted[3:1]};
`endif
endmodule

// Takes out beats without a point near enough.
// threads = 4
// lanes = 1
// depth = 4
module search_sieve (
    input  wire clk, input wire rst,
    input  wire start_valid,  // A thread taking up a query.
    input  wire [1:0] start_thread,  // Thread.
    input  wire [15:0] start_number,  // Its number, which its results bear.
    input  wire [3:0] start_k,  // Neighbors wanted.
    input  wire [23:0] start_radius2,  // Squared radius within which neighbors count.
    input  wire [23:0] start_x,  // Where.
    input  wire [23:0] start_y,  // Where.
    input  wire [23:0] start_z,  // Where.
    input  wire radius_valid,  // A thread's new radius.
    input  wire [1:0] radius_thread,  // Thread.
    input  wire [22:0] radius_radius2,  // Squared radius.
    input  wire candidates_valid, output wire candidates_ready,  // Squared distances; the beats of a leaf come together.
    input  wire [1:0] candidates_thread,  // Thread.
    input  wire [15:0] candidates_address,  // Address in the point memory.
    input  wire candidates_last,  // Closes its leaf.
    input  wire [22:0] candidates_distance0,  // A squared distance a lane; NaN where there is no point.
    output wire kept_valid, input wire kept_ready,  // Beats with a point that is near enough.
    output wire [1:0] kept_thread,  // Thread.
    output wire [15:0] kept_address,  // Address in the point memory.
    output wire kept_last,  // Closes its leaf.
    output wire [22:0] kept_distance0,  // A squared distance a lane; NaN where there is no point.
    output reg  skipped_valid,  // The thread of a leaf of which no beat was kept.
    output reg  [1:0] skipped_thread  // Thread.
);
    (* ram_style = "distributed" *)
    reg [22:0] query_radii [0:3];
    (* ram_style = "distributed" *)
    reg [22:0] leaf_radii [0:3];
    reg s1_valid, s1_empty;
    reg [1:0] s1_thread;  // Thread.
    reg [15:0] s1_address;  // Address in the point memory.
    reg s1_last;  // Closes its leaf.
    reg [22:0] s1_distance0;  // A squared distance a lane; NaN where there is no point.
    reg [3:0] from_leaf;
    reg [22:0] radius2;
    reg s2_valid, s2_empty, s2_survives;
    reg [1:0] s2_thread;  // Thread.
    reg [15:0] s2_address;  // Address in the point memory.
    reg s2_last;  // Closes its leaf.
    reg [22:0] s2_distance0;  // A squared distance a lane; NaN where there is no point.
    reg held_valid, held_last;
    reg [1:0] held_thread;  // Thread.
    reg [15:0] held_address;
    reg [22:0] held_distance0;

    wire candidates_queue_out_valid;
    wire [41:0] candidates_queue_out_data;
    wire kept_queue_in_ready;
    wire [41:0] kept_queue_out_data;

    wire decides_early = s2_empty | (~(held_valid & (held_last | s2_survives)) | kept_queue_in_ready);
    wire candidates_queue_out_ready = s1_empty | decides_early;
    wire closed = held_valid & held_last;
    wire near = s2_valid & s2_survives;
    wire displaced = closed | (held_valid & near);
    wire leaves = displaced & kept_queue_in_ready;
    wire advance = ~s1_valid | decides_early;
    wire s1_valid_choice = advance ? candidates_queue_out_valid : s1_valid;
    wire [1:0] candidates_queue_out_thread = candidates_queue_out_data[41:40];
    wire [15:0] candidates_queue_out_address = candidates_queue_out_data[39:24];
    wire candidates_queue_out_last = candidates_queue_out_data[23];
    wire [22:0] candidates_queue_out_distance0 = candidates_queue_out_data[22:0];
    wire [3:0] query_set = {
        start_valid & (start_thread == 2'd3), start_valid & (start_thread == 2'd2),
        start_valid & (start_thread == 2'd1), start_valid & (start_thread == 2'd0)
    };
    wire [3:0] leaf_set = {
        radius_valid & (radius_thread == 2'd3), radius_valid & (radius_thread == 2'd2),
        radius_valid & (radius_thread == 2'd1), radius_valid & (radius_thread == 2'd0)
    };
    wire [3:0] radius2_shifted = from_leaf >> candidates_queue_out_thread;
    wire [22:0] leaf_radius2 = leaf_radii[candidates_queue_out_thread];
    wire [22:0] query_radius2 = query_radii[candidates_queue_out_thread];
    wire proceeds = ~displaced | kept_queue_in_ready;
    wire decides = ~s2_valid | proceeds;
    wire s2_valid_choice = decides ? s1_valid : s2_valid;
    wire keep = near & proceeds;
    wire ends = s2_valid & s2_last & (~near & proceeds);
    wire closes = ends & (held_valid & ~held_last);

    assign {kept_thread, kept_address, kept_last, kept_distance0} = kept_queue_out_data;

    stream_skid_w42 candidates_queue (
        .clk(clk), .rst(rst), .in_valid(candidates_valid), .in_ready(candidates_ready),
        .in_data({candidates_thread, candidates_address, candidates_last, candidates_distance0}),
        .out_valid(candidates_queue_out_valid), .out_ready(candidates_queue_out_ready),
        .out_data(candidates_queue_out_data)
    );

    stream_fifo_d4_w42 kept_queue (
        .clk(clk), .rst(rst), .in_valid(leaves), .in_ready(kept_queue_in_ready),
        .in_data({held_thread, held_address, held_last, held_distance0}),
        .out_valid(kept_valid), .out_ready(kept_ready), .out_data(kept_queue_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            s1_valid <= 1'd0;
            s1_empty <= 1'd1;
            s2_valid <= 1'd0;
            s2_empty <= 1'd1;
            held_valid <= 1'd0;
            skipped_valid <= 1'd0;
        end else begin
            s1_valid <= s1_valid_choice;
            s1_empty <= ~s1_valid_choice;
            s2_valid <= s2_valid_choice;
            s2_empty <= ~s2_valid_choice;
            held_valid <= keep | (held_valid & ~leaves);
            skipped_valid <= ends & ~closes;
        end
    end
    always @(posedge clk) begin
        if (advance) begin
            s1_thread <= candidates_queue_out_thread;
            s1_address <= candidates_queue_out_address;
            s1_last <= candidates_queue_out_last;
            s1_distance0 <= candidates_queue_out_distance0;
            radius2 <= radius2_shifted[0] ? leaf_radius2 : query_radius2;
        end
        from_leaf <= (from_leaf & ~query_set) | leaf_set;
        skipped_thread <= s2_thread;
        if (decides) begin
            s2_survives <= s1_distance0 < radius2;
            s2_thread <= s1_thread;
            s2_address <= s1_address;
            s2_last <= s1_last;
            s2_distance0 <= s1_distance0;
        end
        if (keep | closes) held_last <= s2_last;
        if (keep) begin
            held_thread <= s2_thread;
            held_address <= s2_address;
            held_distance0 <= s2_distance0;
        end
    end
    always @(posedge clk) if (start_valid) query_radii[start_thread] <= start_radius2[22:0];
    always @(posedge clk) if (radius_valid) leaf_radii[radius_thread] <= radius_radius2;

    wire _unused = &{1'b0, radius2_shifted[3:1], start_k, start_number, start_radius2[23], start_x, start_y, start_z};

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        start_radius2_in_range: assert (~start_valid | (start_radius2 < 24'h800000));
        s1_valid_or_empty: assert (s1_valid ^ s1_empty);
        s2_valid_or_empty: assert (s2_valid ^ s2_empty);
        decides_as_early: assert (decides == decides_early);
`else
        if (!(~start_valid | (start_radius2 < 24'h800000))) begin
            $display("assertion failed: start_radius2_in_range in %m"); $stop;
        end
        if (!(s1_valid ^ s1_empty)) begin
            $display("assertion failed: s1_valid_or_empty in %m"); $stop;
        end
        if (!(s2_valid ^ s2_empty)) begin
            $display("assertion failed: s2_valid_or_empty in %m"); $stop;
        end
        if (!(decides == decides_early)) begin
            $display("assertion failed: decides_as_early in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue in a memory with a registered output.
// depth = 4
// width = 42
module stream_fifo_d4_w42 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [41:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [41:0] out_data
);
    reg [2:0] held, waiting;
    reg is_full, any_waits;
    reg [1:0] write_address, read_address;
    wire [41:0] item;

    wire has_room = ~is_full;
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [2:0] held_bits = {{2{~push}}, 1'd1};
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    memory_1w1r_unordered #(.WIDTH(42), .DEPTH(4)) entries (
        .clk(clk), .write(has_room), .write_address(write_address), .write_data(in_data),
        .read(fetch), .read_address(read_address), .read_data(item)
    );

    always @(posedge clk) begin
        if (rst) begin
            held <= 3'd0;
            waiting <= 3'd0;
            is_full <= 1'd0;
            any_waits <= 1'd0;
            write_address <= 2'd0;
            read_address <= 2'd0;
            out_valid <= 1'd0;
        end else begin
            if (push_xor_pop) begin
                held <= held + held_bits;
                is_full <= push & (held == 3'd3);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 3'd1);
            end
            if (push) write_address <= write_address + 2'd1;
            if (fetch) read_address <= read_address + 2'd1;
            out_valid <= fetch | (out_valid & ~out_ready);
        end
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        held_in_range: assert (held <= 3'd4);
        held_is_waiting_and_shown: assert (held == (waiting + {2'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 3'd4)) & (any_waits == |waiting));
`else
        if (!(held <= 3'd4)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {2'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 3'd4)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue of two in registers.
// width = 42
module stream_skid_w42 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [41:0] in_data,
    output wire out_valid, input wire out_ready, output wire [41:0] out_data
);
    reg head_filled, second_filled, room;
    reg [41:0] head, second;

    wire advance = ~head_filled | out_ready;
    wire some_item = second_filled | in_valid;
    wire not_advance_and_some_item = ~advance & some_item;

    assign in_ready = room;
    assign out_valid = head_filled;
    assign out_data = head;

    always @(posedge clk) begin
        if (rst) begin
            head_filled <= 1'd0;
            second_filled <= 1'd0;
            room <= 1'd1;
        end else begin
            if (advance) head_filled <= some_item;
            second_filled <= not_advance_and_some_item;
            room <= ~not_advance_and_some_item;
        end
    end
    always @(posedge clk) begin
        if (advance) head <= second_filled ? second : in_data;
        if (~second_filled) second <= in_data;
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        second_filled_or_room: assert (second_filled ^ room);
        second_waits_behind_head: assert (head_filled | ~second_filled);
`else
        if (!(second_filled ^ room)) begin
            $display("assertion failed: second_filled_or_room in %m"); $stop;
        end
        if (!(head_filled | ~second_filled)) begin
            $display("assertion failed: second_waits_behind_head in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Fetches leaves and computes the distances of their points.
// threads = 4
// lanes = 1
module search_leaf (
    input  wire clk, input wire rst,
    input  wire tree_valid,  // Write to the leaf table.
    input  wire tree_is_leaf,  // Chooses the leaf table, else the node memory.
    input  wire [5:0] tree_address,  // The leaf's number or the node.
    input  wire [23:0] tree_split,  // Where its plane cuts its dimension.
    input  wire [1:0] tree_dimension,  // Its dimension.
    input  wire tree_internal_leaf,  // It is a leaf.
    input  wire [15:0] tree_begin,  // The first beat.
    input  wire [3:0] tree_beats,  // The number of beats, at least one.
    input  wire leaf_valid, output wire leaf_ready,  // Leaves reached.
    input  wire [1:0] leaf_thread,  // Thread.
    input  wire [5:0] leaf_leaf,  // The leaf's number among those of the deepest level (eq. 6.7).
    output wire fetch_valid, input wire fetch_ready,  // Requests to the memory.
    output wire [1:0] fetch_thread,  // Thread.
    output wire [15:0] fetch_address,  // First beat.
    output wire [3:0] fetch_beats,  // Number of beats, at least one.
    input  wire start_valid,  // A thread taking up a query.
    input  wire [1:0] start_thread,  // Thread.
    input  wire [15:0] start_number,  // Its number, which its results bear.
    input  wire [3:0] start_k,  // Neighbors wanted.
    input  wire [23:0] start_radius2,  // Squared radius within which neighbors count.
    input  wire [23:0] start_x,  // Where.
    input  wire [23:0] start_y,  // Where.
    input  wire [23:0] start_z,  // Where.
    input  wire beat_valid, output wire beat_ready,  // Points from memory.
    input  wire [1:0] beat_thread,  // Thread.
    input  wire [15:0] beat_address,  // Address in the point memory.
    input  wire beat_last,  // Closes its leaf.
    input  wire [23:0] beat_x0,  // A point a lane; NaN where there is none.
    input  wire [23:0] beat_y0,  // A point a lane; NaN where there is none.
    input  wire [23:0] beat_z0,  // A point a lane; NaN where there is none.
    output wire candidates_valid, input wire candidates_ready,  // Their squared distances.
    output wire [1:0] candidates_thread,  // Thread.
    output wire [15:0] candidates_address,  // Address in the point memory.
    output wire candidates_last,  // Closes its leaf.
    output wire [22:0] candidates_distance0  // A squared distance a lane; NaN where there is no point.
);
    reg f0_valid, f1_valid;
    reg [1:0] f0_thread, f1_thread;
    wire [19:0] f0_found;
    reg [15:0] f1_begin;  // The first beat.
    reg [3:0] f1_beats;  // The number of beats, at least one.
    reg query_valid, query_empty;
    reg [1:0] points_thread;  // Thread.
    reg [15:0] points_address;  // Address in the point memory.
    reg points_last;  // Closes its leaf.
    reg [23:0] points_x0;  // A point a lane; NaN where there is none.
    reg [23:0] points_y0;  // A point a lane; NaN where there is none.
    reg [23:0] points_z0;  // A point a lane; NaN where there is none.
    wire [71:0] query;

    wire leaf_queue_out_valid;
    wire [7:0] leaf_queue_out_data;
    wire fetch_queue_in_ready;
    wire [21:0] fetch_queue_out_data;
    wire beat_queue_out_valid;
    wire [90:0] beat_queue_out_data;
    wire distance_in_ready;

    wire writes_leaf = tree_valid & tree_is_leaf;
    wire table_advance = ~f1_valid | fetch_queue_in_ready;
    wire [5:0] leaf_queue_out_leaf = leaf_queue_out_data[5:0];
    wire query_advance = ~query_valid | distance_in_ready;
    wire [1:0] beat_queue_out_thread = beat_queue_out_data[90:89];
    wire beat_queue_out_ready = query_empty | distance_in_ready;
    wire [1:0] leaf_queue_out_thread = leaf_queue_out_data[7:6];
    wire query_valid_choice = query_advance ? beat_queue_out_valid : query_valid;
    wire [15:0] beat_queue_out_address = beat_queue_out_data[88:73];
    wire beat_queue_out_last = beat_queue_out_data[72];
    wire [23:0] beat_queue_out_x0 = beat_queue_out_data[71:48];
    wire [23:0] beat_queue_out_y0 = beat_queue_out_data[47:24];
    wire [23:0] beat_queue_out_z0 = beat_queue_out_data[23:0];

    assign {fetch_thread, fetch_address, fetch_beats} = fetch_queue_out_data;

    memory_1w1r_unordered #(.WIDTH(20), .DEPTH(64)) leaves (
        .clk(clk), .write(writes_leaf), .write_address(tree_address), .write_data({tree_begin, tree_beats}),
        .read(table_advance), .read_address(leaf_queue_out_leaf), .read_data(f0_found)
    );

    memory_1w1r #(.WIDTH(72), .DEPTH(4)) queries (
        .clk(clk), .write(start_valid), .write_address(start_thread),
        .write_data({start_x, start_y, start_z}),
        .read(query_advance), .read_address(beat_queue_out_thread), .read_data(query)
    );

    stream_skid_w8 leaf_queue (
        .clk(clk), .rst(rst), .in_valid(leaf_valid), .in_ready(leaf_ready),
        .in_data({leaf_thread, leaf_leaf}),
        .out_valid(leaf_queue_out_valid), .out_ready(table_advance), .out_data(leaf_queue_out_data)
    );

    stream_skid_w22 fetch_queue (
        .clk(clk), .rst(rst), .in_valid(f1_valid), .in_ready(fetch_queue_in_ready),
        .in_data({f1_thread, f1_begin, f1_beats}),
        .out_valid(fetch_valid), .out_ready(fetch_ready), .out_data(fetch_queue_out_data)
    );

    stream_skid_w91 beat_queue (
        .clk(clk), .rst(rst), .in_valid(beat_valid), .in_ready(beat_ready),
        .in_data({beat_thread, beat_address, beat_last, beat_x0, beat_y0, beat_z0}),
        .out_valid(beat_queue_out_valid), .out_ready(beat_queue_out_ready), .out_data(beat_queue_out_data)
    );

    search_distance distance (
        .clk(clk), .rst(rst), .in_valid(query_valid), .in_ready(distance_in_ready), .in_thread(points_thread),
        .in_address(points_address), .in_last(points_last), .in_x0(points_x0), .in_y0(points_y0),
        .in_z0(points_z0), .in_query_x(query[71:48]), .in_query_y(query[47:24]), .in_query_z(query[23:0]),
        .out_valid(candidates_valid), .out_ready(candidates_ready), .out_thread(candidates_thread),
        .out_address(candidates_address), .out_last(candidates_last), .out_distance0(candidates_distance0)
    );

    always @(posedge clk) begin
        if (rst) begin
            f0_valid <= 1'd0;
            f1_valid <= 1'd0;
            query_valid <= 1'd0;
            query_empty <= 1'd1;
        end else begin
            if (table_advance) begin
                f0_valid <= leaf_queue_out_valid;
                f1_valid <= f0_valid;
            end
            query_valid <= query_valid_choice;
            query_empty <= ~query_valid_choice;
        end
    end
    always @(posedge clk) begin
        if (table_advance) begin
            f0_thread <= leaf_queue_out_thread;
            f1_thread <= f0_thread;
            f1_begin <= f0_found[19:4];
            f1_beats <= f0_found[3:0];
        end
        if (query_advance) begin
            points_thread <= beat_queue_out_thread;
            points_address <= beat_queue_out_address;
            points_last <= beat_queue_out_last;
            points_x0 <= beat_queue_out_x0;
            points_y0 <= beat_queue_out_y0;
            points_z0 <= beat_queue_out_z0;
        end
    end

    wire _unused = &{1'b0, start_k, start_number, start_radius2, tree_dimension, tree_internal_leaf, tree_split};

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        no_leaf_is_looked_up_while_one_is_written: assert (~(writes_leaf & leaf_queue_out_valid));
        start_radius2_in_range: assert (~start_valid | (start_radius2 < 24'h800000));
        query_valid_or_empty: assert (query_valid ^ query_empty);
`else
        if (!(~(writes_leaf & leaf_queue_out_valid))) begin
            $display("assertion failed: no_leaf_is_looked_up_while_one_is_written in %m"); $stop;
        end
        if (!(~start_valid | (start_radius2 < 24'h800000))) begin
            $display("assertion failed: start_radius2_in_range in %m"); $stop;
        end
        if (!(query_valid ^ query_empty)) begin
            $display("assertion failed: query_valid_or_empty in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Squared distances of points to a query.
// latency = 22
// initiation_interval = 1
module search_distance (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [1:0] in_thread,
    input  wire [15:0] in_address, input wire in_last, input wire [23:0] in_x0,
    input  wire [23:0] in_y0, input wire [23:0] in_z0, input wire [23:0] in_query_x,
    input  wire [23:0] in_query_y, input wire [23:0] in_query_z,
    output wire out_valid, input wire out_ready, output wire [1:0] out_thread,
    output wire [15:0] out_address, output wire out_last, output wire [22:0] out_distance0
);
    (* ram_style = "distributed" *)
    reg [23:0] delay_6_from_0 [0:4];
    (* ram_style = "distributed" *)
    reg [18:0] delay_22_from_0 [0:20];
    reg [5:0] credits;
    reg [2:0] delay_6_from_0_pointer;
    reg [23:0] delay_6_from_0_out;
    reg [4:0] delay_22_from_0_pointer;
    reg [18:0] delay_22_from_0_out;
    reg [21:0] in_flight;
    reg left;

    wire [23:0] add_f24_ftz_unit_y, add_f24_ftz_unit_copy2_y, add_f24_ftz_unit_copy3_y, add_f24_ftz_unit_copy4_y;
    wire [23:0] add_f24_ftz_unit_copy5_y, mul_f24_ftz_unit_y, mul_f24_ftz_unit_copy2_y, mul_f24_ftz_unit_copy3_y;
    wire queue_1_in_ready;
    wire [41:0] queue_1_out_data;

    assign in_ready = ~credits[5];
    wire kept = in_flight[21];
    wire [1:0] thread_d22 = delay_22_from_0_out[1:0];
    wire [15:0] address_d22 = delay_22_from_0_out[17:2];
    wire last_d22 = delay_22_from_0_out[18];
    wire in_valid_and_in_ready = in_valid & in_ready;

    assign {out_thread, out_address, out_last, out_distance0} = queue_1_out_data;

    float_add_s6_f24ftz add_f24_ftz_unit (
        .clk(clk), .enable(1'd1), .a(in_x0), .b({~in_query_x[23], in_query_x[22:0]}), .y(add_f24_ftz_unit_y)
    );

    float_add_s6_f24ftz add_f24_ftz_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(in_y0), .b({~in_query_y[23], in_query_y[22:0]}),
        .y(add_f24_ftz_unit_copy2_y)
    );

    float_add_s6_f24ftz add_f24_ftz_unit_copy3 (
        .clk(clk), .enable(1'd1), .a(in_z0), .b({~in_query_z[23], in_query_z[22:0]}),
        .y(add_f24_ftz_unit_copy3_y)
    );

    float_add_s6_f24ftz add_f24_ftz_unit_copy4 (
        .clk(clk), .enable(1'd1), .a(mul_f24_ftz_unit_y), .b(mul_f24_ftz_unit_copy2_y),
        .y(add_f24_ftz_unit_copy4_y)
    );

    float_add_s6_f24ftz add_f24_ftz_unit_copy5 (
        .clk(clk), .enable(1'd1), .a(add_f24_ftz_unit_copy4_y), .b(delay_6_from_0_out),
        .y(add_f24_ftz_unit_copy5_y)
    );

    float_mul_s4_f24ftz mul_f24_ftz_unit (
        .clk(clk), .enable(1'd1), .a(add_f24_ftz_unit_y), .b(add_f24_ftz_unit_y), .y(mul_f24_ftz_unit_y)
    );

    float_mul_s4_f24ftz mul_f24_ftz_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(add_f24_ftz_unit_copy2_y), .b(add_f24_ftz_unit_copy2_y),
        .y(mul_f24_ftz_unit_copy2_y)
    );

    float_mul_s4_f24ftz mul_f24_ftz_unit_copy3 (
        .clk(clk), .enable(1'd1), .a(add_f24_ftz_unit_copy3_y), .b(add_f24_ftz_unit_copy3_y),
        .y(mul_f24_ftz_unit_copy3_y)
    );

    stream_fifo_d26_w42_distributed queue_1 (
        .clk(clk), .rst(rst), .in_valid(kept), .in_ready(queue_1_in_ready),
        .in_data({thread_d22, address_d22, last_d22, add_f24_ftz_unit_copy5_y[22:0]}),
        .out_valid(out_valid), .out_ready(out_ready), .out_data(queue_1_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            credits <= 6'd25;
            delay_6_from_0_pointer <= 3'd0;
            delay_22_from_0_pointer <= 5'd0;
            in_flight <= 22'd0;
            left <= 1'd0;
        end else begin
            credits <= (credits - {5'd0, in_valid_and_in_ready}) + {5'd0, left};
            delay_6_from_0_pointer <= (delay_6_from_0_pointer == 3'd4) ? (delay_6_from_0_pointer - 3'd4) : (delay_6_from_0_pointer + 3'd1);
            delay_22_from_0_pointer <= (delay_22_from_0_pointer == 5'd20) ? (delay_22_from_0_pointer - 5'd20) : (delay_22_from_0_pointer + 5'd1);
            in_flight <= {in_flight[20:0], in_valid_and_in_ready};
            left <= out_valid & out_ready;
        end
    end
    always @(posedge clk) begin
        delay_6_from_0[delay_6_from_0_pointer] <= mul_f24_ftz_unit_copy3_y;
        delay_6_from_0_out <= delay_6_from_0[delay_6_from_0_pointer];
    end
    always @(posedge clk) begin
        delay_22_from_0[delay_22_from_0_pointer] <= {in_last, in_address, in_thread};
        delay_22_from_0_out <= delay_22_from_0[delay_22_from_0_pointer];
    end

    wire _unused = &{1'b0, add_f24_ftz_unit_copy5_y[23], queue_1_in_ready};

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        queue_1_has_a_place_for_each_result: assert (~kept | queue_1_in_ready);
`else
        if (!(~kept | queue_1_in_ready)) begin
            $display("assertion failed: queue_1_has_a_place_for_each_result in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue in a memory with a registered output.
// depth = 26
// width = 42
// storage = distributed
module stream_fifo_d26_w42_distributed (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [41:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [41:0] out_data
);
    (* ram_style = "distributed" *)
    reg [41:0] entries [0:25];
    reg [4:0] held, waiting;
    reg is_full, any_waits;
    reg [4:0] write_address, read_address;
    reg [41:0] item;

    wire has_room = ~is_full;
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [4:0] held_bits = {{4{~push}}, 1'd1};
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    always @(posedge clk) begin
        if (rst) begin
            held <= 5'd0;
            waiting <= 5'd0;
            is_full <= 1'd0;
            any_waits <= 1'd0;
            write_address <= 5'd0;
            read_address <= 5'd0;
            out_valid <= 1'd0;
        end else begin
            if (push_xor_pop) begin
                held <= held + held_bits;
                is_full <= push & (held == 5'd25);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 5'd1);
            end
            if (push) write_address <= (write_address == 5'd25) ? 5'd0 : (write_address + 5'd1);
            if (fetch) read_address <= (read_address == 5'd25) ? 5'd0 : (read_address + 5'd1);
            out_valid <= fetch | (out_valid & ~out_ready);
        end
    end
    always @(posedge clk) begin
        if (has_room) entries[write_address] <= in_data;
        if (fetch) item <= entries[read_address];
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        held_in_range: assert (held <= 5'd26);
        held_is_waiting_and_shown: assert (held == (waiting + {4'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 5'd26)) & (any_waits == |waiting));
`else
        if (!(held <= 5'd26)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {4'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 5'd26)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue of two in registers.
// width = 91
module stream_skid_w91 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [90:0] in_data,
    output wire out_valid, input wire out_ready, output wire [90:0] out_data
);
    reg head_filled, second_filled, room;
    reg [90:0] head, second;

    wire advance = ~head_filled | out_ready;
    wire some_item = second_filled | in_valid;
    wire not_advance_and_some_item = ~advance & some_item;

    assign in_ready = room;
    assign out_valid = head_filled;
    assign out_data = head;

    always @(posedge clk) begin
        if (rst) begin
            head_filled <= 1'd0;
            second_filled <= 1'd0;
            room <= 1'd1;
        end else begin
            if (advance) head_filled <= some_item;
            second_filled <= not_advance_and_some_item;
            room <= ~not_advance_and_some_item;
        end
    end
    always @(posedge clk) begin
        if (advance) head <= second_filled ? second : in_data;
        if (~second_filled) second <= in_data;
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        second_filled_or_room: assert (second_filled ^ room);
        second_waits_behind_head: assert (head_filled | ~second_filled);
`else
        if (!(second_filled ^ room)) begin
            $display("assertion failed: second_filled_or_room in %m"); $stop;
        end
        if (!(head_filled | ~second_filled)) begin
            $display("assertion failed: second_waits_behind_head in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue of two in registers.
// width = 22
module stream_skid_w22 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [21:0] in_data,
    output wire out_valid, input wire out_ready, output wire [21:0] out_data
);
    reg head_filled, second_filled, room;
    reg [21:0] head, second;

    wire advance = ~head_filled | out_ready;
    wire some_item = second_filled | in_valid;
    wire not_advance_and_some_item = ~advance & some_item;

    assign in_ready = room;
    assign out_valid = head_filled;
    assign out_data = head;

    always @(posedge clk) begin
        if (rst) begin
            head_filled <= 1'd0;
            second_filled <= 1'd0;
            room <= 1'd1;
        end else begin
            if (advance) head_filled <= some_item;
            second_filled <= not_advance_and_some_item;
            room <= ~not_advance_and_some_item;
        end
    end
    always @(posedge clk) begin
        if (advance) head <= second_filled ? second : in_data;
        if (~second_filled) second <= in_data;
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        second_filled_or_room: assert (second_filled ^ room);
        second_waits_behind_head: assert (head_filled | ~second_filled);
`else
        if (!(second_filled ^ room)) begin
            $display("assertion failed: second_filled_or_room in %m"); $stop;
        end
        if (!(head_filled | ~second_filled)) begin
            $display("assertion failed: second_waits_behind_head in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Pops paths until one is worth descending.
// threads = 4
module search_recursion (
    input  wire clk, input wire rst,
    input  wire start_valid,  // A thread taking up a query.
    input  wire [1:0] start_thread,  // Thread.
    input  wire [15:0] start_number,  // Its number, which its results bear.
    input  wire [3:0] start_k,  // Neighbors wanted.
    input  wire [23:0] start_radius2,  // Squared radius within which neighbors count.
    input  wire [23:0] start_x,  // Where.
    input  wire [23:0] start_y,  // Where.
    input  wire [23:0] start_z,  // Where.
    input  wire radius_valid,  // A thread's new radius.
    input  wire [1:0] radius_thread,  // Thread.
    input  wire [22:0] radius_radius2,  // Squared radius.
    input  wire in_valid, output wire in_ready,  // Threads that want their next path.
    input  wire [1:0] in_thread,  // Thread.
    input  wire top_empty,  // The stack of the last pop was empty.
    input  wire [6:0] top_node,  // The subtree's root.
    input  wire [22:0] top_distance2,  // Squared distance of the query to the splitting plane before it.
    output wire resume_valid, input wire resume_ready,  // Descents from a path that was not taken before.
    output wire [1:0] resume_thread,  // Thread.
    output wire [6:0] resume_node,  // Node: 1 is the root, `2i` and `2i + 1` are the children of `i`.
    output wire pop_valid,  // A thread that wants its last path back.
    output wire [1:0] pop_thread,  // Thread.
    output reg  empty_valid,  // A thread without a path left.
    output reg  [1:0] empty_thread,  // Thread.
    output reg  event_pop  // A path was popped.
);
    (* ram_style = "distributed" *)
    reg [22:0] query_radii [0:3];
    (* ram_style = "distributed" *)
    reg [22:0] leaf_radii [0:3];
    reg r0_valid, r1_valid, r2_valid, r2_empty;
    reg [1:0] r0_thread, r1_thread, r2_thread;
    reg found;
    reg [6:0] path_node;  // The subtree's root.
    reg [22:0] path_distance2;  // Squared distance of the query to the splitting plane before it.
    reg [3:0] from_leaf;
    reg [22:0] radius2;

    wire in_queue_out_valid;
    wire [1:0] in_queue_out_data;
    wire resume_queue_in_ready;
    wire [8:0] resume_queue_out_data;

    wire pops = (r2_empty | resume_queue_in_ready) & r0_valid;
    wire advance = ~r2_valid | resume_queue_in_ready;
    wire decides = advance & r2_valid;
    wire popped = decides & found;
    wire nearer = path_distance2 < radius2;
    wire back = popped & ~nearer;
    wire in_queue_out_ready = advance & ~back;
    wire r2_valid_choice = advance ? r1_valid : r2_valid;
    wire [3:0] query_set = {
        start_valid & (start_thread == 2'd3), start_valid & (start_thread == 2'd2),
        start_valid & (start_thread == 2'd1), start_valid & (start_thread == 2'd0)
    };
    wire [3:0] leaf_set = {
        radius_valid & (radius_thread == 2'd3), radius_valid & (radius_thread == 2'd2),
        radius_valid & (radius_thread == 2'd1), radius_valid & (radius_thread == 2'd0)
    };
    wire [3:0] from_leaf_shifted_by_r1_thread = from_leaf >> r1_thread;
    wire [22:0] leaf_radius2 = leaf_radii[r1_thread];
    wire [22:0] query_radius2 = query_radii[r1_thread];

    assign {resume_thread, resume_node} = resume_queue_out_data;
    assign pop_valid = pops;
    assign pop_thread = r0_thread;

    stream_skid_w2 in_queue (
        .clk(clk), .rst(rst), .in_valid(in_valid), .in_ready(in_ready), .in_data(in_thread),
        .out_valid(in_queue_out_valid), .out_ready(in_queue_out_ready), .out_data(in_queue_out_data)
    );

    stream_skid_w9 resume_queue (
        .clk(clk), .rst(rst), .in_valid(popped & nearer), .in_ready(resume_queue_in_ready),
        .in_data({r2_thread, path_node}),
        .out_valid(resume_valid), .out_ready(resume_ready), .out_data(resume_queue_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            r0_valid <= 1'd0;
            r1_valid <= 1'd0;
            r2_valid <= 1'd0;
            r2_empty <= 1'd1;
            empty_valid <= 1'd0;
            event_pop <= 1'd0;
        end else begin
            if (advance) begin
                r0_valid <= back | in_queue_out_valid;
                r1_valid <= r0_valid;
            end
            r2_valid <= r2_valid_choice;
            r2_empty <= ~r2_valid_choice;
            empty_valid <= decides & ~found;
            event_pop <= popped;
        end
    end
    always @(posedge clk) begin
        if (advance) begin
            r0_thread <= back ? r2_thread : in_queue_out_data;
            r1_thread <= r0_thread;
            r2_thread <= r1_thread;
            found <= ~top_empty;
            path_node <= top_node;
            path_distance2 <= top_distance2;
            radius2 <= from_leaf_shifted_by_r1_thread[0] ? leaf_radius2 : query_radius2;
        end
        from_leaf <= (from_leaf & ~query_set) | leaf_set;
        empty_thread <= r2_thread;
    end
    always @(posedge clk) if (start_valid) query_radii[start_thread] <= start_radius2[22:0];
    always @(posedge clk) if (radius_valid) leaf_radii[radius_thread] <= radius_radius2;

    wire _unused = &{
        1'b0, from_leaf_shifted_by_r1_thread[3:1], start_k, start_number, start_radius2[23], start_x, start_y,
        start_z
    };

`ifdef RTL_ASSERT
    reg [3:0] begun;

    wire [3:0] begun_shifted_by_r0_thread = begun >> r0_thread;

    always @(posedge clk) begin
        if (rst) begun <= 4'd0;
        else begun <= begun | query_set;
    end

    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        start_radius2_in_range: assert (~start_valid | (start_radius2 < 24'h800000));
        a_query_begins_before_its_thread_pops: assert (~r0_valid | begun_shifted_by_r0_thread[0]);
        r2_valid_or_empty: assert (r2_valid ^ r2_empty);
`else
        if (!(~start_valid | (start_radius2 < 24'h800000))) begin
            $display("assertion failed: start_radius2_in_range in %m"); $stop;
        end
        if (!(~r0_valid | begun_shifted_by_r0_thread[0])) begin
            $display("assertion failed: a_query_begins_before_its_thread_pops in %m"); $stop;
        end
        if (!(r2_valid ^ r2_empty)) begin
            $display("assertion failed: r2_valid_or_empty in %m"); $stop;
        end
`endif
    end

    wire _unused_by_checks = &{1'b0, begun_shifted_by_r0_thread[3:1]};
`endif
endmodule

// Queue of two in registers.
// width = 2
module stream_skid_w2 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [1:0] in_data,
    output wire out_valid, input wire out_ready, output wire [1:0] out_data
);
    reg head_filled, second_filled, room;
    reg [1:0] head, second;

    wire advance = ~head_filled | out_ready;
    wire some_item = second_filled | in_valid;
    wire not_advance_and_some_item = ~advance & some_item;

    assign in_ready = room;
    assign out_valid = head_filled;
    assign out_data = head;

    always @(posedge clk) begin
        if (rst) begin
            head_filled <= 1'd0;
            second_filled <= 1'd0;
            room <= 1'd1;
        end else begin
            if (advance) head_filled <= some_item;
            second_filled <= not_advance_and_some_item;
            room <= ~not_advance_and_some_item;
        end
    end
    always @(posedge clk) begin
        if (advance) head <= second_filled ? second : in_data;
        if (~second_filled) second <= in_data;
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        second_filled_or_room: assert (second_filled ^ room);
        second_waits_behind_head: assert (head_filled | ~second_filled);
`else
        if (!(second_filled ^ room)) begin
            $display("assertion failed: second_filled_or_room in %m"); $stop;
        end
        if (!(head_filled | ~second_filled)) begin
            $display("assertion failed: second_waits_behind_head in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// A stack of paths for each thread.
// threads = 4
// depth = 6
module search_stack (
    input  wire clk, input wire rst,
    input  wire push_valid,  // A path to remember.
    input  wire [1:0] push_thread,  // Thread.
    input  wire [6:0] push_node,  // The subtree's root.
    input  wire [22:0] push_distance2,  // Squared distance of the query to the splitting plane before it.
    input  wire pop_valid,  // A thread that wants its last path back.
    input  wire [1:0] pop_thread,  // Thread.
    output reg  top_empty,  // The stack of the last pop was empty.
    output wire [6:0] top_node,  // The subtree's root.
    output wire [22:0] top_distance2  // Squared distance of the query to the splitting plane before it.
);
    reg [2:0] depth_0, depth_1, depth_2, depth_3;
    wire [29:0] top;

    wire [2:0] push_depth = push_thread[1] ? (push_thread[0] ? depth_3 : depth_2) : push_thread[0] ? depth_1 : depth_0;
    wire [2:0] pop_depth = pop_thread[1] ? (pop_thread[0] ? depth_3 : depth_2) : pop_thread[0] ? depth_1 : depth_0;
    wire takes = pop_valid & |pop_depth;
    wire [3:0] up = {
        push_valid & (push_thread == 2'd3), push_valid & (push_thread == 2'd2),
        push_valid & (push_thread == 2'd1), push_valid & (push_thread == 2'd0)
    };
    wire [3:0] down = {
        takes & (pop_thread == 2'd3), takes & (pop_thread == 2'd2), takes & (pop_thread == 2'd1),
        takes & (pop_thread == 2'd0)
    };

    assign {top_node, top_distance2} = top;

    memory_1w1r_unordered #(.WIDTH(30), .DEPTH(32)) paths (
        .clk(clk), .write(push_valid), .write_address({push_thread, push_depth}),
        .write_data({push_node, push_distance2}),
        .read(takes), .read_address({pop_thread, pop_depth - 3'd1}), .read_data(top)
    );

    always @(posedge clk) begin
        if (rst) begin
            depth_0 <= 3'd0;
            depth_1 <= 3'd0;
            depth_2 <= 3'd0;
            depth_3 <= 3'd0;
            top_empty <= 1'd1;
        end else begin
            if (up[0] | down[0]) depth_0 <= up[0] ? (depth_0 + 3'd1) : (depth_0 - 3'd1);
            if (up[1] | down[1]) depth_1 <= up[1] ? (depth_1 + 3'd1) : (depth_1 - 3'd1);
            if (up[2] | down[2]) depth_2 <= up[2] ? (depth_2 + 3'd1) : (depth_2 - 3'd1);
            if (up[3] | down[3]) depth_3 <= up[3] ? (depth_3 + 3'd1) : (depth_3 - 3'd1);
            if (pop_valid) top_empty <= pop_depth == 3'd0;
        end
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        stack_has_room: assert (~push_valid | (push_depth < 3'd6));
        one_access_a_thread: assert (~(push_valid & pop_valid & (push_thread == pop_thread)));
`else
        if (!(~push_valid | (push_depth < 3'd6))) begin
            $display("assertion failed: stack_has_room in %m"); $stop;
        end
        if (!(~(push_valid & pop_valid & (push_thread == pop_thread)))) begin
            $display("assertion failed: one_access_a_thread in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Descends to leaves and stacks the paths not taken.
// threads = 4
// tree_depth = 6
module search_traversal (
    input  wire clk, input wire rst,
    input  wire start_valid,  // A thread taking up a query.
    input  wire [1:0] start_thread,  // Thread.
    input  wire [15:0] start_number,  // Its number, which its results bear.
    input  wire [3:0] start_k,  // Neighbors wanted.
    input  wire [23:0] start_radius2,  // Squared radius within which neighbors count.
    input  wire [23:0] start_x,  // Where.
    input  wire [23:0] start_y,  // Where.
    input  wire [23:0] start_z,  // Where.
    input  wire descend_valid, output wire descend_ready,  // Descents from the root.
    input  wire [1:0] descend_thread,  // Thread.
    input  wire [6:0] descend_node,  // Node: 1 is the root, `2i` and `2i + 1` are the children of `i`.
    input  wire resume_valid, output wire resume_ready,  // Descents from a path that was not taken before.
    input  wire [1:0] resume_thread,  // Thread.
    input  wire [6:0] resume_node,  // Node: 1 is the root, `2i` and `2i + 1` are the children of `i`.
    output wire leaf_valid, input wire leaf_ready,  // Leaves reached.
    output wire [1:0] leaf_thread,  // Thread.
    output wire [5:0] leaf_leaf,  // The leaf's number among those of the deepest level (eq. 6.7).
    input  wire tree_valid,  // Write to the node memory.
    input  wire tree_is_leaf,  // Chooses the leaf table, else the node memory.
    input  wire [5:0] tree_address,  // The leaf's number or the node.
    input  wire [23:0] tree_split,  // Where its plane cuts its dimension.
    input  wire [1:0] tree_dimension,  // Its dimension.
    input  wire tree_internal_leaf,  // It is a leaf.
    input  wire [15:0] tree_begin,  // The first beat.
    input  wire [3:0] tree_beats,  // The number of beats, at least one.
    output reg  event_node,  // A node was visited.
    output wire push_valid,  // A path to remember.
    output wire [1:0] push_thread,  // Thread.
    output wire [6:0] push_node,  // The subtree's root.
    output wire [22:0] push_distance2,  // Squared distance of the query to the splitting plane before it.
    output wire reached_valid,  // A thread's descent ended in a leaf.
    output wire [1:0] reached_thread  // Thread.
);
    reg f_valid;
    reg [1:0] f_thread;  // Thread.
    reg [6:0] f_node;  // Node: 1 is the root, `2i` and `2i + 1` are the children of `i`.
    reg v_valid;
    reg [1:0] v_thread;  // Thread.
    reg [6:0] v_node;  // Node: 1 is the root, `2i` and `2i + 1` are the children of `i`.
    reg s_valid;
    reg [1:0] s_thread;  // Thread.
    reg [6:0] s_node;  // Node: 1 is the root, `2i` and `2i + 1` are the children of `i`.
    reg f_is_child, s_at_leaf;
    reg [23:0] s_coordinate, s_split;
    reg [1:0] s_dimension;
    wire [26:0] even_node, odd_node;
    reg [23:0] v_even_split, v_odd_split;
    reg [1:0] v_dimension;
    reg v_internal_leaf;
    reg [2:0] v_places;
    wire [71:0] query;

    wire descend_queue_out_valid;
    wire [8:0] descend_queue_out_data;
    wire resume_queue_out_valid;
    wire [8:0] resume_queue_out_data;
    wire leaf_queue_in_ready;
    wire [7:0] leaf_queue_out_data;
    wire path_in_ready, path_out_valid, path_out_is_leaf, less_x_even_y, less_y_even_y, less_z_even_y;
    wire less_x_odd_y, less_y_odd_y, less_z_odd_y;

    wire writes_even_both = tree_valid & ~tree_is_leaf;
    wire writes_even = writes_even_both & ~tree_address[0];
    wire [26:0] even_nodes_data_bits = {tree_split, tree_dimension, tree_internal_leaf};
    wire at_leaf = v_node[6] | v_internal_leaf;
    wire reaches = v_valid & at_leaf;
    wire proceeds = ~reaches | leaf_queue_in_ready;
    wire advance = path_in_ready & proceeds;
    wire descends = v_valid & ~at_leaf;
    wire [6:0] resume_queue_out_node = resume_queue_out_data[6:0];
    wire [6:0] descend_queue_out_node = descend_queue_out_data[6:0];
    wire [6:0] next_node_choice = resume_queue_out_valid ? resume_queue_out_node : descend_queue_out_node;
    wire [6:0] next_node = descends ? {v_node[5:0], 1'd0} : next_node_choice;
    wire writes_odd = writes_even_both & tree_address[0];
    wire resumes = resume_queue_out_valid & ~descends;
    wire descend_queue_out_ready = advance & ~(descends | resumes);
    wire resume_queue_out_ready = advance & ~descends;
    wire [6:0] v_node_shifted_by_v_places = v_node << v_places;
    wire left_choice = s_dimension[1] ? less_z_odd_y : s_dimension[0] ? less_y_odd_y : less_x_odd_y;
    wire left_choice_2 = s_dimension[1] ? less_z_even_y : s_dimension[0] ? less_y_even_y : less_x_even_y;
    wire left = s_node[0] ? left_choice : left_choice_2;
    wire [1:0] resume_queue_out_thread = resume_queue_out_data[8:7];
    wire [1:0] descend_queue_out_thread = descend_queue_out_data[8:7];
    wire [1:0] f_thread_choice = resume_queue_out_valid ? resume_queue_out_thread : descend_queue_out_thread;
    wire v_node_choice = f_is_child ? ~left : f_node[0];
    wire [23:0] coordinate = v_dimension[1] ? query[23:0] : v_dimension[0] ? query[47:24] : query[71:48];
    wire not_f_node_6_and_not_f_node_5 = ~f_node[6] & ~f_node[5];
    wire v_places_both = not_f_node_6_and_not_f_node_5 & (~f_node[4] & ~f_node[3]);
    wire not_f_node_2_and_not_f_node_1 = ~f_node[2] & ~f_node[1];
    wire [1:0] v_places_bits = {not_f_node_2_and_not_f_node_1, not_f_node_2_and_not_f_node_1 ? 1'd0 : ~f_node[2]};
    wire [1:0] v_places_bits_2 = {not_f_node_6_and_not_f_node_5, not_f_node_6_and_not_f_node_5 ? ~f_node[4] : ~f_node[6]};

    assign {leaf_thread, leaf_leaf} = leaf_queue_out_data;
    assign push_valid = path_out_valid & ~path_out_is_leaf;
    assign reached_valid = path_out_valid & path_out_is_leaf;
    assign reached_thread = push_thread;

    memory_1w1r_unordered #(.WIDTH(27), .DEPTH(32)) even_nodes (
        .clk(clk), .write(writes_even), .write_address(tree_address[5:1]), .write_data(even_nodes_data_bits),
        .read(advance), .read_address(next_node[5:1]), .read_data(even_node)
    );

    memory_1w1r_unordered #(.WIDTH(27), .DEPTH(32)) odd_nodes (
        .clk(clk), .write(writes_odd), .write_address(tree_address[5:1]), .write_data(even_nodes_data_bits),
        .read(advance), .read_address(next_node[5:1]), .read_data(odd_node)
    );

    memory_1w1r #(.WIDTH(72), .DEPTH(4)) queries (
        .clk(clk), .write(start_valid), .write_address(start_thread),
        .write_data({start_x, start_y, start_z}),
        .read(advance), .read_address(f_thread), .read_data(query)
    );

    stream_skid_w9 descend_queue (
        .clk(clk), .rst(rst), .in_valid(descend_valid), .in_ready(descend_ready),
        .in_data({descend_thread, descend_node}),
        .out_valid(descend_queue_out_valid), .out_ready(descend_queue_out_ready),
        .out_data(descend_queue_out_data)
    );

    stream_skid_w9 resume_queue (
        .clk(clk), .rst(rst), .in_valid(resume_valid), .in_ready(resume_ready),
        .in_data({resume_thread, resume_node}),
        .out_valid(resume_queue_out_valid), .out_ready(resume_queue_out_ready),
        .out_data(resume_queue_out_data)
    );

    stream_skid_w8 leaf_queue (
        .clk(clk), .rst(rst), .in_valid(advance & reaches), .in_ready(leaf_queue_in_ready),
        .in_data({v_thread, v_node_shifted_by_v_places[5:0]}),
        .out_valid(leaf_valid), .out_ready(leaf_ready), .out_data(leaf_queue_out_data)
    );

    search_path path (
        .clk(clk), .rst(rst), .in_valid(s_valid & proceeds), .in_ready(path_in_ready), .in_is_leaf(s_at_leaf),
        .in_thread(s_thread), .in_node({s_node[5:0], left}), .in_coordinate(s_coordinate), .in_split(s_split),
        .out_valid(path_out_valid), .out_ready(1'd1), .out_is_leaf(path_out_is_leaf),
        .out_thread(push_thread), .out_node(push_node), .out_distance2(push_distance2)
    );

    float_lt_s1_f24ftz less_x_even (
        .clk(clk), .enable(advance), .a(query[71:48]), .b(v_even_split), .y(less_x_even_y)
    );

    float_lt_s1_f24ftz less_y_even (
        .clk(clk), .enable(advance), .a(query[47:24]), .b(v_even_split), .y(less_y_even_y)
    );

    float_lt_s1_f24ftz less_z_even (
        .clk(clk), .enable(advance), .a(query[23:0]), .b(v_even_split), .y(less_z_even_y)
    );

    float_lt_s1_f24ftz less_x_odd (
        .clk(clk), .enable(advance), .a(query[71:48]), .b(v_odd_split), .y(less_x_odd_y)
    );

    float_lt_s1_f24ftz less_y_odd (
        .clk(clk), .enable(advance), .a(query[47:24]), .b(v_odd_split), .y(less_y_odd_y)
    );

    float_lt_s1_f24ftz less_z_odd (
        .clk(clk), .enable(advance), .a(query[23:0]), .b(v_odd_split), .y(less_z_odd_y)
    );

    always @(posedge clk) begin
        if (rst) begin
            f_valid <= 1'd0;
            v_valid <= 1'd0;
            s_valid <= 1'd0;
            event_node <= 1'd0;
        end else begin
            if (advance) begin
                f_valid <= descends | (resume_queue_out_valid | descend_queue_out_valid);
                v_valid <= f_valid;
                s_valid <= v_valid;
            end
            event_node <= advance & v_valid;
        end
    end
    always @(posedge clk) begin
        if (advance) begin
            f_thread <= descends ? v_thread : f_thread_choice;
            f_node <= next_node;
            v_thread <= f_thread;
            v_node <= {f_node[6:1], v_node_choice};
            s_thread <= v_thread;
            s_node <= v_node;
            f_is_child <= descends;
            s_at_leaf <= at_leaf;
            s_coordinate <= coordinate;
            s_split <= v_node[0] ? v_odd_split : v_even_split;
            s_dimension <= v_dimension;
            v_even_split <= even_node[26:3];
            v_odd_split <= odd_node[26:3];
            v_dimension <= v_node_choice ? odd_node[2:1] : even_node[2:1];
            v_internal_leaf <= v_node_choice ? odd_node[0] : even_node[0];
            v_places <= {v_places_both, v_places_both ? v_places_bits : v_places_bits_2};
        end
    end

    wire _unused = &{
        1'b0, s_node[6], start_k, start_number, start_radius2, tree_beats, tree_begin,
        v_node_shifted_by_v_places[6]
    };

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        start_radius2_in_range: assert (~start_valid | (start_radius2 < 24'h800000));
`else
        if (!(~start_valid | (start_radius2 < 24'h800000))) begin
            $display("assertion failed: start_radius2_in_range in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Whether one floating-point number is less than another.
// stages = 1
// format = f24-ftz
module float_lt_s1_f24ftz (
    input  wire clk, input wire enable, input wire [23:0] a, input wire [23:0] b,
    output reg  y
);
    wire y_in_order = {~a[23], a[22:0] ^ {23{a[23]}}} < {~b[23], b[22:0] ^ {23{b[23]}}};

    always @(posedge clk) begin
        if (enable) begin
            y <= y_in_order & ~((a[22:15] == 8'd0) & (b[22:15] == 8'd0)) & ~((&a[22:15] & |a[14:0]) | (&b[22:15] & |b[14:0]));
        end
    end
endmodule

// Squared distance of a query to a splitting plane.
// latency = 10
// initiation_interval = 1
module search_path (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire in_is_leaf, input wire [1:0] in_thread,
    input  wire [6:0] in_node, input wire [23:0] in_coordinate, input wire [23:0] in_split,
    output wire out_valid, input wire out_ready, output wire out_is_leaf, output wire [1:0] out_thread,
    output wire [6:0] out_node, output wire [22:0] out_distance2
);
    (* ram_style = "distributed" *)
    reg [9:0] delay_10_from_0 [0:8];
    reg [3:0] delay_10_from_0_pointer;
    reg [9:0] delay_10_from_0_out, in_flight;
    reg shown, shown_is_leaf;
    reg [1:0] shown_thread;
    reg [6:0] shown_node;
    reg [22:0] shown_distance2;

    wire [23:0] add_f24_ftz_unit_y, mul_f24_ftz_unit_y;

    wire kept = in_flight[9];
    wire is_leaf_d10 = delay_10_from_0_out[0];
    wire [1:0] thread_d10 = delay_10_from_0_out[2:1];
    wire [6:0] node_d10 = delay_10_from_0_out[9:3];

    assign in_ready = 1'd1;
    assign out_valid = shown;
    assign out_is_leaf = shown_is_leaf;
    assign out_thread = shown_thread;
    assign out_node = shown_node;
    assign out_distance2 = shown_distance2;

    float_add_s6_f24ftz add_f24_ftz_unit (
        .clk(clk), .enable(1'd1), .a(in_coordinate), .b({~in_split[23], in_split[22:0]}),
        .y(add_f24_ftz_unit_y)
    );

    float_mul_s4_f24ftz mul_f24_ftz_unit (
        .clk(clk), .enable(1'd1), .a(add_f24_ftz_unit_y), .b(add_f24_ftz_unit_y), .y(mul_f24_ftz_unit_y)
    );

    always @(posedge clk) begin
        if (rst) begin
            delay_10_from_0_pointer <= 4'd0;
            in_flight <= 10'd0;
            shown <= 1'd0;
        end else begin
            delay_10_from_0_pointer <= (delay_10_from_0_pointer == 4'd8) ? (delay_10_from_0_pointer - 4'd8) : (delay_10_from_0_pointer + 4'd1);
            in_flight <= {in_flight[8:0], in_valid};
            shown <= kept;
        end
    end
    always @(posedge clk) begin
        shown_is_leaf <= is_leaf_d10;
        shown_thread <= thread_d10;
        shown_node <= node_d10;
        shown_distance2 <= mul_f24_ftz_unit_y[22:0];
    end
    always @(posedge clk) begin
        delay_10_from_0[delay_10_from_0_pointer] <= {in_node, in_thread, in_is_leaf};
        delay_10_from_0_out <= delay_10_from_0[delay_10_from_0_pointer];
    end

    wire _unused = &{1'b0, mul_f24_ftz_unit_y[23], out_ready};

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        results_are_taken: assert (~shown | out_ready);
`else
        if (!(~shown | out_ready)) begin
            $display("assertion failed: results_are_taken in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Floating-point product.
// stages = 4
// format = f24-ftz
module float_mul_s4_f24ftz (
    input  wire clk, input wire enable, input wire [23:0] a, input wire [23:0] b,
    output reg  [23:0] y
);
    reg [15:0] left_s1, right_s1;
    reg [9:0] exponent_s1;
    reg [31:0] product_s2;
    reg [9:0] exponent_s2, exponent_s3;
    reg [17:0] significand_s3;
    reg sign_s1, sign_s2, sign_s3, nan_s1, nan_s2, nan_s3, infinite_s1, infinite_s2, infinite_s3, zero_s1;
    reg zero_s2, zero_s3;

    wire [7:0] a_field = a[22:15];
    wire [14:0] a_fraction = a[14:0];
    wire [7:0] b_field = b[22:15];
    wire [14:0] b_fraction = b[14:0];
    wire [31:0] significand_s3_choice = product_s2[31] ? product_s2 : (product_s2 << 1);
    wire nan_s1_both = &a_field & (a_fraction == 15'd0);
    wire nan_s1_inverted = ~(|b_field);
    wire nan_s1_either = (&a_field & |a_fraction) | (&b_field & |b_fraction) | (nan_s1_both & nan_s1_inverted);
    wire nan_s1_inverted_2 = ~(|a_field);
    wire nan_s1_both_2 = &b_field & (b_fraction == 15'd0);
    wire y_both = (exponent_s3 == 10'd0) & ~(&significand_s3[16:2] & significand_s3[1]);
    wire round_up = significand_s3[1] & (significand_s3[0] | significand_s3[2]);
    wire [22:0] rounded = {exponent_s3[7:0], significand_s3[16:2]} + {22'd0, round_up};
    wire [22:0] y_choice = (infinite_s3 | (~exponent_s3[9] & (10'd255 <= exponent_s3))) ? 23'h7f8000 : rounded;
    wire [22:0] y_choice_2 = (zero_s3 | ((exponent_s3[9] | y_both) & ~infinite_s3)) ? 23'd0 : y_choice;

    always @(posedge clk) begin
        if (enable) begin
            left_s1 <= {|a_field, a_fraction & {15{|a_field}}};
            right_s1 <= {|b_field, b_fraction & {15{|b_field}}};
            exponent_s1 <= {2'd0, a_field} + {2'd0, b_field};
            product_s2 <= {16'd0, left_s1} * {16'd0, right_s1};
            exponent_s2 <= exponent_s1 - 10'd127;
            exponent_s3 <= exponent_s2 + {9'd0, product_s2[31]};
            significand_s3 <= {significand_s3_choice[31:15], |significand_s3_choice[14:0]};
            sign_s1 <= a[23] ^ b[23];
            sign_s2 <= sign_s1;
            sign_s3 <= sign_s2;
            nan_s1 <= nan_s1_either | (nan_s1_inverted_2 & nan_s1_both_2);
            nan_s2 <= nan_s1;
            nan_s3 <= nan_s2;
            infinite_s1 <= nan_s1_both | nan_s1_both_2;
            infinite_s2 <= infinite_s1;
            infinite_s3 <= infinite_s2;
            zero_s1 <= nan_s1_inverted_2 | nan_s1_inverted;
            zero_s2 <= zero_s1;
            zero_s3 <= zero_s2;
            y <= nan_s3 ? 24'h7fc000 : {sign_s3, y_choice_2};
        end
    end

    wire _unused = &{1'b0, significand_s3[17]};
endmodule

// Floating-point sum.
// stages = 6
// format = f24-ftz
module float_add_s6_f24ftz (
    input  wire clk, input wire enable, input wire [23:0] a, input wire [23:0] b,
    output reg  [23:0] y
);
    reg [9:0] distance_s1;
    reg [15:0] large_s1, small_s1, large_s2;
    reg [18:0] aligned_s2;
    reg subtract_s1, subtract_s2;
    reg [19:0] sum_s3;
    reg sign_s1, sign_s2, sign_s3, nan_s1, nan_s2, nan_s3, infinite_s1, infinite_s2, infinite_s3, subtract_s3;
    reg [19:0] value_s4;
    reg [4:0] zeros_s4;
    reg [9:0] limit_s1, limit_s2, limit_s3, limit_s4, exponent_s5;
    reg [17:0] significand_s5;
    reg sign_s4, sign_s5, nan_s4, nan_s5, infinite_s4, infinite_s5, zero_s4, zero_s5;

    wire swap = a[22:0] < b[22:0];
    wire [7:0] b_field = b[22:15];
    wire [7:0] a_field = a[22:15];
    wire large_s1_inverted = ~(|a_field);
    wire large_s1_inverted_2 = ~(|b_field);
    wire large_s1_inverted_3 = ~(large_s1_inverted & large_s1_inverted_2);
    wire [14:0] b_fraction = b[14:0];
    wire [14:0] a_fraction = a[14:0];
    wire small_s1_inverted = ~(large_s1_inverted | large_s1_inverted_2);
    wire [18:0] aligned_s2_choice = distance_s1[4] ? ({small_s1, 3'd0} >> 16) : {small_s1, 3'd0};
    wire [18:0] aligned_s2_choice_2 = distance_s1[3] ? (aligned_s2_choice >> 8) : aligned_s2_choice;
    wire [18:0] aligned_s2_choice_3 = distance_s1[2] ? (aligned_s2_choice_2 >> 4) : aligned_s2_choice_2;
    wire [18:0] aligned_s2_choice_4 = distance_s1[1] ? (aligned_s2_choice_3 >> 2) : aligned_s2_choice_3;
    wire [18:0] aligned_s2_choice_5 = distance_s1[0] ? (aligned_s2_choice_4 >> 1) : aligned_s2_choice_4;
    wire aligned_s2_either = (distance_s1[4] & |{small_s1[12:0], 3'd0}) | (distance_s1[3] & |aligned_s2_choice[7:0]);
    wire aligned_s2_either_2 = aligned_s2_either | (distance_s1[2] & |aligned_s2_choice_2[3:0]) | (distance_s1[1] & |aligned_s2_choice_3[1:0]);
    wire aligned_s2_either_3 = aligned_s2_choice_5[0] | (aligned_s2_either_2 | (distance_s1[0] & aligned_s2_choice_4[0]));
    wire a_23_xor_b_23 = a[23] ^ b[23];
    wire [20:0] sum_s3_sum = {1'd0, large_s2, 4'd1} + {{1'd0, aligned_s2} ^ {20{subtract_s2}}, subtract_s2};
    wire nan_s1_both = &a_field & (a_fraction == 15'd0);
    wire nan_s1_both_2 = &b_field & (b_fraction == 15'd0);
    wire zeros_s4_both = ~sum_s3[19] & ~sum_s3[18];
    wire zeros_s4_both_2 = zeros_s4_both & (~sum_s3[17] & ~sum_s3[16]);
    wire zeros_s4_both_3 = ~sum_s3[15] & ~sum_s3[14];
    wire zeros_s4_both_4 = zeros_s4_both_2 & (zeros_s4_both_3 & (~sum_s3[13] & ~sum_s3[12]));
    wire zeros_s4_both_5 = ~sum_s3[11] & ~sum_s3[10];
    wire zeros_s4_both_6 = zeros_s4_both_5 & (~sum_s3[9] & ~sum_s3[8]);
    wire not_sum_s3_7_and_not_sum_s3_6 = ~sum_s3[7] & ~sum_s3[6];
    wire zeros_s4_both_7 = zeros_s4_both_6 & (not_sum_s3_7_and_not_sum_s3_6 & (~sum_s3[5] & ~sum_s3[4]));
    wire zeros_s4_both_8 = zeros_s4_both_4 & zeros_s4_both_7;
    wire not_sum_s3_3_and_not_sum_s3_2 = ~sum_s3[3] & ~sum_s3[2];
    wire zeros_s4_both_9 = not_sum_s3_3_and_not_sum_s3_2 & (~sum_s3[1] & ~sum_s3[0]);
    wire [1:0] zeros_s4_bits = {not_sum_s3_3_and_not_sum_s3_2, not_sum_s3_3_and_not_sum_s3_2 ? ~sum_s3[1] : ~sum_s3[3]};
    wire [1:0] zeros_s4_bits_2 = {not_sum_s3_7_and_not_sum_s3_6, not_sum_s3_7_and_not_sum_s3_6 ? ~sum_s3[5] : ~sum_s3[7]};
    wire [1:0] zeros_s4_choice = zeros_s4_both_6 ? zeros_s4_bits_2 : {zeros_s4_both_5, zeros_s4_both_5 ? ~sum_s3[9] : ~sum_s3[11]};
    wire [1:0] zeros_s4_choice_2 = zeros_s4_both_2 ? {zeros_s4_both_3, zeros_s4_both_3 ? ~sum_s3[13] : ~sum_s3[15]} : {zeros_s4_both, zeros_s4_both ? ~sum_s3[17] : ~sum_s3[19]};
    wire [2:0] zeros_s4_choice_3 = zeros_s4_both_4 ? {zeros_s4_both_6, zeros_s4_choice} : {zeros_s4_both_2, zeros_s4_choice_2};
    wire [3:0] zeros_s4_choice_4 = zeros_s4_both_8 ? {1'd0, zeros_s4_both_9, zeros_s4_both_9 ? 2'd0 : zeros_s4_bits} : {zeros_s4_both_4, zeros_s4_choice_3};
    wire [19:0] value_s4_shifted_by_zeros_s4 = value_s4 << zeros_s4;
    wire sum_s3_is_0 = sum_s3 == 20'd0;
    wire y_both = (exponent_s5 == 10'd0) & ~(&significand_s5[16:2] & significand_s5[1]);
    wire round_up = significand_s5[1] & (significand_s5[0] | significand_s5[2]);
    wire [22:0] rounded = {exponent_s5[7:0], significand_s5[16:2]} + {22'd0, round_up};
    wire [22:0] y_choice = (infinite_s5 | (~exponent_s5[9] & (10'd255 <= exponent_s5))) ? 23'h7f8000 : rounded;
    wire [22:0] y_choice_2 = (zero_s5 | ((exponent_s5[9] | y_both) & ~infinite_s5)) ? 23'd0 : y_choice;

    always @(posedge clk) begin
        if (enable) begin
            distance_s1 <= swap ? ({2'd0, b_field} - {2'd0, a_field}) : ({2'd0, a_field} - {2'd0, b_field});
            large_s1 <= {large_s1_inverted_3, (swap ? b_fraction : a_fraction) & {15{large_s1_inverted_3}}};
            small_s1 <= {small_s1_inverted, (swap ? a_fraction : b_fraction) & {15{small_s1_inverted}}};
            large_s2 <= large_s1;
            aligned_s2 <= |distance_s1[7:5] ? {18'd0, |{small_s1, 3'd0}} : {aligned_s2_choice_5[18:1], aligned_s2_either_3};
            subtract_s1 <= a_23_xor_b_23;
            subtract_s2 <= subtract_s1;
            sum_s3 <= sum_s3_sum[20:1];
            sign_s1 <= swap ? b[23] : a[23];
            sign_s2 <= sign_s1;
            sign_s3 <= sign_s2;
            nan_s1 <= (&a_field & |a_fraction) | (&b_field & |b_fraction) | (nan_s1_both & nan_s1_both_2 & a_23_xor_b_23);
            nan_s2 <= nan_s1;
            nan_s3 <= nan_s2;
            infinite_s1 <= nan_s1_both | nan_s1_both_2;
            infinite_s2 <= infinite_s1;
            infinite_s3 <= infinite_s2;
            subtract_s3 <= subtract_s2;
            value_s4 <= sum_s3;
            zeros_s4 <= {zeros_s4_both_8, zeros_s4_choice_4};
            limit_s1 <= swap ? {2'd0, b_field} : {2'd0, a_field};
            limit_s2 <= limit_s1;
            limit_s3 <= limit_s2;
            limit_s4 <= limit_s3;
            exponent_s5 <= (limit_s4 + 10'd1) - {5'd0, zeros_s4};
            significand_s5 <= {value_s4_shifted_by_zeros_s4[19:3], |value_s4_shifted_by_zeros_s4[2:0]};
            sign_s4 <= sign_s3 & ~(sum_s3_is_0 & subtract_s3);
            sign_s5 <= sign_s4;
            nan_s4 <= nan_s3;
            nan_s5 <= nan_s4;
            infinite_s4 <= infinite_s3;
            infinite_s5 <= infinite_s4;
            zero_s4 <= sum_s3_is_0 & ~infinite_s3;
            zero_s5 <= zero_s4;
            y <= nan_s5 ? 24'h7fc000 : {sign_s5, y_choice_2};
        end
    end

    wire _unused = &{1'b0, distance_s1[9:8], significand_s5[17], sum_s3_sum[0]};
endmodule

// Queue of two in registers.
// width = 8
module stream_skid_w8 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [7:0] in_data,
    output wire out_valid, input wire out_ready, output wire [7:0] out_data
);
    reg head_filled, second_filled, room;
    reg [7:0] head, second;

    wire advance = ~head_filled | out_ready;
    wire some_item = second_filled | in_valid;
    wire not_advance_and_some_item = ~advance & some_item;

    assign in_ready = room;
    assign out_valid = head_filled;
    assign out_data = head;

    always @(posedge clk) begin
        if (rst) begin
            head_filled <= 1'd0;
            second_filled <= 1'd0;
            room <= 1'd1;
        end else begin
            if (advance) head_filled <= some_item;
            second_filled <= not_advance_and_some_item;
            room <= ~not_advance_and_some_item;
        end
    end
    always @(posedge clk) begin
        if (advance) head <= second_filled ? second : in_data;
        if (~second_filled) second <= in_data;
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        second_filled_or_room: assert (second_filled ^ room);
        second_waits_behind_head: assert (head_filled | ~second_filled);
`else
        if (!(second_filled ^ room)) begin
            $display("assertion failed: second_filled_or_room in %m"); $stop;
        end
        if (!(head_filled | ~second_filled)) begin
            $display("assertion failed: second_waits_behind_head in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Gives queries to threads and says what each does next.
// threads = 4
// leaves_in_flight = 1
module search_threads (
    input  wire clk, input wire rst,
    input  wire query_valid, output wire query_ready,  // Queries.
    input  wire [15:0] query_number,  // Its number, which its results bear.
    input  wire [3:0] query_k,  // Neighbors wanted.
    input  wire [23:0] query_radius2,  // Squared radius within which neighbors count.
    input  wire [23:0] query_x,  // Where.
    input  wire [23:0] query_y,  // Where.
    input  wire [23:0] query_z,  // Where.
    output reg  start_valid,  // A thread taking up a query.
    output reg  [1:0] start_thread,  // Thread.
    output reg  [15:0] start_number,  // Its number, which its results bear.
    output reg  [3:0] start_k,  // Neighbors wanted.
    output reg  [23:0] start_radius2,  // Squared radius within which neighbors count.
    output reg  [23:0] start_x,  // Where.
    output reg  [23:0] start_y,  // Where.
    output reg  [23:0] start_z,  // Where.
    output wire descend_valid, input wire descend_ready,  // Descents from the root.
    output wire [1:0] descend_thread,  // Thread.
    output wire [6:0] descend_node,  // Node: 1 is the root, `2i` and `2i + 1` are the children of `i`.
    output wire pop_valid, input wire pop_ready,  // Threads that want their next path.
    output wire [1:0] pop_thread,  // Thread.
    output wire finish_valid, input wire finish_ready,  // Threads whose search is over.
    output wire [1:0] finish_thread,  // Thread.
    input  wire reached_valid,  // A thread's descent ended in a leaf.
    input  wire [1:0] reached_thread,  // Thread.
    input  wire leaf_done_valid,  // All points of a leaf are in the thread's queue.
    input  wire [1:0] leaf_done_thread,  // Thread.
    input  wire skipped_valid,  // No point of a leaf was near enough for the thread's queue.
    input  wire [1:0] skipped_thread,  // Thread.
    input  wire empty_valid,  // A thread's stack was empty.
    input  wire [1:0] empty_thread,  // Thread.
    input  wire released_valid,  // A thread whose results are safe.
    input  wire [1:0] released_thread,  // Thread.
    output reg  event_thread_wait  // A query waited for a free thread.
);
    reg [3:0] busy, waiting, exhausted, wants_pop, wants_finish;
    reg any_free;
    reg [3:0] behind_pop, chosen_pop;
    reg pop_shown;
    reg [3:0] behind_finish, chosen_finish;
    reg finish_shown, outstanding_0, outstanding_1, outstanding_2, outstanding_3;

    wire descend_queue_in_ready;
    wire [8:0] descend_queue_out_data;

    assign query_ready = any_free & ~start_valid & descend_queue_in_ready;
    wire [3:0] free = ~busy & (4'd0 - ~busy);
    wire take = query_valid & query_ready;
    wire [3:0] released_set = {
        released_valid & (released_thread == 2'd3), released_valid & (released_thread == 2'd2),
        released_valid & (released_thread == 2'd1), released_valid & (released_thread == 2'd0)
    };
    wire [3:0] kept = ~released_set;
    wire [3:0] busy_next = (busy | (free & {4{take}})) & kept;
    wire [3:0] leaf_done_set = {
        leaf_done_valid & (leaf_done_thread == 2'd3), leaf_done_valid & (leaf_done_thread == 2'd2),
        leaf_done_valid & (leaf_done_thread == 2'd1), leaf_done_valid & (leaf_done_thread == 2'd0)
    };
    wire [3:0] skipped_set = {
        skipped_valid & (skipped_thread == 2'd3), skipped_valid & (skipped_thread == 2'd2),
        skipped_valid & (skipped_thread == 2'd1), skipped_valid & (skipped_thread == 2'd0)
    };
    wire [3:0] leaf_ended = leaf_done_set | skipped_set;
    wire [3:0] reached_set = {
        reached_valid & (reached_thread == 2'd3), reached_valid & (reached_thread == 2'd2),
        reached_valid & (reached_thread == 2'd1), reached_valid & (reached_thread == 2'd0)
    };
    wire outstanding_3_next = ((outstanding_3 + reached_set[3]) - leaf_done_set[3]) - skipped_set[3];
    wire outstanding_2_next = ((outstanding_2 + reached_set[2]) - leaf_done_set[2]) - skipped_set[2];
    wire outstanding_1_next = ((outstanding_1 + reached_set[1]) - leaf_done_set[1]) - skipped_set[1];
    wire outstanding_0_next = ((outstanding_0 + reached_set[0]) - leaf_done_set[0]) - skipped_set[0];
    wire [3:0] waiting_bits = {
        outstanding_3_next < 1'd1, outstanding_2_next < 1'd1, outstanding_1_next < 1'd1,
        outstanding_0_next < 1'd1
    };
    wire [3:0] empty_set = {
        empty_valid & (empty_thread == 2'd3), empty_valid & (empty_thread == 2'd2),
        empty_valid & (empty_thread == 2'd1), empty_valid & (empty_thread == 2'd0)
    };
    wire [3:0] exhausted_now = exhausted | empty_set;
    wire [3:0] pop_next = wants_pop & behind_pop;
    wire pop_from_next = |pop_next;
    wire [3:0] pop_below_next = pop_next - 4'd1;
    wire [3:0] pop_below_any = wants_pop - 4'd1;
    wire [3:0] first_pop = pop_from_next ? (pop_next & ~pop_below_next) : (wants_pop & ~pop_below_any);
    wire pop_advance = pop_ready | ~pop_shown;
    wire [3:0] granted_pop = first_pop & {4{pop_advance}};
    wire [3:0] wants_pop_either = (wants_pop & ~granted_pop) | ((reached_set & waiting_bits) | (leaf_ended & waiting));
    wire [3:0] finish_next = wants_finish & behind_finish;
    wire finish_from_next = |finish_next;
    wire [3:0] finish_below_next = finish_next - 4'd1;
    wire [3:0] finish_below_any = wants_finish - 4'd1;
    wire [3:0] first_finish = finish_from_next ? (finish_next & ~finish_below_next) : (wants_finish & ~finish_below_any);
    wire finish_advance = finish_ready | ~finish_shown;
    wire [3:0] granted_finish = first_finish & {4{finish_advance}};
    wire [3:0] wants_finish_bits = {~outstanding_3_next, ~outstanding_2_next, ~outstanding_1_next, ~outstanding_0_next};
    wire [3:0] wants_finish_either = (wants_finish & ~granted_finish) | ((empty_set | leaf_ended) & (exhausted_now & wants_finish_bits));
    wire [3:0] behind_pop_choice = pop_from_next ? (pop_next ^ pop_below_next) : (wants_pop ^ pop_below_any);
    wire [3:0] behind_finish_choice = finish_from_next ? (finish_next ^ finish_below_next) : (wants_finish ^ finish_below_any);

    assign {descend_thread, descend_node} = descend_queue_out_data;
    assign pop_valid = pop_shown;
    assign pop_thread = {|(chosen_pop & 4'd12), |(chosen_pop & 4'd10)};
    assign finish_valid = finish_shown;
    assign finish_thread = {|(chosen_finish & 4'd12), |(chosen_finish & 4'd10)};

    stream_skid_w9 descend_queue (
        .clk(clk), .rst(rst), .in_valid(start_valid), .in_ready(descend_queue_in_ready),
        .in_data({start_thread, 7'd1}),
        .out_valid(descend_valid), .out_ready(descend_ready), .out_data(descend_queue_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            busy <= 4'd0;
            waiting <= 4'd0;
            exhausted <= 4'd0;
            wants_pop <= 4'd0;
            wants_finish <= 4'd0;
            any_free <= 1'd1;
            start_valid <= 1'd0;
            behind_pop <= 4'd0;
            chosen_pop <= 4'd0;
            pop_shown <= 1'd0;
            behind_finish <= 4'd0;
            chosen_finish <= 4'd0;
            finish_shown <= 1'd0;
            outstanding_0 <= 1'd0;
            outstanding_1 <= 1'd0;
            outstanding_2 <= 1'd0;
            outstanding_3 <= 1'd0;
            event_thread_wait <= 1'd0;
        end else begin
            busy <= busy_next;
            waiting <= ((waiting & ~leaf_ended) | (reached_set & ~waiting_bits)) & kept;
            exhausted <= exhausted_now & kept;
            wants_pop <= wants_pop_either & kept;
            wants_finish <= wants_finish_either & kept;
            any_free <= ~(&busy_next);
            start_valid <= take;
            outstanding_0 <= outstanding_0_next;
            outstanding_1 <= outstanding_1_next;
            outstanding_2 <= outstanding_2_next;
            outstanding_3 <= outstanding_3_next;
            event_thread_wait <= query_valid & ~any_free;
            if (pop_advance & |wants_pop) behind_pop <= ~behind_pop_choice;
            if (pop_advance) begin
                chosen_pop <= first_pop;
                pop_shown <= |wants_pop;
            end
            if (finish_advance & |wants_finish) behind_finish <= ~behind_finish_choice;
            if (finish_advance) begin
                chosen_finish <= first_finish;
                finish_shown <= |wants_finish;
            end
        end
    end
    always @(posedge clk) begin
        start_thread <= {|(free & 4'd12), |(free & 4'd10)};
        start_number <= query_number;
        start_k <= query_k;
        start_radius2 <= query_radius2;
        start_x <= query_x;
        start_y <= query_y;
        start_z <= query_z;
    end

`ifdef RTL_ASSERT
    wire check_in_order = {1'd0, outstanding_3} < ({1'd0, leaf_done_set[3]} + {1'd0, skipped_set[3]});
    wire check_in_order_2 = {1'd0, outstanding_2} < ({1'd0, leaf_done_set[2]} + {1'd0, skipped_set[2]});
    wire check_in_order_3 = {1'd0, outstanding_1} < ({1'd0, leaf_done_set[1]} + {1'd0, skipped_set[1]});
    wire check_in_order_4 = {1'd0, outstanding_0} < ({1'd0, leaf_done_set[0]} + {1'd0, skipped_set[0]});
    wire [3:0] check_bits = {check_in_order, check_in_order_2, check_in_order_3, check_in_order_4};
    wire [3:0] check_bits_2 = {
        reached_set[3] & ~(outstanding_3 < 1'd1), reached_set[2] & ~(outstanding_2 < 1'd1),
        reached_set[1] & ~(outstanding_1 < 1'd1), reached_set[0] & ~(outstanding_0 < 1'd1)
    };
    wire [3:0] check_bits_3 = {
        released_set[3] & (outstanding_3 | reached_set[3]),
        released_set[2] & (outstanding_2 | reached_set[2]),
        released_set[1] & (outstanding_1 | reached_set[1]),
        released_set[0] & (outstanding_0 | reached_set[0])
    };

    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        query_radius2_in_range: assert (~query_valid | (query_radius2 < 24'h800000));
        leaves_are_reached_before_they_end: assert (~(|check_bits));
        no_more_leaves_are_under_way: assert (~(|check_bits_2));
        threads_are_released_without_leaves: assert (~(|check_bits_3));
        a_free_thread_is_told: assert (any_free == ~(&busy));
`else
        if (!(~query_valid | (query_radius2 < 24'h800000))) begin
            $display("assertion failed: query_radius2_in_range in %m"); $stop;
        end
        if (!(~(|check_bits))) begin
            $display("assertion failed: leaves_are_reached_before_they_end in %m"); $stop;
        end
        if (!(~(|check_bits_2))) begin
            $display("assertion failed: no_more_leaves_are_under_way in %m"); $stop;
        end
        if (!(~(|check_bits_3))) begin
            $display("assertion failed: threads_are_released_without_leaves in %m"); $stop;
        end
        if (!(any_free == ~(&busy))) begin
            $display("assertion failed: a_free_thread_is_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue of two in registers.
// width = 9
module stream_skid_w9 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [8:0] in_data,
    output wire out_valid, input wire out_ready, output wire [8:0] out_data
);
    reg head_filled, second_filled, room;
    reg [8:0] head, second;

    wire advance = ~head_filled | out_ready;
    wire some_item = second_filled | in_valid;
    wire not_advance_and_some_item = ~advance & some_item;

    assign in_ready = room;
    assign out_valid = head_filled;
    assign out_data = head;

    always @(posedge clk) begin
        if (rst) begin
            head_filled <= 1'd0;
            second_filled <= 1'd0;
            room <= 1'd1;
        end else begin
            if (advance) head_filled <= some_item;
            second_filled <= not_advance_and_some_item;
            room <= ~not_advance_and_some_item;
        end
    end
    always @(posedge clk) begin
        if (advance) head <= second_filled ? second : in_data;
        if (~second_filled) second <= in_data;
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        second_filled_or_room: assert (second_filled ^ room);
        second_waits_behind_head: assert (head_filled | ~second_filled);
`else
        if (!(second_filled ^ room)) begin
            $display("assertion failed: second_filled_or_room in %m"); $stop;
        end
        if (!(head_filled | ~second_filled)) begin
            $display("assertion failed: second_waits_behind_head in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Memory with registered reads, in slices that are memories of the device each.
// A word that is read while it is written is anything: with assertions, the old one inverted.
module memory_1w1r_unordered #(
    parameter WIDTH = 8,
    parameter DEPTH = 2,
    parameter SLICE = WIDTH
) (
    input  wire clk,
    input  wire write,
    input  wire [$clog2(DEPTH)-1:0] write_address,
    input  wire [WIDTH-1:0] write_data,
    input  wire read,
    input  wire [$clog2(DEPTH)-1:0] read_address,
    output wire [WIDTH-1:0] read_data
);
    genvar low;
    generate
        for (low = 0; low < WIDTH; low = low + SLICE) begin : slice
            localparam BITS = low + SLICE <= WIDTH ? SLICE : WIDTH - low;
            (* no_rw_check *)
            reg [BITS-1:0] words [0:DEPTH-1];
            reg [BITS-1:0] read_word;
            assign read_data[low +: BITS] = read_word;
            always @(posedge clk) begin
                if (write) words[write_address] <= write_data[low +: BITS];
                if (read) read_word <= words[read_address];
`ifdef RTL_ASSERT
                if (read && write && read_address == write_address) read_word <= ~words[read_address];
`endif
            end
        end
    endgenerate
endmodule

// Memory with registered reads, in slices that are memories of the device each.
// A word that is read while it is written is the old one.
module memory_1w1r #(
    parameter WIDTH = 8,
    parameter DEPTH = 2,
    parameter SLICE = WIDTH
) (
    input  wire clk,
    input  wire write,
    input  wire [$clog2(DEPTH)-1:0] write_address,
    input  wire [WIDTH-1:0] write_data,
    input  wire read,
    input  wire [$clog2(DEPTH)-1:0] read_address,
    output wire [WIDTH-1:0] read_data
);
    genvar low;
    generate
        for (low = 0; low < WIDTH; low = low + SLICE) begin : slice
            localparam BITS = low + SLICE <= WIDTH ? SLICE : WIDTH - low;
            reg [BITS-1:0] words [0:DEPTH-1];
            reg [BITS-1:0] read_word;
            assign read_data[low +: BITS] = read_word;
            always @(posedge clk) begin
                if (write) words[write_address] <= write_data[low +: BITS];
                if (read) read_word <= words[read_address];
            end
        end
    endgenerate
endmodule
