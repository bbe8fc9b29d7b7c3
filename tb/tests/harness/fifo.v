// A queue of four entries; what passes is doubled and one added.
module fifo(
    input wire clk,
    input wire rst,
    input wire in_valid,
    output wire in_ready,
    input wire [15:0] in_value,
    input wire in_last,
    output wire out_valid,
    input wire out_ready,
    output wire [16:0] out_value,
    output wire out_last
);
    reg [17:0] entries [0:3];
    reg [1:0] head;
    reg [1:0] tail;
    reg [2:0] count;

    wire put = in_valid & in_ready;
    wire take = out_valid & out_ready;
    wire [17:0] front = entries[head];

    assign in_ready = count != 3'd4;
    assign out_valid = count != 3'd0;
    assign out_value = front[16:0] + 17'd1;
    assign out_last = front[17];

    always @(posedge clk) begin
        if (put) entries[tail] <= {in_last, in_value, 1'b0};
        if (rst) begin
            head <= 2'd0;
            tail <= 2'd0;
            count <= 3'd0;
        end else begin
            if (put) tail <= tail + 2'd1;
            if (take) head <= head + 2'd1;
            count <= count + {2'd0, put} - {2'd0, take};
        end
    end
`ifdef RTL_ASSERT
    always @(posedge clk) begin
        if (!rst && count > 3'd4) begin
            $display("assertion count_in_range failed in %m");
            $stop;
        end
    end
`endif
endmodule
