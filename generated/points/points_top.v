// The whole design is one file, named after its top.
/* verilator lint_off DECLFILENAME */

// Point processor: queries in, what a program makes of their neighbors out.
module points_top (
    input  wire clk, input wire rst,
    input  wire tree_valid,  // Write to the tree memories, not while a query is under way.
    input  wire tree_is_leaf,  // Chooses the leaf table, else the node memory.
    input  wire [13:0] tree_address,  // The leaf's number or the node.
    input  wire [31:0] tree_split,  // Where its plane cuts its dimension.
    input  wire [1:0] tree_dimension,  // Its dimension.
    input  wire tree_internal_leaf,  // It is a leaf.
    input  wire [21:0] tree_begin,  // The first beat.
    input  wire [2:0] tree_beats,  // The number of beats, at least one.
    input  wire [5:0] search_k,  // Neighbors wanted.
    input  wire [31:0] search_radius2,  // Squared radius within which neighbors count.
    input  wire [31:0] setting_inverse_radius2,  // Words of the settings.
    input  wire [31:0] setting_tolerance,  // Words of the settings.
    input  wire [15:0] iterations_max,  // Iterations that a query has at most, at least one.
    input  wire query_valid, output wire query_ready,  // Queries.
    input  wire [23:0] query_number,  // Its number, which its result bears.
    input  wire [31:0] query_query_position_x,  // Words of the query, its position first.
    input  wire [31:0] query_query_position_y,  // Words of the query, its position first.
    input  wire [31:0] query_query_position_z,  // Words of the query, its position first.
    output wire fetch_valid, input wire fetch_ready,  // Requests to the memory of positions, as the search wants them.
    output wire [3:0] fetch_thread,  // Thread.
    output wire [21:0] fetch_address,  // First beat.
    output wire [2:0] fetch_beats,  // Number of beats, at least one.
    input  wire beat_valid, output wire beat_ready,  // Positions from memory: the beats of a request in order and together, requests in any order.
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
    output wire line_valid, input wire line_ready,  // Requests to the memory of points, as the program wants them.
    output wire [21:0] line_line,  // The line: the points from `line_points · line` on.
    input  wire fill_valid, output wire fill_ready,  // The points of the lines from memory, in the order of the requests.
    input  wire [31:0] fill_position_x,  // Words of the neighbor.
    input  wire [31:0] fill_position_y,  // Words of the neighbor.
    input  wire [31:0] fill_position_z,  // Words of the neighbor.
    input  wire [31:0] fill_normal_x,  // Words of the neighbor.
    input  wire [31:0] fill_normal_y,  // Words of the neighbor.
    input  wire [31:0] fill_normal_z,  // Words of the neighbor.
    output wire result_valid, input wire result_ready,  // Queries that leave, in any order.
    output wire [23:0] result_number,  // Its number.
    output wire [15:0] result_iterations,  // Iterations that it took.
    output wire result_capped,  // It was not done, but had no iteration left.
    output wire [31:0] result_output_position_x,  // Words of the outputs.
    output wire [31:0] result_output_position_y,  // Words of the outputs.
    output wire [31:0] result_output_position_z,  // Words of the outputs.
    output wire [31:0] result_output_normal_x,  // Words of the outputs.
    output wire [31:0] result_output_normal_y,  // Words of the outputs.
    output wire [31:0] result_output_normal_z,  // Words of the outputs.
    output wire [31:0] result_output_residual,  // Words of the outputs.
    output wire result_output_valid,  // Words of the outputs.
    output wire idle,  // Nothing is under way.
    output wire event_node,  // A node was visited.
    output wire event_pop,  // A path was popped.
    output wire event_beat,  // A priority queue was done with a beat of points.
    output wire event_insert,  // A neighbor was inserted.
    output wire event_insert_wait,  // A beat stayed for one more insertion.
    output wire event_thread_wait,  // A query waited for a free thread.
    output wire event_point_hit,  // The point cache had a leaf that was wanted.
    output wire event_point_miss,  // The point cache lacked a leaf that was wanted.
    output wire event_query_wait,  // A query waited for a thread.
    output wire event_kernel,  // The kernel took a neighbor.
    output wire event_kernel_wait,  // A neighbor waited for the kernel.
    output wire event_again,  // A query was not done after an iteration.
    output wire event_line_hit,  // A line that was wanted was there.
    output wire event_line_miss  // A line that was wanted was not there.
);
    wire search_core_query_ready, search_core_result_valid;
    wire [23:0] search_core_result_number;
    wire search_core_result_last, search_core_result_found;
    wire [23:0] search_core_result_index;
    wire [31:0] search_core_result_distance2;
    wire process_core_wanted_valid;
    wire [6:0] process_core_wanted_thread;
    wire [31:0] process_core_wanted_query_position_x, process_core_wanted_query_position_y;
    wire [31:0] process_core_wanted_query_position_z;
    wire process_core_found_ready;

    search_top search_core (
        .clk(clk), .rst(rst), .tree_valid(tree_valid), .tree_is_leaf(tree_is_leaf),
        .tree_address(tree_address), .tree_split(tree_split), .tree_dimension(tree_dimension),
        .tree_internal_leaf(tree_internal_leaf), .tree_begin(tree_begin), .tree_beats(tree_beats),
        .query_valid(process_core_wanted_valid), .query_ready(search_core_query_ready),
        .query_number({17'd0, process_core_wanted_thread}), .query_k(search_k),
        .query_radius2(search_radius2), .query_x(process_core_wanted_query_position_x),
        .query_y(process_core_wanted_query_position_y), .query_z(process_core_wanted_query_position_z),
        .fetch_valid(fetch_valid), .fetch_ready(fetch_ready), .fetch_thread(fetch_thread),
        .fetch_address(fetch_address), .fetch_beats(fetch_beats),
        .beat_valid(beat_valid), .beat_ready(beat_ready), .beat_thread(beat_thread),
        .beat_address(beat_address), .beat_last(beat_last), .beat_x0(beat_x0), .beat_y0(beat_y0),
        .beat_z0(beat_z0), .beat_x1(beat_x1), .beat_y1(beat_y1), .beat_z1(beat_z1), .beat_x2(beat_x2),
        .beat_y2(beat_y2), .beat_z2(beat_z2), .beat_x3(beat_x3), .beat_y3(beat_y3), .beat_z3(beat_z3),
        .result_valid(search_core_result_valid), .result_ready(process_core_found_ready),
        .result_number(search_core_result_number), .result_last(search_core_result_last),
        .result_found(search_core_result_found), .result_index(search_core_result_index),
        .result_distance2(search_core_result_distance2),
        .event_node(event_node), .event_pop(event_pop), .event_beat(event_beat), .event_insert(event_insert),
        .event_insert_wait(event_insert_wait), .event_thread_wait(event_thread_wait),
        .event_point_hit(event_point_hit), .event_point_miss(event_point_miss)
    );

    process_top process_core (
        .clk(clk), .rst(rst), .setting_inverse_radius2(setting_inverse_radius2),
        .setting_tolerance(setting_tolerance),
        .iterations_max(iterations_max),
        .forget(1'd0), .query_valid(query_valid), .query_ready(query_ready), .query_number(query_number),
        .query_query_position_x(query_query_position_x), .query_query_position_y(query_query_position_y),
        .query_query_position_z(query_query_position_z),
        .wanted_valid(process_core_wanted_valid), .wanted_ready(search_core_query_ready),
        .wanted_thread(process_core_wanted_thread),
        .wanted_query_position_x(process_core_wanted_query_position_x),
        .wanted_query_position_y(process_core_wanted_query_position_y),
        .wanted_query_position_z(process_core_wanted_query_position_z),
        .found_valid(search_core_result_valid), .found_ready(process_core_found_ready),
        .found_thread(search_core_result_number[6:0]), .found_last(search_core_result_last),
        .found_found(search_core_result_found), .found_index(search_core_result_index),
        .fetch_valid(line_valid), .fetch_ready(line_ready), .fetch_line(line_line),
        .fill_valid(fill_valid), .fill_ready(fill_ready), .fill_position_x(fill_position_x),
        .fill_position_y(fill_position_y), .fill_position_z(fill_position_z), .fill_normal_x(fill_normal_x),
        .fill_normal_y(fill_normal_y), .fill_normal_z(fill_normal_z),
        .result_valid(result_valid), .result_ready(result_ready), .result_number(result_number),
        .result_iterations(result_iterations), .result_capped(result_capped),
        .result_output_position_x(result_output_position_x),
        .result_output_position_y(result_output_position_y),
        .result_output_position_z(result_output_position_z), .result_output_normal_x(result_output_normal_x),
        .result_output_normal_y(result_output_normal_y), .result_output_normal_z(result_output_normal_z),
        .result_output_residual(result_output_residual), .result_output_valid(result_output_valid),
        .idle(idle), .event_query_wait(event_query_wait), .event_kernel(event_kernel),
        .event_kernel_wait(event_kernel_wait), .event_again(event_again), .event_line_hit(event_line_hit),
        .event_line_miss(event_line_miss)
    );

    wire _unused = &{1'b0, search_core_result_distance2, search_core_result_number[23:7]};
endmodule

// Queries and neighbors found in, what a program makes of them out.
module process_top (
    input  wire clk, input wire rst,
    input  wire [31:0] setting_inverse_radius2,  // Words of the settings.
    input  wire [31:0] setting_tolerance,  // Words of the settings.
    input  wire [15:0] iterations_max,  // Iterations that a query has at most, at least one.
    input  wire forget,  // The points have changed. Not while a query is under way.
    input  wire query_valid, output wire query_ready,  // Queries.
    input  wire [23:0] query_number,  // Its number, which its result bears.
    input  wire [31:0] query_query_position_x,  // Words of the query, its position first.
    input  wire [31:0] query_query_position_y,  // Words of the query, its position first.
    input  wire [31:0] query_query_position_z,  // Words of the query, its position first.
    output wire wanted_valid, input wire wanted_ready,  // Searches.
    output wire [6:0] wanted_thread,  // Thread.
    output wire [31:0] wanted_query_position_x,  // Where.
    output wire [31:0] wanted_query_position_y,  // Where.
    output wire [31:0] wanted_query_position_z,  // Where.
    input  wire found_valid, output wire found_ready,  // Neighbors found.
    input  wire [6:0] found_thread,  // Thread.
    input  wire found_last,  // Closes the search.
    input  wire found_found,  // There is a neighbor.
    input  wire [23:0] found_index,  // The neighbor.
    output wire fetch_valid, input wire fetch_ready,  // Requests to the memory of the points.
    output wire [21:0] fetch_line,  // The line: the points from `line_points · line` on.
    input  wire fill_valid, output wire fill_ready,  // The points of the lines from memory, in the order of the requests.
    input  wire [31:0] fill_position_x,  // Words of the neighbor.
    input  wire [31:0] fill_position_y,  // Words of the neighbor.
    input  wire [31:0] fill_position_z,  // Words of the neighbor.
    input  wire [31:0] fill_normal_x,  // Words of the neighbor.
    input  wire [31:0] fill_normal_y,  // Words of the neighbor.
    input  wire [31:0] fill_normal_z,  // Words of the neighbor.
    output wire result_valid, input wire result_ready,  // Queries that leave, in any order.
    output wire [23:0] result_number,  // Its number.
    output wire [15:0] result_iterations,  // Iterations that it took.
    output wire result_capped,  // It was not done, but had no iteration left.
    output wire [31:0] result_output_position_x,  // Words of the outputs.
    output wire [31:0] result_output_position_y,  // Words of the outputs.
    output wire [31:0] result_output_position_z,  // Words of the outputs.
    output wire [31:0] result_output_normal_x,  // Words of the outputs.
    output wire [31:0] result_output_normal_y,  // Words of the outputs.
    output wire [31:0] result_output_normal_z,  // Words of the outputs.
    output wire [31:0] result_output_residual,  // Words of the outputs.
    output wire result_output_valid,  // Words of the outputs.
    output wire idle,  // Nothing is under way.
    output wire event_query_wait,  // A query waited for a thread.
    output wire event_kernel,  // The kernel took a neighbor.
    output wire event_kernel_wait,  // A neighbor waited for the kernel.
    output wire event_again,  // A query was not done after an iteration.
    output wire event_line_hit,  // A line that was wanted was there.
    output wire event_line_miss  // A line that was wanted was not there.
);
    reg kernel_took, kernel_waited;

    wire threads_gather_valid;
    wire [6:0] threads_gather_thread;
    wire threads_gather_farthest, threads_gather_none, threads_gather_last;
    wire [23:0] threads_gather_index;
    wire threads_gathered_ready, threads_kernel_valid;
    wire [6:0] threads_kernel_thread;
    wire threads_kernel_none, threads_kernel_last;
    wire [31:0] threads_kernel_query_position_x, threads_kernel_query_position_y, threads_kernel_query_position_z;
    wire [31:0] threads_kernel_neighbor_position_x, threads_kernel_neighbor_position_y;
    wire [31:0] threads_kernel_neighbor_position_z, threads_kernel_neighbor_normal_x;
    wire [31:0] threads_kernel_neighbor_normal_y, threads_kernel_neighbor_normal_z;
    wire threads_sums_ready, gatherer_gather_ready, gatherer_gathered_valid;
    wire [6:0] gatherer_gathered_thread;
    wire gatherer_gathered_farthest, gatherer_gathered_none, gatherer_gathered_last;
    wire [31:0] gatherer_gathered_position_x, gatherer_gathered_position_y, gatherer_gathered_position_z;
    wire [31:0] gatherer_gathered_normal_x, gatherer_gathered_normal_y, gatherer_gathered_normal_z;
    wire kernel_neighbor_ready, kernel_sums_valid;
    wire [6:0] kernel_sums_thread;
    wire [31:0] kernel_sums_weight_0, kernel_sums_weight_1, kernel_sums_weight_2, kernel_sums_weight_3;
    wire [31:0] kernel_sums_weight_4, kernel_sums_weight_5, kernel_sums_weight_6, kernel_sums_weight_7;
    wire [31:0] kernel_sums_points_x_0, kernel_sums_points_x_1, kernel_sums_points_x_2, kernel_sums_points_x_3;
    wire [31:0] kernel_sums_points_x_4, kernel_sums_points_x_5, kernel_sums_points_x_6, kernel_sums_points_x_7;
    wire [31:0] kernel_sums_points_y_0, kernel_sums_points_y_1, kernel_sums_points_y_2, kernel_sums_points_y_3;
    wire [31:0] kernel_sums_points_y_4, kernel_sums_points_y_5, kernel_sums_points_y_6, kernel_sums_points_y_7;
    wire [31:0] kernel_sums_points_z_0, kernel_sums_points_z_1, kernel_sums_points_z_2, kernel_sums_points_z_3;
    wire [31:0] kernel_sums_points_z_4, kernel_sums_points_z_5, kernel_sums_points_z_6, kernel_sums_points_z_7;
    wire [31:0] kernel_sums_normals_x_0, kernel_sums_normals_x_1, kernel_sums_normals_x_2, kernel_sums_normals_x_3;
    wire [31:0] kernel_sums_normals_x_4, kernel_sums_normals_x_5, kernel_sums_normals_x_6, kernel_sums_normals_x_7;
    wire [31:0] kernel_sums_normals_y_0, kernel_sums_normals_y_1, kernel_sums_normals_y_2, kernel_sums_normals_y_3;
    wire [31:0] kernel_sums_normals_y_4, kernel_sums_normals_y_5, kernel_sums_normals_y_6, kernel_sums_normals_y_7;
    wire [31:0] kernel_sums_normals_z_0, kernel_sums_normals_z_1, kernel_sums_normals_z_2, kernel_sums_normals_z_3;
    wire [31:0] kernel_sums_normals_z_4, kernel_sums_normals_z_5, kernel_sums_normals_z_6, kernel_sums_normals_z_7;

    assign event_kernel = kernel_took;
    assign event_kernel_wait = kernel_waited;

    process_threads threads (
        .clk(clk), .rst(rst), .setting_inverse_radius2(setting_inverse_radius2),
        .setting_tolerance(setting_tolerance),
        .iterations_max(iterations_max),
        .query_valid(query_valid), .query_ready(query_ready), .query_number(query_number),
        .query_query_position_x(query_query_position_x), .query_query_position_y(query_query_position_y),
        .query_query_position_z(query_query_position_z),
        .wanted_valid(wanted_valid), .wanted_ready(wanted_ready), .wanted_thread(wanted_thread),
        .wanted_query_position_x(wanted_query_position_x), .wanted_query_position_y(wanted_query_position_y),
        .wanted_query_position_z(wanted_query_position_z),
        .found_valid(found_valid), .found_ready(found_ready), .found_thread(found_thread),
        .found_last(found_last), .found_found(found_found), .found_index(found_index),
        .gather_valid(threads_gather_valid), .gather_ready(gatherer_gather_ready),
        .gather_thread(threads_gather_thread), .gather_farthest(threads_gather_farthest),
        .gather_none(threads_gather_none), .gather_last(threads_gather_last),
        .gather_index(threads_gather_index),
        .gathered_valid(gatherer_gathered_valid), .gathered_ready(threads_gathered_ready),
        .gathered_thread(gatherer_gathered_thread), .gathered_farthest(gatherer_gathered_farthest),
        .gathered_none(gatherer_gathered_none), .gathered_last(gatherer_gathered_last),
        .gathered_position_x(gatherer_gathered_position_x),
        .gathered_position_y(gatherer_gathered_position_y),
        .gathered_position_z(gatherer_gathered_position_z), .gathered_normal_x(gatherer_gathered_normal_x),
        .gathered_normal_y(gatherer_gathered_normal_y), .gathered_normal_z(gatherer_gathered_normal_z),
        .kernel_valid(threads_kernel_valid), .kernel_ready(kernel_neighbor_ready),
        .kernel_thread(threads_kernel_thread), .kernel_none(threads_kernel_none),
        .kernel_last(threads_kernel_last), .kernel_query_position_x(threads_kernel_query_position_x),
        .kernel_query_position_y(threads_kernel_query_position_y),
        .kernel_query_position_z(threads_kernel_query_position_z),
        .kernel_neighbor_position_x(threads_kernel_neighbor_position_x),
        .kernel_neighbor_position_y(threads_kernel_neighbor_position_y),
        .kernel_neighbor_position_z(threads_kernel_neighbor_position_z),
        .kernel_neighbor_normal_x(threads_kernel_neighbor_normal_x),
        .kernel_neighbor_normal_y(threads_kernel_neighbor_normal_y),
        .kernel_neighbor_normal_z(threads_kernel_neighbor_normal_z),
        .sums_valid(kernel_sums_valid), .sums_ready(threads_sums_ready), .sums_thread(kernel_sums_thread),
        .sums_weight_0(kernel_sums_weight_0), .sums_weight_1(kernel_sums_weight_1),
        .sums_weight_2(kernel_sums_weight_2), .sums_weight_3(kernel_sums_weight_3),
        .sums_weight_4(kernel_sums_weight_4), .sums_weight_5(kernel_sums_weight_5),
        .sums_weight_6(kernel_sums_weight_6), .sums_weight_7(kernel_sums_weight_7),
        .sums_points_x_0(kernel_sums_points_x_0), .sums_points_x_1(kernel_sums_points_x_1),
        .sums_points_x_2(kernel_sums_points_x_2), .sums_points_x_3(kernel_sums_points_x_3),
        .sums_points_x_4(kernel_sums_points_x_4), .sums_points_x_5(kernel_sums_points_x_5),
        .sums_points_x_6(kernel_sums_points_x_6), .sums_points_x_7(kernel_sums_points_x_7),
        .sums_points_y_0(kernel_sums_points_y_0), .sums_points_y_1(kernel_sums_points_y_1),
        .sums_points_y_2(kernel_sums_points_y_2), .sums_points_y_3(kernel_sums_points_y_3),
        .sums_points_y_4(kernel_sums_points_y_4), .sums_points_y_5(kernel_sums_points_y_5),
        .sums_points_y_6(kernel_sums_points_y_6), .sums_points_y_7(kernel_sums_points_y_7),
        .sums_points_z_0(kernel_sums_points_z_0), .sums_points_z_1(kernel_sums_points_z_1),
        .sums_points_z_2(kernel_sums_points_z_2), .sums_points_z_3(kernel_sums_points_z_3),
        .sums_points_z_4(kernel_sums_points_z_4), .sums_points_z_5(kernel_sums_points_z_5),
        .sums_points_z_6(kernel_sums_points_z_6), .sums_points_z_7(kernel_sums_points_z_7),
        .sums_normals_x_0(kernel_sums_normals_x_0), .sums_normals_x_1(kernel_sums_normals_x_1),
        .sums_normals_x_2(kernel_sums_normals_x_2), .sums_normals_x_3(kernel_sums_normals_x_3),
        .sums_normals_x_4(kernel_sums_normals_x_4), .sums_normals_x_5(kernel_sums_normals_x_5),
        .sums_normals_x_6(kernel_sums_normals_x_6), .sums_normals_x_7(kernel_sums_normals_x_7),
        .sums_normals_y_0(kernel_sums_normals_y_0), .sums_normals_y_1(kernel_sums_normals_y_1),
        .sums_normals_y_2(kernel_sums_normals_y_2), .sums_normals_y_3(kernel_sums_normals_y_3),
        .sums_normals_y_4(kernel_sums_normals_y_4), .sums_normals_y_5(kernel_sums_normals_y_5),
        .sums_normals_y_6(kernel_sums_normals_y_6), .sums_normals_y_7(kernel_sums_normals_y_7),
        .sums_normals_z_0(kernel_sums_normals_z_0), .sums_normals_z_1(kernel_sums_normals_z_1),
        .sums_normals_z_2(kernel_sums_normals_z_2), .sums_normals_z_3(kernel_sums_normals_z_3),
        .sums_normals_z_4(kernel_sums_normals_z_4), .sums_normals_z_5(kernel_sums_normals_z_5),
        .sums_normals_z_6(kernel_sums_normals_z_6), .sums_normals_z_7(kernel_sums_normals_z_7),
        .result_valid(result_valid), .result_ready(result_ready), .result_number(result_number),
        .result_iterations(result_iterations), .result_capped(result_capped),
        .result_output_position_x(result_output_position_x),
        .result_output_position_y(result_output_position_y),
        .result_output_position_z(result_output_position_z), .result_output_normal_x(result_output_normal_x),
        .result_output_normal_y(result_output_normal_y), .result_output_normal_z(result_output_normal_z),
        .result_output_residual(result_output_residual), .result_output_valid(result_output_valid),
        .idle(idle), .event_query_wait(event_query_wait), .event_again(event_again)
    );

    process_gather gatherer (
        .clk(clk), .rst(rst), .forget(forget), .gather_valid(threads_gather_valid),
        .gather_ready(gatherer_gather_ready), .gather_thread(threads_gather_thread),
        .gather_farthest(threads_gather_farthest), .gather_none(threads_gather_none),
        .gather_last(threads_gather_last), .gather_index(threads_gather_index),
        .fetch_valid(fetch_valid), .fetch_ready(fetch_ready), .fetch_line(fetch_line),
        .gathered_valid(gatherer_gathered_valid), .gathered_ready(threads_gathered_ready),
        .gathered_thread(gatherer_gathered_thread), .gathered_farthest(gatherer_gathered_farthest),
        .gathered_none(gatherer_gathered_none), .gathered_last(gatherer_gathered_last),
        .gathered_position_x(gatherer_gathered_position_x),
        .gathered_position_y(gatherer_gathered_position_y),
        .gathered_position_z(gatherer_gathered_position_z), .gathered_normal_x(gatherer_gathered_normal_x),
        .gathered_normal_y(gatherer_gathered_normal_y), .gathered_normal_z(gatherer_gathered_normal_z),
        .event_line_hit(event_line_hit), .event_line_miss(event_line_miss),
        .fill_valid(fill_valid), .fill_ready(fill_ready), .fill_position_x(fill_position_x),
        .fill_position_y(fill_position_y), .fill_position_z(fill_position_z), .fill_normal_x(fill_normal_x),
        .fill_normal_y(fill_normal_y), .fill_normal_z(fill_normal_z)
    );

    process_kernel kernel (
        .clk(clk), .rst(rst), .setting_inverse_radius2(setting_inverse_radius2),
        .setting_tolerance(setting_tolerance),
        .neighbor_valid(threads_kernel_valid), .neighbor_ready(kernel_neighbor_ready),
        .neighbor_thread(threads_kernel_thread), .neighbor_none(threads_kernel_none),
        .neighbor_last(threads_kernel_last), .neighbor_query_position_x(threads_kernel_query_position_x),
        .neighbor_query_position_y(threads_kernel_query_position_y),
        .neighbor_query_position_z(threads_kernel_query_position_z),
        .neighbor_neighbor_position_x(threads_kernel_neighbor_position_x),
        .neighbor_neighbor_position_y(threads_kernel_neighbor_position_y),
        .neighbor_neighbor_position_z(threads_kernel_neighbor_position_z),
        .neighbor_neighbor_normal_x(threads_kernel_neighbor_normal_x),
        .neighbor_neighbor_normal_y(threads_kernel_neighbor_normal_y),
        .neighbor_neighbor_normal_z(threads_kernel_neighbor_normal_z),
        .sums_valid(kernel_sums_valid), .sums_ready(threads_sums_ready), .sums_thread(kernel_sums_thread),
        .sums_weight_0(kernel_sums_weight_0), .sums_weight_1(kernel_sums_weight_1),
        .sums_weight_2(kernel_sums_weight_2), .sums_weight_3(kernel_sums_weight_3),
        .sums_weight_4(kernel_sums_weight_4), .sums_weight_5(kernel_sums_weight_5),
        .sums_weight_6(kernel_sums_weight_6), .sums_weight_7(kernel_sums_weight_7),
        .sums_points_x_0(kernel_sums_points_x_0), .sums_points_x_1(kernel_sums_points_x_1),
        .sums_points_x_2(kernel_sums_points_x_2), .sums_points_x_3(kernel_sums_points_x_3),
        .sums_points_x_4(kernel_sums_points_x_4), .sums_points_x_5(kernel_sums_points_x_5),
        .sums_points_x_6(kernel_sums_points_x_6), .sums_points_x_7(kernel_sums_points_x_7),
        .sums_points_y_0(kernel_sums_points_y_0), .sums_points_y_1(kernel_sums_points_y_1),
        .sums_points_y_2(kernel_sums_points_y_2), .sums_points_y_3(kernel_sums_points_y_3),
        .sums_points_y_4(kernel_sums_points_y_4), .sums_points_y_5(kernel_sums_points_y_5),
        .sums_points_y_6(kernel_sums_points_y_6), .sums_points_y_7(kernel_sums_points_y_7),
        .sums_points_z_0(kernel_sums_points_z_0), .sums_points_z_1(kernel_sums_points_z_1),
        .sums_points_z_2(kernel_sums_points_z_2), .sums_points_z_3(kernel_sums_points_z_3),
        .sums_points_z_4(kernel_sums_points_z_4), .sums_points_z_5(kernel_sums_points_z_5),
        .sums_points_z_6(kernel_sums_points_z_6), .sums_points_z_7(kernel_sums_points_z_7),
        .sums_normals_x_0(kernel_sums_normals_x_0), .sums_normals_x_1(kernel_sums_normals_x_1),
        .sums_normals_x_2(kernel_sums_normals_x_2), .sums_normals_x_3(kernel_sums_normals_x_3),
        .sums_normals_x_4(kernel_sums_normals_x_4), .sums_normals_x_5(kernel_sums_normals_x_5),
        .sums_normals_x_6(kernel_sums_normals_x_6), .sums_normals_x_7(kernel_sums_normals_x_7),
        .sums_normals_y_0(kernel_sums_normals_y_0), .sums_normals_y_1(kernel_sums_normals_y_1),
        .sums_normals_y_2(kernel_sums_normals_y_2), .sums_normals_y_3(kernel_sums_normals_y_3),
        .sums_normals_y_4(kernel_sums_normals_y_4), .sums_normals_y_5(kernel_sums_normals_y_5),
        .sums_normals_y_6(kernel_sums_normals_y_6), .sums_normals_y_7(kernel_sums_normals_y_7),
        .sums_normals_z_0(kernel_sums_normals_z_0), .sums_normals_z_1(kernel_sums_normals_z_1),
        .sums_normals_z_2(kernel_sums_normals_z_2), .sums_normals_z_3(kernel_sums_normals_z_3),
        .sums_normals_z_4(kernel_sums_normals_z_4), .sums_normals_z_5(kernel_sums_normals_z_5),
        .sums_normals_z_6(kernel_sums_normals_z_6), .sums_normals_z_7(kernel_sums_normals_z_7)
    );

    always @(posedge clk) begin
        if (rst) begin
            kernel_took <= 1'd0;
            kernel_waited <= 1'd0;
        end else begin
            kernel_took <= threads_kernel_valid & kernel_neighbor_ready;
            kernel_waited <= threads_kernel_valid & ~kernel_neighbor_ready;
        end
    end
endmodule

// Goes through neighbors and keeps their sums.
// rate = 1
module process_kernel (
    input  wire clk, input wire rst,
    input  wire [31:0] setting_inverse_radius2,  // Words of the settings.
    input  wire [31:0] setting_tolerance,  // Words of the settings.
    input  wire neighbor_valid, output wire neighbor_ready,  // The neighbors of a query after the other.
    input  wire [6:0] neighbor_thread,  // Thread.
    input  wire neighbor_none,  // There is no neighbor: the query has none.
    input  wire neighbor_last,  // The query's last neighbor.
    input  wire [31:0] neighbor_query_position_x,  // Words that `kernel` reads besides settings.
    input  wire [31:0] neighbor_query_position_y,  // Words that `kernel` reads besides settings.
    input  wire [31:0] neighbor_query_position_z,  // Words that `kernel` reads besides settings.
    input  wire [31:0] neighbor_neighbor_position_x,  // Words that `kernel` reads besides settings.
    input  wire [31:0] neighbor_neighbor_position_y,  // Words that `kernel` reads besides settings.
    input  wire [31:0] neighbor_neighbor_position_z,  // Words that `kernel` reads besides settings.
    input  wire [31:0] neighbor_neighbor_normal_x,  // Words that `kernel` reads besides settings.
    input  wire [31:0] neighbor_neighbor_normal_y,  // Words that `kernel` reads besides settings.
    input  wire [31:0] neighbor_neighbor_normal_z,  // Words that `kernel` reads besides settings.
    output wire sums_valid, input wire sums_ready,  // The sums of a query after the other.
    output wire [6:0] sums_thread,  // Thread.
    output wire [31:0] sums_weight_0,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_weight_1,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_weight_2,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_weight_3,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_weight_4,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_weight_5,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_weight_6,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_weight_7,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_points_x_0,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_points_x_1,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_points_x_2,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_points_x_3,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_points_x_4,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_points_x_5,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_points_x_6,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_points_x_7,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_points_y_0,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_points_y_1,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_points_y_2,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_points_y_3,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_points_y_4,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_points_y_5,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_points_y_6,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_points_y_7,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_points_z_0,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_points_z_1,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_points_z_2,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_points_z_3,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_points_z_4,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_points_z_5,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_points_z_6,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_points_z_7,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_normals_x_0,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_normals_x_1,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_normals_x_2,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_normals_x_3,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_normals_x_4,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_normals_x_5,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_normals_x_6,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_normals_x_7,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_normals_y_0,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_normals_y_1,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_normals_y_2,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_normals_y_3,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_normals_y_4,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_normals_y_5,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_normals_y_6,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_normals_y_7,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_normals_z_0,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_normals_z_1,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_normals_z_2,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_normals_z_3,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_normals_z_4,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_normals_z_5,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_normals_z_6,  // Of each word of the sums its partial sums.
    output wire [31:0] sums_normals_z_7  // Of each word of the sums its partial sums.
);
    (* ram_style = "distributed" *)
    reg [223:0] even_sums [0:15];
    (* ram_style = "distributed" *)
    reg [223:0] odd_sums [0:15];
    reg [3:0] taken, complete;
    reg [6:0] thread_0, thread_1, thread_2, thread_3;
    reg [3:0] present_0, present_1, present_2, present_3;
    reg [1:0] adding;
    reg [2:0] count;
    reg round;
    reg [1:0] leaving, left;
    reg shown;
    reg [6:0] shown_thread;
    reg [31:0] weight_6, weight_4, weight_2, weight_0, points_x_6, points_x_4, points_x_2, points_x_0, points_y_6;
    reg [31:0] points_y_4, points_y_2, points_y_0, points_z_6, points_z_4, points_z_2, points_z_0, normals_x_6;
    reg [31:0] normals_x_4, normals_x_2, normals_x_0, normals_y_6, normals_y_4, normals_y_2, normals_y_0;
    reg [31:0] normals_z_6, normals_z_4, normals_z_2, normals_z_0, weight_7, weight_5, weight_3, weight_1;
    reg [31:0] points_x_7, points_x_5, points_x_3, points_x_1, points_y_7, points_y_5, points_y_3, points_y_1;
    reg [31:0] points_z_7, points_z_5, points_z_3, points_z_1, normals_x_7, normals_x_5, normals_x_3, normals_x_1;
    reg [31:0] normals_y_7, normals_y_5, normals_y_3, normals_y_1, normals_z_7, normals_z_5, normals_z_3;
    reg [31:0] normals_z_1;

    wire sums_in_ready, sums_out_valid;
    wire [1:0] sums_out_bank;
    wire [2:0] sums_out_partial;
    wire sums_out_none, sums_out_last;
    wire [31:0] sums_out_weight, sums_out_points_x, sums_out_points_y, sums_out_points_z, sums_out_normals_x;
    wire [31:0] sums_out_normals_y, sums_out_normals_z;
    wire neighbor_queue_out_valid;
    wire [296:0] neighbor_queue_out_data;
    wire tags_in_ready, tags_out_valid;
    wire [8:0] tags_out_data;
    wire block_in_ready, block_out_valid;
    wire [31:0] block_out_sum_weight, block_out_sum_points_x, block_out_sum_points_y, block_out_sum_points_z;
    wire [31:0] block_out_sum_normals_x, block_out_sum_normals_y, block_out_sum_normals_z;

    wire begins = (count == 3'd0) & ~round;
    wire [3:0] taken_shifted_by_adding = taken >> adding;
    wire offers_inverted = ~(begins & taken_shifted_by_adding[0]);
    wire offers = block_out_valid & offers_inverted;
    wire tags_out_none = tags_out_data[1];
    wire tags_out_last = tags_out_data[0];
    wire [3:0] former_even_address_bits = {adding, count[2:1]};
    wire [223:0] former_odd = odd_sums[former_even_address_bits];
    wire [223:0] former_even = even_sums[former_even_address_bits];
    wire [223:0] sums_in_before_normals_z_choice = count[0] ? former_odd : former_even;
    wire enters = neighbor_queue_out_valid & block_in_ready;
    wire adds = block_out_valid & (sums_in_ready & offers_inverted);
    wire [31:0] neighbor_queue_out_query_position_x = neighbor_queue_out_data[287:256];
    wire [31:0] neighbor_queue_out_query_position_y = neighbor_queue_out_data[255:224];
    wire [31:0] neighbor_queue_out_query_position_z = neighbor_queue_out_data[223:192];
    wire [31:0] neighbor_queue_out_neighbor_position_x = neighbor_queue_out_data[191:160];
    wire [31:0] neighbor_queue_out_neighbor_position_y = neighbor_queue_out_data[159:128];
    wire [31:0] neighbor_queue_out_neighbor_position_z = neighbor_queue_out_data[127:96];
    wire [31:0] neighbor_queue_out_neighbor_normal_x = neighbor_queue_out_data[95:64];
    wire [31:0] neighbor_queue_out_neighbor_normal_y = neighbor_queue_out_data[63:32];
    wire [31:0] neighbor_queue_out_neighbor_normal_z = neighbor_queue_out_data[31:0];
    wire [3:0] complete_shifted_by_leaving = complete >> leaving;
    wire leaves = complete_shifted_by_leaving[0] & ~shown;
    wire bank_ends = leaves & &left;
    wire [3:0] complete_bits = {
        bank_ends & (leaving == 2'd3), bank_ends & (leaving == 2'd2), bank_ends & (leaving == 2'd1),
        bank_ends & (leaving == 2'd0)
    };
    wire [3:0] not_complete_bits = ~complete_bits;
    wire thread_3_enable_both = adds & (adding == 2'd3);
    wire thread_2_enable_both = adds & (adding == 2'd2);
    wire thread_1_enable_both = adds & (adding == 2'd1);
    wire thread_0_enable_both = adds & (adding == 2'd0);
    wire [3:0] taken_bits = {thread_3_enable_both, thread_2_enable_both, thread_1_enable_both, thread_0_enable_both};
    wire complete_both = sums_out_valid & sums_out_last;
    wire [3:0] complete_bits_2 = {
        complete_both & (sums_out_bank == 2'd3), complete_both & (sums_out_bank == 2'd2),
        complete_both & (sums_out_bank == 2'd1), complete_both & (sums_out_bank == 2'd0)
    };
    wire [6:0] tags_out_thread = tags_out_data[8:2];
    wire [3:0] next_count = {1'd0, count} + 4'd1;
    wire [3:0] present_0_choice = tags_out_none ? 4'd0 : round ? 4'd8 : next_count;
    wire [3:0] even_is_there_choice = leaving[1] ? (leaving[0] ? present_3 : present_2) : leaving[0] ? present_1 : present_0;
    wire even_is_there = {1'd0, left, 1'd0} < even_is_there_choice;
    wire [223:0] leaving_even = even_sums[{leaving, left}];
    wire odd_is_there = {1'd0, left, 1'd1} < even_is_there_choice;
    wire [223:0] leaving_odd = odd_sums[{leaving, left}];
    wire writes_sum = sums_out_valid & ~sums_out_none;
    wire [3:0] even_sums_address_bits = {sums_out_bank, sums_out_partial[2:1]};
    wire [223:0] even_sums_data_bits = {
        sums_out_weight, sums_out_points_x, sums_out_points_y, sums_out_points_z, sums_out_normals_x,
        sums_out_normals_y, sums_out_normals_z
    };

    assign sums_valid = shown;
    assign sums_thread = shown_thread;
    assign sums_weight_0 = weight_0;
    assign sums_weight_1 = weight_1;
    assign sums_weight_2 = weight_2;
    assign sums_weight_3 = weight_3;
    assign sums_weight_4 = weight_4;
    assign sums_weight_5 = weight_5;
    assign sums_weight_6 = weight_6;
    assign sums_weight_7 = weight_7;
    assign sums_points_x_0 = points_x_0;
    assign sums_points_x_1 = points_x_1;
    assign sums_points_x_2 = points_x_2;
    assign sums_points_x_3 = points_x_3;
    assign sums_points_x_4 = points_x_4;
    assign sums_points_x_5 = points_x_5;
    assign sums_points_x_6 = points_x_6;
    assign sums_points_x_7 = points_x_7;
    assign sums_points_y_0 = points_y_0;
    assign sums_points_y_1 = points_y_1;
    assign sums_points_y_2 = points_y_2;
    assign sums_points_y_3 = points_y_3;
    assign sums_points_y_4 = points_y_4;
    assign sums_points_y_5 = points_y_5;
    assign sums_points_y_6 = points_y_6;
    assign sums_points_y_7 = points_y_7;
    assign sums_points_z_0 = points_z_0;
    assign sums_points_z_1 = points_z_1;
    assign sums_points_z_2 = points_z_2;
    assign sums_points_z_3 = points_z_3;
    assign sums_points_z_4 = points_z_4;
    assign sums_points_z_5 = points_z_5;
    assign sums_points_z_6 = points_z_6;
    assign sums_points_z_7 = points_z_7;
    assign sums_normals_x_0 = normals_x_0;
    assign sums_normals_x_1 = normals_x_1;
    assign sums_normals_x_2 = normals_x_2;
    assign sums_normals_x_3 = normals_x_3;
    assign sums_normals_x_4 = normals_x_4;
    assign sums_normals_x_5 = normals_x_5;
    assign sums_normals_x_6 = normals_x_6;
    assign sums_normals_x_7 = normals_x_7;
    assign sums_normals_y_0 = normals_y_0;
    assign sums_normals_y_1 = normals_y_1;
    assign sums_normals_y_2 = normals_y_2;
    assign sums_normals_y_3 = normals_y_3;
    assign sums_normals_y_4 = normals_y_4;
    assign sums_normals_y_5 = normals_y_5;
    assign sums_normals_y_6 = normals_y_6;
    assign sums_normals_y_7 = normals_y_7;
    assign sums_normals_z_0 = normals_z_0;
    assign sums_normals_z_1 = normals_z_1;
    assign sums_normals_z_2 = normals_z_2;
    assign sums_normals_z_3 = normals_z_3;
    assign sums_normals_z_4 = normals_z_4;
    assign sums_normals_z_5 = normals_z_5;
    assign sums_normals_z_6 = normals_z_6;
    assign sums_normals_z_7 = normals_z_7;

    process_sums sums (
        .clk(clk), .rst(rst), .in_valid(offers), .in_ready(sums_in_ready), .in_bank(adding),
        .in_partial(count), .in_none(tags_out_none), .in_last(tags_out_last),
        .in_before_weight(round ? sums_in_before_normals_z_choice[223:192] : 32'd0),
        .in_before_points_x(round ? sums_in_before_normals_z_choice[191:160] : 32'd0),
        .in_before_points_y(round ? sums_in_before_normals_z_choice[159:128] : 32'd0),
        .in_before_points_z(round ? sums_in_before_normals_z_choice[127:96] : 32'd0),
        .in_before_normals_x(round ? sums_in_before_normals_z_choice[95:64] : 32'd0),
        .in_before_normals_y(round ? sums_in_before_normals_z_choice[63:32] : 32'd0),
        .in_before_normals_z(round ? sums_in_before_normals_z_choice[31:0] : 32'd0),
        .in_sum_weight(block_out_sum_weight), .in_sum_points_x(block_out_sum_points_x),
        .in_sum_points_y(block_out_sum_points_y), .in_sum_points_z(block_out_sum_points_z),
        .in_sum_normals_x(block_out_sum_normals_x), .in_sum_normals_y(block_out_sum_normals_y),
        .in_sum_normals_z(block_out_sum_normals_z),
        .out_valid(sums_out_valid), .out_ready(1'd1), .out_bank(sums_out_bank),
        .out_partial(sums_out_partial), .out_none(sums_out_none), .out_last(sums_out_last),
        .out_weight(sums_out_weight), .out_points_x(sums_out_points_x), .out_points_y(sums_out_points_y),
        .out_points_z(sums_out_points_z), .out_normals_x(sums_out_normals_x),
        .out_normals_y(sums_out_normals_y), .out_normals_z(sums_out_normals_z)
    );

    stream_skid_w297 neighbor_queue (
        .clk(clk), .rst(rst), .in_valid(neighbor_valid), .in_ready(neighbor_ready),
        .in_data({
            neighbor_thread, neighbor_none, neighbor_last, neighbor_query_position_x, neighbor_query_position_y,
            neighbor_query_position_z, neighbor_neighbor_position_x, neighbor_neighbor_position_y,
            neighbor_neighbor_position_z, neighbor_neighbor_normal_x, neighbor_neighbor_normal_y,
            neighbor_neighbor_normal_z
        }),
        .out_valid(neighbor_queue_out_valid), .out_ready(block_in_ready), .out_data(neighbor_queue_out_data)
    );

    stream_fifo_d55_w9_distributed tags (
        .clk(clk), .rst(rst), .in_valid(enters), .in_ready(tags_in_ready),
        .in_data(neighbor_queue_out_data[296:288]),
        .out_valid(tags_out_valid), .out_ready(adds), .out_data(tags_out_data)
    );

    mls_kernel block (
        .clk(clk), .rst(rst), .in_valid(neighbor_queue_out_valid), .in_ready(block_in_ready),
        .in_query_position_x(neighbor_queue_out_query_position_x),
        .in_query_position_y(neighbor_queue_out_query_position_y),
        .in_query_position_z(neighbor_queue_out_query_position_z),
        .in_neighbor_position_x(neighbor_queue_out_neighbor_position_x),
        .in_neighbor_position_y(neighbor_queue_out_neighbor_position_y),
        .in_neighbor_position_z(neighbor_queue_out_neighbor_position_z),
        .in_neighbor_normal_x(neighbor_queue_out_neighbor_normal_x),
        .in_neighbor_normal_y(neighbor_queue_out_neighbor_normal_y),
        .in_neighbor_normal_z(neighbor_queue_out_neighbor_normal_z),
        .setting_inverse_radius2(setting_inverse_radius2),
        .out_valid(block_out_valid), .out_ready(adds), .out_sum_weight(block_out_sum_weight),
        .out_sum_points_x(block_out_sum_points_x), .out_sum_points_y(block_out_sum_points_y),
        .out_sum_points_z(block_out_sum_points_z), .out_sum_normals_x(block_out_sum_normals_x),
        .out_sum_normals_y(block_out_sum_normals_y), .out_sum_normals_z(block_out_sum_normals_z)
    );

    always @(posedge clk) begin
        if (rst) begin
            taken <= 4'd0;
            complete <= 4'd0;
            adding <= 2'd0;
            count <= 3'd0;
            round <= 1'd0;
            leaving <= 2'd0;
            left <= 2'd0;
            shown <= 1'd0;
        end else begin
            taken <= (taken & not_complete_bits) | taken_bits;
            complete <= (complete & not_complete_bits) | complete_bits_2;
            shown <= bank_ends | (shown & ~sums_ready);
            if (adds & tags_out_last) adding <= adding + 2'd1;
            if (adds) begin
                count <= tags_out_last ? 3'd0 : next_count[2:0];
                round <= ~tags_out_last & (round | next_count[3]);
            end
            if (bank_ends) leaving <= leaving + 2'd1;
            if (leaves) left <= left + 2'd1;
        end
    end
    always @(posedge clk) begin
        if (thread_0_enable_both) begin
            thread_0 <= tags_out_thread;
            present_0 <= present_0_choice;
        end
        if (thread_1_enable_both) begin
            thread_1 <= tags_out_thread;
            present_1 <= present_0_choice;
        end
        if (thread_2_enable_both) begin
            thread_2 <= tags_out_thread;
            present_2 <= present_0_choice;
        end
        if (thread_3_enable_both) begin
            thread_3 <= tags_out_thread;
            present_3 <= present_0_choice;
        end
        if (bank_ends) begin
            shown_thread <= leaving[1] ? (leaving[0] ? thread_3 : thread_2) : leaving[0] ? thread_1 : thread_0;
        end
        if (leaves) begin
            weight_6 <= even_is_there ? leaving_even[223:192] : 32'd0;
            weight_4 <= weight_6;
            weight_2 <= weight_4;
            weight_0 <= weight_2;
            points_x_6 <= even_is_there ? leaving_even[191:160] : 32'd0;
            points_x_4 <= points_x_6;
            points_x_2 <= points_x_4;
            points_x_0 <= points_x_2;
            points_y_6 <= even_is_there ? leaving_even[159:128] : 32'd0;
            points_y_4 <= points_y_6;
            points_y_2 <= points_y_4;
            points_y_0 <= points_y_2;
            points_z_6 <= even_is_there ? leaving_even[127:96] : 32'd0;
            points_z_4 <= points_z_6;
            points_z_2 <= points_z_4;
            points_z_0 <= points_z_2;
            normals_x_6 <= even_is_there ? leaving_even[95:64] : 32'd0;
            normals_x_4 <= normals_x_6;
            normals_x_2 <= normals_x_4;
            normals_x_0 <= normals_x_2;
            normals_y_6 <= even_is_there ? leaving_even[63:32] : 32'd0;
            normals_y_4 <= normals_y_6;
            normals_y_2 <= normals_y_4;
            normals_y_0 <= normals_y_2;
            normals_z_6 <= even_is_there ? leaving_even[31:0] : 32'd0;
            normals_z_4 <= normals_z_6;
            normals_z_2 <= normals_z_4;
            normals_z_0 <= normals_z_2;
            weight_7 <= odd_is_there ? leaving_odd[223:192] : 32'd0;
            weight_5 <= weight_7;
            weight_3 <= weight_5;
            weight_1 <= weight_3;
            points_x_7 <= odd_is_there ? leaving_odd[191:160] : 32'd0;
            points_x_5 <= points_x_7;
            points_x_3 <= points_x_5;
            points_x_1 <= points_x_3;
            points_y_7 <= odd_is_there ? leaving_odd[159:128] : 32'd0;
            points_y_5 <= points_y_7;
            points_y_3 <= points_y_5;
            points_y_1 <= points_y_3;
            points_z_7 <= odd_is_there ? leaving_odd[127:96] : 32'd0;
            points_z_5 <= points_z_7;
            points_z_3 <= points_z_5;
            points_z_1 <= points_z_3;
            normals_x_7 <= odd_is_there ? leaving_odd[95:64] : 32'd0;
            normals_x_5 <= normals_x_7;
            normals_x_3 <= normals_x_5;
            normals_x_1 <= normals_x_3;
            normals_y_7 <= odd_is_there ? leaving_odd[63:32] : 32'd0;
            normals_y_5 <= normals_y_7;
            normals_y_3 <= normals_y_5;
            normals_y_1 <= normals_y_3;
            normals_z_7 <= odd_is_there ? leaving_odd[31:0] : 32'd0;
            normals_z_5 <= normals_z_7;
            normals_z_3 <= normals_z_5;
            normals_z_1 <= normals_z_3;
        end
    end
    always @(posedge clk) begin
        if (writes_sum & ~sums_out_partial[0]) begin
            even_sums[even_sums_address_bits] <= even_sums_data_bits;
        end
    end
    always @(posedge clk) begin
        if (writes_sum & sums_out_partial[0]) begin
            odd_sums[even_sums_address_bits] <= even_sums_data_bits;
        end
    end

    wire _unused = &{
        1'b0, complete_shifted_by_leaving[3:1], setting_tolerance, tags_in_ready, tags_out_valid,
        taken_shifted_by_adding[3:1]
    };

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        tags_have_room: assert (~enters | tags_in_ready);
        a_neighbor_has_its_tag: assert (~block_out_valid | tags_out_valid);
`else
        if (!(~enters | tags_in_ready)) begin
            $display("assertion failed: tags_have_room in %m"); $stop;
        end
        if (!(~block_out_valid | tags_out_valid)) begin
            $display("assertion failed: a_neighbor_has_its_tag in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// The block `kernel` of the program `mls`.
// latency = 51
// initiation_interval = 1
module mls_kernel (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [31:0] in_query_position_x,
    input  wire [31:0] in_query_position_y, input wire [31:0] in_query_position_z,
    input  wire [31:0] in_neighbor_position_x, input wire [31:0] in_neighbor_position_y,
    input  wire [31:0] in_neighbor_position_z, input wire [31:0] in_neighbor_normal_x,
    input  wire [31:0] in_neighbor_normal_y, input wire [31:0] in_neighbor_normal_z,
    input  wire [31:0] setting_inverse_radius2,
    output wire out_valid, input wire out_ready, output wire [31:0] out_sum_weight,
    output wire [31:0] out_sum_points_x, output wire [31:0] out_sum_points_y,
    output wire [31:0] out_sum_points_z, output wire [31:0] out_sum_normals_x,
    output wire [31:0] out_sum_normals_y, output wire [31:0] out_sum_normals_z
);
    (* ram_style = "distributed" *)
    reg [31:0] delay_5_from_0 [0:3];
    (* ram_style = "distributed" *)
    reg [31:0] delay_6_from_0 [0:4];
    (* ram_style = "distributed" *)
    reg [31:0] delay_34_from_0 [0:32];
    (* ram_style = "distributed" *)
    reg [63:0] delay_40_from_0 [0:38];
    (* ram_style = "distributed" *)
    reg [95:0] delay_46_from_0 [0:44];
    reg [6:0] credits;
    reg [1:0] delay_5_from_0_pointer;
    reg [31:0] delay_5_from_0_out;
    reg [2:0] delay_6_from_0_pointer;
    reg [31:0] delay_6_from_0_out;
    reg [5:0] delay_34_from_0_pointer;
    reg [31:0] delay_34_from_0_out;
    reg [5:0] delay_40_from_0_pointer;
    reg [63:0] delay_40_from_0_out;
    reg [5:0] delay_46_from_0_pointer;
    reg [95:0] delay_46_from_0_out;
    reg [50:0] in_flight;
    reg left;

    wire [31:0] add_f32_ftz_unit_y, add_f32_ftz_unit_copy2_y, add_f32_ftz_unit_copy3_y, add_f32_ftz_unit_copy4_y;
    wire [31:0] add_f32_ftz_unit_copy5_y, add_f32_ftz_unit_copy6_y, mul_f32_ftz_unit_y, mul_f32_ftz_unit_copy2_y;
    wire [31:0] mul_f32_ftz_unit_copy3_y, mul_f32_ftz_unit_copy4_y, mul_f32_ftz_unit_copy5_y;
    wire [31:0] mul_f32_ftz_unit_copy6_y, mul_f32_ftz_unit_copy7_y, mul_f32_ftz_unit_copy8_y;
    wire [31:0] mul_f32_ftz_unit_copy9_y, mul_f32_ftz_unit_copy10_y, mul_f32_ftz_unit_copy11_y;
    wire [31:0] mul_f32_ftz_unit_copy12_y, max_f32_ftz_unit_y;
    wire queue_1_in_ready;
    wire [127:0] queue_1_out_data;
    wire queue_2_in_ready, queue_2_out_valid;
    wire [95:0] queue_2_out_data;

    assign in_ready = ~credits[6];
    wire [31:0] d_x_d40 = delay_40_from_0_out[31:0];
    wire [31:0] d_y_d40 = delay_40_from_0_out[63:32];
    wire [31:0] neighbor_normal_x_d46 = delay_46_from_0_out[31:0];
    wire [31:0] neighbor_normal_y_d46 = delay_46_from_0_out[63:32];
    wire [31:0] neighbor_normal_z_d46 = delay_46_from_0_out[95:64];
    wire kept = in_flight[50];
    wire in_valid_and_in_ready = in_valid & in_ready;

    assign {out_sum_weight, out_sum_points_x, out_sum_points_y, out_sum_points_z} = queue_1_out_data;
    assign {out_sum_normals_x, out_sum_normals_y, out_sum_normals_z} = queue_2_out_data;

    float_add_s6_f32ftz add_f32_ftz_unit (
        .clk(clk), .enable(1'd1), .a(in_neighbor_position_x),
        .b({~in_query_position_x[31], in_query_position_x[30:0]}), .y(add_f32_ftz_unit_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(in_neighbor_position_y),
        .b({~in_query_position_y[31], in_query_position_y[30:0]}), .y(add_f32_ftz_unit_copy2_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy3 (
        .clk(clk), .enable(1'd1), .a(in_neighbor_position_z),
        .b({~in_query_position_z[31], in_query_position_z[30:0]}), .y(add_f32_ftz_unit_copy3_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy4 (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_y), .b(mul_f32_ftz_unit_copy2_y),
        .y(add_f32_ftz_unit_copy4_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy5 (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_copy3_y), .b(add_f32_ftz_unit_copy4_y),
        .y(add_f32_ftz_unit_copy5_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy6 (
        .clk(clk), .enable(1'd1), .a(32'h3f800000),
        .b({~mul_f32_ftz_unit_copy4_y[31], mul_f32_ftz_unit_copy4_y[30:0]}), .y(add_f32_ftz_unit_copy6_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_y), .b(add_f32_ftz_unit_y), .y(mul_f32_ftz_unit_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy2_y), .b(add_f32_ftz_unit_copy2_y),
        .y(mul_f32_ftz_unit_copy2_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy3 (
        .clk(clk), .enable(1'd1), .a(delay_6_from_0_out), .b(delay_6_from_0_out),
        .y(mul_f32_ftz_unit_copy3_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy4 (
        .clk(clk), .enable(1'd1), .a(setting_inverse_radius2), .b(add_f32_ftz_unit_copy5_y),
        .y(mul_f32_ftz_unit_copy4_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy5 (
        .clk(clk), .enable(1'd1), .a(max_f32_ftz_unit_y), .b(max_f32_ftz_unit_y),
        .y(mul_f32_ftz_unit_copy5_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy6 (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_copy5_y), .b(mul_f32_ftz_unit_copy5_y),
        .y(mul_f32_ftz_unit_copy6_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy7 (
        .clk(clk), .enable(1'd1), .a(d_x_d40), .b(mul_f32_ftz_unit_copy6_y), .y(mul_f32_ftz_unit_copy7_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy8 (
        .clk(clk), .enable(1'd1), .a(d_y_d40), .b(mul_f32_ftz_unit_copy6_y), .y(mul_f32_ftz_unit_copy8_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy9 (
        .clk(clk), .enable(1'd1), .a(delay_34_from_0_out), .b(mul_f32_ftz_unit_copy6_y),
        .y(mul_f32_ftz_unit_copy9_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy10 (
        .clk(clk), .enable(1'd1), .a(neighbor_normal_x_d46), .b(mul_f32_ftz_unit_copy6_y),
        .y(mul_f32_ftz_unit_copy10_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy11 (
        .clk(clk), .enable(1'd1), .a(neighbor_normal_y_d46), .b(mul_f32_ftz_unit_copy6_y),
        .y(mul_f32_ftz_unit_copy11_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy12 (
        .clk(clk), .enable(1'd1), .a(neighbor_normal_z_d46), .b(mul_f32_ftz_unit_copy6_y),
        .y(mul_f32_ftz_unit_copy12_y)
    );

    float_max_s2_f32ftz max_f32_ftz_unit (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy6_y), .b(32'd0), .y(max_f32_ftz_unit_y)
    );

    stream_fifo_d55_w128_distributed queue_1 (
        .clk(clk), .rst(rst), .in_valid(kept), .in_ready(queue_1_in_ready),
        .in_data({delay_5_from_0_out, mul_f32_ftz_unit_copy7_y, mul_f32_ftz_unit_copy8_y, mul_f32_ftz_unit_copy9_y}),
        .out_valid(out_valid), .out_ready(out_ready), .out_data(queue_1_out_data)
    );

    stream_fifo_d55_w96_distributed queue_2 (
        .clk(clk), .rst(rst), .in_valid(kept), .in_ready(queue_2_in_ready),
        .in_data({mul_f32_ftz_unit_copy10_y, mul_f32_ftz_unit_copy11_y, mul_f32_ftz_unit_copy12_y}),
        .out_valid(queue_2_out_valid), .out_ready(out_ready), .out_data(queue_2_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            credits <= 7'd54;
            delay_5_from_0_pointer <= 2'd0;
            delay_6_from_0_pointer <= 3'd0;
            delay_34_from_0_pointer <= 6'd0;
            delay_40_from_0_pointer <= 6'd0;
            delay_46_from_0_pointer <= 6'd0;
            in_flight <= 51'd0;
            left <= 1'd0;
        end else begin
            credits <= (credits - {6'd0, in_valid_and_in_ready}) + {6'd0, left};
            delay_5_from_0_pointer <= (delay_5_from_0_pointer == 2'd3) ? (delay_5_from_0_pointer - 2'd3) : (delay_5_from_0_pointer + 2'd1);
            delay_6_from_0_pointer <= (delay_6_from_0_pointer == 3'd4) ? (delay_6_from_0_pointer - 3'd4) : (delay_6_from_0_pointer + 3'd1);
            delay_34_from_0_pointer <= (delay_34_from_0_pointer == 6'd32) ? (delay_34_from_0_pointer - 6'd32) : (delay_34_from_0_pointer + 6'd1);
            delay_40_from_0_pointer <= (delay_40_from_0_pointer == 6'd38) ? (delay_40_from_0_pointer - 6'd38) : (delay_40_from_0_pointer + 6'd1);
            delay_46_from_0_pointer <= (delay_46_from_0_pointer == 6'd44) ? (delay_46_from_0_pointer - 6'd44) : (delay_46_from_0_pointer + 6'd1);
            in_flight <= {in_flight[49:0], in_valid_and_in_ready};
            left <= out_valid & out_ready;
        end
    end
    always @(posedge clk) begin
        delay_5_from_0[delay_5_from_0_pointer] <= mul_f32_ftz_unit_copy6_y;
        delay_5_from_0_out <= delay_5_from_0[delay_5_from_0_pointer];
    end
    always @(posedge clk) begin
        delay_6_from_0[delay_6_from_0_pointer] <= add_f32_ftz_unit_copy3_y;
        delay_6_from_0_out <= delay_6_from_0[delay_6_from_0_pointer];
    end
    always @(posedge clk) begin
        delay_34_from_0[delay_34_from_0_pointer] <= delay_6_from_0_out;
        delay_34_from_0_out <= delay_34_from_0[delay_34_from_0_pointer];
    end
    always @(posedge clk) begin
        delay_40_from_0[delay_40_from_0_pointer] <= {add_f32_ftz_unit_copy2_y, add_f32_ftz_unit_y};
        delay_40_from_0_out <= delay_40_from_0[delay_40_from_0_pointer];
    end
    always @(posedge clk) begin
        delay_46_from_0[delay_46_from_0_pointer] <= {in_neighbor_normal_z, in_neighbor_normal_y, in_neighbor_normal_x};
        delay_46_from_0_out <= delay_46_from_0[delay_46_from_0_pointer];
    end

    wire _unused = &{1'b0, queue_1_in_ready, queue_2_in_ready, queue_2_out_valid};

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
// depth = 55
// width = 96
// storage = distributed
module stream_fifo_d55_w96_distributed (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [95:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [95:0] out_data
);
    (* ram_style = "distributed" *)
    reg [95:0] entries [0:54];
    reg [5:0] held, waiting;
    reg is_full, any_waits;
    reg [5:0] write_address, read_address;
    reg [95:0] item;

    wire has_room = ~is_full;
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [5:0] held_bits = {{5{~push}}, 1'd1};
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    always @(posedge clk) begin
        if (rst) begin
            held <= 6'd0;
            waiting <= 6'd0;
            is_full <= 1'd0;
            any_waits <= 1'd0;
            write_address <= 6'd0;
            read_address <= 6'd0;
            out_valid <= 1'd0;
        end else begin
            if (push_xor_pop) begin
                held <= held + held_bits;
                is_full <= push & (held == 6'd54);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 6'd1);
            end
            if (push) write_address <= (write_address == 6'd54) ? 6'd0 : (write_address + 6'd1);
            if (fetch) read_address <= (read_address == 6'd54) ? 6'd0 : (read_address + 6'd1);
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
        held_in_range: assert (held <= 6'd55);
        held_is_waiting_and_shown: assert (held == (waiting + {5'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 6'd55)) & (any_waits == |waiting));
`else
        if (!(held <= 6'd55)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {5'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 6'd55)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue in a memory with a registered output.
// depth = 55
// width = 128
// storage = distributed
module stream_fifo_d55_w128_distributed (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [127:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [127:0] out_data
);
    (* ram_style = "distributed" *)
    reg [127:0] entries [0:54];
    reg [5:0] held, waiting;
    reg is_full, any_waits;
    reg [5:0] write_address, read_address;
    reg [127:0] item;

    wire has_room = ~is_full;
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [5:0] held_bits = {{5{~push}}, 1'd1};
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    always @(posedge clk) begin
        if (rst) begin
            held <= 6'd0;
            waiting <= 6'd0;
            is_full <= 1'd0;
            any_waits <= 1'd0;
            write_address <= 6'd0;
            read_address <= 6'd0;
            out_valid <= 1'd0;
        end else begin
            if (push_xor_pop) begin
                held <= held + held_bits;
                is_full <= push & (held == 6'd54);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 6'd1);
            end
            if (push) write_address <= (write_address == 6'd54) ? 6'd0 : (write_address + 6'd1);
            if (fetch) read_address <= (read_address == 6'd54) ? 6'd0 : (read_address + 6'd1);
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
        held_in_range: assert (held <= 6'd55);
        held_is_waiting_and_shown: assert (held == (waiting + {5'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 6'd55)) & (any_waits == |waiting));
`else
        if (!(held <= 6'd55)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {5'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 6'd55)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Greater of two floating-point numbers.
// stages = 2
// format = f32-ftz
module float_max_s2_f32ftz (
    input  wire clk, input wire enable, input wire [31:0] a, input wire [31:0] b,
    output reg  [31:0] y
);
    reg a_nan_s1, b_nan_s1, less_s1;
    reg [31:0] a_s1, b_s1;

    always @(posedge clk) begin
        if (enable) begin
            a_nan_s1 <= &a[30:23] & |a[22:0];
            b_nan_s1 <= &b[30:23] & |b[22:0];
            less_s1 <= {~a[31], a[30:0] ^ {31{a[31]}}} < {~b[31], b[30:0] ^ {31{b[31]}}};
            a_s1 <= {a[31:23], a[22:0] & {23{|a[30:23]}}};
            b_s1 <= {b[31:23], b[22:0] & {23{|b[30:23]}}};
            y <= (a_nan_s1 & b_nan_s1) ? 32'h7fc00000 : (b_nan_s1 | (~a_nan_s1 & ~less_s1)) ? a_s1 : b_s1;
        end
    end
endmodule

// Queue in a memory with a registered output.
// depth = 55
// width = 9
// storage = distributed
module stream_fifo_d55_w9_distributed (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [8:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [8:0] out_data
);
    (* ram_style = "distributed" *)
    reg [8:0] entries [0:54];
    reg [5:0] held, waiting;
    reg is_full, any_waits;
    reg [5:0] write_address, read_address;
    reg [8:0] item;

    wire has_room = ~is_full;
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [5:0] held_bits = {{5{~push}}, 1'd1};
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    always @(posedge clk) begin
        if (rst) begin
            held <= 6'd0;
            waiting <= 6'd0;
            is_full <= 1'd0;
            any_waits <= 1'd0;
            write_address <= 6'd0;
            read_address <= 6'd0;
            out_valid <= 1'd0;
        end else begin
            if (push_xor_pop) begin
                held <= held + held_bits;
                is_full <= push & (held == 6'd54);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 6'd1);
            end
            if (push) write_address <= (write_address == 6'd54) ? 6'd0 : (write_address + 6'd1);
            if (fetch) read_address <= (read_address == 6'd54) ? 6'd0 : (read_address + 6'd1);
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
        held_in_range: assert (held <= 6'd55);
        held_is_waiting_and_shown: assert (held == (waiting + {5'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 6'd55)) & (any_waits == |waiting));
`else
        if (!(held <= 6'd55)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {5'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 6'd55)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Adds to partial sums.
// latency = 6
// initiation_interval = 1
module process_sums (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [1:0] in_bank, input wire [2:0] in_partial,
    input  wire in_none, input wire in_last, input wire [31:0] in_before_weight,
    input  wire [31:0] in_before_points_x, input wire [31:0] in_before_points_y,
    input  wire [31:0] in_before_points_z, input wire [31:0] in_before_normals_x,
    input  wire [31:0] in_before_normals_y, input wire [31:0] in_before_normals_z,
    input  wire [31:0] in_sum_weight, input wire [31:0] in_sum_points_x,
    input  wire [31:0] in_sum_points_y, input wire [31:0] in_sum_points_z,
    input  wire [31:0] in_sum_normals_x, input wire [31:0] in_sum_normals_y,
    input  wire [31:0] in_sum_normals_z,
    output wire out_valid, input wire out_ready, output wire [1:0] out_bank,
    output wire [2:0] out_partial, output wire out_none, output wire out_last,
    output wire [31:0] out_weight, output wire [31:0] out_points_x, output wire [31:0] out_points_y,
    output wire [31:0] out_points_z, output wire [31:0] out_normals_x, output wire [31:0] out_normals_y,
    output wire [31:0] out_normals_z
);
    (* ram_style = "distributed" *)
    reg [6:0] delay_6_from_0 [0:4];
    reg [2:0] delay_6_from_0_pointer;
    reg [6:0] delay_6_from_0_out;
    reg [5:0] in_flight;
    reg shown;
    reg [1:0] shown_bank;
    reg [2:0] shown_partial;
    reg shown_none, shown_last;
    reg [31:0] shown_weight, shown_points_x, shown_points_y, shown_points_z, shown_normals_x, shown_normals_y;
    reg [31:0] shown_normals_z;

    wire [31:0] add_f32_ftz_unit_y, add_f32_ftz_unit_copy2_y, add_f32_ftz_unit_copy3_y, add_f32_ftz_unit_copy4_y;
    wire [31:0] add_f32_ftz_unit_copy5_y, add_f32_ftz_unit_copy6_y, add_f32_ftz_unit_copy7_y;

    wire kept = in_flight[5];
    wire [1:0] bank_d6 = delay_6_from_0_out[1:0];
    wire [2:0] partial_d6 = delay_6_from_0_out[4:2];
    wire none_d6 = delay_6_from_0_out[5];
    wire last_d6 = delay_6_from_0_out[6];

    assign in_ready = 1'd1;
    assign out_valid = shown;
    assign out_bank = shown_bank;
    assign out_partial = shown_partial;
    assign out_none = shown_none;
    assign out_last = shown_last;
    assign out_weight = shown_weight;
    assign out_points_x = shown_points_x;
    assign out_points_y = shown_points_y;
    assign out_points_z = shown_points_z;
    assign out_normals_x = shown_normals_x;
    assign out_normals_y = shown_normals_y;
    assign out_normals_z = shown_normals_z;

    float_add_s6_f32ftz add_f32_ftz_unit (
        .clk(clk), .enable(1'd1), .a(in_before_weight), .b(in_sum_weight), .y(add_f32_ftz_unit_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(in_before_points_x), .b(in_sum_points_x), .y(add_f32_ftz_unit_copy2_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy3 (
        .clk(clk), .enable(1'd1), .a(in_before_points_y), .b(in_sum_points_y), .y(add_f32_ftz_unit_copy3_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy4 (
        .clk(clk), .enable(1'd1), .a(in_before_points_z), .b(in_sum_points_z), .y(add_f32_ftz_unit_copy4_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy5 (
        .clk(clk), .enable(1'd1), .a(in_before_normals_x), .b(in_sum_normals_x), .y(add_f32_ftz_unit_copy5_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy6 (
        .clk(clk), .enable(1'd1), .a(in_before_normals_y), .b(in_sum_normals_y), .y(add_f32_ftz_unit_copy6_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy7 (
        .clk(clk), .enable(1'd1), .a(in_before_normals_z), .b(in_sum_normals_z), .y(add_f32_ftz_unit_copy7_y)
    );

    always @(posedge clk) begin
        if (rst) begin
            delay_6_from_0_pointer <= 3'd0;
            in_flight <= 6'd0;
            shown <= 1'd0;
        end else begin
            delay_6_from_0_pointer <= (delay_6_from_0_pointer == 3'd4) ? (delay_6_from_0_pointer - 3'd4) : (delay_6_from_0_pointer + 3'd1);
            in_flight <= {in_flight[4:0], in_valid};
            shown <= kept;
        end
    end
    always @(posedge clk) begin
        shown_bank <= bank_d6;
        shown_partial <= partial_d6;
        shown_none <= none_d6;
        shown_last <= last_d6;
        shown_weight <= add_f32_ftz_unit_y;
        shown_points_x <= add_f32_ftz_unit_copy2_y;
        shown_points_y <= add_f32_ftz_unit_copy3_y;
        shown_points_z <= add_f32_ftz_unit_copy4_y;
        shown_normals_x <= add_f32_ftz_unit_copy5_y;
        shown_normals_y <= add_f32_ftz_unit_copy6_y;
        shown_normals_z <= add_f32_ftz_unit_copy7_y;
    end
    always @(posedge clk) begin
        delay_6_from_0[delay_6_from_0_pointer] <= {in_last, in_none, in_partial, in_bank};
        delay_6_from_0_out <= delay_6_from_0[delay_6_from_0_pointer];
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

// Makes points with attributes of indices.
// lines = 256
// line_points = 4
module process_gather (
    input  wire clk, input wire rst,
    input  wire forget,  // Nothing that is kept counts any more: the points have changed. Not while a neighbor is wanted.
    input  wire gather_valid, output wire gather_ready,  // Neighbors wanted.
    input  wire [6:0] gather_thread,  // Thread.
    input  wire gather_farthest,  // It is the farthest, for `init`; else one of those that `kernel` goes through.
    input  wire gather_none,  // There is none: the query has no neighbors.
    input  wire gather_last,  // The last one of its query that `kernel` goes through.
    input  wire [23:0] gather_index,  // Its index, where there is one.
    output wire fetch_valid, input wire fetch_ready,  // Requests to the memory.
    output wire [21:0] fetch_line,  // The line: the points from `line_points · line` on.
    output wire gathered_valid, input wire gathered_ready,  // Neighbors in the order in which they were wanted.
    output wire [6:0] gathered_thread,  // Thread.
    output wire gathered_farthest,  // It is the farthest, for `init`; else one of those that `kernel` goes through.
    output wire gathered_none,  // There is none: the query has no neighbors.
    output wire gathered_last,  // The last one of its query that `kernel` goes through.
    output wire [31:0] gathered_position_x,  // Words of the neighbor.
    output wire [31:0] gathered_position_y,  // Words of the neighbor.
    output wire [31:0] gathered_position_z,  // Words of the neighbor.
    output wire [31:0] gathered_normal_x,  // Words of the neighbor.
    output wire [31:0] gathered_normal_y,  // Words of the neighbor.
    output wire [31:0] gathered_normal_z,  // Words of the neighbor.
    output reg  event_line_hit,  // A line that was wanted was there.
    output reg  event_line_miss,  // A line that was wanted was not there.
    input  wire fill_valid, output wire fill_ready,  // The points of the lines from memory, in the order of the requests.
    input  wire [31:0] fill_position_x,  // Words of the neighbor.
    input  wire [31:0] fill_position_y,  // Words of the neighbor.
    input  wire [31:0] fill_position_z,  // Words of the neighbor.
    input  wire [31:0] fill_normal_x,  // Words of the neighbor.
    input  wire [31:0] fill_normal_y,  // Words of the neighbor.
    input  wire [31:0] fill_normal_z  // Words of the neighbor.
);
    reg clearing;
    reg [7:0] cleared;
    reg l_valid, k_valid;
    reg [6:0] l_thread;  // Thread.
    reg l_farthest;  // It is the farthest, for `init`; else one of those that `kernel` goes through.
    reg l_none;  // There is none: the query has no neighbors.
    reg l_last;  // The last one of its query that `kernel` goes through.
    reg [23:0] l_index;  // Its index, where there is one.
    wire [22:0] slot_read;
    reg [6:0] k_thread;  // Thread.
    reg k_farthest;  // It is the farthest, for `init`; else one of those that `kernel` goes through.
    reg k_none;  // There is none: the query has no neighbors.
    reg k_last;  // The last one of its query that `kernel` goes through.
    reg [23:0] k_index;  // Its index, where there is one.
    reg [7:0] wanted, read_count;
    reg same_slot;
    reg before_used;  // It has a line, or will have.
    reg [13:0] before_tag;  // Which one.
    reg [7:0] before_wanted;  // How many neighbors had been wanted when one of it was, that one included.
    reg known_used;  // It has a line, or will have.
    reg [13:0] known_tag;  // Which one.
    reg [7:0] known_wanted;  // How many neighbors had been wanted when one of it was, that one included.
    reg filling;
    reg [1:0] fill_count;
    reg [7:0] filled_slot;
    reg [4:0] complete;
    reg r_valid, s_valid;
    wire [191:0] read;
    reg [6:0] r_thread;  // Thread.
    reg r_farthest;  // It is the farthest, for `init`; else one of those that `kernel` goes through.
    reg r_none;  // There is none: the query has no neighbors.
    reg r_last;  // The last one of its query that `kernel` goes through.
    reg [6:0] s_thread;  // Thread.
    reg s_farthest;  // It is the farthest, for `init`; else one of those that `kernel` goes through.
    reg s_none;  // There is none: the query has no neighbors.
    reg s_last;  // The last one of its query that `kernel` goes through.
    reg [31:0] s_position_x;  // Words of the neighbor.
    reg [31:0] s_position_y;  // Words of the neighbor.
    reg [31:0] s_position_z;  // Words of the neighbor.
    reg [31:0] s_normal_x;  // Words of the neighbor.
    reg [31:0] s_normal_y;  // Words of the neighbor.
    reg [31:0] s_normal_z;  // Words of the neighbor.

    wire gather_queue_out_valid;
    wire [33:0] gather_queue_out_data;
    wire pending_in_ready, pending_out_valid;
    wire [20:0] pending_out_data;
    wire missed_in_ready, missed_out_valid;
    wire [15:0] missed_out_data;
    wire fetch_queue_in_ready, gathered_queue_in_ready;
    wire [201:0] gathered_queue_out_data;
    wire fill_queue_out_valid;
    wire [191:0] fill_queue_out_data;

    wire hit = k_none | (known_used & (known_tag == k_index[23:10]));
    wire can_ask = fetch_queue_in_ready & missed_in_ready;
    wire k_leaves = k_valid & (pending_in_ready & (hit | can_ask));
    wire writes_slot = k_leaves & ~k_none;
    wire [7:0] count = wanted + 8'd1;
    wire k_advance = ~k_valid | k_leaves;
    wire l_advance = ~l_valid | k_advance;
    wire [23:0] gather_queue_out_index = gather_queue_out_data[23:0];
    wire fill_taken = fill_queue_out_valid & filling;
    wire pending_out_missed = pending_out_data[0];
    wire is_there = pending_out_valid & (~pending_out_missed | |complete);
    wire s_advance = ~s_valid | gathered_queue_in_ready;
    wire r_advance = ~r_valid | s_advance;
    wire takes = is_there & r_advance;
    wire [9:0] pending_out_point = pending_out_data[10:1];
    wire gather_queue_out_ready = l_advance & ~clearing;
    wire misses = k_leaves & ~hit;
    wire [7:0] wanted_since = wanted - known_wanted;
    wire [7:0] under_way = wanted - read_count;
    wire waits = known_used & (wanted_since < under_way);
    wire line_ends = fill_taken & &fill_count;
    wire takes_line = ~filling | line_ends;
    wire [7:0] missed_out_after = missed_out_data[7:0];
    wire [7:0] read_since = read_count - missed_out_after;
    wire may_be_kept = missed_out_valid & ~read_since[7];
    wire missed_out_ready = takes_line & may_be_kept;
    wire clears_last = cleared == 8'd255;
    wire [6:0] gather_queue_out_thread = gather_queue_out_data[33:27];
    wire gather_queue_out_farthest = gather_queue_out_data[26];
    wire gather_queue_out_none = gather_queue_out_data[25];
    wire gather_queue_out_last = gather_queue_out_data[24];
    wire slot_changes = writes_slot & (l_index[9:2] == k_index[9:2]);
    wire hits = k_leaves & (hit & ~k_none);
    wire [7:0] missed_out_slot = missed_out_data[15:8];
    wire uses_line = takes & pending_out_missed;
    wire [6:0] pending_out_thread = pending_out_data[20:14];
    wire pending_out_farthest = pending_out_data[13];
    wire pending_out_none = pending_out_data[12];
    wire pending_out_last = pending_out_data[11];

    assign {
        gathered_thread, gathered_farthest, gathered_none, gathered_last, gathered_position_x,
        gathered_position_y, gathered_position_z, gathered_normal_x, gathered_normal_y, gathered_normal_z
    } = gathered_queue_out_data;

    memory_1w1r_unordered #(.WIDTH(23), .DEPTH(256)) slots (
        .clk(clk), .write(writes_slot | clearing), .write_address(clearing ? cleared : k_index[9:2]),
        .write_data({~clearing, clearing ? 14'd0 : k_index[23:10], clearing ? 8'd0 : count}),
        .read(l_advance), .read_address(gather_queue_out_index[9:2]), .read_data(slot_read)
    );

    memory_1w1r_unordered #(.WIDTH(192), .DEPTH(1024)) points (
        .clk(clk), .write(fill_taken), .write_address({filled_slot, fill_count}),
        .write_data(fill_queue_out_data),
        .read(takes), .read_address(pending_out_point), .read_data(read)
    );

    stream_skid_w34 gather_queue (
        .clk(clk), .rst(rst), .in_valid(gather_valid), .in_ready(gather_ready),
        .in_data({gather_thread, gather_farthest, gather_none, gather_last, gather_index}),
        .out_valid(gather_queue_out_valid), .out_ready(gather_queue_out_ready),
        .out_data(gather_queue_out_data)
    );

    stream_fifo_d64_w21_distributed pending (
        .clk(clk), .rst(rst), .in_valid(k_leaves), .in_ready(pending_in_ready),
        .in_data({k_thread, k_farthest, k_none, k_last, k_index[9:0], ~hit}),
        .out_valid(pending_out_valid), .out_ready(takes), .out_data(pending_out_data)
    );

    stream_fifo_d16_w16_distributed missed (
        .clk(clk), .rst(rst), .in_valid(misses), .in_ready(missed_in_ready),
        .in_data({k_index[9:2], waits ? known_wanted : read_count}),
        .out_valid(missed_out_valid), .out_ready(missed_out_ready), .out_data(missed_out_data)
    );

    stream_skid_w22 fetch_queue (
        .clk(clk), .rst(rst), .in_valid(misses), .in_ready(fetch_queue_in_ready), .in_data(k_index[23:2]),
        .out_valid(fetch_valid), .out_ready(fetch_ready), .out_data(fetch_line)
    );

    stream_skid_w202 gathered_queue (
        .clk(clk), .rst(rst), .in_valid(s_valid & gathered_queue_in_ready),
        .in_ready(gathered_queue_in_ready),
        .in_data({
            s_thread, s_farthest, s_none, s_last, s_position_x, s_position_y, s_position_z, s_normal_x,
            s_normal_y, s_normal_z
        }),
        .out_valid(gathered_valid), .out_ready(gathered_ready), .out_data(gathered_queue_out_data)
    );

    stream_skid_w192 fill_queue (
        .clk(clk), .rst(rst), .in_valid(fill_valid), .in_ready(fill_ready),
        .in_data({fill_position_x, fill_position_y, fill_position_z, fill_normal_x, fill_normal_y, fill_normal_z}),
        .out_valid(fill_queue_out_valid), .out_ready(filling), .out_data(fill_queue_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            clearing <= 1'd1;
            cleared <= 8'd0;
            l_valid <= 1'd0;
            k_valid <= 1'd0;
            wanted <= 8'd0;
            read_count <= 8'd0;
            same_slot <= 1'd0;
            event_line_hit <= 1'd0;
            event_line_miss <= 1'd0;
            filling <= 1'd0;
            fill_count <= 2'd0;
            complete <= 5'd0;
            r_valid <= 1'd0;
            s_valid <= 1'd0;
        end else begin
            clearing <= forget | (clearing & ~clears_last);
            cleared <= (forget | ~clearing) ? 8'd0 : (cleared + 8'd1);
            event_line_hit <= hits;
            event_line_miss <= misses;
            complete <= (complete + {4'd0, line_ends}) - {4'd0, uses_line};
            if (l_advance) begin
                l_valid <= gather_queue_out_valid & ~clearing;
                same_slot <= writes_slot & (gather_queue_out_index[9:2] == k_index[9:2]);
            end
            if (k_advance) k_valid <= l_valid;
            if (k_leaves) wanted <= count;
            if (takes) read_count <= read_count + 8'd1;
            if (takes_line) filling <= may_be_kept;
            if (fill_taken) fill_count <= fill_count + 2'd1;
            if (r_advance) r_valid <= is_there;
            if (s_advance) s_valid <= r_valid;
        end
    end
    always @(posedge clk) begin
        if (l_advance) begin
            l_thread <= gather_queue_out_thread;
            l_farthest <= gather_queue_out_farthest;
            l_none <= gather_queue_out_none;
            l_last <= gather_queue_out_last;
            l_index <= gather_queue_out_index;
        end
        if (k_advance) begin
            k_thread <= l_thread;
            k_farthest <= l_farthest;
            k_none <= l_none;
            k_last <= l_last;
            k_index <= l_index;
            known_used <= slot_changes ? 1'd1 : same_slot ? before_used : slot_read[22];
            known_tag <= slot_changes ? k_index[23:10] : same_slot ? before_tag : slot_read[21:8];
            known_wanted <= slot_changes ? count : same_slot ? before_wanted : slot_read[7:0];
        end
        if (writes_slot) begin
            before_used <= 1'd1;
            before_tag <= k_index[23:10];
            before_wanted <= count;
        end
        if (takes_line) filled_slot <= missed_out_slot;
        if (takes) begin
            r_thread <= pending_out_thread;
            r_farthest <= pending_out_farthest;
            r_none <= pending_out_none;
            r_last <= pending_out_last;
        end
        if (s_advance) begin
            s_thread <= r_thread;
            s_farthest <= r_farthest;
            s_none <= r_none;
            s_last <= r_last;
            s_position_x <= r_none ? 32'd0 : read[191:160];
            s_position_y <= r_none ? 32'd0 : read[159:128];
            s_position_z <= r_none ? 32'd0 : read[127:96];
            s_normal_x <= r_none ? 32'd0 : read[95:64];
            s_normal_y <= r_none ? 32'd0 : read[63:32];
            s_normal_z <= r_none ? 32'd0 : read[31:0];
        end
    end

    wire _unused = &{1'b0, read_since[6:0]};

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        nothing_is_forgotten_while_it_is_wanted: assert (~forget | ~(l_valid | k_valid | (gather_queue_out_valid | |under_way)));
`else
        if (!(~forget | ~(l_valid | k_valid | (gather_queue_out_valid | |under_way)))) begin
            $display("assertion failed: nothing_is_forgotten_while_it_is_wanted in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue of two in registers.
// width = 192
module stream_skid_w192 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [191:0] in_data,
    output wire out_valid, input wire out_ready, output wire [191:0] out_data
);
    reg head_filled, second_filled, room;
    reg [191:0] head, second;

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
// width = 202
module stream_skid_w202 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [201:0] in_data,
    output wire out_valid, input wire out_ready, output wire [201:0] out_data
);
    reg head_filled, second_filled, room;
    reg [201:0] head, second;

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

// Queue in a memory with a registered output.
// depth = 16
// width = 16
// storage = distributed
module stream_fifo_d16_w16_distributed (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [15:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [15:0] out_data
);
    (* ram_style = "distributed" *)
    reg [15:0] entries [0:15];
    reg [4:0] held, waiting;
    reg is_full, any_waits;
    reg [3:0] write_address, read_address;
    reg [15:0] item;

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
    always @(posedge clk) begin
        if (has_room) entries[write_address] <= in_data;
        if (fetch) item <= entries[read_address];
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

// Queue in a memory with a registered output.
// depth = 64
// width = 21
// storage = distributed
module stream_fifo_d64_w21_distributed (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [20:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [20:0] out_data
);
    (* ram_style = "distributed" *)
    reg [20:0] entries [0:63];
    reg [6:0] held, waiting;
    reg is_full, any_waits;
    reg [5:0] write_address, read_address;
    reg [20:0] item;

    wire has_room = ~is_full;
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [6:0] held_bits = {{6{~push}}, 1'd1};
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    always @(posedge clk) begin
        if (rst) begin
            held <= 7'd0;
            waiting <= 7'd0;
            is_full <= 1'd0;
            any_waits <= 1'd0;
            write_address <= 6'd0;
            read_address <= 6'd0;
            out_valid <= 1'd0;
        end else begin
            if (push_xor_pop) begin
                held <= held + held_bits;
                is_full <= push & (held == 7'd63);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 7'd1);
            end
            if (push) write_address <= write_address + 6'd1;
            if (fetch) read_address <= read_address + 6'd1;
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
        held_in_range: assert (held <= 7'd64);
        held_is_waiting_and_shown: assert (held == (waiting + {6'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 7'd64)) & (any_waits == |waiting));
`else
        if (!(held <= 7'd64)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {6'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 7'd64)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queries and their threads, between searching, gathering and kernel.
module process_threads (
    input  wire clk, input wire rst,
    input  wire [31:0] setting_inverse_radius2,  // Words of the settings.
    input  wire [31:0] setting_tolerance,  // Words of the settings.
    input  wire [15:0] iterations_max,  // Iterations that a query has at most, at least one.
    input  wire query_valid, output wire query_ready,  // Queries.
    input  wire [23:0] query_number,  // Its number, which its result bears.
    input  wire [31:0] query_query_position_x,  // Words of the query, its position first.
    input  wire [31:0] query_query_position_y,  // Words of the query, its position first.
    input  wire [31:0] query_query_position_z,  // Words of the query, its position first.
    output wire wanted_valid, input wire wanted_ready,  // Searches.
    output wire [6:0] wanted_thread,  // Thread.
    output wire [31:0] wanted_query_position_x,  // Where.
    output wire [31:0] wanted_query_position_y,  // Where.
    output wire [31:0] wanted_query_position_z,  // Where.
    input  wire found_valid, output wire found_ready,  // Neighbors found.
    input  wire [6:0] found_thread,  // Thread.
    input  wire found_last,  // Closes the search.
    input  wire found_found,  // There is a neighbor.
    input  wire [23:0] found_index,  // The neighbor.
    output wire gather_valid, input wire gather_ready,  // Neighbors wanted.
    output wire [6:0] gather_thread,  // Thread.
    output wire gather_farthest,  // It is the farthest, for `init`; else one of those that `kernel` goes through.
    output wire gather_none,  // There is none: the query has no neighbors.
    output wire gather_last,  // The last one of its query that `kernel` goes through.
    output wire [23:0] gather_index,  // Its index, where there is one.
    input  wire gathered_valid, output wire gathered_ready,  // Neighbors in the order in which they were wanted.
    input  wire [6:0] gathered_thread,  // Thread.
    input  wire gathered_farthest,  // It is the farthest, for `init`; else one of those that `kernel` goes through.
    input  wire gathered_none,  // There is none: the query has no neighbors.
    input  wire gathered_last,  // The last one of its query that `kernel` goes through.
    input  wire [31:0] gathered_position_x,  // Words of the neighbor.
    input  wire [31:0] gathered_position_y,  // Words of the neighbor.
    input  wire [31:0] gathered_position_z,  // Words of the neighbor.
    input  wire [31:0] gathered_normal_x,  // Words of the neighbor.
    input  wire [31:0] gathered_normal_y,  // Words of the neighbor.
    input  wire [31:0] gathered_normal_z,  // Words of the neighbor.
    output wire kernel_valid, input wire kernel_ready,  // What `kernel` takes.
    output wire [6:0] kernel_thread,  // Thread.
    output wire kernel_none,  // There is no neighbor: the query has none.
    output wire kernel_last,  // The query's last neighbor.
    output wire [31:0] kernel_query_position_x,  // Words that `kernel` reads besides settings.
    output wire [31:0] kernel_query_position_y,  // Words that `kernel` reads besides settings.
    output wire [31:0] kernel_query_position_z,  // Words that `kernel` reads besides settings.
    output wire [31:0] kernel_neighbor_position_x,  // Words that `kernel` reads besides settings.
    output wire [31:0] kernel_neighbor_position_y,  // Words that `kernel` reads besides settings.
    output wire [31:0] kernel_neighbor_position_z,  // Words that `kernel` reads besides settings.
    output wire [31:0] kernel_neighbor_normal_x,  // Words that `kernel` reads besides settings.
    output wire [31:0] kernel_neighbor_normal_y,  // Words that `kernel` reads besides settings.
    output wire [31:0] kernel_neighbor_normal_z,  // Words that `kernel` reads besides settings.
    input  wire sums_valid, output wire sums_ready,  // What comes of it.
    input  wire [6:0] sums_thread,  // Thread.
    input  wire [31:0] sums_weight_0,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_weight_1,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_weight_2,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_weight_3,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_weight_4,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_weight_5,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_weight_6,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_weight_7,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_x_0,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_x_1,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_x_2,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_x_3,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_x_4,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_x_5,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_x_6,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_x_7,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_y_0,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_y_1,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_y_2,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_y_3,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_y_4,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_y_5,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_y_6,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_y_7,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_z_0,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_z_1,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_z_2,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_z_3,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_z_4,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_z_5,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_z_6,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_z_7,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_x_0,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_x_1,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_x_2,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_x_3,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_x_4,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_x_5,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_x_6,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_x_7,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_y_0,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_y_1,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_y_2,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_y_3,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_y_4,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_y_5,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_y_6,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_y_7,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_z_0,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_z_1,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_z_2,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_z_3,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_z_4,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_z_5,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_z_6,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_z_7,  // Of each word of the sums its partial sums.
    output wire result_valid, input wire result_ready,  // Queries that leave, in any order.
    output wire [23:0] result_number,  // Its number.
    output wire [15:0] result_iterations,  // Iterations that it took.
    output wire result_capped,  // It was not done, but had no iteration left.
    output wire [31:0] result_output_position_x,  // Words of the outputs.
    output wire [31:0] result_output_position_y,  // Words of the outputs.
    output wire [31:0] result_output_position_z,  // Words of the outputs.
    output wire [31:0] result_output_normal_x,  // Words of the outputs.
    output wire [31:0] result_output_normal_y,  // Words of the outputs.
    output wire [31:0] result_output_normal_z,  // Words of the outputs.
    output wire [31:0] result_output_residual,  // Words of the outputs.
    output wire result_output_valid,  // Words of the outputs.
    output wire idle,  // Nothing is under way.
    output wire event_query_wait,  // A query waits for a thread.
    output wire event_again  // A query is not done.
);
    wire init_in_ready, init_out_valid;
    wire [6:0] init_out_thread;
    wire [31:0] init_out_state_start_x, init_out_state_start_y, init_out_state_start_z;
    wire init_out_write_start, control_start_valid;
    wire [6:0] control_start_thread;
    wire [23:0] control_start_number;
    wire [31:0] control_start_query_position_x, control_start_query_position_y, control_start_query_position_z;
    wire control_idle, control_want_valid;
    wire [6:0] control_want_thread;
    wire control_listed_valid;
    wire [6:0] control_listed_thread;
    wire [5:0] control_listed_neighbors;
    wire control_prepare_valid;
    wire [6:0] control_prepare_thread;
    wire bank_update_ready;
    wire [6:0] bank_again_thread;
    wire bank_again_search, bank_stores_ready, bank_prepared_valid;
    wire [6:0] bank_prepared_thread;
    wire bank_want_ready, bank_init_valid;
    wire [6:0] bank_init_thread;
    wire [31:0] bank_init_query_position_x, bank_init_query_position_y, bank_init_query_position_z, bank_init_count;
    wire bank_prepare_ready, bank_finish_valid;
    wire [6:0] bank_finish_thread;
    wire [31:0] bank_finish_query_position_x, bank_finish_query_position_y, bank_finish_query_position_z;
    wire [31:0] bank_finish_state_start_x, bank_finish_state_start_y, bank_finish_state_start_z;
    wire [31:0] bank_finish_sum_weight_0, bank_finish_sum_weight_1, bank_finish_sum_weight_2;
    wire [31:0] bank_finish_sum_weight_3, bank_finish_sum_weight_4, bank_finish_sum_weight_5;
    wire [31:0] bank_finish_sum_weight_6, bank_finish_sum_weight_7, bank_finish_sum_points_x_0;
    wire [31:0] bank_finish_sum_points_x_1, bank_finish_sum_points_x_2, bank_finish_sum_points_x_3;
    wire [31:0] bank_finish_sum_points_x_4, bank_finish_sum_points_x_5, bank_finish_sum_points_x_6;
    wire [31:0] bank_finish_sum_points_x_7, bank_finish_sum_points_y_0, bank_finish_sum_points_y_1;
    wire [31:0] bank_finish_sum_points_y_2, bank_finish_sum_points_y_3, bank_finish_sum_points_y_4;
    wire [31:0] bank_finish_sum_points_y_5, bank_finish_sum_points_y_6, bank_finish_sum_points_y_7;
    wire [31:0] bank_finish_sum_points_z_0, bank_finish_sum_points_z_1, bank_finish_sum_points_z_2;
    wire [31:0] bank_finish_sum_points_z_3, bank_finish_sum_points_z_4, bank_finish_sum_points_z_5;
    wire [31:0] bank_finish_sum_points_z_6, bank_finish_sum_points_z_7, bank_finish_sum_normals_x_0;
    wire [31:0] bank_finish_sum_normals_x_1, bank_finish_sum_normals_x_2, bank_finish_sum_normals_x_3;
    wire [31:0] bank_finish_sum_normals_x_4, bank_finish_sum_normals_x_5, bank_finish_sum_normals_x_6;
    wire [31:0] bank_finish_sum_normals_x_7, bank_finish_sum_normals_y_0, bank_finish_sum_normals_y_1;
    wire [31:0] bank_finish_sum_normals_y_2, bank_finish_sum_normals_y_3, bank_finish_sum_normals_y_4;
    wire [31:0] bank_finish_sum_normals_y_5, bank_finish_sum_normals_y_6, bank_finish_sum_normals_y_7;
    wire [31:0] bank_finish_sum_normals_z_0, bank_finish_sum_normals_z_1, bank_finish_sum_normals_z_2;
    wire [31:0] bank_finish_sum_normals_z_3, bank_finish_sum_normals_z_4, bank_finish_sum_normals_z_5;
    wire [31:0] bank_finish_sum_normals_z_6, bank_finish_sum_normals_z_7;
    wire finish_in_ready, finish_out_valid;
    wire [6:0] finish_out_thread;
    wire [31:0] finish_out_output_position_x, finish_out_output_position_y, finish_out_output_position_z;
    wire [31:0] finish_out_output_normal_x, finish_out_output_normal_y, finish_out_output_normal_z;
    wire [31:0] finish_out_output_residual;
    wire finish_out_output_valid;
    wire [31:0] finish_out_moved_position_x, finish_out_moved_position_y, finish_out_moved_position_z;
    wire finish_out_move, finish_out_done, finish_out_search, results_finished_ready, results_update_valid;
    wire [6:0] results_update_thread;
    wire results_update_search;
    wire [31:0] results_update_moved_position_x, results_update_moved_position_y, results_update_moved_position_z;
    wire results_update_move;
    wire [15:0] results_update_count;
    wire results_released_valid;
    wire [6:0] results_released_thread;

    assign idle = control_idle & ~result_valid;

    process_init init (
        .clk(clk), .rst(rst), .in_valid(bank_init_valid), .in_ready(init_in_ready),
        .in_thread(bank_init_thread), .in_query_position_x(bank_init_query_position_x),
        .in_query_position_y(bank_init_query_position_y), .in_query_position_z(bank_init_query_position_z),
        .in_count(bank_init_count),
        .out_valid(init_out_valid), .out_ready(bank_stores_ready), .out_thread(init_out_thread),
        .out_state_start_x(init_out_state_start_x), .out_state_start_y(init_out_state_start_y),
        .out_state_start_z(init_out_state_start_z), .out_write_start(init_out_write_start)
    );

    process_control control (
        .clk(clk), .rst(rst), .again_valid(event_again), .again_thread(bank_again_thread),
        .again_search(bank_again_search),
        .query_valid(query_valid), .query_ready(query_ready), .query_number(query_number),
        .query_query_position_x(query_query_position_x), .query_query_position_y(query_query_position_y),
        .query_query_position_z(query_query_position_z),
        .released_valid(results_released_valid), .released_thread(results_released_thread),
        .start_valid(control_start_valid), .start_thread(control_start_thread),
        .start_number(control_start_number), .start_query_position_x(control_start_query_position_x),
        .start_query_position_y(control_start_query_position_y),
        .start_query_position_z(control_start_query_position_z),
        .event_query_wait(event_query_wait),
        .idle(control_idle), .want_valid(control_want_valid), .want_ready(bank_want_ready),
        .want_thread(control_want_thread),
        .found_valid(found_valid), .found_ready(found_ready), .found_thread(found_thread),
        .found_last(found_last), .found_found(found_found), .found_index(found_index),
        .listed_valid(control_listed_valid), .listed_thread(control_listed_thread),
        .listed_neighbors(control_listed_neighbors),
        .prepared_valid(bank_prepared_valid), .prepared_thread(bank_prepared_thread),
        .prepare_valid(control_prepare_valid), .prepare_ready(bank_prepare_ready),
        .prepare_thread(control_prepare_thread),
        .gather_valid(gather_valid), .gather_ready(gather_ready), .gather_thread(gather_thread),
        .gather_farthest(gather_farthest), .gather_none(gather_none), .gather_last(gather_last),
        .gather_index(gather_index)
    );

    process_bank bank (
        .clk(clk), .rst(rst), .fresh_valid(control_start_valid), .fresh_thread(control_start_thread),
        .fresh_query_position_x(control_start_query_position_x),
        .fresh_query_position_y(control_start_query_position_y),
        .fresh_query_position_z(control_start_query_position_z),
        .listed_valid(control_listed_valid), .listed_thread(control_listed_thread),
        .listed_neighbors(control_listed_neighbors),
        .update_valid(results_update_valid), .update_ready(bank_update_ready),
        .update_thread(results_update_thread), .update_search(results_update_search),
        .update_moved_position_x(results_update_moved_position_x),
        .update_moved_position_y(results_update_moved_position_y),
        .update_moved_position_z(results_update_moved_position_z), .update_move(results_update_move),
        .update_count(results_update_count),
        .again_valid(event_again), .again_thread(bank_again_thread), .again_search(bank_again_search),
        .stores_valid(init_out_valid), .stores_ready(bank_stores_ready), .stores_thread(init_out_thread),
        .stores_state_start_x(init_out_state_start_x), .stores_state_start_y(init_out_state_start_y),
        .stores_state_start_z(init_out_state_start_z), .stores_write_start(init_out_write_start),
        .prepared_valid(bank_prepared_valid), .prepared_thread(bank_prepared_thread),
        .want_valid(control_want_valid), .want_ready(bank_want_ready), .want_thread(control_want_thread),
        .wanted_valid(wanted_valid), .wanted_ready(wanted_ready), .wanted_thread(wanted_thread),
        .wanted_query_position_x(wanted_query_position_x), .wanted_query_position_y(wanted_query_position_y),
        .wanted_query_position_z(wanted_query_position_z),
        .gathered_valid(gathered_valid), .gathered_ready(gathered_ready), .gathered_thread(gathered_thread),
        .gathered_farthest(gathered_farthest), .gathered_none(gathered_none), .gathered_last(gathered_last),
        .gathered_position_x(gathered_position_x), .gathered_position_y(gathered_position_y),
        .gathered_position_z(gathered_position_z), .gathered_normal_x(gathered_normal_x),
        .gathered_normal_y(gathered_normal_y), .gathered_normal_z(gathered_normal_z),
        .kernel_valid(kernel_valid), .kernel_ready(kernel_ready), .kernel_thread(kernel_thread),
        .kernel_none(kernel_none), .kernel_last(kernel_last),
        .kernel_query_position_x(kernel_query_position_x), .kernel_query_position_y(kernel_query_position_y),
        .kernel_query_position_z(kernel_query_position_z),
        .kernel_neighbor_position_x(kernel_neighbor_position_x),
        .kernel_neighbor_position_y(kernel_neighbor_position_y),
        .kernel_neighbor_position_z(kernel_neighbor_position_z),
        .kernel_neighbor_normal_x(kernel_neighbor_normal_x),
        .kernel_neighbor_normal_y(kernel_neighbor_normal_y),
        .kernel_neighbor_normal_z(kernel_neighbor_normal_z),
        .init_valid(bank_init_valid), .init_ready(init_in_ready), .init_thread(bank_init_thread),
        .init_query_position_x(bank_init_query_position_x),
        .init_query_position_y(bank_init_query_position_y),
        .init_query_position_z(bank_init_query_position_z), .init_count(bank_init_count),
        .prepare_valid(control_prepare_valid), .prepare_ready(bank_prepare_ready),
        .prepare_thread(control_prepare_thread),
        .sums_valid(sums_valid), .sums_ready(sums_ready), .sums_thread(sums_thread),
        .sums_weight_0(sums_weight_0), .sums_weight_1(sums_weight_1), .sums_weight_2(sums_weight_2),
        .sums_weight_3(sums_weight_3), .sums_weight_4(sums_weight_4), .sums_weight_5(sums_weight_5),
        .sums_weight_6(sums_weight_6), .sums_weight_7(sums_weight_7), .sums_points_x_0(sums_points_x_0),
        .sums_points_x_1(sums_points_x_1), .sums_points_x_2(sums_points_x_2),
        .sums_points_x_3(sums_points_x_3), .sums_points_x_4(sums_points_x_4),
        .sums_points_x_5(sums_points_x_5), .sums_points_x_6(sums_points_x_6),
        .sums_points_x_7(sums_points_x_7), .sums_points_y_0(sums_points_y_0),
        .sums_points_y_1(sums_points_y_1), .sums_points_y_2(sums_points_y_2),
        .sums_points_y_3(sums_points_y_3), .sums_points_y_4(sums_points_y_4),
        .sums_points_y_5(sums_points_y_5), .sums_points_y_6(sums_points_y_6),
        .sums_points_y_7(sums_points_y_7), .sums_points_z_0(sums_points_z_0),
        .sums_points_z_1(sums_points_z_1), .sums_points_z_2(sums_points_z_2),
        .sums_points_z_3(sums_points_z_3), .sums_points_z_4(sums_points_z_4),
        .sums_points_z_5(sums_points_z_5), .sums_points_z_6(sums_points_z_6),
        .sums_points_z_7(sums_points_z_7), .sums_normals_x_0(sums_normals_x_0),
        .sums_normals_x_1(sums_normals_x_1), .sums_normals_x_2(sums_normals_x_2),
        .sums_normals_x_3(sums_normals_x_3), .sums_normals_x_4(sums_normals_x_4),
        .sums_normals_x_5(sums_normals_x_5), .sums_normals_x_6(sums_normals_x_6),
        .sums_normals_x_7(sums_normals_x_7), .sums_normals_y_0(sums_normals_y_0),
        .sums_normals_y_1(sums_normals_y_1), .sums_normals_y_2(sums_normals_y_2),
        .sums_normals_y_3(sums_normals_y_3), .sums_normals_y_4(sums_normals_y_4),
        .sums_normals_y_5(sums_normals_y_5), .sums_normals_y_6(sums_normals_y_6),
        .sums_normals_y_7(sums_normals_y_7), .sums_normals_z_0(sums_normals_z_0),
        .sums_normals_z_1(sums_normals_z_1), .sums_normals_z_2(sums_normals_z_2),
        .sums_normals_z_3(sums_normals_z_3), .sums_normals_z_4(sums_normals_z_4),
        .sums_normals_z_5(sums_normals_z_5), .sums_normals_z_6(sums_normals_z_6),
        .sums_normals_z_7(sums_normals_z_7),
        .finish_valid(bank_finish_valid), .finish_ready(finish_in_ready), .finish_thread(bank_finish_thread),
        .finish_query_position_x(bank_finish_query_position_x),
        .finish_query_position_y(bank_finish_query_position_y),
        .finish_query_position_z(bank_finish_query_position_z),
        .finish_state_start_x(bank_finish_state_start_x), .finish_state_start_y(bank_finish_state_start_y),
        .finish_state_start_z(bank_finish_state_start_z), .finish_sum_weight_0(bank_finish_sum_weight_0),
        .finish_sum_weight_1(bank_finish_sum_weight_1), .finish_sum_weight_2(bank_finish_sum_weight_2),
        .finish_sum_weight_3(bank_finish_sum_weight_3), .finish_sum_weight_4(bank_finish_sum_weight_4),
        .finish_sum_weight_5(bank_finish_sum_weight_5), .finish_sum_weight_6(bank_finish_sum_weight_6),
        .finish_sum_weight_7(bank_finish_sum_weight_7), .finish_sum_points_x_0(bank_finish_sum_points_x_0),
        .finish_sum_points_x_1(bank_finish_sum_points_x_1),
        .finish_sum_points_x_2(bank_finish_sum_points_x_2),
        .finish_sum_points_x_3(bank_finish_sum_points_x_3),
        .finish_sum_points_x_4(bank_finish_sum_points_x_4),
        .finish_sum_points_x_5(bank_finish_sum_points_x_5),
        .finish_sum_points_x_6(bank_finish_sum_points_x_6),
        .finish_sum_points_x_7(bank_finish_sum_points_x_7),
        .finish_sum_points_y_0(bank_finish_sum_points_y_0),
        .finish_sum_points_y_1(bank_finish_sum_points_y_1),
        .finish_sum_points_y_2(bank_finish_sum_points_y_2),
        .finish_sum_points_y_3(bank_finish_sum_points_y_3),
        .finish_sum_points_y_4(bank_finish_sum_points_y_4),
        .finish_sum_points_y_5(bank_finish_sum_points_y_5),
        .finish_sum_points_y_6(bank_finish_sum_points_y_6),
        .finish_sum_points_y_7(bank_finish_sum_points_y_7),
        .finish_sum_points_z_0(bank_finish_sum_points_z_0),
        .finish_sum_points_z_1(bank_finish_sum_points_z_1),
        .finish_sum_points_z_2(bank_finish_sum_points_z_2),
        .finish_sum_points_z_3(bank_finish_sum_points_z_3),
        .finish_sum_points_z_4(bank_finish_sum_points_z_4),
        .finish_sum_points_z_5(bank_finish_sum_points_z_5),
        .finish_sum_points_z_6(bank_finish_sum_points_z_6),
        .finish_sum_points_z_7(bank_finish_sum_points_z_7),
        .finish_sum_normals_x_0(bank_finish_sum_normals_x_0),
        .finish_sum_normals_x_1(bank_finish_sum_normals_x_1),
        .finish_sum_normals_x_2(bank_finish_sum_normals_x_2),
        .finish_sum_normals_x_3(bank_finish_sum_normals_x_3),
        .finish_sum_normals_x_4(bank_finish_sum_normals_x_4),
        .finish_sum_normals_x_5(bank_finish_sum_normals_x_5),
        .finish_sum_normals_x_6(bank_finish_sum_normals_x_6),
        .finish_sum_normals_x_7(bank_finish_sum_normals_x_7),
        .finish_sum_normals_y_0(bank_finish_sum_normals_y_0),
        .finish_sum_normals_y_1(bank_finish_sum_normals_y_1),
        .finish_sum_normals_y_2(bank_finish_sum_normals_y_2),
        .finish_sum_normals_y_3(bank_finish_sum_normals_y_3),
        .finish_sum_normals_y_4(bank_finish_sum_normals_y_4),
        .finish_sum_normals_y_5(bank_finish_sum_normals_y_5),
        .finish_sum_normals_y_6(bank_finish_sum_normals_y_6),
        .finish_sum_normals_y_7(bank_finish_sum_normals_y_7),
        .finish_sum_normals_z_0(bank_finish_sum_normals_z_0),
        .finish_sum_normals_z_1(bank_finish_sum_normals_z_1),
        .finish_sum_normals_z_2(bank_finish_sum_normals_z_2),
        .finish_sum_normals_z_3(bank_finish_sum_normals_z_3),
        .finish_sum_normals_z_4(bank_finish_sum_normals_z_4),
        .finish_sum_normals_z_5(bank_finish_sum_normals_z_5),
        .finish_sum_normals_z_6(bank_finish_sum_normals_z_6),
        .finish_sum_normals_z_7(bank_finish_sum_normals_z_7)
    );

    process_finish finish (
        .clk(clk), .rst(rst), .in_valid(bank_finish_valid), .in_ready(finish_in_ready),
        .in_thread(bank_finish_thread), .in_query_position_x(bank_finish_query_position_x),
        .in_query_position_y(bank_finish_query_position_y),
        .in_query_position_z(bank_finish_query_position_z), .in_state_start_x(bank_finish_state_start_x),
        .in_state_start_y(bank_finish_state_start_y), .in_state_start_z(bank_finish_state_start_z),
        .in_sum_weight_0(bank_finish_sum_weight_0), .in_sum_weight_1(bank_finish_sum_weight_1),
        .in_sum_weight_2(bank_finish_sum_weight_2), .in_sum_weight_3(bank_finish_sum_weight_3),
        .in_sum_weight_4(bank_finish_sum_weight_4), .in_sum_weight_5(bank_finish_sum_weight_5),
        .in_sum_weight_6(bank_finish_sum_weight_6), .in_sum_weight_7(bank_finish_sum_weight_7),
        .in_sum_points_x_0(bank_finish_sum_points_x_0), .in_sum_points_x_1(bank_finish_sum_points_x_1),
        .in_sum_points_x_2(bank_finish_sum_points_x_2), .in_sum_points_x_3(bank_finish_sum_points_x_3),
        .in_sum_points_x_4(bank_finish_sum_points_x_4), .in_sum_points_x_5(bank_finish_sum_points_x_5),
        .in_sum_points_x_6(bank_finish_sum_points_x_6), .in_sum_points_x_7(bank_finish_sum_points_x_7),
        .in_sum_points_y_0(bank_finish_sum_points_y_0), .in_sum_points_y_1(bank_finish_sum_points_y_1),
        .in_sum_points_y_2(bank_finish_sum_points_y_2), .in_sum_points_y_3(bank_finish_sum_points_y_3),
        .in_sum_points_y_4(bank_finish_sum_points_y_4), .in_sum_points_y_5(bank_finish_sum_points_y_5),
        .in_sum_points_y_6(bank_finish_sum_points_y_6), .in_sum_points_y_7(bank_finish_sum_points_y_7),
        .in_sum_points_z_0(bank_finish_sum_points_z_0), .in_sum_points_z_1(bank_finish_sum_points_z_1),
        .in_sum_points_z_2(bank_finish_sum_points_z_2), .in_sum_points_z_3(bank_finish_sum_points_z_3),
        .in_sum_points_z_4(bank_finish_sum_points_z_4), .in_sum_points_z_5(bank_finish_sum_points_z_5),
        .in_sum_points_z_6(bank_finish_sum_points_z_6), .in_sum_points_z_7(bank_finish_sum_points_z_7),
        .in_sum_normals_x_0(bank_finish_sum_normals_x_0), .in_sum_normals_x_1(bank_finish_sum_normals_x_1),
        .in_sum_normals_x_2(bank_finish_sum_normals_x_2), .in_sum_normals_x_3(bank_finish_sum_normals_x_3),
        .in_sum_normals_x_4(bank_finish_sum_normals_x_4), .in_sum_normals_x_5(bank_finish_sum_normals_x_5),
        .in_sum_normals_x_6(bank_finish_sum_normals_x_6), .in_sum_normals_x_7(bank_finish_sum_normals_x_7),
        .in_sum_normals_y_0(bank_finish_sum_normals_y_0), .in_sum_normals_y_1(bank_finish_sum_normals_y_1),
        .in_sum_normals_y_2(bank_finish_sum_normals_y_2), .in_sum_normals_y_3(bank_finish_sum_normals_y_3),
        .in_sum_normals_y_4(bank_finish_sum_normals_y_4), .in_sum_normals_y_5(bank_finish_sum_normals_y_5),
        .in_sum_normals_y_6(bank_finish_sum_normals_y_6), .in_sum_normals_y_7(bank_finish_sum_normals_y_7),
        .in_sum_normals_z_0(bank_finish_sum_normals_z_0), .in_sum_normals_z_1(bank_finish_sum_normals_z_1),
        .in_sum_normals_z_2(bank_finish_sum_normals_z_2), .in_sum_normals_z_3(bank_finish_sum_normals_z_3),
        .in_sum_normals_z_4(bank_finish_sum_normals_z_4), .in_sum_normals_z_5(bank_finish_sum_normals_z_5),
        .in_sum_normals_z_6(bank_finish_sum_normals_z_6), .in_sum_normals_z_7(bank_finish_sum_normals_z_7),
        .setting_tolerance(setting_tolerance),
        .out_valid(finish_out_valid), .out_ready(results_finished_ready), .out_thread(finish_out_thread),
        .out_output_position_x(finish_out_output_position_x),
        .out_output_position_y(finish_out_output_position_y),
        .out_output_position_z(finish_out_output_position_z),
        .out_output_normal_x(finish_out_output_normal_x), .out_output_normal_y(finish_out_output_normal_y),
        .out_output_normal_z(finish_out_output_normal_z), .out_output_residual(finish_out_output_residual),
        .out_output_valid(finish_out_output_valid), .out_moved_position_x(finish_out_moved_position_x),
        .out_moved_position_y(finish_out_moved_position_y),
        .out_moved_position_z(finish_out_moved_position_z), .out_move(finish_out_move),
        .out_done(finish_out_done), .out_search(finish_out_search)
    );

    process_output results (
        .clk(clk), .rst(rst), .iterations_max(iterations_max),
        .numbered_valid(control_start_valid), .numbered_thread(control_start_thread),
        .numbered_number(control_start_number),
        .finished_valid(finish_out_valid), .finished_ready(results_finished_ready),
        .finished_thread(finish_out_thread), .finished_output_position_x(finish_out_output_position_x),
        .finished_output_position_y(finish_out_output_position_y),
        .finished_output_position_z(finish_out_output_position_z),
        .finished_output_normal_x(finish_out_output_normal_x),
        .finished_output_normal_y(finish_out_output_normal_y),
        .finished_output_normal_z(finish_out_output_normal_z),
        .finished_output_residual(finish_out_output_residual),
        .finished_output_valid(finish_out_output_valid),
        .finished_moved_position_x(finish_out_moved_position_x),
        .finished_moved_position_y(finish_out_moved_position_y),
        .finished_moved_position_z(finish_out_moved_position_z), .finished_move(finish_out_move),
        .finished_done(finish_out_done), .finished_search(finish_out_search),
        .update_valid(results_update_valid), .update_ready(bank_update_ready),
        .update_thread(results_update_thread), .update_search(results_update_search),
        .update_moved_position_x(results_update_moved_position_x),
        .update_moved_position_y(results_update_moved_position_y),
        .update_moved_position_z(results_update_moved_position_z), .update_move(results_update_move),
        .update_count(results_update_count),
        .result_valid(result_valid), .result_ready(result_ready), .result_number(result_number),
        .result_iterations(result_iterations), .result_capped(result_capped),
        .result_output_position_x(result_output_position_x),
        .result_output_position_y(result_output_position_y),
        .result_output_position_z(result_output_position_z), .result_output_normal_x(result_output_normal_x),
        .result_output_normal_y(result_output_normal_y), .result_output_normal_z(result_output_normal_z),
        .result_output_residual(result_output_residual), .result_output_valid(result_output_valid),
        .released_valid(results_released_valid), .released_thread(results_released_thread)
    );

    wire _unused = &{1'b0, setting_inverse_radius2};
endmodule

// Counts iterations, and lets queries leave.
// threads = 128
module process_output (
    input  wire clk, input wire rst,
    input  wire [15:0] iterations_max,  // Iterations that a query has at most, at least one.
    input  wire numbered_valid,  // A thread takes up a query; not in two cycles in a row.
    input  wire [6:0] numbered_thread,  // Thread.
    input  wire [23:0] numbered_number,  // The query's number.
    input  wire finished_valid, output wire finished_ready,  // What comes of `final`.
    input  wire [6:0] finished_thread,  // Thread.
    input  wire [31:0] finished_output_position_x,  // Words of the outputs.
    input  wire [31:0] finished_output_position_y,  // Words of the outputs.
    input  wire [31:0] finished_output_position_z,  // Words of the outputs.
    input  wire [31:0] finished_output_normal_x,  // Words of the outputs.
    input  wire [31:0] finished_output_normal_y,  // Words of the outputs.
    input  wire [31:0] finished_output_normal_z,  // Words of the outputs.
    input  wire [31:0] finished_output_residual,  // Words of the outputs.
    input  wire finished_output_valid,  // Words of the outputs.
    input  wire [31:0] finished_moved_position_x,  // The query's new position.
    input  wire [31:0] finished_moved_position_y,  // The query's new position.
    input  wire [31:0] finished_moved_position_z,  // The query's new position.
    input  wire finished_move,  // The query has moved there.
    input  wire finished_done,  // The query is done.
    input  wire finished_search,  // Else it needs the neighbors of its position.
    output wire update_valid, input wire update_ready,  // What is written of a query that goes on.
    output wire [6:0] update_thread,  // Thread.
    output wire update_search,  // It needs the neighbors of its position; else it goes on with those it has.
    output wire [31:0] update_moved_position_x,  // The query's new position.
    output wire [31:0] update_moved_position_y,  // The query's new position.
    output wire [31:0] update_moved_position_z,  // The query's new position.
    output wire update_move,  // The query has moved there.
    output wire [15:0] update_count,  // Iterations that are complete.
    output wire result_valid, input wire result_ready,  // Queries that leave.
    output wire [23:0] result_number,  // Its number.
    output wire [15:0] result_iterations,  // Iterations that it took.
    output wire result_capped,  // It was not done, but had no iteration left.
    output wire [31:0] result_output_position_x,  // Words of the outputs.
    output wire [31:0] result_output_position_y,  // Words of the outputs.
    output wire [31:0] result_output_position_z,  // Words of the outputs.
    output wire [31:0] result_output_normal_x,  // Words of the outputs.
    output wire [31:0] result_output_normal_y,  // Words of the outputs.
    output wire [31:0] result_output_normal_z,  // Words of the outputs.
    output wire [31:0] result_output_residual,  // Words of the outputs.
    output wire result_output_valid,  // Words of the outputs.
    output reg  released_valid,  // A thread's query has left.
    output reg  [6:0] released_thread  // Thread.
);
    (* ram_style = "distributed" *)
    reg [23:0] numbers [0:127];
    (* ram_style = "distributed" *)
    reg [15:0] counts [0:127];
    reg [23:0] number;
    reg [15:0] count;
    reg has_read, begun;
    reg [6:0] begun_thread;

    wire update_queue_in_ready;
    wire [120:0] update_queue_out_data;
    wire result_queue_in_ready;
    wire [265:0] result_queue_out_data;

    assign finished_ready = has_read & (update_queue_in_ready & result_queue_in_ready);
    wire take = finished_valid & finished_ready;
    wire [15:0] iterations = count + 16'd1;
    wire capped = ~finished_done & (iterations == iterations_max);
    wire leaves = finished_done | capped;
    wire goes_on = take & ~leaves;
    wire take_and_leaves = take & leaves;
    wire begun_and_goes_on = begun & goes_on;

    assign {
        update_thread, update_search, update_moved_position_x, update_moved_position_y,
        update_moved_position_z, update_move, update_count
    } = update_queue_out_data;
    assign {
        result_number, result_iterations, result_capped, result_output_position_x, result_output_position_y,
        result_output_position_z, result_output_normal_x, result_output_normal_y, result_output_normal_z,
        result_output_residual, result_output_valid
    } = result_queue_out_data;

    stream_half_buffer_w121 update_queue (
        .clk(clk), .rst(rst), .in_valid(goes_on), .in_ready(update_queue_in_ready),
        .in_data({
            finished_thread, finished_search, finished_moved_position_x, finished_moved_position_y,
            finished_moved_position_z, finished_move, iterations
        }),
        .out_valid(update_valid), .out_ready(update_ready), .out_data(update_queue_out_data)
    );

    stream_half_buffer_w266 result_queue (
        .clk(clk), .rst(rst), .in_valid(take_and_leaves), .in_ready(result_queue_in_ready),
        .in_data({
            number, iterations, capped, finished_output_position_x, finished_output_position_y,
            finished_output_position_z, finished_output_normal_x, finished_output_normal_y,
            finished_output_normal_z, finished_output_residual, finished_output_valid
        }),
        .out_valid(result_valid), .out_ready(result_ready), .out_data(result_queue_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            has_read <= 1'd0;
            begun <= 1'd0;
            released_valid <= 1'd0;
        end else begin
            has_read <= finished_valid & ~take;
            begun <= numbered_valid | begun_and_goes_on;
            released_valid <= take_and_leaves;
        end
    end
    always @(posedge clk) begin
        if (numbered_valid) begun_thread <= numbered_thread;
        released_thread <= finished_thread;
    end
    always @(posedge clk) begin
        if (numbered_valid) numbers[numbered_thread] <= numbered_number;
        number <= numbers[finished_thread];
    end
    always @(posedge clk) begin
        if (goes_on | begun) begin
            counts[goes_on ? finished_thread : begun_thread] <= goes_on ? iterations : 16'd0;
        end
        count <= counts[finished_thread];
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        one_begins_at_a_time: assert (~begun_and_goes_on | ~numbered_valid);
        finishes_after_begin: assert (~(numbered_valid & finished_valid) | ~(finished_thread == numbered_thread));
        finishes_after_begun: assert (~(begun & finished_valid) | ~(finished_thread == begun_thread));
`else
        if (!(~begun_and_goes_on | ~numbered_valid)) begin
            $display("assertion failed: one_begins_at_a_time in %m"); $stop;
        end
        if (!(~(numbered_valid & finished_valid) | ~(finished_thread == numbered_thread))) begin
            $display("assertion failed: finishes_after_begin in %m"); $stop;
        end
        if (!(~(begun & finished_valid) | ~(finished_thread == begun_thread))) begin
            $display("assertion failed: finishes_after_begun in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// One item in a register, at half rate.
// width = 266
module stream_half_buffer_w266 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [265:0] in_data,
    output wire out_valid, input wire out_ready, output wire [265:0] out_data
);
    reg filled;
    reg [265:0] item;

    assign in_ready = ~filled;

    assign out_valid = filled;
    assign out_data = item;

    always @(posedge clk) begin
        if (rst) filled <= 1'd0;
        else filled <= filled ? ~out_ready : in_valid;
    end
    always @(posedge clk) if (in_ready) item <= in_data;
endmodule

// One item in a register, at half rate.
// width = 121
module stream_half_buffer_w121 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [120:0] in_data,
    output wire out_valid, input wire out_ready, output wire [120:0] out_data
);
    reg filled;
    reg [120:0] item;

    assign in_ready = ~filled;

    assign out_valid = filled;
    assign out_data = item;

    always @(posedge clk) begin
        if (rst) filled <= 1'd0;
        else filled <= filled ? ~out_ready : in_valid;
    end
    always @(posedge clk) if (in_ready) item <= in_data;
endmodule

// The block `final` of the program.
// latency = 111
// initiation_interval = 8
module process_finish (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready,  // What it takes.
    input  wire [6:0] in_thread,  // Thread.
    input  wire [31:0] in_query_position_x,  // Words that `final` reads besides settings and sums.
    input  wire [31:0] in_query_position_y,  // Words that `final` reads besides settings and sums.
    input  wire [31:0] in_query_position_z,  // Words that `final` reads besides settings and sums.
    input  wire [31:0] in_state_start_x,  // Words that `final` reads besides settings and sums.
    input  wire [31:0] in_state_start_y,  // Words that `final` reads besides settings and sums.
    input  wire [31:0] in_state_start_z,  // Words that `final` reads besides settings and sums.
    input  wire [31:0] in_sum_weight_0,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_weight_1,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_weight_2,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_weight_3,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_weight_4,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_weight_5,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_weight_6,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_weight_7,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_points_x_0,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_points_x_1,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_points_x_2,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_points_x_3,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_points_x_4,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_points_x_5,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_points_x_6,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_points_x_7,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_points_y_0,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_points_y_1,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_points_y_2,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_points_y_3,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_points_y_4,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_points_y_5,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_points_y_6,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_points_y_7,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_points_z_0,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_points_z_1,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_points_z_2,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_points_z_3,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_points_z_4,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_points_z_5,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_points_z_6,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_points_z_7,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_normals_x_0,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_normals_x_1,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_normals_x_2,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_normals_x_3,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_normals_x_4,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_normals_x_5,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_normals_x_6,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_normals_x_7,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_normals_y_0,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_normals_y_1,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_normals_y_2,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_normals_y_3,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_normals_y_4,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_normals_y_5,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_normals_y_6,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_normals_y_7,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_normals_z_0,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_normals_z_1,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_normals_z_2,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_normals_z_3,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_normals_z_4,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_normals_z_5,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_normals_z_6,  // Of each word of the sums its partial sums.
    input  wire [31:0] in_sum_normals_z_7,  // Of each word of the sums its partial sums.
    input  wire [31:0] setting_tolerance,  // Words of the settings.
    output wire out_valid, input wire out_ready,  // What comes of it.
    output wire [6:0] out_thread,  // Thread.
    output wire [31:0] out_output_position_x,  // Words of the outputs.
    output wire [31:0] out_output_position_y,  // Words of the outputs.
    output wire [31:0] out_output_position_z,  // Words of the outputs.
    output wire [31:0] out_output_normal_x,  // Words of the outputs.
    output wire [31:0] out_output_normal_y,  // Words of the outputs.
    output wire [31:0] out_output_normal_z,  // Words of the outputs.
    output wire [31:0] out_output_residual,  // Words of the outputs.
    output wire out_output_valid,  // Words of the outputs.
    output wire [31:0] out_moved_position_x,  // The query's new position.
    output wire [31:0] out_moved_position_y,  // The query's new position.
    output wire [31:0] out_moved_position_z,  // The query's new position.
    output wire out_move,  // The query has moved there.
    output wire out_done,  // The query is done.
    output wire out_search  // Else it needs the neighbors of its position.
);
    (* ram_style = "distributed" *)
    reg [31:0] delay_6_from_0 [0:4];
    (* ram_style = "distributed" *)
    reg [95:0] delay_12_from_0 [0:10];
    (* ram_style = "distributed" *)
    reg [95:0] delay_13_from_0 [0:11];
    (* ram_style = "distributed" *)
    reg [6:0] delay_14_from_0 [0:12];
    (* ram_style = "distributed" *)
    reg [31:0] delay_5_from_2 [0:3];
    (* ram_style = "distributed" *)
    reg [31:0] delay_5_from_5 [0:3];
    (* ram_style = "distributed" *)
    reg [63:0] delay_7_from_5 [0:5];
    (* ram_style = "distributed" *)
    reg delay_8_from_5 [0:6];
    (* ram_style = "distributed" *)
    reg [31:0] delay_8_from_6 [0:6];
    reg [4:0] credits;
    reg [7:0] phases_1;
    reg [2:0] delay_6_from_0_pointer;
    reg [31:0] delay_6_from_0_out;
    reg [7:0] phases_2;
    reg [3:0] delay_12_from_0_pointer;
    reg [95:0] delay_12_from_0_out;
    reg [7:0] phases_3;
    reg [3:0] delay_13_from_0_pointer;
    reg [95:0] delay_13_from_0_out;
    reg [3:0] delay_14_from_0_pointer;
    reg [6:0] delay_14_from_0_out;
    reg [1:0] delay_5_from_2_pointer;
    reg [31:0] delay_5_from_2_out;
    reg [1:0] delay_5_from_5_pointer;
    reg [31:0] delay_5_from_5_out;
    reg [2:0] delay_7_from_5_pointer;
    reg [63:0] delay_7_from_5_out;
    reg [2:0] delay_8_from_5_pointer;
    reg delay_8_from_5_out;
    reg [2:0] delay_8_from_6_pointer;
    reg [31:0] delay_8_from_6_out, query_position_x_d1, query_position_y_d1;
    reg [7:0] phases_4;
    reg [31:0] query_position_z_d1, state_start_x_d1, state_start_y_d1, state_start_z_d1;
    reg [7:0] phases_5;
    reg [31:0] sum_weight_0_d1, sum_weight_1_d1, sum_weight_2_d1, sum_weight_3_d1;
    reg [7:0] phases_6;
    reg [31:0] sum_weight_4_d1, sum_weight_5_d1, sum_weight_6_d1, sum_weight_7_d1;
    reg [7:0] phases_7;
    reg [31:0] sum_points_x_0_d1, sum_points_x_1_d1, sum_points_x_2_d1, sum_points_x_3_d1;
    reg [7:0] phases_8;
    reg [31:0] sum_points_x_4_d1, sum_points_x_5_d1, sum_points_x_6_d1, sum_points_x_7_d1;
    reg [7:0] phases_9;
    reg [31:0] sum_points_y_0_d1, sum_points_y_1_d1, sum_points_y_2_d1, sum_points_y_3_d1;
    reg [7:0] phases_10;
    reg [31:0] sum_points_y_4_d1, sum_points_y_5_d1, sum_points_y_6_d1, sum_points_y_7_d1;
    reg [7:0] phases_11;
    reg [31:0] sum_points_z_0_d1, sum_points_z_1_d1, sum_points_z_2_d1, sum_points_z_3_d1;
    reg [7:0] phases_12;
    reg [31:0] sum_points_z_4_d1, sum_points_z_5_d1, sum_points_z_6_d1, sum_points_z_7_d1;
    reg [7:0] phases_13;
    reg [31:0] sum_normals_x_6_d1, sum_normals_x_7_d1, sum_normals_z_0_d1, sum_normals_z_1_d1;
    reg [7:0] phases_14;
    reg [31:0] sum_normals_z_2_d1, sum_normals_z_3_d1, sum_normals_z_4_d1, sum_normals_z_5_d1;
    reg [7:0] phases_15;
    reg [31:0] sum_normals_z_6_d1, sum_normals_z_7_d1, sum_weight_0_plus_sum_weight_1_d1;
    reg [31:0] sum_weight_2_plus_sum_weight_3_d1, inverse_weight_sum_d1, sum_weight_4_plus_sum_weight_5_d1;
    reg [31:0] sum_weight_6_plus_sum_weight_7_d1, inverse_weight_sum_d1_copy2, inverse_weight_d1, a_x_sum_d1;
    reg [31:0] a_x_sum_d1_copy2, a_x_sum_plus_a_x_sum_d1, a_x_sum_d1_copy3, a_x_sum_d1_copy4;
    reg [31:0] a_x_sum_plus_a_x_sum_d1_copy2, a_x_sum_d1_copy5, a_x_sum_d2, a_x_sum_d3, a_x_sum_d4, a_y_sum_d1;
    reg [31:0] a_y_sum_d1_copy2, a_y_sum_plus_a_y_sum_d1, a_y_sum_d1_copy3, a_y_sum_d1_copy4;
    reg [31:0] a_y_sum_plus_a_y_sum_d1_copy2, a_y_sum_d1_copy5, a_y_sum_d2, a_y_sum_d3, a_y_sum_d4, a_z_sum_d1;
    reg [31:0] a_z_sum_d1_copy2, a_z_sum_plus_a_z_sum_d1, a_z_sum_d1_copy3, a_z_sum_d1_copy4;
    reg [31:0] a_z_sum_plus_a_z_sum_d1_copy2, a_z_sum_d1_copy5, a_z_sum_d2, a_z_sum_d3, a_z_sum_d4, a_x_d1, a_x_d2;
    reg [31:0] a_y_d1, a_y_d2, a_z_d1, a_z_d2, a_z_d3, magnitude_sum_d1, magnitude_sum_d1_copy2;
    reg [31:0] magnitude_sum_d1_copy3, magnitude_sum_d1_copy4, magnitude_sum_d1_copy5;
    reg [7:0] phases_16;
    reg [31:0] magnitude_sum_d1_copy6, magnitude_sum_d1_copy7, magnitude_sum_d1_copy8, magnitude_sum_d1_copy9;
    reg [31:0] magnitude_sum_d1_copy10, magnitude_sum_d1_copy11, magnitude_sum_d1_copy12, inverse_length_d1, n_x_d1;
    reg [31:0] n_x_d2, n_x_d3, n_x_d4, n_y_d1, n_y_d2, n_y_d3, n_y_d4, n_z_d1, n_z_d2, n_z_d3, a_y_times_n_y_d1;
    reg [31:0] residual_sum_d1, residual_d1;
    reg weighs_d1, weighs_d2, weighs_d3, valid_d1;
    reg [31:0] from_start_x_d1, from_start_y_d1, from_start_z_d1;
    reg [7:0] phases_17;
    reg [31:0] along_d1, surface_x_d1, surface_z_d1, normal_x_d1, normal_y_d1, normal_z_d1, residual_there_d1;
    reg finished_d1;
    reg [2:0] add_f32_ftz_unit_phase;
    reg [31:0] add_f32_ftz_unit_a;
    reg [2:0] add_f32_ftz_unit_phase_copy2;
    reg [31:0] add_f32_ftz_unit_b;
    reg [2:0] add_f32_ftz_unit_copy2_phase;
    reg [31:0] add_f32_ftz_unit_copy2_a;
    reg [2:0] add_f32_ftz_unit_copy2_phase_copy2;
    reg [31:0] add_f32_ftz_unit_copy2_b;
    reg [2:0] add_f32_ftz_unit_copy3_phase;
    reg [31:0] add_f32_ftz_unit_copy3_a;
    reg [2:0] add_f32_ftz_unit_copy3_phase_copy2;
    reg [31:0] add_f32_ftz_unit_copy3_b;
    reg [2:0] add_f32_ftz_unit_copy4_phase;
    reg [31:0] add_f32_ftz_unit_copy4_a;
    reg [2:0] add_f32_ftz_unit_copy4_phase_copy2;
    reg [31:0] add_f32_ftz_unit_copy4_b;
    reg [2:0] add_f32_ftz_unit_copy5_phase;
    reg [31:0] add_f32_ftz_unit_copy5_a;
    reg [2:0] add_f32_ftz_unit_copy5_phase_copy2;
    reg [31:0] add_f32_ftz_unit_copy5_b;
    reg [2:0] add_f32_ftz_unit_copy6_phase;
    reg [31:0] add_f32_ftz_unit_copy6_a;
    reg [2:0] add_f32_ftz_unit_copy6_phase_copy2;
    reg [31:0] add_f32_ftz_unit_copy6_b;
    reg [2:0] add_f32_ftz_unit_copy7_phase;
    reg [31:0] add_f32_ftz_unit_copy7_a;
    reg [2:0] add_f32_ftz_unit_copy7_phase_copy2;
    reg [31:0] add_f32_ftz_unit_copy7_b;
    reg [2:0] mul_f32_ftz_unit_phase;
    reg [31:0] mul_f32_ftz_unit_a;
    reg [2:0] mul_f32_ftz_unit_phase_copy2;
    reg [31:0] mul_f32_ftz_unit_b;
    reg [2:0] mul_f32_ftz_unit_copy2_phase;
    reg [31:0] mul_f32_ftz_unit_copy2_a, mul_f32_ftz_unit_copy2_b;
    reg [2:0] mul_add_f32_ftz_unit_phase;
    reg [31:0] mul_add_f32_ftz_unit_a;
    reg [2:0] mul_add_f32_ftz_unit_phase_copy2;
    reg [31:0] mul_add_f32_ftz_unit_b;
    reg [2:0] mul_add_f32_ftz_unit_phase_copy3;
    reg [31:0] mul_add_f32_ftz_unit_c;
    reg [13:0] in_flight;
    reg left;

    wire [31:0] add_f32_ftz_unit_y, add_f32_ftz_unit_copy2_y, add_f32_ftz_unit_copy3_y, add_f32_ftz_unit_copy4_y;
    wire [31:0] add_f32_ftz_unit_copy5_y, add_f32_ftz_unit_copy6_y, add_f32_ftz_unit_copy7_y, recip_f32_ftz_unit_y;
    wire [31:0] mul_f32_ftz_unit_y, mul_f32_ftz_unit_copy2_y, mul_add_f32_ftz_unit_y, rsqrt_f32_ftz_unit_y;
    wire lt_f32_ftz_unit_y, lt_f32_ftz_unit_copy2_y, lt_f32_ftz_unit_copy3_y, le_f32_ftz_unit_y;
    wire queue_1_in_ready;
    wire [102:0] queue_1_out_data;
    wire queue_2_in_ready, queue_2_out_valid;
    wire [127:0] queue_2_out_data;
    wire queue_3_in_ready, queue_3_out_valid;
    wire [99:0] queue_3_out_data;

    assign in_ready = ~credits[4] & phases_1[0];
    wire [31:0] distance = {1'd0, mul_add_f32_ftz_unit_y[30:0]};
    wire kept = in_flight[13] & phases_2[7];
    wire [31:0] query_position_y_d14 = delay_13_from_0_out[63:32];
    wire [31:0] surface_y = valid_d1 ? mul_add_f32_ftz_unit_y : query_position_y_d14;
    wire in_valid_and_in_ready = in_valid & in_ready;
    wire valid = lt_f32_ftz_unit_copy3_y & delay_8_from_5_out;
    wire [31:0] query_position_x_d14 = delay_13_from_0_out[31:0];
    wire [31:0] surface_x = valid_d1 ? mul_add_f32_ftz_unit_y : query_position_x_d14;
    wire [31:0] query_position_z_d14 = delay_13_from_0_out[95:64];
    wire [31:0] surface_z = valid_d1 ? add_f32_ftz_unit_copy7_y : query_position_z_d14;
    wire [31:0] normal_x = valid ? n_x_d4 : 32'd0;
    wire [31:0] normal_y = valid ? n_y_d4 : 32'd0;
    wire [31:0] normal_z = valid ? n_z_d3 : 32'd0;
    wire [31:0] residual_there = valid ? residual_d1 : 32'd0;
    wire invalid = ~valid;
    wire finished = le_f32_ftz_unit_y | invalid;
    wire [31:0] add_f32_ftz_unit_a_choice = add_f32_ftz_unit_phase[1] ? (add_f32_ftz_unit_phase[0] ? add_f32_ftz_unit_y : a_z_sum_d1) : add_f32_ftz_unit_phase[0] ? a_x_sum_d1_copy3 : sum_points_x_0_d1;
    wire [31:0] add_f32_ftz_unit_a_choice_2 = add_f32_ftz_unit_phase[0] ? sum_weight_4_plus_sum_weight_5_d1 : sum_weight_0_d1;
    wire [31:0] add_f32_ftz_unit_a_choice_3 = add_f32_ftz_unit_phase[0] ? sum_normals_x_6_d1 : in_sum_normals_x_0;
    wire [31:0] add_f32_ftz_unit_a_choice_4 = add_f32_ftz_unit_phase[1] ? add_f32_ftz_unit_a_choice_2 : add_f32_ftz_unit_a_choice_3;
    wire [31:0] add_f32_ftz_unit_b_choice = add_f32_ftz_unit_phase_copy2[0] ? add_f32_ftz_unit_copy2_y : a_z_sum_d1_copy2;
    wire [31:0] add_f32_ftz_unit_b_choice_2 = add_f32_ftz_unit_phase_copy2[0] ? a_x_sum_d1_copy4 : sum_points_x_1_d1;
    wire [31:0] add_f32_ftz_unit_b_choice_3 = add_f32_ftz_unit_phase_copy2[1] ? add_f32_ftz_unit_b_choice : add_f32_ftz_unit_b_choice_2;
    wire [31:0] add_f32_ftz_unit_b_choice_4 = add_f32_ftz_unit_phase_copy2[0] ? sum_weight_6_plus_sum_weight_7_d1 : sum_weight_1_d1;
    wire [31:0] add_f32_ftz_unit_b_choice_5 = add_f32_ftz_unit_phase_copy2[0] ? sum_normals_x_7_d1 : in_sum_normals_x_1;
    wire [31:0] add_f32_ftz_unit_b_choice_6 = add_f32_ftz_unit_phase_copy2[1] ? add_f32_ftz_unit_b_choice_4 : add_f32_ftz_unit_b_choice_5;
    wire [31:0] add_f32_ftz_unit_copy2_a_choice = add_f32_ftz_unit_copy2_phase[0] ? add_f32_ftz_unit_copy4_y : a_z_sum_d1_copy3;
    wire [31:0] add_f32_ftz_unit_copy2_a_choice_2 = add_f32_ftz_unit_copy2_phase[0] ? a_x_sum_plus_a_x_sum_d1 : sum_points_x_2_d1;
    wire [31:0] add_f32_ftz_unit_copy2_a_choice_3 = add_f32_ftz_unit_copy2_phase[1] ? add_f32_ftz_unit_copy2_a_choice : add_f32_ftz_unit_copy2_a_choice_2;
    wire [31:0] add_f32_ftz_unit_copy2_a_choice_4 = add_f32_ftz_unit_copy2_phase[0] ? inverse_weight_sum_d1 : sum_weight_2_d1;
    wire [31:0] add_f32_ftz_unit_copy2_a_choice_5 = add_f32_ftz_unit_copy2_phase[0] ? magnitude_sum_d1_copy2 : in_sum_normals_x_2;
    wire [31:0] add_f32_ftz_unit_copy2_a_choice_6 = add_f32_ftz_unit_copy2_phase[1] ? add_f32_ftz_unit_copy2_a_choice_4 : add_f32_ftz_unit_copy2_a_choice_5;
    wire [31:0] add_f32_ftz_unit_copy2_b_choice = add_f32_ftz_unit_copy2_phase_copy2[0] ? add_f32_ftz_unit_copy5_y : a_z_sum_d1_copy4;
    wire [31:0] add_f32_ftz_unit_copy2_b_choice_2 = add_f32_ftz_unit_copy2_phase_copy2[0] ? a_x_sum_plus_a_x_sum_d1_copy2 : sum_points_x_3_d1;
    wire [31:0] add_f32_ftz_unit_copy2_b_choice_3 = add_f32_ftz_unit_copy2_phase_copy2[1] ? add_f32_ftz_unit_copy2_b_choice : add_f32_ftz_unit_copy2_b_choice_2;
    wire [31:0] add_f32_ftz_unit_copy2_b_choice_4 = add_f32_ftz_unit_copy2_phase_copy2[0] ? inverse_weight_sum_d1_copy2 : sum_weight_3_d1;
    wire [31:0] add_f32_ftz_unit_copy2_b_choice_5 = add_f32_ftz_unit_copy2_phase_copy2[0] ? magnitude_sum_d1_copy3 : in_sum_normals_x_3;
    wire [31:0] add_f32_ftz_unit_copy2_b_choice_6 = add_f32_ftz_unit_copy2_phase_copy2[1] ? add_f32_ftz_unit_copy2_b_choice_4 : add_f32_ftz_unit_copy2_b_choice_5;
    wire [31:0] add_f32_ftz_unit_copy3_a_choice = add_f32_ftz_unit_copy3_phase[0] ? add_f32_ftz_unit_copy6_y : a_z_sum_plus_a_z_sum_d1;
    wire [31:0] add_f32_ftz_unit_copy3_a_choice_2 = add_f32_ftz_unit_copy3_phase[0] ? a_y_sum_plus_a_y_sum_d1 : a_x_sum_d1;
    wire [31:0] add_f32_ftz_unit_copy3_a_choice_3 = add_f32_ftz_unit_copy3_phase[1] ? add_f32_ftz_unit_copy3_a_choice : add_f32_ftz_unit_copy3_a_choice_2;
    wire [31:0] add_f32_ftz_unit_copy3_a_choice_4 = add_f32_ftz_unit_copy3_phase[0] ? sum_points_y_0_d1 : sum_weight_0_plus_sum_weight_1_d1;
    wire [31:0] add_f32_ftz_unit_copy3_a_choice_5 = add_f32_ftz_unit_copy3_phase[0] ? magnitude_sum_d1 : in_sum_normals_x_4;
    wire [31:0] add_f32_ftz_unit_copy3_a_choice_6 = add_f32_ftz_unit_copy3_phase[1] ? add_f32_ftz_unit_copy3_a_choice_4 : add_f32_ftz_unit_copy3_a_choice_5;
    wire [31:0] add_f32_ftz_unit_copy3_b_choice = add_f32_ftz_unit_copy3_phase_copy2[0] ? add_f32_ftz_unit_copy7_y : a_z_sum_plus_a_z_sum_d1_copy2;
    wire [31:0] add_f32_ftz_unit_copy3_b_choice_2 = add_f32_ftz_unit_copy3_phase_copy2[0] ? a_y_sum_plus_a_y_sum_d1_copy2 : a_x_sum_d1_copy2;
    wire [31:0] add_f32_ftz_unit_copy3_b_choice_3 = add_f32_ftz_unit_copy3_phase_copy2[1] ? add_f32_ftz_unit_copy3_b_choice : add_f32_ftz_unit_copy3_b_choice_2;
    wire [31:0] add_f32_ftz_unit_copy3_b_choice_4 = add_f32_ftz_unit_copy3_phase_copy2[0] ? sum_points_y_1_d1 : sum_weight_2_plus_sum_weight_3_d1;
    wire [31:0] add_f32_ftz_unit_copy3_b_choice_5 = add_f32_ftz_unit_copy3_phase_copy2[0] ? magnitude_sum_d1_copy4 : in_sum_normals_x_5;
    wire [31:0] add_f32_ftz_unit_copy3_b_choice_6 = add_f32_ftz_unit_copy3_phase_copy2[1] ? add_f32_ftz_unit_copy3_b_choice_4 : add_f32_ftz_unit_copy3_b_choice_5;
    wire [31:0] add_f32_ftz_unit_copy4_a_choice = add_f32_ftz_unit_copy4_phase[0] ? query_position_z_d1 : add_f32_ftz_unit_copy2_y;
    wire [31:0] add_f32_ftz_unit_copy4_a_choice_2 = add_f32_ftz_unit_copy4_phase[0] ? sum_points_z_0_d1 : sum_points_x_4_d1;
    wire [31:0] add_f32_ftz_unit_copy4_a_choice_3 = add_f32_ftz_unit_copy4_phase[1] ? add_f32_ftz_unit_copy4_a_choice : add_f32_ftz_unit_copy4_a_choice_2;
    wire [31:0] add_f32_ftz_unit_copy4_a_choice_4 = add_f32_ftz_unit_copy4_phase[0] ? sum_points_y_2_d1 : sum_weight_4_d1;
    wire [31:0] add_f32_ftz_unit_copy4_a_choice_5 = add_f32_ftz_unit_copy4_phase[0] ? sum_normals_z_0_d1 : in_sum_normals_y_0;
    wire [31:0] add_f32_ftz_unit_copy4_a_choice_6 = add_f32_ftz_unit_copy4_phase[1] ? add_f32_ftz_unit_copy4_a_choice_4 : add_f32_ftz_unit_copy4_a_choice_5;
    wire [31:0] add_f32_ftz_unit_copy4_b_choice = add_f32_ftz_unit_copy4_phase_copy2[0] ? {~state_start_z_d1[31], state_start_z_d1[30:0]} : add_f32_ftz_unit_copy3_y;
    wire [31:0] add_f32_ftz_unit_copy4_b_choice_2 = add_f32_ftz_unit_copy4_phase_copy2[0] ? sum_points_z_1_d1 : sum_points_x_5_d1;
    wire [31:0] add_f32_ftz_unit_copy4_b_choice_3 = add_f32_ftz_unit_copy4_phase_copy2[1] ? add_f32_ftz_unit_copy4_b_choice : add_f32_ftz_unit_copy4_b_choice_2;
    wire [31:0] add_f32_ftz_unit_copy4_b_choice_4 = add_f32_ftz_unit_copy4_phase_copy2[0] ? sum_points_y_3_d1 : sum_weight_5_d1;
    wire [31:0] add_f32_ftz_unit_copy4_b_choice_5 = add_f32_ftz_unit_copy4_phase_copy2[0] ? sum_normals_z_1_d1 : in_sum_normals_y_1;
    wire [31:0] add_f32_ftz_unit_copy4_b_choice_6 = add_f32_ftz_unit_copy4_phase_copy2[1] ? add_f32_ftz_unit_copy4_b_choice_4 : add_f32_ftz_unit_copy4_b_choice_5;
    wire [31:0] add_f32_ftz_unit_copy5_a_choice = add_f32_ftz_unit_copy5_phase[0] ? sum_points_z_2_d1 : sum_points_x_6_d1;
    wire [31:0] add_f32_ftz_unit_copy5_a_choice_2 = add_f32_ftz_unit_copy5_phase[1] ? (add_f32_ftz_unit_copy5_phase[0] ? a_x_d1 : query_position_x_d1) : add_f32_ftz_unit_copy5_a_choice;
    wire [31:0] add_f32_ftz_unit_copy5_a_choice_3 = add_f32_ftz_unit_copy5_phase[0] ? sum_points_y_4_d1 : sum_weight_6_d1;
    wire [31:0] add_f32_ftz_unit_copy5_a_choice_4 = add_f32_ftz_unit_copy5_phase[0] ? sum_normals_z_2_d1 : in_sum_normals_y_2;
    wire [31:0] add_f32_ftz_unit_copy5_a_choice_5 = add_f32_ftz_unit_copy5_phase[1] ? add_f32_ftz_unit_copy5_a_choice_3 : add_f32_ftz_unit_copy5_a_choice_4;
    wire [31:0] moved_by_x_d7 = delay_7_from_5_out[31:0];
    wire [31:0] add_f32_ftz_unit_copy5_b_choice = add_f32_ftz_unit_copy5_phase_copy2[0] ? moved_by_x_d7 : {~state_start_x_d1[31], state_start_x_d1[30:0]};
    wire [31:0] add_f32_ftz_unit_copy5_b_choice_2 = add_f32_ftz_unit_copy5_phase_copy2[0] ? sum_points_z_3_d1 : sum_points_x_7_d1;
    wire [31:0] add_f32_ftz_unit_copy5_b_choice_3 = add_f32_ftz_unit_copy5_phase_copy2[1] ? add_f32_ftz_unit_copy5_b_choice : add_f32_ftz_unit_copy5_b_choice_2;
    wire [31:0] add_f32_ftz_unit_copy5_b_choice_4 = add_f32_ftz_unit_copy5_phase_copy2[0] ? sum_points_y_5_d1 : sum_weight_7_d1;
    wire [31:0] add_f32_ftz_unit_copy5_b_choice_5 = add_f32_ftz_unit_copy5_phase_copy2[0] ? sum_normals_z_3_d1 : in_sum_normals_y_3;
    wire [31:0] add_f32_ftz_unit_copy5_b_choice_6 = add_f32_ftz_unit_copy5_phase_copy2[1] ? add_f32_ftz_unit_copy5_b_choice_4 : add_f32_ftz_unit_copy5_b_choice_5;
    wire [31:0] add_f32_ftz_unit_copy6_a_choice = add_f32_ftz_unit_copy6_phase[1] ? (add_f32_ftz_unit_copy6_phase[0] ? a_z_d1 : query_position_y_d1) : add_f32_ftz_unit_copy6_phase[0] ? sum_points_z_4_d1 : a_y_sum_d1;
    wire [31:0] add_f32_ftz_unit_copy6_a_choice_2 = add_f32_ftz_unit_copy6_phase[0] ? sum_points_y_6_d1 : magnitude_sum_d1_copy6;
    wire [31:0] add_f32_ftz_unit_copy6_a_choice_3 = add_f32_ftz_unit_copy6_phase[0] ? sum_normals_z_4_d1 : in_sum_normals_y_4;
    wire [31:0] add_f32_ftz_unit_copy6_a_choice_4 = add_f32_ftz_unit_copy6_phase[1] ? add_f32_ftz_unit_copy6_a_choice_2 : add_f32_ftz_unit_copy6_a_choice_3;
    wire [31:0] add_f32_ftz_unit_copy6_b_choice = add_f32_ftz_unit_copy6_phase_copy2[0] ? delay_8_from_6_out : {~state_start_y_d1[31], state_start_y_d1[30:0]};
    wire [31:0] add_f32_ftz_unit_copy6_b_choice_2 = add_f32_ftz_unit_copy6_phase_copy2[0] ? sum_points_z_5_d1 : a_y_sum_d1_copy2;
    wire [31:0] add_f32_ftz_unit_copy6_b_choice_3 = add_f32_ftz_unit_copy6_phase_copy2[1] ? add_f32_ftz_unit_copy6_b_choice : add_f32_ftz_unit_copy6_b_choice_2;
    wire [31:0] add_f32_ftz_unit_copy6_b_choice_4 = add_f32_ftz_unit_copy6_phase_copy2[0] ? sum_points_y_7_d1 : magnitude_sum_d1_copy7;
    wire [31:0] add_f32_ftz_unit_copy6_b_choice_5 = add_f32_ftz_unit_copy6_phase_copy2[0] ? sum_normals_z_5_d1 : in_sum_normals_y_5;
    wire [31:0] add_f32_ftz_unit_copy6_b_choice_6 = add_f32_ftz_unit_copy6_phase_copy2[1] ? add_f32_ftz_unit_copy6_b_choice_4 : add_f32_ftz_unit_copy6_b_choice_5;
    wire [31:0] state_start_z_d13 = delay_12_from_0_out[95:64];
    wire [31:0] add_f32_ftz_unit_copy7_a_choice = add_f32_ftz_unit_copy7_phase[0] ? sum_points_z_6_d1 : a_y_sum_d1_copy3;
    wire [31:0] add_f32_ftz_unit_copy7_a_choice_2 = add_f32_ftz_unit_copy7_phase[1] ? (add_f32_ftz_unit_copy7_phase[0] ? state_start_z_d13 : a_y_d1) : add_f32_ftz_unit_copy7_a_choice;
    wire [31:0] add_f32_ftz_unit_copy7_a_choice_3 = add_f32_ftz_unit_copy7_phase[0] ? magnitude_sum_d1_copy8 : magnitude_sum_d1_copy9;
    wire [31:0] add_f32_ftz_unit_copy7_a_choice_4 = add_f32_ftz_unit_copy7_phase[0] ? sum_normals_z_6_d1 : in_sum_normals_y_6;
    wire [31:0] add_f32_ftz_unit_copy7_a_choice_5 = add_f32_ftz_unit_copy7_phase[1] ? add_f32_ftz_unit_copy7_a_choice_3 : add_f32_ftz_unit_copy7_a_choice_4;
    wire [31:0] moved_by_y_d7 = delay_7_from_5_out[63:32];
    wire [31:0] add_f32_ftz_unit_copy7_b_choice = add_f32_ftz_unit_copy7_phase_copy2[0] ? mul_f32_ftz_unit_y : moved_by_y_d7;
    wire [31:0] add_f32_ftz_unit_copy7_b_choice_2 = add_f32_ftz_unit_copy7_phase_copy2[0] ? sum_points_z_7_d1 : a_y_sum_d1_copy4;
    wire [31:0] add_f32_ftz_unit_copy7_b_choice_3 = add_f32_ftz_unit_copy7_phase_copy2[1] ? add_f32_ftz_unit_copy7_b_choice : add_f32_ftz_unit_copy7_b_choice_2;
    wire [31:0] add_f32_ftz_unit_copy7_b_choice_4 = add_f32_ftz_unit_copy7_phase_copy2[0] ? magnitude_sum_d1_copy11 : magnitude_sum_d1_copy10;
    wire [31:0] add_f32_ftz_unit_copy7_b_choice_5 = add_f32_ftz_unit_copy7_phase_copy2[0] ? sum_normals_z_7_d1 : in_sum_normals_y_7;
    wire [31:0] add_f32_ftz_unit_copy7_b_choice_6 = add_f32_ftz_unit_copy7_phase_copy2[1] ? add_f32_ftz_unit_copy7_b_choice_4 : add_f32_ftz_unit_copy7_b_choice_5;
    wire [31:0] mul_f32_ftz_unit_a_choice = mul_f32_ftz_unit_phase[0] ? magnitude_sum_d1_copy5 : recip_f32_ftz_unit_y;
    wire [31:0] mul_f32_ftz_unit_a_choice_2 = mul_f32_ftz_unit_phase[1] ? mul_f32_ftz_unit_a_choice : mul_f32_ftz_unit_phase[0] ? delay_5_from_5_out : n_y_d1;
    wire [31:0] mul_f32_ftz_unit_a_choice_3 = mul_f32_ftz_unit_phase[1] ? inverse_weight_d1 : mul_f32_ftz_unit_phase[0] ? n_z_d3 : inverse_weight_d1;
    wire [31:0] mul_f32_ftz_unit_b_choice = mul_f32_ftz_unit_phase_copy2[0] ? magnitude_sum_d1_copy5 : a_y_sum_d4;
    wire [31:0] mul_f32_ftz_unit_b_choice_2 = mul_f32_ftz_unit_phase_copy2[0] ? rsqrt_f32_ftz_unit_y : from_start_y_d1;
    wire [31:0] mul_f32_ftz_unit_b_choice_3 = mul_f32_ftz_unit_phase_copy2[1] ? mul_f32_ftz_unit_b_choice : mul_f32_ftz_unit_b_choice_2;
    wire [31:0] mul_f32_ftz_unit_b_choice_4 = mul_f32_ftz_unit_phase_copy2[1] ? a_z_sum_d4 : mul_f32_ftz_unit_phase_copy2[0] ? along_d1 : a_x_sum_d4;
    wire [31:0] mul_f32_ftz_unit_copy2_b_choice = mul_f32_ftz_unit_copy2_phase[1] ? mul_f32_ftz_unit_y : inverse_length_d1;
    wire [31:0] mul_add_f32_ftz_unit_a_choice = mul_add_f32_ftz_unit_phase[0] ? mul_f32_ftz_unit_copy2_y : n_z_d1;
    wire [31:0] mul_add_f32_ftz_unit_a_choice_2 = mul_add_f32_ftz_unit_phase[1] ? (mul_add_f32_ftz_unit_phase[0] ? magnitude_sum_d1_copy12 : a_x_d2) : mul_add_f32_ftz_unit_a_choice;
    wire [31:0] mul_add_f32_ftz_unit_a_choice_3 = mul_add_f32_ftz_unit_phase[0] ? a_z_d3 : add_f32_ftz_unit_copy3_y;
    wire [31:0] mul_add_f32_ftz_unit_a_choice_4 = mul_add_f32_ftz_unit_phase[1] ? (mul_add_f32_ftz_unit_phase[0] ? n_y_d3 : n_x_d3) : mul_add_f32_ftz_unit_a_choice_3;
    wire [31:0] mul_add_f32_ftz_unit_b_choice = mul_add_f32_ftz_unit_phase_copy2[0] ? magnitude_sum_d1_copy12 : n_x_d1;
    wire [31:0] mul_add_f32_ftz_unit_b_choice_2 = mul_add_f32_ftz_unit_phase_copy2[0] ? from_start_x_d1 : from_start_z_d1;
    wire [31:0] mul_add_f32_ftz_unit_b_choice_3 = mul_add_f32_ftz_unit_phase_copy2[1] ? mul_add_f32_ftz_unit_b_choice : mul_add_f32_ftz_unit_b_choice_2;
    wire [31:0] mul_add_f32_ftz_unit_b_choice_4 = mul_add_f32_ftz_unit_phase_copy2[0] ? n_z_d2 : add_f32_ftz_unit_copy3_y;
    wire [31:0] mul_add_f32_ftz_unit_b_choice_5 = mul_add_f32_ftz_unit_phase_copy2[1] ? along_d1 : mul_add_f32_ftz_unit_b_choice_4;
    wire [31:0] state_start_x_d13 = delay_12_from_0_out[31:0];
    wire [31:0] mul_add_f32_ftz_unit_c_choice = mul_add_f32_ftz_unit_phase_copy3[0] ? state_start_x_d13 : residual_sum_d1;
    wire [31:0] mul_add_f32_ftz_unit_c_choice_2 = mul_add_f32_ftz_unit_phase_copy3[0] ? mul_f32_ftz_unit_y : mul_add_f32_ftz_unit_y;
    wire [31:0] mul_add_f32_ftz_unit_c_choice_3 = mul_add_f32_ftz_unit_phase_copy3[1] ? mul_add_f32_ftz_unit_c_choice : mul_add_f32_ftz_unit_c_choice_2;
    wire [31:0] mul_add_f32_ftz_unit_c_choice_4 = mul_add_f32_ftz_unit_phase_copy3[0] ? a_y_times_n_y_d1 : mul_f32_ftz_unit_y;
    wire [31:0] state_start_y_d13 = delay_12_from_0_out[63:32];
    wire [31:0] mul_add_f32_ftz_unit_c_choice_5 = mul_add_f32_ftz_unit_phase_copy3[0] ? mul_add_f32_ftz_unit_y : state_start_y_d13;
    wire [31:0] mul_add_f32_ftz_unit_c_choice_6 = mul_add_f32_ftz_unit_phase_copy3[1] ? mul_add_f32_ftz_unit_c_choice_4 : mul_add_f32_ftz_unit_c_choice_5;
    wire there = weighs_d3 & lt_f32_ftz_unit_copy2_y;

    assign {out_thread, out_output_position_x, out_output_position_y, out_output_position_z} = queue_1_out_data;
    assign {out_output_normal_x, out_output_normal_y, out_output_normal_z, out_output_residual} = queue_2_out_data;
    assign {
        out_output_valid, out_moved_position_x, out_moved_position_y, out_moved_position_z, out_move,
        out_done, out_search
    } = queue_3_out_data;

    float_add_s6_f32ftz add_f32_ftz_unit (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_a), .b(add_f32_ftz_unit_b), .y(add_f32_ftz_unit_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy2_a), .b(add_f32_ftz_unit_copy2_b),
        .y(add_f32_ftz_unit_copy2_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy3 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy3_a), .b(add_f32_ftz_unit_copy3_b),
        .y(add_f32_ftz_unit_copy3_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy4 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy4_a), .b(add_f32_ftz_unit_copy4_b),
        .y(add_f32_ftz_unit_copy4_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy5 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy5_a), .b(add_f32_ftz_unit_copy5_b),
        .y(add_f32_ftz_unit_copy5_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy6 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy6_a), .b(add_f32_ftz_unit_copy6_b),
        .y(add_f32_ftz_unit_copy6_y)
    );

    float_add_s6_f32ftz add_f32_ftz_unit_copy7 (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy7_a), .b(add_f32_ftz_unit_copy7_b),
        .y(add_f32_ftz_unit_copy7_y)
    );

    float_recip_s28_f32ftz recip_f32_ftz_unit (
        .clk(clk), .enable(1'd1), .a(add_f32_ftz_unit_copy2_y), .y(recip_f32_ftz_unit_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_a), .b(mul_f32_ftz_unit_b), .y(mul_f32_ftz_unit_y)
    );

    float_mul_s5_f32ftz mul_f32_ftz_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(mul_f32_ftz_unit_copy2_a), .b(mul_f32_ftz_unit_copy2_b),
        .y(mul_f32_ftz_unit_copy2_y)
    );

    mul_add_p5_s6_f32ftz mul_add_f32_ftz_unit (
        .clk(clk), .enable(1'd1), .a(mul_add_f32_ftz_unit_a), .b(mul_add_f32_ftz_unit_b),
        .c(mul_add_f32_ftz_unit_c), .y(mul_add_f32_ftz_unit_y)
    );

    float_rsqrt_s26_f32ftz rsqrt_f32_ftz_unit (
        .clk(clk), .enable(1'd1), .a(mul_add_f32_ftz_unit_y), .y(rsqrt_f32_ftz_unit_y)
    );

    float_lt_s2_f32ftz lt_f32_ftz_unit (
        .clk(clk), .enable(1'd1), .a(32'd0), .b(add_f32_ftz_unit_copy2_y), .y(lt_f32_ftz_unit_y)
    );

    float_lt_s2_f32ftz lt_f32_ftz_unit_copy2 (
        .clk(clk), .enable(1'd1), .a(32'd0), .b(mul_add_f32_ftz_unit_y), .y(lt_f32_ftz_unit_copy2_y)
    );

    float_lt_s2_f32ftz lt_f32_ftz_unit_copy3 (
        .clk(clk), .enable(1'd1), .a(distance), .b(32'h7e967699), .y(lt_f32_ftz_unit_copy3_y)
    );

    float_le_s2_f32ftz le_f32_ftz_unit (
        .clk(clk), .enable(1'd1), .a(distance), .b(setting_tolerance), .y(le_f32_ftz_unit_y)
    );

    stream_fifo_d16_w103_distributed queue_1 (
        .clk(clk), .rst(rst), .in_valid(kept), .in_ready(queue_1_in_ready),
        .in_data({delay_14_from_0_out, surface_x_d1, surface_y, surface_z_d1}),
        .out_valid(out_valid), .out_ready(out_ready), .out_data(queue_1_out_data)
    );

    stream_fifo_d16_w128_distributed queue_2 (
        .clk(clk), .rst(rst), .in_valid(kept), .in_ready(queue_2_in_ready),
        .in_data({normal_x_d1, normal_y_d1, normal_z_d1, residual_there_d1}),
        .out_valid(queue_2_out_valid), .out_ready(out_ready), .out_data(queue_2_out_data)
    );

    stream_fifo_d16_w100_distributed queue_3 (
        .clk(clk), .rst(rst), .in_valid(kept), .in_ready(queue_3_in_ready),
        .in_data({valid_d1, surface_x_d1, surface_y, surface_z_d1, 1'd1, finished_d1, 1'd1}),
        .out_valid(queue_3_out_valid), .out_ready(out_ready), .out_data(queue_3_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            credits <= 5'd15;
            phases_1 <= 8'd1;
            delay_6_from_0_pointer <= 3'd0;
            phases_2 <= 8'd1;
            delay_12_from_0_pointer <= 4'd0;
            phases_3 <= 8'd1;
            delay_13_from_0_pointer <= 4'd0;
            delay_14_from_0_pointer <= 4'd0;
            delay_5_from_2_pointer <= 2'd0;
            delay_5_from_5_pointer <= 2'd0;
            delay_7_from_5_pointer <= 3'd0;
            delay_8_from_5_pointer <= 3'd0;
            delay_8_from_6_pointer <= 3'd0;
            phases_4 <= 8'd1;
            phases_5 <= 8'd1;
            phases_6 <= 8'd1;
            phases_7 <= 8'd1;
            phases_8 <= 8'd1;
            phases_9 <= 8'd1;
            phases_10 <= 8'd1;
            phases_11 <= 8'd1;
            phases_12 <= 8'd1;
            phases_13 <= 8'd1;
            phases_14 <= 8'd1;
            phases_15 <= 8'd1;
            phases_16 <= 8'd1;
            phases_17 <= 8'd1;
            add_f32_ftz_unit_phase <= 3'd0;
            add_f32_ftz_unit_phase_copy2 <= 3'd0;
            add_f32_ftz_unit_copy2_phase <= 3'd0;
            add_f32_ftz_unit_copy2_phase_copy2 <= 3'd0;
            add_f32_ftz_unit_copy3_phase <= 3'd0;
            add_f32_ftz_unit_copy3_phase_copy2 <= 3'd0;
            add_f32_ftz_unit_copy4_phase <= 3'd0;
            add_f32_ftz_unit_copy4_phase_copy2 <= 3'd0;
            add_f32_ftz_unit_copy5_phase <= 3'd0;
            add_f32_ftz_unit_copy5_phase_copy2 <= 3'd0;
            add_f32_ftz_unit_copy6_phase <= 3'd0;
            add_f32_ftz_unit_copy6_phase_copy2 <= 3'd0;
            add_f32_ftz_unit_copy7_phase <= 3'd0;
            add_f32_ftz_unit_copy7_phase_copy2 <= 3'd0;
            mul_f32_ftz_unit_phase <= 3'd0;
            mul_f32_ftz_unit_phase_copy2 <= 3'd0;
            mul_f32_ftz_unit_copy2_phase <= 3'd0;
            mul_add_f32_ftz_unit_phase <= 3'd0;
            mul_add_f32_ftz_unit_phase_copy2 <= 3'd0;
            mul_add_f32_ftz_unit_phase_copy3 <= 3'd0;
            in_flight <= 14'd0;
            left <= 1'd0;
        end else begin
            credits <= (credits - {4'd0, in_valid_and_in_ready}) + {4'd0, left};
            phases_1 <= {phases_1[6:0], phases_1[7]};
            phases_2 <= {phases_2[6:0], phases_2[7]};
            phases_3 <= {phases_3[6:0], phases_3[7]};
            phases_4 <= {phases_4[6:0], phases_4[7]};
            phases_5 <= {phases_5[6:0], phases_5[7]};
            phases_6 <= {phases_6[6:0], phases_6[7]};
            phases_7 <= {phases_7[6:0], phases_7[7]};
            phases_8 <= {phases_8[6:0], phases_8[7]};
            phases_9 <= {phases_9[6:0], phases_9[7]};
            phases_10 <= {phases_10[6:0], phases_10[7]};
            phases_11 <= {phases_11[6:0], phases_11[7]};
            phases_12 <= {phases_12[6:0], phases_12[7]};
            phases_13 <= {phases_13[6:0], phases_13[7]};
            phases_14 <= {phases_14[6:0], phases_14[7]};
            phases_15 <= {phases_15[6:0], phases_15[7]};
            phases_16 <= {phases_16[6:0], phases_16[7]};
            phases_17 <= {phases_17[6:0], phases_17[7]};
            add_f32_ftz_unit_phase <= (add_f32_ftz_unit_phase == 3'd7) ? (add_f32_ftz_unit_phase - 3'd7) : (add_f32_ftz_unit_phase + 3'd1);
            add_f32_ftz_unit_phase_copy2 <= (add_f32_ftz_unit_phase_copy2 == 3'd7) ? (add_f32_ftz_unit_phase_copy2 - 3'd7) : (add_f32_ftz_unit_phase_copy2 + 3'd1);
            add_f32_ftz_unit_copy2_phase <= (add_f32_ftz_unit_copy2_phase == 3'd7) ? (add_f32_ftz_unit_copy2_phase - 3'd7) : (add_f32_ftz_unit_copy2_phase + 3'd1);
            add_f32_ftz_unit_copy2_phase_copy2 <= (add_f32_ftz_unit_copy2_phase_copy2 == 3'd7) ? (add_f32_ftz_unit_copy2_phase_copy2 - 3'd7) : (add_f32_ftz_unit_copy2_phase_copy2 + 3'd1);
            add_f32_ftz_unit_copy3_phase <= (add_f32_ftz_unit_copy3_phase == 3'd7) ? (add_f32_ftz_unit_copy3_phase - 3'd7) : (add_f32_ftz_unit_copy3_phase + 3'd1);
            add_f32_ftz_unit_copy3_phase_copy2 <= (add_f32_ftz_unit_copy3_phase_copy2 == 3'd7) ? (add_f32_ftz_unit_copy3_phase_copy2 - 3'd7) : (add_f32_ftz_unit_copy3_phase_copy2 + 3'd1);
            add_f32_ftz_unit_copy4_phase <= (add_f32_ftz_unit_copy4_phase == 3'd7) ? (add_f32_ftz_unit_copy4_phase - 3'd7) : (add_f32_ftz_unit_copy4_phase + 3'd1);
            add_f32_ftz_unit_copy4_phase_copy2 <= (add_f32_ftz_unit_copy4_phase_copy2 == 3'd7) ? (add_f32_ftz_unit_copy4_phase_copy2 - 3'd7) : (add_f32_ftz_unit_copy4_phase_copy2 + 3'd1);
            add_f32_ftz_unit_copy5_phase <= (add_f32_ftz_unit_copy5_phase == 3'd7) ? (add_f32_ftz_unit_copy5_phase - 3'd7) : (add_f32_ftz_unit_copy5_phase + 3'd1);
            add_f32_ftz_unit_copy5_phase_copy2 <= (add_f32_ftz_unit_copy5_phase_copy2 == 3'd7) ? (add_f32_ftz_unit_copy5_phase_copy2 - 3'd7) : (add_f32_ftz_unit_copy5_phase_copy2 + 3'd1);
            add_f32_ftz_unit_copy6_phase <= (add_f32_ftz_unit_copy6_phase == 3'd7) ? (add_f32_ftz_unit_copy6_phase - 3'd7) : (add_f32_ftz_unit_copy6_phase + 3'd1);
            add_f32_ftz_unit_copy6_phase_copy2 <= (add_f32_ftz_unit_copy6_phase_copy2 == 3'd7) ? (add_f32_ftz_unit_copy6_phase_copy2 - 3'd7) : (add_f32_ftz_unit_copy6_phase_copy2 + 3'd1);
            add_f32_ftz_unit_copy7_phase <= (add_f32_ftz_unit_copy7_phase == 3'd7) ? (add_f32_ftz_unit_copy7_phase - 3'd7) : (add_f32_ftz_unit_copy7_phase + 3'd1);
            add_f32_ftz_unit_copy7_phase_copy2 <= (add_f32_ftz_unit_copy7_phase_copy2 == 3'd7) ? (add_f32_ftz_unit_copy7_phase_copy2 - 3'd7) : (add_f32_ftz_unit_copy7_phase_copy2 + 3'd1);
            mul_f32_ftz_unit_phase <= (mul_f32_ftz_unit_phase == 3'd7) ? (mul_f32_ftz_unit_phase - 3'd7) : (mul_f32_ftz_unit_phase + 3'd1);
            mul_f32_ftz_unit_phase_copy2 <= (mul_f32_ftz_unit_phase_copy2 == 3'd7) ? (mul_f32_ftz_unit_phase_copy2 - 3'd7) : (mul_f32_ftz_unit_phase_copy2 + 3'd1);
            mul_f32_ftz_unit_copy2_phase <= (mul_f32_ftz_unit_copy2_phase == 3'd7) ? (mul_f32_ftz_unit_copy2_phase - 3'd7) : (mul_f32_ftz_unit_copy2_phase + 3'd1);
            mul_add_f32_ftz_unit_phase <= (mul_add_f32_ftz_unit_phase == 3'd7) ? (mul_add_f32_ftz_unit_phase - 3'd7) : (mul_add_f32_ftz_unit_phase + 3'd1);
            mul_add_f32_ftz_unit_phase_copy2 <= (mul_add_f32_ftz_unit_phase_copy2 == 3'd7) ? (mul_add_f32_ftz_unit_phase_copy2 - 3'd7) : (mul_add_f32_ftz_unit_phase_copy2 + 3'd1);
            mul_add_f32_ftz_unit_phase_copy3 <= (mul_add_f32_ftz_unit_phase_copy3 == 3'd7) ? (mul_add_f32_ftz_unit_phase_copy3 - 3'd7) : (mul_add_f32_ftz_unit_phase_copy3 + 3'd1);
            left <= out_valid & out_ready;
            if (phases_1[0]) begin
                delay_6_from_0_pointer <= (delay_6_from_0_pointer == 3'd4) ? (delay_6_from_0_pointer - 3'd4) : (delay_6_from_0_pointer + 3'd1);
                delay_14_from_0_pointer <= (delay_14_from_0_pointer == 4'd12) ? (delay_14_from_0_pointer - 4'd12) : (delay_14_from_0_pointer + 4'd1);
                in_flight <= {in_flight[12:0], in_valid_and_in_ready};
            end
            if (phases_2[0]) begin
                delay_12_from_0_pointer <= (delay_12_from_0_pointer == 4'd10) ? (delay_12_from_0_pointer - 4'd10) : (delay_12_from_0_pointer + 4'd1);
            end
            if (phases_3[0]) begin
                delay_13_from_0_pointer <= (delay_13_from_0_pointer == 4'd11) ? (delay_13_from_0_pointer - 4'd11) : (delay_13_from_0_pointer + 4'd1);
            end
            if (phases_1[2]) begin
                delay_5_from_2_pointer <= (delay_5_from_2_pointer == 2'd3) ? (delay_5_from_2_pointer - 2'd3) : (delay_5_from_2_pointer + 2'd1);
            end
            if (phases_1[5]) begin
                delay_5_from_5_pointer <= (delay_5_from_5_pointer == 2'd3) ? (delay_5_from_5_pointer - 2'd3) : (delay_5_from_5_pointer + 2'd1);
                delay_7_from_5_pointer <= (delay_7_from_5_pointer == 3'd5) ? (delay_7_from_5_pointer - 3'd5) : (delay_7_from_5_pointer + 3'd1);
                delay_8_from_5_pointer <= (delay_8_from_5_pointer == 3'd6) ? (delay_8_from_5_pointer - 3'd6) : (delay_8_from_5_pointer + 3'd1);
            end
            if (phases_1[6]) begin
                delay_8_from_6_pointer <= (delay_8_from_6_pointer == 3'd6) ? (delay_8_from_6_pointer - 3'd6) : (delay_8_from_6_pointer + 3'd1);
            end
        end
    end
    always @(posedge clk) begin
        if (phases_1[0]) begin
            query_position_x_d1 <= in_query_position_x;
            query_position_y_d1 <= in_query_position_y;
        end
        if (phases_4[0]) begin
            query_position_z_d1 <= in_query_position_z;
            state_start_x_d1 <= in_state_start_x;
            state_start_y_d1 <= in_state_start_y;
            state_start_z_d1 <= in_state_start_z;
        end
        if (phases_5[0]) begin
            sum_weight_0_d1 <= in_sum_weight_0;
            sum_weight_1_d1 <= in_sum_weight_1;
            sum_weight_2_d1 <= in_sum_weight_2;
            sum_weight_3_d1 <= in_sum_weight_3;
        end
        if (phases_6[0]) begin
            sum_weight_4_d1 <= in_sum_weight_4;
            sum_weight_5_d1 <= in_sum_weight_5;
            sum_weight_6_d1 <= in_sum_weight_6;
            sum_weight_7_d1 <= in_sum_weight_7;
        end
        if (phases_7[0]) begin
            sum_points_x_0_d1 <= in_sum_points_x_0;
            sum_points_x_1_d1 <= in_sum_points_x_1;
            sum_points_x_2_d1 <= in_sum_points_x_2;
            sum_points_x_3_d1 <= in_sum_points_x_3;
        end
        if (phases_8[0]) begin
            sum_points_x_4_d1 <= in_sum_points_x_4;
            sum_points_x_5_d1 <= in_sum_points_x_5;
            sum_points_x_6_d1 <= in_sum_points_x_6;
            sum_points_x_7_d1 <= in_sum_points_x_7;
        end
        if (phases_9[0]) begin
            sum_points_y_0_d1 <= in_sum_points_y_0;
            sum_points_y_1_d1 <= in_sum_points_y_1;
            sum_points_y_2_d1 <= in_sum_points_y_2;
            sum_points_y_3_d1 <= in_sum_points_y_3;
        end
        if (phases_10[0]) begin
            sum_points_y_4_d1 <= in_sum_points_y_4;
            sum_points_y_5_d1 <= in_sum_points_y_5;
            sum_points_y_6_d1 <= in_sum_points_y_6;
            sum_points_y_7_d1 <= in_sum_points_y_7;
        end
        if (phases_11[0]) begin
            sum_points_z_0_d1 <= in_sum_points_z_0;
            sum_points_z_1_d1 <= in_sum_points_z_1;
            sum_points_z_2_d1 <= in_sum_points_z_2;
            sum_points_z_3_d1 <= in_sum_points_z_3;
        end
        if (phases_12[0]) begin
            sum_points_z_4_d1 <= in_sum_points_z_4;
            sum_points_z_5_d1 <= in_sum_points_z_5;
            sum_points_z_6_d1 <= in_sum_points_z_6;
            sum_points_z_7_d1 <= in_sum_points_z_7;
        end
        if (phases_13[0]) begin
            sum_normals_x_6_d1 <= in_sum_normals_x_6;
            sum_normals_x_7_d1 <= in_sum_normals_x_7;
            sum_normals_z_0_d1 <= in_sum_normals_z_0;
            sum_normals_z_1_d1 <= in_sum_normals_z_1;
        end
        if (phases_14[0]) begin
            sum_normals_z_2_d1 <= in_sum_normals_z_2;
            sum_normals_z_3_d1 <= in_sum_normals_z_3;
            sum_normals_z_4_d1 <= in_sum_normals_z_4;
            sum_normals_z_5_d1 <= in_sum_normals_z_5;
        end
        if (phases_15[0]) begin
            sum_normals_z_6_d1 <= in_sum_normals_z_6;
            sum_normals_z_7_d1 <= in_sum_normals_z_7;
            magnitude_sum_d1_copy3 <= add_f32_ftz_unit_y;
            magnitude_sum_d1_copy4 <= add_f32_ftz_unit_copy2_y;
        end
        if (phases_1[1]) begin
            sum_weight_0_plus_sum_weight_1_d1 <= add_f32_ftz_unit_y;
            sum_weight_2_plus_sum_weight_3_d1 <= add_f32_ftz_unit_copy2_y;
            inverse_weight_sum_d1 <= add_f32_ftz_unit_copy3_y;
            sum_weight_4_plus_sum_weight_5_d1 <= add_f32_ftz_unit_copy4_y;
        end
        if (phases_2[1]) begin
            sum_weight_6_plus_sum_weight_7_d1 <= add_f32_ftz_unit_copy5_y;
            a_z_d1 <= mul_f32_ftz_unit_y;
            a_z_d2 <= a_z_d1;
            a_z_d3 <= a_z_d2;
        end
        if (phases_1[2]) begin
            inverse_weight_sum_d1_copy2 <= add_f32_ftz_unit_y;
            a_y_sum_d1 <= add_f32_ftz_unit_copy3_y;
        end
        if (phases_1[6]) begin
            inverse_weight_d1 <= recip_f32_ftz_unit_y;
            a_x_d1 <= mul_f32_ftz_unit_y;
        end
        if (phases_1[3]) begin
            a_x_sum_d1 <= add_f32_ftz_unit_y;
            a_x_sum_d1_copy2 <= add_f32_ftz_unit_copy2_y;
            a_x_sum_plus_a_x_sum_d1 <= add_f32_ftz_unit_copy3_y;
            a_x_sum_d1_copy3 <= add_f32_ftz_unit_copy4_y;
        end
        if (phases_2[3]) begin
            a_x_sum_d1_copy4 <= add_f32_ftz_unit_copy5_y;
            a_y_sum_plus_a_y_sum_d1 <= add_f32_ftz_unit_copy6_y;
            a_y_sum_plus_a_y_sum_d1_copy2 <= add_f32_ftz_unit_copy7_y;
            n_y_d1 <= mul_f32_ftz_unit_y;
        end
        if (phases_1[4]) begin
            a_x_sum_plus_a_x_sum_d1_copy2 <= add_f32_ftz_unit_y;
            a_x_sum_d1_copy5 <= add_f32_ftz_unit_copy2_y;
            a_x_sum_d2 <= a_x_sum_d1_copy5;
            a_x_sum_d3 <= a_x_sum_d2;
        end
        if (phases_2[4]) begin
            a_x_sum_d4 <= a_x_sum_d3;
            a_y_sum_d1_copy5 <= add_f32_ftz_unit_copy3_y;
            a_y_sum_d2 <= a_y_sum_d1_copy5;
            a_y_sum_d3 <= a_y_sum_d2;
        end
        if (phases_2[2]) begin
            a_y_sum_d1_copy2 <= add_f32_ftz_unit_copy4_y;
            a_y_sum_d1_copy3 <= add_f32_ftz_unit_copy5_y;
            a_y_sum_d1_copy4 <= add_f32_ftz_unit_copy6_y;
            magnitude_sum_d1_copy12 <= add_f32_ftz_unit_copy7_y;
        end
        if (phases_3[4]) begin
            a_y_sum_d4 <= a_y_sum_d3;
            a_z_sum_d1 <= add_f32_ftz_unit_copy4_y;
            a_z_sum_d1_copy2 <= add_f32_ftz_unit_copy5_y;
            a_z_sum_d1_copy3 <= add_f32_ftz_unit_copy6_y;
        end
        if (phases_2[5]) begin
            a_z_sum_plus_a_z_sum_d1 <= add_f32_ftz_unit_y;
            a_z_sum_plus_a_z_sum_d1_copy2 <= add_f32_ftz_unit_copy2_y;
            a_z_sum_d1_copy5 <= add_f32_ftz_unit_copy3_y;
            a_z_sum_d2 <= a_z_sum_d1_copy5;
        end
        if (phases_4[4]) begin
            a_z_sum_d1_copy4 <= add_f32_ftz_unit_copy7_y;
            a_y_d1 <= mul_f32_ftz_unit_y;
            a_y_d2 <= a_y_d1;
            weighs_d1 <= lt_f32_ftz_unit_y;
            weighs_d2 <= weighs_d1;
            weighs_d3 <= weighs_d2;
        end
        if (phases_3[5]) begin
            a_z_sum_d3 <= a_z_sum_d2;
            a_z_sum_d4 <= a_z_sum_d3;
            magnitude_sum_d1_copy5 <= add_f32_ftz_unit_copy4_y;
            inverse_length_d1 <= rsqrt_f32_ftz_unit_y;
        end
        if (phases_2[6]) begin
            a_x_d2 <= a_x_d1;
            magnitude_sum_d1 <= add_f32_ftz_unit_y;
            from_start_x_d1 <= add_f32_ftz_unit_copy5_y;
            from_start_z_d1 <= add_f32_ftz_unit_copy6_y;
        end
        if (phases_1[7]) begin
            magnitude_sum_d1_copy2 <= add_f32_ftz_unit_copy3_y;
            n_z_d1 <= mul_f32_ftz_unit_copy2_y;
            n_z_d2 <= n_z_d1;
            n_z_d3 <= n_z_d2;
        end
        if (phases_16[0]) begin
            magnitude_sum_d1_copy6 <= add_f32_ftz_unit_copy4_y;
            magnitude_sum_d1_copy7 <= add_f32_ftz_unit_copy5_y;
            magnitude_sum_d1_copy9 <= add_f32_ftz_unit_copy6_y;
            magnitude_sum_d1_copy10 <= add_f32_ftz_unit_copy7_y;
        end
        if (phases_3[1]) begin
            magnitude_sum_d1_copy8 <= add_f32_ftz_unit_copy6_y;
            magnitude_sum_d1_copy11 <= add_f32_ftz_unit_copy7_y;
            a_y_times_n_y_d1 <= mul_f32_ftz_unit_copy2_y;
        end
        if (phases_4[5]) begin
            n_x_d1 <= mul_f32_ftz_unit_copy2_y;
            n_x_d2 <= n_x_d1;
            n_x_d3 <= n_x_d2;
            n_x_d4 <= n_x_d3;
        end
        if (phases_3[3]) begin
            n_y_d2 <= n_y_d1;
            n_y_d3 <= n_y_d2;
            n_y_d4 <= n_y_d3;
        end
        if (phases_3[2]) residual_sum_d1 <= mul_add_f32_ftz_unit_y;
        if (phases_5[5]) begin
            residual_d1 <= mul_add_f32_ftz_unit_y;
            from_start_y_d1 <= add_f32_ftz_unit_copy7_y;
        end
        if (phases_2[7]) begin
            valid_d1 <= valid;
            normal_x_d1 <= normal_x;
            normal_y_d1 <= normal_y;
            normal_z_d1 <= normal_z;
            finished_d1 <= finished;
        end
        if (phases_17[0]) along_d1 <= mul_add_f32_ftz_unit_y;
        if (phases_3[6]) begin
            surface_x_d1 <= surface_x;
            surface_z_d1 <= surface_z;
        end
        if (phases_3[7]) residual_there_d1 <= residual_there;
        add_f32_ftz_unit_a <= add_f32_ftz_unit_phase[2] ? add_f32_ftz_unit_a_choice : add_f32_ftz_unit_a_choice_4;
        add_f32_ftz_unit_b <= add_f32_ftz_unit_phase_copy2[2] ? add_f32_ftz_unit_b_choice_3 : add_f32_ftz_unit_b_choice_6;
        add_f32_ftz_unit_copy2_a <= add_f32_ftz_unit_copy2_phase[2] ? add_f32_ftz_unit_copy2_a_choice_3 : add_f32_ftz_unit_copy2_a_choice_6;
        add_f32_ftz_unit_copy2_b <= add_f32_ftz_unit_copy2_phase_copy2[2] ? add_f32_ftz_unit_copy2_b_choice_3 : add_f32_ftz_unit_copy2_b_choice_6;
        add_f32_ftz_unit_copy3_a <= add_f32_ftz_unit_copy3_phase[2] ? add_f32_ftz_unit_copy3_a_choice_3 : add_f32_ftz_unit_copy3_a_choice_6;
        add_f32_ftz_unit_copy3_b <= add_f32_ftz_unit_copy3_phase_copy2[2] ? add_f32_ftz_unit_copy3_b_choice_3 : add_f32_ftz_unit_copy3_b_choice_6;
        add_f32_ftz_unit_copy4_a <= add_f32_ftz_unit_copy4_phase[2] ? add_f32_ftz_unit_copy4_a_choice_3 : add_f32_ftz_unit_copy4_a_choice_6;
        add_f32_ftz_unit_copy4_b <= add_f32_ftz_unit_copy4_phase_copy2[2] ? add_f32_ftz_unit_copy4_b_choice_3 : add_f32_ftz_unit_copy4_b_choice_6;
        add_f32_ftz_unit_copy5_a <= add_f32_ftz_unit_copy5_phase[2] ? add_f32_ftz_unit_copy5_a_choice_2 : add_f32_ftz_unit_copy5_a_choice_5;
        add_f32_ftz_unit_copy5_b <= add_f32_ftz_unit_copy5_phase_copy2[2] ? add_f32_ftz_unit_copy5_b_choice_3 : add_f32_ftz_unit_copy5_b_choice_6;
        add_f32_ftz_unit_copy6_a <= add_f32_ftz_unit_copy6_phase[2] ? add_f32_ftz_unit_copy6_a_choice : add_f32_ftz_unit_copy6_a_choice_4;
        add_f32_ftz_unit_copy6_b <= add_f32_ftz_unit_copy6_phase_copy2[2] ? add_f32_ftz_unit_copy6_b_choice_3 : add_f32_ftz_unit_copy6_b_choice_6;
        add_f32_ftz_unit_copy7_a <= add_f32_ftz_unit_copy7_phase[2] ? add_f32_ftz_unit_copy7_a_choice_2 : add_f32_ftz_unit_copy7_a_choice_5;
        add_f32_ftz_unit_copy7_b <= add_f32_ftz_unit_copy7_phase_copy2[2] ? add_f32_ftz_unit_copy7_b_choice_3 : add_f32_ftz_unit_copy7_b_choice_6;
        mul_f32_ftz_unit_a <= mul_f32_ftz_unit_phase[2] ? mul_f32_ftz_unit_a_choice_2 : mul_f32_ftz_unit_a_choice_3;
        mul_f32_ftz_unit_b <= mul_f32_ftz_unit_phase_copy2[2] ? mul_f32_ftz_unit_b_choice_3 : mul_f32_ftz_unit_b_choice_4;
        mul_f32_ftz_unit_copy2_a <= mul_f32_ftz_unit_copy2_phase[2] ? delay_6_from_0_out : mul_f32_ftz_unit_copy2_phase[1] ? a_y_d2 : delay_5_from_2_out;
        mul_f32_ftz_unit_copy2_b <= mul_f32_ftz_unit_copy2_phase[2] ? inverse_length_d1 : mul_f32_ftz_unit_copy2_b_choice;
        mul_add_f32_ftz_unit_a <= mul_add_f32_ftz_unit_phase[2] ? mul_add_f32_ftz_unit_a_choice_2 : mul_add_f32_ftz_unit_a_choice_4;
        mul_add_f32_ftz_unit_b <= mul_add_f32_ftz_unit_phase_copy2[2] ? mul_add_f32_ftz_unit_b_choice_3 : mul_add_f32_ftz_unit_b_choice_5;
        mul_add_f32_ftz_unit_c <= mul_add_f32_ftz_unit_phase_copy3[2] ? mul_add_f32_ftz_unit_c_choice_3 : mul_add_f32_ftz_unit_c_choice_6;
    end
    always @(posedge clk) begin
        if (phases_1[0]) delay_6_from_0[delay_6_from_0_pointer] <= add_f32_ftz_unit_copy3_y;
        if (phases_1[0]) delay_6_from_0_out <= delay_6_from_0[delay_6_from_0_pointer];
    end
    always @(posedge clk) begin
        if (phases_2[0]) begin
            delay_12_from_0[delay_12_from_0_pointer] <= {state_start_z_d1, state_start_y_d1, state_start_x_d1};
        end
        if (phases_2[0]) delay_12_from_0_out <= delay_12_from_0[delay_12_from_0_pointer];
    end
    always @(posedge clk) begin
        if (phases_3[0]) begin
            delay_13_from_0[delay_13_from_0_pointer] <= {query_position_z_d1, query_position_y_d1, query_position_x_d1};
        end
        if (phases_3[0]) delay_13_from_0_out <= delay_13_from_0[delay_13_from_0_pointer];
    end
    always @(posedge clk) begin
        if (phases_1[0]) delay_14_from_0[delay_14_from_0_pointer] <= in_thread;
        if (phases_1[0]) delay_14_from_0_out <= delay_14_from_0[delay_14_from_0_pointer];
    end
    always @(posedge clk) begin
        if (phases_1[2]) delay_5_from_2[delay_5_from_2_pointer] <= magnitude_sum_d1_copy12;
        if (phases_1[2]) delay_5_from_2_out <= delay_5_from_2[delay_5_from_2_pointer];
    end
    always @(posedge clk) begin
        if (phases_1[5]) delay_5_from_5[delay_5_from_5_pointer] <= magnitude_sum_d1_copy5;
        if (phases_1[5]) delay_5_from_5_out <= delay_5_from_5[delay_5_from_5_pointer];
    end
    always @(posedge clk) begin
        if (phases_1[5]) begin
            delay_7_from_5[delay_7_from_5_pointer] <= {add_f32_ftz_unit_copy6_y, add_f32_ftz_unit_copy5_y};
        end
        if (phases_1[5]) delay_7_from_5_out <= delay_7_from_5[delay_7_from_5_pointer];
    end
    always @(posedge clk) begin
        if (phases_1[5]) delay_8_from_5[delay_8_from_5_pointer] <= there;
        if (phases_1[5]) delay_8_from_5_out <= delay_8_from_5[delay_8_from_5_pointer];
    end
    always @(posedge clk) begin
        if (phases_1[6]) delay_8_from_6[delay_8_from_6_pointer] <= add_f32_ftz_unit_copy4_y;
        if (phases_1[6]) delay_8_from_6_out <= delay_8_from_6[delay_8_from_6_pointer];
    end

    wire _unused = &{1'b0, queue_1_in_ready, queue_2_in_ready, queue_2_out_valid, queue_3_in_ready, queue_3_out_valid};

`ifdef RTL_ASSERT
    wire check_both = (phases_2 == phases_1) & (phases_3 == phases_1) & (phases_4 == phases_1);
    wire check_both_2 = check_both & (phases_5 == phases_1) & (phases_6 == phases_1) & (phases_7 == phases_1);
    wire check_both_3 = check_both_2 & (phases_8 == phases_1) & (phases_9 == phases_1) & (phases_10 == phases_1);
    wire check_both_4 = check_both_3 & (phases_11 == phases_1) & (phases_12 == phases_1) & (phases_13 == phases_1);
    wire check_both_5 = check_both_4 & (phases_14 == phases_1) & (phases_15 == phases_1) & (phases_16 == phases_1);
    wire check_both_6 = check_both_5 & (phases_17 == phases_1) & ((add_f32_ftz_unit_phase == 3'd0) == phases_1[0]);
    wire check_both_7 = check_both_6 & ((add_f32_ftz_unit_phase_copy2 == 3'd0) == phases_1[0]);
    wire check_both_8 = check_both_7 & ((add_f32_ftz_unit_copy2_phase == 3'd0) == phases_1[0]);
    wire check_both_9 = check_both_8 & ((add_f32_ftz_unit_copy2_phase_copy2 == 3'd0) == phases_1[0]);
    wire check_both_10 = check_both_9 & ((add_f32_ftz_unit_copy3_phase == 3'd0) == phases_1[0]);
    wire check_both_11 = check_both_10 & ((add_f32_ftz_unit_copy3_phase_copy2 == 3'd0) == phases_1[0]);
    wire check_both_12 = check_both_11 & ((add_f32_ftz_unit_copy4_phase == 3'd0) == phases_1[0]);
    wire check_both_13 = check_both_12 & ((add_f32_ftz_unit_copy4_phase_copy2 == 3'd0) == phases_1[0]);
    wire check_both_14 = check_both_13 & ((add_f32_ftz_unit_copy5_phase == 3'd0) == phases_1[0]);
    wire check_both_15 = check_both_14 & ((add_f32_ftz_unit_copy5_phase_copy2 == 3'd0) == phases_1[0]);
    wire check_both_16 = check_both_15 & ((add_f32_ftz_unit_copy6_phase == 3'd0) == phases_1[0]);
    wire check_both_17 = check_both_16 & ((add_f32_ftz_unit_copy6_phase_copy2 == 3'd0) == phases_1[0]);
    wire check_both_18 = check_both_17 & ((add_f32_ftz_unit_copy7_phase == 3'd0) == phases_1[0]);
    wire check_both_19 = check_both_18 & ((add_f32_ftz_unit_copy7_phase_copy2 == 3'd0) == phases_1[0]);
    wire check_both_20 = check_both_19 & ((mul_f32_ftz_unit_phase == 3'd0) == phases_1[0]);
    wire check_both_21 = check_both_20 & ((mul_f32_ftz_unit_phase_copy2 == 3'd0) == phases_1[0]);
    wire check_both_22 = check_both_21 & ((mul_f32_ftz_unit_copy2_phase == 3'd0) == phases_1[0]);
    wire check_both_23 = check_both_22 & ((mul_add_f32_ftz_unit_phase == 3'd0) == phases_1[0]);
    wire check_both_24 = check_both_23 & ((mul_add_f32_ftz_unit_phase_copy2 == 3'd0) == phases_1[0]);

    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        queue_1_has_a_place_for_each_result: assert (~kept | queue_1_in_ready);
        queue_2_has_a_place_for_each_result: assert (~kept | queue_2_in_ready);
        queue_3_has_a_place_for_each_result: assert (~kept | queue_3_in_ready);
        queue_2_in_step: assert (queue_2_out_valid == out_valid);
        queue_3_in_step: assert (queue_3_out_valid == out_valid);
        phases_are_in_step: assert (check_both_24 & ((mul_add_f32_ftz_unit_phase_copy3 == 3'd0) == phases_1[0]));
`else
        if (!(~kept | queue_1_in_ready)) begin
            $display("assertion failed: queue_1_has_a_place_for_each_result in %m"); $stop;
        end
        if (!(~kept | queue_2_in_ready)) begin
            $display("assertion failed: queue_2_has_a_place_for_each_result in %m"); $stop;
        end
        if (!(~kept | queue_3_in_ready)) begin
            $display("assertion failed: queue_3_has_a_place_for_each_result in %m"); $stop;
        end
        if (!(queue_2_out_valid == out_valid)) begin
            $display("assertion failed: queue_2_in_step in %m"); $stop;
        end
        if (!(queue_3_out_valid == out_valid)) begin
            $display("assertion failed: queue_3_in_step in %m"); $stop;
        end
        if (!(check_both_24 & ((mul_add_f32_ftz_unit_phase_copy3 == 3'd0) == phases_1[0]))) begin
            $display("assertion failed: phases_are_in_step in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue in a memory with a registered output.
// depth = 16
// width = 100
// storage = distributed
module stream_fifo_d16_w100_distributed (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [99:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [99:0] out_data
);
    (* ram_style = "distributed" *)
    reg [99:0] entries [0:15];
    reg [4:0] held, waiting;
    reg is_full, any_waits;
    reg [3:0] write_address, read_address;
    reg [99:0] item;

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
    always @(posedge clk) begin
        if (has_room) entries[write_address] <= in_data;
        if (fetch) item <= entries[read_address];
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

// Queue in a memory with a registered output.
// depth = 16
// width = 128
// storage = distributed
module stream_fifo_d16_w128_distributed (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [127:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [127:0] out_data
);
    (* ram_style = "distributed" *)
    reg [127:0] entries [0:15];
    reg [4:0] held, waiting;
    reg is_full, any_waits;
    reg [3:0] write_address, read_address;
    reg [127:0] item;

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
    always @(posedge clk) begin
        if (has_room) entries[write_address] <= in_data;
        if (fetch) item <= entries[read_address];
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

// Queue in a memory with a registered output.
// depth = 16
// width = 103
// storage = distributed
module stream_fifo_d16_w103_distributed (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [102:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [102:0] out_data
);
    (* ram_style = "distributed" *)
    reg [102:0] entries [0:15];
    reg [4:0] held, waiting;
    reg is_full, any_waits;
    reg [3:0] write_address, read_address;
    reg [102:0] item;

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
    always @(posedge clk) begin
        if (has_room) entries[write_address] <= in_data;
        if (fetch) item <= entries[read_address];
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

// Whether one floating-point number is less than another or equal.
// stages = 2
// format = f32-ftz
module float_le_s2_f32ftz (
    input  wire clk, input wire enable, input wire [31:0] a, input wire [31:0] b,
    output reg  y
);
    reg unordered_s1, both_zero_s1, compared_s1;

    always @(posedge clk) begin
        if (enable) begin
            unordered_s1 <= (&a[30:23] & |a[22:0]) | (&b[30:23] & |b[22:0]);
            both_zero_s1 <= (a[30:23] == 8'd0) & (b[30:23] == 8'd0);
            compared_s1 <= {~a[31], a[30:0] ^ {31{a[31]}}} <= {~b[31], b[30:0] ^ {31{b[31]}}};
            y <= (compared_s1 | both_zero_s1) & ~unordered_s1;
        end
    end
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

// Floating-point reciprocal square root, correctly rounded.
// stages = 26
// format = f32-ftz
module float_rsqrt_s26_f32ftz (
    input  wire clk, input wire enable, input wire [31:0] a,
    output reg  [31:0] y
);
    reg [25:0] residual_s1;
    reg [27:0] threshold_s1;
    reg [26:0] triple_s1;
    reg [24:0] m_s1;
    reg [26:0] residual_s2;
    reg [28:0] threshold_s2;
    reg [1:0] root_s2;
    reg [26:0] triple_s2;
    reg [24:0] m_s2;
    reg [27:0] residual_s3;
    reg [29:0] threshold_s3;
    reg [2:0] root_s3;
    reg [26:0] triple_s3;
    reg [24:0] m_s3;
    reg [28:0] residual_s4;
    reg [30:0] threshold_s4;
    reg [3:0] root_s4;
    reg [26:0] triple_s4;
    reg [24:0] m_s4;
    reg [29:0] residual_s5;
    reg [31:0] threshold_s5;
    reg [4:0] root_s5;
    reg [26:0] triple_s5;
    reg [24:0] m_s5;
    reg [30:0] residual_s6;
    reg [32:0] threshold_s6;
    reg [5:0] root_s6;
    reg [26:0] triple_s6;
    reg [24:0] m_s6;
    reg [31:0] residual_s7;
    reg [33:0] threshold_s7;
    reg [6:0] root_s7;
    reg [26:0] triple_s7;
    reg [24:0] m_s7;
    reg [32:0] residual_s8;
    reg [34:0] threshold_s8;
    reg [7:0] root_s8;
    reg [26:0] triple_s8;
    reg [24:0] m_s8;
    reg [33:0] residual_s9;
    reg [35:0] threshold_s9;
    reg [8:0] root_s9;
    reg [26:0] triple_s9;
    reg [24:0] m_s9;
    reg [34:0] residual_s10;
    reg [36:0] threshold_s10;
    reg [9:0] root_s10;
    reg [26:0] triple_s10;
    reg [24:0] m_s10;
    reg [35:0] residual_s11;
    reg [37:0] threshold_s11;
    reg [10:0] root_s11;
    reg [26:0] triple_s11;
    reg [24:0] m_s11;
    reg [36:0] residual_s12;
    reg [38:0] threshold_s12;
    reg [11:0] root_s12;
    reg [26:0] triple_s12;
    reg [24:0] m_s12;
    reg [37:0] residual_s13;
    reg [39:0] threshold_s13;
    reg [12:0] root_s13;
    reg [26:0] triple_s13;
    reg [24:0] m_s13;
    reg [38:0] residual_s14;
    reg [40:0] threshold_s14;
    reg [13:0] root_s14;
    reg [26:0] triple_s14;
    reg [24:0] m_s14;
    reg [39:0] residual_s15;
    reg [41:0] threshold_s15;
    reg [14:0] root_s15;
    reg [26:0] triple_s15;
    reg [24:0] m_s15;
    reg [40:0] residual_s16;
    reg [42:0] threshold_s16;
    reg [15:0] root_s16;
    reg [26:0] triple_s16;
    reg [24:0] m_s16;
    reg [41:0] residual_s17;
    reg [43:0] threshold_s17;
    reg [16:0] root_s17;
    reg [26:0] triple_s17;
    reg [24:0] m_s17;
    reg [42:0] residual_s18;
    reg [44:0] threshold_s18;
    reg [17:0] root_s18;
    reg [26:0] triple_s18;
    reg [24:0] m_s18;
    reg [43:0] residual_s19;
    reg [45:0] threshold_s19;
    reg [18:0] root_s19;
    reg [26:0] triple_s19;
    reg [24:0] m_s19;
    reg [44:0] residual_s20;
    reg [46:0] threshold_s20;
    reg [19:0] root_s20;
    reg [26:0] triple_s20;
    reg [24:0] m_s20;
    reg [45:0] residual_s21;
    reg [47:0] threshold_s21;
    reg [20:0] root_s21;
    reg [26:0] triple_s21;
    reg [24:0] m_s21;
    reg [46:0] residual_s22;
    reg [48:0] threshold_s22;
    reg [21:0] root_s22;
    reg [26:0] triple_s22;
    reg [24:0] m_s22;
    reg [47:0] residual_s23;
    reg [49:0] threshold_s23;
    reg [22:0] root_s23;
    reg [26:0] triple_s23;
    reg [24:0] m_s23;
    reg [48:0] residual_s24;
    reg [50:0] threshold_s24;
    reg [23:0] root_s24;
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
    wire [22:0] m_s1_both = a_fraction & {23{|a_field}};
    wire [24:0] m_s1_choice = ~a_field[0] ? {|a_field, m_s1_both, 1'd0} : {1'd0, |a_field, m_s1_both};
    wire [27:0] threshold_s1_bits = {3'd0, m_s1_choice};
    wire [26:0] triple_s1_bits = {2'd0, m_s1_choice};
    wire [28:0] residual_s2_bits = {1'd0, residual_s1, 2'd0};
    wire [28:0] residual_s2_difference = residual_s2_bits - {1'd0, threshold_s1};
    wire [28:0] residual_s2_choice = ~residual_s2_difference[28] ? residual_s2_difference : residual_s2_bits;
    wire [29:0] residual_s3_bits = {1'd0, residual_s2, 2'd0};
    wire [29:0] residual_s3_difference = residual_s3_bits - {1'd0, threshold_s2};
    wire [29:0] residual_s3_choice = ~residual_s3_difference[29] ? residual_s3_difference : residual_s3_bits;
    wire [30:0] residual_s4_bits = {1'd0, residual_s3, 2'd0};
    wire [30:0] residual_s4_difference = residual_s4_bits - {1'd0, threshold_s3};
    wire [30:0] residual_s4_choice = ~residual_s4_difference[30] ? residual_s4_difference : residual_s4_bits;
    wire [31:0] residual_s5_bits = {1'd0, residual_s4, 2'd0};
    wire [31:0] residual_s5_difference = residual_s5_bits - {1'd0, threshold_s4};
    wire [31:0] residual_s5_choice = ~residual_s5_difference[31] ? residual_s5_difference : residual_s5_bits;
    wire [32:0] residual_s6_bits = {1'd0, residual_s5, 2'd0};
    wire [32:0] residual_s6_difference = residual_s6_bits - {1'd0, threshold_s5};
    wire [32:0] residual_s6_choice = ~residual_s6_difference[32] ? residual_s6_difference : residual_s6_bits;
    wire [33:0] residual_s7_bits = {1'd0, residual_s6, 2'd0};
    wire [33:0] residual_s7_difference = residual_s7_bits - {1'd0, threshold_s6};
    wire [33:0] residual_s7_choice = ~residual_s7_difference[33] ? residual_s7_difference : residual_s7_bits;
    wire [34:0] residual_s8_bits = {1'd0, residual_s7, 2'd0};
    wire [34:0] residual_s8_difference = residual_s8_bits - {1'd0, threshold_s7};
    wire [34:0] residual_s8_choice = ~residual_s8_difference[34] ? residual_s8_difference : residual_s8_bits;
    wire [35:0] residual_s9_bits = {1'd0, residual_s8, 2'd0};
    wire [35:0] residual_s9_difference = residual_s9_bits - {1'd0, threshold_s8};
    wire [35:0] residual_s9_choice = ~residual_s9_difference[35] ? residual_s9_difference : residual_s9_bits;
    wire [36:0] residual_s10_bits = {1'd0, residual_s9, 2'd0};
    wire [36:0] residual_s10_difference = residual_s10_bits - {1'd0, threshold_s9};
    wire [36:0] residual_s10_choice = ~residual_s10_difference[36] ? residual_s10_difference : residual_s10_bits;
    wire [37:0] residual_s11_bits = {1'd0, residual_s10, 2'd0};
    wire [37:0] residual_s11_difference = residual_s11_bits - {1'd0, threshold_s10};
    wire [37:0] residual_s11_choice = ~residual_s11_difference[37] ? residual_s11_difference : residual_s11_bits;
    wire [38:0] residual_s12_bits = {1'd0, residual_s11, 2'd0};
    wire [38:0] residual_s12_difference = residual_s12_bits - {1'd0, threshold_s11};
    wire [38:0] residual_s12_choice = ~residual_s12_difference[38] ? residual_s12_difference : residual_s12_bits;
    wire [39:0] residual_s13_bits = {1'd0, residual_s12, 2'd0};
    wire [39:0] residual_s13_difference = residual_s13_bits - {1'd0, threshold_s12};
    wire [39:0] residual_s13_choice = ~residual_s13_difference[39] ? residual_s13_difference : residual_s13_bits;
    wire [40:0] residual_s14_bits = {1'd0, residual_s13, 2'd0};
    wire [40:0] residual_s14_difference = residual_s14_bits - {1'd0, threshold_s13};
    wire [40:0] residual_s14_choice = ~residual_s14_difference[40] ? residual_s14_difference : residual_s14_bits;
    wire [41:0] residual_s15_bits = {1'd0, residual_s14, 2'd0};
    wire [41:0] residual_s15_difference = residual_s15_bits - {1'd0, threshold_s14};
    wire [41:0] residual_s15_choice = ~residual_s15_difference[41] ? residual_s15_difference : residual_s15_bits;
    wire [42:0] residual_s16_bits = {1'd0, residual_s15, 2'd0};
    wire [42:0] residual_s16_difference = residual_s16_bits - {1'd0, threshold_s15};
    wire [42:0] residual_s16_choice = ~residual_s16_difference[42] ? residual_s16_difference : residual_s16_bits;
    wire [43:0] residual_s17_bits = {1'd0, residual_s16, 2'd0};
    wire [43:0] residual_s17_difference = residual_s17_bits - {1'd0, threshold_s16};
    wire [43:0] residual_s17_choice = ~residual_s17_difference[43] ? residual_s17_difference : residual_s17_bits;
    wire [44:0] residual_s18_bits = {1'd0, residual_s17, 2'd0};
    wire [44:0] residual_s18_difference = residual_s18_bits - {1'd0, threshold_s17};
    wire [44:0] residual_s18_choice = ~residual_s18_difference[44] ? residual_s18_difference : residual_s18_bits;
    wire [45:0] residual_s19_bits = {1'd0, residual_s18, 2'd0};
    wire [45:0] residual_s19_difference = residual_s19_bits - {1'd0, threshold_s18};
    wire [45:0] residual_s19_choice = ~residual_s19_difference[45] ? residual_s19_difference : residual_s19_bits;
    wire [46:0] residual_s20_bits = {1'd0, residual_s19, 2'd0};
    wire [46:0] residual_s20_difference = residual_s20_bits - {1'd0, threshold_s19};
    wire [46:0] residual_s20_choice = ~residual_s20_difference[46] ? residual_s20_difference : residual_s20_bits;
    wire [47:0] residual_s21_bits = {1'd0, residual_s20, 2'd0};
    wire [47:0] residual_s21_difference = residual_s21_bits - {1'd0, threshold_s20};
    wire [47:0] residual_s21_choice = ~residual_s21_difference[47] ? residual_s21_difference : residual_s21_bits;
    wire [48:0] residual_s22_bits = {1'd0, residual_s21, 2'd0};
    wire [48:0] residual_s22_difference = residual_s22_bits - {1'd0, threshold_s21};
    wire [48:0] residual_s22_choice = ~residual_s22_difference[48] ? residual_s22_difference : residual_s22_bits;
    wire [49:0] residual_s23_bits = {1'd0, residual_s22, 2'd0};
    wire [49:0] residual_s23_difference = residual_s23_bits - {1'd0, threshold_s22};
    wire [49:0] residual_s23_choice = ~residual_s23_difference[49] ? residual_s23_difference : residual_s23_bits;
    wire [50:0] residual_s24_bits = {1'd0, residual_s23, 2'd0};
    wire [50:0] residual_s24_difference = residual_s24_bits - {1'd0, threshold_s23};
    wire [50:0] residual_s24_choice = ~residual_s24_difference[50] ? residual_s24_difference : residual_s24_bits;
    wire [9:0] a_field_plus_127 = {2'd0, a_field} + 10'd127;
    wire [51:0] significand_s25_difference = {1'd0, residual_s24, 2'd0} - {1'd0, threshold_s24};
    wire y_both = (exponent_s25 == 10'd0) & ~(&significand_s25[24:2] & significand_s25[1]);
    wire round_up = significand_s25[1] & (significand_s25[0] | significand_s25[2]);
    wire [30:0] rounded = {exponent_s25[7:0], significand_s25[24:2]} + {30'd0, round_up};
    wire [30:0] y_choice = (infinite_s25 | (~exponent_s25[9] & (10'd255 <= exponent_s25))) ? 31'h7f800000 : rounded;
    wire [30:0] y_choice_2 = (zero_s25 | ((exponent_s25[9] | y_both) & ~infinite_s25)) ? 31'd0 : y_choice;

    always @(posedge clk) begin
        if (enable) begin
            residual_s1 <= 26'h2000000 - {1'd0, m_s1_choice};
            threshold_s1 <= (threshold_s1_bits << 2) + threshold_s1_bits;
            triple_s1 <= triple_s1_bits + (triple_s1_bits << 1);
            m_s1 <= m_s1_choice;
            residual_s2 <= residual_s2_choice[26:0];
            threshold_s2 <= ~residual_s2_difference[28] ? ({threshold_s1, 1'd0} + {2'd0, triple_s1}) : ({threshold_s1, 1'd0} - {4'd0, m_s1});
            root_s2 <= {1'd1, ~residual_s2_difference[28]};
            triple_s2 <= triple_s1;
            m_s2 <= m_s1;
            residual_s3 <= residual_s3_choice[27:0];
            threshold_s3 <= ~residual_s3_difference[29] ? ({threshold_s2, 1'd0} + {3'd0, triple_s2}) : ({threshold_s2, 1'd0} - {5'd0, m_s2});
            root_s3 <= {root_s2, ~residual_s3_difference[29]};
            triple_s3 <= triple_s2;
            m_s3 <= m_s2;
            residual_s4 <= residual_s4_choice[28:0];
            threshold_s4 <= ~residual_s4_difference[30] ? ({threshold_s3, 1'd0} + {4'd0, triple_s3}) : ({threshold_s3, 1'd0} - {6'd0, m_s3});
            root_s4 <= {root_s3, ~residual_s4_difference[30]};
            triple_s4 <= triple_s3;
            m_s4 <= m_s3;
            residual_s5 <= residual_s5_choice[29:0];
            threshold_s5 <= ~residual_s5_difference[31] ? ({threshold_s4, 1'd0} + {5'd0, triple_s4}) : ({threshold_s4, 1'd0} - {7'd0, m_s4});
            root_s5 <= {root_s4, ~residual_s5_difference[31]};
            triple_s5 <= triple_s4;
            m_s5 <= m_s4;
            residual_s6 <= residual_s6_choice[30:0];
            threshold_s6 <= ~residual_s6_difference[32] ? ({threshold_s5, 1'd0} + {6'd0, triple_s5}) : ({threshold_s5, 1'd0} - {8'd0, m_s5});
            root_s6 <= {root_s5, ~residual_s6_difference[32]};
            triple_s6 <= triple_s5;
            m_s6 <= m_s5;
            residual_s7 <= residual_s7_choice[31:0];
            threshold_s7 <= ~residual_s7_difference[33] ? ({threshold_s6, 1'd0} + {7'd0, triple_s6}) : ({threshold_s6, 1'd0} - {9'd0, m_s6});
            root_s7 <= {root_s6, ~residual_s7_difference[33]};
            triple_s7 <= triple_s6;
            m_s7 <= m_s6;
            residual_s8 <= residual_s8_choice[32:0];
            threshold_s8 <= ~residual_s8_difference[34] ? ({threshold_s7, 1'd0} + {8'd0, triple_s7}) : ({threshold_s7, 1'd0} - {10'd0, m_s7});
            root_s8 <= {root_s7, ~residual_s8_difference[34]};
            triple_s8 <= triple_s7;
            m_s8 <= m_s7;
            residual_s9 <= residual_s9_choice[33:0];
            threshold_s9 <= ~residual_s9_difference[35] ? ({threshold_s8, 1'd0} + {9'd0, triple_s8}) : ({threshold_s8, 1'd0} - {11'd0, m_s8});
            root_s9 <= {root_s8, ~residual_s9_difference[35]};
            triple_s9 <= triple_s8;
            m_s9 <= m_s8;
            residual_s10 <= residual_s10_choice[34:0];
            threshold_s10 <= ~residual_s10_difference[36] ? ({threshold_s9, 1'd0} + {10'd0, triple_s9}) : ({threshold_s9, 1'd0} - {12'd0, m_s9});
            root_s10 <= {root_s9, ~residual_s10_difference[36]};
            triple_s10 <= triple_s9;
            m_s10 <= m_s9;
            residual_s11 <= residual_s11_choice[35:0];
            threshold_s11 <= ~residual_s11_difference[37] ? ({threshold_s10, 1'd0} + {11'd0, triple_s10}) : ({threshold_s10, 1'd0} - {13'd0, m_s10});
            root_s11 <= {root_s10, ~residual_s11_difference[37]};
            triple_s11 <= triple_s10;
            m_s11 <= m_s10;
            residual_s12 <= residual_s12_choice[36:0];
            threshold_s12 <= ~residual_s12_difference[38] ? ({threshold_s11, 1'd0} + {12'd0, triple_s11}) : ({threshold_s11, 1'd0} - {14'd0, m_s11});
            root_s12 <= {root_s11, ~residual_s12_difference[38]};
            triple_s12 <= triple_s11;
            m_s12 <= m_s11;
            residual_s13 <= residual_s13_choice[37:0];
            threshold_s13 <= ~residual_s13_difference[39] ? ({threshold_s12, 1'd0} + {13'd0, triple_s12}) : ({threshold_s12, 1'd0} - {15'd0, m_s12});
            root_s13 <= {root_s12, ~residual_s13_difference[39]};
            triple_s13 <= triple_s12;
            m_s13 <= m_s12;
            residual_s14 <= residual_s14_choice[38:0];
            threshold_s14 <= ~residual_s14_difference[40] ? ({threshold_s13, 1'd0} + {14'd0, triple_s13}) : ({threshold_s13, 1'd0} - {16'd0, m_s13});
            root_s14 <= {root_s13, ~residual_s14_difference[40]};
            triple_s14 <= triple_s13;
            m_s14 <= m_s13;
            residual_s15 <= residual_s15_choice[39:0];
            threshold_s15 <= ~residual_s15_difference[41] ? ({threshold_s14, 1'd0} + {15'd0, triple_s14}) : ({threshold_s14, 1'd0} - {17'd0, m_s14});
            root_s15 <= {root_s14, ~residual_s15_difference[41]};
            triple_s15 <= triple_s14;
            m_s15 <= m_s14;
            residual_s16 <= residual_s16_choice[40:0];
            threshold_s16 <= ~residual_s16_difference[42] ? ({threshold_s15, 1'd0} + {16'd0, triple_s15}) : ({threshold_s15, 1'd0} - {18'd0, m_s15});
            root_s16 <= {root_s15, ~residual_s16_difference[42]};
            triple_s16 <= triple_s15;
            m_s16 <= m_s15;
            residual_s17 <= residual_s17_choice[41:0];
            threshold_s17 <= ~residual_s17_difference[43] ? ({threshold_s16, 1'd0} + {17'd0, triple_s16}) : ({threshold_s16, 1'd0} - {19'd0, m_s16});
            root_s17 <= {root_s16, ~residual_s17_difference[43]};
            triple_s17 <= triple_s16;
            m_s17 <= m_s16;
            residual_s18 <= residual_s18_choice[42:0];
            threshold_s18 <= ~residual_s18_difference[44] ? ({threshold_s17, 1'd0} + {18'd0, triple_s17}) : ({threshold_s17, 1'd0} - {20'd0, m_s17});
            root_s18 <= {root_s17, ~residual_s18_difference[44]};
            triple_s18 <= triple_s17;
            m_s18 <= m_s17;
            residual_s19 <= residual_s19_choice[43:0];
            threshold_s19 <= ~residual_s19_difference[45] ? ({threshold_s18, 1'd0} + {19'd0, triple_s18}) : ({threshold_s18, 1'd0} - {21'd0, m_s18});
            root_s19 <= {root_s18, ~residual_s19_difference[45]};
            triple_s19 <= triple_s18;
            m_s19 <= m_s18;
            residual_s20 <= residual_s20_choice[44:0];
            threshold_s20 <= ~residual_s20_difference[46] ? ({threshold_s19, 1'd0} + {20'd0, triple_s19}) : ({threshold_s19, 1'd0} - {22'd0, m_s19});
            root_s20 <= {root_s19, ~residual_s20_difference[46]};
            triple_s20 <= triple_s19;
            m_s20 <= m_s19;
            residual_s21 <= residual_s21_choice[45:0];
            threshold_s21 <= ~residual_s21_difference[47] ? ({threshold_s20, 1'd0} + {21'd0, triple_s20}) : ({threshold_s20, 1'd0} - {23'd0, m_s20});
            root_s21 <= {root_s20, ~residual_s21_difference[47]};
            triple_s21 <= triple_s20;
            m_s21 <= m_s20;
            residual_s22 <= residual_s22_choice[46:0];
            threshold_s22 <= ~residual_s22_difference[48] ? ({threshold_s21, 1'd0} + {22'd0, triple_s21}) : ({threshold_s21, 1'd0} - {24'd0, m_s21});
            root_s22 <= {root_s21, ~residual_s22_difference[48]};
            triple_s22 <= triple_s21;
            m_s22 <= m_s21;
            residual_s23 <= residual_s23_choice[47:0];
            threshold_s23 <= ~residual_s23_difference[49] ? ({threshold_s22, 1'd0} + {23'd0, triple_s22}) : ({threshold_s22, 1'd0} - {25'd0, m_s22});
            root_s23 <= {root_s22, ~residual_s23_difference[49]};
            triple_s23 <= triple_s22;
            m_s23 <= m_s22;
            residual_s24 <= residual_s24_choice[48:0];
            threshold_s24 <= ~residual_s24_difference[50] ? ({threshold_s23, 1'd0} + {24'd0, triple_s23}) : ({threshold_s23, 1'd0} - {26'd0, m_s23});
            root_s24 <= {root_s23, ~residual_s24_difference[50]};
            exponent_s1 <= 10'd253 - {a_field_plus_127[9], a_field_plus_127[9:1]};
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
            significand_s25 <= {root_s24, ~significand_s25_difference[51], 1'd1};
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
            infinite_s1 <= ~(|a_field);
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
            zero_s1 <= &a_field & (a_fraction == 23'd0);
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
        1'b0, a_field_plus_127[0], residual_s10_choice[36:35], residual_s11_choice[37:36],
        residual_s12_choice[38:37], residual_s13_choice[39:38], residual_s14_choice[40:39],
        residual_s15_choice[41:40], residual_s16_choice[42:41], residual_s17_choice[43:42],
        residual_s18_choice[44:43], residual_s19_choice[45:44], residual_s20_choice[46:45],
        residual_s21_choice[47:46], residual_s22_choice[48:47], residual_s23_choice[49:48],
        residual_s24_choice[50:49], residual_s2_choice[28:27], residual_s3_choice[29:28],
        residual_s4_choice[30:29], residual_s5_choice[31:30], residual_s6_choice[32:31],
        residual_s7_choice[33:32], residual_s8_choice[34:33], residual_s9_choice[35:34], significand_s25[25],
        significand_s25_difference[50:0]
    };
endmodule

// Floating-point sum with products, each of them rounded.
// product_stages = 5
// sum_stages = 6
// format = f32-ftz
module mul_add_p5_s6_f32ftz (
    input  wire clk, input wire enable, input wire [31:0] a, input wire [31:0] b, input wire [31:0] c,
    output wire [31:0] y
);
    wire [31:0] product_y;

    float_mul_s5_f32ftz product (.clk(clk), .enable(enable), .a(a), .b(b), .y(product_y));
    float_add_s6_f32ftz sum (.clk(clk), .enable(enable), .a(product_y), .b(c), .y(y));
endmodule

// Floating-point reciprocal, correctly rounded.
// stages = 28
// format = f32-ftz
module float_recip_s28_f32ftz (
    input  wire clk, input wire enable, input wire [31:0] a,
    output reg  [31:0] y
);
    reg [24:0] remainder_s1;
    reg quotient_s1;
    reg [23:0] divisor_s1;
    reg [24:0] remainder_s2;
    reg [1:0] quotient_s2;
    reg [23:0] divisor_s2;
    reg [24:0] remainder_s3;
    reg [2:0] quotient_s3;
    reg [23:0] divisor_s3;
    reg [24:0] remainder_s4;
    reg [3:0] quotient_s4;
    reg [23:0] divisor_s4;
    reg [24:0] remainder_s5;
    reg [4:0] quotient_s5;
    reg [23:0] divisor_s5;
    reg [24:0] remainder_s6;
    reg [5:0] quotient_s6;
    reg [23:0] divisor_s6;
    reg [24:0] remainder_s7;
    reg [6:0] quotient_s7;
    reg [23:0] divisor_s7;
    reg [24:0] remainder_s8;
    reg [7:0] quotient_s8;
    reg [23:0] divisor_s8;
    reg [24:0] remainder_s9;
    reg [8:0] quotient_s9;
    reg [23:0] divisor_s9;
    reg [24:0] remainder_s10;
    reg [9:0] quotient_s10;
    reg [23:0] divisor_s10;
    reg [24:0] remainder_s11;
    reg [10:0] quotient_s11;
    reg [23:0] divisor_s11;
    reg [24:0] remainder_s12;
    reg [11:0] quotient_s12;
    reg [23:0] divisor_s12;
    reg [24:0] remainder_s13;
    reg [12:0] quotient_s13;
    reg [23:0] divisor_s13;
    reg [24:0] remainder_s14;
    reg [13:0] quotient_s14;
    reg [23:0] divisor_s14;
    reg [24:0] remainder_s15;
    reg [14:0] quotient_s15;
    reg [23:0] divisor_s15;
    reg [24:0] remainder_s16;
    reg [15:0] quotient_s16;
    reg [23:0] divisor_s16;
    reg [24:0] remainder_s17;
    reg [16:0] quotient_s17;
    reg [23:0] divisor_s17;
    reg [24:0] remainder_s18;
    reg [17:0] quotient_s18;
    reg [23:0] divisor_s18;
    reg [24:0] remainder_s19;
    reg [18:0] quotient_s19;
    reg [23:0] divisor_s19;
    reg [24:0] remainder_s20;
    reg [19:0] quotient_s20;
    reg [23:0] divisor_s20;
    reg [24:0] remainder_s21;
    reg [20:0] quotient_s21;
    reg [23:0] divisor_s21;
    reg [24:0] remainder_s22;
    reg [21:0] quotient_s22;
    reg [23:0] divisor_s22;
    reg [24:0] remainder_s23;
    reg [22:0] quotient_s23;
    reg [23:0] divisor_s23;
    reg [24:0] remainder_s24;
    reg [23:0] quotient_s24, divisor_s24;
    reg [24:0] remainder_s25, quotient_s25;
    reg [23:0] divisor_s25;
    reg [24:0] remainder_s26;
    reg [25:0] quotient_s26;
    reg [9:0] exponent_s1, exponent_s2, exponent_s3, exponent_s4, exponent_s5, exponent_s6, exponent_s7;
    reg [9:0] exponent_s8, exponent_s9, exponent_s10, exponent_s11, exponent_s12, exponent_s13, exponent_s14;
    reg [9:0] exponent_s15, exponent_s16, exponent_s17, exponent_s18, exponent_s19, exponent_s20, exponent_s21;
    reg [9:0] exponent_s22, exponent_s23, exponent_s24, exponent_s25, exponent_s26, exponent_s27;
    reg [25:0] significand_s27;
    reg sign_s1, sign_s2, sign_s3, sign_s4, sign_s5, sign_s6, sign_s7, sign_s8, sign_s9, sign_s10, sign_s11;
    reg sign_s12, sign_s13, sign_s14, sign_s15, sign_s16, sign_s17, sign_s18, sign_s19, sign_s20, sign_s21;
    reg sign_s22, sign_s23, sign_s24, sign_s25, sign_s26, sign_s27, nan_s1, nan_s2, nan_s3, nan_s4, nan_s5;
    reg nan_s6, nan_s7, nan_s8, nan_s9, nan_s10, nan_s11, nan_s12, nan_s13, nan_s14, nan_s15, nan_s16;
    reg nan_s17, nan_s18, nan_s19, nan_s20, nan_s21, nan_s22, nan_s23, nan_s24, nan_s25, nan_s26, nan_s27;
    reg infinite_s1, infinite_s2, infinite_s3, infinite_s4, infinite_s5, infinite_s6, infinite_s7;
    reg infinite_s8, infinite_s9, infinite_s10, infinite_s11, infinite_s12, infinite_s13, infinite_s14;
    reg infinite_s15, infinite_s16, infinite_s17, infinite_s18, infinite_s19, infinite_s20, infinite_s21;
    reg infinite_s22, infinite_s23, infinite_s24, infinite_s25, infinite_s26, infinite_s27, zero_s1, zero_s2;
    reg zero_s3, zero_s4, zero_s5, zero_s6, zero_s7, zero_s8, zero_s9, zero_s10, zero_s11, zero_s12, zero_s13;
    reg zero_s14, zero_s15, zero_s16, zero_s17, zero_s18, zero_s19, zero_s20, zero_s21, zero_s22, zero_s23;
    reg zero_s24, zero_s25, zero_s26, zero_s27;

    wire [7:0] a_field = a[30:23];
    wire [22:0] a_fraction = a[22:0];
    wire [22:0] remainder_s1_both = a_fraction & {23{|a_field}};
    wire [25:0] remainder_s1_difference = 26'h800000 - {2'd0, |a_field, remainder_s1_both};
    wire [23:0] remainder_s1_choice = ~remainder_s1_difference[25] ? remainder_s1_difference[23:0] : 24'h800000;
    wire [25:0] remainder_s1_minus_divisor_s1 = {1'd0, remainder_s1} - {2'd0, divisor_s1};
    wire [23:0] remainder_s2_choice = ~remainder_s1_minus_divisor_s1[25] ? remainder_s1_minus_divisor_s1[23:0] : remainder_s1[23:0];
    wire [25:0] remainder_s2_minus_divisor_s2 = {1'd0, remainder_s2} - {2'd0, divisor_s2};
    wire [23:0] remainder_s3_choice = ~remainder_s2_minus_divisor_s2[25] ? remainder_s2_minus_divisor_s2[23:0] : remainder_s2[23:0];
    wire [25:0] remainder_s3_minus_divisor_s3 = {1'd0, remainder_s3} - {2'd0, divisor_s3};
    wire [23:0] remainder_s4_choice = ~remainder_s3_minus_divisor_s3[25] ? remainder_s3_minus_divisor_s3[23:0] : remainder_s3[23:0];
    wire [25:0] remainder_s4_minus_divisor_s4 = {1'd0, remainder_s4} - {2'd0, divisor_s4};
    wire [23:0] remainder_s5_choice = ~remainder_s4_minus_divisor_s4[25] ? remainder_s4_minus_divisor_s4[23:0] : remainder_s4[23:0];
    wire [25:0] remainder_s5_minus_divisor_s5 = {1'd0, remainder_s5} - {2'd0, divisor_s5};
    wire [23:0] remainder_s6_choice = ~remainder_s5_minus_divisor_s5[25] ? remainder_s5_minus_divisor_s5[23:0] : remainder_s5[23:0];
    wire [25:0] remainder_s6_minus_divisor_s6 = {1'd0, remainder_s6} - {2'd0, divisor_s6};
    wire [23:0] remainder_s7_choice = ~remainder_s6_minus_divisor_s6[25] ? remainder_s6_minus_divisor_s6[23:0] : remainder_s6[23:0];
    wire [25:0] remainder_s7_minus_divisor_s7 = {1'd0, remainder_s7} - {2'd0, divisor_s7};
    wire [23:0] remainder_s8_choice = ~remainder_s7_minus_divisor_s7[25] ? remainder_s7_minus_divisor_s7[23:0] : remainder_s7[23:0];
    wire [25:0] remainder_s8_minus_divisor_s8 = {1'd0, remainder_s8} - {2'd0, divisor_s8};
    wire [23:0] remainder_s9_choice = ~remainder_s8_minus_divisor_s8[25] ? remainder_s8_minus_divisor_s8[23:0] : remainder_s8[23:0];
    wire [25:0] remainder_s9_minus_divisor_s9 = {1'd0, remainder_s9} - {2'd0, divisor_s9};
    wire [23:0] remainder_s10_choice = ~remainder_s9_minus_divisor_s9[25] ? remainder_s9_minus_divisor_s9[23:0] : remainder_s9[23:0];
    wire [25:0] remainder_s11_difference = {1'd0, remainder_s10} - {2'd0, divisor_s10};
    wire [23:0] remainder_s11_choice = ~remainder_s11_difference[25] ? remainder_s11_difference[23:0] : remainder_s10[23:0];
    wire [25:0] remainder_s12_difference = {1'd0, remainder_s11} - {2'd0, divisor_s11};
    wire [23:0] remainder_s12_choice = ~remainder_s12_difference[25] ? remainder_s12_difference[23:0] : remainder_s11[23:0];
    wire [25:0] remainder_s13_difference = {1'd0, remainder_s12} - {2'd0, divisor_s12};
    wire [23:0] remainder_s13_choice = ~remainder_s13_difference[25] ? remainder_s13_difference[23:0] : remainder_s12[23:0];
    wire [25:0] remainder_s14_difference = {1'd0, remainder_s13} - {2'd0, divisor_s13};
    wire [23:0] remainder_s14_choice = ~remainder_s14_difference[25] ? remainder_s14_difference[23:0] : remainder_s13[23:0];
    wire [25:0] remainder_s15_difference = {1'd0, remainder_s14} - {2'd0, divisor_s14};
    wire [23:0] remainder_s15_choice = ~remainder_s15_difference[25] ? remainder_s15_difference[23:0] : remainder_s14[23:0];
    wire [25:0] remainder_s16_difference = {1'd0, remainder_s15} - {2'd0, divisor_s15};
    wire [23:0] remainder_s16_choice = ~remainder_s16_difference[25] ? remainder_s16_difference[23:0] : remainder_s15[23:0];
    wire [25:0] remainder_s17_difference = {1'd0, remainder_s16} - {2'd0, divisor_s16};
    wire [23:0] remainder_s17_choice = ~remainder_s17_difference[25] ? remainder_s17_difference[23:0] : remainder_s16[23:0];
    wire [25:0] remainder_s18_difference = {1'd0, remainder_s17} - {2'd0, divisor_s17};
    wire [23:0] remainder_s18_choice = ~remainder_s18_difference[25] ? remainder_s18_difference[23:0] : remainder_s17[23:0];
    wire [25:0] remainder_s19_difference = {1'd0, remainder_s18} - {2'd0, divisor_s18};
    wire [23:0] remainder_s19_choice = ~remainder_s19_difference[25] ? remainder_s19_difference[23:0] : remainder_s18[23:0];
    wire [25:0] remainder_s20_difference = {1'd0, remainder_s19} - {2'd0, divisor_s19};
    wire [23:0] remainder_s20_choice = ~remainder_s20_difference[25] ? remainder_s20_difference[23:0] : remainder_s19[23:0];
    wire [25:0] remainder_s21_difference = {1'd0, remainder_s20} - {2'd0, divisor_s20};
    wire [23:0] remainder_s21_choice = ~remainder_s21_difference[25] ? remainder_s21_difference[23:0] : remainder_s20[23:0];
    wire [25:0] remainder_s22_difference = {1'd0, remainder_s21} - {2'd0, divisor_s21};
    wire [23:0] remainder_s22_choice = ~remainder_s22_difference[25] ? remainder_s22_difference[23:0] : remainder_s21[23:0];
    wire [25:0] remainder_s23_difference = {1'd0, remainder_s22} - {2'd0, divisor_s22};
    wire [23:0] remainder_s23_choice = ~remainder_s23_difference[25] ? remainder_s23_difference[23:0] : remainder_s22[23:0];
    wire [25:0] remainder_s24_difference = {1'd0, remainder_s23} - {2'd0, divisor_s23};
    wire [23:0] remainder_s24_choice = ~remainder_s24_difference[25] ? remainder_s24_difference[23:0] : remainder_s23[23:0];
    wire [25:0] remainder_s25_difference = {1'd0, remainder_s24} - {2'd0, divisor_s24};
    wire [23:0] remainder_s25_choice = ~remainder_s25_difference[25] ? remainder_s25_difference[23:0] : remainder_s24[23:0];
    wire [25:0] remainder_s26_difference = {1'd0, remainder_s25} - {2'd0, divisor_s25};
    wire [23:0] remainder_s26_choice = ~remainder_s26_difference[25] ? remainder_s26_difference[23:0] : remainder_s25[23:0];
    wire [26:0] significand_s27_bits = {quotient_s26, |remainder_s26};
    wire [26:0] significand_s27_choice = ~quotient_s26[25] ? (significand_s27_bits << 1) : significand_s27_bits;
    wire y_both = (exponent_s27 == 10'd0) & ~(&significand_s27[24:2] & significand_s27[1]);
    wire round_up = significand_s27[1] & (significand_s27[0] | significand_s27[2]);
    wire [30:0] rounded = {exponent_s27[7:0], significand_s27[24:2]} + {30'd0, round_up};
    wire [30:0] y_choice = (infinite_s27 | (~exponent_s27[9] & (10'd255 <= exponent_s27))) ? 31'h7f800000 : rounded;
    wire [30:0] y_choice_2 = (zero_s27 | ((exponent_s27[9] | y_both) & ~infinite_s27)) ? 31'd0 : y_choice;

    always @(posedge clk) begin
        if (enable) begin
            remainder_s1 <= {remainder_s1_choice, 1'd0};
            quotient_s1 <= ~remainder_s1_difference[25];
            divisor_s1 <= {|a_field, remainder_s1_both};
            remainder_s2 <= {remainder_s2_choice, 1'd0};
            quotient_s2 <= {quotient_s1, ~remainder_s1_minus_divisor_s1[25]};
            divisor_s2 <= divisor_s1;
            remainder_s3 <= {remainder_s3_choice, 1'd0};
            quotient_s3 <= {quotient_s2, ~remainder_s2_minus_divisor_s2[25]};
            divisor_s3 <= divisor_s2;
            remainder_s4 <= {remainder_s4_choice, 1'd0};
            quotient_s4 <= {quotient_s3, ~remainder_s3_minus_divisor_s3[25]};
            divisor_s4 <= divisor_s3;
            remainder_s5 <= {remainder_s5_choice, 1'd0};
            quotient_s5 <= {quotient_s4, ~remainder_s4_minus_divisor_s4[25]};
            divisor_s5 <= divisor_s4;
            remainder_s6 <= {remainder_s6_choice, 1'd0};
            quotient_s6 <= {quotient_s5, ~remainder_s5_minus_divisor_s5[25]};
            divisor_s6 <= divisor_s5;
            remainder_s7 <= {remainder_s7_choice, 1'd0};
            quotient_s7 <= {quotient_s6, ~remainder_s6_minus_divisor_s6[25]};
            divisor_s7 <= divisor_s6;
            remainder_s8 <= {remainder_s8_choice, 1'd0};
            quotient_s8 <= {quotient_s7, ~remainder_s7_minus_divisor_s7[25]};
            divisor_s8 <= divisor_s7;
            remainder_s9 <= {remainder_s9_choice, 1'd0};
            quotient_s9 <= {quotient_s8, ~remainder_s8_minus_divisor_s8[25]};
            divisor_s9 <= divisor_s8;
            remainder_s10 <= {remainder_s10_choice, 1'd0};
            quotient_s10 <= {quotient_s9, ~remainder_s9_minus_divisor_s9[25]};
            divisor_s10 <= divisor_s9;
            remainder_s11 <= {remainder_s11_choice, 1'd0};
            quotient_s11 <= {quotient_s10, ~remainder_s11_difference[25]};
            divisor_s11 <= divisor_s10;
            remainder_s12 <= {remainder_s12_choice, 1'd0};
            quotient_s12 <= {quotient_s11, ~remainder_s12_difference[25]};
            divisor_s12 <= divisor_s11;
            remainder_s13 <= {remainder_s13_choice, 1'd0};
            quotient_s13 <= {quotient_s12, ~remainder_s13_difference[25]};
            divisor_s13 <= divisor_s12;
            remainder_s14 <= {remainder_s14_choice, 1'd0};
            quotient_s14 <= {quotient_s13, ~remainder_s14_difference[25]};
            divisor_s14 <= divisor_s13;
            remainder_s15 <= {remainder_s15_choice, 1'd0};
            quotient_s15 <= {quotient_s14, ~remainder_s15_difference[25]};
            divisor_s15 <= divisor_s14;
            remainder_s16 <= {remainder_s16_choice, 1'd0};
            quotient_s16 <= {quotient_s15, ~remainder_s16_difference[25]};
            divisor_s16 <= divisor_s15;
            remainder_s17 <= {remainder_s17_choice, 1'd0};
            quotient_s17 <= {quotient_s16, ~remainder_s17_difference[25]};
            divisor_s17 <= divisor_s16;
            remainder_s18 <= {remainder_s18_choice, 1'd0};
            quotient_s18 <= {quotient_s17, ~remainder_s18_difference[25]};
            divisor_s18 <= divisor_s17;
            remainder_s19 <= {remainder_s19_choice, 1'd0};
            quotient_s19 <= {quotient_s18, ~remainder_s19_difference[25]};
            divisor_s19 <= divisor_s18;
            remainder_s20 <= {remainder_s20_choice, 1'd0};
            quotient_s20 <= {quotient_s19, ~remainder_s20_difference[25]};
            divisor_s20 <= divisor_s19;
            remainder_s21 <= {remainder_s21_choice, 1'd0};
            quotient_s21 <= {quotient_s20, ~remainder_s21_difference[25]};
            divisor_s21 <= divisor_s20;
            remainder_s22 <= {remainder_s22_choice, 1'd0};
            quotient_s22 <= {quotient_s21, ~remainder_s22_difference[25]};
            divisor_s22 <= divisor_s21;
            remainder_s23 <= {remainder_s23_choice, 1'd0};
            quotient_s23 <= {quotient_s22, ~remainder_s23_difference[25]};
            divisor_s23 <= divisor_s22;
            remainder_s24 <= {remainder_s24_choice, 1'd0};
            quotient_s24 <= {quotient_s23, ~remainder_s24_difference[25]};
            divisor_s24 <= divisor_s23;
            remainder_s25 <= {remainder_s25_choice, 1'd0};
            quotient_s25 <= {quotient_s24, ~remainder_s25_difference[25]};
            divisor_s25 <= divisor_s24;
            remainder_s26 <= {remainder_s26_choice, 1'd0};
            quotient_s26 <= {quotient_s25, ~remainder_s26_difference[25]};
            exponent_s1 <= (10'd127 - {2'd0, a_field}) + 10'd127;
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
            exponent_s26 <= exponent_s25;
            exponent_s27 <= exponent_s26 - {9'd0, ~quotient_s26[25]};
            significand_s27 <= {significand_s27_choice[26:2], |significand_s27_choice[1:0]};
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
            sign_s26 <= sign_s25;
            sign_s27 <= sign_s26;
            nan_s1 <= &a_field & |a_fraction;
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
            nan_s26 <= nan_s25;
            nan_s27 <= nan_s26;
            infinite_s1 <= ~(|a_field);
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
            infinite_s26 <= infinite_s25;
            infinite_s27 <= infinite_s26;
            zero_s1 <= &a_field & (a_fraction == 23'd0);
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
            zero_s26 <= zero_s25;
            zero_s27 <= zero_s26;
            y <= nan_s27 ? 32'h7fc00000 : {sign_s27, y_choice_2};
        end
    end

    wire _unused = &{
        1'b0, remainder_s11_difference[24], remainder_s12_difference[24], remainder_s13_difference[24],
        remainder_s14_difference[24], remainder_s15_difference[24], remainder_s16_difference[24],
        remainder_s17_difference[24], remainder_s18_difference[24], remainder_s19_difference[24],
        remainder_s1_difference[24], remainder_s1_minus_divisor_s1[24], remainder_s20_difference[24],
        remainder_s21_difference[24], remainder_s22_difference[24], remainder_s23_difference[24],
        remainder_s24_difference[24], remainder_s25_difference[24], remainder_s26_difference[24],
        remainder_s2_minus_divisor_s2[24], remainder_s3_minus_divisor_s3[24],
        remainder_s4_minus_divisor_s4[24], remainder_s5_minus_divisor_s5[24],
        remainder_s6_minus_divisor_s6[24], remainder_s7_minus_divisor_s7[24],
        remainder_s8_minus_divisor_s8[24], remainder_s9_minus_divisor_s9[24], significand_s27[25]
    };
endmodule

// Words of queries by thread, a copy of each for each block that reads it.
// threads = 128
module process_bank (
    input  wire clk, input wire rst,
    input  wire fresh_valid,  // A thread takes up a query.
    input  wire [6:0] fresh_thread,  // Thread.
    input  wire [31:0] fresh_query_position_x,  // Words of the query, its position first.
    input  wire [31:0] fresh_query_position_y,  // Words of the query, its position first.
    input  wire [31:0] fresh_query_position_z,  // Words of the query, its position first.
    input  wire listed_valid,  // A thread's neighbors are complete.
    input  wire [6:0] listed_thread,  // Thread.
    input  wire [5:0] listed_neighbors,  // How many.
    input  wire update_valid, output wire update_ready,  // What is written of a query that goes on.
    input  wire [6:0] update_thread,  // Thread.
    input  wire update_search,  // It needs the neighbors of its position; else it goes on with those it has.
    input  wire [31:0] update_moved_position_x,  // The query's new position.
    input  wire [31:0] update_moved_position_y,  // The query's new position.
    input  wire [31:0] update_moved_position_z,  // The query's new position.
    input  wire update_move,  // The query has moved there.
    input  wire [15:0] update_count,  // Iterations that are complete.
    output reg  again_valid,  // It is written.
    output reg  [6:0] again_thread,  // Thread.
    output reg  again_search,  // It needs the neighbors of its position; else it goes on with those it has.
    input  wire stores_valid, output wire stores_ready,  // What `init` writes.
    input  wire [6:0] stores_thread,  // Thread.
    input  wire [31:0] stores_state_start_x,  // Words of the state.
    input  wire [31:0] stores_state_start_y,  // Words of the state.
    input  wire [31:0] stores_state_start_z,  // Words of the state.
    input  wire stores_write_start,  // Which fields of it are written.
    output reg  prepared_valid,  // It is written.
    output reg  [6:0] prepared_thread,  // Thread.
    input  wire want_valid, output wire want_ready,  // Threads that want the neighbors of their position.
    input  wire [6:0] want_thread,  // Thread.
    output wire wanted_valid, input wire wanted_ready,  // The position.
    output wire [6:0] wanted_thread,  // Thread.
    output wire [31:0] wanted_query_position_x,  // Where.
    output wire [31:0] wanted_query_position_y,  // Where.
    output wire [31:0] wanted_query_position_z,  // Where.
    input  wire gathered_valid, output wire gathered_ready,  // Neighbors for `kernel`, and the farthest for `init`.
    input  wire [6:0] gathered_thread,  // Thread.
    input  wire gathered_farthest,  // It is the farthest, for `init`; else one of those that `kernel` goes through.
    input  wire gathered_none,  // There is none: the query has no neighbors.
    input  wire gathered_last,  // The last one of its query that `kernel` goes through.
    input  wire [31:0] gathered_position_x,  // Words of the neighbor.
    input  wire [31:0] gathered_position_y,  // Words of the neighbor.
    input  wire [31:0] gathered_position_z,  // Words of the neighbor.
    input  wire [31:0] gathered_normal_x,  // Words of the neighbor.
    input  wire [31:0] gathered_normal_y,  // Words of the neighbor.
    input  wire [31:0] gathered_normal_z,  // Words of the neighbor.
    output wire kernel_valid, input wire kernel_ready,  // What `kernel` takes.
    output wire [6:0] kernel_thread,  // Thread.
    output wire kernel_none,  // There is no neighbor: the query has none.
    output wire kernel_last,  // The query's last neighbor.
    output wire [31:0] kernel_query_position_x,  // Words that `kernel` reads besides settings.
    output wire [31:0] kernel_query_position_y,  // Words that `kernel` reads besides settings.
    output wire [31:0] kernel_query_position_z,  // Words that `kernel` reads besides settings.
    output wire [31:0] kernel_neighbor_position_x,  // Words that `kernel` reads besides settings.
    output wire [31:0] kernel_neighbor_position_y,  // Words that `kernel` reads besides settings.
    output wire [31:0] kernel_neighbor_position_z,  // Words that `kernel` reads besides settings.
    output wire [31:0] kernel_neighbor_normal_x,  // Words that `kernel` reads besides settings.
    output wire [31:0] kernel_neighbor_normal_y,  // Words that `kernel` reads besides settings.
    output wire [31:0] kernel_neighbor_normal_z,  // Words that `kernel` reads besides settings.
    output wire init_valid, input wire init_ready,  // What `init` takes.
    output wire [6:0] init_thread,  // Thread.
    output wire [31:0] init_query_position_x,  // Words that `init` reads besides settings.
    output wire [31:0] init_query_position_y,  // Words that `init` reads besides settings.
    output wire [31:0] init_query_position_z,  // Words that `init` reads besides settings.
    output wire [31:0] init_count,  // Words that `init` reads besides settings.
    input  wire prepare_valid, output wire prepare_ready,  // Threads for `init`.
    input  wire [6:0] prepare_thread,  // Thread.
    input  wire sums_valid, output wire sums_ready,  // Sums for `final`.
    input  wire [6:0] sums_thread,  // Thread.
    input  wire [31:0] sums_weight_0,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_weight_1,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_weight_2,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_weight_3,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_weight_4,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_weight_5,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_weight_6,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_weight_7,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_x_0,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_x_1,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_x_2,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_x_3,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_x_4,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_x_5,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_x_6,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_x_7,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_y_0,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_y_1,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_y_2,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_y_3,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_y_4,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_y_5,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_y_6,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_y_7,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_z_0,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_z_1,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_z_2,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_z_3,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_z_4,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_z_5,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_z_6,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_points_z_7,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_x_0,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_x_1,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_x_2,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_x_3,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_x_4,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_x_5,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_x_6,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_x_7,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_y_0,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_y_1,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_y_2,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_y_3,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_y_4,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_y_5,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_y_6,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_y_7,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_z_0,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_z_1,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_z_2,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_z_3,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_z_4,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_z_5,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_z_6,  // Of each word of the sums its partial sums.
    input  wire [31:0] sums_normals_z_7,  // Of each word of the sums its partial sums.
    output wire finish_valid, input wire finish_ready,  // What `final` takes.
    output wire [6:0] finish_thread,  // Thread.
    output wire [31:0] finish_query_position_x,  // Words that `final` reads besides settings and sums.
    output wire [31:0] finish_query_position_y,  // Words that `final` reads besides settings and sums.
    output wire [31:0] finish_query_position_z,  // Words that `final` reads besides settings and sums.
    output wire [31:0] finish_state_start_x,  // Words that `final` reads besides settings and sums.
    output wire [31:0] finish_state_start_y,  // Words that `final` reads besides settings and sums.
    output wire [31:0] finish_state_start_z,  // Words that `final` reads besides settings and sums.
    output wire [31:0] finish_sum_weight_0,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_weight_1,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_weight_2,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_weight_3,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_weight_4,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_weight_5,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_weight_6,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_weight_7,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_points_x_0,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_points_x_1,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_points_x_2,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_points_x_3,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_points_x_4,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_points_x_5,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_points_x_6,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_points_x_7,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_points_y_0,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_points_y_1,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_points_y_2,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_points_y_3,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_points_y_4,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_points_y_5,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_points_y_6,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_points_y_7,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_points_z_0,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_points_z_1,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_points_z_2,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_points_z_3,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_points_z_4,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_points_z_5,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_points_z_6,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_points_z_7,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_normals_x_0,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_normals_x_1,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_normals_x_2,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_normals_x_3,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_normals_x_4,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_normals_x_5,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_normals_x_6,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_normals_x_7,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_normals_y_0,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_normals_y_1,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_normals_y_2,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_normals_y_3,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_normals_y_4,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_normals_y_5,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_normals_y_6,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_normals_y_7,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_normals_z_0,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_normals_z_1,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_normals_z_2,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_normals_z_3,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_normals_z_4,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_normals_z_5,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_normals_z_6,  // Of each word of the sums its partial sums.
    output wire [31:0] finish_sum_normals_z_7  // Of each word of the sums its partial sums.
);
    reg reads_wanted;
    reg [6:0] wanted_read_thread;  // Thread.
    wire [31:0] wanted_copy_query_position_x_read, wanted_copy_query_position_y_read;
    wire [31:0] wanted_copy_query_position_z_read;
    reg reads_kernel, reads_init;
    wire [31:0] init_copy_query_position_x_read, init_copy_query_position_y_read, init_copy_query_position_z_read;
    wire [15:0] init_copy_count_read;
    reg [6:0] init_read_thread;  // Thread.
    wire [31:0] kernel_copy_query_position_x_read, kernel_copy_query_position_y_read;
    wire [31:0] kernel_copy_query_position_z_read;
    reg [31:0] kernel_read_neighbor_position_x, kernel_read_neighbor_position_y, kernel_read_neighbor_position_z;
    reg [31:0] kernel_read_neighbor_normal_x, kernel_read_neighbor_normal_y, kernel_read_neighbor_normal_z;
    reg [6:0] kernel_read_thread;
    reg kernel_read_none, kernel_read_last, finish_read;
    wire [31:0] finish_copy_query_position_x_read, finish_copy_query_position_y_read;
    wire [31:0] finish_copy_query_position_z_read, finish_copy_state_start_x_read, finish_copy_state_start_y_read;
    wire [31:0] finish_copy_state_start_z_read;

    wire update_queue_out_valid;
    wire [120:0] update_queue_out_data;
    wire stores_queue_out_valid;
    wire [103:0] stores_queue_out_data;
    wire wanted_queue_in_ready;
    wire [102:0] wanted_queue_out_data;
    wire kernel_queue_in_ready;
    wire [296:0] kernel_queue_out_data;
    wire init_queue_in_ready;
    wire [134:0] init_queue_out_data;
    wire finish_queue_in_ready;
    wire [1990:0] finish_queue_out_data;

    assign sums_ready = finish_read & finish_queue_in_ready;
    wire wanted_advances = ~reads_wanted | wanted_queue_in_ready;
    wire kernel_advances = ~reads_kernel | kernel_queue_in_ready;
    wire init_advances = ~reads_init | init_queue_in_ready;
    wire update_queue_out_ready = ~fresh_valid;
    wire updates = update_queue_out_valid & update_queue_out_ready;
    wire update_queue_out_move = update_queue_out_data[16];
    wire wanted_copy_query_position_x_write_either = fresh_valid | (updates & update_queue_out_move);
    wire stores_queue_out_ready_either = fresh_valid | update_queue_out_valid;
    wire [6:0] update_queue_out_thread = update_queue_out_data[120:114];
    wire [6:0] stores_queue_out_thread = stores_queue_out_data[103:97];
    wire [6:0] written_thread = stores_queue_out_ready_either ? (fresh_valid ? fresh_thread : update_queue_out_thread) : stores_queue_out_thread;
    wire [31:0] update_queue_out_moved_position_x = update_queue_out_data[112:81];
    wire [31:0] wanted_copy_query_position_x_data_choice = fresh_valid ? fresh_query_position_x : update_queue_out_moved_position_x;
    wire want_valid_and_wanted_advances = want_valid & wanted_advances;
    wire [31:0] update_queue_out_moved_position_y = update_queue_out_data[80:49];
    wire [31:0] wanted_copy_query_position_y_data_choice = fresh_valid ? fresh_query_position_y : update_queue_out_moved_position_y;
    wire [31:0] update_queue_out_moved_position_z = update_queue_out_data[48:17];
    wire [31:0] wanted_copy_query_position_z_data_choice = fresh_valid ? fresh_query_position_z : update_queue_out_moved_position_z;
    wire reads_init_both = prepare_valid & init_advances;
    wire [15:0] update_queue_out_count = update_queue_out_data[15:0];
    wire neighbor_arrives = gathered_valid & kernel_advances & ~gathered_farthest;
    wire stores_queue_out_ready = ~stores_queue_out_ready_either;
    wire stored = stores_queue_out_valid & stores_queue_out_ready;
    wire stores_queue_out_write_start = stores_queue_out_data[0];
    wire finish_copy_state_start_x_write_either = fresh_valid | (stored & stores_queue_out_write_start);
    wire [31:0] stores_queue_out_state_start_x = stores_queue_out_data[96:65];
    wire [31:0] stores_queue_out_state_start_y = stores_queue_out_data[64:33];
    wire [31:0] stores_queue_out_state_start_z = stores_queue_out_data[32:1];
    wire takes_sums = sums_valid & sums_ready;
    wire update_queue_out_search = update_queue_out_data[113];

    assign want_ready = wanted_advances;
    assign {wanted_thread, wanted_query_position_x, wanted_query_position_y, wanted_query_position_z} = wanted_queue_out_data;
    assign gathered_ready = kernel_advances;
    assign {
        kernel_thread, kernel_none, kernel_last, kernel_query_position_x, kernel_query_position_y,
        kernel_query_position_z, kernel_neighbor_position_x, kernel_neighbor_position_y,
        kernel_neighbor_position_z, kernel_neighbor_normal_x, kernel_neighbor_normal_y,
        kernel_neighbor_normal_z
    } = kernel_queue_out_data;
    assign {init_thread, init_query_position_x, init_query_position_y, init_query_position_z, init_count} = init_queue_out_data;
    assign prepare_ready = init_advances;
    assign {
        finish_thread, finish_query_position_x, finish_query_position_y, finish_query_position_z,
        finish_state_start_x, finish_state_start_y, finish_state_start_z, finish_sum_weight_0,
        finish_sum_weight_1, finish_sum_weight_2, finish_sum_weight_3, finish_sum_weight_4,
        finish_sum_weight_5, finish_sum_weight_6, finish_sum_weight_7, finish_sum_points_x_0,
        finish_sum_points_x_1, finish_sum_points_x_2, finish_sum_points_x_3, finish_sum_points_x_4,
        finish_sum_points_x_5, finish_sum_points_x_6, finish_sum_points_x_7, finish_sum_points_y_0,
        finish_sum_points_y_1, finish_sum_points_y_2, finish_sum_points_y_3, finish_sum_points_y_4,
        finish_sum_points_y_5, finish_sum_points_y_6, finish_sum_points_y_7, finish_sum_points_z_0,
        finish_sum_points_z_1, finish_sum_points_z_2, finish_sum_points_z_3, finish_sum_points_z_4,
        finish_sum_points_z_5, finish_sum_points_z_6, finish_sum_points_z_7, finish_sum_normals_x_0,
        finish_sum_normals_x_1, finish_sum_normals_x_2, finish_sum_normals_x_3, finish_sum_normals_x_4,
        finish_sum_normals_x_5, finish_sum_normals_x_6, finish_sum_normals_x_7, finish_sum_normals_y_0,
        finish_sum_normals_y_1, finish_sum_normals_y_2, finish_sum_normals_y_3, finish_sum_normals_y_4,
        finish_sum_normals_y_5, finish_sum_normals_y_6, finish_sum_normals_y_7, finish_sum_normals_z_0,
        finish_sum_normals_z_1, finish_sum_normals_z_2, finish_sum_normals_z_3, finish_sum_normals_z_4,
        finish_sum_normals_z_5, finish_sum_normals_z_6, finish_sum_normals_z_7
    } = finish_queue_out_data;

    memory_1w1r #(.WIDTH(32), .DEPTH(128)) wanted_copy_query_position_x (
        .clk(clk), .write(wanted_copy_query_position_x_write_either), .write_address(written_thread),
        .write_data(wanted_copy_query_position_x_data_choice),
        .read(want_valid_and_wanted_advances), .read_address(want_thread),
        .read_data(wanted_copy_query_position_x_read)
    );

    memory_1w1r #(.WIDTH(32), .DEPTH(128)) wanted_copy_query_position_y (
        .clk(clk), .write(wanted_copy_query_position_x_write_either), .write_address(written_thread),
        .write_data(wanted_copy_query_position_y_data_choice),
        .read(want_valid_and_wanted_advances), .read_address(want_thread),
        .read_data(wanted_copy_query_position_y_read)
    );

    memory_1w1r #(.WIDTH(32), .DEPTH(128)) wanted_copy_query_position_z (
        .clk(clk), .write(wanted_copy_query_position_x_write_either), .write_address(written_thread),
        .write_data(wanted_copy_query_position_z_data_choice),
        .read(want_valid_and_wanted_advances), .read_address(want_thread),
        .read_data(wanted_copy_query_position_z_read)
    );

    memory_1w1r #(.WIDTH(32), .DEPTH(128)) init_copy_query_position_x (
        .clk(clk), .write(wanted_copy_query_position_x_write_either), .write_address(written_thread),
        .write_data(wanted_copy_query_position_x_data_choice),
        .read(reads_init_both), .read_address(prepare_thread), .read_data(init_copy_query_position_x_read)
    );

    memory_1w1r #(.WIDTH(32), .DEPTH(128)) init_copy_query_position_y (
        .clk(clk), .write(wanted_copy_query_position_x_write_either), .write_address(written_thread),
        .write_data(wanted_copy_query_position_y_data_choice),
        .read(reads_init_both), .read_address(prepare_thread), .read_data(init_copy_query_position_y_read)
    );

    memory_1w1r #(.WIDTH(32), .DEPTH(128)) init_copy_query_position_z (
        .clk(clk), .write(wanted_copy_query_position_x_write_either), .write_address(written_thread),
        .write_data(wanted_copy_query_position_z_data_choice),
        .read(reads_init_both), .read_address(prepare_thread), .read_data(init_copy_query_position_z_read)
    );

    memory_1w1r #(.WIDTH(16), .DEPTH(128)) init_copy_count (
        .clk(clk), .write(fresh_valid | updates), .write_address(written_thread),
        .write_data(fresh_valid ? 16'd0 : update_queue_out_count),
        .read(reads_init_both), .read_address(prepare_thread), .read_data(init_copy_count_read)
    );

    memory_1w1r #(.WIDTH(32), .DEPTH(128)) kernel_copy_query_position_x (
        .clk(clk), .write(wanted_copy_query_position_x_write_either), .write_address(written_thread),
        .write_data(wanted_copy_query_position_x_data_choice),
        .read(neighbor_arrives), .read_address(gathered_thread),
        .read_data(kernel_copy_query_position_x_read)
    );

    memory_1w1r #(.WIDTH(32), .DEPTH(128)) kernel_copy_query_position_y (
        .clk(clk), .write(wanted_copy_query_position_x_write_either), .write_address(written_thread),
        .write_data(wanted_copy_query_position_y_data_choice),
        .read(neighbor_arrives), .read_address(gathered_thread),
        .read_data(kernel_copy_query_position_y_read)
    );

    memory_1w1r #(.WIDTH(32), .DEPTH(128)) kernel_copy_query_position_z (
        .clk(clk), .write(wanted_copy_query_position_x_write_either), .write_address(written_thread),
        .write_data(wanted_copy_query_position_z_data_choice),
        .read(neighbor_arrives), .read_address(gathered_thread),
        .read_data(kernel_copy_query_position_z_read)
    );

    memory_1w1r #(.WIDTH(32), .DEPTH(128)) finish_copy_query_position_x (
        .clk(clk), .write(wanted_copy_query_position_x_write_either), .write_address(written_thread),
        .write_data(wanted_copy_query_position_x_data_choice),
        .read(sums_valid), .read_address(sums_thread), .read_data(finish_copy_query_position_x_read)
    );

    memory_1w1r #(.WIDTH(32), .DEPTH(128)) finish_copy_query_position_y (
        .clk(clk), .write(wanted_copy_query_position_x_write_either), .write_address(written_thread),
        .write_data(wanted_copy_query_position_y_data_choice),
        .read(sums_valid), .read_address(sums_thread), .read_data(finish_copy_query_position_y_read)
    );

    memory_1w1r #(.WIDTH(32), .DEPTH(128)) finish_copy_query_position_z (
        .clk(clk), .write(wanted_copy_query_position_x_write_either), .write_address(written_thread),
        .write_data(wanted_copy_query_position_z_data_choice),
        .read(sums_valid), .read_address(sums_thread), .read_data(finish_copy_query_position_z_read)
    );

    memory_1w1r #(.WIDTH(32), .DEPTH(128)) finish_copy_state_start_x (
        .clk(clk), .write(finish_copy_state_start_x_write_either), .write_address(written_thread),
        .write_data(stored ? stores_queue_out_state_start_x : 32'd0),
        .read(sums_valid), .read_address(sums_thread), .read_data(finish_copy_state_start_x_read)
    );

    memory_1w1r #(.WIDTH(32), .DEPTH(128)) finish_copy_state_start_y (
        .clk(clk), .write(finish_copy_state_start_x_write_either), .write_address(written_thread),
        .write_data(stored ? stores_queue_out_state_start_y : 32'd0),
        .read(sums_valid), .read_address(sums_thread), .read_data(finish_copy_state_start_y_read)
    );

    memory_1w1r #(.WIDTH(32), .DEPTH(128)) finish_copy_state_start_z (
        .clk(clk), .write(finish_copy_state_start_x_write_either), .write_address(written_thread),
        .write_data(stored ? stores_queue_out_state_start_z : 32'd0),
        .read(sums_valid), .read_address(sums_thread), .read_data(finish_copy_state_start_z_read)
    );

    stream_skid_w121 update_queue (
        .clk(clk), .rst(rst), .in_valid(update_valid), .in_ready(update_ready),
        .in_data({
            update_thread, update_search, update_moved_position_x, update_moved_position_y,
            update_moved_position_z, update_move, update_count
        }),
        .out_valid(update_queue_out_valid), .out_ready(update_queue_out_ready),
        .out_data(update_queue_out_data)
    );

    stream_skid_w104 stores_queue (
        .clk(clk), .rst(rst), .in_valid(stores_valid), .in_ready(stores_ready),
        .in_data({
            stores_thread, stores_state_start_x, stores_state_start_y, stores_state_start_z, stores_write_start
        }),
        .out_valid(stores_queue_out_valid), .out_ready(stores_queue_out_ready),
        .out_data(stores_queue_out_data)
    );

    stream_skid_w103 wanted_queue (
        .clk(clk), .rst(rst), .in_valid(reads_wanted & wanted_advances), .in_ready(wanted_queue_in_ready),
        .in_data({
            wanted_read_thread, wanted_copy_query_position_x_read, wanted_copy_query_position_y_read,
            wanted_copy_query_position_z_read
        }),
        .out_valid(wanted_valid), .out_ready(wanted_ready), .out_data(wanted_queue_out_data)
    );

    stream_skid_w297 kernel_queue (
        .clk(clk), .rst(rst), .in_valid(reads_kernel & kernel_advances), .in_ready(kernel_queue_in_ready),
        .in_data({
            kernel_read_thread, kernel_read_none, kernel_read_last, kernel_copy_query_position_x_read,
            kernel_copy_query_position_y_read, kernel_copy_query_position_z_read, kernel_read_neighbor_position_x,
            kernel_read_neighbor_position_y, kernel_read_neighbor_position_z, kernel_read_neighbor_normal_x,
            kernel_read_neighbor_normal_y, kernel_read_neighbor_normal_z
        }),
        .out_valid(kernel_valid), .out_ready(kernel_ready), .out_data(kernel_queue_out_data)
    );

    stream_skid_w135 init_queue (
        .clk(clk), .rst(rst), .in_valid(reads_init & init_advances), .in_ready(init_queue_in_ready),
        .in_data({
            init_read_thread, init_copy_query_position_x_read, init_copy_query_position_y_read,
            init_copy_query_position_z_read, 16'd0, init_copy_count_read
        }),
        .out_valid(init_valid), .out_ready(init_ready), .out_data(init_queue_out_data)
    );

    stream_half_buffer_w1991 finish_queue (
        .clk(clk), .rst(rst), .in_valid(takes_sums), .in_ready(finish_queue_in_ready),
        .in_data({
            sums_thread, finish_copy_query_position_x_read, finish_copy_query_position_y_read,
            finish_copy_query_position_z_read, finish_copy_state_start_x_read, finish_copy_state_start_y_read,
            finish_copy_state_start_z_read, sums_weight_0, sums_weight_1, sums_weight_2, sums_weight_3,
            sums_weight_4, sums_weight_5, sums_weight_6, sums_weight_7, sums_points_x_0, sums_points_x_1,
            sums_points_x_2, sums_points_x_3, sums_points_x_4, sums_points_x_5, sums_points_x_6, sums_points_x_7,
            sums_points_y_0, sums_points_y_1, sums_points_y_2, sums_points_y_3, sums_points_y_4, sums_points_y_5,
            sums_points_y_6, sums_points_y_7, sums_points_z_0, sums_points_z_1, sums_points_z_2, sums_points_z_3,
            sums_points_z_4, sums_points_z_5, sums_points_z_6, sums_points_z_7, sums_normals_x_0,
            sums_normals_x_1, sums_normals_x_2, sums_normals_x_3, sums_normals_x_4, sums_normals_x_5,
            sums_normals_x_6, sums_normals_x_7, sums_normals_y_0, sums_normals_y_1, sums_normals_y_2,
            sums_normals_y_3, sums_normals_y_4, sums_normals_y_5, sums_normals_y_6, sums_normals_y_7,
            sums_normals_z_0, sums_normals_z_1, sums_normals_z_2, sums_normals_z_3, sums_normals_z_4,
            sums_normals_z_5, sums_normals_z_6, sums_normals_z_7
        }),
        .out_valid(finish_valid), .out_ready(finish_ready), .out_data(finish_queue_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            again_valid <= 1'd0;
            prepared_valid <= 1'd0;
            reads_wanted <= 1'd0;
            reads_kernel <= 1'd0;
            reads_init <= 1'd0;
            finish_read <= 1'd0;
        end else begin
            again_valid <= updates;
            prepared_valid <= stored;
            finish_read <= sums_valid & ~takes_sums;
            if (wanted_advances) reads_wanted <= want_valid;
            if (kernel_advances) reads_kernel <= neighbor_arrives;
            if (init_advances) reads_init <= reads_init_both;
        end
    end
    always @(posedge clk) begin
        again_thread <= update_queue_out_thread;
        again_search <= update_queue_out_search;
        prepared_thread <= stores_queue_out_thread;
        if (wanted_advances) wanted_read_thread <= want_thread;
        if (init_advances) init_read_thread <= prepare_thread;
        if (neighbor_arrives) begin
            kernel_read_neighbor_position_x <= gathered_position_x;
            kernel_read_neighbor_position_y <= gathered_position_y;
            kernel_read_neighbor_position_z <= gathered_position_z;
            kernel_read_neighbor_normal_x <= gathered_normal_x;
            kernel_read_neighbor_normal_y <= gathered_normal_y;
            kernel_read_neighbor_normal_z <= gathered_normal_z;
        end
        if (kernel_advances) begin
            kernel_read_thread <= gathered_thread;
            kernel_read_none <= gathered_none;
            kernel_read_last <= gathered_last;
        end
    end

    wire _unused = &{1'b0, listed_neighbors, listed_thread, listed_valid};
endmodule

// One item in a register, at half rate.
// width = 1991
module stream_half_buffer_w1991 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [1990:0] in_data,
    output wire out_valid, input wire out_ready, output wire [1990:0] out_data
);
    reg filled;
    reg [1990:0] item;

    assign in_ready = ~filled;

    assign out_valid = filled;
    assign out_data = item;

    always @(posedge clk) begin
        if (rst) filled <= 1'd0;
        else filled <= filled ? ~out_ready : in_valid;
    end
    always @(posedge clk) if (in_ready) item <= in_data;
endmodule

// Queue of two in registers.
// width = 135
module stream_skid_w135 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [134:0] in_data,
    output wire out_valid, input wire out_ready, output wire [134:0] out_data
);
    reg head_filled, second_filled, room;
    reg [134:0] head, second;

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
// width = 297
module stream_skid_w297 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [296:0] in_data,
    output wire out_valid, input wire out_ready, output wire [296:0] out_data
);
    reg head_filled, second_filled, room;
    reg [296:0] head, second;

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
// width = 103
module stream_skid_w103 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [102:0] in_data,
    output wire out_valid, input wire out_ready, output wire [102:0] out_data
);
    reg head_filled, second_filled, room;
    reg [102:0] head, second;

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
// width = 104
module stream_skid_w104 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [103:0] in_data,
    output wire out_valid, input wire out_ready, output wire [103:0] out_data
);
    reg head_filled, second_filled, room;
    reg [103:0] head, second;

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
// width = 121
module stream_skid_w121 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [120:0] in_data,
    output wire out_valid, input wire out_ready, output wire [120:0] out_data
);
    reg head_filled, second_filled, room;
    reg [120:0] head, second;

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

// Gives queries to threads and says which block each goes to next.
// threads = 128
// neighbors = 32
module process_control (
    input  wire clk, input wire rst,
    input  wire again_valid,  // A query is not done.
    input  wire [6:0] again_thread,  // Thread.
    input  wire again_search,  // It needs the neighbors of its position; else it goes on with those it has.
    input  wire query_valid, output wire query_ready,  // Queries.
    input  wire [23:0] query_number,  // Its number, which its result bears.
    input  wire [31:0] query_query_position_x,  // Words of the query, its position first.
    input  wire [31:0] query_query_position_y,  // Words of the query, its position first.
    input  wire [31:0] query_query_position_z,  // Words of the query, its position first.
    input  wire released_valid,  // A thread's query has left.
    input  wire [6:0] released_thread,  // Thread.
    output reg  start_valid,  // A thread takes up a query.
    output reg  [6:0] start_thread,  // Thread.
    output reg  [23:0] start_number,  // Its number, which its result bears.
    output reg  [31:0] start_query_position_x,  // Words of the query, its position first.
    output reg  [31:0] start_query_position_y,  // Words of the query, its position first.
    output reg  [31:0] start_query_position_z,  // Words of the query, its position first.
    output reg  event_query_wait,  // A query waits for a thread.
    output wire idle,  // No thread has a query.
    output wire want_valid, input wire want_ready,  // Threads that want the neighbors of their position.
    output wire [6:0] want_thread,  // Thread.
    input  wire found_valid, output wire found_ready,  // Neighbors found.
    input  wire [6:0] found_thread,  // Thread.
    input  wire found_last,  // Closes the search.
    input  wire found_found,  // There is a neighbor.
    input  wire [23:0] found_index,  // The neighbor.
    output reg  listed_valid,  // A thread's neighbors are complete.
    output reg  [6:0] listed_thread,  // Thread.
    output reg  [5:0] listed_neighbors,  // How many.
    input  wire prepared_valid,  // A thread has been through `init`.
    input  wire [6:0] prepared_thread,  // Thread.
    output wire prepare_valid, input wire prepare_ready,  // Threads for `init`.
    output wire [6:0] prepare_thread,  // Thread.
    output wire gather_valid, input wire gather_ready,  // Neighbors wanted, for `kernel` a query after the other.
    output wire [6:0] gather_thread,  // Thread.
    output wire gather_farthest,  // It is the farthest, for `init`; else one of those that `kernel` goes through.
    output wire gather_none,  // There is none: the query has no neighbors.
    output wire gather_last,  // The last one of its query that `kernel` goes through.
    output wire [23:0] gather_index  // Its index, where there is one.
);
    (* ram_style = "distributed" *)
    reg [5:0] ends [0:127];
    reg [7:0] issued;
    reg entering_valid;
    reg [7:0] busy;
    reg [6:0] entering_thread;
    reg [4:0] found_rank;
    reg turn_valid;
    reg [6:0] turn_thread;  // Thread.
    reg [4:0] turn_rank;  // The neighbor that is next.
    reg [4:0] turn_last;  // Its last one.
    reg turn_farthest;  // It is the farthest neighbor, for `init`.
    reg turn_none;  // There is none.
    reg read_valid;
    reg [6:0] read_thread;  // Thread.
    reg read_farthest;  // It is the farthest, for `init`; else one of those that `kernel` goes through.
    reg read_none;  // There is none: the query has no neighbors.
    reg read_last;  // The last one of its query that `kernel` goes through.
    wire [23:0] index;

    wire free_in_ready, free_out_valid;
    wire [6:0] free_out_data;
    wire wants_in_ready, found_queue_out_valid;
    wire [32:0] found_queue_out_data;
    wire runs_in_ready, runs_out_valid;
    wire [6:0] runs_out_data;
    wire readies_in_ready, gather_queue_in_ready;
    wire [33:0] gather_queue_out_data;

    wire is_new = issued < 8'd128;
    wire is_free = is_new | free_out_valid;
    assign query_ready = is_free & ~entering_valid;
    wire kept = again_valid & ~again_search;
    wire found_queue_out_ready = ~kept;
    wire take_found = found_queue_out_valid & found_queue_out_ready;
    wire found_queue_out_found = found_queue_out_data[24];
    wire [6:0] found_queue_out_thread = found_queue_out_data[32:26];
    wire [23:0] found_queue_out_index = found_queue_out_data[23:0];
    wire advance = ~read_valid | gather_queue_in_ready;
    wire emits = turn_valid & advance;
    wire take = query_valid & query_ready;
    wire free_out_ready = take & ~is_new;
    wire searched = again_valid & again_search;
    wire searched_or_entering_valid = searched | entering_valid;
    wire is_last = turn_rank == turn_last;
    wire turn_free = ~turn_valid | (emits & is_last);
    wire found_queue_out_last = found_queue_out_data[25];
    wire complete = take_found & found_queue_out_last;
    wire is_ready = kept | complete;
    wire [6:0] start_thread_choice = is_new ? issued[6:0] : free_out_data;
    wire turn_begins = turn_free & runs_out_valid;
    wire turn_begins_or_emits = turn_begins | emits;
    wire [5:0] list_end = ends[runs_out_data];

    assign idle = busy == 8'd0;
    assign {gather_thread, gather_farthest, gather_none, gather_last, gather_index} = gather_queue_out_data;

    memory_1w1r_unordered #(.WIDTH(24), .DEPTH(4096)) lists (
        .clk(clk), .write(take_found & found_queue_out_found),
        .write_address({found_queue_out_thread, found_rank}), .write_data(found_queue_out_index),
        .read(emits), .read_address({turn_thread, turn_rank}), .read_data(index)
    );

    stream_fifo_d128_w7_distributed free (
        .clk(clk), .rst(rst), .in_valid(released_valid), .in_ready(free_in_ready), .in_data(released_thread),
        .out_valid(free_out_valid), .out_ready(free_out_ready), .out_data(free_out_data)
    );

    stream_fifo_d128_w7_distributed wants (
        .clk(clk), .rst(rst), .in_valid(searched_or_entering_valid), .in_ready(wants_in_ready),
        .in_data(searched ? again_thread : entering_thread),
        .out_valid(want_valid), .out_ready(want_ready), .out_data(want_thread)
    );

    stream_skid_w33 found_queue (
        .clk(clk), .rst(rst), .in_valid(found_valid), .in_ready(found_ready),
        .in_data({found_thread, found_last, found_found, found_index}),
        .out_valid(found_queue_out_valid), .out_ready(found_queue_out_ready), .out_data(found_queue_out_data)
    );

    stream_fifo_d128_w7_distributed runs (
        .clk(clk), .rst(rst), .in_valid(prepared_valid), .in_ready(runs_in_ready), .in_data(prepared_thread),
        .out_valid(runs_out_valid), .out_ready(turn_free), .out_data(runs_out_data)
    );

    stream_fifo_d128_w7_distributed readies (
        .clk(clk), .rst(rst), .in_valid(is_ready), .in_ready(readies_in_ready),
        .in_data(kept ? again_thread : found_queue_out_thread),
        .out_valid(prepare_valid), .out_ready(prepare_ready), .out_data(prepare_thread)
    );

    stream_skid_w34 gather_queue (
        .clk(clk), .rst(rst), .in_valid(read_valid), .in_ready(gather_queue_in_ready),
        .in_data({read_thread, read_farthest, read_none, read_last, index & {24{~read_none}}}),
        .out_valid(gather_valid), .out_ready(gather_ready), .out_data(gather_queue_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            issued <= 8'd0;
            entering_valid <= 1'd0;
            start_valid <= 1'd0;
            event_query_wait <= 1'd0;
            busy <= 8'd0;
            found_rank <= 5'd0;
            listed_valid <= 1'd0;
            turn_valid <= 1'd0;
            read_valid <= 1'd0;
        end else begin
            if (take & is_new) issued <= issued + 8'd1;
            entering_valid <= take | (entering_valid & searched);
            start_valid <= take;
            event_query_wait <= query_valid & ~is_free;
            busy <= (busy + {7'd0, take}) - {7'd0, released_valid};
            listed_valid <= complete;
            turn_valid <= turn_begins | (turn_valid & ~turn_free);
            if (take_found) found_rank <= found_queue_out_last ? 5'd0 : (found_rank + 5'd1);
            if (advance) read_valid <= turn_valid;
        end
    end
    always @(posedge clk) begin
        start_thread <= start_thread_choice;
        start_number <= query_number;
        start_query_position_x <= query_query_position_x;
        start_query_position_y <= query_query_position_y;
        start_query_position_z <= query_query_position_z;
        listed_thread <= found_queue_out_thread;
        listed_neighbors <= found_queue_out_found ? ({1'd0, found_rank} + 6'd1) : 6'd0;
        if (take) entering_thread <= start_thread_choice;
        if (turn_begins_or_emits) begin
            turn_thread <= turn_begins ? runs_out_data : turn_thread;
            turn_rank <= turn_begins ? 5'd0 : (turn_rank + 5'd1);
            turn_last <= turn_begins ? list_end[4:0] : turn_last;
            turn_farthest <= turn_begins ? 1'd0 : turn_farthest;
            turn_none <= turn_begins ? list_end[5] : turn_none;
        end
        if (advance) begin
            read_thread <= turn_thread;
            read_farthest <= turn_farthest;
            read_none <= turn_none;
            read_last <= is_last & ~turn_farthest;
        end
    end
    always @(posedge clk) if (complete) ends[found_queue_out_thread] <= {~found_queue_out_found, found_rank};

    wire _unused = &{1'b0, free_in_ready, readies_in_ready, runs_in_ready, wants_in_ready};

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        free_has_room: assert (~released_valid | free_in_ready);
        wants_has_room: assert (~searched_or_entering_valid | wants_in_ready);
        finds_nothing_in_final: assert (~(again_valid & found_queue_out_valid) | ~(found_queue_out_thread == again_thread));
        a_list_ends_where_it_is_full: assert (~take_found | (found_queue_out_last | ~(found_rank == 5'd31)));
        runs_has_room: assert (~prepared_valid | runs_in_ready);
        readies_has_room: assert (~is_ready | readies_in_ready);
`else
        if (!(~released_valid | free_in_ready)) begin
            $display("assertion failed: free_has_room in %m"); $stop;
        end
        if (!(~searched_or_entering_valid | wants_in_ready)) begin
            $display("assertion failed: wants_has_room in %m"); $stop;
        end
        if (!(~(again_valid & found_queue_out_valid) | ~(found_queue_out_thread == again_thread))) begin
            $display("assertion failed: finds_nothing_in_final in %m"); $stop;
        end
        if (!(~take_found | (found_queue_out_last | ~(found_rank == 5'd31)))) begin
            $display("assertion failed: a_list_ends_where_it_is_full in %m"); $stop;
        end
        if (!(~prepared_valid | runs_in_ready)) begin
            $display("assertion failed: runs_has_room in %m"); $stop;
        end
        if (!(~is_ready | readies_in_ready)) begin
            $display("assertion failed: readies_has_room in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Queue of two in registers.
// width = 34
module stream_skid_w34 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [33:0] in_data,
    output wire out_valid, input wire out_ready, output wire [33:0] out_data
);
    reg head_filled, second_filled, room;
    reg [33:0] head, second;

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
// width = 33
module stream_skid_w33 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [32:0] in_data,
    output wire out_valid, input wire out_ready, output wire [32:0] out_data
);
    reg head_filled, second_filled, room;
    reg [32:0] head, second;

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
// depth = 128
// width = 7
// storage = distributed
module stream_fifo_d128_w7_distributed (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [6:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [6:0] out_data
);
    (* ram_style = "distributed" *)
    reg [6:0] entries [0:127];
    reg [7:0] held, waiting;
    reg is_full, any_waits;
    reg [6:0] write_address, read_address, item;

    wire has_room = ~is_full;
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [7:0] held_bits = {{7{~push}}, 1'd1};
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    always @(posedge clk) begin
        if (rst) begin
            held <= 8'd0;
            waiting <= 8'd0;
            is_full <= 1'd0;
            any_waits <= 1'd0;
            write_address <= 7'd0;
            read_address <= 7'd0;
            out_valid <= 1'd0;
        end else begin
            if (push_xor_pop) begin
                held <= held + held_bits;
                is_full <= push & (held == 8'd127);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 8'd1);
            end
            if (push) write_address <= write_address + 7'd1;
            if (fetch) read_address <= read_address + 7'd1;
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
        held_in_range: assert (held <= 8'd128);
        held_is_waiting_and_shown: assert (held == (waiting + {7'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 8'd128)) & (any_waits == |waiting));
`else
        if (!(held <= 8'd128)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {7'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 8'd128)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// The block `init` of the program.
// latency = 1
// initiation_interval = 8
module process_init (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready,  // What it takes.
    input  wire [6:0] in_thread,  // Thread.
    input  wire [31:0] in_query_position_x,  // Words that `init` reads besides settings.
    input  wire [31:0] in_query_position_y,  // Words that `init` reads besides settings.
    input  wire [31:0] in_query_position_z,  // Words that `init` reads besides settings.
    input  wire [31:0] in_count,  // Words that `init` reads besides settings.
    output wire out_valid, input wire out_ready,  // What it writes.
    output wire [6:0] out_thread,  // Thread.
    output wire [31:0] out_state_start_x,  // Words of the state.
    output wire [31:0] out_state_start_y,  // Words of the state.
    output wire [31:0] out_state_start_z,  // Words of the state.
    output wire out_write_start  // Which fields of it are written.
);
    reg [1:0] credits;
    reg [7:0] phases_1;
    reg [6:0] thread_d1;
    reg [31:0] query_position_x_d1, query_position_y_d1, query_position_z_d1;
    reg first_d1, in_flight, left;

    wire queue_1_in_ready;
    wire [103:0] queue_1_out_data;

    assign in_ready = ~credits[1] & phases_1[0];
    wire kept = in_flight & phases_1[1];
    wire in_valid_and_in_ready = in_valid & in_ready;
    wire first = in_count == 32'd0;

    assign {out_thread, out_state_start_x, out_state_start_y, out_state_start_z, out_write_start} = queue_1_out_data;

    stream_fifo_d2_w104_distributed queue_1 (
        .clk(clk), .rst(rst), .in_valid(kept), .in_ready(queue_1_in_ready),
        .in_data({thread_d1, query_position_x_d1, query_position_y_d1, query_position_z_d1, first_d1}),
        .out_valid(out_valid), .out_ready(out_ready), .out_data(queue_1_out_data)
    );

    always @(posedge clk) begin
        if (rst) begin
            credits <= 2'd1;
            phases_1 <= 8'd1;
            in_flight <= 1'd0;
            left <= 1'd0;
        end else begin
            credits <= (credits - {1'd0, in_valid_and_in_ready}) + {1'd0, left};
            phases_1 <= {phases_1[6:0], phases_1[7]};
            left <= out_valid & out_ready;
            if (phases_1[0]) in_flight <= in_valid_and_in_ready;
        end
    end
    always @(posedge clk) begin
        if (phases_1[0]) begin
            thread_d1 <= in_thread;
            query_position_x_d1 <= in_query_position_x;
            query_position_y_d1 <= in_query_position_y;
            query_position_z_d1 <= in_query_position_z;
            first_d1 <= first;
        end
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
// depth = 2
// width = 104
// storage = distributed
module stream_fifo_d2_w104_distributed (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [103:0] in_data,
    output reg  out_valid, input wire out_ready, output wire [103:0] out_data
);
    (* ram_style = "distributed" *)
    reg [103:0] entries [0:1];
    reg [1:0] held, waiting;
    reg is_full, any_waits, write_address, read_address;
    reg [103:0] item;

    wire has_room = ~is_full;
    wire push = in_valid & has_room;
    wire pop = out_valid & out_ready;
    wire push_xor_pop = push ^ pop;
    wire [1:0] held_bits = {~push, 1'd1};
    wire fetch = any_waits & (~out_valid | out_ready);
    wire push_xor_fetch = push ^ fetch;

    assign in_ready = has_room;
    assign out_data = item;

    always @(posedge clk) begin
        if (rst) begin
            held <= 2'd0;
            waiting <= 2'd0;
            is_full <= 1'd0;
            any_waits <= 1'd0;
            write_address <= 1'd0;
            read_address <= 1'd0;
            out_valid <= 1'd0;
        end else begin
            if (push_xor_pop) begin
                held <= held + held_bits;
                is_full <= push & (held == 2'd1);
            end
            if (push_xor_fetch) begin
                waiting <= waiting + held_bits;
                any_waits <= push | ~(waiting == 2'd1);
            end
            if (push) write_address <= write_address + 1'd1;
            if (fetch) read_address <= read_address + 1'd1;
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
        held_in_range: assert (held <= 2'd2);
        held_is_waiting_and_shown: assert (held == (waiting + {1'd0, out_valid}));
        full_and_waiting_are_told: assert ((is_full == (held == 2'd2)) & (any_waits == |waiting));
`else
        if (!(held <= 2'd2)) begin $display("assertion failed: held_in_range in %m"); $stop; end
        if (!(held == (waiting + {1'd0, out_valid}))) begin
            $display("assertion failed: held_is_waiting_and_shown in %m"); $stop;
        end
        if (!((is_full == (held == 2'd2)) & (any_waits == |waiting))) begin
            $display("assertion failed: full_and_waiting_are_told in %m"); $stop;
        end
`endif
    end
`endif
endmodule

// Neighbor search: queries in, nearest neighbors out.
module search_top (
    input  wire clk, input wire rst,
    input  wire tree_valid,  // Write to the tree memories, not while a query is under way.
    input  wire tree_is_leaf,  // Chooses the leaf table, else the node memory.
    input  wire [13:0] tree_address,  // The leaf's number or the node.
    input  wire [31:0] tree_split,  // Where its plane cuts its dimension.
    input  wire [1:0] tree_dimension,  // Its dimension.
    input  wire tree_internal_leaf,  // It is a leaf.
    input  wire [21:0] tree_begin,  // The first beat.
    input  wire [2:0] tree_beats,  // The number of beats, at least one.
    input  wire query_valid, output wire query_ready,  // Queries.
    input  wire [23:0] query_number,  // Its number, which its results bear.
    input  wire [5:0] query_k,  // Neighbors wanted.
    input  wire [31:0] query_radius2,  // Squared radius within which neighbors count.
    input  wire [31:0] query_x,  // Where.
    input  wire [31:0] query_y,  // Where.
    input  wire [31:0] query_z,  // Where.
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
    output wire event_node,  // A node was visited.
    output wire event_pop,  // A path was popped.
    output wire event_beat,  // A priority queue was done with a beat of points.
    output wire event_insert,  // A neighbor was inserted.
    output wire event_insert_wait,  // A beat stayed for one more insertion.
    output wire event_thread_wait,  // A query waited for a free thread.
    output wire event_point_hit,  // The point cache had a leaf that was wanted.
    output wire event_point_miss  // The point cache lacked a leaf that was wanted.
);
    wire threads_start_valid;
    wire [3:0] threads_start_thread;
    wire [23:0] threads_start_number;
    wire [5:0] threads_start_k;
    wire [31:0] threads_start_radius2, threads_start_x, threads_start_y, threads_start_z;
    wire threads_descend_valid;
    wire [3:0] threads_descend_thread;
    wire [14:0] threads_descend_node;
    wire threads_pop_valid;
    wire [3:0] threads_pop_thread;
    wire threads_finish_valid;
    wire [3:0] threads_finish_thread;
    wire traversal_descend_ready, traversal_resume_ready, traversal_leaf_valid;
    wire [3:0] traversal_leaf_thread;
    wire [13:0] traversal_leaf_leaf;
    wire traversal_push_valid;
    wire [3:0] traversal_push_thread;
    wire [14:0] traversal_push_node;
    wire [30:0] traversal_push_distance2;
    wire traversal_reached_valid;
    wire [3:0] traversal_reached_thread;
    wire stack_top_empty;
    wire [14:0] stack_top_node;
    wire [30:0] stack_top_distance2;
    wire recursion_in_ready, recursion_resume_valid;
    wire [3:0] recursion_resume_thread;
    wire [14:0] recursion_resume_node;
    wire recursion_pop_valid;
    wire [3:0] recursion_pop_thread;
    wire recursion_empty_valid;
    wire [3:0] recursion_empty_thread;
    wire leaf_leaf_ready, leaf_fetch_valid;
    wire [3:0] leaf_fetch_thread;
    wire [21:0] leaf_fetch_address;
    wire [2:0] leaf_fetch_beats;
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
    wire point_cache_fetch_ready, point_cache_beat_valid;
    wire [3:0] point_cache_beat_thread;
    wire [21:0] point_cache_beat_address;
    wire point_cache_beat_last;
    wire [31:0] point_cache_beat_x0, point_cache_beat_y0, point_cache_beat_z0, point_cache_beat_x1;
    wire [31:0] point_cache_beat_y1, point_cache_beat_z1, point_cache_beat_x2, point_cache_beat_y2;
    wire [31:0] point_cache_beat_z2, point_cache_beat_x3, point_cache_beat_y3, point_cache_beat_z3;

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
        .fetch_valid(leaf_fetch_valid), .fetch_ready(point_cache_fetch_ready),
        .fetch_thread(leaf_fetch_thread), .fetch_address(leaf_fetch_address), .fetch_beats(leaf_fetch_beats),
        .start_valid(threads_start_valid), .start_thread(threads_start_thread),
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
        .result_valid(result_valid), .result_ready(result_ready), .result_number(result_number),
        .result_last(result_last), .result_found(result_found), .result_index(result_index),
        .result_distance2(result_distance2),
        .event_beat(event_beat), .event_insert_wait(event_insert_wait)
    );

    search_point_cache point_cache (
        .clk(clk), .rst(rst), .fetch_valid(leaf_fetch_valid), .fetch_ready(point_cache_fetch_ready),
        .fetch_thread(leaf_fetch_thread), .fetch_address(leaf_fetch_address), .fetch_beats(leaf_fetch_beats),
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
    input  wire tree_valid,  // Write to the leaf table.
    input  wire tree_is_leaf,  // Chooses the leaf table, else the node memory.
    input  wire [13:0] tree_address,  // The leaf's number or the node.
    input  wire [31:0] tree_split,  // Where its plane cuts its dimension.
    input  wire [1:0] tree_dimension,  // Its dimension.
    input  wire tree_internal_leaf,  // It is a leaf.
    input  wire [21:0] tree_begin,  // The first beat.
    input  wire [2:0] tree_beats,  // The number of beats, at least one.
    input  wire leaf_valid, output wire leaf_ready,  // Leaves reached.
    input  wire [3:0] leaf_thread,  // Thread.
    input  wire [13:0] leaf_leaf,  // The leaf's number among those of the deepest level (eq. 6.7).
    output wire fetch_valid, input wire fetch_ready,  // Requests to the memory.
    output wire [3:0] fetch_thread,  // Thread.
    output wire [21:0] fetch_address,  // First beat.
    output wire [2:0] fetch_beats,  // Number of beats, at least one.
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
    reg f0_valid, f1_valid;
    reg [3:0] f0_thread, f1_thread;
    wire [24:0] f0_found;
    reg [21:0] f1_begin;  // The first beat.
    reg [2:0] f1_beats;  // The number of beats, at least one.
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

    wire leaf_queue_out_valid;
    wire [17:0] leaf_queue_out_data;
    wire fetch_queue_in_ready;
    wire [28:0] fetch_queue_out_data;
    wire beat_queue_out_valid;
    wire [410:0] beat_queue_out_data;
    wire distance_in_ready;

    wire writes_leaf = tree_valid & tree_is_leaf;
    wire table_advance = ~f1_valid | fetch_queue_in_ready;
    wire [13:0] leaf_queue_out_leaf = leaf_queue_out_data[13:0];
    wire query_advance = ~query_valid | distance_in_ready;
    wire [3:0] beat_queue_out_thread = beat_queue_out_data[410:407];
    wire beat_queue_out_ready = query_empty | distance_in_ready;
    wire [3:0] leaf_queue_out_thread = leaf_queue_out_data[17:14];
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

    assign {fetch_thread, fetch_address, fetch_beats} = fetch_queue_out_data;

    memory_1w1r_unordered #(.WIDTH(25), .DEPTH(16384), .SLICE(1)) leaves (
        .clk(clk), .write(writes_leaf), .write_address(tree_address), .write_data({tree_begin, tree_beats}),
        .read(table_advance), .read_address(leaf_queue_out_leaf), .read_data(f0_found)
    );

    memory_1w1r #(.WIDTH(96), .DEPTH(16)) queries (
        .clk(clk), .write(start_valid), .write_address(start_thread),
        .write_data({start_x, start_y, start_z}),
        .read(query_advance), .read_address(beat_queue_out_thread), .read_data(query)
    );

    stream_skid_w18 leaf_queue (
        .clk(clk), .rst(rst), .in_valid(leaf_valid), .in_ready(leaf_ready),
        .in_data({leaf_thread, leaf_leaf}),
        .out_valid(leaf_queue_out_valid), .out_ready(table_advance), .out_data(leaf_queue_out_data)
    );

    stream_skid_w29 fetch_queue (
        .clk(clk), .rst(rst), .in_valid(f1_valid), .in_ready(fetch_queue_in_ready),
        .in_data({f1_thread, f1_begin, f1_beats}),
        .out_valid(fetch_valid), .out_ready(fetch_ready), .out_data(fetch_queue_out_data)
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
            f1_begin <= f0_found[24:3];
            f1_beats <= f0_found[2:0];
        end
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

    wire _unused = &{1'b0, start_k, start_number, start_radius2, tree_dimension, tree_internal_leaf, tree_split};

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        no_leaf_is_looked_up_while_one_is_written: assert (~(writes_leaf & leaf_queue_out_valid));
        start_radius2_in_range: assert (~start_valid | (start_radius2 < 32'h80000000));
        query_valid_or_empty: assert (query_valid ^ query_empty);
`else
        if (!(~(writes_leaf & leaf_queue_out_valid))) begin
            $display("assertion failed: no_leaf_is_looked_up_while_one_is_written in %m"); $stop;
        end
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
    input  wire [14:0] top_node,  // The subtree's root.
    input  wire [30:0] top_distance2,  // Squared distance of the query to the splitting plane before it.
    output wire resume_valid, input wire resume_ready,  // Descents from a path that was not taken before.
    output wire [3:0] resume_thread,  // Thread.
    output wire [14:0] resume_node,  // Node: 1 is the root, `2i` and `2i + 1` are the children of `i`.
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
    reg [14:0] path_node;  // The subtree's root.
    reg [30:0] path_distance2;  // Squared distance of the query to the splitting plane before it.
    reg [15:0] from_leaf;
    reg [30:0] radius2;

    wire in_queue_out_valid;
    wire [3:0] in_queue_out_data;
    wire resume_queue_in_ready;
    wire [18:0] resume_queue_out_data;

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

    stream_skid_w19 resume_queue (
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
// depth = 14
module search_stack (
    input  wire clk, input wire rst,
    input  wire push_valid,  // A path to remember.
    input  wire [3:0] push_thread,  // Thread.
    input  wire [14:0] push_node,  // The subtree's root.
    input  wire [30:0] push_distance2,  // Squared distance of the query to the splitting plane before it.
    input  wire pop_valid,  // A thread that wants its last path back.
    input  wire [3:0] pop_thread,  // Thread.
    output reg  top_empty,  // The stack of the last pop was empty.
    output wire [14:0] top_node,  // The subtree's root.
    output wire [30:0] top_distance2  // Squared distance of the query to the splitting plane before it.
);
    reg [3:0] depth_0, depth_1, depth_2, depth_3, depth_4, depth_5, depth_6, depth_7, depth_8, depth_9, depth_10;
    reg [3:0] depth_11, depth_12, depth_13, depth_14, depth_15;
    wire [45:0] top;

    wire [3:0] push_depth_choice = push_thread[1] ? (push_thread[0] ? depth_15 : depth_14) : push_thread[0] ? depth_13 : depth_12;
    wire [3:0] push_depth_choice_2 = push_thread[1] ? (push_thread[0] ? depth_11 : depth_10) : push_thread[0] ? depth_9 : depth_8;
    wire [3:0] push_depth_choice_3 = push_thread[1] ? (push_thread[0] ? depth_7 : depth_6) : push_thread[0] ? depth_5 : depth_4;
    wire [3:0] push_depth_choice_4 = push_thread[1] ? (push_thread[0] ? depth_3 : depth_2) : push_thread[0] ? depth_1 : depth_0;
    wire [3:0] push_depth = push_thread[3] ? (push_thread[2] ? push_depth_choice : push_depth_choice_2) : push_thread[2] ? push_depth_choice_3 : push_depth_choice_4;
    wire [3:0] pop_depth_choice = pop_thread[1] ? (pop_thread[0] ? depth_15 : depth_14) : pop_thread[0] ? depth_13 : depth_12;
    wire [3:0] pop_depth_choice_2 = pop_thread[1] ? (pop_thread[0] ? depth_11 : depth_10) : pop_thread[0] ? depth_9 : depth_8;
    wire [3:0] pop_depth_choice_3 = pop_thread[1] ? (pop_thread[0] ? depth_7 : depth_6) : pop_thread[0] ? depth_5 : depth_4;
    wire [3:0] pop_depth_choice_4 = pop_thread[1] ? (pop_thread[0] ? depth_3 : depth_2) : pop_thread[0] ? depth_1 : depth_0;
    wire [3:0] pop_depth = pop_thread[3] ? (pop_thread[2] ? pop_depth_choice : pop_depth_choice_2) : pop_thread[2] ? pop_depth_choice_3 : pop_depth_choice_4;
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

    memory_1w1r_unordered #(.WIDTH(46), .DEPTH(256)) paths (
        .clk(clk), .write(push_valid), .write_address({push_thread, push_depth}),
        .write_data({push_node, push_distance2}),
        .read(takes), .read_address({pop_thread, pop_depth - 4'd1}), .read_data(top)
    );

    always @(posedge clk) begin
        if (rst) begin
            depth_0 <= 4'd0;
            depth_1 <= 4'd0;
            depth_2 <= 4'd0;
            depth_3 <= 4'd0;
            depth_4 <= 4'd0;
            depth_5 <= 4'd0;
            depth_6 <= 4'd0;
            depth_7 <= 4'd0;
            depth_8 <= 4'd0;
            depth_9 <= 4'd0;
            depth_10 <= 4'd0;
            depth_11 <= 4'd0;
            depth_12 <= 4'd0;
            depth_13 <= 4'd0;
            depth_14 <= 4'd0;
            depth_15 <= 4'd0;
            top_empty <= 1'd1;
        end else begin
            if (up[0] | down[0]) depth_0 <= up[0] ? (depth_0 + 4'd1) : (depth_0 - 4'd1);
            if (up[1] | down[1]) depth_1 <= up[1] ? (depth_1 + 4'd1) : (depth_1 - 4'd1);
            if (up[2] | down[2]) depth_2 <= up[2] ? (depth_2 + 4'd1) : (depth_2 - 4'd1);
            if (up[3] | down[3]) depth_3 <= up[3] ? (depth_3 + 4'd1) : (depth_3 - 4'd1);
            if (up[4] | down[4]) depth_4 <= up[4] ? (depth_4 + 4'd1) : (depth_4 - 4'd1);
            if (up[5] | down[5]) depth_5 <= up[5] ? (depth_5 + 4'd1) : (depth_5 - 4'd1);
            if (up[6] | down[6]) depth_6 <= up[6] ? (depth_6 + 4'd1) : (depth_6 - 4'd1);
            if (up[7] | down[7]) depth_7 <= up[7] ? (depth_7 + 4'd1) : (depth_7 - 4'd1);
            if (up[8] | down[8]) depth_8 <= up[8] ? (depth_8 + 4'd1) : (depth_8 - 4'd1);
            if (up[9] | down[9]) depth_9 <= up[9] ? (depth_9 + 4'd1) : (depth_9 - 4'd1);
            if (up[10] | down[10]) depth_10 <= up[10] ? (depth_10 + 4'd1) : (depth_10 - 4'd1);
            if (up[11] | down[11]) depth_11 <= up[11] ? (depth_11 + 4'd1) : (depth_11 - 4'd1);
            if (up[12] | down[12]) depth_12 <= up[12] ? (depth_12 + 4'd1) : (depth_12 - 4'd1);
            if (up[13] | down[13]) depth_13 <= up[13] ? (depth_13 + 4'd1) : (depth_13 - 4'd1);
            if (up[14] | down[14]) depth_14 <= up[14] ? (depth_14 + 4'd1) : (depth_14 - 4'd1);
            if (up[15] | down[15]) depth_15 <= up[15] ? (depth_15 + 4'd1) : (depth_15 - 4'd1);
            if (pop_valid) top_empty <= pop_depth == 4'd0;
        end
    end

`ifdef RTL_ASSERT
    always @(posedge clk) if (!rst) begin
`ifdef FORMAL
        stack_has_room: assert (~push_valid | (push_depth < 4'd14));
        one_access_a_thread: assert (~(push_valid & pop_valid & (push_thread == pop_thread)));
`else
        if (!(~push_valid | (push_depth < 4'd14))) begin
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
// tree_depth = 14
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
    input  wire [14:0] descend_node,  // Node: 1 is the root, `2i` and `2i + 1` are the children of `i`.
    input  wire resume_valid, output wire resume_ready,  // Descents from a path that was not taken before.
    input  wire [3:0] resume_thread,  // Thread.
    input  wire [14:0] resume_node,  // Node: 1 is the root, `2i` and `2i + 1` are the children of `i`.
    output wire leaf_valid, input wire leaf_ready,  // Leaves reached.
    output wire [3:0] leaf_thread,  // Thread.
    output wire [13:0] leaf_leaf,  // The leaf's number among those of the deepest level (eq. 6.7).
    input  wire tree_valid,  // Write to the node memory.
    input  wire tree_is_leaf,  // Chooses the leaf table, else the node memory.
    input  wire [13:0] tree_address,  // The leaf's number or the node.
    input  wire [31:0] tree_split,  // Where its plane cuts its dimension.
    input  wire [1:0] tree_dimension,  // Its dimension.
    input  wire tree_internal_leaf,  // It is a leaf.
    input  wire [21:0] tree_begin,  // The first beat.
    input  wire [2:0] tree_beats,  // The number of beats, at least one.
    output reg  event_node,  // A node was visited.
    output wire push_valid,  // A path to remember.
    output wire [3:0] push_thread,  // Thread.
    output wire [14:0] push_node,  // The subtree's root.
    output wire [30:0] push_distance2,  // Squared distance of the query to the splitting plane before it.
    output wire reached_valid,  // A thread's descent ended in a leaf.
    output wire [3:0] reached_thread  // Thread.
);
    reg f_valid;
    reg [3:0] f_thread;  // Thread.
    reg [14:0] f_node;  // Node: 1 is the root, `2i` and `2i + 1` are the children of `i`.
    reg v_valid;
    reg [3:0] v_thread;  // Thread.
    reg [14:0] v_node;  // Node: 1 is the root, `2i` and `2i + 1` are the children of `i`.
    reg s_valid;
    reg [3:0] s_thread;  // Thread.
    reg [14:0] s_node;  // Node: 1 is the root, `2i` and `2i + 1` are the children of `i`.
    reg f_is_child, s_at_leaf;
    reg [31:0] s_coordinate, s_split;
    reg [1:0] s_dimension;
    wire [34:0] even_node, odd_node;
    reg [31:0] v_even_split, v_odd_split;
    reg [1:0] v_dimension;
    reg v_internal_leaf;
    reg [3:0] v_places;
    wire [95:0] query;

    wire descend_queue_out_valid;
    wire [18:0] descend_queue_out_data;
    wire resume_queue_out_valid;
    wire [18:0] resume_queue_out_data;
    wire leaf_queue_in_ready;
    wire [17:0] leaf_queue_out_data;
    wire path_in_ready, path_out_valid, path_out_is_leaf, less_x_even_y, less_y_even_y, less_z_even_y;
    wire less_x_odd_y, less_y_odd_y, less_z_odd_y;

    wire writes_even_both = tree_valid & ~tree_is_leaf;
    wire writes_even = writes_even_both & ~tree_address[0];
    wire [34:0] even_nodes_data_bits = {tree_split, tree_dimension, tree_internal_leaf};
    wire at_leaf = v_node[14] | v_internal_leaf;
    wire reaches = v_valid & at_leaf;
    wire proceeds = ~reaches | leaf_queue_in_ready;
    wire advance = path_in_ready & proceeds;
    wire descends = v_valid & ~at_leaf;
    wire [14:0] resume_queue_out_node = resume_queue_out_data[14:0];
    wire [14:0] descend_queue_out_node = descend_queue_out_data[14:0];
    wire [14:0] next_node_choice = resume_queue_out_valid ? resume_queue_out_node : descend_queue_out_node;
    wire [14:0] next_node = descends ? {v_node[13:0], 1'd0} : next_node_choice;
    wire writes_odd = writes_even_both & tree_address[0];
    wire resumes = resume_queue_out_valid & ~descends;
    wire descend_queue_out_ready = advance & ~(descends | resumes);
    wire resume_queue_out_ready = advance & ~descends;
    wire [14:0] v_node_shifted_by_v_places = v_node << v_places;
    wire left_choice = s_dimension[1] ? less_z_odd_y : s_dimension[0] ? less_y_odd_y : less_x_odd_y;
    wire left_choice_2 = s_dimension[1] ? less_z_even_y : s_dimension[0] ? less_y_even_y : less_x_even_y;
    wire left = s_node[0] ? left_choice : left_choice_2;
    wire [3:0] resume_queue_out_thread = resume_queue_out_data[18:15];
    wire [3:0] descend_queue_out_thread = descend_queue_out_data[18:15];
    wire [3:0] f_thread_choice = resume_queue_out_valid ? resume_queue_out_thread : descend_queue_out_thread;
    wire v_node_choice = f_is_child ? ~left : f_node[0];
    wire [31:0] coordinate = v_dimension[1] ? query[31:0] : v_dimension[0] ? query[63:32] : query[95:64];
    wire v_places_both = ~f_node[14] & ~f_node[13];
    wire v_places_both_2 = v_places_both & (~f_node[12] & ~f_node[11]);
    wire not_f_node_10_and_not_f_node_9 = ~f_node[10] & ~f_node[9];
    wire v_places_both_3 = v_places_both_2 & (not_f_node_10_and_not_f_node_9 & (~f_node[8] & ~f_node[7]));
    wire not_f_node_6_and_not_f_node_5 = ~f_node[6] & ~f_node[5];
    wire v_places_both_4 = not_f_node_6_and_not_f_node_5 & (~f_node[4] & ~f_node[3]);
    wire not_f_node_2_and_not_f_node_1 = ~f_node[2] & ~f_node[1];
    wire [1:0] v_places_bits = {not_f_node_2_and_not_f_node_1, not_f_node_2_and_not_f_node_1 ? 1'd0 : ~f_node[2]};
    wire [1:0] v_places_bits_2 = {not_f_node_6_and_not_f_node_5, not_f_node_6_and_not_f_node_5 ? ~f_node[4] : ~f_node[6]};
    wire [2:0] v_places_bits_3 = {v_places_both_4, v_places_both_4 ? v_places_bits : v_places_bits_2};
    wire [1:0] v_places_bits_4 = {not_f_node_10_and_not_f_node_9, not_f_node_10_and_not_f_node_9 ? ~f_node[8] : ~f_node[10]};
    wire [1:0] v_places_choice = v_places_both_2 ? v_places_bits_4 : {v_places_both, v_places_both ? ~f_node[12] : ~f_node[14]};
    wire [2:0] v_places_choice_2 = v_places_both_3 ? v_places_bits_3 : {v_places_both_2, v_places_choice};

    assign {leaf_thread, leaf_leaf} = leaf_queue_out_data;
    assign push_valid = path_out_valid & ~path_out_is_leaf;
    assign reached_valid = path_out_valid & path_out_is_leaf;
    assign reached_thread = push_thread;

    memory_1w1r_unordered #(.WIDTH(35), .DEPTH(8192), .SLICE(2)) even_nodes (
        .clk(clk), .write(writes_even), .write_address(tree_address[13:1]), .write_data(even_nodes_data_bits),
        .read(advance), .read_address(next_node[13:1]), .read_data(even_node)
    );

    memory_1w1r_unordered #(.WIDTH(35), .DEPTH(8192), .SLICE(2)) odd_nodes (
        .clk(clk), .write(writes_odd), .write_address(tree_address[13:1]), .write_data(even_nodes_data_bits),
        .read(advance), .read_address(next_node[13:1]), .read_data(odd_node)
    );

    memory_1w1r #(.WIDTH(96), .DEPTH(16)) queries (
        .clk(clk), .write(start_valid), .write_address(start_thread),
        .write_data({start_x, start_y, start_z}),
        .read(advance), .read_address(f_thread), .read_data(query)
    );

    stream_skid_w19 descend_queue (
        .clk(clk), .rst(rst), .in_valid(descend_valid), .in_ready(descend_ready),
        .in_data({descend_thread, descend_node}),
        .out_valid(descend_queue_out_valid), .out_ready(descend_queue_out_ready),
        .out_data(descend_queue_out_data)
    );

    stream_skid_w19 resume_queue (
        .clk(clk), .rst(rst), .in_valid(resume_valid), .in_ready(resume_ready),
        .in_data({resume_thread, resume_node}),
        .out_valid(resume_queue_out_valid), .out_ready(resume_queue_out_ready),
        .out_data(resume_queue_out_data)
    );

    stream_skid_w18 leaf_queue (
        .clk(clk), .rst(rst), .in_valid(advance & reaches), .in_ready(leaf_queue_in_ready),
        .in_data({v_thread, v_node_shifted_by_v_places[13:0]}),
        .out_valid(leaf_valid), .out_ready(leaf_ready), .out_data(leaf_queue_out_data)
    );

    search_path path (
        .clk(clk), .rst(rst), .in_valid(s_valid & proceeds), .in_ready(path_in_ready), .in_is_leaf(s_at_leaf),
        .in_thread(s_thread), .in_node({s_node[13:0], left}), .in_coordinate(s_coordinate),
        .in_split(s_split),
        .out_valid(path_out_valid), .out_ready(1'd1), .out_is_leaf(path_out_is_leaf),
        .out_thread(push_thread), .out_node(push_node), .out_distance2(push_distance2)
    );

    float_lt_s1_f32ftz less_x_even (
        .clk(clk), .enable(advance), .a(query[95:64]), .b(v_even_split), .y(less_x_even_y)
    );

    float_lt_s1_f32ftz less_y_even (
        .clk(clk), .enable(advance), .a(query[63:32]), .b(v_even_split), .y(less_y_even_y)
    );

    float_lt_s1_f32ftz less_z_even (
        .clk(clk), .enable(advance), .a(query[31:0]), .b(v_even_split), .y(less_z_even_y)
    );

    float_lt_s1_f32ftz less_x_odd (
        .clk(clk), .enable(advance), .a(query[95:64]), .b(v_odd_split), .y(less_x_odd_y)
    );

    float_lt_s1_f32ftz less_y_odd (
        .clk(clk), .enable(advance), .a(query[63:32]), .b(v_odd_split), .y(less_y_odd_y)
    );

    float_lt_s1_f32ftz less_z_odd (
        .clk(clk), .enable(advance), .a(query[31:0]), .b(v_odd_split), .y(less_z_odd_y)
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
            v_node <= {f_node[14:1], v_node_choice};
            s_thread <= v_thread;
            s_node <= v_node;
            f_is_child <= descends;
            s_at_leaf <= at_leaf;
            s_coordinate <= coordinate;
            s_split <= v_node[0] ? v_odd_split : v_even_split;
            s_dimension <= v_dimension;
            v_even_split <= even_node[34:3];
            v_odd_split <= odd_node[34:3];
            v_dimension <= v_node_choice ? odd_node[2:1] : even_node[2:1];
            v_internal_leaf <= v_node_choice ? odd_node[0] : even_node[0];
            v_places <= {v_places_both_3, v_places_choice_2};
        end
    end

    wire _unused = &{
        1'b0, s_node[14], start_k, start_number, start_radius2, tree_beats, tree_begin,
        v_node_shifted_by_v_places[14]
    };

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

// Squared distance of a query to a splitting plane.
// latency = 11
// initiation_interval = 1
module search_path (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire in_is_leaf, input wire [3:0] in_thread,
    input  wire [14:0] in_node, input wire [31:0] in_coordinate, input wire [31:0] in_split,
    output wire out_valid, input wire out_ready, output wire out_is_leaf, output wire [3:0] out_thread,
    output wire [14:0] out_node, output wire [30:0] out_distance2
);
    (* ram_style = "distributed" *)
    reg [19:0] delay_11_from_0 [0:9];
    reg [3:0] delay_11_from_0_pointer;
    reg [19:0] delay_11_from_0_out;
    reg [10:0] in_flight;
    reg shown, shown_is_leaf;
    reg [3:0] shown_thread;
    reg [14:0] shown_node;
    reg [30:0] shown_distance2;

    wire [31:0] add_f32_ftz_unit_y, mul_f32_ftz_unit_y;

    wire kept = in_flight[10];
    wire is_leaf_d11 = delay_11_from_0_out[0];
    wire [3:0] thread_d11 = delay_11_from_0_out[4:1];
    wire [14:0] node_d11 = delay_11_from_0_out[19:5];

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
// width = 18
module stream_skid_w18 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [17:0] in_data,
    output wire out_valid, input wire out_ready, output wire [17:0] out_data
);
    reg head_filled, second_filled, room;
    reg [17:0] head, second;

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
    output wire [14:0] descend_node,  // Node: 1 is the root, `2i` and `2i + 1` are the children of `i`.
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
    wire [18:0] descend_queue_out_data;

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

    stream_skid_w19 descend_queue (
        .clk(clk), .rst(rst), .in_valid(start_valid), .in_ready(descend_queue_in_ready),
        .in_data({start_thread, 15'd1}),
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
// width = 19
module stream_skid_w19 (
    input  wire clk, input wire rst,
    input  wire in_valid, output wire in_ready, input wire [18:0] in_data,
    output wire out_valid, input wire out_ready, output wire [18:0] out_data
);
    reg head_filled, second_filled, room;
    reg [18:0] head, second;

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
