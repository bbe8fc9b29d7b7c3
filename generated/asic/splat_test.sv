// Written by pointcore 0.1.0; do not edit.
// Replays 219047 cycles of the bit-exact model at the ports of splat_top, in which 21247 items leave the core, and compares every output in every
// cycle; a stream's fields count while it is valid, and those that go in are spoilt while it is not. For Verilator, whose registers start at
// random values: in a simulator with unknown values, what is not reset stays unknown longer than in hardware.
//
// splat_test.hex is a sequence of bits: in every cycle one, whether anything changes, and if so one for each group of ports, whether it does,
// then the words of those that do.

module splat_test;
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [63:0] words [0:124276];
    reg [821:0] vector = 0;
    reg [821:0] next = 0;
    wire [821:0] found;
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
        .frame_set_up(found[286]),
        .read_valid(found[287]),
        .read_ready(vector[288]),
        .read_surface(found[289]),
        .read_tile(found[301:290]),
        .read_pixel(found[307:302]),
        .read_count(found[311:308]),
        .data_valid(vector[312]),
        .data_ready(found[313]),
        .data_weight(vector[312] ? vector[341:314] : ~vector[341:314]),
        .data_depth(vector[312] ? vector[393:342] : ~vector[393:342]),
        .data_attribute_0(vector[312] ? vector[433:394] : ~vector[433:394]),
        .data_attribute_1(vector[312] ? vector[473:434] : ~vector[473:434]),
        .data_attribute_2(vector[312] ? vector[513:474] : ~vector[513:474]),
        .write_valid(found[514]),
        .write_ready(vector[515]),
        .write_surface(found[516]),
        .write_tile(found[528:517]),
        .write_pixel(found[534:529]),
        .write_weight(found[562:535]),
        .write_depth(found[614:563]),
        .write_attribute_0(found[654:615]),
        .write_attribute_1(found[694:655]),
        .write_attribute_2(found[734:695]),
        .fragment_valid(found[735]),
        .fragment_ready(vector[736]),
        .fragment_end(found[737]),
        .fragment_column(found[746:738]),
        .fragment_row(found[755:747]),
        .fragment_depth(found[779:756]),
        .fragment_attribute_0(found[791:780]),
        .fragment_attribute_1(found[803:792]),
        .fragment_attribute_2(found[815:804]),
        .event_sample(found[816]),
        .event_starved(found[817]),
        .event_blocked(found[818]),
        .event_accumulate(found[819]),
        .event_hazard(found[820]),
        .event_slot_wait(found[821])
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
            if (changed[0]) begin take(0, 1); take(1, 1); take(31, 1); take(32, 1); take(286, 1); take(287, 1); take(288, 1); take(312, 1); take(313, 1); take(514, 1); take(515, 1); take(735, 1); take(736, 1); take(816, 1); take(817, 1); take(818, 1); take(819, 1); take(820, 1); take(821, 1); end
            if (changed[1]) begin take(2, 5); take(7, 24); end
            if (changed[2]) begin take(33, 1); take(34, 24); take(58, 24); take(82, 24); take(106, 24); take(130, 24); take(154, 24); take(178, 24); take(202, 24); take(226, 24); take(250, 12); take(262, 12); take(274, 12); end
            if (changed[3]) begin take(289, 1); take(290, 12); take(302, 6); take(308, 4); end
            if (changed[4]) begin take(314, 28); take(342, 52); take(394, 40); take(434, 40); take(474, 40); end
            if (changed[5]) begin take(516, 1); take(517, 12); take(529, 6); take(535, 28); take(563, 52); take(615, 40); take(655, 40); take(695, 40); end
            if (changed[6]) begin take(737, 1); take(738, 9); take(747, 9); take(756, 24); take(780, 12); take(792, 12); take(804, 12); end
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
        for (cycle = 0; cycle < 219047 && differences == 0; cycle = cycle + 1) begin
            advance;
            #4;
            if (found[32] !== vector[32]) differ("splat_ready");
            if (found[286] !== vector[286]) differ("frame_set_up");
            if (found[287] !== vector[287]) differ("read_valid");
            if (vector[287] && found[289] !== vector[289]) differ("read_surface");
            if (vector[287] && found[301:290] !== vector[301:290]) differ("read_tile");
            if (vector[287] && found[307:302] !== vector[307:302]) differ("read_pixel");
            if (vector[287] && found[311:308] !== vector[311:308]) differ("read_count");
            if (found[313] !== vector[313]) differ("data_ready");
            if (found[514] !== vector[514]) differ("write_valid");
            if (vector[514] && found[516] !== vector[516]) differ("write_surface");
            if (vector[514] && found[528:517] !== vector[528:517]) differ("write_tile");
            if (vector[514] && found[534:529] !== vector[534:529]) differ("write_pixel");
            if (vector[514] && found[562:535] !== vector[562:535]) differ("write_weight");
            if (vector[514] && found[614:563] !== vector[614:563]) differ("write_depth");
            if (vector[514] && found[654:615] !== vector[654:615]) differ("write_attribute_0");
            if (vector[514] && found[694:655] !== vector[694:655]) differ("write_attribute_1");
            if (vector[514] && found[734:695] !== vector[734:695]) differ("write_attribute_2");
            if (found[735] !== vector[735]) differ("fragment_valid");
            if (vector[735] && found[737] !== vector[737]) differ("fragment_end");
            if (vector[735] && !vector[737] && found[746:738] !== vector[746:738]) differ("fragment_column");
            if (vector[735] && !vector[737] && found[755:747] !== vector[755:747]) differ("fragment_row");
            if (vector[735] && !vector[737] && found[779:756] !== vector[779:756]) differ("fragment_depth");
            if (vector[735] && !vector[737] && found[791:780] !== vector[791:780]) differ("fragment_attribute_0");
            if (vector[735] && !vector[737] && found[803:792] !== vector[803:792]) differ("fragment_attribute_1");
            if (vector[735] && !vector[737] && found[815:804] !== vector[815:804]) differ("fragment_attribute_2");
            if (found[816] !== vector[816]) differ("event_sample");
            if (found[817] !== vector[817]) differ("event_starved");
            if (found[818] !== vector[818]) differ("event_blocked");
            if (found[819] !== vector[819]) differ("event_accumulate");
            if (found[820] !== vector[820]) differ("event_hazard");
            if (found[821] !== vector[821]) differ("event_slot_wait");
            @(negedge clk);
        end
        if (differences != 0) $fatal(1, "FAILED");
        $display("PASSED: 219047 cycles, 21247 items, every output as the model's");
        $finish;
    end
endmodule
