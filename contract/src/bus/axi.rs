//! The AMBA buses at the ports of units and tops: what their channels carry, and which channels a bus has.
//!
//! Channels are called as AXI calls them: `m_axi_arvalid`, `m_axi_arready`, `m_axi_araddr`. Beats of memory may be wider than a word:
//! models know them as bytes.

use super::channel::{ChannelIn, ChannelOut};
use super::config::{ADDRESS_BITS, BURST_BEATS_MAX, ID_BITS, REGISTER_ADDRESS_BITS, REGISTER_BITS};
use crate::record;
use crate::splat::config::index_bits;
use crate::unit::Group;

/// Bits of a burst's length, which is one less than its beats.
pub const LENGTH_BITS: u32 = index_bits(BURST_BEATS_MAX);
const SIZE_BITS: u32 = 3;
const BURST_BITS: u32 = 2;
const RESPONSE_BITS: u32 = 2;

/// What an address channel says of a burst.
#[record(address_bits: u32)]
pub struct BurstAddress {
    /// The burst's identifier, which its answers bear.
    #[bits(ID_BITS)]
    pub id: u8,
    /// Its first byte.
    #[name("addr")]
    #[bits(*address_bits)]
    pub address: u32,
    /// One less than its beats.
    #[name("len")]
    #[bits(LENGTH_BITS)]
    pub length: u8,
    /// The binary logarithm of a beat's bytes.
    #[bits(SIZE_BITS)]
    pub size: u8,
    /// How the address goes on: up, where it is 1.
    #[bits(BURST_BITS)]
    pub burst: u8,
}

/// A beat that is written.
#[record(beat_bits: u32)]
pub struct WriteBeat {
    /// Its bytes.
    #[bits(*beat_bits)]
    pub data: u64,
    /// A bit for each byte that is to be written.
    #[name("strb")]
    #[bits(*beat_bits / 8)]
    pub strobes: u64,
    /// Closes its burst.
    pub last: bool,
}

/// The answer to a burst that is written.
#[record(config: ())]
pub struct WriteAnswer {
    /// The burst's identifier.
    #[bits(ID_BITS)]
    pub id: u8,
    /// Whether all is well: 0 if so.
    #[name("resp")]
    #[bits(RESPONSE_BITS)]
    pub response: u8,
}

/// A beat that is read.
#[record(beat_bits: u32)]
pub struct ReadBeat {
    /// The burst's identifier.
    #[bits(ID_BITS)]
    pub id: u8,
    /// Its bytes.
    #[bits(*beat_bits)]
    pub data: u64,
    /// Whether all is well: 0 if so.
    #[name("resp")]
    #[bits(RESPONSE_BITS)]
    pub response: u8,
    /// Closes its burst.
    pub last: bool,
}

/// A register's address.
#[record(config: ())]
pub struct RegisterAddress {
    /// Its first byte.
    #[name("addr")]
    #[bits(REGISTER_ADDRESS_BITS)]
    pub address: u16,
}

/// What is written to a register.
#[record(config: ())]
pub struct RegisterData {
    /// The value.
    #[bits(REGISTER_BITS)]
    pub data: u32,
    /// A bit for each byte that is to be written.
    #[name("strb")]
    #[bits(REGISTER_BITS / 8)]
    pub strobes: u8,
}

/// The answer to a write to a register.
#[record(config: ())]
pub struct RegisterAnswer {
    /// Whether all is well: 0 if so.
    #[name("resp")]
    #[bits(RESPONSE_BITS)]
    pub response: u8,
}

/// What is read from a register.
#[record(config: ())]
pub struct RegisterValue {
    /// The value.
    #[bits(REGISTER_BITS)]
    pub data: u32,
    /// Whether all is well: 0 if so.
    #[name("resp")]
    #[bits(RESPONSE_BITS)]
    pub response: u8,
}

