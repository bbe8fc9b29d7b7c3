// Written by pointcore 0.1.0; do not edit.
// Replays 36167 cycles of the bit-exact model at the ports of splat_top, in which 8248 items leave the core, and compares every output in every
// cycle; a stream's fields count while it is valid, and those that go in are spoilt while it is not. For Verilator, whose registers start at
// random values: in a simulator with unknown values, what is not reset stays unknown longer than in hardware.
//
// splat_test.hex is a sequence of bits: in every cycle one, whether anything changes, and if so one for each group of ports, whether it does,
// then the words of those that do.

module splat_test;
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [63:0] words [0:27188];
    reg [688:0] vector = 0;
    reg [688:0] next = 0;
    wire [688:0] found;
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
        .read_surface(found[300]),
        .read_tile(found[308:301]),
        .read_pixel(found[314:309]),
        .read_count(found[318:315]),
        .data_valid(vector[319]),
        .data_ready(found[320]),
        .data_weight(vector[319] ? vector[348:321] : ~vector[348:321]),
        .data_depth(vector[319] ? vector[400:349] : ~vector[400:349]),
        .data_attribute_0(vector[319] ? vector[416:401] : ~vector[416:401]),
        .data_attribute_1(vector[319] ? vector[432:417] : ~vector[432:417]),
        .data_attribute_2(vector[319] ? vector[448:433] : ~vector[448:433]),
        .write_valid(found[449]),
        .write_ready(vector[450]),
        .write_surface(found[451]),
        .write_tile(found[459:452]),
        .write_pixel(found[465:460]),
        .write_weight(found[493:466]),
        .write_depth(found[545:494]),
        .write_attribute_0(found[561:546]),
        .write_attribute_1(found[577:562]),
        .write_attribute_2(found[593:578]),
        .fragment_valid(found[594]),
        .fragment_ready(vector[595]),
        .fragment_end(found[596]),
        .fragment_column(found[603:597]),
        .fragment_row(found[610:604]),
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
            if (changed[0]) begin take(0, 1); take(1, 1); take(31, 1); take(32, 1); take(298, 1); take(299, 1); take(319, 1); take(320, 1); take(449, 1); take(450, 1); take(594, 1); take(595, 1); take(683, 1); take(684, 1); take(685, 1); take(686, 1); take(687, 1); take(688, 1); end
            if (changed[1]) begin take(2, 5); take(7, 24); end
            if (changed[2]) begin take(33, 1); take(34, 24); take(58, 24); take(82, 24); take(106, 24); take(130, 24); take(154, 24); take(178, 24); take(202, 24); take(226, 24); take(250, 16); take(266, 16); take(282, 16); end
            if (changed[3]) begin take(300, 1); take(301, 8); take(309, 6); take(315, 4); end
            if (changed[4]) begin take(321, 28); take(349, 52); take(401, 16); take(417, 16); take(433, 16); end
            if (changed[5]) begin take(451, 1); take(452, 8); take(460, 6); take(466, 28); take(494, 52); take(546, 16); take(562, 16); take(578, 16); end
            if (changed[6]) begin take(596, 1); take(597, 7); take(604, 7); take(611, 24); take(635, 16); take(651, 16); take(667, 16); end
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
        for (cycle = 0; cycle < 36167 && differences == 0; cycle = cycle + 1) begin
            advance;
            #4;
            if (found[32] !== vector[32]) differ("splat_ready");
            if (found[298] !== vector[298]) differ("read_valid");
            if (vector[298] && found[300] !== vector[300]) differ("read_surface");
            if (vector[298] && found[308:301] !== vector[308:301]) differ("read_tile");
            if (vector[298] && found[314:309] !== vector[314:309]) differ("read_pixel");
            if (vector[298] && found[318:315] !== vector[318:315]) differ("read_count");
            if (found[320] !== vector[320]) differ("data_ready");
            if (found[449] !== vector[449]) differ("write_valid");
            if (vector[449] && found[451] !== vector[451]) differ("write_surface");
            if (vector[449] && found[459:452] !== vector[459:452]) differ("write_tile");
            if (vector[449] && found[465:460] !== vector[465:460]) differ("write_pixel");
            if (vector[449] && found[493:466] !== vector[493:466]) differ("write_weight");
            if (vector[449] && found[545:494] !== vector[545:494]) differ("write_depth");
            if (vector[449] && found[561:546] !== vector[561:546]) differ("write_attribute_0");
            if (vector[449] && found[577:562] !== vector[577:562]) differ("write_attribute_1");
            if (vector[449] && found[593:578] !== vector[593:578]) differ("write_attribute_2");
            if (found[594] !== vector[594]) differ("fragment_valid");
            if (vector[594] && found[596] !== vector[596]) differ("fragment_end");
            if (vector[594] && !vector[596] && found[603:597] !== vector[603:597]) differ("fragment_column");
            if (vector[594] && !vector[596] && found[610:604] !== vector[610:604]) differ("fragment_row");
            if (vector[594] && !vector[596] && found[634:611] !== vector[634:611]) differ("fragment_depth");
            if (vector[594] && !vector[596] && found[650:635] !== vector[650:635]) differ("fragment_attribute_0");
            if (vector[594] && !vector[596] && found[666:651] !== vector[666:651]) differ("fragment_attribute_1");
            if (vector[594] && !vector[596] && found[682:667] !== vector[682:667]) differ("fragment_attribute_2");
            if (found[683] !== vector[683]) differ("event_sample");
            if (found[684] !== vector[684]) differ("event_starved");
            if (found[685] !== vector[685]) differ("event_blocked");
            if (found[686] !== vector[686]) differ("event_accumulate");
            if (found[687] !== vector[687]) differ("event_hazard");
            if (found[688] !== vector[688]) differ("event_slot_wait");
            @(negedge clk);
        end
        if (differences != 0) $fatal(1, "FAILED");
        $display("PASSED: 36167 cycles, 8248 items, every output as the model's");
        $finish;
    end
endmodule
