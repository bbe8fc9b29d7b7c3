// Written by pointcore 0.1.0; do not edit.
// Replays 1515 cycles of the bit-exact model at the ports of search_top, in which 102 items leave the core, and compares every output in every
// cycle; a stream's fields count while it is valid. For Verilator, whose registers start at random values: in a simulator with unknown
// values, what is not reset stays unknown longer than in hardware.

module search_test;
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [356:0] vectors [0:1514];
    reg [356:0] vector = 0;
    wire [356:0] found;
    integer cycle;
    integer differences = 0;

    search_top core (
        .clk(clk),
        .rst(rst),
        .tree_valid(vector[1]),
        .tree_is_leaf(vector[2]),
        .tree_address(vector[8:3]),
        .tree_split(vector[32:9]),
        .tree_dimension(vector[34:33]),
        .tree_internal_leaf(vector[35]),
        .tree_begin(vector[51:36]),
        .tree_beats(vector[55:52]),
        .query_valid(vector[56]),
        .query_ready(found[57]),
        .query_number(vector[73:58]),
        .query_k(vector[77:74]),
        .query_radius2(vector[101:78]),
        .query_x(vector[125:102]),
        .query_y(vector[149:126]),
        .query_z(vector[173:150]),
        .fetch_valid(found[174]),
        .fetch_ready(vector[175]),
        .fetch_thread(found[177:176]),
        .fetch_address(found[193:178]),
        .fetch_beats(found[197:194]),
        .beat_valid(vector[198]),
        .beat_ready(found[199]),
        .beat_thread(vector[201:200]),
        .beat_address(vector[217:202]),
        .beat_last(vector[218]),
        .beat_x0(vector[242:219]),
        .beat_y0(vector[266:243]),
        .beat_z0(vector[290:267]),
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
        .event_insert_wait(found[355]),
        .event_thread_wait(found[356])
    );

    always #5 clk = !clk;

    task differ(input [8*32-1:0] port);
        begin
            differences = differences + 1;
            $display("cycle %0d: %0s differs from the model", cycle, port);
        end
    endtask

    initial begin
        $readmemh("search_test.hex", vectors);
        repeat (2) @(negedge clk);
        rst = 1'b0;
        repeat (0) @(negedge clk);
        for (cycle = 0; cycle < 1515 && differences == 0; cycle = cycle + 1) begin
            vector = vectors[cycle];
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
            if (found[355] !== vector[355]) differ("event_insert_wait");
            if (found[356] !== vector[356]) differ("event_thread_wait");
            @(negedge clk);
        end
        if (differences != 0) $fatal(1, "FAILED");
        $display("PASSED: 1515 cycles, 102 items, every output as the model's");
        $finish;
    end
endmodule
