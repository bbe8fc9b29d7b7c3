// Memory that is read: takes bursts, and gives their beats late, in their order. Spoils answers where it is told to, and counts that.
module axi_test_reads #(parameter BITS = 64, parameter [31:0] SEED = 1) (
    input  wire clk, input wire rst,
    input  wire [7:0] address_share, input wire [7:0] data_share,
    input  wire [7:0] delay,  // Bits of the random number of cycles before a burst.
    input  wire [7:0] error_share, input wire [7:0] misplaced_share,  // Of 256 beats, those that are spoilt.
    input  wire [31:0] unasked,  // Beats that nobody asked for, so far.
    input  wire arvalid, output wire arready, input wire [3:0] arid, input wire [31:0] araddr,
    input  wire [7:0] arlen, input wire [2:0] arsize, input wire [1:0] arburst,
    output wire rvalid, input wire rready, output wire [3:0] rid, output wire [BITS-1:0] rdata,
    output wire [1:0] rresp, output wire rlast,
    output wire asks,  // A burst is asked for.
    output wire gives, output wire [31:0] address, input wire [BITS-1:0] data,  // The beat that is given.
    output wire idle,
    output reg  [31:0] errors, output reg [31:0] misplaced, output reg [31:0] beats
);
    localparam BYTES = BITS / 8;
    localparam BURSTS_MAX = 16;
    reg [31:0] burst_address [0:31];
    integer burst_beats [0:31];
    integer asked = 0;
    integer given = 0;
    integer beat = 0;
    integer waiting = 0;
    integer unasked_given = 0;
    reg is_wrong = 1'b0;
    reg [31:0] random = ~SEED;
    wire [31:0] random_1 = random ^ (random << 13);
    wire [31:0] random_2 = random_1 ^ (random_1 >> 17);

    wire stray = unasked_given != unasked;
    wire under_way = asked != given && waiting == 0;
    wire at_end = beat + 1 == burst_beats[given & 31];
    wire spoils_response = error_share != 8'd0 && random[15:8] <= error_share;
    wire spoils_last = misplaced_share != 8'd0 && random[23:16] <= misplaced_share;
    wire take;
    assign gives = take && !stray;
    assign address = burst_address[given & 31] + beat * BYTES;
    assign idle = asked == given && !rvalid && !stray;

    axi_test_sink #(.WIDTH(49), .SEED(SEED + 32'd7)) addresses (
        .clk(clk), .rst(rst), .share(address_share), .valid(arvalid), .ready(arready),
        .payload({arid, araddr, arlen, arsize, arburst}), .moves(asks)
    );
    axi_test_source #(.WIDTH(BITS + 7), .SEED(SEED + 32'd9)) answers (
        .clk(clk), .rst(rst), .share(data_share), .available(stray || under_way),
        .item({4'd0, stray ? ~data : data, spoils_response ? {1'b1, random[24]} : 2'd0, at_end ^ spoils_last}),
        .take(take), .valid(rvalid), .ready(rready), .payload({rid, rdata, rresp, rlast})
    );

    initial begin errors = 0; misplaced = 0; beats = 0; end
    always @(posedge clk) begin
        random <= random_2 ^ (random_2 << 5);
        if (rst) begin
            asked <= 0;
            given <= 0;
            beat <= 0;
        end else if (asks) begin
            if (arid != 4'd0 || arsize != $clog2(BYTES) || arburst != 2'd1) $fatal(1, "FAILED: %m: no plain burst");
            if (araddr % BYTES != 0 || araddr[11:0] + (arlen + 1) * BYTES > 4096)
                $fatal(1, "FAILED: %m: a burst of %0d beats at %h", arlen + 1, araddr);
            if (asked - given >= BURSTS_MAX) $fatal(1, "FAILED: %m: too many bursts under way");
            burst_address[asked & 31] <= araddr;
            burst_beats[asked & 31] <= arlen + 1;
            asked <= asked + 1;
        end
        if (waiting != 0) waiting <= waiting - 1;
        if (take) begin
            if (spoils_response) errors <= errors + 1;
            if (stray) begin
                unasked_given <= unasked_given + 1;
                misplaced <= misplaced + 1;
            end else begin
                beats <= beats + 1;
                beat <= at_end ? 0 : beat + 1;
                is_wrong <= !at_end && (is_wrong || spoils_last);
                if (at_end) begin
                    given <= given + 1;
                    waiting <= random[31:24] & delay;
                    if (is_wrong || spoils_last) misplaced <= misplaced + 1;
                end
            end
        end
    end
endmodule

