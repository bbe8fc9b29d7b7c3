                8'd35: begin  // Place memories of payloads in which nothing is written.
                    payload_base <= words[at];
                    places_payloads <= 1'b1;
                    @(negedge clk);
                    places_payloads <= 1'b0;
                    at = at + 1;
                end
