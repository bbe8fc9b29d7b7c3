// The memory behind a core's ports, and what answers there.
#pragma once

#include <cstdint>
#include <cstring>
#include <deque>
#include <vector>

#include "channels.hpp"

constexpr uint8_t OKAY = 0, DECODE_ERROR = 3;
constexpr size_t BEAT_BYTES_MAX = 64;

using Memory = std::vector<uint8_t>;

struct Beat {
    uint8_t bytes[BEAT_BYTES_MAX];
    uint8_t response;
    bool last;
};

struct Burst {
    uint32_t address;
    unsigned beats;
};

// A port that reads. Memory is read when an address is taken.
class ReadPort {
  public:
    ReadPort(Random& random, const Memory& memory, unsigned beat_bytes)
        : random(random), memory(memory), beat_bytes(beat_bytes) {}

    template <class Flag, class Data> void drive(Flag& arready, Flag& rvalid, Data& rdata, Flag& rresp, Flag& rlast) {
        const Beat* beat = data.offered();
        rvalid = beat != nullptr;
        random.fill(rdata);
        if (beat)
            set_bytes(rdata, beat->bytes);
        rresp = beat ? beat->response : random.word() & 3;
        rlast = beat ? beat->last : random.happens(0.5);
        arready = addresses.ready();
    }

    void step(bool arvalid, uint32_t araddr, unsigned arlen, bool rready) {
        data.step(rready);
        if (!addresses.taken(arvalid))
            return;
        for (unsigned place = 0; place <= arlen; place++) {
            Beat beat{};
            const uint64_t first = uint64_t(araddr) + place * beat_bytes;
            const bool is_there = first + beat_bytes <= memory.size();
            beat.response = is_there ? OKAY : DECODE_ERROR;
            if (is_there)
                std::memcpy(beat.bytes, &memory[first], beat_bytes);
            beat.last = place == arlen;
            data.items.push_back(beat);
        }
    }

  private:
    Random& random;
    const Memory& memory;
    unsigned beat_bytes;
    Takes addresses{random};
    Offers<Beat> data{random};
};

// A port that writes. A burst is written when all of it is there, and answered then.
class WritePort {
  public:
    WritePort(Random& random, Memory& memory, unsigned beat_bytes)
        : random(random), memory(memory), beat_bytes(beat_bytes) {}

    template <class Flag> void drive(Flag& awready, Flag& wready, Flag& bvalid, Flag& bresp) {
        awready = addresses.ready();
        wready = data.ready();
        const uint8_t* answer = answers.offered();
        bvalid = answer != nullptr;
        bresp = answer ? *answer : random.word() & 3;
    }

    template <class Data>
    void step(bool awvalid, uint32_t awaddr, unsigned awlen, bool wvalid, const Data& wdata, bool bready) {
        answers.step(bready);
        if (addresses.taken(awvalid))
            bursts.push_back({awaddr, awlen + 1});
        if (data.taken(wvalid)) {
            Beat beat{};
            get_bytes(wdata, beat.bytes);
            beats.push_back(beat);
        }
        while (!bursts.empty() && beats.size() >= bursts.front().beats) {
            const Burst burst = bursts.front();
            bursts.pop_front();
            const bool is_there = uint64_t(burst.address) + burst.beats * beat_bytes <= memory.size();
            for (unsigned place = 0; place < burst.beats; place++) {
                if (is_there)
                    std::memcpy(&memory[burst.address + place * beat_bytes], beats.front().bytes, beat_bytes);
                beats.pop_front();
            }
            answers.items.push_back(is_there ? OKAY : DECODE_ERROR);
        }
    }

  private:
    Random& random;
    Memory& memory;
    unsigned beat_bytes;
    Takes addresses{random}, data{random};
    std::deque<Burst> bursts;
    std::deque<Beat> beats;
    Offers<uint8_t> answers{random};
};
