// The record of the proofs of the AXI units, and its layout in C: `struct { uint8_t a; uint32_t b; uint8_t c; uint16_t d; }`.
localparam RECORD_BITS = 96;
localparam C_BIT = 64;
function [RECORD_BITS-1:0] layout(input [2:0] a, input [19:0] b, input c, input [8:0] d);
    layout = {7'd0, d, 8'd0, 7'd0, c, 12'd0, b, 24'd0, 5'd0, a};
endfunction
localparam [RECORD_BITS-1:0] USED = {7'd0, ~9'd0, 8'd0, 7'd0, 1'b1, 12'd0, ~20'd0, 24'd0, 5'd0, 3'd7};
