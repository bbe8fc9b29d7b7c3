// Written by pointcore 0.1.0; do not edit.
// Replays 220587 cycles of the bit-exact model at the ports of search_top, in which 17107 items leave the core, and compares every output in every
// cycle; a stream's fields count while it is valid, and those that go in are spoilt while it is not. For Verilator, whose registers start at
// random values: in a simulator with unknown values, what is not reset stays unknown longer than in hardware.
//
// search_test.hex is a sequence of bits: in every cycle one, whether anything changes, and if so one for each group of ports, whether it does,
// then the words of those that do.

module search_test;
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [63:0] words [0:103287];
    reg [913:0] vector = 0;
    reg [913:0] next = 0;
    wire [913:0] found;
    reg changes;
    reg [7:0] changed;
    integer place = 0;
    integer i;
    integer cycle;
    integer differences = 0;

    search_top core (
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
            $display("cycle %0d: %0s differs from the model", cycle, port);
        end
    endtask

    initial begin
        $readmemh("search_test.hex", words);
        repeat (1) @(negedge clk);
        rst = 1'b0;
        for (cycle = 0; cycle < 220587 && differences == 0; cycle = cycle + 1) begin
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
        $display("PASSED: 220587 cycles, 17107 items, every output as the model's");
        $finish;
    end
endmodule
