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

// 218289 cycles of splat_top, which 22327 items leave.
module splat_top_replay(output reg passed = 1'b0);
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [63:0] words [0:205355];
    reg [1437:0] vector = 0;
    reg [1437:0] next = 0;
    wire [1437:0] found;
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
        .uniform_data(vector[1] ? vector[30:7] : ~vector[30:7]),
        .splat_valid(vector[31]),
        .splat_ready(found[32]),
        .splat_end(vector[31] ? vector[33] : ~vector[33]),
        .splat_center_x(vector[31] ? vector[57:34] : ~vector[57:34]),
        .splat_center_y(vector[31] ? vector[81:58] : ~vector[81:58]),
        .splat_center_z(vector[31] ? vector[105:82] : ~vector[105:82]),
        .splat_tangent1_x(vector[31] ? vector[129:106] : ~vector[129:106]),
        .splat_tangent1_y(vector[31] ? vector[153:130] : ~vector[153:130]),
        .splat_tangent1_z(vector[31] ? vector[177:154] : ~vector[177:154]),
        .splat_tangent2_x(vector[31] ? vector[201:178] : ~vector[201:178]),
        .splat_tangent2_y(vector[31] ? vector[225:202] : ~vector[225:202]),
        .splat_tangent2_z(vector[31] ? vector[249:226] : ~vector[249:226]),
        .splat_attribute_0(vector[31] ? vector[265:250] : ~vector[265:250]),
        .splat_attribute_1(vector[31] ? vector[281:266] : ~vector[281:266]),
        .splat_attribute_2(vector[31] ? vector[297:282] : ~vector[297:282]),
        .splat_attribute_3(vector[31] ? vector[313:298] : ~vector[313:298]),
        .splat_attribute_4(vector[31] ? vector[329:314] : ~vector[329:314]),
        .splat_attribute_5(vector[31] ? vector[345:330] : ~vector[345:330]),
        .splat_attribute_6(vector[31] ? vector[361:346] : ~vector[361:346]),
        .splat_attribute_7(vector[31] ? vector[377:362] : ~vector[377:362]),
        .splat_attribute_8(vector[31] ? vector[393:378] : ~vector[393:378]),
        .splat_attribute_9(vector[31] ? vector[409:394] : ~vector[409:394]),
        .splat_attribute_10(vector[31] ? vector[425:410] : ~vector[425:410]),
        .splat_attribute_11(vector[31] ? vector[441:426] : ~vector[441:426]),
        .splat_attribute_12(vector[31] ? vector[457:442] : ~vector[457:442]),
        .splat_cardinal_0(vector[31] ? vector[473:458] : ~vector[473:458]),
        .frame_set_up(found[474]),
        .read_valid(found[475]),
        .read_ready(vector[476]),
        .read_surface(found[477]),
        .read_tile(found[489:478]),
        .read_pixel(found[495:490]),
        .read_count(found[499:496]),
        .data_valid(vector[500]),
        .data_ready(found[501]),
        .data_weight(vector[500] ? vector[529:502] : ~vector[529:502]),
        .data_depth(vector[500] ? vector[581:530] : ~vector[581:530]),
        .data_peak(vector[500] ? vector[597:582] : ~vector[597:582]),
        .data_attribute_0(vector[500] ? vector[613:598] : ~vector[613:598]),
        .data_attribute_1(vector[500] ? vector[629:614] : ~vector[629:614]),
        .data_attribute_2(vector[500] ? vector[645:630] : ~vector[645:630]),
        .data_attribute_3(vector[500] ? vector[661:646] : ~vector[661:646]),
        .data_attribute_4(vector[500] ? vector[677:662] : ~vector[677:662]),
        .data_attribute_5(vector[500] ? vector[693:678] : ~vector[693:678]),
        .data_attribute_6(vector[500] ? vector[709:694] : ~vector[709:694]),
        .data_attribute_7(vector[500] ? vector[725:710] : ~vector[725:710]),
        .data_attribute_8(vector[500] ? vector[741:726] : ~vector[741:726]),
        .data_attribute_9(vector[500] ? vector[757:742] : ~vector[757:742]),
        .data_attribute_10(vector[500] ? vector[773:758] : ~vector[773:758]),
        .data_attribute_11(vector[500] ? vector[789:774] : ~vector[789:774]),
        .data_attribute_12(vector[500] ? vector[805:790] : ~vector[805:790]),
        .data_cardinal_0(vector[500] ? vector[821:806] : ~vector[821:806]),
        .write_valid(found[822]),
        .write_ready(vector[823]),
        .write_surface(found[824]),
        .write_tile(found[836:825]),
        .write_pixel(found[842:837]),
        .write_weight(found[870:843]),
        .write_depth(found[922:871]),
        .write_peak(found[938:923]),
        .write_attribute_0(found[954:939]),
        .write_attribute_1(found[970:955]),
        .write_attribute_2(found[986:971]),
        .write_attribute_3(found[1002:987]),
        .write_attribute_4(found[1018:1003]),
        .write_attribute_5(found[1034:1019]),
        .write_attribute_6(found[1050:1035]),
        .write_attribute_7(found[1066:1051]),
        .write_attribute_8(found[1082:1067]),
        .write_attribute_9(found[1098:1083]),
        .write_attribute_10(found[1114:1099]),
        .write_attribute_11(found[1130:1115]),
        .write_attribute_12(found[1146:1131]),
        .write_cardinal_0(found[1162:1147]),
        .fragment_valid(found[1163]),
        .fragment_ready(vector[1164]),
        .fragment_end(found[1165]),
        .fragment_column(found[1174:1166]),
        .fragment_row(found[1183:1175]),
        .fragment_depth(found[1207:1184]),
        .fragment_attribute_0(found[1223:1208]),
        .fragment_attribute_1(found[1239:1224]),
        .fragment_attribute_2(found[1255:1240]),
        .fragment_attribute_3(found[1271:1256]),
        .fragment_attribute_4(found[1287:1272]),
        .fragment_attribute_5(found[1303:1288]),
        .fragment_attribute_6(found[1319:1304]),
        .fragment_attribute_7(found[1335:1320]),
        .fragment_attribute_8(found[1351:1336]),
        .fragment_attribute_9(found[1367:1352]),
        .fragment_attribute_10(found[1383:1368]),
        .fragment_attribute_11(found[1399:1384]),
        .fragment_attribute_12(found[1415:1400]),
        .fragment_cardinal_0(found[1431:1416]),
        .event_sample(found[1432]),
        .event_starved(found[1433]),
        .event_blocked(found[1434]),
        .event_accumulate(found[1435]),
        .event_hazard(found[1436]),
        .event_slot_wait(found[1437])
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
            if (changed[0]) begin take(0, 1); take(1, 1); take(31, 1); take(32, 1); take(474, 1); take(475, 1); take(476, 1); take(500, 1); take(501, 1); take(822, 1); take(823, 1); take(1163, 1); take(1164, 1); take(1432, 1); take(1433, 1); take(1434, 1); take(1435, 1); take(1436, 1); take(1437, 1); end
            if (changed[1]) begin take(2, 5); take(7, 24); end
            if (changed[2]) begin take(33, 1); take(34, 24); take(58, 24); take(82, 24); take(106, 24); take(130, 24); take(154, 24); take(178, 24); take(202, 24); take(226, 24); take(250, 16); take(266, 16); take(282, 16); take(298, 16); take(314, 16); take(330, 16); take(346, 16); take(362, 16); take(378, 16); take(394, 16); take(410, 16); take(426, 16); take(442, 16); take(458, 16); end
            if (changed[3]) begin take(477, 1); take(478, 12); take(490, 6); take(496, 4); end
            if (changed[4]) begin take(502, 28); take(530, 52); take(582, 16); take(598, 16); take(614, 16); take(630, 16); take(646, 16); take(662, 16); take(678, 16); take(694, 16); take(710, 16); take(726, 16); take(742, 16); take(758, 16); take(774, 16); take(790, 16); take(806, 16); end
            if (changed[5]) begin take(824, 1); take(825, 12); take(837, 6); take(843, 28); take(871, 52); take(923, 16); take(939, 16); take(955, 16); take(971, 16); take(987, 16); take(1003, 16); take(1019, 16); take(1035, 16); take(1051, 16); take(1067, 16); take(1083, 16); take(1099, 16); take(1115, 16); take(1131, 16); take(1147, 16); end
            if (changed[6]) begin take(1165, 1); take(1166, 9); take(1175, 9); take(1184, 24); take(1208, 16); take(1224, 16); take(1240, 16); take(1256, 16); take(1272, 16); take(1288, 16); take(1304, 16); take(1320, 16); take(1336, 16); take(1352, 16); take(1368, 16); take(1384, 16); take(1400, 16); take(1416, 16); end
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
        for (cycle = 0; cycle < 218289 && differences == 0; cycle = cycle + 1) begin
            advance;
            #4;
            if (found[32] !== vector[32]) differ("splat_ready");
            if (found[474] !== vector[474]) differ("frame_set_up");
            if (found[475] !== vector[475]) differ("read_valid");
            if (vector[475] && found[477] !== vector[477]) differ("read_surface");
            if (vector[475] && found[489:478] !== vector[489:478]) differ("read_tile");
            if (vector[475] && found[495:490] !== vector[495:490]) differ("read_pixel");
            if (vector[475] && found[499:496] !== vector[499:496]) differ("read_count");
            if (found[501] !== vector[501]) differ("data_ready");
            if (found[822] !== vector[822]) differ("write_valid");
            if (vector[822] && found[824] !== vector[824]) differ("write_surface");
            if (vector[822] && found[836:825] !== vector[836:825]) differ("write_tile");
            if (vector[822] && found[842:837] !== vector[842:837]) differ("write_pixel");
            if (vector[822] && found[870:843] !== vector[870:843]) differ("write_weight");
            if (vector[822] && found[922:871] !== vector[922:871]) differ("write_depth");
            if (vector[822] && found[938:923] !== vector[938:923]) differ("write_peak");
            if (vector[822] && found[954:939] !== vector[954:939]) differ("write_attribute_0");
            if (vector[822] && found[970:955] !== vector[970:955]) differ("write_attribute_1");
            if (vector[822] && found[986:971] !== vector[986:971]) differ("write_attribute_2");
            if (vector[822] && found[1002:987] !== vector[1002:987]) differ("write_attribute_3");
            if (vector[822] && found[1018:1003] !== vector[1018:1003]) differ("write_attribute_4");
            if (vector[822] && found[1034:1019] !== vector[1034:1019]) differ("write_attribute_5");
            if (vector[822] && found[1050:1035] !== vector[1050:1035]) differ("write_attribute_6");
            if (vector[822] && found[1066:1051] !== vector[1066:1051]) differ("write_attribute_7");
            if (vector[822] && found[1082:1067] !== vector[1082:1067]) differ("write_attribute_8");
            if (vector[822] && found[1098:1083] !== vector[1098:1083]) differ("write_attribute_9");
            if (vector[822] && found[1114:1099] !== vector[1114:1099]) differ("write_attribute_10");
            if (vector[822] && found[1130:1115] !== vector[1130:1115]) differ("write_attribute_11");
            if (vector[822] && found[1146:1131] !== vector[1146:1131]) differ("write_attribute_12");
            if (vector[822] && found[1162:1147] !== vector[1162:1147]) differ("write_cardinal_0");
            if (found[1163] !== vector[1163]) differ("fragment_valid");
            if (vector[1163] && found[1165] !== vector[1165]) differ("fragment_end");
            if (vector[1163] && !vector[1165] && found[1174:1166] !== vector[1174:1166]) differ("fragment_column");
            if (vector[1163] && !vector[1165] && found[1183:1175] !== vector[1183:1175]) differ("fragment_row");
            if (vector[1163] && !vector[1165] && found[1207:1184] !== vector[1207:1184]) differ("fragment_depth");
            if (vector[1163] && !vector[1165] && found[1223:1208] !== vector[1223:1208]) differ("fragment_attribute_0");
            if (vector[1163] && !vector[1165] && found[1239:1224] !== vector[1239:1224]) differ("fragment_attribute_1");
            if (vector[1163] && !vector[1165] && found[1255:1240] !== vector[1255:1240]) differ("fragment_attribute_2");
            if (vector[1163] && !vector[1165] && found[1271:1256] !== vector[1271:1256]) differ("fragment_attribute_3");
            if (vector[1163] && !vector[1165] && found[1287:1272] !== vector[1287:1272]) differ("fragment_attribute_4");
            if (vector[1163] && !vector[1165] && found[1303:1288] !== vector[1303:1288]) differ("fragment_attribute_5");
            if (vector[1163] && !vector[1165] && found[1319:1304] !== vector[1319:1304]) differ("fragment_attribute_6");
            if (vector[1163] && !vector[1165] && found[1335:1320] !== vector[1335:1320]) differ("fragment_attribute_7");
            if (vector[1163] && !vector[1165] && found[1351:1336] !== vector[1351:1336]) differ("fragment_attribute_8");
            if (vector[1163] && !vector[1165] && found[1367:1352] !== vector[1367:1352]) differ("fragment_attribute_9");
            if (vector[1163] && !vector[1165] && found[1383:1368] !== vector[1383:1368]) differ("fragment_attribute_10");
            if (vector[1163] && !vector[1165] && found[1399:1384] !== vector[1399:1384]) differ("fragment_attribute_11");
            if (vector[1163] && !vector[1165] && found[1415:1400] !== vector[1415:1400]) differ("fragment_attribute_12");
            if (vector[1163] && !vector[1165] && found[1431:1416] !== vector[1431:1416]) differ("fragment_cardinal_0");
            if (found[1432] !== vector[1432]) differ("event_sample");
            if (found[1433] !== vector[1433]) differ("event_starved");
            if (found[1434] !== vector[1434]) differ("event_blocked");
            if (found[1435] !== vector[1435]) differ("event_accumulate");
            if (found[1436] !== vector[1436]) differ("event_hazard");
            if (found[1437] !== vector[1437]) differ("event_slot_wait");
            @(negedge clk);
        end
        if (differences != 0) $fatal(1, "FAILED");
        $display("splat_top: 218289 cycles, 22327 items, every output as the model's");
        passed = 1'b1;
    end
endmodule

// 66267 cycles of splat_setup, which 2046 items leave.
module splat_setup_replay(output reg passed = 1'b0);
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [63:0] words [0:55521];
    reg [1323:0] vector = 0;
    reg [1323:0] next = 0;
    wire [1323:0] found;
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
        .in_center_x(vector[1] ? vector[27:4] : ~vector[27:4]),
        .in_center_y(vector[1] ? vector[51:28] : ~vector[51:28]),
        .in_center_z(vector[1] ? vector[75:52] : ~vector[75:52]),
        .in_tangent1_x(vector[1] ? vector[99:76] : ~vector[99:76]),
        .in_tangent1_y(vector[1] ? vector[123:100] : ~vector[123:100]),
        .in_tangent1_z(vector[1] ? vector[147:124] : ~vector[147:124]),
        .in_tangent2_x(vector[1] ? vector[171:148] : ~vector[171:148]),
        .in_tangent2_y(vector[1] ? vector[195:172] : ~vector[195:172]),
        .in_tangent2_z(vector[1] ? vector[219:196] : ~vector[219:196]),
        .in_attribute_0(vector[1] ? vector[235:220] : ~vector[235:220]),
        .in_attribute_1(vector[1] ? vector[251:236] : ~vector[251:236]),
        .in_attribute_2(vector[1] ? vector[267:252] : ~vector[267:252]),
        .in_attribute_3(vector[1] ? vector[283:268] : ~vector[283:268]),
        .in_attribute_4(vector[1] ? vector[299:284] : ~vector[299:284]),
        .in_attribute_5(vector[1] ? vector[315:300] : ~vector[315:300]),
        .in_attribute_6(vector[1] ? vector[331:316] : ~vector[331:316]),
        .in_attribute_7(vector[1] ? vector[347:332] : ~vector[347:332]),
        .in_attribute_8(vector[1] ? vector[363:348] : ~vector[363:348]),
        .in_attribute_9(vector[1] ? vector[379:364] : ~vector[379:364]),
        .in_attribute_10(vector[1] ? vector[395:380] : ~vector[395:380]),
        .in_attribute_11(vector[1] ? vector[411:396] : ~vector[411:396]),
        .in_attribute_12(vector[1] ? vector[427:412] : ~vector[427:412]),
        .in_cardinal_0(vector[1] ? vector[443:428] : ~vector[443:428]),
        .near_plane(vector[1299:1276]),
        .filter_radius(vector[1323:1300]),
        .depth_a(vector[1203:1180]),
        .depth_b(vector[1227:1204]),
        .epsilon_scale(vector[1251:1228]),
        .epsilon_bias(vector[1275:1252]),
        .scale_x(vector[1107:1084]),
        .origin_x(vector[1155:1132]),
        .scale_y(vector[1131:1108]),
        .origin_y(vector[1179:1156]),
        .out_valid(found[444]),
        .out_ready(vector[445]),
        .out_end(found[446]),
        .out_center_x(found[470:447]),
        .out_center_y(found[494:471]),
        .out_ax(found[518:495]),
        .out_bx(found[542:519]),
        .out_ay(found[566:543]),
        .out_by(found[590:567]),
        .out_delta(found[614:591]),
        .out_mx(found[638:615]),
        .out_my(found[662:639]),
        .out_sight_negative(found[663]),
        .out_sight_near(found[686:664]),
        .out_sight_far(found[709:687]),
        .out_sight_turned(found[710]),
        .out_sight_disc(found[711]),
        .out_depth(found[735:712]),
        .out_depth_low(found[759:736]),
        .out_depth_high(found[783:760]),
        .out_attribute_0(found[799:784]),
        .out_attribute_1(found[815:800]),
        .out_attribute_2(found[831:816]),
        .out_attribute_3(found[847:832]),
        .out_attribute_4(found[863:848]),
        .out_attribute_5(found[879:864]),
        .out_attribute_6(found[895:880]),
        .out_attribute_7(found[911:896]),
        .out_attribute_8(found[927:912]),
        .out_attribute_9(found[943:928]),
        .out_attribute_10(found[959:944]),
        .out_attribute_11(found[975:960]),
        .out_attribute_12(found[991:976]),
        .out_cardinal_0(found[1007:992]),
        .out_left(found[1016:1008]),
        .out_right(found[1025:1017]),
        .out_top(found[1034:1026]),
        .out_bottom(found[1043:1035]),
        .out_first_sum(found[1053:1044]),
        .out_last_sum(found[1063:1054]),
        .out_first_difference(found[1073:1064]),
        .out_last_difference(found[1083:1074])
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
            if (changed[0]) begin take(0, 1); take(1, 1); take(2, 1); take(444, 1); take(445, 1); end
            if (changed[1]) begin take(1084, 24); take(1108, 24); take(1132, 24); take(1156, 24); take(1180, 24); take(1204, 24); take(1228, 24); take(1252, 24); take(1276, 24); take(1300, 24); end
            if (changed[2]) begin take(3, 1); take(4, 24); take(28, 24); take(52, 24); take(76, 24); take(100, 24); take(124, 24); take(148, 24); take(172, 24); take(196, 24); take(220, 16); take(236, 16); take(252, 16); take(268, 16); take(284, 16); take(300, 16); take(316, 16); take(332, 16); take(348, 16); take(364, 16); take(380, 16); take(396, 16); take(412, 16); take(428, 16); end
            if (changed[3]) begin take(446, 1); take(447, 24); take(471, 24); take(495, 24); take(519, 24); take(543, 24); take(567, 24); take(591, 24); take(615, 24); take(639, 24); take(663, 1); take(664, 23); take(687, 23); take(710, 1); take(711, 1); take(712, 24); take(736, 24); take(760, 24); take(784, 16); take(800, 16); take(816, 16); take(832, 16); take(848, 16); take(864, 16); take(880, 16); take(896, 16); take(912, 16); take(928, 16); take(944, 16); take(960, 16); take(976, 16); take(992, 16); take(1008, 9); take(1017, 9); take(1026, 9); take(1035, 9); take(1044, 10); take(1054, 10); take(1064, 10); take(1074, 10); end
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
        for (cycle = 0; cycle < 66267 && differences == 0; cycle = cycle + 1) begin
            advance;
            #4;
            if (found[2] !== vector[2]) differ("in_ready");
            if (found[444] !== vector[444]) differ("out_valid");
            if (vector[444] && found[446] !== vector[446]) differ("out_end");
            if (vector[444] && !vector[446] && found[470:447] !== vector[470:447]) differ("out_center_x");
            if (vector[444] && !vector[446] && found[494:471] !== vector[494:471]) differ("out_center_y");
            if (vector[444] && !vector[446] && found[518:495] !== vector[518:495]) differ("out_ax");
            if (vector[444] && !vector[446] && found[542:519] !== vector[542:519]) differ("out_bx");
            if (vector[444] && !vector[446] && found[566:543] !== vector[566:543]) differ("out_ay");
            if (vector[444] && !vector[446] && found[590:567] !== vector[590:567]) differ("out_by");
            if (vector[444] && !vector[446] && found[614:591] !== vector[614:591]) differ("out_delta");
            if (vector[444] && !vector[446] && found[638:615] !== vector[638:615]) differ("out_mx");
            if (vector[444] && !vector[446] && found[662:639] !== vector[662:639]) differ("out_my");
            if (vector[444] && !vector[446] && found[663] !== vector[663]) differ("out_sight_negative");
            if (vector[444] && !vector[446] && found[686:664] !== vector[686:664]) differ("out_sight_near");
            if (vector[444] && !vector[446] && found[709:687] !== vector[709:687]) differ("out_sight_far");
            if (vector[444] && !vector[446] && found[710] !== vector[710]) differ("out_sight_turned");
            if (vector[444] && !vector[446] && found[711] !== vector[711]) differ("out_sight_disc");
            if (vector[444] && !vector[446] && found[735:712] !== vector[735:712]) differ("out_depth");
            if (vector[444] && !vector[446] && found[759:736] !== vector[759:736]) differ("out_depth_low");
            if (vector[444] && !vector[446] && found[783:760] !== vector[783:760]) differ("out_depth_high");
            if (vector[444] && !vector[446] && found[799:784] !== vector[799:784]) differ("out_attribute_0");
            if (vector[444] && !vector[446] && found[815:800] !== vector[815:800]) differ("out_attribute_1");
            if (vector[444] && !vector[446] && found[831:816] !== vector[831:816]) differ("out_attribute_2");
            if (vector[444] && !vector[446] && found[847:832] !== vector[847:832]) differ("out_attribute_3");
            if (vector[444] && !vector[446] && found[863:848] !== vector[863:848]) differ("out_attribute_4");
            if (vector[444] && !vector[446] && found[879:864] !== vector[879:864]) differ("out_attribute_5");
            if (vector[444] && !vector[446] && found[895:880] !== vector[895:880]) differ("out_attribute_6");
            if (vector[444] && !vector[446] && found[911:896] !== vector[911:896]) differ("out_attribute_7");
            if (vector[444] && !vector[446] && found[927:912] !== vector[927:912]) differ("out_attribute_8");
            if (vector[444] && !vector[446] && found[943:928] !== vector[943:928]) differ("out_attribute_9");
            if (vector[444] && !vector[446] && found[959:944] !== vector[959:944]) differ("out_attribute_10");
            if (vector[444] && !vector[446] && found[975:960] !== vector[975:960]) differ("out_attribute_11");
            if (vector[444] && !vector[446] && found[991:976] !== vector[991:976]) differ("out_attribute_12");
            if (vector[444] && !vector[446] && found[1007:992] !== vector[1007:992]) differ("out_cardinal_0");
            if (vector[444] && !vector[446] && found[1016:1008] !== vector[1016:1008]) differ("out_left");
            if (vector[444] && !vector[446] && found[1025:1017] !== vector[1025:1017]) differ("out_right");
            if (vector[444] && !vector[446] && found[1034:1026] !== vector[1034:1026]) differ("out_top");
            if (vector[444] && !vector[446] && found[1043:1035] !== vector[1043:1035]) differ("out_bottom");
            if (vector[444] && !vector[446] && found[1053:1044] !== vector[1053:1044]) differ("out_first_sum");
            if (vector[444] && !vector[446] && found[1063:1054] !== vector[1063:1054]) differ("out_last_sum");
            if (vector[444] && !vector[446] && found[1073:1064] !== vector[1073:1064]) differ("out_first_difference");
            if (vector[444] && !vector[446] && found[1083:1074] !== vector[1083:1074]) differ("out_last_difference");
            @(negedge clk);
        end
        if (differences != 0) $fatal(1, "FAILED");
        $display("splat_setup: 66267 cycles, 2046 items, every output as the model's");
        passed = 1'b1;
    end
endmodule

// 2647 cycles of splat_operators, which 2622 items leave.
module splat_operators_replay(output reg passed = 1'b0);
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [63:0] words [0:19210];
    reg [534:0] vector = 0;
    reg [534:0] next = 0;
    wire [534:0] found;
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
        .a(vector[25:2]),
        .b(vector[49:26]),
        .c(vector[73:50]),
        .results_valid(found[74]),
        .results_mul_0(found[98:75]),
        .results_add_1(found[122:99]),
        .results_lt_2(found[123]),
        .results_max_3(found[147:124]),
        .results_recip_4(found[171:148]),
        .results_mul_5(found[195:172]),
        .results_sqrt_6(found[219:196]),
        .results_le_7(found[220]),
        .results_min_8(found[244:221]),
        .results_to_fixed_u21q8_9(found[265:245]),
        .results_to_fixed_u23q8_10(found[288:266]),
        .results_to_fixed_s22q8_11(found[310:289]),
        .results_to_fixed_u24q24_12(found[334:311]),
        .results_from_fixed_u10q1_13(found[358:335]),
        .results_div_14(found[382:359]),
        .results_to_fixed_u16q16_15(found[398:383]),
        .results_from_fixed_u16q16_16(found[414:399]),
        .results_mul_17(found[430:415]),
        .results_add_18(found[446:431]),
        .results_from_fixed_u28q16_19(found[470:447]),
        .results_from_fixed_u52q40_20(found[494:471]),
        .results_convert_f24_ftz_21(found[518:495]),
        .results_convert_f16_22(found[534:519])
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
            if (changed[0]) begin take(0, 1); take(1, 1); take(74, 1); end
            if (changed[1]) begin take(2, 24); take(26, 24); take(50, 24); end
            if (changed[2]) begin take(75, 24); take(99, 24); take(123, 1); take(124, 24); take(148, 24); take(172, 24); take(196, 24); take(220, 1); take(221, 24); take(245, 21); take(266, 23); take(289, 22); take(311, 24); take(335, 24); take(359, 24); take(383, 16); take(399, 16); take(415, 16); take(431, 16); take(447, 24); take(471, 24); take(495, 24); take(519, 16); end
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
        for (cycle = 0; cycle < 2647 && differences == 0; cycle = cycle + 1) begin
            advance;
            #4;
            if (found[74] !== vector[74]) differ("results_valid");
            if (vector[74] && found[98:75] !== vector[98:75]) differ("results_mul_0");
            if (vector[74] && found[122:99] !== vector[122:99]) differ("results_add_1");
            if (vector[74] && found[123] !== vector[123]) differ("results_lt_2");
            if (vector[74] && found[147:124] !== vector[147:124]) differ("results_max_3");
            if (vector[74] && found[171:148] !== vector[171:148]) differ("results_recip_4");
            if (vector[74] && found[195:172] !== vector[195:172]) differ("results_mul_5");
            if (vector[74] && found[219:196] !== vector[219:196]) differ("results_sqrt_6");
            if (vector[74] && found[220] !== vector[220]) differ("results_le_7");
            if (vector[74] && found[244:221] !== vector[244:221]) differ("results_min_8");
            if (vector[74] && found[265:245] !== vector[265:245]) differ("results_to_fixed_u21q8_9");
            if (vector[74] && found[288:266] !== vector[288:266]) differ("results_to_fixed_u23q8_10");
            if (vector[74] && found[310:289] !== vector[310:289]) differ("results_to_fixed_s22q8_11");
            if (vector[74] && found[334:311] !== vector[334:311]) differ("results_to_fixed_u24q24_12");
            if (vector[74] && found[358:335] !== vector[358:335]) differ("results_from_fixed_u10q1_13");
            if (vector[74] && found[382:359] !== vector[382:359]) differ("results_div_14");
            if (vector[74] && found[398:383] !== vector[398:383]) differ("results_to_fixed_u16q16_15");
            if (vector[74] && found[414:399] !== vector[414:399]) differ("results_from_fixed_u16q16_16");
            if (vector[74] && found[430:415] !== vector[430:415]) differ("results_mul_17");
            if (vector[74] && found[446:431] !== vector[446:431]) differ("results_add_18");
            if (vector[74] && found[470:447] !== vector[470:447]) differ("results_from_fixed_u28q16_19");
            if (vector[74] && found[494:471] !== vector[494:471]) differ("results_from_fixed_u52q40_20");
            if (vector[74] && found[518:495] !== vector[518:495]) differ("results_convert_f24_ftz_21");
            if (vector[74] && found[534:519] !== vector[534:519]) differ("results_convert_f16_22");
            @(negedge clk);
        end
        if (differences != 0) $fatal(1, "FAILED");
        $display("splat_operators: 2647 cycles, 2622 items, every output as the model's");
        passed = 1'b1;
    end
endmodule

// The floating-point operators of a core side by side.
module splat_operators (
    input  wire clk, input wire rst, input wire enable, input wire [23:0] a, input wire [23:0] b,
    input  wire [23:0] c,
    output wire results_valid, output wire [23:0] results_mul_0, output wire [23:0] results_add_1,
    output wire results_lt_2, output wire [23:0] results_max_3, output wire [23:0] results_recip_4,
    output wire [23:0] results_mul_5, output wire [23:0] results_sqrt_6, output wire results_le_7,
    output wire [23:0] results_min_8, output wire [20:0] results_to_fixed_u21q8_9,
    output wire [22:0] results_to_fixed_u23q8_10, output wire [21:0] results_to_fixed_s22q8_11,
    output wire [23:0] results_to_fixed_u24q24_12, output wire [23:0] results_from_fixed_u10q1_13,
    output wire [23:0] results_div_14, output wire [15:0] results_to_fixed_u16q16_15,
    output wire [15:0] results_from_fixed_u16q16_16, output wire [15:0] results_mul_17,
    output wire [15:0] results_add_18, output wire [23:0] results_from_fixed_u28q16_19,
    output wire [23:0] results_from_fixed_u52q40_20, output wire [23:0] results_convert_f24_ftz_21,
    output wire [15:0] results_convert_f16_22
);
    reg [4:0] taken;

    wire valid = taken == 5'd20;

    assign results_valid = valid;

    float_mul_s4_f24ftz mul_0 (.clk(clk), .enable(enable), .a(a), .b(b), .y(results_mul_0));
    float_add_s6_f24ftz add_1 (.clk(clk), .enable(enable), .a(a), .b(b), .y(results_add_1));
    float_lt_s2_f24ftz lt_2 (.clk(clk), .enable(enable), .a(a), .b(b), .y(results_lt_2));
    float_max_s2_f24ftz max_3 (.clk(clk), .enable(enable), .a(a), .b(b), .y(results_max_3));
    float_recip_s20_f24ftz recip_4 (.clk(clk), .enable(enable), .a(a), .y(results_recip_4));
    float_mul_s5_f24ftz mul_5 (.clk(clk), .enable(enable), .a(a), .b(b), .y(results_mul_5));
    float_sqrt_s18_f24ftz sqrt_6 (.clk(clk), .enable(enable), .a(a), .y(results_sqrt_6));
    float_le_s2_f24ftz le_7 (.clk(clk), .enable(enable), .a(a), .b(b), .y(results_le_7));
    float_min_s2_f24ftz min_8 (.clk(clk), .enable(enable), .a(a), .b(b), .y(results_min_8));
    float_to_fixed_s3_f24ftz_w21_f8_unsigned to_fixed_u21q8_9 (.clk(clk), .enable(enable), .a(a), .y(results_to_fixed_u21q8_9));
    float_to_fixed_s3_f24ftz_w23_f8_unsigned to_fixed_u23q8_10 (.clk(clk), .enable(enable), .a(a), .y(results_to_fixed_u23q8_10));
    float_to_fixed_s3_f24ftz_w22_f8_signed to_fixed_s22q8_11 (.clk(clk), .enable(enable), .a(a), .y(results_to_fixed_s22q8_11));
    float_to_fixed_s3_f24ftz_w24_f24_unsigned to_fixed_u24q24_12 (.clk(clk), .enable(enable), .a(a), .y(results_to_fixed_u24q24_12));
    float_from_fixed_s3_f24ftz_w10_f1_unsigned from_fixed_u10q1_13 (.clk(clk), .enable(enable), .a(a[9:0]), .y(results_from_fixed_u10q1_13));
    float_div_s20_f24ftz div_14 (.clk(clk), .enable(enable), .a(a), .b(b), .y(results_div_14));
    float_to_fixed_s3_f24ftz_w16_f16_unsigned to_fixed_u16q16_15 (.clk(clk), .enable(enable), .a(a), .y(results_to_fixed_u16q16_15));

    float_from_fixed_s4_f16_w16_f16_unsigned from_fixed_u16q16_16 (
        .clk(clk), .enable(enable), .a(a[15:0]), .y(results_from_fixed_u16q16_16)
    );

    float_mul_s6_f16 mul_17 (.clk(clk), .enable(enable), .a(a[15:0]), .b(b[15:0]), .y(results_mul_17));
    float_add_s5_f16 add_18 (.clk(clk), .enable(enable), .a(a[15:0]), .b(b[15:0]), .y(results_add_18));

    float_from_fixed_s3_f24ftz_w28_f16_unsigned from_fixed_u28q16_19 (
        .clk(clk), .enable(enable), .a({b[3:0], a}), .y(results_from_fixed_u28q16_19)
    );

    float_from_fixed_s3_f24ftz_w52_f40_unsigned from_fixed_u52q40_20 (
        .clk(clk), .enable(enable), .a({c[3:0], b, a}), .y(results_from_fixed_u52q40_20)
    );

    float_convert_s3_f16_f24ftz convert_f24_ftz_21 (.clk(clk), .enable(enable), .a(a[15:0]), .y(results_convert_f24_ftz_21));
    float_convert_s3_f24ftz_f16 convert_f16_22 (.clk(clk), .enable(enable), .a(a), .y(results_convert_f16_22));

    always @(posedge clk) begin
        if (rst) taken <= 5'd0;
        else taken <= (enable & ~valid) ? (taken + 5'd1) : taken;
    end

    wire _unused = &{1'b0, c[23:4]};
endmodule
