// Memory that is written, a record a burst: tells of a record when its answer goes out, late and in the order of the bursts.
module axi_test_writes #(parameter BITS = 64, parameter BEATS = 1, parameter TILE_BYTES = 64, parameter [31:0] SEED = 1) (
    input  wire clk, input wire rst,
    input  wire [7:0] address_share, input wire [7:0] data_share, input wire [7:0] answer_share,
    input  wire [7:0] error_share,  // Of 256 answers, those that are errors.
    input  wire awvalid, output wire awready, input wire [3:0] awid, input wire [31:0] awaddr,
    input  wire [7:0] awlen, input wire [2:0] awsize, input wire [1:0] awburst,
    input  wire wvalid, output wire wready, input wire [BITS-1:0] wdata, input wire [BITS/8-1:0] wstrb, input wire wlast,
    output wire bvalid, input wire bready, output wire [3:0] bid, output wire [1:0] bresp,
    output wire stores, output wire [31:0] address, output wire [BEATS*BITS-1:0] record,  // A record is answered.
    input  wire reads, input wire [31:0] read_address,  // A burst is asked for, which must find all writes to its tile answered.
    output reg  [31:0] errors, output reg [31:0] records
);
    localparam BYTES = BITS / 8;
    localparam WRITES_MAX = 16;
    reg [31:0] burst_address [0:31];
    reg [BEATS*BITS-1:0] burst_data [0:31];
    reg [BEATS*BITS-1:0] gathered;
    integer addressed = 0;
    integer given = 0;
    integer answered = 0;
    integer beat = 0;
    integer i;
    reg [31:0] random = ~SEED;
    wire [31:0] random_1 = random ^ (random << 13);
    wire [31:0] random_2 = random_1 ^ (random_1 >> 17);
    wire spoils = error_share != 8'd0 && random[15:8] <= error_share;
    wire address_moves, data_moves;
    assign address = burst_address[answered & 31];
    assign record = burst_data[answered & 31];

    axi_test_sink #(.WIDTH(49), .SEED(SEED + 32'd7)) addresses (
        .clk(clk), .rst(rst), .share(address_share), .valid(awvalid), .ready(awready),
        .payload({awid, awaddr, awlen, awsize, awburst}), .moves(address_moves)
    );
    axi_test_sink #(.WIDTH(BITS + BYTES + 1), .SEED(SEED + 32'd9)) data (
        .clk(clk), .rst(rst), .share(data_share), .valid(wvalid), .ready(wready), .payload({wdata, wstrb, wlast}),
        .moves(data_moves)
    );
    axi_test_source #(.WIDTH(6), .SEED(SEED + 32'd11)) answers (
        .clk(clk), .rst(rst), .share(answer_share), .available(answered != addressed && answered != given),
        .item({4'd0, spoils ? {1'b1, random[24]} : 2'd0}), .take(stores), .valid(bvalid), .ready(bready),
        .payload({bid, bresp})
    );

    initial begin errors = 0; records = 0; end
    always @(posedge clk) begin
        random <= random_2 ^ (random_2 << 5);
        if (rst) begin
            addressed <= 0;
            given <= 0;
            answered <= 0;
            beat <= 0;
        end
        if (address_moves) begin
            if (awid != 4'd0 || awsize != $clog2(BYTES) || awburst != 2'd1 || awlen != BEATS - 1 || awaddr % (BEATS * BYTES) != 0)
                $fatal(1, "FAILED: %m: a burst of %0d beats at %h", awlen + 1, awaddr);
            burst_address[addressed & 31] <= awaddr;
            addressed <= addressed + 1;
        end
        if (data_moves) begin
            if (!(&wstrb) || wlast != (beat == BEATS - 1)) $fatal(1, "FAILED: %m: strobes, or the place of the last beat");
            gathered[beat*BITS +: BITS] <= wdata;
            burst_data[given & 31] <= gathered;
            burst_data[given & 31][beat*BITS +: BITS] <= wdata;
            beat <= wlast ? 0 : beat + 1;
            if (wlast) given <= given + 1;
        end
        if (addressed - answered > WRITES_MAX || given - answered > WRITES_MAX) $fatal(1, "FAILED: %m: too many writes under way");
        if (stores) begin
            answered <= answered + 1;
            records <= records + 1;
            if (spoils) errors <= errors + 1;
        end
        for (i = answered; reads && i != addressed; i = i + 1)
            if (burst_address[i & 31] / TILE_BYTES == read_address / TILE_BYTES)
                $fatal(1, "FAILED: %m: a tile is read before a write to it is answered");
    end
endmodule

