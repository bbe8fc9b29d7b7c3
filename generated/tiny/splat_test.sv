// Written by pointcore 0.1.0; do not edit.
// Replays 39624 cycles of the bit-exact model at the ports of splat_top, in which 11743 items leave the core, and compares every output in every
// cycle; a stream's fields count while it is valid, and those that go in are spoilt while it is not. For Verilator, whose registers start at
// random values: in a simulator with unknown values, what is not reset stays unknown longer than in hardware.
//
// splat_test.hex is a sequence of bits: in every cycle one, whether anything changes, and if so one for each group of ports, whether it does,
// then the words of those that do.

module splat_test;
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [63:0] words [0:36788];
    reg [676:0] vector = 0;
    reg [676:0] next = 0;
    wire [676:0] found;
    reg changes;
    reg [6:0] changed;
    integer place = 0;
    integer i;
    integer cycle;
    integer differences = 0;

    splat_top core (
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
        .read_valid(found[298]),
        .read_ready(vector[299]),
        .read_tile(found[307:300]),
        .data_valid(vector[308]),
        .data_ready(found[309]),
        .data_weight(vector[308] ? vector[337:310] : ~vector[337:310]),
        .data_depth(vector[308] ? vector[389:338] : ~vector[389:338]),
        .data_attribute_0(vector[308] ? vector[405:390] : ~vector[405:390]),
        .data_attribute_1(vector[308] ? vector[421:406] : ~vector[421:406]),
        .data_attribute_2(vector[308] ? vector[437:422] : ~vector[437:422]),
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
            if (changed[0]) begin take(0, 1); take(1, 1); take(31, 1); take(32, 1); take(298, 1); take(299, 1); take(308, 1); take(309, 1); take(438, 1); take(439, 1); take(582, 1); take(583, 1); take(671, 1); take(672, 1); take(673, 1); take(674, 1); take(675, 1); take(676, 1); end
            if (changed[1]) begin take(2, 5); take(7, 24); end
            if (changed[2]) begin take(33, 1); take(34, 24); take(58, 24); take(82, 24); take(106, 24); take(130, 24); take(154, 24); take(178, 24); take(202, 24); take(226, 24); take(250, 16); take(266, 16); take(282, 16); end
            if (changed[3]) begin take(300, 8); end
            if (changed[4]) begin take(310, 28); take(338, 52); take(390, 16); take(406, 16); take(422, 16); end
            if (changed[5]) begin take(440, 8); take(448, 6); take(454, 28); take(482, 52); take(534, 16); take(550, 16); take(566, 16); end
            if (changed[6]) begin take(584, 1); take(585, 7); take(592, 7); take(599, 24); take(623, 16); take(639, 16); take(655, 16); end
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
        $readmemh("splat_test.hex", words);
        repeat (2) @(negedge clk);
        rst = 1'b0;
        for (cycle = 0; cycle < 39624 && differences == 0; cycle = cycle + 1) begin
            advance;
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
        $display("PASSED: 39624 cycles, 11743 items, every output as the model's");
        $finish;
    end
endmodule
