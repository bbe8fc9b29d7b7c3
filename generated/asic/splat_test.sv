// Written by pointcore 0.1.0; do not edit.
// Replays 98520 cycles of the bit-exact model at the ports of splat_top, in which 11316 items leave the core, and compares every output in every
// cycle; a stream's fields count while it is valid, and those that go in are spoilt while it is not. For Verilator, whose registers start at
// random values: in a simulator with unknown values, what is not reset stays unknown longer than in hardware.
//
// splat_test.hex is a sequence of bits: in every cycle one, whether anything changes, and if so one for each group of ports, whether it does,
// then the words of those that do.

module splat_test;
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [63:0] words [0:61631];
    reg [808:0] vector = 0;
    reg [808:0] next = 0;
    wire [808:0] found;
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
        .splat_attribute_0(vector[31] ? vector[261:250] : ~vector[261:250]),
        .splat_attribute_1(vector[31] ? vector[273:262] : ~vector[273:262]),
        .splat_attribute_2(vector[31] ? vector[285:274] : ~vector[285:274]),
        .read_valid(found[286]),
        .read_ready(vector[287]),
        .read_tile(found[299:288]),
        .data_valid(vector[300]),
        .data_ready(found[301]),
        .data_weight(vector[300] ? vector[329:302] : ~vector[329:302]),
        .data_depth(vector[300] ? vector[381:330] : ~vector[381:330]),
        .data_attribute_0(vector[300] ? vector[421:382] : ~vector[421:382]),
        .data_attribute_1(vector[300] ? vector[461:422] : ~vector[461:422]),
        .data_attribute_2(vector[300] ? vector[501:462] : ~vector[501:462]),
        .write_valid(found[502]),
        .write_ready(vector[503]),
        .write_tile(found[515:504]),
        .write_pixel(found[521:516]),
        .write_weight(found[549:522]),
        .write_depth(found[601:550]),
        .write_attribute_0(found[641:602]),
        .write_attribute_1(found[681:642]),
        .write_attribute_2(found[721:682]),
        .fragment_valid(found[722]),
        .fragment_ready(vector[723]),
        .fragment_end(found[724]),
        .fragment_column(found[733:725]),
        .fragment_row(found[742:734]),
        .fragment_depth(found[766:743]),
        .fragment_attribute_0(found[778:767]),
        .fragment_attribute_1(found[790:779]),
        .fragment_attribute_2(found[802:791]),
        .event_sample(found[803]),
        .event_starved(found[804]),
        .event_blocked(found[805]),
        .event_accumulate(found[806]),
        .event_hazard(found[807]),
        .event_slot_wait(found[808])
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
            if (changed[0]) begin take(0, 1); take(1, 1); take(31, 1); take(32, 1); take(286, 1); take(287, 1); take(300, 1); take(301, 1); take(502, 1); take(503, 1); take(722, 1); take(723, 1); take(803, 1); take(804, 1); take(805, 1); take(806, 1); take(807, 1); take(808, 1); end
            if (changed[1]) begin take(2, 5); take(7, 24); end
            if (changed[2]) begin take(33, 1); take(34, 24); take(58, 24); take(82, 24); take(106, 24); take(130, 24); take(154, 24); take(178, 24); take(202, 24); take(226, 24); take(250, 12); take(262, 12); take(274, 12); end
            if (changed[3]) begin take(288, 12); end
            if (changed[4]) begin take(302, 28); take(330, 52); take(382, 40); take(422, 40); take(462, 40); end
            if (changed[5]) begin take(504, 12); take(516, 6); take(522, 28); take(550, 52); take(602, 40); take(642, 40); take(682, 40); end
            if (changed[6]) begin take(724, 1); take(725, 9); take(734, 9); take(743, 24); take(767, 12); take(779, 12); take(791, 12); end
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
        for (cycle = 0; cycle < 98520 && differences == 0; cycle = cycle + 1) begin
            advance;
            #4;
            if (found[32] !== vector[32]) differ("splat_ready");
            if (found[286] !== vector[286]) differ("read_valid");
            if (vector[286] && found[299:288] !== vector[299:288]) differ("read_tile");
            if (found[301] !== vector[301]) differ("data_ready");
            if (found[502] !== vector[502]) differ("write_valid");
            if (vector[502] && found[515:504] !== vector[515:504]) differ("write_tile");
            if (vector[502] && found[521:516] !== vector[521:516]) differ("write_pixel");
            if (vector[502] && found[549:522] !== vector[549:522]) differ("write_weight");
            if (vector[502] && found[601:550] !== vector[601:550]) differ("write_depth");
            if (vector[502] && found[641:602] !== vector[641:602]) differ("write_attribute_0");
            if (vector[502] && found[681:642] !== vector[681:642]) differ("write_attribute_1");
            if (vector[502] && found[721:682] !== vector[721:682]) differ("write_attribute_2");
            if (found[722] !== vector[722]) differ("fragment_valid");
            if (vector[722] && found[724] !== vector[724]) differ("fragment_end");
            if (vector[722] && !vector[724] && found[733:725] !== vector[733:725]) differ("fragment_column");
            if (vector[722] && !vector[724] && found[742:734] !== vector[742:734]) differ("fragment_row");
            if (vector[722] && !vector[724] && found[766:743] !== vector[766:743]) differ("fragment_depth");
            if (vector[722] && !vector[724] && found[778:767] !== vector[778:767]) differ("fragment_attribute_0");
            if (vector[722] && !vector[724] && found[790:779] !== vector[790:779]) differ("fragment_attribute_1");
            if (vector[722] && !vector[724] && found[802:791] !== vector[802:791]) differ("fragment_attribute_2");
            if (found[803] !== vector[803]) differ("event_sample");
            if (found[804] !== vector[804]) differ("event_starved");
            if (found[805] !== vector[805]) differ("event_blocked");
            if (found[806] !== vector[806]) differ("event_accumulate");
            if (found[807] !== vector[807]) differ("event_hazard");
            if (found[808] !== vector[808]) differ("event_slot_wait");
            @(negedge clk);
        end
        if (differences != 0) $fatal(1, "FAILED");
        $display("PASSED: 98520 cycles, 11316 items, every output as the model's");
        $finish;
    end
endmodule
