    // What the core reads through NAME.
    wire NAME_asks, NAME_gives, NAME_idle;
    wire [31:0] NAME_address, NAME_errors, NAME_misplaced, NAME_beats;
    wire [MEMORY_BITS:0] NAME_beat = beat_at(image[NUMBER], NAME_address);
    axi_test_reads #(.BITS(MEMORY_BITS), .SEED(32'hd00d + NUMBER)) NAME_reads (
        .clk(clk), .rst(rst), .address_share(share[ADDRESS]), .data_share(share[DATA]), .delay(delay),
        .error_share(error_share), .misplaced_share(misplaced_share), .unasked(unasked[NUMBER]),
        .arvalid(NAME_arvalid), .arready(NAME_arready), .arid(NAME_arid), .araddr(NAME_araddr), .arlen(NAME_arlen),
        .arsize(NAME_arsize), .arburst(NAME_arburst), .rvalid(NAME_rvalid), .rready(NAME_rready), .rid(NAME_rid),
        .rdata(NAME_rdata), .rresp(NAME_rresp), .rlast(NAME_rlast), .asks(NAME_asks), .gives(NAME_gives),
        .address(NAME_address), .data(NAME_beat[MEMORY_BITS-1:0]), .idle(NAME_idle), .errors(NAME_errors),
        .misplaced(NAME_misplaced), .beats(NAME_beats)
    );
    always @(posedge clk) if (NAME_gives && !NAME_beat[MEMORY_BITS])
        $fatal(1, "FAILED: NAME reads %h, where there is nothing", NAME_address);

