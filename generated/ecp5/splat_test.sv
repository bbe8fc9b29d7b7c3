// Written by pointcore 0.1.0; do not edit.
// Replays 178172 cycles of the bit-exact model at the ports of splat_top, in which 17699 items leave the core, and compares every output in every
// cycle; a stream's fields count while it is valid, and those that go in are spoilt while it is not. For Verilator, whose registers start at
// random values: in a simulator with unknown values, what is not reset stays unknown longer than in hardware.
//
// splat_test.hex is a sequence of bits: in every cycle one, whether anything changes, and if so one for each group of ports, whether it does,
// then the words of those that do.

module splat_test;
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [63:0] words [0:162074];
    reg [1424:0] vector = 0;
    reg [1424:0] next = 0;
    wire [1424:0] found;
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
        .data_valid(vector[488]),
        .data_ready(found[489]),
        .data_weight(vector[488] ? vector[517:490] : ~vector[517:490]),
        .data_depth(vector[488] ? vector[569:518] : ~vector[569:518]),
        .data_peak(vector[488] ? vector[585:570] : ~vector[585:570]),
        .data_attribute_0(vector[488] ? vector[601:586] : ~vector[601:586]),
        .data_attribute_1(vector[488] ? vector[617:602] : ~vector[617:602]),
        .data_attribute_2(vector[488] ? vector[633:618] : ~vector[633:618]),
        .data_attribute_3(vector[488] ? vector[649:634] : ~vector[649:634]),
        .data_attribute_4(vector[488] ? vector[665:650] : ~vector[665:650]),
        .data_attribute_5(vector[488] ? vector[681:666] : ~vector[681:666]),
        .data_attribute_6(vector[488] ? vector[697:682] : ~vector[697:682]),
        .data_attribute_7(vector[488] ? vector[713:698] : ~vector[713:698]),
        .data_attribute_8(vector[488] ? vector[729:714] : ~vector[729:714]),
        .data_attribute_9(vector[488] ? vector[745:730] : ~vector[745:730]),
        .data_attribute_10(vector[488] ? vector[761:746] : ~vector[761:746]),
        .data_attribute_11(vector[488] ? vector[777:762] : ~vector[777:762]),
        .data_attribute_12(vector[488] ? vector[793:778] : ~vector[793:778]),
        .data_cardinal_0(vector[488] ? vector[809:794] : ~vector[809:794]),
        .write_valid(found[810]),
        .write_ready(vector[811]),
        .write_tile(found[823:812]),
        .write_pixel(found[829:824]),
        .write_weight(found[857:830]),
        .write_depth(found[909:858]),
        .write_peak(found[925:910]),
        .write_attribute_0(found[941:926]),
        .write_attribute_1(found[957:942]),
        .write_attribute_2(found[973:958]),
        .write_attribute_3(found[989:974]),
        .write_attribute_4(found[1005:990]),
        .write_attribute_5(found[1021:1006]),
        .write_attribute_6(found[1037:1022]),
        .write_attribute_7(found[1053:1038]),
        .write_attribute_8(found[1069:1054]),
        .write_attribute_9(found[1085:1070]),
        .write_attribute_10(found[1101:1086]),
        .write_attribute_11(found[1117:1102]),
        .write_attribute_12(found[1133:1118]),
        .write_cardinal_0(found[1149:1134]),
        .fragment_valid(found[1150]),
        .fragment_ready(vector[1151]),
        .fragment_end(found[1152]),
        .fragment_column(found[1161:1153]),
        .fragment_row(found[1170:1162]),
        .fragment_depth(found[1194:1171]),
        .fragment_attribute_0(found[1210:1195]),
        .fragment_attribute_1(found[1226:1211]),
        .fragment_attribute_2(found[1242:1227]),
        .fragment_attribute_3(found[1258:1243]),
        .fragment_attribute_4(found[1274:1259]),
        .fragment_attribute_5(found[1290:1275]),
        .fragment_attribute_6(found[1306:1291]),
        .fragment_attribute_7(found[1322:1307]),
        .fragment_attribute_8(found[1338:1323]),
        .fragment_attribute_9(found[1354:1339]),
        .fragment_attribute_10(found[1370:1355]),
        .fragment_attribute_11(found[1386:1371]),
        .fragment_attribute_12(found[1402:1387]),
        .fragment_cardinal_0(found[1418:1403]),
        .event_sample(found[1419]),
        .event_starved(found[1420]),
        .event_blocked(found[1421]),
        .event_accumulate(found[1422]),
        .event_hazard(found[1423]),
        .event_slot_wait(found[1424])
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
            if (changed[0]) begin take(0, 1); take(1, 1); take(31, 1); take(32, 1); take(474, 1); take(475, 1); take(488, 1); take(489, 1); take(810, 1); take(811, 1); take(1150, 1); take(1151, 1); take(1419, 1); take(1420, 1); take(1421, 1); take(1422, 1); take(1423, 1); take(1424, 1); end
            if (changed[1]) begin take(2, 5); take(7, 24); end
            if (changed[2]) begin take(33, 1); take(34, 24); take(58, 24); take(82, 24); take(106, 24); take(130, 24); take(154, 24); take(178, 24); take(202, 24); take(226, 24); take(250, 16); take(266, 16); take(282, 16); take(298, 16); take(314, 16); take(330, 16); take(346, 16); take(362, 16); take(378, 16); take(394, 16); take(410, 16); take(426, 16); take(442, 16); take(458, 16); end
            if (changed[3]) begin take(476, 12); end
            if (changed[4]) begin take(490, 28); take(518, 52); take(570, 16); take(586, 16); take(602, 16); take(618, 16); take(634, 16); take(650, 16); take(666, 16); take(682, 16); take(698, 16); take(714, 16); take(730, 16); take(746, 16); take(762, 16); take(778, 16); take(794, 16); end
            if (changed[5]) begin take(812, 12); take(824, 6); take(830, 28); take(858, 52); take(910, 16); take(926, 16); take(942, 16); take(958, 16); take(974, 16); take(990, 16); take(1006, 16); take(1022, 16); take(1038, 16); take(1054, 16); take(1070, 16); take(1086, 16); take(1102, 16); take(1118, 16); take(1134, 16); end
            if (changed[6]) begin take(1152, 1); take(1153, 9); take(1162, 9); take(1171, 24); take(1195, 16); take(1211, 16); take(1227, 16); take(1243, 16); take(1259, 16); take(1275, 16); take(1291, 16); take(1307, 16); take(1323, 16); take(1339, 16); take(1355, 16); take(1371, 16); take(1387, 16); take(1403, 16); end
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
        for (cycle = 0; cycle < 178172 && differences == 0; cycle = cycle + 1) begin
            advance;
            #4;
            if (found[32] !== vector[32]) differ("splat_ready");
            if (found[474] !== vector[474]) differ("read_valid");
            if (vector[474] && found[487:476] !== vector[487:476]) differ("read_tile");
            if (found[489] !== vector[489]) differ("data_ready");
            if (found[810] !== vector[810]) differ("write_valid");
            if (vector[810] && found[823:812] !== vector[823:812]) differ("write_tile");
            if (vector[810] && found[829:824] !== vector[829:824]) differ("write_pixel");
            if (vector[810] && found[857:830] !== vector[857:830]) differ("write_weight");
            if (vector[810] && found[909:858] !== vector[909:858]) differ("write_depth");
            if (vector[810] && found[925:910] !== vector[925:910]) differ("write_peak");
            if (vector[810] && found[941:926] !== vector[941:926]) differ("write_attribute_0");
            if (vector[810] && found[957:942] !== vector[957:942]) differ("write_attribute_1");
            if (vector[810] && found[973:958] !== vector[973:958]) differ("write_attribute_2");
            if (vector[810] && found[989:974] !== vector[989:974]) differ("write_attribute_3");
            if (vector[810] && found[1005:990] !== vector[1005:990]) differ("write_attribute_4");
            if (vector[810] && found[1021:1006] !== vector[1021:1006]) differ("write_attribute_5");
            if (vector[810] && found[1037:1022] !== vector[1037:1022]) differ("write_attribute_6");
            if (vector[810] && found[1053:1038] !== vector[1053:1038]) differ("write_attribute_7");
            if (vector[810] && found[1069:1054] !== vector[1069:1054]) differ("write_attribute_8");
            if (vector[810] && found[1085:1070] !== vector[1085:1070]) differ("write_attribute_9");
            if (vector[810] && found[1101:1086] !== vector[1101:1086]) differ("write_attribute_10");
            if (vector[810] && found[1117:1102] !== vector[1117:1102]) differ("write_attribute_11");
            if (vector[810] && found[1133:1118] !== vector[1133:1118]) differ("write_attribute_12");
            if (vector[810] && found[1149:1134] !== vector[1149:1134]) differ("write_cardinal_0");
            if (found[1150] !== vector[1150]) differ("fragment_valid");
            if (vector[1150] && found[1152] !== vector[1152]) differ("fragment_end");
            if (vector[1150] && !vector[1152] && found[1161:1153] !== vector[1161:1153]) differ("fragment_column");
            if (vector[1150] && !vector[1152] && found[1170:1162] !== vector[1170:1162]) differ("fragment_row");
            if (vector[1150] && !vector[1152] && found[1194:1171] !== vector[1194:1171]) differ("fragment_depth");
            if (vector[1150] && !vector[1152] && found[1210:1195] !== vector[1210:1195]) differ("fragment_attribute_0");
            if (vector[1150] && !vector[1152] && found[1226:1211] !== vector[1226:1211]) differ("fragment_attribute_1");
            if (vector[1150] && !vector[1152] && found[1242:1227] !== vector[1242:1227]) differ("fragment_attribute_2");
            if (vector[1150] && !vector[1152] && found[1258:1243] !== vector[1258:1243]) differ("fragment_attribute_3");
            if (vector[1150] && !vector[1152] && found[1274:1259] !== vector[1274:1259]) differ("fragment_attribute_4");
            if (vector[1150] && !vector[1152] && found[1290:1275] !== vector[1290:1275]) differ("fragment_attribute_5");
            if (vector[1150] && !vector[1152] && found[1306:1291] !== vector[1306:1291]) differ("fragment_attribute_6");
            if (vector[1150] && !vector[1152] && found[1322:1307] !== vector[1322:1307]) differ("fragment_attribute_7");
            if (vector[1150] && !vector[1152] && found[1338:1323] !== vector[1338:1323]) differ("fragment_attribute_8");
            if (vector[1150] && !vector[1152] && found[1354:1339] !== vector[1354:1339]) differ("fragment_attribute_9");
            if (vector[1150] && !vector[1152] && found[1370:1355] !== vector[1370:1355]) differ("fragment_attribute_10");
            if (vector[1150] && !vector[1152] && found[1386:1371] !== vector[1386:1371]) differ("fragment_attribute_11");
            if (vector[1150] && !vector[1152] && found[1402:1387] !== vector[1402:1387]) differ("fragment_attribute_12");
            if (vector[1150] && !vector[1152] && found[1418:1403] !== vector[1418:1403]) differ("fragment_cardinal_0");
            if (found[1419] !== vector[1419]) differ("event_sample");
            if (found[1420] !== vector[1420]) differ("event_starved");
            if (found[1421] !== vector[1421]) differ("event_blocked");
            if (found[1422] !== vector[1422]) differ("event_accumulate");
            if (found[1423] !== vector[1423]) differ("event_hazard");
            if (found[1424] !== vector[1424]) differ("event_slot_wait");
            @(negedge clk);
        end
        if (differences != 0) $fatal(1, "FAILED");
        $display("PASSED: 178172 cycles, 17699 items, every output as the model's");
        $finish;
    end
endmodule
