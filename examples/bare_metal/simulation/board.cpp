// The board: the verilated top, its registers, streams, window and memory.
#include "board.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <vector>

#include "core.h"
#include "memory.hpp"
#include "Top.h"
#include "verilated.h"

namespace {

// No access takes so many cycles.
constexpr int CYCLES_MAX = 100000;
constexpr int SEND_PACKETS = 2;
constexpr unsigned BURST_WORDS = 16;
constexpr uint32_t BORDER = 4096;
constexpr unsigned WORD_BYTES = 8;
constexpr uint8_t INCREMENTING = 1;
constexpr uint8_t WINDOW_ID = 5;

#ifndef POINTCORE_SPLAT_REGISTERS_H
constexpr uint32_t WINDOW_RANGE = std::max(CORE_(TREE_BYTES), BORDER);
#define STREAM_IN(signal) top->s_axis_query_##signal
#define STREAM_OUT(signal) top->m_axis_result_##signal
#else
constexpr uint32_t WINDOW_RANGE = 0;
#define STREAM_IN(signal) top->s_axis_splat_##signal
#define STREAM_OUT(signal) top->m_axis_fragment_##signal
#endif
constexpr unsigned STREAM_BYTES = CORE_(STREAM_BITS) / 8, MEMORY_BYTES = CORE_(MEMORY_BITS) / 8;

struct Word {
    uint64_t data;
    bool last;
};

class Board {
  public:
    explicit Board(uint32_t seed) : random(seed), memory(BOARD_MEMORY_BYTES) {
        context->randReset(2);
        context->randSeed(int(seed & 0x7fffffff) + 1);
        top = std::make_unique<Top>(context.get(), "top");
        for (uint8_t& byte : memory)
            byte = uint8_t(random.word());
        // One edge is all that a reset needs.
        top->rst = 1;
        cycle();
        top->rst = 0;
        cycles = 0;
    }

    ~Board() { top->final(); }

    bool write_register(uint32_t address, uint32_t value) {
        register_writes.items.push_back(address);
        register_data.items.push_back(value);
        return wait(write_answers) == OKAY;
    }

    bool read_register(uint32_t address, uint32_t* value) {
        register_reads.items.push_back(address);
        const uint64_t answer = wait(read_answers);
        *value = uint32_t(answer);
        return answer >> 32 == OKAY;
    }

    bool write_window(uint32_t address, const uint64_t* words, size_t count) {
        // The interconnect hands on what lies in the range that the slave has, and refuses what does not.
        if (address + count * WORD_BYTES > WINDOW_RANGE)
            return false;
        bool is_okay = true;
        for (size_t done = 0; done < count;) {
            const size_t to_border = (BORDER - (address + done * WORD_BYTES) % BORDER) / WORD_BYTES;
            const size_t beats = std::min({count - done, size_t(BURST_WORDS), to_border});
            window_bursts.items.push_back({uint32_t(address + done * WORD_BYTES), unsigned(beats)});
            for (size_t beat = 0; beat < beats; beat++)
                window_words.items.push_back({words[done + beat], beat + 1 == beats});
            is_okay = wait(window_answers) == OKAY && is_okay;
            done += beats;
        }
        return is_okay;
    }

    void write_memory(uint32_t address, const uint8_t* bytes, size_t count) {
        if (address > memory.size() || count > memory.size() - address)
            fail("a write of the host's beyond memory");
        std::memcpy(&memory[address], bytes, count);
    }

    bool send(const uint8_t* packet, size_t bytes) {
        const bool has_room = packets.items.size() < SEND_PACKETS * bytes / STREAM_BYTES;
        for (size_t place = 0; has_room && place < bytes; place += STREAM_BYTES) {
            Beat beat{};
            std::memcpy(beat.bytes, packet + place, STREAM_BYTES);
            beat.last = place + STREAM_BYTES == bytes;
            packets.items.push_back(beat);
        }
        cycle();
        return has_room;
    }

    bool receive(uint8_t* packet, size_t bytes) {
        cycle();
        if (received.empty())
            return false;
        if (received.front().size() != bytes)
            fail("a packet of a wrong length");
        std::memcpy(packet, received.front().data(), bytes);
        received.pop_front();
        return true;
    }

    void forget() {
        packets.forget();
        received.clear();
        gathered.clear();
    }

