// Offers items on a channel: with pauses, and with noise where nothing is offered.
module axi_test_source #(parameter WIDTH = 1, parameter [31:0] SEED = 1) (
    input  wire clk, input wire rst,
    input  wire [7:0] share,  // Of 256 cycles, those that pause; 255 holds everything back.
    input  wire available, input wire [WIDTH-1:0] item,
    output wire take,  // The item goes on offer.
    output reg  valid, input wire ready, output reg [WIDTH-1:0] payload
);
    localparam WORDS = (WIDTH + 31) / 32;
    reg [31:0] random = SEED;
    wire [31:0] random_1 = random ^ (random << 13);
    wire [31:0] random_2 = random_1 ^ (random_1 >> 17);
    wire [32*WORDS-1:0] noise = {WORDS{random}};
    wire pauses = share != 8'd0 && random[7:0] <= share;
    assign take = !rst && available && !pauses && (!valid || ready);

    always @(posedge clk) begin
        random <= random_2 ^ (random_2 << 5);
        if (rst) valid <= 1'b0;
        else if (!valid || ready) begin
            if (ready === 1'bx) $fatal(1, "FAILED: %m: ready is unknown");
            valid <= take;
            payload <= take ? item : noise[WIDTH-1:0];
        end
    end
endmodule

// Takes what a channel offers, with pauses; what is on offer must stay until it is taken.
module axi_test_sink #(parameter WIDTH = 1, parameter [31:0] SEED = 1) (
    input  wire clk, input wire rst,
    input  wire [7:0] share,
    input  wire valid, output reg ready, input wire [WIDTH-1:0] payload,
    output wire moves  // What is on offer is taken.
);
    reg [31:0] random = SEED;
    wire [31:0] random_1 = random ^ (random << 13);
    wire [31:0] random_2 = random_1 ^ (random_1 >> 17);
    reg was_reset = 1'b0;
    reg waits = 1'b0;
    reg [WIDTH-1:0] offered;
    assign moves = valid && ready && !rst;

    initial ready = 1'b0;
    always @(posedge clk) begin
        random <= random_2 ^ (random_2 << 5);
        ready <= share == 8'd0 || random[7:0] > share;
        was_reset <= rst;
        waits <= valid && !ready && !rst;
        offered <= payload;
        if (was_reset && valid !== 1'b0) $fatal(1, "FAILED: %m: valid during reset");
        if (!rst && (valid === 1'bx || (valid && ^payload === 1'bx))) $fatal(1, "FAILED: %m: unknown values are offered");
        if (!rst && waits && (!valid || payload !== offered)) $fatal(1, "FAILED: %m: an offer was withdrawn or changed");
    end
endmodule

