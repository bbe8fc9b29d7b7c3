
    // What is behind NAME: records from a base on, and which of them have been written.
    wire NAME_asks, NAME_gives, NAME_idle, NAME_stores;
    wire [31:0] NAME_address, NAME_errors, NAME_misplaced, NAME_beats, NAME_store_address, NAME_write_errors, NAME_records;
    wire [KIND_BEATS*KIND_BITS-1:0] NAME_record;
    reg [KIND_BEATS*KIND_BITS-1:0] NAME_words [0:KIND_RECORDS-1];
    reg [KIND_RECORDS-1:0] NAME_is_written = 0;
    wire [31:0] NAME_base = KIND_base + OFFSET * KIND_RECORDS * KIND_BYTES;
    wire [31:0] NAME_store_place = (NAME_store_address - NAME_base) / KIND_BYTES;
    wire [31:0] NAME_read_place = (NAME_address - NAME_base) / KIND_BYTES;
    wire [31:0] NAME_part = (NAME_address - NAME_base) / (KIND_BITS / 8) % KIND_BEATS;
    wire [31:0] NAME_read_held = NAME_read_place < KIND_RECORDS ? NAME_read_place : 0;
    wire [KIND_BEATS*KIND_BITS-1:0] NAME_read_record = NAME_is_written[NAME_read_held] ? NAME_words[NAME_read_held] : UNWRITTEN;

    axi_test_reads #(.BITS(KIND_BITS), .SEED(32'hd10d + SEED_NUMBER)) NAME_reads (
        .clk(clk), .rst(rst), .address_share(share[READ_ADDRESS]), .data_share(share[READ_DATA]), .delay(delay),
        .error_share(error_share), .misplaced_share(misplaced_share), .unasked(unasked[0]),
        .arvalid(NAME_arvalid), .arready(NAME_arready), .arid(NAME_arid), .araddr(NAME_araddr), .arlen(NAME_arlen),
        .arsize(NAME_arsize), .arburst(NAME_arburst), .rvalid(NAME_rvalid), .rready(NAME_rready), .rid(NAME_rid),
        .rdata(NAME_rdata), .rresp(NAME_rresp), .rlast(NAME_rlast), .asks(NAME_asks), .gives(NAME_gives),
        .address(NAME_address), .data(NAME_read_record[NAME_part*KIND_BITS +: KIND_BITS]), .idle(NAME_idle),
        .errors(NAME_errors), .misplaced(NAME_misplaced), .beats(NAME_beats)
    );
STORED_BY

    always @(posedge clk) begin
        if (NAME_gives && (NAME_read_place >= KIND_RECORDS || (KIND_IS_EMPTY && !NAME_is_written[NAME_read_held])))
            $fatal(1, "FAILED: NAME reads %h, which there is not", NAME_address);
        if (NAME_stores) begin
            if (NAME_store_place >= KIND_RECORDS) $fatal(1, "FAILED: %h is written, outside of its memory", NAME_store_address);
            NAME_words[NAME_store_place] <= NAME_record;
            NAME_is_written[NAME_store_place] <= 1'b1;
        end
        if (places_KIND) NAME_is_written <= 0;
    end
