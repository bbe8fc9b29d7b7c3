// The whole design is one file, named after its top.
/* verilator lint_off DECLFILENAME */

// A unit between registers, behind few pins.
module splat_pins (
    input  wire clk,
    input  wire rst,
    input  wire serial_in,
    output wire serial_out
);
    reg drive_uniform_valid;
    reg [4:0] drive_uniform_address;
    reg [31:0] drive_uniform_data;
    reg drive_splat_valid, catch_splat_ready, drive_splat_end;
    reg [31:0] drive_splat_center_x, drive_splat_center_y, drive_splat_center_z, drive_splat_tangent1_x;
    reg [31:0] drive_splat_tangent1_y, drive_splat_tangent1_z, drive_splat_tangent2_x, drive_splat_tangent2_y;
    reg [31:0] drive_splat_tangent2_z;
    reg [15:0] drive_splat_attribute_0, drive_splat_attribute_1, drive_splat_attribute_2, drive_splat_attribute_3;
    reg [15:0] drive_splat_attribute_4, drive_splat_attribute_5, drive_splat_attribute_6, drive_splat_attribute_7;
    reg [15:0] drive_splat_attribute_8, drive_splat_attribute_9, drive_splat_attribute_10, drive_splat_attribute_11;
    reg [15:0] drive_splat_attribute_12, drive_splat_cardinal_0;
    reg catch_read_valid, drive_read_ready;
    reg [11:0] catch_read_tile;
    reg drive_data_valid, catch_data_ready;
    reg [27:0] drive_data_weight;
    reg [51:0] drive_data_depth;
    reg [15:0] drive_data_peak, drive_data_attribute_0, drive_data_attribute_1, drive_data_attribute_2;
    reg [15:0] drive_data_attribute_3, drive_data_attribute_4, drive_data_attribute_5, drive_data_attribute_6;
    reg [15:0] drive_data_attribute_7, drive_data_attribute_8, drive_data_attribute_9, drive_data_attribute_10;
    reg [15:0] drive_data_attribute_11, drive_data_attribute_12, drive_data_cardinal_0;
    reg catch_write_valid, drive_write_ready;
    reg [11:0] catch_write_tile;
    reg [5:0] catch_write_pixel;
    reg [27:0] catch_write_weight;
    reg [51:0] catch_write_depth;
    reg [15:0] catch_write_peak, catch_write_attribute_0, catch_write_attribute_1, catch_write_attribute_2;
    reg [15:0] catch_write_attribute_3, catch_write_attribute_4, catch_write_attribute_5, catch_write_attribute_6;
    reg [15:0] catch_write_attribute_7, catch_write_attribute_8, catch_write_attribute_9, catch_write_attribute_10;
    reg [15:0] catch_write_attribute_11, catch_write_attribute_12, catch_write_cardinal_0;
    reg catch_fragment_valid, drive_fragment_ready, catch_fragment_end;
    reg [8:0] catch_fragment_column, catch_fragment_row;
    reg [31:0] catch_fragment_depth;
    reg [15:0] catch_fragment_attribute_0, catch_fragment_attribute_1, catch_fragment_attribute_2;
    reg [15:0] catch_fragment_attribute_3, catch_fragment_attribute_4, catch_fragment_attribute_5;
    reg [15:0] catch_fragment_attribute_6, catch_fragment_attribute_7, catch_fragment_attribute_8;
    reg [15:0] catch_fragment_attribute_9, catch_fragment_attribute_10, catch_fragment_attribute_11;
    reg [15:0] catch_fragment_attribute_12, catch_fragment_cardinal_0;
    reg catch_event_sample, catch_event_starved, catch_event_blocked, catch_event_accumulate;
    reg catch_event_hazard, catch_event_slot_wait;
    reg [159:0] fold_0;
    reg [39:0] fold_1;
    reg [9:0] fold_2;
    reg [2:0] fold_3;
    reg fold_4;

    wire unit_splat_ready, unit_read_valid;
    wire [11:0] unit_read_tile;
    wire unit_data_ready, unit_write_valid;
    wire [11:0] unit_write_tile;
    wire [5:0] unit_write_pixel;
    wire [27:0] unit_write_weight;
    wire [51:0] unit_write_depth;
    wire [15:0] unit_write_peak, unit_write_attribute_0, unit_write_attribute_1, unit_write_attribute_2;
    wire [15:0] unit_write_attribute_3, unit_write_attribute_4, unit_write_attribute_5, unit_write_attribute_6;
    wire [15:0] unit_write_attribute_7, unit_write_attribute_8, unit_write_attribute_9, unit_write_attribute_10;
    wire [15:0] unit_write_attribute_11, unit_write_attribute_12, unit_write_cardinal_0;
    wire unit_fragment_valid, unit_fragment_end;
    wire [8:0] unit_fragment_column, unit_fragment_row;
    wire [31:0] unit_fragment_depth;
    wire [15:0] unit_fragment_attribute_0, unit_fragment_attribute_1, unit_fragment_attribute_2;
    wire [15:0] unit_fragment_attribute_3, unit_fragment_attribute_4, unit_fragment_attribute_5;
    wire [15:0] unit_fragment_attribute_6, unit_fragment_attribute_7, unit_fragment_attribute_8;
    wire [15:0] unit_fragment_attribute_9, unit_fragment_attribute_10, unit_fragment_attribute_11;
    wire [15:0] unit_fragment_attribute_12, unit_fragment_cardinal_0;
    wire unit_event_sample, unit_event_starved, unit_event_blocked, unit_event_accumulate, unit_event_hazard;
    wire unit_event_slot_wait;

    wire term_1 = drive_fragment_ready ^ catch_event_slot_wait ^ catch_event_hazard;
    wire term_2 = catch_event_blocked ^ catch_event_starved ^ catch_event_sample;
    wire term_3 = catch_fragment_cardinal_0[1] ^ catch_fragment_cardinal_0[2];
    wire term_4 = term_3 ^ catch_fragment_cardinal_0[3] ^ catch_fragment_cardinal_0[4];
    wire term_5 = catch_fragment_cardinal_0[5] ^ catch_fragment_cardinal_0[6];
    wire term_6 = term_5 ^ catch_fragment_cardinal_0[7] ^ catch_fragment_cardinal_0[8];
    wire term_7 = catch_fragment_cardinal_0[9] ^ catch_fragment_cardinal_0[10];
    wire term_8 = term_7 ^ catch_fragment_cardinal_0[11] ^ catch_fragment_cardinal_0[12];
    wire term_9 = catch_fragment_cardinal_0[13] ^ catch_fragment_cardinal_0[14];
    wire term_10 = term_9 ^ catch_fragment_cardinal_0[15] ^ catch_fragment_attribute_12[0];
    wire term_11 = catch_fragment_attribute_12[1] ^ catch_fragment_attribute_12[2];
    wire term_12 = term_11 ^ catch_fragment_attribute_12[3] ^ catch_fragment_attribute_12[4];
    wire term_13 = catch_fragment_attribute_12[5] ^ catch_fragment_attribute_12[6];
    wire term_14 = term_13 ^ catch_fragment_attribute_12[7] ^ catch_fragment_attribute_12[8];
    wire term_15 = catch_fragment_attribute_12[9] ^ catch_fragment_attribute_12[10];
    wire term_16 = term_15 ^ catch_fragment_attribute_12[11] ^ catch_fragment_attribute_12[12];
    wire term_17 = catch_fragment_attribute_12[13] ^ catch_fragment_attribute_12[14];
    wire term_18 = term_17 ^ catch_fragment_attribute_12[15] ^ catch_fragment_attribute_11[0];
    wire term_19 = catch_fragment_attribute_11[1] ^ catch_fragment_attribute_11[2];
    wire term_20 = term_19 ^ catch_fragment_attribute_11[3] ^ catch_fragment_attribute_11[4];
    wire term_21 = catch_fragment_attribute_11[5] ^ catch_fragment_attribute_11[6];
    wire term_22 = term_21 ^ catch_fragment_attribute_11[7] ^ catch_fragment_attribute_11[8];
    wire term_23 = catch_fragment_attribute_11[9] ^ catch_fragment_attribute_11[10];
    wire term_24 = term_23 ^ catch_fragment_attribute_11[11] ^ catch_fragment_attribute_11[12];
    wire term_25 = catch_fragment_attribute_11[13] ^ catch_fragment_attribute_11[14];
    wire term_26 = term_25 ^ catch_fragment_attribute_11[15] ^ catch_fragment_attribute_10[0];
    wire term_27 = catch_fragment_attribute_10[1] ^ catch_fragment_attribute_10[2];
    wire term_28 = term_27 ^ catch_fragment_attribute_10[3] ^ catch_fragment_attribute_10[4];
    wire term_29 = catch_fragment_attribute_10[5] ^ catch_fragment_attribute_10[6];
    wire term_30 = term_29 ^ catch_fragment_attribute_10[7] ^ catch_fragment_attribute_10[8];
    wire term_31 = catch_fragment_attribute_10[9] ^ catch_fragment_attribute_10[10];
    wire term_32 = term_31 ^ catch_fragment_attribute_10[11] ^ catch_fragment_attribute_10[12];
    wire term_33 = catch_fragment_attribute_10[13] ^ catch_fragment_attribute_10[14];
    wire term_34 = term_33 ^ catch_fragment_attribute_10[15] ^ catch_fragment_attribute_9[0];
    wire term_35 = catch_fragment_attribute_9[1] ^ catch_fragment_attribute_9[2];
    wire term_36 = term_35 ^ catch_fragment_attribute_9[3] ^ catch_fragment_attribute_9[4];
    wire term_37 = catch_fragment_attribute_9[5] ^ catch_fragment_attribute_9[6];
    wire term_38 = term_37 ^ catch_fragment_attribute_9[7] ^ catch_fragment_attribute_9[8];
    wire term_39 = catch_fragment_attribute_9[9] ^ catch_fragment_attribute_9[10];
    wire term_40 = term_39 ^ catch_fragment_attribute_9[11] ^ catch_fragment_attribute_9[12];
    wire term_41 = catch_fragment_attribute_9[13] ^ catch_fragment_attribute_9[14];
    wire term_42 = term_41 ^ catch_fragment_attribute_9[15] ^ catch_fragment_attribute_8[0];
    wire term_43 = catch_fragment_attribute_8[1] ^ catch_fragment_attribute_8[2];
    wire term_44 = term_43 ^ catch_fragment_attribute_8[3] ^ catch_fragment_attribute_8[4];
    wire term_45 = catch_fragment_attribute_8[5] ^ catch_fragment_attribute_8[6];
    wire term_46 = term_45 ^ catch_fragment_attribute_8[7] ^ catch_fragment_attribute_8[8];
    wire term_47 = catch_fragment_attribute_8[9] ^ catch_fragment_attribute_8[10];
    wire term_48 = term_47 ^ catch_fragment_attribute_8[11] ^ catch_fragment_attribute_8[12];
    wire term_49 = catch_fragment_attribute_8[13] ^ catch_fragment_attribute_8[14];
    wire term_50 = term_49 ^ catch_fragment_attribute_8[15] ^ catch_fragment_attribute_7[0];
    wire term_51 = catch_fragment_attribute_7[1] ^ catch_fragment_attribute_7[2];
    wire term_52 = term_51 ^ catch_fragment_attribute_7[3] ^ catch_fragment_attribute_7[4];
    wire term_53 = catch_fragment_attribute_7[5] ^ catch_fragment_attribute_7[6];
    wire term_54 = term_53 ^ catch_fragment_attribute_7[7] ^ catch_fragment_attribute_7[8];
    wire term_55 = catch_fragment_attribute_7[9] ^ catch_fragment_attribute_7[10];
    wire term_56 = term_55 ^ catch_fragment_attribute_7[11] ^ catch_fragment_attribute_7[12];
    wire term_57 = catch_fragment_attribute_7[13] ^ catch_fragment_attribute_7[14];
    wire term_58 = term_57 ^ catch_fragment_attribute_7[15] ^ catch_fragment_attribute_6[0];
    wire term_59 = catch_fragment_attribute_6[1] ^ catch_fragment_attribute_6[2];
    wire term_60 = term_59 ^ catch_fragment_attribute_6[3] ^ catch_fragment_attribute_6[4];
    wire term_61 = catch_fragment_attribute_6[5] ^ catch_fragment_attribute_6[6];
    wire term_62 = term_61 ^ catch_fragment_attribute_6[7] ^ catch_fragment_attribute_6[8];
    wire term_63 = catch_fragment_attribute_6[9] ^ catch_fragment_attribute_6[10];
    wire term_64 = term_63 ^ catch_fragment_attribute_6[11] ^ catch_fragment_attribute_6[12];
    wire term_65 = catch_fragment_attribute_6[13] ^ catch_fragment_attribute_6[14];
    wire term_66 = term_65 ^ catch_fragment_attribute_6[15] ^ catch_fragment_attribute_5[0];
    wire term_67 = catch_fragment_attribute_5[1] ^ catch_fragment_attribute_5[2];
    wire term_68 = term_67 ^ catch_fragment_attribute_5[3] ^ catch_fragment_attribute_5[4];
    wire term_69 = catch_fragment_attribute_5[5] ^ catch_fragment_attribute_5[6];
    wire term_70 = term_69 ^ catch_fragment_attribute_5[7] ^ catch_fragment_attribute_5[8];
    wire term_71 = catch_fragment_attribute_5[9] ^ catch_fragment_attribute_5[10];
    wire term_72 = term_71 ^ catch_fragment_attribute_5[11] ^ catch_fragment_attribute_5[12];
    wire term_73 = catch_fragment_attribute_5[13] ^ catch_fragment_attribute_5[14];
    wire term_74 = term_73 ^ catch_fragment_attribute_5[15] ^ catch_fragment_attribute_4[0];
    wire term_75 = catch_fragment_attribute_4[1] ^ catch_fragment_attribute_4[2];
    wire term_76 = term_75 ^ catch_fragment_attribute_4[3] ^ catch_fragment_attribute_4[4];
    wire term_77 = catch_fragment_attribute_4[5] ^ catch_fragment_attribute_4[6];
    wire term_78 = term_77 ^ catch_fragment_attribute_4[7] ^ catch_fragment_attribute_4[8];
    wire term_79 = catch_fragment_attribute_4[9] ^ catch_fragment_attribute_4[10];
    wire term_80 = term_79 ^ catch_fragment_attribute_4[11] ^ catch_fragment_attribute_4[12];
    wire term_81 = catch_fragment_attribute_4[13] ^ catch_fragment_attribute_4[14];
    wire term_82 = term_81 ^ catch_fragment_attribute_4[15] ^ catch_fragment_attribute_3[0];
    wire term_83 = catch_fragment_attribute_3[1] ^ catch_fragment_attribute_3[2];
    wire term_84 = term_83 ^ catch_fragment_attribute_3[3] ^ catch_fragment_attribute_3[4];
    wire term_85 = catch_fragment_attribute_3[5] ^ catch_fragment_attribute_3[6];
    wire term_86 = term_85 ^ catch_fragment_attribute_3[7] ^ catch_fragment_attribute_3[8];
    wire term_87 = catch_fragment_attribute_3[9] ^ catch_fragment_attribute_3[10];
    wire term_88 = term_87 ^ catch_fragment_attribute_3[11] ^ catch_fragment_attribute_3[12];
    wire term_89 = catch_fragment_attribute_3[13] ^ catch_fragment_attribute_3[14];
    wire term_90 = term_89 ^ catch_fragment_attribute_3[15] ^ catch_fragment_attribute_2[0];
    wire term_91 = catch_fragment_attribute_2[1] ^ catch_fragment_attribute_2[2];
    wire term_92 = term_91 ^ catch_fragment_attribute_2[3] ^ catch_fragment_attribute_2[4];
    wire term_93 = catch_fragment_attribute_2[5] ^ catch_fragment_attribute_2[6];
    wire term_94 = term_93 ^ catch_fragment_attribute_2[7] ^ catch_fragment_attribute_2[8];
    wire term_95 = catch_fragment_attribute_2[9] ^ catch_fragment_attribute_2[10];
    wire term_96 = term_95 ^ catch_fragment_attribute_2[11] ^ catch_fragment_attribute_2[12];
    wire term_97 = catch_fragment_attribute_2[13] ^ catch_fragment_attribute_2[14];
    wire term_98 = term_97 ^ catch_fragment_attribute_2[15] ^ catch_fragment_attribute_1[0];
    wire term_99 = catch_fragment_attribute_1[1] ^ catch_fragment_attribute_1[2];
    wire term_100 = term_99 ^ catch_fragment_attribute_1[3] ^ catch_fragment_attribute_1[4];
    wire term_101 = catch_fragment_attribute_1[5] ^ catch_fragment_attribute_1[6];
    wire term_102 = term_101 ^ catch_fragment_attribute_1[7] ^ catch_fragment_attribute_1[8];
    wire term_103 = catch_fragment_attribute_1[9] ^ catch_fragment_attribute_1[10];
    wire term_104 = term_103 ^ catch_fragment_attribute_1[11] ^ catch_fragment_attribute_1[12];
    wire term_105 = catch_fragment_attribute_1[13] ^ catch_fragment_attribute_1[14];
    wire term_106 = term_105 ^ catch_fragment_attribute_1[15] ^ catch_fragment_attribute_0[0];
    wire term_107 = catch_fragment_attribute_0[1] ^ catch_fragment_attribute_0[2];
    wire term_108 = term_107 ^ catch_fragment_attribute_0[3] ^ catch_fragment_attribute_0[4];
    wire term_109 = catch_fragment_attribute_0[5] ^ catch_fragment_attribute_0[6];
    wire term_110 = term_109 ^ catch_fragment_attribute_0[7] ^ catch_fragment_attribute_0[8];
    wire term_111 = catch_fragment_attribute_0[9] ^ catch_fragment_attribute_0[10];
    wire term_112 = term_111 ^ catch_fragment_attribute_0[11] ^ catch_fragment_attribute_0[12];
    wire term_113 = catch_fragment_attribute_0[13] ^ catch_fragment_attribute_0[14];
    wire term_114 = term_113 ^ catch_fragment_attribute_0[15] ^ catch_fragment_depth[0];
    wire term_115 = catch_fragment_depth[1] ^ catch_fragment_depth[2] ^ catch_fragment_depth[3];
    wire term_116 = catch_fragment_depth[5] ^ catch_fragment_depth[6] ^ catch_fragment_depth[7];
    wire term_117 = catch_fragment_depth[9] ^ catch_fragment_depth[10] ^ catch_fragment_depth[11];
    wire term_118 = catch_fragment_depth[13] ^ catch_fragment_depth[14] ^ catch_fragment_depth[15];
    wire term_119 = catch_fragment_depth[17] ^ catch_fragment_depth[18] ^ catch_fragment_depth[19];
    wire term_120 = catch_fragment_depth[21] ^ catch_fragment_depth[22] ^ catch_fragment_depth[23];
    wire term_121 = catch_fragment_depth[25] ^ catch_fragment_depth[26] ^ catch_fragment_depth[27];
    wire term_122 = catch_fragment_depth[29] ^ catch_fragment_depth[30] ^ catch_fragment_depth[31];
    wire term_123 = catch_fragment_row[1] ^ catch_fragment_row[2] ^ catch_fragment_row[3];
    wire term_124 = catch_fragment_row[5] ^ catch_fragment_row[6] ^ catch_fragment_row[7];
    wire term_125 = catch_fragment_column[0] ^ catch_fragment_column[1] ^ catch_fragment_column[2];
    wire term_126 = catch_fragment_column[4] ^ catch_fragment_column[5] ^ catch_fragment_column[6];
    wire term_127 = catch_fragment_column[8] ^ catch_fragment_end ^ catch_fragment_valid;
    wire term_128 = catch_write_cardinal_0[1] ^ catch_write_cardinal_0[2] ^ catch_write_cardinal_0[3];
    wire term_129 = catch_write_cardinal_0[5] ^ catch_write_cardinal_0[6] ^ catch_write_cardinal_0[7];
    wire term_130 = catch_write_cardinal_0[9] ^ catch_write_cardinal_0[10] ^ catch_write_cardinal_0[11];
    wire term_131 = catch_write_cardinal_0[13] ^ catch_write_cardinal_0[14] ^ catch_write_cardinal_0[15];
    wire term_132 = catch_write_attribute_12[1] ^ catch_write_attribute_12[2];
    wire term_133 = term_132 ^ catch_write_attribute_12[3] ^ catch_write_attribute_12[4];
    wire term_134 = catch_write_attribute_12[5] ^ catch_write_attribute_12[6];
    wire term_135 = term_134 ^ catch_write_attribute_12[7] ^ catch_write_attribute_12[8];
    wire term_136 = catch_write_attribute_12[9] ^ catch_write_attribute_12[10];
    wire term_137 = term_136 ^ catch_write_attribute_12[11] ^ catch_write_attribute_12[12];
    wire term_138 = catch_write_attribute_12[13] ^ catch_write_attribute_12[14];
    wire term_139 = term_138 ^ catch_write_attribute_12[15] ^ catch_write_attribute_11[0];
    wire term_140 = catch_write_attribute_11[1] ^ catch_write_attribute_11[2];
    wire term_141 = term_140 ^ catch_write_attribute_11[3] ^ catch_write_attribute_11[4];
    wire term_142 = catch_write_attribute_11[5] ^ catch_write_attribute_11[6];
    wire term_143 = term_142 ^ catch_write_attribute_11[7] ^ catch_write_attribute_11[8];
    wire term_144 = catch_write_attribute_11[9] ^ catch_write_attribute_11[10];
    wire term_145 = term_144 ^ catch_write_attribute_11[11] ^ catch_write_attribute_11[12];
    wire term_146 = catch_write_attribute_11[13] ^ catch_write_attribute_11[14];
    wire term_147 = term_146 ^ catch_write_attribute_11[15] ^ catch_write_attribute_10[0];
    wire term_148 = catch_write_attribute_10[1] ^ catch_write_attribute_10[2];
    wire term_149 = term_148 ^ catch_write_attribute_10[3] ^ catch_write_attribute_10[4];
    wire term_150 = catch_write_attribute_10[5] ^ catch_write_attribute_10[6];
    wire term_151 = term_150 ^ catch_write_attribute_10[7] ^ catch_write_attribute_10[8];
    wire term_152 = catch_write_attribute_10[9] ^ catch_write_attribute_10[10];
    wire term_153 = term_152 ^ catch_write_attribute_10[11] ^ catch_write_attribute_10[12];
    wire term_154 = catch_write_attribute_10[13] ^ catch_write_attribute_10[14];
    wire term_155 = term_154 ^ catch_write_attribute_10[15] ^ catch_write_attribute_9[0];
    wire term_156 = catch_write_attribute_9[1] ^ catch_write_attribute_9[2] ^ catch_write_attribute_9[3];
    wire term_157 = catch_write_attribute_9[5] ^ catch_write_attribute_9[6] ^ catch_write_attribute_9[7];
    wire term_158 = catch_write_attribute_9[9] ^ catch_write_attribute_9[10] ^ catch_write_attribute_9[11];
    wire term_159 = catch_write_attribute_9[13] ^ catch_write_attribute_9[14];
    wire term_160 = term_159 ^ catch_write_attribute_9[15] ^ catch_write_attribute_8[0];
    wire term_161 = catch_write_attribute_8[1] ^ catch_write_attribute_8[2] ^ catch_write_attribute_8[3];
    wire term_162 = catch_write_attribute_8[5] ^ catch_write_attribute_8[6] ^ catch_write_attribute_8[7];
    wire term_163 = catch_write_attribute_8[9] ^ catch_write_attribute_8[10] ^ catch_write_attribute_8[11];
    wire term_164 = catch_write_attribute_8[13] ^ catch_write_attribute_8[14];
    wire term_165 = term_164 ^ catch_write_attribute_8[15] ^ catch_write_attribute_7[0];
    wire term_166 = catch_write_attribute_7[1] ^ catch_write_attribute_7[2] ^ catch_write_attribute_7[3];
    wire term_167 = catch_write_attribute_7[5] ^ catch_write_attribute_7[6] ^ catch_write_attribute_7[7];
    wire term_168 = catch_write_attribute_7[9] ^ catch_write_attribute_7[10] ^ catch_write_attribute_7[11];
    wire term_169 = catch_write_attribute_7[13] ^ catch_write_attribute_7[14];
    wire term_170 = term_169 ^ catch_write_attribute_7[15] ^ catch_write_attribute_6[0];
    wire term_171 = catch_write_attribute_6[1] ^ catch_write_attribute_6[2] ^ catch_write_attribute_6[3];
    wire term_172 = catch_write_attribute_6[5] ^ catch_write_attribute_6[6] ^ catch_write_attribute_6[7];
    wire term_173 = catch_write_attribute_6[9] ^ catch_write_attribute_6[10] ^ catch_write_attribute_6[11];
    wire term_174 = catch_write_attribute_6[13] ^ catch_write_attribute_6[14];
    wire term_175 = term_174 ^ catch_write_attribute_6[15] ^ catch_write_attribute_5[0];
    wire term_176 = catch_write_attribute_5[1] ^ catch_write_attribute_5[2] ^ catch_write_attribute_5[3];
    wire term_177 = catch_write_attribute_5[5] ^ catch_write_attribute_5[6] ^ catch_write_attribute_5[7];
    wire term_178 = catch_write_attribute_5[9] ^ catch_write_attribute_5[10] ^ catch_write_attribute_5[11];
    wire term_179 = catch_write_attribute_5[13] ^ catch_write_attribute_5[14];
    wire term_180 = term_179 ^ catch_write_attribute_5[15] ^ catch_write_attribute_4[0];
    wire term_181 = catch_write_attribute_4[1] ^ catch_write_attribute_4[2] ^ catch_write_attribute_4[3];
    wire term_182 = catch_write_attribute_4[5] ^ catch_write_attribute_4[6] ^ catch_write_attribute_4[7];
    wire term_183 = catch_write_attribute_4[9] ^ catch_write_attribute_4[10] ^ catch_write_attribute_4[11];
    wire term_184 = catch_write_attribute_4[13] ^ catch_write_attribute_4[14];
    wire term_185 = term_184 ^ catch_write_attribute_4[15] ^ catch_write_attribute_3[0];
    wire term_186 = catch_write_attribute_3[1] ^ catch_write_attribute_3[2] ^ catch_write_attribute_3[3];
    wire term_187 = catch_write_attribute_3[5] ^ catch_write_attribute_3[6] ^ catch_write_attribute_3[7];
    wire term_188 = catch_write_attribute_3[9] ^ catch_write_attribute_3[10] ^ catch_write_attribute_3[11];
    wire term_189 = catch_write_attribute_3[13] ^ catch_write_attribute_3[14];
    wire term_190 = term_189 ^ catch_write_attribute_3[15] ^ catch_write_attribute_2[0];
    wire term_191 = catch_write_attribute_2[1] ^ catch_write_attribute_2[2] ^ catch_write_attribute_2[3];
    wire term_192 = catch_write_attribute_2[5] ^ catch_write_attribute_2[6] ^ catch_write_attribute_2[7];
    wire term_193 = catch_write_attribute_2[9] ^ catch_write_attribute_2[10] ^ catch_write_attribute_2[11];
    wire term_194 = catch_write_attribute_2[13] ^ catch_write_attribute_2[14];
    wire term_195 = term_194 ^ catch_write_attribute_2[15] ^ catch_write_attribute_1[0];
    wire term_196 = catch_write_attribute_1[1] ^ catch_write_attribute_1[2] ^ catch_write_attribute_1[3];
    wire term_197 = catch_write_attribute_1[5] ^ catch_write_attribute_1[6] ^ catch_write_attribute_1[7];
    wire term_198 = catch_write_attribute_1[9] ^ catch_write_attribute_1[10] ^ catch_write_attribute_1[11];
    wire term_199 = catch_write_attribute_1[13] ^ catch_write_attribute_1[14];
    wire term_200 = term_199 ^ catch_write_attribute_1[15] ^ catch_write_attribute_0[0];
    wire term_201 = catch_write_attribute_0[1] ^ catch_write_attribute_0[2] ^ catch_write_attribute_0[3];
    wire term_202 = catch_write_attribute_0[5] ^ catch_write_attribute_0[6] ^ catch_write_attribute_0[7];
    wire term_203 = catch_write_attribute_0[9] ^ catch_write_attribute_0[10] ^ catch_write_attribute_0[11];
    wire term_204 = catch_write_attribute_0[13] ^ catch_write_attribute_0[14];
    wire term_205 = term_204 ^ catch_write_attribute_0[15] ^ catch_write_peak[0];
    wire term_206 = catch_write_peak[1] ^ catch_write_peak[2] ^ catch_write_peak[3];
    wire term_207 = catch_write_peak[5] ^ catch_write_peak[6] ^ catch_write_peak[7];
    wire term_208 = catch_write_peak[9] ^ catch_write_peak[10] ^ catch_write_peak[11];
    wire term_209 = catch_write_peak[13] ^ catch_write_peak[14] ^ catch_write_peak[15];
    wire term_210 = catch_write_depth[1] ^ catch_write_depth[2] ^ catch_write_depth[3];
    wire term_211 = catch_write_depth[5] ^ catch_write_depth[6] ^ catch_write_depth[7];
    wire term_212 = catch_write_depth[9] ^ catch_write_depth[10] ^ catch_write_depth[11];
    wire term_213 = catch_write_depth[13] ^ catch_write_depth[14] ^ catch_write_depth[15];
    wire term_214 = catch_write_depth[17] ^ catch_write_depth[18] ^ catch_write_depth[19];
    wire term_215 = catch_write_depth[21] ^ catch_write_depth[22] ^ catch_write_depth[23];
    wire term_216 = catch_write_depth[25] ^ catch_write_depth[26] ^ catch_write_depth[27];
    wire term_217 = catch_write_depth[29] ^ catch_write_depth[30] ^ catch_write_depth[31];
    wire term_218 = catch_write_depth[33] ^ catch_write_depth[34] ^ catch_write_depth[35];
    wire term_219 = catch_write_depth[37] ^ catch_write_depth[38] ^ catch_write_depth[39];
    wire term_220 = catch_write_depth[41] ^ catch_write_depth[42] ^ catch_write_depth[43];
    wire term_221 = catch_write_depth[45] ^ catch_write_depth[46] ^ catch_write_depth[47];
    wire term_222 = catch_write_depth[49] ^ catch_write_depth[50] ^ catch_write_depth[51];
    wire term_223 = catch_write_weight[1] ^ catch_write_weight[2] ^ catch_write_weight[3];
    wire term_224 = catch_write_weight[5] ^ catch_write_weight[6] ^ catch_write_weight[7];
    wire term_225 = catch_write_weight[9] ^ catch_write_weight[10] ^ catch_write_weight[11];
    wire term_226 = catch_write_weight[13] ^ catch_write_weight[14] ^ catch_write_weight[15];
    wire term_227 = catch_write_weight[17] ^ catch_write_weight[18] ^ catch_write_weight[19];
    wire term_228 = catch_write_weight[21] ^ catch_write_weight[22] ^ catch_write_weight[23];
    wire term_229 = catch_write_weight[25] ^ catch_write_weight[26] ^ catch_write_weight[27];
    wire term_230 = catch_write_pixel[1] ^ catch_write_pixel[2] ^ catch_write_pixel[3];
    wire term_231 = catch_write_pixel[5] ^ catch_write_tile[0] ^ catch_write_tile[1];
    wire term_232 = catch_write_tile[3] ^ catch_write_tile[4] ^ catch_write_tile[5];
    wire term_233 = catch_write_tile[7] ^ catch_write_tile[8] ^ catch_write_tile[9];
    wire term_234 = catch_write_tile[11] ^ catch_write_valid ^ catch_data_ready;
    wire term_235 = catch_read_tile[1] ^ catch_read_tile[2] ^ catch_read_tile[3];
    wire term_236 = catch_read_tile[5] ^ catch_read_tile[6] ^ catch_read_tile[7];
    wire term_237 = catch_read_tile[9] ^ catch_read_tile[10] ^ catch_read_tile[11];

    assign serial_out = fold_4;

    splat_top unit (
        .clk(clk), .rst(rst),
        .uniform_valid(drive_uniform_valid), .uniform_address(drive_uniform_address),
        .uniform_data(drive_uniform_data),
        .splat_valid(drive_splat_valid), .splat_ready(unit_splat_ready), .splat_end(drive_splat_end),
        .splat_center_x(drive_splat_center_x), .splat_center_y(drive_splat_center_y),
        .splat_center_z(drive_splat_center_z), .splat_tangent1_x(drive_splat_tangent1_x),
        .splat_tangent1_y(drive_splat_tangent1_y), .splat_tangent1_z(drive_splat_tangent1_z),
        .splat_tangent2_x(drive_splat_tangent2_x), .splat_tangent2_y(drive_splat_tangent2_y),
        .splat_tangent2_z(drive_splat_tangent2_z), .splat_attribute_0(drive_splat_attribute_0),
        .splat_attribute_1(drive_splat_attribute_1), .splat_attribute_2(drive_splat_attribute_2),
        .splat_attribute_3(drive_splat_attribute_3), .splat_attribute_4(drive_splat_attribute_4),
        .splat_attribute_5(drive_splat_attribute_5), .splat_attribute_6(drive_splat_attribute_6),
        .splat_attribute_7(drive_splat_attribute_7), .splat_attribute_8(drive_splat_attribute_8),
        .splat_attribute_9(drive_splat_attribute_9), .splat_attribute_10(drive_splat_attribute_10),
        .splat_attribute_11(drive_splat_attribute_11), .splat_attribute_12(drive_splat_attribute_12),
        .splat_cardinal_0(drive_splat_cardinal_0),
        .read_valid(unit_read_valid), .read_ready(drive_read_ready), .read_tile(unit_read_tile),
        .data_valid(drive_data_valid), .data_ready(unit_data_ready), .data_weight(drive_data_weight),
        .data_depth(drive_data_depth), .data_peak(drive_data_peak), .data_attribute_0(drive_data_attribute_0),
        .data_attribute_1(drive_data_attribute_1), .data_attribute_2(drive_data_attribute_2),
        .data_attribute_3(drive_data_attribute_3), .data_attribute_4(drive_data_attribute_4),
        .data_attribute_5(drive_data_attribute_5), .data_attribute_6(drive_data_attribute_6),
        .data_attribute_7(drive_data_attribute_7), .data_attribute_8(drive_data_attribute_8),
        .data_attribute_9(drive_data_attribute_9), .data_attribute_10(drive_data_attribute_10),
        .data_attribute_11(drive_data_attribute_11), .data_attribute_12(drive_data_attribute_12),
        .data_cardinal_0(drive_data_cardinal_0),
        .write_valid(unit_write_valid), .write_ready(drive_write_ready), .write_tile(unit_write_tile),
        .write_pixel(unit_write_pixel), .write_weight(unit_write_weight), .write_depth(unit_write_depth),
        .write_peak(unit_write_peak), .write_attribute_0(unit_write_attribute_0),
        .write_attribute_1(unit_write_attribute_1), .write_attribute_2(unit_write_attribute_2),
        .write_attribute_3(unit_write_attribute_3), .write_attribute_4(unit_write_attribute_4),
        .write_attribute_5(unit_write_attribute_5), .write_attribute_6(unit_write_attribute_6),
        .write_attribute_7(unit_write_attribute_7), .write_attribute_8(unit_write_attribute_8),
        .write_attribute_9(unit_write_attribute_9), .write_attribute_10(unit_write_attribute_10),
        .write_attribute_11(unit_write_attribute_11), .write_attribute_12(unit_write_attribute_12),
        .write_cardinal_0(unit_write_cardinal_0),
        .fragment_valid(unit_fragment_valid), .fragment_ready(drive_fragment_ready),
        .fragment_end(unit_fragment_end), .fragment_column(unit_fragment_column),
        .fragment_row(unit_fragment_row), .fragment_depth(unit_fragment_depth),
        .fragment_attribute_0(unit_fragment_attribute_0), .fragment_attribute_1(unit_fragment_attribute_1),
        .fragment_attribute_2(unit_fragment_attribute_2), .fragment_attribute_3(unit_fragment_attribute_3),
        .fragment_attribute_4(unit_fragment_attribute_4), .fragment_attribute_5(unit_fragment_attribute_5),
        .fragment_attribute_6(unit_fragment_attribute_6), .fragment_attribute_7(unit_fragment_attribute_7),
        .fragment_attribute_8(unit_fragment_attribute_8), .fragment_attribute_9(unit_fragment_attribute_9),
        .fragment_attribute_10(unit_fragment_attribute_10),
        .fragment_attribute_11(unit_fragment_attribute_11),
        .fragment_attribute_12(unit_fragment_attribute_12), .fragment_cardinal_0(unit_fragment_cardinal_0),
        .event_sample(unit_event_sample), .event_starved(unit_event_starved),
        .event_blocked(unit_event_blocked), .event_accumulate(unit_event_accumulate),
        .event_hazard(unit_event_hazard), .event_slot_wait(unit_event_slot_wait)
    );

    always @(posedge clk) begin
        drive_uniform_valid <= serial_in;
        drive_uniform_address <= {drive_uniform_address[3:0], drive_uniform_valid};
        drive_uniform_data <= {drive_uniform_data[30:0], drive_uniform_address[4]};
        drive_splat_valid <= drive_uniform_data[31];
        catch_splat_ready <= unit_splat_ready;
        drive_splat_end <= drive_splat_valid;
        drive_splat_center_x <= {drive_splat_center_x[30:0], drive_splat_end};
        drive_splat_center_y <= {drive_splat_center_y[30:0], drive_splat_center_x[31]};
        drive_splat_center_z <= {drive_splat_center_z[30:0], drive_splat_center_y[31]};
        drive_splat_tangent1_x <= {drive_splat_tangent1_x[30:0], drive_splat_center_z[31]};
        drive_splat_tangent1_y <= {drive_splat_tangent1_y[30:0], drive_splat_tangent1_x[31]};
        drive_splat_tangent1_z <= {drive_splat_tangent1_z[30:0], drive_splat_tangent1_y[31]};
        drive_splat_tangent2_x <= {drive_splat_tangent2_x[30:0], drive_splat_tangent1_z[31]};
        drive_splat_tangent2_y <= {drive_splat_tangent2_y[30:0], drive_splat_tangent2_x[31]};
        drive_splat_tangent2_z <= {drive_splat_tangent2_z[30:0], drive_splat_tangent2_y[31]};
        drive_splat_attribute_0 <= {drive_splat_attribute_0[14:0], drive_splat_tangent2_z[31]};
        drive_splat_attribute_1 <= {drive_splat_attribute_1[14:0], drive_splat_attribute_0[15]};
        drive_splat_attribute_2 <= {drive_splat_attribute_2[14:0], drive_splat_attribute_1[15]};
        drive_splat_attribute_3 <= {drive_splat_attribute_3[14:0], drive_splat_attribute_2[15]};
        drive_splat_attribute_4 <= {drive_splat_attribute_4[14:0], drive_splat_attribute_3[15]};
        drive_splat_attribute_5 <= {drive_splat_attribute_5[14:0], drive_splat_attribute_4[15]};
        drive_splat_attribute_6 <= {drive_splat_attribute_6[14:0], drive_splat_attribute_5[15]};
        drive_splat_attribute_7 <= {drive_splat_attribute_7[14:0], drive_splat_attribute_6[15]};
        drive_splat_attribute_8 <= {drive_splat_attribute_8[14:0], drive_splat_attribute_7[15]};
        drive_splat_attribute_9 <= {drive_splat_attribute_9[14:0], drive_splat_attribute_8[15]};
        drive_splat_attribute_10 <= {drive_splat_attribute_10[14:0], drive_splat_attribute_9[15]};
        drive_splat_attribute_11 <= {drive_splat_attribute_11[14:0], drive_splat_attribute_10[15]};
        drive_splat_attribute_12 <= {drive_splat_attribute_12[14:0], drive_splat_attribute_11[15]};
        drive_splat_cardinal_0 <= {drive_splat_cardinal_0[14:0], drive_splat_attribute_12[15]};
        catch_read_valid <= unit_read_valid;
        drive_read_ready <= drive_splat_cardinal_0[15];
        catch_read_tile <= unit_read_tile;
        drive_data_valid <= drive_read_ready;
        catch_data_ready <= unit_data_ready;
        drive_data_weight <= {drive_data_weight[26:0], drive_data_valid};
        drive_data_depth <= {drive_data_depth[50:0], drive_data_weight[27]};
        drive_data_peak <= {drive_data_peak[14:0], drive_data_depth[51]};
        drive_data_attribute_0 <= {drive_data_attribute_0[14:0], drive_data_peak[15]};
        drive_data_attribute_1 <= {drive_data_attribute_1[14:0], drive_data_attribute_0[15]};
        drive_data_attribute_2 <= {drive_data_attribute_2[14:0], drive_data_attribute_1[15]};
        drive_data_attribute_3 <= {drive_data_attribute_3[14:0], drive_data_attribute_2[15]};
        drive_data_attribute_4 <= {drive_data_attribute_4[14:0], drive_data_attribute_3[15]};
        drive_data_attribute_5 <= {drive_data_attribute_5[14:0], drive_data_attribute_4[15]};
        drive_data_attribute_6 <= {drive_data_attribute_6[14:0], drive_data_attribute_5[15]};
        drive_data_attribute_7 <= {drive_data_attribute_7[14:0], drive_data_attribute_6[15]};
        drive_data_attribute_8 <= {drive_data_attribute_8[14:0], drive_data_attribute_7[15]};
        drive_data_attribute_9 <= {drive_data_attribute_9[14:0], drive_data_attribute_8[15]};
        drive_data_attribute_10 <= {drive_data_attribute_10[14:0], drive_data_attribute_9[15]};
        drive_data_attribute_11 <= {drive_data_attribute_11[14:0], drive_data_attribute_10[15]};
        drive_data_attribute_12 <= {drive_data_attribute_12[14:0], drive_data_attribute_11[15]};
        drive_data_cardinal_0 <= {drive_data_cardinal_0[14:0], drive_data_attribute_12[15]};
        catch_write_valid <= unit_write_valid;
        drive_write_ready <= drive_data_cardinal_0[15];
        catch_write_tile <= unit_write_tile;
        catch_write_pixel <= unit_write_pixel;
        catch_write_weight <= unit_write_weight;
        catch_write_depth <= unit_write_depth;
        catch_write_peak <= unit_write_peak;
        catch_write_attribute_0 <= unit_write_attribute_0;
        catch_write_attribute_1 <= unit_write_attribute_1;
        catch_write_attribute_2 <= unit_write_attribute_2;
        catch_write_attribute_3 <= unit_write_attribute_3;
        catch_write_attribute_4 <= unit_write_attribute_4;
        catch_write_attribute_5 <= unit_write_attribute_5;
        catch_write_attribute_6 <= unit_write_attribute_6;
        catch_write_attribute_7 <= unit_write_attribute_7;
        catch_write_attribute_8 <= unit_write_attribute_8;
        catch_write_attribute_9 <= unit_write_attribute_9;
        catch_write_attribute_10 <= unit_write_attribute_10;
        catch_write_attribute_11 <= unit_write_attribute_11;
        catch_write_attribute_12 <= unit_write_attribute_12;
        catch_write_cardinal_0 <= unit_write_cardinal_0;
        catch_fragment_valid <= unit_fragment_valid;
        drive_fragment_ready <= drive_write_ready;
        catch_fragment_end <= unit_fragment_end;
        catch_fragment_column <= unit_fragment_column;
        catch_fragment_row <= unit_fragment_row;
        catch_fragment_depth <= unit_fragment_depth;
        catch_fragment_attribute_0 <= unit_fragment_attribute_0;
        catch_fragment_attribute_1 <= unit_fragment_attribute_1;
        catch_fragment_attribute_2 <= unit_fragment_attribute_2;
        catch_fragment_attribute_3 <= unit_fragment_attribute_3;
        catch_fragment_attribute_4 <= unit_fragment_attribute_4;
        catch_fragment_attribute_5 <= unit_fragment_attribute_5;
        catch_fragment_attribute_6 <= unit_fragment_attribute_6;
        catch_fragment_attribute_7 <= unit_fragment_attribute_7;
        catch_fragment_attribute_8 <= unit_fragment_attribute_8;
        catch_fragment_attribute_9 <= unit_fragment_attribute_9;
        catch_fragment_attribute_10 <= unit_fragment_attribute_10;
        catch_fragment_attribute_11 <= unit_fragment_attribute_11;
        catch_fragment_attribute_12 <= unit_fragment_attribute_12;
        catch_fragment_cardinal_0 <= unit_fragment_cardinal_0;
        catch_event_sample <= unit_event_sample;
        catch_event_starved <= unit_event_starved;
        catch_event_blocked <= unit_event_blocked;
        catch_event_accumulate <= unit_event_accumulate;
        catch_event_hazard <= unit_event_hazard;
        catch_event_slot_wait <= unit_event_slot_wait;
        fold_0 <= {
            term_1 ^ catch_event_accumulate, term_2 ^ catch_fragment_cardinal_0[0], term_4, term_6, term_8,
            term_10, term_12, term_14, term_16, term_18, term_20, term_22, term_24, term_26, term_28, term_30,
            term_32, term_34, term_36, term_38, term_40, term_42, term_44, term_46, term_48, term_50, term_52,
            term_54, term_56, term_58, term_60, term_62, term_64, term_66, term_68, term_70, term_72, term_74,
            term_76, term_78, term_80, term_82, term_84, term_86, term_88, term_90, term_92, term_94, term_96,
            term_98, term_100, term_102, term_104, term_106, term_108, term_110, term_112, term_114,
            term_115 ^ catch_fragment_depth[4], term_116 ^ catch_fragment_depth[8],
            term_117 ^ catch_fragment_depth[12], term_118 ^ catch_fragment_depth[16],
            term_119 ^ catch_fragment_depth[20], term_120 ^ catch_fragment_depth[24],
            term_121 ^ catch_fragment_depth[28], term_122 ^ catch_fragment_row[0],
            term_123 ^ catch_fragment_row[4], term_124 ^ catch_fragment_row[8],
            term_125 ^ catch_fragment_column[3], term_126 ^ catch_fragment_column[7],
            term_127 ^ catch_write_cardinal_0[0], term_128 ^ catch_write_cardinal_0[4],
            term_129 ^ catch_write_cardinal_0[8], term_130 ^ catch_write_cardinal_0[12],
            term_131 ^ catch_write_attribute_12[0], term_133, term_135, term_137, term_139, term_141, term_143,
            term_145, term_147, term_149, term_151, term_153, term_155, term_156 ^ catch_write_attribute_9[4],
            term_157 ^ catch_write_attribute_9[8], term_158 ^ catch_write_attribute_9[12], term_160,
            term_161 ^ catch_write_attribute_8[4], term_162 ^ catch_write_attribute_8[8],
            term_163 ^ catch_write_attribute_8[12], term_165, term_166 ^ catch_write_attribute_7[4],
            term_167 ^ catch_write_attribute_7[8], term_168 ^ catch_write_attribute_7[12], term_170,
            term_171 ^ catch_write_attribute_6[4], term_172 ^ catch_write_attribute_6[8],
            term_173 ^ catch_write_attribute_6[12], term_175, term_176 ^ catch_write_attribute_5[4],
            term_177 ^ catch_write_attribute_5[8], term_178 ^ catch_write_attribute_5[12], term_180,
            term_181 ^ catch_write_attribute_4[4], term_182 ^ catch_write_attribute_4[8],
            term_183 ^ catch_write_attribute_4[12], term_185, term_186 ^ catch_write_attribute_3[4],
            term_187 ^ catch_write_attribute_3[8], term_188 ^ catch_write_attribute_3[12], term_190,
            term_191 ^ catch_write_attribute_2[4], term_192 ^ catch_write_attribute_2[8],
            term_193 ^ catch_write_attribute_2[12], term_195, term_196 ^ catch_write_attribute_1[4],
            term_197 ^ catch_write_attribute_1[8], term_198 ^ catch_write_attribute_1[12], term_200,
            term_201 ^ catch_write_attribute_0[4], term_202 ^ catch_write_attribute_0[8],
            term_203 ^ catch_write_attribute_0[12], term_205, term_206 ^ catch_write_peak[4],
            term_207 ^ catch_write_peak[8], term_208 ^ catch_write_peak[12], term_209 ^ catch_write_depth[0],
            term_210 ^ catch_write_depth[4], term_211 ^ catch_write_depth[8], term_212 ^ catch_write_depth[12],
            term_213 ^ catch_write_depth[16], term_214 ^ catch_write_depth[20], term_215 ^ catch_write_depth[24],
            term_216 ^ catch_write_depth[28], term_217 ^ catch_write_depth[32], term_218 ^ catch_write_depth[36],
            term_219 ^ catch_write_depth[40], term_220 ^ catch_write_depth[44], term_221 ^ catch_write_depth[48],
            term_222 ^ catch_write_weight[0], term_223 ^ catch_write_weight[4], term_224 ^ catch_write_weight[8],
            term_225 ^ catch_write_weight[12], term_226 ^ catch_write_weight[16],
            term_227 ^ catch_write_weight[20], term_228 ^ catch_write_weight[24], term_229 ^ catch_write_pixel[0],
            term_230 ^ catch_write_pixel[4], term_231 ^ catch_write_tile[2], term_232 ^ catch_write_tile[6],
            term_233 ^ catch_write_tile[10], term_234 ^ catch_read_tile[0], term_235 ^ catch_read_tile[4],
            term_236 ^ catch_read_tile[8], term_237 ^ catch_read_valid, catch_splat_ready
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
            fold_0[80] ^ fold_0[81] ^ fold_0[82] ^ fold_0[83], fold_0[84] ^ fold_0[85] ^ fold_0[86] ^ fold_0[87],
            fold_0[88] ^ fold_0[89] ^ fold_0[90] ^ fold_0[91], fold_0[92] ^ fold_0[93] ^ fold_0[94] ^ fold_0[95],
            fold_0[96] ^ fold_0[97] ^ fold_0[98] ^ fold_0[99],
            fold_0[100] ^ fold_0[101] ^ fold_0[102] ^ fold_0[103],
            fold_0[104] ^ fold_0[105] ^ fold_0[106] ^ fold_0[107],
            fold_0[108] ^ fold_0[109] ^ fold_0[110] ^ fold_0[111],
            fold_0[112] ^ fold_0[113] ^ fold_0[114] ^ fold_0[115],
            fold_0[116] ^ fold_0[117] ^ fold_0[118] ^ fold_0[119],
            fold_0[120] ^ fold_0[121] ^ fold_0[122] ^ fold_0[123],
            fold_0[124] ^ fold_0[125] ^ fold_0[126] ^ fold_0[127],
            fold_0[128] ^ fold_0[129] ^ fold_0[130] ^ fold_0[131],
            fold_0[132] ^ fold_0[133] ^ fold_0[134] ^ fold_0[135],
            fold_0[136] ^ fold_0[137] ^ fold_0[138] ^ fold_0[139],
            fold_0[140] ^ fold_0[141] ^ fold_0[142] ^ fold_0[143],
            fold_0[144] ^ fold_0[145] ^ fold_0[146] ^ fold_0[147],
            fold_0[148] ^ fold_0[149] ^ fold_0[150] ^ fold_0[151],
            fold_0[152] ^ fold_0[153] ^ fold_0[154] ^ fold_0[155],
            fold_0[156] ^ fold_0[157] ^ fold_0[158] ^ fold_0[159]
        };
        fold_2 <= {
            fold_1[0] ^ fold_1[1] ^ fold_1[2] ^ fold_1[3], fold_1[4] ^ fold_1[5] ^ fold_1[6] ^ fold_1[7],
            fold_1[8] ^ fold_1[9] ^ fold_1[10] ^ fold_1[11], fold_1[12] ^ fold_1[13] ^ fold_1[14] ^ fold_1[15],
            fold_1[16] ^ fold_1[17] ^ fold_1[18] ^ fold_1[19], fold_1[20] ^ fold_1[21] ^ fold_1[22] ^ fold_1[23],
            fold_1[24] ^ fold_1[25] ^ fold_1[26] ^ fold_1[27], fold_1[28] ^ fold_1[29] ^ fold_1[30] ^ fold_1[31],
            fold_1[32] ^ fold_1[33] ^ fold_1[34] ^ fold_1[35], fold_1[36] ^ fold_1[37] ^ fold_1[38] ^ fold_1[39]
        };
        fold_3 <= {
            fold_2[0] ^ fold_2[1] ^ fold_2[2] ^ fold_2[3], fold_2[4] ^ fold_2[5] ^ fold_2[6] ^ fold_2[7],
            fold_2[8] ^ fold_2[9]
        };
        fold_4 <= fold_3[0] ^ fold_3[1] ^ fold_3[2];
    end
endmodule