    uint64_t cycles = 0;

  private:
    [[noreturn]] static void fail(const char* what) {
        std::fprintf(stderr, "board: %s\n", what);
        std::exit(1);
    }

    template <class Answer> Answer wait(std::deque<Answer>& answers) {
        for (int waited = 0; answers.empty(); waited++) {
            if (waited > CYCLES_MAX)
                fail("an access is never answered");
            cycle();
        }
        const Answer answer = answers.front();
        answers.pop_front();
        return answer;
    }

    void cycle() {
        drive_registers();
        drive_streams();
        drive_reads();
        drive_others();
        top->clk = 0;
        top->eval();
        // Whatever moves moves at the edge: outputs are those before it.
        if (!top->rst) {
            step_registers();
            step_streams();
            step_reads();
            step_others();
        }
        top->clk = 1;
        top->eval();
        cycles++;
    }

    void drive_registers() {
        const uint32_t* write = register_writes.offered();
        top->s_axil_awvalid = write != nullptr;
        random.fill(top->s_axil_awaddr);
        top->s_axil_awaddr = (write ? *write : top->s_axil_awaddr) & 0xfff;
        const uint32_t* data = register_data.offered();
        top->s_axil_wvalid = data != nullptr;
        top->s_axil_wdata = data ? *data : random.word();
        top->s_axil_wstrb = data ? 0xf : random.word() & 0xf;
        const uint32_t* read = register_reads.offered();
        top->s_axil_arvalid = read != nullptr;
        top->s_axil_araddr = (read ? *read : random.word()) & 0xfff;
        top->s_axil_bready = register_write_answers.ready();
        top->s_axil_rready = register_read_answers.ready();
    }

    void step_registers() {
        register_writes.step(top->s_axil_awready);
        register_data.step(top->s_axil_wready);
        register_reads.step(top->s_axil_arready);
        if (register_write_answers.taken(top->s_axil_bvalid))
            write_answers.push_back(top->s_axil_bresp);
        if (register_read_answers.taken(top->s_axil_rvalid))
            read_answers.push_back(uint64_t(top->s_axil_rresp) << 32 | top->s_axil_rdata);
    }

    void drive_streams() {
        const Beat* beat = packets.offered();
        STREAM_IN(tvalid) = beat != nullptr;
        random.fill(STREAM_IN(tdata));
        STREAM_IN(tlast) = beat ? beat->last : random.happens(0.5);
        if (beat)
            set_bytes(STREAM_IN(tdata), beat->bytes);
        STREAM_OUT(tready) = results.ready();
    }

    void step_streams() {
        packets.step(STREAM_IN(tready));
        if (!results.taken(STREAM_OUT(tvalid)))
            return;
        gathered.resize(gathered.size() + STREAM_BYTES);
        get_bytes(STREAM_OUT(tdata), &gathered[gathered.size() - STREAM_BYTES]);
        if (STREAM_OUT(tlast)) {
            received.push_back(gathered);
            gathered.clear();
        }
    }

    void drive_reads() {
        reads.drive(top->m_axi_arready, top->m_axi_rvalid, top->m_axi_rdata, top->m_axi_rresp, top->m_axi_rlast);
        top->m_axi_rid = 0;
    }

    void step_reads() {
        reads.step(top->m_axi_arvalid, top->m_axi_araddr, top->m_axi_arlen, top->m_axi_rready);
    }

#ifndef POINTCORE_SPLAT_REGISTERS_H
#if CORE_(TREE_IN_MEMORY)
    void drive_others() {
        drive_lines();
        tree.drive(top->m_axi_tree_arready, top->m_axi_tree_rvalid, top->m_axi_tree_rdata, top->m_axi_tree_rresp,
                   top->m_axi_tree_rlast);
        top->m_axi_tree_rid = 0;
    }

