                8'd32: begin  // Write through the window.
                    while (bursts_asked - bursts_answered >= 8) @(negedge clk);
                    pass;
                    at = at + 5;
                end
                8'd33: begin  // Read through the window.
                    while (bursts_read - reads_ended >= 8) @(negedge clk);
                    pass;
                    at = at + 1;
                end
