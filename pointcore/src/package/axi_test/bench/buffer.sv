    // The reconstruction buffer: a page for each tile that is written, and which of its pixels have been. A tile that is written has
    // fragments, an answer of its own for each frame.
    localparam PAGES = ANSWERS;
    localparam TILE_BYTES = 64 * PIXEL_BEATS * (MEMORY_BITS / 8);
    reg [31:0] buffer_base = 32'd0;
    reg [PIXEL_BEATS*MEMORY_BITS-1:0] pixels [0:64*PAGES-1];
    reg [64*PAGES-1:0] is_written = 0;
    integer page_tile [0:PAGES-1];
    integer pages = 0;
    integer page, i_page;
    wire m_axi_asks, m_axi_gives, m_axi_idle, stores;
    wire [31:0] m_axi_address, m_axi_errors, m_axi_misplaced, m_axi_beats, store_address, write_errors, records_written;
    wire [PIXEL_BEATS*MEMORY_BITS-1:0] record;
    wire [31:0] store_place = store_address - buffer_base;
    wire [31:0] read_place = m_axi_address - buffer_base;
    wire [31:0] read_pixel = read_place % TILE_BYTES / (PIXEL_BEATS * (MEMORY_BITS / 8));
    wire [31:0] read_part = read_place / (MEMORY_BITS / 8) % PIXEL_BEATS;
    integer read_page;
    always @* begin
        read_page = -1;
        for (i_page = 0; i_page < pages; i_page = i_page + 1)
            if (page_tile[i_page] == read_place / TILE_BYTES) read_page = i_page;
    end
    wire [PIXEL_BEATS*MEMORY_BITS-1:0] read_record = pixels[read_page < 0 ? 0 : 64 * read_page + read_pixel];

    axi_test_reads #(.BITS(MEMORY_BITS), .SEED(32'hd00d)) m_axi_reads (
        .clk(clk), .rst(rst), .address_share(share[READ_ADDRESS]), .data_share(share[READ_DATA]), .delay(delay),
        .error_share(error_share), .misplaced_share(misplaced_share), .unasked(unasked[0]),
        .arvalid(m_axi_arvalid), .arready(m_axi_arready), .arid(m_axi_arid), .araddr(m_axi_araddr), .arlen(m_axi_arlen),
        .arsize(m_axi_arsize), .arburst(m_axi_arburst), .rvalid(m_axi_rvalid), .rready(m_axi_rready), .rid(m_axi_rid),
        .rdata(m_axi_rdata), .rresp(m_axi_rresp), .rlast(m_axi_rlast), .asks(m_axi_asks), .gives(m_axi_gives),
        .address(m_axi_address), .data(read_record[read_part*MEMORY_BITS +: MEMORY_BITS]), .idle(m_axi_idle),
        .errors(m_axi_errors), .misplaced(m_axi_misplaced), .beats(m_axi_beats)
    );
    axi_test_writes #(.BITS(MEMORY_BITS), .BEATS(PIXEL_BEATS), .TILE_BYTES(TILE_BYTES), .SEED(32'he00e)) m_axi_writes (
        .clk(clk), .rst(rst), .address_share(share[WRITE_ADDRESS]), .data_share(share[WRITE_DATA]),
        .answer_share(share[WRITE_ANSWER]), .error_share(answer_error_share),
        .awvalid(m_axi_awvalid), .awready(m_axi_awready), .awid(m_axi_awid), .awaddr(m_axi_awaddr), .awlen(m_axi_awlen),
        .awsize(m_axi_awsize), .awburst(m_axi_awburst), .wvalid(m_axi_wvalid), .wready(m_axi_wready), .wdata(m_axi_wdata),
        .wstrb(m_axi_wstrb), .wlast(m_axi_wlast), .bvalid(m_axi_bvalid), .bready(m_axi_bready), .bid(m_axi_bid),
        .bresp(m_axi_bresp), .stores(stores), .address(store_address), .record(record),
        .reads(m_axi_asks), .read_address(m_axi_araddr), .errors(write_errors), .records(records_written)
    );

    always @(posedge clk) begin
        if (m_axi_gives && (read_place >= TILES * TILE_BYTES || read_page < 0 || !is_written[64 * read_page + read_pixel]))
            $fatal(1, "FAILED: %h is read, which has not been written", m_axi_address);
        if (stores) begin
            if ((record & ~PIXEL_HELD) != 0) $fatal(1, "FAILED: %h is written, and not zero where a pixel holds nothing", record);
            if (store_place >= TILES * TILE_BYTES) $fatal(1, "FAILED: %h is written, outside the buffer", store_address);
            page = -1;
            for (i_page = 0; i_page < pages; i_page = i_page + 1)
                if (page_tile[i_page] == store_place / TILE_BYTES) page = i_page;
            if (page < 0) begin
                if (pages == PAGES) $fatal(1, "FAILED: more tiles are written than there are");
                page = pages;
                page_tile[page] = store_place / TILE_BYTES;
                pages = pages + 1;
            end
            pixels[64 * page + store_place % TILE_BYTES / (TILE_BYTES / 64)] <= record;
            is_written[64 * page + store_place % TILE_BYTES / (TILE_BYTES / 64)] <= 1'b1;
        end
    end

