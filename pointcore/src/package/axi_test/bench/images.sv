    localparam ENTRIES_MAX = 1024;
    // The beat of memory at an address, behind a bit that says whether there is any.
    function [MEMORY_BITS:0] beat_at(input integer table_at, input [31:0] address);
        integer entry, part_of, from;
        begin
            beat_at = 0;
            for (entry = 0; entry < ENTRIES_MAX && entry < words[table_at]; entry = entry + 1) begin
                from = table_at + 1 + 3 * entry;
                if (address >= words[from] && address - words[from] < words[from + 1]) begin
                    beat_at[MEMORY_BITS] = 1'b1;
                    for (part_of = 0; part_of < MEMORY_BITS / 32; part_of = part_of + 1)
                        beat_at[32*part_of +: 32] = words[words[from + 2] + (address - words[from]) / 4 + part_of];
                end
            end
        end
    endfunction

