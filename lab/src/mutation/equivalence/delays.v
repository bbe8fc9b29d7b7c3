// A memory of a delay: what is written in a step is read before as many more steps as it has places.
(* techmap_celltype = "$mem_v2" *)
module delay(RD_CLK, RD_EN, RD_ARST, RD_SRST, RD_ADDR, RD_DATA, WR_CLK, WR_EN, WR_ADDR, WR_DATA);
parameter MEMID = "";
parameter signed SIZE = 4;
parameter signed OFFSET = 0;
parameter signed ABITS = 2;
parameter signed WIDTH = 8;
parameter signed INIT = 1'bx;
parameter signed RD_PORTS = 1;
parameter RD_CLK_ENABLE = 1'b0;
parameter RD_CLK_POLARITY = 1'b0;
parameter RD_TRANSPARENCY_MASK = 1'b0;
parameter RD_COLLISION_X_MASK = 1'b0;
parameter RD_WIDE_CONTINUATION = 1'b0;
parameter RD_CE_OVER_SRST = 1'b0;
parameter RD_ARST_VALUE = 1'b0;
parameter RD_SRST_VALUE = 1'b0;
parameter RD_INIT_VALUE = 1'b0;
parameter signed WR_PORTS = 1;
parameter WR_CLK_ENABLE = 1'b1;
parameter WR_CLK_POLARITY = 1'b1;
parameter WR_PRIORITY_MASK = 1'b0;
parameter WR_WIDE_CONTINUATION = 1'b0;
input RD_CLK, RD_EN, RD_ARST, RD_SRST;
input [ABITS-1:0] RD_ADDR;
output [WIDTH-1:0] RD_DATA;
input WR_CLK;
input [WIDTH-1:0] WR_EN;
input [ABITS-1:0] WR_ADDR;
input [WIDTH-1:0] WR_DATA;
wire _TECHMAP_FAIL_ = RD_PORTS != 1 || WR_PORTS != 1 || RD_CLK_ENABLE != 0 || OFFSET != 0;
reg [SIZE*WIDTH-1:0] steps;
always @(posedge WR_CLK) if (WR_EN[0]) steps <= {steps, WR_DATA};
assign RD_DATA = steps[SIZE*WIDTH-1 -: WIDTH];
endmodule
