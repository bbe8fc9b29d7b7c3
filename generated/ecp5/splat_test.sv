// Written by pointcore 0.1.0; do not edit.
// Replays 125618 cycles of the bit-exact model at the ports of splat_top, in which 9738 items leave the core, and compares every output in every
// cycle; a stream's fields count while it is valid, and those that go in are spoilt while it is not. For Verilator, whose registers start at
// random values: in a simulator with unknown values, what is not reset stays unknown longer than in hardware.
//
// splat_test.hex is a sequence of bits: in every cycle one, whether anything changes, and if so one for each group of ports, whether it does,
// then the words of those that do.

module splat_test;
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [63:0] words [0:75374];
    reg [1436:0] vector = 0;
    reg [1436:0] next = 0;
    wire [1436:0] found;
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
        .read_surface(found[476]),
        .read_tile(found[488:477]),
        .read_pixel(found[494:489]),
        .read_count(found[498:495]),
        .data_valid(vector[499]),
        .data_ready(found[500]),
        .data_weight(vector[499] ? vector[528:501] : ~vector[528:501]),
        .data_depth(vector[499] ? vector[580:529] : ~vector[580:529]),
        .data_peak(vector[499] ? vector[596:581] : ~vector[596:581]),
        .data_attribute_0(vector[499] ? vector[612:597] : ~vector[612:597]),
        .data_attribute_1(vector[499] ? vector[628:613] : ~vector[628:613]),
        .data_attribute_2(vector[499] ? vector[644:629] : ~vector[644:629]),
        .data_attribute_3(vector[499] ? vector[660:645] : ~vector[660:645]),
        .data_attribute_4(vector[499] ? vector[676:661] : ~vector[676:661]),
        .data_attribute_5(vector[499] ? vector[692:677] : ~vector[692:677]),
        .data_attribute_6(vector[499] ? vector[708:693] : ~vector[708:693]),
        .data_attribute_7(vector[499] ? vector[724:709] : ~vector[724:709]),
        .data_attribute_8(vector[499] ? vector[740:725] : ~vector[740:725]),
        .data_attribute_9(vector[499] ? vector[756:741] : ~vector[756:741]),
        .data_attribute_10(vector[499] ? vector[772:757] : ~vector[772:757]),
        .data_attribute_11(vector[499] ? vector[788:773] : ~vector[788:773]),
        .data_attribute_12(vector[499] ? vector[804:789] : ~vector[804:789]),
        .data_cardinal_0(vector[499] ? vector[820:805] : ~vector[820:805]),
        .write_valid(found[821]),
        .write_ready(vector[822]),
        .write_surface(found[823]),
        .write_tile(found[835:824]),
        .write_pixel(found[841:836]),
        .write_weight(found[869:842]),
        .write_depth(found[921:870]),
        .write_peak(found[937:922]),
        .write_attribute_0(found[953:938]),
        .write_attribute_1(found[969:954]),
        .write_attribute_2(found[985:970]),
        .write_attribute_3(found[1001:986]),
        .write_attribute_4(found[1017:1002]),
        .write_attribute_5(found[1033:1018]),
        .write_attribute_6(found[1049:1034]),
        .write_attribute_7(found[1065:1050]),
        .write_attribute_8(found[1081:1066]),
        .write_attribute_9(found[1097:1082]),
        .write_attribute_10(found[1113:1098]),
        .write_attribute_11(found[1129:1114]),
        .write_attribute_12(found[1145:1130]),
        .write_cardinal_0(found[1161:1146]),
        .fragment_valid(found[1162]),
        .fragment_ready(vector[1163]),
        .fragment_end(found[1164]),
        .fragment_column(found[1173:1165]),
        .fragment_row(found[1182:1174]),
        .fragment_depth(found[1206:1183]),
        .fragment_attribute_0(found[1222:1207]),
        .fragment_attribute_1(found[1238:1223]),
        .fragment_attribute_2(found[1254:1239]),
        .fragment_attribute_3(found[1270:1255]),
        .fragment_attribute_4(found[1286:1271]),
        .fragment_attribute_5(found[1302:1287]),
        .fragment_attribute_6(found[1318:1303]),
        .fragment_attribute_7(found[1334:1319]),
        .fragment_attribute_8(found[1350:1335]),
        .fragment_attribute_9(found[1366:1351]),
        .fragment_attribute_10(found[1382:1367]),
        .fragment_attribute_11(found[1398:1383]),
        .fragment_attribute_12(found[1414:1399]),
        .fragment_cardinal_0(found[1430:1415]),
        .event_sample(found[1431]),
        .event_starved(found[1432]),
        .event_blocked(found[1433]),
        .event_accumulate(found[1434]),
        .event_hazard(found[1435]),
        .event_slot_wait(found[1436])
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
            if (changed[0]) begin take(0, 1); take(1, 1); take(31, 1); take(32, 1); take(474, 1); take(475, 1); take(499, 1); take(500, 1); take(821, 1); take(822, 1); take(1162, 1); take(1163, 1); take(1431, 1); take(1432, 1); take(1433, 1); take(1434, 1); take(1435, 1); take(1436, 1); end
            if (changed[1]) begin take(2, 5); take(7, 24); end
            if (changed[2]) begin take(33, 1); take(34, 24); take(58, 24); take(82, 24); take(106, 24); take(130, 24); take(154, 24); take(178, 24); take(202, 24); take(226, 24); take(250, 16); take(266, 16); take(282, 16); take(298, 16); take(314, 16); take(330, 16); take(346, 16); take(362, 16); take(378, 16); take(394, 16); take(410, 16); take(426, 16); take(442, 16); take(458, 16); end
            if (changed[3]) begin take(476, 1); take(477, 12); take(489, 6); take(495, 4); end
            if (changed[4]) begin take(501, 28); take(529, 52); take(581, 16); take(597, 16); take(613, 16); take(629, 16); take(645, 16); take(661, 16); take(677, 16); take(693, 16); take(709, 16); take(725, 16); take(741, 16); take(757, 16); take(773, 16); take(789, 16); take(805, 16); end
            if (changed[5]) begin take(823, 1); take(824, 12); take(836, 6); take(842, 28); take(870, 52); take(922, 16); take(938, 16); take(954, 16); take(970, 16); take(986, 16); take(1002, 16); take(1018, 16); take(1034, 16); take(1050, 16); take(1066, 16); take(1082, 16); take(1098, 16); take(1114, 16); take(1130, 16); take(1146, 16); end
            if (changed[6]) begin take(1164, 1); take(1165, 9); take(1174, 9); take(1183, 24); take(1207, 16); take(1223, 16); take(1239, 16); take(1255, 16); take(1271, 16); take(1287, 16); take(1303, 16); take(1319, 16); take(1335, 16); take(1351, 16); take(1367, 16); take(1383, 16); take(1399, 16); take(1415, 16); end
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
        for (cycle = 0; cycle < 125618 && differences == 0; cycle = cycle + 1) begin
            advance;
            #4;
            if (found[32] !== vector[32]) differ("splat_ready");
            if (found[474] !== vector[474]) differ("read_valid");
            if (vector[474] && found[476] !== vector[476]) differ("read_surface");
            if (vector[474] && found[488:477] !== vector[488:477]) differ("read_tile");
            if (vector[474] && found[494:489] !== vector[494:489]) differ("read_pixel");
            if (vector[474] && found[498:495] !== vector[498:495]) differ("read_count");
            if (found[500] !== vector[500]) differ("data_ready");
            if (found[821] !== vector[821]) differ("write_valid");
            if (vector[821] && found[823] !== vector[823]) differ("write_surface");
            if (vector[821] && found[835:824] !== vector[835:824]) differ("write_tile");
            if (vector[821] && found[841:836] !== vector[841:836]) differ("write_pixel");
            if (vector[821] && found[869:842] !== vector[869:842]) differ("write_weight");
            if (vector[821] && found[921:870] !== vector[921:870]) differ("write_depth");
            if (vector[821] && found[937:922] !== vector[937:922]) differ("write_peak");
            if (vector[821] && found[953:938] !== vector[953:938]) differ("write_attribute_0");
            if (vector[821] && found[969:954] !== vector[969:954]) differ("write_attribute_1");
            if (vector[821] && found[985:970] !== vector[985:970]) differ("write_attribute_2");
            if (vector[821] && found[1001:986] !== vector[1001:986]) differ("write_attribute_3");
            if (vector[821] && found[1017:1002] !== vector[1017:1002]) differ("write_attribute_4");
            if (vector[821] && found[1033:1018] !== vector[1033:1018]) differ("write_attribute_5");
            if (vector[821] && found[1049:1034] !== vector[1049:1034]) differ("write_attribute_6");
            if (vector[821] && found[1065:1050] !== vector[1065:1050]) differ("write_attribute_7");
            if (vector[821] && found[1081:1066] !== vector[1081:1066]) differ("write_attribute_8");
            if (vector[821] && found[1097:1082] !== vector[1097:1082]) differ("write_attribute_9");
            if (vector[821] && found[1113:1098] !== vector[1113:1098]) differ("write_attribute_10");
            if (vector[821] && found[1129:1114] !== vector[1129:1114]) differ("write_attribute_11");
            if (vector[821] && found[1145:1130] !== vector[1145:1130]) differ("write_attribute_12");
            if (vector[821] && found[1161:1146] !== vector[1161:1146]) differ("write_cardinal_0");
            if (found[1162] !== vector[1162]) differ("fragment_valid");
            if (vector[1162] && found[1164] !== vector[1164]) differ("fragment_end");
            if (vector[1162] && !vector[1164] && found[1173:1165] !== vector[1173:1165]) differ("fragment_column");
            if (vector[1162] && !vector[1164] && found[1182:1174] !== vector[1182:1174]) differ("fragment_row");
            if (vector[1162] && !vector[1164] && found[1206:1183] !== vector[1206:1183]) differ("fragment_depth");
            if (vector[1162] && !vector[1164] && found[1222:1207] !== vector[1222:1207]) differ("fragment_attribute_0");
            if (vector[1162] && !vector[1164] && found[1238:1223] !== vector[1238:1223]) differ("fragment_attribute_1");
            if (vector[1162] && !vector[1164] && found[1254:1239] !== vector[1254:1239]) differ("fragment_attribute_2");
            if (vector[1162] && !vector[1164] && found[1270:1255] !== vector[1270:1255]) differ("fragment_attribute_3");
            if (vector[1162] && !vector[1164] && found[1286:1271] !== vector[1286:1271]) differ("fragment_attribute_4");
            if (vector[1162] && !vector[1164] && found[1302:1287] !== vector[1302:1287]) differ("fragment_attribute_5");
            if (vector[1162] && !vector[1164] && found[1318:1303] !== vector[1318:1303]) differ("fragment_attribute_6");
            if (vector[1162] && !vector[1164] && found[1334:1319] !== vector[1334:1319]) differ("fragment_attribute_7");
            if (vector[1162] && !vector[1164] && found[1350:1335] !== vector[1350:1335]) differ("fragment_attribute_8");
            if (vector[1162] && !vector[1164] && found[1366:1351] !== vector[1366:1351]) differ("fragment_attribute_9");
            if (vector[1162] && !vector[1164] && found[1382:1367] !== vector[1382:1367]) differ("fragment_attribute_10");
            if (vector[1162] && !vector[1164] && found[1398:1383] !== vector[1398:1383]) differ("fragment_attribute_11");
            if (vector[1162] && !vector[1164] && found[1414:1399] !== vector[1414:1399]) differ("fragment_attribute_12");
            if (vector[1162] && !vector[1164] && found[1430:1415] !== vector[1430:1415]) differ("fragment_cardinal_0");
            if (found[1431] !== vector[1431]) differ("event_sample");
            if (found[1432] !== vector[1432]) differ("event_starved");
            if (found[1433] !== vector[1433]) differ("event_blocked");
            if (found[1434] !== vector[1434]) differ("event_accumulate");
            if (found[1435] !== vector[1435]) differ("event_hazard");
            if (found[1436] !== vector[1436]) differ("event_slot_wait");
            @(negedge clk);
        end
        if (differences != 0) $fatal(1, "FAILED");
        $display("PASSED: 125618 cycles, 9738 items, every output as the model's");
        $finish;
    end
endmodule
