// Written by pointcore 0.1.0; do not edit.
// Replays 97152 cycles of the bit-exact model at the ports of splat_top, in which 6516 items leave the core, and compares every output in every
// cycle; a stream's fields count while it is valid, and those that go in are spoilt while it is not. For Verilator, whose registers start at
// random values: in a simulator with unknown values, what is not reset stays unknown longer than in hardware.
//
// splat_test.hex is a sequence of bits: in every cycle one, whether anything changes, and if so one for each group of ports, whether it does,
// then the words of those that do.

module splat_test;
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [63:0] words [0:43785];
    reg [818:0] vector = 0;
    reg [818:0] next = 0;
    wire [818:0] found;
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
        .read_pixel(found[305:300]),
        .read_count(found[309:306]),
        .data_valid(vector[310]),
        .data_ready(found[311]),
        .data_weight(vector[310] ? vector[339:312] : ~vector[339:312]),
        .data_depth(vector[310] ? vector[391:340] : ~vector[391:340]),
        .data_attribute_0(vector[310] ? vector[431:392] : ~vector[431:392]),
        .data_attribute_1(vector[310] ? vector[471:432] : ~vector[471:432]),
        .data_attribute_2(vector[310] ? vector[511:472] : ~vector[511:472]),
        .write_valid(found[512]),
        .write_ready(vector[513]),
        .write_tile(found[525:514]),
        .write_pixel(found[531:526]),
        .write_weight(found[559:532]),
        .write_depth(found[611:560]),
        .write_attribute_0(found[651:612]),
        .write_attribute_1(found[691:652]),
        .write_attribute_2(found[731:692]),
        .fragment_valid(found[732]),
        .fragment_ready(vector[733]),
        .fragment_end(found[734]),
        .fragment_column(found[743:735]),
        .fragment_row(found[752:744]),
        .fragment_depth(found[776:753]),
        .fragment_attribute_0(found[788:777]),
        .fragment_attribute_1(found[800:789]),
        .fragment_attribute_2(found[812:801]),
        .event_sample(found[813]),
        .event_starved(found[814]),
        .event_blocked(found[815]),
        .event_accumulate(found[816]),
        .event_hazard(found[817]),
        .event_slot_wait(found[818])
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
            if (changed[0]) begin take(0, 1); take(1, 1); take(31, 1); take(32, 1); take(286, 1); take(287, 1); take(310, 1); take(311, 1); take(512, 1); take(513, 1); take(732, 1); take(733, 1); take(813, 1); take(814, 1); take(815, 1); take(816, 1); take(817, 1); take(818, 1); end
            if (changed[1]) begin take(2, 5); take(7, 24); end
            if (changed[2]) begin take(33, 1); take(34, 24); take(58, 24); take(82, 24); take(106, 24); take(130, 24); take(154, 24); take(178, 24); take(202, 24); take(226, 24); take(250, 12); take(262, 12); take(274, 12); end
            if (changed[3]) begin take(288, 12); take(300, 6); take(306, 4); end
            if (changed[4]) begin take(312, 28); take(340, 52); take(392, 40); take(432, 40); take(472, 40); end
            if (changed[5]) begin take(514, 12); take(526, 6); take(532, 28); take(560, 52); take(612, 40); take(652, 40); take(692, 40); end
            if (changed[6]) begin take(734, 1); take(735, 9); take(744, 9); take(753, 24); take(777, 12); take(789, 12); take(801, 12); end
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
        for (cycle = 0; cycle < 97152 && differences == 0; cycle = cycle + 1) begin
            advance;
            #4;
            if (found[32] !== vector[32]) differ("splat_ready");
            if (found[286] !== vector[286]) differ("read_valid");
            if (vector[286] && found[299:288] !== vector[299:288]) differ("read_tile");
            if (vector[286] && found[305:300] !== vector[305:300]) differ("read_pixel");
            if (vector[286] && found[309:306] !== vector[309:306]) differ("read_count");
            if (found[311] !== vector[311]) differ("data_ready");
            if (found[512] !== vector[512]) differ("write_valid");
            if (vector[512] && found[525:514] !== vector[525:514]) differ("write_tile");
            if (vector[512] && found[531:526] !== vector[531:526]) differ("write_pixel");
            if (vector[512] && found[559:532] !== vector[559:532]) differ("write_weight");
            if (vector[512] && found[611:560] !== vector[611:560]) differ("write_depth");
            if (vector[512] && found[651:612] !== vector[651:612]) differ("write_attribute_0");
            if (vector[512] && found[691:652] !== vector[691:652]) differ("write_attribute_1");
            if (vector[512] && found[731:692] !== vector[731:692]) differ("write_attribute_2");
            if (found[732] !== vector[732]) differ("fragment_valid");
            if (vector[732] && found[734] !== vector[734]) differ("fragment_end");
            if (vector[732] && !vector[734] && found[743:735] !== vector[743:735]) differ("fragment_column");
            if (vector[732] && !vector[734] && found[752:744] !== vector[752:744]) differ("fragment_row");
            if (vector[732] && !vector[734] && found[776:753] !== vector[776:753]) differ("fragment_depth");
            if (vector[732] && !vector[734] && found[788:777] !== vector[788:777]) differ("fragment_attribute_0");
            if (vector[732] && !vector[734] && found[800:789] !== vector[800:789]) differ("fragment_attribute_1");
            if (vector[732] && !vector[734] && found[812:801] !== vector[812:801]) differ("fragment_attribute_2");
            if (found[813] !== vector[813]) differ("event_sample");
            if (found[814] !== vector[814]) differ("event_starved");
            if (found[815] !== vector[815]) differ("event_blocked");
            if (found[816] !== vector[816]) differ("event_accumulate");
            if (found[817] !== vector[817]) differ("event_hazard");
            if (found[818] !== vector[818]) differ("event_slot_wait");
            @(negedge clk);
        end
        if (differences != 0) $fatal(1, "FAILED");
        $display("PASSED: 97152 cycles, 6516 items, every output as the model's");
        $finish;
    end
endmodule
