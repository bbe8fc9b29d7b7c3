// Written by pointcore 0.1.0; do not edit.
// Replays 138728 cycles of the bit-exact model at the ports of splat_top, in which 16042 items leave the core, and compares every output in every
// cycle; a stream's fields count while it is valid, and those that go in are spoilt while it is not. For Verilator, whose registers start at
// random values: in a simulator with unknown values, what is not reset stays unknown longer than in hardware.
//
// splat_test.hex is a sequence of bits: in every cycle one, whether anything changes, and if so one for each group of ports, whether it does,
// then the words of those that do.

module splat_test;
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [63:0] words [0:144412];
    reg [1512:0] vector = 0;
    reg [1512:0] next = 0;
    wire [1512:0] found;
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
        .read_tile(found[567:556]),
        .data_valid(vector[568]),
        .data_ready(found[569]),
        .data_weight(vector[568] ? vector[597:570] : ~vector[597:570]),
        .data_depth(vector[568] ? vector[649:598] : ~vector[649:598]),
        .data_peak(vector[568] ? vector[665:650] : ~vector[665:650]),
        .data_attribute_0(vector[568] ? vector[681:666] : ~vector[681:666]),
        .data_attribute_1(vector[568] ? vector[697:682] : ~vector[697:682]),
        .data_attribute_2(vector[568] ? vector[713:698] : ~vector[713:698]),
        .data_attribute_3(vector[568] ? vector[729:714] : ~vector[729:714]),
        .data_attribute_4(vector[568] ? vector[745:730] : ~vector[745:730]),
        .data_attribute_5(vector[568] ? vector[761:746] : ~vector[761:746]),
        .data_attribute_6(vector[568] ? vector[777:762] : ~vector[777:762]),
        .data_attribute_7(vector[568] ? vector[793:778] : ~vector[793:778]),
        .data_attribute_8(vector[568] ? vector[809:794] : ~vector[809:794]),
        .data_attribute_9(vector[568] ? vector[825:810] : ~vector[825:810]),
        .data_attribute_10(vector[568] ? vector[841:826] : ~vector[841:826]),
        .data_attribute_11(vector[568] ? vector[857:842] : ~vector[857:842]),
        .data_attribute_12(vector[568] ? vector[873:858] : ~vector[873:858]),
        .data_cardinal_0(vector[568] ? vector[889:874] : ~vector[889:874]),
        .write_valid(found[890]),
        .write_ready(vector[891]),
        .write_tile(found[903:892]),
        .write_pixel(found[909:904]),
        .write_weight(found[937:910]),
        .write_depth(found[989:938]),
        .write_peak(found[1005:990]),
        .write_attribute_0(found[1021:1006]),
        .write_attribute_1(found[1037:1022]),
        .write_attribute_2(found[1053:1038]),
        .write_attribute_3(found[1069:1054]),
        .write_attribute_4(found[1085:1070]),
        .write_attribute_5(found[1101:1086]),
        .write_attribute_6(found[1117:1102]),
        .write_attribute_7(found[1133:1118]),
        .write_attribute_8(found[1149:1134]),
        .write_attribute_9(found[1165:1150]),
        .write_attribute_10(found[1181:1166]),
        .write_attribute_11(found[1197:1182]),
        .write_attribute_12(found[1213:1198]),
        .write_cardinal_0(found[1229:1214]),
        .fragment_valid(found[1230]),
        .fragment_ready(vector[1231]),
        .fragment_end(found[1232]),
        .fragment_column(found[1241:1233]),
        .fragment_row(found[1250:1242]),
        .fragment_depth(found[1282:1251]),
        .fragment_attribute_0(found[1298:1283]),
        .fragment_attribute_1(found[1314:1299]),
        .fragment_attribute_2(found[1330:1315]),
        .fragment_attribute_3(found[1346:1331]),
        .fragment_attribute_4(found[1362:1347]),
        .fragment_attribute_5(found[1378:1363]),
        .fragment_attribute_6(found[1394:1379]),
        .fragment_attribute_7(found[1410:1395]),
        .fragment_attribute_8(found[1426:1411]),
        .fragment_attribute_9(found[1442:1427]),
        .fragment_attribute_10(found[1458:1443]),
        .fragment_attribute_11(found[1474:1459]),
        .fragment_attribute_12(found[1490:1475]),
        .fragment_cardinal_0(found[1506:1491]),
        .event_sample(found[1507]),
        .event_starved(found[1508]),
        .event_blocked(found[1509]),
        .event_accumulate(found[1510]),
        .event_hazard(found[1511]),
        .event_slot_wait(found[1512])
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
            if (changed[0]) begin take(0, 1); take(1, 1); take(39, 1); take(40, 1); take(554, 1); take(555, 1); take(568, 1); take(569, 1); take(890, 1); take(891, 1); take(1230, 1); take(1231, 1); take(1507, 1); take(1508, 1); take(1509, 1); take(1510, 1); take(1511, 1); take(1512, 1); end
            if (changed[1]) begin take(2, 5); take(7, 32); end
            if (changed[2]) begin take(41, 1); take(42, 32); take(74, 32); take(106, 32); take(138, 32); take(170, 32); take(202, 32); take(234, 32); take(266, 32); take(298, 32); take(330, 16); take(346, 16); take(362, 16); take(378, 16); take(394, 16); take(410, 16); take(426, 16); take(442, 16); take(458, 16); take(474, 16); take(490, 16); take(506, 16); take(522, 16); take(538, 16); end
            if (changed[3]) begin take(556, 12); end
            if (changed[4]) begin take(570, 28); take(598, 52); take(650, 16); take(666, 16); take(682, 16); take(698, 16); take(714, 16); take(730, 16); take(746, 16); take(762, 16); take(778, 16); take(794, 16); take(810, 16); take(826, 16); take(842, 16); take(858, 16); take(874, 16); end
            if (changed[5]) begin take(892, 12); take(904, 6); take(910, 28); take(938, 52); take(990, 16); take(1006, 16); take(1022, 16); take(1038, 16); take(1054, 16); take(1070, 16); take(1086, 16); take(1102, 16); take(1118, 16); take(1134, 16); take(1150, 16); take(1166, 16); take(1182, 16); take(1198, 16); take(1214, 16); end
            if (changed[6]) begin take(1232, 1); take(1233, 9); take(1242, 9); take(1251, 32); take(1283, 16); take(1299, 16); take(1315, 16); take(1331, 16); take(1347, 16); take(1363, 16); take(1379, 16); take(1395, 16); take(1411, 16); take(1427, 16); take(1443, 16); take(1459, 16); take(1475, 16); take(1491, 16); end
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
        for (cycle = 0; cycle < 138728 && differences == 0; cycle = cycle + 1) begin
            advance;
            #4;
            if (found[40] !== vector[40]) differ("splat_ready");
            if (found[554] !== vector[554]) differ("read_valid");
            if (vector[554] && found[567:556] !== vector[567:556]) differ("read_tile");
            if (found[569] !== vector[569]) differ("data_ready");
            if (found[890] !== vector[890]) differ("write_valid");
            if (vector[890] && found[903:892] !== vector[903:892]) differ("write_tile");
            if (vector[890] && found[909:904] !== vector[909:904]) differ("write_pixel");
            if (vector[890] && found[937:910] !== vector[937:910]) differ("write_weight");
            if (vector[890] && found[989:938] !== vector[989:938]) differ("write_depth");
            if (vector[890] && found[1005:990] !== vector[1005:990]) differ("write_peak");
            if (vector[890] && found[1021:1006] !== vector[1021:1006]) differ("write_attribute_0");
            if (vector[890] && found[1037:1022] !== vector[1037:1022]) differ("write_attribute_1");
            if (vector[890] && found[1053:1038] !== vector[1053:1038]) differ("write_attribute_2");
            if (vector[890] && found[1069:1054] !== vector[1069:1054]) differ("write_attribute_3");
            if (vector[890] && found[1085:1070] !== vector[1085:1070]) differ("write_attribute_4");
            if (vector[890] && found[1101:1086] !== vector[1101:1086]) differ("write_attribute_5");
            if (vector[890] && found[1117:1102] !== vector[1117:1102]) differ("write_attribute_6");
            if (vector[890] && found[1133:1118] !== vector[1133:1118]) differ("write_attribute_7");
            if (vector[890] && found[1149:1134] !== vector[1149:1134]) differ("write_attribute_8");
            if (vector[890] && found[1165:1150] !== vector[1165:1150]) differ("write_attribute_9");
            if (vector[890] && found[1181:1166] !== vector[1181:1166]) differ("write_attribute_10");
            if (vector[890] && found[1197:1182] !== vector[1197:1182]) differ("write_attribute_11");
            if (vector[890] && found[1213:1198] !== vector[1213:1198]) differ("write_attribute_12");
            if (vector[890] && found[1229:1214] !== vector[1229:1214]) differ("write_cardinal_0");
            if (found[1230] !== vector[1230]) differ("fragment_valid");
            if (vector[1230] && found[1232] !== vector[1232]) differ("fragment_end");
            if (vector[1230] && !vector[1232] && found[1241:1233] !== vector[1241:1233]) differ("fragment_column");
            if (vector[1230] && !vector[1232] && found[1250:1242] !== vector[1250:1242]) differ("fragment_row");
            if (vector[1230] && !vector[1232] && found[1282:1251] !== vector[1282:1251]) differ("fragment_depth");
            if (vector[1230] && !vector[1232] && found[1298:1283] !== vector[1298:1283]) differ("fragment_attribute_0");
            if (vector[1230] && !vector[1232] && found[1314:1299] !== vector[1314:1299]) differ("fragment_attribute_1");
            if (vector[1230] && !vector[1232] && found[1330:1315] !== vector[1330:1315]) differ("fragment_attribute_2");
            if (vector[1230] && !vector[1232] && found[1346:1331] !== vector[1346:1331]) differ("fragment_attribute_3");
            if (vector[1230] && !vector[1232] && found[1362:1347] !== vector[1362:1347]) differ("fragment_attribute_4");
            if (vector[1230] && !vector[1232] && found[1378:1363] !== vector[1378:1363]) differ("fragment_attribute_5");
            if (vector[1230] && !vector[1232] && found[1394:1379] !== vector[1394:1379]) differ("fragment_attribute_6");
            if (vector[1230] && !vector[1232] && found[1410:1395] !== vector[1410:1395]) differ("fragment_attribute_7");
            if (vector[1230] && !vector[1232] && found[1426:1411] !== vector[1426:1411]) differ("fragment_attribute_8");
            if (vector[1230] && !vector[1232] && found[1442:1427] !== vector[1442:1427]) differ("fragment_attribute_9");
            if (vector[1230] && !vector[1232] && found[1458:1443] !== vector[1458:1443]) differ("fragment_attribute_10");
            if (vector[1230] && !vector[1232] && found[1474:1459] !== vector[1474:1459]) differ("fragment_attribute_11");
            if (vector[1230] && !vector[1232] && found[1490:1475] !== vector[1490:1475]) differ("fragment_attribute_12");
            if (vector[1230] && !vector[1232] && found[1506:1491] !== vector[1506:1491]) differ("fragment_cardinal_0");
            if (found[1507] !== vector[1507]) differ("event_sample");
            if (found[1508] !== vector[1508]) differ("event_starved");
            if (found[1509] !== vector[1509]) differ("event_blocked");
            if (found[1510] !== vector[1510]) differ("event_accumulate");
            if (found[1511] !== vector[1511]) differ("event_hazard");
            if (found[1512] !== vector[1512]) differ("event_slot_wait");
            @(negedge clk);
        end
        if (differences != 0) $fatal(1, "FAILED");
        $display("PASSED: 138728 cycles, 16042 items, every output as the model's");
        $finish;
    end
endmodule
