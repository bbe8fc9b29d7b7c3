    // The script. What it hands to the channels shows in the next cycle.
    reg [31:0] word, value;
    integer polls = 0, polls_before = 0;
    integer packets_dropped = 0;
    reg [31:0] errors_before = 32'd0, misplaced_before = 32'd0;
    wire [31:0] memory_errors = all_memory_errors - errors_before;
    wire [31:0] memory_misplaced = all_misplaced - misplaced_before;
    wire registers_idle = writes_answered == writes_asked && reads_answered == reads_asked;
    wire all_sent = packets_given == packets_asked && !send_tvalid;

    // What the script hands over, and a clock later the channels have.
    reg [7:0] mail = 8'd0;
    reg [31:0] mail_word, mail_value;
    reg [9:0] mail_answer;
    integer mail_at;

    always @(posedge clk) begin
        case (mail)
            8'd1: share[mail_word[15:8]] <= mail_word[23:16];
            8'd3: begin
                write_address[writes_asked & 63] <= mail_word[19:8];
                write_data[writes_asked & 63] <= {mail_word[23:20], mail_value};
                write_answer[writes_asked & 63] <= mail_word[26:24];
                writes_asked <= writes_asked + 1;
            end
            8'd4: begin
                read_address[reads_asked & 63] <= mail_word[19:8];
                read_answer[reads_asked & 63] <= mail_answer;
                read_value[reads_asked & 63] <= mail_value;
                reads_asked <= reads_asked + 1;
            end
            8'd7: begin
                packet_first[packets_asked & 255] <= mail_value;
                packet_beats[packets_asked & 255] <= mail_word[31:8];
                packets_asked <= packets_asked + 1;
            end
            8'd15: unasked[mail_word[8]] <= unasked[mail_word[8]] + mail_word[31:16];
            8'd21: begin
                image[0] <= words[mail_at];
                image[1] <= words[mail_at + 1];
            end
