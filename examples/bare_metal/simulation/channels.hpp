// Channels of a bus with `valid` and `ready`, each stalling in a share of the cycles of its own.
#pragma once

#include <cstdint>
#include <cstring>
#include <deque>
#include <iterator>
#include <random>

// The shares of cycles in which a channel may stall.
inline constexpr double STALLS[] = {0.0, 0.1, 0.3, 0.6};

class Random {
  public:
    explicit Random(uint32_t seed) : source(seed) {}

    double share() { return STALLS[source() % std::size(STALLS)]; }
    bool happens(double share) { return double(source()) < share * 4294967296.0; }
    // Any value, for a signal that does not count.
    template <class Port> void fill(Port& port) {
        for (size_t byte = 0; byte < sizeof port; byte++)
            reinterpret_cast<uint8_t*>(&port)[byte] = uint8_t(source());
    }
    uint32_t word() { return uint32_t(source()); }

  private:
    std::mt19937 source;
};

// A channel on which the board offers; what is offered stays until it is taken.
template <class Item> class Offers {
  public:
    std::deque<Item> items;

    explicit Offers(Random& random) : random(random), stalls(random.share()) {}

    // What is offered in this cycle, or nothing.
    const Item* offered() {
        shows = !items.empty() && (shows || !random.happens(stalls));
        return shows ? &items.front() : nullptr;
    }

    // At the end of the cycle.
    void step(bool ready) {
        if (shows && ready) {
            items.pop_front();
            shows = false;
        }
    }

    // As a reset of what offers.
    void forget() {
        items.clear();
        shows = false;
    }

  private:
    Random& random;
    double stalls;
    bool shows = false;
};

// A channel on which the board takes.
class Takes {
  public:
    explicit Takes(Random& random) : random(random), stalls(random.share()) {}

    bool ready() { return is_ready = !random.happens(stalls); }
    bool taken(bool valid) const { return valid && is_ready; }

  private:
    Random& random;
    double stalls;
    bool is_ready = false;
};

// The bytes of a port of whole words, whatever type it has; the host is little-endian.
template <class Port> void set_bytes(Port& port, const uint8_t* bytes) { std::memcpy(&port, bytes, sizeof port); }
template <class Port> void get_bytes(const Port& port, uint8_t* bytes) { std::memcpy(bytes, &port, sizeof port); }
