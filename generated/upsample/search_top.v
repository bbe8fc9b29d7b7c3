// The whole design is one file, named after its top.
/* verilator lint_off DECLFILENAME */

// Neighbor search: queries in, nearest neighbors out.
module search_top (
    input  wire clk, input wire rst,
    output wire lookup_valid, input wire lookup_ready,  // Requests for records of the tree.
    output wire [3:0] lookup_thread,  // Thread.
    output wire [20:0] lookup_address,  // The node, or `2^tree_depth + l` for leaf `l` of the deepest level.
    input  wire record_valid, output wire record_ready,  // Records of the tree from memory, in any order.
    input  wire [3:0] record_thread,  // Thread.
    input  wire [20:0] record_address,  // The node, or `2^tree_depth + l` for leaf `l` of the deepest level.
    input  wire [31:0] record_split,  // Where its plane cuts its dimension.
    input  wire [1:0] record_dimension,  // Its dimension.
    input  wire record_internal_leaf,  // It is a leaf.
    input  wire [21:0] record_begin,  // The first beat.
    input  wire [2:0] record_beats,  // The number of beats, at least one.
    input  wire setup_valid,  // How the neighbor cache judges its neighborhoods, not while a query is under way.
    input  wire setup_ball,  // Queries are balls, else k nearest neighbors.
    input  wire [31:0] setup_far_scale,  // Factor of the distance to the farthest neighbor.
    input  wire [31:0] setup_margin_scale,  // Factor of what is left of it.
    input  wire query_valid, output wire query_ready,  // Queries.
    input  wire [23:0] query_number,  // Its number, which its results bear.
    input  wire [5:0] query_k,  // Neighbors wanted.
    input  wire [31:0] query_radius2,  // Squared radius within which neighbors count.
    input  wire [31:0] query_x,  // Where.
    input  wire [31:0] query_y,  // Where.
    input  wire [31:0] query_z,  // Where.
    input  wire [31:0] query_reach,  // With a neighbor cache, the radius around it within which a neighborhood must be complete to cover it: 0 for k nearest neighbors, the radius of a ball query.
    output wire fetch_valid, input wire fetch_ready,  // Requests to the memory.
    output wire [3:0] fetch_thread,  // Thread.
    output wire [21:0] fetch_address,  // First beat.
    output wire [2:0] fetch_beats,  // Number of beats, at least one.
    input  wire beat_valid, output wire beat_ready,  // Points from memory: the beats of a request in order and together, requests in any order.
    input  wire [3:0] beat_thread,  // Thread.
    input  wire [21:0] beat_address,  // Address in the point memory.
    input  wire beat_last,  // Closes its leaf.
    input  wire [31:0] beat_x0,  // A point a lane; NaN where there is none.
    input  wire [31:0] beat_y0,  // A point a lane; NaN where there is none.
    input  wire [31:0] beat_z0,  // A point a lane; NaN where there is none.
    input  wire [31:0] beat_x1,  // A point a lane; NaN where there is none.
    input  wire [31:0] beat_y1,  // A point a lane; NaN where there is none.
    input  wire [31:0] beat_z1,  // A point a lane; NaN where there is none.
    input  wire [31:0] beat_x2,  // A point a lane; NaN where there is none.
    input  wire [31:0] beat_y2,  // A point a lane; NaN where there is none.
    input  wire [31:0] beat_z2,  // A point a lane; NaN where there is none.
    input  wire [31:0] beat_x3,  // A point a lane; NaN where there is none.
    input  wire [31:0] beat_y3,  // A point a lane; NaN where there is none.
    input  wire [31:0] beat_z3,  // A point a lane; NaN where there is none.
    output wire result_valid, input wire result_ready,  // Neighbors, nearest first, a query after the other.
    output wire [23:0] result_number,  // The query's number.
    output wire result_last,  // Closes the query.
    output wire result_found,  // Low for a query without any neighbor.
    output wire [23:0] result_index,  // The neighbor's place in the point memory.
    output wire [31:0] result_distance2,  // Its squared distance.
    output wire result_cached,  // With a neighbor cache, its squared distance is that to the query whose neighborhood is reused.
    output wire event_node,  // A node was visited.
    output wire event_pop,  // A path was popped.
    output wire event_beat,  // A priority queue was done with a beat of points.
    output wire event_insert,  // A neighbor was inserted.
    output wire event_insert_wait,  // A beat stayed for one more insertion.
    output wire event_thread_wait,  // A query waited for a free thread.
    output wire event_point_hit,  // The point cache had a leaf that was wanted.
    output wire event_point_miss,  // The point cache lacked a leaf that was wanted.
    output wire event_tree_hit,  // The tree cache had a record that was wanted.
    output wire event_tree_miss,  // The tree cache lacked a record that was wanted.
    output wire event_cache_hit,  // A neighborhood of the neighbor cache covered a query.
    output wire event_cache_miss  // No neighborhood of the neighbor cache covered a query.
);
    wire neighbor_cache_search_valid;
    wire [23:0] neighbor_cache_search_number;
    wire [5:0] neighbor_cache_search_k;
    wire [31:0] neighbor_cache_search_radius2, neighbor_cache_search_x, neighbor_cache_search_y;
    wire [31:0] neighbor_cache_search_z;
    wire neighbor_cache_found_ready, threads_query_ready, threads_start_valid;
    wire [3:0] threads_start_thread;
    wire [23:0] threads_start_number;
    wire [5:0] threads_start_k;
    wire [31:0] threads_start_radius2, threads_start_x, threads_start_y, threads_start_z;
    wire threads_descend_valid;
    wire [3:0] threads_descend_thread;
    wire [20:0] threads_descend_node;
    wire threads_pop_valid;
    wire [3:0] threads_pop_thread;
    wire threads_finish_valid;
    wire [3:0] threads_finish_thread;
    wire traversal_descend_ready, traversal_resume_ready, traversal_leaf_valid;
    wire [3:0] traversal_leaf_thread;
    wire [19:0] traversal_leaf_leaf;
    wire traversal_node_valid;
    wire [3:0] traversal_node_thread;
    wire [20:0] traversal_node_node;
    wire traversal_record_ready, traversal_push_valid;
    wire [3:0] traversal_push_thread;
    wire [20:0] traversal_push_node;
    wire [30:0] traversal_push_distance2;
    wire traversal_reached_valid;
    wire [3:0] traversal_reached_thread;
    wire stack_top_empty;
    wire [20:0] stack_top_node;
    wire [30:0] stack_top_distance2;
    wire recursion_in_ready, recursion_resume_valid;
    wire [3:0] recursion_resume_thread;
    wire [20:0] recursion_resume_node;
    wire recursion_pop_valid;
    wire [3:0] recursion_pop_thread;
    wire recursion_empty_valid;
    wire [3:0] recursion_empty_thread;
    wire leaf_beat_ready, leaf_candidates_valid;
    wire [3:0] leaf_candidates_thread;
    wire [21:0] leaf_candidates_address;
    wire leaf_candidates_last;
    wire [30:0] leaf_candidates_distance0, leaf_candidates_distance1, leaf_candidates_distance2;
    wire [30:0] leaf_candidates_distance3;
    wire sieve_candidates_ready, sieve_kept_valid;
    wire [3:0] sieve_kept_thread;
    wire [21:0] sieve_kept_address;
    wire sieve_kept_last;
    wire [30:0] sieve_kept_distance0, sieve_kept_distance1, sieve_kept_distance2, sieve_kept_distance3;
    wire sieve_skipped_valid;
    wire [3:0] sieve_skipped_thread;
    wire queue_candidates_ready, queue_finish_ready, queue_radius_valid;
    wire [3:0] queue_radius_thread;
    wire [30:0] queue_radius_radius2;
    wire queue_released_valid;
    wire [3:0] queue_released_thread;
    wire queue_result_valid;
    wire [23:0] queue_result_number;
    wire queue_result_last, queue_result_found;
    wire [23:0] queue_result_index;
    wire [31:0] queue_result_distance2;
    wire tree_cache_node_ready, tree_cache_leaf_ready, tree_cache_record_valid;
    wire [3:0] tree_cache_record_thread;
    wire [20:0] tree_cache_record_node;
    wire [31:0] tree_cache_record_split;
    wire [1:0] tree_cache_record_dimension;
    wire tree_cache_record_internal_leaf, tree_cache_fetch_valid;
    wire [3:0] tree_cache_fetch_thread;
    wire [21:0] tree_cache_fetch_address;
    wire [2:0] tree_cache_fetch_beats;
    wire point_cache_fetch_ready, point_cache_beat_valid;
    wire [3:0] point_cache_beat_thread;
    wire [21:0] point_cache_beat_address;
    wire point_cache_beat_last;
    wire [31:0] point_cache_beat_x0, point_cache_beat_y0, point_cache_beat_z0, point_cache_beat_x1;
    wire [31:0] point_cache_beat_y1, point_cache_beat_z1, point_cache_beat_x2, point_cache_beat_y2;
    wire [31:0] point_cache_beat_z2, point_cache_beat_x3, point_cache_beat_y3, point_cache_beat_z3;

    search_neighbor_cache neighbor_cache (
        .clk(clk), .rst(rst), .setup_valid(setup_valid), .setup_ball(setup_ball),
        .setup_far_scale(setup_far_scale), .setup_margin_scale(setup_margin_scale),
        .result_valid(result_valid), .result_ready(result_ready), .result_number(result_number),
        .result_last(result_last), .result_found(result_found), .result_index(result_index),
        .result_distance2(result_distance2), .result_cached(result_cached),
        .search_valid(neighbor_cache_search_valid), .search_ready(threads_query_ready),
        .search_number(neighbor_cache_search_number), .search_k(neighbor_cache_search_k),
        .search_radius2(neighbor_cache_search_radius2), .search_x(neighbor_cache_search_x),
        .search_y(neighbor_cache_search_y), .search_z(neighbor_cache_search_z),
        .event_cache_hit(event_cache_hit), .event_cache_miss(event_cache_miss),
        .found_valid(queue_result_valid), .found_ready(neighbor_cache_found_ready),
        .found_number(queue_result_number), .found_last(queue_result_last), .found_found(queue_result_found),
        .found_index(queue_result_index), .found_distance2(queue_result_distance2),
        .query_valid(query_valid), .query_ready(query_ready), .query_number(query_number), .query_k(query_k),
        .query_radius2(query_radius2), .query_x(query_x), .query_y(query_y), .query_z(query_z),
        .query_reach(query_reach)
    );

    search_threads threads (
        .clk(clk), .rst(rst), .query_valid(neighbor_cache_search_valid), .query_ready(threads_query_ready),
        .query_number(neighbor_cache_search_number), .query_k(neighbor_cache_search_k),
        .query_radius2(neighbor_cache_search_radius2), .query_x(neighbor_cache_search_x),
        .query_y(neighbor_cache_search_y), .query_z(neighbor_cache_search_z),
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
        .leaf_valid(traversal_leaf_valid), .leaf_ready(tree_cache_leaf_ready),
        .leaf_thread(traversal_leaf_thread), .leaf_leaf(traversal_leaf_leaf),
        .node_valid(traversal_node_valid), .node_ready(tree_cache_node_ready),
        .node_thread(traversal_node_thread), .node_node(traversal_node_node),
        .record_valid(tree_cache_record_valid), .record_ready(traversal_record_ready),
        .record_thread(tree_cache_record_thread), .record_node(tree_cache_record_node),
        .record_split(tree_cache_record_split), .record_dimension(tree_cache_record_dimension),
        .record_internal_leaf(tree_cache_record_internal_leaf),
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
        .clk(clk), .rst(rst), .start_valid(threads_start_valid), .start_thread(threads_start_thread),
        .start_number(threads_start_number), .start_k(threads_start_k), .start_radius2(threads_start_radius2),
        .start_x(threads_start_x), .start_y(threads_start_y), .start_z(threads_start_z),
        .beat_valid(point_cache_beat_valid), .beat_ready(leaf_beat_ready),
        .beat_thread(point_cache_beat_thread), .beat_address(point_cache_beat_address),
        .beat_last(point_cache_beat_last), .beat_x0(point_cache_beat_x0), .beat_y0(point_cache_beat_y0),
        .beat_z0(point_cache_beat_z0), .beat_x1(point_cache_beat_x1), .beat_y1(point_cache_beat_y1),
        .beat_z1(point_cache_beat_z1), .beat_x2(point_cache_beat_x2), .beat_y2(point_cache_beat_y2),
        .beat_z2(point_cache_beat_z2), .beat_x3(point_cache_beat_x3), .beat_y3(point_cache_beat_y3),
        .beat_z3(point_cache_beat_z3),
        .candidates_valid(leaf_candidates_valid), .candidates_ready(sieve_candidates_ready),
        .candidates_thread(leaf_candidates_thread), .candidates_address(leaf_candidates_address),
        .candidates_last(leaf_candidates_last), .candidates_distance0(leaf_candidates_distance0),
        .candidates_distance1(leaf_candidates_distance1), .candidates_distance2(leaf_candidates_distance2),
        .candidates_distance3(leaf_candidates_distance3)
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
        .candidates_distance1(leaf_candidates_distance1), .candidates_distance2(leaf_candidates_distance2),
        .candidates_distance3(leaf_candidates_distance3),
        .kept_valid(sieve_kept_valid), .kept_ready(queue_candidates_ready), .kept_thread(sieve_kept_thread),
        .kept_address(sieve_kept_address), .kept_last(sieve_kept_last), .kept_distance0(sieve_kept_distance0),
        .kept_distance1(sieve_kept_distance1), .kept_distance2(sieve_kept_distance2),
        .kept_distance3(sieve_kept_distance3),
        .skipped_valid(sieve_skipped_valid), .skipped_thread(sieve_skipped_thread)
    );

    search_queue queue (
        .clk(clk), .rst(rst), .start_valid(threads_start_valid), .start_thread(threads_start_thread),
        .start_number(threads_start_number), .start_k(threads_start_k), .start_radius2(threads_start_radius2),
        .start_x(threads_start_x), .start_y(threads_start_y), .start_z(threads_start_z),
        .candidates_valid(sieve_kept_valid), .candidates_ready(queue_candidates_ready),
        .candidates_thread(sieve_kept_thread), .candidates_address(sieve_kept_address),
        .candidates_last(sieve_kept_last), .candidates_distance0(sieve_kept_distance0),
        .candidates_distance1(sieve_kept_distance1), .candidates_distance2(sieve_kept_distance2),
        .candidates_distance3(sieve_kept_distance3),
        .finish_valid(threads_finish_valid), .finish_ready(queue_finish_ready),
        .finish_thread(threads_finish_thread),
        .radius_valid(queue_radius_valid), .radius_thread(queue_radius_thread),
        .radius_radius2(queue_radius_radius2),
        .event_insert(event_insert),
        .released_valid(queue_released_valid), .released_thread(queue_released_thread),
        .result_valid(queue_result_valid), .result_ready(neighbor_cache_found_ready),
        .result_number(queue_result_number), .result_last(queue_result_last),
        .result_found(queue_result_found), .result_index(queue_result_index),
        .result_distance2(queue_result_distance2),
        .event_beat(event_beat), .event_insert_wait(event_insert_wait)
    );

    search_tree_cache tree_cache (
        .clk(clk), .rst(rst), .node_valid(traversal_node_valid), .node_ready(tree_cache_node_ready),
        .node_thread(traversal_node_thread), .node_node(traversal_node_node),
        .leaf_valid(traversal_leaf_valid), .leaf_ready(tree_cache_leaf_ready),
        .leaf_thread(traversal_leaf_thread), .leaf_leaf(traversal_leaf_leaf),
        .record_valid(tree_cache_record_valid), .record_ready(traversal_record_ready),
        .record_thread(tree_cache_record_thread), .record_node(tree_cache_record_node),
        .record_split(tree_cache_record_split), .record_dimension(tree_cache_record_dimension),
        .record_internal_leaf(tree_cache_record_internal_leaf),
        .fetch_valid(tree_cache_fetch_valid), .fetch_ready(point_cache_fetch_ready),
        .fetch_thread(tree_cache_fetch_thread), .fetch_address(tree_cache_fetch_address),
        .fetch_beats(tree_cache_fetch_beats),
        .lookup_valid(lookup_valid), .lookup_ready(lookup_ready), .lookup_thread(lookup_thread),
        .lookup_address(lookup_address),
        .fill_valid(record_valid), .fill_ready(record_ready), .fill_thread(record_thread),
        .fill_address(record_address), .fill_split(record_split), .fill_dimension(record_dimension),
        .fill_internal_leaf(record_internal_leaf), .fill_begin(record_begin), .fill_beats(record_beats),
        .event_tree_hit(event_tree_hit), .event_tree_miss(event_tree_miss)
    );

    search_point_cache point_cache (
        .clk(clk), .rst(rst), .fetch_valid(tree_cache_fetch_valid), .fetch_ready(point_cache_fetch_ready),
        .fetch_thread(tree_cache_fetch_thread), .fetch_address(tree_cache_fetch_address),
        .fetch_beats(tree_cache_fetch_beats),
        .miss_valid(fetch_valid), .miss_ready(fetch_ready), .miss_thread(fetch_thread),
        .miss_address(fetch_address), .miss_beats(fetch_beats),
        .beat_valid(point_cache_beat_valid), .beat_ready(leaf_beat_ready),
        .beat_thread(point_cache_beat_thread), .beat_address(point_cache_beat_address),
        .beat_last(point_cache_beat_last), .beat_x0(point_cache_beat_x0), .beat_y0(point_cache_beat_y0),
        .beat_z0(point_cache_beat_z0), .beat_x1(point_cache_beat_x1), .beat_y1(point_cache_beat_y1),
        .beat_z1(point_cache_beat_z1), .beat_x2(point_cache_beat_x2), .beat_y2(point_cache_beat_y2),
        .beat_z2(point_cache_beat_z2), .beat_x3(point_cache_beat_x3), .beat_y3(point_cache_beat_y3),
        .beat_z3(point_cache_beat_z3),
        .fill_valid(beat_valid), .fill_ready(beat_ready), .fill_thread(beat_thread),
        .fill_address(beat_address), .fill_last(beat_last), .fill_x0(beat_x0), .fill_y0(beat_y0),
        .fill_z0(beat_z0), .fill_x1(beat_x1), .fill_y1(beat_y1), .fill_z1(beat_z1), .fill_x2(beat_x2),
        .fill_y2(beat_y2), .fill_z2(beat_z2), .fill_x3(beat_x3), .fill_y3(beat_y3), .fill_z3(beat_z3),
        .event_point_hit(event_point_hit), .event_point_miss(event_point_miss)
    );

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        query_radius2_in_range: assert (~query_valid | (query_radius2 < 32'h80000000));
`else
        if (!(~query_valid | (query_radius2 < 32'h80000000))) begin
            $display("assertion failed: query_radius2_in_range in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Keeps the points of leaves in front of the memory.
// slots = 64
// slot_beats = 4
module search_point_cache (
    input  wire clk, input wire rst,
    input  wire fetch_valid, output wire fetch_ready,  // Leaves wanted.
    input  wire [3:0] fetch_thread,  // Thread.
    input  wire [21:0] fetch_address,  // First beat.
    input  wire [2:0] fetch_beats,  // Number of beats, at least one.
    output wire miss_valid, input wire miss_ready,  // Requests to the memory.
    output wire [3:0] miss_thread,  // Thread.
    output wire [21:0] miss_address,  // First beat.
    output wire [2:0] miss_beats,  // Number of beats, at least one.
    output wire beat_valid, input wire beat_ready,  // Their points.
    output wire [3:0] beat_thread,  // Thread.
    output wire [21:0] beat_address,  // Address in the point memory.
    output wire beat_last,  // Closes its leaf.
    output wire [31:0] beat_x0,  // A point a lane; NaN where there is none.
    output wire [31:0] beat_y0,  // A point a lane; NaN where there is none.
    output wire [31:0] beat_z0,  // A point a lane; NaN where there is none.
    output wire [31:0] beat_x1,  // A point a lane; NaN where there is none.
    output wire [31:0] beat_y1,  // A point a lane; NaN where there is none.
    output wire [31:0] beat_z1,  // A point a lane; NaN where there is none.
    output wire [31:0] beat_x2,  // A point a lane; NaN where there is none.
    output wire [31:0] beat_y2,  // A point a lane; NaN where there is none.
    output wire [31:0] beat_z2,  // A point a lane; NaN where there is none.
    output wire [31:0] beat_x3,  // A point a lane; NaN where there is none.
    output wire [31:0] beat_y3,  // A point a lane; NaN where there is none.
    output wire [31:0] beat_z3,  // A point a lane; NaN where there is none.
    input  wire fill_valid, output wire fill_ready,  // Points from memory.
    input  wire [3:0] fill_thread,  // Thread.
    input  wire [21:0] fill_address,  // Address in the point memory.
    input  wire fill_last,  // Closes its leaf.
    input  wire [31:0] fill_x0,  // A point a lane; NaN where there is none.
    input  wire [31:0] fill_y0,  // A point a lane; NaN where there is none.
    input  wire [31:0] fill_z0,  // A point a lane; NaN where there is none.
    input  wire [31:0] fill_x1,  // A point a lane; NaN where there is none.
    input  wire [31:0] fill_y1,  // A point a lane; NaN where there is none.
    input  wire [31:0] fill_z1,  // A point a lane; NaN where there is none.
    input  wire [31:0] fill_x2,  // A point a lane; NaN where there is none.
    input  wire [31:0] fill_y2,  // A point a lane; NaN where there is none.
    input  wire [31:0] fill_z2,  // A point a lane; NaN where there is none.
    input  wire [31:0] fill_x3,  // A point a lane; NaN where there is none.
    input  wire [31:0] fill_y3,  // A point a lane; NaN where there is none.
    input  wire [31:0] fill_z3,  // A point a lane; NaN where there is none.
    output reg  event_point_hit,  // The point cache had a leaf that was wanted.
    output reg  event_point_miss  // The point cache lacked a leaf that was wanted.
);
    (* ram_style = "distributed" *)
    reg [21:0] tags [0:63];
    reg fill_under_way, fill_between;
    reg [5:0] fill_slot_before;
    reg [2:0] fill_count;
    reg fill_kept_before, l_valid;
    reg [3:0] l_thread;  // Thread.
    reg [21:0] l_address;  // First beat.
    reg [2:0] l_beats;  // Number of beats, at least one.
    reg [5:0] l_slot;  // The slot.
    reg run_valid;
    reg [3:0] run_thread;  // Thread.
    reg [21:0] run_address;  // First beat.
    reg [2:0] run_beats;  // Number of beats, at least one.
    reg [5:0] run_slot;  // The slot.
    reg run_empty, stores;
    reg [7:0] stored_at;
    reg [383:0] stored_points;
    reg began, complete;
    reg [5:0] changed_slot;
    reg [63:0] present;
    reg [2:0] l_same;
    reg l_present;
    reg [2:0] run_count;
    wire [383:0] read;
    reg r_valid, r_empty, s_valid, s_empty, r_read;
    reg [3:0] r_thread;  // Thread.
    reg [21:0] r_address;  // Address in the point memory.
    reg r_last;  // Closes its leaf.
    reg [31:0] r_x0;  // A point a lane; NaN where there is none.
    reg [31:0] r_y0;  // A point a lane; NaN where there is none.
    reg [31:0] r_z0;  // A point a lane; NaN where there is none.
    reg [31:0] r_x1;  // A point a lane; NaN where there is none.
    reg [31:0] r_y1;  // A point a lane; NaN where there is none.
    reg [31:0] r_z1;  // A point a lane; NaN where there is none.
    reg [31:0] r_x2;  // A point a lane; NaN where there is none.
    reg [31:0] r_y2;  // A point a lane; NaN where there is none.
    reg [31:0] r_z2;  // A point a lane; NaN where there is none.
    reg [31:0] r_x3;  // A point a lane; NaN where there is none.
    reg [31:0] r_y3;  // A point a lane; NaN where there is none.
    reg [31:0] r_z3;  // A point a lane; NaN where there is none.
    reg [3:0] s_thread;  // Thread.
    reg [21:0] s_address;  // Address in the point memory.
    reg s_last;  // Closes its leaf.
    reg [31:0] s_x0;  // A point a lane; NaN where there is none.
    reg [31:0] s_y0;  // A point a lane; NaN where there is none.
    reg [31:0] s_z0;  // A point a lane; NaN where there is none.
    reg [31:0] s_x1;  // A point a lane; NaN where there is none.
    reg [31:0] s_y1;  // A point a lane; NaN where there is none.
    reg [31:0] s_z1;  // A point a lane; NaN where there is none.
    reg [31:0] s_x2;  // A point a lane; NaN where there is none.
    reg [31:0] s_y2;  // A point a lane; NaN where there is none.
    reg [31:0] s_z2;  // A point a lane; NaN where there is none.
    reg [31:0] s_x3;  // A point a lane; NaN where there is none.
    reg [31:0] s_y3;  // A point a lane; NaN where there is none.
    reg [31:0] s_z3;  // A point a lane; NaN where there is none.

    wire fetch_queue_out_valid;
    wire [34:0] fetch_queue_out_data;
    wire miss_queue_in_ready;
    wire [28:0] miss_queue_out_data;
    wire beat_queue_in_ready;
    wire [410:0] beat_queue_out_data;
    wire fill_queue_out_valid;
    wire [416:0] fill_queue_out_data;

    wire s_empty_or_beat_queue_in_ready = s_empty | beat_queue_in_ready;
    wire flows = r_empty | s_empty_or_beat_queue_in_ready;
    wire runs = run_valid & fill_between;
    wire run_step = flows & runs;
    wire [5:0] fetch_queue_in_data_unequal = fetch_address[5:0] ^ fetch_address[11:6] ^ fetch_address[17:12] ^ {2'd0, fetch_address[21:18]};
    wire hit = l_present & &l_same;
    wire hits = l_valid & (hit & ~run_valid);
    wire misses = l_valid & (~hit & miss_queue_in_ready);
    wire advance_l = ~l_valid | (hits | misses);
    wire advance_s = ~s_valid | beat_queue_in_ready;
    wire [5:0] fill_queue_in_data_unequal = fill_address[5:0] ^ fill_address[11:6] ^ fill_address[17:12] ^ {2'd0, fill_address[21:18]};
    wire comes = flows & (run_empty | fill_under_way);
    wire fill_taken = fill_queue_out_valid & comes;
    wire fill_queue_out_last = fill_queue_out_data[390];
    wire fill_under_way_choice = fill_taken ? ~fill_queue_out_last : fill_under_way;
    wire [5:0] fill_queue_out_slot = fill_queue_out_data[5:0];
    wire [5:0] fill_slot = fill_under_way ? fill_slot_before : fill_queue_out_slot;
    wire [5:0] fetch_queue_out_slot = fetch_queue_out_data[5:0];
    wire may_keep_both = fetch_queue_out_valid & (fetch_queue_out_slot == fill_queue_out_slot);
    wire may_keep = ~((l_valid & (l_slot == fill_queue_out_slot)) | may_keep_both);
    wire fill_kept = fill_under_way ? fill_kept_before : may_keep;
    wire [3:0] fetch_queue_out_thread = fetch_queue_out_data[34:31];
    wire [21:0] fetch_queue_out_address = fetch_queue_out_data[30:9];
    wire [2:0] fetch_queue_out_beats = fetch_queue_out_data[8:6];
    wire [2:0] run_count_plus_1 = run_count + 3'd1;
    wire run_last = run_count_plus_1 == run_beats;
    wire run_valid_either = hits | (run_valid & ~(run_step & run_last));
    wire store = fill_taken & fill_kept;
    wire store_and_not_fill_under_way = store & ~fill_under_way;
    wire changed_slot_5_3_is_7 = changed_slot[5:3] == 3'd7;
    wire present_both = began & changed_slot_5_3_is_7;
    wire changed_slot_2_0_is_7 = changed_slot[2:0] == 3'd7;
    wire changed_slot_2_0_is_6 = changed_slot[2:0] == 3'd6;
    wire changed_slot_2_0_is_5 = changed_slot[2:0] == 3'd5;
    wire changed_slot_2_0_is_4 = changed_slot[2:0] == 3'd4;
    wire changed_slot_2_0_is_3 = changed_slot[2:0] == 3'd3;
    wire changed_slot_2_0_is_2 = changed_slot[2:0] == 3'd2;
    wire changed_slot_2_0_is_1 = changed_slot[2:0] == 3'd1;
    wire changed_slot_2_0_is_0 = changed_slot[2:0] == 3'd0;
    wire changed_slot_5_3_is_6 = changed_slot[5:3] == 3'd6;
    wire present_both_2 = began & changed_slot_5_3_is_6;
    wire changed_slot_5_3_is_5 = changed_slot[5:3] == 3'd5;
    wire present_both_3 = began & changed_slot_5_3_is_5;
    wire changed_slot_5_3_is_4 = changed_slot[5:3] == 3'd4;
    wire present_both_4 = began & changed_slot_5_3_is_4;
    wire changed_slot_5_3_is_3 = changed_slot[5:3] == 3'd3;
    wire present_both_5 = began & changed_slot_5_3_is_3;
    wire changed_slot_5_3_is_2 = changed_slot[5:3] == 3'd2;
    wire present_both_6 = began & changed_slot_5_3_is_2;
    wire changed_slot_5_3_is_1 = changed_slot[5:3] == 3'd1;
    wire present_both_7 = began & changed_slot_5_3_is_1;
    wire changed_slot_5_3_is_0 = changed_slot[5:3] == 3'd0;
    wire present_both_8 = began & changed_slot_5_3_is_0;
    wire [63:0] present_bits = {
        present_both & changed_slot_2_0_is_7, present_both & changed_slot_2_0_is_6,
        present_both & changed_slot_2_0_is_5, present_both & changed_slot_2_0_is_4,
        present_both & changed_slot_2_0_is_3, present_both & changed_slot_2_0_is_2,
        present_both & changed_slot_2_0_is_1, present_both & changed_slot_2_0_is_0,
        present_both_2 & changed_slot_2_0_is_7, present_both_2 & changed_slot_2_0_is_6,
        present_both_2 & changed_slot_2_0_is_5, present_both_2 & changed_slot_2_0_is_4,
        present_both_2 & changed_slot_2_0_is_3, present_both_2 & changed_slot_2_0_is_2,
        present_both_2 & changed_slot_2_0_is_1, present_both_2 & changed_slot_2_0_is_0,
        present_both_3 & changed_slot_2_0_is_7, present_both_3 & changed_slot_2_0_is_6,
        present_both_3 & changed_slot_2_0_is_5, present_both_3 & changed_slot_2_0_is_4,
        present_both_3 & changed_slot_2_0_is_3, present_both_3 & changed_slot_2_0_is_2,
        present_both_3 & changed_slot_2_0_is_1, present_both_3 & changed_slot_2_0_is_0,
        present_both_4 & changed_slot_2_0_is_7, present_both_4 & changed_slot_2_0_is_6,
        present_both_4 & changed_slot_2_0_is_5, present_both_4 & changed_slot_2_0_is_4,
        present_both_4 & changed_slot_2_0_is_3, present_both_4 & changed_slot_2_0_is_2,
        present_both_4 & changed_slot_2_0_is_1, present_both_4 & changed_slot_2_0_is_0,
        present_both_5 & changed_slot_2_0_is_7, present_both_5 & changed_slot_2_0_is_6,
        present_both_5 & changed_slot_2_0_is_5, present_both_5 & changed_slot_2_0_is_4,
        present_both_5 & changed_slot_2_0_is_3, present_both_5 & changed_slot_2_0_is_2,
        present_both_5 & changed_slot_2_0_is_1, present_both_5 & changed_slot_2_0_is_0,
        present_both_6 & changed_slot_2_0_is_7, present_both_6 & changed_slot_2_0_is_6,
        present_both_6 & changed_slot_2_0_is_5, present_both_6 & changed_slot_2_0_is_4,
        present_both_6 & changed_slot_2_0_is_3, present_both_6 & changed_slot_2_0_is_2,
        present_both_6 & changed_slot_2_0_is_1, present_both_6 & changed_slot_2_0_is_0,
        present_both_7 & changed_slot_2_0_is_7, present_both_7 & changed_slot_2_0_is_6,
        present_both_7 & changed_slot_2_0_is_5, present_both_7 & changed_slot_2_0_is_4,
        present_both_7 & changed_slot_2_0_is_3, present_both_7 & changed_slot_2_0_is_2,
        present_both_7 & changed_slot_2_0_is_1, present_both_7 & changed_slot_2_0_is_0,
        present_both_8 & changed_slot_2_0_is_7, present_both_8 & changed_slot_2_0_is_6,
        present_both_8 & changed_slot_2_0_is_5, present_both_8 & changed_slot_2_0_is_4,
        present_both_8 & changed_slot_2_0_is_3, present_both_8 & changed_slot_2_0_is_2,
        present_both_8 & changed_slot_2_0_is_1, present_both_8 & changed_slot_2_0_is_0
    };
    wire present_both_9 = complete & changed_slot_5_3_is_7;
    wire present_both_10 = complete & changed_slot_5_3_is_6;
    wire present_both_11 = complete & changed_slot_5_3_is_5;
    wire present_both_12 = complete & changed_slot_5_3_is_4;
    wire present_both_13 = complete & changed_slot_5_3_is_3;
    wire present_both_14 = complete & changed_slot_5_3_is_2;
    wire present_both_15 = complete & changed_slot_5_3_is_1;
    wire present_both_16 = complete & changed_slot_5_3_is_0;
    wire [63:0] present_bits_2 = {
        present_both_9 & changed_slot_2_0_is_7, present_both_9 & changed_slot_2_0_is_6,
        present_both_9 & changed_slot_2_0_is_5, present_both_9 & changed_slot_2_0_is_4,
        present_both_9 & changed_slot_2_0_is_3, present_both_9 & changed_slot_2_0_is_2,
        present_both_9 & changed_slot_2_0_is_1, present_both_9 & changed_slot_2_0_is_0,
        present_both_10 & changed_slot_2_0_is_7, present_both_10 & changed_slot_2_0_is_6,
        present_both_10 & changed_slot_2_0_is_5, present_both_10 & changed_slot_2_0_is_4,
        present_both_10 & changed_slot_2_0_is_3, present_both_10 & changed_slot_2_0_is_2,
        present_both_10 & changed_slot_2_0_is_1, present_both_10 & changed_slot_2_0_is_0,
        present_both_11 & changed_slot_2_0_is_7, present_both_11 & changed_slot_2_0_is_6,
        present_both_11 & changed_slot_2_0_is_5, present_both_11 & changed_slot_2_0_is_4,
        present_both_11 & changed_slot_2_0_is_3, present_both_11 & changed_slot_2_0_is_2,
        present_both_11 & changed_slot_2_0_is_1, present_both_11 & changed_slot_2_0_is_0,
        present_both_12 & changed_slot_2_0_is_7, present_both_12 & changed_slot_2_0_is_6,
        present_both_12 & changed_slot_2_0_is_5, present_both_12 & changed_slot_2_0_is_4,
        present_both_12 & changed_slot_2_0_is_3, present_both_12 & changed_slot_2_0_is_2,
        present_both_12 & changed_slot_2_0_is_1, present_both_12 & changed_slot_2_0_is_0,
        present_both_13 & changed_slot_2_0_is_7, present_both_13 & changed_slot_2_0_is_6,
        present_both_13 & changed_slot_2_0_is_5, present_both_13 & changed_slot_2_0_is_4,
        present_both_13 & changed_slot_2_0_is_3, present_both_13 & changed_slot_2_0_is_2,
        present_both_13 & changed_slot_2_0_is_1, present_both_13 & changed_slot_2_0_is_0,
        present_both_14 & changed_slot_2_0_is_7, present_both_14 & changed_slot_2_0_is_6,
        present_both_14 & changed_slot_2_0_is_5, present_both_14 & changed_slot_2_0_is_4,
        present_both_14 & changed_slot_2_0_is_3, present_both_14 & changed_slot_2_0_is_2,
        present_both_14 & changed_slot_2_0_is_1, present_both_14 & changed_slot_2_0_is_0,
        present_both_15 & changed_slot_2_0_is_7, present_both_15 & changed_slot_2_0_is_6,
        present_both_15 & changed_slot_2_0_is_5, present_both_15 & changed_slot_2_0_is_4,
        present_both_15 & changed_slot_2_0_is_3, present_both_15 & changed_slot_2_0_is_2,
        present_both_15 & changed_slot_2_0_is_1, present_both_15 & changed_slot_2_0_is_0,
        present_both_16 & changed_slot_2_0_is_7, present_both_16 & changed_slot_2_0_is_6,
        present_both_16 & changed_slot_2_0_is_5, present_both_16 & changed_slot_2_0_is_4,
        present_both_16 & changed_slot_2_0_is_3, present_both_16 & changed_slot_2_0_is_2,
        present_both_16 & changed_slot_2_0_is_1, present_both_16 & changed_slot_2_0_is_0
    };
    wire [21:0] tag = tags[fetch_queue_out_slot];
    wire [63:0] l_present_shifted = present >> fetch_queue_out_slot;
    wire l_present_same = changed_slot == fetch_queue_out_slot;
    wire l_present_either = (l_present_shifted[0] & ~(began & l_present_same)) | (complete & l_present_same);
    wire changed_slot_is_l_slot = changed_slot == l_slot;
    wire l_present_both = complete & changed_slot_is_l_slot;
    wire advance_r = ~r_valid | s_empty_or_beat_queue_in_ready;
    wire r_valid_choice = advance_r ? (runs | fill_queue_out_valid) : r_valid;
    wire s_valid_choice = advance_s ? r_valid : s_valid;
    wire [3:0] fill_queue_out_thread = fill_queue_out_data[416:413];
    wire [21:0] fill_queue_out_address = fill_queue_out_data[412:391];
    wire [31:0] fill_queue_out_x0 = fill_queue_out_data[389:358];
    wire [31:0] fill_queue_out_y0 = fill_queue_out_data[357:326];
    wire [31:0] fill_queue_out_z0 = fill_queue_out_data[325:294];
    wire [31:0] fill_queue_out_x1 = fill_queue_out_data[293:262];
    wire [31:0] fill_queue_out_y1 = fill_queue_out_data[261:230];
    wire [31:0] fill_queue_out_z1 = fill_queue_out_data[229:198];
    wire [31:0] fill_queue_out_x2 = fill_queue_out_data[197:166];
    wire [31:0] fill_queue_out_y2 = fill_queue_out_data[165:134];
    wire [31:0] fill_queue_out_z2 = fill_queue_out_data[133:102];
    wire [31:0] fill_queue_out_x3 = fill_queue_out_data[101:70];
    wire [31:0] fill_queue_out_y3 = fill_queue_out_data[69:38];
    wire [31:0] fill_queue_out_z3 = fill_queue_out_data[37:6];

    assign {miss_thread, miss_address, miss_beats} = miss_queue_out_data;
    assign {
        beat_thread, beat_address, beat_last, beat_x0, beat_y0, beat_z0, beat_x1, beat_y1, beat_z1, beat_x2,
        beat_y2, beat_z2, beat_x3, beat_y3, beat_z3
    } = beat_queue_out_data;

    memory_1w1r_unordered #(.WIDTH(384), .DEPTH(256)) points (
        .clk(clk), .write(stores), .write_address(stored_at), .write_data(stored_points),
        .read(run_step), .read_address({run_slot, run_count[1:0]}), .read_data(read)
    );

    stream_skid_w35 fetch_queue (
        .clk(clk), .rst(rst), .in_valid(fetch_valid), .in_ready(fetch_ready),
        .in_data({fetch_thread, fetch_address, fetch_beats, fetch_queue_in_data_unequal}),
        .out_valid(fetch_queue_out_valid), .out_ready(advance_l), .out_data(fetch_queue_out_data)
    );

    stream_skid_w29 miss_queue (
        .clk(clk), .rst(rst), .in_valid(misses), .in_ready(miss_queue_in_ready),
        .in_data({l_thread, l_address, l_beats}),
        .out_valid(miss_valid), .out_ready(miss_ready), .out_data(miss_queue_out_data)
    );

    stream_skid_w411 beat_queue (
        .clk(clk), .rst(rst), .in_valid(s_valid & advance_s), .in_ready(beat_queue_in_ready),
        .in_data({
            s_thread, s_address, s_last, s_x0, s_y0, s_z0, s_x1, s_y1, s_z1, s_x2, s_y2, s_z2, s_x3, s_y3, s_z3
        }),
        .out_valid(beat_valid), .out_ready(beat_ready), .out_data(beat_queue_out_data)
    );

    stream_skid_w417 fill_queue (
        .clk(clk), .rst(rst), .in_valid(fill_valid), .in_ready(fill_ready),
        .in_data({
            fill_thread, fill_address, fill_last, fill_x0, fill_y0, fill_z0, fill_x1, fill_y1, fill_z1, fill_x2,
            fill_y2, fill_z2, fill_x3, fill_y3, fill_z3, fill_queue_in_data_unequal
        }),
        .out_valid(fill_queue_out_valid), .out_ready(comes), .out_data(fill_queue_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            fill_under_way <= 1'd0;
            fill_between <= 1'd1;
            fill_count <= 3'd0;
            l_valid <= 1'd0;
            run_valid <= 1'd0;
            run_empty <= 1'd1;
            stores <= 1'd0;
            began <= 1'd0;
            complete <= 1'd0;
            present <= 64'd0;
            run_count <= 3'd0;
            r_valid <= 1'd0;
            r_empty <= 1'd1;
            s_valid <= 1'd0;
            s_empty <= 1'd1;
            event_point_hit <= 1'd0;
            event_point_miss <= 1'd0;
        end else begin
            fill_under_way <= fill_under_way_choice;
            fill_between <= ~fill_under_way_choice;
            run_valid <= run_valid_either;
            run_empty <= ~run_valid_either;
            stores <= store;
            began <= store_and_not_fill_under_way;
            complete <= store & fill_queue_out_last;
            present <= (present & ~present_bits) | present_bits_2;
            r_valid <= r_valid_choice;
            r_empty <= ~r_valid_choice;
            s_valid <= s_valid_choice;
            s_empty <= ~s_valid_choice;
            event_point_hit <= hits;
            event_point_miss <= misses;
            if (fill_taken) fill_count <= fill_queue_out_last ? 3'd0 : (fill_count + 3'd1);
            if (advance_l) l_valid <= fetch_queue_out_valid;
            if (run_step) run_count <= run_last ? 3'd0 : run_count_plus_1;
        end
    end
    always @(posedge clk) begin
        fill_slot_before <= fill_slot;
        stored_at <= {fill_slot, fill_count[1:0]};
        stored_points <= fill_queue_out_data[389:6];
        changed_slot <= fill_slot;
        l_present <= advance_l ? l_present_either : (l_present | l_present_both);
        if (fill_taken) fill_kept_before <= fill_kept;
        if (advance_l) begin
            l_thread <= fetch_queue_out_thread;
            l_address <= fetch_queue_out_address;
            l_beats <= fetch_queue_out_beats;
            l_slot <= fetch_queue_out_slot;
            l_same <= {
                tag[21:16] == fetch_queue_out_address[21:16], tag[15:8] == fetch_queue_out_address[15:8],
                tag[7:0] == fetch_queue_out_address[7:0]
            };
        end
        if (hits) begin
            run_thread <= l_thread;
            run_address <= l_address;
            run_beats <= l_beats;
            run_slot <= l_slot;
        end
        if (advance_r) begin
            r_read <= runs;
            r_thread <= runs ? run_thread : fill_queue_out_thread;
            r_address <= runs ? (run_address + {19'd0, run_count}) : fill_queue_out_address;
            r_last <= runs ? run_last : fill_queue_out_last;
            r_x0 <= fill_queue_out_x0;
            r_y0 <= fill_queue_out_y0;
            r_z0 <= fill_queue_out_z0;
            r_x1 <= fill_queue_out_x1;
            r_y1 <= fill_queue_out_y1;
            r_z1 <= fill_queue_out_z1;
            r_x2 <= fill_queue_out_x2;
            r_y2 <= fill_queue_out_y2;
            r_z2 <= fill_queue_out_z2;
            r_x3 <= fill_queue_out_x3;
            r_y3 <= fill_queue_out_y3;
            r_z3 <= fill_queue_out_z3;
        end
        if (advance_s) begin
            s_thread <= r_thread;
            s_address <= r_address;
            s_last <= r_last;
            s_x0 <= r_read ? read[383:352] : r_x0;
            s_y0 <= r_read ? read[351:320] : r_y0;
            s_z0 <= r_read ? read[319:288] : r_z0;
            s_x1 <= r_read ? read[287:256] : r_x1;
            s_y1 <= r_read ? read[255:224] : r_y1;
            s_z1 <= r_read ? read[223:192] : r_z1;
            s_x2 <= r_read ? read[191:160] : r_x2;
            s_y2 <= r_read ? read[159:128] : r_y2;
            s_z2 <= r_read ? read[127:96] : r_z2;
            s_x3 <= r_read ? read[95:64] : r_x3;
            s_y3 <= r_read ? read[63:32] : r_y3;
            s_z3 <= r_read ? read[31:0] : r_z3;
        end
    end
    always @(posedge clk) if (store_and_not_fill_under_way) tags[fill_slot] <= fill_queue_out_address;

    wire _unused = &{1'b0, l_present_shifted[63:1]};

`ifdef RTL_ASSERT
    wire [63:0] present_shifted_by_run_slot = present >> run_slot;
    wire changed_slot_is_run_slot = changed_slot == run_slot;
    wire check_both = present_shifted_by_run_slot[0] & ~(began & changed_slot_is_run_slot);
    wire [63:0] present_shifted_by_l_slot = present >> l_slot;
    wire check_either = (present_shifted_by_l_slot[0] & ~(began & changed_slot_is_l_slot)) | l_present_both;

    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        fill_under_way_or_between: assert (fill_under_way ^ fill_between);
        run_valid_or_empty: assert (run_valid ^ run_empty);
        r_valid_or_empty: assert (r_valid ^ r_empty);
        s_valid_or_empty: assert (s_valid ^ s_empty);
        what_is_read_is_there: assert (~run_valid | (check_both | (complete & changed_slot_is_run_slot)));
        what_is_looked_up_is_known: assert (~(l_valid & l_present) | check_either);
`else
        if (!(fill_under_way ^ fill_between)) begin
            $display("assertion failed: fill_under_way_or_between in %m"); $stop;
        end
        if (!(run_valid ^ run_empty)) begin
            $display("assertion failed: run_valid_or_empty in %m"); $stop;
        end
        if (!(r_valid ^ r_empty)) begin $display("assertion failed: r_valid_or_empty in %m"); $stop; end
        if (!(s_valid ^ s_empty)) begin $display("assertion failed: s_valid_or_empty in %m"); $stop; end
        if (!(~run_valid | (check_both | (complete & changed_slot_is_run_slot)))) begin
            $display("assertion failed: what_is_read_is_there in %m"); $stop;
        end
        if (!(~(l_valid & l_present) | check_either)) begin
            $display("assertion failed: what_is_looked_up_is_known in %m"); $stop;
        end
`endif
    end

    wire _unused_by_checks = &{1'b0, present_shifted_by_l_slot[63:1], present_shifted_by_run_slot[63:1]};
`endif
endmodule

// Queue of two in registers.
// width = 417
module stream_skid_w417 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [416:0] in_data,
    output wire out_valid, input wire out_ready, output wire [416:0] out_data
);
    reg head_filled, second_filled, room;
    reg [416:0] head, second;

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
// width = 35
module stream_skid_w35 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [34:0] in_data,
    output wire out_valid, input wire out_ready, output wire [34:0] out_data
);
    reg head_filled, second_filled, room;
    reg [34:0] head, second;

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

// Keeps records of a tree in external memory.
// lines = 512
// threads = 16
module search_tree_cache (
    input  wire clk, input wire rst,
    input  wire node_valid, output wire node_ready,  // Nodes that the traversal has come to.
    input  wire [3:0] node_thread,  // Thread.
    input  wire [20:0] node_node,  // Node: 1 is the root, `2i` and `2i + 1` are the children of `i`.
    input  wire leaf_valid, output wire leaf_ready,  // Leaves reached.
    input  wire [3:0] leaf_thread,  // Thread.
    input  wire [19:0] leaf_leaf,  // The leaf's number among those of the deepest level (eq. 6.7).
    output wire record_valid, input wire record_ready,  // Nodes for the traversal.
    output wire [3:0] record_thread,  // Thread.
    output wire [20:0] record_node,  // Node: 1 is the root, `2i` and `2i + 1` are the children of `i`.
    output wire [31:0] record_split,  // Where its plane cuts its dimension.
    output wire [1:0] record_dimension,  // Its dimension.
    output wire record_internal_leaf,  // It is a leaf.
    output wire fetch_valid, input wire fetch_ready,  // Requests for the points of leaves.
    output wire [3:0] fetch_thread,  // Thread.
    output wire [21:0] fetch_address,  // First beat.
    output wire [2:0] fetch_beats,  // Number of beats, at least one.
    output wire lookup_valid, input wire lookup_ready,  // Requests to the memory.
    output wire [3:0] lookup_thread,  // Thread.
    output wire [20:0] lookup_address,  // The node, or `2^tree_depth + l` for leaf `l` of the deepest level.
    input  wire fill_valid, output wire fill_ready,  // Records from memory, in any order.
    input  wire [3:0] fill_thread,  // Thread.
    input  wire [20:0] fill_address,  // The node, or `2^tree_depth + l` for leaf `l` of the deepest level.
    input  wire [31:0] fill_split,  // Where its plane cuts its dimension.
    input  wire [1:0] fill_dimension,  // Its dimension.
    input  wire fill_internal_leaf,  // It is a leaf.
    input  wire [21:0] fill_begin,  // The first beat.
    input  wire [2:0] fill_beats,  // The number of beats, at least one.
    output reg  event_tree_hit,  // The tree cache had a record that was wanted.
    output reg  event_tree_miss  // The tree cache lacked a record that was wanted.
);
    reg [9:0] cleared_lines;
    reg b_valid, c_valid;
    reg [3:0] b_thread;  // Thread.
    reg [20:0] b_address;  // The node, or `2^tree_depth + l` for leaf `l` of the deepest level.
    reg [3:0] c_thread;  // Thread.
    reg [20:0] c_address;  // The node, or `2^tree_depth + l` for leaf `l` of the deepest level.
    reg b_is_leaf, c_is_leaf;
    wire [47:0] b_line;
    reg line_valid;  // It holds a record.
    reg [11:0] line_tag;  // What tells its record from others of the line.
    reg [34:0] line_word;  // What a node or a leaf holds.

    wire node_queue_out_valid;
    wire [24:0] node_queue_out_data;
    wire leaf_queue_out_valid;
    wire [23:0] leaf_queue_out_data;
    wire record_queue_in_ready;
    wire [59:0] record_queue_out_data;
    wire fetch_queue_in_ready;
    wire [28:0] fetch_queue_out_data;
    wire lookup_queue_in_ready;
    wire [24:0] lookup_queue_out_data;
    wire fill_queue_out_valid;
    wire [84:0] fill_queue_out_data;

    wire cleared = cleared_lines[9];
    wire [20:0] fill_queue_out_address = fill_queue_out_data[80:60];
    wire fill_queue_out_ready_choice = fill_queue_out_address[20] ? fetch_queue_in_ready : record_queue_in_ready;
    wire fill_queue_out_ready = cleared & fill_queue_out_ready_choice;
    wire fills = fill_queue_out_valid & fill_queue_out_ready;
    wire [34:0] lines_data_choice = fill_queue_out_address[20] ? {10'd0, fill_queue_out_data[24:0]} : fill_queue_out_data[59:25];
    wire deepest = c_address[20] & ~c_is_leaf;
    wire hit = deepest | (line_valid & (line_tag == c_address[20:9]));
    wire fills_fetch = fills & fill_queue_out_address[20];
    wire fills_record = fills & ~fill_queue_out_address[20];
    wire hits_choice = c_is_leaf ? (fetch_queue_in_ready & ~fills_fetch) : (record_queue_in_ready & ~fills_record);
    wire hits = c_valid & (hit & hits_choice);
    wire misses = c_valid & (~hit & lookup_queue_in_ready);
    wire advance = ~c_valid | (hits | misses);
    wire [19:0] leaf_queue_out_leaf = leaf_queue_out_data[19:0];
    wire [20:0] node_queue_out_node = node_queue_out_data[20:0];
    wire [20:0] b_address_choice = leaf_queue_out_valid ? {1'd1, leaf_queue_out_leaf} : node_queue_out_node;
    wire node_queue_out_ready = advance & (cleared & ~leaf_queue_out_valid);
    wire leaf_queue_out_ready = advance & cleared;
    wire [3:0] fill_queue_out_thread = fill_queue_out_data[84:81];
    wire [31:0] fill_queue_out_split = fill_queue_out_data[59:28];
    wire [31:0] record_queue_in_data_choice = fills_record ? fill_queue_out_split : deepest ? 32'd0 : line_word[34:3];
    wire [1:0] fill_queue_out_dimension = fill_queue_out_data[27:26];
    wire [1:0] record_queue_in_data_choice_2 = fills_record ? fill_queue_out_dimension : deepest ? 2'd0 : line_word[2:1];
    wire fill_queue_out_internal_leaf = fill_queue_out_data[25];
    wire record_queue_in_data_choice_3 = fills_record ? fill_queue_out_internal_leaf : deepest ? 1'd0 : line_word[0];
    wire [21:0] fill_queue_out_begin = fill_queue_out_data[24:3];
    wire [2:0] fill_queue_out_beats = fill_queue_out_data[2:0];
    wire [3:0] leaf_queue_out_thread = leaf_queue_out_data[23:20];
    wire [3:0] node_queue_out_thread = node_queue_out_data[24:21];

    assign {record_thread, record_node, record_split, record_dimension, record_internal_leaf} = record_queue_out_data;
    assign {fetch_thread, fetch_address, fetch_beats} = fetch_queue_out_data;
    assign {lookup_thread, lookup_address} = lookup_queue_out_data;

    memory_1w1r #(.WIDTH(48), .DEPTH(512)) lines (
        .clk(clk), .write(fills | ~cleared),
        .write_address(cleared ? fill_queue_out_address[8:0] : cleared_lines[8:0]),
        .write_data({cleared, cleared ? fill_queue_out_address[20:9] : 12'd0, cleared ? lines_data_choice : 35'd0}),
        .read(advance), .read_address(b_address_choice[8:0]), .read_data(b_line)
    );

    stream_fifo_d16_w25 node_queue (
        .clk(clk), .rst(rst), .in_valid(node_valid), .in_ready(node_ready),
        .in_data({node_thread, node_node}),
        .out_valid(node_queue_out_valid), .out_ready(node_queue_out_ready), .out_data(node_queue_out_data)
    );

    stream_fifo_d32_w24 leaf_queue (
        .clk(clk), .rst(rst), .in_valid(leaf_valid), .in_ready(leaf_ready),
        .in_data({leaf_thread, leaf_leaf}),
        .out_valid(leaf_queue_out_valid), .out_ready(leaf_queue_out_ready), .out_data(leaf_queue_out_data)
    );

    stream_skid_w60 record_queue (
        .clk(clk), .rst(rst), .in_valid(fills_record | (hits & ~c_is_leaf)), .in_ready(record_queue_in_ready),
        .in_data({
            fills_record ? fill_queue_out_thread : c_thread, fills_record ? fill_queue_out_address : c_address,
            record_queue_in_data_choice, record_queue_in_data_choice_2, record_queue_in_data_choice_3
        }),
        .out_valid(record_valid), .out_ready(record_ready), .out_data(record_queue_out_data)
    );

    stream_skid_w29 fetch_queue (
        .clk(clk), .rst(rst), .in_valid(fills_fetch | (hits & c_is_leaf)), .in_ready(fetch_queue_in_ready),
        .in_data({
            fills_fetch ? fill_queue_out_thread : c_thread, fills_fetch ? fill_queue_out_begin : line_word[24:3],
            fills_fetch ? fill_queue_out_beats : line_word[2:0]
        }),
        .out_valid(fetch_valid), .out_ready(fetch_ready), .out_data(fetch_queue_out_data)
    );

    stream_skid_w25 lookup_queue (
        .clk(clk), .rst(rst), .in_valid(misses), .in_ready(lookup_queue_in_ready),
        .in_data({c_thread, c_address}),
        .out_valid(lookup_valid), .out_ready(lookup_ready), .out_data(lookup_queue_out_data)
    );

    stream_skid_w85 fill_queue (
        .clk(clk), .rst(rst), .in_valid(fill_valid), .in_ready(fill_ready),
        .in_data({fill_thread, fill_address, fill_split, fill_dimension, fill_internal_leaf, fill_begin, fill_beats}),
        .out_valid(fill_queue_out_valid), .out_ready(fill_queue_out_ready), .out_data(fill_queue_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            cleared_lines <= 10'd0;
            b_valid <= 1'd0;
            c_valid <= 1'd0;
            event_tree_hit <= 1'd0;
            event_tree_miss <= 1'd0;
        end else begin
            if (~cleared) cleared_lines <= cleared_lines + 10'd1;
            if (advance) begin
                b_valid <= cleared & (leaf_queue_out_valid | node_queue_out_valid);
                c_valid <= b_valid;
            end
            event_tree_hit <= hits & ~deepest;
            event_tree_miss <= misses;
        end
    end
    always @(posedge clk) begin
        if (advance) begin
            b_thread <= leaf_queue_out_valid ? leaf_queue_out_thread : node_queue_out_thread;
            b_address <= b_address_choice;
            c_thread <= b_thread;
            c_address <= b_address;
            b_is_leaf <= leaf_queue_out_valid;
            c_is_leaf <= b_is_leaf;
            line_valid <= b_line[47];
            line_tag <= b_line[46:35];
            line_word <= b_line[34:0];
        end
    end
endmodule

// Queue of two in registers.
// width = 85
module stream_skid_w85 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [84:0] in_data,
    output wire out_valid, input wire out_ready, output wire [84:0] out_data
);
    reg head_filled, second_filled, room;
    reg [84:0] head, second;

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
// width = 29
module stream_skid_w29 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [28:0] in_data,
    output wire out_valid, input wire out_ready, output wire [28:0] out_data
);
    reg head_filled, second_filled, room;
    reg [28:0] head, second;

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

// Queue in a memory with a registered output.
// depth = 32
// width = 24
module stream_fifo_d32_w24 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [23:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [23:0] out_data
);
    reg [5:0] held, waiting;
    reg is_full, any_waits;
    reg [4:0] write_address, read_address;
    wire [23:0] item;

    wire has_room = ~is_full;
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [5:0] held_bits = {{5{~push}}, 1'd1};
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    memory_1w1r_unordered #(.WIDTH(24), .DEPTH(32)) entries (
        .clk(clk), .write(has_room), .write_address(write_address), .write_data(in_data),
        .read(fetch), .read_address(read_address), .read_data(item)
    );

    always @(posedge clk) begin
        if (rst) begin
            held <= 6'd0;
            waiting <= 6'd0;
            is_full <= 1'd0;
            any_waits <= 1'd0;
            write_address <= 5'd0;
            read_address <= 5'd0;
            out_valid <= 1'd0;
        end else begin
            if (push_xor_pop) begin
                held <= held + held_bits;
                is_full <= push & (held == 6'd31);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 6'd1);
            end
            if (push) write_address <= write_address + 5'd1;
            if (fetch) read_address <= read_address + 5'd1;
            out_valid <= fetch | (out_valid & ~out_ready);
        end
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        held_in_range: assert (held <= 6'd32);
        held_is_waiting_and_shown: assert (held == (waiting + {5'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 6'd32)) & (any_waits == |waiting));
`else
        if (!(held <= 6'd32)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {5'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 6'd32)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue in a memory with a registered output.
// depth = 16
// width = 25
module stream_fifo_d16_w25 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [24:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [24:0] out_data
);
    reg [4:0] held, waiting;
    reg is_full, any_waits;
    reg [3:0] write_address, read_address;
    wire [24:0] item;

    wire has_room = ~is_full;
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [4:0] held_bits = {{4{~push}}, 1'd1};
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    memory_1w1r_unordered #(.WIDTH(25), .DEPTH(16)) entries (
        .clk(clk), .write(has_room), .write_address(write_address), .write_data(in_data),
        .read(fetch), .read_address(read_address), .read_data(item)
    );

    always @(posedge clk) begin
        if (rst) begin
            held <= 5'd0;
            waiting <= 5'd0;
            is_full <= 1'd0;
            any_waits <= 1'd0;
            write_address <= 4'd0;
            read_address <= 4'd0;
            out_valid <= 1'd0;
        end else begin
            if (push_xor_pop) begin
                held <= held + held_bits;
                is_full <= push & (held == 5'd15);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 5'd1);
            end
            if (push) write_address <= write_address + 4'd1;
            if (fetch) read_address <= read_address + 4'd1;
            out_valid <= fetch | (out_valid & ~out_ready);
        end
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        held_in_range: assert (held <= 5'd16);
        held_is_waiting_and_shown: assert (held == (waiting + {4'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 5'd16)) & (any_waits == |waiting));
`else
        if (!(held <= 5'd16)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {4'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 5'd16)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// A sorted row of neighbors for each thread.
// threads = 16
// neighbors = 32
// lanes = 4
module search_queue (
    input  wire clk, input wire rst,
    input  wire start_valid,  // A thread taking up a query.
    input  wire [3:0] start_thread,  // Thread.
    input  wire [23:0] start_number,  // Its number, which its results bear.
    input  wire [5:0] start_k,  // Neighbors wanted.
    input  wire [31:0] start_radius2,  // Squared radius within which neighbors count.
    input  wire [31:0] start_x,  // Where.
    input  wire [31:0] start_y,  // Where.
    input  wire [31:0] start_z,  // Where.
    input  wire candidates_valid, output wire candidates_ready,  // Squared distances.
    input  wire [3:0] candidates_thread,  // Thread.
    input  wire [21:0] candidates_address,  // Address in the point memory.
    input  wire candidates_last,  // Closes its leaf.
    input  wire [30:0] candidates_distance0,  // A squared distance a lane; NaN where there is no point.
    input  wire [30:0] candidates_distance1,  // A squared distance a lane; NaN where there is no point.
    input  wire [30:0] candidates_distance2,  // A squared distance a lane; NaN where there is no point.
    input  wire [30:0] candidates_distance3,  // A squared distance a lane; NaN where there is no point.
    input  wire finish_valid, output wire finish_ready,  // Threads whose search is over.
    input  wire [3:0] finish_thread,  // Thread.
    output reg  radius_valid,  // A thread's radius after a leaf.
    output reg  [3:0] radius_thread,  // Thread.
    output reg  [30:0] radius_radius2,  // Squared radius.
    output reg  event_insert,  // A neighbor was inserted.
    output reg  released_valid,  // A thread whose results are safe.
    output reg  [3:0] released_thread,  // Thread.
    output wire result_valid, input wire result_ready,  // Neighbors, nearest first.
    output wire [23:0] result_number,  // The query's number.
    output wire result_last,  // Closes the query.
    output wire result_found,  // Low for a query without any neighbor.
    output wire [23:0] result_index,  // The neighbor's place in the point memory.
    output wire [31:0] result_distance2,  // Its squared distance.
    output reg  event_beat,  // A priority queue was done with a beat of points.
    output reg  event_insert_wait  // A beat stayed for one more insertion.
);
    (* ram_style = "distributed" *)
    reg [5:0] callers [0:1];
    (* ram_style = "distributed" *)
    reg [30:0] query_radii [0:15];
    (* ram_style = "distributed" *)
    reg [30:0] leaf_radii [0:15];
    reg [3:0] first_thread;  // Thread.
    reg [21:0] first_address;  // Address in the point memory.
    reg first_last;  // Closes its leaf.
    reg [30:0] first_distance0;  // A squared distance a lane; NaN where there is no point.
    reg [30:0] first_distance1;  // A squared distance a lane; NaN where there is no point.
    reg [30:0] first_distance2;  // A squared distance a lane; NaN where there is no point.
    reg [30:0] first_distance3;  // A squared distance a lane; NaN where there is no point.
    reg [30:0] first_limit;  // The squared radius of its thread's last leaf as it came in.
    reg [3:0] second_thread;  // Thread.
    reg [21:0] second_address;  // Address in the point memory.
    reg second_last;  // Closes its leaf.
    reg [30:0] second_distance0;  // A squared distance a lane; NaN where there is no point.
    reg [30:0] second_distance1;  // A squared distance a lane; NaN where there is no point.
    reg [30:0] second_distance2;  // A squared distance a lane; NaN where there is no point.
    reg [30:0] second_distance3;  // A squared distance a lane; NaN where there is no point.
    reg [30:0] second_limit;  // The squared radius of its thread's last leaf as it came in.
    reg [1:0] callers_count;
    reg callers_write_address, callers_read_address, callers_has_room, reads_first, owned;
    reg [3:0] owner, not_owner;
    reg [1791:0] working;
    reg [15:0] fresh;
    reg beat_valid, beat_reads, beat_began;
    reg [3:0] beat_pending, beat_settled;
    reg [3:0] beat_thread;  // Thread.
    reg [21:0] beat_address;  // Address in the point memory.
    reg beat_last;  // Closes its leaf.
    reg [30:0] beat_distance0;  // A squared distance a lane; NaN where there is no point.
    reg [30:0] beat_distance1;  // A squared distance a lane; NaN where there is no point.
    reg [30:0] beat_distance2;  // A squared distance a lane; NaN where there is no point.
    reg [30:0] beat_distance3;  // A squared distance a lane; NaN where there is no point.
    reg item_valid, item_reads, item_last, item_inserts_here, item_inserts_initial, item_inserts_stored;
    reg [3:0] item_thread;
    reg item_stays, item_fresh;
    reg [23:0] new_index;  // The point's place in the point memory.
    reg [30:0] new_distance2;  // Its squared distance.
    reg [31:0] nearer;
    reg new_last;
    reg [3:0] new_thread;
    reg [30:0] farthest;
    reg farthest_valid, fetching, sending, readout_idle;
    reg [3:0] readout_thread;
    reg fetch_from_working, fetch_from_nothing;
    wire [1791:0] stored;
    wire [91:0] query;
    reg [30:0] item_distance2_inverse, item_distance2_reset, item_distance2_inverse_reset;
    reg [23:0] item_index;  // The point's place in the point memory.
    reg [30:0] item_distance2;  // Its squared distance.
    reg [15:0] from_leaf;
    reg last_known;
    reg [3:0] last_thread;
    reg second_last_known;
    reg [3:0] second_last_thread;
    reg [1791:0] sent_row;
    reg [23:0] sent_number;
    reg [5:0] position, next_position;

    wire finish_queue_out_valid;
    wire [3:0] finish_queue_out_data;

    wire last_result_choice = next_position[1] ? (next_position[0] ? sent_row[1791] : sent_row[1735]) : next_position[0] ? sent_row[1679] : sent_row[1623];
    wire last_result_choice_2 = next_position[1] ? (next_position[0] ? sent_row[1567] : sent_row[1511]) : next_position[0] ? sent_row[1455] : sent_row[1399];
    wire last_result_choice_3 = next_position[1] ? (next_position[0] ? sent_row[1343] : sent_row[1287]) : next_position[0] ? sent_row[1231] : sent_row[1175];
    wire last_result_choice_4 = next_position[1] ? (next_position[0] ? sent_row[1119] : sent_row[1063]) : next_position[0] ? sent_row[1007] : sent_row[951];
    wire last_result_choice_5 = next_position[3] ? (next_position[2] ? last_result_choice : last_result_choice_2) : next_position[2] ? last_result_choice_3 : last_result_choice_4;
    wire last_result_choice_6 = next_position[1] ? (next_position[0] ? sent_row[895] : sent_row[839]) : next_position[0] ? sent_row[783] : sent_row[727];
    wire last_result_choice_7 = next_position[1] ? (next_position[0] ? sent_row[671] : sent_row[615]) : next_position[0] ? sent_row[559] : sent_row[503];
    wire last_result_choice_8 = next_position[1] ? (next_position[0] ? sent_row[447] : sent_row[391]) : next_position[0] ? sent_row[335] : sent_row[279];
    wire last_result_choice_9 = next_position[1] ? (next_position[0] ? sent_row[223] : sent_row[167]) : next_position[0] ? sent_row[111] : sent_row[55];
    wire last_result_choice_10 = next_position[3] ? (next_position[2] ? last_result_choice_6 : last_result_choice_7) : next_position[2] ? last_result_choice_8 : last_result_choice_9;
    wire last_result_inverted = ~(next_position[4] ? last_result_choice_5 : last_result_choice_10);
    wire last_result = (position == 6'd31) | last_result_inverted;
    wire result_found_choice = position[1] ? (position[0] ? sent_row[1791] : sent_row[1735]) : position[0] ? sent_row[1679] : sent_row[1623];
    wire result_found_choice_2 = position[1] ? (position[0] ? sent_row[1567] : sent_row[1511]) : position[0] ? sent_row[1455] : sent_row[1399];
    wire result_found_choice_3 = position[1] ? (position[0] ? sent_row[1343] : sent_row[1287]) : position[0] ? sent_row[1231] : sent_row[1175];
    wire result_found_choice_4 = position[1] ? (position[0] ? sent_row[1119] : sent_row[1063]) : position[0] ? sent_row[1007] : sent_row[951];
    wire result_found_choice_5 = position[3] ? (position[2] ? result_found_choice : result_found_choice_2) : position[2] ? result_found_choice_3 : result_found_choice_4;
    wire result_found_choice_6 = position[1] ? (position[0] ? sent_row[895] : sent_row[839]) : position[0] ? sent_row[783] : sent_row[727];
    wire result_found_choice_7 = position[1] ? (position[0] ? sent_row[671] : sent_row[615]) : position[0] ? sent_row[559] : sent_row[503];
    wire result_found_choice_8 = position[1] ? (position[0] ? sent_row[447] : sent_row[391]) : position[0] ? sent_row[335] : sent_row[279];
    wire result_found_choice_9 = position[1] ? (position[0] ? sent_row[223] : sent_row[167]) : position[0] ? sent_row[111] : sent_row[55];
    wire result_found_choice_10 = position[3] ? (position[2] ? result_found_choice_6 : result_found_choice_7) : position[2] ? result_found_choice_8 : result_found_choice_9;
    wire [23:0] result_index_choice = position[1] ? (position[0] ? sent_row[1790:1767] : sent_row[1734:1711]) : position[0] ? sent_row[1678:1655] : sent_row[1622:1599];
    wire [23:0] result_index_choice_2 = position[1] ? (position[0] ? sent_row[1566:1543] : sent_row[1510:1487]) : position[0] ? sent_row[1454:1431] : sent_row[1398:1375];
    wire [23:0] result_index_choice_3 = position[1] ? (position[0] ? sent_row[1342:1319] : sent_row[1286:1263]) : position[0] ? sent_row[1230:1207] : sent_row[1174:1151];
    wire [23:0] result_index_choice_4 = position[1] ? (position[0] ? sent_row[1118:1095] : sent_row[1062:1039]) : position[0] ? sent_row[1006:983] : sent_row[950:927];
    wire [23:0] result_index_choice_5 = position[3] ? (position[2] ? result_index_choice : result_index_choice_2) : position[2] ? result_index_choice_3 : result_index_choice_4;
    wire [23:0] result_index_choice_6 = position[1] ? (position[0] ? sent_row[894:871] : sent_row[838:815]) : position[0] ? sent_row[782:759] : sent_row[726:703];
    wire [23:0] result_index_choice_7 = position[1] ? (position[0] ? sent_row[670:647] : sent_row[614:591]) : position[0] ? sent_row[558:535] : sent_row[502:479];
    wire [23:0] result_index_choice_8 = position[1] ? (position[0] ? sent_row[446:423] : sent_row[390:367]) : position[0] ? sent_row[334:311] : sent_row[278:255];
    wire [23:0] result_index_choice_9 = position[1] ? (position[0] ? sent_row[222:199] : sent_row[166:143]) : position[0] ? sent_row[110:87] : sent_row[54:31];
    wire [23:0] result_index_choice_10 = position[3] ? (position[2] ? result_index_choice_6 : result_index_choice_7) : position[2] ? result_index_choice_8 : result_index_choice_9;
    wire [30:0] result_distance2_choice = position[1] ? (position[0] ? sent_row[1766:1736] : sent_row[1710:1680]) : position[0] ? sent_row[1654:1624] : sent_row[1598:1568];
    wire [30:0] result_distance2_choice_2 = position[1] ? (position[0] ? sent_row[1542:1512] : sent_row[1486:1456]) : position[0] ? sent_row[1430:1400] : sent_row[1374:1344];
    wire [30:0] result_distance2_choice_3 = position[2] ? result_distance2_choice : result_distance2_choice_2;
    wire [30:0] result_distance2_choice_4 = position[1] ? (position[0] ? sent_row[1318:1288] : sent_row[1262:1232]) : position[0] ? sent_row[1206:1176] : sent_row[1150:1120];
    wire [30:0] result_distance2_choice_5 = position[1] ? (position[0] ? sent_row[1094:1064] : sent_row[1038:1008]) : position[0] ? sent_row[982:952] : sent_row[926:896];
    wire [30:0] result_distance2_choice_6 = position[2] ? result_distance2_choice_4 : result_distance2_choice_5;
    wire [30:0] result_distance2_choice_7 = position[3] ? result_distance2_choice_3 : result_distance2_choice_6;
    wire [30:0] result_distance2_choice_8 = position[1] ? (position[0] ? sent_row[870:840] : sent_row[814:784]) : position[0] ? sent_row[758:728] : sent_row[702:672];
    wire [30:0] result_distance2_choice_9 = position[1] ? (position[0] ? sent_row[646:616] : sent_row[590:560]) : position[0] ? sent_row[534:504] : sent_row[478:448];
    wire [30:0] result_distance2_choice_10 = position[2] ? result_distance2_choice_8 : result_distance2_choice_9;
    wire [30:0] result_distance2_choice_11 = position[1] ? (position[0] ? sent_row[422:392] : sent_row[366:336]) : position[0] ? sent_row[310:280] : sent_row[254:224];
    wire [30:0] result_distance2_choice_12 = position[1] ? (position[0] ? sent_row[198:168] : sent_row[142:112]) : position[0] ? sent_row[86:56] : sent_row[30:0];
    wire [30:0] result_distance2_choice_13 = position[2] ? result_distance2_choice_11 : result_distance2_choice_12;
    wire [30:0] result_distance2_choice_14 = position[3] ? result_distance2_choice_10 : result_distance2_choice_13;
    wire [30:0] result_distance2_choice_15 = position[4] ? result_distance2_choice_7 : result_distance2_choice_14;
    wire [23:0] inserted_row_choice = nearer[31] ? (nearer[30] ? working[1734:1711] : new_index) : working[1790:1767];
    wire [30:0] radius_radius2_choice = nearer[31] ? (nearer[30] ? working[1710:1680] : new_distance2) : working[1766:1736];
    wire [23:0] inserted_row_choice_2 = nearer[30] ? (nearer[29] ? working[1678:1655] : new_index) : working[1734:1711];
    wire [30:0] inserted_row_choice_3 = nearer[30] ? (nearer[29] ? working[1654:1624] : new_distance2) : working[1710:1680];
    wire [23:0] inserted_row_choice_4 = nearer[29] ? (nearer[28] ? working[1622:1599] : new_index) : working[1678:1655];
    wire [30:0] inserted_row_choice_5 = nearer[29] ? (nearer[28] ? working[1598:1568] : new_distance2) : working[1654:1624];
    wire [23:0] inserted_row_choice_6 = nearer[28] ? (nearer[27] ? working[1566:1543] : new_index) : working[1622:1599];
    wire [30:0] inserted_row_choice_7 = nearer[28] ? (nearer[27] ? working[1542:1512] : new_distance2) : working[1598:1568];
    wire [23:0] inserted_row_choice_8 = nearer[27] ? (nearer[26] ? working[1510:1487] : new_index) : working[1566:1543];
    wire [30:0] inserted_row_choice_9 = nearer[27] ? (nearer[26] ? working[1486:1456] : new_distance2) : working[1542:1512];
    wire [23:0] inserted_row_choice_10 = nearer[26] ? (nearer[25] ? working[1454:1431] : new_index) : working[1510:1487];
    wire [30:0] inserted_row_choice_11 = nearer[26] ? (nearer[25] ? working[1430:1400] : new_distance2) : working[1486:1456];
    wire [23:0] inserted_row_choice_12 = nearer[25] ? (nearer[24] ? working[1398:1375] : new_index) : working[1454:1431];
    wire [30:0] inserted_row_choice_13 = nearer[25] ? (nearer[24] ? working[1374:1344] : new_distance2) : working[1430:1400];
    wire [23:0] inserted_row_choice_14 = nearer[24] ? (nearer[23] ? working[1342:1319] : new_index) : working[1398:1375];
    wire [30:0] inserted_row_choice_15 = nearer[24] ? (nearer[23] ? working[1318:1288] : new_distance2) : working[1374:1344];
    wire [23:0] inserted_row_choice_16 = nearer[23] ? (nearer[22] ? working[1286:1263] : new_index) : working[1342:1319];
    wire [30:0] inserted_row_choice_17 = nearer[23] ? (nearer[22] ? working[1262:1232] : new_distance2) : working[1318:1288];
    wire [23:0] inserted_row_choice_18 = nearer[22] ? (nearer[21] ? working[1230:1207] : new_index) : working[1286:1263];
    wire [30:0] inserted_row_choice_19 = nearer[22] ? (nearer[21] ? working[1206:1176] : new_distance2) : working[1262:1232];
    wire [23:0] inserted_row_choice_20 = nearer[21] ? (nearer[20] ? working[1174:1151] : new_index) : working[1230:1207];
    wire [30:0] inserted_row_choice_21 = nearer[21] ? (nearer[20] ? working[1150:1120] : new_distance2) : working[1206:1176];
    wire [23:0] inserted_row_choice_22 = nearer[20] ? (nearer[19] ? working[1118:1095] : new_index) : working[1174:1151];
    wire [30:0] inserted_row_choice_23 = nearer[20] ? (nearer[19] ? working[1094:1064] : new_distance2) : working[1150:1120];
    wire [23:0] inserted_row_choice_24 = nearer[19] ? (nearer[18] ? working[1062:1039] : new_index) : working[1118:1095];
    wire [30:0] inserted_row_choice_25 = nearer[19] ? (nearer[18] ? working[1038:1008] : new_distance2) : working[1094:1064];
    wire [23:0] inserted_row_choice_26 = nearer[18] ? (nearer[17] ? working[1006:983] : new_index) : working[1062:1039];
    wire [30:0] inserted_row_choice_27 = nearer[18] ? (nearer[17] ? working[982:952] : new_distance2) : working[1038:1008];
    wire [23:0] inserted_row_choice_28 = nearer[17] ? (nearer[16] ? working[950:927] : new_index) : working[1006:983];
    wire [30:0] inserted_row_choice_29 = nearer[17] ? (nearer[16] ? working[926:896] : new_distance2) : working[982:952];
    wire [23:0] inserted_row_choice_30 = nearer[16] ? (nearer[15] ? working[894:871] : new_index) : working[950:927];
    wire [30:0] inserted_row_choice_31 = nearer[16] ? (nearer[15] ? working[870:840] : new_distance2) : working[926:896];
    wire [23:0] inserted_row_choice_32 = nearer[15] ? (nearer[14] ? working[838:815] : new_index) : working[894:871];
    wire [30:0] inserted_row_choice_33 = nearer[15] ? (nearer[14] ? working[814:784] : new_distance2) : working[870:840];
    wire [23:0] inserted_row_choice_34 = nearer[14] ? (nearer[13] ? working[782:759] : new_index) : working[838:815];
    wire [30:0] inserted_row_choice_35 = nearer[14] ? (nearer[13] ? working[758:728] : new_distance2) : working[814:784];
    wire [23:0] inserted_row_choice_36 = nearer[13] ? (nearer[12] ? working[726:703] : new_index) : working[782:759];
    wire [30:0] inserted_row_choice_37 = nearer[13] ? (nearer[12] ? working[702:672] : new_distance2) : working[758:728];
    wire [23:0] inserted_row_choice_38 = nearer[12] ? (nearer[11] ? working[670:647] : new_index) : working[726:703];
    wire [30:0] inserted_row_choice_39 = nearer[12] ? (nearer[11] ? working[646:616] : new_distance2) : working[702:672];
    wire [23:0] inserted_row_choice_40 = nearer[11] ? (nearer[10] ? working[614:591] : new_index) : working[670:647];
    wire [30:0] inserted_row_choice_41 = nearer[11] ? (nearer[10] ? working[590:560] : new_distance2) : working[646:616];
    wire [23:0] inserted_row_choice_42 = nearer[10] ? (nearer[9] ? working[558:535] : new_index) : working[614:591];
    wire [30:0] inserted_row_choice_43 = nearer[10] ? (nearer[9] ? working[534:504] : new_distance2) : working[590:560];
    wire [23:0] inserted_row_choice_44 = nearer[9] ? (nearer[8] ? working[502:479] : new_index) : working[558:535];
    wire [30:0] inserted_row_choice_45 = nearer[9] ? (nearer[8] ? working[478:448] : new_distance2) : working[534:504];
    wire [23:0] inserted_row_choice_46 = nearer[8] ? (nearer[7] ? working[446:423] : new_index) : working[502:479];
    wire [30:0] inserted_row_choice_47 = nearer[8] ? (nearer[7] ? working[422:392] : new_distance2) : working[478:448];
    wire [23:0] inserted_row_choice_48 = nearer[7] ? (nearer[6] ? working[390:367] : new_index) : working[446:423];
    wire [30:0] inserted_row_choice_49 = nearer[7] ? (nearer[6] ? working[366:336] : new_distance2) : working[422:392];
    wire [23:0] inserted_row_choice_50 = nearer[6] ? (nearer[5] ? working[334:311] : new_index) : working[390:367];
    wire [30:0] inserted_row_choice_51 = nearer[6] ? (nearer[5] ? working[310:280] : new_distance2) : working[366:336];
    wire [23:0] inserted_row_choice_52 = nearer[5] ? (nearer[4] ? working[278:255] : new_index) : working[334:311];
    wire [30:0] inserted_row_choice_53 = nearer[5] ? (nearer[4] ? working[254:224] : new_distance2) : working[310:280];
    wire [23:0] inserted_row_choice_54 = nearer[4] ? (nearer[3] ? working[222:199] : new_index) : working[278:255];
    wire [30:0] inserted_row_choice_55 = nearer[4] ? (nearer[3] ? working[198:168] : new_distance2) : working[254:224];
    wire [23:0] inserted_row_choice_56 = nearer[3] ? (nearer[2] ? working[166:143] : new_index) : working[222:199];
    wire [30:0] inserted_row_choice_57 = nearer[3] ? (nearer[2] ? working[142:112] : new_distance2) : working[198:168];
    wire [23:0] inserted_row_choice_58 = nearer[2] ? (nearer[1] ? working[110:87] : new_index) : working[166:143];
    wire [30:0] inserted_row_choice_59 = nearer[2] ? (nearer[1] ? working[86:56] : new_distance2) : working[142:112];
    wire [23:0] inserted_row_choice_60 = nearer[1] ? (nearer[0] ? working[54:31] : new_index) : working[110:87];
    wire [30:0] inserted_row_choice_61 = nearer[1] ? (nearer[0] ? working[30:0] : new_distance2) : working[86:56];
    wire [1791:0] inserted_row = {
        nearer[31] ? (nearer[30] ? working[1735] : 1'd1) : working[1791], inserted_row_choice,
        radius_radius2_choice, nearer[30] ? (nearer[29] ? working[1679] : 1'd1) : working[1735],
        inserted_row_choice_2, inserted_row_choice_3,
        nearer[29] ? (nearer[28] ? working[1623] : 1'd1) : working[1679], inserted_row_choice_4,
        inserted_row_choice_5, nearer[28] ? (nearer[27] ? working[1567] : 1'd1) : working[1623],
        inserted_row_choice_6, inserted_row_choice_7,
        nearer[27] ? (nearer[26] ? working[1511] : 1'd1) : working[1567], inserted_row_choice_8,
        inserted_row_choice_9, nearer[26] ? (nearer[25] ? working[1455] : 1'd1) : working[1511],
        inserted_row_choice_10, inserted_row_choice_11,
        nearer[25] ? (nearer[24] ? working[1399] : 1'd1) : working[1455], inserted_row_choice_12,
        inserted_row_choice_13, nearer[24] ? (nearer[23] ? working[1343] : 1'd1) : working[1399],
        inserted_row_choice_14, inserted_row_choice_15,
        nearer[23] ? (nearer[22] ? working[1287] : 1'd1) : working[1343], inserted_row_choice_16,
        inserted_row_choice_17, nearer[22] ? (nearer[21] ? working[1231] : 1'd1) : working[1287],
        inserted_row_choice_18, inserted_row_choice_19,
        nearer[21] ? (nearer[20] ? working[1175] : 1'd1) : working[1231], inserted_row_choice_20,
        inserted_row_choice_21, nearer[20] ? (nearer[19] ? working[1119] : 1'd1) : working[1175],
        inserted_row_choice_22, inserted_row_choice_23,
        nearer[19] ? (nearer[18] ? working[1063] : 1'd1) : working[1119], inserted_row_choice_24,
        inserted_row_choice_25, nearer[18] ? (nearer[17] ? working[1007] : 1'd1) : working[1063],
        inserted_row_choice_26, inserted_row_choice_27,
        nearer[17] ? (nearer[16] ? working[951] : 1'd1) : working[1007], inserted_row_choice_28,
        inserted_row_choice_29, nearer[16] ? (nearer[15] ? working[895] : 1'd1) : working[951],
        inserted_row_choice_30, inserted_row_choice_31,
        nearer[15] ? (nearer[14] ? working[839] : 1'd1) : working[895], inserted_row_choice_32,
        inserted_row_choice_33, nearer[14] ? (nearer[13] ? working[783] : 1'd1) : working[839],
        inserted_row_choice_34, inserted_row_choice_35,
        nearer[13] ? (nearer[12] ? working[727] : 1'd1) : working[783], inserted_row_choice_36,
        inserted_row_choice_37, nearer[12] ? (nearer[11] ? working[671] : 1'd1) : working[727],
        inserted_row_choice_38, inserted_row_choice_39,
        nearer[11] ? (nearer[10] ? working[615] : 1'd1) : working[671], inserted_row_choice_40,
        inserted_row_choice_41, nearer[10] ? (nearer[9] ? working[559] : 1'd1) : working[615],
        inserted_row_choice_42, inserted_row_choice_43,
        nearer[9] ? (nearer[8] ? working[503] : 1'd1) : working[559], inserted_row_choice_44,
        inserted_row_choice_45, nearer[8] ? (nearer[7] ? working[447] : 1'd1) : working[503],
        inserted_row_choice_46, inserted_row_choice_47,
        nearer[7] ? (nearer[6] ? working[391] : 1'd1) : working[447], inserted_row_choice_48,
        inserted_row_choice_49, nearer[6] ? (nearer[5] ? working[335] : 1'd1) : working[391],
        inserted_row_choice_50, inserted_row_choice_51,
        nearer[5] ? (nearer[4] ? working[279] : 1'd1) : working[335], inserted_row_choice_52,
        inserted_row_choice_53, nearer[4] ? (nearer[3] ? working[223] : 1'd1) : working[279],
        inserted_row_choice_54, inserted_row_choice_55,
        nearer[3] ? (nearer[2] ? working[167] : 1'd1) : working[223], inserted_row_choice_56,
        inserted_row_choice_57, nearer[2] ? (nearer[1] ? working[111] : 1'd1) : working[167],
        inserted_row_choice_58, inserted_row_choice_59,
        nearer[1] ? (nearer[0] ? working[55] : 1'd1) : working[111], inserted_row_choice_60,
        inserted_row_choice_61, nearer[0] ? 1'd1 : working[55], nearer[0] ? new_index : working[54:31],
        nearer[0] ? new_distance2 : working[30:0]
    };
    wire readout_reads = finish_queue_out_valid & readout_idle;
    wire [3:0] read_thread = readout_reads ? finish_queue_out_data : beat_thread;
    wire finished_owns = owned & (~not_owner == finish_queue_out_data);
    wire readout_starts = readout_reads & ~(item_reads & finished_owns);
    wire callers_write_address_enable_both = candidates_valid & callers_has_room;
    wire first_thread_enable_both = callers_write_address_enable_both & ~callers_write_address;
    wire [15:0] first_limit_shifted = from_leaf >> candidates_thread;
    wire [30:0] leaf_radius2 = leaf_radii[candidates_thread];
    wire [30:0] query_radius2 = query_radii[candidates_thread];
    wire [30:0] first_limit_choice = first_limit_shifted[0] ? leaf_radius2 : query_radius2;
    wire second_thread_enable_both = callers_write_address_enable_both & callers_write_address;
    wire waits = beat_reads & readout_reads;
    wire moves = beat_valid & ~waits;
    wire [3:0] not_beat_settled = ~beat_settled;
    wire stays_either = (not_beat_settled[1] & not_beat_settled[0]) | (not_beat_settled[2] & |not_beat_settled[1:0]);
    wire stays = beat_valid & (stays_either | (not_beat_settled[3] & |not_beat_settled[2:0]));
    wire ends = moves & ~stays;
    wire beat_free = ~beat_valid | ends;
    wire [5:0] callers_head = callers[callers_read_address];
    wire driven_out = beat_valid & (callers_head[0] & ~callers_head[1] & ~beat_began);
    wire take = |callers_count & (beat_free & ~driven_out);
    wire callers_has_room_either = (callers_count == 2'd2) | ((callers_count == 2'd1) & callers_write_address_enable_both);
    wire [1791:0] initial_row = {
        25'd0, query[61:31], 25'd0, query[30] ? 31'd0 : query[61:31], 25'd0, query[29] ? 31'd0 : query[61:31],
        25'd0, query[28] ? 31'd0 : query[61:31], 25'd0, query[27] ? 31'd0 : query[61:31], 25'd0,
        query[26] ? 31'd0 : query[61:31], 25'd0, query[25] ? 31'd0 : query[61:31], 25'd0,
        query[24] ? 31'd0 : query[61:31], 25'd0, query[23] ? 31'd0 : query[61:31], 25'd0,
        query[22] ? 31'd0 : query[61:31], 25'd0, query[21] ? 31'd0 : query[61:31], 25'd0,
        query[20] ? 31'd0 : query[61:31], 25'd0, query[19] ? 31'd0 : query[61:31], 25'd0,
        query[18] ? 31'd0 : query[61:31], 25'd0, query[17] ? 31'd0 : query[61:31], 25'd0,
        query[16] ? 31'd0 : query[61:31], 25'd0, query[15] ? 31'd0 : query[61:31], 25'd0,
        query[14] ? 31'd0 : query[61:31], 25'd0, query[13] ? 31'd0 : query[61:31], 25'd0,
        query[12] ? 31'd0 : query[61:31], 25'd0, query[11] ? 31'd0 : query[61:31], 25'd0,
        query[10] ? 31'd0 : query[61:31], 25'd0, query[9] ? 31'd0 : query[61:31], 25'd0,
        query[8] ? 31'd0 : query[61:31], 25'd0, query[7] ? 31'd0 : query[61:31], 25'd0,
        query[6] ? 31'd0 : query[61:31], 25'd0, query[5] ? 31'd0 : query[61:31], 25'd0,
        query[4] ? 31'd0 : query[61:31], 25'd0, query[3] ? 31'd0 : query[61:31], 25'd0,
        query[2] ? 31'd0 : query[61:31], 25'd0, query[1] ? 31'd0 : query[61:31], 25'd0,
        query[0] ? 31'd0 : query[61:31]
    };
    wire reads = moves & beat_reads;
    wire fresh_both = reads & (beat_thread[3:2] == 2'd3);
    wire beat_thread_1_0_is_3 = beat_thread[1:0] == 2'd3;
    wire beat_thread_1_0_is_2 = beat_thread[1:0] == 2'd2;
    wire beat_thread_1_0_is_1 = beat_thread[1:0] == 2'd1;
    wire beat_thread_1_0_is_0 = beat_thread[1:0] == 2'd0;
    wire fresh_both_2 = reads & (beat_thread[3:2] == 2'd2);
    wire fresh_both_3 = reads & (beat_thread[3:2] == 2'd1);
    wire fresh_both_4 = reads & (beat_thread[3:2] == 2'd0);
    wire [15:0] fresh_bits = {
        fresh_both & beat_thread_1_0_is_3, fresh_both & beat_thread_1_0_is_2,
        fresh_both & beat_thread_1_0_is_1, fresh_both & beat_thread_1_0_is_0,
        fresh_both_2 & beat_thread_1_0_is_3, fresh_both_2 & beat_thread_1_0_is_2,
        fresh_both_2 & beat_thread_1_0_is_1, fresh_both_2 & beat_thread_1_0_is_0,
        fresh_both_3 & beat_thread_1_0_is_3, fresh_both_3 & beat_thread_1_0_is_2,
        fresh_both_3 & beat_thread_1_0_is_1, fresh_both_3 & beat_thread_1_0_is_0,
        fresh_both_4 & beat_thread_1_0_is_3, fresh_both_4 & beat_thread_1_0_is_2,
        fresh_both_4 & beat_thread_1_0_is_1, fresh_both_4 & beat_thread_1_0_is_0
    };
    wire query_set_both = start_valid & (start_thread[3:2] == 2'd3);
    wire start_thread_1_0_is_3 = start_thread[1:0] == 2'd3;
    wire start_thread_1_0_is_2 = start_thread[1:0] == 2'd2;
    wire start_thread_1_0_is_1 = start_thread[1:0] == 2'd1;
    wire start_thread_1_0_is_0 = start_thread[1:0] == 2'd0;
    wire query_set_both_2 = start_valid & (start_thread[3:2] == 2'd2);
    wire query_set_both_3 = start_valid & (start_thread[3:2] == 2'd1);
    wire query_set_both_4 = start_valid & (start_thread[3:2] == 2'd0);
    wire [15:0] query_set = {
        query_set_both & start_thread_1_0_is_3, query_set_both & start_thread_1_0_is_2,
        query_set_both & start_thread_1_0_is_1, query_set_both & start_thread_1_0_is_0,
        query_set_both_2 & start_thread_1_0_is_3, query_set_both_2 & start_thread_1_0_is_2,
        query_set_both_2 & start_thread_1_0_is_1, query_set_both_2 & start_thread_1_0_is_0,
        query_set_both_3 & start_thread_1_0_is_3, query_set_both_3 & start_thread_1_0_is_2,
        query_set_both_3 & start_thread_1_0_is_1, query_set_both_3 & start_thread_1_0_is_0,
        query_set_both_4 & start_thread_1_0_is_3, query_set_both_4 & start_thread_1_0_is_2,
        query_set_both_4 & start_thread_1_0_is_1, query_set_both_4 & start_thread_1_0_is_0
    };
    wire [3:0] tail = item_valid ? item_thread : ~not_owner;
    wire [15:0] fresh_shifted_by_tail = fresh >> tail;
    wire farthest_will_be_known_either = ~callers_head[1] | (~beat_valid & fresh_shifted_by_tail[0]);
    wire farthest_is_current = farthest_valid & ~(beat_reads | item_reads);
    wire farthest_will_be_known = farthest_is_current & ~farthest_will_be_known_either;
    wire beat_pending_both = (second_distance3 < second_limit) & (~farthest_will_be_known | (second_distance3 < farthest));
    wire beat_pending_both_2 = (second_distance2 < second_limit) & (~farthest_will_be_known | (second_distance2 < farthest));
    wire beat_pending_both_3 = (second_distance1 < second_limit) & (~farthest_will_be_known | (second_distance1 < farthest));
    wire beat_pending_both_4 = (second_distance0 < second_limit) & (~farthest_will_be_known | (second_distance0 < farthest));
    wire [3:0] beat_pending_bits = {beat_pending_both, beat_pending_both_2, beat_pending_both_3, beat_pending_both_4};
    wire beat_pending_both_5 = (first_distance3 < first_limit) & (~farthest_will_be_known | (first_distance3 < farthest));
    wire beat_pending_both_6 = (first_distance2 < first_limit) & (~farthest_will_be_known | (first_distance2 < farthest));
    wire beat_pending_both_7 = (first_distance1 < first_limit) & (~farthest_will_be_known | (first_distance1 < farthest));
    wire beat_pending_both_8 = (first_distance0 < first_limit) & (~farthest_will_be_known | (first_distance0 < farthest));
    wire [3:0] beat_pending_bits_2 = {beat_pending_both_5, beat_pending_both_6, beat_pending_both_7, beat_pending_both_8};
    wire [3:0] chosen = beat_pending & (4'd0 - beat_pending);
    wire [3:0] rest = beat_pending & ~chosen;
    wire [3:0] left_bits = {
        ~farthest_is_current | (beat_distance3 < farthest),
        ~farthest_is_current | (beat_distance2 < farthest),
        ~farthest_is_current | (beat_distance1 < farthest),
        ~farthest_is_current | (beat_distance0 < farthest)
    };
    wire [3:0] left = waits ? beat_pending : (rest & left_bits);
    wire [3:0] beat_pending_choice = take ? (callers_read_address ? beat_pending_bits : beat_pending_bits_2) : left;
    wire item_inserts_here_both = moves & |beat_pending;
    wire [15:0] fresh_shifted_by_beat_thread = fresh >> beat_thread;
    wire nearer_in_order = ~item_distance2_inverse_reset < working[1710:1680];
    wire nearer_in_order_2 = item_distance2 < new_distance2;
    wire nearer_choice = nearer[31] ? (nearer[30] ? nearer_in_order : nearer_in_order_2) : (~item_distance2_inverse_reset < working[1766:1736]);
    wire nearer_in_order_3 = ~item_distance2_inverse_reset < working[1654:1624];
    wire nearer_choice_2 = nearer[30] ? (nearer[29] ? nearer_in_order_3 : nearer_in_order_2) : nearer_in_order;
    wire nearer_in_order_4 = ~item_distance2_inverse_reset < working[1598:1568];
    wire nearer_choice_3 = nearer[29] ? (nearer[28] ? nearer_in_order_4 : nearer_in_order_2) : nearer_in_order_3;
    wire nearer_in_order_5 = ~item_distance2_inverse_reset < working[1542:1512];
    wire nearer_choice_4 = nearer[28] ? (nearer[27] ? nearer_in_order_5 : nearer_in_order_2) : nearer_in_order_4;
    wire nearer_in_order_6 = ~item_distance2_inverse_reset < working[1486:1456];
    wire nearer_choice_5 = nearer[27] ? (nearer[26] ? nearer_in_order_6 : nearer_in_order_2) : nearer_in_order_5;
    wire nearer_in_order_7 = ~item_distance2_inverse_reset < working[1430:1400];
    wire nearer_choice_6 = nearer[26] ? (nearer[25] ? nearer_in_order_7 : nearer_in_order_2) : nearer_in_order_6;
    wire nearer_in_order_8 = ~item_distance2_inverse_reset < working[1374:1344];
    wire nearer_choice_7 = nearer[25] ? (nearer[24] ? nearer_in_order_8 : nearer_in_order_2) : nearer_in_order_7;
    wire nearer_in_order_9 = item_distance2_reset < working[1318:1288];
    wire nearer_choice_8 = nearer[24] ? (nearer[23] ? nearer_in_order_9 : nearer_in_order_2) : nearer_in_order_8;
    wire nearer_in_order_10 = item_distance2_reset < working[1262:1232];
    wire nearer_choice_9 = nearer[23] ? (nearer[22] ? nearer_in_order_10 : nearer_in_order_2) : nearer_in_order_9;
    wire nearer_in_order_11 = item_distance2_reset < working[1206:1176];
    wire nearer_choice_10 = nearer[22] ? (nearer[21] ? nearer_in_order_11 : nearer_in_order_2) : nearer_in_order_10;
    wire nearer_in_order_12 = item_distance2_reset < working[1150:1120];
    wire nearer_choice_11 = nearer[21] ? (nearer[20] ? nearer_in_order_12 : nearer_in_order_2) : nearer_in_order_11;
    wire nearer_in_order_13 = item_distance2_reset < working[1094:1064];
    wire nearer_choice_12 = nearer[20] ? (nearer[19] ? nearer_in_order_13 : nearer_in_order_2) : nearer_in_order_12;
    wire nearer_in_order_14 = item_distance2_reset < working[1038:1008];
    wire nearer_choice_13 = nearer[19] ? (nearer[18] ? nearer_in_order_14 : nearer_in_order_2) : nearer_in_order_13;
    wire nearer_in_order_15 = item_distance2_reset < working[982:952];
    wire nearer_choice_14 = nearer[18] ? (nearer[17] ? nearer_in_order_15 : nearer_in_order_2) : nearer_in_order_14;
    wire nearer_in_order_16 = item_distance2_reset < working[926:896];
    wire nearer_choice_15 = nearer[17] ? (nearer[16] ? nearer_in_order_16 : nearer_in_order_2) : nearer_in_order_15;
    wire nearer_in_order_17 = ~item_distance2_inverse < working[870:840];
    wire nearer_choice_16 = nearer[16] ? (nearer[15] ? nearer_in_order_17 : nearer_in_order_2) : nearer_in_order_16;
    wire nearer_in_order_18 = ~item_distance2_inverse < working[814:784];
    wire nearer_choice_17 = nearer[15] ? (nearer[14] ? nearer_in_order_18 : nearer_in_order_2) : nearer_in_order_17;
    wire nearer_in_order_19 = ~item_distance2_inverse < working[758:728];
    wire nearer_choice_18 = nearer[14] ? (nearer[13] ? nearer_in_order_19 : nearer_in_order_2) : nearer_in_order_18;
    wire nearer_in_order_20 = ~item_distance2_inverse < working[702:672];
    wire nearer_choice_19 = nearer[13] ? (nearer[12] ? nearer_in_order_20 : nearer_in_order_2) : nearer_in_order_19;
    wire nearer_in_order_21 = ~item_distance2_inverse < working[646:616];
    wire nearer_choice_20 = nearer[12] ? (nearer[11] ? nearer_in_order_21 : nearer_in_order_2) : nearer_in_order_20;
    wire nearer_in_order_22 = ~item_distance2_inverse < working[590:560];
    wire nearer_choice_21 = nearer[11] ? (nearer[10] ? nearer_in_order_22 : nearer_in_order_2) : nearer_in_order_21;
    wire nearer_in_order_23 = ~item_distance2_inverse < working[534:504];
    wire nearer_choice_22 = nearer[10] ? (nearer[9] ? nearer_in_order_23 : nearer_in_order_2) : nearer_in_order_22;
    wire nearer_in_order_24 = ~item_distance2_inverse < working[478:448];
    wire nearer_choice_23 = nearer[9] ? (nearer[8] ? nearer_in_order_24 : nearer_in_order_2) : nearer_in_order_23;
    wire nearer_in_order_25 = item_distance2 < working[422:392];
    wire nearer_choice_24 = nearer[8] ? (nearer[7] ? nearer_in_order_25 : nearer_in_order_2) : nearer_in_order_24;
    wire nearer_in_order_26 = item_distance2 < working[366:336];
    wire nearer_choice_25 = nearer[7] ? (nearer[6] ? nearer_in_order_26 : nearer_in_order_2) : nearer_in_order_25;
    wire nearer_in_order_27 = item_distance2 < working[310:280];
    wire nearer_choice_26 = nearer[6] ? (nearer[5] ? nearer_in_order_27 : nearer_in_order_2) : nearer_in_order_26;
    wire nearer_in_order_28 = item_distance2 < working[254:224];
    wire nearer_choice_27 = nearer[5] ? (nearer[4] ? nearer_in_order_28 : nearer_in_order_2) : nearer_in_order_27;
    wire nearer_in_order_29 = item_distance2 < working[198:168];
    wire nearer_choice_28 = nearer[4] ? (nearer[3] ? nearer_in_order_29 : nearer_in_order_2) : nearer_in_order_28;
    wire nearer_in_order_30 = item_distance2 < working[142:112];
    wire nearer_choice_29 = nearer[3] ? (nearer[2] ? nearer_in_order_30 : nearer_in_order_2) : nearer_in_order_29;
    wire nearer_in_order_31 = item_distance2 < working[86:56];
    wire nearer_choice_30 = nearer[2] ? (nearer[1] ? nearer_in_order_31 : nearer_in_order_2) : nearer_in_order_30;
    wire nearer_in_order_32 = item_distance2 < working[30:0];
    wire nearer_choice_31 = nearer[1] ? (nearer[0] ? nearer_in_order_32 : nearer_in_order_2) : nearer_in_order_31;
    wire [31:0] nearer_bits = {
        nearer_choice, nearer_choice_2, nearer_choice_3, nearer_choice_4, nearer_choice_5, nearer_choice_6,
        nearer_choice_7, nearer_choice_8, nearer_choice_9, nearer_choice_10, nearer_choice_11,
        nearer_choice_12, nearer_choice_13, nearer_choice_14, nearer_choice_15, nearer_choice_16,
        nearer_choice_17, nearer_choice_18, nearer_choice_19, nearer_choice_20, nearer_choice_21,
        nearer_choice_22, nearer_choice_23, nearer_choice_24, nearer_choice_25, nearer_choice_26,
        nearer_choice_27, nearer_choice_28, nearer_choice_29, nearer_choice_30, nearer_choice_31,
        nearer[0] ? nearer_in_order_2 : nearer_in_order_32
    };
    wire [31:0] nearer_either = (nearer_bits & {32{item_inserts_here}}) | ({1'd1, ~query[30:0]} & {32{item_inserts_initial}});
    wire [31:0] nearer_bits_2 = {
        ~item_distance2_inverse_reset < stored[1766:1736], ~item_distance2_inverse_reset < stored[1710:1680],
        ~item_distance2_inverse_reset < stored[1654:1624], ~item_distance2_inverse_reset < stored[1598:1568],
        ~item_distance2_inverse_reset < stored[1542:1512], ~item_distance2_inverse_reset < stored[1486:1456],
        ~item_distance2_inverse_reset < stored[1430:1400], ~item_distance2_inverse_reset < stored[1374:1344],
        item_distance2_reset < stored[1318:1288], item_distance2_reset < stored[1262:1232],
        item_distance2_reset < stored[1206:1176], item_distance2_reset < stored[1150:1120],
        item_distance2_reset < stored[1094:1064], item_distance2_reset < stored[1038:1008],
        item_distance2_reset < stored[982:952], item_distance2_reset < stored[926:896],
        ~item_distance2_inverse < stored[870:840], ~item_distance2_inverse < stored[814:784],
        ~item_distance2_inverse < stored[758:728], ~item_distance2_inverse < stored[702:672],
        ~item_distance2_inverse < stored[646:616], ~item_distance2_inverse < stored[590:560],
        ~item_distance2_inverse < stored[534:504], ~item_distance2_inverse < stored[478:448],
        item_distance2 < stored[422:392], item_distance2 < stored[366:336], item_distance2 < stored[310:280],
        item_distance2 < stored[254:224], item_distance2 < stored[198:168], item_distance2 < stored[142:112],
        item_distance2 < stored[86:56], item_distance2 < stored[30:0]
    };
    wire result_transfer = sending & result_ready;
    wire result_ends = result_transfer & last_result;
    wire [15:0] fetch_from_nothing_shifted = fresh >> finish_queue_out_data;
    wire [30:0] item_distance2_reset_choice = chosen[1] ? beat_distance1 : chosen[2] ? beat_distance2 : beat_distance3;
    wire [30:0] item_distance2_reset_choice_2 = chosen[0] ? beat_distance0 : item_distance2_reset_choice;
    wire [30:0] item_distance2_inverse_inverted = ~item_distance2_reset_choice_2;
    wire leaf_set_both = radius_valid & (radius_thread[3:2] == 2'd3);
    wire radius_thread_1_0_is_3 = radius_thread[1:0] == 2'd3;
    wire radius_thread_1_0_is_2 = radius_thread[1:0] == 2'd2;
    wire radius_thread_1_0_is_1 = radius_thread[1:0] == 2'd1;
    wire radius_thread_1_0_is_0 = radius_thread[1:0] == 2'd0;
    wire leaf_set_both_2 = radius_valid & (radius_thread[3:2] == 2'd2);
    wire leaf_set_both_3 = radius_valid & (radius_thread[3:2] == 2'd1);
    wire leaf_set_both_4 = radius_valid & (radius_thread[3:2] == 2'd0);
    wire [15:0] leaf_set = {
        leaf_set_both & radius_thread_1_0_is_3, leaf_set_both & radius_thread_1_0_is_2,
        leaf_set_both & radius_thread_1_0_is_1, leaf_set_both & radius_thread_1_0_is_0,
        leaf_set_both_2 & radius_thread_1_0_is_3, leaf_set_both_2 & radius_thread_1_0_is_2,
        leaf_set_both_2 & radius_thread_1_0_is_1, leaf_set_both_2 & radius_thread_1_0_is_0,
        leaf_set_both_3 & radius_thread_1_0_is_3, leaf_set_both_3 & radius_thread_1_0_is_2,
        leaf_set_both_3 & radius_thread_1_0_is_1, leaf_set_both_3 & radius_thread_1_0_is_0,
        leaf_set_both_4 & radius_thread_1_0_is_3, leaf_set_both_4 & radius_thread_1_0_is_2,
        leaf_set_both_4 & radius_thread_1_0_is_1, leaf_set_both_4 & radius_thread_1_0_is_0
    };
    wire fetching_or_result_transfer = fetching | result_transfer;

    assign candidates_ready = callers_has_room;
    assign result_valid = sending;
    assign result_number = sent_number;
    assign result_last = last_result;
    assign result_found = position[4] ? result_found_choice_5 : result_found_choice_10;
    assign result_index = position[4] ? result_index_choice_5 : result_index_choice_10;
    assign result_distance2 = {1'd0, result_distance2_choice_15};

    memory_1w1r #(.WIDTH(1792), .DEPTH(16)) rows (
        .clk(clk), .write(owned), .write_address(owner), .write_data(inserted_row),
        .read(1'd1), .read_address(read_thread), .read_data(stored)
    );

    memory_1w1r #(.WIDTH(92), .DEPTH(16)) queries (
        .clk(clk), .write(start_valid), .write_address(start_thread),
        .write_data({
            start_number, start_k, start_radius2[30:0], start_k < 6'd2, start_k < 6'd3, start_k < 6'd4,
            start_k < 6'd5, start_k < 6'd6, start_k < 6'd7, start_k < 6'd8, start_k < 6'd9, start_k < 6'd10,
            start_k < 6'd11, start_k < 6'd12, start_k < 6'd13, start_k < 6'd14, start_k < 6'd15, start_k < 6'd16,
            start_k < 6'd17, start_k < 6'd18, start_k < 6'd19, start_k < 6'd20, start_k < 6'd21, start_k < 6'd22,
            start_k < 6'd23, start_k < 6'd24, start_k < 6'd25, start_k < 6'd26, start_k < 6'd27, start_k < 6'd28,
            start_k < 6'd29, start_k < 6'd30, start_k < 6'd31, start_k < 6'd32
        }),
        .read(1'd1), .read_address(read_thread), .read_data(query)
    );

    stream_skid_w4 finish_queue (
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
            nearer <= 32'd0;
            new_last <= 1'd0;
            radius_valid <= 1'd0;
            event_insert <= 1'd0;
            farthest_valid <= 1'd0;
            fetching <= 1'd0;
            sending <= 1'd0;
            readout_idle <= 1'd1;
            item_distance2_reset <= 31'd0;
            item_distance2_inverse_reset <= 31'd0;
            last_known <= 1'd0;
            second_last_known <= 1'd0;
            released_valid <= 1'd0;
            event_beat <= 1'd0;
            event_insert_wait <= 1'd0;
        end else begin
            callers_count <= (callers_count + {1'd0, callers_write_address_enable_both}) - {1'd0, take};
            callers_has_room <= take | ~callers_has_room_either;
            owned <= owned | item_valid;
            beat_valid <= take | (stays | waits);
            beat_reads <= take ? farthest_will_be_known_either : (beat_reads & waits);
            beat_began <= ~take & (beat_began | moves);
            item_valid <= moves;
            item_reads <= reads;
            item_last <= ends & beat_last;
            item_inserts_here <= item_inserts_here_both & ~beat_reads;
            item_inserts_initial <= item_inserts_here_both & (beat_reads & fresh_shifted_by_beat_thread[0]);
            item_inserts_stored <= item_inserts_here_both & (beat_reads & ~fresh_shifted_by_beat_thread[0]);
            item_stays <= ~reads;
            nearer <= nearer_either | (nearer_bits_2 & {32{item_inserts_stored}});
            new_last <= item_last;
            radius_valid <= new_last;
            event_insert <= nearer[31];
            farthest_valid <= ~item_reads;
            fetching <= readout_starts;
            sending <= fetching | (sending & ~result_ends);
            readout_idle <= (readout_idle & ~readout_starts) | result_ends;
            item_distance2_reset <= item_distance2_reset_choice_2;
            item_distance2_inverse_reset <= item_distance2_inverse_inverted;
            released_valid <= fetching;
            event_beat <= ends;
            event_insert_wait <= moves & stays;
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
            first_distance1 <= candidates_distance1;
            first_distance2 <= candidates_distance2;
            first_distance3 <= candidates_distance3;
            first_limit <= first_limit_choice;
        end
        if (second_thread_enable_both) begin
            second_thread <= candidates_thread;
            second_address <= candidates_address;
            second_last <= candidates_last;
            second_distance0 <= candidates_distance0;
            second_distance1 <= candidates_distance1;
            second_distance2 <= candidates_distance2;
            second_distance3 <= candidates_distance3;
            second_limit <= first_limit_choice;
        end
        if (item_valid) begin
            owner <= item_thread;
            not_owner <= ~item_thread;
        end
        working <= item_stays ? inserted_row : item_fresh ? initial_row : stored;
        fresh <= (fresh & ~fresh_bits) | query_set;
        beat_pending <= beat_pending_choice;
        beat_settled <= ~beat_pending_choice;
        item_thread <= beat_thread;
        item_fresh <= fresh_shifted_by_beat_thread[0];
        new_index <= item_index;
        new_distance2 <= item_distance2;
        new_thread <= item_thread;
        radius_thread <= new_thread;
        radius_radius2 <= radius_radius2_choice;
        farthest <= radius_radius2_choice;
        fetch_from_working <= finished_owns;
        fetch_from_nothing <= fetch_from_nothing_shifted[0];
        item_distance2_inverse <= item_distance2_inverse_inverted;
        item_index <= {beat_address, |(chosen & 4'd12), |(chosen & 4'd10)};
        item_distance2 <= item_distance2_reset_choice_2;
        from_leaf <= (from_leaf & ~query_set) | leaf_set;
        released_thread <= readout_thread;
        if (beat_free) begin
            beat_thread <= reads_first ? first_thread : second_thread;
            beat_address <= reads_first ? first_address : second_address;
            beat_last <= reads_first ? first_last : second_last;
            beat_distance0 <= reads_first ? first_distance0 : second_distance0;
            beat_distance1 <= reads_first ? first_distance1 : second_distance1;
            beat_distance2 <= reads_first ? first_distance2 : second_distance2;
            beat_distance3 <= reads_first ? first_distance3 : second_distance3;
        end
        if (readout_starts) readout_thread <= finish_queue_out_data;
        if (callers_write_address_enable_both) begin
            last_thread <= candidates_thread;
            second_last_thread <= last_thread;
        end
        if (fetching) begin
            sent_row <= fetch_from_nothing ? initial_row : fetch_from_working ? working : stored;
            sent_number <= query[91:68];
        end
        if (fetching_or_result_transfer) begin
            position <= fetching ? (6'd32 - query[67:62]) : next_position;
            next_position <= fetching ? (6'd33 - query[67:62]) : (next_position + 6'd1);
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
    always @(posedge clk) if (start_valid) query_radii[start_thread] <= start_radius2[30:0];
    always @(posedge clk) if (radius_valid) leaf_radii[radius_thread] <= radius_radius2;

    wire _unused = &{
        1'b0, callers_head[5:2], fetch_from_nothing_shifted[15:1], first_limit_shifted[15:1],
        fresh_shifted_by_beat_thread[15:1], fresh_shifted_by_tail[15:1], start_radius2[31], start_x, start_y,
        start_z
    };

`ifdef RTL_ASSERT
    wire [15:0] check_shifted = fresh >> readout_thread;
    wire check_both = (item_valid | owned) & (tail == callers_head[5:2]);
    wire check_choice = beat_valid ? (callers_head[1] == (beat_thread == callers_head[5:2])) : (callers_head[1] == check_both);
    wire check_both_2 = check_choice & (~beat_valid | (beat_began | (callers_head[0] == check_both)));

    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        start_radius2_in_range: assert (~start_valid | (start_radius2 < 32'h80000000));
        k_fits_a_row: assert (~start_valid | (|start_k & (start_k <= 6'd32)));
        the_farthest_is_of_the_beat: assert (~(beat_valid & farthest_is_current) | (owned & (owner == beat_thread)));
        a_fetched_row_stays_where_it_is: assert (~fetching | (fetch_from_working == (owned & (~not_owner == readout_thread))));
        a_fetched_row_stays_fresh: assert (~fetching | (fetch_from_nothing == check_shifted[0]));
        whom_a_beat_follows_is_told: assert (~(|callers_count) | check_both_2);
        callers_go_with_their_beats: assert (reads_first ^ callers_read_address);
        pending_or_settled: assert (~beat_valid | &(beat_pending ^ beat_settled));
        owner_or_not: assert (~owned | &(owner ^ not_owner));
        idle_when_neither: assert (readout_idle == ~(fetching | sending));
`else
        if (!(~start_valid | (start_radius2 < 32'h80000000))) begin
            $display("assertion failed: start_radius2_in_range in %m"); $stop;
        end
        if (!(~start_valid | (|start_k & (start_k <= 6'd32)))) begin
            $display("assertion failed: k_fits_a_row in %m"); $stop;
        end
        if (!(~(beat_valid & farthest_is_current) | (owned & (owner == beat_thread)))) begin
            $display("assertion failed: the_farthest_is_of_the_beat in %m"); $stop;
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
        if (!(~beat_valid | &(beat_pending ^ beat_settled))) begin
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

    wire _unused_by_checks = &{1'b0, check_shifted[15:1]};
`endif
endmodule

// Takes out beats without a point near enough.
// threads = 16
// lanes = 4
// depth = 16
module search_sieve (
    input  wire clk, input wire rst,
    input  wire start_valid,  // A thread taking up a query.
    input  wire [3:0] start_thread,  // Thread.
    input  wire [23:0] start_number,  // Its number, which its results bear.
    input  wire [5:0] start_k,  // Neighbors wanted.
    input  wire [31:0] start_radius2,  // Squared radius within which neighbors count.
    input  wire [31:0] start_x,  // Where.
    input  wire [31:0] start_y,  // Where.
    input  wire [31:0] start_z,  // Where.
    input  wire radius_valid,  // A thread's new radius.
    input  wire [3:0] radius_thread,  // Thread.
    input  wire [30:0] radius_radius2,  // Squared radius.
    input  wire candidates_valid, output wire candidates_ready,  // Squared distances; the beats of a leaf come together.
    input  wire [3:0] candidates_thread,  // Thread.
    input  wire [21:0] candidates_address,  // Address in the point memory.
    input  wire candidates_last,  // Closes its leaf.
    input  wire [30:0] candidates_distance0,  // A squared distance a lane; NaN where there is no point.
    input  wire [30:0] candidates_distance1,  // A squared distance a lane; NaN where there is no point.
    input  wire [30:0] candidates_distance2,  // A squared distance a lane; NaN where there is no point.
    input  wire [30:0] candidates_distance3,  // A squared distance a lane; NaN where there is no point.
    output wire kept_valid, input wire kept_ready,  // Beats with a point that is near enough.
    output wire [3:0] kept_thread,  // Thread.
    output wire [21:0] kept_address,  // Address in the point memory.
    output wire kept_last,  // Closes its leaf.
    output wire [30:0] kept_distance0,  // A squared distance a lane; NaN where there is no point.
    output wire [30:0] kept_distance1,  // A squared distance a lane; NaN where there is no point.
    output wire [30:0] kept_distance2,  // A squared distance a lane; NaN where there is no point.
    output wire [30:0] kept_distance3,  // A squared distance a lane; NaN where there is no point.
    output reg  skipped_valid,  // The thread of a leaf of which no beat was kept.
    output reg  [3:0] skipped_thread  // Thread.
);
    (* ram_style = "distributed" *)
    reg [30:0] query_radii [0:15];
    (* ram_style = "distributed" *)
    reg [30:0] leaf_radii [0:15];
    reg s1_valid, s1_empty;
    reg [3:0] s1_thread;  // Thread.
    reg [21:0] s1_address;  // Address in the point memory.
    reg s1_last;  // Closes its leaf.
    reg [30:0] s1_distance0;  // A squared distance a lane; NaN where there is no point.
    reg [30:0] s1_distance1;  // A squared distance a lane; NaN where there is no point.
    reg [30:0] s1_distance2;  // A squared distance a lane; NaN where there is no point.
    reg [30:0] s1_distance3;  // A squared distance a lane; NaN where there is no point.
    reg [15:0] from_leaf;
    reg [30:0] radius2;
    reg s2_valid, s2_empty, s2_survives;
    reg [3:0] s2_thread;  // Thread.
    reg [21:0] s2_address;  // Address in the point memory.
    reg s2_last;  // Closes its leaf.
    reg [30:0] s2_distance0;  // A squared distance a lane; NaN where there is no point.
    reg [30:0] s2_distance1;  // A squared distance a lane; NaN where there is no point.
    reg [30:0] s2_distance2;  // A squared distance a lane; NaN where there is no point.
    reg [30:0] s2_distance3;  // A squared distance a lane; NaN where there is no point.
    reg held_valid, held_last;
    reg [3:0] held_thread;  // Thread.
    reg [21:0] held_address;
    reg [30:0] held_distance0, held_distance1, held_distance2, held_distance3;

    wire candidates_queue_out_valid;
    wire [150:0] candidates_queue_out_data;
    wire kept_queue_in_ready;
    wire [150:0] kept_queue_out_data;

    wire decides_early = s2_empty | (~(held_valid & (held_last | s2_survives)) | kept_queue_in_ready);
    wire candidates_queue_out_ready = s1_empty | decides_early;
    wire closed = held_valid & held_last;
    wire near = s2_valid & s2_survives;
    wire displaced = closed | (held_valid & near);
    wire leaves = displaced & kept_queue_in_ready;
    wire advance = ~s1_valid | decides_early;
    wire s1_valid_choice = advance ? candidates_queue_out_valid : s1_valid;
    wire [3:0] candidates_queue_out_thread = candidates_queue_out_data[150:147];
    wire [21:0] candidates_queue_out_address = candidates_queue_out_data[146:125];
    wire candidates_queue_out_last = candidates_queue_out_data[124];
    wire [30:0] candidates_queue_out_distance0 = candidates_queue_out_data[123:93];
    wire [30:0] candidates_queue_out_distance1 = candidates_queue_out_data[92:62];
    wire [30:0] candidates_queue_out_distance2 = candidates_queue_out_data[61:31];
    wire [30:0] candidates_queue_out_distance3 = candidates_queue_out_data[30:0];
    wire query_set_both = start_valid & (start_thread[3:2] == 2'd3);
    wire start_thread_1_0_is_3 = start_thread[1:0] == 2'd3;
    wire start_thread_1_0_is_2 = start_thread[1:0] == 2'd2;
    wire start_thread_1_0_is_1 = start_thread[1:0] == 2'd1;
    wire start_thread_1_0_is_0 = start_thread[1:0] == 2'd0;
    wire query_set_both_2 = start_valid & (start_thread[3:2] == 2'd2);
    wire query_set_both_3 = start_valid & (start_thread[3:2] == 2'd1);
    wire query_set_both_4 = start_valid & (start_thread[3:2] == 2'd0);
    wire [15:0] query_set = {
        query_set_both & start_thread_1_0_is_3, query_set_both & start_thread_1_0_is_2,
        query_set_both & start_thread_1_0_is_1, query_set_both & start_thread_1_0_is_0,
        query_set_both_2 & start_thread_1_0_is_3, query_set_both_2 & start_thread_1_0_is_2,
        query_set_both_2 & start_thread_1_0_is_1, query_set_both_2 & start_thread_1_0_is_0,
        query_set_both_3 & start_thread_1_0_is_3, query_set_both_3 & start_thread_1_0_is_2,
        query_set_both_3 & start_thread_1_0_is_1, query_set_both_3 & start_thread_1_0_is_0,
        query_set_both_4 & start_thread_1_0_is_3, query_set_both_4 & start_thread_1_0_is_2,
        query_set_both_4 & start_thread_1_0_is_1, query_set_both_4 & start_thread_1_0_is_0
    };
    wire leaf_set_both = radius_valid & (radius_thread[3:2] == 2'd3);
    wire radius_thread_1_0_is_3 = radius_thread[1:0] == 2'd3;
    wire radius_thread_1_0_is_2 = radius_thread[1:0] == 2'd2;
    wire radius_thread_1_0_is_1 = radius_thread[1:0] == 2'd1;
    wire radius_thread_1_0_is_0 = radius_thread[1:0] == 2'd0;
    wire leaf_set_both_2 = radius_valid & (radius_thread[3:2] == 2'd2);
    wire leaf_set_both_3 = radius_valid & (radius_thread[3:2] == 2'd1);
    wire leaf_set_both_4 = radius_valid & (radius_thread[3:2] == 2'd0);
    wire [15:0] leaf_set = {
        leaf_set_both & radius_thread_1_0_is_3, leaf_set_both & radius_thread_1_0_is_2,
        leaf_set_both & radius_thread_1_0_is_1, leaf_set_both & radius_thread_1_0_is_0,
        leaf_set_both_2 & radius_thread_1_0_is_3, leaf_set_both_2 & radius_thread_1_0_is_2,
        leaf_set_both_2 & radius_thread_1_0_is_1, leaf_set_both_2 & radius_thread_1_0_is_0,
        leaf_set_both_3 & radius_thread_1_0_is_3, leaf_set_both_3 & radius_thread_1_0_is_2,
        leaf_set_both_3 & radius_thread_1_0_is_1, leaf_set_both_3 & radius_thread_1_0_is_0,
        leaf_set_both_4 & radius_thread_1_0_is_3, leaf_set_both_4 & radius_thread_1_0_is_2,
        leaf_set_both_4 & radius_thread_1_0_is_1, leaf_set_both_4 & radius_thread_1_0_is_0
    };
    wire [15:0] radius2_shifted = from_leaf >> candidates_queue_out_thread;
    wire [30:0] leaf_radius2 = leaf_radii[candidates_queue_out_thread];
    wire [30:0] query_radius2 = query_radii[candidates_queue_out_thread];
    wire proceeds = ~displaced | kept_queue_in_ready;
    wire decides = ~s2_valid | proceeds;
    wire s2_valid_choice = decides ? s1_valid : s2_valid;
    wire [3:0] s2_survives_bits = {s1_distance3 < radius2, s1_distance2 < radius2, s1_distance1 < radius2, s1_distance0 < radius2};
    wire keep = near & proceeds;
    wire ends = s2_valid & s2_last & (~near & proceeds);
    wire closes = ends & (held_valid & ~held_last);

    assign {
        kept_thread, kept_address, kept_last, kept_distance0, kept_distance1, kept_distance2, kept_distance3
    } = kept_queue_out_data;

    stream_skid_w151 candidates_queue (
        .clk(clk), .rst(rst), .in_valid(candidates_valid), .in_ready(candidates_ready),
        .in_data({
            candidates_thread, candidates_address, candidates_last, candidates_distance0, candidates_distance1,
            candidates_distance2, candidates_distance3
        }),
        .out_valid(candidates_queue_out_valid), .out_ready(candidates_queue_out_ready),
        .out_data(candidates_queue_out_data)
    );

    stream_fifo_d16_w151 kept_queue (
        .clk(clk), .rst(rst), .in_valid(leaves), .in_ready(kept_queue_in_ready),
        .in_data({
            held_thread, held_address, held_last, held_distance0, held_distance1, held_distance2, held_distance3
        }),
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
            s1_distance1 <= candidates_queue_out_distance1;
            s1_distance2 <= candidates_queue_out_distance2;
            s1_distance3 <= candidates_queue_out_distance3;
            radius2 <= radius2_shifted[0] ? leaf_radius2 : query_radius2;
        end
        from_leaf <= (from_leaf & ~query_set) | leaf_set;
        skipped_thread <= s2_thread;
        if (decides) begin
            s2_survives <= |s2_survives_bits;
            s2_thread <= s1_thread;
            s2_address <= s1_address;
            s2_last <= s1_last;
            s2_distance0 <= s1_distance0;
            s2_distance1 <= s1_distance1;
            s2_distance2 <= s1_distance2;
            s2_distance3 <= s1_distance3;
        end
        if (keep | closes) held_last <= s2_last;
        if (keep) begin
            held_thread <= s2_thread;
            held_address <= s2_address;
            held_distance0 <= s2_distance0;
            held_distance1 <= s2_distance1;
            held_distance2 <= s2_distance2;
            held_distance3 <= s2_distance3;
        end
    end
    always @(posedge clk) if (start_valid) query_radii[start_thread] <= start_radius2[30:0];
    always @(posedge clk) if (radius_valid) leaf_radii[radius_thread] <= radius_radius2;

    wire _unused = &{1'b0, radius2_shifted[15:1], start_k, start_number, start_radius2[31], start_x, start_y, start_z};

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        start_radius2_in_range: assert (~start_valid | (start_radius2 < 32'h80000000));
        s1_valid_or_empty: assert (s1_valid ^ s1_empty);
        s2_valid_or_empty: assert (s2_valid ^ s2_empty);
        decides_as_early: assert (decides == decides_early);
`else
        if (!(~start_valid | (start_radius2 < 32'h80000000))) begin
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
// depth = 16
// width = 151
module stream_fifo_d16_w151 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [150:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [150:0] out_data
);
    reg [4:0] held, waiting;
    reg is_full, any_waits;
    reg [3:0] write_address, read_address;
    wire [150:0] item;

    wire has_room = ~is_full;
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [4:0] held_bits = {{4{~push}}, 1'd1};
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    memory_1w1r_unordered #(.WIDTH(151), .DEPTH(16)) entries (
        .clk(clk), .write(has_room), .write_address(write_address), .write_data(in_data),
        .read(fetch), .read_address(read_address), .read_data(item)
    );

    always @(posedge clk) begin
        if (rst) begin
            held <= 5'd0;
            waiting <= 5'd0;
            is_full <= 1'd0;
            any_waits <= 1'd0;
            write_address <= 4'd0;
            read_address <= 4'd0;
            out_valid <= 1'd0;
        end else begin
            if (push_xor_pop) begin
                held <= held + held_bits;
                is_full <= push & (held == 5'd15);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 5'd1);
            end
            if (push) write_address <= write_address + 4'd1;
            if (fetch) read_address <= read_address + 4'd1;
            out_valid <= fetch | (out_valid & ~out_ready);
        end
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        held_in_range: assert (held <= 5'd16);
        held_is_waiting_and_shown: assert (held == (waiting + {4'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 5'd16)) & (any_waits == |waiting));
`else
        if (!(held <= 5'd16)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {4'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 5'd16)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue of two in registers.
// width = 151
module stream_skid_w151 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [150:0] in_data,
    output wire out_valid, input wire out_ready, output wire [150:0] out_data
);
    reg head_filled, second_filled, room;
    reg [150:0] head, second;

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
// threads = 16
// lanes = 4
module search_leaf (
    input  wire clk, input wire rst,
    input  wire start_valid,  // A thread taking up a query.
    input  wire [3:0] start_thread,  // Thread.
    input  wire [23:0] start_number,  // Its number, which its results bear.
    input  wire [5:0] start_k,  // Neighbors wanted.
    input  wire [31:0] start_radius2,  // Squared radius within which neighbors count.
    input  wire [31:0] start_x,  // Where.
    input  wire [31:0] start_y,  // Where.
    input  wire [31:0] start_z,  // Where.
    input  wire beat_valid, output wire beat_ready,  // Points from memory.
    input  wire [3:0] beat_thread,  // Thread.
    input  wire [21:0] beat_address,  // Address in the point memory.
    input  wire beat_last,  // Closes its leaf.
    input  wire [31:0] beat_x0,  // A point a lane; NaN where there is none.
    input  wire [31:0] beat_y0,  // A point a lane; NaN where there is none.
    input  wire [31:0] beat_z0,  // A point a lane; NaN where there is none.
    input  wire [31:0] beat_x1,  // A point a lane; NaN where there is none.
    input  wire [31:0] beat_y1,  // A point a lane; NaN where there is none.
    input  wire [31:0] beat_z1,  // A point a lane; NaN where there is none.
    input  wire [31:0] beat_x2,  // A point a lane; NaN where there is none.
    input  wire [31:0] beat_y2,  // A point a lane; NaN where there is none.
    input  wire [31:0] beat_z2,  // A point a lane; NaN where there is none.
    input  wire [31:0] beat_x3,  // A point a lane; NaN where there is none.
    input  wire [31:0] beat_y3,  // A point a lane; NaN where there is none.
    input  wire [31:0] beat_z3,  // A point a lane; NaN where there is none.
    output wire candidates_valid, input wire candidates_ready,  // Their squared distances.
    output wire [3:0] candidates_thread,  // Thread.
    output wire [21:0] candidates_address,  // Address in the point memory.
    output wire candidates_last,  // Closes its leaf.
    output wire [30:0] candidates_distance0,  // A squared distance a lane; NaN where there is no point.
    output wire [30:0] candidates_distance1,  // A squared distance a lane; NaN where there is no point.
    output wire [30:0] candidates_distance2,  // A squared distance a lane; NaN where there is no point.
    output wire [30:0] candidates_distance3  // A squared distance a lane; NaN where there is no point.
);
    reg query_valid, query_empty;
    reg [3:0] points_thread;  // Thread.
    reg [21:0] points_address;  // Address in the point memory.
    reg points_last;  // Closes its leaf.
    reg [31:0] points_x0;  // A point a lane; NaN where there is none.
    reg [31:0] points_y0;  // A point a lane; NaN where there is none.
    reg [31:0] points_z0;  // A point a lane; NaN where there is none.
    reg [31:0] points_x1;  // A point a lane; NaN where there is none.
    reg [31:0] points_y1;  // A point a lane; NaN where there is none.
    reg [31:0] points_z1;  // A point a lane; NaN where there is none.
    reg [31:0] points_x2;  // A point a lane; NaN where there is none.
    reg [31:0] points_y2;  // A point a lane; NaN where there is none.
    reg [31:0] points_z2;  // A point a lane; NaN where there is none.
    reg [31:0] points_x3;  // A point a lane; NaN where there is none.
    reg [31:0] points_y3;  // A point a lane; NaN where there is none.
    reg [31:0] points_z3;  // A point a lane; NaN where there is none.
    wire [95:0] query;

    wire beat_queue_out_valid;
    wire [410:0] beat_queue_out_data;
    wire distance_in_ready;

    wire query_advance = ~query_valid | distance_in_ready;
    wire [3:0] beat_queue_out_thread = beat_queue_out_data[410:407];
    wire beat_queue_out_ready = query_empty | distance_in_ready;
    wire query_valid_choice = query_advance ? beat_queue_out_valid : query_valid;
    wire [21:0] beat_queue_out_address = beat_queue_out_data[406:385];
    wire beat_queue_out_last = beat_queue_out_data[384];
    wire [31:0] beat_queue_out_x0 = beat_queue_out_data[383:352];
    wire [31:0] beat_queue_out_y0 = beat_queue_out_data[351:320];
    wire [31:0] beat_queue_out_z0 = beat_queue_out_data[319:288];
    wire [31:0] beat_queue_out_x1 = beat_queue_out_data[287:256];
    wire [31:0] beat_queue_out_y1 = beat_queue_out_data[255:224];
    wire [31:0] beat_queue_out_z1 = beat_queue_out_data[223:192];
    wire [31:0] beat_queue_out_x2 = beat_queue_out_data[191:160];
    wire [31:0] beat_queue_out_y2 = beat_queue_out_data[159:128];
    wire [31:0] beat_queue_out_z2 = beat_queue_out_data[127:96];
    wire [31:0] beat_queue_out_x3 = beat_queue_out_data[95:64];
    wire [31:0] beat_queue_out_y3 = beat_queue_out_data[63:32];
    wire [31:0] beat_queue_out_z3 = beat_queue_out_data[31:0];

    memory_1w1r #(.WIDTH(96), .DEPTH(16)) queries (
        .clk(clk), .write(start_valid), .write_address(start_thread),
        .write_data({start_x, start_y, start_z}),
        .read(query_advance), .read_address(beat_queue_out_thread), .read_data(query)
    );

    stream_skid_w411 beat_queue (
        .clk(clk), .rst(rst), .in_valid(beat_valid), .in_ready(beat_ready),
        .in_data({
            beat_thread, beat_address, beat_last, beat_x0, beat_y0, beat_z0, beat_x1, beat_y1, beat_z1, beat_x2,
            beat_y2, beat_z2, beat_x3, beat_y3, beat_z3
        }),
        .out_valid(beat_queue_out_valid), .out_ready(beat_queue_out_ready), .out_data(beat_queue_out_data)
    );

    search_distance distance (
        .clk(clk), .rst(rst), .in_valid(query_valid), .in_ready(distance_in_ready), .in_thread(points_thread),
        .in_address(points_address), .in_last(points_last), .in_x0(points_x0), .in_y0(points_y0),
        .in_z0(points_z0), .in_x1(points_x1), .in_y1(points_y1), .in_z1(points_z1), .in_x2(points_x2),
        .in_y2(points_y2), .in_z2(points_z2), .in_x3(points_x3), .in_y3(points_y3), .in_z3(points_z3),
        .in_query_x(query[95:64]), .in_query_y(query[63:32]), .in_query_z(query[31:0]),
        .out_valid(candidates_valid), .out_ready(candidates_ready), .out_thread(candidates_thread),
        .out_address(candidates_address), .out_last(candidates_last), .out_distance0(candidates_distance0),
        .out_distance1(candidates_distance1), .out_distance2(candidates_distance2),
        .out_distance3(candidates_distance3)
    );

    always @(posedge clk) begin
        if (rst) begin
            query_valid <= 1'd0;
            query_empty <= 1'd1;
        end else begin
            query_valid <= query_valid_choice;
            query_empty <= ~query_valid_choice;
        end
    end
    always @(posedge clk) begin
        if (query_advance) begin
            points_thread <= beat_queue_out_thread;
            points_address <= beat_queue_out_address;
            points_last <= beat_queue_out_last;
            points_x0 <= beat_queue_out_x0;
            points_y0 <= beat_queue_out_y0;
            points_z0 <= beat_queue_out_z0;
            points_x1 <= beat_queue_out_x1;
            points_y1 <= beat_queue_out_y1;
            points_z1 <= beat_queue_out_z1;
            points_x2 <= beat_queue_out_x2;
            points_y2 <= beat_queue_out_y2;
            points_z2 <= beat_queue_out_z2;
            points_x3 <= beat_queue_out_x3;
            points_y3 <= beat_queue_out_y3;
            points_z3 <= beat_queue_out_z3;
        end
    end

    wire _unused = &{1'b0, start_k, start_number, start_radius2};

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        start_radius2_in_range: assert (~start_valid | (start_radius2 < 32'h80000000));
        query_valid_or_empty: assert (query_valid ^ query_empty);
`else
        if (!(~start_valid | (start_radius2 < 32'h80000000))) begin
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
// latency = 23
// initiation_interval = 1
module search_distance (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [3:0] in_thread,
    input  wire [21:0] in_address, input wire in_last, input wire [31:0] in_x0,
    input  wire [31:0] in_y0, input wire [31:0] in_z0, input wire [31:0] in_x1,
    input  wire [31:0] in_y1, input wire [31:0] in_z1, input wire [31:0] in_x2,
    input  wire [31:0] in_y2, input wire [31:0] in_z2, input wire [31:0] in_x3,
    input  wire [31:0] in_y3, input wire [31:0] in_z3, input wire [31:0] in_query_x,
    input  wire [31:0] in_query_y, input wire [31:0] in_query_z,
    output wire out_valid, input wire out_ready, output wire [3:0] out_thread,
    output wire [21:0] out_address, output wire out_last, output wire [30:0] out_distance0,
    output wire [30:0] out_distance1, output wire [30:0] out_distance2, output wire [30:0] out_distance3
);
    (* ram_style = "distributed" *)
    reg [95:0] delay_6_from_0 [0:4];
    (* ram_style = "distributed" *)
    reg [31:0] delay_6_from_0_copy2 [0:4];
    (* ram_style = "distributed" *)
    reg [26:0] delay_23_from_0 [0:21];
    reg [5:0] credits;
    reg [2:0] delay_6_from_0_pointer;
    reg [95:0] delay_6_from_0_out;
    reg [2:0] delay_6_from_0_copy2_pointer;
    reg [31:0] delay_6_from_0_copy2_out;
    reg [4:0] delay_23_from_0_pointer;
    reg [26:0] delay_23_from_0_out;
    reg [22:0] in_flight;
    reg left;

    wire [31:0] add_f32_ftz_unit_y, add_f32_ftz_unit_copy2_y, add_f32_ftz_unit_copy3_y, add_f32_ftz_unit_copy4_y;
    wire [31:0] add_f32_ftz_unit_copy5_y, add_f32_ftz_unit_copy6_y, add_f32_ftz_unit_copy7_y;
    wire [31:0] add_f32_ftz_unit_copy8_y, add_f32_ftz_unit_copy9_y, add_f32_ftz_unit_copy10_y;
    wire [31:0] add_f32_ftz_unit_copy11_y, add_f32_ftz_unit_copy12_y, add_f32_ftz_unit_copy13_y;
    wire [31:0] add_f32_ftz_unit_copy14_y, add_f32_ftz_unit_copy15_y, add_f32_ftz_unit_copy16_y;
    wire [31:0] add_f32_ftz_unit_copy17_y, add_f32_ftz_unit_copy18_y, add_f32_ftz_unit_copy19_y;
    wire [31:0] add_f32_ftz_unit_copy20_y, mul_f32_ftz_unit_y, mul_f32_ftz_unit_copy2_y, mul_f32_ftz_unit_copy3_y;
    wire [31:0] mul_f32_ftz_unit_copy4_y, mul_f32_ftz_unit_copy5_y, mul_f32_ftz_unit_copy6_y;
    wire [31:0] mul_f32_ftz_unit_copy7_y, mul_f32_ftz_unit_copy8_y, mul_f32_ftz_unit_copy9_y;
    wire [31:0] mul_f32_ftz_unit_copy10_y, mul_f32_ftz_unit_copy11_y, mul_f32_ftz_unit_copy12_y;
    wire queue_1_in_ready;
    wire [119:0] queue_1_out_data;
    wire queue_2_in_ready, queue_2_out_valid;

    assign in_ready = ~credits[5];
    wire [31:0] minus_in_query_x = {~in_query_x[31], in_query_x[30:0]};
    wire [31:0] minus_in_query_y = {~in_query_y[31], in_query_y[30:0]};
    wire [31:0] minus_in_query_z = {~in_query_z[31], in_query_z[30:0]};
    wire [31:0] offset_z_squared_d6 = delay_6_from_0_out[31:0];
    wire [31:0] offset_z_squared_d6_copy2 = delay_6_from_0_out[63:32];
    wire [31:0] offset_z_squared_d6_copy3 = delay_6_from_0_out[95:64];
    wire kept = in_flight[22];
    wire [3:0] thread_d23 = delay_23_from_0_out[3:0];
    wire [21:0] address_d23 = delay_23_from_0_out[25:4];
    wire last_d23 = delay_23_from_0_out[26];
    wire in_valid_and_in_ready = in_valid & in_ready;

    assign {out_thread, out_address, out_last, out_distance0, out_distance1, out_distance2} = queue_1_out_data;

    float_add_s6_f32ftz add_f32_ftz_unit (
        .clk(clk), .enable(1'd1), .a(in_x0), .b(minus_in_query_x), .y(add_f32_ftz_unit_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(in_y0), .b(minus_in_query_y), .y(add_f32_ftz_unit_copy2_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy3 (
        .clk(clk), .enable(1'd1), .a(in_z0), .b(minus_in_query_z), .y(add_f32_ftz_unit_copy3_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy4 (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_y), .b(mul_f32_ftz_unit_copy2_y),
        .y(add_f32_ftz_unit_copy4_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy5 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy4_y), .b(offset_z_squared_d6),
        .y(add_f32_ftz_unit_copy5_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy6 (
        .clk(clk), .enable(1'd1), .a(minus_in_query_x), .b(in_x1), .y(add_f32_ftz_unit_copy6_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy7 (
        .clk(clk), .enable(1'd1), .a(minus_in_query_y), .b(in_y1), .y(add_f32_ftz_unit_copy7_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy8 (
        .clk(clk), .enable(1'd1), .a(minus_in_query_z), .b(in_z1), .y(add_f32_ftz_unit_copy8_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy9 (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_copy4_y), .b(mul_f32_ftz_unit_copy5_y),
        .y(add_f32_ftz_unit_copy9_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy10 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy9_y), .b(offset_z_squared_d6_copy2),
        .y(add_f32_ftz_unit_copy10_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy11 (
        .clk(clk), .enable(1'd1), .a(minus_in_query_x), .b(in_x2), .y(add_f32_ftz_unit_copy11_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy12 (
        .clk(clk), .enable(1'd1), .a(minus_in_query_y), .b(in_y2), .y(add_f32_ftz_unit_copy12_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy13 (
        .clk(clk), .enable(1'd1), .a(minus_in_query_z), .b(in_z2), .y(add_f32_ftz_unit_copy13_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy14 (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_copy7_y), .b(mul_f32_ftz_unit_copy8_y),
        .y(add_f32_ftz_unit_copy14_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy15 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy14_y), .b(offset_z_squared_d6_copy3),
        .y(add_f32_ftz_unit_copy15_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy16 (
        .clk(clk), .enable(1'd1), .a(minus_in_query_x), .b(in_x3), .y(add_f32_ftz_unit_copy16_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy17 (
        .clk(clk), .enable(1'd1), .a(minus_in_query_y), .b(in_y3), .y(add_f32_ftz_unit_copy17_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy18 (
        .clk(clk), .enable(1'd1), .a(minus_in_query_z), .b(in_z3), .y(add_f32_ftz_unit_copy18_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy19 (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_copy10_y), .b(mul_f32_ftz_unit_copy11_y),
        .y(add_f32_ftz_unit_copy19_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy20 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy19_y), .b(delay_6_from_0_copy2_out),
        .y(add_f32_ftz_unit_copy20_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_y), .b(add_f32_ftz_unit_y), .y(mul_f32_ftz_unit_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy2_y), .b(add_f32_ftz_unit_copy2_y),
        .y(mul_f32_ftz_unit_copy2_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy3 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy3_y), .b(add_f32_ftz_unit_copy3_y),
        .y(mul_f32_ftz_unit_copy3_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy4 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy6_y), .b(add_f32_ftz_unit_copy6_y),
        .y(mul_f32_ftz_unit_copy4_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy5 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy7_y), .b(add_f32_ftz_unit_copy7_y),
        .y(mul_f32_ftz_unit_copy5_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy6 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy8_y), .b(add_f32_ftz_unit_copy8_y),
        .y(mul_f32_ftz_unit_copy6_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy7 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy11_y), .b(add_f32_ftz_unit_copy11_y),
        .y(mul_f32_ftz_unit_copy7_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy8 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy12_y), .b(add_f32_ftz_unit_copy12_y),
        .y(mul_f32_ftz_unit_copy8_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy9 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy13_y), .b(add_f32_ftz_unit_copy13_y),
        .y(mul_f32_ftz_unit_copy9_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy10 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy16_y), .b(add_f32_ftz_unit_copy16_y),
        .y(mul_f32_ftz_unit_copy10_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy11 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy17_y), .b(add_f32_ftz_unit_copy17_y),
        .y(mul_f32_ftz_unit_copy11_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy12 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy18_y), .b(add_f32_ftz_unit_copy18_y),
        .y(mul_f32_ftz_unit_copy12_y)
    );

    stream_fifo_d27_w120_distributed queue_1 (
        .clk(clk), .rst(rst), .in_valid(kept), .in_ready(queue_1_in_ready),
        .in_data({
            thread_d23, address_d23, last_d23, add_f32_ftz_unit_copy5_y[30:0], add_f32_ftz_unit_copy10_y[30:0],
            add_f32_ftz_unit_copy15_y[30:0]
        }),
        .out_valid(out_valid), .out_ready(out_ready), .out_data(queue_1_out_data)
    );

    stream_fifo_d27_w31_distributed queue_2 (
        .clk(clk), .rst(rst), .in_valid(kept), .in_ready(queue_2_in_ready),
        .in_data(add_f32_ftz_unit_copy20_y[30:0]),
        .out_valid(queue_2_out_valid), .out_ready(out_ready), .out_data(out_distance3)
    );

    always @(posedge clk) begin
        if (rst) begin
            credits <= 6'd26;
            delay_6_from_0_pointer <= 3'd0;
            delay_6_from_0_copy2_pointer <= 3'd0;
            delay_23_from_0_pointer <= 5'd0;
            in_flight <= 23'd0;
            left <= 1'd0;
        end else begin
            credits <= (credits - {5'd0, in_valid_and_in_ready}) + {5'd0, left};
            delay_6_from_0_pointer <= (delay_6_from_0_pointer == 3'd4) ? (delay_6_from_0_pointer - 3'd4) : (delay_6_from_0_pointer + 3'd1);
            delay_6_from_0_copy2_pointer <= (delay_6_from_0_copy2_pointer == 3'd4) ? (delay_6_from_0_copy2_pointer - 3'd4) : (delay_6_from_0_copy2_pointer + 3'd1);
            delay_23_from_0_pointer <= (delay_23_from_0_pointer == 5'd21) ? (delay_23_from_0_pointer - 5'd21) : (delay_23_from_0_pointer + 5'd1);
            in_flight <= {in_flight[21:0], in_valid_and_in_ready};
            left <= out_valid & out_ready;
        end
    end
    always @(posedge clk) begin
        delay_6_from_0[delay_6_from_0_pointer] <= {mul_f32_ftz_unit_copy9_y, mul_f32_ftz_unit_copy6_y, mul_f32_ftz_unit_copy3_y};
        delay_6_from_0_out <= delay_6_from_0[delay_6_from_0_pointer];
    end
    always @(posedge clk) begin
        delay_6_from_0_copy2[delay_6_from_0_copy2_pointer] <= mul_f32_ftz_unit_copy12_y;
        delay_6_from_0_copy2_out <= delay_6_from_0_copy2[delay_6_from_0_copy2_pointer];
    end
    always @(posedge clk) begin
        delay_23_from_0[delay_23_from_0_pointer] <= {in_last, in_address, in_thread};
        delay_23_from_0_out <= delay_23_from_0[delay_23_from_0_pointer];
    end

    wire _unused = &{
        1'b0, add_f32_ftz_unit_copy10_y[31], add_f32_ftz_unit_copy15_y[31], add_f32_ftz_unit_copy20_y[31],
        add_f32_ftz_unit_copy5_y[31], queue_1_in_ready, queue_2_in_ready, queue_2_out_valid
    };

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        queue_1_has_a_place_for_each_result: assert (~kept | queue_1_in_ready);
        queue_2_has_a_place_for_each_result: assert (~kept | queue_2_in_ready);
        queue_2_in_step: assert (queue_2_out_valid == out_valid);
`else
        if (!(~kept | queue_1_in_ready)) begin
            $display("assertion failed: queue_1_has_a_place_for_each_result in %m"); $stop;
        end
        if (!(~kept | queue_2_in_ready)) begin
            $display("assertion failed: queue_2_has_a_place_for_each_result in %m"); $stop;
        end
        if (!(queue_2_out_valid == out_valid)) begin
            $display("assertion failed: queue_2_in_step in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue in a memory with a registered output.
// depth = 27
// width = 31
// storage = distributed
module stream_fifo_d27_w31_distributed (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [30:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [30:0] out_data
);
    (* ram_style = "distributed" *)
    reg [30:0] entries [0:26];
    reg [4:0] held, waiting;
    reg is_full, any_waits;
    reg [4:0] write_address, read_address;
    reg [30:0] item;

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
                is_full <= push & (held == 5'd26);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 5'd1);
            end
            if (push) write_address <= (write_address == 5'd26) ? 5'd0 : (write_address + 5'd1);
            if (fetch) read_address <= (read_address == 5'd26) ? 5'd0 : (read_address + 5'd1);
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
        held_in_range: assert (held <= 5'd27);
        held_is_waiting_and_shown: assert (held == (waiting + {4'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 5'd27)) & (any_waits == |waiting));
`else
        if (!(held <= 5'd27)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {4'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 5'd27)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue in a memory with a registered output.
// depth = 27
// width = 120
// storage = distributed
module stream_fifo_d27_w120_distributed (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [119:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [119:0] out_data
);
    (* ram_style = "distributed" *)
    reg [119:0] entries [0:26];
    reg [4:0] held, waiting;
    reg is_full, any_waits;
    reg [4:0] write_address, read_address;
    reg [119:0] item;

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
                is_full <= push & (held == 5'd26);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 5'd1);
            end
            if (push) write_address <= (write_address == 5'd26) ? 5'd0 : (write_address + 5'd1);
            if (fetch) read_address <= (read_address == 5'd26) ? 5'd0 : (read_address + 5'd1);
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
        held_in_range: assert (held <= 5'd27);
        held_is_waiting_and_shown: assert (held == (waiting + {4'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 5'd27)) & (any_waits == |waiting));
`else
        if (!(held <= 5'd27)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {4'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 5'd27)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue of two in registers.
// width = 411
module stream_skid_w411 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [410:0] in_data,
    output wire out_valid, input wire out_ready, output wire [410:0] out_data
);
    reg head_filled, second_filled, room;
    reg [410:0] head, second;

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
// threads = 16
module search_recursion (
    input  wire clk, input wire rst,
    input  wire start_valid,  // A thread taking up a query.
    input  wire [3:0] start_thread,  // Thread.
    input  wire [23:0] start_number,  // Its number, which its results bear.
    input  wire [5:0] start_k,  // Neighbors wanted.
    input  wire [31:0] start_radius2,  // Squared radius within which neighbors count.
    input  wire [31:0] start_x,  // Where.
    input  wire [31:0] start_y,  // Where.
    input  wire [31:0] start_z,  // Where.
    input  wire radius_valid,  // A thread's new radius.
    input  wire [3:0] radius_thread,  // Thread.
    input  wire [30:0] radius_radius2,  // Squared radius.
    input  wire in_valid, output wire in_ready,  // Threads that want their next path.
    input  wire [3:0] in_thread,  // Thread.
    input  wire top_empty,  // The stack of the last pop was empty.
    input  wire [20:0] top_node,  // The subtree's root.
    input  wire [30:0] top_distance2,  // Squared distance of the query to the splitting plane before it.
    output wire resume_valid, input wire resume_ready,  // Descents from a path that was not taken before.
    output wire [3:0] resume_thread,  // Thread.
    output wire [20:0] resume_node,  // Node: 1 is the root, `2i` and `2i + 1` are the children of `i`.
    output wire pop_valid,  // A thread that wants its last path back.
    output wire [3:0] pop_thread,  // Thread.
    output reg  empty_valid,  // A thread without a path left.
    output reg  [3:0] empty_thread,  // Thread.
    output reg  event_pop  // A path was popped.
);
    (* ram_style = "distributed" *)
    reg [30:0] query_radii [0:15];
    (* ram_style = "distributed" *)
    reg [30:0] leaf_radii [0:15];
    reg r0_valid, r1_valid, r2_valid, r2_empty;
    reg [3:0] r0_thread, r1_thread, r2_thread;
    reg found;
    reg [20:0] path_node;  // The subtree's root.
    reg [30:0] path_distance2;  // Squared distance of the query to the splitting plane before it.
    reg [15:0] from_leaf;
    reg [30:0] radius2;

    wire in_queue_out_valid;
    wire [3:0] in_queue_out_data;
    wire resume_queue_in_ready;
    wire [24:0] resume_queue_out_data;

    wire pops = (r2_empty | resume_queue_in_ready) & r0_valid;
    wire advance = ~r2_valid | resume_queue_in_ready;
    wire decides = advance & r2_valid;
    wire popped = decides & found;
    wire nearer = path_distance2 < radius2;
    wire back = popped & ~nearer;
    wire in_queue_out_ready = advance & ~back;
    wire r2_valid_choice = advance ? r1_valid : r2_valid;
    wire query_set_both = start_valid & (start_thread[3:2] == 2'd3);
    wire start_thread_1_0_is_3 = start_thread[1:0] == 2'd3;
    wire start_thread_1_0_is_2 = start_thread[1:0] == 2'd2;
    wire start_thread_1_0_is_1 = start_thread[1:0] == 2'd1;
    wire start_thread_1_0_is_0 = start_thread[1:0] == 2'd0;
    wire query_set_both_2 = start_valid & (start_thread[3:2] == 2'd2);
    wire query_set_both_3 = start_valid & (start_thread[3:2] == 2'd1);
    wire query_set_both_4 = start_valid & (start_thread[3:2] == 2'd0);
    wire [15:0] query_set = {
        query_set_both & start_thread_1_0_is_3, query_set_both & start_thread_1_0_is_2,
        query_set_both & start_thread_1_0_is_1, query_set_both & start_thread_1_0_is_0,
        query_set_both_2 & start_thread_1_0_is_3, query_set_both_2 & start_thread_1_0_is_2,
        query_set_both_2 & start_thread_1_0_is_1, query_set_both_2 & start_thread_1_0_is_0,
        query_set_both_3 & start_thread_1_0_is_3, query_set_both_3 & start_thread_1_0_is_2,
        query_set_both_3 & start_thread_1_0_is_1, query_set_both_3 & start_thread_1_0_is_0,
        query_set_both_4 & start_thread_1_0_is_3, query_set_both_4 & start_thread_1_0_is_2,
        query_set_both_4 & start_thread_1_0_is_1, query_set_both_4 & start_thread_1_0_is_0
    };
    wire leaf_set_both = radius_valid & (radius_thread[3:2] == 2'd3);
    wire radius_thread_1_0_is_3 = radius_thread[1:0] == 2'd3;
    wire radius_thread_1_0_is_2 = radius_thread[1:0] == 2'd2;
    wire radius_thread_1_0_is_1 = radius_thread[1:0] == 2'd1;
    wire radius_thread_1_0_is_0 = radius_thread[1:0] == 2'd0;
    wire leaf_set_both_2 = radius_valid & (radius_thread[3:2] == 2'd2);
    wire leaf_set_both_3 = radius_valid & (radius_thread[3:2] == 2'd1);
    wire leaf_set_both_4 = radius_valid & (radius_thread[3:2] == 2'd0);
    wire [15:0] leaf_set = {
        leaf_set_both & radius_thread_1_0_is_3, leaf_set_both & radius_thread_1_0_is_2,
        leaf_set_both & radius_thread_1_0_is_1, leaf_set_both & radius_thread_1_0_is_0,
        leaf_set_both_2 & radius_thread_1_0_is_3, leaf_set_both_2 & radius_thread_1_0_is_2,
        leaf_set_both_2 & radius_thread_1_0_is_1, leaf_set_both_2 & radius_thread_1_0_is_0,
        leaf_set_both_3 & radius_thread_1_0_is_3, leaf_set_both_3 & radius_thread_1_0_is_2,
        leaf_set_both_3 & radius_thread_1_0_is_1, leaf_set_both_3 & radius_thread_1_0_is_0,
        leaf_set_both_4 & radius_thread_1_0_is_3, leaf_set_both_4 & radius_thread_1_0_is_2,
        leaf_set_both_4 & radius_thread_1_0_is_1, leaf_set_both_4 & radius_thread_1_0_is_0
    };
    wire [15:0] from_leaf_shifted_by_r1_thread = from_leaf >> r1_thread;
    wire [30:0] leaf_radius2 = leaf_radii[r1_thread];
    wire [30:0] query_radius2 = query_radii[r1_thread];

    assign {resume_thread, resume_node} = resume_queue_out_data;
    assign pop_valid = pops;
    assign pop_thread = r0_thread;

    stream_skid_w4 in_queue (
        .clk(clk), .rst(rst), .in_valid(in_valid), .in_ready(in_ready), .in_data(in_thread),
        .out_valid(in_queue_out_valid), .out_ready(in_queue_out_ready), .out_data(in_queue_out_data)
    );

    stream_skid_w25 resume_queue (
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
    always @(posedge clk) if (start_valid) query_radii[start_thread] <= start_radius2[30:0];
    always @(posedge clk) if (radius_valid) leaf_radii[radius_thread] <= radius_radius2;

    wire _unused = &{
        1'b0, from_leaf_shifted_by_r1_thread[15:1], start_k, start_number, start_radius2[31], start_x,
        start_y, start_z
    };

`ifdef RTL_ASSERT
    reg [15:0] begun;

    wire [15:0] begun_shifted_by_r0_thread = begun >> r0_thread;

    always @(posedge clk) begin
        if (rst) begun <= 16'd0;
        else begun <= begun | query_set;
    end

    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        start_radius2_in_range: assert (~start_valid | (start_radius2 < 32'h80000000));
        a_query_begins_before_its_thread_pops: assert (~r0_valid | begun_shifted_by_r0_thread[0]);
        r2_valid_or_empty: assert (r2_valid ^ r2_empty);
`else
        if (!(~start_valid | (start_radius2 < 32'h80000000))) begin
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

    wire _unused_by_checks = &{1'b0, begun_shifted_by_r0_thread[15:1]};
`endif
endmodule

// Queue of two in registers.
// width = 4
module stream_skid_w4 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [3:0] in_data,
    output wire out_valid, input wire out_ready, output wire [3:0] out_data
);
    reg head_filled, second_filled, room;
    reg [3:0] head, second;

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
// threads = 16
// depth = 20
module search_stack (
    input  wire clk, input wire rst,
    input  wire push_valid,  // A path to remember.
    input  wire [3:0] push_thread,  // Thread.
    input  wire [20:0] push_node,  // The subtree's root.
    input  wire [30:0] push_distance2,  // Squared distance of the query to the splitting plane before it.
    input  wire pop_valid,  // A thread that wants its last path back.
    input  wire [3:0] pop_thread,  // Thread.
    output reg  top_empty,  // The stack of the last pop was empty.
    output wire [20:0] top_node,  // The subtree's root.
    output wire [30:0] top_distance2  // Squared distance of the query to the splitting plane before it.
);
    reg [4:0] depth_0, depth_1, depth_2, depth_3, depth_4, depth_5, depth_6, depth_7, depth_8, depth_9, depth_10;
    reg [4:0] depth_11, depth_12, depth_13, depth_14, depth_15;
    wire [51:0] top;

    wire [4:0] push_depth_choice = push_thread[1] ? (push_thread[0] ? depth_15 : depth_14) : push_thread[0] ? depth_13 : depth_12;
    wire [4:0] push_depth_choice_2 = push_thread[1] ? (push_thread[0] ? depth_11 : depth_10) : push_thread[0] ? depth_9 : depth_8;
    wire [4:0] push_depth_choice_3 = push_thread[1] ? (push_thread[0] ? depth_7 : depth_6) : push_thread[0] ? depth_5 : depth_4;
    wire [4:0] push_depth_choice_4 = push_thread[1] ? (push_thread[0] ? depth_3 : depth_2) : push_thread[0] ? depth_1 : depth_0;
    wire [4:0] push_depth = push_thread[3] ? (push_thread[2] ? push_depth_choice : push_depth_choice_2) : push_thread[2] ? push_depth_choice_3 : push_depth_choice_4;
    wire [4:0] pop_depth_choice = pop_thread[1] ? (pop_thread[0] ? depth_15 : depth_14) : pop_thread[0] ? depth_13 : depth_12;
    wire [4:0] pop_depth_choice_2 = pop_thread[1] ? (pop_thread[0] ? depth_11 : depth_10) : pop_thread[0] ? depth_9 : depth_8;
    wire [4:0] pop_depth_choice_3 = pop_thread[1] ? (pop_thread[0] ? depth_7 : depth_6) : pop_thread[0] ? depth_5 : depth_4;
    wire [4:0] pop_depth_choice_4 = pop_thread[1] ? (pop_thread[0] ? depth_3 : depth_2) : pop_thread[0] ? depth_1 : depth_0;
    wire [4:0] pop_depth = pop_thread[3] ? (pop_thread[2] ? pop_depth_choice : pop_depth_choice_2) : pop_thread[2] ? pop_depth_choice_3 : pop_depth_choice_4;
    wire takes = pop_valid & |pop_depth;
    wire up_both = push_valid & (push_thread[3:2] == 2'd3);
    wire push_thread_1_0_is_3 = push_thread[1:0] == 2'd3;
    wire push_thread_1_0_is_2 = push_thread[1:0] == 2'd2;
    wire push_thread_1_0_is_1 = push_thread[1:0] == 2'd1;
    wire push_thread_1_0_is_0 = push_thread[1:0] == 2'd0;
    wire up_both_2 = push_valid & (push_thread[3:2] == 2'd2);
    wire up_both_3 = push_valid & (push_thread[3:2] == 2'd1);
    wire up_both_4 = push_valid & (push_thread[3:2] == 2'd0);
    wire [15:0] up = {
        up_both & push_thread_1_0_is_3, up_both & push_thread_1_0_is_2, up_both & push_thread_1_0_is_1,
        up_both & push_thread_1_0_is_0, up_both_2 & push_thread_1_0_is_3, up_both_2 & push_thread_1_0_is_2,
        up_both_2 & push_thread_1_0_is_1, up_both_2 & push_thread_1_0_is_0, up_both_3 & push_thread_1_0_is_3,
        up_both_3 & push_thread_1_0_is_2, up_both_3 & push_thread_1_0_is_1, up_both_3 & push_thread_1_0_is_0,
        up_both_4 & push_thread_1_0_is_3, up_both_4 & push_thread_1_0_is_2, up_both_4 & push_thread_1_0_is_1,
        up_both_4 & push_thread_1_0_is_0
    };
    wire down_both = takes & (pop_thread[3:2] == 2'd3);
    wire pop_thread_1_0_is_3 = pop_thread[1:0] == 2'd3;
    wire pop_thread_1_0_is_2 = pop_thread[1:0] == 2'd2;
    wire pop_thread_1_0_is_1 = pop_thread[1:0] == 2'd1;
    wire pop_thread_1_0_is_0 = pop_thread[1:0] == 2'd0;
    wire down_both_2 = takes & (pop_thread[3:2] == 2'd2);
    wire down_both_3 = takes & (pop_thread[3:2] == 2'd1);
    wire down_both_4 = takes & (pop_thread[3:2] == 2'd0);
    wire [15:0] down = {
        down_both & pop_thread_1_0_is_3, down_both & pop_thread_1_0_is_2, down_both & pop_thread_1_0_is_1,
        down_both & pop_thread_1_0_is_0, down_both_2 & pop_thread_1_0_is_3, down_both_2 & pop_thread_1_0_is_2,
        down_both_2 & pop_thread_1_0_is_1, down_both_2 & pop_thread_1_0_is_0,
        down_both_3 & pop_thread_1_0_is_3, down_both_3 & pop_thread_1_0_is_2,
        down_both_3 & pop_thread_1_0_is_1, down_both_3 & pop_thread_1_0_is_0,
        down_both_4 & pop_thread_1_0_is_3, down_both_4 & pop_thread_1_0_is_2,
        down_both_4 & pop_thread_1_0_is_1, down_both_4 & pop_thread_1_0_is_0
    };

    assign {top_node, top_distance2} = top;

    memory_1w1r_unordered #(.WIDTH(52), .DEPTH(512)) paths (
        .clk(clk), .write(push_valid), .write_address({push_thread, push_depth}),
        .write_data({push_node, push_distance2}),
        .read(takes), .read_address({pop_thread, pop_depth - 5'd1}), .read_data(top)
    );

    always @(posedge clk) begin
        if (rst) begin
            depth_0 <= 5'd0;
            depth_1 <= 5'd0;
            depth_2 <= 5'd0;
            depth_3 <= 5'd0;
            depth_4 <= 5'd0;
            depth_5 <= 5'd0;
            depth_6 <= 5'd0;
            depth_7 <= 5'd0;
            depth_8 <= 5'd0;
            depth_9 <= 5'd0;
            depth_10 <= 5'd0;
            depth_11 <= 5'd0;
            depth_12 <= 5'd0;
            depth_13 <= 5'd0;
            depth_14 <= 5'd0;
            depth_15 <= 5'd0;
            top_empty <= 1'd1;
        end else begin
            if (up[0] | down[0]) depth_0 <= up[0] ? (depth_0 + 5'd1) : (depth_0 - 5'd1);
            if (up[1] | down[1]) depth_1 <= up[1] ? (depth_1 + 5'd1) : (depth_1 - 5'd1);
            if (up[2] | down[2]) depth_2 <= up[2] ? (depth_2 + 5'd1) : (depth_2 - 5'd1);
            if (up[3] | down[3]) depth_3 <= up[3] ? (depth_3 + 5'd1) : (depth_3 - 5'd1);
            if (up[4] | down[4]) depth_4 <= up[4] ? (depth_4 + 5'd1) : (depth_4 - 5'd1);
            if (up[5] | down[5]) depth_5 <= up[5] ? (depth_5 + 5'd1) : (depth_5 - 5'd1);
            if (up[6] | down[6]) depth_6 <= up[6] ? (depth_6 + 5'd1) : (depth_6 - 5'd1);
            if (up[7] | down[7]) depth_7 <= up[7] ? (depth_7 + 5'd1) : (depth_7 - 5'd1);
            if (up[8] | down[8]) depth_8 <= up[8] ? (depth_8 + 5'd1) : (depth_8 - 5'd1);
            if (up[9] | down[9]) depth_9 <= up[9] ? (depth_9 + 5'd1) : (depth_9 - 5'd1);
            if (up[10] | down[10]) depth_10 <= up[10] ? (depth_10 + 5'd1) : (depth_10 - 5'd1);
            if (up[11] | down[11]) depth_11 <= up[11] ? (depth_11 + 5'd1) : (depth_11 - 5'd1);
            if (up[12] | down[12]) depth_12 <= up[12] ? (depth_12 + 5'd1) : (depth_12 - 5'd1);
            if (up[13] | down[13]) depth_13 <= up[13] ? (depth_13 + 5'd1) : (depth_13 - 5'd1);
            if (up[14] | down[14]) depth_14 <= up[14] ? (depth_14 + 5'd1) : (depth_14 - 5'd1);
            if (up[15] | down[15]) depth_15 <= up[15] ? (depth_15 + 5'd1) : (depth_15 - 5'd1);
            if (pop_valid) top_empty <= pop_depth == 5'd0;
        end
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        stack_has_room: assert (~push_valid | (push_depth < 5'd20));
        one_access_a_thread: assert (~(push_valid & pop_valid & (push_thread == pop_thread)));
`else
        if (!(~push_valid | (push_depth < 5'd20))) begin
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
// threads = 16
// tree_depth = 20
module search_traversal (
    input  wire clk, input wire rst,
    input  wire start_valid,  // A thread taking up a query.
    input  wire [3:0] start_thread,  // Thread.
    input  wire [23:0] start_number,  // Its number, which its results bear.
    input  wire [5:0] start_k,  // Neighbors wanted.
    input  wire [31:0] start_radius2,  // Squared radius within which neighbors count.
    input  wire [31:0] start_x,  // Where.
    input  wire [31:0] start_y,  // Where.
    input  wire [31:0] start_z,  // Where.
    input  wire descend_valid, output wire descend_ready,  // Descents from the root.
    input  wire [3:0] descend_thread,  // Thread.
    input  wire [20:0] descend_node,  // Node: 1 is the root, `2i` and `2i + 1` are the children of `i`.
    input  wire resume_valid, output wire resume_ready,  // Descents from a path that was not taken before.
    input  wire [3:0] resume_thread,  // Thread.
    input  wire [20:0] resume_node,  // Node: 1 is the root, `2i` and `2i + 1` are the children of `i`.
    output wire leaf_valid, input wire leaf_ready,  // Leaves reached.
    output wire [3:0] leaf_thread,  // Thread.
    output wire [19:0] leaf_leaf,  // The leaf's number among those of the deepest level (eq. 6.7).
    output wire node_valid, input wire node_ready,  // Nodes wanted of the tree cache.
    output wire [3:0] node_thread,  // Thread.
    output wire [20:0] node_node,  // Node: 1 is the root, `2i` and `2i + 1` are the children of `i`.
    input  wire record_valid, output wire record_ready,  // Nodes from the tree cache.
    input  wire [3:0] record_thread,  // Thread.
    input  wire [20:0] record_node,  // Node: 1 is the root, `2i` and `2i + 1` are the children of `i`.
    input  wire [31:0] record_split,  // Where its plane cuts its dimension.
    input  wire [1:0] record_dimension,  // Its dimension.
    input  wire record_internal_leaf,  // It is a leaf.
    output reg  event_node,  // A node was visited.
    output wire push_valid,  // A path to remember.
    output wire [3:0] push_thread,  // Thread.
    output wire [20:0] push_node,  // The subtree's root.
    output wire [30:0] push_distance2,  // Squared distance of the query to the splitting plane before it.
    output wire reached_valid,  // A thread's descent ended in a leaf.
    output wire [3:0] reached_thread  // Thread.
);
    reg f_valid;
    reg [3:0] f_thread;  // Thread.
    reg [20:0] f_node;  // Node: 1 is the root, `2i` and `2i + 1` are the children of `i`.
    reg v_valid;
    reg [3:0] v_thread;  // Thread.
    reg [20:0] v_node;  // Node: 1 is the root, `2i` and `2i + 1` are the children of `i`.
    reg s_valid;
    reg [3:0] s_thread;  // Thread.
    reg [20:0] s_node;  // Node: 1 is the root, `2i` and `2i + 1` are the children of `i`.
    reg f_is_child, s_at_leaf;
    reg [31:0] s_coordinate, s_split;
    reg [1:0] s_dimension;
    reg [31:0] v_split;  // Where its plane cuts its dimension.
    reg [1:0] v_dimension;  // Its dimension.
    reg v_internal_leaf;  // It is a leaf.
    reg [4:0] v_places;
    wire [95:0] query;

    wire descend_queue_out_valid;
    wire [24:0] descend_queue_out_data;
    wire resume_queue_out_valid;
    wire [24:0] resume_queue_out_data;
    wire leaf_queue_in_ready;
    wire [23:0] leaf_queue_out_data;
    wire path_in_ready, path_out_valid, path_out_is_leaf, node_queue_in_ready;
    wire [24:0] node_queue_out_data;
    wire record_queue_out_valid;
    wire [59:0] record_queue_out_data;
    wire less_x_y, less_y_y, less_z_y;

    wire at_leaf = v_node[20] | v_internal_leaf;
    wire reaches = v_valid & at_leaf;
    wire proceeds = node_queue_in_ready & (~reaches | leaf_queue_in_ready);
    wire advance = path_in_ready & proceeds;
    wire [3:0] record_queue_out_thread = record_queue_out_data[59:56];
    wire descends = v_valid & ~at_leaf;
    wire resumes = resume_queue_out_valid & ~descends;
    wire descend_queue_out_ready = advance & ~(descends | resumes);
    wire resume_queue_out_ready = advance & ~descends;
    wire [20:0] v_node_shifted_by_v_places = v_node << v_places;
    wire left = s_dimension[1] ? less_z_y : s_dimension[0] ? less_y_y : less_x_y;
    wire [3:0] resume_queue_out_thread = resume_queue_out_data[24:21];
    wire [3:0] descend_queue_out_thread = descend_queue_out_data[24:21];
    wire [3:0] f_thread_choice = resume_queue_out_valid ? resume_queue_out_thread : descend_queue_out_thread;
    wire [20:0] resume_queue_out_node = resume_queue_out_data[20:0];
    wire [20:0] descend_queue_out_node = descend_queue_out_data[20:0];
    wire [20:0] next_node_choice = resume_queue_out_valid ? resume_queue_out_node : descend_queue_out_node;
    wire [20:0] next_node = descends ? {v_node[19:0], 1'd0} : next_node_choice;
    wire [20:0] record_queue_out_node = record_queue_out_data[55:35];
    wire [31:0] coordinate = v_dimension[1] ? query[31:0] : v_dimension[0] ? query[63:32] : query[95:64];
    wire [31:0] record_queue_out_split = record_queue_out_data[34:3];
    wire [1:0] record_queue_out_dimension = record_queue_out_data[2:1];
    wire record_queue_out_internal_leaf = record_queue_out_data[0];
    wire v_places_both = ~record_queue_out_node[20] & ~record_queue_out_node[19];
    wire v_places_both_2 = v_places_both & (~record_queue_out_node[18] & ~record_queue_out_node[17]);
    wire v_places_both_3 = ~record_queue_out_node[16] & ~record_queue_out_node[15];
    wire v_places_both_4 = v_places_both_3 & (~record_queue_out_node[14] & ~record_queue_out_node[13]);
    wire v_places_both_5 = v_places_both_2 & v_places_both_4;
    wire v_places_both_6 = ~record_queue_out_node[12] & ~record_queue_out_node[11];
    wire v_places_both_7 = v_places_both_6 & (~record_queue_out_node[10] & ~record_queue_out_node[9]);
    wire v_places_both_8 = ~record_queue_out_node[8] & ~record_queue_out_node[7];
    wire v_places_both_9 = v_places_both_8 & (~record_queue_out_node[6] & ~record_queue_out_node[5]);
    wire v_places_both_10 = v_places_both_5 & (v_places_both_7 & v_places_both_9);
    wire v_places_both_11 = ~record_queue_out_node[4] & ~record_queue_out_node[3];
    wire v_places_both_12 = v_places_both_11 & (~record_queue_out_node[2] & ~record_queue_out_node[1]);
    wire v_places_choice = v_places_both_11 ? ~record_queue_out_node[2] : ~record_queue_out_node[4];
    wire [3:0] v_places_bits = {1'd0, v_places_both_12, v_places_both_12 ? 2'd0 : {v_places_both_11, v_places_choice}};
    wire v_places_choice_2 = v_places_both_8 ? ~record_queue_out_node[6] : ~record_queue_out_node[8];
    wire v_places_choice_3 = v_places_both_6 ? ~record_queue_out_node[10] : ~record_queue_out_node[12];
    wire [1:0] v_places_choice_4 = v_places_both_7 ? {v_places_both_8, v_places_choice_2} : {v_places_both_6, v_places_choice_3};
    wire v_places_choice_5 = v_places_both_3 ? ~record_queue_out_node[14] : ~record_queue_out_node[16];
    wire v_places_choice_6 = v_places_both ? ~record_queue_out_node[18] : ~record_queue_out_node[20];
    wire [1:0] v_places_choice_7 = v_places_both_2 ? {v_places_both_3, v_places_choice_5} : {v_places_both, v_places_choice_6};
    wire [2:0] v_places_choice_8 = v_places_both_5 ? {v_places_both_7, v_places_choice_4} : {v_places_both_2, v_places_choice_7};
    wire [3:0] v_places_choice_9 = v_places_both_10 ? v_places_bits : {v_places_both_5, v_places_choice_8};

    assign {leaf_thread, leaf_leaf} = leaf_queue_out_data;
    assign {node_thread, node_node} = node_queue_out_data;
    assign push_valid = path_out_valid & ~path_out_is_leaf;
    assign reached_valid = path_out_valid & path_out_is_leaf;
    assign reached_thread = push_thread;

    memory_1w1r #(.WIDTH(96), .DEPTH(16)) queries (
        .clk(clk), .write(start_valid), .write_address(start_thread),
        .write_data({start_x, start_y, start_z}),
        .read(advance), .read_address(record_queue_out_thread), .read_data(query)
    );

    stream_skid_w25 descend_queue (
        .clk(clk), .rst(rst), .in_valid(descend_valid), .in_ready(descend_ready),
        .in_data({descend_thread, descend_node}),
        .out_valid(descend_queue_out_valid), .out_ready(descend_queue_out_ready),
        .out_data(descend_queue_out_data)
    );

    stream_skid_w25 resume_queue (
        .clk(clk), .rst(rst), .in_valid(resume_valid), .in_ready(resume_ready),
        .in_data({resume_thread, resume_node}),
        .out_valid(resume_queue_out_valid), .out_ready(resume_queue_out_ready),
        .out_data(resume_queue_out_data)
    );

    stream_skid_w24 leaf_queue (
        .clk(clk), .rst(rst), .in_valid(advance & reaches), .in_ready(leaf_queue_in_ready),
        .in_data({v_thread, v_node_shifted_by_v_places[19:0]}),
        .out_valid(leaf_valid), .out_ready(leaf_ready), .out_data(leaf_queue_out_data)
    );

    search_path path (
        .clk(clk), .rst(rst), .in_valid(s_valid & proceeds), .in_ready(path_in_ready), .in_is_leaf(s_at_leaf),
        .in_thread(s_thread), .in_node({s_node[19:0], left}), .in_coordinate(s_coordinate),
        .in_split(s_split),
        .out_valid(path_out_valid), .out_ready(1'd1), .out_is_leaf(path_out_is_leaf),
        .out_thread(push_thread), .out_node(push_node), .out_distance2(push_distance2)
    );

    stream_skid_w25 node_queue (
        .clk(clk), .rst(rst), .in_valid(advance & f_valid), .in_ready(node_queue_in_ready),
        .in_data({f_thread, f_node[20:1], f_is_child ? ~left : f_node[0]}),
        .out_valid(node_valid), .out_ready(node_ready), .out_data(node_queue_out_data)
    );

    stream_skid_w60 record_queue (
        .clk(clk), .rst(rst), .in_valid(record_valid), .in_ready(record_ready),
        .in_data({record_thread, record_node, record_split, record_dimension, record_internal_leaf}),
        .out_valid(record_queue_out_valid), .out_ready(advance), .out_data(record_queue_out_data)
    );

    float_lt_s1_f32ftz less_x (.clk(clk), .enable(advance), .a(query[95:64]), .b(v_split), .y(less_x_y));
    float_lt_s1_f32ftz less_y (.clk(clk), .enable(advance), .a(query[63:32]), .b(v_split), .y(less_y_y));
    float_lt_s1_f32ftz less_z (.clk(clk), .enable(advance), .a(query[31:0]), .b(v_split), .y(less_z_y));

    always @(posedge clk) begin
        if (rst) begin
            f_valid <= 1'd0;
            v_valid <= 1'd0;
            s_valid <= 1'd0;
            event_node <= 1'd0;
        end else begin
            if (advance) begin
                f_valid <= descends | (resume_queue_out_valid | descend_queue_out_valid);
                v_valid <= record_queue_out_valid;
                s_valid <= v_valid;
            end
            event_node <= advance & v_valid;
        end
    end
    always @(posedge clk) begin
        if (advance) begin
            f_thread <= descends ? v_thread : f_thread_choice;
            f_node <= next_node;
            v_thread <= record_queue_out_thread;
            v_node <= record_queue_out_node;
            s_thread <= v_thread;
            s_node <= v_node;
            f_is_child <= descends;
            s_at_leaf <= at_leaf;
            s_coordinate <= coordinate;
            s_split <= v_split;
            s_dimension <= v_dimension;
            v_split <= record_queue_out_split;
            v_dimension <= record_queue_out_dimension;
            v_internal_leaf <= record_queue_out_internal_leaf;
            v_places <= {v_places_both_10, v_places_choice_9};
        end
    end

    wire _unused = &{1'b0, s_node[20], start_k, start_number, start_radius2, v_node_shifted_by_v_places[20]};

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        start_radius2_in_range: assert (~start_valid | (start_radius2 < 32'h80000000));
`else
        if (!(~start_valid | (start_radius2 < 32'h80000000))) begin
            $display("assertion failed: start_radius2_in_range in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Whether one floating-point number is less than another.
// stages = 1
// format = f32-ftz
module float_lt_s1_f32ftz (
    input  wire clk, input wire enable, input wire [31:0] a, input wire [31:0] b,
    output reg  y
);
    wire y_in_order = {~a[31], a[30:0] ^ {31{a[31]}}} < {~b[31], b[30:0] ^ {31{b[31]}}};

    always @(posedge clk) begin
        if (enable) begin
            y <= y_in_order & ~((a[30:23] == 8'd0) & (b[30:23] == 8'd0)) & ~((&a[30:23] & |a[22:0]) | (&b[30:23] & |b[22:0]));
        end
    end
endmodule

// Queue of two in registers.
// width = 60
module stream_skid_w60 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [59:0] in_data,
    output wire out_valid, input wire out_ready, output wire [59:0] out_data
);
    reg head_filled, second_filled, room;
    reg [59:0] head, second;

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

// Squared distance of a query to a splitting plane.
// latency = 11
// initiation_interval = 1
module search_path (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire in_is_leaf, input wire [3:0] in_thread,
    input  wire [20:0] in_node, input wire [31:0] in_coordinate, input wire [31:0] in_split,
    output wire out_valid, input wire out_ready, output wire out_is_leaf, output wire [3:0] out_thread,
    output wire [20:0] out_node, output wire [30:0] out_distance2
);
    (* ram_style = "distributed" *)
    reg [25:0] delay_11_from_0 [0:9];
    reg [3:0] delay_11_from_0_pointer;
    reg [25:0] delay_11_from_0_out;
    reg [10:0] in_flight;
    reg shown, shown_is_leaf;
    reg [3:0] shown_thread;
    reg [20:0] shown_node;
    reg [30:0] shown_distance2;

    wire [31:0] add_f32_ftz_unit_y, mul_f32_ftz_unit_y;

    wire kept = in_flight[10];
    wire is_leaf_d11 = delay_11_from_0_out[0];
    wire [3:0] thread_d11 = delay_11_from_0_out[4:1];
    wire [20:0] node_d11 = delay_11_from_0_out[25:5];

    assign in_ready = 1'd1;
    assign out_valid = shown;
    assign out_is_leaf = shown_is_leaf;
    assign out_thread = shown_thread;
    assign out_node = shown_node;
    assign out_distance2 = shown_distance2;

    float_add_s6_f32ftz add_f32_ftz_unit (
        .clk(clk), .enable(1'd1), .a(in_coordinate), .b({~in_split[31], in_split[30:0]}),
        .y(add_f32_ftz_unit_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_y), .b(add_f32_ftz_unit_y), .y(mul_f32_ftz_unit_y)
    );

    always @(posedge clk) begin
        if (rst) begin
            delay_11_from_0_pointer <= 4'd0;
            in_flight <= 11'd0;
            shown <= 1'd0;
        end else begin
            delay_11_from_0_pointer <= (delay_11_from_0_pointer == 4'd9) ? (delay_11_from_0_pointer - 4'd9) : (delay_11_from_0_pointer + 4'd1);
            in_flight <= {in_flight[9:0], in_valid};
            shown <= kept;
        end
    end
    always @(posedge clk) begin
        shown_is_leaf <= is_leaf_d11;
        shown_thread <= thread_d11;
        shown_node <= node_d11;
        shown_distance2 <= mul_f32_ftz_unit_y[30:0];
    end
    always @(posedge clk) begin
        delay_11_from_0[delay_11_from_0_pointer] <= {in_node, in_thread, in_is_leaf};
        delay_11_from_0_out <= delay_11_from_0[delay_11_from_0_pointer];
    end

    wire _unused = &{1'b0, mul_f32_ftz_unit_y[31], out_ready};

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

// Queue of two in registers.
// width = 24
module stream_skid_w24 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [23:0] in_data,
    output wire out_valid, input wire out_ready, output wire [23:0] out_data
);
    reg head_filled, second_filled, room;
    reg [23:0] head, second;

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
// threads = 16
// leaves_in_flight = 2
module search_threads (
    input  wire clk, input wire rst,
    input  wire query_valid, output wire query_ready,  // Queries.
    input  wire [23:0] query_number,  // Its number, which its results bear.
    input  wire [5:0] query_k,  // Neighbors wanted.
    input  wire [31:0] query_radius2,  // Squared radius within which neighbors count.
    input  wire [31:0] query_x,  // Where.
    input  wire [31:0] query_y,  // Where.
    input  wire [31:0] query_z,  // Where.
    output reg  start_valid,  // A thread taking up a query.
    output reg  [3:0] start_thread,  // Thread.
    output reg  [23:0] start_number,  // Its number, which its results bear.
    output reg  [5:0] start_k,  // Neighbors wanted.
    output reg  [31:0] start_radius2,  // Squared radius within which neighbors count.
    output reg  [31:0] start_x,  // Where.
    output reg  [31:0] start_y,  // Where.
    output reg  [31:0] start_z,  // Where.
    output wire descend_valid, input wire descend_ready,  // Descents from the root.
    output wire [3:0] descend_thread,  // Thread.
    output wire [20:0] descend_node,  // Node: 1 is the root, `2i` and `2i + 1` are the children of `i`.
    output wire pop_valid, input wire pop_ready,  // Threads that want their next path.
    output wire [3:0] pop_thread,  // Thread.
    output wire finish_valid, input wire finish_ready,  // Threads whose search is over.
    output wire [3:0] finish_thread,  // Thread.
    input  wire reached_valid,  // A thread's descent ended in a leaf.
    input  wire [3:0] reached_thread,  // Thread.
    input  wire leaf_done_valid,  // All points of a leaf are in the thread's queue.
    input  wire [3:0] leaf_done_thread,  // Thread.
    input  wire skipped_valid,  // No point of a leaf was near enough for the thread's queue.
    input  wire [3:0] skipped_thread,  // Thread.
    input  wire empty_valid,  // A thread's stack was empty.
    input  wire [3:0] empty_thread,  // Thread.
    input  wire released_valid,  // A thread whose results are safe.
    input  wire [3:0] released_thread,  // Thread.
    output reg  event_thread_wait  // A query waited for a free thread.
);
    reg [15:0] busy, waiting, exhausted, wants_pop, wants_finish;
    reg any_free;
    reg [15:0] behind_pop, chosen_pop;
    reg pop_shown;
    reg [15:0] behind_finish, chosen_finish;
    reg finish_shown;
    reg [1:0] outstanding_0, outstanding_1, outstanding_2, outstanding_3, outstanding_4, outstanding_5;
    reg [1:0] outstanding_6, outstanding_7, outstanding_8, outstanding_9, outstanding_10, outstanding_11;
    reg [1:0] outstanding_12, outstanding_13, outstanding_14, outstanding_15;

    wire descend_queue_in_ready;
    wire [24:0] descend_queue_out_data;

    assign query_ready = any_free & ~start_valid & descend_queue_in_ready;
    wire [15:0] free = ~busy & (16'd0 - ~busy);
    wire take = query_valid & query_ready;
    wire released_set_both = released_valid & (released_thread[3:2] == 2'd3);
    wire released_thread_1_0_is_3 = released_thread[1:0] == 2'd3;
    wire released_thread_1_0_is_2 = released_thread[1:0] == 2'd2;
    wire released_thread_1_0_is_1 = released_thread[1:0] == 2'd1;
    wire released_thread_1_0_is_0 = released_thread[1:0] == 2'd0;
    wire released_set_both_2 = released_valid & (released_thread[3:2] == 2'd2);
    wire released_set_both_3 = released_valid & (released_thread[3:2] == 2'd1);
    wire released_set_both_4 = released_valid & (released_thread[3:2] == 2'd0);
    wire [15:0] released_set = {
        released_set_both & released_thread_1_0_is_3, released_set_both & released_thread_1_0_is_2,
        released_set_both & released_thread_1_0_is_1, released_set_both & released_thread_1_0_is_0,
        released_set_both_2 & released_thread_1_0_is_3, released_set_both_2 & released_thread_1_0_is_2,
        released_set_both_2 & released_thread_1_0_is_1, released_set_both_2 & released_thread_1_0_is_0,
        released_set_both_3 & released_thread_1_0_is_3, released_set_both_3 & released_thread_1_0_is_2,
        released_set_both_3 & released_thread_1_0_is_1, released_set_both_3 & released_thread_1_0_is_0,
        released_set_both_4 & released_thread_1_0_is_3, released_set_both_4 & released_thread_1_0_is_2,
        released_set_both_4 & released_thread_1_0_is_1, released_set_both_4 & released_thread_1_0_is_0
    };
    wire [15:0] kept = ~released_set;
    wire [15:0] busy_next = (busy | (free & {16{take}})) & kept;
    wire leaf_done_set_both = leaf_done_valid & (leaf_done_thread[3:2] == 2'd3);
    wire leaf_done_thread_1_0_is_3 = leaf_done_thread[1:0] == 2'd3;
    wire leaf_done_thread_1_0_is_2 = leaf_done_thread[1:0] == 2'd2;
    wire leaf_done_thread_1_0_is_1 = leaf_done_thread[1:0] == 2'd1;
    wire leaf_done_thread_1_0_is_0 = leaf_done_thread[1:0] == 2'd0;
    wire leaf_done_set_both_2 = leaf_done_valid & (leaf_done_thread[3:2] == 2'd2);
    wire leaf_done_set_both_3 = leaf_done_valid & (leaf_done_thread[3:2] == 2'd1);
    wire leaf_done_set_both_4 = leaf_done_valid & (leaf_done_thread[3:2] == 2'd0);
    wire [15:0] leaf_done_set = {
        leaf_done_set_both & leaf_done_thread_1_0_is_3, leaf_done_set_both & leaf_done_thread_1_0_is_2,
        leaf_done_set_both & leaf_done_thread_1_0_is_1, leaf_done_set_both & leaf_done_thread_1_0_is_0,
        leaf_done_set_both_2 & leaf_done_thread_1_0_is_3, leaf_done_set_both_2 & leaf_done_thread_1_0_is_2,
        leaf_done_set_both_2 & leaf_done_thread_1_0_is_1, leaf_done_set_both_2 & leaf_done_thread_1_0_is_0,
        leaf_done_set_both_3 & leaf_done_thread_1_0_is_3, leaf_done_set_both_3 & leaf_done_thread_1_0_is_2,
        leaf_done_set_both_3 & leaf_done_thread_1_0_is_1, leaf_done_set_both_3 & leaf_done_thread_1_0_is_0,
        leaf_done_set_both_4 & leaf_done_thread_1_0_is_3, leaf_done_set_both_4 & leaf_done_thread_1_0_is_2,
        leaf_done_set_both_4 & leaf_done_thread_1_0_is_1, leaf_done_set_both_4 & leaf_done_thread_1_0_is_0
    };
    wire skipped_set_both = skipped_valid & (skipped_thread[3:2] == 2'd3);
    wire skipped_thread_1_0_is_3 = skipped_thread[1:0] == 2'd3;
    wire skipped_thread_1_0_is_2 = skipped_thread[1:0] == 2'd2;
    wire skipped_thread_1_0_is_1 = skipped_thread[1:0] == 2'd1;
    wire skipped_thread_1_0_is_0 = skipped_thread[1:0] == 2'd0;
    wire skipped_set_both_2 = skipped_valid & (skipped_thread[3:2] == 2'd2);
    wire skipped_set_both_3 = skipped_valid & (skipped_thread[3:2] == 2'd1);
    wire skipped_set_both_4 = skipped_valid & (skipped_thread[3:2] == 2'd0);
    wire [15:0] skipped_set = {
        skipped_set_both & skipped_thread_1_0_is_3, skipped_set_both & skipped_thread_1_0_is_2,
        skipped_set_both & skipped_thread_1_0_is_1, skipped_set_both & skipped_thread_1_0_is_0,
        skipped_set_both_2 & skipped_thread_1_0_is_3, skipped_set_both_2 & skipped_thread_1_0_is_2,
        skipped_set_both_2 & skipped_thread_1_0_is_1, skipped_set_both_2 & skipped_thread_1_0_is_0,
        skipped_set_both_3 & skipped_thread_1_0_is_3, skipped_set_both_3 & skipped_thread_1_0_is_2,
        skipped_set_both_3 & skipped_thread_1_0_is_1, skipped_set_both_3 & skipped_thread_1_0_is_0,
        skipped_set_both_4 & skipped_thread_1_0_is_3, skipped_set_both_4 & skipped_thread_1_0_is_2,
        skipped_set_both_4 & skipped_thread_1_0_is_1, skipped_set_both_4 & skipped_thread_1_0_is_0
    };
    wire [15:0] leaf_ended = leaf_done_set | skipped_set;
    wire reached_set_both = reached_valid & (reached_thread[3:2] == 2'd3);
    wire reached_thread_1_0_is_3 = reached_thread[1:0] == 2'd3;
    wire reached_thread_1_0_is_2 = reached_thread[1:0] == 2'd2;
    wire reached_thread_1_0_is_1 = reached_thread[1:0] == 2'd1;
    wire reached_thread_1_0_is_0 = reached_thread[1:0] == 2'd0;
    wire reached_set_both_2 = reached_valid & (reached_thread[3:2] == 2'd2);
    wire reached_set_both_3 = reached_valid & (reached_thread[3:2] == 2'd1);
    wire reached_set_both_4 = reached_valid & (reached_thread[3:2] == 2'd0);
    wire [15:0] reached_set = {
        reached_set_both & reached_thread_1_0_is_3, reached_set_both & reached_thread_1_0_is_2,
        reached_set_both & reached_thread_1_0_is_1, reached_set_both & reached_thread_1_0_is_0,
        reached_set_both_2 & reached_thread_1_0_is_3, reached_set_both_2 & reached_thread_1_0_is_2,
        reached_set_both_2 & reached_thread_1_0_is_1, reached_set_both_2 & reached_thread_1_0_is_0,
        reached_set_both_3 & reached_thread_1_0_is_3, reached_set_both_3 & reached_thread_1_0_is_2,
        reached_set_both_3 & reached_thread_1_0_is_1, reached_set_both_3 & reached_thread_1_0_is_0,
        reached_set_both_4 & reached_thread_1_0_is_3, reached_set_both_4 & reached_thread_1_0_is_2,
        reached_set_both_4 & reached_thread_1_0_is_1, reached_set_both_4 & reached_thread_1_0_is_0
    };
    wire [1:0] outstanding_15_next_difference = (outstanding_15 + {1'd0, reached_set[15]}) - {1'd0, leaf_done_set[15]};
    wire [1:0] outstanding_15_next = outstanding_15_next_difference - {1'd0, skipped_set[15]};
    wire [1:0] outstanding_14_next_difference = (outstanding_14 + {1'd0, reached_set[14]}) - {1'd0, leaf_done_set[14]};
    wire [1:0] outstanding_14_next = outstanding_14_next_difference - {1'd0, skipped_set[14]};
    wire [1:0] outstanding_13_next_difference = (outstanding_13 + {1'd0, reached_set[13]}) - {1'd0, leaf_done_set[13]};
    wire [1:0] outstanding_13_next = outstanding_13_next_difference - {1'd0, skipped_set[13]};
    wire [1:0] outstanding_12_next_difference = (outstanding_12 + {1'd0, reached_set[12]}) - {1'd0, leaf_done_set[12]};
    wire [1:0] outstanding_12_next = outstanding_12_next_difference - {1'd0, skipped_set[12]};
    wire [1:0] outstanding_11_next_difference = (outstanding_11 + {1'd0, reached_set[11]}) - {1'd0, leaf_done_set[11]};
    wire [1:0] outstanding_11_next = outstanding_11_next_difference - {1'd0, skipped_set[11]};
    wire [1:0] outstanding_10_next_difference = (outstanding_10 + {1'd0, reached_set[10]}) - {1'd0, leaf_done_set[10]};
    wire [1:0] outstanding_10_next = outstanding_10_next_difference - {1'd0, skipped_set[10]};
    wire [1:0] outstanding_9_next_difference = (outstanding_9 + {1'd0, reached_set[9]}) - {1'd0, leaf_done_set[9]};
    wire [1:0] outstanding_9_next = outstanding_9_next_difference - {1'd0, skipped_set[9]};
    wire [1:0] outstanding_8_next_difference = (outstanding_8 + {1'd0, reached_set[8]}) - {1'd0, leaf_done_set[8]};
    wire [1:0] outstanding_8_next = outstanding_8_next_difference - {1'd0, skipped_set[8]};
    wire [1:0] outstanding_7_next_difference = (outstanding_7 + {1'd0, reached_set[7]}) - {1'd0, leaf_done_set[7]};
    wire [1:0] outstanding_7_next = outstanding_7_next_difference - {1'd0, skipped_set[7]};
    wire [1:0] outstanding_6_next_difference = (outstanding_6 + {1'd0, reached_set[6]}) - {1'd0, leaf_done_set[6]};
    wire [1:0] outstanding_6_next = outstanding_6_next_difference - {1'd0, skipped_set[6]};
    wire [1:0] outstanding_5_next_difference = (outstanding_5 + {1'd0, reached_set[5]}) - {1'd0, leaf_done_set[5]};
    wire [1:0] outstanding_5_next = outstanding_5_next_difference - {1'd0, skipped_set[5]};
    wire [1:0] outstanding_4_next_difference = (outstanding_4 + {1'd0, reached_set[4]}) - {1'd0, leaf_done_set[4]};
    wire [1:0] outstanding_4_next = outstanding_4_next_difference - {1'd0, skipped_set[4]};
    wire [1:0] outstanding_3_next_difference = (outstanding_3 + {1'd0, reached_set[3]}) - {1'd0, leaf_done_set[3]};
    wire [1:0] outstanding_3_next = outstanding_3_next_difference - {1'd0, skipped_set[3]};
    wire [1:0] outstanding_2_next_difference = (outstanding_2 + {1'd0, reached_set[2]}) - {1'd0, leaf_done_set[2]};
    wire [1:0] outstanding_2_next = outstanding_2_next_difference - {1'd0, skipped_set[2]};
    wire [1:0] outstanding_1_next_difference = (outstanding_1 + {1'd0, reached_set[1]}) - {1'd0, leaf_done_set[1]};
    wire [1:0] outstanding_1_next = outstanding_1_next_difference - {1'd0, skipped_set[1]};
    wire [1:0] outstanding_0_next_difference = (outstanding_0 + {1'd0, reached_set[0]}) - {1'd0, leaf_done_set[0]};
    wire [1:0] outstanding_0_next = outstanding_0_next_difference - {1'd0, skipped_set[0]};
    wire [15:0] waiting_bits = {
        outstanding_15_next < 2'd2, outstanding_14_next < 2'd2, outstanding_13_next < 2'd2,
        outstanding_12_next < 2'd2, outstanding_11_next < 2'd2, outstanding_10_next < 2'd2,
        outstanding_9_next < 2'd2, outstanding_8_next < 2'd2, outstanding_7_next < 2'd2,
        outstanding_6_next < 2'd2, outstanding_5_next < 2'd2, outstanding_4_next < 2'd2,
        outstanding_3_next < 2'd2, outstanding_2_next < 2'd2, outstanding_1_next < 2'd2,
        outstanding_0_next < 2'd2
    };
    wire empty_set_both = empty_valid & (empty_thread[3:2] == 2'd3);
    wire empty_thread_1_0_is_3 = empty_thread[1:0] == 2'd3;
    wire empty_thread_1_0_is_2 = empty_thread[1:0] == 2'd2;
    wire empty_thread_1_0_is_1 = empty_thread[1:0] == 2'd1;
    wire empty_thread_1_0_is_0 = empty_thread[1:0] == 2'd0;
    wire empty_set_both_2 = empty_valid & (empty_thread[3:2] == 2'd2);
    wire empty_set_both_3 = empty_valid & (empty_thread[3:2] == 2'd1);
    wire empty_set_both_4 = empty_valid & (empty_thread[3:2] == 2'd0);
    wire [15:0] empty_set = {
        empty_set_both & empty_thread_1_0_is_3, empty_set_both & empty_thread_1_0_is_2,
        empty_set_both & empty_thread_1_0_is_1, empty_set_both & empty_thread_1_0_is_0,
        empty_set_both_2 & empty_thread_1_0_is_3, empty_set_both_2 & empty_thread_1_0_is_2,
        empty_set_both_2 & empty_thread_1_0_is_1, empty_set_both_2 & empty_thread_1_0_is_0,
        empty_set_both_3 & empty_thread_1_0_is_3, empty_set_both_3 & empty_thread_1_0_is_2,
        empty_set_both_3 & empty_thread_1_0_is_1, empty_set_both_3 & empty_thread_1_0_is_0,
        empty_set_both_4 & empty_thread_1_0_is_3, empty_set_both_4 & empty_thread_1_0_is_2,
        empty_set_both_4 & empty_thread_1_0_is_1, empty_set_both_4 & empty_thread_1_0_is_0
    };
    wire [15:0] exhausted_now = exhausted | empty_set;
    wire [15:0] pop_next = wants_pop & behind_pop;
    wire pop_from_next = |pop_next;
    wire [15:0] pop_below_next = pop_next - 16'd1;
    wire [15:0] pop_below_any = wants_pop - 16'd1;
    wire [15:0] first_pop = pop_from_next ? (pop_next & ~pop_below_next) : (wants_pop & ~pop_below_any);
    wire pop_advance = pop_ready | ~pop_shown;
    wire [15:0] granted_pop = first_pop & {16{pop_advance}};
    wire [15:0] wants_pop_either = (wants_pop & ~granted_pop) | ((reached_set & waiting_bits) | (leaf_ended & waiting));
    wire [15:0] finish_next = wants_finish & behind_finish;
    wire finish_from_next = |finish_next;
    wire [15:0] finish_below_next = finish_next - 16'd1;
    wire [15:0] finish_below_any = wants_finish - 16'd1;
    wire [15:0] first_finish = finish_from_next ? (finish_next & ~finish_below_next) : (wants_finish & ~finish_below_any);
    wire finish_advance = finish_ready | ~finish_shown;
    wire [15:0] granted_finish = first_finish & {16{finish_advance}};
    wire [15:0] wants_finish_bits = {
        outstanding_15_next == 2'd0, outstanding_14_next == 2'd0, outstanding_13_next == 2'd0,
        outstanding_12_next == 2'd0, outstanding_11_next == 2'd0, outstanding_10_next == 2'd0,
        outstanding_9_next == 2'd0, outstanding_8_next == 2'd0, outstanding_7_next == 2'd0,
        outstanding_6_next == 2'd0, outstanding_5_next == 2'd0, outstanding_4_next == 2'd0,
        outstanding_3_next == 2'd0, outstanding_2_next == 2'd0, outstanding_1_next == 2'd0,
        outstanding_0_next == 2'd0
    };
    wire [15:0] wants_finish_either = (wants_finish & ~granted_finish) | ((empty_set | leaf_ended) & (exhausted_now & wants_finish_bits));
    wire [15:0] behind_pop_choice = pop_from_next ? (pop_next ^ pop_below_next) : (wants_pop ^ pop_below_any);
    wire [15:0] behind_finish_choice = finish_from_next ? (finish_next ^ finish_below_next) : (wants_finish ^ finish_below_any);

    assign {descend_thread, descend_node} = descend_queue_out_data;
    assign pop_valid = pop_shown;
    assign pop_thread = {
        |(chosen_pop & 16'hff00), |(chosen_pop & 16'hf0f0), |(chosen_pop & 16'hcccc),
        |(chosen_pop & 16'haaaa)
    };
    assign finish_valid = finish_shown;
    assign finish_thread = {
        |(chosen_finish & 16'hff00), |(chosen_finish & 16'hf0f0), |(chosen_finish & 16'hcccc),
        |(chosen_finish & 16'haaaa)
    };

    stream_skid_w25 descend_queue (
        .clk(clk), .rst(rst), .in_valid(start_valid), .in_ready(descend_queue_in_ready),
        .in_data({start_thread, 21'd1}),
        .out_valid(descend_valid), .out_ready(descend_ready), .out_data(descend_queue_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            busy <= 16'd0;
            waiting <= 16'd0;
            exhausted <= 16'd0;
            wants_pop <= 16'd0;
            wants_finish <= 16'd0;
            any_free <= 1'd1;
            start_valid <= 1'd0;
            behind_pop <= 16'd0;
            chosen_pop <= 16'd0;
            pop_shown <= 1'd0;
            behind_finish <= 16'd0;
            chosen_finish <= 16'd0;
            finish_shown <= 1'd0;
            outstanding_0 <= 2'd0;
            outstanding_1 <= 2'd0;
            outstanding_2 <= 2'd0;
            outstanding_3 <= 2'd0;
            outstanding_4 <= 2'd0;
            outstanding_5 <= 2'd0;
            outstanding_6 <= 2'd0;
            outstanding_7 <= 2'd0;
            outstanding_8 <= 2'd0;
            outstanding_9 <= 2'd0;
            outstanding_10 <= 2'd0;
            outstanding_11 <= 2'd0;
            outstanding_12 <= 2'd0;
            outstanding_13 <= 2'd0;
            outstanding_14 <= 2'd0;
            outstanding_15 <= 2'd0;
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
            outstanding_4 <= outstanding_4_next;
            outstanding_5 <= outstanding_5_next;
            outstanding_6 <= outstanding_6_next;
            outstanding_7 <= outstanding_7_next;
            outstanding_8 <= outstanding_8_next;
            outstanding_9 <= outstanding_9_next;
            outstanding_10 <= outstanding_10_next;
            outstanding_11 <= outstanding_11_next;
            outstanding_12 <= outstanding_12_next;
            outstanding_13 <= outstanding_13_next;
            outstanding_14 <= outstanding_14_next;
            outstanding_15 <= outstanding_15_next;
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
        start_thread <= {|(free & 16'hff00), |(free & 16'hf0f0), |(free & 16'hcccc), |(free & 16'haaaa)};
        start_number <= query_number;
        start_k <= query_k;
        start_radius2 <= query_radius2;
        start_x <= query_x;
        start_y <= query_y;
        start_z <= query_z;
    end

`ifdef RTL_ASSERT
    wire check_in_order = {1'd0, outstanding_15} < ({2'd0, leaf_done_set[15]} + {2'd0, skipped_set[15]});
    wire check_in_order_2 = {1'd0, outstanding_14} < ({2'd0, leaf_done_set[14]} + {2'd0, skipped_set[14]});
    wire check_in_order_3 = {1'd0, outstanding_13} < ({2'd0, leaf_done_set[13]} + {2'd0, skipped_set[13]});
    wire check_in_order_4 = {1'd0, outstanding_12} < ({2'd0, leaf_done_set[12]} + {2'd0, skipped_set[12]});
    wire check_in_order_5 = {1'd0, outstanding_11} < ({2'd0, leaf_done_set[11]} + {2'd0, skipped_set[11]});
    wire check_in_order_6 = {1'd0, outstanding_10} < ({2'd0, leaf_done_set[10]} + {2'd0, skipped_set[10]});
    wire check_in_order_7 = {1'd0, outstanding_9} < ({2'd0, leaf_done_set[9]} + {2'd0, skipped_set[9]});
    wire check_in_order_8 = {1'd0, outstanding_8} < ({2'd0, leaf_done_set[8]} + {2'd0, skipped_set[8]});
    wire check_in_order_9 = {1'd0, outstanding_7} < ({2'd0, leaf_done_set[7]} + {2'd0, skipped_set[7]});
    wire check_in_order_10 = {1'd0, outstanding_6} < ({2'd0, leaf_done_set[6]} + {2'd0, skipped_set[6]});
    wire check_in_order_11 = {1'd0, outstanding_5} < ({2'd0, leaf_done_set[5]} + {2'd0, skipped_set[5]});
    wire check_in_order_12 = {1'd0, outstanding_4} < ({2'd0, leaf_done_set[4]} + {2'd0, skipped_set[4]});
    wire check_in_order_13 = {1'd0, outstanding_3} < ({2'd0, leaf_done_set[3]} + {2'd0, skipped_set[3]});
    wire check_in_order_14 = {1'd0, outstanding_2} < ({2'd0, leaf_done_set[2]} + {2'd0, skipped_set[2]});
    wire check_in_order_15 = {1'd0, outstanding_1} < ({2'd0, leaf_done_set[1]} + {2'd0, skipped_set[1]});
    wire check_in_order_16 = {1'd0, outstanding_0} < ({2'd0, leaf_done_set[0]} + {2'd0, skipped_set[0]});
    wire [15:0] check_bits = {
        check_in_order, check_in_order_2, check_in_order_3, check_in_order_4, check_in_order_5,
        check_in_order_6, check_in_order_7, check_in_order_8, check_in_order_9, check_in_order_10,
        check_in_order_11, check_in_order_12, check_in_order_13, check_in_order_14, check_in_order_15,
        check_in_order_16
    };
    wire [15:0] check_bits_2 = {
        reached_set[15] & ~(outstanding_15 < 2'd2), reached_set[14] & ~(outstanding_14 < 2'd2),
        reached_set[13] & ~(outstanding_13 < 2'd2), reached_set[12] & ~(outstanding_12 < 2'd2),
        reached_set[11] & ~(outstanding_11 < 2'd2), reached_set[10] & ~(outstanding_10 < 2'd2),
        reached_set[9] & ~(outstanding_9 < 2'd2), reached_set[8] & ~(outstanding_8 < 2'd2),
        reached_set[7] & ~(outstanding_7 < 2'd2), reached_set[6] & ~(outstanding_6 < 2'd2),
        reached_set[5] & ~(outstanding_5 < 2'd2), reached_set[4] & ~(outstanding_4 < 2'd2),
        reached_set[3] & ~(outstanding_3 < 2'd2), reached_set[2] & ~(outstanding_2 < 2'd2),
        reached_set[1] & ~(outstanding_1 < 2'd2), reached_set[0] & ~(outstanding_0 < 2'd2)
    };
    wire [15:0] check_bits_3 = {
        released_set[15] & (|outstanding_15 | reached_set[15]),
        released_set[14] & (|outstanding_14 | reached_set[14]),
        released_set[13] & (|outstanding_13 | reached_set[13]),
        released_set[12] & (|outstanding_12 | reached_set[12]),
        released_set[11] & (|outstanding_11 | reached_set[11]),
        released_set[10] & (|outstanding_10 | reached_set[10]),
        released_set[9] & (|outstanding_9 | reached_set[9]),
        released_set[8] & (|outstanding_8 | reached_set[8]),
        released_set[7] & (|outstanding_7 | reached_set[7]),
        released_set[6] & (|outstanding_6 | reached_set[6]),
        released_set[5] & (|outstanding_5 | reached_set[5]),
        released_set[4] & (|outstanding_4 | reached_set[4]),
        released_set[3] & (|outstanding_3 | reached_set[3]),
        released_set[2] & (|outstanding_2 | reached_set[2]),
        released_set[1] & (|outstanding_1 | reached_set[1]),
        released_set[0] & (|outstanding_0 | reached_set[0])
    };

    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        query_radius2_in_range: assert (~query_valid | (query_radius2 < 32'h80000000));
        leaves_are_reached_before_they_end: assert (~(|check_bits));
        no_more_leaves_are_under_way: assert (~(|check_bits_2));
        threads_are_released_without_leaves: assert (~(|check_bits_3));
        a_free_thread_is_told: assert (any_free == ~(&busy));
`else
        if (!(~query_valid | (query_radius2 < 32'h80000000))) begin
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
// width = 25
module stream_skid_w25 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [24:0] in_data,
    output wire out_valid, input wire out_ready, output wire [24:0] out_data
);
    reg head_filled, second_filled, room;
    reg [24:0] head, second;

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

// Answers coherent queries with the neighbors of earlier ones.
// entries = 8
// neighbors = 32
// tickets = 20
module search_neighbor_cache (
    input  wire clk, input wire rst,
    input  wire setup_valid,  // How neighborhoods are judged, not while a query is under way.
    input  wire setup_ball,  // Queries are balls, else k nearest neighbors.
    input  wire [31:0] setup_far_scale,  // Factor of the distance to the farthest neighbor.
    input  wire [31:0] setup_margin_scale,  // Factor of what is left of it.
    output wire result_valid, input wire result_ready,  // Neighbors, nearest first to the query that was searched for, a query after the other.
    output wire [23:0] result_number,  // The query's number.
    output wire result_last,  // Closes the query.
    output wire result_found,  // Low for a query without any neighbor.
    output wire [23:0] result_index,  // The neighbor's place in the point memory.
    output wire [31:0] result_distance2,  // Its squared distance.
    output wire result_cached,  // With a neighbor cache, its squared distance is that to the query whose neighborhood is reused.
    output wire search_valid, input wire search_ready,  // Queries that no neighborhood covers, with their tickets for numbers.
    output wire [23:0] search_number,  // Its number, which its results bear.
    output wire [5:0] search_k,  // Neighbors wanted.
    output wire [31:0] search_radius2,  // Squared radius within which neighbors count.
    output wire [31:0] search_x,  // Where.
    output wire [31:0] search_y,  // Where.
    output wire [31:0] search_z,  // Where.
    output reg  event_cache_hit,  // A neighborhood of the neighbor cache covered a query.
    output reg  event_cache_miss,  // No neighborhood of the neighbor cache covered a query.
    input  wire found_valid, output wire found_ready,  // Neighbors that a search found, nearest first, a search after the other.
    input  wire [23:0] found_number,  // The query's number.
    input  wire found_last,  // Closes the query.
    input  wire found_found,  // Low for a query without any neighbor.
    input  wire [23:0] found_index,  // The neighbor's place in the point memory.
    input  wire [31:0] found_distance2,  // Its squared distance.
    input  wire query_valid, output wire query_ready,  // Queries.
    input  wire [23:0] query_number,  // Its number, which its results bear.
    input  wire [5:0] query_k,  // Neighbors wanted.
    input  wire [31:0] query_radius2,  // Squared radius within which neighbors count.
    input  wire [31:0] query_x,  // Where.
    input  wire [31:0] query_y,  // Where.
    input  wire [31:0] query_z,  // Where.
    input  wire [31:0] query_reach  // With a neighbor cache, the radius around it within which a neighborhood must be complete to cover it: 0 for k nearest neighbors, the radius of a ball query.
);
    (* ram_style = "distributed" *)
    reg [162:0] asked [0:7];
    reg ball;  // Queries are balls, else k nearest neighbors.
    reg [31:0] far_scale;  // Factor of the distance to the farthest neighbor.
    reg [31:0] margin_scale;  // Factor of what is left of it.
    reg [7:0] present, writing, stale, version_0, version_1, version_2, version_3, version_4, version_5, version_6;
    reg [7:0] version_7;
    reg [2:0] readers_0, readers_1, readers_2, readers_3, readers_4, readers_5, readers_6, readers_7;
    reg older_than_1;
    reg [1:0] older_than_2;
    reg [2:0] older_than_3;
    reg [3:0] older_than_4;
    reg [4:0] older_than_5;
    reg [5:0] older_than_6;
    reg [6:0] older_than_7;
    reg [7:0] used;
    reg [19:0] taken;
    reg any_ticket;
    reg [4:0] next_ticket, under_way;
    reg admits_query;
    reg [2:0] next_entry;
    reg first_entry, last_entry;
    reg [3:0] asked_count;
    reg [2:0] asked_write_address, asked_read_address;
    reg asked_has_room, i1_valid;
    reg [2:0] i1_entry;  // The entry.
    reg i1_last;  // It is the query's last.
    reg i1_present;  // The entry's neighborhood could be reused as it was read.
    reg [7:0] i1_version;  // Which neighborhood of the entry's it was.
    reg [31:0] i1_x;  // Where the query is.
    reg [31:0] i1_y;  // Where the query is.
    reg [31:0] i1_z;  // Where the query is.
    reg [31:0] i1_reach;  // The radius around it within which a neighborhood must be complete.
    wire [127:0] entry_cover;
    reg j_valid, j_matches;
    reg [2:0] j_entry;  // The entry.
    reg j_last;  // It is the query's last.
    reg j_reusable;
    reg [31:0] j_margin;
    reg answered, copying;
    reg [2:0] copy_entry;
    wire [162:0] ticket_query;
    reg [5:0] copy_rank;
    reg [31:0] copy_previous;
    reg reach_valid;
    reg [2:0] reach_entry;  // The entry.
    reg [31:0] reach_x;  // Where its query is.
    reg [31:0] reach_y;  // Where its query is.
    reg [31:0] reach_z;  // Where its query is.
    reg [31:0] reach_far2;  // Within this squared distance all points are known.
    reg [31:0] reach_near2;  // Within this one lie all that are wanted.
    reg reach_leads;  // Others may wait for it.
    reg [3:0] reach_leader;  // Its number among the leaders.
    reg d0_valid;
    reg [2:0] d0_entry;  // The entry that holds the neighbors.
    reg [23:0] d0_number;  // The query's number.
    reg d0_cached;  // The neighborhood is reused.
    wire [5:0] count;
    reg [5:0] d0_rank, d0_next_rank;
    reg d1_valid;
    reg [23:0] d1_number;  // The query's number.
    reg d1_last;  // Closes the query.
    reg d1_found;  // There is a neighbor.
    reg d1_cached;  // The neighborhood is reused.
    wire [54:0] neighbor;
    reg hit_finishes;
    reg [3:0] hit_leader;
    reg delivered_finishes;
    reg [3:0] delivered_leader;
    reg [31:0] waits, follower_ready, due, chosen;
    reg [3:0] follows_0, follows_1, follows_2, follows_3, follows_4, follows_5, follows_6, follows_7, follows_8;
    reg [3:0] follows_9, follows_10, follows_11, follows_12, follows_13, follows_14, follows_15, follows_16;
    reg [3:0] follows_17, follows_18, follows_19, follows_20, follows_21, follows_22, follows_23, follows_24;
    reg [3:0] follows_25, follows_26, follows_27, follows_28, follows_29, follows_30, follows_31;
    reg has_next, has_chosen;
    wire [189:0] next;
    reg has_free_follower;
    reg [31:0] free_follower;
    reg [1:0] lead_step;
    reg grid_known;
    reg [7:0] grid_unit;
    reg [4:0] grid_limit;
    reg [15:0] unfinished, comparable;
    reg [11:0] leader_0_x, leader_0_y, leader_0_z, leader_1_x, leader_1_y, leader_1_z, leader_2_x, leader_2_y;
    reg [11:0] leader_2_z, leader_3_x, leader_3_y, leader_3_z, leader_4_x, leader_4_y, leader_4_z, leader_5_x;
    reg [11:0] leader_5_y, leader_5_z, leader_6_x, leader_6_y, leader_6_z, leader_7_x, leader_7_y, leader_7_z;
    reg [11:0] leader_8_x, leader_8_y, leader_8_z, leader_9_x, leader_9_y, leader_9_z, leader_10_x, leader_10_y;
    reg [11:0] leader_10_z, leader_11_x, leader_11_y, leader_11_z, leader_12_x, leader_12_y, leader_12_z;
    reg [11:0] leader_13_x, leader_13_y, leader_13_z, leader_14_x, leader_14_y, leader_14_z, leader_15_x;
    reg [11:0] leader_15_y, leader_15_z;
    reg aligned;
    reg [5:0] lead_x_amount;
    reg lead_x_inside;
    reg [11:0] lead_x_place;
    reg [5:0] lead_y_amount;
    reg lead_y_inside;
    reg [11:0] lead_y_place;
    reg [5:0] lead_z_amount;
    reg lead_z_inside;
    reg [11:0] lead_z_place;
    reg [15:0] near_x, near_y, near_z;
    reg [31:0] entered;
    reg [3:0] followed_before;
    reg hit_before_finishes;
    reg [3:0] hit_before_leader;
    reg delivered_before_finishes;
    reg [3:0] delivered_before_leader;
    reg [7:0] more_readers;

    wire deliver_queue_in_ready, deliver_queue_out_valid;
    wire [27:0] deliver_queue_out_data;
    wire result_queue_in_ready;
    wire [82:0] result_queue_out_data;
    wire asks_in_ready, asks_out_valid;
    wire [194:0] asks_out_data;
    wire check_in_ready, check_out_valid;
    wire [2:0] check_out_entry;
    wire check_out_last, check_out_present;
    wire [7:0] check_out_version;
    wire [31:0] check_out_margin;
    wire check_out_covered, search_queue_in_ready;
    wire [157:0] search_queue_out_data;
    wire found_queue_out_valid;
    wire [81:0] found_queue_out_data;
    wire judge_in_ready, judge_out_valid;
    wire [2:0] judge_out_entry;
    wire [31:0] judge_out_x, judge_out_y, judge_out_z, judge_out_c;
    wire judge_out_leads;
    wire [3:0] judge_out_leader;
    wire query_queue_out_valid;
    wire [189:0] query_queue_out_data;

    wire i_advance = ~i1_valid | check_in_ready;
    wire admits = asked_has_room & admits_query;
    wire issues = asks_out_valid & i_advance & (~first_entry | admits);
    wire found_queue_out_last = found_queue_out_data[57];
    wire open = j_valid & ~answered;
    wire j_given_away = copying & (j_entry == copy_entry);
    wire j_reads = j_matches & ~j_given_away;
    wire hit = open & j_reads;
    wire hits = hit & deliver_queue_in_ready;
    wire copy_ready = copying & (~found_queue_out_last | (deliver_queue_in_ready & ~hits));
    wire copy_takes = found_queue_out_valid & copy_ready;
    wire found_queue_out_found = found_queue_out_data[56];
    wire copy_stores = copy_takes & found_queue_out_found;
    wire [23:0] found_queue_out_index = found_queue_out_data[55:32];
    wire [31:0] found_queue_out_distance2 = found_queue_out_data[31:0];
    wire d_advance = ~d1_valid | result_queue_in_ready;
    wire d0_reads = d0_valid & d_advance;
    wire copy_ends = copy_takes & found_queue_out_last;
    wire [5:0] copy_rank_plus_1 = copy_rank + 6'd1;
    wire copy_full_same = copy_rank_plus_1 == ticket_query[138:133];
    wire copy_full_same_2 = copy_rank == ticket_query[138:133];
    wire deliver_queue_out_ready = ~d0_valid;
    wire d0_takes = deliver_queue_out_ready & deliver_queue_out_valid;
    wire [2:0] deliver_queue_out_entry = deliver_queue_out_data[27:25];
    wire miss = open & (j_last & ~hit);
    wire misses = miss & search_queue_in_ready;
    wire [162:0] asked_head = asked[asked_read_address];
    wire copy_starts_both = found_queue_out_valid & ~copying;
    wire [23:0] found_queue_out_number = found_queue_out_data[81:58];
    wire leads_both = query_queue_out_valid & (lead_step == 2'd3);
    wire [15:0] candidates = near_x & near_y & (near_z & unfinished);
    wire follows = leads_both & (|candidates & has_free_follower);
    wire next_taken = ~has_next | asks_in_ready;
    wire reads_follower = next_taken & has_chosen;
    wire leads = leads_both & (~(|candidates) & (asks_in_ready & ~has_next));
    wire [23:0] query_queue_out_number = query_queue_out_data[189:166];
    wire [5:0] query_queue_out_k = query_queue_out_data[165:160];
    wire [31:0] query_queue_out_radius2 = query_queue_out_data[159:128];
    wire [31:0] query_queue_out_x = query_queue_out_data[127:96];
    wire [31:0] query_queue_out_y = query_queue_out_data[95:64];
    wire [31:0] query_queue_out_z = query_queue_out_data[63:32];
    wire [31:0] query_queue_out_reach = query_queue_out_data[31:0];
    wire [15:0] free_leader = ~unfinished & (16'd0 - ~unfinished);
    wire [3:0] asks_in_data_bits = {
        |(free_leader & 16'hff00), |(free_leader & 16'hf0f0), |(free_leader & 16'hcccc),
        |(free_leader & 16'haaaa)
    };
    wire asks_out_ready = issues & last_entry;
    wire leaves = j_valid & ~((hit & ~hits) | (miss & ~misses));
    wire j_advance = ~j_valid | leaves;
    wire query_taken = follows | leads;
    wire [7:0] eligible_bits = {|readers_7, |readers_6, |readers_5, |readers_4, |readers_3, |readers_2, |readers_1, |readers_0};
    wire [7:0] eligible = ~(eligible_bits | writing | used);
    wire [7:0] before_7 = eligible & {1'd0, older_than_7};
    wire [7:0] before_6 = eligible & {~older_than_7[6], 1'd0, older_than_6};
    wire [7:0] before_5 = eligible & {~older_than_7[5], ~older_than_6[5], 1'd0, older_than_5};
    wire [7:0] before_4_bits = {~older_than_7[4], ~older_than_6[4], ~older_than_5[4], 1'd0, older_than_4};
    wire [7:0] before_4 = eligible & before_4_bits;
    wire [7:0] before_3_bits = {~older_than_7[3], ~older_than_6[3], ~older_than_5[3], ~older_than_4[3], 1'd0, older_than_3};
    wire [7:0] before_3 = eligible & before_3_bits;
    wire [7:0] before_2_bits = {
        ~older_than_7[2], ~older_than_6[2], ~older_than_5[2], ~older_than_4[2], ~older_than_3[2], 1'd0,
        older_than_2
    };
    wire [7:0] before_2 = eligible & before_2_bits;
    wire [7:0] before_1_bits = {
        ~older_than_7[1], ~older_than_6[1], ~older_than_5[1], ~older_than_4[1], ~older_than_3[1],
        ~older_than_2[1], 1'd0, older_than_1
    };
    wire [7:0] before_1 = eligible & before_1_bits;
    wire [7:0] before_0_bits = {
        ~older_than_7[0], ~older_than_6[0], ~older_than_5[0], ~older_than_4[0], ~older_than_3[0],
        ~older_than_2[0], ~older_than_1, 1'd0
    };
    wire [7:0] before_0 = eligible & before_0_bits;
    wire [7:0] oldest = {
        eligible[7] & (before_7 == 8'd0), eligible[6] & (before_6 == 8'd0), eligible[5] & (before_5 == 8'd0),
        eligible[4] & (before_4 == 8'd0), eligible[3] & (before_3 == 8'd0), eligible[2] & (before_2 == 8'd0),
        eligible[1] & (before_1 == 8'd0), eligible[0] & (before_0 == 8'd0)
    };
    wire copy_starts = copy_starts_both & (|eligible & ~hits);
    wire [7:0] start_set = oldest & {8{copy_starts}};
    wire [7:0] judged_set = {
        judge_out_valid & (judge_out_entry == 3'd7), judge_out_valid & (judge_out_entry == 3'd6),
        judge_out_valid & (judge_out_entry == 3'd5), judge_out_valid & (judge_out_entry == 3'd4),
        judge_out_valid & (judge_out_entry == 3'd3), judge_out_valid & (judge_out_entry == 3'd2),
        judge_out_valid & (judge_out_entry == 3'd1), judge_out_valid & (judge_out_entry == 3'd0)
    };
    wire d0_last = (d0_next_rank == count) | (count == 6'd0);
    wire releases = d0_reads & d0_last;
    wire [7:0] release_set = {
        releases & (d0_entry == 3'd7), releases & (d0_entry == 3'd6), releases & (d0_entry == 3'd5),
        releases & (d0_entry == 3'd4), releases & (d0_entry == 3'd3), releases & (d0_entry == 3'd2),
        releases & (d0_entry == 3'd1), releases & (d0_entry == 3'd0)
    };
    wire [7:0] hit_set = {
        hits & (j_entry == 3'd7), hits & (j_entry == 3'd6), hits & (j_entry == 3'd5),
        hits & (j_entry == 3'd4), hits & (j_entry == 3'd3), hits & (j_entry == 3'd2),
        hits & (j_entry == 3'd1), hits & (j_entry == 3'd0)
    };
    wire [19:0] lowest_ticket = ~taken & (20'd0 - ~taken);
    wire takes_ticket = ~any_ticket | misses;
    wire taken_both = copy_ends & (found_queue_out_number[4:2] == 3'd4);
    wire taken_same = found_queue_out_number[1:0] == 2'd3;
    wire taken_same_2 = found_queue_out_number[1:0] == 2'd2;
    wire taken_same_3 = found_queue_out_number[1:0] == 2'd1;
    wire taken_same_4 = found_queue_out_number[1:0] == 2'd0;
    wire taken_both_2 = copy_ends & (found_queue_out_number[4:2] == 3'd3);
    wire taken_both_3 = copy_ends & (found_queue_out_number[4:2] == 3'd2);
    wire taken_both_4 = copy_ends & (found_queue_out_number[4:2] == 3'd1);
    wire taken_both_5 = copy_ends & (found_queue_out_number[4:2] == 3'd0);
    wire [19:0] taken_bits = {
        taken_both & taken_same, taken_both & taken_same_2, taken_both & taken_same_3,
        taken_both & taken_same_4, taken_both_2 & taken_same, taken_both_2 & taken_same_2,
        taken_both_2 & taken_same_3, taken_both_2 & taken_same_4, taken_both_3 & taken_same,
        taken_both_3 & taken_same_2, taken_both_3 & taken_same_3, taken_both_3 & taken_same_4,
        taken_both_4 & taken_same, taken_both_4 & taken_same_2, taken_both_4 & taken_same_3,
        taken_both_4 & taken_same_4, taken_both_5 & taken_same, taken_both_5 & taken_same_2,
        taken_both_5 & taken_same_3, taken_both_5 & taken_same_4
    };
    wire enters = issues & first_entry;
    wire asked_pops = leaves & j_last;
    wire [4:0] still_under_way = (under_way - {4'd0, asked_pops & ~misses}) - {4'd0, copy_ends};
    wire admits_query_either = (still_under_way == 5'd20) | ((still_under_way == 5'd19) & enters);
    wire [7:0] present_shifted_by_next_entry = present >> next_entry;
    wire [7:0] i1_version_choice = next_entry[1] ? (next_entry[0] ? version_7 : version_6) : next_entry[0] ? version_5 : version_4;
    wire [7:0] i1_version_choice_2 = next_entry[1] ? (next_entry[0] ? version_3 : version_2) : next_entry[0] ? version_1 : version_0;
    wire [31:0] asks_out_x = asks_out_data[132:101];
    wire [31:0] asks_out_y = asks_out_data[100:69];
    wire [31:0] asks_out_z = asks_out_data[68:37];
    wire [31:0] asks_out_reach = asks_out_data[36:5];
    wire [7:0] reusable_shifted = present >> check_out_entry;
    wire [7:0] reusable_choice = check_out_entry[1] ? (check_out_entry[0] ? version_7 : version_6) : check_out_entry[0] ? version_5 : version_4;
    wire [7:0] reusable_choice_2 = check_out_entry[1] ? (check_out_entry[0] ? version_3 : version_2) : check_out_entry[0] ? version_1 : version_0;
    wire reusable_same = check_out_version == (check_out_entry[2] ? reusable_choice : reusable_choice_2);
    wire reusable = check_out_present & reusable_shifted[0] & reusable_same;
    wire matched = check_out_covered & reusable;
    wire [2:0] victim = {|(oldest & 8'd240), |(oldest & 8'd204), |(oldest & 8'd170)};
    wire not_copying_or_copy_stores = ~copying | copy_stores;
    wire [5:0] copy_total = copy_rank + {5'd0, found_queue_out_found};
    wire copy_full = found_queue_out_found ? copy_full_same : copy_full_same_2;
    wire reach_near2_choice = found_queue_out_found ? ((copy_rank + 6'd2) == ticket_query[138:133]) : copy_full_same;
    wire [31:0] reach_near2_choice_2 = found_queue_out_found ? found_queue_out_distance2 : copy_previous;
    wire [31:0] reach_near2_choice_3 = reach_near2_choice ? reach_near2_choice_2 : ticket_query[132:101];
    wire [23:0] deliver_queue_out_number = deliver_queue_out_data[24:1];
    wire deliver_queue_out_cached = deliver_queue_out_data[0];
    wire d0_takes_or_d0_reads = d0_takes | d0_reads;
    wire [31:0] follower_enters = free_follower & {32{follows}};
    wire [31:0] follower_ready_bits = {32{|due}};
    wire missed_either = (hit_finishes & (hit_leader == followed_before)) | (delivered_finishes & (delivered_leader == followed_before));
    wire missed_either_2 = missed_either | (hit_before_finishes & (hit_before_leader == followed_before));
    wire missed_both = delivered_before_finishes & (delivered_before_leader == followed_before);
    wire missed = missed_either_2 | missed_both;
    wire becomes_ready_either = (hit_finishes & (hit_leader == follows_31)) | (delivered_finishes & (delivered_leader == follows_31));
    wire becomes_ready_either_2 = (hit_finishes & (hit_leader == follows_30)) | (delivered_finishes & (delivered_leader == follows_30));
    wire becomes_ready_either_3 = (hit_finishes & (hit_leader == follows_29)) | (delivered_finishes & (delivered_leader == follows_29));
    wire becomes_ready_either_4 = (hit_finishes & (hit_leader == follows_28)) | (delivered_finishes & (delivered_leader == follows_28));
    wire becomes_ready_either_5 = (hit_finishes & (hit_leader == follows_27)) | (delivered_finishes & (delivered_leader == follows_27));
    wire becomes_ready_either_6 = (hit_finishes & (hit_leader == follows_26)) | (delivered_finishes & (delivered_leader == follows_26));
    wire becomes_ready_either_7 = (hit_finishes & (hit_leader == follows_25)) | (delivered_finishes & (delivered_leader == follows_25));
    wire becomes_ready_either_8 = (hit_finishes & (hit_leader == follows_24)) | (delivered_finishes & (delivered_leader == follows_24));
    wire becomes_ready_either_9 = (hit_finishes & (hit_leader == follows_23)) | (delivered_finishes & (delivered_leader == follows_23));
    wire becomes_ready_either_10 = (hit_finishes & (hit_leader == follows_22)) | (delivered_finishes & (delivered_leader == follows_22));
    wire becomes_ready_either_11 = (hit_finishes & (hit_leader == follows_21)) | (delivered_finishes & (delivered_leader == follows_21));
    wire becomes_ready_either_12 = (hit_finishes & (hit_leader == follows_20)) | (delivered_finishes & (delivered_leader == follows_20));
    wire becomes_ready_either_13 = (hit_finishes & (hit_leader == follows_19)) | (delivered_finishes & (delivered_leader == follows_19));
    wire becomes_ready_either_14 = (hit_finishes & (hit_leader == follows_18)) | (delivered_finishes & (delivered_leader == follows_18));
    wire becomes_ready_either_15 = (hit_finishes & (hit_leader == follows_17)) | (delivered_finishes & (delivered_leader == follows_17));
    wire becomes_ready_either_16 = (hit_finishes & (hit_leader == follows_16)) | (delivered_finishes & (delivered_leader == follows_16));
    wire becomes_ready_either_17 = (hit_finishes & (hit_leader == follows_15)) | (delivered_finishes & (delivered_leader == follows_15));
    wire becomes_ready_either_18 = (hit_finishes & (hit_leader == follows_14)) | (delivered_finishes & (delivered_leader == follows_14));
    wire becomes_ready_either_19 = (hit_finishes & (hit_leader == follows_13)) | (delivered_finishes & (delivered_leader == follows_13));
    wire becomes_ready_either_20 = (hit_finishes & (hit_leader == follows_12)) | (delivered_finishes & (delivered_leader == follows_12));
    wire becomes_ready_either_21 = (hit_finishes & (hit_leader == follows_11)) | (delivered_finishes & (delivered_leader == follows_11));
    wire becomes_ready_either_22 = (hit_finishes & (hit_leader == follows_10)) | (delivered_finishes & (delivered_leader == follows_10));
    wire becomes_ready_either_23 = (hit_finishes & (hit_leader == follows_9)) | (delivered_finishes & (delivered_leader == follows_9));
    wire becomes_ready_either_24 = (hit_finishes & (hit_leader == follows_8)) | (delivered_finishes & (delivered_leader == follows_8));
    wire becomes_ready_either_25 = (hit_finishes & (hit_leader == follows_7)) | (delivered_finishes & (delivered_leader == follows_7));
    wire becomes_ready_either_26 = (hit_finishes & (hit_leader == follows_6)) | (delivered_finishes & (delivered_leader == follows_6));
    wire becomes_ready_either_27 = (hit_finishes & (hit_leader == follows_5)) | (delivered_finishes & (delivered_leader == follows_5));
    wire becomes_ready_either_28 = (hit_finishes & (hit_leader == follows_4)) | (delivered_finishes & (delivered_leader == follows_4));
    wire becomes_ready_either_29 = (hit_finishes & (hit_leader == follows_3)) | (delivered_finishes & (delivered_leader == follows_3));
    wire becomes_ready_either_30 = (hit_finishes & (hit_leader == follows_2)) | (delivered_finishes & (delivered_leader == follows_2));
    wire becomes_ready_either_31 = (hit_finishes & (hit_leader == follows_1)) | (delivered_finishes & (delivered_leader == follows_1));
    wire becomes_ready_either_32 = (hit_finishes & (hit_leader == follows_0)) | (delivered_finishes & (delivered_leader == follows_0));
    wire [31:0] becomes_ready_bits = {
        becomes_ready_either, becomes_ready_either_2, becomes_ready_either_3, becomes_ready_either_4,
        becomes_ready_either_5, becomes_ready_either_6, becomes_ready_either_7, becomes_ready_either_8,
        becomes_ready_either_9, becomes_ready_either_10, becomes_ready_either_11, becomes_ready_either_12,
        becomes_ready_either_13, becomes_ready_either_14, becomes_ready_either_15, becomes_ready_either_16,
        becomes_ready_either_17, becomes_ready_either_18, becomes_ready_either_19, becomes_ready_either_20,
        becomes_ready_either_21, becomes_ready_either_22, becomes_ready_either_23, becomes_ready_either_24,
        becomes_ready_either_25, becomes_ready_either_26, becomes_ready_either_27, becomes_ready_either_28,
        becomes_ready_either_29, becomes_ready_either_30, becomes_ready_either_31, becomes_ready_either_32
    };
    wire [31:0] becomes_ready = waits & ~(follower_ready | due | chosen) & ((entered & {32{missed}}) | (becomes_ready_bits & ~entered));
    wire [31:0] first_due = due & (32'd0 - due);
    wire chooses_follower = next_taken | ~has_chosen;
    wire grid_follows_both = ~j_margin[31] & ((8'd4 <= j_margin[30:23]) & (j_margin[30:23] < 8'd255));
    wire grid_follows = leaves & j_reusable & grid_follows_both;
    wire [8:0] margin_above_unit = {1'd0, j_margin[30:23]} - {1'd0, grid_unit};
    wire grid_moves_both = grid_known & (margin_above_unit == 9'd2);
    wire grid_moves_both_2 = grid_known & (margin_above_unit == 9'd4);
    wire grid_moves_either = (grid_known & (margin_above_unit == 9'd3)) | grid_moves_both | grid_moves_both_2;
    wire grid_moves = grid_follows & ~grid_moves_either;
    wire [4:0] grid_limit_choice = grid_moves_both ? {3'd1, j_margin[22:21]} : {2'd1, j_margin[22:20]};
    wire [15:0] becomes_leader = free_leader & {16{leads}};
    wire finished_leaders_both = hit_finishes & (hit_leader[3:2] == 2'd3);
    wire hit_leader_1_0_is_3 = hit_leader[1:0] == 2'd3;
    wire hit_leader_1_0_is_2 = hit_leader[1:0] == 2'd2;
    wire hit_leader_1_0_is_1 = hit_leader[1:0] == 2'd1;
    wire hit_leader_1_0_is_0 = hit_leader[1:0] == 2'd0;
    wire finished_leaders_both_2 = hit_finishes & (hit_leader[3:2] == 2'd2);
    wire finished_leaders_both_3 = hit_finishes & (hit_leader[3:2] == 2'd1);
    wire finished_leaders_both_4 = hit_finishes & (hit_leader[3:2] == 2'd0);
    wire [15:0] finished_leaders_bits = {
        finished_leaders_both & hit_leader_1_0_is_3, finished_leaders_both & hit_leader_1_0_is_2,
        finished_leaders_both & hit_leader_1_0_is_1, finished_leaders_both & hit_leader_1_0_is_0,
        finished_leaders_both_2 & hit_leader_1_0_is_3, finished_leaders_both_2 & hit_leader_1_0_is_2,
        finished_leaders_both_2 & hit_leader_1_0_is_1, finished_leaders_both_2 & hit_leader_1_0_is_0,
        finished_leaders_both_3 & hit_leader_1_0_is_3, finished_leaders_both_3 & hit_leader_1_0_is_2,
        finished_leaders_both_3 & hit_leader_1_0_is_1, finished_leaders_both_3 & hit_leader_1_0_is_0,
        finished_leaders_both_4 & hit_leader_1_0_is_3, finished_leaders_both_4 & hit_leader_1_0_is_2,
        finished_leaders_both_4 & hit_leader_1_0_is_1, finished_leaders_both_4 & hit_leader_1_0_is_0
    };
    wire finished_leaders_both_5 = delivered_finishes & (delivered_leader[3:2] == 2'd3);
    wire delivered_leader_1_0_is_3 = delivered_leader[1:0] == 2'd3;
    wire delivered_leader_1_0_is_2 = delivered_leader[1:0] == 2'd2;
    wire delivered_leader_1_0_is_1 = delivered_leader[1:0] == 2'd1;
    wire delivered_leader_1_0_is_0 = delivered_leader[1:0] == 2'd0;
    wire finished_leaders_both_6 = delivered_finishes & (delivered_leader[3:2] == 2'd2);
    wire finished_leaders_both_7 = delivered_finishes & (delivered_leader[3:2] == 2'd1);
    wire finished_leaders_both_8 = delivered_finishes & (delivered_leader[3:2] == 2'd0);
    wire [15:0] finished_leaders_bits_2 = {
        finished_leaders_both_5 & delivered_leader_1_0_is_3,
        finished_leaders_both_5 & delivered_leader_1_0_is_2,
        finished_leaders_both_5 & delivered_leader_1_0_is_1,
        finished_leaders_both_5 & delivered_leader_1_0_is_0,
        finished_leaders_both_6 & delivered_leader_1_0_is_3,
        finished_leaders_both_6 & delivered_leader_1_0_is_2,
        finished_leaders_both_6 & delivered_leader_1_0_is_1,
        finished_leaders_both_6 & delivered_leader_1_0_is_0,
        finished_leaders_both_7 & delivered_leader_1_0_is_3,
        finished_leaders_both_7 & delivered_leader_1_0_is_2,
        finished_leaders_both_7 & delivered_leader_1_0_is_1,
        finished_leaders_both_7 & delivered_leader_1_0_is_0,
        finished_leaders_both_8 & delivered_leader_1_0_is_3,
        finished_leaders_both_8 & delivered_leader_1_0_is_2,
        finished_leaders_both_8 & delivered_leader_1_0_is_1,
        finished_leaders_both_8 & delivered_leader_1_0_is_0
    };
    wire [15:0] finished_leaders = finished_leaders_bits | finished_leaders_bits_2;
    wire [15:0] comparable_either = (comparable & ~becomes_leader) | (becomes_leader & {16{aligned}});
    wire lead_x_amount_enable_both = query_queue_out_valid & (lead_step == 2'd0);
    wire [9:0] grid_unit_plus_34 = {2'd0, grid_unit} + 10'd34;
    wire [9:0] lead_x_shift = grid_unit_plus_34 - {2'd0, query_queue_out_x[30:23]};
    wire lead_x_place_enable_both = query_queue_out_valid & (lead_step == 2'd1);
    wire [34:0] lead_x_place_shifted = {1'd1, query_queue_out_x[22:0], 11'd0} >> lead_x_amount;
    wire [9:0] lead_y_shift = grid_unit_plus_34 - {2'd0, query_queue_out_y[30:23]};
    wire [34:0] lead_y_place_shifted = {1'd1, query_queue_out_y[22:0], 11'd0} >> lead_y_amount;
    wire [9:0] lead_z_shift = grid_unit_plus_34 - {2'd0, query_queue_out_z[30:23]};
    wire [34:0] lead_z_place_shifted = {1'd1, query_queue_out_z[22:0], 11'd0} >> lead_z_amount;
    wire near_x_enable_both = query_queue_out_valid & (lead_step == 2'd2);
    wire [11:0] lead_x_place_minus_leader_15_x = lead_x_place - leader_15_x;
    wire near_x_both = (lead_x_place_minus_leader_15_x[11:5] == 7'd0) & (lead_x_place_minus_leader_15_x[4:0] < grid_limit);
    wire [4:0] near_x_difference = 5'd0 - grid_limit;
    wire near_x_both_2 = &lead_x_place_minus_leader_15_x[11:5] & (near_x_difference < lead_x_place_minus_leader_15_x[4:0]);
    wire [11:0] lead_x_place_minus_leader_14_x = lead_x_place - leader_14_x;
    wire near_x_both_3 = (lead_x_place_minus_leader_14_x[11:5] == 7'd0) & (lead_x_place_minus_leader_14_x[4:0] < grid_limit);
    wire near_x_both_4 = &lead_x_place_minus_leader_14_x[11:5] & (near_x_difference < lead_x_place_minus_leader_14_x[4:0]);
    wire [11:0] lead_x_place_minus_leader_13_x = lead_x_place - leader_13_x;
    wire near_x_both_5 = (lead_x_place_minus_leader_13_x[11:5] == 7'd0) & (lead_x_place_minus_leader_13_x[4:0] < grid_limit);
    wire near_x_both_6 = &lead_x_place_minus_leader_13_x[11:5] & (near_x_difference < lead_x_place_minus_leader_13_x[4:0]);
    wire [11:0] lead_x_place_minus_leader_12_x = lead_x_place - leader_12_x;
    wire near_x_both_7 = (lead_x_place_minus_leader_12_x[11:5] == 7'd0) & (lead_x_place_minus_leader_12_x[4:0] < grid_limit);
    wire near_x_both_8 = &lead_x_place_minus_leader_12_x[11:5] & (near_x_difference < lead_x_place_minus_leader_12_x[4:0]);
    wire [11:0] lead_x_place_minus_leader_11_x = lead_x_place - leader_11_x;
    wire near_x_both_9 = (lead_x_place_minus_leader_11_x[11:5] == 7'd0) & (lead_x_place_minus_leader_11_x[4:0] < grid_limit);
    wire near_x_both_10 = &lead_x_place_minus_leader_11_x[11:5] & (near_x_difference < lead_x_place_minus_leader_11_x[4:0]);
    wire [11:0] lead_x_place_minus_leader_10_x = lead_x_place - leader_10_x;
    wire near_x_both_11 = (lead_x_place_minus_leader_10_x[11:5] == 7'd0) & (lead_x_place_minus_leader_10_x[4:0] < grid_limit);
    wire near_x_both_12 = &lead_x_place_minus_leader_10_x[11:5] & (near_x_difference < lead_x_place_minus_leader_10_x[4:0]);
    wire [11:0] lead_x_place_minus_leader_9_x = lead_x_place - leader_9_x;
    wire near_x_both_13 = (lead_x_place_minus_leader_9_x[11:5] == 7'd0) & (lead_x_place_minus_leader_9_x[4:0] < grid_limit);
    wire near_x_both_14 = &lead_x_place_minus_leader_9_x[11:5] & (near_x_difference < lead_x_place_minus_leader_9_x[4:0]);
    wire [11:0] lead_x_place_minus_leader_8_x = lead_x_place - leader_8_x;
    wire near_x_both_15 = (lead_x_place_minus_leader_8_x[11:5] == 7'd0) & (lead_x_place_minus_leader_8_x[4:0] < grid_limit);
    wire near_x_both_16 = &lead_x_place_minus_leader_8_x[11:5] & (near_x_difference < lead_x_place_minus_leader_8_x[4:0]);
    wire [11:0] lead_x_place_minus_leader_7_x = lead_x_place - leader_7_x;
    wire near_x_both_17 = (lead_x_place_minus_leader_7_x[11:5] == 7'd0) & (lead_x_place_minus_leader_7_x[4:0] < grid_limit);
    wire near_x_both_18 = &lead_x_place_minus_leader_7_x[11:5] & (near_x_difference < lead_x_place_minus_leader_7_x[4:0]);
    wire [11:0] lead_x_place_minus_leader_6_x = lead_x_place - leader_6_x;
    wire near_x_both_19 = (lead_x_place_minus_leader_6_x[11:5] == 7'd0) & (lead_x_place_minus_leader_6_x[4:0] < grid_limit);
    wire near_x_both_20 = &lead_x_place_minus_leader_6_x[11:5] & (near_x_difference < lead_x_place_minus_leader_6_x[4:0]);
    wire [11:0] lead_x_place_minus_leader_5_x = lead_x_place - leader_5_x;
    wire near_x_both_21 = (lead_x_place_minus_leader_5_x[11:5] == 7'd0) & (lead_x_place_minus_leader_5_x[4:0] < grid_limit);
    wire near_x_both_22 = &lead_x_place_minus_leader_5_x[11:5] & (near_x_difference < lead_x_place_minus_leader_5_x[4:0]);
    wire [11:0] lead_x_place_minus_leader_4_x = lead_x_place - leader_4_x;
    wire near_x_both_23 = (lead_x_place_minus_leader_4_x[11:5] == 7'd0) & (lead_x_place_minus_leader_4_x[4:0] < grid_limit);
    wire near_x_both_24 = &lead_x_place_minus_leader_4_x[11:5] & (near_x_difference < lead_x_place_minus_leader_4_x[4:0]);
    wire [11:0] lead_x_place_minus_leader_3_x = lead_x_place - leader_3_x;
    wire near_x_both_25 = (lead_x_place_minus_leader_3_x[11:5] == 7'd0) & (lead_x_place_minus_leader_3_x[4:0] < grid_limit);
    wire near_x_both_26 = &lead_x_place_minus_leader_3_x[11:5] & (near_x_difference < lead_x_place_minus_leader_3_x[4:0]);
    wire [11:0] lead_x_place_minus_leader_2_x = lead_x_place - leader_2_x;
    wire near_x_both_27 = (lead_x_place_minus_leader_2_x[11:5] == 7'd0) & (lead_x_place_minus_leader_2_x[4:0] < grid_limit);
    wire near_x_both_28 = &lead_x_place_minus_leader_2_x[11:5] & (near_x_difference < lead_x_place_minus_leader_2_x[4:0]);
    wire [11:0] lead_x_place_minus_leader_1_x = lead_x_place - leader_1_x;
    wire near_x_both_29 = (lead_x_place_minus_leader_1_x[11:5] == 7'd0) & (lead_x_place_minus_leader_1_x[4:0] < grid_limit);
    wire near_x_both_30 = &lead_x_place_minus_leader_1_x[11:5] & (near_x_difference < lead_x_place_minus_leader_1_x[4:0]);
    wire [11:0] lead_x_place_minus_leader_0_x = lead_x_place - leader_0_x;
    wire near_x_both_31 = (lead_x_place_minus_leader_0_x[11:5] == 7'd0) & (lead_x_place_minus_leader_0_x[4:0] < grid_limit);
    wire near_x_both_32 = &lead_x_place_minus_leader_0_x[11:5] & (near_x_difference < lead_x_place_minus_leader_0_x[4:0]);
    wire [15:0] near_x_bits = {
        near_x_both | near_x_both_2, near_x_both_3 | near_x_both_4, near_x_both_5 | near_x_both_6,
        near_x_both_7 | near_x_both_8, near_x_both_9 | near_x_both_10, near_x_both_11 | near_x_both_12,
        near_x_both_13 | near_x_both_14, near_x_both_15 | near_x_both_16, near_x_both_17 | near_x_both_18,
        near_x_both_19 | near_x_both_20, near_x_both_21 | near_x_both_22, near_x_both_23 | near_x_both_24,
        near_x_both_25 | near_x_both_26, near_x_both_27 | near_x_both_28, near_x_both_29 | near_x_both_30,
        near_x_both_31 | near_x_both_32
    };
    wire [11:0] lead_y_place_minus_leader_15_y = lead_y_place - leader_15_y;
    wire near_y_both = (lead_y_place_minus_leader_15_y[11:5] == 7'd0) & (lead_y_place_minus_leader_15_y[4:0] < grid_limit);
    wire near_y_both_2 = &lead_y_place_minus_leader_15_y[11:5] & (near_x_difference < lead_y_place_minus_leader_15_y[4:0]);
    wire [11:0] lead_y_place_minus_leader_14_y = lead_y_place - leader_14_y;
    wire near_y_both_3 = (lead_y_place_minus_leader_14_y[11:5] == 7'd0) & (lead_y_place_minus_leader_14_y[4:0] < grid_limit);
    wire near_y_both_4 = &lead_y_place_minus_leader_14_y[11:5] & (near_x_difference < lead_y_place_minus_leader_14_y[4:0]);
    wire [11:0] lead_y_place_minus_leader_13_y = lead_y_place - leader_13_y;
    wire near_y_both_5 = (lead_y_place_minus_leader_13_y[11:5] == 7'd0) & (lead_y_place_minus_leader_13_y[4:0] < grid_limit);
    wire near_y_both_6 = &lead_y_place_minus_leader_13_y[11:5] & (near_x_difference < lead_y_place_minus_leader_13_y[4:0]);
    wire [11:0] lead_y_place_minus_leader_12_y = lead_y_place - leader_12_y;
    wire near_y_both_7 = (lead_y_place_minus_leader_12_y[11:5] == 7'd0) & (lead_y_place_minus_leader_12_y[4:0] < grid_limit);
    wire near_y_both_8 = &lead_y_place_minus_leader_12_y[11:5] & (near_x_difference < lead_y_place_minus_leader_12_y[4:0]);
    wire [11:0] lead_y_place_minus_leader_11_y = lead_y_place - leader_11_y;
    wire near_y_both_9 = (lead_y_place_minus_leader_11_y[11:5] == 7'd0) & (lead_y_place_minus_leader_11_y[4:0] < grid_limit);
    wire near_y_both_10 = &lead_y_place_minus_leader_11_y[11:5] & (near_x_difference < lead_y_place_minus_leader_11_y[4:0]);
    wire [11:0] lead_y_place_minus_leader_10_y = lead_y_place - leader_10_y;
    wire near_y_both_11 = (lead_y_place_minus_leader_10_y[11:5] == 7'd0) & (lead_y_place_minus_leader_10_y[4:0] < grid_limit);
    wire near_y_both_12 = &lead_y_place_minus_leader_10_y[11:5] & (near_x_difference < lead_y_place_minus_leader_10_y[4:0]);
    wire [11:0] lead_y_place_minus_leader_9_y = lead_y_place - leader_9_y;
    wire near_y_both_13 = (lead_y_place_minus_leader_9_y[11:5] == 7'd0) & (lead_y_place_minus_leader_9_y[4:0] < grid_limit);
    wire near_y_both_14 = &lead_y_place_minus_leader_9_y[11:5] & (near_x_difference < lead_y_place_minus_leader_9_y[4:0]);
    wire [11:0] lead_y_place_minus_leader_8_y = lead_y_place - leader_8_y;
    wire near_y_both_15 = (lead_y_place_minus_leader_8_y[11:5] == 7'd0) & (lead_y_place_minus_leader_8_y[4:0] < grid_limit);
    wire near_y_both_16 = &lead_y_place_minus_leader_8_y[11:5] & (near_x_difference < lead_y_place_minus_leader_8_y[4:0]);
    wire [11:0] lead_y_place_minus_leader_7_y = lead_y_place - leader_7_y;
    wire near_y_both_17 = (lead_y_place_minus_leader_7_y[11:5] == 7'd0) & (lead_y_place_minus_leader_7_y[4:0] < grid_limit);
    wire near_y_both_18 = &lead_y_place_minus_leader_7_y[11:5] & (near_x_difference < lead_y_place_minus_leader_7_y[4:0]);
    wire [11:0] lead_y_place_minus_leader_6_y = lead_y_place - leader_6_y;
    wire near_y_both_19 = (lead_y_place_minus_leader_6_y[11:5] == 7'd0) & (lead_y_place_minus_leader_6_y[4:0] < grid_limit);
    wire near_y_both_20 = &lead_y_place_minus_leader_6_y[11:5] & (near_x_difference < lead_y_place_minus_leader_6_y[4:0]);
    wire [11:0] lead_y_place_minus_leader_5_y = lead_y_place - leader_5_y;
    wire near_y_both_21 = (lead_y_place_minus_leader_5_y[11:5] == 7'd0) & (lead_y_place_minus_leader_5_y[4:0] < grid_limit);
    wire near_y_both_22 = &lead_y_place_minus_leader_5_y[11:5] & (near_x_difference < lead_y_place_minus_leader_5_y[4:0]);
    wire [11:0] lead_y_place_minus_leader_4_y = lead_y_place - leader_4_y;
    wire near_y_both_23 = (lead_y_place_minus_leader_4_y[11:5] == 7'd0) & (lead_y_place_minus_leader_4_y[4:0] < grid_limit);
    wire near_y_both_24 = &lead_y_place_minus_leader_4_y[11:5] & (near_x_difference < lead_y_place_minus_leader_4_y[4:0]);
    wire [11:0] lead_y_place_minus_leader_3_y = lead_y_place - leader_3_y;
    wire near_y_both_25 = (lead_y_place_minus_leader_3_y[11:5] == 7'd0) & (lead_y_place_minus_leader_3_y[4:0] < grid_limit);
    wire near_y_both_26 = &lead_y_place_minus_leader_3_y[11:5] & (near_x_difference < lead_y_place_minus_leader_3_y[4:0]);
    wire [11:0] lead_y_place_minus_leader_2_y = lead_y_place - leader_2_y;
    wire near_y_both_27 = (lead_y_place_minus_leader_2_y[11:5] == 7'd0) & (lead_y_place_minus_leader_2_y[4:0] < grid_limit);
    wire near_y_both_28 = &lead_y_place_minus_leader_2_y[11:5] & (near_x_difference < lead_y_place_minus_leader_2_y[4:0]);
    wire [11:0] lead_y_place_minus_leader_1_y = lead_y_place - leader_1_y;
    wire near_y_both_29 = (lead_y_place_minus_leader_1_y[11:5] == 7'd0) & (lead_y_place_minus_leader_1_y[4:0] < grid_limit);
    wire near_y_both_30 = &lead_y_place_minus_leader_1_y[11:5] & (near_x_difference < lead_y_place_minus_leader_1_y[4:0]);
    wire [11:0] lead_y_place_minus_leader_0_y = lead_y_place - leader_0_y;
    wire near_y_both_31 = (lead_y_place_minus_leader_0_y[11:5] == 7'd0) & (lead_y_place_minus_leader_0_y[4:0] < grid_limit);
    wire near_y_both_32 = &lead_y_place_minus_leader_0_y[11:5] & (near_x_difference < lead_y_place_minus_leader_0_y[4:0]);
    wire [11:0] lead_z_place_minus_leader_15_z = lead_z_place - leader_15_z;
    wire near_z_both = (lead_z_place_minus_leader_15_z[11:5] == 7'd0) & (lead_z_place_minus_leader_15_z[4:0] < grid_limit);
    wire near_z_both_2 = &lead_z_place_minus_leader_15_z[11:5] & (near_x_difference < lead_z_place_minus_leader_15_z[4:0]);
    wire [11:0] lead_z_place_minus_leader_14_z = lead_z_place - leader_14_z;
    wire near_z_both_3 = (lead_z_place_minus_leader_14_z[11:5] == 7'd0) & (lead_z_place_minus_leader_14_z[4:0] < grid_limit);
    wire near_z_both_4 = &lead_z_place_minus_leader_14_z[11:5] & (near_x_difference < lead_z_place_minus_leader_14_z[4:0]);
    wire [11:0] lead_z_place_minus_leader_13_z = lead_z_place - leader_13_z;
    wire near_z_both_5 = (lead_z_place_minus_leader_13_z[11:5] == 7'd0) & (lead_z_place_minus_leader_13_z[4:0] < grid_limit);
    wire near_z_both_6 = &lead_z_place_minus_leader_13_z[11:5] & (near_x_difference < lead_z_place_minus_leader_13_z[4:0]);
    wire [11:0] lead_z_place_minus_leader_12_z = lead_z_place - leader_12_z;
    wire near_z_both_7 = (lead_z_place_minus_leader_12_z[11:5] == 7'd0) & (lead_z_place_minus_leader_12_z[4:0] < grid_limit);
    wire near_z_both_8 = &lead_z_place_minus_leader_12_z[11:5] & (near_x_difference < lead_z_place_minus_leader_12_z[4:0]);
    wire [11:0] lead_z_place_minus_leader_11_z = lead_z_place - leader_11_z;
    wire near_z_both_9 = (lead_z_place_minus_leader_11_z[11:5] == 7'd0) & (lead_z_place_minus_leader_11_z[4:0] < grid_limit);
    wire near_z_both_10 = &lead_z_place_minus_leader_11_z[11:5] & (near_x_difference < lead_z_place_minus_leader_11_z[4:0]);
    wire [11:0] lead_z_place_minus_leader_10_z = lead_z_place - leader_10_z;
    wire near_z_both_11 = (lead_z_place_minus_leader_10_z[11:5] == 7'd0) & (lead_z_place_minus_leader_10_z[4:0] < grid_limit);
    wire near_z_both_12 = &lead_z_place_minus_leader_10_z[11:5] & (near_x_difference < lead_z_place_minus_leader_10_z[4:0]);
    wire [11:0] lead_z_place_minus_leader_9_z = lead_z_place - leader_9_z;
    wire near_z_both_13 = (lead_z_place_minus_leader_9_z[11:5] == 7'd0) & (lead_z_place_minus_leader_9_z[4:0] < grid_limit);
    wire near_z_both_14 = &lead_z_place_minus_leader_9_z[11:5] & (near_x_difference < lead_z_place_minus_leader_9_z[4:0]);
    wire [11:0] lead_z_place_minus_leader_8_z = lead_z_place - leader_8_z;
    wire near_z_both_15 = (lead_z_place_minus_leader_8_z[11:5] == 7'd0) & (lead_z_place_minus_leader_8_z[4:0] < grid_limit);
    wire near_z_both_16 = &lead_z_place_minus_leader_8_z[11:5] & (near_x_difference < lead_z_place_minus_leader_8_z[4:0]);
    wire [11:0] lead_z_place_minus_leader_7_z = lead_z_place - leader_7_z;
    wire near_z_both_17 = (lead_z_place_minus_leader_7_z[11:5] == 7'd0) & (lead_z_place_minus_leader_7_z[4:0] < grid_limit);
    wire near_z_both_18 = &lead_z_place_minus_leader_7_z[11:5] & (near_x_difference < lead_z_place_minus_leader_7_z[4:0]);
    wire [11:0] lead_z_place_minus_leader_6_z = lead_z_place - leader_6_z;
    wire near_z_both_19 = (lead_z_place_minus_leader_6_z[11:5] == 7'd0) & (lead_z_place_minus_leader_6_z[4:0] < grid_limit);
    wire near_z_both_20 = &lead_z_place_minus_leader_6_z[11:5] & (near_x_difference < lead_z_place_minus_leader_6_z[4:0]);
    wire [11:0] lead_z_place_minus_leader_5_z = lead_z_place - leader_5_z;
    wire near_z_both_21 = (lead_z_place_minus_leader_5_z[11:5] == 7'd0) & (lead_z_place_minus_leader_5_z[4:0] < grid_limit);
    wire near_z_both_22 = &lead_z_place_minus_leader_5_z[11:5] & (near_x_difference < lead_z_place_minus_leader_5_z[4:0]);
    wire [11:0] lead_z_place_minus_leader_4_z = lead_z_place - leader_4_z;
    wire near_z_both_23 = (lead_z_place_minus_leader_4_z[11:5] == 7'd0) & (lead_z_place_minus_leader_4_z[4:0] < grid_limit);
    wire near_z_both_24 = &lead_z_place_minus_leader_4_z[11:5] & (near_x_difference < lead_z_place_minus_leader_4_z[4:0]);
    wire [11:0] lead_z_place_minus_leader_3_z = lead_z_place - leader_3_z;
    wire near_z_both_25 = (lead_z_place_minus_leader_3_z[11:5] == 7'd0) & (lead_z_place_minus_leader_3_z[4:0] < grid_limit);
    wire near_z_both_26 = &lead_z_place_minus_leader_3_z[11:5] & (near_x_difference < lead_z_place_minus_leader_3_z[4:0]);
    wire [11:0] lead_z_place_minus_leader_2_z = lead_z_place - leader_2_z;
    wire near_z_both_27 = (lead_z_place_minus_leader_2_z[11:5] == 7'd0) & (lead_z_place_minus_leader_2_z[4:0] < grid_limit);
    wire near_z_both_28 = &lead_z_place_minus_leader_2_z[11:5] & (near_x_difference < lead_z_place_minus_leader_2_z[4:0]);
    wire [11:0] lead_z_place_minus_leader_1_z = lead_z_place - leader_1_z;
    wire near_z_both_29 = (lead_z_place_minus_leader_1_z[11:5] == 7'd0) & (lead_z_place_minus_leader_1_z[4:0] < grid_limit);
    wire near_z_both_30 = &lead_z_place_minus_leader_1_z[11:5] & (near_x_difference < lead_z_place_minus_leader_1_z[4:0]);
    wire [11:0] lead_z_place_minus_leader_0_z = lead_z_place - leader_0_z;
    wire near_z_both_31 = (lead_z_place_minus_leader_0_z[11:5] == 7'd0) & (lead_z_place_minus_leader_0_z[4:0] < grid_limit);
    wire near_z_both_32 = &lead_z_place_minus_leader_0_z[11:5] & (near_x_difference < lead_z_place_minus_leader_0_z[4:0]);
    wire [15:0] first_candidate = candidates & (16'd0 - candidates);
    wire [3:0] followed = {
        |(first_candidate & 16'hff00), |(first_candidate & 16'hf0f0), |(first_candidate & 16'hcccc),
        |(first_candidate & 16'haaaa)
    };
    wire [7:0] end_set = {
        copy_ends & (copy_entry == 3'd7), copy_ends & (copy_entry == 3'd6), copy_ends & (copy_entry == 3'd5),
        copy_ends & (copy_entry == 3'd4), copy_ends & (copy_entry == 3'd3), copy_ends & (copy_entry == 3'd2),
        copy_ends & (copy_entry == 3'd1), copy_ends & (copy_entry == 3'd0)
    };

    assign {result_number, result_last, result_found, result_index, result_distance2, result_cached} = result_queue_out_data;
    assign {search_number, search_k, search_radius2, search_x, search_y, search_z} = search_queue_out_data;

    memory_1w1r #(.WIDTH(128), .DEPTH(8)) covers (
        .clk(clk), .write(judge_out_valid), .write_address(judge_out_entry),
        .write_data({judge_out_x, judge_out_y, judge_out_z, judge_out_c}),
        .read(issues), .read_address(next_entry), .read_data(entry_cover)
    );

    memory_1w1r_unordered #(.WIDTH(55), .DEPTH(256)) neighborhoods (
        .clk(clk), .write(copy_stores), .write_address({copy_entry, copy_rank[4:0]}),
        .write_data({found_queue_out_index, found_queue_out_distance2[30:0]}),
        .read(d0_reads), .read_address({d0_entry, d0_rank[4:0]}), .read_data(neighbor)
    );

    memory_1w1r #(.WIDTH(6), .DEPTH(8)) counts (
        .clk(clk), .write(copy_ends), .write_address(copy_entry),
        .write_data(found_queue_out_found ? ((copy_full_same & ~ball) ? copy_rank : copy_rank_plus_1) : (copy_full_same_2 & ~ball) ? (copy_rank - 6'd1) : copy_rank),
        .read(d0_takes), .read_address(deliver_queue_out_entry), .read_data(count)
    );

    memory_1w1r #(.WIDTH(163), .DEPTH(32)) tickets (
        .clk(clk), .write(misses), .write_address(next_ticket), .write_data(asked_head),
        .read(copy_starts_both), .read_address(found_queue_out_number[4:0]), .read_data(ticket_query)
    );

    memory_1w1r #(.WIDTH(190), .DEPTH(32)) followers (
        .clk(clk), .write(follows),
        .write_address({
            |(free_follower & 32'hffff0000), |(free_follower & 32'hff00ff00), |(free_follower & 32'hf0f0f0f0),
            |(free_follower & 32'hcccccccc), |(free_follower & 32'haaaaaaaa)
        }),
        .write_data(query_queue_out_data),
        .read(reads_follower),
        .read_address({
            |(chosen & 32'hffff0000), |(chosen & 32'hff00ff00), |(chosen & 32'hf0f0f0f0),
            |(chosen & 32'hcccccccc), |(chosen & 32'haaaaaaaa)
        }),
        .read_data(next)
    );

    stream_fifo_d4_w28 deliver_queue (
        .clk(clk), .rst(rst), .in_valid(hits | copy_ends), .in_ready(deliver_queue_in_ready),
        .in_data({hits ? j_entry : copy_entry, hits ? asked_head[162:139] : ticket_query[162:139], hits}),
        .out_valid(deliver_queue_out_valid), .out_ready(deliver_queue_out_ready),
        .out_data(deliver_queue_out_data)
    );

    stream_skid_w83 result_queue (
        .clk(clk), .rst(rst), .in_valid(d1_valid & result_queue_in_ready), .in_ready(result_queue_in_ready),
        .in_data({
            d1_number, d1_last, d1_found, d1_found ? neighbor[54:31] : 24'd0, 1'd0,
            d1_found ? neighbor[30:0] : 31'd0, d1_cached
        }),
        .out_valid(result_valid), .out_ready(result_ready), .out_data(result_queue_out_data)
    );

    stream_skid_w195 asks (
        .clk(clk), .rst(rst), .in_valid(has_next | leads), .in_ready(asks_in_ready),
        .in_data({
            has_next ? next[189:166] : query_queue_out_number, has_next ? next[165:160] : query_queue_out_k,
            has_next ? next[159:128] : query_queue_out_radius2, has_next ? next[127:96] : query_queue_out_x,
            has_next ? next[95:64] : query_queue_out_y, has_next ? next[63:32] : query_queue_out_z,
            has_next ? next[31:0] : query_queue_out_reach, has_next ? 1'd0 : |free_leader,
            has_next ? 4'd0 : asks_in_data_bits
        }),
        .out_valid(asks_out_valid), .out_ready(asks_out_ready), .out_data(asks_out_data)
    );

    search_check check (
        .clk(clk), .rst(rst), .in_valid(i1_valid), .in_ready(check_in_ready), .in_entry(i1_entry),
        .in_last(i1_last), .in_present(i1_present), .in_version(i1_version), .in_x(i1_x), .in_y(i1_y),
        .in_z(i1_z), .in_reach(i1_reach), .in_entry_x(entry_cover[127:96]), .in_entry_y(entry_cover[95:64]),
        .in_entry_z(entry_cover[63:32]), .in_entry_c(entry_cover[31:0]),
        .margin_scale(margin_scale),
        .out_valid(check_out_valid), .out_ready(j_advance), .out_entry(check_out_entry),
        .out_last(check_out_last), .out_present(check_out_present), .out_version(check_out_version),
        .out_margin(check_out_margin), .out_covered(check_out_covered)
    );

    stream_skid_w158 search_queue (
        .clk(clk), .rst(rst), .in_valid(misses), .in_ready(search_queue_in_ready),
        .in_data({19'd0, next_ticket, asked_head[138:5]}),
        .out_valid(search_valid), .out_ready(search_ready), .out_data(search_queue_out_data)
    );

    stream_skid_w82 found_queue (
        .clk(clk), .rst(rst), .in_valid(found_valid), .in_ready(found_ready),
        .in_data({found_number, found_last, found_found, found_index, found_distance2}),
        .out_valid(found_queue_out_valid), .out_ready(copy_ready), .out_data(found_queue_out_data)
    );

    search_cover judge (
        .clk(clk), .rst(rst), .in_valid(reach_valid), .in_ready(judge_in_ready), .in_entry(reach_entry),
        .in_x(reach_x), .in_y(reach_y), .in_z(reach_z), .in_far2(reach_far2), .in_near2(reach_near2),
        .in_leads(reach_leads), .in_leader(reach_leader),
        .far_scale(far_scale),
        .out_valid(judge_out_valid), .out_ready(1'd1), .out_entry(judge_out_entry), .out_x(judge_out_x),
        .out_y(judge_out_y), .out_z(judge_out_z), .out_c(judge_out_c), .out_leads(judge_out_leads),
        .out_leader(judge_out_leader)
    );

    stream_skid_w190 query_queue (
        .clk(clk), .rst(rst), .in_valid(query_valid), .in_ready(query_ready),
        .in_data({query_number, query_k, query_radius2, query_x, query_y, query_z, query_reach}),
        .out_valid(query_queue_out_valid), .out_ready(query_taken), .out_data(query_queue_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            present <= 8'd0;
            writing <= 8'd0;
            stale <= 8'd0;
            version_0 <= 8'd0;
            version_1 <= 8'd0;
            version_2 <= 8'd0;
            version_3 <= 8'd0;
            version_4 <= 8'd0;
            version_5 <= 8'd0;
            version_6 <= 8'd0;
            version_7 <= 8'd0;
            readers_0 <= 3'd0;
            readers_1 <= 3'd0;
            readers_2 <= 3'd0;
            readers_3 <= 3'd0;
            readers_4 <= 3'd0;
            readers_5 <= 3'd0;
            readers_6 <= 3'd0;
            readers_7 <= 3'd0;
            older_than_1 <= 1'd1;
            older_than_2 <= 2'd3;
            older_than_3 <= 3'd7;
            older_than_4 <= 4'd15;
            older_than_5 <= 5'd31;
            older_than_6 <= 6'd63;
            older_than_7 <= 7'd127;
            used <= 8'd0;
            taken <= 20'd0;
            any_ticket <= 1'd0;
            under_way <= 5'd0;
            admits_query <= 1'd1;
            next_entry <= 3'd0;
            first_entry <= 1'd1;
            last_entry <= 1'd0;
            asked_count <= 4'd0;
            asked_write_address <= 3'd0;
            asked_read_address <= 3'd0;
            asked_has_room <= 1'd1;
            i1_valid <= 1'd0;
            j_valid <= 1'd0;
            answered <= 1'd0;
            event_cache_hit <= 1'd0;
            event_cache_miss <= 1'd0;
            copying <= 1'd0;
            reach_valid <= 1'd0;
            d0_valid <= 1'd0;
            d1_valid <= 1'd0;
            hit_finishes <= 1'd0;
            delivered_finishes <= 1'd0;
            waits <= 32'd0;
            follower_ready <= 32'd0;
            due <= 32'd0;
            chosen <= 32'd0;
            has_next <= 1'd0;
            has_chosen <= 1'd0;
            has_free_follower <= 1'd0;
            lead_step <= 2'd0;
            grid_known <= 1'd0;
            unfinished <= 16'd0;
            entered <= 32'd0;
            hit_before_finishes <= 1'd0;
            delivered_before_finishes <= 1'd0;
            more_readers <= 8'd0;
        end else begin
            present <= ((present & ~start_set) | (judged_set & ~stale)) & ~{8{setup_valid}};
            writing <= (writing | start_set) & ~judged_set;
            stale <= (stale | (writing & {8{setup_valid}})) & ~judged_set;
            readers_0 <= (readers_0 + {2'd0, more_readers[0]}) - {2'd0, release_set[0]};
            readers_1 <= (readers_1 + {2'd0, more_readers[1]}) - {2'd0, release_set[1]};
            readers_2 <= (readers_2 + {2'd0, more_readers[2]}) - {2'd0, release_set[2]};
            readers_3 <= (readers_3 + {2'd0, more_readers[3]}) - {2'd0, release_set[3]};
            readers_4 <= (readers_4 + {2'd0, more_readers[4]}) - {2'd0, release_set[4]};
            readers_5 <= (readers_5 + {2'd0, more_readers[5]}) - {2'd0, release_set[5]};
            readers_6 <= (readers_6 + {2'd0, more_readers[6]}) - {2'd0, release_set[6]};
            readers_7 <= (readers_7 + {2'd0, more_readers[7]}) - {2'd0, release_set[7]};
            older_than_1 <= used[1] ? 1'd1 : (older_than_1 & ~used[0]);
            older_than_2 <= used[2] ? 2'd3 : (older_than_2 & ~used[1:0]);
            older_than_3 <= used[3] ? 3'd7 : (older_than_3 & ~used[2:0]);
            older_than_4 <= used[4] ? 4'd15 : (older_than_4 & ~used[3:0]);
            older_than_5 <= used[5] ? 5'd31 : (older_than_5 & ~used[4:0]);
            older_than_6 <= used[6] ? 6'd63 : (older_than_6 & ~used[5:0]);
            older_than_7 <= used[7] ? 7'd127 : (older_than_7 & ~used[6:0]);
            used <= hit_set | start_set;
            taken <= (taken | (lowest_ticket & {20{takes_ticket}})) & ~taken_bits;
            under_way <= enters ? (still_under_way + 5'd1) : still_under_way;
            admits_query <= ~admits_query_either;
            asked_count <= (asked_count + {3'd0, enters}) - {3'd0, asked_pops};
            asked_has_room <= asked_pops | ~((asked_count == 4'd8) | ((asked_count == 4'd7) & enters));
            answered <= (answered | hits) & ~asked_pops;
            event_cache_hit <= hits;
            event_cache_miss <= misses;
            copying <= copy_starts | (copying & ~copy_ends);
            reach_valid <= copy_ends;
            d0_valid <= d0_takes | (d0_valid & ~releases);
            hit_finishes <= hits & asked_head[4];
            delivered_finishes <= judge_out_valid & judge_out_leads;
            waits <= (waits & ~(chosen & {32{reads_follower}})) | follower_enters;
            follower_ready <= (follower_ready & follower_ready_bits) | becomes_ready;
            due <= (due & ~(first_due & {32{chooses_follower}})) | (follower_ready & ~follower_ready_bits);
            has_free_follower <= ~(&waits);
            grid_known <= (grid_known | grid_follows) & ~setup_valid;
            unfinished <= (unfinished | becomes_leader) & ~finished_leaders;
            entered <= follower_enters;
            hit_before_finishes <= hit_finishes;
            delivered_before_finishes <= delivered_finishes;
            more_readers <= hit_set | end_set;
            if (start_set[0]) version_0 <= version_0 + 8'd1;
            if (start_set[1]) version_1 <= version_1 + 8'd1;
            if (start_set[2]) version_2 <= version_2 + 8'd1;
            if (start_set[3]) version_3 <= version_3 + 8'd1;
            if (start_set[4]) version_4 <= version_4 + 8'd1;
            if (start_set[5]) version_5 <= version_5 + 8'd1;
            if (start_set[6]) version_6 <= version_6 + 8'd1;
            if (start_set[7]) version_7 <= version_7 + 8'd1;
            if (takes_ticket) any_ticket <= ~(&taken);
            if (issues) begin
                next_entry <= last_entry ? 3'd0 : (next_entry + 3'd1);
                first_entry <= last_entry;
                last_entry <= next_entry == 3'd6;
            end
            if (enters) asked_write_address <= asked_write_address + 3'd1;
            if (asked_pops) asked_read_address <= asked_read_address + 3'd1;
            if (i_advance) i1_valid <= issues;
            if (j_advance) j_valid <= check_out_valid;
            if (d_advance) d1_valid <= d0_valid;
            if (chooses_follower) begin
                chosen <= first_due;
                has_chosen <= |due;
            end
            if (next_taken) has_next <= has_chosen;
            if (query_queue_out_valid & (~leads_both | query_taken)) begin
                lead_step <= lead_step + 2'd1;
            end
        end
    end
    always @(posedge clk) begin
        if (setup_valid) begin
            ball <= setup_ball;
            far_scale <= setup_far_scale;
            margin_scale <= setup_margin_scale;
        end
        if (takes_ticket) begin
            next_ticket <= {
                |(lowest_ticket & 20'hf0000), |(lowest_ticket & 20'hff00), |(lowest_ticket & 20'hf0f0),
                |(lowest_ticket & 20'hccccc), |(lowest_ticket & 20'haaaaa)
            };
        end
        if (issues) begin
            i1_entry <= next_entry;
            i1_last <= last_entry;
            i1_present <= present_shifted_by_next_entry[0];
            i1_version <= next_entry[2] ? i1_version_choice : i1_version_choice_2;
            i1_x <= asks_out_x;
            i1_y <= asks_out_y;
            i1_z <= asks_out_z;
            i1_reach <= asks_out_reach;
        end
        j_matches <= j_advance ? matched : j_reads;
        reach_entry <= copy_entry;
        reach_x <= ticket_query[100:69];
        reach_y <= ticket_query[68:37];
        reach_z <= ticket_query[36:5];
        reach_far2 <= copy_full ? found_queue_out_distance2 : ticket_query[132:101];
        reach_near2 <= ball ? 32'd0 : copy_full ? copy_previous : reach_near2_choice_3;
        reach_leads <= ticket_query[4];
        reach_leader <= ticket_query[3:0];
        hit_leader <= asked_head[3:0];
        delivered_leader <= judge_out_leader;
        free_follower <= ~waits & (32'd0 - ~waits);
        comparable <= (|becomes_leader ? comparable_either : comparable) & ~{16{grid_moves}};
        aligned <= (lead_x_amount_enable_both | aligned) & ~grid_moves;
        followed_before <= followed;
        hit_before_leader <= hit_leader;
        delivered_before_leader <= delivered_leader;
        if (j_advance) begin
            j_entry <= check_out_entry;
            j_last <= check_out_last;
            j_reusable <= reusable;
            j_margin <= check_out_margin;
        end
        if (~copying) copy_entry <= victim;
        if (not_copying_or_copy_stores) begin
            copy_rank <= copying ? copy_total : 6'd0;
            copy_previous <= copying ? found_queue_out_distance2 : 32'd0;
        end
        if (d0_takes) begin
            d0_entry <= deliver_queue_out_entry;
            d0_number <= deliver_queue_out_number;
            d0_cached <= deliver_queue_out_cached;
        end
        if (d0_takes_or_d0_reads) begin
            d0_rank <= d0_takes ? 6'd0 : d0_next_rank;
            d0_next_rank <= d0_takes ? 6'd1 : (d0_next_rank + 6'd1);
        end
        if (d0_reads) begin
            d1_number <= d0_number;
            d1_last <= d0_last;
            d1_found <= |count;
            d1_cached <= d0_cached;
        end
        if (entered[0]) follows_0 <= followed_before;
        if (entered[1]) follows_1 <= followed_before;
        if (entered[2]) follows_2 <= followed_before;
        if (entered[3]) follows_3 <= followed_before;
        if (entered[4]) follows_4 <= followed_before;
        if (entered[5]) follows_5 <= followed_before;
        if (entered[6]) follows_6 <= followed_before;
        if (entered[7]) follows_7 <= followed_before;
        if (entered[8]) follows_8 <= followed_before;
        if (entered[9]) follows_9 <= followed_before;
        if (entered[10]) follows_10 <= followed_before;
        if (entered[11]) follows_11 <= followed_before;
        if (entered[12]) follows_12 <= followed_before;
        if (entered[13]) follows_13 <= followed_before;
        if (entered[14]) follows_14 <= followed_before;
        if (entered[15]) follows_15 <= followed_before;
        if (entered[16]) follows_16 <= followed_before;
        if (entered[17]) follows_17 <= followed_before;
        if (entered[18]) follows_18 <= followed_before;
        if (entered[19]) follows_19 <= followed_before;
        if (entered[20]) follows_20 <= followed_before;
        if (entered[21]) follows_21 <= followed_before;
        if (entered[22]) follows_22 <= followed_before;
        if (entered[23]) follows_23 <= followed_before;
        if (entered[24]) follows_24 <= followed_before;
        if (entered[25]) follows_25 <= followed_before;
        if (entered[26]) follows_26 <= followed_before;
        if (entered[27]) follows_27 <= followed_before;
        if (entered[28]) follows_28 <= followed_before;
        if (entered[29]) follows_29 <= followed_before;
        if (entered[30]) follows_30 <= followed_before;
        if (entered[31]) follows_31 <= followed_before;
        if (grid_moves) grid_unit <= j_margin[30:23] - 8'd3;
        if (grid_follows) begin
            grid_limit <= grid_moves_both_2 ? {1'd1, j_margin[22:19]} : grid_limit_choice;
        end
        if (becomes_leader[0]) begin
            leader_0_x <= lead_x_place;
            leader_0_y <= lead_y_place;
            leader_0_z <= lead_z_place;
        end
        if (becomes_leader[1]) begin
            leader_1_x <= lead_x_place;
            leader_1_y <= lead_y_place;
            leader_1_z <= lead_z_place;
        end
        if (becomes_leader[2]) begin
            leader_2_x <= lead_x_place;
            leader_2_y <= lead_y_place;
            leader_2_z <= lead_z_place;
        end
        if (becomes_leader[3]) begin
            leader_3_x <= lead_x_place;
            leader_3_y <= lead_y_place;
            leader_3_z <= lead_z_place;
        end
        if (becomes_leader[4]) begin
            leader_4_x <= lead_x_place;
            leader_4_y <= lead_y_place;
            leader_4_z <= lead_z_place;
        end
        if (becomes_leader[5]) begin
            leader_5_x <= lead_x_place;
            leader_5_y <= lead_y_place;
            leader_5_z <= lead_z_place;
        end
        if (becomes_leader[6]) begin
            leader_6_x <= lead_x_place;
            leader_6_y <= lead_y_place;
            leader_6_z <= lead_z_place;
        end
        if (becomes_leader[7]) begin
            leader_7_x <= lead_x_place;
            leader_7_y <= lead_y_place;
            leader_7_z <= lead_z_place;
        end
        if (becomes_leader[8]) begin
            leader_8_x <= lead_x_place;
            leader_8_y <= lead_y_place;
            leader_8_z <= lead_z_place;
        end
        if (becomes_leader[9]) begin
            leader_9_x <= lead_x_place;
            leader_9_y <= lead_y_place;
            leader_9_z <= lead_z_place;
        end
        if (becomes_leader[10]) begin
            leader_10_x <= lead_x_place;
            leader_10_y <= lead_y_place;
            leader_10_z <= lead_z_place;
        end
        if (becomes_leader[11]) begin
            leader_11_x <= lead_x_place;
            leader_11_y <= lead_y_place;
            leader_11_z <= lead_z_place;
        end
        if (becomes_leader[12]) begin
            leader_12_x <= lead_x_place;
            leader_12_y <= lead_y_place;
            leader_12_z <= lead_z_place;
        end
        if (becomes_leader[13]) begin
            leader_13_x <= lead_x_place;
            leader_13_y <= lead_y_place;
            leader_13_z <= lead_z_place;
        end
        if (becomes_leader[14]) begin
            leader_14_x <= lead_x_place;
            leader_14_y <= lead_y_place;
            leader_14_z <= lead_z_place;
        end
        if (becomes_leader[15]) begin
            leader_15_x <= lead_x_place;
            leader_15_y <= lead_y_place;
            leader_15_z <= lead_z_place;
        end
        if (lead_x_amount_enable_both) begin
            lead_x_amount <= lead_x_shift[5:0];
            lead_x_inside <= lead_x_shift[9:6] == 4'd0;
            lead_y_amount <= lead_y_shift[5:0];
            lead_y_inside <= lead_y_shift[9:6] == 4'd0;
            lead_z_amount <= lead_z_shift[5:0];
            lead_z_inside <= lead_z_shift[9:6] == 4'd0;
        end
        if (lead_x_place_enable_both) begin
            lead_x_place <= (lead_x_place_shifted[11:0] & {12{lead_x_inside}}) ^ {12{query_queue_out_x[31]}};
            lead_y_place <= (lead_y_place_shifted[11:0] & {12{lead_y_inside}}) ^ {12{query_queue_out_y[31]}};
            lead_z_place <= (lead_z_place_shifted[11:0] & {12{lead_z_inside}}) ^ {12{query_queue_out_z[31]}};
        end
        if (near_x_enable_both) begin
            near_x <= near_x_bits & ({16{aligned & grid_known}} & comparable);
            near_y <= {
                near_y_both | near_y_both_2, near_y_both_3 | near_y_both_4, near_y_both_5 | near_y_both_6,
                near_y_both_7 | near_y_both_8, near_y_both_9 | near_y_both_10, near_y_both_11 | near_y_both_12,
                near_y_both_13 | near_y_both_14, near_y_both_15 | near_y_both_16, near_y_both_17 | near_y_both_18,
                near_y_both_19 | near_y_both_20, near_y_both_21 | near_y_both_22, near_y_both_23 | near_y_both_24,
                near_y_both_25 | near_y_both_26, near_y_both_27 | near_y_both_28, near_y_both_29 | near_y_both_30,
                near_y_both_31 | near_y_both_32
            };
            near_z <= {
                near_z_both | near_z_both_2, near_z_both_3 | near_z_both_4, near_z_both_5 | near_z_both_6,
                near_z_both_7 | near_z_both_8, near_z_both_9 | near_z_both_10, near_z_both_11 | near_z_both_12,
                near_z_both_13 | near_z_both_14, near_z_both_15 | near_z_both_16, near_z_both_17 | near_z_both_18,
                near_z_both_19 | near_z_both_20, near_z_both_21 | near_z_both_22, near_z_both_23 | near_z_both_24,
                near_z_both_25 | near_z_both_26, near_z_both_27 | near_z_both_28, near_z_both_29 | near_z_both_30,
                near_z_both_31 | near_z_both_32
            };
        end
    end
    always @(posedge clk) if (enters) asked[asked_write_address] <= {asks_out_data[194:37], asks_out_data[4:0]};

    wire _unused = &{
        1'b0, d0_rank[5], found_queue_out_number[23:5], j_margin[18:0], judge_in_ready,
        lead_x_place_shifted[34:12], lead_y_place_shifted[34:12], lead_z_place_shifted[34:12],
        present_shifted_by_next_entry[7:1], reusable_shifted[7:1]
    };

`ifdef RTL_ASSERT
    wire [7:0] present_shifted_by_j_entry = present >> j_entry;
    wire check_either = ((readers_0 == 3'd0) & release_set[0]) | ((readers_1 == 3'd0) & release_set[1]);
    wire check_either_2 = check_either | ((readers_2 == 3'd0) & release_set[2]) | ((readers_3 == 3'd0) & release_set[3]);
    wire check_either_3 = check_either_2 | ((readers_4 == 3'd0) & release_set[4]) | ((readers_5 == 3'd0) & release_set[5]);
    wire check_either_4 = check_either_3 | ((readers_6 == 3'd0) & release_set[6]) | ((readers_7 == 3'd0) & release_set[7]);

    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        a_comparison_has_its_query: assert (~j_valid | |asked_count);
        a_hit_is_present: assert (~hits | present_shifted_by_j_entry[0]);
        found_distance2_in_range: assert (~found_valid | (found_distance2 < 32'h80000000));
        query_radius2_in_range: assert (~query_valid | (query_radius2 < 32'h80000000));
        finished_leaders_were_none_before: assert ((finished_leaders & ~unfinished) == 16'd0);
        a_follower_enters_where_none_waits: assert ((follower_enters & waits) == 32'd0);
        a_miss_has_a_ticket: assert (~misses | any_ticket);
        released_entries_have_readers: assert (~check_either_4);
`else
        if (!(~j_valid | |asked_count)) begin
            $display("assertion failed: a_comparison_has_its_query in %m"); $stop;
        end
        if (!(~hits | present_shifted_by_j_entry[0])) begin
            $display("assertion failed: a_hit_is_present in %m"); $stop;
        end
        if (!(~found_valid | (found_distance2 < 32'h80000000))) begin
            $display("assertion failed: found_distance2_in_range in %m"); $stop;
        end
        if (!(~query_valid | (query_radius2 < 32'h80000000))) begin
            $display("assertion failed: query_radius2_in_range in %m"); $stop;
        end
        if (!((finished_leaders & ~unfinished) == 16'd0)) begin
            $display("assertion failed: finished_leaders_were_none_before in %m"); $stop;
        end
        if (!((follower_enters & waits) == 32'd0)) begin
            $display("assertion failed: a_follower_enters_where_none_waits in %m"); $stop;
        end
        if (!(~misses | any_ticket)) begin
            $display("assertion failed: a_miss_has_a_ticket in %m"); $stop;
        end
        if (!(~check_either_4)) begin
            $display("assertion failed: released_entries_have_readers in %m"); $stop;
        end
`endif
    end

    wire _unused_by_checks = &{1'b0, present_shifted_by_j_entry[7:1]};
`endif
endmodule

// Queue of two in registers.
// width = 190
module stream_skid_w190 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [189:0] in_data,
    output wire out_valid, input wire out_ready, output wire [189:0] out_data
);
    reg head_filled, second_filled, room;
    reg [189:0] head, second;

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

// How far a neighborhood reaches.
// latency = 37
// initiation_interval = 1
module search_cover (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [2:0] in_entry, input wire [31:0] in_x,
    input  wire [31:0] in_y, input wire [31:0] in_z, input wire [31:0] in_far2,
    input  wire [31:0] in_near2, input wire in_leads, input wire [3:0] in_leader,
    input  wire [31:0] far_scale,
    output wire out_valid, input wire out_ready, output wire [2:0] out_entry, output wire [31:0] out_x,
    output wire [31:0] out_y, output wire [31:0] out_z, output wire [31:0] out_c, output wire out_leads,
    output wire [3:0] out_leader
);
    (* ram_style = "distributed" *)
    reg [31:0] delay_5_from_0 [0:3];
    (* ram_style = "distributed" *)
    reg [103:0] delay_37_from_0 [0:35];
    reg [1:0] delay_5_from_0_pointer;
    reg [31:0] delay_5_from_0_out;
    reg [5:0] delay_37_from_0_pointer;
    reg [103:0] delay_37_from_0_out;
    reg [36:0] in_flight;
    reg shown;
    reg [2:0] shown_entry;
    reg [31:0] shown_x, shown_y, shown_z, shown_c;
    reg shown_leads;
    reg [3:0] shown_leader;

    wire [31:0] sqrt_f32_ftz_unit_y, sqrt_f32_ftz_unit_copy2_y, mul_f32_ftz_unit_y, add_f32_ftz_unit_y;

    wire kept = in_flight[36];
    wire [2:0] entry_d37 = delay_37_from_0_out[2:0];
    wire [31:0] x_d37 = delay_37_from_0_out[34:3];
    wire [31:0] y_d37 = delay_37_from_0_out[66:35];
    wire [31:0] z_d37 = delay_37_from_0_out[98:67];
    wire leads_d37 = delay_37_from_0_out[99];
    wire [3:0] leader_d37 = delay_37_from_0_out[103:100];

    assign in_ready = 1'd1;
    assign out_valid = shown;
    assign out_entry = shown_entry;
    assign out_x = shown_x;
    assign out_y = shown_y;
    assign out_z = shown_z;
    assign out_c = shown_c;
    assign out_leads = shown_leads;
    assign out_leader = shown_leader;

    float_sqrt_s26_f32ftz sqrt_f32_ftz_unit (.clk(clk), .enable(1'd1), .a(in_far2), .y(sqrt_f32_ftz_unit_y));
    float_sqrt_s26_f32ftz sqrt_f32_ftz_unit_copy2 (.clk(clk), .enable(1'd1), .a(in_near2), .y(sqrt_f32_ftz_unit_copy2_y));

    float_mul_s5_f32ftz mul_f32_ftz_unit (
        .clk(clk), .enable(1'd1), .a(sqrt_f32_ftz_unit_y), .b(far_scale), .y(mul_f32_ftz_unit_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_y), .b(delay_5_from_0_out), .y(add_f32_ftz_unit_y)
    );

    always @(posedge clk) begin
        if (rst) begin
            delay_5_from_0_pointer <= 2'd0;
            delay_37_from_0_pointer <= 6'd0;
            in_flight <= 37'd0;
            shown <= 1'd0;
        end else begin
            delay_5_from_0_pointer <= (delay_5_from_0_pointer == 2'd3) ? (delay_5_from_0_pointer - 2'd3) : (delay_5_from_0_pointer + 2'd1);
            delay_37_from_0_pointer <= (delay_37_from_0_pointer == 6'd35) ? (delay_37_from_0_pointer - 6'd35) : (delay_37_from_0_pointer + 6'd1);
            in_flight <= {in_flight[35:0], in_valid};
            shown <= kept;
        end
    end
    always @(posedge clk) begin
        shown_entry <= entry_d37;
        shown_x <= x_d37;
        shown_y <= y_d37;
        shown_z <= z_d37;
        shown_c <= add_f32_ftz_unit_y;
        shown_leads <= leads_d37;
        shown_leader <= leader_d37;
    end
    always @(posedge clk) begin
        delay_5_from_0[delay_5_from_0_pointer] <= {~sqrt_f32_ftz_unit_copy2_y[31], sqrt_f32_ftz_unit_copy2_y[30:0]};
        delay_5_from_0_out <= delay_5_from_0[delay_5_from_0_pointer];
    end
    always @(posedge clk) begin
        delay_37_from_0[delay_37_from_0_pointer] <= {in_leader, in_leads, in_z, in_y, in_x, in_entry};
        delay_37_from_0_out <= delay_37_from_0[delay_37_from_0_pointer];
    end

    wire _unused = &{1'b0, out_ready};

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

// Floating-point square root, correctly rounded.
// stages = 26
// format = f32-ftz
module float_sqrt_s26_f32ftz (
    input  wire clk, input wire enable, input wire [31:0] a,
    output reg  [31:0] y
);
    reg [2:0] remainder_s1;
    reg [1:0] root_s1;
    reg [20:0] pending_s1;
    reg [3:0] remainder_s2;
    reg [2:0] root_s2;
    reg [18:0] pending_s2;
    reg [4:0] remainder_s3;
    reg [3:0] root_s3;
    reg [16:0] pending_s3;
    reg [5:0] remainder_s4;
    reg [4:0] root_s4;
    reg [14:0] pending_s4;
    reg [6:0] remainder_s5;
    reg [5:0] root_s5;
    reg [12:0] pending_s5;
    reg [7:0] remainder_s6;
    reg [6:0] root_s6;
    reg [10:0] pending_s6;
    reg [8:0] remainder_s7;
    reg [7:0] root_s7;
    reg [8:0] pending_s7;
    reg [9:0] remainder_s8;
    reg [8:0] root_s8;
    reg [6:0] pending_s8;
    reg [10:0] remainder_s9;
    reg [9:0] root_s9;
    reg [4:0] pending_s9;
    reg [11:0] remainder_s10;
    reg [10:0] root_s10;
    reg [2:0] pending_s10;
    reg [12:0] remainder_s11;
    reg [11:0] root_s11;
    reg pending_s11;
    reg [13:0] remainder_s12;
    reg [12:0] root_s12;
    reg [14:0] remainder_s13;
    reg [13:0] root_s13;
    reg [15:0] remainder_s14;
    reg [14:0] root_s14;
    reg [16:0] remainder_s15;
    reg [15:0] root_s15;
    reg [17:0] remainder_s16;
    reg [16:0] root_s16;
    reg [18:0] remainder_s17;
    reg [17:0] root_s17;
    reg [19:0] remainder_s18;
    reg [18:0] root_s18;
    reg [20:0] remainder_s19;
    reg [19:0] root_s19;
    reg [21:0] remainder_s20;
    reg [20:0] root_s20;
    reg [22:0] remainder_s21;
    reg [21:0] root_s21;
    reg [23:0] remainder_s22;
    reg [22:0] root_s22;
    reg [24:0] remainder_s23;
    reg [23:0] root_s23;
    reg [25:0] remainder_s24;
    reg [24:0] root_s24;
    reg [9:0] exponent_s1, exponent_s2, exponent_s3, exponent_s4, exponent_s5, exponent_s6, exponent_s7;
    reg [9:0] exponent_s8, exponent_s9, exponent_s10, exponent_s11, exponent_s12, exponent_s13, exponent_s14;
    reg [9:0] exponent_s15, exponent_s16, exponent_s17, exponent_s18, exponent_s19, exponent_s20, exponent_s21;
    reg [9:0] exponent_s22, exponent_s23, exponent_s24, exponent_s25;
    reg [25:0] significand_s25;
    reg sign_s1, sign_s2, sign_s3, sign_s4, sign_s5, sign_s6, sign_s7, sign_s8, sign_s9, sign_s10, sign_s11;
    reg sign_s12, sign_s13, sign_s14, sign_s15, sign_s16, sign_s17, sign_s18, sign_s19, sign_s20, sign_s21;
    reg sign_s22, sign_s23, sign_s24, sign_s25, nan_s1, nan_s2, nan_s3, nan_s4, nan_s5, nan_s6, nan_s7;
    reg nan_s8, nan_s9, nan_s10, nan_s11, nan_s12, nan_s13, nan_s14, nan_s15, nan_s16, nan_s17, nan_s18;
    reg nan_s19, nan_s20, nan_s21, nan_s22, nan_s23, nan_s24, nan_s25, infinite_s1, infinite_s2, infinite_s3;
    reg infinite_s4, infinite_s5, infinite_s6, infinite_s7, infinite_s8, infinite_s9, infinite_s10;
    reg infinite_s11, infinite_s12, infinite_s13, infinite_s14, infinite_s15, infinite_s16, infinite_s17;
    reg infinite_s18, infinite_s19, infinite_s20, infinite_s21, infinite_s22, infinite_s23, infinite_s24;
    reg infinite_s25, zero_s1, zero_s2, zero_s3, zero_s4, zero_s5, zero_s6, zero_s7, zero_s8, zero_s9;
    reg zero_s10, zero_s11, zero_s12, zero_s13, zero_s14, zero_s15, zero_s16, zero_s17, zero_s18, zero_s19;
    reg zero_s20, zero_s21, zero_s22, zero_s23, zero_s24, zero_s25;

    wire [7:0] a_field = a[30:23];
    wire [22:0] a_fraction = a[22:0];
    wire [22:0] remainder_s1_both = a_fraction & {23{|a_field}};
    wire [24:0] remainder_s1_choice = ~a_field[0] ? {|a_field, remainder_s1_both, 1'd0} : {1'd0, |a_field, remainder_s1_both};
    wire [1:0] remainder_s1_difference = remainder_s1_choice[24:23] - 2'd1;
    wire [4:0] remainder_s1_difference_2 = {1'd0, remainder_s1_difference, remainder_s1_choice[22:21]} - 5'd5;
    wire [5:0] remainder_s2_difference = {1'd0, remainder_s1, pending_s1[20:19]} - {2'd0, root_s1, 2'd1};
    wire [6:0] remainder_s3_difference = {1'd0, remainder_s2, pending_s2[18:17]} - {2'd0, root_s2, 2'd1};
    wire [7:0] remainder_s4_difference = {1'd0, remainder_s3, pending_s3[16:15]} - {2'd0, root_s3, 2'd1};
    wire [8:0] remainder_s5_difference = {1'd0, remainder_s4, pending_s4[14:13]} - {2'd0, root_s4, 2'd1};
    wire [9:0] remainder_s6_difference = {1'd0, remainder_s5, pending_s5[12:11]} - {2'd0, root_s5, 2'd1};
    wire [10:0] remainder_s7_difference = {1'd0, remainder_s6, pending_s6[10:9]} - {2'd0, root_s6, 2'd1};
    wire [11:0] remainder_s8_difference = {1'd0, remainder_s7, pending_s7[8:7]} - {2'd0, root_s7, 2'd1};
    wire [12:0] remainder_s9_difference = {1'd0, remainder_s8, pending_s8[6:5]} - {2'd0, root_s8, 2'd1};
    wire [13:0] remainder_s10_difference = {1'd0, remainder_s9, pending_s9[4:3]} - {2'd0, root_s9, 2'd1};
    wire [14:0] remainder_s11_difference = {1'd0, remainder_s10, pending_s10[2:1]} - {2'd0, root_s10, 2'd1};
    wire [15:0] remainder_s12_difference = {1'd0, remainder_s11, pending_s11, 1'd0} - {2'd0, root_s11, 2'd1};
    wire [16:0] remainder_s13_difference = {1'd0, remainder_s12, 2'd0} - {2'd0, root_s12, 2'd1};
    wire [17:0] remainder_s14_difference = {1'd0, remainder_s13, 2'd0} - {2'd0, root_s13, 2'd1};
    wire [18:0] remainder_s15_difference = {1'd0, remainder_s14, 2'd0} - {2'd0, root_s14, 2'd1};
    wire [19:0] remainder_s16_difference = {1'd0, remainder_s15, 2'd0} - {2'd0, root_s15, 2'd1};
    wire [20:0] remainder_s17_difference = {1'd0, remainder_s16, 2'd0} - {2'd0, root_s16, 2'd1};
    wire [21:0] remainder_s18_difference = {1'd0, remainder_s17, 2'd0} - {2'd0, root_s17, 2'd1};
    wire [22:0] remainder_s19_difference = {1'd0, remainder_s18, 2'd0} - {2'd0, root_s18, 2'd1};
    wire [23:0] remainder_s20_difference = {1'd0, remainder_s19, 2'd0} - {2'd0, root_s19, 2'd1};
    wire [24:0] remainder_s21_difference = {1'd0, remainder_s20, 2'd0} - {2'd0, root_s20, 2'd1};
    wire [25:0] remainder_s22_difference = {1'd0, remainder_s21, 2'd0} - {2'd0, root_s21, 2'd1};
    wire [26:0] remainder_s23_difference = {1'd0, remainder_s22, 2'd0} - {2'd0, root_s22, 2'd1};
    wire [27:0] remainder_s24_difference = {1'd0, remainder_s23, 2'd0} - {2'd0, root_s23, 2'd1};
    wire [9:0] a_field_plus_127 = {2'd0, a_field} + 10'd127;
    wire y_both = (exponent_s25 == 10'd0) & ~(&significand_s25[24:2] & significand_s25[1]);
    wire round_up = significand_s25[1] & (significand_s25[0] | significand_s25[2]);
    wire [30:0] rounded = {exponent_s25[7:0], significand_s25[24:2]} + {30'd0, round_up};
    wire [30:0] y_choice = (infinite_s25 | (~exponent_s25[9] & (10'd255 <= exponent_s25))) ? 31'h7f800000 : rounded;
    wire [30:0] y_choice_2 = (zero_s25 | ((exponent_s25[9] | y_both) & ~infinite_s25)) ? 31'd0 : y_choice;

    always @(posedge clk) begin
        if (enable) begin
            remainder_s1 <= ~remainder_s1_difference_2[4] ? remainder_s1_difference_2[2:0] : {remainder_s1_difference[0], remainder_s1_choice[22:21]};
            root_s1 <= {1'd1, ~remainder_s1_difference_2[4]};
            pending_s1 <= remainder_s1_choice[20:0];
            remainder_s2 <= ~remainder_s2_difference[5] ? remainder_s2_difference[3:0] : {remainder_s1[1:0], pending_s1[20:19]};
            root_s2 <= {root_s1, ~remainder_s2_difference[5]};
            pending_s2 <= pending_s1[18:0];
            remainder_s3 <= ~remainder_s3_difference[6] ? remainder_s3_difference[4:0] : {remainder_s2[2:0], pending_s2[18:17]};
            root_s3 <= {root_s2, ~remainder_s3_difference[6]};
            pending_s3 <= pending_s2[16:0];
            remainder_s4 <= ~remainder_s4_difference[7] ? remainder_s4_difference[5:0] : {remainder_s3[3:0], pending_s3[16:15]};
            root_s4 <= {root_s3, ~remainder_s4_difference[7]};
            pending_s4 <= pending_s3[14:0];
            remainder_s5 <= ~remainder_s5_difference[8] ? remainder_s5_difference[6:0] : {remainder_s4[4:0], pending_s4[14:13]};
            root_s5 <= {root_s4, ~remainder_s5_difference[8]};
            pending_s5 <= pending_s4[12:0];
            remainder_s6 <= ~remainder_s6_difference[9] ? remainder_s6_difference[7:0] : {remainder_s5[5:0], pending_s5[12:11]};
            root_s6 <= {root_s5, ~remainder_s6_difference[9]};
            pending_s6 <= pending_s5[10:0];
            remainder_s7 <= ~remainder_s7_difference[10] ? remainder_s7_difference[8:0] : {remainder_s6[6:0], pending_s6[10:9]};
            root_s7 <= {root_s6, ~remainder_s7_difference[10]};
            pending_s7 <= pending_s6[8:0];
            remainder_s8 <= ~remainder_s8_difference[11] ? remainder_s8_difference[9:0] : {remainder_s7[7:0], pending_s7[8:7]};
            root_s8 <= {root_s7, ~remainder_s8_difference[11]};
            pending_s8 <= pending_s7[6:0];
            remainder_s9 <= ~remainder_s9_difference[12] ? remainder_s9_difference[10:0] : {remainder_s8[8:0], pending_s8[6:5]};
            root_s9 <= {root_s8, ~remainder_s9_difference[12]};
            pending_s9 <= pending_s8[4:0];
            remainder_s10 <= ~remainder_s10_difference[13] ? remainder_s10_difference[11:0] : {remainder_s9[9:0], pending_s9[4:3]};
            root_s10 <= {root_s9, ~remainder_s10_difference[13]};
            pending_s10 <= pending_s9[2:0];
            remainder_s11 <= ~remainder_s11_difference[14] ? remainder_s11_difference[12:0] : {remainder_s10[10:0], pending_s10[2:1]};
            root_s11 <= {root_s10, ~remainder_s11_difference[14]};
            pending_s11 <= pending_s10[0];
            remainder_s12 <= ~remainder_s12_difference[15] ? remainder_s12_difference[13:0] : {remainder_s11[11:0], pending_s11, 1'd0};
            root_s12 <= {root_s11, ~remainder_s12_difference[15]};
            remainder_s13 <= ~remainder_s13_difference[16] ? remainder_s13_difference[14:0] : {remainder_s12[12:0], 2'd0};
            root_s13 <= {root_s12, ~remainder_s13_difference[16]};
            remainder_s14 <= ~remainder_s14_difference[17] ? remainder_s14_difference[15:0] : {remainder_s13[13:0], 2'd0};
            root_s14 <= {root_s13, ~remainder_s14_difference[17]};
            remainder_s15 <= ~remainder_s15_difference[18] ? remainder_s15_difference[16:0] : {remainder_s14[14:0], 2'd0};
            root_s15 <= {root_s14, ~remainder_s15_difference[18]};
            remainder_s16 <= ~remainder_s16_difference[19] ? remainder_s16_difference[17:0] : {remainder_s15[15:0], 2'd0};
            root_s16 <= {root_s15, ~remainder_s16_difference[19]};
            remainder_s17 <= ~remainder_s17_difference[20] ? remainder_s17_difference[18:0] : {remainder_s16[16:0], 2'd0};
            root_s17 <= {root_s16, ~remainder_s17_difference[20]};
            remainder_s18 <= ~remainder_s18_difference[21] ? remainder_s18_difference[19:0] : {remainder_s17[17:0], 2'd0};
            root_s18 <= {root_s17, ~remainder_s18_difference[21]};
            remainder_s19 <= ~remainder_s19_difference[22] ? remainder_s19_difference[20:0] : {remainder_s18[18:0], 2'd0};
            root_s19 <= {root_s18, ~remainder_s19_difference[22]};
            remainder_s20 <= ~remainder_s20_difference[23] ? remainder_s20_difference[21:0] : {remainder_s19[19:0], 2'd0};
            root_s20 <= {root_s19, ~remainder_s20_difference[23]};
            remainder_s21 <= ~remainder_s21_difference[24] ? remainder_s21_difference[22:0] : {remainder_s20[20:0], 2'd0};
            root_s21 <= {root_s20, ~remainder_s21_difference[24]};
            remainder_s22 <= ~remainder_s22_difference[25] ? remainder_s22_difference[23:0] : {remainder_s21[21:0], 2'd0};
            root_s22 <= {root_s21, ~remainder_s22_difference[25]};
            remainder_s23 <= ~remainder_s23_difference[26] ? remainder_s23_difference[24:0] : {remainder_s22[22:0], 2'd0};
            root_s23 <= {root_s22, ~remainder_s23_difference[26]};
            remainder_s24 <= ~remainder_s24_difference[27] ? remainder_s24_difference[25:0] : {remainder_s23[23:0], 2'd0};
            root_s24 <= {root_s23, ~remainder_s24_difference[27]};
            exponent_s1 <= {a_field_plus_127[9], a_field_plus_127[9:1]};
            exponent_s2 <= exponent_s1;
            exponent_s3 <= exponent_s2;
            exponent_s4 <= exponent_s3;
            exponent_s5 <= exponent_s4;
            exponent_s6 <= exponent_s5;
            exponent_s7 <= exponent_s6;
            exponent_s8 <= exponent_s7;
            exponent_s9 <= exponent_s8;
            exponent_s10 <= exponent_s9;
            exponent_s11 <= exponent_s10;
            exponent_s12 <= exponent_s11;
            exponent_s13 <= exponent_s12;
            exponent_s14 <= exponent_s13;
            exponent_s15 <= exponent_s14;
            exponent_s16 <= exponent_s15;
            exponent_s17 <= exponent_s16;
            exponent_s18 <= exponent_s17;
            exponent_s19 <= exponent_s18;
            exponent_s20 <= exponent_s19;
            exponent_s21 <= exponent_s20;
            exponent_s22 <= exponent_s21;
            exponent_s23 <= exponent_s22;
            exponent_s24 <= exponent_s23;
            exponent_s25 <= exponent_s24;
            significand_s25 <= {root_s24, |remainder_s24};
            sign_s1 <= a[31];
            sign_s2 <= sign_s1;
            sign_s3 <= sign_s2;
            sign_s4 <= sign_s3;
            sign_s5 <= sign_s4;
            sign_s6 <= sign_s5;
            sign_s7 <= sign_s6;
            sign_s8 <= sign_s7;
            sign_s9 <= sign_s8;
            sign_s10 <= sign_s9;
            sign_s11 <= sign_s10;
            sign_s12 <= sign_s11;
            sign_s13 <= sign_s12;
            sign_s14 <= sign_s13;
            sign_s15 <= sign_s14;
            sign_s16 <= sign_s15;
            sign_s17 <= sign_s16;
            sign_s18 <= sign_s17;
            sign_s19 <= sign_s18;
            sign_s20 <= sign_s19;
            sign_s21 <= sign_s20;
            sign_s22 <= sign_s21;
            sign_s23 <= sign_s22;
            sign_s24 <= sign_s23;
            sign_s25 <= sign_s24;
            nan_s1 <= (&a_field & |a_fraction) | (a[31] & |a_field);
            nan_s2 <= nan_s1;
            nan_s3 <= nan_s2;
            nan_s4 <= nan_s3;
            nan_s5 <= nan_s4;
            nan_s6 <= nan_s5;
            nan_s7 <= nan_s6;
            nan_s8 <= nan_s7;
            nan_s9 <= nan_s8;
            nan_s10 <= nan_s9;
            nan_s11 <= nan_s10;
            nan_s12 <= nan_s11;
            nan_s13 <= nan_s12;
            nan_s14 <= nan_s13;
            nan_s15 <= nan_s14;
            nan_s16 <= nan_s15;
            nan_s17 <= nan_s16;
            nan_s18 <= nan_s17;
            nan_s19 <= nan_s18;
            nan_s20 <= nan_s19;
            nan_s21 <= nan_s20;
            nan_s22 <= nan_s21;
            nan_s23 <= nan_s22;
            nan_s24 <= nan_s23;
            nan_s25 <= nan_s24;
            infinite_s1 <= &a_field & (a_fraction == 23'd0);
            infinite_s2 <= infinite_s1;
            infinite_s3 <= infinite_s2;
            infinite_s4 <= infinite_s3;
            infinite_s5 <= infinite_s4;
            infinite_s6 <= infinite_s5;
            infinite_s7 <= infinite_s6;
            infinite_s8 <= infinite_s7;
            infinite_s9 <= infinite_s8;
            infinite_s10 <= infinite_s9;
            infinite_s11 <= infinite_s10;
            infinite_s12 <= infinite_s11;
            infinite_s13 <= infinite_s12;
            infinite_s14 <= infinite_s13;
            infinite_s15 <= infinite_s14;
            infinite_s16 <= infinite_s15;
            infinite_s17 <= infinite_s16;
            infinite_s18 <= infinite_s17;
            infinite_s19 <= infinite_s18;
            infinite_s20 <= infinite_s19;
            infinite_s21 <= infinite_s20;
            infinite_s22 <= infinite_s21;
            infinite_s23 <= infinite_s22;
            infinite_s24 <= infinite_s23;
            infinite_s25 <= infinite_s24;
            zero_s1 <= ~(|a_field);
            zero_s2 <= zero_s1;
            zero_s3 <= zero_s2;
            zero_s4 <= zero_s3;
            zero_s5 <= zero_s4;
            zero_s6 <= zero_s5;
            zero_s7 <= zero_s6;
            zero_s8 <= zero_s7;
            zero_s9 <= zero_s8;
            zero_s10 <= zero_s9;
            zero_s11 <= zero_s10;
            zero_s12 <= zero_s11;
            zero_s13 <= zero_s12;
            zero_s14 <= zero_s13;
            zero_s15 <= zero_s14;
            zero_s16 <= zero_s15;
            zero_s17 <= zero_s16;
            zero_s18 <= zero_s17;
            zero_s19 <= zero_s18;
            zero_s20 <= zero_s19;
            zero_s21 <= zero_s20;
            zero_s22 <= zero_s21;
            zero_s23 <= zero_s22;
            zero_s24 <= zero_s23;
            zero_s25 <= zero_s24;
            y <= nan_s25 ? 32'h7fc00000 : {sign_s25, y_choice_2};
        end
    end

    wire _unused = &{
        1'b0, a_field_plus_127[0], remainder_s10_difference[12], remainder_s11_difference[13],
        remainder_s12_difference[14], remainder_s13_difference[15], remainder_s14_difference[16],
        remainder_s15_difference[17], remainder_s16_difference[18], remainder_s17_difference[19],
        remainder_s18_difference[20], remainder_s19_difference[21], remainder_s1_difference_2[3],
        remainder_s20_difference[22], remainder_s21_difference[23], remainder_s22_difference[24],
        remainder_s23_difference[25], remainder_s24_difference[26], remainder_s2_difference[4],
        remainder_s3_difference[5], remainder_s4_difference[6], remainder_s5_difference[7],
        remainder_s6_difference[8], remainder_s7_difference[9], remainder_s8_difference[10],
        remainder_s9_difference[11], significand_s25[25]
    };
endmodule

// Queue of two in registers.
// width = 82
module stream_skid_w82 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [81:0] in_data,
    output wire out_valid, input wire out_ready, output wire [81:0] out_data
);
    reg head_filled, second_filled, room;
    reg [81:0] head, second;

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
// width = 158
module stream_skid_w158 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [157:0] in_data,
    output wire out_valid, input wire out_ready, output wire [157:0] out_data
);
    reg head_filled, second_filled, room;
    reg [157:0] head, second;

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

// Whether a neighborhood covers a query.
// latency = 25
// initiation_interval = 1
module search_check (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [2:0] in_entry, input wire in_last,
    input  wire in_present, input wire [7:0] in_version, input wire [31:0] in_x,
    input  wire [31:0] in_y, input wire [31:0] in_z, input wire [31:0] in_reach,
    input  wire [31:0] in_entry_x, input wire [31:0] in_entry_y, input wire [31:0] in_entry_z,
    input  wire [31:0] in_entry_c,
    input  wire [31:0] margin_scale,
    output wire out_valid, input wire out_ready, output wire [2:0] out_entry, output wire out_last,
    output wire out_present, output wire [7:0] out_version, output wire [31:0] out_margin,
    output wire out_covered
);
    (* ram_style = "distributed" *)
    reg [31:0] delay_6_from_0 [0:4];
    (* ram_style = "distributed" *)
    reg [63:0] delay_7_from_0 [0:5];
    (* ram_style = "distributed" *)
    reg delay_23_from_0 [0:21];
    (* ram_style = "distributed" *)
    reg [12:0] delay_25_from_0 [0:23];
    reg [5:0] credits;
    reg [2:0] delay_6_from_0_pointer;
    reg [31:0] delay_6_from_0_out;
    reg [2:0] delay_7_from_0_pointer;
    reg [63:0] delay_7_from_0_out;
    reg [4:0] delay_23_from_0_pointer;
    reg delay_23_from_0_out;
    reg [4:0] delay_25_from_0_pointer;
    reg [12:0] delay_25_from_0_out;
    reg [24:0] in_flight;
    reg left;

    wire [31:0] add_f32_ftz_unit_y, add_f32_ftz_unit_copy2_y, add_f32_ftz_unit_copy3_y, add_f32_ftz_unit_copy4_y;
    wire [31:0] add_f32_ftz_unit_copy5_y, add_f32_ftz_unit_copy6_y, mul_f32_ftz_unit_y, mul_f32_ftz_unit_copy2_y;
    wire [31:0] mul_f32_ftz_unit_copy3_y, mul_f32_ftz_unit_copy4_y, mul_f32_ftz_unit_copy5_y;
    wire lt_f32_ftz_unit_y, lt_f32_ftz_unit_copy2_y, queue_1_in_ready;
    wire [45:0] queue_1_out_data;

    assign in_ready = ~credits[5];
    wire [31:0] margin_d7 = delay_7_from_0_out[31:0];
    wire kept = in_flight[24];
    wire [2:0] entry_d25 = delay_25_from_0_out[2:0];
    wire last_d25 = delay_25_from_0_out[3];
    wire present_d25 = delay_25_from_0_out[4];
    wire [7:0] version_d25 = delay_25_from_0_out[12:5];
    wire [31:0] margin_d14 = delay_7_from_0_out[63:32];
    wire covered_out = delay_23_from_0_out & lt_f32_ftz_unit_copy2_y;
    wire in_valid_and_in_ready = in_valid & in_ready;

    assign {out_entry, out_last, out_present, out_version, out_margin, out_covered} = queue_1_out_data;

    float_add_s6_f32ftz add_f32_ftz_unit (
        .clk(clk), .enable(1'd1), .a(in_x), .b({~in_entry_x[31], in_entry_x[30:0]}), .y(add_f32_ftz_unit_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(in_y), .b({~in_entry_y[31], in_entry_y[30:0]}),
        .y(add_f32_ftz_unit_copy2_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy3 (
        .clk(clk), .enable(1'd1), .a(in_z), .b({~in_entry_z[31], in_entry_z[30:0]}),
        .y(add_f32_ftz_unit_copy3_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy4 (
        .clk(clk), .enable(1'd1), .a(in_entry_c), .b({~in_reach[31], in_reach[30:0]}),
        .y(add_f32_ftz_unit_copy4_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy5 (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_copy2_y), .b(mul_f32_ftz_unit_copy3_y),
        .y(add_f32_ftz_unit_copy5_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy6 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy5_y), .b(delay_6_from_0_out),
        .y(add_f32_ftz_unit_copy6_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy4_y), .b(margin_scale), .y(mul_f32_ftz_unit_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_y), .b(add_f32_ftz_unit_y),
        .y(mul_f32_ftz_unit_copy2_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy3 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy2_y), .b(add_f32_ftz_unit_copy2_y),
        .y(mul_f32_ftz_unit_copy3_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy4 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy3_y), .b(add_f32_ftz_unit_copy3_y),
        .y(mul_f32_ftz_unit_copy4_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy5 (
        .clk(clk), .enable(1'd1), .a(margin_d7), .b(margin_d7), .y(mul_f32_ftz_unit_copy5_y)
    );

    float_lt_s2_f32ftz lt_f32_ftz_unit (
        .clk(clk), .enable(1'd1), .a(in_reach), .b(in_entry_c), .y(lt_f32_ftz_unit_y)
    );

    float_lt_s2_f32ftz lt_f32_ftz_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy6_y), .b(mul_f32_ftz_unit_copy5_y),
        .y(lt_f32_ftz_unit_copy2_y)
    );

    stream_fifo_d29_w46_distributed queue_1 (
        .clk(clk), .rst(rst), .in_valid(kept), .in_ready(queue_1_in_ready),
        .in_data({entry_d25, last_d25, present_d25, version_d25, margin_d14, covered_out}),
        .out_valid(out_valid), .out_ready(out_ready), .out_data(queue_1_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            credits <= 6'd28;
            delay_6_from_0_pointer <= 3'd0;
            delay_7_from_0_pointer <= 3'd0;
            delay_23_from_0_pointer <= 5'd0;
            delay_25_from_0_pointer <= 5'd0;
            in_flight <= 25'd0;
            left <= 1'd0;
        end else begin
            credits <= (credits - {5'd0, in_valid_and_in_ready}) + {5'd0, left};
            delay_6_from_0_pointer <= (delay_6_from_0_pointer == 3'd4) ? (delay_6_from_0_pointer - 3'd4) : (delay_6_from_0_pointer + 3'd1);
            delay_7_from_0_pointer <= (delay_7_from_0_pointer == 3'd5) ? (delay_7_from_0_pointer - 3'd5) : (delay_7_from_0_pointer + 3'd1);
            delay_23_from_0_pointer <= (delay_23_from_0_pointer == 5'd21) ? (delay_23_from_0_pointer - 5'd21) : (delay_23_from_0_pointer + 5'd1);
            delay_25_from_0_pointer <= (delay_25_from_0_pointer == 5'd23) ? (delay_25_from_0_pointer - 5'd23) : (delay_25_from_0_pointer + 5'd1);
            in_flight <= {in_flight[23:0], in_valid_and_in_ready};
            left <= out_valid & out_ready;
        end
    end
    always @(posedge clk) begin
        delay_6_from_0[delay_6_from_0_pointer] <= mul_f32_ftz_unit_copy4_y;
        delay_6_from_0_out <= delay_6_from_0[delay_6_from_0_pointer];
    end
    always @(posedge clk) begin
        delay_7_from_0[delay_7_from_0_pointer] <= {margin_d7, mul_f32_ftz_unit_y};
        delay_7_from_0_out <= delay_7_from_0[delay_7_from_0_pointer];
    end
    always @(posedge clk) begin
        delay_23_from_0[delay_23_from_0_pointer] <= lt_f32_ftz_unit_y;
        delay_23_from_0_out <= delay_23_from_0[delay_23_from_0_pointer];
    end
    always @(posedge clk) begin
        delay_25_from_0[delay_25_from_0_pointer] <= {in_version, in_present, in_last, in_entry};
        delay_25_from_0_out <= delay_25_from_0[delay_25_from_0_pointer];
    end

    wire _unused = &{1'b0, queue_1_in_ready};

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
// depth = 29
// width = 46
// storage = distributed
module stream_fifo_d29_w46_distributed (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [45:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [45:0] out_data
);
    (* ram_style = "distributed" *)
    reg [45:0] entries [0:28];
    reg [4:0] held, waiting;
    reg is_full, any_waits;
    reg [4:0] write_address, read_address;
    reg [45:0] item;

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
                is_full <= push & (held == 5'd28);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 5'd1);
            end
            if (push) write_address <= (write_address == 5'd28) ? 5'd0 : (write_address + 5'd1);
            if (fetch) read_address <= (read_address == 5'd28) ? 5'd0 : (read_address + 5'd1);
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
        held_in_range: assert (held <= 5'd29);
        held_is_waiting_and_shown: assert (held == (waiting + {4'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 5'd29)) & (any_waits == |waiting));
`else
        if (!(held <= 5'd29)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {4'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 5'd29)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Whether one floating-point number is less than another.
// stages = 2
// format = f32-ftz
module float_lt_s2_f32ftz (
    input  wire clk, input wire enable, input wire [31:0] a, input wire [31:0] b,
    output reg  y
);
    reg unordered_s1, both_zero_s1, compared_s1;

    always @(posedge clk) begin
        if (enable) begin
            unordered_s1 <= (&a[30:23] & |a[22:0]) | (&b[30:23] & |b[22:0]);
            both_zero_s1 <= (a[30:23] == 8'd0) & (b[30:23] == 8'd0);
            compared_s1 <= {~a[31], a[30:0] ^ {31{a[31]}}} < {~b[31], b[30:0] ^ {31{b[31]}}};
            y <= compared_s1 & ~both_zero_s1 & ~unordered_s1;
        end
    end
endmodule

// Floating-point product.
// stages = 5
// format = f32-ftz
module float_mul_s5_f32ftz (
    input  wire clk, input wire enable, input wire [31:0] a, input wire [31:0] b,
    output reg  [31:0] y
);
    reg [23:0] left_s1, right_s1;
    reg [9:0] exponent_s1;
    reg [23:0] partial_0_0_s2, partial_0_12_s2, partial_12_0_s2, partial_12_12_s2;
    reg [47:0] product_s3;
    reg [9:0] exponent_s2, exponent_s3, exponent_s4;
    reg [25:0] significand_s4;
    reg sign_s1, sign_s2, sign_s3, sign_s4, nan_s1, nan_s2, nan_s3, nan_s4, infinite_s1, infinite_s2;
    reg infinite_s3, infinite_s4, zero_s1, zero_s2, zero_s3, zero_s4;

    wire [7:0] a_field = a[30:23];
    wire [22:0] a_fraction = a[22:0];
    wire [7:0] b_field = b[30:23];
    wire [22:0] b_fraction = b[22:0];
    wire [47:0] product_s3_sum = ({24'd0, partial_0_0_s2} | ({24'd0, partial_12_12_s2} << 24)) + ({24'd0, partial_0_12_s2} << 12);
    wire [47:0] significand_s4_choice = product_s3[47] ? product_s3 : (product_s3 << 1);
    wire nan_s1_both = &a_field & (a_fraction == 23'd0);
    wire nan_s1_inverted = ~(|b_field);
    wire nan_s1_either = (&a_field & |a_fraction) | (&b_field & |b_fraction) | (nan_s1_both & nan_s1_inverted);
    wire nan_s1_inverted_2 = ~(|a_field);
    wire nan_s1_both_2 = &b_field & (b_fraction == 23'd0);
    wire y_both = (exponent_s4 == 10'd0) & ~(&significand_s4[24:2] & significand_s4[1]);
    wire round_up = significand_s4[1] & (significand_s4[0] | significand_s4[2]);
    wire [30:0] rounded = {exponent_s4[7:0], significand_s4[24:2]} + {30'd0, round_up};
    wire [30:0] y_choice = (infinite_s4 | (~exponent_s4[9] & (10'd255 <= exponent_s4))) ? 31'h7f800000 : rounded;
    wire [30:0] y_choice_2 = (zero_s4 | ((exponent_s4[9] | y_both) & ~infinite_s4)) ? 31'd0 : y_choice;

    always @(posedge clk) begin
        if (enable) begin
            left_s1 <= {|a_field, a_fraction & {23{|a_field}}};
            right_s1 <= {|b_field, b_fraction & {23{|b_field}}};
            exponent_s1 <= {2'd0, a_field} + {2'd0, b_field};
            partial_0_0_s2 <= {12'd0, left_s1[11:0]} * {12'd0, right_s1[11:0]};
            partial_0_12_s2 <= {12'd0, left_s1[11:0]} * {12'd0, right_s1[23:12]};
            partial_12_0_s2 <= {12'd0, left_s1[23:12]} * {12'd0, right_s1[11:0]};
            partial_12_12_s2 <= {12'd0, left_s1[23:12]} * {12'd0, right_s1[23:12]};
            product_s3 <= product_s3_sum + ({24'd0, partial_12_0_s2} << 12);
            exponent_s2 <= exponent_s1 - 10'd127;
            exponent_s3 <= exponent_s2;
            exponent_s4 <= exponent_s3 + {9'd0, product_s3[47]};
            significand_s4 <= {significand_s4_choice[47:23], |significand_s4_choice[22:0]};
            sign_s1 <= a[31] ^ b[31];
            sign_s2 <= sign_s1;
            sign_s3 <= sign_s2;
            sign_s4 <= sign_s3;
            nan_s1 <= nan_s1_either | (nan_s1_inverted_2 & nan_s1_both_2);
            nan_s2 <= nan_s1;
            nan_s3 <= nan_s2;
            nan_s4 <= nan_s3;
            infinite_s1 <= nan_s1_both | nan_s1_both_2;
            infinite_s2 <= infinite_s1;
            infinite_s3 <= infinite_s2;
            infinite_s4 <= infinite_s3;
            zero_s1 <= nan_s1_inverted_2 | nan_s1_inverted;
            zero_s2 <= zero_s1;
            zero_s3 <= zero_s2;
            zero_s4 <= zero_s3;
            y <= nan_s4 ? 32'h7fc00000 : {sign_s4, y_choice_2};
        end
    end

    wire _unused = &{1'b0, significand_s4[25]};
endmodule

// Floating-point sum.
// stages = 6
// format = f32-ftz
module float_add_s6_f32ftz (
    input  wire clk, input wire enable, input wire [31:0] a, input wire [31:0] b,
    output reg  [31:0] y
);
    reg [9:0] distance_s1;
    reg [23:0] large_s1, small_s1, large_s2;
    reg [26:0] aligned_s2;
    reg subtract_s1, subtract_s2;
    reg [27:0] sum_s3;
    reg sign_s1, sign_s2, sign_s3, nan_s1, nan_s2, nan_s3, infinite_s1, infinite_s2, infinite_s3, subtract_s3;
    reg [27:0] value_s4;
    reg [4:0] zeros_s4;
    reg [9:0] limit_s1, limit_s2, limit_s3, limit_s4, exponent_s5;
    reg [25:0] significand_s5;
    reg sign_s4, sign_s5, nan_s4, nan_s5, infinite_s4, infinite_s5, zero_s4, zero_s5;

    wire swap = a[30:0] < b[30:0];
    wire [7:0] b_field = b[30:23];
    wire [7:0] a_field = a[30:23];
    wire large_s1_inverted = ~(|a_field);
    wire large_s1_inverted_2 = ~(|b_field);
    wire large_s1_inverted_3 = ~(large_s1_inverted & large_s1_inverted_2);
    wire [22:0] b_fraction = b[22:0];
    wire [22:0] a_fraction = a[22:0];
    wire small_s1_inverted = ~(large_s1_inverted | large_s1_inverted_2);
    wire [26:0] aligned_s2_choice = distance_s1[4] ? ({small_s1, 3'd0} >> 16) : {small_s1, 3'd0};
    wire [26:0] aligned_s2_choice_2 = distance_s1[3] ? (aligned_s2_choice >> 8) : aligned_s2_choice;
    wire [26:0] aligned_s2_choice_3 = distance_s1[2] ? (aligned_s2_choice_2 >> 4) : aligned_s2_choice_2;
    wire [26:0] aligned_s2_choice_4 = distance_s1[1] ? (aligned_s2_choice_3 >> 2) : aligned_s2_choice_3;
    wire [26:0] aligned_s2_choice_5 = distance_s1[0] ? (aligned_s2_choice_4 >> 1) : aligned_s2_choice_4;
    wire aligned_s2_either = (distance_s1[4] & |{small_s1[12:0], 3'd0}) | (distance_s1[3] & |aligned_s2_choice[7:0]);
    wire aligned_s2_either_2 = aligned_s2_either | (distance_s1[2] & |aligned_s2_choice_2[3:0]) | (distance_s1[1] & |aligned_s2_choice_3[1:0]);
    wire aligned_s2_either_3 = aligned_s2_choice_5[0] | (aligned_s2_either_2 | (distance_s1[0] & aligned_s2_choice_4[0]));
    wire a_31_xor_b_31 = a[31] ^ b[31];
    wire [28:0] sum_s3_sum = {1'd0, large_s2, 4'd1} + {{1'd0, aligned_s2} ^ {28{subtract_s2}}, subtract_s2};
    wire nan_s1_both = &a_field & (a_fraction == 23'd0);
    wire nan_s1_both_2 = &b_field & (b_fraction == 23'd0);
    wire zeros_s4_both = ~sum_s3[27] & ~sum_s3[26];
    wire zeros_s4_both_2 = zeros_s4_both & (~sum_s3[25] & ~sum_s3[24]);
    wire zeros_s4_both_3 = ~sum_s3[23] & ~sum_s3[22];
    wire zeros_s4_both_4 = zeros_s4_both_2 & (zeros_s4_both_3 & (~sum_s3[21] & ~sum_s3[20]));
    wire zeros_s4_both_5 = ~sum_s3[19] & ~sum_s3[18];
    wire zeros_s4_both_6 = zeros_s4_both_5 & (~sum_s3[17] & ~sum_s3[16]);
    wire zeros_s4_both_7 = ~sum_s3[15] & ~sum_s3[14];
    wire zeros_s4_both_8 = zeros_s4_both_6 & (zeros_s4_both_7 & (~sum_s3[13] & ~sum_s3[12]));
    wire zeros_s4_both_9 = zeros_s4_both_4 & zeros_s4_both_8;
    wire zeros_s4_both_10 = ~sum_s3[11] & ~sum_s3[10];
    wire zeros_s4_both_11 = zeros_s4_both_10 & (~sum_s3[9] & ~sum_s3[8]);
    wire not_sum_s3_7_and_not_sum_s3_6 = ~sum_s3[7] & ~sum_s3[6];
    wire zeros_s4_both_12 = zeros_s4_both_11 & (not_sum_s3_7_and_not_sum_s3_6 & (~sum_s3[5] & ~sum_s3[4]));
    wire not_sum_s3_3_and_not_sum_s3_2 = ~sum_s3[3] & ~sum_s3[2];
    wire zeros_s4_both_13 = not_sum_s3_3_and_not_sum_s3_2 & (~sum_s3[1] & ~sum_s3[0]);
    wire [1:0] zeros_s4_bits = {not_sum_s3_3_and_not_sum_s3_2, not_sum_s3_3_and_not_sum_s3_2 ? ~sum_s3[1] : ~sum_s3[3]};
    wire [1:0] zeros_s4_bits_2 = {not_sum_s3_7_and_not_sum_s3_6, not_sum_s3_7_and_not_sum_s3_6 ? ~sum_s3[5] : ~sum_s3[7]};
    wire [1:0] zeros_s4_choice = zeros_s4_both_11 ? zeros_s4_bits_2 : {zeros_s4_both_10, zeros_s4_both_10 ? ~sum_s3[9] : ~sum_s3[11]};
    wire [2:0] zeros_s4_choice_2 = zeros_s4_both_12 ? {zeros_s4_both_13, zeros_s4_both_13 ? 2'd0 : zeros_s4_bits} : {zeros_s4_both_11, zeros_s4_choice};
    wire [1:0] zeros_s4_choice_3 = zeros_s4_both_6 ? {zeros_s4_both_7, zeros_s4_both_7 ? ~sum_s3[13] : ~sum_s3[15]} : {zeros_s4_both_5, zeros_s4_both_5 ? ~sum_s3[17] : ~sum_s3[19]};
    wire [1:0] zeros_s4_choice_4 = zeros_s4_both_2 ? {zeros_s4_both_3, zeros_s4_both_3 ? ~sum_s3[21] : ~sum_s3[23]} : {zeros_s4_both, zeros_s4_both ? ~sum_s3[25] : ~sum_s3[27]};
    wire [2:0] zeros_s4_choice_5 = zeros_s4_both_4 ? {zeros_s4_both_6, zeros_s4_choice_3} : {zeros_s4_both_2, zeros_s4_choice_4};
    wire [3:0] zeros_s4_choice_6 = zeros_s4_both_9 ? {zeros_s4_both_12, zeros_s4_choice_2} : {zeros_s4_both_4, zeros_s4_choice_5};
    wire [27:0] value_s4_shifted_by_zeros_s4 = value_s4 << zeros_s4;
    wire sum_s3_is_0 = sum_s3 == 28'd0;
    wire y_both = (exponent_s5 == 10'd0) & ~(&significand_s5[24:2] & significand_s5[1]);
    wire round_up = significand_s5[1] & (significand_s5[0] | significand_s5[2]);
    wire [30:0] rounded = {exponent_s5[7:0], significand_s5[24:2]} + {30'd0, round_up};
    wire [30:0] y_choice = (infinite_s5 | (~exponent_s5[9] & (10'd255 <= exponent_s5))) ? 31'h7f800000 : rounded;
    wire [30:0] y_choice_2 = (zero_s5 | ((exponent_s5[9] | y_both) & ~infinite_s5)) ? 31'd0 : y_choice;

    always @(posedge clk) begin
        if (enable) begin
            distance_s1 <= swap ? ({2'd0, b_field} - {2'd0, a_field}) : ({2'd0, a_field} - {2'd0, b_field});
            large_s1 <= {large_s1_inverted_3, (swap ? b_fraction : a_fraction) & {23{large_s1_inverted_3}}};
            small_s1 <= {small_s1_inverted, (swap ? a_fraction : b_fraction) & {23{small_s1_inverted}}};
            large_s2 <= large_s1;
            aligned_s2 <= |distance_s1[7:5] ? {26'd0, |{small_s1, 3'd0}} : {aligned_s2_choice_5[26:1], aligned_s2_either_3};
            subtract_s1 <= a_31_xor_b_31;
            subtract_s2 <= subtract_s1;
            sum_s3 <= sum_s3_sum[28:1];
            sign_s1 <= swap ? b[31] : a[31];
            sign_s2 <= sign_s1;
            sign_s3 <= sign_s2;
            nan_s1 <= (&a_field & |a_fraction) | (&b_field & |b_fraction) | (nan_s1_both & nan_s1_both_2 & a_31_xor_b_31);
            nan_s2 <= nan_s1;
            nan_s3 <= nan_s2;
            infinite_s1 <= nan_s1_both | nan_s1_both_2;
            infinite_s2 <= infinite_s1;
            infinite_s3 <= infinite_s2;
            subtract_s3 <= subtract_s2;
            value_s4 <= sum_s3;
            zeros_s4 <= {zeros_s4_both_9, zeros_s4_choice_6};
            limit_s1 <= swap ? {2'd0, b_field} : {2'd0, a_field};
            limit_s2 <= limit_s1;
            limit_s3 <= limit_s2;
            limit_s4 <= limit_s3;
            exponent_s5 <= (limit_s4 + 10'd1) - {5'd0, zeros_s4};
            significand_s5 <= {value_s4_shifted_by_zeros_s4[27:3], |value_s4_shifted_by_zeros_s4[2:0]};
            sign_s4 <= sign_s3 & ~(sum_s3_is_0 & subtract_s3);
            sign_s5 <= sign_s4;
            nan_s4 <= nan_s3;
            nan_s5 <= nan_s4;
            infinite_s4 <= infinite_s3;
            infinite_s5 <= infinite_s4;
            zero_s4 <= sum_s3_is_0 & ~infinite_s3;
            zero_s5 <= zero_s4;
            y <= nan_s5 ? 32'h7fc00000 : {sign_s5, y_choice_2};
        end
    end

    wire _unused = &{1'b0, distance_s1[9:8], significand_s5[25], sum_s3_sum[0]};
endmodule

// Queue of two in registers.
// width = 195
module stream_skid_w195 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [194:0] in_data,
    output wire out_valid, input wire out_ready, output wire [194:0] out_data
);
    reg head_filled, second_filled, room;
    reg [194:0] head, second;

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
// width = 83
module stream_skid_w83 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [82:0] in_data,
    output wire out_valid, input wire out_ready, output wire [82:0] out_data
);
    reg head_filled, second_filled, room;
    reg [82:0] head, second;

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

// Queue in a memory with a registered output.
// depth = 4
// width = 28
module stream_fifo_d4_w28 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [27:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [27:0] out_data
);
    reg [2:0] held, waiting;
    reg is_full, any_waits;
    reg [1:0] write_address, read_address;
    wire [27:0] item;

    wire has_room = ~is_full;
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [2:0] held_bits = {{2{~push}}, 1'd1};
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    memory_1w1r_unordered #(.WIDTH(28), .DEPTH(4)) entries (
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
