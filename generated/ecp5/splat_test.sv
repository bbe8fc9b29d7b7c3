// Written by pointcore 0.1.0; do not edit.
// Replays 85101 cycles of the bit-exact model at the ports of splat_top, in which 8609 items leave the core, and compares every output in every
// cycle; a stream's fields count while it is valid, and those that go in are spoilt while it is not. For Verilator, whose registers start at
// random values: in a simulator with unknown values, what is not reset stays unknown longer than in hardware.
//
// splat_test.hex is a sequence of bits: in every cycle one, whether anything changes, and if so one for each group of ports, whether it does,
// then the words of those that do.

module splat_test;
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [63:0] words [0:66312];
    reg [1434:0] vector = 0;
    reg [1434:0] next = 0;
    wire [1434:0] found;
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
        .read_valid(found[474]),
        .read_ready(vector[475]),
        .read_tile(found[487:476]),
        .read_pixel(found[493:488]),
        .read_count(found[497:494]),
        .data_valid(vector[498]),
        .data_ready(found[499]),
        .data_weight(vector[498] ? vector[527:500] : ~vector[527:500]),
        .data_depth(vector[498] ? vector[579:528] : ~vector[579:528]),
        .data_peak(vector[498] ? vector[595:580] : ~vector[595:580]),
        .data_attribute_0(vector[498] ? vector[611:596] : ~vector[611:596]),
        .data_attribute_1(vector[498] ? vector[627:612] : ~vector[627:612]),
        .data_attribute_2(vector[498] ? vector[643:628] : ~vector[643:628]),
        .data_attribute_3(vector[498] ? vector[659:644] : ~vector[659:644]),
        .data_attribute_4(vector[498] ? vector[675:660] : ~vector[675:660]),
        .data_attribute_5(vector[498] ? vector[691:676] : ~vector[691:676]),
        .data_attribute_6(vector[498] ? vector[707:692] : ~vector[707:692]),
        .data_attribute_7(vector[498] ? vector[723:708] : ~vector[723:708]),
        .data_attribute_8(vector[498] ? vector[739:724] : ~vector[739:724]),
        .data_attribute_9(vector[498] ? vector[755:740] : ~vector[755:740]),
        .data_attribute_10(vector[498] ? vector[771:756] : ~vector[771:756]),
        .data_attribute_11(vector[498] ? vector[787:772] : ~vector[787:772]),
        .data_attribute_12(vector[498] ? vector[803:788] : ~vector[803:788]),
        .data_cardinal_0(vector[498] ? vector[819:804] : ~vector[819:804]),
        .write_valid(found[820]),
        .write_ready(vector[821]),
        .write_tile(found[833:822]),
        .write_pixel(found[839:834]),
        .write_weight(found[867:840]),
        .write_depth(found[919:868]),
        .write_peak(found[935:920]),
        .write_attribute_0(found[951:936]),
        .write_attribute_1(found[967:952]),
        .write_attribute_2(found[983:968]),
        .write_attribute_3(found[999:984]),
        .write_attribute_4(found[1015:1000]),
        .write_attribute_5(found[1031:1016]),
        .write_attribute_6(found[1047:1032]),
        .write_attribute_7(found[1063:1048]),
        .write_attribute_8(found[1079:1064]),
        .write_attribute_9(found[1095:1080]),
        .write_attribute_10(found[1111:1096]),
        .write_attribute_11(found[1127:1112]),
        .write_attribute_12(found[1143:1128]),
        .write_cardinal_0(found[1159:1144]),
        .fragment_valid(found[1160]),
        .fragment_ready(vector[1161]),
        .fragment_end(found[1162]),
        .fragment_column(found[1171:1163]),
        .fragment_row(found[1180:1172]),
        .fragment_depth(found[1204:1181]),
        .fragment_attribute_0(found[1220:1205]),
        .fragment_attribute_1(found[1236:1221]),
        .fragment_attribute_2(found[1252:1237]),
        .fragment_attribute_3(found[1268:1253]),
        .fragment_attribute_4(found[1284:1269]),
        .fragment_attribute_5(found[1300:1285]),
        .fragment_attribute_6(found[1316:1301]),
        .fragment_attribute_7(found[1332:1317]),
        .fragment_attribute_8(found[1348:1333]),
        .fragment_attribute_9(found[1364:1349]),
        .fragment_attribute_10(found[1380:1365]),
        .fragment_attribute_11(found[1396:1381]),
        .fragment_attribute_12(found[1412:1397]),
        .fragment_cardinal_0(found[1428:1413]),
        .event_sample(found[1429]),
        .event_starved(found[1430]),
        .event_blocked(found[1431]),
        .event_accumulate(found[1432]),
        .event_hazard(found[1433]),
        .event_slot_wait(found[1434])
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
            if (changed[0]) begin take(0, 1); take(1, 1); take(31, 1); take(32, 1); take(474, 1); take(475, 1); take(498, 1); take(499, 1); take(820, 1); take(821, 1); take(1160, 1); take(1161, 1); take(1429, 1); take(1430, 1); take(1431, 1); take(1432, 1); take(1433, 1); take(1434, 1); end
            if (changed[1]) begin take(2, 5); take(7, 24); end
            if (changed[2]) begin take(33, 1); take(34, 24); take(58, 24); take(82, 24); take(106, 24); take(130, 24); take(154, 24); take(178, 24); take(202, 24); take(226, 24); take(250, 16); take(266, 16); take(282, 16); take(298, 16); take(314, 16); take(330, 16); take(346, 16); take(362, 16); take(378, 16); take(394, 16); take(410, 16); take(426, 16); take(442, 16); take(458, 16); end
            if (changed[3]) begin take(476, 12); take(488, 6); take(494, 4); end
            if (changed[4]) begin take(500, 28); take(528, 52); take(580, 16); take(596, 16); take(612, 16); take(628, 16); take(644, 16); take(660, 16); take(676, 16); take(692, 16); take(708, 16); take(724, 16); take(740, 16); take(756, 16); take(772, 16); take(788, 16); take(804, 16); end
            if (changed[5]) begin take(822, 12); take(834, 6); take(840, 28); take(868, 52); take(920, 16); take(936, 16); take(952, 16); take(968, 16); take(984, 16); take(1000, 16); take(1016, 16); take(1032, 16); take(1048, 16); take(1064, 16); take(1080, 16); take(1096, 16); take(1112, 16); take(1128, 16); take(1144, 16); end
            if (changed[6]) begin take(1162, 1); take(1163, 9); take(1172, 9); take(1181, 24); take(1205, 16); take(1221, 16); take(1237, 16); take(1253, 16); take(1269, 16); take(1285, 16); take(1301, 16); take(1317, 16); take(1333, 16); take(1349, 16); take(1365, 16); take(1381, 16); take(1397, 16); take(1413, 16); end
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
        for (cycle = 0; cycle < 85101 && differences == 0; cycle = cycle + 1) begin
            advance;
            #4;
            if (found[32] !== vector[32]) differ("splat_ready");
            if (found[474] !== vector[474]) differ("read_valid");
            if (vector[474] && found[487:476] !== vector[487:476]) differ("read_tile");
            if (vector[474] && found[493:488] !== vector[493:488]) differ("read_pixel");
            if (vector[474] && found[497:494] !== vector[497:494]) differ("read_count");
            if (found[499] !== vector[499]) differ("data_ready");
            if (found[820] !== vector[820]) differ("write_valid");
            if (vector[820] && found[833:822] !== vector[833:822]) differ("write_tile");
            if (vector[820] && found[839:834] !== vector[839:834]) differ("write_pixel");
            if (vector[820] && found[867:840] !== vector[867:840]) differ("write_weight");
            if (vector[820] && found[919:868] !== vector[919:868]) differ("write_depth");
            if (vector[820] && found[935:920] !== vector[935:920]) differ("write_peak");
            if (vector[820] && found[951:936] !== vector[951:936]) differ("write_attribute_0");
            if (vector[820] && found[967:952] !== vector[967:952]) differ("write_attribute_1");
            if (vector[820] && found[983:968] !== vector[983:968]) differ("write_attribute_2");
            if (vector[820] && found[999:984] !== vector[999:984]) differ("write_attribute_3");
            if (vector[820] && found[1015:1000] !== vector[1015:1000]) differ("write_attribute_4");
            if (vector[820] && found[1031:1016] !== vector[1031:1016]) differ("write_attribute_5");
            if (vector[820] && found[1047:1032] !== vector[1047:1032]) differ("write_attribute_6");
            if (vector[820] && found[1063:1048] !== vector[1063:1048]) differ("write_attribute_7");
            if (vector[820] && found[1079:1064] !== vector[1079:1064]) differ("write_attribute_8");
            if (vector[820] && found[1095:1080] !== vector[1095:1080]) differ("write_attribute_9");
            if (vector[820] && found[1111:1096] !== vector[1111:1096]) differ("write_attribute_10");
            if (vector[820] && found[1127:1112] !== vector[1127:1112]) differ("write_attribute_11");
            if (vector[820] && found[1143:1128] !== vector[1143:1128]) differ("write_attribute_12");
            if (vector[820] && found[1159:1144] !== vector[1159:1144]) differ("write_cardinal_0");
            if (found[1160] !== vector[1160]) differ("fragment_valid");
            if (vector[1160] && found[1162] !== vector[1162]) differ("fragment_end");
            if (vector[1160] && !vector[1162] && found[1171:1163] !== vector[1171:1163]) differ("fragment_column");
            if (vector[1160] && !vector[1162] && found[1180:1172] !== vector[1180:1172]) differ("fragment_row");
            if (vector[1160] && !vector[1162] && found[1204:1181] !== vector[1204:1181]) differ("fragment_depth");
            if (vector[1160] && !vector[1162] && found[1220:1205] !== vector[1220:1205]) differ("fragment_attribute_0");
            if (vector[1160] && !vector[1162] && found[1236:1221] !== vector[1236:1221]) differ("fragment_attribute_1");
            if (vector[1160] && !vector[1162] && found[1252:1237] !== vector[1252:1237]) differ("fragment_attribute_2");
            if (vector[1160] && !vector[1162] && found[1268:1253] !== vector[1268:1253]) differ("fragment_attribute_3");
            if (vector[1160] && !vector[1162] && found[1284:1269] !== vector[1284:1269]) differ("fragment_attribute_4");
            if (vector[1160] && !vector[1162] && found[1300:1285] !== vector[1300:1285]) differ("fragment_attribute_5");
            if (vector[1160] && !vector[1162] && found[1316:1301] !== vector[1316:1301]) differ("fragment_attribute_6");
            if (vector[1160] && !vector[1162] && found[1332:1317] !== vector[1332:1317]) differ("fragment_attribute_7");
            if (vector[1160] && !vector[1162] && found[1348:1333] !== vector[1348:1333]) differ("fragment_attribute_8");
            if (vector[1160] && !vector[1162] && found[1364:1349] !== vector[1364:1349]) differ("fragment_attribute_9");
            if (vector[1160] && !vector[1162] && found[1380:1365] !== vector[1380:1365]) differ("fragment_attribute_10");
            if (vector[1160] && !vector[1162] && found[1396:1381] !== vector[1396:1381]) differ("fragment_attribute_11");
            if (vector[1160] && !vector[1162] && found[1412:1397] !== vector[1412:1397]) differ("fragment_attribute_12");
            if (vector[1160] && !vector[1162] && found[1428:1413] !== vector[1428:1413]) differ("fragment_cardinal_0");
            if (found[1429] !== vector[1429]) differ("event_sample");
            if (found[1430] !== vector[1430]) differ("event_starved");
            if (found[1431] !== vector[1431]) differ("event_blocked");
            if (found[1432] !== vector[1432]) differ("event_accumulate");
            if (found[1433] !== vector[1433]) differ("event_hazard");
            if (found[1434] !== vector[1434]) differ("event_slot_wait");
            @(negedge clk);
        end
        if (differences != 0) $fatal(1, "FAILED");
        $display("PASSED: 85101 cycles, 8609 items, every output as the model's");
        $finish;
    end
endmodule
