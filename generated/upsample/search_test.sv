// Written by pointcore 0.1.0; do not edit.
// Replays what bit-exact models did at their ports, and compares every output in every cycle; a stream's fields count while it is valid, and
// those that go in are spoilt while it is not. For Verilator, whose registers start at random values: in a simulator with unknown values,
// what is not reset stays unknown longer than in hardware.
//
// A recording is a sequence of bits: in every cycle one, whether anything changes, and if so one for each group of ports, whether it does,
// then the words of those that do.

module search_test;
    wire [2:0] passed;

    search_top_replay replay_0 (.passed(passed[0]));
    search_leaf_replay replay_1 (.passed(passed[1]));
    search_operators_replay replay_2 (.passed(passed[2]));

    initial begin
        wait (&passed);
        $display("PASSED");
        $finish;
    end
endmodule

// 220792 cycles of search_top, which 17138 items leave.
module search_top_replay(output reg passed = 1'b0);
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [63:0] words [0:104118];
    reg [913:0] vector = 0;
    reg [913:0] next = 0;
    wire [913:0] found;
    reg changes;
    reg [7:0] changed;
    integer place = 0;
    integer i;
    integer cycle;
    integer differences = 0;

    search_top replayed (
        .clk(clk),
        .rst(rst || vector[0]),
        .lookup_valid(found[1]),
        .lookup_ready(vector[2]),
        .lookup_thread(found[6:3]),
        .lookup_address(found[27:7]),
        .record_valid(vector[28]),
        .record_ready(found[29]),
        .record_thread(vector[28] ? vector[33:30] : ~vector[33:30]),
        .record_address(vector[28] ? vector[54:34] : ~vector[54:34]),
        .record_split(vector[28] ? vector[86:55] : ~vector[86:55]),
        .record_dimension(vector[28] ? vector[88:87] : ~vector[88:87]),
        .record_internal_leaf(vector[28] ? vector[89] : ~vector[89]),
        .record_begin(vector[28] ? vector[111:90] : ~vector[111:90]),
        .record_beats(vector[28] ? vector[114:112] : ~vector[114:112]),
        .setup_valid(vector[115]),
        .setup_ball(vector[115] ? vector[116] : ~vector[116]),
        .setup_far_scale(vector[115] ? vector[148:117] : ~vector[148:117]),
        .setup_margin_scale(vector[115] ? vector[180:149] : ~vector[180:149]),
        .query_valid(vector[181]),
        .query_ready(found[182]),
        .query_number(vector[181] ? vector[206:183] : ~vector[206:183]),
        .query_k(vector[181] ? vector[212:207] : ~vector[212:207]),
        .query_radius2(vector[181] ? vector[244:213] : ~vector[244:213]),
        .query_x(vector[181] ? vector[276:245] : ~vector[276:245]),
        .query_y(vector[181] ? vector[308:277] : ~vector[308:277]),
        .query_z(vector[181] ? vector[340:309] : ~vector[340:309]),
        .query_reach(vector[181] ? vector[372:341] : ~vector[372:341]),
        .fetch_valid(found[373]),
        .fetch_ready(vector[374]),
        .fetch_thread(found[378:375]),
        .fetch_address(found[400:379]),
        .fetch_beats(found[403:401]),
        .beat_valid(vector[404]),
        .beat_ready(found[405]),
        .beat_thread(vector[404] ? vector[409:406] : ~vector[409:406]),
        .beat_address(vector[404] ? vector[431:410] : ~vector[431:410]),
        .beat_last(vector[404] ? vector[432] : ~vector[432]),
        .beat_x0(vector[404] ? vector[464:433] : ~vector[464:433]),
        .beat_y0(vector[404] ? vector[496:465] : ~vector[496:465]),
        .beat_z0(vector[404] ? vector[528:497] : ~vector[528:497]),
        .beat_x1(vector[404] ? vector[560:529] : ~vector[560:529]),
        .beat_y1(vector[404] ? vector[592:561] : ~vector[592:561]),
        .beat_z1(vector[404] ? vector[624:593] : ~vector[624:593]),
        .beat_x2(vector[404] ? vector[656:625] : ~vector[656:625]),
        .beat_y2(vector[404] ? vector[688:657] : ~vector[688:657]),
        .beat_z2(vector[404] ? vector[720:689] : ~vector[720:689]),
        .beat_x3(vector[404] ? vector[752:721] : ~vector[752:721]),
        .beat_y3(vector[404] ? vector[784:753] : ~vector[784:753]),
        .beat_z3(vector[404] ? vector[816:785] : ~vector[816:785]),
        .result_valid(found[817]),
        .result_ready(vector[818]),
        .result_number(found[842:819]),
        .result_last(found[843]),
        .result_found(found[844]),
        .result_index(found[868:845]),
        .result_distance2(found[900:869]),
        .result_cached(found[901]),
        .event_node(found[902]),
        .event_pop(found[903]),
        .event_beat(found[904]),
        .event_insert(found[905]),
        .event_insert_wait(found[906]),
        .event_thread_wait(found[907]),
        .event_point_hit(found[908]),
        .event_point_miss(found[909]),
        .event_tree_hit(found[910]),
        .event_tree_miss(found[911]),
        .event_cache_hit(found[912]),
        .event_cache_miss(found[913])
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
            for (i = 0; i <= 7; i = i + 1) begin
                if (changes) take_bit(changed[i]);
                else changed[i] = 1'b0;
            end
            if (changed[0]) begin take(0, 1); take(1, 1); take(2, 1); take(28, 1); take(29, 1); take(115, 1); take(181, 1); take(182, 1); take(373, 1); take(374, 1); take(404, 1); take(405, 1); take(817, 1); take(818, 1); take(902, 1); take(903, 1); take(904, 1); take(905, 1); take(906, 1); take(907, 1); take(908, 1); take(909, 1); take(910, 1); take(911, 1); take(912, 1); take(913, 1); end
            if (changed[1]) begin take(3, 4); take(7, 21); end
            if (changed[2]) begin take(30, 4); take(34, 21); take(55, 32); take(87, 2); take(89, 1); take(90, 22); take(112, 3); end
            if (changed[3]) begin take(116, 1); take(117, 32); take(149, 32); end
            if (changed[4]) begin take(183, 24); take(207, 6); take(213, 32); take(245, 32); take(277, 32); take(309, 32); take(341, 32); end
            if (changed[5]) begin take(375, 4); take(379, 22); take(401, 3); end
            if (changed[6]) begin take(406, 4); take(410, 22); take(432, 1); take(433, 32); take(465, 32); take(497, 32); take(529, 32); take(561, 32); take(593, 32); take(625, 32); take(657, 32); take(689, 32); take(721, 32); take(753, 32); take(785, 32); end
            if (changed[7]) begin take(819, 24); take(843, 1); take(844, 1); take(845, 24); take(869, 32); take(901, 1); end
            vector = next;
        end
    endtask

    task differ(input [8*32-1:0] port);
        begin
            differences = differences + 1;
            $display("search_top, cycle %0d: %0s differs from the model", cycle, port);
        end
    endtask

    initial begin
        $readmemh("search_test.hex", words);
        repeat (1) @(negedge clk);
        rst = 1'b0;
        for (cycle = 0; cycle < 220792 && differences == 0; cycle = cycle + 1) begin
            advance;
            #4;
            if (found[1] !== vector[1]) differ("lookup_valid");
            if (vector[1] && found[6:3] !== vector[6:3]) differ("lookup_thread");
            if (vector[1] && found[27:7] !== vector[27:7]) differ("lookup_address");
            if (found[29] !== vector[29]) differ("record_ready");
            if (found[182] !== vector[182]) differ("query_ready");
            if (found[373] !== vector[373]) differ("fetch_valid");
            if (vector[373] && found[378:375] !== vector[378:375]) differ("fetch_thread");
            if (vector[373] && found[400:379] !== vector[400:379]) differ("fetch_address");
            if (vector[373] && found[403:401] !== vector[403:401]) differ("fetch_beats");
            if (found[405] !== vector[405]) differ("beat_ready");
            if (found[817] !== vector[817]) differ("result_valid");
            if (vector[817] && found[842:819] !== vector[842:819]) differ("result_number");
            if (vector[817] && found[843] !== vector[843]) differ("result_last");
            if (vector[817] && found[844] !== vector[844]) differ("result_found");
            if (vector[817] && found[868:845] !== vector[868:845]) differ("result_index");
            if (vector[817] && found[900:869] !== vector[900:869]) differ("result_distance2");
            if (vector[817] && found[901] !== vector[901]) differ("result_cached");
            if (found[902] !== vector[902]) differ("event_node");
            if (found[903] !== vector[903]) differ("event_pop");
            if (found[904] !== vector[904]) differ("event_beat");
            if (found[905] !== vector[905]) differ("event_insert");
            if (found[906] !== vector[906]) differ("event_insert_wait");
            if (found[907] !== vector[907]) differ("event_thread_wait");
            if (found[908] !== vector[908]) differ("event_point_hit");
            if (found[909] !== vector[909]) differ("event_point_miss");
            if (found[910] !== vector[910]) differ("event_tree_hit");
            if (found[911] !== vector[911]) differ("event_tree_miss");
            if (found[912] !== vector[912]) differ("event_cache_hit");
            if (found[913] !== vector[913]) differ("event_cache_miss");
            @(negedge clk);
        end
        if (differences != 0) $fatal(1, "FAILED");
        $display("search_top: 220792 cycles, 17138 items, every output as the model's");
        passed = 1'b1;
    end
endmodule

// 4452 cycles of search_leaf, which 2152 items leave.
module search_leaf_replay(output reg passed = 1'b0);
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [63:0] words [0:19807];
    reg [729:0] vector = 0;
    reg [729:0] next = 0;
    wire [729:0] found;
    reg changes;
    reg [3:0] changed;
    integer place = 0;
    integer i;
    integer cycle;
    integer differences = 0;

    search_leaf replayed (
        .clk(clk),
        .rst(rst || vector[0]),
        .start_valid(vector[1]),
        .start_thread(vector[1] ? vector[5:2] : ~vector[5:2]),
        .start_number(vector[1] ? vector[29:6] : ~vector[29:6]),
        .start_k(vector[1] ? vector[35:30] : ~vector[35:30]),
        .start_radius2(vector[1] ? vector[67:36] : ~vector[67:36]),
        .start_x(vector[1] ? vector[99:68] : ~vector[99:68]),
        .start_y(vector[1] ? vector[131:100] : ~vector[131:100]),
        .start_z(vector[1] ? vector[163:132] : ~vector[163:132]),
        .beat_valid(vector[164]),
        .beat_ready(found[165]),
        .beat_thread(vector[164] ? vector[169:166] : ~vector[169:166]),
        .beat_address(vector[164] ? vector[191:170] : ~vector[191:170]),
        .beat_last(vector[164] ? vector[192] : ~vector[192]),
        .beat_x0(vector[164] ? vector[224:193] : ~vector[224:193]),
        .beat_y0(vector[164] ? vector[256:225] : ~vector[256:225]),
        .beat_z0(vector[164] ? vector[288:257] : ~vector[288:257]),
        .beat_x1(vector[164] ? vector[320:289] : ~vector[320:289]),
        .beat_y1(vector[164] ? vector[352:321] : ~vector[352:321]),
        .beat_z1(vector[164] ? vector[384:353] : ~vector[384:353]),
        .beat_x2(vector[164] ? vector[416:385] : ~vector[416:385]),
        .beat_y2(vector[164] ? vector[448:417] : ~vector[448:417]),
        .beat_z2(vector[164] ? vector[480:449] : ~vector[480:449]),
        .beat_x3(vector[164] ? vector[512:481] : ~vector[512:481]),
        .beat_y3(vector[164] ? vector[544:513] : ~vector[544:513]),
        .beat_z3(vector[164] ? vector[576:545] : ~vector[576:545]),
        .candidates_valid(found[577]),
        .candidates_ready(vector[578]),
        .candidates_thread(found[582:579]),
        .candidates_address(found[604:583]),
        .candidates_last(found[605]),
        .candidates_distance0(found[636:606]),
        .candidates_distance1(found[667:637]),
        .candidates_distance2(found[698:668]),
        .candidates_distance3(found[729:699])
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
            if (changed[0]) begin take(0, 1); take(1, 1); take(164, 1); take(165, 1); take(577, 1); take(578, 1); end
            if (changed[1]) begin take(2, 4); take(6, 24); take(30, 6); take(36, 32); take(68, 32); take(100, 32); take(132, 32); end
            if (changed[2]) begin take(166, 4); take(170, 22); take(192, 1); take(193, 32); take(225, 32); take(257, 32); take(289, 32); take(321, 32); take(353, 32); take(385, 32); take(417, 32); take(449, 32); take(481, 32); take(513, 32); take(545, 32); end
            if (changed[3]) begin take(579, 4); take(583, 22); take(605, 1); take(606, 31); take(637, 31); take(668, 31); take(699, 31); end
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
        for (cycle = 0; cycle < 4452 && differences == 0; cycle = cycle + 1) begin
            advance;
            #4;
            if (found[165] !== vector[165]) differ("beat_ready");
            if (found[577] !== vector[577]) differ("candidates_valid");
            if (vector[577] && found[582:579] !== vector[582:579]) differ("candidates_thread");
            if (vector[577] && found[604:583] !== vector[604:583]) differ("candidates_address");
            if (vector[577] && found[605] !== vector[605]) differ("candidates_last");
            if (vector[577] && found[636:606] !== vector[636:606]) differ("candidates_distance0");
            if (vector[577] && found[667:637] !== vector[667:637]) differ("candidates_distance1");
            if (vector[577] && found[698:668] !== vector[698:668]) differ("candidates_distance2");
            if (vector[577] && found[729:699] !== vector[729:699]) differ("candidates_distance3");
            @(negedge clk);
        end
        if (differences != 0) $fatal(1, "FAILED");
        $display("search_leaf: 4452 cycles, 2152 items, every output as the model's");
        passed = 1'b1;
    end
endmodule

// 1333 cycles of search_operators, which 1301 items leave.
module search_operators_replay(output reg passed = 1'b0);
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [63:0] words [0:3494];
    reg [196:0] vector = 0;
    reg [196:0] next = 0;
    wire [196:0] found;
    reg changes;
    reg [2:0] changed;
    integer place = 0;
    integer i;
    integer cycle;
    integer differences = 0;

    search_operators replayed (
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
        .results_sqrt_3(found[195:164]),
        .results_lt_4(found[196])
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
            if (changed[2]) begin take(99, 32); take(131, 32); take(163, 1); take(164, 32); take(196, 1); end
            vector = next;
        end
    endtask

    task differ(input [8*32-1:0] port);
        begin
            differences = differences + 1;
            $display("search_operators, cycle %0d: %0s differs from the model", cycle, port);
        end
    endtask

    initial begin
        $readmemh("search_operators_test.hex", words);
        repeat (1) @(negedge clk);
        rst = 1'b0;
        for (cycle = 0; cycle < 1333 && differences == 0; cycle = cycle + 1) begin
            advance;
            #4;
            if (found[98] !== vector[98]) differ("results_valid");
            if (vector[98] && found[130:99] !== vector[130:99]) differ("results_add_0");
            if (vector[98] && found[162:131] !== vector[162:131]) differ("results_mul_1");
            if (vector[98] && found[163] !== vector[163]) differ("results_lt_2");
            if (vector[98] && found[195:164] !== vector[195:164]) differ("results_sqrt_3");
            if (vector[98] && found[196] !== vector[196]) differ("results_lt_4");
            @(negedge clk);
        end
        if (differences != 0) $fatal(1, "FAILED");
        $display("search_operators: 1333 cycles, 1301 items, every output as the model's");
        passed = 1'b1;
    end
endmodule

// The floating-point operators of a core side by side.
module search_operators (
    input  wire clk, input wire rst, input wire enable, input wire [31:0] a, input wire [31:0] b,
    input  wire [31:0] c,
    output wire results_valid, output wire [31:0] results_add_0, output wire [31:0] results_mul_1,
    output wire results_lt_2, output wire [31:0] results_sqrt_3, output wire results_lt_4
);
    reg [4:0] taken;

    wire valid = taken == 5'd26;

    assign results_valid = valid;

    float_add_s6_f32ftz add_0 (.clk(clk), .enable(enable), .a(a), .b(b), .y(results_add_0));
    float_mul_s5_f32ftz mul_1 (.clk(clk), .enable(enable), .a(a), .b(b), .y(results_mul_1));
    float_lt_s2_f32ftz lt_2 (.clk(clk), .enable(enable), .a(a), .b(b), .y(results_lt_2));
    float_sqrt_s26_f32ftz sqrt_3 (.clk(clk), .enable(enable), .a(a), .y(results_sqrt_3));
    float_lt_s1_f32ftz lt_4 (.clk(clk), .enable(enable), .a(a), .b(b), .y(results_lt_4));

    always @(posedge clk) begin
        if (rst) taken <= 5'd0;
        else taken <= (enable & ~valid) ? (taken + 5'd1) : taken;
    end

    wire _unused = &{1'b0, c};
endmodule
