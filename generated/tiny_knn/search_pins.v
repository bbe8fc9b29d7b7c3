// The whole design is one file, named after its top.
/* verilator lint_off DECLFILENAME */

// A unit between registers, behind few pins.
module search_pins (
    input  wire clk, input wire rst,
    input  wire serial_in, output wire serial_out
);
    reg drive_tree_valid, drive_tree_is_leaf;
    reg [5:0] drive_tree_address;
    reg [23:0] drive_tree_split;
    reg [1:0] drive_tree_dimension;
    reg drive_tree_internal_leaf;
    reg [15:0] drive_tree_begin;
    reg [3:0] drive_tree_beats;
    reg drive_query_valid, catch_query_ready;
    reg [15:0] drive_query_number;
    reg [3:0] drive_query_k;
    reg [23:0] drive_query_radius2, drive_query_x, drive_query_y, drive_query_z;
    reg catch_fetch_valid, drive_fetch_ready;
    reg [1:0] catch_fetch_thread;
    reg [15:0] catch_fetch_address;
    reg [3:0] catch_fetch_beats;
    reg drive_beat_valid, catch_beat_ready;
    reg [1:0] drive_beat_thread;
    reg [15:0] drive_beat_address;
    reg drive_beat_last;
    reg [23:0] drive_beat_x0, drive_beat_y0, drive_beat_z0;
    reg catch_result_valid, drive_result_ready;
    reg [15:0] catch_result_number;
    reg catch_result_last, catch_result_found;
    reg [15:0] catch_result_index;
    reg [23:0] catch_result_distance2;
    reg catch_event_node, catch_event_pop, catch_event_beat, catch_event_insert, catch_event_thread_wait;
    reg [22:0] fold_0;
    reg [5:0] fold_1;
    reg [1:0] fold_2;
    reg fold_3;

    wire unit_query_ready, unit_fetch_valid;
    wire [1:0] unit_fetch_thread;
    wire [15:0] unit_fetch_address;
    wire [3:0] unit_fetch_beats;
    wire unit_beat_ready, unit_result_valid;
    wire [15:0] unit_result_number;
    wire unit_result_last, unit_result_found;
    wire [15:0] unit_result_index;
    wire [23:0] unit_result_distance2;
    wire unit_event_node, unit_event_pop, unit_event_beat, unit_event_insert, unit_event_thread_wait;

    wire fold_0_unequal = drive_result_ready ^ catch_event_thread_wait ^ catch_event_insert;
    wire fold_0_unequal_2 = catch_event_pop ^ catch_event_node ^ catch_result_distance2[0] ^ catch_result_distance2[1];
    wire fold_0_unequal_3 = catch_result_distance2[2] ^ catch_result_distance2[3] ^ catch_result_distance2[4];
    wire fold_0_unequal_4 = catch_result_distance2[6] ^ catch_result_distance2[7] ^ catch_result_distance2[8];
    wire fold_0_unequal_5 = catch_result_distance2[10] ^ catch_result_distance2[11] ^ catch_result_distance2[12];
    wire fold_0_unequal_6 = catch_result_distance2[14] ^ catch_result_distance2[15] ^ catch_result_distance2[16];
    wire fold_0_unequal_7 = catch_result_distance2[18] ^ catch_result_distance2[19] ^ catch_result_distance2[20];
    wire fold_0_unequal_8 = catch_result_distance2[22] ^ catch_result_distance2[23] ^ catch_result_index[0];
    wire fold_0_unequal_9 = catch_result_index[2] ^ catch_result_index[3] ^ catch_result_index[4];
    wire fold_0_unequal_10 = catch_result_index[6] ^ catch_result_index[7] ^ catch_result_index[8];
    wire fold_0_unequal_11 = catch_result_index[10] ^ catch_result_index[11] ^ catch_result_index[12];
    wire fold_0_unequal_12 = catch_result_index[14] ^ catch_result_index[15] ^ catch_result_found;
    wire fold_0_unequal_13 = catch_result_number[0] ^ catch_result_number[1] ^ catch_result_number[2];
    wire fold_0_unequal_14 = catch_result_number[4] ^ catch_result_number[5] ^ catch_result_number[6];
    wire fold_0_unequal_15 = catch_result_number[8] ^ catch_result_number[9] ^ catch_result_number[10];
    wire fold_0_unequal_16 = catch_result_number[12] ^ catch_result_number[13] ^ catch_result_number[14];
    wire fold_0_unequal_17 = catch_result_valid ^ catch_beat_ready ^ catch_fetch_beats[0] ^ catch_fetch_beats[1];
    wire fold_0_unequal_18 = catch_fetch_beats[2] ^ catch_fetch_beats[3] ^ catch_fetch_address[0];
    wire fold_0_unequal_19 = catch_fetch_address[2] ^ catch_fetch_address[3] ^ catch_fetch_address[4];
    wire fold_0_unequal_20 = catch_fetch_address[6] ^ catch_fetch_address[7] ^ catch_fetch_address[8];
    wire fold_0_unequal_21 = catch_fetch_address[10] ^ catch_fetch_address[11] ^ catch_fetch_address[12];
    wire fold_0_unequal_22 = catch_fetch_address[14] ^ catch_fetch_address[15] ^ catch_fetch_thread[0];

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
        .beat_y0(drive_beat_y0), .beat_z0(drive_beat_z0),
        .result_valid(unit_result_valid), .result_ready(drive_result_ready),
        .result_number(unit_result_number), .result_last(unit_result_last), .result_found(unit_result_found),
        .result_index(unit_result_index), .result_distance2(unit_result_distance2),
        .event_node(unit_event_node), .event_pop(unit_event_pop), .event_beat(unit_event_beat),
        .event_insert(unit_event_insert), .event_thread_wait(unit_event_thread_wait)
    );

    always @(posedge clk) begin
        drive_tree_valid <= serial_in;
        drive_tree_is_leaf <= drive_tree_valid;
        drive_tree_address <= {drive_tree_address[4:0], drive_tree_is_leaf};
        drive_tree_split <= {drive_tree_split[22:0], drive_tree_address[5]};
        drive_tree_dimension <= {drive_tree_dimension[0], drive_tree_split[23]};
        drive_tree_internal_leaf <= drive_tree_dimension[1];
        drive_tree_begin <= {drive_tree_begin[14:0], drive_tree_internal_leaf};
        drive_tree_beats <= {drive_tree_beats[2:0], drive_tree_begin[15]};
        drive_query_valid <= drive_tree_beats[3];
        catch_query_ready <= unit_query_ready;
        drive_query_number <= {drive_query_number[14:0], drive_query_valid};
        drive_query_k <= {drive_query_k[2:0], drive_query_number[15]};
        drive_query_radius2 <= {drive_query_radius2[22:0], drive_query_k[3]};
        drive_query_x <= {drive_query_x[22:0], drive_query_radius2[23]};
        drive_query_y <= {drive_query_y[22:0], drive_query_x[23]};
        drive_query_z <= {drive_query_z[22:0], drive_query_y[23]};
        catch_fetch_valid <= unit_fetch_valid;
        drive_fetch_ready <= drive_query_z[23];
        catch_fetch_thread <= unit_fetch_thread;
        catch_fetch_address <= unit_fetch_address;
        catch_fetch_beats <= unit_fetch_beats;
        drive_beat_valid <= drive_fetch_ready;
        catch_beat_ready <= unit_beat_ready;
        drive_beat_thread <= {drive_beat_thread[0], drive_beat_valid};
        drive_beat_address <= {drive_beat_address[14:0], drive_beat_thread[1]};
        drive_beat_last <= drive_beat_address[15];
        drive_beat_x0 <= {drive_beat_x0[22:0], drive_beat_last};
        drive_beat_y0 <= {drive_beat_y0[22:0], drive_beat_x0[23]};
        drive_beat_z0 <= {drive_beat_z0[22:0], drive_beat_y0[23]};
        catch_result_valid <= unit_result_valid;
        drive_result_ready <= drive_beat_z0[23];
        catch_result_number <= unit_result_number;
        catch_result_last <= unit_result_last;
        catch_result_found <= unit_result_found;
        catch_result_index <= unit_result_index;
        catch_result_distance2 <= unit_result_distance2;
        catch_event_node <= unit_event_node;
        catch_event_pop <= unit_event_pop;
        catch_event_beat <= unit_event_beat;
        catch_event_insert <= unit_event_insert;
        catch_event_thread_wait <= unit_event_thread_wait;
        fold_0 <= {
            fold_0_unequal ^ catch_event_beat, fold_0_unequal_2, fold_0_unequal_3 ^ catch_result_distance2[5],
            fold_0_unequal_4 ^ catch_result_distance2[9], fold_0_unequal_5 ^ catch_result_distance2[13],
            fold_0_unequal_6 ^ catch_result_distance2[17], fold_0_unequal_7 ^ catch_result_distance2[21],
            fold_0_unequal_8 ^ catch_result_index[1], fold_0_unequal_9 ^ catch_result_index[5],
            fold_0_unequal_10 ^ catch_result_index[9], fold_0_unequal_11 ^ catch_result_index[13],
            fold_0_unequal_12 ^ catch_result_last, fold_0_unequal_13 ^ catch_result_number[3],
            fold_0_unequal_14 ^ catch_result_number[7], fold_0_unequal_15 ^ catch_result_number[11],
            fold_0_unequal_16 ^ catch_result_number[15], fold_0_unequal_17,
            fold_0_unequal_18 ^ catch_fetch_address[1], fold_0_unequal_19 ^ catch_fetch_address[5],
            fold_0_unequal_20 ^ catch_fetch_address[9], fold_0_unequal_21 ^ catch_fetch_address[13],
            fold_0_unequal_22 ^ catch_fetch_thread[1], catch_fetch_valid ^ catch_query_ready
        };
        fold_1 <= {
            fold_0[0] ^ fold_0[1] ^ fold_0[2] ^ fold_0[3], fold_0[4] ^ fold_0[5] ^ fold_0[6] ^ fold_0[7],
            fold_0[8] ^ fold_0[9] ^ fold_0[10] ^ fold_0[11], fold_0[12] ^ fold_0[13] ^ fold_0[14] ^ fold_0[15],
            fold_0[16] ^ fold_0[17] ^ fold_0[18] ^ fold_0[19], fold_0[20] ^ fold_0[21] ^ fold_0[22]
        };
        fold_2 <= {fold_1[0] ^ fold_1[1] ^ fold_1[2] ^ fold_1[3], fold_1[4] ^ fold_1[5]};
        fold_3 <= fold_2[0] ^ fold_2[1];
    end
endmodule
