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

// 215927 cycles of splat_top, which 22623 items leave.
module splat_top_replay(output reg passed = 1'b0);
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [63:0] words [0:146874];
    reg [989:0] vector = 0;
    reg [989:0] next = 0;
    wire [989:0] found;
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
        .splat_cardinal_0(vector[31] ? vector[361:346] : ~vector[361:346]),
        .frame_set_up(found[362]),
        .read_valid(found[363]),
        .read_ready(vector[364]),
        .read_surface(found[365]),
        .read_tile(found[377:366]),
        .read_pixel(found[383:378]),
        .read_count(found[387:384]),
        .data_valid(vector[388]),
        .data_ready(found[389]),
        .data_weight(vector[388] ? vector[417:390] : ~vector[417:390]),
        .data_depth(vector[388] ? vector[469:418] : ~vector[469:418]),
        .data_peak(vector[388] ? vector[485:470] : ~vector[485:470]),
        .data_attribute_0(vector[388] ? vector[501:486] : ~vector[501:486]),
        .data_attribute_1(vector[388] ? vector[517:502] : ~vector[517:502]),
        .data_attribute_2(vector[388] ? vector[533:518] : ~vector[533:518]),
        .data_attribute_3(vector[388] ? vector[549:534] : ~vector[549:534]),
        .data_attribute_4(vector[388] ? vector[565:550] : ~vector[565:550]),
        .data_attribute_5(vector[388] ? vector[581:566] : ~vector[581:566]),
        .data_cardinal_0(vector[388] ? vector[597:582] : ~vector[597:582]),
        .write_valid(found[598]),
        .write_ready(vector[599]),
        .write_surface(found[600]),
        .write_tile(found[612:601]),
        .write_pixel(found[618:613]),
        .write_weight(found[646:619]),
        .write_depth(found[698:647]),
        .write_peak(found[714:699]),
        .write_attribute_0(found[730:715]),
        .write_attribute_1(found[746:731]),
        .write_attribute_2(found[762:747]),
        .write_attribute_3(found[778:763]),
        .write_attribute_4(found[794:779]),
        .write_attribute_5(found[810:795]),
        .write_cardinal_0(found[826:811]),
        .fragment_valid(found[827]),
        .fragment_ready(vector[828]),
        .fragment_end(found[829]),
        .fragment_column(found[838:830]),
        .fragment_row(found[847:839]),
        .fragment_depth(found[871:848]),
        .fragment_attribute_0(found[887:872]),
        .fragment_attribute_1(found[903:888]),
        .fragment_attribute_2(found[919:904]),
        .fragment_attribute_3(found[935:920]),
        .fragment_attribute_4(found[951:936]),
        .fragment_attribute_5(found[967:952]),
        .fragment_cardinal_0(found[983:968]),
        .event_sample(found[984]),
        .event_starved(found[985]),
        .event_blocked(found[986]),
        .event_accumulate(found[987]),
        .event_hazard(found[988]),
        .event_slot_wait(found[989])
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
            if (changed[0]) begin take(0, 1); take(1, 1); take(31, 1); take(32, 1); take(362, 1); take(363, 1); take(364, 1); take(388, 1); take(389, 1); take(598, 1); take(599, 1); take(827, 1); take(828, 1); take(984, 1); take(985, 1); take(986, 1); take(987, 1); take(988, 1); take(989, 1); end
            if (changed[1]) begin take(2, 5); take(7, 24); end
            if (changed[2]) begin take(33, 1); take(34, 24); take(58, 24); take(82, 24); take(106, 24); take(130, 24); take(154, 24); take(178, 24); take(202, 24); take(226, 24); take(250, 16); take(266, 16); take(282, 16); take(298, 16); take(314, 16); take(330, 16); take(346, 16); end
            if (changed[3]) begin take(365, 1); take(366, 12); take(378, 6); take(384, 4); end
            if (changed[4]) begin take(390, 28); take(418, 52); take(470, 16); take(486, 16); take(502, 16); take(518, 16); take(534, 16); take(550, 16); take(566, 16); take(582, 16); end
            if (changed[5]) begin take(600, 1); take(601, 12); take(613, 6); take(619, 28); take(647, 52); take(699, 16); take(715, 16); take(731, 16); take(747, 16); take(763, 16); take(779, 16); take(795, 16); take(811, 16); end
            if (changed[6]) begin take(829, 1); take(830, 9); take(839, 9); take(848, 24); take(872, 16); take(888, 16); take(904, 16); take(920, 16); take(936, 16); take(952, 16); take(968, 16); end
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
        for (cycle = 0; cycle < 215927 && differences == 0; cycle = cycle + 1) begin
            advance;
            #4;
            if (found[32] !== vector[32]) differ("splat_ready");
            if (found[362] !== vector[362]) differ("frame_set_up");
            if (found[363] !== vector[363]) differ("read_valid");
            if (vector[363] && found[365] !== vector[365]) differ("read_surface");
            if (vector[363] && found[377:366] !== vector[377:366]) differ("read_tile");
            if (vector[363] && found[383:378] !== vector[383:378]) differ("read_pixel");
            if (vector[363] && found[387:384] !== vector[387:384]) differ("read_count");
            if (found[389] !== vector[389]) differ("data_ready");
            if (found[598] !== vector[598]) differ("write_valid");
            if (vector[598] && found[600] !== vector[600]) differ("write_surface");
            if (vector[598] && found[612:601] !== vector[612:601]) differ("write_tile");
            if (vector[598] && found[618:613] !== vector[618:613]) differ("write_pixel");
            if (vector[598] && found[646:619] !== vector[646:619]) differ("write_weight");
            if (vector[598] && found[698:647] !== vector[698:647]) differ("write_depth");
            if (vector[598] && found[714:699] !== vector[714:699]) differ("write_peak");
            if (vector[598] && found[730:715] !== vector[730:715]) differ("write_attribute_0");
            if (vector[598] && found[746:731] !== vector[746:731]) differ("write_attribute_1");
            if (vector[598] && found[762:747] !== vector[762:747]) differ("write_attribute_2");
            if (vector[598] && found[778:763] !== vector[778:763]) differ("write_attribute_3");
            if (vector[598] && found[794:779] !== vector[794:779]) differ("write_attribute_4");
            if (vector[598] && found[810:795] !== vector[810:795]) differ("write_attribute_5");
            if (vector[598] && found[826:811] !== vector[826:811]) differ("write_cardinal_0");
            if (found[827] !== vector[827]) differ("fragment_valid");
            if (vector[827] && found[829] !== vector[829]) differ("fragment_end");
            if (vector[827] && !vector[829] && found[838:830] !== vector[838:830]) differ("fragment_column");
            if (vector[827] && !vector[829] && found[847:839] !== vector[847:839]) differ("fragment_row");
            if (vector[827] && !vector[829] && found[871:848] !== vector[871:848]) differ("fragment_depth");
            if (vector[827] && !vector[829] && found[887:872] !== vector[887:872]) differ("fragment_attribute_0");
            if (vector[827] && !vector[829] && found[903:888] !== vector[903:888]) differ("fragment_attribute_1");
            if (vector[827] && !vector[829] && found[919:904] !== vector[919:904]) differ("fragment_attribute_2");
            if (vector[827] && !vector[829] && found[935:920] !== vector[935:920]) differ("fragment_attribute_3");
            if (vector[827] && !vector[829] && found[951:936] !== vector[951:936]) differ("fragment_attribute_4");
            if (vector[827] && !vector[829] && found[967:952] !== vector[967:952]) differ("fragment_attribute_5");
            if (vector[827] && !vector[829] && found[983:968] !== vector[983:968]) differ("fragment_cardinal_0");
            if (found[984] !== vector[984]) differ("event_sample");
            if (found[985] !== vector[985]) differ("event_starved");
            if (found[986] !== vector[986]) differ("event_blocked");
            if (found[987] !== vector[987]) differ("event_accumulate");
            if (found[988] !== vector[988]) differ("event_hazard");
            if (found[989] !== vector[989]) differ("event_slot_wait");
            @(negedge clk);
        end
        if (differences != 0) $fatal(1, "FAILED");
        $display("splat_top: 215927 cycles, 22623 items, every output as the model's");
        passed = 1'b1;
    end
endmodule

// 66207 cycles of splat_setup, which 2092 items leave.
module splat_setup_replay(output reg passed = 1'b0);
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [63:0] words [0:44316];
    reg [1099:0] vector = 0;
    reg [1099:0] next = 0;
    wire [1099:0] found;
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
        .in_cardinal_0(vector[1] ? vector[331:316] : ~vector[331:316]),
        .near_plane(vector[1075:1052]),
        .filter_radius(vector[1099:1076]),
        .depth_a(vector[979:956]),
        .depth_b(vector[1003:980]),
        .epsilon_scale(vector[1027:1004]),
        .epsilon_bias(vector[1051:1028]),
        .scale_x(vector[883:860]),
        .origin_x(vector[931:908]),
        .scale_y(vector[907:884]),
        .origin_y(vector[955:932]),
        .out_valid(found[332]),
        .out_ready(vector[333]),
        .out_end(found[334]),
        .out_center_x(found[358:335]),
        .out_center_y(found[382:359]),
        .out_ax(found[406:383]),
        .out_bx(found[430:407]),
        .out_ay(found[454:431]),
        .out_by(found[478:455]),
        .out_delta(found[502:479]),
        .out_mx(found[526:503]),
        .out_my(found[550:527]),
        .out_sight_negative(found[551]),
        .out_sight_near(found[574:552]),
        .out_sight_far(found[597:575]),
        .out_sight_turned(found[598]),
        .out_sight_disc(found[599]),
        .out_depth(found[623:600]),
        .out_depth_low(found[647:624]),
        .out_depth_high(found[671:648]),
        .out_attribute_0(found[687:672]),
        .out_attribute_1(found[703:688]),
        .out_attribute_2(found[719:704]),
        .out_attribute_3(found[735:720]),
        .out_attribute_4(found[751:736]),
        .out_attribute_5(found[767:752]),
        .out_cardinal_0(found[783:768]),
        .out_left(found[792:784]),
        .out_right(found[801:793]),
        .out_top(found[810:802]),
        .out_bottom(found[819:811]),
        .out_first_sum(found[829:820]),
        .out_last_sum(found[839:830]),
        .out_first_difference(found[849:840]),
        .out_last_difference(found[859:850])
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
            if (changed[0]) begin take(0, 1); take(1, 1); take(2, 1); take(332, 1); take(333, 1); end
            if (changed[1]) begin take(860, 24); take(884, 24); take(908, 24); take(932, 24); take(956, 24); take(980, 24); take(1004, 24); take(1028, 24); take(1052, 24); take(1076, 24); end
            if (changed[2]) begin take(3, 1); take(4, 24); take(28, 24); take(52, 24); take(76, 24); take(100, 24); take(124, 24); take(148, 24); take(172, 24); take(196, 24); take(220, 16); take(236, 16); take(252, 16); take(268, 16); take(284, 16); take(300, 16); take(316, 16); end
            if (changed[3]) begin take(334, 1); take(335, 24); take(359, 24); take(383, 24); take(407, 24); take(431, 24); take(455, 24); take(479, 24); take(503, 24); take(527, 24); take(551, 1); take(552, 23); take(575, 23); take(598, 1); take(599, 1); take(600, 24); take(624, 24); take(648, 24); take(672, 16); take(688, 16); take(704, 16); take(720, 16); take(736, 16); take(752, 16); take(768, 16); take(784, 9); take(793, 9); take(802, 9); take(811, 9); take(820, 10); take(830, 10); take(840, 10); take(850, 10); end
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
        for (cycle = 0; cycle < 66207 && differences == 0; cycle = cycle + 1) begin
            advance;
            #4;
            if (found[2] !== vector[2]) differ("in_ready");
            if (found[332] !== vector[332]) differ("out_valid");
            if (vector[332] && found[334] !== vector[334]) differ("out_end");
            if (vector[332] && !vector[334] && found[358:335] !== vector[358:335]) differ("out_center_x");
            if (vector[332] && !vector[334] && found[382:359] !== vector[382:359]) differ("out_center_y");
            if (vector[332] && !vector[334] && found[406:383] !== vector[406:383]) differ("out_ax");
            if (vector[332] && !vector[334] && found[430:407] !== vector[430:407]) differ("out_bx");
            if (vector[332] && !vector[334] && found[454:431] !== vector[454:431]) differ("out_ay");
            if (vector[332] && !vector[334] && found[478:455] !== vector[478:455]) differ("out_by");
            if (vector[332] && !vector[334] && found[502:479] !== vector[502:479]) differ("out_delta");
            if (vector[332] && !vector[334] && found[526:503] !== vector[526:503]) differ("out_mx");
            if (vector[332] && !vector[334] && found[550:527] !== vector[550:527]) differ("out_my");
            if (vector[332] && !vector[334] && found[551] !== vector[551]) differ("out_sight_negative");
            if (vector[332] && !vector[334] && found[574:552] !== vector[574:552]) differ("out_sight_near");
            if (vector[332] && !vector[334] && found[597:575] !== vector[597:575]) differ("out_sight_far");
            if (vector[332] && !vector[334] && found[598] !== vector[598]) differ("out_sight_turned");
            if (vector[332] && !vector[334] && found[599] !== vector[599]) differ("out_sight_disc");
            if (vector[332] && !vector[334] && found[623:600] !== vector[623:600]) differ("out_depth");
            if (vector[332] && !vector[334] && found[647:624] !== vector[647:624]) differ("out_depth_low");
            if (vector[332] && !vector[334] && found[671:648] !== vector[671:648]) differ("out_depth_high");
            if (vector[332] && !vector[334] && found[687:672] !== vector[687:672]) differ("out_attribute_0");
            if (vector[332] && !vector[334] && found[703:688] !== vector[703:688]) differ("out_attribute_1");
            if (vector[332] && !vector[334] && found[719:704] !== vector[719:704]) differ("out_attribute_2");
            if (vector[332] && !vector[334] && found[735:720] !== vector[735:720]) differ("out_attribute_3");
            if (vector[332] && !vector[334] && found[751:736] !== vector[751:736]) differ("out_attribute_4");
            if (vector[332] && !vector[334] && found[767:752] !== vector[767:752]) differ("out_attribute_5");
            if (vector[332] && !vector[334] && found[783:768] !== vector[783:768]) differ("out_cardinal_0");
            if (vector[332] && !vector[334] && found[792:784] !== vector[792:784]) differ("out_left");
            if (vector[332] && !vector[334] && found[801:793] !== vector[801:793]) differ("out_right");
            if (vector[332] && !vector[334] && found[810:802] !== vector[810:802]) differ("out_top");
            if (vector[332] && !vector[334] && found[819:811] !== vector[819:811]) differ("out_bottom");
            if (vector[332] && !vector[334] && found[829:820] !== vector[829:820]) differ("out_first_sum");
            if (vector[332] && !vector[334] && found[839:830] !== vector[839:830]) differ("out_last_sum");
            if (vector[332] && !vector[334] && found[849:840] !== vector[849:840]) differ("out_first_difference");
            if (vector[332] && !vector[334] && found[859:850] !== vector[859:850]) differ("out_last_difference");
            @(negedge clk);
        end
        if (differences != 0) $fatal(1, "FAILED");
        $display("splat_setup: 66207 cycles, 2092 items, every output as the model's");
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

    float_from_fixed_s5_f16_w16_f16_unsigned from_fixed_u16q16_16 (
        .clk(clk), .enable(enable), .a(a[15:0]), .y(results_from_fixed_u16q16_16)
    );

    float_mul_s6_f16 mul_17 (.clk(clk), .enable(enable), .a(a[15:0]), .b(b[15:0]), .y(results_mul_17));
    float_add_s5_f16 add_18 (.clk(clk), .enable(enable), .a(a[15:0]), .b(b[15:0]), .y(results_add_18));

    float_from_fixed_s4_f24ftz_w28_f16_unsigned from_fixed_u28q16_19 (
        .clk(clk), .enable(enable), .a({b[3:0], a}), .y(results_from_fixed_u28q16_19)
    );

    float_from_fixed_s4_f24ftz_w52_f40_unsigned from_fixed_u52q40_20 (
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
