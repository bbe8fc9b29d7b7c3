// Written by pointcore 0.1.0; do not edit.
// Replays 34488 cycles of the bit-exact model at the ports of splat_top, in which 7748 items leave the core, and compares every output in every
// cycle; a stream's fields count while it is valid, and those that go in are spoilt while it is not. For Verilator, whose registers start at
// random values: in a simulator with unknown values, what is not reset stays unknown longer than in hardware.
//
// splat_test.hex is a sequence of bits: in every cycle one, whether anything changes, and if so one for each group of ports, whether it does,
// then the words of those that do.

module splat_test;
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [63:0] words [0:25710];
    reg [686:0] vector = 0;
    reg [686:0] next = 0;
    wire [686:0] found;
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
        .read_pixel(found[313:308]),
        .read_count(found[317:314]),
        .data_valid(vector[318]),
        .data_ready(found[319]),
        .data_weight(vector[318] ? vector[347:320] : ~vector[347:320]),
        .data_depth(vector[318] ? vector[399:348] : ~vector[399:348]),
        .data_attribute_0(vector[318] ? vector[415:400] : ~vector[415:400]),
        .data_attribute_1(vector[318] ? vector[431:416] : ~vector[431:416]),
        .data_attribute_2(vector[318] ? vector[447:432] : ~vector[447:432]),
        .write_valid(found[448]),
        .write_ready(vector[449]),
        .write_tile(found[457:450]),
        .write_pixel(found[463:458]),
        .write_weight(found[491:464]),
        .write_depth(found[543:492]),
        .write_attribute_0(found[559:544]),
        .write_attribute_1(found[575:560]),
        .write_attribute_2(found[591:576]),
        .fragment_valid(found[592]),
        .fragment_ready(vector[593]),
        .fragment_end(found[594]),
        .fragment_column(found[601:595]),
        .fragment_row(found[608:602]),
        .fragment_depth(found[632:609]),
        .fragment_attribute_0(found[648:633]),
        .fragment_attribute_1(found[664:649]),
        .fragment_attribute_2(found[680:665]),
        .event_sample(found[681]),
        .event_starved(found[682]),
        .event_blocked(found[683]),
        .event_accumulate(found[684]),
        .event_hazard(found[685]),
        .event_slot_wait(found[686])
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
            if (changed[0]) begin take(0, 1); take(1, 1); take(31, 1); take(32, 1); take(298, 1); take(299, 1); take(318, 1); take(319, 1); take(448, 1); take(449, 1); take(592, 1); take(593, 1); take(681, 1); take(682, 1); take(683, 1); take(684, 1); take(685, 1); take(686, 1); end
            if (changed[1]) begin take(2, 5); take(7, 24); end
            if (changed[2]) begin take(33, 1); take(34, 24); take(58, 24); take(82, 24); take(106, 24); take(130, 24); take(154, 24); take(178, 24); take(202, 24); take(226, 24); take(250, 16); take(266, 16); take(282, 16); end
            if (changed[3]) begin take(300, 8); take(308, 6); take(314, 4); end
            if (changed[4]) begin take(320, 28); take(348, 52); take(400, 16); take(416, 16); take(432, 16); end
            if (changed[5]) begin take(450, 8); take(458, 6); take(464, 28); take(492, 52); take(544, 16); take(560, 16); take(576, 16); end
            if (changed[6]) begin take(594, 1); take(595, 7); take(602, 7); take(609, 24); take(633, 16); take(649, 16); take(665, 16); end
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
        for (cycle = 0; cycle < 34488 && differences == 0; cycle = cycle + 1) begin
            advance;
            #4;
            if (found[32] !== vector[32]) differ("splat_ready");
            if (found[298] !== vector[298]) differ("read_valid");
            if (vector[298] && found[307:300] !== vector[307:300]) differ("read_tile");
            if (vector[298] && found[313:308] !== vector[313:308]) differ("read_pixel");
            if (vector[298] && found[317:314] !== vector[317:314]) differ("read_count");
            if (found[319] !== vector[319]) differ("data_ready");
            if (found[448] !== vector[448]) differ("write_valid");
            if (vector[448] && found[457:450] !== vector[457:450]) differ("write_tile");
            if (vector[448] && found[463:458] !== vector[463:458]) differ("write_pixel");
            if (vector[448] && found[491:464] !== vector[491:464]) differ("write_weight");
            if (vector[448] && found[543:492] !== vector[543:492]) differ("write_depth");
            if (vector[448] && found[559:544] !== vector[559:544]) differ("write_attribute_0");
            if (vector[448] && found[575:560] !== vector[575:560]) differ("write_attribute_1");
            if (vector[448] && found[591:576] !== vector[591:576]) differ("write_attribute_2");
            if (found[592] !== vector[592]) differ("fragment_valid");
            if (vector[592] && found[594] !== vector[594]) differ("fragment_end");
            if (vector[592] && !vector[594] && found[601:595] !== vector[601:595]) differ("fragment_column");
            if (vector[592] && !vector[594] && found[608:602] !== vector[608:602]) differ("fragment_row");
            if (vector[592] && !vector[594] && found[632:609] !== vector[632:609]) differ("fragment_depth");
            if (vector[592] && !vector[594] && found[648:633] !== vector[648:633]) differ("fragment_attribute_0");
            if (vector[592] && !vector[594] && found[664:649] !== vector[664:649]) differ("fragment_attribute_1");
            if (vector[592] && !vector[594] && found[680:665] !== vector[680:665]) differ("fragment_attribute_2");
            if (found[681] !== vector[681]) differ("event_sample");
            if (found[682] !== vector[682]) differ("event_starved");
            if (found[683] !== vector[683]) differ("event_blocked");
            if (found[684] !== vector[684]) differ("event_accumulate");
            if (found[685] !== vector[685]) differ("event_hazard");
            if (found[686] !== vector[686]) differ("event_slot_wait");
            @(negedge clk);
        end
        if (differences != 0) $fatal(1, "FAILED");
        $display("PASSED: 34488 cycles, 7748 items, every output as the model's");
        $finish;
    end
endmodule
