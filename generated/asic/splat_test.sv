// Written by pointcore 0.1.0; do not edit.
// Replays 126382 cycles of the bit-exact model at the ports of splat_top, in which 7205 items leave the core, and compares every output in every
// cycle; a stream's fields count while it is valid, and those that go in are spoilt while it is not. For Verilator, whose registers start at
// random values: in a simulator with unknown values, what is not reset stays unknown longer than in hardware.
//
// splat_test.hex is a sequence of bits: in every cycle one, whether anything changes, and if so one for each group of ports, whether it does,
// then the words of those that do.

module splat_test;
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [63:0] words [0:49340];
    reg [820:0] vector = 0;
    reg [820:0] next = 0;
    wire [820:0] found;
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
        .read_surface(found[288]),
        .read_tile(found[300:289]),
        .read_pixel(found[306:301]),
        .read_count(found[310:307]),
        .data_valid(vector[311]),
        .data_ready(found[312]),
        .data_weight(vector[311] ? vector[340:313] : ~vector[340:313]),
        .data_depth(vector[311] ? vector[392:341] : ~vector[392:341]),
        .data_attribute_0(vector[311] ? vector[432:393] : ~vector[432:393]),
        .data_attribute_1(vector[311] ? vector[472:433] : ~vector[472:433]),
        .data_attribute_2(vector[311] ? vector[512:473] : ~vector[512:473]),
        .write_valid(found[513]),
        .write_ready(vector[514]),
        .write_surface(found[515]),
        .write_tile(found[527:516]),
        .write_pixel(found[533:528]),
        .write_weight(found[561:534]),
        .write_depth(found[613:562]),
        .write_attribute_0(found[653:614]),
        .write_attribute_1(found[693:654]),
        .write_attribute_2(found[733:694]),
        .fragment_valid(found[734]),
        .fragment_ready(vector[735]),
        .fragment_end(found[736]),
        .fragment_column(found[745:737]),
        .fragment_row(found[754:746]),
        .fragment_depth(found[778:755]),
        .fragment_attribute_0(found[790:779]),
        .fragment_attribute_1(found[802:791]),
        .fragment_attribute_2(found[814:803]),
        .event_sample(found[815]),
        .event_starved(found[816]),
        .event_blocked(found[817]),
        .event_accumulate(found[818]),
        .event_hazard(found[819]),
        .event_slot_wait(found[820])
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
            if (changed[0]) begin take(0, 1); take(1, 1); take(31, 1); take(32, 1); take(286, 1); take(287, 1); take(311, 1); take(312, 1); take(513, 1); take(514, 1); take(734, 1); take(735, 1); take(815, 1); take(816, 1); take(817, 1); take(818, 1); take(819, 1); take(820, 1); end
            if (changed[1]) begin take(2, 5); take(7, 24); end
            if (changed[2]) begin take(33, 1); take(34, 24); take(58, 24); take(82, 24); take(106, 24); take(130, 24); take(154, 24); take(178, 24); take(202, 24); take(226, 24); take(250, 12); take(262, 12); take(274, 12); end
            if (changed[3]) begin take(288, 1); take(289, 12); take(301, 6); take(307, 4); end
            if (changed[4]) begin take(313, 28); take(341, 52); take(393, 40); take(433, 40); take(473, 40); end
            if (changed[5]) begin take(515, 1); take(516, 12); take(528, 6); take(534, 28); take(562, 52); take(614, 40); take(654, 40); take(694, 40); end
            if (changed[6]) begin take(736, 1); take(737, 9); take(746, 9); take(755, 24); take(779, 12); take(791, 12); take(803, 12); end
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
        for (cycle = 0; cycle < 126382 && differences == 0; cycle = cycle + 1) begin
            advance;
            #4;
            if (found[32] !== vector[32]) differ("splat_ready");
            if (found[286] !== vector[286]) differ("read_valid");
            if (vector[286] && found[288] !== vector[288]) differ("read_surface");
            if (vector[286] && found[300:289] !== vector[300:289]) differ("read_tile");
            if (vector[286] && found[306:301] !== vector[306:301]) differ("read_pixel");
            if (vector[286] && found[310:307] !== vector[310:307]) differ("read_count");
            if (found[312] !== vector[312]) differ("data_ready");
            if (found[513] !== vector[513]) differ("write_valid");
            if (vector[513] && found[515] !== vector[515]) differ("write_surface");
            if (vector[513] && found[527:516] !== vector[527:516]) differ("write_tile");
            if (vector[513] && found[533:528] !== vector[533:528]) differ("write_pixel");
            if (vector[513] && found[561:534] !== vector[561:534]) differ("write_weight");
            if (vector[513] && found[613:562] !== vector[613:562]) differ("write_depth");
            if (vector[513] && found[653:614] !== vector[653:614]) differ("write_attribute_0");
            if (vector[513] && found[693:654] !== vector[693:654]) differ("write_attribute_1");
            if (vector[513] && found[733:694] !== vector[733:694]) differ("write_attribute_2");
            if (found[734] !== vector[734]) differ("fragment_valid");
            if (vector[734] && found[736] !== vector[736]) differ("fragment_end");
            if (vector[734] && !vector[736] && found[745:737] !== vector[745:737]) differ("fragment_column");
            if (vector[734] && !vector[736] && found[754:746] !== vector[754:746]) differ("fragment_row");
            if (vector[734] && !vector[736] && found[778:755] !== vector[778:755]) differ("fragment_depth");
            if (vector[734] && !vector[736] && found[790:779] !== vector[790:779]) differ("fragment_attribute_0");
            if (vector[734] && !vector[736] && found[802:791] !== vector[802:791]) differ("fragment_attribute_1");
            if (vector[734] && !vector[736] && found[814:803] !== vector[814:803]) differ("fragment_attribute_2");
            if (found[815] !== vector[815]) differ("event_sample");
            if (found[816] !== vector[816]) differ("event_starved");
            if (found[817] !== vector[817]) differ("event_blocked");
            if (found[818] !== vector[818]) differ("event_accumulate");
            if (found[819] !== vector[819]) differ("event_hazard");
            if (found[820] !== vector[820]) differ("event_slot_wait");
            @(negedge clk);
        end
        if (differences != 0) $fatal(1, "FAILED");
        $display("PASSED: 126382 cycles, 7205 items, every output as the model's");
        $finish;
    end
endmodule
