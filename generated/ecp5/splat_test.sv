// Written by pointcore 0.1.0; do not edit.
// Replays 1102 cycles of the bit-exact model at the ports of splat_top, in which 569 items leave the core, and compares every output in every
// cycle; a stream's fields count while it is valid. For Verilator, whose registers start at random values: in a simulator with unknown
// values, what is not reset stays unknown longer than in hardware.

module splat_test;
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [1424:0] vectors [0:1101];
    reg [1424:0] vector = 0;
    wire [1424:0] found;
    integer cycle;
    integer differences = 0;

    splat_top core (
        .clk(clk),
        .rst(rst),
        .uniform_valid(vector[1]),
        .uniform_address(vector[6:2]),
        .uniform_data(vector[30:7]),
        .splat_valid(vector[31]),
        .splat_ready(found[32]),
        .splat_end(vector[33]),
        .splat_center_x(vector[57:34]),
        .splat_center_y(vector[81:58]),
        .splat_center_z(vector[105:82]),
        .splat_tangent1_x(vector[129:106]),
        .splat_tangent1_y(vector[153:130]),
        .splat_tangent1_z(vector[177:154]),
        .splat_tangent2_x(vector[201:178]),
        .splat_tangent2_y(vector[225:202]),
        .splat_tangent2_z(vector[249:226]),
        .splat_attribute_0(vector[265:250]),
        .splat_attribute_1(vector[281:266]),
        .splat_attribute_2(vector[297:282]),
        .splat_attribute_3(vector[313:298]),
        .splat_attribute_4(vector[329:314]),
        .splat_attribute_5(vector[345:330]),
        .splat_attribute_6(vector[361:346]),
        .splat_attribute_7(vector[377:362]),
        .splat_attribute_8(vector[393:378]),
        .splat_attribute_9(vector[409:394]),
        .splat_attribute_10(vector[425:410]),
        .splat_attribute_11(vector[441:426]),
        .splat_attribute_12(vector[457:442]),
        .splat_cardinal_0(vector[473:458]),
        .read_valid(found[474]),
        .read_ready(vector[475]),
        .read_tile(found[487:476]),
        .data_valid(vector[488]),
        .data_ready(found[489]),
        .data_weight(vector[517:490]),
        .data_depth(vector[569:518]),
        .data_peak(vector[585:570]),
        .data_attribute_0(vector[601:586]),
        .data_attribute_1(vector[617:602]),
        .data_attribute_2(vector[633:618]),
        .data_attribute_3(vector[649:634]),
        .data_attribute_4(vector[665:650]),
        .data_attribute_5(vector[681:666]),
        .data_attribute_6(vector[697:682]),
        .data_attribute_7(vector[713:698]),
        .data_attribute_8(vector[729:714]),
        .data_attribute_9(vector[745:730]),
        .data_attribute_10(vector[761:746]),
        .data_attribute_11(vector[777:762]),
        .data_attribute_12(vector[793:778]),
        .data_cardinal_0(vector[809:794]),
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

    task differ(input [8*32-1:0] port);
        begin
            differences = differences + 1;
            $display("cycle %0d: %0s differs from the model", cycle, port);
        end
    endtask

    initial begin
        $readmemh("splat_test.hex", vectors);
        repeat (2) @(negedge clk);
        rst = 1'b0;
        repeat (4104) @(negedge clk);
        for (cycle = 0; cycle < 1102 && differences == 0; cycle = cycle + 1) begin
            vector = vectors[cycle];
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
        $display("PASSED: 1102 cycles, 569 items, every output as the model's");
        $finish;
    end
endmodule