POSTED
            default: ;
        endcase
    end

    task post(input [7:0] operation);
        begin
            mail <= operation;
            @(negedge clk);
            mail <= 8'd0;
        end
    endtask

    task push_write(input [11:0] address, input [31:0] data, input [3:0] strb, input [2:0] answer);
        begin
            while (writes_asked - writes_answered >= 32) @(negedge clk);
            mail_word <= {5'd0, answer, strb, address, 8'd3};
            mail_value <= data;
            post(8'd3);
        end
    endtask

    task push_read(input [11:0] address, input [9:0] answer, input [31:0] expected);
        begin
            while (reads_asked - reads_answered >= 32) @(negedge clk);
            mail_word <= {12'd0, address, 8'd4};
            mail_answer <= answer;
            mail_value <= expected;
            post(8'd4);
        end
    endtask

    // Hands the operation over as it is.
    task pass;
        begin
            mail_word <= word;
            mail_value <= value;
            mail_at <= at;
            post(word[7:0]);
        end
    endtask

    task poll;
        begin
            push_read(12'h008, 10'b1000, 32'd0);
            polls = polls + 1;
            if (polls - polls_before > STUCK_POLLS) $fatal(1, "FAILED: status stays %h", last_value);
            settle;
        end
    endtask

    // What was asked for in this cycle shows in the next.
    task settle;
        begin
            @(negedge clk);
            while (!registers_idle || !window_idle) @(negedge clk);
        end
    endtask

    task next(output [31:0] operand);
        begin
            operand = words[at];
            at = at + 1;
        end
    endtask

    task step;
        begin
            next(word);
            case (word[7:0])
                8'd1: pass;  // Pauses of a channel.
                8'd2: begin  // Wait.
                    waits_by_script <= 1'b1;
                    repeat (word[31:8]) @(negedge clk);
                    waits_by_script <= 1'b0;
                end
                8'd3: begin  // Write.
                    next(value);
                    push_write(word[19:8], value, word[23:20], word[26:24]);
                end
                8'd4: begin  // Read.
                    next(value);
                    push_read(word[19:8], {6'd0, 2'b00, word[25:24]}, value);
                end
                8'd5: begin  // Read a counter that the bench counts, too; a number is added.
                    next(value);
                    push_read(word[19:8], {word[25:20], 4'b0100}, value);
                end
                8'd6: settle;
                8'd7: begin  // Send a packet.
                    next(value);
                    while (packets_asked - packets_given >= 255) @(negedge clk);
                    pass;
                end
                8'd8: begin  // Wait until all packets are taken.
                    @(negedge clk);
                    while (!all_sent) @(negedge clk);
                end
                8'd9: begin  // Expect packets; what is missing of those before will not come.
                    packets_dropped = packets_dropped + packets_left;
                    answers = word[31:8];
                    packets_left = 0;
                    for (int k = 0; k < answers; k = k + 1) begin
                        answer_next[k] = words[at];
                        answer_packets[k] = words[at + 1];
                        packets_left = packets_left + words[at + 1];
                        at = at + 2;
                    end
                end
                8'd10: while (packets_left > word[31:8]) @(negedge clk);
                8'd11: begin  // Wait for the interrupt, which comes after some cycles in which nothing moves.
                    while (!irq) @(negedge clk);
                    if (still < word[31:8]) $fatal(1, "FAILED: irq is high %0d cycles after something moved; word %0d", still, at);
                end
                8'd12: begin  // Hold packets from a beat on.
                    holds <= word[8];
                    held_beat <= word[31:16];
                end
                8'd13: delay <= word[15:8];
                8'd14: {answer_error_share, misplaced_share, error_share} <= word[31:8];
                8'd15: begin  // Beats that nobody asked for.
                    pass;
                    @(negedge clk);
                    while (!memory_idle) @(negedge clk);
                end
                8'd16: begin  // Wait until bits of `status` are low.
                    settle;
                    polls_before = polls;
                    poll;
                    while ((last_value[3:0] & word[11:8]) != 0) poll;
                end
                8'd17: if (irq !== word[8]) $fatal(1, "FAILED: irq is %b; word %0d", irq, at);
                8'd18: begin  // Reset.
                    rst <= 1'b1;
                    repeat (word[31:8]) @(negedge clk);
                    rst <= 1'b0;
                end
                8'd19: begin  // Writes that are refused: from a word to another.
                    next(value);
                    for (int k = word[19:8]; k <= word[31:20]; k = k + 4) push_write(k, value, 4'hf, 3'd2);
                end
                8'd20: for (int k = word[19:8]; k <= word[31:20]; k = k + 4) push_read(k, 10'd2, 32'd0);
                8'd21: begin  // Contents of memory.
                    pass;
                    at = at + 2;
                end
                8'd22: begin  // Nothing more may be offered or taken.
                    settle;
                    if (send_tready || packets_left != word[31:8] || !memory_idle) $fatal(1, "FAILED: something is left over; word %0d", at);
                end
                8'd23: begin  // Error counters have been cleared.
                    errors_before <= all_memory_errors;
                    misplaced_before <= all_misplaced;
                end
                8'd24: rst <= 1'b1;  // Reset, until it ends.
OPERATIONS
                default: $fatal(1, "FAILED: the script has no operation %0d at word %0d", word[7:0], at - 1);
            endcase
        end
    endtask

    always begin
        for (int k = 0; k < CHANNELS; k = k + 1) share[k] = 8'd0;
        for (int k = 0; k < 2; k = k + 1) begin
            unasked[k] = 32'd0;
            image[k] = 32'd0;
        end
        for (int k = 0; k < EVENTS; k = k + 1) event_count[k] = 32'd0;
        $readmemh(FILE, words);
        if (words[0] !== MAGIC) $fatal(1, "FAILED: %s is missing or another's", FILE);
        at = words[1];
        repeat (4) @(negedge clk);
        rst = 1'b0;
        @(negedge clk);
        while (words[at] != 32'd0) begin
            step;
            @(negedge clk);
        end
        settle;
        if (writes_answered != words[at + 1] || reads_answered - polls != words[at + 2] || packets_given != words[at + 3] || packets_received + packets_dropped != words[at + 4])
            $fatal(1, "FAILED: %0d writes, %0d reads, %0d packets sent, %0d received", writes_answered, reads_answered, packets_given, packets_received);
        $display("PASSED: %0d writes and %0d reads of registers, %0d packets in, %0d packets out", writes_answered, reads_answered, packets_given, packets_received);
        $finish;
        forever @(negedge clk);
    end
endmodule
