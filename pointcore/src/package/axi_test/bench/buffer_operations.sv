                8'd34: begin  // Place an empty buffer.
                    buffer_base <= words[at];
                    pages = 0;
                    is_written = 0;
                    at = at + 1;
                end
