// Written by pointcore 0.1.0; do not edit.
// Replays 80626 cycles of the bit-exact model at the ports of splat_top, in which 18934 items leave the core, and compares every output in every
// cycle; a stream's fields count while it is valid, and those that go in are spoilt while it is not. For Verilator, whose registers start at
// random values: in a simulator with unknown values, what is not reset stays unknown longer than in hardware.
//
// splat_test.hex is a sequence of bits: in every cycle one, whether anything changes, and if so one for each group of ports, whether it does,
// then the words of those that do.

module splat_test;
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [63:0] words [0:73258];
    reg [689:0] vector = 0;
    reg [689:0] next = 0;
    wire [689:0] found;
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
        .frame_set_up(found[298]),
        .read_valid(found[299]),
        .read_ready(vector[300]),
        .read_surface(found[301]),
        .read_tile(found[309:302]),
        .read_pixel(found[315:310]),
        .read_count(found[319:316]),
        .data_valid(vector[320]),
        .data_ready(found[321]),
        .data_weight(vector[320] ? vector[349:322] : ~vector[349:322]),
        .data_depth(vector[320] ? vector[401:350] : ~vector[401:350]),
        .data_attribute_0(vector[320] ? vector[417:402] : ~vector[417:402]),
        .data_attribute_1(vector[320] ? vector[433:418] : ~vector[433:418]),
        .data_attribute_2(vector[320] ? vector[449:434] : ~vector[449:434]),
        .write_valid(found[450]),
        .write_ready(vector[451]),
        .write_surface(found[452]),
        .write_tile(found[460:453]),
        .write_pixel(found[466:461]),
        .write_weight(found[494:467]),
        .write_depth(found[546:495]),
        .write_attribute_0(found[562:547]),
        .write_attribute_1(found[578:563]),
        .write_attribute_2(found[594:579]),
        .fragment_valid(found[595]),
        .fragment_ready(vector[596]),
        .fragment_end(found[597]),
        .fragment_column(found[604:598]),
        .fragment_row(found[611:605]),
        .fragment_depth(found[635:612]),
        .fragment_attribute_0(found[651:636]),
        .fragment_attribute_1(found[667:652]),
        .fragment_attribute_2(found[683:668]),
        .event_sample(found[684]),
        .event_starved(found[685]),
        .event_blocked(found[686]),
        .event_accumulate(found[687]),
        .event_hazard(found[688]),
        .event_slot_wait(found[689])
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
            if (changed[0]) begin take(0, 1); take(1, 1); take(31, 1); take(32, 1); take(298, 1); take(299, 1); take(300, 1); take(320, 1); take(321, 1); take(450, 1); take(451, 1); take(595, 1); take(596, 1); take(684, 1); take(685, 1); take(686, 1); take(687, 1); take(688, 1); take(689, 1); end
            if (changed[1]) begin take(2, 5); take(7, 24); end
            if (changed[2]) begin take(33, 1); take(34, 24); take(58, 24); take(82, 24); take(106, 24); take(130, 24); take(154, 24); take(178, 24); take(202, 24); take(226, 24); take(250, 16); take(266, 16); take(282, 16); end
            if (changed[3]) begin take(301, 1); take(302, 8); take(310, 6); take(316, 4); end
            if (changed[4]) begin take(322, 28); take(350, 52); take(402, 16); take(418, 16); take(434, 16); end
            if (changed[5]) begin take(452, 1); take(453, 8); take(461, 6); take(467, 28); take(495, 52); take(547, 16); take(563, 16); take(579, 16); end
            if (changed[6]) begin take(597, 1); take(598, 7); take(605, 7); take(612, 24); take(636, 16); take(652, 16); take(668, 16); end
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
        repeat (1) @(negedge clk);
        rst = 1'b0;
        for (cycle = 0; cycle < 80626 && differences == 0; cycle = cycle + 1) begin
            advance;
            #4;
            if (found[32] !== vector[32]) differ("splat_ready");
            if (found[298] !== vector[298]) differ("frame_set_up");
            if (found[299] !== vector[299]) differ("read_valid");
            if (vector[299] && found[301] !== vector[301]) differ("read_surface");
            if (vector[299] && found[309:302] !== vector[309:302]) differ("read_tile");
            if (vector[299] && found[315:310] !== vector[315:310]) differ("read_pixel");
            if (vector[299] && found[319:316] !== vector[319:316]) differ("read_count");
            if (found[321] !== vector[321]) differ("data_ready");
            if (found[450] !== vector[450]) differ("write_valid");
            if (vector[450] && found[452] !== vector[452]) differ("write_surface");
            if (vector[450] && found[460:453] !== vector[460:453]) differ("write_tile");
            if (vector[450] && found[466:461] !== vector[466:461]) differ("write_pixel");
            if (vector[450] && found[494:467] !== vector[494:467]) differ("write_weight");
            if (vector[450] && found[546:495] !== vector[546:495]) differ("write_depth");
            if (vector[450] && found[562:547] !== vector[562:547]) differ("write_attribute_0");
            if (vector[450] && found[578:563] !== vector[578:563]) differ("write_attribute_1");
            if (vector[450] && found[594:579] !== vector[594:579]) differ("write_attribute_2");
            if (found[595] !== vector[595]) differ("fragment_valid");
            if (vector[595] && found[597] !== vector[597]) differ("fragment_end");
            if (vector[595] && !vector[597] && found[604:598] !== vector[604:598]) differ("fragment_column");
            if (vector[595] && !vector[597] && found[611:605] !== vector[611:605]) differ("fragment_row");
            if (vector[595] && !vector[597] && found[635:612] !== vector[635:612]) differ("fragment_depth");
            if (vector[595] && !vector[597] && found[651:636] !== vector[651:636]) differ("fragment_attribute_0");
            if (vector[595] && !vector[597] && found[667:652] !== vector[667:652]) differ("fragment_attribute_1");
            if (vector[595] && !vector[597] && found[683:668] !== vector[683:668]) differ("fragment_attribute_2");
            if (found[684] !== vector[684]) differ("event_sample");
            if (found[685] !== vector[685]) differ("event_starved");
            if (found[686] !== vector[686]) differ("event_blocked");
            if (found[687] !== vector[687]) differ("event_accumulate");
            if (found[688] !== vector[688]) differ("event_hazard");
            if (found[689] !== vector[689]) differ("event_slot_wait");
            @(negedge clk);
        end
        if (differences != 0) $fatal(1, "FAILED");
        $display("PASSED: 80626 cycles, 18934 items, every output as the model's");
        $finish;
    end
endmodule
