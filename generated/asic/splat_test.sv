// Written by pointcore 0.1.0; do not edit.
// Replays 2279 cycles of the bit-exact model at the ports of splat_top, in which 909 items leave the core, and compares every output in every
// cycle; a stream's fields count while it is valid. For Verilator, whose registers start at random values: in a simulator with unknown
// values, what is not reset stays unknown longer than in hardware.

module splat_test;
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [688:0] vectors [0:2278];
    reg [688:0] vector = 0;
    wire [688:0] found;
    integer cycle;
    integer differences = 0;

    splat_top core (
        .clk(clk),
        .rst(rst),
        .uniform_valid(vector[1]),
        .uniform_address(vector[6:2]),
        .uniform_data(vector[30:7]),
        .splat_valid(vector[31]),
        .splat_ready(found[32]),
        .splat_end(vector[33]),
        .splat_center_x(vector[57:34]),
        .splat_center_y(vector[81:58]),
        .splat_center_z(vector[105:82]),
        .splat_tangent1_x(vector[129:106]),
        .splat_tangent1_y(vector[153:130]),
        .splat_tangent1_z(vector[177:154]),
        .splat_tangent2_x(vector[201:178]),
        .splat_tangent2_y(vector[225:202]),
        .splat_tangent2_z(vector[249:226]),
        .splat_attribute_0(vector[265:250]),
        .splat_attribute_1(vector[281:266]),
        .splat_attribute_2(vector[297:282]),
        .read_valid(found[298]),
        .read_ready(vector[299]),
        .read_tile(found[311:300]),
        .data_valid(vector[312]),
        .data_ready(found[313]),
        .data_weight(vector[341:314]),
        .data_depth(vector[393:342]),
        .data_attribute_0(vector[409:394]),
        .data_attribute_1(vector[425:410]),
        .data_attribute_2(vector[441:426]),
        .write_valid(found[442]),
        .write_ready(vector[443]),
        .write_tile(found[455:444]),
        .write_pixel(found[461:456]),
        .write_weight(found[489:462]),
        .write_depth(found[541:490]),
        .write_attribute_0(found[557:542]),
        .write_attribute_1(found[573:558]),
        .write_attribute_2(found[589:574]),
        .fragment_valid(found[590]),
        .fragment_ready(vector[591]),
        .fragment_end(found[592]),
        .fragment_column(found[601:593]),
        .fragment_row(found[610:602]),
        .fragment_depth(found[634:611]),
        .fragment_attribute_0(found[650:635]),
        .fragment_attribute_1(found[666:651]),
        .fragment_attribute_2(found[682:667]),
        .event_sample(found[683]),
        .event_starved(found[684]),
        .event_blocked(found[685]),
        .event_accumulate(found[686]),
        .event_hazard(found[687]),
        .event_slot_wait(found[688])
    );

    always #5 clk = !clk;

    task differ(input [8*32-1:0] port);
        begin
            differences = differences + 1;
            $display("cycle %0d: %0s differs from the model", cycle, port);
        end
    endtask

    initial begin
        $readmemh("splat_test.hex", vectors);
        repeat (2) @(negedge clk);
        rst = 1'b0;
        repeat (4104) @(negedge clk);
        for (cycle = 0; cycle < 2279 && differences == 0; cycle = cycle + 1) begin
            vector = vectors[cycle];
            #4;
            if (found[32] !== vector[32]) differ("splat_ready");
            if (found[298] !== vector[298]) differ("read_valid");
            if (vector[298] && found[311:300] !== vector[311:300]) differ("read_tile");
            if (found[313] !== vector[313]) differ("data_ready");
            if (found[442] !== vector[442]) differ("write_valid");
            if (vector[442] && found[455:444] !== vector[455:444]) differ("write_tile");
            if (vector[442] && found[461:456] !== vector[461:456]) differ("write_pixel");
            if (vector[442] && found[489:462] !== vector[489:462]) differ("write_weight");
            if (vector[442] && found[541:490] !== vector[541:490]) differ("write_depth");
            if (vector[442] && found[557:542] !== vector[557:542]) differ("write_attribute_0");
            if (vector[442] && found[573:558] !== vector[573:558]) differ("write_attribute_1");
            if (vector[442] && found[589:574] !== vector[589:574]) differ("write_attribute_2");
            if (found[590] !== vector[590]) differ("fragment_valid");
            if (vector[590] && found[592] !== vector[592]) differ("fragment_end");
            if (vector[590] && !vector[592] && found[601:593] !== vector[601:593]) differ("fragment_column");
            if (vector[590] && !vector[592] && found[610:602] !== vector[610:602]) differ("fragment_row");
            if (vector[590] && !vector[592] && found[634:611] !== vector[634:611]) differ("fragment_depth");
            if (vector[590] && !vector[592] && found[650:635] !== vector[650:635]) differ("fragment_attribute_0");
            if (vector[590] && !vector[592] && found[666:651] !== vector[666:651]) differ("fragment_attribute_1");
            if (vector[590] && !vector[592] && found[682:667] !== vector[682:667]) differ("fragment_attribute_2");
            if (found[683] !== vector[683]) differ("event_sample");
            if (found[684] !== vector[684]) differ("event_starved");
            if (found[685] !== vector[685]) differ("event_blocked");
            if (found[686] !== vector[686]) differ("event_accumulate");
            if (found[687] !== vector[687]) differ("event_hazard");
            if (found[688] !== vector[688]) differ("event_slot_wait");
            @(negedge clk);
        end
        if (differences != 0) $fatal(1, "FAILED");
        $display("PASSED: 2279 cycles, 909 items, every output as the model's");
        $finish;
    end
endmodule
