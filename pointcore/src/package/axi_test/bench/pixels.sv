
    // What the core reads of a pixel is what it wrote there last, whatever buses and memory did to it in between.
    reg [PIXEL_WIDTH-1:0] DATA_expected [0:255];
    integer DATA_asked = 0, DATA_taken = 0, DATA_i;
    always @(posedge clk) begin
        if (dut.core.rst) begin
            DATA_asked = 0;
            DATA_taken = 0;
        end else begin
            if (dut.core.WRITE_valid && dut.core.WRITE_ready)
                kept[{dut.core.WRITE_surface, dut.core.WRITE_tile, dut.core.WRITE_pixel}] = WRITTEN;
            if (dut.core.READ_valid && dut.core.READ_ready)
                for (DATA_i = 0; DATA_i < dut.core.READ_count; DATA_i = DATA_i + 1) begin
                    DATA_expected[DATA_asked & 255] = kept[{dut.core.READ_surface, dut.core.READ_tile, dut.core.READ_pixel} + DATA_i];
                    DATA_asked = DATA_asked + 1;
                end
            if (dut.core.DATA_valid && dut.core.DATA_ready) begin
                if (DATA_taken == DATA_asked || TAKEN != DATA_expected[DATA_taken & 255])
                    $fatal(1, "FAILED: the core reads %h, and wrote %h", TAKEN, DATA_expected[DATA_taken & 255]);
                DATA_taken = DATA_taken + 1;
            end
        end
    end
