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

// 218943 cycles of splat_top, which 21360 items leave.
module splat_top_replay(output reg passed = 1'b0);
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [63:0] words [0:124614];
    reg [821:0] vector = 0;
    reg [821:0] next = 0;
    wire [821:0] found;
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
        .splat_attribute_0(vector[31] ? vector[261:250] : ~vector[261:250]),
        .splat_attribute_1(vector[31] ? vector[273:262] : ~vector[273:262]),
        .splat_attribute_2(vector[31] ? vector[285:274] : ~vector[285:274]),
        .frame_set_up(found[286]),
        .read_valid(found[287]),
        .read_ready(vector[288]),
        .read_surface(found[289]),
        .read_tile(found[301:290]),
        .read_pixel(found[307:302]),
        .read_count(found[311:308]),
        .data_valid(vector[312]),
        .data_ready(found[313]),
        .data_weight(vector[312] ? vector[341:314] : ~vector[341:314]),
        .data_depth(vector[312] ? vector[393:342] : ~vector[393:342]),
        .data_attribute_0(vector[312] ? vector[433:394] : ~vector[433:394]),
        .data_attribute_1(vector[312] ? vector[473:434] : ~vector[473:434]),
        .data_attribute_2(vector[312] ? vector[513:474] : ~vector[513:474]),
        .write_valid(found[514]),
        .write_ready(vector[515]),
        .write_surface(found[516]),
        .write_tile(found[528:517]),
        .write_pixel(found[534:529]),
        .write_weight(found[562:535]),
        .write_depth(found[614:563]),
        .write_attribute_0(found[654:615]),
        .write_attribute_1(found[694:655]),
        .write_attribute_2(found[734:695]),
        .fragment_valid(found[735]),
        .fragment_ready(vector[736]),
        .fragment_end(found[737]),
        .fragment_column(found[746:738]),
        .fragment_row(found[755:747]),
        .fragment_depth(found[779:756]),
        .fragment_attribute_0(found[791:780]),
        .fragment_attribute_1(found[803:792]),
        .fragment_attribute_2(found[815:804]),
        .event_sample(found[816]),
        .event_starved(found[817]),
        .event_blocked(found[818]),
        .event_accumulate(found[819]),
        .event_hazard(found[820]),
        .event_slot_wait(found[821])
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
            if (changed[0]) begin take(0, 1); take(1, 1); take(31, 1); take(32, 1); take(286, 1); take(287, 1); take(288, 1); take(312, 1); take(313, 1); take(514, 1); take(515, 1); take(735, 1); take(736, 1); take(816, 1); take(817, 1); take(818, 1); take(819, 1); take(820, 1); take(821, 1); end
            if (changed[1]) begin take(2, 5); take(7, 24); end
            if (changed[2]) begin take(33, 1); take(34, 24); take(58, 24); take(82, 24); take(106, 24); take(130, 24); take(154, 24); take(178, 24); take(202, 24); take(226, 24); take(250, 12); take(262, 12); take(274, 12); end
            if (changed[3]) begin take(289, 1); take(290, 12); take(302, 6); take(308, 4); end
            if (changed[4]) begin take(314, 28); take(342, 52); take(394, 40); take(434, 40); take(474, 40); end
            if (changed[5]) begin take(516, 1); take(517, 12); take(529, 6); take(535, 28); take(563, 52); take(615, 40); take(655, 40); take(695, 40); end
            if (changed[6]) begin take(737, 1); take(738, 9); take(747, 9); take(756, 24); take(780, 12); take(792, 12); take(804, 12); end
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
        for (cycle = 0; cycle < 218943 && differences == 0; cycle = cycle + 1) begin
            advance;
            #4;
            if (found[32] !== vector[32]) differ("splat_ready");
            if (found[286] !== vector[286]) differ("frame_set_up");
            if (found[287] !== vector[287]) differ("read_valid");
            if (vector[287] && found[289] !== vector[289]) differ("read_surface");
            if (vector[287] && found[301:290] !== vector[301:290]) differ("read_tile");
            if (vector[287] && found[307:302] !== vector[307:302]) differ("read_pixel");
            if (vector[287] && found[311:308] !== vector[311:308]) differ("read_count");
            if (found[313] !== vector[313]) differ("data_ready");
            if (found[514] !== vector[514]) differ("write_valid");
            if (vector[514] && found[516] !== vector[516]) differ("write_surface");
            if (vector[514] && found[528:517] !== vector[528:517]) differ("write_tile");
            if (vector[514] && found[534:529] !== vector[534:529]) differ("write_pixel");
            if (vector[514] && found[562:535] !== vector[562:535]) differ("write_weight");
            if (vector[514] && found[614:563] !== vector[614:563]) differ("write_depth");
            if (vector[514] && found[654:615] !== vector[654:615]) differ("write_attribute_0");
            if (vector[514] && found[694:655] !== vector[694:655]) differ("write_attribute_1");
            if (vector[514] && found[734:695] !== vector[734:695]) differ("write_attribute_2");
            if (found[735] !== vector[735]) differ("fragment_valid");
            if (vector[735] && found[737] !== vector[737]) differ("fragment_end");
            if (vector[735] && !vector[737] && found[746:738] !== vector[746:738]) differ("fragment_column");
            if (vector[735] && !vector[737] && found[755:747] !== vector[755:747]) differ("fragment_row");
            if (vector[735] && !vector[737] && found[779:756] !== vector[779:756]) differ("fragment_depth");
            if (vector[735] && !vector[737] && found[791:780] !== vector[791:780]) differ("fragment_attribute_0");
            if (vector[735] && !vector[737] && found[803:792] !== vector[803:792]) differ("fragment_attribute_1");
            if (vector[735] && !vector[737] && found[815:804] !== vector[815:804]) differ("fragment_attribute_2");
            if (found[816] !== vector[816]) differ("event_sample");
            if (found[817] !== vector[817]) differ("event_starved");
            if (found[818] !== vector[818]) differ("event_blocked");
            if (found[819] !== vector[819]) differ("event_accumulate");
            if (found[820] !== vector[820]) differ("event_hazard");
            if (found[821] !== vector[821]) differ("event_slot_wait");
            @(negedge clk);
        end
        if (differences != 0) $fatal(1, "FAILED");
        $display("splat_top: 218943 cycles, 21360 items, every output as the model's");
        passed = 1'b1;
    end
endmodule

// 68177 cycles of splat_setup, which 2140 items leave.
module splat_setup_replay(output reg passed = 1'b0);
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [63:0] words [0:36575];
    reg [897:0] vector = 0;
    reg [897:0] next = 0;
    wire [897:0] found;
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
        .in_attribute_0(vector[1] ? vector[231:220] : ~vector[231:220]),
        .in_attribute_1(vector[1] ? vector[243:232] : ~vector[243:232]),
        .in_attribute_2(vector[1] ? vector[255:244] : ~vector[255:244]),
        .near_plane(vector[873:850]),
        .filter_radius(vector[897:874]),
        .depth_a(vector[777:754]),
        .depth_b(vector[801:778]),
        .epsilon_scale(vector[825:802]),
        .epsilon_bias(vector[849:826]),
        .scale_x(vector[681:658]),
        .origin_x(vector[729:706]),
        .scale_y(vector[705:682]),
        .origin_y(vector[753:730]),
        .out_valid(found[256]),
        .out_ready(vector[257]),
        .out_end(found[258]),
        .out_center_x(found[284:259]),
        .out_center_y(found[310:285]),
        .out_ax(found[326:311]),
        .out_bx(found[342:327]),
        .out_ay(found[358:343]),
        .out_by(found[374:359]),
        .out_delta(found[394:375]),
        .out_mx(found[410:395]),
        .out_my(found[426:411]),
        .out_shift(found[430:427]),
        .out_sight_negative(found[431]),
        .out_sight_near(found[451:432]),
        .out_sight_far(found[471:452]),
        .out_sight_turned(found[472]),
        .out_sight_disc(found[473]),
        .out_depth(found[497:474]),
        .out_depth_low(found[521:498]),
        .out_depth_high(found[545:522]),
        .out_attribute_0(found[557:546]),
        .out_attribute_1(found[569:558]),
        .out_attribute_2(found[581:570]),
        .out_left(found[590:582]),
        .out_right(found[599:591]),
        .out_top(found[608:600]),
        .out_bottom(found[617:609]),
        .out_first_sum(found[627:618]),
        .out_last_sum(found[637:628]),
        .out_first_difference(found[647:638]),
        .out_last_difference(found[657:648])
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
            if (changed[0]) begin take(0, 1); take(1, 1); take(2, 1); take(256, 1); take(257, 1); end
            if (changed[1]) begin take(658, 24); take(682, 24); take(706, 24); take(730, 24); take(754, 24); take(778, 24); take(802, 24); take(826, 24); take(850, 24); take(874, 24); end
            if (changed[2]) begin take(3, 1); take(4, 24); take(28, 24); take(52, 24); take(76, 24); take(100, 24); take(124, 24); take(148, 24); take(172, 24); take(196, 24); take(220, 12); take(232, 12); take(244, 12); end
            if (changed[3]) begin take(258, 1); take(259, 26); take(285, 26); take(311, 16); take(327, 16); take(343, 16); take(359, 16); take(375, 20); take(395, 16); take(411, 16); take(427, 4); take(431, 1); take(432, 20); take(452, 20); take(472, 1); take(473, 1); take(474, 24); take(498, 24); take(522, 24); take(546, 12); take(558, 12); take(570, 12); take(582, 9); take(591, 9); take(600, 9); take(609, 9); take(618, 10); take(628, 10); take(638, 10); take(648, 10); end
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
        for (cycle = 0; cycle < 68177 && differences == 0; cycle = cycle + 1) begin
            advance;
            #4;
            if (found[2] !== vector[2]) differ("in_ready");
            if (found[256] !== vector[256]) differ("out_valid");
            if (vector[256] && found[258] !== vector[258]) differ("out_end");
            if (vector[256] && !vector[258] && found[284:259] !== vector[284:259]) differ("out_center_x");
            if (vector[256] && !vector[258] && found[310:285] !== vector[310:285]) differ("out_center_y");
            if (vector[256] && !vector[258] && found[326:311] !== vector[326:311]) differ("out_ax");
            if (vector[256] && !vector[258] && found[342:327] !== vector[342:327]) differ("out_bx");
            if (vector[256] && !vector[258] && found[358:343] !== vector[358:343]) differ("out_ay");
            if (vector[256] && !vector[258] && found[374:359] !== vector[374:359]) differ("out_by");
            if (vector[256] && !vector[258] && found[394:375] !== vector[394:375]) differ("out_delta");
            if (vector[256] && !vector[258] && found[410:395] !== vector[410:395]) differ("out_mx");
            if (vector[256] && !vector[258] && found[426:411] !== vector[426:411]) differ("out_my");
            if (vector[256] && !vector[258] && found[430:427] !== vector[430:427]) differ("out_shift");
            if (vector[256] && !vector[258] && found[431] !== vector[431]) differ("out_sight_negative");
            if (vector[256] && !vector[258] && found[451:432] !== vector[451:432]) differ("out_sight_near");
            if (vector[256] && !vector[258] && found[471:452] !== vector[471:452]) differ("out_sight_far");
            if (vector[256] && !vector[258] && found[472] !== vector[472]) differ("out_sight_turned");
            if (vector[256] && !vector[258] && found[473] !== vector[473]) differ("out_sight_disc");
            if (vector[256] && !vector[258] && found[497:474] !== vector[497:474]) differ("out_depth");
            if (vector[256] && !vector[258] && found[521:498] !== vector[521:498]) differ("out_depth_low");
            if (vector[256] && !vector[258] && found[545:522] !== vector[545:522]) differ("out_depth_high");
            if (vector[256] && !vector[258] && found[557:546] !== vector[557:546]) differ("out_attribute_0");
            if (vector[256] && !vector[258] && found[569:558] !== vector[569:558]) differ("out_attribute_1");
            if (vector[256] && !vector[258] && found[581:570] !== vector[581:570]) differ("out_attribute_2");
            if (vector[256] && !vector[258] && found[590:582] !== vector[590:582]) differ("out_left");
            if (vector[256] && !vector[258] && found[599:591] !== vector[599:591]) differ("out_right");
            if (vector[256] && !vector[258] && found[608:600] !== vector[608:600]) differ("out_top");
            if (vector[256] && !vector[258] && found[617:609] !== vector[617:609]) differ("out_bottom");
            if (vector[256] && !vector[258] && found[627:618] !== vector[627:618]) differ("out_first_sum");
            if (vector[256] && !vector[258] && found[637:628] !== vector[637:628]) differ("out_last_sum");
            if (vector[256] && !vector[258] && found[647:638] !== vector[647:638]) differ("out_first_difference");
            if (vector[256] && !vector[258] && found[657:648] !== vector[657:648]) differ("out_last_difference");
            @(negedge clk);
        end
        if (differences != 0) $fatal(1, "FAILED");
        $display("splat_setup: 68177 cycles, 2140 items, every output as the model's");
        passed = 1'b1;
    end
endmodule

// 1327 cycles of splat_operators, which 1302 items leave.
module splat_operators_replay(output reg passed = 1'b0);
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [63:0] words [0:8988];
    reg [504:0] vector = 0;
    reg [504:0] next = 0;
    wire [504:0] found;
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
        .results_to_fixed_s27q13_12(found[337:311]),
        .results_to_fixed_s17q16_13(found[354:338]),
        .results_to_fixed_s21q20_14(found[375:355]),
        .results_to_fixed_u20q19_15(found[395:376]),
        .results_to_fixed_u24q24_16(found[419:396]),
        .results_from_fixed_u28q16_17(found[443:420]),
        .results_from_fixed_u52q40_18(found[467:444]),
        .results_from_fixed_s40q27_19(found[491:468]),
        .results_to_fixed_s13q12_20(found[504:492])
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
            if (changed[2]) begin take(75, 24); take(99, 24); take(123, 1); take(124, 24); take(148, 24); take(172, 24); take(196, 24); take(220, 1); take(221, 24); take(245, 21); take(266, 23); take(289, 22); take(311, 27); take(338, 17); take(355, 21); take(376, 20); take(396, 24); take(420, 24); take(444, 24); take(468, 24); take(492, 13); end
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
        for (cycle = 0; cycle < 1327 && differences == 0; cycle = cycle + 1) begin
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
            if (vector[74] && found[337:311] !== vector[337:311]) differ("results_to_fixed_s27q13_12");
            if (vector[74] && found[354:338] !== vector[354:338]) differ("results_to_fixed_s17q16_13");
            if (vector[74] && found[375:355] !== vector[375:355]) differ("results_to_fixed_s21q20_14");
            if (vector[74] && found[395:376] !== vector[395:376]) differ("results_to_fixed_u20q19_15");
            if (vector[74] && found[419:396] !== vector[419:396]) differ("results_to_fixed_u24q24_16");
            if (vector[74] && found[443:420] !== vector[443:420]) differ("results_from_fixed_u28q16_17");
            if (vector[74] && found[467:444] !== vector[467:444]) differ("results_from_fixed_u52q40_18");
            if (vector[74] && found[491:468] !== vector[491:468]) differ("results_from_fixed_s40q27_19");
            if (vector[74] && found[504:492] !== vector[504:492]) differ("results_to_fixed_s13q12_20");
            @(negedge clk);
        end
        if (differences != 0) $fatal(1, "FAILED");
        $display("splat_operators: 1327 cycles, 1302 items, every output as the model's");
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
    output wire [26:0] results_to_fixed_s27q13_12, output wire [16:0] results_to_fixed_s17q16_13,
    output wire [20:0] results_to_fixed_s21q20_14, output wire [19:0] results_to_fixed_u20q19_15,
    output wire [23:0] results_to_fixed_u24q24_16, output wire [23:0] results_from_fixed_u28q16_17,
    output wire [23:0] results_from_fixed_u52q40_18, output wire [23:0] results_from_fixed_s40q27_19,
    output wire [12:0] results_to_fixed_s13q12_20
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
    float_to_fixed_s3_f24ftz_w27_f13_signed to_fixed_s27q13_12 (.clk(clk), .enable(enable), .a(a), .y(results_to_fixed_s27q13_12));
    float_to_fixed_s3_f24ftz_w17_f16_signed to_fixed_s17q16_13 (.clk(clk), .enable(enable), .a(a), .y(results_to_fixed_s17q16_13));
    float_to_fixed_s3_f24ftz_w21_f20_signed to_fixed_s21q20_14 (.clk(clk), .enable(enable), .a(a), .y(results_to_fixed_s21q20_14));
    float_to_fixed_s3_f24ftz_w20_f19_unsigned to_fixed_u20q19_15 (.clk(clk), .enable(enable), .a(a), .y(results_to_fixed_u20q19_15));
    float_to_fixed_s3_f24ftz_w24_f24_unsigned to_fixed_u24q24_16 (.clk(clk), .enable(enable), .a(a), .y(results_to_fixed_u24q24_16));

    float_from_fixed_s4_f24ftz_w28_f16_unsigned from_fixed_u28q16_17 (
        .clk(clk), .enable(enable), .a({b[3:0], a}), .y(results_from_fixed_u28q16_17)
    );

    float_from_fixed_s4_f24ftz_w52_f40_unsigned from_fixed_u52q40_18 (
        .clk(clk), .enable(enable), .a({c[3:0], b, a}), .y(results_from_fixed_u52q40_18)
    );

    float_from_fixed_s5_f24ftz_w40_f27_signed from_fixed_s40q27_19 (
        .clk(clk), .enable(enable), .a({b[15:0], a}), .y(results_from_fixed_s40q27_19)
    );

    float_to_fixed_s3_f24ftz_w13_f12_signed to_fixed_s13q12_20 (.clk(clk), .enable(enable), .a(a), .y(results_to_fixed_s13q12_20));

    always @(posedge clk) begin
        if (rst) taken <= 5'd0;
        else taken <= (enable & ~valid) ? (taken + 5'd1) : taken;
    end

    wire _unused = &{1'b0, c[23:4]};
endmodule
