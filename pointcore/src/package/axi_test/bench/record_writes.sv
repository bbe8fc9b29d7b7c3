    axi_test_writes #(.BITS(KIND_BITS), .BEATS(KIND_BEATS), .TILE_BYTES(KIND_BYTES), .SEED(32'he10e + SEED_NUMBER)) NAME_writes (
        .clk(clk), .rst(rst), .address_share(share[WRITE_ADDRESS]), .data_share(share[WRITE_DATA]),
        .answer_share(share[WRITE_ANSWER]), .error_share(answer_error_share),
        .awvalid(NAME_awvalid), .awready(NAME_awready), .awid(NAME_awid), .awaddr(NAME_awaddr), .awlen(NAME_awlen),
        .awsize(NAME_awsize), .awburst(NAME_awburst), .wvalid(NAME_wvalid), .wready(NAME_wready), .wdata(NAME_wdata),
        .wstrb(NAME_wstrb), .wlast(NAME_wlast), .bvalid(NAME_bvalid), .bready(NAME_bready), .bid(NAME_bid),
        .bresp(NAME_bresp), .stores(NAME_stores), .address(NAME_store_address), .record(NAME_record),
        .reads(NAME_asks), .read_address(NAME_araddr), .errors(NAME_write_errors), .records(NAME_records)
    );
