// Written by pointcore 0.1.0; do not edit.
// Replays what bit-exact models did at their ports, and compares every output in every cycle; a stream's fields count while it is valid, and
// those that go in are spoilt while it is not. For Verilator, whose registers start at random values: in a simulator with unknown values,
// what is not reset stays unknown longer than in hardware.
//
// A recording is a sequence of bits: in every cycle one, whether anything changes, and if so one for each group of ports, whether it does,
// then the words of those that do.

module splat_test;
    wire [2:0] passed;

    splat_top_replay replay_0 (.passed(passed[0]));
    splat_setup_replay replay_1 (.passed(passed[1]));
    splat_operators_replay replay_2 (.passed(passed[2]));

    initial begin
        wait (&passed);
        $display("PASSED");
        $finish;
    end
endmodule

// 260931 cycles of splat_top, which 23143 items leave.
module splat_top_replay(output reg passed = 1'b0);
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [63:0] words [0:233427];
    reg [1525:0] vector = 0;
    reg [1525:0] next = 0;
    wire [1525:0] found;
    reg changes;
    reg [6:0] changed;
    integer place = 0;
    integer i;
    integer cycle;
    integer differences = 0;

    splat_top replayed (
        .clk(clk),
        .rst(rst || vector[0]),
        .uniform_valid(vector[1]),
        .uniform_address(vector[1] ? vector[6:2] : ~vector[6:2]),
        .uniform_data(vector[1] ? vector[38:7] : ~vector[38:7]),
        .splat_valid(vector[39]),
        .splat_ready(found[40]),
        .splat_end(vector[39] ? vector[41] : ~vector[41]),
        .splat_center_x(vector[39] ? vector[73:42] : ~vector[73:42]),
        .splat_center_y(vector[39] ? vector[105:74] : ~vector[105:74]),
        .splat_center_z(vector[39] ? vector[137:106] : ~vector[137:106]),
        .splat_tangent1_x(vector[39] ? vector[169:138] : ~vector[169:138]),
        .splat_tangent1_y(vector[39] ? vector[201:170] : ~vector[201:170]),
        .splat_tangent1_z(vector[39] ? vector[233:202] : ~vector[233:202]),
        .splat_tangent2_x(vector[39] ? vector[265:234] : ~vector[265:234]),
        .splat_tangent2_y(vector[39] ? vector[297:266] : ~vector[297:266]),
        .splat_tangent2_z(vector[39] ? vector[329:298] : ~vector[329:298]),
        .splat_attribute_0(vector[39] ? vector[345:330] : ~vector[345:330]),
        .splat_attribute_1(vector[39] ? vector[361:346] : ~vector[361:346]),
        .splat_attribute_2(vector[39] ? vector[377:362] : ~vector[377:362]),
        .splat_attribute_3(vector[39] ? vector[393:378] : ~vector[393:378]),
        .splat_attribute_4(vector[39] ? vector[409:394] : ~vector[409:394]),
        .splat_attribute_5(vector[39] ? vector[425:410] : ~vector[425:410]),
        .splat_attribute_6(vector[39] ? vector[441:426] : ~vector[441:426]),
        .splat_attribute_7(vector[39] ? vector[457:442] : ~vector[457:442]),
        .splat_attribute_8(vector[39] ? vector[473:458] : ~vector[473:458]),
        .splat_attribute_9(vector[39] ? vector[489:474] : ~vector[489:474]),
        .splat_attribute_10(vector[39] ? vector[505:490] : ~vector[505:490]),
        .splat_attribute_11(vector[39] ? vector[521:506] : ~vector[521:506]),
        .splat_attribute_12(vector[39] ? vector[537:522] : ~vector[537:522]),
        .splat_cardinal_0(vector[39] ? vector[553:538] : ~vector[553:538]),
        .frame_set_up(found[554]),
        .read_valid(found[555]),
        .read_ready(vector[556]),
        .read_surface(found[557]),
        .read_tile(found[569:558]),
        .read_pixel(found[575:570]),
        .read_count(found[579:576]),
        .data_valid(vector[580]),
        .data_ready(found[581]),
        .data_weight(vector[580] ? vector[609:582] : ~vector[609:582]),
        .data_depth(vector[580] ? vector[661:610] : ~vector[661:610]),
        .data_peak(vector[580] ? vector[677:662] : ~vector[677:662]),
        .data_attribute_0(vector[580] ? vector[693:678] : ~vector[693:678]),
        .data_attribute_1(vector[580] ? vector[709:694] : ~vector[709:694]),
        .data_attribute_2(vector[580] ? vector[725:710] : ~vector[725:710]),
        .data_attribute_3(vector[580] ? vector[741:726] : ~vector[741:726]),
        .data_attribute_4(vector[580] ? vector[757:742] : ~vector[757:742]),
        .data_attribute_5(vector[580] ? vector[773:758] : ~vector[773:758]),
        .data_attribute_6(vector[580] ? vector[789:774] : ~vector[789:774]),
        .data_attribute_7(vector[580] ? vector[805:790] : ~vector[805:790]),
        .data_attribute_8(vector[580] ? vector[821:806] : ~vector[821:806]),
        .data_attribute_9(vector[580] ? vector[837:822] : ~vector[837:822]),
        .data_attribute_10(vector[580] ? vector[853:838] : ~vector[853:838]),
        .data_attribute_11(vector[580] ? vector[869:854] : ~vector[869:854]),
        .data_attribute_12(vector[580] ? vector[885:870] : ~vector[885:870]),
        .data_cardinal_0(vector[580] ? vector[901:886] : ~vector[901:886]),
        .write_valid(found[902]),
        .write_ready(vector[903]),
        .write_surface(found[904]),
        .write_tile(found[916:905]),
        .write_pixel(found[922:917]),
        .write_weight(found[950:923]),
        .write_depth(found[1002:951]),
        .write_peak(found[1018:1003]),
        .write_attribute_0(found[1034:1019]),
        .write_attribute_1(found[1050:1035]),
        .write_attribute_2(found[1066:1051]),
        .write_attribute_3(found[1082:1067]),
        .write_attribute_4(found[1098:1083]),
        .write_attribute_5(found[1114:1099]),
        .write_attribute_6(found[1130:1115]),
        .write_attribute_7(found[1146:1131]),
        .write_attribute_8(found[1162:1147]),
        .write_attribute_9(found[1178:1163]),
        .write_attribute_10(found[1194:1179]),
        .write_attribute_11(found[1210:1195]),
        .write_attribute_12(found[1226:1211]),
        .write_cardinal_0(found[1242:1227]),
        .fragment_valid(found[1243]),
        .fragment_ready(vector[1244]),
        .fragment_end(found[1245]),
        .fragment_column(found[1254:1246]),
        .fragment_row(found[1263:1255]),
        .fragment_depth(found[1295:1264]),
        .fragment_attribute_0(found[1311:1296]),
        .fragment_attribute_1(found[1327:1312]),
        .fragment_attribute_2(found[1343:1328]),
        .fragment_attribute_3(found[1359:1344]),
        .fragment_attribute_4(found[1375:1360]),
        .fragment_attribute_5(found[1391:1376]),
        .fragment_attribute_6(found[1407:1392]),
        .fragment_attribute_7(found[1423:1408]),
        .fragment_attribute_8(found[1439:1424]),
        .fragment_attribute_9(found[1455:1440]),
        .fragment_attribute_10(found[1471:1456]),
        .fragment_attribute_11(found[1487:1472]),
        .fragment_attribute_12(found[1503:1488]),
        .fragment_cardinal_0(found[1519:1504]),
        .event_sample(found[1520]),
        .event_starved(found[1521]),
        .event_blocked(found[1522]),
        .event_accumulate(found[1523]),
        .event_hazard(found[1524]),
        .event_slot_wait(found[1525])
    );

    always #5 clk = !clk;

    // The next bit of the recording.
    task take_bit(output result);
        begin
            result = words[place / 64][place % 64];
            place = place + 1;
        end
    endtask

    // The next bits of the recording become bits of the next vector.
    task take(input integer low, input integer width);
        for (i = low; i < low + width; i = i + 1) take_bit(next[i]);
    endtask

    task advance;
        begin
            take_bit(changes);
            for (i = 0; i <= 6; i = i + 1) begin
                if (changes) take_bit(changed[i]);
                else changed[i] = 1'b0;
            end
            if (changed[0]) begin take(0, 1); take(1, 1); take(39, 1); take(40, 1); take(554, 1); take(555, 1); take(556, 1); take(580, 1); take(581, 1); take(902, 1); take(903, 1); take(1243, 1); take(1244, 1); take(1520, 1); take(1521, 1); take(1522, 1); take(1523, 1); take(1524, 1); take(1525, 1); end
            if (changed[1]) begin take(2, 5); take(7, 32); end
            if (changed[2]) begin take(41, 1); take(42, 32); take(74, 32); take(106, 32); take(138, 32); take(170, 32); take(202, 32); take(234, 32); take(266, 32); take(298, 32); take(330, 16); take(346, 16); take(362, 16); take(378, 16); take(394, 16); take(410, 16); take(426, 16); take(442, 16); take(458, 16); take(474, 16); take(490, 16); take(506, 16); take(522, 16); take(538, 16); end
            if (changed[3]) begin take(557, 1); take(558, 12); take(570, 6); take(576, 4); end
            if (changed[4]) begin take(582, 28); take(610, 52); take(662, 16); take(678, 16); take(694, 16); take(710, 16); take(726, 16); take(742, 16); take(758, 16); take(774, 16); take(790, 16); take(806, 16); take(822, 16); take(838, 16); take(854, 16); take(870, 16); take(886, 16); end
            if (changed[5]) begin take(904, 1); take(905, 12); take(917, 6); take(923, 28); take(951, 52); take(1003, 16); take(1019, 16); take(1035, 16); take(1051, 16); take(1067, 16); take(1083, 16); take(1099, 16); take(1115, 16); take(1131, 16); take(1147, 16); take(1163, 16); take(1179, 16); take(1195, 16); take(1211, 16); take(1227, 16); end
            if (changed[6]) begin take(1245, 1); take(1246, 9); take(1255, 9); take(1264, 32); take(1296, 16); take(1312, 16); take(1328, 16); take(1344, 16); take(1360, 16); take(1376, 16); take(1392, 16); take(1408, 16); take(1424, 16); take(1440, 16); take(1456, 16); take(1472, 16); take(1488, 16); take(1504, 16); end
            vector = next;
        end
    endtask

    task differ(input [8*32-1:0] port);
        begin
            differences = differences + 1;
            $display("splat_top, cycle %0d: %0s differs from the model", cycle, port);
        end
    endtask

    initial begin
        $readmemh("splat_test.hex", words);
        repeat (1) @(negedge clk);
        rst = 1'b0;
        for (cycle = 0; cycle < 260931 && differences == 0; cycle = cycle + 1) begin
            advance;
            #4;
            if (found[40] !== vector[40]) differ("splat_ready");
            if (found[554] !== vector[554]) differ("frame_set_up");
            if (found[555] !== vector[555]) differ("read_valid");
            if (vector[555] && found[557] !== vector[557]) differ("read_surface");
            if (vector[555] && found[569:558] !== vector[569:558]) differ("read_tile");
            if (vector[555] && found[575:570] !== vector[575:570]) differ("read_pixel");
            if (vector[555] && found[579:576] !== vector[579:576]) differ("read_count");
            if (found[581] !== vector[581]) differ("data_ready");
            if (found[902] !== vector[902]) differ("write_valid");
            if (vector[902] && found[904] !== vector[904]) differ("write_surface");
            if (vector[902] && found[916:905] !== vector[916:905]) differ("write_tile");
            if (vector[902] && found[922:917] !== vector[922:917]) differ("write_pixel");
            if (vector[902] && found[950:923] !== vector[950:923]) differ("write_weight");
            if (vector[902] && found[1002:951] !== vector[1002:951]) differ("write_depth");
            if (vector[902] && found[1018:1003] !== vector[1018:1003]) differ("write_peak");
            if (vector[902] && found[1034:1019] !== vector[1034:1019]) differ("write_attribute_0");
            if (vector[902] && found[1050:1035] !== vector[1050:1035]) differ("write_attribute_1");
            if (vector[902] && found[1066:1051] !== vector[1066:1051]) differ("write_attribute_2");
            if (vector[902] && found[1082:1067] !== vector[1082:1067]) differ("write_attribute_3");
            if (vector[902] && found[1098:1083] !== vector[1098:1083]) differ("write_attribute_4");
            if (vector[902] && found[1114:1099] !== vector[1114:1099]) differ("write_attribute_5");
            if (vector[902] && found[1130:1115] !== vector[1130:1115]) differ("write_attribute_6");
            if (vector[902] && found[1146:1131] !== vector[1146:1131]) differ("write_attribute_7");
            if (vector[902] && found[1162:1147] !== vector[1162:1147]) differ("write_attribute_8");
            if (vector[902] && found[1178:1163] !== vector[1178:1163]) differ("write_attribute_9");
            if (vector[902] && found[1194:1179] !== vector[1194:1179]) differ("write_attribute_10");
            if (vector[902] && found[1210:1195] !== vector[1210:1195]) differ("write_attribute_11");
            if (vector[902] && found[1226:1211] !== vector[1226:1211]) differ("write_attribute_12");
            if (vector[902] && found[1242:1227] !== vector[1242:1227]) differ("write_cardinal_0");
            if (found[1243] !== vector[1243]) differ("fragment_valid");
            if (vector[1243] && found[1245] !== vector[1245]) differ("fragment_end");
            if (vector[1243] && !vector[1245] && found[1254:1246] !== vector[1254:1246]) differ("fragment_column");
            if (vector[1243] && !vector[1245] && found[1263:1255] !== vector[1263:1255]) differ("fragment_row");
            if (vector[1243] && !vector[1245] && found[1295:1264] !== vector[1295:1264]) differ("fragment_depth");
            if (vector[1243] && !vector[1245] && found[1311:1296] !== vector[1311:1296]) differ("fragment_attribute_0");
            if (vector[1243] && !vector[1245] && found[1327:1312] !== vector[1327:1312]) differ("fragment_attribute_1");
            if (vector[1243] && !vector[1245] && found[1343:1328] !== vector[1343:1328]) differ("fragment_attribute_2");
            if (vector[1243] && !vector[1245] && found[1359:1344] !== vector[1359:1344]) differ("fragment_attribute_3");
            if (vector[1243] && !vector[1245] && found[1375:1360] !== vector[1375:1360]) differ("fragment_attribute_4");
            if (vector[1243] && !vector[1245] && found[1391:1376] !== vector[1391:1376]) differ("fragment_attribute_5");
            if (vector[1243] && !vector[1245] && found[1407:1392] !== vector[1407:1392]) differ("fragment_attribute_6");
            if (vector[1243] && !vector[1245] && found[1423:1408] !== vector[1423:1408]) differ("fragment_attribute_7");
            if (vector[1243] && !vector[1245] && found[1439:1424] !== vector[1439:1424]) differ("fragment_attribute_8");
            if (vector[1243] && !vector[1245] && found[1455:1440] !== vector[1455:1440]) differ("fragment_attribute_9");
            if (vector[1243] && !vector[1245] && found[1471:1456] !== vector[1471:1456]) differ("fragment_attribute_10");
            if (vector[1243] && !vector[1245] && found[1487:1472] !== vector[1487:1472]) differ("fragment_attribute_11");
            if (vector[1243] && !vector[1245] && found[1503:1488] !== vector[1503:1488]) differ("fragment_attribute_12");
            if (vector[1243] && !vector[1245] && found[1519:1504] !== vector[1519:1504]) differ("fragment_cardinal_0");
            if (found[1520] !== vector[1520]) differ("event_sample");
            if (found[1521] !== vector[1521]) differ("event_starved");
            if (found[1522] !== vector[1522]) differ("event_blocked");
            if (found[1523] !== vector[1523]) differ("event_accumulate");
            if (found[1524] !== vector[1524]) differ("event_hazard");
            if (found[1525] !== vector[1525]) differ("event_slot_wait");
            @(negedge clk);
        end
        if (differences != 0) $fatal(1, "FAILED");
        $display("splat_top: 260931 cycles, 23143 items, every output as the model's");
        passed = 1'b1;
    end
endmodule

// 43151 cycles of splat_setup, which 2030 items leave.
module splat_setup_replay(output reg passed = 1'b0);
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [63:0] words [0:64900];
    reg [1563:0] vector = 0;
    reg [1563:0] next = 0;
    wire [1563:0] found;
    reg changes;
    reg [3:0] changed;
    integer place = 0;
    integer i;
    integer cycle;
    integer differences = 0;

    splat_setup replayed (
        .clk(clk),
        .rst(rst || vector[0]),
        .in_valid(vector[1]),
        .in_ready(found[2]),
        .in_end(vector[1] ? vector[3] : ~vector[3]),
        .in_center_x(vector[1] ? vector[35:4] : ~vector[35:4]),
        .in_center_y(vector[1] ? vector[67:36] : ~vector[67:36]),
        .in_center_z(vector[1] ? vector[99:68] : ~vector[99:68]),
        .in_tangent1_x(vector[1] ? vector[131:100] : ~vector[131:100]),
        .in_tangent1_y(vector[1] ? vector[163:132] : ~vector[163:132]),
        .in_tangent1_z(vector[1] ? vector[195:164] : ~vector[195:164]),
        .in_tangent2_x(vector[1] ? vector[227:196] : ~vector[227:196]),
        .in_tangent2_y(vector[1] ? vector[259:228] : ~vector[259:228]),
        .in_tangent2_z(vector[1] ? vector[291:260] : ~vector[291:260]),
        .in_attribute_0(vector[1] ? vector[307:292] : ~vector[307:292]),
        .in_attribute_1(vector[1] ? vector[323:308] : ~vector[323:308]),
        .in_attribute_2(vector[1] ? vector[339:324] : ~vector[339:324]),
        .in_attribute_3(vector[1] ? vector[355:340] : ~vector[355:340]),
        .in_attribute_4(vector[1] ? vector[371:356] : ~vector[371:356]),
        .in_attribute_5(vector[1] ? vector[387:372] : ~vector[387:372]),
        .in_attribute_6(vector[1] ? vector[403:388] : ~vector[403:388]),
        .in_attribute_7(vector[1] ? vector[419:404] : ~vector[419:404]),
        .in_attribute_8(vector[1] ? vector[435:420] : ~vector[435:420]),
        .in_attribute_9(vector[1] ? vector[451:436] : ~vector[451:436]),
        .in_attribute_10(vector[1] ? vector[467:452] : ~vector[467:452]),
        .in_attribute_11(vector[1] ? vector[483:468] : ~vector[483:468]),
        .in_attribute_12(vector[1] ? vector[499:484] : ~vector[499:484]),
        .in_cardinal_0(vector[1] ? vector[515:500] : ~vector[515:500]),
        .near_plane(vector[1531:1500]),
        .filter_radius(vector[1563:1532]),
        .depth_a(vector[1403:1372]),
        .depth_b(vector[1435:1404]),
        .epsilon_scale(vector[1467:1436]),
        .epsilon_bias(vector[1499:1468]),
        .scale_x(vector[1275:1244]),
        .origin_x(vector[1339:1308]),
        .scale_y(vector[1307:1276]),
        .origin_y(vector[1371:1340]),
        .out_valid(found[516]),
        .out_ready(vector[517]),
        .out_end(found[518]),
        .out_center_x(found[550:519]),
        .out_center_y(found[582:551]),
        .out_ax(found[614:583]),
        .out_bx(found[646:615]),
        .out_ay(found[678:647]),
        .out_by(found[710:679]),
        .out_delta(found[742:711]),
        .out_mx(found[774:743]),
        .out_my(found[806:775]),
        .out_sight_negative(found[807]),
        .out_sight_near(found[838:808]),
        .out_sight_far(found[869:839]),
        .out_sight_turned(found[870]),
        .out_sight_disc(found[871]),
        .out_depth(found[895:872]),
        .out_depth_low(found[919:896]),
        .out_depth_high(found[943:920]),
        .out_attribute_0(found[959:944]),
        .out_attribute_1(found[975:960]),
        .out_attribute_2(found[991:976]),
        .out_attribute_3(found[1007:992]),
        .out_attribute_4(found[1023:1008]),
        .out_attribute_5(found[1039:1024]),
        .out_attribute_6(found[1055:1040]),
        .out_attribute_7(found[1071:1056]),
        .out_attribute_8(found[1087:1072]),
        .out_attribute_9(found[1103:1088]),
        .out_attribute_10(found[1119:1104]),
        .out_attribute_11(found[1135:1120]),
        .out_attribute_12(found[1151:1136]),
        .out_cardinal_0(found[1167:1152]),
        .out_left(found[1176:1168]),
        .out_right(found[1185:1177]),
        .out_top(found[1194:1186]),
        .out_bottom(found[1203:1195]),
        .out_first_sum(found[1213:1204]),
        .out_last_sum(found[1223:1214]),
        .out_first_difference(found[1233:1224]),
        .out_last_difference(found[1243:1234])
    );

    always #5 clk = !clk;

    // The next bit of the recording.
    task take_bit(output result);
        begin
            result = words[place / 64][place % 64];
            place = place + 1;
        end
    endtask

    // The next bits of the recording become bits of the next vector.
    task take(input integer low, input integer width);
        for (i = low; i < low + width; i = i + 1) take_bit(next[i]);
    endtask

    task advance;
        begin
            take_bit(changes);
            for (i = 0; i <= 3; i = i + 1) begin
                if (changes) take_bit(changed[i]);
                else changed[i] = 1'b0;
            end
            if (changed[0]) begin take(0, 1); take(1, 1); take(2, 1); take(516, 1); take(517, 1); end
            if (changed[1]) begin take(1244, 32); take(1276, 32); take(1308, 32); take(1340, 32); take(1372, 32); take(1404, 32); take(1436, 32); take(1468, 32); take(1500, 32); take(1532, 32); end
            if (changed[2]) begin take(3, 1); take(4, 32); take(36, 32); take(68, 32); take(100, 32); take(132, 32); take(164, 32); take(196, 32); take(228, 32); take(260, 32); take(292, 16); take(308, 16); take(324, 16); take(340, 16); take(356, 16); take(372, 16); take(388, 16); take(404, 16); take(420, 16); take(436, 16); take(452, 16); take(468, 16); take(484, 16); take(500, 16); end
            if (changed[3]) begin take(518, 1); take(519, 32); take(551, 32); take(583, 32); take(615, 32); take(647, 32); take(679, 32); take(711, 32); take(743, 32); take(775, 32); take(807, 1); take(808, 31); take(839, 31); take(870, 1); take(871, 1); take(872, 24); take(896, 24); take(920, 24); take(944, 16); take(960, 16); take(976, 16); take(992, 16); take(1008, 16); take(1024, 16); take(1040, 16); take(1056, 16); take(1072, 16); take(1088, 16); take(1104, 16); take(1120, 16); take(1136, 16); take(1152, 16); take(1168, 9); take(1177, 9); take(1186, 9); take(1195, 9); take(1204, 10); take(1214, 10); take(1224, 10); take(1234, 10); end
            vector = next;
        end
    endtask

    task differ(input [8*32-1:0] port);
        begin
            differences = differences + 1;
            $display("splat_setup, cycle %0d: %0s differs from the model", cycle, port);
        end
    endtask

    initial begin
        $readmemh("splat_setup_test.hex", words);
        repeat (1) @(negedge clk);
        rst = 1'b0;
        for (cycle = 0; cycle < 43151 && differences == 0; cycle = cycle + 1) begin
            advance;
            #4;
            if (found[2] !== vector[2]) differ("in_ready");
            if (found[516] !== vector[516]) differ("out_valid");
            if (vector[516] && found[518] !== vector[518]) differ("out_end");
            if (vector[516] && !vector[518] && found[550:519] !== vector[550:519]) differ("out_center_x");
            if (vector[516] && !vector[518] && found[582:551] !== vector[582:551]) differ("out_center_y");
            if (vector[516] && !vector[518] && found[614:583] !== vector[614:583]) differ("out_ax");
            if (vector[516] && !vector[518] && found[646:615] !== vector[646:615]) differ("out_bx");
            if (vector[516] && !vector[518] && found[678:647] !== vector[678:647]) differ("out_ay");
            if (vector[516] && !vector[518] && found[710:679] !== vector[710:679]) differ("out_by");
            if (vector[516] && !vector[518] && found[742:711] !== vector[742:711]) differ("out_delta");
            if (vector[516] && !vector[518] && found[774:743] !== vector[774:743]) differ("out_mx");
            if (vector[516] && !vector[518] && found[806:775] !== vector[806:775]) differ("out_my");
            if (vector[516] && !vector[518] && found[807] !== vector[807]) differ("out_sight_negative");
            if (vector[516] && !vector[518] && found[838:808] !== vector[838:808]) differ("out_sight_near");
            if (vector[516] && !vector[518] && found[869:839] !== vector[869:839]) differ("out_sight_far");
            if (vector[516] && !vector[518] && found[870] !== vector[870]) differ("out_sight_turned");
            if (vector[516] && !vector[518] && found[871] !== vector[871]) differ("out_sight_disc");
            if (vector[516] && !vector[518] && found[895:872] !== vector[895:872]) differ("out_depth");
            if (vector[516] && !vector[518] && found[919:896] !== vector[919:896]) differ("out_depth_low");
            if (vector[516] && !vector[518] && found[943:920] !== vector[943:920]) differ("out_depth_high");
            if (vector[516] && !vector[518] && found[959:944] !== vector[959:944]) differ("out_attribute_0");
            if (vector[516] && !vector[518] && found[975:960] !== vector[975:960]) differ("out_attribute_1");
            if (vector[516] && !vector[518] && found[991:976] !== vector[991:976]) differ("out_attribute_2");
            if (vector[516] && !vector[518] && found[1007:992] !== vector[1007:992]) differ("out_attribute_3");
            if (vector[516] && !vector[518] && found[1023:1008] !== vector[1023:1008]) differ("out_attribute_4");
            if (vector[516] && !vector[518] && found[1039:1024] !== vector[1039:1024]) differ("out_attribute_5");
            if (vector[516] && !vector[518] && found[1055:1040] !== vector[1055:1040]) differ("out_attribute_6");
            if (vector[516] && !vector[518] && found[1071:1056] !== vector[1071:1056]) differ("out_attribute_7");
            if (vector[516] && !vector[518] && found[1087:1072] !== vector[1087:1072]) differ("out_attribute_8");
            if (vector[516] && !vector[518] && found[1103:1088] !== vector[1103:1088]) differ("out_attribute_9");
            if (vector[516] && !vector[518] && found[1119:1104] !== vector[1119:1104]) differ("out_attribute_10");
            if (vector[516] && !vector[518] && found[1135:1120] !== vector[1135:1120]) differ("out_attribute_11");
            if (vector[516] && !vector[518] && found[1151:1136] !== vector[1151:1136]) differ("out_attribute_12");
            if (vector[516] && !vector[518] && found[1167:1152] !== vector[1167:1152]) differ("out_cardinal_0");
            if (vector[516] && !vector[518] && found[1176:1168] !== vector[1176:1168]) differ("out_left");
            if (vector[516] && !vector[518] && found[1185:1177] !== vector[1185:1177]) differ("out_right");
            if (vector[516] && !vector[518] && found[1194:1186] !== vector[1194:1186]) differ("out_top");
            if (vector[516] && !vector[518] && found[1203:1195] !== vector[1203:1195]) differ("out_bottom");
            if (vector[516] && !vector[518] && found[1213:1204] !== vector[1213:1204]) differ("out_first_sum");
            if (vector[516] && !vector[518] && found[1223:1214] !== vector[1223:1214]) differ("out_last_sum");
            if (vector[516] && !vector[518] && found[1233:1224] !== vector[1233:1224]) differ("out_first_difference");
            if (vector[516] && !vector[518] && found[1243:1234] !== vector[1243:1234]) differ("out_last_difference");
            @(negedge clk);
        end
        if (differences != 0) $fatal(1, "FAILED");
        $display("splat_setup: 43151 cycles, 2030 items, every output as the model's");
        passed = 1'b1;
    end
endmodule

// 2656 cycles of splat_operators, which 2622 items leave.
module splat_operators_replay(output reg passed = 1'b0);
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [63:0] words [0:23317];
    reg [654:0] vector = 0;
    reg [654:0] next = 0;
    wire [654:0] found;
    reg changes;
    reg [2:0] changed;
    integer place = 0;
    integer i;
    integer cycle;
    integer differences = 0;

    splat_operators replayed (
        .clk(clk),
        .rst(rst || vector[0]),
        .enable(vector[1]),
        .a(vector[33:2]),
        .b(vector[65:34]),
        .c(vector[97:66]),
        .results_valid(found[98]),
        .results_mul_0(found[130:99]),
        .results_add_1(found[162:131]),
        .results_lt_2(found[163]),
        .results_max_3(found[195:164]),
        .results_recip_4(found[227:196]),
        .results_mul_5(found[259:228]),
        .results_sqrt_6(found[291:260]),
        .results_le_7(found[292]),
        .results_min_8(found[324:293]),
        .results_to_fixed_u21q8_9(found[345:325]),
        .results_to_fixed_u23q8_10(found[368:346]),
        .results_to_fixed_s22q8_11(found[390:369]),
        .results_to_fixed_u24q24_12(found[414:391]),
        .results_from_fixed_u10q1_13(found[446:415]),
        .results_div_14(found[478:447]),
        .results_to_fixed_u16q16_15(found[494:479]),
        .results_from_fixed_u16q16_16(found[510:495]),
        .results_mul_17(found[526:511]),
        .results_add_18(found[542:527]),
        .results_from_fixed_u28q16_19(found[574:543]),
        .results_from_fixed_u52q40_20(found[606:575]),
        .results_convert_f32_ftz_21(found[638:607]),
        .results_convert_f16_22(found[654:639])
    );

    always #5 clk = !clk;

    // The next bit of the recording.
    task take_bit(output result);
        begin
            result = words[place / 64][place % 64];
            place = place + 1;
        end
    endtask

    // The next bits of the recording become bits of the next vector.
    task take(input integer low, input integer width);
        for (i = low; i < low + width; i = i + 1) take_bit(next[i]);
    endtask

    task advance;
        begin
            take_bit(changes);
            for (i = 0; i <= 2; i = i + 1) begin
                if (changes) take_bit(changed[i]);
                else changed[i] = 1'b0;
            end
            if (changed[0]) begin take(0, 1); take(1, 1); take(98, 1); end
            if (changed[1]) begin take(2, 32); take(34, 32); take(66, 32); end
            if (changed[2]) begin take(99, 32); take(131, 32); take(163, 1); take(164, 32); take(196, 32); take(228, 32); take(260, 32); take(292, 1); take(293, 32); take(325, 21); take(346, 23); take(369, 22); take(391, 24); take(415, 32); take(447, 32); take(479, 16); take(495, 16); take(511, 16); take(527, 16); take(543, 32); take(575, 32); take(607, 32); take(639, 16); end
            vector = next;
        end
    endtask

    task differ(input [8*32-1:0] port);
        begin
            differences = differences + 1;
            $display("splat_operators, cycle %0d: %0s differs from the model", cycle, port);
        end
    endtask

    initial begin
        $readmemh("splat_operators_test.hex", words);
        repeat (1) @(negedge clk);
        rst = 1'b0;
        for (cycle = 0; cycle < 2656 && differences == 0; cycle = cycle + 1) begin
            advance;
            #4;
            if (found[98] !== vector[98]) differ("results_valid");
            if (vector[98] && found[130:99] !== vector[130:99]) differ("results_mul_0");
            if (vector[98] && found[162:131] !== vector[162:131]) differ("results_add_1");
            if (vector[98] && found[163] !== vector[163]) differ("results_lt_2");
            if (vector[98] && found[195:164] !== vector[195:164]) differ("results_max_3");
            if (vector[98] && found[227:196] !== vector[227:196]) differ("results_recip_4");
            if (vector[98] && found[259:228] !== vector[259:228]) differ("results_mul_5");
            if (vector[98] && found[291:260] !== vector[291:260]) differ("results_sqrt_6");
            if (vector[98] && found[292] !== vector[292]) differ("results_le_7");
            if (vector[98] && found[324:293] !== vector[324:293]) differ("results_min_8");
            if (vector[98] && found[345:325] !== vector[345:325]) differ("results_to_fixed_u21q8_9");
            if (vector[98] && found[368:346] !== vector[368:346]) differ("results_to_fixed_u23q8_10");
            if (vector[98] && found[390:369] !== vector[390:369]) differ("results_to_fixed_s22q8_11");
            if (vector[98] && found[414:391] !== vector[414:391]) differ("results_to_fixed_u24q24_12");
            if (vector[98] && found[446:415] !== vector[446:415]) differ("results_from_fixed_u10q1_13");
            if (vector[98] && found[478:447] !== vector[478:447]) differ("results_div_14");
            if (vector[98] && found[494:479] !== vector[494:479]) differ("results_to_fixed_u16q16_15");
            if (vector[98] && found[510:495] !== vector[510:495]) differ("results_from_fixed_u16q16_16");
            if (vector[98] && found[526:511] !== vector[526:511]) differ("results_mul_17");
            if (vector[98] && found[542:527] !== vector[542:527]) differ("results_add_18");
            if (vector[98] && found[574:543] !== vector[574:543]) differ("results_from_fixed_u28q16_19");
            if (vector[98] && found[606:575] !== vector[606:575]) differ("results_from_fixed_u52q40_20");
            if (vector[98] && found[638:607] !== vector[638:607]) differ("results_convert_f32_ftz_21");
            if (vector[98] && found[654:639] !== vector[654:639]) differ("results_convert_f16_22");
            @(negedge clk);
        end
        if (differences != 0) $fatal(1, "FAILED");
        $display("splat_operators: 2656 cycles, 2622 items, every output as the model's");
        passed = 1'b1;
    end
endmodule

// The floating-point operators of a core side by side.
module splat_operators (
    input  wire clk, input wire rst, input wire enable, input wire [31:0] a, input wire [31:0] b,
    input  wire [31:0] c,
    output wire results_valid, output wire [31:0] results_mul_0, output wire [31:0] results_add_1,
    output wire results_lt_2, output wire [31:0] results_max_3, output wire [31:0] results_recip_4,
    output wire [31:0] results_mul_5, output wire [31:0] results_sqrt_6, output wire results_le_7,
    output wire [31:0] results_min_8, output wire [20:0] results_to_fixed_u21q8_9,
    output wire [22:0] results_to_fixed_u23q8_10, output wire [21:0] results_to_fixed_s22q8_11,
    output wire [23:0] results_to_fixed_u24q24_12, output wire [31:0] results_from_fixed_u10q1_13,
    output wire [31:0] results_div_14, output wire [15:0] results_to_fixed_u16q16_15,
    output wire [15:0] results_from_fixed_u16q16_16, output wire [15:0] results_mul_17,
    output wire [15:0] results_add_18, output wire [31:0] results_from_fixed_u28q16_19,
    output wire [31:0] results_from_fixed_u52q40_20, output wire [31:0] results_convert_f32_ftz_21,
    output wire [15:0] results_convert_f16_22
);
    reg [4:0] taken;

    wire valid = taken == 5'd28;

    assign results_valid = valid;

    float_mul_s5_f32ftz mul_0 (.clk(clk), .enable(enable), .a(a), .b(b), .y(results_mul_0));
    float_add_s6_f32ftz add_1 (.clk(clk), .enable(enable), .a(a), .b(b), .y(results_add_1));
    float_lt_s2_f32ftz lt_2 (.clk(clk), .enable(enable), .a(a), .b(b), .y(results_lt_2));
    float_max_s2_f32ftz max_3 (.clk(clk), .enable(enable), .a(a), .b(b), .y(results_max_3));
    float_recip_s28_f32ftz recip_4 (.clk(clk), .enable(enable), .a(a), .y(results_recip_4));
    float_mul_s6_f32ftz mul_5 (.clk(clk), .enable(enable), .a(a), .b(b), .y(results_mul_5));
    float_sqrt_s26_f32ftz sqrt_6 (.clk(clk), .enable(enable), .a(a), .y(results_sqrt_6));
    float_le_s2_f32ftz le_7 (.clk(clk), .enable(enable), .a(a), .b(b), .y(results_le_7));
    float_min_s2_f32ftz min_8 (.clk(clk), .enable(enable), .a(a), .b(b), .y(results_min_8));
    float_to_fixed_s3_f32ftz_w21_f8_unsigned to_fixed_u21q8_9 (.clk(clk), .enable(enable), .a(a), .y(results_to_fixed_u21q8_9));
    float_to_fixed_s3_f32ftz_w23_f8_unsigned to_fixed_u23q8_10 (.clk(clk), .enable(enable), .a(a), .y(results_to_fixed_u23q8_10));
    float_to_fixed_s3_f32ftz_w22_f8_signed to_fixed_s22q8_11 (.clk(clk), .enable(enable), .a(a), .y(results_to_fixed_s22q8_11));
    float_to_fixed_s3_f32ftz_w24_f24_unsigned to_fixed_u24q24_12 (.clk(clk), .enable(enable), .a(a), .y(results_to_fixed_u24q24_12));
    float_from_fixed_s3_f32ftz_w10_f1_unsigned from_fixed_u10q1_13 (.clk(clk), .enable(enable), .a(a[9:0]), .y(results_from_fixed_u10q1_13));
    float_div_s28_f32ftz div_14 (.clk(clk), .enable(enable), .a(a), .b(b), .y(results_div_14));
    float_to_fixed_s3_f32ftz_w16_f16_unsigned to_fixed_u16q16_15 (.clk(clk), .enable(enable), .a(a), .y(results_to_fixed_u16q16_15));

    float_from_fixed_s5_f16_w16_f16_unsigned from_fixed_u16q16_16 (
        .clk(clk), .enable(enable), .a(a[15:0]), .y(results_from_fixed_u16q16_16)
    );

    float_mul_s6_f16 mul_17 (.clk(clk), .enable(enable), .a(a[15:0]), .b(b[15:0]), .y(results_mul_17));
    float_add_s5_f16 add_18 (.clk(clk), .enable(enable), .a(a[15:0]), .b(b[15:0]), .y(results_add_18));

    float_from_fixed_s4_f32ftz_w28_f16_unsigned from_fixed_u28q16_19 (
        .clk(clk), .enable(enable), .a(a[27:0]), .y(results_from_fixed_u28q16_19)
    );

    float_from_fixed_s4_f32ftz_w52_f40_unsigned from_fixed_u52q40_20 (
        .clk(clk), .enable(enable), .a({b[19:0], a}), .y(results_from_fixed_u52q40_20)
    );

    float_convert_s3_f16_f32ftz convert_f32_ftz_21 (.clk(clk), .enable(enable), .a(a[15:0]), .y(results_convert_f32_ftz_21));
    float_convert_s3_f32ftz_f16 convert_f16_22 (.clk(clk), .enable(enable), .a(a), .y(results_convert_f16_22));

    always @(posedge clk) begin
        if (rst) taken <= 5'd0;
        else taken <= (enable & ~valid) ? (taken + 5'd1) : taken;
    end

    wire _unused = &{1'b0, c};
endmodule
