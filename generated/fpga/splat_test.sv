// Written by pointcore 0.1.0; do not edit.
// Replays 260912 cycles of the bit-exact model at the ports of splat_top, in which 23252 items leave the core, and compares every output in every
// cycle; a stream's fields count while it is valid, and those that go in are spoilt while it is not. For Verilator, whose registers start at
// random values: in a simulator with unknown values, what is not reset stays unknown longer than in hardware.
//
// splat_test.hex is a sequence of bits: in every cycle one, whether anything changes, and if so one for each group of ports, whether it does,
// then the words of those that do.

module splat_test;
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [63:0] words [0:233869];
    reg [1525:0] vector = 0;
    reg [1525:0] next = 0;
    wire [1525:0] found;
    reg changes;
    reg [6:0] changed;
    integer place = 0;
    integer i;
    integer cycle;
    integer differences = 0;

    splat_top core (
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
            $display("cycle %0d: %0s differs from the model", cycle, port);
        end
    endtask

    initial begin
        $readmemh("splat_test.hex", words);
        repeat (1) @(negedge clk);
        rst = 1'b0;
        for (cycle = 0; cycle < 260912 && differences == 0; cycle = cycle + 1) begin
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
        $display("PASSED: 260912 cycles, 23252 items, every output as the model's");
        $finish;
    end
endmodule
