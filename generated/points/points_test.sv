// Written by pointcore 0.1.0; do not edit.
// Replays what bit-exact models did at their ports, and compares every output in every cycle; a stream's fields count while it is valid, and
// those that go in are spoilt while it is not. For Verilator, whose registers start at random values: in a simulator with unknown values,
// what is not reset stays unknown longer than in hardware.
//
// A recording is a sequence of bits: in every cycle one, whether anything changes, and if so one for each group of ports, whether it does,
// then the words of those that do.

module points_test;
    wire [2:0] passed;

    points_top_replay replay_0 (.passed(passed[0]));
    search_leaf_replay replay_1 (.passed(passed[1]));
    points_operators_replay replay_2 (.passed(passed[2]));

    initial begin
        wait (&passed);
        $display("PASSED");
        $finish;
    end
endmodule

// 18499 cycles of points_top, which 561 items leave.
module points_top_replay(output reg passed = 1'b0);
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [63:0] words [0:16112];
    reg [1261:0] vector = 0;
    reg [1261:0] next = 0;
    wire [1261:0] found;
    reg changes;
    reg [8:0] changed;
    integer place = 0;
    integer i;
    integer cycle;
    integer differences = 0;

    points_top replayed (
        .clk(clk),
        .rst(rst || vector[0]),
        .tree_valid(vector[1]),
        .tree_is_leaf(vector[1] ? vector[2] : ~vector[2]),
        .tree_address(vector[1] ? vector[16:3] : ~vector[16:3]),
        .tree_split(vector[1] ? vector[48:17] : ~vector[48:17]),
        .tree_dimension(vector[1] ? vector[50:49] : ~vector[50:49]),
        .tree_internal_leaf(vector[1] ? vector[51] : ~vector[51]),
        .tree_begin(vector[1] ? vector[73:52] : ~vector[73:52]),
        .tree_beats(vector[1] ? vector[76:74] : ~vector[76:74]),
        .search_k(vector[82:77]),
        .search_radius2(vector[114:83]),
        .setting_inverse_radius2(vector[146:115]),
        .setting_tolerance(vector[178:147]),
        .iterations_max(vector[194:179]),
        .query_valid(vector[195]),
        .query_ready(found[196]),
        .query_number(vector[195] ? vector[220:197] : ~vector[220:197]),
        .query_query_position_x(vector[195] ? vector[252:221] : ~vector[252:221]),
        .query_query_position_y(vector[195] ? vector[284:253] : ~vector[284:253]),
        .query_query_position_z(vector[195] ? vector[316:285] : ~vector[316:285]),
        .fetch_valid(found[317]),
        .fetch_ready(vector[318]),
        .fetch_thread(found[322:319]),
        .fetch_address(found[344:323]),
        .fetch_beats(found[347:345]),
        .beat_valid(vector[348]),
        .beat_ready(found[349]),
        .beat_thread(vector[348] ? vector[353:350] : ~vector[353:350]),
        .beat_address(vector[348] ? vector[375:354] : ~vector[375:354]),
        .beat_last(vector[348] ? vector[376] : ~vector[376]),
        .beat_x0(vector[348] ? vector[408:377] : ~vector[408:377]),
        .beat_y0(vector[348] ? vector[440:409] : ~vector[440:409]),
        .beat_z0(vector[348] ? vector[472:441] : ~vector[472:441]),
        .beat_x1(vector[348] ? vector[504:473] : ~vector[504:473]),
        .beat_y1(vector[348] ? vector[536:505] : ~vector[536:505]),
        .beat_z1(vector[348] ? vector[568:537] : ~vector[568:537]),
        .beat_x2(vector[348] ? vector[600:569] : ~vector[600:569]),
        .beat_y2(vector[348] ? vector[632:601] : ~vector[632:601]),
        .beat_z2(vector[348] ? vector[664:633] : ~vector[664:633]),
        .beat_x3(vector[348] ? vector[696:665] : ~vector[696:665]),
        .beat_y3(vector[348] ? vector[728:697] : ~vector[728:697]),
        .beat_z3(vector[348] ? vector[760:729] : ~vector[760:729]),
        .line_valid(found[761]),
        .line_ready(vector[762]),
        .line_line(found[784:763]),
        .fill_valid(vector[785]),
        .fill_ready(found[786]),
        .fill_position_x(vector[785] ? vector[818:787] : ~vector[818:787]),
        .fill_position_y(vector[785] ? vector[850:819] : ~vector[850:819]),
        .fill_position_z(vector[785] ? vector[882:851] : ~vector[882:851]),
        .fill_normal_x(vector[785] ? vector[914:883] : ~vector[914:883]),
        .fill_normal_y(vector[785] ? vector[946:915] : ~vector[946:915]),
        .fill_normal_z(vector[785] ? vector[978:947] : ~vector[978:947]),
        .result_valid(found[979]),
        .result_ready(vector[980]),
        .result_number(found[1004:981]),
        .result_iterations(found[1020:1005]),
        .result_capped(found[1021]),
        .result_output_position_x(found[1053:1022]),
        .result_output_position_y(found[1085:1054]),
        .result_output_position_z(found[1117:1086]),
        .result_output_normal_x(found[1149:1118]),
        .result_output_normal_y(found[1181:1150]),
        .result_output_normal_z(found[1213:1182]),
        .result_output_residual(found[1245:1214]),
        .result_output_valid(found[1246]),
        .idle(found[1247]),
        .event_node(found[1248]),
        .event_pop(found[1249]),
        .event_beat(found[1250]),
        .event_insert(found[1251]),
        .event_insert_wait(found[1252]),
        .event_thread_wait(found[1253]),
        .event_point_hit(found[1254]),
        .event_point_miss(found[1255]),
        .event_query_wait(found[1256]),
        .event_kernel(found[1257]),
        .event_kernel_wait(found[1258]),
        .event_again(found[1259]),
        .event_line_hit(found[1260]),
        .event_line_miss(found[1261])
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
            for (i = 0; i <= 8; i = i + 1) begin
                if (changes) take_bit(changed[i]);
                else changed[i] = 1'b0;
            end
            if (changed[0]) begin take(0, 1); take(1, 1); take(195, 1); take(196, 1); take(317, 1); take(318, 1); take(348, 1); take(349, 1); take(761, 1); take(762, 1); take(785, 1); take(786, 1); take(979, 1); take(980, 1); take(1247, 1); take(1248, 1); take(1249, 1); take(1250, 1); take(1251, 1); take(1252, 1); take(1253, 1); take(1254, 1); take(1255, 1); take(1256, 1); take(1257, 1); take(1258, 1); take(1259, 1); take(1260, 1); take(1261, 1); end
            if (changed[1]) begin take(77, 6); take(83, 32); take(115, 32); take(147, 32); take(179, 16); end
            if (changed[2]) begin take(2, 1); take(3, 14); take(17, 32); take(49, 2); take(51, 1); take(52, 22); take(74, 3); end
            if (changed[3]) begin take(197, 24); take(221, 32); take(253, 32); take(285, 32); end
            if (changed[4]) begin take(319, 4); take(323, 22); take(345, 3); end
            if (changed[5]) begin take(350, 4); take(354, 22); take(376, 1); take(377, 32); take(409, 32); take(441, 32); take(473, 32); take(505, 32); take(537, 32); take(569, 32); take(601, 32); take(633, 32); take(665, 32); take(697, 32); take(729, 32); end
            if (changed[6]) begin take(763, 22); end
            if (changed[7]) begin take(787, 32); take(819, 32); take(851, 32); take(883, 32); take(915, 32); take(947, 32); end
            if (changed[8]) begin take(981, 24); take(1005, 16); take(1021, 1); take(1022, 32); take(1054, 32); take(1086, 32); take(1118, 32); take(1150, 32); take(1182, 32); take(1214, 32); take(1246, 1); end
            vector = next;
        end
    endtask

    task differ(input [8*32-1:0] port);
        begin
            differences = differences + 1;
            $display("points_top, cycle %0d: %0s differs from the model", cycle, port);
        end
    endtask

    initial begin
        $readmemh("points_test.hex", words);
        repeat (1) @(negedge clk);
        rst = 1'b0;
        for (cycle = 0; cycle < 18499 && differences == 0; cycle = cycle + 1) begin
            advance;
            #4;
            if (found[196] !== vector[196]) differ("query_ready");
            if (found[317] !== vector[317]) differ("fetch_valid");
            if (vector[317] && found[322:319] !== vector[322:319]) differ("fetch_thread");
            if (vector[317] && found[344:323] !== vector[344:323]) differ("fetch_address");
            if (vector[317] && found[347:345] !== vector[347:345]) differ("fetch_beats");
            if (found[349] !== vector[349]) differ("beat_ready");
            if (found[761] !== vector[761]) differ("line_valid");
            if (vector[761] && found[784:763] !== vector[784:763]) differ("line_line");
            if (found[786] !== vector[786]) differ("fill_ready");
            if (found[979] !== vector[979]) differ("result_valid");
            if (vector[979] && found[1004:981] !== vector[1004:981]) differ("result_number");
            if (vector[979] && found[1020:1005] !== vector[1020:1005]) differ("result_iterations");
            if (vector[979] && found[1021] !== vector[1021]) differ("result_capped");
            if (vector[979] && found[1053:1022] !== vector[1053:1022]) differ("result_output_position_x");
            if (vector[979] && found[1085:1054] !== vector[1085:1054]) differ("result_output_position_y");
            if (vector[979] && found[1117:1086] !== vector[1117:1086]) differ("result_output_position_z");
            if (vector[979] && found[1149:1118] !== vector[1149:1118]) differ("result_output_normal_x");
            if (vector[979] && found[1181:1150] !== vector[1181:1150]) differ("result_output_normal_y");
            if (vector[979] && found[1213:1182] !== vector[1213:1182]) differ("result_output_normal_z");
            if (vector[979] && found[1245:1214] !== vector[1245:1214]) differ("result_output_residual");
            if (vector[979] && found[1246] !== vector[1246]) differ("result_output_valid");
            if (found[1247] !== vector[1247]) differ("idle");
            if (found[1248] !== vector[1248]) differ("event_node");
            if (found[1249] !== vector[1249]) differ("event_pop");
            if (found[1250] !== vector[1250]) differ("event_beat");
            if (found[1251] !== vector[1251]) differ("event_insert");
            if (found[1252] !== vector[1252]) differ("event_insert_wait");
            if (found[1253] !== vector[1253]) differ("event_thread_wait");
            if (found[1254] !== vector[1254]) differ("event_point_hit");
            if (found[1255] !== vector[1255]) differ("event_point_miss");
            if (found[1256] !== vector[1256]) differ("event_query_wait");
            if (found[1257] !== vector[1257]) differ("event_kernel");
            if (found[1258] !== vector[1258]) differ("event_kernel_wait");
            if (found[1259] !== vector[1259]) differ("event_again");
            if (found[1260] !== vector[1260]) differ("event_line_hit");
            if (found[1261] !== vector[1261]) differ("event_line_miss");
            @(negedge clk);
        end
        if (differences != 0) $fatal(1, "FAILED");
        $display("points_top: 18499 cycles, 561 items, every output as the model's");
        passed = 1'b1;
    end
endmodule

// 4516 cycles of search_leaf, which 3681 items leave.
module search_leaf_replay(output reg passed = 1'b0);
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [63:0] words [0:21954];
    reg [856:0] vector = 0;
    reg [856:0] next = 0;
    wire [856:0] found;
    reg changes;
    reg [6:0] changed;
    integer place = 0;
    integer i;
    integer cycle;
    integer differences = 0;

    search_leaf replayed (
        .clk(clk),
        .rst(rst || vector[0]),
        .tree_valid(vector[1]),
        .tree_is_leaf(vector[1] ? vector[2] : ~vector[2]),
        .tree_address(vector[1] ? vector[16:3] : ~vector[16:3]),
        .tree_split(vector[1] ? vector[48:17] : ~vector[48:17]),
        .tree_dimension(vector[1] ? vector[50:49] : ~vector[50:49]),
        .tree_internal_leaf(vector[1] ? vector[51] : ~vector[51]),
        .tree_begin(vector[1] ? vector[73:52] : ~vector[73:52]),
        .tree_beats(vector[1] ? vector[76:74] : ~vector[76:74]),
        .leaf_valid(vector[77]),
        .leaf_ready(found[78]),
        .leaf_thread(vector[77] ? vector[82:79] : ~vector[82:79]),
        .leaf_leaf(vector[77] ? vector[96:83] : ~vector[96:83]),
        .fetch_valid(found[97]),
        .fetch_ready(vector[98]),
        .fetch_thread(found[102:99]),
        .fetch_address(found[124:103]),
        .fetch_beats(found[127:125]),
        .start_valid(vector[128]),
        .start_thread(vector[128] ? vector[132:129] : ~vector[132:129]),
        .start_number(vector[128] ? vector[156:133] : ~vector[156:133]),
        .start_k(vector[128] ? vector[162:157] : ~vector[162:157]),
        .start_radius2(vector[128] ? vector[194:163] : ~vector[194:163]),
        .start_x(vector[128] ? vector[226:195] : ~vector[226:195]),
        .start_y(vector[128] ? vector[258:227] : ~vector[258:227]),
        .start_z(vector[128] ? vector[290:259] : ~vector[290:259]),
        .beat_valid(vector[291]),
        .beat_ready(found[292]),
        .beat_thread(vector[291] ? vector[296:293] : ~vector[296:293]),
        .beat_address(vector[291] ? vector[318:297] : ~vector[318:297]),
        .beat_last(vector[291] ? vector[319] : ~vector[319]),
        .beat_x0(vector[291] ? vector[351:320] : ~vector[351:320]),
        .beat_y0(vector[291] ? vector[383:352] : ~vector[383:352]),
        .beat_z0(vector[291] ? vector[415:384] : ~vector[415:384]),
        .beat_x1(vector[291] ? vector[447:416] : ~vector[447:416]),
        .beat_y1(vector[291] ? vector[479:448] : ~vector[479:448]),
        .beat_z1(vector[291] ? vector[511:480] : ~vector[511:480]),
        .beat_x2(vector[291] ? vector[543:512] : ~vector[543:512]),
        .beat_y2(vector[291] ? vector[575:544] : ~vector[575:544]),
        .beat_z2(vector[291] ? vector[607:576] : ~vector[607:576]),
        .beat_x3(vector[291] ? vector[639:608] : ~vector[639:608]),
        .beat_y3(vector[291] ? vector[671:640] : ~vector[671:640]),
        .beat_z3(vector[291] ? vector[703:672] : ~vector[703:672]),
        .candidates_valid(found[704]),
        .candidates_ready(vector[705]),
        .candidates_thread(found[709:706]),
        .candidates_address(found[731:710]),
        .candidates_last(found[732]),
        .candidates_distance0(found[763:733]),
        .candidates_distance1(found[794:764]),
        .candidates_distance2(found[825:795]),
        .candidates_distance3(found[856:826])
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
            if (changed[0]) begin take(0, 1); take(1, 1); take(77, 1); take(78, 1); take(97, 1); take(98, 1); take(128, 1); take(291, 1); take(292, 1); take(704, 1); take(705, 1); end
            if (changed[1]) begin take(2, 1); take(3, 14); take(17, 32); take(49, 2); take(51, 1); take(52, 22); take(74, 3); end
            if (changed[2]) begin take(79, 4); take(83, 14); end
            if (changed[3]) begin take(99, 4); take(103, 22); take(125, 3); end
            if (changed[4]) begin take(129, 4); take(133, 24); take(157, 6); take(163, 32); take(195, 32); take(227, 32); take(259, 32); end
            if (changed[5]) begin take(293, 4); take(297, 22); take(319, 1); take(320, 32); take(352, 32); take(384, 32); take(416, 32); take(448, 32); take(480, 32); take(512, 32); take(544, 32); take(576, 32); take(608, 32); take(640, 32); take(672, 32); end
            if (changed[6]) begin take(706, 4); take(710, 22); take(732, 1); take(733, 31); take(764, 31); take(795, 31); take(826, 31); end
            vector = next;
        end
    endtask

    task differ(input [8*32-1:0] port);
        begin
            differences = differences + 1;
            $display("search_leaf, cycle %0d: %0s differs from the model", cycle, port);
        end
    endtask

    initial begin
        $readmemh("search_leaf_test.hex", words);
        repeat (1) @(negedge clk);
        rst = 1'b0;
        for (cycle = 0; cycle < 4516 && differences == 0; cycle = cycle + 1) begin
            advance;
            #4;
            if (found[78] !== vector[78]) differ("leaf_ready");
            if (found[97] !== vector[97]) differ("fetch_valid");
            if (vector[97] && found[102:99] !== vector[102:99]) differ("fetch_thread");
            if (vector[97] && found[124:103] !== vector[124:103]) differ("fetch_address");
            if (vector[97] && found[127:125] !== vector[127:125]) differ("fetch_beats");
            if (found[292] !== vector[292]) differ("beat_ready");
            if (found[704] !== vector[704]) differ("candidates_valid");
            if (vector[704] && found[709:706] !== vector[709:706]) differ("candidates_thread");
            if (vector[704] && found[731:710] !== vector[731:710]) differ("candidates_address");
            if (vector[704] && found[732] !== vector[732]) differ("candidates_last");
            if (vector[704] && found[763:733] !== vector[763:733]) differ("candidates_distance0");
            if (vector[704] && found[794:764] !== vector[794:764]) differ("candidates_distance1");
            if (vector[704] && found[825:795] !== vector[825:795]) differ("candidates_distance2");
            if (vector[704] && found[856:826] !== vector[856:826]) differ("candidates_distance3");
            @(negedge clk);
        end
        if (differences != 0) $fatal(1, "FAILED");
        $display("search_leaf: 4516 cycles, 3681 items, every output as the model's");
        passed = 1'b1;
    end
endmodule

// 1337 cycles of points_operators, which 1303 items leave.
module points_operators_replay(output reg passed = 1'b0);
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [63:0] words [0:4664];
    reg [261:0] vector = 0;
    reg [261:0] next = 0;
    wire [261:0] found;
    reg changes;
    reg [2:0] changed;
    integer place = 0;
    integer i;
    integer cycle;
    integer differences = 0;

    points_operators replayed (
        .clk(clk),
        .rst(rst || vector[0]),
        .enable(vector[1]),
        .a(vector[33:2]),
        .b(vector[65:34]),
        .c(vector[97:66]),
        .results_valid(found[98]),
        .results_add_0(found[130:99]),
        .results_mul_1(found[162:131]),
        .results_lt_2(found[163]),
        .results_recip_3(found[195:164]),
        .results_rsqrt_4(found[227:196]),
        .results_lt_5(found[228]),
        .results_le_6(found[229]),
        .results_max_7(found[261:230])
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
            if (changed[0]) begin take(0, 1); take(1, 1); take(98, 1); end
            if (changed[1]) begin take(2, 32); take(34, 32); take(66, 32); end
            if (changed[2]) begin take(99, 32); take(131, 32); take(163, 1); take(164, 32); take(196, 32); take(228, 1); take(229, 1); take(230, 32); end
            vector = next;
        end
    endtask

    task differ(input [8*32-1:0] port);
        begin
            differences = differences + 1;
            $display("points_operators, cycle %0d: %0s differs from the model", cycle, port);
        end
    endtask

    initial begin
        $readmemh("points_operators_test.hex", words);
        repeat (1) @(negedge clk);
        rst = 1'b0;
        for (cycle = 0; cycle < 1337 && differences == 0; cycle = cycle + 1) begin
            advance;
            #4;
            if (found[98] !== vector[98]) differ("results_valid");
            if (vector[98] && found[130:99] !== vector[130:99]) differ("results_add_0");
            if (vector[98] && found[162:131] !== vector[162:131]) differ("results_mul_1");
            if (vector[98] && found[163] !== vector[163]) differ("results_lt_2");
            if (vector[98] && found[195:164] !== vector[195:164]) differ("results_recip_3");
            if (vector[98] && found[227:196] !== vector[227:196]) differ("results_rsqrt_4");
            if (vector[98] && found[228] !== vector[228]) differ("results_lt_5");
            if (vector[98] && found[229] !== vector[229]) differ("results_le_6");
            if (vector[98] && found[261:230] !== vector[261:230]) differ("results_max_7");
            @(negedge clk);
        end
        if (differences != 0) $fatal(1, "FAILED");
        $display("points_operators: 1337 cycles, 1303 items, every output as the model's");
        passed = 1'b1;
    end
endmodule

// The floating-point operators of a core side by side.
module points_operators (
    input  wire clk, input wire rst, input wire enable, input wire [31:0] a, input wire [31:0] b,
    input  wire [31:0] c,
    output wire results_valid, output wire [31:0] results_add_0, output wire [31:0] results_mul_1,
    output wire results_lt_2, output wire [31:0] results_recip_3, output wire [31:0] results_rsqrt_4,
    output wire results_lt_5, output wire results_le_6, output wire [31:0] results_max_7
);
    reg [4:0] taken;

    wire valid = taken == 5'd28;

    assign results_valid = valid;

    float_add_s6_f32ftz add_0 (.clk(clk), .enable(enable), .a(a), .b(b), .y(results_add_0));
    float_mul_s5_f32ftz mul_1 (.clk(clk), .enable(enable), .a(a), .b(b), .y(results_mul_1));
    float_lt_s1_f32ftz lt_2 (.clk(clk), .enable(enable), .a(a), .b(b), .y(results_lt_2));
    float_recip_s28_f32ftz recip_3 (.clk(clk), .enable(enable), .a(a), .y(results_recip_3));
    float_rsqrt_s26_f32ftz rsqrt_4 (.clk(clk), .enable(enable), .a(a), .y(results_rsqrt_4));
    float_lt_s2_f32ftz lt_5 (.clk(clk), .enable(enable), .a(a), .b(b), .y(results_lt_5));
    float_le_s2_f32ftz le_6 (.clk(clk), .enable(enable), .a(a), .b(b), .y(results_le_6));
    float_max_s2_f32ftz max_7 (.clk(clk), .enable(enable), .a(a), .b(b), .y(results_max_7));

    always @(posedge clk) begin
        if (rst) taken <= 5'd0;
        else taken <= (enable & ~valid) ? (taken + 5'd1) : taken;
    end

    wire _unused = &{1'b0, c};
endmodule