/// A beat of a packet.
#[record(beat_bits: u32)]
pub struct PacketBeat {
    /// Its bytes.
    #[bits(*beat_bits)]
    pub data: u64,
    /// Closes its packet.
    pub last: bool,
}

/// Widths of a bus to a unit that others write and read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SlaveBits {
    /// Of an address: as many as the unit's range needs.
    pub address: u32,
    /// Of a beat.
    pub beat: u32,
}

/// Channels that belong together, at one side.
pub trait Bus: Copy {
    /// What their widths depend on.
    type Config;

    /// The channels in order.
    fn groups(&self, config: &Self::Config) -> Vec<Group>;
}

macro_rules! buses {
    ($(
        $(#[doc = $about:literal])*
        $bus:ident, $config:ident: $ty:ty {
            $($(#[doc = $doc:literal])* $field:ident: $kind:ident<$record:ty> = $channel:literal, $with:expr;)*
        }
    )*) => {
        $(
            $(#[doc = $about])*
            #[derive(Clone, Copy, Debug)]
            pub struct $bus {
                $($(#[doc = $doc])* pub $field: $kind<$record>,)*
            }

            impl $bus {
                /// The bus whose ports are called `<name>_…`.
                #[must_use]
                pub const fn on(name: &'static str) -> Self {
                    Self { $($field: $kind::new(name, $channel, concat!($($doc),*)),)* }
                }
            }

            impl Bus for $bus {
                type Config = $ty;

                fn groups(&self, $config: &$ty) -> Vec<Group> {
                    vec![$(self.$field.group($with)),*]
                }
            }
        )*
    };
}

buses! {
    /// AXI4-Lite to the registers.
    RegisterBus, config: () {
        /// Registers to be written.
        write_address: ChannelIn<RegisterAddress> = "aw", config;
        /// What is written to them.
        write_data: ChannelIn<RegisterData> = "w", config;
        /// Answers to writes.
        write_answer: ChannelOut<RegisterAnswer> = "b", config;
        /// Registers to be read.
        read_address: ChannelIn<RegisterAddress> = "ar", config;
        /// What is read from them.
        read_value: ChannelOut<RegisterValue> = "r", config;
    }

    /// An AXI4-Stream of packets into the unit.
    PacketBusIn, beat_bits: u32 {
        /// Beats of packets.
        beats: ChannelIn<PacketBeat> = "t", beat_bits;
    }

    /// An AXI4-Stream of packets out of the unit.
    PacketBusOut, beat_bits: u32 {
        /// Beats of packets.
        beats: ChannelOut<PacketBeat> = "t", beat_bits;
    }

    /// AXI4, reading.
    ReadMaster, beat_bits: u32 {
        /// Bursts wanted.
        address: ChannelOut<BurstAddress> = "ar", &ADDRESS_BITS;
        /// Their beats.
        data: ChannelIn<ReadBeat> = "r", beat_bits;
    }

    /// AXI4, writing.
    WriteMaster, beat_bits: u32 {
        /// Bursts to be written.
        address: ChannelOut<BurstAddress> = "aw", &ADDRESS_BITS;
        /// Their beats.
        data: ChannelOut<WriteBeat> = "w", beat_bits;
        /// Answers to bursts.
        answer: ChannelIn<WriteAnswer> = "b", &();
    }

    /// AXI4, written and read by others.
    Slave, bits: SlaveBits {
        /// Bursts to be written.
        write_address: ChannelIn<BurstAddress> = "aw", &bits.address;
        /// Their beats.
        write_data: ChannelIn<WriteBeat> = "w", &bits.beat;
        /// Answers to bursts.
        write_answer: ChannelOut<WriteAnswer> = "b", &();
        /// Bursts wanted.
        read_address: ChannelIn<BurstAddress> = "ar", &bits.address;
        /// Their beats.
        read_data: ChannelOut<ReadBeat> = "r", &bits.beat;
    }
}
