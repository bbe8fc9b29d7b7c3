    assign NAME_stores = 1'b0;
    assign NAME_store_address = NAME_base;
    assign NAME_record = 0;
    assign NAME_write_errors = 32'd0;
    assign NAME_records = 32'd0;
