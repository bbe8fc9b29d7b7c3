// The whole design is one file, named after its top.
/* verilator lint_off DECLFILENAME */

// A unit between registers, behind few pins.
module splat_pins (
    input  wire clk, input wire rst,
    input  wire serial_in, output wire serial_out
);
    reg drive_uniform_valid;
    reg [4:0] drive_uniform_address;
    reg [23:0] drive_uniform_data;
    reg drive_splat_valid, catch_splat_ready, drive_splat_end;
    reg [23:0] drive_splat_center_x, drive_splat_center_y, drive_splat_center_z, drive_splat_tangent1_x;
    reg [23:0] drive_splat_tangent1_y, drive_splat_tangent1_z, drive_splat_tangent2_x, drive_splat_tangent2_y;
    reg [23:0] drive_splat_tangent2_z;
    reg [15:0] drive_splat_attribute_0, drive_splat_attribute_1, drive_splat_attribute_2, drive_splat_attribute_3;
    reg [15:0] drive_splat_attribute_4, drive_splat_attribute_5, drive_splat_cardinal_0;
    reg catch_frame_set_up, catch_read_valid, drive_read_ready, catch_read_surface;
    reg [11:0] catch_read_tile;
    reg [5:0] catch_read_pixel;
    reg [3:0] catch_read_count;
    reg drive_data_valid, catch_data_ready;
    reg [27:0] drive_data_weight;
    reg [51:0] drive_data_depth;
    reg [15:0] drive_data_peak, drive_data_attribute_0, drive_data_attribute_1, drive_data_attribute_2;
    reg [15:0] drive_data_attribute_3, drive_data_attribute_4, drive_data_attribute_5, drive_data_cardinal_0;
    reg catch_write_valid, drive_write_ready, catch_write_surface;
    reg [11:0] catch_write_tile;
    reg [5:0] catch_write_pixel;
    reg [27:0] catch_write_weight;
    reg [51:0] catch_write_depth;
    reg [15:0] catch_write_peak, catch_write_attribute_0, catch_write_attribute_1, catch_write_attribute_2;
    reg [15:0] catch_write_attribute_3, catch_write_attribute_4, catch_write_attribute_5, catch_write_cardinal_0;
    reg catch_fragment_valid, drive_fragment_ready, catch_fragment_end;
    reg [8:0] catch_fragment_column, catch_fragment_row;
    reg [23:0] catch_fragment_depth;
    reg [15:0] catch_fragment_attribute_0, catch_fragment_attribute_1, catch_fragment_attribute_2;
    reg [15:0] catch_fragment_attribute_3, catch_fragment_attribute_4, catch_fragment_attribute_5;
    reg [15:0] catch_fragment_cardinal_0;
    reg catch_event_sample, catch_event_starved, catch_event_blocked, catch_event_accumulate;
    reg catch_event_hazard, catch_event_slot_wait;
    reg [104:0] fold_0;
    reg [26:0] fold_1;
    reg [6:0] fold_2;
    reg [1:0] fold_3;
    reg fold_4;

    wire unit_splat_ready, unit_frame_set_up, unit_read_valid, unit_read_surface;
    wire [11:0] unit_read_tile;
    wire [5:0] unit_read_pixel;
    wire [3:0] unit_read_count;
    wire unit_data_ready, unit_write_valid, unit_write_surface;
    wire [11:0] unit_write_tile;
    wire [5:0] unit_write_pixel;
    wire [27:0] unit_write_weight;
    wire [51:0] unit_write_depth;
    wire [15:0] unit_write_peak, unit_write_attribute_0, unit_write_attribute_1, unit_write_attribute_2;
    wire [15:0] unit_write_attribute_3, unit_write_attribute_4, unit_write_attribute_5, unit_write_cardinal_0;
    wire unit_fragment_valid, unit_fragment_end;
    wire [8:0] unit_fragment_column, unit_fragment_row;
    wire [23:0] unit_fragment_depth;
    wire [15:0] unit_fragment_attribute_0, unit_fragment_attribute_1, unit_fragment_attribute_2;
    wire [15:0] unit_fragment_attribute_3, unit_fragment_attribute_4, unit_fragment_attribute_5;
    wire [15:0] unit_fragment_cardinal_0;
    wire unit_event_sample, unit_event_starved, unit_event_blocked, unit_event_accumulate, unit_event_hazard;
    wire unit_event_slot_wait;

    wire fold_0_unequal = drive_fragment_ready ^ catch_event_slot_wait ^ catch_event_hazard;
    wire fold_0_unequal_2 = catch_event_blocked ^ catch_event_starved ^ catch_event_sample ^ catch_fragment_cardinal_0[0];
    wire fold_0_unequal_3 = catch_fragment_cardinal_0[1] ^ catch_fragment_cardinal_0[2] ^ catch_fragment_cardinal_0[3];
    wire fold_0_unequal_4 = catch_fragment_cardinal_0[5] ^ catch_fragment_cardinal_0[6] ^ catch_fragment_cardinal_0[7];
    wire fold_0_unequal_5 = catch_fragment_cardinal_0[9] ^ catch_fragment_cardinal_0[10] ^ catch_fragment_cardinal_0[11];
    wire fold_0_unequal_6 = catch_fragment_cardinal_0[13] ^ catch_fragment_cardinal_0[14] ^ catch_fragment_cardinal_0[15];
    wire fold_0_unequal_7 = catch_fragment_attribute_5[1] ^ catch_fragment_attribute_5[2] ^ catch_fragment_attribute_5[3];
    wire fold_0_unequal_8 = catch_fragment_attribute_5[5] ^ catch_fragment_attribute_5[6] ^ catch_fragment_attribute_5[7];
    wire fold_0_unequal_9 = catch_fragment_attribute_5[9] ^ catch_fragment_attribute_5[10] ^ catch_fragment_attribute_5[11];
    wire fold_0_unequal_10 = catch_fragment_attribute_5[13] ^ catch_fragment_attribute_5[14] ^ catch_fragment_attribute_5[15];
    wire fold_0_unequal_11 = catch_fragment_attribute_4[1] ^ catch_fragment_attribute_4[2] ^ catch_fragment_attribute_4[3];
    wire fold_0_unequal_12 = catch_fragment_attribute_4[5] ^ catch_fragment_attribute_4[6] ^ catch_fragment_attribute_4[7];
    wire fold_0_unequal_13 = catch_fragment_attribute_4[9] ^ catch_fragment_attribute_4[10] ^ catch_fragment_attribute_4[11];
    wire fold_0_unequal_14 = catch_fragment_attribute_4[13] ^ catch_fragment_attribute_4[14] ^ catch_fragment_attribute_4[15];
    wire fold_0_unequal_15 = catch_fragment_attribute_3[1] ^ catch_fragment_attribute_3[2] ^ catch_fragment_attribute_3[3];
    wire fold_0_unequal_16 = catch_fragment_attribute_3[5] ^ catch_fragment_attribute_3[6] ^ catch_fragment_attribute_3[7];
    wire fold_0_unequal_17 = catch_fragment_attribute_3[9] ^ catch_fragment_attribute_3[10] ^ catch_fragment_attribute_3[11];
    wire fold_0_unequal_18 = catch_fragment_attribute_3[13] ^ catch_fragment_attribute_3[14] ^ catch_fragment_attribute_3[15];
    wire fold_0_unequal_19 = catch_fragment_attribute_2[1] ^ catch_fragment_attribute_2[2] ^ catch_fragment_attribute_2[3];
    wire fold_0_unequal_20 = catch_fragment_attribute_2[5] ^ catch_fragment_attribute_2[6] ^ catch_fragment_attribute_2[7];
    wire fold_0_unequal_21 = catch_fragment_attribute_2[9] ^ catch_fragment_attribute_2[10] ^ catch_fragment_attribute_2[11];
    wire fold_0_unequal_22 = catch_fragment_attribute_2[13] ^ catch_fragment_attribute_2[14] ^ catch_fragment_attribute_2[15];
    wire fold_0_unequal_23 = catch_fragment_attribute_1[1] ^ catch_fragment_attribute_1[2] ^ catch_fragment_attribute_1[3];
    wire fold_0_unequal_24 = catch_fragment_attribute_1[5] ^ catch_fragment_attribute_1[6] ^ catch_fragment_attribute_1[7];
    wire fold_0_unequal_25 = catch_fragment_attribute_1[9] ^ catch_fragment_attribute_1[10] ^ catch_fragment_attribute_1[11];
    wire fold_0_unequal_26 = catch_fragment_attribute_1[13] ^ catch_fragment_attribute_1[14] ^ catch_fragment_attribute_1[15];
    wire fold_0_unequal_27 = catch_fragment_attribute_0[1] ^ catch_fragment_attribute_0[2] ^ catch_fragment_attribute_0[3];
    wire fold_0_unequal_28 = catch_fragment_attribute_0[5] ^ catch_fragment_attribute_0[6] ^ catch_fragment_attribute_0[7];
    wire fold_0_unequal_29 = catch_fragment_attribute_0[9] ^ catch_fragment_attribute_0[10] ^ catch_fragment_attribute_0[11];
    wire fold_0_unequal_30 = catch_fragment_attribute_0[13] ^ catch_fragment_attribute_0[14] ^ catch_fragment_attribute_0[15];
    wire fold_0_unequal_31 = catch_fragment_depth[1] ^ catch_fragment_depth[2] ^ catch_fragment_depth[3];
    wire fold_0_unequal_32 = catch_fragment_depth[5] ^ catch_fragment_depth[6] ^ catch_fragment_depth[7];
    wire fold_0_unequal_33 = catch_fragment_depth[9] ^ catch_fragment_depth[10] ^ catch_fragment_depth[11];
    wire fold_0_unequal_34 = catch_fragment_depth[13] ^ catch_fragment_depth[14] ^ catch_fragment_depth[15];
    wire fold_0_unequal_35 = catch_fragment_depth[17] ^ catch_fragment_depth[18] ^ catch_fragment_depth[19];
    wire fold_0_unequal_36 = catch_fragment_depth[21] ^ catch_fragment_depth[22] ^ catch_fragment_depth[23];
    wire fold_0_unequal_37 = catch_fragment_row[1] ^ catch_fragment_row[2] ^ catch_fragment_row[3];
    wire fold_0_unequal_38 = catch_fragment_row[5] ^ catch_fragment_row[6] ^ catch_fragment_row[7];
    wire fold_0_unequal_39 = catch_fragment_column[0] ^ catch_fragment_column[1] ^ catch_fragment_column[2];
    wire fold_0_unequal_40 = catch_fragment_column[4] ^ catch_fragment_column[5] ^ catch_fragment_column[6];
    wire fold_0_unequal_41 = catch_fragment_column[8] ^ catch_fragment_end ^ catch_fragment_valid;
    wire fold_0_unequal_42 = catch_write_cardinal_0[1] ^ catch_write_cardinal_0[2] ^ catch_write_cardinal_0[3];
    wire fold_0_unequal_43 = catch_write_cardinal_0[5] ^ catch_write_cardinal_0[6] ^ catch_write_cardinal_0[7];
    wire fold_0_unequal_44 = catch_write_cardinal_0[9] ^ catch_write_cardinal_0[10] ^ catch_write_cardinal_0[11];
    wire fold_0_unequal_45 = catch_write_cardinal_0[13] ^ catch_write_cardinal_0[14] ^ catch_write_cardinal_0[15];
    wire fold_0_unequal_46 = catch_write_attribute_5[1] ^ catch_write_attribute_5[2] ^ catch_write_attribute_5[3];
    wire fold_0_unequal_47 = catch_write_attribute_5[5] ^ catch_write_attribute_5[6] ^ catch_write_attribute_5[7];
    wire fold_0_unequal_48 = catch_write_attribute_5[9] ^ catch_write_attribute_5[10] ^ catch_write_attribute_5[11];
    wire fold_0_unequal_49 = catch_write_attribute_5[13] ^ catch_write_attribute_5[14] ^ catch_write_attribute_5[15];
    wire fold_0_unequal_50 = catch_write_attribute_4[1] ^ catch_write_attribute_4[2] ^ catch_write_attribute_4[3];
    wire fold_0_unequal_51 = catch_write_attribute_4[5] ^ catch_write_attribute_4[6] ^ catch_write_attribute_4[7];
    wire fold_0_unequal_52 = catch_write_attribute_4[9] ^ catch_write_attribute_4[10] ^ catch_write_attribute_4[11];
    wire fold_0_unequal_53 = catch_write_attribute_4[13] ^ catch_write_attribute_4[14] ^ catch_write_attribute_4[15];
    wire fold_0_unequal_54 = catch_write_attribute_3[1] ^ catch_write_attribute_3[2] ^ catch_write_attribute_3[3];
    wire fold_0_unequal_55 = catch_write_attribute_3[5] ^ catch_write_attribute_3[6] ^ catch_write_attribute_3[7];
    wire fold_0_unequal_56 = catch_write_attribute_3[9] ^ catch_write_attribute_3[10] ^ catch_write_attribute_3[11];
    wire fold_0_unequal_57 = catch_write_attribute_3[13] ^ catch_write_attribute_3[14] ^ catch_write_attribute_3[15];
    wire fold_0_unequal_58 = catch_write_attribute_2[1] ^ catch_write_attribute_2[2] ^ catch_write_attribute_2[3];
    wire fold_0_unequal_59 = catch_write_attribute_2[5] ^ catch_write_attribute_2[6] ^ catch_write_attribute_2[7];
    wire fold_0_unequal_60 = catch_write_attribute_2[9] ^ catch_write_attribute_2[10] ^ catch_write_attribute_2[11];
    wire fold_0_unequal_61 = catch_write_attribute_2[13] ^ catch_write_attribute_2[14] ^ catch_write_attribute_2[15];
    wire fold_0_unequal_62 = catch_write_attribute_1[1] ^ catch_write_attribute_1[2] ^ catch_write_attribute_1[3];
    wire fold_0_unequal_63 = catch_write_attribute_1[5] ^ catch_write_attribute_1[6] ^ catch_write_attribute_1[7];
    wire fold_0_unequal_64 = catch_write_attribute_1[9] ^ catch_write_attribute_1[10] ^ catch_write_attribute_1[11];
    wire fold_0_unequal_65 = catch_write_attribute_1[13] ^ catch_write_attribute_1[14] ^ catch_write_attribute_1[15];
    wire fold_0_unequal_66 = catch_write_attribute_0[1] ^ catch_write_attribute_0[2] ^ catch_write_attribute_0[3];
    wire fold_0_unequal_67 = catch_write_attribute_0[5] ^ catch_write_attribute_0[6] ^ catch_write_attribute_0[7];
    wire fold_0_unequal_68 = catch_write_attribute_0[9] ^ catch_write_attribute_0[10] ^ catch_write_attribute_0[11];
    wire fold_0_unequal_69 = catch_write_attribute_0[13] ^ catch_write_attribute_0[14] ^ catch_write_attribute_0[15];
    wire fold_0_unequal_70 = catch_write_peak[1] ^ catch_write_peak[2] ^ catch_write_peak[3] ^ catch_write_peak[4];
    wire fold_0_unequal_71 = catch_write_peak[5] ^ catch_write_peak[6] ^ catch_write_peak[7] ^ catch_write_peak[8];
    wire fold_0_unequal_72 = catch_write_peak[9] ^ catch_write_peak[10] ^ catch_write_peak[11];
    wire fold_0_unequal_73 = catch_write_peak[13] ^ catch_write_peak[14] ^ catch_write_peak[15];
    wire fold_0_unequal_74 = catch_write_depth[1] ^ catch_write_depth[2] ^ catch_write_depth[3];
    wire fold_0_unequal_75 = catch_write_depth[5] ^ catch_write_depth[6] ^ catch_write_depth[7];
    wire fold_0_unequal_76 = catch_write_depth[9] ^ catch_write_depth[10] ^ catch_write_depth[11];
    wire fold_0_unequal_77 = catch_write_depth[13] ^ catch_write_depth[14] ^ catch_write_depth[15];
    wire fold_0_unequal_78 = catch_write_depth[17] ^ catch_write_depth[18] ^ catch_write_depth[19];
    wire fold_0_unequal_79 = catch_write_depth[21] ^ catch_write_depth[22] ^ catch_write_depth[23];
    wire fold_0_unequal_80 = catch_write_depth[25] ^ catch_write_depth[26] ^ catch_write_depth[27];
    wire fold_0_unequal_81 = catch_write_depth[29] ^ catch_write_depth[30] ^ catch_write_depth[31];
    wire fold_0_unequal_82 = catch_write_depth[33] ^ catch_write_depth[34] ^ catch_write_depth[35];
    wire fold_0_unequal_83 = catch_write_depth[37] ^ catch_write_depth[38] ^ catch_write_depth[39];
    wire fold_0_unequal_84 = catch_write_depth[41] ^ catch_write_depth[42] ^ catch_write_depth[43];
    wire fold_0_unequal_85 = catch_write_depth[45] ^ catch_write_depth[46] ^ catch_write_depth[47];
    wire fold_0_unequal_86 = catch_write_depth[49] ^ catch_write_depth[50] ^ catch_write_depth[51];
    wire fold_0_unequal_87 = catch_write_weight[1] ^ catch_write_weight[2] ^ catch_write_weight[3];
    wire fold_0_unequal_88 = catch_write_weight[5] ^ catch_write_weight[6] ^ catch_write_weight[7];
    wire fold_0_unequal_89 = catch_write_weight[9] ^ catch_write_weight[10] ^ catch_write_weight[11];
    wire fold_0_unequal_90 = catch_write_weight[13] ^ catch_write_weight[14] ^ catch_write_weight[15];
    wire fold_0_unequal_91 = catch_write_weight[17] ^ catch_write_weight[18] ^ catch_write_weight[19];
    wire fold_0_unequal_92 = catch_write_weight[21] ^ catch_write_weight[22] ^ catch_write_weight[23];
    wire fold_0_unequal_93 = catch_write_weight[25] ^ catch_write_weight[26] ^ catch_write_weight[27];
    wire fold_0_unequal_94 = catch_write_pixel[1] ^ catch_write_pixel[2] ^ catch_write_pixel[3];
    wire fold_0_unequal_95 = catch_write_pixel[5] ^ catch_write_tile[0] ^ catch_write_tile[1] ^ catch_write_tile[2];
    wire fold_0_unequal_96 = catch_write_tile[3] ^ catch_write_tile[4] ^ catch_write_tile[5] ^ catch_write_tile[6];
    wire fold_0_unequal_97 = catch_write_tile[7] ^ catch_write_tile[8] ^ catch_write_tile[9] ^ catch_write_tile[10];
    wire fold_0_unequal_98 = catch_write_tile[11] ^ catch_write_surface ^ catch_write_valid ^ catch_data_ready;
    wire fold_0_unequal_99 = catch_read_count[0] ^ catch_read_count[1] ^ catch_read_count[2] ^ catch_read_count[3];
    wire fold_0_unequal_100 = catch_read_pixel[0] ^ catch_read_pixel[1] ^ catch_read_pixel[2] ^ catch_read_pixel[3];
    wire fold_0_unequal_101 = catch_read_pixel[4] ^ catch_read_pixel[5] ^ catch_read_tile[0] ^ catch_read_tile[1];
    wire fold_0_unequal_102 = catch_read_tile[2] ^ catch_read_tile[3] ^ catch_read_tile[4] ^ catch_read_tile[5];
    wire fold_0_unequal_103 = catch_read_tile[6] ^ catch_read_tile[7] ^ catch_read_tile[8] ^ catch_read_tile[9];
    wire fold_0_unequal_104 = catch_read_tile[10] ^ catch_read_tile[11] ^ catch_read_surface ^ catch_read_valid;

    assign serial_out = fold_4;

    splat_top unit (
        .clk(clk), .rst(rst), .uniform_valid(drive_uniform_valid), .uniform_address(drive_uniform_address),
        .uniform_data(drive_uniform_data),
        .splat_valid(drive_splat_valid), .splat_ready(unit_splat_ready), .splat_end(drive_splat_end),
        .splat_center_x(drive_splat_center_x), .splat_center_y(drive_splat_center_y),
        .splat_center_z(drive_splat_center_z), .splat_tangent1_x(drive_splat_tangent1_x),
        .splat_tangent1_y(drive_splat_tangent1_y), .splat_tangent1_z(drive_splat_tangent1_z),
        .splat_tangent2_x(drive_splat_tangent2_x), .splat_tangent2_y(drive_splat_tangent2_y),
        .splat_tangent2_z(drive_splat_tangent2_z), .splat_attribute_0(drive_splat_attribute_0),
        .splat_attribute_1(drive_splat_attribute_1), .splat_attribute_2(drive_splat_attribute_2),
        .splat_attribute_3(drive_splat_attribute_3), .splat_attribute_4(drive_splat_attribute_4),
        .splat_attribute_5(drive_splat_attribute_5), .splat_cardinal_0(drive_splat_cardinal_0),
        .frame_set_up(unit_frame_set_up),
        .read_valid(unit_read_valid), .read_ready(drive_read_ready), .read_surface(unit_read_surface),
        .read_tile(unit_read_tile), .read_pixel(unit_read_pixel), .read_count(unit_read_count),
        .data_valid(drive_data_valid), .data_ready(unit_data_ready), .data_weight(drive_data_weight),
        .data_depth(drive_data_depth), .data_peak(drive_data_peak), .data_attribute_0(drive_data_attribute_0),
        .data_attribute_1(drive_data_attribute_1), .data_attribute_2(drive_data_attribute_2),
        .data_attribute_3(drive_data_attribute_3), .data_attribute_4(drive_data_attribute_4),
        .data_attribute_5(drive_data_attribute_5), .data_cardinal_0(drive_data_cardinal_0),
        .write_valid(unit_write_valid), .write_ready(drive_write_ready), .write_surface(unit_write_surface),
        .write_tile(unit_write_tile), .write_pixel(unit_write_pixel), .write_weight(unit_write_weight),
        .write_depth(unit_write_depth), .write_peak(unit_write_peak),
        .write_attribute_0(unit_write_attribute_0), .write_attribute_1(unit_write_attribute_1),
        .write_attribute_2(unit_write_attribute_2), .write_attribute_3(unit_write_attribute_3),
        .write_attribute_4(unit_write_attribute_4), .write_attribute_5(unit_write_attribute_5),
        .write_cardinal_0(unit_write_cardinal_0),
        .fragment_valid(unit_fragment_valid), .fragment_ready(drive_fragment_ready),
        .fragment_end(unit_fragment_end), .fragment_column(unit_fragment_column),
        .fragment_row(unit_fragment_row), .fragment_depth(unit_fragment_depth),
        .fragment_attribute_0(unit_fragment_attribute_0), .fragment_attribute_1(unit_fragment_attribute_1),
        .fragment_attribute_2(unit_fragment_attribute_2), .fragment_attribute_3(unit_fragment_attribute_3),
        .fragment_attribute_4(unit_fragment_attribute_4), .fragment_attribute_5(unit_fragment_attribute_5),
        .fragment_cardinal_0(unit_fragment_cardinal_0),
        .event_sample(unit_event_sample), .event_starved(unit_event_starved),
        .event_blocked(unit_event_blocked), .event_accumulate(unit_event_accumulate),
        .event_hazard(unit_event_hazard), .event_slot_wait(unit_event_slot_wait)
    );

    always @(posedge clk) begin
        drive_uniform_valid <= serial_in;
        drive_uniform_address <= {drive_uniform_address[3:0], drive_uniform_valid};
        drive_uniform_data <= {drive_uniform_data[22:0], drive_uniform_address[4]};
        drive_splat_valid <= drive_uniform_data[23];
        catch_splat_ready <= unit_splat_ready;
        drive_splat_end <= drive_splat_valid;
        drive_splat_center_x <= {drive_splat_center_x[22:0], drive_splat_end};
        drive_splat_center_y <= {drive_splat_center_y[22:0], drive_splat_center_x[23]};
        drive_splat_center_z <= {drive_splat_center_z[22:0], drive_splat_center_y[23]};
        drive_splat_tangent1_x <= {drive_splat_tangent1_x[22:0], drive_splat_center_z[23]};
        drive_splat_tangent1_y <= {drive_splat_tangent1_y[22:0], drive_splat_tangent1_x[23]};
        drive_splat_tangent1_z <= {drive_splat_tangent1_z[22:0], drive_splat_tangent1_y[23]};
        drive_splat_tangent2_x <= {drive_splat_tangent2_x[22:0], drive_splat_tangent1_z[23]};
        drive_splat_tangent2_y <= {drive_splat_tangent2_y[22:0], drive_splat_tangent2_x[23]};
        drive_splat_tangent2_z <= {drive_splat_tangent2_z[22:0], drive_splat_tangent2_y[23]};
        drive_splat_attribute_0 <= {drive_splat_attribute_0[14:0], drive_splat_tangent2_z[23]};
        drive_splat_attribute_1 <= {drive_splat_attribute_1[14:0], drive_splat_attribute_0[15]};
        drive_splat_attribute_2 <= {drive_splat_attribute_2[14:0], drive_splat_attribute_1[15]};
        drive_splat_attribute_3 <= {drive_splat_attribute_3[14:0], drive_splat_attribute_2[15]};
        drive_splat_attribute_4 <= {drive_splat_attribute_4[14:0], drive_splat_attribute_3[15]};
        drive_splat_attribute_5 <= {drive_splat_attribute_5[14:0], drive_splat_attribute_4[15]};
        drive_splat_cardinal_0 <= {drive_splat_cardinal_0[14:0], drive_splat_attribute_5[15]};
        catch_frame_set_up <= unit_frame_set_up;
        catch_read_valid <= unit_read_valid;
        drive_read_ready <= drive_splat_cardinal_0[15];
        catch_read_surface <= unit_read_surface;
        catch_read_tile <= unit_read_tile;
        catch_read_pixel <= unit_read_pixel;
        catch_read_count <= unit_read_count;
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
        drive_data_cardinal_0 <= {drive_data_cardinal_0[14:0], drive_data_attribute_5[15]};
        catch_write_valid <= unit_write_valid;
        drive_write_ready <= drive_data_cardinal_0[15];
        catch_write_surface <= unit_write_surface;
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
        catch_fragment_cardinal_0 <= unit_fragment_cardinal_0;
        catch_event_sample <= unit_event_sample;
        catch_event_starved <= unit_event_starved;
        catch_event_blocked <= unit_event_blocked;
        catch_event_accumulate <= unit_event_accumulate;
        catch_event_hazard <= unit_event_hazard;
        catch_event_slot_wait <= unit_event_slot_wait;
        fold_0 <= {
            fold_0_unequal ^ catch_event_accumulate, fold_0_unequal_2,
            fold_0_unequal_3 ^ catch_fragment_cardinal_0[4], fold_0_unequal_4 ^ catch_fragment_cardinal_0[8],
            fold_0_unequal_5 ^ catch_fragment_cardinal_0[12], fold_0_unequal_6 ^ catch_fragment_attribute_5[0],
            fold_0_unequal_7 ^ catch_fragment_attribute_5[4], fold_0_unequal_8 ^ catch_fragment_attribute_5[8],
            fold_0_unequal_9 ^ catch_fragment_attribute_5[12], fold_0_unequal_10 ^ catch_fragment_attribute_4[0],
            fold_0_unequal_11 ^ catch_fragment_attribute_4[4], fold_0_unequal_12 ^ catch_fragment_attribute_4[8],
            fold_0_unequal_13 ^ catch_fragment_attribute_4[12], fold_0_unequal_14 ^ catch_fragment_attribute_3[0],
            fold_0_unequal_15 ^ catch_fragment_attribute_3[4], fold_0_unequal_16 ^ catch_fragment_attribute_3[8],
            fold_0_unequal_17 ^ catch_fragment_attribute_3[12], fold_0_unequal_18 ^ catch_fragment_attribute_2[0],
            fold_0_unequal_19 ^ catch_fragment_attribute_2[4], fold_0_unequal_20 ^ catch_fragment_attribute_2[8],
            fold_0_unequal_21 ^ catch_fragment_attribute_2[12], fold_0_unequal_22 ^ catch_fragment_attribute_1[0],
            fold_0_unequal_23 ^ catch_fragment_attribute_1[4], fold_0_unequal_24 ^ catch_fragment_attribute_1[8],
            fold_0_unequal_25 ^ catch_fragment_attribute_1[12], fold_0_unequal_26 ^ catch_fragment_attribute_0[0],
            fold_0_unequal_27 ^ catch_fragment_attribute_0[4], fold_0_unequal_28 ^ catch_fragment_attribute_0[8],
            fold_0_unequal_29 ^ catch_fragment_attribute_0[12], fold_0_unequal_30 ^ catch_fragment_depth[0],
            fold_0_unequal_31 ^ catch_fragment_depth[4], fold_0_unequal_32 ^ catch_fragment_depth[8],
            fold_0_unequal_33 ^ catch_fragment_depth[12], fold_0_unequal_34 ^ catch_fragment_depth[16],
            fold_0_unequal_35 ^ catch_fragment_depth[20], fold_0_unequal_36 ^ catch_fragment_row[0],
            fold_0_unequal_37 ^ catch_fragment_row[4], fold_0_unequal_38 ^ catch_fragment_row[8],
            fold_0_unequal_39 ^ catch_fragment_column[3], fold_0_unequal_40 ^ catch_fragment_column[7],
            fold_0_unequal_41 ^ catch_write_cardinal_0[0], fold_0_unequal_42 ^ catch_write_cardinal_0[4],
            fold_0_unequal_43 ^ catch_write_cardinal_0[8], fold_0_unequal_44 ^ catch_write_cardinal_0[12],
            fold_0_unequal_45 ^ catch_write_attribute_5[0], fold_0_unequal_46 ^ catch_write_attribute_5[4],
            fold_0_unequal_47 ^ catch_write_attribute_5[8], fold_0_unequal_48 ^ catch_write_attribute_5[12],
            fold_0_unequal_49 ^ catch_write_attribute_4[0], fold_0_unequal_50 ^ catch_write_attribute_4[4],
            fold_0_unequal_51 ^ catch_write_attribute_4[8], fold_0_unequal_52 ^ catch_write_attribute_4[12],
            fold_0_unequal_53 ^ catch_write_attribute_3[0], fold_0_unequal_54 ^ catch_write_attribute_3[4],
            fold_0_unequal_55 ^ catch_write_attribute_3[8], fold_0_unequal_56 ^ catch_write_attribute_3[12],
            fold_0_unequal_57 ^ catch_write_attribute_2[0], fold_0_unequal_58 ^ catch_write_attribute_2[4],
            fold_0_unequal_59 ^ catch_write_attribute_2[8], fold_0_unequal_60 ^ catch_write_attribute_2[12],
            fold_0_unequal_61 ^ catch_write_attribute_1[0], fold_0_unequal_62 ^ catch_write_attribute_1[4],
            fold_0_unequal_63 ^ catch_write_attribute_1[8], fold_0_unequal_64 ^ catch_write_attribute_1[12],
            fold_0_unequal_65 ^ catch_write_attribute_0[0], fold_0_unequal_66 ^ catch_write_attribute_0[4],
            fold_0_unequal_67 ^ catch_write_attribute_0[8], fold_0_unequal_68 ^ catch_write_attribute_0[12],
            fold_0_unequal_69 ^ catch_write_peak[0], fold_0_unequal_70, fold_0_unequal_71,
            fold_0_unequal_72 ^ catch_write_peak[12], fold_0_unequal_73 ^ catch_write_depth[0],
            fold_0_unequal_74 ^ catch_write_depth[4], fold_0_unequal_75 ^ catch_write_depth[8],
            fold_0_unequal_76 ^ catch_write_depth[12], fold_0_unequal_77 ^ catch_write_depth[16],
            fold_0_unequal_78 ^ catch_write_depth[20], fold_0_unequal_79 ^ catch_write_depth[24],
            fold_0_unequal_80 ^ catch_write_depth[28], fold_0_unequal_81 ^ catch_write_depth[32],
            fold_0_unequal_82 ^ catch_write_depth[36], fold_0_unequal_83 ^ catch_write_depth[40],
            fold_0_unequal_84 ^ catch_write_depth[44], fold_0_unequal_85 ^ catch_write_depth[48],
            fold_0_unequal_86 ^ catch_write_weight[0], fold_0_unequal_87 ^ catch_write_weight[4],
            fold_0_unequal_88 ^ catch_write_weight[8], fold_0_unequal_89 ^ catch_write_weight[12],
            fold_0_unequal_90 ^ catch_write_weight[16], fold_0_unequal_91 ^ catch_write_weight[20],
            fold_0_unequal_92 ^ catch_write_weight[24], fold_0_unequal_93 ^ catch_write_pixel[0],
            fold_0_unequal_94 ^ catch_write_pixel[4], fold_0_unequal_95, fold_0_unequal_96, fold_0_unequal_97,
            fold_0_unequal_98, fold_0_unequal_99, fold_0_unequal_100, fold_0_unequal_101, fold_0_unequal_102,
            fold_0_unequal_103, fold_0_unequal_104, catch_frame_set_up ^ catch_splat_ready
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
            fold_0[100] ^ fold_0[101] ^ fold_0[102] ^ fold_0[103], fold_0[104]
        };
        fold_2 <= {
            fold_1[0] ^ fold_1[1] ^ fold_1[2] ^ fold_1[3], fold_1[4] ^ fold_1[5] ^ fold_1[6] ^ fold_1[7],
            fold_1[8] ^ fold_1[9] ^ fold_1[10] ^ fold_1[11], fold_1[12] ^ fold_1[13] ^ fold_1[14] ^ fold_1[15],
            fold_1[16] ^ fold_1[17] ^ fold_1[18] ^ fold_1[19], fold_1[20] ^ fold_1[21] ^ fold_1[22] ^ fold_1[23],
            fold_1[24] ^ fold_1[25] ^ fold_1[26]
        };
        fold_3 <= {fold_2[0] ^ fold_2[1] ^ fold_2[2] ^ fold_2[3], fold_2[4] ^ fold_2[5] ^ fold_2[6]};
        fold_4 <= fold_3[0] ^ fold_3[1];
    end
endmodule
