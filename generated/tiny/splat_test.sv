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

// 80648 cycles of splat_top, which 18894 items leave.
module splat_top_replay(output reg passed = 1'b0);
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [63:0] words [0:73286];
    reg [689:0] vector = 0;
    reg [689:0] next = 0;
    wire [689:0] found;
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
        .frame_set_up(found[298]),
        .read_valid(found[299]),
        .read_ready(vector[300]),
        .read_surface(found[301]),
        .read_tile(found[309:302]),
        .read_pixel(found[315:310]),
        .read_count(found[319:316]),
        .data_valid(vector[320]),
        .data_ready(found[321]),
        .data_weight(vector[320] ? vector[349:322] : ~vector[349:322]),
        .data_depth(vector[320] ? vector[401:350] : ~vector[401:350]),
        .data_attribute_0(vector[320] ? vector[417:402] : ~vector[417:402]),
        .data_attribute_1(vector[320] ? vector[433:418] : ~vector[433:418]),
        .data_attribute_2(vector[320] ? vector[449:434] : ~vector[449:434]),
        .write_valid(found[450]),
        .write_ready(vector[451]),
        .write_surface(found[452]),
        .write_tile(found[460:453]),
        .write_pixel(found[466:461]),
        .write_weight(found[494:467]),
        .write_depth(found[546:495]),
        .write_attribute_0(found[562:547]),
        .write_attribute_1(found[578:563]),
        .write_attribute_2(found[594:579]),
        .fragment_valid(found[595]),
        .fragment_ready(vector[596]),
        .fragment_end(found[597]),
        .fragment_column(found[604:598]),
        .fragment_row(found[611:605]),
        .fragment_depth(found[635:612]),
        .fragment_attribute_0(found[651:636]),
        .fragment_attribute_1(found[667:652]),
        .fragment_attribute_2(found[683:668]),
        .event_sample(found[684]),
        .event_starved(found[685]),
        .event_blocked(found[686]),
        .event_accumulate(found[687]),
        .event_hazard(found[688]),
        .event_slot_wait(found[689])
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
            if (changed[0]) begin take(0, 1); take(1, 1); take(31, 1); take(32, 1); take(298, 1); take(299, 1); take(300, 1); take(320, 1); take(321, 1); take(450, 1); take(451, 1); take(595, 1); take(596, 1); take(684, 1); take(685, 1); take(686, 1); take(687, 1); take(688, 1); take(689, 1); end
            if (changed[1]) begin take(2, 5); take(7, 24); end
            if (changed[2]) begin take(33, 1); take(34, 24); take(58, 24); take(82, 24); take(106, 24); take(130, 24); take(154, 24); take(178, 24); take(202, 24); take(226, 24); take(250, 16); take(266, 16); take(282, 16); end
            if (changed[3]) begin take(301, 1); take(302, 8); take(310, 6); take(316, 4); end
            if (changed[4]) begin take(322, 28); take(350, 52); take(402, 16); take(418, 16); take(434, 16); end
            if (changed[5]) begin take(452, 1); take(453, 8); take(461, 6); take(467, 28); take(495, 52); take(547, 16); take(563, 16); take(579, 16); end
            if (changed[6]) begin take(597, 1); take(598, 7); take(605, 7); take(612, 24); take(636, 16); take(652, 16); take(668, 16); end
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
        for (cycle = 0; cycle < 80648 && differences == 0; cycle = cycle + 1) begin
            advance;
            #4;
            if (found[32] !== vector[32]) differ("splat_ready");
            if (found[298] !== vector[298]) differ("frame_set_up");
            if (found[299] !== vector[299]) differ("read_valid");
            if (vector[299] && found[301] !== vector[301]) differ("read_surface");
            if (vector[299] && found[309:302] !== vector[309:302]) differ("read_tile");
            if (vector[299] && found[315:310] !== vector[315:310]) differ("read_pixel");
            if (vector[299] && found[319:316] !== vector[319:316]) differ("read_count");
            if (found[321] !== vector[321]) differ("data_ready");
            if (found[450] !== vector[450]) differ("write_valid");
            if (vector[450] && found[452] !== vector[452]) differ("write_surface");
            if (vector[450] && found[460:453] !== vector[460:453]) differ("write_tile");
            if (vector[450] && found[466:461] !== vector[466:461]) differ("write_pixel");
            if (vector[450] && found[494:467] !== vector[494:467]) differ("write_weight");
            if (vector[450] && found[546:495] !== vector[546:495]) differ("write_depth");
            if (vector[450] && found[562:547] !== vector[562:547]) differ("write_attribute_0");
            if (vector[450] && found[578:563] !== vector[578:563]) differ("write_attribute_1");
            if (vector[450] && found[594:579] !== vector[594:579]) differ("write_attribute_2");
            if (found[595] !== vector[595]) differ("fragment_valid");
            if (vector[595] && found[597] !== vector[597]) differ("fragment_end");
            if (vector[595] && !vector[597] && found[604:598] !== vector[604:598]) differ("fragment_column");
            if (vector[595] && !vector[597] && found[611:605] !== vector[611:605]) differ("fragment_row");
            if (vector[595] && !vector[597] && found[635:612] !== vector[635:612]) differ("fragment_depth");
            if (vector[595] && !vector[597] && found[651:636] !== vector[651:636]) differ("fragment_attribute_0");
            if (vector[595] && !vector[597] && found[667:652] !== vector[667:652]) differ("fragment_attribute_1");
            if (vector[595] && !vector[597] && found[683:668] !== vector[683:668]) differ("fragment_attribute_2");
            if (found[684] !== vector[684]) differ("event_sample");
            if (found[685] !== vector[685]) differ("event_starved");
            if (found[686] !== vector[686]) differ("event_blocked");
            if (found[687] !== vector[687]) differ("event_accumulate");
            if (found[688] !== vector[688]) differ("event_hazard");
            if (found[689] !== vector[689]) differ("event_slot_wait");
            @(negedge clk);
        end
        if (differences != 0) $fatal(1, "FAILED");
        $display("splat_top: 80648 cycles, 18894 items, every output as the model's");
        passed = 1'b1;
    end
endmodule

// 97701 cycles of splat_setup, which 1757 items leave.
module splat_setup_replay(output reg passed = 1'b0);
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [63:0] words [0:33350];
    reg [856:0] vector = 0;
    reg [856:0] next = 0;
    wire [856:0] found;
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
        .filter_radius(vector[856:833]),
        .depth_a(vector[760:737]),
        .depth_b(vector[784:761]),
        .epsilon_scale(vector[808:785]),
        .epsilon_bias(vector[832:809]),
        .scale_x(vector[664:641]),
        .origin_x(vector[712:689]),
        .scale_y(vector[688:665]),
        .origin_y(vector[736:713]),
        .out_valid(found[268]),
        .out_ready(vector[269]),
        .out_end(found[270]),
        .out_center_x(found[298:271]),
        .out_center_y(found[326:299]),
        .out_ax(found[344:327]),
        .out_bx(found[362:345]),
        .out_ay(found[380:363]),
        .out_by(found[398:381]),
        .out_delta(found[420:399]),
        .out_mx(found[438:421]),
        .out_my(found[456:439]),
        .out_shift(found[460:457]),
        .out_depth(found[484:461]),
        .out_depth_low(found[508:485]),
        .out_depth_high(found[532:509]),
        .out_attribute_0(found[548:533]),
        .out_attribute_1(found[564:549]),
        .out_attribute_2(found[580:565]),
        .out_left(found[587:581]),
        .out_right(found[594:588]),
        .out_top(found[601:595]),
        .out_bottom(found[608:602]),
        .out_first_sum(found[616:609]),
        .out_last_sum(found[624:617]),
        .out_first_difference(found[632:625]),
        .out_last_difference(found[640:633])
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
            if (changed[0]) begin take(0, 1); take(1, 1); take(2, 1); take(268, 1); take(269, 1); end
            if (changed[1]) begin take(641, 24); take(665, 24); take(689, 24); take(713, 24); take(737, 24); take(761, 24); take(785, 24); take(809, 24); take(833, 24); end
            if (changed[2]) begin take(3, 1); take(4, 24); take(28, 24); take(52, 24); take(76, 24); take(100, 24); take(124, 24); take(148, 24); take(172, 24); take(196, 24); take(220, 16); take(236, 16); take(252, 16); end
            if (changed[3]) begin take(270, 1); take(271, 28); take(299, 28); take(327, 18); take(345, 18); take(363, 18); take(381, 18); take(399, 22); take(421, 18); take(439, 18); take(457, 4); take(461, 24); take(485, 24); take(509, 24); take(533, 16); take(549, 16); take(565, 16); take(581, 7); take(588, 7); take(595, 7); take(602, 7); take(609, 8); take(617, 8); take(625, 8); take(633, 8); end
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
        for (cycle = 0; cycle < 97701 && differences == 0; cycle = cycle + 1) begin
            advance;
            #4;
            if (found[2] !== vector[2]) differ("in_ready");
            if (found[268] !== vector[268]) differ("out_valid");
            if (vector[268] && found[270] !== vector[270]) differ("out_end");
            if (vector[268] && !vector[270] && found[298:271] !== vector[298:271]) differ("out_center_x");
            if (vector[268] && !vector[270] && found[326:299] !== vector[326:299]) differ("out_center_y");
            if (vector[268] && !vector[270] && found[344:327] !== vector[344:327]) differ("out_ax");
            if (vector[268] && !vector[270] && found[362:345] !== vector[362:345]) differ("out_bx");
            if (vector[268] && !vector[270] && found[380:363] !== vector[380:363]) differ("out_ay");
            if (vector[268] && !vector[270] && found[398:381] !== vector[398:381]) differ("out_by");
            if (vector[268] && !vector[270] && found[420:399] !== vector[420:399]) differ("out_delta");
            if (vector[268] && !vector[270] && found[438:421] !== vector[438:421]) differ("out_mx");
            if (vector[268] && !vector[270] && found[456:439] !== vector[456:439]) differ("out_my");
            if (vector[268] && !vector[270] && found[460:457] !== vector[460:457]) differ("out_shift");
            if (vector[268] && !vector[270] && found[484:461] !== vector[484:461]) differ("out_depth");
            if (vector[268] && !vector[270] && found[508:485] !== vector[508:485]) differ("out_depth_low");
            if (vector[268] && !vector[270] && found[532:509] !== vector[532:509]) differ("out_depth_high");
            if (vector[268] && !vector[270] && found[548:533] !== vector[548:533]) differ("out_attribute_0");
            if (vector[268] && !vector[270] && found[564:549] !== vector[564:549]) differ("out_attribute_1");
            if (vector[268] && !vector[270] && found[580:565] !== vector[580:565]) differ("out_attribute_2");
            if (vector[268] && !vector[270] && found[587:581] !== vector[587:581]) differ("out_left");
            if (vector[268] && !vector[270] && found[594:588] !== vector[594:588]) differ("out_right");
            if (vector[268] && !vector[270] && found[601:595] !== vector[601:595]) differ("out_top");
            if (vector[268] && !vector[270] && found[608:602] !== vector[608:602]) differ("out_bottom");
            if (vector[268] && !vector[270] && found[616:609] !== vector[616:609]) differ("out_first_sum");
            if (vector[268] && !vector[270] && found[624:617] !== vector[624:617]) differ("out_last_sum");
            if (vector[268] && !vector[270] && found[632:625] !== vector[632:625]) differ("out_first_difference");
            if (vector[268] && !vector[270] && found[640:633] !== vector[640:633]) differ("out_last_difference");
            @(negedge clk);
        end
        if (differences != 0) $fatal(1, "FAILED");
        $display("splat_setup: 97701 cycles, 1757 items, every output as the model's");
        passed = 1'b1;
    end
endmodule

// 2647 cycles of splat_operators, which 2622 items leave.
module splat_operators_replay(output reg passed = 1'b0);
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [63:0] words [0:19379];
    reg [541:0] vector = 0;
    reg [541:0] next = 0;
    wire [541:0] found;
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
        .results_recip_3(found[147:124]),
        .results_mul_4(found[171:148]),
        .results_sqrt_5(found[195:172]),
        .results_le_6(found[196]),
        .results_min_7(found[220:197]),
        .results_max_8(found[244:221]),
        .results_to_fixed_u21q8_9(found[265:245]),
        .results_to_fixed_u23q8_10(found[288:266]),
        .results_to_fixed_s22q8_11(found[310:289]),
        .results_to_fixed_s29q15_12(found[339:311]),
        .results_to_fixed_s19q18_13(found[358:340]),
        .results_to_fixed_s23q22_14(found[381:359]),
        .results_to_fixed_u24q24_15(found[405:382]),
        .results_from_fixed_u16q16_16(found[421:406]),
        .results_mul_17(found[437:422]),
        .results_add_18(found[453:438]),
        .results_from_fixed_u28q16_19(found[477:454]),
        .results_from_fixed_u52q40_20(found[501:478]),
        .results_convert_f24_ftz_21(found[525:502]),
        .results_convert_f16_22(found[541:526])
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
            if (changed[2]) begin take(75, 24); take(99, 24); take(123, 1); take(124, 24); take(148, 24); take(172, 24); take(196, 1); take(197, 24); take(221, 24); take(245, 21); take(266, 23); take(289, 22); take(311, 29); take(340, 19); take(359, 23); take(382, 24); take(406, 16); take(422, 16); take(438, 16); take(454, 24); take(478, 24); take(502, 24); take(526, 16); end
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
            if (vector[74] && found[147:124] !== vector[147:124]) differ("results_recip_3");
            if (vector[74] && found[171:148] !== vector[171:148]) differ("results_mul_4");
            if (vector[74] && found[195:172] !== vector[195:172]) differ("results_sqrt_5");
            if (vector[74] && found[196] !== vector[196]) differ("results_le_6");
            if (vector[74] && found[220:197] !== vector[220:197]) differ("results_min_7");
            if (vector[74] && found[244:221] !== vector[244:221]) differ("results_max_8");
            if (vector[74] && found[265:245] !== vector[265:245]) differ("results_to_fixed_u21q8_9");
            if (vector[74] && found[288:266] !== vector[288:266]) differ("results_to_fixed_u23q8_10");
            if (vector[74] && found[310:289] !== vector[310:289]) differ("results_to_fixed_s22q8_11");
            if (vector[74] && found[339:311] !== vector[339:311]) differ("results_to_fixed_s29q15_12");
            if (vector[74] && found[358:340] !== vector[358:340]) differ("results_to_fixed_s19q18_13");
            if (vector[74] && found[381:359] !== vector[381:359]) differ("results_to_fixed_s23q22_14");
            if (vector[74] && found[405:382] !== vector[405:382]) differ("results_to_fixed_u24q24_15");
            if (vector[74] && found[421:406] !== vector[421:406]) differ("results_from_fixed_u16q16_16");
            if (vector[74] && found[437:422] !== vector[437:422]) differ("results_mul_17");
            if (vector[74] && found[453:438] !== vector[453:438]) differ("results_add_18");
            if (vector[74] && found[477:454] !== vector[477:454]) differ("results_from_fixed_u28q16_19");
            if (vector[74] && found[501:478] !== vector[501:478]) differ("results_from_fixed_u52q40_20");
            if (vector[74] && found[525:502] !== vector[525:502]) differ("results_convert_f24_ftz_21");
            if (vector[74] && found[541:526] !== vector[541:526]) differ("results_convert_f16_22");
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
    output wire results_lt_2, output wire [23:0] results_recip_3, output wire [23:0] results_mul_4,
    output wire [23:0] results_sqrt_5, output wire results_le_6, output wire [23:0] results_min_7,
    output wire [23:0] results_max_8, output wire [20:0] results_to_fixed_u21q8_9,
    output wire [22:0] results_to_fixed_u23q8_10, output wire [21:0] results_to_fixed_s22q8_11,
    output wire [28:0] results_to_fixed_s29q15_12, output wire [18:0] results_to_fixed_s19q18_13,
    output wire [22:0] results_to_fixed_s23q22_14, output wire [23:0] results_to_fixed_u24q24_15,
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
    float_recip_s20_f24ftz recip_3 (.clk(clk), .enable(enable), .a(a), .y(results_recip_3));
    float_mul_s5_f24ftz mul_4 (.clk(clk), .enable(enable), .a(a), .b(b), .y(results_mul_4));
    float_sqrt_s18_f24ftz sqrt_5 (.clk(clk), .enable(enable), .a(a), .y(results_sqrt_5));
    float_le_s2_f24ftz le_6 (.clk(clk), .enable(enable), .a(a), .b(b), .y(results_le_6));
    float_min_s2_f24ftz min_7 (.clk(clk), .enable(enable), .a(a), .b(b), .y(results_min_7));
    float_max_s2_f24ftz max_8 (.clk(clk), .enable(enable), .a(a), .b(b), .y(results_max_8));
    float_to_fixed_s3_f24ftz_w21_f8_unsigned to_fixed_u21q8_9 (.clk(clk), .enable(enable), .a(a), .y(results_to_fixed_u21q8_9));
    float_to_fixed_s3_f24ftz_w23_f8_unsigned to_fixed_u23q8_10 (.clk(clk), .enable(enable), .a(a), .y(results_to_fixed_u23q8_10));
    float_to_fixed_s3_f24ftz_w22_f8_signed to_fixed_s22q8_11 (.clk(clk), .enable(enable), .a(a), .y(results_to_fixed_s22q8_11));
    float_to_fixed_s3_f24ftz_w29_f15_signed to_fixed_s29q15_12 (.clk(clk), .enable(enable), .a(a), .y(results_to_fixed_s29q15_12));
    float_to_fixed_s3_f24ftz_w19_f18_signed to_fixed_s19q18_13 (.clk(clk), .enable(enable), .a(a), .y(results_to_fixed_s19q18_13));
    float_to_fixed_s3_f24ftz_w23_f22_signed to_fixed_s23q22_14 (.clk(clk), .enable(enable), .a(a), .y(results_to_fixed_s23q22_14));
    float_to_fixed_s3_f24ftz_w24_f24_unsigned to_fixed_u24q24_15 (.clk(clk), .enable(enable), .a(a), .y(results_to_fixed_u24q24_15));

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
