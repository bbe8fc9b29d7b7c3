// The whole design is one file, named after its top.
/* verilator lint_off DECLFILENAME */

// A unit between registers, behind few pins.
module search_pins (
    input  wire clk, input wire rst,
    input  wire serial_in, output wire serial_out
);
    reg drive_tree_valid, drive_tree_is_leaf;
    reg [13:0] drive_tree_address;
    reg [31:0] drive_tree_split;
    reg [1:0] drive_tree_dimension;
    reg drive_tree_internal_leaf;
    reg [21:0] drive_tree_begin;
    reg [2:0] drive_tree_beats;
    reg drive_query_valid, catch_query_ready;
    reg [23:0] drive_query_number;
    reg [5:0] drive_query_k;
    reg [31:0] drive_query_radius2, drive_query_x, drive_query_y, drive_query_z;
    reg catch_fetch_valid, drive_fetch_ready;
    reg [3:0] catch_fetch_thread;
    reg [21:0] catch_fetch_address;
    reg [2:0] catch_fetch_beats;
    reg drive_beat_valid, catch_beat_ready;
    reg [3:0] drive_beat_thread;
    reg [21:0] drive_beat_address;
    reg drive_beat_last;
    reg [31:0] drive_beat_x0, drive_beat_y0, drive_beat_z0, drive_beat_x1, drive_beat_y1, drive_beat_z1;
    reg [31:0] drive_beat_x2, drive_beat_y2, drive_beat_z2, drive_beat_x3, drive_beat_y3, drive_beat_z3;
    reg catch_result_valid, drive_result_ready;
    reg [23:0] catch_result_number;
    reg catch_result_last, catch_result_found;
    reg [23:0] catch_result_index;
    reg [31:0] catch_result_distance2;
    reg catch_event_node, catch_event_pop, catch_event_beat, catch_event_insert, catch_event_insert_wait;
    reg catch_event_thread_wait, catch_event_point_hit, catch_event_point_miss;
    reg [30:0] fold_0;
    reg [7:0] fold_1;
    reg [1:0] fold_2;
    reg fold_3;

    wire unit_query_ready, unit_fetch_valid;
    wire [3:0] unit_fetch_thread;
    wire [21:0] unit_fetch_address;
    wire [2:0] unit_fetch_beats;
    wire unit_beat_ready, unit_result_valid;
    wire [23:0] unit_result_number;
    wire unit_result_last, unit_result_found;
    wire [23:0] unit_result_index;
    wire [31:0] unit_result_distance2;
    wire unit_event_node, unit_event_pop, unit_event_beat, unit_event_insert, unit_event_insert_wait;
    wire unit_event_thread_wait, unit_event_point_hit, unit_event_point_miss;

    wire fold_0_unequal = drive_result_ready ^ catch_event_point_miss ^ catch_event_point_hit;
    wire fold_0_unequal_2 = catch_event_insert_wait ^ catch_event_insert ^ catch_event_beat ^ catch_event_pop;
    wire fold_0_unequal_3 = catch_event_node ^ catch_result_distance2[0] ^ catch_result_distance2[1];
    wire fold_0_unequal_4 = catch_result_distance2[3] ^ catch_result_distance2[4] ^ catch_result_distance2[5];
    wire fold_0_unequal_5 = catch_result_distance2[7] ^ catch_result_distance2[8] ^ catch_result_distance2[9];
    wire fold_0_unequal_6 = catch_result_distance2[11] ^ catch_result_distance2[12] ^ catch_result_distance2[13];
    wire fold_0_unequal_7 = catch_result_distance2[15] ^ catch_result_distance2[16] ^ catch_result_distance2[17];
    wire fold_0_unequal_8 = catch_result_distance2[19] ^ catch_result_distance2[20] ^ catch_result_distance2[21];
    wire fold_0_unequal_9 = catch_result_distance2[23] ^ catch_result_distance2[24] ^ catch_result_distance2[25];
    wire fold_0_unequal_10 = catch_result_distance2[27] ^ catch_result_distance2[28] ^ catch_result_distance2[29];
    wire fold_0_unequal_11 = catch_result_distance2[31] ^ catch_result_index[0] ^ catch_result_index[1];
    wire fold_0_unequal_12 = catch_result_index[3] ^ catch_result_index[4] ^ catch_result_index[5];
    wire fold_0_unequal_13 = catch_result_index[7] ^ catch_result_index[8] ^ catch_result_index[9];
    wire fold_0_unequal_14 = catch_result_index[11] ^ catch_result_index[12] ^ catch_result_index[13];
    wire fold_0_unequal_15 = catch_result_index[15] ^ catch_result_index[16] ^ catch_result_index[17];
    wire fold_0_unequal_16 = catch_result_index[19] ^ catch_result_index[20] ^ catch_result_index[21];
    wire fold_0_unequal_17 = catch_result_index[23] ^ catch_result_found ^ catch_result_last ^ catch_result_number[0];
    wire fold_0_unequal_18 = catch_result_number[1] ^ catch_result_number[2] ^ catch_result_number[3];
    wire fold_0_unequal_19 = catch_result_number[5] ^ catch_result_number[6] ^ catch_result_number[7];
    wire fold_0_unequal_20 = catch_result_number[9] ^ catch_result_number[10] ^ catch_result_number[11];
    wire fold_0_unequal_21 = catch_result_number[13] ^ catch_result_number[14] ^ catch_result_number[15];
    wire fold_0_unequal_22 = catch_result_number[17] ^ catch_result_number[18] ^ catch_result_number[19];
    wire fold_0_unequal_23 = catch_result_number[21] ^ catch_result_number[22] ^ catch_result_number[23];
    wire fold_0_unequal_24 = catch_beat_ready ^ catch_fetch_beats[0] ^ catch_fetch_beats[1] ^ catch_fetch_beats[2];
    wire fold_0_unequal_25 = catch_fetch_address[0] ^ catch_fetch_address[1] ^ catch_fetch_address[2];
    wire fold_0_unequal_26 = catch_fetch_address[4] ^ catch_fetch_address[5] ^ catch_fetch_address[6];
    wire fold_0_unequal_27 = catch_fetch_address[8] ^ catch_fetch_address[9] ^ catch_fetch_address[10];
    wire fold_0_unequal_28 = catch_fetch_address[12] ^ catch_fetch_address[13] ^ catch_fetch_address[14];
    wire fold_0_unequal_29 = catch_fetch_address[16] ^ catch_fetch_address[17] ^ catch_fetch_address[18];
    wire fold_0_unequal_30 = catch_fetch_address[20] ^ catch_fetch_address[21] ^ catch_fetch_thread[0];
    wire fold_0_unequal_31 = catch_fetch_thread[2] ^ catch_fetch_thread[3] ^ catch_fetch_valid;

    assign serial_out = fold_3;

    search_top unit (
        .clk(clk), .rst(rst), .tree_valid(drive_tree_valid), .tree_is_leaf(drive_tree_is_leaf),
        .tree_address(drive_tree_address), .tree_split(drive_tree_split),
        .tree_dimension(drive_tree_dimension), .tree_internal_leaf(drive_tree_internal_leaf),
        .tree_begin(drive_tree_begin), .tree_beats(drive_tree_beats),
        .query_valid(drive_query_valid), .query_ready(unit_query_ready), .query_number(drive_query_number),
        .query_k(drive_query_k), .query_radius2(drive_query_radius2), .query_x(drive_query_x),
        .query_y(drive_query_y), .query_z(drive_query_z),
        .fetch_valid(unit_fetch_valid), .fetch_ready(drive_fetch_ready), .fetch_thread(unit_fetch_thread),
        .fetch_address(unit_fetch_address), .fetch_beats(unit_fetch_beats),
        .beat_valid(drive_beat_valid), .beat_ready(unit_beat_ready), .beat_thread(drive_beat_thread),
        .beat_address(drive_beat_address), .beat_last(drive_beat_last), .beat_x0(drive_beat_x0),
        .beat_y0(drive_beat_y0), .beat_z0(drive_beat_z0), .beat_x1(drive_beat_x1), .beat_y1(drive_beat_y1),
        .beat_z1(drive_beat_z1), .beat_x2(drive_beat_x2), .beat_y2(drive_beat_y2), .beat_z2(drive_beat_z2),
        .beat_x3(drive_beat_x3), .beat_y3(drive_beat_y3), .beat_z3(drive_beat_z3),
        .result_valid(unit_result_valid), .result_ready(drive_result_ready),
        .result_number(unit_result_number), .result_last(unit_result_last), .result_found(unit_result_found),
        .result_index(unit_result_index), .result_distance2(unit_result_distance2),
        .event_node(unit_event_node), .event_pop(unit_event_pop), .event_beat(unit_event_beat),
        .event_insert(unit_event_insert), .event_insert_wait(unit_event_insert_wait),
        .event_thread_wait(unit_event_thread_wait), .event_point_hit(unit_event_point_hit),
        .event_point_miss(unit_event_point_miss)
    );

    always @(posedge clk) begin
        drive_tree_valid <= serial_in;
        drive_tree_is_leaf <= drive_tree_valid;
        drive_tree_address <= {drive_tree_address[12:0], drive_tree_is_leaf};
        drive_tree_split <= {drive_tree_split[30:0], drive_tree_address[13]};
        drive_tree_dimension <= {drive_tree_dimension[0], drive_tree_split[31]};
        drive_tree_internal_leaf <= drive_tree_dimension[1];
        drive_tree_begin <= {drive_tree_begin[20:0], drive_tree_internal_leaf};
        drive_tree_beats <= {drive_tree_beats[1:0], drive_tree_begin[21]};
        drive_query_valid <= drive_tree_beats[2];
        catch_query_ready <= unit_query_ready;
        drive_query_number <= {drive_query_number[22:0], drive_query_valid};
        drive_query_k <= {drive_query_k[4:0], drive_query_number[23]};
        drive_query_radius2 <= {drive_query_radius2[30:0], drive_query_k[5]};
        drive_query_x <= {drive_query_x[30:0], drive_query_radius2[31]};
        drive_query_y <= {drive_query_y[30:0], drive_query_x[31]};
        drive_query_z <= {drive_query_z[30:0], drive_query_y[31]};
        catch_fetch_valid <= unit_fetch_valid;
        drive_fetch_ready <= drive_query_z[31];
        catch_fetch_thread <= unit_fetch_thread;
        catch_fetch_address <= unit_fetch_address;
        catch_fetch_beats <= unit_fetch_beats;
        drive_beat_valid <= drive_fetch_ready;
        catch_beat_ready <= unit_beat_ready;
        drive_beat_thread <= {drive_beat_thread[2:0], drive_beat_valid};
        drive_beat_address <= {drive_beat_address[20:0], drive_beat_thread[3]};
        drive_beat_last <= drive_beat_address[21];
        drive_beat_x0 <= {drive_beat_x0[30:0], drive_beat_last};
        drive_beat_y0 <= {drive_beat_y0[30:0], drive_beat_x0[31]};
        drive_beat_z0 <= {drive_beat_z0[30:0], drive_beat_y0[31]};
        drive_beat_x1 <= {drive_beat_x1[30:0], drive_beat_z0[31]};
        drive_beat_y1 <= {drive_beat_y1[30:0], drive_beat_x1[31]};
        drive_beat_z1 <= {drive_beat_z1[30:0], drive_beat_y1[31]};
        drive_beat_x2 <= {drive_beat_x2[30:0], drive_beat_z1[31]};
        drive_beat_y2 <= {drive_beat_y2[30:0], drive_beat_x2[31]};
        drive_beat_z2 <= {drive_beat_z2[30:0], drive_beat_y2[31]};
        drive_beat_x3 <= {drive_beat_x3[30:0], drive_beat_z2[31]};
        drive_beat_y3 <= {drive_beat_y3[30:0], drive_beat_x3[31]};
        drive_beat_z3 <= {drive_beat_z3[30:0], drive_beat_y3[31]};
        catch_result_valid <= unit_result_valid;
        drive_result_ready <= drive_beat_z3[31];
        catch_result_number <= unit_result_number;
        catch_result_last <= unit_result_last;
        catch_result_found <= unit_result_found;
        catch_result_index <= unit_result_index;
        catch_result_distance2 <= unit_result_distance2;
        catch_event_node <= unit_event_node;
        catch_event_pop <= unit_event_pop;
        catch_event_beat <= unit_event_beat;
        catch_event_insert <= unit_event_insert;
        catch_event_insert_wait <= unit_event_insert_wait;
        catch_event_thread_wait <= unit_event_thread_wait;
        catch_event_point_hit <= unit_event_point_hit;
        catch_event_point_miss <= unit_event_point_miss;
        fold_0 <= {
            fold_0_unequal ^ catch_event_thread_wait, fold_0_unequal_2,
            fold_0_unequal_3 ^ catch_result_distance2[2], fold_0_unequal_4 ^ catch_result_distance2[6],
            fold_0_unequal_5 ^ catch_result_distance2[10], fold_0_unequal_6 ^ catch_result_distance2[14],
            fold_0_unequal_7 ^ catch_result_distance2[18], fold_0_unequal_8 ^ catch_result_distance2[22],
            fold_0_unequal_9 ^ catch_result_distance2[26], fold_0_unequal_10 ^ catch_result_distance2[30],
            fold_0_unequal_11 ^ catch_result_index[2], fold_0_unequal_12 ^ catch_result_index[6],
            fold_0_unequal_13 ^ catch_result_index[10], fold_0_unequal_14 ^ catch_result_index[14],
            fold_0_unequal_15 ^ catch_result_index[18], fold_0_unequal_16 ^ catch_result_index[22],
            fold_0_unequal_17, fold_0_unequal_18 ^ catch_result_number[4],
            fold_0_unequal_19 ^ catch_result_number[8], fold_0_unequal_20 ^ catch_result_number[12],
            fold_0_unequal_21 ^ catch_result_number[16], fold_0_unequal_22 ^ catch_result_number[20],
            fold_0_unequal_23 ^ catch_result_valid, fold_0_unequal_24, fold_0_unequal_25 ^ catch_fetch_address[3],
            fold_0_unequal_26 ^ catch_fetch_address[7], fold_0_unequal_27 ^ catch_fetch_address[11],
            fold_0_unequal_28 ^ catch_fetch_address[15], fold_0_unequal_29 ^ catch_fetch_address[19],
            fold_0_unequal_30 ^ catch_fetch_thread[1], fold_0_unequal_31 ^ catch_query_ready
        };
        fold_1 <= {
            fold_0[0] ^ fold_0[1] ^ fold_0[2] ^ fold_0[3], fold_0[4] ^ fold_0[5] ^ fold_0[6] ^ fold_0[7],
            fold_0[8] ^ fold_0[9] ^ fold_0[10] ^ fold_0[11], fold_0[12] ^ fold_0[13] ^ fold_0[14] ^ fold_0[15],
            fold_0[16] ^ fold_0[17] ^ fold_0[18] ^ fold_0[19], fold_0[20] ^ fold_0[21] ^ fold_0[22] ^ fold_0[23],
            fold_0[24] ^ fold_0[25] ^ fold_0[26] ^ fold_0[27], fold_0[28] ^ fold_0[29] ^ fold_0[30]
        };
        fold_2 <= {fold_1[0] ^ fold_1[1] ^ fold_1[2] ^ fold_1[3], fold_1[4] ^ fold_1[5] ^ fold_1[6] ^ fold_1[7]};
        fold_3 <= fold_2[0] ^ fold_2[1];
    end
endmodule
