            8'd32: begin
                burst_address[bursts_asked & 15] <= {mail_word[11:8], words[mail_at], mail_word[19:12], mail_word[22:20], mail_word[24:23]};
                burst_answer[bursts_asked & 15] <= mail_word[26:25];
                burst_first[bursts_asked & 15] <= words[mail_at + 1];
                burst_bad_strobes[bursts_asked & 15] <= words[mail_at + 2];
                burst_bad_last[bursts_asked & 15] <= words[mail_at + 3];
                burst_strobes[bursts_asked & 15] <= words[mail_at + 4];
                bursts_asked <= bursts_asked + 1;
            end
            8'd33: begin
                burst_read[bursts_read & 15] <= {mail_word[11:8], words[mail_at], mail_word[19:12], 3'd3, 2'd1};
                bursts_read <= bursts_read + 1;
            end
