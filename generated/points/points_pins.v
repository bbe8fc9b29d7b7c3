// The whole design is one file, named after its top.
/* verilator lint_off DECLFILENAME */

// A unit between registers, behind few pins.
module points_pins (
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
    reg [5:0] drive_search_k;
    reg [31:0] drive_search_radius2, drive_setting_inverse_radius2, drive_setting_tolerance;
    reg [15:0] drive_iterations_max;
    reg drive_query_valid, catch_query_ready;
    reg [23:0] drive_query_number;
    reg [31:0] drive_query_query_position_x, drive_query_query_position_y, drive_query_query_position_z;
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
    reg catch_line_valid, drive_line_ready;
    reg [21:0] catch_line_line;
    reg drive_fill_valid, catch_fill_ready;
    reg [31:0] drive_fill_position_x, drive_fill_position_y, drive_fill_position_z, drive_fill_normal_x;
    reg [31:0] drive_fill_normal_y, drive_fill_normal_z;
    reg catch_result_valid, drive_result_ready;
    reg [23:0] catch_result_number;
    reg [15:0] catch_result_iterations;
    reg catch_result_capped;
    reg [31:0] catch_result_output_position_x, catch_result_output_position_y, catch_result_output_position_z;
    reg [31:0] catch_result_output_normal_x, catch_result_output_normal_y, catch_result_output_normal_z;
    reg [31:0] catch_result_output_residual;
    reg catch_result_output_valid, catch_idle, catch_event_node, catch_event_pop, catch_event_beat;
    reg catch_event_insert, catch_event_insert_wait, catch_event_thread_wait, catch_event_point_hit;
    reg catch_event_point_miss, catch_event_query_wait, catch_event_kernel, catch_event_kernel_wait;
    reg catch_event_again, catch_event_line_hit, catch_event_line_miss;
    reg [84:0] fold_0;
    reg [21:0] fold_1;
    reg [5:0] fold_2;
    reg [1:0] fold_3;
    reg fold_4;

    wire unit_query_ready, unit_fetch_valid;
    wire [3:0] unit_fetch_thread;
    wire [21:0] unit_fetch_address;
    wire [2:0] unit_fetch_beats;
    wire unit_beat_ready, unit_line_valid;
    wire [21:0] unit_line_line;
    wire unit_fill_ready, unit_result_valid;
    wire [23:0] unit_result_number;
    wire [15:0] unit_result_iterations;
    wire unit_result_capped;
    wire [31:0] unit_result_output_position_x, unit_result_output_position_y, unit_result_output_position_z;
    wire [31:0] unit_result_output_normal_x, unit_result_output_normal_y, unit_result_output_normal_z;
    wire [31:0] unit_result_output_residual;
    wire unit_result_output_valid, unit_idle, unit_event_node, unit_event_pop, unit_event_beat;
    wire unit_event_insert, unit_event_insert_wait, unit_event_thread_wait, unit_event_point_hit;
    wire unit_event_point_miss, unit_event_query_wait, unit_event_kernel, unit_event_kernel_wait;
    wire unit_event_again, unit_event_line_hit, unit_event_line_miss;

    wire fold_0_unequal = drive_result_ready ^ catch_event_line_miss ^ catch_event_line_hit;
    wire fold_0_unequal_2 = catch_event_kernel_wait ^ catch_event_kernel ^ catch_event_query_wait;
    wire fold_0_unequal_3 = catch_event_point_hit ^ catch_event_thread_wait ^ catch_event_insert_wait;
    wire fold_0_unequal_4 = catch_event_beat ^ catch_event_pop ^ catch_event_node ^ catch_idle;
    wire fold_0_unequal_5 = catch_result_output_valid ^ catch_result_output_residual[0] ^ catch_result_output_residual[1];
    wire fold_0_unequal_6 = catch_result_output_residual[3] ^ catch_result_output_residual[4];
    wire fold_0_unequal_7 = fold_0_unequal_6 ^ catch_result_output_residual[5] ^ catch_result_output_residual[6];
    wire fold_0_unequal_8 = catch_result_output_residual[7] ^ catch_result_output_residual[8];
    wire fold_0_unequal_9 = fold_0_unequal_8 ^ catch_result_output_residual[9] ^ catch_result_output_residual[10];
    wire fold_0_unequal_10 = catch_result_output_residual[11] ^ catch_result_output_residual[12];
    wire fold_0_unequal_11 = fold_0_unequal_10 ^ catch_result_output_residual[13] ^ catch_result_output_residual[14];
    wire fold_0_unequal_12 = catch_result_output_residual[15] ^ catch_result_output_residual[16];
    wire fold_0_unequal_13 = fold_0_unequal_12 ^ catch_result_output_residual[17] ^ catch_result_output_residual[18];
    wire fold_0_unequal_14 = catch_result_output_residual[19] ^ catch_result_output_residual[20];
    wire fold_0_unequal_15 = fold_0_unequal_14 ^ catch_result_output_residual[21] ^ catch_result_output_residual[22];
    wire fold_0_unequal_16 = catch_result_output_residual[23] ^ catch_result_output_residual[24];
    wire fold_0_unequal_17 = fold_0_unequal_16 ^ catch_result_output_residual[25] ^ catch_result_output_residual[26];
    wire fold_0_unequal_18 = catch_result_output_residual[27] ^ catch_result_output_residual[28];
    wire fold_0_unequal_19 = fold_0_unequal_18 ^ catch_result_output_residual[29] ^ catch_result_output_residual[30];
    wire fold_0_unequal_20 = catch_result_output_residual[31] ^ catch_result_output_normal_z[0];
    wire fold_0_unequal_21 = fold_0_unequal_20 ^ catch_result_output_normal_z[1] ^ catch_result_output_normal_z[2];
    wire fold_0_unequal_22 = catch_result_output_normal_z[3] ^ catch_result_output_normal_z[4];
    wire fold_0_unequal_23 = fold_0_unequal_22 ^ catch_result_output_normal_z[5] ^ catch_result_output_normal_z[6];
    wire fold_0_unequal_24 = catch_result_output_normal_z[7] ^ catch_result_output_normal_z[8];
    wire fold_0_unequal_25 = fold_0_unequal_24 ^ catch_result_output_normal_z[9] ^ catch_result_output_normal_z[10];
    wire fold_0_unequal_26 = catch_result_output_normal_z[11] ^ catch_result_output_normal_z[12];
    wire fold_0_unequal_27 = fold_0_unequal_26 ^ catch_result_output_normal_z[13] ^ catch_result_output_normal_z[14];
    wire fold_0_unequal_28 = catch_result_output_normal_z[15] ^ catch_result_output_normal_z[16];
    wire fold_0_unequal_29 = fold_0_unequal_28 ^ catch_result_output_normal_z[17] ^ catch_result_output_normal_z[18];
    wire fold_0_unequal_30 = catch_result_output_normal_z[19] ^ catch_result_output_normal_z[20];
    wire fold_0_unequal_31 = fold_0_unequal_30 ^ catch_result_output_normal_z[21] ^ catch_result_output_normal_z[22];
    wire fold_0_unequal_32 = catch_result_output_normal_z[23] ^ catch_result_output_normal_z[24];
    wire fold_0_unequal_33 = fold_0_unequal_32 ^ catch_result_output_normal_z[25] ^ catch_result_output_normal_z[26];
    wire fold_0_unequal_34 = catch_result_output_normal_z[27] ^ catch_result_output_normal_z[28];
    wire fold_0_unequal_35 = fold_0_unequal_34 ^ catch_result_output_normal_z[29] ^ catch_result_output_normal_z[30];
    wire fold_0_unequal_36 = catch_result_output_normal_z[31] ^ catch_result_output_normal_y[0];
    wire fold_0_unequal_37 = fold_0_unequal_36 ^ catch_result_output_normal_y[1] ^ catch_result_output_normal_y[2];
    wire fold_0_unequal_38 = catch_result_output_normal_y[3] ^ catch_result_output_normal_y[4];
    wire fold_0_unequal_39 = fold_0_unequal_38 ^ catch_result_output_normal_y[5] ^ catch_result_output_normal_y[6];
    wire fold_0_unequal_40 = catch_result_output_normal_y[7] ^ catch_result_output_normal_y[8];
    wire fold_0_unequal_41 = fold_0_unequal_40 ^ catch_result_output_normal_y[9] ^ catch_result_output_normal_y[10];
    wire fold_0_unequal_42 = catch_result_output_normal_y[11] ^ catch_result_output_normal_y[12];
    wire fold_0_unequal_43 = fold_0_unequal_42 ^ catch_result_output_normal_y[13] ^ catch_result_output_normal_y[14];
    wire fold_0_unequal_44 = catch_result_output_normal_y[15] ^ catch_result_output_normal_y[16];
    wire fold_0_unequal_45 = fold_0_unequal_44 ^ catch_result_output_normal_y[17] ^ catch_result_output_normal_y[18];
    wire fold_0_unequal_46 = catch_result_output_normal_y[19] ^ catch_result_output_normal_y[20];
    wire fold_0_unequal_47 = fold_0_unequal_46 ^ catch_result_output_normal_y[21] ^ catch_result_output_normal_y[22];
    wire fold_0_unequal_48 = catch_result_output_normal_y[23] ^ catch_result_output_normal_y[24];
    wire fold_0_unequal_49 = fold_0_unequal_48 ^ catch_result_output_normal_y[25] ^ catch_result_output_normal_y[26];
    wire fold_0_unequal_50 = catch_result_output_normal_y[27] ^ catch_result_output_normal_y[28];
    wire fold_0_unequal_51 = fold_0_unequal_50 ^ catch_result_output_normal_y[29] ^ catch_result_output_normal_y[30];
    wire fold_0_unequal_52 = catch_result_output_normal_y[31] ^ catch_result_output_normal_x[0];
    wire fold_0_unequal_53 = fold_0_unequal_52 ^ catch_result_output_normal_x[1] ^ catch_result_output_normal_x[2];
    wire fold_0_unequal_54 = catch_result_output_normal_x[3] ^ catch_result_output_normal_x[4];
    wire fold_0_unequal_55 = fold_0_unequal_54 ^ catch_result_output_normal_x[5] ^ catch_result_output_normal_x[6];
    wire fold_0_unequal_56 = catch_result_output_normal_x[7] ^ catch_result_output_normal_x[8];
    wire fold_0_unequal_57 = fold_0_unequal_56 ^ catch_result_output_normal_x[9] ^ catch_result_output_normal_x[10];
    wire fold_0_unequal_58 = catch_result_output_normal_x[11] ^ catch_result_output_normal_x[12];
    wire fold_0_unequal_59 = fold_0_unequal_58 ^ catch_result_output_normal_x[13] ^ catch_result_output_normal_x[14];
    wire fold_0_unequal_60 = catch_result_output_normal_x[15] ^ catch_result_output_normal_x[16];
    wire fold_0_unequal_61 = fold_0_unequal_60 ^ catch_result_output_normal_x[17] ^ catch_result_output_normal_x[18];
    wire fold_0_unequal_62 = catch_result_output_normal_x[19] ^ catch_result_output_normal_x[20];
    wire fold_0_unequal_63 = fold_0_unequal_62 ^ catch_result_output_normal_x[21] ^ catch_result_output_normal_x[22];
    wire fold_0_unequal_64 = catch_result_output_normal_x[23] ^ catch_result_output_normal_x[24];
    wire fold_0_unequal_65 = fold_0_unequal_64 ^ catch_result_output_normal_x[25] ^ catch_result_output_normal_x[26];
    wire fold_0_unequal_66 = catch_result_output_normal_x[27] ^ catch_result_output_normal_x[28];
    wire fold_0_unequal_67 = fold_0_unequal_66 ^ catch_result_output_normal_x[29] ^ catch_result_output_normal_x[30];
    wire fold_0_unequal_68 = catch_result_output_normal_x[31] ^ catch_result_output_position_z[0];
    wire fold_0_unequal_69 = fold_0_unequal_68 ^ catch_result_output_position_z[1] ^ catch_result_output_position_z[2];
    wire fold_0_unequal_70 = catch_result_output_position_z[3] ^ catch_result_output_position_z[4];
    wire fold_0_unequal_71 = fold_0_unequal_70 ^ catch_result_output_position_z[5] ^ catch_result_output_position_z[6];
    wire fold_0_unequal_72 = catch_result_output_position_z[7] ^ catch_result_output_position_z[8];
    wire fold_0_unequal_73 = fold_0_unequal_72 ^ catch_result_output_position_z[9] ^ catch_result_output_position_z[10];
    wire fold_0_unequal_74 = catch_result_output_position_z[11] ^ catch_result_output_position_z[12];
    wire fold_0_unequal_75 = fold_0_unequal_74 ^ catch_result_output_position_z[13] ^ catch_result_output_position_z[14];
    wire fold_0_unequal_76 = catch_result_output_position_z[15] ^ catch_result_output_position_z[16];
    wire fold_0_unequal_77 = fold_0_unequal_76 ^ catch_result_output_position_z[17] ^ catch_result_output_position_z[18];
    wire fold_0_unequal_78 = catch_result_output_position_z[19] ^ catch_result_output_position_z[20];
    wire fold_0_unequal_79 = fold_0_unequal_78 ^ catch_result_output_position_z[21] ^ catch_result_output_position_z[22];
    wire fold_0_unequal_80 = catch_result_output_position_z[23] ^ catch_result_output_position_z[24];
    wire fold_0_unequal_81 = fold_0_unequal_80 ^ catch_result_output_position_z[25] ^ catch_result_output_position_z[26];
    wire fold_0_unequal_82 = catch_result_output_position_z[27] ^ catch_result_output_position_z[28];
    wire fold_0_unequal_83 = fold_0_unequal_82 ^ catch_result_output_position_z[29] ^ catch_result_output_position_z[30];
    wire fold_0_unequal_84 = catch_result_output_position_z[31] ^ catch_result_output_position_y[0];
    wire fold_0_unequal_85 = fold_0_unequal_84 ^ catch_result_output_position_y[1] ^ catch_result_output_position_y[2];
    wire fold_0_unequal_86 = catch_result_output_position_y[3] ^ catch_result_output_position_y[4];
    wire fold_0_unequal_87 = fold_0_unequal_86 ^ catch_result_output_position_y[5] ^ catch_result_output_position_y[6];
    wire fold_0_unequal_88 = catch_result_output_position_y[7] ^ catch_result_output_position_y[8];
    wire fold_0_unequal_89 = fold_0_unequal_88 ^ catch_result_output_position_y[9] ^ catch_result_output_position_y[10];
    wire fold_0_unequal_90 = catch_result_output_position_y[11] ^ catch_result_output_position_y[12];
    wire fold_0_unequal_91 = fold_0_unequal_90 ^ catch_result_output_position_y[13] ^ catch_result_output_position_y[14];
    wire fold_0_unequal_92 = catch_result_output_position_y[15] ^ catch_result_output_position_y[16];
    wire fold_0_unequal_93 = fold_0_unequal_92 ^ catch_result_output_position_y[17] ^ catch_result_output_position_y[18];
    wire fold_0_unequal_94 = catch_result_output_position_y[19] ^ catch_result_output_position_y[20];
    wire fold_0_unequal_95 = fold_0_unequal_94 ^ catch_result_output_position_y[21] ^ catch_result_output_position_y[22];
    wire fold_0_unequal_96 = catch_result_output_position_y[23] ^ catch_result_output_position_y[24];
    wire fold_0_unequal_97 = fold_0_unequal_96 ^ catch_result_output_position_y[25] ^ catch_result_output_position_y[26];
    wire fold_0_unequal_98 = catch_result_output_position_y[27] ^ catch_result_output_position_y[28];
    wire fold_0_unequal_99 = fold_0_unequal_98 ^ catch_result_output_position_y[29] ^ catch_result_output_position_y[30];
    wire fold_0_unequal_100 = catch_result_output_position_y[31] ^ catch_result_output_position_x[0];
    wire fold_0_unequal_101 = fold_0_unequal_100 ^ catch_result_output_position_x[1] ^ catch_result_output_position_x[2];
    wire fold_0_unequal_102 = catch_result_output_position_x[3] ^ catch_result_output_position_x[4];
    wire fold_0_unequal_103 = fold_0_unequal_102 ^ catch_result_output_position_x[5] ^ catch_result_output_position_x[6];
    wire fold_0_unequal_104 = catch_result_output_position_x[7] ^ catch_result_output_position_x[8];
    wire fold_0_unequal_105 = fold_0_unequal_104 ^ catch_result_output_position_x[9] ^ catch_result_output_position_x[10];
    wire fold_0_unequal_106 = catch_result_output_position_x[11] ^ catch_result_output_position_x[12];
    wire fold_0_unequal_107 = fold_0_unequal_106 ^ catch_result_output_position_x[13] ^ catch_result_output_position_x[14];
    wire fold_0_unequal_108 = catch_result_output_position_x[15] ^ catch_result_output_position_x[16];
    wire fold_0_unequal_109 = fold_0_unequal_108 ^ catch_result_output_position_x[17] ^ catch_result_output_position_x[18];
    wire fold_0_unequal_110 = catch_result_output_position_x[19] ^ catch_result_output_position_x[20];
    wire fold_0_unequal_111 = fold_0_unequal_110 ^ catch_result_output_position_x[21] ^ catch_result_output_position_x[22];
    wire fold_0_unequal_112 = catch_result_output_position_x[23] ^ catch_result_output_position_x[24];
    wire fold_0_unequal_113 = fold_0_unequal_112 ^ catch_result_output_position_x[25] ^ catch_result_output_position_x[26];
    wire fold_0_unequal_114 = catch_result_output_position_x[27] ^ catch_result_output_position_x[28];
    wire fold_0_unequal_115 = fold_0_unequal_114 ^ catch_result_output_position_x[29] ^ catch_result_output_position_x[30];
    wire fold_0_unequal_116 = catch_result_output_position_x[31] ^ catch_result_capped ^ catch_result_iterations[0];
    wire fold_0_unequal_117 = catch_result_iterations[2] ^ catch_result_iterations[3] ^ catch_result_iterations[4];
    wire fold_0_unequal_118 = catch_result_iterations[6] ^ catch_result_iterations[7] ^ catch_result_iterations[8];
    wire fold_0_unequal_119 = catch_result_iterations[10] ^ catch_result_iterations[11] ^ catch_result_iterations[12];
    wire fold_0_unequal_120 = catch_result_iterations[14] ^ catch_result_iterations[15] ^ catch_result_number[0];
    wire fold_0_unequal_121 = catch_result_number[2] ^ catch_result_number[3] ^ catch_result_number[4];
    wire fold_0_unequal_122 = catch_result_number[6] ^ catch_result_number[7] ^ catch_result_number[8];
    wire fold_0_unequal_123 = catch_result_number[10] ^ catch_result_number[11] ^ catch_result_number[12];
    wire fold_0_unequal_124 = catch_result_number[14] ^ catch_result_number[15] ^ catch_result_number[16];
    wire fold_0_unequal_125 = catch_result_number[18] ^ catch_result_number[19] ^ catch_result_number[20];
    wire fold_0_unequal_126 = catch_result_number[22] ^ catch_result_number[23] ^ catch_result_valid;
    wire fold_0_unequal_127 = catch_line_line[0] ^ catch_line_line[1] ^ catch_line_line[2] ^ catch_line_line[3];
    wire fold_0_unequal_128 = catch_line_line[4] ^ catch_line_line[5] ^ catch_line_line[6] ^ catch_line_line[7];
    wire fold_0_unequal_129 = catch_line_line[8] ^ catch_line_line[9] ^ catch_line_line[10] ^ catch_line_line[11];
    wire fold_0_unequal_130 = catch_line_line[12] ^ catch_line_line[13] ^ catch_line_line[14] ^ catch_line_line[15];
    wire fold_0_unequal_131 = catch_line_line[16] ^ catch_line_line[17] ^ catch_line_line[18] ^ catch_line_line[19];
    wire fold_0_unequal_132 = catch_line_line[20] ^ catch_line_line[21] ^ catch_line_valid ^ catch_beat_ready;
    wire fold_0_unequal_133 = catch_fetch_beats[0] ^ catch_fetch_beats[1] ^ catch_fetch_beats[2];
    wire fold_0_unequal_134 = catch_fetch_address[1] ^ catch_fetch_address[2] ^ catch_fetch_address[3];
    wire fold_0_unequal_135 = catch_fetch_address[5] ^ catch_fetch_address[6] ^ catch_fetch_address[7];
    wire fold_0_unequal_136 = catch_fetch_address[9] ^ catch_fetch_address[10] ^ catch_fetch_address[11];
    wire fold_0_unequal_137 = catch_fetch_address[13] ^ catch_fetch_address[14] ^ catch_fetch_address[15];
    wire fold_0_unequal_138 = catch_fetch_address[17] ^ catch_fetch_address[18] ^ catch_fetch_address[19];
    wire fold_0_unequal_139 = catch_fetch_address[21] ^ catch_fetch_thread[0] ^ catch_fetch_thread[1];

    assign serial_out = fold_4;

    points_top unit (
        .clk(clk), .rst(rst), .tree_valid(drive_tree_valid), .tree_is_leaf(drive_tree_is_leaf),
        .tree_address(drive_tree_address), .tree_split(drive_tree_split),
        .tree_dimension(drive_tree_dimension), .tree_internal_leaf(drive_tree_internal_leaf),
        .tree_begin(drive_tree_begin), .tree_beats(drive_tree_beats),
        .search_k(drive_search_k), .search_radius2(drive_search_radius2),
        .setting_inverse_radius2(drive_setting_inverse_radius2), .setting_tolerance(drive_setting_tolerance),
        .iterations_max(drive_iterations_max),
        .query_valid(drive_query_valid), .query_ready(unit_query_ready), .query_number(drive_query_number),
        .query_query_position_x(drive_query_query_position_x),
        .query_query_position_y(drive_query_query_position_y),
        .query_query_position_z(drive_query_query_position_z),
        .fetch_valid(unit_fetch_valid), .fetch_ready(drive_fetch_ready), .fetch_thread(unit_fetch_thread),
        .fetch_address(unit_fetch_address), .fetch_beats(unit_fetch_beats),
        .beat_valid(drive_beat_valid), .beat_ready(unit_beat_ready), .beat_thread(drive_beat_thread),
        .beat_address(drive_beat_address), .beat_last(drive_beat_last), .beat_x0(drive_beat_x0),
        .beat_y0(drive_beat_y0), .beat_z0(drive_beat_z0), .beat_x1(drive_beat_x1), .beat_y1(drive_beat_y1),
        .beat_z1(drive_beat_z1), .beat_x2(drive_beat_x2), .beat_y2(drive_beat_y2), .beat_z2(drive_beat_z2),
        .beat_x3(drive_beat_x3), .beat_y3(drive_beat_y3), .beat_z3(drive_beat_z3),
        .line_valid(unit_line_valid), .line_ready(drive_line_ready), .line_line(unit_line_line),
        .fill_valid(drive_fill_valid), .fill_ready(unit_fill_ready), .fill_position_x(drive_fill_position_x),
        .fill_position_y(drive_fill_position_y), .fill_position_z(drive_fill_position_z),
        .fill_normal_x(drive_fill_normal_x), .fill_normal_y(drive_fill_normal_y),
        .fill_normal_z(drive_fill_normal_z),
        .result_valid(unit_result_valid), .result_ready(drive_result_ready),
        .result_number(unit_result_number), .result_iterations(unit_result_iterations),
        .result_capped(unit_result_capped), .result_output_position_x(unit_result_output_position_x),
        .result_output_position_y(unit_result_output_position_y),
        .result_output_position_z(unit_result_output_position_z),
        .result_output_normal_x(unit_result_output_normal_x),
        .result_output_normal_y(unit_result_output_normal_y),
        .result_output_normal_z(unit_result_output_normal_z),
        .result_output_residual(unit_result_output_residual), .result_output_valid(unit_result_output_valid),
        .idle(unit_idle), .event_node(unit_event_node), .event_pop(unit_event_pop),
        .event_beat(unit_event_beat), .event_insert(unit_event_insert),
        .event_insert_wait(unit_event_insert_wait), .event_thread_wait(unit_event_thread_wait),
        .event_point_hit(unit_event_point_hit), .event_point_miss(unit_event_point_miss),
        .event_query_wait(unit_event_query_wait), .event_kernel(unit_event_kernel),
        .event_kernel_wait(unit_event_kernel_wait), .event_again(unit_event_again),
        .event_line_hit(unit_event_line_hit), .event_line_miss(unit_event_line_miss)
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
        drive_search_k <= {drive_search_k[4:0], drive_tree_beats[2]};
        drive_search_radius2 <= {drive_search_radius2[30:0], drive_search_k[5]};
        drive_setting_inverse_radius2 <= {drive_setting_inverse_radius2[30:0], drive_search_radius2[31]};
        drive_setting_tolerance <= {drive_setting_tolerance[30:0], drive_setting_inverse_radius2[31]};
        drive_iterations_max <= {drive_iterations_max[14:0], drive_setting_tolerance[31]};
        drive_query_valid <= drive_iterations_max[15];
        catch_query_ready <= unit_query_ready;
        drive_query_number <= {drive_query_number[22:0], drive_query_valid};
        drive_query_query_position_x <= {drive_query_query_position_x[30:0], drive_query_number[23]};
        drive_query_query_position_y <= {drive_query_query_position_y[30:0], drive_query_query_position_x[31]};
        drive_query_query_position_z <= {drive_query_query_position_z[30:0], drive_query_query_position_y[31]};
        catch_fetch_valid <= unit_fetch_valid;
        drive_fetch_ready <= drive_query_query_position_z[31];
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
        catch_line_valid <= unit_line_valid;
        drive_line_ready <= drive_beat_z3[31];
        catch_line_line <= unit_line_line;
        drive_fill_valid <= drive_line_ready;
        catch_fill_ready <= unit_fill_ready;
        drive_fill_position_x <= {drive_fill_position_x[30:0], drive_fill_valid};
        drive_fill_position_y <= {drive_fill_position_y[30:0], drive_fill_position_x[31]};
        drive_fill_position_z <= {drive_fill_position_z[30:0], drive_fill_position_y[31]};
        drive_fill_normal_x <= {drive_fill_normal_x[30:0], drive_fill_position_z[31]};
        drive_fill_normal_y <= {drive_fill_normal_y[30:0], drive_fill_normal_x[31]};
        drive_fill_normal_z <= {drive_fill_normal_z[30:0], drive_fill_normal_y[31]};
        catch_result_valid <= unit_result_valid;
        drive_result_ready <= drive_fill_normal_z[31];
        catch_result_number <= unit_result_number;
        catch_result_iterations <= unit_result_iterations;
        catch_result_capped <= unit_result_capped;
        catch_result_output_position_x <= unit_result_output_position_x;
        catch_result_output_position_y <= unit_result_output_position_y;
        catch_result_output_position_z <= unit_result_output_position_z;
        catch_result_output_normal_x <= unit_result_output_normal_x;
        catch_result_output_normal_y <= unit_result_output_normal_y;
        catch_result_output_normal_z <= unit_result_output_normal_z;
        catch_result_output_residual <= unit_result_output_residual;
        catch_result_output_valid <= unit_result_output_valid;
        catch_idle <= unit_idle;
        catch_event_node <= unit_event_node;
        catch_event_pop <= unit_event_pop;
        catch_event_beat <= unit_event_beat;
        catch_event_insert <= unit_event_insert;
        catch_event_insert_wait <= unit_event_insert_wait;
        catch_event_thread_wait <= unit_event_thread_wait;
        catch_event_point_hit <= unit_event_point_hit;
        catch_event_point_miss <= unit_event_point_miss;
        catch_event_query_wait <= unit_event_query_wait;
        catch_event_kernel <= unit_event_kernel;
        catch_event_kernel_wait <= unit_event_kernel_wait;
        catch_event_again <= unit_event_again;
        catch_event_line_hit <= unit_event_line_hit;
        catch_event_line_miss <= unit_event_line_miss;
        fold_0 <= {
            fold_0_unequal ^ catch_event_again, fold_0_unequal_2 ^ catch_event_point_miss,
            fold_0_unequal_3 ^ catch_event_insert, fold_0_unequal_4,
            fold_0_unequal_5 ^ catch_result_output_residual[2], fold_0_unequal_7, fold_0_unequal_9,
            fold_0_unequal_11, fold_0_unequal_13, fold_0_unequal_15, fold_0_unequal_17, fold_0_unequal_19,
            fold_0_unequal_21, fold_0_unequal_23, fold_0_unequal_25, fold_0_unequal_27, fold_0_unequal_29,
            fold_0_unequal_31, fold_0_unequal_33, fold_0_unequal_35, fold_0_unequal_37, fold_0_unequal_39,
            fold_0_unequal_41, fold_0_unequal_43, fold_0_unequal_45, fold_0_unequal_47, fold_0_unequal_49,
            fold_0_unequal_51, fold_0_unequal_53, fold_0_unequal_55, fold_0_unequal_57, fold_0_unequal_59,
            fold_0_unequal_61, fold_0_unequal_63, fold_0_unequal_65, fold_0_unequal_67, fold_0_unequal_69,
            fold_0_unequal_71, fold_0_unequal_73, fold_0_unequal_75, fold_0_unequal_77, fold_0_unequal_79,
            fold_0_unequal_81, fold_0_unequal_83, fold_0_unequal_85, fold_0_unequal_87, fold_0_unequal_89,
            fold_0_unequal_91, fold_0_unequal_93, fold_0_unequal_95, fold_0_unequal_97, fold_0_unequal_99,
            fold_0_unequal_101, fold_0_unequal_103, fold_0_unequal_105, fold_0_unequal_107, fold_0_unequal_109,
            fold_0_unequal_111, fold_0_unequal_113, fold_0_unequal_115,
            fold_0_unequal_116 ^ catch_result_iterations[1], fold_0_unequal_117 ^ catch_result_iterations[5],
            fold_0_unequal_118 ^ catch_result_iterations[9], fold_0_unequal_119 ^ catch_result_iterations[13],
            fold_0_unequal_120 ^ catch_result_number[1], fold_0_unequal_121 ^ catch_result_number[5],
            fold_0_unequal_122 ^ catch_result_number[9], fold_0_unequal_123 ^ catch_result_number[13],
            fold_0_unequal_124 ^ catch_result_number[17], fold_0_unequal_125 ^ catch_result_number[21],
            fold_0_unequal_126 ^ catch_fill_ready, fold_0_unequal_127, fold_0_unequal_128, fold_0_unequal_129,
            fold_0_unequal_130, fold_0_unequal_131, fold_0_unequal_132,
            fold_0_unequal_133 ^ catch_fetch_address[0], fold_0_unequal_134 ^ catch_fetch_address[4],
            fold_0_unequal_135 ^ catch_fetch_address[8], fold_0_unequal_136 ^ catch_fetch_address[12],
            fold_0_unequal_137 ^ catch_fetch_address[16], fold_0_unequal_138 ^ catch_fetch_address[20],
            fold_0_unequal_139 ^ catch_fetch_thread[2],
            catch_fetch_thread[3] ^ catch_fetch_valid ^ catch_query_ready
        };
        fold_1 <= {
            fold_0[0] ^ fold_0[1] ^ fold_0[2] ^ fold_0[3], fold_0[4] ^ fold_0[5] ^ fold_0[6] ^ fold_0[7],
            fold_0[8] ^ fold_0[9] ^ fold_0[10] ^ fold_0[11], fold_0[12] ^ fold_0[13] ^ fold_0[14] ^ fold_0[15],
            fold_0[16] ^ fold_0[17] ^ fold_0[18] ^ fold_0[19], fold_0[20] ^ fold_0[21] ^ fold_0[22] ^ fold_0[23],
            fold_0[24] ^ fold_0[25] ^ fold_0[26] ^ fold_0[27], fold_0[28] ^ fold_0[29] ^ fold_0[30] ^ fold_0[31],
            fold_0[32] ^ fold_0[33] ^ fold_0[34] ^ fold_0[35], fold_0[36] ^ fold_0[37] ^ fold_0[38] ^ fold_0[39],
            fold_0[40] ^ fold_0[41] ^ fold_0[42] ^ fold_0[43], fold_0[44] ^ fold_0[45] ^ fold_0[46] ^ fold_0[47],
            fold_0[48] ^ fold_0[49] ^ fold_0[50] ^ fold_0[51], fold_0[52] ^ fold_0[53] ^ fold_0[54] ^ fold_0[55],
            fold_0[56] ^ fold_0[57] ^ fold_0[58] ^ fold_0[59], fold_0[60] ^ fold_0[61] ^ fold_0[62] ^ fold_0[63],
            fold_0[64] ^ fold_0[65] ^ fold_0[66] ^ fold_0[67], fold_0[68] ^ fold_0[69] ^ fold_0[70] ^ fold_0[71],
            fold_0[72] ^ fold_0[73] ^ fold_0[74] ^ fold_0[75], fold_0[76] ^ fold_0[77] ^ fold_0[78] ^ fold_0[79],
            fold_0[80] ^ fold_0[81] ^ fold_0[82] ^ fold_0[83], fold_0[84]
        };
        fold_2 <= {
            fold_1[0] ^ fold_1[1] ^ fold_1[2] ^ fold_1[3], fold_1[4] ^ fold_1[5] ^ fold_1[6] ^ fold_1[7],
            fold_1[8] ^ fold_1[9] ^ fold_1[10] ^ fold_1[11], fold_1[12] ^ fold_1[13] ^ fold_1[14] ^ fold_1[15],
            fold_1[16] ^ fold_1[17] ^ fold_1[18] ^ fold_1[19], fold_1[20] ^ fold_1[21]
        };
        fold_3 <= {fold_2[0] ^ fold_2[1] ^ fold_2[2] ^ fold_2[3], fold_2[4] ^ fold_2[5]};
        fold_4 <= fold_3[0] ^ fold_3[1];
    end
endmodule
