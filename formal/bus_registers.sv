// bus_registers: every access is answered once, and as the contract says; what is refused changes nothing but its counter, and reads give
// what was written and what has happened.
//
// The map has a register of every kind, a base of multiples of 4,096 among them. Assumed: the host holds what it offers. The core's side may
// do anything. A counter is chosen by a symbol; of its value it is asked that it lies between those at the read's beginning and end.
module proof (input clk);
    `include "sizes.vh"

    reg rst = 1;
    always @(posedge clk) rst <= 0;

    (* anyseq *) reg s_axil_awvalid, s_axil_wvalid, s_axil_bready, s_axil_arvalid, s_axil_rready;
    (* anyseq *) reg [11:0] s_axil_awaddr, s_axil_araddr;
    (* anyseq *) reg [31:0] s_axil_wdata;
    (* anyseq *) reg [3:0] s_axil_wstrb;
    (* anyseq *) reg finished, begun, occupied, busy_error, packet_error, memory_error, packet_taken, packet_sent, event_seen;
    (* anyseq *) reg [1:0] burst_error;
    wire s_axil_awready, s_axil_wready, s_axil_bvalid, s_axil_arready, s_axil_rvalid;
    wire [1:0] s_axil_bresp, s_axil_rresp;
    wire [31:0] s_axil_rdata, base, queries;
    wire busy, start, core_reset, aborts, irq, uniform_valid;
    wire [VALUE_BITS-1:0] scale, uniform_data;
    wire [UNIFORM_BITS-1:0] uniform_address;
    `UNIT unit (.*);

    localparam OKAY = 2'b00, SLVERR = 2'b10;
    localparam ID = 12'h000, CONTROL = 12'h004, STATUS = 12'h008, INTERRUPT_ENABLE = 12'h00c, COUNTERS = 12'h010, EVENT = 12'h040;
    localparam BASE = 12'h080, QUERIES = 12'h088, SCALE = 12'h090, UNIFORMS = 12'h100;
    localparam COMMON_COUNTERS = 8, ERROR_COUNTERS = 5;

    // The channels.
    wire addressed = s_axil_awvalid && s_axil_awready;
    wire given = s_axil_wvalid && s_axil_wready;
    wire answered = s_axil_bvalid && s_axil_bready;
    wire asked = s_axil_arvalid && s_axil_arready;
    wire told = s_axil_rvalid && s_axil_rready;
    axi_channel #(.WIDTH(12)) write_addresses (clk, rst, s_axil_awvalid, s_axil_awready, s_axil_awaddr);
    axi_channel #(.WIDTH(36)) write_data (clk, rst, s_axil_wvalid, s_axil_wready, {s_axil_wdata, s_axil_wstrb});
    axi_channel #(.WIDTH(12)) read_addresses (clk, rst, s_axil_arvalid, s_axil_arready, s_axil_araddr);
    axi_channel #(.OURS(1), .WIDTH(2)) write_answers (clk, rst, s_axil_bvalid, s_axil_bready, s_axil_bresp);
    axi_channel #(.OURS(1), .WIDTH(34)) read_answers (clk, rst, s_axil_rvalid, s_axil_rready, {s_axil_rdata, s_axil_rresp});
    wire [3:0] open_addresses, open_data;
    wire [2:0] open_reads;
    axi_write_answers #(.OURS(1)) writes (
        .clk, .rst, .addressed, .ended(given), .valid(s_axil_bvalid), .answered, .addresses(open_addresses), .ends(open_data)
    );
    axi_read_answers #(.OURS(1), .BEAT_BITS(3)) reads (
        .clk, .rst, .asked, .len(8'd0), .id(1'b0), .valid(s_axil_rvalid), .answered(told), .last(1'b1), .answer_id(1'b0), .owed(open_reads)
    );

    // What is asked, kept until the next, and what was there a cycle ago.
    reg [11:0] address, read_address;
    reg [31:0] data;
    reg [3:0] strobes;
    reg write_shown = 0, read_shown = 0, busy_before = 0, occupied_before, finished_before, begun_before, run_begun_before = 0;
    always @(posedge clk) begin
        if (addressed) address <= s_axil_awaddr;
        if (given) {data, strobes} <= {s_axil_wdata, s_axil_wstrb};
        if (asked) read_address <= s_axil_araddr;
        write_shown <= !rst && s_axil_bvalid && !s_axil_bready;
        read_shown <= !rst && s_axil_rvalid && !s_axil_rready;
        busy_before <= !rst && busy;
        run_begun_before <= !rst && start && !busy_before;
        {occupied_before, finished_before, begun_before} <= {occupied, finished, begun};
    end

    // A write is judged in the cycle before its answer shows.
    reg [31:0] base_before = 0, queries_before = 0;
    reg [VALUE_BITS-1:0] scale_before = 0;
    reg enable_before = 0, done_before = 0, waiting_before = 0;
    wire judged = s_axil_bvalid && !write_shown;
    wire to_uniform = address >= UNIFORMS && address < UNIFORMS + 4 * UNIFORM_COUNT;
    wire to_setting = address == BASE || address == QUERIES || address == SCALE;
    wire wants_start = address == CONTROL && data[0];
    wire wants_reset = address == CONTROL && data[1];
    wire is_write = address[1:0] == 0 && &strobes && (to_uniform || to_setting || address == CONTROL || address == INTERRUPT_ENABLE);
    wire is_blocked = (busy_before && (to_setting || wants_reset)) || (waiting_before && (to_uniform || wants_start))
        || (wants_start && occupied_before);
    wire is_senseless = (address == BASE && data[11:0] != 0) || (wants_start && queries_before == 0);
    wire accepted = is_write && !is_blocked && !is_senseless;
    wire carried_out = judged && accepted;
    wire clears = carried_out && address == CONTROL && data[2];
    wire enable = carried_out && address == INTERRUPT_ENABLE ? data[0] : enable_before;
    wire waiting = start || (waiting_before && !begun_before && !finished_before);
    wire done = !start && (done_before || (busy_before && finished_before));
    always @(posedge clk) begin
        base_before <= rst ? 0 : base;
        queries_before <= rst ? 0 : queries;
        scale_before <= rst ? 0 : scale;
        enable_before <= !rst && enable;
        done_before <= !rst && done;
        waiting_before <= !rst && waiting;
    end
    always @(posedge clk) if (!rst) begin
        refused_as_told: assert (!judged || s_axil_bresp == (accepted ? OKAY : SLVERR));
        base_is_written: assert (base == (carried_out && address == BASE ? data : base_before));
        queries_are_written: assert (queries == (carried_out && address == QUERIES ? data : queries_before));
        scale_is_written: assert (scale == (carried_out && address == SCALE ? data[VALUE_BITS-1:0] : scale_before));
        uniform_is_told: assert (uniform_valid == (carried_out && to_uniform));
        its_value: assert (!uniform_valid || (uniform_data == data[VALUE_BITS-1:0] && uniform_address == address[UNIFORM_BITS+1:2]));
        start_is_told: assert (start == (carried_out && wants_start));
        reset_is_told: assert (core_reset == (carried_out && wants_reset));
        abort_is_told: assert (aborts == (carried_out && address == CONTROL && data[3]));
        a_run: assert (busy == (start || (busy_before && !finished_before)));
        waits_for_both_only: assert (open_addresses <= 2 && open_data <= 2);
        one_read_at_a_time: assert (!asked || open_reads == 0);
    end

    // Reads: what was there in the cycle before the answer shows.
    wire read = s_axil_rvalid && !read_shown;
    wire [11:0] counter_place = (read_address - COUNTERS) >> 2;
    wire from_counter = (read_address >= COUNTERS && counter_place < COMMON_COUNTERS) || read_address == EVENT;
    wire is_read = read_address[1:0] == 0 && (from_counter || read_address == ID || read_address == STATUS
        || read_address == INTERRUPT_ENABLE || read_address == BASE || read_address == QUERIES || read_address == SCALE);
    reg error_before = 0;
    wire [31:0] value = read_address == ID ? IDENTITY : read_address == STATUS ? {waiting_before, error_before, done_before, busy_before}
        : read_address == INTERRUPT_ENABLE ? enable_before : read_address == BASE ? base_before
        : read_address == QUERIES ? queries_before : scale_before;
    reg irq_expected = 0;
    always @(posedge clk) irq_expected <= !rst && done && enable;
    always @(posedge clk) if (!rst) begin
        read_refused_as_told: assert (!read || s_axil_rresp == (is_read ? OKAY : SLVERR));
        refused_reads_are_zero: assert (!read || is_read || s_axil_rdata == 0);
        reads_what_is_there: assert (!(read && is_read && !from_counter) || s_axil_rdata == value);
        interrupts: assert (irq == irq_expected);
    end

    // What happened in the last cycle, of each counter, and a counter. An access that is refused counts when its answer shows.
    (* anyconst *) reg [3:0] counter;
    always @* assume (counter <= COMMON_COUNTERS);
    wire [11:0] counter_address = counter == COMMON_COUNTERS ? EVENT : COUNTERS + 4 * counter;
    reg [COMMON_COUNTERS:0] happened = 0;
    reg [1:0] burst_error_before = 0;
    wire write_is_no_access = judged && (!is_write || (!is_blocked && is_senseless));
    wire [1:0] more = counter == 0 ? write_is_no_access + (read && !is_read)
        : counter == 1 ? (judged && is_write && is_blocked) + happened[1]
        : counter == 2 ? burst_error_before[0] + burst_error_before[1]
        : (happened >> counter) & 1;
    wire any_error = (judged && !accepted) || (read && !is_read) || burst_error_before != 0 || happened[1] || happened[4:3] != 0;
    reg clears_before = 0;
    reg [5:0] count_before = 0, count_asked;
    wire resets = counter < ERROR_COUNTERS ? clears_before : run_begun_before;
    wire [5:0] count = (resets ? 0 : count_before) + more;
    reg undisturbed = 0;
    always @(posedge clk) begin
        happened <= rst ? 0 : {busy && event_seen, busy && packet_sent, busy && packet_taken, busy, memory_error, packet_error, 1'b0, busy_error, 1'b0};
        burst_error_before <= rst ? 0 : burst_error;
        clears_before <= !rst && clears;
        error_before <= !rst && (any_error || (error_before && !clears_before));
        count_before <= rst ? 0 : count;
        if (asked) count_asked <= count;
        undisturbed <= !rst && (asked || (undisturbed && !resets));
    end
    always @(posedge clk) if (!rst && read && read_address == counter_address && undisturbed && !resets) begin
        none_lost: assert (s_axil_rdata >= count_asked);
        none_invented: assert (s_axil_rdata <= count);
    end

    // Answers come: a write's after both its parts, a read's after the counter's next turn.
    reg [3:0] write_waits = 0, read_waits = 0;
    always @(posedge clk) if (!rst) begin
        write_waits <= open_addresses != 0 && open_data != 0 && !s_axil_bvalid ? write_waits + 1 : 0;
        read_waits <= open_reads != 0 && !s_axil_rvalid ? read_waits + 1 : 0;
        writes_are_answered: assert (write_waits <= 2);
        reads_are_answered: assert (read_waits <= 6);
    end

    // A run from its start to the interrupt; a counter that is read twice in it and has gone on.
    reg [31:0] told_before = 0;
    always @(posedge clk) if (!rst) begin
        if (read && read_address == counter_address && busy) told_before <= s_axil_rdata;
        cover (irq && count != 0);
        cover (read && read_address == counter_address && counter >= ERROR_COUNTERS && told_before != 0 && s_axil_rdata > told_before);
        cover (clears && error_before);
        cover (start && busy_before && waiting_before == 0 && count_before != 0);
    end
endmodule
