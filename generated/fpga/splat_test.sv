// Written by pointcore 0.1.0; do not edit.
// Replays 121208 cycles of the bit-exact model at the ports of splat_top, in which 10532 items leave the core, and compares every output in every
// cycle; a stream's fields count while it is valid, and those that go in are spoilt while it is not. For Verilator, whose registers start at
// random values: in a simulator with unknown values, what is not reset stays unknown longer than in hardware.
//
// splat_test.hex is a sequence of bits: in every cycle one, whether anything changes, and if so one for each group of ports, whether it does,
// then the words of those that do.

module splat_test;
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [63:0] words [0:107495];
    reg [1522:0] vector = 0;
    reg [1522:0] next = 0;
    wire [1522:0] found;
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
        .read_pixel(found[573:568]),
        .read_count(found[577:574]),
        .data_valid(vector[578]),
        .data_ready(found[579]),
        .data_weight(vector[578] ? vector[607:580] : ~vector[607:580]),
        .data_depth(vector[578] ? vector[659:608] : ~vector[659:608]),
        .data_peak(vector[578] ? vector[675:660] : ~vector[675:660]),
        .data_attribute_0(vector[578] ? vector[691:676] : ~vector[691:676]),
        .data_attribute_1(vector[578] ? vector[707:692] : ~vector[707:692]),
        .data_attribute_2(vector[578] ? vector[723:708] : ~vector[723:708]),
        .data_attribute_3(vector[578] ? vector[739:724] : ~vector[739:724]),
        .data_attribute_4(vector[578] ? vector[755:740] : ~vector[755:740]),
        .data_attribute_5(vector[578] ? vector[771:756] : ~vector[771:756]),
        .data_attribute_6(vector[578] ? vector[787:772] : ~vector[787:772]),
        .data_attribute_7(vector[578] ? vector[803:788] : ~vector[803:788]),
        .data_attribute_8(vector[578] ? vector[819:804] : ~vector[819:804]),
        .data_attribute_9(vector[578] ? vector[835:820] : ~vector[835:820]),
        .data_attribute_10(vector[578] ? vector[851:836] : ~vector[851:836]),
        .data_attribute_11(vector[578] ? vector[867:852] : ~vector[867:852]),
        .data_attribute_12(vector[578] ? vector[883:868] : ~vector[883:868]),
        .data_cardinal_0(vector[578] ? vector[899:884] : ~vector[899:884]),
        .write_valid(found[900]),
        .write_ready(vector[901]),
        .write_tile(found[913:902]),
        .write_pixel(found[919:914]),
        .write_weight(found[947:920]),
        .write_depth(found[999:948]),
        .write_peak(found[1015:1000]),
        .write_attribute_0(found[1031:1016]),
        .write_attribute_1(found[1047:1032]),
        .write_attribute_2(found[1063:1048]),
        .write_attribute_3(found[1079:1064]),
        .write_attribute_4(found[1095:1080]),
        .write_attribute_5(found[1111:1096]),
        .write_attribute_6(found[1127:1112]),
        .write_attribute_7(found[1143:1128]),
        .write_attribute_8(found[1159:1144]),
        .write_attribute_9(found[1175:1160]),
        .write_attribute_10(found[1191:1176]),
        .write_attribute_11(found[1207:1192]),
        .write_attribute_12(found[1223:1208]),
        .write_cardinal_0(found[1239:1224]),
        .fragment_valid(found[1240]),
        .fragment_ready(vector[1241]),
        .fragment_end(found[1242]),
        .fragment_column(found[1251:1243]),
        .fragment_row(found[1260:1252]),
        .fragment_depth(found[1292:1261]),
        .fragment_attribute_0(found[1308:1293]),
        .fragment_attribute_1(found[1324:1309]),
        .fragment_attribute_2(found[1340:1325]),
        .fragment_attribute_3(found[1356:1341]),
        .fragment_attribute_4(found[1372:1357]),
        .fragment_attribute_5(found[1388:1373]),
        .fragment_attribute_6(found[1404:1389]),
        .fragment_attribute_7(found[1420:1405]),
        .fragment_attribute_8(found[1436:1421]),
        .fragment_attribute_9(found[1452:1437]),
        .fragment_attribute_10(found[1468:1453]),
        .fragment_attribute_11(found[1484:1469]),
        .fragment_attribute_12(found[1500:1485]),
        .fragment_cardinal_0(found[1516:1501]),
        .event_sample(found[1517]),
        .event_starved(found[1518]),
        .event_blocked(found[1519]),
        .event_accumulate(found[1520]),
        .event_hazard(found[1521]),
        .event_slot_wait(found[1522])
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
            if (changed[0]) begin take(0, 1); take(1, 1); take(39, 1); take(40, 1); take(554, 1); take(555, 1); take(578, 1); take(579, 1); take(900, 1); take(901, 1); take(1240, 1); take(1241, 1); take(1517, 1); take(1518, 1); take(1519, 1); take(1520, 1); take(1521, 1); take(1522, 1); end
            if (changed[1]) begin take(2, 5); take(7, 32); end
            if (changed[2]) begin take(41, 1); take(42, 32); take(74, 32); take(106, 32); take(138, 32); take(170, 32); take(202, 32); take(234, 32); take(266, 32); take(298, 32); take(330, 16); take(346, 16); take(362, 16); take(378, 16); take(394, 16); take(410, 16); take(426, 16); take(442, 16); take(458, 16); take(474, 16); take(490, 16); take(506, 16); take(522, 16); take(538, 16); end
            if (changed[3]) begin take(556, 12); take(568, 6); take(574, 4); end
            if (changed[4]) begin take(580, 28); take(608, 52); take(660, 16); take(676, 16); take(692, 16); take(708, 16); take(724, 16); take(740, 16); take(756, 16); take(772, 16); take(788, 16); take(804, 16); take(820, 16); take(836, 16); take(852, 16); take(868, 16); take(884, 16); end
            if (changed[5]) begin take(902, 12); take(914, 6); take(920, 28); take(948, 52); take(1000, 16); take(1016, 16); take(1032, 16); take(1048, 16); take(1064, 16); take(1080, 16); take(1096, 16); take(1112, 16); take(1128, 16); take(1144, 16); take(1160, 16); take(1176, 16); take(1192, 16); take(1208, 16); take(1224, 16); end
            if (changed[6]) begin take(1242, 1); take(1243, 9); take(1252, 9); take(1261, 32); take(1293, 16); take(1309, 16); take(1325, 16); take(1341, 16); take(1357, 16); take(1373, 16); take(1389, 16); take(1405, 16); take(1421, 16); take(1437, 16); take(1453, 16); take(1469, 16); take(1485, 16); take(1501, 16); end
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
        for (cycle = 0; cycle < 121208 && differences == 0; cycle = cycle + 1) begin
            advance;
            #4;
            if (found[40] !== vector[40]) differ("splat_ready");
            if (found[554] !== vector[554]) differ("read_valid");
            if (vector[554] && found[567:556] !== vector[567:556]) differ("read_tile");
            if (vector[554] && found[573:568] !== vector[573:568]) differ("read_pixel");
            if (vector[554] && found[577:574] !== vector[577:574]) differ("read_count");
            if (found[579] !== vector[579]) differ("data_ready");
            if (found[900] !== vector[900]) differ("write_valid");
            if (vector[900] && found[913:902] !== vector[913:902]) differ("write_tile");
            if (vector[900] && found[919:914] !== vector[919:914]) differ("write_pixel");
            if (vector[900] && found[947:920] !== vector[947:920]) differ("write_weight");
            if (vector[900] && found[999:948] !== vector[999:948]) differ("write_depth");
            if (vector[900] && found[1015:1000] !== vector[1015:1000]) differ("write_peak");
            if (vector[900] && found[1031:1016] !== vector[1031:1016]) differ("write_attribute_0");
            if (vector[900] && found[1047:1032] !== vector[1047:1032]) differ("write_attribute_1");
            if (vector[900] && found[1063:1048] !== vector[1063:1048]) differ("write_attribute_2");
            if (vector[900] && found[1079:1064] !== vector[1079:1064]) differ("write_attribute_3");
            if (vector[900] && found[1095:1080] !== vector[1095:1080]) differ("write_attribute_4");
            if (vector[900] && found[1111:1096] !== vector[1111:1096]) differ("write_attribute_5");
            if (vector[900] && found[1127:1112] !== vector[1127:1112]) differ("write_attribute_6");
            if (vector[900] && found[1143:1128] !== vector[1143:1128]) differ("write_attribute_7");
            if (vector[900] && found[1159:1144] !== vector[1159:1144]) differ("write_attribute_8");
            if (vector[900] && found[1175:1160] !== vector[1175:1160]) differ("write_attribute_9");
            if (vector[900] && found[1191:1176] !== vector[1191:1176]) differ("write_attribute_10");
            if (vector[900] && found[1207:1192] !== vector[1207:1192]) differ("write_attribute_11");
            if (vector[900] && found[1223:1208] !== vector[1223:1208]) differ("write_attribute_12");
            if (vector[900] && found[1239:1224] !== vector[1239:1224]) differ("write_cardinal_0");
            if (found[1240] !== vector[1240]) differ("fragment_valid");
            if (vector[1240] && found[1242] !== vector[1242]) differ("fragment_end");
            if (vector[1240] && !vector[1242] && found[1251:1243] !== vector[1251:1243]) differ("fragment_column");
            if (vector[1240] && !vector[1242] && found[1260:1252] !== vector[1260:1252]) differ("fragment_row");
            if (vector[1240] && !vector[1242] && found[1292:1261] !== vector[1292:1261]) differ("fragment_depth");
            if (vector[1240] && !vector[1242] && found[1308:1293] !== vector[1308:1293]) differ("fragment_attribute_0");
            if (vector[1240] && !vector[1242] && found[1324:1309] !== vector[1324:1309]) differ("fragment_attribute_1");
            if (vector[1240] && !vector[1242] && found[1340:1325] !== vector[1340:1325]) differ("fragment_attribute_2");
            if (vector[1240] && !vector[1242] && found[1356:1341] !== vector[1356:1341]) differ("fragment_attribute_3");
            if (vector[1240] && !vector[1242] && found[1372:1357] !== vector[1372:1357]) differ("fragment_attribute_4");
            if (vector[1240] && !vector[1242] && found[1388:1373] !== vector[1388:1373]) differ("fragment_attribute_5");
            if (vector[1240] && !vector[1242] && found[1404:1389] !== vector[1404:1389]) differ("fragment_attribute_6");
            if (vector[1240] && !vector[1242] && found[1420:1405] !== vector[1420:1405]) differ("fragment_attribute_7");
            if (vector[1240] && !vector[1242] && found[1436:1421] !== vector[1436:1421]) differ("fragment_attribute_8");
            if (vector[1240] && !vector[1242] && found[1452:1437] !== vector[1452:1437]) differ("fragment_attribute_9");
            if (vector[1240] && !vector[1242] && found[1468:1453] !== vector[1468:1453]) differ("fragment_attribute_10");
            if (vector[1240] && !vector[1242] && found[1484:1469] !== vector[1484:1469]) differ("fragment_attribute_11");
            if (vector[1240] && !vector[1242] && found[1500:1485] !== vector[1500:1485]) differ("fragment_attribute_12");
            if (vector[1240] && !vector[1242] && found[1516:1501] !== vector[1516:1501]) differ("fragment_cardinal_0");
            if (found[1517] !== vector[1517]) differ("event_sample");
            if (found[1518] !== vector[1518]) differ("event_starved");
            if (found[1519] !== vector[1519]) differ("event_blocked");
            if (found[1520] !== vector[1520]) differ("event_accumulate");
            if (found[1521] !== vector[1521]) differ("event_hazard");
            if (found[1522] !== vector[1522]) differ("event_slot_wait");
            @(negedge clk);
        end
        if (differences != 0) $fatal(1, "FAILED");
        $display("PASSED: 121208 cycles, 10532 items, every output as the model's");
        $finish;
    end
endmodule
