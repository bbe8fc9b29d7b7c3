// Written by pointcore 0.1.0; do not edit.
// Replays 149701 cycles of the bit-exact model at the ports of splat_top, in which 11645 items leave the core, and compares every output in every
// cycle; a stream's fields count while it is valid, and those that go in are spoilt while it is not. For Verilator, whose registers start at
// random values: in a simulator with unknown values, what is not reset stays unknown longer than in hardware.
//
// splat_test.hex is a sequence of bits: in every cycle one, whether anything changes, and if so one for each group of ports, whether it does,
// then the words of those that do.

module splat_test;
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [63:0] words [0:112392];
    reg [1524:0] vector = 0;
    reg [1524:0] next = 0;
    wire [1524:0] found;
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
        .read_valid(found[554]),
        .read_ready(vector[555]),
        .read_surface(found[556]),
        .read_tile(found[568:557]),
        .read_pixel(found[574:569]),
        .read_count(found[578:575]),
        .data_valid(vector[579]),
        .data_ready(found[580]),
        .data_weight(vector[579] ? vector[608:581] : ~vector[608:581]),
        .data_depth(vector[579] ? vector[660:609] : ~vector[660:609]),
        .data_peak(vector[579] ? vector[676:661] : ~vector[676:661]),
        .data_attribute_0(vector[579] ? vector[692:677] : ~vector[692:677]),
        .data_attribute_1(vector[579] ? vector[708:693] : ~vector[708:693]),
        .data_attribute_2(vector[579] ? vector[724:709] : ~vector[724:709]),
        .data_attribute_3(vector[579] ? vector[740:725] : ~vector[740:725]),
        .data_attribute_4(vector[579] ? vector[756:741] : ~vector[756:741]),
        .data_attribute_5(vector[579] ? vector[772:757] : ~vector[772:757]),
        .data_attribute_6(vector[579] ? vector[788:773] : ~vector[788:773]),
        .data_attribute_7(vector[579] ? vector[804:789] : ~vector[804:789]),
        .data_attribute_8(vector[579] ? vector[820:805] : ~vector[820:805]),
        .data_attribute_9(vector[579] ? vector[836:821] : ~vector[836:821]),
        .data_attribute_10(vector[579] ? vector[852:837] : ~vector[852:837]),
        .data_attribute_11(vector[579] ? vector[868:853] : ~vector[868:853]),
        .data_attribute_12(vector[579] ? vector[884:869] : ~vector[884:869]),
        .data_cardinal_0(vector[579] ? vector[900:885] : ~vector[900:885]),
        .write_valid(found[901]),
        .write_ready(vector[902]),
        .write_surface(found[903]),
        .write_tile(found[915:904]),
        .write_pixel(found[921:916]),
        .write_weight(found[949:922]),
        .write_depth(found[1001:950]),
        .write_peak(found[1017:1002]),
        .write_attribute_0(found[1033:1018]),
        .write_attribute_1(found[1049:1034]),
        .write_attribute_2(found[1065:1050]),
        .write_attribute_3(found[1081:1066]),
        .write_attribute_4(found[1097:1082]),
        .write_attribute_5(found[1113:1098]),
        .write_attribute_6(found[1129:1114]),
        .write_attribute_7(found[1145:1130]),
        .write_attribute_8(found[1161:1146]),
        .write_attribute_9(found[1177:1162]),
        .write_attribute_10(found[1193:1178]),
        .write_attribute_11(found[1209:1194]),
        .write_attribute_12(found[1225:1210]),
        .write_cardinal_0(found[1241:1226]),
        .fragment_valid(found[1242]),
        .fragment_ready(vector[1243]),
        .fragment_end(found[1244]),
        .fragment_column(found[1253:1245]),
        .fragment_row(found[1262:1254]),
        .fragment_depth(found[1294:1263]),
        .fragment_attribute_0(found[1310:1295]),
        .fragment_attribute_1(found[1326:1311]),
        .fragment_attribute_2(found[1342:1327]),
        .fragment_attribute_3(found[1358:1343]),
        .fragment_attribute_4(found[1374:1359]),
        .fragment_attribute_5(found[1390:1375]),
        .fragment_attribute_6(found[1406:1391]),
        .fragment_attribute_7(found[1422:1407]),
        .fragment_attribute_8(found[1438:1423]),
        .fragment_attribute_9(found[1454:1439]),
        .fragment_attribute_10(found[1470:1455]),
        .fragment_attribute_11(found[1486:1471]),
        .fragment_attribute_12(found[1502:1487]),
        .fragment_cardinal_0(found[1518:1503]),
        .event_sample(found[1519]),
        .event_starved(found[1520]),
        .event_blocked(found[1521]),
        .event_accumulate(found[1522]),
        .event_hazard(found[1523]),
        .event_slot_wait(found[1524])
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
            if (changed[0]) begin take(0, 1); take(1, 1); take(39, 1); take(40, 1); take(554, 1); take(555, 1); take(579, 1); take(580, 1); take(901, 1); take(902, 1); take(1242, 1); take(1243, 1); take(1519, 1); take(1520, 1); take(1521, 1); take(1522, 1); take(1523, 1); take(1524, 1); end
            if (changed[1]) begin take(2, 5); take(7, 32); end
            if (changed[2]) begin take(41, 1); take(42, 32); take(74, 32); take(106, 32); take(138, 32); take(170, 32); take(202, 32); take(234, 32); take(266, 32); take(298, 32); take(330, 16); take(346, 16); take(362, 16); take(378, 16); take(394, 16); take(410, 16); take(426, 16); take(442, 16); take(458, 16); take(474, 16); take(490, 16); take(506, 16); take(522, 16); take(538, 16); end
            if (changed[3]) begin take(556, 1); take(557, 12); take(569, 6); take(575, 4); end
            if (changed[4]) begin take(581, 28); take(609, 52); take(661, 16); take(677, 16); take(693, 16); take(709, 16); take(725, 16); take(741, 16); take(757, 16); take(773, 16); take(789, 16); take(805, 16); take(821, 16); take(837, 16); take(853, 16); take(869, 16); take(885, 16); end
            if (changed[5]) begin take(903, 1); take(904, 12); take(916, 6); take(922, 28); take(950, 52); take(1002, 16); take(1018, 16); take(1034, 16); take(1050, 16); take(1066, 16); take(1082, 16); take(1098, 16); take(1114, 16); take(1130, 16); take(1146, 16); take(1162, 16); take(1178, 16); take(1194, 16); take(1210, 16); take(1226, 16); end
            if (changed[6]) begin take(1244, 1); take(1245, 9); take(1254, 9); take(1263, 32); take(1295, 16); take(1311, 16); take(1327, 16); take(1343, 16); take(1359, 16); take(1375, 16); take(1391, 16); take(1407, 16); take(1423, 16); take(1439, 16); take(1455, 16); take(1471, 16); take(1487, 16); take(1503, 16); end
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
        repeat (2) @(negedge clk);
        rst = 1'b0;
        for (cycle = 0; cycle < 149701 && differences == 0; cycle = cycle + 1) begin
            advance;
            #4;
            if (found[40] !== vector[40]) differ("splat_ready");
            if (found[554] !== vector[554]) differ("read_valid");
            if (vector[554] && found[556] !== vector[556]) differ("read_surface");
            if (vector[554] && found[568:557] !== vector[568:557]) differ("read_tile");
            if (vector[554] && found[574:569] !== vector[574:569]) differ("read_pixel");
            if (vector[554] && found[578:575] !== vector[578:575]) differ("read_count");
            if (found[580] !== vector[580]) differ("data_ready");
            if (found[901] !== vector[901]) differ("write_valid");
            if (vector[901] && found[903] !== vector[903]) differ("write_surface");
            if (vector[901] && found[915:904] !== vector[915:904]) differ("write_tile");
            if (vector[901] && found[921:916] !== vector[921:916]) differ("write_pixel");
            if (vector[901] && found[949:922] !== vector[949:922]) differ("write_weight");
            if (vector[901] && found[1001:950] !== vector[1001:950]) differ("write_depth");
            if (vector[901] && found[1017:1002] !== vector[1017:1002]) differ("write_peak");
            if (vector[901] && found[1033:1018] !== vector[1033:1018]) differ("write_attribute_0");
            if (vector[901] && found[1049:1034] !== vector[1049:1034]) differ("write_attribute_1");
            if (vector[901] && found[1065:1050] !== vector[1065:1050]) differ("write_attribute_2");
            if (vector[901] && found[1081:1066] !== vector[1081:1066]) differ("write_attribute_3");
            if (vector[901] && found[1097:1082] !== vector[1097:1082]) differ("write_attribute_4");
            if (vector[901] && found[1113:1098] !== vector[1113:1098]) differ("write_attribute_5");
            if (vector[901] && found[1129:1114] !== vector[1129:1114]) differ("write_attribute_6");
            if (vector[901] && found[1145:1130] !== vector[1145:1130]) differ("write_attribute_7");
            if (vector[901] && found[1161:1146] !== vector[1161:1146]) differ("write_attribute_8");
            if (vector[901] && found[1177:1162] !== vector[1177:1162]) differ("write_attribute_9");
            if (vector[901] && found[1193:1178] !== vector[1193:1178]) differ("write_attribute_10");
            if (vector[901] && found[1209:1194] !== vector[1209:1194]) differ("write_attribute_11");
            if (vector[901] && found[1225:1210] !== vector[1225:1210]) differ("write_attribute_12");
            if (vector[901] && found[1241:1226] !== vector[1241:1226]) differ("write_cardinal_0");
            if (found[1242] !== vector[1242]) differ("fragment_valid");
            if (vector[1242] && found[1244] !== vector[1244]) differ("fragment_end");
            if (vector[1242] && !vector[1244] && found[1253:1245] !== vector[1253:1245]) differ("fragment_column");
            if (vector[1242] && !vector[1244] && found[1262:1254] !== vector[1262:1254]) differ("fragment_row");
            if (vector[1242] && !vector[1244] && found[1294:1263] !== vector[1294:1263]) differ("fragment_depth");
            if (vector[1242] && !vector[1244] && found[1310:1295] !== vector[1310:1295]) differ("fragment_attribute_0");
            if (vector[1242] && !vector[1244] && found[1326:1311] !== vector[1326:1311]) differ("fragment_attribute_1");
            if (vector[1242] && !vector[1244] && found[1342:1327] !== vector[1342:1327]) differ("fragment_attribute_2");
            if (vector[1242] && !vector[1244] && found[1358:1343] !== vector[1358:1343]) differ("fragment_attribute_3");
            if (vector[1242] && !vector[1244] && found[1374:1359] !== vector[1374:1359]) differ("fragment_attribute_4");
            if (vector[1242] && !vector[1244] && found[1390:1375] !== vector[1390:1375]) differ("fragment_attribute_5");
            if (vector[1242] && !vector[1244] && found[1406:1391] !== vector[1406:1391]) differ("fragment_attribute_6");
            if (vector[1242] && !vector[1244] && found[1422:1407] !== vector[1422:1407]) differ("fragment_attribute_7");
            if (vector[1242] && !vector[1244] && found[1438:1423] !== vector[1438:1423]) differ("fragment_attribute_8");
            if (vector[1242] && !vector[1244] && found[1454:1439] !== vector[1454:1439]) differ("fragment_attribute_9");
            if (vector[1242] && !vector[1244] && found[1470:1455] !== vector[1470:1455]) differ("fragment_attribute_10");
            if (vector[1242] && !vector[1244] && found[1486:1471] !== vector[1486:1471]) differ("fragment_attribute_11");
            if (vector[1242] && !vector[1244] && found[1502:1487] !== vector[1502:1487]) differ("fragment_attribute_12");
            if (vector[1242] && !vector[1244] && found[1518:1503] !== vector[1518:1503]) differ("fragment_cardinal_0");
            if (found[1519] !== vector[1519]) differ("event_sample");
            if (found[1520] !== vector[1520]) differ("event_starved");
            if (found[1521] !== vector[1521]) differ("event_blocked");
            if (found[1522] !== vector[1522]) differ("event_accumulate");
            if (found[1523] !== vector[1523]) differ("event_hazard");
            if (found[1524] !== vector[1524]) differ("event_slot_wait");
            @(negedge clk);
        end
        if (differences != 0) $fatal(1, "FAILED");
        $display("PASSED: 149701 cycles, 11645 items, every output as the model's");
        $finish;
    end
endmodule
