// Written by pointcore 0.1.0; do not edit.
// Replays 1652 cycles of the bit-exact model at the ports of splat_top, in which 141 items leave the core, and compares every output in every
// cycle; a stream's fields count while it is valid. For Verilator, whose registers start at random values: in a simulator with unknown
// values, what is not reset stays unknown longer than in hardware.

module splat_test;
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [676:0] vectors [0:1651];
    reg [676:0] vector = 0;
    wire [676:0] found;
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
        .read_tile(found[307:300]),
        .data_valid(vector[308]),
        .data_ready(found[309]),
        .data_weight(vector[337:310]),
        .data_depth(vector[389:338]),
        .data_attribute_0(vector[405:390]),
        .data_attribute_1(vector[421:406]),
        .data_attribute_2(vector[437:422]),
        .write_valid(found[438]),
        .write_ready(vector[439]),
        .write_tile(found[447:440]),
        .write_pixel(found[453:448]),
        .write_weight(found[481:454]),
        .write_depth(found[533:482]),
        .write_attribute_0(found[549:534]),
        .write_attribute_1(found[565:550]),
        .write_attribute_2(found[581:566]),
        .fragment_valid(found[582]),
        .fragment_ready(vector[583]),
        .fragment_end(found[584]),
        .fragment_column(found[591:585]),
        .fragment_row(found[598:592]),
        .fragment_depth(found[622:599]),
        .fragment_attribute_0(found[638:623]),
        .fragment_attribute_1(found[654:639]),
        .fragment_attribute_2(found[670:655]),
        .event_sample(found[671]),
        .event_starved(found[672]),
        .event_blocked(found[673]),
        .event_accumulate(found[674]),
        .event_hazard(found[675]),
        .event_slot_wait(found[676])
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
        repeat (264) @(negedge clk);
        for (cycle = 0; cycle < 1652 && differences == 0; cycle = cycle + 1) begin
            vector = vectors[cycle];
            #4;
            if (found[32] !== vector[32]) differ("splat_ready");
            if (found[298] !== vector[298]) differ("read_valid");
            if (vector[298] && found[307:300] !== vector[307:300]) differ("read_tile");
            if (found[309] !== vector[309]) differ("data_ready");
            if (found[438] !== vector[438]) differ("write_valid");
            if (vector[438] && found[447:440] !== vector[447:440]) differ("write_tile");
            if (vector[438] && found[453:448] !== vector[453:448]) differ("write_pixel");
            if (vector[438] && found[481:454] !== vector[481:454]) differ("write_weight");
            if (vector[438] && found[533:482] !== vector[533:482]) differ("write_depth");
            if (vector[438] && found[549:534] !== vector[549:534]) differ("write_attribute_0");
            if (vector[438] && found[565:550] !== vector[565:550]) differ("write_attribute_1");
            if (vector[438] && found[581:566] !== vector[581:566]) differ("write_attribute_2");
            if (found[582] !== vector[582]) differ("fragment_valid");
            if (vector[582] && found[584] !== vector[584]) differ("fragment_end");
            if (vector[582] && !vector[584] && found[591:585] !== vector[591:585]) differ("fragment_column");
            if (vector[582] && !vector[584] && found[598:592] !== vector[598:592]) differ("fragment_row");
            if (vector[582] && !vector[584] && found[622:599] !== vector[622:599]) differ("fragment_depth");
            if (vector[582] && !vector[584] && found[638:623] !== vector[638:623]) differ("fragment_attribute_0");
            if (vector[582] && !vector[584] && found[654:639] !== vector[654:639]) differ("fragment_attribute_1");
            if (vector[582] && !vector[584] && found[670:655] !== vector[670:655]) differ("fragment_attribute_2");
            if (found[671] !== vector[671]) differ("event_sample");
            if (found[672] !== vector[672]) differ("event_starved");
            if (found[673] !== vector[673]) differ("event_blocked");
            if (found[674] !== vector[674]) differ("event_accumulate");
            if (found[675] !== vector[675]) differ("event_hazard");
            if (found[676] !== vector[676]) differ("event_slot_wait");
            @(negedge clk);
        end
        if (differences != 0) $fatal(1, "FAILED");
        $display("PASSED: 1652 cycles, 141 items, every output as the model's");
        $finish;
    end
endmodule