    void step_others() {
        step_lines();
        tree.step(top->m_axi_tree_arvalid, top->m_axi_tree_araddr, top->m_axi_tree_arlen, top->m_axi_tree_rready);
    }
#else
    void drive_others() {
        drive_lines();
        const Burst* burst = window_bursts.offered();
        top->s_axi_awvalid = burst != nullptr;
        top->s_axi_awaddr = burst ? burst->address : random.word() % WINDOW_RANGE;
        top->s_axi_awlen = burst ? burst->beats - 1 : random.word() & 0xff;
        top->s_axi_awsize = burst ? 3 : random.word() & 7;
        top->s_axi_awburst = burst ? INCREMENTING : random.word() & 3;
        top->s_axi_awid = burst ? WINDOW_ID : random.word() & 0xf;
        const Word* word = window_words.offered();
        top->s_axi_wvalid = word != nullptr;
        random.fill(top->s_axi_wdata);
        if (word)
            top->s_axi_wdata = word->data;
        top->s_axi_wstrb = word ? 0xff : random.word() & 0xff;
        top->s_axi_wlast = word ? word->last : random.happens(0.5);
        top->s_axi_bready = window_write_answers.ready();
        top->s_axi_arvalid = 0;
        top->s_axi_rready = 1;
    }

    void step_others() {
        step_lines();
        window_bursts.step(top->s_axi_awready);
        window_words.step(top->s_axi_wready);
        if (window_write_answers.taken(top->s_axi_bvalid))
            window_answers.push_back(top->s_axi_bresp);
    }
#endif

#ifdef POINTCORE_POINTS_REGISTERS_H
    void drive_lines() {
        lines.drive(top->m_axi_line_arready, top->m_axi_line_rvalid, top->m_axi_line_rdata, top->m_axi_line_rresp,
                    top->m_axi_line_rlast);
        top->m_axi_line_rid = 0;
    }

    void step_lines() {
        lines.step(top->m_axi_line_arvalid, top->m_axi_line_araddr, top->m_axi_line_arlen, top->m_axi_line_rready);
    }
#else
    void drive_lines() {}
    void step_lines() {}
#endif
#else
    void drive_others() {
        writes.drive(top->m_axi_awready, top->m_axi_wready, top->m_axi_bvalid, top->m_axi_bresp);
        top->m_axi_bid = 0;
    }

    void step_others() {
        writes.step(top->m_axi_awvalid, top->m_axi_awaddr, top->m_axi_awlen, top->m_axi_wvalid, top->m_axi_wdata,
                    top->m_axi_bready);
    }
#endif

    Random random;
    std::unique_ptr<VerilatedContext> context = std::make_unique<VerilatedContext>();
    std::unique_ptr<Top> top;
    Memory memory;

    Offers<uint32_t> register_writes{random}, register_data{random}, register_reads{random};
    Takes register_write_answers{random}, register_read_answers{random};
    std::deque<uint8_t> write_answers;
    std::deque<uint64_t> read_answers;

    Offers<Beat> packets{random};
    Takes results{random};
    std::vector<uint8_t> gathered;
    std::deque<std::vector<uint8_t>> received;

    ReadPort reads{random, memory, MEMORY_BYTES};
    // Points as the point processor's program reads them.
    ReadPort lines{random, memory, MEMORY_BYTES};
    // The tree of points: in memory, or behind the window.
    ReadPort tree{random, memory, MEMORY_BYTES};
    Offers<Burst> window_bursts{random};
    Offers<Word> window_words{random};
    Takes window_write_answers{random};
    std::deque<uint8_t> window_answers;
    // The renderer's buffer.
    WritePort writes{random, memory, MEMORY_BYTES};
};

Board& board(void* context) { return *static_cast<Board*>(context); }

bool read32(void* context, uint32_t address, uint32_t* value) { return board(context).read_register(address, value); }
bool write32(void* context, uint32_t address, uint32_t value) { return board(context).write_register(address, value); }
bool write_window(void* context, uint32_t address, const uint64_t* words, size_t count) {
    return board(context).write_window(address, words, count);
}
void write_memory(void* context, uint32_t address, const uint8_t* bytes, size_t count) {
    board(context).write_memory(address, bytes, count);
}
bool send(void* context, const uint8_t* packet, size_t bytes) { return board(context).send(packet, bytes); }
bool receive(void* context, uint8_t* packet, size_t bytes) { return board(context).receive(packet, bytes); }
void forget(void* context) { board(context).forget(); }

}  // namespace

struct platform board_open(uint32_t seed) {
    return {new Board(seed), read32, write32, write_window, write_memory, send, receive, forget};
}

uint64_t board_cycles(const struct platform* platform) { return board(platform->context).cycles; }

void board_close(struct platform* platform) { delete static_cast<Board*>(platform->context); }
