                8'dOPERATION: begin  // Place what is behind the ports of this kind.
                    KIND_base <= words[at];
                    places_KIND <= 1'b1;
                    @(negedge clk);
                    places_KIND <= 1'b0;
                    at = at + 1;
                end
