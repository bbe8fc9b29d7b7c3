// Written by pointcore 0.1.0; do not edit.
// Replays 173183 cycles of the bit-exact model at the ports of search_top, in which 12297 items leave the core, and compares every output in every
// cycle; a stream's fields count while it is valid, and those that go in are spoilt while it is not. For Verilator, whose registers start at
// random values: in a simulator with unknown values, what is not reset stays unknown longer than in hardware.
//
// search_test.hex is a sequence of bits: in every cycle one, whether anything changes, and if so one for each group of ports, whether it does,
// then the words of those that do.

module search_test;
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [63:0] words [0:74685];
    reg [772:0] vector = 0;
    reg [772:0] next = 0;
    wire [772:0] found;
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
        .tree_address(vector[1] ? vector[16:3] : ~vector[16:3]),
        .tree_split(vector[1] ? vector[48:17] : ~vector[48:17]),
        .tree_dimension(vector[1] ? vector[50:49] : ~vector[50:49]),
        .tree_internal_leaf(vector[1] ? vector[51] : ~vector[51]),
        .tree_begin(vector[1] ? vector[73:52] : ~vector[73:52]),
        .tree_beats(vector[1] ? vector[76:74] : ~vector[76:74]),
        .query_valid(vector[77]),
        .query_ready(found[78]),
        .query_number(vector[77] ? vector[102:79] : ~vector[102:79]),
        .query_k(vector[77] ? vector[108:103] : ~vector[108:103]),
        .query_radius2(vector[77] ? vector[140:109] : ~vector[140:109]),
        .query_x(vector[77] ? vector[172:141] : ~vector[172:141]),
        .query_y(vector[77] ? vector[204:173] : ~vector[204:173]),
        .query_z(vector[77] ? vector[236:205] : ~vector[236:205]),
        .fetch_valid(found[237]),
        .fetch_ready(vector[238]),
        .fetch_thread(found[242:239]),
        .fetch_address(found[264:243]),
        .fetch_beats(found[267:265]),
        .beat_valid(vector[268]),
        .beat_ready(found[269]),
        .beat_thread(vector[268] ? vector[273:270] : ~vector[273:270]),
        .beat_address(vector[268] ? vector[295:274] : ~vector[295:274]),
        .beat_last(vector[268] ? vector[296] : ~vector[296]),
        .beat_x0(vector[268] ? vector[328:297] : ~vector[328:297]),
        .beat_y0(vector[268] ? vector[360:329] : ~vector[360:329]),
        .beat_z0(vector[268] ? vector[392:361] : ~vector[392:361]),
        .beat_x1(vector[268] ? vector[424:393] : ~vector[424:393]),
        .beat_y1(vector[268] ? vector[456:425] : ~vector[456:425]),
        .beat_z1(vector[268] ? vector[488:457] : ~vector[488:457]),
        .beat_x2(vector[268] ? vector[520:489] : ~vector[520:489]),
        .beat_y2(vector[268] ? vector[552:521] : ~vector[552:521]),
        .beat_z2(vector[268] ? vector[584:553] : ~vector[584:553]),
        .beat_x3(vector[268] ? vector[616:585] : ~vector[616:585]),
        .beat_y3(vector[268] ? vector[648:617] : ~vector[648:617]),
        .beat_z3(vector[268] ? vector[680:649] : ~vector[680:649]),
        .result_valid(found[681]),
        .result_ready(vector[682]),
        .result_number(found[706:683]),
        .result_last(found[707]),
        .result_found(found[708]),
        .result_index(found[732:709]),
        .result_distance2(found[764:733]),
        .event_node(found[765]),
        .event_pop(found[766]),
        .event_beat(found[767]),
        .event_insert(found[768]),
        .event_insert_wait(found[769]),
        .event_thread_wait(found[770]),
        .event_point_hit(found[771]),
        .event_point_miss(found[772])
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
            if (changed[0]) begin take(0, 1); take(1, 1); take(77, 1); take(78, 1); take(237, 1); take(238, 1); take(268, 1); take(269, 1); take(681, 1); take(682, 1); take(765, 1); take(766, 1); take(767, 1); take(768, 1); take(769, 1); take(770, 1); take(771, 1); take(772, 1); end
            if (changed[1]) begin take(2, 1); take(3, 14); take(17, 32); take(49, 2); take(51, 1); take(52, 22); take(74, 3); end
            if (changed[2]) begin take(79, 24); take(103, 6); take(109, 32); take(141, 32); take(173, 32); take(205, 32); end
            if (changed[3]) begin take(239, 4); take(243, 22); take(265, 3); end
            if (changed[4]) begin take(270, 4); take(274, 22); take(296, 1); take(297, 32); take(329, 32); take(361, 32); take(393, 32); take(425, 32); take(457, 32); take(489, 32); take(521, 32); take(553, 32); take(585, 32); take(617, 32); take(649, 32); end
            if (changed[5]) begin take(683, 24); take(707, 1); take(708, 1); take(709, 24); take(733, 32); end
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
        for (cycle = 0; cycle < 173183 && differences == 0; cycle = cycle + 1) begin
            advance;
            #4;
            if (found[78] !== vector[78]) differ("query_ready");
            if (found[237] !== vector[237]) differ("fetch_valid");
            if (vector[237] && found[242:239] !== vector[242:239]) differ("fetch_thread");
            if (vector[237] && found[264:243] !== vector[264:243]) differ("fetch_address");
            if (vector[237] && found[267:265] !== vector[267:265]) differ("fetch_beats");
            if (found[269] !== vector[269]) differ("beat_ready");
            if (found[681] !== vector[681]) differ("result_valid");
            if (vector[681] && found[706:683] !== vector[706:683]) differ("result_number");
            if (vector[681] && found[707] !== vector[707]) differ("result_last");
            if (vector[681] && found[708] !== vector[708]) differ("result_found");
            if (vector[681] && found[732:709] !== vector[732:709]) differ("result_index");
            if (vector[681] && found[764:733] !== vector[764:733]) differ("result_distance2");
            if (found[765] !== vector[765]) differ("event_node");
            if (found[766] !== vector[766]) differ("event_pop");
            if (found[767] !== vector[767]) differ("event_beat");
            if (found[768] !== vector[768]) differ("event_insert");
            if (found[769] !== vector[769]) differ("event_insert_wait");
            if (found[770] !== vector[770]) differ("event_thread_wait");
            if (found[771] !== vector[771]) differ("event_point_hit");
            if (found[772] !== vector[772]) differ("event_point_miss");
            @(negedge clk);
        end
        if (differences != 0) $fatal(1, "FAILED");
        $display("PASSED: 173183 cycles, 12297 items, every output as the model's");
        $finish;
    end
endmodule
