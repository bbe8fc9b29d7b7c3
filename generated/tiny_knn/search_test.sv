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

// 267699 cycles of search_top, which 8810 items leave.
module search_top_replay(output reg passed = 1'b0);
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [63:0] words [0:77734];
    reg [355:0] vector = 0;
    reg [355:0] next = 0;
    wire [355:0] found;
    reg changes;
    reg [5:0] changed;
    integer place = 0;
    integer i;
    integer cycle;
    integer differences = 0;

    search_top replayed (
        .clk(clk),
        .rst(rst || vector[0]),
        .tree_valid(vector[1]),
        .tree_is_leaf(vector[1] ? vector[2] : ~vector[2]),
        .tree_address(vector[1] ? vector[8:3] : ~vector[8:3]),
        .tree_split(vector[1] ? vector[32:9] : ~vector[32:9]),
        .tree_dimension(vector[1] ? vector[34:33] : ~vector[34:33]),
        .tree_internal_leaf(vector[1] ? vector[35] : ~vector[35]),
        .tree_begin(vector[1] ? vector[51:36] : ~vector[51:36]),
        .tree_beats(vector[1] ? vector[55:52] : ~vector[55:52]),
        .query_valid(vector[56]),
        .query_ready(found[57]),
        .query_number(vector[56] ? vector[73:58] : ~vector[73:58]),
        .query_k(vector[56] ? vector[77:74] : ~vector[77:74]),
        .query_radius2(vector[56] ? vector[101:78] : ~vector[101:78]),
        .query_x(vector[56] ? vector[125:102] : ~vector[125:102]),
        .query_y(vector[56] ? vector[149:126] : ~vector[149:126]),
        .query_z(vector[56] ? vector[173:150] : ~vector[173:150]),
        .fetch_valid(found[174]),
        .fetch_ready(vector[175]),
        .fetch_thread(found[177:176]),
        .fetch_address(found[193:178]),
        .fetch_beats(found[197:194]),
        .beat_valid(vector[198]),
        .beat_ready(found[199]),
        .beat_thread(vector[198] ? vector[201:200] : ~vector[201:200]),
        .beat_address(vector[198] ? vector[217:202] : ~vector[217:202]),
        .beat_last(vector[198] ? vector[218] : ~vector[218]),
        .beat_x0(vector[198] ? vector[242:219] : ~vector[242:219]),
        .beat_y0(vector[198] ? vector[266:243] : ~vector[266:243]),
        .beat_z0(vector[198] ? vector[290:267] : ~vector[290:267]),
        .result_valid(found[291]),
        .result_ready(vector[292]),
        .result_number(found[308:293]),
        .result_last(found[309]),
        .result_found(found[310]),
        .result_index(found[326:311]),
        .result_distance2(found[350:327]),
        .event_node(found[351]),
        .event_pop(found[352]),
        .event_beat(found[353]),
        .event_insert(found[354]),
        .event_thread_wait(found[355])
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
            for (i = 0; i <= 5; i = i + 1) begin
                if (changes) take_bit(changed[i]);
                else changed[i] = 1'b0;
            end
            if (changed[0]) begin take(0, 1); take(1, 1); take(56, 1); take(57, 1); take(174, 1); take(175, 1); take(198, 1); take(199, 1); take(291, 1); take(292, 1); take(351, 1); take(352, 1); take(353, 1); take(354, 1); take(355, 1); end
            if (changed[1]) begin take(2, 1); take(3, 6); take(9, 24); take(33, 2); take(35, 1); take(36, 16); take(52, 4); end
            if (changed[2]) begin take(58, 16); take(74, 4); take(78, 24); take(102, 24); take(126, 24); take(150, 24); end
            if (changed[3]) begin take(176, 2); take(178, 16); take(194, 4); end
            if (changed[4]) begin take(200, 2); take(202, 16); take(218, 1); take(219, 24); take(243, 24); take(267, 24); end
            if (changed[5]) begin take(293, 16); take(309, 1); take(310, 1); take(311, 16); take(327, 24); end
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
        for (cycle = 0; cycle < 267699 && differences == 0; cycle = cycle + 1) begin
            advance;
            #4;
            if (found[57] !== vector[57]) differ("query_ready");
            if (found[174] !== vector[174]) differ("fetch_valid");
            if (vector[174] && found[177:176] !== vector[177:176]) differ("fetch_thread");
            if (vector[174] && found[193:178] !== vector[193:178]) differ("fetch_address");
            if (vector[174] && found[197:194] !== vector[197:194]) differ("fetch_beats");
            if (found[199] !== vector[199]) differ("beat_ready");
            if (found[291] !== vector[291]) differ("result_valid");
            if (vector[291] && found[308:293] !== vector[308:293]) differ("result_number");
            if (vector[291] && found[309] !== vector[309]) differ("result_last");
            if (vector[291] && found[310] !== vector[310]) differ("result_found");
            if (vector[291] && found[326:311] !== vector[326:311]) differ("result_index");
            if (vector[291] && found[350:327] !== vector[350:327]) differ("result_distance2");
            if (found[351] !== vector[351]) differ("event_node");
            if (found[352] !== vector[352]) differ("event_pop");
            if (found[353] !== vector[353]) differ("event_beat");
            if (found[354] !== vector[354]) differ("event_insert");
            if (found[355] !== vector[355]) differ("event_thread_wait");
            @(negedge clk);
        end
        if (differences != 0) $fatal(1, "FAILED");
        $display("search_top: 267699 cycles, 8810 items, every output as the model's");
        passed = 1'b1;
    end
endmodule

// 4360 cycles of search_leaf, which 4083 items leave.
module search_leaf_replay(output reg passed = 1'b0);
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [63:0] words [0:6750];
    reg [345:0] vector = 0;
    reg [345:0] next = 0;
    wire [345:0] found;
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
        .tree_address(vector[1] ? vector[8:3] : ~vector[8:3]),
        .tree_split(vector[1] ? vector[32:9] : ~vector[32:9]),
        .tree_dimension(vector[1] ? vector[34:33] : ~vector[34:33]),
        .tree_internal_leaf(vector[1] ? vector[35] : ~vector[35]),
        .tree_begin(vector[1] ? vector[51:36] : ~vector[51:36]),
        .tree_beats(vector[1] ? vector[55:52] : ~vector[55:52]),
        .leaf_valid(vector[56]),
        .leaf_ready(found[57]),
        .leaf_thread(vector[56] ? vector[59:58] : ~vector[59:58]),
        .leaf_leaf(vector[56] ? vector[65:60] : ~vector[65:60]),
        .fetch_valid(found[66]),
        .fetch_ready(vector[67]),
        .fetch_thread(found[69:68]),
        .fetch_address(found[85:70]),
        .fetch_beats(found[89:86]),
        .start_valid(vector[90]),
        .start_thread(vector[90] ? vector[92:91] : ~vector[92:91]),
        .start_number(vector[90] ? vector[108:93] : ~vector[108:93]),
        .start_k(vector[90] ? vector[112:109] : ~vector[112:109]),
        .start_radius2(vector[90] ? vector[136:113] : ~vector[136:113]),
        .start_x(vector[90] ? vector[160:137] : ~vector[160:137]),
        .start_y(vector[90] ? vector[184:161] : ~vector[184:161]),
        .start_z(vector[90] ? vector[208:185] : ~vector[208:185]),
        .beat_valid(vector[209]),
        .beat_ready(found[210]),
        .beat_thread(vector[209] ? vector[212:211] : ~vector[212:211]),
        .beat_address(vector[209] ? vector[228:213] : ~vector[228:213]),
        .beat_last(vector[209] ? vector[229] : ~vector[229]),
        .beat_x0(vector[209] ? vector[253:230] : ~vector[253:230]),
        .beat_y0(vector[209] ? vector[277:254] : ~vector[277:254]),
        .beat_z0(vector[209] ? vector[301:278] : ~vector[301:278]),
        .candidates_valid(found[302]),
        .candidates_ready(vector[303]),
        .candidates_thread(found[305:304]),
        .candidates_address(found[321:306]),
        .candidates_last(found[322]),
        .candidates_distance0(found[345:323])
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
            if (changed[0]) begin take(0, 1); take(1, 1); take(56, 1); take(57, 1); take(66, 1); take(67, 1); take(90, 1); take(209, 1); take(210, 1); take(302, 1); take(303, 1); end
            if (changed[1]) begin take(2, 1); take(3, 6); take(9, 24); take(33, 2); take(35, 1); take(36, 16); take(52, 4); end
            if (changed[2]) begin take(58, 2); take(60, 6); end
            if (changed[3]) begin take(68, 2); take(70, 16); take(86, 4); end
            if (changed[4]) begin take(91, 2); take(93, 16); take(109, 4); take(113, 24); take(137, 24); take(161, 24); take(185, 24); end
            if (changed[5]) begin take(211, 2); take(213, 16); take(229, 1); take(230, 24); take(254, 24); take(278, 24); end
            if (changed[6]) begin take(304, 2); take(306, 16); take(322, 1); take(323, 23); end
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
        for (cycle = 0; cycle < 4360 && differences == 0; cycle = cycle + 1) begin
            advance;
            #4;
            if (found[57] !== vector[57]) differ("leaf_ready");
            if (found[66] !== vector[66]) differ("fetch_valid");
            if (vector[66] && found[69:68] !== vector[69:68]) differ("fetch_thread");
            if (vector[66] && found[85:70] !== vector[85:70]) differ("fetch_address");
            if (vector[66] && found[89:86] !== vector[89:86]) differ("fetch_beats");
            if (found[210] !== vector[210]) differ("beat_ready");
            if (found[302] !== vector[302]) differ("candidates_valid");
            if (vector[302] && found[305:304] !== vector[305:304]) differ("candidates_thread");
            if (vector[302] && found[321:306] !== vector[321:306]) differ("candidates_address");
            if (vector[302] && found[322] !== vector[322]) differ("candidates_last");
            if (vector[302] && found[345:323] !== vector[345:323]) differ("candidates_distance0");
            @(negedge clk);
        end
        if (differences != 0) $fatal(1, "FAILED");
        $display("search_leaf: 4360 cycles, 4083 items, every output as the model's");
        passed = 1'b1;
    end
endmodule

// 1311 cycles of search_operators, which 1302 items leave.
module search_operators_replay(output reg passed = 1'b0);
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [63:0] words [0:2236];
    reg [123:0] vector = 0;
    reg [123:0] next = 0;
    wire [123:0] found;
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
        .a(vector[25:2]),
        .b(vector[49:26]),
        .c(vector[73:50]),
        .results_valid(found[74]),
        .results_add_0(found[98:75]),
        .results_mul_1(found[122:99]),
        .results_lt_2(found[123])
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
            if (changed[2]) begin take(75, 24); take(99, 24); take(123, 1); end
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
        for (cycle = 0; cycle < 1311 && differences == 0; cycle = cycle + 1) begin
            advance;
            #4;
            if (found[74] !== vector[74]) differ("results_valid");
            if (vector[74] && found[98:75] !== vector[98:75]) differ("results_add_0");
            if (vector[74] && found[122:99] !== vector[122:99]) differ("results_mul_1");
            if (vector[74] && found[123] !== vector[123]) differ("results_lt_2");
            @(negedge clk);
        end
        if (differences != 0) $fatal(1, "FAILED");
        $display("search_operators: 1311 cycles, 1302 items, every output as the model's");
        passed = 1'b1;
    end
endmodule

// The floating-point operators of a core side by side.
module search_operators (
    input  wire clk, input wire rst, input wire enable, input wire [23:0] a, input wire [23:0] b,
    input  wire [23:0] c,
    output wire results_valid, output wire [23:0] results_add_0, output wire [23:0] results_mul_1,
    output wire results_lt_2
);
    reg [2:0] taken;

    wire valid = taken == 3'd6;

    assign results_valid = valid;

    float_add_s6_f24ftz add_0 (.clk(clk), .enable(enable), .a(a), .b(b), .y(results_add_0));
    float_mul_s4_f24ftz mul_1 (.clk(clk), .enable(enable), .a(a), .b(b), .y(results_mul_1));
    float_lt_s1_f24ftz lt_2 (.clk(clk), .enable(enable), .a(a), .b(b), .y(results_lt_2));

    always @(posedge clk) begin
        if (rst) taken <= 3'd0;
        else taken <= (enable & ~valid) ? (taken + 3'd1) : taken;
    end

    wire _unused = &{1'b0, c};
endmodule
