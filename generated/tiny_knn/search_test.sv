// Written by pointcore 0.1.0; do not edit.
// Replays 267699 cycles of the bit-exact model at the ports of search_top, in which 8810 items leave the core, and compares every output in every
// cycle; a stream's fields count while it is valid, and those that go in are spoilt while it is not. For Verilator, whose registers start at
// random values: in a simulator with unknown values, what is not reset stays unknown longer than in hardware.
//
// search_test.hex is a sequence of bits: in every cycle one, whether anything changes, and if so one for each group of ports, whether it does,
// then the words of those that do.

module search_test;
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

    search_top core (
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
            $display("cycle %0d: %0s differs from the model", cycle, port);
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
        $display("PASSED: 267699 cycles, 8810 items, every output as the model's");
        $finish;
    end
endmodule
